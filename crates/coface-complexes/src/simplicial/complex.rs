//! Simplicial complexes that change: simplices come with their faces and go with their cofaces.

use super::Simplex;
use super::lists::{Lists, check_face_count};
use super::tree::{ROOT, Tree};
use super::tree_walk::{CofaceWalk, Walk};
use coface_algebra::RaggedArray;
use coface_algebra::{Error, ErrorKind, VertexId};
use std::fmt;

/// A finite set of simplices that holds with each one all its faces.
///
/// # Examples
/// Two triangles with a common edge:
/// ```
/// use coface_complexes::simplicial::{Simplex, SimplicialComplex};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let mut complex = SimplicialComplex::from_facets([[0, 1, 2], [1, 2, 3]])?;
/// assert_eq!(complex.f_vector(), [4, 5, 2]);
/// complex.erase(&Simplex::from([1, 2]));
/// assert_eq!(complex.f_vector(), [4, 4]);
/// assert_eq!(complex.dimension(), Some(1));
/// # Ok(()) }
/// ```
///
/// # Complexity
/// 24 bytes a simplex when made at once, and up to twice that after many changes. Inside is a simplex tree
/// (J.-D. Boissonnat, C. Maria, 2014); a complex has fewer than 2^30 simplices.
#[derive(Clone, Default)]
pub struct SimplicialComplex {
    tree: Tree,
}

impl SimplicialComplex {
    /// The complex without simplices.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::SimplicialComplex;
    /// assert_eq!(SimplicialComplex::new().dimension(), None);
    /// ```
    pub fn new() -> Self {
        Self::default()
    }

    /// The smallest complex with these simplices, given as lists of vertex numbers in any order. Lists may repeat and
    /// may be faces of others.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] naming the first list without a vertex or with a repeated one;
    /// [`ErrorKind::TooLarge`] if there would be more than 2^28 simplices.
    ///
    /// # Complexity
    /// $O(f \log g)$ for f pairs of a list and a face of it, of which at most g have a common part of their vertices.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::SimplicialComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let complex = SimplicialComplex::from_facets([&[0, 1, 2][..], &[3, 2]])?;
    /// assert_eq!(complex.f_vector(), [4, 4, 1]);
    /// # Ok(()) }
    /// ```
    pub fn from_facets<L: AsRef<[u32]>>(facets: impl IntoIterator<Item = L>) -> Result<Self, Error> {
        Ok(Self { tree: Tree::from_lists(&Lists::new(facets)?)? })
    }

    /// The complex of exactly these simplices, in any order; repetitions do not matter.
    ///
    /// # Errors
    /// [`ErrorKind::NotAComplex`] naming faces that are missing; [`ErrorKind::TooLarge`] as [`Self::insert`].
    ///
    /// # Examples
    /// A vertex is a complex; an edge without its ends is not.
    /// ```
    /// use coface_complexes::simplicial::{Simplex, SimplicialComplex};
    /// assert!(SimplicialComplex::from_simplices([Simplex::from([0])]).is_ok());
    /// let error = SimplicialComplex::from_simplices([Simplex::from([0, 1])]).unwrap_err();
    /// assert!(error.to_string().starts_with("2 faces are missing: {0}, {1}"));
    /// ```
    pub fn from_simplices(simplices: impl IntoIterator<Item = Simplex>) -> Result<Self, Error> {
        let mut given: Vec<Simplex> = simplices.into_iter().collect();
        given.sort_unstable();
        given.dedup();
        // The greatest first: then the faces of each are there already, and only looked up.
        let mut order: Vec<&Simplex> = given.iter().collect();
        order.sort_by_key(|simplex| std::cmp::Reverse(simplex.dimension()));
        let mut complex = Self::new();
        for simplex in order {
            complex.insert(simplex)?;
        }
        let missing_count = complex.len() - given.len();
        if missing_count == 0 {
            return Ok(complex);
        }
        let missing = complex.iter().filter(|face| given.binary_search(face).is_err());
        let mut named: Vec<String> = missing.take(8).map(|face| face.to_string()).collect();
        if named.len() < missing_count {
            named.push("...".to_owned());
        }
        let (count, are) = if missing_count == 1 {
            ("1 face".to_owned(), "is")
        } else {
            (format!("{missing_count} faces"), "are")
        };
        Err(Error::new(ErrorKind::NotAComplex, format!("{count} {are} missing: {}", named.join(", ")))
            .with_cure("add the missing faces, or take the closure (from_facets)"))
    }

