//! What makes the chain complex of a model, and the names of its cells.
//!
//! * A [`Producer`] is a model with the faces of its cells identified; it makes the chain complex.
//! * [`CellNames`] names the cells of a complex that was made from it by the vertices of the file: in answers a chain
//!   is a list of coefficients with such names. A [`Term`] is one of these as the user writes it.
//! * A [`Pair`] is the complex, or that of a part of the model, relative to a subcomplex; [`named_groups`] are parts that the file names.
//! * [`OrderedSimplices`] is the model as a delta complex, for products of cochains.

mod bounded;
mod cycles;
mod groups;
mod labels;
mod lookup;
mod names;
mod ordered_cells;
mod ordered_simplices;
mod pair;
mod places;

use bounded::bounded;
pub use cycles::Term;
pub(crate) use cycles::{CubeChain, picture_of_cubes};
pub use groups::{group_chain, named_groups};
pub(crate) use labels::Labels;
pub use names::CellNames;
pub(crate) use ordered_cells::OrderedCells;
pub use ordered_simplices::OrderedSimplices;
pub use pair::Pair;

use crate::facts::VolumeCells;
use coface_algebra::Error;
use coface_algebra::RaggedArray;
use coface_algebra::chains::{ChainComplex, TwoSkeleton};
use coface_algebra::{CellId, EdgeId, FaceId};
use coface_complexes::cell_mesh::CellMesh;
use coface_complexes::cubical::CubicalVolume;
use coface_complexes::gluing::{FaceClasses, GluingTable};
use coface_complexes::lar::LarModel;
use coface_complexes::simplicial::FrozenComplex;
use coface_complexes::surface::{HalfedgeMesh, HalfedgePermutations, PolygonMesh};
use coface_geometry::{PartialPositions, Positions};
use coface_io::{Model, ModelParts, Remark, Structure, segments};

/// The cells of a model with their faces identified: what its chain complex is made from.
///
/// Cells of each degree are numbered; [`Self::cell_vertices`] names them by vertices of the file.
///
/// # Examples
/// ```
/// use coface_algebra::{CellId, RaggedArray};
/// use coface_io::{Model, Structure};
/// use coface_answers::Producer;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let facets = RaggedArray::from_lists([[0, 1, 7], [1, 7, 9]]);
/// let producer = Producer::of(Model::from_structure(Structure::Facets(facets)))?;
/// assert_eq!(producer.chain_complex()?.f_vector(), [4, 5, 2]);
/// assert_eq!(producer.cell_vertices(2, CellId::new(1)), [1, 7, 9]);
/// # Ok(()) }
/// ```
#[derive(Debug)]
pub struct Producer {
    pub(crate) cells: Cells,
    pub(crate) labels: Labels,
    pub(crate) positions: Positions,
    pub(crate) partial_positions: Option<PartialPositions>,
    pub(crate) remarks: Vec<Remark>,
}

/// The structures that models become.
#[derive(Debug)]
pub(crate) enum Cells {
    /// Polygons, edges and vertices.
    Polygons(PolygonMesh),
    /// 3-cells, faces, edges and vertices.
    Solids(Box<CellMesh>),
    /// Simplices of any dimension.
    Simplices(FrozenComplex),
    /// Halfedges.
    Halfedges(HalfedgeMesh),
    /// Simplices with facets glued in pairs, and their face classes.
    Gluings(Box<(GluingTable, FaceClasses)>),
    /// Boundary matrices.
    Chains(ChainComplex),
    /// Voxels with their faces.
    Voxels(Box<VolumeCells>),
    /// Lists of vertices.
    Ordered(Box<OrderedCells>),
}

