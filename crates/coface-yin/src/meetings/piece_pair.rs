//! All common points of two pieces.

use super::common_end::{has_no_other_point, has_no_point_between};
use super::contacts::{Cluster, Contact, clusters};
use super::cubic_pair::{cubics, meetings_of_cubics};
use super::isolation::places_on;
use super::line_contact::{LineContact, line_contact};
use super::meeting::Found;
use super::overlaps::{foot, opposite_on_arc, overlaps_of};
use super::polynomial::{is_apart, is_near, minus, size};
use super::roots::{IMAGE, Transversal, transversal_root};
use super::segments::{enclosure, meet_segments};
use super::side_by_side::{SideBySide, side_by_side};
use super::simple_fractions::{Fraction, meet_alone};
use super::{Meeting, Overlap, Pieces, Polynomial};
use coface_geometry::predicates::orientation;

/// Pairs of cells that are looked at for two parts before it is given up.
const MOST_CELLS: usize = 1 << 16;
/// Cells that are undecided are at most so long.
const CONTACT_LENGTH: f64 = 1.0 / (1u32 << 14) as f64;
/// Undecided arcs that are longer are an overlap, shorter ones a point.
const LONGEST_CONTACT: f64 = 1.0 / (1u32 << 11) as f64;

/// Places of crossings are known well up to here.
const WIDE_PLACE: f64 = 1e-11;

/// A part of a part of each of two pieces, and its parameters.
struct Cell {
    pieces: [Polynomial; 2],
    ranges: [[f64; 2]; 2],
}

/// A crossing that is proven.
#[derive(Clone, Copy)]
struct Root {
    at: [f64; 2],
    parameters: [[f64; 2]; 2],
    point: [f64; 2],
}

impl Root {
    /// Whether the boxes of two roots have a point in common.
    fn is_beside(&self, other: &Self) -> bool {
        (0..2).all(|k| {
            let [x, y] = [self.parameters[k], other.parameters[k]];
            x[0] <= y[1] && y[0] <= x[1]
        })
    }

    /// Whether this root is proven to be another one: it lies in the box in which there is no more than that.
    fn is_same(&self, other: &Self) -> bool {
        (0..2).all(|k| {
            let [low, high] = self.parameters[k];
            let radius = 0.5 * (high - low) * IMAGE;
            other.parameters[k][0] <= self.at[k] - radius && self.at[k] + radius <= other.parameters[k][1]
        })
    }
}

/// Meets pieces, with storage that is used again.
pub(super) struct PairSolver<'a> {
    pieces: &'a Pieces<'a>,
    stack: Vec<Cell>,
    roots: Vec<Root>,
    contacts: Vec<Contact>,
    /// Whether cells were left over.
    is_exhausted: bool,
}

impl<'a> PairSolver<'a> {
    pub(super) fn new(pieces: &'a Pieces<'a>) -> Self {
        Self { pieces, stack: Vec::new(), roots: Vec::new(), contacts: Vec::new(), is_exhausted: false }
    }

    /// Adds the meetings and overlaps of two pieces, or of a piece with itself, from the pairs of their parts that come near each
    /// other.
    pub(super) fn meet(&mut self, pair: [u32; 2], parts: &[[u32; 2]], found: &mut Found) {
        let [p, q] = pair.map(|piece| piece as usize);
        let pieces = self.pieces;
        if p != q && pieces.is_straight(p) && pieces.is_straight(q) {
            meet_segments(pieces, pair, found);
            return;
        }
        let overlaps = if p == q { Vec::new() } else { overlaps_of(pieces, pair) };
        if overlaps.iter().any(|overlap| !overlap.is_certified)
            && let Some(exact) = meetings_of_cubics(pieces, pair)
        {
            found.points.extend(exact);
            return;
        }
        self.roots.clear();
        self.contacts.clear();
        self.is_exhausted = false;
        for &own in parts {
            let own = own.map(|part| part as usize);
            if !self.is_monotone_through(own) && !overlaps.iter().any(|overlap| self.follows(overlap, own)) {
                self.meet_parts(own);
            }
        }
        if self.is_exhausted
            && let Some(exact) = meetings_of_cubics(pieces, pair)
        {
            found.points.extend(exact);
            return;
        }
        self.collect(pair, found);
        found.overlaps.extend(overlaps);
        if self.is_exhausted {
            found.exhausted.push(pair);
        }
    }

