//! From a stream to a model.

use super::coordinates::{Coordinates, Nested};
use super::properties::Description;
use super::topology::Topology;
use crate::drawing::Drawing;
use crate::json::Faults;
use crate::{Model, ReferenceSystem};
use coface_algebra::Error;
use serde::de::{DeserializeSeed, Deserializer, IgnoredAny, MapAccess, SeqAccess, Visitor};
use serde_json::error::Category;
use serde_json::value::RawValue;
use std::fmt;
use std::io::{BufRead, BufReader, Read};

/// What stands before each record of a text sequence.
const SEPARATOR: u8 = 0x1E;
const CURE: &str = "the file must be GeoJSON (RFC 7946)";
/// The types of geometries with coordinates, and how deep the lists of these are.
const LEVELS: [(&str, usize); 6] = [
    ("Point", 1),
    ("MultiPoint", 2),
    ("LineString", 2),
    ("MultiLineString", 3),
    ("Polygon", 3),
    ("MultiPolygon", 4),
];
const OTHERS: [&str; 4] = ["GeometryCollection", "Feature", "FeatureCollection", "Topology"];

/// Reads a drawing or map, GeoJSON or TopoJSON: see [what becomes of what](crate::geojson). Several texts that follow each other, such as a
/// feature a line, or the records of a text sequence, are one drawing.
///
/// A line whose positions are all equal is kept as a point; heights that are missing beside others are 0; both with a
/// warning.
///
/// # Errors
/// [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) for what is no GeoJSON; [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for
/// a ring that is not closed; both with the line, and in a text sequence the number of the record. [`ErrorKind::TooLarge`](coface_algebra::ErrorKind::TooLarge) beyond 2^32 - 2 corners.
///
/// # Complexity
/// $O(n \log n)$ for n positions, to find equal ones; memory is the model and the largest geometry.
///
/// # References
/// H. Butler et al., *The GeoJSON Format*, RFC 7946 (2016); S. Gillies, *GeoJSON Text Sequences*, RFC 8142 (2017).
///
/// # Examples
/// ```
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let text = r#"{"type": "Feature", "properties": {"name": "bridge"},
///     "geometry": {"type": "LineString", "coordinates": [[0, 0], [1, 0], [1, 2]]}}"#;
/// let model = coface_io::geojson::read(text.as_bytes())?;
/// assert_eq!(model.lines().list(0), [0, 1, 2]);
/// assert_eq!(model.groups()[0].name(), "bridge");
/// # Ok(()) }
/// ```
pub fn read(input: impl Read) -> Result<Model, Error> {
    let mut input = BufReader::with_capacity(1 << 16, input);
    let (mut drawing, faults) = (Drawing::default(), Faults::default());
    let is_sequence = loop {
        match input.fill_buf() {
            // White space may come before the first separator.
            Ok(start) => break start.trim_ascii_start().first() == Some(&SEPARATOR),
            Err(error) if error.kind() == std::io::ErrorKind::Interrupted => {}
            Err(error) => return Err(error.into()),
        }
    };
    if is_sequence {
        draw_records(input, &mut drawing, &faults)?;
    } else {
        draw_texts(input, &mut drawing, &faults).map_err(|error| located(error, 0, faults.take()))?;
    }
    drawing.finish()
}

/// Draws all texts of JSON that follow each other, such as a feature a line.
fn draw_texts(input: impl Read, drawing: &mut Drawing, faults: &Faults) -> Result<(), serde_json::Error> {
    let mut deserializer = serde_json::Deserializer::from_reader(input);
    loop {
        Root(&mut Sink { drawing, faults }).deserialize(&mut deserializer)?;
        if deserializer.end().is_ok() {
            return Ok(());
        }
    }
}