    /// Inserts these simplices with all their faces.
    ///
    /// # Errors
    /// As [`Self::from_facets`]; the complex is then as before.
    ///
    /// # Complexity
    /// As [`Self::from_facets`]; if the lists have many faces, the complex itself is copied once.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::SimplicialComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mut complex = SimplicialComplex::from_facets([[0, 1]])?;
    /// complex.extend([[1, 2], [2, 0]])?;
    /// assert_eq!(complex.f_vector(), [3, 3]);
    /// # Ok(()) }
    /// ```
    pub fn extend<L: AsRef<[u32]>>(&mut self, facets: impl IntoIterator<Item = L>) -> Result<(), Error> {
        let lists = Lists::new(facets)?;
        // Merging walks both trees once; inserting one by one pays for each face, several times as much.
        if lists.face_bound > self.len() as u64 / 8 {
            let added = Tree::from_lists(&lists)?;
            self.tree = if self.is_empty() { added } else { self.tree.merged(&added) };
            return Ok(());
        }
        self.tree.make_room(lists.face_bound as usize)?;
        let mut numbers = Vec::with_capacity(lists.longest);
        for list in lists.iter() {
            numbers.clear();
            numbers.extend(list.iter().map(|&rank| lists.names[rank as usize]));
            self.tree.insert(&numbers, numbers.len());
        }
        self.tree.tidy();
        Ok(())
    }

    /// Inserts a simplex with all its faces; tells whether it was new.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`], with the complex as before, if the simplex has more than 2^28 faces (dimension 28 and
    /// up) or there is no room for them; [`Self::insert_skeleton`] is the cure.
    ///
    /// # Complexity
    /// $O(2^d \log n)$ for dimension d and n children of a node.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::{Simplex, SimplicialComplex};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mut complex = SimplicialComplex::new();
    /// assert!(complex.insert(&Simplex::from([0, 1, 2]))?);
    /// assert!(!complex.insert(&Simplex::from([0, 2]))?);
    /// assert_eq!(complex.len(), 7);
    /// # Ok(()) }
    /// ```
    pub fn insert(&mut self, simplex: &Simplex) -> Result<bool, Error> {
        if self.contains(simplex) {
            return Ok(false);
        }
        self.insert_skeleton(simplex, simplex.dimension())
    }

    /// Inserts the faces of dimension up to `dimension` of a simplex; tells whether one of them was new.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`], with the complex as before, if there are more than 2^28 such faces or no room for
    /// them.
    ///
    /// # Examples
    /// The complete graph on 40 vertices:
    /// ```
    /// use coface_complexes::simplicial::{Simplex, SimplicialComplex};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let vertices: Vec<u32> = (0..40).collect();
    /// let mut graph = SimplicialComplex::new();
    /// graph.insert_skeleton(&Simplex::from_numbers(&vertices)?, 1)?;
    /// assert_eq!(graph.f_vector(), [40, 780]);
    /// # Ok(()) }
    /// ```
    pub fn insert_skeleton(&mut self, simplex: &Simplex, dimension: usize) -> Result<bool, Error> {
        let before = self.len();
        let limit = dimension.saturating_add(1);
        self.tree.make_room(check_face_count(simplex.vertex_count(), limit)?)?;
        self.tree.insert(simplex.numbers(), limit);
        self.tree.tidy();
        Ok(self.len() > before)
    }

    /// Erases a simplex with all its cofaces; tells whether it was there.
    ///
    /// # Complexity
    /// Linear in the number of simplices that end in its last vertex, times the dimension; storage is given back from
    /// time to time by copying the complex, which costs a constant for each simplex erased.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::{Simplex, SimplicialComplex};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mut complex = SimplicialComplex::from_facets([[0, 1, 2]])?;
    /// assert!(complex.erase(&Simplex::from([0])));
    /// assert_eq!(complex, SimplicialComplex::from_facets([[1, 2]])?);
    /// # Ok(()) }
    /// ```
    pub fn erase(&mut self, simplex: &Simplex) -> bool {
        self.tree.erase(simplex.numbers())
    }

