//! The report on tetrahedra, hexahedra, wedges and pyramids.

use super::moments::{Integrals, boundary_chain};
use super::polygons::{VertexDegrees, counted, isolated_vertices};
use super::report::{Answer, Kind, Report, Skin, Witness};
use super::{Problem, ProblemKind};
use crate::answer::{Remark, RemarkCode};
use coface_algebra::RaggedArray;
use coface_algebra::{CellId, EdgeId, FaceId};
use coface_complexes::cell_mesh::{
    CellMesh, CellShape, VolumeDefect, VolumeOrientation, VolumeVerdict, cell_volumes,
};
use coface_geometry::Positions;
use coface_topology::homology;

/// The report on a mesh that has at least one 3-cell.
pub(crate) fn report(mesh: CellMesh, positions: &Positions, exponents: &[[u32; 3]]) -> Report {
    let verdict = mesh.manifold_verdict();
    let mut problems = Vec::new();
    non_manifold(&mesh, &verdict, &mut problems);
    let orientation = mesh.orientation();
    orientation_problems(&mesh, &orientation, &mut problems);
    duplicates(&mesh, &mut problems);
    let isolated = VertexDegrees::of(mesh.skeleton()).isolated;
    let pure = isolated.is_empty() && verdict.loose_faces().is_empty() && verdict.loose_edges().is_empty();
    if !isolated.is_empty() {
        problems.push(isolated_vertices(&isolated));
    }
    let volumes = cell_volumes(positions, mesh.shapes(), mesh.cells());
    let inverted = volumes.map_or(0, |volumes| volumes.negative_count());
    let remarks = match inverted {
        0 => Vec::new(),
        _ => {
            let message = format!(
                "{inverted} of {} cells have a negative volume: their vertices are listed inside out",
                mesh.cell_count()
            );
            vec![Remark::new(RemarkCode::NegativeVolume, message).at(inverted, [])]
        }
    };
    let boundary = mesh.boundary_surface();
    let survey = boundary.mesh().survey();
    let skin = Skin {
        face_count: boundary.faces().len(),
        components: survey.components().count(),
        euler_characteristic: boundary.mesh().euler_characteristic(),
        is_manifold: survey.verdict().is_manifold(),
        name: survey.name(),
    };
    drop((survey, boundary));
    let around = if positions.is_empty() { RaggedArray::new() } else { boundary_chain(&mesh) };
    let integrals = Integrals { surface: Some(&around), around: Some(&around), positions };
    let (mass, moments) = (integrals.mass(), integrals.moments(exponents));
    drop(around);
    let mut report = Report {
        kind: Kind::Volume,
        f_vector: mesh.f_vector(),
        shapes: shapes(&mesh),
        pure: Some(pure),
        components: mesh.components().count(),
        euler_characteristic: mesh.euler_characteristic(),
        manifold: Answer::of(verdict.to_bool()),
        closed: Some(verdict.is_closed()),
        witness: verdict.witness().map(|defect| witness(&mesh, defect)),
        orientable: orientation.is_orientable(),
        coherently_oriented: orientation.is_coherent(),
        skin: (skin.face_count > 0).then_some(skin),
        signed_volume: volumes.map(|volumes| volumes.signed()),
        mass,
        moments,
        problems,
        remarks,
        ..Report::of_nothing()
    };
    report.homology =
        homology(&mesh.into_chain_complex().expect("a mesh has a chain complex")).groups().to_vec();
    report
}

fn witness(mesh: &CellMesh, defect: &VolumeDefect) -> Witness {
    match defect {
        VolumeDefect::FaceInManyCells { face, .. } => {
            let (vertices, cells) = (face_vertices(mesh, *face), cells_at(mesh, *face));
            let few: Vec<String> = cells.iter().take(8).map(|cell| format!("c{cell}")).collect();
            Witness {
                kind: "face_in_many_cells",
                message: format!(
                    "face {} lies in {} cells: {}",
                    named(&vertices),
                    cells.len(),
                    few.join(", ")
                ),
                cells: vec![vertices],
            }
        }
        VolumeDefect::LooseFace { face } => {
            let vertices = face_vertices(mesh, *face);
            let message = format!("face {} lies in no cell", named(&vertices));
            Witness { kind: "face_in_no_cell", cells: vec![vertices], message }
        }
        VolumeDefect::LooseEdge { edge } => {
            let ends = edge_vertices(mesh, *edge);
            let message = format!("edge {} lies in no face", named(&ends));
            Witness { kind: "edge_in_no_face", cells: vec![ends.to_vec()], message }
        }
        VolumeDefect::SeveralFans { edge, fans } => {
            let ends = edge_vertices(mesh, *edge);
            let message = format!("{} separate fans of cells touch along edge {}", fans.len(), named(&ends));
            Witness { kind: "edge_with_several_fans", cells: vec![ends.to_vec()], message }
        }
        VolumeDefect::VertexLink { vertex, .. } => {
            Witness { kind: "vertex_link", cells: vec![vec![vertex.to_u32()]], message: defect.message() }
        }
    }
}

