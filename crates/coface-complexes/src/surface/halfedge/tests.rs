//! Tests of halfedge meshes: small permutations with known orbits, all of them up to four edges, polygons in the light of
//! the tests for polygon meshes.

use super::HalfedgeMesh;
use super::mesh::NONE;
use crate::surface::PolygonMesh;
use coface_algebra::RaggedArray;
use coface_algebra::{EdgeId, ErrorKind, FaceId, Fault, HalfedgeId, VertexId};
use proptest::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

fn lists(polygons: &[Vec<u32>]) -> RaggedArray {
    RaggedArray::from_lists(polygons)
}

/// The triangles of a torus of `columns` by `rows` squares, all coherent, with vertices renamed.
pub(super) fn torus_triangles(columns: u32, rows: u32, name: impl Fn(u32) -> u32) -> Vec<Vec<u32>> {
    let vertex = |i: u32, j: u32| name(i % columns + columns * (j % rows));
    (0..columns * rows)
        .map(|k| (k % columns, k / columns))
        .flat_map(|(i, j)| {
            let [a, b, c, d] = [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)];
            [vec![a, b, c], vec![a, c, d]]
        })
        .collect()
}

#[test]
fn a_cone_with_a_monogon_is_a_sphere() {
    let mesh = HalfedgeMesh::from_permutations(&[1, 2, 0, 3], &[1, 0, 3, 2]).unwrap();
    mesh.check().unwrap();
    assert_eq!((mesh.f_vector(), mesh.euler_characteristic(), mesh.genus()), (vec![2, 2, 2], 2, 0));
    let sources: Vec<usize> = mesh.halfedges().map(|h| mesh.source(h).index()).collect();
    assert_eq!(sources, [0, 1, 0, 0]);
    let sizes: Vec<usize> = (0..2).map(|f| mesh.face_halfedges(FaceId::new(f)).count()).collect();
    assert_eq!(sizes, [3, 1]);
}

#[test]
fn small_permutations_have_the_known_orbits() {
    let table: [(&[u32], [usize; 3], usize); 6] = [
        (&[2, 3, 4, 5, 0, 1], [1, 3, 2], 1), // the one-vertex torus
        (&[2, 5, 4, 1, 0, 3], [3, 3, 2], 0), // its second triangle backwards: a sphere
        (&[2, 3, 1, 0], [1, 2, 1], 1),       // the square torus
        (&[0, 1], [1, 1, 2], 0),             // a loop between two monogons
        (&[1, 0], [2, 1, 1], 0),             // a segment in a digon
        (&[], [0, 0, 0], 0),
    ];
    for (next, f_vector, genus) in table {
        let mesh = HalfedgeMesh::from_next(next.to_vec()).unwrap();
        mesh.check().unwrap();
        assert_eq!((mesh.f_vector(), mesh.genus()), (f_vector.to_vec(), genus), "{next:?}");
    }
    let spheres = HalfedgeMesh::from_next((0..10).collect()).unwrap();
    assert_eq!((spheres.component_count(), spheres.euler_characteristic()), (5, 10));
}

/// The polygon of 4g sides with the word a b a^-1 b^-1 ...: one face, one vertex, 2g edges.
#[test]
fn a_polygon_of_4g_sides_has_genus_g() {
    for genus in [1u32, 2, 3, 10] {
        let rim: Vec<u32> = (0..genus).flat_map(|i| [4 * i, 4 * i + 2, 4 * i + 1, 4 * i + 3]).collect();
        let mut next = vec![0; rim.len()];
        for (i, &h) in rim.iter().enumerate() {
            next[h as usize] = rim[(i + 1) % rim.len()];
        }
        let mesh = HalfedgeMesh::from_next(next).unwrap();
        assert_eq!(mesh.f_vector(), [1, 2 * genus as usize, 1]);
        assert_eq!(mesh.genus(), genus as usize);
    }
}

#[test]
fn faults_name_the_halfedge() {
    let fault = |next: &[u32], twin: &[u32]| {
        HalfedgeMesh::from_permutations(next, twin).unwrap_err().message().to_owned()
    };
    assert_eq!(fault(&[0, 0], &[1, 0]), "next is no permutation: h0 and h1 both go to h0");
    assert_eq!(fault(&[0, 2], &[1, 0]), "next takes h1 to h2, but there are 2 halfedges");
    assert_eq!(fault(&[0, 1], &[0, 1]), "twin leaves h0 where it is");
    assert_eq!(fault(&[0, 1, 2, 3], &[1, 2, 3, 0]), "twin takes h0 to h1, but h1 to h2");
    assert_eq!(fault(&[0, 1], &[1, 5]), "twin takes h0 to h1, but h1 to h5");
    assert_eq!(fault(&[0, 1], &[7, 0]), "twin takes h0 to h7, but there are 2 halfedges");
    assert_eq!(fault(&[0, 1], &[]), "next has 2 halfedges, but twin has 0");
    assert_eq!(HalfedgeMesh::from_next(vec![0]).unwrap_err().message(), "1 halfedges cannot be paired");
}