    /// Whether the simplex is in the complex.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::{Simplex, SimplicialComplex};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert!(SimplicialComplex::from_facets([[0, 1, 2]])?.contains(&Simplex::from([0, 2])));
    /// # Ok(()) }
    /// ```
    pub fn contains(&self, simplex: &Simplex) -> bool {
        self.tree.find(simplex.numbers()).is_some()
    }

    /// The greatest dimension of a simplex; `None` for the empty complex.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::SimplicialComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(SimplicialComplex::from_facets([[4]])?.dimension(), Some(0));
    /// # Ok(()) }
    /// ```
    pub fn dimension(&self) -> Option<usize> {
        self.tree.counts().len().checked_sub(1)
    }

    /// The number of simplices of this dimension.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::SimplicialComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(SimplicialComplex::from_facets([[0, 1, 2]])?.simplex_count(1), 3);
    /// # Ok(()) }
    /// ```
    pub fn simplex_count(&self, dimension: usize) -> usize {
        self.tree.counts().get(dimension).copied().unwrap_or(0)
    }

    /// The numbers of simplices of dimension 0, 1, ...; empty for the empty complex.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::SimplicialComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(SimplicialComplex::from_facets([[0, 1, 2]])?.f_vector(), [3, 3, 1]);
    /// # Ok(()) }
    /// ```
    pub fn f_vector(&self) -> Vec<usize> {
        self.tree.counts().to_vec()
    }

    /// The alternating sum of the numbers of simplices.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::SimplicialComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(SimplicialComplex::from_facets([[0, 1], [1, 2], [2, 0]])?.euler_characteristic(), 0);
    /// # Ok(()) }
    /// ```
    pub fn euler_characteristic(&self) -> i64 {
        let counts = self.tree.counts().iter().enumerate();
        counts.map(|(k, &count)| if k % 2 == 0 { count as i64 } else { -(count as i64) }).sum()
    }

    /// The number of simplices.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::SimplicialComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(SimplicialComplex::from_facets([[0, 1, 2]])?.len(), 7);
    /// # Ok(()) }
    /// ```
    pub fn len(&self) -> usize {
        self.tree.len()
    }

    /// Whether there is no simplex.
    ///
    /// # Examples
    /// ```
    /// assert!(coface_complexes::simplicial::SimplicialComplex::new().is_empty());
    /// ```
    pub fn is_empty(&self) -> bool {
        self.tree.len() == 0
    }

