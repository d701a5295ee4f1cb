//! What is known about a spline at its ends.

/// What a spline is asked for at its ends, besides running through its points.
///
/// Splines of order 2m have continuous derivatives up to degree 2m - 2; m - 1 conditions at each end make them unique. Polylines
/// need none.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum EndCondition {
    /// The spline is closed and as smooth at its first knot as at all others. The last point is the first.
    Periodic,
    /// The m pieces at each end are one polynomial. Fewer than 2m points are on one polynomial, whose degree is the number of pieces:
    /// two on a line, three on a parabola.
    #[default]
    NotAKnot,
    /// The derivatives of degree m to 2m - 2 vanish at both ends: for cubic splines the second. It costs half of the order of accuracy.
    Natural,
    /// The derivatives of degree 1 to m - 1 by the chord length are given at both ends: for cubic splines one at each.
    Complete {
        /// The derivatives at the first point, in order of degree.
        start: Vec<[f64; 2]>,
        /// The derivatives at the last point.
        end: Vec<[f64; 2]>,
    },
}
