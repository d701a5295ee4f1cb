//! Small differences of sets against closed forms and against Booleans.
#![allow(clippy::unwrap_used, reason = "a failing test shows where")]

use crate::splines::{Random, case_count, smooth_set};
use coface_yin::{Curve, EndCondition, Order, YinSet};

fn circle(count: usize) -> Curve<'static> {
    Curve::circle([0.0, 0.0], 1.0, count, Order::CUBIC).unwrap()
}

/// A unit circle against itself moved by a little: twice its width times the way.
#[test]
fn a_circle_and_itself_moved_by_next_to_nothing() {
    let set = YinSet::new(&[circle(32)]).unwrap();
    let [low, high] = set.bounding_box().unwrap();
    for shift in [1e-3, 1e-6, 1e-9, 1e-10, 1e-11, 1e-13] {
        let moved = YinSet::new(&[set.curve(0).translated([shift, 0.0])]).unwrap();
        let found = set.comparison(&moved).unwrap();
        // Of strips of height dy the part that changes is twice as long as the way; the third power is what their ends add.
        let expected = 2.0 * shift * (high[1] - low[1]);
        let miss = (found.area_xor() - expected).abs();
        assert!(miss <= 1e-15 + found.area_xor_error() + shift * shift * shift, "{shift:e}: {miss:e}");
        assert!(found.area_xor_error() < 2e-13, "{shift:e}: {:e}", found.area_xor_error());
        assert!(found.area_signed().abs() <= found.area_signed_error(), "{shift:e}");
        assert!(
            (found.hausdorff() - shift).abs() <= 1e-15 + 1e-2 * shift * shift,
            "{shift:e} {}",
            found.hausdorff()
        );
    }
}

/// Squares of order 4 at 1e12, where a resolution of the largest coordinate swallows them.
#[test]
fn squares_far_from_the_origin() {
    let square = |at: f64| {
        let corners = [[at, at], [at + 4.0, at], [at + 4.0, at + 4.0], [at, at + 4.0], [at, at]];
        YinSet::new(&[Curve::polyline(&corners).unwrap().raised(Order::CUBIC).unwrap()]).unwrap()
    };
    let found = square(1e12).comparison(&square(1e12 + 2.0)).unwrap();
    assert!((found.area_xor() - 24.0).abs() <= found.area_xor_error() && found.area_xor_error() < 1e-12);
    assert_eq!(found.area_signed(), 0.0);
}

/// Fits of one circle with n and n + 1 knots: their areas differ by less than each is off, and lie to both sides of each other.
#[test]
fn fits_of_one_circle() {
    for count in [32, 64, 128, 256, 512] {
        let [a, b] = [count, count + 1].map(|count| YinSet::new(&[circle(count)]).unwrap());
        let found = a.comparison(&b).unwrap();
        let bound = 2.0 * 13.7 / (count as f64).powi(4);
        assert!(found.area_xor() > found.area_xor_error() && found.area_xor() < bound, "{count} {found:?}");
        assert!(
            found.area_signed().abs() <= found.area_xor() + found.area_signed_error(),
            "{count} {found:?}"
        );
    }
}

/// Two arcs that cross twice next to each other, far narrower than the pieces they are on.
#[test]
fn a_lens_between_two_arcs_is_seen() {
    for power in 6..24 {
        let depth = 2f64.powi(-power);
        // The parabolas y = x^2 - depth and y = 0 over [-1, 1], closed above and below.
        let bowl = vec![
            [-1.0, 1.0 - depth],
            [-1.0 / 3.0, -1.0 / 3.0 - depth],
            [1.0 / 3.0, -1.0 / 3.0 - depth],
            [1.0, 1.0 - depth],
            [1.0, 2.0],
            [-1.0, 2.0],
            [-1.0, 1.0 - depth],
        ];
        let bowl = Curve::from_controls(Order::CUBIC, bowl, vec![0.0, 1.0, 2.0]).unwrap();
        let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 0.0], [-1.0, 0.0], [-1.0, -1.0]];
        let flat = Curve::polyline(&corners).unwrap();
        let [bowl, flat] = [bowl, flat].map(|curve| YinSet::new(&[curve]).unwrap());
        let found = bowl.comparison(&flat).unwrap();
        let lens = 4.0 / 3.0 * depth * depth.sqrt();
        let expected = bowl.area().unwrap() + flat.area().unwrap() - 2.0 * lens;
        assert!(
            (found.area_xor() - expected).abs() <= found.area_xor_error(),
            "{power} {found:?} {expected}"
        );
        assert!(found.area_xor_error() < 1e-12);
    }
}

