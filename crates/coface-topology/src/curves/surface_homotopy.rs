//! Homotopy of closed walks on surfaces.

use super::{ClosedWalk, CutSurface, TreeCotree};
use crate::groups::{CanonicalSystem, NormalForm, SurfaceGroup};
use coface_algebra::Word;
use coface_algebra::{EdgeId, Error, ErrorKind};
use coface_complexes::surface::GeneralizedMap;

/// The fundamental groups of the components of a surface, with the words of walks: contractible or not, homotopic or
/// not.
///
/// # Conventions
/// Letters and bases are those of [`CutSurface`]: letter i is generator i of the component, counted from 1. Walks that
/// start elsewhere are moved along the tree to the base.
///
/// # References
/// F. Lazarus, J. Rivaud, *On the homotopy test on surfaces* (2012); J. Erickson, K. Whittlesey, *Transforming curves
/// on surfaces redux* (2013).
///
/// # Examples
/// On the torus made of one square the two loops commute.
/// ```
/// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
/// use coface_topology::{ClosedWalk, SurfaceHomotopy, TreeCotree};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
/// let trees = TreeCotree::new(&torus);
/// let homotopy = SurfaceHomotopy::new(&torus, &trees)?;
/// let walk = |steps: &[u32]| ClosedWalk::new(torus.skeleton(), steps.to_vec());
/// assert!(homotopy.is_contractible(&walk(&[0, 2, 1, 3])?)?);
/// assert!(homotopy.are_homotopic(&walk(&[0, 2])?, &walk(&[2, 0])?)?);
/// assert!(!homotopy.are_freely_homotopic(&walk(&[0])?, &walk(&[2])?)?);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct SurfaceHomotopy<'a> {
    map: &'a GeneralizedMap,
    trees: &'a TreeCotree,
    cut: CutSurface,
    groups: Vec<SurfaceGroup>,
}

impl<'a> SurfaceHomotopy<'a> {
    /// Cuts the surface and reads the relators.
    ///
    /// # Errors
    /// None for trees of this surface.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # Panics
    /// If the trees are not of this surface.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{SurfaceHomotopy, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// let homotopy = SurfaceHomotopy::new(&torus, &trees)?;
    /// assert_eq!(homotopy.groups().len(), 1);
    /// # Ok(()) }
    /// ```
    pub fn new(map: &'a GeneralizedMap, trees: &'a TreeCotree) -> Result<Self, Error> {
        let cut = CutSurface::new(map, trees);
        let group = |(component, found): (usize, &super::TreeCotreeComponent)| match cut.domains()[component]
            .relator()
        {
            Some(relator) => SurfaceGroup::closed(&relator),
            None => Ok(SurfaceGroup::free(found.generators().len())),
        };
        let groups = trees.components().iter().enumerate().map(group).collect::<Result<_, _>>()?;
        Ok(Self { map, trees, cut, groups })
    }

    /// The surface cut open.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{SurfaceHomotopy, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// let homotopy = SurfaceHomotopy::new(&torus, &trees)?;
    /// assert_eq!(homotopy.cut().domains()[0].side_count(), 4);
    /// # Ok(()) }
    /// ```
    pub fn cut(&self) -> &CutSurface {
        &self.cut
    }

    /// The fundamental groups, one for each component of the trees.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{SurfaceHomotopy, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// let homotopy = SurfaceHomotopy::new(&torus, &trees)?;
    /// assert_eq!(homotopy.groups()[0].name().to_string(), "Z^2");
    /// # Ok(()) }
    /// ```
    pub fn groups(&self) -> &[SurfaceGroup] {
        &self.groups
    }

