//! Grids and extrusions as cells with positions.

use super::CuboidGrid;
use crate::shapes::{CellKind, PlacedCells};
use crate::simplicial::{Extrusion, SimplicialGrid};
use coface_algebra::Error;
use coface_geometry::Positions;

impl CuboidGrid {
    /// The cells of one dimension with the positions of all vertices.
    ///
    /// # Errors
    /// Those of [`CuboidGrid::cells`]; [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for a grid without axes,
    /// which has no positions.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::grids::CuboidGrid;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let walls = CuboidGrid::new(&[2, 2, 2])?.placed_cells(2)?;
    /// assert_eq!((walls.vertex_count(), walls.cell_count()), (27, 36));
    /// # Ok(()) }
    /// ```
    pub fn placed_cells(&self, dimension: usize) -> Result<PlacedCells, Error> {
        PlacedCells::new(self.positions()?, CellKind::Cuboid, dimension, self.cells(dimension)?)
    }
}

impl SimplicialGrid {
    /// The positive simplices of full dimension with the positions of all vertices.
    ///
    /// # Errors
    /// Those of [`SimplicialGrid::simplices`]; [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for a grid without
    /// axes, which has no positions.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::SimplicialGrid;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangles = SimplicialGrid::new(&[2, 1])?.placed_cells()?;
    /// assert!(triangles.cells().iter().eq([[0, 1, 3], [3, 1, 4], [1, 2, 4], [4, 2, 5]]));
    /// # Ok(()) }
    /// ```
    pub fn placed_cells(&self) -> Result<PlacedCells, Error> {
        let simplices = self.simplices()?.to_oriented();
        PlacedCells::new(self.positions()?, CellKind::Simplex, self.shape().len(), simplices)
    }
}

impl Extrusion {
    /// The oriented simplices with the positions of all vertices, given those of the base.
    ///
    /// # Errors
    /// Those of [`Extrusion::positions`]; [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) naming a simplex of
    /// another dimension than the first.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_geometry::Positions;
    /// use coface_complexes::simplicial::extrude;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(2, vec![0., 0., 1., 0., 0., 1.])?;
    /// let wedge = extrude(3, &RaggedArray::from_lists([[0, 1, 2]]), &[2.0])?.placed_cells(&corners)?;
    /// assert_eq!((wedge.vertex_count(), wedge.cell_count(), wedge.dimension()), (6, 3, 3));
    /// # Ok(()) }
    /// ```
    pub fn placed_cells(&self, base: &Positions) -> Result<PlacedCells, Error> {
        let simplices = self.simplices().to_oriented();
        let dimension = simplices.iter().next().map_or(0, |simplex| simplex.len() - 1);
        PlacedCells::new(self.positions(base)?, CellKind::Simplex, dimension, simplices)
    }
}