    /// Whether two parts follow each other on a curve, and one coordinate rises or falls all along: then they have the point between
    /// them in common alone.
    fn is_monotone_through(&self, [i, j]: [usize; 2]) -> bool {
        let [a, b] = [i, j].map(|part| self.pieces.parts()[part]);
        // Whether the second is run through backward by who goes on from the first.
        let is_turned = if a.piece == b.piece {
            (a.range[1] == b.range[0] || b.range[1] == a.range[0]).then_some(false)
        } else {
            let mut joints = self.pieces.joints([a.piece, b.piece]);
            let joint = joints.find(|ends| (0..2).all(|k| [a, b][k].range[ends[k]] == ends[k] as f64));
            joint.map(|[end, other]| end == other)
        };
        let Some(is_turned) = is_turned else { return false };
        let [c, mut d] = [i, j].map(|part| self.pieces.part_polynomial(part).chord());
        if is_turned {
            d = d.map(|x| -x);
        }
        // Far above what rounding can do to a coordinate that hardly changes.
        let least = 16.0 * self.pieces.frame.resolution;
        (0..2).any(|k| c[k] * d[k] > 0.0 && c[k].abs() > least && d[k].abs() > least)
    }

    /// Whether two parts have a part of an overlap in common, or the point next to one.
    fn follows(&self, overlap: &Overlap, parts: [usize; 2]) -> bool {
        let [a, b] = parts.map(|part| self.pieces.parts()[part].range);
        let of_a = overlap.ranges[0];
        let slack = 1e-6;
        let [low, high] = [a[0].max(of_a[0]), a[1].min(of_a[1])];
        if low > high + slack {
            return false;
        }
        let own = overlap.pieces.map(|piece| self.pieces.polynomial(piece as usize));
        let tolerance = self.pieces.frame.resolution;
        let ends = [low, high].map(|t| opposite_on_arc([&own[0], &own[1]], overlap.ranges, t, tolerance));
        ends[0].min(ends[1]) <= b[1] + slack && b[0] <= ends[0].max(ends[1]) + slack
    }

    fn meet_parts(&mut self, parts: [usize; 2]) {
        let resolution = self.pieces.frame.resolution;
        self.stack.clear();
        self.stack.push(Cell {
            pieces: parts.map(|part| self.pieces.part_polynomial(part)),
            ranges: parts.map(|part| self.pieces.parts()[part].range),
        });
        let [p, q] = parts.map(|part| self.pieces.parts()[part].piece as usize);
        let is_neighbor = p == q || self.pieces.joints([p, q].map(|piece| piece as u32)).next().is_some();
        let mut count = 0;
        while let Some(Cell { pieces: [a, b], ranges }) = self.stack.pop() {
            count += 1;
            if is_apart(a.controls(), b.controls(), resolution) {
                continue;
            }
            if count > MOST_CELLS {
                self.is_exhausted = true;
                return;
            }
            if a.is_transversal(&b) {
                match transversal_root(&a, &b, resolution) {
                    Transversal::Root { at, radii } => {
                        self.add_root(&a, ranges, at, radii);
                        continue;
                    }
                    Transversal::Nothing => continue,
                    Transversal::Unknown => {}
                }
            } else {
                match side_by_side(&a, &b, self.pieces.frame) {
                    SideBySide::Apart => continue,
                    // What is next to a common end is told from it when it hangs together with it.
                    SideBySide::Near(near) if !is_neighbor => {
                        let ranges =
                            [0, 1].map(|k| near[k].map(|t| ranges[k][0] + t * (ranges[k][1] - ranges[k][0])));
                        self.contacts.push(Contact { ranges });
                        continue;
                    }
                    SideBySide::Near(_) | SideBySide::Unclear => {}
                }
            }
            let lengths = [size(a.chord()), size(b.chord())];
            let bends = [a.largest_second_derivative(), b.largest_second_derivative()];
            // The distance of a piece from its chord is at most an eighth of the second derivative.
            let is_undecided = |k: usize| {
                lengths[k] <= resolution || (bends[k] <= 4.0 * resolution && lengths[k] <= CONTACT_LENGTH)
            };
            let is_narrow = ranges.iter().any(|range| range[1] - range[0] < 1e-15);
            if is_narrow || (is_undecided(0) && is_undecided(1)) {
                self.contacts.push(Contact { ranges });
                continue;
            }
            // The longer one is cut, of two that are alike the one that bends more.
            let by_length = lengths[0] > 2.0 * lengths[1] || lengths[1] > 2.0 * lengths[0];
            let first = if by_length { lengths[0] > lengths[1] } else { bends[0] >= bends[1] };
            let first = (first && !is_undecided(0)) || is_undecided(1);
            let [mut of_first, mut of_second] = [ranges; 2];
            let cut = usize::from(!first);
            let middle = 0.5 * (ranges[cut][0] + ranges[cut][1]);
            of_first[cut][1] = middle;
            of_second[cut][0] = middle;
            let halves = if first { a.split(0.5) } else { b.split(0.5) };
            let with = |half: Polynomial| if first { [half, b] } else { [a, half] };
            self.stack.push(Cell { pieces: with(halves[1]), ranges: of_second });
            self.stack.push(Cell { pieces: with(halves[0]), ranges: of_first });
        }
    }

