//! The 2-skeleton: vertices, edges, and faces with the closed paths that bound them.

use crate::Sign;
use crate::chains::ChainComplex;
use crate::matrices::{RaggedArray, SparseMatrix};
use crate::{EdgeId, Error, ErrorKind, FaceId, Fault, VertexId};

/// The part of a cell complex that determines its loops: vertices, edges with their ends, and faces with the closed
/// edge paths of their boundaries. A [`ChainComplex`] forgets the order of the edges around a face; this does not.
///
/// Any two-dimensional cell complex is allowed: loops, faces that touch themselves, faces whose boundary is one point.
/// The boundaries of 3-cells may be stored too: they do not change the fundamental group, but show which faces are
/// redundant.
///
/// # Conventions
/// A step along edge e is stored as the number 2e, a step against it as 2e + 1. Edge e goes from `ends[2e]` to
/// `ends[2e + 1]`.
///
/// # Examples
/// The projective plane as one vertex, one loop, and a disk that runs twice along it:
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_algebra::chains::TwoSkeleton;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let plane = TwoSkeleton::new(1, vec![0, 0], RaggedArray::from_lists([[0, 0]]))?;
/// assert_eq!(plane.f_vector(), [1, 1, 1]);
/// assert_eq!(plane.chain_complex()?.boundary_matrix(2).expect("there is a face").entry(0, 0), 2);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TwoSkeleton {
    vertex_count: usize,
    ends: Vec<u32>,
    faces: RaggedArray,
    /// The faces with an empty rim and the vertex each is at, by rising face.
    points: Vec<(FaceId, VertexId)>,
    solids: RaggedArray,
}

/// The edge and direction of a stored step.
fn step(packed: u32) -> (EdgeId, Sign) {
    (EdgeId::from_u32(packed >> 1), Sign::power_of_minus_one((packed & 1) as usize))
}

