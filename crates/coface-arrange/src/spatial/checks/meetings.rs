//! All pairs of faces that meet where they should not.

use super::containment::box_around;
use super::rings::{Points, Triangles};
use super::triangle_pairs::{Meeting, TrianglePairs};
use coface_geometry::{AxisBox, BoxTree};
use rayon::prelude::*;

/// With more pairs than this the search ends.
const MOST_PAIRS: usize = 4_000_000;
/// How many groups of boxes are searched before the pairs are counted.
const GROUPS_AT_ONCE: usize = 64;

/// Two faces that meet, the smaller number first, with a triangle of each.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct MeetingFaces {
    pub(super) faces: [u32; 2],
    pub(super) meeting: Meeting,
    pub(super) triangles: [u32; 2],
}

/// Which pairs of faces are looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Interest {
    /// None of it matters.
    Nothing,
    /// Only what crosses or overlaps.
    Crossings,
    /// What touches too.
    Touches,
    /// What touches too, in common vertices and edges or not.
    Contacts,
}

/// The pairs of faces that meet, rising, each once, and whether they are all.
///
/// Pairs of triangles whose boxes meet are found in a tree, and decided exactly.
pub(super) fn meeting_faces(
    points: &Points<'_>,
    triangles: &Triangles,
    interest: impl Fn(u32, u32) -> Interest + Sync,
) -> (Vec<MeetingFaces>, bool) {
    let boxes: Vec<AxisBox> =
        triangles.corners.par_iter().map(|&corners| box_around(points, corners)).collect();
    let tree = BoxTree::new(&boxes);
    let pairs = TrianglePairs::new(points, triangles);
    let of_group = |group: usize| {
        let mut found = Vec::new();
        tree.pairs_of_group(group, |t, u| {
            // From the lower face, so that the order of the tree does not matter.
            let [t, u] = if t < u { [t, u] } else { [u, t] };
            let faces = [t, u].map(|triangle| triangles.face[triangle as usize]);
            if faces[0] == faces[1] {
                return;
            }
            let interest = interest(faces[0], faces[1]);
            if interest == Interest::Nothing {
                return;
            }
            let wants_touch = matches!(interest, Interest::Touches | Interest::Contacts);
            let has_contact = || {
                let [first, second] = [t, u].map(|triangle| triangles.corners[triangle as usize]);
                interest == Interest::Contacts && first.iter().any(|corner| second.contains(corner))
            };
            let meeting = pairs.meeting(t as usize, u as usize, wants_touch);
            if let Some(meeting) = meeting.or_else(|| has_contact().then_some(Meeting::Touch)) {
                found.push(MeetingFaces { faces, meeting, triangles: [t, u] });
            }
        });
        found
    };
    let mut found = Vec::new();
    let mut is_complete = true;
    let groups = if boxes.is_empty() { 0 } else { tree.group_count() };
    for start in (0..groups).step_by(GROUPS_AT_ONCE) {
        let end = (start + GROUPS_AT_ONCE).min(groups);
        let lists: Vec<Vec<MeetingFaces>> = (start..end).into_par_iter().map(of_group).collect();
        lists.into_iter().for_each(|mut list| found.append(&mut list));
        if found.len() > MOST_PAIRS && end < groups {
            is_complete = false;
            break;
        }
    }
    found.par_sort_unstable();
    found.dedup_by_key(|pair| pair.faces);
    (found, is_complete)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spatial::GivenPoints;
    use coface_geometry::Positions;
    use proptest::prelude::*;

    proptest! {
        /// Triangles on a lattice, many of which share corners: the tree misses no pair and invents none.
        #[test]
        fn pairs_are_those_of_all_pairs(
            corners in prop::collection::vec(prop::array::uniform3(-3i32..4), 12..40),
            chosen in prop::collection::vec(prop::array::uniform3(0usize..100), 2..40),
        ) {
            let flat: Vec<f64> = corners.iter().flatten().map(|&x| f64::from(x)).collect();
            let positions = Positions::from_flat(3, flat).unwrap();
            let first = |i: usize| corners.iter().position(|other| *other == corners[i]).unwrap() as u32;
            let points = Points {
                predicates: GivenPoints::new(&positions).unwrap(),
                coordinates: positions.as_flat(),
                place: (0..corners.len()).map(first).collect(),
                flatness: None,
            };
            let mut triangles = Triangles::default();
            for own in chosen {
                let own = own.map(|i| first(i % corners.len()));
                let plane = own.map(|place| points.point(place));
                let is_flat = (0..3).all(|axis| {
                    let [a, b, c] = plane.map(|p| [p[(axis + 1) % 3], p[(axis + 2) % 3]]);
                    coface_geometry::predicates::orientation(a, b, c).is_eq()
                });
                if !is_flat {
                    triangles.face.push(triangles.corners.len() as u32);
                    triangles.corners.push(own);
                    triangles.sides.push(7);
                }
            }
            let (found, is_complete) = meeting_faces(&points, &triangles, |_, _| Interest::Touches);
            prop_assert!(is_complete);
            let pairs = TrianglePairs::new(&points, &triangles);
            let count = triangles.corners.len();
            let all = (0..count).flat_map(|t| (t + 1..count).map(move |u| [t, u]));
            let expected: Vec<([u32; 2], Meeting)> = all
                .filter_map(|[t, u]| Some(([t as u32, u as u32], pairs.meeting(t, u, true)?)))
                .collect();
            let found: Vec<([u32; 2], Meeting)> = found.into_iter().map(|pair| (pair.faces, pair.meeting)).collect();
            prop_assert_eq!(found, expected);
        }
    }
}
