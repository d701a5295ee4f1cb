//! Delta complexes: simplices with ordered vertices, whose faces may coincide.
//!
//! A delta complex (a finite semi-simplicial set) has for each degree k a number of k-simplices, and each of them has
//! k + 1 faces of degree k - 1: face i is opposite to vertex i. Vertices of a simplex are ordered, and a face keeps the
//! order. Nothing else is asked: the faces of one simplex may be one and the same cell (the torus with one vertex), and
//! several simplices may have the same vertices.

use super::{FrozenComplex, SimplicialComplex};
use coface_algebra::chains::ChainComplex;
use coface_algebra::{CellId, Error, ErrorKind};
use coface_algebra::{RaggedArray, SparseMatrix, UnionFind};
use std::fmt;

/// A finite delta complex: for each degree the faces of all simplices in one flat array.
///
/// # Complexity
/// $4(k + 1)$ bytes a k-simplex.
///
/// # Examples
/// The torus of two triangles: one vertex; edges 0 and 1 are the sides of a square, edge 2 is its diagonal.
/// ```
/// use coface_complexes::simplicial::DeltaComplex;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let edges = vec![0, 0, 0, 0, 0, 0];
/// let triangles = vec![1, 2, 0, 0, 2, 1];
/// let torus = DeltaComplex::new(1, vec![edges, triangles])?;
/// assert_eq!(torus.f_vector(), [1, 3, 2]);
/// assert_eq!(torus.chain_complex()?.euler_characteristic(), 0);
/// # Ok(()) }
/// ```
#[derive(Clone, Default, PartialEq, Eq)]
pub struct DeltaComplex {
    vertex_count: usize,
    /// The faces of the simplices of degree k at position k - 1: k + 1 of each. The last is not empty.
    faces: Vec<Vec<u32>>,
}

impl DeltaComplex {
    /// The delta complex with this number of vertices and these faces: `faces[k - 1]` has the faces of the k-simplices,
    /// k + 1 of each, one simplex after the other; face i is the (k-1)-simplex opposite to vertex i. So an edge has its
    /// end first, then its start.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] if the faces of a degree are no whole number of simplices; [`ErrorKind::InvalidInput`]
    /// naming the first face that is not there; [`ErrorKind::NotAComplex`] naming the first simplex that breaks
    /// $d_i d_j = d_{j-1} d_i$ for i < j (leaving out vertex j, then i, is leaving out i, then what was j);
    /// [`ErrorKind::TooLarge`] for 2^32 simplices of one degree.
    ///
    /// # Complexity
    /// $O(k^2)$ for each k-simplex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::ErrorKind;
    /// use coface_complexes::simplicial::DeltaComplex;
    /// // An edge from vertex 0 to vertex 1, and a triangle whose three sides cannot follow one another.
    /// let error = DeltaComplex::new(2, vec![vec![1, 0], vec![0, 0, 0]]).unwrap_err();
    /// assert_eq!(error.kind(), ErrorKind::NotAComplex);
    /// ```
    pub fn new(vertex_count: usize, faces: Vec<Vec<u32>>) -> Result<Self, Error> {
        let complex = Self::from_trusted_faces(vertex_count, faces);
        complex.check()?;
        Ok(complex)
    }

    /// The complex of faces that a construction has just made right.
    #[doc(hidden)]
    pub fn from_trusted_faces(vertex_count: usize, mut faces: Vec<Vec<u32>>) -> Self {
        while faces.last().is_some_and(Vec::is_empty) {
            faces.pop();
        }
        Self { vertex_count, faces }
    }

