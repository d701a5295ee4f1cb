//! The curves around selected faces: sub-arcs of the operands' curves.

use super::CurvedOverlay;
use crate::boolean::{Combination, PieceSource};
use crate::set::{CanonicalOrder, CurveArena};
use crate::{Carrier, Curve, KnotIndex, YinSet};
use coface_algebra::Error;
use rayon::prelude::*;
use std::cmp::Ordering;

/// A part of a piece of an operand along a curve of the result.
#[derive(Clone, Copy)]
struct Part {
    piece: u32,
    /// The way along the piece; falling where the result runs against it.
    range: [f64; 2],
    /// The parameters on the carrier of the piece. They go on beyond the piece where others on the same carrier were joined to it.
    carried: [f64; 2],
    /// The halfedge of the ring that it belongs to first, by its place.
    at: u32,
    /// How many halfedges it runs along.
    span: u32,
    /// Whether it begins at the node of its first halfedge.
    is_at_node: bool,
}

impl Part {
    /// Goes on along another part.
    fn take(&mut self, next: &Self) {
        if self.piece == next.piece {
            self.range[1] = next.range[1];
        }
        self.carried[1] = next.carried[1];
        self.span += next.span;
    }
}

/// A curve of the result.
struct Outline {
    controls: Vec<[f64; 2]>,
    knots: Vec<f64>,
    carriers: Vec<Carrier>,
    kinks: Vec<u32>,
    sources: Vec<PieceSource>,
    /// Further sources, each with its piece.
    other_sources: Vec<(u32, PieceSource)>,
}

