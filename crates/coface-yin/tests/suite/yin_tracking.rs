//! Yin sets that move, and interfaces of Yin sets.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use coface_yin::{
    Curve, EndCondition, Flow, InterfaceGraph, KnotIndex, Order, RungeKutta, TrackingOptions, Verification,
    YinSet,
};
use std::f64::consts::{PI, TAU};

fn circle(center: [f64; 2], radius: f64, count: usize, order: Order) -> Curve<'static> {
    Curve::circle(center, radius, count, order).unwrap()
}

#[test]
fn a_ring_with_an_island_keeps_its_forest_and_its_area() {
    let flow = Flow::Vortex { period: 2.0 };
    let errors = [60, 120].map(|count| {
        let center = [0.5, 0.75];
        let curves = [
            circle(center, 0.15, count, Order::CUBIC),
            circle(center, 0.1, count, Order::CUBIC).reversed(),
            circle(center, 0.05, count, Order::CUBIC),
        ];
        let set = YinSet::new(&curves).unwrap();
        let spacing = TAU * 0.15 / count as f64 * 1.05;
        let options = TrackingOptions::new(1.0, 0.5 * spacing, spacing);
        let moved = set.advected(|p, t| flow.velocity(p, t), &options).unwrap();
        assert!(moved.counts().added() > 0 && moved.vanished().is_empty());
        assert_eq!(moved.curves(), [0, 1, 2]);
        let moved = moved.into_set();
        assert_eq!(moved.validate().unwrap(), None);
        assert_eq!(moved.forest(), set.forest());
        (moved.area().unwrap() - set.area().unwrap()).abs()
    });
    assert!((errors[0] / errors[1]).log2() > 3.4 && errors[1] < 1e-6, "{errors:?}");
}

#[test]
fn kinks_stay_kinks() {
    let square: Vec<[f64; 2]> = (0..40)
        .map(|i| (i / 10, f64::from(i % 10) / 10.0))
        .map(|(side, s)| match side {
            0 => [s, 0.0],
            1 => [1.0, s],
            2 => [1.0 - s, 1.0],
            _ => [0.0, 1.0 - s],
        })
        .collect();
    let corners = vec![0, 10, 20, 30];
    let set = YinSet::fit(&[square], &[corners], Order::CUBIC, &EndCondition::NotAKnot).unwrap();
    let flow = Flow::Rotation { center: [0.5, 0.5], speed: 1.0 };
    let moved =
        set.advected(|p, t| flow.velocity(p, t), &TrackingOptions::new(PI / 2.0, 0.01, 0.11)).unwrap();
    let moved = moved.set();
    let kinks: Vec<KnotIndex> = moved.kinks().iter().map(|(knot, _)| knot).collect();
    assert_eq!(kinks.len(), 4);
    // A quarter turn leads each corner to the next one.
    for (at, kink) in kinks.iter().enumerate() {
        let [x, y] = moved.curve(0).knot_point(kink.knot as usize);
        let [u, v] = set.curve(0).knot_point(10 * ((at + 1) % 4));
        assert!((x - u).hypot(y - v) < 1e-9);
    }
    assert!((moved.area().unwrap() - 1.0).abs() < 1e-9);
}

#[test]
fn an_island_that_shrinks_away_is_reported() {
    // Points flow to the origin inside of radius 1/2 and rest outside of it.
    let sink = |[x, y]: [f64; 2], _: f64| {
        let r = x.hypot(y);
        let speed = if r < 0.5 { (0.5 - r) * 4.0 } else { 0.0 };
        [-speed * x, -speed * y]
    };
    let curves =
        [circle([0.0, 0.0], 1.0, 64, Order::CUBIC), circle([0.0, 0.0], 0.3, 32, Order::CUBIC).reversed()];
    let set = YinSet::new(&curves).unwrap();
    let moved = set.advected(sink, &TrackingOptions::new(6.0, 0.05, 0.1)).unwrap();
    assert_eq!((moved.set().curve_count(), moved.curves()), (1, &[0u32][..]));
    assert_eq!((moved.vanished().len(), moved.vanished()[0].curve()), (1, 1));
    assert!(moved.vanished()[0].length() < 0.05);
    assert!((moved.set().area().unwrap() - PI).abs() < 1e-5);
    assert_eq!(moved.set().validate().unwrap(), None);
}

