//! Curves: known convergence, second methods and properties.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use coface_geometry::Angle;
use coface_yin::{Curve, EndCondition, Location, Order};
use proptest::prelude::*;
use std::f64::consts::{PI, TAU};

const ORDERS: [usize; 4] = [2, 4, 6, 8];

fn order(value: usize) -> Order {
    Order::new(value).unwrap()
}

/// The greatest distance from the unit circle among many points of a curve.
fn circle_miss(curve: &Curve<'_>) -> f64 {
    let mut miss: f64 = 0.0;
    for piece in 0..curve.piece_count() {
        let [a, b] = [curve.knots()[piece], curve.knots()[piece + 1]];
        for i in 0..=100 {
            let [x, y] = curve.point(a + (b - a) * f64::from(i) / 100.0);
            miss = miss.max((x.hypot(y) - 1.0).abs());
        }
    }
    miss
}

/// Whether two numbers agree to three digits.
fn agree(found: f64, right: f64) -> bool {
    (found - right).abs() <= 6e-4 * right
}

/// Points of a wavy closed curve without symmetry, the first again as the last.
fn wavy(count: usize) -> Vec<[f64; 2]> {
    let point = |i: usize| {
        let t = TAU * (i % count) as f64 / count as f64;
        let t = t + 0.3 * t.sin();
        let r = 1.0 + 0.2 * (3.0 * t).cos() + 0.1 * (2.0 * t + 0.4).sin();
        [r * t.cos() + 0.3, 0.8 * r * t.sin() - 0.1]
    };
    (0..=count).map(point).collect()
}

/// Distances of what should be equal, over their size.
fn relative_miss(a: &[[f64; 2]], b: &[[f64; 2]]) -> f64 {
    assert_eq!(a.len(), b.len());
    let size = a.iter().flatten().fold(0.0, |size: f64, x| size.max(x.abs()));
    a.iter().flatten().zip(b.iter().flatten()).fold(0.0, |miss: f64, (x, y)| miss.max((x - y).abs())) / size
}

#[test]
fn circles_converge_as_known() {
    // Measured with another implementation, and the constants of the theory: pi^4 / 24 and 2 pi^5 / 45.
    let table = [
        (8, 1.152e-3, 3.835e-3, 3.804e-3),
        (16, 6.435e-5, 2.153e-4, 2.149e-4),
        (32, 3.908e-6, 1.309e-5, 1.308e-5),
        (64, 2.425e-7, 8.125e-7, 8.124e-7),
        (256, 9.451e-10, 3.167e-9, 3.167e-9),
    ];
    for (count, miss, area, length) in table {
        let circle = Curve::circle([0.0, 0.0], 1.0, count, Order::CUBIC).unwrap();
        assert!(agree(circle_miss(&circle), miss), "{count} {:e}", circle_miss(&circle));
        assert!(agree((circle.signed_area() - PI).abs(), area), "{count} {:e}", circle.signed_area() - PI);
        assert!(
            agree((circle.length(1e-14) - TAU).abs(), length),
            "{count} {:e}",
            circle.length(1e-14) - TAU
        );
    }
    let fine = Curve::circle([0.0, 0.0], 1.0, 1024, Order::CUBIC).unwrap();
    assert!((circle_miss(&fine) / 3.691e-12 - 1.0).abs() < 1e-3);
    assert!(((fine.signed_area() - PI).abs() / 1.237e-11 - 1.0).abs() < 1e-3);
    assert!(((fine.length(1e-15) - TAU).abs() / 1.237e-11 - 1.0).abs() < 1e-2);
    for (count, area) in [(128, 1.261e-3), (1024, 1.971e-5)] {
        let polygon = Curve::circle([0.0, 0.0], 1.0, count, Order::LINEAR).unwrap();
        assert!(agree(PI - polygon.signed_area(), area));
    }
}

#[test]
fn ellipses_converge_as_known() {
    for (count, area) in [(32, 4.964e-5), (64, 2.903e-6), (128, 1.784e-7), (256, 1.110e-8), (1024, 4.330e-11)]
    {
        let ellipse = Curve::ellipse([0.0, 0.0], [2.0, 1.0], count, Order::CUBIC).unwrap();
        let miss = (ellipse.signed_area() - TAU).abs();
        assert!(agree(miss, area), "{count} {miss:e}");
    }
    const PERIMETER: f64 = 9.688_448_220_547_675;
    let length = |count| Curve::ellipse([0.0, 0.0], [2.0, 1.0], count, Order::CUBIC).unwrap().length(1e-15);
    assert!(agree((length(64) - PERIMETER).abs(), 1.694e-6));
    assert!(((length(1024) - PERIMETER).abs() / 2.452e-11 - 1.0).abs() < 1e-2);
}

