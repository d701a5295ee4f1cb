use super::samples::polygon;
use super::*;
use crate::known_spaces;
use crate::surface::{HalfedgeMesh, PolygonMesh};
use coface_algebra::RaggedArray;
use proptest::prelude::*;

fn map_of(faces: &[&[u32]], ends: &[u32], vertex_count: usize) -> Result<GeneralizedMap, Error> {
    GeneralizedMap::new(
        TwoSkeleton::new(vertex_count, ends.to_vec(), RaggedArray::from_lists(faces)).unwrap(),
    )
}

/// All invariants, told by the flags alone.
fn check_flags(map: &GeneralizedMap) {
    for flag in 0..2 * map.side_count() as u32 {
        let images = [0, 1, 2].map(|i| map.alpha(i, flag));
        for (i, image) in images.into_iter().enumerate() {
            assert_eq!(map.alpha(i, image), flag);
        }
        assert!(images[0] != flag && images[1] != flag && images[0] != images[2]);
        assert_eq!(map.alpha(0, images[2]), map.alpha(2, images[0]));
        assert_eq!(map.flag_vertex(images[1]), map.flag_vertex(flag));
        assert_eq!(map.flag_vertex(images[2]), map.flag_vertex(flag));
        let [side, across] = [flag, images[2]].map(|f| HalfedgeId::from_u32(f >> 1));
        assert_eq!(map.edge(side), map.edge(across));
    }
}

#[test]
fn one_polygon_makes_every_surface() {
    let table: [(&[i32], &str); 12] = [
        (&[1, -1], "sphere"),
        (&[1, 1], "projective plane"),
        (&[1, 2, -1, -2], "torus"),
        (&[1, 2, -1, 2], "Klein bottle"),
        (&[1, 1, 2, 2], "Klein bottle"),
        (&[1, 2, 1, 3], "Moebius band"),
        (&[1, 2, -1, 3], "annulus"),
        (&[1], "disk"),
        (&[1, 2, -1, -2, 3, 4, -3, -4], "double torus"),
        (&[1, 2, 3, 4, -1, -2, -3, -4], "double torus"),
        (&[1, 1, 2, 2, 3, 3], "non-orientable surface with 3 crosscaps"),
        (&[1, 2, -1, 3, 4, -3, 5], "pair of pants"),
    ];
    for (letters, name) in table {
        let map = polygon(letters);
        assert_eq!(map.surfaces()[0].to_string(), name, "{letters:?}");
        check_flags(&map);
    }
}

#[test]
fn double_covers_are_oriented() {
    // Over an orientable surface two copies of it; over others a surface of twice the Euler characteristic.
    let table: [(&[i32], &[&str]); 6] = [
        (&[1, 1], &["sphere"]),
        (&[1, 1, 2, 2], &["torus"]),
        (&[1, 2, 1, 3], &["annulus"]),
        (&[1, 1, 2, 2, 3, 3], &["double torus"]),
        (&[1, 2, -1, -2], &["torus", "torus"]),
        (&[1], &["disk", "disk"]),
    ];
    for (letters, names) in table {
        let map = polygon(letters);
        let double = map.orientation_double_cover();
        let cover = double.map();
        check_flags(cover);
        assert!(cover.sides().all(|side| cover.agrees(side)));
        let found: Vec<String> = cover.surfaces().iter().map(ToString::to_string).collect();
        assert_eq!(found, names);
        assert_eq!(cover.f_vector(), map.f_vector().iter().map(|count| 2 * count).collect::<Vec<usize>>());
        for side in cover.sides() {
            let edge = cover.skeleton().edge(cover.edge(side));
            let below = map.skeleton().edge(double.edge_below(cover.edge(side)));
            assert_eq!(edge.map(|vertex| double.vertex_below(vertex)), below);
        }
    }
}

#[test]
fn faults_name_the_cells() {
    let fault = |faces: &[&[u32]], ends: &[u32], n| map_of(faces, ends, n).unwrap_err().message().to_owned();
    let book = [0, 1, 1, 2, 0, 2, 1, 3, 0, 3, 1, 4, 0, 4];
    assert_eq!(
        fault(&[&[0, 2, 5], &[0, 6, 9], &[0, 10, 13]], &book, 5),
        "edge e0 = {v0, v1} is on 3 sides of faces: f0, f1, f2"
    );
    assert_eq!(fault(&[&[0, 2, 5]], &[0, 1, 1, 2, 0, 2, 0, 3], 4), "edge e3 = {v0, v3} lies in no face");
    // Of both the loose edge is named: what removes it mends the other too.
    let flag = [&book[..], &[4, 5]].concat();
    assert_eq!(
        fault(&[&[0, 2, 5], &[0, 6, 9], &[0, 10, 13]], &flag, 6),
        "edge e7 = {v4, v5} lies in no face"
    );
    let bow = [0, 1, 1, 2, 0, 2, 0, 3, 3, 4, 0, 4];
    assert_eq!(fault(&[&[0, 2, 5], &[6, 8, 11]], &bow, 5), "2 fans of faces meet at vertex v0 only: f0 | f1");
    assert_eq!(fault(&[&[]], &[], 1), "face f0 has no sides");
}

