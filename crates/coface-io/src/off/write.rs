//! Writing OFF.

use crate::Model;
use crate::decimal::{flush, push_f64, push_natural};
use crate::limits::require_mesh;
use coface_algebra::Error;
use std::io::Write;

/// Writes a model in OFF: `OFF` in dimension 3, `4OFF` in dimension 4, `nOFF` in others.
///
/// Coordinates are written so that they read back bit for bit. Lines become faces of two vertices (a polyline its
/// segments) and points faces of one, behind the polygons. OFF has no names: groups are left out.
///
/// # Errors
/// [`ErrorKind::UnsupportedFormat`](coface_algebra::ErrorKind::UnsupportedFormat) naming formats that serve if the model has 3-cells, no positions, or is an abstract
/// structure; [`ErrorKind::Io`](coface_algebra::ErrorKind::Io) if the stream fails.
///
/// # Examples
/// ```
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let text = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 0.5 0\n3 0 1 2\n";
/// let triangle = coface_io::off::read(text.as_bytes())?;
/// let mut written = Vec::new();
/// coface_io::off::write(&triangle, &mut written)?;
/// assert_eq!(written, text.as_bytes());
/// # Ok(()) }
/// ```
pub fn write(model: &Model, mut output: impl Write) -> Result<(), Error> {
    require_mesh(model, "OFF", "MEDIT, MSH or VTK")?;
    let mut text = Vec::new();
    let dimension = model.coordinate_count();
    match dimension {
        0 | 3 => text.extend_from_slice(b"OFF\n"),
        4 => text.extend_from_slice(b"4OFF\n"),
        _ => text.extend_from_slice(format!("nOFF\n{dimension}\n").as_bytes()),
    }
    let segments = model.lines.item_count() - model.lines.len();
    let faces = model.polygons.len() + segments + model.points.len();
    text.extend_from_slice(format!("{} {faces} 0\n", model.vertex_count).as_bytes());
    for point in model.coordinates().chunks_exact(dimension.max(1)) {
        for (i, &value) in point.iter().enumerate() {
            if i > 0 {
                text.push(b' ');
            }
            push_f64(&mut text, value);
        }
        text.push(b'\n');
        flush(&mut text, &mut output)?;
    }
    for face in model.polygons.iter().chain(model.lines.iter().flat_map(|line| line.windows(2))) {
        push_face(&mut text, face);
        flush(&mut text, &mut output)?;
    }
    for point in &model.points {
        push_face(&mut text, &[point.to_u32()]);
        flush(&mut text, &mut output)?;
    }
    output.write_all(&text)?;
    output.flush()?;
    Ok(())
}

fn push_face(text: &mut Vec<u8>, face: &[u32]) {
    push_natural(text, face.len() as u64);
    for &vertex in face {
        text.push(b' ');
        push_natural(text, u64::from(vertex));
    }
    text.push(b'\n');
}
