//! One simplex: a non-empty finite set of vertices.

use coface_algebra::Sign;
use coface_algebra::{Error, ErrorKind, VertexId};
use std::cmp::Ordering;
use std::fmt;
use std::hash::{Hash, Hasher};

/// How many vertices a simplex holds without an allocation: enough for dimension 6.
const INLINE: usize = 7;

/// A simplex: a non-empty set of distinct vertices, kept sorted. Its dimension is their number less one.
///
/// The orientation it stands for is the class of the rising order of its vertices. Simplices are ordered
/// lexicographically by their vertices, a simplex before those that continue it:
/// `{0} < {0, 1} < {0, 1, 2} < {0, 2} < {1}`.
///
/// # Examples
/// ```
/// use coface_complexes::simplicial::Simplex;
/// let triangle = Simplex::from([4, 2, 3]);
/// assert_eq!(triangle.to_string(), "{2, 3, 4}");
/// assert_eq!(triangle.dimension(), 2);
/// assert!(Simplex::from([4, 2]).is_face_of(&triangle));
/// ```
#[derive(Clone)]
pub struct Simplex(Repr);

#[derive(Clone)]
enum Repr {
    /// The first `len` numbers are the vertices.
    Inline {
        len: u8,
        numbers: [u32; INLINE],
    },
    Heap(Box<[u32]>),
}

impl Simplex {
    /// The simplex with these vertices, given in any order.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] if there is no vertex or one is repeated.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_complexes::simplicial::Simplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edge = Simplex::new([VertexId::new(7), VertexId::new(1)])?;
    /// assert_eq!(edge, Simplex::from([1, 7]));
    /// assert!(Simplex::new([VertexId::new(7), VertexId::new(7)]).is_err());
    /// # Ok(()) }
    /// ```
    pub fn new(vertices: impl IntoIterator<Item = VertexId>) -> Result<Self, Error> {
        let numbers: Vec<u32> = vertices.into_iter().map(VertexId::to_u32).collect();
        Self::from_numbers(&numbers)
    }

    /// The simplex whose vertices have these numbers, given in any order.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] if there is no vertex or one is repeated.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::Simplex;
    /// let error = Simplex::from_numbers(&[3, 1, 3]).unwrap_err();
    /// assert!(error.to_string().starts_with("vertex 3 is repeated in the simplex [3, 1, 3]"));
    /// ```
    pub fn from_numbers(numbers: &[u32]) -> Result<Self, Error> {
        let mut simplex = Self::from_sorted(numbers);
        let sorted = simplex.numbers_mut();
        sorted.sort_unstable();
        match sorted.windows(2).find(|pair| pair[0] == pair[1]) {
            Some(pair) => Err(repeated(pair[0], numbers)),
            None if numbers.is_empty() => {
                Err(Error::invalid("a simplex without vertices").with_cure("name at least one vertex"))
            }
            None => Ok(simplex),
        }
    }

    /// The simplex with these strictly rising vertex numbers, taken as they are.
    pub(crate) fn from_sorted(numbers: &[u32]) -> Self {
        if numbers.len() <= INLINE {
            let mut inline = [0; INLINE];
            inline[..numbers.len()].copy_from_slice(numbers);
            Self(Repr::Inline { len: numbers.len() as u8, numbers: inline })
        } else {
            Self(Repr::Heap(numbers.into()))
        }
    }

    /// The simplex of one vertex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_complexes::simplicial::Simplex;
    /// assert_eq!(Simplex::vertex(VertexId::new(5)), Simplex::from([5]));
    /// ```
    pub fn vertex(vertex: VertexId) -> Self {
        Self::from_sorted(&[vertex.to_u32()])
    }

    /// The numbers of the vertices, rising.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::Simplex;
    /// assert_eq!(Simplex::from([9, 4]).numbers(), [4, 9]);
    /// ```
    pub fn numbers(&self) -> &[u32] {
        match &self.0 {
            Repr::Inline { len, numbers } => &numbers[..usize::from(*len)],
            Repr::Heap(numbers) => numbers,
        }
    }

    fn numbers_mut(&mut self) -> &mut [u32] {
        match &mut self.0 {
            Repr::Inline { len, numbers } => &mut numbers[..usize::from(*len)],
            Repr::Heap(numbers) => numbers,
        }
    }