impl Producer {
    /// Identifies the cells of a model. The ideal vertices of a gluing table are cut off first, and a remark says so, unless the model is
    /// [taken as a pseudomanifold](Model::as_pseudomanifold).
    ///
    /// # Errors
    /// Those of the structure that fits the model: [`coface_algebra::ErrorKind::InvalidInput`] naming a cell that is none,
    /// [`coface_algebra::ErrorKind::TooLarge`] for what its numbers do not hold.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::Producer;
    /// let strip = coface_io::read(&b"[[0,1,7],[1,7,9]]"[..], coface_io::Format::Json)?;
    /// let strip = Producer::of(strip)?;
    /// assert_eq!(strip.chain_complex()?.f_vector(), [4, 5, 2]);
    /// # Ok(()) }
    /// ```
    pub fn of(model: Model) -> Result<Self, Error> {
        let ModelParts {
            vertex_count,
            mut positions,
            partial_positions,
            polygons,
            shapes,
            cells,
            lines,
            structure,
            mut remarks,
            is_pseudomanifold,
            frame,
            ..
        } = model.into_parts();
        let (cells, labels) = match structure {
            Some(Structure::Facets(facets)) => of_facets(facets)?,
            Some(Structure::Chains(complex)) => (Cells::Chains(complex), Labels::default()),
            Some(Structure::Volume(volume)) => {
                let cells = VolumeCells::new(volume);
                positions = cells.positions().unwrap_or_default();
                if let Some(frame) = frame.filter(|_| !positions.is_empty()) {
                    positions = frame.place(&positions)?;
                }
                (Cells::Voxels(Box::new(cells)), Labels::default())
            }
            Some(Structure::Halfedges { next, twin, outer }) => {
                let permutations = HalfedgePermutations::new(next, twin, outer)?;
                (Cells::Halfedges(permutations.mesh()?), Labels::default())
            }
            Some(Structure::Gluings(table)) => {
                let made = match is_pseudomanifold {
                    true => None,
                    false => bounded(&table)?,
                };
                let table = match made {
                    Some((bounded, remark)) => {
                        remarks.push(remark);
                        bounded
                    }
                    None => table,
                };
                let faces = table.faces()?;
                (Cells::Gluings(Box::new((table, faces))), Labels::default())
            }
            None if !cells.is_empty() => {
                let mesh = CellMesh::new(vertex_count, shapes, cells, &polygons, &segments(&lines))?;
                (Cells::Solids(Box::new(mesh)), Labels::default())
            }
            None => {
                let mesh = PolygonMesh::new(vertex_count, polygons, &segments(&lines))?;
                (Cells::Polygons(mesh), Labels::default())
            }
        };
        Ok(Self { cells, labels, positions, partial_positions, remarks })
    }

    /// The positions of the vertices by their numbers in the file; empty when it has none.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::Producer;
    /// let strip = coface_io::read(&b"[[0,1,7],[1,7,9]]"[..], coface_io::Format::Json)?;
    /// let strip = Producer::of(strip)?;
    /// assert!(strip.positions().is_empty());
    /// # Ok(()) }
    /// ```
    pub fn positions(&self) -> &Positions {
        &self.positions
    }

    /// Refuses a model with a coordinate that is NaN or infinite: for whatever needs the position of each vertex. A model without
    /// positions is not refused.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::InvalidInput`] naming the first such coordinate.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::Producer;
    /// use coface_io::Format;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edge = Producer::of(coface_io::read(&b"v 0 0 0\nv 0 nan 0\nl 1 2\n"[..], Format::Obj)?)?;
    /// assert_eq!(edge.chain_complex()?.f_vector(), [2, 1]);
    /// assert!(edge.require_finite().is_err());
    /// # Ok(()) }
    /// ```
    pub fn require_finite(&self) -> Result<(), Error> {
        self.partial_positions.as_ref().and_then(PartialPositions::fault).map_or(Ok(()), Err)
    }

    /// The names of the vertices of a graph by their numbers.
    pub(crate) fn vertex_names(&self) -> Option<&[String]> {
        self.labels.names()
    }

    /// What the reader of the model assumed, changed or left out.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::Producer;
    /// let strip = coface_io::read(&b"[[0,1,7],[1,7,9]]"[..], coface_io::Format::Json)?;
    /// let strip = Producer::of(strip)?;
    /// assert!(strip.remarks().is_empty());
    /// # Ok(()) }
    /// ```
    pub fn remarks(&self) -> &[Remark] {
        &self.remarks
    }

    /// The volume, where the cells are voxels with their faces.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::Producer;
    /// let strip = coface_io::read(&b"[[0,1,7],[1,7,9]]"[..], coface_io::Format::Json)?;
    /// let strip = Producer::of(strip)?;
    /// assert!(strip.volume().is_none());
    /// # Ok(()) }
    /// ```
    pub fn volume(&self) -> Option<&CubicalVolume> {
        match &self.cells {
            Cells::Voxels(cells) => Some(cells.volume()),
            _ => None,
        }
    }

