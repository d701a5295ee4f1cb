//! Writing VTK XML.

use super::cell_types::WEDGE;
use super::data;
use super::writing::{cell_types, group_numbers};
use crate::numbers::Numbers;
use crate::print_objects::escaped;
use crate::{CellData, GroupKind, Model, limits};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use coface_algebra::{Error, ErrorKind};
use coface_complexes::cell_mesh::CellShape;
use std::io::Write;

/// Which of the VTK XML formats.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum XmlKind {
    /// `.vtu`: an unstructured grid, which holds everything.
    UnstructuredGrid,
    /// `.vtp`: polygonal data: points, lines and polygons.
    PolyData,
}

/// Writes a VTK XML file for ParaView and its like: points, polylines, polygons and cells in the order of the model, as base64 of
/// little-endian numbers within the XML. Data on vertices and on cells follow as arrays, of the width that they have in the model; what is said
/// of groups and of data on lines, polygons and cells is as in the legacy format, see [`write`](super::write).
///
/// # Errors
/// [`ErrorKind::UnsupportedFormat`] for an abstract structure, for vertices without positions or of more than three coordinates, and for
/// 3-cells in polygonal data; [`ErrorKind::InvalidInput`] for data of one name with different numbers of components on lines, polygons and
/// cells; [`ErrorKind::Io`] from the output.
///
/// # References
/// Kitware, *VTK File Formats*, section "XML File Formats".
///
/// # Examples
/// ```
/// use coface_io::{off, vtk};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let model = off::read(&b"OFF 4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n"[..])?;
/// let mut out = Vec::new();
/// vtk::write_xml(&model, &mut out, vtk::XmlKind::PolyData)?;
/// assert!(String::from_utf8_lossy(&out).contains("NumberOfPoints=\"4\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"1\""));
/// # Ok(()) }
/// ```
pub fn write_xml(model: &Model, out: impl Write, kind: XmlKind) -> Result<(), Error> {
    limits::require_volume_mesh(model, "VTK")?;
    limits::require_dimension(model, "VTK", 3)?;
    if kind == XmlKind::PolyData && !model.cells.is_empty() {
        let message = format!("polygonal data cannot hold 3-cells, and the model has {}", model.cells.len());
        return Err(Error::new(ErrorKind::UnsupportedFormat, message).with_cure("write .vtu"));
    }
    let arrays = data::arrays_on_cells(model)?;
    let count = model.points.len() + model.lines.len() + model.polygons.len() + model.cells.len();
    let mut file = File { out };
    let word = if kind == XmlKind::PolyData { "PolyData" } else { "UnstructuredGrid" };
    file.line(&format!(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"{word}\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<{word}>"
    ))?;
    match kind {
        XmlKind::UnstructuredGrid => file.line(&format!(
            "<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{count}\">",
            model.vertex_count
        ))?,
        XmlKind::PolyData => file.line(&format!(
            "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"{}\" NumberOfStrips=\"0\" NumberOfPolys=\"{}\">",
            model.vertex_count,
            model.points.len(),
            model.lines.len(),
            model.polygons.len()
        ))?,
    }
    file.line("<PointData>")?;
    for array in model.data.iter().filter(|array| array.kind() == GroupKind::Vertices) {
        file.data(array)?;
    }
    file.line("</PointData>\n<CellData>")?;
    if !model.groups.is_empty() {
        let name = if arrays.iter().any(|data| data.name() == "group") { "group_number" } else { "group" };
        let numbers = group_numbers(model, count).into_iter().map(|number| number as i32);
        file.array("Int32", name, 1, numbers.flat_map(i32::to_le_bytes).collect())?;
    }
    for array in &arrays {
        file.data(array)?;
    }
    file.line("</CellData>\n<Points>")?;
    let dimension = model.coordinate_count();
    let points = model.coordinates().chunks_exact(dimension.max(1));
    let filled = points.flat_map(|point| [0, 1, 2].map(|i| point.get(i).copied().unwrap_or(0.0)));
    file.array("Float64", "Points", 3, filled.flat_map(f64::to_le_bytes).collect())?;
    file.line("</Points>")?;
    let verts = || model.points.iter().map(|point| vec![point.to_u32()]);
    let lists = |lists: &coface_algebra::RaggedArray| lists.iter().map(<[u32]>::to_vec).collect::<Vec<_>>();
    match kind {
        XmlKind::PolyData => {
            file.cells("Verts", verts())?;
            file.cells("Lines", lists(&model.lines))?;
            file.cells("Strips", [])?;
            file.cells("Polys", lists(&model.polygons))?;
        }
        XmlKind::UnstructuredGrid => {
            let solids = model.cells.iter().zip(&model.shapes).map(|(cell, shape)| match shape {
                CellShape::Wedge => WEDGE.iter().map(|&corner| cell[corner]).collect(),
                _ => cell.to_vec(),
            });
            let all = verts().chain(lists(&model.lines)).chain(lists(&model.polygons)).chain(solids);
            file.open_cells("Cells", all)?;
            file.array("UInt8", "types", 1, cell_types(model).map(|number| number as u8).collect())?;
            file.line("</Cells>")?;
        }
    }
    file.line(&format!("</Piece>\n</{word}>\n</VTKFile>"))?;
    file.out.flush()?;
    Ok(())
}

struct File<W> {
    out: W,
}

