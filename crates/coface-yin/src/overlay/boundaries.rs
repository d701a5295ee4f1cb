//! The pieces of the boundaries of several sets, numbered one after the other.

use crate::curve::bernstein::Piece;
use crate::curve::{bernstein, distance, distance_to};
use crate::meetings::{Carriers, resolution};
use crate::set::CurveArena;
use crate::{Carrier, Order, PieceSource};
use coface_algebra::{Error, ErrorKind};
use std::borrow::Cow;
use std::ops::Range;

/// A piece of a curve of an operand.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct PieceIndex {
    pub(super) operand: u32,
    pub(super) curve: u32,
    pub(super) piece: u32,
}

/// A place on a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Position {
    pub(super) piece: u32,
    /// The way from the beginning of the piece along its carrier: from 0 inclusive to the length of the piece exclusive, which is 1 for
    /// whole pieces. The end of a piece is the beginning of the next.
    pub(super) parameter: f64,
}

/// The curves of several sets, all of one order.
pub(super) struct Boundaries<'a> {
    order: Order,
    arenas: Vec<Cow<'a, CurveArena>>,
    /// What the pieces are parts of.
    pub(super) carriers: Carriers,
    /// The control points of all pieces, those of a piece together.
    controls: Vec<[f64; 2]>,
    curve_of_piece: Vec<u32>,
    /// The first piece of each curve, and the number of all.
    curve_starts: Vec<u32>,
    /// The first curve of each arena, and the number of all.
    arena_starts: Vec<u32>,
    /// The resolution: what is nearer together may be taken for one point.
    pub(super) resolution: f64,
    /// How far computed points are off at most.
    pub(super) rounding: f64,
}

