//! What the sections of a legacy file have in common.

use super::elements::Elements;
use crate::scanner::{Scanner, quoted};
use crate::values::{Encoding, NumberType, Values};
use coface_algebra::{Error, ErrorKind};
use std::io::Read;

/// Lists of points with the place of each in the file.
pub(super) struct Lists {
    pub(super) starts: Vec<usize>,
    pub(super) points: Vec<u32>,
    /// The line, or the byte, of each list; of all of them if there is one only.
    pub(super) places: Vec<u64>,
    pub(super) is_ascii: bool,
}

impl Default for Lists {
    fn default() -> Self {
        Self { starts: vec![0], points: Vec::new(), places: Vec::new(), is_ascii: true }
    }
}

impl Lists {
    pub(super) fn len(&self) -> usize {
        self.starts.len() - 1
    }

    pub(super) fn list(&self, i: usize) -> &[u32] {
        &self.points[self.starts[i]..self.starts[i + 1]]
    }

    /// A fault in list `i`.
    pub(super) fn place(&self, i: usize, fault: Error) -> Error {
        let place = self.places.get(i).or(self.places.last()).copied().unwrap_or(0);
        if self.is_ascii { fault.at_line(place) } else { fault.at_byte(place) }
    }
}

/// How the points of a grid are given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum GridKind {
    /// By an origin and three steps.
    Uniform,
    /// By coordinates along three axes.
    Rectilinear,
    /// One by one.
    Curved,
}

/// A grid as far as it has been read.
#[derive(Debug, Default)]
pub(super) struct Grid {
    pub(super) kind: Option<GridKind>,
    pub(super) dimensions: Option<[u64; 3]>,
    pub(super) origin: [f64; 3],
    pub(super) spacing: Option<[f64; 3]>,
    pub(super) axes: [Option<Vec<f64>>; 3],
}

/// What data that follow are on.
#[derive(Clone, Copy, Debug)]
pub(super) enum Place {
    Points,
    Cells,
}

/// A file whose sections are read one after the other.
pub(super) struct Reader<R> {
    pub(super) values: Values<R>,
    pub(super) elements: Elements,
    /// The cells of an unstructured grid, before their types are known.
    pub(super) cells: Option<Lists>,
    pub(super) has_dataset: bool,
    pub(super) has_offsets: bool,
    pub(super) grid: Grid,
    /// What data that follow are on; `None` before the first.
    pub(super) data_place: Option<Place>,
}

impl<R: Read> Reader<R> {
    pub(super) fn new(input: R) -> Self {
        Self {
            values: Values::new(Scanner::new(input), Encoding::Ascii),
            elements: Elements::new(),
            cells: None,
            has_dataset: false,
            has_offsets: false,
            grid: Grid::default(),
            data_place: None,
        }
    }

    pub(super) fn header_error(&self, message: String, cure: &str) -> Error {
        self.values.error(message).with_cure(cure)
    }

    pub(super) fn read_points(&mut self) -> Result<(), Error> {
        if self.elements.assembly.vertex_count() > 0 {
            return Err(self.header_error("the points are given twice".to_owned(), "keep one section POINTS"));
        }
        let count = self.values.scanner.expect_u64("the count of points")?;
        let number = self.read_type()?;
        self.values.end_line()?;
        for _ in 0..count {
            let mut point = [0.0; 3];
            for coordinate in &mut point {
                *coordinate = self.values.coordinate(number, "a coordinate")?;
            }
            let line = self.values.line();
            let added = self.elements.assembly.add_vertex_on_line(&point, line);
            added.map_err(|fault| self.values.located(fault))?;
        }
        Ok(())
    }

    /// The type of the numbers of an array.
    pub(super) fn read_type(&mut self) -> Result<NumberType, Error> {
        let name = self.values.scanner.expect_token("a type of numbers")?.to_ascii_lowercase();
        number_type(&name).ok_or_else(|| {
            let message = format!("{} is no type of numbers", quoted(&name));
            self.header_error(message, "use float, double, int, vtktypeint64 or their like")
        })
    }

    /// The fault of an array of another type than numbers before the mesh.
    pub(super) fn unreadable_field(&self, type_name: &[u8]) -> Error {
        let message = format!("arrays of {} cannot be passed over", quoted(type_name));
        let fault = Error::new(ErrorKind::UnsupportedFormat, message);
        self.values.located(fault.with_cure("remove the FIELD before the points"))
    }

    /// Lines up to an empty one.
    pub(super) fn skip_metadata(&mut self) -> Result<(), Error> {
        self.values.scanner.next_line()?;
        while let Some(line) = self.values.scanner.next_line()? {
            if line.trim_ascii().is_empty() {
                break;
            }
        }
        Ok(())
    }
}

/// The type of numbers of this name.
pub(super) fn number_type(name: &[u8]) -> Option<NumberType> {
    Some(match name {
        b"char" | b"signed_char" | b"vtktypeint8" => NumberType::Int8,
        b"unsigned_char" | b"vtktypeuint8" => NumberType::UInt8,
        b"short" | b"vtktypeint16" => NumberType::Int16,
        b"unsigned_short" | b"vtktypeuint16" => NumberType::UInt16,
        // Ids are written as 32-bit numbers whatever they are in memory.
        b"int" | b"vtkidtype" | b"vtktypeint32" => NumberType::Int32,
        b"unsigned_int" | b"vtktypeuint32" => NumberType::UInt32,
        b"long" | b"long_long" | b"vtktypeint64" => NumberType::Int64,
        b"unsigned_long" | b"unsigned_long_long" | b"vtktypeuint64" => NumberType::UInt64,
        b"float" | b"vtktypefloat32" => NumberType::Float32,
        b"double" | b"vtktypefloat64" => NumberType::Float64,
        _ => return None,
    })
}
