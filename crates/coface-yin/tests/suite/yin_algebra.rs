//! The laws of the Boolean algebra over chains of operations, for sets with kinks and without: results meet their own operands.
#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "a failing test shows where")]

use crate::splines::{Random, blob, case_count, seeds, smooth_set};
use coface_algebra::Error;
use coface_arrange::boolean::{BooleanFormula, InsideRule};
use coface_geometry::Angle;
use coface_yin::{Curve, EndCondition, KnotIndex, Order, YinSet};

/// The set around which a spline with kinks at some of its points runs.
fn kinked(points: &[[f64; 2]], kinks: &[u32], order: Order) -> YinSet {
    let curve = Curve::fit_closed(points, kinks, order, &EndCondition::NotAKnot).unwrap();
    let knots: Vec<_> = kinks.iter().map(|&knot| KnotIndex { curve: 0, knot }).collect();
    YinSet::new(&[curve]).unwrap().with_declared_kinks(&knots, None, None).unwrap()
}

fn polygon(corners: &[[f64; 2]], order: Order) -> YinSet {
    kinked(corners, &(0..corners.len() as u32).collect::<Vec<_>>(), order)
}

fn is_equal(a: &YinSet, b: &YinSet) -> Result<bool, Error> {
    a.has_points_of(b)
}

/// An error that says what does not hold.
fn holds(is_held: bool, what: impl FnOnce() -> String) -> Result<(), Error> {
    if is_held { Ok(()) } else { Err(Error::invalid(what())) }
}

/// The laws for two sets and what is made of them.
///
/// # Errors
/// If an operation is refused or a law does not hold.
fn check_laws(a: &YinSet, b: &YinSet, about: &str) -> Result<(), Error> {
    let meet = a.meet(b)?;
    let join = a.join(b)?;
    let rest = a.difference(b)?;
    let law = |name: &str, x: &YinSet, y: &YinSet| -> Result<(), Error> {
        holds(is_equal(x, y)?, || format!("{about}: not {name}"))
    };
    law("a & (a & b) = a & b", &a.meet(&meet)?, &meet)?;
    law("b & (a & b) = a & b", &meet.meet(b)?, &meet)?;
    law("(a & b) | (a - b) = a", &meet.join(&rest)?, a)?;
    law("a - (a & b) = a - b", &a.difference(&meet)?, &rest)?;
    law("a ^ (a & b) = a - b", &a.symmetric_difference(&meet)?, &rest)?;
    law("a ^ (a - b) = a & b", &a.symmetric_difference(&rest)?, &meet)?;
    law("a & (a | b) = a", &a.meet(&join)?, a)?;
    law("a | (a & b) = a", &a.join(&meet)?, a)?;
    law("!(a & b) = !a | !b", &meet.complement()?, &a.complement()?.join(&b.complement()?)?)?;
    law("!(a | b) = !a & !b", &join.complement()?, &a.complement()?.meet(&b.complement()?)?)?;
    law("a & a = a", &meet.meet(&meet)?, &meet)?;
    law("(a - b) & b = 0", &rest.meet(b)?, &YinSet::empty(a.order()))?;
    Ok(())
}

#[test]
fn a_kinked_triangle_and_what_a_blob_cuts_out_of_it() {
    let triangle = polygon(&[[0., 0.], [3., 1.], [1., 2.]], Order::CUBIC);
    let points = [[2., 1.], [1., 1.5], [0.5, 0.5], [1.5, -0.2]];
    let blob = kinked(&points, &[], Order::CUBIC);
    check_laws(&triangle, &blob, "triangle and blob").unwrap();
    check_laws(&blob, &triangle, "blob and triangle").unwrap();
    // Dissolved cuts leave the curve that was there, bit for bit.
    let [both, rest] = [triangle.meet(&blob).unwrap(), triangle.difference(&blob).unwrap()];
    assert!(!both.curve(0).carriers().is_empty());
    let whole = both.join(&rest).unwrap();
    assert_eq!(whole.curve(0).controls(), triangle.canonical().curve(0).controls());
    assert!(whole.curve(0).carriers().is_empty());
}

#[test]
fn a_turned_square_of_any_order_and_its_parts() {
    for order in [4, 6, 8] {
        let order = Order::new(order).unwrap();
        let square = polygon(&[[0., 0.], [1., 0.], [1., 1.], [0., 1.]], order);
        let (sine, cosine) = 0.5f64.sin_cos();
        let turned: Vec<[f64; 2]> = [[0., 0.], [1., 0.], [1., 1.], [0., 1.]]
            .iter()
            .map(|[x, y]| [cosine * x - sine * y, sine * x + cosine * y])
            .collect();
        let turned = polygon(&turned, order);
        check_laws(&square, &turned, "squares").unwrap();
        let points = [[1., 0.5], [0.5, 0.9], [0.2, 0.4], [0.6, -0.2]];
        check_laws(&turned, &kinked(&points, &[1], order), "turned square and kinked blob").unwrap();
    }
}

