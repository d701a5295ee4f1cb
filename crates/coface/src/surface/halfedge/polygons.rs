//! Halfedge meshes from polygons.

use super::super::PolygonMesh;
use super::super::edge_identification::{identify_edges, is_sound, polygon_fault};
use super::mesh::{HalfedgeMesh, NONE};
use crate::algebra::RaggedArray;
use crate::{EdgeId, Error, ErrorKind, FaceId, VertexId};

/// The most sides of polygons.
const SIDE_LIMIT: usize = 1 << 30;

impl HalfedgeMesh {
    /// The surface of these polygons, each a cycle of at least three vertices that runs counterclockwise, on the vertices
    /// `0..vertex_count`. Boundary loops are filled with outer faces.
    ///
    /// Face i is polygon i, and its first halfedge the side from corner 0 to corner 1. Edges are numbered as the polygons
    /// meet them, and point as the first side does, which is the halfedge 2e. Two polygons on the same vertices, one
    /// each way around, are a sphere.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] naming the first polygon with a vertex that does not exist, a repeated vertex, or too few
    /// vertices; [`ErrorKind::NonManifold`] naming an edge in three or more faces, two faces that run through an edge in
    /// the same direction, or a vertex with several fans of faces, which it lists; [`ErrorKind::TooLarge`] from 2^30 sides
    /// on.
    ///
    /// # Complexity
    /// Linear but for vertices of very many edges, which cost nearly linear time. Fastest when faces with near numbers
    /// have vertices with near numbers.
    ///
    /// # Examples
    /// Two triangles on an edge: a disk, whose outer face has four halfedges.
    /// ```
    /// use coface::algebra::RaggedArray;
    /// use coface::surface::HalfedgeMesh;
    /// use coface::HalfedgeId;
    /// # fn main() -> Result<(), coface::Error> {
    /// let mesh = HalfedgeMesh::from_polygons(4, &RaggedArray::from_lists([[0, 1, 2], [2, 1, 3]]))?;
    /// assert_eq!(mesh.f_vector(), [4, 5, 2]);
    /// assert_eq!((mesh.outer_face_count(), mesh.halfedge_count()), (1, 10));
    /// let shared = HalfedgeId::new(2);
    /// assert_eq!((mesh.source(shared).index(), mesh.target(shared).index()), (1, 2));
    /// assert_eq!(mesh.face(mesh.twin(shared)).index(), 1);
    /// # Ok(()) }
    /// ```
    pub fn from_polygons(vertex_count: usize, polygons: &RaggedArray) -> Result<Self, Error> {
        if polygons.item_count() >= SIDE_LIMIT || vertex_count >= NONE as usize {
            return Err(Error::new(
                ErrorKind::TooLarge,
                format!(
                    "{vertex_count} vertices and {} sides of faces; the limits are 2^32 - 2 and 2^30 - 1",
                    polygons.item_count()
                ),
            ));
        }
        if let Some(face) = (0..polygons.len()).find(|&face| !is_sound(vertex_count, polygons.list(face))) {
            return Err(polygon_fault(vertex_count, face, polygons.list(face)));
        }
        let matched = match match_sides(vertex_count, polygons) {
            Err(Unmatched::Crowded) => match_sorted_sides(vertex_count, polygons)?,
            other => other,
        };
        let Ok(sides) = matched else { return Err(edge_fault(polygons)) };
        let count = 2 * sides.edge_count;
        let (mut next, mut source, mut face) = (vec![NONE; count], vec![NONE; count], vec![NONE; count]);
        let mut first_halfedges = Vec::with_capacity(polygons.len());
        for (number, polygon) in polygons.iter().enumerate() {
            let start = polygons.start(number);
            let halfedges = &sides.halfedges[start..start + polygon.len()];
            first_halfedges.push(halfedges[0]);
            let mut before = halfedges[halfedges.len() - 1];
            for (&h, &vertex) in halfedges.iter().zip(polygon) {
                next[before as usize] = h;
                source[h as usize] = vertex;
                face[h as usize] = number as u32;
                before = h;
            }
        }
        drop(sides);
        Self::filled(vertex_count, next, source, face, first_halfedges)
            .map_err(|vertex| fan_fault(vertex_count, polygons, vertex))
    }
}

impl PolygonMesh {
    /// The mesh as an oriented surface of halfedges: vertices and faces keep their ids; edges are numbered as the faces
    /// meet them, see [`HalfedgeMesh::from_polygons`].
    ///
    /// # Errors
    /// [`ErrorKind::NonManifold`] naming an edge in no face, or what [`HalfedgeMesh::from_polygons`] names.
    ///
    /// # Examples
    /// ```
    /// use coface::algebra::RaggedArray;
    /// use coface::surface::PolygonMesh;
    /// # fn main() -> Result<(), coface::Error> {
    /// let mesh = PolygonMesh::new(4, RaggedArray::from_lists([[0, 1, 2]]), &[[2, 3]])?;
    /// assert_eq!(
    ///     mesh.halfedges().unwrap_err().message(),
    ///     "edge e3 = {v2, v3} lies in no face, so the mesh is no surface"
    /// );
    /// # Ok(()) }
    /// ```
    pub fn halfedges(&self) -> Result<HalfedgeMesh, Error> {
        if let Some(edge) = self.edge_degrees().position(|degree| degree == 0) {
            let [a, b] = self.edge(EdgeId::new(edge));
            return Err(Error::new(
                ErrorKind::NonManifold,
                format!("edge e{edge} = {{{a}, {b}}} lies in no face, so the mesh is no surface"),
            )
            .with_cure("remove the edge"));
        }
        HalfedgeMesh::from_polygons(self.vertex_count(), self.polygons())
    }
}

