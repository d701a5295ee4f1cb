//! From a stream to a model.

use super::document::{CityObject, Coordinate, Document, Geometry, Templates, Vertices};
use super::nested::{Cursor, Token};
use super::transform::Transform;
use crate::assembly::Assembly;
use crate::element_kind::Kind;
use crate::feature_table::{FeatureTable, FeatureTexts};
use crate::group::Roles;
use crate::holed_faces::triangulated;
use crate::json_text::compact;
use crate::stated_surfaces::SurfaceCollector;
use crate::{GroupKind, GroupRole, Model, ReadOptions, Remark, RemarkCode};
use coface_algebra::{Error, ErrorKind};
use coface_arrange::spatial::checks::CheckedPrimitive;
use serde::Deserialize;
use serde_json::error::Category;
use std::collections::BTreeMap;
use std::io::{BufReader, Read};
use std::sync::Arc;

/// Beyond so many corners, those of instances are at most `RATIO` times what the file holds: few bytes can place a
/// template very often.
const FREE: usize = 1 << 22;
const RATIO: usize = 64;
/// The numbers of groups for semantics are from here on; those before are for objects.
const SEMANTICS: i64 = 1 << 40;
/// So many levels are listed in a message.
const MOST_LISTED: usize = 8;

/// Reads a city, building or part of one: see [what becomes of what](crate::cityjson).
///
/// # Errors
/// [`ErrorKind::Parse`] for what is no CityJSON, with the line; [`ErrorKind::InvalidInput`] naming object, geometry
/// and place of a ring with fewer
/// than three vertices around a surface, or a vertex that is not there; [`ErrorKind::TooLarge`] for
/// templates that are placed
/// too often.
///
/// # Complexity
/// Linear, and $O(n \log n)$ for surfaces with holes.
///
/// # References
/// H. Ledoux et al., *CityJSON: a compact and easy-to-use encoding of the CityGML data model* (2019); OGC 20-072r5,
/// *CityJSON Community
/// Standard 2.0* (2023).
///
/// # Examples
/// ```
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let text = r#"{"type": "CityJSON", "version": "2.0",
///     "transform": {"scale": [0.1, 0.1, 0.1], "translate": [0, 0, 0]},
///     "CityObjects": {"shed": {"type": "Building", "attributes": {"year": 1998}, "geometry": [
///         {"type": "Solid", "lod": "1", "boundaries": [[[[0, 2, 1]], [[0, 1, 3]], [[1, 2, 3]], [[2, 0, 3]]]]}]}},
///     "vertices": [[0, 0, 0], [10, 0, 0], [0, 10, 0], [0, 0, 60]]}"#;
/// let model = coface_io::cityjson::read(text.as_bytes())?;
/// assert_eq!((model.polygons().len(), model.positions().as_flat()[3]), (4, 1.0));
/// assert_eq!(model.groups()[0].name(), "shed");
/// assert_eq!(model.features().properties(0), r#"{"type":"Building","year":1998}"#);
/// # Ok(()) }
/// ```
pub fn read(input: impl Read) -> Result<Model, Error> {
    read_with(input, &ReadOptions::default())
}

/// The same with a level of detail.
pub(crate) fn read_with(input: impl Read, options: &ReadOptions) -> Result<Model, Error> {
    let mut deserializer = serde_json::Deserializer::from_reader(BufReader::with_capacity(1 << 16, input));
    let mut city = City::new(options.lod);
    loop {
        let document = Document::deserialize(&mut deserializer).map_err(located)?;
        city.add(document)?;
        // A text sequence has a feature a line behind the first object.
        if deserializer.end().is_ok() {
            return city.finish();
        }
    }
}

/// Whether the start of a file says that it is CityJSON, or a feature of it.
pub(crate) fn is_cityjson(start: &[u8]) -> bool {
    if start.trim_ascii_start().first() != Some(&b'{') {
        return false;
    }
    memchr::memmem::find_iter(start, b"\"type\"").any(|at| {
        let value = start[at + 6..].trim_ascii_start();
        let Some(value) = value.strip_prefix(b":").map(<[u8]>::trim_ascii_start) else { return false };
        value.starts_with(b"\"CityJSON\"") || value.starts_with(b"\"CityJSONFeature\"")
    }) || memchr::memmem::find(start, b"\"CityObjects\"").is_some()
}

