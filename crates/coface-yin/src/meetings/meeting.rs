//! What two pieces have in common: points and arcs.

/// A common point of two pieces, or of a piece with itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Meeting {
    /// The pieces, the lower number first.
    pub(crate) pieces: [u32; 2],
    /// Intervals between 0 and 1 in which the parameters lie; of an end the end alone.
    pub(crate) parameters: [[f64; 2]; 2],
    /// The best parameters.
    pub(crate) at: [f64; 2],
    /// The point; bit for bit the end of a piece where a parameter is 0 or 1 (of the first one where both are).
    pub(crate) point: [f64; 2],
    /// Whether it is proven that the pieces have exactly one common point there. If not they are within the resolution of each other
    /// there, or of an end of one of them.
    pub(crate) is_certified: bool,
}

/// An arc that two pieces have in common.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Overlap {
    /// The pieces, the lower number first.
    pub(crate) pieces: [u32; 2],
    /// The parameters of both pieces where the arc begins and ends: rising for the first piece, falling for the second when it runs
    /// against it.
    pub(crate) ranges: [[f64; 2]; 2],
    /// Whether the arc is common exactly: equal pieces, and segments. If not the pieces are within the resolution of each other.
    pub(crate) is_certified: bool,
}

/// What a pair of pieces, or many, have in common.
#[derive(Default)]
pub(super) struct Found {
    pub(super) points: Vec<Meeting>,
    pub(super) overlaps: Vec<Overlap>,
    pub(super) exhausted: Vec<[u32; 2]>,
}
