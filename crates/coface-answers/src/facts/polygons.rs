//! The report on polygons, edges and vertices.

use super::geometry::{GeometryFacts, GeometryRequest};
use super::moments::Integrals;
use super::report::{Answer, BoundaryPart, Kind, Report, Witness};
use super::{Problem, ProblemKind};
use crate::producer::Labels;
use coface_algebra::RaggedArray;
use coface_algebra::{EdgeId, Error, FaceId, VertexId};
use coface_complexes::surface::{PolygonMesh, SurfaceDefect, SurfaceOrientation, SurfaceSurvey};
use coface_geometry::{Positions, enclosed_volume, polygon_area};
use coface_io::{Place, Remark, RemarkCode, StatedSurfaces};
use coface_topology::homology;
use std::cmp::Ordering;

/// The report on a mesh, whose vertices have these labels in the file.
///
/// # Errors
/// Those of a check of the geometry.
pub(crate) fn report(
    mesh: PolygonMesh,
    positions: Positions,
    labels: &Labels,
    kind: Kind,
    (exponents, geometry): (&[[u32; 3]], &GeometryRequest),
    stated: Option<&StatedSurfaces>,
) -> Result<Report, Error> {
    let degrees = VertexDegrees::of(&mesh);
    let mut report = match (mesh.face_count(), mesh.edge_count()) {
        (0, 0) => of_points(&mesh),
        (0, _) => of_graph(&mesh, &degrees, labels),
        _ => of_faces(&mesh, &positions, labels, exponents),
    };
    report.geometry = GeometryFacts::of(&mesh, &positions, labels, geometry, stated)?;
    report.remarks.extend(open_seams(&mesh, &positions, labels));
    drop(positions);
    report.kind = kind;
    duplicates(&mesh, labels, &mut report.problems);
    if report.dimension() != Some(0) {
        isolated(&degrees, labels, &mut report.problems);
    }
    report.pure = Some(match report.dimension() {
        Some(2) => degrees.isolated.is_empty() && !has(&report, ProblemKind::LooseCell),
        Some(1) => degrees.isolated.is_empty(),
        _ => true,
    });
    if kind == Kind::Complex && report.dimension() > Some(0) && report.pure == Some(false) {
        not_pure(&mesh, &degrees, labels, &mut report);
    }
    drop(degrees);
    let complex = mesh.into_chain_complex().expect("a mesh has a chain complex");
    report.euler_characteristic = complex.euler_characteristic();
    report.homology = homology(&complex).groups().to_vec();
    Ok(report)
}

/// A facet list with facets of lower dimension is no manifold; says so, and whether the other facets alone are one.
fn not_pure(mesh: &PolygonMesh, degrees: &VertexDegrees, labels: &Labels, report: &mut Report) {
    if report.witness.as_ref().is_some_and(|witness| witness.kind != "edge_in_no_face") {
        return;
    }
    let is_manifold_without = match report.dimension() {
        Some(2) => PolygonMesh::new(mesh.vertex_count(), mesh.polygons().clone(), &[])
            .is_ok_and(|faces| faces.survey().verdict().is_manifold()),
        _ => report.manifold == Answer::Yes,
    };
    let loose = report.problems.iter().find(|problem| problem.kind() == ProblemKind::LooseCell);
    let first = match (degrees.isolated.first(), loose) {
        (Some(&vertex), _) => vec![labels.of(vertex)],
        (None, Some(problem)) => problem.cells().list(0).to_vec(),
        (None, None) => return,
    };
    let count = degrees.isolated.len() + loose.map_or(0, Problem::count);
    let listed: Vec<String> = first.iter().map(u32::to_string).collect();
    let mut message = format!(
        "the facet [{}] has dimension {}, others have {}: the complex is not pure",
        listed.join(", "),
        first.len() - 1,
        report.dimension().unwrap_or(0)
    );
    if is_manifold_without {
        let such = if count == 1 { "that facet" } else { "such facets" };
        message += &format!("; without {such} it is a manifold");
    }
    report.manifold = Answer::No;
    report.witness = Some(Witness { kind: "not_pure", cells: vec![first], message });
}

fn has(report: &Report, kind: ProblemKind) -> bool {
    report.problems.iter().any(|problem| problem.kind() == kind)
}

/// The numbers of edges at the vertices.
pub(crate) struct VertexDegrees {
    of_vertex: Vec<u32>,
    pub(crate) isolated: Vec<u32>,
}

impl VertexDegrees {
    pub(crate) fn of(mesh: &PolygonMesh) -> Self {
        let mut of_vertex = vec![0; mesh.vertex_count()];
        for &end in mesh.edge_ends() {
            of_vertex[end as usize] += 1;
        }
        let isolated = (0..of_vertex.len() as u32).filter(|&v| of_vertex[v as usize] == 0).collect();
        Self { of_vertex, isolated }
    }
}

