//! Combinations of regions are valid as they are written, and go back in as inputs.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use coface_algebra::{FaceId, RaggedArray};
use coface_answers::answer::{Remark, RemarkCode};
use coface_answers::{
    ArrangementRequest, BooleanRequest, DrawingArrangement, PlanarDrawing, RegionBoolean, RegionSource,
};
use coface_arrange::boolean::BooleanFormula;
use coface_arrange::planar::polygon_faults;
use coface_io::{Format, Model};
use proptest::prelude::*;

fn drawing(texts: &[String]) -> PlanarDrawing {
    let models: Vec<Model> =
        texts.iter().map(|text| coface_io::read(text.as_bytes(), Format::Wkt).unwrap()).collect();
    PlanarDrawing::new(models.iter().map(|model| ("drawn", model)), RegionSource::Models).unwrap()
}

fn combined(texts: &[String], formula: &str, request: &BooleanRequest) -> RegionBoolean {
    RegionBoolean::new(drawing(texts), &BooleanFormula::parse(formula, &[]).unwrap(), request).unwrap()
}

fn written(result: &RegionBoolean) -> String {
    let mut text = Vec::new();
    result.write(&mut text, Format::Wkt).unwrap();
    String::from_utf8(text).unwrap()
}

/// Whether the polygons of a result have a fault together: not the way in which the result is made valid.
fn has_faults(result: &RegionBoolean) -> bool {
    let (mut rings, mut polygons) = (RaggedArray::new(), RaggedArray::new());
    for polygon in 0..result.f_vector()[2] {
        let first = rings.len() as u32;
        result.rings_of_polygon(FaceId::new(polygon)).for_each(|ring| rings.push(ring));
        polygons.push(&(first..rings.len() as u32).collect::<Vec<u32>>());
    }
    !polygon_faults(result.positions(), &rings, &polygons).unwrap().is_empty()
}

const OPERATIONS: [&str; 4] = ["a | b", "a & b", "a - b", "a ^ b"];

/// The second polygon has two sides along one of the first, and the crossing of two others is rounded into an edge.
#[test]
fn a_vertex_within_an_edge_is_seen_and_mended() {
    let pair = [
        "POLYGON((-1120500.000000126 850931.058865365,-1120500.0000001257 851343.3885007716,\
         -1120500.0000001257 851342.2386007707,-1120399.762684411 851199.4941312922,-1120500.000000126 850931.058865365))",
        "POLYGON((-1120500.000000126 851253.4627870625,-1120500.0000001257 851299.8179383819,\
         -1120492.1498410008 851293.8417889411,-1120500.000000126 851253.4627870625))",
    ]
    .map(str::to_owned);
    let mut request = BooleanRequest::default();
    request.exact = true;
    let exact = combined(&pair, "a | b", &request);
    assert!(!exact.is_valid_when_rounded() && has_faults(&exact));
    let codes = |result: &RegionBoolean| -> Vec<RemarkCode> {
        result.answer().remarks.iter().map(|remark| remark.code).collect()
    };
    assert_eq!(codes(&exact), [RemarkCode::RoundedInvalid]);
    let valid = combined(&pair, "a | b", &BooleanRequest::default());
    assert!(valid.is_valid_when_rounded() && !has_faults(&valid));
    assert_eq!(codes(&valid), [RemarkCode::FeaturesJoined]);
    let rounding = valid.answer().rounding;
    assert!(
        !rounding.exact && rounding.repair.rounds > 0 && rounding.repair.largest_movement < 1e-9,
        "{rounding:?}"
    );
    assert!((valid.area() - exact.area()).abs() < 1e-6);
}

