//! What the sections of all versions have in common.

use super::data::ElementTags;
use super::elements::{ElementType, MOST_NODES};
use super::nodes::Nodes;
use crate::assembly::Assembly;
use crate::scanner::{Scanner, quoted};
use crate::scratch_mesh::ScratchMesh;
use crate::values::{Encoding, NumberType, Values};
use crate::{GroupKind, Remark, RemarkCode};
use coface_algebra::{Error, ErrorKind};
use std::collections::BTreeMap;
use std::io::Read;

/// A version that is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FileVersion {
    Two,
    FourZero,
    FourOne,
}

impl FileVersion {
    pub(super) fn is_4(self) -> bool {
        self != Self::Two
    }
}

/// A file whose sections are read one after the other.
pub(super) struct Reader<R> {
    pub(super) values: Values<R>,
    /// The type of counts and tags of version 4 in a binary file.
    pub(super) size: NumberType,
    pub(super) assembly: Assembly,
    pub(super) nodes: Nodes,
    /// The tags of the elements, for data on them.
    pub(super) element_tags: ElementTags,
    /// Whether data on nodes and elements are read.
    pub(super) keeps_data: bool,
    /// The physical groups of the entities of version 4, by dimension and tag.
    pub(super) physical: BTreeMap<(usize, i64), Vec<i64>>,
}

impl<R: Read> Reader<R> {
    /// The reader of a stream; without a scratch the mesh is kept.
    pub(super) fn new(input: R, scratch: Option<ScratchMesh>) -> Self {
        Self {
            values: Values::new(Scanner::new(input), Encoding::Ascii),
            size: NumberType::UInt64,
            assembly: Assembly::streaming(3, scratch),
            nodes: Nodes::default(),
            element_tags: ElementTags::default(),
            keeps_data: true,
            physical: BTreeMap::new(),
        }
    }

    /// The name of the next section, without the dollar; lines between sections are empty.
    pub(super) fn next_section(&mut self) -> Result<Option<Vec<u8>>, Error> {
        while let Some(line) = self.values.scanner.next_line()? {
            let line = line.trim_ascii();
            if let Some(name) = line.strip_prefix(b"$") {
                return Ok(Some(name.to_vec()));
            }
            if !line.is_empty() {
                let message = format!("{} stands where a section should begin with $", quoted(line));
                return Err(self.values.error(message).with_cure("check the count of the section before"));
            }
        }
        Ok(None)
    }

    pub(super) fn end_section(&mut self, section: &[u8]) -> Result<(), Error> {
        let Some(end) = self.values.scanner.next_token()? else {
            self.miss_end(section);
            return Ok(());
        };
        // Version 1 has capitals.
        let name = end.strip_prefix(b"$End").or(end.strip_prefix(b"$END"));
        if name != Some(section) && name.is_some_and(|name| is_misspelled(name, section)) {
            let message = format!(
                "the section ${} ends with {}, which is taken for its end",
                String::from_utf8_lossy(section).escape_debug(),
                quoted(end)
            );
            self.assembly.remarks.push(Remark::new(RemarkCode::InputReading, message));
        } else if name != Some(section) {
            let message = format!(
                "{} stands where $End{} should",
                quoted(end),
                String::from_utf8_lossy(section).escape_debug()
            );
            return Err(self.values.error(message).with_cure("check the count at the start of the section"));
        }
        self.values.scanner.next_line()?;
        Ok(())
    }

    pub(super) fn skip_section(&mut self, section: &[u8]) -> Result<(), Error> {
        while let Some(line) = self.values.scanner.next_line()? {
            if line.trim_ascii().strip_prefix(b"$End") == Some(section) {
                return Ok(());
            }
        }
        self.miss_end(section);
        Ok(())
    }

    /// Says that a section with data is passed over; the other sections are comments, or say what the mesh says too.
    pub(super) fn pass_over(&mut self, section: &[u8]) {
        if matches!(section, b"NodeData" | b"ElementData" | b"ElementNodeData") && self.keeps_data {
            let name = String::from_utf8_lossy(section);
            let message = format!("the data of a section ${} are left out", name.escape_debug());
            self.assembly.remarks.push(Remark::new(RemarkCode::DataLeftOut, message));
        }
    }

    /// The file ends before the end of a section.
    fn miss_end(&mut self, section: &[u8]) {
        let name = String::from_utf8_lossy(section);
        let message = format!("the file ends without $End{}", name.escape_debug());
        self.assembly.remarks.push(Remark::new(RemarkCode::MissingEnd, message));
    }

    pub(super) fn unsupported(&self, message: impl Into<String>) -> Error {
        Error::new(ErrorKind::UnsupportedFormat, message)
            .at_line(self.values.scanner.line_number())
            .with_cure("open it in Gmsh and save it as version 4.1 or 2.2")
    }

