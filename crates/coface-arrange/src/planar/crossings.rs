//! Where segments meet: every pair that has a common point, exactly.

use super::PlanarOptions;
use super::exact_ends::ExactEnds;
use super::segment_tree::SegmentTree;
use coface_algebra::Error;
use coface_algebra::progress::stage;
use coface_geometry::PairTask;
use coface_geometry::predicates::{PlanarLine, PlanarPoint, orientation};
use rayon::prelude::*;
use std::cmp::Ordering;
use std::sync::Arc;

/// What is arranged: points, and segments between them.
#[derive(Default)]
pub(super) struct Soup {
    pub(super) points: Vec<[f64; 2]>,
    /// The points at the ends of each segment.
    pub(super) segments: Vec<[u32; 2]>,
    /// Exact ends where points are rounded; of segments without a length for points on their own there are none.
    pub(super) exact: Option<Arc<ExactEnds>>,
}

impl Soup {
    /// The segments as given, and after them a segment of no length for each point that no segment with a length ends
    /// in.
    pub(super) fn with_loose_points(points: Vec<[f64; 2]>, mut segments: Vec<[u32; 2]>) -> Self {
        let mut loose = vec![true; points.len()];
        for &[a, b] in &segments {
            if points[a as usize] != points[b as usize] {
                loose[a as usize] = false;
                loose[b as usize] = false;
            }
        }
        segments.extend((0..points.len() as u32).filter(|&p| loose[p as usize]).map(|p| [p, p]));
        Self { points, segments, exact: None }
    }

    /// The ends of a segment.
    pub(super) fn line(&self, segment: u32) -> PlanarLine {
        self.segments[segment as usize].map(|point| self.points[point as usize])
    }

    /// The tree on the segments.
    pub(super) fn tree(&self) -> SegmentTree {
        let is_joined = |s: usize| s > 0 && self.segments[s][0] == self.segments[s - 1][1];
        SegmentTree::new(self.segments.len(), |s| self.line(s as u32), is_joined)
    }
}

/// The crossing of the interiors of two segments that are not parallel.
#[derive(Clone, Copy)]
pub(super) struct Crossing {
    pub(super) segments: [u32; 2],
    pub(super) rounded: [f64; 2],
    pub(super) residues: [Option<Ordering>; 2],
}

impl Crossing {
    pub(super) fn point(&self, soup: &Soup) -> PlanarPoint {
        PlanarPoint::known_crossing(self.segments.map(|s| soup.support(s)), self.rounded, self.residues)
    }
}

/// All meetings of segments.
#[derive(Default)]
pub(super) struct Meetings {
    pub(super) crossings: Vec<Crossing>,
    /// A segment and a given point that lies on it and is not one of its ends.
    pub(super) touches: Vec<[u32; 2]>,
    /// Points at one place, at which segments end; twice the same one where segments fold back.
    pub(super) equal_points: Vec<[u32; 2]>,
    /// Segments on one line with a common point: those that may run along each other.
    pub(super) collinear: Vec<[u32; 2]>,
    /// Segments that have no common point, and of which none lies on one side of the other by many units of the last place.
    pub(super) close: Vec<[u32; 2]>,
}

/// Units of the last place, of the largest coordinate of the line and the point, that a point off a line is more than away
/// from it.
const CLEAR_UNITS: f64 = 16.0;

/// Whether a point lies off a line through two points by more than rounding does to points on it; `false` says nothing.
pub(super) fn is_clear_of([a, b]: PlanarLine, c: [f64; 2]) -> bool {
    let [left, right] = [(a[0] - c[0]) * (b[1] - c[1]), (a[1] - c[1]) * (b[0] - c[0])];
    let largest = [a, b, c].as_flattened().iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    let reach = (b[0] - a[0]).abs() + (b[1] - a[1]).abs();
    let moved = CLEAR_UNITS * f64::EPSILON * largest * reach;
    let lost = 2.0 * f64::EPSILON * (left.abs() + right.abs());
    // Also false for what is no number.
    (left - right).abs() > moved + lost + 2.0 * f64::MIN_POSITIVE
}

