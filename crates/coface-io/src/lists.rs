//! Polygons, lines and points as they are read, grown piece by piece.

use crate::Place;
use crate::model::repeated_vertex;
use crate::oddities::{Oddities, Oddity, without_repetition};
use coface_algebra::RaggedArray;
use coface_algebra::{Error, ErrorKind, VertexId};

/// A list of lists that grows: ends are written down only once two lengths differ.
#[derive(Debug, Default)]
pub(crate) struct Lists {
    items: Vec<u32>,
    /// The end of each list, once they differ in length.
    ends: Option<Vec<u32>>,
    /// The length of the first list.
    width: usize,
    count: usize,
}

impl Lists {
    pub(crate) fn len(&self) -> usize {
        self.count
    }

    /// The items of the lists, and of the list that is being made.
    pub(crate) fn items_mut(&mut self) -> &mut Vec<u32> {
        &mut self.items
    }

    /// The number of items in the finished lists.
    fn finished(&self) -> usize {
        match &self.ends {
            Some(ends) => ends.last().map_or(0, |&end| end as usize),
            None => self.width * self.count,
        }
    }

    /// The list that is being made: what was pushed to the items since the last one was finished.
    pub(crate) fn open(&self) -> &[u32] {
        &self.items[self.finished()..]
    }

    /// Drops the list that is being made.
    pub(crate) fn abandon(&mut self) {
        self.items.truncate(self.finished());
    }

    /// Ends the list that is being made; at most 2^32 - 1 items in all, which [`Self::append`] and
    /// [`Self::into_ragged`] check.
    pub(crate) fn finish(&mut self) {
        let length = self.items.len() - self.finished();
        if self.count == 0 {
            self.width = length;
        } else if length != self.width {
            let (width, count) = (self.width, self.count);
            self.ends.get_or_insert_with(|| (1..=count).map(|i| (i * width) as u32).collect());
        }
        if let Some(ends) = &mut self.ends {
            ends.push(self.items.len() as u32);
        }
        self.count += 1;
    }

    pub(crate) fn push(&mut self, list: &[u32]) {
        self.items.extend_from_slice(list);
        self.finish();
    }

    /// Appends a list of three, which is the usual one.
    #[inline]
    pub(crate) fn push_triangle(&mut self, triangle: [u32; 3]) {
        self.items.extend_from_slice(&triangle);
        if self.width == 3 && self.ends.is_none() && self.count > 0 {
            self.count += 1;
        } else {
            self.finish();
        }
    }

    /// Appends lists of three, at most `most`, and gives their number.
    pub(crate) fn push_triangles(&mut self, most: usize, triangles: impl Iterator<Item = [u32; 3]>) -> usize {
        if self.ends.is_some() || (self.count > 0 && self.width != 3) {
            return triangles.take(most).map(|triangle| self.push_triangle(triangle)).count();
        }
        let start = self.items.len();
        self.items.resize(start + 3 * most, 0);
        let mut pushed = 0;
        for (room, triangle) in self.items[start..].chunks_exact_mut(3).zip(triangles) {
            room.copy_from_slice(&triangle);
            pushed += 1;
        }
        self.items.truncate(start + 3 * pushed);
        if pushed > 0 {
            self.width = 3;
        }
        self.count += pushed;
        pushed
    }

    /// Appends the lists of another.
    pub(crate) fn append(&mut self, other: &Self) -> Result<(), Error> {
        if self.items.len() + other.items.len() > u32::MAX as usize {
            return Err(too_many());
        }
        if self.count == 0 {
            self.width = other.width;
        }
        let differ = other.count > 0 && (other.ends.is_some() || other.width != self.width);
        if differ || self.ends.is_some() {
            let (width, count, base) = (self.width, self.count, self.items.len() as u32);
            let ends = self.ends.get_or_insert_with(|| (1..=count).map(|i| (i * width) as u32).collect());
            match &other.ends {
                Some(added) => ends.extend(added.iter().map(|end| base + end)),
                None => ends.extend((1..=other.count).map(|i| base + (i * other.width) as u32)),
            }
        }
        self.items.extend_from_slice(&other.items);
        self.count += other.count;
        Ok(())
    }

    pub(crate) fn into_ragged(self) -> Result<RaggedArray, Error> {
        if self.items.len() > u32::MAX as usize {
            return Err(too_many());
        }
        match self.ends {
            None if self.width > 0 => RaggedArray::uniform(self.width, self.items),
            None => Ok(RaggedArray::new()),
            Some(ends) => {
                let starts = std::iter::once(0).chain(ends).collect();
                RaggedArray::from_parts(starts, self.items)
            }
        }
    }
}

