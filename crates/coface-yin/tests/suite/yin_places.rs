//! Nearest points, samples, curvatures and images of sets against closed forms and dense polylines.
#![allow(clippy::unwrap_used, reason = "a failing test shows where")]

use crate::splines::{Random, case_count, smooth_set};
use coface_geometry::{AffineMap, Angle};
use coface_yin::{Curve, KnotIndex, Order, Sampling, SetLocation, YinSet};

fn ellipse(count: usize) -> YinSet {
    YinSet::new(&[Curve::ellipse([0.0, 0.0], [2.0, 1.0], count, Order::CUBIC).unwrap()]).unwrap()
}

/// The second method: all places of all pieces, so near to each other that the nearest is not missed by more than a bound.
fn by_force(set: &YinSet, point: [f64; 2]) -> f64 {
    const PLACES: usize = 256;
    let samples = set.samples(Sampling::PerPiece(PLACES)).unwrap();
    let far = |other: [f64; 2]| (other[0] - point[0]).hypot(other[1] - point[1]);
    samples.iter().map(|sample| far(sample.point)).fold(f64::INFINITY, f64::min)
}

#[test]
fn nearest_points_are_those_of_dense_samples() {
    let mut random = Random::new(41);
    for _ in 0..case_count(20) {
        let set = smooth_set(&mut random, 1.0);
        let points: Vec<[f64; 2]> = (0..8).map(|_| [0, 1].map(|_| 4.0 * random.part() - 2.0)).collect();
        for (found, &point) in set.nearest_all(&points).unwrap().iter().zip(&points) {
            let found = found.unwrap();
            let dense = by_force(&set, point);
            assert!(
                found.distance <= dense + 1e-14 && found.distance > dense - 0.05,
                "{point:?} {found:?} {dense}"
            );
            let own = [0, 1].map(|k| found.point[k] - point[k]);
            assert!((own[0].hypot(own[1]) - found.distance).abs() < 1e-14, "{point:?} {found:?}");
            // The way to the nearest point is at right angles to the curve, but at kinks.
            let curve = set.curve(found.curve);
            let inner = found.parameter > 0.0 && found.parameter < 1.0;
            let knots = curve.knots();
            let at = knots[found.piece] + found.parameter * (knots[found.piece + 1] - knots[found.piece]);
            let tangent = curve.tangent(at).unwrap();
            let along = own[0] * tangent[0] + own[1] * tangent[1];
            assert!(!inner || along.abs() < 1e-6 * (1.0 + found.distance), "{point:?} {found:?} {along:e}");
        }
    }
}

#[test]
fn nearest_points_do_not_depend_on_the_unit() {
    let set = ellipse(24);
    let points = [[3.0, 1.0], [0.5, 0.25], [-1.0, 7.0], [2.0, 0.0]];
    let known = set.nearest_all(&points).unwrap();
    for power in [-1000, -600, -100, 100, 600, 1000] {
        let scale = 2f64.powi(power);
        let scaled = YinSet::new(&[set.curve(0).scaled(scale, [0.0, 0.0])]).unwrap();
        let found = scaled.nearest_all(&points.map(|point| point.map(|x| x * scale))).unwrap();
        for (known, found) in known.iter().zip(found) {
            let (known, found) = (known.unwrap(), found.unwrap());
            assert_eq!((known.piece, known.distance * scale), (found.piece, found.distance), "2^{power}");
        }
    }
    assert!(set.nearest_all(&[[f64::NAN, 0.0]]).is_err());
}

#[test]
fn samples_are_at_equal_lengths() {
    let set = ellipse(64);
    let whole = set.perimeter(1e-14);
    let dense = set.curve(0).length(1e-14);
    assert!((whole - dense).abs() < 1e-12);
    let found = set.samples(Sampling::PerCurve(37)).unwrap();
    assert_eq!(found.len(), 37);
    for (number, sample) in found.iter().enumerate() {
        assert!((sample.length - whole * number as f64 / 37.0).abs() < 1e-12);
        // The length of the part of the curve up to the sample, found by cutting it.
        let curve = set.curve(0);
        let knots = curve.knots();
        let at = knots[sample.piece] + sample.parameter * (knots[sample.piece + 1] - knots[sample.piece]);
        if number > 0 {
            let part = curve.part([knots[0], at]).unwrap();
            assert!((part.length(1e-14) - sample.length).abs() < 1e-11, "{number}");
        }
    }
    let spaced = set.samples(Sampling::Spacing(whole / 10.0)).unwrap();
    assert_eq!(spaced.len(), 10);
    assert_eq!(set.samples(Sampling::Spacing(100.0)).unwrap().len(), 1);
    for wrong in
        [Sampling::PerPiece(0), Sampling::PerCurve(0), Sampling::Spacing(0.0), Sampling::Spacing(f64::NAN)]
    {
        assert!(set.samples(wrong).is_err(), "{wrong:?}");
    }
    assert!(set.samples(Sampling::Spacing(1e-12)).is_err());
    assert!(YinSet::plane(Order::CUBIC).samples(Sampling::PerCurve(4)).unwrap().is_empty());
}

