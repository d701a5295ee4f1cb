//! Faces whose vertices, edges and insides that are nearer to each other than a tolerance become one.
//!
//! A **panel** is a face that is flat within the tolerance, by the chain of its sides; a polygon that is not is a panel
//! for each of its triangles. What is done to sides is done by [`NearChains`](crate::near::NearChains). In the end each
//! panel is a chain of triangles with the boundary that it has then.
//!
//! When nothing is near anything any more, vertices and sides are further apart than the tolerance, but for sides that
//! go through panels far from everything else: these are for the exact cut to find. Sides and vertices that lie on a
//! panel divide it, and each part is triangulated by its own sides alone, seen along the same axis whatever panel it
//! is part of: so panels that lie on each other have the same triangles there.

mod flats;
mod flips;
mod panels;
mod planes;

pub(super) use flats::flat_faces;
pub(super) use planes::flattened;
