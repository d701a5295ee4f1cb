//! Combinations of many solids, some at a time, beside all at once.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::turned_boxes::{TurnedBox, boxes, cuboid};
use coface_algebra::ErrorKind;
use coface_answers::answer::{RemarkCode, SolidBooleanAnswer};
use coface_answers::{
    OpenInputs, SceneArrangement, SolidBoolean, SolidRequest, SpatialRequest, SpatialScene,
};
use coface_arrange::boolean::BooleanFormula;
use coface_io::Model;
use proptest::prelude::*;

fn scene(models: &[Model]) -> SpatialScene {
    let names: Vec<String> = (0..models.len()).map(|i| format!("model {i}")).collect();
    SpatialScene::of(names.iter().map(String::as_str).zip(models), true).unwrap()
}

/// Whether operands are combined some at a time: then no other formula is answered.
fn is_in_parts(models: &[Model], request: &SolidRequest) -> bool {
    let made = SceneArrangement::for_result(scene(models), &SpatialRequest::default(), request).unwrap();
    let other = SolidRequest::of(BooleanFormula::parse("0", &[]).unwrap());
    let is_refused = SolidBoolean::of(&made, &other).is_err();
    assert_eq!(made.answer(request.rule).is_err(), is_refused);
    is_refused
}

fn models(boxes: &[TurnedBox], triangles: bool) -> Vec<Model> {
    boxes.iter().map(|&(middle, half, turns)| cuboid(middle, half, turns, triangles)).collect()
}

/// Formulas over so many inputs, 19 or more: each names all of them once.
fn formulas(count: usize) -> Vec<BooleanFormula> {
    let chain = |range: std::ops::Range<usize>, operator: &str| {
        let names: Vec<String> = range.map(|input| input.to_string()).collect();
        format!("({})", names.join(operator))
    };
    let mixed = [
        format!("{} - {}", chain(0..count - 16, "|"), chain(count - 16..count, "|")),
        format!("{} & {} - 0", chain(1..count - 2, "|"), chain(count - 2..count, "^")),
        format!("{} | {}", chain(0..2, "&"), chain(2..count, "|")),
    ];
    let parsed = mixed.iter().map(|text| BooleanFormula::parse(text, &[]).unwrap());
    [BooleanFormula::union(count), BooleanFormula::intersection(count), BooleanFormula::difference(count)]
        .into_iter()
        .chain(parsed)
        .collect()
}

/// What both ways must agree in.
fn facts(answer: &SolidBooleanAnswer) -> (usize, usize, usize, i64, Option<usize>, bool, bool) {
    let SolidBooleanAnswer { solids, voids, components, euler_characteristic, genus, .. } = *answer;
    (solids, voids, components, euler_characteristic, genus, answer.closed, answer.unbounded)
}

