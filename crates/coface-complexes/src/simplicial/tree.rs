//! The simplex tree: all simplices of a complex as paths in one arena.
//!
//! A node at depth d stands for the d-simplex of the vertices on the path to it, rising. Siblings are held sorted, and
//! all nodes that end in one vertex form a ring through that vertex's node of depth 0, so that the cofaces of a
//! simplex are the subtrees below the nodes of one ring and the tree is never searched as a whole.
//!
//! Siblings made together lie side by side in the arena and need no list of their own (a run); siblings that came one
//! by one are listed in a block, many of them in a search tree (a hub). Erased nodes stay in the arena until they
//! are half of it; then the tree is copied.
//!
//! Source: J.-D. Boissonnat, C. Maria, *The simplex tree: an efficient data structure for general simplicial
//! complexes* (2014). Runs instead of allocated sibling sets and rings in one arena are ours.

use super::tree_walk::Cursor;
use coface_algebra::{Error, ErrorKind};
use std::collections::BTreeMap;

/// The parent of the nodes of depth 0.
pub(super) const ROOT: u32 = u32::MAX;
/// What stands for the ring of an erased node.
const ERASED: u32 = u32::MAX;
/// The most simplices that one call may add: all faces of a simplex of dimension 27.
pub(super) const CALL_LIMIT: usize = 1 << 28;
/// The most nodes of one arena.
pub(super) const ARENA_LIMIT: usize = 1 << 30;
/// More children than these are held in a search tree.
const BLOCK_LIMIT: usize = 64;

#[derive(Clone, Copy, Debug)]
pub(super) struct Node {
    pub(super) vertex: u32,
    pub(super) parent: u32,
    pub(super) children: Children,
    /// The ring of the nodes that end in `vertex`.
    pub(super) next: u32,
    previous: u32,
}

/// Where the children of a node are: a kind in the two highest bits of `tagged`, their number in the others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Children {
    start: u32,
    tagged: u32,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    /// The nodes from `start` on.
    Run,
    /// The entries of the pool from `start` on; room for the next power of two.
    Block,
    /// The hub at position `start`.
    Hub,
}

impl Children {
    const EMPTY: Self = Self { start: 0, tagged: 0 };

    pub(super) fn run(start: u32, count: usize) -> Self {
        Self { start, tagged: count as u32 }
    }

    fn new(kind: Kind, start: usize, count: usize) -> Self {
        Self { start: start as u32, tagged: (kind as u32) << 30 | count as u32 }
    }

    fn kind(self) -> Kind {
        match self.tagged >> 30 {
            0 => Kind::Run,
            1 => Kind::Block,
            _ => Kind::Hub,
        }
    }

    pub(super) fn count(self) -> usize {
        (self.tagged & ((1 << 30) - 1)) as usize
    }

    pub(super) fn is_empty(self) -> bool {
        self.tagged == 0
    }
}

#[derive(Clone, Debug)]
pub(super) struct Tree {
    pub(super) nodes: Vec<Node>,
    root: Children,
    /// Children of blocks as (vertex, node), sorted within a block.
    pool: Vec<(u32, u32)>,
    hubs: Vec<BTreeMap<u32, u32>>,
    /// The number of simplices of each dimension; the last is not zero.
    counts: Vec<usize>,
    erased_count: usize,
}

impl Default for Tree {
    fn default() -> Self {
        Self {
            nodes: Vec::new(),
            root: Children::EMPTY,
            pool: Vec::new(),
            hubs: Vec::new(),
            counts: Vec::new(),
            erased_count: 0,
        }
    }
}

impl Tree {
    pub(super) fn counts(&self) -> &[usize] {
        &self.counts
    }

    /// The number of simplices.
    pub(super) fn len(&self) -> usize {
        self.nodes.len() - self.erased_count
    }

    pub(super) fn children(&self, parent: u32) -> Children {
        if parent == ROOT { self.root } else { self.nodes[parent as usize].children }
    }

