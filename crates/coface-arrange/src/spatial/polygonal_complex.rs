//! Polygons, edges and vertices in space that meet only in common edges and vertices.

use coface_algebra::chains::ChainComplex;
use coface_algebra::{EdgeId, Error, ErrorKind, FaceId};
use coface_algebra::{RaggedArray, Sign, SparseMatrix};
use coface_geometry::Positions;

/// The bit of a side that runs against its edge.
const AGAINST: u32 = 1;

/// A complex of vertices, straight edges and flat faces, by incidence alone.
///
/// A face is the set of its **sides**: directed edges that close up to walks, with the face to the left of each. The
/// outer walk of a face runs counterclockwise seen from its **front**, holes run clockwise. An edge that lies inside a
/// face with its face on both sides (a slit, as where the edge of another face ends on this one) is two sides of it,
/// one in each direction. Edges without faces and vertices without edges are welcome.
///
/// # Examples
/// A square with a square hole, and a loose edge:
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_arrange::spatial::PolygonalComplex;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let walks = RaggedArray::from_lists([[0, 1, 2, 3], [4, 7, 6, 5]]);
/// let complex = PolygonalComplex::from_walks(9, &walks, &[0, 0], &[[3, 8]])?;
/// assert_eq!(complex.f_vector(), [9, 9, 1]);
/// assert_eq!(complex.face_boundaries()?.column(0).entries().len(), 8);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PolygonalComplex {
    vertex_count: usize,
    edges: Vec<[u32; 2]>,
    /// The sides of each face as `2 * edge + against`.
    sides: RaggedArray,
}

impl PolygonalComplex {
    /// The complex with these edges, each from its first to its second end, and faces, each a list of sides.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] naming the first edge with an end that does not exist, with equal ends or with the
    /// ends of an earlier edge, and the first face with an edge that does not exist, a side that stands twice, no side,
    /// or sides that do not close up.
    ///
    /// # Complexity
    /// $O(n \log n)$ for n sides.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{EdgeId, Sign};
    /// use coface_arrange::spatial::PolygonalComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let sides = [(0, Sign::Plus), (1, Sign::Plus), (2, Sign::Minus)].map(|(e, sign)| (EdgeId::new(e), sign));
    /// let triangle = PolygonalComplex::new(3, vec![[0, 1], [1, 2], [0, 2]], &[sides.to_vec()])?;
    /// assert_eq!(triangle.f_vector(), [3, 3, 1]);
    /// # Ok(()) }
    /// ```
    pub fn new(
        vertex_count: usize,
        edges: Vec<[u32; 2]>,
        faces: &[Vec<(EdgeId, Sign)>],
    ) -> Result<Self, Error> {
        let edge_count = edges.len();
        if edge_count >= 1 << 30 || faces.len() >= 1 << 30 {
            return Err(Error::new(ErrorKind::TooLarge, "2^30 or more edges or faces"));
        }
        let mut sides = RaggedArray::new();
        let mut list = Vec::new();
        for (face, own) in faces.iter().enumerate() {
            list.clear();
            for &(edge, sign) in own {
                if edge.index() >= edge_count {
                    return Err(Error::invalid(format!(
                        "face f{face} has the edge {edge}, but there are {edge_count} edges"
                    )));
                }
                list.push(edge.to_u32() << 1 | u32::from(sign == Sign::Minus));
            }
            sides.push(&list);
        }
        Self::of_sides(vertex_count, edges, sides)
    }

