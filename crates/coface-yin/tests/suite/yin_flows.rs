//! Benchmarks of interface tracking: flows that come back, measured by the area of what is in the wrong place.
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a helper of a test that cannot go on is the test failing"
)]

use coface_yin::{Curve, Flow, MarkerParameters, Order, RungeKutta, TrackingOptions, Verification, YinSet};
use std::f64::consts::TAU;

/// How far a disk is from itself after a flow there and back.
#[derive(Debug)]
struct Miss {
    /// The differences of the areas at the middle and at the end.
    areas: [f64; 2],
    /// The area of the symmetric difference of the sets at the beginning and at the end.
    geometric: f64,
}

fn area(set: &YinSet) -> f64 {
    set.area().unwrap()
}

fn there_and_back(flow: Flow, period: f64, center: [f64; 2], step: f64, spacing: f64) -> Miss {
    let count = (TAU * 0.15 / spacing).ceil() as usize + 1;
    let disk = YinSet::new(&[Curve::circle(center, 0.15, count, Order::CUBIC).unwrap()]).unwrap();
    // What is rounded off in time is far below what is in space.
    let mut options = TrackingOptions::new(0.5 * period, step, spacing)
        .scheme(RungeKutta::CooperVerner)
        .verification(Verification::End);
    let half = disk.advected(|p, t| flow.velocity(p, t), &options).unwrap();
    options = options.start(0.5 * period).end(period);
    let back = half.set().advected(|p, t| flow.velocity(p, t), &options).unwrap().into_set();
    Miss {
        areas: [area(half.set()) - area(&disk), area(&back) - area(&disk)],
        geometric: difference(&back, &disk),
    }
}

/// The area of the symmetric difference, exactly of polylines with forty chords for each piece where the curves run so near each other
/// that the resolution does not tell how they cross.
fn difference(a: &YinSet, b: &YinSet) -> f64 {
    a.symmetric_difference(b).map_or_else(
        |_| {
            let [a, b] = [a, b].map(|set| {
                let curve = set.curve(0);
                let count = 40 * curve.piece_count();
                let last = curve.knots()[curve.piece_count()];
                let ring: Vec<[f64; 2]> =
                    (0..=count).map(|i| curve.point(last * (i % count) as f64 / count as f64)).collect();
                YinSet::new(&[Curve::polyline(&ring).unwrap()]).unwrap()
            });
            area(&a.symmetric_difference(&b).unwrap())
        },
        |set| area(&set),
    )
}

/// The mean order over two halvings of the spacing.
fn check_order(misses: &[Miss; 3]) {
    let order = (misses[0].geometric / misses[2].geometric).log2() / 2.0;
    assert!(order > 3.5, "order {order}: {misses:?}");
    // Areas cannot differ by more than what is in the wrong place.
    assert!(misses.iter().all(|miss| miss.areas[1].abs() <= 1.01 * miss.geometric), "{misses:?}");
}

#[test]
fn the_deformation_test_converges_at_order_four() {
    let flow = Flow::Deformation { period: 2.0, vortices: 4 };
    let misses = [0.01, 0.005, 0.0025].map(|h| there_and_back(flow, 2.0, [0.5, 0.5], 0.02, h));
    check_order(&misses);
    assert!(misses[2].geometric < 1e-7);
}

#[test]
fn the_vortex_with_period_four_converges_at_order_four() {
    let flow = Flow::Vortex { period: 4.0 };
    let misses = [0.02, 0.01, 0.005].map(|h| there_and_back(flow, 4.0, [0.5, 0.75], 0.04, h));
    check_order(&misses);
    assert!(misses[2].geometric < 3e-7);
}

#[test]
fn the_vortex_with_period_eight_converges_at_order_four() {
    let flow = Flow::Vortex { period: 8.0 };
    let misses = [0.02, 0.01, 0.005].map(|h| there_and_back(flow, 8.0, [0.5, 0.75], 0.04, h));
    check_order(&misses);
    assert!(misses[2].geometric < 3e-6);
}

