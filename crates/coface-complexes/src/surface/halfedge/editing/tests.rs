use super::super::HalfedgeMesh;
use coface_algebra::RaggedArray;
use coface_algebra::{EdgeId, ErrorKind, FaceId, HalfedgeId, VertexId};
use proptest::prelude::*;

/// Asserts that two meshes are the same but for the first halfedges of cells.
#[track_caller]
fn assert_same(mesh: &HalfedgeMesh, other: &HalfedgeMesh) {
    assert_eq!(mesh.next, other.next);
    assert_eq!((&mesh.source, &mesh.face), (&other.source, &other.face));
    assert_eq!((mesh.vertex_count(), mesh.face_count), (other.vertex_count(), other.face_count));
    mesh.check().unwrap();
}

/// What no edit changes: Euler characteristic, components, genus and holes.
fn invariants(mesh: &HalfedgeMesh) -> (i64, usize, usize, usize) {
    (mesh.euler_characteristic(), mesh.component_count(), mesh.genus(), mesh.outer_face_count())
}

/// Random surfaces of all sorts: any `next`, then some faces outer where that leaves a surface.
fn surfaces() -> impl Strategy<Value = HalfedgeMesh> {
    let next = (1u32..12).prop_flat_map(|edges| Just((0..2 * edges).collect::<Vec<_>>()).prop_shuffle());
    (next, any::<u32>()).prop_map(|(next, holes)| {
        let mut mesh = HalfedgeMesh::from_next(next).unwrap();
        for i in 0..3 {
            let face = FaceId::new((holes >> (8 * i)) as usize % (2 * mesh.face_count()).max(1));
            if face.index() < mesh.face_count() {
                mesh = mesh.clone().with_outer_faces(&[face]).unwrap_or(mesh);
            }
        }
        mesh
    })
}

/// Grids of triangles with or without boundary, with an isolated vertex.
fn triangulations() -> impl Strategy<Value = HalfedgeMesh> {
    (3u32..6, 3u32..6, any::<u8>()).prop_map(|(columns, rows, shape)| {
        let (closed_columns, closed_rows) = (shape & 1 == 1, shape & 2 == 2);
        let name = |x: u32, y: u32| (y % rows) * columns + x % columns;
        let mut triangles = Vec::new();
        for y in 0..rows - u32::from(!closed_rows) {
            for x in 0..columns - u32::from(!closed_columns) {
                let [a, b, c, d] = [name(x, y), name(x + 1, y), name(x + 1, y + 1), name(x, y + 1)];
                triangles.extend([[a, b, c], [a, c, d]]);
            }
        }
        let count = (columns * rows + 1) as usize;
        HalfedgeMesh::from_polygons(count, &RaggedArray::from_lists(triangles)).unwrap()
    })
}

