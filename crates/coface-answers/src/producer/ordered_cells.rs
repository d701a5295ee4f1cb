//! Simplices that are lists of vertices, of which several may have the same ones.

use coface_complexes::alpha::PeriodicAlphaComplex;
use coface_complexes::filtered::DirectedFlagComplex;
use coface_complexes::simplicial::DeltaComplex;

/// A complex of simplices that are not told by their vertices.
#[derive(Debug)]
pub(crate) enum OrderedCells {
    /// Of a directed graph.
    Directed(DirectedFlagComplex),
    /// Of points that repeat, of which there are few.
    Periodic(PeriodicAlphaComplex),
}

impl OrderedCells {
    /// The simplices with their faces.
    pub(crate) fn complex(&self) -> &DeltaComplex {
        match self {
            Self::Directed(complex) => complex.complex(),
            Self::Periodic(complex) => complex.complex(),
        }
    }

    /// The vertices of a simplex, in its order.
    pub(crate) fn vertices(&self, degree: usize, i: usize) -> &[u32] {
        match self {
            Self::Directed(complex) => complex.simplex(degree, i),
            Self::Periodic(complex) => complex.points(degree, i),
        }
    }
}