#[test]
fn faults_of_involutions_name_the_flag() {
    let fault = |a: &[u32], b: &[u32], c: &[u32]| {
        GeneralizedMap::from_involutions(&[a.to_vec(), b.to_vec(), c.to_vec()])
            .unwrap_err()
            .message()
            .to_owned()
    };
    let [ends, corners] = [[1, 0, 3, 2], [3, 2, 1, 0]];
    assert_eq!(fault(&ends, &corners, &[0]), "the involutions have 4, 4 and 1 flags, not as many each");
    assert_eq!(
        fault(&ends, &corners, &[0, 1, 2, 9]),
        "involution 2 takes flag 3 to 9, but there are 4 flags"
    );
    assert_eq!(fault(&[0, 1, 3, 2], &corners, &[0, 1, 2, 3]), "involution 0 leaves flag 0 where it is");
    assert_eq!(fault(&ends, &corners, &[0, 2, 3, 1]), "involution 2 takes flag 1 to 2, but 2 to 3");
    assert_eq!(fault(&ends, &corners, &[2, 1, 0, 3]), "involutions 0 and 2 do not commute at flag 0");
    assert_eq!(fault(&ends, &corners, &[1, 0, 2, 3]), "involutions 0 and 2 both take flag 0 to 1");
}

#[test]
fn polygon_meshes_and_maps_agree() {
    for space in [known_spaces::cyclic_torus(2).unwrap(), known_spaces::projective_plane().unwrap()] {
        let map = GeneralizedMap::new(space.freeze().two_skeleton().unwrap()).unwrap();
        check_flags(&map);
        assert_eq!(map.component_count(), 1);
        assert!(map.boundary_loops().is_empty());
    }
    let empty = map_of(&[], &[], 2).unwrap();
    assert_eq!((empty.component_count(), empty.surfaces().len()), (2, 0));
}

proptest! {
    /// Involutions, out and in again, with every surface of pairs of permutations.
    #[test]
    fn halfedge_surfaces_are_orientable_maps(next in Just((0u32..14).collect::<Vec<_>>()).prop_shuffle()) {
        let mesh = HalfedgeMesh::from_next(next).unwrap();
        let map = GeneralizedMap::new(mesh.two_skeleton().unwrap()).unwrap();
        check_flags(&map);
        let orientation = map.orientation();
        prop_assert!(orientation.conflicts().iter().all(Option::is_none));
        prop_assert_eq!(orientation.conflicts().len(), mesh.component_count());
        let genus: usize = map.surfaces().iter().map(|surface| surface.genus()).sum();
        prop_assert_eq!(genus, mesh.genus());
        let flags = 0..2 * map.side_count() as u32;
        let involutions = [0, 1, 2].map(|i| flags.clone().map(|flag| map.alpha(i, flag)).collect());
        let (again, numbers) = GeneralizedMap::from_involutions(&involutions).unwrap();
        for flag in flags {
            for i in 0..3 {
                prop_assert_eq!(
                    again.alpha(i, numbers[flag as usize]), numbers[map.alpha(i, flag) as usize]);
            }
        }
    }

    /// Random triangles: the map is refused exactly where the mesh is no surface, and says the same about it.
    #[test]
    fn maps_and_meshes_say_the_same(
        triangles in prop::collection::vec(
            Just((0u32..7).collect::<Vec<_>>()).prop_shuffle().prop_map(|v| [v[0], v[1], v[2]]), 1..7),
    ) {
        let mesh = PolygonMesh::new(7, RaggedArray::from_lists(&triangles), &[]).unwrap();
        let survey = mesh.survey();
        match GeneralizedMap::new(mesh.two_skeleton().unwrap()) {
            Err(_) => prop_assert!(!survey.verdict().is_manifold()),
            Ok(map) => {
                prop_assert!(survey.verdict().is_manifold());
                check_flags(&map);
                let mut found = map.surfaces();
                let mut expected: Vec<_> = survey.parts().iter().filter_map(|part| part.surface()).collect();
                found.sort();
                expected.sort();
                prop_assert_eq!(found, expected);
                prop_assert_eq!(map.component_count(), survey.components().count());
                let double = map.orientation_double_cover();
                check_flags(double.map());
                prop_assert!(double.map().sides().all(|side| double.map().agrees(side)));
                for hole in map.boundary_loops() {
                    // Each side ends where the next starts, and none has a mate.
                    for (i, &(side, sign)) in hole.iter().enumerate() {
                        let (next, next_sign) = hole[(i + 1) % hole.len()];
                        let end = if sign == Sign::Plus { map.target(side) } else { map.source(side) };
                        let start = if next_sign == Sign::Plus { map.source(next) } else { map.target(next) };
                        prop_assert_eq!(end, start);
                        prop_assert!(map.mate(side).is_none());
                    }
                }
            }
        }
    }
}
