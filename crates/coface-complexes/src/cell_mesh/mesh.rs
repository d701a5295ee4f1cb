//! Cell meshes: tetrahedra, hexahedra, wedges and pyramids on one vertex set, with their faces and edges identified.

use crate::cell_mesh::face_identification::{CellSides, FaceTable, identify_faces};
use crate::cell_mesh::shape::CellShape;
use crate::components::Components;
use crate::surface::PolygonMesh;
use coface_algebra::chains::ChainComplex;
use coface_algebra::{CellId, Error, FaceId};
use coface_algebra::{RaggedArray, Sign, SparseMatrix};
use rayon::prelude::*;

/// A three-dimensional regular cell complex of mixed cells, loose polygons, loose edges and vertices.
///
/// Two sides of cells are one face when they are the same cycle of vertices. So the quadrangle of a hexahedron is
/// not the two triangles of the tetrahedra beside it: between them lies an enclosed pocket, and the homology says so.
/// A cell with the same shape and faces as an earlier one is left out and reported by [`Self::duplicate_cells`].
///
/// # Conventions
/// Faces are cycles from their least vertex towards the smaller neighbor of it, numbered in the lexicographic order of
/// least vertex, smaller and larger neighbor; that is also their orientation. A cell has the orientation of its list of
/// vertices as [`CellShape`] describes; its boundary is the sum of its faces as seen from outside a positive cell.
///
/// # Examples
/// A hexahedron with a pyramid on its top and the top given once more as a loose polygon:
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_complexes::cell_mesh::{CellMesh, CellShape};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let cells = RaggedArray::from_lists([vec![0, 1, 2, 3, 4, 5, 6, 7], vec![4, 5, 6, 7, 8]]);
/// let top = RaggedArray::from_lists([[7, 6, 5, 4]]);
/// let mesh = CellMesh::new(9, vec![CellShape::Hexahedron, CellShape::Pyramid], cells, &top, &[])?;
/// assert_eq!(mesh.f_vector(), [9, 16, 10, 2]);
/// assert_eq!(mesh.cells_of_face(mesh.face_of_polygon(0).0).count(), 2);
/// assert_eq!(mesh.chain_complex()?.euler_characteristic(), 1);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct CellMesh {
    shapes: Vec<CellShape>,
    cells: RaggedArray,
    sides: CellSides,
    /// `polygons` of the table is moved into the skeleton.
    faces: FaceTable,
    skeleton: PolygonMesh,
    /// The position of each cell in the input, when some were left out.
    source_of_cell: Option<Vec<u32>>,
    duplicate_cells: Vec<(CellId, usize)>,
}

impl CellMesh {
    /// The mesh of these cells, cell i with the shape `shapes[i]` and the vertices `cells.list(i)`, of loose polygons and of
    /// loose edges, on the vertices `0..vertex_count`. Polygons that are sides of cells, and edges that are sides of
    /// faces, are identified with them.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::Shape`] unless there are as many shapes as cells; [`coface_algebra::ErrorKind::InvalidInput`] naming the
    /// first cell, polygon or loose edge with a vertex that does not exist or repeats, or of a wrong number of
    /// vertices; [`coface_algebra::ErrorKind::TooLarge`] from 2^30 sides on.
    ///
    /// # Complexity
    /// $O(n \log d)$ for n sides, d of them with one least vertex; parallel over ranges of vertices.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::cell_mesh::{CellMesh, CellShape};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = RaggedArray::from_lists([[0, 1, 2, 3]]);
    /// let mesh = CellMesh::new(4, vec![CellShape::Tetrahedron], corners, &RaggedArray::new(), &[])?;
    /// assert_eq!(mesh.cell_count(), 1);
    /// # Ok(()) }
    /// ```
    pub fn new(
        vertex_count: usize,
        shapes: Vec<CellShape>,
        cells: RaggedArray,
        polygons: &RaggedArray,
        loose_edges: &[[u32; 2]],
    ) -> Result<Self, Error> {
        if shapes.len() != cells.len() {
            return Err(Error::new(
                coface_algebra::ErrorKind::Shape,
                format!("{} shapes beside {} cells", shapes.len(), cells.len()),
            ));
        }
        let sides = CellSides::new(&shapes);
        let mut faces = identify_faces(vertex_count, &shapes, &cells, &sides, polygons)?;
        let duplicates = duplicate_cells(&shapes, &sides, &faces);
        if !duplicates.is_empty() {
            return Self::without(vertex_count, &shapes, &cells, polygons, loose_edges, &duplicates);
        }
        let skeleton = PolygonMesh::new(vertex_count, std::mem::take(&mut faces.polygons), loose_edges)?;
        Ok(Self { shapes, cells, sides, faces, skeleton, source_of_cell: None, duplicate_cells: Vec::new() })
    }

