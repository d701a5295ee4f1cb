//! Chains of operations on solids whose results are rounded: each step ends, is valid, and the last one is what one
//! formula gives.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::turned_boxes::{self, TurnedBox, cuboid, operation, through_file};
use coface_answers::answer::RemarkCode;
use coface_answers::{SceneArrangement, SolidBoolean, SolidRequest, SpatialRequest, are_planar};
use coface_arrange::boolean::{BooleanFormula, InsideRule};
use coface_arrange::spatial::SpatialPolygons;
use coface_geometry::Positions;
use coface_io::{self as io, Format, Model};
use proptest::prelude::*;

const BOXES: [TurnedBox; 4] = [
    (
        [-0.25349435344943694, -0.23205870375570914, 0.38825700797558493],
        [0.7147316480821025, 0.4220276164972092, 0.32071784944054155],
        [4.698085669825593, 0.8480005975302459],
    ),
    (
        [-0.8687293217221923, -0.7996489361488524, 0.7552916183489449],
        [0.5013221404646708, 0.3051725376002868, 0.6020848339664462],
        [5.643974545164065, 4.884069426891516],
    ),
    (
        [-0.5705026874588142, -0.19123736261888613, -0.008264055571726603],
        [0.5198649118365638, 0.8101850897229759, 0.38589354297550177],
        [3.054032983249158, 5.6678898066290975],
    ),
    (
        [-0.03523907776586954, 0.08567268719013099, 0.411041941195059],
        [0.6713176851171461, 0.45279440898002343, 0.5101818010138501],
        [3.024210899870286, 0.43294379124521243],
    ),
];

fn arranged(models: &[&Model]) -> SceneArrangement {
    turned_boxes::arranged(models, &SpatialRequest::default())
}

fn request(formula: &str) -> SolidRequest {
    let mut request = SolidRequest::of(BooleanFormula::parse(formula, &[]).unwrap());
    (request.triangles, request.split_pinches, request.merge_coplanar) = (true, true, true);
    request
}

/// The result through a file of triangles, rounded validly; and its volume.
fn step(operands: [&Model; 2], operation: char) -> (Model, f64) {
    let request = request(&format!("a {operation} b"));
    let exact = arranged(&operands);
    let found = SolidBoolean::of(&exact, &request).unwrap();
    let rounded = match found.crossings().unwrap().count {
        0 => None,
        _ => found.validly_rounded().unwrap(),
    };
    let result = SolidBoolean::of(rounded.as_ref().unwrap_or(&exact), &request).unwrap();
    assert_eq!(result.crossings().unwrap().count, 0);
    let mesh = result.to_mesh().unwrap();
    let polygons = SpatialPolygons::from_polygons(mesh.positions().clone(), mesh.polygons().clone()).unwrap();
    assert_eq!(polygons.crossings(1).unwrap().count, 0);
    (through_file(&result.to_mesh().unwrap(), Format::Off), result.volume().unwrap())
}

fn agree(models: &[Model], operations: &[char]) -> Result<(), TestCaseError> {
    let mut chained = models[0].clone();
    let mut formula = "0".to_owned();
    let mut volume = 0.0;
    for (i, (model, &operation)) in models[1..].iter().zip(operations).enumerate() {
        formula = format!("({formula}) {operation} {}", i + 1);
        (chained, volume) = step([&chained, model], operation);
    }
    let all: Vec<&Model> = models.iter().collect();
    let whole = arranged(&all);
    let result = SolidBoolean::of(&whole, &request(&formula)).unwrap();
    let expected = result.volume().unwrap();
    prop_assert!(
        (volume - expected).abs() <= 1e-12 * expected.max(1.0),
        "{formula}: {volume} for {expected}"
    );
    // The faces of each box are one polygon still.
    let counts = [chained.polygons().len(), result.surface().polygons().len()];
    prop_assert!(counts[0] <= counts[1] + counts[1] / 8 + 8, "{formula}: {counts:?}");
    Ok(())
}

/// A union of a cut box and a third one whose faces meet in a line along an axis: its parts are straight within rounding,
/// and a sweep across that line met them in the order of their errors, round after round.
#[test]
fn a_line_across_the_sweep_comes_to_an_end() {
    let boxes = BOXES.map(|(middle, half, turns)| cuboid(middle, half, turns, true));
    agree(&boxes, &['|', '-', '|']).unwrap();
}

