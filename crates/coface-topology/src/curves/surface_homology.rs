//! First homology and cohomology of surfaces by crossing numbers, in linear time.

use super::{ClosedWalk, TreeCotree};
use crate::homology::Bounding;
use coface_algebra::Integer;
use coface_algebra::chains::{Chain, Cochain};
use coface_algebra::progress::stage;
use coface_algebra::{CellId, EdgeId, Error, ErrorKind, FaceId, HalfedgeId};
use coface_complexes::surface::GeneralizedMap;

/// The first homology of a surface in the loops of a [`TreeCotree`]: how often cycles run through each generator, and
/// the chains of faces that they bound.
///
/// A cycle is pushed off the edges that the cotree crosses, through the faces and out by the cotree's exits: to the
/// outside, or to the root of a closed component. What remains runs through generators and the tree only, and the
/// number of times that it runs through a generator is a linear function of the cycle: the generator's **crossing
/// cochain**. It is closed, but perhaps at the root of a component that is closed and not orientable. There all
/// generators together have one relation, the rim of the root pushed off: the **relation** has a coefficient 0, 2 or -2
/// for each of them.
///
/// # Conventions
/// Generators are numbered through all components, in the order of the components.
///
/// # References
/// D. Eppstein, *Dynamic generators of topologically embedded graphs* (2003); O. Busaryev, S. Cabello, C. Chen, T. K.
/// Dey, Y. Wang, *Annotating simplices with a homology basis and its applications* (2012), for classes of edges.
///
/// # Examples
/// ```
/// use coface_complexes::known_spaces;
/// use coface_complexes::surface::GeneralizedMap;
/// use coface_topology::{Bounding, SurfaceHomology, TreeCotree};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let torus = GeneralizedMap::new(known_spaces::cyclic_torus(2)?.freeze().two_skeleton()?)?;
/// let trees = TreeCotree::new(&torus);
/// let homology = SurfaceHomology::new(&torus, &trees);
/// let second = &homology.loops()[1];
/// assert_eq!(homology.class_of_walk(second)?, [0, 1]);
/// assert!(matches!(homology.bounding(&second.chain())?, Bounding::Never { .. }));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct SurfaceHomology<'a> {
    map: &'a GeneralizedMap,
    trees: &'a TreeCotree,
    /// The generators of all components, and the component of each.
    generators: Vec<(EdgeId, usize)>,
    /// The crossing cochain of each generator: its values that are not zero, by rising edges.
    crossings: Vec<Vec<(u32, i64)>>,
    relation: Vec<i64>,
    /// The generators (number, value) that each edge crosses: those of edge e from position `starts[e]` on.
    starts: Vec<u32>,
    by_edge: Vec<(u32, i64)>,
}

impl<'a> SurfaceHomology<'a> {
    /// Finds the crossing cochains.
    ///
    /// # Complexity
    /// Linear, and the ways in the cotree from each generator to the root.
    ///
    /// # Panics
    /// If the trees are not of this surface.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{SurfaceHomology, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// let homology = SurfaceHomology::new(&torus, &trees);
    /// assert_eq!(homology.generators().len(), 2);
    /// # Ok(()) }
    /// ```
    pub fn new(map: &'a GeneralizedMap, trees: &'a TreeCotree) -> Self {
        let generators: Vec<(EdgeId, usize)> = trees
            .components()
            .iter()
            .enumerate()
            .flat_map(|(i, component)| component.generators().iter().map(move |&edge| (edge, i)))
            .collect();
        let steps = stage("finding what generators cross", generators.len());
        let (crossings, relation): (Vec<_>, Vec<_>) =
            steps.each(&generators).map(|&(edge, _)| crossing(map, trees, edge)).unzip();
        let edge_count = map.skeleton().edge_count();
        let mut starts = vec![0u32; edge_count + 1];
        crossings.iter().flatten().for_each(|&(edge, _): &(u32, i64)| starts[edge as usize + 1] += 1);
        for edge in 0..edge_count {
            starts[edge + 1] += starts[edge];
        }
        let mut ends = starts.clone();
        let mut by_edge = vec![(0, 0); starts[edge_count] as usize];
        for (number, crossing) in (0..).zip(&crossings) {
            for &(edge, value) in crossing {
                by_edge[ends[edge as usize] as usize] = (number, value);
                ends[edge as usize] += 1;
            }
        }
        Self { map, trees, generators, crossings, relation, starts, by_edge }
    }

