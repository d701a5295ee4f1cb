//! What keeps curves from bounding a Yin set.

use coface_algebra::Error;
use std::fmt;

/// Why curves are not the boundary of a Yin set, with a witness. Curves are named by their places among those that were given; points
/// are rounded to floating-point numbers.
///
/// # Examples
/// ```
/// use coface_yin::{Curve, YinFault, YinSet};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let bow = Curve::polyline(&[[0., 0.], [2., 2.], [2., 0.], [0., 2.], [0., 0.]])?;
/// assert_eq!(YinSet::fault(&[bow])?, Some(YinFault::SelfMeeting { curve: 0, point: [1.0, 1.0] }));
/// # Ok(()) }
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum YinFault {
    /// A curve does not end where it begins.
    Open {
        /// The curve.
        curve: usize,
    },
    /// A closed polyline has less than three pieces.
    TooFewPieces {
        /// The curve.
        curve: usize,
    },
    /// A piece begins and ends in one point without leaving it.
    ZeroLength {
        /// The curve.
        curve: usize,
        /// Its piece.
        piece: usize,
    },
    /// A curve comes to a point more than once: it crosses or touches itself.
    SelfMeeting {
        /// The curve.
        curve: usize,
        /// The point.
        point: [f64; 2],
    },
    /// Two curves cross.
    Crossing {
        /// The curves.
        curves: [usize; 2],
        /// The point.
        point: [f64; 2],
    },
    /// Curves share an arc; both are one curve where that runs along itself.
    Overlap {
        /// The curves.
        curves: [usize; 2],
        /// The ends of the arc.
        ends: [[f64; 2]; 2],
    },
    /// A curve has the orientation of the smallest curve around it: positive and negative ones have to alternate.
    Orientation {
        /// The curve.
        curve: usize,
        /// The curve around it.
        parent: usize,
    },
    /// Of two curves that lie in no other one is positive and one negative.
    MixedRoots {
        /// The curves.
        curves: [usize; 2],
    },
}

impl fmt::Display for YinFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Open { curve } => write!(f, "curve {curve} does not end where it begins"),
            Self::TooFewPieces { curve } => write!(f, "closed polyline {curve} has less than three pieces"),
            Self::ZeroLength { curve, piece } => write!(f, "piece {piece} of curve {curve} has no length"),
            Self::SelfMeeting { curve, point: [x, y] } => {
                write!(f, "curve {curve} comes to ({x}, {y}) more than once")
            }
            Self::Crossing { curves: [a, b], point: [x, y] } => {
                write!(f, "curves {a} and {b} cross at ({x}, {y})")
            }
            Self::Overlap { curves: [a, b], ends: [[x, y], [z, w]] } if a == b => {
                write!(f, "curve {a} runs along itself from ({x}, {y}) to ({z}, {w})")
            }
            Self::Overlap { curves: [a, b], ends: [[x, y], [z, w]] } => {
                write!(f, "curves {a} and {b} share what is between ({x}, {y}) and ({z}, {w})")
            }
            Self::Orientation { curve, parent } => {
                write!(f, "curve {curve} has the orientation of curve {parent}, which is directly around it")
            }
            Self::MixedRoots { curves: [a, b] } => {
                write!(f, "curves {a} and {b} lie in no other, and one is positive, the other negative")
            }
        }
    }
}

impl YinFault {
    /// The fault with other numbers of curves.
    pub(crate) fn renumbered(self, number: impl Fn(usize) -> usize) -> Self {
        match self {
            Self::Open { curve } => Self::Open { curve: number(curve) },
            Self::TooFewPieces { curve } => Self::TooFewPieces { curve: number(curve) },
            Self::ZeroLength { curve, piece } => Self::ZeroLength { curve: number(curve), piece },
            Self::SelfMeeting { curve, point } => Self::SelfMeeting { curve: number(curve), point },
            Self::Crossing { curves, point } => Self::Crossing { curves: curves.map(number), point },
            Self::Overlap { curves, ends } => Self::Overlap { curves: curves.map(number), ends },
            Self::Orientation { curve, parent } => {
                Self::Orientation { curve: number(curve), parent: number(parent) }
            }
            Self::MixedRoots { curves } => Self::MixedRoots { curves: curves.map(number) },
        }
    }

    /// The fault as an error with a cure.
    pub(crate) fn into_error(self) -> Error {
        let cure = match self {
            Self::Open { .. } => "end the curve in its first point",
            Self::TooFewPieces { .. } => "give a curve that bounds something",
            Self::ZeroLength { .. } => "leave repeated points out",
            Self::SelfMeeting { .. } | Self::Crossing { .. } | Self::Overlap { .. } => {
                "repair the curves with a fill rule"
            }
            Self::Orientation { .. } => "reverse one of the two, or repair the curves with a fill rule",
            Self::MixedRoots { .. } => "reverse one of the two: positive ones bound a bounded set",
        };
        Error::invalid(self.to_string()).with_cure(cure)
    }
}
