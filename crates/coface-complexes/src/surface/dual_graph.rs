//! Dual graphs with signs: can the top cells of a mesh be turned so that neighbors agree?
//!
//! Nodes are top cells (faces of a surface, cells of a volume); their facets are the cells one degree lower. Two top cells
//! on a facet agree when they induce opposite orientations on it.

use crate::coherence::{Coherence, Obstruction, OddCycle};
use coface_algebra::progress::stage_of_many;
use coface_algebra::{Id, ParityUnion, ParityUnionFind, Sign};
use rayon::prelude::*;

/// The top cells of a mesh and the facets between them.
pub(crate) trait DualGraph: Sync {
    /// The number of top cells.
    fn node_count(&self) -> usize;
    /// The number of facets.
    fn facet_count(&self) -> usize;
    /// The facets of a top cell, each once.
    fn facets_of(&self, node: u32) -> impl Iterator<Item = u32>;
    /// The top cells at a facet, each as `2 * node + reversed`.
    fn nodes_at(&self, facet: usize) -> &[u32];
}

/// The relative sign of two top cells at a facet, as packed there: plus when they agree as given.
fn relative_sign(f: u32, g: u32) -> Sign {
    Sign::power_of_minus_one(((f ^ g ^ 1) & 1) as usize)
}

/// Searches a coherent orientation across the facets of two top cells.
pub(crate) fn coherence<Cell: Id + Send, Facet: Id + Send>(graph: &impl DualGraph) -> Coherence<Cell, Facet> {
    const BLOCK: usize = 1 << 14;
    let blocks = || (0..graph.facet_count().div_ceil(BLOCK)).into_par_iter();
    let range_of = |block: usize| block * BLOCK..((block + 1) * BLOCK).min(graph.facet_count());
    let crowded =
        blocks().find_map_first(|block| range_of(block).find(|&facet| graph.nodes_at(facet).len() > 2));
    let obstruction = crowded.map(|facet| Obstruction::CrowdedFacet {
        facet: Facet::new(facet),
        cells: graph.nodes_at(facet).iter().map(|&node| Cell::new((node >> 1) as usize)).collect(),
    });
    let conflicts: Vec<Facet> = blocks()
        .flat_map_iter(|block| {
            let conflicting = |&facet: &usize| matches!(graph.nodes_at(facet), [f, g] if (f ^ g) & 1 == 0);
            range_of(block).filter(conflicting).map(Facet::new)
        })
        .collect();
    let mut found = Coherence { obstruction, conflicts, signs: Vec::new(), odd_cycle: None };
    if found.conflicts.is_empty() {
        return found;
    }
    let mut classes = ParityUnionFind::new(graph.node_count());
    let steps = stage_of_many("orienting cells", graph.facet_count());
    for facet in steps.each(0..graph.facet_count()) {
        if let &[f, g] = graph.nodes_at(facet)
            && classes.unite(f >> 1, g >> 1, relative_sign(f, g)) == ParityUnion::Contradicts
        {
            let (cells, facets) = odd_cycle(graph, f >> 1);
            let cells = cells.into_iter().map(|cell| Cell::new(cell as usize)).collect();
            let facets = facets.into_iter().map(|facet| Facet::new(facet as usize)).collect();
            found.odd_cycle = Some(OddCycle { cells, facets });
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

/// The facets of two top cells that contradict the orientation spread over the facets before them: at least one in each
/// part that has no coherent orientation, and none elsewhere.
pub(crate) fn contradictions(graph: &impl DualGraph) -> Vec<usize> {
    let mut classes = ParityUnionFind::new(graph.node_count());
    let mut contradicts = |facet: &usize| {
        matches!(graph.nodes_at(*facet), &[f, g]
            if classes.unite(f >> 1, g >> 1, relative_sign(f, g)) == ParityUnion::Contradicts)
    };
    (0..graph.facet_count()).filter(|facet| contradicts(facet)).collect()
}

/// A closed chain of top cells with an odd number of conflicts, in a part without coherent orientation.
///
/// Breadth-first search in the double cover, whose nodes are 2 * cell + side: crossing a facet on which the cells conflict
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
        for facet in graph.facets_of(node >> 1) {
            let &[f, g] = graph.nodes_at(facet as usize) else { continue };
            let other = if f >> 1 == node >> 1 { g >> 1 } else { f >> 1 };
            let next = other << 1 | ((node ^ f ^ g ^ 1) & 1);
            if from[next as usize].0 == UNSEEN {
                from[next as usize] = (node, facet);
                queue.push(next);
            }
        }
    }
    let mut walk = Vec::new();
    let mut node = target;
    while node != source {
        let (before, facet) = from[node as usize];
        walk.push((before, facet));
        node = before;
    }
    walk.reverse();
    simple_odd_part(&walk)
}

/// The odd simple part of a closed walk in the double cover, whose steps are (node left, facet crossed).
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
    walk[first..after].iter().map(|&(node, facet)| (node >> 1, facet)).unzip()
}