#[test]
fn half_circles_converge_as_known() {
    let half = |count: u32, ends: &EndCondition| {
        let points: Vec<[f64; 2]> = (0..=count)
            .map(|i| {
                let (x, y) = Angle::turns(i64::from(i), 2 * count).cosine_and_sine();
                [x, y]
            })
            .collect();
        Curve::fit(&points, Order::CUBIC, ends).unwrap()
    };
    for (count, miss) in [(16, 4.160e-5), (64, 1.639e-7), (256, 6.405e-10)] {
        let found = circle_miss(&half(count, &EndCondition::NotAKnot));
        assert!(agree(found, miss), "{count} {found:e}");
    }
    for (count, miss) in [(16, 1.897e-3), (64, 1.183e-4), (256, 7.392e-6), (1024, 4.620e-7)] {
        let found = circle_miss(&half(count, &EndCondition::Natural));
        assert!(agree(found, miss), "{count} {found:e}");
    }
    // With the right derivatives at the ends the order is back.
    let given = EndCondition::Complete { start: vec![[0.0, 1.0]], end: vec![[0.0, -1.0]] };
    let [coarse, fine] = [16, 32].map(|count| circle_miss(&half(count, &given)));
    assert!(coarse < 1e-5 && (3.8..4.2).contains(&(coarse / fine).log2()), "{coarse:e} {fine:e}");
}

#[test]
fn higher_orders_converge_at_their_order() {
    for (value, coarse_count) in [(6, 32), (8, 24)] {
        let area = |count: usize| {
            let circle = Curve::circle([0.0, 0.0], 1.0, count, order(value)).unwrap();
            (circle_miss(&circle), (circle.signed_area() - PI).abs())
        };
        let (coarse, fine) = (area(coarse_count), area(2 * coarse_count));
        for rate in [(coarse.0 / fine.0).log2(), (coarse.1 / fine.1).log2()] {
            assert!((rate - value as f64).abs() < 0.4, "order {value}: {rate} {coarse:?} {fine:?}");
        }
    }
}

/// The spline by dense elimination on the power coefficients of all pieces and all conditions: a second method.
fn dense_spline(points: &[[f64; 2]], knots: &[f64], value: usize, ends: &EndCondition) -> Vec<Vec<[f64; 2]>> {
    let (n, m) = (points.len() - 1, value / 2);
    let size = n * value;
    let mut rows: Vec<Vec<f64>> = Vec::new();
    // The derivative of a degree of a piece at a local parameter, as a row over its coefficients.
    let factor = |j: usize, k: usize| (j + 1 - k..=j).map(|i| i as f64).product::<f64>();
    let put = |row: &mut Vec<f64>, piece: usize, degree: usize, at: f64, sign: f64| {
        for j in degree..value {
            row[piece * value + j] += sign * factor(j, degree) * at.powi((j - degree) as i32);
        }
    };
    let empty = || vec![0.0; size + 2];
    let length = |piece: usize| knots[piece + 1] - knots[piece];
    for piece in 0..n {
        for (at, point) in [(0.0, points[piece]), (length(piece), points[piece + 1])] {
            let mut row = empty();
            put(&mut row, piece, 0, at, 1.0);
            row[size..].copy_from_slice(&point);
            rows.push(row);
        }
    }
    let mut smooth = |before: usize, after: usize, degrees: std::ops::RangeInclusive<usize>| {
        for degree in degrees {
            let mut row = empty();
            put(&mut row, before, degree, length(before), 1.0);
            put(&mut row, after, degree, 0.0, -1.0);
            rows.push(row);
        }
    };
    for knot in 1..n {
        smooth(knot - 1, knot, 1..=2 * m - 2);
    }
    match ends {
        EndCondition::Periodic => smooth(n - 1, 0, 1..=2 * m - 2),
        EndCondition::NotAKnot => {
            for i in 1..m {
                smooth(i - 1, i, 2 * m - 1..=2 * m - 1);
                smooth(n - i - 1, n - i, 2 * m - 1..=2 * m - 1);
            }
        }
        EndCondition::Natural => {
            for degree in m..=2 * m - 2 {
                for (piece, at) in [(0, 0.0), (n - 1, length(n - 1))] {
                    let mut row = empty();
                    put(&mut row, piece, degree, at, 1.0);
                    rows.push(row);
                }
            }
        }
        EndCondition::Complete { start, end } => {
            for degree in 1..m {
                for (piece, at, given) in [(0, 0.0, start), (n - 1, length(n - 1), end)] {
                    let mut row = empty();
                    put(&mut row, piece, degree, at, 1.0);
                    row[size..].copy_from_slice(&given[degree - 1]);
                    rows.push(row);
                }
            }
        }
    }
    assert_eq!(rows.len(), size);
    for column in 0..size {
        let pivot =
            (column..size).max_by(|&a, &b| rows[a][column].abs().total_cmp(&rows[b][column].abs())).unwrap();
        rows.swap(column, pivot);
        let used = rows[column].clone();
        for (at, row) in rows.iter_mut().enumerate() {
            let factor = row[column] / used[column];
            if at != column && factor != 0.0 {
                row.iter_mut().zip(&used).for_each(|(x, y)| *x -= factor * y);
            }
        }
    }
    let coefficient = |i: usize| [0, 1].map(|axis| rows[i][size + axis] / rows[i][i]);
    (0..n).map(|piece| (piece * value..(piece + 1) * value).map(coefficient).collect()).collect()
}

