//! Complexes brought together: congruence of cells, what segments cut the plane into ([`planar`]) and faces cut space
//! into ([`spatial`]), and Boolean combinations of inputs on either ([`boolean`]).
//!
//! # Words and conventions
//! * Vertices are **congruent** when they are within a tolerance of each other, or joined by a chain of such vertices.
//!   A **class** is all that are congruent; classes are numbered by their lowest members.
//! * Cells are congruent when their boundaries, written in classes, are the same up to sign. Each cell has a **sign**
//!   against the lowest member of its class.
//! * The **quotient** complex has the classes as cells. A cell whose boundary vanishes in it is **collapsed**: it has
//!   no class.
//! * [`JoinedFeatures`] tell what a tolerance, or rounding, put together in the plane or in space.
//! * A cell that came to touch itself can be **wrapped again**: split into **pieces**, the cells that its boundary
//!   encloses. Its **image** is their sum.
//!
#![doc = include_str!("../README.md")]

pub mod boolean;
mod cells;
pub mod congruence;
mod face_cells;
mod near;
pub mod planar;
pub mod spatial;

pub use near::{CoordinatePrecision, JoinedFeatures, NearCounts};
