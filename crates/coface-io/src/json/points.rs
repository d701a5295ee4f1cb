//! Lists of points.

use coface_algebra::{Error, ErrorKind};
use coface_geometry::Positions;
use serde::de::{DeserializeSeed, Deserializer, IgnoredAny, MapAccess, SeqAccess, Visitor};
use std::fmt;

/// The points under `"vertices"`, or the first fault in them.
///
/// A fault waits: the key has other meanings in files that give no boundaries, where it is passed over.
#[derive(Default)]
pub(super) struct PointList {
    dimension: usize,
    coordinates: Vec<f64>,
    count: usize,
    fault: Option<Error>,
}

impl PointList {
    /// The points as positions.
    pub(super) fn into_positions(self) -> Result<Positions, Error> {
        match self.fault {
            Some(fault) => Err(fault.with_cure("give a list of points, each a list of as many coordinates")),
            None => Positions::from_flat(self.dimension, self.coordinates),
        }
    }

    /// The points as positions; none where the key has another meaning.
    pub(super) fn into_list(self) -> Option<Positions> {
        let positions = self.into_positions().ok()?;
        (!positions.is_empty()).then_some(positions)
    }

    fn fault(&mut self, message: impl FnOnce() -> String) {
        self.fault.get_or_insert_with(|| Error::new(ErrorKind::InvalidInput, message()));
    }

    /// A point of so many coordinates has been read.
    fn end_point(&mut self, width: usize) {
        let (count, dimension) = (self.count, self.dimension);
        if width == 0 {
            self.fault(|| format!("point {count} of \"vertices\" has no coordinates"));
        } else if count > 0 && width != dimension {
            self.fault(|| {
                format!(
                    "point {count} of \"vertices\" has {width} coordinates, but those before it have {dimension}"
                )
            });
        }
        self.dimension = if count == 0 { width } else { dimension };
        self.count += 1;
    }
}

/// The level of a value: the list of points, a point, a coordinate.
#[derive(Clone, Copy)]
enum Level {
    List,
    Point,
    Coordinate { axis: usize },
}

/// Reads a value of any kind into the list; what is no point is a fault of the list, not of the parser.
struct Reader<'a> {
    list: &'a mut PointList,
    level: Level,
}

/// Reads what stands under `"vertices"`.
pub(super) struct Points;

impl<'de> DeserializeSeed<'de> for Points {
    type Value = PointList;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<PointList, D::Error> {
        let mut list = PointList::default();
        Reader { list: &mut list, level: Level::List }.deserialize(deserializer)?;
        Ok(list)
    }
}

impl Reader<'_> {
    fn number(self, value: f64) {
        match self.level {
            Level::Coordinate { .. } if self.list.fault.is_none() => self.list.coordinates.push(value),
            Level::Coordinate { .. } => {}
            _ => self.wrong("a number"),
        }
    }

    fn wrong(self, what: &str) {
        let count = self.list.count;
        match self.level {
            Level::List => self.list.fault(|| format!("\"vertices\" is {what}, not a list of points")),
            Level::Point => {
                self.list
                    .fault(|| format!("point {count} of \"vertices\" is {what}, not a list of coordinates"));
            }
            Level::Coordinate { axis } => self.list.fault(|| {
                format!("coordinate {axis} of point {count} of \"vertices\" is {what}, not a number")
            }),
        }
    }
}

impl<'de> DeserializeSeed<'de> for Reader<'_> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<(), D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Reader<'_> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a list of points")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut elements: A) -> Result<(), A::Error> {
        match self.level {
            Level::List => {
                while elements
                    .next_element_seed(Reader { list: &mut *self.list, level: Level::Point })?
                    .is_some()
                {}
            }
            Level::Point => {
                let mut axis = 0;
                while elements
                    .next_element_seed(Reader { list: &mut *self.list, level: Level::Coordinate { axis } })?
                    .is_some()
                {
                    axis += 1;
                }
                self.list.end_point(axis);
            }
            Level::Coordinate { .. } => {
                while elements.next_element::<IgnoredAny>()?.is_some() {}
                self.wrong("a list");
            }
        }
        Ok(())
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<(), A::Error> {
        while map.next_entry::<IgnoredAny, IgnoredAny>()?.is_some() {}
        self.wrong("an object");
        Ok(())
    }

    fn visit_f64<E: serde::de::Error>(self, value: f64) -> Result<(), E> {
        self.number(value);
        Ok(())
    }

    fn visit_i64<E: serde::de::Error>(self, value: i64) -> Result<(), E> {
        self.number(value as f64);
        Ok(())
    }

    fn visit_u64<E: serde::de::Error>(self, value: u64) -> Result<(), E> {
        self.number(value as f64);
        Ok(())
    }

    fn visit_str<E: serde::de::Error>(self, _: &str) -> Result<(), E> {
        self.wrong("a text");
        Ok(())
    }

    fn visit_bool<E: serde::de::Error>(self, _: bool) -> Result<(), E> {
        self.wrong("a truth value");
        Ok(())
    }

    fn visit_unit<E: serde::de::Error>(self) -> Result<(), E> {
        self.wrong("null");
        Ok(())
    }
}
