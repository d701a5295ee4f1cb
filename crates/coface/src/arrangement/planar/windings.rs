//! Winding numbers, carried from face to face across edges.

use super::faces::{Faces, NONE, Orbits};
use crate::{Error, ErrorKind};

/// For each face the regions with a winding number that is not zero, rising.
#[derive(Clone, Debug)]
pub(crate) struct Windings {
    numbers: Vec<(u32, i32)>,
    /// Where the list of each face begins and ends.
    ranges: Vec<[u32; 2]>,
}

impl Windings {
    /// The winding numbers around all faces, from those around the unbounded one, which are zero. `step` adds to a list how much
    /// more regions wind around what is left of a halfedge than around what is right of it.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] beyond 2^32 numbers.
    pub(crate) fn new(
        orbits: &Orbits,
        faces: &Faces,
        step: impl Fn(u32, &mut Vec<(u32, i32)>),
    ) -> Result<Self, Error> {
        let mut found = Self { numbers: Vec::new(), ranges: vec![[NONE; 2]; faces.orbits.len()] };
        let mut stack = vec![NONE];
        let (mut across_edge, mut here) = (Vec::new(), Vec::new());
        while let Some(face) = stack.pop() {
            here.clear();
            here.extend_from_slice(found.of_face(face));
            let around =
                if face == NONE { &faces.unbounded_orbits[..] } else { faces.orbits.list(face as usize) };
            for &halfedge in around.iter().flat_map(|&orbit| orbits.orbits.list(orbit as usize)) {
                let across = faces.of_orbit[orbits.orbit_of[(halfedge ^ 1) as usize] as usize];
                if across == NONE || found.ranges[across as usize] != [NONE; 2] {
                    continue;
                }
                across_edge.clear();
                step(halfedge ^ 1, &mut across_edge);
                across_edge.sort_unstable();
                let start = found.numbers.len();
                add(&here, &across_edge, &mut found.numbers);
                let end = found.numbers.len();
                if u32::try_from(end).is_err() {
                    return Err(Error::new(ErrorKind::TooLarge, "more than 2^32 winding numbers"));
                }
                found.ranges[across as usize] = [start, end].map(|at| at as u32);
                stack.push(across);
            }
        }
        Ok(found)
    }

    /// The numbers around a face; none around the unbounded one.
    pub(crate) fn of_face(&self, face: u32) -> &[(u32, i32)] {
        match self.ranges.get(face as usize) {
            Some(&[start, end]) => &self.numbers[start as usize..end as usize],
            None => &[],
        }
    }
}

/// Appends the sum of two lists that rise by region; both may have regions more than once. Zeros are left out.
fn add(a: &[(u32, i32)], b: &[(u32, i32)], sum: &mut Vec<(u32, i32)>) {
    let start = sum.len();
    let (mut i, mut j) = (0, 0);
    while i < a.len() || j < b.len() {
        let from_a = j == b.len() || (i < a.len() && a[i].0 <= b[j].0);
        let (region, winding) = if from_a { a[i] } else { b[j] };
        if from_a {
            i += 1;
        } else {
            j += 1;
        }
        // A number that has become zero makes room for the next region.
        if sum.len() > start && sum[sum.len() - 1].0 == region {
            let last = sum.len() - 1;
            sum[last].1 += winding;
        } else {
            if sum.len() > start && sum[sum.len() - 1].1 == 0 {
                sum.pop();
            }
            sum.push((region, winding));
        }
    }
    if sum.len() > start && sum[sum.len() - 1].1 == 0 {
        sum.pop();
    }
}
