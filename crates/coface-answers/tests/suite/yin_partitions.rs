//! Sets as phases that share the arcs between them, and boundaries that come to meet.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use coface_algebra::{EdgeId, VertexId};
use coface_answers::{PlanarSet, SetRequest};
use coface_arrange::boolean::InsideRule;
use coface_io as io;
use coface_io::ReadOptions;
use coface_yin::{
    Curve, DirectedEdge, InterfaceGraph, InterfaceOptions, Order, Overlaps, RungeKutta, TrackingOptions,
    Verification, YinFault, YinSet,
};
use std::f64::consts::PI;

fn disk(center: [f64; 2], radius: f64) -> YinSet {
    YinSet::new(&[Curve::circle(center, radius, 48, Order::CUBIC).unwrap()]).unwrap()
}

fn polygon(points: &[[f64; 2]]) -> YinSet {
    let closed: Vec<[f64; 2]> = points.iter().copied().chain([points[0]]).collect();
    YinSet::new(&[Curve::polyline(&closed).unwrap()]).unwrap()
}

/// The formula of Euler, with the faces counted as components of phases and of what is outside.
fn check_euler(graph: &InterfaceGraph, sets: &[YinSet]) {
    let count = graph.vertices().len();
    let mut class: Vec<usize> = (0..count).collect();
    for edge in 0..graph.edge_count() {
        let [a, b] = graph.ends(EdgeId::new(edge)).map(|end| class[end.index()]);
        class.iter_mut().filter(|own| **own == a).for_each(|own| *own = b);
    }
    class.sort_unstable();
    class.dedup();
    let phases: usize =
        graph.phases().iter().map(|&phase| graph.phase_set(phase).unwrap().component_count().unwrap()).sum();
    let all: Vec<&YinSet> = sets.iter().collect();
    let outside = YinSet::join_all(&all).unwrap().complement().unwrap();
    let faces = phases + outside.component_count().unwrap();
    assert_eq!(count + faces, graph.edge_count() + 1 + class.len());
    // Each end of an edge is at one place around one vertex.
    let ends: usize = (0..count).map(|vertex| graph.edges_at(VertexId::new(vertex)).len()).sum();
    assert_eq!(ends, 2 * graph.edge_count());
}

#[test]
fn curved_sets_share_their_arcs_bit_for_bit() {
    let (a, b) = (disk([0.0, 0.0], 1.0), disk([0.9, 0.3], 0.8));
    let sets = [a.difference(&b).unwrap(), a.meet(&b).unwrap(), b.difference(&a).unwrap()];
    let graph = InterfaceGraph::of_sets(&sets, Order::CUBIC, 0.01).unwrap();
    assert_eq!((graph.edge_count(), graph.junctions().count()), (4, 2));
    // Both circles go on smoothly through both junctions.
    assert_eq!(graph.trails().iter().filter(|trail| trail.is_circuit()).count(), 2);
    assert_eq!(graph.fault().unwrap(), None);
    check_euler(&graph, &sets);
    for (phase, set) in (0..).zip(&sets) {
        let own = graph.phase_set(phase).unwrap();
        assert!((own.area().unwrap() - set.area().unwrap()).abs() < 1e-15);
        assert!(own.has_points_of(set).unwrap());
    }
    let [phases, border] = graph.covered_areas().unwrap();
    assert!((phases - border).abs() < 1e-14);
    // A ring and the disk in it, with what is outside as a phase too; other knots on both sides of the circle.
    let inner = YinSet::new(&[Curve::circle([0.0, 0.0], 0.5, 20, Order::CUBIC).unwrap()]).unwrap();
    let ring = a.difference(&inner).unwrap();
    let outside = a.complement().unwrap();
    let sets = [inner, ring, outside];
    let graph = InterfaceGraph::of_sets(&sets, Order::CUBIC, -1.0).unwrap();
    assert_eq!((graph.edge_count(), graph.junctions().count()), (2, 0));
    assert!(!graph.phase_set(2).unwrap().is_bounded());
    check_euler(&graph, &sets);
}