fn located(error: serde_json::Error) -> Error {
    let (line, column, category) = (error.line() as u64, error.column(), error.classify());
    if category == Category::Io {
        return std::io::Error::from(error).into();
    }
    let text = error.to_string();
    let place = format!(" at line {line} column {column}");
    let text = text.strip_suffix(&place).unwrap_or(&text);
    let safe: String = text.chars().take(200).map(|c| if c.is_control() { '?' } else { c }).collect();
    Error::parse(format!("{safe} (column {column})")).at_line(line).with_cure(match category {
        Category::Eof => "the file was cut short: write it again",
        _ => "the file must be CityJSON 1.0, 1.1 or 2.0",
    })
}

/// What geometries of a kind hold.
#[derive(Clone, Copy, PartialEq)]
enum Shape {
    Points,
    Lines,
    /// Surfaces, below so many levels of lists.
    Surfaces(usize),
    Instance,
}

fn shape_of(kind: &str) -> Option<Shape> {
    Some(match kind {
        "MultiPoint" => Shape::Points,
        "MultiLineString" => Shape::Lines,
        "MultiSurface" | "CompositeSurface" => Shape::Surfaces(0),
        "Solid" => Shape::Surfaces(1),
        "MultiSolid" | "CompositeSolid" => Shape::Surfaces(2),
        "GeometryInstance" => Shape::Instance,
        _ => return None,
    })
}

/// An affine map of templates: three rows of four numbers.
type Rows = [[f64; 4]; 3];

struct City {
    lod: Option<f64>,
    assembly: Assembly,
    transform: Option<Transform>,
    templates: Templates,
    /// Of the first document.
    is_begun: bool,
    object_count: usize,
    texts: FeatureTexts,
    feature_of_polygon: Vec<u32>,
    /// The numbers of groups by the names of semantics.
    semantics: BTreeMap<String, i64>,
    /// How many corners and vertices instances have placed, and how many numbers were read.
    placed: usize,
    read: usize,
    with_holes: usize,
    /// Surfaces some of whose rings no polygons were made of.
    with_odd_holes: usize,
    surfaces: SurfaceCollector,
    /// Objects that have no geometry of the level that was asked for.
    without_lod: usize,
    has_lod: bool,
    levels: Vec<f64>,
}

/// The vertices of a document, and which of them the model has.
struct Points<'a> {
    given: &'a [[Coordinate; 3]],
    transform: Option<&'a Transform>,
    map: Option<Rows>,
    /// The vertex of the model, if there is one.
    number: Vec<Option<u32>>,
}

impl Points<'_> {
    /// The vertex of the model for a vertex of the document.
    fn vertex(
        &mut self,
        index: u32,
        assembly: &mut Assembly,
        place: &dyn Fn() -> String,
    ) -> Result<u32, Error> {
        let Some(&given) = self.given.get(index as usize) else {
            return Err(Error::invalid(format!(
                "{}: vertex {index}, but there are {} vertices, numbered from 0",
                place(),
                self.given.len()
            ))
            .with_cure("correct the index, or add the vertices"));
        };
        if let Some(number) = self.number[index as usize] {
            return Ok(number);
        }
        let mut point = match self.transform {
            Some(transform) => transform.apply(given),
            None => given.map(Coordinate::to_f64),
        };
        if let Some(rows) = &self.map {
            let [x, y, z] = point;
            point = rows.map(|[a, b, c, d]| a * x + b * y + c * z + d);
        }
        let number = assembly.vertex_count() as u32;
        assembly.add_vertex(&point)?;
        self.number[index as usize] = Some(number);
        Ok(number)
    }
}

impl City {
    fn new(lod: Option<f64>) -> Self {
        Self {
            lod,
            assembly: Assembly::new(3),
            transform: None,
            templates: Templates::default(),
            is_begun: false,
            object_count: 0,
            texts: FeatureTexts::default(),
            feature_of_polygon: Vec::new(),
            semantics: BTreeMap::new(),
            placed: 0,
            read: 0,
            with_holes: 0,
            with_odd_holes: 0,
            surfaces: SurfaceCollector::default(),
            without_lod: 0,
            has_lod: false,
            levels: Vec::new(),
        }
    }

