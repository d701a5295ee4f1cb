//! Repair of meshes that are no coherent surface, on request only: vertices and edges are split, faces turned.

use super::PolygonMesh;
use coface_algebra::{Error, ErrorKind, FaceId, IdVec, VertexId};
use coface_algebra::{RaggedArray, Sign, UnionFind};

/// A mesh under repair, and what has been done to it.
///
/// Each step is done only when it is asked for, changes nothing where nothing is wrong, and is done once: the same step
/// again finds nothing to do. Faces keep their numbers. Old vertices keep their numbers; copies are numbered on from
/// there in the order of the corners that they are first seen at, and [`Self::vertex_sources`] says what they are
/// copies of, so that positions and other data can follow.
///
/// Loose edges that are sides of faces follow the first face at the edge. Other loose edges and isolated vertices stay as
/// they are; no splitting makes a surface of them.
///
/// # Examples
/// Two triangles that touch in vertex 0: the second gets a vertex of its own.
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_complexes::surface::{MeshRepair, PolygonMesh};
/// use coface_algebra::{FaceId, VertexId};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let mesh = PolygonMesh::new(5, RaggedArray::from_lists([[0, 1, 2], [0, 3, 4]]), &[])?;
/// let mut repair = MeshRepair::new(mesh);
/// repair.split_vertices()?;
/// assert!(repair.mesh().manifold_verdict().is_manifold());
/// assert_eq!(repair.mesh().face(FaceId::new(1)), [5, 3, 4]);
/// assert_eq!(repair.vertex_sources()[VertexId::new(5)], VertexId::new(0));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct MeshRepair {
    mesh: PolygonMesh,
    vertex_sources: IdVec<VertexId, VertexId>,
    edges_split: Vec<[VertexId; 2]>,
    vertices_split: Vec<VertexId>,
    faces_turned: Vec<FaceId>,
}

/// Which faces stay together at an edge in three or more faces that is split.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum FacesAtEdge {
    /// None: each face gets the edge for itself.
    Apart,
    /// Pairs that run through the edge in opposite directions: the first that runs along it with the first that runs
    /// against it, the second with the second, by rising face. Those left over get the edge for themselves.
    ///
    /// An edge where pairs could not be told apart by their vertices, because both ends stay common, is split as in
    /// [`Self::Apart`].
    CoherentPairs,
}

impl MeshRepair {
    /// The mesh as it is; nothing done yet.
    pub fn new(mesh: PolygonMesh) -> Self {
        let vertex_sources = (0..mesh.vertex_count()).map(VertexId::new).collect();
        Self {
            mesh,
            vertex_sources,
            edges_split: Vec::new(),
            vertices_split: Vec::new(),
            faces_turned: Vec::new(),
        }
    }

    /// The mesh as it is now.
    pub fn mesh(&self) -> &PolygonMesh {
        &self.mesh
    }

    /// The mesh as it is now, given away.
    pub fn into_mesh(self) -> PolygonMesh {
        self.mesh
    }

    /// For each vertex the vertex of the given mesh that it is, or is a copy of.
    pub fn vertex_sources(&self) -> &IdVec<VertexId, VertexId> {
        &self.vertex_sources
    }

    /// The edges of the given mesh that were split by [`Self::split_edges`], as pairs of its vertices, rising.
    pub fn edges_split(&self) -> &[[VertexId; 2]] {
        &self.edges_split
    }

    /// The vertices of the given mesh that have copies now, rising.
    pub fn vertices_split(&self) -> &[VertexId] {
        &self.vertices_split
    }

    /// The faces that were turned around, rising.
    pub fn faces_turned(&self) -> &[FaceId] {
        &self.faces_turned
    }