    /// The edges of the generators.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::EdgeId;
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{SurfaceHomology, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// let homology = SurfaceHomology::new(&torus, &trees);
    /// assert!(homology.generators().eq([0, 1].map(EdgeId::new)));
    /// # Ok(()) }
    /// ```
    pub fn generators(&self) -> impl ExactSizeIterator<Item = EdgeId> + '_ {
        self.generators.iter().map(|&(edge, _)| edge)
    }

    /// The loop of each generator, without the way that it goes forth and back; see [`TreeCotree::simple_loop`].
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{SurfaceHomology, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// let homology = SurfaceHomology::new(&torus, &trees);
    /// assert_eq!(homology.loops()[0].steps(), [0]);
    /// # Ok(()) }
    /// ```
    pub fn loops(&self) -> Vec<ClosedWalk> {
        let walk = |&(edge, _): &(EdgeId, usize)| {
            ClosedWalk::new(self.map.skeleton(), self.trees.simple_loop(self.map, edge))
                .expect("an edge closed up along a tree is a closed walk")
        };
        let steps = stage("closing generators up", self.generators.len());
        steps.each(&self.generators).map(walk).collect()
    }

    /// The coefficient of each generator in the relation of its component: zero unless that is closed and not
    /// orientable, else 0, 2 or -2. The first homology is freely generated by the loops, but for the relations, one for
    /// each such component.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{SurfaceHomology, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// let homology = SurfaceHomology::new(&torus, &trees);
    /// assert_eq!(homology.relation(), [0, 0]);
    /// # Ok(()) }
    /// ```
    pub fn relation(&self) -> &[i64] {
        &self.relation
    }

    /// Closed cochains that are a basis of the first cohomology over Z, and the value of each on each loop.
    ///
    /// In a component that is orientable or has a boundary they are dual to the loops. In one of k loops that is closed
    /// and not orientable there are k - 1: for a pivot p with coefficient $r_p \ne 0$ in the relation and each other
    /// loop i the cochain with the value 1 on loop i and $-r_i / r_p$ on loop p.
    ///
    /// # Complexity
    /// Linear in the values that are not zero.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{SurfaceHomology, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// let homology = SurfaceHomology::new(&torus, &trees);
    /// assert_eq!(homology.cocycles().1, [[1, 0], [0, 1]]);
    /// # Ok(()) }
    /// ```
    pub fn cocycles(&self) -> (Vec<Cochain<Integer>>, Vec<Vec<i64>>) {
        let pivots = self.pivots();
        let (mut cocycles, mut values) = (Vec::new(), Vec::new());
        for (i, &(_, component)) in self.generators.iter().enumerate() {
            let mut row = vec![0; self.generators.len()];
            row[i] = 1;
            let mut terms = self.crossings[i].clone();
            match pivots[component] {
                Some(pivot) if pivot == i => continue,
                Some(pivot) if self.relation[i] != 0 => {
                    row[pivot] = -self.relation[i] / self.relation[pivot];
                    terms.extend(self.crossings[pivot].iter().map(|&(edge, x)| (edge, x * row[pivot])));
                }
                _ => {}
            }
            cocycles.push(cochain(terms));
            values.push(row);
        }
        (cocycles, values)
    }

    /// The numbers of the generators whose loops are a basis of the first homology modulo torsion: all but the pivots
    /// of relations. On these loops the values of [`Self::cocycles`] are the identity.
    pub(super) fn free_generators(&self) -> Vec<usize> {
        let pivots = self.pivots();
        let numbered = self.generators.iter().enumerate();
        numbered.filter(|&(i, &(_, component))| pivots[component] != Some(i)).map(|(i, _)| i).collect()
    }

    /// For each component the first generator that its relation has.
    fn pivots(&self) -> Vec<Option<usize>> {
        let mut pivots = vec![None; self.trees.components().len()];
        for (i, &(_, component)) in self.generators.iter().enumerate() {
            if self.relation[i] != 0 {
                pivots[component].get_or_insert(i);
            }
        }
        pivots
    }

    /// How often a closed walk runs through each generator when it is pushed off all other edges but the tree. Where
    /// there is a relation, the multiple of it is added for which the first generator in it has the coefficient 0 or 1:
    /// then two walks are homologous if and only if their coefficients are the same.
    ///
    /// # Errors
    /// [`ErrorKind::NotInComplex`] naming an edge that is not there.
    ///
    /// # Complexity
    /// The length of the walk times the number of generators whose cotree loops it meets.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{ClosedWalk, SurfaceHomology, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// let homology = SurfaceHomology::new(&torus, &trees);
    /// let walk = |steps: &[u32]| ClosedWalk::new(torus.skeleton(), steps.to_vec());
    /// assert_eq!(homology.class_of_walk(&walk(&[0, 2, 2])?)?, [1, 2]);
    /// # Ok(()) }
    /// ```
    pub fn class_of_walk(&self, walk: &ClosedWalk) -> Result<Vec<i64>, Error> {
        let mut class = vec![0; self.generators.len()];
        for &step in walk.steps() {
            self.check_edge((step >> 1) as usize)?;
            let sign = if step & 1 == 0 { 1 } else { -1 };
            for &(generator, value) in self.crossed(step >> 1) {
                class[generator as usize] += sign * value;
            }
        }
        for (component, pivot) in self.pivots().into_iter().enumerate() {
            let Some(pivot) = pivot else { continue };
            let times = class[pivot].div_euclid(2) * self.relation[pivot].signum();
            for (i, &(_, own)) in self.generators.iter().enumerate() {
                if own == component {
                    class[i] -= times * self.relation[i];
                }
            }
        }
        Ok(class)
    }

    fn check_edge(&self, edge: usize) -> Result<(), Error> {
        let edge_count = self.map.skeleton().edge_count();
        if edge < edge_count {
            return Ok(());
        }
        Err(Error::new(
            ErrorKind::NotInComplex,
            format!("there is no edge {}; the surface has {edge_count}", EdgeId::new(edge)),
        ))
    }

    /// The generators whose crossing cochains do not vanish on an edge, with the values.
    pub(super) fn crossed(&self, edge: u32) -> &[(u32, i64)] {
        let [start, end] = [0, 1].map(|i| self.starts[edge as usize + i] as usize);
        &self.by_edge[start..end]
    }

    /// The generators whose crossing cochains are odd on an edge.
    pub(super) fn odd_crossings(&self, edge: u32) -> impl Iterator<Item = u32> + '_ {
        self.crossed(edge).iter().filter(|(_, value)| value % 2 != 0).map(|&(generator, _)| generator)
    }

