//! Velocity fields of tests of interface tracking.

use std::f64::consts::PI;

/// A velocity field of the plane that has no divergence: it keeps areas.
///
/// # Examples
/// ```
/// use coface_yin::Flow;
/// let turn = Flow::Rotation { center: [0.0, 0.0], speed: 2.0 };
/// assert_eq!(turn.velocity([1.0, 0.0], 0.0), [0.0, 2.0]);
/// // The vortex stands still at the middle of its period, and in its center.
/// let vortex = Flow::Vortex { period: 4.0 };
/// assert!(vortex.velocity([0.3, 0.6], 2.0)[0].abs() < 1e-15);
/// assert!(vortex.velocity([0.5, 0.5], 0.0)[1].abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Flow {
    /// All points move alike.
    Translation {
        /// The velocity, lengths per time.
        velocity: [f64; 2],
    },
    /// A rigid rotation.
    Rotation {
        /// The point that rests.
        center: [f64; 2],
        /// Radians per time, positive counterclockwise.
        speed: f64,
    },
    /// The single vortex in the unit square, $\cos(\pi t / T) (\sin^2(\pi x) \sin(2 \pi y), -\sin^2(\pi y) \sin(2 \pi x))$: at the
    /// end of the period all points are back.
    Vortex {
        /// The period T.
        period: f64,
    },
    /// Rows of vortices, $\cos(\pi t / T) (\sin n\pi(x + 1/2) \sin n\pi(y + 1/2), \cos n\pi(x + 1/2) \cos n\pi(y + 1/2))$.
    Deformation {
        /// The period T.
        period: f64,
        /// The number n of vortices in each direction of the unit square; 4 in common tests.
        vortices: u32,
    },
}

impl Flow {
    /// The velocity at a point and a time.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::Flow;
    /// let turn = Flow::Rotation { center: [0.0, 0.0], speed: 2.0 };
    /// assert_eq!(turn.velocity([1.0, 0.0], 0.0), [0.0, 2.0]);
    /// ```
    pub fn velocity(&self, [x, y]: [f64; 2], time: f64) -> [f64; 2] {
        match *self {
            Self::Translation { velocity } => velocity,
            Self::Rotation { center, speed } => [-speed * (y - center[1]), speed * (x - center[0])],
            Self::Vortex { period } => {
                let strength = (PI * time / period).cos();
                let ((sx, cx), (sy, cy)) = ((PI * x).sin_cos(), (PI * y).sin_cos());
                [strength * sx * sx * 2.0 * sy * cy, -strength * sy * sy * 2.0 * sx * cx]
            }
            Self::Deformation { period, vortices } => {
                let strength = (PI * time / period).cos();
                let n = PI * f64::from(vortices);
                let ((sx, cx), (sy, cy)) = ((n * (x + 0.5)).sin_cos(), (n * (y + 0.5)).sin_cos());
                [strength * sx * sy, strength * cx * cy]
            }
        }
    }
}