impl<W: Write> File<W> {
    fn line(&mut self, line: &str) -> Result<(), Error> {
        self.out.write_all(line.as_bytes())?;
        Ok(self.out.write_all(b"\n")?)
    }

    /// An array: the length of its bytes and then these, together as base64.
    fn array(
        &mut self,
        type_name: &str,
        name: &str,
        components: usize,
        mut bytes: Vec<u8>,
    ) -> Result<(), Error> {
        let length = bytes.len() as u64;
        bytes.splice(0..0, length.to_le_bytes());
        self.line(&format!(
            "<DataArray type=\"{type_name}\" Name=\"{}\" NumberOfComponents=\"{components}\" format=\"binary\">",
            escaped(name)
        ))?;
        // Three bytes are four letters: pieces can be put side by side.
        for piece in bytes.chunks(3 << 16) {
            self.out.write_all(STANDARD.encode(piece).as_bytes())?;
        }
        self.line("\n</DataArray>")
    }

    fn data(&mut self, data: &CellData) -> Result<(), Error> {
        let numbers = data.numbers();
        let type_name = match numbers {
            Numbers::UInt8(_) => "UInt8",
            Numbers::Int32(_) => "Int32",
            Numbers::Int64(_) => "Int64",
            Numbers::Float32(_) => "Float32",
            Numbers::Float64(_) => "Float64",
        };
        let mut bytes = Vec::new();
        (0..numbers.len()).for_each(|i| numbers.write_bytes(i, false, &mut bytes));
        self.array(type_name, data.name(), data.components(), bytes)
    }

    /// An element with lists of vertices: all of them, and where each ends. It stays open.
    fn open_cells(&mut self, element: &str, lists: impl IntoIterator<Item = Vec<u32>>) -> Result<(), Error> {
        let (mut vertices, mut ends, mut end) = (Vec::new(), Vec::new(), 0i64);
        for list in lists {
            end += list.len() as i64;
            vertices.extend(list.into_iter().flat_map(|vertex| i64::from(vertex).to_le_bytes()));
            ends.extend(end.to_le_bytes());
        }
        self.line(&format!("<{element}>"))?;
        self.array("Int64", "connectivity", 1, vertices)?;
        self.array("Int64", "offsets", 1, ends)
    }

    fn cells(&mut self, element: &str, lists: impl IntoIterator<Item = Vec<u32>>) -> Result<(), Error> {
        self.open_cells(element, lists)?;
        self.line(&format!("</{element}>"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Format, read};

    /// The bytes of the array of this name, behind their length.
    fn array(document: &roxmltree::Document<'_>, name: &str) -> (String, Vec<u8>) {
        let node = document
            .descendants()
            .find(|node| node.has_tag_name("DataArray") && node.attribute("Name") == Some(name))
            .unwrap();
        let bytes = STANDARD.decode(node.text().unwrap().trim()).unwrap();
        assert_eq!(u64::from_le_bytes(bytes[..8].try_into().unwrap()), bytes.len() as u64 - 8);
        (node.attribute("type").unwrap().to_owned(), bytes[8..].to_vec())
    }

    fn integers(bytes: &[u8]) -> Vec<i64> {
        bytes.chunks_exact(8).map(|bytes| i64::from_le_bytes(bytes.try_into().unwrap())).collect()
    }

    #[test]
    fn cells_of_all_sorts_come_in_order_with_their_data() {
        let text = "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 6 double\n\
            0 0 0 1 0 0 0 1 0 0 0 1 1 0 1 0 1 1\nCELLS 3 14\n6 0 1 2 3 4 5\n3 0 1 2\n2 3 4\nCELL_TYPES 3\n13\n5\n3\n\
            CELL_DATA 3\nSCALARS <a> float 1\nLOOKUP_TABLE default\n7 8 9\nPOINT_DATA 6\nSCALARS b int 1\n\
            LOOKUP_TABLE default\n0 1 2 3 4 5\n";
        let model = read(text.as_bytes(), Format::Vtk).unwrap();
        let mut out = Vec::new();
        write_xml(&model, &mut out, XmlKind::UnstructuredGrid).unwrap();
        let out = String::from_utf8(out).unwrap();
        let document = roxmltree::Document::parse(&out).unwrap();
        assert_eq!(integers(&array(&document, "offsets").1), [2, 5, 11]);
        // The wedge is as it was in the file.
        assert_eq!(integers(&array(&document, "connectivity").1), [3, 4, 0, 1, 2, 0, 1, 2, 3, 4, 5]);
        assert_eq!(array(&document, "types"), ("UInt8".to_owned(), vec![3, 5, 13]));
        let floats = [9f32, 8.0, 7.0].map(f32::to_le_bytes).concat();
        assert_eq!(array(&document, "<a>"), ("Float32".to_owned(), floats));
        assert_eq!(array(&document, "b").0, "Int32");
        let error = write_xml(&model, Vec::new(), XmlKind::PolyData).unwrap_err().to_string();
        assert!(error.contains("3-cells") && error.contains(".vtu"), "{error}");
    }

    #[test]
    fn an_empty_model_is_a_whole_file() {
        let model = read(&b"OFF 0 0 0\n"[..], Format::Off).unwrap();
        for kind in [XmlKind::PolyData, XmlKind::UnstructuredGrid] {
            let mut out = Vec::new();
            write_xml(&model, &mut out, kind).unwrap();
            assert!(roxmltree::Document::parse(std::str::from_utf8(&out).unwrap()).is_ok());
        }
    }
}
