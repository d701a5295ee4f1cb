//! Meetings against closed forms, against a dense polyline, and against themselves after changes that change nothing.

use super::Meetings;
use crate::yin::set::CurveArena;
use crate::yin::{Curve, Order};

/// One closed curve from all its control points, the first one again at the end.
fn arena(order: usize, curves: &[Vec<[f64; 2]>]) -> CurveArena {
    let order = Order::new(order).expect("orders of tests are even");
    let mut found = CurveArena::new(order);
    for controls in curves {
        let knots = (0..=controls.len() / order.degree()).map(|i| i as f64).collect();
        found
            .push(&Curve::from_controls(order, controls.clone(), knots).expect("tests count control points"));
    }
    found
}

/// The cubic from 0 to 1 whose coordinates are given, closed by the segment back.
fn closed_by_segment(piece: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let (a, b) = (piece[0], piece[piece.len() - 1]);
    let degree = piece.len() - 1;
    let back = (1..=degree).map(|i| {
        let t = i as f64 / degree as f64;
        if i == degree { a } else { [0, 1].map(|k| b[k] + (a[k] - b[k]) * t) }
    });
    piece.iter().copied().chain(back).collect()
}

/// Control points of a cubic spline near a circle: each quarter in `n` arcs, counterclockwise.
fn circle(center: [f64; 2], radius: f64, n: usize, turn: f64) -> Vec<[f64; 2]> {
    let step = std::f64::consts::TAU / (4 * n) as f64;
    let handle = 4.0 / 3.0 * (step / 4.0).tan();
    let at = |i: usize| {
        let (sine, cosine) = (step * (i % (4 * n)) as f64 + turn).sin_cos();
        ([cosine, sine], [-sine, cosine])
    };
    let place = |x: f64, y: f64| [center[0] + radius * x, center[1] + radius * y];
    let mut found = Vec::new();
    for i in 0..4 * n {
        let ((p, d), (q, e)) = (at(i), at(i + 1));
        found.push(place(p[0], p[1]));
        found.push(place(p[0] + handle * d[0], p[1] + handle * d[1]));
        found.push(place(q[0] - handle * e[0], q[1] - handle * e[1]));
    }
    found.push(found[0]);
    found
}

fn of(arenas: &[&CurveArena]) -> Meetings {
    Meetings::of(arenas).expect("control points of tests are finite")
}

#[test]
fn two_circles_cross_twice() {
    let a = arena(4, &[circle([0.0, 0.0], 1.0, 2, 0.0)]);
    let b = arena(4, &[circle([1.0, 0.0], 1.0, 2, 0.1)]);
    let found = of(&[&a, &b]);
    assert_eq!((found.points.len(), found.overlaps.len()), (2, 0), "{:?}", found.points);
    for meeting in &found.points {
        assert!(meeting.is_certified);
        assert!(
            (meeting.point[0] - 0.5).abs() < 1e-4 && (meeting.point[1].abs() - 0.75f64.sqrt()).abs() < 1e-4
        );
        let curves = [
            found.pieces.polynomial(meeting.pieces[0] as usize),
            found.pieces.polynomial(meeting.pieces[1] as usize),
        ];
        for k in 0..2 {
            let at = found.pieces.frame.to_world(curves[k].at(meeting.at[k]));
            assert!((0..2).all(|axis| (at[axis] - meeting.point[axis]).abs() < 1e-14));
            assert!(meeting.parameters[k][0] < meeting.at[k] && meeting.at[k] < meeting.parameters[k][1]);
            assert!(meeting.parameters[k][1] - meeting.parameters[k][0] < 1e-11);
        }
    }
}