    /// The vertices, rising.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_complexes::simplicial::Simplex;
    /// let edge = Simplex::from([9, 4]);
    /// assert_eq!(edge.vertices().next(), Some(VertexId::new(4)));
    /// ```
    pub fn vertices(&self) -> impl ExactSizeIterator<Item = VertexId> + DoubleEndedIterator + Clone + '_ {
        self.numbers().iter().map(|&number| VertexId::from_u32(number))
    }

    /// The number of vertices: the dimension plus one.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_complexes::simplicial::Simplex::from([0, 1]).vertex_count(), 2);
    /// ```
    pub fn vertex_count(&self) -> usize {
        self.numbers().len()
    }

    /// The number of vertices less one.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_complexes::simplicial::Simplex::from([8]).dimension(), 0);
    /// ```
    pub fn dimension(&self) -> usize {
        self.numbers().len() - 1
    }

    /// Whether `vertex` is one of the vertices.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_complexes::simplicial::Simplex;
    /// assert!(Simplex::from([0, 3]).has_vertex(VertexId::new(3)));
    /// ```
    pub fn has_vertex(&self, vertex: VertexId) -> bool {
        self.numbers().binary_search(&vertex.to_u32()).is_ok()
    }

    /// Whether every vertex is a vertex of `other`. A simplex is a face of itself.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::Simplex;
    /// assert!(Simplex::from([0, 2]).is_face_of(&Simplex::from([0, 1, 2])));
    /// assert!(!Simplex::from([0, 3]).is_face_of(&Simplex::from([0, 1, 2])));
    /// ```
    pub fn is_face_of(&self, other: &Self) -> bool {
        let mut rest = other.numbers().iter();
        self.numbers().iter().all(|number| rest.by_ref().any(|candidate| candidate == number))
    }

    /// Whether no vertex is shared with `other`.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::Simplex;
    /// assert!(Simplex::from([0, 2]).is_disjoint(&Simplex::from([1, 3])));
    /// ```
    pub fn is_disjoint(&self, other: &Self) -> bool {
        self.intersection(other).is_none()
    }

    /// All faces, the simplex itself last: by dimension, lexicographically within one. The empty set is not counted,
    /// so a simplex of dimension d has $2^{d+1} - 1$ of them.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::Simplex;
    /// let faces: Vec<String> = Simplex::from([0, 1, 2]).faces().map(|face| face.to_string()).collect();
    /// assert_eq!(faces, ["{0}", "{1}", "{2}", "{0, 1}", "{0, 2}", "{1, 2}", "{0, 1, 2}"]);
    /// ```
    pub fn faces(&self) -> impl Iterator<Item = Self> + '_ {
        (0..self.vertex_count()).flat_map(|dimension| self.faces_of_dimension(dimension))
    }

    /// The faces of one dimension in lexicographic order; none above the dimension of the simplex.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::Simplex;
    /// let edges: Vec<Simplex> = Simplex::from([0, 1, 2]).faces_of_dimension(1).collect();
    /// assert_eq!(edges, [Simplex::from([0, 1]), Simplex::from([0, 2]), Simplex::from([1, 2])]);
    /// ```
    pub fn faces_of_dimension(&self, dimension: usize) -> impl Iterator<Item = Self> + '_ {
        let numbers = self.numbers();
        let count = dimension.saturating_add(1);
        let mut chosen: Option<Vec<usize>> = (count <= numbers.len()).then(|| (0..count).collect());
        std::iter::from_fn(move || {
            let positions = chosen.as_mut()?;
            let face: Vec<u32> = positions.iter().map(|&at| numbers[at]).collect();
            // The last position that can still move right does so, and those after it follow closely.
            match (0..count).rposition(|i| positions[i] < numbers.len() - count + i) {
                Some(i) => {
                    let start = positions[i] + 1;
                    for (step, position) in positions[i..].iter_mut().enumerate() {
                        *position = start + step;
                    }
                }
                None => chosen = None,
            }
            Some(Self::from_sorted(&face))
        })
    }

    /// The faces of one dimension less with their signs in the boundary: the i-th leaves out the i-th vertex and has
    /// the sign $(-1)^i$. A vertex has none.
    ///
    /// # Examples
    /// The boundary of the edge from 0 to 1 is vertex 1 minus vertex 0.
    /// ```
    /// use coface_algebra::Sign;
    /// use coface_complexes::simplicial::Simplex;
    /// let boundary: Vec<(Sign, Simplex)> = Simplex::from([0, 1]).facets().collect();
    /// assert_eq!(boundary, [(Sign::Plus, Simplex::from([1])), (Sign::Minus, Simplex::from([0]))]);
    /// ```
    pub fn facets(&self) -> impl ExactSizeIterator<Item = (Sign, Self)> + '_ {
        let count = if self.dimension() == 0 { 0 } else { self.vertex_count() };
        (0..count).map(|i| (Sign::power_of_minus_one(i), self.without_position(i)))
    }

    fn without_position(&self, i: usize) -> Self {
        let numbers = self.numbers();
        let mut face = Self::from_sorted(&numbers[..numbers.len() - 1]);
        face.numbers_mut()[i..].copy_from_slice(&numbers[i + 1..]);
        face
    }

    /// The sign of `facet` in the boundary of this simplex; `None` if it is not a face of one dimension less.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Sign;
    /// use coface_complexes::simplicial::Simplex;
    /// let triangle = Simplex::from([0, 1, 2]);
    /// assert_eq!(triangle.incidence(&Simplex::from([0, 2])), Some(Sign::Minus));
    /// assert_eq!(triangle.incidence(&Simplex::from([0])), None);
    /// ```
    pub fn incidence(&self, facet: &Self) -> Option<Sign> {
        if facet.vertex_count() + 1 != self.vertex_count() || !facet.is_face_of(self) {
            return None;
        }
        let missing = self.numbers().iter().zip(facet.numbers()).take_while(|(a, b)| a == b).count();
        Some(Sign::power_of_minus_one(missing))
    }

    /// The orientation that an order of the vertices gives: plus if it is an even permutation of the rising order.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] if `order` is not an order of the vertices of this simplex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Sign;
    /// use coface_complexes::simplicial::Simplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = Simplex::from([0, 1, 2]);
    /// assert_eq!(triangle.sign_of(&[1, 2, 0])?, Sign::Plus);
    /// assert_eq!(triangle.sign_of(&[1, 0, 2])?, Sign::Minus);
    /// # Ok(()) }
    /// ```
    pub fn sign_of(&self, order: &[u32]) -> Result<Sign, Error> {
        let numbers = self.numbers();
        let mut positions = Vec::with_capacity(numbers.len());
        for number in order {
            positions.extend(numbers.binary_search(number));
        }
        let mut seen = vec![false; numbers.len()];
        for &position in &positions {
            seen[position] = true;
        }
        if order.len() != numbers.len() || positions.len() != numbers.len() || seen.contains(&false) {
            return Err(Error::invalid(format!("{order:?} is not an order of the vertices of {self}")));
        }
        // A cycle of even length is an odd permutation; each step below is one transposition.
        let mut sign = Sign::Plus;
        for i in 0..positions.len() {
            while positions[i] != i {
                let target = positions[i];
                positions.swap(i, target);
                sign = sign.opposite();
            }
        }
        Ok(sign)
    }

    /// The join with a simplex that shares no vertex: the simplex of all vertices of both.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] naming a vertex of both.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::Simplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(Simplex::from([0, 3]).join(&Simplex::from([1]))?, Simplex::from([0, 1, 3]));
    /// # Ok(()) }
    /// ```
    pub fn join(&self, other: &Self) -> Result<Self, Error> {
        match self.intersection(other) {
            None => Ok(self.union(other)),
            Some(shared) => {
                let both = shared.numbers()[0];
                Err(Error::invalid(format!("{self} and {other} share vertex {both} and have no join"))
                    .with_cure("renumber the vertices of one, or take the union"))
            }
        }
    }

    /// The simplex of the vertices of either.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::Simplex;
    /// assert_eq!(Simplex::from([0, 1]).union(&Simplex::from([1, 2])), Simplex::from([0, 1, 2]));
    /// ```
    #[must_use]
    pub fn union(&self, other: &Self) -> Self {
        let mut all = [self.numbers(), other.numbers()].concat();
        all.sort_unstable();
        all.dedup();
        Self::from_sorted(&all)
    }

    /// The common face; `None` if there is no common vertex.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::Simplex;
    /// assert_eq!(Simplex::from([0, 1]).intersection(&Simplex::from([1, 2])), Some(Simplex::from([1])));
    /// ```
    pub fn intersection(&self, other: &Self) -> Option<Self> {
        self.selected(|number| other.numbers().binary_search(&number).is_ok())
    }

    /// The face opposite to `other`: that of the vertices that are not in `other`; `None` if there are none.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::Simplex;
    /// assert_eq!(Simplex::from([0, 1, 2]).difference(&Simplex::from([1, 5])), Some(Simplex::from([0, 2])));
    /// ```
    pub fn difference(&self, other: &Self) -> Option<Self> {
        self.selected(|number| other.numbers().binary_search(&number).is_err())
    }

    fn selected(&self, keep: impl Fn(u32) -> bool) -> Option<Self> {
        let chosen: Vec<u32> = self.numbers().iter().copied().filter(|&number| keep(number)).collect();
        (!chosen.is_empty()).then(|| Self::from_sorted(&chosen))
    }
}

