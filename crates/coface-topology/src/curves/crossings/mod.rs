//! Shortest cycles found where they cross cuts.
//!
//! # Words and conventions
//! * A **piece** is a connected surface that is left when a surface is cut. A cut is a shortest path from one hole to another, or a shortest
//!   loop of the wanted kind at a vertex or at a hole, which counts as a point.
//! * A shortest cycle of the kind crosses such a cut at most once, where it runs along it or touches it as a whole, or it can be exchanged for
//!   one that does. Let it meet a shortest path at two places. The path between them makes with one of its two parts a cycle of the kind that is not
//!   longer (of three paths with the same ends, if one pair makes a cycle of the kind, a second pair does) and crosses the cut less often. Let it
//!   meet a shortest loop at x = a m b at both ends of m, and let c and d be its parts. If c and m make a cycle of the kind, then d is shorter than m, or
//!   could be exchanged for it; so a d b is a shorter loop and not of the kind; so d and m make a cycle of the kind, and the same is true of a c b; so c
//!   and d make none.
//! * If it crosses the cut once, it is a path from a vertex on one side of the cut to the same vertex on the other side; all such paths are
//!   cycles of the kind. If it does not, it lies on a piece that is left, on which it is a shortest cycle again. In the end all pieces are spheres
//!   with at most one hole.
//! * A loop at the only hole of a piece is asked to be of the kind when the hole is filled. What it may cross twice, cycles that are
//!   homotopic to the boundary, crosses once a shortest path between the two holes of a double cover. Such a cycle separates.
//! * Shortest paths from **sources** that move along one side of the cut are found in an interval at a time. The trees from the ends of an interval
//!   have many arcs in common. If the paths to a node are homotopic, the sources moved along the boundary, they bound a disk with it, and paths from the
//!   sources between them need not leave it; if both end with the same arc, so do these, and the arc is contracted. The paths from all
//!   sources to a node do not cross, so that they are of few homotopy classes, each of a range of sources, and turn around the node once: what is
//!   left in all intervals of one size is of the size of the surface, times its genus.
//!
//! # References
//! S. Cabello, E. Chambers, J. Erickson, *Multiple-source shortest paths in embedded graphs* (2013), for moving sources, cuts and
//! covers; D. Das, E. Kipouridis, M. Probst Gutenberg, C. Wulff-Nilsen, *A simple algorithm for multiple-source shortest paths in
//! planar digraphs* (2022), for intervals and contraction.

mod free_words;
mod moving_source;
mod piece;
mod search;
#[cfg(test)]
mod tests;
mod weights;

pub(super) use search::search;
