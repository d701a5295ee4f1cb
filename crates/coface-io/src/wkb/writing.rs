//! From a model to bytes or digits.

use super::{COLLECTION, HAS_SRID, HAS_Z, LINE, MULTI, POINT, POLYGON, POLYHEDRAL_SURFACE};
use crate::drawing::{Shape, closed, written_dimension};
use crate::geometries::Geometries;
use crate::{Model, ReferenceSystem};
use coface_algebra::{Error, ErrorKind};
use std::io::Write;

/// How bytes are written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Encoding {
    /// As they are.
    #[default]
    Bytes,
    /// As hexadecimal digits, a geometry a line.
    Digits,
}

/// Writes one geometry for each feature, as [`wkt::write`](crate::wkt::write) does: as bytes in one geometry, a collection if there are several
/// features, or as digits with a geometry a line. Names and data are not kept; the number of the reference system is.
///
/// # Errors
/// [`ErrorKind::UnsupportedFormat`] if the model has 3-cells, no positions or more than three coordinates a vertex, or is
/// an abstract structure; [`ErrorKind::TooLarge`] for a ring of 2^32 corners; [`ErrorKind::Io`] if the stream fails.
///
/// # Examples
/// ```
/// use coface_io::wkb::{self, Encoding};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let model = coface_io::wkt::read(&b"SRID=4326;POINT (1 2)"[..])?;
/// let mut digits = Vec::new();
/// wkb::write(&model, &mut digits, Encoding::Digits)?;
/// assert_eq!(digits, b"0101000020E6100000000000000000F03F0000000000000040\n");
/// let mut bytes = Vec::new();
/// wkb::write(&model, &mut bytes, Encoding::Bytes)?;
/// assert_eq!(wkb::read(&bytes[..])?, model);
/// # Ok(()) }
/// ```
pub fn write(model: &Model, mut output: impl Write, encoding: Encoding) -> Result<(), Error> {
    let srid = model.reference_system().and_then(ReferenceSystem::srid);
    let writer = Writer { model, dimension: written_dimension(model, "WKB")?, is_extended: srid.is_some() };
    let geometries = Geometries::of(model, writer.dimension);
    let features = || geometries.iter();
    let mut bytes = Vec::new();
    match encoding {
        Encoding::Digits => {
            for feature in features() {
                bytes.clear();
                writer.push_geometry(feature, srid, &mut bytes)?;
                write_digits(&bytes, &mut output)?;
            }
            if geometries.shapes.is_empty() {
                writer.push_start(COLLECTION, srid, &mut bytes);
                push_count(0, &mut bytes)?;
                write_digits(&bytes, &mut output)?;
            }
        }
        Encoding::Bytes => {
            let (count, is_collection) =
                (features().count(), features().any(|feature| !is_of_one_kind(feature)));
            if count == 1 && !is_collection {
                writer.push_geometry(&geometries.shapes, srid, &mut bytes)?;
            } else {
                writer.push_start(COLLECTION, srid, &mut bytes);
                push_count(count, &mut bytes)?;
                for feature in features() {
                    writer.push_geometry(feature, None, &mut bytes)?;
                    output.write_all(&bytes)?;
                    bytes.clear();
                }
            }
            output.write_all(&bytes)?;
        }
    }
    output.flush()?;
    Ok(())
}

/// Writes a polygon without rings.
pub(crate) fn write_empty_polygon(
    system: Option<&ReferenceSystem>,
    mut output: impl Write,
    encoding: Encoding,
) -> Result<(), Error> {
    let model = Model::default();
    let srid = system.and_then(ReferenceSystem::srid);
    let writer = Writer { model: &model, dimension: 2, is_extended: srid.is_some() };
    let mut bytes = Vec::new();
    writer.push_start(POLYGON, srid, &mut bytes);
    push_count(0, &mut bytes)?;
    match encoding {
        Encoding::Digits => write_digits(&bytes, &mut output)?,
        Encoding::Bytes => output.write_all(&bytes)?,
    }
    output.flush()?;
    Ok(())
}

fn write_digits(bytes: &[u8], output: &mut impl Write) -> Result<(), Error> {
    const DIGITS: &[u8; 16] = b"0123456789ABCDEF";
    let digits = |&byte: &u8| [byte >> 4, byte & 15].map(|digit| DIGITS[usize::from(digit)]);
    let mut text: Vec<u8> = bytes.iter().flat_map(digits).collect();
    text.push(b'\n');
    output.write_all(&text)?;
    Ok(())
}

