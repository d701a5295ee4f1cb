//! The outermost object or list.

use super::coboundaries::{Coboundary, CoboundaryOf, degree_of_key};
use super::curves::{CurveKeys, CurveList};
use super::exact::ExactList;
use super::exact_segments::ExactSegmentList;
use super::facets::{Facet, FacetList, HalfedgeList, OuterFaces, TwinList};
use super::faults::Faults;
use super::gluings::GluingList;
use super::interface::{Interface, InterfaceKeys};
use super::matrices::MatrixList;
use super::points::{PointList, Points};
use crate::yin::BoundaryDrawing;
use coface_algebra::Error;
use coface_algebra::{RaggedArray, SparseMatrix};
use coface_complexes::gluing::GluingTable;
use serde::de::{DeserializeSeed, Deserializer, IgnoredAny, MapAccess, SeqAccess, Visitor};
use serde_json::Value;
use std::fmt;

/// What one object describes.
pub(super) enum Content {
    Facets(RaggedArray, Option<PointList>),
    Halfedges {
        next: Vec<u32>,
        twin: Option<Vec<Option<u32>>>,
        /// The faces that are outer.
        outer: Vec<u32>,
        points: Option<PointList>,
    },
    Boundaries {
        matrices: Vec<SparseMatrix>,
        points: Option<PointList>,
        /// From degree 0 on, what each cell is a piece of.
        pieces: Option<Vec<Vec<Option<u32>>>>,
        /// The faces before coordinates were rounded.
        exact: Option<ExactList>,
        /// The edges of a drawing before coordinates were rounded.
        segments: Option<ExactSegmentList>,
    },
    /// Coboundary matrices with the degrees of their keys, in the order of the file.
    Coboundaries {
        matrices: Vec<(u32, Coboundary)>,
        points: Option<PointList>,
    },
    Gluings(GluingTable),
    Boundary(BoundaryDrawing),
    Interface(Box<Interface>),
    /// None of these; some of the keys that stand there instead.
    Unknown {
        keys: Vec<String>,
        is_answer: bool,
    },
}

/// What the file is.
pub(super) enum Document {
    /// One object with its name, or a list of facets.
    One(Option<String>, Content),
    /// Several models.
    List(Choice),
}

/// The models of a list: their names, and of their contents those that are wanted.
pub(super) struct Choice {
    wanted: Option<String>,
    pub(super) names: Vec<Option<String>>,
    /// Those of the name that is wanted.
    named: Vec<Content>,
    /// The one at the place that is wanted, from 1, or the first if nothing is wanted.
    placed: Option<Content>,
}

impl Choice {
    pub(super) fn new(wanted: Option<&str>) -> Self {
        Self { wanted: wanted.map(str::to_owned), names: Vec::new(), named: Vec::new(), placed: None }
    }

    pub(super) fn add(&mut self, name: Option<String>, content: Content) {
        let place = self.wanted.as_ref().map_or(Some(1), |wanted| wanted.parse().ok());
        if self.wanted.is_some() && name == self.wanted {
            self.named.push(content);
        } else if place == Some(self.names.len() + 1) {
            self.placed = Some(content);
        }
        self.names.push(name);
    }

    /// What is wanted: a name comes before a place.
    pub(super) fn into_chosen(self) -> Vec<Content> {
        if self.named.is_empty() { self.placed.into_iter().collect() } else { self.named }
    }
}

/// One value of the file; in a list, the objects named `wanted` are kept, or the one at that place, from 1.
pub(super) struct Root<'a> {
    pub(super) wanted: Option<&'a str>,
    pub(super) faults: &'a Faults,
}

impl<'de> DeserializeSeed<'de> for Root<'_> {
    type Value = Document;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Document, D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Root<'_> {
    type Value = Document;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("an object or a list")
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Document, A::Error> {
        visit_object(map, self.faults).map(|(name, content)| Document::One(name, content))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Document, A::Error> {
        let (mut facets, mut vertices) = (RaggedArray::new(), Vec::new());
        let mut choice = Choice::new(self.wanted);
        while let Some(model) = list.next_element_seed(Element {
            facet: Facet { facets: &mut facets, vertices: &mut vertices, faults: self.faults },
        })? {
            let Some((name, content)) = model else { continue };
            choice.add(name, content);
        }
        match (facets.is_empty(), choice.names.is_empty()) {
            (_, true) => Ok(Document::One(None, Content::Facets(facets, None))),
            (true, false) => Ok(Document::List(choice)),
            (false, false) => {
                Err(self
                    .faults
                    .raise(Error::parse("the list holds facets as well as models").with_cure(
                        "keep to one: a list of facets, or a list of lists of facets and objects",
                    )))
            }
        }
    }
}

/// An element of the outermost list: a facet, or a model: an object, or a list of facets.
struct Element<'a> {
    facet: Facet<'a>,
}

