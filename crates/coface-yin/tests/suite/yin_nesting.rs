//! How splines lie in each other, against where a point of each lies as to each other one alone.
#![allow(clippy::unwrap_used, reason = "a failing test shows where")]

use crate::splines::{Random, blob, seeds};
use coface_yin::{Curve, EndCondition, Order, SetLocation, YinSet};

/// A curve and smaller ones in it like it, some with others inside of them.
fn nest(random: &mut Random, center: [f64; 2], size: f64, depth: u32, curves: &mut Vec<Curve<'static>>) {
    let outer = blob(random, center, size);
    let count = 1 + random.below(if depth == 0 { 24 } else { 6 });
    let points: Vec<[f64; 2]> = (0..outer.piece_count()).map(|knot| outer.knot_point(knot)).collect();
    for ring in 0..count {
        let factor = 1.0 - 0.7 * ring as f64 / count as f64;
        let place = |point: &[f64; 2]| [0, 1].map(|k| center[k] + factor * (point[k] - center[k]));
        let mut points: Vec<[f64; 2]> = points.iter().map(place).collect();
        let start = random.below(points.len() as u64) as usize;
        points.rotate_left(start);
        if random.below(2) == 0 {
            points.reverse();
        }
        curves.push(Curve::fit_closed(&points, &[], Order::CUBIC, &EndCondition::NotAKnot).unwrap());
    }
    if depth < 2 {
        for side in [-1.0, 1.0].into_iter().take(random.below(3) as usize) {
            nest(random, [center[0] + 0.09 * side * size, center[1]], 0.08 * size, depth + 1, curves);
        }
    }
}

#[test]
fn rings_lie_in_each_other_as_each_alone_tells() {
    for seed in seeds(40) {
        let mut random = Random::new(seed + (13 << 32));
        let mut curves = Vec::new();
        for x in 0..1 + random.below(3) {
            nest(&mut random, [3.0 * x as f64, 0.1 * x as f64], 1.0, 0, &mut curves);
        }
        for at in (1..curves.len()).rev() {
            curves.swap(at, random.below(at as u64 + 1) as usize);
        }
        let set = YinSet::oriented(&curves).unwrap_or_else(|error| panic!("seed {seed}: {error}"));
        let alone: Vec<YinSet> =
            curves.iter().map(|curve| YinSet::oriented(std::slice::from_ref(curve)).unwrap()).collect();
        for (number, own) in curves.iter().enumerate() {
            let around = (0..curves.len()).filter(|&other| {
                other != number && alone[other].locate(own.knot_point(0)).unwrap() == SetLocation::Inside
            });
            let around: Vec<usize> = around.collect();
            let area = |&other: &usize| alone[other].signed_area();
            let parent = around.iter().copied().min_by(|a, b| area(a).total_cmp(&area(b)));
            assert_eq!(set.forest().parent(number), parent, "seed {seed}: curve {number}");
            assert_eq!(set.forest().depth(number), around.len(), "seed {seed}: curve {number}");
        }
        assert_eq!(set.validate().unwrap(), None, "seed {seed}");
    }
}

/// Cubic rings, each in the next, at two scales of the distance between them.
#[test]
fn many_rings_are_a_path_in_the_forest() {
    for (count, corner_count) in [(600usize, 4usize), (500, 11)] {
        let ring = |number: usize| {
            let radius = 1.0 + number as f64;
            let corner = |corner: usize| {
                let turn = std::f64::consts::TAU * corner as f64 / corner_count as f64 + 0.3;
                [1e3 + radius * turn.cos(), radius * turn.sin()]
            };
            let points: Vec<[f64; 2]> = (0..corner_count).map(corner).collect();
            Curve::fit_closed(&points, &[], Order::CUBIC, &EndCondition::NotAKnot).unwrap()
        };
        let set = YinSet::oriented(&(0..count).map(ring).collect::<Vec<_>>()).unwrap();
        for curve in 0..count {
            assert_eq!(set.forest().parent(curve), Some(curve + 1).filter(|&parent| parent < count));
        }
    }
}
