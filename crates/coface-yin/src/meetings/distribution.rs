//! What carriers have in common, handed to the pieces that lie there.

use super::carriers::{Carriers, REACH};
use super::overlaps::opposite_on_arc;
use super::polynomial::is_near;
use super::{Meeting, Meetings, Overlap, Polynomial};
use crate::curve::{bernstein, on_grid};

/// Hands what carriers have in common to their pieces.
struct Distribution<'a> {
    carriers: &'a Carriers,
    resolution: f64,
    points: Vec<Meeting>,
    overlaps: Vec<Overlap>,
}

impl Meetings {
    /// The meetings of pieces, with local parameters, from those of their carriers.
    ///
    /// The common end of neighbors on a curve is not listed unless they meet there otherwise.
    pub(super) fn distributed(self, carriers: &Carriers, resolution: f64) -> Self {
        let (points, overlaps) = (Vec::with_capacity(self.points.len()), self.overlaps.clone());
        let mut all = Distribution { carriers, resolution, points, overlaps: Vec::new() };
        for meeting in &self.points {
            all.meet(meeting);
        }
        for [p, a, q, b] in carriers.all_joints() {
            all.meet(&Meeting {
                pieces: [p, q],
                parameters: [[f64::from(a); 2], [f64::from(b); 2]],
                at: [a, b].map(f64::from),
                point: carriers.controls(p)[if a == 0 { 0 } else { carriers.controls(p).len() - 1 }],
                is_certified: true,
            });
        }
        for overlap in &overlaps {
            all.overlap(overlap);
        }
        for carrier in 0..carriers.len() as u32 {
            all.overlap_on(carrier);
        }
        let Distribution { mut points, mut overlaps, .. } = all;
        points.sort_by(|x, y| {
            let by_place = x.at[0].total_cmp(&y.at[0]).then(x.at[1].total_cmp(&y.at[1]));
            x.pieces.cmp(&y.pieces).then(by_place)
        });
        points.dedup_by(|b, a| a.pieces == b.pieces && a.at == b.at);
        overlaps.sort_by(|x, y| x.pieces.cmp(&y.pieces).then(x.ranges[0][0].total_cmp(&y.ranges[0][0])));
        let first_pieces = |pair: [u32; 2]| {
            let mut pieces = pair.map(|carrier| carriers.pieces(carrier)[0]);
            pieces.sort_unstable();
            pieces
        };
        let exhausted = self.exhausted.into_iter().map(first_pieces).collect();
        Self { points, overlaps, exhausted, depth: self.depth }
    }
}

