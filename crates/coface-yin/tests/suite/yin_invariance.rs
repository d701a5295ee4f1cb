//! Booleans of curved sets are the same after motions that are exact, in either order of operands, by either way of writing a formula,
//! and for polygons at order 2 and order 4.
#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "a failing test shows where")]

use crate::splines::{Random, case_count, mapped, smooth_set};
use coface_arrange::boolean::{BooleanFormula, InsideRule};
use coface_yin::{Combination, Curve, Order, YinSet};

const FORMULAS: [&str; 6] = ["a & b", "a | b", "a - b", "b - a", "a ^ b", "!a & !b"];

fn combine(sets: &[&YinSet], formula: &str) -> Combination {
    YinSet::combine(sets, &BooleanFormula::parse(formula, &["a", "b", "c"]).unwrap()).unwrap()
}

/// The curve with all control points on the grid of multiples of 2^-24; pieces that are segments stay segments.
fn on_grid(curve: &Curve<'_>) -> Curve<'static> {
    let scale = f64::from(1u32 << 24);
    let controls = curve.controls().iter().map(|point| point.map(|x| (x * scale).round() / scale)).collect();
    Curve::from_controls(curve.order(), controls, curve.knots().to_vec()).unwrap()
}

/// A curve with its points mapped; the other way around where the map turns the plane over.
fn moved(curve: &Curve<'_>, map: &dyn Fn([f64; 2]) -> [f64; 2], is_mirror: bool) -> Curve<'static> {
    let controls = curve.controls().iter().map(|&point| map(point)).collect();
    let found = Curve::from_controls(curve.order(), controls, curve.knots().to_vec()).unwrap();
    if is_mirror { found.reversed() } else { found }
}

/// What no motion changes: counts, depths, and areas of curves.
fn assert_alike(a: &YinSet, b: &YinSet, about: &str) {
    assert_eq!(a.is_bounded(), b.is_bounded(), "{about}");
    assert_eq!(a.curve_counts(), b.curve_counts(), "{about}");
    assert_eq!(a.betti_open().unwrap(), b.betti_open().unwrap(), "{about}");
    assert_eq!(a.betti_closed().unwrap(), b.betti_closed().unwrap(), "{about}");
    assert_eq!(a.kinks().len(), b.kinks().len(), "{about}");
    let curves = |set: &YinSet| {
        let mut all: Vec<_> = (0..set.curve_count())
            .map(|i| (set.curve(i).signed_area(), set.forest().depth(i), set.curve(i).piece_count()))
            .collect();
        all.sort_by(|x, y| x.0.total_cmp(&y.0));
        all
    };
    for (x, y) in curves(a).into_iter().zip(curves(b)) {
        assert!((x.0 - y.0).abs() <= 1e-11, "{about}: {x:?} {y:?}");
        assert_eq!((x.1, x.2), (y.1, y.2), "{about}");
    }
}

/// A map of the plane to itself.
type Motion<'a> = &'a dyn Fn([f64; 2]) -> [f64; 2];

#[test]
fn motions_and_swaps_change_nothing() {
    for seed in 0..case_count(12) {
        let mut random = Random::new(seed + (3 << 32));
        let sets = [0; 2].map(|_| mapped(&smooth_set(&mut random, 1.0), on_grid).unwrap());
        let shift = [0; 2].map(|_| (random.coordinate() * 4096.0).round());
        let motions: [(Motion<'_>, bool); 4] = [
            (&|[x, y]| [x + shift[0], y + shift[1]], false),
            (&|[x, y]| [-x, y], true),
            (&|[x, y]| [-y, x], false),
            (&|[x, y]| [y, x], true),
        ];
        let moved_sets: Vec<[YinSet; 2]> = motions
            .iter()
            .map(|(map, is_mirror)| {
                [0, 1].map(|i| mapped(&sets[i], |curve| moved(curve, map, *is_mirror)).unwrap())
            })
            .collect();
        let [a, b] = &sets;
        for formula in FORMULAS {
            let found = combine(&[a, b], formula);
            assert!(found.report().is_empty(), "{seed} {formula}");
            for (number, [p, q]) in moved_sets.iter().enumerate() {
                let other = combine(&[p, q], formula);
                assert_alike(found.set(), other.set(), &format!("seed {seed}, {formula}, motion {number}"));
            }
            // The same with the operands in the other order.
            let swapped: String = formula
                .chars()
                .map(|c| match c {
                    'a' => 'b',
                    'b' => 'a',
                    c => c,
                })
                .collect();
            let swapped = combine(&[b, a], &swapped);
            assert_alike(swapped.set(), found.set(), &format!("seed {seed}, {formula}, swapped"));
        }
    }
}

/// A set of random polygons by parity, or of rectangles on a lattice, whose sides cross in lattice points.
fn polygons(random: &mut Random, is_lattice: bool) -> YinSet {
    let rings: Vec<Vec<[f64; 2]>> = (0..1 + random.below(4))
        .map(|_| {
            if is_lattice {
                let [x, y, z, w] = [0; 4].map(|_| random.below(7) as f64);
                return vec![[x, y], [x + z + 1.0, y], [x + z + 1.0, y + w + 1.0], [x, y + w + 1.0]];
            }
            (0..3 + random.below(4)).map(|_| [0; 2].map(|_| random.coordinate())).collect()
        })
        .collect();
    let set = YinSet::from_rings(&rings, InsideRule::Odd).unwrap();
    set.normalized().unwrap().into_set()
}

#[test]
fn polygons_are_the_same_at_order_4() {
    let mut differing = 0;
    let mut case_number = 0;
    for seed in 0..case_count(60) {
        let mut random = Random::new(seed + (4 << 32));
        let flat = [0; 2].map(|_| polygons(&mut random, seed % 2 == 0));
        if flat.iter().any(YinSet::is_empty) {
            continue;
        }
        let raise = |set: &YinSet| mapped(set, |curve| curve.raised(Order::CUBIC).unwrap()).unwrap();
        let curved = [raise(&flat[0]), raise(&flat[1])];
        for formula in FORMULAS {
            case_number += 1;
            let expected = combine(&[&flat[0], &flat[1]], formula);
            let found = combine(&[&curved[0], &curved[1]], formula);
            let [p, q] = [expected.set(), found.set()];
            let about = format!("seed {seed}, {formula}");
            assert_eq!(p.is_bounded(), q.is_bounded(), "{about}");
            assert!((p.signed_area() - q.signed_area()).abs() <= 1e-11, "{about}");
            // Crossings nearer than the resolution are one at order 4 and say so.
            if found.report().is_empty() {
                assert_eq!(p.curve_counts(), q.curve_counts(), "{about}");
                assert_eq!(p.betti_open().unwrap(), q.betti_open().unwrap(), "{about}");
                assert_eq!(p.betti_closed().unwrap(), q.betti_closed().unwrap(), "{about}");
                assert_eq!(p.forest(), q.forest(), "{about}");
                assert!(
                    (p.signed_area() - q.signed_area()).abs() <= 1e-13 * p.signed_area().abs().max(1.0),
                    "{about}"
                );
            } else {
                differing += 1;
            }
        }
    }
    println!("{differing} of {case_number} with crossings below the resolution");
    assert!(differing * 50 <= case_number);
}

#[test]
fn formulas_say_the_same_in_other_words() {
    for seed in 0..case_count(12) {
        let mut random = Random::new(seed + (5 << 32));
        let sets = [0; 3].map(|_| smooth_set(&mut random, 1.0));
        let [a, b, c] = &sets;
        let area = |formula: &str| combine(&[a, b, c], formula).set().signed_area();
        // Inclusion and exclusion.
        let single = area("a") + area("b") + area("c");
        let pairs = area("a & b") + area("b & c") + area("a & c");
        let all = single - pairs + area("a & b & c");
        assert!((area("a | b | c") - all).abs() <= 1e-12 * single, "{seed}");
        // De Morgan, one operation after the other.
        let (not_a, not_b) = (a.complement().unwrap(), b.complement().unwrap());
        let [join, meet] = [a.join(b).unwrap(), a.meet(b).unwrap()].map(|set| set.complement().unwrap());
        assert_alike(&join, &not_a.meet(&not_b).unwrap(), &format!("seed {seed}, complement of join"));
        assert_alike(&meet, &not_a.join(&not_b).unwrap(), &format!("seed {seed}, complement of meet"));
        assert!(join.has_points_of(&not_a.meet(&not_b).unwrap()).unwrap(), "{seed}");
        // Distribution.
        let left = a.meet(&b.join(c).unwrap()).unwrap();
        let right = a.meet(b).unwrap().join(&a.meet(c).unwrap()).unwrap();
        assert!((left.signed_area() - right.signed_area()).abs() <= 1e-11, "{seed}");
        let between = left.symmetric_difference(&right).unwrap();
        assert!(between.signed_area().abs() <= 1e-10, "{seed} {}", between.signed_area());
    }
}
