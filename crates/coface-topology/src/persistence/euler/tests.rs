//! Euler characteristic curves against Betti numbers, and against counting.

use crate::homology::Coefficients;
use crate::persistence::{
    EulerCurve, EulerTransform, Filtration, ImageConstruction, ImageFiltration, even_directions, persistence,
};
use coface_algebra::chains::ChainComplex;
use coface_complexes::simplicial::FrozenComplex;
use proptest::prelude::*;

/// The alternating sum of the numbers of classes that live, after each value.
fn by_classes(
    pairs: impl Iterator<Item = (usize, f64, Option<f64>)> + Clone,
    value: f64,
    falling: bool,
) -> i64 {
    let has_come = |x: f64| if falling { x >= value } else { x <= value };
    let living = pairs.filter(|&(_, birth, death)| has_come(birth) && !death.is_some_and(has_come));
    living.map(|(degree, ..)| if degree % 2 == 0 { 1 } else { -1 }).sum()
}

fn complex_of(facets: &[Vec<u32>]) -> (FrozenComplex, ChainComplex) {
    let facets = coface_algebra::RaggedArray::from_lists(facets);
    let complex = FrozenComplex::from_facets(&facets).unwrap();
    let chains = complex.chain_complex().unwrap();
    (complex, chains)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(128))]

    #[test]
    fn image_curves_are_alternating_sums_of_betti_numbers(
        (shape, numbers, periodic) in prop::collection::vec(1..5_usize, 1..=4).prop_flat_map(|shape| {
            let count = shape.iter().product::<usize>();
            let number = prop_oneof![6 => (-3..4_i32).prop_map(f64::from), 1 => Just(f64::NAN)];
            let axes = shape.len();
            (Just(shape), prop::collection::vec(number, count), prop::collection::vec(any::<bool>(), axes))
        }),
        is_v in any::<bool>(),
        is_superlevel in any::<bool>(),
    ) {
        let periodic: Vec<bool> = shape.iter().zip(periodic).map(|(&length, wanted)| wanted && length > 2).collect();
        let construction = if is_v { ImageConstruction::Vertices } else { ImageConstruction::TopCells };
        let image = ImageFiltration::new(&shape, numbers.iter().copied()).unwrap();
        let image = image.construction(construction).superlevel(is_superlevel).periodic(&periodic).unwrap();
        let diagram = image.persistence(Coefficients::Modulo(2)).unwrap();
        let curve = image.euler_curve().unwrap();
        let pairs = diagram.pairs().iter().map(|pair| (pair.degree(), pair.birth(), pair.death()));
        for value in -8..8 {
            let value = f64::from(value) / 2.0;
            prop_assert_eq!(curve.at(value), by_classes(pairs.clone(), value, is_superlevel), "at {}", value);
        }
    }

    #[test]
    fn transforms_are_curves_of_heights(
        facets in prop::collection::vec(prop::collection::btree_set(0..8_u32, 1..5), 1..8),
        positions in prop::collection::vec((-4..5_i32).prop_map(f64::from), 24),
        direction in prop::collection::vec(-2..3_i32, 3),
    ) {
        prop_assume!(direction.iter().any(|&x| x != 0));
        let facets: Vec<Vec<u32>> = facets.into_iter().map(|set| set.into_iter().collect()).collect();
        let (complex, chains) = complex_of(&facets);
        let vertices: Vec<usize> = (0..chains.cell_count(0)).map(|vertex| complex.numbers(0, vertex)[0] as usize).collect();
        let flat: Vec<f64> = vertices.iter().flat_map(|&vertex| positions[3 * vertex..3 * vertex + 3].to_vec()).collect();
        let transform = EulerTransform::new(&chains, &flat, 3).unwrap();
        let direction: Vec<f64> = direction.into_iter().map(f64::from).collect();
        let curve = transform.curve(&direction).unwrap();
        // Counted: whole heights, of which those of the transform are a multiple.
        let length = direction.iter().map(|x| x * x).sum::<f64>().sqrt();
        let height = |vertex: usize| (0..3).map(|axis| positions[3 * vertex + axis] * direction[axis]).sum::<f64>();
        let heights: Vec<f64> = vertices.iter().map(|&vertex| height(vertex)).collect();
        let filtration = Filtration::lower_star(&chains, &heights).unwrap();
        let exact = EulerCurve::of_filtration(&filtration);
        let diagram = persistence(&chains, &filtration, Coefficients::Modulo(2)).unwrap();
        let pairs = diagram.pairs().iter().map(|pair| (pair.degree(), pair.birth(), pair.death()));
        for value in -33..33 {
            let value = f64::from(value) + 0.5;
            prop_assert_eq!(exact.at(value), by_classes(pairs.clone(), value, false));
            prop_assert_eq!(curve.at(value / length), exact.at(value));
        }
        // The integral, by small steps.
        let range = [-5.0, 7.0];
        let smooth = curve.smooth(range, &[-5.0, -1.0, 0.3, 7.0]);
        let steps = 24_000;
        let step = |place: usize| range[0] + (place as f64 + 0.5) * (range[1] - range[0]) / f64::from(steps);
        let width = (range[1] - range[0]) / f64::from(steps);
        let mean = (0..steps as usize).map(|place| curve.at(step(place)) as f64).sum::<f64>() / f64::from(steps);
        for (value, smooth) in [-5.0, -1.0, 0.3, 7.0].into_iter().zip(smooth) {
            let below = (0..steps as usize).map(step).take_while(|&at| at < value);
            let integral: f64 = below.map(|at| (curve.at(at) as f64 - mean) * width).sum();
            prop_assert!((integral - smooth).abs() < 0.1, "{integral} {smooth}");
        }
    }
}

#[test]
fn directions_are_spread_evenly() {
    let directions = even_directions(3, 500).unwrap();
    for axis in 0..3 {
        let mean = directions.iter().map(|direction| direction[axis]).sum::<f64>() / 500.0;
        let square = directions.iter().map(|direction| direction[axis].powi(2)).sum::<f64>() / 500.0;
        assert!(mean.abs() < 0.01 && (square - 1.0 / 3.0).abs() < 0.01);
    }
}

#[test]
fn faults_are_told() {
    let points = ChainComplex::of_points(2);
    assert!(EulerTransform::new(&points, &[0.0, f64::NAN], 1).is_err());
    assert!(EulerTransform::new(&points, &[0.0], 1).is_err());
    let transform = EulerTransform::new(&points, &[0.0, 1.0], 1).unwrap();
    assert!(transform.curve(&[0.0]).is_err());
    assert!(transform.curve(&[1.0, 0.0]).is_err());
    assert_eq!(transform.curve(&[1e-300]).unwrap().steps(), [(0.0, 1), (1.0, 2)]);
    assert_eq!(transform.curve(&[1.0]).unwrap().smooth([0.0, 0.0], &[0.0]), [0.0]);
}