#[test]
fn fits_agree_with_dense_elimination() {
    for value in [4, 6, 8] {
        let derivatives: Vec<[f64; 2]> = [[0.3, -1.0], [0.5, 0.2], [-1.0, 2.0]][..value / 2 - 1].to_vec();
        let complete = EndCondition::Complete { start: derivatives.clone(), end: derivatives };
        for ends in [EndCondition::Periodic, EndCondition::NotAKnot, EndCondition::Natural, complete] {
            for count in [5, 9, 16] {
                let mut points = wavy(count);
                if ends != EndCondition::Periodic {
                    points.pop();
                }
                if ends == EndCondition::NotAKnot && points.len() <= value {
                    continue;
                }
                let curve = Curve::fit(&points, order(value), &ends).unwrap();
                let dense = dense_spline(&points, curve.knots(), value, &ends);
                for (piece, coefficients) in dense.iter().enumerate() {
                    let h = curve.knots()[piece + 1] - curve.knots()[piece];
                    for i in 0..=8 {
                        let s = h * f64::from(i) / 8.0;
                        let mut right = [0.0; 2];
                        for c in coefficients.iter().rev() {
                            right = [0, 1].map(|axis| right[axis] * s + c[axis]);
                        }
                        let found = curve.point(curve.knots()[piece] + s);
                        let miss = (found[0] - right[0]).hypot(found[1] - right[1]);
                        assert!(miss < 1e-10, "order {value} {ends:?} {count} piece {piece}: {miss:e}");
                    }
                }
            }
        }
    }
}

#[test]
fn few_points_are_on_one_polynomial() {
    // Points of y = x^2 that are not equally spaced: the parabola through three, by the chord length.
    for value in [4, 6, 8] {
        for count in 3..=value {
            let points: Vec<[f64; 2]> = (0..count).map(|i| [i as f64, ((i * i) % 7) as f64]).collect();
            let curve = Curve::fit(&points, order(value), &EndCondition::NotAKnot).unwrap();
            // One polynomial: derivatives of all degrees agree at the inner knots, and those above the number of pieces vanish.
            for knot in 1..count - 1 {
                let t = curve.knots()[knot];
                for degree in 0..value {
                    let before = Curve::from_controls(
                        order(value),
                        curve.piece(knot - 1).to_vec(),
                        vec![curve.knots()[knot - 1], t],
                    )
                    .unwrap()
                    .derivative(t, degree);
                    let after = curve.derivative(t, degree);
                    let miss = (before[0] - after[0]).hypot(before[1] - after[1]);
                    assert!(
                        miss < 1e-7,
                        "order {value}, {count} points, knot {knot}, degree {degree}: {miss:e}"
                    );
                }
            }
            let high = curve.derivative(0.1, count);
            assert!(high[0].hypot(high[1]) < 1e-7, "{value} {count} {high:?}");
        }
    }
}

