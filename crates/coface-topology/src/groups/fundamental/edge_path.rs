//! Fundamental groups by edge paths.

use super::Presentation;
use super::word_table::{UNIT, WordTable};
use crate::homology::AbelianGroup;
use coface_algebra::chains::TwoSkeleton;
use coface_algebra::progress::stage;
use coface_algebra::{EdgeId, Error, ErrorKind, FaceId, VertexId};
use coface_algebra::{RaggedArray, Sign, UnionFind, Word};
use std::collections::{BTreeSet, VecDeque};

/// Longer words than this are not given to edges; such an edge becomes a generator of its own.
const LONGEST_WORD: usize = 1 << 10;
/// No edge, no step, no vertex.
const NONE: u32 = u32::MAX;

/// The fundamental groups of the components of a complex: presentations, and every edge as a word in their generators.
///
/// Each component has a base vertex and a breadth-first spanning tree. Tree edges are the unit. A face all of whose
/// edges but one have words gives the last one its word; when there is no such face, the edge with the shortest loop
/// becomes a generator (on surfaces, one that a maximum spanning tree of the dual graph does not cross, so that there
/// are no more generators than needed). The faces that gave no edge its word are the relators. Of these, a 3-cell
/// makes one superfluous: along a spanning tree of the 3-cells the longest ones are left out.
///
/// # Conventions
/// A path is multiplied from left to right. Generators are numbered in each component from 1. A generator is the loop
/// from the base along the tree to its edge, along the edge, and back along the tree.
///
/// # Complexity
/// Near-linear in the cells and in the lengths of the words, which stay short on meshes.
///
/// # References
/// H. Seifert, W. Threlfall, *Lehrbuch der Topologie* (1934), section 44, for the edge-path group; J. Erickson,
/// K. Whittlesey, *Greedy optimal homotopy and homology generators* (2005), for the choice of the generators.
///
/// # Examples
/// The torus with 7 vertices: two generators that commute.
/// ```
/// use coface_complexes::known_spaces;
/// use coface_topology::EdgePathGroups;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let skeleton = known_spaces::cyclic_torus(2)?.freeze().two_skeleton()?;
/// let groups = EdgePathGroups::new(&skeleton);
/// assert_eq!(groups.component_count(), 1);
/// let torus = groups.presentation(0);
/// assert_eq!((torus.generator_count(), torus.relators().len()), (2, 1));
/// assert_eq!(torus.relators()[0].len(), 4);
/// assert_eq!(torus.abelianization().to_string(), "Z^2");
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct EdgePathGroups {
    ends: Vec<u32>,
    forest: Forest,
    /// The word of edge e is the word `words[edge_words[e] / 2]`, inverted if that number is odd.
    edge_words: Vec<u32>,
    words: Vec<Word>,
    components: Vec<Component>,
    /// The faces that gave an edge its word, in their order.
    determining: Vec<FaceId>,
}

#[derive(Clone, Debug)]
struct Component {
    base: VertexId,
    presentation: Presentation,
    generator_edges: Vec<EdgeId>,
}

/// Breadth-first spanning trees.
#[derive(Clone, Debug)]
struct Forest {
    /// The root of each tree.
    roots: Vec<u32>,
    /// The tree that each vertex is in.
    tree: Vec<u32>,
    /// The step (2e along edge e, 2e + 1 against it) by which each vertex was reached; none for roots.
    steps: Vec<u32>,
    /// The number of steps to each vertex.
    depths: Vec<u32>,
}

impl Forest {
    /// Trees that span all components, rooted at the given vertex first and then at the first vertex of each other one.
    fn new(skeleton: &TwoSkeleton, first: Option<VertexId>) -> Self {
        let (count, ends) = (skeleton.vertex_count(), skeleton.edge_ends());
        let steps_at = RaggedArray::grouped(count, ends.iter().copied());
        let mut forest = Self {
            roots: Vec::new(),
            tree: vec![NONE; count],
            steps: vec![NONE; count],
            depths: vec![0; count],
        };
        let mut queue = VecDeque::new();
        for root in first.map(VertexId::to_u32).into_iter().chain(0..count as u32) {
            if forest.tree[root as usize] != NONE {
                continue;
            }
            let tree = forest.roots.len() as u32;
            forest.roots.push(root);
            forest.tree[root as usize] = tree;
            queue.push_back(root);
            while let Some(vertex) = queue.pop_front() {
                for &step in steps_at.list(vertex as usize) {
                    let next = ends[(step ^ 1) as usize] as usize;
                    if forest.tree[next] == NONE {
                        forest.tree[next] = tree;
                        forest.steps[next] = step;
                        forest.depths[next] = forest.depths[vertex as usize] + 1;
                        queue.push_back(next as u32);
                    }
                }
            }
        }
        forest
    }

