//! Fundamental groups: presentations of edge-path groups, and normal forms in the groups of surfaces.

mod fundamental;
mod surface_group;

pub use fundamental::{
    CosetTable, EdgePathGroups, Effort, HomomorphismCount, PermutationGroup, Presentation, Simplification,
    SubgroupClass, TietzeMove,
};
pub use surface_group::{Ball, CanonicalSystem, ConjugacyForm, NormalForm, SurfaceGroup};
