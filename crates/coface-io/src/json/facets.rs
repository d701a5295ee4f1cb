//! Lists of numbers and lists of facets.

use super::faults::Faults;
use crate::model::repeated_vertex;
use coface_algebra::RaggedArray;
use coface_algebra::{Error, ErrorKind};
use serde::de::{DeserializeSeed, Deserializer, SeqAccess, Visitor};
use std::fmt;

/// A number of 32 bits; `what` says which, for an error.
pub(super) struct Number<'a, W> {
    pub(super) what: W,
    pub(super) faults: &'a Faults,
}

impl<'de, W: Fn() -> String> DeserializeSeed<'de> for Number<'_, W> {
    type Value = u32;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<u32, D::Error> {
        deserializer.deserialize_u32(self)
    }
}

impl<W: Fn() -> String> Visitor<'_> for Number<'_, W> {
    type Value = u32;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}, an integer from 0 to {}", (self.what)(), u32::MAX)
    }

    fn visit_u64<E: serde::de::Error>(self, value: u64) -> Result<u32, E> {
        u32::try_from(value).map_err(|_| {
            self.faults.raise(Error::new(
                ErrorKind::TooLarge,
                format!("{} is {value}; the limit is 2^32 - 1", (self.what)()),
            ))
        })
    }

    fn visit_i64<E: serde::de::Error>(self, value: i64) -> Result<u32, E> {
        if let Ok(value) = u64::try_from(value) {
            return self.visit_u64(value);
        }
        Err(self.faults.raise(
            Error::invalid(format!("{} is {value}; it cannot be negative", (self.what)()))
                .with_cure("number from 0"),
        ))
    }

    fn visit_f64<E: serde::de::Error>(self, value: f64) -> Result<u32, E> {
        Err(self.faults.raise(
            Error::invalid(format!("{} is {value}, not an integer of 32 bits", (self.what)()))
                .with_cure("write whole numbers from 0 to 2^32 - 1"),
        ))
    }
}

/// One facet, appended to `facets`; `vertices` is room to work in.
pub(super) struct Facet<'a> {
    pub(super) facets: &'a mut RaggedArray,
    pub(super) vertices: &'a mut Vec<u32>,
    pub(super) faults: &'a Faults,
}

impl<'de> DeserializeSeed<'de> for Facet<'_> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<(), D::Error> {
        deserializer.deserialize_seq(self)
    }
}

impl<'de> Visitor<'de> for Facet<'_> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "facet {}, a list of vertex numbers", self.facets.len())
    }

    fn visit_seq<A: SeqAccess<'de>>(mut self, list: A) -> Result<(), A::Error> {
        self.vertices.clear();
        self.finish(list)
    }
}

impl Facet<'_> {
    /// Reads the rest of a list whose first numbers are there, and appends the facet.
    fn finish<'de, A: SeqAccess<'de>>(&mut self, mut list: A) -> Result<(), A::Error> {
        let position = self.facets.len();
        let what = || format!("a vertex of facet {position}");
        while let Some(vertex) = list.next_element_seed(Number { what, faults: self.faults })? {
            self.vertices.push(vertex);
        }
        if self.vertices.is_empty() {
            return Err(self.faults.raise(
                Error::invalid(format!("facet {position} has no vertex; facets are numbered from 0"))
                    .with_cure("leave it out"),
            ));
        }
        if let Some(vertex) = repeated_vertex(self.vertices) {
            return Err(self.faults.raise(
                Error::invalid(format!(
                    "facet {position} repeats vertex {vertex}; facets are numbered from 0"
                ))
                .with_cure("a simplex has distinct vertices: remove the facet, or the repeated vertex"),
            ));
        }
        if self.facets.item_count() + self.vertices.len() > u32::MAX as usize {
            return Err(self.faults.raise(Error::new(
                ErrorKind::TooLarge,
                "the facets have more than 2^32 - 1 vertices in all",
            )));
        }
        self.facets.push(self.vertices);
        Ok(())
    }

    /// Reads a list that is a facet, which is appended, or a list of facets, which is returned.
    pub(super) fn or_list<'de, A: SeqAccess<'de>>(
        mut self,
        mut list: A,
    ) -> Result<Option<RaggedArray>, A::Error> {
        self.vertices.clear();
        let position = self.facets.len();
        let number = Number { what: || format!("a vertex of facet {position}"), faults: self.faults };
        let mut inner = RaggedArray::new();
        let facet = Facet { facets: &mut inner, vertices: self.vertices, faults: self.faults };
        match list.next_element_seed(NumberOrFacet { number, facet })? {
            Some(Some(vertex)) => {
                self.vertices.push(vertex);
                self.finish(list).map(|()| None)
            }
            Some(None) => {
                let (vertices, faults) = (self.vertices, self.faults);
                while list.next_element_seed(Facet { facets: &mut inner, vertices, faults })?.is_some() {}
                Ok(Some(inner))
            }
            None => self.finish(list).map(|()| None),
        }
    }
}