#[test]
fn overlaps_are_errors_with_place_and_area_or_go_to_one_set() {
    let (a, b) = (disk([0.0, 0.0], 1.0), disk([1.0, 0.0], 1.0));
    let lens = a.meet(&b).unwrap().area().unwrap();
    let sets = [a, b];
    let mut options = InterfaceOptions::new(Order::CUBIC);
    let said = InterfaceGraph::of_sets_with(&sets, &options).unwrap_err().to_string();
    assert!(
        said.contains("sets 0 and 1 overlap at (") && said.contains(&format!("in an area of {lens}")),
        "{said}"
    );
    for (overlaps, wins) in [(Overlaps::ToTheFirst, 0), (Overlaps::ToTheLast, 1)] {
        options = options.overlaps(overlaps);
        let graph = InterfaceGraph::of_sets_with(&sets, &options).unwrap();
        let areas = [0, 1].map(|phase| graph.phase_area(phase).unwrap());
        assert!((areas[wins] - sets[wins].area().unwrap()).abs() < 1e-14);
        assert!((areas[1 - wins] + lens - sets[1 - wins].area().unwrap()).abs() < 1e-14);
        assert_eq!((graph.edge_count(), graph.junctions().count()), (3, 2));
        check_euler(&graph, &sets);
    }
    // The plane and a set in it.
    let plane = [polygon(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]), YinSet::plane(Order::LINEAR)];
    let said = InterfaceGraph::of_sets(&plane, Order::LINEAR, -1.0).unwrap_err().to_string();
    assert!(said.contains("in an area of 0.5"), "{said}");
}

#[test]
fn a_staircase_of_bricks_has_shared_walls() {
    // Rows of bricks, each half a brick farther: vertices of each row lie within sides of the next.
    let mut sets = Vec::new();
    for row in 0..6 {
        for column in 0..5 {
            let (x, y) = (2.0 * f64::from(column) + f64::from(row % 2), f64::from(row));
            sets.push(polygon(&[[x, y], [x + 2.0, y], [x + 2.0, y + 1.0], [x, y + 1.0]]));
        }
    }
    let graph = InterfaceGraph::of_sets(&sets, Order::LINEAR, -1.0).unwrap();
    check_euler(&graph, &sets);
    // Within each of 5 borders between rows each brick above and each below has two corners, of which no two are one.
    assert!(graph.junctions().all(|vertex| graph.degree(vertex) == 3));
    assert!((0..30).all(|phase| graph.phase_area(phase).unwrap() == 2.0));
    let shared = (0..graph.edge_count())
        .map(EdgeId::new)
        .filter(|&edge| graph.phases_of(edge).iter().all(Option::is_some));
    // Neighbors: 4 in each row, 9 between rows.
    assert_eq!(shared.count(), 6 * 4 + 5 * 9);
}

#[test]
fn countries_become_an_interface() {
    let Ok(data) = std::env::var("COFACE_DATA") else {
        eprintln!("skipped: COFACE_DATA is not set");
        return;
    };
    let read = |name: &str| {
        let path = format!("{data}/planar/{name}");
        let drawing = io::read_boundary_path(path, &ReadOptions::default()).unwrap();
        // A coast touches itself.
        let mut request = SetRequest::default();
        request.rule = Some(InsideRule::Odd);
        PlanarSet::of(&drawing, &request).unwrap().set().clone()
    };
    let [lesotho, africa, italy, land] =
        ["LSO.geo.json", "ZAF.geo.json", "ITA.geo.json", "land-110m.geojson"].map(read);
    // A country in another: one border, which is shared whole.
    let sets = [lesotho, africa];
    let graph = InterfaceGraph::of_sets(&sets, Order::LINEAR, -1.0).unwrap();
    assert_eq!((graph.edge_count(), graph.junctions().count()), (2, 0));
    check_euler(&graph, &sets);
    let [lesotho, africa] = sets;
    // The land around them: the rest of it is a phase, and coasts are shared where they are the same.
    let sets = [lesotho, africa, italy, land];
    let mut options = InterfaceOptions::new(Order::LINEAR);
    assert!(InterfaceGraph::of_sets_with(&sets, &options).unwrap_err().to_string().contains("overlap"));
    options = options.overlaps(Overlaps::ToTheFirst);
    let graph = InterfaceGraph::of_sets_with(&sets, &options).unwrap();
    check_euler(&graph, &sets);
    let all: Vec<&YinSet> = sets.iter().collect();
    let joined = YinSet::join_all(&all).unwrap().area().unwrap();
    let [phases, border] = graph.covered_areas().unwrap();
    assert!((phases - joined).abs() < 1e-9 && (phases - border).abs() < 1e-9, "{phases} {border} {joined}");
    assert!(graph.junctions().count() >= 4);
}