fn push_count(count: usize, bytes: &mut Vec<u8>) -> Result<(), Error> {
    let count = u32::try_from(count).map_err(|_| {
        Error::new(ErrorKind::TooLarge, "a geometry has more than 2^32 - 1 parts").with_cure("divide it")
    })?;
    bytes.extend(count.to_le_bytes());
    Ok(())
}

/// The number of a geometry of one shape.
fn number_of(shape: &Shape) -> u32 {
    match shape {
        Shape::Line(_) => LINE,
        Shape::Rings(_) | Shape::Face(_) => POLYGON,
        Shape::Point(_) => POINT,
    }
}

type Named = (Shape, Option<usize>);

fn is_of_one_kind(shapes: &[Named]) -> bool {
    shapes.windows(2).all(|pair| number_of(&pair[0].0) == number_of(&pair[1].0))
}

struct Writer<'a> {
    model: &'a Model,
    dimension: usize,
    /// Whether heights are a flag of EWKB, not a number of ISO.
    is_extended: bool,
}

impl Writer<'_> {
    /// The byte order, the kind, and the reference system if it is said.
    fn push_start(&self, number: u32, srid: Option<u32>, bytes: &mut Vec<u8>) {
        let axes = match (self.dimension, self.is_extended) {
            (3, true) => HAS_Z,
            (3, false) => 1000,
            _ => 0,
        };
        let flag = if srid.is_some() { HAS_SRID } else { 0 };
        bytes.push(1);
        bytes.extend(((number + axes) | flag).to_le_bytes());
        bytes.extend(srid.into_iter().flat_map(u32::to_le_bytes));
    }

    /// One geometry of shapes: a single one, several of one kind, or a collection.
    fn push_geometry(&self, shapes: &[Named], srid: Option<u32>, bytes: &mut Vec<u8>) -> Result<(), Error> {
        if self.dimension == 3 && shapes.iter().all(|(shape, _)| matches!(shape, Shape::Face(_))) {
            self.push_start(POLYHEDRAL_SURFACE, srid, bytes);
            push_count(shapes.len(), bytes)?;
            return shapes.iter().try_for_each(|(shape, _)| {
                self.push_start(POLYGON, None, bytes);
                self.push_shape(shape, bytes)
            });
        }
        let number = number_of(&shapes[0].0);
        if !is_of_one_kind(shapes) {
            let kinds = || shapes.chunk_by(|(a, _), (b, _)| number_of(a) == number_of(b));
            self.push_start(COLLECTION, srid, bytes);
            push_count(kinds().count(), bytes)?;
            return kinds().try_for_each(|kind| self.push_geometry(kind, None, bytes));
        }
        if let [(shape, _)] = shapes {
            self.push_start(number, srid, bytes);
            return self.push_shape(shape, bytes);
        }
        self.push_start(number + MULTI, srid, bytes);
        push_count(shapes.len(), bytes)?;
        for (shape, _) in shapes {
            self.push_start(number, None, bytes);
            self.push_shape(shape, bytes)?;
        }
        Ok(())
    }

    fn push_shape(&self, shape: &Shape, bytes: &mut Vec<u8>) -> Result<(), Error> {
        match shape {
            Shape::Line(i) => self.push_path(self.model.lines.list(*i).iter().copied(), bytes),
            Shape::Rings(range) => {
                push_count(range.len(), bytes)?;
                for i in range.clone() {
                    self.push_path(self.model.lines.list(i).iter().copied(), bytes)?;
                }
                Ok(())
            }
            Shape::Face(i) => {
                push_count(1, bytes)?;
                self.push_path(closed(self.model.polygons.list(*i)), bytes)
            }
            Shape::Point(vertex) => {
                self.push_place(vertex.to_u32(), bytes);
                Ok(())
            }
        }
    }

    fn push_path(&self, path: impl Iterator<Item = u32> + Clone, bytes: &mut Vec<u8>) -> Result<(), Error> {
        push_count(path.clone().count(), bytes)?;
        path.for_each(|vertex| self.push_place(vertex, bytes));
        Ok(())
    }

    fn push_place(&self, vertex: u32, bytes: &mut Vec<u8>) {
        let positions = &self.model.positions;
        let start = vertex as usize * positions.dimension();
        for axis in 0..self.dimension {
            let is_there = axis < positions.dimension();
            let coordinate = if is_there { positions.as_flat()[start + axis] } else { 0.0 };
            bytes.extend(coordinate.to_le_bytes());
        }
    }
}
