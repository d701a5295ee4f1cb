//! Changes of the topology of sets that move: what merges, splits, opens, closes and vanishes, with times that are known.
#![allow(clippy::unwrap_used, reason = "a failing test shows where")]

use crate::splines::Random;
use coface_yin::{
    Curve, EndCondition, EventKind, Flow, InterfaceEdge, InterfaceGraph, OnContact, Order, RungeKutta,
    TopologyEvent, TrackedSet, TrackingOptions, Verification, YinSet,
};
use std::f64::consts::TAU;

fn circle(center: [f64; 2], radius: f64) -> Curve<'static> {
    Curve::circle(center, radius, 96, Order::CUBIC).unwrap()
}

/// Points come to the line x = 0 by exp(-t).
fn along_x([x, _]: [f64; 2], _: f64) -> [f64; 2] {
    [-x, 0.0]
}

/// Points come to the line y = 0 by exp(-t).
fn along_y([_, y]: [f64; 2], _: f64) -> [f64; 2] {
    [0.0, -y]
}

/// Steps of 0.1, markers up to 0.05 apart, contacts at 0.05.
fn merging(end: f64) -> TrackingOptions {
    TrackingOptions::new(end, 0.1, 0.05).on_contact(OnContact::Merge).contact_distance(0.05)
}

/// The one event, checked against its kind, time, place and counts.
fn check_one(
    moved: &TrackedSet,
    kind: EventKind,
    time: f64,
    place: [f64; 2],
    [before, after]: [[usize; 2]; 2],
) -> TopologyEvent {
    let [event] = moved.events() else { panic!("{:?}", moved.events()) };
    assert_eq!((event.kind(), event.before(), event.after()), (kind, before, after), "{event:?}");
    // What splines and steps miss, and the tolerance of times.
    assert!((event.time() - time).abs() < 2e-3, "{event:?} {time}");
    assert!((0..2).all(|axis| (event.place()[axis] - place[axis]).abs() < 2e-2), "{event:?}");
    assert_eq!(moved.set().validate().unwrap(), None);
    assert_eq!(moved.set().curve_counts(), after);
    *event
}

#[test]
fn two_disks_merge_when_the_gap_is_narrow() {
    let set = YinSet::new(&[circle([-1.25, 0.0], 1.0), circle([1.25, 0.0], 1.0)]).unwrap();
    let moved = set.advected(along_x, &merging(2.6)).unwrap();
    let time = (0.5f64 / 0.05).ln();
    check_one(&moved, EventKind::ComponentsMerge, time, [0.0, 0.0], [[2, 0], [1, 0]]);
    // The bridge is as small as the distance.
    let whole = TAU * (-2.6f64).exp();
    assert!((moved.set().area().unwrap() - whole).abs() < 4.0 * 0.05 * 0.05, "{:?}", moved.set().area());
    assert_eq!(moved.curves(), [0]);
    // The time does not hang on the steps, but for the tolerance.
    let other = merging(2.6).event_tolerance(1e-6);
    let times = [0.13, 0.1].map(|step| {
        let options = TrackingOptions::new(2.6, step, 0.05).on_contact(OnContact::Merge);
        let options = options.contact_distance(0.05).event_tolerance(1e-6);
        set.advected(along_x, &options).unwrap().events()[0].time()
    });
    assert!((times[0] - times[1]).abs() < 1e-4, "{times:?}");
    assert!((set.advected(along_x, &other).unwrap().events()[0].time() - time).abs() < 1e-4);
}

#[test]
fn polygons_merge_too() {
    let square = |x: f64| {
        let corners = [[x, 0.0], [x + 1.0, 0.0], [x + 1.0, 1.0], [x, 1.0]];
        Curve::fit_closed(&corners, &[0, 1, 2, 3], Order::LINEAR, &EndCondition::NotAKnot).unwrap()
    };
    let set = YinSet::new(&[square(-1.2), square(0.3)]).unwrap();
    // The gap between the parallel sides: a bridge over a part of it, and the bay that is left closes no hole.
    let moved = set.advected(along_x, &merging(2.4)).unwrap();
    let [event] = moved.events() else { panic!("{:?}", moved.events()) };
    assert_eq!((event.kind(), event.after()), (EventKind::ComponentsMerge, [1, 0]));
    assert!((event.time() - 10.0f64.ln()).abs() < 2e-3, "{event:?}");
}

