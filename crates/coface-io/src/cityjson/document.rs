//! The JSON of CityJSON.

use super::nested::Nested;
use serde::Deserialize;
use serde::de::{Deserializer, MapAccess, SeqAccess, Visitor};
use serde_json::value::RawValue;
use std::fmt;

/// A file, or a line of a text sequence.
#[derive(Debug, Deserialize)]
pub(super) struct Document {
    #[serde(rename = "type")]
    pub(super) kind: Option<String>,
    pub(super) transform: Option<RawTransform>,
    #[serde(rename = "CityObjects", default)]
    pub(super) objects: CityObjects,
    pub(super) vertices: Option<Vertices>,
    #[serde(rename = "geometry-templates")]
    pub(super) templates: Option<Templates>,
}

/// The numbers of a transform as they are written.
#[derive(Debug, Deserialize)]
pub(super) struct RawTransform {
    pub(super) scale: Vec<Box<RawValue>>,
    pub(super) translate: Vec<Box<RawValue>>,
}

#[derive(Debug, Default, Deserialize)]
pub(super) struct Templates {
    #[serde(default)]
    pub(super) templates: Vec<Geometry>,
    #[serde(rename = "vertices-templates", default)]
    pub(super) vertices: Vertices,
}

#[derive(Debug, Deserialize)]
pub(super) struct CityObject {
    #[serde(rename = "type")]
    pub(super) kind: Option<String>,
    pub(super) attributes: Option<Box<RawValue>>,
    #[serde(default, deserialize_with = "or_nothing")]
    pub(super) geometry: Vec<Geometry>,
}

#[derive(Debug, Deserialize)]
pub(super) struct Geometry {
    #[serde(rename = "type")]
    pub(super) kind: String,
    pub(super) lod: Option<Box<RawValue>>,
    #[serde(default)]
    pub(super) boundaries: Nested,
    pub(super) semantics: Option<Semantics>,
    pub(super) template: Option<u64>,
    #[serde(rename = "transformationMatrix")]
    pub(super) matrix: Option<Vec<f64>>,
}

impl Geometry {
    /// The level of detail: a number, or the text of one; `None` if it has none.
    pub(super) fn lod(&self) -> Option<f64> {
        let text = self.lod.as_ref()?.get().trim_matches('"');
        text.parse().ok().filter(|lod: &f64| lod.is_finite())
    }
}

#[derive(Debug, Deserialize)]
pub(super) struct Semantics {
    #[serde(default, deserialize_with = "or_nothing")]
    pub(super) surfaces: Vec<SemanticSurface>,
    #[serde(default)]
    pub(super) values: Nested,
}

#[derive(Debug, Deserialize)]
pub(super) struct SemanticSurface {
    #[serde(rename = "type")]
    pub(super) kind: Option<String>,
}

fn or_nothing<'de, D: Deserializer<'de>, T: Deserialize<'de>>(deserializer: D) -> Result<Vec<T>, D::Error> {
    Ok(Option::deserialize(deserializer)?.unwrap_or_default())
}

/// The objects in the order of the file.
#[derive(Debug, Default)]
pub(super) struct CityObjects(pub(super) Vec<(String, CityObject)>);

impl<'de> Deserialize<'de> for CityObjects {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Objects;
        impl<'de> Visitor<'de> for Objects {
            type Value = CityObjects;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("\"CityObjects\", an object with an object for each id")
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<CityObjects, A::Error> {
                let mut objects = Vec::new();
                while let Some(object) = map.next_entry()? {
                    objects.push(object);
                }
                Ok(CityObjects(objects))
            }
        }
        deserializer.deserialize_map(Objects)
    }
}

/// A coordinate as it is written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Coordinate {
    Whole(i64),
    Real(f64),
}

impl Coordinate {
    pub(super) fn to_f64(self) -> f64 {
        match self {
            Self::Whole(number) => number as f64,
            Self::Real(number) => number,
        }
    }
}

impl<'de> Deserialize<'de> for Coordinate {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Number;
        impl Visitor<'_> for Number {
            type Value = Coordinate;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a coordinate, which is a number")
            }

            fn visit_i64<E: serde::de::Error>(self, number: i64) -> Result<Coordinate, E> {
                Ok(Coordinate::Whole(number))
            }

            fn visit_u64<E: serde::de::Error>(self, number: u64) -> Result<Coordinate, E> {
                Ok(i64::try_from(number).map_or(Coordinate::Real(number as f64), Coordinate::Whole))
            }

            fn visit_f64<E: serde::de::Error>(self, number: f64) -> Result<Coordinate, E> {
                Ok(Coordinate::Real(number))
            }
        }
        deserializer.deserialize_any(Number)
    }
}

/// Vertices with three coordinates each.
#[derive(Debug, Default)]
pub(super) struct Vertices(pub(super) Vec<[Coordinate; 3]>);

impl<'de> Deserialize<'de> for Vertices {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct List;
        impl<'de> Visitor<'de> for List {
            type Value = Vertices;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a list of vertices, each with three coordinates")
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Vertices, A::Error> {
                let mut vertices = Vec::new();
                while let Some(vertex) = list.next_element()? {
                    vertices.push(vertex);
                }
                Ok(Vertices(vertices))
            }
        }
        deserializer.deserialize_seq(List)
    }
}
