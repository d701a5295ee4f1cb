//! Reading VTK XML: the pieces of a mesh.

use super::cell_runs::{Cells, KINDS};
use super::cell_types::CellType;
use super::elements::{Elements, count_nonzero};
use super::xml_arrays::{Appended, Array, Storage, located, natural};
use crate::numbers::Numbers;
use crate::values::{Encoding, NumberType};
use crate::{CellData, GroupKind, Model};
use crate::{Remark, RemarkCode};
use coface_algebra::{Error, ErrorKind};
use memchr::memmem;
use roxmltree::{Document, Node};
use std::borrow::Cow;
use std::io::Read;

/// Reads a VTK XML file: an unstructured grid (`.vtu`) or polygonal data (`.vtp`), in any encoding. Several pieces become one mesh, one after
/// the other; points that pieces share are not merged. Data that are no numbers, or that not every piece has, are left out with a remark.
///
/// # Errors
/// [`ErrorKind::Parse`] and [`ErrorKind::InvalidInput`] with the line: what is no XML, an array that is too short or too long, an index outside
/// the points, a cell that repeats a point; [`ErrorKind::UnsupportedFormat`] for other data sets, types of cells and compressors than those
/// known here (zlib).
///
/// # Complexity
/// Linear; memory is the file, the model and an array.
///
/// # References
/// Kitware, *VTK File Formats*, section "XML File Formats".
///
/// # Examples
/// ```
/// use coface_io::vtk;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let text = br#"<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian">
/// <PolyData><Piece NumberOfPoints="4" NumberOfPolys="1">
/// <Points><DataArray type="Float32" NumberOfComponents="3" format="ascii">0 0 0 1 0 0 1 1 0 0 1 0</DataArray></Points>
/// <Polys><DataArray type="Int32" Name="connectivity" format="ascii">0 1 2 3</DataArray>
/// <DataArray type="Int32" Name="offsets" format="ascii">4</DataArray></Polys>
/// </Piece></PolyData></VTKFile>"#;
/// assert_eq!(vtk::read_xml(&text[..])?.polygons().list(0), [0, 1, 2, 3]);
/// # Ok(()) }
/// ```
pub fn read_xml(input: impl Read) -> Result<Model, Error> {
    let bytes = all_bytes(input)?;
    let (text, appended) = split(&bytes)?;
    let text = match text {
        Cow::Borrowed(text) => std::str::from_utf8(text).map(Cow::Borrowed),
        Cow::Owned(text) => String::from_utf8(text).map(Cow::Owned).map_err(|error| error.utf8_error()),
    };
    let text = text.map_err(|error| {
        Error::parse("the text is not UTF-8")
            .at_byte(error.valid_up_to() as u64)
            .with_cure("save the file as UTF-8, or write it again")
    })?;
    let document = Document::parse(&text).map_err(|error| {
        let message: String = error
            .to_string()
            .chars()
            .flat_map(|c| match c.is_control() {
                true => c.escape_default().collect::<Vec<_>>(),
                false => vec![c],
            })
            .take(200)
            .collect();
        Error::parse(format!("this is no XML: {message}"))
            .at_line(error.pos().row.into())
            .with_cure("the file was cut short or damaged: write it again")
    })?;
    let root = document.root_element();
    if !root.has_tag_name("VTKFile") {
        let name = root.tag_name().name().escape_debug();
        let message = format!("the element \"{name}\" stands where VTKFile should");
        return Err(located(Error::parse(message).with_cure("check that this is a VTK XML file"), root));
    }
    let storage = storage_of(root, appended)?;
    let kind = root.attribute("type").unwrap_or_default();
    if !matches!(kind, "UnstructuredGrid" | "PolyData") {
        let message = format!("data sets of the kind \"{}\" are not read", kind.escape_debug());
        let fault = Error::new(ErrorKind::UnsupportedFormat, message);
        return Err(located(fault.with_cure("save it as UnstructuredGrid (.vtu) or PolyData (.vtp)"), root));
    }
    let Some(set) = child(root, kind) else {
        return Err(located(missing(kind), root));
    };
    let mut reader = Reader { storage, elements: Elements::new(), data: Vec::new(), piece_count: 0 };
    for piece in set.children().filter(|node| node.has_tag_name("Piece")) {
        reader.read_piece(piece, kind == "PolyData")?;
    }
    reader.finish()
}

/// What begins the appended data.
const START: &[u8] = b"<AppendedData";

