//! What holds for all inputs: one function of bytes for each fuzz target.
//!
//! A **check** takes any bytes and panics where a promise is broken. The fuzz targets call the checks with bytes that the fuzzer makes up; the
//! test `corpora` calls them with every file of `fuzz/corpus`. A check either gives the bytes to a reader, or draws a small input of the right
//! structure from them (`arbitrary`) where most bytes would be refused at once.

#![allow(clippy::missing_panics_doc, reason = "a check panics where a promise is broken")]

mod arrangements;
mod certificates;
mod containers;
mod gluings;
mod models;
mod packed;
mod readers;
mod requests;
mod sets;
mod surfaces;
mod words;

pub use arrangements::{arrange_plane, arrange_space, boolean_plane, boolean_space};
pub use certificates::check_certificate;
pub use containers::{read_chains, read_container, read_manifest, read_reduced_shard, read_shard};
pub use gluings::glue_simplices;
pub use packed::{read_compressed, read_three_mf, read_vtk_appended};
pub use readers::{
    read_abaqus, read_amf, read_any, read_collada, read_geojson, read_gltf, read_isosig, read_json,
    read_lines, read_matrix_market, read_mesh, read_msh, read_nifti, read_npy, read_nrrd, read_obj, read_off,
    read_ply, read_points, read_stl, read_svg, read_tetgen, read_unknown, read_vtk, read_vtk_xml, read_wkt,
};
pub use requests::{ask_facets, ask_polygons, ask_voxels};
pub use sets::{boolean_yin, read_factories, read_yin_dat, read_yin_json};
pub use surfaces::{edit_halfedges, repair_mesh};
pub use words::parse_words;

/// A check: it returns where all is well.
pub type Check = fn(&[u8]);

/// All checks by the names of their fuzz targets, in alphabetical order.
pub const CHECKS: &[(&str, Check)] = &[
    ("arrange_plane", arrange_plane),
    ("arrange_space", arrange_space),
    ("ask_facets", ask_facets),
    ("ask_polygons", ask_polygons),
    ("ask_voxels", ask_voxels),
    ("boolean_plane", boolean_plane),
    ("boolean_space", boolean_space),
    ("boolean_yin", boolean_yin),
    ("check_certificate", check_certificate),
    ("edit_halfedges", edit_halfedges),
    ("glue_simplices", glue_simplices),
    ("parse_words", parse_words),
    ("read_abaqus", read_abaqus),
    ("read_amf", read_amf),
    ("read_any", read_any),
    ("read_chains", read_chains),
    ("read_collada", read_collada),
    ("read_compressed", read_compressed),
    ("read_container", read_container),
    ("read_factories", read_factories),
    ("read_geojson", read_geojson),
    ("read_gltf", read_gltf),
    ("read_isosig", read_isosig),
    ("read_json", read_json),
    ("read_lines", read_lines),
    ("read_manifest", read_manifest),
    ("read_matrix_market", read_matrix_market),
    ("read_mesh", read_mesh),
    ("read_msh", read_msh),
    ("read_nifti", read_nifti),
    ("read_npy", read_npy),
    ("read_nrrd", read_nrrd),
    ("read_obj", read_obj),
    ("read_off", read_off),
    ("read_ply", read_ply),
    ("read_points", read_points),
    ("read_reduced_shard", read_reduced_shard),
    ("read_shard", read_shard),
    ("read_stl", read_stl),
    ("read_svg", read_svg),
    ("read_tetgen", read_tetgen),
    ("read_three_mf", read_three_mf),
    ("read_unknown", read_unknown),
    ("read_vtk", read_vtk),
    ("read_vtk_appended", read_vtk_appended),
    ("read_vtk_xml", read_vtk_xml),
    ("read_wkt", read_wkt),
    ("read_yin_dat", read_yin_dat),
    ("read_yin_json", read_yin_json),
    ("repair_mesh", repair_mesh),
];
