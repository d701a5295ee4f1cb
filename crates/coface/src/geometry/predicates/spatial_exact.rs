//! Points in space as quotients of exact numbers.

use super::arithmetic::{Arithmetic, cross, cross_coordinate, dot, normal, vector};
use super::{Dyadic, SpatialLine, SpatialPlane};
use crate::algebra::Rational;
use std::cmp::Ordering;

/// The point `base + offset / weight`.
#[derive(Clone, Debug)]
pub(super) struct Quotient<T> {
    pub(super) base: [f64; 3],
    pub(super) offset: [T; 3],
    pub(super) weight: T,
}

/// Where a line meets a plane: $s + d (n \cdot (a - s)) / (n \cdot d)$ for the line through s along d and the plane through a
/// with the normal n.
pub(super) fn line_and_plane<T: Arithmetic>(line: SpatialLine, plane: SpatialPlane) -> Quotient<T> {
    let (normal, direction) = (normal::<T>(plane), vector::<T>(line[0], line[1]));
    let along = dot(&normal, &vector(line[0], plane[0]));
    let weight = dot(&normal, &direction);
    Quotient { base: line[0], offset: direction.map(|d| d.times(&along)), weight }
}

/// Where three planes meet, by Cramer's rule with a point of the first plane as the origin.
pub(super) fn three_planes<T: Arithmetic>(planes: [SpatialPlane; 3]) -> Quotient<T> {
    let base = planes[0][0];
    let [f, g, h] = planes.map(normal::<T>);
    let height_g = dot(&g, &vector(base, planes[1][0]));
    let height_h = dot(&h, &vector(base, planes[2][0]));
    let (fg, hf) = (cross(&f, &g), cross(&h, &f));
    let weight = dot(&fg, &h);
    let offset = [0, 1, 2].map(|axis| height_g.times(&hf[axis]).plus(&height_h.times(&fg[axis])));
    Quotient { base, offset, weight }
}

/// Where two lines of one plane cross, found as seen along an axis.
pub(super) fn two_lines<T: Arithmetic>(lines: [SpatialLine; 2], axis: usize) -> Quotient<T> {
    let [s, t] = lines.map(|line| vector::<T>(line[0], line[1]));
    let weight = cross_coordinate(&s, &t, axis);
    let along = cross_coordinate(&vector(lines[0][0], lines[1][0]), &t, axis);
    Quotient { base: lines[0][0], offset: s.map(|d| d.times(&along)), weight }
}

/// A point with exact numbers; the weight is positive.
pub(super) type ExactPoint = Quotient<Dyadic>;

impl ExactPoint {
    pub(super) fn given(coordinates: [f64; 3]) -> Self {
        let zero = || Dyadic::from(0.0);
        Self { base: coordinates, offset: [zero(), zero(), zero()], weight: Dyadic::from(1.0) }
    }

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

    /// A coordinate times the weight.
    fn numerator(&self, axis: usize) -> Dyadic {
        &(&Dyadic::from(self.base[axis]) * &self.weight) + &self.offset[axis]
    }

    /// The nearest floating-point number of a coordinate, and the number nearest to what is left.
    pub(super) fn rounded(&self, axis: usize) -> (f64, f64, Ordering) {
        let numerator = self.numerator(axis);
        let (high, residue) = numerator.rounded_quotient(&self.weight);
        if residue.is_eq() || !high.is_finite() {
            return (high, 0.0, residue);
        }
        let rest = &numerator - &(&Dyadic::from(high) * &self.weight);
        (high, rest.rounded_quotient(&self.weight).0, residue)
    }

    pub(super) fn to_rational(&self) -> [Rational; 3] {
        [0, 1, 2].map(|axis| self.numerator(axis).quotient(&self.weight))
    }

    pub(super) fn compare_coordinate(&self, other: &Self, axis: usize) -> Ordering {
        let across = Dyadic::difference(self.base[axis], other.base[axis]);
        let shift = &(&across * &self.weight) + &self.offset[axis];
        (&(&shift * &other.weight) - &(&other.offset[axis] * &self.weight)).sign()
    }

    pub(super) fn side_of(&self, plane: SpatialPlane) -> Ordering {
        let normal = normal::<Dyadic>(plane);
        let from_base = dot(&normal, &vector(plane[0], self.base));
        (&(&from_base * &self.weight) + &dot(&normal, &self.offset)).sign()
    }

    /// The vector to another point times both weights.
    pub(super) fn vector_to(&self, other: &Self) -> [Dyadic; 3] {
        [0, 1, 2].map(|axis| {
            let across = Dyadic::difference(other.base[axis], self.base[axis]);
            let shift = &(&across * &other.weight) + &other.offset[axis];
            &(&shift * &self.weight) - &(&self.offset[axis] * &other.weight)
        })
    }
}
