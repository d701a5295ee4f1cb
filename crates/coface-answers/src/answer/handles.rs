//! The answers of `cycles --handles` and `cycles --fill-handles`.

use super::{ClosedPath, Remark};
use serde::{Deserialize, Serialize};

/// The handles of closed surfaces in space, each by a handle loop and a tunnel loop.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct HandlesAnswer {
    /// The name of the input.
    pub file: String,
    /// The sum of the genera of the components: there are as many handles.
    pub genus: usize,
    /// Only handles whose shorter loop is shorter than this are listed; `null` if all are.
    pub shorter_than: Option<f64>,
    /// The handles, that with the shortest loop first.
    pub handles: Vec<HandleAnswer>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

/// A handle: a handle loop and a tunnel loop that cross an odd number of times.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct HandleAnswer {
    /// The component that it is on, from 0 in the order of the first vertices of components.
    pub component: usize,
    /// Which loop is the shorter one.
    pub shorter: LoopKind,
    /// The length of the shorter loop, in the unit of the file.
    pub length: f64,
    /// The loop that bounds on the inside of its component, but not on the outside.
    pub handle: ClosedPath,
    /// The loop that bounds on the outside, but not on the inside.
    pub tunnel: ClosedPath,
}

/// Where a loop on a closed surface in space bounds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum LoopKind {
    /// On the inside: it runs around a handle.
    Handle,
    /// On the outside: it runs around a hole.
    Tunnel,
}

impl LoopKind {
    /// The word of the answer.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_answers::answer::LoopKind::Tunnel.name(), "tunnel");
    /// ```
    pub fn name(self) -> &'static str {
        match self {
            Self::Handle => "handle",
            Self::Tunnel => "tunnel",
        }
    }
}

/// Closed surfaces without their short handles, with what shows it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FilledHandlesAnswer {
    /// The name of the input.
    pub file: String,
    /// Handles with a loop shorter than this were filled; `null` if all were to be.
    pub shorter_than: Option<f64>,
    /// The surface before, and after.
    pub before: HandleCounts,
    /// The surface that was made. No triangles of it have points in common but their common vertices and sides; this was decided exactly.
    pub after: HandleCounts,
    /// The loops along which the surface was cut and filled, in this order. A later loop may run over vertices that were added before.
    pub filled: Vec<FilledHandle>,
    /// Loops below the length that could not be filled without triangles that meet others.
    pub left: Vec<LeftHandle>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

/// The size and the kind of a surface.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct HandleCounts {
    /// The numbers of vertices, edges and triangles. Vertices in no triangle do not count.
    pub f_vector: [usize; 3],
    /// The number of components.
    pub components: usize,
    /// The Euler characteristic: twice the components less twice the genus.
    pub euler_characteristic: i64,
    /// The sum of the genera of the components.
    pub genus: usize,
    /// Whether it is a manifold without boundary.
    pub closed: bool,
    /// Whether its triangles agree, or can be turned to agree.
    pub orientable: bool,
}

/// A loop along which a surface was cut, and both rims filled.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FilledHandle {
    /// On which side the rims were filled: a handle on the inside, a tunnel on the outside.
    pub kind: LoopKind,
    /// The loop. One of its two rims keeps its vertices.
    #[serde(flatten)]
    pub path: ClosedPath,
    /// The vertices of the other rim, in the order of the first ones, without repetition.
    pub added_vertices: Vec<u32>,
    /// The number of triangles that fill both rims.
    pub added_triangles: usize,
}

/// A loop that was not filled.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct LeftHandle {
    /// Where it bounds.
    pub kind: LoopKind,
    /// The loop.
    #[serde(flatten)]
    pub path: ClosedPath,
}
