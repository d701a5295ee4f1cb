//! Random curves: self-crossing ones by fill rules, and sets that share arcs, nearly touch, and differ in size by many powers of ten.
//!
//! Every case gives a right result or an error that names the place; the number of errors is bounded too.
#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "a failing test shows where")]

use crate::splines::{Random, blob, case_count, mapped, smooth_set};
use coface_algebra::Error;
use coface_arrange::boolean::{BooleanFormula, InsideRule};
use coface_geometry::Angle;
use coface_yin::{Combination, Curve, Order, SetLocation, YinSet};

const RULES: [InsideRule; 3] = [InsideRule::Nonzero, InsideRule::Odd, InsideRule::Positive];

/// A closed curve whose control points are anywhere, or on a lattice.
fn wild(random: &mut Random, order: Order, lattice: Option<f64>) -> Curve<'static> {
    let count = 2 + random.below(4) as usize;
    let mut controls: Vec<[f64; 2]> = (0..count * order.degree())
        .map(|_| {
            [0, 1].map(|_| {
                let x = random.coordinate();
                lattice.map_or(x, |step| (x / step).round() * step)
            })
        })
        .collect();
    // Some knots are smooth.
    let degree = order.degree();
    for knot in 1..count {
        if degree > 2 && random.below(3) == 0 {
            let [a, b] = [controls[knot * degree - 1], controls[knot * degree]];
            controls[knot * degree + 1] = [0, 1].map(|k| 2.0 * b[k] - a[k]);
        }
    }
    controls.push(controls[0]);
    let knots = (0..=count).map(|i| i as f64).collect();
    Curve::from_controls(order, controls, knots).unwrap()
}

/// The points of a curve at many parameters.
fn flattened(curve: &Curve<'_>, parts: usize) -> Vec<[f64; 2]> {
    (0..curve.piece_count() * parts)
        .map(|i| {
            let (piece, t) = (i / parts, (i % parts) as f64 / parts as f64);
            let mut points = curve.piece(piece).to_vec();
            while points.len() > 1 {
                points = points
                    .windows(2)
                    .map(|pair| [0, 1].map(|k| (1.0 - t) * pair[0][k] + t * pair[1][k]))
                    .collect();
            }
            points[0]
        })
        .collect()
}

/// How often a polygon winds around a point, and how near it comes.
fn winding(polygon: &[[f64; 2]], at: [f64; 2]) -> (i32, f64) {
    let (mut winding, mut nearest) = (0, f64::INFINITY);
    for (i, &p) in polygon.iter().enumerate() {
        let q = polygon[(i + 1) % polygon.len()];
        let (d, e) = ([q[0] - p[0], q[1] - p[1]], [at[0] - p[0], at[1] - p[1]]);
        let length = d[0] * d[0] + d[1] * d[1];
        let part = if length > 0.0 { ((d[0] * e[0] + d[1] * e[1]) / length).clamp(0.0, 1.0) } else { 0.0 };
        nearest = nearest.min((e[0] - part * d[0]).hypot(e[1] - part * d[1]));
        let side = d[0] * e[1] - d[1] * e[0];
        if p[1] <= at[1] && at[1] < q[1] && side > 0.0 {
            winding += 1;
        } else if q[1] <= at[1] && at[1] < p[1] && side < 0.0 {
            winding -= 1;
        }
    }
    (winding, nearest)
}

fn is_undecided(error: &Error) -> bool {
    error.to_string().contains("cannot be decided at resolution")
}

