//! Vietoris-Rips persistence against the reduction of the whole complex.

use super::*;
use crate::homology::Coefficients;
use crate::persistence::{Filtration, persistence, persistent_cycles};
use coface_algebra::chains::ChainComplex;
use coface_algebra::{CellId, ErrorKind, SparseMatrix, VertexId};
use coface_complexes::filtered::{Distances, WeightedGraph};
use proptest::prelude::*;

/// The second method: every simplex up to the degree above `dimension` in a chain complex, reduced as any other. The distance of a point to itself is where
/// it enters.
fn by_the_whole_complex(
    count: usize,
    distance: impl Fn(usize, usize) -> f64,
    threshold: f64,
    dimension: usize,
    p: u64,
) -> Vec<(usize, String)> {
    let points = (0..count).filter(|&i| distance(i, i) <= threshold);
    let mut levels: Vec<Vec<Vec<usize>>> = vec![points.map(|i| vec![i]).collect()];
    for _ in 0..=dimension {
        let last = levels.last().unwrap();
        let grown = last.iter().flat_map(|simplex| {
            (simplex.last().unwrap() + 1..count)
                .filter(|&point| simplex.iter().all(|&other| distance(other, point) <= threshold))
                .map(|point| [&simplex[..], &[point]].concat())
                .collect::<Vec<_>>()
        });
        let grown: Vec<Vec<usize>> = grown.collect();
        levels.push(grown);
    }
    let value = |simplex: &Vec<usize>| {
        let pairs = simplex.iter().flat_map(|&i| simplex.iter().map(move |&j| (i, j)));
        pairs.filter(|(i, j)| i <= j).map(|(i, j)| distance(i, j)).fold(f64::NEG_INFINITY, f64::max)
    };
    let matrices = levels.windows(2).map(|two| {
        let entries = two[1].iter().enumerate().flat_map(|(column, simplex)| {
            (0..simplex.len()).map(move |i| {
                let mut face = simplex.clone();
                face.remove(i);
                (face, column, if i % 2 == 0 { 1i64 } else { -1 })
            })
        });
        let entries =
            entries.map(|(face, column, sign)| (two[0].binary_search(&face).unwrap(), column, sign));
        SparseMatrix::from_entries(two[0].len(), two[1].len(), entries).unwrap()
    });
    let complex = ChainComplex::new(matrices.collect()).unwrap();
    let values = levels.iter().map(|level| level.iter().map(value).collect()).collect();
    let filtration = Filtration::new(&complex, values).unwrap();
    let diagram = persistence(&complex, &filtration, Coefficients::Modulo(p)).unwrap().longer_than(0.0);
    let pairs = diagram.pairs().iter().filter(|pair| pair.degree() <= dimension);
    let mut found: Vec<_> =
        pairs.map(|pair| (pair.degree(), format!("{:?} {:?}", pair.birth(), pair.death()))).collect();
    found.sort();
    found
}