#[test]
fn a_dumbbell_splits_at_its_neck() {
    // r = 1 + 0.8 cos 2t has a neck of width 0.4 at x = 0.
    let points: Vec<[f64; 2]> = (0..200)
        .map(|i| TAU * f64::from(i) / 200.0)
        .map(|t| (1.0 + 0.8 * (2.0 * t).cos(), t))
        .map(|(r, t)| [r * t.cos(), r * t.sin()])
        .collect();
    let set = YinSet::fit(&[points], &[vec![]], Order::CUBIC, &EndCondition::NotAKnot).unwrap();
    let moved = set.advected(along_y, &merging(2.2)).unwrap();
    check_one(&moved, EventKind::ComponentSplits, 8.0f64.ln(), [0.0, 0.0], [[1, 0], [2, 0]]);
    assert_eq!(moved.curves(), [0, 0]);
}

#[test]
fn the_mouth_of_a_ring_closes_to_a_hole() {
    // A ring between radii 1/2 and 1 without the angles up to 0.2 around the direction of x.
    let arc = |radius: f64, from: f64, to: f64, count: u32| {
        (0..count)
            .map(move |i| from + (to - from) * f64::from(i) / f64::from(count))
            .map(move |t| [radius * t.cos(), radius * t.sin()])
    };
    let mut points: Vec<[f64; 2]> = arc(1.0, 0.2, TAU - 0.2, 160).collect();
    let mut kinks = vec![0, points.len() as u32];
    let [sine, cosine] = [0.2f64.sin(), 0.2f64.cos()];
    let side = |from: f64, to: f64, sign: f64| {
        (0..12)
            .map(move |i| from + (to - from) * f64::from(i) / 12.0)
            .map(move |r| [r * cosine, sign * r * sine])
    };
    points.extend(side(1.0, 0.5, -1.0));
    kinks.push(points.len() as u32);
    points.extend(arc(0.5, TAU - 0.2, 0.2, 100));
    kinks.push(points.len() as u32);
    points.extend(side(0.5, 1.0, 1.0));
    let set = YinSet::fit(&[points], &[kinks], Order::CUBIC, &EndCondition::NotAKnot).unwrap();
    let moved = set.advected(along_y, &merging(1.5)).unwrap();
    let time = (sine / 0.05).ln();
    check_one(&moved, EventKind::HoleForms, time, [0.5 * cosine, 0.0], [[1, 0], [1, 1]]);
}

#[test]
fn a_hole_opens_and_holes_merge() {
    let at_the_rim = [circle([0.0, 0.0], 1.0), circle([0.0, 0.6], 0.3).reversed()];
    let moved = YinSet::new(&at_the_rim).unwrap().advected(along_y, &merging(0.8)).unwrap();
    // The wall is 0.1 exp(-t) wide.
    let place = [0.0, 0.95 * 0.5];
    check_one(&moved, EventKind::HoleOpens, 2.0f64.ln(), place, [[1, 1], [1, 0]]);
    let two =
        [circle([0.0, 0.0], 2.0), circle([-0.55, 0.0], 0.5).reversed(), circle([0.55, 0.0], 0.5).reversed()];
    let moved = YinSet::new(&two).unwrap().advected(along_x, &merging(0.8)).unwrap();
    check_one(&moved, EventKind::HolesMerge, 2.0f64.ln(), [0.0, 0.0], [[1, 2], [1, 1]]);
    // The complement: an outside of two disks, whose gap is a neck of it, and a hole that splits.
    let outside = two[1..].iter().map(|curve| curve.reversed().reversed()).collect::<Vec<_>>();
    let moved = YinSet::new(&outside).unwrap().advected(along_x, &merging(0.8)).unwrap();
    check_one(&moved, EventKind::HolesMerge, 2.0f64.ln(), [0.0, 0.0], [[1, 2], [1, 1]]);
}

#[test]
fn a_hole_splits() {
    let points: Vec<[f64; 2]> = (0..200)
        .map(|i| TAU * f64::from(i) / 200.0)
        .map(|t| (1.0 + 0.8 * (2.0 * t).cos(), t))
        .map(|(r, t)| [r * t.cos(), r * t.sin()])
        .collect();
    let mut ring = points;
    ring.push(ring[0]);
    let hole = Curve::fit(&ring, Order::CUBIC, &EndCondition::Periodic).unwrap().reversed();
    let set = YinSet::new(&[circle([0.0, 0.0], 3.0), hole]).unwrap();
    let moved = set.advected(along_y, &merging(2.2)).unwrap();
    check_one(&moved, EventKind::HoleSplits, 8.0f64.ln(), [0.0, 0.0], [[1, 1], [1, 2]]);
}

