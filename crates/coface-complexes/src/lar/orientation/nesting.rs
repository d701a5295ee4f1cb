//! Orientation by positions: holes against rims, voids against outer shells, positive areas and volumes.

use super::OrientedCells;
use super::measure::{Frame, check_full};
use coface_algebra::{Error, ErrorKind};
use coface_algebra::{Integer, Sign, SparseMatrix};
use coface_geometry::Positions;
use rayon::prelude::*;

impl OrientedCells {
    /// The cells with the components of their boundaries related: the component with the largest area or volume is the outer
    /// one, the others run opposite to it, and the lowest facet of the whole cell is positive.
    ///
    /// `lower` has the boundary matrices below the cells, from edges on: one for faces, two for 3-cells. Areas of faces in
    /// space are compared as vectors; 3-cells are measured in space only. All comparisons are exact.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] for cells of another degree with several components, for 3-cells without three coordinates, and
    /// for vertices without position; [`ErrorKind::InvalidInput`] naming a cell with a component that measures nothing,
    /// or with two largest ones.
    ///
    /// # Complexity
    /// Linear in the boundaries of cells with several components, in integers of any size; nothing is done for others.
    ///
    /// # Examples
    /// A square of side 3 with a square hole of side 1, both listed counterclockwise:
    /// ```
    /// use coface_algebra::{RaggedArray, SparseMatrix};
    /// use coface_complexes::lar::{LarModel, oriented_boundary};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edges = [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4]];
    /// let model = LarModel::new(8, vec![RaggedArray::from_lists(edges)])?;
    /// let corners = [0., 0., 3., 0., 3., 3., 0., 3., 1., 1., 2., 1., 2., 2., 1., 2.];
    /// let lower = [model.edge_boundaries()?];
    /// let face = oriented_boundary(&lower[0], &RaggedArray::from_lists([[0, 1, 2, 3, 4, 5, 6, 7]]))?;
    /// let face = face.nested(&lower, &Positions::from_flat(2, corners.to_vec())?)?;
    /// assert_eq!(face.boundary().column(0).entries(), [1, 1, 1, 1, -1, -1, -1, -1]);
    /// # Ok(()) }
    /// ```
    pub fn nested(self, lower: &[SparseMatrix], positions: &Positions) -> Result<Self, Error> {
        if self.first_disconnected().is_none() {
            return Ok(self);
        }
        let frame = Frame::new(lower, positions)?;
        let degree = frame.degree();
        if !(degree == 2 && positions.dimension() >= 2 || degree == 3 && positions.dimension() == 3) {
            return Err(Error::new(
                ErrorKind::Shape,
                format!(
                    "cells of degree {degree} with several components and {} coordinates cannot be oriented",
                    positions.dimension()
                ),
            )
            .with_cure("components are related for faces and, in space, for 3-cells"));
        }
        let turned: Result<Vec<Vec<Sign>>, Error> = (0..self.cell_count())
            .into_par_iter()
            .with_min_len(1 << 8)
            .map(|cell| match self.component_count(cell) {
                0 | 1 => Ok(Vec::new()),
                count => self.component_signs(&frame, cell, count),
            })
            .collect();
        let mut entries = self.boundary().entries().to_vec();
        for (cell, signs) in turned?.iter().enumerate().filter(|(_, signs)| !signs.is_empty()) {
            let start = self.boundary().column_starts()[cell] as usize;
            for at in 0..self.boundary().column(cell).rows().len() {
                entries[start + at] *= signs[self.component(cell, at) as usize].to_i32();
            }
        }
        Ok(self.with_entries(entries))
    }