fn found(diagram: &RipsDiagram) -> Vec<(usize, String)> {
    let mut found: Vec<_> = diagram
        .pairs()
        .map(|pair| (pair.degree(), format!("{:?} {:?}", pair.birth(), pair.death())))
        .collect();
    found.sort();
    found
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    /// Few different distances, so that ties are ordinary; thresholds at which lists and squares are used.
    #[test]
    fn pairs_are_those_of_the_whole_complex(
        count in 0usize..9,
        numbers in prop::collection::vec(0u8..7, 36),
        threshold in prop::option::of(0u8..8),
        dimension in 0usize..4,
        p in prop::sample::select(vec![2u64, 3, 5]),
    ) {
        let number = |i: usize, j: usize| match i.cmp(&j) {
            std::cmp::Ordering::Equal => 0.0,
            _ => f64::from(numbers[i.max(j) * (i.max(j) - 1) / 2 + i.min(j)]) / 2.0,
        };
        let lower = (0..count).flat_map(|i| (0..i).map(move |j| number(i, j))).collect();
        let all = Distances::from_lower_triangle(count, lower).unwrap();
        let filtration = RipsFiltration::new(&all, threshold.map(f64::from)).unwrap();
        let diagram = filtration.persistence(dimension, Coefficients::Modulo(p)).unwrap();
        let expected = by_the_whole_complex(count, number, filtration.threshold(), dimension, p);
        prop_assert_eq!(&found(&diagram), &expected);
        // Up to its last distance, a list of some distances is the same.
        let near = (0..count).flat_map(|i| (0..i).map(move |j| (j, i, number(i, j))));
        let some = near.filter(|&(_, _, distance)| distance <= filtration.threshold());
        let some = Distances::from_list(count, some).unwrap();
        let other = RipsFiltration::new(&some, Some(filtration.threshold())).unwrap();
        prop_assert_eq!(&other.persistence(dimension, Coefficients::Modulo(p)).unwrap(), &diagram);
        for pair in diagram.pairs() {
            let diameter = |simplex: &[coface_algebra::VertexId]| {
                let ends = simplex.iter().flat_map(|i| simplex.iter().map(move |j| (i.index(), j.index())));
                ends.filter(|(i, j)| i < j).map(|(i, j)| number(i, j)).fold(0.0, f64::max)
            };
            prop_assert_eq!(diameter(pair.birth_simplex()), pair.birth());
            prop_assert_eq!(pair.death_simplex().map(diameter), pair.death());
            prop_assert_eq!(pair.birth_simplex().len(), pair.degree() + 1);
        }
    }

    /// Flag complexes of graphs whose vertices have values too, and of which some edges are missing.
    #[test]
    fn pairs_of_graphs_are_those_of_the_whole_complex(
        births in prop::collection::vec(-2i8..3, 0..9),
        numbers in prop::collection::vec(-3i8..6, 36),
        threshold in prop::option::of(-3i8..6),
        dimension in 0usize..4,
        p in prop::sample::select(vec![2u64, 3]),
    ) {
        let count = births.len();
        let value = |i: usize, j: usize| -> f64 {
            let number = if i == j { -3 } else { numbers[i.max(j) * (i.max(j) - 1) / 2 + i.min(j)] };
            // No edge.
            if number == 5 { f64::INFINITY } else { number.max(births[i]).max(births[j]).into() }
        };
        let edges = (0..count).flat_map(|i| (0..i).map(move |j| (j, i, value(i, j))));
        let edges = edges.filter(|edge| edge.2.is_finite());
        let graph = WeightedGraph::new(births.iter().map(|&birth| birth.into()).collect(), edges).unwrap();
        let filtration = RipsFiltration::of_graph(&graph, threshold.map(f64::from)).unwrap();
        let diagram = filtration.persistence(dimension, Coefficients::Modulo(p)).unwrap();
        let expected = by_the_whole_complex(count, value, threshold.map_or(1e9, f64::from), dimension, p);
        prop_assert_eq!(&found(&diagram), &expected);
        prop_assert!(filtration.size(dimension, f64::INFINITY).unwrap().bytes() >= 0.0);
    }

    /// Past the enclosing radius nothing happens.
    #[test]
    fn the_enclosing_radius_is_enough(count in 1usize..9, numbers in prop::collection::vec(1u8..40, 28)) {
        let all = Distances::from_lower_triangle(count, numbers[..count * (count - 1) / 2].iter().map(|&x| x.into()).collect()).unwrap();
        let short = RipsFiltration::new(&all, None).unwrap().persistence(2, Coefficients::Modulo(2)).unwrap();
        let long = RipsFiltration::new(&all, Some(100.0)).unwrap().persistence(2, Coefficients::Modulo(2)).unwrap();
        prop_assert_eq!(found(&short), found(&long));
        prop_assert_eq!(short.betti_numbers(), [1, 0, 0]);
    }
}

/// Points on a circle: one loop, born at the length of a side, over any field.
#[test]
fn a_circle_has_a_loop_with_many_points() {
    let count = 60;
    let chord = |i: usize, j: usize| 2.0 * (std::f64::consts::PI * (i - j) as f64 / count as f64).sin();
    let lower = (0..count).flat_map(|i| (0..i).map(move |j| chord(i, j))).collect();
    let filtration =
        RipsFiltration::new(&Distances::from_lower_triangle(count, lower).unwrap(), None).unwrap();
    for p in [2, 7] {
        let diagram = filtration.persistence(1, Coefficients::Modulo(p)).unwrap();
        let loops = diagram.pairs_of_degree(1);
        assert_eq!(loops.len(), 1);
        assert!((loops[0].birth() - chord(1, 0)).abs() < 1e-12);
        assert!((loops[0].death().unwrap() - 3f64.sqrt()).abs() < 1e-12);
    }
}