fn non_manifold(mesh: &CellMesh, verdict: &VolumeVerdict, problems: &mut Vec<Problem>) {
    let faces = verdict.non_manifold_faces();
    if !faces.is_empty() {
        let message = format!(
            "{} in three or more cells; a solid allows two",
            counted(faces.len(), "face lies", "faces lie")
        );
        problems.push(at_faces(mesh, faces, ProblemKind::NonManifoldRidge, message));
    }
    let edges = verdict.non_manifold_edges();
    if !edges.is_empty() {
        let message = format!(
            "{} not surrounded by a single fan or ring of cells",
            counted(edges.len(), "edge is", "edges are")
        );
        problems.push(at_edges(mesh, edges, ProblemKind::NonManifoldEdge, message));
    }
    let vertices = verdict.non_manifold_vertices();
    if !vertices.is_empty() {
        let message = format!(
            "{} a neighborhood that is no ball or half ball",
            counted(vertices.len(), "vertex has", "vertices have")
        );
        let listed: Vec<u32> = vertices.iter().map(|vertex| vertex.to_u32()).collect();
        problems.push(Problem::at_vertices(ProblemKind::NonManifoldVertex, message, &listed));
    }
    let (faces, edges) = (verdict.loose_faces(), verdict.loose_edges());
    if !faces.is_empty() {
        let message = format!("{} in no cell", counted(faces.len(), "face lies", "faces lie"));
        problems.push(at_faces(mesh, faces, ProblemKind::LooseCell, message));
    }
    if !edges.is_empty() {
        let message = format!("{} in no face", counted(edges.len(), "edge lies", "edges lie"));
        problems.push(at_edges(mesh, edges, ProblemKind::LooseCell, message));
    }
}

fn orientation_problems(mesh: &CellMesh, orientation: &VolumeOrientation, problems: &mut Vec<Problem>) {
    if let (Some(false), Some(cycle)) = (orientation.is_orientable(), orientation.odd_cycle()) {
        let message = format!(
            "no orientation can be chosen: a closed chain of {} comes back reversed",
            counted(cycle.cells().len(), "cell", "cells")
        );
        let cells = RaggedArray::from_lists(cycle.cells().iter().map(|&cell| mesh.cell(cell)));
        let tops = cycle.cells().iter().map(|&cell| [mesh.source_of_cell(cell) as u32]);
        let tops = RaggedArray::from_lists(tops);
        problems.push(Problem::new(ProblemKind::OneSidedChain, message, cells, tops, "cell"));
    } else if orientation.is_coherent() == Some(false) {
        let faces = orientation.conflicts();
        let message = format!(
            "at {} the two cells run against each other; some cells must be reversed",
            counted(faces.len(), "face", "faces")
        );
        problems.push(at_faces(mesh, faces, ProblemKind::OrientationConflict, message));
    }
}

fn edge_vertices(mesh: &CellMesh, edge: EdgeId) -> [u32; 2] {
    mesh.skeleton().edge(edge).map(|end| end.to_u32())
}

fn at_edges(mesh: &CellMesh, edges: &[EdgeId], kind: ProblemKind, message: String) -> Problem {
    let cells = RaggedArray::from_lists(edges.iter().map(|&edge| edge_vertices(mesh, edge)));
    Problem::new(kind, message, cells, RaggedArray::new(), "cell")
}

fn face_vertices(mesh: &CellMesh, face: FaceId) -> Vec<u32> {
    mesh.skeleton().face(face).to_vec()
}

/// The positions in the file of the cells at a face.
fn cells_at(mesh: &CellMesh, face: FaceId) -> Vec<u32> {
    mesh.cells_of_face(face).map(|(cell, _)| mesh.source_of_cell(cell) as u32).collect()
}

/// `{v0 v1 v2}`.
fn named(vertices: &[u32]) -> String {
    let names: Vec<String> = vertices.iter().map(|vertex| format!("v{vertex}")).collect();
    format!("{{{}}}", names.join(" "))
}

fn at_faces(mesh: &CellMesh, faces: &[FaceId], kind: ProblemKind, message: String) -> Problem {
    let cells = RaggedArray::from_lists(faces.iter().map(|&face| face_vertices(mesh, face)));
    let tops = RaggedArray::from_lists(faces.iter().map(|&face| cells_at(mesh, face)));
    Problem::new(kind, message, cells, tops, "cell")
}

fn duplicates(mesh: &CellMesh, problems: &mut Vec<Problem>) {
    let found = mesh.duplicate_cells();
    let Some(&(cell, later)) = found.first() else { return };
    let first = mesh.source_of_cell(cell);
    let message = format!(
        "{} an earlier one and counted once: cell c{later} repeats c{first}{}",
        counted(found.len(), "cell repeats", "cells repeat"),
        if found.len() > 1 { ", .." } else { "" },
    );
    let cells = RaggedArray::from_lists(found.iter().map(|&(cell, _)| mesh.cell(cell)));
    let pair = |&(cell, later): &(CellId, usize)| [mesh.source_of_cell(cell) as u32, later as u32];
    let tops = RaggedArray::from_lists(found.iter().map(pair));
    problems.push(Problem::new(ProblemKind::DuplicateCell, message, cells, tops, "cell"));
}

/// How many cells have which shape.
fn shapes(mesh: &CellMesh) -> Vec<(&'static str, usize)> {
    let count = |shape: CellShape| mesh.shapes().iter().filter(|&&other| other == shape).count();
    CellShape::ALL.map(|shape| (shape.name(), count(shape))).into_iter().filter(|entry| entry.1 > 0).collect()
}