/// All permutations of `0..n`, by inserting the last element everywhere.
fn permutations(n: u32) -> Vec<Vec<u32>> {
    if n == 0 {
        return vec![Vec::new()];
    }
    permutations(n - 1)
        .into_iter()
        .flat_map(|p| {
            (0..n as usize).map(move |at| {
                let mut longer = p.clone();
                longer.insert(at, n - 1);
                longer
            })
        })
        .collect()
}

#[test]
fn all_surfaces_of_up_to_four_edges_are_counted() {
    // Connected ones by genus, then disconnected ones; the numbers were found by an independent program.
    let table = [
        (1, vec![(0, 2)], 0),
        (2, vec![(0, 18), (1, 2)], 4),
        (3, vec![(0, 432), (1, 160)], 128),
        (4, vec![(0, 18_144), (1, 14_736), (2, 1_008)], 6_432),
    ];
    for (edges, by_genus, disconnected) in table {
        let mut counted: BTreeMap<usize, usize> = BTreeMap::new();
        let mut several = 0;
        for next in permutations(2 * edges) {
            let mesh = HalfedgeMesh::from_next(next).unwrap();
            if mesh.component_count() == 1 {
                *counted.entry(mesh.genus()).or_default() += 1;
            } else {
                several += 1;
            }
        }
        assert_eq!((counted.into_iter().collect::<Vec<_>>(), several), (by_genus, disconnected));
    }
}

#[test]
fn outer_faces_are_refused_where_no_surface_remains() {
    let fault = |next: &[u32], faces: &[usize]| {
        let faces: Vec<FaceId> = faces.iter().map(|&face| FaceId::new(face)).collect();
        HalfedgeMesh::from_next(next.to_vec()).unwrap().with_outer_faces(&faces).unwrap_err()
    };
    assert_eq!(fault(&[1, 0], &[0]).kind(), ErrorKind::NonManifold);
    assert_eq!(
        fault(&[1, 0], &[0]).message(),
        "edge e0 lies between outer faces only, so it would be in no face"
    );
    // Two loops at a vertex, each with a monogon.
    let figure_eight = [0, 3, 2, 1];
    assert_eq!(
        fault(&figure_eight, &[0, 2]).message(),
        "vertex v0 has several corners in outer faces, so several fans of faces would meet there only"
    );
    assert_eq!(fault(&[0, 1], &[0, 0]).message(), "face f0 is given twice");
    assert_eq!(fault(&[0, 1], &[2]).message(), "face f2 is to be outer, but there are 2 faces");
    let disk = HalfedgeMesh::from_next(vec![0, 1]).unwrap().with_outer_faces(&[FaceId::new(0)]).unwrap();
    disk.check().unwrap();
    assert_eq!(disk.face_halfedge(FaceId::new(0)), HalfedgeId::new(1));
    assert_eq!(disk.with_outer_faces(&[FaceId::new(1)]).unwrap_err().message(), "face f1 is outer already");
}