    /// The chain complex of the cells, in the order of their numbers.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::TooLarge`] for boundary matrices beyond 32 bits.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::Producer;
    /// let strip = coface_io::read(&b"[[0,1,7],[1,7,9]]"[..], coface_io::Format::Json)?;
    /// let strip = Producer::of(strip)?;
    /// assert_eq!(strip.chain_complex()?.euler_characteristic(), 1);
    /// # Ok(()) }
    /// ```
    pub fn chain_complex(&self) -> Result<ChainComplex, Error> {
        Ok(match &self.cells {
            Cells::Polygons(mesh) => mesh.chain_complex()?,
            Cells::Solids(mesh) => mesh.chain_complex()?,
            Cells::Simplices(complex) => complex.chain_complex()?,
            Cells::Halfedges(mesh) => mesh.chain_complex()?,
            Cells::Gluings(gluings) => gluings.1.chain_complex()?,
            Cells::Chains(complex) => complex.clone(),
            Cells::Voxels(cells) => cells.chain_complex()?,
            Cells::Ordered(complex) => complex.complex().chain_complex()?,
        })
    }

    /// The chain complex, made out of the arrays of the producer; saves memory and time where no cell has to be named.
    ///
    /// # Errors
    /// Those of [`Self::chain_complex`].
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::Producer;
    /// let strip = coface_io::read(&b"[[0,1,7],[1,7,9]]"[..], coface_io::Format::Json)?;
    /// let strip = Producer::of(strip)?;
    /// assert_eq!(strip.into_chain_complex()?.f_vector(), [4, 5, 2]);
    /// # Ok(()) }
    /// ```
    pub fn into_chain_complex(self) -> Result<ChainComplex, Error> {
        Ok(match self.cells {
            Cells::Polygons(mesh) => mesh.into_chain_complex()?,
            Cells::Solids(mesh) => mesh.into_chain_complex()?,
            Cells::Simplices(complex) => complex.chain_complex()?,
            Cells::Halfedges(mesh) => mesh.chain_complex()?,
            Cells::Gluings(gluings) => gluings.1.chain_complex()?,
            Cells::Chains(complex) => complex,
            Cells::Voxels(cells) => cells.chain_complex()?,
            Cells::Ordered(complex) => complex.complex().chain_complex()?,
        })
    }

    /// The vertices, edges and faces with the paths around the faces, numbered as in [`Self::chain_complex`].
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::InvalidInput`] for a bare chain complex, which does not say how its faces are attached;
    /// [`coface_algebra::ErrorKind::TooLarge`] beyond 32 bits.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::Producer;
    /// let strip = coface_io::read(&b"[[0,1,7],[1,7,9]]"[..], coface_io::Format::Json)?;
    /// let strip = Producer::of(strip)?;
    /// assert_eq!(strip.two_skeleton()?.face_count(), 2);
    /// # Ok(()) }
    /// ```
    pub fn two_skeleton(&self) -> Result<TwoSkeleton, Error> {
        Ok(match &self.cells {
            Cells::Polygons(mesh) => mesh.two_skeleton()?,
            Cells::Solids(mesh) => mesh.two_skeleton()?,
            Cells::Simplices(complex) => complex.two_skeleton()?,
            Cells::Halfedges(mesh) => mesh.two_skeleton()?,
            Cells::Gluings(gluings) => gluings.1.two_skeleton()?,
            Cells::Voxels(_) => {
                return Err(Error::invalid("loops in a volume of voxels have no words")
                    .with_cure("ask for its homology, or make a mesh of its boundary: coface convert VOLUME -o boundary.obj"));
            }
            Cells::Ordered(complex) => complex.complex().two_skeleton()?,
            Cells::Chains(complex) => TwoSkeleton::from_chain_complex(complex).map_err(|_| {
                Error::invalid(
                    "boundary matrices do not say in which order faces run along their edges, so loops have no words",
                )
                .with_cure("give the complex as facets, polygons, cells or halfedges")
            })?,
        })
    }

