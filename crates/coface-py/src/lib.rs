//! The Python package `coface`: the classes and primitives that its module `_coface` holds.
//!
//! No mathematics here: each file is a class or a question, and asks the library. Long work runs without the lock of the interpreter
//! ([`work`]), arrays look at memory of the library where its layout allows ([`memory`]), faults become exceptions ([`errors`]).
#![deny(unsafe_code)]

mod answer;
mod arrangement;
mod arrays;
mod batch;
mod certificates;
mod chain;
mod chain_complex;
mod complex;
mod congruence;
mod cures;
mod dissolve;
mod errors;
mod generate;
mod graph;
mod grids;
mod homology;
mod homology_facts;
mod incidence;
mod json;
mod maps;
mod memory;
mod model;
mod objects;
mod persistence;
mod pi1;
mod pictures;
mod products;
mod report;
mod shards;
mod source;
mod surface;
mod view;
mod volumes;
mod work;
mod yin;

use pyo3::prelude::*;

/// The part of the package that is written in Rust.
#[pymodule]
fn _coface(module: &Bound<'_, PyModule>) -> PyResult<()> {
    work::remember_process();
    coface::algebra::memory::measure_by(coface_allocator::free_memory);
    errors::add(module)?;
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add_class::<memory::Memory>()?;
    module.add_class::<model::Model>()?;
    module.add_function(wrap_pyfunction!(errors::_in_python, module)?)?;
    module.add_class::<report::Report>()?;
    module.add_function(wrap_pyfunction!(report::_report, module)?)?;
    module.add_class::<complex::Complex>()?;
    module.add_class::<complex::Simplices>()?;
    module.add_class::<complex::PyVerdict>()?;
    module.add_class::<chain_complex::ChainComplex>()?;
    module.add_class::<homology::Homology>()?;
    module.add_class::<homology::HomologyGroup>()?;
    module.add_class::<chain::Generator>()?;
    module.add_class::<chain::Chain>()?;
    module.add_class::<surface::Surface>()?;
    module.add_class::<surface::Domain>()?;
    module.add_class::<surface::Cover>()?;
    module.add_class::<surface::Cocycles>()?;
    module.add_class::<pi1::FundamentalGroup>()?;
    module.add_function(wrap_pyfunction!(certificates::_certificate, module)?)?;
    module.add_function(wrap_pyfunction!(certificates::_drawing_certificate, module)?)?;
    module.add_function(wrap_pyfunction!(certificates::_check, module)?)?;
    module.add_function(wrap_pyfunction!(surface::_surface, module)?)?;
    module.add_function(wrap_pyfunction!(pi1::fundamental_groups, module)?)?;
    module.add_function(wrap_pyfunction!(pi1::_group, module)?)?;
    module.add_class::<persistence::Persistence>()?;
    module.add_class::<incidence::LarModel>()?;
    module.add_class::<congruence::Congruence>()?;
    module.add_class::<arrangement::PlanarArrangement>()?;
    module.add_class::<arrangement::PlanarBoolean>()?;
    module.add_class::<arrangement::SpatialArrangement>()?;
    module.add_class::<arrangement::SolidBooleanResult>()?;
    module.add_class::<yin::Curve>()?;
    module.add_class::<yin::YinSet>()?;
    module.add_class::<yin::Kinks>()?;
    module.add_class::<yin::CutCells>()?;
    module.add_class::<yin::Interface>()?;
    module.add_function(wrap_pyfunction!(yin::_interface, module)?)?;
    module.add_function(wrap_pyfunction!(yin::_label_sets, module)?)?;
    module.add_function(wrap_pyfunction!(yin::_feature_sets, module)?)?;
    module.add_function(wrap_pyfunction!(persistence::persistence, module)?)?;
    module.add_function(wrap_pyfunction!(persistence::rips, module)?)?;
    module.add_function(wrap_pyfunction!(persistence::cubical, module)?)?;
    module.add_function(wrap_pyfunction!(persistence::_values_of_volume, module)?)?;
    module.add_function(wrap_pyfunction!(congruence::congruence, module)?)?;
    module.add_function(wrap_pyfunction!(arrangement::arrange, module)?)?;
    module.add_function(wrap_pyfunction!(arrangement::boolean, module)?)?;
    module.add_function(wrap_pyfunction!(dissolve::dissolve, module)?)?;
    module.add_function(wrap_pyfunction!(maps::map_task, module)?)?;
    module.add_function(wrap_pyfunction!(graph::graphml, module)?)?;
    module.add_function(wrap_pyfunction!(yin::_curve, module)?)?;
    module.add_function(wrap_pyfunction!(yin::_yin_set, module)?)?;
    module.add_function(wrap_pyfunction!(products::classes, module)?)?;
    module.add_function(wrap_pyfunction!(products::harmonic, module)?)?;
    module.add_function(wrap_pyfunction!(products::decompose, module)?)?;
    module.add_function(wrap_pyfunction!(products::laplacian, module)?)?;
    module.add_function(wrap_pyfunction!(products::matching, module)?)?;
    module.add_function(wrap_pyfunction!(products::invariant_factors, module)?)?;
    module.add_function(wrap_pyfunction!(products::cup_products, module)?)?;
    module.add_function(wrap_pyfunction!(products::intersection_form, module)?)?;
    module.add_function(wrap_pyfunction!(products::long_exact_sequence, module)?)?;
    module.add_function(wrap_pyfunction!(products::induced_map, module)?)?;
    module.add_function(wrap_pyfunction!(products::is_exact, module)?)?;
    module.add_class::<grids::CuboidGrid>()?;
    module.add_class::<grids::SimplicialGrid>()?;
    module.add_function(wrap_pyfunction!(grids::extruded, module)?)?;
    module.add_function(wrap_pyfunction!(grids::product, module)?)?;
    module.add_function(wrap_pyfunction!(pictures::render, module)?)?;
    module.add_function(wrap_pyfunction!(pictures::matrix_svg, module)?)?;
    module.add_function(wrap_pyfunction!(pictures::_matrix_picture, module)?)?;
    module.add_function(wrap_pyfunction!(model::read, module)?)?;
    module.add_function(wrap_pyfunction!(model::entries, module)?)?;
    module.add_function(wrap_pyfunction!(model::_model, module)?)?;
    module.add_function(wrap_pyfunction!(chain_complex::_chains, module)?)?;
    module.add_function(wrap_pyfunction!(generate::generate, module)?)?;
    module.add_function(wrap_pyfunction!(generate::families, module)?)?;
    module.add_function(wrap_pyfunction!(view::_page, module)?)?;
    module.add_function(wrap_pyfunction!(volumes::_volume, module)?)?;
    module.add_function(wrap_pyfunction!(volumes::_read_volume, module)?)?;
    module.add_function(wrap_pyfunction!(batch::_batch_lines, module)?)?;
    module.add_function(wrap_pyfunction!(batch::_batch_write, module)?)?;
    module.add_function(wrap_pyfunction!(batch::_table_of_lines, module)?)?;
    module.add_function(wrap_pyfunction!(batch::_signatures_write, module)?)?;
    module.add_class::<batch::_SignatureRows>()?;
    module.add_function(wrap_pyfunction!(batch::_replace_file, module)?)?;
    module.add_function(wrap_pyfunction!(batch::_copy_file, module)?)?;
    module.add_function(wrap_pyfunction!(batch::_find_files, module)?)?;
    module.add_function(wrap_pyfunction!(batch::_flat_line, module)?)?;
    module.add_function(wrap_pyfunction!(batch::_serve, module)?)?;
    module.add_function(wrap_pyfunction!(shards::_shard, module)?)?;
    module.add_function(wrap_pyfunction!(shards::_reduce, module)?)?;
    module.add_function(wrap_pyfunction!(shards::_merge, module)?)?;
    module.add_function(wrap_pyfunction!(shards::_summary, module)?)?;
    module.add_function(wrap_pyfunction!(shards::_root_homology, module)?)?;
    module.add_function(wrap_pyfunction!(shards::_folder_homology, module)?)?;
    // What is public is for the package to say.
    module.delattr("__all__")?;
    Ok(())
}
