//! Vineyards: how the classes of a diagram move while the function moves.
//!
//! # Words and conventions
//! * Functions on the vertices are given at the **parameters** 0, 1, 2, ..; between them each vertex has the value on the line between its two values.
//! * A [`Vine`] is the path of a point of the diagram, from where it leaves the diagonal to where it comes back.
//! * Two vertices whose values meet change places. The cells that enter with them change places one after the other, and each of these
//!   **transpositions** changes at most one sum of columns of the decomposition R = D V.

mod decomposition;
mod sweep;
mod vine;

#[cfg(test)]
mod tests;

pub use sweep::vineyard;
pub use vine::{Vine, VinePoint};