    /// Adds a root of two cells in parameters of the pieces.
    fn add_root(&mut self, a: &Polynomial, ranges: [[f64; 2]; 2], at: [f64; 2], radii: [f64; 2]) {
        let in_piece = |k: usize, t: f64| ranges[k][0] + t * (ranges[k][1] - ranges[k][0]);
        let parameters = [0, 1].map(|k| {
            let slack = 2.0 * f64::EPSILON;
            [in_piece(k, at[k] - radii[k]) - slack, in_piece(k, at[k] + radii[k]) + slack]
        });
        let root = Root { at: [0, 1].map(|k| in_piece(k, at[k])), parameters, point: a.at(at[0]) };
        self.roots.push(root);
    }

    /// The meetings of two pieces from their roots and undecided cells.
    fn collect(&mut self, pair: [u32; 2], found: &mut Found) {
        if self.roots.is_empty() && self.contacts.is_empty() {
            return;
        }
        let [p, q] = pair.map(|piece| self.pieces.polynomial(piece as usize));
        let resolution = self.pieces.frame.resolution;
        let is_wide = |root: &Root| root.parameters.iter().any(|[low, high]| high - low > WIDE_PLACE);
        if (!self.contacts.is_empty() || self.roots.iter().any(is_wide))
            && let Some(exact) = meetings_of_cubics(self.pieces, pair)
        {
            found.points.extend(exact);
            return;
        }
        let mut groups = clusters(&mut self.contacts, &p, &q);
        // What is proven next to what is undecided belongs to it.
        let mut roots = std::mem::take(&mut self.roots);
        for group in &mut groups {
            let wide = group.ranges.map(|range| {
                let length = range[1] - range[0];
                [range[0] - length, range[1] + length]
            });
            roots.retain(|root| {
                let is_in = (0..2).all(|k| wide[k][0] <= root.at[k] && root.at[k] <= wide[k][1]);
                if is_in {
                    for k in 0..2 {
                        group.ranges[k][0] = group.ranges[k][0].min(root.parameters[k][0]);
                        group.ranges[k][1] = group.ranges[k][1].max(root.parameters[k][1]);
                    }
                }
                !is_in
            });
        }
        roots.sort_by(|x, y| x.at[0].total_cmp(&y.at[0]).then(x.at[1].total_cmp(&y.at[1])));
        let mut kept: Vec<(Root, bool)> = Vec::with_capacity(roots.len());
        for root in &roots {
            let same = kept.iter_mut().rev().find(|(known, _)| {
                known.is_beside(root)
                    || is_near(known.point, root.point, 2.0 * resolution)
                        && self.is_short(&p, known.at[0], root.at[0])
                        && self.is_short(&q, known.at[1], root.at[1])
            });
            match same {
                // Found from two sides of a cut, or two that are not to be told apart.
                Some((known, is_one)) => {
                    *is_one &= known.is_same(root) || root.is_same(known);
                    for k in 0..2 {
                        known.parameters[k][0] = known.parameters[k][0].min(root.parameters[k][0]);
                        known.parameters[k][1] = known.parameters[k][1].max(root.parameters[k][1]);
                    }
                }
                None => kept.push((*root, true)),
            }
        }
        self.roots = roots;
        for (root, is_one) in kept {
            if self.is_shared(pair, root.at.map(|t| [t; 2])) {
                continue;
            }
            let mut meeting = Meeting {
                pieces: pair,
                parameters: root.parameters.map(|range| range.map(|t| t.clamp(0.0, 1.0))),
                at: root.at.map(|t| t.clamp(0.0, 1.0)),
                point: self.pieces.frame.to_world(root.point),
                is_certified: is_one,
            };
            let mut parameters = root.parameters;
            if is_one && let Some(exact) = self.polished(pair, &root) {
                (meeting, parameters) = (exact, exact.parameters);
            }
            self.snap(&mut meeting, parameters);
            found.points.push(meeting);
        }
        for group in groups {
            if self.is_shared(pair, group.ranges) || self.is_beside_shared_end(pair, group.ranges) {
                continue;
            }
            if let Some(crossings) = self.crossings(pair, &group) {
                found.points.extend(crossings);
                continue;
            }
            let at = group.nearest(&p, &q);
            // Long ones may be common arcs up to rounding.
            if group.length <= LONGEST_CONTACT
                && let Some(exact) = self.exact(pair, &group, at)
            {
                found.points.extend(exact);
                continue;
            }
            if group.length > LONGEST_CONTACT {
                let [of_p, mut of_q] = group.ranges;
                if group.is_against {
                    of_q.reverse();
                }
                let [from, to] = [0, 1].map(|end| opposite(&p, &q, [of_p[end], of_q[end]]));
                let ranges = [0, 1].map(|k| [from[k], to[k]]);
                found.overlaps.push(Overlap { pieces: pair, ranges, is_certified: false });
                continue;
            }
            let mut meeting = Meeting {
                pieces: pair,
                parameters: group.ranges,
                at,
                point: self.pieces.frame.to_world(p.at(at[0])),
                is_certified: false,
            };
            self.snap_contact(&mut meeting, &p, &q);
            found.points.push(meeting);
        }
    }