/// Asserts that both ways agree, with the numbers of cells of the surface if `cells`, and that faces are on their sources.
fn assert_same(models: &[Model], request: &SolidRequest, cells: bool) -> Result<(), TestCaseError> {
    let spatial = SpatialRequest::default();
    let whole = SceneArrangement::of_scene(scene(models), &spatial).unwrap();
    let parts = SceneArrangement::for_result(scene(models), &spatial, request).unwrap();
    let [all, some] = [&whole, &parts].map(|own| SolidBoolean::of(own, request).unwrap());
    let [expected, found] = [&all, &some].map(|own| own.answer().unwrap());
    prop_assert_eq!(facts(&expected), facts(&found));
    let [x, y] = [&expected, &found].map(|own| own.measure.unwrap());
    prop_assert!((x - y).abs() <= 1e-13 * x.max(1.0), "{} {}", x, y);
    // What is inside of a union ends at the faces of what it is cut with.
    prop_assert!(!cells || expected.f_vector == found.f_vector);
    prop_assert_eq!(expected.files.len(), found.files.len());
    prop_assert!(found.files.iter().all(|file| file.closed && file.polygons > 0));
    let (mesh, sources) = (some.to_mesh().unwrap(), some.provenance().unwrap().polygons);
    prop_assert_eq!(mesh.polygons().len(), sources.len());
    let normal = |model: &Model, polygon: &[u32]| -> ([f64; 3], [f64; 3]) {
        let points = model.positions().as_flat().as_chunks::<3>().0;
        let at = |i: usize| points[polygon[i] as usize];
        let mut sum = [0.0; 3];
        for i in 1..polygon.len() - 1 {
            let [u, v] = [at(i), at(i + 1)].map(|p| [0, 1, 2].map(|axis| p[axis] - at(0)[axis]));
            let cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
            sum = [0, 1, 2].map(|axis| sum[axis] + cross[axis]);
        }
        (at(0), sum)
    };
    for (polygon, own) in mesh.polygons().iter().zip(&sources) {
        prop_assert!(!own.is_empty());
        let (_, front) = normal(&mesh, polygon);
        for &[input, source, sign] in own {
            let model = &models[input as usize];
            let (origin, plane) = normal(model, model.polygons().list(source as usize));
            let length = plane.iter().map(|x| x * x).sum::<f64>().sqrt();
            for &vertex in polygon {
                let point = mesh.positions().as_flat().as_chunks::<3>().0[vertex as usize];
                let away: f64 = (0..3).map(|axis| (point[axis] - origin[axis]) * plane[axis]).sum();
                prop_assert!((away / length).abs() < 1e-9);
            }
            let dot: f64 = (0..3).map(|axis| front[axis] * plane[axis]).sum();
            prop_assert!(dot * sign as f64 >= -1e-12, "{} {}", dot, sign);
        }
    }
    // By its surface alone where that will do, and all that was arranged last.
    for valid in [some.validly_rounded(), parts.validly_rounded()] {
        let valid = valid.unwrap().expect("boxes of this size can be rounded");
        let rounded = SolidBoolean::of(&valid, request).unwrap();
        prop_assert!(rounded.is_valid().unwrap());
        prop_assert!((rounded.volume().unwrap() - x).abs() < 1e-9);
        prop_assert_eq!(rounded.answer().unwrap().files.len(), models.len());
        let again = valid.snapped().unwrap();
        prop_assert_eq!(again.volumes(), valid.volumes());
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4))]

    #[test]
    fn parts_of_many_solids_are_those_of_all_at_once(
        boxes in boxes(19..23),
        triangles: bool,
        which in 0usize..6,
    ) {
        // Nearer to each other than they are, and more alike.
        let near = |(middle, half, turns): TurnedBox| {
            (middle.map(|x| 0.1 * x), half.map(|x| 0.5 + 0.3 * x), turns)
        };
        let models = models(&boxes.into_iter().map(near).collect::<Vec<_>>(), true);
        let mut request = SolidRequest::of(formulas(models.len()).swap_remove(which));
        request.triangles = triangles;
        prop_assert!(is_in_parts(&models, &request));
        assert_same(&models, &request, which == 0 && !triangles)?;
    }

    /// Many faces in one plane, and edges on each other.
    #[test]
    fn parts_of_boxes_on_a_lattice_are_those_of_all_at_once(
        boxes in prop::collection::vec((prop::array::uniform3(0i32..2), prop::array::uniform3(3i32..5)), 19..27),
        which in 0usize..6,
        triangles: bool,
    ) {
        let boxes: Vec<TurnedBox> = boxes
            .into_iter()
            .map(|(low, sides)| {
                let half = sides.map(|side| f64::from(side) / 2.0);
                ([0, 1, 2].map(|axis| f64::from(low[axis]) + half[axis]), half, [0.0; 2])
            })
            .collect();
        let models = models(&boxes, triangles);
        let mut request = SolidRequest::of(formulas(models.len()).swap_remove(which));
        request.triangles = triangles;
        assert_same(&models, &request, false)?;
    }
}

/// A heap of boxes in a row, each covered by many others, and turned a little more than the one before.
fn heap(count: usize, turn: f64) -> Vec<Model> {
    let place = |i: usize| ([0.1 * i as f64, 0.01 * (i % 7) as f64, 0.0], [1.0; 3], [turn * i as f64, 0.0]);
    models(&(0..count).map(place).collect::<Vec<_>>(), true)
}

#[test]
fn what_covers_itself_is_combined_in_parts() {
    let union = |count: usize| SolidRequest::of(BooleanFormula::union(count));
    assert!(is_in_parts(&heap(20, 0.0), &union(20)));
    assert!(!is_in_parts(&heap(8, 0.0), &union(8)), "few are arranged at once");
    let apart: Vec<TurnedBox> =
        (0..20).map(|i| ([3.0 * f64::from(i), 0.0, 0.0], [1.0; 3], [0.0; 2])).collect();
    assert!(!is_in_parts(&models(&apart, true), &union(20)), "nothing is covered");
    // The exterior is in it; and an input that is not named cuts others.
    let other = |text: &str| SolidRequest::of(BooleanFormula::parse(text, &[]).unwrap());
    assert!(!is_in_parts(&heap(20, 0.0), &other("!0")));
    let complement: Vec<String> = (0..20).map(|i| format!("!{i}")).collect();
    assert!(!is_in_parts(&heap(20, 0.0), &other(&complement.join("&"))));
    let mut walls = union(20);
    walls.keep_walls = true;
    assert!(!is_in_parts(&heap(20, 0.0), &walls));
    // Symmetric differences leave nothing out.
    assert!(!is_in_parts(&heap(20, 0.0), &SolidRequest::of(BooleanFormula::xor(20))));
}