/// The first element of a list: a vertex of a facet, or the first facet of a list of them, which is appended.
struct NumberOrFacet<'a, W> {
    number: Number<'a, W>,
    facet: Facet<'a>,
}

impl<'de, W: Fn() -> String> DeserializeSeed<'de> for NumberOrFacet<'_, W> {
    type Value = Option<u32>;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Self::Value, D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de, W: Fn() -> String> Visitor<'de> for NumberOrFacet<'_, W> {
    type Value = Option<u32>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.number.expecting(f)
    }

    fn visit_u64<E: serde::de::Error>(self, value: u64) -> Result<Self::Value, E> {
        self.number.visit_u64(value).map(Some)
    }

    fn visit_i64<E: serde::de::Error>(self, value: i64) -> Result<Self::Value, E> {
        self.number.visit_i64(value).map(Some)
    }

    fn visit_f64<E: serde::de::Error>(self, value: f64) -> Result<Self::Value, E> {
        self.number.visit_f64(value).map(Some)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<Self::Value, A::Error> {
        self.facet.visit_seq(list).map(|()| None)
    }
}

/// A list of facets.
pub(super) struct FacetList<'a>(pub(super) &'a Faults);

impl<'de> DeserializeSeed<'de> for FacetList<'_> {
    type Value = RaggedArray;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<RaggedArray, D::Error> {
        deserializer.deserialize_seq(self)
    }
}

impl<'de> Visitor<'de> for FacetList<'_> {
    type Value = RaggedArray;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a list of facets")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<RaggedArray, A::Error> {
        let (mut facets, mut vertices) = (RaggedArray::new(), Vec::new());
        let faults = self.0;
        while list
            .next_element_seed(Facet { facets: &mut facets, vertices: &mut vertices, faults })?
            .is_some()
        {}
        Ok(facets)
    }
}

/// A list of halfedges; the name is the key that it stands under.
pub(super) struct HalfedgeList<'a> {
    pub(super) name: &'static str,
    pub(super) faults: &'a Faults,
}

impl<'de> DeserializeSeed<'de> for HalfedgeList<'_> {
    type Value = Vec<u32>;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Vec<u32>, D::Error> {
        deserializer.deserialize_seq(self)
    }
}

impl<'de> Visitor<'de> for HalfedgeList<'_> {
    type Value = Vec<u32>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "\"{}\", a list of halfedge numbers", self.name)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Vec<u32>, A::Error> {
        let mut halfedges = Vec::new();
        loop {
            let what = || format!("\"{}\" of halfedge {}", self.name, halfedges.len());
            match list.next_element_seed(Number { what, faults: self.faults })? {
                Some(halfedge) => halfedges.push(halfedge),
                None => return Ok(halfedges),
            }
        }
    }
}

/// The twins of halfedges; `null` and -1 stand for no twin.
pub(super) struct TwinList<'a>(pub(super) &'a Faults);

impl<'de> DeserializeSeed<'de> for TwinList<'_> {
    type Value = Vec<Option<u32>>;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Self::Value, D::Error> {
        deserializer.deserialize_seq(self)
    }
}

impl<'de> Visitor<'de> for TwinList<'_> {
    type Value = Vec<Option<u32>>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "\"twin\", a list of halfedge numbers, with null on the boundary")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Self::Value, A::Error> {
        let mut twins = Vec::new();
        while let Some(twin) = list.next_element::<Option<i64>>()? {
            let twin = match twin {
                None | Some(-1) => None,
                Some(number) => Some(u32::try_from(number).map_err(|_| {
                    let message = format!("\"twin\" of halfedge {} is {number}", twins.len());
                    let cure = "number from 0 to 2^32 - 1, and write null on the boundary";
                    self.0.raise(Error::invalid(message).with_cure(cure))
                })?),
            };
            twins.push(twin);
        }
        Ok(twins)
    }
}

/// The numbers of outer faces. What is no list of numbers is another key of that name, and is passed over.
pub(super) struct OuterFaces;

impl<'de> DeserializeSeed<'de> for OuterFaces {
    type Value = Vec<u32>;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Self::Value, D::Error> {
        let given: serde_json::Value = serde::Deserialize::deserialize(deserializer)?;
        Ok(serde_json::from_value(given).unwrap_or_default())
    }
}