impl CurvedOverlay<'_> {
    /// The set of the faces whose winding numbers satisfy a condition.
    /// The curves are those of the sets in order.
    ///
    /// The pieces of its curves are those of the operands, or parts of them where curves meet. A piece that is whole is the same bit
    /// for bit, or its reverse. The parameter grows along a part of a piece by that part of what it grows along the piece. Where a
    /// curve of an operand goes on through a meeting that the result has no part in, its pieces are not cut.
    ///
    /// # Errors
    /// If a curve of the result cannot be determined.
    pub(crate) fn select(
        self,
        sets: &[&YinSet],
        condition: impl Fn(&[(u32, i32)]) -> bool,
    ) -> Result<Combination, Error> {
        let is_unbounded: Vec<bool> = sets.iter().map(|set| !set.is_bounded()).collect();
        self.check_regions(&is_unbounded)?;
        self.select_faces(sets, condition)
    }

    /// The same for curves that may cross and overlap within a set.
    ///
    /// # Errors
    /// If a curve of the result cannot be determined.
    pub(crate) fn select_faces(
        self,
        sets: &[&YinSet],
        condition: impl Fn(&[(u32, i32)]) -> bool,
    ) -> Result<Combination, Error> {
        let is_inside = self.cells.faces_where(condition);
        let traced = self.cells.trace(&is_inside, |_| false);
        let rings: Vec<u32> = (0..traced.starts().len() as u32 - 1).collect();
        let ring = |ring: u32| {
            &traced.halfedges()[traced.starts()[ring as usize]..traced.starts()[ring as usize + 1]]
        };
        let mut passes = vec![0u8; self.nodes.points.len()];
        for &halfedge in traced.halfedges() {
            let passes = &mut passes[self.cells.tail(halfedge) as usize];
            *passes = passes.saturating_add(1);
        }
        let outlines: Vec<Outline> = rings
            .par_iter()
            .with_min_len(8)
            .map(|&number| self.outline(ring(number), &passes, sets))
            .collect();
        let parents = self.cells.parents_in_order(traced.halfedges(), traced.starts(), &rings);
        let order = CanonicalOrder::new(
            &parents,
            |curve| outlines[curve as usize].controls[0],
            |a, b| {
                let [a, b] = [a, b].map(|curve| &outlines[curve as usize].controls);
                a.partial_cmp(b).unwrap_or(Ordering::Equal)
            },
        );
        let piece_count = outlines.iter().map(|outline| outline.sources.len()).sum();
        let mut arena = CurveArena::with_capacity(self.boundaries.order(), piece_count, outlines.len());
        let (mut kinks, mut sources, mut other_sources) =
            (Vec::new(), Vec::with_capacity(piece_count), Vec::new());
        for (number, &curve) in (0..).zip(order.items()) {
            let outline = &outlines[curve as usize];
            let first = sources.len() as u32;
            let curve = Curve::borrowed(self.boundaries.order(), &outline.controls, &outline.knots);
            arena.push(&curve.carried_by(&outline.carriers[..]));
            kinks.extend(outline.kinks.iter().map(|&knot| KnotIndex { curve: number, knot }));
            sources.extend_from_slice(&outline.sources);
            other_sources
                .extend(outline.other_sources.iter().map(|&(piece, source)| (first + piece, source)));
        }
        let has_exterior = is_inside[is_inside.len() - 1];
        Ok(Combination {
            set: YinSet::from_parts(arena, has_exterior, order.parents(&parents), kinks),
            sources,
            other_sources,
            collapsed_count: 0,
            repair_count: 0,
            resolution: self.boundaries.resolution,
            report: self.report,
            area_error: 0.0,
        })
    }

    /// The curve along a ring of halfedges.
    fn outline(&self, halfedges: &[u32], passes: &[u8], sets: &[&YinSet]) -> Outline {
        let chains = self.chains();
        let mut parts: Vec<Part> = Vec::new();
        for (at, &halfedge) in (0..).zip(halfedges) {
            let own = chains.parts(self.cells.edges().first_chain(halfedge / 2));
            let first = parts.len();
            let part = |piece: u32, range: [f64; 2]| {
                let carried = range.map(|way| self.boundaries.carriers.on_carrier(piece, way));
                Part { piece, range, carried, at, span: 1, is_at_node: false }
            };
            if halfedge.is_multiple_of(2) {
                parts.extend(own.map(|(piece, range)| part(piece, range)));
            } else {
                parts.extend(own.rev().map(|(piece, [a, b])| part(piece, [b, a])));
            }
            if let Some(part) = parts.get_mut(first) {
                part.is_at_node = true;
            }
        }
        self.join(&mut parts, halfedges, passes);
        let point = |part: &Part| {
            if part.is_at_node {
                self.nodes.points[self.cells.tail(halfedges[part.at as usize]) as usize]
            } else {
                let controls = self.boundaries.controls(part.piece);
                controls[if part.range[0] == 0.0 { 0 } else { controls.len() - 1 }]
            }
        };
        let lowest = parts.iter().enumerate().min_by(|a, b| {
            let ([ax, ay], [bx, by]) = (point(a.1), point(b.1));
            ax.total_cmp(&bx).then(ay.total_cmp(&by))
        });
        let lowest = lowest.map_or(0, |(at, _)| at);
        parts.rotate_left(lowest);
        let count = parts.len();
        let mut found = Outline {
            controls: Vec::with_capacity(count * self.boundaries.order().degree() + 1),
            knots: Vec::with_capacity(count + 1),
            carriers: Vec::new(),
            kinks: Vec::new(),
            sources: Vec::with_capacity(count),
            other_sources: Vec::new(),
        };
        let mut knot = 0.0f64;
        for (number, part) in parts.iter().enumerate() {
            let ends = [point(part), point(&parts[(number + 1) % count])];
            let carrier = self.boundaries.carriers.of_piece(part.piece);
            let (controls, source) = self.boundaries.cut_out(carrier, part.carried, ends);
            found.carriers.extend(source.map(|source| source.of_piece(number as u32)));
            found.controls.extend_from_slice(&controls[..controls.len() - 1]);
            found.knots.push(knot);
            let growth = self.boundaries.carriers.growth(carrier) * (part.carried[1] - part.carried[0]).abs();
            knot = (knot + growth).max(knot.next_up());
            if self.is_kink(part, halfedges, sets) {
                found.kinks.push(number as u32);
            }
            found.sources.push(self.boundaries.source(part.piece, part.range));
            for at in part.at..part.at + part.span {
                self.push_other_sources(
                    halfedges[at as usize % halfedges.len()],
                    number as u32,
                    part.piece,
                    &mut found,
                );
            }
        }
        found.knots.push(knot);
        if let Some(knots) = self.knots_of_whole_curve(&parts) {
            found.knots = knots;
        }
        found.controls.extend(found.controls.first().copied());
        found
    }

    /// Joins the parts of one piece on both sides of a node that nothing else of the result runs through.
    fn join(&self, parts: &mut Vec<Part>, halfedges: &[u32], passes: &[u8]) {
        let chains = self.chains();
        let first_chain = |part: &Part| self.cells.edges().first_chain(halfedges[part.at as usize] / 2);
        let last_halfedge = |at: u32| halfedges[if at == 0 { halfedges.len() } else { at as usize } - 1];
        let goes_on = |before: &Part, part: &Part| {
            let node = self.cells.tail(halfedges[part.at as usize]);
            let carriers = &self.boundaries.carriers;
            let carrier = carriers.of_piece(part.piece);
            if !part.is_at_node || passes[node as usize] > 1 || carriers.of_piece(before.piece) != carrier {
                return false;
            }
            if before.piece != part.piece {
                // Parts of one polynomial from different curves: one goes on where the other ends.
                let rises = |part: &Part| part.carried[0] < part.carried[1];
                let gap = [before.carried[1], part.carried[0]];
                return rises(before) == rises(part) && self.boundaries.is_one_point(carrier, gap);
            }
            let is_along = before.range[0] < before.range[1];
            if is_along != (part.range[0] < part.range[1]) {
                return false;
            }
            // The chain that comes to the node; what was joined before has it last.
            let chain = self.cells.edges().first_chain(last_halfedge(part.at) / 2);
            let [from, to] = if is_along { [chain, first_chain(part)] } else { [first_chain(part), chain] };
            let meets =
                if is_along { before.range[1] <= part.range[0] } else { before.range[1] >= part.range[0] };
            chains.end(from) == to && meets
        };
        let mut joined: Vec<Part> = Vec::with_capacity(parts.len());
        for part in parts.iter() {
            match joined.last_mut() {
                Some(before) if goes_on(before, part) => {
                    before.take(part);
                }
                _ => joined.push(*part),
            }
        }
        if let [first, .., last] = &joined[..]
            && goes_on(last, first)
        {
            let mut part = *last;
            part.take(first);
            joined.pop();
            joined[0] = part;
        }
        *parts = joined;
    }

    /// The knots of the curve that parts are, if they are all of its pieces in order, from its first knot on.
    fn knots_of_whole_curve(&self, parts: &[Part]) -> Option<Vec<f64>> {
        let pieces = self.boundaries.pieces(self.boundaries.curve_of(parts.first()?.piece));
        let is_whole = parts.len() == pieces.len()
            && parts.iter().zip(pieces.clone()).all(|(part, piece)| {
                part.piece == piece && part.range == [0.0, self.boundaries.length(piece)]
            });
        is_whole.then(|| self.boundaries.knots(pieces.start))
    }

    /// What else runs along a halfedge than the first chain of its edge, or than the first piece of what was joined: each of them is a
    /// part of one piece.
    fn push_other_sources(&self, halfedge: u32, piece: u32, first: u32, found: &mut Outline) {
        let chains = self.chains();
        let list = self.cells.edges().chains().list(halfedge as usize / 2);
        let curve_of = |piece: u32| self.boundaries.curve_of(piece);
        let is_joined = chains.curve_of(list[0]) != curve_of(first);
        for &chain in &list[usize::from(!is_joined)..] {
            let is_along = self.cells.edges().halfedge_of_chain()[chain as usize] == halfedge;
            found.other_sources.extend(chains.parts(chain).map(|(own, [a, b])| {
                (piece, self.boundaries.source(own, if is_along { [a, b] } else { [b, a] }))
            }));
        }
    }

    /// Whether a part of a ring begins at a kink: where its source has one, or where the ring goes from one curve to another.
    fn is_kink(&self, part: &Part, halfedges: &[u32], sets: &[&YinSet]) -> bool {
        if !part.is_at_node {
            // The knot at which the part begins.
            let piece = if part.range[0] == 0.0 { part.piece } else { self.boundaries.next(part.piece) };
            return self.is_source_kink(piece, sets);
        }
        let chains = self.chains();
        let at = part.at as usize;
        let halfedge = halfedges[at];
        let before = halfedges[if at == 0 { halfedges.len() } else { at } - 1];
        let along = |halfedge: u32| {
            let list = self.cells.edges().chains().list(halfedge as usize / 2);
            list.iter().map(move |&chain| {
                (chain, self.cells.edges().halfedge_of_chain()[chain as usize] == halfedge)
            })
        };
        !along(before).any(|(a, is_a_along)| {
            along(halfedge).any(|(b, is_b_along)| {
                let [from, to] = if is_a_along { [a, b] } else { [b, a] };
                is_a_along == is_b_along && chains.end(from) == to && {
                    let passed = self.nodes.breaks[to as usize];
                    ![passed.arrive, passed.leave].iter().any(|position| {
                        position.parameter == 0.0 && self.is_source_kink(position.piece, sets)
                    })
                }
            })
        })
    }

    /// Whether the knot at the beginning of a piece is a kink of its set.
    pub(super) fn is_source_kink(&self, piece: u32, sets: &[&YinSet]) -> bool {
        let index = self.boundaries.index(piece);
        let knot = KnotIndex { curve: index.curve, knot: index.piece };
        sets[index.operand as usize].kinks().vertex(knot).is_some()
    }
}