/// The fault of a simplex that names this vertex more than once.
pub(super) fn repeated(vertex: u32, numbers: &[u32]) -> Error {
    let simplex = shortened(numbers);
    Error::new(ErrorKind::InvalidInput, format!("vertex {vertex} is repeated in the simplex {simplex}"))
        .with_cure(
            "a simplex is a set of vertices; cells glued to themselves need a surface or a cell complex",
        )
}

/// The list as it prints, cut after 16 numbers.
pub(super) fn shortened(numbers: &[u32]) -> String {
    match numbers.get(..16) {
        Some(start) if numbers.len() > 16 => {
            let start: Vec<String> = start.iter().map(u32::to_string).collect();
            format!("[{}, ... {} numbers]", start.join(", "), numbers.len())
        }
        _ => format!("{numbers:?}"),
    }
}

/// The simplex with these vertex numbers, in any order, for literals in code.
///
/// # Panics
/// If there is none or one is repeated; use [`Simplex::from_numbers`] for data.
impl<const N: usize> From<[u32; N]> for Simplex {
    fn from(numbers: [u32; N]) -> Self {
        Self::from_numbers(&numbers).expect("a simplex literal has vertices and repeats none")
    }
}

impl AsRef<[u32]> for Simplex {
    fn as_ref(&self) -> &[u32] {
        self.numbers()
    }
}

