use super::*;
use crate::groups::{EdgePathGroups, Presentation};
use crate::homology::{AbelianGroup, homology};
use coface_algebra::RaggedArray;
use coface_algebra::VertexId;
use coface_algebra::chains::TwoSkeleton;
use coface_complexes::known_spaces;
use coface_complexes::simplicial::SimplicialComplex;
use coface_complexes::surface::HalfedgeMesh;
use proptest::prelude::*;

fn map_of(space: &SimplicialComplex) -> GeneralizedMap {
    GeneralizedMap::new(space.freeze().two_skeleton().unwrap()).unwrap()
}

/// The group that the relator of a domain presents, made abelian.
fn abelianization(domain: &FundamentalDomain, generators: usize) -> AbelianGroup {
    Presentation::new(generators, domain.relator().into_iter().collect()).unwrap().abelianization()
}

fn ends_of(map: &GeneralizedMap, step: u32) -> [VertexId; 2] {
    let ends = map.skeleton().edge_ends();
    [VertexId::from_u32(ends[step as usize]), VertexId::from_u32(ends[(step ^ 1) as usize])]
}

fn check_closed(map: &GeneralizedMap, steps: &[u32]) {
    for (i, &step) in steps.iter().enumerate() {
        assert_eq!(ends_of(map, step)[1], ends_of(map, steps[(i + 1) % steps.len()])[0]);
    }
}

/// All that must hold of the trees and domains of a surface.
fn check(map: &GeneralizedMap, trees: &TreeCotree) {
    let cut = CutSurface::new(map, trees);
    assert_eq!(map.surfaces().len(), cut.domains().len());
    for (found, domain) in trees.components().iter().zip(cut.domains()) {
        let generators = found.generators();
        // The polygon: as many sides as it should have, each next to the one before.
        let sides: Vec<_> = domain.sides().collect();
        for (position, &(side, sign)) in sides.iter().enumerate() {
            assert_eq!(cut.side_position(side), Some(position));
            let (next, next_sign) = sides[(position + 1) % sides.len()];
            let end = if sign == Sign::Plus { map.target(side) } else { map.source(side) };
            let start = if next_sign == Sign::Plus { map.source(next) } else { map.target(next) };
            assert_eq!(end, start);
        }
        let boundary = sides.iter().filter(|(side, _)| map.mate(*side).is_none()).count();
        assert_eq!(domain.side_count(), 2 * domain.cut_edge_count() + boundary);
        if domain.side_count() > 0 {
            assert_eq!(domain.euler_characteristic(), 1);
        }
        // Each generator twice in the relator.
        if let Some(relator) = domain.relator() {
            for letter in 1..=generators.len() as i32 {
                assert_eq!(relator.letters().iter().filter(|l| l.abs() == letter).count(), 2);
            }
        }
        for (i, &edge) in generators.iter().enumerate() {
            let letter = i as i32 + 1;
            let based = trees.based_loop(map, edge);
            check_closed(map, &based);
            assert_eq!(ends_of(map, based[0])[0], found.base());
            assert_eq!(cut.path_word(map, &based).letters(), [letter]);
            let simple = trees.simple_loop(map, edge);
            check_closed(map, &simple);
            let mut starts: Vec<_> = simple.iter().map(|&step| ends_of(map, step)[0]).collect();
            starts.sort();
            starts.dedup();
            assert_eq!(starts.len(), simple.len(), "a simple loop meets no vertex twice");
            // The dual loop crosses this generator, and no other one, and no edge of the tree.
            if let Some(dual) = trees.dual_loop(map, map.first_side(edge)) {
                let mut at = map.face(map.first_side(edge));
                for &side in &dual {
                    assert_eq!(map.face(side), at);
                    at = map.face(map.mate(side).unwrap());
                    let role = trees.roles()[map.edge(side).index()];
                    assert!(role == EdgeRole::Cotree || map.edge(side) == edge);
                }
                assert_eq!(at, map.face(dual[0]));
            }
        }
    }
    // Going around a face is the unit, up to the relator: exactly where the group is free, by exponent sums everywhere.
    for face in (0..map.skeleton().face_count()).map(FaceId::new) {
        let mut word = Word::from_letters([]);
        for side in map.sides_of(face) {
            word.append(&cut.side_word(map, side));
        }
        let component = trees.component_of_face(face);
        match cut.domains()[component].relator() {
            None => assert!(word.is_empty()),
            Some(relator) => {
                let count = trees.components()[component].generators().len();
                let (sums, relator) = (word.exponent_sums(count), relator.exponent_sums(count));
                assert!(
                    (-2..=2).any(|times| sums.iter().zip(&relator).all(|(a, b)| *a == times * b)),
                    "{sums:?} {relator:?}"
                );
            }
        }
    }
    // Crossing there and back again is the unit.
    for side in map.sides() {
        let Some(there) = cut.crossing(map, side) else { continue };
        let back = cut.crossing(map, map.mate(side).unwrap()).unwrap();
        assert!(there.times(&back).is_empty());
    }
    // Made abelian, the groups are H_1.
    let complex = map.skeleton().chain_complex().unwrap();
    let homology = homology(&complex);
    let (mut betti, mut torsion) = (0, Vec::new());
    for (found, domain) in trees.components().iter().zip(cut.domains()) {
        let group = abelianization(domain, found.generators().len());
        betti += group.betti();
        torsion.extend_from_slice(group.torsion());
    }
    let expected = homology.groups().get(1).cloned().unwrap_or_default();
    assert_eq!(AbelianGroup::new(betti, torsion), expected);
}

