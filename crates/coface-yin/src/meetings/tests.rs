//! Meetings against closed forms, against a dense polyline, and against themselves after changes that change nothing.

use super::polynomial::{cross, is_apart, minus};
use super::{Carriers, Meetings, Pieces};
use crate::curve::bernstein;
use crate::set::CurveArena;
use crate::{Curve, Order};
use proptest::prelude::*;

/// One closed curve from all its control points, the first one again at the end.
fn arena(order: usize, curves: &[Vec<[f64; 2]>]) -> CurveArena {
    let order = Order::new(order).expect("orders of tests are even");
    let mut found = CurveArena::new(order);
    for controls in curves {
        let knots = (0..=(controls.len() - 1) / order.degree()).map(|i| i as f64).collect();
        found
            .push(&Curve::from_controls(order, controls.clone(), knots).expect("tests count control points"));
    }
    found
}

/// A piece, closed by the segment back.
fn closed_by_segment(piece: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let back = bernstein::straight_piece([piece[piece.len() - 1], piece[0]], piece.len());
    piece.iter().chain(&back[1..]).copied().collect()
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
    let carriers = carriers(arenas);
    let pieces = Pieces::of(&carriers, 1.0).expect("control points of tests are finite");
    Meetings::of_pieces(&pieces).distributed(&carriers, pieces.frame.world_length(pieces.frame.resolution))
}

fn carriers(arenas: &[&CurveArena]) -> Carriers {
    Carriers::of(arenas, arenas[0].order().value())
}

#[test]
fn two_circles_cross_twice() {
    let a = arena(4, &[circle([0.0, 0.0], 1.0, 2, 0.0)]);
    let b = arena(4, &[circle([1.0, 0.0], 1.0, 2, 0.1)]);
    let carriers = carriers(&[&a, &b]);
    let pieces = Pieces::of(&carriers, 1.0).expect("they are finite");
    let found = Meetings::of_pieces(&pieces);
    assert_eq!((found.points.len(), found.overlaps.len()), (2, 0), "{:?}", found.points);
    for meeting in &found.points {
        assert!(meeting.is_certified);
        assert!(
            (meeting.point[0] - 0.5).abs() < 1e-4 && (meeting.point[1].abs() - 0.75f64.sqrt()).abs() < 1e-4
        );
        for (k, piece) in meeting.pieces.into_iter().enumerate() {
            let at = pieces.frame.to_world(pieces.polynomial(piece as usize).at(meeting.at[k]));
            assert!((0..2).all(|axis| (at[axis] - meeting.point[axis]).abs() < 1e-14));
            assert!(meeting.parameters[k][0] <= meeting.at[k] && meeting.at[k] <= meeting.parameters[k][1]);
            assert!(meeting.parameters[k][1] - meeting.parameters[k][0] < 1e-11);
        }
    }
}

#[test]
fn circles_that_touch_have_one_point_that_is_certified_in_a_common_knot() {
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
            // Of angles of half a turn the sine is not zero in floating point.
            assert_eq!(meeting.is_certified, center + radius == 1.0, "{radius} {center} {meeting:?}");
            assert!((0..2).all(|k| (meeting.point[k] - [1.0, 0.0][k]).abs() < 1e-12), "{meeting:?}");
        }
    }
}