    /// The sign of each component of a cell.
    fn component_signs(&self, frame: &Frame<'_>, cell: usize, count: usize) -> Result<Vec<Sign>, Error> {
        let terms: Vec<(usize, i32)> = self.boundary().column(cell).iter().collect();
        let points = frame.points(&terms);
        let mut components = vec![Vec::new(); count];
        for (at, &term) in terms.iter().enumerate() {
            components[self.component(cell, at) as usize].push(term);
        }
        let measures: Vec<Vec<Integer>> =
            components.iter().map(|component| frame.exact(&points, component)).collect();
        let sizes: Vec<Integer> = measures.iter().map(|measure| product(measure, measure)).collect();
        let noun = if frame.degree() == 2 { "area" } else { "volume" };
        if let Some(flat) = sizes.iter().position(Integer::is_zero) {
            return Err(Error::invalid(format!(
                "the component of the boundary of cell {cell} with facet {} has no {noun}, so its orientation cannot be told",
                components[flat][0].0
            )));
        }
        let outer = (0..count).max_by(|&i, &j| sizes[i].cmp(&sizes[j])).unwrap_or(0);
        if let Some(twin) = (0..count).find(|&i| i != outer && sizes[i] == sizes[outer]) {
            return Err(Error::invalid(format!(
                "two components of the boundary of cell {cell}, with facets {} and {}, have the same {noun}, so none is around the other",
                components[twin.min(outer)][0].0,
                components[twin.max(outer)][0].0
            )));
        }
        let mut signs: Vec<Sign> = (0..count)
            .map(|i| match product(&measures[i], &measures[outer]).signum() {
                1 if i != outer => Sign::Minus,
                _ => Sign::Plus,
            })
            .collect();
        // Component 0 has the lowest facet, which is positive as it stands.
        if signs[0] == Sign::Minus {
            signs.iter_mut().for_each(|sign| *sign = sign.opposite());
        }
        Ok(signs)
    }

    /// The cells turned so that their measures are positive: lengths on the line, areas in the plane, volumes in space. A cell
    /// that measures nothing stays as it is.
    ///
    /// `lower` has the boundary matrices below the cells, from edges on. Signs are exact.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless the positions have as many coordinates as the degree of the cells, 1, 2 or 3, and each
    /// vertex has one.
    ///
    /// # Complexity
    /// Linear in the boundaries of facets; in parallel over cells.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::lar::{LarModel, oriented_boundary};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let model = LarModel::new(3, vec![RaggedArray::from_lists([[1, 0], [1, 2], [0, 2]])])?;
    /// let lower = [model.edge_boundaries()?];
    /// let face = oriented_boundary(&lower[0], &RaggedArray::from_lists([[0, 1, 2]]))?;
    /// assert_eq!(face.boundary().column(0).entries(), [1, -1, 1]);
    /// let positions = Positions::from_flat(2, vec![0.0, 0.0, 1.0, 0.0, 0.0, 1.0])?;
    /// assert_eq!(face.positive(&lower, &positions)?.boundary().column(0).entries(), [-1, 1, -1]);
    /// # Ok(()) }
    /// ```
    pub fn positive(self, lower: &[SparseMatrix], positions: &Positions) -> Result<Self, Error> {
        let frame = Frame::new(lower, positions)?;
        check_full(frame.degree(), positions)?;
        if frame.degree() == 1 && positions.len() < self.boundary().row_count() {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("{} positions for {} vertices", positions.len(), self.boundary().row_count()),
            ));
        }
        let signs: Vec<Sign> = (0..self.cell_count())
            .into_par_iter()
            .with_min_len(1 << 8)
            .map_init(Vec::new, |boundary, cell| {
                boundary.clear();
                boundary.extend(self.boundary().column(cell).iter());
                if frame.sign(boundary) < 0 { Sign::Minus } else { Sign::Plus }
            })
            .collect();
        Ok(self.turned(&signs))
    }
}

/// The inner product.
fn product(a: &[Integer], b: &[Integer]) -> Integer {
    let mut sum = Integer::ZERO;
    for (x, y) in a.iter().zip(b) {
        sum += &(x * y);
    }
    sum
}
