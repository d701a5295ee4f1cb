//! Models again, from what pickles hold.

use super::Model;
use super::cells::{kind_of, shape_word};
use crate::arrays;
use crate::chain_complex::ChainComplex;
use crate::errors::{OrRaise, invalid};
use crate::source::{Names, Naming};
use crate::volumes::_volume;
use coface::VertexId;
use coface::algebra::RaggedArray;
use coface::algebra::chains::ChainRefinement;
use coface::complexes::cell_mesh::CellShape;
use coface::complexes::gluing::GluingTable;
use coface::complexes::surface::HalfedgePermutations;
use coface::geometry::Positions;
use coface::io;
use coface::io::{Group, Structure};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};
use std::sync::Arc;

/// Makes a model again from what :meth:`Model.__reduce__` gave.
#[pyfunction]
pub(crate) fn _model(py: Python<'_>, parts: &Bound<'_, PyDict>) -> PyResult<Model> {
    let field = |name: &str| -> PyResult<Bound<'_, PyAny>> {
        parts
            .get_item(name)?
            .ok_or_else(|| invalid(py, format!("there is no {name}"), "pickle the model again"))
    };
    let vertices = field("vertices")?;
    let given = if vertices.is_none() { None } else { Some(arrays::reals(&vertices, "vertices")?) };
    // Coordinates of a file need not be finite.
    let partial = given.filter(|(_, values)| !values.iter().all(|x| x.is_finite()));
    let positions = match (&partial, vertices.is_none()) {
        (None, false) => arrays::positions(&vertices, "vertices")?,
        _ => Positions::default(),
    };
    let mut model = if let Some(facets) = parts.get_item("facets")? {
        io::Model::from_structure(Structure::Facets(arrays::lists(&facets, "facets")?))
    } else if let Some(pair) = parts.get_item("halfedges")? {
        let next = arrays::ids(&pair.get_item(0)?, "next")?;
        let twin = arrays::ids(&pair.get_item(1)?, "twin")?;
        let outer = match parts.get_item("outer")? {
            Some(outer) => arrays::ids(&outer, "outer")?,
            None => Vec::new(),
        };
        let permutations = HalfedgePermutations::new(next, twin, outer).or_raise(py)?;
        io::Model::from_halfedges(permutations, positions).or_raise(py)?
    } else if let Some(rows) = parts.get_item("gluings")? {
        let rows: Vec<Vec<Option<(u32, Vec<u32>)>>> = rows.extract()?;
        io::Model::from_structure(Structure::Gluings(GluingTable::from_rows(&rows).or_raise(py)?))
    } else if let Some(voxels) = parts.get_item("voxels")? {
        let (voxels, periodic) = voxels.extract()?;
        _volume(py, voxels, periodic)?.model().clone()
    } else if let Some(complex) = parts.get_item("chains")? {
        let complex = complex.cast::<ChainComplex>()?.get().complex.as_ref().clone();
        let made = if positions.is_empty() {
            io::Model::from_structure(Structure::Chains(complex))
        } else {
            io::Model::from_chains(complex, positions).or_raise(py)?
        };
        match parts.get_item("pieces_of")? {
            Some(pieces) => made.with_refinement(ChainRefinement::new(pieces.extract()?)).or_raise(py)?,
            None => made,
        }
    } else {
        let words: Vec<String> = field("shapes")?.extract()?;
        let shape = |word: &String| CellShape::ALL.into_iter().find(|&shape| shape_word(shape) == word);
        let shapes: Option<Vec<CellShape>> = words.iter().map(shape).collect();
        let shapes = shapes.ok_or_else(|| invalid(py, "a shape is unknown", "pickle the model again"))?;
        let points = arrays::ids(&field("points")?, "points")?;
        io::Model::from_parts(
            field("vertex_count")?.extract()?,
            positions,
            arrays::lists(&field("faces")?, "faces")?,
            (shapes, arrays::lists(&field("cells")?, "cells")?),
            arrays::lists(&field("lines")?, "lines")?,
            points.into_iter().map(|vertex| VertexId::new(vertex as usize)).collect(),
        )
        .or_raise(py)?
    };
    if let Some((shape, values)) = partial {
        model = model.with_coordinates(shape.last().copied().unwrap_or(0), values).or_raise(py)?;
    }
    if let Some(crs) = parts.get_item("crs")? {
        let system = io::ReferenceSystem::from_crs(&crs.extract::<String>()?).or_raise(py)?;
        model = model.with_reference_system(system);
    }
    if let Some(format) = parts.get_item("format")? {
        model = model.with_format(io::Format::from_name(&format.extract::<String>()?).or_raise(py)?);
    }
    for group in field("groups")?.try_iter()? {
        let (name, kind, members): (String, String, Bound<'_, PyAny>) = group?.extract()?;
        let group = Group::new(name, kind_of(py, &kind)?, arrays::ids(&members, "members")?);
        model = model.with_group(group).or_raise(py)?;
    }
    if let Some(text) = parts.get_item("exact")? {
        model = io::json::with_exact_keys(model, text.extract::<String>()?.as_bytes()).or_raise(py)?;
    }
    if let Some(text) = parts.get_item("kept")? {
        model = model.with_kept(&text.extract::<String>()?).or_raise(py)?;
    }
    let mut model = Model::of(model);
    for data in field("data")?.try_iter()? {
        let (name, kind, values): (String, String, Bound<'_, PyAny>) = data?.extract()?;
        model = model.with_data(py, &name, &values, &kind)?;
    }
    Ok(model)
}

/// Lists as (flat, offsets), on memory of their own.
pub(super) fn pair<'py>(py: Python<'py>, lists: &RaggedArray) -> PyResult<Bound<'py, PyTuple>> {
    let offsets = (0..=lists.len()).map(|i| lists.start(i) as i64).collect();
    let flat = PyArray1::from_slice(py, lists.items());
    PyTuple::new(py, [flat.into_any(), PyArray1::from_vec(py, offsets).into_any()])
}

