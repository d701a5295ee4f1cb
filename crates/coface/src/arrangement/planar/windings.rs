//! Winding numbers, carried from face to face across edges.

use super::faces::{Faces, NONE, Orbits};
use super::tour::{Step, tour};
use crate::{Error, ErrorKind};

/// For each face the regions with a winding number that is not zero, rising.
#[derive(Clone, Debug, Default)]
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
        let (mut across_edge, mut here) = (Vec::new(), Vec::new());
        tour(orbits, faces, |at| match at {
            Step::Into { face, across } => {
                step(across, &mut across_edge);
                across_edge.drain(..).for_each(|(region, by)| add(&mut here, region, by));
                if u32::try_from(found.numbers.len()).is_ok() {
                    let start = found.numbers.len();
                    found.numbers.extend_from_slice(&here);
                    found.ranges[face as usize] = [start, found.numbers.len()].map(|at| at as u32);
                }
            }
            Step::Back { face, .. } => {
                here.clear();
                here.extend_from_slice(found.of_face(face));
            }
        });
        if u32::try_from(found.numbers.len()).is_err() {
            return Err(Error::new(ErrorKind::TooLarge, "more than 2^32 winding numbers"));
        }
        Ok(found)
    }

    /// The numbers around a face; none around the unbounded one.
    pub(crate) fn of_face(&self, face: u32) -> &[(u32, i32)] {
        match self.ranges.get(face as usize) {
            Some(&[start, end]) if start != NONE => &self.numbers[start as usize..end as usize],
            _ => &[],
        }
    }
}

/// Adds to the number of a region in a list that rises; zeros are left out.
fn add(windings: &mut Vec<(u32, i32)>, region: u32, by: i32) {
    match windings.binary_search_by_key(&region, |&(region, _)| region) {
        Ok(at) => {
            windings[at].1 += by;
            if windings[at].1 == 0 {
                windings.remove(at);
            }
        }
        Err(at) => windings.insert(at, (region, by)),
    }
}
