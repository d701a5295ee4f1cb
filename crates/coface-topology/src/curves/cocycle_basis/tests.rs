use super::*;
use crate::curves::exactness;
use crate::curves::exactness::Exactness;
use crate::curves::slicing_cocycle::intersection_number;
use crate::curves::surface_homotopy::tests::random_walk;
use crate::curves::tree_cotree::TreeCotree;
use crate::homology::{Bounding, HomologyBasis, homology};
use coface_algebra::EdgeId;
use coface_algebra::chains::Chain;
use coface_algebra::{Sign, smith_form};
use coface_complexes::known_spaces;
use coface_complexes::surface::samples::{
    all_kinds, genus, map_of, of_next, polygon, with_faces_turned, with_holes,
};
use proptest::prelude::*;

fn is_exact(map: &GeneralizedMap, cochain: &Cochain<Integer>) -> bool {
    matches!(exactness(map.skeleton(), cochain).unwrap(), Exactness::Exact { .. })
}

/// All that must hold on any surface.
fn check(name: &str, map: &GeneralizedMap) {
    let trees = TreeCotree::new(map);
    let found = SurfaceHomology::new(map, &trees);
    let complex = map.skeleton().chain_complex().unwrap();
    let basis = CocycleBasis::by_crossing(&found);
    let groups = homology(&complex);
    let betti = groups.groups().get(1).map_or(0, |group| group.betti());
    assert_eq!((basis.cocycles().len(), basis.loops().len()), (betti, betti), "{name}");
    let identity = |i: usize| (0..betti).map(move |j| i64::from(i == j)).collect::<Vec<_>>();
    assert!(basis.pairing().iter().enumerate().all(|(i, row)| *row == identity(i)), "{name}");
    let general = HomologyBasis::unshortened(&complex);
    let mut rows = Vec::new();
    for (cocycle, row) in basis.cocycles().iter().zip(basis.pairing()) {
        assert!(complex.is_closed(cocycle).unwrap(), "{name}");
        for (walk, &value) in basis.loops().iter().zip(row) {
            let expected = cocycle.pairing(&walk.chain()).unwrap().unwrap_or(Integer::ZERO);
            assert_eq!(expected, Integer::from(value), "{name}");
        }
        // The classes in the general basis are as many as the rank, and unimodular.
        let class = general.class_of_cocycle(cocycle).unwrap();
        rows.push(class.coefficients()[class.coefficients().len() - betti..].to_vec());
    }
    let entries = rows
        .iter()
        .enumerate()
        .flat_map(|(i, row)| row.iter().enumerate().map(move |(j, x)| (i, j, x.to_i64().unwrap())));
    let matrix = SparseMatrix::from_entries(betti, betti, entries).unwrap();
    let smith = smith_form(&matrix);
    assert!(smith.rank() == betti && smith.diagonal().iter().all(Integer::is_unit), "{name}");
    // What bounds, and what does not, and why.
    let loops = found.loops();
    for (i, walk) in loops.iter().enumerate() {
        let mut unit = vec![0; loops.len()];
        unit[i] = 1;
        assert_eq!(found.class_of_walk(walk).unwrap(), unit, "{name}");
        let cycles = [walk.chain(), walk.chain().plus(&loops[0].chain()).unwrap()];
        for cycle in cycles {
            check_bounding(name, &found, &general, &cycle);
        }
    }
    let every = loops.iter().fold(Chain::zero(1), |sum, walk| sum.plus(&walk.chain()).unwrap());
    check_bounding(name, &found, &general, &every);
    for matrix in complex.boundary_matrix(2).into_iter() {
        for column in matrix.columns().take(5) {
            let terms = column.iter().map(|(row, x)| (CellId::new(row), Integer::from(3 * x)));
            check_bounding(name, &found, &general, &Chain::new(&complex, 1, terms).unwrap());
        }
    }
}

