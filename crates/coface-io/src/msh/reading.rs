//! The sections of a file.

use super::reader::Reader;
use super::{data, version_2, version_4};
use crate::scratch_mesh::ScratchMesh;
use crate::{Model, ReadOptions};
use coface_algebra::Error;
use std::io::Read;

/// Reads a Gmsh mesh of version 2, 4.0 or 4.1, text or binary.
///
/// # Errors
/// [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) and [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) with the line (the byte in a binary file): a number out of place,
/// a node that is not there or stands twice, an element that repeats a node, a file that was cut short;
/// [`ErrorKind::UnsupportedFormat`](coface_algebra::ErrorKind::UnsupportedFormat) for other versions and for types of elements that are not known here.
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
    read_with(input, &ReadOptions::default())
}

pub(crate) fn read_with(input: impl Read, options: &ReadOptions) -> Result<Model, Error> {
    let mut reader = Reader::new(input, None);
    let Err(fault) = read_sections(&mut reader) else { return reader.assembly.finish() };
    if !options.partial || reader.assembly.vertex_count() == 0 {
        return Err(fault);
    }
    reader.assembly.remarks.insert(0, crate::remark::partial(&fault));
    reader.assembly.finish()
}

/// Reads a mesh into files.
pub(crate) fn read_into(input: impl Read, scratch: ScratchMesh) -> Result<ScratchMesh, Error> {
    let mut reader = Reader::new(input, Some(scratch));
    reader.keeps_data = false;
    read_sections(&mut reader)?;
    Ok(reader.assembly.into_scratch().expect("the files that were given"))
}

fn read_sections<R: Read>(reader: &mut Reader<R>) -> Result<(), Error> {
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
            (b"NOD" | b"NOE", None) => {
                has_nodes = true;
                version_2::read_nodes(reader)?;
                reader.nodes.finish().map_err(|fault| reader.values.located(fault))?;
            }
            (b"ELM", None) if has_nodes => {
                has_elements = true;
                version_2::read_elements_of_version_1(reader)?;
            }
            (b"Entities", Some(version)) if version.is_4() => version_4::read_entities(reader, version)?,
            (b"Nodes", Some(version)) => {
                has_nodes = true;
                if version.is_4() {
                    version_4::read_nodes(reader, version)?;
                } else {
                    version_2::read_nodes(reader)?;
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
                    version_4::read_elements(reader, version)?;
                } else {
                    version_2::read_elements(reader)?;
                }
            }
            (b"NodeData", Some(_)) if has_nodes && reader.keeps_data => {
                data::read(reader, &section)?;
                continue;
            }
            (b"ElementData", Some(_)) if has_elements && reader.keeps_data => {
                data::read(reader, &section)?;
                continue;
            }
            (b"Nodes" | b"Elements" | b"Entities", None) => {
                let fault = reader.values.error("$MeshFormat is missing");
                return Err(fault.with_cure("put the section $MeshFormat first"));
            }
            _ => {
                reader.pass_over(&section);
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
    Ok(())
}