    /// Gives each fan of faces at a vertex its own copy of the vertex. The fan of the first face keeps the vertex.
    ///
    /// Faces are in one fan at a vertex when one comes to the other across edges at it, however many faces an edge has.
    /// When no edge lies in three or more faces, and none in no face, the result is a surface.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] when the copies do not fit in 32 bits.
    ///
    /// # Complexity
    /// Nearly linear, by union-find on the corners.
    pub fn split_vertices(&mut self) -> Result<(), Error> {
        let sides = SidesAtEdges::new(&self.mesh);
        let mut fans = UnionFind::new(self.mesh.polygons().item_count());
        for edge in 0..self.mesh.edge_count() {
            for pair in sides.at(edge).windows(2) {
                sides.join(&self.mesh, &mut fans, pair[0], pair[1]);
            }
        }
        self.give_copies(&copies_of_fans(&self.mesh, &mut fans, |_| true)?)
    }

    /// Splits the edges in three or more faces; `together` says which faces stay together there. The ends of such an edge
    /// are split into the fans that remain; other vertices are left alone, see [`Self::split_vertices`].
    ///
    /// An edge is known by its ends. So two faces whose corners stay together at both ends, around the ends, stay
    /// together: a wall inside a sphere comes off, and the sphere stays closed. No edge of the result lies in three or
    /// more faces, and the ends of the split edges have one fan each.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] when the copies do not fit in 32 bits.
    ///
    /// # Complexity
    /// Nearly linear for [`FacesAtEdge::Apart`]. For pairs the same once more each time that edges are found where
    /// pairs cannot be told apart.
    ///
    /// # References
    /// A. Gueziec, G. Taubin, F. Lazarus, W. Horn, *Cutting and stitching: converting sets of polygons to manifold
    /// surfaces* (2001), for cutting and the choice between local and pairwise stitching.
    ///
    /// # Examples
    /// Three pages of a book, two of which run through the spine in opposite directions:
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::{FacesAtEdge, MeshRepair, PolygonMesh};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let book = PolygonMesh::new(5, RaggedArray::from_lists([[0, 1, 2], [0, 1, 3], [1, 0, 4]]), &[])?;
    /// let mut apart = MeshRepair::new(book.clone());
    /// apart.split_edges(FacesAtEdge::Apart)?;
    /// assert_eq!(apart.mesh().f_vector(), [9, 9, 3]);
    /// let mut pairs = MeshRepair::new(book);
    /// pairs.split_edges(FacesAtEdge::CoherentPairs)?;
    /// assert_eq!(pairs.mesh().f_vector(), [7, 8, 3]);
    /// # Ok(()) }
    /// ```
    pub fn split_edges(&mut self, together: FacesAtEdge) -> Result<(), Error> {
        let mesh = &self.mesh;
        let crowded: Vec<usize> =
            mesh.edge_degrees().enumerate().filter(|&(_, faces)| faces > 2).map(|(edge, _)| edge).collect();
        if crowded.is_empty() {
            return Ok(());
        }
        let mut is_end = vec![false; mesh.vertex_count()];
        for end in crowded.iter().flat_map(|&edge| mesh.ends(edge)) {
            is_end[end as usize] = true;
        }
        let sides = SidesAtEdges::new(mesh);
        let mut apart = vec![together == FacesAtEdge::Apart; mesh.edge_count()];
        let copies = loop {
            let mut fans = UnionFind::new(mesh.polygons().item_count());
            for (edge, &apart) in apart.iter().enumerate() {
                match sides.at(edge) {
                    &[side, other] => sides.join(mesh, &mut fans, side, other),
                    many if many.len() > 2 && !apart => {
                        for (side, other) in sides.coherent_pairs(mesh, edge) {
                            sides.join(mesh, &mut fans, side, other);
                        }
                    }
                    _ => {}
                }
            }
            let copies = copies_of_fans(mesh, &mut fans, |v| is_end[v as usize])?;
            // An edge all of whose faces are apart has at most two of them between the same copies of its ends: a fan
            // that is cut there ends there, and it has two ends.
            let clashing: Vec<usize> = crowded
                .iter()
                .copied()
                .filter(|&edge| !apart[edge] && sides.still_crowded(mesh, edge, &copies.of_corner))
                .collect();
            if clashing.is_empty() {
                break copies;
            }
            for edge in clashing {
                apart[edge] = true;
            }
        };
        let ends = |&edge: &usize| mesh.ends(edge).map(|v| self.vertex_sources[VertexId::from_u32(v)]);
        let mut split: Vec<[VertexId; 2]> = crowded.iter().map(ends).collect();
        for pair in &mut split {
            pair.sort_unstable();
        }
        self.edges_split.append(&mut split);
        self.edges_split.sort_unstable();
        self.edges_split.dedup();
        self.give_copies(&copies)
    }