#[test]
fn polygons_that_are_no_surface_are_refused_with_the_place() {
    let fault = |polygons: &[Vec<u32>]| HalfedgeMesh::from_polygons(6, &lists(polygons)).unwrap_err();
    let book = fault(&[vec![0, 1, 2], vec![1, 0, 3], vec![0, 1, 4]]);
    assert_eq!(book.message(), "edge {v0, v1} lies in 3 faces: f0, f1, f2; a surface has at most two there");
    assert_eq!(book.kind(), ErrorKind::NonManifold);
    let ends = [0, 1].map(VertexId::new);
    let faces = |numbers: &[usize]| numbers.iter().map(|&face| FaceId::new(face)).collect::<Vec<_>>();
    assert_eq!(book.fault(), Some(&Fault::EdgeInFaces { edge: ends, faces: faces(&[0, 1, 2]) }));
    let alike = fault(&[vec![0, 1, 2], vec![3, 0, 1]]);
    let both = [0, 1].map(FaceId::new);
    assert_eq!(alike.fault(), Some(&Fault::IncoherentFaces { edge: ends, faces: both }));
    // Two triangles that share vertex 0 only.
    let bow = fault(&[vec![0, 1, 2], vec![3, 4, 0]]);
    let fans = vec![faces(&[0]), faces(&[1])];
    assert_eq!(bow.fault(), Some(&Fault::VertexWithFans { vertex: VertexId::new(0), fans }));
    assert_eq!(
        fault(&[vec![0, 1, 2], vec![3, 0, 1]]).message(),
        "faces f0 and f1 both run from v0 to v1, so they do not agree there"
    );
    assert_eq!(
        fault(&[vec![0, 1, 2], vec![1, 2, 0]]).message(),
        "faces f0 and f1 both run from v0 to v1, so they do not agree there"
    );
    assert_eq!(
        fault(&[vec![0, 1, 2], vec![0, 3, 4]]).message(),
        "2 fans of faces meet at vertex v0 only: v1 v2 | v3 v4"
    );
    // A closed fan and an open one.
    let tent: Vec<Vec<u32>> = vec![vec![0, 1, 2], vec![0, 2, 3], vec![0, 3, 1], vec![1, 3, 2], vec![0, 4, 5]];
    assert_eq!(fault(&tent).message(), "2 fans of faces meet at vertex v0 only: v1 v2 v3 | v4 v5");
    assert!(fault(&[vec![0, 1, 6]]).message().starts_with("face f0 names vertex v6"));
    assert!(fault(&[vec![0, 1, 2], vec![3, 4, 3]]).message().starts_with("face f1 repeats vertex v3"));
    assert!(fault(&[vec![0, 1]]).message().starts_with("face f0 has 2 vertices"));
}

#[test]
fn degenerate_polygon_meshes_are_ordinary() {
    let empty = HalfedgeMesh::from_polygons(0, &RaggedArray::new()).unwrap();
    empty.check().unwrap();
    assert_eq!((empty.f_vector(), empty.genus(), empty.surface()), (vec![0; 3], 0, None));
    let points = HalfedgeMesh::from_polygons(3, &RaggedArray::new()).unwrap();
    points.check().unwrap();
    assert_eq!((points.f_vector(), points.component_count(), points.genus()), (vec![3, 0, 0], 3, 0));
    assert_eq!(points.chain_complex().unwrap().f_vector(), [3]);
    assert_eq!(points.vertex_halfedge(VertexId::new(1)), None);
    assert_eq!(points.halfedges_leaving(VertexId::new(1)).count(), 0);
    // Two triangles with the same vertices are a sphere; an isolated vertex stays.
    let pillow = HalfedgeMesh::from_polygons(4, &lists(&[vec![0, 1, 2], vec![2, 1, 0]])).unwrap();
    pillow.check().unwrap();
    assert_eq!((pillow.f_vector(), pillow.genus(), pillow.is_closed()), (vec![4, 3, 2], 0, true));
    assert_eq!(pillow.component_count(), 2);
    assert_eq!(pillow.surface(), None);
}

/// A hub of high degree with the greatest number: lists of edges at it would be long.
#[test]
fn a_hub_of_many_edges_is_matched_by_sorting() {
    let n = 3000;
    let fan: Vec<Vec<u32>> = (0..n).map(|i| vec![i * 7 % n, (i * 7 + 1) % n, n]).collect();
    let mesh = HalfedgeMesh::from_polygons(n as usize + 1, &lists(&fan)).unwrap();
    mesh.check().unwrap();
    assert_eq!(mesh.f_vector(), [3001, 6000, 3000]);
    assert_eq!(mesh.surface().unwrap().to_string(), "disk");
    assert_eq!(mesh.degree(VertexId::from_u32(n)), 3000);
}

/// Triangles of a torus with some left out: a surface with boundary, or one with several fans at a vertex.
fn part_of_torus() -> impl Strategy<Value = Vec<Vec<u32>>> {
    let names = Just((0u32..20).collect::<Vec<_>>()).prop_shuffle();
    (names, prop::collection::vec(prop::bool::weighted(0.85), 40), 0usize..40).prop_map(
        |(names, kept, turn)| {
            let mut triangles = torus_triangles(5, 4, |v| names[v as usize]);
            triangles.rotate_left(turn);
            triangles.into_iter().zip(kept).filter(|&(_, kept)| kept).map(|(triangle, _)| triangle).collect()
        },
    )
}