/// The whole file, unless it is no text where there should be some.
fn all_bytes(mut input: impl Read) -> Result<Vec<u8>, Error> {
    let (mut bytes, mut is_text, mut from) = (Vec::new(), true, 0);
    loop {
        let before = bytes.len();
        input.by_ref().take(1 << 20).read_to_end(&mut bytes)?;
        if bytes.len() == before {
            return Ok(bytes);
        }
        if is_text {
            is_text = memmem::find(&bytes[from..], START).is_none();
            if let Some(zero) = memchr::memchr(0, &bytes[before..]).filter(|_| is_text) {
                return Err(Error::parse("there is a zero byte in the text")
                    .at_byte((before + zero) as u64)
                    .with_cure("the file is damaged: write it again"));
            }
            // The word may lie across two pieces.
            from = bytes.len().saturating_sub(START.len());
        }
    }
}

/// The XML without appended data, and these.
///
/// Appended bytes are no XML: what the element holds is cut out before anything is parsed. Its end is the last of its kind in the file, for
/// bytes may look like one.
fn split(bytes: &[u8]) -> Result<(Cow<'_, [u8]>, Appended<'_>), Error> {
    const END: &[u8] = b"</AppendedData";
    let mut from = 0;
    let start = loop {
        let Some(at) = memmem::find(&bytes[from..], START).map(|at| from + at) else {
            return Ok((Cow::Borrowed(bytes), Appended::None));
        };
        // In a comment it is none.
        match memmem::find(&bytes[from..at], b"<!--").map(|comment| from + comment) {
            Some(comment) => match memmem::find(&bytes[comment..], b"-->") {
                Some(end) => from = comment + end,
                None => return Ok((Cow::Borrowed(bytes), Appended::None)),
            },
            None => break at,
        }
    };
    let line = || memchr::memchr_iter(b'\n', &bytes[..start]).count() as u64 + 1;
    let fault = |message: &str| {
        Error::parse(message).at_line(line()).with_cure("the file was cut short or damaged: write it again")
    };
    let open = memchr::memchr(b'>', &bytes[start..]).ok_or_else(|| fault("AppendedData does not end"))?;
    let head = &bytes[start..start + open];
    let body = start + open + 1;
    let end = memmem::rfind(&bytes[body..], END).ok_or_else(|| fault("AppendedData does not end"))? + body;
    let gap = bytes[body..end].iter().position(|byte| !byte.is_ascii_whitespace()).map(|gap| body + gap);
    let Some(first) = gap.filter(|&gap| bytes[gap] == b'_') else {
        return Err(fault("AppendedData do not begin with an underscore"));
    };
    let held = &bytes[first + 1..end];
    let says = |text: &[u8]| memmem::find(head, text).is_some();
    let appended = if says(b"\"raw\"") || says(b"'raw'") {
        Appended::Raw(held)
    } else if says(b"\"base64\"") || says(b"'base64'") || !says(b"encoding") {
        Appended::Base64(held)
    } else {
        return Err(fault("AppendedData have an encoding that is neither raw nor base64"));
    };
    let text = [&bytes[..body], &bytes[end..]].concat();
    Ok((Cow::Owned(text), appended))
}

fn storage_of<'a>(root: Node<'_, '_>, appended: Appended<'a>) -> Result<Storage<'a>, Error> {
    let unknown = |attribute: &str, value: &str, cure: &str| {
        let message = format!("{attribute} is \"{}\"", value.escape_debug());
        located(Error::new(ErrorKind::UnsupportedFormat, message).with_cure(cure), root)
    };
    let encoding = match root.attribute("byte_order").unwrap_or("LittleEndian") {
        "LittleEndian" => Encoding::LittleEndian,
        "BigEndian" => Encoding::BigEndian,
        other => return Err(unknown("byte_order", other, "it is LittleEndian or BigEndian")),
    };
    let length = match root.attribute("header_type").unwrap_or("UInt32") {
        "UInt32" => NumberType::UInt32,
        "UInt64" => NumberType::UInt64,
        other => return Err(unknown("header_type", other, "it is UInt32 or UInt64")),
    };
    let is_compressed = match root.attribute("compressor").unwrap_or_default() {
        "" => false,
        "vtkZLibDataCompressor" => true,
        other => {
            let cure = "write the file again uncompressed, or compressed by zlib";
            return Err(unknown("the compressor", other, cure));
        }
    };
    Ok(Storage { encoding, length, is_compressed, appended })
}

fn child<'a, 'i>(node: Node<'a, 'i>, name: &str) -> Option<Node<'a, 'i>> {
    node.children().find(|child| child.has_tag_name(name))
}

fn missing(what: &str) -> Error {
    Error::parse(format!("{what} is missing")).with_cure("the file is not complete: write it again")
}

/// The arrays of an element.
fn arrays<'a, 'i>(node: Option<Node<'a, 'i>>) -> impl Iterator<Item = Node<'a, 'i>> {
    let nodes = node.into_iter().flat_map(|node| node.children());
    nodes.filter(|node| node.has_tag_name("DataArray") || node.has_tag_name("Array"))
}