    /// Whether a cycle of degree 1 bounds: the chain of faces, of its double if only that bounds, or a cocycle that
    /// shows that no multiple does.
    ///
    /// Two cycles are homologous if their difference bounds.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] for a chain of another degree; [`ErrorKind::NotInComplex`] naming an edge that is not
    /// there; [`ErrorKind::NotACycle`] naming a vertex in the boundary of the chain.
    ///
    /// # Complexity
    /// Linear in the surface, and the length of the chain times the number of generators.
    ///
    /// # Examples
    /// On the projective plane made of one digon the loop does not bound, but its double does.
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::TwoSkeleton;
    /// use coface_complexes::surface::GeneralizedMap;
    /// use coface_topology::{Bounding, SurfaceHomology, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let digon = TwoSkeleton::new(1, vec![0, 0], RaggedArray::from_lists([[0, 0]]))?;
    /// let plane = GeneralizedMap::new(digon)?;
    /// let trees = TreeCotree::new(&plane);
    /// let homology = SurfaceHomology::new(&plane, &trees);
    /// let cycle = homology.loops()[0].chain();
    /// let Bounding::MultipleBounds { multiple, chain } = homology.bounding(&cycle)? else { panic!() };
    /// assert_eq!((multiple, chain.to_string()), (2.into(), "c0".to_owned()));
    /// # Ok(()) }
    /// ```
    pub fn bounding(&self, cycle: &Chain<Integer>) -> Result<Bounding, Error> {
        self.check_cycle(cycle)?;
        let mut class = vec![Integer::ZERO; self.generators.len()];
        for (cell, coefficient) in cycle.terms() {
            for &(generator, value) in self.crossed(cell.to_u32()) {
                class[generator as usize] += &(coefficient * &Integer::from(value));
            }
        }
        // How often each relation is in the class, in halves: the double of the class is that many relations.
        let pivots = self.pivots();
        let halves: Vec<Integer> = pivots
            .iter()
            .map(|pivot| match *pivot {
                Some(pivot) if self.relation[pivot] > 0 => class[pivot].clone(),
                Some(pivot) => -&class[pivot],
                None => Integer::ZERO,
            })
            .collect();
        let rest = self.generators.iter().enumerate().find_map(|(i, &(_, component))| {
            let expected = &halves[component] * &Integer::from(self.relation[i] / 2);
            let value = &class[i] - &expected;
            (!value.is_zero()).then_some((i, value))
        });
        if let Some((generator, value)) = rest {
            // The cocycle of this generator vanishes on the relation; the pivot itself cannot be left.
            let mut terms = self.crossings[generator].clone();
            if let Some(pivot) = pivots[self.generators[generator].1] {
                let factor = -self.relation[generator] / self.relation[pivot];
                terms.extend(self.crossings[pivot].iter().map(|&(edge, x)| (edge, x * factor)));
            }
            return Ok(Bounding::Never { cocycle: cochain(terms), value });
        }
        let two = Integer::from(2);
        let is_odd = halves.iter().any(|half| !two.divides(half));
        let multiple = if is_odd { two } else { Integer::ONE };
        let chain = self.filling(cycle, &multiple, &halves)?;
        Ok(if is_odd { Bounding::MultipleBounds { multiple, chain } } else { Bounding::Bounds(chain) })
    }

