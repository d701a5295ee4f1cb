//! Boolean combinations of drawings, which are made on an overlay, against arrangements of the same drawings.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use coface_algebra::{EdgeId, ErrorKind, FaceId};
use coface_answers::answer::RemarkCode;
use coface_answers::{
    ArrangementRequest, BooleanRequest, DrawingArrangement, PlanarDrawing, RegionBoolean, RegionSource,
};
use coface_arrange::boolean::{BooleanFormula, InsideRule};
use coface_io as io;
use coface_io::{Format, Model};
use proptest::prelude::*;

type Ring = Vec<[i32; 2]>;

/// Polygons with holes, and an open line.
#[derive(Clone, Debug)]
struct Drawn {
    polygons: Vec<Vec<Ring>>,
    line: Option<Ring>,
}

fn ring() -> impl Strategy<Value = Ring> {
    prop::collection::vec(prop::array::uniform2(0i32..7), 3..7)
}

fn drawn() -> impl Strategy<Value = Drawn> {
    let polygons = prop::collection::vec(prop::collection::vec(ring(), 1..4), 1..4);
    let line = prop::option::of(prop::collection::vec(prop::array::uniform2(-1i32..8), 2..4));
    (polygons, line).prop_map(|(polygons, line)| Drawn { polygons, line })
}

fn model(drawn: &Drawn) -> Model {
    let points = |ring: &Ring, closes: bool| {
        let last = ring.first().filter(|_| closes);
        let points: Vec<String> = ring.iter().chain(last).map(|[x, y]| format!("{x} {y}")).collect();
        points.join(", ")
    };
    let mut text = String::new();
    for polygon in &drawn.polygons {
        let rings: Vec<String> = polygon.iter().map(|ring| format!("({})", points(ring, true))).collect();
        text += &format!("POLYGON ({})\n", rings.join(", "));
    }
    if let Some(line) = &drawn.line {
        text += &format!("LINESTRING ({})\n", points(line, false));
    }
    io::read(text.as_bytes(), Format::Wkt).unwrap()
}

fn drawing(models: &[Model]) -> PlanarDrawing {
    let names = ["a", "b", "c"];
    PlanarDrawing::new(names.into_iter().zip(models), RegionSource::Models).unwrap()
}

fn sorted(mut areas: Vec<f64>) -> Vec<f64> {
    areas.sort_by(f64::total_cmp);
    areas
}

fn is_near(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-13 * a.abs().max(b.abs())
}

