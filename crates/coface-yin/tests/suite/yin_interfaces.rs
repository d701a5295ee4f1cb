//! Interfaces of phases: what they bound, how they fit together and how they move.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use coface_algebra::{EdgeId, VertexId};
use coface_yin::{
    Curve, DirectedEdge, Flow, InterfaceEdge, InterfaceGraph, Order, RungeKutta, TrackingOptions,
};
use std::f64::consts::{PI, TAU};

const CENTER: [f64; 2] = [0.5, 0.75];
const RADIUS: f64 = 0.15;

fn on_circle(angle: f64) -> [f64; 2] {
    [CENTER[0] + RADIUS * angle.cos(), CENTER[1] + RADIUS * angle.sin()]
}

/// The disk as phase 0 and the rest as phase 1.
fn disk(spacing: f64, order: Order) -> InterfaceGraph {
    let count = (TAU * RADIUS / spacing).ceil() as u32 + 1;
    let points: Vec<[f64; 2]> =
        (0..count).map(|i| on_circle(TAU * f64::from(i) / f64::from(count))).collect();
    let edge = InterfaceEdge { ends: [0, 0], markers: points[1..].to_vec(), phases: [Some(0), Some(1)] };
    InterfaceGraph::new(&points[..1], &[edge], &[[DirectedEdge::along(EdgeId::new(0)); 2]], order).unwrap()
}

/// The disk in three sectors, phases 0, 1 and 2.
fn sectors(spacing: f64) -> InterfaceGraph {
    let mut vertices = vec![CENTER];
    let mut edges = Vec::new();
    for i in 0..3u32 {
        let [from, to] = [i, i + 1].map(|i| 0.2 + TAU * f64::from(i) / 3.0);
        vertices.push(on_circle(from));
        let count = (RADIUS / spacing).ceil() as u32 + 1;
        let way = |s: f64| [0, 1].map(|axis| CENTER[axis] + s * (on_circle(from)[axis] - CENTER[axis]));
        edges.push(InterfaceEdge {
            ends: [0, i + 1],
            markers: (1..count).map(|k| way(f64::from(k) / f64::from(count))).collect(),
            phases: [Some(i), Some((i + 2) % 3)],
        });
        let count = ((to - from) * RADIUS / spacing).ceil() as u32 + 1;
        edges.push(InterfaceEdge {
            ends: [i + 1, (i + 1) % 3 + 1],
            markers: (1..count)
                .map(|k| on_circle(from + (to - from) * f64::from(k) / f64::from(count)))
                .collect(),
            phases: [Some(i), None],
        });
    }
    let smooth = [0, 1, 2]
        .map(|i| [2 * i + 1, 2 * ((i + 1) % 3) + 1].map(|edge| DirectedEdge::along(EdgeId::new(edge))));
    InterfaceGraph::new(&vertices, &edges, &smooth, Order::CUBIC).unwrap()
}

fn circle_miss(curve: &Curve<'_>) -> f64 {
    let last = curve.knots()[curve.piece_count()];
    (0..=2000).fold(0.0, |miss: f64, i| {
        let [x, y] = curve.point(last * f64::from(i) / 2000.0);
        miss.max(((x - CENTER[0]).hypot(y - CENTER[1]) - RADIUS).abs())
    })
}

#[test]
fn sectors_share_their_radii_bit_for_bit() {
    let graph = sectors(0.01);
    assert_eq!(graph.phases(), [0, 1, 2]);
    assert_eq!(graph.junctions().collect::<Vec<_>>(), [0, 1, 2, 3].map(VertexId::new));
    // Three radii and the circle.
    assert_eq!(graph.trails().len(), 4);
    assert_eq!(graph.trails().iter().filter(|trail| trail.is_circuit()).count(), 1);
    let mut total = 0.0;
    for phase in 0..3 {
        let curves = graph.phase_curves(phase).unwrap();
        assert_eq!(curves.len(), 1);
        assert!((graph.phase_area(phase).unwrap() - PI * RADIUS * RADIUS / 3.0).abs() < 1e-8);
        total += graph.phase_area(phase).unwrap();
        // The radius on its right is on the left of the next phase, backward.
        let radius = graph.curve(EdgeId::from_u32(2 * phase)).controls();
        let backward: Vec<[f64; 2]> = radius.iter().rev().copied().collect();
        let has = |curve: &Curve<'_>, part: &[[f64; 2]]| {
            let twice: Vec<[f64; 2]> =
                curve.controls().iter().chain(&curve.controls()[1..]).copied().collect();
            twice.windows(part.len()).any(|window| window == part)
        };
        let before = &graph.phase_curves((phase + 2) % 3).unwrap()[0];
        assert!(has(&curves[0], radius) && has(before, &backward));
    }
    let [phases, border] = graph.covered_areas().unwrap();
    assert!((phases - total).abs() < 1e-16 && (phases - border).abs() < 1e-15);
    // The circle is one periodic spline: smooth at its junctions.
    for i in 0..3 {
        let (a, b) = (graph.curve(EdgeId::new(2 * i + 1)), graph.curve(EdgeId::new(2 * ((i + 1) % 3) + 1)));
        let end = a.knots()[a.piece_count()];
        let before = a.derivative(end, 2);
        let after = b.derivative(0.0, 2);
        assert!((before[0] - after[0]).hypot(before[1] - after[1]) < 1e-9);
    }
}

