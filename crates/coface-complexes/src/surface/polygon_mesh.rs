//! Polygon meshes: any soup of polygons on one vertex set, with its edges identified.

use super::edge_identification::{EdgeTable, identify_edges};
use coface_algebra::chains::ChainComplex;
use coface_algebra::{EdgeId, Error, FaceId, VertexId};
use coface_algebra::{RaggedArray, Sign, SparseMatrix};
use rayon::prelude::*;

/// A two-dimensional regular cell complex of polygons, edges and vertices.
///
/// Any set of polygons is welcome: edges with three or more faces, vertices where several sheets meet, faces that run
/// against each other, several components, edges without a face and vertices without an edge. A polygon with the
/// same cycle of edges as an earlier one is left out and reported by [`Self::duplicate_faces`].
///
/// # Conventions
/// Edges are numbered in the lexicographic order of their pairs (smaller vertex, larger vertex) and point from the
/// smaller to the larger. Faces keep the order of the polygons and the orientation in which their vertices are
/// listed; corner i of a face is at its vertex i, and the side of that corner runs to the next vertex.
///
/// # Examples
/// Two triangles on a common edge, one edge more and one vertex more:
/// ```
/// use coface_algebra::{RaggedArray, VertexId};
/// use coface_complexes::surface::PolygonMesh;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let mesh = PolygonMesh::new(6, RaggedArray::from_lists([[0, 1, 2], [2, 1, 3]]), &[[3, 4]])?;
/// assert_eq!(mesh.f_vector(), [6, 6, 2]);
/// assert_eq!(mesh.euler_characteristic(), 2);
/// let shared = mesh.edge_between(VertexId::new(2), VertexId::new(1)).expect("both triangles have it");
/// assert_eq!(mesh.face_count_at(shared), 2);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct PolygonMesh {
    vertex_count: usize,
    polygons: RaggedArray,
    edges: EdgeTable,
    /// The position of each face in the input, when some polygons were left out.
    polygon_of_face: Option<Vec<u32>>,
    duplicate_faces: Vec<(FaceId, usize)>,
}

impl PolygonMesh {
    /// The mesh of these polygons, each a cycle of at least three vertices, and loose edges, each a pair, on the
    /// vertices `0..vertex_count`. Loose edges that are sides of faces, or stand twice, are identified.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::InvalidInput`] naming the first polygon or loose edge with a vertex that does not exist, a repeated vertex, or too
    /// few vertices; [`coface_algebra::ErrorKind::TooLarge`] from 2^30 sides on.
    ///
    /// # Complexity
    /// Linear, by two passes of counting; parallel over ranges of vertices.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::PolygonMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = PolygonMesh::new(4, RaggedArray::from_lists([[0, 1, 2, 3]]), &[])?;
    /// assert_eq!(square.edge_count(), 4);
    /// assert!(PolygonMesh::new(3, RaggedArray::from_lists([[0, 1, 7]]), &[]).is_err());
    /// # Ok(()) }
    /// ```
    pub fn new(vertex_count: usize, polygons: RaggedArray, loose_edges: &[[u32; 2]]) -> Result<Self, Error> {
        let edges = identify_edges(vertex_count, &polygons, loose_edges)?;
        if edges.duplicates.is_empty() {
            let duplicate_faces = Vec::new();
            return Ok(Self { vertex_count, polygons, edges, polygon_of_face: None, duplicate_faces });
        }
        let mut dropped = vec![false; polygons.len()];
        for &(_, later) in &edges.duplicates {
            dropped[later as usize] = true;
        }
        let kept: Vec<u32> = (0..polygons.len() as u32).filter(|&p| !dropped[p as usize]).collect();
        let duplicate_faces = edges
            .duplicates
            .iter()
            .map(|&(first, later)| {
                let face = kept.binary_search(&first).expect("the first of equal faces is kept");
                (FaceId::new(face), later as usize)
            })
            .collect();
        let distinct = RaggedArray::from_lists(kept.iter().map(|&p| polygons.list(p as usize)));
        let edges = identify_edges(vertex_count, &distinct, loose_edges)?;
        Ok(Self { vertex_count, polygons: distinct, edges, polygon_of_face: Some(kept), duplicate_faces })
    }

