//! Shortest cycles that cannot be contracted, or that do not separate.

use super::crossings;
use super::cut_vertices::cut_vertices;
use super::root_search::{Closing, LocalDual, RootSearch};
use super::shortest_paths::checked_lengths;
use super::{ClosedWalk, SurfaceHomology, SurfaceHomotopy, TreeCotree};
use coface_algebra::RaggedArray;
use coface_algebra::chains::TwoSkeleton;
use coface_algebra::progress::stage;
use coface_algebra::{Error, ErrorKind, VertexId};
use coface_complexes::surface::GeneralizedMap;
use std::borrow::Cow;

/// What a shortest cycle must not be.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum CycleKind {
    /// It cannot be contracted to a point.
    NonContractible,
    /// It does not separate the surface, its holes filled with disks.
    NonSeparating,
}

/// A closed walk with its length.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct ShortestCycle {
    walk: ClosedWalk,
    length: f64,
}

impl ShortestCycle {
    pub(super) fn new(walk: ClosedWalk, lengths: &[f64]) -> Self {
        let length = walk.steps().iter().map(|&step| lengths[(step >> 1) as usize]).sum();
        Self { walk, length }
    }

    /// The walk.
    pub fn walk(&self) -> &ClosedWalk {
        &self.walk
    }

    /// The sum of the lengths of its edges.
    pub fn length(&self) -> f64 {
        self.length
    }
}

/// The shortest closed walk of a kind through a vertex; `None` if its component has none.
///
/// It is an edge closed up along shortest paths, and may go forth and back on a way to the vertex. `lengths` has a
/// length for each edge; without it, each edge has the length 1. Of several shortest ones the edge with the lowest
/// number decides.
///
/// # Errors
/// [`ErrorKind::Shape`] and [`ErrorKind::InvalidInput`] for lengths that are not one for each edge, finite and not
/// negative; [`ErrorKind::NotInComplex`] for a vertex that is not there.
///
/// # Complexity
/// $O(n \log n)$, and the test of the loops that are not seen to bound a disk by the dual graph near the vertex.
///
/// # References
/// J. Erickson, S. Har-Peled, *Optimally cutting a surface into a disk* (2004), section 5.
///
/// # Examples
/// On a torus of 4 by 6 squares, each cut in two, every vertex is on a cycle of 4 edges.
/// ```
/// use coface_algebra::VertexId;
/// use coface_complexes::known_spaces;
/// use coface_complexes::surface::GeneralizedMap;
/// use coface_topology::{CycleKind, shortest_cycle_through};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let torus = GeneralizedMap::new(known_spaces::torus_grid(&[4, 6])?.freeze().two_skeleton()?)?;
/// let cycle = shortest_cycle_through(&torus, VertexId::new(3), None, CycleKind::NonContractible)?;
/// assert_eq!(cycle.expect("a torus has such cycles").length(), 4.0);
/// # Ok(()) }
/// ```
pub fn shortest_cycle_through(
    map: &GeneralizedMap,
    vertex: VertexId,
    lengths: Option<&[f64]>,
    kind: CycleKind,
) -> Result<Option<ShortestCycle>, Error> {
    if vertex.index() >= map.skeleton().vertex_count() {
        return Err(Error::new(
            ErrorKind::NotInComplex,
            format!("there is no vertex {vertex}; the surface has {}", map.skeleton().vertex_count()),
        ));
    }
    search(map, &[vertex.to_u32()], lengths, kind, usize::MAX)
}

