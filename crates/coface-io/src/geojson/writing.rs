//! From a model to a stream.

use super::properties::name_in;
use crate::decimal::flush;
use crate::drawing::{
    Features, Shape, closed, features_of_shapes, push_list, push_place, shapes, written_dimension,
};
use crate::{FeatureTable, Model};
use coface_algebra::Error;
use serde::Serialize;
use serde_json::{Map, Value};
use std::borrow::Cow;
use std::io::Write;

/// How a list begins, what is between its things, and how it ends.
const LIST: [&[u8]; 3] = [b"[", b",", b"]"];

/// Something that is drawn.
struct Drawn {
    shape: Shape,
    /// The group that names it.
    group: Option<usize>,
    /// Its feature in the table of the model.
    feature: Option<usize>,
    /// Its place among the shapes of the model.
    place: usize,
}

/// Writes a `FeatureCollection`, one feature a line.
///
/// Lines become `LineString`, the rings of each polygon and the polygons of a mesh `Polygon`, points and vertices that nothing uses
/// `Point`. Three coordinates are written if a vertex lies outside the plane z = 0. Data are not kept, but `polygon`,
/// `ring` and `feature` follow from the rings.
///
/// Features of the model's [`FeatureTable`](crate::FeatureTable) are written in their order with the properties and
/// the id that they have in the file: one without shapes with the geometry null. What follows each other in a named
/// group and is in no such feature is one feature with the name as its property `name`, and of several geometries,
/// and so is what has one number in `feature`; what is in several groups has the name of the first.
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
    write_features(model, output, |drawn| properties_of(model, drawn))
}

/// The same with other properties: those of the first shape of each feature, a struct or map, or nothing.
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
    output: impl Write,
    properties: impl Fn(usize) -> P,
) -> Result<(), Error> {
    write_features(model, output, |drawn| {
        let mut properties =
            match serde_json::to_value(properties(drawn.place)).map_err(std::io::Error::from)? {
                Value::Object(properties) => properties,
                _ => Map::new(),
            };
        if let Some(group) = drawn.group {
            properties.insert("name".to_owned(), model.groups[group].name().into());
        }
        Ok(Cow::Owned(Value::Object(properties).to_string()))
    })
}

/// The same with properties that are the text of a JSON object, by the place of the first shape of each feature among
/// all.
///
/// # Errors
/// Those of [`write()`] and of `properties`.
///
/// # Examples
/// ```
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let model = coface_io::wkt::read(&b"POINT (1 2)"[..])?;
/// let mut written = Vec::new();
/// coface_io::geojson::write_with_texts(&model, &mut written, |_| Ok(r#"{"height":7}"#.to_owned()))?;
/// assert!(String::from_utf8_lossy(&written).contains(r#""properties":{"height":7}"#));
/// # Ok(()) }
/// ```
pub fn write_with_texts(
    model: &Model,
    output: impl Write,
    properties: impl Fn(usize) -> Result<String, Error>,
) -> Result<(), Error> {
    write_features(model, output, |drawn| properties(drawn.place).map(Cow::Owned))
}

/// The properties of a shape as the file has them, with the name of its group if nothing else tells it.
fn properties_of<'m>(model: &'m Model, drawn: &Drawn) -> Result<Cow<'m, str>, Error> {
    let features = model.features();
    let properties = drawn.feature.map_or("{}", |feature| features.properties(feature));
    let Some(group) = drawn.group else { return Ok(properties.into()) };
    let has_id = drawn.feature.is_some_and(|feature| features.id(feature).is_some());
    if has_id || name_in(properties).map_err(Error::parse)?.is_some() {
        return Ok(properties.into());
    }
    let name = Value::from(model.groups[group].name());
    let comma = if properties == "{}" { "" } else { "," };
    Ok(Cow::Owned(format!("{{\"name\":{name}{comma}{}", &properties[1..])))
}

