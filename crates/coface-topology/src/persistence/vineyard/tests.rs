//! Vineyards against diagrams that are computed from nothing.

use super::{Vine, vineyard};
use crate::Coefficients;
use crate::persistence::{Filtration, persistence};
use coface_algebra::chains::ChainComplex;
use coface_complexes::simplicial::SimplicialComplex;
use proptest::prelude::*;

type Class = (usize, f64, f64);

/// The points of the vines at a parameter, by lines between their own points.
fn at(vines: &[Vine], parameter: f64) -> Vec<Class> {
    let mut found = Vec::new();
    for vine in vines {
        let points = vine.points();
        let there = points.iter().rposition(|point| point.parameter() <= parameter);
        let Some(place) = there else { continue };
        let (a, b) = (points[place], points.get(place + 1));
        let (birth, death) = match b {
            _ if a.parameter() == parameter => (a.birth(), a.death()),
            Some(b) => {
                let part = (parameter - a.parameter()) / (b.parameter() - a.parameter());
                let between = |x: f64, y: f64| x * (1.0 - part) + y * part;
                (between(a.birth(), b.birth()), a.death().map(|death| between(death, b.death().unwrap())))
            }
            None => continue,
        };
        let death = death.unwrap_or(f64::INFINITY);
        if death > birth {
            found.push((vine.degree(), birth, death));
        }
    }
    found.sort_by(|a, b| a.partial_cmp(b).unwrap());
    found
}

fn from_nothing(complex: &ChainComplex, values: &[f64], p: u64) -> Vec<Class> {
    let filtration = Filtration::lower_star(complex, values).unwrap();
    let diagram = persistence(complex, &filtration, Coefficients::Modulo(p)).unwrap().longer_than(0.0);
    let class =
        |pair: &crate::PersistencePair| (pair.degree(), pair.birth(), pair.death().unwrap_or(f64::INFINITY));
    let mut found: Vec<Class> = diagram.pairs().iter().map(class).collect();
    found.sort_by(|a, b| a.partial_cmp(b).unwrap());
    found
}

fn complex_of(facets: &[std::collections::BTreeSet<u32>]) -> ChainComplex {
    let facets = facets.iter().map(|facet| facet.iter().copied().collect::<Vec<_>>());
    SimplicialComplex::from_facets(facets).unwrap().chain_complex().unwrap()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(120))]

    /// Invariant 115.
    #[test]
    fn vines_have_the_points_of_all_diagrams(
        facets in prop::collection::vec(prop::collection::btree_set(0..8u32, 1..5), 1..14),
        heights in prop::collection::vec(prop::collection::vec(-4..5i32, 8), 1..5),
        p in prop_oneof![Just(2u64), Just(3), Just(5)],
    ) {
        let complex = complex_of(&facets);
        let count = complex.cell_count(0);
        let functions: Vec<Vec<f64>> =
            heights.iter().map(|row| row.iter().take(count).map(|&x| f64::from(x)).collect()).collect();
        let vines = vineyard(&complex, &functions, Coefficients::Modulo(p)).unwrap();
        for (place, function) in functions.iter().enumerate() {
            prop_assert_eq!(at(&vines, place as f64), from_nothing(&complex, function, p), "at {}", place);
        }
        let last = (functions.len() - 1) as f64;
        for vine in &vines {
            let points = vine.points();
            prop_assert!(points.windows(2).all(|two| two[0].parameter() < two[1].parameter()));
            prop_assert!(points.iter().all(|point| point.persistence() >= 0.0));
            for (end, bound) in [(points[0], 0.0), (points[points.len() - 1], last)] {
                prop_assert!(end.parameter() == bound || end.persistence() < 1e-9, "{:?}", vine);
            }
        }
    }

    /// Between the functions too.
    #[test]
    fn vines_are_right_along_their_way(
        facets in prop::collection::vec(prop::collection::btree_set(0..8u32, 1..5), 1..14),
        heights in prop::collection::vec(prop::collection::vec(-1.0..1.0f64, 8), 2..4),
        parts in prop::collection::vec(0.01..0.99f64, 6),
    ) {
        let complex = complex_of(&facets);
        let count = complex.cell_count(0);
        let functions: Vec<Vec<f64>> = heights.iter().map(|row| row[..count].to_vec()).collect();
        let vines = vineyard(&complex, &functions, Coefficients::Modulo(2)).unwrap();
        for (place, two) in functions.windows(2).enumerate() {
            for part in &parts {
                let values: Vec<f64> = two[0].iter().zip(&two[1]).map(|(x, y)| x * (1.0 - part) + y * part).collect();
                let long = |classes: Vec<Class>| classes.into_iter().filter(|class| class.2 - class.1 > 1e-9).collect::<Vec<_>>();
                let (found, expected) =
                    (long(at(&vines, place as f64 + part)), long(from_nothing(&complex, &values, 2)));
                // Rounding may order them in another way.
                let near = |x: f64, y: f64| x == y || (x - y).abs() < 1e-9;
                let is_near = |a: &Class, b: &Class| a.0 == b.0 && near(a.1, b.1) && near(a.2, b.2);
                let mut left = expected.clone();
                for class in &found {
                    let place = left.iter().position(|other| is_near(class, other));
                    prop_assert!(place.is_some(), "{:?} {:?}", found, expected);
                    left.swap_remove(place.unwrap());
                }
                prop_assert!(left.is_empty(), "{:?} {:?}", found, expected);
            }
        }
    }
}

#[test]
fn one_function_is_a_diagram_and_none_is_refused() {
    let circle = complex_of(&[[0, 1].into(), [1, 2].into(), [0, 2].into()]);
    let vines = vineyard(&circle, &[vec![0.0, 1.0, 5.0]], Coefficients::Modulo(2)).unwrap();
    assert_eq!(at(&vines, 0.0), [(0, 0.0, f64::INFINITY), (1, 5.0, f64::INFINITY)]);
    assert!(vines.iter().all(|vine| vine.points().len() == 1));
    assert!(vineyard(&circle, &[], Coefficients::Modulo(2)).is_err());
    assert!(vineyard(&circle, &[vec![0.0]], Coefficients::Modulo(2)).is_err());
    let nothing = ChainComplex::of_points(0);
    assert!(vineyard(&nothing, &[vec![], vec![]], Coefficients::Modulo(2)).unwrap().is_empty());
}
