//! The order of halfedges around nodes.
//!
//! Arcs that meet at a node only leave it in the order in which they come through any circle around it that each of them crosses
//! once. Where tangents are clearly apart, they tell the order. Elsewhere points at one distance do, and where two of these are too
//! near each other, the two arcs are compared at the distances to which both can be followed.

use super::boundaries::Boundaries;
use super::chains::{Chains, undecided};
use super::nodes::tell;
use crate::curve::bernstein;
use crate::curve::bernstein::Piece;
use crate::curve::nearest_on;
use crate::{Assumption, UncertifiedDecision};
use coface_algebra::Error;
use coface_arrange::planar::ChainEdges;
use std::cmp::Ordering;
use std::sync::Mutex;

/// How many halves of the first piece of an arc are tried until one keeps its direction.
const MOST_HALVES: usize = 30;

/// How many pieces an arc is followed.
const MOST_PIECES: usize = 32;

/// Directions whose places on the diamond are this far apart are apart.
const CLEARLY_APART: f64 = 0.01;

/// Decides how halfedges go around nodes, and keeps what was not certain.
pub(super) struct Departures<'a> {
    pub(super) chains: &'a Chains<'a>,
    pub(super) edges: &'a ChainEdges,
    doubts: Mutex<Doubts>,
}

#[derive(Default)]
struct Doubts {
    /// Nodes at which the order is known up to the resolution, with two halfedges.
    uncertain: Vec<(u32, [u32; 2])>,
    /// Nodes at which it is not known.
    undecided: Vec<(u32, [u32; 2])>,
}

/// What the order of halfedges is found with.
#[derive(Default)]
pub(super) struct Scratch {
    leaving: Vec<(f64, u32)>,
    arcs: Vec<Arc>,
}

/// The beginning of an arc, as far as it goes away from its node in one direction up to 45 degrees.
struct Arc {
    pieces: Vec<Piece>,
    /// The distances from the node at the ends of the pieces, rising.
    distances: Vec<f64>,
}

impl<'a> Departures<'a> {
    pub(super) fn new(chains: &'a Chains<'a>, edges: &'a ChainEdges) -> Self {
        Self { chains, edges, doubts: Mutex::default() }
    }

    /// The part of a piece along which a halfedge leaves its node.
    fn first_part(&self, halfedge: u32) -> (u32, [f64; 2]) {
        let chain = self.edges.first_chain(halfedge / 2);
        let mut parts = self.chains.parts(chain);
        let part = if halfedge.is_multiple_of(2) { parts.next() } else { parts.next_back() };
        part.expect("chains are longer than the resolution")
    }