    /// All simplices in lexicographic order (the order of [`Simplex`]).
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::SimplicialComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edge = SimplicialComplex::from_facets([[0, 1]])?;
    /// assert_eq!(edge.iter().map(|simplex| simplex.to_string()).collect::<Vec<_>>(), ["{0}", "{0, 1}", "{1}"]);
    /// # Ok(()) }
    /// ```
    pub fn iter(&self) -> impl Iterator<Item = Simplex> + '_ {
        let mut walk = Walk::new(&self.tree, usize::MAX);
        std::iter::from_fn(move || walk.advance().then(|| Simplex::from_sorted(walk.path())))
    }

    /// The simplices of one dimension in lexicographic order.
    ///
    /// # Complexity
    /// Linear in the number of simplices of dimension up to `dimension`.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::{Simplex, SimplicialComplex};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let complex = SimplicialComplex::from_facets([[0, 1, 2]])?;
    /// let edges: Vec<Simplex> = complex.simplices(1).collect();
    /// assert_eq!(edges, [Simplex::from([0, 1]), Simplex::from([0, 2]), Simplex::from([1, 2])]);
    /// # Ok(()) }
    /// ```
    pub fn simplices(&self, dimension: usize) -> impl Iterator<Item = Simplex> + '_ {
        let vertex_count = dimension.saturating_add(1);
        let mut walk = Walk::new(&self.tree, vertex_count);
        std::iter::from_fn(move || {
            while walk.advance() {
                if walk.path().len() == vertex_count {
                    return Some(Simplex::from_sorted(walk.path()));
                }
            }
            None
        })
    }

    /// The vertices, rising.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_complexes::simplicial::SimplicialComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edge = SimplicialComplex::from_facets([[7, 3]])?;
    /// assert!(edge.vertices().eq([VertexId::new(3), VertexId::new(7)]));
    /// # Ok(()) }
    /// ```
    pub fn vertices(&self) -> impl Iterator<Item = VertexId> + '_ {
        self.tree.cursor(ROOT).map(|(vertex, _)| VertexId::from_u32(vertex))
    }

    /// The cofaces of a simplex, itself included: its star. None if it is not in the complex.
    ///
    /// Their order follows from what was done to the complex, so it is the same in every run, but it is not sorted
    /// and equal complexes may differ in it.
    ///
    /// # Complexity
    /// Linear in the number of simplices that end in the last vertex of `simplex` and contain it or not, and in the
    /// number of cofaces.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::{Simplex, SimplicialComplex};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let complex = SimplicialComplex::from_facets([[0, 1, 2], [1, 2, 3]])?;
    /// let mut star: Vec<String> = complex.cofaces(&Simplex::from([1, 2])).map(|coface| coface.to_string()).collect();
    /// star.sort();
    /// assert_eq!(star, ["{0, 1, 2}", "{1, 2, 3}", "{1, 2}"]);
    /// # Ok(()) }
    /// ```
    pub fn cofaces<'a>(&'a self, simplex: &Simplex) -> impl Iterator<Item = Simplex> + use<'a> {
        let mut walk = CofaceWalk::new(&self.tree, simplex.numbers());
        std::iter::from_fn(move || walk.advance().then(|| Simplex::from_sorted(walk.path())))
    }

    /// Calls `visit` with the vertex numbers of each coface of a simplex, rising; the cofaces and their order are
    /// those of [`Self::cofaces`], and no simplex is made for them.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::{Simplex, SimplicialComplex};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let complex = SimplicialComplex::from_facets([[0, 1, 2], [1, 2, 3]])?;
    /// let mut triangle_count = 0;
    /// complex.visit_cofaces(&Simplex::from([1]), |coface| triangle_count += usize::from(coface.len() == 3));
    /// assert_eq!(triangle_count, 2);
    /// # Ok(()) }
    /// ```
    pub fn visit_cofaces(&self, simplex: &Simplex, mut visit: impl FnMut(&[u32])) {
        let mut walk = CofaceWalk::new(&self.tree, simplex.numbers());
        while walk.advance() {
            visit(walk.path());
        }
    }

    /// The vertices that share an edge with `vertex`, rising.
    ///
    /// # Errors
    /// [`ErrorKind::NotInComplex`] if `vertex` is not in the complex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_complexes::simplicial::SimplicialComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let path = SimplicialComplex::from_facets([[0, 1], [1, 2]])?;
    /// assert_eq!(path.adjacent_vertices(VertexId::new(1))?, [VertexId::new(0), VertexId::new(2)]);
    /// # Ok(()) }
    /// ```
    pub fn adjacent_vertices(&self, vertex: VertexId) -> Result<Vec<VertexId>, Error> {
        let number = vertex.to_u32();
        let Some(ring) = self.tree.find_child(ROOT, number) else {
            return Err(absent(&Simplex::vertex(vertex)));
        };
        let mut adjacent: Vec<u32> = self.tree.edges_to(ring).collect();
        adjacent.sort_unstable();
        adjacent.extend(self.tree.cursor(ring).map(|(greater, _)| greater));
        Ok(adjacent.into_iter().map(VertexId::from_u32).collect())
    }

    /// The complex of all faces of all cofaces of a simplex: the closure of its star.
    ///
    /// # Errors
    /// [`ErrorKind::NotInComplex`] if `simplex` is not in the complex.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::{Simplex, SimplicialComplex};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let complex = SimplicialComplex::from_facets([[0, 1, 2], [1, 2, 3], [3, 4, 5]])?;
    /// let around = complex.closed_star(&Simplex::from([1]))?;
    /// assert_eq!(around, SimplicialComplex::from_facets([[0, 1, 2], [1, 2, 3]])?);
    /// # Ok(()) }
    /// ```
    pub fn closed_star(&self, simplex: &Simplex) -> Result<Self, Error> {
        self.require(simplex)?;
        let mut walk = CofaceWalk::new(&self.tree, simplex.numbers());
        let mut facets = RaggedArray::new();
        while walk.advance() {
            if walk.is_at_leaf() {
                facets.push(walk.path());
            }
        }
        Self::from_facets(facets.iter())
    }

    /// The link of one simplex, cut out of the tree in time linear in the simplices that end in its last vertex, and in
    /// $m \log v$ for m simplices and v vertices in the link: what [`Self::link`] does for a set of one.
    pub(super) fn link_of(&self, simplex: &Simplex) -> Result<Self, Error> {
        self.require(simplex)?;
        Ok(Self { tree: self.tree.link(simplex.numbers()) })
    }

    /// The maximal simplices (those that are no face of another) in lexicographic order.
    ///
    /// # Complexity
    /// $O(n d \log c)$ for n simplices, dimension d, and c children of a node.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::{Simplex, SimplicialComplex};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let complex = SimplicialComplex::from_facets([&[2, 3][..], &[0, 1, 2], &[4]])?;
    /// assert_eq!(complex.facets(), [Simplex::from([0, 1, 2]), Simplex::from([2, 3]), Simplex::from([4])]);
    /// # Ok(()) }
    /// ```
    pub fn facets(&self) -> Vec<Simplex> {
        let is_face = self.tree.proper_faces();
        let mut path = Vec::new();
        let mut facets: Vec<Simplex> = (0..is_face.len())
            .filter(|&node| !is_face[node])
            .map(|node| {
                self.tree.path_to(node as u32, &mut path);
                Simplex::from_sorted(&path)
            })
            .collect();
        facets.sort_unstable();
        facets
    }

    /// Verifies the invariants: every face of every simplex is there, and the inner order is sound.
    ///
    /// # Errors
    /// [`ErrorKind::NotAComplex`] naming the first broken one.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::SimplicialComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// SimplicialComplex::from_facets([[0, 1, 2]])?.check()?;
    /// # Ok(()) }
    /// ```
    pub fn check(&self) -> Result<(), Error> {
        self.tree.check()
    }

    pub(super) fn from_tree(tree: Tree) -> Self {
        Self { tree }
    }

    pub(super) fn tree(&self) -> &Tree {
        &self.tree
    }

    /// # Errors
    /// [`ErrorKind::NotInComplex`] if the simplex is not in the complex.
    pub(super) fn require(&self, simplex: &Simplex) -> Result<(), Error> {
        if self.contains(simplex) { Ok(()) } else { Err(absent(simplex)) }
    }
}

