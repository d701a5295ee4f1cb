use super::search::search;
use crate::curves::shortest_cycle::{Known, from_roots, searched};
use crate::curves::{
    ClosedWalk, CycleKind, SurfaceHomology, SurfaceHomotopy, TreeCotree, shortest_cycle_until,
};
use coface_algebra::RaggedArray;
use coface_algebra::chains::TwoSkeleton;
use coface_complexes::known_spaces;
use coface_complexes::surface::GeneralizedMap;
use coface_complexes::surface::samples::{all_kinds, genus, map_of, of_next, polygon, with_holes};
use proptest::prelude::*;

/// The barycentric subdivision.
fn subdivided(map: &GeneralizedMap) -> GeneralizedMap {
    let skeleton = map.skeleton();
    let [v, e, f] = [skeleton.vertex_count(), skeleton.edge_count(), skeleton.face_count()];
    let mut ends: Vec<u32> = Vec::new();
    // From the start of each step to the middle of its edge; from the middle of each side and from its start to the middle of its face.
    for (step, &vertex) in skeleton.edge_ends().iter().enumerate() {
        ends.extend([vertex, (v + step / 2) as u32]);
    }
    for side in map.sides() {
        ends.extend([(v + map.edge(side).index()) as u32, (v + e + map.face(side).index()) as u32]);
    }
    for side in map.sides() {
        ends.extend([map.source(side).to_u32(), (v + e + map.face(side).index()) as u32]);
    }
    let half = |step: u32| 2 * step;
    let middle = |side: coface_algebra::HalfedgeId| 2 * (2 * e as u32 + side.to_u32());
    let corner =
        |side: coface_algebra::HalfedgeId| 2 * (2 * e as u32 + map.sides().len() as u32 + side.to_u32());
    let mut faces = RaggedArray::new();
    for side in map.sides() {
        let step = map.step(side);
        faces.push(&[half(step), middle(side), corner(side) ^ 1]);
        faces.push(&[half(step ^ 1) ^ 1, corner(map.next(side)), middle(side) ^ 1]);
    }
    GeneralizedMap::new(TwoSkeleton::new(v + e + f, ends, faces).unwrap()).unwrap()
}

/// Both searches give cycles of the kind of the same length.
fn check(name: &str, map: &GeneralizedMap, lengths: &[f64]) {
    for kind in [CycleKind::NonContractible, CycleKind::NonSeparating] {
        let map = &*searched(map, kind);
        let trees = TreeCotree::new(map);
        let found = search(map, lengths, kind, Known::default(), usize::MAX, &|| false).unwrap();
        let expected = from_roots(map, &trees, lengths, kind, usize::MAX, &|| false).unwrap();
        match (&found.cycle, expected.cycle()) {
            (None, None) => assert!(found.lower_bound.is_infinite()),
            (Some(cycle), Some(expected)) => {
                assert!(
                    (cycle.length() - expected.length()).abs() <= 1e-9,
                    "{name} {kind:?}: {} and not {}, {:?}, {lengths:?}",
                    cycle.length(),
                    expected.length(),
                    map.f_vector(),
                );
                assert!(found.lower_bound >= cycle.length());
                assert!(is_of_kind(map, &trees, cycle.walk(), kind), "{name} {kind:?}");
            }
            other => panic!("{name} {kind:?}: {other:?}"),
        }
    }
}

fn is_of_kind(map: &GeneralizedMap, trees: &TreeCotree, walk: &ClosedWalk, kind: CycleKind) -> bool {
    match kind {
        CycleKind::NonContractible => {
            !SurfaceHomotopy::new(map, trees).unwrap().is_contractible(walk).unwrap()
        }
        CycleKind::NonSeparating => {
            let class = SurfaceHomology::new(map, trees).class_of_walk(walk).unwrap();
            class.iter().any(|coefficient| coefficient % 2 != 0)
        }
    }
}

/// Lengths that look random: whole numbers up to `most`, or others for 0.
fn random_lengths(count: usize, seed: u64, most: u64) -> Vec<f64> {
    let mut state = seed | 1;
    let mut next = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        state.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 11
    };
    let length = |bits: u64| if most == 0 { bits as f64 / 9e15 } else { (bits % (most + 1)) as f64 };
    (0..count).map(|_| length(next())).collect()
}

#[test]
fn all_kinds_of_surfaces_are_searched_twice() {
    for (name, map) in all_kinds() {
        let fine = subdivided(&map);
        for map in [&map, &fine] {
            check(name, map, &vec![1.0; map.skeleton().edge_count()]);
            for seed in 1..8 {
                check(
                    name,
                    map,
                    &random_lengths(map.skeleton().edge_count(), seed, [0, 1, 2, 9][seed as usize % 4]),
                );
            }
        }
    }
}