impl<'a> Boundaries<'a> {
    /// The curves of arenas, raised to the highest of their orders, to be told apart at so many times the usual resolution.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] for more than 2^28 pieces.
    pub(super) fn new(arenas: &[&'a CurveArena], coarseness: f64) -> Result<Self, Error> {
        let order = arenas.iter().map(|arena| arena.order()).max().unwrap_or(Order::LINEAR);
        let piece_count: usize = arenas.iter().map(|arena| arena.piece_count()).sum();
        if piece_count >= 1 << 28 {
            return Err(Error::new(ErrorKind::TooLarge, "more than 2^28 pieces of curves")
                .with_cure("combine the sets in parts"));
        }
        let arenas = arenas.iter().map(|&arena| raised(arena, order)).collect::<Result<Vec<_>, Error>>()?;
        let borrowed: Vec<&CurveArena> = arenas.iter().map(|arena| &**arena).collect();
        let mut found = Self {
            order,
            carriers: Carriers::of(&borrowed, order.value()),
            arenas: Vec::new(),
            controls: Vec::with_capacity(piece_count * order.value()),
            curve_of_piece: Vec::with_capacity(piece_count),
            curve_starts: vec![0],
            arena_starts: vec![0],
            resolution: 0.0,
            rounding: 0.0,
        };
        for arena in &arenas {
            for curve in arena.iter() {
                let number = found.curve_starts.len() as u32 - 1;
                for piece in 0..curve.piece_count() {
                    found.controls.extend_from_slice(curve.piece(piece));
                    found.curve_of_piece.push(number);
                }
                found.curve_starts.push(found.curve_of_piece.len() as u32);
            }
            found.arena_starts.push(found.curve_starts.len() as u32 - 1);
        }
        found.arenas = arenas;
        let [low, high] = bernstein::control_box(found.carriers.all_controls());
        if !found.controls.is_empty() {
            let extent = [0, 1].map(|axis| high[axis] - low[axis]);
            let largest = [low, high].as_flattened().iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
            found.resolution = resolution(extent, largest, coarseness);
            found.rounding = 4.0 * order.value() as f64 * f64::EPSILON * largest;
        }
        Ok(found)
    }

    pub(super) fn order(&self) -> Order {
        self.order
    }

    pub(super) fn piece_count(&self) -> usize {
        self.curve_of_piece.len()
    }

    pub(super) fn curve_count(&self) -> usize {
        self.curve_starts.len() - 1
    }

    pub(super) fn controls(&self, piece: u32) -> &[[f64; 2]] {
        let first = piece as usize * self.order.value();
        &self.controls[first..first + self.order.value()]
    }

    pub(super) fn curve_of(&self, piece: u32) -> u32 {
        self.curve_of_piece[piece as usize]
    }

    pub(super) fn pieces(&self, curve: u32) -> Range<u32> {
        self.curve_starts[curve as usize]..self.curve_starts[curve as usize + 1]
    }

    /// The piece that follows on the same curve.
    pub(super) fn next(&self, piece: u32) -> u32 {
        let pieces = self.pieces(self.curve_of(piece));
        if piece + 1 == pieces.end { pieces.start } else { piece + 1 }
    }

    /// The arena that a curve is in.
    pub(super) fn arena_of(&self, curve: u32) -> u32 {
        self.arena_starts.partition_point(|&start| start <= curve) as u32 - 1
    }

    pub(super) fn index(&self, piece: u32) -> PieceIndex {
        let curve = self.curve_of(piece);
        let operand = self.arena_of(curve);
        let first = self.curve_starts[curve as usize];
        PieceIndex { operand, curve: curve - self.arena_starts[operand as usize], piece: piece - first }
    }

    /// A part of a piece, by the way along it, as a source of what is made of it.
    pub(super) fn source(&self, piece: u32, range: [f64; 2]) -> PieceSource {
        let length = self.length(piece);
        let range = range.map(|way| (way / length).clamp(0.0, 1.0));
        let PieceIndex { operand, curve, piece } = self.index(piece);
        PieceSource { operand, curve, piece, range }
    }

    /// The way along a whole piece.
    pub(super) fn length(&self, piece: u32) -> f64 {
        self.carriers.length(piece)
    }

    /// The knots of the curve that a piece is on.
    pub(super) fn knots(&self, piece: u32) -> Vec<f64> {
        let PieceIndex { operand, curve, .. } = self.index(piece);
        self.arenas[operand as usize].curve(curve as usize).knots().to_vec()
    }

    /// The position so far along a piece.
    pub(super) fn position(&self, piece: u32, parameter: f64) -> Position {
        if parameter < self.length(piece) {
            Position { piece, parameter: parameter.max(0.0) }
        } else {
            Position { piece: self.next(piece), parameter: 0.0 }
        }
    }

    pub(super) fn point(&self, position: Position) -> [f64; 2] {
        let Position { piece, parameter } = position;
        if parameter == 0.0 {
            return self.controls(piece)[0];
        }
        let carrier = self.carriers.controls(self.carriers.of_piece(piece));
        bernstein::value(carrier, self.carriers.on_carrier(piece, parameter))
    }

    /// The part of a piece from so far along it to so far, which may be less: as its carrier has it.
    pub(super) fn part(&self, piece: u32, range: [f64; 2]) -> Piece {
        self.carriers.part(piece, range)
    }

    /// A part of a carrier between these ends, which are on it up to the resolution, as a piece of a curve; and its carrier, if it is not
    /// the whole one.
    pub(super) fn cut_out(
        &self,
        carrier: u32,
        range: [f64; 2],
        ends: [[f64; 2]; 2],
    ) -> (Piece, Option<Carrier>) {
        let whole = self.carriers.controls(carrier);
        let piece = bernstein::sub_range_between(whole, range, ends);
        let is_whole = match range {
            [0.0, 1.0] => piece[..] == *whole,
            [1.0, 0.0] => piece.iter().rev().eq(whole),
            _ => false,
        };
        let growth = self.carriers.growth(carrier);
        (piece, (!is_whole).then(|| Carrier::from_trusted(0, Piece::new(whole), range, growth)))
    }

    /// The parts of pieces on the way along a curve from one position to another; all of it where they are the same.
    pub(super) fn parts(
        &self,
        from: Position,
        to: Position,
    ) -> impl DoubleEndedIterator<Item = (u32, [f64; 2])> + '_ {
        let pieces = self.pieces(self.curve_of(from.piece));
        let (start, count) = (pieces.start, pieces.end - pieces.start);
        let steps = if from.piece == to.piece && from.parameter < to.parameter {
            0
        } else if from.piece < to.piece {
            to.piece - from.piece
        } else {
            to.piece + count - from.piece
        };
        let part = move |step: u32| {
            let piece = start + (from.piece - start + step) % count;
            let begin = if step == 0 { from.parameter } else { 0.0 };
            (piece, [begin, if step == steps { to.parameter } else { self.length(piece) }])
        };
        (0..=steps).map(part).filter(|(_, range)| range[0] < range[1])
    }

