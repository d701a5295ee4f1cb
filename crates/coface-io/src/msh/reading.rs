//! The sections of a file.

use super::elements::{ElementType, MOST_NODES};
use super::{version_2, version_4};
use crate::Model;
use crate::assembly::Assembly;
use crate::model::GroupKind;
use crate::scanner::{Scanner, quoted};
use crate::scratch_mesh::ScratchMesh;
use crate::values::{Encoding, NumberType, Values};
use coface_algebra::{Error, ErrorKind};
use std::collections::BTreeMap;
use std::io::Read;

/// Reads a Gmsh mesh of version 2, 4.0 or 4.1, text or binary.
///
/// # Errors
/// [`ErrorKind::Parse`] and [`ErrorKind::InvalidInput`] with the line (the byte in a binary file): a number out of place,
/// a node that is not there or stands twice, an element that repeats a node, a file that was cut short;
/// [`ErrorKind::UnsupportedFormat`] for other versions and for types of elements that are not known here.
///
/// # Complexity
/// Linear for node tags that are nearly dense, otherwise $O(n \log n)$ for n nodes.
///
/// # References
/// C. Geuzaine and J.-F. Remacle, *Gmsh reference manual*, chapter "MSH file format".
///
/// # Examples
/// ```
/// use coface_io::msh;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let text = b"$MeshFormat
/// 2.2 0 8
/// $EndMeshFormat
/// $PhysicalNames
/// 1
/// 2 7 \"lid\"
/// $EndPhysicalNames
/// $Nodes
/// 3
/// 10 0 0 0
/// 20 1 0 0
/// 40 0 1 0
/// $EndNodes
/// $Elements
/// 1
/// 1 2 2 7 1 10 20 40
/// $EndElements
/// ";
/// let model = msh::read(&text[..])?;
/// assert_eq!(model.polygons().list(0), [0, 1, 2]);
/// assert_eq!((model.groups()[0].name(), model.groups()[0].members()), ("lid", &[0][..]));
/// # Ok(()) }
/// ```
pub fn read(input: impl Read) -> Result<Model, Error> {
    read_with(input, None)?.finish()
}

/// Reads a mesh into files.
pub(crate) fn read_into(input: impl Read, scratch: ScratchMesh) -> Result<ScratchMesh, Error> {
    Ok(read_with(input, Some(scratch))?.into_scratch().expect("the files that were given"))
}

fn read_with(input: impl Read, scratch: Option<ScratchMesh>) -> Result<Assembly, Error> {
    let mut reader = Reader {
        values: Values::new(Scanner::new(input), Encoding::Ascii),
        size: NumberType::UInt64,
        assembly: Assembly::streaming(3, scratch),
        nodes: Nodes::default(),
        physical: BTreeMap::new(),
    };
    let mut version = None;
    let (mut has_nodes, mut has_elements) = (false, false);
    while let Some(section) = reader.next_section()? {
        match (section.as_slice(), version) {
            (b"MeshFormat", None) => version = Some(reader.read_format()?),
            (b"MeshFormat", Some(_)) => {
                return Err(reader
                    .values
                    .error("the format is given twice")
                    .with_cure("the file holds two meshes: split it"));
            }
            (b"PhysicalNames", _) => reader.read_names()?,
            (b"NOD" | b"NOE", _) => {
                return Err(reader.unsupported("this is version 1 of MSH; 2 and 4 are read"));
            }
            (b"Entities", Some(version)) if version.is_4() => version_4::read_entities(&mut reader, version)?,
            (b"Nodes", Some(version)) => {
                has_nodes = true;
                if version.is_4() {
                    version_4::read_nodes(&mut reader, version)?;
                } else {
                    version_2::read_nodes(&mut reader)?;
                }
                reader.nodes.finish().map_err(|fault| reader.values.located(fault))?;
            }
            (b"Elements", Some(version)) => {
                if !has_nodes {
                    let fault = reader.values.error("the elements stand before the nodes");
                    return Err(fault.with_cure("put the section $Nodes first"));
                }
                has_elements = true;
                if version.is_4() {
                    version_4::read_elements(&mut reader, version)?;
                } else {
                    version_2::read_elements(&mut reader)?;
                }
            }
            (b"Nodes" | b"Elements" | b"Entities", None) => {
                let fault = reader.values.error("$MeshFormat is missing");
                return Err(fault.with_cure("put the section $MeshFormat first"));
            }
            _ => {
                reader.skip_section(&section)?;
                continue;
            }
        }
        reader.end_section(&section)?;
    }
    if !has_nodes || (reader.assembly.vertex_count() > 0 && !has_elements) {
        let missing = if has_nodes { "$Elements" } else { "$Nodes" };
        return Err(Error::parse(format!("the file ends without the section {missing}"))
            .at_line(reader.values.scanner.line_number())
            .with_cure("it was cut short: write it again"));
    }
    Ok(reader.assembly)
}