#[test]
fn phases_that_touch_in_a_point_have_simple_curves() {
    // Two triangles that touch at the origin are one phase: two curves, and the phase around them two as well.
    let vertices = [[0.0, 0.0]];
    let edge = |points: &[[f64; 2]]| InterfaceEdge {
        ends: [0, 0],
        markers: points.to_vec(),
        phases: [Some(7), Some(3)],
    };
    let edges = [edge(&[[1.0, -1.0], [1.0, 1.0]]), edge(&[[-1.0, 1.0], [-1.0, -1.0]])];
    let graph = InterfaceGraph::new(&vertices, &edges, &[], Order::LINEAR).unwrap();
    let areas = |phase| graph.phase_curves(phase).unwrap().iter().map(Curve::signed_area).collect::<Vec<_>>();
    assert_eq!(areas(7), [1.0, 1.0]);
    assert_eq!(areas(3), [-1.0, -1.0]);
}

#[test]
fn faults_of_interfaces_are_named() {
    let vertices = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    let edge = |ends, left, right| InterfaceEdge { ends, markers: vec![], phases: [left, right] };
    let good = [edge([0, 1], Some(0), None), edge([1, 2], Some(0), None), edge([2, 0], Some(0), None)];
    let fault = |edges: &[InterfaceEdge], pairs: &[[DirectedEdge; 2]]| {
        InterfaceGraph::new(&vertices, edges, pairs, Order::CUBIC).unwrap_err().to_string()
    };
    assert!(InterfaceGraph::new(&vertices, &good, &[], Order::CUBIC).is_ok());
    let mut edges = good.to_vec();
    edges[1].phases = [Some(1), None];
    assert!(fault(&edges, &[]).contains("phase 0 by the"), "{}", fault(&edges, &[]));
    edges[1] = edge([1, 5], Some(0), None);
    assert!(fault(&edges, &[]).contains("edge 1 ends at vertex 5"));
    edges[1] = edge([1, 2], Some(4), Some(4));
    assert!(fault(&edges, &[]).contains("edge 1 has the same phase"));
    edges = good.to_vec();
    edges.push(edge([0, 1], Some(1), Some(0)));
    assert!(fault(&edges, &[]).contains("leave vertex 0 in the same direction"));
    let along = |edge| DirectedEdge::along(EdgeId::new(edge));
    assert!(fault(&good, &[[along(0), along(2)]]).contains("edge 0 of smooth pair 0"));
    assert!(
        fault(&good, &[[along(0), along(1)], [along(0), DirectedEdge::against(EdgeId::new(0))]])
            .contains("smooth pair 1")
    );
    assert!(fault(&good, &[[along(9), along(1)]]).contains("names edge 9"));
    edges = good.to_vec();
    edges[0].markers = vec![[0.0, 0.0]];
    assert!(fault(&edges, &[]).contains("the trail from edge 0: points 0 and 1 are equal"));
}

#[test]
fn the_vortex_test_converges_at_order_four() {
    let flow = Flow::Vortex { period: 2.0 };
    let errors = [0.04, 0.02, 0.01].map(|spacing| {
        let graph = disk(spacing, Order::CUBIC);
        let mut options = TrackingOptions::new(2.0, spacing, spacing);
        let back = graph.advected(|p, t| flow.velocity(p, t), &options).unwrap();
        options = options.end(1.0);
        let half = graph.advected(|p, t| flow.velocity(p, t), &options).unwrap();
        assert!(half.counts().added() > 0);
        let exact = PI * RADIUS * RADIUS;
        [circle_miss(back.graph().curve(EdgeId::new(0))), (half.graph().phase_area(0).unwrap() - exact).abs()]
    });
    for kind in 0..2 {
        let rate = (errors[0][kind] / errors[2][kind]).log2() / 2.0;
        assert!(rate > 3.6, "rate {rate}: {errors:?}");
    }
    assert!(errors[2][0] < 1e-5, "{errors:?}");
}

#[test]
fn sectors_keep_their_areas_in_the_deformation_test() {
    let flow = Flow::Deformation { period: 2.0, vortices: 4 };
    let errors = [0.02, 0.01, 0.005].map(|spacing| {
        let graph = sectors(spacing);
        let options = TrackingOptions::new(0.5, 0.5 * spacing, spacing);
        let moved = graph.advected(|p, t| flow.velocity(p, t), &options).unwrap();
        assert_eq!((moved.graph().edge_count(), moved.vanished().len()), (6, 0));
        let [phases, border] = moved.graph().covered_areas().unwrap();
        assert!((phases - border).abs() < 1e-14);
        (0..3).fold(0.0, |miss: f64, phase| {
            miss.max((moved.graph().phase_area(phase).unwrap() - graph.phase_area(phase).unwrap()).abs())
        })
    });
    assert!((errors[1] / errors[2]).log2() > 3.4 && errors[2] < 5e-7, "{errors:?}");
}

