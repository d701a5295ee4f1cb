//! Where pieces cross a vertical line, with enclosures of the heights.

use super::boundaries::Boundaries;
use crate::curve::bernstein;
use crate::curve::bernstein::Piece;

/// How deep a piece is halved to tell its crossings apart.
const MOST_DEPTH: u32 = 40;

/// How often the parameters of a crossing are halved.
const HALVINGS: u32 = 44;

/// Where a piece crosses a vertical line.
#[derive(Clone, Copy, Debug)]
pub(super) struct ColumnCrossing {
    pub(super) piece: u32,
    /// The parameters that the crossing is between, from 0 to 1 along the piece.
    pub(super) range: [f64; 2],
    /// The heights that it is between.
    pub(super) heights: [f64; 2],
    /// Whether x grows along the piece there.
    pub(super) is_rightward: bool,
}

/// A line along which what it crosses cannot be told for certain, as it comes near a node, a knot or a vertical tangent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct NearDegenerate;

/// Adds all crossings of a piece with the line of this x, in the order of the piece.
pub(super) fn column_crossings(
    boundaries: &Boundaries<'_>,
    piece: u32,
    x: f64,
    found: &mut Vec<ColumnCrossing>,
) -> Result<(), NearDegenerate> {
    let controls = boundaries.controls(piece);
    let margin = 2.0 * boundaries.rounding;
    if !is_near(controls, x, margin) {
        return Ok(());
    }
    if [controls[0], controls[controls.len() - 1]].iter().any(|end| (end[0] - x).abs() <= margin) {
        return Err(NearDegenerate);
    }
    let mut column = Column { piece, x, margin, found };
    if bernstein::is_straight(controls) {
        let ends = [controls[0], controls[controls.len() - 1]];
        return column.monotone(bernstein::straight_piece(ends, controls.len()), [0.0, 1.0]);
    }
    column.search(Piece::new(controls), [0.0, 1.0], 0)
}

struct Column<'a> {
    piece: u32,
    x: f64,
    margin: f64,
    found: &'a mut Vec<ColumnCrossing>,
}

/// Whether a line comes near the control points of a piece.
fn is_near(controls: &[[f64; 2]], x: f64, margin: f64) -> bool {
    let is_right = controls.iter().all(|point| point[0] > x + margin);
    let is_left = controls.iter().all(|point| point[0] < x - margin);
    !is_right && !is_left
}

impl Column<'_> {
    fn search(&mut self, piece: Piece, range: [f64; 2], depth: u32) -> Result<(), NearDegenerate> {
        if !is_near(&piece, self.x, self.margin) {
            return Ok(());
        }
        let rises = piece.windows(2).all(|pair| pair[0][0] <= pair[1][0] + self.margin);
        let falls = piece.windows(2).all(|pair| pair[0][0] >= pair[1][0] - self.margin);
        let [first, last] = [piece[0][0], piece[piece.len() - 1][0]];
        let is_across = (first - self.x).abs() > self.margin
            && (last - self.x).abs() > self.margin
            && (first > self.x) != (last > self.x);
        if (rises || falls) && is_across && (first - last).abs() > 16.0 * self.margin {
            return self.monotone(piece, range);
        }
        if depth == MOST_DEPTH {
            return Err(NearDegenerate);
        }
        // The place of a cut must not be on the line.
        for part in [0.5, 0.4375, 0.5625, 0.375] {
            let [before, after] = bernstein::split(&piece, part);
            if (after[0][0] - self.x).abs() > self.margin {
                let middle = range[0] + part * (range[1] - range[0]);
                self.search(before, [range[0], middle], depth + 1)?;
                return self.search(after, [middle, range[1]], depth + 1);
            }
        }
        Err(NearDegenerate)
    }

    /// The one crossing of a piece along which x grows or falls.
    fn monotone(&mut self, piece: Piece, range: [f64; 2]) -> Result<(), NearDegenerate> {
        let [first, last] = [piece[0][0], piece[piece.len() - 1][0]];
        if (first > self.x) == (last > self.x) {
            return Ok(());
        }
        let is_rightward = last > first;
        let [mut low, mut high] = [0.0, 1.0];
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            let offset = bernstein::value(&piece, middle)[0] - self.x;
            if offset.abs() <= self.margin {
                break;
            }
            if (offset > 0.0) == is_rightward {
                high = middle;
            } else {
                low = middle;
            }
        }
        let [[_, bottom], [_, top]] = bernstein::range_box(&piece, [low, high]);
        let at = |part: f64| range[0] + part * (range[1] - range[0]);
        self.found.push(ColumnCrossing {
            piece: self.piece,
            range: [at(low).next_down().max(0.0), at(high).next_up().min(1.0)],
            heights: [bottom - self.margin, top + self.margin],
            is_rightward,
        });
        Ok(())
    }
}
