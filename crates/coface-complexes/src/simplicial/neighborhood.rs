//! Star, closure, link, boundary and interior of any set of simplices of a complex.

use super::{Simplex, SimplicialComplex};
use coface_algebra::{Error, ErrorKind, VertexId};
use std::fmt;

/// A finite set of simplices that need not hold the faces of its members: a star, an interior, a selection.
///
/// # Examples
/// A triangle without its rim is a set, not a complex.
/// ```
/// use coface_complexes::simplicial::{Simplex, SimplexSet};
/// let open = SimplexSet::from(Simplex::from([0, 1, 2]));
/// assert!(!open.is_complex());
/// assert_eq!(open.missing_faces().f_vector(), [3, 3]);
/// assert_eq!(open.closure().f_vector(), [3, 3, 1]);
/// ```
#[derive(Clone, Default, PartialEq, Eq)]
pub struct SimplexSet {
    /// The members of dimension k at position k, in lexicographic order, each once. The last list is not empty.
    levels: Vec<Vec<Simplex>>,
}

impl SimplexSet {
    /// The set without members.
    pub const fn new() -> Self {
        Self { levels: Vec::new() }
    }

    fn from_levels(mut levels: Vec<Vec<Simplex>>) -> Self {
        for level in &mut levels {
            level.sort_unstable();
            level.dedup();
        }
        while levels.last().is_some_and(Vec::is_empty) {
            levels.pop();
        }
        Self { levels }
    }

    /// The number of members.
    pub fn len(&self) -> usize {
        self.levels.iter().map(Vec::len).sum()
    }

    /// Whether there is no member.
    pub fn is_empty(&self) -> bool {
        self.levels.is_empty()
    }

    /// The greatest dimension of a member; `None` for the empty set.
    pub fn dimension(&self) -> Option<usize> {
        self.levels.len().checked_sub(1)
    }

    /// The numbers of members of dimension 0, 1, ...; empty for the empty set.
    pub fn f_vector(&self) -> Vec<usize> {
        self.levels.iter().map(Vec::len).collect()
    }

    /// The members of one dimension in lexicographic order.
    pub fn simplices(&self, dimension: usize) -> &[Simplex] {
        self.levels.get(dimension).map_or(&[], Vec::as_slice)
    }

    /// All members, by dimension and then in lexicographic order.
    pub fn iter(&self) -> impl Iterator<Item = &Simplex> {
        self.levels.iter().flatten()
    }

    /// All members, given away in the same order.
    pub fn into_simplices(self) -> impl Iterator<Item = Simplex> {
        self.levels.into_iter().flatten()
    }

    /// Whether the simplex is a member.
    ///
    /// # Complexity
    /// Logarithmic.
    pub fn contains(&self, simplex: &Simplex) -> bool {
        self.simplices(simplex.dimension()).binary_search(simplex).is_ok()
    }

    /// The vertices of all members, rising, whether they are members themselves or not.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::{Simplex, SimplexSet};
    /// assert_eq!(SimplexSet::from(Simplex::from([3, 1])).vertices().len(), 2);
    /// ```
    pub fn vertices(&self) -> Vec<VertexId> {
        let mut all: Vec<VertexId> = self.iter().flat_map(Simplex::vertices).collect();
        all.sort_unstable();
        all.dedup();
        all
    }

    /// The members of either set.
    #[must_use]
    pub fn union(&self, other: &Self) -> Self {
        self.iter().chain(other.iter()).cloned().collect()
    }

    /// The members of both sets.
    #[must_use]
    pub fn intersection(&self, other: &Self) -> Self {
        self.iter().filter(|simplex| other.contains(simplex)).cloned().collect()
    }

    /// The members of this set that are not in the other.
    #[must_use]
    pub fn difference(&self, other: &Self) -> Self {
        self.iter().filter(|simplex| !other.contains(simplex)).cloned().collect()
    }

