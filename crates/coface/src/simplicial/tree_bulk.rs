//! Many simplices at once: building a simplex tree from lists, and merging two trees.
//!
//! Below a node the lists that contain its simplex are looked at together: each gives the vertices after that simplex,
//! these are sorted, and equal ones are the next child. Each (list, face) pair is sorted once, in a short array, and
//! nodes come out with siblings side by side and subtrees after one another.

use super::simplex::repeated;
use super::tree::{CALL_LIMIT, Children, ROOT, Tree};
use crate::{Error, ErrorKind};
use std::iter::Peekable;

/// Ends each list of [`Lists`]; the numbers before it are smaller.
pub(super) const END: u32 = u32::MAX;

/// Vertex lists made ready for building: sorted, checked, with the vertices renumbered without gaps.
pub(super) struct Lists {
    /// The original numbers of the vertices, rising.
    pub(super) names: Vec<u32>,
    /// The lists one after the other as ranks in `names`, each rising and followed by [`END`].
    pub(super) ranks: Vec<u32>,
    /// The greatest number of vertices in a list.
    pub(super) longest: usize,
    /// Upper bound of the number of faces of all lists.
    pub(super) face_bound: u64,
}

impl Lists {
    /// # Errors
    /// [`ErrorKind::InvalidInput`] for an empty list or a repeated vertex; [`ErrorKind::TooLarge`] for a list with
    /// more faces than one call may add, and for 2^32 vertices in all.
    pub(super) fn new<L: AsRef<[u32]>>(lists: impl IntoIterator<Item = L>) -> Result<Self, Error> {
        let (mut items, mut ends): (Vec<u32>, Vec<u32>) = (Vec::new(), Vec::new());
        let (mut longest, mut face_bound, mut greatest) = (0, 0u64, 0);
        for (position, list) in lists.into_iter().enumerate() {
            let list = list.as_ref();
            let start = items.len();
            items.extend_from_slice(list);
            let own = &mut items[start..];
            if !own.is_sorted_by(|a, b| a < b) {
                own.sort_unstable();
                if let Some(pair) = own.windows(2).find(|pair| pair[0] == pair[1]) {
                    return Err(in_list(&repeated(pair[0], list), position));
                }
            }
            let Some(&last) = own.last() else {
                return Err(Error::invalid(format!("list {position} has no vertex"))
                    .with_cure("name at least one vertex in each simplex"));
            };
            check_face_count(list.len(), list.len())?;
            greatest = greatest.max(last);
            longest = longest.max(list.len());
            face_bound = face_bound.saturating_add((1 << list.len()) - 1);
            ends.push(items.len() as u32);
            items.push(END);
        }
        if u32::try_from(items.len()).is_err() {
            return Err(Error::new(
                ErrorKind::TooLarge,
                "the lists have 2^32 vertices or more in all, too many for one call",
            )
            .with_cure("insert them in several calls"));
        }
        let names = renumber(&mut items, &ends, greatest);
        Ok(Self { names, ranks: items, longest, face_bound })
    }

    /// Where each vertex occurs: the positions in `ranks` of vertex r are `positions[starts[r]..starts[r + 1]]`.
    pub(super) fn occurrences(&self) -> (Vec<u32>, Vec<u32>) {
        let mut starts = vec![0u32; self.names.len() + 2];
        for &rank in self.ranks.iter().filter(|&&rank| rank != END) {
            starts[rank as usize + 2] += 1;
        }
        for i in 2..starts.len() {
            starts[i] += starts[i - 1];
        }
        let total = starts.last().map_or(0, |&total| total as usize);
        let mut positions = vec![0u32; total];
        for (at, &rank) in self.ranks.iter().enumerate().filter(|&(_, &rank)| rank != END) {
            let next = &mut starts[rank as usize + 1];
            positions[*next as usize] = at as u32;
            *next += 1;
        }
        starts.pop();
        (starts, positions)
    }

    /// The lists of ranks.
    pub(super) fn iter(&self) -> impl Iterator<Item = &[u32]> {
        self.ranks.split(|&rank| rank == END).filter(|list| !list.is_empty())
    }

