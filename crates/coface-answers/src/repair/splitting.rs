//! Repair of models, on request only.

use super::outwards::faces_to_turn;
use super::polygons_of::PolygonsOf;
use coface_algebra::RaggedArray;
use coface_algebra::{Error, FaceId, VertexId};
use coface_complexes::surface::{FacesAtEdge, MeshRepair, PolygonMesh};
use coface_io::{CellData, Group, GroupKind, Model, ModelParts, placed};

/// What to repair in a model, and nothing else.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct RepairRequest {
    /// Split the edges in three or more faces; see [`MeshRepair::split_edges`].
    pub split_edges: Option<FacesAtEdge>,
    /// Split the vertices with several fans of faces; see [`MeshRepair::split_vertices`].
    pub split_vertices: bool,
    /// Turn faces so that all agree; see [`MeshRepair::orient`]. Closed parts in space look outwards then; a part whose box lies in that of another
    /// closed one turns with it.
    pub orient: bool,
    /// Turn faces so that those of each part agree where they can, and closed parts look outwards; see [`MeshRepair::orient_parts`].
    pub orient_parts: bool,
    /// Leave out the polygons that repeat an earlier one, with their data, before anything else is done.
    pub drop_repeated: bool,
}

/// The model with its polygons repaired as requested, first edges, then vertices, then orientation, and what was done.
///
/// Copies of vertices get their positions and data and are members of their groups. Lines follow the faces that they are
/// sides of; where these come apart, so does the line, and its parts, one after the other, have its data and are members
/// of its groups. Points stay. Polygons that repeat an earlier one stay beside it unless they are to be dropped.
///
/// # Errors
/// [`coface_algebra::ErrorKind::UnsupportedFormat`] for models with 3-cells, and for structures that are no facet list of dimension 2; those of [`PolygonMesh::new`] and
/// of the steps of [`MeshRepair`].
///
/// # Examples
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_geometry::Positions;
/// use coface_io::Model;
/// use coface_answers::{RepairRequest, repaired};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let points = Positions::from_flat(2, vec![0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 1.0])?;
/// let model = Model::from_polygons(points, RaggedArray::from_lists([[0, 1, 2], [1, 2, 3]]))?;
/// let mut request = RepairRequest::default();
/// request.orient = true;
/// let (turned, repair) = repaired(&model, request)?;
/// assert_eq!(turned.polygons().list(1), [3, 2, 1]);
/// assert_eq!(repair.faces_turned().len(), 1);
/// # Ok(()) }
/// ```
pub fn repaired(model: &Model, request: RepairRequest) -> Result<(Model, MeshRepair), Error> {
    let PolygonsOf { model: mut polygons, labels } = PolygonsOf::new(model)?;
    if request.drop_repeated {
        polygons = without_repeated(polygons)?;
    }
    let vertex_count = polygons.vertex_count();
    let (made, repair) = repaired_polygons_model(polygons, request)?;
    let sources: Vec<usize> = (0..vertex_count).collect();
    Ok((PolygonsOf { model: made, labels }.into_given(&sources), repair))
}

/// The model without the polygons that repeat an earlier one; data and groups follow.
fn without_repeated(model: Model) -> Result<Model, Error> {
    let mesh = PolygonMesh::new(model.vertex_count(), model.polygons().clone(), &[])?;
    let mut repeated: Vec<usize> = mesh.duplicate_faces().iter().map(|&(_, polygon)| polygon).collect();
    if repeated.is_empty() {
        return Ok(model);
    }
    repeated.sort_unstable();
    let is_kept = |polygon: &usize| repeated.binary_search(polygon).is_err();
    let kept: Vec<usize> = (0..model.polygons().len()).filter(is_kept).collect();
    let data = |data: &CellData| match data.kind() {
        GroupKind::Polygons => data.taken_from(kept.iter().copied()),
        _ => data.clone(),
    };
    let group = |group: &Group| match group.kind() {
        GroupKind::Polygons => {
            let place = |&member: &u32| kept.binary_search(&(member as usize)).ok();
            let members = group.members().iter().filter_map(place).map(|place| place as u32).collect();
            group.with_members(members)
        }
        _ => group.clone(),
    };
    Ok(ModelParts {
        polygons: RaggedArray::from_lists(kept.iter().map(|&polygon| model.polygons().list(polygon))),
        groups: model.groups().iter().map(group).collect(),
        data: model.data().iter().map(data).collect(),
        ..model.clone().into_parts()
    }
    .into_model())
}