    /// The one meeting of a cluster of two cubic pieces in an end of both, where it is proven that there is no other.
    fn common_end(&self, pair: [u32; 2], group: &Cluster) -> Option<Meeting> {
        let [a, b] = [0, 1].map(|k| {
            let mut controls = <[[f64; 2]; 4]>::try_from(self.pieces.given(pair[k] as usize)).ok()?;
            let [low, high] = group.ranges[k];
            let end = match (low <= 0.0, high >= 1.0) {
                (true, false) => 0.0,
                (false, true) => 1.0,
                _ => return None,
            };
            if end == 1.0 {
                controls.reverse();
            }
            Some((controls, end, high - low))
        });
        let ((a, at_a, reach), (b, at_b, _)) = (a?, b?);
        (a[0] == b[0] && has_no_other_point(&a, &b, reach)).then(|| Meeting {
            pieces: pair,
            parameters: [[at_a; 2], [at_b; 2]],
            at: [at_a, at_b],
            point: a[0],
            is_certified: true,
        })
    }

    /// Whether two cubic pieces are neighbors that are proven to have nothing in common in a cluster: they leave their common end side
    /// by side, within the resolution of each other.
    fn is_beside_shared_end(&self, pair: [u32; 2], ranges: [[f64; 2]; 2]) -> bool {
        let [p, q] = pair.map(|piece| piece as usize);
        if p == q {
            return false;
        }
        let cubic = |piece: usize| <[[f64; 2]; 4]>::try_from(self.pieces.given(piece)).ok();
        let (Some(a), Some(b)) = (cubic(p), cubic(q)) else { return false };
        let reversed = |mut controls: [[f64; 2]; 4]| {
            controls.reverse();
            controls
        };
        // From the common end on, more than rounding can take away.
        let [low, high] = ranges[0];
        let wide = |low: f64, high: f64| [low - f64::EPSILON, high + f64::EPSILON];
        self.pieces.joints(pair).any(|[end, other]| {
            let b = if other == 1 { reversed(b) } else { b };
            if end == 1 {
                has_no_point_between(&reversed(a), &b, wide(1.0 - high, 1.0 - low))
            } else {
                has_no_point_between(&a, &b, wide(low, high))
            }
        })
    }

