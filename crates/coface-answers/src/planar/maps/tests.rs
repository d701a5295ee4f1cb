//! Tests of what is done to maps.

use super::{BufferCaps, BufferJoins, BufferOptions, LineOptions, MapResult, MapTask, RepairMethod};
use crate::answer::MapAnswer;
use crate::{ArrangementRequest, DrawingArrangement, PlanarDrawing, RegionSource, Report};
use coface_io::{Format, Model, Shape, shapes};
use proptest::prelude::*;

fn read(text: &str) -> Model {
    coface_io::read(text.as_bytes(), Format::Wkt).unwrap()
}

fn after(model: &Model, task: &MapTask) -> (MapAnswer, Model) {
    let result = MapResult::new([("map", model)], task).unwrap();
    (result.answer().clone(), result.model().clone())
}

fn written(model: &Model) -> String {
    let mut text = Vec::new();
    coface_io::write(model, &mut text, Format::Wkt).unwrap();
    String::from_utf8(text).unwrap()
}

/// Whether what is written of a map is valid.
fn is_valid(model: &Model) -> bool {
    Report::of(read(&written(model))).unwrap().drawn_polygons().is_none_or(|found| found.faults().is_empty())
}

/// The polygons of a map by their rings.
fn polygons_of(model: &Model) -> Vec<Vec<Vec<[f64; 2]>>> {
    let place = |&vertex: &u32| {
        let point = model.positions().point(coface_algebra::VertexId::from_u32(vertex));
        [point[0], point[1]]
    };
    let ring = |line: usize| model.lines().list(line).iter().map(place).collect();
    let polygon = |(shape, _)| match shape {
        Shape::Rings(lines) => Some(lines.map(ring).collect()),
        _ => None,
    };
    shapes(model).into_iter().filter_map(polygon).collect()
}

/// Whether rings wind around a point an odd number of times.
fn is_inside(polygons: &[Vec<Vec<[f64; 2]>>], [x, y]: [f64; 2]) -> bool {
    let crosses = |side: &[[f64; 2]]| {
        let [[ax, ay], [bx, by]] = [side[0], side[1]];
        (ay > y) != (by > y) && x < ax + (y - ay) / (by - ay) * (bx - ax)
    };
    polygons.iter().flatten().flat_map(|ring| ring.windows(2)).filter(|side| crosses(side)).count() % 2 == 1
}

fn distance(place: [f64; 2], walks: &[Vec<[f64; 2]>]) -> f64 {
    let to_side = |side: &[[f64; 2]]| {
        let (a, b) = (side[0], side[1]);
        let (way, own) = ([b[0] - a[0], b[1] - a[1]], [place[0] - a[0], place[1] - a[1]]);
        let square = way[0] * way[0] + way[1] * way[1];
        let part =
            if square > 0.0 { ((way[0] * own[0] + way[1] * own[1]) / square).clamp(0.0, 1.0) } else { 0.0 };
        (own[0] - part * way[0]).hypot(own[1] - part * way[1])
    };
    walks.iter().flat_map(|walk| walk.windows(2)).map(to_side).fold(f64::INFINITY, f64::min)
}

/// Each with the area by structure and by linework, which are those of GEOS.
const INVALID: [(&str, f64, f64); 9] = [
    ("POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))", 2.0, 2.0),
    // A hole that crosses the outer ring.
    ("POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (2 1, 6 1, 6 3, 2 3, 2 1))", 12.0, 16.0),
    // A hole with a side along the outer ring.
    ("POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (2 1, 4 1, 4 3, 2 3, 2 1))", 12.0, 16.0),
    // A hole outside.
    ("POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (6 1, 8 1, 8 3, 6 3, 6 1))", 20.0, 20.0),
    // The ring runs around a square twice.
    ("POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0, 2 0, 2 2, 0 2, 0 0))", 4.0, 4.0),
    // Two parts that overlap.
    ("MULTIPOLYGON (((0 0, 2 0, 2 2, 0 2, 0 0)), ((1 0, 3 0, 3 2, 1 2, 1 0)))", 6.0, 6.0),
    // Two parts side by side.
    ("MULTIPOLYGON (((0 0, 2 0, 2 2, 0 2, 0 0)), ((2 0, 3 0, 3 2, 2 2, 2 0)))", 6.0, 6.0),
    // A spike.
    ("POLYGON ((0 0, 4 0, 4 6, 4 4, 0 4, 0 0))", 16.0, 16.0),
    // A part in a part.
    ("MULTIPOLYGON (((0 0, 4 0, 4 4, 0 4, 0 0)), ((1 1, 2 1, 2 2, 1 2, 1 1)))", 16.0, 15.0),
];

