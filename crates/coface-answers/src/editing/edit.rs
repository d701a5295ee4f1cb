//! One edit of a surface.

use coface_algebra::Error;
use serde::{Deserialize, Serialize};
use std::fmt;
use std::str::FromStr;

/// An edge or a halfedge: by its number, or by the vertices that it goes from and to.
///
/// # Examples
/// ```
/// use coface_answers::CellName;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// assert_eq!("7".parse::<CellName>()?, CellName::Number(7));
/// assert_eq!("3 5".parse::<CellName>()?, CellName::Ends([3, 5]));
/// assert!("3 5 6".parse::<CellName>().is_err());
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(untagged)]
pub enum CellName {
    /// Its number.
    Number(usize),
    /// Its source and its target.
    Ends([usize; 2]),
}

impl CellName {
    /// The cell of this number.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::CellName;
    /// assert_eq!(CellName::of(3), CellName::Number(3));
    /// ```
    pub fn of(number: usize) -> Self {
        Self::Number(number)
    }
}

impl fmt::Display for CellName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(number) => write!(f, "{number}"),
            Self::Ends([a, b]) => write!(f, "{a} {b}"),
        }
    }
}

impl FromStr for CellName {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self, Error> {
        let words: Vec<&str> = text.split([' ', ',', '-', '\t']).filter(|word| !word.is_empty()).collect();
        let number = |word: &str| {
            word.trim_start_matches(['v', 'e', 'h']).parse::<usize>().map_err(|_| {
                Error::invalid(format!("{word:?} is no number"))
                    .with_cure("write 7, or two vertices: \"3 5\"")
            })
        };
        match words[..] {
            [one] => number(one).map(Self::Number),
            [a, b] => Ok(Self::Ends([number(a)?, number(b)?])),
            _ => Err(Error::invalid(format!("{text:?} is neither a number nor two vertices"))
                .with_cure("write 7, or two vertices: \"3 5\"")),
        }
    }
}

/// A local change of a surface that keeps its homeomorphism type.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(tag = "op", rename_all = "snake_case")]
pub enum Edit {
    /// Turns an edge by one corner counterclockwise: between two triangles, the other diagonal.
    FlipEdge {
        /// The edge.
        edge: CellName,
    },
    /// Turns an edge by one corner clockwise.
    FlipEdgeBack {
        /// The edge.
        edge: CellName,
    },
    /// Puts a vertex on an edge, in its middle.
    SplitEdge {
        /// The edge.
        edge: CellName,
    },
    /// Removes a vertex with exactly two edges, which become one.
    RemoveVertex {
        /// The vertex.
        vertex: usize,
    },
    /// Splits a face by an edge between the corners of two of its halfedges, at their sources.
    SplitFace {
        /// The halfedge at the first corner.
        from: CellName,
        /// The halfedge at the second corner.
        to: CellName,
    },
    /// Removes an edge between two different faces, which become one.
    RemoveEdge {
        /// The edge.
        edge: CellName,
    },
    /// Draws a vertex out to an edge, between the corners of two of the halfedges that leave it.
    SplitVertex {
        /// The halfedge at the first corner.
        from: CellName,
        /// The halfedge at the second corner.
        to: CellName,
    },
    /// Contracts an edge to a vertex: its faces lose a side each.
    ContractEdge {
        /// The edge.
        edge: CellName,
    },
    /// Removes an edge with an end where no other edge is.
    RemovePendantEdge {
        /// The edge.
        edge: CellName,
    },
    /// Collapses an edge to a vertex together with the triangles beside it, where the mesh stays a simplicial complex.
    CollapseEdge {
        /// The edge.
        edge: CellName,
    },
    /// Puts a vertex inside a face and joins it to each corner.
    PokeFace {
        /// The face.
        face: usize,
    },
}

/// An edit that was done, and how it is undone.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct EditRecord {
    /// What was done.
    #[serde(flatten)]
    pub edit: Edit,
    /// The edits that undo it, in their order, by the numbers of cells after it. They bring the same surface back; where a cell
    /// had been removed, numbers may be others than before.
    pub inverse: Vec<Edit>,
    /// The vertex that was added.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub added_vertex: Option<usize>,
    /// The vertex that the ends of a collapsed edge are now.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub kept_vertex: Option<usize>,
}
