//! Models of simplicial complexes that points or graphs make.

use crate::{CellData, Format, GroupKind, Model, ModelParts, Remark, Structure};
use coface_algebra::{RaggedArray, VertexId};
use coface_complexes::cell_mesh::CellShape;
use coface_complexes::filtered::FilteredComplex;
use coface_geometry::Positions;
use coface_geometry::predicates::{orientation, spatial_orientation};

/// A complex on points: a mesh where they have positions and the simplices have at most four vertices, else a list of simplices.
pub(crate) fn model_of(positions: &Positions, complex: &FilteredComplex, remarks: Vec<Remark>) -> Model {
    let dimension = complex.complex().dimension();
    if dimension.is_none_or(|dimension| dimension <= 3 && !positions.is_empty()) {
        return mesh_of(positions, complex, remarks);
    }
    model_of_facets(complex.facets_up_to(f64::INFINITY), remarks)
}

/// A complex whose vertices have these numbers.
pub(crate) fn model_with_numbers(complex: &FilteredComplex, numbers: &[u32], remarks: Vec<Remark>) -> Model {
    let mut facets = RaggedArray::new();
    for facet in complex.facets_up_to(f64::INFINITY).iter() {
        let facet: Vec<u32> = facet.iter().map(|&vertex| numbers[vertex as usize]).collect();
        facets.push(&facet);
    }
    model_of_facets(facets, remarks)
}

/// A complex as the list of its facets.
pub(crate) fn model_of_facets(facets: RaggedArray, remarks: Vec<Remark>) -> Model {
    let structure = Some(Structure::Facets(facets));
    ModelParts { format: Some(Format::Points), structure, remarks, ..ModelParts::default() }.into_model()
}

/// A complex of at most four points a simplex as a mesh: tetrahedra, the triangles and edges that are in none, and points. Triangles of the plane run
/// counterclockwise, and tetrahedra are positive. Where points are in no simplex, the others are numbered anew, and data `point` has their numbers.
pub(crate) fn mesh_of(positions: &Positions, complex: &FilteredComplex, remarks: Vec<Remark>) -> Model {
    let used = complex.complex().flat(0);
    let is_whole = used.len() == positions.len();
    let number = |id: u32| match is_whole {
        true => id,
        false => used.binary_search(&id).expect("a point of a simplex") as u32,
    };
    let least = complex.complex().dimension().map_or(0, |dimension| dimension.max(2));
    let dimension = positions.dimension().max(least);
    let coordinates = |id: u32| {
        let point = positions.point(VertexId::new(id as usize));
        (0..dimension).map(move |axis| point.get(axis).copied().unwrap_or(0.0))
    };
    let (mut polygons, mut cells) = (RaggedArray::new(), RaggedArray::new());
    let (mut lines, mut points) = (RaggedArray::new(), Vec::new());
    for facet in complex.facets_up_to(f64::INFINITY).iter() {
        let mut corners = facet.to_vec();
        if is_turned(positions, facet) {
            corners.swap(0, 1);
        }
        let corners: Vec<u32> = corners.into_iter().map(number).collect();
        match corners[..] {
            [point] => points.push(VertexId::new(point as usize)),
            [_, _] => lines.push(&corners),
            [_, _, _] => polygons.push(&corners),
            _ => cells.push(&corners),
        }
    }
    let flat = used.iter().flat_map(|&id| coordinates(id)).collect();
    let new_positions = Positions::from_flat(dimension, flat).expect("points have finite coordinates");
    let mut data = Vec::new();
    if !is_whole {
        let numbers = used.iter().map(|&id| i64::from(id)).collect();
        let named = CellData::integers("point", GroupKind::Vertices, 1, numbers);
        data.push(named.expect("one number for each point"));
    }
    let shapes = vec![CellShape::Tetrahedron; cells.len()];
    ModelParts {
        format: Some(Format::Points),
        vertex_count: used.len(),
        positions: new_positions,
        polygons,
        shapes,
        cells,
        lines,
        points,
        data,
        remarks,
        ..ModelParts::default()
    }
    .into_model()
}

/// Whether a triangle of the plane or a tetrahedron runs the wrong way.
fn is_turned(positions: &Positions, corners: &[u32]) -> bool {
    let point = |id: u32| positions.point(VertexId::new(id as usize));
    match *corners {
        [a, b, c] if positions.dimension() == 2 => {
            let [a, b, c] = [a, b, c].map(|id| [point(id)[0], point(id)[1]]);
            orientation(a, b, c).is_lt()
        }
        [a, b, c, d] if positions.dimension() == 3 => {
            let [a, b, c, d] = [a, b, c, d].map(|id| [point(id)[0], point(id)[1], point(id)[2]]);
            spatial_orientation(a, b, c, d).is_lt()
        }
        _ => false,
    }
}