    /// Whether every member is in the other set.
    pub fn is_subset(&self, other: &Self) -> bool {
        self.iter().all(|simplex| other.contains(simplex))
    }

    /// The closure: all faces of all members. The smallest complex with these members, as a set.
    ///
    /// # Complexity
    /// $O(m d \log m)$ for m simplices in the closure, of dimension up to d.
    #[must_use]
    pub fn closure(&self) -> Self {
        let mut levels = self.levels.clone();
        for k in (1..levels.len()).rev() {
            let facets: Vec<Simplex> =
                levels[k].iter().flat_map(|simplex| simplex.facets().map(|(_, facet)| facet)).collect();
            levels[k - 1].extend(facets);
            levels[k - 1].sort_unstable();
            levels[k - 1].dedup();
        }
        Self { levels }
    }

    /// Whether every face of every member is a member. The empty set is a complex.
    pub fn is_complex(&self) -> bool {
        self.first_missing_face().is_none()
    }

    /// A member and a face of it that is not a member, one dimension below; a set without such a pair is a complex.
    pub(super) fn first_missing_face(&self) -> Option<(&Simplex, Simplex)> {
        self.iter().find_map(|simplex| {
            let missing = simplex.facets().map(|(_, facet)| facet).find(|facet| !self.contains(facet))?;
            Some((simplex, missing))
        })
    }

    /// The faces of members that are not members: what [`Self::closure`] adds.
    #[must_use]
    pub fn missing_faces(&self) -> Self {
        self.closure().difference(self)
    }

    /// The members that are no proper face of another member: for a complex, its facets.
    ///
    /// # Complexity
    /// As [`Self::closure`].
    #[must_use]
    pub fn maximal_simplices(&self) -> Self {
        let Some(top) = self.dimension() else { return Self::new() };
        let mut levels = vec![Vec::new(); top + 1];
        // The proper faces of members of higher dimensions, one dimension at a time.
        let mut covered: Vec<Simplex> = Vec::new();
        for k in (0..=top).rev() {
            levels[k] =
                self.levels[k].iter().filter(|s| covered.binary_search(s).is_err()).cloned().collect();
            let next = self.levels[k].iter().chain(covered.iter());
            let mut next: Vec<Simplex> =
                next.flat_map(|simplex| simplex.facets().map(|(_, facet)| facet)).collect();
            next.sort_unstable();
            next.dedup();
            covered = next;
        }
        Self::from_levels(levels)
    }

    /// The members as a complex.
    ///
    /// # Errors
    /// [`ErrorKind::NotAComplex`] naming a member and a face of it that is missing.
    pub fn to_complex(&self) -> Result<SimplicialComplex, Error> {
        self.require_complex()?;
        self.spanned_complex()
    }

    /// The complex of all faces of all members. In low dimension the faces that many members have in common cost less than
    /// the search for the members that would do.
    pub(super) fn spanned_complex(&self) -> Result<SimplicialComplex, Error> {
        if self.levels.len() <= 4 {
            SimplicialComplex::from_facets(self.iter())
        } else {
            SimplicialComplex::from_facets(self.maximal_simplices().iter())
        }
    }

    pub(super) fn require_complex(&self) -> Result<(), Error> {
        let Some((simplex, face)) = self.first_missing_face() else { return Ok(()) };
        Err(Error::new(
            ErrorKind::NotAComplex,
            format!("the set of simplices is not a complex: it holds {simplex} without its face {face}"),
        )
        .with_cells([simplex.numbers(), face.numbers()])
        .with_cure("take its closure first"))
    }