fn of_points(mesh: &PolygonMesh) -> Report {
    Report {
        f_vector: if mesh.vertex_count() == 0 { Vec::new() } else { vec![mesh.vertex_count()] },
        shapes: vec![("vertex", mesh.vertex_count())],
        components: mesh.vertex_count(),
        orientable: (mesh.vertex_count() > 0).then_some(true),
        ..Report::of_nothing()
    }
}

/// A graph is a 1-manifold when each vertex that has an edge has one or two.
fn of_graph(mesh: &PolygonMesh, degrees: &VertexDegrees, labels: &Labels) -> Report {
    let branching: Vec<u32> =
        (0..degrees.of_vertex.len() as u32).filter(|&v| degrees.of_vertex[v as usize] > 2).collect();
    let witness = branching.first().map(|&v| Witness {
        kind: "vertex_in_many_edges",
        cells: vec![vec![labels.of(v)]],
        message: format!("vertex v{} lies in {} edges", labels.of(v), degrees.of_vertex[v as usize]),
    });
    let mut problems = Vec::new();
    if !branching.is_empty() {
        let message = format!(
            "{} in three or more edges; a curve allows two",
            counted(branching.len(), "vertex lies", "vertices lie")
        );
        problems.push(Problem::at_vertices(
            ProblemKind::NonManifoldRidge,
            message,
            &labels.of_all(branching),
        ));
    }
    Report {
        f_vector: vec![mesh.vertex_count(), mesh.edge_count()],
        shapes: vec![("edge", mesh.edge_count())],
        components: mesh.components().count(),
        manifold: if witness.is_none() { Answer::Yes } else { Answer::No },
        closed: Some(!degrees.of_vertex.contains(&1)),
        orientable: witness.is_none().then_some(true),
        witness,
        problems,
        ..Report::of_nothing()
    }
}

fn of_faces(mesh: &PolygonMesh, positions: &Positions, labels: &Labels, exponents: &[[u32; 3]]) -> Report {
    let survey = mesh.survey();
    let (verdict, orientation) = (survey.verdict(), survey.orientation());
    let mut problems = Vec::new();
    non_manifold(mesh, &survey, labels, &mut problems);
    orientation_problems(mesh, orientation, labels, &mut problems);
    let area = polygon_area(positions, mesh.polygons());
    let around = is_cycle(mesh, &survey).then(|| mesh.polygons());
    let signed_volume = around.and_then(|around| enclosed_volume(positions, around));
    let integrals = Integrals { surface: Some(mesh.polygons()), around, positions };
    let boundary_loops = survey.boundary_loops().iter().map(|part| BoundaryPart {
        vertices: part.vertices().iter().map(|&vertex| labels.of(vertex.to_u32())).collect(),
        edge_count: part.edges().len(),
        walks: part
            .walks()
            .iter()
            .map(|walk| walk.iter().map(|&vertex| labels.of(vertex.to_u32())).collect())
            .collect(),
        is_simple: part.is_simple(),
    });
    Report {
        f_vector: mesh.f_vector(),
        shapes: polygon_shapes(mesh.polygons()),
        components: survey.components().count(),
        manifold: Answer::of(verdict.to_bool()),
        closed: Some(verdict.is_closed()),
        witness: verdict.witness().map(|defect| witness(mesh, defect, labels)),
        boundary_loops: Some(boundary_loops.collect()),
        orientable: orientation.is_orientable(),
        coherently_oriented: orientation.is_coherent(),
        surface_type: survey.surface(),
        surfaces: survey.parts().iter().filter(|part| part.f_vector() != [1, 0, 0]).cloned().collect(),
        name: survey.name(),
        area,
        signed_volume,
        surface_centroid: integrals.surface_centroid(),
        mass: integrals.mass(),
        moments: integrals.moments(exponents),
        problems,
        ..Report::of_nothing()
    }
}

/// Whether the sum of all faces, as they are oriented, has no boundary: then it encloses a volume.
fn is_cycle(mesh: &PolygonMesh, survey: &SurfaceSurvey) -> bool {
    if let Some(coherent) = survey.orientation().is_coherent() {
        return coherent && survey.verdict().is_closed();
    }
    (0..mesh.edge_count())
        .all(|edge| mesh.faces_of_edge(EdgeId::new(edge)).map(|(_, sign)| sign.to_i32()).sum::<i32>() == 0)
}

