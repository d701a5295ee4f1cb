//! What a sparse matrix may hold.

use super::Integer;
use std::fmt;

/// The entry of a [`SparseMatrix`](super::SparseMatrix): `i32`, or [`Integer`] where 32 bits are too narrow.
///
/// No other type implements it: matrices over a field are made from integer ones by the question that needs them.
pub trait Entry: Clone + Default + Eq + fmt::Debug + fmt::Display + Send + Sync + sealed::Sealed {
    /// The value, without limit of size.
    fn to_integer(&self) -> Integer;
    /// Whether this is 0.
    fn is_zero(&self) -> bool;
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for i32 {}
    impl Sealed for super::Integer {}
}

impl Entry for i32 {
    fn to_integer(&self) -> Integer {
        Integer::from(*self)
    }

    fn is_zero(&self) -> bool {
        *self == 0
    }
}

impl Entry for Integer {
    fn to_integer(&self) -> Integer {
        self.clone()
    }

    fn is_zero(&self) -> bool {
        Integer::is_zero(self)
    }
}