#[test]
fn rigid_motions_have_no_events() {
    let set = YinSet::new(&[circle([-1.25, 0.0], 1.0), circle([1.25, 0.0], 1.0)]).unwrap();
    let flow = Flow::Rotation { center: [0.3, 0.2], speed: 2.0 };
    for what in [Some(OnContact::Merge), Some(OnContact::Keep), None] {
        let options = TrackingOptions::new(3.0, 0.1, 0.05).events(true).on_contact(what);
        let moved = set.advected(|p, t| flow.velocity(p, t), &options).unwrap();
        assert!(moved.events().is_empty(), "{:?}", moved.events());
        // What is looked at is not changed.
        let plain = TrackingOptions::new(3.0, 0.1, 0.05);
        let plain = set.advected(|p, t| flow.velocity(p, t), &plain).unwrap();
        let [area, same] = [&plain, &moved].map(|moved| moved.set().area().unwrap());
        assert!((area - same).abs() < 1e-12 && plain.counts() == moved.counts(), "{area} {same}");
    }
}

#[test]
fn what_shrinks_away_has_a_time() {
    let radial = |[x, y]: [f64; 2], _: f64| [-x, -y];
    let ring = [circle([0.0, 0.0], 1.0), circle([0.0, 0.0], 0.5).reversed()];
    let set = YinSet::new(&ring).unwrap();
    // Three times the least distance is 0.06.
    let options = TrackingOptions::new(5.0, 0.5, 0.2).events(true).event_tolerance(1e-4);
    let moved = set.advected(radial, &options).unwrap();
    let kinds: Vec<EventKind> = moved.events().iter().map(TopologyEvent::kind).collect();
    assert_eq!(kinds, [EventKind::HoleVanishes, EventKind::ComponentVanishes]);
    for (event, radius) in moved.events().iter().zip([0.5, 1.0]) {
        // Polygons of few markers are a little shorter.
        let latest = (TAU * radius / 0.06).ln();
        assert!(event.time() < latest + 1e-4 && event.time() > latest - 0.3, "{event:?} {latest}");
        assert!(event.place().iter().all(|x| x.abs() < 2e-2), "{event:?}");
    }
    assert_eq!(moved.events()[0].after(), [1, 0]);
    assert_eq!(moved.vanished().len(), 2);
    assert!(moved.set().is_empty());
    assert_eq!(moved.events()[1].time(), moved.vanished()[1].time());
    // Kept curves do not vanish, and are no necks.
    let kept = options.keep_small(true).on_contact(OnContact::Merge).contact_distance(1e-3);
    assert!(set.advected(radial, &kept).unwrap().events().is_empty());
}

#[test]
fn contacts_can_be_kept() {
    let set = YinSet::new(&[circle([-1.25, 0.0], 1.0), circle([1.25, 0.0], 1.0)]).unwrap();
    let options = merging(2.6).on_contact(OnContact::Keep);
    let moved = set.advected(along_x, &options).unwrap();
    check_one(&moved, EventKind::Contact, 10.0f64.ln(), [0.0, 0.0], [[2, 0], [2, 0]]);
    let plain = set.advected(along_x, &TrackingOptions::new(2.6, 0.1, 0.05)).unwrap();
    let area = |moved: &TrackedSet| moved.set().area().unwrap();
    assert!((area(&moved) - area(&plain)).abs() < 1e-5);
    // In contact from the beginning on there is no event.
    let near = merging(1.0).on_contact(OnContact::Keep).contact_distance(0.6);
    assert!(set.advected(along_x, &near).unwrap().events().is_empty());
    // With a bridge at once.
    let near = near.on_contact(OnContact::Merge);
    assert_eq!(set.advected(along_x, &near).unwrap().set().curve_counts(), [1, 0]);
}