/// Of an ellipse with axes a and b curvatures are from b / a^2 to a / b^2.
#[test]
fn curvatures_of_ellipses() {
    for (count, error) in [(64, 3e-2), (256, 2e-3), (1024, 2e-4)] {
        let set = ellipse(count);
        let found = set.bends().unwrap()[0];
        assert!((found.least.value - 0.25).abs() < error, "{count} {found:?}");
        assert!((found.greatest.value - 2.0).abs() < error, "{count} {found:?}");
        assert!(found.sharpest.value.abs() < 1e-9 && found.roughest.unwrap().value.abs() < 1e-9);
        let hole = YinSet::new(&[set.curve(0).reversed()]).unwrap().bends().unwrap()[0];
        assert!((hole.least.value + found.greatest.value).abs() < 1e-9, "{hole:?}");
    }
    let square = Curve::polyline(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.0, 0.0]]).unwrap();
    let mut set = YinSet::new(&[square.raised(Order::CUBIC).unwrap()]).unwrap();
    assert_eq!(set.bends().unwrap()[0].roughest.unwrap().value, std::f64::consts::FRAC_PI_2);
    set.insert_kinks(&[0, 1, 2, 3].map(|knot| KnotIndex { curve: 0, knot })).unwrap();
    let found = set.bends().unwrap()[0];
    assert!(found.roughest.is_none() && (found.sharpest.value - std::f64::consts::FRAC_PI_2).abs() < 1e-12);
}

/// Chains of maps: areas follow the determinant, points stay where they are, and the way back leads back.
#[test]
fn images_of_images() {
    let mut random = Random::new(43);
    for _ in 0..case_count(10) {
        let first = smooth_set(&mut random, 1.0);
        let points: Vec<[f64; 2]> = (0..16).map(|_| [0, 1].map(|_| 4.0 * random.part() - 2.0)).collect();
        let (mut set, mut moved) = (first.clone(), points.clone());
        let mut all = AffineMap::identity(2);
        for _ in 0..4 {
            let angle = Angle::degrees(360.0 * random.part()).unwrap();
            let mirror = if random.part() < 0.5 { -1.0 } else { 1.0 };
            let map = AffineMap::rotation(2, [0, 1], angle).unwrap();
            let map = map
                .then(&AffineMap::scaling(&[mirror * (0.5 + random.part()), 0.5 + random.part()]).unwrap())
                .unwrap();
            let map = map.then(&AffineMap::translation(&[random.part(), random.part()]).unwrap()).unwrap();
            let &[a, b, c, d] = map.matrix() else { unreachable!() };
            let before = set.area().unwrap();
            set = set.transformed(&map).unwrap();
            let expected = before * (a * d - b * c).abs();
            assert!((set.area().unwrap() - expected).abs() < 1e-12 * (1.0 + expected));
            assert_eq!(set.betti_open().unwrap(), first.betti_open().unwrap());
            moved = moved.iter().map(|point| map.image(point).try_into().unwrap()).collect();
            all = all.then(&map).unwrap();
        }
        let sides = |set: &YinSet, points: &[[f64; 2]]| {
            let found = set.locate_all(points).unwrap();
            found.iter().map(|found| *found == SetLocation::Inside).collect::<Vec<_>>()
        };
        assert_eq!(sides(&first, &points), sides(&set, &moved));
        let back = set.transformed(&all.inverse().unwrap()).unwrap();
        assert!(first.comparison(&back).unwrap().area_xor() < 1e-12);
        assert_eq!(first.kinks().len(), back.kinks().len());
        let names = |set: &YinSet| {
            set.kinks().iter().map(|(_, name)| name.to_u32()).collect::<std::collections::BTreeSet<_>>()
        };
        assert_eq!(names(&first), names(&back));
    }
    let set = ellipse(16);
    for (matrix, offset) in [
        ([0.0, 0.0, 0.0, 0.0], [0.0; 2]),
        ([1.0, 2.0, 2.0, 4.0], [0.0; 2]),
        ([1e308, 0.0, 0.0, 1e308], [0.0; 2]),
    ] {
        assert!(
            set.transformed(&AffineMap::new(matrix.to_vec(), offset.to_vec()).unwrap()).is_err(),
            "{matrix:?}"
        );
    }
    assert!(set.transformed(&AffineMap::identity(3)).is_err());
}