impl TwoSkeleton {
    /// The complex with these edges and faces on the vertices `0..vertex_count`. List i of `faces` has the steps around
    /// face i. A face with an empty rim is attached at vertex 0; see [`Self::with_points`].
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] naming the first edge with an end that does not exist and the first face whose steps
    /// are no closed path; [`ErrorKind::Shape`] for an odd number of ends; [`ErrorKind::TooLarge`] from 2^31 edges on.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # Examples
    /// A square of four vertices and four edges:
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::TwoSkeleton;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let rim = RaggedArray::from_lists([[0, 2, 4, 6]]);
    /// let square = TwoSkeleton::new(4, vec![0, 1, 1, 2, 2, 3, 3, 0], rim)?;
    /// assert_eq!(square.f_vector(), [4, 4, 1]);
    /// # Ok(()) }
    /// ```
    pub fn new(vertex_count: usize, ends: Vec<u32>, faces: RaggedArray) -> Result<Self, Error> {
        if !ends.len().is_multiple_of(2) {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("{} ends of edges cannot be paired", ends.len()),
            )
            .with_cure("give each edge a source and a target"));
        }
        if u32::try_from(ends.len()).is_err() || u32::try_from(vertex_count).is_err() {
            return Err(Error::new(
                ErrorKind::TooLarge,
                "a 2-skeleton has fewer than 2^31 edges and 2^32 vertices",
            ));
        }
        if let Some(at) = ends.iter().position(|&end| end as usize >= vertex_count) {
            return Err(Error::invalid(format!(
                "edge {} ends at vertex {}, but there are {vertex_count} vertices",
                EdgeId::new(at / 2),
                ends[at]
            ))
            .with_fault(Fault::OutOfRange { index: ends[at] as usize, count: vertex_count }));
        }
        let mut points = Vec::new();
        for (face, rim) in faces.iter().enumerate() {
            check_rim(face, rim, &ends)?;
            if rim.is_empty() {
                points.push((FaceId::new(face), VertexId::new(0)));
            }
        }
        if let (Some((face, _)), 0) = (points.first(), vertex_count) {
            return Err(Error::invalid(format!("face {face} has no vertex to be attached at")));
        }
        Ok(Self { vertex_count, ends, faces, points, solids: RaggedArray::new() })
    }

    /// The same complex with its faces of empty rim at these vertices, in the order of the faces.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless there are as many vertices as such faces; [`ErrorKind::InvalidInput`] naming a
    /// vertex that does not exist.
    ///
    /// # Examples
    /// Two points, and a sphere at the second of them:
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::TwoSkeleton;
    /// use coface_algebra::{FaceId, VertexId};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mut faces = RaggedArray::new();
    /// faces.push(&[]);
    /// let spheres = TwoSkeleton::new(2, vec![], faces)?.with_points(&[VertexId::new(1)])?;
    /// assert_eq!(spheres.start(FaceId::new(0)), VertexId::new(1));
    /// # Ok(()) }
    /// ```
    pub fn with_points(mut self, vertices: &[VertexId]) -> Result<Self, Error> {
        if vertices.len() != self.points.len() {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("{} vertices for {} faces with an empty rim", vertices.len(), self.points.len()),
            )
            .with_fault(Fault::Length { found: vertices.len(), expected: self.points.len() }));
        }
        for ((face, at), &vertex) in self.points.iter_mut().zip(vertices) {
            if vertex.index() >= self.vertex_count {
                return Err(Error::invalid(format!(
                    "face {face} is attached at {vertex}, but there are {} vertices",
                    self.vertex_count
                ))
                .with_fault(Fault::OutOfRange { index: vertex.index(), count: self.vertex_count }));
            }
            *at = vertex;
        }
        Ok(self)
    }

    /// The same complex with the faces around its 3-cells: list i names the faces that the boundary sphere of 3-cell i
    /// is made of, each as often as the sphere runs over it.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] naming a face that does not exist.
    ///
    /// # Examples
    /// A ball: its boundary sphere is made of two disks on one loop.
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::TwoSkeleton;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let sphere = TwoSkeleton::new(1, vec![0, 0], RaggedArray::from_lists([[0], [1]]))?;
    /// let ball = sphere.with_solids(RaggedArray::from_lists([[0, 1]]))?;
    /// assert_eq!(ball.solids().len(), 1);
    /// # Ok(()) }
    /// ```
    pub fn with_solids(mut self, solids: RaggedArray) -> Result<Self, Error> {
        if let Some(&face) = solids.items().iter().find(|&&face| face as usize >= self.faces.len()) {
            return Err(Error::invalid(format!(
                "a 3-cell has the face {}, but there are {} faces",
                FaceId::from_u32(face),
                self.faces.len()
            ))
            .with_fault(Fault::OutOfRange { index: face as usize, count: self.faces.len() }));
        }
        self.solids = solids;
        Ok(self)
    }

    /// The number of vertices.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::TwoSkeleton;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(TwoSkeleton::new(2, vec![0, 1], RaggedArray::new())?.vertex_count(), 2);
    /// # Ok(()) }
    /// ```
    pub fn vertex_count(&self) -> usize {
        self.vertex_count
    }

    /// The number of edges.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::TwoSkeleton;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(TwoSkeleton::new(2, vec![0, 1], RaggedArray::new())?.edge_count(), 1);
    /// # Ok(()) }
    /// ```
    pub fn edge_count(&self) -> usize {
        self.ends.len() / 2
    }

    /// The number of faces.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::TwoSkeleton;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(TwoSkeleton::new(1, vec![0, 0], RaggedArray::from_lists([[0, 0]]))?.face_count(), 1);
    /// # Ok(()) }
    /// ```
    pub fn face_count(&self) -> usize {
        self.faces.len()
    }

    /// The numbers of vertices, edges and faces.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::TwoSkeleton;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(TwoSkeleton::new(2, vec![0, 1], RaggedArray::new())?.f_vector(), [2, 1, 0]);
    /// # Ok(()) }
    /// ```
    pub fn f_vector(&self) -> Vec<usize> {
        vec![self.vertex_count(), self.edge_count(), self.face_count()]
    }

    /// The source and the target of an edge.
    ///
    /// # Panics
    /// If there is no such edge.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::TwoSkeleton;
    /// use coface_algebra::{EdgeId, RaggedArray, VertexId};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let arrow = TwoSkeleton::new(2, vec![1, 0], RaggedArray::new())?;
    /// assert_eq!(arrow.edge(EdgeId::new(0)), [VertexId::new(1), VertexId::new(0)]);
    /// # Ok(()) }
    /// ```
    pub fn edge(&self, edge: EdgeId) -> [VertexId; 2] {
        let at = 2 * edge.index();
        [VertexId::from_u32(self.ends[at]), VertexId::from_u32(self.ends[at + 1])]
    }

    /// The sources and targets of all edges, two by two.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::TwoSkeleton;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(TwoSkeleton::new(3, vec![0, 1, 1, 2], RaggedArray::new())?.edge_ends(), [0, 1, 1, 2]);
    /// # Ok(()) }
    /// ```
    pub fn edge_ends(&self) -> &[u32] {
        &self.ends
    }

    /// The steps around a face.
    ///
    /// # Panics
    /// If there is no such face.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::TwoSkeleton;
    /// use coface_algebra::{EdgeId, FaceId, RaggedArray, Sign};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let disk = TwoSkeleton::new(1, vec![0, 0], RaggedArray::from_lists([[0, 1]]))?;
    /// let loop_edge = EdgeId::new(0);
    /// assert!(disk.face(FaceId::new(0)).eq([(loop_edge, Sign::Plus), (loop_edge, Sign::Minus)]));
    /// # Ok(()) }
    /// ```
    pub fn face(
        &self,
        face: FaceId,
    ) -> impl DoubleEndedIterator<Item = (EdgeId, Sign)> + ExactSizeIterator + '_ {
        self.faces.list(face.index()).iter().map(|&packed| step(packed))
    }

    /// The steps around all faces as numbers: 2e along edge e, 2e + 1 against it.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::TwoSkeleton;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = TwoSkeleton::new(3, vec![0, 1, 1, 2, 2, 0], RaggedArray::from_lists([[0, 2, 4]]))?;
    /// assert_eq!(triangle.faces().list(0), [0, 2, 4]);
    /// # Ok(()) }
    /// ```
    pub fn faces(&self) -> &RaggedArray {
        &self.faces
    }

    /// The vertex where the rim of a face starts and ends.
    ///
    /// # Panics
    /// If there is no such face.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::TwoSkeleton;
    /// use coface_algebra::{FaceId, RaggedArray, VertexId};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = TwoSkeleton::new(3, vec![0, 1, 1, 2, 2, 0], RaggedArray::from_lists([[2, 4, 0]]))?;
    /// assert_eq!(triangle.start(FaceId::new(0)), VertexId::new(1));
    /// # Ok(()) }
    /// ```
    pub fn start(&self, face: FaceId) -> VertexId {
        match self.faces.list(face.index()).first() {
            Some(&packed) => VertexId::from_u32(self.ends[packed as usize]),
            None => {
                let at = self.points.binary_search_by_key(&face, |&(face, _)| face);
                self.points[at.expect("a face with an empty rim has a vertex")].1
            }
        }
    }

    /// The faces around each 3-cell, as far as they are known; empty without 3-cells.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::TwoSkeleton;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert!(TwoSkeleton::new(2, vec![0, 1], RaggedArray::new())?.solids().is_empty());
    /// # Ok(()) }
    /// ```
    pub fn solids(&self) -> &RaggedArray {
        &self.solids
    }

    /// The chain complex of the vertices, edges and faces.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] for boundary matrices beyond 32 bits.
    ///
    /// # Examples
    /// A disk that runs along a loop and back: its boundary is zero.
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::TwoSkeleton;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let complex = TwoSkeleton::new(1, vec![0, 0], RaggedArray::from_lists([[0, 1]]))?.chain_complex()?;
    /// assert_eq!(complex.f_vector(), [1, 1, 1]);
    /// assert_eq!(complex.boundary_matrix(2).expect("there is a face").entry_count(), 0);
    /// # Ok(()) }
    /// ```
    pub fn chain_complex(&self) -> Result<ChainComplex, Error> {
        let (vertex_count, edge_count, face_count) =
            (self.vertex_count(), self.edge_count(), self.face_count());
        if edge_count == 0 && face_count == 0 {
            return Ok(ChainComplex::of_points(vertex_count));
        }
        let ends = self.ends.iter().enumerate();
        let edges = ends.map(|(at, &end)| (end as usize, at / 2, if at % 2 == 0 { -1 } else { 1 }));
        let mut boundaries = vec![SparseMatrix::from_entries(vertex_count, edge_count, edges)?];
        if face_count > 0 {
            let steps = self.faces.iter().enumerate().flat_map(|(face, rim)| {
                rim.iter().map(move |&packed| {
                    let (edge, sign) = step(packed);
                    (edge.index(), face, i64::from(sign.to_i32()))
                })
            });
            boundaries.push(SparseMatrix::from_entries(edge_count, face_count, steps)?);
        }
        ChainComplex::new(boundaries)
    }
}

