//! Surfaces as permutations of halfedges, surfaces of polygons again, and their duals.

use crate::SurfaceModel;
use coface_algebra::{EdgeId, Error, ErrorKind, FaceId, RaggedArray, VertexId};
use coface_complexes::surface::{GeneralizedMap, HalfedgePermutations};
use coface_geometry::Positions;
use coface_io::{Model, Place, Remark, RemarkCode, Structure};

/// An oriented surface as permutations of its halfedges, with positions.
///
/// Halfedges are numbered along the polygons of the file, those of outer faces after them. So polygon i is face i, and vertices
/// are numbered as the polygons meet them; isolated vertices are left out, and polygons that do not agree with the first of their
/// component are turned. A remark each says so, and which number the first vertices had.
///
/// # Errors
/// Those of [`SurfaceModel::of`] and [`HalfedgePermutations::of_map`].
///
/// # Examples
/// ```
/// use coface_answers::halfedge_model;
/// use coface_io::{Format, Structure};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let square = coface_io::read(&b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n"[..], Format::Obj)?;
/// let model = halfedge_model(square)?;
/// let Some(Structure::Halfedges { outer, .. }) = model.structure() else { panic!() };
/// assert_eq!((&outer[..], model.vertex_count()), (&[2][..], 4));
/// # Ok(()) }
/// ```
pub fn halfedge_model(model: Model) -> Result<Model, Error> {
    if matches!(model.structure(), Some(Structure::Halfedges { .. })) {
        return Ok(model);
    }
    let surface = SurfaceModel::of(model)?;
    let map = surface.map();
    let (permutations, vertices) = HalfedgePermutations::of_map(map)
        .map_err(|error| error.with_vertex_numbers(|vertex| surface.number(VertexId::from_u32(vertex))))?;
    surface.require_finite()?;
    let mut remarks = Vec::new();
    let isolated = surface.isolated_vertices();
    if !isolated.is_empty() {
        let message = format!(
            "{} in no face left out: they have no halfedges",
            crate::text::count(isolated.len(), "vertex")
        );
        let places = isolated.iter().take(10).map(|&vertex| Place::cell(&[vertex]));
        remarks.push(Remark::new(RemarkCode::IsolatedVertex, message).at(isolated.len(), places));
    }
    let orientation = map.orientation();
    let turned = orientation.signs().iter().filter(|&&sign| sign == coface_algebra::Sign::Minus).count();
    if turned > 0 {
        let message = format!("{} turned, so that all agree", crate::text::count(turned, "face"));
        remarks.push(Remark::new(RemarkCode::ModelRepaired, message).at(turned, []));
    }
    remarks.extend(renumbered(&surface, &vertices));
    let positions = match surface.positions() {
        given if given.is_empty() => Positions::default(),
        given => {
            let points = vertices.iter().flat_map(|&vertex| given.point(vertex)).copied().collect();
            Positions::from_flat(given.dimension(), points)?
        }
    };
    let mut parts = Model::from_halfedges(permutations, positions)?.into_parts();
    parts.remarks = remarks;
    Ok(parts.into_model())
}

/// That vertices have other numbers than in the file, if some have: the first vertices, each by its number in the file.
fn renumbered(surface: &SurfaceModel, vertices: &[VertexId]) -> Option<Remark> {
    let moved: Vec<(usize, VertexId)> = vertices
        .iter()
        .copied()
        .enumerate()
        .filter(|&(number, vertex)| surface.number(vertex) as usize != number)
        .collect();
    let &(first, vertex) = moved.first()?;
    let message = format!(
        "{} renumbered in the order in which the faces meet them: vertex {first} is {} of the file",
        crate::text::count(moved.len(), "vertex"),
        surface.number(vertex),
    );
    let places = moved.iter().take(10).map(|&(_, vertex)| Place::cell(&[surface.number(vertex)]));
    Some(Remark::new(RemarkCode::VerticesRenumbered, message).at(moved.len(), places))
}

