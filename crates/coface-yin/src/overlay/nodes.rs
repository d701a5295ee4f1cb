//! Where curves meet: events along curves, brought together to nodes.

use super::boundaries::{Boundaries, Position};
use crate::curve::{distance, on_grid};
use crate::meetings::{Meeting, Overlap};
use crate::{Assumption, UncertifiedDecision};
use coface_algebra::UnionFind;
use rayon::prelude::*;
use std::cmp::Ordering;

/// No number. The arrays that hold it have one entry a cell, and an `Option` would double their size.
const NONE: u32 = u32::MAX;

/// A place where a curve comes to a node.
#[derive(Clone, Copy, Debug)]
pub(super) struct Event {
    pub(super) position: Position,
    /// The place where it was found; several of them are one node.
    pub(super) site: u32,
    /// The break that it is part of.
    pub(super) at: u32,
}

/// All events of a curve at a node that follow each other within the resolution.
#[derive(Clone, Copy, Debug)]
pub(super) struct Break {
    /// Where the curve comes to the node, and where it leaves it.
    pub(super) arrive: Position,
    pub(super) leave: Position,
    pub(super) node: u32,
}

/// The nodes, and the breaks of curves at them.
pub(super) struct Nodes {
    pub(super) points: Vec<[f64; 2]>,
    /// By position.
    pub(super) events: Vec<Event>,
    /// Along each curve, by the positions at which it leaves.
    pub(super) breaks: Vec<Break>,
    /// The first break of each curve, and the number of all.
    pub(super) starts: Vec<u32>,
    /// Where overlaps begin and end.
    pub(super) overlap_ends: Vec<[OverlapEnd; 2]>,
}

/// An end of an overlap.
#[derive(Clone, Copy, Debug)]
pub(super) struct OverlapEnd {
    pub(super) site: u32,
    /// On each of the two pieces.
    pub(super) positions: [Position; 2],
}

/// Sites and events on the way to nodes.
struct Gathering<'a> {
    boundaries: &'a Boundaries<'a>,
    points: Vec<[f64; 2]>,
    /// How far the places on curves were moved that became each of these points: to a knot within the resolution.
    shifts: Vec<f64>,
    events: Vec<Event>,
    classes: UnionFind,
}

/// What of the decisions on nodes is to be told.
pub(super) fn tell(
    boundaries: &Boundaries<'_>,
    assumption: Assumption,
    point: [f64; 2],
    parts: [(u32, [f64; 2]); 2],
) -> UncertifiedDecision {
    let pieces = parts.map(|(piece, range)| boundaries.source(piece, range));
    UncertifiedDecision { point, pieces, assumption, misplaced: 0.0 }
}

impl Nodes {
    pub(super) fn new(
        boundaries: &Boundaries<'_>,
        meetings: &[Meeting],
        overlaps: &[Overlap],
        report: &mut Vec<UncertifiedDecision>,
    ) -> Self {
        let mut all = Gathering {
            boundaries,
            points: Vec::with_capacity(meetings.len() + 2 * overlaps.len()),
            shifts: Vec::with_capacity(meetings.len() + 2 * overlaps.len()),
            events: Vec::with_capacity(2 * meetings.len() + 4 * overlaps.len()),
            classes: UnionFind::new(meetings.len() + 2 * overlaps.len()),
        };
        for meeting in meetings {
            if !meeting.is_certified {
                let parts = [0, 1].map(|side| (meeting.pieces[side], meeting.parameters[side]));
                report.push(tell(boundaries, Assumption::SamePoint, meeting.point, parts));
            }
            let sides = [0, 1].map(|side| (meeting.pieces[side], meeting.at[side]));
            all.add(sides, Some(meeting.point));
        }
        let mut overlap_ends = Vec::with_capacity(overlaps.len());
        for overlap in overlaps {
            let ends = [0, 1].map(|end| [0, 1].map(|side| (overlap.pieces[side], overlap.ranges[side][end])));
            let ends = ends.map(|sides| all.add(sides, None));
            if !overlap.is_certified {
                let place = all.points[ends[0].site as usize];
                let parts = [0, 1].map(|side| (overlap.pieces[side], overlap.ranges[side]));
                report.push(tell(boundaries, Assumption::SameArc, place, parts));
            }
            overlap_ends.push(ends);
        }
        all.unite_equal_points();
        let mut is_tiny = all.contract();
        // What one of two common arcs meets, the other meets there too; then events may be near others again.
        while all.carry_over(overlaps, &overlap_ends) {
            is_tiny = all.contract();
        }
        all.finish(&is_tiny, overlap_ends, report)
    }

