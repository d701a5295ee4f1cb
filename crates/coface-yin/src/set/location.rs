//! Where points lie.

use super::YinSet;
use crate::curve::bernstein::{control_box, is_straight, rounding_bound};
use crate::curve::piece_crossings;
use coface_algebra::{Error, ErrorKind};
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
        /// A piece of the curve that the point is on; at a knot the one that begins there.
        piece: usize,
        /// The parameter in `[0, 1)` on that piece, rounded.
        parameter: f64,
    },
}

/// Boxes of so many pieces, and boxes of so many boxes.
const WIDTH: usize = 8;

/// Boxes around pieces that come one after the other, in levels.
struct PieceBoxes<'a> {
    pieces: &'a [&'a [[f64; 2]]],
    /// For each level the lowest and highest y and the highest x.
    levels: Vec<Vec<[f64; 3]>>,
}

impl<'a> PieceBoxes<'a> {
    /// The boxes of pieces, given their control points.
    fn new(pieces: &'a [&'a [[f64; 2]]]) -> Self {
        let around = |[a, b, c]: [f64; 3], [d, e, f]: [f64; 3]| [a.min(d), b.max(e), c.max(f)];
        let nothing = [f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY];
        let of_piece = |controls: &&[[f64; 2]]| {
            let margin = if is_straight(controls) { 0.0 } else { rounding_bound(controls) };
            let [[_, low], [right, high]] = control_box(controls);
            [low - margin, high + margin, right + margin]
        };
        let mut levels: Vec<Vec<[f64; 3]>> =
            vec![pieces.chunks(WIDTH).map(|own| own.iter().map(of_piece).fold(nothing, around)).collect()];
        while let Some(last) = levels.last().filter(|last| last.len() > 1) {
            let next = last.chunks(WIDTH).map(|own| own.iter().copied().fold(nothing, around)).collect();
            levels.push(next);
        }
        Self { pieces, levels }
    }

    /// How often the pieces wind around a point, or the first piece that it is on, with the parameter.
    fn locate(&self, point: [f64; 2]) -> Result<i32, (usize, f64)> {
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
            for (piece, controls) in (first..).zip(self.pieces[first..].iter().take(WIDTH)) {
                winding += piece_crossings(controls, point).map_err(|s| (piece, s))?;
            }
        }
        Ok(winding)
    }
}

impl YinSet {
    /// Where a point lies; exact for polylines and straight pieces. Points nearer to other pieces than their rounding bound are on
    /// the boundary.
    ///
    /// # Errors
    /// As [`Self::locate_all`].
    ///
    /// # Complexity
    /// Linear in the pieces.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::boolean::InsideRule;
    /// use coface_yin::{SetLocation, YinSet};
    /// # fn main() -> Result<(), coface_algebra::Error> {
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
    ///
    /// # Examples
    /// A square of side 4 with a square hole of side 1.
    /// ```
    /// use coface_yin::{Curve, SetLocation, YinSet};
    /// let outer = Curve::polyline(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [0.0, 0.0]])?;
    /// let hole = Curve::polyline(&[[1.0, 1.0], [1.0, 2.0], [2.0, 2.0], [2.0, 1.0], [1.0, 1.0]])?;
    /// let ring = YinSet::new(&[outer, hole])?;
    /// let found = ring.locate_all(&[[0.5, 0.5], [1.5, 1.5]])?;
    /// assert_eq!(found, [SetLocation::Inside, SetLocation::Outside]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn locate_all(&self, points: &[[f64; 2]]) -> Result<Vec<SetLocation>, Error> {
        check_points(points)?;
        let degree = self.order().degree();
        let controls = self.arena().controls();
        let pieces: Vec<&[[f64; 2]]> = (0..self.curve_count())
            .flat_map(|curve| {
                let own = self.arena().first_piece(curve)..self.arena().first_piece(curve + 1);
                // Each curve has one control point more than its pieces take.
                own.map(move |piece| &controls[piece * degree + curve..=(piece + 1) * degree + curve])
            })
            .collect();
        let boxes = PieceBoxes::new(&pieces);
        let locate = |&point: &[f64; 2]| match boxes.locate(point) {
            Ok(winding) if winding >= i32::from(self.is_bounded()) => SetLocation::Inside,
            Ok(_) => SetLocation::Outside,
            Err((at, parameter)) => {
                let (curve, piece) = self.arena().curve_of_piece(at);
                if parameter < 1.0 {
                    return SetLocation::Boundary { curve, piece, parameter };
                }
                let next = if piece + 1 == self.curve(curve).piece_count() { 0 } else { piece + 1 };
                SetLocation::Boundary { curve, piece: next, parameter: 0.0 }
            }
        };
        Ok(points.par_iter().with_min_len(256).map(locate).collect())
    }
}

/// Refuses points that are not finite.
pub(super) fn check_points(points: &[[f64; 2]]) -> Result<(), Error> {
    match points.iter().position(|point| point.iter().any(|x| !x.is_finite())) {
        None => Ok(()),
        Some(at) => Err(Error::new(ErrorKind::InvalidInput, format!("point {at} is not finite"))
            .with_cure("ask about finite coordinates")),
    }
}

/// The parameter on a segment of a point on it, up to rounding; exactly 0 and 1 at its ends.
pub(crate) fn parameter([a, b]: [[f64; 2]; 2], point: [f64; 2]) -> f64 {
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