    /// The meeting at a root of two cubic pieces whose place is not known well, since they cross at a small angle: where exact arithmetic has
    /// it, so that it is found in one place whatever else is there.
    fn polished(&self, pair: [u32; 2], root: &Root) -> Option<Meeting> {
        let cubics = self.cubics(pair)?;
        if root.parameters.iter().all(|[low, high]| high - low <= WIDE_PLACE) {
            return None;
        }
        let own = (0..2).find(|&k| root.parameters[1 - k][0] > 0.0 && root.parameters[1 - k][1] < 1.0)?;
        let range = root.parameters[own].map(|t| t.clamp(0.0, 1.0));
        match places_on(&cubics[own], &cubics[1 - own], range, [false; 2])?[..] {
            [place] => self.crossing(pair, root.parameters[1 - own], own, place)?,
            _ => None,
        }
    }

    /// The control points of two different pieces if they are cubics that are not straight, and the resolution is fine.
    fn cubics(&self, pair: [u32; 2]) -> Option<[[[f64; 2]; 4]; 2]> {
        self.pieces.frame.is_fine.then(|| cubics(self.pieces, pair)).flatten()
    }

    /// The meetings of two cubic pieces in a cluster, where exact arithmetic tells them apart: those that cross, however near they are to
    /// each other elsewhere, and a common end.
    fn crossings(&self, pair: [u32; 2], group: &Cluster) -> Option<Vec<Meeting>> {
        let cubics = self.cubics(pair)?;
        let ranges = group.ranges.map(|range| range.map(|t| t.clamp(0.0, 1.0)));
        let reaches = |k: usize, end: usize| ranges[k][end] == end as f64;
        let common = [[0, 0], [0, 1], [1, 0], [1, 1]].into_iter().find(|&[end, other]| {
            let is_one = cubics[0][3 * end] == cubics[1][3 * other];
            is_one && reaches(0, end) && reaches(1, other)
        });
        let mut found = Vec::new();
        if let Some([end, other]) = common {
            // Both from the common end on.
            let from = |mut controls: [[f64; 2]; 4], end: usize| {
                if end == 1 {
                    controls.reverse();
                }
                controls
            };
            let reach = if end == 1 { 1.0 - ranges[0][0] } else { ranges[0][1] };
            let [a, b] = [from(cubics[0], end), from(cubics[1], other)];
            let point = self.pieces.ends(pair[0] as usize)[end];
            let mut is_certified = true;
            let mut last = end as f64;
            for place in places_on(&a, &b, [0.0, reach.next_up()], [true, false])? {
                let place = if end == 1 { [1.0 - place[1], 1.0 - place[0]] } else { place };
                // Arcs that come together so near to their end that rounding may do that are no more than the end.
                if !self.is_clear_between(pair, group, 0, [last, place[0]]) {
                    is_certified = false;
                    continue;
                }
                last = place[0];
                found.extend(self.crossing(pair, group.ranges[1], 0, place)?);
            }
            let is_joint = self.pieces.joints(pair).any(|ends| ends == [end, other]);
            if !is_joint {
                let at = [end, other].map(|end| end as f64);
                let parameters = at.map(|t| [t; 2]);
                found.push(Meeting { pieces: pair, parameters, at, point, is_certified });
            }
            return Some(found);
        }
        // The one whose ends are elsewhere is that which the other is on.
        let is_inner = |k: usize| !reaches(k, 0) && !reaches(k, 1);
        let own = (0..2).find(|&k| is_inner(1 - k)).unwrap_or(0);
        let [low, high] = ranges[own];
        let wide = [low - (high - low), high + (high - low)].map(|t| t.clamp(0.0, 1.0));
        let mut places = places_on(&cubics[own], &cubics[1 - own], wide, [false; 2])?;
        let all = places.len();
        places.retain(|place| low <= place[0] && place[1] <= high);
        // Next to a common end that the cluster does not reach to they come together as near as they like.
        let has_common_end = [0, 3].iter().any(|&i| [0, 3].iter().any(|&j| cubics[0][i] == cubics[1][j]));
        let is_clear = match places[..] {
            [] => {
                let at = group.nearest(
                    &self.pieces.polynomial(pair[0] as usize),
                    &self.pieces.polynomial(pair[1] as usize),
                );
                // Or next to a crossing, which is found where it is.
                has_common_end || all > 0 || self.gap(pair, group, 0, at[0]) > self.pieces.frame.finest
            }
            _ => places
                .windows(2)
                .all(|pair_of| self.is_clear_between(pair, group, own, [pair_of[0][1], pair_of[1][0]])),
        };
        if !is_clear {
            return None;
        }
        for place in places {
            found.extend(self.crossing(pair, group.ranges[1 - own], own, place)?);
        }
        Some(found)
    }