    fn add(&mut self, document: Document) -> Result<(), Error> {
        let kind = document.kind.as_deref().unwrap_or("");
        let expected = if self.is_begun { "CityJSONFeature" } else { "CityJSON" };
        if kind != expected && kind != "CityJSONFeature" {
            return Err(Error::parse(format!("\"type\" is \"{}\", not \"{expected}\"", kind.escape_debug()))
                .with_cure("the file must be CityJSON 1.0, 1.1 or 2.0, or a text sequence of its features"));
        }
        self.is_begun = true;
        if let Some(raw) = &document.transform {
            let texts = |list: &'_ [Box<serde_json::value::RawValue>]| -> Vec<String> {
                list.iter().map(|value| value.get().to_owned()).collect()
            };
            self.transform = Some(Transform::new(&texts(&raw.scale), &texts(&raw.translate))?);
        }
        if let Some(templates) = document.templates {
            self.read += 3 * templates.vertices.0.len();
            self.templates = templates;
        }
        let objects = document.objects.0;
        let Some(Vertices(vertices)) = document.vertices else {
            return match objects.is_empty() {
                true => Ok(()),
                false => Err(Error::parse("there are no \"vertices\", which geometries name by number")
                    .with_cure("write the list of vertices, or an empty one")),
            };
        };
        self.read += 3 * vertices.len();
        let transform = self.transform.clone();
        let mut points = Points {
            given: &vertices,
            transform: transform.as_ref(),
            map: None,
            number: vec![None; vertices.len()],
        };
        let mut chosen = Vec::with_capacity(objects.len());
        let mut is_used = vec![false; vertices.len()];
        for (id, object) in &objects {
            let of_object = self.choose(id, object)?;
            for &(geometry, _) in of_object.iter().filter(|&&(_, shape)| shape != Shape::Instance) {
                for index in object.geometry[geometry].boundaries.numbers() {
                    // What is out of range is an error further down, with its place.
                    if let Some(is_used) = is_used.get_mut(index as usize) {
                        *is_used = true;
                    }
                }
            }
            chosen.push(of_object);
        }
        // Vertices come in the order of the file.
        for index in (0..vertices.len() as u32).filter(|&index| is_used[index as usize]) {
            points.vertex(index, &mut self.assembly, &String::new)?;
        }
        for ((id, object), chosen) in objects.iter().zip(&chosen) {
            self.add_object(id, object, chosen, &mut points)?;
        }
        Ok(())
    }

    /// The geometries of an object that are read, with what they hold.
    fn choose(&mut self, id: &str, object: &CityObject) -> Result<Vec<(usize, Shape)>, Error> {
        let mut first_of_kind = Vec::new();
        let mut best: Option<f64> = None;
        for (i, geometry) in object.geometry.iter().enumerate() {
            self.read += geometry.boundaries.len();
            let kind = &geometry.kind[..];
            let Some(shape) = shape_of(kind) else {
                return Err(Error::invalid(format!(
                    "{}: the type \"{}\" is no geometry of CityJSON",
                    place_of(id, i, geometry),
                    kind.escape_debug()
                ))
                .with_cure(
                    "it is one of MultiPoint, MultiLineString, MultiSurface, CompositeSurface, Solid, MultiSolid, \
                     CompositeSolid and GeometryInstance",
                ));
            };
            let lod = self.lod_of(geometry);
            if let Some(lod) = lod
                && !self.levels.contains(&lod)
            {
                self.levels.push(lod);
            }
            let is_wanted = self.lod.is_none_or(|wanted| lod == Some(wanted));
            if is_wanted {
                let lod = lod.unwrap_or(f64::NEG_INFINITY);
                best = Some(best.map_or(lod, |best: f64| best.max(lod)));
                first_of_kind.push((i, shape, lod));
            }
        }
        if object.geometry.is_empty() {
            return Ok(Vec::new());
        }
        let Some(best) = best else {
            self.without_lod += 1;
            return Ok(Vec::new());
        };
        self.has_lod = true;
        let of_level = first_of_kind.into_iter().filter(|&(_, _, lod)| lod == best);
        let mut chosen: Vec<(usize, Shape)> = of_level.map(|(i, shape, _)| (i, shape)).collect();
        if chosen.iter().any(|&(_, shape)| matches!(shape, Shape::Surfaces(1..))) {
            // Surfaces of a level that has solids are their sides once more.
            chosen.retain(|&(_, shape)| shape != Shape::Surfaces(0));
        }
        Ok(chosen)
    }

    fn add_object(
        &mut self,
        id: &str,
        object: &CityObject,
        chosen: &[(usize, Shape)],
        points: &mut Points<'_>,
    ) -> Result<(), Error> {
        let number = self.texts.len() as u32;
        self.texts.push(&properties(object), &serde_json::Value::from(id).to_string());
        if chosen.is_empty() {
            return Ok(());
        }
        self.object_count += 1;
        let group = self.object_count as i64;
        self.assembly.name_group(GroupKind::Polygons, group, id.to_owned());
        for &(i, shape) in chosen {
            let geometry = &object.geometry[i];
            let place = || place_of(id, i, geometry);
            if shape == Shape::Instance {
                self.add_instance(geometry, points, (group, number), &place)?;
            } else {
                self.add_geometry(geometry, shape, points, (group, number), false, &place)?;
            }
        }
        Ok(())
    }

    /// The level of a geometry; that of its template for an instance without one.
    fn lod_of(&self, geometry: &Geometry) -> Option<f64> {
        geometry.lod().or_else(|| {
            let template = usize::try_from(geometry.template?).ok()?;
            self.templates.templates.get(template)?.lod()
        })
    }

    fn add_instance(
        &mut self,
        instance: &Geometry,
        points: &Points<'_>,
        owner: (i64, u32),
        place: &dyn Fn() -> String,
    ) -> Result<(), Error> {
        let fault = |what: String, cure: &str| {
            Err(Error::invalid(format!("{}: {what}", place())).with_cure(cure.to_owned()))
        };
        let templates = std::mem::take(&mut self.templates);
        let mut add = || {
            let count = templates.templates.len();
            let number = instance.template.unwrap_or(u64::MAX);
            let Some(template) =
                usize::try_from(number).ok().and_then(|number| templates.templates.get(number))
            else {
                let what = match instance.template {
                    Some(number) => format!("template {number}, but there are {count}, numbered from 0"),
                    None => "it names no template".to_owned(),
                };
                return fault(what, "name one of \"geometry-templates\"");
            };
            let kind = &template.kind[..];
            let Some(shape) = shape_of(kind).filter(|&shape| shape != Shape::Instance) else {
                return fault(
                    format!("template {number} has the type \"{}\"", kind.escape_debug()),
                    "a template is a geometry that is no instance",
                );
            };
            let Some(&[anchor]) = instance.boundaries.cursor().numbers() else {
                return fault(
                    "its boundaries are not one vertex".to_owned(),
                    "name the vertex where it stands",
                );
            };
            let Some(&given) = points.given.get(anchor as usize) else {
                return fault(
                    format!(
                        "vertex {anchor}, but there are {} vertices, numbered from 0",
                        points.given.len()
                    ),
                    "correct the index, or add the vertices",
                );
            };
            let origin = match points.transform {
                Some(transform) => transform.apply(given),
                None => given.map(Coordinate::to_f64),
            };
            let matrix = match instance.matrix.as_deref() {
                None => [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0],
                Some(numbers) => match <[f64; 16]>::try_from(numbers) {
                    Ok(matrix) if matrix[12..] == [0.0, 0.0, 0.0, 1.0] => matrix,
                    _ => {
                        return fault(
                            "its matrix is not 16 numbers that end with 0, 0, 0, 1".to_owned(),
                            "write the matrix row by row",
                        );
                    }
                },
            };
            let rows: Rows = [0, 1, 2].map(|row| {
                let [a, b, c, d] = [0, 1, 2, 3].map(|column| matrix[4 * row + column]);
                [a, b, c, d + origin[row]]
            });
            let cost = template.boundaries.len() + templates.vertices.0.len();
            self.placed = self.placed.saturating_add(cost);
            if self.placed > FREE.max(self.read.saturating_mul(RATIO)) {
                return Err(Error::new(
                    ErrorKind::TooLarge,
                    format!("{}: templates are placed too often", place()),
                )
                .with_cure("write fewer instances"));
            }
            let vertices = &templates.vertices.0;
            let mut moved = Points {
                given: vertices,
                transform: None,
                map: Some(rows),
                number: vec![None; vertices.len()],
            };
            let [x, y, z] = rows.map(|[a, b, c, _]| [a, b, c]);
            let is_mirror = coface_geometry::determinant(x, y, z) < 0.0;
            self.add_geometry(template, shape, &mut moved, owner, is_mirror, place)
        };
        let added = add();
        self.templates = templates;
        added
    }

    fn add_geometry(
        &mut self,
        geometry: &Geometry,
        shape: Shape,
        points: &mut Points<'_>,
        owner: (i64, u32),
        is_mirror: bool,
        place: &dyn Fn() -> String,
    ) -> Result<(), Error> {
        let malformed = || {
            Error::invalid(format!("{}: its boundaries are not nested as the type says", place())).with_cure(
                "write rings as lists of vertices, surfaces as lists of rings, shells as lists of surfaces",
            )
        };
        let mut cursor = geometry.boundaries.cursor();
        let mut values = geometry.semantics.as_ref().map(|semantics| semantics.values.cursor());
        match shape {
            Shape::Points => {
                for &index in cursor.numbers().ok_or_else(malformed)? {
                    let vertex = points.vertex(index, &mut self.assembly, place)?;
                    self.assembly.add(Kind::Point, 1, &[vertex], u64::from)?;
                }
                Ok(())
            }
            Shape::Lines => {
                if cursor.take() != Some(Token::Open) {
                    return Err(malformed());
                }
                while cursor.peek() == Some(Token::Open) {
                    let line = cursor.numbers().ok_or_else(malformed)?;
                    if line.len() < 2 {
                        return Err(Error::invalid(format!(
                            "{}: a line with {} vertices",
                            place(),
                            line.len()
                        ))
                        .with_cure("a line needs 2"));
                    }
                    let line = line.iter().map(|&index| points.vertex(index, &mut self.assembly, place));
                    let line: Vec<u32> = line.collect::<Result<_, _>>()?;
                    self.assembly.add(Kind::Line, line.len(), &line, u64::from)?;
                }
                Ok(())
            }
            Shape::Surfaces(levels) => {
                let mut path = Vec::new();
                let mut walk = Walk {
                    city: self,
                    points,
                    owner,
                    is_mirror,
                    geometry,
                    place,
                    malformed: &malformed,
                    shell: None,
                    composite: None,
                };
                walk.level(&mut cursor, &mut values, levels, &mut path)
            }
            Shape::Instance => Err(malformed()),
        }
    }

    fn semantic_group(&mut self, kind: &str) -> i64 {
        if let Some(&group) = self.semantics.get(kind) {
            return group;
        }
        let group = SEMANTICS + self.semantics.len() as i64;
        self.semantics.insert(kind.to_owned(), group);
        self.assembly.name_group(GroupKind::Polygons, group, kind.to_owned());
        group
    }

    fn finish(mut self) -> Result<Model, Error> {
        if let Some(wanted) = self.lod.filter(|_| self.without_lod > 0) {
            if !self.has_lod {
                self.levels.sort_by(f64::total_cmp);
                let listed: Vec<String> = self.levels.iter().take(MOST_LISTED).map(f64::to_string).collect();
                let cure = match listed.len() {
                    0 => "leave --lod out: the geometries say no level".to_owned(),
                    _ => format!("the file has {}", listed.join(", ")),
                };
                return Err(
                    Error::invalid(format!("no geometry has the level of detail {wanted}")).with_cure(cure)
                );
            }
            let message =
                format!("{} objects have no geometry of the level of detail {wanted}", self.without_lod);
            let remark = Remark::new(RemarkCode::DataLeftOut, message).at(self.without_lod, []);
            self.assembly.remarks.push(remark);
        }
        if self.with_holes > 0 {
            let message = match self.with_holes {
                1 => "a surface with holes is read as triangles".to_owned(),
                count => format!("{count} surfaces with holes are read as triangles"),
            };
            let remark = Remark::new(RemarkCode::FacesTriangulated, message).at(self.with_holes, []);
            self.assembly.remarks.push(remark);
        }
        if self.with_odd_holes > 0 {
            let surfaces = match self.with_odd_holes {
                1 => "a surface has holes that cross or touch its rings, or have less than three vertices: they are".to_owned(),
                count => format!("{count} surfaces have holes that cross or touch their rings, or have less than three vertices: they are"),
            };
            let message = format!("{surfaces} left out of its polygons");
            let remark = Remark::new(RemarkCode::DataLeftOut, message).at(self.with_odd_holes, []);
            self.assembly.remarks.push(remark);
        }
        let mut model = self.assembly.finish()?;
        if !self.surfaces.is_empty() && model.polygons().len() == self.feature_of_polygon.len() {
            model.stated = Some(Arc::new(self.surfaces.finish(&model, self.with_odd_holes)?));
        }
        let polygons = model.groups.iter_mut().filter(|group| group.kind == GroupKind::Polygons);
        for group in polygons.take(self.object_count) {
            group.roles = Roles::of(GroupRole::Object);
        }
        if model.polygons().len() == self.feature_of_polygon.len() {
            model.features = FeatureTable::of_city(self.texts, self.feature_of_polygon);
        }
        Ok(model)
    }
}

