//! Tree-cotree decompositions of surfaces.

use super::shortest_paths::{ShortestPaths, checked_lengths, first_vertices};
use coface_algebra::progress::stage;
use coface_algebra::{EdgeId, Error, ErrorKind, FaceId, HalfedgeId, VertexId};
use coface_algebra::{RaggedArray, Sign, UnionFind};
use coface_complexes::surface::GeneralizedMap;

/// No step, no side, no component.
const NONE: u32 = u32::MAX;

/// What an edge is in a [`TreeCotree`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum EdgeRole {
    /// It belongs to the spanning tree of the vertices.
    Tree,
    /// The spanning tree of the faces crosses it.
    Cotree,
    /// It is left: with the tree it makes a loop.
    Generator,
}

/// A spanning tree of the vertices and one of the faces, without a common edge, in each component of a surface.
///
/// The edges that are in neither are the generators. Isolated vertices belong to no component.
///
/// # Conventions
/// A step 2e is along edge e, 2e + 1 against it. Components are in the order of their first vertices, the one of a
/// chosen base first. On a component with boundary the cotree has the outside as one node more, reached through
/// exactly one boundary edge.
///
/// # References
/// D. Eppstein, *Dynamic generators of topologically embedded graphs* (2003); J. Erickson, K. Whittlesey, *Greedy
/// optimal homotopy and homology generators* (2005).
///
/// # Examples
/// The torus with 7 vertices, 21 edges and 14 triangles: 6 edges of the tree, 13 of the cotree, 2 generators.
/// ```
/// use coface_complexes::known_spaces;
/// use coface_complexes::surface::GeneralizedMap;
/// use coface_topology::{EdgeRole, TreeCotree};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let torus = GeneralizedMap::new(known_spaces::cyclic_torus(2)?.freeze().two_skeleton()?)?;
/// let trees = TreeCotree::new(&torus);
/// let count = |role| trees.roles().iter().filter(|&&found| found == role).count();
/// assert_eq!([EdgeRole::Tree, EdgeRole::Cotree, EdgeRole::Generator].map(count), [6, 13, 2]);
/// assert_eq!(trees.components()[0].generators().len(), 2);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TreeCotree {
    roles: Vec<EdgeRole>,
    /// The step of the tree into each vertex; none for bases and isolated vertices.
    steps: Vec<u32>,
    /// The side by which the cotree leaves each face towards its root; none for roots of closed components.
    exits: Vec<u32>,
    vertex_components: Vec<u32>,
    face_components: Vec<u32>,
    components: Vec<TreeCotreeComponent>,
}

/// One component of a [`TreeCotree`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TreeCotreeComponent {
    base: VertexId,
    root: FaceId,
    has_boundary: bool,
    generators: Vec<EdgeId>,
}

impl TreeCotreeComponent {
    /// The root of the tree, where the loops start and end.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::TreeCotree;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// let component = &trees.components()[0];
    /// assert_eq!(component.base(), VertexId::new(0));
    /// # Ok(()) }
    /// ```
    pub fn base(&self) -> VertexId {
        self.base
    }

    /// The root of the cotree.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::FaceId;
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::TreeCotree;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// let component = &trees.components()[0];
    /// assert_eq!(component.root(), FaceId::new(0));
    /// # Ok(()) }
    /// ```
    pub fn root(&self) -> FaceId {
        self.root
    }

    /// Whether the component has a boundary.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::TreeCotree;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// let component = &trees.components()[0];
    /// assert!(!component.has_boundary());
    /// # Ok(()) }
    /// ```
    pub fn has_boundary(&self) -> bool {
        self.has_boundary
    }

    /// The generators, rising. Letter i of a word, counted from 1, is generator i - 1, run through as its edge runs.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::EdgeId;
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::TreeCotree;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// let component = &trees.components()[0];
    /// assert_eq!(component.generators(), [EdgeId::new(0), EdgeId::new(1)]);
    /// # Ok(()) }
    /// ```
    pub fn generators(&self) -> &[EdgeId] {
        &self.generators
    }
}

