//! Triangulated 3-manifolds: their names, by proof, and smaller triangulations of them.
//!
//! # Words
//! * A [`SpaceName`] says which 3-manifold a triangulation is, up to homeomorphism that may reverse orientation; a [`NamedSpace`] has it with
//!   the [`SpaceProof`] that it rests on.
//! * A [`SeifertSpace`] is a union of circles, by its base surface and the invariants of its exceptional circles.
//! * A [`GraphSpace`] is made of one or two such pieces, glued along a torus on which their fibers do not agree; a [`TorusBundle`] is given by what a
//!   walk around its circle does to a torus.
//! * A [`GluingMove`] puts other tetrahedra in a ball with the same boundary; a [`GluingSimplification`] is a chain of them.
//!
//! No name says nothing about the space.

mod by_group;
mod fibered;
mod graph;
mod layered;
mod moves;
mod name;
mod normal_surfaces;
mod recognition;
mod seifert;
mod simplification;
mod stacks;
mod standard_groups;
mod summands;

pub use graph::{GraphSpace, TorusBundle};
pub use moves::{GluingMove, moved};
pub use name::{NamedSpace, SpaceName, SpaceProof};
pub use recognition::named_space;
pub use seifert::SeifertSpace;
pub use simplification::{GluingSimplification, simplified, simplified_until};