    /// Turns faces so that all agree; the first face of each strongly connected part keeps its direction.
    ///
    /// # Errors
    /// Those of [`PolygonMesh::oriented`]: an edge in three or more faces, and a mesh that is not orientable.
    ///
    /// # Complexity
    /// That of [`PolygonMesh::orientation`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::{MeshRepair, PolygonMesh};
    /// use coface_algebra::FaceId;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mesh = PolygonMesh::new(4, RaggedArray::from_lists([[0, 1, 2], [1, 2, 3]]), &[])?;
    /// let mut repair = MeshRepair::new(mesh);
    /// repair.orient()?;
    /// assert_eq!(repair.faces_turned(), [FaceId::new(1)]);
    /// # Ok(()) }
    /// ```
    pub fn orient(&mut self) -> Result<(), Error> {
        let orientation = self.mesh.orientation();
        let turned: Vec<FaceId> = (0..self.mesh.face_count())
            .map(FaceId::new)
            .filter(|&face| orientation.sign(face) == Sign::Minus)
            .collect();
        self.mesh = self.mesh.oriented()?;
        self.note_turned(&turned);
        Ok(())
    }

    /// Turns faces so that all of each part agree where they can; a part, strongly connected through edges in two faces, that is not
    /// orientable stays as it is.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # Examples
    /// A Moebius band of five triangles beside two triangles that run against each other.
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::{MeshRepair, PolygonMesh};
    /// use coface_algebra::FaceId;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let band = [[0, 1, 2], [1, 2, 3], [2, 3, 4], [3, 4, 0], [4, 0, 1]];
    /// let faces = RaggedArray::from_lists(band.into_iter().chain([[5, 6, 7], [6, 7, 8]]));
    /// let mut repair = MeshRepair::new(PolygonMesh::new(9, faces, &[])?);
    /// repair.orient_parts();
    /// assert_eq!(repair.faces_turned(), [FaceId::new(6)]);
    /// # Ok(()) }
    /// ```
    pub fn orient_parts(&mut self) {
        let mesh = &self.mesh;
        let mut signs: Vec<Option<Sign>> = vec![None; mesh.face_count()];
        let mut part = Vec::new();
        for first in 0..mesh.face_count() {
            if signs[first].is_some() {
                continue;
            }
            signs[first] = Some(Sign::Plus);
            part.clear();
            part.push(first);
            let (mut next, mut is_orientable) = (0, true);
            while let Some(&face) = part.get(next) {
                next += 1;
                for (edge, sign) in mesh.face_edges(FaceId::new(face)) {
                    if mesh.face_count_at(edge) != 2 {
                        continue;
                    }
                    let of_face = signs[face].expect("a face of the part has a sign");
                    let others = mesh.faces_of_edge(edge).filter(|(other, _)| other.index() != face);
                    for (other, at_other) in others {
                        // Two faces agree when they run along the edge in opposite directions.
                        let agree = sign != at_other;
                        let wanted = if agree { of_face } else { of_face.opposite() };
                        match signs[other.index()] {
                            None => {
                                signs[other.index()] = Some(wanted);
                                part.push(other.index());
                            }
                            Some(found) => is_orientable &= found == wanted,
                        }
                    }
                }
            }
            if !is_orientable {
                part.iter().for_each(|&face| signs[face] = Some(Sign::Plus));
            }
        }
        let signs: Vec<Sign> = signs.into_iter().map(|sign| sign.unwrap_or(Sign::Plus)).collect();
        let turned: Vec<FaceId> =
            (0..signs.len()).filter(|&face| signs[face] == Sign::Minus).map(FaceId::new).collect();
        if !turned.is_empty() {
            self.mesh = self.mesh.with_face_signs(&signs);
            self.note_turned(&turned);
        }
    }

