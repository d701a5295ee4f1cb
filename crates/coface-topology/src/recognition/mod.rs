//! Recognition of groups: which well-known group a presentation gives, by proof or not at all; and of manifolds, whose links are told
//! from spheres by their groups.
//!
//! # Words and conventions
//! * A [`GroupName`] is a statement with a proof behind it: the group is isomorphic to the one of this name.
//! * Which group a presentation gives is undecidable in general.
//!   [`Presentation::recognized`](crate::groups::Presentation::recognized) works with a bounded
//!   [`Effort`](crate::groups::Effort), and `None` says nothing about the group.
//! * The group of a surface has a name always: [`SurfaceGroup::name`](crate::groups::SurfaceGroup::name).

mod finite_group;
mod group_name;
mod manifold;
mod metacyclic;
mod presentations;
mod rewriting;
mod surface_groups;

pub use group_name::GroupName;
pub use manifold::{gluing_manifold_verdict, manifold_verdict};
pub(crate) use metacyclic::{name_of_cyclic_product, name_of_inversion_product};
