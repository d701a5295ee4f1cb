//! Many simplices at once: building a simplex tree from lists, and merging two trees.

use super::lists::{FaceWalk, Growth, Lists, too_many_faces};
use super::tree::{CALL_LIMIT, Children, ROOT, Tree};
use coface_algebra::Error;
use std::iter::Peekable;

impl Growth for Tree {
    fn add_children(
        &mut self,
        parent: u32,
        depth: usize,
        ranks: impl ExactSizeIterator<Item = u32> + Clone,
    ) -> u32 {
        let first = self.nodes.len() as u32;
        let count = ranks.len();
        for rank in ranks {
            let ring = if parent == ROOT { ROOT } else { rank };
            self.push_node(rank, parent, ring);
        }
        self.set_children(parent, Children::run(first, count));
        self.count_more(depth, count);
        first
    }

    fn reserve(&mut self, more: usize) -> Result<(), Error> {
        if self.nodes.len() + more > CALL_LIMIT {
            return Err(too_many_faces());
        }
        self.make_room(more)
    }
}

impl Tree {
    /// The tree of all faces of these lists. Siblings lie side by side and subtrees after one another.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`](coface_algebra::ErrorKind::TooLarge) beyond 2^28 simplices.
    ///
    /// # Complexity
    /// $O(f \log g)$ for f pairs (list, face) and at most g of them below one node.
    pub(super) fn from_lists(lists: &Lists) -> Result<Self, Error> {
        let mut tree = Self::default();
        let count = lists.names.len();
        if count == 0 {
            return Ok(tree);
        }
        tree.reserve(count)?;
        tree.add_children(ROOT, 0, 0..count as u32);
        let (starts, positions) = lists.occurrences();
        let mut walk = FaceWalk::new(lists, tree);
        for rank in 0..count {
            let group = &positions[starts[rank] as usize..starts[rank + 1] as usize];
            walk.grow_from_vertex(rank as u32, group)?;
        }
        let mut tree = walk.into_growth();
        if lists.names[count - 1] as usize >= count {
            for node in &mut tree.nodes {
                node.vertex = lists.names[node.vertex as usize];
            }
        }
        Ok(tree)
    }

    /// The tree of the simplices of either, in a fresh arena.
    pub(super) fn merged(&self, other: &Self) -> Self {
        let mut union = Self::default();
        union.nodes.reserve_exact(self.len().max(other.len()));
        union.merge_below(ROOT, (self, Some(ROOT)), (other, Some(ROOT)), 0);
        union
    }

    fn merge_below(&mut self, parent: u32, a: (&Self, Option<u32>), b: (&Self, Option<u32>), depth: usize) {
        let mut left = a.1.map(|node| a.0.cursor(node)).into_iter().flatten().peekable();
        let mut right = b.1.map(|node| b.0.cursor(node)).into_iter().flatten().peekable();
        let first = self.nodes.len();
        let mut sources = Vec::new();
        while let Some((vertex, from_a, from_b)) = next_of_both(&mut left, &mut right) {
            let ring = if parent == ROOT {
                ROOT
            } else {
                self.find_child(ROOT, vertex).expect("every vertex of a simplex is in the tree")
            };
            self.push_node(vertex, parent, ring);
            sources.push((from_a, from_b));
        }
        if sources.is_empty() {
            return;
        }
        self.set_children(parent, Children::run(first as u32, sources.len()));
        self.count_more(depth, sources.len());
        for (i, (from_a, from_b)) in sources.into_iter().enumerate() {
            self.merge_below((first + i) as u32, (a.0, from_a), (b.0, from_b), depth + 1);
        }
    }
}

/// The next vertex of either of two rising sequences, with its node in each.
fn next_of_both(
    left: &mut Peekable<impl Iterator<Item = (u32, u32)>>,
    right: &mut Peekable<impl Iterator<Item = (u32, u32)>>,
) -> Option<(u32, Option<u32>, Option<u32>)> {
    let vertex = match (left.peek(), right.peek()) {
        (Some(&(a, _)), Some(&(b, _))) => a.min(b),
        (Some(&(a, _)), None) => a,
        (None, Some(&(b, _))) => b,
        (None, None) => return None,
    };
    let from_left = left.next_if(|&(other, _)| other == vertex).map(|(_, node)| node);
    let from_right = right.next_if(|&(other, _)| other == vertex).map(|(_, node)| node);
    Some((vertex, from_left, from_right))
}