    /// The number of vertices, isolated ones included.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::PolygonMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = PolygonMesh::new(4, RaggedArray::from_lists([[0, 1, 2, 3]]), &[])?;
    /// assert_eq!(square.vertex_count(), 4);
    /// # Ok(()) }
    /// ```
    pub fn vertex_count(&self) -> usize {
        self.vertex_count
    }

    /// The number of edges, loose ones included.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::PolygonMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = PolygonMesh::new(4, RaggedArray::from_lists([[0, 1, 2, 3]]), &[])?;
    /// assert_eq!(square.edge_count(), 4);
    /// # Ok(()) }
    /// ```
    pub fn edge_count(&self) -> usize {
        self.edges.ends.len() / 2
    }

    /// The number of faces.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::PolygonMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = PolygonMesh::new(4, RaggedArray::from_lists([[0, 1, 2, 3]]), &[])?;
    /// assert_eq!(square.face_count(), 1);
    /// # Ok(()) }
    /// ```
    pub fn face_count(&self) -> usize {
        self.polygons.len()
    }

    /// The numbers of vertices, edges and faces.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::PolygonMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = PolygonMesh::new(4, RaggedArray::from_lists([[0, 1, 2, 3]]), &[])?;
    /// assert_eq!(square.f_vector(), [4, 4, 1]);
    /// # Ok(()) }
    /// ```
    pub fn f_vector(&self) -> Vec<usize> {
        vec![self.vertex_count, self.edge_count(), self.face_count()]
    }

    /// Vertices minus edges plus faces.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::PolygonMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = PolygonMesh::new(4, RaggedArray::from_lists([[0, 1, 2, 3]]), &[])?;
    /// assert_eq!(square.euler_characteristic(), 1);
    /// # Ok(()) }
    /// ```
    pub fn euler_characteristic(&self) -> i64 {
        self.vertex_count as i64 - self.edge_count() as i64 + self.face_count() as i64
    }

    /// The faces as cycles of vertices: list i is face i.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::PolygonMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = PolygonMesh::new(4, RaggedArray::from_lists([[0, 1, 2, 3]]), &[])?;
    /// assert_eq!(square.polygons().list(0), [0, 1, 2, 3]);
    /// # Ok(()) }
    /// ```
    pub fn polygons(&self) -> &RaggedArray {
        &self.polygons
    }

    /// The vertices of a face in order.
    ///
    /// # Panics
    /// If there is no such face.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{FaceId, RaggedArray};
    /// use coface_complexes::surface::PolygonMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = PolygonMesh::new(4, RaggedArray::from_lists([[0, 1, 2, 3]]), &[])?;
    /// assert_eq!(square.face(FaceId::new(0)), [0, 1, 2, 3]);
    /// # Ok(()) }
    /// ```
    pub fn face(&self, face: FaceId) -> &[u32] {
        self.polygons.list(face.index())
    }

    /// The position of a face among the polygons the mesh was made of.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{FaceId, RaggedArray};
    /// use coface_complexes::surface::PolygonMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = PolygonMesh::new(4, RaggedArray::from_lists([[0, 1, 2, 3]]), &[])?;
    /// assert_eq!(square.polygon_of_face(FaceId::new(0)), 0);
    /// # Ok(()) }
    /// ```
    pub fn polygon_of_face(&self, face: FaceId) -> usize {
        self.polygon_of_face.as_ref().map_or(face.index(), |kept| kept[face.index()] as usize)
    }

    /// The polygons that were left out: each with the face that has the same edges, by rising position in the input.
    ///
    /// # Examples
    /// A triangle given twice, the second time the other way around:
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::PolygonMesh;
    /// use coface_algebra::FaceId;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mesh = PolygonMesh::new(3, RaggedArray::from_lists([[0, 1, 2], [1, 0, 2]]), &[])?;
    /// assert_eq!(mesh.face_count(), 1);
    /// assert_eq!(mesh.duplicate_faces(), [(FaceId::new(0), 1)]);
    /// # Ok(()) }
    /// ```
    pub fn duplicate_faces(&self) -> &[(FaceId, usize)] {
        &self.duplicate_faces
    }

