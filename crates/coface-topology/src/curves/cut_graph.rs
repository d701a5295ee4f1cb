//! Cut graphs without loose ends, as seams, and how they are made shorter.

mod seam_paths;

use seam_paths::{across_annulus, across_band};

use super::shortest_cycle::search;
use super::shortest_paths::checked_lengths;
use super::{CycleKind, EdgeRole, TreeCotree};
use coface_algebra::progress::stage;
use coface_algebra::{EdgeId, Error, FaceId, HalfedgeId, VertexId};
use coface_algebra::{RaggedArray, Sign, UnionFind};
use coface_complexes::surface::GeneralizedMap;
use std::fmt;

/// No step, no vertex.
const NONE: u32 = u32::MAX;

/// Edges in the interior of a surface such that each component, cut open along them, is a disk; without loose ends.
///
/// It consists of **seams**, paths between **corners**: vertices where one, three or more of its edges meet, and
/// vertices of the boundary. A disk needs no seam. A sphere gets a slit of two
/// edges of the tree, so that its sides differ in their ends; of one if there are no more, of none if it has a single
/// vertex.
///
/// # References
/// J. Erickson, S. Har-Peled, *Optimally cutting a surface into a disk* (2004).
///
/// # Examples
/// The torus with 7 vertices: of 8 edges that the cotree does not cross, those remain that no loose end has.
/// ```
/// use coface_complexes::known_spaces;
/// use coface_complexes::surface::GeneralizedMap;
/// use coface_topology::{CutGraph, SeamKind, TreeCotree};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let torus = GeneralizedMap::new(known_spaces::cyclic_torus(2)?.freeze().two_skeleton()?)?;
/// let graph = CutGraph::new(&torus, &TreeCotree::new(&torus), None)?.shortened(&torus, None, 10)?;
/// assert!(graph.seams().iter().all(|seam| seam.kind() == SeamKind::Handle));
/// let disk = torus.slice_edges(&graph.edges())?;
/// assert_eq!(disk.surface().surfaces()[0].to_string(), "disk");
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct CutGraph {
    seams: Vec<Seam>,
    is_cut: Vec<bool>,
}

/// What a surface is cut open at along a seam.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum SeamKind {
    /// It lies on a cycle of seams and boundary of an orientable surface: the seams of this kind together open the
    /// handles, two of a torus, up to 6g - 3 of genus g.
    Handle,
    /// It lies on a cycle of seams and boundary of a surface that is not orientable: the seams of this kind together
    /// open the crosscaps. [`Seam::is_reversing`] tells those along which a single one opens.
    Crosscap,
    /// It joins boundary loops, or the seams of handles and crosscaps with these or with each other: without it the
    /// graph and the boundary are not connected.
    Join,
    /// It opens a sphere.
    Slit,
}

impl fmt::Display for SeamKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Handle => "handle",
            Self::Crosscap => "crosscap",
            Self::Join => "join",
            Self::Slit => "slit",
        })
    }
}

/// A path of a [`CutGraph`] from corner to corner.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Seam {
    steps: Vec<u32>,
    ends: [VertexId; 2],
    kind: SeamKind,
    is_reversing: bool,
    length: f64,
}

impl Seam {
    /// The steps: 2e along edge e, 2e + 1 against it.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CutGraph, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// let graph = CutGraph::new(&torus, &trees, Some(&[2.0, 3.0]))?;
    /// assert_eq!(graph.seams()[0].steps(), [0]);
    /// # Ok(()) }
    /// ```
    pub fn steps(&self) -> &[u32] {
        &self.steps
    }

    /// The corners where it starts and ends. A seam without corners is a cycle; these are its first vertex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CutGraph, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// let graph = CutGraph::new(&torus, &trees, Some(&[2.0, 3.0]))?;
    /// assert_eq!(graph.seams()[0].ends(), [VertexId::new(0); 2]);
    /// # Ok(()) }
    /// ```
    pub fn ends(&self) -> [VertexId; 2] {
        self.ends
    }