impl TreeCotree {
    /// The cotree first, breadth-first from the first face; then the tree, breadth-first from the first vertex of each
    /// component, in the edges that the cotree does not cross.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{EdgeRole, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// assert_eq!(trees.roles(), [EdgeRole::Generator; 2]);
    /// # Ok(()) }
    /// ```
    pub fn new(map: &GeneralizedMap) -> Self {
        let roots = roots(map);
        let mut is_crossed = vec![false; map.skeleton().edge_count()];
        let mut seen = vec![false; map.skeleton().face_count()];
        let mut queue = Vec::new();
        let steps = stage("walking over faces", map.skeleton().face_count());
        let mut reached = 0;
        for &first in &roots {
            seen[first.index()] = true;
            queue.push(first);
            let mut at = 0;
            while at < queue.len() {
                for side in map.sides_of(queue[at]) {
                    let Some(mate) = map.mate(side) else { continue };
                    let face = map.face(mate);
                    if !std::mem::replace(&mut seen[face.index()], true) {
                        is_crossed[map.edge(side).index()] = true;
                        queue.push(face);
                    }
                }
                at += 1;
                reached += 1;
                steps.pass(reached);
            }
            queue.clear();
        }
        drop(steps);
        Self::with_cotree(map, &roots, is_crossed, None)
    }

    /// Short loops at a base: those of the edges, with the shortest paths to their ends, that can be had. The tree is
    /// one of shortest paths from the base and the cotree is a spanning tree of greatest loop lengths, as far as the
    /// two do not meet, which is always so without boundary: there the loops are a shortest system of generators of
    /// the fundamental group at that base. Where there is a boundary, the cotree comes first, so that the domain is a
    /// disk.
    ///
    /// `lengths` has a length for each edge; without it, each edge has the length 1. `base` is the base of its
    /// component; other components have their first vertices.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless there are as many lengths as edges; [`ErrorKind::InvalidInput`] naming a length
    /// that is negative or not finite; [`ErrorKind::NotInComplex`] for a base that no edge ends at.
    ///
    /// # Complexity
    /// $O(n \log n)$.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_complexes::known_spaces;
    /// use coface_complexes::surface::GeneralizedMap;
    /// use coface_topology::TreeCotree;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // One triangle, with edges 01, 02 and 12.
    /// let triangle = GeneralizedMap::new(known_spaces::simplex(2)?.freeze().two_skeleton()?)?;
    /// let trees = TreeCotree::new(&triangle);
    /// let near = TreeCotree::greedy(&triangle, Some(VertexId::new(1)), None)?;
    /// assert_eq!(near.components()[0].base(), VertexId::new(1));
    /// # Ok(()) }
    /// ```
    pub fn greedy(
        map: &GeneralizedMap,
        base: Option<VertexId>,
        lengths: Option<&[f64]>,
    ) -> Result<Self, Error> {
        let ends = map.skeleton().edge_ends();
        let lengths = checked_lengths(map, lengths)?;
        if let Some(base) = base
            && !ends.contains(&base.to_u32())
        {
            return Err(Error::new(
                ErrorKind::NotInComplex,
                format!("vertex {base} is on no edge of the surface, so that no loop starts there"),
            ));
        }
        let paths = ShortestPaths::new(map, base, &lengths);
        let loop_length = |edge: u32| {
            let [a, b] = [0, 1].map(|end| paths.distances[ends[(2 * edge + end) as usize] as usize]);
            a + b + lengths[edge as usize]
        };
        let mut is_path = vec![false; lengths.len()];
        for &step in paths.steps.iter().filter(|&&step| step != NONE) {
            is_path[(step >> 1) as usize] = true;
        }
        // The longest loops first, edges of shortest paths at the end; ties by number.
        let mut edges: Vec<(u32, f64)> =
            (0..lengths.len() as u32).map(|edge| (edge, loop_length(edge))).collect();
        edges.sort_unstable_by(|&(e, x), &(f, y)| {
            (is_path[e as usize].cmp(&is_path[f as usize])).then(y.total_cmp(&x)).then(e.cmp(&f))
        });
        let mut partition = UnionFind::new(map.skeleton().face_count());
        let mut is_crossed = vec![false; lengths.len()];
        for &(edge, _) in &edges {
            let arc = map.dual_arc(EdgeId::from_u32(edge)).map(|faces| faces.map(FaceId::to_u32));
            is_crossed[edge as usize] = arc.is_some_and(|[f, g]| partition.unite(f, g));
        }
        Ok(Self::with_cotree(map, &roots(map), is_crossed, Some((&paths, &edges))))
    }

