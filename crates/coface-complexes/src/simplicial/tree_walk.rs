//! Walks through a simplex tree: all simplices below a node in lexicographic order.

use super::tree::{Node, ROOT, Tree};
use std::collections::btree_map;
use std::slice;

/// The children of one node as pairs (vertex, node), by rising vertex.
#[derive(Clone, Debug)]
pub(super) enum Cursor<'a> {
    Run { first: u32, nodes: slice::Iter<'a, Node> },
    Block(slice::Iter<'a, (u32, u32)>),
    Hub(btree_map::Iter<'a, u32, u32>),
}

impl Iterator for Cursor<'_> {
    type Item = (u32, u32);

    fn next(&mut self) -> Option<(u32, u32)> {
        match self {
            Self::Run { first, nodes } => {
                let node = nodes.next()?;
                *first += 1;
                Some((node.vertex, *first - 1))
            }
            Self::Block(entries) => entries.next().copied(),
            Self::Hub(entries) => entries.next().map(|(&vertex, &node)| (vertex, node)),
        }
    }
}

/// A walk through the nodes below a node, in lexicographic order, down to a depth.
#[derive(Clone, Debug)]
pub(super) struct Walk<'a> {
    tree: &'a Tree,
    /// The vertices of the simplex the walk is at.
    path: Vec<u32>,
    /// The vertices that all simplices of this walk have in common.
    common: usize,
    cursors: Vec<Cursor<'a>>,
    depth_limit: usize,
}

impl<'a> Walk<'a> {
    /// The walk through all simplices of at most `vertex_limit` vertices.
    pub(super) fn new(tree: &'a Tree, vertex_limit: usize) -> Self {
        let mut walk =
            Self { tree, path: Vec::new(), common: 0, cursors: Vec::new(), depth_limit: vertex_limit };
        if vertex_limit > 0 {
            walk.cursors.push(tree.cursor(ROOT));
        }
        walk
    }

    /// A walk that is over.
    pub(super) fn finished(tree: &'a Tree) -> Self {
        Self::new(tree, 0)
    }

    /// Begins the walk through what is below `node`; the walk stands at `node`.
    pub(super) fn restart_at(&mut self, node: u32) {
        self.depth_limit = usize::MAX;
        self.tree.path_to(node, &mut self.path);
        self.common = self.path.len();
        self.cursors.clear();
        if !self.tree.children(node).is_empty() {
            self.cursors.push(self.tree.cursor(node));
        }
    }

    /// Goes on to the next simplex; false at the end.
    pub(super) fn advance(&mut self) -> bool {
        loop {
            let depth = self.common + self.cursors.len();
            let Some(cursor) = self.cursors.last_mut() else { return false };
            match cursor.next() {
                Some((vertex, node)) => {
                    self.path.truncate(depth - 1);
                    self.path.push(vertex);
                    if depth < self.depth_limit && !self.tree.children(node).is_empty() {
                        self.cursors.push(self.tree.cursor(node));
                    }
                    return true;
                }
                None => {
                    self.cursors.pop();
                }
            }
        }
    }

    /// The vertices of the simplex the walk is at.
    pub(super) fn path(&self) -> &[u32] {
        &self.path
    }

    /// Whether no simplex continues the one the walk is at. Meaningful without a depth limit.
    pub(super) fn is_at_leaf(&self) -> bool {
        self.path.len() == self.common + self.cursors.len()
    }
}

/// A walk through the cofaces of one simplex, itself included.
#[derive(Clone, Debug)]
pub(super) struct CofaceWalk<'a> {
    vertices: Vec<u32>,
    ring: u32,
    /// The next node of the ring to look at; none at the end.
    next: Option<u32>,
    walk: Walk<'a>,
}

impl<'a> CofaceWalk<'a> {
    pub(super) fn new(tree: &'a Tree, vertices: &[u32]) -> Self {
        let ring = tree.find(vertices).and_then(|_| tree.find_child(ROOT, *vertices.last()?));
        Self {
            vertices: vertices.to_vec(),
            ring: ring.unwrap_or(ROOT),
            next: ring,
            walk: Walk::finished(tree),
        }
    }

    /// Goes on to the next coface; false at the end.
    pub(super) fn advance(&mut self) -> bool {
        if self.walk.advance() {
            return true;
        }
        let tree = self.walk.tree;
        while let Some(at) = self.next {
            let next = tree.nodes[at as usize].next;
            self.next = (next != self.ring).then_some(next);
            if tree.contains_path(at, &self.vertices) {
                self.walk.restart_at(at);
                return true;
            }
        }
        false
    }

    /// The vertices of the coface the walk is at.
    pub(super) fn path(&self) -> &[u32] {
        self.walk.path()
    }

    /// Whether no simplex continues the one the walk is at.
    pub(super) fn is_at_leaf(&self) -> bool {
        self.walk.is_at_leaf()
    }
}