    /// The mesh without the later cells of these pairs.
    fn without(
        vertex_count: usize,
        shapes: &[CellShape],
        cells: &RaggedArray,
        polygons: &RaggedArray,
        loose_edges: &[[u32; 2]],
        duplicates: &[(u32, u32)],
    ) -> Result<Self, Error> {
        let mut dropped = vec![false; shapes.len()];
        for &(_, later) in duplicates {
            dropped[later as usize] = true;
        }
        let kept: Vec<u32> = (0..shapes.len() as u32).filter(|&c| !dropped[c as usize]).collect();
        let distinct = RaggedArray::from_lists(kept.iter().map(|&c| cells.list(c as usize)));
        let kept_shapes = kept.iter().map(|&c| shapes[c as usize]).collect();
        let mut mesh = Self::new(vertex_count, kept_shapes, distinct, polygons, loose_edges)?;
        mesh.duplicate_cells = duplicates
            .iter()
            .map(|&(first, later)| {
                let cell = kept.binary_search(&first).expect("the first of equal cells is kept");
                (CellId::new(cell), later as usize)
            })
            .collect();
        mesh.source_of_cell = Some(kept);
        Ok(mesh)
    }

    /// The number of vertices, isolated ones included.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::cell_mesh::{CellMesh, CellShape};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = RaggedArray::from_lists([[0, 1, 2, 3]]);
    /// let mesh = CellMesh::new(4, vec![CellShape::Tetrahedron], corners, &RaggedArray::new(), &[])?;
    /// assert_eq!(mesh.vertex_count(), 4);
    /// # Ok(()) }
    /// ```
    pub fn vertex_count(&self) -> usize {
        self.skeleton.vertex_count()
    }

    /// The number of edges, loose ones included.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::cell_mesh::{CellMesh, CellShape};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = RaggedArray::from_lists([[0, 1, 2, 3]]);
    /// let mesh = CellMesh::new(4, vec![CellShape::Tetrahedron], corners, &RaggedArray::new(), &[])?;
    /// assert_eq!(mesh.edge_count(), 6);
    /// # Ok(()) }
    /// ```
    pub fn edge_count(&self) -> usize {
        self.skeleton.edge_count()
    }

    /// The number of faces, loose polygons included.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::cell_mesh::{CellMesh, CellShape};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = RaggedArray::from_lists([[0, 1, 2, 3]]);
    /// let mesh = CellMesh::new(4, vec![CellShape::Tetrahedron], corners, &RaggedArray::new(), &[])?;
    /// assert_eq!(mesh.face_count(), 4);
    /// # Ok(()) }
    /// ```
    pub fn face_count(&self) -> usize {
        self.skeleton.face_count()
    }

    /// The number of cells.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::cell_mesh::{CellMesh, CellShape};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = RaggedArray::from_lists([[0, 1, 2, 3]]);
    /// let mesh = CellMesh::new(4, vec![CellShape::Tetrahedron], corners, &RaggedArray::new(), &[])?;
    /// assert_eq!(mesh.cell_count(), 1);
    /// # Ok(()) }
    /// ```
    pub fn cell_count(&self) -> usize {
        self.shapes.len()
    }