    fn check_cycle(&self, cycle: &Chain<Integer>) -> Result<(), Error> {
        if cycle.degree() != 1 {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("a chain of degree {} where one of degree 1 is asked for", cycle.degree()),
            ));
        }
        let skeleton = self.map.skeleton();
        let mut sums = Vec::new();
        for (cell, coefficient) in cycle.terms() {
            self.check_edge(cell.index())?;
            let [source, target] = skeleton.edge(EdgeId::new(cell.index()));
            sums.push((CellId::new(target.index()), coefficient.clone()));
            sums.push((CellId::new(source.index()), -coefficient));
        }
        let boundary = Chain::of_cells(0, sums)?;
        match boundary.terms().first() {
            None => Ok(()),
            Some((vertex, value)) => Err(Error::new(
                ErrorKind::NotACycle,
                format!(
                    "the chain is not closed: vertex {vertex} has the coefficient {value} in its boundary"
                ),
            )
            .with_cure("give a sum of closed walks")),
        }
    }

    /// The chain of faces whose boundary is this multiple of a cycle of which that is known to bound. The coefficient
    /// of the root of each closed component follows from the relation, or is zero.
    fn filling(
        &self,
        cycle: &Chain<Integer>,
        multiple: &Integer,
        halves: &[Integer],
    ) -> Result<Chain<Integer>, Error> {
        let (map, trees) = (self.map, self.trees);
        let mut needed = vec![Integer::ZERO; map.skeleton().edge_count()];
        for (cell, coefficient) in cycle.terms() {
            needed[cell.index()] = coefficient * multiple;
        }
        let along = |side: HalfedgeId| if map.step(side) & 1 == 0 { Integer::ONE } else { -&Integer::ONE };
        let mut coefficients: Vec<Option<Integer>> = vec![None; map.skeleton().face_count()];
        let two = Integer::from(2);
        let mut way = Vec::new();
        let steps = stage("filling a cycle", coefficients.len());
        for face in steps.each(0..coefficients.len()) {
            // Up to a face whose coefficient is known, and down again.
            let mut at = FaceId::new(face);
            let mut above = loop {
                if let Some(known) = &coefficients[at.index()] {
                    break known.clone();
                }
                match trees.exit(at) {
                    None => {
                        // The rim of the root, pushed off, is the relation. Its exponents are those of the whole cycle.
                        let half = &halves[trees.component_of_face(at)] * multiple;
                        let root = half.exact_quotient(&two).unwrap_or(Integer::ZERO);
                        coefficients[at.index()] = Some(root.clone());
                        break root;
                    }
                    Some(side) => {
                        way.push(side);
                        match map.mate(side) {
                            Some(mate) => at = map.face(mate),
                            None => break Integer::ZERO,
                        }
                    }
                }
            };
            while let Some(side) = way.pop() {
                // On the edge of the exit both faces together have the coefficient that is needed.
                let beyond = map.mate(side).map_or(Integer::ZERO, |mate| &above * &along(mate));
                above = &(&needed[map.edge(side).index()] - &beyond) * &along(side);
                coefficients[map.face(side).index()] = Some(above.clone());
            }
        }
        let terms = coefficients.into_iter().enumerate();
        Chain::of_cells(2, terms.filter_map(|(face, x)| Some((CellId::new(face), x?))))
    }
}