/// One operation, chosen by `kind`, on cells chosen by the numbers; whether it was done. Each that is done is undone on a
/// copy.
fn edit(mesh: &mut HalfedgeMesh, kind: u8, first: u16, second: u16) -> bool {
    if mesh.edge_count() == 0 {
        return false;
    }
    let before = mesh.clone();
    let edge = EdgeId::new(first as usize % mesh.edge_count());
    let halfedge = HalfedgeId::new(first as usize % mesh.halfedge_count());
    let done = match kind {
        0 => {
            let split = mesh.split_edge(edge).unwrap();
            let mut undone = mesh.clone();
            let removal = undone.remove_vertex(split.vertex()).unwrap();
            assert_eq!((removal.edge(), removal.renumbering().is_empty()), (edge, true));
            assert_same(&undone, &before);
            assert_eq!(mesh.source(mesh.edge_halfedge(split.edge())), split.vertex());
            true
        }
        1 => {
            let vertex = VertexId::new(first as usize % mesh.vertex_count());
            let done = mesh.remove_vertex(vertex).is_ok();
            assert!(done || *mesh == before);
            done
        }
        2 => {
            let around: Vec<HalfedgeId> = mesh.face_halfedges(mesh.face(halfedge)).collect();
            let to = around[second as usize % around.len()];
            let Ok(split) = mesh.split_face(halfedge, to) else {
                assert!(before.is_outer_halfedge(halfedge) && *mesh == before);
                return false;
            };
            let edge = mesh.edge_halfedge(split.edge());
            assert_eq!(mesh.face(edge), split.face());
            assert_eq!((mesh.next(edge) == to, halfedge == to), (halfedge != to, mesh.next(edge) == edge));
            let mut undone = mesh.clone();
            assert_eq!(undone.remove_edge(split.edge()).unwrap().face(), before.face(halfedge));
            assert_same(&undone, &before);
            true
        }
        3 => match mesh.remove_edge(edge) {
            Ok(removal) => {
                let mut undone = mesh.clone();
                undone.split_face(removal.corners()[0], removal.corners()[1]).unwrap();
                undone.check().unwrap();
                assert!(are_isomorphic(&undone, &before));
                true
            }
            Err(_) => {
                assert_eq!(*mesh, before);
                let h = mesh.edge_halfedge(edge);
                assert!(
                    mesh.is_boundary_edge(edge)
                        || mesh.face(h) == mesh.face(mesh.twin(h))
                        || (mesh.next(h) == h && mesh.next(mesh.twin(h)) == mesh.twin(h))
                );
                false
            }
        },
        4 => {
            let around: Vec<HalfedgeId> = mesh.halfedges_leaving(mesh.source(halfedge)).collect();
            let to = around[second as usize % around.len()];
            let Ok(split) = mesh.split_vertex(halfedge, to) else {
                assert!(halfedge == to && before.is_outer_halfedge(to) && *mesh == before);
                return false;
            };
            let edge = mesh.edge_halfedge(split.edge());
            assert_eq!((mesh.source(edge), mesh.target(edge)), (before.source(to), split.vertex()));
            assert_eq!(mesh.face(edge), before.face(halfedge));
            let mut undone = mesh.clone();
            let collapse = undone.collapse_edge(split.edge()).unwrap();
            assert_same(&undone, &before);
            assert_eq!(collapse.corners(), [halfedge, to]);
            if halfedge == to {
                let mut undone = mesh.clone();
                assert_eq!(undone.remove_pendant_edge(split.edge()).unwrap().vertex(), before.source(to));
                assert_same(&undone, &before);
            }
            true
        }
        5 => match mesh.collapse_edge(edge) {
            Ok(collapse) => {
                let mut undone = mesh.clone();
                undone.split_vertex(collapse.corners()[0], collapse.corners()[1]).unwrap();
                undone.check().unwrap();
                assert!(are_isomorphic(&undone, &before));
                true
            }
            Err(_) => {
                assert_eq!(*mesh, before);
                false
            }
        },
        6 => match mesh.remove_pendant_edge(edge) {
            Ok(removal) => {
                let [corner, _] = removal.corners();
                assert_eq!(mesh.source(corner), removal.vertex());
                let mut undone = mesh.clone();
                undone.split_vertex(corner, corner).unwrap();
                undone.check().unwrap();
                assert!(are_isomorphic(&undone, &before));
                true
            }
            Err(_) => {
                assert_eq!(*mesh, before);
                false
            }
        },
        7 | 8 => {
            let flips = [HalfedgeMesh::flip_edge, HalfedgeMesh::flip_edge_back];
            let (flip, back) = if kind == 7 { (flips[0], flips[1]) } else { (flips[1], flips[0]) };
            if flip(mesh, edge).is_err() {
                assert_eq!(*mesh, before);
                return false;
            }
            let mut undone = mesh.clone();
            back(&mut undone, edge).unwrap();
            assert_same(&undone, &before);
            true
        }
        9 => match mesh.collapse_edge_simplicially(edge) {
            Ok(collapse) => {
                let (vertices, edges, faces) =
                    (before.vertex_count(), before.edge_count(), before.face_count());
                let gone = [1, collapse.removed_edges().len(), collapse.removed_faces().len()];
                assert_eq!(mesh.f_vector(), [vertices - gone[0], edges - gone[1], faces - gone[2]]);
                true
            }
            Err(_) => {
                assert_eq!(*mesh, before);
                false
            }
        },
        _ => {
            let face = FaceId::new(first as usize % mesh.face_count());
            let poke = mesh.poke_face(face).unwrap();
            mesh.check().unwrap();
            let mut undone = mesh.clone();
            let edges: Vec<EdgeId> = poke.edges().collect();
            assert_eq!((edges.len(), poke.faces().len() + 1), (undone.degree(poke.vertex()), edges.len()));
            for &edge in edges[1..].iter().rev() {
                undone.remove_edge(edge).unwrap();
            }
            undone.remove_pendant_edge(edges[0]).unwrap();
            assert_same(&undone, &before);
            true
        }
    };
    mesh.check().unwrap();
    done
}