    /// The cells of all degrees as lists of vertices, numbered as in [`Self::chain_complex`], with their facets.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::InvalidInput`] for halfedges and gluings, whose cells may have a vertex several times, and for
    /// boundary matrices that do not tell the vertices of cells; [`coface_algebra::ErrorKind::TooLarge`] beyond 32 bits.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::Producer;
    /// let strip = coface_io::read(&b"[[0,1,7],[1,7,9]]"[..], coface_io::Format::Json)?;
    /// let strip = Producer::of(strip)?;
    /// assert_eq!(strip.lar_model()?.f_vector(), [4, 5, 2]);
    /// # Ok(()) }
    /// ```
    pub fn lar_model(&self) -> Result<LarModel, Error> {
        match &self.cells {
            Cells::Polygons(mesh) => LarModel::try_from(mesh),
            Cells::Solids(mesh) => LarModel::try_from(&**mesh),
            Cells::Simplices(complex) => LarModel::try_from(complex),
            Cells::Chains(complex) => LarModel::try_from(complex),
            Cells::Voxels(cells) => LarModel::try_from(&cells.chain_complex()?),
            Cells::Halfedges(_) | Cells::Gluings(_) | Cells::Ordered(_) => Err(Error::invalid(
                "the cells of halfedges, gluings and directed flag complexes are not sets of vertices",
            )
            .with_cure("give the complex as facets, polygons or cells, or its boundary matrices")),
        }
    }

    /// The vertices of a cell, by their numbers in the file, in an order that has the orientation of the cell: an edge
    /// from its start to its end, a polygon around. The cells of a chain complex have no vertices, and those of halfedge
    /// permutations and gluing tables may have one vertex several times: they are named by their own numbers. The vertices of a directed flag complex
    /// have edges to those behind them. With a
    /// folded face class the cells of a gluing table are those of its barycentric subdivision.
    ///
    /// # Panics
    /// If there is no such cell.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_algebra::CellId;
    /// use coface_answers::Producer;
    /// let strip = coface_io::read(&b"[[0,1,7],[1,7,9]]"[..], coface_io::Format::Json)?;
    /// let strip = Producer::of(strip)?;
    /// assert_eq!(strip.cell_vertices(2, CellId::new(1)), [1, 7, 9]);
    /// # Ok(()) }
    /// ```
    pub fn cell_vertices(&self, degree: usize, cell: CellId) -> Vec<u32> {
        let cell = cell.index();
        let skeleton = match &self.cells {
            Cells::Polygons(mesh) => mesh,
            Cells::Solids(mesh) if degree == 3 => return mesh.cell(CellId::new(cell)).to_vec(),
            Cells::Solids(mesh) => mesh.skeleton(),
            Cells::Simplices(complex) => return self.labels.of_all(complex.numbers(degree, cell).to_vec()),
            Cells::Halfedges(_) | Cells::Gluings(_) | Cells::Chains(_) => return vec![cell as u32],
            Cells::Voxels(cells) => return cells.vertices(degree, cell),
            Cells::Ordered(complex) => return self.labels.of_all(complex.vertices(degree, cell).to_vec()),
        };
        self.labels.of_all(match degree {
            0 => vec![cell as u32],
            1 => skeleton.edge(EdgeId::new(cell)).map(|end| end.to_u32()).to_vec(),
            _ => skeleton.face(FaceId::new(cell)).to_vec(),
        })
    }
}

/// Up to dimension 2 a polygon mesh, whose questions have more answers.
fn of_facets(mut facets: RaggedArray) -> Result<(Cells, Labels), Error> {
    if facets.iter().any(|facet| facet.len() > 3) {
        return Ok((Cells::Simplices(FrozenComplex::from_facets(&facets)?), Labels::default()));
    }
    let (labels, vertex_count) = Labels::compact(&mut facets);
    let mut triangles = RaggedArray::new();
    let mut edges = Vec::new();
    for facet in facets.iter() {
        match *facet {
            [a, b] => edges.push([a, b]),
            [_, _, _] => triangles.push(facet),
            _ => {}
        }
    }
    Ok((Cells::Polygons(PolygonMesh::new(vertex_count, triangles, &edges)?), labels))
}
