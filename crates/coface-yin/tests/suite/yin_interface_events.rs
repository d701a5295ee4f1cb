//! Changes of the topology of interfaces that move, with times that are known.
#![allow(clippy::unwrap_used, reason = "a failing test shows where")]

use coface_algebra::EdgeId;
use coface_arrange::boolean::InsideRule;
use coface_yin::{
    Curve, Flow, InterfaceEvent, InterfaceEventKind, InterfaceGraph, InterfaceOptions, OnContact, Order,
    Overlaps, TrackedGraph, TrackingOptions, YinSet,
};
use std::f64::consts::TAU;

fn disk(center: [f64; 2], radius: f64) -> YinSet {
    YinSet::new(&[Curve::circle(center, radius, 64, Order::CUBIC).unwrap()]).unwrap()
}

fn polygon(points: &[[f64; 2]]) -> YinSet {
    let closed: Vec<[f64; 2]> = points.iter().copied().chain([points[0]]).collect();
    YinSet::new(&[Curve::polyline(&closed).unwrap()]).unwrap()
}

/// Left, right, above and below; left and right have the edge from (0, -1/2) to (0, 1/2) in common.
fn four() -> InterfaceGraph {
    let sets = [
        polygon(&[[0.0, -0.5], [0.0, 0.5], [-2.0, 2.0], [-2.0, -2.0]]),
        polygon(&[[0.0, 0.5], [0.0, -0.5], [2.0, -2.0], [2.0, 2.0]]),
        polygon(&[[0.0, 0.5], [2.0, 2.0], [-2.0, 2.0]]),
        polygon(&[[0.0, -0.5], [-2.0, -2.0], [2.0, -2.0]]),
    ];
    InterfaceGraph::of_sets(&sets, Order::LINEAR, -1.0).unwrap()
}

fn kinds(moved: &TrackedGraph) -> Vec<InterfaceEventKind> {
    moved.events().iter().map(InterfaceEvent::kind).collect()
}

#[test]
fn junctions_meet_when_the_edge_between_them_is_too_short() {
    // The edge has the length exp(-t); markers are at least 0.05 apart.
    for (step, tolerance) in [(0.25, 1e-4), (0.05, 1e-6)] {
        let options = TrackingOptions::new(4.0, step, 0.5).events(true).event_tolerance(tolerance);
        let moved = four().advected(|[_, y], _| [0.0, -y], &options).unwrap();
        let [event] = moved.events() else { panic!("{:?}", moved.events()) };
        assert_eq!((event.kind(), event.counts()), (InterfaceEventKind::JunctionsMeet, None));
        assert_eq!(event.phases(), [0, 1, 2, 3]);
        let exact = (1.0f64 / 0.05).ln();
        assert!((event.time() - exact).abs() < 2.0 * tolerance + 1e-4 * step, "{} and {exact}", event.time());
        assert!(event.place().iter().all(|x| x.abs() < 1e-12));
        // The edge is kept.
        assert_eq!(moved.graph().edge_count(), four().edge_count());
    }
}

#[test]
fn an_edge_that_stays_short_is_told_once_and_again_after_it_was_long() {
    // Its length is exp(-4 sin(t)).
    let squeeze = |[_, y]: [f64; 2], t: f64| [0.0, -4.0 * t.cos() * y];
    let options = TrackingOptions::new(2.0 * TAU, 0.05, 0.5).events(true);
    let moved = four().advected(squeeze, &options).unwrap();
    assert_eq!(kinds(&moved), [InterfaceEventKind::JunctionsMeet; 2]);
    let times: Vec<f64> = moved.events().iter().map(InterfaceEvent::time).collect();
    assert!((times[1] - times[0] - TAU).abs() < 1e-3, "{times:?}");
    // What is short at the beginning is no change.
    let options = TrackingOptions::new(1.0, 0.1, 11.0).events(true);
    assert!(four().advected(|_, _| [1.0, 0.0], &options).unwrap().events().is_empty());
}

