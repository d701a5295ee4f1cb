//! Curved and straight boundaries that touch, pass each other, and cross twice, nearer than the resolution: exact arithmetic tells.
#![allow(clippy::unwrap_used, reason = "a failing test shows where")]

use coface_arrange::boolean::BooleanFormula;
use coface_geometry::Angle;
use coface_yin::{Combination, Curve, Order, YinSet};

/// A set over a cubic piece: straight up from its end, back and down.
fn over(piece: [[f64; 2]; 4], up: [f64; 2]) -> YinSet {
    let [a, b] = [piece[0], piece[3]];
    let [c, d] = [b, a].map(|point| [point[0] + up[0], point[1] + up[1]]);
    let rest = Curve::polyline(&[b, c, d, a]).unwrap().raised(Order::CUBIC).unwrap();
    let controls = piece.iter().chain(&rest.controls()[1..]).copied().collect();
    YinSet::new(&[Curve::from_controls(Order::CUBIC, controls, vec![0.0, 1.0, 2.0, 3.0, 4.0]).unwrap()])
        .unwrap()
}

fn polygon(points: &[[f64; 2]]) -> YinSet {
    let closed: Vec<_> = points.iter().chain(&points[..1]).copied().collect();
    YinSet::new(&[Curve::polyline(&closed).unwrap()]).unwrap()
}

fn combine(sets: [&YinSet; 2], formula: &str) -> Combination {
    YinSet::combine(&sets, &BooleanFormula::parse(formula, &["a", "b"]).unwrap()).unwrap()
}

/// The cubic $9 (t - 1/3)^2 (t + 1)$ over the line $y = 2 x$, with x from 0 to 3: it touches in a third, which is no number here.
fn touching() -> [[f64; 2]; 4] {
    let heights = [3.0, -2.0, -4.0, 24.0].map(|height| height / 4.0);
    [0, 1, 2, 3].map(|j| [j as f64, 2.0 * j as f64 + heights[j]])
}

fn below_line() -> YinSet {
    polygon(&[[-2.0, -4.0], [5.0, -7.0], [5.0, 10.0]])
}

fn raised(height: f64) -> YinSet {
    over(touching().map(|[x, y]| [x, y + height]), [0.0, 40.0])
}

fn turned(set: &YinSet, quarters: i64) -> YinSet {
    let curves: Vec<_> =
        (0..set.curve_count()).map(|i| set.curve(i).rotated(Angle::turns(quarters, 4), [0.0; 2])).collect();
    YinSet::new(&curves).unwrap()
}

#[test]
fn touching_is_proven() {
    for quarters in 0..4 {
        let [a, b] = [raised(0.0), below_line()].map(|set| turned(&set, quarters));
        let meet = combine([&a, &b], "a & b");
        assert!(meet.set().is_empty() && meet.report().is_empty(), "{:?}", meet.report());
        let join = combine([&a, &b], "a | b");
        assert!(join.report().is_empty());
        assert_eq!((join.set().curve_counts(), join.set().validate().unwrap()), ([2, 0], None));
        assert_eq!((join.set().betti_open().unwrap(), join.set().betti_closed().unwrap()), ([2, 0], [1, 0]));
    }
}

#[test]
fn passing_by_is_told_from_crossing_twice() {
    // The resolution is about 2^-34 here, as the extent is about 60.
    for exponent in [-30, -35, -36, -37] {
        let height = 2f64.powi(exponent);
        let (a, b) = (raised(height), below_line());
        let join = combine([&a, &b], "a | b");
        assert!(join.report().is_empty(), "{exponent} {:?}", join.report());
        assert!(join.resolution() > 2f64.powi(-36));
        assert_eq!(join.set().betti_closed().unwrap(), [2, 0], "{exponent}");
        assert!(combine([&a, &b], "a & b").set().is_empty());
        let a = raised(-height);
        let meet = combine([&a, &b], "a & b");
        assert_eq!((meet.set().curve_counts(), meet.set().validate().unwrap()), ([1, 0], None), "{exponent}");
        // Near a third the height is 27 / 4 (4/3) = 9 times the square of the offset in t, and x is 3 t.
        let root = (height / 9.0).sqrt();
        let expected = 3.0 * (4.0 / 3.0) * height * root;
        let area = meet.set().area().unwrap();
        assert!((area - expected).abs() < 0.05 * expected, "{exponent}: {area} {expected}");
        assert_eq!(combine([&a, &b], "a | b").set().betti_open().unwrap(), [1, 0]);
    }
    // What is left is below what rounding does to results.
    for height in [2f64.powi(-47), -(2f64.powi(-47))] {
        let (a, b) = (raised(height), below_line());
        let join = combine([&a, &b], "a | b");
        assert_eq!(join.set().betti_closed().unwrap(), [1, 0]);
        assert!(!join.report().is_empty());
    }
}

