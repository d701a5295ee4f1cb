//! Interfaces in unique form, fitted, and with kinks that come and go.
#![allow(clippy::unwrap_used, reason = "a failing test shows where")]

use crate::splines::Random;
use coface_algebra::VertexId;
use coface_arrange::boolean::InsideRule;
use coface_yin::{
    Curve, InterfaceEdge, InterfaceGraph, InterfaceOptions, KnotIndex, Order, Overlaps, YinSet,
};
use std::f64::consts::TAU;

fn polygon(points: &[[f64; 2]]) -> YinSet {
    let closed: Vec<[f64; 2]> = points.iter().copied().chain([points[0]]).collect();
    YinSet::new(&[Curve::polyline(&closed).unwrap()]).unwrap()
}

fn disk(center: [f64; 2], radius: f64, count: usize) -> YinSet {
    YinSet::new(&[Curve::circle(center, radius, count, Order::CUBIC).unwrap()]).unwrap()
}

/// Two disks that overlap; the first has what they have in common.
fn lens() -> InterfaceGraph {
    let sets = [disk([0.0, 0.0], 1.0, 48), disk([1.0, 0.2], 0.8, 40)];
    let options = InterfaceOptions::new(Order::CUBIC).overlaps(Overlaps::ToTheFirst);
    InterfaceGraph::of_sets_with(&sets, &options).unwrap()
}

/// The points of an edge, the phases on its sides, and its ends.
type Edge = (Vec<[f64; 2]>, [Option<u32>; 2], [u32; 2]);

fn edges(graph: &InterfaceGraph) -> Vec<Edge> {
    (0..graph.edge_count())
        .map(coface_algebra::EdgeId::new)
        .map(|edge| {
            let ends = graph.ends(edge).map(VertexId::to_u32);
            (graph.curve(edge).controls().to_vec(), graph.phases_of(edge), ends)
        })
        .collect()
}

#[test]
fn one_partition_has_one_unique_form() {
    // Integer cells in three phases, drawn with knots anywhere on the sides, from any corner.
    let mut random = Random::new(3);
    for case in 0..40 {
        let labels: Vec<u64> = (0..16).map(|_| random.below(4)).collect();
        let cell = |at: usize| {
            let [x, y] = [at % 4, at / 4].map(|x| x as f64);
            [[x, y], [x + 1.0, y], [x + 1.0, y + 1.0], [x, y + 1.0]]
        };
        let phase = |label: u64, order: &[usize]| {
            let rings: Vec<Vec<[f64; 2]>> =
                order.iter().filter(|&&at| labels[at] == label).map(|&at| cell(at).to_vec()).collect();
            if rings.is_empty() {
                YinSet::empty(Order::LINEAR)
            } else {
                YinSet::from_rings(&rings, InsideRule::Nonzero).unwrap()
            }
        };
        let forward: Vec<usize> = (0..16).collect();
        let backward: Vec<usize> = (0..16).rev().collect();
        let first: Vec<YinSet> = (1..4).map(|label| phase(label, &forward).straightened()).collect();
        let graph = InterfaceGraph::of_sets(&first, Order::LINEAR, -1.0).unwrap();
        // Others, with knots in the middle of sides and curves that begin elsewhere.
        let second: Vec<YinSet> = (1..4).map(|label| split(&phase(label, &backward), case)).collect();
        let other = InterfaceGraph::of_sets(&second, Order::LINEAR, -1.0).unwrap();
        let [a, b] = [&graph, &other].map(|graph| graph.normalized(InsideRule::Nonzero).unwrap());
        assert_eq!(edges(a.graph()), edges(b.graph()), "case {case}");
        assert_eq!(a.graph().vertices(), b.graph().vertices(), "case {case}");
        assert_eq!(a.graph().junctions().count(), graph.junctions().count());
        assert_eq!((a.fault(), a.graph().fault().unwrap()), (None, None));
        let again = a.graph().normalized(InsideRule::Odd).unwrap();
        assert_eq!((edges(again.graph()), again.joined_count()), (edges(a.graph()), 0));
        for phase in a.graph().phases() {
            let area = |graph: &InterfaceGraph| graph.phase_area(phase).unwrap();
            assert_eq!((area(a.graph()), area(b.graph())), (area(&graph), area(&graph)));
        }
    }
}

