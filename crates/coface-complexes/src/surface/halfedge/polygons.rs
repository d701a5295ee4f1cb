//! Halfedge meshes from polygons.

use super::super::edge_identification::{identify_edges, is_sound, polygon_fault};
use super::super::{PolygonMesh, SurfaceDefect};
use super::mesh::{HalfedgeMesh, NONE};
use coface_algebra::RaggedArray;
use coface_algebra::{EdgeId, Error, ErrorKind, FaceId, Fault, VertexId};

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
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::HalfedgeMesh;
    /// use coface_algebra::HalfedgeId;
    /// # fn main() -> Result<(), coface_algebra::Error> {
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
        let sides = match sides_by_lists(vertex_count, polygons) {
            Err(Unmatched::Crowded) => sides_by_sorting(vertex_count, polygons)?,
            other => other,
        };
        match sides {
            Ok(sides) => {
                sides.into_mesh(vertex_count).map_err(|vertex| fan_fault(vertex_count, polygons, vertex))
            }
            Err(Unmatched::Unsound(face)) => Err(polygon_fault(vertex_count, face, polygons.list(face))),
            Err(_) => Err(edge_fault(polygons)),
        }
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
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::PolygonMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
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
            .with_cells([[a.to_u32(), b.to_u32()]])
            .with_fault(Fault::EdgeInFaces { edge: [a, b], faces: Vec::new() })
            .with_cure("remove the edge"));
        }
        HalfedgeMesh::from_polygons(self.vertex_count(), self.polygons())
    }
}

/// Why sides do not make edges.
#[cfg_attr(test, derive(Debug, PartialEq))]
enum Unmatched {
    /// This polygon is none.
    Unsound(usize),
    /// An edge has three sides, or two in the same direction.
    Fault,
    /// Vertices of so many edges that their lists take too long.
    Crowded,
}

/// How the edge between two vertices is found among those met so far.
trait EdgeIndex {
    /// The edge with these ends in either order, if it was met. Asked for one side after the other.
    fn find(&mut self, ends: [u32; 2], met: &[[u32; 2]]) -> Result<Option<u32>, Unmatched>;
    /// Takes up the edge that was asked for last.
    fn insert(&mut self, ends: [u32; 2], edge: u32);
}

/// The edges met so far: the arrays of the mesh, two entries an edge.
#[cfg_attr(test, derive(Debug, PartialEq))]
struct Sides {
    next: Vec<[u32; 2]>,
    source: Vec<[u32; 2]>,
    /// The second is `NONE` as long as the edge has one side.
    face: Vec<[u32; 2]>,
    face_halfedge: Vec<u32>,
    boundary_edge_count: usize,
}

impl Sides {
    /// Goes through the sides of all polygons, numbering edges as they are met.
    ///
    /// All that is written lies where near sides were filed, so a mesh whose numbers are local stays in the cache.
    fn of_polygons(
        vertex_count: usize,
        polygons: &RaggedArray,
        mut index: impl EdgeIndex,
    ) -> Result<Self, Unmatched> {
        // As many edges as a closed surface has.
        let expected = polygons.item_count() / 2;
        let mut sides = Self {
            next: Vec::with_capacity(expected),
            source: Vec::with_capacity(expected),
            face: Vec::with_capacity(expected),
            face_halfedge: Vec::with_capacity(polygons.len()),
            boundary_edge_count: 0,
        };
        if polygons.uniform_width() == Some(3) {
            // A loop of their own for triangles: nothing in it depends on the size of a polygon.
            for (face, triangle) in (0..).zip(polygons.items().as_chunks::<3>().0) {
                if !is_sound(vertex_count, triangle) {
                    return Err(Unmatched::Unsound(face as usize));
                }
                let &[a, b, c] = triangle;
                let ab = sides.file([a, b], face, &mut index)?;
                let bc = sides.file([b, c], face, &mut index)?;
                let ca = sides.file([c, a], face, &mut index)?;
                let next = sides.next.as_flattened_mut();
                (next[ab as usize], next[bc as usize], next[ca as usize]) = (bc, ca, ab);
                sides.face_halfedge.push(ab);
            }
        } else {
            for (face, polygon) in (0..).zip(polygons.iter()) {
                if !is_sound(vertex_count, polygon) {
                    return Err(Unmatched::Unsound(face as usize));
                }
                let first = sides.file([polygon[0], polygon[1]], face, &mut index)?;
                let mut before = first;
                for (i, &from) in polygon.iter().enumerate().skip(1) {
                    let to = polygon[if i + 1 == polygon.len() { 0 } else { i + 1 }];
                    let halfedge = sides.file([from, to], face, &mut index)?;
                    sides.next.as_flattened_mut()[before as usize] = halfedge;
                    before = halfedge;
                }
                sides.next.as_flattened_mut()[before as usize] = first;
                sides.face_halfedge.push(first);
            }
        }
        Ok(sides)
    }

