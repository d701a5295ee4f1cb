use super::{Barcode, PersistenceSurface, euler_characteristic_curve};
use crate::{Coefficients, Filtration, persistence};
use coface_complexes::simplicial::SimplicialComplex;
use proptest::prelude::*;

const NEVER: f64 = f64::INFINITY;

fn barcode(intervals: &[[f64; 2]]) -> Barcode {
    Barcode::new(intervals.to_vec()).unwrap()
}

fn length(a: [f64; 2], b: [f64; 2], p: f64) -> f64 {
    let (x, y) = ((a[0] - b[0]).abs(), (a[1] - b[1]).abs());
    if p == NEVER { x.max(y) } else { (x.powf(p) + y.powf(p)).powf(1.0 / p) }
}

fn to_diagonal(a: [f64; 2], p: f64) -> f64 {
    let middle = (a[0] + a[1]) / 2.0;
    length(a, [middle; 2], p)
}

/// The lengths of all matchings, one list of lengths a matching.
fn all_matchings(a: &[[f64; 2]], b: &[[f64; 2]], p: f64) -> Vec<Vec<f64>> {
    let Some((&first, rest)) = a.split_first() else {
        return vec![b.iter().map(|&point| to_diagonal(point, p)).collect()];
    };
    let with = |own: f64, b: &[[f64; 2]]| {
        all_matchings(rest, b, p).into_iter().map(move |mut lengths| {
            lengths.push(own);
            lengths
        })
    };
    let mut all: Vec<Vec<f64>> = with(to_diagonal(first, p), b).collect();
    for place in 0..b.len() {
        let mut others = b.to_vec();
        let partner = others.remove(place);
        all.extend(with(length(first, partner, p), &others));
    }
    all
}

/// The lengths of the pairs of a matching.
fn lengths_of(pairs: &[(Option<usize>, Option<usize>)], a: &[[f64; 2]], b: &[[f64; 2]], p: f64) -> Vec<f64> {
    let one = |&(i, j): &(Option<usize>, Option<usize>)| match (i, j) {
        (Some(i), Some(j)) => length(a[i], b[j], p),
        (Some(i), None) => to_diagonal(a[i], p),
        (None, Some(j)) => to_diagonal(b[j], p),
        (None, None) => panic!("a pair of the diagonal with itself"),
    };
    pairs.iter().map(one).collect()
}

/// Each place is in one pair, but for intervals of length 0 that go to the diagonal.
fn assert_each_once(pairs: &[(Option<usize>, Option<usize>)], a: &[[f64; 2]], b: &[[f64; 2]]) {
    for (side, points) in [a, b].into_iter().enumerate() {
        let place = |pair: &(Option<usize>, Option<usize>)| if side == 0 { pair.0 } else { pair.1 };
        let mut places: Vec<usize> = pairs.iter().filter_map(place).collect();
        places.sort_unstable();
        let expected: Vec<usize> = (0..points.len()).filter(|&i| points[i][0] != points[i][1]).collect();
        assert_eq!(places, expected);
    }
}

fn points(most: usize) -> impl Strategy<Value = Vec<[f64; 2]>> {
    // Small whole numbers make ties.
    let whole = (0..7i32, -6..7i32).prop_map(|(b, l)| [f64::from(b), f64::from(b + l)]);
    let real = (0.0..5.0f64, -3.0..3.0f64).prop_map(|(b, l)| [b, b + l]);
    prop_oneof![prop::collection::vec(whole, 0..=most), prop::collection::vec(real, 0..=most)]
}