/// Numbers things by their first equals, in order: `firsts[i]` is the first thing that equals thing i, and becomes its
/// number. The first of each number is given back.
pub(crate) fn number_by_firsts(firsts: &mut [u32]) -> Vec<u32> {
    let mut own = Vec::new();
    for i in 0..firsts.len() {
        let first = firsts[i] as usize;
        if first == i {
            firsts[i] = own.len() as u32;
            own.push(i as u32);
        } else {
            // The first comes before, so it has its number already.
            firsts[i] = firsts[first];
        }
    }
    own
}

fn too_many() -> Error {
    Error::new(ErrorKind::TooLarge, "the polygons or lines name more than 2^32 - 1 vertices in all")
}

/// Polygons, lines and points in the order of the file: lists of three or more vertices, of two, of one.
#[derive(Debug, Default)]
pub(crate) struct Elements {
    pub(crate) polygons: Lists,
    pub(crate) lines: Lists,
    pub(crate) points: Vec<VertexId>,
}

impl Elements {
    /// Whether there is none.
    pub(crate) fn is_empty(&self) -> bool {
        self.polygons.len() == 0 && self.lines.len() == 0 && self.points.is_empty()
    }

    /// Sorts the open list of the polygons in by its length: one vertex is a point, two are a line.
    pub(crate) fn finish(&mut self) {
        match *self.polygons.open() {
            [] => {}
            [vertex] => {
                self.points.push(VertexId::from_u32(vertex));
                self.polygons.abandon();
            }
            [from, to] => {
                self.lines.push(&[from, to]);
                self.polygons.abandon();
            }
            _ => self.polygons.finish(),
        }
    }

    /// Sorts the open list of the polygons in, without its repetitions; if they leave too little of it, it is left out.
    pub(crate) fn finish_face(&mut self, oddities: &mut Oddities, place: Place) {
        let face = self.polygons.open();
        let has_repetition = match *face {
            [a, b, c] => a == b || b == c || c == a,
            _ => repeated_vertex(face).is_some(),
        };
        if face.is_empty() || has_repetition {
            let distinct = without_repetition(face);
            let place = || Place { cell: Some(face.to_vec()), ..place };
            if distinct.len() < 3 {
                oddities.note(Oddity::Collapsed, place);
                self.polygons.abandon();
                return;
            }
            oddities.note(Oddity::Repeated, place);
            self.polygons.abandon();
            self.polygons.items_mut().extend_from_slice(&distinct);
        }
        self.finish();
    }

    pub(crate) fn append(&mut self, other: &Self) -> Result<(), Error> {
        self.polygons.append(&other.polygons)?;
        self.lines.append(&other.lines)?;
        self.points.extend_from_slice(&other.points);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn lists_grown_in_pieces_are_the_lists(lists in proptest::collection::vec(proptest::collection::vec(0..9u32, 1..5), 0..12), cut in 0..12usize, triangles in proptest::collection::vec([0..9u32, 0..9, 0..9], 0..3)) {
            let cut = cut.min(lists.len());
            let mut whole = Lists::default();
            for piece in [&lists[..cut], &lists[cut..]] {
                let mut part = Lists::default();
                for list in piece {
                    part.items_mut().push(99);
                    part.abandon();
                    part.push(list);
                }
                // Triangles in bulk are triangles one by one.
                let mut bulk = Lists::default();
                bulk.append(&part).unwrap();
                for &triangle in &triangles {
                    part.push(&triangle);
                }
                prop_assert_eq!(bulk.push_triangles(triangles.len(), triangles.iter().copied()), triangles.len());
                prop_assert_eq!(bulk.push_triangles(2, [[1, 2, 3]].into_iter().filter(|_| false)), 0);
                prop_assert_eq!((bulk.items, bulk.ends, bulk.count), (part.items.clone(), part.ends.clone(), part.count));
                whole.append(&part).unwrap();
            }
            let piece = |lists: &[Vec<u32>]| lists.iter().cloned().chain(triangles.iter().map(|t| t.to_vec())).collect::<Vec<_>>();
            let expected = [piece(&lists[..cut]), piece(&lists[cut..])].concat();
            prop_assert_eq!(whole.len(), expected.len());
            prop_assert_eq!(whole.into_ragged().unwrap(), RaggedArray::from_lists(&expected));
        }
    }
}