/// A result rounded validly by its surface alone is what it is with all cells of the arrangement.
fn agree_alone_and_whole(models: &[&Model], request: &SolidRequest) -> Result<(), TestCaseError> {
    let exact = arranged(models);
    let found = SolidBoolean::of(&exact, request).unwrap();
    // No place is missed by looking at what rounding moved alone.
    let polygons = found.surface().polygons().clone();
    let polygons = SpatialPolygons::from_polygons(found.positions().unwrap(), polygons).unwrap();
    if let Ok(all) = polygons.crossings(1) {
        prop_assert!(found.crossings().unwrap().count >= all.count);
    }
    let (Some(alone), Some(whole)) = (found.validly_rounded().unwrap(), exact.validly_rounded().unwrap())
    else {
        return Err(TestCaseError::fail("boxes are rounded validly"));
    };
    let [alone, whole] = [&alone, &whole].map(|rounded| SolidBoolean::of(rounded, request).unwrap());
    prop_assert!(alone.is_valid().unwrap());
    let [a, b] = [&alone, &whole].map(|result| result.answer().unwrap());
    prop_assert_eq!((a.solids, a.voids, a.components), (b.solids, b.voids, b.components));
    prop_assert_eq!((a.closed, a.unbounded, a.cells, a.genus), (b.closed, b.unbounded, b.cells, b.genus));
    prop_assert_eq!(a.pinches.edge_count, b.pinches.edge_count);
    prop_assert_eq!(format!("{:?}", a.files), format!("{:?}", b.files));
    prop_assert!((a.area.unwrap() - b.area.unwrap()).abs() <= 1e-12 * b.area.unwrap().max(1.0));
    let difference = a.measure.unwrap_or_default() - b.measure.unwrap_or_default();
    prop_assert!(difference.abs() <= 1e-12 * b.measure.unwrap_or_default().max(1.0), "{difference:e}");
    // Each polygon is of the same polygons of the inputs as one that it lies on.
    let sources = |result: &SolidBoolean<'_>| {
        let mut own: Vec<String> =
            result.provenance().unwrap().polygons.iter().map(|own| format!("{own:?}")).collect();
        own.sort_unstable();
        own.dedup();
        own
    };
    if !request.merge_coplanar {
        prop_assert_eq!(sources(&alone), sources(&whole));
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn a_surface_alone_is_rounded_as_all_cells_are(
        boxes in turned_boxes::boxes(2..6),
        formula in prop::sample::select(vec!["a | b", "a & b", "a - b", "a ^ b", "~(a | b)"]),
        triangles in any::<bool>(),
        splits in any::<bool>(),
    ) {
        let models: Vec<Model> = boxes.iter().map(|&(middle, half, turns)| cuboid(middle, half, turns, triangles)).collect();
        let models: Vec<&Model> = models.iter().collect();
        let formula = match formula {
            "a | b" => BooleanFormula::union(models.len()),
            "a ^ b" => BooleanFormula::xor(models.len()),
            "a - b" => BooleanFormula::difference(models.len()),
            "a & b" => BooleanFormula::intersection(models.len()),
            text => BooleanFormula::parse(text, &[]).unwrap(),
        };
        let mut request = SolidRequest::of(formula);
        (request.triangles, request.split_pinches, request.merge_coplanar) = (triangles, splits, triangles);
        agree_alone_and_whole(&models, &request)?;
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]

    #[test]
    fn rounded_chains_are_one_formula(
        boxes in turned_boxes::boxes(3..7),
        operations in prop::collection::vec(operation(), 6),
        are_of_one_turn in any::<bool>(),
    ) {
        let own = |turns| if are_of_one_turn { boxes[0].2 } else { turns };
        let models: Vec<Model> = boxes.iter().map(|&(middle, half, turns)| cuboid(middle, half, own(turns), true)).collect();
        agree(&models, &operations)?;
    }
}

/// Nothing is left of a solid without itself, in every format; and that is a solid of the next operation.
#[test]
fn nothing_is_an_input() {
    let cube = cuboid([0.0; 3], [0.5; 3], [0.3, 0.2], true);
    let scene = arranged(&[&cube, &cube]);
    let empty = SolidBoolean::of(&scene, &request("a - b")).unwrap();
    let mesh = empty.to_mesh().unwrap();
    let formats =
        [Format::Off, Format::Obj, Format::Ply, Format::Stl, Format::Vtk, Format::Medit, Format::Msh];
    let mut models: Vec<Model> = formats.iter().map(|&format| through_file(&mesh, format)).collect();
    let chains = empty.to_chains().unwrap();
    models.push(through_file(&chains, Format::Json));
    models.push(through_file(
        &chains.with_exact_polygons(empty.exact_polygons().unwrap().into()),
        Format::Json,
    ));
    for nothing in &models {
        assert!(!are_planar([nothing, &cube]));
        let scene = arranged(&[nothing, &cube]);
        let answer = scene.answer(InsideRule::Nonzero).unwrap();
        assert_eq!(
            answer.remarks.iter().map(|remark| remark.code).collect::<Vec<_>>(),
            [RemarkCode::EmptyInput]
        );
        for (formula, volume) in
            [("a | b", 1.0), ("b - a", 1.0), ("a - b", 0.0), ("a & b", 0.0), ("a ^ b", 1.0)]
        {
            let found = SolidBoolean::of(&scene, &request(formula)).unwrap().volume().unwrap();
            assert!((found - volume).abs() < 1e-15, "{formula}");
        }
        let alone = arranged(&[nothing]);
        assert_eq!(SolidBoolean::of(&alone, &request("a")).unwrap().f_vector(), [0; 3]);
    }
}

/// Copies of a mesh, each turned a little more around an axis that goes through them: faces lie along each other where two copies pass.
#[test]
fn turned_copies_of_a_mesh_are_rounded() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/spot.obj");
    let mesh = io::read(&std::fs::read(path).unwrap()[..], Format::Obj).unwrap();
    let turned = |i: u32| {
        let (s, c) = (std::f64::consts::TAU * f64::from(i) / 30.0).sin_cos();
        let points = mesh.positions().as_flat().as_chunks::<3>().0.iter();
        let flat = points.flat_map(|&[x, y, z]| [c * x + s * z, y, c * z - s * x]).collect();
        Model::from_polygons(Positions::from_flat(3, flat).unwrap(), mesh.polygons().clone()).unwrap()
    };
    let copies: Vec<Model> = (0..8).map(turned).collect();
    let scene = arranged(&copies.iter().collect::<Vec<_>>());
    let mut request = SolidRequest::of(BooleanFormula::union(copies.len()));
    request.triangles = true;
    let exact = SolidBoolean::of(&scene, &request).unwrap();
    assert!(!exact.is_valid().unwrap());
    let rounded = exact.validly_rounded().unwrap().expect("a few units of the last place are enough");
    let result = SolidBoolean::of(&rounded, &request).unwrap();
    assert!(result.is_valid().unwrap());
    assert!((result.volume().unwrap() - exact.volume().unwrap()).abs() < 1e-12);
    assert!(result.answer().unwrap().joined.unwrap().largest_movement < 1e-13);
}