    /// The two ends of an edge, the smaller first.
    ///
    /// # Panics
    /// If there is no such edge.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{EdgeId, RaggedArray};
    /// use coface_complexes::surface::PolygonMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = PolygonMesh::new(4, RaggedArray::from_lists([[0, 1, 2, 3]]), &[])?;
    /// assert_eq!(square.edge(EdgeId::new(1)).map(|end| end.index()), [0, 3]);
    /// # Ok(()) }
    /// ```
    pub fn edge(&self, edge: EdgeId) -> [VertexId; 2] {
        let [a, b] = self.ends(edge.index());
        [VertexId::from_u32(a), VertexId::from_u32(b)]
    }

    /// The ends of the edge at this position as plain numbers.
    pub(crate) fn ends(&self, edge: usize) -> [u32; 2] {
        [self.edges.ends[2 * edge], self.edges.ends[2 * edge + 1]]
    }

    /// The ends of all edges, two by two.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::PolygonMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = PolygonMesh::new(4, RaggedArray::from_lists([[0, 1, 2, 3]]), &[])?;
    /// assert_eq!(square.edge_ends(), [0, 1, 0, 3, 1, 2, 2, 3]);
    /// # Ok(()) }
    /// ```
    pub fn edge_ends(&self) -> &[u32] {
        &self.edges.ends
    }

    /// The edge between two vertices, if there is one.
    ///
    /// # Complexity
    /// Logarithmic.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{EdgeId, RaggedArray, VertexId};
    /// use coface_complexes::surface::PolygonMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = PolygonMesh::new(4, RaggedArray::from_lists([[0, 1, 2, 3]]), &[])?;
    /// let [a, b, c] = [0, 2, 3].map(VertexId::new);
    /// assert_eq!(square.edge_between(c, a), Some(EdgeId::new(1)));
    /// assert_eq!(square.edge_between(a, b), None);
    /// # Ok(()) }
    /// ```
    pub fn edge_between(&self, a: VertexId, b: VertexId) -> Option<EdgeId> {
        let wanted = (a.min(b).to_u32(), a.max(b).to_u32());
        let (pairs, _) = self.edges.ends.as_chunks::<2>();
        pairs.binary_search_by_key(&wanted, |&[low, high]| (low, high)).ok().map(EdgeId::new)
    }

    /// The edge that loose edge `i` of the input is.
    ///
    /// # Panics
    /// If there were not so many loose edges.
    pub fn loose_edge(&self, i: usize) -> EdgeId {
        EdgeId::from_u32(self.edges.corner_edges[self.polygons.item_count() + i])
    }