/// Where sets are far apart, Booleans say the same.
#[test]
fn comparisons_agree_with_booleans() {
    for seed in 0..case_count(15) {
        let mut random = Random::new(seed + (9 << 32));
        let [a, b] = [0, 1].map(|_| smooth_set(&mut random, 1.0));
        let found = a.comparison(&b).unwrap();
        let xor = a.symmetric_difference(&b).unwrap().area().unwrap();
        assert!(
            (found.area_xor() - xor).abs() <= 1e-10 && found.area_xor_error() < 1e-12,
            "{seed}: {found:?} {xor}"
        );
        assert!((found.area_signed() - a.area().unwrap() + b.area().unwrap()).abs() < 1e-12);
        let turned = b.complement().unwrap().comparison(&a.complement().unwrap()).unwrap();
        assert!(
            (turned.area_xor() - found.area_xor()).abs() <= 1e-13
                && (turned.hausdorff() - found.hausdorff()).abs() <= 1e-9
        );
        assert!(a.comparison(&b.complement().unwrap()).unwrap().area_xor().is_infinite());
        // No point of one boundary is farther from the other.
        let curve = a.curve(0);
        let nearest = |p: [f64; 2]| {
            let curves = (0..b.curve_count()).map(|curve| b.curve(curve).into_owned());
            curves
                .flat_map(|curve| {
                    let [from, to] = [curve.knots()[0], *curve.knots().last().unwrap()];
                    (0..400)
                        .map(|i| curve.point(from + (to - from) * f64::from(i) / 400.0))
                        .collect::<Vec<_>>()
                })
                .fold(f64::INFINITY, |best: f64, q| best.min((p[0] - q[0]).hypot(p[1] - q[1])))
        };
        assert!(nearest(curve.point(0.123)) <= found.hausdorff() + 1e-2, "{seed}");
    }
}

/// A circle and one around it, an ellipse and a circle: distances along normals and curvatures in closed form.
#[test]
fn normals_and_curvatures_are_those_of_closed_forms() {
    let disk = |radius: f64, count: usize| {
        YinSet::new(&[Curve::circle([0.5, -2.0], radius, count, Order::new(8).unwrap()).unwrap()]).unwrap()
    };
    for by in [0.5, 1e-2, 1e-5, 1e-8] {
        let found = disk(1.0, 64).comparison(&disk(1.0 + by, 64)).unwrap();
        let (far, apart) = (found.along_normals().unwrap(), found.curvature().unwrap());
        assert!((far - by).abs() <= found.along_normals_error() + 1e-11, "{by:e} {far:e}");
        assert!(
            (found.hausdorff() - by).abs() <= found.hausdorff_error() + 1e-11,
            "{by:e} {:e}",
            found.hausdorff()
        );
        assert!((apart - by / (1.0 + by)).abs() <= found.curvature_error() + 1e-7, "{by:e} {apart:e}");
        assert!(found.normals_left_out() < 0.02, "{by:e}");
    }
    let order = Order::new(8).unwrap();
    let ellipse = YinSet::new(&[Curve::ellipse([0.0, 0.0], [1.1, 1.0], 256, order).unwrap()]).unwrap();
    let circle = YinSet::new(&[Curve::circle([0.0, 0.0], 1.0, 256, order).unwrap()]).unwrap();
    let found = circle.comparison(&ellipse).unwrap();
    assert!((found.along_normals().unwrap() - 0.1).abs() <= found.along_normals_error() + 1e-9);
    // The curvature of the ellipse at the end of its shorter axis.
    let apart = 1.0 - 1.0 / 1.21;
    assert!((found.curvature().unwrap() - apart).abs() <= found.curvature_error() + 1e-6);
    let nothing = circle.comparison(&YinSet::empty(order)).unwrap();
    assert_eq!((nothing.along_normals(), nothing.curvature(), nothing.normals_left_out()), (None, None, 1.0));
    // A circle far away: most normals do not come to it.
    let moved = YinSet::new(&[circle.curve(0).translated([9.0, 0.0])]).unwrap();
    let far = circle.comparison(&moved).unwrap();
    assert!(far.normals_left_out() > 0.5 && far.normals_left_out() < 1.0, "{}", far.normals_left_out());
}

/// At a kink each side has a curvature of its own: a set has no other curvature than itself, moved by a little nearly the same, and one that is
/// scaled another.
#[test]
fn curvatures_are_those_of_the_same_side_of_kinks() {
    let mut random = Random::new(31);
    let mut compared = 0;
    for case in 0..case_count(60) {
        let count = 4 + random.below(8) as u32;
        let points: Vec<[f64; 2]> = (0..count)
            .map(|at| {
                let radius = 0.6 + 0.8 * random.part();
                let (sine, cosine) = (std::f64::consts::TAU * f64::from(at) / f64::from(count)).sin_cos();
                [radius * cosine, radius * sine]
            })
            .collect();
        let mut kinks: Vec<u32> = (0..3).map(|_| random.below(u64::from(count)) as u32).collect();
        kinks.sort_unstable();
        kinks.dedup();
        let curve = Curve::fit_closed(&points, &kinks, Order::CUBIC, &EndCondition::NotAKnot).unwrap();
        let Ok(set) = YinSet::new(std::slice::from_ref(&curve)) else { continue };
        compared += 1;
        let found = set.comparison(&set).unwrap();
        let apart = found.curvature().unwrap();
        assert!(
            apart <= found.curvature_error() + 1e-9 && found.normals_left_out() == 0.0,
            "case {case}: {apart:e}"
        );
        let moved = YinSet::new(&[curve.translated([1e-9, 0.0])]).unwrap();
        let found = set.comparison(&moved).unwrap();
        let apart = found.curvature().unwrap();
        assert!(apart < 1e-4, "case {case}: {apart:e}");
        assert!(found.normals_left_out() < 0.1, "case {case}: {}", found.normals_left_out());
    }
    assert!(compared > 30, "{compared}");
}
