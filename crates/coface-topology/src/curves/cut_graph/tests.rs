use super::*;
use coface_complexes::known_spaces;
use coface_complexes::surface::SurfaceType;
use coface_complexes::surface::samples::{all_kinds, genus, map_of, of_next, with_holes};
use proptest::prelude::*;

fn check(name: &str, map: &GeneralizedMap, lengths: &[f64]) {
    let trees = TreeCotree::new(map);
    let plain = CutGraph::new(map, &trees, Some(lengths)).unwrap();
    let short = plain.shortened(map, Some(lengths), 20).unwrap();
    assert!(short.length() <= plain.length() + 1e-9, "{name}");
    assert_eq!(short, short.shortened(map, Some(lengths), 1).unwrap(), "{name}: nothing is left to do");
    for graph in [&plain, &short] {
        let sliced = map.slice_edges(&graph.edges()).unwrap();
        let has_edges = |component: usize| trees.components()[component].root();
        for (component, surface) in sliced.surface().surfaces().iter().enumerate() {
            let is_point_sphere = map.surfaces()[component] == SurfaceType::orientable(0, 0)
                && surface == &SurfaceType::orientable(0, 0);
            assert!(
                surface == &SurfaceType::orientable(0, 1) || is_point_sphere,
                "{name}: {surface} {:?}",
                has_edges(component)
            );
        }
        // Seams are paths, and have all edges once.
        let mut edges: Vec<EdgeId> = graph
            .seams()
            .iter()
            .flat_map(|seam| seam.steps().iter().map(|step| EdgeId::from_u32(step >> 1)))
            .collect();
        edges.sort();
        assert_eq!(edges, graph.edges(), "{name}");
        for seam in graph.seams() {
            let ends = map.skeleton().edge_ends();
            for pair in seam.steps().windows(2) {
                assert_eq!(ends[(pair[0] ^ 1) as usize], ends[pair[1] as usize]);
            }
        }
        check_kinds(name, map, graph);
    }
}

/// What each seam opens, by gluing the disk there.
fn check_kinds(name: &str, map: &GeneralizedMap, graph: &CutGraph) {
    for seam in graph.seams() {
        let own = |edge: &EdgeId| seam.steps().iter().any(|step| step >> 1 == edge.to_u32());
        let others: Vec<EdgeId> = graph.edges().into_iter().filter(|edge| !own(edge)).collect();
        let glued = map.slice_edges(&others).unwrap();
        let component =
            map.orientation().component(map.face(map.first_side(EdgeId::from_u32(seam.steps()[0] >> 1))));
        let surface = glued.surface().surfaces()[component];
        match (seam.kind(), seam.is_reversing()) {
            (SeamKind::Slit, _) => assert_eq!(surface, SurfaceType::orientable(0, 0), "{name}"),
            (_, true) => assert!(!surface.is_orientable() && surface.genus() == 1, "{name}"),
            (_, false) => assert_eq!(surface, SurfaceType::orientable(0, 2), "{name} {seam:?}"),
        }
    }
}

#[test]
fn cut_graphs_cut_to_disks() {
    for (name, map) in all_kinds() {
        check(name, &map, &vec![1.0; map.skeleton().edge_count()]);
    }
    let map = genus(2);
    let trees = TreeCotree::new(&map);
    let graph = CutGraph::new(&map, &trees, None).unwrap().shortened(&map, None, 20).unwrap();
    assert!(graph.corners().len() <= 6 && graph.seams().len() <= 9);
    assert!(graph.seams().iter().any(|seam| seam.kind() == SeamKind::Handle));
}

#[test]
fn seams_say_what_they_are_for() {
    let kinds = |map: &GeneralizedMap| {
        let graph = CutGraph::new(map, &TreeCotree::new(map), None).unwrap();
        let mut kinds: Vec<String> = graph.seams().iter().map(|seam| seam.kind().to_string()).collect();
        kinds.sort();
        kinds.dedup();
        kinds.join(" ")
    };
    assert_eq!(kinds(&map_of(known_spaces::simplex_boundary(2))), "slit");
    assert_eq!(kinds(&map_of(known_spaces::simplex(2))), "");
    assert_eq!(kinds(&map_of(known_spaces::triangle_strip(6))), "join");
    assert_eq!(kinds(&map_of(known_spaces::triangle_strip(5))), "crosscap");
    assert_eq!(kinds(&map_of(known_spaces::projective_plane())), "crosscap");
    assert_eq!(kinds(&map_of(known_spaces::cyclic_torus(2))), "handle");
    // A surface without handles has no seam that opens one, however its seams lie around the domain.
    assert_eq!(kinds(&map_of(known_spaces::klein_grid(5, 5))), "crosscap");
    for (name, map) in all_kinds() {
        let orientable: Vec<bool> = map.orientation().conflicts().iter().map(Option::is_none).collect();
        let graph = CutGraph::new(&map, &TreeCotree::new(&map), None).unwrap();
        for seam in graph.seams() {
            let face = map.face(map.first_side(EdgeId::from_u32(seam.steps()[0] >> 1)));
            let is_orientable = orientable[map.orientation().component(face)];
            assert!(seam.kind() != SeamKind::Handle || is_orientable, "{name}");
            assert!(seam.kind() != SeamKind::Crosscap || !is_orientable, "{name}");
            assert!(!seam.is_reversing() || seam.kind() == SeamKind::Crosscap, "{name}");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]

    #[test]
    fn permutation_surfaces_are_cut_to_disks(
        next in Just((0u32..20).collect::<Vec<_>>()).prop_shuffle(),
        lengths in prop::collection::vec(0u8..9, 10),
    ) {
        let lengths: Vec<f64> = lengths.into_iter().map(f64::from).collect();
        check("permutation", &of_next(next), &lengths);
    }

    #[test]
    fn surfaces_with_holes_are_cut_to_disks(
        removed in any::<u64>(), more in any::<u64>(), lengths in prop::collection::vec(1u8..9, 75),
    ) {
        for closed in [known_spaces::torus_grid(&[4, 4]), known_spaces::klein_grid(5, 5), known_spaces::projective_plane()] {
            if let Some(map) = with_holes(&map_of(closed), removed & more) {
                let count = map.skeleton().edge_count();
                let lengths: Vec<f64> = lengths[..count].iter().map(|&x| f64::from(x)).collect();
                check("with holes", &map, &lengths);
            }
        }
    }
}
