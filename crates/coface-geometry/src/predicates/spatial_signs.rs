//! Orientations of triangles and tetrahedra of points in space, given or defined by intersections.

use super::arithmetic::{Arithmetic, cross, cross_coordinate, dot};
use super::common_line::CommonLine;
use super::double_double::Approximation;
use super::estimate::Estimate;
use super::short_dyadic::ShortDyadic;
use super::spatial_point::{Coordinates, SpatialPoint};
use super::spatial_quotient::sign_over;
use super::{Dyadic, orientation, spatial_orientation};
use std::cmp::Ordering;

/// Which way a triangle runs seen from the far end of an axis, exactly: the sign of that coordinate of
/// $(b - a) \times (c - a)$, `Greater` for counterclockwise.
///
/// # Panics
/// If `axis` is not below 3.
///
/// # Examples
/// ```
/// use coface_geometry::predicates::{SpatialPoint, normal_sign};
/// use std::cmp::Ordering;
/// let [a, b, c] = [[0., 0., 0.], [3., 0., 1.], [0., 2., 5.]].map(SpatialPoint::given);
/// assert_eq!(normal_sign(2, [&a, &b, &c]), Ordering::Greater);
/// assert_eq!(normal_sign(2, [&a, &c, &b]), Ordering::Less);
/// ```
pub fn normal_sign(axis: usize, [a, b, c]: [&SpatialPoint; 3]) -> Ordering {
    if let (Some(a), Some(b), Some(c)) = (a.as_given(), b.as_given(), c.as_given()) {
        let [a, b, c] = [a, b, c].map(|point| [point[(axis + 1) % 3], point[(axis + 2) % 3]]);
        return orientation(a, b, c);
    }
    normal_coordinate::<Estimate>(axis, [a, b, c])
        .certain_sign()
        .or_else(|| normal_coordinate::<Approximation>(axis, [a, b, c]).certain_sign())
        .or_else(|| common_normal_sign(axis, [a, b, c]))
        .or_else(|| exact_normal_sign::<ShortDyadic>(axis, [a, b, c]))
        .or_else(|| exact_normal_sign::<Dyadic>(axis, [a, b, c]))
        .expect("exact numbers have a sign")
}

/// The decision if two of the points are on a line that their definitions share, and the third is given.
fn common_normal_sign(axis: usize, points: [&SpatialPoint; 3]) -> Option<Ordering> {
    let last = points.iter().position(|point| point.as_given().is_some())?;
    let line = CommonLine::new(points[(last + 1) % 3], points[(last + 2) % 3])?;
    Some(line.normal_sign(axis, points[last].as_given()?))
}

fn exact_normal_sign<T: Arithmetic>(axis: usize, points: [&SpatialPoint; 3]) -> Option<Ordering> {
    let [a, b, c] = points.map(SpatialPoint::quotient::<T>);
    // The weight of a comes twice.
    sign_over(&cross_coordinate(&a.vector_to(&b), &a.vector_to(&c), axis), &[&b.weight, &c.weight])
}

fn normal_coordinate<T: Coordinates>(axis: usize, [a, b, c]: [&SpatialPoint; 3]) -> T {
    let to = |point: &SpatialPoint| [0, 1, 2].map(|axis| T::from_point(point, axis, a));
    cross_coordinate(&to(b), &to(c), axis)
}

/// How a tetrahedron of points runs, exactly: `Greater` if the triangle of the first three runs counterclockwise seen
/// from the fourth, `Equal` if the four are in one plane.
///
/// # Complexity
/// Constant. Four implicit points in one plane are decided by integers of some thousand bits: where the plane is given,
/// [`SpatialPoint::side_of`] is quicker.
///
/// # Examples
/// ```
/// use coface_geometry::predicates::{SpatialPoint, orientation_of_points};
/// use std::cmp::Ordering;
/// let plane = [[1., 0., 0.], [0., 1., 0.], [0., 0., 1.]];
/// let third = SpatialPoint::on_plane([[0., 0., 0.], [1., 1., 1.]], plane).expect("not parallel");
/// let [a, b, c] = plane.map(SpatialPoint::given);
/// assert_eq!(orientation_of_points([&a, &b, &c, &third]), Ordering::Equal);
/// assert_eq!(orientation_of_points([&a, &b, &third, &SpatialPoint::given([9.; 3])]), Ordering::Greater);
/// ```
pub fn orientation_of_points(points: [&SpatialPoint; 4]) -> Ordering {
    let given = points.map(SpatialPoint::as_given);
    if let [Some(a), Some(b), Some(c), Some(d)] = given {
        return spatial_orientation(a, b, c, d);
    }
    // Even permutations.
    for (last, [i, j, k]) in [(3, [0, 1, 2]), (2, [1, 0, 3]), (1, [0, 2, 3]), (0, [2, 1, 3])] {
        if let [Some(a), Some(b), Some(c)] = [i, j, k].map(|i| given[i]) {
            return points[last].side_of([a, b, c]);
        }
    }
    volume::<Estimate>(points)
        .certain_sign()
        .or_else(|| volume::<Approximation>(points).certain_sign())
        .or_else(|| common_volume_sign(points))
        .or_else(|| exact_volume_sign::<ShortDyadic>(points))
        .or_else(|| exact_volume_sign::<Dyadic>(points))
        .expect("exact numbers have a sign")
}

/// The decision if two of the points are on a line that their definitions share, and the others are given.
fn common_volume_sign(points: [&SpatialPoint; 4]) -> Option<Ordering> {
    // Even permutations.
    let orders = [[0, 1, 2, 3], [0, 2, 3, 1], [0, 3, 1, 2], [1, 2, 0, 3], [1, 3, 2, 0], [2, 3, 0, 1]];
    orders.into_iter().find_map(|order| {
        let [a, b, c, d] = order.map(|i| points[i]);
        let (c, d) = (c.as_given()?, d.as_given()?);
        Some(CommonLine::new(a, b)?.orientation(c, d))
    })
}

fn exact_volume_sign<T: Arithmetic>(points: [&SpatialPoint; 4]) -> Option<Ordering> {
    let [a, b, c, d] = points.map(SpatialPoint::quotient::<T>);
    let volume = dot(&cross(&a.vector_to(&b), &a.vector_to(&c)), &a.vector_to(&d));
    // The weight of a comes three times.
    sign_over(&volume, &[&a.weight, &b.weight, &c.weight, &d.weight])
}

fn volume<T: Coordinates>([a, b, c, d]: [&SpatialPoint; 4]) -> T {
    let to = |point: &SpatialPoint| [0, 1, 2].map(|axis| T::from_point(point, axis, a));
    dot(&cross(&to(b), &to(c)), &to(d))
}
