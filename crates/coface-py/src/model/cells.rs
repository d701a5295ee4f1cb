//! Cells by kind, as users give them.

use crate::arrays;
use crate::errors::{self, invalid};
use crate::memory::shared_ids;
use coface::algebra::RaggedArray;
use coface::complexes::cell_mesh::CellShape;
use coface::geometry::Positions;
use coface::io;
use coface::io::{GroupKind, ReferenceSystem, Structure};
use coface::{Error, VertexId};
use numpy::{PyArray1, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::borrow::Cow;

/// What users give as cells by kind.
#[derive(Default)]
pub(super) struct Parts {
    pub(super) polygons: Vec<RaggedArray>,
    pub(super) shapes: Vec<CellShape>,
    pub(super) cells: Vec<RaggedArray>,
    pub(super) lines: Vec<RaggedArray>,
    pub(super) points: Vec<VertexId>,
}

impl Parts {
    pub(super) fn add(&mut self, kind: &str, value: &Bound<'_, PyAny>) -> PyResult<()> {
        let py = value.py();
        let lists = arrays::lists(value, kind)?;
        let shape = match kind {
            "vertex" => {
                self.points.extend(lists.items().iter().map(|&vertex| VertexId::new(vertex as usize)));
                return Ok(());
            }
            "line" | "polyline" => {
                self.lines.push(lists);
                return Ok(());
            }
            "triangle" | "quad" | "polygon" => {
                let sides = match kind {
                    "triangle" => Some(3),
                    "quad" => Some(4),
                    _ => None,
                };
                if let Some(list) = lists.iter().find(|list| sides.is_some_and(|sides| list.len() != sides)) {
                    let message = format!("the {kind} {list:?} has {} corners", list.len());
                    return Err(invalid(py, message, "call it a polygon"));
                }
                self.polygons.push(lists);
                return Ok(());
            }
            "tetra" | "tetrahedron" => CellShape::Tetrahedron,
            "hexahedron" => CellShape::Hexahedron,
            "wedge" => CellShape::Wedge,
            "pyramid" => CellShape::Pyramid,
            _ => {
                return Err(invalid(
                    py,
                    format!("{kind:?} is no kind of cells known here"),
                    "give vertex, line, triangle, quad, polygon, tetra, hexahedron, wedge or pyramid",
                ));
            }
        };
        self.shapes.extend(std::iter::repeat_n(shape, lists.len()));
        self.cells.push(lists);
        Ok(())
    }
}

/// Lists one after the other.
fn joined(mut lists: Vec<RaggedArray>) -> RaggedArray {
    match lists.len() {
        0 => RaggedArray::new(),
        1 => lists.remove(0),
        _ => RaggedArray::from_lists(lists.iter().flat_map(RaggedArray::iter)),
    }
}

pub(super) fn model_of_parts(
    positions: Option<Positions>,
    parts: Parts,
    least: usize,
) -> Result<io::Model, Error> {
    let (polygons, cells, lines) = (joined(parts.polygons), joined(parts.cells), joined(parts.lines));
    let highest = [&polygons, &cells, &lines].into_iter().flat_map(|lists| lists.items().iter().max()).max();
    let of_points = parts.points.iter().map(|vertex| vertex.index() + 1).max().unwrap_or(0);
    let count = match &positions {
        Some(positions) => positions.len(),
        None => highest.map_or(0, |&vertex| vertex as usize + 1).max(of_points).max(least),
    };
    io::Model::from_parts(
        count,
        positions.unwrap_or_default(),
        polygons,
        (parts.shapes, cells),
        lines,
        parts.points,
    )
}

/// Refuses rows of four vertices that are tetrahedra: most of their points are far from one plane, and two rows have three vertices in
/// common. Where no rows have, a warning says what is assumed.
pub(super) fn refuse_tetrahedra(
    py: Python<'_>,
    positions: Option<&Positions>,
    faces: &RaggedArray,
) -> PyResult<()> {
    let Some(positions) = positions.filter(|positions| positions.dimension() == 3) else { return Ok(()) };
    let is_row = |list: &[u32]| list.len() == 4 && list.iter().all(|&id| (id as usize) < positions.len());
    if faces.is_empty() || !faces.iter().all(is_row) {
        return Ok(());
    }
    let bent = faces.iter().filter(|list| steepness(positions, list) > BENT).count();
    if 2 * bent <= faces.len() {
        return Ok(());
    }
    let mut triples: Vec<[u32; 3]> = Vec::with_capacity(4 * faces.len());
    for list in faces.iter() {
        for left_out in 0..4 {
            let mut triple = [1, 2, 3].map(|step| list[(left_out + step) % 4]);
            triple.sort_unstable();
            triples.push(triple);
        }
    }
    triples.sort_unstable();
    let is_shared = triples.windows(2).any(|pair| pair[0] == pair[1]);
    let steep = faces.iter().filter(|list| steepness(positions, list) > STEEP).count();
    if !is_shared {
        return match 2 * steep > faces.len() {
            true => errors::warn(
                py,
                "rows of 4 vertices that are far from flat are read as quadrangles: tetrahedra are cells={\"tetra\": rows}, quadrangles cells={\"quad\": rows}",
            ),
            false => Ok(()),
        };
    }
    let first = faces.iter().find(|list| steepness(positions, list) > BENT).unwrap_or_default();
    let message = format!(
        "faces has rows of 4 vertices that may be tetrahedra or quadrangles: {bent} of {} are far from flat, the first one {first:?}, and rows have three vertices in common",
        faces.len()
    );
    let cure =
        "say which: coface.Model.from_arrays(vertices, cells={\"tetra\": rows}) or cells={\"quad\": rows}";
    Err(invalid(py, message, cure))
}

/// Rows, more than half of which are farther from flat than this, are no quadrangles if they share triangles.
const BENT: f64 = 0.02;
/// The same for a warning where they share none.
const STEEP: f64 = 0.3;

/// How far four points are from one plane: the volume of the parallelepiped of three edges, divided by the product of their lengths.
fn steepness(positions: &Positions, list: &[u32]) -> f64 {
    let point = |corner: usize| positions.point(VertexId::from_u32(list[corner]));
    let origin = point(0);
    let edge = |corner: usize| [0, 1, 2].map(|axis| point(corner)[axis] - origin[axis]);
    let [a, b, c] = [edge(1), edge(2), edge(3)];
    let cross = [b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]];
    let volume: f64 = a.iter().zip(cross).map(|(x, y)| x * y).sum();
    let lengths: f64 = [a, b, c].iter().map(|edge| edge.iter().map(|x| x * x).sum::<f64>().sqrt()).product();
    if lengths > 0.0 { volume.abs() / lengths } else { 0.0 }
}

