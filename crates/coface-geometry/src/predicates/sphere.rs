//! On which side of the sphere through given points a point lies.

use super::WeightedPoint;
use super::arithmetic::{Arithmetic, cross, dot, sign_of, vector};
use super::double_double::is_ordinary;
use std::cmp::Ordering;

/// What a determinant of an in-sphere test may lose of the sum of the sizes of its terms: differences, products, weights and sums have at most 21 unit
/// roundoffs together.
const LOST: f64 = 32.0 * f64::EPSILON / 2.0;

/// On which side of the circle through the corners of a triangle of the plane, which runs counterclockwise, a point lies, exactly: `Greater` for
/// inside, `Less` for outside. For points with weights the circle is the one that is orthogonal to the corners, and the sign is that of less power.
/// The third coordinates are not looked at.
///
/// The sign of $\det (p_i - q, |p_i - q|^2 - w_i + w_q)$ for the corners $p_i$ and the point $q$. All numbers are finite.
///
/// # Complexity
/// Constant; some thirty operations in floating point unless the points are nearly on one circle.
///
/// # References
/// J. R. Shewchuk, *Adaptive precision floating-point arithmetic and fast robust geometric predicates* (1997).
///
/// # Examples
/// ```
/// use coface_geometry::predicates::{WeightedPoint, circle_side};
/// use std::cmp::Ordering;
/// let at = |x: f64, y: f64| WeightedPoint::new([x, y, 0.0], 0.0);
/// let triangle = [at(0.0, 0.0), at(1.0, 0.0), at(0.0, 1.0)];
/// assert_eq!(circle_side(triangle, at(0.9, 0.9)), Ordering::Greater);
/// assert_eq!(circle_side(triangle, at(1.0, 1.0)), Ordering::Equal);
/// // A weight lets a point count as nearer.
/// assert_eq!(circle_side(triangle, WeightedPoint::new([1.0, 1.0, 0.0], 1e-300)), Ordering::Greater);
/// ```
pub fn circle_side(triangle: [WeightedPoint; 3], q: WeightedPoint) -> Ordering {
    let filtered = if are_ordinary(&triangle, q) { ordinary_circle_side(triangle, q) } else { None };
    filtered.unwrap_or_else(|| sign_of!(circle_determinant(triangle, q)))
}

/// On which side of the sphere through the corners of a tetrahedron a point lies, exactly: `Greater` for inside, `Less` for outside. The tetrahedron is
/// positive as [`spatial_orientation`](super::spatial_orientation) says. For points with weights the sphere is the one that is orthogonal to the corners,
/// and the sign is that of less power.
///
/// The sign of $-\det (p_i - q, |p_i - q|^2 - w_i + w_q)$ for the corners $p_i$ and the point $q$. All numbers are finite.
///
/// # Complexity
/// Constant; some eighty operations in floating point unless the points are nearly on one sphere.
///
/// # References
/// As of [`circle_side`].
///
/// # Examples
/// ```
/// use coface_geometry::predicates::{WeightedPoint, sphere_side};
/// use std::cmp::Ordering;
/// let at = |point| WeightedPoint::new(point, 0.0);
/// let corner = [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [0., 0., 1.]].map(at);
/// assert_eq!(sphere_side(corner, at([1., 1., 1.])), Ordering::Equal);
/// assert_eq!(sphere_side(corner, at([0.9, 1., 1.])), Ordering::Greater);
/// assert_eq!(sphere_side(corner, at([9., 1., 1.])), Ordering::Less);
/// ```
pub fn sphere_side(tetrahedron: [WeightedPoint; 4], q: WeightedPoint) -> Ordering {
    let filtered = if are_ordinary(&tetrahedron, q) { ordinary_sphere_side(tetrahedron, q) } else { None };
    filtered.unwrap_or_else(|| sign_of!(sphere_determinant(tetrahedron, q)))
}

fn are_ordinary(corners: &[WeightedPoint], q: WeightedPoint) -> bool {
    corners.iter().chain([&q]).all(|corner| corner.is_ordinary())
}

impl WeightedPoint {
    /// Whether the products of in-sphere tests stay in the range of ordinary numbers.
    pub(crate) fn is_ordinary(&self) -> bool {
        self.point.iter().all(|&x| is_ordinary(x)) && is_ordinary(self.weight)
    }
}

/// The difference to `q`, its squared length less the difference of the weights, and the sum of the sizes of both.
fn lifted(p: WeightedPoint, q: WeightedPoint) -> ([f64; 3], f64, f64) {
    let [x, y, z] = [0, 1, 2].map(|axis| p.point[axis] - q.point[axis]);
    let (square, weight) = (x * x + y * y + z * z, p.weight - q.weight);
    ([x, y, z], square - weight, square + weight.abs())
}