    /// The breaks of a curve.
    pub(super) fn breaks_of(&self, curve: u32) -> std::ops::Range<u32> {
        self.starts[curve as usize]..self.starts[curve as usize + 1]
    }

    /// The break at the event of a site at a position.
    pub(super) fn break_at(&self, position: Position, site: u32) -> Option<u32> {
        let key = |event: &Event| compare(&event.position, &position).then(event.site.cmp(&site));
        self.events.binary_search_by(key).ok().map(|at| self.events[at].at)
    }
}

pub(super) fn compare(a: &Position, b: &Position) -> Ordering {
    a.piece.cmp(&b.piece).then(a.parameter.total_cmp(&b.parameter))
}

impl Gathering<'_> {
    /// A new site on two pieces.
    fn add(&mut self, sides: [(u32, f64); 2], point: Option<[f64; 2]>) -> OverlapEnd {
        let site = self.points.len() as u32;
        let positions = sides.map(|(piece, parameter)| self.settled(piece, parameter));
        // A knot keeps its point, and so does what both sides have at one place.
        let at_knot = positions.iter().find(|position| position.parameter == 0.0);
        let point = match (at_knot, point) {
            (Some(&knot), _) => self.boundaries.point(knot),
            (None, Some(point)) => point,
            (None, None) => self.boundaries.point(positions[0]),
        };
        let shift = |(&(piece, parameter), settled): (&(u32, f64), &Position)| {
            let own = self.boundaries.position(piece, parameter);
            if own == *settled { 0.0 } else { distance(self.boundaries.point(own), point) }
        };
        self.shifts.push(sides.iter().zip(&positions).map(shift).fold(0.0, f64::max));
        self.points.push(point);
        for position in positions {
            self.events.push(Event { position, site, at: NONE });
        }
        OverlapEnd { site, positions }
    }

    /// A position; the next knot where that is within the resolution.
    fn settled(&self, piece: u32, parameter: f64) -> Position {
        let own = self.boundaries.position(piece, parameter);
        let knots = [piece, self.boundaries.next(piece)].map(|piece| Position { piece, parameter: 0.0 });
        if own.parameter == 0.0 || self.boundaries.is_tiny(knots[0], own) {
            return if own.parameter == 0.0 { own } else { knots[0] };
        }
        if self.boundaries.is_tiny(own, knots[1]) { knots[1] } else { own }
    }

    fn unite_equal_points(&mut self) {
        let mut sorted: Vec<u32> = (0..self.points.len() as u32).collect();
        let key = |site: u32| self.points[site as usize];
        sorted.par_sort_unstable_by(|&a, &b| {
            let ([ax, ay], [bx, by]) = (key(a), key(b));
            ax.total_cmp(&bx).then(ay.total_cmp(&by)).then(a.cmp(&b))
        });
        for pair in sorted.windows(2) {
            if self.points[pair[0] as usize] == self.points[pair[1] as usize] {
                self.classes.unite(pair[0], pair[1]);
            }
        }
    }

    /// Unites the sites of events that follow each other within the resolution: whether that is so after each event.
    fn contract(&mut self) -> Vec<bool> {
        self.events.par_sort_unstable_by(|a, b| compare(&a.position, &b.position).then(a.site.cmp(&b.site)));
        self.events.dedup_by(|b, a| a.position == b.position && a.site == b.site);
        let boundaries = self.boundaries;
        let curve_of = |event: &Event| boundaries.curve_of(event.position.piece);
        let mut is_tiny = Vec::with_capacity(self.events.len());
        for own in self.events.chunk_by(|a, b| curve_of(a) == curve_of(b)) {
            let first = is_tiny.len();
            is_tiny.extend(own.windows(2).map(|pair| {
                pair[0].position == pair[1].position || boundaries.is_tiny(pair[0].position, pair[1].position)
            }));
            let [start, end] = [own[0].position, own[own.len() - 1].position];
            is_tiny.push(start != end && boundaries.is_tiny(end, start));
            for (at, _) in is_tiny[first..].iter().enumerate().filter(|(_, is_tiny)| **is_tiny) {
                self.classes.unite(own[at].site, own[(at + 1) % own.len()].site);
            }
        }
        is_tiny
    }

    /// Adds to each side of overlaps what the other has: whether there was anything to add.
    fn carry_over(&mut self, overlaps: &[Overlap], ends: &[[OverlapEnd; 2]]) -> bool {
        let mut added = Vec::new();
        for (overlap, ends) in overlaps.iter().zip(ends) {
            let ends = ends.map(|end| self.classes.find(end.site));
            let within = [0, 1].map(|side| {
                let [low, high] = rising(overlap.ranges[side]);
                let own = self.events.partition_point(|event| {
                    (event.position.piece, event.position.parameter) <= (overlap.pieces[side], low)
                });
                let own = self.events[own..].iter().take_while(|event| {
                    event.position.piece == overlap.pieces[side] && event.position.parameter < high
                });
                own.copied().collect::<Vec<_>>()
            });
            for side in 0..2 {
                for event in &within[side] {
                    let class = self.classes.find(event.site);
                    let is_there = ends.contains(&class)
                        || within[1 - side].iter().any(|other| self.classes.find(other.site) == class);
                    if !is_there {
                        let [from, to] = [overlap.ranges[side], overlap.ranges[1 - side]];
                        let way = event.position.parameter - from[0];
                        let [own, other] = [from[1] - from[0], to[1] - to[0]];
                        // On one carrier parameters go along together, exactly.
                        let way = match own.abs() == other.abs() {
                            true if own == other => way,
                            true => -way,
                            false => way * (other / own),
                        };
                        let parameter = on_grid((to[0] + way).clamp(0.0, 1.0));
                        let position = self.boundaries.position(overlap.pieces[1 - side], parameter);
                        added.push(Event { position, site: event.site, at: NONE });
                    }
                }
            }
        }
        let has_added = !added.is_empty();
        self.events.extend(added);
        has_added
    }

    fn finish(
        mut self,
        is_tiny: &[bool],
        overlap_ends: Vec<[OverlapEnd; 2]>,
        report: &mut Vec<UncertifiedDecision>,
    ) -> Nodes {
        let boundaries = self.boundaries;
        let mut breaks: Vec<Break> = Vec::new();
        let mut starts = vec![0];
        // Breaks have classes of sites for nodes at first; curves of their own have none.
        let mut next = 0;
        for curve in 0..boundaries.curve_count() as u32 {
            let pieces = boundaries.pieces(curve);
            let first = next;
            while self.events.get(next).is_some_and(|event| event.position.piece < pieces.end) {
                next += 1;
            }
            let (own, is_tiny) = (&mut self.events[first..next], &is_tiny[first..next]);
            if own.is_empty() {
                let knot = Position { piece: pieces.start, parameter: 0.0 };
                breaks.push(Break { arrive: knot, leave: knot, node: NONE });
            } else if is_tiny.iter().all(|&is_tiny| is_tiny) {
                let place = self.points[own[0].site as usize];
                let parts = [(pieces.start, [0.0, 1.0]), (pieces.end - 1, [0.0, 1.0])];
                report.push(tell(boundaries, Assumption::SmallCurve, place, parts));
            } else {
                let count = own.len();
                // The break that runs over the end of the curve comes first.
                let begin = if is_tiny[count - 1] {
                    1 + (0..count).rfind(|&at| !is_tiny[at]).expect("not all arcs are tiny")
                } else {
                    0
                };
                for at in (begin..count).chain(0..begin) {
                    let before = if at == 0 { count - 1 } else { at - 1 };
                    let event = &mut own[at];
                    if at == begin || !is_tiny[before] {
                        let node = self.classes.find(event.site);
                        breaks.push(Break { arrive: event.position, leave: event.position, node });
                    }
                    let number = breaks.len() - 1;
                    breaks[number].leave = event.position;
                    event.at = number as u32;
                }
            }
            starts.push(breaks.len() as u32);
        }
        // Nodes in the order in which curves come to them; the point of one is that of a knot, if there is one.
        let mut number_of = vec![NONE; self.points.len()];
        let mut points: Vec<[f64; 2]> = Vec::new();
        for own in &mut breaks {
            if own.node == NONE {
                own.node = points.len() as u32;
                points.push(boundaries.point(own.leave));
                continue;
            }
            let number = &mut number_of[own.node as usize];
            if *number == NONE {
                *number = points.len() as u32;
                points.push(self.points[own.node as usize]);
            }
            own.node = *number;
        }
        self.place(&number_of, &mut points, report);
        Nodes { points, events: self.events, breaks, starts, overlap_ends }
    }

    /// Gives nodes the points of knots where there are such, and tells which were brought together.
    fn place(&mut self, number_of: &[u32], points: &mut [[f64; 2]], report: &mut Vec<UncertifiedDecision>) {
        let mut is_at_knot = vec![false; points.len()];
        // How far the points are that became one.
        let mut apart = vec![0.0f64; points.len()];
        for event in &self.events {
            let node = number_of[self.classes.find(event.site) as usize];
            if node == NONE {
                continue;
            }
            let node = node as usize;
            if event.position.parameter == 0.0 && !is_at_knot[node] {
                is_at_knot[node] = true;
                points[node] = self.boundaries.point(event.position);
            }
        }
        for site in 0..self.points.len() as u32 {
            let node = number_of[self.classes.find(site) as usize];
            if node != NONE {
                let [a, b] = [points[node as usize], self.points[site as usize]];
                // Points that are equal up to rounding are told where they are not certain in themselves.
                let far = distance(a, b) + self.shifts[site as usize];
                if far > self.boundaries.rounding {
                    apart[node as usize] = apart[node as usize].max(far);
                }
            }
        }
        let mut merged: Vec<(u32, Position)> = Vec::new();
        for event in &self.events {
            let node = number_of[self.classes.find(event.site) as usize];
            if node != NONE && apart[node as usize] > 0.0 {
                merged.push((node, event.position));
            }
        }
        merged.sort_by(|a, b| a.0.cmp(&b.0).then(compare(&a.1, &b.1)));
        for own in merged.chunk_by(|a, b| a.0 == b.0) {
            let place = points[own[0].0 as usize];
            let parts = [own[0].1, own[own.len() - 1].1].map(|at| (at.piece, [at.parameter; 2]));
            // What goes to the point and from it is moved along with its end.
            let length: f64 = own.iter().map(|&(_, at)| self.boundaries.length_around(at)).sum();
            let misplaced = apart[own[0].0 as usize] * length;
            report.push(UncertifiedDecision {
                misplaced,
                ..tell(self.boundaries, Assumption::SamePoint, place, parts)
            });
        }
    }
}

pub(super) fn rising([a, b]: [f64; 2]) -> [f64; 2] {
    [a.min(b), a.max(b)]
}
