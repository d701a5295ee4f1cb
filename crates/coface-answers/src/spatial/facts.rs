//! Facts about arranged models that do not depend on how they were arranged.

use super::inputs::Inputs;
use super::{InputState, SpatialScene};
use crate::answer::{InsideMethod, Place, Remark, RemarkCode, SpatialInput};
use crate::text;
use coface_algebra::chains::ChainComplex;
use coface_algebra::{CellId, Error, UnionFind};
use coface_arrange::boolean::InsideRule;

/// The number of connected components of faces, edges and vertices; walks around one face are connected by the face.
pub(super) fn component_count(complex: &ChainComplex) -> usize {
    let mut vertices = UnionFind::new(complex.cell_count(0));
    let ends = |edge: u32| complex.boundary_matrix(1).map_or(&[][..], |m| m.column(edge as usize).rows());
    for edge in 0..complex.cell_count(1) as u32 {
        if let &[a, b] = ends(edge) {
            vertices.unite(a, b);
        }
    }
    for face in (0..complex.cell_count(2)).map(CellId::new) {
        let mut first = None;
        let edges = complex.boundary_matrix(2).map_or(&[][..], |m| m.column(face.index()).rows());
        for &edge in edges {
            if let Some(&vertex) = ends(edge).first() {
                vertices.unite(*first.get_or_insert(vertex), vertex);
            }
        }
    }
    vertices.class_count()
}

/// Whether the products of neighboring boundary matrices are zero, found by multiplying.
pub(super) fn products_are_zero(complex: &ChainComplex) -> Result<bool, Error> {
    for pair in complex.boundary_matrices().windows(2) {
        if pair[0].first_nonzero_product_column(&pair[1])?.is_some() {
            return Ok(false);
        }
    }
    Ok(true)
}

/// The number of faces with one cell, or the exterior, on both sides.
pub(super) fn dangling_face_count(complex: &ChainComplex) -> usize {
    let mut is_side = vec![false; complex.cell_count(2)];
    if let Some(cells) = complex.boundary_matrix(3) {
        cells.rows().iter().for_each(|&face| is_side[face as usize] = true);
    }
    is_side.iter().filter(|is_side| !**is_side).count()
}

/// Whether an input has an inside; where mouths were closed, how it was before.
pub(super) fn input_state(scene: &SpatialScene, inputs: &Inputs, input: usize) -> InputState {
    match scene.mouth_edges(input) {
        Some(edges) => InputState::Open { edges },
        None => inputs.state(input),
    }
}

/// The inputs in their order.
pub(super) fn input_answers(scene: &SpatialScene, inputs: &Inputs) -> Vec<SpatialInput> {
    let mut polygons = vec![0usize; scene.names().len()];
    let own = &scene.input_of_polygon()[..scene.own_polygon_count()];
    own.iter().for_each(|&input| polygons[input as usize] += 1);
    let odd_cells = inputs.odd_cells();
    let file = |(input, name): (usize, &String)| {
        let (closed, coherent, rim_edges) = match input_state(scene, inputs, input) {
            InputState::Closed => (true, true, 0),
            InputState::Incoherent { edges } => (true, false, edges),
            InputState::Open { edges } => (false, false, edges),
        };
        let [reversed_cells, overlapping_cells] = odd_cells[input];
        SpatialInput {
            file: scene.file_of_input(input).to_owned(),
            name: scene.has_parts().then(|| name.clone()),
            polygons: polygons[input],
            closed,
            coherent,
            rim_edges,
            reversed_cells,
            overlapping_cells,
            inside_by: None,
        }
    };
    scene.names().iter().enumerate().map(file).collect()
}

/// Which inputs enclose nothing, since their polygons cancel each other.
pub(super) fn remarks_of_vanished(inputs: &Inputs, files: &[SpatialInput]) -> Vec<Remark> {
    let vanished = files.iter().zip(&inputs.vanishes);
    let vanished = vanished.filter(|(file, vanishes)| **vanishes && file.closed && file.polygons > 0);
    let remark = |(file, _): (&SpatialInput, &bool)| {
        let message = format!(
            "{} encloses nothing: each of its faces is there as often in one direction as in the other, or has no area",
            file.label()
        );
        Remark::new(RemarkCode::EmptyInput, message).at(file.polygons, [Place::file(&file.file)])
    };
    vanished.map(remark).collect()
}

/// Which inputs are inside out, which overlap themselves, and of which the inside is found by parity.
pub(super) fn remarks_of_inputs(files: &[SpatialInput], rule: InsideRule) -> Vec<Remark> {
    let mut remarks = Vec::new();
    for file in files.iter().filter(|file| file.reversed_cells > 0) {
        let message = format!(
            "{} is inside out, wholly or in part: it winds less than zero times around cells",
            file.label()
        );
        remarks.push(
            Remark::new(RemarkCode::ReversedInput, message)
                .at(file.reversed_cells, [Place::file(&file.file)]),
        );
    }
    let by_parity = |file: &&SpatialInput| {
        rule != InsideRule::Odd && !file.coherent && file.inside_by == Some(InsideMethod::Parity)
    };
    let by_parity: Vec<&SpatialInput> = files.iter().filter(by_parity).collect();
    if let Some(first) = by_parity.first() {
        let others = match by_parity.len() {
            1 => String::new(),
            count => format!(", and so of {} more", text::count(count - 1, "input")),
        };
        let message = format!(
            "{}: polygons do not agree in direction across {}{others}: inside is what they enclose an odd number of times",
            first.label(),
            text::count(first.rim_edges, "edge")
        );
        let places = by_parity.iter().map(|file| Place::file(&file.file));
        remarks.push(Remark::new(RemarkCode::ReversedInput, message).at(by_parity.len(), places));
    }
    for file in files.iter().filter(|file| rule == InsideRule::Nonzero && file.overlapping_cells > 0) {
        let message = format!(
            "{} overlaps itself: it winds more than once around {}; --rule positive counts what winds backward as outside",
            file.label(),
            text::count(file.overlapping_cells, "cell")
        );
        remarks.push(
            Remark::new(RemarkCode::OverlappingInput, message)
                .at(file.overlapping_cells, [Place::file(&file.file)]),
        );
    }
    remarks
}
