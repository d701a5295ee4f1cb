//! Places of interfaces, their images and files, checked against their phases as sets.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use coface_answers::answer::{YinInterfaceAnswer, YinLocation};
use coface_answers::{LabelImage, NamedSet, PlanarInterface, PlanarSet};
use coface_geometry::{AffineMap, Angle};
use coface_yin::{Curve, InterfaceOptions, Order, Overlaps, Sampling, SetLocation, YinSet};
use proptest::prelude::*;

fn of_sets(sets: Vec<NamedSet>) -> PlanarInterface {
    let options = InterfaceOptions::new(PlanarInterface::order_for(&sets)).smooth_angle(0.01);
    PlanarInterface::of(sets, &options, Overlaps::ToTheFirst).unwrap()
}

/// Two disks that overlap, and what is outside of both in a third: a phase that is not bounded.
fn disks() -> PlanarInterface {
    let disk =
        |center, radius| YinSet::new(&[Curve::circle(center, radius, 24, Order::CUBIC).unwrap()]).unwrap();
    let sets = [disk([0.0, 0.0], 1.0), disk([1.0, 0.25], 0.75), YinSet::plane(Order::CUBIC)];
    let names = ["left", "right", "rest"];
    of_sets(
        names.iter().zip(sets).map(|(name, set)| NamedSet::new(*name, PlanarSet::from_set(set))).collect(),
    )
}

/// The interface after it went through a file.
fn reread(interface: &PlanarInterface) -> PlanarInterface {
    let text = serde_json::to_vec(&interface.answer(&[], true).unwrap()).unwrap();
    PlanarInterface::of_answer(&YinInterfaceAnswer::of_json(&text).unwrap().unwrap()).unwrap()
}

fn text(interface: &PlanarInterface) -> String {
    serde_json::to_string(&interface.answer(&[], true).unwrap()).unwrap()
}