    /// The boundary bd of a pure complex: the closure of the simplices that are a proper face of exactly one simplex.
    ///
    /// These are the simplices one dimension below the top with one coface, and their faces. Points have no boundary.
    /// The boundary of a chain is another thing: here `bd(bd K)` may have members, as for the triangles vab, vbc, vca,
    /// vad, where it is {v}.
    ///
    /// # Errors
    /// [`ErrorKind::NotAComplex`] naming a missing face; [`ErrorKind::NotPure`] naming a simplex that is in none of the
    /// top dimension.
    ///
    /// # Examples
    /// A book of three triangles: the spine is not in the boundary, its ends are.
    /// ```
    /// use coface_complexes::simplicial::{SimplexSet, SimplicialComplex};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let book = SimplicialComplex::from_facets([[0, 1, 2], [0, 1, 3], [0, 1, 4]])?;
    /// assert_eq!(SimplexSet::from(&book).boundary_complex()?.f_vector(), [5, 6]);
    /// # Ok(()) }
    /// ```
    pub fn boundary_complex(&self) -> Result<SimplicialComplex, Error> {
        SimplicialComplex::from_facets(self.boundary_ridges()?)
    }

    /// The interior of a pure complex: its simplices that are not in its boundary. A set, in general no complex.
    ///
    /// # Errors
    /// As [`Self::boundary_complex`].
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::{Simplex, SimplexSet};
    /// let triangle = SimplexSet::from(Simplex::from([0, 1, 2])).closure();
    /// assert_eq!(triangle.interior()?.f_vector(), [0, 0, 1]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn interior(&self) -> Result<Self, Error> {
        let boundary: Self = self.boundary_ridges()?.into_iter().collect();
        Ok(self.difference(&boundary.closure()))
    }

    /// The simplices one dimension below the top of a pure complex that have one coface.
    fn boundary_ridges(&self) -> Result<Vec<Simplex>, Error> {
        self.require_complex()?;
        if let Some(witness) = self.first_not_in_top() {
            return Err(Error::new(
                ErrorKind::NotPure,
                format!(
                    "{witness} is a face of no simplex of dimension {}: the complex is not pure",
                    self.levels.len() - 1
                ),
            )
            .with_cells([witness.numbers()])
            .with_cure("take the boundary of a part all of whose facets have one dimension"));
        }
        let Some(top) = self.levels.last() else { return Ok(Vec::new()) };
        let mut ridges: Vec<Simplex> =
            top.iter().flat_map(|simplex| simplex.facets().map(|(_, facet)| facet)).collect();
        ridges.sort_unstable();
        Ok(ridges
            .chunk_by(|a, b| a == b)
            .filter(|same| same.len() == 1)
            .map(|same| same[0].clone())
            .collect())
    }

    /// The first member of a complex that is maximal but not of the top dimension.
    pub(super) fn first_not_in_top(&self) -> Option<Simplex> {
        let top = self.dimension()?;
        let maximal = self.maximal_simplices();
        maximal.into_simplices().find(|simplex| simplex.dimension() < top)
    }
}

impl FromIterator<Simplex> for SimplexSet {
    fn from_iter<I: IntoIterator<Item = Simplex>>(simplices: I) -> Self {
        let mut levels: Vec<Vec<Simplex>> = Vec::new();
        for simplex in simplices {
            let dimension = simplex.dimension();
            if levels.len() <= dimension {
                levels.resize(dimension + 1, Vec::new());
            }
            levels[dimension].push(simplex);
        }
        Self::from_levels(levels)
    }
}

impl From<Simplex> for SimplexSet {
    fn from(simplex: Simplex) -> Self {
        [simplex].into_iter().collect()
    }
}

impl From<&Simplex> for SimplexSet {
    fn from(simplex: &Simplex) -> Self {
        simplex.clone().into()
    }
}

impl From<&SimplexSet> for SimplexSet {
    fn from(set: &SimplexSet) -> Self {
        set.clone()
    }
}

impl From<&SimplicialComplex> for SimplexSet {
    fn from(complex: &SimplicialComplex) -> Self {
        complex.iter().collect()
    }
}

impl fmt::Debug for SimplexSet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_set().entries(self.iter()).finish()
    }
}