impl PartialEq for Simplex {
    fn eq(&self, other: &Self) -> bool {
        self.numbers() == other.numbers()
    }
}

impl Eq for Simplex {}

impl PartialOrd for Simplex {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Simplex {
    fn cmp(&self, other: &Self) -> Ordering {
        self.numbers().cmp(other.numbers())
    }
}

impl Hash for Simplex {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.numbers().hash(state);
    }
}

impl fmt::Display for Simplex {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("{")?;
        for (i, number) in self.numbers().iter().enumerate() {
            if i > 0 {
                f.write_str(", ")?;
            }
            write!(f, "{number}")?;
        }
        f.write_str("}")
    }
}

impl fmt::Debug for Simplex {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::collections::BTreeSet;

    fn simplex() -> impl Strategy<Value = Simplex> {
        prop::collection::btree_set(0u32..40, 1..12)
            .prop_map(|set| Simplex::from_sorted(&set.into_iter().collect::<Vec<_>>()))
    }

    #[test]
    fn faults_name_the_vertex_and_the_cure() {
        let error = Simplex::from_numbers(&[5, 2, 5]).unwrap_err();
        assert_eq!(error.kind(), ErrorKind::InvalidInput);
        assert!(error.message().contains("vertex 5") && error.cure().is_some());
        assert_eq!(Simplex::new([]).unwrap_err().kind(), ErrorKind::InvalidInput);
        let long: Vec<u32> = (0..40).chain([3]).collect();
        assert!(Simplex::from_numbers(&long).unwrap_err().message().ends_with("15, ... 41 numbers]"));
    }

