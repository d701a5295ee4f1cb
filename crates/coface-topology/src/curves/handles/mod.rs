//! Handle loops and tunnel loops of closed surfaces in space.
//!
//! # Words
//! * A cycle on a closed surface in space is a **handle loop** if it bounds on the inside of its component but no multiple of it bounds on
//!   the outside, and a **tunnel loop** the other way round. On a component of genus g each kind spans a subgroup of rank g, and
//!   together they are the first homology.
//! * The **linking matrix** has the linking number of each loop of a tree-cotree decomposition with each other one pushed off to the
//!   outside. A class x is of a handle loop if x times the matrix vanishes, a class y of a tunnel loop if the matrix times y does.
//! * A **fingerprint** of a walk is a few numbers modulo a large prime, by which classes are told apart while loops are looked for; of those
//!   that are kept the integers decide.

mod cover_search;
mod linking_matrix;
mod loop_search;
mod pairing;
#[cfg(test)]
mod tests;

use super::{ClosedWalk, ShortestCycle, SurfaceHomology, TreeCotree};
use crate::curves::shortest_paths::checked_lengths;
use coface_algebra::{EdgeId, Error, ErrorKind};
use coface_complexes::surface::{GeneralizedMap, LinkingTerm};
use loop_search::{Chosen, LoopSearch};

/// The linking terms of some edges, as `linking_terms` of `coface_complexes::surface` finds them.
type Linking<'a> = &'a dyn Fn(&[EdgeId]) -> Result<Vec<LinkingTerm>, Error>;

/// Where a loop on a closed surface in space bounds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum HandleKind {
    /// It bounds on the inside: it runs around a handle.
    Handle,
    /// It bounds on the outside: it runs around a hole.
    Tunnel,
}

/// A handle loop and a tunnel loop that cross an odd number of times.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct HandlePair {
    handle: ShortestCycle,
    tunnel: ShortestCycle,
    component: usize,
}

impl HandlePair {
    /// The loop that bounds on the inside.
    ///
    /// # Examples
    /// See [`handle_pairs`].
    pub fn handle(&self) -> &ShortestCycle {
        &self.handle
    }

    /// The loop that bounds on the outside.
    ///
    /// # Examples
    /// See [`handle_pairs`].
    pub fn tunnel(&self) -> &ShortestCycle {
        &self.tunnel
    }

    /// The component that they are on, as in [`TreeCotree::components`].
    ///
    /// # Examples
    /// See [`handle_pairs`].
    pub fn component(&self) -> usize {
        self.component
    }

    /// The kind of the shorter loop; of two of one length it is the handle.
    ///
    /// # Examples
    /// See [`handle_pairs`].
    pub fn shorter(&self) -> HandleKind {
        if self.handle.length() <= self.tunnel.length() { HandleKind::Handle } else { HandleKind::Tunnel }
    }

    /// The length of the shorter loop.
    ///
    /// # Examples
    /// See [`handle_pairs`].
    pub fn length(&self) -> f64 {
        self.handle.length().min(self.tunnel.length())
    }
}

/// Short handle loops and tunnel loops of a closed surface in space: as many pairs as its components have handles, those with the shortest loop
/// first.
///
/// `linking` gives the linking form on some edges, as [`coface_complexes::surface::linking_terms`] does for vertices with positions.
/// `lengths` has a length for each edge; without it, each edge has the length 1. The loops are a basis of the first homology over Z/2. Each
/// is an edge closed up along shortest paths from a vertex of a short graph that every such loop meets, and of all these loops the shortest
/// independent ones of their kind are kept; where they do not suffice, as on a knotted tube, it is such a loop in a part of the
/// cover in which all loops are of that kind, or else a walk without a bound on its length. Searches may reach about `most` vertices in all;
/// when that is not enough for all vertices of the graph, some of them are taken.
///
/// # Errors
/// [`ErrorKind::Shape`] and [`ErrorKind::InvalidInput`] for lengths that are not one for each edge, finite and not negative; those of
/// `linking`; [`ErrorKind::InvalidInput`] if its numbers are those of no surface in space.
///
/// # Complexity
/// $O(g \ell + g^3)$ for the linking numbers, with the total length $\ell$ of 2g loops, and the searches: about `most` times
/// $\log n$.
///
/// # References
/// T. K. Dey, F. Fan, Y. Wang, *An efficient computation of handle and tunnel loops via Reeb graphs* (2013); T. K. Dey, K. Li, J. Sun,
/// *On computing handle and tunnel loops* (2007). Here the linking numbers are those of a tree-cotree decomposition instead of a Reeb graph.
///
/// # Examples
/// The torus with seven vertices has one handle and one tunnel.
/// ```
/// use coface_complexes::shapes;
/// use coface_complexes::surface::{GeneralizedMap, PolygonMesh, linking_terms};
/// use coface_topology::handle_pairs;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let torus = shapes::csaszar_torus()?;
/// let mesh = PolygonMesh::new(torus.vertex_count(), torus.cells().clone(), &[])?;
/// let map = GeneralizedMap::new(mesh.two_skeleton()?)?;
/// let linking = |edges: &[_]| linking_terms(&map, torus.positions(), edges);
/// let pairs = handle_pairs(&map, None, &linking, 1_000_000)?;
/// assert_eq!(pairs.len(), 1);
/// assert_eq!(pairs[0].handle().length(), 3.0);
/// assert!(pairs[0].tunnel().length() >= 3.0);
/// # Ok(()) }
/// ```
pub fn handle_pairs(
    map: &GeneralizedMap,
    lengths: Option<&[f64]>,
    linking: Linking<'_>,
    most: usize,
) -> Result<Vec<HandlePair>, Error> {
    let lengths = checked_lengths(map, lengths)?;
    let trees = TreeCotree::greedy(map, None, Some(&lengths))?;
    check_kind(map, &trees)?;
    let homology = SurfaceHomology::new(map, &trees);
    let mut search = LoopSearch::new(map, &lengths, &trees, &homology, linking)?;
    let chosen = search.basis(most)?;
    let cycle = |chosen: &Chosen| -> Result<ShortestCycle, Error> {
        Ok(ShortestCycle::new(ClosedWalk::new(map.skeleton(), chosen.steps.clone())?, &lengths))
    };
    let mut pairs = Vec::new();
    for [handle, tunnel] in pairing::pairs(&chosen, search.linking())? {
        let component = handle.component;
        pairs.push(HandlePair { handle: cycle(handle)?, tunnel: cycle(tunnel)?, component });
    }
    pairs.sort_by(|a, b| a.length().total_cmp(&b.length()));
    Ok(pairs)
}