#[test]
fn what_crosses_is_merged_or_refused() {
    // Disks around two centers grow by exp(t), and cross in the second step.
    let growth = |[x, y]: [f64; 2], _: f64| [x - 0.6f64.copysign(x), y];
    let set = YinSet::new(&[circle([-0.6, 0.0], 0.5), circle([0.6, 0.0], 0.5)]).unwrap();
    let options = TrackingOptions::new(0.2, 0.1, 0.08).scheme(RungeKutta::Midpoint).events(true);
    let error = set.advected(growth, &options).unwrap_err();
    assert!(error.to_string().contains("in step 2") && error.cure().is_some(), "{error}");
    let merging = options.on_contact(OnContact::Merge).contact_distance(1e-3);
    let merged = set.advected(growth, &merging).unwrap();
    // Where the fronts close further, slivers between them may be left as holes.
    assert_eq!((merged.set().validate().unwrap(), merged.set().curve_counts()[0]), (None, 1));
    let event = merged.events()[0];
    assert_eq!((event.kind(), event.after()), (EventKind::ComponentsMerge, [1, 0]));
    assert!((event.time() - 1.2f64.ln()).abs() < 5e-3, "{event:?}");
    let error = set.advected(growth, &options.on_contact(OnContact::Keep)).unwrap_err();
    assert!(error.to_string().contains("in step 2"), "{error}");
}

/// Random pairs of disks on a line through the origin.
#[test]
fn times_of_contact_are_those_of_the_flow() {
    let mut random = Random::new(26);
    for case in 0..4 {
        let [left, right] = [0, 1].map(|_| 0.4 + 0.6 * random.part());
        let [gap, height] = [0.2 + 0.3 * random.part(), 0.1 * random.coordinate()];
        let curves = [circle([-0.5 * gap - left, height], left), circle([0.5 * gap + right, height], right)];
        let moved = YinSet::new(&curves).unwrap().advected(along_x, &merging(2.5)).unwrap();
        let time = (gap / 0.05).ln();
        assert_eq!(moved.events().len(), 1, "{case} {:?}", moved.events());
        assert!((moved.events()[0].time() - time).abs() < 2e-3, "{case} {:?} {time}", moved.events()[0]);
        assert_eq!(moved.set().validate().unwrap(), None, "{case}");
    }
}

#[test]
fn options_without_meaning_are_refused() {
    let set = YinSet::new(&[circle([0.0, 0.0], 1.0)]).unwrap();
    let options = TrackingOptions::new(1.0, 0.1, 0.05).events(true);
    for wrong in [
        options.event_tolerance(0.0),
        options.contact_distance(-1.0),
        options.contact_distance(f64::NAN),
        options.verification(Verification::End),
    ] {
        let error = set.advected(along_x, &wrong).unwrap_err();
        assert!(error.cure().is_some(), "{error}");
    }
    // Nothing to look at.
    let empty = YinSet::empty(Order::CUBIC).advected(along_x, &merging(1.0)).unwrap();
    assert!(empty.events().is_empty() && empty.set().is_empty());
    assert!(YinSet::plane(Order::CUBIC).advected(along_x, &merging(1.0)).unwrap().set().is_plane());
    let markers = vec![[1.0, 0.0], [0.0, 1.0]];
    let edge = InterfaceEdge { ends: [0, 0], markers, phases: [Some(0), None] };
    let graph = InterfaceGraph::new(&[[0.0, 0.0]], &[edge], &[], Order::LINEAR).unwrap();
    assert!(graph.advected(along_x, &merging(1.0)).unwrap().events().is_empty());
    assert!(graph.advected(along_x, &merging(1.0).contact_distance(-1.0)).unwrap_err().cure().is_some());
}

#[test]
fn fronts_that_are_pressed_together_leave_no_slivers_and_end() {
    let disks =
        YinSet::new(&[-1.2, 1.2].map(|x| Curve::circle([x, 0.0], 1.0, 8, Order::CUBIC).unwrap())).unwrap();
    let onto = |[x, _]: [f64; 2], _: f64| [(-20.0 * x).clamp(-1.0, 1.0), 0.0];
    for within in [1e-2, 1e-3] {
        let options =
            TrackingOptions::new(0.5, 0.05, 0.25).on_contact(OnContact::Merge).contact_distance(within);
        let moved = disks.advected(onto, &options).unwrap();
        assert_eq!(moved.events()[0].kind(), EventKind::ComponentsMerge);
        assert_eq!(moved.set().component_count().unwrap(), 1);
        for curve in 0..moved.set().curve_count() {
            let own = moved.set().curve(curve);
            let width = 2.0 * own.signed_area().abs() / own.length(1e-9);
            assert!(width > 0.45 * within, "{within}: curve {curve} has the width {width}");
        }
        assert!(moved.repairs().len() <= 4 * 10, "{}", moved.repairs().len());
    }
}