    /// What is opened there.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CutGraph, SeamKind, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// let graph = CutGraph::new(&torus, &trees, Some(&[2.0, 3.0]))?;
    /// assert_eq!(graph.seams()[0].kind(), SeamKind::Handle);
    /// # Ok(()) }
    /// ```
    pub fn kind(&self) -> SeamKind {
        self.kind
    }

    /// Whether the disk, glued together again at this seam alone, becomes a Moebius band, and not an annulus.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::known_spaces;
    /// use coface_complexes::surface::GeneralizedMap;
    /// use coface_topology::{CutGraph, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let plane = GeneralizedMap::new(known_spaces::projective_plane()?.freeze().two_skeleton()?)?;
    /// let graph = CutGraph::new(&plane, &TreeCotree::new(&plane), None)?;
    /// assert!(graph.seams()[0].is_reversing());
    /// # Ok(()) }
    /// ```
    pub fn is_reversing(&self) -> bool {
        self.is_reversing
    }

    /// The sum of the lengths of its edges.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CutGraph, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// let graph = CutGraph::new(&torus, &trees, Some(&[2.0, 3.0]))?;
    /// assert_eq!(graph.seams()[1].length(), 3.0);
    /// # Ok(()) }
    /// ```
    pub fn length(&self) -> f64 {
        self.length
    }
}

impl CutGraph {
    /// The cut graph of a tree-cotree decomposition without its loose ends. `lengths` has a length for each edge;
    /// without it, each edge has the length 1.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::Shape`] and [`coface_algebra::ErrorKind::InvalidInput`] for lengths that are not
    /// one for each edge, finite and not negative.
    ///
    /// # Complexity
    /// Linear, and near-linear in the seams.
    ///
    /// # Panics
    /// If the trees are not of this surface.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CutGraph, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// let graph = CutGraph::new(&torus, &trees, Some(&[2.0, 3.0]))?;
    /// assert_eq!(graph.seams().len(), 2);
    /// # Ok(()) }
    /// ```
    pub fn new(map: &GeneralizedMap, trees: &TreeCotree, lengths: Option<&[f64]>) -> Result<Self, Error> {
        let lengths = checked_lengths(map, lengths)?;
        let is_inner = |edge: usize| map.mate(map.first_side(EdgeId::new(edge))).is_some();
        let roles = trees.roles().iter().enumerate();
        let mut is_cut: Vec<bool> =
            roles.map(|(edge, role)| *role != EdgeRole::Cotree && is_inner(edge)).collect();
        prune(map, &mut is_cut);
        for slit in slits(map, trees, &lengths).into_iter().flatten() {
            is_cut[slit as usize] = true;
        }
        Self::of_edges(map, is_cut, &lengths)
    }

    /// The seams of a set of edges without loose ends.
    fn of_edges(map: &GeneralizedMap, is_cut: Vec<bool>, lengths: &[f64]) -> Result<Self, Error> {
        let paths = paths(map, &is_cut);
        let sliced = map.slice_edges(&edges_of(&is_cut))?;
        let orientation = sliced.surface().orientation();
        let below = map.orientation();
        let joins = joins(map, &paths);
        let ends = map.skeleton().edge_ends();
        let is_outer = outer_vertices(map);
        let mut degrees = vec![0u32; is_outer.len()];
        for &step in paths.iter().flatten() {
            degrees[ends[step as usize] as usize] += 1;
            degrees[ends[(step ^ 1) as usize] as usize] += 1;
        }
        let seam = |(steps, is_join): (Vec<u32>, bool)| {
            let corners = [steps[0], steps[steps.len() - 1] ^ 1].map(|step| ends[step as usize]);
            let side = map.first_side(EdgeId::from_u32(steps[0] >> 1));
            let mate = map.mate(side).expect("seams are in the interior");
            let [a, b] = [side, mate].map(|side| orientation.signs()[map.face(side).index()]);
            // Only a slit has loose ends.
            let is_loose = |corner: u32| degrees[corner as usize] == 1 && !is_outer[corner as usize];
            let is_reversing = (a == b) != map.agrees(side);
            let kind = match (is_loose(corners[0]), is_join && !is_reversing) {
                (true, _) => SeamKind::Slit,
                (_, true) => SeamKind::Join,
                _ if below.conflicts()[below.component(map.face(side))].is_some() => SeamKind::Crosscap,
                _ => SeamKind::Handle,
            };
            let length = steps.iter().map(|&step| lengths[(step >> 1) as usize]).sum();
            Seam { ends: corners.map(VertexId::from_u32), steps, kind, is_reversing, length }
        };
        let seams = paths.into_iter().zip(joins).map(seam).collect();
        Ok(Self { seams, is_cut })
    }

