//! Points in space as quotients, in every precision.

use super::arithmetic::{Arithmetic, cross, cross_coordinate, dot, normal, vector};
use super::{Dyadic, SpatialLine, SpatialPlane};
use coface_algebra::Rational;
use std::cmp::Ordering;

/// The point `base + offset / weight`. The weight is not zero; its sign counts in what says so.
#[derive(Clone, Debug)]
pub(super) struct Quotient<T> {
    pub(super) base: [f64; 3],
    pub(super) offset: [T; 3],
    pub(super) weight: T,
}

/// Where a line meets a plane: $s + d (n \cdot (a - s)) / (n \cdot d)$ for the line through s along d and the plane
/// through a with the normal n.
pub(super) fn line_and_plane<T: Arithmetic>(line: SpatialLine, plane: SpatialPlane) -> Quotient<T> {
    let (normal, direction) = (normal::<T>(plane), vector::<T>(line[0], line[1]));
    let along = dot(&normal, &vector(line[0], plane[0]));
    let weight = dot(&normal, &direction);
    Quotient { base: line[0], offset: scaled(&direction, &along), weight }
}

fn scaled<T: Arithmetic>(direction: &[T; 3], factor: &T) -> [T; 3] {
    [direction[0].times(factor), direction[1].times(factor), direction[2].times(factor)]
}

/// Where three planes meet, by Cramer's rule with a point of the first plane as the origin.
pub(super) fn three_planes<T: Arithmetic>(planes: &[SpatialPlane; 3]) -> Quotient<T> {
    let base = planes[0][0];
    let (f, g, h) = (normal::<T>(planes[0]), normal::<T>(planes[1]), normal::<T>(planes[2]));
    let height_g = dot(&g, &vector(base, planes[1][0]));
    let height_h = dot(&h, &vector(base, planes[2][0]));
    let (fg, hf) = (cross(&f, &g), cross(&h, &f));
    let weight = dot(&fg, &h);
    let coordinate = |axis: usize| height_g.times(&hf[axis]).plus(&height_h.times(&fg[axis]));
    Quotient { base, offset: [coordinate(0), coordinate(1), coordinate(2)], weight }
}

/// Where two lines of one plane cross, found as seen along an axis.
pub(super) fn two_lines<T: Arithmetic>(lines: [SpatialLine; 2], axis: usize) -> Quotient<T> {
    let (s, t) = (vector::<T>(lines[0][0], lines[0][1]), vector::<T>(lines[1][0], lines[1][1]));
    let weight = cross_coordinate(&s, &t, axis);
    let along = cross_coordinate(&vector(lines[0][0], lines[1][0]), &t, axis);
    Quotient { base: lines[0][0], offset: scaled(&s, &along), weight }
}

impl<T: Arithmetic> Quotient<T> {
    pub(super) fn given(coordinates: [f64; 3]) -> Self {
        let zero = || T::difference(0.0, 0.0);
        Self { base: coordinates, offset: [zero(), zero(), zero()], weight: T::difference(1.0, 0.0) }
    }

    /// A coordinate minus a number, times the weight.
    pub(super) fn above(&self, number: f64, axis: usize) -> T {
        T::difference(self.base[axis], number).times(&self.weight).plus(&self.offset[axis])
    }

    /// A coordinate minus that of another point, times both weights.
    pub(super) fn difference(&self, other: &Self, axis: usize) -> T {
        let shift = self.above(other.base[axis], axis);
        shift.times(&other.weight).minus(&other.offset[axis].times(&self.weight))
    }

    /// The vector to another point times both weights.
    pub(super) fn vector_to(&self, other: &Self) -> [T; 3] {
        [other.difference(self, 0), other.difference(self, 1), other.difference(self, 2)]
    }

    /// How far the point is in front of a plane, times the weight and the length of the normal.
    pub(super) fn height(&self, plane: SpatialPlane) -> T {
        let normal = normal::<T>(plane);
        let from_base = dot(&normal, &vector(plane[0], self.base));
        from_base.times(&self.weight).plus(&dot(&normal, &self.offset))
    }
}

impl Quotient<Dyadic> {
    /// The same point with a positive weight; `None` if the weight is zero.
    pub(super) fn with_positive_weight(self) -> Option<Self> {
        match self.weight.sign() {
            Ordering::Greater => Some(self),
            Ordering::Equal => None,
            Ordering::Less => Some(Self {
                base: self.base,
                offset: self.offset.map(|coordinate| -&coordinate),
                weight: -&self.weight,
            }),
        }
    }

    /// The nearest floating-point number of a coordinate, the number nearest to what is left, and how the coordinate
    /// compares with the first. The weight is positive.
    pub(super) fn rounded(&self, axis: usize) -> (f64, f64, Ordering) {
        let (high, residue) = self.above(0.0, axis).rounded_quotient(&self.weight);
        if residue.is_eq() || !high.is_finite() {
            return (high, 0.0, residue);
        }
        (high, self.above(high, axis).rounded_quotient(&self.weight).0, residue)
    }

    /// The exact coordinates. The weight is positive.
    pub(super) fn to_rational(&self) -> [Rational; 3] {
        [0, 1, 2].map(|axis| self.above(0.0, axis).quotient(&self.weight))
    }
}

/// The sign of a quotient's numerator, as it is when the denominator is made positive; `None` if the precision does not
/// tell.
pub(super) fn sign_over<T: Arithmetic>(numerator: &T, denominators: &[&T]) -> Option<Ordering> {
    denominators.iter().try_fold(numerator.certain_sign()?, |sign, denominator| {
        Some(if denominator.certain_sign()?.is_lt() { sign.reverse() } else { sign })
    })
}