    /// The numbers of vertices, edges, faces and cells.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::cell_mesh::{CellMesh, CellShape};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = RaggedArray::from_lists([[0, 1, 2, 3]]);
    /// let mesh = CellMesh::new(4, vec![CellShape::Tetrahedron], corners, &RaggedArray::new(), &[])?;
    /// assert_eq!(mesh.f_vector(), [4, 6, 4, 1]);
    /// # Ok(()) }
    /// ```
    pub fn f_vector(&self) -> Vec<usize> {
        vec![self.vertex_count(), self.edge_count(), self.face_count(), self.cell_count()]
    }

    /// The alternating sum of the numbers of vertices, edges, faces and cells.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::cell_mesh::{CellMesh, CellShape};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = RaggedArray::from_lists([[0, 1, 2, 3]]);
    /// let mesh = CellMesh::new(4, vec![CellShape::Tetrahedron], corners, &RaggedArray::new(), &[])?;
    /// assert_eq!(mesh.euler_characteristic(), 1);
    /// # Ok(()) }
    /// ```
    pub fn euler_characteristic(&self) -> i64 {
        self.skeleton.euler_characteristic() - self.cell_count() as i64
    }

    /// The vertices, edges and faces.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::cell_mesh::{CellMesh, CellShape};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = RaggedArray::from_lists([[0, 1, 2, 3]]);
    /// let mesh = CellMesh::new(4, vec![CellShape::Tetrahedron], corners, &RaggedArray::new(), &[])?;
    /// assert_eq!(mesh.skeleton().euler_characteristic(), 2);
    /// # Ok(()) }
    /// ```
    pub fn skeleton(&self) -> &PolygonMesh {
        &self.skeleton
    }

    /// The connected components; each isolated vertex is one.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::cell_mesh::{CellMesh, CellShape};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = RaggedArray::from_lists([[0, 1, 2, 3]]);
    /// let mesh = CellMesh::new(4, vec![CellShape::Tetrahedron], corners, &RaggedArray::new(), &[])?;
    /// assert_eq!(mesh.components().count(), 1);
    /// # Ok(()) }
    /// ```
    pub fn components(&self) -> Components {
        self.skeleton.components()
    }

    /// The shapes of the cells.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::cell_mesh::{CellMesh, CellShape};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = RaggedArray::from_lists([[0, 1, 2, 3]]);
    /// let mesh = CellMesh::new(4, vec![CellShape::Tetrahedron], corners, &RaggedArray::new(), &[])?;
    /// assert_eq!(mesh.shapes(), [CellShape::Tetrahedron]);
    /// # Ok(()) }
    /// ```
    pub fn shapes(&self) -> &[CellShape] {
        &self.shapes
    }

    /// The cells by their vertices.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::cell_mesh::{CellMesh, CellShape};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = RaggedArray::from_lists([[0, 1, 2, 3]]);
    /// let mesh = CellMesh::new(4, vec![CellShape::Tetrahedron], corners, &RaggedArray::new(), &[])?;
    /// assert_eq!(mesh.cells().list(0), [0, 1, 2, 3]);
    /// # Ok(()) }
    /// ```
    pub fn cells(&self) -> &RaggedArray {
        &self.cells
    }

    /// The vertices of a cell in the order that [`CellShape`] describes.
    ///
    /// # Panics
    /// If there is no such cell.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, RaggedArray};
    /// use coface_complexes::cell_mesh::{CellMesh, CellShape};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = RaggedArray::from_lists([[0, 1, 2, 3]]);
    /// let mesh = CellMesh::new(4, vec![CellShape::Tetrahedron], corners, &RaggedArray::new(), &[])?;
    /// assert_eq!(mesh.cell(CellId::new(0)), [0, 1, 2, 3]);
    /// # Ok(()) }
    /// ```
    pub fn cell(&self, cell: CellId) -> &[u32] {
        self.cells.list(cell.index())
    }

