//! Homology and cohomology of chain complexes: groups, bases with certificates, induced maps, cup products.
//!
//! # Words and conventions
//! * **Homology** in degree k is the group of k-cycles modulo the boundaries of (k+1)-chains. Over Z it is a finitely
//!   generated [`AbelianGroup`]: its rank is the **Betti number**, its finite part is the **torsion**.
//! * [`homology`] computes the groups over Z. [`homology_with`] and [`cohomology`] compute them over Z, Q or Z/n by the
//!   universal coefficient theorem. A [`Homology`] lists the groups by degree.
//! * A [`HomologyBasis`] has one cycle on the original cells for each cyclic summand, and the dual cocycles. It gives
//!   the [`HomologyClass`] of any cycle, and a certificate ([`Bounding`]): a chain that the cycle bounds, the least
//!   multiple that bounds, or a cocycle that proves that no multiple does.
//! * [`generators`] gives the cycles alone. [`generators_of_parts`] finds them for a complex that is divided into
//!   parts, and [`homology_of_parts`] the groups alone.
//! * A chain map induces a [`HomologyMap`] in each degree ([`induced_maps`]); a subcomplex has a [`LongExactSequence`].
//! * The **cup product** of cochains is that of a [`CochainAlgebra`]. A [`CupProductTable`] lists the products of
//!   classes; the [`IntersectionForm`] is the product in the middle degree of a closed oriented manifold.
//! * Orders are `Option<Integer>`: `None` is infinite. Torsion comes before free generators, orders dividing along.
//!
//! # Examples
//! The Klein bottle as a square with one vertex and two loops a, b, whose boundary is a b a b^-1.
//! ```
//! use coface_algebra::SparseMatrix;
//! use coface_algebra::chains::ChainComplex;
//! use coface_topology::homology;
//! # fn main() -> Result<(), coface_algebra::Error> {
//! let klein = ChainComplex::new(vec![SparseMatrix::zero(1, 2)?, SparseMatrix::from_entries(2, 1, [(0, 0, 2)])?])?;
//! let groups: Vec<String> = homology(&klein).groups().iter().map(ToString::to_string).collect();
//! assert_eq!(groups, ["Z", "Z + Z/2", "0"]);
//! # Ok(()) }
//! ```

mod abelian_group;
mod adapted_basis;
mod basis;
mod class;
mod cocycles;
mod coefficients;
mod computation;
mod cup;
mod cup_table;
mod duals;
mod fundamental_cycle;
mod generators;
mod induced_maps;
mod intersection_form;
mod long_exact_sequence;
mod parts;
mod short_loops;
mod shortening;
mod summands;

pub use abelian_group::AbelianGroup;
pub use basis::HomologyBasis;
pub use class::{Bounding, Cocycle, Generator, HomologyClass};
pub use coefficients::Coefficients;
pub use computation::{Homology, cohomology, homology, homology_with};
pub use cup::CochainAlgebra;
pub use cup_table::{CupProductTable, cup_product_table};
pub use generators::generators;
pub use induced_maps::{HomologyMap, induced_maps};
pub use intersection_form::{IntersectionForm, MiddlePairing, intersection_form};
pub use long_exact_sequence::LongExactSequence;
#[doc(hidden)]
pub use parts::reduced_generators;
pub use parts::{generators_of_parts, homology_of_parts};
