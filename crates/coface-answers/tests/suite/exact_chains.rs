//! Chains of operations on solids that keep exact points: the last result is that of one formula.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::turned_boxes::{self, cuboid, operation, through_file};
use coface_algebra::ErrorKind;
use coface_answers::{SceneArrangement, SolidBoolean, SolidRequest, SpatialRequest};
use coface_arrange::boolean::BooleanFormula;
use coface_arrange::spatial::ExactPolygons;
use coface_io::{Format, Model, Structure};
use proptest::prelude::*;
use std::sync::Arc;

fn arranged(models: &[&Model], merge: bool) -> SceneArrangement {
    let mut request = SpatialRequest::default();
    request.merge_coplanar = merge;
    turned_boxes::arranged(models, &request)
}

fn request(formula: &str) -> SolidRequest {
    SolidRequest::of(BooleanFormula::parse(formula, &[]).unwrap())
}

/// The result of a step with exact points, as its file says.
fn step(operands: [&Model; 2], operation: char) -> Model {
    let scene = arranged(&operands, false);
    let result = SolidBoolean::of(&scene, &request(&format!("a {operation} b"))).unwrap();
    let made = result.to_chains().unwrap().with_exact_polygons(result.exact_polygons().unwrap().into());
    let read = through_file(&made, Format::Json);
    assert_eq!(read.exact_polygons(), made.exact_polygons());
    read
}

/// Volume, solids, voids, genus and f-vector of what models are together.
fn facts(models: &[&Model], formula: &str) -> (f64, [usize; 2], Option<u32>, [usize; 3]) {
    let scene = arranged(models, true);
    let result = SolidBoolean::of(&scene, &request(formula)).unwrap();
    let answer = result.answer().unwrap();
    (
        result.volume().unwrap(),
        result.part_counts(),
        answer.genus.map(|genus| genus as u32),
        result.f_vector(),
    )
}

