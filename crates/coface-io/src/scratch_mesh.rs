//! Meshes of simplices that go to flat files while they are read.

use super::assembly::Kind;
use coface_algebra::{Error, ErrorKind};
use coface_complexes::cell_mesh::CellShape;
use std::fmt;
use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};

/// What is said where an element is no simplex, or has vertices inside its edges.
pub(super) const NOT_SIMPLICIAL: &str = "only simplices are read without being kept";

/// Two files in a folder that has to be removed by whoever made it: three coordinates for each vertex, and four vertices for each element, the
/// last ones `u32::MAX` where it has fewer, all little endian.
pub struct ScratchMesh {
    vertices: BufWriter<File>,
    elements: BufWriter<File>,
    vertex_path: PathBuf,
    element_path: PathBuf,
}

impl fmt::Debug for ScratchMesh {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("ScratchMesh").field("vertices", &self.vertex_path).finish_non_exhaustive()
    }
}

impl ScratchMesh {
    pub(super) fn create(folder: &Path) -> Result<Self, Error> {
        let (vertex_path, element_path) = (folder.join("vertices"), folder.join("elements"));
        let file = |path: &Path| Ok::<_, Error>(BufWriter::with_capacity(1 << 18, File::create(path)?));
        Ok(Self { vertices: file(&vertex_path)?, elements: file(&element_path)?, vertex_path, element_path })
    }

    /// The file of coordinates.
    #[doc(hidden)]
    pub fn vertex_path(&self) -> &Path {
        &self.vertex_path
    }

    /// The file of elements.
    #[doc(hidden)]
    pub fn element_path(&self) -> &Path {
        &self.element_path
    }

    pub(super) fn add_vertex(&mut self, coordinates: &[f64]) -> Result<(), Error> {
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
            self.elements.write_all(&corners.get(place).copied().unwrap_or(u32::MAX).to_le_bytes())?;
        }
        Ok(())
    }

    pub(super) fn finish(&mut self) -> Result<(), Error> {
        self.vertices.flush()?;
        self.elements.flush()?;
        Ok(())
    }
}
