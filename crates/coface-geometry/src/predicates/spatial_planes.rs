//! Planes, lines and given points in space: sides, directions and normals.

use super::arithmetic::{Arithmetic, cross, dot, normal, sign_of, vector};
use super::double_double::is_ordinary;
use super::estimate::Estimate;
use super::short_dyadic::ShortDyadic;
use super::{Dyadic, SpatialLine, SpatialPlane};
use robust::Coord3D;
use std::cmp::Ordering;

/// On which side of the plane of `a`, `b`, `c` the point `d` lies, exactly: `Greater` if the triangle `a b c` runs
/// counterclockwise seen from `d`, `Less` for clockwise, `Equal` if the four points are in one plane.
///
/// The sign of the determinant of $b - a$, $c - a$, $d - a$, six times the volume of the tetrahedron. All coordinates
/// are finite.
///
/// # Complexity
/// Constant; some twenty operations in floating point unless the points are nearly in one plane.
///
/// # References
/// J. R. Shewchuk, *Adaptive precision floating-point arithmetic and fast robust geometric predicates* (1997).
///
/// # Examples
/// ```
/// use coface_geometry::predicates::spatial_orientation;
/// use std::cmp::Ordering;
/// let [a, b, c] = [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.]];
/// assert_eq!(spatial_orientation(a, b, c, [5., 5., 1e-300]), Ordering::Greater);
/// assert_eq!(spatial_orientation(a, b, c, [1e300, 1e-300, 0.]), Ordering::Equal);
/// ```
pub fn spatial_orientation(a: [f64; 3], b: [f64; 3], c: [f64; 3], d: [f64; 3]) -> Ordering {
    if [a, b, c, d].as_flattened().iter().all(|&x| is_ordinary(x)) {
        let [a, b, c, d] = [a, b, c, d].map(|[x, y, z]| Coord3D { x, y, z });
        // There the determinant is that of a - d, b - d, c - d. Not total_cmp: -0.0 is zero too.
        let determinant = robust::orient3d(a, b, c, d);
        return 0f64.partial_cmp(&determinant).expect("a determinant of ordinary numbers is a number");
    }
    sign_of!(volume(a, b, c, d))
}

fn volume<T: Arithmetic>(a: [f64; 3], b: [f64; 3], c: [f64; 3], d: [f64; 3]) -> T {
    dot(&cross(&vector(a, b), &vector(a, c)), &vector(a, d))
}

/// How the normals of three planes turn, exactly: the sign of the determinant of the normals of `f`, `g` and `h`;
/// `Equal` if the three are parallel to one line, so that the planes do not meet in exactly one point.
///
/// # Examples
/// ```
/// use coface_geometry::predicates::normals_turn;
/// use std::cmp::Ordering;
/// let x = [[0., 0., 0.], [0., 1., 0.], [0., 0., 1.]];
/// let y = [[0., 0., 0.], [0., 0., 1.], [1., 0., 0.]];
/// let z = [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.]];
/// assert_eq!(normals_turn(x, y, z), Ordering::Greater);
/// assert_eq!(normals_turn(y, x, z), Ordering::Less);
/// assert_eq!(normals_turn(x, y, [[0., 0., 0.], [1., 1., 0.], [0., 0., 1.]]), Ordering::Equal);
/// ```
pub fn normals_turn(f: SpatialPlane, g: SpatialPlane, h: SpatialPlane) -> Ordering {
    sign_of!(normals_determinant(f, g, h))
}

fn normals_determinant<T: Arithmetic>(f: SpatialPlane, g: SpatialPlane, h: SpatialPlane) -> T {
    dot(&cross(&normal(f), &normal(g)), &normal(h))
}

/// To which side of a plane a line is directed, exactly: the sign of $n \cdot (s_1 - s_0)$ for the normal n of the
/// plane and the line from $s_0$ to $s_1$; `Equal` for a line parallel to the plane.
///
/// # Examples
/// ```
/// use coface_geometry::predicates::direction_side;
/// use std::cmp::Ordering;
/// let ground = [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.]];
/// assert_eq!(direction_side([[9., 9., 9.], [8., 8., 10.]], ground), Ordering::Greater);
/// assert_eq!(direction_side([[9., 9., 9.], [8., 8., 9.]], ground), Ordering::Equal);
/// ```
pub fn direction_side(line: SpatialLine, plane: SpatialPlane) -> Ordering {
    sign_of!(climb(line, plane))
}

fn climb<T: Arithmetic>(line: SpatialLine, plane: SpatialPlane) -> T {
    dot(&normal(plane), &vector(line[0], line[1]))
}

/// An axis along which a plane is not seen edge-on, and the sign of that coordinate of its normal: which way the
/// plane's triangle runs seen from the far end of the axis.
///
/// The axis is one of the largest coordinate of the normal, up to rounding. The sign is `Equal` exactly if the three
/// points are on one line, and so do not give a plane.
///
/// # Examples
/// ```
/// use coface_geometry::predicates::plane_axis;
/// use std::cmp::Ordering;
/// assert_eq!(plane_axis([[0., 0., 0.], [1., 0., 0.], [0., 1., 0.25]]), (2, Ordering::Greater));
/// assert_eq!(plane_axis([[0., 0., 0.], [0.1, 0.1, 0.1], [0.3, 0.3, 0.3]]).1, Ordering::Equal);
/// ```
pub fn plane_axis(plane: SpatialPlane) -> (usize, Ordering) {
    let estimate = normal::<Estimate>(plane);
    let largest =
        |sizes: [f64; 3]| (1..3).fold(0, |best, axis| if sizes[axis] > sizes[best] { axis } else { best });
    let axis = largest(estimate.map(|coordinate| coordinate.value().abs()));
    if let Some(sign) = estimate[axis].sign() {
        return (axis, sign);
    }
    let short = normal::<ShortDyadic>(plane);
    if short.iter().all(|coordinate| coordinate.certain_sign() == Some(Ordering::Equal)) {
        return (0, Ordering::Equal);
    }
    let exact = normal::<Dyadic>(plane);
    let size = |axis: usize| if exact[axis].sign().is_lt() { -&exact[axis] } else { exact[axis].clone() };
    let axis =
        (1..3).fold(0, |best, axis| if (&size(axis) - &size(best)).sign().is_gt() { axis } else { best });
    (axis, exact[axis].sign())
}

/// Whether two planes are one, exactly.
///
/// # Examples
/// ```
/// use coface_geometry::predicates::are_coplanar;
/// let ground = [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.]];
/// assert!(are_coplanar(ground, [[7., 7., 0.], [1e300, 0., 0.], [0., 0., 0.]]));
/// assert!(!are_coplanar(ground, [[7., 7., 0.], [1e300, 0., 1e-300], [0., 0., 0.]]));
/// ```
pub fn are_coplanar(f: SpatialPlane, g: SpatialPlane) -> bool {
    // Triangles with a common side have two common points, for which no filter would decide.
    g.iter().all(|&point| f.contains(&point) || spatial_orientation(f[0], f[1], f[2], point).is_eq())
}