/// The same set with knots in the middle of its sides, and curves that begin at one of them.
fn split(set: &YinSet, start: usize) -> YinSet {
    let curves: Vec<Curve<'static>> = (0..set.curve_count())
        .map(|curve| {
            let curve = set.curve(curve);
            let mut points: Vec<[f64; 2]> = (0..curve.piece_count())
                .flat_map(|piece| {
                    let [a, b] = [piece, piece + 1].map(|knot| curve.knot_point(knot));
                    [a, [0, 1].map(|axis| 0.5 * (a[axis] + b[axis]))]
                })
                .collect();
            let count = points.len();
            points.rotate_left((2 * start + 1) % count);
            points.push(points[0]);
            Curve::polyline(&points).unwrap()
        })
        .collect();
    if curves.is_empty() { set.clone() } else { YinSet::new(&curves).unwrap() }
}

#[test]
fn unique_forms_of_curved_interfaces_keep_their_curves() {
    let graph = lens();
    assert_eq!((graph.junctions().count(), graph.edge_count()), (2, 3));
    let unique = graph.normalized(InsideRule::Nonzero).unwrap();
    let unique = unique.graph();
    assert_eq!((unique.junctions().count(), unique.edge_count(), unique.fault().unwrap()), (2, 3, None));
    for phase in [0, 1] {
        let miss = unique.phase_area(phase).unwrap() - graph.phase_area(phase).unwrap();
        assert!(miss.abs() < 1e-15);
    }
    // What has no junctions begins at its lowest knot.
    let ring = InterfaceGraph::of_sets(&[disk([0.0, 0.0], 1.0, 48)], Order::CUBIC, -1.0).unwrap();
    let unique = ring.normalized(InsideRule::Nonzero).unwrap();
    assert_eq!(unique.graph().vertices(), [[-1.0, unique.graph().vertices()[0][1]]]);
    assert!(unique.graph().vertices()[0][1].abs() < 1e-15);
}

#[test]
fn edges_that_cross_are_cut_and_pasted() {
    let bow = InterfaceEdge {
        ends: [0, 0],
        markers: vec![[2.0, 2.0], [2.0, 0.0], [0.0, 2.0]],
        phases: [Some(4), None],
    };
    let graph = InterfaceGraph::new(&[[0.0, 0.0]], &[bow], &[], Order::LINEAR).unwrap();
    assert!(graph.fault().unwrap().is_some());
    let found = graph.normalized(InsideRule::Nonzero).unwrap();
    assert!(found.fault().is_some() && found.graph().fault().unwrap().is_none());
    assert_eq!((found.graph().phases(), found.graph().phase_area(4).unwrap()), (vec![4], 2.0));
}