    /// The edges of a face in order, with plus where the face runs from the smaller to the larger end.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{FaceId, RaggedArray};
    /// use coface_complexes::surface::PolygonMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = PolygonMesh::new(4, RaggedArray::from_lists([[0, 1, 2, 3]]), &[])?;
    /// assert_eq!(square.face_edges(FaceId::new(0)).len(), 4);
    /// # Ok(()) }
    /// ```
    pub fn face_edges(&self, face: FaceId) -> impl ExactSizeIterator<Item = (EdgeId, Sign)> + '_ {
        let polygon = self.face(face);
        let edges = self.side_edges(face.index());
        edges.iter().enumerate().map(move |(i, &edge)| {
            let next = polygon[if i + 1 == polygon.len() { 0 } else { i + 1 }];
            let sign = if polygon[i] < next { Sign::Plus } else { Sign::Minus };
            (EdgeId::from_u32(edge), sign)
        })
    }

    /// The edge numbers of the sides of the face at this position, in order.
    pub(crate) fn side_edges(&self, face: usize) -> &[u32] {
        &self.edges.corner_edges[self.polygons.start(face)..self.polygons.start(face + 1)]
    }

    /// The edge of each corner of all faces, corner after corner as in [`Self::polygons`].
    pub fn corner_edges(&self) -> &[u32] {
        &self.edges.corner_edges[..self.polygons.item_count()]
    }

    /// The faces at an edge by rising id, with plus where the face runs from the smaller to the larger end.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{EdgeId, RaggedArray};
    /// use coface_complexes::surface::PolygonMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = PolygonMesh::new(4, RaggedArray::from_lists([[0, 1, 2, 3]]), &[])?;
    /// assert_eq!(square.faces_of_edge(EdgeId::new(0)).count(), 1);
    /// # Ok(()) }
    /// ```
    pub fn faces_of_edge(&self, edge: EdgeId) -> impl ExactSizeIterator<Item = (FaceId, Sign)> + '_ {
        self.packed_faces(edge.index())
            .iter()
            .map(|&packed| (FaceId::from_u32(packed >> 1), Sign::power_of_minus_one((packed & 1) as usize)))
    }

    /// The faces at the edge at this position, each as `2 * face + reversed`.
    pub(crate) fn packed_faces(&self, edge: usize) -> &[u32] {
        let starts = &self.edges.face_starts;
        &self.edges.faces[starts[edge] as usize..starts[edge + 1] as usize]
    }

    /// The number of faces at an edge.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{EdgeId, RaggedArray};
    /// use coface_complexes::surface::PolygonMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = PolygonMesh::new(4, RaggedArray::from_lists([[0, 1, 2, 3]]), &[])?;
    /// assert_eq!(square.face_count_at(EdgeId::new(0)), 1);
    /// # Ok(()) }
    /// ```
    pub fn face_count_at(&self, edge: EdgeId) -> usize {
        self.packed_faces(edge.index()).len()
    }

    /// The number of faces at each edge, in the order of the edges.
    pub(crate) fn edge_degrees(&self) -> impl ExactSizeIterator<Item = u32> + '_ {
        self.edges.face_starts.windows(2).map(|pair| pair[1] - pair[0])
    }

    /// The loose edges that the mesh was made with, as pairs.
    pub(super) fn loose_pairs(&self) -> Vec<[u32; 2]> {
        self.edges.corner_edges[self.polygons.item_count()..]
            .iter()
            .map(|&edge| self.ends(edge as usize))
            .collect()
    }

    /// The same mesh with the faces of minus sign listed the other way around.
    pub(crate) fn with_face_signs(&self, signs: &[Sign]) -> Self {
        let mut polygons = self.polygons.clone();
        for (face, _) in signs.iter().enumerate().filter(|&(_, &sign)| sign == Sign::Minus) {
            let corners = polygons.start(face)..polygons.start(face + 1);
            polygons.items_mut()[corners].reverse();
        }
        self.with_corners(self.vertex_count, polygons, &self.loose_pairs())
    }

    /// The same faces with these vertices at their corners, and these loose edges in the place of those it was made with.
    ///
    /// # Panics
    /// Unless faces that differ still differ, and none repeats a vertex.
    pub(super) fn with_corners(
        &self,
        vertex_count: usize,
        polygons: RaggedArray,
        loose_edges: &[[u32; 2]],
    ) -> Self {
        let edges = identify_edges(vertex_count, &polygons, loose_edges)
            .expect("faces that are turned around, or get vertices of their own, are as sound as before");
        assert!(edges.duplicates.is_empty(), "faces that differ still differ");
        Self {
            vertex_count,
            polygons,
            edges,
            polygon_of_face: self.polygon_of_face.clone(),
            duplicate_faces: self.duplicate_faces.clone(),
        }
    }

    /// The boundary matrix of degree 1: rows are vertices, columns edges; an edge is its larger end minus its smaller.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::PolygonMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = PolygonMesh::new(4, RaggedArray::from_lists([[0, 1, 2, 3]]), &[])?;
    /// assert_eq!(square.edge_boundaries().column(0).entries(), [-1, 1]);
    /// # Ok(()) }
    /// ```
    pub fn edge_boundaries(&self) -> SparseMatrix {
        edge_boundaries(self.vertex_count, self.edges.ends.clone())
    }

    /// The boundary matrix of degree 2: rows are edges, columns faces; an edge has the entry 1 where the face runs
    /// from its smaller to its larger end.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::PolygonMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = PolygonMesh::new(4, RaggedArray::from_lists([[0, 1, 2, 3]]), &[])?;
    /// assert_eq!(square.face_boundaries().column(0).entries(), [1, -1, 1, 1]);
    /// # Ok(()) }
    /// ```
    pub fn face_boundaries(&self) -> SparseMatrix {
        face_boundaries(self.edge_count(), &self.polygons, self.corner_edges().to_vec())
    }

    /// The chain complex of vertices, edges and faces in the order of their ids.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::TooLarge`] for boundary matrices beyond 32 bits.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::PolygonMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = PolygonMesh::new(4, RaggedArray::from_lists([[0, 1, 2, 3]]), &[])?;
    /// let complex = square.chain_complex()?;
    /// assert_eq!(complex.f_vector(), [4, 4, 1]);
    /// // The edges are 01, 03, 12, 23; the square runs 0 1 2 3, so against 03.
    /// let boundary = complex.boundary_matrix(2).expect("there is a face");
    /// assert_eq!(boundary.column(0).entries(), [1, -1, 1, 1]);
    /// # Ok(()) }
    /// ```
    pub fn chain_complex(&self) -> Result<ChainComplex, Error> {
        let (ends, corner_edges) = (self.edges.ends.clone(), self.corner_edges().to_vec());
        complex_of(
            self.vertex_count,
            boundary_matrices(self.vertex_count, &self.polygons, ends, corner_edges),
        )
    }

    /// The chain complex, made out of the arrays of the mesh; saves memory and time where the mesh is not needed
    /// any more.
    ///
    /// # Errors
    /// As [`Self::chain_complex`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::PolygonMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = PolygonMesh::new(4, RaggedArray::from_lists([[0, 1, 2, 3]]), &[])?;
    /// assert_eq!(square.into_chain_complex()?.euler_characteristic(), 1);
    /// # Ok(()) }
    /// ```
    pub fn into_chain_complex(self) -> Result<ChainComplex, Error> {
        let vertex_count = self.vertex_count;
        complex_of(vertex_count, self.into_boundary_matrices())
    }

    /// The boundary matrices of degrees 1 and 2, as far as there are edges and faces, made out of the arrays of the mesh.
    pub(crate) fn into_boundary_matrices(self) -> Vec<SparseMatrix> {
        let Self { vertex_count, polygons, edges: EdgeTable { ends, mut corner_edges, .. }, .. } = self;
        corner_edges.truncate(polygons.item_count());
        boundary_matrices(vertex_count, &polygons, ends, corner_edges)
    }
}

