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

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<(), A::Error> {
        let position = self.facets.len();
        self.vertices.clear();
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
