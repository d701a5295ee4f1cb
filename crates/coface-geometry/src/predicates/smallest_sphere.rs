//! The smallest sphere through given points: its radius, and who lies inside.

use super::arithmetic::{Arithmetic, cross, dot, sign_of, vector};
use super::double_double::Approximation;
use super::{Dyadic, WeightedPoint};
use std::cmp::Ordering;

/// Whether a point lies inside the smallest sphere through one to three points, exactly: `Greater` for inside, `Less` for outside. With weights the sphere
/// is the smallest one that is orthogonal to the weighted points, and the sign is that of less power. The points are affinely independent.
///
/// # Panics
/// For no point and for more than three: through four points there is but one sphere ([`sphere_side`](super::sphere_side)).
///
/// # Complexity
/// Constant; some forty operations in floating point unless the point is nearly on the sphere.
///
/// # Examples
/// ```
/// use coface_geometry::predicates::{WeightedPoint, smallest_sphere_side};
/// use std::cmp::Ordering;
/// let at = |x: f64, y: f64| WeightedPoint::new([x, y, 0.0], 0.0);
/// let edge = [at(-1.0, 0.0), at(1.0, 0.0)];
/// assert_eq!(smallest_sphere_side(&edge, at(0.0, 0.9)), Ordering::Greater);
/// assert_eq!(smallest_sphere_side(&edge, at(0.0, 1.0)), Ordering::Equal);
/// assert_eq!(smallest_sphere_side(&edge, at(0.0, 1.1)), Ordering::Less);
/// ```
pub fn smallest_sphere_side(through: &[WeightedPoint], q: WeightedPoint) -> Ordering {
    match *through {
        [a] => sign_of!(inside_point(a, q)),
        [a, b] => sign_of!(inside_of_two(a, b, q)),
        [a, b, c] => sign_of!(inside_of_three(a, b, c, q)),
        _ => panic!("smallest spheres go through one to three points"),
    }
}

/// The squared radius of the smallest sphere through one to four points, rounded to the nearest number. With weights it is that of the smallest
/// sphere that is orthogonal to the weighted points, which may be negative: of one point the negative weight. The points are affinely independent.
///
/// With $u_i = p_i - p_0$ and $s_i = |u_i|^2 - w_i + w_0$ it is $s_1^2 / 4 |u_1|^2$ for two points, $|s_1 u_2 - s_2 u_1|^2 / 4 |u_1 \times u_2|^2$ for
/// three, and $|s_1 u_2 \times u_3 + s_2 u_3 \times u_1 + s_3 u_1 \times u_2|^2 / 4 \det(u_1, u_2, u_3)^2$ for four, each less $w_0$.
///
/// # Panics
/// For no point, for more than four, and for points that are not affinely independent.
///
/// # Complexity
/// Constant; some hundred operations in twice the usual precision unless that leaves the last digit open.
///
/// # Examples
/// ```
/// use coface_geometry::predicates::{WeightedPoint, smallest_sphere};
/// let at = |x: f64, y: f64| WeightedPoint::new([x, y, 0.0], 0.0);
/// assert_eq!(smallest_sphere(&[at(0.0, 0.0), at(1.0, 1.0)]), 0.5);
/// assert_eq!(smallest_sphere(&[at(0.0, 0.0), at(3.0, 0.0), at(0.0, 4.0)]), 6.25);
/// assert_eq!(smallest_sphere(&[WeightedPoint::new([0.0; 3], 2.0)]), -2.0);
/// ```
pub fn smallest_sphere(through: &[WeightedPoint]) -> f64 {
    if let [a] = through {
        // Zero has no sign here.
        return 0.0 - a.weight;
    }
    let [above, below] = radius::<Approximation>(through);
    if let Some(quotient) = above.over(below)
        && let [least, most] = quotient.rest().map(|rest| quotient.high + rest)
        && least == most
        && least.is_finite()
    {
        return least + 0.0;
    }
    let [above, below] = radius::<Dyadic>(through);
    above.rounded_ratio(&below) + 0.0
}

/// `|u|^2 - w + w_0` of a vector u to a point of weight w.
fn lift<T: Arithmetic>(p: WeightedPoint, origin: WeightedPoint, along: &[T; 3]) -> T {
    dot(along, along).minus(&T::difference(p.weight, origin.weight))
}

fn inside_point<T: Arithmetic>(a: WeightedPoint, q: WeightedPoint) -> T {
    T::difference(q.weight, a.weight).minus(&{
        let along = vector::<T>(a.point, q.point);
        dot(&along, &along)
    })
}

fn inside_of_two<T: Arithmetic>(a: WeightedPoint, b: WeightedPoint, q: WeightedPoint) -> T {
    let [u, v] = [b, q].map(|p| vector::<T>(a.point, p.point));
    lift(b, a, &u).times(&dot(&u, &v)).minus(&dot(&u, &u).times(&lift(q, a, &v)))
}

fn inside_of_three<T: Arithmetic>(
    a: WeightedPoint,
    b: WeightedPoint,
    c: WeightedPoint,
    q: WeightedPoint,
) -> T {
    let [u, v, along] = [b, c, q].map(|p| vector::<T>(a.point, p.point));
    let normal = cross(&u, &v);
    let center = cross(&combined(&lift(b, a, &u), &v, &lift(c, a, &v), &u), &normal);
    dot(&along, &center).minus(&lift(q, a, &along).times(&dot(&normal, &normal)))
}

/// `s u - t v`.
fn combined<T: Arithmetic>(s: &T, u: &[T; 3], t: &T, v: &[T; 3]) -> [T; 3] {
    let along = |axis: usize| s.times(&u[axis]).minus(&t.times(&v[axis]));
    [along(0), along(1), along(2)]
}

/// The numerator and the positive denominator of the squared radius.
fn radius<T: Arithmetic>(through: &[WeightedPoint]) -> [T; 2] {
    let (&a, others) = through.split_first().expect("a sphere goes through a point");
    let to = |p: WeightedPoint| vector::<T>(a.point, p.point);
    let [above, below] = match *others {
        [b] => {
            let u = to(b);
            let s = lift(b, a, &u);
            [s.times(&s), dot(&u, &u)]
        }
        [b, c] => {
            let [u, v] = [to(b), to(c)];
            let (turned, normal) = (combined(&lift(b, a, &u), &v, &lift(c, a, &v), &u), cross(&u, &v));
            [dot(&turned, &turned), dot(&normal, &normal)]
        }
        [b, c, d] => {
            let [u, v, w] = [to(b), to(c), to(d)];
            let lifts = [lift(b, a, &u), lift(c, a, &v), lift(d, a, &w)];
            let faces = [cross(&v, &w), cross(&w, &u), cross(&u, &v)];
            let along = |axis: usize| {
                let [first, second, third] = [0, 1, 2].map(|i| lifts[i].times(&faces[i][axis]));
                first.plus(&second).plus(&third)
            };
            let (turned, volume) = ([along(0), along(1), along(2)], dot(&u, &faces[0]));
            [dot(&turned, &turned), volume.times(&volume)]
        }
        _ => panic!("smallest spheres go through one to four points"),
    };
    let below = T::difference(4.0, 0.0).times(&below);
    if a.weight == 0.0 {
        return [above, below];
    }
    [above.minus(&T::difference(a.weight, 0.0).times(&below)), below]
}