/// What a pickle of a model holds: arrays by name.
pub(super) fn parts<'py>(py: Python<'py>, model_of: &Model) -> PyResult<Bound<'py, PyDict>> {
    let model = model_of.model();
    let parts = PyDict::new(py);
    match model.structure() {
        Some(Structure::Facets(facets)) => {
            parts.set_item("facets", pair(py, facets)?)?;
        }
        Some(Structure::Halfedges { outer, .. }) => {
            parts.set_item("halfedges", model_of.halfedges(py)?)?;
            if !outer.is_empty() {
                parts.set_item("outer", arrays::id_array(py, outer.iter().copied()))?;
            }
        }
        Some(Structure::Gluings(_)) => parts.set_item("gluings", model_of.gluings())?,
        Some(Structure::Volume(_)) => parts.set_item("voxels", model_of.voxels(py)?)?,
        Some(Structure::Chains(complex)) => {
            let complex = ChainComplex::new(Arc::new(complex.clone()), Naming::of(Names::Own));
            parts.set_item("chains", complex)?;
            if let Some(refinement) = model.refinement() {
                let pieces = (0..refinement.degree_count())
                    .map(|degree| refinement.pieces(degree).collect::<Vec<_>>());
                parts.set_item("pieces_of", pieces.collect::<Vec<_>>())?;
            }
        }
        _ => {
            parts.set_item("vertex_count", model.vertex_count())?;
            parts.set_item("faces", pair(py, model.polygons())?)?;
            parts.set_item(
                "shapes",
                model.shapes().iter().map(|&shape| shape_word(shape)).collect::<Vec<_>>(),
            )?;
            parts.set_item("cells", pair(py, model.cells())?)?;
            parts.set_item("lines", pair(py, model.lines())?)?;
            parts.set_item("points", model_of.points(py))?;
        }
    }
    let is_volume = matches!(model.structure(), Some(Structure::Volume(_)));
    parts.set_item("vertices", if is_volume { None } else { model_of.vertices(py)? })?;
    if let Some(system) = model.reference_system() {
        parts.set_item("crs", system.crs())?;
    }
    if let Some(format) = model.format() {
        parts.set_item("format", format.name())?;
    }
    if let Some(text) = io::json::exact_keys(model).or_raise(py)? {
        parts.set_item("exact", text)?;
    }
    parts.set_item("groups", model_of.groups(py))?;
    parts.set_item("kept", model.kept())?;
    parts.set_item("data", model_of.data(py)?)?;
    Ok(parts)
}
