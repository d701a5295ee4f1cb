//! Diagrams of alpha complexes against those of Čech complexes, which the nerve theorem says are the same.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use coface::algebra::{RaggedArray, VertexId};
use coface::complexes::alpha::{AlphaComplex, PeriodicAlphaComplex, PeriodicBox};
use coface::complexes::filtered::{Distances, FilteredComplex, enclosing_ball_radius};
use coface::complexes::simplicial::FrozenComplex;
use coface::geometry::predicates::{
    WeightedPoint, orientation, smallest_sphere, smallest_sphere_side, spatial_orientation, sphere_side,
};
use coface::topology::{Filtration, homology, persistence};
use coface::{ChainComplex, Coefficients, Positions};
use proptest::prelude::*;

/// Whether points are affinely independent.
fn are_independent(points: &[WeightedPoint]) -> bool {
    let at = |i: usize| points[i].point();
    let is_turn = |axis: usize| {
        let [a, b, c] = [0, 1, 2].map(|i| [at(i)[axis], at(i)[(axis + 1) % 3]]);
        orientation(a, b, c).is_ne()
    };
    match points.len() {
        1 => true,
        2 => at(0) != at(1),
        3 => (0..3).any(is_turn),
        _ => spatial_orientation(at(0), at(1), at(2), at(3)).is_ne(),
    }
}

/// Whether a point is outside of the smallest sphere of others.
fn is_outside(through: &[WeightedPoint], q: WeightedPoint) -> bool {
    match *through {
        [a, b, c, d] => {
            let run = spatial_orientation(a.point(), b.point(), c.point(), d.point());
            sphere_side(if run.is_lt() { [b, a, c, d] } else { [a, b, c, d] }, q).is_lt()
        }
        _ => smallest_sphere_side(through, q).is_lt(),
    }
}

/// The squared radius at which the balls of these points have a common point: that of the smallest of the spheres of some of them that no other one is
/// outside of.
fn ball(points: &[WeightedPoint]) -> f64 {
    let mut least = f64::INFINITY;
    for chosen in 1u32..1 << points.len() {
        let some: Vec<WeightedPoint> =
            (0..points.len()).filter(|i| chosen >> i & 1 == 1).map(|i| points[i]).collect();
        let is_supported = some.len() <= 4
            && are_independent(&some)
            && !(0..points.len()).any(|i| chosen >> i & 1 == 0 && is_outside(&some, points[i]));
        if is_supported {
            least = least.min(smallest_sphere(&some));
        }
    }
    least
}

/// Births and deaths that differ, sorted.
fn pairs(chains: &ChainComplex, values: Vec<Vec<f64>>) -> Vec<(usize, f64, Option<f64>)> {
    let filtration = Filtration::new(chains, values).unwrap();
    let found = persistence(chains, &filtration, Coefficients::Modulo(3)).unwrap().longer_than(0.0);
    let mut pairs: Vec<_> =
        found.pairs().iter().map(|pair| (pair.degree(), pair.birth(), pair.death())).collect();
    pairs.sort_by(|a, b| a.partial_cmp(b).unwrap());
    pairs
}

/// Births and deaths that differ, below a degree.
fn diagram(complex: &FrozenComplex, values: Vec<Vec<f64>>, end: usize) -> Vec<(usize, f64, Option<f64>)> {
    let mut pairs = pairs(&complex.chain_complex().unwrap(), values);
    pairs.retain(|pair| pair.0 < end);
    pairs
}

fn of_alpha(points: &Positions, weights: Option<&[f64]>) -> Vec<(usize, f64, Option<f64>)> {
    let (complex, values) = AlphaComplex::new(points, weights).unwrap().into_filtered().into_parts();
    diagram(&complex, values, points.dimension())
}

/// All sets of points up to one more than their dimension.
fn of_cech(points: &Positions, weights: Option<&[f64]>) -> Vec<(usize, f64, Option<f64>)> {
    let (dimension, count) = (points.dimension(), points.len());
    let all: Vec<WeightedPoint> = (0..count)
        .map(|id| {
            let point = points.point(VertexId::new(id));
            let point = [0, 1, 2].map(|axis| point.get(axis).copied().unwrap_or(0.0));
            WeightedPoint::new(point, weights.map_or(0.0, |weights| weights[id]))
        })
        .collect();
    let mut facets = RaggedArray::new();
    for chosen in 1u32..1 << count {
        let some: Vec<u32> = (0..count as u32).filter(|i| chosen >> i & 1 == 1).collect();
        if some.len() <= dimension + 1 {
            facets.push(&some);
        }
    }
    let complex = FrozenComplex::from_facets(&facets).unwrap();
    let value = |degree: usize, i: usize| {
        let ids = complex.numbers(degree, i);
        ball(&ids.iter().map(|&id| all[id as usize]).collect::<Vec<_>>())
    };
    let counts = complex.f_vector();
    let values = counts.iter().enumerate().map(|(k, &n)| (0..n).map(|i| value(k, i)).collect()).collect();
    diagram(&complex, values, dimension)
}

/// Points of a small grid, where many are on one circle, or anywhere; with weights or without.
fn points() -> impl Strategy<Value = (Positions, Option<Vec<f64>>)> {
    let coordinate = prop_oneof![
        2 => (0i32..3).prop_map(f64::from),
        1 => (0i32..1000).prop_map(|x| f64::from(x) * 0.003),
    ];
    let weight = prop_oneof![Just(0.0), (-2i32..4).prop_map(f64::from)];
    let weights = prop::option::of(prop::collection::vec(weight, 8));
    (1usize..4, prop::collection::vec(coordinate, 24), 1usize..8, weights).prop_map(
        |(dimension, mut flat, count, weights)| {
            flat.truncate(dimension * count);
            let weights = weights.map(|mut weights| {
                weights.truncate(count);
                weights
            });
            (Positions::from_flat(dimension, flat).unwrap(), weights)
        },
    )
}