    /// The complex whose faces have these walks around them, cycles of vertices: walk i belongs to face
    /// `face_of_walk[i]`.
    ///
    /// Edges are numbered in the lexicographic order of their pairs (smaller vertex, larger vertex) and point from the
    /// smaller to the larger; `loose_edges` are further edges, which may also be sides of faces.
    ///
    /// # Errors
    /// As [`Self::new`]; [`ErrorKind::Shape`] unless there is a face for each walk and a walk for each face.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::PolygonalComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A triangle with a triangular hole, and an edge between them.
    /// let walks = RaggedArray::from_lists([[0, 1, 2], [3, 5, 4]]);
    /// let holed = PolygonalComplex::from_walks(6, &walks, &[0, 0], &[[0, 3]])?;
    /// assert_eq!(holed.f_vector(), [6, 7, 1]);
    /// # Ok(()) }
    /// ```
    pub fn from_walks(
        vertex_count: usize,
        walks: &RaggedArray,
        face_of_walk: &[u32],
        loose_edges: &[[u32; 2]],
    ) -> Result<Self, Error> {
        if face_of_walk.len() != walks.len() {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("{} walks beside the faces of {}", walks.len(), face_of_walk.len()),
            ));
        }
        let face_count = face_of_walk.iter().max().map_or(0, |&last| last as usize + 1);
        if face_count > walks.len() {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("{face_count} faces have {} walks", walks.len()),
            )
            .with_cure("number the faces without gaps"));
        }
        let sides_of = |walk: usize| {
            let list = walks.list(walk);
            list.iter().enumerate().map(move |(i, &from)| [from, list[(i + 1) % list.len()]])
        };
        let mut edges: Vec<[u32; 2]> = (0..walks.len())
            .flat_map(sides_of)
            .chain(loose_edges.iter().copied())
            .map(|[a, b]| [a.min(b), a.max(b)])
            .collect();
        edges.sort_unstable();
        edges.dedup();
        let by_face = RaggedArray::grouped(face_count, face_of_walk.iter().copied());
        let mut sides = RaggedArray::new();
        let mut list = Vec::new();
        for own in by_face.iter() {
            list.clear();
            for [a, b] in own.iter().flat_map(|&walk| sides_of(walk as usize)) {
                let edge = edges.binary_search(&[a.min(b), a.max(b)]).expect("sides of walks are edges");
                list.push((edge as u32) << 1 | u32::from(a > b));
            }
            sides.push(&list);
        }
        Self::of_sides(vertex_count, edges, sides)
    }

    /// The complex whose faces are these polygons without holes, cycles of vertices.
    ///
    /// # Errors
    /// As [`Self::from_walks`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::PolygonalComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = PolygonalComplex::from_polygons(3, &RaggedArray::from_lists([[0, 1, 2]]))?;
    /// assert_eq!(triangle.f_vector(), [3, 3, 1]);
    /// # Ok(()) }
    /// ```
    pub fn from_polygons(vertex_count: usize, polygons: &RaggedArray) -> Result<Self, Error> {
        let faces: Vec<u32> = (0..polygons.len() as u32).collect();
        Self::from_walks(vertex_count, polygons, &faces, &[])
    }

    /// The complex with these boundary matrices, of edges (rows are vertices) and of faces (rows are edges).
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] for an edge that is not a vertex minus a vertex, a coefficient of a face that is not 1 or
    /// -1 (an edge with a face on both sides has the coefficient 0 and needs [`Self::new`]), or shapes that do not fit
    /// together; else as [`Self::new`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::PolygonalComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = PolygonalComplex::from_polygons(3, &RaggedArray::from_lists([[0, 1, 2]]))?;
    /// let (edges, faces) = (triangle.edge_boundaries()?, triangle.face_boundaries()?);
    /// assert_eq!(PolygonalComplex::from_boundary_matrices(&edges, &faces)?.edges(), triangle.edges());
    /// # Ok(()) }
    /// ```
    pub fn from_boundary_matrices(edges: &SparseMatrix, faces: &SparseMatrix) -> Result<Self, Error> {
        if faces.row_count() != edges.column_count() {
            return Err(Error::new(
                ErrorKind::Shape,
                format!(
                    "the boundaries of faces have {} rows, but there are {} edges",
                    faces.row_count(),
                    edges.column_count()
                ),
            ));
        }
        let mut ends = Vec::with_capacity(edges.column_count());
        for (edge, column) in edges.columns().enumerate() {
            ends.push(match (column.rows(), column.entries()) {
                (&[a, b], [-1, 1]) => [a, b],
                (&[a, b], [1, -1]) => [b, a],
                _ => {
                    return Err(Error::new(
                        ErrorKind::Shape,
                        format!("the boundary of edge e{edge} is not a vertex minus a vertex"),
                    ));
                }
            });
        }
        let mut sides = RaggedArray::new();
        let mut list = Vec::new();
        for (face, column) in faces.columns().enumerate() {
            list.clear();
            for (edge, entry) in column.iter() {
                if entry.abs() != 1 {
                    return Err(Error::new(
                        ErrorKind::Shape,
                        format!(
                            "face f{face} has the coefficient {entry} on edge e{edge}; only 1 and -1 are sides"
                        ),
                    ));
                }
                list.push((edge as u32) << 1 | u32::from(entry < 0));
            }
            sides.push(&list);
        }
        Self::of_sides(edges.row_count(), ends, sides)
    }

    /// The complex with these edges and packed sides of faces, which are known to be in order.
    pub(super) fn from_trusted_parts(vertex_count: usize, edges: Vec<[u32; 2]>, sides: RaggedArray) -> Self {
        let complex = Self { vertex_count, edges, sides };
        debug_assert!(complex.check_edges().is_ok() && complex.check_faces().is_ok());
        complex
    }

    fn of_sides(vertex_count: usize, edges: Vec<[u32; 2]>, sides: RaggedArray) -> Result<Self, Error> {
        if vertex_count >= 1 << 31 || edges.len() >= 1 << 30 || sides.len() >= 1 << 30 {
            return Err(Error::new(
                ErrorKind::TooLarge,
                "2^31 or more vertices, or 2^30 or more edges or faces",
            ));
        }
        let complex = Self { vertex_count, edges, sides };
        complex.check_edges()?;
        complex.check_faces()?;
        Ok(complex)
    }

    fn check_edges(&self) -> Result<(), Error> {
        for (edge, &[a, b]) in self.edges.iter().enumerate() {
            if let Some(end) = [a, b].into_iter().find(|&end| end as usize >= self.vertex_count) {
                return Err(Error::invalid(format!(
                    "edge e{edge} ends at v{end}, but there are {} vertices",
                    self.vertex_count
                )));
            }
            if a == b {
                return Err(Error::invalid(format!("edge e{edge} begins and ends at v{a}"))
                    .with_cure("remove it, or the repeated vertex of the polygon"));
            }
        }
        let mut order: Vec<([u32; 2], u32)> =
            (0..).zip(&self.edges).map(|(edge, &[a, b])| ([a.min(b), a.max(b)], edge)).collect();
        order.sort_unstable();
        let twice = order.windows(2).filter(|pair| pair[0].0 == pair[1].0).min_by_key(|pair| pair[1].1);
        match twice {
            None => Ok(()),
            Some(pair) => Err(Error::invalid(format!(
                "edges e{} and e{} both join v{} and v{}",
                pair[0].1, pair[1].1, pair[0].0[0], pair[0].0[1]
            ))
            .with_cure("give the edge once")),
        }
    }

    fn check_faces(&self) -> Result<(), Error> {
        let (mut own, mut ends) = (Vec::new(), Vec::new());
        for (face, sides) in self.sides.iter().enumerate() {
            own.clear();
            own.extend_from_slice(sides);
            own.sort_unstable();
            if sides.is_empty() {
                return Err(Error::invalid(format!("face f{face} has no side")));
            }
            if let Some(pair) = own.windows(2).find(|pair| pair[0] == pair[1]) {
                return Err(Error::invalid(format!(
                    "face f{face} runs through edge e{} twice in one direction",
                    pair[0] >> 1
                )));
            }
            // Each vertex is left as often as it is reached.
            ends.clear();
            for &side in sides {
                let [from, to] = self.side_ends(side);
                ends.extend([(from, -1), (to, 1)]);
            }
            ends.sort_unstable();
            let open =
                ends.chunk_by(|x, y| x.0 == y.0).find(|at| at.iter().map(|end| end.1).sum::<i32>() != 0);
            if let Some(at) = open {
                return Err(Error::invalid(format!(
                    "the sides of face f{face} do not close up at v{}",
                    at[0].0
                ))
                .with_cure("list all sides of the face, in the directions of its walks"));
            }
        }
        Ok(())
    }

    /// The number of vertices, isolated ones included.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::PolygonalComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = PolygonalComplex::from_polygons(3, &RaggedArray::from_lists([[0, 1, 2]]))?;
    /// assert_eq!(triangle.vertex_count(), 3);
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
    /// use coface_arrange::spatial::PolygonalComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = PolygonalComplex::from_polygons(3, &RaggedArray::from_lists([[0, 1, 2]]))?;
    /// assert_eq!(triangle.edge_count(), 3);
    /// # Ok(()) }
    /// ```
    pub fn edge_count(&self) -> usize {
        self.edges.len()
    }

    /// The number of faces.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::PolygonalComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = PolygonalComplex::from_polygons(3, &RaggedArray::from_lists([[0, 1, 2]]))?;
    /// assert_eq!(triangle.face_count(), 1);
    /// # Ok(()) }
    /// ```
    pub fn face_count(&self) -> usize {
        self.sides.len()
    }

    /// The numbers of vertices, edges and faces.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::PolygonalComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = PolygonalComplex::from_polygons(3, &RaggedArray::from_lists([[0, 1, 2]]))?;
    /// assert_eq!(triangle.f_vector(), [3, 3, 1]);
    /// # Ok(()) }
    /// ```
    pub fn f_vector(&self) -> Vec<usize> {
        vec![self.vertex_count, self.edge_count(), self.face_count()]
    }

    /// The ends of each edge: where it begins and where it ends.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::PolygonalComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = PolygonalComplex::from_polygons(3, &RaggedArray::from_lists([[0, 1, 2]]))?;
    /// assert_eq!(triangle.edges(), [[0, 1], [0, 2], [1, 2]]);
    /// # Ok(()) }
    /// ```
    pub fn edges(&self) -> &[[u32; 2]] {
        &self.edges
    }

    /// The sides of a face: its edges, with minus where the side runs against the edge.
    ///
    /// # Panics
    /// If there is no such face.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{EdgeId, FaceId, RaggedArray, Sign};
    /// use coface_arrange::spatial::PolygonalComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = PolygonalComplex::from_polygons(3, &RaggedArray::from_lists([[0, 1, 2]]))?;
    /// // From vertex 2 back to 0 the side runs against its edge.
    /// assert!(triangle.sides(FaceId::new(0)).any(|side| side == (EdgeId::new(1), Sign::Minus)));
    /// # Ok(()) }
    /// ```
    pub fn sides(&self, face: FaceId) -> impl ExactSizeIterator<Item = (EdgeId, Sign)> + '_ {
        self.sides.list(face.index()).iter().map(|&side| (EdgeId::from_u32(side >> 1), sign_of(side)))
    }

    /// The boundary matrix of the edges: rows are vertices, columns edges.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] beyond 2^32 - 1 entries.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::PolygonalComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = PolygonalComplex::from_polygons(3, &RaggedArray::from_lists([[0, 1, 2]]))?;
    /// assert_eq!(triangle.edge_boundaries()?.column(0).entries(), [-1, 1]);
    /// # Ok(()) }
    /// ```
    pub fn edge_boundaries(&self) -> Result<SparseMatrix, Error> {
        let starts = (0..=self.edges.len() as u32).map(|edge| 2 * edge).collect();
        let count = 2 * self.edges.len();
        let (mut rows, mut entries) = (Vec::with_capacity(count), Vec::with_capacity(count));
        for &[from, to] in &self.edges {
            rows.extend([from.min(to), from.max(to)]);
            entries.extend(if from < to { [-1, 1] } else { [1, -1] });
        }
        SparseMatrix::from_trusted_parts(self.vertex_count, starts, rows, entries)
    }

    /// The boundary matrix of the faces: rows are edges, columns faces. An edge with the face on both sides has the
    /// entry 0.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] beyond 2^32 - 1 entries.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::PolygonalComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = PolygonalComplex::from_polygons(3, &RaggedArray::from_lists([[0, 1, 2]]))?;
    /// assert_eq!(triangle.face_boundaries()?.column(0).entries(), [1, -1, 1]);
    /// # Ok(()) }
    /// ```
    pub fn face_boundaries(&self) -> Result<SparseMatrix, Error> {
        let count = self.sides.item_count();
        let (mut rows, mut entries) = (Vec::with_capacity(count), Vec::with_capacity(count));
        let mut starts = Vec::with_capacity(self.sides.len() + 1);
        starts.push(0u32);
        let mut own = Vec::new();
        for sides in self.sides.iter() {
            own.clear();
            own.extend_from_slice(sides);
            own.sort_unstable();
            for pair in own.chunk_by(|x, y| x >> 1 == y >> 1).filter(|pair| pair.len() == 1) {
                rows.push(pair[0] >> 1);
                entries.push(sign_of(pair[0]).to_i32());
            }
            starts.push(rows.len() as u32);
        }
        SparseMatrix::from_trusted_parts(self.edges.len(), starts, rows, entries)
    }

    /// The chain complex of vertices, edges and faces.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] beyond 2^32 - 1 entries in a matrix.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::PolygonalComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = PolygonalComplex::from_polygons(3, &RaggedArray::from_lists([[0, 1, 2]]))?;
    /// assert_eq!(triangle.chain_complex()?.f_vector(), [3, 3, 1]);
    /// # Ok(()) }
    /// ```
    pub fn chain_complex(&self) -> Result<ChainComplex, Error> {
        Ok(ChainComplex::from_trusted_boundaries(vec![self.edge_boundaries()?, self.face_boundaries()?]))
    }

    /// `Shape` unless the positions are points in space, one for each vertex at least.
    pub(super) fn check_positions(&self, positions: &Positions) -> Result<(), Error> {
        if positions.dimension() == 3 && positions.len() >= self.vertex_count {
            return Ok(());
        }
        Err(Error::new(
            ErrorKind::Shape,
            format!(
                "{} points with {} coordinates for {} vertices in space",
                positions.len(),
                positions.dimension(),
                self.vertex_count
            ),
        )
        .with_cure("give three coordinates for each vertex"))
    }

    /// The sides of all faces as `2 * edge + against`.
    pub(super) fn packed_sides(&self) -> &RaggedArray {
        &self.sides
    }

    /// Where a packed side begins and ends.
    pub(super) fn side_ends(&self, side: u32) -> [u32; 2] {
        let [from, to] = self.edges[(side >> 1) as usize];
        if side & AGAINST == 0 { [from, to] } else { [to, from] }
    }
}

