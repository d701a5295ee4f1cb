//! The order of segments in the plane, near ones together.
//!
//! Segments that follow each other on a polyline stay together in runs, and runs are put in the order of a Hilbert
//! curve. A run that goes around what many others go around, as a square in a square does, has a box in which all of
//! them are. So where many runs are near each other, compared with how far each of them is from a segment, their
//! segments come one by one.

use coface_geometry::hilbert;
use coface_geometry::predicates::PlanarLine;
use rayon::prelude::*;
use std::ops::Range;

/// Segments in a leaf of the tree that stands on this order.
pub(super) const LEAF: usize = 8;

/// A run is broken up where it has at least so many others near it.
const CROWD: usize = 32;

/// Segments by where they are.
pub(super) struct HilbertOrder {
    /// A power of two that brings all coordinates between -1 and 1.
    pub(super) factor: f64,
    /// The segment at each place.
    pub(super) order: Vec<u32>,
}

impl HilbertOrder {
    /// The order of `count` segments; `is_joined` tells whether a segment begins where the one before it ends.
    ///
    /// # Complexity
    /// $O(n \log n)$.
    pub(super) fn new(
        count: usize,
        line: &(impl Fn(usize) -> PlanarLine + Sync),
        is_joined: &(impl Fn(usize) -> bool + Sync),
    ) -> Self {
        let square = Square::around(count, line);
        let mut starts: Vec<u32> = Vec::with_capacity(count / LEAF + 1);
        for s in 0..count {
            let is_new = starts.last().is_none_or(|&first| s - first as usize == LEAF || !is_joined(s));
            if is_new {
                starts.push(s as u32);
            }
        }
        let mut runs = Runs { starts, count };
        let mut places = runs.places(&square, line);
        let is_crowded = |at: usize| square.is_crowded(&places, at, runs.segments(places[at].1), line);
        let crowded = (0..places.len()).into_par_iter().with_min_len(512).filter(|&at| is_crowded(at));
        let crowded: Vec<u32> = crowded.map(|at| places[at].1).collect();
        if !crowded.is_empty() {
            runs = runs.broken_up(&crowded);
            places = runs.places(&square, line);
        }
        let mut order = Vec::with_capacity(count);
        for (_, run) in places {
            order.extend(runs.segments(run).map(|s| s as u32));
        }
        Self { factor: square.factor, order }
    }
}

/// Where all segments are.
struct Square {
    factor: f64,
    /// The lowest coordinates, multiplied by the factor.
    low: [f64; 2],
    /// What makes the largest differences of coordinates $2^{32}$.
    scale: [f64; 2],
}