#[test]
fn wrong_requests_are_refused() {
    let kind = |error: coface_algebra::Error| error.kind();
    assert_eq!(
        Distances::from_list(3, [(0, 1, 1.0), (1, 0, 2.0)]).map_err(kind),
        Err(ErrorKind::InvalidInput)
    );
    assert_eq!(Distances::from_list(3, [(1, 1, 2.0)]).map_err(kind), Err(ErrorKind::InvalidInput));
    assert_eq!(Distances::from_lower_triangle(2, vec![f64::NAN]).map_err(kind), Err(ErrorKind::InvalidInput));
    for (births, edges) in [
        (vec![0.0, f64::NAN], vec![]),
        (vec![0.0, 1.0], vec![(0, 1, 0.5)]),
        (vec![0.0, 0.0], vec![(0, 2, 1.0)]),
        (vec![0.0, 0.0], vec![(1, 1, 1.0)]),
        (vec![0.0, 0.0], vec![(0, 1, f64::INFINITY)]),
        (vec![0.0, 0.0], vec![(0, 1, 1.0), (1, 0, 2.0)]),
    ] {
        assert_eq!(WeightedGraph::new(births, edges).map_err(kind), Err(ErrorKind::InvalidInput));
    }
    let many = Distances::from_list(1 << 20, []).unwrap();
    let filtration = RipsFiltration::new(&many, None).unwrap();
    assert_eq!(filtration.persistence(9, Coefficients::Modulo(2)).map_err(kind), Err(ErrorKind::TooLarge));
    assert_eq!(
        filtration.persistence(usize::MAX, Coefficients::Modulo(2)).map_err(kind),
        Err(ErrorKind::TooLarge)
    );
    assert_eq!(filtration.persistence(1, Coefficients::Integers).map_err(kind), Err(ErrorKind::Coefficient));
    assert_eq!(filtration.persistence(1, Coefficients::Modulo(2)).unwrap().betti_numbers(), [1 << 20, 0]);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    /// On the stored simplices the same classes are born and die, and have cycles that prove it; the cocycle of one component is constant.
    #[test]
    fn cycles_are_those_of_the_diagram(
        numbers in prop::collection::vec(0u8..12, 45),
        births in prop_oneof![Just(vec![0u8; 10]), prop::collection::vec(0u8..6, 10)],
        threshold in prop_oneof![Just(None), (0u8..12).prop_map(Some)],
        dimension in 0usize..3,
        p in prop_oneof![Just(2u32), Just(3), Just(5)],
    ) {
        let value = |i: usize, j: usize| f64::from(numbers[i * (i - 1) / 2 + j].max(births[i]).max(births[j]));
        let edges = (0..10).flat_map(|i| (0..i).map(move |j| (i, j))).map(|(i, j)| (i, j, value(i, j)));
        let graph = WeightedGraph::new(births.iter().map(|&birth| birth.into()).collect(), edges).unwrap();
        let filtration = RipsFiltration::of_graph(&graph, threshold.map(f64::from)).unwrap();
        let diagram = filtration.persistence(dimension, Coefficients::Modulo(p.into())).unwrap();
        let made = filtration.complex_of(&diagram).unwrap();
        let order = RipsFiltration::order_of(&made);
        let (simplices, values) = made.into_parts();
        let complex = simplices.chain_complex().unwrap();
        let stored = Filtration::in_order(&complex, values, order).unwrap();
        let whole = persistence(&complex, &stored, Coefficients::Modulo(p.into())).unwrap().up_to_degree(dimension);
        let cycles = persistent_cycles(&complex, &stored, &whole, 0.0).unwrap();
        // The same pairs of simplices in the same order, also where values are equal.
        let points = |degree: usize, cell: CellId| simplices.numbers(degree, cell.index()).to_vec();
        let of_cycles: Vec<_> = cycles
            .iter()
            .map(|one| {
                let pair = one.pair();
                let death = pair.death_cell().map(|cell| points(pair.degree() + 1, cell));
                (pair.birth(), pair.death(), points(pair.degree(), pair.birth_cell()), death)
            })
            .collect();
        let numbers = |simplex: &[VertexId]| simplex.iter().map(|point| point.index() as u32).collect::<Vec<_>>();
        let of_pairs: Vec<_> = diagram
            .pairs()
            .map(|pair| {
                let death = pair.death_simplex().map(numbers);
                (pair.birth(), pair.death(), numbers(pair.birth_simplex()), death)
            })
            .collect();
        prop_assert_eq!(of_cycles, of_pairs);
        let mut classes: Vec<_> = cycles
            .iter()
            .map(|one| (one.pair().degree(), format!("{:?} {:?}", one.pair().birth(), one.pair().death())))
            .collect();
        classes.sort();
        prop_assert_eq!(classes, self::found(&diagram));
        for one in &cycles {
            super::super::cycles_tests::assert_proved(&complex, &stored, p, one);
        }
        if diagram.betti_numbers().iter().sum::<usize>() == 1 {
            let staying = cycles.iter().find(|one| one.pair().is_essential()).unwrap();
            let there = births.iter().filter(|&&birth| f64::from(birth) <= filtration.threshold()).count();
            prop_assert_eq!(staying.cocycle().terms().len(), there);
        }
    }
}
