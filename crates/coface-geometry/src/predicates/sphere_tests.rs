//! Decisions about spheres against fractions.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use super::samples::{coordinate, rational};
use super::{
    WeightedPoint, circle_side, orientation, smallest_sphere, smallest_sphere_side, spatial_orientation,
    sphere_side,
};
use coface_algebra::{Integer, Rational};
use proptest::prelude::*;
use std::cmp::Ordering;

/// Points of a small grid, and points with coordinates of all sizes.
fn weighted_point() -> impl Strategy<Value = WeightedPoint> {
    let near = (prop::array::uniform3(-2i32..3), prop_oneof![Just(0), -2i32..3])
        .prop_map(|(point, weight)| WeightedPoint::new(point.map(f64::from), weight.into()));
    let tenths = prop::array::uniform3(-20i32..20)
        .prop_map(|point| WeightedPoint::new(point.map(|x| f64::from(x) * 0.1), 0.0));
    let wild = (prop::array::uniform3(coordinate()), coordinate())
        .prop_map(|(point, weight)| WeightedPoint::new(point, weight));
    prop_oneof![4 => near, 2 => tenths, 1 => wild]
}

fn vector(from: WeightedPoint, to: WeightedPoint) -> [Rational; 3] {
    [0, 1, 2].map(|axis| &rational(to.point()[axis]) - &rational(from.point()[axis]))
}

fn dot(u: &[Rational; 3], v: &[Rational; 3]) -> Rational {
    &(&(&u[0] * &v[0]) + &(&u[1] * &v[1])) + &(&u[2] * &v[2])
}

fn lift(p: WeightedPoint, from: WeightedPoint) -> Rational {
    let along = vector(from, p);
    &dot(&along, &along) - &(&rational(p.weight()) - &rational(from.weight()))
}

/// The center, from the first point, and the squared radius of the smallest sphere: normal equations by Cramer's rule, which no formula of the
/// library uses. `None` for points that are not independent.
fn smallest(through: &[WeightedPoint]) -> Option<([Rational; 3], Rational)> {
    let (first, others) = (through[0], &through[1..]);
    let vectors: Vec<[Rational; 3]> = others.iter().map(|&p| vector(first, p)).collect();
    let n = vectors.len();
    let half = Rational::new(Integer::ONE, Integer::from(2)).unwrap();
    let mut rows: Vec<Vec<Rational>> = (0..n)
        .map(|i| {
            let mut row: Vec<Rational> = (0..n).map(|j| dot(&vectors[i], &vectors[j])).collect();
            row.push(&lift(others[i], first) * &half);
            row
        })
        .collect();
    for i in 0..n {
        let pivot = (i..n).find(|&r| !rows[r][i].is_zero())?;
        rows.swap(i, pivot);
        let inverse = rows[i][i].inverse()?;
        let lead: Vec<Rational> = rows[i].iter().map(|x| x * &inverse).collect();
        for (r, row) in rows.iter_mut().enumerate() {
            let factor = if r == i { &row[i] - &Rational::from(Integer::ONE) } else { row[i].clone() };
            for (x, y) in row.iter_mut().zip(&lead) {
                *x = &*x - &(&factor * y);
            }
        }
    }
    let mut center = [Rational::ZERO, Rational::ZERO, Rational::ZERO];
    for (row, vector) in rows.iter().zip(&vectors) {
        for (x, y) in center.iter_mut().zip(vector) {
            *x = &*x + &(&row[n] * y);
        }
    }
    let radius = &dot(&center, &center) - &rational(first.weight());
    Some((center, radius))
}

/// The sign of less power to a sphere.
fn side(through: &[WeightedPoint], q: WeightedPoint) -> Option<Ordering> {
    let (center, radius) = smallest(through)?;
    let to = vector(through[0], q);
    let off = [0, 1, 2].map(|axis| &to[axis] - &center[axis]);
    let power = &(&dot(&off, &off) - &rational(q.weight())) - &radius;
    Some(Rational::ZERO.cmp(&power))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]
    /// Invariant 51.
    #[test]
    fn sides_of_spheres_are_those_of_fractions(points in prop::array::uniform5(weighted_point())) {
        let [a, b, c, d, q] = points;
        for through in [&points[..1], &points[..2], &points[..3]] {
            if let Some(side) = side(through, q) {
                prop_assert_eq!(smallest_sphere_side(through, q), side);
            }
        }
        let run = spatial_orientation(a.point(), b.point(), c.point(), d.point());
        let positive = if run.is_lt() { [b, a, c, d] } else { [a, b, c, d] };
        if run.is_ne() {
            prop_assert_eq!(Some(sphere_side(positive, q)), side(&positive, q));
        }
        let flat = points.map(|p| WeightedPoint::new([p.point()[0], p.point()[1], 0.0], p.weight()));
        let [a, b, c, ..] = flat;
        let at = |p: WeightedPoint| [p.point()[0], p.point()[1]];
        let run = orientation(at(a), at(b), at(c));
        let positive = if run.is_lt() { [b, a, c] } else { [a, b, c] };
        if run.is_ne() {
            prop_assert_eq!(Some(circle_side(positive, q)), side(&positive, flat[4]));
        }
    }

    #[test]
    fn radii_are_the_nearest_numbers(points in prop::array::uniform4(weighted_point())) {
        for count in 1..=4 {
            let Some((_, exact)) = smallest(&points[..count]) else { continue };
            let found = smallest_sphere(&points[..count]);
            if !found.is_finite() {
                continue;
            }
            let miss = |x: f64| {
                let miss = &exact - &rational(x);
                if miss < Rational::ZERO { &Rational::ZERO - &miss } else { miss }
            };
            let [below, above] = [found.next_down(), found.next_up()];
            prop_assert!(!below.is_finite() || miss(found) <= miss(below));
            prop_assert!(!above.is_finite() || miss(found) <= miss(above));
        }
    }
}