fn absent(simplex: &Simplex) -> Error {
    Error::new(ErrorKind::NotInComplex, format!("the simplex {simplex} is not in the complex"))
        .with_cells([simplex.numbers()])
        .with_cure("insert it first, or name a simplex of the complex")
}

/// Complexes are equal when they have the same simplices, however they came about.
impl PartialEq for SimplicialComplex {
    fn eq(&self, other: &Self) -> bool {
        if self.tree.counts() != other.tree.counts() {
            return false;
        }
        let (mut a, mut b) = (Walk::new(&self.tree, usize::MAX), Walk::new(&other.tree, usize::MAX));
        while a.advance() && b.advance() {
            if a.path() != b.path() {
                return false;
            }
        }
        true
    }
}

impl Eq for SimplicialComplex {}

impl fmt::Debug for SimplicialComplex {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_set().entries(self.iter()).finish()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::collections::BTreeSet;

    type Model = BTreeSet<BTreeSet<u32>>;

    fn faces(list: &BTreeSet<u32>, limit: usize) -> Model {
        let numbers: Vec<u32> = list.iter().copied().collect();
        (1u32..1 << numbers.len())
            .map(|mask| (0..numbers.len()).filter(|i| mask >> i & 1 == 1).map(|i| numbers[i]).collect())
            .filter(|face: &BTreeSet<u32>| face.len() <= limit)
            .collect()
    }