    pub(super) fn set_children(&mut self, parent: u32, children: Children) {
        if parent == ROOT {
            self.root = children;
        } else {
            self.nodes[parent as usize].children = children;
        }
    }

    /// The children as pairs (vertex, node), by rising vertex.
    pub(super) fn cursor(&self, parent: u32) -> Cursor<'_> {
        let children = self.children(parent);
        let (start, count) = (children.start as usize, children.count());
        match children.kind() {
            Kind::Run => {
                Cursor::Run { first: children.start, nodes: self.nodes[start..start + count].iter() }
            }
            Kind::Block => Cursor::Block(self.pool[start..start + count].iter()),
            Kind::Hub => Cursor::Hub(self.hubs[start].iter()),
        }
    }

    pub(super) fn find_child(&self, parent: u32, vertex: u32) -> Option<u32> {
        let children = self.children(parent);
        let (start, count) = (children.start as usize, children.count());
        match children.kind() {
            Kind::Run => {
                let run = &self.nodes[start..start + count];
                // Vertices are often numbered without gaps; then the place is known.
                let guess = vertex.checked_sub(run.first()?.vertex)? as usize;
                if run.get(guess).is_some_and(|node| node.vertex == vertex) {
                    return Some((start + guess) as u32);
                }
                let at = run.partition_point(|node| node.vertex < vertex);
                (run.get(at)?.vertex == vertex).then_some((start + at) as u32)
            }
            Kind::Block => {
                let block = &self.pool[start..start + count];
                let at = block.partition_point(|&(other, _)| other < vertex);
                block.get(at).filter(|&&(other, _)| other == vertex).map(|&(_, node)| node)
            }
            Kind::Hub => self.hubs[start].get(&vertex).copied(),
        }
    }

    /// The node of the simplex with these rising vertices.
    pub(super) fn find(&self, vertices: &[u32]) -> Option<u32> {
        vertices.iter().try_fold(ROOT, |node, &vertex| self.find_child(node, vertex))
    }

    /// The vertices of a node's simplex, rising, put into `path`.
    pub(super) fn path_to(&self, node: u32, path: &mut Vec<u32>) {
        path.clear();
        let mut at = node;
        while at != ROOT {
            let Node { vertex, parent, .. } = self.nodes[at as usize];
            path.push(vertex);
            at = parent;
        }
        path.reverse();
    }

    /// Whether the simplex of `node` has all of these rising vertices, the last of which it is known to end in.
    pub(super) fn contains_path(&self, node: u32, vertices: &[u32]) -> bool {
        let mut wanted = &vertices[..vertices.len() - 1];
        let mut at = self.nodes[node as usize].parent;
        while let Some((&last, rest)) = wanted.split_last() {
            if at == ROOT {
                return false;
            }
            let Node { vertex, parent, .. } = self.nodes[at as usize];
            if vertex < last {
                return false;
            }
            if vertex == last {
                wanted = rest;
            }
            at = parent;
        }
        true
    }

    /// Appends a leaf to the arena and to the ring of `ring`, the node of depth 0 with this vertex (ROOT for the node
    /// that is itself of depth 0). The caller makes it a child of `parent`.
    pub(super) fn push_node(&mut self, vertex: u32, parent: u32, ring: u32) -> u32 {
        let node = self.nodes.len() as u32;
        let (ring, previous) =
            if ring == ROOT { (node, node) } else { (ring, self.nodes[ring as usize].previous) };
        self.nodes.push(Node { vertex, parent, children: Children::EMPTY, next: ring, previous });
        self.nodes[previous as usize].next = node;
        self.nodes[ring as usize].previous = node;
        node
    }

    pub(super) fn count_more(&mut self, depth: usize, more: usize) {
        if self.counts.len() <= depth {
            self.counts.resize(depth + 1, 0);
        }
        self.counts[depth] += more;
    }

    /// Makes room for `more` nodes.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] if there are not so many numbers for nodes, or not so much memory.
    pub(super) fn make_room(&mut self, more: usize) -> Result<(), Error> {
        if self.nodes.len() + more > ARENA_LIMIT && self.erased_count > 0 {
            *self = self.merged(&Self::default());
        }
        if self.nodes.len() + more > ARENA_LIMIT {
            return Err(Error::new(
                ErrorKind::TooLarge,
                format!(
                    "a complex of {} simplices cannot take up to {more} more: the limit is 2^30",
                    self.len()
                ),
            )
            .with_cure("keep a skeleton of lower dimension, or split the complex"));
        }
        self.nodes.try_reserve(more).map_err(|_| {
            Error::new(ErrorKind::TooLarge, format!("there is no memory for {more} more simplices"))
                .with_cure("keep a skeleton of lower dimension, or split the complex")
        })
    }

    /// Inserts the faces of up to `count` of these rising vertices. There must be room for them.
    pub(super) fn insert(&mut self, vertices: &[u32], count: usize) {
        let mut rings = Vec::with_capacity(vertices.len());
        for &vertex in vertices {
            let ring = self.find_child(ROOT, vertex).unwrap_or_else(|| {
                let node = self.push_node(vertex, ROOT, ROOT);
                self.add_child(ROOT, vertex, node);
                self.count_more(0, 1);
                node
            });
            rings.push(ring);
        }
        if count > 1 {
            for i in 0..vertices.len() {
                self.insert_below(rings[i], &vertices[i + 1..], &rings[i + 1..], 1, count);
            }
        }
    }

    fn insert_below(&mut self, parent: u32, vertices: &[u32], rings: &[u32], depth: usize, end: usize) {
        if vertices.is_empty() || depth == end {
            return;
        }
        if self.nodes[parent as usize].children.is_empty() {
            let first = self.nodes.len() as u32;
            for (&vertex, &ring) in vertices.iter().zip(rings) {
                self.push_node(vertex, parent, ring);
            }
            self.nodes[parent as usize].children = Children::run(first, vertices.len());
            self.count_more(depth, vertices.len());
            for i in 0..vertices.len() {
                self.insert_below(first + i as u32, &vertices[i + 1..], &rings[i + 1..], depth + 1, end);
            }
            return;
        }
        for (i, &vertex) in vertices.iter().enumerate() {
            let child = self.find_child(parent, vertex).unwrap_or_else(|| {
                let node = self.push_node(vertex, parent, rings[i]);
                self.add_child(parent, vertex, node);
                self.count_more(depth, 1);
                node
            });
            self.insert_below(child, &vertices[i + 1..], &rings[i + 1..], depth + 1, end);
        }
    }

    /// Lists `node`, which ends in `vertex`, among the children of `parent`.
    fn add_child(&mut self, parent: u32, vertex: u32, node: u32) {
        let children = self.children(parent);
        let (start, count) = (children.start as usize, children.count());
        let changed = match children.kind() {
            Kind::Run if count == 0 => Children::run(node, 1),
            Kind::Run if node as usize == start + count && self.nodes[node as usize - 1].vertex < vertex => {
                Children::run(children.start, count + 1)
            }
            Kind::Hub => {
                self.hubs[start].insert(vertex, node);
                Children::new(Kind::Hub, start, count + 1)
            }
            Kind::Block if !count.is_power_of_two() => {
                let at =
                    start + self.pool[start..start + count].partition_point(|&(other, _)| other < vertex);
                self.pool.copy_within(at..start + count, at + 1);
                self.pool[at] = (vertex, node);
                Children::new(Kind::Block, start, count + 1)
            }
            Kind::Run | Kind::Block => {
                let mut entries: Vec<(u32, u32)> = self.cursor(parent).collect();
                entries.insert(entries.partition_point(|&(other, _)| other < vertex), (vertex, node));
                self.listed(entries)
            }
        };
        self.set_children(parent, changed);
    }

    /// Takes the child that ends in `vertex` off the list of `parent`.
    fn remove_child(&mut self, parent: u32, vertex: u32) {
        let children = self.children(parent);
        let (start, count) = (children.start as usize, children.count());
        let changed = match children.kind() {
            _ if count == 1 => Children::EMPTY,
            Kind::Run if self.nodes[start].vertex == vertex => Children::run(children.start + 1, count - 1),
            Kind::Run if self.nodes[start + count - 1].vertex == vertex => {
                Children::run(children.start, count - 1)
            }
            Kind::Run => {
                let entries = self.cursor(parent).filter(|&(other, _)| other != vertex).collect();
                self.listed(entries)
            }
            Kind::Block => {
                let at =
                    start + self.pool[start..start + count].partition_point(|&(other, _)| other < vertex);
                self.pool.copy_within(at + 1..start + count, at);
                Children::new(Kind::Block, start, count - 1)
            }
            Kind::Hub => {
                self.hubs[start].remove(&vertex);
                Children::new(Kind::Hub, start, count - 1)
            }
        };
        self.set_children(parent, changed);
    }

    /// Children as a new block or hub with these sorted entries.
    fn listed(&mut self, entries: Vec<(u32, u32)>) -> Children {
        let count = entries.len();
        if count > BLOCK_LIMIT {
            self.hubs.push(entries.into_iter().collect());
            return Children::new(Kind::Hub, self.hubs.len() - 1, count);
        }
        let start = self.pool.len();
        self.pool.extend(entries);
        self.pool.resize(start + count.next_power_of_two(), (0, 0));
        Children::new(Kind::Block, start, count)
    }

    /// Copies the tree if most of its storage is not in use.
    pub(super) fn tidy(&mut self) {
        let live = self.len() + 4096;
        if self.erased_count > live || self.pool.len() > 4 * live {
            *self = self.merged(&Self::default());
        }
    }

    /// Erases the simplex with these rising vertices and its cofaces; tells whether it was there.
    pub(super) fn erase(&mut self, vertices: &[u32]) -> bool {
        let Some((&last, _)) = vertices.split_last() else { return false };
        let (Some(_), Some(ring)) = (self.find(vertices), self.find_child(ROOT, last)) else { return false };
        let tops: Vec<u32> = self.ring(ring).filter(|&at| self.contains_path(at, vertices)).collect();
        let mut path = Vec::new();
        for top in tops {
            self.path_to(top, &mut path);
            self.remove_child(self.nodes[top as usize].parent, last);
            self.erase_subtree(top, path.len() - 1);
        }
        while self.counts.last() == Some(&0) {
            self.counts.pop();
        }
        self.tidy();
        true
    }

    fn erase_subtree(&mut self, node: u32, depth: usize) {
        let children: Vec<u32> = self.cursor(node).map(|(_, child)| child).collect();
        for child in children {
            self.erase_subtree(child, depth + 1);
        }
        let Node { next, previous, .. } = self.nodes[node as usize];
        self.nodes[previous as usize].next = next;
        self.nodes[next as usize].previous = previous;
        self.nodes[node as usize].next = ERASED;
        self.counts[depth] -= 1;
        self.erased_count += 1;
    }

    /// The nodes of a ring, its node of depth 0 first.
    pub(super) fn ring(&self, ring: u32) -> impl Iterator<Item = u32> + '_ {
        std::iter::successors(Some(ring), move |&at| {
            let next = self.nodes[at as usize].next;
            (next != ring).then_some(next)
        })
    }

    /// The smaller ends of the edges that end in the vertex of `ring`, in no order.
    pub(super) fn edges_to(&self, ring: u32) -> impl Iterator<Item = u32> + '_ {
        self.ring(ring).skip(1).filter_map(|at| {
            let parent = self.nodes[self.nodes[at as usize].parent as usize];
            (parent.parent == ROOT).then_some(parent.vertex)
        })
    }

    /// For each place of the arena, whether it is erased or stands for a proper face of another simplex.
    pub(super) fn proper_faces(&self) -> Vec<bool> {
        let mut is_face: Vec<bool> = self.nodes.iter().map(|node| node.next == ERASED).collect();
        self.mark_faces(ROOT, 0, &mut Vec::new(), &mut is_face);
        is_face
    }

    /// Marks the facets of all nodes below `parent`, whose own facets are on the stack from `begin` on. The facets of a
    /// child are `parent` and those children of the parent's facets that end in the same vertex.
    fn mark_faces(&self, parent: u32, begin: usize, stack: &mut Vec<u32>, is_face: &mut [bool]) {
        let end = stack.len();
        let width = end - begin + 1;
        let child_count = self.children(parent).count();
        stack.resize(end + child_count * width, parent);
        if parent != ROOT && child_count > 0 {
            is_face[parent as usize] = true;
        }
        for i in begin..end {
            let facet = stack[i];
            let is_long = self.children(facet).count() > 8 * child_count;
            let mut cousins = self.cursor(facet);
            for (at, (vertex, _)) in self.cursor(parent).enumerate() {
                let cousin = if is_long {
                    self.find_child(facet, vertex)
                } else {
                    cousins.find(|&(other, _)| other == vertex).map(|(_, cousin)| cousin)
                };
                let cousin = cousin.expect("a complex has all faces of its simplices");
                is_face[cousin as usize] = true;
                stack[end + at * width + i - begin] = cousin;
            }
        }
        for (at, (_, child)) in self.cursor(parent).enumerate() {
            if !self.nodes[child as usize].children.is_empty() {
                let top = stack.len();
                stack.extend_from_within(end + at * width..end + (at + 1) * width);
                self.mark_faces(child, top, stack, is_face);
                stack.truncate(top);
            }
        }
        stack.truncate(end);
    }

    /// Verifies the structure: sorted siblings, parents, rings, counts and closure under faces.
    ///
    /// # Errors
    /// [`ErrorKind::NotAComplex`] naming the first fault.
    pub(super) fn check(&self) -> Result<(), Error> {
        let mut counts = vec![0; self.counts.len()];
        self.check_below(ROOT, &[], &mut counts)?;
        let ring_total: usize = self.cursor(ROOT).map(|(vertex, ring)| self.ring_length(vertex, ring)).sum();
        if counts != self.counts || counts.iter().sum::<usize>() != self.len() || ring_total != self.len() {
            return Err(broken(format!("the counts {:?} do not fit {counts:?} simplices", self.counts)));
        }
        Ok(())
    }

    /// The number of nodes in a ring that end in its vertex.
    fn ring_length(&self, vertex: u32, ring: u32) -> usize {
        let mut at = ring;
        for length in 1..=self.nodes.len() {
            let node = self.nodes[at as usize];
            if node.next == ERASED || node.vertex != vertex || self.nodes[node.next as usize].previous != at {
                return 0;
            }
            at = node.next;
            if at == ring {
                return length;
            }
        }
        0
    }

    /// `facets` are the nodes of the facets of `parent`, which are all in the tree.
    fn check_below(&self, parent: u32, facets: &[u32], counts: &mut [usize]) -> Result<(), Error> {
        let mut before = None;
        let mut path = Vec::new();
        for (vertex, child) in self.cursor(parent) {
            self.path_to(child, &mut path);
            let node = &self.nodes[child as usize];
            if node.vertex != vertex || node.parent != parent || before >= Some(vertex) || node.next == ERASED
            {
                return Err(broken(format!("the tree is out of order at {path:?}")));
            }
            before = Some(vertex);
            let Some(count) = counts.get_mut(path.len() - 1) else {
                return Err(broken(format!("the simplex {path:?} is not counted")));
            };
            *count += 1;
            let mut own = Vec::with_capacity(path.len());
            for (i, &facet) in facets.iter().enumerate() {
                own.push(self.find_child(facet, vertex).ok_or_else(|| {
                    let mut face = path.clone();
                    face.remove(i);
                    broken(format!("the face {face:?} of {path:?} is missing"))
                })?);
            }
            // The facet without the last vertex: the parent, or the empty set that stands above all vertices.
            own.push(parent);
            self.check_below(child, &own, counts)?;
        }
        Ok(())
    }
}

fn broken(message: String) -> Error {
    Error::new(ErrorKind::NotAComplex, message)
}