/// The attributes of an object with its type in front.
fn properties(object: &CityObject) -> String {
    let kind = object.kind.as_deref().map(|kind| format!("\"type\":{}", serde_json::Value::from(kind)));
    let attributes = object.attributes.as_ref().map(|value| compact(value.get())).unwrap_or_default();
    let inner = attributes.strip_prefix('{').and_then(|rest| rest.strip_suffix('}')).unwrap_or_default();
    let names_type = inner.starts_with("\"type\":") || inner.contains(",\"type\":");
    let parts = [kind.filter(|_| !names_type).unwrap_or_default(), inner.to_owned()];
    format!("{{{}}}", parts.iter().filter(|part| !part.is_empty()).cloned().collect::<Vec<_>>().join(","))
}

/// Which geometry of which object.
fn place_of(id: &str, number: usize, geometry: &Geometry) -> String {
    let id: String = id.chars().take(100).flat_map(char::escape_debug).collect();
    let kind: String = geometry.kind.chars().take(40).flat_map(char::escape_debug).collect();
    let lod = geometry.lod().map_or_else(String::new, |lod| format!(", lod {lod}"));
    format!("object \"{id}\", geometry {number} ({kind}{lod})")
}

/// A walk through the surfaces of a geometry.
struct Walk<'c, 'p, 'g> {
    city: &'c mut City,
    points: &'c mut Points<'p>,
    owner: (i64, u32),
    is_mirror: bool,
    geometry: &'g Geometry,
    place: &'c dyn Fn() -> String,
    malformed: &'c dyn Fn() -> Error,
    /// The solid and the shell of the last surface.
    shell: Option<[usize; 2]>,
    /// The composite whose solids these are.
    composite: Option<u32>,
}