impl<'de> DeserializeSeed<'de> for Element<'_> {
    type Value = Option<(Option<String>, Content)>;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Self::Value, D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Element<'_> {
    type Value = Option<(Option<String>, Content)>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.facet.expecting(f)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<Self::Value, A::Error> {
        Ok(self.facet.or_list(list)?.map(|facets| (None, Content::Facets(facets, None))))
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Self::Value, A::Error> {
        visit_object(map, self.facet.faults).map(Some)
    }
}

/// The name of an object and what it describes.
fn visit_object<'de, A: MapAccess<'de>>(
    mut map: A,
    faults: &Faults,
) -> Result<(Option<String>, Content), A::Error> {
    let (mut name, mut facets, mut next, mut twin, mut boundaries) = (None, None, None, None, None);
    let (mut gluings, mut points, mut coboundaries, mut others) = (None, None, Vec::new(), Vec::new());
    let (mut curves, mut pieces, mut outer) = (CurveKeys::default(), None, Vec::new());
    let (mut exact, mut segments, mut interface) = (None, None, InterfaceKeys::default());
    let mut is_answer = false;
    while let Some(key) = map.next_key::<String>()? {
        match key.as_str() {
            "name" => name = map.next_value_seed(Name)?,
            "facets" => facets = Some(map.next_value_seed(FacetList(faults))?),
            "next" => next = Some(map.next_value_seed(HalfedgeList { name: "next", faults })?),
            "twin" => twin = Some(map.next_value_seed(TwinList(faults))?),
            "outer" => outer = map.next_value_seed(OuterFaces)?,
            "boundaries" => boundaries = Some(map.next_value_seed(MatrixList(faults))?),
            "pieces_of" => pieces = Some(map.next_value()?),
            "exact_polygons" => exact = Some(map.next_value()?),
            "exact_segments" => segments = Some(map.next_value()?),
            "gluings" => gluings = Some(map.next_value_seed(GluingList(faults))?),
            "order" => curves.order = Some(map.next_value()?),
            "plane" => curves.plane = Some(map.next_value()?),
            "next_vertex" => curves.next_vertex = Some(map.next_value()?),
            "curves" => curves.curves = Some(map.next_value_seed(CurveList(faults))?),
            "vertices" => {
                points = Some(map.next_value_seed(Points)?);
                others.push(key);
            }
            "phases" | "edges" | "smooth_pairs" => {
                let value = Some(map.next_value()?);
                match key.as_str() {
                    "phases" => interface.phases = value,
                    "edges" => interface.edges = value,
                    _ => interface.smooth_pairs = value,
                }
                others.push(key);
            }
            _ => {
                interface.has_junctions |= key == "junctions";
                is_answer |= key == "remarks";
                if let Some(degree) = degree_of_key(&key) {
                    coboundaries.push((degree, map.next_value_seed(CoboundaryOf { degree, faults })?));
                    continue;
                }
                map.next_value::<IgnoredAny>()?;
                if others.len() < 8 {
                    others.push(key);
                }
            }
        }
    }
    let is_other = facets.is_some() || next.is_some() || boundaries.is_some() || gluings.is_some();
    if curves.is_some() && !is_other && coboundaries.is_empty() {
        curves.others = others;
        let drawing = curves.into_drawing().map_err(|fault| faults.raise(fault))?;
        return Ok((name, Content::Boundary(drawing)));
    }
    let has_curves = curves.is_some();
    let content = match (facets, next, boundaries, gluings, coboundaries.is_empty()) {
        _ if has_curves => return Err(several(faults)),
        (Some(facets), None, None, None, true) => Content::Facets(facets, points),
        (None, Some(next), None, None, true) => Content::Halfedges { next, twin, outer, points },
        (None, None, Some(matrices), None, true) => {
            Content::Boundaries { matrices, points, pieces, exact, segments }
        }
        (None, None, None, Some(table), true) => Content::Gluings(table),
        (None, None, None, None, false) => Content::Coboundaries { matrices: coboundaries, points },
        (None, None, None, None, true) => {
            let positions = points.and_then(PointList::into_list);
            let order = curves.order.as_ref().and_then(Value::as_u64);
            match interface.into_interface(order, positions) {
                Some(found) => Content::Interface(Box::new(found.map_err(|fault| faults.raise(fault))?)),
                None => Content::Unknown { keys: others, is_answer },
            }
        }
        _ => return Err(several(faults)),
    };
    Ok((name, content))
}

/// The error of an object that is several things.
fn several<E: serde::de::Error>(faults: &Faults) -> E {
    faults.raise(
        Error::parse(
            "one object has more than one of \"facets\", \"next\", \"boundaries\", \"d0\", \"gluings\" and \"curves\"",
        )
        .with_cure("make them objects of their own, with names, in a list"),
    )
}

/// A name; what is no text is none.
struct Name;

impl<'de> DeserializeSeed<'de> for Name {
    type Value = Option<String>;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Self::Value, D::Error> {
        deserializer.deserialize_string(self)
    }
}

impl Visitor<'_> for Name {
    type Value = Option<String>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a name, a text")
    }

    fn visit_str<E: serde::de::Error>(self, name: &str) -> Result<Self::Value, E> {
        Ok(Some(name.to_owned()))
    }
}
