//! Euler characteristics of what has entered, without homology.
//!
//! * An [`EulerCurve`] has the Euler characteristic of the cells that have entered, at each value: of a [filtration](EulerCurve::of_filtration), or of an
//!   [image](crate::ImageFiltration::euler_curve).
//! * An [`EulerTransform`] has such a curve for each direction: cells enter with their highest vertex, where the height is measured along the direction.

mod curve;
mod transform;

#[cfg(test)]
mod tests;

pub use curve::EulerCurve;
pub use transform::{EulerTransform, even_directions};