/// Whether some renumbering of halfedges takes one mesh to the other: tried from one halfedge of each component to all.
fn are_isomorphic(mesh: &HalfedgeMesh, other: &HalfedgeMesh) -> bool {
    const NONE: usize = usize::MAX;
    let count = mesh.halfedge_count();
    if count != other.halfedge_count() || mesh.f_vector() != other.f_vector() {
        return false;
    }
    // A component may cover a smaller one, so the way back is kept as well.
    let (mut image, mut source) = (vec![NONE; count], vec![NONE; count]);
    'components: while let Some(start) = (0..count).find(|&h| image[h] == NONE) {
        'starts: for target in 0..count {
            if source[target] != NONE {
                continue;
            }
            let (mut trial, mut back) = (image.clone(), source.clone());
            let mut members = vec![start];
            (trial[start], back[target]) = (target, start);
            let mut at = 0;
            while at < members.len() {
                let h = members[at];
                at += 1;
                let outer = |mesh: &HalfedgeMesh, h: usize| mesh.is_outer_halfedge(HalfedgeId::new(h));
                if outer(mesh, h) != outer(other, trial[h]) {
                    continue 'starts;
                }
                let steps = [(h ^ 1, trial[h] ^ 1), (mesh.next[h] as usize, other.next[trial[h]] as usize)];
                for (to, wanted) in steps {
                    if trial[to] == NONE && back[wanted] == NONE {
                        (trial[to], back[wanted]) = (wanted, to);
                        members.push(to);
                    } else if trial[to] != wanted {
                        continue 'starts;
                    }
                }
            }
            (image, source) = (trial, back);
            continue 'components;
        }
        return false;
    }
    true
}

#[test]
fn a_component_that_covers_another_is_not_it() {
    // A circle of two edges and one of one edge, in both orders.
    let mesh = HalfedgeMesh::from_next(vec![2, 3, 0, 1, 4, 5]).unwrap();
    let other = HalfedgeMesh::from_next(vec![0, 1, 4, 5, 2, 3]).unwrap();
    assert!(are_isomorphic(&mesh, &other) && are_isomorphic(&other, &mesh));
}