    /// Turns these faces, which are listed once each.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::{MeshRepair, PolygonMesh};
    /// use coface_algebra::FaceId;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mesh = PolygonMesh::new(3, RaggedArray::from_lists([[0, 1, 2]]), &[])?;
    /// let mut repair = MeshRepair::new(mesh);
    /// repair.turn(&[FaceId::new(0)]);
    /// assert_eq!(repair.faces_turned(), [FaceId::new(0)]);
    /// # Ok(()) }
    /// ```
    pub fn turn(&mut self, faces: &[FaceId]) {
        if faces.is_empty() {
            return;
        }
        let mut signs = vec![Sign::Plus; self.mesh.face_count()];
        faces.iter().for_each(|face| signs[face.index()] = Sign::Minus);
        let mut turned = faces.to_vec();
        turned.sort_unstable();
        self.mesh = self.mesh.with_face_signs(&signs);
        self.note_turned(&turned);
    }

    fn note_turned(&mut self, turned: &[FaceId]) {
        // Turning a second time brings a face back.
        let before = std::mem::take(&mut self.faces_turned);
        let differs = |list: &[FaceId], face: &FaceId| list.binary_search(face).is_err();
        self.faces_turned = before.iter().filter(|face| differs(turned, face)).copied().collect();
        self.faces_turned.extend(turned.iter().filter(|face| differs(&before, face)));
        self.faces_turned.sort_unstable();
    }

    /// Puts the copies in the place of the vertices at the corners.
    fn give_copies(&mut self, copies: &Copies) -> Result<(), Error> {
        if copies.sources.is_empty() {
            return Ok(());
        }
        let mesh = &self.mesh;
        let sides = SidesAtEdges::new(mesh);
        let mut loose = mesh.loose_pairs();
        for (i, pair) in loose.iter_mut().enumerate() {
            if let Some(&side) = sides.at(mesh.loose_edge(i).index()).first() {
                *pair = sides.corners(mesh, side).map(|corner| copies.of_corner[corner as usize]);
            }
        }
        let mut polygons = mesh.polygons().clone();
        polygons.items_mut().copy_from_slice(&copies.of_corner);
        for &vertex in &copies.sources {
            let source = self.vertex_sources[VertexId::from_u32(vertex)];
            self.vertex_sources.push(source);
            self.vertices_split.push(source);
        }
        self.vertices_split.sort_unstable();
        self.vertices_split.dedup();
        self.mesh = mesh.with_corners(self.vertex_sources.len(), polygons, &loose);
        Ok(())
    }
}

/// A vertex for each corner.
struct Copies {
    of_corner: Vec<u32>,
    /// What the vertices beyond those of the mesh are copies of, in order.
    sources: Vec<u32>,
}

/// Each class of corners at a vertex that `is_split` gets a copy of the vertex; the first class keeps the vertex.
fn copies_of_fans(
    mesh: &PolygonMesh,
    fans: &mut UnionFind,
    is_split: impl Fn(u32) -> bool,
) -> Result<Copies, Error> {
    const UNSEEN: u32 = u32::MAX;
    let vertex_count = mesh.vertex_count();
    let mut vertex_of_fan = vec![UNSEEN; fans.len()];
    let mut is_kept = vec![false; vertex_count];
    let mut sources = Vec::new();
    let mut of_corner = mesh.polygons().items().to_vec();
    for (corner, vertex) in of_corner.iter_mut().enumerate() {
        if !is_split(*vertex) {
            continue;
        }
        let copy = &mut vertex_of_fan[fans.find(corner as u32) as usize];
        if *copy == UNSEEN {
            *copy = *vertex;
            if std::mem::replace(&mut is_kept[*vertex as usize], true) {
                *copy = u32::try_from(vertex_count + sources.len())
                    .ok()
                    .filter(|&copy| copy != UNSEEN)
                    .ok_or_else(|| Error::new(ErrorKind::TooLarge, "more than 2^32 - 1 vertices"))?;
                sources.push(*vertex);
            }
        }
        *vertex = *copy;
    }
    Ok(Copies { of_corner, sources })
}