    /// The parts of an arc from its node on.
    fn parts(&self, halfedge: u32) -> impl Iterator<Item = Piece> + '_ {
        let mut parts = self.chains.parts(self.edges.first_chain(halfedge / 2));
        let is_along = halfedge.is_multiple_of(2);
        std::iter::from_fn(move || {
            let (piece, [from, to]) = if is_along { parts.next() } else { parts.next_back() }?;
            Some(self.boundaries().part(piece, if is_along { [from, to] } else { [to, from] }))
        })
    }

    fn boundaries(&self) -> &Boundaries<'a> {
        self.chains.boundaries
    }

    /// Puts the halfedges that leave one node in counterclockwise order.
    pub(super) fn order(&self, list: &mut [u32], scratch: &mut Scratch) {
        if list.len() <= 2 {
            return;
        }
        let node = self.edges.ends()[list[0] as usize / 2][list[0] as usize % 2];
        let center = self.chains.nodes.points[node as usize];
        if !self.order_by_tangents(list, scratch) {
            self.order_by_distances(list, node, center, scratch);
        }
        list.iter_mut().zip(&scratch.leaving).for_each(|(halfedge, &(_, sorted))| *halfedge = sorted);
    }

    fn order_by_tangents(&self, list: &[u32], scratch: &mut Scratch) -> bool {
        scratch.leaving.clear();
        let least = 1024.0 * self.boundaries().resolution;
        for &halfedge in list {
            let Some(first) = self.parts(halfedge).next() else { return false };
            let direction = difference(first[1], first[0]);
            if direction.iter().all(|x| x.abs() < least) {
                return false;
            }
            scratch.leaving.push((diamond_angle(direction), halfedge));
        }
        sort(&mut scratch.leaving);
        gaps(&scratch.leaving).all(|gap| gap > CLEARLY_APART)
    }

    fn order_by_distances(&self, list: &[u32], node: u32, center: [f64; 2], scratch: &mut Scratch) {
        scratch.arcs.clear();
        scratch.arcs.extend(list.iter().map(|&halfedge| self.arc(halfedge, center)));
        let arcs = &scratch.arcs;
        let reach = arcs.iter().map(Arc::reach).fold(f64::INFINITY, f64::min);
        let distance = 0.75 * reach;
        scratch.leaving.clear();
        scratch.leaving.extend(arcs.iter().zip(0..).map(|(arc, number)| {
            (diamond_angle(difference(arc.point_at(distance, center), center)), number)
        }));
        sort(&mut scratch.leaving);
        // Arcs in one direction are compared pair by pair, as far as these go.
        let near = 4.0 * CLEARLY_APART;
        let count = list.len();
        let leaving = &mut scratch.leaving;
        if let Some(gap) = (0..count).max_by(|&a, &b| gap_after(leaving, a).total_cmp(&gap_after(leaving, b)))
        {
            leaving.rotate_left((gap + 1) % count);
        }
        let mut start = 0;
        for at in 1..=count {
            let is_end = at == count || gap_between(leaving[at - 1].0, leaving[at].0) > near;
            if is_end {
                self.order_group(&mut leaving[start..at], arcs, list, node, center);
                start = at;
            }
        }
        leaving.iter_mut().for_each(|own| own.1 = list[own.1 as usize]);
    }

    /// Orders arcs whose directions are near each other; insertion, as these are few.
    fn order_group(&self, group: &mut [(f64, u32)], arcs: &[Arc], list: &[u32], node: u32, center: [f64; 2]) {
        for end in 1..group.len() {
            let mut at = end;
            while at > 0 {
                let [a, b] = [group[at - 1].1, group[at].1];
                let halfedges = [list[a as usize], list[b as usize]];
                match self.turn(&arcs[a as usize], &arcs[b as usize], center, (node, halfedges)) {
                    Ordering::Less => group.swap(at - 1, at),
                    _ => break,
                }
                at -= 1;
            }
        }
    }

    /// Whether the second of two arcs, which leave a node in nearly one direction, is counterclockwise of the first.
    fn turn(&self, a: &Arc, b: &Arc, center: [f64; 2], about: (u32, [u32; 2])) -> Ordering {
        let reach = a.reach().min(b.reach());
        let mut best = 0.0f64;
        let mut has_both = [false; 2];
        for part in [0.97, 0.75, 0.5, 0.3, 0.15, 0.05, 0.01] {
            let distance = part * reach;
            let [p, q] = [a, b].map(|arc| difference(arc.point_at(distance, center), center));
            // The height of the second point over the line to the first.
            let height = (p[0] * q[1] - p[1] * q[0]) / distance;
            if height.abs() > 4.0 * self.boundaries().resolution {
                has_both[usize::from(height > 0.0)] = true;
            }
            if height.abs() > best.abs() {
                best = height;
            }
        }
        let is_open = best.abs() <= 2.0 * self.boundaries().rounding || has_both == [true; 2];
        let along = if is_open { self.turn_along(about.1) } else { None };
        let mut doubts = self.doubts.lock().expect("no thread has failed here");
        if let Some(along) = along {
            doubts.uncertain.push(about);
            best = along;
        } else if is_open {
            doubts.undecided.push(about);
        } else if best.abs() <= 4.0 * self.boundaries().resolution {
            doubts.uncertain.push(about);
        }
        best.total_cmp(&0.0)
    }

    /// How far the second of two arcs is to the left of the first where they are first clearly apart, however far that is from the node and
    /// whatever way they turn; nothing if they are nowhere or each says another side.
    fn turn_along(&self, halfedges: [u32; 2]) -> Option<f64> {
        /// Places of each piece.
        const PLACES: usize = 8;
        /// How many pieces arcs are followed here.
        const MOST: usize = 4096;
        let pieces = halfedges.map(|halfedge| self.parts(halfedge).take(MOST).collect::<Vec<Piece>>());
        let clear = 2.0 * self.boundaries().rounding;
        // How far one arc is to the left of the other.
        let offset = |own: &[Piece], other: &[Piece]| {
            let mut first = 0;
            for piece in own {
                for place in 1..=PLACES {
                    let point = bernstein::value(piece, place as f64 / PLACES as f64);
                    let (at, [far, t]) = nearest_from(other, first, point)?;
                    if at + 1 == other.len() && t == 1.0 {
                        return None;
                    }
                    first = at;
                    if far > clear {
                        let tangent = bernstein::value(&bernstein::derivative(&other[at]), t);
                        let way = difference(point, bernstein::value(&other[at], t));
                        return Some(far.copysign(tangent[0] * way[1] - tangent[1] * way[0]));
                    }
                }
            }
            None
        };
        let found = [offset(&pieces[1], &pieces[0]), offset(&pieces[0], &pieces[1]).map(|x| -x)];
        match found {
            [Some(a), Some(b)] if (a > 0.0) != (b > 0.0) => None,
            [a, b] => a.or(b),
        }
    }

    fn arc(&self, halfedge: u32, center: [f64; 2]) -> Arc {
        let mut arc = Arc { pieces: Vec::new(), distances: Vec::new() };
        let mut direction: Option<[f64; 2]> = None;
        for mut piece in self.parts(halfedge).take(MOST_PIECES) {
            let mut is_whole = true;
            let base = match direction {
                Some(direction) => direction,
                None => {
                    let Some(first) = first_direction(&piece, self.boundaries().rounding) else { continue };
                    *direction.insert(first)
                }
            };
            for _ in 0..MOST_HALVES {
                if keeps_direction(&piece, base) {
                    break;
                }
                piece = bernstein::split(&piece, 0.5)[0];
                is_whole = false;
            }
            let end = difference(piece[piece.len() - 1], center);
            let distance = length(end);
            // A piece that has nothing left of it, or goes on beyond a kink in another direction, ends the arc.
            let is_farther = arc.distances.last().is_none_or(|&last| distance > last);
            if !keeps_direction(&piece, base) || !is_farther {
                break;
            }
            arc.pieces.push(piece);
            arc.distances.push(distance);
            if !is_whole {
                break;
            }
        }
        arc
    }

    /// What was not certain.
    ///
    /// # Errors
    /// If the order around a node is not known at all.
    pub(super) fn finish(self, report: &mut Vec<UncertifiedDecision>) -> Result<(), Error> {
        let Doubts { mut uncertain, mut undecided } =
            std::mem::take(&mut *self.doubts.lock().expect("no thread has failed here"));
        undecided.sort_unstable();
        let point = |node: u32| self.chains.nodes.points[node as usize];
        if let Some(&(node, halfedges)) = undecided.first() {
            let pieces = halfedges.map(|halfedge| self.first_part(halfedge).0);
            return Err(self::undecided(
                self.boundaries(),
                "the order of arcs that leave a point",
                point(node),
                pieces,
            ));
        }
        uncertain.sort_unstable();
        uncertain.dedup();
        for (node, halfedges) in uncertain {
            let parts = halfedges.map(|halfedge| self.first_part(halfedge));
            report.push(tell(self.boundaries(), Assumption::ArcOrder, point(node), parts));
        }
        Ok(())
    }
}