    fn simplex_of(list: &BTreeSet<u32>) -> Simplex {
        Simplex::from_numbers(&list.iter().copied().collect::<Vec<_>>()).unwrap()
    }

    /// Compares everything a complex tells with what the set of sets tells.
    fn assert_same(complex: &SimplicialComplex, model: &Model) {
        complex.check().unwrap();
        let all: Vec<Simplex> = complex.iter().collect();
        assert!(all.is_sorted_by(|a, b| a < b));
        assert_eq!(all, model.iter().map(simplex_of).collect::<Vec<_>>());
        assert_eq!(complex.len(), model.len());
        let top = model.iter().map(BTreeSet::len).max();
        assert_eq!(complex.dimension(), top.map(|count| count - 1));
        assert_eq!(complex.f_vector().len(), top.unwrap_or(0));
        for (k, &count) in complex.f_vector().iter().enumerate() {
            assert_eq!(complex.simplices(k).collect::<Vec<_>>().len(), count);
            assert_eq!(count, model.iter().filter(|simplex| simplex.len() == k + 1).count());
        }
        let maximal = model.iter().filter(|a| !model.iter().any(|b| a.len() < b.len() && a.is_subset(b)));
        assert_eq!(complex.facets(), maximal.map(simplex_of).collect::<Vec<_>>());
    }

    /// Few vertices, some of them with great numbers, so that simplices meet often.
    fn list() -> impl Strategy<Value = BTreeSet<u32>> {
        let vertex =
            prop_oneof![9 => 0u32..9, 1 => Just(70_000), 1 => Just(u32::MAX), 1 => Just(u32::MAX - 1)];
        prop::collection::btree_set(vertex, 1..6)
    }

    #[derive(Clone, Debug)]
    enum Change {
        Insert(BTreeSet<u32>),
        Skeleton(BTreeSet<u32>, usize),
        Extend(Vec<BTreeSet<u32>>),
        Erase(BTreeSet<u32>),
    }

    fn change() -> impl Strategy<Value = Change> {
        prop_oneof![
            3 => list().prop_map(Change::Insert),
            1 => (list(), 0usize..4).prop_map(|(list, k)| Change::Skeleton(list, k)),
            2 => prop::collection::vec(list(), 0..12).prop_map(Change::Extend),
            3 => list().prop_map(Change::Erase),
        ]
    }

    fn lists(sets: &[BTreeSet<u32>]) -> Vec<Vec<u32>> {
        // Descending, so that sorting is put to the test.
        sets.iter().map(|set| set.iter().rev().copied().collect()).collect()
    }