/// Points flow away from the nearer one of two centers: disks around them grow, and come to meet.
fn growth([x, y]: [f64; 2], _: f64) -> [f64; 2] {
    [x - 0.6f64.copysign(x), y]
}

#[test]
fn sets_that_come_to_meet_are_errors_or_repaired() {
    let curves = [-0.6, 0.6].map(|x| Curve::circle([x, 0.0], 0.5, 64, Order::CUBIC).unwrap());
    let set = YinSet::new(&curves).unwrap();
    // No stage comes over the line in the middle.
    let mut options = TrackingOptions::new(0.2, 0.1, 0.08).scheme(RungeKutta::Midpoint);
    let error = set.advected(growth, &options).unwrap_err();
    let said = error.to_string();
    assert!(said.contains("in step 2, at time 0.2: curves 0 and 1 cross at ("), "{said}");
    assert!(error.cure().unwrap().contains("fill rule"));
    options = options.verification(Verification::Never);
    assert!(set.advected(growth, &options).unwrap().into_set().validate().unwrap().is_some());
    options = options.verification(Verification::EachStep);
    options = options.repair(InsideRule::Nonzero);
    let moved = set.advected(growth, &options).unwrap();
    let repair = moved.repairs()[0];
    assert_eq!((repair.step(), moved.curves()), (2, &[0u32][..]));
    assert!(matches!(repair.fault(), YinFault::Crossing { curves: [0, 1], .. }), "{repair:?}");
    let moved = moved.into_set();
    assert_eq!((moved.validate().unwrap(), moved.curve_counts(), moved.kinks().len()), (None, [1, 0], 2));
    // Two disks without their lens.
    let radius = 0.5 * 1.105 * 1.105;
    let half = (0.6f64 / radius).acos();
    let right = 2.0 * (PI - half) * radius * radius + 1.2 * radius * half.sin();
    assert!((moved.area().unwrap() - right).abs() < 1e-5, "{:?} {right}", moved.area());
    // What is outside of the disks is wound around once less in the lens: by this rule that is outside as well.
    options = options.repair(InsideRule::Positive);
    let moved = set.complement().unwrap().advected(growth, &options).unwrap();
    assert_eq!((moved.repairs().len(), moved.set().is_bounded(), moved.set().curve_count()), (1, false, 1));
    assert_eq!(moved.set().validate().unwrap(), None);
    assert!((moved.set().complement().unwrap().area().unwrap() - right).abs() < 1e-5);
}

#[test]
fn phases_that_come_to_meet_are_errors_or_repaired() {
    let sets = [-0.6, 0.6].map(|x| disk([x, 0.0], 0.5));
    let graph = InterfaceGraph::of_sets(&sets, Order::CUBIC, -1.0).unwrap();
    let mut options = TrackingOptions::new(0.2, 0.1, 0.08).scheme(RungeKutta::Midpoint);
    let said = graph.advected(growth, &options).unwrap_err().to_string();
    assert!(said.contains("in step 2, at time 0.2: phases 0 and 1 overlap at ("), "{said}");
    options = options.repair(InsideRule::Nonzero);
    let moved = graph.advected(growth, &options).unwrap();
    assert_eq!(moved.repairs()[0].step(), 2);
    assert_eq!(moved.repairs()[0].fault().phases(), [0, 1]);
    let graph = moved.graph();
    assert_eq!((graph.fault().unwrap(), graph.phases()), (None, vec![0, 1]));
    assert!(graph.junctions().count() == 2 && moved.edges().iter().all(Option::is_none));
    let shared =
        (0..graph.edge_count()).any(|edge| graph.phases_of(EdgeId::new(edge)).iter().all(Option::is_some));
    assert!(
        shared
            && graph
                .edges_at(VertexId::new(0))
                .iter()
                .all(|edge: &DirectedEdge| edge.edge.index() < graph.edge_count())
    );
}