/// Checks that the steps of a face exist and are a closed path.
fn check_rim(face: usize, rim: &[u32], ends: &[u32]) -> Result<(), Error> {
    let Some(&last) = rim.last() else { return Ok(()) };
    let named = || FaceId::new(face);
    if let Some(&packed) = rim.iter().find(|&&packed| packed as usize >= ends.len()) {
        return Err(Error::invalid(format!(
            "face {} runs along {}, but there are {} edges",
            named(),
            step(packed).0,
            ends.len() / 2
        ))
        .with_fault(Fault::OutOfRange { index: packed as usize / 2, count: ends.len() / 2 }));
    }
    // The step 2e starts at ends[2e], the step 2e + 1 at ends[2e + 1]; each ends where its opposite starts.
    let mut at = ends[(last ^ 1) as usize];
    for &packed in rim {
        if ends[packed as usize] != at {
            return Err(Error::invalid(format!(
                "the rim of face {} breaks before {}: it is at v{at}, the step starts at v{}",
                named(),
                step(packed).0,
                ends[packed as usize]
            ))
            .with_cure("list the edges around the face in order, as one closed path"));
        }
        at = ends[(packed ^ 1) as usize];
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn broken_rims_are_named() {
        let fault = |vertex_count, ends: &[u32], rim: &[u32]| {
            let faces = RaggedArray::from_lists([rim]);
            TwoSkeleton::new(vertex_count, ends.to_vec(), faces).unwrap_err().message().to_owned()
        };
        let path = [0, 1, 1, 2, 2, 0];
        assert_eq!(
            fault(3, &path, &[0, 4]),
            "the rim of face f0 breaks before e2: it is at v1, the step starts at v2"
        );
        assert_eq!(
            fault(3, &path, &[0, 2]),
            "the rim of face f0 breaks before e0: it is at v2, the step starts at v0"
        );
        assert_eq!(fault(3, &path, &[6]), "face f0 runs along e3, but there are 3 edges");
        assert_eq!(fault(2, &path, &[]), "edge e1 ends at vertex 2, but there are 2 vertices");
        assert_eq!(fault(3, &[0], &[]), "1 ends of edges cannot be paired");
        assert_eq!(fault(0, &[], &[]), "face f0 has no vertex to be attached at");
    }

    #[test]
    fn a_triangle_has_its_boundary() {
        let triangle =
            TwoSkeleton::new(3, vec![0, 1, 0, 2, 1, 2], RaggedArray::from_lists([[0, 4, 3]])).unwrap();
        let complex = triangle.chain_complex().unwrap();
        assert_eq!(complex.f_vector(), [3, 3, 1]);
        assert_eq!(complex.boundary_matrix(2).unwrap().column(0).entries(), [1, -1, 1]);
        let steps: Vec<_> = triangle.face(FaceId::new(0)).collect();
        assert_eq!(steps[2], (EdgeId::new(1), Sign::Minus));
        assert_eq!(triangle.start(FaceId::new(0)), VertexId::new(0));
        assert!(triangle.clone().with_solids(RaggedArray::from_lists([[0, 1]])).is_err());
        assert!(triangle.with_points(&[VertexId::new(0)]).is_err());
    }
}