#[test]
fn repairs_are_those_of_geos() {
    for (text, structure, linework) in INVALID {
        for (method, area) in [(RepairMethod::Structure, structure), (RepairMethod::Linework, linework)] {
            let (answer, model) = after(&read(text), &MapTask::Repair(method));
            assert_eq!(answer.measure, area, "{text} by {}", method.name());
            assert!(is_valid(&model), "{text} by {}", method.name());
            let repair = answer.repair.unwrap();
            assert!(repair.features == 1 && !repair.faults.is_empty(), "{text}");
            // What is valid stays.
            let (again, same) = after(&model, &MapTask::Repair(method));
            assert_eq!((again.repair.unwrap().features, written(&same)), (0, written(&model)), "{text}");
        }
    }
}

#[test]
fn what_changed_is_told() {
    let text = "POLYGON ((0 0, 3 0, 3 3, 0 3, 0 0, 2 0, 2 2, 0 2, 0 0))";
    let changed = |method| after(&read(text), &MapTask::Repair(method)).0.repair.unwrap();
    // The inner square is enclosed twice: structure has it inside.
    assert_eq!(changed(RepairMethod::Structure).area_changed, 4.0);
    // A ring that is valid but reversed is turned, and nothing else.
    let (answer, model) =
        after(&read("POLYGON ((0 0, 0 1, 1 1, 1 0, 0 0))"), &MapTask::Repair(RepairMethod::Structure));
    let repair = answer.repair.unwrap();
    assert_eq!((repair.features, repair.rings_turned, repair.area_changed), (0, 1, 0.0));
    assert_eq!(written(&model), "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))\n");
    let flat = after(&read("POLYGON ((0 0, 1 1, 2 2, 0 0))"), &MapTask::Repair(RepairMethod::Structure)).0;
    assert_eq!((flat.counts.features, flat.counts.polygons, flat.repair.unwrap().vanished), (1, 0, 1));
}

#[test]
fn buffers_of_squares_and_lines_have_the_areas_of_formulas() {
    let square = read("POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 3, 3 3, 3 1, 1 1))");
    let area = |model: &Model, options: BufferOptions| after(model, &MapTask::Buffer(options)).0.measure;
    assert_eq!(area(&square, BufferOptions::new(0.5).joins(BufferJoins::Mitre(5.0))), 25.0 - 1.0);
    // Cut off at the limit, as high as the diagonal of a unit square less 1.
    let cut = area(
        &read("POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))"),
        BufferOptions::new(1.0).joins(BufferJoins::Mitre(1.0)),
    );
    assert!((cut - (36.0 - 4.0 * (2f64.sqrt() - 1.0).powi(2))).abs() < 1e-12);
    assert_eq!(area(&square, BufferOptions::new(0.5).joins(BufferJoins::Bevel)), 25.0 - 4.0 * 0.125 - 1.0);
    assert_eq!(area(&square, BufferOptions::new(2.0).joins(BufferJoins::Mitre(5.0))), 64.0);
    assert_eq!(
        area(&square, BufferOptions::new(-0.25).joins(BufferJoins::Mitre(5.0))),
        3.5 * 3.5 - 2.5 * 2.5
    );
    // In each corner of the frame a square without a quarter of a disk is left.
    let left = 1.0 - std::f64::consts::FRAC_PI_4;
    assert!((area(&square, BufferOptions::new(-0.5)) - left).abs() < 2e-3);
    let round = area(&square, BufferOptions::new(1.0).error(1e-4));
    let exact = 16.0 + 16.0 + std::f64::consts::PI;
    assert!(round < exact && round > exact - 4e-4 * std::f64::consts::TAU, "{round}");
    let line = read("LINESTRING (0 0, 4 0)");
    assert_eq!(area(&line, BufferOptions::new(1.0).caps(BufferCaps::Flat)), 8.0);
    assert_eq!(area(&line, BufferOptions::new(1.0).caps(BufferCaps::Square)), 12.0);
    assert!((area(&line, BufferOptions::new(1.0).error(1e-6)) - 8.0 - std::f64::consts::PI).abs() < 1e-5);
    assert_eq!(area(&line, BufferOptions::new(-1.0)), 0.0);
    let closed = read("LINESTRING (0 0, 4 0, 4 4, 0 4, 0 0)");
    assert_eq!(area(&closed, BufferOptions::new(1.0).joins(BufferJoins::Mitre(5.0))), 36.0 - 4.0);
    assert_eq!(area(&read("POINT (1 1)"), BufferOptions::new(2.0).caps(BufferCaps::Square)), 16.0);
}