/// The same for a model of polygons.
pub(super) fn repaired_polygons_model(
    model: Model,
    request: RepairRequest,
) -> Result<(Model, MeshRepair), Error> {
    let steps: Vec<[u32; 2]> =
        model.lines().iter().flat_map(|line| line.windows(2).map(|step| [step[0], step[1]])).collect();
    let mesh = PolygonMesh::new(model.vertex_count(), model.polygons().clone(), &steps)?;
    let mut repair = MeshRepair::new(mesh);
    if let Some(together) = request.split_edges {
        repair.split_edges(together)?;
    }
    if request.split_vertices {
        repair.split_vertices()?;
    }
    if request.orient {
        repair.orient()?;
    }
    if request.orient_parts {
        repair.orient_parts();
    }
    let (positions, partial_positions) =
        placed(model.coordinate_count(), repaired_coordinates(&model, &repair))?;
    if request.orient || request.orient_parts {
        repair.turn(&faces_to_turn(repair.mesh(), &positions));
    }
    let (lines, line_starts) = repaired_lines(model.lines(), &repair);
    let repaired = ModelParts {
        vertex_count: repair.mesh().vertex_count(),
        positions,
        partial_positions,
        polygons: repaired_polygons(model.polygons(), &repair),
        lines,
        groups: model.groups().iter().map(|group| repaired_group(group, &repair, &line_starts)).collect(),
        data: model.data().iter().map(|data| repaired_data(data, &repair, &line_starts)).collect(),
        ..model.into_parts()
    }
    .into_model();
    Ok((repaired, repair))
}

/// The coordinates of the vertices, as the model has them, with those of the vertices that were split.
fn repaired_coordinates(model: &Model, repair: &MeshRepair) -> Vec<f64> {
    let dimension = model.coordinate_count();
    let mut coordinates = model.coordinates().to_vec();
    for source in repair.vertex_sources().iter().skip(model.vertex_count()) {
        let start = source.index() * dimension;
        coordinates.extend_from_slice(&model.coordinates()[start..start + dimension]);
    }
    coordinates
}

/// The polygons of the model, also those that repeat an earlier one, at the vertices of the repaired faces.
fn repaired_polygons(polygons: &RaggedArray, repair: &MeshRepair) -> RaggedArray {
    let mesh = repair.mesh();
    if mesh.duplicate_faces().is_empty() {
        return mesh.polygons().clone();
    }
    let mut repaired = polygons.clone();
    for face in (0..mesh.face_count()).map(FaceId::new) {
        let start = polygons.start(mesh.polygon_of_face(face));
        let corners = mesh.face(face);
        repaired.items_mut()[start..start + corners.len()].copy_from_slice(corners);
    }
    for &(face, polygon) in mesh.duplicate_faces() {
        let mut corners: Vec<u32> = polygons.list(polygon).to_vec();
        for corner in &mut corners {
            let source =
                |&&copy: &&u32| repair.vertex_sources()[VertexId::from_u32(copy)].to_u32() == *corner;
            *corner = *mesh.face(face).iter().find(source).expect("equal faces have the same vertices");
        }
        if repair.faces_turned().binary_search(&face).is_ok() {
            corners.reverse();
        }
        let start = polygons.start(polygon);
        repaired.items_mut()[start..start + corners.len()].copy_from_slice(&corners);
    }
    repaired
}

/// The lines along the repaired edges, and where the parts of each line start, with their number at the end.
fn repaired_lines(lines: &RaggedArray, repair: &MeshRepair) -> (RaggedArray, Vec<u32>) {
    let (mesh, sources) = (repair.mesh(), repair.vertex_sources());
    let (mut parts, mut starts, mut step) = (RaggedArray::new(), Vec::with_capacity(lines.len() + 1), 0);
    let mut part = Vec::new();
    for line in lines.iter() {
        starts.push(parts.len() as u32);
        part.clear();
        for &from in &line[..line.len() - 1] {
            let [mut a, mut b] = mesh.edge(mesh.loose_edge(step));
            step += 1;
            if sources[a].to_u32() != from {
                (a, b) = (b, a);
            }
            if part.last() != Some(&a.to_u32()) {
                if !part.is_empty() {
                    parts.push(&part);
                    part.clear();
                }
                part.push(a.to_u32());
            }
            part.push(b.to_u32());
        }
        parts.push(&part);
    }
    starts.push(parts.len() as u32);
    (parts, starts)
}

/// Copies of vertices and parts of lines have the data of what they come from.
fn repaired_data(data: &CellData, repair: &MeshRepair, line_starts: &[u32]) -> CellData {
    match data.kind() {
        GroupKind::Vertices => data.taken_from(repair.vertex_sources().iter().map(|source| source.index())),
        GroupKind::Lines => data.taken_from(
            line_starts
                .windows(2)
                .enumerate()
                .flat_map(|(line, parts)| std::iter::repeat_n(line, (parts[1] - parts[0]) as usize)),
        ),
        GroupKind::Polygons | GroupKind::Cells => data.clone(),
    }
}