/// The sides at each edge, each as the position of the corner that it starts from, rising.
struct SidesAtEdges(RaggedArray);

impl SidesAtEdges {
    fn new(mesh: &PolygonMesh) -> Self {
        let mut starts: Vec<u32> = Vec::with_capacity(mesh.edge_count() + 1);
        starts.push(0);
        let mut total = 0;
        starts.extend(mesh.edge_degrees().map(|count| {
            total += count;
            total
        }));
        let mut next = starts.clone();
        let mut sides = vec![0; mesh.polygons().item_count()];
        for (corner, &edge) in mesh.corner_edges().iter().enumerate() {
            let at = &mut next[edge as usize];
            sides[*at as usize] = corner as u32;
            *at += 1;
        }
        Self(RaggedArray::from_parts(starts, sides).expect("each side is at one edge"))
    }

    fn at(&self, edge: usize) -> &[u32] {
        self.0.list(edge)
    }

    /// The corners that a side runs between, in its direction.
    fn corners(&self, mesh: &PolygonMesh, side: u32) -> [u32; 2] {
        let edge = mesh.corner_edges()[side as usize] as usize;
        let place = self.at(edge).binary_search(&side).expect("a side is at its edge");
        let face = (mesh.packed_faces(edge)[place] >> 1) as usize;
        let last = side as usize + 1 == mesh.polygons().start(face + 1);
        [side, if last { mesh.polygons().start(face) as u32 } else { side + 1 }]
    }

    /// Unites the corners of two sides of one edge, at both ends.
    fn join(&self, mesh: &PolygonMesh, fans: &mut UnionFind, side: u32, other: u32) {
        let ([a, b], [mut c, mut d]) = (self.corners(mesh, side), self.corners(mesh, other));
        let vertices = mesh.polygons().items();
        if vertices[a as usize] != vertices[c as usize] {
            (c, d) = (d, c);
        }
        fans.unite(a, c);
        fans.unite(b, d);
    }

    /// The sides along an edge with those against it, the first with the first.
    fn coherent_pairs(&self, mesh: &PolygonMesh, edge: usize) -> Vec<(u32, u32)> {
        let with_sign = |reversed: u32| {
            self.at(edge)
                .iter()
                .zip(mesh.packed_faces(edge))
                .filter(move |&(_, packed)| packed & 1 == reversed)
                .map(|(&side, _)| side)
        };
        with_sign(0).zip(with_sign(1)).collect()
    }