    /// The same graph with seams exchanged for shorter ones: each in turn is replaced by the shortest path that cuts
    /// the surface, cut open along the others, to a disk; until none gets shorter, or `rounds` times through all seams.
    ///
    /// The result need not be the shortest cut graph; to find that is hard.
    ///
    /// # Errors
    /// As [`Self::new`].
    ///
    /// # Complexity
    /// $O(n \log n)$ for each seam and round.
    ///
    /// # Panics
    /// If the graph is not of this surface.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CutGraph, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// let graph = CutGraph::new(&torus, &trees, Some(&[2.0, 3.0]))?;
    /// // There is nothing shorter.
    /// assert_eq!(graph.shortened(&torus, Some(&[2.0, 3.0]), 5)?.length(), 5.0);
    /// # Ok(()) }
    /// ```
    pub fn shortened(
        &self,
        map: &GeneralizedMap,
        lengths: Option<&[f64]>,
        rounds: usize,
    ) -> Result<Self, Error> {
        let lengths = checked_lengths(map, lengths)?;
        let mut graph = Self::of_edges(map, self.is_cut.clone(), &lengths)?;
        let steps = stage("shortening seams", rounds.saturating_mul(graph.seams.len()));
        for _ in 0..rounds {
            let mut is_better = false;
            let mut i = 0;
            while i < graph.seams.len() {
                steps.advance(1);
                if let Some(better) = graph.with_shorter_seam(map, &lengths, i)? {
                    graph = better;
                    is_better = true;
                }
                i += 1;
            }
            if !is_better {
                break;
            }
        }
        Ok(graph)
    }

    /// The seams.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CutGraph, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// let graph = CutGraph::new(&torus, &trees, Some(&[2.0, 3.0]))?;
    /// assert_eq!(graph.seams().len(), 2);
    /// # Ok(()) }
    /// ```
    pub fn seams(&self) -> &[Seam] {
        &self.seams
    }

    /// The edges, rising.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::EdgeId;
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CutGraph, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// let graph = CutGraph::new(&torus, &trees, Some(&[2.0, 3.0]))?;
    /// assert_eq!(graph.edges(), [EdgeId::new(0), EdgeId::new(1)]);
    /// # Ok(()) }
    /// ```
    pub fn edges(&self) -> Vec<EdgeId> {
        edges_of(&self.is_cut)
    }

    /// The ends of seams, rising.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CutGraph, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// let graph = CutGraph::new(&torus, &trees, Some(&[2.0, 3.0]))?;
    /// assert_eq!(graph.corners(), [VertexId::new(0)]);
    /// # Ok(()) }
    /// ```
    pub fn corners(&self) -> Vec<VertexId> {
        let mut corners: Vec<VertexId> = self.seams.iter().flat_map(|seam| seam.ends).collect();
        corners.sort_unstable();
        corners.dedup();
        corners
    }

    /// The sum of the lengths of all edges.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CutGraph, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// let graph = CutGraph::new(&torus, &trees, Some(&[2.0, 3.0]))?;
    /// assert_eq!(graph.length(), 5.0);
    /// # Ok(()) }
    /// ```
    pub fn length(&self) -> f64 {
        self.seams.iter().fold(0.0, |sum, seam| sum + seam.length)
    }