#[test]
fn boxes_clip_polygons_lines_and_points() {
    let map = read(
        "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))\nLINESTRING (-1 1, 5 1, 5 3, -1 3)\nPOINT (1 1)\nPOINT (9 9)",
    );
    let (answer, model) = after(&map, &MapTask::Clip([1.0, 1.0, 5.0, 2.0]));
    let expected = "POLYGON ((1 1, 4 1, 4 2, 1 2, 1 1))\nLINESTRING (1 1, 5 1, 5 2)\nPOINT (1 1)\n";
    assert_eq!((written(&model).as_str(), answer.measure, answer.length), (expected, 3.0, 5.0));
    // A line that touches the box in a corner, or goes by.
    for line in ["LINESTRING (0 2, 2 0)", "LINESTRING (0 0, 0 9)"] {
        assert_eq!(after(&read(line), &MapTask::Clip([1.0, 1.0, 2.0, 2.0])).0.counts.features, 0, "{line}");
    }
    let heights = read("LINESTRING Z (0 0 0, 4 0 8)");
    assert_eq!(
        written(&after(&heights, &MapTask::Clip([1.0, -1.0, 2.0, 1.0])).1),
        "LINESTRING Z (1 0 2, 2 0 4)\n"
    );
    assert!(MapResult::new([("map", &map)], &MapTask::Clip([1.0, 0.0, 1.0, 2.0])).is_err());
}

#[test]
fn lines_are_cut_and_faces_found() {
    let lines = read("LINESTRING (0 0, 4 0, 4 4, 0 4, 0 0)\nLINESTRING (-1 2, 5 2)\nLINESTRING (2 2, 2 3)");
    let (noded, model) = after(&lines, &MapTask::Node(LineOptions::new()));
    assert_eq!((noded.counts.lines, noded.length), (7, 16.0 + 6.0 + 1.0));
    assert_eq!(after(&model, &MapTask::Node(LineOptions::new())).0.counts, noded.counts);
    let (faces, polygons) = after(&lines, &MapTask::Polygonize(LineOptions::new()));
    let left_out = faces.left_out.unwrap();
    assert_eq!((faces.counts.polygons, faces.measure, left_out.dangles, left_out.cut_edges), (2, 16.0, 3, 0));
    assert!(is_valid(&polygons));
}

#[test]
fn coverages_list_gaps_overlaps_and_sides() {
    let task = MapTask::Coverage { gap_width: Some(0.2) };
    let found = |text: &str| after(&read(text), &task).0.coverage.unwrap();
    let fits = found("POLYGON ((0 0, 2 0, 2 1, 2 2, 0 2, 0 0))\nPOLYGON ((2 0, 4 0, 4 2, 2 2, 2 1, 2 0))");
    assert!(fits.valid && fits.gaps.is_empty());
    let missing = found("POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))\nPOLYGON ((2 0, 4 0, 4 2, 2 2, 2 1, 2 0))");
    assert_eq!((missing.valid, missing.invalid_edges), (false, 3));
    let overlap = found("POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))\nPOLYGON ((1 0, 3 0, 3 2, 1 2, 1 0))");
    assert_eq!((overlap.overlaps[0].area, &overlap.overlaps[0].features[..]), (2.0, &[0, 1][..]));
    let gap = found("POLYGON ((0 0, 4 0, 4 1, 0 1, 0 0))\nPOLYGON ((0 1, 2 1.1, 4 1, 4 2, 0 2, 0 1))");
    assert_eq!((gap.gaps.len(), gap.gaps[0].narrow, gap.valid), (1, true, false));
    assert!((gap.gaps[0].area - 0.2).abs() < 1e-12 && (gap.gaps[0].width - 0.05).abs() < 1e-3);
}