    /// The decomposition whose cotree crosses these edges, a spanning forest of the dual graph. The tree takes edges of
    /// the given paths where it can, then shorter loops first; without paths it is breadth-first.
    fn with_cotree(
        map: &GeneralizedMap,
        roots: &[FaceId],
        mut is_crossed: Vec<bool>,
        preferred: Option<(&ShortestPaths, &[(u32, f64)])>,
    ) -> Self {
        let skeleton = map.skeleton();
        // The edge through which the cotree reaches the outside.
        let mut exits = vec![NONE; skeleton.face_count()];
        let mut has_boundary = vec![false; roots.len()];
        for (component, &root) in roots.iter().enumerate() {
            if let Some(exit) = map.sides_of(root).find(|&side| map.mate(side).is_none()) {
                is_crossed[map.edge(exit).index()] = true;
                exits[root.index()] = exit.to_u32();
                has_boundary[component] = true;
            }
        }
        let bases = match preferred {
            Some((paths, _)) => paths.bases.clone(),
            None => first_vertices(map),
        };
        let steps_at = RaggedArray::grouped(skeleton.vertex_count(), skeleton.edge_ends().iter().copied());
        let is_free: Vec<bool> = match preferred {
            None => is_crossed.iter().map(|crossed| !crossed).collect(),
            Some((_, edges)) => {
                // A spanning tree of least loops, found once and for all: paths first.
                let mut partition = UnionFind::new(skeleton.vertex_count());
                let mut is_tree = vec![false; is_crossed.len()];
                for &(edge, _) in edges.iter().rev().filter(|(edge, _)| !is_crossed[*edge as usize]) {
                    let [a, b] = skeleton.edge(EdgeId::from_u32(edge)).map(VertexId::to_u32);
                    is_tree[edge as usize] = partition.unite(a, b);
                }
                is_tree
            }
        };
        let mut roles: Vec<EdgeRole> = is_crossed
            .iter()
            .map(|&crossed| if crossed { EdgeRole::Cotree } else { EdgeRole::Generator })
            .collect();
        let mut steps = vec![NONE; skeleton.vertex_count()];
        let mut vertex_components = vec![NONE; skeleton.vertex_count()];
        let mut queue = Vec::new();
        let growing = stage("growing a spanning tree", skeleton.vertex_count());
        let mut reached = 0;
        for (component, &base) in bases.iter().enumerate() {
            vertex_components[base.index()] = component as u32;
            queue.push(base.to_u32());
            let mut at = 0;
            while at < queue.len() {
                for &step in steps_at.list(queue[at] as usize) {
                    let next = skeleton.edge_ends()[(step ^ 1) as usize];
                    if is_free[(step >> 1) as usize] && vertex_components[next as usize] == NONE {
                        vertex_components[next as usize] = component as u32;
                        steps[next as usize] = step;
                        roles[(step >> 1) as usize] = EdgeRole::Tree;
                        queue.push(next);
                    }
                }
                at += 1;
                reached += 1;
                growing.pass(reached);
            }
            queue.clear();
        }
        drop(growing);
        let mut components: Vec<TreeCotreeComponent> = bases
            .iter()
            .map(|&base| TreeCotreeComponent {
                base,
                root: FaceId::new(0),
                has_boundary: false,
                generators: Vec::new(),
            })
            .collect();
        let mut face_components = vec![NONE; skeleton.face_count()];
        let mut queue = Vec::new();
        let growing = stage("growing a spanning tree of the dual graph", skeleton.face_count());
        let mut reached = 0;
        for (&root, has_boundary) in roots.iter().zip(has_boundary) {
            let side = map.sides_of(root).next().expect("a face has sides");
            let component = vertex_components[map.source(side).index()];
            let found = &mut components[component as usize];
            (found.root, found.has_boundary) = (root, has_boundary);
            face_components[root.index()] = component;
            queue.push(root);
            let mut at = 0;
            while at < queue.len() {
                for side in map.sides_of(queue[at]) {
                    let Some(mate) = map.mate(side).filter(|_| is_crossed[map.edge(side).index()]) else {
                        continue;
                    };
                    let face = map.face(mate);
                    if face_components[face.index()] == NONE {
                        face_components[face.index()] = component;
                        exits[face.index()] = mate.to_u32();
                        queue.push(face);
                    }
                }
                at += 1;
                reached += 1;
                growing.pass(reached);
            }
            queue.clear();
        }
        for (edge, _) in roles.iter().enumerate().filter(|(_, role)| **role == EdgeRole::Generator) {
            let edge = EdgeId::new(edge);
            let component = vertex_components[skeleton.edge(edge)[0].index()];
            components[component as usize].generators.push(edge);
        }
        Self { roles, steps, exits, vertex_components, face_components, components }
    }

