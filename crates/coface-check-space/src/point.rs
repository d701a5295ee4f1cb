//! Points with fractions as coordinates, and what is decided about them.

use coface_check::Fault;
use coface_check::json::{integer, list};
use coface_check_plane::parts;
use dashu_int::IBig;
use serde_json::Value;
use std::cmp::Ordering;

/// The point (x / w, y / w, z / w), w above zero, and doubles that are near it.
#[derive(Clone, Debug)]
pub(crate) struct Point {
    /// x, y, z and w.
    pub(crate) exact: [IBig; 4],
    /// The coordinates; each is off by less than [`CLOSENESS`] of itself, or is infinite.
    pub(crate) near: [f64; 3],
}

/// Two integers are rounded to doubles and divided, which is three roundings of 2^-53 each; one more to spare, and for bounds one.
const CLOSENESS: f64 = 8.0 / (1u64 << 53) as f64;

impl Point {
    /// The point with these finite coordinates, exactly.
    pub(crate) fn of(coordinates: [f64; 3]) -> Self {
        let parts = coordinates.map(parts);
        let least = parts.iter().map(|part| part.1).fold(0, i32::min);
        let [x, y, z] = parts.map(|(value, exponent)| value << (exponent - least) as usize);
        Self { exact: [x, y, z, IBig::ONE << -least as usize], near: coordinates }
    }

    /// The point of four integers, of which the last is above zero.
    pub(crate) fn new(exact: [IBig; 4]) -> Self {
        let double = |integer: &IBig| integer.to_f64().value();
        let near = [0, 1, 2].map(|axis| {
            let quotient = double(&exact[axis]) / double(&exact[3]);
            // Below the range of doubles with all digits, or above it, nothing is known.
            let is_known = exact[axis] == IBig::ZERO || (1e-250..1e250).contains(&quotient.abs());
            if is_known { quotient } else { f64::INFINITY }
        });
        Self { exact, near }
    }

    /// Four integers of a certificate.
    pub(crate) fn read(value: &Value, step: &str) -> Result<Self, Fault> {
        let [x, y, z, w] = list(value, "a vertex", step)? else {
            return Err(Fault::new(step, "a vertex is no list of four integers x, y, z and w"));
        };
        let exact =
            [integer(x, "x", step)?, integer(y, "y", step)?, integer(z, "z", step)?, integer(w, "w", step)?];
        if exact[3] <= IBig::ZERO {
            return Err(Fault::new(step, "the w of a vertex is not above zero"));
        }
        Ok(Self::new(exact))
    }

    /// By x, then y, then z. Along a line points rise or fall in this order.
    pub(crate) fn compare(&self, other: &Self) -> Ordering {
        let by =
            |axis: usize| (&self.exact[axis] * &other.exact[3]).cmp(&(&other.exact[axis] * &self.exact[3]));
        by(0).then_with(|| by(1)).then_with(|| by(2))
    }

    /// Doubles below and above each coordinate.
    pub(crate) fn bounds(&self) -> [[f64; 2]; 3] {
        self.near.map(|x| match x.is_finite() {
            true => [x - CLOSENESS * x.abs(), x + CLOSENESS * x.abs()],
            false => [f64::NEG_INFINITY, f64::INFINITY],
        })
    }
}

/// The determinant of three rows of integers.
pub(crate) fn determinant([a, b, c]: [[&IBig; 3]; 3]) -> IBig {
    let minor = |i: usize, j: usize| b[i] * c[j] - b[j] * c[i];
    a[0] * minor(1, 2) - a[1] * minor(0, 2) + a[2] * minor(0, 1)
}

/// The plane of three points: p is on it where n . (x, y, z) + m w is zero, and in front of it, where the points turn counterclockwise,
/// where that is above zero.
pub(crate) struct Plane {
    /// n and m, times what is above zero.
    exact: [IBig; 4],
    points: [[f64; 3]; 3],
}

impl Plane {
    pub(crate) fn of([a, b, c]: [&Point; 3]) -> Self {
        let without = |skip: usize| {
            let row = |p: &'_ Point| -> [IBig; 3] {
                let mut rest = (0..4).filter(|&place| place != skip).map(|place| p.exact[place].clone());
                [(); 3].map(|()| rest.next().unwrap_or_default())
            };
            let rows = [row(a), row(b), row(c)];
            determinant([0, 1, 2].map(|i| [&rows[i][0], &rows[i][1], &rows[i][2]]))
        };
        // The minors of the matrix of four rows whose last is a further point, with the sign that makes the front positive.
        let exact = [without(0), -without(1), without(2), -without(3)];
        Self { exact, points: [a.near, b.near, c.near] }
    }

    /// The components of the normal, times what is above zero.
    pub(crate) fn normal(&self) -> [&IBig; 3] {
        [&self.exact[0], &self.exact[1], &self.exact[2]]
    }

    /// What is above zero in front of the plane, and zero on it; linear in the four integers of the point.
    pub(crate) fn value(&self, p: &Point) -> IBig {
        (0..4).map(|place| &self.exact[place] * &p.exact[place]).fold(IBig::ZERO, |sum, part| sum + part)
    }

    /// On which side a point is: greater in front.
    pub(crate) fn side(&self, p: &Point) -> Ordering {
        self.near_side(p).unwrap_or_else(|| self.value(p).cmp(&IBig::ZERO))
    }

    /// The side by doubles, where these suffice.
    ///
    /// With M the largest coordinate and L the largest difference, each difference has an error below 2^-49 M, so each of the six
    /// products has one below 3 (2^-49 M) (L + 2^-49 M)^2, and rounding adds less. The bound has a factor of eight to spare.
    fn near_side(&self, p: &Point) -> Option<Ordering> {
        let [a, b, c] = self.points;
        let rows = [a, b, c].map(|q| [0, 1, 2].map(|i| q[i] - p.near[i]));
        let most = [a, b, c, p.near].iter().flatten().fold(0.0f64, |most, x| most.max(x.abs()));
        let length = rows.iter().flatten().fold(0.0f64, |most, x| most.max(x.abs()));
        let [u, v, w] = rows;
        let found = u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0])
            + u[2] * (v[0] * w[1] - v[1] * w[0]);
        let bound = 3e-13 * most * length * length;
        let is_certain = (1e-200..1e200).contains(&bound) && found.abs() > bound;
        if !is_certain {
            return None;
        }
        // The rows turn counterclockwise seen from p if p is in front: then the determinant of the differences is negative.
        Some(if found < 0.0 { Ordering::Greater } else { Ordering::Less })
    }
}