#[test]
fn periodic_splines_are_smooth_at_every_knot() {
    for value in [4, 6, 8] {
        let curve = Curve::fit(&wavy(60), order(value), &EndCondition::Periodic).unwrap();
        let n = curve.piece_count();
        for knot in 0..n {
            let before = (knot + n - 1) % n;
            let part = Curve::from_controls(
                order(value),
                curve.piece(before).to_vec(),
                curve.knots()[before..before + 2].to_vec(),
            )
            .unwrap();
            for degree in 0..value - 1 {
                let a = part.derivative(part.knots()[1], degree);
                let b = curve.derivative(curve.knots()[knot], degree);
                let size = a[0].hypot(a[1]).max(1.0);
                let miss = (a[0] - b[0]).hypot(a[1] - b[1]) / size;
                // Differences of control points lose a digit or so a degree.
                let bound = [
                    1e-15,
                    if value == 4 { 1e-14 } else { 1e-13 },
                    if value == 4 { 1e-12 } else { 1e-11 },
                    1e-10,
                    1e-8,
                    1e-6,
                    1e-4,
                ][degree];
                assert!(miss < bound, "order {value} knot {knot} degree {degree}: {miss:e}");
            }
        }
    }
}

#[test]
fn points_on_a_line_give_straight_pieces() {
    let points: Vec<[f64; 2]> = [0.0, 1.0, 1.5, 7.0, 9.0, 9.25].map(|x| [x, 3.0 - 2.0 * x]).to_vec();
    for value in ORDERS {
        for ends in [EndCondition::NotAKnot, EndCondition::Natural] {
            let curve = Curve::fit(&points, order(value), &ends).unwrap();
            assert_eq!(curve, Curve::polyline(&points).unwrap().raised(order(value)).unwrap());
        }
        // A line run through back and forth is not straight.
        let back = [[0.0, 0.0], [2.0, 0.0], [1.0, 0.0]];
        let curve = Curve::fit(&back, order(value), &EndCondition::NotAKnot).unwrap();
        assert_eq!(value == 2, curve == Curve::polyline(&back).unwrap().raised(order(value)).unwrap());
    }
}

#[test]
fn faults_are_named() {
    let fit = |points: &[[f64; 2]], ends: &EndCondition| {
        Curve::fit(points, Order::CUBIC, ends).unwrap_err().to_string()
    };
    let open = EndCondition::NotAKnot;
    assert!(fit(&[[0.0, 0.0]], &open).contains("1 points"));
    assert!(fit(&[[0.0, 0.0], [1.0, 0.0], [1.0, 0.0]], &open).contains("points 1 and 2 are equal"));
    assert!(fit(&[[0.0, 0.0], [1.0, f64::NAN]], &open).contains("point 1 is not finite"));
    assert!(fit(&[[0.0, 0.0], [1e30, 0.0], [1e30, 1.0]], &open).contains("from point 1 to point 2"));
    assert!(
        fit(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [2.0, 2.0]], &EndCondition::Periodic)
            .contains("end where they begin")
    );
    assert!(fit(&[[0.0, 0.0], [1.0, 0.0], [0.0, 0.0]], &EndCondition::Periodic).contains("2 points"));
    let complete = EndCondition::Complete { start: vec![], end: vec![[1.0, 0.0]] };
    assert!(fit(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]], &complete).contains("0 and 1 derivatives"));
    assert!(
        fit(&[[0.0, 0.0], [1e308, 0.0], [1e308, 1e308], [-1e308, 1e308]], &open)
            .contains("longer than any number")
    );
    let curve = Curve::polyline(&[[0.0, 0.0], [1.0, 0.0]]).unwrap();
    assert!(
        curve.split(1.0).is_err() && curve.part([0.5, 0.2]).is_err() && curve.locate([0.0, 0.0]).is_err()
    );
    assert!(curve.raised(Order::CUBIC).unwrap().raised(Order::LINEAR).is_err());
}

#[test]
fn lengths_of_pieces_may_differ_by_much() {
    // Spacing that shrinks to 1e-9 and grows again, on the circle.
    let mut angles = vec![];
    let (mut at, mut step) = (0.0, 1e-9);
    while at < 1.5 {
        angles.push(at);
        at += step;
        step = f64::min(1.5 * step, 0.1);
    }
    let points: Vec<[f64; 2]> = angles.iter().map(|a: &f64| [a.cos(), a.sin()]).collect();
    for value in [4, 6, 8] {
        for ends in [EndCondition::NotAKnot, EndCondition::Natural] {
            let curve = Curve::fit(&points, order(value), &ends).unwrap();
            assert!(circle_miss(&curve) < 2e-2, "{value} {ends:?} {:e}", circle_miss(&curve));
        }
    }
}