/// Draws the records of a text sequence (RFC 8142). Empty ones, of separators that follow each other, are passed over.
fn draw_records(mut input: impl BufRead, drawing: &mut Drawing, faults: &Faults) -> Result<(), Error> {
    let (mut record, mut number, mut lines_before) = (Vec::new(), 0u64, 0);
    loop {
        record.clear();
        if input.read_until(SEPARATOR, &mut record)? == 0 {
            break;
        }
        let is_last = record.pop_if(|last| *last == SEPARATOR).is_none();
        let text = record.trim_ascii_end();
        if !text.is_empty() {
            number += 1;
            draw_texts(text, drawing, faults).map_err(|error| {
                let is_cut = error.is_eof();
                let error = located(error, lines_before, faults.take());
                let line = error.line().unwrap_or(lines_before + 1);
                if is_cut {
                    let what = if is_last { "the file ends" } else { "the next one begins" };
                    let message = format!("record {number} is cut off: {what} within it");
                    return Error::parse(message)
                        .at_line(line)
                        .with_cure("write the record again, or take it out with the byte 0x1E before it");
                }
                let message = format!("record {number}: {}", error.message());
                let cure = error.cure().unwrap_or(CURE);
                Error::new(error.kind(), message).at_line(line).with_cure(cure)
            })?;
        }
        lines_before += record.iter().filter(|&&byte| byte == b'\n').count() as u64;
    }
    if number == 0 {
        return Err(Error::parse("the text sequence has no record").with_cure(CURE));
    }
    Ok(())
}

/// The start of a file without the white space and the separators of records before the first one.
pub(crate) fn first_record(start: &[u8]) -> &[u8] {
    let is_before = |byte: &u8| *byte == SEPARATOR || byte.is_ascii_whitespace();
    let before = start.iter().take_while(|byte| is_before(byte)).count();
    &start[before..]
}

/// Whether the start of a file has a type of GeoJSON, or is a list of lists of lists.
pub(crate) fn is_geojson(start: &[u8]) -> bool {
    let start = first_record(start);
    let mut brackets = start.iter().filter(|byte| !byte.is_ascii_whitespace());
    if brackets.by_ref().take(3).eq(b"[[[") {
        return !has_facets(start);
    }
    if start.first() != Some(&b'{') {
        return false;
    }
    memchr::memmem::find_iter(start, b"\"type\"").any(|at| {
        let value = start[at + 6..].trim_ascii_start();
        let Some(value) = value.strip_prefix(b":").map(<[u8]>::trim_ascii_start) else { return false };
        let Some(value) = value.strip_prefix(b"\"") else { return false };
        let names = LEVELS.iter().map(|&(name, _)| name).chain(OTHERS);
        names
            .into_iter()
            .any(|name| value.strip_prefix(name.as_bytes()).is_some_and(|rest| rest.starts_with(b"\"")))
    })
}

/// Whether the innermost lists of nested lists are facets rather than points: distinct whole numbers from 0 in each, three or more in
/// one of them, and no list within a list of them.
fn has_facets(start: &[u8]) -> bool {
    let (mut depth, mut has_long) = (0, false);
    let mut numbers: Vec<&[u8]> = Vec::new();
    let mut rest = start;
    while let Some((&byte, behind)) = rest.split_first() {
        rest = behind;
        match byte {
            b'[' if depth == 3 => return false,
            b'[' => {
                depth += 1;
                numbers.clear();
            }
            b']' => {
                numbers.sort_unstable();
                if numbers.windows(2).any(|pair| pair[0] == pair[1]) {
                    return false;
                }
                has_long |= depth == 3 && numbers.len() > 2;
                numbers.clear();
                let Some(less) = usize::checked_sub(depth, 1) else { return has_long };
                depth = less;
            }
            b'0'..=b'9' => {
                let length = behind.iter().take_while(|byte| byte.is_ascii_digit()).count();
                let (number, after) = behind.split_at(length);
                if after.is_empty() {
                    // The start that is looked at ends within it.
                    return has_long;
                }
                if number.len() > 9 || matches!(after.first(), Some(b'.' | b'e' | b'E')) {
                    return false;
                }
                // With its first digit.
                let at = start.len() - rest.len() - 1;
                numbers.push(&start[at..at + 1 + length]);
                rest = after;
            }
            b',' => {}
            // Coordinates hold no objects.
            b'{' => return true,
            byte if byte.is_ascii_whitespace() => {}
            _ => return false,
        }
    }
    has_long
}

/// The fault that was raised, or the parser's own, with the line; so many lines come before those that the parser counts.
fn located(error: serde_json::Error, lines_before: u64, fault: Option<Error>) -> Error {
    let (column, category) = (error.column(), error.classify());
    let line = lines_before + error.line() as u64;
    if let Some(fault) = fault {
        return fault.at_line(line);
    }
    if category == Category::Io {
        return std::io::Error::from(error).into();
    }
    let text = error.to_string();
    let place = format!(" at line {} column {column}", error.line());
    let text = shortened(text.strip_suffix(&place).unwrap_or(&text));
    Error::parse(format!("{text} (column {column})")).at_line(line).with_cure(match category {
        Category::Eof => "the file was cut short: write it again",
        _ => CURE,
    })
}

