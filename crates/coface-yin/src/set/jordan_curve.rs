//! Oriented Jordan curves.

use super::construction::lying;
use super::{CurveArena, YinSet};
use crate::Curve;
use coface_algebra::Error;
use coface_algebra::Sign;

/// An oriented Jordan curve: closed, and through no point twice. It is **positive** if it runs counterclockwise around what it
/// bounds; what is on its left is its inside, which is bounded for positive curves and reaches to infinity for negative ones.
///
/// # Examples
/// ```
/// use coface_algebra::Sign;
/// use coface_yin::{Curve, JordanCurve};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let triangle = Curve::polyline(&[[0., 0.], [0., 1.], [1., 0.], [0., 0.]])?;
/// assert_eq!(JordanCurve::new(triangle)?.orientation(), Sign::Minus);
/// let bow = Curve::polyline(&[[0., 0.], [2., 2.], [2., 0.], [0., 2.], [0., 0.]])?;
/// assert!(JordanCurve::new(bow).is_err());
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct JordanCurve<'a> {
    curve: Curve<'a>,
    orientation: Sign,
}

impl<'a> JordanCurve<'a> {
    /// A closed curve, checked; of polylines exactly.
    ///
    /// # Errors
    /// As [`YinSet::new`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Sign;
    /// use coface_yin::{Curve, JordanCurve};
    /// let curve = JordanCurve::new(Curve::polyline(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.0, 0.0]])?)?;
    /// assert_eq!(curve.orientation(), Sign::Plus);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn new(curve: Curve<'a>) -> Result<Self, Error> {
        if let Some(fault) = YinSet::fault(std::slice::from_ref(&curve))? {
            return Err(fault.into_error());
        }
        let mut arena = CurveArena::new(curve.order());
        arena.push(&curve);
        let is_positive = lying(&arena)?.is_ok_and(|lying| lying.is_positive[0]);
        Ok(Self { curve, orientation: if is_positive { Sign::Plus } else { Sign::Minus } })
    }

    /// Whether the curve runs counterclockwise or clockwise.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Sign;
    /// use coface_yin::{Curve, JordanCurve};
    /// let curve = JordanCurve::new(Curve::polyline(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.0, 0.0]])?)?;
    /// assert_eq!(curve.orientation(), Sign::Plus);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn orientation(&self) -> Sign {
        self.orientation
    }

    /// The curve.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Curve, JordanCurve};
    /// let curve = JordanCurve::new(Curve::polyline(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.0, 0.0]])?)?;
    /// assert_eq!(curve.curve().piece_count(), 3);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn curve(&self) -> &Curve<'a> {
        &self.curve
    }

    /// The curve alone.
    pub fn into_curve(self) -> Curve<'a> {
        self.curve
    }
}

impl YinSet {
    /// A curve of the boundary with its orientation.
    ///
    /// # Panics
    /// If there is no such curve.
    pub fn jordan_curve(&self, curve: usize) -> JordanCurve<'_> {
        let orientation = if self.is_positive(curve) { Sign::Plus } else { Sign::Minus };
        JordanCurve { curve: self.curve(curve), orientation }
    }
}
