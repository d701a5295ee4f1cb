//! What lies between the breaks of curves, and which of it runs along common arcs.

use super::boundaries::{Boundaries, Position};
use super::nodes::{Break, Nodes, OverlapEnd, tell};
use crate::meetings::Overlap;
use crate::{Assumption, UncertifiedDecision};
use coface_algebra::Error;
use coface_algebra::{ParityUnion, ParityUnionFind, Sign};
use coface_arrange::planar::ChainEdges;
use std::fmt::Write;

/// No number. The arrays that hold it have one entry a cell, and an `Option` would double their size.
const NONE: u32 = u32::MAX;

/// Chains are one that are nowhere farther apart than so many times what rounding does to points.
const THIN: f64 = 3.0;

/// Two chains between the same nodes that are within so many times the resolution from end to end are one where they are near each other.
const SHORT: f64 = 4096.0;

/// Short chains are near each other within this many times the resolution: their ends may be off by a few of it.
const NEAR: f64 = 8.0;

/// Chains have the numbers of the breaks that they begin at.
pub(super) struct Chains<'a> {
    pub(super) boundaries: &'a Boundaries<'a>,
    pub(super) nodes: &'a Nodes,
}

impl Chains<'_> {
    /// The break at the end of a chain.
    pub(super) fn end(&self, chain: u32) -> u32 {
        let curve = self.boundaries.curve_of(self.nodes.breaks[chain as usize].leave.piece);
        let own = self.nodes.breaks_of(curve);
        if chain + 1 == own.end { own.start } else { chain + 1 }
    }

    pub(super) fn breaks(&self, chain: u32) -> [&Break; 2] {
        [chain, self.end(chain)].map(|at| &self.nodes.breaks[at as usize])
    }

    /// The nodes that a chain goes from and to.
    pub(super) fn ends(&self, chain: u32) -> [u32; 2] {
        self.breaks(chain).map(|own| own.node)
    }

    pub(super) fn curve_of(&self, chain: u32) -> u32 {
        self.boundaries.curve_of(self.nodes.breaks[chain as usize].leave.piece)
    }

    /// The parts of pieces along a chain.
    pub(super) fn parts(&self, chain: u32) -> impl DoubleEndedIterator<Item = (u32, [f64; 2])> + '_ {
        let [from, to] = self.breaks(chain);
        self.boundaries.parts(from.leave, to.arrive)
    }

    /// The edges: chains along common arcs are one, and those between two nodes that are nowhere farther apart than rounding of results.
    ///
    /// # Errors
    /// If nodes along the two sides of an overlap are not the same.
    pub(super) fn edges(
        &self,
        overlaps: &[Overlap],
        report: &mut Vec<UncertifiedDecision>,
    ) -> Result<ChainEdges, Error> {
        let count = self.nodes.breaks.len();
        let mut equal = ParityUnionFind::new(count);
        for (overlap, overlap_ends) in overlaps.iter().zip(&self.nodes.overlap_ends) {
            let sides = [0, 1].map(|side| self.chains_along(overlap, overlap_ends, side));
            let [Some(along), Some(other)] = sides else { continue };
            let is_against = overlap.ranges[1][0] > overlap.ranges[1][1];
            let sign = if is_against { Sign::Minus } else { Sign::Plus };
            let fits = along.len() == other.len()
                && along.iter().zip(&other).all(|(&a, &b)| {
                    let mut ends = self.ends(b);
                    if is_against {
                        ends.reverse();
                    }
                    self.ends(a) == ends && equal.unite(a, b, sign) != ParityUnion::Contradicts
                });
            if !fits {
                let place = self.nodes.points[self.nodes.breaks[along[0] as usize].node as usize];
                return Err(undecided(
                    self.boundaries,
                    "which arcs pieces have in common",
                    place,
                    overlap.pieces,
                ));
            }
        }
        self.unite_thin(&mut equal, report);
        let mut first_of_class = vec![NONE; count];
        let mut first_of = Vec::with_capacity(count);
        for chain in 0..count as u32 {
            let class = equal.find(chain).0 as usize;
            if first_of_class[class] == NONE {
                first_of_class[class] = chain;
            }
            first_of.push(first_of_class[class]);
        }
        let signs: Vec<Sign> = (0..count as u32).map(|chain| equal.find(chain).1).collect();
        Ok(ChainEdges::of_equal_chains(
            (0..count).map(|chain| self.ends(chain as u32)),
            &first_of,
            |chain, first| signs[chain as usize] != signs[first as usize],
        ))
    }

    /// Unites chains between the same nodes that are nowhere farther apart than rounding of results: what is between them could not be
    /// written; and short ones within some times the resolution, which is what is between crossings of curves that run along each other.
    /// Those of two curves that run against each other, where sets touch from outside, are left: one edge would join the sets.
    fn unite_thin(&self, equal: &mut ParityUnionFind, report: &mut Vec<UncertifiedDecision>) {
        let thin = THIN * self.boundaries.rounding;
        let near = thin.max(NEAR * self.boundaries.resolution);
        let short = SHORT * self.boundaries.resolution;
        let is_short = |[from, to]: [Position; 2]| self.boundaries.is_within(from, to, short);
        let chains = (0..self.nodes.breaks.len() as u32).map(|chain| (self.ends(chain), chain));
        let chains = chains.filter(|([from, to], _)| from != to);
        let mut parallel: Vec<([u32; 2], u32)> =
            chains.map(|([from, to], chain)| ([from.min(to), from.max(to)], chain)).collect();
        parallel.sort_unstable();
        let arc = |chain: u32| {
            let [from, to] = self.breaks(chain);
            [from.leave, to.arrive]
        };
        for group in parallel.chunk_by(|a, b| a.0 == b.0) {
            for (at, &(_, a)) in group.iter().enumerate() {
                for &(_, b) in &group[at + 1..] {
                    let sign = if self.ends(a) == self.ends(b) { Sign::Plus } else { Sign::Minus };
                    let is_touching = sign == Sign::Minus && self.curve_of(a) != self.curve_of(b);
                    let is_one = equal.find(a).0 == equal.find(b).0;
                    if is_touching || is_one {
                        continue;
                    }
                    let arcs = [arc(a), arc(b)];
                    let limit = if arcs.into_iter().all(is_short) { near } else { thin };
                    if !self.boundaries.are_near(arcs, limit) {
                        continue;
                    }
                    if equal.unite(a, b, sign) != ParityUnion::Contradicts {
                        let place = self.nodes.points[self.breaks(a)[0].node as usize];
                        let other = self.parts(b).next().expect("chains are longer than the resolution");
                        let decision =
                            |part| tell(self.boundaries, Assumption::SameArc, place, [part, other]);
                        report.extend(self.parts(a).map(decision));
                    }
                }
            }
        }
    }

    /// The chains along a side of an overlap, from its beginning to its end; none where it is contracted.
    fn chains_along(&self, overlap: &Overlap, ends: &[OverlapEnd; 2], side: usize) -> Option<Vec<u32>> {
        let is_against = overlap.ranges[side][0] > overlap.ranges[side][1];
        let breaks = ends.map(|end| self.nodes.break_at(end.positions[side], end.site));
        let [Some(mut from), Some(mut to)] = breaks else { return None };
        if is_against {
            std::mem::swap(&mut from, &mut to);
        }
        let curve = self.boundaries.curve_of(overlap.pieces[side]);
        let all = self.nodes.breaks_of(curve);
        let count = all.end.checked_sub(all.start).filter(|&count| count > 0)?;
        let is_whole = count == 1 && self.boundaries.pieces(curve).len() == 1;
        let steps = if from == to { u32::from(is_whole) } else { (to + count - from) % count };
        let mut chains: Vec<u32> =
            (0..steps).map(|step| all.start + (from - all.start + step) % count).collect();
        if is_against {
            chains.reverse();
        }
        (!chains.is_empty()).then_some(chains)
    }
}

/// What a user can do where curves run nearer to each other than can be decided.
pub(crate) const NEARNESS_CURE: &str = "move one of the sets by a known vector longer than that, fit curves with other knots there, or take chords for curves, which are exact: --order 2 --flatten LENGTH";

/// The error for what the resolution does not tell.
pub(super) fn undecided(
    boundaries: &Boundaries<'_>,
    what: &str,
    [x, y]: [f64; 2],
    pieces: impl IntoIterator<Item = u32>,
) -> Error {
    let mut pieces: Vec<u32> = pieces.into_iter().collect();
    pieces.sort_unstable();
    pieces.dedup();
    let mut names = String::new();
    for piece in pieces.iter().take(4) {
        let index = boundaries.index(*piece);
        let separator = if names.is_empty() { "" } else { ", " };
        // Writing to a string cannot fail.
        let _ = write!(
            names,
            "{separator}piece {} of curve {} of set {}",
            index.piece, index.curve, index.operand
        );
    }
    Error::invalid(format!(
        "{what} near ({x}, {y}) cannot be decided at resolution {:e}: {names}",
        boundaries.resolution
    ))
    .with_cure(NEARNESS_CURE)
}