    /// The steps from the root to a vertex.
    fn path_to(&self, vertex: u32, ends: &[u32]) -> Vec<u32> {
        let mut path = Vec::with_capacity(self.depths[vertex as usize] as usize);
        let mut at = vertex;
        while self.steps[at as usize] != NONE {
            path.push(self.steps[at as usize]);
            at = ends[self.steps[at as usize] as usize];
        }
        path.reverse();
        path
    }

    /// The length of the loop through each edge.
    fn loop_length(&self, edge: u32, ends: &[u32]) -> u32 {
        let [a, b] = [0, 1].map(|side| self.depths[ends[2 * edge as usize + side] as usize]);
        a + b + 1
    }
}

/// The work in progress: which edges have words.
struct Words<'a> {
    faces: &'a RaggedArray,
    /// The faces at each edge, each as often as it runs over it.
    faces_at: RaggedArray,
    /// The number of the word of each edge; none if it has no word yet.
    of_edge: Vec<u32>,
    /// How many steps of each face have no word.
    unknown: Vec<u32>,
    /// Whether each face has given an edge its word.
    is_used: Vec<bool>,
    /// The faces that are used, in their order.
    determining: Vec<FaceId>,
    ready: VecDeque<u32>,
    generators: Vec<u32>,
    table: WordTable,
}

impl<'a> Words<'a> {
    fn new(faces: &'a RaggedArray, edge_count: usize) -> Self {
        let mut faces_at = RaggedArray::grouped(edge_count, faces.items().iter().map(|step| step >> 1));
        let mut face_of = Vec::with_capacity(faces.item_count());
        for (face, rim) in faces.iter().enumerate() {
            face_of.extend(std::iter::repeat_n(face as u32, rim.len()));
        }
        for position in faces_at.items_mut() {
            *position = face_of[*position as usize];
        }
        Self {
            faces,
            faces_at,
            of_edge: vec![NONE; edge_count],
            unknown: faces.iter().map(|rim| rim.len() as u32).collect(),
            is_used: vec![false; faces.len()],
            determining: Vec::new(),
            ready: VecDeque::new(),
            generators: Vec::new(),
            table: WordTable::new(),
        }
    }

    fn faces_of(&self, edge: u32) -> &[u32] {
        self.faces_at.list(edge as usize)
    }

    fn is_known(&self, edge: u32) -> bool {
        self.of_edge[edge as usize] != NONE
    }

    fn set(&mut self, edge: u32, word: u32) {
        self.of_edge[edge as usize] = word;
        for &face in self.faces_at.list(edge as usize) {
            self.unknown[face as usize] -= 1;
            if self.unknown[face as usize] == 1 {
                self.ready.push_back(face);
            }
        }
    }

    fn make_generator(&mut self, edge: u32) {
        self.generators.push(edge);
        let letter = i32::try_from(self.generators.len()).expect("there are fewer than 2^31 edges");
        let word = self.table.insert(Word::from_letters([letter]));
        self.set(edge, word);
    }

    /// The number of the word of a step.
    fn of_step(&self, step: u32) -> u32 {
        let word = self.of_edge[step as usize / 2];
        if step & 1 == 0 { word } else { WordTable::inverse(word) }
    }

    /// The number of the product of the words of these steps, if it does not get too long.
    fn product(&mut self, steps: impl Iterator<Item = u32>, longest: usize) -> Option<u32> {
        let mut product = UNIT;
        for step in steps {
            product = self.table.product(product, self.of_step(step), longest)?;
        }
        Some(product)
    }

