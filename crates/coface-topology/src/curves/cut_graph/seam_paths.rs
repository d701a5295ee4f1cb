//! Shortest paths across the annulus or Moebius band that a disk becomes when it is glued at a seam.

use super::NONE;
use coface_algebra::EdgeId;
use coface_algebra::RaggedArray;
use coface_complexes::surface::{GeneralizedMap, Slice};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Shortest paths from some vertices of a sliced surface.
struct Forest {
    distances: Vec<f64>,
    steps: Vec<u32>,
    parities: Vec<bool>,
}

impl Forest {
    /// Grows until `is_goal` holds at a vertex, which is given back.
    fn grow(
        sliced: &Slice<GeneralizedMap>,
        lengths: &[f64],
        roots: &[u32],
        parity: &[bool],
        is_goal: impl Fn(u32) -> bool,
    ) -> (Self, Option<u32>) {
        let skeleton = sliced.surface().skeleton();
        let ends = skeleton.edge_ends();
        let count = skeleton.vertex_count();
        let steps_at = RaggedArray::grouped(count, ends.iter().copied());
        let mut forest = Self {
            distances: vec![f64::INFINITY; count],
            steps: vec![NONE; count],
            parities: vec![false; count],
        };
        // Lengths are not negative, so their bits are in the order of their values.
        let mut heap = BinaryHeap::new();
        for &root in roots {
            forest.distances[root as usize] = 0.0;
            heap.push(Reverse((0u64, root)));
        }
        while let Some(Reverse((bits, vertex))) = heap.pop() {
            let distance = f64::from_bits(bits);
            if distance > forest.distances[vertex as usize] {
                continue;
            }
            if is_goal(vertex) {
                return (forest, Some(vertex));
            }
            for &step in steps_at.list(vertex as usize) {
                let edge = (step >> 1) as usize;
                let next = ends[(step ^ 1) as usize] as usize;
                let through = distance + lengths[sliced.edge_sources()[EdgeId::new(edge)].index()];
                if through < forest.distances[next] {
                    forest.distances[next] = through;
                    forest.steps[next] = step;
                    forest.parities[next] =
                        forest.parities[vertex as usize] ^ parity.get(edge).copied().unwrap_or(false);
                    heap.push(Reverse((through.to_bits(), next as u32)));
                }
            }
        }
        (forest, None)
    }

    /// The steps up from a vertex to a root, against the direction of the path, in the sliced surface.
    fn way_up(&self, ends: &[u32], vertex: u32) -> Vec<u32> {
        let mut way = Vec::new();
        let mut at = vertex;
        while self.steps[at as usize] != NONE {
            let step = self.steps[at as usize];
            way.push(step ^ 1);
            at = ends[step as usize];
        }
        way
    }
}

/// Steps of a sliced surface as steps of the surface before.
fn below(sliced: &Slice<GeneralizedMap>, steps: impl IntoIterator<Item = u32>) -> Vec<u32> {
    let source = |step: u32| (sliced.edge_sources()[EdgeId::from_u32(step >> 1)].to_u32() << 1) | (step & 1);
    steps.into_iter().map(source).collect()
}

/// The shortest path from one boundary loop to the other.
pub(super) fn across_annulus(
    sliced: &Slice<GeneralizedMap>,
    lengths: &[f64],
    inner: &[u32],
    outer: &[u32],
) -> Option<Vec<u32>> {
    let mut is_outer = vec![false; sliced.surface().skeleton().vertex_count()];
    outer.iter().for_each(|&vertex| is_outer[vertex as usize] = true);
    let (forest, end) = Forest::grow(sliced, lengths, inner, &[], |vertex| is_outer[vertex as usize]);
    Some(below(sliced, forest.way_up(sliced.surface().skeleton().edge_ends(), end?)))
}

/// The shortest path from the boundary of a Moebius band to itself that crosses the core.
pub(super) fn across_band(
    sliced: &Slice<GeneralizedMap>,
    lengths: &[f64],
    around: &[u32],
    parity: &[bool],
) -> Option<Vec<u32>> {
    let ends = sliced.surface().skeleton().edge_ends();
    let (forest, _) = Forest::grow(sliced, lengths, around, parity, |_| false);
    let mut best: Option<(f64, u32)> = None;
    for (edge, &[a, b]) in (0u32..).zip(ends.as_chunks::<2>().0) {
        let [x, y] = [a, b].map(|vertex| vertex as usize);
        let is_odd = forest.parities[x] ^ forest.parities[y] ^ parity[edge as usize];
        let length = forest.distances[x]
            + forest.distances[y]
            + lengths[sliced.edge_sources()[EdgeId::from_u32(edge)].index()];
        if is_odd && length.is_finite() && best.is_none_or(|(least, _)| length < least) {
            best = Some((length, edge));
        }
    }
    let (_, edge) = best?;
    let [a, b] = [2 * edge, 2 * edge + 1].map(|step| forest.way_up(ends, ends[step as usize]));
    let there = a.into_iter().rev().map(|step| step ^ 1);
    Some(below(sliced, there.chain([2 * edge]).chain(b)))
}