fn check_bounding(
    name: &str,
    found: &SurfaceHomology<'_>,
    general: &HomologyBasis<'_>,
    cycle: &Chain<Integer>,
) {
    let complex = general.complex();
    match (found.bounding(cycle).unwrap(), general.bounding(cycle).unwrap()) {
        (Bounding::Bounds(chain), Bounding::Bounds(_)) => {
            assert_eq!(&complex.boundary(&chain).unwrap(), cycle, "{name}");
        }
        (
            Bounding::MultipleBounds { multiple, chain },
            Bounding::MultipleBounds { multiple: expected, .. },
        ) => {
            assert_eq!(multiple, expected, "{name}");
            assert_eq!(complex.boundary(&chain).unwrap(), cycle.scaled(&multiple).unwrap(), "{name}");
        }
        (Bounding::Never { cocycle, value }, Bounding::Never { .. }) => {
            assert!(complex.is_closed(&cocycle).unwrap(), "{name}");
            assert_eq!(cocycle.pairing(cycle).unwrap(), Some(value), "{name}");
        }
        (a, b) => panic!("{name}: {a:?} {b:?}"),
    }
}

/// Slicing on a closed oriented surface, against crossing.
fn check_slicing(map: &GeneralizedMap) {
    let trees = TreeCotree::new(map);
    let homology = SurfaceHomology::new(map, &trees);
    let complex = map.skeleton().chain_complex().unwrap();
    let sliced = CocycleBasis::by_slicing(map, homology.loops()).unwrap();
    assert_eq!(sliced.determinant(), Some(&Integer::ONE));
    let crossed = CocycleBasis::by_crossing(&homology);
    for (i, cocycle) in sliced.cocycles().iter().enumerate() {
        assert!(complex.is_closed(cocycle).unwrap());
        for (j, walk) in sliced.loops().iter().enumerate() {
            let value = cocycle.pairing(&walk.chain()).unwrap().unwrap_or(Integer::ZERO);
            assert_eq!(value, Integer::from(sliced.pairing()[i][j]));
            assert_eq!(intersection_number(map, &sliced.loops()[i], walk).unwrap(), -sliced.pairing()[i][j]);
        }
    }
    let dual = sliced.dual().unwrap();
    for ((a, b), walk) in dual.cocycles().iter().zip(crossed.cocycles()).zip(dual.loops()) {
        assert!(is_exact(map, &a.minus(b).unwrap()));
        assert_eq!(a.pairing(&walk.chain()).unwrap(), Some(Integer::ONE));
    }
}

#[test]
fn cocycles_by_crossing_are_a_basis_on_all_surfaces() {
    for (name, map) in all_kinds() {
        check(name, &map);
        check(name, &with_faces_turned(&map, 0x5a5a_1234_9876_0f0f));
    }
}

#[test]
fn slicing_agrees_with_crossing() {
    for map in
        [map_of(known_spaces::cyclic_torus(2)), genus(2), genus(3), polygon(&[1, 2, 3, 4, -1, -2, -3, -4])]
    {
        check_slicing(&map);
        check_slicing(&with_faces_turned(&map, 0x1234_5678_9abc_def0));
    }
    let torus = map_of(known_spaces::cyclic_torus(2));
    let trees = TreeCotree::new(&torus);
    let loops = SurfaceHomology::new(&torus, &trees).loops();
    let pairing = CocycleBasis::by_slicing(&torus, loops).unwrap().pairing().to_vec();
    assert!(pairing == [[0, -1], [1, 0]] || pairing == [[0, 1], [-1, 0]]);
}

#[test]
fn slicing_on_the_sliced_surface_is_a_jump() {
    // The function that is 1 on the left copy of a simple loop: its coboundary on the sliced surface, put back.
    let map = genus(2);
    let trees = TreeCotree::new(&map);
    for walk in SurfaceHomology::new(&map, &trees).loops() {
        let edges: Vec<EdgeId> = walk.steps().iter().map(|step| EdgeId::from_u32(step >> 1)).collect();
        let sliced = map.slice_edges(&edges).unwrap();
        let slicing = Slicing::new(&map);
        let signs = map.orientation();
        // Vertices of the left copy: the ends of the sides to the left.
        let mut is_left = vec![false; sliced.surface().skeleton().vertex_count()];
        for side in map.sides() {
            let along = if signs.signs()[map.face(side).index()] == Sign::Plus {
                map.step(side)
            } else {
                map.step(side) ^ 1
            };
            if walk.steps().contains(&along) {
                is_left[sliced.surface().source(side).index()] = true;
                is_left[sliced.surface().target(side).index()] = true;
            }
        }
        let cocycle = slicing.cocycle(&walk).unwrap();
        for edge in (0..sliced.surface().skeleton().edge_count()).map(EdgeId::new) {
            let [source, target] =
                sliced.surface().skeleton().edge(edge).map(|v| i64::from(is_left[v.index()]));
            let below = CellId::new(sliced.edge_sources()[edge].index());
            let value = cocycle.coefficient(below).cloned().unwrap_or(Integer::ZERO);
            assert_eq!(Integer::from(target - source), value);
        }
    }
}