#[test]
fn common_borders_are_simplified_once() {
    let map = read(
        "POLYGON ((0 0, 2 0, 2.1 1, 2 2, 0 2, 0 0))\nPOLYGON ((2 0, 4 0, 4 2, 2 2, 2.1 1, 2 0))\nPOINT (2.05 1)",
    );
    // The point keeps the border from moving over it.
    let (stays, _) = after(&map, &MapTask::Simplify(0.5));
    assert_eq!(stays.simplification.unwrap().vertices, 7);
    let without =
        read("POLYGON ((0 0, 2 0, 2.1 1, 2 2, 0 2, 0 0))\nPOLYGON ((2 0, 4 0, 4 2, 2 2, 2.1 1, 2 0))");
    let (answer, model) = after(&without, &MapTask::Simplify(0.5));
    let expected = "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))\nPOLYGON ((2 0, 4 0, 4 2, 2 2, 2 0))\n";
    assert_eq!(written(&model), expected);
    let found = answer.simplification.unwrap();
    assert_eq!((found.vertices_before, found.vertices), (7, 6));
    assert!((found.largest_distance - 0.1).abs() < 1e-12);
    assert_eq!(after(&without, &MapTask::Simplify(0.05)).0.simplification.unwrap().vertices, 7);
}

#[test]
fn closed_lines_stay_closed_without_their_first_vertices() {
    let (answer, model) = after(&read("LINESTRING (1 0, 2 0, 2 2, 0 2, 0 0, 1 0)"), &MapTask::Simplify(0.0));
    assert_eq!(answer.simplification.unwrap().vertices, 4);
    assert_eq!(written(&model), "LINESTRING (2 0, 2 2, 0 2, 0 0, 2 0)\n");
    let ring = read("LINESTRING (1 5, 1 4, 2 0, 2 1, 1 5)");
    let (answer, model) = after(&ring, &MapTask::Simplify(2.0));
    assert_eq!(answer.simplification.unwrap().vertices, 3);
    let walk = model.lines().list(0);
    assert_eq!((model.lines().len(), walk.len(), walk.first()), (1, 4, walk.last()));
}

#[test]
fn requests_of_no_meaning_are_refused() {
    let square = read("POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))");
    let tasks = [
        MapTask::Buffer(BufferOptions::new(f64::NAN)),
        MapTask::Buffer(BufferOptions::new(1.0).error(0.0)),
        MapTask::Buffer(BufferOptions::new(1.0).error(1e-14)),
        MapTask::Buffer(BufferOptions::new(1.0).joins(BufferJoins::Mitre(0.5))),
        MapTask::Simplify(-1.0),
        MapTask::Coverage { gap_width: Some(f64::INFINITY) },
    ];
    for task in tasks {
        assert!(MapResult::new([("map", &square)], &task).unwrap_err().cure().is_some(), "{task:?}");
    }
    let nothing = read("POLYGON EMPTY");
    for task in [
        MapTask::Buffer(BufferOptions::new(1.0)),
        MapTask::Repair(RepairMethod::Linework),
        MapTask::Clip([0.0, 0.0, 1.0, 1.0]),
        MapTask::Node(LineOptions::new()),
        MapTask::Polygonize(LineOptions::new()),
        MapTask::Simplify(1.0),
        MapTask::Coverage { gap_width: None },
    ] {
        assert_eq!(after(&nothing, &task).0.measure, 0.0, "{task:?}");
    }
}

/// Rings with corners among few integers: they cross, touch and overlap themselves.
fn rings(most: usize) -> impl Strategy<Value = Vec<Vec<[i32; 2]>>> {
    prop::collection::vec(prop::collection::vec([0..7i32, 0..7i32], 3..7), 1..most)
}

