//! Families of models by name: the shapes with positions and the known spaces, with their parameters.
//!
//! A [`Family`] is a row of one table: a name, what it is, its parameters with their usual values, and how it is made. Programs and
//! packages that let people ask for a shape by its name read this table, so that the names, the usual values and the limits are the same
//! everywhere.
//!
//! # Words
//! * A **parameter** has a name, a meaning and a [`ParameterKind`], which says what it takes and its usual value.
//! * A **value** is what somebody gives for a parameter. Parameters that are not given have their usual values.
//! * What is **made** is a [`FamilyModel`]: cells with positions, or a complex without them.

mod family;
mod given;
mod made;
mod parameter;
mod shape_table;
mod space_table;

pub use family::Family;
pub use made::FamilyModel;
pub use parameter::{Parameter, ParameterKind, ParameterValue};
