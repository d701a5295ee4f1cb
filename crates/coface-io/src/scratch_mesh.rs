//! Meshes of simplices that go to flat streams while they are read.

use super::element_kind::Kind;
use coface_algebra::{Error, ErrorKind};
use coface_complexes::cell_mesh::CellShape;
use std::fmt;
use std::io::{BufWriter, Write};

/// What is said where an element is no simplex, or has vertices inside its edges, and where a vertex has a coordinate that is not finite.
pub(super) const NOT_SIMPLICIAL: &str = "only simplices are read without being kept";

/// A stream of bytes that are looked at later.
pub(super) type ScratchStream = Box<dyn Write>;

/// Two streams: three coordinates for each vertex, and four vertices for each element, the last ones [`NO_VERTEX`] where it has fewer, all
/// little endian.
pub(super) struct ScratchMesh {
    vertices: BufWriter<ScratchStream>,
    elements: BufWriter<ScratchStream>,
}

/// What stands for a vertex in the stream of elements where an element has fewer than four: the records have one length.
#[doc(hidden)]
pub const NO_VERTEX: u32 = u32::MAX;

impl fmt::Debug for ScratchMesh {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("ScratchMesh").finish_non_exhaustive()
    }
}

impl ScratchMesh {
    pub(super) fn new([vertices, elements]: [ScratchStream; 2]) -> Self {
        let [vertices, elements] =
            [vertices, elements].map(|stream| BufWriter::with_capacity(1 << 18, stream));
        Self { vertices, elements }
    }

    pub(super) fn add_vertex(&mut self, coordinates: &[f64]) -> Result<(), Error> {
        if !coordinates.iter().all(|x| x.is_finite()) {
            return Err(Error::new(ErrorKind::UnsupportedFormat, NOT_SIMPLICIAL));
        }
        for axis in 0..3 {
            let x = coordinates.get(axis).copied().unwrap_or(0.0);
            self.vertices.write_all(&x.to_le_bytes())?;
        }
        Ok(())
    }

    /// Adds an element with these corners, of so many vertices in all.
    pub(super) fn add(&mut self, kind: Kind, corners: &[u32], vertex_count: usize) -> Result<(), Error> {
        let is_simplex = match kind {
            Kind::Point | Kind::Line => true,
            Kind::Polygon => corners.len() == 3,
            Kind::Cell(shape) => shape == CellShape::Tetrahedron,
        };
        // A line of several segments is as many elements.
        if !is_simplex || corners.len() != vertex_count || (kind == Kind::Line && corners.len() != 2) {
            return Err(Error::new(ErrorKind::UnsupportedFormat, NOT_SIMPLICIAL));
        }
        for place in 0..4 {
            self.elements.write_all(&corners.get(place).copied().unwrap_or(NO_VERTEX).to_le_bytes())?;
        }
        Ok(())
    }

    pub(super) fn finish(&mut self) -> Result<(), Error> {
        self.vertices.flush()?;
        self.elements.flush()?;
        Ok(())
    }
}