fn write_features<'p>(
    model: &Model,
    mut output: impl Write,
    properties: impl Fn(&Drawn) -> Result<Cow<'p, str>, Error>,
) -> Result<(), Error> {
    let writer = Writer { model, dimension: written_dimension(model, "GeoJSON")? };
    let mut text = b"{\"type\":\"FeatureCollection\",".to_vec();
    if let Some(system) = model.reference_system() {
        text.extend_from_slice(b"\"crs\":");
        text.extend_from_slice(system.crs().as_bytes());
        text.push(b',');
    }
    text.extend_from_slice(b"\"features\":[\n");
    let mut is_first = true;
    let mut separate = |text: &mut Vec<u8>| {
        let between: &[u8] = if std::mem::take(&mut is_first) { b"" } else { b",\n" };
        text.extend_from_slice(between);
    };
    let (known, features) = (Features::new(model), model.features());
    let shapes = drawn_by_feature(model);
    let are_one = |a: &Drawn, b: &Drawn| match (a.feature, b.feature) {
        (None, None) => a.group == b.group && (a.group.is_some() || known.are_one(&a.shape, &b.shape)),
        (a, b) => a == b,
    };
    let mut next = 0..features.len();
    for feature in shapes.chunk_by(are_one) {
        // Features without shapes come before the one after them.
        for empty in next.by_ref().take_while(|&number| feature[0].feature != Some(number)) {
            separate(&mut text);
            push_start(features, Some(empty), features.properties(empty), &mut text);
            text.extend_from_slice(b"null}");
        }
        separate(&mut text);
        push_start(features, feature[0].feature, &properties(&feature[0])?, &mut text);
        writer.push_geometry(feature, &mut text);
        text.push(b'}');
        flush(&mut text, &mut output)?;
    }
    for empty in next {
        separate(&mut text);
        push_start(features, Some(empty), features.properties(empty), &mut text);
        text.extend_from_slice(b"null}");
    }
    text.extend_from_slice(b"\n]}\n");
    output.write_all(&text)?;
    output.flush()?;
    Ok(())
}

/// What a model draws: the shapes of each of its features together, in the order of these, then the others.
fn drawn_by_feature(model: &Model) -> Vec<Drawn> {
    let shapes = shapes(model);
    let features = features_of_shapes(model, &shapes);
    let mut drawn: Vec<Drawn> = shapes
        .into_iter()
        .zip(features)
        .enumerate()
        .map(|(place, ((shape, group), feature))| Drawn { shape, group, feature, place })
        .collect();
    drawn.sort_by_key(|drawn| drawn.feature.unwrap_or(usize::MAX));
    drawn
}

/// A feature up to its geometry.
fn push_start(features: &FeatureTable, feature: Option<usize>, properties: &str, text: &mut Vec<u8>) {
    text.extend_from_slice(b"{\"type\":\"Feature\",");
    if let Some(id) = feature.and_then(|feature| features.id(feature)) {
        text.extend_from_slice(b"\"id\":");
        text.extend_from_slice(id.as_bytes());
        text.push(b',');
    }
    text.extend_from_slice(b"\"properties\":");
    text.extend_from_slice(properties.as_bytes());
    text.extend_from_slice(b",\"geometry\":");
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
    fn push_geometry(&self, shapes: &[Drawn], text: &mut Vec<u8>) {
        let name = name_of(&shapes[0].shape);
        if !shapes.iter().all(|drawn| name_of(&drawn.shape) == name) {
            text.extend_from_slice(b"{\"type\":\"GeometryCollection\",\"geometries\":[");
            for (i, group) in shapes.chunk_by(|a, b| name_of(&a.shape) == name_of(&b.shape)).enumerate() {
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
            push_list(text, LIST, shapes.iter(), |drawn, text| self.push_shape(&drawn.shape, text));
        } else {
            self.push_shape(&shapes[0].shape, text);
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
            Shape::Point(vertex) => self.push_position(vertex.to_u32(), text),
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