/// What fill rules make of curves, checked against winding numbers of fine polygons.
fn check_rules(curves: &[Curve<'_>], about: &str, random: &mut Random) -> Result<(), Error> {
    const PARTS: usize = 48;
    let polygons: Vec<_> = curves.iter().map(|curve| flattened(curve, PARTS)).collect();
    // The distance of polygons from curves: an eighth of the second derivative, which is 24 at most on control points in [-3, 3].
    let bend = curves
        .iter()
        .map(|curve| curve.controls().as_flattened().iter().fold(0.0, |most: f64, x| most.max(x.abs())))
        .fold(0.0, f64::max);
    let degree = curves[0].order().degree() as f64;
    let margin = degree * (degree - 1.0) * 4.0 * 1.5 * bend / (8.0 * (PARTS * PARTS) as f64);
    let points: Vec<([f64; 2], i32)> = (0..60)
        .filter_map(|_| {
            let at = [random.coordinate(), random.coordinate()];
            let all: Vec<_> = polygons.iter().map(|polygon| winding(polygon, at)).collect();
            all.iter()
                .all(|&(_, distance)| distance > margin)
                .then(|| (at, all.iter().map(|&(winding, _)| winding).sum()))
        })
        .collect();
    let mut areas = Vec::new();
    for rule in RULES {
        let found = YinSet::combine_curves(curves, rule)?;
        let set = found.set();
        assert_eq!(set.validate()?, None, "{about} {rule:?} {curves:?}");
        assert!(set.is_bounded());
        for &(at, winding) in &points {
            let is_inside = set.locate(at).unwrap() == SetLocation::Inside;
            assert_eq!(is_inside, rule.is_inside(winding), "{about} {rule:?} {at:?} {winding} {curves:?}");
        }
        areas.push(set.area().unwrap());
        // Once more it is the same.
        let own: Vec<Curve<'_>> = (0..set.curve_count()).map(|curve| set.curve(curve)).collect();
        let again = YinSet::combine_curves(&own, rule)?;
        assert!((again.set().signed_area() - set.signed_area()).abs() <= 1e-9, "{about} {rule:?}");
    }
    let backward: Vec<_> = curves.iter().map(Curve::reversed).collect();
    let negative = YinSet::combine_curves(&backward, InsideRule::Positive)?.set().area().unwrap();
    let [nonzero, odd, positive] = areas[..] else { panic!("three rules") };
    assert!(
        (positive + negative - nonzero).abs() <= 1e-9,
        "{about} {positive} {negative} {nonzero} {curves:?}"
    );
    assert!(odd <= nonzero + 1e-9, "{about}");
    Ok(())
}

/// Checks the rules on random curves; at most one case in `most` may be undecided.
fn check_rules_on(first_seed: u64, most: u64, curves: impl Fn(&mut Random) -> Vec<Curve<'static>>) {
    let (case_number, mut undecided) = (case_count(60), Vec::new());
    for seed in 0..case_number {
        let mut random = Random::new(seed + first_seed);
        let curves = curves(&mut random);
        if let Err(error) = check_rules(&curves, &format!("seed {seed}"), &mut random) {
            assert!(is_undecided(&error), "{seed}: {error}");
            println!("{seed}: {error}");
            undecided.push(seed);
        }
    }
    println!("{} of {case_number} undecided: {undecided:?}", undecided.len());
    assert!(undecided.len() as u64 * most <= case_number);
}

#[test]
fn fill_rules_count_how_often_curves_wind() {
    check_rules_on(0, 100, |random| {
        let order = Order::new(random.one_of(&[4, 4, 4, 6, 8])).unwrap();
        (0..1 + random.below(3)).map(|_| wild(random, order, None)).collect()
    });
}

#[test]
fn fill_rules_of_curves_on_a_lattice() {
    check_rules_on(1 << 32, 10, |random| {
        let step = random.one_of(&[0.5, 0.25, 0.125]);
        (0..1 + random.below(2)).map(|_| wild(random, Order::CUBIC, Some(step))).collect()
    });
}

/// Two pieces leave their common knot in one direction with one curvature: next to it they are nearer than the resolution.
#[test]
fn a_cusp_of_equal_curvatures_is_one_point() {
    let controls =
        vec![[0.5, -1.0], [-0.5, 0.0], [0.5, -0.5], [0.0, -0.5], [0.5, -0.5], [1.0, 0.0], [0.5, -1.0]];
    let curve = Curve::from_controls(Order::CUBIC, controls, vec![0.0, 1.0, 2.0]).unwrap();
    for curve in [curve.reversed(), curve] {
        check_rules(&[curve], "cusp", &mut Random::new(1)).unwrap();
    }
}

/// A set that is hard to tell from another: near it, or with common arcs, or tiny and at its boundary.
fn relative(of: &YinSet, random: &mut Random) -> Result<(&'static str, YinSet), Error> {
    let other = smooth_set(random, 1.0);
    let small = random.one_of(&[1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-11, 1e-12, 1e-13, 1e-15]);
    Ok(match random.below(10) {
        0 => ("independent", other),
        1 => ("meet", of.meet(&other)?),
        2 => ("difference", of.difference(&other)?),
        3 => ("other without it", other.difference(of)?),
        4 => ("join", of.join(&other)?),
        5 => {
            let shift = [0, 1].map(|_| small * random.coordinate());
            ("shifted", mapped(of, |curve| curve.translated(shift))?)
        }
        6 => ("scaled", mapped(of, |curve| curve.scaled(1.0 + small, [0.0; 2]))?),
        7 if of.curve_count() > 0 => {
            let curve = of.curve(0);
            let knot = random.below(curve.piece_count() as u64) as usize;
            let parameter = curve.knots()[knot] + random.one_of(&[0.0, 0.0, 1e-9, 0.3]);
            let size = random.one_of(&[1e-2, 1e-4, 1e-6, 1e-8]);
            let center = curve.point(parameter);
            ("tiny", YinSet::new(&[blob(random, center, size)])?)
        }
        8 if of.curve_count() > 0 => {
            // One piece of it, and a way back.
            let curve = of.curve(0);
            let number = random.below(curve.piece_count() as u64) as usize;
            let mut piece = curve.piece(number).to_vec();
            if random.below(2) == 0 {
                piece.reverse();
            }
            let [a, b] = [piece[0], piece[3]];
            let side = random.one_of(&[1.0, -1.0, 0.3]);
            let corner = [a[0] + side * (b[1] - a[1]), a[1] - side * (b[0] - a[0])];
            let toward = |t: f64| [0, 1].map(|k| (1.0 - t) * b[k] + t * corner[k]);
            let back = |t: f64| [0, 1].map(|k| (1.0 - t) * corner[k] + t * a[k]);
            piece.extend([toward(0.3), toward(0.7), corner, back(0.3), back(0.7), a]);
            let own = Curve::from_controls(Order::CUBIC, piece, vec![0.0, 1.0, 2.0, 3.0])?;
            let rule = if own.signed_area() > 0.0 { own } else { own.reversed() };
            ("piece", YinSet::combine_curves(&[rule], InsideRule::Nonzero)?.into_set())
        }
        9 => ("turned", {
            let angle = Angle::turns(1, random.one_of(&[4, 1 << 20, 1 << 31]));
            mapped(of, |curve| curve.rotated(angle, [0.0; 2]))?
        }),
        _ => ("itself", of.clone()),
    })
}

/// All that must hold for two sets.
fn check_pair(a: &YinSet, b: &YinSet, about: &str, random: &mut Random) -> Result<(), Error> {
    let sets = [a, b];
    let combine = |formula: &str| -> Result<Combination, Error> {
        YinSet::combine(&sets, &BooleanFormula::parse(formula, &["a", "b"]).unwrap())
    };
    let formulas = ["a & b", "a | b", "a - b", "b - a", "a ^ b", "!a & !b"];
    let (mut areas, mut resolution) = (Vec::new(), 0.0f64);
    let mut points: Vec<[f64; 2]> =
        (0..40).map(|_| [2.0 * random.coordinate(), 2.0 * random.coordinate()]).collect();
    for set in sets {
        // Points of tiny sets are near their boundaries.
        if let Some([low, high]) = set.bounding_box().filter(|[low, high]| high[0] - low[0] > 1e-3) {
            points.extend((0..20).map(|_| [0, 1].map(|k| low[k] + (high[k] - low[k]) * random.part())));
        }
    }
    let inside = |set: &YinSet| set.locate_all(&points).unwrap();
    let (in_a, in_b) = (inside(a), inside(b));
    for formula in formulas {
        let found = combine(formula)?;
        let set = found.set();
        assert_eq!(set.validate()?, None, "{about} {formula}");
        assert_eq!(set, &set.canonical(), "{about} {formula}");
        assert_eq!(
            found.sources().len(),
            (0..set.curve_count()).map(|i| set.curve(i).piece_count()).sum::<usize>()
        );
        for (i, at) in inside(set).into_iter().enumerate() {
            let [p, q] = [in_a[i], in_b[i]].map(|at| at == SetLocation::Inside);
            let expected = match formula {
                "a & b" => p && q,
                "a | b" => p || q,
                "a - b" => p && !q,
                "b - a" => q && !p,
                "a ^ b" => p != q,
                _ => !p && !q,
            };
            assert_eq!(at == SetLocation::Inside, expected, "{about} {formula} {:?}", points[i]);
        }
        areas.push(set.signed_area());
        resolution = resolution.max(found.resolution());
    }
    let &[both, either, first, second, one, none] = &areas[..] else { panic!("six areas") };
    let (whole_a, whole_b) = (a.signed_area(), b.signed_area());
    // What is taken for one has no more between it than this times the length of the boundary.
    let tolerance = 50.0 * resolution;
    let misses = [
        whole_a + whole_b - both - either,
        whole_a - both - first,
        whole_b - both - second,
        first + second - one,
        either + none,
    ];
    assert!(misses.iter().all(|miss| miss.abs() <= tolerance), "{about}: {misses:?} {resolution:e}");
    Ok(())
}

#[test]
fn sets_that_are_hard_to_tell_apart() {
    let (mut all, mut undecided) = (0, Vec::new());
    let mut by_kind = std::collections::BTreeMap::<&str, [usize; 2]>::new();
    for seed in 0..case_count(60) {
        let mut random = Random::new(seed + (2 << 32));
        let a = smooth_set(&mut random, 1.0);
        let (kind, b) = match relative(&a, &mut random) {
            Ok(found) => found,
            Err(error) => {
                println!("{seed}: making: {error}");
                by_kind.entry("making").or_default()[1] += 1;
                continue;
            }
        };
        all += 1;
        by_kind.entry(kind).or_default()[0] += 1;
        if let Err(error) = check_pair(&a, &b, &format!("seed {seed} {kind}"), &mut random) {
            assert!(is_undecided(&error), "{seed}: {error}");
            println!("{seed} {kind}: {error}");
            by_kind.entry(kind).or_default()[1] += 1;
            undecided.push(seed);
        }
    }
    println!("{} of {all} undecided: {by_kind:?}", undecided.len());
    assert!(undecided.len() as u64 * 20 <= all);
}