    /// The position of a cell among the cells the mesh was made of.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, RaggedArray};
    /// use coface_complexes::cell_mesh::{CellMesh, CellShape};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = RaggedArray::from_lists([[0, 1, 2, 3]]);
    /// let mesh = CellMesh::new(4, vec![CellShape::Tetrahedron], corners, &RaggedArray::new(), &[])?;
    /// assert_eq!(mesh.source_of_cell(CellId::new(0)), 0);
    /// # Ok(()) }
    /// ```
    pub fn source_of_cell(&self, cell: CellId) -> usize {
        self.source_of_cell.as_ref().map_or(cell.index(), |kept| kept[cell.index()] as usize)
    }

    /// The cells that were left out: each with the cell that has the same shape and faces, by rising position in the
    /// input.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::cell_mesh::{CellMesh, CellShape};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = RaggedArray::from_lists([[0, 1, 2, 3]]);
    /// let mesh = CellMesh::new(4, vec![CellShape::Tetrahedron], corners, &RaggedArray::new(), &[])?;
    /// assert!(mesh.duplicate_cells().is_empty());
    /// # Ok(()) }
    /// ```
    pub fn duplicate_cells(&self) -> &[(CellId, usize)] {
        &self.duplicate_cells
    }

    /// The face that loose polygon `i` of the input is, with minus if the polygon runs against it.
    ///
    /// # Panics
    /// If there were not so many polygons.
    pub fn face_of_polygon(&self, i: usize) -> (FaceId, Sign) {
        face_and_sign(self.faces.side_faces[self.sides.start(self.cell_count()) + i])
    }

    /// The faces of a cell in the order of [`CellShape::faces`], with minus where the face runs against the boundary of
    /// the cell.
    ///
    /// # Panics
    /// If there is no such cell.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, RaggedArray};
    /// use coface_complexes::cell_mesh::{CellMesh, CellShape};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = RaggedArray::from_lists([[0, 1, 2, 3]]);
    /// let mesh = CellMesh::new(4, vec![CellShape::Tetrahedron], corners, &RaggedArray::new(), &[])?;
    /// assert_eq!(mesh.faces_of_cell(CellId::new(0)).len(), 4);
    /// # Ok(()) }
    /// ```
    pub fn faces_of_cell(&self, cell: CellId) -> impl ExactSizeIterator<Item = (FaceId, Sign)> + '_ {
        self.packed_faces(cell.index()).iter().map(|&packed| face_and_sign(packed))
    }

    /// The faces of the cell at this position, each as `2 * face + reversed`.
    pub(crate) fn packed_faces(&self, cell: usize) -> &[u32] {
        &self.faces.side_faces[self.sides.range(cell)]
    }

    /// The cells at a face, rising, with minus where the boundary of the cell runs against the face.
    ///
    /// # Panics
    /// If there is no such face.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{FaceId, RaggedArray};
    /// use coface_complexes::cell_mesh::{CellMesh, CellShape};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = RaggedArray::from_lists([[0, 1, 2, 3]]);
    /// let mesh = CellMesh::new(4, vec![CellShape::Tetrahedron], corners, &RaggedArray::new(), &[])?;
    /// assert_eq!(mesh.cells_of_face(FaceId::new(0)).len(), 1);
    /// # Ok(()) }
    /// ```
    pub fn cells_of_face(&self, face: FaceId) -> impl ExactSizeIterator<Item = (CellId, Sign)> + '_ {
        self.packed_cells(face.index())
            .iter()
            .map(|&packed| (CellId::from_u32(packed >> 1), Sign::power_of_minus_one((packed & 1) as usize)))
    }

    /// The cells at the face at this position, each as `2 * cell + reversed`.
    pub(crate) fn packed_cells(&self, face: usize) -> &[u32] {
        let starts = &self.faces.cell_starts;
        &self.faces.cells[starts[face] as usize..starts[face + 1] as usize]
    }

    /// The boundary matrix of degree 3: rows are faces, columns cells.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::cell_mesh::{CellMesh, CellShape};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = RaggedArray::from_lists([[0, 1, 2, 3]]);
    /// let mesh = CellMesh::new(4, vec![CellShape::Tetrahedron], corners, &RaggedArray::new(), &[])?;
    /// assert_eq!(mesh.cell_boundaries().column(0).rows(), [0, 1, 2, 3]);
    /// # Ok(()) }
    /// ```
    pub fn cell_boundaries(&self) -> SparseMatrix {
        let side_count = self.sides.start(self.cell_count());
        cell_boundaries(
            self.face_count(),
            &self.sides,
            self.cell_count(),
            self.faces.side_faces[..side_count].to_vec(),
        )
    }

    /// The chain complex of vertices, edges, faces and cells in the order of their ids.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`](coface_algebra::ErrorKind::TooLarge) for boundary matrices beyond 32 bits.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::cell_mesh::{CellMesh, CellShape};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = RaggedArray::from_lists([[0, 1, 2, 3]]);
    /// let mesh = CellMesh::new(4, vec![CellShape::Tetrahedron], corners, &RaggedArray::new(), &[])?;
    /// assert_eq!(mesh.chain_complex()?.f_vector(), [4, 6, 4, 1]);
    /// # Ok(()) }
    /// ```
    pub fn chain_complex(&self) -> Result<ChainComplex, Error> {
        if self.cell_count() == 0 {
            return self.skeleton.chain_complex();
        }
        let boundaries =
            vec![self.skeleton.edge_boundaries(), self.skeleton.face_boundaries(), self.cell_boundaries()];
        ChainComplex::new(boundaries)
    }

    /// The chain complex, made out of the arrays of the mesh; saves memory and time where the mesh is not needed any
    /// more.
    ///
    /// # Errors
    /// As [`Self::chain_complex`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::cell_mesh::{CellMesh, CellShape};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = RaggedArray::from_lists([[0, 1, 2, 3]]);
    /// let mesh = CellMesh::new(4, vec![CellShape::Tetrahedron], corners, &RaggedArray::new(), &[])?;
    /// assert_eq!(mesh.into_chain_complex()?.euler_characteristic(), 1);
    /// # Ok(()) }
    /// ```
    pub fn into_chain_complex(self) -> Result<ChainComplex, Error> {
        let Self { shapes, sides, faces, skeleton, .. } = self;
        if shapes.is_empty() {
            return skeleton.into_chain_complex();
        }
        let (face_count, mut side_faces) = (skeleton.face_count(), faces.side_faces);
        side_faces.truncate(sides.start(shapes.len()));
        let (two, three) = rayon::join(
            || skeleton.into_boundary_matrices(),
            || cell_boundaries(face_count, &sides, shapes.len(), side_faces),
        );
        let boundaries = two.into_iter().chain([three]).collect();
        ChainComplex::new(boundaries)
    }
}