#[test]
fn parts_keep_their_carriers_when_both_are_moved() {
    let triangle = polygon(&[[0., 0.], [3., 1.], [1., 2.]], Order::CUBIC);
    let blob = kinked(&[[2., 1.], [1., 1.5], [0.5, 0.5], [1.5, -0.2]], &[], Order::CUBIC);
    let turn = |set: &YinSet| {
        let curves: Vec<_> = (0..set.curve_count())
            .map(|curve| set.curve(curve).rotated(Angle::turns(1, 7), [0.3, 0.1]).translated([0.7, 1e3]))
            .collect();
        YinSet::new(&curves).unwrap()
    };
    let [part, whole] = [triangle.meet(&blob).unwrap(), triangle].map(|set| turn(&set));
    assert!(is_equal(&whole.meet(&part).unwrap(), &part).unwrap());
    assert!(is_equal(&whole.difference(&part).unwrap().join(&part).unwrap(), &whole).unwrap());
}

/// The same set as a file without carriers would have it.
fn stripped(set: &YinSet) -> YinSet {
    let curve = |curve: usize| {
        let own = set.curve(curve);
        Curve::from_controls(own.order(), own.controls().to_vec(), own.knots().to_vec()).unwrap()
    };
    let curves: Vec<_> = (0..set.curve_count()).map(curve).collect();
    if curves.is_empty() { set.clone() } else { YinSet::new(&curves).unwrap() }
}

/// Parts of a straight side are one line within rounding.
#[test]
fn laws_hold_for_results_that_lost_their_carriers() {
    let mut refused = Vec::new();
    for case in seeds(60) {
        let mut random = Random::new(case + (11 << 32));
        let [first, second] = [0, 1].map(|_| {
            let center = [0, 1].map(|_| 0.5 * random.coordinate());
            blob(&mut random, center, 1.0)
        });
        let points = |curve: &Curve<'_>| -> Vec<[f64; 2]> {
            (0..curve.piece_count()).map(|knot| curve.knot_point(knot)).collect()
        };
        let a = match case % 4 {
            // Sides along the axes, and along lines through the origin.
            0 => polygon(&[[-0.5, 0.], [0.75, 0.], [0.75, 0.625], [0., 0.5], [-0.5, 0.5]], Order::CUBIC),
            _ => polygon(&points(&first), Order::CUBIC),
        };
        let b = kinked(&points(&second), &[], Order::CUBIC);
        let run = || -> Result<(), Error> {
            let (both, rest) = (stripped(&a.meet(&b)?), stripped(&a.difference(&b)?));
            holds(is_equal(&a.meet(&both)?, &both)?, || "not a & (a & b) = a & b".into())?;
            holds(is_equal(&a.difference(&both)?, &rest)?, || "not a - (a & b) = a - b".into())?;
            holds(is_equal(&both.join(&rest)?, &a)?, || "not (a & b) | (a - b) = a".into())?;
            holds(is_equal(&a.symmetric_difference(&rest)?, &both)?, || "not a ^ (a - b) = a & b".into())
        };
        if let Err(error) = run() {
            println!("case {case}: {error}");
            refused.push(case);
        }
    }
    assert!(refused.is_empty(), "{refused:?}");
}

/// A polygon with kinks at all or some of its points, or a smooth set.
fn operand(random: &mut Random, order: Order) -> YinSet {
    if order == Order::CUBIC && random.below(4) == 0 {
        return smooth_set(random, 1.0);
    }
    let center = [0, 1].map(|_| 0.5 * random.coordinate());
    let curve = blob(random, center, 1.0);
    let points = &curve.knots()[..curve.piece_count()];
    let points: Vec<[f64; 2]> = (0..points.len()).map(|knot| curve.knot_point(knot)).collect();
    let are_all = random.below(2) == 0;
    let kinks: Vec<u32> = (0..points.len() as u32).filter(|_| are_all || random.below(3) == 0).collect();
    // Few points between kinks make curves that cross themselves, which are no sets.
    match Curve::fit_closed(&points, &kinks, order, &EndCondition::NotAKnot) {
        Ok(curve) if YinSet::new(std::slice::from_ref(&curve)).is_ok() => kinked(&points, &kinks, order),
        _ => polygon(&points, order),
    }
}