/// Data on one kind of cells, or on vertices, as far as pieces have it.
struct Gathered {
    name: String,
    kind: GroupKind,
    components: usize,
    numbers: Numbers,
    /// The number of pieces that have it, no two rows of one piece among them.
    pieces: usize,
}

struct Reader<'a> {
    storage: Storage<'a>,
    elements: Elements,
    data: Vec<Gathered>,
    piece_count: usize,
}

/// The kinds of cells of polygonal data in the order of the data on them.
const SECTIONS: [(&str, &str, CellType); 4] = [
    ("Verts", "NumberOfVerts", CellType::Points),
    ("Lines", "NumberOfLines", CellType::Polyline),
    ("Polys", "NumberOfPolys", CellType::Polygon),
    ("Strips", "NumberOfStrips", CellType::Strip),
];

impl Reader<'_> {
    fn read_piece(&mut self, piece: Node<'_, '_>, is_poly_data: bool) -> Result<(), Error> {
        let first = self.elements.assembly.vertex_count();
        let firsts = KINDS.map(|kind| self.elements.assembly.count_of(kind));
        self.elements.cells = Cells::default();
        let point_count = natural(piece, "NumberOfPoints", None)?;
        self.read_points(piece, point_count)?;
        let points = first as u32..self.elements.assembly.vertex_count() as u32;
        if is_poly_data {
            for (section, (name, attribute, cell_type)) in SECTIONS.into_iter().enumerate() {
                let count = natural(piece, attribute, Some(0))?;
                if count > 0 {
                    let node = child(piece, name).ok_or_else(|| located(missing(name), piece))?;
                    self.read_cells(node, section, count, Some(cell_type), points.clone())?;
                }
            }
        } else {
            let count = natural(piece, "NumberOfCells", None)?;
            if count > 0 {
                let node = child(piece, "Cells").ok_or_else(|| located(missing("Cells"), piece))?;
                self.read_cells(node, 0, count, None, points)?;
            }
        }
        for node in arrays(child(piece, "PointData")) {
            if let Some(array) = self.data_array(node, point_count)? {
                self.gather(&array.name, GroupKind::Vertices, array.components, &array.numbers, node)?;
            }
        }
        for node in arrays(child(piece, "CellData")) {
            let Some(array) = self.data_array(node, self.elements.cells.count())? else { continue };
            let mut taken = 0;
            for (kind, first) in KINDS.into_iter().zip(firsts) {
                let count = self.elements.assembly.count_of(kind) - first;
                let part = self.elements.cells.numbers_on(kind, count, array.components, &array.numbers);
                taken += count_nonzero(&part);
                self.gather(&array.name, kind, array.components, &part, node)?;
            }
            self.elements.remark_on_points(&array.numbers, taken);
        }
        self.piece_count += 1;
        Ok(())
    }

    fn read_points(&mut self, piece: Node<'_, '_>, count: u64) -> Result<(), Error> {
        let Some(node) = arrays(child(piece, "Points")).next() else {
            return if count == 0 { Ok(()) } else { Err(located(missing("Points"), piece)) };
        };
        let array = self.storage.array(node, count, 3)?.ok_or_else(|| located(missing("Points"), piece))?;
        if array.components != 3 {
            let message = format!("points have {} coordinates, not 3", array.components);
            return Err(located(Error::invalid(message).with_cure("give each point three"), node));
        }
        for i in 0..array.numbers.len() / 3 {
            let point = [0, 1, 2].map(|k| array.numbers.real(3 * i + k));
            self.elements.assembly.add_vertex(&point).map_err(|fault| located(fault, node))?;
        }
        Ok(())
    }

    /// Adds cells, of one type or of the types in their element; `points` are those of the piece.
    fn read_cells(
        &mut self,
        node: Node<'_, '_>,
        section: usize,
        count: u64,
        cell_type: Option<CellType>,
        points: std::ops::Range<u32>,
    ) -> Result<(), Error> {
        let named = |name: &str| {
            arrays(Some(node))
                .find(|array| array.attribute("Name") == Some(name))
                .ok_or_else(|| located(missing(&format!("the array {name}")), node))
        };
        let whole = |name: &str, count: u64| {
            let node = named(name)?;
            self.storage.integers(node, count)?.map(|numbers| (numbers, node)).ok_or_else(|| {
                let fault = Error::parse(format!("the array {name} has no single integers"));
                located(fault.with_cure("write it as Int64 with one component"), node)
            })
        };
        let (offsets, offsets_node) = whole("offsets", count)?;
        let size = offsets.integer(offsets.len().saturating_sub(1)).and_then(|size| u64::try_from(size).ok());
        let size = size.ok_or_else(|| {
            let fault = Error::invalid("the last offset is negative");
            located(fault.with_cure("offsets say where each cell ends"), offsets_node)
        })?;
        let (connectivity, connectivity_node) = whole("connectivity", size)?;
        let types = if cell_type.is_none() { Some(whole("types", count)?) } else { None };
        let mut vertices = Vec::new();
        let mut start = 0;
        for i in 0..count as usize {
            let end = offsets.integer(i).unwrap_or(-1);
            if end < start as i64 || end as u64 > size {
                let message = format!("the offset of cell {i} is {end}; offsets rise from 0 to {size}");
                let fault = Error::invalid(message).with_cure("the file is damaged: write it again");
                return Err(located(fault, offsets_node));
            }
            vertices.clear();
            for k in start..end as usize {
                let index = connectivity.integer(k).unwrap_or(-1);
                let point = u32::try_from(index).ok().and_then(|index| points.start.checked_add(index));
                let Some(point) = point.filter(|point| points.contains(point)) else {
                    let message = format!(
                        "cell {i} names point {index}, but the piece has {} points, numbered from 0",
                        points.len()
                    );
                    let cure = "the file is damaged, or was written wrongly: write it again";
                    return Err(located(Error::invalid(message).with_cure(cure), connectivity_node));
                };
                vertices.push(point);
            }
            start = end as usize;
            let cell_type = match (cell_type, &types) {
                (Some(cell_type), _) => cell_type,
                (None, Some((types, node))) => CellType::of_cell(i, types.integer(i).unwrap_or(-1))
                    .map_err(|fault| located(fault, *node))?,
                (None, None) => CellType::Empty,
            };
            self.elements.add_cell(section, cell_type, &vertices, points.start).map_err(|fault| {
                let placed = Error::new(fault.kind(), format!("cell {i}: {}", fault.message()));
                located(placed.with_cure(fault.cure().unwrap_or("remove it")), connectivity_node)
            })?;
        }
        Ok(())
    }

    /// An array of data; `None`, with a remark, if it holds no numbers.
    fn data_array(&mut self, node: Node<'_, '_>, rows: u64) -> Result<Option<Array>, Error> {
        let array = self.storage.array(node, rows, 1)?;
        if array.is_none() {
            let name = node.attribute("Name").unwrap_or_default().escape_debug();
            self.leave_out(format!("the data \"{name}\" are no numbers; they are left out"));
        }
        Ok(array.filter(|array| array.components > 0))
    }

    fn leave_out(&mut self, message: String) {
        let remarks = &mut self.elements.assembly.remarks;
        if !remarks.iter().any(|remark| remark.message == message) {
            remarks.push(Remark::new(RemarkCode::DataLeftOut, message));
        }
    }

    /// Puts data of a piece behind those of the pieces before.
    fn gather(
        &mut self,
        name: &str,
        kind: GroupKind,
        components: usize,
        numbers: &Numbers,
        node: Node<'_, '_>,
    ) -> Result<(), Error> {
        let known = self.data.iter_mut().find(|data| (data.name.as_str(), data.kind) == (name, kind));
        let Some(data) = known.filter(|data| data.pieces == self.piece_count) else {
            if self.piece_count == 0 {
                let (name, numbers) = (name.to_owned(), numbers.clone());
                self.data.push(Gathered { name, kind, components, numbers, pieces: 1 });
            }
            return Ok(());
        };
        if data.components != components {
            let message = format!(
                "the data \"{}\" have {components} components, in the pieces before {}",
                name.escape_debug(),
                data.components
            );
            return Err(located(Error::invalid(message).with_cure("write them alike in all pieces"), node));
        }
        let common = data.numbers.common_type(numbers);
        if std::mem::discriminant(&common) != std::mem::discriminant(&data.numbers) {
            let mut wide = common;
            wide.extend(&data.numbers, 0..data.numbers.len());
            data.numbers = wide;
        }
        data.numbers.extend(numbers, 0..numbers.len());
        data.pieces += 1;
        Ok(())
    }

    fn finish(mut self) -> Result<Model, Error> {
        for data in std::mem::take(&mut self.data) {
            if data.pieces < self.piece_count {
                let name = data.name.escape_debug();
                self.leave_out(format!("the data \"{name}\" are not in every piece; they are left out"));
            } else if self.elements.assembly.count_of(data.kind) > 0 {
                let Gathered { name, kind, components, numbers, .. } = data;
                self.elements.assembly.add_data(CellData::of_file(name, kind, components, numbers));
            }
        }
        self.elements.assembly.finish()
    }
}
