//! Questions that a chain complex or a surface can be asked: homology, fundamental groups, cuts, covers and short
//! loops.
//!
//! This crate belongs to the library `coface`. It knows chain complexes and surfaces, but no file formats.
//!
//! # Sections
//! * **Homology**: [`homology`] gives the groups over Z, [`homology_with`] and [`cohomology`] over Z, Q or Z/n. A
//!   [`HomologyBasis`] has cycles on the original cells, the dual cocycles, the class of any cycle and the chain that
//!   it bounds. [`induced_maps`], a [`LongExactSequence`], [`cup_product_table`] and [`intersection_form`] are built
//!   on it.
//! * **Hodge theory**: a [`MetricComplex`] is a complex with weights. A [`HodgeSpace`] decomposes real cochains into
//!   exact, coexact and harmonic parts; [`harmonic_basis`] has one harmonic cochain for each free class.
//! * **Persistence**: [`persistence`] reports over a prime field when the classes of a [`Filtration`] are born and die, and a
//!   [`RipsFiltration`] those of points with [`Distances`](coface_complexes::filtered::Distances), an [`ImageFiltration`] those of an image. A
//!   [`Barcode`] compares diagrams and makes them curves and images.
//! * **Groups**: [`EdgePathGroups`] presents fundamental groups, a [`Simplification`] shortens presentations, and a
//!   [`SurfaceGroup`] has normal forms that decide homotopy.
//! * **Recognition**: [`Presentation::recognized`] names a group, as a [`GroupName`], if it can prove which one it is.
//! * **Curves on surfaces**: a [`TreeCotree`] gives loops that generate the fundamental group. A [`CutSurface`] cuts
//!   each component open into a disk, its [`FundamentalDomain`]. [`shortest_cycle`], [`shortest_loops`] and
//!   [`shortest_homology_basis`] find short curves.
//! * **Covers**: a [`UniversalCover`] is a finite part of the universal covering space, with a [`CoverLayout`] to
//!   draw it.
//!
//! # Conventions
//! * Homology in degree k is the group of k-cycles modulo boundaries. Exact answers carry certificates: a bounding
//!   chain, a pairing cocycle, or the least multiple of a cycle that bounds.
//! * A **step** along an edge is a number: 2e runs along edge e, 2e + 1 runs against it.
//! * All answers about one complex use the acyclic matching of [`coface_algebra::chains::MorseComplex`], then the Smith
//!   normal form of what the matching leaves.
//! * Only harmonic cochains, harmonic forms and layouts use floating point. It decides no topology.
//!
//! # Examples
//! The torus as one vertex, two loops and one square.
//! ```
//! use coface_algebra::SparseMatrix;
//! use coface_algebra::chains::ChainComplex;
//! use coface_topology::homology;
//! # fn main() -> Result<(), coface_algebra::Error> {
//! let torus = ChainComplex::new(vec![SparseMatrix::zero(1, 2)?, SparseMatrix::zero(2, 1)?])?;
//! assert_eq!(homology(&torus).betti_numbers(), [1, 2, 1]);
//! # Ok(()) }
//! ```

#![warn(clippy::iter_over_hash_type, missing_debug_implementations)]

mod covering;
mod hodge;
mod persistence;

pub use covering::{CoverExtent, CoverLayout, CoverPlane, UniversalCover};
pub use hodge::{
    HarmonicCochain, HodgeDecomposition, HodgeSpace, MetricComplex, harmonic_basis, laplacian_matrix,
};
pub use persistence::{
    Barcode, BarcodeMatching, CubeTerms, EulerCurve, EulerTransform, ExtendedKind, ExtendedPair, Filtration,
    ImageBlocks, ImageConstruction, ImageCycle, ImageCycles, ImageDiagram, ImageFiltration, ImagePair,
    ImagePart, PersistenceDiagram, PersistencePair, PersistenceSurface, PersistentCycle, RipsCochain,
    RipsDiagram, RipsFiltration, RipsPair, RipsSize, Vine, VinePoint, ZigzagFiltration, ZigzagPair,
    ZigzagStep, euler_characteristic_curve, even_directions, extended_filtration, extended_persistence,
    image_persistence, persistence, persistent_cycles, relative_persistence, torsion_primes, vineyard,
};

mod curves;

pub use curves::{
    CanonicalComponent, CanonicalCurve, CanonicalCut, Carrier, ClosedWalk, CocycleBasis, CurveKind, CutGraph,
    CutSurface, CycleBounds, CycleKind, EdgeRole, Exactness, FundamentalDomain, HandleKind, HandlePair,
    HarmonicForm, PolygonPlane, Refinement, Seam, SeamKind, ShortHandleLoops, ShortestCycle, Slicing,
    SurfaceHomology, SurfaceHomotopy, TreeCotree, TreeCotreeComponent, cotangent_weights, exactness,
    exactness_within, handle_pairs, harmonic_forms, intersection_number, short_handle_loops, shortest_cycle,
    shortest_cycle_through, shortest_cycle_until, shortest_homology_basis, shortest_loops, slicing_cocycle,
};

mod groups;
pub use groups::{
    Ball, CanonicalSystem, ConjugacyForm, CosetTable, EdgePathGroups, Effort, HomomorphismCount, NormalForm,
    PermutationGroup, Presentation, Simplification, SubgroupClass, SurfaceGroup, TietzeMove,
};

mod three_manifolds;
pub use three_manifolds::{
    GluingMove, GluingSimplification, GraphSpace, NamedSpace, SeifertSpace, SpaceName, SpaceProof,
    TorusBundle, moved, named_space, simplified, simplified_until,
};

mod recognition;
pub use recognition::{GroupName, gluing_manifold_verdict, manifold_verdict};

mod homology;
#[doc(hidden)]
pub use homology::reduced_generators;
pub use homology::{
    AbelianGroup, Bounding, CochainAlgebra, Cocycle, Coefficients, CupProductTable, Generator, Homology,
    HomologyBasis, HomologyClass, HomologyMap, IntersectionForm, LongExactSequence, MiddlePairing,
    cohomology, cup_product_table, generators, generators_of_parts, homology, homology_of_parts,
    homology_with, induced_maps, intersection_form,
};
