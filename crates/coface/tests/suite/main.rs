//! Tests of the library as a whole, through its front door, in one program: each test program links everything anew.

mod alpha_complexes;
mod ball_cells;
mod grids;
#[path = "../../../coface-arrange/tests/suite/solids/mod.rs"]
mod solids;
mod spatial_arrangements;
mod spatial_cells;
mod spatial_cutting;
mod surface_editing;
mod surface_truth;
mod tolerance;
mod watching;