/// Neighborhoods of any set S of simplices of the complex, which need not be a complex itself. A single simplex is
/// passed as such, a set as [`SimplexSet`], a subcomplex by reference.
impl SimplicialComplex {
    /// The star $\operatorname{St}(S)$: all simplices that have a member of S as a face. In general no complex.
    ///
    /// # Errors
    /// [`ErrorKind::NotInComplex`] naming the members that are not in the complex.
    ///
    /// # Complexity
    /// $O(m \log m)$ beyond the search of the cofaces, for m cofaces counted once for each member.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::{Simplex, SimplicialComplex};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = SimplicialComplex::from_facets([[0, 1, 2]])?;
    /// assert_eq!(triangle.star(&Simplex::from([0]))?.f_vector(), [1, 2, 1]);
    /// # Ok(()) }
    /// ```
    pub fn star(&self, of: impl Into<SimplexSet>) -> Result<SimplexSet, Error> {
        let of = of.into();
        self.require_members(&of)?;
        Ok(of.iter().flat_map(|simplex| self.cofaces(simplex)).collect())
    }

    /// The closure $\operatorname{Cl}(S)$: the smallest subcomplex that holds S.
    ///
    /// # Errors
    /// [`ErrorKind::NotInComplex`] naming the members that are not in the complex.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::{Simplex, SimplicialComplex};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let complex = SimplicialComplex::from_facets([[0, 1, 2], [1, 2, 3]])?;
    /// assert_eq!(complex.closure(&Simplex::from([1, 2]))?.f_vector(), [2, 1]);
    /// # Ok(()) }
    /// ```
    pub fn closure(&self, of: impl Into<SimplexSet>) -> Result<SimplicialComplex, Error> {
        let of = of.into();
        self.require_members(&of)?;
        of.spanned_complex()
    }

    /// The link: what the neighborhood of S leaves when everything touching it is taken away.
    ///
    /// $\operatorname{Lk}(S) = \operatorname{Cl}(\operatorname{St}(S)) \setminus \operatorname{St}(\operatorname{Cl}(S))$:
    /// the closure of the star minus the star of the closure. For one simplex s these are the simplices t disjoint from s
    /// such that t and s together span a simplex. A vertex of a closed surface has a circle as its link. The link of
    /// a set is not the union of the links of its members; that of the empty set, and of a facet, is empty.
    ///
    /// The star of the closure holds all simplices with a vertex in common with S, and what is left of a simplex of the
    /// star without these vertices is in the closed star; so the link is found without making either.
    ///
    /// # Errors
    /// [`ErrorKind::NotInComplex`] naming the members that are not in the complex.
    ///
    /// # Complexity
    /// As [`Self::star`].
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::{Simplex, SimplicialComplex};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = SimplicialComplex::from_facets([[0, 1, 2]])?;
    /// let link = triangle.link(&Simplex::from([0]))?;
    /// assert!(link.contains(&Simplex::from([1, 2])));
    /// # Ok(()) }
    /// ```
    pub fn link(&self, of: impl Into<SimplexSet>) -> Result<SimplicialComplex, Error> {
        let of = of.into();
        // The link of one simplex, by far the most frequent, is cut out of the tree without being sorted again.
        if let (1, Some(simplex)) = (of.len(), of.iter().next()) {
            return self.link_of(simplex);
        }
        self.link_simplices(of)?.spanned_complex()
    }

    /// The simplices of [`Self::link`] as a set: quicker to make than the complex.
    ///
    /// # Errors
    /// [`ErrorKind::NotInComplex`] naming the members that are not in the complex.
    pub fn link_simplices(&self, of: impl Into<SimplexSet>) -> Result<SimplexSet, Error> {
        let of = of.into();
        self.require_members(&of)?;
        let touched: Vec<u32> = of.vertices().into_iter().map(VertexId::to_u32).collect();
        let mut rest = Vec::new();
        let outside = |simplex: Simplex| {
            rest.clear();
            rest.extend(simplex.numbers().iter().copied().filter(|v| touched.binary_search(v).is_err()));
            (!rest.is_empty()).then(|| Simplex::from_sorted(&rest))
        };
        Ok(of.iter().flat_map(|simplex| self.cofaces(simplex)).filter_map(outside).collect())
    }