proptest! {
    #[test]
    fn bottleneck_is_the_least_of_all_matchings(a in points(5), b in points(5)) {
        let found = barcode(&a).bottleneck_matching(&barcode(&b));
        let longest = |lengths: &Vec<f64>| lengths.iter().copied().fold(0.0, f64::max);
        let least = all_matchings(&a, &b, NEVER).iter().map(longest).fold(NEVER, f64::min);
        // The middle of an interval is rounded here, and coordinates reach 14.
        prop_assert!((found.distance() - least).abs() <= 1e-14, "{} {least}", found.distance());
        prop_assert!(longest(&lengths_of(found.pairs(), &a, &b, NEVER)) <= found.distance() + 1e-14);
        assert_each_once(found.pairs(), &a, &b);
    }

    #[test]
    fn wasserstein_is_the_least_of_all_matchings(
        a in points(4), b in points(5),
        order in prop_oneof![Just(1.0), Just(2.0), 1.0..4.0f64],
        p in prop_oneof![Just(1.0), Just(2.0), Just(NEVER), 1.0..4.0f64],
    ) {
        let found = barcode(&a).wasserstein_matching(&barcode(&b), order, p).unwrap();
        let total = |lengths: &Vec<f64>| {
            lengths.iter().map(|length| length.powf(order)).sum::<f64>().powf(1.0 / order)
        };
        let least = all_matchings(&a, &b, p).iter().map(total).fold(NEVER, f64::min);
        prop_assert!((found.distance() - least).abs() <= 1e-13 * least.max(1.0), "{} {least}", found.distance());
        prop_assert!((total(&lengths_of(found.pairs(), &a, &b, p)) - least).abs() <= 1e-13 * least.max(1.0));
        prop_assert!(found.lower_bound() <= found.distance());
        prop_assert!(found.lower_bound() >= least * (1.0 - 1e-12) - 1e-12);
        assert_each_once(found.pairs(), &a, &b);
    }

    /// They are metrics, and each is at most the distances of lower order.
    #[test]
    fn distances_are_metrics(a in points(40), b in points(40), c in points(40)) {
        let [x, y, z] = [barcode(&a), barcode(&b), barcode(&c)];
        let bottleneck = |a: &Barcode, b: &Barcode| a.bottleneck_matching(b).distance();
        prop_assert_eq!(bottleneck(&x, &x), 0.0);
        prop_assert_eq!(bottleneck(&x, &y), bottleneck(&y, &x));
        prop_assert!(bottleneck(&x, &z) <= (bottleneck(&x, &y) + bottleneck(&y, &z)) * (1.0 + 1e-12));
        let wasserstein = |order: f64, a: &Barcode, b: &Barcode| {
            let found = a.wasserstein_matching(b, order, NEVER).unwrap();
            assert!(order > 2.0 || found.distance() - found.lower_bound() <= 1e-9 * found.distance());
            found.distance()
        };
        prop_assert_eq!(wasserstein(2.0, &x, &x), 0.0);
        let (one, two, many) =
            (wasserstein(1.0, &x, &y), wasserstein(2.0, &x, &y), wasserstein(6.0, &x, &y));
        prop_assert!((one - wasserstein(1.0, &y, &x)).abs() <= 1e-9);
        prop_assert!(wasserstein(1.0, &x, &z) <= one + wasserstein(1.0, &y, &z) + 1e-9);
        prop_assert!(two <= one * (1.0 + 1e-12));
        let least = bottleneck(&x, &y);
        prop_assert!(least * (1.0 - 1e-9) <= many && many <= two * (1.0 + 1e-9), "{least} {many} {two}");
    }

    /// A bottleneck distance is found when points are many, and moves them no farther than they were moved.
    #[test]
    fn moved_points_are_found_again(a in points(300), moves in prop::collection::vec((-0.01..0.01f64, -0.01..0.01f64), 300)) {
        let b: Vec<[f64; 2]> = a.iter().zip(&moves).rev().map(|(a, m)| [a[0] + m.0, a[1] + m.1]).collect();
        let found = barcode(&a).bottleneck_matching(&barcode(&b));
        prop_assert!(found.distance() <= 0.01 + 1e-12);
        let longest = lengths_of(found.pairs(), &a, &b, NEVER).into_iter().fold(0.0, f64::max);
        prop_assert!((longest - found.distance()).abs() <= 1e-15);
    }

    /// Betti curves count the intervals that hold a value; landscapes are tents in order, and silhouettes lie among them.
    #[test]
    fn curves_are_what_they_say(a in points(20), values in prop::collection::vec(-3.0..9.0f64, 1..9)) {
        let barcode = barcode(&a);
        let lives = |[b, d]: [f64; 2], v: f64| if b <= d { b <= v && v < d } else { d < v && v <= b };
        let counts: Vec<usize> =
            values.iter().map(|&v| a.iter().filter(|&&interval| lives(interval, v)).count()).collect();
        prop_assert_eq!(barcode.betti_curve(&values), counts);
        let landscapes = barcode.landscapes(a.len() + 1, &values);
        let silhouette = barcode.silhouette(1.0, &values);
        for (place, &value) in values.iter().enumerate() {
            let column: Vec<f64> = landscapes.iter().map(|row| row[place]).collect();
            prop_assert!(column.windows(2).all(|pair| pair[0] >= pair[1]));
            let sum: f64 = a.iter().map(|&[b, d]| (value - b.min(d)).min(b.max(d) - value).max(0.0)).sum();
            prop_assert!((column.iter().sum::<f64>() - sum).abs() < 1e-9);
            prop_assert!(silhouette[place] <= column[0] * (1.0 + 1e-12) && silhouette[place] >= 0.0);
        }
    }

    /// A wide image has the whole weight of all points.
    #[test]
    fn images_have_the_weight_of_their_points(a in points(9), width in 1..9usize, height in 1..9usize) {
        let surface = PersistenceSurface::new([-20.0, 30.0], [-20.0, 30.0], [width, height], 0.5).unwrap();
        let image = surface.image(&barcode(&a));
        let weight: f64 = a.iter().map(|[b, d]| (d - b).abs()).sum();
        prop_assert_eq!(image.len(), width * height);
        prop_assert!((image.iter().sum::<f64>() - weight).abs() < 1e-9);
    }

    /// Invariant 5 along a filtration: the curve counts the cells that have entered.
    #[test]
    fn euler_curves_count_cells(
        facets in prop::collection::vec(prop::collection::btree_set(0..7u32, 1..5), 1..9),
        heights in prop::collection::vec(-4..5i32, 7),
        is_falling: bool,
    ) {
        let complex = SimplicialComplex::from_facets(facets.iter().map(|f| f.iter().copied().collect::<Vec<_>>()))
            .unwrap();
        let chains = complex.chain_complex().unwrap();
        let values: Vec<f64> = heights.iter().take(chains.cell_count(0)).map(|&x| f64::from(x)).collect();
        let star = if is_falling { Filtration::upper_star } else { Filtration::lower_star };
        let filtration = star(&chains, &values).unwrap();
        let diagram = persistence(&chains, &filtration, Coefficients::Modulo(2)).unwrap();
        let degrees: Vec<Barcode> = (0..diagram.degree_count()).map(|degree| diagram.barcode(degree)).collect();
        let at: Vec<f64> = (-10..11).map(|x| f64::from(x) / 2.0).collect();
        let count = |&value: &f64| {
            let entered = |degree: usize| {
                let has = |&&x: &&f64| if is_falling { x >= value } else { x <= value };
                filtration.values(degree).iter().filter(has).count() as i64
            };
            (0..chains.degree_count()).map(|degree| if degree % 2 == 0 { entered(degree) } else { -entered(degree) }).sum()
        };
        let counts: Vec<i64> = at.iter().map(count).collect();
        prop_assert_eq!(euler_characteristic_curve(&degrees, &at), counts);
    }
}

