//! Data on points and cells.
//!
//! In the file an array is on all cells, whatever they are, in the order in which they are drawn: vertices, lines, polygons,
//! strips. In the model it becomes one array for each kind of cells that there is.

use super::cell_runs::KINDS;
use super::elements::count_nonzero;
use super::reader::{Place, Reader, number_type};
use crate::numbers::Numbers;
use crate::scanner::quoted;
use crate::values::NumberType;
use crate::{CellData, GroupKind, Model};
use crate::{Remark, RemarkCode};
use coface_algebra::Error;
use std::io::Read;

/// Reads the count behind `POINT_DATA` or `CELL_DATA`.
pub(super) fn read_place<R: Read>(reader: &mut Reader<R>, keyword: &[u8]) -> Result<(), Error> {
    let (place, name, there) = match keyword {
        b"POINT_DATA" => (Place::Points, "points", reader.elements.assembly.vertex_count() as u64),
        _ => (Place::Cells, "cells", reader.elements.cells.count()),
    };
    let count = reader.values.scanner.expect_u64("the count of rows of data")?;
    if count != there {
        let message = format!("there are data on {count} {name}, but there are {there} {name}");
        return Err(reader.values.error(message).with_cure("give each of them one row, or remove the data"));
    }
    reader.data_place = Some(place);
    Ok(())
}

/// Reads what follows one of the keywords of data; false if what follows cannot be read.
pub(super) fn read_array<R: Read>(
    reader: &mut Reader<R>,
    place: Place,
    keyword: &[u8],
) -> Result<bool, Error> {
    let components = match keyword {
        b"FIELD" => return read_fields(reader, Some(place)),
        b"LOOKUP_TABLE" => return skip_lookup_table(reader).map(|()| true),
        b"SCALARS" | b"TEXTURE_COORDINATES" | b"COLOR_SCALARS" => 0,
        b"VECTORS" | b"NORMALS" => 3,
        b"TENSORS" => 9,
        b"TENSORS6" => 6,
        b"GLOBAL_IDS" | b"PEDIGREE_IDS" | b"EDGE_FLAGS" => 1,
        _ => {
            let message = format!("{} is no keyword of data in a VTK file", quoted(keyword));
            return Err(reader.values.error(message).with_cure("check the count of the data before"));
        }
    };
    let name = decoded(reader.values.scanner.expect_token("the name of data")?);
    let (components, number) = match keyword {
        b"COLOR_SCALARS" => {
            let components = reader.values.scanner.expect_u64("the count of components")?;
            // Text has parts of 1, binary files bytes.
            let number = if reader.values.is_ascii() { NumberType::Float32 } else { NumberType::UInt8 };
            reader.values.end_line()?;
            (components, Some(number))
        }
        b"TEXTURE_COORDINATES" => {
            let components = reader.values.scanner.expect_u64("the count of components")?;
            let number = number_type_next(reader)?;
            reader.values.end_line()?;
            (components, number)
        }
        b"SCALARS" => {
            let number = number_type_next(reader)?;
            (read_scalar_head(reader)?, number)
        }
        _ => {
            let number = number_type_next(reader)?;
            reader.values.end_line()?;
            (components, number)
        }
    };
    let Some(number) = number else {
        leave_out(reader, &name);
        return Ok(false);
    };
    let rows = row_count(reader, place);
    let numbers = reader.values.numbers(rows.saturating_mul(components), number, "data")?;
    add(reader, place, name, components as usize, numbers);
    Ok(true)
}

/// The count of components, which may be missing, and the lookup table.
fn read_scalar_head<R: Read>(reader: &mut Reader<R>) -> Result<u64, Error> {
    let word = reader.values.scanner.expect_token("LOOKUP_TABLE")?.to_ascii_uppercase();
    let components = match word.as_slice() {
        b"LOOKUP_TABLE" => 1,
        digits => {
            let components = std::str::from_utf8(digits).ok().and_then(|digits| digits.parse::<u64>().ok());
            let Some(components) = components.filter(|&components| components > 0) else {
                let message =
                    format!("{} stands where a count of components or LOOKUP_TABLE should", quoted(digits));
                return Err(reader
                    .values
                    .error(message)
                    .with_cure("write \"LOOKUP_TABLE default\" behind SCALARS"));
            };
            let word = reader.values.scanner.expect_token("LOOKUP_TABLE")?;
            if !word.eq_ignore_ascii_case(b"LOOKUP_TABLE") {
                let message = format!("{} stands where LOOKUP_TABLE should", quoted(word));
                return Err(reader
                    .values
                    .error(message)
                    .with_cure("write \"LOOKUP_TABLE default\" behind SCALARS"));
            }
            components
        }
    };
    reader.values.scanner.expect_token("the name of a lookup table")?;
    reader.values.end_line()?;
    Ok(components)
}