#[test]
fn circles_that_touch_have_one_point_that_is_not_certified() {
    for (radius, center) in [(1.0, 2.0), (0.5, 0.5), (0.25, 1.25), (2.0, -1.0)] {
        // Both have a knot where they touch, and its tangent is upright.
        let a = arena(4, &[circle([0.0, 0.0], 1.0, 3, 0.0)]);
        let b = arena(4, &[circle([center, 0.0], radius, 2, 0.0)]);
        let found = of(&[&a, &b]);
        assert!(
            !found.points.is_empty() && found.overlaps.is_empty(),
            "{radius} {center}: {:?}",
            found.points
        );
        for meeting in &found.points {
            assert!(!meeting.is_certified);
            assert!((0..2).all(|k| (meeting.point[k] - [1.0, 0.0][k]).abs() < 1e-12), "{meeting:?}");
        }
    }
}

#[test]
fn two_cubics_cross_nine_times() {
    // y = T3(x) and x = T3(y) with T3 = 4 x^3 - 3 x, on [-1, 1].
    let graph = [[-1.0, -1.0], [-1.0 / 3.0, 5.0], [1.0 / 3.0, -5.0], [1.0, 1.0]];
    let turned = graph.map(|[x, y]| [y, x]);
    let a = arena(4, &[closed_by_segment(&graph)]);
    let b = arena(4, &[closed_by_segment(&turned)]);
    let found = of(&[&a, &b]);
    let between: Vec<_> = found.points.iter().filter(|meeting| meeting.pieces == [0, 2]).collect();
    assert_eq!(between.len(), 9, "{between:?}");
    // The ends are common to both, bit for bit.
    assert!(between.iter().all(|meeting| meeting.is_certified), "{between:?}");
    // The segments overlap, and each cubic crosses both segments in the middle.
    assert_eq!(found.overlaps.len(), 1);
    assert_eq!(found.overlaps[0].pieces, [1, 3]);
    assert!(found.overlaps[0].is_certified);
}

#[test]
fn a_cubic_with_a_loop_meets_itself() {
    // x = t^2 - 1/4, y = t (t^2 - 1/4) for t from -1 to 1: the loop closes at the origin for t = 1/2 and -1/2.
    let piece = [[0.75, -0.75], [-1.25, 1.25], [-1.25, -1.25], [0.75, 0.75]];
    let point = |t: f64| {
        let s = (t + 1.0) / 2.0;
        let weights = [(1.0 - s).powi(3), 3.0 * s * (1.0 - s).powi(2), 3.0 * s * s * (1.0 - s), s.powi(3)];
        [0, 1].map(|k| (0..4).map(|i| weights[i] * piece[i][k]).sum::<f64>())
    };
    let curve = arena(4, &[closed_by_segment(&piece)]);
    let found = of(&[&curve]);
    let loops: Vec<_> = found.points.iter().filter(|meeting| meeting.pieces == [0, 0]).collect();
    assert_eq!(loops.len(), 1, "{:?} {:?}", found.points, point(0.5));
    assert!(loops[0].is_certified);
    let [s, t] = loops[0].at.map(point_parameter);
    let (p, q) = (point(s), point(t));
    assert!((p[0] - q[0]).abs() < 1e-13 && (p[1] - q[1]).abs() < 1e-13 && (s - t).abs() > 0.5);
}

fn point_parameter(t: f64) -> f64 {
    2.0 * t - 1.0
}

#[test]
fn the_same_curve_overlaps_piece_by_piece() {
    let points = circle([0.3, 0.2], 1.0, 3, 0.2);
    let backward: Vec<_> = points.iter().rev().copied().collect();
    let a = arena(4, &[points]);
    for (b, ranges) in
        [(a.clone(), [[0.0, 1.0], [0.0, 1.0]]), (arena(4, &[backward]), [[0.0, 1.0], [1.0, 0.0]])]
    {
        let found = of(&[&a, &b]);
        assert_eq!(found.overlaps.len(), 12);
        assert!(found.overlaps.iter().all(|overlap| overlap.is_certified && overlap.ranges == ranges));
        // Ends of pieces lie on those of the neighbors of their partners.
        assert_eq!(found.points.len(), 24);
        for meeting in &found.points {
            assert!(meeting.at.iter().all(|&t| t == 0.0 || t == 1.0), "{meeting:?}");
        }
    }
}