    proptest! {
        #[test]
        fn changes_agree_with_sets_of_sets(changes in prop::collection::vec(change(), 1..24)) {
            let (mut complex, mut model) = (SimplicialComplex::new(), Model::new());
            for change in changes {
                let before = model.len();
                match change {
                    Change::Insert(list) => {
                        let was_new = complex.insert(&simplex_of(&list)).unwrap();
                        model.extend(faces(&list, usize::MAX));
                        prop_assert_eq!(was_new, model.len() > before);
                    }
                    Change::Skeleton(list, k) => {
                        let was_new = complex.insert_skeleton(&simplex_of(&list), k).unwrap();
                        model.extend(faces(&list, k + 1));
                        prop_assert_eq!(was_new, model.len() > before);
                    }
                    Change::Extend(sets) => {
                        complex.extend(lists(&sets)).unwrap();
                        model.extend(sets.iter().flat_map(|list| faces(list, usize::MAX)));
                    }
                    Change::Erase(list) => {
                        let was_there = complex.erase(&simplex_of(&list));
                        model.retain(|simplex| !list.is_subset(simplex));
                        prop_assert_eq!(was_there, model.len() < before);
                    }
                }
                assert_same(&complex, &model);
            }
        }

        #[test]
        fn building_at_once_agrees_with_one_by_one(sets in prop::collection::vec(list(), 0..40)) {
            let at_once = SimplicialComplex::from_facets(lists(&sets)).unwrap();
            let mut one_by_one = SimplicialComplex::new();
            for set in &sets {
                one_by_one.insert(&simplex_of(set)).unwrap();
            }
            prop_assert_eq!(&at_once, &one_by_one);
            prop_assert_eq!(&SimplicialComplex::from_simplices(at_once.iter()).unwrap(), &at_once);
            assert_same(&at_once, &sets.iter().flat_map(|list| faces(list, usize::MAX)).collect());
        }

        #[test]
        fn neighbors_agree_with_sets_of_sets(
            sets in prop::collection::vec(list(), 1..20), gone in list(), of in list()
        ) {
            let mut complex = SimplicialComplex::from_facets(lists(&sets)).unwrap();
            complex.erase(&simplex_of(&gone));
            let model: Model = sets.iter().flat_map(|list| faces(list, usize::MAX))
                .filter(|simplex| !gone.is_subset(simplex)).collect();
            let simplex = simplex_of(&of);
            let mut star: Vec<Simplex> = complex.cofaces(&simplex).collect();
            star.sort();
            let expected: Vec<&BTreeSet<u32>> =
                model.iter().filter(|other| model.contains(&of) && of.is_subset(other)).collect();
            prop_assert_eq!(&star, &expected.iter().map(|set| simplex_of(set)).collect::<Vec<_>>());
            match complex.closed_star(&simplex) {
                Ok(closed) => assert_same(&closed, &expected.iter().flat_map(|set| faces(set, 9)).collect()),
                Err(error) => {
                    prop_assert_eq!(error.kind(), ErrorKind::NotInComplex);
                    prop_assert!(!model.contains(&of));
                }
            }
            for simplex in complex.iter() {
                let own: BTreeSet<u32> = simplex.numbers().iter().copied().collect();
                let apart = model.iter().filter(|other| {
                    own.is_disjoint(other) && model.contains(&own.union(other).copied().collect::<BTreeSet<u32>>())
                });
                assert_same(&complex.link_of(&simplex).unwrap(), &apart.cloned().collect());
            }
            for vertex in complex.vertices() {
                let adjacent = complex.adjacent_vertices(vertex).unwrap();
                let number = vertex.to_u32();
                let expected: Vec<VertexId> = model.iter()
                    .filter(|edge| edge.len() == 2 && edge.contains(&number))
                    .flat_map(|edge| edge.iter().copied().filter(|&other| other != number))
                    .map(VertexId::from_u32)
                    .collect::<BTreeSet<_>>().into_iter().collect();
                prop_assert_eq!(adjacent, expected);
            }
        }

        #[test]
        fn missing_faces_are_named(list in list(), position in 0usize..31) {
            let all = faces(&list, usize::MAX);
            let left_out = all.iter().nth(position % all.len()).unwrap();
            let given = all.iter().filter(|&face| face != left_out).map(simplex_of);
            let result = SimplicialComplex::from_simplices(given);
            if left_out.len() == list.len() {
                prop_assert!(result.is_ok());
            } else {
                let error = result.unwrap_err();
                prop_assert_eq!(error.kind(), ErrorKind::NotAComplex);
                prop_assert_eq!(error.message(), format!("1 face is missing: {}", simplex_of(left_out)));
            }
        }
    }

    /// The facts of what is a complex: a vertex is, an open edge is not, a triangle with edges but without vertices
    /// is not, a closed triangle is.
    #[test]
    fn closure_under_faces_is_demanded() {
        let triangle = Simplex::from([0, 1, 2]);
        let without_vertices = triangle.faces().filter(|face| face.dimension() > 0);
        let error = SimplicialComplex::from_simplices(without_vertices).unwrap_err();
        assert_eq!(error.message(), "3 faces are missing: {0}, {1}, {2}");
        assert!(SimplicialComplex::from_simplices([Simplex::from([0, 1])]).is_err());
        assert_eq!(SimplicialComplex::from_simplices([Simplex::from([0])]).unwrap().len(), 1);
        assert_eq!(SimplicialComplex::from_simplices(triangle.faces()).unwrap().len(), 7);
        assert!(SimplicialComplex::from_simplices([]).unwrap().is_empty());
    }