    /// The graph with one seam replaced, if that makes it shorter.
    fn with_shorter_seam(
        &self,
        map: &GeneralizedMap,
        lengths: &[f64],
        i: usize,
    ) -> Result<Option<Self>, Error> {
        let seam = &self.seams[i];
        if seam.kind == SeamKind::Slit {
            return Ok(None);
        }
        let mut is_cut = self.is_cut.clone();
        for &step in &seam.steps {
            is_cut[(step >> 1) as usize] = false;
        }
        let sliced = map.slice_edges(&edges_of(&is_cut))?;
        let first = map.first_side(EdgeId::from_u32(seam.steps[0] >> 1));
        let orientation = sliced.surface().orientation();
        let component = orientation.component(map.face(first));
        let ends = sliced.surface().skeleton().edge_ends();
        let loops: Vec<Vec<u32>> = sliced
            .surface()
            .boundary_loops()
            .into_iter()
            .filter(|hole| orientation.component(sliced.surface().face(hole[0].0)) == component)
            .map(|hole| {
                let start = |&(side, sign): &(HalfedgeId, Sign)| {
                    ends[(sliced.surface().step(side) ^ u32::from(sign == Sign::Minus)) as usize]
                };
                hole.iter().map(start).collect()
            })
            .collect();
        let path = match &loops[..] {
            [inner, outer] => across_annulus(&sliced, lengths, inner, outer),
            [around] => {
                let parity =
                    self.parity_of_core(map, sliced.surface().skeleton().edge_count(), seam.steps[0]);
                across_band(&sliced, lengths, around, &parity)
            }
            // The projective plane: a cycle that meets every other one that cannot be contracted.
            _ => {
                let skeleton = map.skeleton();
                let roots: Vec<u32> =
                    seam.steps.iter().map(|&step| skeleton.edge_ends()[step as usize]).collect();
                search(map, &roots, Some(lengths), CycleKind::NonContractible, usize::MAX)?
                    .map(|cycle| cycle.walk().steps().to_vec())
            }
        };
        let Some(path) = path else { return Ok(None) };
        let mut edges: Vec<u32> = path.iter().map(|step| step >> 1).collect();
        edges.sort_unstable();
        edges.dedup();
        for &edge in &edges {
            is_cut[edge as usize] = true;
        }
        prune(map, &mut is_cut);
        for slit in self.seams.iter().filter(|seam| seam.kind == SeamKind::Slit) {
            slit.steps.iter().for_each(|&step| is_cut[(step >> 1) as usize] = true);
        }
        let length = |is_cut: &[bool]| -> f64 {
            lengths.iter().zip(is_cut).filter(|(_, cut)| **cut).map(|(length, _)| length).sum()
        };
        let (old, new) = (length(&self.is_cut), length(&is_cut));
        // Rounding must not keep the exchange going.
        if new < old * (1.0 - 1e-12) { Self::of_edges(map, is_cut, lengths).map(Some) } else { Ok(None) }
    }

    /// For the Moebius band that the disk becomes when it is glued at a seam: the edges that a closed path of faces
    /// crosses which crosses the seam once.
    fn parity_of_core(&self, map: &GeneralizedMap, edge_count: usize, step: u32) -> Vec<bool> {
        let start = map.first_side(EdgeId::from_u32(step >> 1));
        let goal = map.face(map.mate(start).expect("seams are in the interior"));
        let mut entered = vec![NONE; map.skeleton().face_count()];
        let mut queue = vec![map.face(start)];
        entered[queue[0].index()] = start.to_u32();
        let mut at = 0;
        while at < queue.len() && entered[goal.index()] == NONE {
            for side in map.sides_of(queue[at]).filter(|&side| !self.is_cut[map.edge(side).index()]) {
                let Some(mate) = map.mate(side) else { continue };
                let face: FaceId = map.face(mate);
                if entered[face.index()] == NONE {
                    entered[face.index()] = mate.to_u32();
                    queue.push(face);
                }
            }
            at += 1;
        }
        let mut is_crossed = vec![false; edge_count];
        is_crossed[(step >> 1) as usize] = true;
        let mut face = goal;
        while face != map.face(start) {
            let side = HalfedgeId::from_u32(entered[face.index()]);
            is_crossed[map.edge(side).index()] ^= true;
            face = map.face(map.mate(side).expect("a face is entered from another one"));
        }
        is_crossed
    }
}

