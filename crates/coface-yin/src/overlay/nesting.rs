//! Which orbit of each component sees its outside, and what each component lies in.
//!
//! A vertical line is laid through the widest piece of a component, away from knots, nodes and vertical tangents. Below the lowest
//! crossing of the component on the line is its outside; the first crossing below that of another component tells the face that it is
//! in. Where that is the outside of the other one, both lie in the same face, and are asked about together.

use super::boundaries::{Boundaries, Position};
use super::chains::{Chains, undecided};
use super::columns::{ColumnCrossing, NearDegenerate, column_crossings};
use super::exact_columns::exact_crossings;
use super::nodes::compare;
use crate::curve::bernstein;
use crate::meetings::ArcTree;
use coface_algebra::Error;
use coface_algebra::{RaggedArray, UnionFind};
use coface_arrange::planar::{ChainEdges, Orbits};
use rayon::prelude::*;

/// How many lines are tried through a component.
const MOST_LINES: usize = 48;

/// How many of them with exact heights, the last ones.
const EXACT_LINES: usize = 8;

/// What components lie in.
pub(super) struct Nesting {
    /// The orbit of each component that sees the outside.
    pub(super) outer_orbits: Vec<u32>,
    /// A halfedge that has the face around each component on its left, on an orbit that is no outer one; none outside of all.
    pub(super) below: Vec<Option<u32>>,
}

/// A line through a component that is away from everything that is doubtful.
#[derive(Clone, Copy)]
struct Line {
    x: f64,
    /// Between which heights the component is lowest there, from the base on if there is one.
    heights: [f64; 2],
    /// What heights are counted from if they are exact.
    base: Option<f64>,
}

impl Line {
    /// Adds the crossings of a piece with the line.
    fn crossings(
        &self,
        boundaries: &Boundaries<'_>,
        piece: u32,
        found: &mut Vec<ColumnCrossing>,
    ) -> Result<(), NearDegenerate> {
        match self.base {
            Some(base) => exact_crossings(boundaries, piece, self.x, base, found),
            None => column_crossings(boundaries, piece, self.x, found),
        }
    }
}

/// What a component sees below itself.
#[derive(Clone, Copy)]
struct Seen {
    line: Line,
    outer_orbit: u32,
    below: Option<u32>,
}

pub(super) struct Nester<'a> {
    pub(super) chains: &'a Chains<'a>,
    pub(super) edges: &'a ChainEdges,
    pub(super) orbits: &'a Orbits,
    /// The depth of the tree of arcs in which few are near each other.
    pub(super) depth: u32,
}

impl<'a> Nester<'a> {
    fn boundaries(&self) -> &'a Boundaries<'a> {
        self.chains.boundaries
    }

    /// # Errors
    /// If no line through a component tells what is below it.
    pub(super) fn nesting(&self) -> Result<Nesting, Error> {
        let count = self.orbits.lowest_vertices().len();
        let chain_count = self.chains.nodes.breaks.len() as u32;
        let component_of_chain = |chain: u32| {
            let node = self.chains.nodes.breaks[chain as usize].node;
            self.orbits.component_of()[node as usize]
        };
        let chains_of = RaggedArray::grouped(count, (0..chain_count).map(component_of_chain));
        let boundaries = self.boundaries();
        let piece_count = boundaries.piece_count();
        let margin = 2.0 * boundaries.rounding;
        let tree = ArcTree::new(piece_count, |piece| boundaries.controls(piece), self.depth, margin);
        let seen: Vec<Seen> = (0..count)
            .into_par_iter()
            .with_min_len(4)
            .map(|component| self.look_down(&tree, chains_of.list(component)))
            .collect::<Result<_, Error>>()?;
        let outer_orbits: Vec<u32> = seen.iter().map(|seen| seen.outer_orbit).collect();
        let below = self.settle(&tree, &seen, &outer_orbits, &chains_of)?;
        Ok(Nesting { outer_orbits, below })
    }

    fn component(&self, halfedge: u32) -> u32 {
        self.orbits.component_of()[self.edges.ends()[halfedge as usize / 2][0] as usize]
    }