/// Colors of scalars: four numbers each.
fn skip_lookup_table<R: Read>(reader: &mut Reader<R>) -> Result<(), Error> {
    reader.values.scanner.expect_token("the name of a lookup table")?;
    let count = reader.values.scanner.expect_u64("the count of colors")?;
    reader.values.end_line()?;
    reader.values.skip(count.saturating_mul(4), NumberType::UInt8, "a lookup table")
}

/// Reads arrays with counts of their own: onto a place, or over those that belong to the whole data set. False if one of
/// them cannot be read.
pub(super) fn read_fields<R: Read>(reader: &mut Reader<R>, place: Option<Place>) -> Result<bool, Error> {
    reader.values.scanner.expect_token("the name of a field")?;
    let count = reader.values.scanner.expect_u64("the count of arrays")?;
    for _ in 0..count {
        let mut name = reader.values.scanner.expect_token("the name of an array")?.to_vec();
        if name.eq_ignore_ascii_case(b"METADATA") {
            reader.skip_metadata()?;
            name = reader.values.scanner.expect_token("the name of an array")?.to_vec();
        }
        let components = reader.values.scanner.expect_u64("the count of components")?;
        let rows = reader.values.scanner.expect_u64("the count of tuples")?;
        let count = components.saturating_mul(rows);
        let type_name = reader.values.scanner.expect_token("a type of numbers")?.to_ascii_lowercase();
        reader.values.end_line()?;
        match (type_name.as_slice(), reader.values.is_ascii()) {
            (b"string", true) => {
                reader.values.scanner.next_line()?;
                for _ in 0..count {
                    if reader.values.scanner.next_line()?.is_none() {
                        return Err(reader
                            .values
                            .error("the file ends inside a field")
                            .with_cure("write it again"));
                    }
                }
            }
            (b"bit", false) => reader.values.skip_bytes(count.div_ceil(8), "an array")?,
            (b"bit", true) => reader.values.skip(count, NumberType::Int8, "an array")?,
            (type_name, _) => match (number_type(type_name), place) {
                (Some(number), None) => reader.values.skip(count, number, "an array")?,
                (Some(number), Some(place)) => {
                    let name = decoded(&name);
                    if rows != row_count(reader, place) {
                        let message = format!("the data \"{}\" have {rows} rows", name.escape_debug());
                        return Err(reader
                            .values
                            .error(message)
                            .with_cure("give each point or cell one row, or remove the data"));
                    }
                    let numbers = reader.values.numbers(count, number, "data")?;
                    add(reader, place, name, components as usize, numbers);
                }
                (None, None) => return Err(reader.unreadable_field(type_name)),
                (None, Some(_)) => {
                    leave_out(reader, &decoded(&name));
                    return Ok(false);
                }
            },
        }
    }
    Ok(true)
}

/// The type that the next word names; `None` for strings and bits.
fn number_type_next<R: Read>(reader: &mut Reader<R>) -> Result<Option<NumberType>, Error> {
    let name = reader.values.scanner.expect_token("a type of numbers")?.to_ascii_lowercase();
    match name.as_slice() {
        b"string" | b"utf8_string" | b"variant" | b"bit" => Ok(None),
        name => match number_type(name) {
            Some(number) => Ok(Some(number)),
            None => Err(reader
                .values
                .error(format!("{} is no type of numbers", quoted(name)))
                .with_cure("use float, double, int, vtktypeint64 or their like")),
        },
    }
}

fn row_count<R: Read>(reader: &Reader<R>, place: Place) -> u64 {
    match place {
        Place::Points => reader.elements.assembly.vertex_count() as u64,
        Place::Cells => reader.elements.cells.count(),
    }
}

fn leave_out<R: Read>(reader: &mut Reader<R>, name: &str) {
    reader.elements.assembly.remarks.push(Remark::new(
        RemarkCode::DataLeftOut,
        format!("the data \"{}\" are no numbers; they and what follows are left out", name.escape_debug()),
    ));
}