fn ring_text(ring: &[[i32; 2]]) -> String {
    let corners: Vec<String> = ring.iter().chain(ring.first()).map(|[x, y]| format!("{x} {y}")).collect();
    format!("({})", corners.join(", "))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn repaired_polygons_are_valid_and_stay(rings in rings(4), is_linework: bool) {
        let texts: Vec<String> = rings.iter().map(|ring| ring_text(ring)).collect();
        let text = format!("POLYGON ({})", texts.join(", "));
        let method = if is_linework { RepairMethod::Linework } else { RepairMethod::Structure };
        let (answer, model) = after(&read(&text), &MapTask::Repair(method));
        prop_assert!(is_valid(&model), "{text}");
        let (again, same) = after(&model, &MapTask::Repair(method));
        prop_assert_eq!(written(&same), written(&model), "{}", text);
        prop_assert_eq!(again.measure.to_bits(), answer.measure.to_bits());
    }

    #[test]
    fn points_in_buffers_are_near(
        rings in rings(2),
        is_line: bool,
        distance_in_tenths in 1..25i32,
        points in prop::collection::vec([-300..1000i32, -300..1000i32], 30),
    ) {
        let mut ring = rings[0].clone();
        ring.dedup();
        let radius = f64::from(distance_in_tenths) / 10.0;
        let text = if is_line {
            format!("LINESTRING {}", ring_text(&ring))
        } else {
            format!("POLYGON ({})", ring_text(&ring))
        };
        let model = read(&text);
        let valid = after(&model, &MapTask::Repair(RepairMethod::Structure)).1;
        let inner = polygons_of(&valid);
        let walks: Vec<Vec<[f64; 2]>> = if is_line {
            vec![ring.iter().chain(ring.first()).map(|corner| corner.map(f64::from)).collect()]
        } else {
            inner.iter().flatten().cloned().collect()
        };
        prop_assume!(!walks.is_empty() && !valid.lines().is_empty());
        for sign in [1.0, -1.0] {
            let options = BufferOptions::new(sign * radius).error(0.01);
            let (_, buffer) = after(&model, &MapTask::Buffer(options));
            prop_assert!(is_valid(&buffer), "{text} {radius}");
            let polygons = polygons_of(&buffer);
            for point in &points {
                let place = point.map(|x| f64::from(x) / 100.0 + 0.0003);
                let away = distance(place, &walks);
                let is_in = is_inside(&inner, place);
                let signed = if is_in { -away } else { away };
                let found = is_inside(&polygons, place);
                if sign > 0.0 {
                    let near = if is_line { away } else { signed };
                    prop_assert!(found || near > radius - 0.0101, "{text} {radius} {place:?} outside at {near}");
                    prop_assert!(!found || near < radius + 1e-9, "{text} {radius} {place:?} inside at {near}");
                } else if !is_line {
                    prop_assert!(found || signed > -radius - 1e-9, "{text} {radius} {place:?} outside at {signed}");
                    prop_assert!(!found || signed < -radius + 0.0101, "{text} {radius} {place:?} inside at {signed}");
                }
            }
        }
    }

    #[test]
    fn simpler_maps_have_the_same_faces(
        rings in rings(5),
        tolerance in 0..30i32,
    ) {
        let lines: Vec<String> = rings.iter().map(|ring| format!("LINESTRING {}", ring_text(ring))).collect();
        let model = read(&lines.join("\n"));
        let noded = after(&model, &MapTask::Node(LineOptions::new())).1;
        let tolerance = f64::from(tolerance) / 10.0;
        let (answer, simpler) = after(&noded, &MapTask::Simplify(tolerance));
        let found = answer.simplification.unwrap();
        prop_assert!(found.largest_distance <= tolerance);
        let cells = |model: &Model| {
            let drawing = PlanarDrawing::new([("map", model)], RegionSource::Models).unwrap();
            let arranged = DrawingArrangement::new(drawing, &ArrangementRequest::default()).unwrap();
            let arrangement = arranged.arrangement();
            let euler = arrangement.vertex_count() as i64 - arrangement.edge_count() as i64;
            (arrangement.face_count(), arrangement.component_count(), arrangement.hole_count(), euler)
        };
        prop_assert_eq!(cells(&noded), cells(&simpler));
    }

    #[test]
    fn clips_are_intersections(rings in rings(3), frame in [0..4i32, 0..4i32, 4..8i32, 4..8i32]) {
        let texts: Vec<String> = rings.iter().map(|ring| format!("POLYGON ({})", ring_text(ring))).collect();
        let map = after(&read(&texts.join("\n")), &MapTask::Repair(RepairMethod::Structure)).1;
        let [left, low, right, high] = frame.map(f64::from);
        let (answer, model) = after(&map, &MapTask::Clip([left, low, right, high]));
        prop_assert!(is_valid(&model));
        let window = format!("POLYGON (({left} {low}, {right} {low}, {right} {high}, {left} {high}, {left} {low}))");
        let mut sum = 0.0;
        for polygons in written(&map).lines().filter(|line| line.contains("POLYGON")) {
            let (own, window) = (read(polygons), read(&window));
            let drawing = PlanarDrawing::new([("a", &own), ("b", &window)], RegionSource::Models).unwrap();
            let formula = coface_arrange::boolean::BooleanFormula::intersection(2);
            sum += crate::RegionBoolean::new(drawing, &formula, &crate::BooleanRequest::default()).unwrap().area();
        }
        prop_assert!((answer.measure - sum).abs() < 1e-9, "{} {}", answer.measure, sum);
    }
}

