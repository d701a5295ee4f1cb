//! Lists of points: counted lists, or offsets and connectivity.

use super::reader::{Lists, Reader};
use crate::values::NumberType;
use coface_algebra::Error;
use std::io::Read;

/// Reads the lists behind a keyword: `count size` and then each list behind its length, or, since version 5.1, the
/// lengths of two arrays, `OFFSETS` and `CONNECTIVITY`.
pub(super) fn read_lists<R: Read>(reader: &mut Reader<R>, keyword: &str) -> Result<Lists, Error> {
    let count = reader.values.scanner.expect_u64("a count of lists")?;
    let size = reader.values.scanner.expect_u64("the size of the lists")?;
    reader.values.end_line()?;
    let mut lists = Lists { is_ascii: reader.values.is_ascii(), ..Lists::default() };
    if reader.has_offsets {
        read_offsets(reader, keyword, count, size, &mut lists)?;
        return Ok(lists);
    }
    let mut left = size;
    for _ in 0..count {
        let length = reader.values.count(NumberType::Int32, "the length of a list")?;
        lists.places.push(place(reader));
        if left < length.saturating_add(1) {
            let message = format!("a list of {length} numbers runs over the size of {keyword}, {size}");
            return Err(reader.values.error(message).with_cure("check the size and the lengths"));
        }
        left -= length + 1;
        for _ in 0..length {
            let point = read_point(reader, NumberType::Int32)?;
            lists.points.push(point);
        }
        lists.starts.push(lists.points.len());
    }
    if left > 0 {
        let message = format!("the lists of {keyword} have {} numbers, not {size}", size - left);
        return Err(reader.values.error(message).with_cure("check the count and the size"));
    }
    Ok(lists)
}

fn read_offsets<R: Read>(
    reader: &mut Reader<R>,
    keyword: &str,
    count: u64,
    size: u64,
    lists: &mut Lists,
) -> Result<(), Error> {
    let word = reader.values.scanner.expect_token("OFFSETS")?;
    if !word.eq_ignore_ascii_case(b"OFFSETS") {
        let fault = reader.values.error("OFFSETS is missing");
        return Err(fault.with_cure("since version 5 lists are offsets and connectivity: check the version"));
    }
    let number = reader.read_type()?;
    reader.values.end_line()?;
    lists.starts.clear();
    for i in 0..count {
        let offset = reader.values.count(number, "an offset")?;
        let least = lists.starts.last().copied().unwrap_or(0) as u64;
        if offset < least || offset > size || (i == 0 && offset != 0) {
            let message = format!("an offset of {keyword} is {offset}; offsets rise from 0 to {size}");
            return Err(reader.values.error(message).with_cure("the file is damaged: write it again"));
        }
        lists.starts.push(offset as usize);
    }
    if lists.starts.is_empty() {
        lists.starts.push(0);
    }
    if lists.starts.last().copied() != usize::try_from(size).ok() {
        let message = format!("the offsets of {keyword} do not end at the size, {size}");
        return Err(reader.values.error(message).with_cure("the file is damaged: write it again"));
    }
    let word = reader.values.scanner.expect_token("CONNECTIVITY")?;
    if !word.eq_ignore_ascii_case(b"CONNECTIVITY") {
        return Err(reader
            .values
            .error("CONNECTIVITY is missing")
            .with_cure("check the count of the offsets"));
    }
    let number = reader.read_type()?;
    reader.values.end_line()?;
    lists.places.push(place(reader));
    for _ in 0..size {
        let point = read_point(reader, number)?;
        lists.points.push(point);
    }
    Ok(())
}

fn place<R: Read>(reader: &Reader<R>) -> u64 {
    if reader.values.is_ascii() {
        reader.values.scanner.line_number()
    } else {
        reader.values.scanner.byte_offset()
    }
}

/// The index of a point, which must be among the points.
fn read_point<R: Read>(reader: &mut Reader<R>, number: NumberType) -> Result<u32, Error> {
    let index = reader.values.integer(number, "a point of a cell")?;
    let count = reader.elements.assembly.vertex_count();
    match u32::try_from(index) {
        Ok(point) if (point as usize) < count => Ok(point),
        _ => {
            let fault = Error::invalid(format!(
                "a cell names point {index}, but there are {count} points, numbered from 0"
            ));
            Err(reader
                .values
                .located(fault.with_cure("the file is damaged, or was written wrongly: write it again")))
        }
    }
}