    /// The role of each edge.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::known_spaces;
    /// use coface_complexes::surface::GeneralizedMap;
    /// use coface_topology::{EdgeRole, TreeCotree};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // One triangle, with edges 01, 02 and 12.
    /// let triangle = GeneralizedMap::new(known_spaces::simplex(2)?.freeze().two_skeleton()?)?;
    /// let trees = TreeCotree::new(&triangle);
    /// // One boundary edge belongs to the cotree, which reaches the outside through it.
    /// let cotree = trees.roles().iter().filter(|&&role| role == EdgeRole::Cotree);
    /// assert_eq!(cotree.count(), 1);
    /// # Ok(()) }
    /// ```
    pub fn roles(&self) -> &[EdgeRole] {
        &self.roles
    }

    /// The components with faces.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::TreeCotree;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// assert_eq!(trees.components().len(), 1);
    /// # Ok(()) }
    /// ```
    pub fn components(&self) -> &[TreeCotreeComponent] {
        &self.components
    }

    /// The component that a vertex is in; `None` if it is isolated.
    ///
    /// # Panics
    /// If there is no such vertex. Likewise the functions that follow panic where there is no such cell.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::TreeCotree;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// assert_eq!(trees.component_of_vertex(VertexId::new(0)), Some(0));
    /// # Ok(()) }
    /// ```
    pub fn component_of_vertex(&self, vertex: VertexId) -> Option<usize> {
        let component = self.vertex_components[vertex.index()];
        (component != NONE).then_some(component as usize)
    }

    /// The component that a face is in.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::FaceId;
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::TreeCotree;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// assert_eq!(trees.component_of_face(FaceId::new(0)), 0);
    /// # Ok(()) }
    /// ```
    pub fn component_of_face(&self, face: FaceId) -> usize {
        self.face_components[face.index()] as usize
    }

    /// The last step of the way in the tree from the base to a vertex; `None` for a base and an isolated vertex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_complexes::known_spaces;
    /// use coface_complexes::surface::GeneralizedMap;
    /// use coface_topology::TreeCotree;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // One triangle, with edges 01, 02 and 12.
    /// let triangle = GeneralizedMap::new(known_spaces::simplex(2)?.freeze().two_skeleton()?)?;
    /// let trees = TreeCotree::new(&triangle);
    /// assert_eq!(trees.tree_step(VertexId::new(0)), None);
    /// assert!(trees.tree_step(VertexId::new(1)).is_some());
    /// # Ok(()) }
    /// ```
    pub fn tree_step(&self, vertex: VertexId) -> Option<u32> {
        Some(self.steps[vertex.index()]).filter(|&step| step != NONE)
    }

    /// The side by which the cotree leaves a face towards its root, or the outside; `None` for the root of a closed
    /// component.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::FaceId;
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::TreeCotree;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// assert_eq!(trees.exit(FaceId::new(0)), None);
    /// # Ok(()) }
    /// ```
    pub fn exit(&self, face: FaceId) -> Option<HalfedgeId> {
        Some(self.exits[face.index()]).filter(|&side| side != NONE).map(HalfedgeId::from_u32)
    }

    /// The steps in the tree from the base of its component to a vertex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_complexes::known_spaces;
    /// use coface_complexes::surface::GeneralizedMap;
    /// use coface_topology::TreeCotree;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // One triangle, with edges 01, 02 and 12.
    /// let triangle = GeneralizedMap::new(known_spaces::simplex(2)?.freeze().two_skeleton()?)?;
    /// let trees = TreeCotree::new(&triangle);
    /// assert!(trees.path_to(&triangle, VertexId::new(0)).is_empty());
    /// # Ok(()) }
    /// ```
    pub fn path_to(&self, map: &GeneralizedMap, vertex: VertexId) -> Vec<u32> {
        let mut path = Vec::new();
        let mut at = vertex;
        while let Some(step) = self.tree_step(at) {
            path.push(step);
            at = VertexId::from_u32(map.skeleton().edge_ends()[step as usize]);
        }
        path.reverse();
        path
    }

    /// The loop of a generator at the base: along the tree, through the edge, and back along the tree.
    ///
    /// # Examples
    /// On the torus with one vertex there is no tree to walk along.
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::TreeCotree;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// let loops: Vec<_> =
    ///     trees.components()[0].generators().iter().map(|&e| trees.based_loop(&torus, e)).collect();
    /// assert_eq!(loops, [vec![0], vec![2]]);
    /// # Ok(()) }
    /// ```
    pub fn based_loop(&self, map: &GeneralizedMap, edge: EdgeId) -> Vec<u32> {
        let [source, target] = map.skeleton().edge(edge);
        let mut steps = self.path_to(map, source);
        steps.push(2 * edge.to_u32());
        steps.extend(self.path_to(map, target).into_iter().rev().map(|step| step ^ 1));
        steps
    }