    /// A vertex with more neighbors than a block holds, joined in an order that is not sorted, then erased again.
    #[test]
    fn a_hub_takes_any_order() {
        let mut wheel = SimplicialComplex::new();
        for i in 0..400u32 {
            let rim = i * 173 % 400;
            wheel.insert(&Simplex::from([500, rim, (rim + 1) % 400])).unwrap();
            wheel.insert(&Simplex::from([0, rim + 1])).unwrap();
        }
        wheel.check().unwrap();
        assert_eq!(wheel.adjacent_vertices(VertexId::new(500)).unwrap().len(), 400);
        assert_eq!(wheel.adjacent_vertices(VertexId::new(0)).unwrap().len(), 401);
        for i in 0..400u32 {
            assert!(wheel.erase(&Simplex::from([i * 91 % 400, 500])));
            if i % 50 == 0 {
                wheel.check().unwrap();
            }
        }
        assert_eq!(wheel.cofaces(&Simplex::from([500])).count(), 1);
        wheel.check().unwrap();
    }

    /// Storage of erased simplices is used again.
    #[test]
    fn erasing_and_inserting_does_not_grow() {
        let mut complex = SimplicialComplex::from_facets([[0, 1, 2, 3, 4, 5, 6, 7]]).unwrap();
        for _ in 0..300 {
            assert!(complex.erase(&Simplex::from([3])));
            assert!(complex.insert(&Simplex::from([0, 1, 2, 3, 4, 5, 6, 7])).unwrap());
        }
        complex.check().unwrap();
        assert_eq!(complex.len(), 255);
        assert!(complex.tree.nodes.len() < 10_000);
    }

    #[test]
    fn too_many_faces_are_refused_with_a_cure() {
        let vertices: Vec<u32> = (0..31).collect();
        let simplex = Simplex::from_numbers(&vertices).unwrap();
        let mut complex = SimplicialComplex::from_facets([[0, 40]]).unwrap();
        let error = complex.insert(&simplex).unwrap_err();
        assert_eq!(error.kind(), ErrorKind::TooLarge);
        assert!(error.cure().unwrap().contains("coface skeleton INPUT"));
        assert_eq!(SimplicialComplex::from_facets([&vertices]).unwrap_err().kind(), ErrorKind::TooLarge);
        assert_eq!(complex.f_vector(), [2, 1]);
        assert!(complex.insert_skeleton(&simplex, 2).unwrap());
        assert_eq!(complex.f_vector(), [32, 466, 4495]);
        let wide = Simplex::from_numbers(&(0..100_000).collect::<Vec<u32>>()).unwrap();
        assert_eq!(complex.insert_skeleton(&wide, 1).unwrap_err().kind(), ErrorKind::TooLarge);
        assert!(complex.insert_skeleton(&wide, 0).unwrap());
    }

    #[test]
    fn bad_lists_are_named_and_change_nothing() {
        let mut complex = SimplicialComplex::from_facets([[0, 1]]).unwrap();
        let error = complex.extend([&[2, 3][..], &[4, 5, 4]]).unwrap_err();
        assert!(
            error.to_string().starts_with("list 1: vertex 4 is repeated in the simplex [4, 5, 4]"),
            "{error}"
        );
        let error = complex.extend([&[2, 3][..], &[]]).unwrap_err();
        assert_eq!(error.message(), "list 1 has no vertex");
        assert_eq!(complex.f_vector(), [2, 1]);
    }

    /// All faces of a simplex listed: lists that are faces of others must not multiply the work.
    #[test]
    fn lists_may_be_faces_of_others() {
        let simplex = Simplex::from_numbers(&(0..12).collect::<Vec<u32>>()).unwrap();
        let complex = SimplicialComplex::from_facets(simplex.faces().chain(simplex.faces())).unwrap();
        assert_eq!(complex.len(), 4095);
        assert_eq!(complex.facets(), [simplex]);
    }
}