/// The name of a kind of things in Python's words.
pub(super) fn kind_of(py: Python<'_>, word: &str) -> PyResult<GroupKind> {
    Ok(match word {
        "vertices" => GroupKind::Vertices,
        "lines" => GroupKind::Lines,
        "faces" | "polygons" => GroupKind::Polygons,
        "cells" => GroupKind::Cells,
        _ => {
            return Err(invalid(
                py,
                format!("{word:?} is no kind of cells"),
                "give vertices, lines, faces or cells",
            ));
        }
    })
}

pub(super) fn kind_word(kind: GroupKind) -> &'static str {
    match kind {
        GroupKind::Vertices => "vertices",
        GroupKind::Lines => "lines",
        GroupKind::Polygons => "faces",
        GroupKind::Cells => "cells",
    }
}

/// The word of what a model holds instead of vertices and cells.
pub(super) fn structure_word(structure: &Structure) -> &'static str {
    match structure {
        Structure::Facets(_) => "facets",
        Structure::Halfedges { .. } => "halfedges",
        Structure::Chains(_) => "chains",
        Structure::Gluings(_) => "gluings",
        Structure::Volume(_) => "volume",
    }
}

/// The name of a shape as meshio has it.
pub(super) fn shape_word(shape: CellShape) -> &'static str {
    match shape {
        CellShape::Tetrahedron => "tetra",
        CellShape::Hexahedron => "hexahedron",
        CellShape::Wedge => "wedge",
        CellShape::Pyramid => "pyramid",
    }
}

