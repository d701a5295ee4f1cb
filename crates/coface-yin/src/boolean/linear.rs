//! Boolean combinations of sets of order 2, exactly.

use super::outline::Outline;
use super::rounding::is_doubtful;
use super::{Combination, PieceSource};
use crate::set::{CurveArena, parameter};
use crate::{KnotIndex, YinSet};
use coface_algebra::{EdgeId, Error, RaggedArray};
use coface_arrange::boolean::InsideRule;
use coface_arrange::planar::{PlanarOverlay, PlanarPolygons};
use coface_geometry::Positions;
use rayon::prelude::*;

/// The curves of order 2 of some arenas laid over each other, each arena a region. Sides are the pieces of the arenas, one after the
/// other.
pub(crate) fn linear_overlay(arenas: &[&CurveArena]) -> Result<PlanarOverlay, Error> {
    let point_count: usize = arenas.iter().map(|arena| arena.controls().len()).sum();
    let piece_count: usize = arenas.iter().map(|arena| arena.piece_count()).sum();
    let mut flat = Vec::with_capacity(2 * point_count);
    let (mut starts, mut items) = (vec![0u32], Vec::with_capacity(piece_count));
    let mut regions = Vec::new();
    let mut first = 0u32;
    for (region, arena) in (0..).zip(arenas) {
        flat.extend_from_slice(arena.controls().as_flattened());
        for curve in 0..arena.len() {
            let count = (arena.first_piece(curve + 1) - arena.first_piece(curve)) as u32;
            items.extend(first..first + count);
            // The first point comes again at the end.
            first += count + 1;
            starts.push(items.len() as u32);
            regions.push(region);
        }
    }
    PlanarOverlay::new(&Positions::from_flat(2, flat)?, &RaggedArray::from_parts(starts, items)?, &regions)
}

/// Which sets a face is in, by the winding numbers of their curves: the inside of a set is where they are 1, or 0 if it is unbounded.
/// Curves that cross by rounding turn small parts inside out; those are outside, and what is wound around twice is inside.
pub(crate) struct Membership<'a> {
    sets: &'a [&'a YinSet],
}

impl<'a> Membership<'a> {
    pub(crate) fn new(sets: &'a [&'a YinSet]) -> Self {
        Self { sets }
    }

    pub(crate) fn is_inside(&self, set: usize, windings: &[(u32, i32)]) -> bool {
        let found = windings.binary_search_by_key(&(set as u32), |&(region, _)| region);
        let winding = found.map_or(0, |at| windings[at].1);
        winding >= i32::from(self.sets[set].is_bounded())
    }

    /// The number of sets that a face is in.
    pub(crate) fn count(&self, unbounded_count: usize, windings: &[(u32, i32)]) -> usize {
        let changes = windings.iter().map(|&(region, winding)| {
            let is_bounded = self.sets[region as usize].is_bounded();
            isize::from(winding >= i32::from(is_bounded)) - isize::from(!is_bounded)
        });
        unbounded_count.wrapping_add_signed(changes.sum())
    }
}

/// How often a result is repaired before it is given up.
const MOST_REPAIRS: usize = 100;

/// The set of the faces whose winding numbers satisfy a condition. Where rounding of its corners made curves meet, they are laid over
/// each other once more.
pub(super) fn combine_linear(
    sets: &[&YinSet],
    condition: impl Fn(&[(u32, i32)]) -> bool,
) -> Result<Combination, Error> {
    let (mut found, mut is_doubtful) = combine_once(sets, condition)?;
    for _ in 0..MOST_REPAIRS {
        if !is_doubtful || found.set.validate()?.is_none() {
            return Ok(found);
        }
        let again = [&found.set];
        let membership = Membership::new(&again);
        let (repaired, is_again) = combine_once(&again, |windings| membership.is_inside(0, windings))?;
        (found, is_doubtful) = (repaired.after(&found), is_again);
    }
    Err(Error::invalid(format!(
        "rounding makes curves meet again and again: {MOST_REPAIRS} repairs are not enough"
    ))
    .with_cure("scale the sets up, or remove curves that nearly coincide"))
}

