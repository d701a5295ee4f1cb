//! How often the inputs wind around what is in front of pieces and behind them.

use crate::meeting::bounds;
use crate::pieces::{Piece, Pieces};
use crate::point::{Plane, Point, turn};
use crate::tree::Tree;
use coface_check::Fault;
use dashu_int::IBig;
use std::cmp::Ordering;
use std::collections::BTreeMap;

const STEP: &str = "winding numbers";

/// So many points are tried in a piece for a ray that meets no side of another.
const TRIES: u8 = 60;

/// Tests that each input is a closed surface: along each edge as many of its pieces run one way as the other.
pub(crate) fn closed(all: &Pieces) -> Result<(), Fault> {
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
    match sums.into_iter().find(|(_, sum)| *sum != 0) {
        None => Ok(()),
        Some(((input, ends), _)) => {
            Err(Fault::new(STEP, format!("input {input} is not closed at the edge between {ends:?}")))
        }
    }
}

/// How often each input winds around what is in front of a piece, and around what is behind it.
///
/// A ray starts in front of a point inside the piece, along the axis that the front looks along most. It passes what it meets from behind or
/// from the front; beyond all boxes nothing winds. Other pieces do not meet the inside of the piece, so all points in front of it are alike.
pub(crate) fn both_sides(
    all: &Pieces,
    tree: &Tree,
    planes: &[Plane],
    number: usize,
    inputs: usize,
) -> Result<[Vec<i64>; 2], Fault> {
    let (piece, plane) = (&all.pieces[number], &planes[number]);
    let normal = plane.normal();
    let size = |axis: usize| if *normal[axis] < IBig::ZERO { -normal[axis] } else { normal[axis].clone() };
    let axis = (0..3).max_by_key(|&axis| size(axis)).unwrap_or(0);
    let is_up = *normal[axis] > IBig::ZERO;
    for attempt in 0..TRIES {
        let start = inner_point(all, piece, attempt);
        let mut reach = start.bounds();
        reach[axis][usize::from(is_up)] = if is_up { f64::INFINITY } else { f64::NEG_INFINITY };
        let mut front = vec![0; inputs];
        let mut is_unclear = false;
        tree.each(&reach, |other| {
            if other as usize != number {
                match passed(all, &planes[other as usize], &all.pieces[other as usize], &start, axis, is_up) {
                    Some(times) => {
                        let sources = &all.pieces[other as usize].sources;
                        sources.iter().for_each(|&(input, own)| front[input as usize] += times * own);
                    }
                    None => is_unclear = true,
                }
            }
            is_unclear
        });
        if is_unclear {
            continue;
        }
        let mut back = front.clone();
        piece.sources.iter().for_each(|&(input, own)| back[input as usize] += own);
        return Ok([front, back]);
    }
    Err(Fault::new(STEP, format!("no ray from the triangle {:?} misses all sides", piece.corners)))
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

/// All pieces in a tree.
pub(crate) fn tree_of(all: &Pieces) -> Tree {
    Tree::new(all.pieces.iter().map(|piece| bounds(all, piece)))
}