/// Where a vertex that is put in is rounded, a side may come to lie on another one: the map is valid still.
#[test]
fn simplified_maps_are_valid() {
    let thin = "POLYGON ((500011.77219073195 5600100.0,500011.9070466073 5600100.0,500011.7431692894 5600099.967402775,500011.77219073195 5600100.0))";
    let wide = "POLYGON ((500000.0 5600088.55780193,500000.0 5600100.0,500011.77219073195 5600100.0,500011.7431692894 5600099.967402775,500011.6577788078 5600099.950417552,500009.92238761374 5600098.790866228,500008.7628362895 5600097.055475034,500008.65125764033 5600096.494531284,500001.51590870443 5600088.480023528,500000.0 5600088.55780193))";
    let disk = "POLYGON ((\
        500019.0539685746 5600095.008441548,500018.64678829786 5600092.961408062,\
        500017.48723697354 5600091.226016868,500015.75184577954 5600090.066465544,\
        500013.70481229364 5600089.659285267,500011.6577788078 5600090.066465544,\
        500009.92238761374 5600091.226016868,500008.7628362895 5600092.961408062,\
        500008.35565601266 5600095.008441548,500008.7628362895 5600097.055475034,\
        500009.92238761374 5600098.790866228,500011.6577788078 5600099.950417552,\
        500013.70481229364 5600100.357597829,500015.75184577954 5600099.950417552,\
        500017.48723697354 5600098.790866228,500018.64678829786 5600097.055475034,\
        500019.0539685746 5600095.008441548))";
    let map = read(&[thin, wide, disk].join("\n"));
    assert!(is_valid(&map));
    let (answer, simple) = after(&map, &MapTask::Simplify(0.01));
    assert!(is_valid(&simple), "{}", written(&simple));
    assert!(answer.simplification.unwrap().vertices_added > 0);
    let two = read(&[thin, disk].join("\n"));
    assert!(is_valid(&two));
    let (_, simple) = after(&two, &MapTask::Simplify(0.01));
    assert!(is_valid(&simple), "{}", written(&simple));
    // What is not valid stays so, and that is said.
    let (answer, _) = after(&read("POLYGON ((0 0,2 2,2 0,0 2,0 0))"), &MapTask::Simplify(0.01));
    assert!(answer.remarks.iter().any(|remark| remark.message.contains("not valid, as before")));
}

/// Cells of a file are features of a map: each face a polygon, with its holes.
#[test]
fn cells_are_features() {
    let map = read("POLYGON ((0 0,6 0,6 6,0 6,0 0),(2 2,4 2,4 4,2 4,2 2))\nPOLYGON ((2 2,4 2,4 4,2 4,2 2))");
    let drawing = PlanarDrawing::new([("map", &map)], RegionSource::Models).unwrap();
    let arranged = DrawingArrangement::new(drawing, &ArrangementRequest::default()).unwrap();
    let mut bytes = Vec::new();
    arranged.write(&mut bytes, Format::Json).unwrap();
    let cells = coface_io::read(&bytes[..], Format::Json).unwrap();
    let (answer, repaired) = after(&cells, &MapTask::Repair(RepairMethod::Structure));
    assert_eq!((answer.counts.features, answer.counts.holes, answer.measure), (2, 1, 36.0));
    assert!(is_valid(&repaired));
}