    /// The component that a walk is in; `None` if it stays at an isolated vertex.
    ///
    /// # Errors
    /// [`ErrorKind::NotInComplex`] for a walk that is not of this surface.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{ClosedWalk, SurfaceHomotopy, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// let homotopy = SurfaceHomotopy::new(&torus, &trees)?;
    /// let walk = |steps: &[u32]| ClosedWalk::new(torus.skeleton(), steps.to_vec());
    /// assert_eq!(homotopy.component(&walk(&[0])?)?, Some(0));
    /// # Ok(()) }
    /// ```
    pub fn component(&self, walk: &ClosedWalk) -> Result<Option<usize>, Error> {
        let (vertex_count, edge_count) = (self.map.vertex_count(), self.map.edge_count());
        if let Some(step) = walk.steps().iter().find(|&&step| (step >> 1) as usize >= edge_count) {
            return Err(Error::new(
                ErrorKind::NotInComplex,
                format!("there is no edge {}; the surface has {edge_count}", EdgeId::from_u32(step >> 1)),
            ));
        }
        if walk.start().index() >= vertex_count {
            return Err(Error::new(
                ErrorKind::NotInComplex,
                format!("there is no vertex {}; the surface has {vertex_count}", walk.start()),
            ));
        }
        Ok(self.trees.component_of_vertex(walk.start()))
    }

    /// The word of a walk, freely reduced: see [`CutSurface::path_word`].
    ///
    /// # Errors
    /// As [`Self::component`].
    ///
    /// # Complexity
    /// The length of the walk times the number of generators of its component; linear while that is bounded.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{ClosedWalk, SurfaceHomotopy, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// let homotopy = SurfaceHomotopy::new(&torus, &trees)?;
    /// let walk = |steps: &[u32]| ClosedWalk::new(torus.skeleton(), steps.to_vec());
    /// assert_eq!(homotopy.word(&walk(&[0, 2])?)?.letters(), [1, 2]);
    /// # Ok(()) }
    /// ```
    pub fn word(&self, walk: &ClosedWalk) -> Result<Word, Error> {
        self.component(walk)?;
        Ok(self.cut.path_word(self.map, walk.steps()))
    }