/// The sign of a packed side against its edge.
pub(super) fn sign_of(side: u32) -> Sign {
    Sign::power_of_minus_one((side & AGAINST) as usize)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faults_are_named() {
        let message = |result: Result<PolygonalComplex, Error>| result.unwrap_err().message().to_owned();
        let triangle = |list: [u32; 3]| RaggedArray::from_lists([list]);
        assert_eq!(
            message(PolygonalComplex::from_polygons(2, &triangle([0, 1, 2]))),
            "edge e1 ends at v2, but there are 2 vertices"
        );
        assert_eq!(
            message(PolygonalComplex::from_polygons(2, &triangle([0, 1, 1]))),
            "edge e1 begins and ends at v1"
        );
        let open = vec![(EdgeId::new(0), Sign::Plus), (EdgeId::new(1), Sign::Plus)];
        assert_eq!(
            message(PolygonalComplex::new(3, vec![[0, 1], [1, 2]], &[open])),
            "the sides of face f0 do not close up at v0"
        );
        assert_eq!(
            message(PolygonalComplex::new(2, vec![[0, 1], [1, 0]], &[])),
            "edges e0 and e1 both join v0 and v1"
        );
        assert!(PolygonalComplex::from_walks(3, &triangle([0, 1, 2]), &[1], &[]).is_err());
        assert!(PolygonalComplex::from_polygons(0, &RaggedArray::from_lists([vec![]])).is_err());
    }

    #[test]
    fn a_slit_is_twice_a_side_and_not_in_the_boundary() {
        // A square with an edge from a corner to its middle.
        let walks = RaggedArray::from_lists([[0, 1, 2, 3, 0, 4]]);
        let complex = PolygonalComplex::from_walks(5, &walks, &[0], &[]).unwrap();
        assert_eq!(complex.f_vector(), [5, 5, 1]);
        assert_eq!(complex.sides(FaceId::new(0)).len(), 6);
        assert_eq!(complex.face_boundaries().unwrap().entry_count(), 4);
        assert_eq!(complex.chain_complex().unwrap().euler_characteristic(), 1);
    }

    #[test]
    fn matrices_give_the_complex_back() {
        let polygons = RaggedArray::from_lists([[0, 1, 2], [1, 3, 2]]);
        let complex = PolygonalComplex::from_polygons(4, &polygons).unwrap();
        let (edges, faces) = (complex.edge_boundaries().unwrap(), complex.face_boundaries().unwrap());
        let back = PolygonalComplex::from_boundary_matrices(&edges, &faces).unwrap();
        assert_eq!((back.edge_boundaries().unwrap(), back.face_boundaries().unwrap()), (edges, faces));
    }
}
