//! Where segments meet: every pair that has a common point, exactly.

use super::segment_grid::SegmentGrid;
use crate::geometry::predicates::{PlanarLine, PlanarPoint, orientation};
use rayon::prelude::*;
use std::cmp::Ordering;

/// What is arranged: points, and segments between them; then points on their own as segments of no length.
pub(super) struct Soup {
    pub(super) points: Vec<[f64; 2]>,
    /// The ends of each segment, first those that were given.
    pub(super) segments: Vec<[u32; 2]>,
    /// The coordinates of the ends.
    pub(super) lines: Vec<PlanarLine>,
}

impl Soup {
    /// The segments, and a point on its own for each point that no segment with a length ends in.
    pub(super) fn new(points: Vec<[f64; 2]>, mut segments: Vec<[u32; 2]>) -> Self {
        let mut loose = vec![true; points.len()];
        for &[a, b] in &segments {
            if points[a as usize] != points[b as usize] {
                loose[a as usize] = false;
                loose[b as usize] = false;
            }
        }
        segments.extend((0..points.len() as u32).filter(|&p| loose[p as usize]).map(|p| [p, p]));
        let lines = segments.iter().map(|ends| ends.map(|p| points[p as usize])).collect();
        Self { points, segments, lines }
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
    pub(super) fn point(&self, lines: &[PlanarLine]) -> PlanarPoint {
        let lines = self.segments.map(|s| lines[s as usize]);
        PlanarPoint::known_crossing(lines, self.rounded, self.residues)
    }
}

/// All meetings of segments.
#[derive(Default)]
pub(super) struct Meetings {
    pub(super) crossings: Vec<Crossing>,
    /// A segment and a given point that lies on it and is not one of its ends.
    pub(super) touches: Vec<[u32; 2]>,
}

impl Meetings {
    /// The meetings of all pairs; their order does not depend on the number of threads.
    pub(super) fn of(soup: &Soup, grid: &SegmentGrid) -> Self {
        const BLOCK: usize = 256;
        let count = soup.segments.len();
        let blocks: Vec<Self> = (0..count.div_ceil(BLOCK))
            .into_par_iter()
            .map_init(
                || vec![u32::MAX; count],
                |met_by, block| {
                    let mut found = Self::default();
                    for s in block * BLOCK..((block + 1) * BLOCK).min(count) {
                        grid.near(soup.lines[s], |list| {
                            // Each pair once: by its lower segment, and when it is first seen.
                            for &t in list.iter().rev().take_while(|&&t| t as usize > s) {
                                if std::mem::replace(&mut met_by[t as usize], s as u32) != s as u32 {
                                    found.meet(soup, s as u32, t);
                                }
                            }
                        });
                    }
                    found
                },
            )
            .collect();
        let mut all = Self {
            crossings: Vec::with_capacity(blocks.iter().map(|block| block.crossings.len()).sum()),
            touches: Vec::new(),
        };
        for block in blocks {
            all.crossings.extend(block.crossings);
            all.touches.extend(block.touches);
        }
        all
    }

    fn meet(&mut self, soup: &Soup, s: u32, t: u32) {
        let [[a, b], [c, d]] = [s, t].map(|segment| soup.lines[segment as usize]);
        let apart = |axis: usize| {
            a[axis].max(b[axis]) < c[axis].min(d[axis]) || c[axis].max(d[axis]) < a[axis].min(b[axis])
        };
        if apart(0) || apart(1) {
            return;
        }
        let of_t = [orientation(a, b, c), orientation(a, b, d)];
        if of_t[0] == of_t[1] && of_t[0].is_ne() {
            return;
        }
        let of_s = [orientation(c, d, a), orientation(c, d, b)];
        if of_s[0] == of_s[1] && of_s[0].is_ne() {
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
        for (on, line, ends, sides, other) in [(s, [a, b], [c, d], of_t, t), (t, [c, d], [a, b], of_s, s)] {
            for end in 0..2 {
                let point = ends[end];
                // A point of the line is on the segment when it is in the box around it.
                let within = (0..2).all(|axis| {
                    let [p, q] = [line[0][axis], line[1][axis]];
                    p.min(q) <= point[axis] && point[axis] <= p.max(q)
                });
                if sides[end].is_eq() && within && !line.contains(&point) {
                    self.touches.push([on, soup.segments[other as usize][end]]);
                }
            }
        }
    }
}