/// The sign if floating point tells it, for ordinary numbers.
pub(crate) fn ordinary_circle_side([a, b, c]: [WeightedPoint; 3], q: WeightedPoint) -> Option<Ordering> {
    let flat = |p: WeightedPoint| WeightedPoint { point: [p.point[0], p.point[1], 0.0], ..p };
    let q = flat(q);
    let [(a, a_lift, a_size), (b, b_lift, b_size), (c, c_lift, c_size)] =
        [a, b, c].map(|corner| lifted(flat(corner), q));
    let area = |u: [f64; 3], v: [f64; 3]| {
        let [left, right] = [u[0] * v[1], u[1] * v[0]];
        (left - right, left.abs() + right.abs())
    };
    let [(bc, bc_size), (ca, ca_size), (ab, ab_size)] = [area(b, c), area(c, a), area(a, b)];
    let determinant = a_lift * bc + b_lift * ca + c_lift * ab;
    let size = a_size * bc_size + b_size * ca_size + c_size * ab_size;
    (determinant.abs() > LOST * size).then(|| determinant.total_cmp(&0.0))
}

/// The sign if floating point tells it, for ordinary numbers.
pub(crate) fn ordinary_sphere_side([a, b, c, d]: [WeightedPoint; 4], q: WeightedPoint) -> Option<Ordering> {
    let [(a, a_lift, a_size), (b, b_lift, b_size), (c, c_lift, c_size), (d, d_lift, d_size)] =
        [a, b, c, d].map(|corner| lifted(corner, q));
    let area = |u: [f64; 3], v: [f64; 3]| {
        let [left, right] = [u[0] * v[1], u[1] * v[0]];
        (left - right, left.abs() + right.abs())
    };
    let [ab, bc, cd, da, ac, bd] = [area(a, b), area(b, c), area(c, d), area(d, a), area(a, c), area(b, d)];
    let [az, bz, cz, dz] = [a[2], b[2], c[2], d[2]];
    let abc = az * bc.0 - bz * ac.0 + cz * ab.0;
    let bcd = bz * cd.0 - cz * bd.0 + dz * bc.0;
    let cda = cz * da.0 + dz * ac.0 + az * cd.0;
    let dab = dz * ab.0 + az * bd.0 + bz * da.0;
    let determinant = (d_lift * abc - c_lift * dab) + (b_lift * cda - a_lift * bcd);
    let [az, bz, cz, dz] = [az, bz, cz, dz].map(f64::abs);
    let size = d_size * (az * bc.1 + bz * ac.1 + cz * ab.1)
        + c_size * (dz * ab.1 + az * bd.1 + bz * da.1)
        + b_size * (cz * da.1 + dz * ac.1 + az * cd.1)
        + a_size * (bz * cd.1 + cz * bd.1 + dz * bc.1);
    (determinant.abs() > LOST * size).then(|| 0f64.total_cmp(&determinant))
}

fn lift<T: Arithmetic>(p: WeightedPoint, q: WeightedPoint, along: &[T; 3]) -> T {
    dot(along, along).minus(&T::difference(p.weight, q.weight))
}

fn circle_determinant<T: Arithmetic>(triangle: [WeightedPoint; 3], q: WeightedPoint) -> T {
    let flat = |p: WeightedPoint| [p.point[0], p.point[1], 0.0];
    let [a, b, c] = triangle.map(|corner| vector::<T>(flat(q), flat(corner)));
    let area = |u: &[T; 3], v: &[T; 3]| u[0].times(&v[1]).minus(&u[1].times(&v[0]));
    let [la, lb, lc] = [lift(triangle[0], q, &a), lift(triangle[1], q, &b), lift(triangle[2], q, &c)];
    la.times(&area(&b, &c)).plus(&lb.times(&area(&c, &a))).plus(&lc.times(&area(&a, &b)))
}

fn sphere_determinant<T: Arithmetic>(tetrahedron: [WeightedPoint; 4], q: WeightedPoint) -> T {
    let [a, b, c, d] = tetrahedron.map(|corner| vector::<T>(q.point, corner.point));
    let volume = |u: &[T; 3], v: &[T; 3], w: &[T; 3]| dot(u, &cross(v, w));
    let [la, lb, lc, ld] = [
        lift(tetrahedron[0], q, &a),
        lift(tetrahedron[1], q, &b),
        lift(tetrahedron[2], q, &c),
        lift(tetrahedron[3], q, &d),
    ];
    let positive = la.times(&volume(&b, &c, &d)).plus(&lc.times(&volume(&a, &b, &d)));
    positive.minus(&lb.times(&volume(&a, &c, &d)).plus(&ld.times(&volume(&a, &b, &c))))
}