impl Square {
    fn around(count: usize, line: &(impl Fn(usize) -> PlanarLine + Sync)) -> Self {
        let corners = (0..count).into_par_iter().with_min_len(4096).map(|s| {
            let [p, q] = line(s);
            [[0, 1].map(|i| p[i].min(q[i])), [0, 1].map(|i| p[i].max(q[i]))]
        });
        let nothing = || [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
        let [low, high] = corners.reduce(nothing, |a, b| {
            [[0, 1].map(|i| a[0][i].min(b[0][i])), [0, 1].map(|i| a[1][i].max(b[1][i]))]
        });
        let largest = low.iter().chain(&high).fold(1e-290, |largest: f64, x| largest.max(x.abs()));
        // An ordinary number above the largest; its inverse is one too.
        let factor =
            if count == 0 { 1.0 } else { 2f64.powi(-(largest.log2().floor() as i32 + 1).clamp(-1020, 1020)) };
        let low = low.map(|x| x * factor);
        let scale = [0, 1].map(|i| (1u64 << 32) as f64 / (high[i] * factor - low[i]));
        Self { factor, low, scale }
    }

    /// The place of the middle between two points on the Hilbert curve.
    fn place(&self, p: [f64; 2], q: [f64; 2]) -> u64 {
        // A cast sends what is no number to zero, and what is too large to the largest number.
        let [x, y] = [0, 1].map(|i| {
            let middle = 0.5 * (p[i] * self.factor + q[i] * self.factor);
            ((middle - self.low[i]) * self.scale[i]) as u32
        });
        hilbert(x, y)
    }

    /// Whether many runs are near one of them, given its place among all: in a square of the curve that is no larger
    /// than the run is wide.
    fn is_crowded(
        &self,
        places: &[(u64, u32)],
        at: usize,
        run: Range<usize>,
        line: &impl Fn(usize) -> PlanarLine,
    ) -> bool {
        if run.len() == 1 {
            return false;
        }
        let near = [at.checked_sub(CROWD), Some(at + CROWD)].map(|other| Some(places.get(other?)?.0));
        if near == [None; 2] {
            return false;
        }
        let level = self.width(run, line).log2();
        // Also false for what is no number.
        let is_wide = level >= 0.0;
        let square = |place: u64| place.checked_shr(2 * (level as u32).min(32)).unwrap_or(0);
        is_wide && near.into_iter().flatten().any(|other| square(other) == square(places[at].0))
    }

    /// How far a run reaches across its longest segment, in units of the curve.
    fn width(&self, run: Range<usize>, line: &impl Fn(usize) -> PlanarLine) -> f64 {
        let scaled = |s: usize| line(s).map(|point| point.map(|x| x * self.factor));
        let [origin, _] = scaled(run.start);
        let mut along = [0.0; 2];
        let mut longest = 0.0;
        let [mut low, mut high] = [origin; 2];
        for [p, q] in run.clone().map(scaled) {
            let to = [0, 1].map(|i| q[i] - p[i]);
            let square = to[0] * to[0] + to[1] * to[1];
            if square > longest {
                (longest, along) = (square, to);
            }
            for i in 0..2 {
                low[i] = low[i].min(p[i]).min(q[i]);
                high[i] = high[i].max(p[i]).max(q[i]);
            }
        }
        let [mut right, mut left] = [0.0f64; 2];
        for [p, q] in run.map(scaled) {
            for point in [p, q] {
                let across = along[0] * (point[1] - origin[1]) - along[1] * (point[0] - origin[0]);
                right = right.min(across);
                left = left.max(across);
            }
        }
        let sides = [0, 1].map(|i| high[i] - low[i]);
        let across = (left - right) / longest.sqrt();
        let least = (sides[0] * self.scale[0]).min(sides[1] * self.scale[1]);
        // A run along a slanted line is narrower than its box.
        if across > 0.0 { least * (across / sides[0].min(sides[1])).min(1.0) } else { 0.0 }
    }
}

/// Segments one after the other in parts.
struct Runs {
    /// The first segment of each.
    starts: Vec<u32>,
    /// How many segments there are in all.
    count: usize,
}

impl Runs {
    fn segments(&self, run: u32) -> Range<usize> {
        let end = self.starts.get(run as usize + 1).map_or(self.count, |&next| next as usize);
        self.starts[run as usize] as usize..end
    }

    /// The runs along the curve, each with its place on it.
    fn places(&self, square: &Square, line: &(impl Fn(usize) -> PlanarLine + Sync)) -> Vec<(u64, u32)> {
        let runs = (0..self.starts.len() as u32).into_par_iter().with_min_len(512);
        let place = |run: u32| {
            let own = self.segments(run);
            (square.place(line(own.start)[0], line(own.end - 1)[1]), run)
        };
        let mut places: Vec<(u64, u32)> = runs.map(place).collect();
        places.par_sort_unstable();
        places
    }

    /// The same with runs of one segment for some.
    fn broken_up(&self, some: &[u32]) -> Self {
        let mut is_broken = vec![false; self.starts.len()];
        some.iter().for_each(|&run| is_broken[run as usize] = true);
        let mut starts = Vec::with_capacity(self.starts.len() + (LEAF - 1) * some.len());
        for run in 0..self.starts.len() as u32 {
            let own = self.segments(run);
            let end = if is_broken[run as usize] { own.end } else { own.start + 1 };
            starts.extend((own.start..end).map(|s| s as u32));
        }
        Self { starts, count: self.count }
    }
}