proptest! {
    #[test]
    fn what_a_formula_selects_is_the_faces_of_the_arrangement_that_it_selects(
        drawn in prop::collection::vec(drawn(), 2..4),
        formula in prop::sample::select(vec!["a | b", "a & b", "a - b", "a ^ b", "(a | b) - (a & b)"]),
        rule in prop::sample::select(vec![InsideRule::Nonzero, InsideRule::Odd, InsideRule::Positive]),
        snap in any::<bool>(),
    ) {
        let models: Vec<Model> = drawn.iter().map(model).collect();
        let formula = BooleanFormula::parse(formula, &[]).unwrap();
        let mut request = ArrangementRequest::default();
        (request.rule, request.snap, request.exact) = (Some(rule), snap, true);
        let arranged = DrawingArrangement::new(drawing(&models), &request).unwrap();
        let face_count = arranged.arrangement().face_count();
        let inside = |face: usize| arranged.regions_around(FaceId::new(face));
        let selected: Vec<usize> = (0..face_count)
            .filter(|&face| formula.evaluate(|input| inside(face).contains(&(input as u32))))
            .collect();
        let areas = arranged.arrangement().areas();
        let mut request = BooleanRequest::default();
        (request.rule, request.snap, request.exact) = (Some(rule), snap, true);
        let merged = RegionBoolean::new(drawing(&models), &formula, &request).unwrap();
        prop_assert!(is_near(merged.area(), selected.iter().map(|&face| areas[face]).sum()));
        request.keep_walls = true;
        let walls = RegionBoolean::new(drawing(&models), &formula, &request).unwrap();
        prop_assert_eq!(walls.f_vector()[2], selected.len());
        let [found, expected] =
            [walls.polygon_areas().to_vec(), selected.iter().map(|&face| areas[face]).collect()].map(sorted);
        prop_assert!(found.iter().zip(&expected).all(|(&a, &b)| is_near(a, b)), "{:?} {:?}", found, expected);
        let mut around: Vec<&[u32]> = (0..selected.len()).map(|i| walls.regions_of_polygon(FaceId::new(i))).collect();
        let mut expected: Vec<&[u32]> = selected.iter().map(|&face| inside(face)).collect();
        around.sort_unstable();
        expected.sort_unstable();
        prop_assert_eq!(around, expected);
        prop_assert_eq!(walls.component_count(), merged.component_count());
        prop_assert_eq!(walls.pinches().len(), merged.pinches().len());
        for result in [&walls, &merged] {
            let [vertices, edges, polygons] = result.f_vector();
            prop_assert!(!snap || result.is_valid_when_rounded());
            let rings: Vec<&[u32]> = (0..polygons).flat_map(|polygon| result.rings_of_polygon(FaceId::new(polygon))).collect();
            prop_assert_eq!(rings.len() - polygons, result.hole_count());
            // Rings begin with their lowest vertices; all vertices and edges are on rings.
            prop_assert!(rings.iter().all(|ring| ring.iter().all(|&vertex| vertex >= ring[0])));
            let mut sides: Vec<[u32; 2]> = rings
                .iter()
                .flat_map(|ring| ring.iter().zip(ring.iter().cycle().skip(1)))
                .map(|(&a, &b)| [a.min(b), a.max(b)])
                .collect();
            sides.sort_unstable();
            sides.dedup();
            prop_assert_eq!(&sides[..], result.edges());
            let mut used: Vec<u32> = sides.as_flattened().to_vec();
            used.sort_unstable();
            used.dedup();
            prop_assert_eq!(used.len(), vertices);
            prop_assert!((0..edges).all(|edge| !result.segments_of_edge(EdgeId::new(edge)).is_empty()));
        }
    }
}

#[test]
fn lines_divide_faces_and_bound_nothing() {
    let square = vec![vec![[0, 0], [4, 0], [4, 4], [0, 4]]];
    let cut = Drawn { polygons: vec![square], line: Some(vec![[2, -1], [2, 5]]) };
    let formula = BooleanFormula::parse("a", &[]).unwrap();
    let mut request = BooleanRequest::default();
    let whole = RegionBoolean::new(drawing(&[model(&cut)]), &formula, &request).unwrap();
    assert_eq!(whole.f_vector(), [4, 4, 1]);
    request.keep_walls = true;
    let parts = RegionBoolean::new(drawing(&[model(&cut)]), &formula, &request).unwrap();
    assert_eq!((parts.f_vector(), parts.component_count()), ([6, 7, 2], 1));
    assert_eq!(parts.polygon_areas(), [8.0, 8.0]);
    assert_eq!(parts.answer().arrangement, [8, 9, 2]);
}

#[test]
fn holes_that_are_not_inside_of_their_outer_rings_are_named() {
    let square = |x: i32, side: i32| vec![[x, 0], [x + side, 0], [x + side, side], [x, side]];
    let stray = Drawn { polygons: vec![vec![square(0, 4), square(1, 2), square(6, 2)]], line: None };
    let formula = BooleanFormula::parse("a", &[]).unwrap();
    let found = RegionBoolean::new(drawing(&[model(&stray)]), &formula, &BooleanRequest::default()).unwrap();
    assert_eq!(found.area(), 12.0);
    assert_eq!(found.warnings().len(), 1);
    assert!(
        found.warnings()[0].starts_with("a: hole 2 of polygon 0 is not inside"),
        "{:?}",
        found.warnings()
    );
    // A ring that crosses itself is taken as what it winds around, and refused with the place if strict.
    let bow = Drawn { polygons: vec![vec![vec![[0, 0], [2, 2], [2, 0], [0, 2]]]], line: None };
    let found = RegionBoolean::new(drawing(&[model(&bow)]), &formula, &BooleanRequest::default()).unwrap();
    assert_eq!((found.area(), found.f_vector()), (2.0, [5, 6, 2]));
    let remark = &found.answer().remarks[0];
    assert_eq!((remark.code, remark.count), (RemarkCode::SelfCrossingRing, 1));
    assert_eq!(remark.places[0].point.as_deref(), Some(&[1.0, 1.0][..]));
    let mut strict = BooleanRequest::default();
    strict.strict = true;
    let refused = RegionBoolean::new(drawing(&[model(&bow)]), &formula, &strict).unwrap_err();
    assert_eq!(refused.kind(), ErrorKind::InvalidInput);
    assert!(refused.to_string().contains("polygon 0 crosses itself at (1, 1)"), "{refused}");
}