    /// The element of the fundamental group that a walk is, moved along the tree to the base; `None` at an isolated
    /// vertex.
    ///
    /// # Errors
    /// As [`Self::component`].
    ///
    /// # Complexity
    /// Linear in the length of the walk on closed components, whatever their genus: a step leads from one corner of the
    /// fundamental polygon to another, which is two edges of the system of quadrangles. With a boundary as
    /// [`Self::word`].
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{ClosedWalk, SurfaceHomotopy, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// let homotopy = SurfaceHomotopy::new(&torus, &trees)?;
    /// let walk = |steps: &[u32]| ClosedWalk::new(torus.skeleton(), steps.to_vec());
    /// assert_eq!(homotopy.element(&walk(&[0, 2])?)?, homotopy.element(&walk(&[2, 0])?)?);
    /// # Ok(()) }
    /// ```
    pub fn element(&self, walk: &ClosedWalk) -> Result<Option<NormalForm>, Error> {
        let Some(component) = self.component(walk)? else { return Ok(None) };
        let (group, domain) = (&self.groups[component], &self.cut.domains()[component]);
        if domain.relator().is_none() {
            return Ok(Some(group.normal_form(&self.word(walk)?)));
        }
        let corners = walk.steps().iter().map(|&step| {
            let side = self.map.first_side(EdgeId::from_u32(step >> 1));
            let ends = [side, self.map.next(side)].map(|side| self.cut.corner_position(side));
            let [from, to] = ends.map(|position| domain.letters_before(position));
            if self.map.step(side) == step { [from, to] } else { [to, from] }
        });
        Ok(Some(group.element_of_steps(corners)))
    }

    /// Whether a walk can be contracted to a point.
    ///
    /// # Errors
    /// As [`Self::component`].
    ///
    /// # Complexity
    /// As [`Self::element`].
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{ClosedWalk, SurfaceHomotopy, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// let homotopy = SurfaceHomotopy::new(&torus, &trees)?;
    /// let walk = |steps: &[u32]| ClosedWalk::new(torus.skeleton(), steps.to_vec());
    /// assert!(homotopy.is_contractible(&walk(&[0, 2, 1, 3])?)?);
    /// assert!(!homotopy.is_contractible(&walk(&[0])?)?);
    /// # Ok(()) }
    /// ```
    pub fn is_contractible(&self, walk: &ClosedWalk) -> Result<bool, Error> {
        Ok(self.element(walk)?.is_none_or(|element| element.is_identity()))
    }

    /// Whether two walks from the same vertex can be deformed into each other while that stays where it is.
    ///
    /// # Errors
    /// As [`Self::component`]; [`ErrorKind::InvalidInput`] for walks from different vertices.
    ///
    /// # Complexity
    /// As [`Self::element`].
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{ClosedWalk, SurfaceHomotopy, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// let homotopy = SurfaceHomotopy::new(&torus, &trees)?;
    /// let walk = |steps: &[u32]| ClosedWalk::new(torus.skeleton(), steps.to_vec());
    /// assert!(homotopy.are_homotopic(&walk(&[0, 2])?, &walk(&[2, 0])?)?);
    /// # Ok(()) }
    /// ```
    pub fn are_homotopic(&self, a: &ClosedWalk, b: &ClosedWalk) -> Result<bool, Error> {
        if a.start() != b.start() {
            return Err(Error::invalid(format!(
                "the walks start at different vertices, {} and {}",
                a.start(),
                b.start()
            ))
            .with_cure("ask for free homotopy"));
        }
        Ok(self.element(a)? == self.element(b)?)
    }

    /// Whether two closed walks can be deformed into each other, wherever they start.
    ///
    /// # Errors
    /// As [`Self::component`].
    ///
    /// # Complexity
    /// As [`Self::element`] and [`SurfaceGroup::conjugacy_form`].
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{ClosedWalk, SurfaceHomotopy, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// let homotopy = SurfaceHomotopy::new(&torus, &trees)?;
    /// let walk = |steps: &[u32]| ClosedWalk::new(torus.skeleton(), steps.to_vec());
    /// assert!(homotopy.are_freely_homotopic(&walk(&[2, 0, 3])?, &walk(&[0])?)?);
    /// # Ok(()) }
    /// ```
    pub fn are_freely_homotopic(&self, a: &ClosedWalk, b: &ClosedWalk) -> Result<bool, Error> {
        match (self.component(a)?, self.component(b)?) {
            (Some(i), Some(j)) if i == j => {
                let [a, b] = [self.element(a)?, self.element(b)?];
                let class =
                    |element: Option<NormalForm>| element.map(|element| self.groups[i].class_of(element));
                Ok(class(a) == class(b))
            }
            (None, None) => Ok(a.start() == b.start()),
            _ => Ok(false),
        }
    }

    /// The closed walk at the base of a component that has this word: its loops one after another, without turning back
    /// on a step.
    ///
    /// # Panics
    /// If there is no such component or generator.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{SurfaceHomotopy, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// let homotopy = SurfaceHomotopy::new(&torus, &trees)?;
    /// let walk = homotopy.walk_of_word(0, &Word::from_letters([1, 2]));
    /// assert_eq!(walk.steps(), [0, 2]);
    /// # Ok(()) }
    /// ```
    pub fn walk_of_word(&self, component: usize, word: &Word) -> ClosedWalk {
        let found = &self.trees.components()[component];
        let mut steps: Vec<u32> = Vec::new();
        let mut push = |step: u32| {
            if steps.last() == Some(&(step ^ 1)) {
                steps.pop();
            } else {
                steps.push(step);
            }
        };
        for &letter in word.letters() {
            let edge = found.generators()[letter.unsigned_abs() as usize - 1];
            let around = self.trees.based_loop(self.map, edge);
            if letter > 0 {
                around.into_iter().for_each(&mut push);
            } else {
                around.into_iter().rev().for_each(|step| push(step ^ 1));
            }
        }
        if steps.is_empty() {
            return ClosedWalk::constant(found.base());
        }
        ClosedWalk::new(self.map.skeleton(), steps).expect("loops at a base are closed walks")
    }

    /// The canonical loops of a closed component as closed walks at its base: $a_1, b_1, a_2, b_2, \dots$ such that the
    /// product of their commutators can be contracted, or $c_1, c_2, \dots$ with squares. With them the system at the
    /// level of words. `None` where there is a boundary; none on a sphere, which has no loops.
    ///
    /// # Complexity
    /// The words have $O(n^2)$ letters in all for n generators, see [`SurfaceGroup::canonical_system`]; each is a loop.
    ///
    /// # References
    /// G. Vegter, C. K. Yap, *Computational complexity of combinatorial surfaces* (1990).
    ///
    /// # Panics
    /// If there is no such component.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::known_spaces;
    /// use coface_complexes::surface::GeneralizedMap;
    /// use coface_topology::{SurfaceHomotopy, TreeCotree, intersection_number};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = GeneralizedMap::new(known_spaces::cyclic_torus(2)?.freeze().two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// let homotopy = SurfaceHomotopy::new(&torus, &trees)?;
    /// let (loops, _) = homotopy.canonical_loops(0).expect("the torus is closed");
    /// assert_eq!(intersection_number(&torus, &loops[0], &loops[1])?.abs(), 1);
    /// # Ok(()) }
    /// ```
    pub fn canonical_loops(&self, component: usize) -> Option<(Vec<ClosedWalk>, CanonicalSystem)> {
        let system = self.groups[component].canonical_system()?;
        let walks = system.generators().iter().map(|word| self.walk_of_word(component, word)).collect();
        Some((walks, system))
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::curves::slicing_cocycle::intersection_number;
    use crate::curves::surface_homology::SurfaceHomology;
    use crate::homology::Bounding;
    use coface_algebra::VertexId;
    use coface_complexes::surface::samples::{all_kinds, genus, of_next};
    use proptest::prelude::*;

    /// A closed walk from the base that takes the choices in turn and goes back along the tree.
    pub(in crate::curves) fn random_walk(
        map: &GeneralizedMap,
        trees: &TreeCotree,
        choices: &[usize],
    ) -> Option<ClosedWalk> {
        let ends = map.skeleton().edge_ends();
        let base = trees.components()[0].base();
        let mut at = base;
        let mut steps = Vec::new();
        for &choice in choices {
            let out: Vec<u32> = (0..ends.len() as u32).filter(|&s| ends[s as usize] == at.to_u32()).collect();
            let step = out[choice % out.len()];
            steps.push(step);
            at = VertexId::from_u32(ends[(step ^ 1) as usize]);
        }
        steps.extend(trees.path_to(map, at).into_iter().rev().map(|step| step ^ 1));
        ClosedWalk::new(map.skeleton(), steps).ok()
    }

    /// The walk with one step replaced by the rest of a face around it, or with a detour forth and back.
    fn deformed(map: &GeneralizedMap, walk: &ClosedWalk, choice: usize) -> ClosedWalk {
        let mut steps = walk.steps().to_vec();
        let at = choice % steps.len();
        let step = steps[at];
        let side = map.sides().find(|&side| map.edge(side).to_u32() == step >> 1).unwrap();
        let rim: Vec<u32> = {
            let mut rim = Vec::new();
            let mut next = map.next(side);
            while next != side {
                rim.push(map.step(next));
                next = map.next(next);
            }
            // The rim without this side, backwards, runs as the side does.
            rim.iter().rev().map(|step| step ^ 1).collect()
        };
        let rim = if map.step(side) == step { rim } else { rim.iter().rev().map(|step| step ^ 1).collect() };
        steps.splice(at..=at, rim);
        match steps.is_empty() {
            true => ClosedWalk::constant(walk.start()),
            false => ClosedWalk::new(map.skeleton(), steps).unwrap(),
        }
    }

    #[test]
    fn canonical_loops_have_the_canonical_relator() {
        for (name, map) in all_kinds() {
            let trees = TreeCotree::new(&map);
            let homotopy = SurfaceHomotopy::new(&map, &trees).unwrap();
            let homology = SurfaceHomology::new(&map, &trees);
            for component in 0..trees.components().len() {
                let Some((loops, system)) = homotopy.canonical_loops(component) else { continue };
                let steps: Vec<u32> = (system.relator().letters().iter())
                    .flat_map(|&letter| {
                        let walk = &loops[letter.unsigned_abs() as usize - 1];
                        if letter > 0 { walk.steps().to_vec() } else { walk.reversed().steps().to_vec() }
                    })
                    .collect();
                let around = ClosedWalk::new(map.skeleton(), steps).unwrap();
                assert!(homotopy.is_contractible(&around).unwrap(), "{name}");
                assert!(matches!(homology.bounding(&around.chain()).unwrap(), Bounding::Bounds(_)), "{name}");
                if system.is_orientable() {
                    for (i, a) in loops.iter().enumerate() {
                        for (j, b) in loops.iter().enumerate() {
                            let expected = i64::from(i / 2 == j / 2 && i != j);
                            assert_eq!(intersection_number(&map, a, b).unwrap().abs(), expected, "{name}");
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn walks_in_different_places() {
        let two = of_next(vec![2, 3, 1, 0, 6, 7, 5, 4]);
        let trees = TreeCotree::new(&two);
        let homotopy = SurfaceHomotopy::new(&two, &trees).unwrap();
        let walk = |step| ClosedWalk::new(two.skeleton(), vec![step]).unwrap();
        assert!(!homotopy.are_freely_homotopic(&walk(0), &walk(4)).unwrap());
        assert_eq!(homotopy.are_homotopic(&walk(0), &walk(4)).unwrap_err().kind(), ErrorKind::InvalidInput);
        let other = genus(1);
        let long = ClosedWalk::new(other.skeleton(), vec![90, 91]).unwrap();
        assert_eq!(homotopy.is_contractible(&long).unwrap_err().kind(), ErrorKind::NotInComplex);
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(24))]

        #[test]
        fn deformations_are_homotopic(
            which in 0usize..19, choices in prop::collection::vec(0usize..64, 1..12),
            moves in prop::collection::vec(0usize..64, 1..6), turn in 0usize..64,
        ) {
            let (name, map) = all_kinds().swap_remove(which);
            let trees = TreeCotree::new(&map);
            let homotopy = SurfaceHomotopy::new(&map, &trees).unwrap();
            let homology = SurfaceHomology::new(&map, &trees);
            let Some(walk) = random_walk(&map, &trees, &choices) else { return Ok(()) };
            let mut other = walk.clone();
            for &choice in &moves {
                if !other.is_empty() {
                    other = deformed(&map, &other, choice);
                }
            }
            prop_assert!(homotopy.are_homotopic(&walk, &other).unwrap(), "{}", name);
            // From corner to corner and by words, an element is the same.
            for walk in [&walk, &other] {
                let Some(component) = homotopy.component(walk).unwrap() else { continue };
                let (group, word) = (&homotopy.groups()[component], homotopy.word(walk).unwrap());
                let element = homotopy.element(walk).unwrap().unwrap();
                prop_assert_eq!(&element, &group.normal_form(&word), "{}", name);
                prop_assert_eq!(group.class_of(element), group.conjugacy_form(&word), "{}", name);
            }
            let difference = walk.chain().minus(&other.chain()).unwrap();
            prop_assert!(matches!(homology.bounding(&difference).unwrap(), Bounding::Bounds(_)), "{}", name);
            // Started elsewhere.
            let mut steps = other.steps().to_vec();
            if !steps.is_empty() {
                let turn = turn % steps.len();
                steps.rotate_left(turn);
                let turned = ClosedWalk::new(map.skeleton(), steps).unwrap();
                prop_assert!(homotopy.are_freely_homotopic(&walk, &turned).unwrap(), "{}", name);
            }
            // A contractible walk bounds; what does not bound cannot be contracted.
            if homotopy.is_contractible(&walk).unwrap() {
                prop_assert!(matches!(homology.bounding(&walk.chain()).unwrap(), Bounding::Bounds(_)));
            }
            prop_assert!(homotopy.is_contractible(
                &ClosedWalk::new(map.skeleton(), [walk.steps(), walk.reversed().steps()].concat()).unwrap()).unwrap());
        }
    }
}
