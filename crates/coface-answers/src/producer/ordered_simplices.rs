//! Models as delta complexes, for products of cochains.

use super::{Cells, Producer};
use crate::simplices::{require_tetrahedra, require_triangles};
use coface_algebra::RaggedArray;
use coface_algebra::{CellId, Error, FaceId};
use coface_complexes::simplicial::{DeltaComplex, FrozenComplex};

/// The simplices of a model with ordered vertices, as products of cochains need them, and their names.
#[derive(Clone, Debug)]
pub struct OrderedSimplices {
    complex: DeltaComplex,
    names: Option<FrozenComplex>,
}

impl OrderedSimplices {
    /// The delta complex.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::Producer;
    /// let strip = coface_io::read(&b"[[0,1,7],[1,7,9]]"[..], coface_io::Format::Json)?;
    /// let strip = Producer::of(strip)?;
    /// let simplices = strip.ordered_simplices()?;
    /// assert_eq!(simplices.complex().f_vector(), [4, 5, 2]);
    /// # Ok(()) }
    /// ```
    pub fn complex(&self) -> &DeltaComplex {
        &self.complex
    }

    /// The simplicial complex that it was made of, if there is one; cells have the same numbers in both.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::Producer;
    /// let strip = coface_io::read(&b"[[0,1,7],[1,7,9]]"[..], coface_io::Format::Json)?;
    /// let strip = Producer::of(strip)?;
    /// let simplices = strip.ordered_simplices()?;
    /// assert!(simplices.simplicial().is_some());
    /// # Ok(()) }
    /// ```
    pub fn simplicial(&self) -> Option<&FrozenComplex> {
        self.names.as_ref()
    }

    /// The vertices of a simplex by their numbers in the file; of a gluing table, which is subdivided, the number of the
    /// simplex in the subdivision.
    ///
    /// # Panics
    /// If there is no such simplex.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_algebra::CellId;
    /// use coface_answers::Producer;
    /// let strip = coface_io::read(&b"[[0,1,7],[1,7,9]]"[..], coface_io::Format::Json)?;
    /// let strip = Producer::of(strip)?;
    /// let simplices = strip.ordered_simplices()?;
    /// assert_eq!(simplices.name(2, CellId::new(1)), [1, 7, 9]);
    /// # Ok(()) }
    /// ```
    pub fn name(&self, dimension: usize, simplex: CellId) -> Vec<u32> {
        self.names.as_ref().map_or_else(
            || vec![simplex.to_u32()],
            |names| names.numbers(dimension, simplex.index()).to_vec(),
        )
    }
}

impl Producer {
    /// The simplices of the model with their vertices in rising order; a gluing table is subdivided once, which orders
    /// them.
    ///
    /// # Errors
    /// [`InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if a polygon is no triangle or a 3-cell no tetrahedron, and for
    /// halfedge permutations and chain complexes, which have no ordered simplices.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, RaggedArray};
    /// use coface_io::{Model, Structure};
    /// use coface_answers::Producer;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let facets = RaggedArray::from_lists([[3, 1, 7]]);
    /// let simplices = Producer::of(Model::from_structure(Structure::Facets(facets)))?.ordered_simplices()?;
    /// assert_eq!(simplices.name(2, CellId::new(0)), [1, 3, 7]);
    /// # Ok(()) }
    /// ```
    pub fn ordered_simplices(&self) -> Result<OrderedSimplices, Error> {
        let frozen = match &self.cells {
            Cells::Simplices(complex) => complex.clone(),
            Cells::Gluings(gluings) => {
                let complex = gluings.1.barycentric_subdivision()?.complex().clone();
                return Ok(OrderedSimplices { complex, names: None });
            }
            Cells::Polygons(mesh) => {
                let sides = (0..mesh.face_count()).map(|face| mesh.face(FaceId::new(face)).len());
                require_triangles(sides, self.positions())?;
                self.named_simplices(&[mesh.vertex_count(), mesh.edge_count(), mesh.face_count()])?
            }
            Cells::Solids(mesh) => {
                require_tetrahedra(mesh.shapes())?;
                let skeleton = mesh.skeleton();
                self.named_simplices(&[
                    skeleton.vertex_count(),
                    skeleton.edge_count(),
                    skeleton.face_count(),
                    mesh.shapes().len(),
                ])?
            }
            Cells::Halfedges(_) => {
                return Err(Error::invalid("the faces of halfedge permutations have no ordered vertices")
                    .with_cure("give the surface as a mesh of triangles or a facet list"));
            }
            Cells::Voxels(_) => {
                return Err(Error::invalid("voxels are cubes: their faces have no ordered vertices")
                    .with_cure("give a facet list, or a mesh of triangles or tetrahedra"));
            }
            Cells::Ordered(complex) => {
                return Ok(OrderedSimplices { complex: complex.complex().clone(), names: None });
            }
            Cells::Chains(_) => {
                return Err(Error::invalid("a chain complex does not say how its cells are attached")
                    .with_cure("give a facet list, a gluing table, or a mesh of triangles or tetrahedra"));
            }
        };
        Ok(OrderedSimplices { complex: frozen.to_delta()?, names: Some(frozen) })
    }

    /// The simplicial complex of all cells, by the vertex numbers of the file.
    fn named_simplices(&self, counts: &[usize]) -> Result<FrozenComplex, Error> {
        let mut simplices = RaggedArray::new();
        for (degree, &count) in counts.iter().enumerate() {
            for cell in 0..count {
                simplices.push(&self.cell_vertices(degree, CellId::new(cell)));
            }
        }
        FrozenComplex::from_facets(&simplices)
    }
}