#[test]
fn locations_are_those_of_the_circle() {
    for value in ORDERS {
        let circle = Curve::circle([0.0, 0.0], 1.0, 256, order(value)).unwrap();
        for (curve, turn) in [(circle.clone(), 1), (circle.reversed(), -1)] {
            for i in 0..500 {
                let angle = f64::from(i) * 0.1;
                for (r, right) in
                    [(0.999, Location::Inside), (1.001, Location::Outside), (3.0, Location::Outside)]
                {
                    let found = curve.locate([r * angle.cos(), r * angle.sin()]).unwrap();
                    assert_eq!(found, right, "order {value}, turn {turn}");
                }
            }
            // Points of the curve, knots and others.
            for piece in 0..curve.piece_count() {
                assert_eq!(
                    curve.locate(curve.knot_point(piece)).unwrap(),
                    Location::Boundary { piece, parameter: 0.0 }
                );
                if value > 2 {
                    let t = curve.knots()[piece] + 0.3 * (curve.knots()[piece + 1] - curve.knots()[piece]);
                    let Location::Boundary { piece: found, parameter } =
                        curve.locate(curve.point(t)).unwrap()
                    else {
                        panic!("a point of the curve is not on it");
                    };
                    assert_eq!(found, piece);
                    assert!((parameter - 0.3).abs() < 1e-9);
                }
            }
        }
    }
    // Known answers of another implementation.
    let quad = Curve::polyline(&[[0.0, 2.0], [0.0, -1.0], [1.0, 0.0], [1.0, 1.0], [0.0, 2.0]]).unwrap();
    for on in [[0.0, 2.0], [1.0, 1.0], [1.0, 0.5], [0.0, -1.0]] {
        assert!(matches!(quad.locate(on).unwrap(), Location::Boundary { .. }));
    }
    assert_eq!(quad.locate([0.5, 0.5]).unwrap(), Location::Inside);
    for out in [[-1.0, 0.0], [0.5, -2.0], [-1.0, -1.0], [0.5, 2.0], [-1.0, 2.0]] {
        assert_eq!(quad.locate(out).unwrap(), Location::Outside);
    }
}