impl Distribution<'_> {
    /// The pieces of a carrier that a parameter is on, or within the resolution of which it is.
    fn holders(&self, carrier: u32, t: f64) -> impl Iterator<Item = u32> + '_ {
        let pieces = self.carriers.pieces(carrier);
        let end = pieces.partition_point(|&piece| {
            let [from, to] = self.carriers.span(piece);
            from.min(to) <= t + REACH
        });
        pieces[..end].iter().copied().filter(move |&piece| {
            let [from, to] = self.carriers.span(piece);
            let [low, high] = [from.min(to), from.max(to)];
            let nearest = t.clamp(low, high);
            nearest == t || (nearest - t).abs() <= REACH && self.is_short(carrier, [nearest, t])
        })
    }

    /// Whether the way between two parameters of a carrier stays within the resolution.
    fn is_short(&self, carrier: u32, range: [f64; 2]) -> bool {
        let [low, high] =
            bernstein::control_box(&bernstein::sub_range(self.carriers.controls(carrier), range));
        (0..2).all(|axis| high[axis] - low[axis] <= self.resolution)
    }

    /// Whether two places are at the knot between neighbors, up to the resolution.
    fn is_between_neighbors(&self, [p, q]: [u32; 2], [s, t]: [f64; 2]) -> bool {
        let is_at = |piece: u32, local: f64, end: f64| {
            local == end || {
                let [low, high] = bernstein::control_box(&self.carriers.part(piece, [local, end]));
                (0..2).all(|axis| high[axis] - low[axis] <= 4.0 * self.resolution)
            }
        };
        let follows = |p: u32, s: f64, q: u32, t: f64| {
            self.carriers.next(p) == q && is_at(p, s, self.carriers.length(p)) && is_at(q, t, 0.0)
        };
        follows(p, s, q, t) || follows(q, t, p, s)
    }

    fn meet(&mut self, meeting: &Meeting) {
        let [c, d] = meeting.pieces;
        let at = meeting.at.map(|t| on_grid(t.clamp(0.0, 1.0)));
        let [of_c, of_d] = [0, 1].map(|k| self.holders([c, d][k], at[k]).collect::<Vec<u32>>());
        for &p in &of_c {
            for &q in &of_d {
                let pieces = [p, q];
                let locals = [0, 1].map(|k| self.carriers.local(pieces[k], at[k]));
                if p == q && locals[0] == locals[1] || self.is_between_neighbors(pieces, locals) {
                    continue;
                }
                let parameters = [0, 1].map(|k| {
                    let [a, b] = meeting.parameters[k].map(|t| self.carriers.local(pieces[k], t));
                    [a.min(b), a.max(b)]
                });
                self.push(Meeting { pieces, parameters, at: locals, ..*meeting });
            }
        }
    }

    /// Adds a meeting, whose point is that of an end where it is at one.
    fn push(&mut self, mut meeting: Meeting) {
        if meeting.pieces[0] > meeting.pieces[1]
            || meeting.pieces[0] == meeting.pieces[1] && meeting.at[0] > meeting.at[1]
        {
            meeting.pieces.reverse();
            meeting.parameters.reverse();
            meeting.at.reverse();
        }
        let end = |k: usize| {
            let piece = meeting.pieces[k];
            let ends = [0.0, self.carriers.length(piece)];
            let end = ends.iter().position(|&end| end == meeting.at[k])?;
            Some(self.carriers.end(piece, end))
        };
        if let Some(point) = end(0).or_else(|| end(1)) {
            meeting.point = point;
        }
        self.points.push(meeting);
    }

    /// The parts of an overlap of two carriers that their pieces have.
    fn overlap(&mut self, overlap: &Overlap) {
        let [c, d] = overlap.pieces;
        let [of_c, of_d] = overlap.ranges.map(|range| range.map(|t| on_grid(t.clamp(0.0, 1.0))));
        if of_c[0] == of_c[1] || of_d[0] == of_d[1] {
            return;
        }
        // The ends are the same bit for bit; lengths that are equal make no error.
        let own = [c, d].map(|carrier| Polynomial::new(self.carriers.controls(carrier)));
        let resolution = self.resolution;
        let mapped = |t: f64, [first, second]: [usize; 2]| {
            let [from, to] = [first, second].map(|k| [of_c, of_d][k]);
            if t == from[0] {
                return to[0];
            }
            if t == from[1] {
                return to[1];
            }
            let slope = (to[1] - to[0]) / (from[1] - from[0]);
            let even = to[0] + (t - from[0]) * slope;
            // Two parts of one polynomial have even steps opposite even ones.
            let is_even = overlap.is_certified || is_near(own[first].at(t), own[second].at(even), resolution);
            let found = match is_even {
                true => even,
                false => opposite_on_arc([&own[first], &own[second]], [from, to], t, resolution),
            };
            on_grid(found.clamp(0.0, 1.0))
        };
        for &p in self.carriers.pieces(c) {
            let [low, high] = sorted(self.carriers.span(p));
            let [low, high] = [low.max(of_c[0]), high.min(of_c[1])];
            if low > high {
                continue;
            }
            for &q in self.carriers.pieces(d) {
                let own = sorted(self.carriers.span(q));
                let [least, most] = sorted(of_d);
                let own = [own[0].max(least), own[1].min(most)];
                if own[0] > own[1] {
                    continue;
                }
                let [a, b] = sorted(own.map(|s| mapped(s, [1, 0])));
                let ends = [a.max(low), b.min(high)];
                if ends[0] > ends[1] {
                    continue;
                }
                let opposite = ends.map(|t| {
                    let at = (0..2).find(|&k| mapped(own[k], [1, 0]) == t);
                    at.map_or_else(|| mapped(t, [0, 1]).clamp(own[0], own[1]), |k| own[k])
                });
                self.push_common([p, q], [ends, opposite], overlap.is_certified);
            }
        }
    }

    /// What the pieces of one carrier have in common.
    fn overlap_on(&mut self, carrier: u32) {
        let pieces = self.carriers.pieces(carrier).to_vec();
        for (i, &p) in pieces.iter().enumerate() {
            let [low, high] = sorted(self.carriers.span(p));
            for &q in &pieces[i + 1..] {
                let [least, most] = sorted(self.carriers.span(q));
                if least > high + REACH {
                    break;
                }
                let [from, to] = [low.max(least), high.min(most)];
                let is_short = from == to || self.is_short(carrier, [from, to]);
                if is_short {
                    // Ends that are one point, whether they pass each other or not.
                    self.push_common([p, q], [[to; 2], [from; 2]], true);
                } else if from < to {
                    self.push_common([p, q], [[from, to]; 2], true);
                }
            }
        }
    }

    /// Adds an arc that two pieces have in common, by parameters on their carriers, or the point if that is all.
    fn push_common(&mut self, mut pieces: [u32; 2], mut ranges: [[f64; 2]; 2], is_certified: bool) {
        if pieces[0] > pieces[1] {
            pieces.reverse();
            ranges.reverse();
        }
        let mut locals = [0, 1].map(|k| ranges[k].map(|t| self.carriers.local(pieces[k], t)));
        if locals.iter().any(|[from, to]| from == to) {
            let at = [0, 1].map(|k| 0.5 * (locals[k][0] + locals[k][1]));
            if !self.is_between_neighbors(pieces, at) {
                let carrier = self.carriers.controls(self.carriers.of_piece(pieces[0]));
                let point = bernstein::value(carrier, self.carriers.on_carrier(pieces[0], at[0]));
                self.push(Meeting { pieces, parameters: locals, at, point, is_certified });
            }
            return;
        }
        if locals[0][0] > locals[0][1] {
            locals.iter_mut().for_each(|range| range.reverse());
        }
        self.overlaps.push(Overlap { pieces, ranges: locals, is_certified });
    }
}

fn sorted([a, b]: [f64; 2]) -> [f64; 2] {
    [a.min(b), a.max(b)]
}
