//! The polynomials that pieces are parts of, each once.
//!
//! # Invariants
//! * A **carrier** is a polynomial over [0, 1]; carriers are different from each other and from each other's reverses, bit for bit. Each
//!   piece has one, and the **span** of the piece is the range of parameters on it: falling where the piece runs against it.
//! * Spans and all parameters of meetings are multiples of 2^-53, so differences of them are exact. A **local** parameter of a piece is
//!   the way from the beginning of its span: from 0 to the length of the span.
//! * What two pieces have in common depends on their carriers and spans alone: meetings are found between carriers, once for each pair
//!   of them, and each piece has those within its span. So a curve crosses a part of another one where it crosses the whole one,
//!   however often the part was cut, rounded or turned around, and parts of one carrier have in common what their spans have.
//! * The ends of a piece are points of its curve, which may be off the carrier by what nodes were moved when they were made.

use crate::curve::bernstein;
use crate::curve::bernstein::Piece;
use crate::curve::on_grid;
use crate::set::CurveArena;
use coface_algebra::RaggedArray;
use std::collections::HashMap;

/// No number. The arrays that hold it have one entry a cell, and an `Option` would double their size.
const NONE: u32 = u32::MAX;

/// Spans that end this near to a parameter may reach to it.
pub(super) const REACH: f64 = 1.0 / 1024.0;

/// The carriers of all pieces of several arenas, which are numbered one after the other.
pub(crate) struct Carriers {
    /// The number of control points of each.
    order: usize,
    /// The control points of all carriers, those of one together.
    controls: Vec<[f64; 2]>,
    /// How much the parameter of a curve grows along each.
    growths: Vec<f64>,
    /// For each piece its carrier and its span.
    of_piece: Vec<u32>,
    spans: Vec<[f64; 2]>,
    /// The ends of pieces.
    ends: Vec<[[f64; 2]; 2]>,
    /// The piece that follows on the same curve.
    next: Vec<u32>,
    /// The pieces of each carrier by the lower ends of their spans.
    pieces: RaggedArray,
    /// Ends of carriers at which a curve goes from one to the other, in both directions, sorted: the first carrier, its end (0 or 1),
    /// the second carrier, its end.
    joints: Vec<[u32; 4]>,
}

/// Carriers found so far, by a hash of their control points.
struct Index {
    first_of_hash: HashMap<u64, u32>,
    /// The carrier of the same hash that was found before.
    same_hash: Vec<u32>,
}

impl Carriers {
    /// The carriers of arenas of one order.
    pub(crate) fn of(arenas: &[&CurveArena], order: usize) -> Self {
        let piece_count = arenas.iter().map(|arena| arena.piece_count()).sum();
        let mut found = Self {
            order,
            controls: Vec::with_capacity(piece_count * order),
            growths: Vec::with_capacity(piece_count),
            of_piece: Vec::with_capacity(piece_count),
            spans: Vec::with_capacity(piece_count),
            ends: Vec::with_capacity(piece_count),
            next: Vec::with_capacity(piece_count),
            pieces: RaggedArray::new(),
            joints: Vec::new(),
        };
        let mut index = Index {
            first_of_hash: HashMap::with_capacity(piece_count),
            same_hash: Vec::with_capacity(piece_count),
        };
        for curve in arenas.iter().flat_map(|arena| arena.iter()) {
            let first = found.of_piece.len() as u32;
            let count = curve.piece_count() as u32;
            let mut carriers = curve.carriers().iter().peekable();
            for piece in 0..count {
                let own = curve.piece(piece as usize);
                let carrier = carriers.next_if(|carrier| carrier.piece() == piece);
                let (controls, [from, to], growth) = match carrier {
                    Some(carrier) => (carrier.controls(), carrier.range(), carrier.growth()),
                    None => {
                        let [from, to] = [piece, piece + 1].map(|knot| curve.knots()[knot as usize]);
                        (own, [0.0, 1.0], to - from)
                    }
                };
                let (carrier, is_against) = found.number(&mut index, controls, growth);
                found.of_piece.push(carrier);
                found.spans.push(if is_against { [1.0 - from, 1.0 - to] } else { [from, to] });
                found.ends.push([own[0], own[own.len() - 1]]);
                found.next.push(first + (piece + 1) % count);
            }
        }
        found.index_pieces();
        found
    }

    /// The number of the carrier with these control points, and whether it has them the other way around.
    fn number(&mut self, index: &mut Index, controls: &[[f64; 2]], growth: f64) -> (u32, bool) {
        let hash = hash(controls);
        let first = index.first_of_hash.get(&hash).copied().unwrap_or(NONE);
        let mut at = first;
        while at != NONE {
            let known = self.controls(at);
            if known == controls {
                return (at, false);
            }
            if known.iter().rev().eq(controls) {
                return (at, true);
            }
            at = index.same_hash[at as usize];
        }
        let number = self.growths.len() as u32;
        self.controls.extend_from_slice(controls);
        self.growths.push(growth);
        index.same_hash.push(first);
        index.first_of_hash.insert(hash, number);
        (number, false)
    }

