//! Which cell each cell of a finer complex is a piece of.

use super::ChainComplex;
use crate::{Error, ErrorKind, SparseMatrix};

/// For each cell of a refined complex the cell of the same degree that it is a piece of, or none for a cell inside of one
/// of a higher degree: a bridge, a cut, a vertex where a cut meets an edge. Pieces of one cell run in one direction.
///
/// A cell that is the sum of its pieces need not be a ball: it may have holes, voids and tunnels. The refined complex has the
/// homology of the space, the coarse one has the cells that were meant.
///
/// # Examples
/// A square with a square hole: edge 8 is a bridge from the hole to the rim.
/// ```
/// use coface_algebra::SparseMatrix;
/// use coface_algebra::chains::{ChainComplex, ChainRefinement};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let side = |e: usize, [a, b]: [usize; 2]| [(a, e, -1), (b, e, 1)];
/// let ends = [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4], [0, 4]];
/// let edges = SparseMatrix::from_entries(8, 9, (0..9).flat_map(|e| side(e, ends[e])))?;
/// let rims = (0..8).map(|e| (e, 0, if e < 4 { 1 } else { -1 }));
/// let refined = ChainComplex::new(vec![edges, SparseMatrix::from_entries(9, 1, rims)?])?;
/// let mut pieces: Vec<Option<u32>> = (0..8).map(Some).collect();
/// pieces.push(None);
/// let vertices = (0..8).map(Some).collect();
/// let refinement = ChainRefinement::new(vec![vertices, pieces, vec![Some(0)]]);
/// assert_eq!(refinement.coarse(&refined)?.f_vector(), [8, 8, 1]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ChainRefinement {
    /// From degree 0 on.
    pieces: Vec<Vec<Option<u32>>>,
}

impl ChainRefinement {
    /// The refinement with these lists, from degree 0 on.
    pub fn new(pieces: Vec<Vec<Option<u32>>>) -> Self {
        Self { pieces }
    }

    /// The number of degrees that there are lists for.
    pub fn degree_count(&self) -> usize {
        self.pieces.len()
    }

    /// The cell that each cell of a degree is a piece of.
    pub fn pieces(&self, degree: usize) -> impl ExactSizeIterator<Item = Option<u32>> + '_ {
        let list = self.pieces.get(degree).map_or(&[][..], Vec::as_slice);
        list.iter().copied()
    }

    /// Whether each cell is a cell, under its own number.
    pub fn is_trivial(&self) -> bool {
        self.pieces.iter().all(|list| (0..).zip(list).all(|(own, &piece)| piece == Some(own)))
    }

    /// Verifies that there is an entry for each cell.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] naming the degree and the two numbers.
    pub fn check(&self, refined: &ChainComplex) -> Result<(), Error> {
        let counts = refined.f_vector();
        for degree in 0..counts.len().max(self.pieces.len()) {
            let (known, count) =
                (self.pieces.get(degree).map_or(0, Vec::len), counts.get(degree).copied().unwrap_or(0));
            if known != count {
                return Err(Error::new(
                    ErrorKind::Shape,
                    format!(
                        "{known} entries say what cells of degree {degree} are pieces of, but there are {count} cells"
                    ),
                ));
            }
            let most = self.pieces(degree).flatten().max();
            if let Some(most) = most.filter(|&most| most as usize >= count) {
                return Err(Error::new(
                    ErrorKind::Shape,
                    format!(
                        "cells of degree {degree} are pieces of cell {most}, but there are {count} pieces: fewer cells"
                    ),
                ));
            }
        }
        Ok(())
    }

    /// The complex of the cells that the pieces make up: each boundary is the sum of the boundaries of the pieces. Cells without a
    /// piece are there, with boundary 0.
    ///
    /// # Errors
    /// Those of [`Self::check`]; `InvalidInput` if the sums make no complex.
    pub fn coarse(&self, refined: &ChainComplex) -> Result<ChainComplex, Error> {
        self.check(refined)?;
        let count = |degree: usize| self.pieces(degree).flatten().max().map_or(0, |most| most as usize + 1);
        // What is summed up for a cell: all pieces of a facet have the same coefficient in it, so the first is enough.
        let first_piece = |degree: usize| {
            let mut is_first = Vec::with_capacity(refined.cell_count(degree));
            let mut is_known = vec![false; count(degree)];
            for piece in self.pieces(degree) {
                is_first
                    .push(piece.is_some_and(|piece| !std::mem::replace(&mut is_known[piece as usize], true)));
            }
            is_first
        };
        let mut matrices = Vec::new();
        for (degree, matrix) in (1..).zip(refined.boundary_matrices()) {
            let is_first = first_piece(degree - 1);
            let facets = &self.pieces[degree - 1];
            let row = |facet: usize| facets.get(facet).copied().flatten().map(|piece| piece as usize);
            let entries = self.pieces(degree).enumerate().filter_map(|(cell, piece)| Some((cell, piece?)));
            let entries = entries.flat_map(|(cell, piece)| {
                let own = matrix.column(cell).iter().filter(|&(facet, _)| is_first[facet]);
                own.filter_map(|(facet, entry)| Some((row(facet)?, piece as usize, i64::from(entry))))
                    .collect::<Vec<_>>()
            });
            matrices.push(SparseMatrix::from_entries(count(degree - 1), count(degree), entries)?);
        }
        if matrices.is_empty() { Ok(ChainComplex::of_points(count(0))) } else { ChainComplex::new(matrices) }
    }
}
