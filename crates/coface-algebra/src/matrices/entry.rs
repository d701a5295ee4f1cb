//! The entries of sparse matrices.

use crate::integers::Integer;
use std::fmt;

/// The entry of a [`SparseMatrix`](crate::matrices::sparse_matrix::SparseMatrix): `i32`, or [`Integer`] where 32 bits
/// are too narrow.
///
/// No other type implements it: matrices over a field are made from integer ones by the question that needs them.
pub trait Entry: Clone + Default + Eq + fmt::Debug + fmt::Display + Send + Sync + sealed::Sealed {
    /// The value, without limit of size.
    fn to_integer(&self) -> Integer;
    /// The value if it fits in 64 bits.
    fn to_i64(&self) -> Option<i64>;
    /// Whether this is 0.
    fn is_zero(&self) -> bool;
    /// Whether a matrix may store this: not 0, and not $-2^{31}$ in 32 bits, which has no opposite there.
    fn is_storable(&self) -> bool;
    /// The opposite of an entry that a matrix stores.
    #[must_use]
    fn negated(&self) -> Self;
    /// Whether this is below 0.
    fn is_negative(&self) -> bool;
    /// Whether this is 1 or -1.
    fn is_unit(&self) -> bool;
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for i32 {}
    impl Sealed for crate::integers::Integer {}
}

impl Entry for i32 {
    fn to_integer(&self) -> Integer {
        Integer::from(*self)
    }

    fn to_i64(&self) -> Option<i64> {
        Some(i64::from(*self))
    }

    fn is_zero(&self) -> bool {
        *self == 0
    }

    fn is_storable(&self) -> bool {
        !matches!(*self, 0 | i32::MIN)
    }

    fn negated(&self) -> Self {
        -*self
    }

    fn is_negative(&self) -> bool {
        *self < 0
    }

    fn is_unit(&self) -> bool {
        matches!(*self, 1 | -1)
    }
}

impl Entry for Integer {
    fn to_integer(&self) -> Integer {
        self.clone()
    }

    fn to_i64(&self) -> Option<i64> {
        Integer::to_i64(self)
    }

    fn is_zero(&self) -> bool {
        Integer::is_zero(self)
    }

    fn is_storable(&self) -> bool {
        !self.is_zero()
    }

    fn negated(&self) -> Self {
        -self
    }

    fn is_negative(&self) -> bool {
        self.signum() < 0
    }

    fn is_unit(&self) -> bool {
        Integer::is_unit(self)
    }
}