fn face_and_sign(packed: u32) -> (FaceId, Sign) {
    (FaceId::from_u32(packed >> 1), Sign::power_of_minus_one((packed & 1) as usize))
}

/// `side_faces` becomes the rows: the faces of each cell are sorted in place.
fn cell_boundaries(
    face_count: usize,
    sides: &CellSides,
    cell_count: usize,
    side_faces: Vec<u32>,
) -> SparseMatrix {
    let mut rows = side_faces;
    let mut entries = vec![0i32; rows.len()];
    let unpack = |rows: &mut [u32], entries: &mut [i32]| {
        rows.sort_unstable();
        for (row, entry) in rows.iter_mut().zip(entries) {
            *entry = 1 - 2 * (*row & 1) as i32;
            *row >>= 1;
        }
    };
    if let CellSides::Uniform(count) = *sides {
        const BLOCK: usize = 1 << 12;
        rows.par_chunks_mut(BLOCK * count).zip(entries.par_chunks_mut(BLOCK * count)).for_each(
            |(rows, entries)| {
                for (rows, entries) in rows.chunks_mut(count).zip(entries.chunks_mut(count)) {
                    unpack(rows, entries);
                }
            },
        );
    } else {
        for cell in 0..cell_count {
            unpack(&mut rows[sides.range(cell)], &mut entries[sides.range(cell)]);
        }
    }
    let starts = (0..=cell_count).map(|cell| sides.start(cell) as u32).collect();
    SparseMatrix::from_trusted_parts(face_count, starts, rows, entries)
        .expect("a cell has each of its faces once")
}

