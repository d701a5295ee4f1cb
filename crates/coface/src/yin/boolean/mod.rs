//! The Boolean algebra of Yin sets.

mod combination;

pub use combination::{Combination, PieceSource};