fn cochain(terms: Vec<(u32, i64)>) -> Cochain<Integer> {
    let terms = terms.into_iter().map(|(edge, value)| (CellId::from_u32(edge), Integer::from(value)));
    Cochain::of_cells(1, terms).expect("integers can be added")
}

/// The crossing cochain of a generator, by rising edges, and the sum around the rim of the root of a closed component.
fn crossing(map: &GeneralizedMap, trees: &TreeCotree, edge: EdgeId) -> (Vec<(u32, i64)>, i64) {
    let first = map.first_side(edge);
    let mut steps = vec![2 * edge.to_u32()];
    let mut at_root = 0;
    // Faces on either side of the generator have a sum of their rims to get rid of.
    for side in std::iter::once(first).chain(map.mate(first)) {
        let mut face = map.face(side);
        // The step across which the sum is 1.
        let mut is_positive = map.step(side) & 1 == 1;
        loop {
            let Some(exit) = trees.exit(face) else {
                at_root += if is_positive { -1 } else { 1 };
                break;
            };
            steps.push(map.step(exit) ^ u32::from(!is_positive));
            let Some(mate) = map.mate(exit) else { break };
            face = map.face(mate);
            is_positive ^= !map.agrees(exit);
        }
    }
    steps.sort_unstable();
    let mut values: Vec<(u32, i64)> = Vec::new();
    for step in steps {
        let value = if step & 1 == 0 { 1 } else { -1 };
        match values.last_mut() {
            Some((edge, sum)) if *edge == step >> 1 => *sum += value,
            _ => values.push((step >> 1, value)),
        }
    }
    values.retain(|&(_, sum)| sum != 0);
    (values, at_root)
}
