//! Writing PLY.

use super::Encoding;
use super::columns::{WrittenColumn, written_columns};
use crate::decimal::{flush, push_f64, push_natural};
use crate::limits::{require_dimension, require_mesh};
use crate::{GroupKind, Model};
use coface_algebra::Error;
use std::io::Write;

/// Writes a model in PLY, with coordinates in double precision that read back bit for bit.
///
/// Lines become the element `edge` (a polyline its segments), and points faces of one vertex behind the polygons. Data on
/// vertices, polygons and lines become properties, `name_0`, `name_1`, .. where a row has several numbers; points have
/// zeros there, and the segments of a polyline all that is said of it. PLY has no names of sets: groups are left out.
///
/// # Errors
/// [`UnsupportedFormat`](coface_algebra::ErrorKind::UnsupportedFormat) naming formats that serve if the model has 3-cells, no
/// positions or more than three coordinates a vertex, is an abstract structure, or has data beyond 32 bits;
/// [`InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if two properties would have one name; [`Io`](coface_algebra::ErrorKind::Io) if the
/// stream fails.
///
/// # Examples
/// ```
/// use coface_io::{obj, ply};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let triangle = obj::read("v 0 0 0\nv 1 0 0\nv 0 0.5 0\nf 1 2 3\n".as_bytes())?;
/// let mut written = Vec::new();
/// ply::write(&triangle, &mut written, ply::Encoding::BigEndian)?;
/// assert_eq!(ply::read(&written[..])?, triangle);
/// # Ok(()) }
/// ```
pub fn write(model: &Model, mut output: impl Write, encoding: Encoding) -> Result<(), Error> {
    require_mesh(model, "PLY", "MEDIT, MSH or VTK")?;
    require_dimension(model, "PLY", 3)?;
    let longest = model.polygons.iter().map(<[u32]>::len).max().unwrap_or(0);
    let columns = [
        written_columns(model, GroupKind::Vertices, &["x", "y", "z"])?,
        written_columns(model, GroupKind::Polygons, &["vertex_indices", "vertex_index"])?,
        written_columns(model, GroupKind::Lines, &["vertex1", "vertex2"])?,
    ];
    let mut body = Body { text: header(model, encoding, longest, &columns), encoding };
    let [of_vertices, of_polygons, of_lines] = &columns;
    for (row, point) in model.coordinates().chunks_exact(model.coordinate_count().max(1)).enumerate() {
        for (i, &value) in point.iter().enumerate() {
            body.coordinate(value, i == 0);
        }
        body.data(of_vertices, Some(row));
        body.end_record();
        flush(&mut body.text, &mut output)?;
    }
    for (row, polygon) in model.polygons.iter().enumerate() {
        body.face(polygon, longest);
        body.data(of_polygons, Some(row));
        body.end_record();
        flush(&mut body.text, &mut output)?;
    }
    for point in &model.points {
        body.face(&[point.to_u32()], longest);
        body.data(of_polygons, None);
        body.end_record();
        flush(&mut body.text, &mut output)?;
    }
    for (row, line) in model.lines.iter().enumerate() {
        for edge in line.windows(2) {
            body.index(edge[0], true);
            body.index(edge[1], false);
            body.data(of_lines, Some(row));
            body.end_record();
            flush(&mut body.text, &mut output)?;
        }
    }
    output.write_all(&body.text)?;
    output.flush()?;
    Ok(())
}

/// The header; columns are those of vertices, polygons and lines.
fn header(
    model: &Model,
    encoding: Encoding,
    longest: usize,
    columns: &[Vec<WrittenColumn<'_>>; 3],
) -> Vec<u8> {
    let properties = |columns: &[WrittenColumn<'_>]| -> String {
        columns.iter().map(|column| format!("property {} {}\n", column.type_name, column.name)).collect()
    };
    let format = match encoding {
        Encoding::Ascii => "ascii",
        Encoding::LittleEndian => "binary_little_endian",
        Encoding::BigEndian => "binary_big_endian",
    };
    let index = if model.vertex_count > i32::MAX as usize { "uint" } else { "int" };
    let mut header = format!("ply\nformat {format} 1.0\nelement vertex {}\n", model.vertex_count);
    for axis in ["x", "y", "z"].iter().take(model.coordinate_count()) {
        header += &format!("property double {axis}\n");
    }
    header += &properties(&columns[0]);
    let count = if longest > u8::MAX.into() { "uint" } else { "uchar" };
    let faces = model.polygons.len() + model.points.len();
    header += &format!("element face {faces}\nproperty list {count} {index} vertex_indices\n");
    header += &properties(&columns[1]);
    let segments = model.lines.item_count() - model.lines.len();
    if segments > 0 {
        header += &format!("element edge {segments}\nproperty {index} vertex1\nproperty {index} vertex2\n");
        header += &properties(&columns[2]);
    }
    header += "end_header\n";
    header.into_bytes()
}

/// The data behind the header, on their way out.
struct Body {
    text: Vec<u8>,
    encoding: Encoding,
}

impl Body {
    fn coordinate(&mut self, value: f64, first: bool) {
        match self.encoding {
            Encoding::Ascii => {
                self.separate(first);
                push_f64(&mut self.text, value);
            }
            Encoding::LittleEndian => self.text.extend_from_slice(&value.to_le_bytes()),
            Encoding::BigEndian => self.text.extend_from_slice(&value.to_be_bytes()),
        }
    }

    fn index(&mut self, value: u32, first: bool) {
        match self.encoding {
            Encoding::Ascii => {
                self.separate(first);
                push_natural(&mut self.text, value.into());
            }
            Encoding::LittleEndian => self.text.extend_from_slice(&value.to_le_bytes()),
            Encoding::BigEndian => self.text.extend_from_slice(&value.to_be_bytes()),
        }
    }

    fn face(&mut self, vertices: &[u32], longest: usize) {
        let count = vertices.len() as u32;
        match u8::try_from(count) {
            Ok(count) if self.encoding != Encoding::Ascii && longest <= u8::MAX.into() => {
                self.text.push(count);
            }
            _ => self.index(count, true),
        }
        for &vertex in vertices {
            self.index(vertex, false);
        }
    }

    /// The data of one row, or zeros.
    fn data(&mut self, columns: &[WrittenColumn<'_>], row: Option<usize>) {
        for column in columns {
            match (self.encoding, row) {
                (Encoding::Ascii, row) => {
                    self.text.push(b' ');
                    match row {
                        Some(row) => column.write_word(row, &mut self.text),
                        None => self.text.push(b'0'),
                    }
                }
                (encoding, Some(row)) => {
                    column.write_bytes(row, encoding == Encoding::BigEndian, &mut self.text);
                }
                (_, None) => self.text.resize(self.text.len() + column.size(), 0),
            }
        }
    }

    fn separate(&mut self, first: bool) {
        if !first {
            self.text.push(b' ');
        }
    }

    fn end_record(&mut self) {
        if self.encoding == Encoding::Ascii {
            self.text.push(b'\n');
        }
    }
}