proptest! {
    #[test]
    fn any_sequence_of_edits_keeps_the_surface_and_can_be_undone(
        start in surfaces(),
        steps in prop::collection::vec((0u8..11, any::<u16>(), any::<u16>()), 0..24),
    ) {
        let mut mesh = start;
        let expected = invariants(&mesh);
        for (kind, first, second) in steps {
            edit(&mut mesh, kind, first, second);
            prop_assert_eq!(invariants(&mesh), expected);
        }
    }

    #[test]
    fn triangulations_are_edited_too(
        start in triangulations(),
        steps in prop::collection::vec((0u8..11, any::<u16>(), any::<u16>()), 0..16),
    ) {
        let mut mesh = start;
        let expected = invariants(&mesh);
        for (kind, first, second) in steps {
            edit(&mut mesh, kind, first, second);
            prop_assert_eq!(invariants(&mesh), expected);
        }
    }

    /// Until no edge can be collapsed; each refusal is checked by collapsing and looking.
    #[test]
    fn simplicial_collapses_keep_simplicial_complexes(start in triangulations(), choices in prop::collection::vec(any::<u16>(), 60)) {
        let mut mesh = start;
        let expected = invariants(&mesh);
        for choice in choices {
            let edge = EdgeId::new(choice as usize % mesh.edge_count());
            let before = mesh.clone();
            let obstacle = mesh.collapse_obstacle(edge);
            match mesh.collapse_edge_simplicially(edge) {
                Ok(collapse) => {
                    prop_assert!(obstacle.is_none());
                    mesh.check().unwrap();
                    prop_assert!(is_simplicial(&mesh));
                    prop_assert_eq!(invariants(&mesh), expected);
                    // The records say which cells became which: triangles keep their vertices but for the one that went.
                    let h = before.edge_halfedge(edge);
                    let (kept, gone) = (before.source(h).min(before.target(h)), before.source(h).max(before.target(h)));
                    let mut vertices: Vec<Option<VertexId>> = (0..before.vertex_count()).map(|v| Some(VertexId::new(v))).collect();
                    vertices[gone.index()] = None;
                    for &(from, to) in collapse.renumbering().vertices() {
                        prop_assert!(vertices[to.index()].is_none());
                        vertices[to.index()] = vertices[from.index()].take();
                    }
                    prop_assert_eq!(vertices.iter().flatten().count(), mesh.vertex_count());
                    let mut faces: Vec<Option<FaceId>> =
                        (0..before.face_count() + before.outer_face_count()).map(|f| Some(FaceId::new(f))).collect();
                    for face in collapse.removed_faces() {
                        faces[face.index()] = None;
                    }
                    for &(from, to) in collapse.renumbering().faces() {
                        prop_assert!(faces[to.index()].is_none());
                        faces[to.index()] = faces[from.index()].take();
                    }
                    for face in (0..mesh.face_count()).map(FaceId::new) {
                        let mut found: Vec<VertexId> = mesh.face_vertices(face).map(|v| vertices[v.index()].unwrap()).collect();
                        let old = faces[face.index()].unwrap();
                        let mut wanted: Vec<VertexId> = before.face_vertices(old).map(|v| if v == gone { kept } else { v }).collect();
                        found.sort_unstable();
                        wanted.sort_unstable();
                        prop_assert_eq!(found, wanted);
                    }
                    let mut edges: Vec<Option<EdgeId>> = (0..before.edge_count()).map(|e| Some(EdgeId::new(e))).collect();
                    for edge in collapse.removed_edges() {
                        edges[edge.index()] = None;
                    }
                    for &(from, to) in collapse.renumbering().edges() {
                        prop_assert!(edges[to.index()].is_none());
                        edges[to.index()] = edges[from.index()].take();
                    }
                    for edge in (0..mesh.edge_count()).map(EdgeId::new) {
                        let old = before.edge_halfedge(edges[edge.index()].unwrap());
                        let wanted = [before.source(old), before.target(old)].map(|v| if v == gone { kept } else { v });
                        let new = mesh.edge_halfedge(edge);
                        let found = [mesh.source(new), mesh.target(new)].map(|v| vertices[v.index()].unwrap());
                        prop_assert_eq!(found, wanted);
                    }
                }
                Err(error) => {
                    prop_assert_eq!(error.kind(), ErrorKind::NonManifold);
                    prop_assert_eq!(&mesh, &before);
                    prop_assert!(!stays_simplicial(&before, edge), "{error}");
                }
            }
        }
    }
}

/// Whether all faces are triangles on three vertices and no edges and no triangles coincide.
fn is_simplicial(mesh: &HalfedgeMesh) -> bool {
    let sorted = |mut vertices: Vec<VertexId>| {
        vertices.sort_unstable();
        vertices
    };
    let mut triangles: Vec<Vec<VertexId>> =
        (0..mesh.face_count()).map(|f| sorted(mesh.face_vertices(FaceId::new(f)).collect())).collect();
    let mut edges: Vec<Vec<VertexId>> = (0..mesh.edge_count())
        .map(|e| mesh.edge_halfedge(EdgeId::new(e)))
        .map(|h| sorted(vec![mesh.source(h), mesh.target(h)]))
        .collect();
    let proper = triangles.iter().all(|t| t.len() == 3 && t[0] < t[1] && t[1] < t[2])
        && edges.iter().all(|e| e[0] < e[1]);
    let count = (triangles.len(), edges.len());
    triangles.sort_unstable();
    triangles.dedup();
    edges.sort_unstable();
    edges.dedup();
    proper && count == (triangles.len(), edges.len())
}