impl Arc {
    fn reach(&self) -> f64 {
        self.distances.last().copied().unwrap_or(0.0)
    }

    /// The point at a distance from the center, up to the reach.
    fn point_at(&self, distance: f64, center: [f64; 2]) -> [f64; 2] {
        let at = self.distances.partition_point(|&end| end < distance);
        let Some(piece) = self.pieces.get(at).or(self.pieces.last()) else { return center };
        let [mut low, mut high] = [0.0, 1.0];
        // As often as halves of the interval differ.
        for _ in 0..54 {
            let middle = 0.5 * (low + high);
            if length(difference(bernstein::value(piece, middle), center)) < distance {
                low = middle;
            } else {
                high = middle;
            }
        }
        bernstein::value(piece, high)
    }
}

/// The nearest point of pieces that follow each other, from one of them on as long as they come nearer: its piece, how far it is, and the
/// parameter.
fn nearest_from(pieces: &[Piece], first: usize, point: [f64; 2]) -> Option<(usize, [f64; 2])> {
    let mut best: Option<(usize, [f64; 2])> = None;
    for (at, piece) in pieces.iter().enumerate().skip(first) {
        let known = best.map_or(f64::INFINITY, |(_, [far, _])| far);
        match nearest_on(piece, point, known) {
            Some(found) => best = Some((at, found)),
            None => break,
        }
    }
    best
}

fn difference(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

fn length([x, y]: [f64; 2]) -> f64 {
    x.hypot(y)
}

/// The direction in which a piece starts.
fn first_direction(piece: &[[f64; 2]], rounding: f64) -> Option<[f64; 2]> {
    let directions = piece[1..].iter().map(|&point| difference(point, piece[0]));
    directions.into_iter().find(|&direction| length(direction) > 4.0 * rounding)
}

/// Whether a piece goes in a direction up to 45 degrees.
fn keeps_direction(piece: &[[f64; 2]], [x, y]: [f64; 2]) -> bool {
    piece.windows(2).all(|pair| {
        let step = difference(pair[1], pair[0]);
        let (along, across) = (x * step[0] + y * step[1], x * step[1] - y * step[0]);
        along >= across.abs()
    })
}

/// Where a direction meets the square with the corners (1, 0), (0, 1), (-1, 0), (0, -1), from 0 to 4 counterclockwise.
fn diamond_angle([x, y]: [f64; 2]) -> f64 {
    let part = y / (x.abs() + y.abs());
    let part = if part.is_nan() { 0.0 } else { part };
    match (x < 0.0, y < 0.0) {
        (true, _) => 2.0 - part,
        (false, false) => part,
        (false, true) => 4.0 + part,
    }
}

fn sort(leaving: &mut [(f64, u32)]) {
    leaving.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
}

fn gap_between(from: f64, to: f64) -> f64 {
    let gap = to - from;
    if gap < 0.0 { gap + 4.0 } else { gap }
}

fn gap_after(leaving: &[(f64, u32)], at: usize) -> f64 {
    gap_between(leaving[at].0, leaving[(at + 1) % leaving.len()].0)
}

fn gaps(leaving: &[(f64, u32)]) -> impl Iterator<Item = f64> + '_ {
    (0..leaving.len()).map(|at| gap_after(leaving, at))
}