/// The area between a disk with a radius of 0.15 and what a flow there and back has made of it, by the distances of its points from the
/// circle: eight of each piece.
fn miss_of_order(order: usize, flow: Flow, period: f64, center: [f64; 2], count: usize) -> f64 {
    let disk =
        YinSet::new(&[Curve::circle(center, 0.15, count, Order::new(order).unwrap()).unwrap()]).unwrap();
    // Time is fine enough not to be seen.
    let options = TrackingOptions::new(period, 0.01, 1.05 * TAU * 0.15 / count as f64)
        .scheme(RungeKutta::CooperVerner)
        .least_ratio(0.01)
        .verification(Verification::End);
    let back = disk.advected(|p, t| flow.velocity(p, t), &options).unwrap();
    let curve = back.set().curve(0).into_owned();
    let points = (0..curve.piece_count()).flat_map(|piece| {
        let [from, to] = [curve.knots()[piece], curve.knots()[piece + 1]];
        (0..8).map(move |i| from + (to - from) * f64::from(i) / 8.0)
    });
    let points: Vec<[f64; 2]> = points.map(|parameter| curve.point(parameter)).collect();
    let far = |at: usize| {
        let [x, y] = points[at % points.len()];
        (x - center[0]).hypot(y - center[1]) - 0.15
    };
    let strip = |at: usize| {
        let [[x, y], [u, v]] = [points[at], points[(at + 1) % points.len()]];
        0.5 * (far(at).abs() + far(at + 1).abs()) * (u - x).hypot(v - y)
    };
    (0..points.len()).map(strip).sum()
}

/// Markers keep their parameters in orders 6 and 8: each order is seen, and higher ones are better with as many markers.
#[test]
fn each_order_is_seen_in_flows_there_and_back() {
    let cases = [
        (Flow::Vortex { period: 4.0 }, 4.0, [0.5, 0.75], [40, 80, 160]),
        (Flow::Vortex { period: 8.0 }, 8.0, [0.5, 0.75], [60, 120, 240]),
        (Flow::Deformation { period: 2.0, vortices: 4 }, 2.0, [0.5, 0.5], [76, 152, 304]),
    ];
    for (flow, period, center, counts) in cases {
        let [fourth, sixth, eighth] =
            [4, 6, 8].map(|order| counts.map(|count| miss_of_order(order, flow, period, center, count)));
        println!("{flow:?}\n{fourth:?}\n{sixth:?}\n{eighth:?}");
        for (misses, least) in [(sixth, 5.5), (eighth, 7.0)] {
            // The mean over two halvings.
            let rate = 0.5 * (misses[0] / misses[2]).log2();
            assert!(rate > least, "{flow:?}: {rate} {misses:?}");
        }
        for at in 0..3 {
            assert!(fourth[at] > 100.0 * sixth[at] && sixth[at] > 2.0 * eighth[at], "{flow:?}");
        }
        assert!(eighth[2] < 1e-12, "{flow:?}");
    }
}

/// Cubic splines whose markers keep their parameters are nearer by far than those of the published method, and go on where these cross.
#[test]
fn cubic_splines_that_keep_their_parameters() {
    let flow = Flow::Vortex { period: 8.0 };
    let disk = YinSet::new(&[Curve::circle([0.5, 0.75], 0.15, 77, Order::CUBIC).unwrap()]).unwrap();
    let options =
        TrackingOptions::new(8.0, 0.03125, 0.0125).least_ratio(0.01).verification(Verification::End);
    let moved = |parameters| {
        let options = options.scheme(RungeKutta::CooperVerner).parameters(parameters);
        disk.advected(|p, t| flow.velocity(p, t), &options)
    };
    assert!(moved(MarkerParameters::Lengths).is_err());
    let found = moved(MarkerParameters::Kept).unwrap().set().comparison(&disk).unwrap();
    assert!(found.area_xor() < 1e-6, "{found:?}");
}

#[test]
fn velocities_of_all_points_at_once_give_the_same_bits() {
    let flow = Flow::Vortex { period: 2.0 };
    let disk = YinSet::new(&[Curve::circle([0.5, 0.75], 0.15, 40, Order::CUBIC).unwrap()]).unwrap();
    for scheme in [RungeKutta::Midpoint, RungeKutta::Classical, RungeKutta::Verner, RungeKutta::CooperVerner]
    {
        let options = TrackingOptions::new(0.5, 0.05, 0.02).scheme(scheme);
        let single = disk.advected(|p, t| flow.velocity(p, t), &options).unwrap();
        let mut calls = std::cell::Cell::new(0usize);
        let together = |points: &[[f64; 2]], t: f64| {
            calls.set(calls.get() + 1);
            points.iter().map(|&p| flow.velocity(p, t)).collect()
        };
        let all = disk.advected_together(together, &options).unwrap();
        assert_eq!(all.counts(), single.counts());
        assert!(all.set() == single.set(), "{scheme:?}");
        // Not one call a point: stages and rounds of ten steps.
        assert!(*calls.get_mut() < 2000, "{calls:?}");
    }
    // Too few velocities are no velocities.
    let options = TrackingOptions::new(0.5, 0.05, 0.02);
    let error = disk.advected_together(|_, _| vec![[0.0; 2]], &options).unwrap_err();
    assert!(error.to_string().contains("leads to no finite point"), "{error}");
}