/// The separating cycle around the neck between two tori is the shortest one that cannot be contracted.
#[test]
fn a_narrow_neck_separates() {
    for handles in [2, 3] {
        let map = genus(handles);
        let count = map.skeleton().edge_count();
        // What one half of the faces has in common with the other half is short.
        for seed in 1..20u64 {
            let mut faces = coface_algebra::UnionFind::new(map.face_count());
            let mut lengths = random_lengths(count, seed, 0);
            let found =
                search(&map, &lengths, CycleKind::NonSeparating, Known::default(), usize::MAX, &|| false)
                    .unwrap();
            let cycle = found.cycle.unwrap();
            let is_on = |edge: usize| cycle.walk().steps().iter().any(|step| (step >> 1) as usize == edge);
            for edge in 0..count {
                if !is_on(edge)
                    && let Some([a, b]) = map.dual_arc(coface_algebra::EdgeId::new(edge))
                {
                    faces.unite(a.to_u32(), b.to_u32());
                }
            }
            // Long everywhere but around that cycle and a second one, so that the boundary of a handle is short.
            let ends = map.skeleton().edge_ends();
            let near: Vec<u32> = cycle.walk().steps().iter().map(|&step| ends[step as usize]).collect();
            for (edge, length) in lengths.iter_mut().enumerate() {
                let touches = |v: u32| near.contains(&v);
                let count = [0, 1].into_iter().filter(|&end| touches(ends[2 * edge + end])).count();
                *length += [0.0, 3.0, 5.0][count];
            }
            check("neck", &map, &lengths);
        }
    }
}

#[test]
fn a_search_that_is_stopped_has_a_lower_bound() {
    let map = map_of(known_spaces::torus_grid(&[9, 11]));
    let lengths = random_lengths(map.skeleton().edge_count(), 5, 0);
    let all =
        search(&map, &lengths, CycleKind::NonContractible, Known::default(), usize::MAX, &|| false).unwrap();
    let least = all.cycle.unwrap().length();
    for calls in 0..60 {
        let left = std::cell::Cell::new(calls);
        let is_over = || {
            left.set(left.get() - 1);
            left.get() < 0
        };
        let found =
            search(&map, &lengths, CycleKind::NonContractible, Known::default(), usize::MAX, &is_over)
                .unwrap();
        let length = found.cycle.unwrap().length();
        assert!(found.lower_bound <= least + 1e-12 && least <= length + 1e-12, "{calls}");
        left.set(calls);
        let kind = CycleKind::NonContractible;
        let found = shortest_cycle_until(&map, Some(&lengths), kind, usize::MAX, &is_over).unwrap();
        let length = found.cycle().unwrap().length();
        assert!(found.lower_bound() <= least + 1e-12 && least <= length + 1e-12, "{calls}");
        // After the first searches half of the length is known.
        assert!(calls < 40 || found.lower_bound() >= length / 2.0, "{calls} {}", found.lower_bound());
    }
}

/// A polygon with its sides glued in pairs or left free.
fn random_polygon(seed: u64, sides: usize, free: usize) -> GeneralizedMap {
    let mut letters: Vec<i32> = (0..sides as i32).map(|i| i / 2 + 1).collect();
    letters.extend((0..free as i32).map(|i| sides as i32 + i + 1));
    let numbers = random_lengths(2 * letters.len(), seed, 0);
    for i in (1..letters.len()).rev() {
        letters.swap(i, (numbers[i] * (i + 1) as f64) as usize % (i + 1));
    }
    let turns = &numbers[letters.len()..];
    // All alike, or mixed.
    let turn = |i: usize| if seed.is_multiple_of(3) { false } else { turns[i] < 0.5 };
    let mut seen = Vec::new();
    for (i, letter) in letters.iter_mut().enumerate() {
        let is_second = seen.contains(letter);
        seen.push(*letter);
        if is_second != turn(i) {
            *letter = -*letter;
        }
    }
    polygon(&letters)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn tori_are_searched_twice(rows in 3u32..9, columns in 3u32..9, seed in any::<u64>(), most in 0u64..5, removed in any::<u64>()) {
        let torus = map_of(known_spaces::torus_grid(&[rows, columns]));
        check("torus", &torus, &random_lengths(torus.skeleton().edge_count(), seed, most));
        if let Some(map) = with_holes(&torus, removed & removed.rotate_left(17) & removed.rotate_left(31)) {
            check("torus with holes", &map, &random_lengths(map.skeleton().edge_count(), seed, most));
        }
    }

    #[test]
    fn glued_polygons_are_searched_twice(seed in any::<u64>(), pairs in 1usize..7, free in 0usize..4, most in 0u64..5, fine in any::<bool>()) {
        let polygon = subdivided(&random_polygon(seed, 2 * pairs, free));
        let map = if fine { subdivided(&polygon) } else { polygon };
        check("polygon", &map, &random_lengths(map.skeleton().edge_count(), seed, most));
    }

    #[test]
    fn surfaces_of_permutations_are_searched_twice(
        next in Just((0u32..40).collect::<Vec<_>>()).prop_shuffle(), seed in any::<u64>(), most in 0u64..5,
    ) {
        let map = of_next(next);
        check("permutation", &map, &random_lengths(map.skeleton().edge_count(), seed, most));
        let map = subdivided(&map);
        check("permutation", &map, &random_lengths(map.skeleton().edge_count(), seed, most));
    }
}