    /// Lets faces give words to edges as long as there is a face with one unknown step.
    fn propagate(&mut self) {
        let steps = stage("walking around faces", 0);
        for walked in 0.. {
            let Some(face) = self.ready.pop_front() else { break };
            steps.pass(walked);
            if self.unknown[face as usize] != 1 {
                continue;
            }
            let rim = self.faces.list(face as usize);
            let at = rim.iter().position(|&step| !self.is_known(step >> 1)).expect("one step has no word");
            let step = rim[at];
            let others = rim[at + 1..].iter().chain(&rim[..at]).copied();
            match self.product(others, LONGEST_WORD) {
                // The step times the others is the unit.
                Some(rest) => {
                    self.is_used[face as usize] = true;
                    self.determining.push(FaceId::from_u32(face));
                    self.set(step >> 1, if step & 1 == 0 { WordTable::inverse(rest) } else { rest });
                }
                None => self.make_generator(step >> 1),
            }
        }
    }

    /// Gives all edges words.
    fn finish(&mut self, forest: &Forest, ends: &[u32]) {
        for &step in forest.steps.iter().filter(|&&step| step != NONE) {
            self.set(step >> 1, UNIT);
        }
        self.ready.clear();
        self.ready.extend((0..self.faces.len() as u32).filter(|&face| self.unknown[face as usize] == 1));
        let by_length = self.edges_by_length(forest, ends);
        let is_crossed = self.dual_tree(&by_length);
        self.propagate();
        for crossed in [false, true] {
            for &edge in by_length.iter().filter(|&&edge| is_crossed[edge as usize] == crossed) {
                if !self.is_known(edge) {
                    self.make_generator(edge);
                    self.propagate();
                }
            }
        }
    }

    /// The edges without words by the lengths of their loops, the shortest first.
    fn edges_by_length(&self, forest: &Forest, ends: &[u32]) -> Vec<u32> {
        let edges: Vec<u32> = (0..self.of_edge.len() as u32).filter(|&edge| !self.is_known(edge)).collect();
        let lengths = edges.iter().map(|&edge| forest.loop_length(edge, ends));
        let longest = lengths.clone().max().unwrap_or(0) as usize;
        RaggedArray::grouped(longest + 1, lengths)
            .into_items()
            .into_iter()
            .map(|position| edges[position as usize])
            .collect()
    }

    /// The edges that a maximum spanning tree of the dual graph crosses: faces are its nodes, and the outside is one
    /// more, joined to those with an edge of their own. Edges in three or more faces are left out.
    fn dual_tree(&self, by_length: &[u32]) -> Vec<bool> {
        let outside = self.faces.len() as u32;
        let mut trees = UnionFind::new(self.faces.len() + 1);
        let mut is_crossed = vec![false; self.of_edge.len()];
        for &edge in by_length.iter().rev() {
            is_crossed[edge as usize] = match *self.faces_of(edge) {
                [face] => trees.unite(face, outside),
                [a, b] => trees.unite(a, b),
                _ => false,
            };
        }
        is_crossed
    }

    /// The numbers of the words of the faces that are relators, without repetition.
    fn relators(&mut self, solids: &RaggedArray) -> Vec<u32> {
        let mut relators = Vec::new();
        for face in 0..self.faces.len() {
            if !self.is_used[face] {
                let rim = self.faces.list(face);
                let word = self.product(rim.iter().copied(), usize::MAX).expect("words may have any length");
                if word != UNIT {
                    relators.push((face as u32, word));
                }
            }
        }
        self.remove_superfluous(&mut relators, solids);
        let mut met = BTreeSet::new();
        relators.retain(|&(_, word)| met.insert(self.table.word(word).cyclic_form()));
        relators.into_iter().map(|(_, word)| word).collect()
    }