#[test]
fn motions_move_and_schemes_have_their_orders() {
    let graph = disk(0.05, Order::CUBIC);
    let turned = |scheme: RungeKutta, time_step: f64| {
        let flow = Flow::Rotation { center: CENTER, speed: TAU };
        let options = TrackingOptions::new(1.0, time_step, 0.1).scheme(scheme);
        let moved = graph.advected(|p, t| flow.velocity(p, t), &options).unwrap();
        let [[ax, ay], [bx, by]] = [graph.vertices()[0], moved.graph().vertices()[0]];
        (ax - bx).hypot(ay - by)
    };
    for (scheme, step) in [
        (RungeKutta::Midpoint, 0.02),
        (RungeKutta::Classical, 0.02),
        (RungeKutta::Verner, 0.05),
        (RungeKutta::CooperVerner, 0.1),
    ] {
        let rate = (turned(scheme, step) / turned(scheme, 0.5 * step)).log2();
        assert!((rate - f64::from(scheme.order())).abs() < 0.4, "{scheme:?} {rate}");
    }
    // Sets of higher order take the scheme of their order.
    let fine = disk(0.05, Order::new(8).unwrap());
    let flow = Flow::Rotation { center: CENTER, speed: TAU };
    let moved = fine.advected(|p, t| flow.velocity(p, t), &TrackingOptions::new(1.0, 0.05, 0.1)).unwrap();
    let [[ax, ay], [bx, by]] = [fine.vertices()[0], moved.graph().vertices()[0]];
    assert!((ax - bx).hypot(ay - by) < 1e-8);
    // Backward in time to where it came from.
    let shift = Flow::Translation { velocity: [0.25, -0.5] };
    let options = TrackingOptions::new(0.0, 0.5, 0.1).start(3.0).end(1.0);
    let moved = graph.advected(|p, t| shift.velocity(p, t), &options).unwrap();
    assert_eq!(moved.counts().steps(), 4);
    let [x, y] = moved.graph().vertices()[0];
    assert!(
        (x - graph.vertices()[0][0] + 0.5).abs() < 1e-15 && (y - graph.vertices()[0][1] - 1.0).abs() < 1e-15
    );
}

#[test]
fn what_shrinks_vanishes_with_a_report() {
    let graph = disk(0.02, Order::CUBIC);
    let shrinking = |p: [f64; 2], _: f64| [0, 1].map(|axis| CENTER[axis] - p[axis]);
    let moved = graph.advected(shrinking, &TrackingOptions::new(8.0, 0.1, 0.02)).unwrap();
    assert_eq!(moved.graph().edge_count(), 0);
    let &[(time, Some(edge))] = moved.vanished() else { panic!("one edge vanishes") };
    assert_eq!(edge, EdgeId::new(0));
    // The length is 2 pi r exp(-t), below three tenths of the spacing from about 5.05; that of the polygon a little earlier.
    let right = (TAU * RADIUS / 0.006).ln();
    assert!((right - 0.3..right + 0.1).contains(&time), "{time} {right}");
    let early = graph.advected(shrinking, &TrackingOptions::new(3.0, 0.1, 0.02)).unwrap();
    let curve = early.graph().curve(EdgeId::new(0));
    assert!(
        early.counts().removed() > 0 && (curve.length(1e-9) - TAU * RADIUS * (-3.0f64).exp()).abs() < 1e-5
    );
}

#[test]
fn bad_options_and_velocities_are_refused() {
    let graph = disk(0.05, Order::CUBIC);
    let rest = |_: [f64; 2], _: f64| [0.0; 2];
    for options in [
        TrackingOptions::new(1.0, 0.0, 0.1),
        TrackingOptions::new(f64::NAN, 0.1, 0.1),
        TrackingOptions::new(1.0, 0.1, -0.1),
        TrackingOptions::new(1.0, 0.1, 0.1).least_ratio(0.9),
    ] {
        assert!(graph.advected(rest, &options).is_err());
    }
    let options = TrackingOptions::new(1.0, 0.1, 0.1);
    let unknown = |_: [f64; 2], _: f64| [f64::NAN; 2];
    assert!(graph.advected(unknown, &options).unwrap_err().to_string().contains("no finite point"));
    let torn = |p: [f64; 2], _: f64| if p[0] > 0.5 { [9.0, 0.0] } else { [-9.0, 0.0] };
    assert!(graph.advected(torn, &options).unwrap_err().to_string().contains("move apart"));
}