/// What `check` does not say about a mesh from polygons.
fn check_against_polygons(mesh: &HalfedgeMesh, polygons: &[Vec<u32>]) {
    mesh.check().unwrap();
    assert_eq!(mesh.face_count(), polygons.len());
    let mut edges_met = 0;
    for (face, polygon) in polygons.iter().enumerate() {
        let face = FaceId::new(face);
        let vertices: Vec<u32> = mesh.face_vertices(face).map(|v| v.to_u32()).collect();
        assert_eq!(&vertices, polygon);
        for h in mesh.face_halfedges(face) {
            assert!(mesh.edge(h).index() <= edges_met, "edges are numbered as sides meet them");
            if mesh.edge(h).index() == edges_met {
                assert_eq!(h.index() % 2, 0, "the even halfedge is the first side");
                edges_met += 1;
            }
        }
    }
    assert_eq!(edges_met, mesh.edge_count());
}

proptest! {
    #[test]
    fn any_two_permutations_are_a_closed_surface(
        next in Just((0u32..24).collect::<Vec<_>>()).prop_shuffle(),
        pairs in Just((0u32..24).collect::<Vec<_>>()).prop_shuffle(),
    ) {
        let mut twin = vec![0; 24];
        for pair in pairs.chunks(2) {
            twin[pair[0] as usize] = pair[1];
            twin[pair[1] as usize] = pair[0];
        }
        let mesh = HalfedgeMesh::from_permutations(&next, &twin).unwrap();
        mesh.check().unwrap();
        prop_assert_eq!(mesh.euler_characteristic() % 2, 0);
        let numbers = HalfedgeMesh::halfedge_numbers(&twin).unwrap();
        let renamed = |h: u32| HalfedgeId::new(numbers.image(h as usize));
        let (mut seen, mut faces_seen, mut edges_seen) = (0, 0, 0);
        for h in 0..24 {
            prop_assert_eq!(mesh.next(renamed(h)), renamed(next[h as usize]));
            prop_assert_eq!(mesh.twin(renamed(h)), renamed(twin[h as usize]));
            prop_assert_eq!(mesh.next(mesh.previous(renamed(h))), renamed(h));
            // Orbits are numbered by their smallest halfedges as numbered before.
            let cells = (mesh.source(renamed(h)), mesh.face(renamed(h)), mesh.edge(renamed(h)));
            prop_assert!(cells.0.index() <= seen && cells.1.index() <= faces_seen && cells.2.index() <= edges_seen);
            if cells.0.index() == seen {
                prop_assert_eq!(mesh.vertex_halfedge(cells.0), Some(renamed(h)));
            }
            seen = seen.max(cells.0.index() + 1);
            faces_seen = faces_seen.max(cells.1.index() + 1);
            edges_seen = edges_seen.max(cells.2.index() + 1);
        }
        prop_assert_eq!(vec![seen, edges_seen, faces_seen], mesh.f_vector());
        // Closed and oriented: the sum of the faces of each component is a cycle.
        let complex = mesh.chain_complex().unwrap();
        prop_assert_eq!(complex.f_vector(), mesh.f_vector());
        let faces = complex.boundary_matrix(2).unwrap().transpose();
        for edge in faces.columns() {
            prop_assert_eq!(edge.entries().iter().sum::<i32>(), 0);
        }
    }

    #[test]
    fn opened_surfaces_keep_the_invariants(
        next in Just((0u32..16).collect::<Vec<_>>()).prop_shuffle(),
        picks in prop::collection::vec(0usize..16, 0..4),
    ) {
        let mut mesh = HalfedgeMesh::from_next(next).unwrap();
        let genus = mesh.genus();
        for pick in picks {
            let face = FaceId::new(pick % mesh.face_count().max(1));
            let before = mesh.f_vector();
            if let Ok(opened) = mesh.clone().with_outer_faces(&[face]) {
                opened.check().unwrap();
                prop_assert_eq!(opened.f_vector(), [before[0], before[1], before[2] - 1]);
                mesh = opened;
            }
        }
        prop_assert_eq!(mesh.genus(), genus);
        for h in mesh.halfedges() {
            prop_assert_eq!(mesh.next(mesh.previous(h)), h);
        }
    }

    #[test]
    fn polygons_are_accepted_exactly_when_they_are_a_coherent_surface(
        polygons in prop_oneof![
            part_of_torus(),
            prop::collection::vec((Just((0u32..7).collect::<Vec<_>>()).prop_shuffle(), 3usize..5)
                .prop_map(|(mut v, n)| { v.truncate(n); v }), 0..8),
        ],
    ) {
        let tested = PolygonMesh::new(20, lists(&polygons), &[]).unwrap();
        prop_assume!(tested.duplicate_faces().is_empty());
        let is_surface = tested.manifold_verdict().is_manifold() && tested.orientation().is_coherent() == Some(true);
        let made = HalfedgeMesh::from_polygons(20, &lists(&polygons));
        prop_assert_eq!(made.is_ok(), is_surface, "{:?}", made);
        if let Ok(mesh) = made {
            check_against_polygons(&mesh, &polygons);
            let survey = tested.survey();
            prop_assert_eq!(mesh.outer_face_count(), survey.boundary_loops().len());
            prop_assert_eq!(mesh.component_count(), survey.components().count());
            prop_assert_eq!(mesh.euler_characteristic(), tested.euler_characteristic());
            // Boundary loops agree, as sets of vertices, and each runs along its faces.
            let found: BTreeSet<BTreeSet<VertexId>> = mesh
                .outer_faces()
                .map(|face| mesh.boundary_loop(face).map(|h| mesh.source(h)).collect())
                .collect();
            let expected: BTreeSet<BTreeSet<VertexId>> =
                survey.boundary_loops().iter().map(|l| l.vertices().iter().copied().collect()).collect();
            prop_assert_eq!(found, expected);
            for face in mesh.outer_faces() {
                let mut along: Vec<HalfedgeId> = mesh.boundary_loop(face).map(|h| mesh.twin(h)).collect();
                along[1..].reverse();
                prop_assert_eq!(along, mesh.face_halfedges(face).collect::<Vec<_>>());
            }
        }
    }

    #[test]
    fn circulators_agree_with_looking_at_all_halfedges(polygons in part_of_torus()) {
        let Ok(mesh) = HalfedgeMesh::from_polygons(20, &lists(&polygons)) else { return Ok(()) };
        for vertex in (0..20).map(VertexId::new) {
            let all: BTreeSet<HalfedgeId> = mesh.halfedges().filter(|&h| mesh.source(h) == vertex).collect();
            let around: Vec<HalfedgeId> = mesh.halfedges_leaving(vertex).collect();
            prop_assert_eq!(around.len(), all.len());
            prop_assert_eq!(&around.iter().copied().collect::<BTreeSet<_>>(), &all);
            for pair in around.windows(2) {
                // Clockwise: the face between two consecutive halfedges lies on the right of the first.
                prop_assert_eq!(mesh.face(mesh.twin(pair[0])), mesh.face(pair[1]));
            }
            prop_assert!(mesh.halfedges_entering(vertex).all(|h| mesh.target(h) == vertex));
            let corners = polygons.iter().filter(|polygon| polygon.contains(&vertex.to_u32())).count();
            prop_assert_eq!(mesh.vertex_faces(vertex).count(), corners);
            prop_assert_eq!(mesh.is_boundary_vertex(vertex), !all.is_empty() && corners < all.len());
            prop_assert_eq!(mesh.degree(vertex), all.len());
            prop_assert_eq!(mesh.vertex_edges(vertex).count(), mesh.adjacent_vertices(vertex).count());
        }
        for face in (0..mesh.face_count()).map(FaceId::new) {
            prop_assert_eq!(mesh.face_edges(face).count(), 3);
            for (edge, other) in mesh.face_edges(face).zip(mesh.adjacent_faces(face)) {
                prop_assert_eq!(mesh.is_boundary_edge(edge), mesh.is_outer(other));
            }
        }
    }
}

