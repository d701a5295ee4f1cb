//! How often the inputs wind around what is in front of pieces and behind them.

use crate::pieces::{Piece, Pieces};
use crate::point::{Plane, Point, turn};
use crate::tree::Tree;
use coface_check::Fault;
use coface_check_plane::Rule;
use dashu_int::IBig;
use std::cmp::Ordering;
use std::collections::BTreeMap;

const STEP: &str = "winding numbers";

/// So many points are tried in a piece for a ray that meets no side of another.
const TRIES: u8 = 60;

/// Tests that each input is a closed surface: along each edge as many of its pieces run one way as the other; where only parities count, that
/// their number is even.
pub(crate) fn closed(all: &Pieces, rule: Rule) -> Result<(), Fault> {
    let mut sums: BTreeMap<(u32, [u32; 2]), i64> = BTreeMap::new();
    for piece in &all.pieces {
        let [a, b, c] = piece.corners;
        for [from, to] in [[a, b], [b, c], [c, a]] {
            let sign = if from < to { 1 } else { -1 };
            for &(input, times) in &piece.sources {
                *sums.entry((input, [from.min(to), from.max(to)])).or_default() += sign * times;
            }
        }
    }
    let is_open = |sum: i64| if rule == Rule::Odd { sum % 2 != 0 } else { sum != 0 };
    match sums.into_iter().find(|(_, sum)| is_open(*sum)) {
        None => Ok(()),
        Some(((input, ends), _)) => {
            Err(Fault::new(STEP, format!("input {input} is not closed at the edge between {ends:?}")))
        }
    }
}

/// A ray from a point inside a piece along an axis, in front of the piece or behind it.
pub(crate) struct Ray {
    pub(crate) axis: usize,
    pub(crate) is_up: bool,
    pub(crate) start: Point,
    /// The pieces that it meets, with 1 for each that it leaves through the front, and -1 for each that it enters there.
    pub(crate) passed: Vec<(u32, i64)>,
}

impl Ray {
    /// A ray from the front of a piece, or from behind it, along the axis that the piece looks along most, which meets no side of another piece.
    pub(crate) fn from(
        all: &Pieces,
        tree: &Tree,
        planes: &[Plane],
        number: usize,
        is_front: bool,
    ) -> Result<Self, Fault> {
        let (piece, plane) = (&all.pieces[number], &planes[number]);
        let normal = plane.normal();
        let size =
            |axis: usize| if *normal[axis] < IBig::ZERO { -normal[axis] } else { normal[axis].clone() };
        let axis = (0..3).max_by_key(|&axis| size(axis)).unwrap_or(0);
        let is_up = (*normal[axis] > IBig::ZERO) == is_front;
        for attempt in 0..TRIES {
            let start = inner_point(all, piece, attempt);
            let mut reach = start.bounds();
            reach[axis][usize::from(is_up)] = if is_up { f64::INFINITY } else { f64::NEG_INFINITY };
            let (mut found, mut is_unclear) = (Vec::new(), false);
            tree.each(&reach, |other| {
                if other as usize != number {
                    match passed(
                        all,
                        &planes[other as usize],
                        &all.pieces[other as usize],
                        &start,
                        axis,
                        is_up,
                    ) {
                        Some(0) => {}
                        Some(times) => found.push((other, times)),
                        None => is_unclear = true,
                    }
                }
                is_unclear
            });
            if !is_unclear {
                return Ok(Self { axis, is_up, start, passed: found });
            }
        }
        Err(Fault::new(STEP, format!("no ray from the triangle {:?} misses all sides", piece.corners)))
    }

    /// The pieces that it meets, nearest first.
    pub(crate) fn in_order(mut self, planes: &[Plane]) -> Vec<(u32, i64)> {
        // A plane has the value v at the start and n along the axis: it is met after -v / n, where n is not zero.
        let way = |piece: u32| {
            let plane = &planes[piece as usize];
            let (value, along) = (plane.value(&self.start), plane.normal()[self.axis].clone());
            if along < IBig::ZERO { (value, -along) } else { (-value, along) }
        };
        let mut ways: Vec<_> =
            self.passed.drain(..).map(|(piece, times)| (way(piece), piece, times)).collect();
        ways.sort_by(|((a, below_a), ..), ((b, below_b), ..)| {
            let order = (a * below_b).cmp(&(b * below_a));
            if self.is_up { order } else { order.reverse() }
        });
        ways.into_iter().map(|(_, piece, times)| (piece, times)).collect()
    }
}

/// How often each input winds around what is in front of a piece, and around what is behind it.
///
/// A ray starts in front of a point inside the piece. It passes what it meets from behind or from the front; beyond all boxes nothing winds.
/// Other pieces do not meet the inside of the piece, so all points in front of it are alike.
pub(crate) fn both_sides(
    all: &Pieces,
    tree: &Tree,
    planes: &[Plane],
    number: usize,
    inputs: usize,
) -> Result<[Vec<i64>; 2], Fault> {
    let mut front = vec![0; inputs];
    for (other, times) in Ray::from(all, tree, planes, number, true)?.passed {
        all.pieces[other as usize]
            .sources
            .iter()
            .for_each(|&(input, own)| front[input as usize] += times * own);
    }
    let mut back = front.clone();
    all.pieces[number].sources.iter().for_each(|&(input, own)| back[input as usize] += own);
    Ok([front, back])
}

/// A point inside a piece, another one at each attempt.
fn inner_point(all: &Pieces, piece: &Piece, attempt: u8) -> Point {
    let n = i64::from(attempt);
    let weights = [7 + n * n % 11, 9 + 2 * n, 8 + n * n * n % 13];
    let [a, b, c] = all.points(piece).map(|point| &point.exact);
    // Over one denominator.
    let [of_a, of_b, of_c] =
        [&b[3] * &c[3] * weights[0], &a[3] * &c[3] * weights[1], &a[3] * &b[3] * weights[2]];
    let part = |place: usize| &a[place] * &of_a + &b[place] * &of_b + &c[place] * &of_c;
    Point::new([part(0), part(1), part(2), part(3)])
}

/// What a ray along an axis adds to the winding number at its start by passing a piece: 1 if it leaves through the front, -1 if it comes in through it,
/// 0 if it misses it. `None` if it meets a side, or the piece is seen as a line and the start is on it.
fn passed(
    all: &Pieces,
    plane: &Plane,
    piece: &Piece,
    start: &Point,
    axis: usize,
    is_up: bool,
) -> Option<i64> {
    let [a, b, c] = all.points(piece);
    let turns = [turn([a, b, start], axis), turn([b, c, start], axis), turn([c, a, start], axis)];
    let has = |wanted: Ordering| turns.contains(&wanted);
    if has(Ordering::Less) && has(Ordering::Greater) {
        return Some(0);
    }
    // On a side, or on the line as which the piece is seen.
    if has(Ordering::Equal) {
        return None;
    }
    // On the same side of all three sides: inside as seen. The piece is passed if it lies on the way.
    let is_front_up = turns[0].is_gt();
    let is_start_in_front = match plane.side(start) {
        Ordering::Equal => return None,
        side => side.is_gt(),
    };
    // The start is below a piece whose front is up if it is behind it.
    let is_ahead = if is_front_up == is_up { !is_start_in_front } else { is_start_in_front };
    if !is_ahead {
        return Some(0);
    }
    Some(if is_front_up == is_up { 1 } else { -1 })
}
