//! Tests of `coface-answers`, in one program: each test program links everything anew.

mod certificates;
mod certificates_of_points;
mod certificates_of_walks;
mod covering;
mod exact_chains;
mod exact_drawings;
mod fundamental_groups;
mod geometry;
mod gluings;
mod harmonic;
mod image_cycles;
mod lar;
mod many_solids;
mod planar_drawings;
mod planar_files;
mod planar_properties;
mod planar_rounding;
mod repairs;
mod rounded_chains;
mod rounded_tubes;
#[cfg(feature = "schema")]
mod schema;
mod shapes;
mod solid_booleans;
mod spatial_inputs;
mod surface_curves;
mod turned_boxes;
mod verdicts;
mod volumes;
mod yin_interface_places;
mod yin_partitions;