/// The shortest cycle of a kind on the surface; `None` if there is none.
///
/// `lengths` is as for [`shortest_cycle_through`]. The searches may reach `most` vertices in all, each counted as often as it is
/// reached.
///
/// The surface is cut along shortest paths between holes and shortest loops, each of which such a cycle crosses at most once; a cycle that crosses a
/// cut is a path from a vertex on one side to the same vertex on the other, and the others lie on what is left. The shortest of these
/// paths is found by trees of shortest paths from the ends of intervals of a side, whose common parts are contracted. Where a component has a first Betti
/// number above 20, searches start from all vertices of a short cut graph instead: every such cycle meets one.
///
/// # Errors
/// As [`shortest_cycle_through`]; [`ErrorKind::TooLarge`] when more vertices than `most` are reached.
///
/// # Complexity
/// $O(b^2 n \log^2 n)$ for the first Betti number b, up to 20: b cuts, in which the trees of each of $\log n$ sizes of intervals have $O(b n)$
/// vertices together. On surfaces of higher genus $O(k r \log r)$ for k vertices on the cut graph and r vertices within half the length of the
/// cycle.
///
/// # References
/// S. Cabello, E. Chambers, J. Erickson, *Multiple-source shortest paths in embedded graphs* (2013); D. Das, E. Kipouridis, M. Probst Gutenberg, C.
/// Wulff-Nilsen, *A simple algorithm for multiple-source shortest paths in planar digraphs* (2022), for intervals and contraction; J. Erickson, S. Har-Peled,
/// *Optimally cutting a surface into a disk* (2004), section 5, and J. Erickson, K. Whittlesey, *Greedy optimal homotopy and homology generators* (2005),
/// for searches from cut graphs.
///
/// # Examples
/// ```
/// use coface_complexes::known_spaces;
/// use coface_complexes::surface::GeneralizedMap;
/// use coface_topology::{CycleKind, shortest_cycle};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let map = |space: coface_complexes::simplicial::SimplicialComplex| GeneralizedMap::new(space.freeze().two_skeleton()?);
/// let torus = map(known_spaces::cyclic_torus(2)?)?;
/// let cycle = shortest_cycle(&torus, None, CycleKind::NonContractible, 1_000)?;
/// assert_eq!(cycle.expect("a torus has such cycles").length(), 3.0);
/// let sphere = map(known_spaces::simplex_boundary(2)?)?;
/// assert_eq!(shortest_cycle(&sphere, None, CycleKind::NonContractible, 1_000)?, None);
/// # Ok(()) }
/// ```
pub fn shortest_cycle(
    map: &GeneralizedMap,
    lengths: Option<&[f64]>,
    kind: CycleKind,
    most: usize,
) -> Result<Option<ShortestCycle>, Error> {
    Ok(bounds(map, lengths, kind, most, None)?.cycle)
}

/// The best cycle that a search has found, and what no cycle of the kind falls below.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct CycleBounds {
    cycle: Option<ShortestCycle>,
    lower_bound: f64,
}

impl CycleBounds {
    /// The best cycle that is known; `None` if there is none of the kind.
    ///
    /// # Examples
    /// See [`shortest_cycle_until`].
    pub fn cycle(&self) -> Option<&ShortestCycle> {
        self.cycle.as_ref()
    }

    /// No cycle of the kind is shorter than this; infinite if there is none.
    ///
    /// # Examples
    /// See [`shortest_cycle_until`].
    pub fn lower_bound(&self) -> f64 {
        self.lower_bound
    }

    /// Whether the cycle is a shortest one.
    ///
    /// # Examples
    /// See [`shortest_cycle_until`].
    pub fn is_shortest(&self) -> bool {
        self.cycle.as_ref().is_none_or(|cycle| cycle.length <= self.lower_bound)
    }
}

