//! The chain complex of a model: facets found or given, signs by propagation.

use super::LarModel;
use crate::lar::orientation::{OrientedCells, oriented_boundary};
use coface_algebra::Error;
use coface_algebra::SparseMatrix;
use coface_algebra::chains::ChainComplex;
use coface_geometry::Positions;

/// How the cells of highest degree are oriented. Cells of lower degree have their lowest facet positive, and edges run from
/// their first to their second vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum TopOrientation {
    /// The lowest facet of each cell is positive, as for all other cells; edges run from their first vertex to their second.
    LowestFacet,
    /// Lengths on the line, areas in the plane, volumes in space are positive.
    Positive,
    /// Neighbors run through their common facet in opposite directions.
    Coherent,
}

impl LarModel {
    /// The boundary matrix of degree 1: rows are vertices, columns edges; an edge is its second vertex minus its first.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::TooLarge`] beyond 32 bits.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::lar::LarModel;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let model = LarModel::new(3, vec![RaggedArray::from_lists([[2, 0]])])?;
    /// assert_eq!(model.edge_boundaries()?.column(0).entries(), [1, -1]);
    /// # Ok(()) }
    /// ```
    pub fn edge_boundaries(&self) -> Result<SparseMatrix, Error> {
        let edges = self.cells(1);
        let (mut rows, mut entries) =
            (Vec::with_capacity(edges.item_count()), Vec::with_capacity(edges.item_count()));
        for edge in edges.iter() {
            let (a, b) = (edge[0], edge[1]);
            rows.extend([a.min(b), a.max(b)]);
            entries.extend(if a < b { [-1, 1] } else { [1, -1] });
        }
        let starts = (0..=edges.len()).map(|edge| 2 * edge as u32).collect();
        SparseMatrix::from_trusted_parts(self.vertex_count(), starts, rows, entries)
    }

    /// The chain complex of the model with lowest facets positive: [`Self::oriented_chain_complex`] without positions.
    ///
    /// # Errors
    /// Those of [`Self::oriented_chain_complex`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::lar::LarModel;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edges = RaggedArray::from_lists([[0, 1], [2, 3], [0, 2], [1, 3]]);
    /// let square = LarModel::new(4, vec![edges, RaggedArray::from_lists([[0, 1, 2, 3]])])?;
    /// let complex = square.chain_complex()?;
    /// let face = complex.boundary_matrix(2).expect("there is a face").column(0);
    /// assert_eq!(face.entries(), [1, -1, -1, 1]);
    /// # Ok(()) }
    /// ```
    pub fn chain_complex(&self) -> Result<ChainComplex, Error> {
        self.oriented_chain_complex(TopOrientation::LowestFacet, None)
    }

    /// The chain complex of the model: facets as [`Self::facets`] says, signs by
    /// [`oriented_boundary`](crate::lar::orientation::oriented_boundary).
    ///
    /// The positions relate the components of cells with holes and voids, and tell positive measures; without them cells must
    /// have connected boundaries.
    ///
    /// # Errors
    /// Those of [`Self::facets_by_vertices`] and of [`oriented_boundary`](crate::lar::orientation::oriented_boundary), the degree said
    /// before them; [`coface_algebra::ErrorKind::InvalidInput`] naming a cell whose boundary has several components when there are no
    /// positions; [`coface_algebra::ErrorKind::Shape`] for positive measures without the positions that have them;
    /// [`coface_algebra::ErrorKind::NonManifold`] naming a closed chain of cells that cannot be coherent.
    ///
    /// # Complexity
    /// Linear in the ridges of facets of all cells.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::lar::{LarModel, TopOrientation};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edges = RaggedArray::from_lists([[0, 1], [2, 3], [0, 2], [1, 3]]);
    /// let square = LarModel::new(4, vec![edges, RaggedArray::from_lists([[0, 1, 2, 3]])])?;
    /// let complex = square.oriented_chain_complex(TopOrientation::Coherent, None)?;
    /// let face = complex.boundary_matrix(2).expect("there is a face").column(0);
    /// assert_eq!(face.entries(), [1, -1, -1, 1]);
    /// # Ok(()) }
    /// ```
    pub fn oriented_chain_complex(
        &self,
        top: TopOrientation,
        positions: Option<&Positions>,
    ) -> Result<ChainComplex, Error> {
        let dimension = self.dimension().unwrap_or(0);
        if dimension == 0 {
            return Ok(ChainComplex::of_points(self.vertex_count()));
        }
        let mut boundaries: Vec<SparseMatrix> = Vec::new();
        for degree in 1..=dimension {
            let mut cells = self.oriented_cells(degree, &boundaries, positions)?;
            if degree == dimension {
                cells = match (top, positions) {
                    (TopOrientation::LowestFacet, _) => cells,
                    (TopOrientation::Coherent, _) => cells.coherent()?,
                    (TopOrientation::Positive, Some(positions)) => cells.positive(&boundaries, positions)?,
                    (TopOrientation::Positive, None) => {
                        return Err(Error::new(
                            coface_algebra::ErrorKind::Shape,
                            "without positions nothing has a positive measure",
                        ));
                    }
                };
            }
            boundaries.push(cells.into_boundary());
        }
        ChainComplex::new(boundaries)
    }

    /// The cells of a degree with their lowest facets positive, above these boundary matrices of lower degrees.
    fn oriented_cells(
        &self,
        degree: usize,
        lower: &[SparseMatrix],
        positions: Option<&Positions>,
    ) -> Result<OrientedCells, Error> {
        let Some(facet_boundaries) = lower.last() else {
            return Ok(OrientedCells::connected(self.edge_boundaries()?));
        };
        let facets = self.facets(degree)?;
        let cells =
            oriented_boundary(facet_boundaries, &facets).map_err(|error| in_degree(degree, &error))?;
        match (cells.first_disconnected(), positions) {
            (None, _) => Ok(cells),
            (Some(_), Some(positions)) => {
                cells.nested(lower, positions).map_err(|error| in_degree(degree, &error))
            }
            (Some(cell), None) => Err(Error::invalid(format!(
                "the boundary of {} has {} components, whose signs only positions relate",
                self.cell_name(degree, cell.to_u32()),
                cells.boundary_components(cell).len()
            ))
            .with_cure("give the positions of the vertices")),
        }
    }
}

/// The error with the degree of the cells before it.
fn in_degree(degree: usize, error: &Error) -> Error {
    let named = Error::new(error.kind(), format!("in degree {degree}: {}", error.message()));
    match error.cure() {
        Some(cure) => named.with_cure(cure),
        None => named,
    }
}