/// The halfedge of each side of the polygons, sides in the order of corners.
struct Sides {
    halfedges: Vec<u32>,
    edge_count: usize,
}

/// Why sides were not matched.
enum Unmatched {
    /// An edge has three sides, or two in the same direction.
    Fault,
    /// Vertices of so many edges that their lists take too long.
    Crowded,
}

/// Numbers the edges in the order of their first sides.
///
/// The edges met so far stand in lists, one for each vertex that is the larger end of edges. A mesh whose vertices are
/// numbered near each other where faces are near finds all of a list in the cache.
fn match_sides(vertex_count: usize, polygons: &RaggedArray) -> Result<Sides, Unmatched> {
    /// An edge met: its smaller end, the edge that was first in the list before, and which directions it had.
    #[derive(Clone, Copy)]
    struct Met {
        smaller: u32,
        before: u32,
        directions: u8,
    }
    let mut last = vec![NONE; vertex_count];
    let mut met: Vec<Met> = Vec::with_capacity(polygons.item_count() / 2 + 64);
    let mut halfedges = Vec::with_capacity(polygons.item_count());
    let mut budget = 16 * polygons.item_count() as i64 + 1024;
    for polygon in polygons.iter() {
        let mut from = polygon[0];
        for &to in polygon[1..].iter().chain(&polygon[..1]) {
            let (smaller, larger, direction) = if from < to { (from, to, 1) } else { (to, from, 2) };
            from = to;
            let head = &mut last[larger as usize];
            let mut edge = *head;
            while edge != NONE && met[edge as usize].smaller != smaller {
                edge = met[edge as usize].before;
                budget -= 1;
            }
            if edge == NONE {
                edge = met.len() as u32;
                met.push(Met { smaller, before: *head, directions: direction });
                *head = edge;
                halfedges.push(2 * edge);
            } else {
                let directions = &mut met[edge as usize].directions;
                if *directions != 3 - direction {
                    return Err(Unmatched::Fault);
                }
                *directions = 3;
                halfedges.push(2 * edge + 1);
            }
        }
        if budget < 0 {
            return Err(Unmatched::Crowded);
        }
    }
    Ok(Sides { halfedges, edge_count: met.len() })
}

/// The same by sorting, whatever the degrees of vertices.
fn match_sorted_sides(
    vertex_count: usize,
    polygons: &RaggedArray,
) -> Result<Result<Sides, Unmatched>, Error> {
    let edges = identify_edges(vertex_count, polygons, &[])?;
    let starts = &edges.face_starts;
    let is_fault = |pair: &[u32]| match edges.faces[pair[0] as usize..pair[1] as usize] {
        [_] => false,
        [f, g] => (f ^ g) & 1 == 0,
        _ => true,
    };
    if starts.windows(2).any(is_fault) {
        return Ok(Err(Unmatched::Fault));
    }
    let mut numbers = vec![NONE; edges.ends.len() / 2];
    let mut edge_count = 0;
    let halfedges = edges
        .corner_edges
        .iter()
        .map(|&edge| {
            let number = &mut numbers[edge as usize];
            if *number == NONE {
                *number = edge_count;
                edge_count += 1;
                2 * *number
            } else {
                2 * *number + 1
            }
        })
        .collect();
    Ok(Ok(Sides { halfedges, edge_count: edge_count as usize }))
}

/// What is wrong with the first edge that has more than two sides or two in the same direction.
#[cold]
fn edge_fault(polygons: &RaggedArray) -> Error {
    let mut sides: Vec<([u32; 2], u32, bool)> = Vec::with_capacity(polygons.item_count());
    for (face, polygon) in polygons.iter().enumerate() {
        for (i, &from) in polygon.iter().enumerate() {
            let to = polygon[if i + 1 == polygon.len() { 0 } else { i + 1 }];
            sides.push(([from.min(to), from.max(to)], face as u32, from < to));
        }
    }
    sides.sort_unstable();
    let named = |face: u32| FaceId::from_u32(face).to_string();
    let edges = || sides.chunk_by(|a, b| a.0 == b.0);
    if let Some(edge) = edges().find(|sides| sides.len() > 2) {
        let ([a, b], ..) = edge[0];
        let listed: Vec<String> = edge.iter().take(8).map(|&(_, face, _)| named(face)).collect();
        let more = if edge.len() > 8 { ", .." } else { "" };
        return Error::new(
            ErrorKind::NonManifold,
            format!(
                "edge {{v{a}, v{b}}} lies in {} faces: {}{more}; a surface has at most two there",
                edge.len(),
                listed.join(", ")
            ),
        )
        .with_cure("remove faces there, or cut the mesh along the edge");
    }
    let incoherent = edges().find(|edge| matches!(edge, [f, g] if f.2 == g.2));
    let &[([a, b], f, forward), (_, g, _)] = incoherent.expect("some edge was found at fault") else {
        unreachable!("an incoherent edge has two sides")
    };
    let [a, b] = if forward { [a, b] } else { [b, a] };
    Error::new(
        ErrorKind::NonManifold,
        format!("faces {} and {} both run from v{a} to v{b}, so they do not agree there", named(f), named(g)),
    )
    .with_cure("turn faces around so that all agree, which orienting the mesh does if it is orientable")
}

/// The fans of faces at a vertex that has several.
#[cold]
fn fan_fault(vertex_count: usize, polygons: &RaggedArray, vertex: VertexId) -> Error {
    let message = match PolygonMesh::new(vertex_count, polygons.clone(), &[]) {
        Ok(mesh) => {
            let link = mesh.link_components(vertex);
            super::super::SurfaceDefect::SeveralFans { vertex, link }.message()
        }
        Err(error) => return error,
    };
    Error::new(ErrorKind::NonManifold, message).with_cure("split the vertex, one copy for each fan")
}
