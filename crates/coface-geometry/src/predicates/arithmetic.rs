//! Formulas that are the same in every precision.

use super::double_double::Approximation;
use super::estimate::Estimate;
use super::short_dyadic::ShortDyadic;
use super::{Dyadic, SpatialPlane};
use std::cmp::Ordering;

/// Numbers that formulas are evaluated in: an [`Estimate`], an [`Approximation`], the exact
/// [`ShortDyadic`] or the exact [`Dyadic`].
pub(super) trait Arithmetic: Sized {
    fn difference(a: f64, b: f64) -> Self;
    fn plus(&self, other: &Self) -> Self;
    fn minus(&self, other: &Self) -> Self;
    fn times(&self, other: &Self) -> Self;
    /// The order of this number and 0, if the precision tells.
    fn certain_sign(&self) -> Option<Ordering>;
}

impl Arithmetic for Estimate {
    fn difference(a: f64, b: f64) -> Self {
        Estimate::difference(a, b)
    }
    fn plus(&self, other: &Self) -> Self {
        Estimate::plus(*self, *other)
    }
    fn minus(&self, other: &Self) -> Self {
        Estimate::minus(*self, *other)
    }
    fn times(&self, other: &Self) -> Self {
        Estimate::times(*self, *other)
    }
    fn certain_sign(&self) -> Option<Ordering> {
        self.sign()
    }
}

impl Arithmetic for Approximation {
    fn difference(a: f64, b: f64) -> Self {
        Approximation::difference(a, b)
    }
    fn plus(&self, other: &Self) -> Self {
        Approximation::plus(*self, *other)
    }
    fn minus(&self, other: &Self) -> Self {
        Approximation::minus(*self, *other)
    }
    fn times(&self, other: &Self) -> Self {
        Approximation::times(*self, *other)
    }
    fn certain_sign(&self) -> Option<Ordering> {
        self.sign()
    }
}

impl Arithmetic for ShortDyadic {
    fn difference(a: f64, b: f64) -> Self {
        ShortDyadic::difference(a, b)
    }
    fn plus(&self, other: &Self) -> Self {
        ShortDyadic::plus(self, other)
    }
    fn minus(&self, other: &Self) -> Self {
        ShortDyadic::minus(self, other)
    }
    fn times(&self, other: &Self) -> Self {
        ShortDyadic::times(self, other)
    }
    fn certain_sign(&self) -> Option<Ordering> {
        ShortDyadic::certain_sign(self)
    }
}

impl Arithmetic for Dyadic {
    fn difference(a: f64, b: f64) -> Self {
        &Dyadic::from(a) - &Dyadic::from(b)
    }
    fn plus(&self, other: &Self) -> Self {
        self + other
    }
    fn minus(&self, other: &Self) -> Self {
        self - other
    }
    fn times(&self, other: &Self) -> Self {
        self * other
    }
    fn certain_sign(&self) -> Option<Ordering> {
        Some(self.sign())
    }
}

/// The sign of a formula in the first precision that tells: `sign_of!(formula(arguments))` for a `formula` that is
/// generic in its [`Arithmetic`].
macro_rules! sign_of {
    ($formula:ident($($argument:expr),*)) => {
        $formula::<$crate::predicates::estimate::Estimate>($($argument),*)
            .certain_sign()
            .or_else(|| {
                $formula::<$crate::predicates::double_double::Approximation>($($argument),*).certain_sign()
            })
            .or_else(|| {
                $formula::<$crate::predicates::short_dyadic::ShortDyadic>($($argument),*).certain_sign()
            })
            .unwrap_or_else(|| $formula::<$crate::predicates::Dyadic>($($argument),*).sign())
    };
}
pub(super) use sign_of;

/// The vector from `a` to `b`.
pub(super) fn vector<T: Arithmetic>(a: [f64; 3], b: [f64; 3]) -> [T; 3] {
    // Written out, as in the following: a map moves long numbers more than once.
    let along = |axis: usize| T::difference(b[axis], a[axis]);
    [along(0), along(1), along(2)]
}

pub(super) fn dot<T: Arithmetic>(a: &[T; 3], b: &[T; 3]) -> T {
    a[0].times(&b[0]).plus(&a[1].times(&b[1])).plus(&a[2].times(&b[2]))
}

/// One coordinate of a cross product.
pub(super) fn cross_coordinate<T: Arithmetic>(a: &[T; 3], b: &[T; 3], axis: usize) -> T {
    let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
    a[j].times(&b[k]).minus(&a[k].times(&b[j]))
}

pub(super) fn cross<T: Arithmetic>(a: &[T; 3], b: &[T; 3]) -> [T; 3] {
    [cross_coordinate(a, b, 0), cross_coordinate(a, b, 1), cross_coordinate(a, b, 2)]
}

/// The normal $(b - a) \times (c - a)$ of a plane.
pub(super) fn normal<T: Arithmetic>([a, b, c]: SpatialPlane) -> [T; 3] {
    cross(&vector(a, b), &vector(a, c))
}
