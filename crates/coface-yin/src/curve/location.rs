//! On which side of a closed curve a point lies.

use super::Curve;
use super::bernstein;
use coface_algebra::Error;
use coface_geometry::predicates::orientation;
use std::cmp::Ordering;

/// Where a point lies with respect to a closed curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Location {
    /// In what the curve winds around: the bounded side of a Jordan curve.
    Inside,
    /// In what the curve does not wind around.
    Outside,
    /// On the curve.
    Boundary {
        /// The piece.
        piece: usize,
        /// The place on the piece, in [0, 1); 0 at a knot.
        parameter: f64,
    },
}

/// How often a closed curve runs around a point.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Winding {
    /// So often counterclockwise.
    Around(i32),
    /// The point is on a piece, at this parameter in [0, 1].
    On(usize, f64),
}

impl Curve<'_> {
    /// Where a point lies with respect to the curve.
    ///
    /// For straight pieces the answer is exact. For others it is certain: it is found by halving pieces until boxes that surely
    /// contain their exact parts leave no doubt; a point that is so close to the exact piece that rounding does not tell them apart,
    /// about $10^{-15}$ times the coordinates, is on it.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for a curve that is not closed and a point that is not finite.
    ///
    /// # Complexity
    /// Linear in the pieces.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Curve, Location};
    /// let triangle = Curve::polyline(&[[0.0, 0.0], [4.0, 0.0], [0.0, 3.0], [0.0, 0.0]])?;
    /// assert_eq!(triangle.locate([1.0, 1.0])?, Location::Inside);
    /// assert_eq!(triangle.locate([3.0, 3.0])?, Location::Outside);
    /// assert_eq!(triangle.locate([1.0, 0.0])?, Location::Boundary { piece: 0, parameter: 0.25 });
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn locate(&self, point: [f64; 2]) -> Result<Location, Error> {
        if !self.is_closed() {
            return Err(Error::invalid("an open curve has no inside")
                .with_cure("close the curve: give its first point again as the last"));
        }
        if point.iter().any(|x| !x.is_finite()) {
            return Err(Error::invalid("the point to locate is not finite"));
        }
        Ok(match self.winding(point) {
            Winding::Around(0) => Location::Outside,
            Winding::Around(_) => Location::Inside,
            Winding::On(piece, 1.0) => {
                Location::Boundary { piece: (piece + 1) % self.piece_count(), parameter: 0.0 }
            }
            Winding::On(piece, parameter) => Location::Boundary { piece, parameter },
        })
    }

    /// How often the curve runs around a point.
    fn winding(&self, point: [f64; 2]) -> Winding {
        let mut number = 0;
        for piece in 0..self.piece_count() {
            match piece_crossings(self.piece(piece), point) {
                Ok(crossings) => number += crossings,
                Err(s) => return Winding::On(piece, s),
            }
        }
        Winding::Around(number)
    }
}

/// How often a piece crosses the ray from a point toward rising x upward, less how often downward; the ray counts as being just
/// above its height. Or the parameter at which the piece runs through the point.
pub(crate) fn piece_crossings(controls: &[[f64; 2]], point: [f64; 2]) -> Result<i32, f64> {
    let last = controls.len() - 1;
    for (end, s) in [(0, 0.0), (last, 1.0)] {
        if controls[end] == point {
            return Err(s);
        }
    }
    let is_straight = bernstein::is_straight(controls);
    if is_straight {
        let [a, b] = [controls[0], controls[last]];
        if let Some(crossings) = decided(&[a, b], point, 0.0) {
            return Ok(crossings);
        }
        return match orientation(a, b, point) {
            Ordering::Equal => {
                let axis = usize::from((b[1] - a[1]).abs() > (b[0] - a[0]).abs());
                Err(((point[axis] - a[axis]) / (b[axis] - a[axis])).clamp(0.0, 1.0))
            }
            side => {
                let upward = height_step(a, b, point);
                // Crossed to the right of the point when the point is to the left of an upward piece.
                Ok(if (upward > 0 && side == Ordering::Greater) || (upward < 0 && side == Ordering::Less) {
                    upward
                } else {
                    0
                })
            }
        };
    }
    let bound = bernstein::rounding_bound(controls);
    let mut number = 0;
    let mut ranges = vec![[0.0, 1.0]];
    while let Some([low, high]) = ranges.pop() {
        let part = bernstein::sub_range(controls, [low, high]);
        if let Some(crossings) = decided(&part, point, bound) {
            number += crossings;
            continue;
        }
        let middle = 0.5 * (low + high);
        let [least, most] = bernstein::control_box(&part);
        let is_small = (0..2).all(|axis| most[axis] - least[axis] <= bound);
        if is_small || middle <= low || middle >= high {
            return Err(middle);
        }
        ranges.push([middle, high]);
        ranges.push([low, middle]);
    }
    Ok(number)
}

/// 1 if the way from a to b leads from not above the point to above it, -1 if it leads back, else 0.
fn height_step(a: [f64; 2], b: [f64; 2], point: [f64; 2]) -> i32 {
    i32::from(b[1] > point[1]) - i32::from(a[1] > point[1])
}

/// The crossings of a piece whose controls are off by at most `bound`, if their box tells.
fn decided(controls: &[[f64; 2]], point: [f64; 2], bound: f64) -> Option<i32> {
    let [least, most] = bernstein::control_box(controls);
    if point[1] < least[1] - bound || point[1] > most[1] + bound || point[0] > most[0] + bound {
        return Some(0);
    }
    (point[0] < least[0] - bound).then(|| height_step(controls[0], controls[controls.len() - 1], point))
}