#[test]
fn one_sided_loops_are_refused() {
    let plane = polygon(&[1, 1]);
    let once = ClosedWalk::new(plane.skeleton(), vec![0]).unwrap();
    let error = CocycleBasis::by_slicing(&plane, vec![once]).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::InvalidInput);
    assert!(error.message().starts_with("the closed walk through v0 v0 is one-sided"), "{error}");
    let twice = ClosedWalk::new(plane.skeleton(), vec![0, 0]).unwrap();
    assert!(is_exact(&plane, &Slicing::new(&plane).cocycle(&twice).unwrap()));
    // No inverse where there is a boundary between.
    let annulus = map_of(known_spaces::triangle_strip(6));
    let trees = TreeCotree::new(&annulus);
    let around = SurfaceHomology::new(&annulus, &trees).loops();
    let sliced = CocycleBasis::by_slicing(&annulus, around).unwrap();
    assert_eq!(sliced.pairing(), [[0]]);
    assert_eq!(sliced.dual().unwrap_err().kind(), ErrorKind::Coefficient);
}

#[test]
fn walks_that_turn_back_or_run_along_the_boundary_are_welcome() {
    for (_, map) in all_kinds() {
        let complex = map.skeleton().chain_complex().unwrap();
        let slicing = Slicing::new(&map);
        for edge in 0..map.skeleton().edge_count() as u32 {
            // Forth and back: homologous to nothing.
            let walk = ClosedWalk::new(map.skeleton(), vec![2 * edge, 2 * edge + 1]).unwrap();
            assert!(is_exact(&map, &slicing.cocycle(&walk).unwrap()));
        }
        for hole in map.boundary_loops() {
            let steps = hole.iter().map(|&(side, sign)| map.step(side) ^ u32::from(sign == Sign::Minus));
            let walk = ClosedWalk::new(map.skeleton(), steps.collect()).unwrap();
            for walk in [walk.reversed(), walk] {
                let cocycle = slicing.cocycle(&walk).unwrap();
                assert!(complex.is_closed(&cocycle).unwrap());
                assert_eq!(intersection_number(&map, &walk, &walk).unwrap(), 0);
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// Every pair of permutations: one vertex or many, edges that are loops, monogons, digons.
    #[test]
    fn permutation_surfaces_have_dual_bases(
        next in Just((0u32..16).collect::<Vec<_>>()).prop_shuffle(), turned in any::<u64>(),
    ) {
        let map = with_faces_turned(&of_next(next), turned);
        check("permutation", &map);
        check_slicing(&map);
    }

    #[test]
    fn surfaces_with_holes_have_bases(removed in any::<u64>(), more in any::<u64>(), turned in any::<u64>()) {
        for closed in [map_of(known_spaces::torus_grid(&[4, 4])), map_of(known_spaces::klein_grid(4, 4))] {
            if let Some(map) = with_holes(&closed, removed & more) {
                check("with holes", &with_faces_turned(&map, turned));
            }
        }
    }

    /// Walks at random: bilinear, skew, and told by classes.
    #[test]
    fn intersection_numbers_are_told_by_classes(choices in prop::collection::vec(0usize..64, 2..24)) {
        let map = genus(2);
        let trees = TreeCotree::new(&map);
        let homology = SurfaceHomology::new(&map, &trees);
        let loops = homology.loops();
        let form = CocycleBasis::by_slicing(&map, loops).unwrap();
        let half = choices.len() / 2;
        let walks = [&choices[..half], &choices[half..]].map(|part| random_walk(&map, &trees, part));
        let [Some(a), Some(b)] = walks else { return Ok(()) };
        if a.is_empty() || b.is_empty() { return Ok(()) }
        let [x, y] = [&a, &b].map(|walk| homology.class_of_walk(walk).unwrap());
        let mut expected = 0;
        for (i, row) in form.pairing().iter().enumerate() {
            for (j, value) in row.iter().enumerate() {
                expected -= x[i] * value * y[j];
            }
        }
        prop_assert_eq!(intersection_number(&map, &a, &b).unwrap(), expected);
        prop_assert_eq!(intersection_number(&map, &b, &a).unwrap(), -expected);
    }
}
