//! TopoJSON: geometries whose lines are shared arcs, with coordinates that may be whole numbers.
//!
//! The features are the geometries of each object, those of a collection one by one, with their properties.

use super::properties::Description;
use crate::drawing::{Drawing, Place};
use coface_algebra::{Error, ErrorKind};
use serde::Deserialize;
use serde_json::Value;
use serde_json::value::RawValue;
use std::collections::BTreeMap;

const CURE: &str = "the file must be TopoJSON as topojson writes it";
/// Collections in collections.
const DEEPEST: usize = 64;

/// What stands under the keys of a topology.
#[derive(Default)]
pub(super) struct Topology {
    pub(super) objects: Option<Box<RawValue>>,
    pub(super) arcs: Option<Value>,
    pub(super) transform: Option<Value>,
}

/// How whole numbers become coordinates.
struct Transform {
    scale: [f64; 2],
    translate: [f64; 2],
}

impl Transform {
    fn of(value: &Value) -> Result<Self, Error> {
        let pair = |key: &str| match value.get(key).and_then(Value::as_array).map(Vec::as_slice) {
            Some([x, y]) => x.as_f64().zip(y.as_f64()).map(|(x, y)| [x, y]),
            _ => None,
        };
        match (pair("scale"), pair("translate")) {
            (Some(scale), Some(translate)) => Ok(Self { scale, translate }),
            _ => Err(fault("the transform has no \"scale\" and \"translate\" of two numbers each")),
        }
    }

    fn place(&self, [x, y]: [f64; 2], z: Option<f64>) -> Place {
        let [x, y] = [(0, x), (1, y)].map(|(axis, x)| x * self.scale[axis] + self.translate[axis]);
        Place { x, y, z }
    }
}

fn fault(text: impl Into<String>) -> Error {
    Error::parse(text).with_cure(CURE)
}

impl Topology {
    /// Draws all objects, in the order of their names.
    ///
    /// # Errors
    /// [`ErrorKind::Parse`] for what is no topology, or names an arc that is not there; [`ErrorKind::TooLarge`] for collections nested
    /// deeper than 64.
    pub(super) fn draw(self, drawing: &mut Drawing) -> Result<(), Error> {
        let transform = self.transform.as_ref().map(Transform::of).transpose()?;
        let arcs = self.arcs.as_ref().and_then(Value::as_array).map_or(&[][..], Vec::as_slice);
        let arcs = arcs.iter().map(|arc| arc_of(arc, transform.as_ref())).collect::<Result<_, _>>()?;
        let drawer = Drawer { arcs, transform };
        let Some(objects) = self.objects.filter(|objects| objects.get().starts_with('{')) else {
            return Err(fault("a Topology has no \"objects\""));
        };
        let objects: BTreeMap<String, Option<Object<'_>>> = parsed(objects.get())?;
        objects.values().flatten().try_for_each(|object| drawer.features(object, drawing, 0))
    }
}

/// A geometry of a topology, or a collection of them. What is in it is read when it is drawn.
#[derive(Deserialize)]
struct Object<'a> {
    #[serde(rename = "type", default)]
    kind: Value,
    #[serde(borrow, default)]
    properties: Option<&'a RawValue>,
    #[serde(borrow, default)]
    id: Option<&'a RawValue>,
    #[serde(borrow, default)]
    geometries: Option<&'a RawValue>,
    #[serde(default)]
    arcs: Value,
    #[serde(default)]
    coordinates: Value,
}

impl<'a> Object<'a> {
    /// What the file says of it.
    fn description(&self) -> Result<Description, Error> {
        let mut description = Description::default();
        if let Some(properties) = self.properties.filter(|properties| properties.get().starts_with('{')) {
            description.set_properties(properties).map_err(fault)?;
        }
        if let Some(id) = self.id {
            description.set_id(id);
        }
        Ok(description)
    }

    /// The geometries of a collection.
    fn geometries(&self) -> Result<Vec<Option<Object<'a>>>, Error> {
        self.geometries.map_or(Ok(Vec::new()), |geometries| parsed(geometries.get()))
    }

    /// The list under a key, whose value this is.
    fn list<'b>(&self, key: &str, value: &'b Value) -> Result<&'b [Value], Error> {
        value.as_array().map(Vec::as_slice).ok_or_else(|| self.missing(key))
    }

    fn missing(&self, key: &str) -> Error {
        fault(format!("a geometry of type {} has no \"{key}\"", self.kind))
    }
}

fn parsed<'a, T: Deserialize<'a>>(text: &'a str) -> Result<T, Error> {
    serde_json::from_str(text).map_err(|error| fault(format!("an object of a Topology is none: {error}")))
}