/// The facets of a model of facets.
pub(super) fn facets_of(model: &io::Model) -> &RaggedArray {
    match model.structure() {
        Some(Structure::Facets(facets)) => facets,
        _ => model.lines(),
    }
}

/// The permutations `next` and `twin` of a model of halfedges.
pub(super) fn permutations_of(model: &io::Model) -> [&[u32]; 2] {
    match model.structure() {
        Some(Structure::Halfedges { next, twin, .. }) => [next, twin],
        _ => [&[], &[]],
    }
}

/// The length of all lists, if they have one.
pub(super) fn common_length(lists: &RaggedArray) -> Option<usize> {
    let length = lists.iter().next()?.len();
    lists.iter().all(|list| list.len() == length).then_some(length)
}

impl super::Model {
    /// Lists as an array that shares memory where all have one length, else as (flat, offsets), of which flat does.
    pub(super) fn lists<'py>(
        &self,
        py: Python<'py>,
        lists: impl for<'a> Fn(&'a io::Model) -> &'a RaggedArray,
        empty: usize,
    ) -> PyResult<Bound<'py, PyAny>> {
        let flat = shared_ids(py, &self.source, |own| lists(&own.model).items())?;
        let lists = lists(self.model());
        if lists.is_empty() {
            return Ok(flat.reshape([0, empty])?.into_any());
        }
        if let Some(width) = lists.uniform_width().or_else(|| common_length(lists)) {
            return Ok(flat.reshape([lists.len(), width])?.into_any());
        }
        let offsets = (0..=lists.len()).map(|i| lists.start(i) as i64).collect();
        Ok((flat, PyArray1::from_vec(py, offsets)).into_pyobject(py)?.into_any())
    }

    /// The 3-cells of each kind by its name, as an array.
    pub(super) fn cells_by_kind<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        let (shapes, cells) = (self.model().shapes(), self.model().cells());
        for shape in CellShape::ALL {
            if !shapes.contains(&shape) {
                continue;
            }
            let value = if cells.uniform_width().is_some() {
                self.lists(py, io::Model::cells, shape.vertex_count())?
            } else {
                let of_shape = cells.iter().zip(shapes).filter(|&(_, &other)| other == shape);
                let width = Some(shape.vertex_count());
                arrays::from_lists(py, of_shape.map(|(cell, _)| cell), width)?
            };
            dict.set_item(shape_word(shape), value)?;
        }
        Ok(dict)
    }
}

/// The data on cells as (name, kind, array).
pub(super) fn data_of<'py>(
    py: Python<'py>,
    model: &io::Model,
) -> PyResult<Vec<(String, &'static str, Bound<'py, PyAny>)>> {
    let mut list = Vec::new();
    for data in model.data() {
        let (width, count) = (data.components(), data.len());
        let array = if data.is_integral() {
            let rows = (0..count).flat_map(|i| data.integer_row(i).unwrap_or_default()).collect();
            PyArray1::from_vec(py, rows).into_any()
        } else {
            let rows: Vec<f64> = (0..count).flat_map(|i| data.real_row(i)).collect();
            PyArray1::from_vec(py, rows).into_any()
        };
        let array = if width == 1 { array } else { array.call_method1("reshape", ((count, width),))? };
        list.push((data.name().to_owned(), kind_word(data.kind()), array));
    }
    Ok(list)
}

/// A reference system by the name that pyproj takes: the number of EPSG, another authority with its code, or WKT.
pub(super) fn system_name(system: &ReferenceSystem) -> Option<String> {
    let by_number = || system.srid().map(|srid| format!("EPSG:{srid}"));
    let Cow::Borrowed(member) = system.crs() else { return by_number() };
    let member: serde_json::Value = serde_json::from_str(member).ok()?;
    let name = member.get("properties").and_then(|properties| properties.get("name"));
    let name = name.and_then(serde_json::Value::as_str);
    match name {
        // With longitudes first, which the number does not say.
        Some("OGC:CRS84") => name.map(str::to_owned),
        _ => by_number().or_else(|| name.map(str::to_owned)),
    }
}
