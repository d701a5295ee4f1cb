//! Models whose cells are lists of vertices, and the operators between their cells.
//!
//! # Words
//! * A [`LarModel`] (linear algebraic representation) has for each degree k from 1 on a list of **k-cells**, each the set of
//!   its vertices. Nothing else is stored; facets can be given beside it where vertices do not tell them.
//! * The **characteristic matrix** of degree k has a row a k-cell and a column a vertex, with 1 where the vertex belongs to
//!   the cell.
//! * An [`Operator`] is a pair of degrees, written as two of the letters V, E, F, C: the rows of `FE` are faces, its columns
//!   edges. Its **shared vertices** are a matrix of counts, the product of two characteristic matrices.
//! * Two cells are **related** when they share enough vertices, as [`Shared`] says. [`LarModel::related`] finds the pairs
//!   without storing the product.
//! * Two cells are **incident** when one is a face of the other; cells of one degree are **adjacent** when they share a facet,
//!   vertices when an edge joins them.
//!
//! * [`OrientedCells`] have signs of their facets that make each boundary a cycle: [`oriented_boundary`] finds them.
//!
//! Counts of vertices are not incidence: an edge whose ends lie on a non-convex face shares two vertices with it and need
//! not be an edge of it.
//!
//! # References
//! A. DiCarlo, A. Paoluzzi, V. Shapiro, *Linear algebraic representation for topological structures* (2014).

mod chain_complex;
mod conversion;
mod facets;
mod incidence;
mod model;
mod operator;
mod orientation;
mod overlaps;
mod parts;
#[cfg(test)]
pub(crate) mod samples;
mod shared_vertices;

pub use chain_complex::TopOrientation;
pub use model::LarModel;
pub use operator::Operator;
pub use shared_vertices::Shared;

pub use orientation::{CellCoherence, OrientedCells, oriented_boundary, signed_measures};