impl Meetings {
    /// The meetings of all pairs; their order does not depend on the number of threads.
    ///
    /// # Errors
    /// When there must be more cells than the options allow.
    pub(super) fn of(soup: &Soup, tree: &SegmentTree, options: &PlanarOptions) -> Result<Self, Error> {
        let parts = tree.parts();
        let steps = stage("finding crossings", parts.len());
        let search = |&part: &PairTask| {
            steps.advance(1);
            let mut found = Self::default();
            match soup.exact {
                None => tree.search(part, |pair, lines| found.meet(soup, pair, lines)),
                Some(_) => tree.search(part, |pair, _| found.meet_exactly(soup, pair)),
            }
            found
        };
        // Without a bound all at once; else some parts at a time.
        let at_once =
            if options.max_cells.is_some() { parts.len().div_ceil(64).max(1) } else { parts.len().max(1) };
        let mut all = Self::default();
        let mut next_look = 0;
        for some in parts.chunks(at_once) {
            let found: Vec<Self> = some.par_iter().map(search).collect();
            let more = |count: fn(&Self) -> usize| found.iter().map(count).sum();
            all.crossings.reserve(more(|part| part.crossings.len()));
            all.touches.reserve(more(|part| part.touches.len()));
            all.equal_points.reserve(more(|part| part.equal_points.len()));
            all.collinear.reserve(more(|part| part.collinear.len()));
            all.close.reserve(more(|part| part.close.len()));
            for part in found {
                all.crossings.extend(part.crossings);
                all.touches.extend(part.touches);
                all.equal_points.extend(part.equal_points);
                all.collinear.extend(part.collinear);
                all.close.extend(part.close);
            }
            if let Some(most) = options.max_cells
                && all.crossings.len() > most / 4
                && all.crossings.len() >= next_look
            {
                options.check(all.least_cell_count(), "so far")?;
                // Crossings at one place count once: until there are twice as many it is not worth while to look again.
                next_look = 2 * all.crossings.len();
            }
        }
        Ok(all)
    }

    /// A number of cells that the arrangement has at least: at a crossing a vertex with four edges, and with $V - E +
    /// F$ the number of components there are at least four cells a crossing.
    fn least_cell_count(&self) -> usize {
        let mut places: Vec<[u64; 2]> =
            self.crossings.par_iter().map(|crossing| crossing.rounded.map(|x| (x + 0.0).to_bits())).collect();
        places.par_sort_unstable();
        places.dedup();
        4 * places.len()
    }

    fn meet(&mut self, soup: &Soup, [s, t]: [u32; 2], [[a, b], [c, d]]: [PlanarLine; 2]) {
        let [ends_s, ends_t] = [s, t].map(|segment| soup.segments[segment as usize]);
        // One side that goes on from the other, or two from one point, in different directions: they meet nowhere else.
        let shared = (0..4).find(|i| ends_s[i / 2] == ends_t[i % 2]);
        if let Some(i) = shared
            && orientation(a, b, if i % 2 == 0 { d } else { c }).is_ne()
        {
            return;
        }
        let of_t = [orientation(a, b, c), orientation(a, b, d)];
        if of_t[0] == of_t[1] && of_t[0].is_ne() {
            if !(is_clear_of([a, b], c) && is_clear_of([a, b], d)) {
                self.note_apart([s, t], [[c, d], [a, b]]);
            }
            return;
        }
        let of_s = [orientation(c, d, a), orientation(c, d, b)];
        if of_s[0] == of_s[1] && of_s[0].is_ne() {
            self.note_apart([s, t], [[c, d], [a, b]]);
            return;
        }
        if of_s.iter().chain(&of_t).all(|side| side.is_ne()) {
            let lines = [[a, b], [c, d]];
            let point =
                PlanarPoint::crossing(lines[0], lines[1]).expect("segments that cross are not parallel");
            self.crossings.push(Crossing {
                segments: [s, t],
                rounded: point.rounded(),
                residues: point.residues(),
            });
            return;
        }
        if of_s.iter().chain(&of_t).all(|side| side.is_eq()) {
            self.collinear.push([s, t]);
        }
        let [touch_count, equal_count] = [self.touches.len(), self.equal_points.len()];
        for (p, at_p) in ends_s.into_iter().zip([a, b]) {
            for (q, at_q) in ends_t.into_iter().zip([c, d]) {
                if p != q && at_p == at_q {
                    self.equal_points.push([p, q]);
                }
            }
        }
        let touches = [(s, [a, b], [c, d], of_t, ends_t), (t, [c, d], [a, b], of_s, ends_s)];
        for (on, line, ends, sides, numbers) in touches {
            for end in 0..2 {
                let point = ends[end];
                // A point of the line is on the segment when it is in the box around it.
                let within = (0..2).all(|axis| {
                    let [p, q] = [line[0][axis], line[1][axis]];
                    p.min(q) <= point[axis] && point[axis] <= p.max(q)
                });
                if sides[end].is_eq() && within && !line.contains(&point) {
                    self.touches.push([on, numbers[end]]);
                }
            }
        }
        // Segments that share an end and more: they fold back there.
        if self.touches.len() > touch_count || self.equal_points.len() > equal_count {
            let shared = ends_s.into_iter().filter(|end| ends_t.contains(end));
            self.equal_points.extend(shared.map(|end| [end, end]));
        }
    }

    /// Two segments have no common point; unless the second lies on one side of the first by many units they are close.
    fn note_apart(&mut self, pair: [u32; 2], [line, [p, q]]: [PlanarLine; 2]) {
        let is_beside = orientation(line[0], line[1], p) == orientation(line[0], line[1], q);
        if !(is_beside && is_clear_of(line, p) && is_clear_of(line, q)) {
            self.close.push(pair);
        }
    }
}