fn agree(models: &[Model], operations: &[char]) -> Result<(), TestCaseError> {
    let mut chained = models[0].clone();
    let mut formula = "0".to_owned();
    for (i, (model, &operation)) in models[1..].iter().zip(operations).enumerate() {
        formula = format!("({formula}) {operation} {}", i + 1);
        let all: Vec<&Model> = models[..i + 2].iter().collect();
        let (volume, parts, genus, _) = facts(&all, &formula);
        if volume == 0.0 {
            return Ok(());
        }
        chained = step([&chained, model], operation);
        let found = facts(&[&chained], "a");
        prop_assert!(
            (found.0 - volume).abs() <= 1e-12 * volume.max(1.0),
            "{formula}: {} for {volume}",
            found.0
        );
        prop_assert_eq!((found.1, found.2), (parts, genus), "{}", &formula);
        // What is read again is what was written.
        let exact = chained.exact_polygons().unwrap();
        let again = arranged(&[&chained], true);
        let again = SolidBoolean::of(&again, &request("a")).unwrap().exact_polygons().unwrap();
        prop_assert_eq!(again.shared().len(), exact.shared().len());
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn chains_of_turned_boxes_are_one_formula(
        boxes in prop::collection::vec(
            (prop::array::uniform3(-1.0..1.0), prop::array::uniform3(0.3..1.0), prop::array::uniform2(0.0..6.3), any::<bool>()),
            3..7,
        ),
        operations in prop::collection::vec(operation(), 6),
    ) {
        let models: Vec<Model> = boxes.iter().map(|&(middle, half, turns, triangles)| cuboid(middle, half, turns, triangles)).collect();
        agree(&models, &operations)?;
    }

    #[test]
    fn chains_of_boxes_that_share_planes_are_one_formula(
        boxes in prop::collection::vec((prop::array::uniform3(-3..4i32), prop::array::uniform3(1..4i32), any::<bool>()), 3..7),
        operations in prop::collection::vec(operation(), 6),
        is_turned in any::<bool>(),
    ) {
        let turns = if is_turned { [0.7, 0.3] } else { [0.0; 2] };
        let models: Vec<Model> = boxes
            .iter()
            .map(|&(middle, half, triangles)| cuboid(middle.map(f64::from), half.map(|x| 0.5 * f64::from(x)), turns, triangles))
            .collect();
        agree(&models, &operations)?;
    }
}

/// A ninth of a cube by a plane that is none of binary fractions: rounded, the parts would not fit.
#[test]
fn parts_that_were_cut_fit_again() {
    let cube = cuboid([0.0; 3], [1.0; 3], [0.2, 0.5], true);
    let knife = cuboid([0.1, 0.2, 1.3], [5.0, 5.0, 1.0], [0.4, 0.9], true);
    let (below, above) = (step([&cube, &knife], '-'), step([&cube, &knife], '&'));
    // Together they are the cube again, with no gap and no overlap.
    assert_eq!(facts(&[&below, &above], "a | b").1, [1, 0]);
    assert_eq!(facts(&[&below, &above], "a & b").0, 0.0);
    assert_eq!(facts(&[&cube, &below, &above], "(a ^ b) ^ c").3, [0; 3]);
    // Rounded, this is not so.
    let rounded = |model: &Model| {
        Model::from_chains(
            match model.structure() {
                Some(Structure::Chains(complex)) => complex.clone(),
                _ => panic!("a chain complex"),
            },
            model.positions().clone(),
        )
        .unwrap()
    };
    assert_ne!(facts(&[&cube, &rounded(&below), &rounded(&above)], "(a ^ b) ^ c").3, [0; 3]);
}

/// Cells of an arrangement with walls between them.
#[test]
fn arrangements_are_input_with_their_walls() {
    let (a, b) =
        (cuboid([0.0; 3], [1.0; 3], [0.3, 0.8], true), cuboid([0.7, 0.1, 0.4], [1.0; 3], [0.0; 2], false));
    let scene = arranged(&[&a, &b], true);
    let model = scene.to_chains(false).unwrap().with_exact_polygons(scene.exact_polygons().into());
    let walls = model.exact_polygons().unwrap().shared();
    assert!(walls.contains(&true) && walls.contains(&false));
    let again = arranged(&[&model], true);
    assert_eq!(again.complex().f_vector(), scene.complex().f_vector());
    let sorted = |volumes: &[f64]| {
        let mut volumes: Vec<i64> = volumes.iter().map(|x| (x * 1e9).round() as i64).collect();
        volumes.sort_unstable();
        volumes
    };
    assert_eq!(sorted(again.volumes()), sorted(scene.volumes()));
    // As a solid it is the union.
    let union = facts(&[&a, &b], "a | b");
    assert_eq!(facts(&[&model], "a").1, union.1);
    assert!((facts(&[&model], "a").0 - union.0).abs() < 1e-12);
}

/// Outlines that leave their triangles are refused with a place.
#[test]
fn broken_outlines_are_refused() {
    let cube = cuboid([0.0; 3], [1.0; 3], [0.0; 2], false);
    let knife = cuboid([0.1, 0.2, 1.3], [5.0, 5.0, 1.0], [0.4, 0.9], true);
    let cut = step([&cube, &knife], '-');
    let exact = cut.exact_polygons().unwrap();
    let with = |vertices: &[Vec<u32>], parts: Vec<_>| {
        ExactPolygons::new(exact.points().to_vec(), vertices, parts, exact.shared().to_vec())
    };
    let vertices: Vec<Vec<u32>> = exact.vertices().iter().map(<[u32]>::to_vec).collect();
    assert_eq!(with(&vertices, exact.parts().to_vec()).unwrap(), **exact);
    // Without the knife's triangle nothing is cut there.
    let of_cube = exact.parts().iter().filter(|part| part.walks.iter().flatten().count() >= 3);
    let first = of_cube.map(|part| part.polygon).next().unwrap();
    let wanted: Vec<bool> = (0..exact.shared().len()).map(|polygon| polygon as u32 == first).collect();
    let alone = cut.clone().with_exact_polygons(Arc::new(exact.with(&wanted)));
    let names = [("alone.json", &alone)];
    if let Err(error) = SceneArrangement::of(names, &SpatialRequest::default()) {
        assert_eq!(error.kind(), ErrorKind::InvalidInput);
        assert!(error.to_string().contains("exact"), "{error}");
    }
    // A vertex that is somewhere else is not in the plane.
    let mut moved = vertices;
    let at = moved.iter().position(|own| own.len() > 1).unwrap();
    moved[at] = vec![0];
    assert!(with(&moved, exact.parts().to_vec()).unwrap_err().message().contains("is not in the plane"));
    moved[at] = vec![0, 1];
    assert!(with(&moved, exact.parts().to_vec()).unwrap_err().message().contains("is a list of 2 points"));
}