/// The shortest cycle of a kind, or the best one and a lower bound when `is_over` says so between two searches. One cycle is found in any
/// case, where there is one.
///
/// First searches from some vertices of a cut graph give a lower bound of half of the length of the best cycle. Then the surface is cut as by
/// [`shortest_cycle`]; the lower bound rises again while the last cut is searched. On a component with a first Betti number above 20 it rises in rounds.
///
/// # Errors
/// Those of [`shortest_cycle`].
///
/// # Complexity
/// That of [`shortest_cycle`]; $O(n \log n)$ if it is over at once.
///
/// # References
/// Those of [`shortest_cycle`].
///
/// # Examples
/// ```
/// use coface_complexes::known_spaces;
/// use coface_complexes::surface::GeneralizedMap;
/// use coface_topology::{CycleKind, shortest_cycle_until};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let torus = GeneralizedMap::new(known_spaces::torus_grid(&[4, 6])?.freeze().two_skeleton()?)?;
/// let found = shortest_cycle_until(&torus, None, CycleKind::NonContractible, 1_000_000, &|| true)?;
/// assert!(found.cycle().is_some_and(|cycle| cycle.length() >= found.lower_bound()));
/// let found = shortest_cycle_until(&torus, None, CycleKind::NonContractible, 1_000_000, &|| false)?;
/// assert!(found.is_shortest() && found.lower_bound() == 4.0);
/// # Ok(()) }
/// ```
pub fn shortest_cycle_until(
    map: &GeneralizedMap,
    lengths: Option<&[f64]>,
    kind: CycleKind,
    most: usize,
    is_over: &dyn Fn() -> bool,
) -> Result<CycleBounds, Error> {
    bounds(map, lengths, kind, most, Some(is_over))
}

/// As [`shortest_cycle_until`]; without `is_over`, no time is spent on lower bounds.
fn bounds(
    map: &GeneralizedMap,
    lengths: Option<&[f64]>,
    kind: CycleKind,
    most: usize,
    is_over: Option<&dyn Fn() -> bool>,
) -> Result<CycleBounds, Error> {
    let lengths = checked_lengths(map, lengths)?;
    let map = &*searched(map, kind);
    let trees = TreeCotree::new(map);
    let generators = trees.components().iter().map(|component| component.generators().len());
    if generators.max().is_some_and(|most| most > MOST_GENERATORS) {
        return from_roots(map, &trees, &lengths, kind, most, is_over.unwrap_or(&|| false));
    }
    let mut known = Known::default();
    if let Some(is_over) = is_over {
        known = half_bound(map, &trees, &lengths, kind, most, is_over)?;
        if known.is_stopped {
            return Ok(CycleBounds { cycle: known.cycle, lower_bound: known.lower_bound });
        }
    }
    drop(trees);
    let lower_bound = known.lower_bound;
    let found = crossings::search(map, &lengths, kind, known, most, is_over.unwrap_or(&|| false))?;
    if found.reached > most {
        return Err(too_many(most));
    }
    // What is known of all cycles holds for those that were not searched for.
    let length = found.cycle.as_ref().map_or(f64::INFINITY, ShortestCycle::length);
    Ok(CycleBounds { lower_bound: found.lower_bound.max(lower_bound).min(length), cycle: found.cycle })
}

/// What is known before cuts are made.
#[derive(Default)]
pub(super) struct Known {
    pub(super) cycle: Option<ShortestCycle>,
    pub(super) lower_bound: f64,
    pub(super) reached: usize,
    is_stopped: bool,
}

/// A cycle, and a lower bound of half of its length: searches from vertices of a cut graph of which each is within a quarter of that length
/// from one.
fn half_bound(
    map: &GeneralizedMap,
    trees: &TreeCotree,
    lengths: &[f64],
    kind: CycleKind,
    most: usize,
    is_over: &dyn Fn() -> bool,
) -> Result<Known, Error> {
    let tests = Tests::new(map, trees, kind)?;
    let mut search = CycleSearch::new(map, lengths, &tests, most);
    let roots = search.started(trees)?;
    let mut is_stopped = false;
    for &root in &roots {
        if search.lower[root as usize] < search.bound() / 2.0 {
            is_stopped = is_over();
            if is_stopped {
                break;
            }
            search.look_from(root, search.bound())?;
        }
    }
    Ok(Known {
        lower_bound: search.lower_bound(&roots),
        cycle: search.best,
        reached: search.reached,
        is_stopped,
    })
}