/// Chains of ten operations, at each step of which all laws are checked against operands of before.
#[test]
fn chains_of_operations_keep_the_laws() {
    let (mut refused, cases) = (Vec::new(), seeds(40));
    for seed in cases.clone() {
        let mut random = Random::new(seed + (7 << 32));
        let order = Order::new(random.one_of(&[4, 4, 4, 6, 8])).unwrap();
        let mut sets: Vec<YinSet> = (0..3).map(|_| operand(&mut random, order)).collect();
        let run = |random: &mut Random, sets: &mut Vec<YinSet>| -> Result<(), Error> {
            for step in 0..10 {
                let [i, j] = [0, 1].map(|_| random.below(sets.len() as u64) as usize);
                let (a, b) = (&sets[i], &sets[j]);
                let about = format!("seed {seed} step {step}: {i} and {j}");
                let (next, area) = match random.below(4) {
                    0 => (a.meet(b)?, None),
                    1 => (a.join(b)?, None),
                    2 => (a.difference(b)?, None),
                    _ => (a.symmetric_difference(b)?, Some(a.meet(b)?.signed_area())),
                };
                let fault = next.validate()?;
                holds(fault.is_none(), || format!("{about}: {fault:?}"))?;
                if let Some(meet) = area {
                    let miss = a.signed_area() + b.signed_area() - 2.0 * meet - next.signed_area();
                    holds(miss.abs() <= 1e-9, || format!("{about}: the area is off by {miss:e}"))?;
                }
                if step % 3 == 0 {
                    check_laws(a, b, &about)?;
                }
                if step % 3 == 1 {
                    check_laws(a, &next, &about)?;
                }
                sets.push(next);
            }
            Ok(())
        };
        if let Err(error) = run(&mut random, &mut sets) {
            println!("seed {seed}: {error}");
            refused.push(seed);
        }
    }
    println!("{} of {cases:?} refused: {refused:?}", refused.len());
    assert!(refused.is_empty(), "{refused:?}");
}

/// Results of order 2 are rounded so that they are valid: slivers whose corners come together are repaired.
#[test]
fn rounded_results_are_sets() {
    let mut random = Random::new(5);
    let mut repaired = 0;
    for case in 0..case_count(600) {
        let mut rings = || -> Vec<Vec<[f64; 2]>> {
            let ring = |random: &mut Random| {
                (0..3 + random.below(6)).map(|_| [0, 1].map(|_| random.below(17) as f64)).collect()
            };
            (0..1 + random.below(4)).map(|_| ring(&mut random)).collect()
        };
        let (first, second) = (rings(), rings());
        let rule = [InsideRule::Nonzero, InsideRule::Positive, InsideRule::Odd][case as usize % 3];
        let [a, b] = [&first, &second].map(|rings| YinSet::from_rings(rings, rule).unwrap());
        assert_eq!([a.validate().unwrap(), b.validate().unwrap()], [None, None], "case {case}");
        for formula in ["a & b", "a | b", "a - b", "a ^ b"] {
            let found =
                YinSet::combine(&[&a, &b], &BooleanFormula::parse(formula, &["a", "b"]).unwrap()).unwrap();
            assert_eq!(found.set().validate().unwrap(), None, "case {case} {formula}");
            let pieces: usize =
                (0..found.set().curve_count()).map(|i| found.set().curve(i).piece_count()).sum();
            assert_eq!(found.sources().len(), pieces);
            // Each piece lies along its source.
            let curves = (0..found.set().curve_count()).map(|curve| found.set().curve(curve).into_owned());
            let knots = curves.flat_map(|curve| {
                (0..curve.piece_count())
                    .map(move |piece| [0, 1].map(|end| curve.piece(piece)[end]))
                    .collect::<Vec<_>>()
            });
            for (ends, source) in knots.zip(found.sources()) {
                let curve = [&a, &b][source.operand as usize].curve(source.curve as usize).into_owned();
                let line = curve.piece(source.piece as usize);
                let way = [0, 1].map(|k| line[1][k] - line[0][k]);
                for end in ends {
                    let offset = [0, 1].map(|k| end[k] - line[0][k]);
                    let miss = (way[0] * offset[1] - way[1] * offset[0]).abs() / way[0].hypot(way[1]);
                    assert!(miss <= 1e-12, "case {case} {formula} {miss:e}");
                }
            }
            repaired += usize::from(found.repair_count() > 0);
        }
    }
    println!("{repaired} repaired");
    assert!(repaired > 0);
}