/// Handle loops and tunnel loops below a length.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct ShortHandleLoops {
    loops: Vec<(HandleKind, ShortestCycle)>,
    is_complete: bool,
}

impl ShortHandleLoops {
    /// The loops, shortest first. They are independent over Z/2.
    ///
    /// # Examples
    /// See [`short_handle_loops`].
    pub fn loops(&self) -> &[(HandleKind, ShortestCycle)] {
        &self.loops
    }

    /// Whether all searches were done.
    ///
    /// # Examples
    /// See [`short_handle_loops`].
    pub fn is_complete(&self) -> bool {
        self.is_complete
    }
}

/// The handle loops and tunnel loops of [`handle_pairs`] that are shorter than `below`, and no others; they need not come in pairs.
///
/// # Errors
/// Those of [`handle_pairs`].
///
/// # Complexity
/// That of [`handle_pairs`]; searches go no farther than half of `below`.
///
/// # References
/// Those of [`handle_pairs`].
///
/// # Examples
/// ```
/// use coface_complexes::shapes;
/// use coface_complexes::surface::{GeneralizedMap, PolygonMesh, linking_terms};
/// use coface_topology::short_handle_loops;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let torus = shapes::csaszar_torus()?;
/// let mesh = PolygonMesh::new(torus.vertex_count(), torus.cells().clone(), &[])?;
/// let map = GeneralizedMap::new(mesh.two_skeleton()?)?;
/// let linking = |edges: &[_]| linking_terms(&map, torus.positions(), edges);
/// let short = |below| short_handle_loops(&map, None, &linking, below, 1_000_000);
/// assert!(short(3.0)?.loops().is_empty() && short(3.0)?.is_complete());
/// assert!(!short(3.5)?.loops().is_empty());
/// # Ok(()) }
/// ```
pub fn short_handle_loops(
    map: &GeneralizedMap,
    lengths: Option<&[f64]>,
    linking: Linking<'_>,
    below: f64,
    most: usize,
) -> Result<ShortHandleLoops, Error> {
    let lengths = checked_lengths(map, lengths)?;
    let trees = TreeCotree::greedy(map, None, Some(&lengths))?;
    check_kind(map, &trees)?;
    let homology = SurfaceHomology::new(map, &trees);
    let mut search = LoopSearch::new(map, &lengths, &trees, &homology, linking)?;
    let is_complete = search.look(below, most);
    let mut loops = Vec::new();
    for chosen in search.chosen()? {
        let walk = ClosedWalk::new(map.skeleton(), chosen.steps)?;
        loops.push((chosen.kind, ShortestCycle::new(walk, &lengths)));
    }
    loops.sort_by(|a, b| a.1.length().total_cmp(&b.1.length()));
    Ok(ShortHandleLoops { loops, is_complete })
}

/// Only closed orientable surfaces have handles and tunnels.
fn check_kind(map: &GeneralizedMap, trees: &TreeCotree) -> Result<(), Error> {
    let fault = if trees.components().iter().any(|component| component.has_boundary()) {
        "has a boundary"
    } else if map.orientation().conflicts().iter().any(Option::is_some) {
        "is not orientable"
    } else {
        return Ok(());
    };
    Err(Error::new(
        ErrorKind::NonManifold,
        format!("the surface {fault}: it has no inside and outside, so no handle and tunnel loops"),
    )
    .with_cure("give a closed orientable surface"))
}