    /// Verifies the invariants: see [`Self::new`].
    ///
    /// # Errors
    /// Those of [`Self::new`].
    ///
    /// # Examples
    /// ```
    /// coface_complexes::simplicial::DeltaComplex::default().check()?;
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn check(&self) -> Result<(), Error> {
        if self.vertex_count > u32::MAX as usize {
            return Err(Error::new(ErrorKind::TooLarge, "a delta complex has fewer than 2^32 vertices"));
        }
        for degree in 1..=self.faces.len() {
            let flat = &self.faces[degree - 1];
            if !flat.len().is_multiple_of(degree + 1) {
                return Err(Error::new(
                    ErrorKind::Shape,
                    format!(
                        "{} faces are no whole number of simplices of degree {degree}, which have {} each",
                        flat.len(),
                        degree + 1
                    ),
                ));
            }
            let count = self.simplex_count(degree);
            if count > u32::MAX as usize {
                return Err(Error::new(
                    ErrorKind::TooLarge,
                    format!("{count} simplices of degree {degree}; the limit is 2^32 - 1"),
                ));
            }
            let below = self.simplex_count(degree - 1);
            for cell in 0..count {
                self.check_simplex(degree, cell, below)?;
            }
        }
        Ok(())
    }

    fn check_simplex(&self, degree: usize, cell: usize, below: usize) -> Result<(), Error> {
        let faces = self.faces(degree, CellId::new(cell));
        if let Some(i) = faces.iter().position(|&face| face as usize >= below) {
            return Err(Error::invalid(format!(
                "face {i} of simplex {cell} of degree {degree} is {}, but there are {below} simplices of degree {}",
                faces[i],
                degree - 1
            ))
            .with_cure("number the simplices of each degree from 0"));
        }
        if degree == 1 {
            return Ok(());
        }
        for j in 1..=degree {
            for i in 0..j {
                let (first, second) = (
                    self.face(degree - 1, CellId::from_u32(faces[j]), i).index(),
                    self.face(degree - 1, CellId::from_u32(faces[i]), j - 1).index(),
                );
                if first != second {
                    return Err(Error::new(
                        ErrorKind::NotAComplex,
                        format!(
                            "faces {i} and {j} of simplex {cell} of degree {degree} do not fit together: face {i} of \
                             its face {j} is {first}, but face {} of its face {i} is {second}",
                            j - 1
                        ),
                    )
                    .with_cure("list face i as the one opposite to vertex i, all in one order of the vertices"));
                }
            }
        }
        Ok(())
    }

    /// The highest degree of a simplex; `None` for the empty complex.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_complexes::simplicial::DeltaComplex::default().dimension(), None);
    /// ```
    pub fn dimension(&self) -> Option<usize> {
        (self.vertex_count > 0).then_some(self.faces.len())
    }

