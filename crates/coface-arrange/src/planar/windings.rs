//! Winding numbers, carried from face to face across edges.

use super::faces::{Faces, NONE, Orbits};
use coface_algebra::{Error, ErrorKind};
use std::collections::BTreeMap;

/// For each face the regions with a winding number that is not zero, rising. Faces with the same numbers share a list:
/// there are few different ones, and a condition on them is asked once for each.
#[derive(Clone, Debug, Default)]
pub struct Windings {
    lists: WindingLists,
    /// The list of each bounded face.
    list_of_face: Vec<u32>,
    /// The halfedges across which bounded faces were entered first, each coming after that of the face that it leads
    /// from.
    entries: Vec<u32>,
}

impl Windings {
    /// The winding numbers around all faces, from those around the unbounded one, which are zero. `step` adds to a list
    /// how much more regions wind around what is left of a halfedge than around what is right of it.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] beyond 2^32 numbers.
    ///
    /// # Complexity
    /// Linear in the halfedges, and in the lengths of different lists.
    #[doc(hidden)]
    pub fn new(
        orbits: &Orbits,
        faces: &Faces,
        step: impl Fn(u32, &mut Vec<(u32, i32)>),
    ) -> Result<Self, Error> {
        let face_count = faces.orbits.len();
        let face_of = |halfedge: u32| faces.of_orbit[orbits.orbit_of[halfedge as usize] as usize];
        let mut found = Self {
            lists: WindingLists::default(),
            list_of_face: vec![NONE; face_count],
            entries: Vec::with_capacity(face_count),
        };
        let mut across_edge = Vec::new();
        // Faces are flooded from the unbounded one, those first that were entered first: what is asked about next is
        // known early, and along the front of the flood neighbors are near each other in memory.
        let (mut around, mut here) = (&faces.unbounded_orbits[..], 0);
        let mut next = 0;
        loop {
            for &halfedge in around.iter().flat_map(|&orbit| orbits.orbits.list(orbit as usize)) {
                let across = face_of(halfedge ^ 1);
                if across == NONE || found.list_of_face[across as usize] != NONE {
                    continue;
                }
                step(halfedge ^ 1, &mut across_edge);
                let mut list = here;
                for (region, by) in across_edge.drain(..) {
                    list = found.lists.after(list, region, by);
                }
                found.list_of_face[across as usize] = list;
                found.entries.push(halfedge ^ 1);
            }
            let Some(&entry) = found.entries.get(next) else { break };
            next += 1;
            let face = face_of(entry) as usize;
            (around, here) = (faces.orbits.list(face), found.list_of_face[face]);
        }
        if u32::try_from(found.lists.numbers.len()).is_err() {
            return Err(Error::new(ErrorKind::TooLarge, "more than 2^32 winding numbers"));
        }
        Ok(found)
    }

    /// The numbers around a face; none around the unbounded one.
    #[doc(hidden)]
    pub fn of_face(&self, face: u32) -> &[(u32, i32)] {
        match self.list_of_face.get(face as usize) {
            Some(&list) if list != NONE => self.lists.list(list),
            _ => &[],
        }
    }

    /// Whether the numbers around each bounded face satisfy a condition, and then whether no numbers do.
    pub(crate) fn where_satisfied(&self, condition: impl Fn(&[(u32, i32)]) -> bool) -> Vec<bool> {
        // What cannot be reached has the empty list, the first.
        let list_of = |&list: &u32| if list == NONE { 0 } else { list as usize };
        // On the way to a list there are others, which no face has.
        let mut is_used = vec![false; self.lists.len()];
        is_used[0] = true;
        self.list_of_face.iter().for_each(|list| is_used[list_of(list)] = true);
        let is_satisfied = |(list, is_used)| is_used && condition(self.lists.list(list));
        let of_list: Vec<bool> = (0..).zip(is_used).map(is_satisfied).collect();
        let mut found = Vec::with_capacity(self.list_of_face.len() + 1);
        found.extend(self.list_of_face.iter().map(|list| of_list[list_of(list)]));
        found.push(of_list[0]);
        found
    }

    /// The halfedges across which bounded faces were entered from others, the unbounded one first, each after that of
    /// the face it leads from.
    pub(crate) fn entries(&self) -> &[u32] {
        &self.entries
    }
}

/// Different lists of winding numbers, and which follows which. List 0 is empty.
#[derive(Clone, Debug)]
struct WindingLists {
    /// The numbers of one list after those of another.
    numbers: Vec<(u32, i32)>,
    /// Where each list begins, and where the last ends.
    starts: Vec<usize>,
    by_numbers: BTreeMap<Vec<(u32, i32)>, u32>,
    /// For each list what it becomes when a number is added for a region, as far as that has been asked; by rising
    /// regions.
    following: Vec<Vec<(u32, i32, u32)>>,
}

impl Default for WindingLists {
    fn default() -> Self {
        Self {
            numbers: Vec::new(),
            starts: vec![0, 0],
            by_numbers: BTreeMap::from([(Vec::new(), 0)]),
            following: vec![Vec::new()],
        }
    }
}

impl WindingLists {
    fn len(&self) -> usize {
        self.starts.len() - 1
    }

    fn list(&self, list: u32) -> &[(u32, i32)] {
        &self.numbers[self.starts[list as usize]..self.starts[list as usize + 1]]
    }

    /// The list with a number added for a region; zeros are left out.
    fn after(&mut self, list: u32, region: u32, by: i32) -> u32 {
        let known = self.following[list as usize].binary_search_by_key(&(region, by), |&(r, b, _)| (r, b));
        let place = match known {
            Ok(at) => return self.following[list as usize][at].2,
            Err(place) => place,
        };
        let mut numbers = self.list(list).to_vec();
        match numbers.binary_search_by_key(&region, |&(region, _)| region) {
            Ok(at) => {
                numbers[at].1 += by;
                if numbers[at].1 == 0 {
                    numbers.remove(at);
                }
            }
            Err(at) => numbers.insert(at, (region, by)),
        }
        let found = match self.by_numbers.get(&numbers) {
            Some(&found) => found,
            None => {
                let found = self.len() as u32;
                self.numbers.extend_from_slice(&numbers);
                self.starts.push(self.numbers.len());
                self.following.push(Vec::new());
                self.by_numbers.insert(numbers, found);
                found
            }
        };
        self.following[list as usize].insert(place, (region, by, found));
        found
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_numbers_are_one_list_on_whatever_way_they_come_about() {
        let mut lists = WindingLists::default();
        let mut at = 0;
        for (region, by) in [(5, 1), (2, -1), (5, 1), (2, 1)] {
            at = lists.after(at, region, by);
        }
        assert_eq!(lists.list(at), [(5, 2)]);
        assert_eq!(lists.after(0, 5, 2), at);
        let [one, other] = [[(5, 1), (2, -1)], [(2, -1), (5, 1)]]
            .map(|steps| steps.iter().fold(0, |list, &(region, by)| lists.after(list, region, by)));
        assert_eq!(one, other);
        assert_eq!(lists.list(one), [(2, -1), (5, 1)]);
        let back = lists.after(at, 5, -2);
        assert_eq!((back, lists.len()), (0, 6));
    }
}