/// A text from the file, safe and short enough for an error message.
fn shortened(text: &str) -> String {
    let start: String = text.chars().take(200).collect();
    let dots = if start.len() < text.len() { "..." } else { "" };
    let safe: String = start.chars().map(|c| if c.is_control() { '?' } else { c }).collect();
    format!("{safe}{dots}")
}

/// Where geometries go.
struct Sink<'a> {
    drawing: &'a mut Drawing,
    faults: &'a Faults,
}

/// What an object holds, whatever its type and the order of its keys.
#[derive(Default)]
struct Object {
    kind: Option<String>,
    coordinates: Option<Coordinates>,
    geometries: Vec<Object>,
    /// What stands under `"geometry"`, unless that is null.
    geometry: Option<Box<Object>>,
    has_features: bool,
    topology: Topology,
    description: Description,
}

impl Object {
    /// Draws a feature or a geometry; the features of a collection have been drawn as they were read.
    fn draw(self, drawing: &mut Drawing) -> Result<(), Error> {
        let kind = self.kind.as_deref().unwrap_or_default();
        if self.has_features && kind != "FeatureCollection" {
            return Err(
                Error::parse("an object has \"features\", but is no FeatureCollection").with_cure(CURE)
            );
        }
        match kind {
            "FeatureCollection" => Ok(()),
            "Topology" => self.topology.draw(drawing),
            "Feature" => {
                self.description.begin(drawing);
                let drawn = self.geometry.map_or(Ok(()), |geometry| geometry.draw_geometry(drawing));
                drawing.begin_feature(None);
                drawn
            }
            _ => self.draw_geometry(drawing),
        }
    }

    fn draw_geometry(self, drawing: &mut Drawing) -> Result<(), Error> {
        let Some(kind) = self.kind else {
            return Err(Error::parse("an object has no \"type\"").with_cure(CURE));
        };
        if kind == "GeometryCollection" {
            return self.geometries.into_iter().try_for_each(|geometry| geometry.draw_geometry(drawing));
        }
        let Some(&(name, level)) = LEVELS.iter().find(|(name, _)| *name == kind) else {
            let fault = Error::parse(format!("\"{}\" is not a type of geometry", shortened(&kind)));
            return Err(fault.with_cure(CURE));
        };
        let Some(coordinates) = self.coordinates else {
            return Err(Error::parse(format!("a {name} has no \"coordinates\"")).with_cure(CURE));
        };
        draw(name, level, &coordinates, false, drawing)
    }
}

/// Draws a geometry whose coordinates must have this level; rings of bare ones are closed.
fn draw(
    name: &str,
    level: usize,
    coordinates: &Coordinates,
    is_bare: bool,
    drawing: &mut Drawing,
) -> Result<(), Error> {
    let Some(found) = coordinates.level() else { return Ok(()) };
    if found != level {
        let what = match found {
            0 => "a number",
            1 => "a position",
            2 => "a list of positions",
            3 => "a list of lists of positions",
            _ => "lists nested too deep",
        };
        let message = format!("the coordinates of a {name} are {what}");
        let brackets = ["", "[0, 0]", "[[0, 0], [1, 0]]", "[[[0, 0], [1, 0]]]", "[[[[0, 0], [1, 0]]]]"];
        return Err(Error::parse(message).with_cure(format!("write them as in {}", brackets[level])));
    }
    match name {
        "Point" | "MultiPoint" => coordinates.draw_points(drawing),
        "LineString" | "MultiLineString" => coordinates.draw_lines(drawing, &format!("a {name}")),
        _ => coordinates.draw_polygons(drawing, &format!("a {name}"), is_bare)?,
    }
    Ok(())
}

/// The whole file.
struct Root<'a, 'b>(&'a mut Sink<'b>);

impl<'de> DeserializeSeed<'de> for Root<'_, '_> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<(), D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Root<'_, '_> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("an object")
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<(), A::Error> {
        Drawn(self.0).visit_map(map)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<(), A::Error> {
        let coordinates = Nested::of_list(list)?;
        let name = if coordinates.level() == Some(4) { "MultiPolygon" } else { "Polygon" };
        let level = if coordinates.level() == Some(4) { 4 } else { 3 };
        draw(name, level, &coordinates, true, self.0.drawing).map_err(|fault| self.0.faults.raise(fault))
    }
}

