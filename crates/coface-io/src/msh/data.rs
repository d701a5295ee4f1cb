//! Data on nodes and elements: `$NodeData` and `$ElementData`.

use super::reader::Reader;
use crate::values::NumberType;
use crate::{CellData, GroupKind, Remark, RemarkCode};
use coface_algebra::Error;
use std::io::Read;

/// More components than this are left out: tensors have 9.
const MOST_COMPONENTS: i64 = 64;

/// What the elements of the file became, for runs of elements of one kind whose tags and places both count up.
#[derive(Debug, Default)]
pub(super) struct ElementTags {
    runs: Vec<Run>,
    is_sorted: bool,
}

#[derive(Debug)]
struct Run {
    tag: i64,
    kind: GroupKind,
    member: u32,
    count: u32,
}

impl ElementTags {
    /// The next element of the file has this tag and became this member of its kind.
    pub(super) fn add(&mut self, tag: i64, kind: GroupKind, member: u32) {
        if let Some(run) = self.runs.last_mut()
            && run.kind == kind
            && tag.checked_sub(run.tag) == Some(i64::from(run.count))
            && member.checked_sub(run.member) == Some(run.count)
        {
            run.count += 1;
            return;
        }
        self.runs.push(Run { tag, kind, member, count: 1 });
        self.is_sorted = false;
    }

    /// What the element of this tag became.
    fn find(&mut self, tag: i64) -> Option<(GroupKind, u32)> {
        if !self.is_sorted {
            self.runs.sort_by_key(|run| run.tag);
            self.is_sorted = true;
        }
        let run = &self.runs[self.runs.partition_point(|run| run.tag <= tag).checked_sub(1)?];
        let ahead = u32::try_from(tag.checked_sub(run.tag)?).ok().filter(|&ahead| ahead < run.count)?;
        Some((run.kind, run.member + ahead))
    }
}

/// Reads a section onto the nodes or the elements. If there is a fault in it, it is left out with a remark.
pub(super) fn read<R: Read>(reader: &mut Reader<R>, section: &[u8]) -> Result<(), Error> {
    let fault = match read_rows(reader, section == b"NodeData") {
        Ok(()) => return reader.end_section(section),
        Err(fault) => fault,
    };
    let name = String::from_utf8_lossy(section);
    let message = format!("a section ${} is left out: {}", name.escape_debug(), fault.message());
    reader.assembly.remarks.push(Remark::new(RemarkCode::DataLeftOut, message));
    if fault.message().starts_with("\"$End") {
        // The end of the section stood where a number should be.
        reader.values.scanner.next_line()?;
        return Ok(());
    }
    reader.skip_section(section)
}

/// Reads the numbers of a section onto the nodes or the elements: those that have none get NaN.
fn read_rows<R: Read>(reader: &mut Reader<R>, is_of_nodes: bool) -> Result<(), Error> {
    let scanner = &mut reader.values.scanner;
    let string_count = scanner.expect_u64("the count of string tags")?;
    scanner.next_line()?;
    let mut name = String::new();
    for i in 0..string_count {
        let Some(line) = scanner.next_line()? else {
            return Err(scanner.error(format!("the file ends after {i} of {string_count} string tags")));
        };
        if i == 0 {
            name = String::from_utf8_lossy(line).trim().trim_matches('"').to_owned();
        }
    }
    for _ in 0..scanner.expect_u64("the count of real tags")? {
        scanner.expect_token("a real tag")?;
    }
    let mut integers = [0, 1, 0];
    for i in 0..scanner.expect_u64("the count of integer tags")? {
        let integer = scanner.expect_i64("an integer tag")?;
        if let Some(place) = integers.get_mut(i as usize) {
            *place = integer;
        }
    }
    scanner.next_line()?;
    let [_, components, row_count] = integers;
    if name.is_empty() {
        "data".clone_into(&mut name);
    }
    if !(1..=MOST_COMPONENTS).contains(&components) || row_count < 0 {
        let message = format!("the data \"{}\" have {components} components", name.escape_debug());
        return Err(reader.values.error(message).with_cure("give each node or element 1 to 64 numbers"));
    }
    let components = components as usize;
    let mut arrays: Vec<(GroupKind, Vec<f64>)> = Vec::new();
    let mut strangers = 0u64;
    for _ in 0..row_count {
        let tag = reader.values.integer(NumberType::Int32, "the tag of data")?;
        let row = reader.values.numbers(components as u64, NumberType::Float64, "data")?;
        let place = if is_of_nodes {
            reader.nodes.vertex(tag).map(|vertex| (GroupKind::Vertices, vertex))
        } else {
            reader.element_tags.find(tag)
        };
        let Some((kind, member)) = place else {
            strangers += 1;
            continue;
        };
        let at = arrays.iter().position(|&(known, _)| known == kind).unwrap_or_else(|| {
            arrays.push((kind, vec![f64::NAN; reader.assembly.count_of(kind) * components]));
            arrays.len() - 1
        });
        for (i, value) in arrays[at].1[member as usize * components..][..components].iter_mut().enumerate() {
            *value = row.real(i);
        }
    }
    if strangers > 0 {
        let what = if is_of_nodes { "nodes" } else { "elements" };
        let message = format!(
            "{strangers} rows of the data \"{}\" name {what} that are not there",
            name.escape_debug()
        );
        reader
            .assembly
            .remarks
            .push(Remark::new(RemarkCode::DataLeftOut, message).at(strangers as usize, []));
    }
    for (kind, values) in arrays {
        reader.assembly.add_data(CellData::reals(name.clone(), kind, components, values)?);
    }
    Ok(())
}