#[test]
fn lines_that_nearly_meet_bound_faces_within_a_tolerance() {
    // The third side ends short of the first.
    let lines = read("MULTILINESTRING ((0 0, 4 0), (4 0, 0 3), (0 3, 0 0.0000001))\n");
    let faces = |options: LineOptions| after(&lines, &MapTask::Polygonize(options)).0;
    assert_eq!(faces(LineOptions::new()).counts.polygons, 0);
    for options in [LineOptions::new().tolerance(Some(0.001)), LineOptions::new().grid(Some(0.5))] {
        let answer = faces(options);
        assert_eq!((answer.counts.polygons, answer.measure), (1, 6.0), "{options:?}");
    }
    let noded = after(&lines, &MapTask::Node(LineOptions::new().tolerance(Some(0.001)))).0;
    assert!(noded.remarks.iter().any(|remark| remark.message.contains("0.001")), "{:?}", noded.remarks);
    let wrong = MapResult::new([("lines", &lines)], &MapTask::Node(LineOptions::new().grid(Some(-1.0))));
    assert!(wrong.is_err());
}

/// What SVG fills of paths is what maps of them have.
#[test]
fn fill_rules_of_drawings_say_what_is_inside() {
    let drawing = |rule: &str, data: &str| {
        let text = format!(
            "<svg xmlns='http://www.w3.org/2000/svg'><path id='a' fill-rule='{rule}' d='{data}'/></svg>"
        );
        coface_io::read(text.as_bytes(), Format::Svg).unwrap()
    };
    // Beside each other, in each other alike and against each other, an island in a hole, and a bow tie.
    let (square, other) = ("M0 0H6V6H0Z", "M8 0H9V1H8Z");
    let (alike, against, island) = ("M1 1H5V5H1Z", "M1 1V5H5V1Z", "M2 2H4V4H2Z");
    let cases = [
        (format!("{square}{other}"), 37.0, 37.0, 2),
        (format!("{square}{alike}"), 36.0, 20.0, 1),
        (format!("{square}{against}"), 20.0, 20.0, 1),
        (format!("{square}{against}{island}"), 24.0, 24.0, 2),
        (format!("{island}{against}{square}"), 24.0, 24.0, 2),
        ("M0 0H4V4H2V-2H0Z".to_owned(), 12.0, 12.0, 2),
    ];
    for (data, nonzero, odd, parts) in cases {
        for (rule, area) in [("nonzero", nonzero), ("evenodd", odd)] {
            let model = drawing(rule, &data);
            let (answer, repaired) = after(&model, &MapTask::Repair(RepairMethod::Structure));
            let filled = PlanarDrawing::new([("drawing", &model)], RegionSource::Models).unwrap();
            let request = crate::BooleanRequest::default();
            let formula = coface_arrange::boolean::BooleanFormula::union(1);
            let expected = crate::RegionBoolean::new(filled, &formula, &request).unwrap();
            assert_eq!(answer.measure, expected.area(), "{rule} {data}");
            assert_eq!(answer.measure, area, "{rule} {data}");
            assert!(is_valid(&repaired), "{rule} {data}");
            let wide = after(&model, &MapTask::Clip([-3.0, -3.0, 20.0, 20.0])).0;
            assert_eq!(wide.measure, area, "{rule} {data}");
            let written = match crate::polygons_of_fill_rules(&model).unwrap() {
                Some((model, remark)) => {
                    assert!(remark.message.starts_with("1 shape is written"), "{}", remark.message);
                    model
                }
                None => model,
            };
            let back = read(&self::written(&written));
            let back = after(&back, &MapTask::Repair(RepairMethod::Structure)).0;
            assert_eq!((back.measure, back.repair.unwrap().features), (area, 0), "{rule} {data}");
            assert_eq!(polygons_of(&written).len(), parts, "{rule} {data}");
        }
    }
}