#[test]
fn kinks_cut_edges_and_join_them_again() {
    let graph = lens();
    let middle = |edge: u32| KnotIndex {
        curve: edge,
        knot: graph.curve(coface_algebra::EdgeId::from_u32(edge)).piece_count() as u32 / 2,
    };
    for edge in 0..3 {
        let cut = graph.with_kinks_changed(&[], &[middle(edge)]).unwrap();
        assert_eq!((cut.edge_count(), cut.kinks().len(), cut.junctions().count()), (4, 1, 2));
        assert_eq!(cut.fault().unwrap(), None);
        // All other edges stay bit for bit.
        for other in (0..3).filter(|&other| other != edge) {
            let id = coface_algebra::EdgeId::from_u32(other);
            assert_eq!(cut.curve(id), graph.curve(id));
        }
        let whole = cut.with_kinks_changed(&cut.kinks(), &[]).unwrap();
        assert_eq!((whole.edge_count(), whole.kinks().len()), (3, 0));
        let refitted = graph.fitted(Order::CUBIC, None).unwrap();
        for (a, b) in edges(&whole).iter().zip(edges(&refitted)) {
            let miss = a.0.iter().zip(&b.0).map(|(p, q)| (p[0] - q[0]).hypot(p[1] - q[1]));
            assert!(miss.fold(0.0, f64::max) < 1e-4, "edge {edge}");
        }
        let again = whole.with_kinks_changed(&[], &[middle(edge)]).unwrap();
        let again = again.with_kinks_changed(&again.kinks(), &[]).unwrap();
        assert_eq!(edges(&again), edges(&whole), "a round trip bit for bit");
    }
    // Phases have the kinks on both sides.
    let shared = (0..3).find(|&edge| {
        let [left, right] = graph.phases_of(coface_algebra::EdgeId::from_u32(edge));
        left.is_some() && right.is_some()
    });
    let cut = graph.with_kinks_changed(&[], &[middle(shared.unwrap())]).unwrap();
    for phase in [0, 1] {
        assert_eq!(
            cut.phase_set(phase).unwrap().kinks().len(),
            graph.phase_set(phase).unwrap().kinks().len() + 1
        );
    }
    assert_eq!(cut.nearest_kink([0.5, 0.0]).unwrap(), Some(cut.kinks()[0]));
    let near = graph.nearest_knot([-1.0, 0.0]).unwrap().unwrap();
    let [x, y] = graph.curve(coface_algebra::EdgeId::from_u32(near.curve)).knot_point(near.knot as usize);
    assert!((x + 1.0).hypot(y) < 1e-9);
}

#[test]
fn kinks_of_closed_edges() {
    let ring = InterfaceGraph::of_sets(&[disk([0.0, 0.0], 1.0, 32)], Order::CUBIC, -1.0).unwrap();
    assert!(ring.kinks().is_empty());
    for knots in [&[0][..], &[32], &[5], &[0, 8, 16, 24], &[31, 1]] {
        let knots: Vec<KnotIndex> = knots.iter().map(|&knot| KnotIndex { curve: 0, knot }).collect();
        let kinked = ring.with_kinks_changed(&[], &knots).unwrap();
        assert_eq!(kinked.kinks().len(), knots.len(), "{knots:?}");
        let set = kinked.phase_set(0).unwrap();
        assert_eq!(set.kinks().len(), knots.len());
        let back = kinked.with_kinks_changed(&kinked.kinks(), &[]).unwrap();
        assert_eq!((back.edge_count(), back.kinks().len()), (1, 0));
        assert!((back.phase_area(0).unwrap() - ring.phase_area(0).unwrap()).abs() < 1e-12);
        // The same as of a set with these kinks.
        let mut set = disk([0.0, 0.0], 1.0, 32);
        set.insert_kinks(&knots.iter().map(|at| KnotIndex { knot: at.knot % 32, ..*at }).collect::<Vec<_>>())
            .unwrap();
        assert!((set.area().unwrap() - kinked.phase_area(0).unwrap()).abs() < 1e-14, "{knots:?}");
        let reset = kinked.with_kinks(&[]).unwrap();
        assert_eq!((reset.edge_count(), reset.kinks().len()), (1, 0));
    }
    for (knots, said) in [
        (&[(0, 33)][..], "no knot 33 on edge 0"),
        (&[(1, 0)], "no edge 1"),
        (&[(0, 4), (0, 4)], "comes twice"),
        (&[(0, 0), (0, 32)], "comes twice"),
    ] {
        let knots: Vec<KnotIndex> = knots.iter().map(|&(curve, knot)| KnotIndex { curve, knot }).collect();
        let refused = ring.with_kinks_changed(&[], &knots).unwrap_err();
        assert!(refused.to_string().contains(said), "{refused}");
    }
    assert!(
        ring.with_kinks_changed(&[VertexId::new(0)], &[]).unwrap_err().to_string().contains("no kink v0")
    );
    let lens = lens();
    let junction = lens.with_kinks_changed(&[], &[KnotIndex { curve: 0, knot: 0 }]).unwrap_err();
    assert!(junction.to_string().contains("is a junction"), "{junction}");
}