    /// Whether three or more sides of an edge run between the same copies of its ends.
    fn still_crowded(&self, mesh: &PolygonMesh, edge: usize, copies: &[u32]) -> bool {
        let mut pairs: Vec<[u32; 2]> = self
            .at(edge)
            .iter()
            .map(|&side| {
                let mut pair = self.corners(mesh, side).map(|corner| copies[corner as usize]);
                pair.sort_unstable();
                pair
            })
            .collect();
        pairs.sort_unstable();
        pairs.windows(3).any(|three| three[0] == three[2])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::LinkShape;
    use proptest::prelude::*;

    fn mesh(vertex_count: usize, polygons: &[Vec<u32>], loose: &[[u32; 2]]) -> PolygonMesh {
        PolygonMesh::new(vertex_count, RaggedArray::from_lists(polygons), loose).unwrap()
    }

    /// A sphere of four triangles.
    fn tetrahedron([a, b, c, d]: [u32; 4]) -> Vec<Vec<u32>> {
        vec![vec![a, b, c], vec![a, d, b], vec![b, d, c], vec![a, c, d]]
    }

    #[test]
    fn a_wall_comes_off_a_sphere_that_stays_closed() {
        // Vertex 4 hangs on a triangle on the edge 01.
        let mut polygons = tetrahedron([0, 1, 2, 3]);
        polygons.push(vec![0, 1, 4]);
        for together in [FacesAtEdge::Apart, FacesAtEdge::CoherentPairs] {
            let mut repair = MeshRepair::new(mesh(5, &polygons, &[]));
            repair.split_edges(together).unwrap();
            assert_eq!(repair.mesh().f_vector(), [7, 9, 5]);
            assert_eq!(repair.mesh().components().count(), 2);
            assert_eq!(repair.mesh().face(FaceId::new(4)), [5, 6, 4]);
            assert_eq!(repair.vertices_split(), [VertexId::new(0), VertexId::new(1)]);
            assert_eq!(repair.edges_split(), [[VertexId::new(0), VertexId::new(1)]]);
            assert_eq!(repair.mesh().manifold_verdict().boundary_edge_count(), 3);
        }
    }

    #[test]
    fn two_spheres_on_an_edge_fall_into_the_two() {
        let polygons = [tetrahedron([0, 1, 2, 3]), tetrahedron([0, 1, 4, 5])].concat();
        let mut repair = MeshRepair::new(mesh(6, &polygons, &[]));
        repair.split_edges(FacesAtEdge::CoherentPairs).unwrap();
        let verdict = repair.mesh().manifold_verdict();
        assert!(verdict.is_manifold() && verdict.is_closed());
        assert_eq!(repair.mesh().f_vector(), [8, 12, 8]);
    }

    #[test]
    fn pairs_that_cannot_be_told_apart_are_split() {
        // The same spheres in an order in which the first pair is one face of each: all four walls would then have
        // both ends of the edge in common.
        let (one, other) = (tetrahedron([0, 1, 2, 3]), tetrahedron([0, 1, 4, 5]));
        let polygons = [
            vec![one[0].clone(), other[1].clone()],
            one[1..].to_vec(),
            vec![other[0].clone()],
            other[2..].to_vec(),
        ];
        let mut repair = MeshRepair::new(mesh(6, &polygons.concat(), &[]));
        repair.split_edges(FacesAtEdge::CoherentPairs).unwrap();
        let verdict = repair.mesh().manifold_verdict();
        assert!(verdict.is_manifold() && verdict.is_closed());
        assert_eq!((repair.mesh().f_vector(), repair.mesh().components().count()), (vec![8, 12, 8], 2));
    }

    #[test]
    fn loose_edges_follow_the_first_face() {
        let fans = [vec![0, 1, 2], vec![3, 0, 4]];
        let mut repair = MeshRepair::new(mesh(6, &fans, &[[0, 3], [0, 5], [0, 1]]));
        repair.split_vertices().unwrap();
        let repaired = repair.mesh();
        let pairs: Vec<[usize; 2]> =
            (0..3).map(|i| repaired.edge(repaired.loose_edge(i)).map(VertexId::index)).collect();
        assert_eq!(pairs, [[3, 6], [0, 5], [0, 1]]);
    }

    #[test]
    fn turning_tells_which_faces() {
        let mut repair = MeshRepair::new(mesh(4, &[vec![0, 1, 2], vec![1, 2, 3]], &[]));
        repair.orient().unwrap();
        repair.orient().unwrap();
        assert_eq!(repair.faces_turned(), [FaceId::new(1)]);
        assert_eq!(repair.mesh().orientation().is_coherent(), Some(true));
        let mut book = MeshRepair::new(mesh(5, &[vec![0, 1, 2], vec![0, 1, 3], vec![0, 1, 4]], &[]));
        assert_eq!(book.orient().unwrap_err().kind(), ErrorKind::NonManifold);
        assert!(book.faces_turned().is_empty());
        book.split_edges(FacesAtEdge::Apart).unwrap();
        book.orient().unwrap();
    }

    #[test]
    fn nothing_is_done_to_nothing() {
        let mut repair = MeshRepair::new(mesh(0, &[], &[]));
        repair.split_edges(FacesAtEdge::Apart).unwrap();
        repair.split_vertices().unwrap();
        repair.orient().unwrap();
        assert_eq!(repair.into_mesh().f_vector(), [0, 0, 0]);
    }

    proptest! {
        #[test]
        fn repaired_meshes_are_surfaces_on_the_same_corners(
            polygons in prop::collection::vec(
                (Just((0u32..8).collect::<Vec<_>>()).prop_shuffle(), 3usize..6).prop_map(|(mut v, n)| { v.truncate(n); v }),
                0..16,
            ),
            pairs in any::<bool>(),
            isolated in 0usize..2,
        ) {
            let given = mesh(8 + isolated, &polygons, &[]);
            let together = if pairs { FacesAtEdge::CoherentPairs } else { FacesAtEdge::Apart };
            let mut repair = MeshRepair::new(given.clone());
            repair.split_edges(together).unwrap();
            prop_assert!(repair.mesh().manifold_verdict().non_manifold_edges().is_empty());
            let crowded: Vec<[VertexId; 2]> =
                given.manifold_verdict().non_manifold_edges().iter().map(|&edge| given.edge(edge)).collect();
            prop_assert_eq!(repair.edges_split(), &crowded[..]);
            repair.split_vertices().unwrap();
            let verdict = repair.mesh().manifold_verdict();
            prop_assert!(verdict.is_manifold(), "{:?}", verdict.witness());

            // Faces map back, and every vertex is in its own place or a copy.
            let sources = repair.vertex_sources();
            prop_assert_eq!(repair.mesh().face_count(), given.face_count());
            for face in (0..given.face_count()).map(FaceId::new) {
                let back: Vec<u32> = repair.mesh().face(face).iter().map(|&v| sources[VertexId::from_u32(v)].to_u32()).collect();
                prop_assert_eq!(&back[..], given.face(face));
            }
            for vertex in (0..given.vertex_count()).map(VertexId::new) {
                prop_assert_eq!(sources[vertex], vertex);
            }
            let mut split: Vec<VertexId> = sources.iter().skip(given.vertex_count()).copied().collect();
            split.sort_unstable();
            split.dedup();
            prop_assert_eq!(repair.vertices_split(), &split[..]);
            // Only singular vertices are split.
            let singular = given.manifold_verdict();
            prop_assert!(split.iter().all(|v| singular.non_manifold_vertices().contains(v)));

            // Once is enough.
            let once = repair.clone();
            repair.split_edges(together).unwrap();
            repair.split_vertices().unwrap();
            prop_assert_eq!(repair.mesh().polygons(), once.mesh().polygons());
            prop_assert_eq!(repair.vertex_sources(), once.vertex_sources());
        }

        #[test]
        fn each_fan_gets_one_vertex(
            polygons in prop::collection::vec(
                (Just((0u32..9).collect::<Vec<_>>()).prop_shuffle(), 3usize..5).prop_map(|(mut v, n)| { v.truncate(n); v }),
                0..10,
            ),
            loose in prop::collection::vec((0u32..9, 1u32..9).prop_map(|(a, d)| [a, (a + d) % 9]), 0..3),
        ) {
            let given = mesh(9, &polygons, &loose);
            let mut repair = MeshRepair::new(given.clone());
            repair.split_vertices().unwrap();
            for vertex in (0..9).map(VertexId::new) {
                let fans = given.link_components(vertex).iter().filter(|fan| fan.shape() != LinkShape::Point).count();
                let copies = repair.vertex_sources().iter().filter(|&&source| source == vertex).count();
                prop_assert_eq!(copies, fans.max(1));
            }
            // Edges are neither joined nor split.
            prop_assert_eq!(repair.mesh().edge_count(), given.edge_count());
            for (i, pair) in loose.iter().enumerate() {
                let mut back = repair.mesh().edge(repair.mesh().loose_edge(i)).map(|v| repair.vertex_sources()[v].to_u32());
                back.sort_unstable();
                prop_assert_eq!(back, [pair[0].min(pair[1]), pair[0].max(pair[1])]);
            }
        }
    }
}