/// The same without a look at what rounding did: and whether there is need of one.
fn combine_once(
    sets: &[&YinSet],
    condition: impl Fn(&[(u32, i32)]) -> bool,
) -> Result<(Combination, bool), Error> {
    let arenas: Vec<&CurveArena> = sets.iter().map(|set| set.arena()).collect();
    let overlay = linear_overlay(&arenas)?;
    let (polygons, parents) = overlay.select_nested(condition)?;
    let outline = Outline::new(&polygons, &parents);
    let is_doubtful = is_doubtful(&polygons, &outline);
    let operands = Operands::new(&arenas);
    let ((sources, other_sources), kinks) = rayon::join(
        || operands.sources(&arenas, &polygons, &outline),
        || operands.kinks(sets, &polygons, &outline),
    );
    let is_unbounded = polygons.has_exterior();
    let Outline { curves, parents, collapsed_count, .. } = outline;
    let found = Combination {
        set: YinSet::from_parts(curves, is_unbounded, parents, kinks),
        sources,
        other_sources,
        collapsed_count,
        repair_count: 0,
        resolution: 0.0,
        report: Vec::new(),
        area_error: 0.0,
    };
    Ok((found, is_doubtful))
}

/// The set that rings bound by a fill rule.
pub(crate) fn combine_rings(flat: Vec<f64>, rings: &RaggedArray, rule: InsideRule) -> Result<YinSet, Error> {
    let overlay = PlanarOverlay::new(&Positions::from_flat(2, flat)?, rings, &vec![0; rings.len()])?;
    let is_inside = |windings: &[(u32, i32)]| windings.first().is_some_and(|&(_, w)| rule.is_inside(w));
    let (polygons, parents) = overlay.select_nested(is_inside)?;
    let outline = Outline::new(&polygons, &parents);
    let starts: Vec<u32> = (0..=rings.len()).map(|ring| rings.start(ring) as u32).collect();
    let operands = Operands { curve_of_side: curve_of_side(&starts), starts, first_curves: vec![0] };
    let kinks = operands.kinks(&[], &polygons, &outline);
    let is_doubtful = is_doubtful(&polygons, &outline);
    let set = YinSet::from_parts(outline.curves, false, outline.parents, kinks);
    if is_doubtful && set.validate()?.is_some() {
        let again = [&set];
        let membership = Membership::new(&again);
        return Ok(combine_linear(&again, |windings| membership.is_inside(0, windings))?.into_set());
    }
    Ok(set)
}

fn curve_of_side(starts: &[u32]) -> Vec<u32> {
    let mut found = Vec::with_capacity(starts.last().map_or(0, |&end| end as usize));
    for (curve, ends) in (0..).zip(starts.windows(2)) {
        found.resize(ends[1] as usize, curve);
    }
    found
}

/// What the sides of an overlay are in its operands. Curves of all operands are numbered one after the other here.
struct Operands {
    curve_of_side: Vec<u32>,
    /// The first side of each curve, and where the last ends.
    starts: Vec<u32>,
    /// The first curve of each operand.
    first_curves: Vec<u32>,
}

impl Operands {
    fn new(arenas: &[&CurveArena]) -> Self {
        let (mut starts, mut first_curves) = (vec![0], Vec::with_capacity(arenas.len()));
        let mut first_side = 0;
        for arena in arenas {
            first_curves.push(starts.len() as u32 - 1);
            starts.extend((1..=arena.len()).map(|curve| (first_side + arena.first_piece(curve)) as u32));
            first_side += arena.piece_count();
        }
        Self { curve_of_side: curve_of_side(&starts), starts, first_curves }
    }

    /// The operand and the knot that a side begins at.
    fn knot(&self, side: usize) -> (usize, KnotIndex) {
        let curve = self.curve_of_side[side];
        let operand = self.first_curves.partition_point(|&first| first <= curve) - 1;
        let knot = side as u32 - self.starts[curve as usize];
        (operand, KnotIndex { curve: curve - self.first_curves[operand], knot })
    }

    /// The side after this one on its curve.
    fn next(&self, side: usize) -> usize {
        let curve = self.curve_of_side[side] as usize;
        if side + 1 == self.starts[curve + 1] as usize { self.starts[curve] as usize } else { side + 1 }
    }

