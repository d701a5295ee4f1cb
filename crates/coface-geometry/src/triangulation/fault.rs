//! Why sides do not bound a polygon.

use coface_algebra::Error;
use std::fmt;

/// Why walks do not bound a polygon, with the vertices and sides at fault.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TriangulationFault {
    /// Two vertices with different numbers have the same place.
    SamePlace([u32; 2]),
    /// A side begins and ends at one vertex.
    NoLength(u32),
    /// A side is listed twice in one direction.
    RepeatedSide([u32; 2]),
    /// Two sides cross, or lie on each other.
    Crossing([[u32; 2]; 2]),
    /// A vertex lies in the interior of a side.
    OnSide {
        /// The vertex.
        vertex: u32,
        /// The ends of the side.
        side: [u32; 2],
    },
    /// The sides at a vertex do not have the inside to their left.
    WrongWay(u32),
}

impl TriangulationFault {
    /// The fault with other numbers for its vertices.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::triangulation::TriangulationFault;
    /// let fault = TriangulationFault::SamePlace([0, 1]);
    /// assert_eq!(fault.renumbered(|vertex| vertex + 10), TriangulationFault::SamePlace([10, 11]));
    /// ```
    #[must_use]
    pub fn renumbered(self, number: impl Fn(u32) -> u32) -> Self {
        match self {
            Self::SamePlace(pair) => Self::SamePlace(pair.map(number)),
            Self::NoLength(vertex) => Self::NoLength(number(vertex)),
            Self::RepeatedSide(side) => Self::RepeatedSide(side.map(number)),
            Self::Crossing(sides) => Self::Crossing(sides.map(|side| side.map(&number))),
            Self::OnSide { vertex, side } => Self::OnSide { vertex: number(vertex), side: side.map(&number) },
            Self::WrongWay(vertex) => Self::WrongWay(number(vertex)),
        }
    }

    /// The cure: what to do about the fault.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::triangulation::TriangulationFault;
    /// assert_eq!(TriangulationFault::NoLength(4).cure(), "remove the repeated vertex");
    /// ```
    pub fn cure(self) -> &'static str {
        match self {
            Self::SamePlace(_) => "give points at one place one number",
            Self::NoLength(_) => "remove the repeated vertex",
            Self::RepeatedSide(_) => "let each side be there once",
            Self::Crossing(_) => "cut the polygon where its sides cross",
            Self::OnSide { .. } => "add the vertex to the walk that it lies on",
            Self::WrongWay(_) => "let outer walks run counterclockwise and holes clockwise",
        }
    }
}

impl fmt::Display for TriangulationFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::SamePlace([a, b]) => write!(f, "vertices v{a} and v{b} are at one place"),
            Self::NoLength(vertex) => write!(f, "a side begins and ends at v{vertex}"),
            Self::RepeatedSide([a, b]) => write!(f, "the side from v{a} to v{b} is there twice"),
            Self::Crossing([[a, b], [c, d]]) => {
                write!(f, "the side of v{a} and v{b} crosses the side of v{c} and v{d}")
            }
            Self::OnSide { vertex, side: [a, b] } => {
                write!(f, "v{vertex} lies on the side of v{a} and v{b}")
            }
            Self::WrongWay(vertex) => {
                write!(f, "the sides at v{vertex} do not have the inside to their left")
            }
        }
    }
}

impl From<TriangulationFault> for Error {
    fn from(fault: TriangulationFault) -> Self {
        Self::invalid(fault.to_string()).with_cure(fault.cure())
    }
}
