//! Booleans of sets with curved boundaries: against closed forms, against polygons, and against each other.
#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "a failing test shows where")]

use coface::arrangement::boolean::BooleanFormula;
use coface::yin::{Curve, Order, YinSet};
use std::f64::consts::{PI, TAU};

/// A cubic curve near a circle, counterclockwise, with knots at equal angles from `turn` on.
fn circle(center: [f64; 2], radius: f64, count: usize, turn: f64) -> Curve<'static> {
    let step = TAU / count as f64;
    let handle = 4.0 / 3.0 * (step / 4.0).tan();
    let mut controls = Vec::new();
    for i in 0..count {
        let at = |i: usize| (turn + step * (i % count) as f64).sin_cos();
        let ((s, c), (t, d)) = (at(i), at(i + 1));
        let place = |x: f64, y: f64| [center[0] + radius * x, center[1] + radius * y];
        controls.push(place(c, s));
        controls.push(place(c - handle * s, s + handle * c));
        controls.push(place(d + handle * t, t - handle * d));
    }
    controls.push(controls[0]);
    let knots = (0..=count).map(|i| i as f64 * step * radius).collect();
    Curve::from_controls(Order::CUBIC, controls, knots).unwrap()
}

fn disk(center: [f64; 2], radius: f64, count: usize) -> YinSet {
    YinSet::new(&[circle(center, radius, count, 0.3)]).unwrap()
}

/// The same curve in the other direction.
fn reversed(curve: &Curve<'_>) -> Curve<'static> {
    let controls: Vec<_> = curve.controls().iter().rev().copied().collect();
    let end = curve.knots()[curve.piece_count()];
    let knots = curve.knots().iter().rev().map(|knot| end - knot).collect();
    Curve::from_controls(curve.order(), controls, knots).unwrap()
}

fn polygon(points: &[[f64; 2]], order: Order) -> Curve<'static> {
    let closed: Vec<_> = points.iter().chain(&points[..1]).copied().collect();
    Curve::polyline(&closed).unwrap().raised(order).unwrap()
}

fn square(x: f64, y: f64, side: f64, order: Order) -> YinSet {
    let points = [[x, y], [x + side, y], [x + side, y + side], [x, y + side]];
    YinSet::new(&[polygon(&points, order)]).unwrap()
}

/// Meet and join, after the checks that hold for any two sets.
fn meet_and_join(a: &YinSet, b: &YinSet) -> [YinSet; 2] {
    let (meet, join) = (a.meet(b).unwrap(), a.join(b).unwrap());
    for set in [&meet, &join] {
        assert_eq!(set.validate().unwrap(), None);
        assert_eq!(set, &set.canonical());
    }
    let (other_meet, other_join) = (b.meet(a).unwrap(), b.join(a).unwrap());
    assert_eq!(meet.curve_counts(), other_meet.curve_counts());
    assert_eq!(join.curve_counts(), other_join.curve_counts());
    if let (Some(a), Some(b)) = (a.area(), b.area()) {
        let (meet, join) = (meet.area().unwrap(), join.area().unwrap());
        let residual = (a + b - meet - join).abs() / (a + b);
        assert!(residual <= 1e-12, "residual {residual:e}");
        assert!((other_meet.area().unwrap() - meet).abs() <= 1e-12 * (a + b));
        assert!((other_join.area().unwrap() - join).abs() <= 1e-12 * (a + b));
    }
    [meet, join]
}

#[test]
fn disks_that_cross_have_a_lens() {
    for distance in [0.1, 0.5, 1.0, 1.5, 1.9, 1.999] {
        let lens = 2.0 * (distance / 2.0f64).acos() - distance / 2.0 * (4.0 - distance * distance).sqrt();
        let (a, b) = (disk([0.0, 0.0], 1.0, 64), disk([distance, 0.0], 1.0, 64));
        let [meet, join] = meet_and_join(&a, &b);
        assert!((meet.area().unwrap() - lens).abs() < 1e-9, "{distance}");
        assert!((join.area().unwrap() - (TAU - lens)).abs() < 1e-9);
        assert_eq!((meet.curve_counts(), join.curve_counts()), ([1, 0], [1, 0]));
        assert_eq!(meet.kinks().len(), 2);
        let moon = a.difference(&b).unwrap();
        assert!((moon.area().unwrap() - (PI - lens)).abs() < 1e-9);
        let both = a.symmetric_difference(&b).unwrap();
        assert_eq!((both.curve_counts(), both.kinks().len()), ([2, 0], 4));
        assert_eq!(both.validate().unwrap(), None);
        assert_eq!((both.betti_open().unwrap(), both.betti_closed().unwrap()), ([2, 0], [1, 1]));
    }
}