    /// Leaves out relators that follow from others because a 3-cell is between them. In a spanning forest of the graph
    /// whose nodes are the 3-cells and the outside, and whose edges are the faces that occur at most twice in them,
    /// each 3-cell but one of each tree has the face towards the root as a product of conjugates of its other faces.
    fn remove_superfluous(&self, relators: &mut Vec<(u32, u32)>, solids: &RaggedArray) {
        if solids.is_empty() {
            return;
        }
        let mut sides: Vec<[u32; 2]> = vec![[NONE; 2]; self.faces.len()];
        let mut is_crowded = vec![false; self.faces.len()];
        for (solid, faces) in solids.iter().enumerate() {
            for &face in faces {
                match sides[face as usize].iter_mut().find(|side| **side == NONE) {
                    Some(side) => *side = solid as u32,
                    None => is_crowded[face as usize] = true,
                }
            }
        }
        let outside = solids.len() as u32;
        let mut trees = UnionFind::new(solids.len() + 1);
        let mut order: Vec<usize> = (0..relators.len()).collect();
        order.sort_by_key(|&i| std::cmp::Reverse(self.table.len(relators[i].1)));
        let mut is_needed = vec![true; relators.len()];
        let steps = stage("leaving out relators", order.len());
        for i in steps.each(order) {
            let face = relators[i].0 as usize;
            is_needed[i] = match sides[face] {
                _ if is_crowded[face] => true,
                [NONE, _] => true,
                [solid, NONE] => !trees.unite(solid, outside),
                [a, b] => !trees.unite(a, b),
            };
        }
        let mut flags = is_needed.into_iter();
        relators.retain(|_| flags.next() == Some(true));
    }
}

impl EdgePathGroups {
    /// The fundamental groups of the components, by the numbers of their smallest vertices, which are their bases.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::known_spaces;
    /// use coface_topology::EdgePathGroups;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The rim of a triangle.
    /// let skeleton = known_spaces::circle(3)?.freeze().two_skeleton()?;
    /// let groups = EdgePathGroups::new(&skeleton);
    /// assert_eq!(groups.presentation(0).to_string(), "<x1 | >");
    /// # Ok(()) }
    /// ```
    pub fn new(skeleton: &TwoSkeleton) -> Self {
        Self::from_forest(skeleton, Forest::new(skeleton, None))
    }

    /// The fundamental groups of the components, the one of this vertex first with the vertex as its base.
    ///
    /// # Errors
    /// [`ErrorKind::NotInComplex`] if there is no such vertex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_algebra::Word;
    /// use coface_complexes::known_spaces;
    /// use coface_topology::EdgePathGroups;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let skeleton = known_spaces::circle(5)?.freeze().two_skeleton()?;
    /// let groups = EdgePathGroups::with_base(&skeleton, VertexId::new(3))?;
    /// assert_eq!(groups.base(0), VertexId::new(3));
    /// assert_eq!(groups.loop_vertices(0, &Word::from_letters([1])).len(), 6);
    /// # Ok(()) }
    /// ```
    pub fn with_base(skeleton: &TwoSkeleton, base: VertexId) -> Result<Self, Error> {
        if base.index() >= skeleton.vertex_count() {
            return Err(Error::new(
                ErrorKind::NotInComplex,
                format!("{base} cannot be the base, for there are {} vertices", skeleton.vertex_count()),
            )
            .with_cure("name a vertex of the complex, numbered from 0"));
        }
        Ok(Self::from_forest(skeleton, Forest::new(skeleton, Some(base))))
    }

    fn from_forest(skeleton: &TwoSkeleton, forest: Forest) -> Self {
        let ends = skeleton.edge_ends().to_vec();
        let mut words = Words::new(skeleton.faces(), skeleton.edge_count());
        words.finish(&forest, &ends);
        let relators = words.relators(skeleton.solids());
        let Words { of_edge: edge_words, generators, table, determining, .. } = words;
        let mut generator_edges = vec![Vec::new(); forest.roots.len()];
        let mut component_of = Vec::with_capacity(generators.len());
        let mut local = Vec::with_capacity(generators.len());
        for &edge in &generators {
            let component = forest.tree[ends[2 * edge as usize] as usize];
            let edges: &mut Vec<EdgeId> = &mut generator_edges[component as usize];
            edges.push(EdgeId::from_u32(edge));
            component_of.push(component);
            local.push(edges.len() as i32);
        }
        let component_of_word = |word: &Word| component_of[word.letters()[0].unsigned_abs() as usize - 1];
        let relator_components: Vec<u32> =
            relators.iter().map(|&relator| component_of_word(&table.word(relator))).collect();
        let words = table.into_words(|letter| local[letter.unsigned_abs() as usize - 1] * letter.signum());
        let mut component_relators = vec![Vec::new(); forest.roots.len()];
        for (&relator, &component) in relators.iter().zip(&relator_components) {
            component_relators[component as usize].push(word_of(&words, relator).cyclically_reduced());
        }
        let components = forest
            .roots
            .iter()
            .zip(generator_edges)
            .zip(component_relators)
            .map(|((&root, generator_edges), relators)| Component {
                base: VertexId::from_u32(root),
                presentation: Presentation::new(generator_edges.len(), relators)
                    .expect("the letters of a component are its generators"),
                generator_edges,
            })
            .collect();
        Self { ends, forest, edge_words, words, components, determining }
    }