/// The numbers of a position.
fn numbers_of(position: &Value) -> Result<([f64; 2], Option<f64>), Error> {
    let numbers = position.as_array().map_or(&[][..], Vec::as_slice);
    match numbers.iter().map(Value::as_f64).collect::<Option<Vec<f64>>>().as_deref() {
        Some(&[x, y]) => Ok(([x, y], None)),
        Some(&[x, y, z, ..]) => Ok(([x, y], Some(z))),
        _ => Err(fault("a position is not a list of two or more numbers")),
    }
}

/// The positions of an arc: with a transform each is the difference to the one before.
fn arc_of(arc: &Value, transform: Option<&Transform>) -> Result<Vec<Place>, Error> {
    let positions = arc.as_array().ok_or_else(|| fault("an arc is not a list of positions"))?;
    let mut at = [0.0; 2];
    positions
        .iter()
        .map(|position| {
            let (numbers, z) = numbers_of(position)?;
            let Some(transform) = transform else {
                return Ok(Place { x: numbers[0], y: numbers[1], z });
            };
            at = [at[0] + numbers[0], at[1] + numbers[1]];
            Ok(transform.place(at, z))
        })
        .collect()
}

struct Drawer {
    arcs: Vec<Vec<Place>>,
    transform: Option<Transform>,
}

impl Drawer {
    /// An object: a feature, or a collection of features.
    fn features(&self, object: &Object<'_>, drawing: &mut Drawing, depth: usize) -> Result<(), Error> {
        let description = object.description()?;
        if object.kind == "GeometryCollection" && description.name().is_none() && depth == 0 {
            let geometries = object.geometries()?;
            return geometries.iter().flatten().try_for_each(|geometry| self.features(geometry, drawing, 1));
        }
        description.begin(drawing);
        self.geometry(object, drawing, depth)?;
        drawing.begin_feature(None);
        Ok(())
    }

    fn geometry(&self, object: &Object<'_>, drawing: &mut Drawing, depth: usize) -> Result<(), Error> {
        if depth > DEEPEST {
            let message = format!("collections are nested deeper than {DEEPEST}");
            return Err(Error::new(ErrorKind::TooLarge, message).with_cure("nest them less"));
        }
        let lists = |value: &'_ Value| {
            value.as_array().cloned().ok_or_else(|| fault("the arcs of a geometry are nested too little"))
        };
        let arcs = || object.list("arcs", &object.arcs);
        match object.kind.as_str() {
            None if object.kind.is_null() => Ok(()),
            Some("Point") => self.point(&object.coordinates, drawing),
            Some("MultiPoint") => {
                let points = object.list("coordinates", &object.coordinates)?;
                points.iter().try_for_each(|point| self.point(point, drawing))
            }
            Some("LineString") => {
                self.path(arcs()?, drawing)?;
                drawing.end_line(|| "a LineString".to_owned());
                Ok(())
            }
            Some("MultiLineString") => arcs()?.iter().try_for_each(|line| {
                self.path(&lists(line)?, drawing)?;
                drawing.end_line(|| "a MultiLineString".to_owned());
                Ok(())
            }),
            Some("Polygon") => self.polygon(arcs()?, drawing),
            Some("MultiPolygon") => {
                arcs()?.iter().try_for_each(|polygon| self.polygon(&lists(polygon)?, drawing))
            }
            Some("GeometryCollection") => {
                object.geometries.ok_or_else(|| object.missing("geometries"))?;
                object
                    .geometries()?
                    .iter()
                    .flatten()
                    .try_for_each(|geometry| self.geometry(geometry, drawing, depth + 1))
            }
            _ => Err(fault("a geometry of a Topology has a type that is none")),
        }
    }

    fn point(&self, position: &Value, drawing: &mut Drawing) -> Result<(), Error> {
        let (numbers, z) = numbers_of(position)?;
        drawing.point(match &self.transform {
            Some(transform) => transform.place(numbers, z),
            None => Place { x: numbers[0], y: numbers[1], z },
        });
        Ok(())
    }

    fn polygon(&self, rings: &[Value], drawing: &mut Drawing) -> Result<(), Error> {
        drawing.begin_polygon();
        for ring in rings {
            let arcs = ring.as_array().ok_or_else(|| fault("the arcs of a polygon are nested too little"))?;
            self.path(arcs, drawing)?;
            drawing.end_ring(|| "a ring of a Topology".to_owned());
        }
        Ok(())
    }

    /// Arcs one after the other by their numbers: -1 is the first, the other way round.
    fn path(&self, arcs: &[Value], drawing: &mut Drawing) -> Result<(), Error> {
        for arc in arcs {
            let number = arc.as_i64().ok_or_else(|| fault("the number of an arc is not a whole number"))?;
            let at = usize::try_from(if number < 0 { !number } else { number }).unwrap_or(usize::MAX);
            let Some(places) = self.arcs.get(at) else {
                return Err(fault(format!("arc {number} is named, but there are {}", self.arcs.len())));
            };
            if number < 0 {
                places.iter().rev().for_each(|&place| drawing.corner(place));
            } else {
                places.iter().for_each(|&place| drawing.corner(place));
            }
        }
        Ok(())
    }
}