    /// Brings together components that lie in one face, until it is known in which.
    fn settle(
        &self,
        tree: &ArcTree,
        seen: &[Seen],
        outer_orbits: &[u32],
        chains_of: &RaggedArray,
    ) -> Result<Vec<Option<u32>>, Error> {
        let count = seen.len();
        let mut groups = UnionFind::new(count);
        // For each group what is below it, once that is known.
        let mut known: Vec<Option<Option<u32>>> = vec![None; count];
        let other_outside = |halfedge: u32| {
            let component = self.component(halfedge);
            let orbit = self.orbits.orbit_of()[halfedge as usize];
            (outer_orbits[component as usize] == orbit).then_some(component)
        };
        let mut pending: Vec<(u32, Option<u32>)> =
            (0..).zip(seen).map(|(component, seen)| (component, seen.below)).collect();
        while !pending.is_empty() {
            let mut answers = Vec::new();
            for (component, below) in pending.drain(..) {
                match below.and_then(&other_outside) {
                    Some(other) => {
                        let own = [component, other].map(|member| known[groups.find(member) as usize]);
                        groups.unite(component, other);
                        let found = own[0].or(own[1]);
                        if found.is_some() {
                            known[groups.find(component) as usize] = found;
                        }
                    }
                    None => answers.push((component, below)),
                }
            }
            for (component, below) in answers {
                known[groups.find(component) as usize] = Some(below);
            }
            // Groups that look at each other only: one of each looks on below all of them.
            for component in 0..count as u32 {
                let root = groups.find(component);
                if root == component && known[root as usize].is_none() {
                    let list = chains_of.list(component as usize);
                    let mut is_own = |other: u32| groups.find(other) == root;
                    let below = self.look_past(tree, seen[component as usize].line, &mut is_own);
                    let below = below.map_err(|NearDegenerate| self.doubtful(list))?;
                    pending.push((component, below));
                }
            }
        }
        Ok((0..count as u32)
            .map(|component| known[groups.find(component) as usize].expect("all groups are settled"))
            .collect())
    }

    fn doubtful(&self, chains: &[u32]) -> Error {
        let chain = chains[0];
        let place = self.chains.nodes.points[self.chains.ends(chain)[0] as usize];
        let piece = self.chains.nodes.breaks[chain as usize].leave.piece;
        undecided(self.boundaries(), "in what a curve lies", place, [piece])
    }

    /// The outside of a component and what is below it, on the first line that tells.
    fn look_down(&self, tree: &ArcTree, chains: &[u32]) -> Result<Seen, Error> {
        let parts = || chains.iter().flat_map(|&chain| self.chains.parts(chain));
        let width = |piece: u32| {
            let [low, high] = bernstein::control_box(self.boundaries().controls(piece));
            high[0] - low[0]
        };
        let mut widest: Option<(f64, u32, [f64; 2])> = None;
        for (piece, range) in parts() {
            let own = width(piece) * (range[1] - range[0]);
            if widest.is_none_or(|(width, ..)| own > width) {
                widest = Some((own, piece, range));
            }
        }
        let Some((_, piece, range)) = widest else { return Err(self.doubtful(chains)) };
        let mut crossings = Vec::new();
        for attempt in 0..MOST_LINES {
            // Multiples of the golden section are spread evenly.
            let part = (0.381_966_011_250_105 + attempt as f64 * 0.618_033_988_749_895).fract();
            let at = range[0] + part * (range[1] - range[0]);
            let [x, y] = self.boundaries().point(Position { piece, parameter: at });
            // At first heights have to be farther apart than the resolution.
            let apart = if attempt < MOST_LINES / 2 { 4.0 * self.boundaries().resolution } else { 0.0 };
            let base = (attempt + EXACT_LINES >= MOST_LINES).then_some(y);
            let line = Line { x, heights: [0.0; 2], base };
            crossings.clear();
            let is_told =
                parts().try_for_each(|(piece, _)| line.crossings(self.boundaries(), piece, &mut crossings));
            if is_told.is_err() {
                continue;
            }
            let Ok(Some((lowest, halfedge))) = self.extreme(&crossings, apart, false) else {
                continue;
            };
            let line = Line { heights: lowest.heights, ..line };
            let own = self.component(halfedge);
            let below = self.first_below(tree, line, apart, &mut |other| other == own);
            if let Ok(below) = below {
                let outer_orbit = self.orbits.orbit_of()[(halfedge ^ 1) as usize];
                return Ok(Seen { line, outer_orbit, below });
            }
        }
        Err(self.doubtful(chains))
    }

    /// The halfedge above the first crossing below all components of a group on a line.
    fn look_past(
        &self,
        tree: &ArcTree,
        line: Line,
        is_own: &mut dyn FnMut(u32) -> bool,
    ) -> Result<Option<u32>, NearDegenerate> {
        let mut crossings = Vec::new();
        let below = [f64::NEG_INFINITY, line.heights[0]];
        self.column(tree, line, below, &mut Vec::new(), &mut crossings)?;
        let mut heights = line.heights;
        for crossing in &crossings {
            let halfedge = self.upper_halfedge(crossing)?;
            if is_own(self.component(halfedge)) {
                heights = [0, 1].map(|end| heights[end].min(crossing.heights[end]));
            }
        }
        self.first_below(tree, Line { heights, ..line }, 0.0, is_own)
    }