/// How many polygons have how many sides.
pub(crate) fn polygon_shapes(polygons: &RaggedArray) -> Vec<(&'static str, usize)> {
    const NAMES: [&str; 4] = ["triangle", "quadrangle", "pentagon", "hexagon"];
    let mut counts = [0; 5];
    if let Some(width) = polygons.uniform_width() {
        counts[(width - 3).min(4)] = polygons.len();
    } else {
        for polygon in polygons.iter() {
            counts[(polygon.len() - 3).min(4)] += 1;
        }
    }
    let names = NAMES.into_iter().chain(["polygon of more sides"]);
    names.zip(counts).filter(|&(_, count)| count > 0).collect()
}

fn edge_vertices(mesh: &PolygonMesh, edge: EdgeId, labels: &Labels) -> [u32; 2] {
    mesh.edge(edge).map(|end| labels.of(end.to_u32()))
}

/// The positions in the file of the faces at an edge.
fn faces_at(mesh: &PolygonMesh, edge: EdgeId) -> Vec<u32> {
    mesh.faces_of_edge(edge).map(|(face, _)| mesh.polygon_of_face(face) as u32).collect()
}

fn face_vertices(mesh: &PolygonMesh, face: FaceId, labels: &Labels) -> Vec<u32> {
    mesh.face(face).iter().map(|&vertex| labels.of(vertex)).collect()
}

/// The edges by their ends, with the faces at each.
fn at_edges(
    mesh: &PolygonMesh,
    edges: &[EdgeId],
    labels: &Labels,
    kind: ProblemKind,
    message: String,
) -> Problem {
    let cells = RaggedArray::from_lists(edges.iter().map(|&edge| edge_vertices(mesh, edge, labels)));
    let faces = RaggedArray::from_lists(edges.iter().map(|&edge| faces_at(mesh, edge)));
    Problem::new(kind, message, cells, faces, "face")
}

pub(crate) fn witness(mesh: &PolygonMesh, defect: &SurfaceDefect, labels: &Labels) -> Witness {
    match defect {
        SurfaceDefect::EdgeInManyFaces { edge, .. } => {
            let [a, b] = edge_vertices(mesh, *edge, labels);
            let faces = faces_at(mesh, *edge);
            let few: Vec<String> = faces.iter().take(8).map(|face| format!("f{face}")).collect();
            let more = if faces.len() > few.len() { ", .." } else { "" };
            Witness {
                kind: "edge_in_many_faces",
                cells: vec![vec![a, b]],
                message: format!(
                    "edge {{v{a} v{b}}} lies in {} faces: {}{more}",
                    faces.len(),
                    few.join(", ")
                ),
            }
        }
        SurfaceDefect::LooseEdge { edge } => {
            let [a, b] = edge_vertices(mesh, *edge, labels);
            Witness {
                kind: "edge_in_no_face",
                cells: vec![vec![a, b]],
                message: format!("edge {{v{a} v{b}}} lies in no face"),
            }
        }
        SurfaceDefect::SeveralFans { vertex, link } => {
            let v = labels.of(vertex.to_u32());
            Witness {
                kind: "vertex_with_several_fans",
                cells: vec![vec![v]],
                message: format!("{} separate fans of faces touch at vertex v{v}", link.len()),
            }
        }
    }
}

fn non_manifold(mesh: &PolygonMesh, survey: &SurfaceSurvey, labels: &Labels, problems: &mut Vec<Problem>) {
    let verdict = survey.verdict();
    let (edges, loose) = (verdict.non_manifold_edges(), verdict.loose_edges());
    if !edges.is_empty() {
        let message = format!(
            "{} in three or more faces; a surface allows two",
            counted(edges.len(), "edge lies", "edges lie")
        );
        problems.push(at_edges(mesh, edges, labels, ProblemKind::NonManifoldRidge, message));
    }
    if !loose.is_empty() {
        let message = format!("{} in no face", counted(loose.len(), "edge lies", "edges lie"));
        problems.push(at_edges(mesh, loose, labels, ProblemKind::LooseCell, message));
    }
    let vertices = verdict.non_manifold_vertices();
    if !vertices.is_empty() {
        let mut ends: Vec<VertexId> = edges.iter().chain(loose).flat_map(|&edge| mesh.edge(edge)).collect();
        ends.sort_unstable();
        ends.dedup();
        // The vertices that no bad edge explains come first.
        let (explained, pinched): (Vec<VertexId>, Vec<VertexId>) =
            vertices.iter().partition(|vertex| ends.binary_search(vertex).is_ok());
        let mut message = format!(
            "{} not surrounded by a single fan or ring of faces",
            counted(vertices.len(), "vertex is", "vertices are")
        );
        if pinched.is_empty() {
            message += ": ends of the edges above";
        } else if !explained.is_empty() {
            message += &format!("; {} of them are ends of the edges above", explained.len());
        }
        let listed = pinched.into_iter().chain(explained).map(VertexId::to_u32).collect();
        problems.push(Problem::at_vertices(ProblemKind::NonManifoldVertex, message, &labels.of_all(listed)));
    }
}