    /// The ranks after a position in its list.
    pub(super) fn rest(&self, position: u32) -> &[u32] {
        let rest = &self.ranks[position as usize + 1..];
        let count = rest.iter().take_while(|&&rank| rank != END).count();
        &rest[..count]
    }
}

/// Replaces the numbers by their ranks and gives the numbers in use, rising. The places of `ends` stay.
fn renumber(items: &mut [u32], ends: &[u32], greatest: u32) -> Vec<u32> {
    if items.is_empty() {
        return Vec::new();
    }
    if greatest < END && greatest as usize <= 4 * items.len() {
        let mut ranks = vec![END; greatest as usize + 1];
        for &item in items.iter().filter(|&&item| item != END) {
            ranks[item as usize] = 0;
        }
        let names: Vec<u32> = (0..=greatest).filter(|&number| ranks[number as usize] != END).collect();
        if names.len() < ranks.len() {
            for (rank, &name) in names.iter().enumerate() {
                ranks[name as usize] = rank as u32;
            }
            for item in items.iter_mut().filter(|item| **item != END) {
                *item = ranks[*item as usize];
            }
        }
        return names;
    }
    // END is also a possible number of a vertex here, so the lists are taken one by one.
    let mut names = Vec::with_capacity(items.len() - ends.len());
    let mut start = 0;
    for &end in ends {
        names.extend_from_slice(&items[start..end as usize]);
        start = end as usize + 1;
    }
    names.sort_unstable();
    names.dedup();
    start = 0;
    for &end in ends {
        for item in &mut items[start..end as usize] {
            *item = names.partition_point(|name| name < item) as u32;
        }
        start = end as usize + 1;
    }
    names
}

fn in_list(error: &Error, position: usize) -> Error {
    let cure = error.cure().unwrap_or_default().to_owned();
    Error::new(error.kind(), format!("list {position}: {}", error.message())).with_cure(cure)
}

/// The number of faces of a simplex that have at most `limit` vertices.
///
/// # Errors
/// [`ErrorKind::TooLarge`] if they are more than one call may add.
pub(super) fn check_face_count(vertex_count: usize, limit: usize) -> Result<usize, Error> {
    let (mut total, mut binomial) = (0u128, 1u128);
    for k in 1..=limit.min(vertex_count) {
        binomial = binomial * (vertex_count + 1 - k) as u128 / k as u128;
        total += binomial;
        if total > CALL_LIMIT as u128 {
            return Err(Error::new(
                ErrorKind::TooLarge,
                format!(
                    "a simplex of dimension {} has more than 2^28 faces of dimension up to {}",
                    vertex_count - 1,
                    limit.min(vertex_count) - 1
                ),
            )
            .with_cure("insert its skeleton of lower dimension (insert_skeleton)"));
        }
    }
    Ok(total as usize)
}

/// Lists that are looked at together are freed of repetitions when they are more than this.
const CROWD: usize = 64;

/// The state of a tree being built from lists.
struct Builder<'a> {
    lists: &'a Lists,
    tree: Tree,
    /// Groups of (vertex, position in the lists), one level of the tree upon the other.
    stack: Vec<u64>,
}