/// Where points lie, by asking every phase about every point.
fn check_located(interface: &PlanarInterface, points: &[[f64; 2]]) {
    let found = interface.located("x", points).unwrap();
    let phases = interface.phases().unwrap();
    assert_eq!(
        found.boundary + found.outside + found.phases.iter().map(|own| own.inside).sum::<usize>(),
        points.len()
    );
    for (point, place) in points.iter().zip(&found.points) {
        let (mut location, mut own) = (YinLocation::Outside, Vec::new());
        for (number, phase) in (0u32..).zip(&phases) {
            match phase.set().locate(*point).unwrap() {
                SetLocation::Inside => location = YinLocation::Inside,
                SetLocation::Boundary { .. } => location = YinLocation::Boundary,
                SetLocation::Outside => continue,
            }
            own.push(number);
        }
        assert_eq!((place.location, &place.phases), (location, &own), "{point:?}");
        let all = phases.iter().filter_map(|phase| phase.set().nearest_all(&[*point]).unwrap()[0]);
        let least = all.map(|found| found.distance).fold(f64::INFINITY, f64::min);
        let Some(distance) = place.distance else {
            assert_eq!(least, f64::INFINITY);
            continue;
        };
        assert!((distance - least).abs() <= 1e-12, "{point:?}: {distance} and {least}");
        // The place on the edge is the nearest point.
        let curve = interface.graph().curve(coface_algebra::EdgeId::new(place.edge.unwrap() as usize));
        let [knots, piece] = [curve.knots(), curve.knots()].map(<[f64]>::to_vec);
        let at = place.piece.unwrap();
        let t = knots[at] + place.parameter.unwrap() * (piece[at + 1] - knots[at]);
        let on_edge = curve.point(t);
        let nearest = place.nearest.unwrap();
        assert!((on_edge[0] - nearest[0]).hypot(on_edge[1] - nearest[1]) < 1e-9, "{on_edge:?} {nearest:?}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn points_lie_where_each_phase_says(
        width in 1usize..5,
        labels in proptest::collection::vec(0u32..4, 1..16),
        halves in proptest::collection::vec((-1i8..11, -1i8..11), 1..24),
    ) {
        let height = labels.len().div_ceil(width);
        let mut labels = labels;
        labels.resize(width * height, 0);
        let interface = of_sets(LabelImage::new(width, labels).unwrap().sets().unwrap());
        // Points on lattice lines and between them, exactly.
        let points: Vec<[f64; 2]> = halves.iter().map(|&(x, y)| [f64::from(x) * 0.5, f64::from(y) * 0.5]).collect();
        check_located(&interface, &points);
        check_located(&reread(&interface), &points);
    }

    #[test]
    fn images_keep_phases_and_come_back(
        labels in proptest::collection::vec(0u32..4, 9),
        steps in proptest::collection::vec((0u8..4, -3i8..4, -3i8..4), 10),
    ) {
        let interface = of_sets(LabelImage::new(3, labels).unwrap().sets().unwrap());
        let mut image = interface.clone();
        let mut back = AffineMap::translation(&[0.0, 0.0]).unwrap();
        let mut scale = 1.0;
        for (what, x, y) in steps {
            let (map, inverse) = match what {
                0 => (AffineMap::scaling(&[-2.0, 2.0]).unwrap(), AffineMap::scaling(&[-0.5, 0.5]).unwrap()),
                1 => (
                    AffineMap::rotation(2, [0, 1], Angle::degrees(90.0).unwrap()).unwrap(),
                    AffineMap::rotation(2, [0, 1], Angle::degrees(-90.0).unwrap()).unwrap(),
                ),
                _ => {
                    let by = [f64::from(x), f64::from(y)];
                    (AffineMap::translation(&by).unwrap(), AffineMap::translation(&by.map(|x| -x)).unwrap())
                }
            };
            scale *= if what == 0 { 4.0 } else { 1.0 };
            // Written, read and mapped, ten times.
            image = reread(&image.transformed(&map).unwrap());
            back = inverse.then(&back).unwrap();
            for (own, first) in image.phases().unwrap().iter().zip(interface.phases().unwrap()) {
                prop_assert_eq!(own.set().area(), first.set().area().map(|area| area * scale));
            }
        }
        let returned = image.transformed(&back).unwrap();
        for (own, first) in returned.phases().unwrap().iter().zip(interface.phases().unwrap()) {
            prop_assert!(own.set().has_points_of(first.set()).unwrap());
        }
        let kinds = |interface: &PlanarInterface| {
            let answer = interface.answer(&[], false).unwrap();
            let mut kinds: Vec<_> = answer.junctions.iter().map(|own| (own.degree, own.kind.word())).collect();
            kinds.sort_unstable();
            kinds
        };
        prop_assert_eq!(kinds(&returned), kinds(&interface));
    }
}

#[test]
fn curved_interfaces_and_phases_without_bounds_are_located() {
    let interface = disks();
    let grid = (-12..=16).flat_map(|x| (-12..=12).map(move |y| [f64::from(x) * 0.125, f64::from(y) * 0.125]));
    check_located(&interface, &grid.collect::<Vec<_>>());
    let far = interface.located("x", &[[50.0, 0.0]]).unwrap();
    assert_eq!((far.points[0].location, &far.points[0].phases), (YinLocation::Inside, &vec![2]));
    // Vertices are on edges of all phases that meet there.
    let junction = interface.graph().junctions().next().unwrap();
    let found = interface.located("x", &[interface.graph().vertices()[junction.index()]]).unwrap();
    assert_eq!(found.points[0].phases, [0, 1, 2]);
}

#[test]
fn files_of_files_are_the_same_file() {
    let first = text(&disks());
    let mut interface = disks();
    for _ in 0..10 {
        interface = reread(&interface);
    }
    assert_eq!(text(&interface), first);
}

#[test]
fn samples_and_bends_of_edges_are_those_of_the_curves() {
    let interface = disks();
    let found = interface.sampled("x", Sampling::Spacing(0.05)).unwrap();
    let answer = interface.answer(&[], false).unwrap();
    for (number, edge) in (0u32..).zip(&answer.edges) {
        let own: Vec<_> = found.samples.iter().filter(|sample| sample.edge == number).collect();
        let ends = edge.ends.map(|end| answer.vertices[end as usize]);
        let (first, last) = (own[0], own[own.len() - 1]);
        assert_eq!([first.point, last.point], ends);
        assert!((last.length - edge.length.unwrap()).abs() < 1e-12);
        assert_eq!((first.left, first.right), (edge.left, edge.right));
        let steps = own.windows(2).map(|pair| pair[1].length - pair[0].length);
        let step = edge.length.unwrap() / (own.len() - 1) as f64;
        assert!(step <= 0.05 * (1.0 + 1e-12) && steps.into_iter().all(|own| (own - step).abs() < 1e-12));
    }
    // Arcs of circles with radii 1 and 3/4.
    for bend in interface.curvature("x").unwrap().edges {
        let [least, greatest] = [bend.least.value.abs(), bend.greatest.value.abs()];
        let radius = if (least - 1.0).abs() < 0.02 { 1.0 } else { 0.75 };
        assert!(
            (least * radius - 1.0).abs() < 0.02 && (greatest * radius - 1.0).abs() < 0.02,
            "{least} {greatest}"
        );
        assert!(bend.sharpest.is_some_and(|place| place.value.abs() < 1e-6));
    }
}

#[test]
fn comparisons_sum_what_phases_differ_by() {
    let interface = disks();
    let same = interface.compared_with("a", &interface, "b").unwrap();
    assert!(same.area_xor.is_some_and(|area| area <= same.area_xor_error));
    // The phase outside of the disks has the symmetric difference of their union.
    let moved = interface.transformed(&AffineMap::translation(&[0.01, 0.0]).unwrap()).unwrap();
    let found = interface.compared_with("a", &moved, "b").unwrap();
    let [own, others] = [&interface, &moved].map(|one| one.phases().unwrap());
    let parts =
        own.iter().zip(&others).map(|(a, b)| a.set().symmetric_difference(b.set()).unwrap().area().unwrap());
    assert!((found.area_xor.unwrap() - parts.sum::<f64>()).abs() < 1e-12 + found.area_xor_error);
    assert_eq!(found.junctions, [2, 2]);
    // Namesakes go together, wherever they stand.
    let labels = |labels| of_sets(LabelImage::new(2, labels).unwrap().sets().unwrap());
    let fewer = labels(vec![1, 2]).compared_with("a", &labels(vec![1, 1]), "b");
    assert!(fewer.is_err_and(|error| error.message().contains("2 and 1 phases")));
}

#[test]
fn degenerate_interfaces_are_answered() {
    let nothing = of_sets(Vec::new());
    let found = nothing.located("x", &[[1.0, 2.0]]).unwrap();
    assert_eq!((found.outside, found.points[0].nearest), (1, None));
    assert!(nothing.sampled("x", Sampling::PerPiece(3)).unwrap().samples.is_empty());
    assert!(nothing.curvature("x").unwrap().edges.is_empty());
    assert!(nothing.phase("a").is_err_and(|error| error.message().contains("no phase \"a\"")));
    assert!(nothing.located("x", &[[f64::NAN, 0.0]]).is_err());
    assert!(nothing.sampled("x", Sampling::PerPiece(0)).is_err());
    assert!(disks().transformed(&AffineMap::scaling(&[1.0, 0.0]).unwrap()).is_err());
    assert!(disks().transformed(&AffineMap::scaling(&[1e308, 1e308]).unwrap()).is_err());
    // A phase that is the plane.
    let plane = of_sets(vec![NamedSet::new("all", PlanarSet::from_set(YinSet::plane(Order::LINEAR)))]);
    let found = reread(&plane).located("x", &[[1.0, 2.0]]).unwrap();
    assert_eq!((found.phases[0].inside, found.points[0].distance), (1, None));
}