fn orientation_problems(
    mesh: &PolygonMesh,
    orientation: &SurfaceOrientation,
    labels: &Labels,
    problems: &mut Vec<Problem>,
) {
    if let (Some(false), Some(cycle)) = (orientation.is_orientable(), orientation.odd_cycle()) {
        let message = format!(
            "no side can be chosen: a closed chain of {} comes back reversed (a Moebius band)",
            counted(cycle.cells().len(), "face", "faces")
        );
        let cells = cycle.cells().iter().map(|&face| face_vertices(mesh, face, labels));
        let faces = cycle.cells().iter().map(|&face| [mesh.polygon_of_face(face) as u32]);
        let (cells, faces) = (RaggedArray::from_lists(cells), RaggedArray::from_lists(faces));
        problems.push(Problem::new(ProblemKind::OneSidedChain, message, cells, faces, "face"));
    } else if orientation.is_coherent() == Some(false) {
        let edges = orientation.conflicts();
        let message = format!(
            "at {} the two faces run against each other; some faces must be turned over",
            counted(edges.len(), "edge", "edges")
        );
        problems.push(at_edges(mesh, edges, labels, ProblemKind::OrientationConflict, message));
    }
}

fn duplicates(mesh: &PolygonMesh, labels: &Labels, problems: &mut Vec<Problem>) {
    let found = mesh.duplicate_faces();
    if found.is_empty() {
        return;
    }
    let (_, later) = found[0];
    let first = mesh.polygon_of_face(found[0].0);
    let message = format!(
        "{} an earlier one and counted once: face f{later} repeats f{first}{}",
        counted(found.len(), "face repeats", "faces repeat"),
        if found.len() > 1 { ", .." } else { "" },
    );
    let cells = RaggedArray::from_lists(found.iter().map(|&(face, _)| face_vertices(mesh, face, labels)));
    let pair = |&(face, later): &(FaceId, usize)| [mesh.polygon_of_face(face) as u32, later as u32];
    let faces = RaggedArray::from_lists(found.iter().map(pair));
    problems.push(Problem::new(ProblemKind::DuplicateCell, message, cells, faces, "face"));
}

fn isolated(degrees: &VertexDegrees, labels: &Labels, problems: &mut Vec<Problem>) {
    if !degrees.isolated.is_empty() {
        problems.push(isolated_vertices(&labels.of_all(degrees.isolated.clone())));
    }
}

/// The problem of vertices that lie in no edge.
pub(crate) fn isolated_vertices(vertices: &[u32]) -> Problem {
    let message = format!("{} isolated: in no edge", counted(vertices.len(), "vertex is", "vertices are"));
    Problem::at_vertices(ProblemKind::IsolatedVertex, message, vertices)
}

/// That vertices of the boundary have the very position of others there: faces that look joined are not, as where a mesh was split for texture
/// coordinates or normals.
fn open_seams(mesh: &PolygonMesh, positions: &Positions, labels: &Labels) -> Option<Remark> {
    if positions.dimension() == 0 || positions.len() != mesh.vertex_count() {
        return None;
    }
    let is_open = |&edge: &EdgeId| mesh.faces_of_edge(edge).count() == 1;
    let open = (0..mesh.edge_count()).map(EdgeId::new).filter(is_open);
    let mut vertices: Vec<VertexId> = open.flat_map(|edge| mesh.edge(edge)).collect();
    vertices.sort_unstable();
    vertices.dedup();
    // Zeros of both signs are equal.
    let compare = |&a: &VertexId, &b: &VertexId| {
        let pairs = positions.point(a).iter().zip(positions.point(b));
        pairs
            .map(|(x, y)| (x + 0.0).total_cmp(&(y + 0.0)))
            .find(|order| order.is_ne())
            .unwrap_or(Ordering::Equal)
    };
    vertices.sort_by(compare);
    let twins = vertices.windows(2).filter(|pair| compare(&pair[0], &pair[1]).is_eq());
    let mut twins: Vec<u32> = twins.map(|pair| labels.of(pair[1].to_u32())).collect();
    twins.sort_unstable();
    if twins.is_empty() {
        return None;
    }
    let message = format!(
        "{} at the very position of another, so that faces which look joined there are not; \
         coface convert INPUT --weld 0 -o OUT.off joins them",
        counted(twins.len(), "vertex of the boundary is", "vertices of the boundary are")
    );
    let places = twins.iter().map(|&twin| Place::cell(&[twin]));
    Some(Remark::new(RemarkCode::CoincidentVertices, message).at(twins.len(), places))
}

/// `1 edge lies`, `12 edges lie`.
pub(crate) fn counted(count: usize, one: &str, many: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { many })
}