    #[test]
    #[should_panic(expected = "literal")]
    fn a_bad_literal_is_a_broken_contract() {
        let _ = Simplex::from([1, 1]);
    }

    #[test]
    fn the_order_is_lexicographic() {
        let order = [&[0][..], &[0, 1], &[0, 1, 2], &[0, 2], &[1]].map(Simplex::from_sorted);
        assert!(order.is_sorted_by(|a, b| a < b));
    }

    #[test]
    fn a_vertex_has_no_facets_and_one_face() {
        let vertex = Simplex::from([3]);
        assert_eq!((vertex.facets().len(), vertex.faces().count()), (0, 1));
        assert_eq!(vertex.faces_of_dimension(usize::MAX).count(), 0);
        assert_eq!(vertex.sign_of(&[3]).unwrap(), Sign::Plus);
    }

    #[test]
    fn an_order_must_have_the_same_vertices() {
        let triangle = Simplex::from([0, 1, 2]);
        for bad in [&[0, 1][..], &[0, 1, 1], &[0, 1, 3], &[0, 1, 2, 2], &[]] {
            assert!(triangle.sign_of(bad).is_err(), "{bad:?}");
        }
    }

    #[test]
    fn a_simplex_is_four_words() {
        assert_eq!(size_of::<Simplex>(), 32);
    }

    proptest! {
        #[test]
        fn faces_are_the_non_empty_subsets(simplex in simplex()) {
            let faces: Vec<Simplex> = simplex.faces().collect();
            let masks: BTreeSet<Simplex> = (1u32..1 << simplex.vertex_count())
                .map(|mask| {
                    let chosen = (0..simplex.vertex_count()).filter(|i| mask >> i & 1 == 1);
                    Simplex::from_sorted(&chosen.map(|i| simplex.numbers()[i]).collect::<Vec<_>>())
                })
                .collect();
            prop_assert_eq!(faces.len(), masks.len());
            prop_assert!(faces.is_sorted_by(|a, b| (a.dimension(), a) < (b.dimension(), b)));
            prop_assert_eq!(faces.into_iter().collect::<BTreeSet<_>>(), masks);
        }

        #[test]
        fn facets_of_facets_cancel(simplex in simplex()) {
            let mut sums = std::collections::BTreeMap::new();
            for (sign, facet) in simplex.facets() {
                prop_assert_eq!(simplex.incidence(&facet), Some(sign));
                for (inner, ridge) in facet.facets() {
                    *sums.entry(ridge).or_insert(0) += sign.times(inner).to_i32();
                }
            }
            prop_assert!(sums.values().all(|&sum| sum == 0));
        }

        /// The sign counts inversions.
        #[test]
        fn the_sign_is_the_parity_of_inversions(order in Just((0u32..9).collect::<Vec<_>>()).prop_shuffle()) {
            let inversions = (0..9).flat_map(|i| (i + 1..9).map(move |j| (i, j)))
                .filter(|&(i, j)| order[i] > order[j]).count();
            let simplex = Simplex::from_numbers(&order).unwrap();
            prop_assert_eq!(simplex.sign_of(&order).unwrap(), Sign::power_of_minus_one(inversions));
        }

        #[test]
        fn set_operations_agree_with_sets(a in simplex(), b in simplex()) {
            let set = |s: &Simplex| s.numbers().iter().copied().collect::<BTreeSet<u32>>();
            let list = |s: Option<Simplex>| s.map_or(Vec::new(), |s| s.numbers().to_vec());
            let (x, y) = (set(&a), set(&b));
            prop_assert_eq!(list(Some(a.union(&b))), x.union(&y).copied().collect::<Vec<_>>());
            prop_assert_eq!(list(a.intersection(&b)), x.intersection(&y).copied().collect::<Vec<_>>());
            prop_assert_eq!(list(a.difference(&b)), x.difference(&y).copied().collect::<Vec<_>>());
            prop_assert_eq!(a.is_face_of(&b), x.is_subset(&y));
            prop_assert_eq!(a.is_disjoint(&b), x.is_disjoint(&y));
            prop_assert_eq!(a.join(&b).is_ok(), x.is_disjoint(&y));
        }
    }
}
