//! Tubes along curves that cross themselves: rounding of large self-overlapping input ends, and is valid; so is rounding to
//! the coordinates of an STL file.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::turned_boxes::{arranged, boxes, cuboid, operation, through_file};
use coface_algebra::RaggedArray;
use coface_answers::{SceneArrangement, SolidBoolean, SolidRequest, SpatialRequest};
use coface_arrange::CoordinatePrecision;
use coface_arrange::boolean::{BooleanFormula, InsideRule};
use coface_arrange::spatial::SpatialPolygons;
use coface_geometry::Positions;
use coface_io::{Format, Model};
use proptest::prelude::*;
use std::f64::consts::TAU;

/// The closed tube of a radius around a closed curve, a polygon of so many corners swept in so many steps.
fn tube([steps, around]: [usize; 2], radius: f64, curve: impl Fn(f64) -> [f64; 3]) -> Model {
    let unit = |v: [f64; 3]| v.map(|x| x / v.iter().map(|x| x * x).sum::<f64>().sqrt());
    let cross = |a: [f64; 3], b: [f64; 3]| {
        [0, 1, 2].map(|i| a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3])
    };
    let (mut flat, mut triangles) = (Vec::new(), Vec::new());
    for i in 0..steps {
        let t = TAU * i as f64 / steps as f64;
        let (middle, before, after) = (curve(t), curve(t - 1e-5), curve(t + 1e-5));
        let along = unit([0, 1, 2].map(|axis| after[axis] - before[axis]));
        let u = unit(cross(along, [0.1, 0.2, 1.0]));
        let v = cross(along, u);
        for j in 0..around {
            let (s, c) = (TAU * j as f64 / around as f64).sin_cos();
            flat.extend([0, 1, 2].map(|axis| middle[axis] + radius * (c * u[axis] + s * v[axis])));
            let at = |i: usize, j: usize| (i % steps * around + j % around) as u32;
            let [a, b, c, d] = [at(i, j), at(i, j + 1), at(i + 1, j), at(i + 1, j + 1)];
            triangles.extend([[a, b, d], [a, d, c]]);
        }
    }
    Model::from_polygons(Positions::from_flat(3, flat).unwrap(), RaggedArray::from_lists(triangles)).unwrap()
}

fn request(formula: &str) -> SolidRequest {
    let mut request = SolidRequest::of(BooleanFormula::parse(formula, &[]).unwrap());
    (request.triangles, request.split_pinches, request.merge_coplanar) = (true, true, true);
    request
}

/// The result, rounded validly to the numbers of a format, through a file of it.
fn step(models: &[&Model], request: &SolidRequest, format: Format) -> (Model, f64) {
    let mut spatial = SpatialRequest::default();
    if format == Format::Stl {
        spatial.precision = CoordinatePrecision::Single;
    }
    let exact = arranged(models, &spatial);
    let mut rounded = None;
    if !SolidBoolean::of(&exact, request).unwrap().is_valid().unwrap() {
        rounded = exact.validly_rounded().unwrap();
        assert!(rounded.is_some(), "rounding came to no end");
    }
    let arrangement: &SceneArrangement = rounded.as_ref().unwrap_or(&exact);
    let result = SolidBoolean::of(arrangement, request).unwrap();
    assert!(result.is_valid().unwrap());
    let read = through_file(&result.to_mesh().unwrap(), format);
    let polygons = SpatialPolygons::from_polygons(read.positions().clone(), read.polygons().clone()).unwrap();
    assert_eq!(polygons.crossings(3).unwrap().count, 0, "{:?}", polygons.crossings(3));
    (read, result.volume().unwrap())
}

/// The union of a tube with itself by positive winding numbers: with rounded coordinates it has the volume of the exact one.
fn assert_united(tube: &Model) {
    let mut request = request("a");
    request.rule = InsideRule::Positive;
    let exact = arranged(&[tube], &SpatialRequest::default());
    let volume = SolidBoolean::of(&exact, &request).unwrap().volume().unwrap();
    for (format, within) in [(Format::Off, 1e-9), (Format::Stl, 1e-4)] {
        let (united, found) = step(&[tube], &request, format);
        assert!((found - volume).abs() <= within * volume, "{format:?}: {found} for {volume}");
        // What is united is an input again, and nothing changes.
        let (again, same) = step(&[&united], &request, format);
        assert!((same - volume).abs() <= within * volume, "{format:?}: {same} for {volume}");
        assert!(again.polygons().len() <= united.polygons().len() + 8);
    }
}

#[test]
fn tubes_that_overlap_themselves_are_rounded_validly() {
    assert_united(&tube([60, 30], 0.25, |t| {
        [t.cos() + 0.3 * (7.0 * t).cos(), t.sin() + 0.3 * (7.0 * t).sin(), 0.2 * (5.0 * t).sin()]
    }));
    assert_united(&tube([60, 30], 0.8, |t| {
        let radius = 2.0 + (3.0 * t).cos();
        [radius * (2.0 * t).cos(), radius * (2.0 * t).sin(), (3.0 * t).sin()]
    }));
}

/// A tube that runs twice around the same circle: its two layers are one but for rounding.
#[test]
fn a_tube_on_itself_is_rounded_validly() {
    assert_united(&tube([20, 9], 0.3, |t| [(2.0 * t).cos(), (2.0 * t).sin(), 0.0]));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4))]

    /// Each step of a chain through STL is valid with the 32 bits that the file holds.
    #[test]
    fn chains_through_stl_are_valid(
        boxes in boxes(8..12),
        operations in prop::collection::vec(operation(), 11),
    ) {
        let models: Vec<Model> =
            boxes.iter().map(|&(middle, half, turns)| cuboid(middle, half, turns, true)).collect();
        let mut chained = models[0].clone();
        let mut formula = "0".to_owned();
        let mut volume = 0.0;
        for (i, (model, operation)) in models[1..].iter().zip(operations).enumerate() {
            formula = format!("({formula}) {operation} {}", i + 1);
            (chained, volume) = step(&[&chained, model], &request(&format!("a {operation} b")), Format::Stl);
        }
        let all: Vec<&Model> = models.iter().collect();
        let whole = arranged(&all, &SpatialRequest::default());
        let expected = SolidBoolean::of(&whole, &request(&formula)).unwrap().volume().unwrap();
        prop_assert!((volume - expected).abs() <= 1e-4, "{formula}: {volume} for {expected}");
    }
}