    /// Files a side that runs between these ends; gives its halfedge.
    #[inline(always)]
    fn file(&mut self, ends: [u32; 2], face: u32, index: &mut impl EdgeIndex) -> Result<u32, Unmatched> {
        if let Some(edge) = index.find(ends, &self.source)? {
            let second = &mut self.face[edge as usize][1];
            if *second != NONE || self.source[edge as usize] == ends {
                return Err(Unmatched::Fault);
            }
            *second = face;
            self.boundary_edge_count -= 1;
            return Ok(2 * edge + 1);
        }
        let edge = self.source.len() as u32;
        self.source.push(ends);
        self.face.push([face, NONE]);
        self.next.push([NONE, NONE]);
        self.boundary_edge_count += 1;
        index.insert(ends, edge);
        Ok(2 * edge)
    }

    /// The mesh of these edges, or a vertex of several fans.
    fn into_mesh(self, vertex_count: usize) -> Result<HalfedgeMesh, VertexId> {
        let outer: Vec<u32> = if self.boundary_edge_count == 0 {
            Vec::new()
        } else {
            (0..).zip(&self.face).filter(|(_, face)| face[1] == NONE).map(|(edge, _)| 2 * edge + 1).collect()
        };
        let [next, source, face] = [self.next, self.source, self.face].map(|pairs| {
            let mut flat = pairs.into_flattened();
            flat.shrink_to_fit();
            flat
        });
        HalfedgeMesh::filled(vertex_count, next, source, face, self.face_halfedge, &outer)
    }
}

/// Lists of edges, one for each vertex, of those whose larger end it is.
struct EdgeLists {
    /// The edge that is last in the list of each vertex.
    last: Vec<u32>,
    /// The edge before each one in its list.
    before: Vec<u32>,
    /// How many more edges may be passed.
    budget: usize,
}

impl EdgeIndex for EdgeLists {
    #[inline(always)]
    fn find(&mut self, [from, to]: [u32; 2], met: &[[u32; 2]]) -> Result<Option<u32>, Unmatched> {
        let mut edge = self.last[from.max(to) as usize];
        while edge != NONE {
            let ends = met[edge as usize];
            if ends == [to, from] || ends == [from, to] {
                return Ok(Some(edge));
            }
            edge = self.before[edge as usize];
            self.budget -= 1;
            if self.budget == 0 {
                return Err(Unmatched::Crowded);
            }
        }
        Ok(None)
    }

    #[inline(always)]
    fn insert(&mut self, [from, to]: [u32; 2], edge: u32) {
        let last = &mut self.last[from.max(to) as usize];
        self.before.push(*last);
        *last = edge;
    }
}

/// The edges of all sides in turn, found by sorting, with the numbers that they get here.
struct SortedEdges<E> {
    edges: E,
    numbers: Vec<u32>,
    at: usize,
}

impl<E: Iterator<Item = u32>> EdgeIndex for SortedEdges<E> {
    fn find(&mut self, _: [u32; 2], _: &[[u32; 2]]) -> Result<Option<u32>, Unmatched> {
        self.at = self.edges.next().expect("each side has an edge") as usize;
        Ok(Some(self.numbers[self.at]).filter(|&edge| edge != NONE))
    }

    fn insert(&mut self, _: [u32; 2], edge: u32) {
        self.numbers[self.at] = edge;
    }
}

