//! Where boundaries come near each other.

use super::{OnContact, TrackingOptions};
use crate::Curve;
use crate::curve::bernstein::{control_box, value};
use crate::curve::{distance, nearest_on};
use coface_geometry::predicates::orientation;
use coface_geometry::{AxisBox, BoxTree};
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

/// So often the nearest points of two pieces are looked for in turns.
const TURNS: usize = 100;

/// Two places of one boundary are apart only if the way between them along it is longer than so many times their distance.
const WAY: f64 = 3.0;

/// Two places of boundaries that are nearest to each other among those around them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Contact {
    pub(super) curves: [usize; 2],
    /// The pieces of these curves.
    pub(super) pieces: [usize; 2],
    pub(super) points: [[f64; 2]; 2],
}

impl Contact {
    pub(super) fn distance(&self) -> f64 {
        distance(self.points[0], self.points[1])
    }

    /// The point halfway between the two places.
    pub(super) fn place(&self) -> [f64; 2] {
        let [p, q] = self.points;
        [0, 1].map(|axis| 0.5 * p[axis] + 0.5 * q[axis])
    }
}

/// The contacts that are looked at: all, or where contacts are kept those that are not near a place where one was kept before. `kept` are these
/// places as they have moved.
pub(super) fn fresh<C: Clone>(
    options: &TrackingOptions,
    within: f64,
    contacts: &[C],
    place: impl Fn(&C) -> [f64; 2],
    kept: impl FnOnce() -> Vec<[f64; 2]>,
) -> Vec<C> {
    if options.on_contact != Some(OnContact::Keep) {
        return contacts.to_vec();
    }
    let (near, kept) = (2.0 * options.spacing.max(within), kept());
    let is_known = |contact: &C| kept.iter().any(|&known| distance(known, place(contact)) < near);
    contacts.iter().filter(|contact| !is_known(contact)).cloned().collect()
}

/// A pair of pieces that are near each other.
#[derive(Clone, Copy)]
struct Near {
    distance: f64,
    points: [[f64; 2]; 2],
}

/// The pieces of closed curves, one after the other.
struct Pieces<'a> {
    curves: &'a [&'a Curve<'static>],
    /// The first piece of each curve, and the number of all.
    first: Vec<usize>,
    /// For each piece the length of the polygon of its curve before it.
    way: Vec<f64>,
    /// The length of the polygon of each curve.
    around: Vec<f64>,
}

impl<'a> Pieces<'a> {
    fn new(curves: &'a [&'a Curve<'static>]) -> Self {
        let (mut first, mut way, mut around) = (vec![0], Vec::new(), Vec::new());
        for curve in curves {
            let mut length = 0.0;
            for piece in 0..curve.piece_count() {
                way.push(length);
                length += distance(curve.knot_point(piece), curve.knot_point(piece + 1));
            }
            around.push(length);
            first.push(way.len());
        }
        Self { curves, first, way, around }
    }

    fn curve_of(&self, piece: u32) -> usize {
        self.first.partition_point(|&first| first <= piece as usize) - 1
    }

    fn controls(&self, piece: u32) -> &[[f64; 2]] {
        let curve = self.curve_of(piece);
        self.curves[curve].piece(piece as usize - self.first[curve])
    }

    /// How many knots lie between two pieces of one curve, on the shorter way; `None` for pieces of different curves.
    fn knots_between(&self, [a, b]: [u32; 2]) -> Option<usize> {
        let curve = self.curve_of(a);
        if curve != self.curve_of(b) {
            return None;
        }
        let steps = a.abs_diff(b) as usize;
        Some(steps.min(self.first[curve + 1] - self.first[curve] - steps))
    }

    /// A piece and its neighbors on its curve.
    fn around(&self, piece: u32) -> [u32; 3] {
        let curve = self.curve_of(piece);
        let [first, end] = [self.first[curve], self.first[curve + 1]].map(|piece| piece as u32);
        let before = if piece == first { end - 1 } else { piece - 1 };
        [before, piece, if piece + 1 == end { first } else { piece + 1 }]
    }