fn repaired_group(group: &Group, repair: &MeshRepair, line_starts: &[u32]) -> Group {
    let members = match group.kind() {
        GroupKind::Vertices => {
            let mut is_member = vec![false; repair.vertex_sources().len()];
            for &member in group.members() {
                is_member[member as usize] = true;
            }
            let copies = repair
                .vertex_sources()
                .iter()
                .enumerate()
                .filter(|&(copy, source)| copy != source.index() && is_member[source.index()])
                .map(|(copy, _)| copy as u32);
            group.members().iter().copied().chain(copies).collect()
        }
        GroupKind::Lines => group
            .members()
            .iter()
            .flat_map(|&line| line_starts[line as usize]..line_starts[line as usize + 1])
            .collect(),
        GroupKind::Polygons | GroupKind::Cells => group.members().to_vec(),
    };
    group.with_members(members)
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_geometry::Positions;

    /// Two triangles at vertex 0, a repeated one, a line through vertex 0, and groups of all sorts.
    fn bow_tie() -> Model {
        let positions = Positions::from_flat(2, (0..10).map(f64::from).collect()).unwrap();
        let polygons = RaggedArray::from_lists([[0, 1, 2], [0, 3, 4], [4, 3, 0]]);
        ModelParts {
            lines: RaggedArray::from_lists([vec![1, 0, 3], vec![2, 1]]),
            points: vec![VertexId::new(0)],
            groups: vec![
                Group::new("center", GroupKind::Vertices, vec![0]),
                Group::new("line", GroupKind::Lines, vec![0, 1]),
                Group::new("again", GroupKind::Polygons, vec![2]),
            ],
            data: vec![
                CellData::integers("number", GroupKind::Vertices, 1, vec![0, 1, 2, 3, 4]).unwrap(),
                CellData::reals("length", GroupKind::Lines, 1, vec![2.0, 1.0]).unwrap(),
            ],
            ..Model::from_polygons(positions, polygons).unwrap().into_parts()
        }
        .into_model()
    }

    #[test]
    fn lines_groups_and_repeated_polygons_follow() {
        let request = RepairRequest { split_vertices: true, ..RepairRequest::default() };
        let (model, repair) = repaired(&bow_tie(), request).unwrap();
        model.check().unwrap();
        assert_eq!(repair.vertices_split(), [VertexId::new(0)]);
        assert_eq!(model.vertex_count(), 6);
        assert_eq!(model.positions().point(VertexId::new(5)), [0.0, 1.0]);
        assert_eq!(model.polygons(), &RaggedArray::from_lists([[0, 1, 2], [5, 3, 4], [4, 3, 5]]));
        assert_eq!(model.lines(), &RaggedArray::from_lists([[1, 0], [5, 3], [2, 1]]));
        assert_eq!(model.points(), [VertexId::new(0)]);
        let members: Vec<&[u32]> = model.groups().iter().map(Group::members).collect();
        assert_eq!(members, [&[0, 5][..], &[0, 1, 2], &[2]]);
        assert_eq!(model.data()[0].integer_row(5), Some(vec![0]));
        assert_eq!([0, 1, 2].map(|line| model.data()[1].real_row(line)[0]), [2.0, 2.0, 1.0]);
    }

    #[test]
    fn a_model_without_faults_stays_as_it_is() {
        let request = RepairRequest {
            split_edges: Some(FacesAtEdge::Apart),
            split_vertices: true,
            orient: true,
            drop_repeated: false,
            orient_parts: false,
        };
        let polygons = RaggedArray::from_lists([[0, 1, 2]]);
        let sound = ModelParts { polygons, groups: Vec::new(), ..bow_tie().into_parts() }.into_model();
        assert_eq!(repaired(&sound, request).unwrap().0, sound);
        assert_eq!(repaired(&bow_tie(), RepairRequest::default()).unwrap().0, bow_tie());
        assert_eq!(repaired(&Model::default(), request).unwrap().0, Model::default());
    }

    #[test]
    fn what_is_no_polygon_mesh_is_refused() {
        let facets = coface_io::Structure::Facets(RaggedArray::from_lists([[0, 1, 2, 3]]));
        let error = repaired(&Model::from_structure(facets), RepairRequest::default()).unwrap_err();
        assert_eq!(error.kind(), coface_algebra::ErrorKind::UnsupportedFormat);
    }
}
