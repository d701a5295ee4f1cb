//! Every producer of this crate as [`Cells`].

use crate::congruence::ChainCongruence;
use crate::planar::PlanarArrangement;
use crate::spatial::{CongruenceArrangement, PolygonalComplex, SpatialArrangement, SpatialCells};
use coface_algebra::chains::{Cells, ChainComplex};
use coface_algebra::{Error, RaggedArray};

/// Vertices, edges and bounded faces, refined until each face is a disk.
impl Cells for PlanarArrangement {
    fn chain_complex(&self) -> Result<ChainComplex, Error> {
        self.chain_complex()
    }
}

/// A face has the vertices of all its rings, rising.
impl Cells for PolygonalComplex {
    fn chain_complex(&self) -> Result<ChainComplex, Error> {
        self.chain_complex()
    }

    fn cell_vertices(&self, degree: usize) -> Result<RaggedArray, Error> {
        if degree != 1 {
            return self.chain_complex()?.cell_vertices(degree);
        }
        RaggedArray::uniform(2, self.edges().as_flattened().to_vec())
    }

    fn f_vector(&self) -> Result<Vec<usize>, Error> {
        Ok(self.f_vector())
    }
}

/// The fine vertices, edges and faces, with the cells.
impl Cells for SpatialCells {
    fn chain_complex(&self) -> Result<ChainComplex, Error> {
        self.chain_complex()
    }
}

/// Vertices, edges, faces and bounded cells, refined until each is a ball.
impl Cells for SpatialArrangement {
    fn chain_complex(&self) -> Result<ChainComplex, Error> {
        self.chain_complex()
    }
}

/// Vertices, edges, faces and bounded cells.
impl Cells for CongruenceArrangement {
    fn chain_complex(&self) -> Result<ChainComplex, Error> {
        self.chain_complex()
    }

    fn f_vector(&self) -> Result<Vec<usize>, Error> {
        Ok(self.f_vector())
    }
}

/// The cells are the classes: those of [`ChainCongruence::complex`].
impl Cells for ChainCongruence {
    fn chain_complex(&self) -> Result<ChainComplex, Error> {
        Ok(self.complex().clone())
    }

    fn cell_vertices(&self, degree: usize) -> Result<RaggedArray, Error> {
        self.complex().cell_vertices(degree)
    }

    fn f_vector(&self) -> Result<Vec<usize>, Error> {
        Ok(self.complex().f_vector().to_vec())
    }
}