/// As [`shortest_cycle_until`], by searches from all vertices of a cut graph.
pub(super) fn from_roots(
    map: &GeneralizedMap,
    trees: &TreeCotree,
    lengths: &[f64],
    kind: CycleKind,
    most: usize,
    is_over: &dyn Fn() -> bool,
) -> Result<CycleBounds, Error> {
    let tests = Tests::new(map, trees, kind)?;
    let mut search = CycleSearch::new(map, lengths, &tests, most);
    let roots = search.started(trees)?;
    search.deepen(&roots, is_over)?;
    Ok(CycleBounds { lower_bound: search.lower_bound(&roots), cycle: search.best })
}

/// The shortest closed walk of a kind at a vertex of a connected surface whose holes are filled if the kind wants that.
pub(super) fn loop_at(
    map: &GeneralizedMap,
    lengths: &[f64],
    kind: CycleKind,
    root: u32,
) -> Result<Option<ShortestCycle>, Error> {
    let trees = TreeCotree::new(map);
    if trees.components().iter().all(|component| component.generators().is_empty()) {
        return Ok(None);
    }
    let tests = Tests::new(map, &trees, kind)?;
    let mut search = CycleSearch::new(map, lengths, &tests, usize::MAX);
    search.look_from(root, f64::INFINITY)?;
    Ok(search.best)
}

/// Cuts that cycles cross once are looked for on surfaces of at most this first Betti number.
const MOST_GENERATORS: usize = 20;
/// A search that goes beyond what is needed by this factor rules out roots near its own.
const SLACK: f64 = 1.25;
/// The first round looks for cycles this much shorter than the best one known.
const FIRST_ROUND: f64 = 1.0 / 16.0;

/// Searches from several roots that share what they know.
struct CycleSearch<'a> {
    map: &'a GeneralizedMap,
    lengths: &'a [f64],
    tests: &'a Tests<'a>,
    search: RootSearch<'a>,
    best: Option<ShortestCycle>,
    /// No cycle of the kind through a vertex is shorter than this.
    lower: Vec<f64>,
    reached: usize,
    most: usize,
}

impl<'a> CycleSearch<'a> {
    fn new(map: &'a GeneralizedMap, lengths: &'a [f64], tests: &'a Tests<'a>, most: usize) -> Self {
        let lower = vec![0.0; map.skeleton().vertex_count()];
        Self {
            map,
            lengths,
            tests,
            search: RootSearch::new(map, lengths),
            best: None,
            lower,
            reached: 0,
            most,
        }
    }

    fn bound(&self) -> f64 {
        self.best.as_ref().map_or(f64::INFINITY, |best| best.length)
    }

    /// The vertices of a cut graph, after a search for some cycle on each component.
    fn started(&mut self, trees: &TreeCotree) -> Result<Vec<u32>, Error> {
        let vertices = cut_vertices(self.map, self.lengths).into_iter();
        let roots: Vec<u32> = vertices.filter(|&root| self.tests.is_searched(root)).collect();
        let mut is_started = vec![false; trees.components().len()];
        for &root in &roots {
            let component = trees.component_of_vertex(VertexId::from_u32(root));
            if component.is_some_and(|component| !std::mem::replace(&mut is_started[component], true)) {
                self.look_from(root, f64::INFINITY)?;
            }
        }
        Ok(roots)
    }

    /// No cycle is shorter than this, if each meets one of the roots.
    fn lower_bound(&self, roots: &[u32]) -> f64 {
        let lower = roots.iter().map(|&root| self.lower[root as usize]).fold(f64::INFINITY, f64::min);
        self.best.as_ref().map_or(f64::INFINITY, |best| best.length.min(lower))
    }