/// A surface of halfedges with positions as polygons on its vertices; any other model as it stands.
///
/// # Errors
/// [`ErrorKind::InvalidInput`] if a face has fewer than three sides or a vertex twice, which polygons cannot.
///
/// # Examples
/// ```
/// use coface_answers::{halfedge_model, polygon_model};
/// use coface_io::Format;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let square = coface_io::read(&b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n"[..], Format::Obj)?;
/// let again = polygon_model(halfedge_model(square.clone())?)?;
/// assert_eq!(again.polygons(), square.polygons());
/// # Ok(()) }
/// ```
pub fn polygon_model(model: Model) -> Result<Model, Error> {
    let Some(Structure::Halfedges { next, twin, outer }) = model.structure() else { return Ok(model) };
    if model.positions().is_empty() {
        return Ok(model);
    }
    let mesh = HalfedgePermutations::new(next.clone(), twin.clone(), outer.clone())?.mesh()?;
    Model::from_polygons(model.positions().clone(), mesh.polygons())
}

/// The dual of a surface: a vertex in each face, an edge across each edge, a face around each vertex.
///
/// A surface with boundary has a vertex on each boundary edge and at each boundary vertex too, so that its dual is the same
/// surface. With positions it is a mesh of polygons: vertices of faces lie at the mean of their corners, those of boundary edges
/// in their middle. A closed oriented surface of halfedges without positions has halfedges again. Isolated vertices are left
/// out.
///
/// # Errors
/// Those of [`SurfaceModel::of`]; [`ErrorKind::InvalidInput`] where a vertex lies in fewer than three faces and the dual would be
/// no polygons; [`ErrorKind::UnsupportedFormat`] for other surfaces without positions.
///
/// # Examples
/// The dual of a cube is an octahedron.
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_answers::dual_model;
/// use coface_geometry::Positions;
/// use coface_io::Model;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let corners = (0..8).flat_map(|i| [i & 1, i >> 1 & 1, i >> 2]).map(f64::from).collect();
/// let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
/// let cube = Model::from_polygons(Positions::from_flat(3, corners)?, RaggedArray::from_lists(faces))?;
/// let dual = dual_model(cube)?;
/// assert_eq!((dual.vertex_count(), dual.polygons().len()), (6, 8));
/// assert!(dual.polygons().iter().all(|triangle| triangle.len() == 3));
/// # Ok(()) }
/// ```
pub fn dual_model(model: Model) -> Result<Model, Error> {
    if let Some(Structure::Halfedges { next, twin, outer }) = model.structure()
        && model.positions().is_empty()
    {
        if !outer.is_empty() {
            return Err(without_positions());
        }
        // Around a face of the dual: twin, then next.
        let dual = twin.iter().map(|&mate| next[mate as usize]).collect();
        let permutations = HalfedgePermutations::new(dual, twin.clone(), Vec::new())?;
        return Model::from_halfedges(permutations, Positions::default());
    }
    let surface = SurfaceModel::of(polygon_model(model)?)?;
    surface.require_finite()?;
    if surface.positions().is_empty() {
        return Err(without_positions());
    }
    let dual = DualVertices::of(&surface)?;
    let map = surface.map();
    let mut is_met = vec![false; map.vertex_count()];
    let mut polygons = RaggedArray::new();
    for side in map.sides() {
        let vertex = map.source(side);
        if std::mem::replace(&mut is_met[vertex.index()], true) {
            continue;
        }
        polygons.push(&dual.around(map, side.to_u32() << 1));
    }
    Model::from_polygons(dual.positions, polygons)
}

