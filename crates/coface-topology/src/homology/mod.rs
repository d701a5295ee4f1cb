//! Homology and cohomology of chain complexes: groups, bases with certificates, induced maps, long exact sequences, cup products.

mod abelian_group;
mod adapted_basis;
mod basis;
mod class;
mod cocycles;
mod coefficients;
mod computation;
mod cup;
mod cup_table;
mod fundamental_cycle;
mod generators;
mod induced_maps;
mod intersection_form;
mod long_exact_sequence;
mod parts;
mod short_loops;
mod shortening;

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
pub use parts::generators_of_parts;
#[doc(hidden)]
pub use parts::reduced_generators;
