//! Triangles of a mesh that meet where they should not.

use super::meetings::{Interest, meeting_faces};
use super::rings::{Points, Triangles};
use crate::spatial::{GivenPoints, SpatialPredicates};
use coface_algebra::{Error, ErrorKind};
use coface_geometry::Positions;

/// The pairs of triangles of a mesh that have points in common beside the vertices and sides that they share by number, rising, each
/// once. Only pairs of which one triangle at least is `new` are looked at; a triangle without an area meets itself.
///
/// Vertices with equal positions and different numbers are different: triangles that touch there meet. The search ends early when more than
/// four million pairs are found.
///
/// # Errors
/// [`ErrorKind::Shape`] for positions that are not points in space; [`ErrorKind::NotInComplex`] for a corner that is no vertex.
///
/// # Complexity
/// $O(n \log n + k)$ for n triangles and k pairs of them whose boxes meet.
///
/// # Examples
/// Two triangles that cross, and a third one that shares a side with the first.
/// ```
/// use coface_arrange::spatial::checks::meeting_triangles;
/// use coface_geometry::Positions;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let points = vec![0., 0., 0., 3., 0., 0., 0., 3., 0., 1., 1., -1., 1., 1., 1., 2., 2., 1., 0., 0., 3.];
/// let points = Positions::from_flat(3, points)?;
/// let triangles = [[0, 1, 2], [3, 4, 5], [0, 1, 6]];
/// assert_eq!(meeting_triangles(&points, &triangles, &|_| true)?, [[0, 1]]);
/// assert_eq!(meeting_triangles(&points, &triangles, &|triangle| triangle == 2)?.len(), 0);
/// # Ok(()) }
/// ```
pub fn meeting_triangles(
    positions: &Positions,
    triangles: &[[u32; 3]],
    new: &(dyn Fn(u32) -> bool + Sync),
) -> Result<Vec<[u32; 2]>, Error> {
    let predicates = GivenPoints::new(positions)?;
    if let Some(corner) = triangles.as_flattened().iter().find(|&&corner| corner as usize >= positions.len())
    {
        return Err(Error::new(
            ErrorKind::NotInComplex,
            format!("a triangle has the corner {corner}; there are {} points", positions.len()),
        ));
    }
    let points = Points {
        predicates,
        coordinates: positions.as_flat(),
        place: (0..positions.len() as u32).collect(),
        flatness: None,
    };
    let has_area = |&corners: &[u32; 3]| {
        let [a, b, c] = corners;
        let is_thick = a != b && b != c && c != a;
        is_thick && (0..3).any(|axis| points.predicates.normal_sign(axis, corners).is_ne())
    };
    let mut pairs = Vec::new();
    let mut sound = Triangles::default();
    for (number, corners) in (0u32..).zip(triangles) {
        if has_area(corners) {
            sound.corners.push(*corners);
            sound.face.push(number);
            sound.sides.push(7);
        } else if new(number) {
            pairs.push([number, number]);
        }
    }
    let interest = |a: u32, b: u32| if new(a) || new(b) { Interest::Touches } else { Interest::Nothing };
    let (found, _) = meeting_faces(&points, &sound, interest);
    pairs.extend(found.into_iter().map(|pair| pair.faces));
    pairs.sort_unstable();
    Ok(pairs)
}