    /// The boundary bd(S) of a pure subcomplex S: see [`SimplexSet::boundary_complex`]. That of the whole complex is
    /// `complex.boundary_complex(&complex)`.
    ///
    /// # Errors
    /// [`ErrorKind::NotInComplex`] naming the members that are not in the complex; [`ErrorKind::NotAComplex`] and
    /// [`ErrorKind::NotPure`] with a witness.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::SimplicialComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let disk = SimplicialComplex::from_facets([[0, 1, 2], [1, 2, 3]])?;
    /// assert_eq!(disk.boundary_complex(&disk)?.f_vector(), [4, 4]);
    /// # Ok(()) }
    /// ```
    pub fn boundary_complex(&self, of: impl Into<SimplexSet>) -> Result<SimplicialComplex, Error> {
        let of = of.into();
        self.require_members(&of)?;
        of.boundary_complex()
    }

    /// The interior of a pure subcomplex S, S minus bd(S): see [`SimplexSet::interior`].
    ///
    /// # Errors
    /// As [`Self::boundary_complex`].
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::{Simplex, SimplicialComplex};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let disk = SimplicialComplex::from_facets([[0, 1, 2], [1, 2, 3]])?;
    /// assert_eq!(disk.interior(&disk)?.simplices(1), [Simplex::from([1, 2])]);
    /// # Ok(()) }
    /// ```
    pub fn interior(&self, of: impl Into<SimplexSet>) -> Result<SimplexSet, Error> {
        let of = of.into();
        self.require_members(&of)?;
        of.interior()
    }

