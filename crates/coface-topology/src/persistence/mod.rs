//! Persistent homology: when the homology classes of a growing complex are born, and when they die.
//!
//! # Words and conventions
//! * A [`Filtration`] gives each cell the value at which it **enters**. A face enters no later than its cofaces, so the
//!   cells that have entered by a value are a subcomplex. Values rise, or, for an upper star, fall.
//! * Over a field each class is **born** when one cell enters and **dies** when another one does, a degree higher, or
//!   never: then it is **essential**. A [`PersistencePair`] names both cells and both values, a
//!   [`PersistenceDiagram`] holds all pairs. The number of essential classes of a degree is its Betti number.
//! * A [`Barcode`] has births and deaths alone: what diagrams of all filtrations have in common. Distances are distances of barcodes.
//! * **Extended** persistence goes on with the homology relative to growing superlevel sets, where each class dies: [`extended_persistence`].
//! * Of a pair of a complex and a part of it, **relative** persistence has the homology of the whole modulo the part ([`relative_persistence`]), and **image**
//!   persistence that of the part as it is seen in the whole ([`image_persistence`]).
//! * A **zigzag** gains and loses simplices: a [`ZigzagFiltration`]. Its classes live on intervals whose ends are **closed** or **open**: a [`ZigzagPair`].
//! * A [`vineyard`] follows the points of a diagram while the function moves: each path is a [`Vine`].
//! * The **persistence** of a pair is the distance between birth and death. Pairs of persistence zero, on the
//!   **diagonal**, depend on how ties are broken; the others do not.

mod barcode;
mod cycles;
mod diagram;
mod elimination;
mod euler;
mod extended;
mod filtration;
mod image;
mod pair;
mod reduction;
mod rips;
mod shortening;
mod sum;
mod torsion;
mod trees;
mod vineyard;
mod zigzag;

#[cfg(test)]
mod cycles_tests;
#[cfg(test)]
mod tests;
#[cfg(test)]
mod zigzag_tests;

pub use barcode::{Barcode, BarcodeMatching, PersistenceSurface, euler_characteristic_curve};
pub use cycles::{PersistentCycle, persistent_cycles};
pub use diagram::{PersistenceDiagram, PersistencePair};
pub use euler::{EulerCurve, EulerTransform, even_directions};
pub use extended::{ExtendedKind, ExtendedPair, extended_filtration, extended_persistence};
pub use filtration::Filtration;
pub use image::{
    CubeTerms, ImageBlocks, ImageConstruction, ImageCycle, ImageCycles, ImageDiagram, ImageFiltration,
    ImagePair, ImagePart,
};
pub use pair::{image_persistence, relative_persistence};
pub use reduction::persistence;
pub use rips::{RipsCochain, RipsDiagram, RipsFiltration, RipsPair, RipsSize};
pub use torsion::torsion_primes;
pub use vineyard::{Vine, VinePoint, vineyard};
pub use zigzag::{ZigzagFiltration, ZigzagPair, ZigzagStep};
