//! Tests of `coface-topology`, in one program: each test program links everything anew.

mod contract;
mod cubical_parts;
mod cup_products;
mod halfedge_homology;
mod known_spaces;