#[test]
fn fits_keep_junctions_and_are_near_what_was_sampled() {
    // Sectors of a disk as polygons.
    let count = 96;
    let on = |i: usize| (TAU * i as f64 / count as f64).sin_cos();
    let sector = |number: usize| {
        let mut points = vec![[0.0, 0.0]];
        points.extend((0..=count / 3).map(|i| on((number * count / 3 + i) % count)).map(|(y, x)| [x, y]));
        polygon(&points)
    };
    let sets = [sector(0), sector(1), sector(2)];
    let graph = InterfaceGraph::of_sets(&sets, Order::LINEAR, 10f64.to_radians()).unwrap();
    for order in [4, 6, 8] {
        let fitted = graph.fitted(Order::new(order).unwrap(), None).unwrap();
        assert_eq!((fitted.junctions().count(), fitted.edge_count()), (4, graph.edge_count()));
        let total: f64 = (0..3).map(|phase| fitted.phase_area(phase).unwrap()).sum();
        assert!((total - std::f64::consts::PI).abs() < 2e-6, "{order} {total}");
        assert_eq!(fitted.fault().unwrap(), None);
    }
    // With all knots kinks nothing bends, unless edges go on smoothly through junctions.
    let graph = InterfaceGraph::of_sets(&sets, Order::LINEAR, -1.0).unwrap();
    let all: Vec<KnotIndex> = (0..graph.edge_count() as u32)
        .flat_map(|edge| {
            let count = graph.curve(coface_algebra::EdgeId::from_u32(edge)).piece_count() as u32;
            (1..count).map(move |knot| KnotIndex { curve: edge, knot })
        })
        .collect();
    let straight = graph.fitted(Order::CUBIC, Some(&all)).unwrap();
    let area = |graph: &InterfaceGraph| graph.phase_area(1).unwrap();
    assert!((area(&straight) - area(&graph)).abs() < 1e-14);
    let corners = polygon(&[[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [0.0, 1.0]]);
    let square = InterfaceGraph::of_sets(&[corners], Order::LINEAR, -1.0).unwrap();
    let detected = square.detected_kinks(0.5).unwrap();
    assert_eq!(detected.len(), 4);
    assert_eq!(square.fitted(Order::CUBIC, Some(&detected)).unwrap().phase_area(0).unwrap(), 2.0);
}

#[test]
fn edges_that_leave_a_junction_in_one_direction_are_told_apart_by_their_bend() {
    // A disk in a disk that touches it from inside.
    let sets = [disk([0.0, 0.0], 2.0, 64), disk([1.0, 0.0], 1.0, 64)];
    let options = InterfaceOptions::new(Order::CUBIC).overlaps(Overlaps::ToTheLast);
    let graph = InterfaceGraph::of_sets_with(&sets, &options).unwrap();
    let curves: Vec<Curve<'static>> =
        (0..graph.edge_count()).map(|edge| graph.curve(coface_algebra::EdgeId::new(edge)).clone()).collect();
    let ends: Vec<[u32; 2]> = edges(&graph).iter().map(|edge| edge.2).collect();
    let phases: Vec<[Option<u32>; 2]> = edges(&graph).iter().map(|edge| edge.1).collect();
    let again = InterfaceGraph::from_curves(
        graph.vertices(),
        &ends,
        &phases,
        curves,
        graph.smooth_pairs(),
        Order::CUBIC,
    );
    let again = again.unwrap();
    for phase in [0, 1] {
        assert_eq!(again.phase_area(phase).unwrap(), graph.phase_area(phase).unwrap());
    }
    assert_eq!(graph.normalized(InsideRule::Nonzero).unwrap().graph().fault().unwrap(), None);
}