    /// Where the pieces of a result come from, and what else they run along, by rising pieces.
    fn sources(
        &self,
        arenas: &[&CurveArena],
        polygons: &PlanarPolygons<'_>,
        outline: &Outline,
    ) -> (Vec<PieceSource>, Vec<(u32, PieceSource)>) {
        let points = outline.curves.controls();
        let curve_of = |piece: usize, last: &mut usize| {
            let is_on = |curve: usize| {
                outline.curves.first_piece(curve) <= piece && piece < outline.curves.first_piece(curve + 1)
            };
            // Mostly the same curve as before, or the next.
            if !is_on(*last) {
                *last = match *last + 1 {
                    next if next < outline.curves.len() && is_on(next) => next,
                    _ => outline.curves.curve_of_piece(piece).0,
                };
            }
            *last
        };
        let along = |piece: usize, last: &mut usize| {
            // Each curve has one point more than it has pieces.
            let at = piece + curve_of(piece, last);
            let ends = [points[at], points[at + 1]];
            let sides = polygons.sides_of_edge(EdgeId::from_u32(outline.edges[piece]));
            sides.map(move |side| self.source(arenas, side, ends))
        };
        let pieces = || (0..outline.edges.len()).into_par_iter().with_min_len(1 << 12);
        let sources = pieces().map_init(
            || 0,
            |last, piece| along(piece, last).next().expect("a side runs along each edge of polygons"),
        );
        let sources = sources.collect();
        let has_others =
            |piece: &usize| polygons.sides_of_edge(EdgeId::from_u32(outline.edges[*piece])).nth(1).is_some();
        let others = pieces().filter(has_others).flat_map_iter(|piece| {
            let rest: Vec<_> = along(piece, &mut 0).skip(1).collect();
            rest.into_iter().map(move |source| (piece as u32, source))
        });
        (sources, others.collect())
    }

    fn source(&self, arenas: &[&CurveArena], side: usize, ends: [[f64; 2]; 2]) -> PieceSource {
        let (operand, KnotIndex { curve, knot }) = self.knot(side);
        let first = arenas[operand].first_piece(curve as usize) + (knot + curve) as usize;
        let line = [0, 1].map(|end| arenas[operand].controls()[first + end]);
        let range = ends.map(|end| parameter(line, end));
        PieceSource { operand: operand as u32, curve, piece: knot, range }
    }

    /// The knots of a result that are kinks: those at which two neighbors on one curve of an operand do not come together, or come
    /// together in a kink.
    fn kinks(&self, sets: &[&YinSet], polygons: &PlanarPolygons<'_>, outline: &Outline) -> Vec<KnotIndex> {
        let is_kink = |side: usize| {
            let (operand, knot) = self.knot(side);
            sets.get(operand).is_some_and(|set| set.kinks().vertex(knot).is_some())
        };
        let has_kinks = sets.iter().any(|set| !set.kinks().is_empty());
        let is_result_kink = |before: EdgeId, after: EdgeId| {
            let (mut is_smooth, mut is_old_kink) = (false, false);
            for s in polygons.sides_of_edge(before) {
                for t in polygons.sides_of_edge(after) {
                    if s == t {
                        is_smooth = true;
                    } else if self.curve_of_side[s] == self.curve_of_side[t] {
                        if self.next(s) == t {
                            is_smooth = true;
                            is_old_kink |= has_kinks && is_kink(t);
                        } else if self.next(t) == s {
                            is_smooth = true;
                            is_old_kink |= has_kinks && is_kink(s);
                        }
                    }
                }
            }
            !is_smooth || is_old_kink
        };
        let curves = (0..outline.curves.len()).into_par_iter().with_min_len(1 << 8);
        let kinks = curves.flat_map_iter(|curve| {
            let own = outline.curves.first_piece(curve)..outline.curves.first_piece(curve + 1);
            let knots = (0..).zip(own.clone()).filter(move |&(_, piece)| {
                let before = if piece == own.start { own.end } else { piece } - 1;
                let [before, after] = [before, piece].map(|at| EdgeId::from_u32(outline.edges[at]));
                is_result_kink(before, after)
            });
            knots.map(move |(knot, _)| KnotIndex { curve: curve as u32, knot })
        });
        kinks.collect()
    }
}