/// The pairs (first, later) of cells of one shape with the same faces, by the later cell.
fn duplicate_cells(shapes: &[CellShape], sides: &CellSides, faces: &FaceTable) -> Vec<(u32, u32)> {
    let faces_of = |cell: u32| &faces.side_faces[sides.range(cell as usize)];
    let least_face = |cell: u32| faces_of(cell).iter().map(|packed| packed >> 1).min();
    let sorted = |cell: u32| {
        let mut list: Vec<u32> = faces_of(cell).iter().map(|packed| packed >> 1).collect();
        list.sort_unstable();
        (shapes[cell as usize], list)
    };
    let mut pairs: Vec<(u32, u32)> = (0..faces.cell_starts.len() - 1)
        .into_par_iter()
        .flat_map_iter(|face| {
            let at = &faces.cells[faces.cell_starts[face] as usize..faces.cell_starts[face + 1] as usize];
            let mut pairs = Vec::new();
            // Equal cells are at one face with it as their least.
            if at.len() > 1 {
                let is_least = |&&packed: &&u32| least_face(packed >> 1) == Some(face as u32);
                if at.iter().filter(is_least).count() > 1 {
                    let mut cells: Vec<_> =
                        at.iter().filter(is_least).map(|&p| (sorted(p >> 1), p >> 1)).collect();
                    cells.sort_unstable();
                    for equal in cells.chunk_by(|a, b| a.0 == b.0) {
                        pairs.extend(equal[1..].iter().map(|&(_, later)| (equal[0].1, later)));
                    }
                }
            }
            pairs
        })
        .collect();
    pairs.sort_unstable_by_key(|&(_, later)| later);
    pairs
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::collections::{BTreeMap, BTreeSet};

    /// The cycle from its least vertex towards the smaller neighbor, found by trying all readings.
    fn least_reading(cycle: &[u32]) -> Vec<u32> {
        let n = cycle.len();
        let reading =
            |start: usize, step: usize| (0..n).map(|i| cycle[(start + i * step) % n]).collect::<Vec<_>>();
        (0..n).flat_map(|start| [reading(start, 1), reading(start, n - 1)]).min().unwrap()
    }

    fn is_rotation(a: &[u32], b: &[u32]) -> bool {
        (0..a.len()).any(|k| (0..a.len()).all(|i| a[i] == b[(i + k) % b.len()]))
    }

    fn sides_of(shape: CellShape, cell: &[u32]) -> Vec<Vec<u32>> {
        shape.faces().iter().map(|side| side.iter().map(|&i| cell[i]).collect()).collect()
    }

    #[derive(Clone, Debug)]
    struct Soup {
        shapes: Vec<CellShape>,
        cells: Vec<Vec<u32>>,
        polygons: Vec<Vec<u32>>,
    }

    fn soup() -> impl Strategy<Value = Soup> {
        let shuffled = |n: u32| Just((0..n).collect::<Vec<u32>>()).prop_shuffle();
        let cell = |n: u32| {
            (shuffled(n), prop::sample::select(&CellShape::ALL[..])).prop_map(|(mut v, shape)| {
                v.truncate(shape.vertex_count());
                (shape, v)
            })
        };
        let tetrahedron = shuffled(5).prop_map(|v| (CellShape::Tetrahedron, v[..4].to_vec()));
        let polygon = (shuffled(9), 3usize..7).prop_map(|(mut v, n)| {
            v.truncate(n);
            v
        });
        (
            prop_oneof![
                prop::collection::vec(cell(9), 0..12),
                prop::collection::vec(tetrahedron, 0..8),
                prop::collection::vec(cell(8), 0..20),
            ],
            prop::collection::vec(polygon, 0..5),
            prop::collection::vec(any::<prop::sample::Index>(), 0..4),
        )
            .prop_map(|(pairs, mut polygons, sides)| {
                let (shapes, mut cells): (Vec<_>, Vec<_>) = pairs.into_iter().unzip();
                // Some polygons that are sides of cells, and a cell that stands twice in another order.
                for side in sides {
                    if !cells.is_empty() {
                        let cell = side.index(cells.len());
                        let all = sides_of(shapes[cell], &cells[cell]);
                        polygons.push(all[side.index(all.len())].clone());
                        polygons.last_mut().unwrap().rotate_left(1);
                    }
                }
                if let ([CellShape::Tetrahedron, CellShape::Tetrahedron, ..], [a, b, ..]) =
                    (&shapes[..], &mut cells[..])
                {
                    b.clone_from(a);
                    b.swap(1, 2);
                }
                Soup { shapes, cells, polygons }
            })
    }

    fn mesh_of(soup: &Soup) -> CellMesh {
        let (cells, polygons) =
            (RaggedArray::from_lists(&soup.cells), RaggedArray::from_lists(&soup.polygons));
        CellMesh::new(9, soup.shapes.clone(), cells, &polygons, &[[0, 1]]).unwrap()
    }

    #[test]
    fn one_cell_of_each_shape_is_a_ball() {
        let table = [
            (CellShape::Tetrahedron, [4, 6, 4, 1]),
            (CellShape::Hexahedron, [8, 12, 6, 1]),
            (CellShape::Wedge, [6, 9, 5, 1]),
            (CellShape::Pyramid, [5, 8, 5, 1]),
        ];
        for (shape, f_vector) in table {
            let n = shape.vertex_count();
            let cells = RaggedArray::from_lists([(0..n as u32).rev().collect::<Vec<_>>()]);
            let mesh = CellMesh::new(n, vec![shape], cells, &RaggedArray::new(), &[]).unwrap();
            assert_eq!(mesh.f_vector(), f_vector, "{shape:?}");
            assert_eq!(mesh.chain_complex().unwrap().f_vector(), f_vector);
        }
    }

    #[test]
    fn a_quadrangle_is_not_two_triangles() {
        // A hexahedron, and on its top two tetrahedra that share the diagonal 4 6 and an apex.
        let shapes = vec![CellShape::Hexahedron, CellShape::Tetrahedron, CellShape::Tetrahedron];
        let cells =
            RaggedArray::from_lists([vec![0, 1, 2, 3, 4, 5, 6, 7], vec![4, 5, 6, 8], vec![4, 6, 7, 8]]);
        let mesh = CellMesh::new(9, shapes, cells, &RaggedArray::new(), &[]).unwrap();
        // The quadrangle 4567 and the triangles 456, 467 enclose a pocket: Euler characteristic 1 + 1.
        assert_eq!((mesh.f_vector(), mesh.euler_characteristic()), (vec![9, 17, 13, 3], 2));
    }

    #[test]
    fn faults_name_the_cell() {
        let fault = |shapes: &[CellShape], cells: &[Vec<u32>], polygons: &[Vec<u32>]| {
            CellMesh::new(
                6,
                shapes.to_vec(),
                RaggedArray::from_lists(cells),
                &RaggedArray::from_lists(polygons),
                &[],
            )
            .unwrap_err()
            .to_string()
        };
        let tet = [CellShape::Tetrahedron];
        assert!(fault(&tet, &[vec![0, 1, 2, 6]], &[]).starts_with("cell c0, a tetrahedron, names vertex v6"));
        assert!(
            fault(&tet, &[vec![0, 1, 2, 1]], &[]).starts_with("cell c0, a tetrahedron, repeats vertex v1")
        );
        assert!(
            fault(&tet, &[vec![0, 1, 2, 3, 4]], &[])
                .starts_with("cell c0 has 5 vertices; a tetrahedron has 4")
        );
        assert!(fault(&[], &[vec![0, 1, 2, 3]], &[]).starts_with("0 shapes beside 1 cells"));
        assert!(fault(&[], &[], &[vec![0, 1, 9]]).starts_with("face f0 names vertex v9"));
    }

    #[test]
    fn many_ranges_agree_with_the_counts_of_a_torus() {
        // The 3-torus of 18^3 cubes, six tetrahedra each: 5832 vertices, more than one range of vertices and one chunk.
        let n = 18u32;
        let id = |p: [u32; 3]| (p[0] % n * n + p[1] % n) * n + p[2] % n;
        let mut cells = Vec::new();
        for k in 0..n.pow(3) {
            let corner = [k / (n * n), k / n % n, k % n];
            for order in [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]] {
                let mut at = corner;
                cells.push(id(at));
                for axis in order {
                    at[axis] += 1;
                    cells.push(id(at));
                }
            }
        }
        let cells = RaggedArray::uniform(4, cells).unwrap();
        let v = n.pow(3) as usize;
        let mesh =
            CellMesh::new(v, vec![CellShape::Tetrahedron; 6 * v], cells, &RaggedArray::new(), &[]).unwrap();
        assert_eq!(mesh.f_vector(), [v, 7 * v, 12 * v, 6 * v]);
        assert!((0..mesh.face_count()).all(|face| mesh.packed_cells(face).len() == 2));
        assert_eq!(mesh.chain_complex().unwrap().euler_characteristic(), 0);
    }

    proptest! {
        #[test]
        fn faces_and_cells_agree_with_sets(soup in soup()) {
            let mesh = mesh_of(&soup);
            // Equal cells: one shape and the same set of faces.
            let faces_of = |i: usize| -> BTreeSet<Vec<u32>> {
                sides_of(soup.shapes[i], &soup.cells[i]).iter().map(|side| least_reading(side)).collect()
            };
            let (mut first, mut kept, mut dropped) = (BTreeMap::new(), Vec::new(), Vec::new());
            for i in 0..soup.cells.len() {
                let key = (soup.shapes[i], faces_of(i));
                if let Some(&cell) = first.get(&key) {
                    dropped.push((CellId::new(cell), i));
                } else {
                    first.insert(key, kept.len());
                    kept.push(i);
                }
            }
            prop_assert_eq!(mesh.duplicate_cells(), dropped);
            prop_assert_eq!(mesh.cell_count(), kept.len());

            let all: BTreeSet<Vec<u32>> = (0..soup.cells.len())
                .flat_map(faces_of)
                .chain(soup.polygons.iter().map(|p| least_reading(p)))
                .collect();
            let listed: BTreeSet<Vec<u32>> = mesh.skeleton().polygons().iter().map(<[u32]>::to_vec).collect();
            prop_assert_eq!(mesh.face_count(), listed.len());
            prop_assert_eq!(listed, all);

            let matrix = mesh.cell_boundaries();
            let mut at_face = vec![Vec::new(); mesh.face_count()];
            for (cell, &source) in kept.iter().enumerate() {
                let id = CellId::new(cell);
                prop_assert_eq!(mesh.source_of_cell(id), source);
                prop_assert_eq!(mesh.cell(id), &soup.cells[source][..]);
                let sides = sides_of(soup.shapes[source], &soup.cells[source]);
                for ((face, sign), side) in mesh.faces_of_cell(id).zip(&sides) {
                    prop_assert_eq!(mesh.skeleton().face(face), least_reading(side));
                    prop_assert_eq!(sign == Sign::Plus, is_rotation(mesh.skeleton().face(face), side));
                    prop_assert_eq!(matrix.entry(face.index(), cell), sign.to_i32());
                    at_face[face.index()].push((id, sign));
                }
            }
            for (face, cells) in at_face.iter().enumerate() {
                prop_assert_eq!(&mesh.cells_of_face(FaceId::new(face)).collect::<Vec<_>>(), cells);
            }
            for (i, polygon) in soup.polygons.iter().enumerate() {
                let (face, sign) = mesh.face_of_polygon(i);
                prop_assert_eq!(mesh.skeleton().face(face), least_reading(polygon));
                prop_assert_eq!(sign == Sign::Plus, is_rotation(mesh.skeleton().face(face), polygon));
            }
            // The complex checks that the products are zero.
            let complex = mesh.chain_complex().unwrap();
            prop_assert_eq!(complex.euler_characteristic(), mesh.euler_characteristic());
            prop_assert_eq!(mesh.into_chain_complex().unwrap(), complex);
        }
    }
}