#[test]
fn check_names_what_is_broken() {
    let mesh = HalfedgeMesh::from_polygons(4, &lists(&[vec![0, 1, 2], vec![2, 1, 3]])).unwrap();
    mesh.check().unwrap();
    let fault = |change: fn(&mut HalfedgeMesh)| {
        let mut broken = mesh.clone();
        change(&mut broken);
        broken.check().unwrap_err().message().to_owned()
    };
    assert_eq!(fault(|mesh| mesh.next.swap(0, 2)), "the next of h0 does not leave its target");
    assert_eq!(fault(|mesh| mesh.next[0] = 4), "two halfedges have h4 as next");
    assert_eq!(fault(|mesh| mesh.face[0] = 1), "the next of h0 is in another face");
    assert_eq!(fault(|mesh| mesh.face_halfedge[1] = 0), "the first halfedge of face f1 is not in it");
    assert_eq!(
        fault(|mesh| mesh.vertex_halfedge[0] = 0),
        "the outer halfedge h5 is not the first one of its source v0"
    );
    assert_eq!(
        fault(|mesh| mesh.vertex_halfedge[3] = NONE),
        "the outer halfedge h7 is not the first one of its source v3"
    );
    assert_eq!(mesh.edge(HalfedgeId::new(3)), EdgeId::new(1));
}
