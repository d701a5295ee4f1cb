//! Writing PLY.

use super::Encoding;
use crate::Error;
use crate::io::Model;
use crate::io::decimal::{flush, push_f64, push_natural};
use crate::io::limits::{require_dimension, require_mesh};
use std::io::Write;

/// Writes a model in PLY, with coordinates in double precision that read back bit for bit.
///
/// Lines become the element `edge` (a polyline its segments), and points faces of one vertex behind the polygons. PLY
/// has no names: groups are left out.
///
/// # Errors
/// [`UnsupportedFormat`](crate::ErrorKind::UnsupportedFormat) naming formats that serve if the model has 3-cells, no
/// positions or more than three coordinates a vertex, or is an abstract structure; [`Io`](crate::ErrorKind::Io) if the
/// stream fails.
///
/// # Examples
/// ```
/// use coface::io::{obj, ply};
/// # fn main() -> Result<(), coface::Error> {
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
    let mut body = Body { text: header(model, encoding, longest), encoding };
    for point in model.positions.as_flat().chunks_exact(model.positions.dimension().max(1)) {
        for (i, &value) in point.iter().enumerate() {
            body.coordinate(value, i == 0);
        }
        body.end_record();
        flush(&mut body.text, &mut output)?;
    }
    let points = model.points.iter().map(|point| [point.to_u32()]);
    for polygon in model.polygons.iter() {
        body.face(polygon, longest);
        flush(&mut body.text, &mut output)?;
    }
    for point in points {
        body.face(&point, longest);
        flush(&mut body.text, &mut output)?;
    }
    for edge in model.lines.iter().flat_map(|line| line.windows(2)) {
        body.index(edge[0], true);
        body.index(edge[1], false);
        body.end_record();
        flush(&mut body.text, &mut output)?;
    }
    output.write_all(&body.text)?;
    output.flush()?;
    Ok(())
}

fn header(model: &Model, encoding: Encoding, longest: usize) -> Vec<u8> {
    let format = match encoding {
        Encoding::Ascii => "ascii",
        Encoding::LittleEndian => "binary_little_endian",
        Encoding::BigEndian => "binary_big_endian",
    };
    let index = if model.vertex_count > i32::MAX as usize { "uint" } else { "int" };
    let mut header = format!("ply\nformat {format} 1.0\nelement vertex {}\n", model.vertex_count);
    for axis in ["x", "y", "z"].iter().take(model.positions.dimension()) {
        header += &format!("property double {axis}\n");
    }
    let count = if longest > u8::MAX.into() { "uint" } else { "uchar" };
    let faces = model.polygons.len() + model.points.len();
    header += &format!("element face {faces}\nproperty list {count} {index} vertex_indices\n");
    let segments = model.lines.item_count() - model.lines.len();
    if segments > 0 {
        header += &format!("element edge {segments}\nproperty {index} vertex1\nproperty {index} vertex2\n");
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
        self.end_record();
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