#[test]
fn phases_components_and_holes_vanish_at_their_times() {
    // Disks of one phase in a disk of another, which has a hole that is in none.
    let (small, smaller, hole) = (disk([-1.0, 0.0], 0.5), disk([1.0, 0.0], 0.25), disk([0.0, 1.0], 0.125));
    let inner = small.join(&smaller).unwrap();
    let outer = disk([0.0, 0.0], 4.0).difference(&inner).unwrap().difference(&hole).unwrap();
    let graph = InterfaceGraph::of_sets(&[inner, outer], Order::CUBIC, -1.0).unwrap();
    let options = TrackingOptions::new(4.2, 0.05, 0.1).least_ratio(0.1).events(true).event_tolerance(1e-5);
    let moved = graph.advected(|[x, y], _| [-x, -y], &options).unwrap();
    use InterfaceEventKind::{ComponentVanishes, HoleVanishes, PhaseVanishes};
    assert_eq!(kinds(&moved), [HoleVanishes, ComponentVanishes]);
    let [first, second] = moved.events() else { unreachable!() };
    // The hole of the other phase goes with the component, and is no event.
    assert_eq!((first.phases(), first.counts()), (&[1][..], Some([[1, 3], [1, 2]])));
    assert_eq!((second.phases(), second.counts()), (&[0][..], Some([[2, 0], [1, 0]])));
    // Circumferences fall by exp(-t); three of the least distances are too short, and so are less than four knots.
    for (event, radius) in [(first, 0.125), (second, 0.25)] {
        let exact = (TAU * radius / 0.03f64).ln();
        assert!((exact - 0.4..exact).contains(&event.time()), "{} and {exact}", event.time());
    }
    let far = TrackingOptions::new(7.5, 0.05, 0.1).least_ratio(0.1).events(true);
    let moved = graph.advected(|[x, y], _| [-x, -y], &far).unwrap();
    assert_eq!(kinds(&moved), [HoleVanishes, ComponentVanishes, PhaseVanishes, PhaseVanishes]);
    assert_eq!(moved.events()[3].phases(), [1]);
    assert_eq!(moved.vanished().len(), 4);
    // Without events the same goes, with the times of steps.
    let quiet = TrackingOptions::new(7.5, 0.05, 0.1).least_ratio(0.1);
    let same = graph.advected(|[x, y], _| [-x, -y], &quiet).unwrap();
    assert!(same.events().is_empty() && same.vanished().len() == 4);
}

#[test]
fn times_do_not_depend_on_the_steps() {
    let times = |step: f64| {
        let options = TrackingOptions::new(4.0, step, 0.5).events(true).event_tolerance(1e-6);
        let moved = four().advected(|[_, y], _| [0.0, -y], &options).unwrap();
        moved.events().iter().map(InterfaceEvent::time).collect::<Vec<f64>>()
    };
    let all: Vec<Vec<f64>> = [0.01, 0.03, 0.07, 0.11].map(times).to_vec();
    assert!(all.iter().all(|own| own.len() == 1 && (own[0] - all[0][0]).abs() < 1e-5), "{all:?}");
}

#[test]
fn rigid_motions_of_interfaces_have_no_events() {
    let turn = Flow::Rotation { center: [1.0, 0.5], speed: 1.0 };
    let options = TrackingOptions::new(TAU, 0.05, 0.5).events(true);
    assert!(four().advected(|p, t| turn.velocity(p, t), &options).unwrap().events().is_empty());
}

#[test]
fn edges_that_are_cut_and_pasted_change_phases() {
    // Two disks of one phase, which a flow that jumps at x = 0 brings onto each other at time 0.2.
    let pair = disk([-1.2, 0.0], 1.0).join(&disk([1.2, 0.0], 1.0)).unwrap();
    let options = InterfaceOptions::new(Order::CUBIC).overlaps(Overlaps::Refused);
    let graph = InterfaceGraph::of_sets_with(&[pair], &options).unwrap();
    let onto = |[x, _]: [f64; 2], _: f64| [-x.signum(), 0.0];
    let options = TrackingOptions::new(0.3, 0.1, 0.1).events(true);
    let refused = graph.advected(onto, &options).unwrap_err();
    assert!(refused.message().contains("edges around phase 0 cross"), "{refused}");
    let moved = graph.advected(onto, &options.repair(InsideRule::Nonzero)).unwrap();
    let event = &moved.events()[0];
    assert_eq!((event.kind(), event.phases()), (InterfaceEventKind::PhaseMerges, &[0][..]));
    assert!(event.counts().is_some_and(|[before, after]| before == [2, 0] && after[0] == 1));
    assert!((event.time() - 0.2).abs() < 5e-3, "{event:?}");
}