    /// Whether two pieces in a cluster are farther apart between two parameters of one of them than rounding of results can take away.
    fn is_clear_between(&self, pair: [u32; 2], group: &Cluster, own: usize, ends: [f64; 2]) -> bool {
        self.gap(pair, group, own, 0.5 * (ends[0] + ends[1])) > self.pieces.frame.finest
    }

    /// How far the point at a parameter of one of two pieces is from the other.
    fn gap(&self, pair: [u32; 2], group: &Cluster, own: usize, t: f64) -> f64 {
        let [p, q] = [own, 1 - own].map(|k| self.pieces.polynomial(pair[k] as usize));
        let [of_own, mut of_other] = [group.ranges[own], group.ranges[1 - own]];
        if group.is_against {
            of_other.reverse();
        }
        let part = if of_own[0] < of_own[1] { (t - of_own[0]) / (of_own[1] - of_own[0]) } else { 0.5 };
        let point = p.at(t);
        let s = foot(&q, point, of_other[0] + part * (of_other[1] - of_other[0]));
        let [x, y] = minus(q.at(s), point);
        x.hypot(y)
    }

    /// The meeting at a place of one of two pieces that is known to be on the other or its continuation, where the one that belongs to a
    /// range of the other is; nothing within if it is on the continuation, and nothing at all if that is not clear.
    fn crossing(
        &self,
        pair: [u32; 2],
        range: [f64; 2],
        own: usize,
        place: [f64; 2],
    ) -> Option<Option<Meeting>> {
        /// How well the parameter on the other piece is known at least.
        const DOUBT: f64 = 1e-11;
        let [p, q] = [own, 1 - own].map(|k| self.pieces.polynomial(pair[k] as usize));
        let t = 0.5 * (place[0] + place[1]);
        let point = p.at(t);
        let [low, high] = range;
        let s = foot(&q, point, 0.5 * (low + high));
        let slack = 0.25 * (high - low) + DOUBT;
        let is_clear = low - slack <= s
            && s <= high + slack
            && s.abs() > DOUBT
            && (1.0 - s).abs() > DOUBT
            && is_near(q.at(s), point, self.pieces.frame.resolution / 8.0);
        if !is_clear {
            return None;
        }
        if !(0.0..=1.0).contains(&s) {
            return Some(None);
        }
        let mut at = [t; 2];
        let mut parameters = [place; 2];
        at[1 - own] = s;
        parameters[1 - own] = enclosure(self.pieces, pair[1 - own] as usize, s);
        let end = (0..2).find(|&end| t == end as f64);
        let point = end.map_or_else(
            || self.pieces.frame.to_world(point),
            |end| self.pieces.ends(pair[own] as usize)[end],
        );
        Some(Some(Meeting { pieces: pair, parameters, at, point, is_certified: true }))
    }

    /// The one meeting of a cluster of two cubic pieces at parameters that are simple fractions, where it is proven that there is no
    /// other.
    fn simple_touching(&self, pair: [u32; 2], group: &Cluster, at: [f64; 2]) -> Option<Meeting> {
        let fraction = |k: usize| {
            let [low, high] = group.ranges[k];
            let found = Fraction::near(at[k], high - low)?;
            // What reaches to an end is common in that end.
            let ends = [(low <= 0.0).then_some(0.0), (high >= 1.0).then_some(1.0)];
            ends.into_iter().flatten().all(|end| found.value() == end).then_some(found)
        };
        let found = [fraction(0)?, fraction(1)?];
        let given = pair.map(|piece| self.pieces.given(piece as usize));
        let cubic = |k: usize| <[[f64; 2]; 4]>::try_from(given[k]).ok();
        let values = found.map(Fraction::value);
        let reach = group.ranges[0].map(|t| (t - values[0]).abs());
        // More than rounding can take away.
        let reach = 1.001 * reach[0].max(reach[1]) + 1e-15;
        meet_alone([&cubic(0)?, &cubic(1)?], found, reach).then(|| {
            let is_end = |t: f64| t == 0.0 || t == 1.0;
            let point = match values.iter().position(|&t| is_end(t)) {
                Some(k) => self.pieces.ends(pair[k] as usize)[values[k] as usize],
                None => {
                    let own = self.pieces.polynomial(pair[0] as usize);
                    self.pieces.frame.to_world(own.at(values[0]))
                }
            };
            let parameters = values
                .map(|t| if is_end(t) { [t; 2] } else { [t.next_down().max(0.0), t.next_up().min(1.0)] });
            Meeting { pieces: pair, parameters, at: values, point, is_certified: true }
        })
    }