/// These were refused because the rounded copy of a ring crosses itself, or given up after a hundred rounds.
#[test]
fn snapping_takes_valid_polygons_and_ends() {
    let mut request = BooleanRequest::default();
    (request.snap, request.strict) = (true, true);
    for (a, b) in [
        (
            "POLYGON((-314775 2708,-336712 -2708,-332495.8798798799 -1667.0870870870874,-314775 2708))",
            "POLYGON((-321742.91436957236 -4737.74561859717,-324495.928715514 19374.77016942418,\
             -357251.62907800317 17838.204022852125,-321742.91436957236 -4737.74561859717))",
        ),
        (
            "POLYGON((2.4489212000000027 48.7672806,2.4509811 48.7665939,2.4502945 48.7659073,2.4489212000000027 48.7672806))",
            "POLYGON((2.4406815 48.7755203,2.4489212 48.7672806,2.4509811 48.7665939,2.4406815 48.7755203))",
        ),
    ] {
        let pair = [a.to_owned(), b.to_owned()];
        for formula in OPERATIONS {
            let snapped = combined(&pair, formula, &request);
            assert!(snapped.is_valid_when_rounded() && !has_faults(&snapped), "{formula} {a}");
            let answer = snapped.answer();
            assert!(answer.rounding.exact && answer.remarks.is_empty(), "{:?}", answer.remarks);
            let exact = combined(&pair, formula, &BooleanRequest::default());
            assert!((exact.area() - snapped.area()).abs() < 1e-3, "{formula} {a}");
        }
    }
}

#[test]
fn one_result_is_one_geometry() {
    let squares =
        ["POLYGON((0 0,2 0,2 2,0 2,0 0))", "POLYGON((1 -1,1.5 -1,1.5 3,1 3,1 -1))"].map(str::to_owned);
    let request = BooleanRequest::default();
    let expected = "MULTIPOLYGON (((0 0, 1 0, 1 2, 0 2, 0 0)), ((1.5 0, 2 0, 2 2, 1.5 2, 1.5 0)))\n";
    assert_eq!(written(&combined(&squares, "a - b", &request)), expected);
    assert_eq!(written(&combined(&squares, "a & b", &request)), "POLYGON ((1 0, 1.5 0, 1.5 2, 1 2, 1 0))\n");
    assert_eq!(written(&combined(&squares, "a - a", &request)), "POLYGON EMPTY\n");
    let mut walls = BooleanRequest::default();
    walls.keep_walls = true;
    assert_eq!(written(&combined(&squares, "a", &walls)).lines().count(), 3);
}

/// A square that is smaller than the step of the grid beside one that is not.
#[test]
fn what_vanishes_on_a_grid_is_told() {
    let pair =
        ["POLYGON((0 0,8 0,8 8,0 8,0 0))", "POLYGON((20 20,21 20,21 21,20 21,20 20))"].map(str::to_owned);
    let vanished = |step: f64| {
        let mut request = BooleanRequest::default();
        request.grid = Some(step);
        let result = combined(&pair, "a | b", &request);
        let mut asked = ArrangementRequest::default();
        asked.grid = Some(step);
        let arranged = DrawingArrangement::new(drawing(&pair), &asked).unwrap().answer().unwrap();
        let counts = |remarks: &[Remark]| -> Vec<u64> {
            let joined = remarks.iter().filter(|remark| remark.code == RemarkCode::FeaturesJoined);
            joined.map(|remark| remark.count).collect()
        };
        assert_eq!(counts(&result.answer().remarks), counts(&arranged.remarks));
        (result.f_vector()[2], counts(&arranged.remarks))
    };
    assert_eq!(vanished(1.0), (2, vec![]));
    assert_eq!(vanished(4.0), (1, vec![1]));
    assert_eq!(vanished(100.0), (0, vec![2]));
}

#[test]
fn grids_have_all_vertices_of_results() {
    let pair =
        ["POLYGON((0 0,3 0.1234,1 2.71828,0 0))", "POLYGON((1 -1,2.5 0.7,0.31 3,1 -1))"].map(str::to_owned);
    let mut request = BooleanRequest::default();
    request.grid = Some(0.001);
    for formula in OPERATIONS {
        let result = combined(&pair, formula, &request);
        assert!(
            result.positions().as_flat().iter().all(|&x| (x * 1000.0).round() / 1000.0 == x),
            "{formula}"
        );
        assert!(result.is_valid_when_rounded() && !has_faults(&result));
        let exact = combined(&pair, formula, &BooleanRequest::default());
        assert!((exact.area() - result.area()).abs() < 0.01);
    }
    let mut request = ArrangementRequest::default();
    request.grid = Some(0.5);
    let cells = DrawingArrangement::new(drawing(&pair), &request).unwrap();
    assert!(cells.arrangement().positions().as_flat().iter().all(|x| x % 0.5 == 0.0));
    assert!(cells.answer().unwrap().rounding.valid);
}