#[test]
fn pieces_of_results_are_parts_of_their_sources() {
    let (a, b) = (disk([0.0, 0.0], 1.0, 16), disk([1.0, 0.25], 1.0, 16));
    let sets = [&a, &b];
    for formula in ["a & b", "a | b", "a - b", "a ^ b", "!a & b"] {
        let found = YinSet::combine(&sets, &BooleanFormula::parse(formula, &[]).unwrap()).unwrap();
        assert!(found.report().is_empty());
        let curves = (0..found.set().curve_count()).map(|curve| found.set().curve(curve));
        let pieces: Vec<Vec<[f64; 2]>> = curves
            .flat_map(|curve| (0..curve.piece_count()).map(|i| curve.piece(i).to_vec()).collect::<Vec<_>>())
            .collect();
        assert_eq!(pieces.len(), found.sources().len());
        let mut whole_count = 0;
        for (piece, source) in pieces.iter().zip(found.sources()) {
            let curve = sets[source.operand as usize].curve(source.curve as usize);
            let mut given = curve.piece(source.piece as usize).to_vec();
            if source.range[0] > source.range[1] {
                given.reverse();
            }
            if [0.0, 1.0].iter().all(|end| source.range.contains(end)) {
                whole_count += 1;
                assert_eq!(piece, &given);
            } else {
                // The end of the part is on the source.
                let value = |controls: &[[f64; 2]], t: f64| {
                    let mut points = controls.to_vec();
                    while points.len() > 1 {
                        points = points
                            .windows(2)
                            .map(|pair| [0, 1].map(|k| pair[0][k] + t * (pair[1][k] - pair[0][k])))
                            .collect();
                    }
                    points[0]
                };
                let t = 0.5 * (source.range[0] + source.range[1]);
                let (p, q) = (value(piece, 0.5), value(curve.piece(source.piece as usize), t));
                assert!((0..2).all(|k| (p[k] - q[k]).abs() < 1e-14), "{p:?} {q:?}");
            }
        }
        assert!(whole_count >= 8, "{formula} {whole_count}");
    }
}

#[test]
fn disks_that_touch() {
    for turn in [0.0, 0.3, 1.0] {
        let disk = |x: f64, y: f64, radius: f64| YinSet::new(&[circle([x, y], radius, 32, turn)]).unwrap();
        // From the outside in a knot or not.
        let (a, b) = (disk(0.0, 0.0, 1.0), disk(2.0 * turn.cos(), 2.0 * turn.sin(), 1.0));
        let a_knot = a.curve(0).knot_point(0);
        let [meet, join] = meet_and_join(&a, &b);
        println!("{turn} {:?} {:?} {a_knot:?}", meet.area(), join.curve_counts());
        assert!(meet.area().unwrap() < 1e-12);
        assert_eq!(join.curve_counts()[0], 2 - join.curve_counts()[1].min(1));
    }
}

#[test]
fn a_disk_and_itself() {
    let a = disk([0.25, -0.5], 1.5, 24);
    let [meet, join] = meet_and_join(&a, &a);
    assert_eq!((&meet, &join), (&a.canonical(), &a.canonical()));
    assert!(a.difference(&a).unwrap().is_empty());
    assert!(a.symmetric_difference(&a).unwrap().is_empty());
    let outside = a.complement().unwrap();
    assert!(!outside.is_bounded());
    assert_eq!(outside.validate().unwrap(), None);
    assert!(a.meet(&outside).unwrap().is_empty());
    assert!(a.join(&outside).unwrap().is_plane());
    let again = outside.complement().unwrap();
    assert_eq!(again.curve(0).controls(), a.canonical().curve(0).controls());
    assert!(a.is_subset_of(&a).unwrap());
}