    fn index_pieces(&mut self) {
        let mut sorted: Vec<u32> = (0..self.of_piece.len() as u32).collect();
        let low = |piece: u32| {
            let [from, to] = self.spans[piece as usize];
            from.min(to)
        };
        sorted.sort_by(|&a, &b| {
            let [of_a, of_b] = [a, b].map(|piece| self.of_piece[piece as usize]);
            of_a.cmp(&of_b).then(low(a).total_cmp(&low(b))).then(a.cmp(&b))
        });
        let mut starts: Vec<u32> = vec![0; self.len() + 1];
        for &carrier in &self.of_piece {
            starts[carrier as usize + 1] += 1;
        }
        for carrier in 0..self.len() {
            starts[carrier + 1] += starts[carrier];
        }
        self.pieces = RaggedArray::from_parts(starts, sorted).expect("each piece has a carrier");
        let end = |t: f64| (t == 0.0 || t == 1.0).then_some(t as u32);
        for piece in 0..self.of_piece.len() {
            let next = self.next[piece] as usize;
            let ends = [end(self.spans[piece][1]), end(self.spans[next][0])];
            if let [Some(a), Some(b)] = ends {
                let [p, q] = [piece, next].map(|piece| self.of_piece[piece]);
                self.joints.push([p, a, q, b]);
                self.joints.push([q, b, p, a]);
            }
        }
        self.joints.sort_unstable();
        self.joints.dedup();
    }

    /// The number of carriers.
    pub(crate) fn len(&self) -> usize {
        self.growths.len()
    }

    /// The control points of a carrier.
    pub(crate) fn controls(&self, carrier: u32) -> &[[f64; 2]] {
        &self.controls[carrier as usize * self.order..][..self.order]
    }

    /// The control points of all carriers.
    pub(crate) fn all_controls(&self) -> &[[f64; 2]] {
        &self.controls
    }

    /// How much the parameter of a curve grows along a carrier.
    pub(crate) fn growth(&self, carrier: u32) -> f64 {
        self.growths[carrier as usize]
    }

    /// The carrier of a piece.
    pub(crate) fn of_piece(&self, piece: u32) -> u32 {
        self.of_piece[piece as usize]
    }

    pub(super) fn span(&self, piece: u32) -> [f64; 2] {
        self.spans[piece as usize]
    }

    /// The length of the span of a piece: the local parameter of its end.
    pub(crate) fn length(&self, piece: u32) -> f64 {
        let [from, to] = self.spans[piece as usize];
        (to - from).abs()
    }

    /// The parameter on its carrier of a local parameter of a piece.
    pub(crate) fn on_carrier(&self, piece: u32, local: f64) -> f64 {
        let [from, to] = self.spans[piece as usize];
        (if from < to { from + local } else { from - local }).clamp(0.0, 1.0)
    }

    /// The local parameter of a piece of a parameter on its carrier, that of the nearest end beyond the span.
    pub(super) fn local(&self, piece: u32, t: f64) -> f64 {
        let [from, to] = self.spans[piece as usize];
        let t = on_grid(t.clamp(0.0, 1.0));
        (if from < to { t - from } else { from - t }).clamp(0.0, (to - from).abs())
    }

    /// The part of a piece between local parameters, as its carrier has it.
    pub(crate) fn part(&self, piece: u32, range: [f64; 2]) -> Piece {
        let range = range.map(|local| self.on_carrier(piece, local));
        bernstein::sub_range(self.controls(self.of_piece(piece)), range)
    }

    pub(super) fn next(&self, piece: u32) -> u32 {
        self.next[piece as usize]
    }

    /// An end of a piece, 0 or 1.
    pub(super) fn end(&self, piece: u32, end: usize) -> [f64; 2] {
        self.ends[piece as usize][end]
    }

    /// The pieces of a carrier by the lower ends of their spans.
    pub(super) fn pieces(&self, carrier: u32) -> &[u32] {
        self.pieces.list(carrier as usize)
    }

    /// The ends at which curves go from one carrier to another, or to another end of the same.
    pub(super) fn joints(&self, [p, q]: [u32; 2]) -> impl Iterator<Item = [usize; 2]> + '_ {
        let from = self.joints.partition_point(|joint| *joint < [p, 0, q, 0]);
        let near = self.joints[from..].iter().take_while(move |joint| joint[0] == p);
        near.filter(move |joint| joint[2] == q).map(|&[_, a, _, b]| [a as usize, b as usize])
    }

    /// All joints, each once.
    pub(super) fn all_joints(&self) -> impl Iterator<Item = [u32; 4]> + '_ {
        self.joints.iter().copied().filter(|&[p, a, q, b]| [p, a] <= [q, b])
    }

    /// Whether a range of parameters on a carrier is near the span of one of its pieces.
    pub(super) fn is_used(&self, carrier: u32, [low, high]: [f64; 2]) -> bool {
        self.pieces(carrier).iter().any(|&piece| {
            let [from, to] = self.spans[piece as usize];
            from.min(to) - REACH <= high && low <= from.max(to) + REACH
        })
    }
}

/// A hash of control points and of the same in reverse.
fn hash(controls: &[[f64; 2]]) -> u64 {
    let of = |points: &mut dyn Iterator<Item = &[f64; 2]>| {
        points.flatten().fold(0xcbf2_9ce4_8422_2325_u64, |hash, x| {
            // Both zeros are equal.
            let bits = (x + 0.0).to_bits();
            (hash.rotate_left(23) ^ bits).wrapping_mul(0x9e37_79b9_7f4a_7c15)
        })
    };
    of(&mut controls.iter()).wrapping_add(of(&mut controls.iter().rev()))
}