    pub(super) fn read_format(&mut self) -> Result<FileVersion, Error> {
        let scanner = &mut self.values.scanner;
        let number = scanner.expect_f64("the version")?;
        let is_binary = scanner.expect_i64("the file type")?;
        let size = scanner.expect_i64("the data size")?;
        scanner.next_line()?;
        let version = match number {
            4.1 => FileVersion::FourOne,
            4.0 => FileVersion::FourZero,
            2.0..3.0 => FileVersion::Two,
            _ => {
                return Err(
                    self.unsupported(format!("this is version {number} of MSH; 2, 4.0 and 4.1 are read"))
                );
            }
        };
        self.size = match size {
            8 => NumberType::UInt64,
            4 => NumberType::UInt32,
            _ => {
                return Err(
                    self.unsupported(format!("the data size is {size}; it is 8 in all files known here"))
                );
            }
        };
        match is_binary {
            0 => {}
            1 => {
                // The number 1 states the byte order.
                let mut one = [0; 4];
                self.values.scanner.read_exact(&mut one, "the number 1")?;
                self.values.encoding = match one {
                    [1, 0, 0, 0] => Encoding::LittleEndian,
                    [0, 0, 0, 1] => Encoding::BigEndian,
                    _ => {
                        return Err(self
                            .values
                            .error("the number 1, which states the byte order, is missing"));
                    }
                };
            }
            _ => {
                return Err(self
                    .values
                    .error(format!("the file type is {is_binary}; 0 is text and 1 binary")));
            }
        }
        Ok(version)
    }

    /// The names are text in binary files too.
    pub(super) fn read_names(&mut self) -> Result<(), Error> {
        let count = self.values.scanner.expect_u64("the count of physical names")?;
        self.values.scanner.next_line()?;
        for _ in 0..count {
            let Some(line) = self.values.scanner.next_line()? else {
                return Err(self.values.scanner.error("the file ends inside the physical names"));
            };
            let text = String::from_utf8_lossy(line).into_owned();
            // The first files of version 2 say no dimension.
            if let Some((number, name)) = text.split_once('"')
                && let (Ok(number), Some(name)) =
                    (number.trim().parse::<i64>(), name.trim_end().strip_suffix('"'))
            {
                self.assembly.name_groups(number, name.to_owned());
                continue;
            }
            let mut words = text.trim().splitn(3, char::is_whitespace);
            let dimension = words.next().and_then(|word| word.parse::<i64>().ok());
            let number = words.next().and_then(|word| word.parse::<i64>().ok());
            let name = words.next();
            if let (Some(dimension), Some(number), Some(_)) = (dimension, number, name)
                && !(0..=3).contains(&dimension)
            {
                // Programs write such a name for a group of nothing.
                let message = format!(
                    "the name of group {number} is of dimension {dimension}, which no element has: it is left out"
                );
                self.assembly.remarks.push(Remark::new(RemarkCode::DataLeftOut, message));
                continue;
            }
            let (Some(dimension @ 0..=3), Some(number), Some(name)) = (dimension, number, name) else {
                let message = format!("{} is no physical name", quoted(text.as_bytes()));
                return Err(self
                    .values
                    .scanner
                    .error(message)
                    .with_cure("write dimension, number, \"name\""));
            };
            let name = name.trim();
            let name = name.strip_prefix('"').and_then(|name| name.strip_suffix('"')).unwrap_or(name);
            self.assembly.name_group(group_kind(dimension as usize), number, name.to_owned());
        }
        Ok(())
    }

    /// Reads the nodes of one element and adds it to the mesh and to physical groups.
    pub(super) fn read_element(
        &mut self,
        element: ElementType,
        tag: i64,
        tag_type: NumberType,
        groups: &[i64],
    ) -> Result<(), Error> {
        let mut vertices = [0; MOST_NODES];
        let vertices = &mut vertices[..element.node_count];
        for vertex in vertices.iter_mut() {
            let node = self.values.integer(tag_type, "a node of an element")?;
            *vertex = self.nodes.vertex(node).ok_or_else(|| {
                self.values.located(
                    Error::invalid(format!("an element names node {node}, which is not among the nodes"))
                        .with_cure("the file is damaged, or was written wrongly: write it again"),
                )
            })?;
        }
        let nodes = &self.nodes;
        let member = self
            .assembly
            .add(element.kind, element.corner_count, vertices, |vertex| nodes.tag(vertex))
            .map_err(|fault| self.values.located(fault))?;
        if let Some(member) = member {
            if self.keeps_data {
                self.element_tags.add(tag, element.kind.group_kind(), member);
            }
            for &group in groups {
                self.assembly.add_to_group(element.kind.group_kind(), group, member);
            }
        }
        Ok(())
    }

    pub(super) fn element_type(&self, number: i64) -> Result<ElementType, Error> {
        ElementType::from_number(number).ok_or_else(|| {
            self.values.located(
                Error::new(
                    ErrorKind::UnsupportedFormat,
                    format!("elements of type {number} are not known here"),
                )
                .with_cure("save the mesh with elements of order 1"),
            )
        })
    }
}

/// Whether a name is another one but for one letter that is wrong.
fn is_misspelled(name: &[u8], meant: &[u8]) -> bool {
    name.len() == meant.len() && name.iter().zip(meant).filter(|(a, b)| a != b).count() == 1
}

/// The kind of a physical group by its dimension.
pub(super) fn group_kind(dimension: usize) -> GroupKind {
    match dimension {
        0 => GroupKind::Vertices,
        1 => GroupKind::Lines,
        2 => GroupKind::Polygons,
        _ => GroupKind::Cells,
    }
}