/// How a, b and c turn as seen along an axis, the next two axes being x and y: greater for counterclockwise.
pub(crate) fn turn([a, b, c]: [&Point; 3], axis: usize) -> Ordering {
    let [i, j] = [(axis + 1) % 3, (axis + 2) % 3];
    let [u, v] = [b, c].map(|q| [q.near[i] - a.near[i], q.near[j] - a.near[j]]);
    let most =
        [a, b, c].iter().flat_map(|q| [q.near[i], q.near[j]]).fold(0.0f64, |most, x| most.max(x.abs()));
    let length = [u, v].iter().flatten().fold(0.0f64, |most, x| most.max(x.abs()));
    let found = u[0] * v[1] - u[1] * v[0];
    let bound = 3e-14 * most * length;
    if (1e-200..1e200).contains(&bound) && found.abs() > bound {
        return if found > 0.0 { Ordering::Greater } else { Ordering::Less };
    }
    let row = |q: &'_ Point| [i, j, 3].map(|place| q.exact[place].clone());
    let rows = [row(a), row(b), row(c)];
    determinant([0, 1, 2].map(|k| [&rows[k][0], &rows[k][1], &rows[k][2]])).cmp(&IBig::ZERO)
}

#[cfg(test)]
mod tests {
    use super::{Plane, Point, turn};
    use dashu_int::IBig;
    use std::cmp::Ordering::{Equal, Greater, Less};

    #[test]
    fn numbers_are_taken_exactly() {
        assert_eq!(Point::of([0.5, -2.0, 3.0]).exact, [1, -4, 6, 2].map(IBig::from));
    }

    #[test]
    fn sides_are_those_of_space() {
        let at = |x: f64, y: f64, z: f64| Point::of([x, y, z]);
        let [a, b, c] = [at(0.0, 0.0, 1.0), at(1.0, 0.0, 1.0), at(0.0, 1.0, 1.0)];
        let plane = Plane::of([&a, &b, &c]);
        assert_eq!(plane.normal(), [&IBig::ZERO, &IBig::ZERO, &IBig::ONE]);
        for (height, side) in
            [(3.0, Greater), (1.0 + f64::EPSILON, Greater), (1.0, Equal), (1.0 - f64::EPSILON, Less)]
        {
            let p = at(0.25, 0.7, height);
            assert_eq!(plane.side(&p), side);
            assert_eq!(plane.value(&p).cmp(&IBig::ZERO), side);
        }
        assert_eq!(
            [turn([&a, &b, &c], 2), turn([&b, &a, &c], 2), turn([&a, &b, &c], 0)],
            [Greater, Less, Equal]
        );
        let third = Point::new([1, 1, 3, 3].map(IBig::from));
        assert_eq!(turn([&a, &third, &at(1.0, 1.0, 9.0)], 2), Equal);
        assert_eq!(plane.side(&third), Equal);
        assert_eq!(a.compare(&third), Less);
    }

    /// The quick decisions are the exact ones, near the plane too.
    #[test]
    fn doubles_decide_nothing_wrongly() {
        let mut state = 7u64;
        let mut next = |range: i64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            ((state >> 33) as i64).rem_euclid(2 * range + 1) - range
        };
        for _ in 0..20_000 {
            let w = 1 + next(40).abs();
            let mut point =
                |range: i64| Point::new([next(range), next(range), next(range), w].map(IBig::from));
            let [a, b, c, mut d] = [point(1 << 40), point(1 << 40), point(1 << 40), point(1 << 40)];
            let plane = Plane::of([&a, &b, &c]);
            assert_eq!(plane.side(&d), plane.value(&d).cmp(&IBig::ZERO));
            // A combination of the three, moved by as little as there is.
            let sum = |i: usize| &a.exact[i] * 3 + &b.exact[i] * 5 + &c.exact[i] * 8;
            let moved = [
                sum(0) * (1i64 << 60) + next(2),
                sum(1) * (1i64 << 60),
                sum(2) * (1i64 << 60),
                sum(3) * (1i64 << 60),
            ];
            d = Point::new(moved);
            assert_eq!(plane.side(&d), plane.value(&d).cmp(&IBig::ZERO));
        }
    }
}