fn boundary_matrices(
    vertex_count: usize,
    polygons: &RaggedArray,
    ends: Vec<u32>,
    corner_edges: Vec<u32>,
) -> Vec<SparseMatrix> {
    let edge_count = ends.len() / 2;
    if edge_count == 0 {
        return Vec::new();
    }
    let mut boundaries = vec![edge_boundaries(vertex_count, ends)];
    if !polygons.is_empty() {
        boundaries.push(face_boundaries(edge_count, polygons, corner_edges));
    }
    boundaries
}

fn complex_of(vertex_count: usize, boundaries: Vec<SparseMatrix>) -> Result<ChainComplex, Error> {
    if boundaries.is_empty() {
        return Ok(ChainComplex::of_points(vertex_count));
    }
    ChainComplex::new(boundaries)
}

fn edge_boundaries(vertex_count: usize, ends: Vec<u32>) -> SparseMatrix {
    let starts = (0..=ends.len() as u32).step_by(2).collect();
    let mut entries = vec![1; ends.len()];
    entries
        .par_chunks_mut(1 << 14)
        .for_each(|block| block.iter_mut().step_by(2).for_each(|entry| *entry = -1));
    SparseMatrix::from_trusted_parts(vertex_count, starts, ends, entries)
        .expect("edges join two vertices in order")
}