    /// The halfedge that has the first crossing below the bottom of a line on its right; crossings of own components are passed over.
    fn first_below(
        &self,
        tree: &ArcTree,
        line: Line,
        apart: f64,
        is_own: &mut dyn FnMut(u32) -> bool,
    ) -> Result<Option<u32>, NearDegenerate> {
        let [_, whole] = tree.window();
        let (mut pieces, mut crossings, mut others) = (Vec::new(), Vec::new(), Vec::new());
        let lowest = whole[0] - line.base.unwrap_or(0.0);
        // Few pieces are that high above each other on average.
        let mut height = (whole[1] - whole[0]) / self.boundaries().piece_count() as f64;
        let mut top = line.heights[1];
        loop {
            let low = line.heights[0] - height;
            let is_last = low <= lowest;
            self.column(tree, line, [low, top], &mut pieces, &mut crossings)?;
            top = low;
            others.clear();
            for crossing in &crossings {
                if crossing.heights[0] > line.heights[1] {
                    continue;
                }
                let halfedge = self.upper_halfedge(crossing)?;
                if is_own(self.component(halfedge)) {
                    continue;
                }
                // It may be above.
                if crossing.heights[1] + apart >= line.heights[0] {
                    return Err(NearDegenerate);
                }
                others.push(*crossing);
            }
            let found = self.extreme(&others, apart, true)?;
            match found {
                // What is below the window may be higher than what was found only if that is not in the window.
                Some((highest, halfedge)) if is_last || highest.heights[0] > low => {
                    return Ok(Some(halfedge));
                }
                None if is_last => return Ok(None),
                _ => height *= 8.0,
            }
        }
    }

    /// Adds all crossings of pieces near a range of heights on a line, except of the pieces given, to which it adds them.
    fn column(
        &self,
        tree: &ArcTree,
        line: Line,
        heights: [f64; 2],
        pieces: &mut Vec<u32>,
        crossings: &mut Vec<ColumnCrossing>,
    ) -> Result<(), NearDegenerate> {
        let old = pieces.len();
        let heights = match line.base {
            Some(base) => {
                let margin = 2.0 * self.boundaries().rounding;
                [heights[0] + base - margin, heights[1] + base + margin]
            }
            None => heights,
        };
        tree.visit(&[[line.x; 2], heights], |piece| pieces.push(piece));
        let (known, new) = pieces.split_at_mut(old);
        new.sort_unstable();
        // Several arcs of a piece may be there.
        for own in new.chunk_by(|a, b| a == b) {
            if known.binary_search(&own[0]).is_err() {
                line.crossings(self.boundaries(), own[0], crossings)?;
            }
        }
        pieces.sort_unstable();
        pieces.dedup();
        Ok(())
    }

    /// The lowest or highest of some crossings, with the halfedge that has it on its right; crossings of one edge are one.
    fn extreme(
        &self,
        crossings: &[ColumnCrossing],
        apart: f64,
        is_highest: bool,
    ) -> Result<Option<(ColumnCrossing, u32)>, NearDegenerate> {
        // The least of the upper bounds, or the greatest of the lower ones.
        let best = crossings.iter().min_by(|a, b| {
            if is_highest {
                b.heights[0].total_cmp(&a.heights[0])
            } else {
                a.heights[1].total_cmp(&b.heights[1])
            }
        });
        let Some(best) = best else { return Ok(None) };
        let halfedge = self.upper_halfedge(best)?;
        for other in crossings {
            let is_clear = if is_highest {
                other.heights[1] + apart < best.heights[0]
            } else {
                other.heights[0] - apart > best.heights[1]
            };
            if !is_clear && self.upper_halfedge(other)? != halfedge {
                return Err(NearDegenerate);
            }
        }
        Ok(Some((*best, halfedge)))
    }

    /// The halfedge along a crossing that has what is above on its left.
    fn upper_halfedge(&self, crossing: &ColumnCrossing) -> Result<u32, NearDegenerate> {
        let chains = crossing.range.map(|parameter| self.chain_at(crossing.piece, parameter));
        let [Some(chain), Some(other)] = chains else { return Err(NearDegenerate) };
        if chain != other {
            return Err(NearDegenerate);
        }
        let along = self.edges.halfedge_of_chain()[chain as usize];
        Ok(if crossing.is_rightward { along } else { along ^ 1 })
    }

    /// The chain that a place of a piece is on; none where it is at a node.
    fn chain_at(&self, piece: u32, parameter: f64) -> Option<u32> {
        let position = self.boundaries().position(piece, parameter * self.boundaries().length(piece));
        let own = self.chains.nodes.breaks_of(self.boundaries().curve_of(piece));
        let breaks = &self.chains.nodes.breaks[own.start as usize..own.end as usize];
        let passed = breaks.partition_point(|own| compare(&own.leave, &position).is_le()) as u32;
        // Before the first break the last chain runs.
        let count = own.end.checked_sub(own.start).filter(|&count| count > 0)?;
        let chain = own.start + (passed + count - 1) % count;
        self.is_on(chain, position).then_some(chain)
    }

    /// Whether a place comes after the break at which a chain begins and before the one at its end.
    fn is_on(&self, chain: u32, place: Position) -> bool {
        let [from, to] = self.chains.breaks(chain);
        let [from, to] = [from.leave, to.arrive];
        let is_after = compare(&from, &place).is_lt();
        let is_before = compare(&place, &to).is_lt();
        // A chain over the end of the curve has its end before its beginning.
        if compare(&from, &to).is_lt() { is_after && is_before } else { is_after || is_before }
    }
}
