//! What a model knows of the cells of its chain complex beside the matrices.

use super::Model;
use crate::volume::VoxelFrame;
use crate::{Remark, RemarkCode, Structure, cells_not_balls};
use coface_algebra::chains::ChainRefinement;
use coface_algebra::{Error, RaggedArray, VertexId};
use coface_arrange::planar::ExactSegments;
use coface_arrange::spatial::ExactPolygons;
use coface_geometry::Positions;
use std::sync::Arc;

impl Model {
    /// The model with what the cells of its chain complex are pieces of.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::InvalidInput`] for a model that is no chain complex; those of
    /// [`ChainRefinement::check`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::{ChainComplex, ChainRefinement};
    /// use coface_io::{Model, Structure};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // An edge and a bridge.
    /// let ends = [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1)];
    /// let path = ChainComplex::new(vec![SparseMatrix::from_entries(3, 2, ends)?])?;
    /// let pieces = ChainRefinement::new(vec![(0..3).map(Some).collect(), vec![Some(0), None]]);
    /// let model = Model::from_structure(Structure::Chains(path)).with_refinement(pieces)?;
    /// let coarse = model.coarse()?.expect("it is refined");
    /// assert!(matches!(coarse.structure(), Some(Structure::Chains(complex)) if complex.f_vector() == [3, 1]));
    /// # Ok(()) }
    /// ```
    pub fn with_refinement(mut self, refinement: ChainRefinement) -> Result<Self, Error> {
        let Some(Structure::Chains(complex)) = &self.structure else {
            return Err(Error::invalid("only the cells of a chain complex are pieces of others"));
        };
        refinement.check(complex)?;
        self.refinement = (!refinement.is_trivial()).then_some(refinement);
        Ok(self)
    }

    /// The model with a remark if cells of its chain complex [are no balls](cells_not_balls).
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_io::{Model, Structure};
    /// let points = Model::from_structure(Structure::Chains(ChainComplex::of_points(2)));
    /// assert!(points.with_remark_on_cells().remarks().is_empty());
    /// ```
    #[must_use]
    pub fn with_remark_on_cells(mut self) -> Self {
        if let Some(Structure::Chains(complex)) = &self.structure {
            self.remarks.extend(cells_not_balls(complex));
        }
        self
    }

    /// What the cells of the chain complex are pieces of, if the file says so.
    pub fn refinement(&self) -> Option<&ChainRefinement> {
        self.refinement.as_ref()
    }

    /// The model with its faces as they were before coordinates were rounded.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_io::{Model, Structure};
    /// let points = Model::from_structure(Structure::Chains(ChainComplex::of_points(2)));
    /// assert!(points.with_exact_polygons(Default::default()).exact_polygons().is_some());
    /// ```
    #[must_use]
    pub fn with_exact_polygons(mut self, exact: Arc<ExactPolygons>) -> Self {
        self.exact = Some(exact);
        self
    }

    /// The faces as they were before coordinates were rounded, if they are known: arrangements and Booleans take these.
    pub fn exact_polygons(&self) -> Option<&Arc<ExactPolygons>> {
        self.exact.as_ref()
    }

    /// The model of a drawing with its segments as they were before coordinates were rounded.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_io::{Model, Structure};
    /// let points = Model::from_structure(Structure::Chains(ChainComplex::of_points(2)));
    /// assert!(points.with_exact_segments(Default::default()).exact_segments().is_some());
    /// ```
    #[must_use]
    pub fn with_exact_segments(mut self, exact: Arc<ExactSegments>) -> Self {
        self.exact_segments = Some(exact);
        self
    }

    /// The segments of a drawing as they were before coordinates were rounded, if they are known: arrangements and Booleans in the
    /// plane take these.
    pub fn exact_segments(&self) -> Option<&Arc<ExactSegments>> {
        self.exact_segments.as_ref()
    }

    /// The model of the cells that those of the chain complex are pieces of; `None` if there are no pieces.
    ///
    /// # Errors
    /// Those of [`ChainRefinement::coarse`].
    pub fn coarse(&self) -> Result<Option<Self>, Error> {
        let (Some(Structure::Chains(complex)), Some(refinement)) = (&self.structure, &self.refinement) else {
            return Ok(None);
        };
        let coarse = refinement.coarse(complex).map_err(|error| {
            error.with_cure(
                "write the file again, or leave out what its cells are pieces of: the key \"pieces_of\"",
            )
        })?;
        if self.positions.is_empty() {
            return Ok(Some(Self::from_structure(Structure::Chains(coarse))));
        }
        let dimension = self.positions.dimension();
        let mut flat = vec![0.0; dimension * coarse.cell_count(0)];
        for (vertex, place) in refinement.pieces(0).enumerate() {
            if let Some(place) = place {
                let at = dimension * place as usize;
                flat[at..at + dimension].copy_from_slice(self.positions.point(VertexId::new(vertex)));
            }
        }
        Self::from_chains(coarse, Positions::from_flat(dimension, flat)?).map(Some)
    }
}

impl Model {
    /// The squares between voxels of a volume that are set and others, which look outward, with their corners where the header of the file places
    /// them; `None` for what is no volume.
    ///
    /// # Errors
    /// Those of [`coface_complexes::cubical::CubicalVolume::boundary_squares`].
    #[doc(hidden)]
    pub fn voxel_surface(&self) -> Result<Option<(Positions, RaggedArray)>, Error> {
        let Some(Structure::Volume(volume)) = self.structure() else { return Ok(None) };
        let (corners, squares) = volume.boundary_squares()?;
        let Some(frame) = self.frame else { return Ok(Some((corners, squares))) };
        let squares = match frame.is_mirrored() {
            true => RaggedArray::from_lists(
                squares.iter().map(|square| square.iter().rev().copied().collect::<Vec<u32>>()),
            ),
            false => squares,
        };
        Ok(Some((frame.place(&corners)?, squares)))
    }

    /// What the file has beside what was read, such as normals and colors that have no place here, with counts: it changes no answer, but is not in
    /// what is written.
    #[doc(hidden)]
    pub fn unread(&self) -> &[(&'static str, usize)] {
        &self.unread
    }

    /// Where the header of a file of voxels places them, if it says so.
    #[doc(hidden)]
    pub fn voxel_frame(&self) -> Option<VoxelFrame> {
        self.frame
    }

    /// How voxels are placed, if the header of their file says it.
    #[doc(hidden)]
    pub fn voxel_remark(&self) -> Option<Remark> {
        self.frame.map(|frame| Remark::new(RemarkCode::InputReading, frame.description()))
    }
}

impl PartialEq for Model {
    fn eq(&self, other: &Self) -> bool {
        self.vertex_count == other.vertex_count
            && self.positions == other.positions
            && self.partial_positions == other.partial_positions
            && self.polygons == other.polygons
            && self.shapes == other.shapes
            && self.cells == other.cells
            && self.lines == other.lines
            && self.points == other.points
            && self.groups == other.groups
            && self.data == other.data
            && self.structure == other.structure
            && self.refinement == other.refinement
            && self.exact == other.exact
            && self.exact_segments == other.exact_segments
            && self.features == other.features
            && self.reference == other.reference
    }
}