/// The dual graph of a surface: a vertex in each face, and a line across each edge between two faces.
///
/// # Errors
/// Those of [`SurfaceModel::of`]; [`ErrorKind::UnsupportedFormat`] for a surface without positions.
///
/// # Examples
/// ```
/// use coface_answers::dual_graph_model;
/// use coface_io::Format;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let square = coface_io::read(&b"v 0 0 0\nv 3 0 0\nv 3 3 0\nv 0 3 0\nf 1 2 3\nf 1 3 4\n"[..], Format::Obj)?;
/// let graph = dual_graph_model(square)?;
/// assert_eq!((graph.vertex_count(), graph.lines().len()), (2, 1));
/// assert_eq!(graph.positions().as_flat()[..2], [2.0, 1.0]);
/// # Ok(()) }
/// ```
pub fn dual_graph_model(model: Model) -> Result<Model, Error> {
    let surface = SurfaceModel::of(polygon_model(model)?)?;
    surface.require_finite()?;
    let (map, positions) = (surface.map(), surface.positions());
    if positions.is_empty() {
        return Err(without_positions());
    }
    let mut points = Vec::new();
    for face in (0..map.face_count()).map(FaceId::new) {
        push_mean(&mut points, positions, &corners(map, face));
    }
    let arcs = (0..map.edge_count()).filter_map(|edge| map.dual_arc(EdgeId::new(edge)));
    let lines = RaggedArray::from_lists(arcs.filter(|[a, b]| a != b).map(|arc| arc.map(FaceId::to_u32)));
    Model::from_lines(Positions::from_flat(positions.dimension(), points)?, lines)
}

fn without_positions() -> Error {
    Error::new(
        ErrorKind::UnsupportedFormat,
        "the vertices have no positions, and the dual needs some for its own",
    )
    .with_cure("give a mesh with positions, or a closed surface of halfedges")
}

fn corners(map: &GeneralizedMap, face: FaceId) -> Vec<VertexId> {
    map.sides_of(face).map(|side| map.source(side)).collect()
}

fn push_mean(points: &mut Vec<f64>, positions: &Positions, vertices: &[VertexId]) {
    for axis in 0..positions.dimension() {
        let sum: f64 = vertices.iter().map(|&vertex| positions.point(vertex)[axis]).sum();
        points.push(sum / vertices.len() as f64);
    }
}

/// The vertices of the dual: those of faces first, then those of boundary edges and boundary vertices.
struct DualVertices {
    positions: Positions,
    /// The vertex in the middle of each boundary edge.
    of_edge: Vec<Option<u32>>,
    /// The vertex at each boundary vertex.
    of_vertex: Vec<Option<u32>>,
}

impl DualVertices {
    fn of(surface: &SurfaceModel) -> Result<Self, Error> {
        let (map, positions) = (surface.map(), surface.positions());
        let mut points = Vec::new();
        for face in (0..map.face_count()).map(FaceId::new) {
            push_mean(&mut points, positions, &corners(map, face));
        }
        let mut count = map.face_count() as u32;
        let mut of_edge = vec![None; map.edge_count()];
        let mut of_vertex = vec![None; map.vertex_count()];
        for side in map.sides().filter(|&side| map.mate(side).is_none()) {
            let ends = [map.source(side), map.target(side)];
            let mut add = |place: &mut Option<u32>, vertices: &[VertexId]| {
                if place.is_none() {
                    *place = Some(count);
                    count += 1;
                    push_mean(&mut points, positions, vertices);
                }
            };
            add(&mut of_edge[map.edge(side).index()], &ends);
            ends.iter().for_each(|&end| add(&mut of_vertex[end.index()], &[end]));
        }
        Ok(Self { positions: Positions::from_flat(positions.dimension(), points)?, of_edge, of_vertex })
    }

    /// The face around a vertex, which a flag is at, in the direction of the faces.
    fn around(&self, map: &GeneralizedMap, flag: u32) -> Vec<u32> {
        let fan = map.fan(flag);
        let side = |flag: u32| coface_algebra::HalfedgeId::from_u32(flag >> 1);
        let edge = |flag: u32| self.of_edge[map.edge(side(flag)).index()];
        let mut polygon = Vec::new();
        polygon.extend(edge(fan[0]));
        polygon.extend(fan.chunks(2).map(|pair| map.face(side(pair[0])).to_u32()));
        if let Some(vertex) = self.of_vertex[map.flag_vertex(flag).index()] {
            polygon.extend(edge(fan[fan.len() - 1]));
            polygon.push(vertex);
        }
        // A fan that leaves its first face by the side that leaves the vertex turns clockwise.
        let leaves = fan[0] & 1 == 0;
        if !leaves {
            polygon.reverse();
        }
        polygon
    }
}