#[test]
fn the_numbers_of_known_surfaces_are_found() {
    // Vertices, cut edges, sides of the domain and letters of the relator do not depend on the trees.
    let torus = known_spaces::cyclic_torus(2).unwrap();
    let genus = |g: usize| {
        let sum = |sum: SimplicialComplex, _| known_spaces::oriented_sum(&sum, &torus, Sign::Plus).unwrap();
        (1..g).fold(torus.clone(), sum)
    };
    let table = [
        (torus.clone(), 8, 16, 4),
        (genus(2), 14, 28, 8),
        (genus(3), 20, 40, 12),
        (genus(10), 62, 124, 40),
        (known_spaces::cross_polytope_boundary(2).unwrap(), 5, 10, 0),
    ];
    for (space, cut_edges, sides, letters) in table {
        let map = map_of(&space);
        for trees in [TreeCotree::new(&map), TreeCotree::greedy(&map, None, None).unwrap()] {
            let cut = CutSurface::new(&map, &trees);
            let domain = &cut.domains()[0];
            assert_eq!((domain.cut_edge_count(), domain.side_count()), (cut_edges, sides));
            assert_eq!(domain.relator().unwrap().len(), letters);
            check(&map, &trees);
        }
    }
}

#[test]
fn surfaces_with_one_vertex_and_points_are_ordinary() {
    for next in [vec![], vec![0, 1], vec![1, 0], vec![2, 3, 1, 0], vec![2, 3, 4, 5, 0, 1]] {
        let map =
            GeneralizedMap::new(HalfedgeMesh::from_next(next).unwrap().two_skeleton().unwrap()).unwrap();
        check(&map, &TreeCotree::new(&map));
    }
    let points = GeneralizedMap::new(TwoSkeleton::new(2, vec![], RaggedArray::new()).unwrap()).unwrap();
    let trees = TreeCotree::new(&points);
    assert!(trees.components().is_empty());
    assert_eq!(trees.component_of_vertex(VertexId::new(1)), None);
    assert!(TreeCotree::greedy(&points, Some(VertexId::new(0)), None).is_err());
}

#[test]
fn bad_lengths_are_named() {
    let map = map_of(&known_spaces::cyclic_torus(2).unwrap());
    let fault =
        |lengths: &[f64]| TreeCotree::greedy(&map, None, Some(lengths)).unwrap_err().message().to_owned();
    assert_eq!(fault(&[1.0]), "1 lengths for 21 edges");
    let mut lengths = vec![1.0; 21];
    lengths[3] = -2.0;
    assert_eq!(fault(&lengths), "edge e3 has the length -2");
}

proptest! {
    #[test]
    fn every_surface_of_permutations_is_cut(
        next in Just((0u32..16).collect::<Vec<_>>()).prop_shuffle(),
        lengths in prop::collection::vec(0u8..9, 8),
    ) {
        let map = GeneralizedMap::new(HalfedgeMesh::from_next(next).unwrap().two_skeleton().unwrap()).unwrap();
        check(&map, &TreeCotree::new(&map));
        let lengths: Vec<f64> = lengths.into_iter().map(f64::from).collect();
        check(&map, &TreeCotree::greedy(&map, None, Some(&lengths)).unwrap());
    }

    /// Polygons with random letters on their sides: orientable or not, with boundary or not.
    #[test]
    fn every_gluing_of_polygons_is_cut(
        sizes in prop::collection::vec(1usize..6, 1..5),
        order in Just((0usize..20).collect::<Vec<_>>()).prop_shuffle(),
        turned in prop::collection::vec(any::<bool>(), 20),
        free in 0usize..4,
        base in 0usize..20,
    ) {
        let total: usize = sizes.iter().sum();
        let order: Vec<usize> = order.into_iter().filter(|&side| side < total).collect();
        let mut mate: Vec<u32> = (0..2 * total as u32).collect();
        for pair in order[..total - free.min(total)].chunks_exact(2) {
            let [s, t] = [pair[0], pair[1]];
            let turn = u32::from(turned[s]);
            for end in 0..2 {
                mate[2 * s + end] = 2 * t as u32 + (end as u32 ^ turn);
                mate[2 * t + (end ^ turn as usize)] = (2 * s + end) as u32;
            }
        }
        let other_end = (0..2 * total as u32).map(|flag| flag ^ 1).collect();
        let mut corner = vec![0; 2 * total];
        let mut start = 0;
        for size in sizes {
            for i in 0..size {
                let (end, next) = (2 * (start + i) + 1, 2 * (start + (i + 1) % size));
                corner[end] = next as u32;
                corner[next] = end as u32;
            }
            start += size;
        }
        let map = GeneralizedMap::from_involutions(&[other_end, corner, mate]).unwrap().0;
        check(&map, &TreeCotree::new(&map));
        let base = VertexId::new(base % map.skeleton().vertex_count());
        let greedy = TreeCotree::greedy(&map, Some(base), None).unwrap();
        prop_assert_eq!(greedy.components()[0].base(), base);
        check(&map, &greedy);
        // The same groups as those of edge paths.
        let groups = EdgePathGroups::new(map.skeleton());
        prop_assert_eq!(groups.component_count(), TreeCotree::new(&map).components().len());
        // Sliced along the cut graph, each component is a disk.
        let cut = CutSurface::new(&map, &greedy);
        let sliced = map.slice_edges(&cut.cut_graph(&map)).unwrap();
        let disks = sliced.surface().surfaces().iter().filter(|surface| surface.to_string() == "disk").count();
        prop_assert_eq!(disks, cut.domains().iter().filter(|domain| domain.side_count() > 0).count());
        let total = cut.domains().iter().map(|domain| domain.f_vector()).fold([0; 3], |a, b| {
            [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
        });
        prop_assert_eq!(sliced.surface().f_vector(), total);
    }
}
