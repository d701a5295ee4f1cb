//! Writing, as text or binary.

use super::cell_types::WEDGE;
use super::data;
use crate::decimal::{flush, push_f64, push_natural};
use crate::{CellData, GroupKind, Model, limits};
use coface_algebra::{Error, ErrorKind};
use coface_complexes::cell_mesh::CellShape;
use std::io::Write;

/// How numbers are written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Encoding {
    /// Decimal numbers.
    #[default]
    Ascii,
    /// Binary, the most significant byte first, as the format demands.
    Binary,
}

/// Writes a legacy VTK file of version 3.0, an unstructured grid: points, polylines, polygons, cells, in the order of the
/// model. If there are groups, the cell data `group` says of each cell which one it is in, counted from 1, the first of
/// several; 0 is none. Readers do not make groups of it again.
///
/// Data follow as fields. The format knows arrays on all cells only: those of one name on lines, polygons and cells are
/// one array, and it is 0 on cells that have no such data.
///
/// # Errors
/// [`ErrorKind::UnsupportedFormat`] for an abstract structure and for vertices without positions or of more than three
/// coordinates; [`ErrorKind::InvalidInput`] for data of one name with different numbers of components on lines, polygons
/// and cells; [`ErrorKind::TooLarge`] for more than 2^31 - 1 numbers in a binary list; [`ErrorKind::Io`] from the
/// output.
///
/// # Examples
/// ```
/// use coface_io::{off, vtk};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let model = off::read(&b"OFF 4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n"[..])?;
/// let mut out = Vec::new();
/// vtk::write(&model, &mut out, vtk::Encoding::Ascii)?;
/// assert!(out.ends_with(b"CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n9\n"));
/// assert_eq!(vtk::read(&out[..])?, model);
/// # Ok(()) }
/// ```
pub fn write(model: &Model, mut out: impl Write, encoding: Encoding) -> Result<(), Error> {
    limits::require_volume_mesh(model, "VTK")?;
    limits::require_dimension(model, "VTK", 3)?;
    let dimension = model.coordinate_count();
    let mut numbers = Numbers { text: Vec::new(), encoding };
    let word = if encoding == Encoding::Ascii { "ASCII" } else { "BINARY" };
    numbers.line(&format!(
        "# vtk DataFile Version 3.0\nwritten by coface\n{word}\nDATASET UNSTRUCTURED_GRID\nPOINTS {} double",
        model.vertex_count
    ));
    for point in model.coordinates().chunks_exact(dimension.max(1)) {
        for i in 0..3 {
            numbers.float(point.get(i).copied().unwrap_or(0.0), i == 2);
        }
        flush(&mut numbers.text, &mut out)?;
    }
    numbers.end_block();

    let count = model.points.len() + model.lines.len() + model.polygons.len() + model.cells.len();
    let items = model.points.len()
        + model.lines.item_count()
        + model.polygons.item_count()
        + model.cells.item_count();
    if encoding == Encoding::Binary && i32::try_from(count + items).is_err() {
        let message =
            format!("the cells take {} numbers, and a binary VTK file holds 2^31 - 1", count + items);
        return Err(Error::new(ErrorKind::TooLarge, message).with_cure("write it as text"));
    }
    numbers.line(&format!("CELLS {count} {}", count + items));
    for point in &model.points {
        numbers.list(&[point.to_u32()]);
        flush(&mut numbers.text, &mut out)?;
    }
    for list in model.lines.iter().chain(model.polygons.iter()) {
        numbers.list(list);
        flush(&mut numbers.text, &mut out)?;
    }
    for (cell, &shape) in model.cells.iter().zip(&model.shapes) {
        match (shape, cell.len()) {
            (CellShape::Wedge, 6) => {
                let mut exchanged = [0; 6];
                for (place, &corner) in exchanged.iter_mut().zip(WEDGE) {
                    *place = cell[corner];
                }
                numbers.list(&exchanged);
            }
            _ => numbers.list(cell),
        }
        flush(&mut numbers.text, &mut out)?;
    }
    numbers.end_block();

    numbers.line(&format!("CELL_TYPES {count}"));
    for number in cell_types(model) {
        numbers.integer(number, true);
        flush(&mut numbers.text, &mut out)?;
    }
    numbers.end_block();
    let arrays = data::arrays_on_cells(model)?;
    if !model.groups.is_empty() || !arrays.is_empty() {
        numbers.line(&format!("CELL_DATA {count}"));
    }
    if !model.groups.is_empty() {
        let name = if arrays.iter().any(|data| data.name() == "group") { "group_number" } else { "group" };
        numbers.line(&format!("SCALARS {name} int 1\nLOOKUP_TABLE default"));
        for number in group_numbers(model, count) {
            numbers.integer(number, true);
            flush(&mut numbers.text, &mut out)?;
        }
        numbers.end_block();
    }
    numbers.fields(&arrays.iter().collect::<Vec<_>>(), &mut out)?;
    let on_points: Vec<&CellData> =
        model.data.iter().filter(|data| data.kind() == GroupKind::Vertices).collect();
    if !on_points.is_empty() {
        numbers.line(&format!("POINT_DATA {}", model.vertex_count));
        numbers.fields(&on_points, &mut out)?;
    }
    out.write_all(&numbers.text)?;
    out.flush()?;
    Ok(())
}