/// The area of polygons by slabs between the heights at which sides end or cross: a second method, on numbers that are
/// rounded. What a ring winds around is inside of it; holes are subtracted, polygons united.
fn area_by_slabs(drawn: &Drawn) -> f64 {
    let sides = |ring: &Ring| -> Vec<[[f64; 2]; 2]> {
        let ends = ring.iter().zip(ring.iter().cycle().skip(1));
        ends.map(|(a, b)| [a, b].map(|p| p.map(f64::from))).filter(|[a, b]| a[0] != b[0]).collect()
    };
    let all: Vec<[[f64; 2]; 2]> = drawn.polygons.iter().flatten().flat_map(sides).collect();
    let height = |[a, b]: [[f64; 2]; 2], x: f64| a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]);
    let slope = |[a, b]: [[f64; 2]; 2]| (b[1] - a[1]) / (b[0] - a[0]);
    let mut events: Vec<f64> = all.iter().flatten().map(|point| point[0]).collect();
    for (i, &s) in all.iter().enumerate() {
        for &t in &all[..i] {
            if slope(s) != slope(t) {
                events.push((height(t, 0.0) - height(s, 0.0)) / (slope(s) - slope(t)));
            }
        }
    }
    events.sort_by(f64::total_cmp);
    let is_inside = |x: f64, y: f64| {
        let winds = |ring: &Ring| {
            let crossings = sides(ring).into_iter().filter(|side| (side[0][0] < x) != (side[1][0] < x));
            let above = crossings.filter(|&side| height(side, x) > y);
            above.map(|[a, b]| if a[0] < b[0] { 1 } else { -1 }).sum::<i32>() != 0
        };
        drawn.polygons.iter().any(|rings| winds(&rings[0]) && !rings[1..].iter().any(winds))
    };
    let mut area = 0.0;
    for slab in events.windows(2).filter(|slab| slab[1] - slab[0] > 1e-9) {
        let x = f64::midpoint(slab[0], slab[1]);
        let crossed = all.iter().filter(|side| (side[0][0] < x) != (side[1][0] < x));
        let mut heights: Vec<f64> = crossed.map(|&side| height(side, x)).collect();
        heights.sort_by(f64::total_cmp);
        for pair in heights.windows(2).filter(|pair| is_inside(x, f64::midpoint(pair[0], pair[1]))) {
            area += (slab[1] - slab[0]) * (pair[1] - pair[0]);
        }
    }
    area
}

proptest! {
    #[test]
    fn rings_that_cross_themselves_contain_what_each_winds_around(drawn in drawn()) {
        // Repeated points and polygons that are points are left out of files.
        prop_assume!(drawn.polygons.iter().flatten().all(|ring| ring.iter().any(|point| point != &ring[0])));
        let models = [model(&drawn)];
        let formula = BooleanFormula::parse("a", &[]).unwrap();
        let found = RegionBoolean::new(drawing(&models), &formula, &BooleanRequest::default()).unwrap();
        let expected = area_by_slabs(&drawn);
        prop_assert!((found.area() - expected).abs() < 1e-7, "{} {}", found.area(), expected);
        // The remark names rings that cross themselves, and strict requests are refused exactly then.
        let remarks = found.answer().remarks;
        let crossing = remarks.iter().find(|remark| remark.code == RemarkCode::SelfCrossingRing);
        let mut strict = BooleanRequest::default();
        strict.strict = true;
        let refused = RegionBoolean::new(drawing(&models), &formula, &strict);
        prop_assert_eq!(refused.is_err(), crossing.is_some());
        let arranged = DrawingArrangement::new(drawing(&models), &ArrangementRequest::default()).unwrap();
        let remarks = arranged.answer().unwrap().remarks;
        let other = remarks.iter().find(|remark| remark.code == RemarkCode::SelfCrossingRing);
        prop_assert_eq!(other.map(|remark| remark.count), crossing.map(|remark| remark.count));
    }
}