    /// The number of components.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::known_spaces;
    /// use coface_topology::EdgePathGroups;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The rim of a triangle.
    /// let skeleton = known_spaces::circle(3)?.freeze().two_skeleton()?;
    /// let groups = EdgePathGroups::new(&skeleton);
    /// assert_eq!(groups.component_count(), 1);
    /// # Ok(()) }
    /// ```
    pub fn component_count(&self) -> usize {
        self.components.len()
    }

    /// The component that a vertex is in.
    ///
    /// # Panics
    /// If there is no such vertex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_complexes::known_spaces;
    /// use coface_topology::EdgePathGroups;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The rim of a triangle.
    /// let skeleton = known_spaces::circle(3)?.freeze().two_skeleton()?;
    /// let groups = EdgePathGroups::new(&skeleton);
    /// assert_eq!(groups.component_of(VertexId::new(2)), 0);
    /// # Ok(()) }
    /// ```
    pub fn component_of(&self, vertex: VertexId) -> usize {
        self.forest.tree[vertex.index()] as usize
    }

    /// The base vertex of a component.
    ///
    /// # Panics
    /// If there is no such component; so do the functions that follow.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_complexes::known_spaces;
    /// use coface_topology::EdgePathGroups;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The rim of a triangle.
    /// let skeleton = known_spaces::circle(3)?.freeze().two_skeleton()?;
    /// let groups = EdgePathGroups::new(&skeleton);
    /// assert_eq!(groups.base(0), VertexId::new(0));
    /// # Ok(()) }
    /// ```
    pub fn base(&self, component: usize) -> VertexId {
        self.components[component].base
    }

    /// The group of a component by generators and relators.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::known_spaces;
    /// use coface_topology::EdgePathGroups;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The rim of a triangle.
    /// let skeleton = known_spaces::circle(3)?.freeze().two_skeleton()?;
    /// let groups = EdgePathGroups::new(&skeleton);
    /// assert_eq!(groups.presentation(0).generator_count(), 1);
    /// # Ok(()) }
    /// ```
    pub fn presentation(&self, component: usize) -> &Presentation {
        &self.components[component].presentation
    }

    /// The edge that each generator of a component runs through.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::known_spaces;
    /// use coface_topology::EdgePathGroups;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The rim of a triangle.
    /// let skeleton = known_spaces::circle(3)?.freeze().two_skeleton()?;
    /// let groups = EdgePathGroups::new(&skeleton);
    /// assert_eq!(groups.generator_edges(0).len(), 1);
    /// # Ok(()) }
    /// ```
    pub fn generator_edges(&self, component: usize) -> &[EdgeId] {
        &self.components[component].generator_edges
    }

    /// The faces that gave an edge its word, in their order: all other edges of such a face had words before.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::known_spaces;
    /// use coface_topology::EdgePathGroups;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Of the 21 edges of the torus 6 are in the tree and 2 are generators; 13 faces give the others, and the last is the relator.
    /// let skeleton = known_spaces::cyclic_torus(2)?.freeze().two_skeleton()?;
    /// assert_eq!(EdgePathGroups::new(&skeleton).determining_faces().len(), 13);
    /// # Ok(()) }
    /// ```
    pub fn determining_faces(&self) -> &[FaceId] {
        &self.determining
    }

