//! From a model to a stream.

use crate::decimal::{flush, push_f64};
use crate::drawing::{Shape, closed, push_place, shapes, written_dimension};
use crate::{Format, GroupKind, Model};
use coface_algebra::Error;
use coface_algebra::{ErrorKind, VertexId};
use std::io::Write;

/// Writes a drawing: polygons, with holes, as filled paths; lines as polylines; points as lines without length.
///
/// Coordinates are written as they are. Browsers show the second axis pointing up, by a style that readers of shapes pass
/// over, unless the model was read from SVG. Rings keep the rule that `fill_rule` gives them, and have the even-odd rule without
/// one, so holes may run in either direction. Names and other data are not kept.
///
/// # Errors
/// [`ErrorKind::UnsupportedFormat`] if the model has 3-cells or no positions, is an abstract structure or does not lie in
/// the plane z = 0; [`ErrorKind::Io`] if the stream fails.
///
/// # Examples
/// ```
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let model = coface_io::wkt::read(&b"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"[..])?;
/// let mut written = Vec::new();
/// coface_io::svg::write(&model, &mut written)?;
/// assert!(String::from_utf8_lossy(&written).contains("<path d=\"M0 0L2 0L2 2L0 2Z\"/>"));
/// assert_eq!(coface_io::svg::read(&written[..])?.lines(), model.lines());
/// # Ok(()) }
/// ```
pub fn write(model: &Model, mut output: impl Write) -> Result<(), Error> {
    if written_dimension(model, "SVG")? > 2 {
        let message = "SVG cannot hold points outside the plane z = 0";
        return Err(Error::new(ErrorKind::UnsupportedFormat, message).with_cure("write OBJ, GeoJSON or WKT"));
    }
    let mut text = b"<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"".to_vec();
    let (low, size) = frame(model);
    let margin = 0.02 * size[0].max(size[1]);
    for (i, number) in [low[0] - margin, low[1] - margin, size[0] + 2.0 * margin, size[1] + 2.0 * margin]
        .into_iter()
        .enumerate()
    {
        if i > 0 {
            text.push(b' ');
        }
        push_f64(&mut text, number);
    }
    text.extend_from_slice(
        b"\" fill=\"#9ac\" fill-opacity=\"0.6\" stroke=\"#246\" stroke-linejoin=\"round\" stroke-width=\"",
    );
    push_f64(&mut text, (0.002 * size[0].max(size[1])).max(f64::MIN_POSITIVE));
    text.extend_from_slice(b"\"");
    if model.format() != Some(Format::Svg) {
        text.extend_from_slice(b" style=\"transform:scaleY(-1)\"");
    }
    text.extend_from_slice(b">\n");
    let rules = model.data_named("fill_rule", GroupKind::Lines);
    for (shape, _) in shapes(model) {
        match shape {
            Shape::Line(i) => {
                text.extend_from_slice(b"<polyline fill=\"none\" points=\"");
                push_corners(model, model.lines.list(i).iter().copied(), b",", b" ", &mut text);
            }
            Shape::Rings(range) => {
                let rule = rules.and_then(|rules| rules.integer_row(range.start)).map(|row| row[0]);
                text.extend_from_slice(b"<path ");
                if rule != Some(0) && range.len() > 1 || rule == Some(1) {
                    text.extend_from_slice(b"fill-rule=\"evenodd\" ");
                }
                text.extend_from_slice(b"d=\"");
                for i in range {
                    let ring = model.lines.list(i);
                    text.push(b'M');
                    push_corners(model, ring[..ring.len() - 1].iter().copied(), b" ", b"L", &mut text);
                    text.push(b'Z');
                }
            }
            Shape::Face(i) => {
                let ring = model.polygons.list(i);
                text.extend_from_slice(b"<path d=\"M");
                push_corners(model, closed(ring).take(ring.len()), b" ", b"L", &mut text);
                text.push(b'Z');
            }
            Shape::Point(vertex) => {
                text.extend_from_slice(b"<polyline stroke-linecap=\"round\" points=\"");
                push_corners(model, [vertex.to_u32(); 2].into_iter(), b",", b" ", &mut text);
            }
        }
        text.extend_from_slice(b"\"/>\n");
        flush(&mut text, &mut output)?;
    }
    text.extend_from_slice(b"</svg>\n");
    output.write_all(&text)?;
    output.flush()?;
    Ok(())
}

fn push_corners(
    model: &Model,
    corners: impl Iterator<Item = u32>,
    between: &[u8; 1],
    behind: &[u8],
    text: &mut Vec<u8>,
) {
    for (i, vertex) in corners.enumerate() {
        if i > 0 {
            text.extend_from_slice(behind);
        }
        push_place(model, vertex, 2, between[0], text);
    }
}

/// The lower corner and the size of the box around all vertices; a unit box if there is none. What has no second coordinate is at 0.
fn frame(model: &Model) -> ([f64; 2], [f64; 2]) {
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for vertex in 0..model.vertex_count() {
        let point = model.positions().point(VertexId::new(vertex));
        for axis in 0..2 {
            let coordinate = point.get(axis).copied().unwrap_or(0.0);
            (low[axis], high[axis]) = (low[axis].min(coordinate), high[axis].max(coordinate));
        }
    }
    let size = [0, 1].map(|axis| high[axis] - low[axis]);
    let largest = size[0].max(size[1]);
    if !largest.is_finite() || largest <= 0.0 {
        let low = if low[0].is_finite() && low[1].is_finite() { low } else { [0.0; 2] };
        return (low, [1.0; 2]);
    }
    (low, size)
}
