//! Lines through two points that are defined by planes they share.

use super::arithmetic::{Arithmetic, cross, cross_coordinate, dot, normal, sign_of, vector};
use super::estimate::Estimate;
use super::spatial_point::SpatialPoint;
use super::{Dyadic, SpatialPlane};
use std::cmp::Ordering;

/// The line from a point to another where both are in two planes: then its direction is the product of the normals or
/// the opposite, and decisions about given points around it take no more than the given planes.
#[derive(Clone, Copy, Debug)]
pub(super) struct CommonLine {
    planes: [SpatialPlane; 2],
    /// How the line is directed along the product of the normals.
    along: Ordering,
}

impl CommonLine {
    /// The line from `a` to `b`, if their definitions share two planes that cross.
    pub(super) fn new(a: &SpatialPoint, b: &SpatialPoint) -> Option<Self> {
        let candidates = [a.planes(), b.planes(), [joint_plane(a, b), None, None]];
        let mut shared =
            candidates.as_flattened().iter().flatten().filter(|plane| a.is_by(plane) && b.is_by(plane));
        let f = *shared.next()?;
        let g = *shared.find(|&&plane| plane != f)?;
        let (order, direction) = quick_order(a, b, f, g).or_else(|| {
            let (axis, direction) = crossing_axis(f, g)?;
            Some((b.compare_coordinate(a, axis), direction))
        })?;
        Some(Self { planes: [f, g], along: if direction.is_gt() { order } else { order.reverse() } })
    }

    /// The sign of a coordinate of $(b - a) \times (c - a)$.
    pub(super) fn normal_sign(&self, axis: usize, c: [f64; 3]) -> Ordering {
        let [f, g] = self.planes;
        self.directed(sign_of!(moment(f, g, c, axis)))
    }

    /// The sign of the determinant of $b - a$, $c - a$, $d - a$.
    pub(super) fn orientation(&self, c: [f64; 3], d: [f64; 3]) -> Ordering {
        let [f, g] = self.planes;
        self.directed(sign_of!(turn(f, g, c, d)))
    }

    fn directed(&self, sign: Ordering) -> Ordering {
        match self.along {
            Ordering::Greater => sign,
            Ordering::Equal => Ordering::Equal,
            Ordering::Less => sign.reverse(),
        }
    }
}

/// The plane of two lines that define two points and begin or end in one given point.
fn joint_plane(a: &SpatialPoint, b: &SpatialPoint) -> Option<SpatialPlane> {
    let (s, t) = (a.line()?, b.line()?);
    match [s.contains(&t[0]), s.contains(&t[1])] {
        [true, false] => Some([s[0], s[1], t[1]]),
        [false, true] => Some([s[0], s[1], t[0]]),
        _ => None,
    }
}

/// The order of two points of two planes along an axis, and the sign of the product of the normals along it, if that is
/// quickly known for some axis.
fn quick_order(
    a: &SpatialPoint,
    b: &SpatialPoint,
    f: SpatialPlane,
    g: SpatialPlane,
) -> Option<(Ordering, Ordering)> {
    let product = cross(&normal::<Estimate>(f), &normal::<Estimate>(g));
    (0..3).find_map(|axis| Some((b.known_order(a, axis)?, product[axis].sign()?)))
}

/// An axis that the line where two planes cross is not at right angles to, and the sign of the product of the normals
/// along it; `None` for parallel planes.
fn crossing_axis(f: SpatialPlane, g: SpatialPlane) -> Option<(usize, Ordering)> {
    let exact = cross(&normal::<Dyadic>(f), &normal::<Dyadic>(g));
    (0..3).map(|axis| (axis, exact[axis].sign())).find(|(_, sign)| sign.is_ne())
}

/// How far a point is in front of a plane, times the length of the normal.
fn height<T: Arithmetic>(plane: SpatialPlane, normal: &[T; 3], point: [f64; 3]) -> T {
    if plane.contains(&point) {
        return T::difference(0.0, 0.0);
    }
    dot(normal, &vector(plane[0], point))
}

/// A coordinate of $(n \times n') \times (c - a) = n' (n \cdot (c - a)) - n (n' \cdot (c - a))$ for a point a of both
/// planes.
fn moment<T: Arithmetic>(f: SpatialPlane, g: SpatialPlane, c: [f64; 3], axis: usize) -> T {
    let (n, m) = (normal::<T>(f), normal::<T>(g));
    let (over_f, over_g) = (height(f, &n, c), height(g, &m, c));
    m[axis].times(&over_f).minus(&n[axis].times(&over_g))
}

/// The determinant of $n \times n'$, $c - a$, $d - a$ for a point a of both planes.
fn turn<T: Arithmetic>(f: SpatialPlane, g: SpatialPlane, c: [f64; 3], d: [f64; 3]) -> T {
    let (n, m) = (normal::<T>(f), normal::<T>(g));
    let heights = |point: [f64; 3]| [height(f, &n, point), height(g, &m, point), T::difference(0.0, 0.0)];
    cross_coordinate(&heights(c), &heights(d), 2)
}