/// `corner_edges` becomes the rows of the matrix: the sides of each face are sorted in place.
fn face_boundaries(edge_count: usize, polygons: &RaggedArray, corner_edges: Vec<u32>) -> SparseMatrix {
    let mut rows = corner_edges;
    let mut entries = vec![0i32; rows.len()];
    let starts: Vec<u32> = (0..=polygons.len()).map(|face| polygons.start(face) as u32).collect();
    if let Some(width) = polygons.uniform_width() {
        const BLOCK: usize = 1 << 12;
        polygons
            .items()
            .par_chunks(BLOCK * width)
            .zip(rows.par_chunks_mut(BLOCK * width))
            .zip(entries.par_chunks_mut(BLOCK * width))
            .for_each(|((vertices, rows), entries)| {
                if width == 3 {
                    let (rows, entries) = (rows.as_chunks_mut::<3>().0, entries.as_chunks_mut::<3>().0);
                    for ((triangle, rows), entries) in
                        vertices.as_chunks::<3>().0.iter().zip(rows).zip(entries)
                    {
                        sort_triangle(triangle, rows, entries);
                    }
                    return;
                }
                let mut pairs = Vec::with_capacity(width);
                for ((polygon, rows), entries) in
                    vertices.chunks(width).zip(rows.chunks_mut(width)).zip(entries.chunks_mut(width))
                {
                    sort_sides(polygon, rows, entries, &mut pairs);
                }
            });
    } else {
        let mut pairs = Vec::new();
        for (face, polygon) in polygons.iter().enumerate() {
            let sides = starts[face] as usize..starts[face + 1] as usize;
            sort_sides(polygon, &mut rows[sides.clone()], &mut entries[sides], &mut pairs);
        }
    }
    SparseMatrix::from_trusted_parts(edge_count, starts, rows, entries)
        .expect("a face has each of its edges once")
}

/// Sorts the edges of one face and writes their signs beside them.
fn sort_sides(polygon: &[u32], rows: &mut [u32], entries: &mut [i32], pairs: &mut Vec<(u32, i32)>) {
    pairs.clear();
    for (i, &edge) in rows.iter().enumerate() {
        let next = polygon[if i + 1 == polygon.len() { 0 } else { i + 1 }];
        pairs.push((edge, if polygon[i] < next { 1 } else { -1 }));
    }
    pairs.sort_unstable();
    for ((row, entry), &(edge, sign)) in rows.iter_mut().zip(entries).zip(&*pairs) {
        (*row, *entry) = (edge, sign);
    }
}