    /// The number of simplices of this degree.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::DeltaComplex;
    /// let circle = DeltaComplex::new(1, vec![vec![0, 0]])?;
    /// assert_eq!((circle.simplex_count(1), circle.simplex_count(2)), (1, 0));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn simplex_count(&self, degree: usize) -> usize {
        match degree {
            0 => self.vertex_count,
            _ => self.faces.get(degree - 1).map_or(0, |flat| flat.len() / (degree + 1)),
        }
    }

    /// The numbers of simplices of degrees 0, 1, ...; empty for the empty complex.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::DeltaComplex;
    /// assert_eq!(DeltaComplex::new(1, vec![vec![0, 0]])?.f_vector(), [1, 1]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn f_vector(&self) -> Vec<usize> {
        self.dimension().map_or(Vec::new(), |top| (0..=top).map(|k| self.simplex_count(k)).collect())
    }

    /// The face of a simplex opposite to its vertex i.
    ///
    /// # Panics
    /// If there is no such simplex or vertex, and for degree 0.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::CellId;
    /// use coface_complexes::simplicial::DeltaComplex;
    /// // An edge from vertex 0 to vertex 1.
    /// let edge = DeltaComplex::new(2, vec![vec![1, 0]])?;
    /// assert_eq!(edge.face(1, CellId::new(0), 0), CellId::new(1));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn face(&self, degree: usize, cell: CellId, i: usize) -> CellId {
        CellId::from_u32(self.faces(degree, cell)[i])
    }

    /// The faces of a simplex: number i is opposite to its vertex i. A vertex has none.
    ///
    /// # Panics
    /// If there is no such simplex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::CellId;
    /// use coface_complexes::simplicial::DeltaComplex;
    /// let edge = DeltaComplex::new(2, vec![vec![1, 0]])?;
    /// assert_eq!(edge.faces(1, CellId::new(0)), [1, 0]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn faces(&self, degree: usize, cell: CellId) -> &[u32] {
        let cell = cell.index();
        if degree == 0 {
            assert!(cell < self.vertex_count, "there are {} vertices", self.vertex_count);
            return &[];
        }
        &self.faces[degree - 1][cell * (degree + 1)..(cell + 1) * (degree + 1)]
    }

    /// The face spanned by some vertices of a simplex, given as rising positions.
    ///
    /// # Panics
    /// If there is no such simplex or position, or if there is no position.
    ///
    /// # Complexity
    /// Linear in the number of positions left out.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, RaggedArray};
    /// use coface_complexes::simplicial::FrozenComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = FrozenComplex::from_facets(&RaggedArray::from_lists([[5, 6, 7]]))?.to_delta()?;
    /// let face = CellId::new(0);
    /// assert_eq!(triangle.face_spanned_by(2, face, &[1]), CellId::new(1));
    /// // The edges are {5, 6}, {5, 7}, {6, 7}.
    /// assert_eq!(triangle.face_spanned_by(2, face, &[0, 2]), CellId::new(1));
    /// # Ok(()) }
    /// ```
    pub fn face_spanned_by(&self, degree: usize, cell: CellId, positions: &[usize]) -> CellId {
        assert!(!positions.is_empty(), "a face has a vertex");
        let (mut at, mut at_degree, mut kept) = (cell, degree, positions.len());
        for i in (0..=degree).rev() {
            if kept > 0 && positions[kept - 1] == i {
                kept -= 1;
            } else {
                at = self.face(at_degree, at, i);
                at_degree -= 1;
            }
        }
        assert_eq!(kept, 0, "positions rise and are at most {degree}");
        at
    }

    /// The face spanned by the first p + 1 vertices of a simplex.
    ///
    /// # Panics
    /// If there is no such simplex, or if p is greater than its degree.
    ///
    /// # Complexity
    /// $O(k - p)$ for degree k.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::CellId;
    /// use coface_complexes::simplicial::DeltaComplex;
    /// let edge = DeltaComplex::new(2, vec![vec![1, 0]])?;
    /// let [start, end] = [0, 1].map(CellId::new);
    /// assert_eq!((edge.front_face(1, CellId::new(0), 0), edge.back_face(1, CellId::new(0), 0)), (start, end));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn front_face(&self, degree: usize, cell: CellId, p: usize) -> CellId {
        assert!(p <= degree, "a face of degree {p} of a simplex of degree {degree}");
        (p + 1..=degree).rev().fold(cell, |at, last| self.face(last, at, last))
    }

    /// The face spanned by the last q + 1 vertices of a simplex.
    ///
    /// # Panics
    /// If there is no such simplex, or if q is greater than its degree.
    ///
    /// # Complexity
    /// $O(k - q)$ for degree k.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, RaggedArray};
    /// use coface_complexes::simplicial::FrozenComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = FrozenComplex::from_facets(&RaggedArray::from_lists([[0, 1, 2]]))?.to_delta()?;
    /// // The edges are {0, 1}, {0, 2}, {1, 2}.
    /// let face = CellId::new(0);
    /// assert_eq!(triangle.front_face(2, face, 1), CellId::new(0));
    /// assert_eq!(triangle.back_face(2, face, 1), CellId::new(2));
    /// # Ok(()) }
    /// ```
    pub fn back_face(&self, degree: usize, cell: CellId, q: usize) -> CellId {
        assert!(q <= degree, "a face of degree {q} of a simplex of degree {degree}");
        (q + 1..=degree).rev().fold(cell, |at, degree| self.face(degree, at, 0))
    }

    /// The vertices of a simplex in its order; one may stand several times.
    ///
    /// # Panics
    /// If there is no such simplex.
    ///
    /// # Complexity
    /// $O(k^2)$ for degree k.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::CellId;
    /// use coface_complexes::simplicial::DeltaComplex;
    /// let edge = DeltaComplex::new(2, vec![vec![1, 0]])?;
    /// assert_eq!(edge.vertices(1, CellId::new(0)), [0, 1]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn vertices(&self, degree: usize, cell: CellId) -> Vec<u32> {
        let mut vertices = vec![0; degree + 1];
        let mut at = cell;
        for k in (0..=degree).rev() {
            vertices[k] = self.back_face(k, at, 0).to_u32();
            if k > 0 {
                at = self.face(k, at, k);
            }
        }
        vertices
    }

    /// The chain complex: cells of degree k are the k-simplices in their order, and the boundary of a simplex is
    /// $\sum_i (-1)^i d_i$, the alternating sum of its faces; where faces coincide their signs are added up.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] beyond 2^32 entries in a matrix.
    ///
    /// # Complexity
    /// Linear in the faces, times the logarithm of the degree.
    ///
    /// # Examples
    /// The dunce hat: a triangle with its three sides glued to one edge, in the order 01, 12, 02.
    /// ```
    /// use coface_complexes::simplicial::DeltaComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let chains = DeltaComplex::new(1, vec![vec![0, 0], vec![0, 0, 0]])?.chain_complex()?;
    /// assert_eq!(chains.boundary_matrix(2).map(|matrix| matrix.entry(0, 0)), Some(1));
    /// # Ok(()) }
    /// ```
    pub fn chain_complex(&self) -> Result<ChainComplex, Error> {
        if self.faces.is_empty() {
            return Ok(ChainComplex::of_points(self.vertex_count));
        }
        let matrices: Result<Vec<SparseMatrix>, Error> =
            (1..=self.faces.len()).map(|degree| self.boundary_matrix(degree)).collect();
        ChainComplex::new(matrices?)
    }

    fn boundary_matrix(&self, degree: usize) -> Result<SparseMatrix, Error> {
        let flat = &self.faces[degree - 1];
        if flat.len() > u32::MAX as usize {
            return Err(Error::new(
                ErrorKind::TooLarge,
                format!("{} faces of simplices of degree {degree}; the limit is 2^32 - 1", flat.len()),
            ));
        }
        let mut starts = Vec::with_capacity(flat.len() / (degree + 1) + 1);
        let (mut rows, mut entries) = (Vec::with_capacity(flat.len()), Vec::with_capacity(flat.len()));
        starts.push(0);
        let mut column: Vec<(u32, i32)> = Vec::with_capacity(degree + 1);
        for faces in flat.chunks_exact(degree + 1) {
            column.clear();
            column.extend(faces.iter().enumerate().map(|(i, &face)| (face, if i % 2 == 0 { 1 } else { -1 })));
            column.sort_unstable_by_key(|&(face, _)| face);
            for equal in column.chunk_by(|a, b| a.0 == b.0) {
                let sum: i32 = equal.iter().map(|&(_, sign)| sign).sum();
                if sum != 0 {
                    rows.push(equal[0].0);
                    entries.push(sum);
                }
            }
            starts.push(rows.len() as u32);
        }
        SparseMatrix::from_trusted_parts(self.simplex_count(degree - 1), starts, rows, entries)
    }

    /// The complex with some pairs of simplices made one, their faces along with them: `(k, a, b)` identifies the
    /// k-simplices a and b, vertex i of one with vertex i of the other. Also the new number of each old simplex, by
    /// degree. New simplices are numbered in the order of the first old ones.
    ///
    /// # Errors
    /// [`ErrorKind::NotInComplex`] naming a simplex that is not there.
    ///
    /// # Complexity
    /// Nearly linear.
    ///
    /// # Examples
    /// An edge with its ends identified:
    /// ```
    /// use coface_algebra::CellId;
    /// use coface_complexes::simplicial::DeltaComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edge = DeltaComplex::new(2, vec![vec![1, 0]])?;
    /// let (circle, numbers) = edge.quotient([(0, CellId::new(0), CellId::new(1))])?;
    /// assert_eq!(circle, DeltaComplex::new(1, vec![vec![0, 0]])?);
    /// assert_eq!(numbers[0], [0, 0]);
    /// # Ok(()) }
    /// ```
    pub fn quotient(
        &self,
        pairs: impl IntoIterator<Item = (usize, CellId, CellId)>,
    ) -> Result<(Self, Vec<Vec<u32>>), Error> {
        let mut classes: Vec<UnionFind> = self.f_vector().into_iter().map(UnionFind::new).collect();
        let mut stack = Vec::new();
        for (degree, a, b) in pairs {
            for cell in [a, b] {
                if cell.index() >= self.simplex_count(degree) {
                    return Err(Error::new(
                        ErrorKind::NotInComplex,
                        format!(
                            "there is no simplex {} of degree {degree}: there are {}",
                            cell.index(),
                            self.simplex_count(degree)
                        ),
                    ));
                }
            }
            stack.push((degree, a.index(), b.index()));
            while let Some((degree, a, b)) = stack.pop() {
                if classes[degree].unite(a as u32, b as u32) && degree > 0 {
                    let pairs = [a, b].map(|cell| self.faces(degree, CellId::new(cell)));
                    let pairs = pairs[0].iter().zip(pairs[1]);
                    stack.extend(pairs.map(|(&a, &b)| (degree - 1, a as usize, b as usize)));
                }
            }
        }
        let numbers: Vec<Vec<u32>> = classes.iter_mut().map(UnionFind::class_numbers).collect();
        let mut faces: Vec<Vec<u32>> = vec![Vec::new(); self.faces.len()];
        for (degree, faces) in (1..).zip(&mut faces) {
            let mut next = 0;
            for (cell, &number) in numbers[degree].iter().enumerate() {
                if number == next {
                    next += 1;
                    faces.extend(
                        self.faces(degree, CellId::new(cell))
                            .iter()
                            .map(|&f| numbers[degree - 1][f as usize]),
                    );
                }
            }
        }
        let vertex_count = classes.first().map_or(0, UnionFind::class_count);
        Ok((Self::from_trusted_faces(vertex_count, faces), numbers))
    }

    /// The simplicial complex with the same vertices and simplices.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] naming a simplex that repeats a vertex, or two simplices with the same vertices; then
    /// take [`Self::triangulation`]. [`ErrorKind::TooLarge`] as [`FrozenComplex::from_facets`].
    ///
    /// # Complexity
    /// $O(n \log n)$ for n simplices.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::DeltaComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edge = DeltaComplex::new(2, vec![vec![1, 0]])?;
    /// assert_eq!(edge.to_simplicial_complex()?.f_vector(), [2, 1]);
    /// let circle = DeltaComplex::new(1, vec![vec![0, 0]])?;
    /// assert!(circle.to_simplicial_complex().is_err());
    /// # Ok(()) }
    /// ```
    pub fn to_simplicial_complex(&self) -> Result<SimplicialComplex, Error> {
        Ok(FrozenComplex::from_facets(&self.vertex_sets()?)?.thaw())
    }

    /// The sorted vertices of all simplices, degree by degree.
    pub(super) fn vertex_sets(&self) -> Result<RaggedArray, Error> {
        let cure = "take the triangulation, which subdivides it";
        let mut all = RaggedArray::new();
        for degree in 0..=self.faces.len() {
            let mut sets: Vec<(Vec<u32>, usize)> = Vec::with_capacity(self.simplex_count(degree));
            for cell in 0..self.simplex_count(degree) {
                let mut vertices = self.vertices(degree, CellId::new(cell));
                vertices.sort_unstable();
                if let Some(pair) = vertices.windows(2).find(|pair| pair[0] == pair[1]) {
                    return Err(Error::invalid(format!(
                        "simplex {cell} of degree {degree} has vertex {} several times, so it is in no simplicial \
                         complex",
                        pair[0]
                    ))
                    .with_cure(cure));
                }
                sets.push((vertices, cell));
            }
            sets.sort_unstable();
            if let Some(pair) = sets.windows(2).find(|pair| pair[0].0 == pair[1].0) {
                return Err(Error::invalid(format!(
                    "simplices {} and {} of degree {degree} have the same vertices {:?}, so they are in no simplicial \
                     complex",
                    pair[0].1, pair[1].1, pair[0].0
                ))
                .with_cure(cure));
            }
            sets.iter().for_each(|(vertices, _)| all.push(vertices));
        }
        Ok(all)
    }
}