/// Adds an array to the model, on each kind of cells that it has.
fn add<R: Read>(reader: &mut Reader<R>, place: Place, name: String, components: usize, numbers: Numbers) {
    if components == 0 {
        return;
    }
    let kinds = match place {
        Place::Points => {
            let data = CellData::of_file(name, GroupKind::Vertices, components, numbers);
            reader.elements.assembly.add_data(data);
            return;
        }
        Place::Cells => KINDS,
    };
    let mut taken = 0;
    for kind in kinds {
        let count = reader.elements.assembly.count_of(kind);
        if count > 0 {
            let part = reader.elements.cells.numbers_on(kind, count, components, &numbers);
            taken += count_nonzero(&part);
            reader.elements.assembly.add_data(CellData::of_file(name.clone(), kind, components, part));
        }
    }
    reader.elements.remark_on_points(&numbers, taken);
}

/// A name in which `%20` stands for a blank, and so on.
fn decoded(word: &[u8]) -> String {
    let mut bytes = Vec::with_capacity(word.len());
    let mut rest = word;
    while let [first, tail @ ..] = rest {
        let digits =
            tail.get(..2).filter(|digits| *first == b'%' && digits.iter().all(u8::is_ascii_hexdigit));
        let digits = digits.and_then(|digits| std::str::from_utf8(digits).ok());
        match digits.and_then(|digits| u8::from_str_radix(digits, 16).ok()) {
            Some(byte) => {
                bytes.push(byte);
                rest = &tail[2..];
            }
            None => {
                bytes.push(*first);
                rest = tail;
            }
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

/// The name as one word that [`decoded`] makes the name again.
pub(super) fn encoded(name: &str) -> String {
    let mut word = String::with_capacity(name.len());
    for byte in name.bytes() {
        match byte {
            b'!'..=b'~' if !matches!(byte, b'%' | b'"') => word.push(char::from(byte)),
            _ => word += &format!("%{byte:02X}"),
        }
    }
    word
}

/// The type of these numbers in a file.
pub(super) fn type_name(numbers: &Numbers) -> &'static str {
    match numbers {
        Numbers::UInt8(_) => "unsigned_char",
        Numbers::Int32(_) => "int",
        Numbers::Int64(_) => "vtktypeint64",
        Numbers::Float32(_) => "float",
        Numbers::Float64(_) => "double",
    }
}

/// The arrays on all cells of a file: points, lines, polygons, 3-cells. Data of one name are one array, 0 on the cells
/// that have none.
pub(super) fn arrays_on_cells(model: &Model) -> Result<Vec<CellData>, Error> {
    let mut arrays: Vec<CellData> = Vec::new();
    for data in model.data().iter().filter(|data| KINDS.contains(&data.kind())) {
        let name = data.name();
        if arrays.iter().any(|array| array.name() == name) {
            continue;
        }
        let mut common = data.numbers().of_same_type();
        let parts = KINDS.map(|kind| model.data_named(name, kind));
        for part in parts.into_iter().flatten() {
            common = common.common_type(part.numbers());
            if part.components() != data.components() {
                let message = format!(
                    "the data \"{name}\" have {} components on {} and {} on {}; in VTK they are one array",
                    data.components(),
                    data.kind(),
                    part.components(),
                    part.kind()
                );
                return Err(Error::invalid(message).with_cure("rename one of them"));
            }
        }
        common.extend_zeros(model.points().len() * data.components());
        for (kind, part) in KINDS.into_iter().zip(parts) {
            match part {
                Some(part) => common.extend(part.numbers(), 0..part.numbers().len()),
                None => common.extend_zeros(model.count_of(kind) * data.components()),
            }
        }
        arrays.push(CellData::of_file(name.to_owned(), data.kind(), data.components(), common));
    }
    Ok(arrays)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_survive_as_words() {
        for name in ["a", "two words", "100%", "%20", "größe", "\"x\"", "\n"] {
            let word = encoded(name);
            assert!(word.bytes().all(|byte| byte.is_ascii_graphic()), "{word}");
            assert_eq!(decoded(word.as_bytes()), name);
        }
        assert_eq!(decoded(b"100%"), "100%");
        assert_eq!(decoded(b"%zz%+1"), "%zz%+1");
    }
}