/// Collapses on the triangles as sets of vertices: whether the result is the right number of cells, all there.
fn stays_simplicial(mesh: &HalfedgeMesh, edge: EdgeId) -> bool {
    let h = mesh.edge_halfedge(edge);
    let (u, v) = (mesh.source(h), mesh.target(h));
    let mut triangles: Vec<Vec<u32>> = Vec::new();
    for face in (0..mesh.face_count()).map(FaceId::new) {
        let corners: Vec<u32> = mesh
            .face_vertices(face)
            .map(|corner| if corner == v { u.to_u32() } else { corner.to_u32() })
            .collect();
        if corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0] {
            triangles.push(corners);
        }
    }
    let expected = mesh.face_count()
        - mesh.halfedges().filter(|&side| mesh.edge(side) == edge && !mesh.is_outer_halfedge(side)).count();
    let Ok(result) = HalfedgeMesh::from_polygons(mesh.vertex_count(), &RaggedArray::from_lists(&triangles))
    else {
        return false;
    };
    // The vertex that went is isolated now; it was none before.
    triangles.len() == expected
        && is_simplicial(&result)
        && result.euler_characteristic() - 1 == mesh.euler_characteristic()
        && result.outer_face_count() == mesh.outer_face_count()
        && result.component_count() - 1 == mesh.component_count()
}

#[test]
fn four_flips_between_triangles_bring_everything_back() {
    let mut mesh = HalfedgeMesh::from_next(vec![2, 3, 4, 5, 0, 1]).unwrap();
    let before = mesh.clone();
    for edge in (0..3).map(EdgeId::new) {
        for _ in 0..4 {
            mesh.flip_edge(edge).unwrap();
            mesh.check().unwrap();
        }
        assert_same(&mesh, &before);
    }
}

#[test]
fn refusals_name_the_cell_and_the_reason() {
    let mut disk = HalfedgeMesh::from_polygons(4, &RaggedArray::from_lists([[0, 1, 2], [0, 2, 3]])).unwrap();
    let message = |result: Result<(), coface_algebra::Error>| result.unwrap_err().message().to_owned();
    assert_eq!(
        message(disk.flip_edge(EdgeId::new(0))),
        "edge e0 lies on the boundary, in one face only, and cannot be flipped"
    );
    assert_eq!(
        message(disk.collapse_edge(EdgeId::new(2)).map(drop)),
        "edge e2 joins the vertices v2 and v0 of the boundary inside the surface; collapsing it would make two fans of faces meet in one vertex"
    );
    assert_eq!(
        message(disk.poke_face(FaceId::new(2)).map(drop)),
        "a vertex cannot be put into face f2, which is outer: it fills a hole of the surface"
    );
    assert_eq!(
        message(disk.remove_vertex(VertexId::new(0)).map(drop)),
        "3 edges end at vertex v0; only a vertex with two is removed"
    );
    let mut sphere = HalfedgeMesh::from_next(vec![1, 0]).unwrap();
    assert_eq!(message(sphere.flip_edge(EdgeId::new(0))), "edge e0 is pendant: no other edge ends at v1");
    assert!(message(sphere.collapse_edge(EdgeId::new(0)).map(drop)).contains("only one of its component"));
    assert!(message(sphere.remove_pendant_edge(EdgeId::new(0)).map(drop)).contains("only one"));
    assert!(message(sphere.remove_edge(EdgeId::new(0)).map(drop)).contains("is on both sides of edge e0"));
    let mut monogons = HalfedgeMesh::from_next(vec![0, 1]).unwrap();
    assert!(message(monogons.flip_edge(EdgeId::new(0))).contains("is a monogon"));
    assert!(message(monogons.collapse_edge(EdgeId::new(0)).map(drop)).contains("is a loop at vertex v0"));
    assert!(message(monogons.remove_vertex(VertexId::new(0)).map(drop)).contains("is a loop at vertex v0"));
    assert!(message(monogons.remove_edge(EdgeId::new(0)).map(drop)).contains("only one of its component"));
    assert!(
        message(monogons.split_face(HalfedgeId::new(0), HalfedgeId::new(1)).map(drop))
            .contains("different faces, f0 and f1")
    );
    assert!(
        message(sphere.split_vertex(HalfedgeId::new(0), HalfedgeId::new(1)).map(drop))
            .contains("h0 leaves vertex v0 and h1 vertex v1")
    );
}
