//! What stands under `"coordinates"`.

use crate::drawing::{Drawing, Place};
use coface_algebra::Error;
use serde::de::{DeserializeSeed, Deserializer, SeqAccess, Visitor};
use std::fmt;

/// Positions in lists of lists, flat. Lists that are empty are left out.
#[derive(Debug, Default)]
pub(super) struct Coordinates {
    places: Vec<Place>,
    /// Positions with more than three numbers.
    surplus: usize,
    /// `ends[0]` are the ends of the lists of positions, `ends[1]` those of lists of these, `ends[2]` of lists of these.
    ends: [Vec<u32>; 3],
    /// 1 for a position, 2 for a list of positions, and so on; `None` if there is nothing.
    level: Option<usize>,
    /// The numbers of the position that is being read, and how many there are.
    open: [f64; 3],
    count: usize,
}

impl Coordinates {
    /// How deep the lists are: 1 for a position, 2 for a list of positions, and so on; `None` if there is nothing.
    pub(super) fn level(&self) -> Option<usize> {
        self.level
    }

    /// Each position is a point.
    pub(super) fn draw_points(&self, drawing: &mut Drawing) {
        self.note_surplus(drawing);
        for &place in &self.places {
            drawing.point(place);
        }
    }

    /// All positions, or each list of them, are a line; `name` says what they are.
    pub(super) fn draw_lines(&self, drawing: &mut Drawing, name: &str) {
        self.note_surplus(drawing);
        for range in ranges(&self.ends[0], 0..self.ends[0].len()) {
            for &place in &self.places[range] {
                drawing.corner(place);
            }
            drawing.end_line(|| name.to_owned());
        }
    }

    /// All lists of positions, or each list of such, are the rings of a polygon. They must be closed unless they are to be
    /// closed here.
    pub(super) fn draw_polygons(
        &self,
        drawing: &mut Drawing,
        name: &str,
        to_close: bool,
    ) -> Result<(), Error> {
        self.note_surplus(drawing);
        for polygon in ranges(&self.ends[1], 0..self.ends[1].len()) {
            drawing.begin_polygon();
            for range in ranges(&self.ends[0], polygon) {
                let places = &self.places[range];
                for &place in places.iter().chain(places.first().filter(|_| to_close)) {
                    drawing.corner(place);
                }
                drawing.end_ring(|| format!("a ring of {name}"));
            }
        }
        Ok(())
    }

    fn note_surplus(&self, drawing: &mut Drawing) {
        for _ in 0..self.surplus {
            drawing.note_surplus();
        }
    }

    fn number(&mut self, value: f64) {
        if let Some(place) = self.open.get_mut(self.count) {
            *place = value;
        }
        self.count += 1;
    }

    /// The numbers of a position have been read.
    fn end_place(&mut self) -> Result<(), String> {
        let count = std::mem::take(&mut self.count);
        if count < 2 {
            return Err(format!("position {} has one number; it needs two", self.places.len()));
        }
        let [x, y, z] = self.open;
        self.surplus += usize::from(count > 3);
        self.places.push(Place { x, y, z: (count > 2).then_some(z) });
        Ok(())
    }

    /// A list of things of this level has been read.
    fn end_list(&mut self, level: usize) -> Result<(), String> {
        let length = match level {
            1 => self.places.len(),
            2 | 3 => self.ends[level - 2].len(),
            _ => return Err("lists are nested too deep".to_owned()),
        };
        let end = u32::try_from(length).map_err(|_| "there are more than 2^32 - 1 positions".to_owned())?;
        self.ends[level - 1].push(end);
        Ok(())
    }
}

/// The ranges of these lists, of which the ends are given.
fn ranges(ends: &[u32], lists: std::ops::Range<usize>) -> impl Iterator<Item = std::ops::Range<usize>> + '_ {
    lists.map(|i| if i == 0 { 0 } else { ends[i - 1] as usize }..ends[i] as usize)
}

/// Reads coordinates of any depth.
pub(super) struct Nested;

impl<'de> DeserializeSeed<'de> for Nested {
    type Value = Coordinates;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Coordinates, D::Error> {
        let mut coordinates = Coordinates::default();
        coordinates.level = Node(&mut coordinates).deserialize(deserializer)?;
        Ok(coordinates)
    }
}

impl Nested {
    /// Reads coordinates from a list whose bracket is open.
    pub(super) fn of_list<'de, A: SeqAccess<'de>>(list: A) -> Result<Coordinates, A::Error> {
        let mut coordinates = Coordinates::default();
        coordinates.level = Node(&mut coordinates).visit_seq(list)?;
        Ok(coordinates)
    }
}

/// A value in the lists: gives its level, 0 for a number, or `None` if it is empty.
struct Node<'a>(&'a mut Coordinates);

impl<'de> DeserializeSeed<'de> for Node<'_> {
    type Value = Option<usize>;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Self::Value, D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Node<'_> {
    type Value = Option<usize>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number or a list of coordinates")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Self::Value, A::Error> {
        use serde::de::Error as _;
        let mut level = None;
        while let Some(next) = list.next_element_seed(Node(&mut *self.0))? {
            match (level, next) {
                (_, None) => {}
                (None, Some(_)) => level = next,
                (Some(known), Some(next)) if known == next => {}
                _ => {
                    return Err(A::Error::custom(
                        "numbers and lists of them stand in one list of coordinates",
                    ));
                }
            }
        }
        match level {
            None => return Ok(None),
            Some(0) => self.0.end_place(),
            Some(level) => self.0.end_list(level),
        }
        .map_err(A::Error::custom)?;
        Ok(level.map(|level| level + 1))
    }

    fn visit_f64<E: serde::de::Error>(self, value: f64) -> Result<Self::Value, E> {
        self.0.number(value);
        Ok(Some(0))
    }

    fn visit_i64<E: serde::de::Error>(self, value: i64) -> Result<Self::Value, E> {
        self.visit_f64(value as f64)
    }

    fn visit_u64<E: serde::de::Error>(self, value: u64) -> Result<Self::Value, E> {
        self.visit_f64(value as f64)
    }
}
