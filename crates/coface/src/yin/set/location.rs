//! Where points lie.

use super::YinSet;
use crate::geometry::predicates::orientation;
use crate::yin::Order;
use crate::{Error, ErrorKind};
use rayon::prelude::*;

/// Where a point lies in relation to a set.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SetLocation {
    /// In the set, which is open.
    Inside,
    /// Outside of the closure of the set.
    Outside,
    /// On the boundary.
    Boundary {
        /// A curve through the point, the first of them.
        curve: usize,
        /// The piece of the curve, the first that the point is on.
        piece: usize,
        /// The parameter in `[0, 1]` on that piece, rounded.
        parameter: f64,
    },
}

/// Boxes of so many pieces, and boxes of so many boxes.
const WIDTH: usize = 8;

/// Boxes around pieces that come one after the other, in levels.
struct PieceBoxes<'a> {
    pieces: &'a [[[f64; 2]; 2]],
    /// For each level the lowest and highest y and the highest x.
    levels: Vec<Vec<[f64; 3]>>,
}

impl<'a> PieceBoxes<'a> {
    fn new(pieces: &'a [[[f64; 2]; 2]]) -> Self {
        let around = |[a, b, c]: [f64; 3], [d, e, f]: [f64; 3]| [a.min(d), b.max(e), c.max(f)];
        let nothing = [f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY];
        let of_piece = |[a, b]: &[[f64; 2]; 2]| [a[1].min(b[1]), a[1].max(b[1]), a[0].max(b[0])];
        let mut levels: Vec<Vec<[f64; 3]>> =
            vec![pieces.chunks(WIDTH).map(|own| own.iter().map(of_piece).fold(nothing, around)).collect()];
        while let Some(last) = levels.last().filter(|last| last.len() > 1) {
            let next = last.chunks(WIDTH).map(|own| own.iter().copied().fold(nothing, around)).collect();
            levels.push(next);
        }
        Self { pieces, levels }
    }

    /// How often the pieces wind around a point, or the first piece that it is on.
    fn locate(&self, point: [f64; 2]) -> Result<i32, usize> {
        let mut winding = 0;
        let mut stack = vec![(self.levels.len() - 1, 0)];
        while let Some((level, at)) = stack.pop() {
            let Some(&[low, high, right]) = self.levels[level].get(at) else { continue };
            if point[1] < low || point[1] > high || point[0] > right {
                continue;
            }
            if level > 0 {
                // The first is taken first.
                stack.extend((at * WIDTH..(at + 1) * WIDTH).rev().map(|child| (level - 1, child)));
                continue;
            }
            let first = at * WIDTH;
            for (piece, &[a, b]) in (first..).zip(&self.pieces[first..(first + WIDTH).min(self.pieces.len())])
            {
                let is_across = (a[1] <= point[1]) != (b[1] <= point[1]);
                let is_between = (0..2)
                    .all(|axis| a[axis].min(b[axis]) <= point[axis] && point[axis] <= a[axis].max(b[axis]));
                if !is_across && !is_between {
                    continue;
                }
                let turn = orientation(a, b, point);
                if turn.is_eq() && is_between {
                    return Err(piece);
                }
                if is_across {
                    // A ray to the right meets pieces that rise and have the point on their left.
                    let rises = a[1] <= point[1];
                    if rises && turn.is_gt() {
                        winding += 1;
                    } else if !rises && turn.is_lt() {
                        winding -= 1;
                    }
                }
            }
        }
        Ok(winding)
    }
}

impl YinSet {
    /// Where a point lies; exact for sets of order 2.
    ///
    /// # Errors
    /// As [`Self::locate_all`].
    ///
    /// # Complexity
    /// Linear in the pieces.
    ///
    /// # Examples
    /// ```
    /// use coface::arrangement::boolean::InsideRule;
    /// use coface::yin::{SetLocation, YinSet};
    /// # fn main() -> Result<(), coface::Error> {
    /// let square = YinSet::from_rings(&[[[0., 0.], [2., 0.], [2., 2.], [0., 2.]]], InsideRule::Nonzero)?;
    /// assert_eq!(square.locate([1.0, 1.0])?, SetLocation::Inside);
    /// assert_eq!(square.locate([2.0, 0.5])?, SetLocation::Boundary { curve: 0, piece: 1, parameter: 0.25 });
    /// # Ok(()) }
    /// ```
    pub fn locate(&self, point: [f64; 2]) -> Result<SetLocation, Error> {
        Ok(self.locate_all(&[point])?[0])
    }

    /// Where points lie.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] naming a point that is not finite.
    ///
    /// # Complexity
    /// Linear in the pieces once, and then for each point as much as boxes of pieces meet the ray from it to the right, in parallel.
    pub fn locate_all(&self, points: &[[f64; 2]]) -> Result<Vec<SetLocation>, Error> {
        if let Some(at) = points.iter().position(|point| point.iter().any(|x| !x.is_finite())) {
            return Err(Error::new(ErrorKind::InvalidInput, format!("point {at} is not finite"))
                .with_cure("ask about finite coordinates"));
        }
        if self.order() != Order::LINEAR {
            return Err(crate::yin::boolean::unsupported(self.order()));
        }
        let pieces: Vec<[[f64; 2]; 2]> = self
            .arena()
            .iter()
            .flat_map(|curve| {
                (0..curve.piece_count())
                    .map(|piece| [curve.knot_point(piece), curve.knot_point(piece + 1)])
                    .collect::<Vec<_>>()
            })
            .collect();
        let boxes = PieceBoxes::new(&pieces);
        let locate = |&point: &[f64; 2]| match boxes.locate(point) {
            Ok(winding) if winding >= i32::from(self.is_bounded()) => SetLocation::Inside,
            Ok(_) => SetLocation::Outside,
            Err(at) => {
                let (curve, piece) = self.arena().curve_of_piece(at);
                SetLocation::Boundary { curve, piece, parameter: parameter(pieces[at], point) }
            }
        };
        Ok(points.par_iter().with_min_len(256).map(locate).collect())
    }
}

/// The parameter on a segment of a point on it, up to rounding; exactly 0 and 1 at its ends.
pub(in crate::yin) fn parameter([a, b]: [[f64; 2]; 2], point: [f64; 2]) -> f64 {
    if point == a {
        return 0.0;
    }
    if point == b {
        return 1.0;
    }
    // The coordinate that changes most, halved against overflow.
    let way = [b[0] * 0.5 - a[0] * 0.5, b[1] * 0.5 - a[1] * 0.5];
    let axis = usize::from(way[1].abs() > way[0].abs());
    ((point[axis] * 0.5 - a[axis] * 0.5) / way[axis]).clamp(0.0, 1.0)
}
