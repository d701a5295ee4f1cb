//! The carriers of all pieces in one frame, cut into monotone parts.

use super::carriers::Carriers;
use super::{Frame, Polynomial};
use crate::curve::bernstein;
use coface_algebra::Error;
use rayon::prelude::*;

/// The carriers of pieces, and their monotone parts where pieces are.
pub(super) struct Pieces<'a> {
    pub(super) frame: Frame,
    carriers: &'a Carriers,
    /// The control points of all pieces in the frame, those of a piece together.
    controls: Vec<[f64; 2]>,
    /// The first control point of each piece, and their number.
    starts: Vec<u32>,
    /// The ends of each piece in coordinates of the input.
    ends: Vec<[[f64; 2]; 2]>,
    is_straight: Vec<bool>,
    parts: Vec<Part>,
    part_controls: Vec<[f64; 2]>,
}

/// A part of a piece that is monotone in both coordinates.
#[derive(Clone, Copy, Debug)]
pub(super) struct Part {
    pub(super) piece: u32,
    /// Its first control point among those of all parts.
    first_control: u32,
    pub(super) range: [f64; 2],
}

/// The parts of one piece.
struct Cut {
    ranges: Vec<[f64; 2]>,
    controls: Vec<[f64; 2]>,
}

impl<'a> Pieces<'a> {
    /// The carriers, to be told apart at so many times the usual resolution.
    ///
    /// # Errors
    /// As [`Frame::of_points`]; [`ErrorKind::TooLarge`](coface_algebra::ErrorKind::TooLarge) for more than 2^29 control points.
    pub(super) fn of(carriers: &'a Carriers, coarseness: f64) -> Result<Self, Error> {
        let all = carriers.all_controls();
        if all.len() >= 1 << 29 {
            return Err(Error::new(coface_algebra::ErrorKind::TooLarge, "more than 2^29 control points")
                .with_cure("combine the sets in parts"));
        }
        let frame = Frame::of_points(all.iter(), coarseness)?;
        let count = carriers.len();
        let mut found = Self {
            frame,
            carriers,
            controls: Vec::with_capacity(all.len()),
            starts: Vec::with_capacity(count + 1),
            ends: Vec::with_capacity(count),
            is_straight: Vec::with_capacity(count),
            parts: Vec::new(),
            part_controls: Vec::new(),
        };
        found.starts.push(0);
        for controls in (0..count as u32).map(|carrier| carriers.controls(carrier)) {
            let ends = [controls[0], controls[controls.len() - 1]];
            let is_straight = bernstein::is_straight(controls);
            if is_straight {
                let own = bernstein::straight_piece(ends.map(|end| frame.to_local(end)), controls.len());
                found.controls.extend_from_slice(&own);
            } else {
                found.controls.extend(controls.iter().map(|&point| frame.to_local(point)));
            }
            found.starts.push(found.controls.len() as u32);
            found.ends.push(ends);
            found.is_straight.push(is_straight);
        }
        found.cut();
        Ok(found)
    }

    fn cut(&mut self) {
        let cuts: Vec<Cut> = (0..self.len())
            .into_par_iter()
            .with_min_len(256)
            .map_init(Vec::new, |turns, piece| self.cut_of(piece, turns))
            .collect();
        let part_count: usize = cuts.iter().map(|cut| cut.ranges.len()).sum();
        let mut parts = Vec::with_capacity(part_count);
        let mut part_controls = Vec::with_capacity(cuts.iter().map(|cut| cut.controls.len()).sum());
        for (piece, cut) in cuts.into_iter().enumerate() {
            let step = cut.controls.len() / cut.ranges.len();
            for (&range, controls) in cut.ranges.iter().zip(cut.controls.chunks_exact(step)) {
                if self.carriers.is_used(piece as u32, range) {
                    parts.push(Part {
                        piece: piece as u32,
                        first_control: part_controls.len() as u32,
                        range,
                    });
                    part_controls.extend_from_slice(controls);
                }
            }
        }
        (self.parts, self.part_controls) = (parts, part_controls);
    }

    fn cut_of(&self, piece: usize, turns: &mut Vec<f64>) -> Cut {
        let own = self.polynomial(piece);
        turns.clear();
        if !self.is_straight[piece] {
            for axis in 0..2 {
                own.add_turns(axis, turns);
            }
            turns.sort_by(f64::total_cmp);
            turns.dedup();
        }
        let ends: Vec<f64> = [0.0].into_iter().chain(turns.iter().copied()).chain([1.0]).collect();
        let mut controls = Vec::with_capacity(ends.len() * (own.degree() + 1));
        let mut from = own.first();
        for range in ends.windows(2) {
            let to = own.at(range[1]);
            // Neighbors share their ends bit for bit.
            let part = own.part([range[0], range[1]]).with_ends([from, to]);
            controls.extend_from_slice(part.controls());
            from = to;
        }
        Cut { ranges: ends.windows(2).map(|range| [range[0], range[1]]).collect(), controls }
    }

    /// The number of pieces.
    pub(super) fn len(&self) -> usize {
        self.ends.len()
    }

    /// A piece in coordinates of the frame.
    pub(super) fn polynomial(&self, piece: usize) -> Polynomial {
        Polynomial::new(&self.controls[self.starts[piece] as usize..self.starts[piece + 1] as usize])
    }

    /// A piece in coordinates of the input, exactly as it was given.
    pub(super) fn given(&self, piece: usize) -> &'a [[f64; 2]] {
        self.carriers.controls(piece as u32)
    }

    /// The ends of a piece in coordinates of the input.
    pub(super) fn ends(&self, piece: usize) -> [[f64; 2]; 2] {
        self.ends[piece]
    }

    /// Whether a piece is treated as a segment.
    pub(super) fn is_straight(&self, piece: usize) -> bool {
        self.is_straight[piece]
    }

    /// The ends (0 or 1) at which curves go from one piece to another.
    pub(super) fn joints(&self, pair: [u32; 2]) -> impl Iterator<Item = [usize; 2]> + 'a {
        self.carriers.joints(pair)
    }

    /// The monotone parts of all pieces, in order.
    pub(super) fn parts(&self) -> &[Part] {
        &self.parts
    }

    /// A part in coordinates of the frame.
    pub(super) fn part_polynomial(&self, part: usize) -> Polynomial {
        Polynomial::new(self.part_points(part))
    }

    /// The control points of a part.
    pub(super) fn part_points(&self, part: usize) -> &[[f64; 2]] {
        let own = self.parts[part];
        let piece = own.piece as usize;
        let count = (self.starts[piece + 1] - self.starts[piece]) as usize;
        &self.part_controls[own.first_control as usize..own.first_control as usize + count]
    }
}