    /// Rounds of searches of growing radius, until nothing shorter than the best cycle can be there.
    fn deepen(&mut self, roots: &[u32], is_over: &dyn Fn() -> bool) -> Result<(), Error> {
        if self.best.is_none() {
            return Ok(());
        }
        let mut round = self.bound() * FIRST_ROUND;
        loop {
            let steps = stage("searching for a shortest cycle", roots.len());
            for &root in roots {
                steps.advance(1);
                let wanted = round.min(self.bound());
                if self.lower[root as usize] >= wanted {
                    continue;
                }
                if is_over() {
                    return Ok(());
                }
                self.look_from(root, wanted * SLACK)?;
            }
            // Lengths may be zero.
            if round >= self.bound() || self.bound() <= 0.0 {
                return Ok(());
            }
            round *= 2.0;
        }
    }

    /// Looks for the shortest loop of the kind at a root among those shorter than `bound`.
    fn look_from(&mut self, root: u32, bound: f64) -> Result<(), Error> {
        self.search.run(root, bound / 2.0);
        self.reached += self.search.reached().len();
        if self.reached > self.most {
            return Err(too_many(self.most));
        }
        let mut length = bound;
        for closing in self.tests.candidates(&self.search.local_dual(bound)) {
            let walk = ClosedWalk::new(self.map.skeleton(), self.search.loop_through(closing.edge))?;
            if self.tests.is_wanted(&walk)? {
                length = closing.length;
                if length < self.bound() {
                    self.best = Some(ShortestCycle { walk, length });
                }
                break;
            }
        }
        for &vertex in self.search.reached() {
            let lower = &mut self.lower[vertex as usize];
            *lower = lower.max(length - 2.0 * self.search.distance(vertex));
        }
        Ok(())
    }
}

/// What loops are tested by.
struct Tests<'a> {
    kind: CycleKind,
    trees: &'a TreeCotree,
    homotopy: SurfaceHomotopy<'a>,
    homology: SurfaceHomology<'a>,
}

impl<'a> Tests<'a> {
    fn new(map: &'a GeneralizedMap, trees: &'a TreeCotree, kind: CycleKind) -> Result<Self, Error> {
        let homotopy = SurfaceHomotopy::new(map, trees)?;
        Ok(Self { kind, trees, homotopy, homology: SurfaceHomology::new(map, trees) })
    }

    /// Whether the component of a vertex has loops that cannot be contracted.
    fn is_searched(&self, vertex: u32) -> bool {
        let component = self.trees.component_of_vertex(VertexId::from_u32(vertex));
        component.is_some_and(|component| !self.trees.components()[component].generators().is_empty())
    }

    /// The edges whose loops may be of the kind, shortest first.
    fn candidates(&self, dual: &LocalDual) -> Vec<Closing> {
        match self.kind {
            CycleKind::NonContractible => dual.pruned(),
            CycleKind::NonSeparating => dual.leftover(),
        }
    }

    fn is_wanted(&self, walk: &ClosedWalk) -> Result<bool, Error> {
        match self.kind {
            CycleKind::NonContractible => self.homotopy.is_contractible(walk).map(|yes| !yes),
            CycleKind::NonSeparating => {
                Ok(self.homology.class_of_walk(walk)?.iter().any(|coefficient| coefficient % 2 != 0))
            }
        }
    }
}

fn too_many(most: usize) -> Error {
    Error::new(
        ErrorKind::TooLarge,
        format!("the search for a shortest cycle reaches more than {most} vertices"),
    )
    .with_cure("raise the limit, ask for the shortest cycle through one vertex, or coarsen the surface")
}

/// The shortest closed walk of a kind through one of these vertices.
pub(super) fn search(
    map: &GeneralizedMap,
    roots: &[u32],
    lengths: Option<&[f64]>,
    kind: CycleKind,
    most: usize,
) -> Result<Option<ShortestCycle>, Error> {
    let lengths = checked_lengths(map, lengths)?;
    let map = &*searched(map, kind);
    let trees = TreeCotree::new(map);
    let tests = Tests::new(map, &trees, kind)?;
    let mut search = CycleSearch::new(map, &lengths, &tests, most);
    for &root in roots.iter().filter(|&&root| tests.is_searched(root)) {
        search.look_from(root, search.bound())?;
    }
    Ok(search.best)
}

