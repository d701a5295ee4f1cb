//! From a model to a stream.

use crate::Model;
use crate::decimal::flush;
use crate::drawing::{Features, Shape, closed, push_list, push_place, shapes, written_dimension};
use coface_algebra::Error;
use serde::Serialize;
use serde_json::{Map, Value};
use std::io::Write;

/// How a list begins, what is between its things, and how it ends.
const LIST: [&[u8]; 3] = [b"[", b",", b"]"];

/// Writes a `FeatureCollection`, one feature a line.
///
/// Lines become `LineString`, the rings of each polygon and the polygons of a mesh `Polygon`, points and vertices that nothing uses
/// `Point`. What follows each other in a named group is one feature with that name, and of several geometries, and so is what has one
/// number in `feature`; what is in several groups has the name of the first. Three coordinates are written if a vertex lies outside the plane z = 0.
/// Data are not kept, but `polygon`, `ring` and `feature` follow from the rings.
///
/// # Errors
/// [`ErrorKind::UnsupportedFormat`](coface_algebra::ErrorKind::UnsupportedFormat) if the model has 3-cells, no positions or more than three
/// coordinates a vertex, or is an abstract structure; [`ErrorKind::Io`](coface_algebra::ErrorKind::Io) if the stream fails.
///
/// # Examples
/// ```
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let model = coface_io::wkt::read(&b"POINT (1 2)"[..])?;
/// let mut written = Vec::new();
/// coface_io::geojson::write(&model, &mut written)?;
/// let line = r#"{"type":"Feature","properties":{},"geometry":{"type":"Point","coordinates":[1,2]}}"#;
/// assert!(String::from_utf8_lossy(&written).contains(line));
/// assert_eq!(coface_io::geojson::read(&written[..])?, model);
/// # Ok(()) }
/// ```
pub fn write(model: &Model, output: impl Write) -> Result<(), Error> {
    write_with(model, output, |_| ())
}

/// The same with more properties: those of the first shape of each feature, a struct or map, or nothing.
///
/// # Errors
/// Those of [`write()`], and [`ErrorKind::Io`](coface_algebra::ErrorKind::Io) if properties cannot be written as JSON.
///
/// # Examples
/// ```
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let model = coface_io::wkt::read(&b"POINT (1 2)"[..])?;
/// let mut written = Vec::new();
/// let height = |shape: usize| std::collections::BTreeMap::from([("height", shape + 7)]);
/// coface_io::geojson::write_with(&model, &mut written, height)?;
/// assert!(String::from_utf8_lossy(&written).contains(r#""properties":{"height":7}"#));
/// # Ok(()) }
/// ```
pub fn write_with<P: Serialize>(
    model: &Model,
    mut output: impl Write,
    properties: impl Fn(usize) -> P,
) -> Result<(), Error> {
    let writer = Writer { model, dimension: written_dimension(model, "GeoJSON")? };
    let shapes = shapes(model);
    let mut text = b"{\"type\":\"FeatureCollection\",\"features\":[\n".to_vec();
    let known = Features::new(model);
    let features = shapes.chunk_by(|(x, a), (y, b)| a == b && (a.is_some() || known.are_one(x, y)));
    let mut shape = 0;
    for (i, feature) in features.enumerate() {
        if i > 0 {
            text.extend_from_slice(b",\n");
        }
        let mut properties = match serde_json::to_value(properties(shape)).map_err(std::io::Error::from)? {
            Value::Object(properties) => properties,
            _ => Map::new(),
        };
        shape += feature.len();
        if let Some(group) = feature[0].1 {
            properties.insert("name".to_owned(), model.groups[group].name().into());
        }
        text.extend_from_slice(b"{\"type\":\"Feature\",\"properties\":");
        serde_json::to_writer(&mut text, &properties).map_err(std::io::Error::from)?;
        text.extend_from_slice(b",\"geometry\":");
        writer.push_geometry(feature, &mut text);
        text.push(b'}');
        flush(&mut text, &mut output)?;
    }
    text.extend_from_slice(b"\n]}\n");
    output.write_all(&text)?;
    output.flush()?;
    Ok(())
}

/// The type of a geometry of one shape.
fn name_of(shape: &Shape) -> &'static str {
    match shape {
        Shape::Line(_) => "LineString",
        Shape::Rings(_) | Shape::Face(_) => "Polygon",
        Shape::Point(_) => "Point",
    }
}

struct Writer<'a> {
    model: &'a Model,
    dimension: usize,
}

impl Writer<'_> {
    /// One geometry of shapes: a single one, several of one type, or a collection.
    fn push_geometry(&self, shapes: &[(Shape, Option<usize>)], text: &mut Vec<u8>) {
        let name = name_of(&shapes[0].0);
        if !shapes.iter().all(|(shape, _)| name_of(shape) == name) {
            text.extend_from_slice(b"{\"type\":\"GeometryCollection\",\"geometries\":[");
            for (i, group) in shapes.chunk_by(|(a, _), (b, _)| name_of(a) == name_of(b)).enumerate() {
                if i > 0 {
                    text.push(b',');
                }
                self.push_geometry(group, text);
            }
            text.extend_from_slice(b"]}");
            return;
        }
        let many = shapes.len() > 1;
        text.extend_from_slice(b"{\"type\":\"");
        text.extend_from_slice(if many { b"Multi" } else { b"" });
        text.extend_from_slice(name.as_bytes());
        text.extend_from_slice(b"\",\"coordinates\":");
        if many {
            push_list(text, LIST, shapes.iter(), |(shape, _), text| self.push_shape(shape, text));
        } else {
            self.push_shape(&shapes[0].0, text);
        }
        text.push(b'}');
    }

    fn push_shape(&self, shape: &Shape, text: &mut Vec<u8>) {
        match shape {
            Shape::Line(i) => self.push_path(self.model.lines.list(*i).iter().copied(), text),
            Shape::Rings(range) => push_list(text, LIST, range.clone(), |i, text| {
                self.push_path(self.model.lines.list(i).iter().copied(), text);
            }),
            Shape::Face(i) => {
                text.push(b'[');
                self.push_path(closed(self.model.polygons.list(*i)), text);
                text.push(b']');
            }
            Shape::Point(vertex) => self.push_position(*vertex, text),
        }
    }

    fn push_path(&self, path: impl Iterator<Item = u32>, text: &mut Vec<u8>) {
        push_list(text, LIST, path, |vertex, text| self.push_position(vertex, text));
    }

    fn push_position(&self, vertex: u32, text: &mut Vec<u8>) {
        text.push(b'[');
        push_place(self.model, vertex, self.dimension, b',', text);
        text.push(b']');
    }
}