/// Two halves of a bar with a gap between them that is in no phase: x from -2 to -0.25 and from 0.25 to 2, |y| below 1.
fn halves(names: [usize; 2]) -> InterfaceGraph {
    let bar = |from: f64, to: f64| polygon(&[[from, -1.0], [to, -1.0], [to, 1.0], [from, 1.0]]);
    let [left, right] = [bar(-2.0, -0.25), bar(0.25, 2.0)];
    if names[0] == names[1] {
        return InterfaceGraph::of_sets(&[left.join(&right).unwrap()], Order::LINEAR, -1.0).unwrap();
    }
    InterfaceGraph::of_sets(&[left, right], Order::LINEAR, -1.0).unwrap()
}

#[test]
fn phases_come_together_where_the_gap_is_narrower_than_the_distance() {
    // Bulges towards each other: the gap at y = 0 is 0.5 exp(-t), and wider elsewhere.
    let bulge = |x: f64| {
        let side = |t: f64| [x.signum() * (0.25 + 0.5 * t * t), t];
        let mut ring: Vec<[f64; 2]> = (-20..=20).map(|i| side(f64::from(i) / 20.0)).collect();
        ring.push([2.0 * x.signum(), 1.0]);
        ring.push([2.0 * x.signum(), -1.0]);
        if x < 0.0 { polygon(&ring) } else { polygon(&ring.into_iter().rev().collect::<Vec<_>>()) }
    };
    let sets = [bulge(-1.0), bulge(1.0)];
    let squeeze = |[x, _]: [f64; 2], _: f64| [-x, 0.0];
    let options = TrackingOptions::new(1.5, 0.05, 0.1).on_contact(OnContact::Merge).contact_distance(0.25);
    let exact = 2.0f64.ln();
    // Two phases get an edge in common; what is between them is in no phase, and stays above and below.
    let two = InterfaceGraph::of_sets(&sets, Order::LINEAR, -1.0).unwrap();
    assert_eq!(two.junctions().count(), 0);
    let moved = two.advected(squeeze, &options).unwrap();
    let event = &moved.events()[0];
    assert_eq!(
        (event.kind(), event.phases(), event.counts()),
        (InterfaceEventKind::PhasesMeet, &[0, 1][..], None)
    );
    assert!((event.time() - exact).abs() < 1e-3 && event.place()[0].abs() < 1e-6, "{event:?}");
    let graph = moved.graph();
    assert_eq!(graph.junctions().count(), 2);
    let common = (0..graph.edge_count()).map(EdgeId::new).filter(|&edge| {
        let [left, right] = graph.phases_of(edge);
        left.is_some() && right.is_some()
    });
    assert_eq!(common.count(), 1);
    assert_eq!(graph.fault().unwrap(), None);
    // One phase becomes connected.
    let one = InterfaceGraph::of_sets(&[sets[0].join(&sets[1]).unwrap()], Order::LINEAR, -1.0).unwrap();
    let moved = one.advected(squeeze, &options).unwrap();
    let event = &moved.events()[0];
    assert_eq!((event.kind(), event.counts()), (InterfaceEventKind::PhaseMerges, Some([[2, 0], [1, 0]])));
    assert!((event.time() - exact).abs() < 1e-3);
    assert_eq!(moved.graph().phase_set(0).unwrap().betti_open().unwrap(), [1, 0]);
    // A set moves in the same way.
    let set = sets[0].join(&sets[1]).unwrap().advected(squeeze, &options).unwrap();
    assert!((set.events()[0].time() - event.time()).abs() < 1e-4);
    let area = |graph: &InterfaceGraph| graph.phase_area(0).unwrap();
    assert!((set.set().area().unwrap() - area(moved.graph())).abs() < 1e-6);
    // Kept, they stay apart.
    let kept = two.advected(squeeze, &options.on_contact(OnContact::Keep)).unwrap();
    assert_eq!(kinds(&kept), [InterfaceEventKind::Contact]);
    assert_eq!((kept.events()[0].phases(), kept.graph().junctions().count()), (&[0, 1][..], 0));
}