/// A version that is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FileVersion {
    Two,
    FourZero,
    FourOne,
}

impl FileVersion {
    fn is_4(self) -> bool {
        self != Self::Two
    }
}

pub(super) struct Reader<R> {
    pub(super) values: Values<R>,
    /// The type of counts and tags of version 4 in a binary file.
    pub(super) size: NumberType,
    pub(super) assembly: Assembly,
    pub(super) nodes: Nodes,
    /// The physical groups of the entities of version 4, by dimension and tag.
    pub(super) physical: BTreeMap<(usize, i64), Vec<i64>>,
}

impl<R: Read> Reader<R> {
    /// The name of the next section, without the dollar; lines between sections are empty.
    fn next_section(&mut self) -> Result<Option<Vec<u8>>, Error> {
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

    fn end_section(&mut self, section: &[u8]) -> Result<(), Error> {
        let end = self.values.scanner.expect_token("the end of a section")?;
        if end.strip_prefix(b"$End") != Some(section) {
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

    fn skip_section(&mut self, section: &[u8]) -> Result<(), Error> {
        let begin = self.values.scanner.line_number();
        while let Some(line) = self.values.scanner.next_line()? {
            if line.trim_ascii().strip_prefix(b"$End") == Some(section) {
                return Ok(());
            }
        }
        let name = String::from_utf8_lossy(section);
        Err(Error::parse(format!("the section ${} has no end", name.escape_debug()))
            .at_line(begin)
            .with_cure("the file was cut short: write it again"))
    }

    fn unsupported(&self, message: impl Into<String>) -> Error {
        Error::new(ErrorKind::UnsupportedFormat, message)
            .at_line(self.values.scanner.line_number())
            .with_cure("open it in Gmsh and save it as version 4.1 or 2.2")
    }

    fn read_format(&mut self) -> Result<FileVersion, Error> {
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
                // The number 1 tells the order of bytes.
                let mut one = [0; 4];
                self.values.scanner.read_exact(&mut one, "the number 1")?;
                self.values.encoding = match one {
                    [1, 0, 0, 0] => Encoding::LittleEndian,
                    [0, 0, 0, 1] => Encoding::BigEndian,
                    _ => {
                        return Err(self
                            .values
                            .error("the number 1 that tells the order of bytes is missing"));
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
    fn read_names(&mut self) -> Result<(), Error> {
        let count = self.values.scanner.expect_u64("the count of physical names")?;
        self.values.scanner.next_line()?;
        for _ in 0..count {
            let Some(line) = self.values.scanner.next_line()? else {
                return Err(self.values.scanner.error("the file ends inside the physical names"));
            };
            let text = String::from_utf8_lossy(line).into_owned();
            let mut words = text.trim().splitn(3, char::is_whitespace);
            let dimension = words.next().and_then(|word| word.parse::<usize>().ok());
            let number = words.next().and_then(|word| word.parse::<i64>().ok());
            let (Some(dimension @ 0..=3), Some(number), Some(name)) = (dimension, number, words.next())
            else {
                let message = format!("{} is no physical name", quoted(text.as_bytes()));
                return Err(self
                    .values
                    .scanner
                    .error(message)
                    .with_cure("write dimension, number, \"name\""));
            };
            let name = name.trim();
            let name = name.strip_prefix('"').and_then(|name| name.strip_suffix('"')).unwrap_or(name);
            self.assembly.name_group(group_kind(dimension), number, name.to_owned());
        }
        Ok(())
    }

    /// Reads the nodes of one element and adds it to the mesh and to physical groups.
    pub(super) fn read_element(
        &mut self,
        element: ElementType,
        tag_type: NumberType,
        groups: &[i64],
    ) -> Result<(), Error> {
        let mut vertices = [0; MOST_NODES];
        let vertices = &mut vertices[..element.node_count];
        for vertex in vertices.iter_mut() {
            let tag = self.values.integer(tag_type, "a node of an element")?;
            *vertex = self.nodes.vertex(tag).ok_or_else(|| {
                self.values.located(
                    Error::invalid(format!("an element names node {tag}, which is not among the nodes"))
                        .with_cure("the file is damaged, or was written wrongly: write it again"),
                )
            })?;
        }
        let nodes = &self.nodes;
        let member = self
            .assembly
            .add(element.kind, element.corner_count, vertices, |vertex| nodes.tag(vertex))
            .map_err(|fault| self.values.located(fault))?;
        for &group in groups {
            self.assembly.add_to_group(element.kind.group_kind(), group, member);
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

/// The kind of a physical group by its dimension.
pub(super) fn group_kind(dimension: usize) -> GroupKind {
    match dimension {
        0 => GroupKind::Vertices,
        1 => GroupKind::Lines,
        2 => GroupKind::Polygons,
        _ => GroupKind::Cells,
    }
}

/// The tags of the nodes, and the vertex of each tag.
#[derive(Debug, Default)]
pub(super) struct Nodes {
    /// The tag of each vertex.
    tags: Vec<u64>,
    index: Index,
}

/// How a vertex is found by its tag.
#[derive(Debug, Default)]
enum Index {
    #[default]
    Empty,
    /// The tags run on from this one.
    Consecutive(u64),
    /// One more than the vertex, from the lowest tag on; 0 where there is none.
    Table(u64, Vec<u32>),
    /// Tags and vertices, sorted.
    Sorted(Vec<(u64, u32)>),
}

impl Nodes {
    /// Enters the tag of the next vertex.
    pub(super) fn add(&mut self, tag: i64) -> Result<(), Error> {
        match u64::try_from(tag) {
            Ok(tag @ 1..) => self.tags.push(tag),
            _ => {
                return Err(
                    Error::invalid(format!("a node has the tag {tag}")).with_cure("tags are positive")
                );
            }
        }
        Ok(())
    }

    /// The tag of a vertex.
    fn tag(&self, vertex: u32) -> u64 {
        self.tags.get(vertex as usize).copied().unwrap_or(0)
    }

    /// The vertex of a tag.
    fn vertex(&self, tag: i64) -> Option<u32> {
        let tag = u64::try_from(tag).ok()?;
        match &self.index {
            Index::Empty => None,
            Index::Consecutive(first) => {
                let vertex = tag.checked_sub(*first)?;
                (vertex < self.tags.len() as u64).then_some(vertex as u32)
            }
            Index::Table(first, table) => {
                let at = usize::try_from(tag.checked_sub(*first)?).ok()?;
                table.get(at)?.checked_sub(1)
            }
            Index::Sorted(pairs) => {
                let at = pairs.binary_search_by_key(&tag, |&(tag, _)| tag).ok()?;
                Some(pairs[at].1)
            }
        }
    }

    /// Makes the index once all nodes are there.
    fn finish(&mut self) -> Result<(), Error> {
        let (Some(&first), Some(&low), Some(&high)) =
            (self.tags.first(), self.tags.iter().min(), self.tags.iter().max())
        else {
            return Ok(());
        };
        let twice = |tag: u64| {
            Error::invalid(format!("node {tag} stands twice")).with_cure("give each node a tag of its own")
        };
        if self.tags.iter().enumerate().all(|(i, &tag)| tag == first + i as u64) {
            self.index = Index::Consecutive(first);
        } else if high - low < 4 * self.tags.len() as u64 + 1024 {
            let mut table = vec![0; (high - low) as usize + 1];
            for (vertex, &tag) in (1..).zip(&self.tags) {
                let place = &mut table[(tag - low) as usize];
                if *place != 0 {
                    return Err(twice(tag));
                }
                *place = vertex;
            }
            self.index = Index::Table(low, table);
        } else {
            let mut pairs: Vec<(u64, u32)> = self.tags.iter().copied().zip(0..).collect();
            pairs.sort_unstable();
            if let Some(pair) = pairs.windows(2).find(|pair| pair[0].0 == pair[1].0) {
                return Err(twice(pair[0].0));
            }
            self.index = Index::Sorted(pairs);
        }
        Ok(())
    }
}
