//! A walk through all faces: from the unbounded one across edges into each of the others, and back.

use super::faces::{Faces, NONE, Orbits};

/// What happens on the walk. An edge is crossed from what is right of the halfedge `across` to what is left of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[doc(hidden)]
pub enum Step {
    /// Into a bounded face for the first time.
    Into { face: u32, across: u32 },
    /// Back to the face from which this edge was crossed before; [`NONE`] for the unbounded one.
    Back { face: u32, across: u32 },
}

/// A face on the way from the unbounded one.
struct Visit {
    /// The halfedge of this face across which it was entered; none for the unbounded one.
    entered: u32,
    face: u32,
    /// The place of the next halfedge to look at: of its orbit around the face, and within the orbit.
    orbit: u32,
    at: u32,
}

/// Goes from the unbounded face through all others and back to it. Each edge that is crossed is crossed back later, so
/// what is added up across edges is right wherever the tour is, without a list for each face.
///
/// # Complexity
/// Linear in the halfedges; each bounded face is entered once.
pub(super) fn tour(orbits: &Orbits, faces: &Faces, mut step: impl FnMut(Step)) {
    let mut is_known = vec![false; faces.orbits.len()];
    let visit = |face: u32, entered: u32| Visit { entered, face, orbit: 0, at: 0 };
    let mut path = vec![visit(NONE, NONE)];
    while let Some(here) = path.last_mut() {
        let around = if here.face == NONE {
            &faces.unbounded_orbits[..]
        } else {
            faces.orbits.list(here.face as usize)
        };
        let mut found = None;
        while let Some(&orbit) = around.get(here.orbit as usize) {
            let halfedges = &orbits.orbits.list(orbit as usize)[here.at as usize..];
            let unknown = halfedges.iter().position(|&halfedge| {
                let across = faces.of_orbit[orbits.orbit_of[(halfedge ^ 1) as usize] as usize];
                across != NONE && !is_known[across as usize]
            });
            if let Some(place) = unknown {
                here.at += place as u32 + 1;
                found = Some(halfedges[place] ^ 1);
                break;
            }
            here.orbit += 1;
            here.at = 0;
        }
        if let Some(halfedge) = found {
            let face = faces.of_orbit[orbits.orbit_of[halfedge as usize] as usize];
            is_known[face as usize] = true;
            step(Step::Into { face, across: halfedge });
            path.push(visit(face, halfedge));
        } else {
            let entered = here.entered;
            path.pop();
            if let Some(before) = path.last() {
                step(Step::Back { face: before.face, across: entered ^ 1 });
            }
        }
    }
}
