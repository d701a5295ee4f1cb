//! Questions that any chain complex can be asked, wherever its cells came from.
//!
//! # Words and conventions
//! * **Homology** in degree k: the cycles of degree k modulo the boundaries of (k+1)-chains. Over Z it is a finitely
//!   generated abelian group, [`AbelianGroup`]: its rank is the **Betti number**, its finite part the **torsion**.
//! * [`homology`] answers over Z; [`homology_with`] and [`cohomology`] over Z, Q or Z/n, by the universal coefficient
//!   theorem.
//! * A [`HomologyBasis`] has cycles on the original cells, one for each cyclic summand, the dual cocycles, the class of
//!   any cycle and the chain that it bounds, if it does. [`generators`] gives the cycles alone.
//! * A [`SurfaceGroup`] puts loops on surfaces in normal form, so that homotopy is decided.
//! * [`harmonic_basis`] and [`HodgeSpace`] take real coefficients: Laplacians, harmonic cochains, Hodge decomposition.
//! * [`persistence`] says over a prime field when the classes of a growing complex are born and die.
//! * The **cup product** of cochains is that of a [`CochainAlgebra`]; on a closed oriented manifold it gives the
//!   [`intersection_form`].
//! * A [`TreeCotree`] of a surface gives loops; cut along them, in a [`CutSurface`], each component is a disk, its
//!   [`FundamentalDomain`], whose boundary spells the relator of the fundamental group.
//! * All answers about one complex go through the acyclic matching of [`coface_algebra::chains::MorseComplex`], then Smith normal form.
//!
#![doc = include_str!("../README.md")]

mod covering;
mod hodge;
mod persistence;

pub use covering::{CoverExtent, CoverLayout, CoverPlane, UniversalCover};
pub use hodge::{
    HarmonicCochain, HodgeDecomposition, HodgeSpace, MetricComplex, harmonic_basis, laplacian_matrix,
};
pub use persistence::{Filtration, PersistenceDiagram, PersistencePair, persistence};

mod curves;

pub use curves::{
    ClosedWalk, CocycleBasis, CutGraph, CutSurface, CycleKind, EdgeRole, Exactness, FundamentalDomain,
    HarmonicForm, Seam, SeamKind, ShortestCycle, Slicing, SurfaceHomology, SurfaceHomotopy, TreeCotree,
    TreeCotreeComponent, cotangent_weights, exactness, exactness_within, harmonic_forms, intersection_number,
    shortest_cycle, shortest_cycle_through, shortest_homology_basis, shortest_loops, slicing_cocycle,
};

mod groups;
pub use groups::{
    Ball, CanonicalSystem, ConjugacyForm, CosetTable, EdgePathGroups, Effort, HomomorphismCount, NormalForm,
    PermutationGroup, Presentation, Simplification, SubgroupClass, SurfaceGroup, TietzeMove,
};

mod recognition;
pub use recognition::GroupName;

mod homology;
#[doc(hidden)]
pub use homology::reduced_generators;
pub use homology::{
    AbelianGroup, Bounding, CochainAlgebra, Cocycle, Coefficients, CupProductTable, Generator, Homology,
    HomologyBasis, HomologyClass, HomologyMap, IntersectionForm, LongExactSequence, MiddlePairing,
    cohomology, cup_product_table, generators, generators_of_parts, homology, homology_with, induced_maps,
    intersection_form,
};