/// An object that is drawn as soon as it has been read.
struct Drawn<'a, 'b>(&'a mut Sink<'b>);

impl<'de> DeserializeSeed<'de> for Drawn<'_, '_> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<(), D::Error> {
        deserializer.deserialize_map(self)
    }
}

impl<'de> Visitor<'de> for Drawn<'_, '_> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a feature or geometry, an object")
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<(), A::Error> {
        let object = Parsed(&mut *self.0).visit_map(map)?;
        object.draw(self.0.drawing).map_err(|fault| self.0.faults.raise(fault))
    }
}

/// An object that is kept, since its keys come in any order.
struct Parsed<'a, 'b>(&'a mut Sink<'b>);

impl<'de> DeserializeSeed<'de> for Parsed<'_, '_> {
    type Value = Object;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Object, D::Error> {
        deserializer.deserialize_map(self)
    }
}

impl<'de> Visitor<'de> for Parsed<'_, '_> {
    type Value = Object;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("an object")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Object, A::Error> {
        let mut object = Object::default();
        while let Some(key) = map.next_key::<String>()? {
            match key.as_str() {
                "type" => object.kind = Some(map.next_value()?),
                "coordinates" => object.coordinates = Some(map.next_value_seed(Nested)?),
                "geometry" => object.geometry = map.next_value_seed(Geometry(&mut *self.0))?,
                "geometries" => map.next_value_seed(Geometries(&mut *self.0, &mut object.geometries))?,
                "features" => {
                    object.has_features = true;
                    map.next_value_seed(Features(&mut *self.0))?;
                }
                "properties" => {
                    let properties = map.next_value::<Box<RawValue>>()?;
                    let set = object.description.set_properties(&properties);
                    set.map_err(serde::de::Error::custom)?;
                }
                "objects" => object.topology.objects = Some(map.next_value()?),
                "arcs" => object.topology.arcs = Some(map.next_value()?),
                "transform" => object.topology.transform = Some(map.next_value()?),
                "crs" => {
                    let system = map.next_value::<Box<RawValue>>()?;
                    let system = ReferenceSystem::from_crs(system.get())
                        .map_err(|fault| self.0.faults.raise(fault))?;
                    if system.is_some() {
                        self.0.drawing.set_reference(system).map_err(|fault| self.0.faults.raise(fault))?;
                    }
                }
                "id" => object.description.set_id(&map.next_value::<Box<RawValue>>()?),
                _ => {
                    map.next_value::<IgnoredAny>()?;
                }
            }
        }
        Ok(object)
    }
}

/// A geometry or null.
struct Geometry<'a, 'b>(&'a mut Sink<'b>);

impl<'de> DeserializeSeed<'de> for Geometry<'_, '_> {
    type Value = Option<Box<Object>>;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Self::Value, D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Geometry<'_, '_> {
    type Value = Option<Box<Object>>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a geometry or null")
    }

    fn visit_unit<E: serde::de::Error>(self) -> Result<Self::Value, E> {
        Ok(None)
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Self::Value, A::Error> {
        Parsed(self.0).visit_map(map).map(|object| Some(Box::new(object)))
    }
}

/// The list of geometries of a collection.
struct Geometries<'a, 'b>(&'a mut Sink<'b>, &'a mut Vec<Object>);

impl<'de> DeserializeSeed<'de> for Geometries<'_, '_> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<(), D::Error> {
        deserializer.deserialize_seq(self)
    }
}

impl<'de> Visitor<'de> for Geometries<'_, '_> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a list of geometries")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<(), A::Error> {
        while let Some(object) = list.next_element_seed(Parsed(&mut *self.0))? {
            self.1.push(object);
        }
        Ok(())
    }
}

/// The list of features of a collection.
struct Features<'a, 'b>(&'a mut Sink<'b>);

impl<'de> DeserializeSeed<'de> for Features<'_, '_> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<(), D::Error> {
        deserializer.deserialize_seq(self)
    }
}

impl<'de> Visitor<'de> for Features<'_, '_> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a list of features")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<(), A::Error> {
        while list.next_element_seed(Drawn(&mut *self.0))?.is_some() {}
        Ok(())
    }
}