    /// The loop of a generator without the way that it goes forth and back: a closed path that meets no vertex twice.
    /// It starts with the edge.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::EdgeId;
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::TreeCotree;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// assert_eq!(trees.simple_loop(&torus, EdgeId::new(1)), [2]);
    /// # Ok(()) }
    /// ```
    pub fn simple_loop(&self, map: &GeneralizedMap, edge: EdgeId) -> Vec<u32> {
        let [source, target] = map.skeleton().edge(edge);
        let [to_source, to_target] = [self.path_to(map, source), self.path_to(map, target)];
        let common = to_source.iter().zip(&to_target).take_while(|(a, b)| a == b).count();
        let mut steps = vec![2 * edge.to_u32()];
        steps.extend(to_target[common..].iter().rev().map(|step| step ^ 1));
        steps.extend(&to_source[common..]);
        steps
    }

    /// The closed chain of faces that crosses a generator and no other edge that the cotree does not cross: the sides
    /// by which one face is left for the next. It starts in the face of `first`, a side of the generator, and crosses
    /// it. `None` for a generator on the boundary.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::HalfedgeId;
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::TreeCotree;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus made of one square.
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let trees = TreeCotree::new(&torus);
    /// // The square is left through the first edge and entered again on its other side.
    /// let side = HalfedgeId::new(0);
    /// assert_eq!(trees.dual_loop(&torus, side), Some(vec![side]));
    /// # Ok(()) }
    /// ```
    pub fn dual_loop(&self, map: &GeneralizedMap, first: HalfedgeId) -> Option<Vec<HalfedgeId>> {
        let mate = map.mate(first)?;
        let [from_second, from_first] = [map.face(mate), map.face(first)].map(|face| self.way_out(map, face));
        let common =
            from_second.iter().rev().zip(from_first.iter().rev()).take_while(|(a, b)| a == b).count();
        let mut sides = vec![first];
        sides.extend(&from_second[..from_second.len() - common]);
        for &side in from_first[..from_first.len() - common].iter().rev() {
            sides.push(map.mate(side)?);
        }
        Some(sides)
    }

    /// The sides by which the cotree leads from a face to its root, not further.
    fn way_out(&self, map: &GeneralizedMap, face: FaceId) -> Vec<HalfedgeId> {
        let mut sides = Vec::new();
        let mut at = face;
        while let Some(side) = self.exit(at)
            && let Some(mate) = map.mate(side)
        {
            sides.push(side);
            at = map.face(mate);
        }
        sides
    }

    /// The signs with which the faces of each component agree across all edges of the cotree; those of the roots are
    /// plus.
    pub(super) fn face_signs(&self, map: &GeneralizedMap) -> Vec<Sign> {
        const UNKNOWN: u8 = 2;
        let mut signs = vec![UNKNOWN; map.skeleton().face_count()];
        let mut way = Vec::new();
        let steps = stage("orienting faces along a tree", signs.len());
        for face in steps.each(0..signs.len()) {
            let mut at = FaceId::new(face);
            // Up to a face whose sign is known, and down again.
            while signs[at.index()] == UNKNOWN {
                match self.exit(at).and_then(|side| Some((side, map.mate(side)?))) {
                    None => signs[at.index()] = 0,
                    Some((side, mate)) => {
                        way.push(side);
                        at = map.face(mate);
                    }
                }
            }
            let mut sign = signs[at.index()];
            while let Some(side) = way.pop() {
                sign ^= u8::from(!map.agrees(side));
                signs[map.face(side).index()] = sign;
            }
        }
        signs.into_iter().map(|sign| Sign::power_of_minus_one(usize::from(sign))).collect()
    }
}

/// The first face of each component; the first one at the boundary if there is a boundary.
fn roots(map: &GeneralizedMap) -> Vec<FaceId> {
    let orientation = map.orientation();
    let mut first = vec![NONE; orientation.conflicts().len()];
    for face in (0..map.skeleton().face_count()).rev() {
        first[orientation.component(FaceId::new(face))] = face as u32;
    }
    for side in map.sides().rev().filter(|&side| map.mate(side).is_none()) {
        first[orientation.component(map.face(side))] = map.face(side).to_u32();
    }
    first.into_iter().map(FaceId::from_u32).collect()
}