/// A polygon with corners near those of a fixed one or on its sides, to a few units of the last digit.
fn near(offset: f64) -> impl Strategy<Value = String> {
    let corner = (0usize..6, 0u32..8, -2i64..3, -2i64..3, any::<bool>());
    prop::collection::vec(corner, 3..7).prop_map(move |corners| {
        const BASE: [[f64; 2]; 6] = [[0.1, 0.2], [3.3, 0.7], [4.1, 2.9], [2.2, 2.1], [1.7, 4.4], [0.3, 3.1]];
        let text: Vec<String> = corners
            .into_iter()
            .map(|(side, part, dx, dy, far)| {
                let (from, to) = (BASE[side], BASE[(side + 1) % 6]);
                let part = f64::from(part) / 7.0;
                let [x, y] = [0, 1].map(|axis| offset + from[axis] + part * (to[axis] - from[axis]));
                let [x, y] =
                    [(x, dx), (y, dy)].map(|(x, by)| f64::from_bits(x.to_bits().wrapping_add_signed(by)));
                if far { format!("{} {}", 2.0 * x - offset, y) } else { format!("{x} {y}") }
            })
            .collect();
        format!("POLYGON(({},{}))", text.join(","), text[0])
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn results_of_nearly_equal_polygons_are_valid(
        (a, b) in prop::sample::select(vec![0.0, 1e3, 1e9]).prop_flat_map(|offset| (near(offset), near(offset))),
        walls in any::<bool>(),
    ) {
        let pair = [a, b];
        let mut exact = BooleanRequest::default();
        exact.exact = true;
        for formula in OPERATIONS {
            let as_it_is = combined(&pair, formula, &exact);
            prop_assert_eq!(as_it_is.is_valid_when_rounded(), !has_faults(&as_it_is));
            let valid = combined(&pair, formula, &BooleanRequest::default());
            prop_assert!(valid.is_valid_when_rounded() && !has_faults(&valid));
            let size = as_it_is.positions().as_flat().iter().fold(1.0f64, |most, x| most.max(x.abs()));
            prop_assert!((valid.area() - as_it_is.area()).abs() <= 1000.0 * size * f64::EPSILON);
            if valid.answer().rounding.repair.rounds == 0 {
                prop_assert_eq!(written(&valid), written(&as_it_is));
            }
            // What is written is the result, but for vertices that rounding puts on straight lines.
            let again = combined(&[written(&valid)], "a", &BooleanRequest::default());
            prop_assert_eq!(again.f_vector()[2], valid.f_vector()[2]);
            prop_assert_eq!(again.hole_count(), valid.hole_count());
            prop_assert!((again.area() - valid.area()).abs() <= 1000.0 * size * f64::EPSILON);
            prop_assert!(again.answer().rounding.exact && again.answer().remarks.is_empty());
            let mut request = BooleanRequest::default();
            request.keep_walls = walls;
            let answer = combined(&pair, formula, &request).answer();
            prop_assert!(answer.rounding.valid);
        }
        let cells = DrawingArrangement::new(drawing(&pair), &ArrangementRequest::default()).unwrap();
        prop_assert!(cells.answer().unwrap().rounding.valid);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(20))]

    /// Twenty results that go back in are valid, and have the area of one formula of all inputs.
    #[test]
    fn chains_have_the_area_of_one_formula(
        (first, steps) in prop::sample::select(vec![0.0, 1e4])
            .prop_flat_map(|offset| (near(offset), prop::collection::vec((0usize..4, near(offset)), 20)))
    ) {
        let (mut inputs, mut formula, mut chained) = (vec![first.clone()], "0".to_owned(), first);
        for (operation, next) in steps {
            let pair = [chained.clone(), next.clone()];
            let result = combined(&pair, OPERATIONS[operation], &BooleanRequest::default());
            prop_assert!(!has_faults(&result));
            chained = written(&result);
            formula = format!("({formula}) {} {}", ["|", "&", "-", "^"][operation], inputs.len());
            inputs.push(next);
        }
        let [chained, at_once] = [combined(&[chained], "a", &BooleanRequest::default()), combined(&inputs, &formula, &BooleanRequest::default())];
        let size = inputs.len() as f64 * if chained.positions().is_empty() { 1e4 } else { 1e5 };
        prop_assert!((chained.area() - at_once.area()).abs() <= 1000.0 * size * f64::EPSILON);
    }
}