#[test]
fn areas_of_polygons_are_exact_far_from_the_origin() {
    let far = 1e9;
    let square = Curve::polyline(&[
        [far, far],
        [far + 0.5, far],
        [far + 0.5, far + 0.5],
        [far, far + 0.5],
        [far, far],
    ])
    .unwrap();
    for value in ORDERS {
        let raised = square.raised(order(value)).unwrap();
        assert_eq!((raised.signed_area(), raised.length(1e-9)), (0.25, 2.0));
    }
    // A star whose area cancels almost: the exact way.
    let thin = Curve::polyline(&[[0.0, 0.0], [1e9, 1e9], [1e9, 1e9 + 1e-6], [0.0, 0.0]]).unwrap();
    let exact = 0.5 * 1e9 * ((1e9 + 1e-6) - 1e9);
    assert!((thin.signed_area() - exact).abs() <= 1e-15 * exact);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn fits_follow_motions(value in prop::sample::select(vec![4usize, 6, 8]), angle in 0.0..6.0f64, shift in prop::array::uniform2(-3.0..3.0f64)) {
        let points = wavy(23);
        let angle = Angle::radians(angle).unwrap();
        let (c, s) = angle.cosine_and_sine();
        let image = |[x, y]: [f64; 2]| [3.0 * (c * x - s * y) + shift[0], 3.0 * (s * x + c * y) + shift[1]];
        for ends in [EndCondition::Periodic, EndCondition::NotAKnot, EndCondition::Natural] {
            let given = if ends == EndCondition::Periodic { &points[..] } else { &points[..20] };
            let curve = Curve::fit(given, order(value), &ends).unwrap();
            let moved: Vec<[f64; 2]> = given.iter().map(|&point| image(point)).collect();
            let fitted = Curve::fit(&moved, order(value), &ends).unwrap();
            let right = curve.scaled(3.0, [0.0, 0.0]).rotated(angle, [0.0, 0.0]).translated(shift);
            prop_assert!(relative_miss(fitted.controls(), right.controls()) < 1e-12);
            let backward: Vec<[f64; 2]> = given.iter().rev().copied().collect();
            let turned = Curve::fit(&backward, order(value), &ends).unwrap().reversed();
            prop_assert!(relative_miss(turned.controls(), curve.controls()) < 1e-12);
            for (a, b) in turned.knots().iter().zip(curve.knots()) {
                prop_assert!((a - b).abs() < 1e-14);
            }
        }
    }

    #[test]
    fn parts_are_the_curve((value, from, to) in (prop::sample::select(ORDERS.to_vec()), 0.0..1.0f64, 0.0..1.0f64)) {
        let curve = Curve::fit(&wavy(17), order(value), &EndCondition::Periodic).unwrap();
        let whole = curve.knots()[17];
        let [from, to] = [from * whole, to * whole];
        let part = curve.part([from, to]).unwrap();
        let end = if from < to { to } else { whole + to };
        prop_assert_eq!(part.knots()[0], from);
        prop_assert!((part.knots()[part.piece_count()] - end).abs() < 1e-13);
        for i in 0..=100 {
            let t = from + (end - from) * f64::from(i) / 100.0;
            let [a, b] = [part.point(t), curve.point(if t > whole { t - whole } else { t })];
            prop_assert!((a[0] - b[0]).hypot(a[1] - b[1]) < 1e-13);
        }
        let reversed = curve.reversed();
        prop_assert!((reversed.signed_area() + curve.signed_area()).abs() < 1e-14);
        let twice = reversed.reversed();
        prop_assert_eq!(twice.controls(), curve.controls());
        let a = reversed.point(whole - from);
        let b = curve.point(from);
        prop_assert!((a[0] - b[0]).hypot(a[1] - b[1]) < 1e-13);
        let [before, after] = curve.split(from.max(1e-3)).unwrap();
        let sum = before.length(1e-13) + after.length(1e-13);
        prop_assert!((sum - curve.length(1e-13)).abs() < 1e-11);
    }

    #[test]
    fn boxes_and_monotone_parts_hold_all_points(value in prop::sample::select(ORDERS.to_vec()), flat in prop::collection::vec(prop::array::uniform2(-1.0..1.0f64), 5..12)) {
        let curve = Curve::fit(&flat, order(value), &EndCondition::NotAKnot).unwrap();
        let [low, high] = curve.bounding_box();
        let breaks = curve.monotone_parameters();
        let mut extremes = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
        for pair in breaks.windows(2) {
            let points: Vec<[f64; 2]> = (0..=16).map(|i| curve.point(pair[0] + (pair[1] - pair[0]) * f64::from(i) / 16.0)).collect();
            let size = 1e-12 * (1.0 + points.iter().flatten().fold(0.0, |size: f64, x| size.max(x.abs())));
            for axis in 0..2 {
                let steps: Vec<f64> = points.windows(2).map(|pair| pair[1][axis] - pair[0][axis]).collect();
                prop_assert!(steps.iter().all(|&step| step >= -size) || steps.iter().all(|&step| step <= size));
                for point in &points {
                    extremes[0][axis] = extremes[0][axis].min(point[axis]);
                    extremes[1][axis] = extremes[1][axis].max(point[axis]);
                    prop_assert!(low[axis] - size <= point[axis] && point[axis] <= high[axis] + size);
                }
            }
        }
        // Extremes are at the breaks, so the box is as small as it can be.
        for axis in 0..2 {
            let size = 1e-12 * (1.0 + high[axis].abs() + low[axis].abs());
            prop_assert!((extremes[0][axis] - low[axis]).abs() <= size && (extremes[1][axis] - high[axis]).abs() <= size);
        }
    }

    #[test]
    fn powers_there_and_back(value in prop::sample::select(ORDERS.to_vec()), count in 4..20usize) {
        let curve = Curve::fit(&wavy(count), order(value), &EndCondition::Periodic).unwrap();
        let coefficients: Vec<[f64; 2]> = (0..count).flat_map(|piece| curve.power_coefficients(piece)).collect();
        let back = Curve::from_power(order(value), curve.knots().to_vec(), &coefficients, 1e-11).unwrap();
        prop_assert!(back.is_closed());
        prop_assert!(relative_miss(back.controls(), curve.controls()) < 1e-11);
    }
}