#[test]
fn disks_in_disks() {
    let curves: Vec<_> = (1..=5)
        .map(|i| {
            let own = circle([0.0, 0.0], f64::from(i), 12 + i as usize, 0.1 * f64::from(i));
            if i % 2 == 0 { reversed(&own) } else { own }
        })
        .collect();
    let rings = YinSet::new(&curves).unwrap();
    assert_eq!(rings.curve_counts(), [3, 2]);
    let order: Vec<_> = (0..5).map(|i| rings.forest().depth(i)).collect();
    assert_eq!(order, [4, 3, 2, 1, 0]);
    let hole = rings.complement().unwrap();
    assert_eq!((hole.curve_counts(), hole.is_bounded()), ([3, 3], false));
    let small = disk([2.5, 0.0], 0.25, 8);
    let [meet, join] = meet_and_join(&rings, &small);
    assert_eq!((meet, join), (small.canonical(), rings.canonical()));
    let gap = disk([1.5, 0.0], 0.25, 8);
    assert!(rings.meet(&gap).unwrap().is_empty());
    let [_, join] = meet_and_join(&rings, &gap);
    assert_eq!(join.curve_counts(), [4, 2]);
    let corners = [[-6.0, -0.1], [6.0, -0.1], [6.0, 0.1], [-6.0, 0.1]];
    let bar = YinSet::new(&[polygon(&corners, Order::CUBIC)]).unwrap();
    let [meet, _] = meet_and_join(&rings, &bar);
    assert_eq!(meet.curve_counts(), [5, 0]);
}

#[test]
fn parts_of_a_set_make_it_whole() {
    let (a, b) = (disk([0.0, 0.0], 1.0, 20), disk([0.75, 0.5], 1.0, 20));
    let (inner, outer) = (a.meet(&b).unwrap(), a.difference(&b).unwrap());
    let found = YinSet::combine(&[&inner, &outer], &BooleanFormula::parse("a | b", &[]).unwrap()).unwrap();
    assert_eq!(found.set().curve_counts(), [1, 0]);
    assert!((found.set().area().unwrap() - a.area().unwrap()).abs() < 1e-13);
    assert_eq!(found.set().validate().unwrap(), None);
    assert!(inner.meet(&outer).unwrap().is_empty());
    // Again with what the other disk leaves.
    let whole = inner.join(&b.difference(&a).unwrap()).unwrap();
    assert!((whole.area().unwrap() - b.area().unwrap()).abs() < 1e-13);
    assert_eq!(whole.curve_counts(), [1, 0]);
    assert!(inner.is_subset_of(&a).unwrap() && inner.is_subset_of(&b).unwrap());
    assert!(!a.is_subset_of(&inner).unwrap());
}

#[test]
fn straight_sets_are_those_of_order_2() {
    // Lattice squares that touch, overlap and share sides.
    let formulas = ["a & b", "a | b", "a - b", "b - a", "a ^ b", "!a", "!a & !b"];
    for (x, y) in [(0., 0.), (1., 0.), (2., 0.), (2., 2.), (1., 2.), (0.5, 0.5), (-1., -1.), (3., 0.)] {
        for side in [1.0, 2.0, 3.0] {
            for order in [Order::CUBIC, Order::new(6).unwrap(), Order::HIGHEST] {
                let flat = [square(0., 0., 2., Order::LINEAR), square(x, y, side, Order::LINEAR)];
                let curved = [square(0., 0., 2., order), square(x, y, side, order)];
                for formula in formulas {
                    let formula = BooleanFormula::parse(formula, &["a", "b"]).unwrap();
                    let [expected, found] =
                        [&flat, &curved].map(|[a, b]| YinSet::combine(&[a, b], &formula).unwrap().into_set());
                    assert_eq!(found.curve_counts(), expected.curve_counts(), "{x} {y} {side}");
                    assert_eq!(found.is_bounded(), expected.is_bounded());
                    let miss = found.signed_area() - expected.signed_area();
                    assert!(miss.abs() <= 1e-15 * expected.signed_area().abs(), "{miss:e}");
                    assert_eq!(found.betti_open().unwrap(), expected.betti_open().unwrap());
                    assert_eq!(found.betti_closed().unwrap(), expected.betti_closed().unwrap());
                    assert_eq!(found.forest(), expected.forest());
                    assert_eq!(found.kinks().len(), expected.kinks().len());
                    assert_eq!(found.validate().unwrap(), None);
                }
            }
        }
    }
}