impl Walk<'_, '_, '_> {
    /// A list of surfaces, or of lists of such below so many levels; `values` are the semantics beside it, if they go
    /// on so far.
    fn level(
        &mut self,
        cursor: &mut Cursor<'_>,
        values: &mut Option<Cursor<'_>>,
        levels: usize,
        path: &mut Vec<usize>,
    ) -> Result<(), Error> {
        if cursor.take() != Some(Token::Open) {
            return Err((self.malformed)());
        }
        let has_values = match values.as_ref().and_then(Cursor::peek) {
            Some(Token::Open) => {
                values.as_mut().map(Cursor::take);
                true
            }
            Some(Token::Null | Token::Number(_)) => {
                values.as_mut().map(Cursor::take);
                false
            }
            Some(Token::Close) | None => false,
        };
        let mut none = None;
        let values = if has_values { values } else { &mut none };
        let mut number = 0;
        while cursor.peek() == Some(Token::Open) {
            path.push(number);
            if levels > 0 {
                self.level(cursor, values, levels - 1, path)?;
            } else {
                let semantic = match values.as_ref().and_then(Cursor::peek) {
                    Some(Token::Number(semantic)) => {
                        values.as_mut().map(Cursor::take);
                        Some(semantic)
                    }
                    Some(Token::Null) => {
                        values.as_mut().map(Cursor::take);
                        None
                    }
                    _ => None,
                };
                self.surface(cursor, semantic, path)?;
            }
            path.pop();
            number += 1;
        }
        if let Some(values) = values {
            values.leave();
        }
        match cursor.take() {
            Some(Token::Close) => Ok(()),
            _ => Err((self.malformed)()),
        }
    }

    fn surface(
        &mut self,
        cursor: &mut Cursor<'_>,
        semantic: Option<u32>,
        path: &[usize],
    ) -> Result<(), Error> {
        let outer = self.place;
        let place = || {
            let names = ["solid", "shell", "surface"];
            let parts = names[names.len() - path.len()..].iter().zip(path);
            let parts: Vec<String> = parts.map(|(name, number)| format!(", {name} {number}")).collect();
            format!("{}{}", outer(), parts.concat())
        };
        if cursor.take() != Some(Token::Open) {
            return Err((self.malformed)());
        }
        self.enter_shell(path);
        let mut rings: Vec<Vec<u32>> = Vec::new();
        while cursor.peek() == Some(Token::Open) {
            let indices = cursor.numbers().ok_or_else(self.malformed)?;
            if indices.is_empty() && rings.is_empty() {
                return Err(Error::invalid(format!("{}: ring 0 has no vertices", place()))
                    .with_cure("a ring needs 3: remove the surface, or write its vertices"));
            }
            let ring =
                indices.iter().map(|&index| self.points.vertex(index, &mut self.city.assembly, &place));
            let mut ring: Vec<u32> = ring.collect::<Result<_, _>>()?;
            if ring.len() > 3 && ring.first() == ring.last() {
                ring.pop();
            }
            if self.is_mirror {
                ring.reverse();
            }
            // A surface of one or two points is one that collapses.
            while rings.is_empty() && ring.len() < 3 {
                ring.push(ring[0]);
            }
            rings.push(ring);
        }
        if cursor.take() != Some(Token::Close) {
            return Err((self.malformed)());
        }
        let first = self.city.feature_of_polygon.len();
        let polygons = self.polygons_of(&rings);
        polygons.iter().try_for_each(|corners| self.add(corners, semantic))?;
        if let Some(outer) = rings.first_mut() {
            // What was corrected there is said already.
            outer.dedup();
            while outer.len() > 1 && outer.first() == outer.last() {
                outer.pop();
            }
        }
        if self.city.feature_of_polygon.len() > first {
            self.city.surfaces.add(&rings, first);
        }
        Ok(())
    }

    /// Begins another shell, if the surface with this path is in another one than the last.
    fn enter_shell(&mut self, path: &[usize]) {
        let shell = match *path {
            [solid, shell, _] => [solid, shell],
            [shell, _] => [0, shell],
            _ => [0; 2],
        };
        if self.shell != Some(shell) {
            let is_first = self.shell.is_none_or(|last| last[0] != shell[0]);
            let primitive = match &self.geometry.kind[..] {
                "MultiSurface" => CheckedPrimitive::MultiSurface,
                "CompositeSurface" => CheckedPrimitive::CompositeSurface,
                "CompositeSolid" => CheckedPrimitive::CompositeSolid(match self.composite {
                    Some(composite) => composite,
                    None => *self.composite.insert(self.city.surfaces.new_composite()),
                }),
                _ => CheckedPrimitive::Solid,
            };
            self.city.surfaces.begin_shell(is_first.then_some(primitive));
            self.shell = Some(shell);
        }
    }

    /// The outer ring, or triangles where there are holes; holes that cannot be cut out are left out.
    fn polygons_of(&mut self, rings: &[Vec<u32>]) -> Vec<Vec<u32>> {
        let [outer, holes @ ..] = rings else { return Vec::new() };
        if holes.is_empty() {
            return vec![outer.clone()];
        }
        let mut clean: Vec<Vec<u32>> = rings.to_vec();
        clean.iter_mut().for_each(Vec::dedup);
        clean.retain(|ring| ring.len() > 2);
        let city = &mut *self.city;
        let is_odd = clean.len() < rings.len();
        let triangles = match clean.len() {
            0 | 1 => None,
            _ => triangulated(&mut clean, |vertex| city.assembly.position(vertex)),
        };
        city.with_odd_holes += usize::from(is_odd || triangles.is_none());
        let Some(triangles) = triangles else { return vec![outer.clone()] };
        city.with_holes += 1;
        triangles.into_iter().map(|triangle| triangle.to_vec()).collect()
    }

    fn add(&mut self, corners: &[u32], semantic: Option<u32>) -> Result<(), Error> {
        let city = &mut *self.city;
        let Some(polygon) = city.assembly.add(Kind::Polygon, corners.len(), corners, u64::from)? else {
            return Ok(());
        };
        city.feature_of_polygon.push(self.owner.1);
        city.assembly.add_to_group(GroupKind::Polygons, self.owner.0, polygon);
        let surfaces = self.geometry.semantics.as_ref().map(|semantics| &semantics.surfaces[..]);
        let surface = semantic.and_then(|semantic| surfaces?.get(semantic as usize));
        if let Some(kind) = surface.and_then(|surface| surface.kind.as_deref()) {
            let group = city.semantic_group(kind);
            city.assembly.add_to_group(GroupKind::Polygons, group, polygon);
        }
        Ok(())
    }
}
