//! Sets that are nearly the same: moved by little, turned by little, fitted again with other knots, cut into more pieces.
#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "a failing test shows where")]

use crate::splines::{Random, blob, case_count, smooth_set};
use coface_arrange::boolean::BooleanFormula;
use coface_yin::{Curve, EndCondition, KnotIndex, Order, YinSet};
use std::collections::BTreeMap;

/// A set whose boundary has kinks at some of its knots.
fn kinked(random: &mut Random) -> Option<YinSet> {
    let curve = blob(random, [0.0, 0.0], 1.0);
    let count = curve.piece_count();
    let points: Vec<[f64; 2]> = (0..count).map(|knot| curve.knot_point(knot)).collect();
    let kinks: Vec<u32> = (0..count as u32).filter(|_| random.below(3) == 0).collect();
    let curve = Curve::fit_closed(&points, &kinks, Order::CUBIC, &EndCondition::NotAKnot).unwrap();
    let knots: Vec<_> = kinks.iter().map(|&knot| KnotIndex { curve: 0, knot }).collect();
    // Where few kinks make it overshoot it may cross itself.
    YinSet::new(&[curve]).ok()?.with_declared_kinks(&knots, None, None).ok()
}

/// The same set with every point elsewhere.
fn mapped(set: &YinSet, map: impl Fn([f64; 2]) -> [f64; 2]) -> Option<YinSet> {
    let curves: Vec<Curve<'static>> = (0..set.curve_count())
        .map(|number| {
            let curve = set.curve(number);
            let controls = curve.controls().iter().map(|&point| map(point)).collect();
            Curve::from_controls(curve.order(), controls, curve.knots().to_vec()).unwrap()
        })
        .collect();
    YinSet::new(&curves).ok()
}

/// The same set fitted to other points of its boundary, so many on each piece.
fn refitted(set: &YinSet, places: u32, first: f64) -> Option<YinSet> {
    let kinks: Vec<Vec<u32>> =
        (0..set.curve_count() as u32).map(|curve| set.kinks().on_curve(curve).collect()).collect();
    let curves: Option<Vec<Curve<'static>>> = (0..set.curve_count())
        .map(|number| {
            let curve = set.curve(number);
            let knots = curve.knots();
            let has_kinks = !kinks[number].is_empty();
            let mut points = Vec::new();
            for piece in 0..curve.piece_count() {
                for place in 0..places {
                    let part = (f64::from(place) + if has_kinks { 0.0 } else { first }) / f64::from(places);
                    points.push(curve.point(knots[piece] + part * (knots[piece + 1] - knots[piece])));
                }
            }
            let own: Vec<u32> = kinks[number].iter().map(|knot| knot * places).collect();
            Curve::fit_closed(&points, &own, Order::CUBIC, &EndCondition::NotAKnot).ok()
        })
        .collect();
    YinSet::new(&curves?).ok()
}

/// A pair of nearly equal sets, and what it is.
fn pair(random: &mut Random, case: u64) -> Option<(YinSet, YinSet, String)> {
    let set = match random.below(3) {
        0 => YinSet::new(&[blob(random, [0.0, 0.0], 1.0)]).unwrap(),
        1 => kinked(random)?,
        _ => smooth_set(random, 1.0),
    };
    if set.curve_count() == 0 {
        return None;
    }
    let size = 10f64.powf(-9.0 - 4.0 * random.part());
    let angle = std::f64::consts::TAU * random.part();
    let center = [0, 1].map(|_| 0.5 * random.coordinate());
    let places = 2 + random.below(4) as u32;
    let kind = case % 5;
    let (other, name) = match kind {
        0 => (mapped(&set, |[x, y]| [x + size * angle.cos(), y + size * angle.sin()]), "moved"),
        1 => {
            let turned = |[x, y]: [f64; 2]| {
                let [u, v] = [x - center[0], y - center[1]];
                [x - size * v, y + size * u]
            };
            (mapped(&set, turned), "turned")
        }
        2 => (mapped(&set, |[x, y]| [x + size * (x - center[0]), y + size * (y - center[1])]), "scaled"),
        3 => (refitted(&set, places, 0.0), "refitted at knots"),
        _ => (refitted(&set, places, 0.5), "refitted between knots"),
    };
    Some((set, other?, format!("case {case}: {name} {size:e} {places}")))
}

/// Few are refused, areas add up, and the symmetric difference has the area that the comparison of the boundaries finds.
#[test]
fn nearly_equal_sets_are_combined() {
    let mut random = Random::new(2026);
    let mut refused: BTreeMap<String, Vec<String>> = BTreeMap::new();
    let mut asked = 0;
    for case in 0..case_count(20) {
        let Some((a, b, about)) = pair(&mut random, case) else { continue };
        let sets = [&a, &b];
        let combine = |text: &str| YinSet::combine(&sets, &BooleanFormula::parse(text, &[]).unwrap());
        let found = ["a & b", "a | b", "a ^ b", "a - b"].map(combine);
        asked += 4;
        for (found, name) in found.iter().zip(["meet", "join", "xor", "difference"]) {
            if let Err(error) = found {
                let text = error.to_string();
                let class: String = text.split(" near (").next().unwrap().chars().take(90).collect();
                refused.entry(class).or_default().push(format!("{about} {name}: {text}"));
            }
        }
        let area =
            |at: usize| found[at].as_ref().ok().map(|own| (own.set().area().unwrap(), own.area_error()));
        let [first, second] = sets.map(|set| set.area().unwrap());
        if let (Some((meet, e)), Some((join, f))) = (area(0), area(1)) {
            let miss = (meet + join - first - second).abs();
            assert!(miss <= e + f + 1e-13, "{about}: {miss:e} {e:e} {f:e}");
        }
        let truth = a.comparison(&b).unwrap();
        if let Some((xor, e)) = area(2) {
            let miss = (xor - truth.area_xor()).abs();
            let known = e + truth.area_xor_error();
            assert!(miss <= known + 1e-14, "{about}: {xor:e} {:e} {miss:e} {known:e}", truth.area_xor());
        }
        if let (Some((rest, e)), Some((meet, f))) = (area(3), area(0)) {
            assert!((rest + meet - first).abs() <= e + f + 1e-13, "{about}");
        }
    }
    for (class, own) in &refused {
        println!("{} x {class}", own.len());
        own.iter().take(3).for_each(|one| println!("    {one}"));
    }
    let count: usize = refused.values().map(Vec::len).sum();
    println!("{count} of {asked} are refused");
    assert!(40 * count <= asked, "{count} of {asked} are refused");
}
