//! Kinks found by how much the boundary turns.

use super::KnotIndex;
use crate::{Curve, YinSet};
use coface_algebra::Error;

/// The points of a ring at which the closed polygon through them turns by more than an angle, in radians, rising.
///
/// The first point is not repeated at the end. Points are taken as they are: the finer they follow a smooth curve, the smaller the
/// angle can be.
///
/// # Errors
/// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) unless the angle is between 0 and pi.
///
/// # Examples
/// A square with the middle of one side.
/// ```
/// use coface_yin::turning_kinks;
/// let ring = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
/// assert_eq!(turning_kinks(&ring, 1.0)?, [0, 2, 3, 4]);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn turning_kinks(points: &[[f64; 2]], angle: f64) -> Result<Vec<u32>, Error> {
    check_angle(angle)?;
    let count = points.len();
    Ok((0..count)
        .filter(|&at| {
            let [before, after] = [points[(at + count - 1) % count], points[(at + 1) % count]];
            turn(difference(points[at], before), difference(after, points[at])) > angle
        })
        .map(|at| at as u32)
        .collect())
}

/// Whether a polygon turns at a point by more than an angle, in radians.
pub(crate) fn turning_at(before: [f64; 2], at: [f64; 2], after: [f64; 2], angle: f64) -> Result<bool, Error> {
    check_angle(angle)?;
    Ok(turn(difference(at, before), difference(after, at)) > angle)
}

impl YinSet {
    /// The knots at which the polygon through the knots of a curve turns by more than an angle, in radians, rising.
    ///
    /// This is for boundaries that were sampled: kinks of what was sampled turn by a fixed angle, all other knots by less the finer
    /// the samples are. For the corners that the boundary itself has see [`Self::corners`].
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) unless the angle is between 0 and pi.
    ///
    /// # Complexity
    /// $O(n)$ for n pieces.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{EndCondition, Order, YinSet};
    /// let ring = vec![[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
    /// let set = YinSet::fit(&[ring], &[], Order::CUBIC, &EndCondition::NotAKnot)?;
    /// let found: Vec<u32> = set.detect_kinks(1.0)?.iter().map(|at| at.knot).collect();
    /// assert_eq!(found, [0, 2, 3, 4]);
    /// let sharp = set.with_detected_kinks(1.0)?;
    /// assert_eq!((sharp.kinks().len(), sharp.curve(0).signed_area()), (4, 4.0));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn detect_kinks(&self, angle: f64) -> Result<Vec<KnotIndex>, Error> {
        self.knots_where(angle, |curve, [before, at]| {
            let from = difference(curve.knot_point(at), curve.knot_point(before));
            turn(from, difference(curve.knot_point(at + 1), curve.knot_point(at)))
        })
    }

    /// The knots at which the boundary itself turns by more than an angle, in radians, rising: where the tangents of the polynomials
    /// on either side differ.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) unless the angle is between 0 and pi.
    ///
    /// # Complexity
    /// $O(n)$ for n pieces.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{EndCondition, Order, YinSet};
    /// let ring = vec![[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
    /// let set = YinSet::fit(&[ring], &[vec![3]], Order::CUBIC, &EndCondition::NotAKnot)?;
    /// let found: Vec<u32> = set.corners(1e-9)?.iter().map(|at| at.knot).collect();
    /// assert_eq!(found, [3]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn corners(&self, angle: f64) -> Result<Vec<KnotIndex>, Error> {
        self.knots_where(angle, |curve, [before, at]| {
            let point = curve.knot_point(at);
            let next = curve.piece(at).iter().find(|&&control| control != point);
            let last =
                curve.piece(before).iter().rev().find(|&&control| control != curve.knot_point(before + 1));
            match (last, next) {
                (Some(&last), Some(&next)) => turn(difference(point, last), difference(next, point)),
                _ => 0.0,
            }
        })
    }

    /// The set with the kinks that [`Self::detect_kinks`] finds in place of its own, refitted.
    ///
    /// # Errors
    /// As [`Self::detect_kinks`] and [`Self::reset_all_kinks`].
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{EndCondition, Order, YinSet};
    /// let ring = vec![[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
    /// let smooth = YinSet::fit(&[ring], &[], Order::CUBIC, &EndCondition::NotAKnot)?;
    /// assert_eq!(smooth.with_detected_kinks(1.0)?.curve(0).signed_area(), 4.0);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn with_detected_kinks(&self, angle: f64) -> Result<Self, Error> {
        let mut set = self.clone();
        set.reset_all_kinks(&self.detect_kinks(angle)?)?;
        Ok(set)
    }

    /// The knots whose turn, told from a curve and the pieces before and after, is above an angle.
    fn knots_where(
        &self,
        angle: f64,
        turn: impl Fn(&Curve<'_>, [usize; 2]) -> f64,
    ) -> Result<Vec<KnotIndex>, Error> {
        check_angle(angle)?;
        let mut found = Vec::new();
        for own in 0..self.curve_count() {
            let curve = self.curve(own);
            let count = curve.piece_count();
            found.extend(
                (0..count)
                    .filter(|&at| turn(&curve, [(at + count - 1) % count, at]) > angle)
                    .map(|at| KnotIndex { curve: own as u32, knot: at as u32 }),
            );
        }
        Ok(found)
    }
}

fn check_angle(angle: f64) -> Result<(), Error> {
    if (0.0..=std::f64::consts::PI).contains(&angle) {
        return Ok(());
    }
    Err(Error::invalid(format!("{angle} is no angle to turn by"))
        .with_cure("give radians between 0 and pi, for instance 0.5"))
}

fn difference(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

/// The angle between two directions, in radians from 0 to pi.
fn turn(from: [f64; 2], to: [f64; 2]) -> f64 {
    let [from, to] = [from, to].map(|v| {
        let length = v[0].hypot(v[1]);
        [v[0] / length, v[1] / length]
    });
    (from[0] * to[1] - from[1] * to[0]).atan2(from[0] * to[0] + from[1] * to[1]).abs()
}