#[test]
fn infinite_ends_are_matched_in_order() {
    let a = barcode(&[[3.0, NEVER], [0.0, NEVER], [1.0, 2.0], [5.0, -NEVER]]);
    let b = barcode(&[[0.5, NEVER], [3.25, NEVER], [4.0, -NEVER]]);
    let found = a.bottleneck_matching(&b);
    assert_eq!(found.distance(), 1.0);
    assert_eq!(found.pairs(), [(Some(0), Some(1)), (Some(1), Some(0)), (Some(2), None), (Some(3), Some(2))]);
    assert_eq!(a.wasserstein_matching(&b, 1.0, NEVER).unwrap().distance(), 0.25 + 0.5 + 0.5 + 1.0);
    for other in [&[[0.0, NEVER]][..], &[[0.0, NEVER], [0.0, NEVER], [0.0, NEVER]], &[]] {
        assert_eq!(a.bottleneck_matching(&barcode(other)).distance(), NEVER);
        assert_eq!(a.wasserstein_matching(&barcode(other), 2.0, 2.0).unwrap().distance(), NEVER);
    }
    assert_eq!(Barcode::default().bottleneck_matching(&Barcode::default()).distance(), 0.0);
}

#[test]
fn tiny_and_huge_numbers_neither_vanish_nor_overflow() {
    for unit in [1e-300, 1e-30, 1.0, 1e100, 1e306] {
        let a = barcode(&[[0.0, 4.0 * unit], [unit, 3.0 * unit]]);
        let b = barcode(&[[unit, 4.0 * unit]]);
        for order in [1.0, 2.0, 7.0] {
            let found = a.wasserstein_matching(&b, order, NEVER).unwrap().distance();
            let expected = unit * 2f64.powf(1.0 / order);
            assert!((found - expected).abs() <= 1e-12 * expected, "{unit} {order} {found}");
        }
        assert!((a.bottleneck_matching(&b).distance() - unit).abs() <= 1e-15 * unit);
    }
}

#[test]
fn wrong_requests_are_refused() {
    let one = barcode(&[[0.0, 1.0]]);
    for (order, p) in [(0.5, 1.0), (NEVER, 1.0), (f64::NAN, 1.0), (1.0, 0.5), (1.0, f64::NAN)] {
        assert!(one.wasserstein_matching(&one, order, p).is_err());
    }
    assert!(Barcode::new(vec![[f64::NAN, 1.0]]).is_err());
    assert!(Barcode::new(vec![[-1.7e308, 1.7e308]]).is_err());
    assert!(barcode(&[[2.0, NEVER]]).ended_at(1.0).is_err());
    assert!(barcode(&[[2.0, -NEVER]]).ended_at(3.0).is_err());
    assert_eq!(barcode(&[[2.0, -NEVER]]).ended_at(1.0).unwrap().intervals(), [[2.0, 1.0]]);
    for (births, resolution, bandwidth) in [
        ([1.0, 1.0], [2, 2], 1.0),
        ([0.0, 1.0], [0, 2], 1.0),
        ([0.0, 1.0], [2, 2], 0.0),
        ([0.0, 1.0], [1 << 20, 1 << 20], 1.0),
    ] {
        assert!(PersistenceSurface::new(births, [0.0, 1.0], resolution, bandwidth).is_err());
    }
}