/// The slit of each sphere: the shortest edge of its tree, and the shortest one that meets it there.
fn slits(map: &GeneralizedMap, trees: &TreeCotree, lengths: &[f64]) -> Vec<Option<u32>> {
    let is_shorter = |edge: u32, other: Option<u32>| {
        other.is_none_or(|other| lengths[edge as usize] < lengths[other as usize])
    };
    let ends = |edge: u32| map.skeleton().edge(EdgeId::from_u32(edge));
    let mut slits = [vec![None; trees.components().len()], vec![None; trees.components().len()]];
    let tree = || (0..lengths.len() as u32).filter(|&edge| trees.roles()[edge as usize] == EdgeRole::Tree);
    for second in [false, true] {
        for edge in tree() {
            let component =
                trees.component_of_vertex(ends(edge)[0]).expect("the end of an edge is in a component");
            let found = &trees.components()[component];
            if found.has_boundary() || !found.generators().is_empty() {
                continue;
            }
            let first: Option<u32> = slits[0][component];
            let meets = |first: u32| first != edge && ends(first).iter().any(|end| ends(edge).contains(end));
            if second && !first.is_some_and(meets) {
                continue;
            }
            let slit = &mut slits[usize::from(second)][component];
            if is_shorter(edge, *slit) {
                *slit = Some(edge);
            }
        }
    }
    slits.concat()
}

/// The vertices on the boundary.
fn outer_vertices(map: &GeneralizedMap) -> Vec<bool> {
    let mut is_outer = vec![false; map.skeleton().vertex_count()];
    for side in map.sides().filter(|&side| map.mate(side).is_none()) {
        is_outer[map.source(side).index()] = true;
        is_outer[map.target(side).index()] = true;
    }
    is_outer
}

fn edges_of(is_cut: &[bool]) -> Vec<EdgeId> {
    (0..is_cut.len()).filter(|&edge| is_cut[edge]).map(EdgeId::new).collect()
}

/// Takes away loose ends: edges with an end that no other edge of the set, and no edge of the boundary, has.
fn prune(map: &GeneralizedMap, is_cut: &mut [bool]) {
    let ends = map.skeleton().edge_ends();
    let mut degrees = vec![0u32; map.skeleton().vertex_count()];
    // The exclusive or of the steps out of each vertex: of a single one its number.
    let mut sums = vec![0u32; degrees.len()];
    for (edge, &is_cut) in is_cut.iter().enumerate() {
        let is_outer = map.mate(map.first_side(EdgeId::new(edge))).is_none();
        if is_cut || is_outer {
            for step in [2 * edge, 2 * edge + 1] {
                degrees[ends[step] as usize] += 1;
                sums[ends[step] as usize] ^= step as u32;
            }
        }
    }
    let mut stack: Vec<u32> = (0..degrees.len() as u32).filter(|&v| degrees[v as usize] == 1).collect();
    while let Some(vertex) = stack.pop() {
        if degrees[vertex as usize] != 1 {
            continue;
        }
        let step = sums[vertex as usize];
        is_cut[(step >> 1) as usize] = false;
        for step in [step, step ^ 1] {
            let end = ends[step as usize];
            degrees[end as usize] -= 1;
            sums[end as usize] ^= step;
            if degrees[end as usize] == 1 {
                stack.push(end);
            }
        }
    }
}