impl Tree {
    /// The tree of all faces of these lists.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] beyond 2^28 simplices.
    ///
    /// # Complexity
    /// $O(f \log g)$ for f pairs (list, face) and at most g of them below one node.
    pub(super) fn from_lists(lists: &Lists) -> Result<Self, Error> {
        let mut builder = Builder { lists, tree: Self::default(), stack: Vec::new() };
        builder.tree.reserve(lists.names.len())?;
        for rank in 0..lists.names.len() {
            builder.tree.push_node(rank as u32, ROOT, ROOT);
        }
        if !lists.names.is_empty() {
            builder.tree.set_children(ROOT, Children::run(0, lists.names.len()));
            builder.tree.count_more(0, lists.names.len());
        }
        let (starts, positions) = lists.occurrences();
        for rank in 0..lists.names.len() {
            let group = &positions[starts[rank] as usize..starts[rank + 1] as usize];
            builder.stack.clear();
            builder.stack.extend(group.iter().map(|&position| u64::from(position)));
            builder.grow(rank as u32, 0, 1)?;
        }
        let mut tree = builder.tree;
        if lists.names.last().is_some_and(|&last| last as usize >= lists.names.len()) {
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

impl Builder<'_> {
    /// Grows the tree below `parent`, whose simplex ends at the positions from `begin` on in the stack.
    fn grow(&mut self, parent: u32, begin: usize, depth: usize) -> Result<(), Error> {
        let lists = self.lists;
        let end = self.stack.len();
        if end - begin == 1 {
            return self.grow_one(parent, lists.rest(self.stack[begin] as u32), depth);
        }
        if end - begin > CROWD {
            self.thin_out(begin);
        }
        let end = self.stack.len();
        for i in begin..end {
            let position = self.stack[i] as u32;
            let rest = lists.rest(position);
            self.stack.extend(
                rest.iter().zip(position + 1..).map(|(&rank, at)| u64::from(rank) << 32 | u64::from(at)),
            );
        }
        let below = self.stack.len();
        if below == end {
            return Ok(());
        }
        self.stack[end..].sort_unstable();
        self.reserve(below - end)?;
        let first = self.tree.nodes.len() as u32;
        let mut before = END;
        for i in end..below {
            let rank = (self.stack[i] >> 32) as u32;
            if rank != before {
                self.tree.push_node(rank, parent, rank);
                before = rank;
            }
        }
        let count = self.tree.nodes.len() - first as usize;
        self.tree.nodes[parent as usize].children = Children::run(first, count);
        self.tree.count_more(depth, count);
        let mut at = end;
        for child in first..first + count as u32 {
            let rank = self.stack[at] >> 32;
            let group_begin = self.stack.len();
            while at < below && self.stack[at] >> 32 == rank {
                self.stack.push(self.stack[at]);
                at += 1;
            }
            self.grow(child, group_begin, depth + 1)?;
            self.stack.truncate(below);
        }
        self.stack.truncate(end);
        Ok(())
    }

    /// All faces of one list below a node.
    fn grow_one(&mut self, parent: u32, rest: &[u32], depth: usize) -> Result<(), Error> {
        if rest.is_empty() {
            return Ok(());
        }
        self.reserve(1 << rest.len())?;
        self.grow_all(parent, rest, depth);
        Ok(())
    }

    fn grow_all(&mut self, parent: u32, rest: &[u32], depth: usize) {
        let first = self.tree.nodes.len() as u32;
        for &rank in rest {
            self.tree.push_node(rank, parent, rank);
        }
        self.tree.nodes[parent as usize].children = Children::run(first, rest.len());
        self.tree.count_more(depth, rest.len());
        for i in 1..rest.len() {
            self.grow_all(first + i as u32 - 1, &rest[i..], depth + 1);
        }
    }

    /// Takes out of the group from `begin` on the lists whose rest repeats or begins another's.
    fn thin_out(&mut self, begin: usize) {
        let lists = self.lists;
        let group = &mut self.stack[begin..];
        group.sort_by(|&a, &b| lists.rest(a as u32).cmp(lists.rest(b as u32)));
        let mut kept = begin;
        for i in begin..self.stack.len() {
            let own = lists.rest(self.stack[i] as u32);
            if self.stack.get(i + 1).is_none_or(|&next| !lists.rest(next as u32).starts_with(own)) {
                self.stack[kept] = self.stack[i];
                kept += 1;
            }
        }
        self.stack.truncate(kept);
    }

    /// Makes room for `more` nodes.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] if they would go beyond what one call may add, or beyond the memory.
    fn reserve(&mut self, more: usize) -> Result<(), Error> {
        if self.tree.nodes.len() + more <= CALL_LIMIT {
            return self.tree.reserve(more);
        }
        Err(Error::new(ErrorKind::TooLarge, "the simplices have more than 2^28 faces, too many for one call")
            .with_cure("insert them in several calls, or their skeletons of lower dimension"))
    }
}