/// The surface on which cycles of a kind are searched for: one around a hole separates nothing but the disk that fills it.
pub(super) fn searched(map: &GeneralizedMap, kind: CycleKind) -> Cow<'_, GeneralizedMap> {
    match kind {
        CycleKind::NonContractible => Cow::Borrowed(map),
        CycleKind::NonSeparating => Cow::Owned(with_holes_filled(map)),
    }
}

/// The surface with a face in each hole; vertices and edges keep their numbers.
pub(super) fn with_holes_filled(map: &GeneralizedMap) -> GeneralizedMap {
    let mut faces: RaggedArray = map.skeleton().faces().clone();
    for hole in map.boundary_loops() {
        let steps =
            hole.iter().map(|&(side, sign)| map.step(side) ^ u32::from(sign == coface_algebra::Sign::Minus));
        faces.push(&steps.collect::<Vec<u32>>());
    }
    let skeleton =
        TwoSkeleton::new(map.skeleton().vertex_count(), map.skeleton().edge_ends().to_vec(), faces)
            .expect("a boundary loop is a closed path");
    GeneralizedMap::new(skeleton).expect("a surface with its holes filled is a surface")
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_complexes::known_spaces;
    use coface_complexes::surface::samples::{all_kinds, of_next, with_holes};
    use proptest::prelude::*;

    /// All closed walks without repeated vertices, and through an edge forth only: by brute force.
    fn brute_force(map: &GeneralizedMap, lengths: &[f64], kind: CycleKind) -> Option<f64> {
        let filled = with_holes_filled(map);
        let test = if kind == CycleKind::NonSeparating { &filled } else { map };
        let trees = TreeCotree::new(test);
        let homotopy = SurfaceHomotopy::new(test, &trees).unwrap();
        let ends = map.skeleton().edge_ends();
        let mut best: Option<f64> = None;
        let mut stack: Vec<Vec<u32>> = (0..ends.len() as u32).map(|step| vec![step]).collect();
        while let Some(path) = stack.pop() {
            let length: f64 = path.iter().map(|step| lengths[(step >> 1) as usize]).sum();
            if best.is_some_and(|best| length >= best) {
                continue;
            }
            let (start, end) = (ends[path[0] as usize], ends[(path[path.len() - 1] ^ 1) as usize]);
            if start == end {
                let walk = ClosedWalk::new(map.skeleton(), path).unwrap();
                let is_wanted = match kind {
                    CycleKind::NonContractible => !homotopy.is_contractible(&walk).unwrap(),
                    // Of the faces of the filled surface: the edges of the cycle do not separate them.
                    CycleKind::NonSeparating => {
                        let edges: Vec<_> = walk
                            .steps()
                            .iter()
                            .map(|step| coface_algebra::EdgeId::from_u32(step >> 1))
                            .collect();
                        let mut faces = coface_algebra::UnionFind::new(test.skeleton().face_count());
                        for edge in (0..test.skeleton().edge_count()).map(coface_algebra::EdgeId::new) {
                            if !edges.contains(&edge) {
                                let [f, g] = test.dual_arc(edge).unwrap();
                                faces.unite(f.to_u32(), g.to_u32());
                            }
                        }
                        let component = trees.component_of_vertex(walk.start()).unwrap();
                        let mut of_component = (0..test.skeleton().face_count()).filter(|&face| {
                            trees.component_of_face(coface_algebra::FaceId::new(face)) == component
                        });
                        let first = of_component.next().unwrap() as u32;
                        of_component.all(|face| faces.same(first, face as u32))
                    }
                };
                if is_wanted {
                    best = Some(length);
                }
                continue;
            }
            let visited: Vec<u32> = path.iter().map(|&step| ends[step as usize]).collect();
            for step in 0..ends.len() as u32 {
                let next = ends[(step ^ 1) as usize];
                let is_new = !visited[1..].contains(&next) && next != end && step != path[path.len() - 1] ^ 1;
                if ends[step as usize] == end && is_new {
                    stack.push([&path[..], &[step]].concat());
                }
            }
        }
        best
    }

    fn check(name: &str, map: &GeneralizedMap, lengths: &[f64]) {
        for kind in [CycleKind::NonContractible, CycleKind::NonSeparating] {
            let found = shortest_cycle(map, Some(lengths), kind, usize::MAX).unwrap();
            let expected = brute_force(map, lengths, kind);
            match (&found, expected) {
                (None, None) => {}
                (Some(found), Some(expected)) => {
                    assert!((found.length() - expected).abs() < 1e-9, "{name} {kind:?} {found:?} {expected}");
                    let sum: f64 =
                        found.walk().steps().iter().map(|step| lengths[(step >> 1) as usize]).sum();
                    assert!((sum - expected).abs() < 1e-9);
                }
                other => panic!("{name} {kind:?}: {other:?}"),
            }
            // The best of all vertices is the best.
            let each = (0..map.skeleton().vertex_count()).filter_map(|vertex| {
                shortest_cycle_through(map, VertexId::new(vertex), Some(lengths), kind).unwrap()
            });
            let least = each.map(|cycle| cycle.length()).min_by(f64::total_cmp);
            assert_eq!(least.is_some(), expected.is_some());
            if let (Some(a), Some(b)) = (least, expected) {
                assert!((a - b).abs() < 1e-9, "{name} {kind:?}: {a} {b}");
            }
        }
    }

    #[test]
    fn small_surfaces_are_searched_by_brute_force() {
        for (name, map) in all_kinds() {
            if map.skeleton().edge_count() <= 24 {
                let unit = vec![1.0; map.skeleton().edge_count()];
                check(name, &map, &unit);
            }
        }
    }

    #[test]
    fn bad_requests_are_refused() {
        let torus = coface_complexes::surface::samples::map_of(known_spaces::cyclic_torus(2));
        let error = shortest_cycle(&torus, None, CycleKind::NonContractible, 3).unwrap_err();
        assert_eq!(error.kind(), ErrorKind::TooLarge);
        let error = shortest_cycle_through(&torus, VertexId::new(7), None, CycleKind::NonContractible);
        assert_eq!(error.unwrap_err().kind(), ErrorKind::NotInComplex);
        let error = shortest_cycle(&torus, Some(&[1.0]), CycleKind::NonContractible, 9).unwrap_err();
        assert_eq!(error.kind(), ErrorKind::Shape);
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(32))]

        #[test]
        fn surfaces_of_permutations_are_searched_by_brute_force(
            next in Just((0u32..14).collect::<Vec<_>>()).prop_shuffle(),
            lengths in prop::collection::vec(0u8..9, 7),
        ) {
            let lengths: Vec<f64> = lengths.into_iter().map(f64::from).collect();
            check("permutation", &of_next(next), &lengths);
        }

        #[test]
        fn surfaces_with_holes_are_searched_by_brute_force(
            removed in any::<u64>(), lengths in prop::collection::vec(1u8..5, 30),
        ) {
            for closed in [known_spaces::cyclic_torus(2), known_spaces::small_klein_bottle(), known_spaces::projective_plane()] {
                let closed = coface_complexes::surface::samples::map_of(closed);
                if let Some(map) = with_holes(&closed, removed & (removed >> 32)) {
                    let count = map.skeleton().edge_count();
                    let lengths: Vec<f64> = lengths[..count].iter().map(|&x| f64::from(x)).collect();
                    check("with holes", &map, &lengths);
                }
            }
        }
    }
}
