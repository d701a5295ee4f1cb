//! Fundamental groups: presentations of edge-path groups, and normal forms in the groups of surfaces.
//!
//! # Words and conventions
//! * A [`coface_algebra::Word`] is a product of **letters**: +i is generator i, -i its inverse, counted from 1.
//! * A [`Presentation`] has generators and **relators**, words that are the identity of the group.
//! * [`EdgePathGroups`] presents the fundamental group of each component of a 2-skeleton: every edge has a word, and
//!   every generator is a loop at the base vertex.
//! * A [`Simplification`] shortens a presentation by [`TietzeMove`]s and keeps the isomorphism in both directions.
//! * Groups are compared by invariants: [`Presentation::subgroups_up_to`] counts subgroups of low index,
//!   [`Presentation::homomorphisms_to`] counts homomorphisms to a [`PermutationGroup`]. A [`CosetTable`] enumerates the
//!   cosets of a subgroup.
//! * A [`SurfaceGroup`] is the group of a surface. Its elements have a [`NormalForm`], which decides whether two
//!   loops are homotopic; a [`ConjugacyForm`] decides free homotopy. A [`Ball`] lists the elements up to a length.
//! * The word problem is undecidable in general, so searches are bounded by an [`Effort`]. Its steps are the same on
//!   every machine.
//!
//! # Examples
//! ```
//! use coface_algebra::Word;
//! use coface_topology::SurfaceGroup;
//! # fn main() -> Result<(), coface_algebra::Error> {
//! let genus_2 = SurfaceGroup::closed(&Word::from_letters([1, 2, -1, -2, 3, 4, -3, -4]))?;
//! assert!(!genus_2.is_trivial(&Word::from_letters([1, 2, -1, -2])));
//! # Ok(()) }
//! ```

mod fundamental;
mod surface_group;

pub use fundamental::{
    CosetTable, EdgePathGroups, Effort, HomomorphismCount, PermutationGroup, Presentation, Simplification,
    SubgroupClass, TietzeMove,
};
pub use surface_group::{Ball, CanonicalSystem, ConjugacyForm, NormalForm, SurfaceGroup};