    /// Whether the way along the curve between places on two pieces is much longer than their distance.
    fn are_apart(&self, [a, b]: [u32; 2], near: &Near) -> bool {
        let curve = self.curve_of(a);
        if curve != self.curve_of(b) {
            return true;
        }
        let place =
            |piece: u32, point: [f64; 2]| self.way[piece as usize] + distance(self.controls(piece)[0], point);
        let way = (place(a, near.points[0]) - place(b, near.points[1])).abs();
        way.min(self.around[curve] - way) > WAY * near.distance
    }

    /// Whether no other piece lies between places on two pieces; pieces are taken for their chords.
    fn are_in_sight(&self, tree: &BoxTree, pair: [u32; 2], points: [[f64; 2]; 2]) -> bool {
        let own = pair.map(|piece| self.around(piece));
        let [p, q] = points;
        let side = |axis: usize| [p[axis].min(q[axis]), p[axis].max(q[axis])];
        let mut is_free = true;
        tree.visit(&[side(0), side(1), [0.0; 2]], |piece| {
            if !own.as_flattened().contains(&piece) {
                let controls = self.controls(piece);
                is_free &= !cross(points, [controls[0], controls[controls.len() - 1]]);
            }
        });
        is_free
    }
}

/// The places where closed curves come nearer to each other, or to themselves, than a distance, with the least distance around them, the
/// nearest first. Where they touch already, and along threads and corners that are thinner up to their tips, there are none.
///
/// # Complexity
/// $O(n \log n)$ for n pieces that are short beside what lies between them, in parallel.
pub(super) fn contacts(curves: &[&Curve<'static>], within: f64) -> Vec<Contact> {
    let pieces = Pieces::new(curves);
    let count = pieces.way.len();
    let boxes: Vec<AxisBox> = (0..count as u32)
        .map(|piece| {
            let [low, high] = control_box(pieces.controls(piece));
            let side = |axis: usize| [low[axis] - 0.5 * within, high[axis] + 0.5 * within];
            [side(0), side(1), [0.0; 2]]
        })
        .collect();
    let tree = BoxTree::new(&boxes);
    let mut pairs: Vec<[u32; 2]> = Vec::new();
    for group in 0..tree.group_count() {
        tree.pairs_of_group(group, |a, b| {
            let pair = [a.min(b), a.max(b)];
            if pieces.knots_between(pair).is_none_or(|knots| knots > 1) {
                pairs.push(pair);
            }
        });
    }
    let near: BTreeMap<[u32; 2], Near> = pairs
        .into_par_iter()
        .filter_map(|pair| {
            let [a, b] = pair.map(|piece| pieces.controls(piece));
            nearest(a, b).filter(|near| near.distance < within).map(|near| (pair, near))
        })
        .collect();
    let mut found = Vec::new();
    let mut seen = BTreeSet::new();
    for &start in near.keys() {
        if !seen.insert(start) {
            continue;
        }
        let mut open = vec![start];
        let mut is_thread = false;
        let mut least = (start, near[&start]);
        while let Some(pair) = open.pop() {
            is_thread |= pieces.knots_between(pair) == Some(2);
            if near[&pair].distance < least.1.distance {
                least = (pair, near[&pair]);
            }
            let [a, b] = pair.map(|piece| pieces.around(piece));
            for pair in a.iter().flat_map(|&a| b.iter().map(move |&b| [a.min(b), a.max(b)])) {
                if near.contains_key(&pair) && seen.insert(pair) {
                    open.push(pair);
                }
            }
        }
        let (pair, least) = least;
        let is_apart = least.distance > 1e-9 * within && pieces.are_apart(pair, &least);
        if !is_thread && is_apart && pieces.are_in_sight(&tree, pair, least.points) {
            let curves = pair.map(|piece| pieces.curve_of(piece));
            let own = [0, 1].map(|end| pair[end] as usize - pieces.first[curves[end]]);
            found.push(Contact { curves, pieces: own, points: least.points });
        }
    }
    found.sort_by(|a: &Contact, b| a.distance().total_cmp(&b.distance()));
    found
}

/// Whether two segments cross.
fn cross([a, b]: [[f64; 2]; 2], [c, d]: [[f64; 2]; 2]) -> bool {
    orientation(a, b, c) != orientation(a, b, d) && orientation(c, d, a) != orientation(c, d, b)
}

/// Places of two pieces that are nearest to each other, found from both ends and the middle of each.
fn nearest(a: &[[f64; 2]], b: &[[f64; 2]]) -> Option<Near> {
    let mut best: Option<Near> = None;
    let starts = [0.0, 0.5, 1.0].map(|s| value(a, s));
    let from_b = [0.0, 0.5, 1.0].map(|s| value(b, s));
    let starts = starts.into_iter().chain(from_b.into_iter().filter_map(|point| on(a, point)));
    for start in starts {
        let mut points = [start, on(b, start)?];
        let mut least = distance(points[0], points[1]);
        for _ in 0..TURNS {
            points[0] = on(a, points[1])?;
            points[1] = on(b, points[0])?;
            let now = distance(points[0], points[1]);
            let is_done = now >= least * (1.0 - 1e-9);
            least = least.min(now);
            if is_done {
                break;
            }
        }
        if best.is_none_or(|best| least < best.distance) {
            best = Some(Near { distance: least, points });
        }
    }
    best
}

/// The nearest point of a piece.
fn on(piece: &[[f64; 2]], point: [f64; 2]) -> Option<[f64; 2]> {
    nearest_on(piece, point, f64::INFINITY).map(|[_, s]| value(piece, s))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Order;

    fn circle(x: f64, radius: f64) -> Curve<'static> {
        Curve::circle([x, 0.0], radius, 64, Order::CUBIC).expect("a circle")
    }

    #[test]
    fn two_circles_are_near_at_one_place() {
        let curves = [circle(-1.05, 1.0), circle(1.05, 1.0)];
        let curves: Vec<&Curve<'static>> = curves.iter().collect();
        assert!(contacts(&curves, 0.099).is_empty());
        let found = contacts(&curves, 0.101);
        assert_eq!(found.len(), 1);
        assert_eq!(found[0].curves, [0, 1]);
        let [x, y] = found[0].place();
        assert!(x.abs() < 1e-6 && y.abs() < 1e-4, "{found:?}");
    }

    #[test]
    fn small_curves_and_thin_tips_are_not_near_themselves() {
        let point = circle(0.0, 0.01);
        assert!(contacts(&[&point], 0.1).is_empty());
        // A needle.
        let sides = |y: f64| (0..20).map(move |i| [f64::from(i) / 10.0, y * (1.0 - f64::from(i) / 20.0)]);
        let mut ring: Vec<[f64; 2]> = sides(-0.01).chain([[2.0, 0.0]]).collect();
        ring.extend(sides(0.01).rev());
        ring.push(ring[0]);
        let needle = Curve::polyline(&ring).expect("a polyline");
        assert!(contacts(&[&needle], 0.1).is_empty());
    }

    #[test]
    fn a_neck_is_found_once() {
        // |y| = 0.1 + x^2 between x = -1 and 1.
        let side = || (-20..=20).map(|i| f64::from(i) / 20.0).map(|x| [x, 0.1 + x * x]);
        let mut ring: Vec<[f64; 2]> = side().map(|[x, y]| [x, -y]).collect();
        ring.extend(side().rev());
        ring.push(ring[0]);
        let neck = Curve::polyline(&ring).expect("a polyline");
        assert!(contacts(&[&neck], 0.19).is_empty());
        let found = contacts(&[&neck], 0.21);
        assert_eq!(found.len(), 1);
        assert!(found[0].place().iter().all(|x| x.abs() < 1e-9), "{found:?}");
    }
}