/// The types of all cells in the order of writing.
pub(super) fn cell_types(model: &Model) -> impl Iterator<Item = u32> {
    let points = model.points.iter().map(|_| 1);
    let lines = model.lines.iter().map(|line| if line.len() == 2 { 3 } else { 4 });
    let polygons = model.polygons.iter().map(|polygon| match polygon.len() {
        3 => 5,
        4 => 9,
        _ => 7,
    });
    let cells = model.shapes.iter().map(|shape| match shape {
        CellShape::Tetrahedron => 10,
        CellShape::Hexahedron => 12,
        CellShape::Wedge => 13,
        CellShape::Pyramid => 14,
    });
    points.chain(lines).chain(polygons).chain(cells)
}

/// For each cell in the order of writing the number of its first group, from 1.
pub(super) fn group_numbers(model: &Model, count: usize) -> Vec<u32> {
    let mut numbers = vec![0; count];
    let lines = model.points.len();
    let polygons = lines + model.lines.len();
    let cells = polygons + model.polygons.len();
    for (group, number) in model.groups.iter().zip(1..) {
        let mut mark = |at: usize| {
            if let Some(place) = numbers.get_mut(at).filter(|place| **place == 0) {
                *place = number;
            }
        };
        match group.kind() {
            GroupKind::Vertices => {
                let mut members = group.members().to_vec();
                members.sort_unstable();
                let places = model.points.iter().enumerate();
                let inside = places.filter(|(_, point)| members.binary_search(&point.to_u32()).is_ok());
                inside.for_each(|(at, _)| mark(at));
            }
            GroupKind::Lines => group.members().iter().for_each(|&at| mark(lines + at as usize)),
            GroupKind::Polygons => group.members().iter().for_each(|&at| mark(polygons + at as usize)),
            GroupKind::Cells => group.members().iter().for_each(|&at| mark(cells + at as usize)),
        }
    }
    numbers
}

/// Numbers on their way out.
struct Numbers {
    text: Vec<u8>,
    encoding: Encoding,
}

impl Numbers {
    fn line(&mut self, line: &str) {
        self.text.extend_from_slice(line.as_bytes());
        self.text.push(b'\n');
    }

    fn float(&mut self, value: f64, is_last: bool) {
        match self.encoding {
            Encoding::Binary => self.text.extend_from_slice(&value.to_be_bytes()),
            Encoding::Ascii => {
                push_f64(&mut self.text, value);
                self.text.push(if is_last { b'\n' } else { b' ' });
            }
        }
    }

    fn integer(&mut self, value: u32, is_last: bool) {
        match self.encoding {
            Encoding::Binary => self.text.extend_from_slice(&value.to_be_bytes()),
            Encoding::Ascii => {
                push_natural(&mut self.text, value.into());
                self.text.push(if is_last { b'\n' } else { b' ' });
            }
        }
    }

    /// Arrays with their rows.
    fn fields(&mut self, arrays: &[&CellData], out: &mut impl Write) -> Result<(), Error> {
        if arrays.is_empty() {
            return Ok(());
        }
        self.line(&format!("FIELD FieldData {}", arrays.len()));
        for data in arrays {
            let numbers = data.numbers();
            self.line(&format!(
                "{} {} {} {}",
                data::encoded(data.name()),
                data.components(),
                data.len(),
                data::type_name(numbers)
            ));
            for i in 0..numbers.len() {
                if self.encoding == Encoding::Binary {
                    numbers.write_bytes(i, true, &mut self.text);
                } else {
                    numbers.write_word(i, &mut self.text);
                    self.text.push(if (i + 1).is_multiple_of(data.components()) { b'\n' } else { b' ' });
                }
                flush(&mut self.text, out)?;
            }
            self.end_block();
        }
        Ok(())
    }

    fn list(&mut self, list: &[u32]) {
        self.integer(list.len() as u32, list.is_empty());
        for (i, &vertex) in list.iter().enumerate() {
            self.integer(vertex, i + 1 == list.len());
        }
    }

    /// A line end behind a binary block; a text has it already.
    fn end_block(&mut self) {
        if self.encoding == Encoding::Binary {
            self.text.push(b'\n');
        }
    }
}