    /// The path along the tree from the base of its component to a vertex.
    ///
    /// # Panics
    /// If there is no such vertex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_complexes::known_spaces;
    /// use coface_topology::EdgePathGroups;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The rim of a triangle.
    /// let skeleton = known_spaces::circle(3)?.freeze().two_skeleton()?;
    /// let groups = EdgePathGroups::new(&skeleton);
    /// assert!(groups.path_to(VertexId::new(0)).is_empty());
    /// assert_eq!(groups.path_to(VertexId::new(1)).len(), 1);
    /// # Ok(()) }
    /// ```
    pub fn path_to(&self, vertex: VertexId) -> Vec<(EdgeId, Sign)> {
        signed(self.forest.path_to(vertex.to_u32(), &self.ends))
    }

    /// The loop at the base of its component that runs along the tree to an edge, along it and back along the tree, as
    /// steps.
    ///
    /// # Panics
    /// If there is no such edge.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::known_spaces;
    /// use coface_topology::EdgePathGroups;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The rim of a triangle.
    /// let skeleton = known_spaces::circle(3)?.freeze().two_skeleton()?;
    /// let groups = EdgePathGroups::new(&skeleton);
    /// assert_eq!(groups.loop_through(groups.generator_edges(0)[0]).len(), 3);
    /// # Ok(()) }
    /// ```
    pub fn loop_through(&self, edge: EdgeId) -> Vec<(EdgeId, Sign)> {
        let [source, target] = [0, 1].map(|side| self.ends[2 * edge.index() + side]);
        let mut steps = self.forest.path_to(source, &self.ends);
        steps.push(2 * edge.to_u32());
        steps.extend(self.forest.path_to(target, &self.ends).into_iter().rev().map(|step| step ^ 1));
        signed(steps)
    }

    /// A loop at the base of a component for a word in its generators: their loops one after the other, without steps
    /// there and back.
    ///
    /// # Panics
    /// If a letter is no generator.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_complexes::known_spaces;
    /// use coface_topology::EdgePathGroups;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The rim of a triangle.
    /// let skeleton = known_spaces::circle(3)?.freeze().two_skeleton()?;
    /// let groups = EdgePathGroups::new(&skeleton);
    /// assert_eq!(groups.loop_of_word(0, &Word::from_letters([1, 1])).len(), 6);
    /// # Ok(()) }
    /// ```
    pub fn loop_of_word(&self, component: usize, word: &Word) -> Vec<(EdgeId, Sign)> {
        let edges = &self.components[component].generator_edges;
        let mut path: Vec<(EdgeId, Sign)> = Vec::new();
        for &letter in word.letters() {
            let mut steps = self.loop_through(edges[letter.unsigned_abs() as usize - 1]);
            if letter < 0 {
                steps.reverse();
                steps.iter_mut().for_each(|(_, sign)| *sign = sign.opposite());
            }
            for (edge, sign) in steps {
                if path.last() == Some(&(edge, sign.opposite())) {
                    path.pop();
                } else {
                    path.push((edge, sign));
                }
            }
        }
        path
    }

    /// The loop for a word as the vertices it meets, the base first and last. The unit stays at the base.
    ///
    /// # Panics
    /// If a letter is no generator.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_complexes::known_spaces;
    /// use coface_topology::EdgePathGroups;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let groups = EdgePathGroups::new(&known_spaces::circle(3)?.freeze().two_skeleton()?);
    /// let once = groups.loop_vertices(0, &Word::from_letters([1]));
    /// assert_eq!((once.len(), once[0], once[3]), (4, groups.base(0), groups.base(0)));
    /// assert_eq!(groups.loop_vertices(0, &Word::from_letters([1, 1])).len(), 7);
    /// # Ok(()) }
    /// ```
    pub fn loop_vertices(&self, component: usize, word: &Word) -> Vec<VertexId> {
        let mut vertices = vec![self.components[component].base];
        let steps = self.loop_of_word(component, word);
        vertices.extend(steps.into_iter().map(|(edge, sign)| self.target(edge, sign)));
        vertices
    }