impl fmt::Debug for DeltaComplex {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "DeltaComplex {{ f_vector: {:?} }}", self.f_vector())
    }
}

impl FrozenComplex {
    /// The same complex as a delta complex: simplices have the same numbers and their vertices rise.
    ///
    /// # Errors
    /// As [`FrozenComplex::chain_complex`].
    ///
    /// # Complexity
    /// As [`FrozenComplex::chain_complex`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, RaggedArray};
    /// use coface_complexes::simplicial::FrozenComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = FrozenComplex::from_facets(&RaggedArray::from_lists([[0, 1, 2]]))?;
    /// let delta = triangle.to_delta()?;
    /// assert_eq!(delta.faces(2, CellId::new(0)), [2, 1, 0]);
    /// assert_eq!(delta.chain_complex()?, triangle.chain_complex()?);
    /// # Ok(()) }
    /// ```
    pub fn to_delta(&self) -> Result<DeltaComplex, Error> {
        let chains = self.chain_complex()?;
        let faces = chains.boundary_matrices().iter().enumerate().map(|(below, matrix)| {
            // In lexicographic order of simplices, the facets of one come last position first.
            let mut faces = matrix.rows().to_vec();
            faces.chunks_exact_mut(below + 2).for_each(<[u32]>::reverse);
            faces
        });
        Ok(DeltaComplex::from_trusted_faces(self.simplex_count(0), faces.collect()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Some simplices of degree up to 3, apart, with random pairs of faces of one degree identified.
    fn random_delta_complexes() -> impl Strategy<Value = DeltaComplex> {
        let degrees = prop::collection::vec(0_u32..4, 0..5);
        let pairs = prop::collection::vec((0_usize..4, any::<u32>(), any::<u32>()), 0..6);
        (degrees, pairs).prop_map(|(degrees, pairs)| {
            let facets = degrees.iter().enumerate().map(|(i, &degree)| {
                let first = 4 * i as u32;
                (first..=first + degree).collect::<Vec<u32>>()
            });
            let apart =
                FrozenComplex::from_facets(&RaggedArray::from_lists(facets)).unwrap().to_delta().unwrap();
            let pairs = pairs.into_iter().filter(|pair| apart.simplex_count(pair.0) > 0).map(|(k, a, b)| {
                let cell = |number: u32| CellId::new(number as usize % apart.simplex_count(k));
                (k, cell(a), cell(b))
            });
            apart.quotient(pairs).unwrap().0
        })
    }

    proptest! {
        #[test]
        fn faces_are_spanned_by_vertices(complex in random_delta_complexes()) {
            complex.check().unwrap();
            for degree in 0..complex.f_vector().len() {
                for cell in (0..complex.simplex_count(degree)).map(CellId::new) {
                    let vertices = complex.vertices(degree, cell);
                    for subset in 1_usize..1 << (degree + 1) {
                        let positions: Vec<usize> = (0..=degree).filter(|i| subset >> i & 1 == 1).collect();
                        let face = complex.face_spanned_by(degree, cell, &positions);
                        let spanned: Vec<u32> = positions.iter().map(|&i| vertices[i]).collect();
                        prop_assert_eq!(complex.vertices(positions.len() - 1, face), spanned);
                    }
                    for p in 0..=degree {
                        let front: Vec<usize> = (0..=p).collect();
                        let back: Vec<usize> = (degree - p..=degree).collect();
                        prop_assert_eq!(complex.front_face(degree, cell, p), complex.face_spanned_by(degree, cell, &front));
                        prop_assert_eq!(complex.back_face(degree, cell, p), complex.face_spanned_by(degree, cell, &back));
                    }
                }
            }
        }

        #[test]
        fn subdivisions_are_complexes_of_the_same_euler_characteristic(complex in random_delta_complexes()) {
            let once = complex.barycentric_subdivision().unwrap();
            once.complex().check().unwrap();
            let euler = complex.chain_complex().unwrap().euler_characteristic();
            prop_assert_eq!(once.complex().chain_complex().unwrap().euler_characteristic(), euler);
            let cells: usize = complex.f_vector().iter().sum();
            prop_assert_eq!(once.complex().simplex_count(0), cells);
            // Barycenters of a chain of faces have carriers of rising degree.
            for degree in 1..once.complex().f_vector().len() {
                for cell in (0..once.complex().simplex_count(degree)).map(CellId::new) {
                    let degrees: Vec<usize> = once.complex().vertices(degree, cell).iter()
                        .map(|&v| once.carriers()[coface_algebra::VertexId::from_u32(v)].0).collect();
                    prop_assert!(degrees.is_sorted_by(|a, b| a < b));
                }
            }
            if cells < 40 {
                let twice = once.subdivided().unwrap();
                let triangulation = twice.complex().to_simplicial_complex().unwrap();
                prop_assert_eq!(triangulation.f_vector(), twice.complex().f_vector());
                // Each simplex has a new vertex in its interior.
                for (degree, &count) in complex.f_vector().iter().enumerate() {
                    for cell in 0..count {
                        let of_cell = |carrier: &(usize, CellId)| *carrier == (degree, CellId::new(cell));
                        prop_assert!(twice.carriers().iter().any(of_cell));
                    }
                }
            }
            let (triangulated, carriers) = complex.triangulation().unwrap();
            prop_assert_eq!(triangulated.euler_characteristic(), euler);
            prop_assert_eq!(carriers.len(), triangulated.simplex_count(0));
        }

        #[test]
        fn one_wrong_face_is_found_or_harmless(
            complex in random_delta_complexes(), at in any::<prop::sample::Index>(), face in 0_u32..8
        ) {
            let mut faces = complex.faces.clone();
            let Some(last) = faces.last_mut() else { return Ok(()) };
            let place = at.index(last.len());
            last[place] = face;
            let degree = faces.len();
            match DeltaComplex::new(complex.vertex_count, faces) {
                Ok(changed) => { changed.chain_complex().unwrap(); }
                Err(error) => {
                    let named = format!("simplex {} of degree {degree}", place / (degree + 1));
                    prop_assert!(error.message().contains(&named), "{}", error);
                }
            }
        }
    }

    #[test]
    fn faults_are_named() {
        let kind = |vertices, faces| DeltaComplex::new(vertices, faces).unwrap_err().kind();
        assert_eq!(kind(1, vec![vec![0]]), ErrorKind::Shape);
        assert_eq!(kind(1, vec![vec![0, 1]]), ErrorKind::InvalidInput);
        assert_eq!(kind(1, vec![vec![], vec![0, 0, 0]]), ErrorKind::InvalidInput);
        let disk = DeltaComplex::new(3, vec![vec![1, 0, 2, 0, 2, 1], vec![2, 1, 0]]).unwrap();
        assert_eq!(disk.vertices(2, CellId::new(0)), [0, 1, 2]);
        let twice =
            DeltaComplex::new(2, vec![vec![1, 0, 1, 0]]).unwrap().to_simplicial_complex().unwrap_err();
        assert!(twice.message().contains("simplices 0 and 1"));
    }

    #[test]
    fn empty_complexes_and_points_are_ordinary() {
        let empty = DeltaComplex::new(0, Vec::new()).unwrap();
        assert_eq!((empty.f_vector(), empty.dimension()), (Vec::new(), None));
        assert!(empty.triangulation().unwrap().0.is_empty());
        let points = DeltaComplex::new(3, vec![Vec::new(), Vec::new()]).unwrap();
        assert_eq!(points.f_vector(), [3]);
        assert_eq!(points.chain_complex().unwrap(), ChainComplex::of_points(3));
        assert_eq!(points.barycentric_subdivision().unwrap().complex(), &points);
    }
}
