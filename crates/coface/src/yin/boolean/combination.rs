//! What a Boolean combination gives: the set, and where its boundary comes from.

use crate::yin::YinSet;

/// The part of an operand that a piece of a result is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PieceSource {
    /// The operand, counted from 0.
    pub operand: u32,
    /// The curve of the operand.
    pub curve: u32,
    /// The piece of that curve.
    pub piece: u32,
    /// The parameters in `[0, 1]` on that piece at which the piece of the result begins and ends. They fall where the result runs
    /// against its source.
    pub range: [f64; 2],
}

/// A Boolean combination of Yin sets.
#[derive(Clone, Debug)]
pub struct Combination {
    pub(super) set: YinSet,
    /// For the pieces of all curves of the result, one after the other.
    pub(super) sources: Vec<PieceSource>,
}

impl Combination {
    /// The set.
    pub fn set(&self) -> &YinSet {
        &self.set
    }

    /// The set alone.
    pub fn into_set(self) -> YinSet {
        self.set
    }

    /// Where the pieces of the boundary come from, those of one curve after those of another.
    pub fn sources(&self) -> &[PieceSource] {
        &self.sources
    }
}
