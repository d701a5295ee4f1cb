//! Guide 20: interfaces between several phases: triple points, areas, kinks, and how they move.
//!
//! Run with `cargo run -p coface --example 20_interfaces`.

use coface::EdgeId;
use coface::yin::{
    Curve, Flow, InterfaceEdge, InterfaceGraph, InterfaceOptions, Order, Overlaps, TrackingOptions, YinSet,
};
use std::f64::consts::PI;

fn main() -> Result<(), coface::Error> {
    // A unit square of two phases: 0 on the left of the line x = 1/2, 1 on its right. Edges have a phase on each side, or none, which is outside.
    let vertices = [[0.5, 0.0], [0.5, 1.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0], [0.0, 0.0]];
    let edge = |ends, left, right| InterfaceEdge { ends, markers: vec![], phases: [left, right] };
    let edges = [
        edge([0, 1], Some(0), Some(1)),
        edge([0, 3], Some(1), None),
        edge([3, 2], Some(1), None),
        edge([2, 1], Some(1), None),
        edge([1, 4], Some(0), None),
        edge([4, 5], Some(0), None),
        edge([5, 0], Some(0), None),
    ];
    let graph = InterfaceGraph::new(&vertices, &edges, &[], Order::LINEAR)?;
    assert_eq!(graph.phases(), [0, 1]);
    assert_eq!((graph.phase_area(0)?, graph.phase_area(1)?), (0.5, 0.5));
    assert_eq!(graph.phases_of(EdgeId::new(0)), [Some(0), Some(1)]);
    // At the triple points three edges meet.
    assert_eq!((0..6).filter(|&v| graph.degree(coface::VertexId::new(v)) == 3).count(), 2);
    // The phases do not overlap and leave no gap.
    assert_eq!(graph.fault()?, None);

    // From sets: two squares that overlap in a unit square. Without a rule that is refused; with one, the later set keeps what both claim.
    let square = Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?;
    let sets = [YinSet::new(&[square.translated([1.0, 1.0])])?, YinSet::new(&[square])?];
    let options = InterfaceOptions::new(Order::LINEAR);
    assert!(InterfaceGraph::of_sets_with(&sets, &options.overlaps(Overlaps::Refused)).is_err());
    let last = InterfaceGraph::of_sets_with(&sets, &options.overlaps(Overlaps::ToTheLast))?;
    assert_eq!((last.phase_area(0)?, last.phase_area(1)?), (3.0, 4.0));
    // A phase is a Yin set again.
    assert_eq!(last.phase_set(0)?.area(), Some(3.0));

    // A flow carries all markers along: after a quarter turn about the center of the square, phase 0, which was the left half, is the lower one.
    let turn = Flow::Rotation { center: [0.5, 0.5], speed: PI / 2.0 };
    let velocity = |point: [f64; 2], time: f64| turn.velocity(point, time);
    let moved = graph.advected(velocity, &TrackingOptions::new(1.0, 0.05, 0.2))?;
    let turned = moved.graph();
    assert!((turned.phase_area(0)? - 0.5).abs() < 1e-6 && (turned.phase_area(1)? - 0.5).abs() < 1e-6);
    let [low, high] = turned.phase_set(0)?.bounding_box().expect("it is bounded");
    assert!((high[1] - 0.5).abs() < 1e-6 && low[1].abs() < 1e-6 && (high[0] - 1.0).abs() < 1e-6);
    // Nothing vanished, no event, 20 steps.
    assert!(moved.vanished().is_empty() && moved.events().is_empty());
    assert_eq!(moved.counts().steps(), 20);
    Ok(())
}
