//! Barcodes: persistence diagrams without the cells that make them, as numbers to compare and to compute with.
//!
//! # Words and conventions
//! * An **interval** is a birth and a death. A class whose values rise lives from its birth up to before its death, one whose values fall from
//!   its birth down to before its death. A class that never dies has the death inf, where values fall -inf.
//! * A **matching** of two barcodes pairs some intervals of one with some of the other. What is left over is matched with the **diagonal**, the
//!   intervals that are born and die at once.
//! * Intervals with infinite ends are matched with those that have the same ends infinite. If their numbers differ, the distance is infinite.

mod bottleneck;
mod curves;
mod intervals;
mod matching;
mod near_points;
mod surface;
mod wasserstein;

#[cfg(test)]
mod tests;

pub use curves::euler_characteristic_curve;
pub use intervals::Barcode;
pub use matching::BarcodeMatching;
pub use surface::PersistenceSurface;