#[test]
fn arcs_side_by_side_are_apart_or_one() {
    let arc = [[0.0, 0.0], [1.0, 1.5], [2.0, 1.25], [3.0, 0.25]];
    let moved = |[x, y]: [f64; 2]| arc.map(|p| [p[0] + x, p[1] + y]).to_vec();
    let between = |shift: [f64; 2]| {
        let [a, b] = [arena(4, &[closed_by_segment(&arc)]), arena(4, &[closed_by_segment(&moved(shift))])];
        let found = of(&[&a, &b]);
        assert!(found.exhausted.is_empty(), "{shift:?}");
        let points = found.points.into_iter().filter(|meeting| meeting.pieces == [0, 2]).count();
        (points, found.overlaps.into_iter().filter(|overlap| overlap.pieces == [0, 2]).collect::<Vec<_>>())
    };
    for shift in [[0.0, 1e-6], [0.0, 5e-9], [0.0, -1e-10], [1e-8, 0.0]] {
        let (points, overlaps) = between(shift);
        // Where the direction of the shift is that of the arc they come together.
        assert_eq!(points, usize::from(shift[0] != 0.0), "{shift:?}");
        assert!(overlaps.is_empty(), "{shift:?} {overlaps:?}");
    }
    for shift in [[0.0, 1e-13], [1e-13, -1e-13]] {
        let (points, overlaps) = between(shift);
        assert_eq!((points, overlaps.len()), (0, 1), "{shift:?} {overlaps:?}");
        for range in overlaps[0].ranges {
            assert!(range[0] < 1e-9 && range[1] > 1.0 - 1e-9, "{range:?}");
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
    let [s, t] = loops[0].at.map(|t| 2.0 * t - 1.0);
    let (p, q) = (point(s), point(t));
    assert!((p[0] - q[0]).abs() < 1e-13 && (p[1] - q[1]).abs() < 1e-13 && (s - t).abs() > 0.5);
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

#[test]
fn a_part_of_a_piece_overlaps_it() {
    let cubic = [[0.0, 0.0], [0.5, 1.5], [1.25, -0.75], [2.0, 0.75]];
    let fifth = [[0.0, 0.0], [0.5, 1.5], [0.75, -1.0], [1.0, 0.5], [1.5, -0.25], [2.0, 1.0]];
    let seventh =
        [[0.0, 0.0], [0.5, 1.5], [0.75, -1.0], [1.0, 0.5], [1.5, -2.25], [2.0, 1.0], [2.5, 1.0], [2.75, 3.0]];
    for piece in [&cubic[..], &fifth, &seventh] {
        for (range, shift) in [([0.25, 0.75], 0.0), ([0.9, 0.3], 0.0), ([0.0, 0.4], 1e6), ([0.7, 1.0], -3e-6)]
        {
            let moved =
                |points: &[[f64; 2]]| points.iter().map(|point| point.map(|x| x + shift)).collect::<Vec<_>>();
            let own = moved(piece);
            let part = bernstein::sub_range(&own, range);
            let (a, b) = (
                arena(piece.len(), &[closed_by_segment(&own)]),
                arena(piece.len(), &[closed_by_segment(&part)]),
            );
            let found = of(&[&a, &b]);
            let overlaps: Vec<_> = found.overlaps.iter().filter(|overlap| overlap.pieces == [0, 2]).collect();
            assert_eq!(overlaps.len(), 1, "{range:?} {shift} {:?} {:?}", found.overlaps, found.points);
            let [of_a, of_b] = overlaps[0].ranges;
            let expected =
                if range[0] < range[1] { [range, [0.0, 1.0]] } else { [[range[1], range[0]], [1.0, 0.0]] };
            assert!((0..2).all(|k| (of_a[k] - expected[0][k]).abs() < 1e-8), "{of_a:?} {expected:?}");
            assert_eq!(of_b, expected[1]);
            // A part of a cubic is proven to be one where it ends at simple fractions and no coordinate was rounded.
            let is_exact = piece.len() == 4 && range == [0.25, 0.75];
            assert_eq!(overlaps[0].is_certified, is_exact, "{range:?} of order {}", piece.len());
            assert!(found.points.iter().all(|meeting| meeting.pieces != [0, 2]), "{:?}", found.points);
        }
    }
}

/// Thirds cannot be written in binary: only the fractions themselves prove that the parts are parts.
#[test]
fn parts_between_thirds_are_proven_to_overlap() {
    // y = 27 t^2 (1 - t) over x = 27 t, and a way back around the middle third or the last.
    let piece = [[0.0, 0.0], [9.0, 0.0], [18.0, 9.0], [27.0, 0.0]];
    let middle = [[9.0, 2.0], [12.0, 3.0], [15.0, 4.0], [18.0, 4.0]];
    let last = [[18.0, 4.0], [21.0, 4.0], [24.0, 3.0], [27.0, 0.0]];
    for (part, range) in [(middle, [1.0 / 3.0, 2.0 / 3.0]), (last, [2.0 / 3.0, 1.0])] {
        let is_certified = |part: &[[f64; 2]]| {
            let [a, b] = [&piece[..], part].map(|own| arena(4, &[closed_by_segment(own)]));
            let found = of(&[&a, &b]);
            let overlaps: Vec<_> = found.overlaps.iter().filter(|overlap| overlap.pieces == [0, 2]).collect();
            assert_eq!(overlaps.len(), 1, "{:?}", found.overlaps);
            assert!((0..2).all(|k| (overlaps[0].ranges[0][k] - range[k]).abs() < 1e-8), "{:?}", overlaps[0]);
            overlaps[0].is_certified
        };
        assert!(is_certified(&part));
        // By the last digit it is another cubic, within the resolution of the first.
        let mut moved = part;
        moved[1][1] = moved[1][1].next_up();
        assert!(!is_certified(&moved));
    }
}

#[test]
fn segments_meet_exactly_in_any_order() {
    // A triangle, and one whose corner is on its lower side; both have parts of that side's line.
    for order in [2, 4, 8] {
        let triangle = |corners: [[f64; 2]; 3]| {
            let mut controls = vec![corners[0]];
            for i in 0..3 {
                let side = bernstein::straight_piece([corners[i], corners[(i + 1) % 3]], order);
                controls.extend_from_slice(&side[1..]);
            }
            arena(order, &[controls])
        };
        let a = triangle([[0.0, 0.0], [3.0, 0.0], [1.5, 2.0]]);
        let b = triangle([[1.0, 0.0], [2.0, -1.0], [2.0, 0.0]]);
        let found = of(&[&a, &b]);
        assert_eq!(found.overlaps.len(), 1, "{order}");
        assert_eq!(found.overlaps[0].pieces, [0, 5]);
        let [[from, to], of_b] = found.overlaps[0].ranges;
        assert!((from - 1.0 / 3.0).abs() < 1e-15 && (to - 2.0 / 3.0).abs() < 1e-15 && of_b == [1.0, 0.0]);
        assert!(found.overlaps[0].is_certified);
        assert!(found.points.iter().all(|meeting| meeting.is_certified));
        assert_eq!(found.points.iter().map(|meeting| meeting.pieces).collect::<Vec<_>>(), [[0, 3], [0, 4]]);
        assert_eq!(found.points[0].point, [1.0, 0.0]);
        // Gaps far below the resolution are gaps for segments.
        let near = triangle([[1.0, -1e-17], [2.0, -1.0], [2.0, -1e-17]]);
        let found = of(&[&a, &near]);
        assert!(found.points.is_empty() && found.overlaps.is_empty(), "{order}");
    }
}

#[test]
fn neighbors_that_leave_their_knot_together_have_only_that() {
    // Two arcs from the origin with one tangent, and back: a cusp between pieces, and a crossing farther on.
    let controls = vec![[0.0, 0.0], [1.0, 0.0], [2.0, 1.0], [3.0, 3.0], [2.0, 2.0], [1.0, 0.0], [0.0, 0.0]];
    let found = of(&[&arena(4, &[controls])]);
    assert!(found.points.is_empty() && found.overlaps.is_empty(), "{:?}", found.points);
    // A piece with a cusp: (t^2, t^3).
    let cusp = [[1.0, -1.0], [-1.0 / 3.0, 1.0], [-1.0 / 3.0, -1.0], [1.0, 1.0]];
    let found = of(&[&arena(4, &[closed_by_segment(&cusp)])]);
    assert!(found.points.is_empty() && found.overlaps.is_empty(), "{:?}", found.points);
}

#[test]
fn knots_on_a_curve_are_met_at_the_knot() {
    // The middle of the first curve's arc is a knot of the second, which crosses it there.
    let arc = [[0.0, 0.0], [1.0, 1.0], [2.0, 1.0], [3.0, 0.0]];
    let middle = bernstein::value(&arc, 0.5);
    let a = arena(4, &[closed_by_segment(&arc)]);
    let mut controls = vec![[1.25, 2.0]];
    controls.extend_from_slice(&[[1.25, 1.75], [1.5, 1.0], middle, [1.5, 0.5], [2.0, 0.5], [2.0, 0.25]]);
    controls.extend_from_slice(&[[5.0, 0.25], [5.0, 2.0], [1.25, 2.0]]);
    let found = of(&[&a, &arena(4, &[controls])]);
    let at_knot: Vec<_> =
        found.points.iter().filter(|meeting| meeting.pieces[0] == 0 && meeting.pieces[1] < 4).collect();
    assert_eq!(at_knot.len(), 2, "{:?}", found.points);
    assert_eq!((at_knot[0].at[1], at_knot[1].at[1]), (1.0, 0.0));
    assert!(at_knot.iter().all(|meeting| meeting.point == middle && !meeting.is_certified));
}

/// The parameter of the first piece is the cube of the way, so at equal parameters it is far from the segment back.
#[test]
fn a_piece_that_stands_still_overlaps_its_closing_segment() {
    let piece = [[1.3125, 0.0], [1.3125, 0.0], [1.3125, 0.0], [1.3125, -0.125]];
    let other = [[0.0, 0.0], [0.0, 0.0], [0.0, 0.0], [0.0, 0.0625]];
    for turned in [false, true] {
        let mut own = closed_by_segment(&piece);
        if turned {
            own.reverse();
        }
        let found = of(&[&arena(4, &[own]), &arena(4, &[closed_by_segment(&other)])]);
        assert!(found.points.is_empty(), "{turned}: {:?}", found.points);
        let overlaps: Vec<_> =
            found.overlaps.iter().map(|overlap| (overlap.pieces, overlap.ranges)).collect();
        assert_eq!(overlaps, [([0, 1], [[0.0, 1.0], [1.0, 0.0]]), ([2, 3], [[0.0, 1.0], [1.0, 0.0]])]);
    }
}

/// A piece that runs along a segment at a speed of its own, and goes on to bend away from it: the arc ends opposite a place on it.
#[test]
fn an_arc_at_another_speed_ends_opposite_its_end() {
    let slow = [[0.0, 0.0], [0.0, 0.0], [0.0, 0.0], [1.0, 0.0]];
    let segment = bernstein::straight_piece([[0.125, 0.0], [4.0, 0.0]], 4);
    let away = |end: [f64; 2], start: [f64; 2]| {
        let [x, y] = [0, 1].map(|axis| 0.5 * (end[axis] + start[axis]));
        bernstein::straight_piece([end, [x, y - 1.0]], 4)[1..]
            .iter()
            .chain(&bernstein::straight_piece([[x, y - 1.0], start], 4)[1..])
            .copied()
            .collect::<Vec<_>>()
    };
    let closed = |piece: &[[f64; 2]]| [piece.to_vec(), away(piece[3], piece[0])].concat();
    for turned in [false, true] {
        let (mut a, b) = (closed(&slow), closed(&segment));
        if turned {
            a.reverse();
        }
        let own = if turned { 2 } else { 0 };
        let found = of(&[&arena(4, &[a]), &arena(4, &[b])]);
        let overlaps: Vec<_> = found.overlaps.iter().filter(|overlap| overlap.pieces == [own, 3]).collect();
        assert_eq!(overlaps.len(), 1, "{turned}: {:?}", found.overlaps);
        let [of_a, of_b] = overlaps[0].ranges.map(|[s, t]| [s.min(t), s.max(t)]);
        let expected = if turned { [0.0, 0.5] } else { [0.5, 1.0] };
        assert!((0..2).all(|k| (of_a[k] - expected[k]).abs() < 1e-9), "{turned}: {of_a:?}");
        assert!(of_b[0] == 0.0 && (of_b[1] - 0.875 / 3.875).abs() < 1e-12, "{turned}: {of_b:?}");
        assert!(
            found.points.iter().all(|meeting| meeting.pieces != [own, 3]),
            "{turned}: {:?}",
            found.points
        );
    }
}

/// Control points on a lattice, so that they coincide now and then and can be moved exactly.
fn piece(count: usize) -> impl Strategy<Value = Vec<[f64; 2]>> {
    prop::collection::vec(prop::array::uniform2((-32i32..=32).prop_map(|x| f64::from(x) / 16.0)), count)
        .prop_filter("the ends differ", |piece| piece[0] != piece[piece.len() - 1])
}

fn any_piece() -> impl Strategy<Value = Vec<[f64; 2]>> {
    prop_oneof![4 => piece(4), 1 => piece(6), 1 => piece(8)]
}

/// A summary that does not depend on the order of pieces.
fn summary(found: &Meetings, place: impl Fn(u32, f64) -> (u32, f64)) -> Vec<([(u32, i64); 2], bool)> {
    let mut all: Vec<_> = found
        .points
        .iter()
        .map(|meeting| {
            let mut sides = [0, 1].map(|k| {
                let (piece, at) = place(meeting.pieces[k], meeting.at[k]);
                (piece, (at * 1e6).round() as i64)
            });
            sides.sort_unstable();
            (sides, meeting.is_certified)
        })
        .collect();
    all.sort_unstable();
    all
}

fn is_alike(a: &[([(u32, i64); 2], bool)], b: &[([(u32, i64); 2], bool)]) -> bool {
    a.len() == b.len()
        && a.iter().zip(b).all(|(x, y)| {
            // What is not certified may be anywhere in its range.
            x.1 == y.1 && (0..2).all(|k| x.0[k].0 == y.0[k].0 && (!x.1 || (x.0[k].1 - y.0[k].1).abs() <= 2))
        })
}

/// All pairs of different parts that hulls of control points do not tell apart.
fn all_pairs(pieces: &Pieces<'_>) -> Vec<[u32; 4]> {
    let count = pieces.parts().len();
    let piece = |part: usize| pieces.parts()[part].piece;
    let points = |part: usize| pieces.part_points(part);
    let pairs = (0..count).flat_map(|i| (i + 1..count).map(move |j| [i, j]));
    pairs
        .filter(|&[i, j]| !is_apart(points(i), points(j), pieces.frame.resolution))
        .map(|[i, j]| [piece(i), piece(j), i as u32, j as u32])
        .collect()
}

/// Circles around one center, some of them squeezed or moved so that they meet others.
fn rings() -> impl Strategy<Value = Vec<Vec<[f64; 2]>>> {
    let change = prop_oneof![4 => Just([0.0; 3]), 1 => prop::array::uniform3(-0.03..0.03f64)];
    (prop::collection::vec((1..4usize, 0.0..7.0f64, change), 2..40), prop::array::uniform2(-2.0..2.0f64))
        .prop_map(|(rings, center)| {
            let ring =
                |(number, (n, turn, [x, y, squeeze])): (usize, (usize, f64, [f64; 3]))| -> Vec<[f64; 2]> {
                    let controls = circle([0.0; 2], 1.0 + 0.01 * number as f64, n, turn);
                    let place = |[p, q]: [f64; 2]| [center[0] + x + (1.0 + squeeze) * p, center[1] + y + q];
                    controls.into_iter().map(place).collect()
                };
            rings.into_iter().enumerate().map(ring).collect()
        })
}

proptest! {
    #[test]
    fn meetings_are_those_among_all_pairs(rings in rings(), depth in 0..3i32) {
        let arena = arena(4, &rings);
        let carriers = carriers(&[&arena]);
        let pieces = Pieces::of(&carriers, 0.25f64.powi(depth)).expect("they are finite");
        let [found, expected] = [Meetings::of_pieces(&pieces), Meetings::among(&pieces, all_pairs(&pieces))];
        prop_assert_eq!(found.points, expected.points);
        prop_assert_eq!(found.overlaps, expected.overlaps);
        prop_assert_eq!(found.exhausted, expected.exhausted);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn crossings_are_those_of_dense_polylines(a in any_piece(), b in any_piece()) {
        const COUNT: usize = 256;
        let count = a.len().max(b.len());
        let [p, q] = [&a, &b].map(|piece| bernstein::raised(piece, count));
        let found = of(&[&arena(count, &[closed_by_segment(&p)]), &arena(count, &[closed_by_segment(&q)])]);
        let [of_a, of_b] = [&a, &b].map(|piece| {
            (0..=COUNT).map(|i| bernstein::value(piece, i as f64 / COUNT as f64)).collect::<Vec<_>>()
        });
        let is_bent = |points: &[[f64; 2]], i: usize| {
            let side = |j: usize| minus(points[j + 1], points[j]);
            let (before, after) = (side(i.max(2) - 2), side((i + 2).min(COUNT - 1)));
            cross(before, after).abs() > 0.1 * before[0].hypot(before[1]) * after[0].hypot(after[1])
        };
        let mut crossings = Vec::new();
        for i in 0..COUNT {
            for j in 0..COUNT {
                let side = |from: [f64; 2], to: [f64; 2], of: [f64; 2]| cross(minus(to, from), minus(of, from));
                let (s, t) = ([of_a[i], of_a[i + 1]], [of_b[j], of_b[j + 1]]);
                if side(s[0], s[1], t[0]) * side(s[0], s[1], t[1]) < 0.0 && side(t[0], t[1], s[0]) * side(t[0], t[1], s[1]) < 0.0 {
                    let (d, e) = (minus(s[1], s[0]), minus(t[1], t[0]));
                    let is_clear = cross(d, e).abs() > 0.2 * d[0].hypot(d[1]) * e[0].hypot(e[1])
                        && !is_bent(&of_a, i) && !is_bent(&of_b, j);
                    crossings.push(([i, j], is_clear));
                }
            }
        }
        let found: Vec<_> = found.points.iter().filter(|meeting| meeting.pieces == [0, 2]).collect();
        let is_same = |[i, j]: [usize; 2], at: [f64; 2]| {
            (at[0] * COUNT as f64 - i as f64 - 0.5).abs() < 2.0 && (at[1] * COUNT as f64 - j as f64 - 0.5).abs() < 2.0
        };
        for &(place, _) in crossings.iter().filter(|(_, is_clear)| *is_clear) {
            prop_assert!(found.iter().any(|meeting| is_same(place, meeting.at)), "{place:?} {found:?}");
        }
        // Whatever is certified inside both pieces and crosses clearly is a crossing of the polylines, and one alone.
        for meeting in found.iter().filter(|meeting| meeting.is_certified) {
            let inner = meeting.at.iter().all(|&t| 0.02 < t && t < 0.98);
            let [i, j] = meeting.at.map(|t| ((t * COUNT as f64) as usize).min(COUNT - 1));
            let (d, e) = (minus(of_a[i + 1], of_a[i]), minus(of_b[j + 1], of_b[j]));
            let turn = cross(d, e).abs() / (d[0].hypot(d[1]) * e[0].hypot(e[1]));
            if inner && turn > 0.3 && !is_bent(&of_a, i) && !is_bent(&of_b, j) {
                prop_assert!(crossings.iter().any(|&(place, _)| is_same(place, meeting.at)), "{meeting:?} {crossings:?}");
                let same = found.iter().filter(|other| (0..2).all(|k| (other.at[k] - meeting.at[k]).abs() < 0.5 / COUNT as f64));
                prop_assert_eq!(same.count(), 1, "{:?}", found);
            }
        }
    }

    #[test]
    fn closed_curves_cross_an_even_number_of_times(
        order in prop_oneof![3 => Just(4usize), 1 => Just(6), 1 => Just(8)],
        coordinates in prop::collection::vec(-1.0..1.0f64, 2 * 2 * 3 * 7),
        scale in 0.01..1.0f64,
    ) {
        let count = 3 * (order - 1);
        let closed = |points: &[f64], scale: f64| {
            let mut controls: Vec<_> = points.chunks(2).take(count).map(|at| [at[0] * scale, at[1] * scale]).collect();
            controls.push(controls[0]);
            arena(order, &[controls])
        };
        let (a, b) = coordinates.split_at(coordinates.len() / 2);
        let found = of(&[&closed(a, 1.0), &closed(b, scale)]);
        // Touching has probability zero, and coming near it a small one.
        prop_assume!(found.overlaps.is_empty() && found.points.iter().all(|meeting| meeting.is_certified));
        let between: Vec<_> = found.points.iter().filter(|meeting| meeting.pieces[0] < 3 && meeting.pieces[1] >= 3).collect();
        prop_assert_eq!(between.len() % 2, 0, "{:?}", between);
    }

    #[test]
    fn nothing_depends_on_order_direction_scale_and_place(a in piece(4), b in piece(4), power in -40i32..40) {
        let [c, d] = [&a, &b].map(|piece| closed_by_segment(piece));
        let [first, second] = [&c, &d].map(|controls| arena(4, std::slice::from_ref(controls)));
        let plain = of(&[&first, &second]);
        let expected = summary(&plain, |piece, at| (piece, at));
        let swapped = summary(&of(&[&second, &first]), |piece, at| ((piece + 2) % 4, at));
        prop_assert!(is_alike(&expected, &swapped), "{:?} {:?}", expected, swapped);
        // Backward the segment comes first.
        let backward = arena(4, &[c.iter().rev().copied().collect()]);
        let reversed = of(&[&backward, &second]);
        let reversed = summary(&reversed, |piece, at| if piece < 2 { (1 - piece, 1.0 - at) } else { (piece, at) });
        prop_assert!(is_alike(&expected, &reversed), "{:?} {:?}", expected, reversed);
        let factor = 2f64.powi(power);
        let mapped = |controls: &[[f64; 2]], map: &dyn Fn(f64) -> f64| {
            arena(4, &[controls.iter().map(|point| point.map(map)).collect()])
        };
        let scaled = of(&[&mapped(&c, &|x| x * factor), &mapped(&d, &|x| x * factor)]);
        prop_assert_eq!(&scaled.overlaps, &plain.overlaps);
        prop_assert_eq!(scaled.points.len(), plain.points.len());
        for (x, y) in scaled.points.iter().zip(&plain.points) {
            prop_assert_eq!((x.pieces, x.at, x.parameters), (y.pieces, y.at, y.parameters));
            prop_assert_eq!(x.point, y.point.map(|x| x * factor));
        }
        let shift = 256.0;
        let moved = of(&[&mapped(&c, &|x| x + shift), &mapped(&d, &|x| x + shift)]);
        let moved = summary(&moved, |piece, at| (piece, at));
        prop_assert!(is_alike(&expected, &moved), "{:?} {:?}", expected, moved);
    }
}