/// The paths of a set of edges from corner to corner, by rising first vertices; then the cycles without corners.
fn paths(map: &GeneralizedMap, is_cut: &[bool]) -> Vec<Vec<u32>> {
    let ends = map.skeleton().edge_ends();
    let mut out: Vec<(u32, u32)> = Vec::new();
    for edge in edges_of(is_cut) {
        for step in [2 * edge.to_u32(), 2 * edge.to_u32() + 1] {
            out.push((ends[step as usize], step));
        }
    }
    out.sort_unstable();
    let is_outer = outer_vertices(map);
    let at = |vertex: u32| {
        let start = out.partition_point(|&(v, _)| v < vertex);
        let count = out[start..].iter().take_while(|&&(v, _)| v == vertex).count();
        &out[start..start + count]
    };
    let is_corner = |vertex: u32| is_outer[vertex as usize] || at(vertex).len() != 2;
    let mut seen = vec![false; is_cut.len()];
    let mut paths = Vec::new();
    // First from corners, then what is left.
    for from_corners in [true, false] {
        for &(vertex, first) in &out {
            if seen[(first >> 1) as usize] || is_corner(vertex) != from_corners {
                continue;
            }
            let mut path = Vec::new();
            let mut step = first;
            loop {
                seen[(step >> 1) as usize] = true;
                path.push(step);
                let end = ends[(step ^ 1) as usize];
                if end == vertex || is_corner(end) {
                    break;
                }
                let back = step ^ 1;
                step =
                    at(end).iter().map(|&(_, step)| step).find(|&step| step != back).expect("two edges meet");
            }
            paths.push(path);
        }
    }
    paths
}

/// Which paths are bridges: without them the paths and the boundary are not connected.
fn joins(map: &GeneralizedMap, paths: &[Vec<u32>]) -> Vec<bool> {
    let ends = map.skeleton().edge_ends();
    // Boundary loops as single nodes.
    let mut nodes = UnionFind::new(map.skeleton().vertex_count());
    for side in map.sides().filter(|&side| map.mate(side).is_none()) {
        nodes.unite(map.source(side).to_u32(), map.target(side).to_u32());
    }
    let mut arcs: Vec<[u32; 2]> = Vec::with_capacity(paths.len());
    for path in paths {
        let ends = [path[0], path[path.len() - 1] ^ 1].map(|step| ends[step as usize]);
        arcs.push(ends.map(|end| nodes.find(end)));
    }
    let mut names: Vec<u32> = arcs.iter().flatten().copied().collect();
    names.sort_unstable();
    names.dedup();
    for node in arcs.iter_mut().flatten() {
        *node = names.partition_point(|name| name < node) as u32;
    }
    // A forest of arcs; each other arc closes a cycle, whose arcs are no bridges.
    let incident = RaggedArray::grouped(names.len(), arcs.iter().flatten().copied());
    let mut parents = vec![NONE; names.len()];
    let mut depths = vec![NONE; names.len()];
    let mut is_tree = vec![false; arcs.len()];
    let mut queue = Vec::new();
    for root in 0..names.len() {
        if depths[root] != NONE {
            continue;
        }
        depths[root] = 0;
        queue.push(root as u32);
        let mut at = 0;
        while at < queue.len() {
            let node = queue[at] as usize;
            at += 1;
            for &end in incident.list(node) {
                let other = arcs[(end >> 1) as usize][((end & 1) ^ 1) as usize] as usize;
                if depths[other] == NONE {
                    depths[other] = depths[node] + 1;
                    parents[other] = end >> 1;
                    is_tree[(end >> 1) as usize] = true;
                    queue.push(other as u32);
                }
            }
        }
        queue.clear();
    }
    let mut is_join = is_tree.clone();
    for (arc, _) in is_tree.iter().enumerate().filter(|(_, is_tree)| !**is_tree) {
        let [mut a, mut b] = arcs[arc].map(|node| node as usize);
        while a != b {
            if depths[a] < depths[b] {
                std::mem::swap(&mut a, &mut b);
            }
            let up = parents[a] as usize;
            is_join[up] = false;
            a = arcs[up][usize::from(arcs[up][0] as usize == a)] as usize;
        }
    }
    is_join
}

#[cfg(test)]
mod tests;