/// The same for a triangle: three comparisons.
fn sort_triangle(&[a, b, c]: &[u32; 3], rows: &mut [u32; 3], entries: &mut [i32; 3]) {
    let [ab, bc, ca] = *rows;
    let sign = |from: u32, to: u32| if from < to { 1 } else { -1 };
    let (mut first, mut second, mut third) = ((ab, sign(a, b)), (bc, sign(b, c)), (ca, sign(c, a)));
    if second.0 < first.0 {
        (first, second) = (second, first);
    }
    if third.0 < second.0 {
        (second, third) = (third, second);
    }
    if second.0 < first.0 {
        (first, second) = (second, first);
    }
    *rows = [first.0, second.0, third.0];
    *entries = [first.1, second.1, third.1];
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::collections::{BTreeMap, BTreeSet};

    fn mesh(vertex_count: usize, polygons: &[Vec<u32>]) -> PolygonMesh {
        PolygonMesh::new(vertex_count, RaggedArray::from_lists(polygons), &[]).unwrap()
    }

    fn sides(polygon: &[u32]) -> Vec<(u32, u32)> {
        (0..polygon.len()).map(|i| (polygon[i], polygon[(i + 1) % polygon.len()])).collect()
    }

    fn undirected((a, b): (u32, u32)) -> (u32, u32) {
        (a.min(b), a.max(b))
    }

    /// Polygons of 3 to 6 distinct vertices below 12, many of them equal or sharing sides.
    fn soup() -> impl Strategy<Value = (Vec<Vec<u32>>, Vec<[u32; 2]>)> {
        let polygon =
            (Just((0u32..12).collect::<Vec<_>>()).prop_shuffle(), 3usize..7).prop_map(|(mut v, n)| {
                v.truncate(n);
                v
            });
        let few = (Just((0u32..4).collect::<Vec<_>>()).prop_shuffle(), 3usize..5).prop_map(|(mut v, n)| {
            v.truncate(n);
            v
        });
        let edge = (0u32..12, 1u32..12).prop_map(|(a, d)| [a, (a + d) % 12]);
        (
            prop_oneof![prop::collection::vec(polygon, 0..30), prop::collection::vec(few, 0..12)],
            prop::collection::vec(edge, 0..6),
        )
    }

    #[test]
    fn degenerate_input_is_ordinary() {
        let empty = mesh(0, &[]);
        assert_eq!((empty.f_vector(), empty.chain_complex().unwrap().f_vector()), (vec![0; 3], &[][..]));
        let point = mesh(1, &[]);
        assert_eq!(point.chain_complex().unwrap().f_vector(), [1]);
        let arc = PolygonMesh::new(3, RaggedArray::new(), &[[2, 0], [0, 2]]).unwrap();
        assert_eq!(arc.chain_complex().unwrap().f_vector(), [3, 1]);
        assert_eq!((arc.loose_edge(0), arc.loose_edge(1)), (EdgeId::new(0), EdgeId::new(0)));
    }

    #[test]
    fn faults_name_the_first_face() {
        let fault = |polygons: &[Vec<u32>], loose: &[[u32; 2]]| {
            PolygonMesh::new(4, RaggedArray::from_lists(polygons), loose).unwrap_err().to_string()
        };
        assert!(
            fault(&[vec![0, 1, 2], vec![0, 1, 4], vec![9, 9, 9]], &[]).starts_with("face f1 names vertex v4")
        );
        assert!(fault(&[vec![0, 1, 0]], &[]).starts_with("face f0 repeats vertex v0"));
        assert!(fault(&[vec![0, 1, 2, 3, 1]], &[]).starts_with("face f0 repeats vertex v1"));
        assert!(fault(&[vec![0, 1]], &[]).starts_with("face f0 has 2 vertices"));
        assert!(fault(&[], &[[1, 1]]).starts_with("loose edge 0 joins v1 to itself"));
        assert!(fault(&[], &[[0, 1], [1, 7]]).starts_with("loose edge 1 names vertex v7"));
    }

    #[test]
    fn equal_cycles_are_one_face_whatever_their_start_and_direction() {
        let polygons =
            [vec![3, 1, 0, 2], vec![0, 1, 3, 2], vec![0, 1, 2, 3], vec![2, 3, 1, 0], vec![1, 0, 2, 3]];
        let mesh = mesh(4, &polygons);
        assert_eq!(mesh.face_count(), 2);
        let f0 = FaceId::new(0);
        assert_eq!(mesh.duplicate_faces(), [(f0, 1), (f0, 3), (f0, 4)]);
        assert_eq!(mesh.polygon_of_face(FaceId::new(1)), 2);
    }

    #[test]
    fn many_ranges_and_chunks_agree_with_few() {
        // A closed strip of quadrangles over 100000 vertices in a scattered order: several ranges and chunks.
        let n = 50_000u32;
        let scatter = |i: u32| (u64::from(i) * 48_271 % 100_003 % 100_000) as u32;
        let mut seen = vec![false; 100_000];
        let names: Vec<u32> =
            (0..100_003).map(scatter).filter(|&v| !std::mem::replace(&mut seen[v as usize], true)).collect();
        assert_eq!(names.len(), 100_000);
        let quadrangles: Vec<u32> = (0..n)
            .flat_map(|i| {
                let j = (i + 1) % n;
                [2 * i, 2 * j, 2 * j + 1, 2 * i + 1].map(|v| names[v as usize])
            })
            .collect();
        let mesh = PolygonMesh::new(100_000, RaggedArray::uniform(4, quadrangles).unwrap(), &[]).unwrap();
        assert_eq!(mesh.f_vector(), [100_000, 150_000, 50_000]);
        assert!(mesh.edge_ends().as_chunks::<2>().0.is_sorted_by(|a, b| a < b));
        let rungs = (0..mesh.edge_count()).filter(|&e| mesh.packed_faces(e).len() == 2).count();
        assert_eq!(rungs, 50_000);
        for face in (0..mesh.face_count()).step_by(997) {
            for ((a, b), (edge, _)) in
                sides(mesh.polygons().list(face)).into_iter().zip(mesh.face_edges(FaceId::new(face)))
            {
                let [a, b] = [a, b].map(VertexId::from_u32);
                assert_eq!(mesh.edge_between(a, b), Some(edge));
            }
        }
    }

    proptest! {
        #[test]
        fn edges_and_faces_agree_with_sets((polygons, loose) in soup()) {
            let mesh = PolygonMesh::new(12, RaggedArray::from_lists(&polygons), &loose).unwrap();
            let all: BTreeSet<(u32, u32)> = polygons
                .iter()
                .flat_map(|p| sides(p))
                .chain(loose.iter().map(|&[a, b]| (a, b)))
                .map(undirected)
                .collect();
            let listed: Vec<(u32, u32)> = mesh.edge_ends().as_chunks::<2>().0.iter().map(|&[a, b]| (a, b)).collect();
            prop_assert_eq!(&listed, &all.into_iter().collect::<Vec<_>>());

            // Equal faces by their sets of sides.
            let mut first: BTreeMap<BTreeSet<(u32, u32)>, usize> = BTreeMap::new();
            let mut kept = Vec::new();
            let mut dropped = Vec::new();
            for (i, polygon) in polygons.iter().enumerate() {
                let key: BTreeSet<_> = sides(polygon).into_iter().map(undirected).collect();
                if let Some(&face) = first.get(&key) {
                    dropped.push((FaceId::new(face), i));
                } else {
                    first.insert(key, kept.len());
                    kept.push(i);
                }
            }
            prop_assert_eq!(mesh.duplicate_faces(), dropped);
            prop_assert_eq!(mesh.face_count(), kept.len());
            for (face, &polygon) in kept.iter().enumerate() {
                prop_assert_eq!(mesh.polygon_of_face(FaceId::new(face)), polygon);
                prop_assert_eq!(mesh.face(FaceId::new(face)), &polygons[polygon][..]);
            }

            // Incidences in both directions, with signs.
            let mut at_edge = vec![Vec::new(); mesh.edge_count()];
            for face in (0..mesh.face_count()).map(FaceId::new) {
                for ((edge, sign), (a, b)) in mesh.face_edges(face).zip(sides(mesh.face(face))) {
                    prop_assert_eq!(mesh.edge(edge).map(|v| v.to_u32()), [a.min(b), a.max(b)]);
                    prop_assert_eq!(sign == Sign::Plus, a < b);
                    at_edge[edge.index()].push((face, sign));
                }
            }
            for (edge, faces) in at_edge.iter().enumerate() {
                prop_assert_eq!(&mesh.faces_of_edge(EdgeId::new(edge)).collect::<Vec<_>>(), faces);
            }

            // The matrices say the same; the chain complex checks that the product is zero.
            let complex = mesh.chain_complex().unwrap();
            prop_assert_eq!(complex.euler_characteristic(), mesh.euler_characteristic());
            let matrix = mesh.face_boundaries();
            for face in (0..mesh.face_count()).map(FaceId::new) {
                for (edge, sign) in mesh.face_edges(face) {
                    prop_assert_eq!(matrix.entry(edge.index(), face.index()), sign.to_i32());
                }
                prop_assert_eq!(matrix.column(face.index()).rows().len(), mesh.face(face).len());
            }
            prop_assert_eq!(mesh.into_chain_complex().unwrap(), complex);
        }
    }
}