#[test]
fn sets_that_share_boundary_become_phases() {
    // A regular 48-gon, its left and right halves as phases 0 and 1, and a frame around it.
    let point = |i: i64| {
        let (x, y) = coface_geometry::Angle::turns(i, 48).cosine_and_sine();
        [x, y]
    };
    let ring = |points: Vec<[f64; 2]>| {
        let closed: Vec<[f64; 2]> = points.iter().copied().chain([points[0]]).collect();
        Curve::polyline(&closed).unwrap()
    };
    let right = ring((-12..=12).map(point).chain([[0.0, 0.5], [0.0, 0.0], [0.0, -0.5]]).collect());
    let left = ring((12..=36).map(point).chain([[0.0, -0.5], [0.0, 0.0], [0.0, 0.5]]).collect());
    let frame = ring(vec![[-2.0, -2.0], [2.0, -2.0], [2.0, 2.0], [-2.0, 2.0]]);
    let hole = ring((0..48).map(point).collect()).reversed();
    let sets =
        [YinSet::new(&[left]).unwrap(), YinSet::new(&[right]).unwrap(), YinSet::new(&[frame, hole]).unwrap()];
    let graph = InterfaceGraph::of_sets(&sets, Order::CUBIC, 0.3).unwrap();
    assert_eq!((graph.edge_count(), graph.junctions().count()), (4, 2));
    // The circle goes on smoothly through both junctions: one periodic spline, with the accuracy of that.
    let areas: Vec<f64> = (0..3).map(|phase| graph.phase_area(phase).unwrap()).collect();
    let disk = circle([0.0, 0.0], 1.0, 48, Order::CUBIC).signed_area();
    assert!((areas[0] + areas[1] - disk).abs() < 1e-14 && (areas[0] - areas[1]).abs() < 1e-14);
    let [phases, border] = graph.covered_areas().unwrap();
    assert!((phases - border).abs() < 1e-13);
    // Each phase is a Yin set.
    for phase in 0..3 {
        let set = graph.phase_set(phase).unwrap();
        assert_eq!(set.area().unwrap(), graph.phase_area(phase).unwrap());
        assert_eq!(set.curve_count(), [1, 1, 2][phase as usize]);
    }
    // Without smoothness the halves of the circle end in kinks.
    let kinked = InterfaceGraph::of_sets(&sets, Order::CUBIC, -1.0).unwrap();
    assert_eq!(kinked.trails().len(), 4);
    // Sets that overlap are refused; a vertex of one on a segment of the other is no fault.
    let square = ring(vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
    let shifted = ring(vec![[1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 0.5]]);
    let set = |curve: &Curve<'_>| YinSet::new(std::slice::from_ref(curve)).unwrap();
    let fault = |sets: &[YinSet]| InterfaceGraph::of_sets(sets, Order::CUBIC, 0.0).unwrap_err().to_string();
    let said = fault(&[set(&square), set(&square)]);
    assert!(said.contains("sets 0 and 1 overlap at (0, 0), in an area of 1"), "{said}");
    let shared = InterfaceGraph::of_sets(&[set(&square), set(&shifted)], Order::LINEAR, -1.0).unwrap();
    assert_eq!((shared.edge_count(), shared.junctions().count()), (3, 2));
}

/// How far the curve of a disk is from its circle after a mild vortex there and back, with markers that come apart unevenly on the way.
fn mild_vortex(order: Order, scheme: RungeKutta, h: f64) -> f64 {
    let (center, radius) = ([0.5, 0.75], 0.15);
    let count = (TAU * radius / h).ceil() as usize + 1;
    let disk = YinSet::new(&[Curve::circle(center, radius, count, order).unwrap()]).unwrap();
    let flow = Flow::Vortex { period: 1.0 };
    let options = TrackingOptions::new(1.0, h, h).scheme(scheme).verification(Verification::End);
    let moved = disk.advected(|p, t| flow.velocity(p, t), &options).unwrap();
    assert!(moved.counts().added() > 0);
    let curve = moved.set().curve(0);
    let places = curve
        .knots()
        .windows(2)
        .flat_map(|pair| (0..8).map(|i| pair[0] + (pair[1] - pair[0]) * f64::from(i) / 8.0));
    let miss = |[x, y]: [f64; 2]| ((x - center[0]).hypot(y - center[1]) - radius).abs();
    places.map(|t| miss(curve.point(t))).fold(0.0, f64::max)
}

/// Splines with chords as parameters would be of order four only, whatever their degree.
#[test]
fn boundaries_of_high_order_converge_at_their_order() {
    for (order, scheme, least, most) in [
        (4, RungeKutta::Classical, 3.3, 1e-6),
        (6, RungeKutta::Verner, 5.6, 1e-8),
        (8, RungeKutta::CooperVerner, 7.6, 1e-11),
    ] {
        let misses = [0.04, 0.02, 0.01].map(|h| mild_vortex(Order::new(order).unwrap(), scheme, h));
        // Down to where rounding begins.
        let last = if misses[2] < 1e-12 { 1 } else { 2 };
        let found = (misses[0] / misses[last]).log2() / last as f64;
        assert!(found > least && misses[2] < most, "{order}: {found} {misses:?}");
    }
}

/// Markers by turning are nearer together where the boundary bends, as far as the least distance leaves room.
#[test]
fn markers_by_turning_follow_curvature() {
    // Half a period of a strong vortex: a thread with sharp ends.
    let flow = Flow::Vortex { period: 4.0 };
    let disk = YinSet::new(&[Curve::circle([0.5, 0.75], 0.15, 48, Order::CUBIC).unwrap()]).unwrap();
    let moved = |most_turn: Option<f64>| {
        let options = TrackingOptions::new(2.0, 0.02, 0.04).most_turn(most_turn);
        disk.advected(|p, t| flow.velocity(p, t), &options).unwrap().into_set()
    };
    let (plain, turned) = (moved(None), moved(Some(0.2)));
    // The longest gap beside a marker at which the polygon turns by more.
    let widest = |set: &YinSet| {
        let curve = set.curve(0);
        let count = curve.piece_count();
        let corner = |i: usize| curve.knot_point(i % count);
        let way = |i: usize| [0, 1].map(|k| corner(i + 1)[k] - corner(i)[k]);
        (0..count)
            .map(|i| (way(i), way(i + 1)))
            .filter(|([a, b], [c, d])| (a * d - b * c).atan2(a * c + b * d).abs() > 0.2)
            .map(|([a, b], [c, d])| a.hypot(b).max(c.hypot(d)))
            .fold(0.0, f64::max)
    };
    let [knots, more] = [&plain, &turned].map(|set| set.curve(0).piece_count());
    assert!(knots < more && more < 2 * knots, "{knots} {more}");
    // Markers are added until two and a half of the least distances leave no room.
    let [before, after] = [widest(&plain), widest(&turned)];
    assert!(before > 0.02 && after <= 2.5 * 0.1 * 0.04 + 0.1 * 0.04, "{before} {after}");
    // An angle that is none is refused.
    let options = TrackingOptions::new(1.0, 0.1, 0.1).most_turn(0.0);
    let error = disk.advected(|p, t| flow.velocity(p, t), &options).unwrap_err();
    assert!(error.to_string().contains("turn by at most 0") && error.cure().is_some(), "{error}");
}
