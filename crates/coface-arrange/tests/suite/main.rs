//! Tests of `coface-arrange`, in one program: each test program links everything anew.

mod boolean_properties;
mod booleans;
mod congruence;
mod congruence_rewrap;
mod contract;
mod coplanar_triangles;
mod geometry_checks;
#[cfg(feature = "graphblas-tests")]
mod graphblas;
mod planar_arrangements;
mod planar_booleans;
mod planar_congruence;
mod planar_overlays;
mod planar_segments;
mod planar_tolerance;
mod polygon_validity;
mod reference;
mod selection_meshes;
mod solids;
mod spatial_congruence;
mod spatial_rooms;
mod spatial_triangles;