#[test]
fn a_knot_on_a_side_is_proven() {
    // The knot (3, 1) between two cubic pieces is on the side from (0, 0) to (6, 2), and both stay above it.
    let left = [[0.0, 4.0], [1.0, 1.0], [2.0, 1.0 - 1.0 / 4.0], [3.0, 1.0]];
    let right = [[3.0, 1.0], [4.0, 1.25 + 0.25], [5.0, 3.0], [6.0, 8.0]];
    let controls = left
        .iter()
        .chain(&right[1..])
        .copied()
        .chain(
            Curve::polyline(&[right[3], [0.0, 20.0], left[0]])
                .unwrap()
                .raised(Order::CUBIC)
                .unwrap()
                .controls()[1..]
                .to_vec(),
        )
        .collect();
    let a = YinSet::new(&[Curve::from_controls(Order::CUBIC, controls, vec![0., 1., 2., 3., 4.]).unwrap()])
        .unwrap();
    let b = polygon(&[[0.0, 0.0], [6.0, -4.0], [6.0, 2.0]]);
    let join = combine([&a, &b], "a | b");
    assert!(join.report().is_empty(), "{:?}", join.report());
    assert_eq!((join.set().curve_counts(), join.set().betti_closed().unwrap()), ([2, 0], [1, 0]));
    assert!(combine([&a, &b], "a & b").set().is_empty());
}

/// The mirror image of [`touching`] in the line, as the upper side of a set that hangs down from it.
fn hanging(height: f64) -> YinSet {
    let heights = [3.0, -2.0, -4.0, 24.0].map(|height| height / 4.0);
    over([3, 2, 1, 0].map(|j: usize| [j as f64, 2.0 * j as f64 - heights[j] + height]), [0.0, -60.0])
}

/// Two cubics that touch at a third of one and two thirds of the other.
#[test]
fn curves_that_touch_at_simple_fractions_are_proven_to() {
    for quarters in 0..4 {
        let [a, b] = [raised(0.0), hanging(0.0)].map(|set| turned(&set, quarters));
        let meet = combine([&a, &b], "a & b");
        assert!(meet.set().is_empty() && meet.report().is_empty(), "{:?}", meet.report());
        let join = combine([&b, &a], "a | b");
        assert!(join.report().is_empty(), "{:?}", join.report());
        assert_eq!((join.set().curve_counts(), join.set().validate().unwrap()), ([2, 0], None));
        assert_eq!((join.set().betti_open().unwrap(), join.set().betti_closed().unwrap()), ([2, 0], [1, 0]));
    }
    // Nearly so is not so: what rounding may have done is said, and what is apart is found to be.
    let join = combine([&raised(0.0), &hanging(2f64.powi(-47))], "a | b");
    assert!(!join.report().is_empty());
    let apart = combine([&raised(0.0), &hanging(-(2f64.powi(-47)))], "a | b");
    assert!(apart.report().is_empty(), "{:?}", apart.report());
    assert_eq!(apart.set().betti_open().unwrap(), [2, 0]);
    // Farther away they are apart, or cross twice.
    let apart = combine([&raised(0.0), &hanging(-(2f64.powi(-20)))], "a | b");
    assert!(apart.report().is_empty());
    assert_eq!(apart.set().betti_closed().unwrap(), [2, 0]);
    let lens = combine([&raised(0.0), &hanging(2f64.powi(-20))], "a & b");
    assert!(lens.report().is_empty());
    assert_eq!(lens.set().curve_counts(), [1, 0]);
}
