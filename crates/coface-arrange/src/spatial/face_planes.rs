//! The oriented plane of each face.

use super::PolygonalComplex;
use super::predicates::SpatialPredicates;
use coface_algebra::Sign;
use coface_algebra::{Error, VertexId};
use rayon::prelude::*;
use std::cmp::Ordering;

/// The plane of a face, by three of its vertices.
#[derive(Clone, Copy, Debug)]
pub(super) struct FacePlane {
    /// Vertices that run counterclockwise seen from the front of the face.
    pub(super) corners: [u32; 3],
    /// An axis that is not in the plane: seen along it no triangle of the plane is flat.
    axis: u8,
    /// Plus when the front is towards the far end of the axis.
    front: Sign,
}

impl FacePlane {
    /// Which way a triangle of the plane runs seen from the front: `Greater` for counterclockwise.
    pub(super) fn turn(&self, predicates: &impl SpatialPredicates, triangle: [u32; 3]) -> Ordering {
        let turn = predicates.normal_sign(usize::from(self.axis), triangle);
        if self.front == Sign::Plus { turn } else { turn.reverse() }
    }

    /// The same with the sign of the axis alone, for planes that are one but have different fronts.
    pub(super) fn turn_along_axis(
        &self,
        predicates: &impl SpatialPredicates,
        triangle: [u32; 3],
    ) -> Ordering {
        predicates.normal_sign(usize::from(self.axis), triangle)
    }
}

/// The lexicographic order of two vertices.
pub(super) fn lexicographic(predicates: &impl SpatialPredicates, a: u32, b: u32) -> Ordering {
    (0..3).map(|axis| predicates.compare(axis, a, b)).find(|order| order.is_ne()).unwrap_or(Ordering::Equal)
}

/// The planes of all faces: listed, or asked of predicates that know all of them.
pub(super) struct FacePlanes(Option<Vec<FacePlane>>);

impl FacePlanes {
    /// The planes of the faces of a complex.
    ///
    /// # Errors
    /// `InvalidInput` naming the first face that has no area, whose sides do not run around it, or that is not flat.
    pub(super) fn new(
        complex: &PolygonalComplex,
        predicates: &impl SpatialPredicates,
    ) -> Result<Self, Error> {
        let is_known = predicates.knows_planes();
        Ok(Self(if is_known { None } else { Some(face_planes(complex, predicates)?) }))
    }

    /// The plane of a face.
    pub(super) fn of(&self, predicates: &impl SpatialPredicates, face: usize) -> FacePlane {
        match &self.0 {
            Some(planes) => planes[face],
            None => known_plane(predicates, face as u32).expect("the planes of all faces are known"),
        }
    }
}

/// The planes of all faces.
///
/// At its lexicographically least vertex a face lies within a half turn, so the outermost two sides there are corners
/// of its outer walk, whatever the rest looks like; which of them leads away tells the front.
///
/// # Errors
/// `InvalidInput` naming the first face that has no area, whose sides do not run around it, or that is not flat.
fn face_planes(
    complex: &PolygonalComplex,
    predicates: &impl SpatialPredicates,
) -> Result<Vec<FacePlane>, Error> {
    let found: Vec<Result<FacePlane, Error>> = (0..complex.face_count())
        .into_par_iter()
        .map_init(Vec::new, |neighbors, face| face_plane(complex, predicates, face, neighbors))
        .collect();
    // In order, so that the error does not depend on threads.
    found.into_iter().collect()
}

fn face_plane(
    complex: &PolygonalComplex,
    predicates: &impl SpatialPredicates,
    face: usize,
    neighbors: &mut Vec<(u32, bool)>,
) -> Result<FacePlane, Error> {
    if let Some(plane) = known_plane(predicates, face as u32) {
        return Ok(plane);
    }
    let sides = complex.packed_sides().list(face);
    let tails = || sides.iter().map(|&side| complex.side_ends(side)[0]);
    let lowest = tails().min_by(|&a, &b| lexicographic(predicates, a, b)).expect("a face has sides");
    neighbors.clear();
    for &side in sides {
        let [from, to] = complex.side_ends(side);
        if from == lowest {
            neighbors.push((to, true));
        } else if to == lowest {
            neighbors.push((from, false));
        }
    }
    let start = neighbors[0];
    let crossing = neighbors[1..].iter().find_map(|&(other, _)| {
        (0..3).find(|&axis| predicates.normal_sign(axis, [lowest, start.0, other]).is_ne())
    });
    let Some(axis) = crossing else {
        return Err(Error::invalid(format!("face f{face} has no area at v{lowest}"))
            .with_cure("remove faces without area"));
    };
    let (mut first, mut last) = (start, start);
    for &(other, leads_away) in &neighbors[1..] {
        if predicates.normal_sign(axis, [lowest, first.0, other]).is_lt() {
            first = (other, leads_away);
        }
        if predicates.normal_sign(axis, [lowest, last.0, other]).is_gt() {
            last = (other, leads_away);
        }
    }
    if first.1 == last.1 {
        return Err(Error::invalid(format!("the sides of face f{face} do not run around it at v{lowest}"))
            .with_cure("let the outer walk run one way and holes the other"));
    }
    let (corners, front) = if first.1 {
        ([lowest, first.0, last.0], Sign::Plus)
    } else {
        ([lowest, last.0, first.0], Sign::Minus)
    };
    let [p, q, r] = corners;
    let off = tails()
        .find(|vertex| !corners.contains(vertex) && predicates.orientation([p, q, r, *vertex]).is_ne());
    if let Some(off) = off {
        let [p, q, r, off] = [p, q, r, off].map(VertexId::from_u32);
        return Err(Error::invalid(format!(
            "face f{face} is not flat: {off} is not in the plane of {p}, {q}, {r}"
        ))
        .with_cure("triangulate the face"));
    }
    Ok(FacePlane { corners, axis: axis as u8, front })
}

/// The plane of a face that the predicates know.
fn known_plane(predicates: &impl SpatialPredicates, face: u32) -> Option<FacePlane> {
    let corners = predicates.corners_of_plane(face)?;
    let (axis, front) = predicates.axis_of_plane(face).expect("the corners of a plane are not on one line");
    let front = if front.is_gt() { Sign::Plus } else { Sign::Minus };
    Some(FacePlane { corners, axis: axis as u8, front })
}