    /// The meetings of a cluster, where exact arithmetic tells them.
    fn exact(&self, pair: [u32; 2], group: &Cluster, at: [f64; 2]) -> Option<Vec<Meeting>> {
        let Some(straight) = (0..2).find(|&k| self.pieces.is_straight(pair[k] as usize)) else {
            let proven = self.common_end(pair, group).or_else(|| self.simple_touching(pair, group, at));
            return proven.map(|meeting| vec![meeting]);
        };
        let curved = 1 - straight;
        let frame = self.pieces.frame;
        let ends = pair.map(|piece| self.pieces.ends(piece as usize));
        let range = group.ranges[curved].map(|t| t.clamp(0.0, 1.0));
        let given = self.pieces.given(pair[curved] as usize);
        let least = frame.world_length(frame.finest);
        let points = match line_contact(given, ends[straight], range, at[curved], least) {
            LineContact::Nothing => return Some(Vec::new()),
            LineContact::Points(points) => points,
            LineContact::Unclear => return None,
        };
        let [own, line] = [curved, straight].map(|k| self.pieces.polynomial(pair[k] as usize));
        let is_near_end = |range: [f64; 2]| range[0] <= 0.0 || range[1] >= 1.0;
        // Near an end of one of them the one common point has to be that end.
        if is_near_end(group.ranges[straight]) || is_near_end(range) {
            let [[t, _]] = points[..] else { return None };
            if t != 0.0 && t != 1.0 {
                return None;
            }
            let point = ends[curved][t as usize];
            let mut at = [t; 2];
            if is_near_end(group.ranges[straight]) {
                let end = if group.ranges[straight][0] <= 0.0 { 0.0 } else { 1.0 };
                if ends[straight][end as usize] != point {
                    return None;
                }
                at[straight] = end;
            } else {
                at[straight] = foot(&line, own.at(t), 0.5).clamp(f64::MIN_POSITIVE, 1.0 - f64::EPSILON / 2.0);
            }
            let parameters = [0, 1].map(|k| match at[k] {
                end if end == 0.0 || end == 1.0 => [end; 2],
                inner => enclosure(self.pieces, pair[k] as usize, inner),
            });
            return Some(vec![Meeting { pieces: pair, parameters, at, point, is_certified: true }]);
        }
        if let [first, .., last] = points[..]
            && is_near(own.at(first[0]), own.at(last[0]), 16.0 * frame.resolution)
        {
            return None;
        }
        let meeting = |between: [f64; 2]| {
            let t = 0.5 * (between[0] + between[1]);
            let point = own.at(t);
            let s = foot(&line, point, 0.5);
            let (mut at, mut parameters) = ([t; 2], [between; 2]);
            at[straight] = s;
            parameters[straight] = enclosure(self.pieces, pair[straight] as usize, s);
            Meeting { pieces: pair, parameters, at, point: frame.to_world(point), is_certified: true }
        };
        Some(points.into_iter().map(meeting).collect())
    }

    /// Whether the way between two parameters of a piece stays within the resolution.
    fn is_short(&self, piece: &Polynomial, s: f64, t: f64) -> bool {
        let [low, high] = [s.min(t).clamp(0.0, 1.0), s.max(t).clamp(0.0, 1.0)];
        if low == high {
            return true;
        }
        let [least, most] = piece.part([low, high]).bounds();
        (0..2).all(|k| most[k] - least[k] <= 4.0 * self.pieces.frame.resolution)
    }

