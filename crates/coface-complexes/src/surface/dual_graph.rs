//! Dual graphs with signs: can the top cells of a mesh be turned so that neighbors agree?
//!
//! Nodes are top cells (faces of a surface, cells of a volume), walls are the cells one degree lower. Two top cells on a
//! wall agree when they induce opposite orientations on it.

use coface_algebra::progress::stage_of_many;
use coface_algebra::{ParityUnion, ParityUnionFind, Sign};
use rayon::prelude::*;

/// The top cells of a mesh and the walls between them.
pub(crate) trait DualGraph: Sync {
    /// The number of top cells.
    fn node_count(&self) -> usize;
    /// The number of walls.
    fn wall_count(&self) -> usize;
    /// The walls of a top cell, each once.
    fn walls_of(&self, node: u32) -> impl Iterator<Item = u32>;
    /// The top cells at a wall, each as `2 * node + reversed`.
    fn nodes_at(&self, wall: usize) -> &[u32];
}

/// What the search for a coherent orientation found.
pub(crate) struct Coherence {
    /// The first wall of three or more top cells.
    pub(crate) crowded_wall: Option<usize>,
    /// The walls of two top cells that conflict as given, rising.
    pub(crate) conflicts: Vec<u32>,
    /// The sign of each top cell that makes all agree; empty when all are plus, and when there is none.
    pub(crate) signs: Vec<Sign>,
    /// Top cells around an odd cycle and the walls between them.
    pub(crate) odd_cycle: Option<(Vec<u32>, Vec<u32>)>,
}

/// The relative sign of two top cells at a wall, as packed there: plus when they agree as given.
fn relative_sign(f: u32, g: u32) -> Sign {
    Sign::power_of_minus_one(((f ^ g ^ 1) & 1) as usize)
}

/// Searches a coherent orientation across the walls of two top cells.
pub(crate) fn coherence(graph: &impl DualGraph) -> Coherence {
    const BLOCK: usize = 1 << 14;
    let blocks = || (0..graph.wall_count().div_ceil(BLOCK)).into_par_iter();
    let walls = |block: usize| block * BLOCK..((block + 1) * BLOCK).min(graph.wall_count());
    let crowded_wall =
        blocks().find_map_first(|block| walls(block).find(|&wall| graph.nodes_at(wall).len() > 2));
    let conflicts: Vec<u32> = blocks()
        .flat_map_iter(|block| {
            let conflicting = |&wall: &usize| matches!(graph.nodes_at(wall), [f, g] if (f ^ g) & 1 == 0);
            walls(block).filter(conflicting).map(|wall| wall as u32)
        })
        .collect();
    let mut found = Coherence { crowded_wall, conflicts, signs: Vec::new(), odd_cycle: None };
    if found.conflicts.is_empty() {
        return found;
    }
    let mut classes = ParityUnionFind::new(graph.node_count());
    let steps = stage_of_many("orienting cells", graph.wall_count());
    for wall in steps.each(0..graph.wall_count()) {
        if let &[f, g] = graph.nodes_at(wall)
            && classes.unite(f >> 1, g >> 1, relative_sign(f, g)) == ParityUnion::Contradicts
        {
            found.odd_cycle = Some(odd_cycle(graph, f >> 1));
            return found;
        }
    }
    let mut sign_of_root: Vec<Option<Sign>> = vec![None; graph.node_count()];
    found.signs = (0..graph.node_count() as u32)
        .map(|node| {
            let (root, sign) = classes.find(node);
            sign.times(*sign_of_root[root as usize].get_or_insert(sign))
        })
        .collect();
    found
}

/// The walls of two top cells that contradict the orientation spread over the walls before them: at least one in each
/// part that has no coherent orientation, and none elsewhere.
pub(crate) fn contradictions(graph: &impl DualGraph) -> Vec<usize> {
    let mut classes = ParityUnionFind::new(graph.node_count());
    let mut contradicts = |wall: &usize| {
        matches!(graph.nodes_at(*wall), &[f, g]
            if classes.unite(f >> 1, g >> 1, relative_sign(f, g)) == ParityUnion::Contradicts)
    };
    (0..graph.wall_count()).filter(|wall| contradicts(wall)).collect()
}

/// A closed chain of top cells with an odd number of conflicts, in a part without coherent orientation.
///
/// Breadth-first search in the double cover, whose nodes are 2 * cell + side: crossing a wall on which the cells conflict
/// changes the side.
fn odd_cycle(graph: &impl DualGraph, start: u32) -> (Vec<u32>, Vec<u32>) {
    const UNSEEN: u32 = u32::MAX;
    let mut from = vec![(UNSEEN, 0u32); 2 * graph.node_count()];
    let (source, target) = (start << 1, start << 1 | 1);
    let mut queue = vec![source];
    let mut at = 0;
    from[source as usize] = (source, 0);
    while from[target as usize].0 == UNSEEN {
        let node = queue[at];
        at += 1;
        for wall in graph.walls_of(node >> 1) {
            let &[f, g] = graph.nodes_at(wall as usize) else { continue };
            let other = if f >> 1 == node >> 1 { g >> 1 } else { f >> 1 };
            let next = other << 1 | ((node ^ f ^ g ^ 1) & 1);
            if from[next as usize].0 == UNSEEN {
                from[next as usize] = (node, wall);
                queue.push(next);
            }
        }
    }
    let mut walk = Vec::new();
    let mut node = target;
    while node != source {
        let (before, wall) = from[node as usize];
        walk.push((before, wall));
        node = before;
    }
    walk.reverse();
    simple_odd_part(&walk)
}

/// The odd simple part of a closed walk in the double cover, whose steps are (node left, wall crossed).
///
/// A shortest walk never comes back to a cell on the same side; coming back on the other side closes an odd walk. The
/// shortest such return has distinct cells.
fn simple_odd_part(walk: &[(u32, u32)]) -> (Vec<u32>, Vec<u32>) {
    let mut visits: Vec<(u32, usize)> =
        walk.iter().enumerate().map(|(i, &(node, _))| (node >> 1, i)).collect();
    visits.sort_unstable();
    let (first, after) = visits
        .windows(2)
        .filter(|pair| pair[0].0 == pair[1].0)
        .map(|pair| (pair[0].1, pair[1].1))
        .min_by_key(|&(i, j)| (j - i, i))
        .unwrap_or((0, walk.len()));
    walk[first..after].iter().map(|&(node, wall)| (node >> 1, wall)).unzip()
}
