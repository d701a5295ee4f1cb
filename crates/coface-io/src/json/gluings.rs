//! Gluing tables.

use super::facets::Number;
use super::faults::Faults;
use coface_algebra::{Error, ErrorKind};
use coface_complexes::gluing::{GluingTable, different_rows, no_permutation};
use serde::de::{DeserializeSeed, Deserializer, SeqAccess, Visitor};
use std::fmt;

/// The width of a row that is not known before the first; the table of no rows has dimension 3.
const WIDTH_OF_NOTHING: usize = 4;

/// The list of rows, one for each simplex.
pub(super) struct GluingList<'a>(pub(super) &'a Faults);

impl<'de> DeserializeSeed<'de> for GluingList<'_> {
    type Value = GluingTable;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<GluingTable, D::Error> {
        deserializer.deserialize_seq(self)
    }
}

impl<'de> Visitor<'de> for GluingList<'_> {
    type Value = GluingTable;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("\"gluings\", a list with the gluings of the facets of each simplex")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<GluingTable, A::Error> {
        let faults = self.0;
        let mut table = Flat::default();
        while list.next_element_seed(Row { table: &mut table, faults })?.is_some() {
            table.rows += 1;
        }
        let width = table.neighbors.len().checked_div(table.rows).unwrap_or(WIDTH_OF_NOTHING);
        GluingTable::from_flat(width, table.neighbors, table.images).map_err(|error| faults.raise(error))
    }
}

/// The rows read so far.
#[derive(Default)]
struct Flat {
    rows: usize,
    neighbors: Vec<Option<u32>>,
    images: Vec<u8>,
    /// The facets of the row being read, and room for the images of one facet.
    row: Vec<(Option<u32>, Vec<u32>)>,
}

/// The gluings of the facets of one simplex.
struct Row<'a> {
    table: &'a mut Flat,
    faults: &'a Faults,
}

impl<'de> DeserializeSeed<'de> for Row<'_> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<(), D::Error> {
        deserializer.deserialize_seq(self)
    }
}

impl<'de> Visitor<'de> for Row<'_> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "the gluings of simplex {}, a list with null or [neighbor, [images of vertices]]",
            self.table.rows
        )
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<(), A::Error> {
        let Self { table, faults } = self;
        let simplex = table.rows;
        table.row.clear();
        while let Some(gluing) = list.next_element_seed(Facet { simplex, facet: table.row.len(), faults })? {
            table.row.push(match gluing {
                Some((neighbor, images)) => (Some(neighbor), images),
                None => (None, Vec::new()),
            });
        }
        let length = table.row.len();
        let width = table.neighbors.len().checked_div(simplex).unwrap_or(length);
        if length != width {
            return Err(faults.raise(different_rows(simplex, length, width)));
        }
        for (facet, (neighbor, images)) in table.row.iter().enumerate() {
            table.neighbors.push(*neighbor);
            if neighbor.is_none() {
                table.images.resize(table.images.len() + width, 0);
            } else if images.len() == width && images.iter().all(|&image| (image as usize) < width.min(256)) {
                table.images.extend(images.iter().map(|&image| image as u8));
            } else {
                return Err(faults.raise(no_permutation(simplex, facet, images, width - 1)));
            }
        }
        Ok(())
    }
}

/// The gluing of one facet.
struct Facet<'a> {
    simplex: usize,
    facet: usize,
    faults: &'a Faults,
}

impl Facet<'_> {
    fn name(&self) -> String {
        format!("facet {} of simplex {}", self.facet, self.simplex)
    }
}

impl<'de> DeserializeSeed<'de> for Facet<'_> {
    type Value = Option<(u32, Vec<u32>)>;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Self::Value, D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Facet<'_> {
    type Value = Option<(u32, Vec<u32>)>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the gluing of {}, null or [neighbor, [images of vertices]]", self.name())
    }

    fn visit_unit<E>(self) -> Result<Self::Value, E> {
        Ok(None)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Self::Value, A::Error> {
        let faults = self.faults;
        let what = || format!("the neighbor at {}", self.name());
        let neighbor = list.next_element_seed(Number { what, faults })?;
        let images = list.next_element_seed(Images { name: self.name(), faults })?;
        match (neighbor, images, list.next_element::<serde::de::IgnoredAny>()?) {
            (Some(neighbor), Some(images), None) => Ok(Some((neighbor, images))),
            _ => Err(faults.raise(
                Error::new(ErrorKind::Parse, format!("the gluing of {} is no pair", self.name()))
                    .with_cure("write [neighbor, [images of vertices]], or null on the boundary"),
            )),
        }
    }
}

/// The images of the vertices.
struct Images<'a> {
    name: String,
    faults: &'a Faults,
}

impl<'de> DeserializeSeed<'de> for Images<'_> {
    type Value = Vec<u32>;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Vec<u32>, D::Error> {
        deserializer.deserialize_seq(self)
    }
}

impl<'de> Visitor<'de> for Images<'_> {
    type Value = Vec<u32>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the images of the vertices at {}, a list", self.name)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Vec<u32>, A::Error> {
        let mut images = Vec::new();
        let what = || format!("an image of a vertex at {}", self.name);
        while let Some(image) = list.next_element_seed(Number { what, faults: self.faults })? {
            images.push(image);
        }
        Ok(images)
    }
}