    /// Whether the way between two parameters of a carrier is so short that they are taken for one point.
    pub(super) fn is_one_point(&self, carrier: u32, range: [f64; 2]) -> bool {
        let way = bernstein::sub_range(self.carriers.controls(carrier), range);
        let [low, high] = bernstein::control_box(&way);
        range[0] == range[1] || (0..2).all(|axis| high[axis] - low[axis] <= 16.0 * self.resolution)
    }

    /// Whether two arcs between positions stay within a distance of each other, at places that are spread over both.
    pub(super) fn are_near(&self, arcs: [[Position; 2]; 2], limit: f64) -> bool {
        /// Places of each piece besides its ends.
        const PLACES: usize = 7;
        let pieces = arcs.map(|[from, to]| {
            self.parts(from, to).map(|(piece, range)| self.part(piece, range)).collect::<Vec<Piece>>()
        });
        (0..2).all(|side| {
            let other = &pieces[1 - side];
            // Most points are near the piece that the one before is near.
            let mut last = 0;
            let mut is_near = |point: [f64; 2]| {
                let is_near_piece = |piece: &Piece| distance_to(piece, point, limit.next_up()) <= limit;
                is_near_piece(&other[last])
                    || other.iter().position(is_near_piece).inspect(|&at| last = at).is_some()
            };
            pieces[side].iter().all(|piece| {
                let steps = (PLACES + 1) as f64;
                (0..=PLACES + 1).all(|place| is_near(bernstein::value(piece, place as f64 / steps)))
            })
        })
    }

    /// The length of the control polygons of the pieces around a position: of its own, and at a knot of that before it.
    pub(super) fn length_around(&self, at: Position) -> f64 {
        let length = |piece: u32| -> f64 {
            self.controls(piece).windows(2).map(|pair| distance(pair[0], pair[1])).sum()
        };
        if at.parameter != 0.0 {
            return length(at.piece);
        }
        let pieces = self.pieces(self.curve_of(at.piece));
        let before = if at.piece == pieces.start { pieces.end } else { at.piece } - 1;
        length(before) + length(at.piece)
    }

    /// Whether the way from one position to another, which is not the same, stays within the resolution.
    pub(super) fn is_tiny(&self, from: Position, to: Position) -> bool {
        self.is_within(from, to, self.resolution)
    }

    /// Whether the way from one position to another, which is not the same, stays in a box with sides up to a limit.
    pub(super) fn is_within(&self, from: Position, to: Position, limit: f64) -> bool {
        let [a, b] = [from, to].map(|position| self.point(position));
        if (0..2).any(|axis| (a[axis] - b[axis]).abs() > limit) {
            return false;
        }
        let [mut low, mut high] = [a, a];
        for (piece, range) in self.parts(from, to) {
            let [own_low, own_high] = bernstein::control_box(&self.part(piece, range));
            for axis in 0..2 {
                low[axis] = low[axis].min(own_low[axis]);
                high[axis] = high[axis].max(own_high[axis]);
                if high[axis] - low[axis] > limit {
                    return false;
                }
            }
        }
        true
    }
}

fn raised(arena: &CurveArena, order: Order) -> Result<Cow<'_, CurveArena>, Error> {
    if arena.order() == order {
        return Ok(Cow::Borrowed(arena));
    }
    let mut found = CurveArena::new(order);
    for curve in arena.iter() {
        found.push(&curve.raised(order)?);
    }
    Ok(Cow::Owned(found))
}