/// What is said of inputs does not depend on how they are combined.
#[test]
fn odd_inputs_are_told_of() {
    let mut models = heap(20, 0.0);
    let count = models.len();
    let mut request = SolidRequest::of(BooleanFormula::union(count));
    // Inside out.
    let turned: Vec<Vec<u32>> =
        models[7].polygons().iter().map(|own| own.iter().rev().copied().collect()).collect();
    let positions = models[7].positions().clone();
    models[7] =
        Model::from_polygons(positions.clone(), coface_algebra::RaggedArray::from_lists(turned)).unwrap();
    let made = SceneArrangement::for_result(scene(&models), &SpatialRequest::default(), &request).unwrap();
    let answer = SolidBoolean::of(&made, &request).unwrap().answer().unwrap();
    assert!(answer.files[7].reversed_cells > 0);
    assert!(answer.remarks.iter().any(|remark| remark.code == RemarkCode::ReversedInput));
    // Open.
    let open: Vec<&[u32]> = models[7].polygons().iter().skip(1).collect();
    models[7] = Model::from_polygons(positions, coface_algebra::RaggedArray::from_lists(open)).unwrap();
    let made = SceneArrangement::for_result(scene(&models), &SpatialRequest::default(), &request).unwrap();
    let error = SolidBoolean::of(&made, &request).unwrap_err();
    assert_eq!((error.kind(), error.file()), (ErrorKind::NotACycle, Some("model 7")));
    request.open = OpenInputs::Empty;
    assert!(!SolidBoolean::of(&made, &request).unwrap().answer().unwrap().files[7].closed);
    // Nothing at all.
    let nothing = coface_geometry::Positions::from_flat(3, Vec::new()).unwrap();
    models[7] = Model::from_polygons(nothing, coface_algebra::RaggedArray::new()).unwrap();
    assert!(is_in_parts(&models, &request));
    let made = SceneArrangement::for_result(scene(&models), &SpatialRequest::default(), &request).unwrap();
    let answer = SolidBoolean::of(&made, &request).unwrap().answer().unwrap();
    assert!(answer.remarks.iter().any(|remark| remark.code == RemarkCode::EmptyInput));
    assert_eq!(answer.files[7].polygons, 0);
}

/// Squares that rounding bends are cut into triangles, and still those of the inputs.
#[test]
fn turned_squares_are_combined_in_parts() {
    let place = |i: usize| ([0.1 * i as f64, 0.0, 0.1], [1.0; 3], [0.1 * i as f64, 0.3]);
    let models = models(&(0..20).map(place).collect::<Vec<_>>(), false);
    let mut request = SolidRequest::of(BooleanFormula::union(20));
    assert!(!is_in_parts(&models, &request), "their polygons are asked for");
    request.triangles = true;
    assert!(is_in_parts(&models, &request));
    assert_same(&models, &request, false).unwrap();
}

/// Results that lose nothing are inputs again.
#[test]
fn exact_results_are_combined_in_parts() {
    let models = heap(40, 0.1);
    let pair = |i: usize| {
        let own = SceneArrangement::of_scene(scene(&models[i..i + 2]), &SpatialRequest::default()).unwrap();
        let union = SolidBoolean::of(&own, &SolidRequest::of(BooleanFormula::union(2))).unwrap();
        union.to_mesh().unwrap().with_exact_polygons(union.exact_polygons().unwrap().into())
    };
    let pairs: Vec<Model> = (0..20).map(|i| pair(2 * i)).collect();
    let [all, of_pairs] = [&models, &pairs].map(|models| {
        let request = SolidRequest::of(BooleanFormula::union(models.len()));
        assert!(is_in_parts(models, &request));
        let made = SceneArrangement::for_result(scene(models), &SpatialRequest::default(), &request).unwrap();
        SolidBoolean::of(&made, &request).unwrap().answer().unwrap()
    });
    assert_eq!(facts(&all), facts(&of_pairs));
    assert!((all.measure.unwrap() - of_pairs.measure.unwrap()).abs() < 1e-12);
}