    /// An error that names the members of a set that are not in the complex, if there are any.
    pub(super) fn require_members(&self, set: &SimplexSet) -> Result<(), Error> {
        let absent: Vec<&Simplex> = set.iter().filter(|simplex| !self.contains(simplex)).collect();
        if absent.is_empty() {
            return Ok(());
        }
        const SHOWN: usize = 8;
        let names: Vec<String> = absent.iter().take(SHOWN).map(|simplex| simplex.to_string()).collect();
        let more =
            if absent.len() > SHOWN { format!(" and {} more", absent.len() - SHOWN) } else { String::new() };
        let (word, verb) = if absent.len() == 1 { ("simplex", "is") } else { ("simplices", "are") };
        Err(Error::new(
            ErrorKind::NotInComplex,
            format!("the {word} {}{more} {verb} not in the complex", names.join(", ")),
        )
        .with_cells(absent.iter().map(|simplex| simplex.numbers()))
        .with_cure("name simplices of the complex by the numbers of its vertices"))
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use proptest::prelude::*;

    fn complex(facets: &[&[u32]]) -> SimplicialComplex {
        SimplicialComplex::from_facets(facets).unwrap()
    }

    fn set<const N: usize>(simplices: [&[u32]; N]) -> SimplexSet {
        simplices.into_iter().map(|s| Simplex::from_numbers(s).unwrap()).collect()
    }

    /// Random complexes with few vertices, and a random part of their simplices.
    pub(in super::super) fn complex_and_part() -> impl Strategy<Value = (SimplicialComplex, SimplexSet)> {
        prop::collection::vec(prop::collection::btree_set(0u32..8, 1..5), 0..8).prop_flat_map(|facets| {
            let facets: Vec<Vec<u32>> = facets.into_iter().map(|f| f.into_iter().collect()).collect();
            let complex = SimplicialComplex::from_facets(&facets).unwrap();
            let all: Vec<Simplex> = complex.iter().collect();
            let count = all.len();
            prop::collection::vec(prop::bool::weighted(0.2), count).prop_map(move |chosen| {
                let part = all.iter().zip(chosen).filter(|(_, c)| *c).map(|(s, _)| s.clone()).collect();
                (complex.clone(), part)
            })
        })
    }

    // The definitions, word for word.
    fn star_by_definition(k: &SimplicialComplex, s: &SimplexSet) -> SimplexSet {
        k.iter().filter(|t| s.iter().any(|face| face.is_face_of(t))).collect()
    }
    fn closure_by_definition(k: &SimplicialComplex, s: &SimplexSet) -> SimplexSet {
        k.iter().filter(|t| s.iter().any(|member| t.is_face_of(member))).collect()
    }
    fn link_by_definition(k: &SimplicialComplex, s: &SimplexSet) -> SimplexSet {
        closure_by_definition(k, &star_by_definition(k, s))
            .difference(&star_by_definition(k, &closure_by_definition(k, s)))
    }
    fn boundary_by_definition(k: &SimplexSet) -> SimplexSet {
        let proper = |t: &&Simplex| k.iter().filter(|s| *t != *s && t.is_face_of(s)).count() == 1;
        k.iter().filter(proper).cloned().collect::<SimplexSet>().closure()
    }

    proptest! {
        #[test]
        fn star_closure_link_follow_their_definitions((k, s) in complex_and_part()) {
            prop_assert_eq!(k.star(&s).unwrap(), star_by_definition(&k, &s));
            prop_assert_eq!(SimplexSet::from(&k.closure(&s).unwrap()), closure_by_definition(&k, &s));
            prop_assert_eq!(s.closure(), closure_by_definition(&k, &s));
            let link = k.link(&s).unwrap();
            prop_assert_eq!(SimplexSet::from(&link), link_by_definition(&k, &s));
            prop_assert_eq!(k.link_simplices(&s).unwrap(), link_by_definition(&k, &s));
        }

        #[test]
        fn closure_and_star_are_idempotent_and_distribute((k, s) in complex_and_part(), cut in 0usize..100) {
            let star = k.star(&s).unwrap();
            prop_assert_eq!(&k.star(&star).unwrap(), &star);
            prop_assert_eq!(s.closure().closure(), s.closure());
            prop_assert!(s.closure().is_complex());
            let (a, b): (Vec<_>, Vec<_>) = s.iter().cloned().enumerate().partition(|(i, _)| *i < cut % (s.len() + 1));
            let [a, b] = [a, b].map(|part| part.into_iter().map(|(_, s)| s).collect::<SimplexSet>());
            prop_assert_eq!(k.star(&a).unwrap().union(&k.star(&b).unwrap()), star);
            prop_assert_eq!(a.closure().union(&b.closure()), s.closure());
        }

        #[test]
        fn the_link_of_one_simplex_is_what_joins_it((k, _) in complex_and_part()) {
            for s in k.iter() {
                let joined: SimplexSet = k.iter().filter(|t| t.is_disjoint(&s) && k.contains(&t.union(&s))).collect();
                prop_assert_eq!(SimplexSet::from(&k.link(&s).unwrap()), joined.clone());
                prop_assert_eq!(k.link_simplices(&s).unwrap(), joined);
            }
        }

        #[test]
        fn boundary_and_interior_follow_their_definitions((k, _) in complex_and_part()) {
            let all = SimplexSet::from(&k);
            let top = k.dimension().unwrap_or(0);
            let pure = k.facets().iter().all(|facet| facet.dimension() == top);
            match k.boundary_complex(&k) {
                Ok(boundary) => {
                    prop_assert!(pure);
                    prop_assert_eq!(SimplexSet::from(&boundary), boundary_by_definition(&all));
                    let interior = k.interior(&k).unwrap();
                    prop_assert_eq!(interior.union(&SimplexSet::from(&boundary)), all);
                    prop_assert!(interior.intersection(&SimplexSet::from(&boundary)).is_empty());
                }
                Err(error) => {
                    prop_assert!(!pure);
                    prop_assert_eq!(error.kind(), ErrorKind::NotPure);
                }
            }
            // The part of top dimension is pure.
            let part: SimplexSet = k.simplices(top).collect::<SimplexSet>().closure();
            prop_assert_eq!(SimplexSet::from(&k.boundary_complex(&part).unwrap()), boundary_by_definition(&part));
        }

        #[test]
        fn missing_faces_and_maximal_simplices((k, s) in complex_and_part()) {
            prop_assert_eq!(s.is_complex(), s.missing_faces().is_empty());
            prop_assert_eq!(s.union(&s.missing_faces()), s.closure());
            prop_assert_eq!(s.to_complex().is_ok(), s.is_complex());
            prop_assert_eq!(s.maximal_simplices().closure(), s.closure());
            let maximal: SimplexSet =
                s.iter().filter(|a| !s.iter().any(|b| *a != b && a.is_face_of(b))).cloned().collect();
            prop_assert_eq!(s.maximal_simplices(), maximal);
            prop_assert_eq!(SimplexSet::from(&k).maximal_simplices(), k.facets().into_iter().collect::<SimplexSet>());
        }
    }

    #[test]
    fn the_link_does_not_distribute_over_union() {
        let triangle = complex(&[&[0, 1, 2]]);
        let both = set([&[0], &[1]]);
        assert_eq!(triangle.link_simplices(&both).unwrap(), set([&[2]]));
        let single = triangle.link_simplices(Simplex::from([0])).unwrap();
        assert_eq!(single, set([&[1], &[2], &[1, 2]]));
    }

    #[test]
    fn links_in_the_boundary_of_a_tetrahedron() {
        let sphere = complex(&[&[0, 1, 2], &[0, 1, 3], &[0, 2, 3], &[1, 2, 3]]);
        assert_eq!(sphere.link_simplices(Simplex::from([0, 1])).unwrap(), set([&[2], &[3]]));
        assert!(sphere.link(Simplex::from([0, 1, 2])).unwrap().is_empty());
        assert!(sphere.link(SimplexSet::new()).unwrap().is_empty());
        assert_eq!(sphere.link(Simplex::from([0])).unwrap().f_vector(), [3, 3]);
    }

    #[test]
    fn the_boundary_of_a_boundary_may_be_a_point() {
        let [v, a, b, c, d] = [0, 1, 2, 3, 4];
        let fan = complex(&[&[v, a, b], &[v, b, c], &[v, c, a], &[v, a, d]]);
        let boundary = fan.boundary_complex(&fan).unwrap();
        let twice = boundary.boundary_complex(&boundary).unwrap();
        assert_eq!(SimplexSet::from(&twice), set([&[v]]));
    }

    #[test]
    fn points_have_no_boundary() {
        let points = complex(&[&[3], &[5]]);
        assert!(points.boundary_complex(&points).unwrap().is_empty());
        assert_eq!(points.interior(&points).unwrap().len(), 2);
        assert!(SimplexSet::new().boundary_complex().unwrap().is_empty());
    }

    #[test]
    fn faults_name_their_witness() {
        let triangle = complex(&[&[0, 1, 2], &[2, 3]]);
        let error = triangle.star(set([&[0], &[0, 3], &[7]])).unwrap_err();
        assert_eq!(error.kind(), ErrorKind::NotInComplex);
        assert_eq!(error.message(), "the simplices {7}, {0, 3} are not in the complex");
        let error = triangle.boundary_complex(&triangle).unwrap_err();
        assert_eq!(error.kind(), ErrorKind::NotPure);
        assert!(error.message().starts_with("{2, 3} is a face of no simplex of dimension 2"));
        let error = triangle.boundary_complex(Simplex::from([0, 1, 2])).unwrap_err();
        assert_eq!(error.kind(), ErrorKind::NotAComplex);
        assert!(error.message().contains("{0, 1, 2} without its face {1, 2}"));
        let many: SimplexSet = (10..30).map(|v| Simplex::from([v])).collect();
        assert!(triangle.link(&many).unwrap_err().message().contains("{17} and 12 more are"));
    }
}
