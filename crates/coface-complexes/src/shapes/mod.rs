//! Shapes made by rule: curves, surfaces and solids as images of grids, with their vertices identified in closed form.
//!
//! # Words
//! * [`PlacedCells`] are simplices or cuboids of one dimension on one list of positions, what grids, shapes and products are
//!   before they become a model, a mesh or a chain complex. [`CellKind`] says which of the two, and with it the order of the
//!   vertices of a cell.
//! * A **shape** is the image of a grid. Where the map takes two grid points to one, they are one vertex from the start:
//!   no tolerance decides it. Cells that the map flattens, at poles, are left out; so there a shape has simplices only.
//!
//! # Conventions
//! Lengths are in one unit, positive, and checked. Numbers of subdivisions are the numbers of cells along an axis. Shapes that can be
//! oriented are oriented coherently: plane shapes counterclockwise, closed surfaces and sides of solids with the normal
//! outward, solids positive. Points around a circle are as symmetric as [`coface_geometry::Angle`] makes them.
//!
//! | curves | surfaces | solids |
//! |---|---|---|
//! | [`circle`], [`helix`] | [`disk`], [`ring`], [`helicoid`], [`cylinder`], [`cone`], [`sphere`], [`torus`], [`crown`], [`moebius`], [`klein_bottle`], [`klein_bottle_in_4d`], [`csaszar_torus`] | [`simplex`], [`cuboid`], [`ball`], [`rod`], [`solid_torus`], [`hollow_cylinder`], [`hollow_ball`], [`plate_with_holes`] |

mod assembly;
mod csaszar;
mod curves;
mod faces;
mod lattice;
mod layers;
mod placed_cells;
mod solids;
mod spheres;
mod surfaces;

pub use csaszar::csaszar_torus;
pub use curves::{circle, helix};
#[doc(hidden)]
pub use faces::turn_cell;
pub use placed_cells::{CellKind, PlacedCells};
pub use solids::{ball, cuboid, hollow_ball, hollow_cylinder, plate_with_holes, rod, simplex, solid_torus};
pub use spheres::{SphereGrid, sphere};
pub use surfaces::{
    DiskGrid, cone, crown, cylinder, disk, helicoid, klein_bottle, klein_bottle_in_4d, moebius, ring, torus,
};

pub use assembly::{Assembly, AssemblyPart, FlatAssembly};