    /// Whether what two pieces have in common is the point that they share as neighbors, or one point of one piece.
    fn is_shared(&self, pair: [u32; 2], ranges: [[f64; 2]; 2]) -> bool {
        let [p, q] = pair.map(|piece| piece as usize);
        let [a, b] = [self.pieces.polynomial(p), self.pieces.polynomial(q)];
        let reaches = |piece: &Polynomial, range: [f64; 2], end: usize| match end {
            0 => self.is_short(piece, 0.0, range[0]),
            _ => self.is_short(piece, range[1], 1.0),
        };
        if p == q && ranges[0][0] <= ranges[1][1] && ranges[1][0] <= ranges[0][1] {
            return true;
        }
        if p == q
            && (self.is_short(&a, ranges[0][1], ranges[1][0])
                || self.is_short(&a, ranges[1][1], ranges[0][0]))
        {
            return true;
        }
        self.pieces
            .joints(pair)
            .any(|[end, other]| reaches(&a, ranges[0], end) && reaches(&b, ranges[1], other))
    }

    /// Moves a crossing to an end of a piece that is within the resolution. It stays certified when the ends of both pieces are there
    /// and equal, and when the end of one is on the other, which is a segment.
    fn snap(&self, meeting: &mut Meeting, parameters: [[f64; 2]; 2]) {
        let ends: [Option<usize>; 2] = [0, 1].map(|k| {
            let piece = self.pieces.polynomial(meeting.pieces[k] as usize);
            let end = usize::from(meeting.at[k] > 0.5);
            self.is_within(&piece, meeting.at[k], end as f64).then_some(end)
        });
        let points = [0, 1].map(|k| ends[k].map(|end| self.pieces.ends(meeting.pieces[k] as usize)[end]));
        for (k, end) in ends.into_iter().enumerate().filter_map(|(k, end)| Some((k, end? as f64))) {
            meeting.at[k] = end;
            meeting.parameters[k] = [end; 2];
        }
        match points {
            [None, None] => {
                // Within the enclosure of a root that is inside there is no end.
                meeting.is_certified &= parameters.iter().all(|range| range[0] >= 0.0 && range[1] <= 1.0);
            }
            [Some(a), Some(b)] => {
                meeting.is_certified &= a == b;
                meeting.point = a;
            }
            [Some(end), None] | [None, Some(end)] => {
                let other = meeting.pieces[usize::from(points[0].is_some())] as usize;
                let [a, b] = self.pieces.ends(other);
                meeting.is_certified &= self.pieces.is_straight(other) && orientation(a, b, end).is_eq();
                meeting.point = end;
            }
        }
    }

    /// Whether a point of a piece is within the resolution of an end, and the way to it too.
    fn is_within(&self, piece: &Polynomial, t: f64, end: f64) -> bool {
        t == end
            || (is_near(piece.at(t), piece.at(end), self.pieces.frame.resolution)
                && self.is_short(piece, t, end))
    }

    /// Puts a contact at ends of pieces that its ranges reach to.
    fn snap_contact(&self, meeting: &mut Meeting, p: &Polynomial, q: &Polynomial) {
        let end_in = |range: [f64; 2]| {
            if range[0] <= 0.0 {
                Some(0.0)
            } else if range[1] >= 1.0 {
                Some(1.0)
            } else {
                None
            }
        };
        let resolution = self.pieces.frame.resolution;
        let ends = meeting.parameters.map(end_in);
        let end_point = |k: usize, end: f64| self.pieces.ends(meeting.pieces[k] as usize)[end as usize];
        match ends {
            [Some(s), Some(t)] if is_near(p.at(s), q.at(t), 2.0 * resolution) => {
                meeting.at = [s, t];
                meeting.point = end_point(0, s);
            }
            [Some(s), _] => {
                meeting.at = [s, foot(q, p.at(s), meeting.at[1]).clamp(0.0, 1.0)];
                meeting.point = end_point(0, s);
            }
            [None, Some(t)] => {
                meeting.at = [foot(p, q.at(t), meeting.at[0]).clamp(0.0, 1.0), t];
                meeting.point = end_point(1, t);
            }
            [None, None] => {}
        }
    }
}

/// The parameters nearest to given ones at which pieces are opposite each other.
fn opposite(p: &Polynomial, q: &Polynomial, [t, s]: [f64; 2]) -> [f64; 2] {
    let other = foot(q, p.at(t.clamp(0.0, 1.0)), s);
    if (0.0..=1.0).contains(&other) {
        return [t.clamp(0.0, 1.0), other];
    }
    let end = other.clamp(0.0, 1.0);
    [foot(p, q.at(end), t).clamp(0.0, 1.0), end]
}