    /// The abelianizations of all components together: H_1 of the complex.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::known_spaces;
    /// use coface_topology::EdgePathGroups;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The rim of a triangle.
    /// let skeleton = known_spaces::circle(3)?.freeze().two_skeleton()?;
    /// let groups = EdgePathGroups::new(&skeleton);
    /// assert_eq!(groups.first_homology().to_string(), "Z");
    /// # Ok(()) }
    /// ```
    pub fn first_homology(&self) -> AbelianGroup {
        let groups = self.components.iter().map(|component| component.presentation.abelianization());
        let (mut betti, mut torsion) = (0, Vec::new());
        for group in groups {
            betti += group.betti();
            torsion.extend_from_slice(group.torsion());
        }
        AbelianGroup::new(betti, torsion)
    }

    /// The vertex at the end of a step.
    fn target(&self, edge: EdgeId, sign: Sign) -> VertexId {
        VertexId::from_u32(self.ends[2 * edge.index() + usize::from(sign == Sign::Plus)])
    }

    /// The loop through an edge as a word in the generators of its component.
    ///
    /// # Panics
    /// If there is no such edge.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::known_spaces;
    /// use coface_topology::EdgePathGroups;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The rim of a triangle.
    /// let skeleton = known_spaces::circle(3)?.freeze().two_skeleton()?;
    /// let groups = EdgePathGroups::new(&skeleton);
    /// let edge = groups.generator_edges(0)[0];
    /// assert_eq!(groups.word_of_edge(edge).letters(), [1]);
    /// # Ok(()) }
    /// ```
    pub fn word_of_edge(&self, edge: EdgeId) -> Word {
        word_of(&self.words, self.edge_words[edge.index()])
    }

    /// A closed path as a word in the generators of its component, up to the path along the tree from the base to the
    /// start of the path and back, which is the unit.
    ///
    /// # Errors
    /// [`ErrorKind::NotInComplex`] naming an edge that does not exist; [`ErrorKind::InvalidInput`] naming the first
    /// step that does not start where the one before ends, the last one before the first.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::EdgeId;
    /// use coface_algebra::Sign;
    /// use coface_complexes::known_spaces;
    /// use coface_topology::EdgePathGroups;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The edges are 01, 02, 12.
    /// let groups = EdgePathGroups::new(&known_spaces::circle(3)?.freeze().two_skeleton()?);
    /// let around = [(EdgeId::new(0), Sign::Plus), (EdgeId::new(2), Sign::Plus), (EdgeId::new(1), Sign::Minus)];
    /// assert_eq!(groups.word_of_path(&around)?.len(), 1);
    /// # Ok(()) }
    /// ```
    pub fn word_of_path(&self, path: &[(EdgeId, Sign)]) -> Result<Word, Error> {
        if let Some((edge, _)) = path.iter().find(|(edge, _)| edge.index() >= self.edge_words.len()) {
            return Err(Error::new(
                ErrorKind::NotInComplex,
                format!("there is no edge {edge}; the complex has {}", self.edge_words.len()),
            ));
        }
        let Some(&(last, sign)) = path.last() else { return Ok(Word::new()) };
        let mut at = self.target(last, sign);
        let mut word = Word::new();
        for (i, &(edge, sign)) in path.iter().enumerate() {
            let source = self.target(edge, sign.opposite());
            if source != at {
                return Err(Error::invalid(format!(
                    "step {i} of the path starts at {source}, but the step before ends at {at}"
                ))
                .with_cure("give the steps of a closed path in order"));
            }
            at = self.target(edge, sign);
            let own = self.word_of_edge(edge);
            word.append(&if sign == Sign::Plus { own } else { own.inverse() });
        }
        Ok(word)
    }
}

/// Steps as edges with signs.
fn signed(steps: Vec<u32>) -> Vec<(EdgeId, Sign)> {
    let sign = |step: u32| Sign::power_of_minus_one((step & 1) as usize);
    steps.into_iter().map(|step| (EdgeId::from_u32(step >> 1), sign(step))).collect()
}

/// The word with this number of a word table.
fn word_of(words: &[Word], number: u32) -> Word {
    let word = &words[number as usize / 2];
    if number & 1 == 0 { word.clone() } else { word.inverse() }
}