/// The pairs of the Čech complex of the library that live longer than rounding.
fn of_radii(points: &Positions) -> Vec<(usize, f64, Option<f64>)> {
    let complex = FilteredComplex::cech(points, enclosing_ball_radius(points), points.dimension()).unwrap();
    let (complex, values) = complex.into_parts();
    complex.check().unwrap();
    let mut pairs = diagram(&complex, values, points.dimension());
    pairs.retain(|pair| pair.2.is_none_or(|death| death - pair.1 > 1e-9));
    pairs
}

proptest! {
    /// Radii of smallest balls are those of exact spheres, but for rounding.
    #[test]
    fn cech_complexes_of_the_library_have_the_diagram_too((points, _) in points()) {
        let radius = |pair: &(usize, f64, Option<f64>)| (pair.0, pair.1.sqrt(), pair.2.map(f64::sqrt));
        let mut exact: Vec<_> = of_alpha(&points, None).iter().map(radius).collect();
        exact.retain(|pair| pair.2.is_none_or(|death| death - pair.1 > 1e-9));
        let mut found = of_radii(&points);
        // Equal points are one in the alpha complex, and die at once here.
        found.retain(|pair| pair.2 != Some(pair.1));
        prop_assert_eq!(found.len(), exact.len());
        for (one, other) in found.iter().zip(&exact) {
            prop_assert_eq!((one.0, one.2.is_some()), (other.0, other.2.is_some()));
            prop_assert!((one.1 - other.1).abs() < 1e-9);
            prop_assert!((one.2.unwrap_or(0.0) - other.2.unwrap_or(0.0)).abs() < 1e-9);
        }
    }

    /// Invariant 121.
    #[test]
    fn alpha_and_cech_complexes_have_one_diagram((points, weights) in points()) {
        let weights = weights.as_deref();
        prop_assert_eq!(of_alpha(&points, weights), of_cech(&points, weights));
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]
    /// Points near each other in a wide box see none of their copies for a while; in the end there is the torus.
    #[test]
    fn a_cluster_that_repeats_is_a_cluster_first(
        (dimension, flat) in (1usize..4).prop_flat_map(|dimension| {
            prop::collection::vec(0i32..64, dimension..=dimension * 12).prop_map(move |flat| {
                let rows = flat.len() / dimension * dimension;
                (dimension, flat[..rows].iter().map(|&x| f64::from(x) / 16.0).collect::<Vec<f64>>())
            })
        }),
    ) {
        let points = Positions::from_flat(dimension, flat).unwrap();
        // Within this value balls around points of the cluster, of diameter 7 at most, stay away from copies.
        let (wide, within) = (64.0, 28.0 * 28.0);
        let torus = PeriodicAlphaComplex::new(&points, &PeriodicBox::new(&vec![wide; dimension]).unwrap(), None).unwrap();
        let degrees = 0..torus.complex().f_vector().len();
        let values = degrees.map(|degree| torus.values(degree).to_vec()).collect();
        let mut repeated = pairs(&torus.complex().chain_complex().unwrap(), values);
        let ever: Vec<usize> = repeated.iter().filter(|pair| pair.2.is_none()).map(|pair| pair.0).collect();
        let binomial = [&[0, 1][..], &[0, 1, 1, 2], &[0, 1, 1, 1, 2, 2, 2, 3]];
        prop_assert_eq!(&ever[..], binomial[dimension - 1]);
        repeated.retain(|pair| pair.1 < within && pair.2.is_some_and(|death| death < within));
        let (complex, values) = AlphaComplex::new(&points, None).unwrap().into_filtered().into_parts();
        let mut alone = pairs(&complex.chain_complex().unwrap(), values);
        alone.retain(|pair| pair.2.is_some_and(|death| death < within));
        prop_assert_eq!(repeated, alone);
    }

    /// Within the connecting distance the graph is connected, and within less it is not.
    #[test]
    fn the_connecting_distance_connects(distances in prop::collection::vec(1u32..20, 45), keep in 1usize..45) {
        let all: Vec<f64> = distances.iter().map(|&distance| f64::from(distance)).collect();
        let dense = Distances::from_lower_triangle(10, all.clone()).unwrap();
        let places = (0..10usize).flat_map(|i| (0..i).map(move |j| (i, j)));
        let known = places.zip(all).map(|((i, j), distance)| (i, j, distance)).take(keep);
        let sparse = Distances::from_list(10, known).unwrap();
        for distances in [dense, sparse] {
            let component_count = |threshold: f64| {
                let graph = distances.graph_within(threshold);
                let lists = graph.edges().iter().map(|&(i, j, _)| vec![i, j]).chain((0..10).map(|i| vec![i]));
                let complex = FrozenComplex::from_facets(&RaggedArray::from_lists(lists)).unwrap();
                homology(&complex.chain_complex().unwrap()).betti_numbers()[0]
            };
            match distances.connecting_distance() {
                Some(distance) => {
                    prop_assert_eq!(component_count(distance), 1);
                    prop_assert!(component_count(distance - 0.5) > 1);
                }
                None => prop_assert!(component_count(1e9) > 1),
            }
        }
    }
}