#[test]
fn a_film_between_two_phases_breaks() {
    // Left, film and right, side by side; the film is thinnest at y = 0.
    let side = |sign: f64, t: f64| [sign * (0.1 + 0.5 * t * t), t];
    let way = |sign: f64| (-20..=20).map(move |i| side(sign, f64::from(i) / 20.0));
    let left: Vec<[f64; 2]> = way(-1.0).chain([[-3.0, 1.0], [-3.0, -1.0]]).collect();
    let right: Vec<[f64; 2]> = way(1.0).rev().chain([[3.0, -1.0], [3.0, 1.0]]).collect();
    let film: Vec<[f64; 2]> = way(-1.0).rev().chain(way(1.0)).collect();
    let sets = [polygon(&left), polygon(&film), polygon(&right)];
    let graph = InterfaceGraph::of_sets(&sets, Order::LINEAR, -1.0).unwrap();
    assert_eq!(graph.junctions().count(), 4);
    let options = TrackingOptions::new(1.0, 0.05, 0.1).on_contact(OnContact::Merge).contact_distance(0.1);
    let moved = graph.advected(|[x, y], _| [-x, y * 0.0], &options).unwrap();
    assert_eq!(kinds(&moved)[..2], [InterfaceEventKind::PhasesMeet, InterfaceEventKind::PhaseSplits]);
    assert_eq!(moved.events()[0].phases(), [0, 2]);
    assert_eq!((moved.events()[1].phases(), moved.events()[1].counts()), (&[1][..], Some([[1, 0], [2, 0]])));
    assert!((moved.events()[0].time() - 2.0f64.ln()).abs() < 1e-3);
    assert_eq!((moved.graph().junctions().count(), moved.graph().fault().unwrap()), (6, None));
    let areas = |graph: &InterfaceGraph| (0..3).map(|phase| graph.phase_area(phase).unwrap()).sum::<f64>();
    assert!((areas(moved.graph()) - areas(&graph) * (-1.0f64).exp()).abs() < 1e-6);
}

#[test]
fn a_phase_that_is_narrow_all_along_goes_to_its_neighbor() {
    let bar = |from: f64, to: f64| polygon(&[[from, -1.0], [to, -1.0], [to, 1.0], [from, 1.0]]);
    let sets = [bar(-2.0, -0.1), bar(-0.1, 0.1), bar(0.1, 1.0)];
    let graph = InterfaceGraph::of_sets(&sets, Order::LINEAR, -1.0).unwrap();
    let options = TrackingOptions::new(2.0, 0.05, 0.5).on_contact(OnContact::Merge).contact_distance(0.1);
    let squeeze = |[x, _]: [f64; 2], _: f64| [-x, 0.0];
    let moved = graph.advected(squeeze, &options).unwrap();
    assert_eq!(kinds(&moved), [InterfaceEventKind::PhaseVanishes]);
    assert_eq!(moved.graph().phases(), [0, 2]);
    let total: f64 = [0, 2].iter().map(|&phase| moved.graph().phase_area(phase).unwrap()).sum();
    assert!((total - 6.0 * (-2.0f64).exp()).abs() < 1e-6, "{total}");
    let kept = graph.advected(squeeze, &options.keep_small(true)).unwrap();
    assert_eq!(kept.graph().phases(), [0, 1, 2]);
}

#[test]
fn interfaces_without_edges_have_no_contacts() {
    let options = TrackingOptions::new(1.0, 0.25, 0.1).on_contact(OnContact::Keep);
    assert!(four().advected(|_, _| [0.0; 2], &options).unwrap().events().is_empty());
    assert!(halves([0, 1]).advected(|_, _| [1.0, 0.0], &options).unwrap().events().is_empty());
    let none = InterfaceGraph::of_sets(&[], Order::LINEAR, 0.0).unwrap();
    for options in
        [options, options.on_contact(OnContact::Merge), TrackingOptions::new(1.0, 0.25, 0.1).events(true)]
    {
        assert!(none.advected(|_, _| [1.0, 0.0], &options).unwrap().events().is_empty());
    }
}