/// Finds edges in lists at their vertices.
fn sides_by_lists(vertex_count: usize, polygons: &RaggedArray) -> Result<Sides, Unmatched> {
    let side_count = polygons.item_count();
    let index = EdgeLists {
        last: vec![NONE; vertex_count],
        before: Vec::with_capacity(side_count / 2),
        budget: 16 * side_count + 1024,
    };
    Sides::of_polygons(vertex_count, polygons, index)
}

/// The same by sorting, for vertices of any degree.
fn sides_by_sorting(vertex_count: usize, polygons: &RaggedArray) -> Result<Result<Sides, Unmatched>, Error> {
    let table = identify_edges(vertex_count, polygons, &[])?;
    let index = SortedEdges {
        edges: table.corner_edges.into_iter(),
        numbers: vec![NONE; table.ends.len() / 2],
        at: 0,
    };
    Ok(Sides::of_polygons(vertex_count, polygons, index))
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
        .with_cells([[a, b]])
        .with_fault(Fault::EdgeInFaces {
            edge: [a, b].map(VertexId::from_u32),
            faces: edge.iter().map(|&(_, face, _)| FaceId::from_u32(face)).collect(),
        })
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
    .with_cells([[a, b]])
    .with_fault(Fault::IncoherentFaces {
        edge: [a, b].map(VertexId::from_u32),
        faces: [f, g].map(FaceId::from_u32),
    })
    .with_cure("turn faces around so that all agree, which orienting the mesh does if it is orientable")
}

/// The fans of faces at a vertex that has several.
#[cold]
fn fan_fault(vertex_count: usize, polygons: &RaggedArray, vertex: VertexId) -> Error {
    let link = match PolygonMesh::new(vertex_count, polygons.clone(), &[]) {
        Ok(mesh) => mesh.link_components(vertex),
        Err(error) => return error,
    };
    let mut fans = vec![Vec::new(); link.len()];
    for (face, polygon) in polygons.iter().enumerate() {
        let Some(at) = polygon.iter().position(|&corner| corner == vertex.to_u32()) else { continue };
        let next = VertexId::from_u32(polygon[(at + 1) % polygon.len()]);
        if let Some(fan) = link.iter().position(|component| component.vertices().contains(&next)) {
            fans[fan].push(FaceId::new(face));
        }
    }
    Error::new(ErrorKind::NonManifold, SurfaceDefect::SeveralFans { vertex, link }.message())
        .with_cells([[vertex.to_u32()]])
        .with_fault(Fault::VertexWithFans { vertex, fans })
        .with_cure("split the vertex, one copy for each fan")
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn lists_and_sorting_agree(
            polygons in prop::collection::vec(
                (Just((0u32..9).collect::<Vec<_>>()).prop_shuffle(), 3usize..6), 0..6),
        ) {
            let polygons = RaggedArray::from_lists(polygons.iter().map(|(cycle, n)| &cycle[..*n]));
            let sorted = sides_by_sorting(9, &polygons).unwrap();
            prop_assert_eq!(sides_by_lists(9, &polygons), sorted);
        }

        #[test]
        fn closed_triangulations_agree_too(columns in 3u32..7, rows in 3u32..6, step in 1u32..5) {
            let count = columns * rows;
            prop_assume!((1..=count).filter(|d| count % d == 0 && step % d == 0).count() == 1);
            let triangles = super::super::tests::torus_triangles(columns, rows, |v| v * step % count);
            let polygons = RaggedArray::from_lists(triangles);
            let sorted = sides_by_sorting(count as usize, &polygons).unwrap();
            prop_assert_eq!(sorted.as_ref().map(|sides| sides.boundary_edge_count), Ok(0));
            prop_assert_eq!(sides_by_lists(count as usize, &polygons), sorted);
        }
    }

    #[test]
    fn edges_at_a_hub_are_too_many_for_lists() {
        let n = 3000;
        let fan: Vec<[u32; 3]> = (0..n).map(|i| [i * 7 % n, (i * 7 + 1) % n, n]).collect();
        let polygons = RaggedArray::from_lists(fan);
        assert_eq!(sides_by_lists(n as usize + 1, &polygons), Err(Unmatched::Crowded));
        assert!(sides_by_sorting(n as usize + 1, &polygons).unwrap().is_ok());
    }
}
