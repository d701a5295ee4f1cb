//! Angles, given by their cosine and sine.

use coface_algebra::Error;
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2};

/// An angle, known by its cosine and sine.
///
/// Of multiples of a quarter turn both are exact, of twelfths and eighths of a turn correctly rounded, and equal angles
/// up to symmetry have equal values up to sign: points that are placed around a circle by [`Self::turns`] are exactly
/// as symmetric as they should be.
///
/// # Examples
/// ```
/// use coface_geometry::Angle;
/// assert_eq!(Angle::turns(1, 4).cosine_and_sine(), (0.0, 1.0));
/// assert_eq!(Angle::degrees(-270.0)?.cosine_and_sine(), (0.0, 1.0));
/// assert_eq!(Angle::turns(-1, 3).cosine_and_sine().0, -0.5);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Angle {
    cosine: f64,
    sine: f64,
}

impl Angle {
    /// The angle of zero.
    pub const ZERO: Self = Self { cosine: 1.0, sine: 0.0 };

    /// This part of a full turn: `turns(1, 4)` is a right angle.
    ///
    /// # Panics
    /// If the denominator is zero.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::Angle;
    /// assert_eq!(Angle::turns(1, 2).cosine_and_sine(), (-1.0, 0.0));
    /// ```
    pub fn turns(numerator: i64, denominator: u32) -> Self {
        let d = i128::from(denominator);
        let quarters = 4 * (i128::from(numerator).rem_euclid(d));
        // The nearest multiple of a quarter, and what is left of d to it.
        let quadrant = (2 * quarters + d).div_euclid(2 * d);
        let rest = quarters - quadrant * d;
        let quadrant = i64::try_from(quadrant).expect("a part of a turn has at most four quadrants");
        Self::of_quadrant(quadrant, rest as f64 / d as f64)
    }

    /// An angle in degrees.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::InvalidInput`] unless the number is finite.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::Angle;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(Angle::degrees(90.0)?.cosine_and_sine(), (0.0, 1.0));
    /// assert!(Angle::degrees(f64::NAN).is_err());
    /// # Ok(()) }
    /// ```
    #[allow(
        clippy::cast_possible_truncation,
        reason = "a remainder of 360 degrees has at most four quadrants"
    )]
    pub fn degrees(degrees: f64) -> Result<Self, Error> {
        if !degrees.is_finite() {
            return Err(
                Error::invalid(format!("{degrees} is no angle")).with_cure("give a finite number of degrees")
            );
        }
        // Remainders are exact.
        let reduced = degrees % 360.0;
        let quadrant = (reduced / 90.0).round();
        Ok(Self::of_quadrant(quadrant as i64, (reduced - 90.0 * quadrant) / 90.0))
    }

    /// An angle in radians.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::InvalidInput`] unless the number is finite.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::Angle;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(Angle::radians(0.0)?, Angle::ZERO);
    /// # Ok(()) }
    /// ```
    pub fn radians(radians: f64) -> Result<Self, Error> {
        if !radians.is_finite() {
            return Err(
                Error::invalid(format!("{radians} is no angle")).with_cure("give a finite number of radians")
            );
        }
        let (sine, cosine) = radians.sin_cos();
        Ok(Self { cosine, sine })
    }

    /// So many quarter turns, and this part of one more, between -1/2 and 1/2.
    fn of_quadrant(quadrant: i64, part: f64) -> Self {
        let (sine, cosine) = match part.abs() {
            0.5 => (FRAC_1_SQRT_2.copysign(part), FRAC_1_SQRT_2),
            x if x == 1.0 / 3.0 => (0.5f64.copysign(part), 0.75f64.sqrt()),
            _ => (part * FRAC_PI_2).sin_cos(),
        };
        // Adding zero takes the sign off a negative zero.
        let (cosine, sine) = match quadrant.rem_euclid(4) {
            0 => (cosine, sine),
            1 => (-sine, cosine),
            2 => (-cosine, -sine),
            _ => (sine, -cosine),
        };
        Self { cosine: cosine + 0.0, sine: sine + 0.0 }
    }

    /// The cosine and the sine.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::Angle;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(Angle::degrees(60.0)?.cosine_and_sine().0, 0.5);
    /// # Ok(()) }
    /// ```
    pub const fn cosine_and_sine(self) -> (f64, f64) {
        (self.cosine, self.sine)
    }

    /// The angle the other way around.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::Angle;
    /// assert_eq!(Angle::turns(1, 4).reversed(), Angle::turns(3, 4));
    /// ```
    #[must_use]
    pub fn reversed(self) -> Self {
        Self { cosine: self.cosine, sine: 0.0 - self.sine }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn the_axes_are_exact() {
        let expected = [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)];
        for (i, axis) in expected.into_iter().enumerate() {
            for round in -2i64..3 {
                let angle = Angle::turns(i as i64 + 4 * round, 4);
                assert_eq!(angle.cosine_and_sine(), axis);
                assert_eq!(Angle::degrees(90.0 * (i as i64 + 4 * round) as f64).unwrap(), angle);
            }
        }
        assert_eq!(Angle::degrees(60.0).unwrap().cosine_and_sine().0, 0.5);
        assert!(Angle::degrees(f64::NAN).is_err() && Angle::radians(f64::INFINITY).is_err());
    }

    proptest! {
        #[test]
        fn three_units_agree(numerator in -10_000i64..10_000, denominator in 1u32..10_000) {
            let turns = numerator as f64 / f64::from(denominator);
            let (c, s) = Angle::turns(numerator, denominator).cosine_and_sine();
            for other in [Angle::degrees(360.0 * turns), Angle::radians(std::f64::consts::TAU * turns)] {
                let (x, y) = other.unwrap().cosine_and_sine();
                let tolerance = 1e-14 * (1.0 + turns.abs());
                prop_assert!((x - c).abs() < tolerance && (y - s).abs() < tolerance, "{c} {s} {x} {y}");
            }
        }

        #[test]
        fn symmetric_angles_are_exactly_symmetric(i in 0i64..400, n in 1u32..400) {
            let (c, s) = Angle::turns(i, n).cosine_and_sine();
            prop_assert_eq!(Angle::turns(-i, n).cosine_and_sine(), (c, 0.0 - s));
            let (x, y) = Angle::turns(2 * i + i64::from(n), 2 * n).cosine_and_sine();
            prop_assert_eq!((x, y), (0.0 - c, 0.0 - s));
        }
    }
}
