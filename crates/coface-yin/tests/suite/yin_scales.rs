//! Sets of all sizes, near the origin and far from it, and pairs that are nearly equal: laws hold, areas are within their bounds, nothing vanishes.
#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "a failing test shows where")]

use crate::splines::{Random, case_count, seeds};
use coface_algebra::{Error, ErrorKind};
use coface_arrange::boolean::BooleanFormula;
use coface_yin::{Combination, Curve, EndCondition, KnotIndex, Order, YinSet};
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// Points of a closed curve around the origin, of size one, and its kinks.
struct Shape {
    points: Vec<[f64; 2]>,
    kinks: Vec<u32>,
    order: Order,
    /// By which parts of a full turn it is like itself.
    symmetry: u32,
}

fn shape(random: &mut Random) -> Shape {
    let count = 4 + random.below(8) as u32;
    let turn = if random.below(2) == 0 { 0.0 } else { TAU * random.part() };
    let on_circle = |at: u32, radius: f64| {
        let (sine, cosine) = (turn + TAU * f64::from(at) / f64::from(count)).sin_cos();
        [radius * cosine, radius * sine]
    };
    let order = Order::new(if count < 8 { 4 } else { random.one_of(&[4, 4, 6, 8]) }).unwrap();
    let regular = |at| on_circle(at, 1.0);
    match random.below(5) {
        0 => Shape {
            points: (0..count).map(regular).collect(),
            kinks: (0..count).collect(),
            order,
            symmetry: count,
        },
        1 => Shape { points: (0..count).map(regular).collect(), kinks: Vec::new(), order, symmetry: count },
        2 => {
            let star = |at: u32| on_circle(at, if at.is_multiple_of(2) { 1.0 } else { 0.6 });
            let symmetry = if count.is_multiple_of(2) { count / 2 } else { 1 };
            Shape { points: (0..count).map(star).collect(), kinks: (0..count).collect(), order, symmetry }
        }
        3 => {
            let points = [
                [0., 0.],
                [1., 0.],
                [2., 0.],
                [3., 0.],
                [3.5, 0.5],
                [3., 1.],
                [2., 1.],
                [1., 1.],
                [0., 1.],
                [-0.5, 0.5],
            ];
            Shape { points: points.to_vec(), kinks: vec![0, 3, 5, 8], order: Order::CUBIC, symmetry: 1 }
        }
        _ => {
            let points = (0..count).map(|at| on_circle(at, 0.7 + 0.3 * random.part())).collect();
            let kinks = (0..count).filter(|_| random.below(3) == 0).collect();
            Shape { points, kinks, order: Order::CUBIC, symmetry: 1 }
        }
    }
}

/// The set through images of the points of a shape; nothing where few kinks make its boundary cross itself.
fn set(shape: &Shape, map: impl Fn([f64; 2]) -> [f64; 2]) -> Option<YinSet> {
    let points: Vec<[f64; 2]> = shape.points.iter().map(|&point| map(point)).collect();
    let curve = Curve::fit_closed(&points, &shape.kinks, shape.order, &EndCondition::NotAKnot).ok()?;
    let kinks: Vec<_> = shape.kinks.iter().map(|&knot| KnotIndex { curve: 0, knot }).collect();
    YinSet::new(&[curve]).ok()?.with_declared_kinks(&kinks, None, None).ok()
}

/// Two sets, how they are related, and their size and place.
struct Pair {
    sets: [YinSet; 2],
    kind: &'static str,
    about: String,
}

fn pair(seed: u64) -> Option<Pair> {
    let random = &mut Random::new(seed + (23 << 32));
    let own = shape(random);
    let size = random.one_of(&[1.0, 1.0, 1e-6, 1e6]);
    let far = random.one_of(&[0.0, 0.0, 1e3, 1e6, 3e10]);
    let center = [far * size, -0.7 * far * size];
    let place = |[x, y]: [f64; 2]| [center[0] + size * x, center[1] + size * y];
    let little = 10f64.powf(-3.0 - 13.0 * random.part());
    let turned = |[x, y]: [f64; 2], angle: f64| {
        let (sine, cosine) = angle.sin_cos();
        [cosine * x - sine * y, sine * x + cosine * y]
    };
    let (kind, other) = match random.below(7) {
        0 => ("itself", set(&own, place)),
        1 => ("moved", set(&own, |[x, y]| place([x + little, y - 0.3 * little]))),
        2 => ("scaled", set(&own, |[x, y]| place([x * (1.0 - little), y * (1.0 - little)]))),
        3 => ("turned", set(&own, |point| place(turned(point, little)))),
        4 => {
            let angle =
                TAU * f64::from(1 + random.below(u64::from(own.symmetry)) as u32) / f64::from(own.symmetry);
            ("turned by a symmetry", set(&own, |point| place(turned(point, angle))))
        }
        5 => ("beside it", set(&own, |[x, y]| place([x + 2.0, y]))),
        _ => {
            let other = shape(random);
            let order = other.order.max(own.order);
            let other = Shape { order, ..other };
            ("another", set(&other, |[x, y]| place([x + 0.3, y + 0.2])))
        }
    };
    let about =
        format!("case {seed}: {kind} by {little:e}, size {size:e}, center {center:?}, order {}", own.order);
    Some(Pair { sets: [set(&own, place)?, other?], kind, about })
}

/// What was refused, by how sets are related and the decision that was not made.
#[derive(Default)]
struct Refused {
    classes: BTreeMap<String, Vec<String>>,
    asked: usize,
}

impl Refused {
    fn of<T>(&mut self, found: Result<T, Error>, what: &str, pair: &Pair) -> Option<T> {
        self.asked += 1;
        let error = match found {
            Ok(found) => return Some(found),
            Err(error) => error,
        };
        assert_eq!(error.kind(), ErrorKind::InvalidInput, "{}: {error}", pair.about);
        assert!(error.cure().is_some(), "{}: {error}", pair.about);
        let text = error.to_string();
        let class: String = text.split(" near (").next().unwrap().chars().take(60).collect();
        self.classes
            .entry(format!("{}: {class}", pair.kind))
            .or_default()
            .push(format!("{} {what}", pair.about));
        None
    }
}

/// What rounding of coordinates does to the area of a set.
fn rounding(set: &YinSet) -> f64 {
    let Some([low, high]) = set.bounding_box() else { return 0.0 };
    let largest = [low, high].as_flattened().iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
    let extent = (high[0] - low[0]).max(high[1] - low[1]);
    64.0 * f64::EPSILON * extent * (extent + largest)
}

/// The same points but for rounding, by the area between both.
fn check_equal(a: &YinSet, b: &YinSet, known: f64, what: &str, pair: &Pair) {
    let found = a.comparison(b).unwrap();
    let most = known + found.area_xor_error() + 4.0 * (rounding(a) + rounding(b));
    assert!(found.area_xor() <= most, "{}: not {what}: {:e} {most:e}", pair.about, found.area_xor());
}

#[test]
fn sets_of_all_sizes_keep_the_laws() {
    let mut refused = Refused::default();
    for seed in seeds(60) {
        let Some(pair) = pair(seed) else { continue };
        let [a, b] = &pair.sets;
        let combine = |text: &str| -> Result<Combination, Error> {
            YinSet::combine(&[a, b], &BooleanFormula::parse(text, &[]).unwrap())
        };
        let [meet, join, rest, apart] =
            ["a & b", "a | b", "a - b", "a ^ b"].map(|text| refused.of(combine(text), text, &pair));
        let area = |found: &Combination| (found.set().area().unwrap(), found.area_error());
        let [first, second] = [a, b].map(|set| set.area().unwrap());
        let slack = rounding(a) + rounding(b);
        if let (Some(meet), Some(join)) = (&meet, &join) {
            let ((meet, e), (join, f)) = (area(meet), area(join));
            let miss = (meet + join - first - second).abs();
            assert!(miss <= e + f + slack, "{}: {meet:e} {join:e} {first:e} {second:e} {miss:e}", pair.about);
        }
        if let (Some(meet), Some(rest)) = (&meet, &rest) {
            let ((meet, e), (rest, f)) = (area(meet), area(rest));
            assert!(
                (meet + rest - first).abs() <= e + f + slack,
                "{}: {meet:e} {rest:e} {first:e}",
                pair.about
            );
        }
        if let Some(apart) = &apart {
            let (apart, e) = area(apart);
            let truth = a.comparison(b).unwrap();
            let miss = (apart - truth.area_xor()).abs();
            let known = e + truth.area_xor_error() + slack;
            assert!(miss <= known, "{}: {apart:e} {:e} {known:e}", pair.about, truth.area_xor());
        }
        if pair.kind == "itself" {
            let [Some(meet), Some(join), Some(apart)] = [&meet, &join, &apart] else {
                panic!("{}", pair.about)
            };
            assert_eq!([meet.set().curve_count(), join.set().curve_count()], [1; 2], "{}", pair.about);
            assert!(apart.set().is_empty() && meet.report().is_empty(), "{}", pair.about);
        }
        let (Some(meet), Some(rest), Some(apart)) = (meet, rest, apart) else { continue };
        let known = meet.area_error() + rest.area_error() + apart.area_error();
        let (meet, rest, apart) = (meet.set(), rest.set(), apart.set());
        let laws = [
            ("a & (a & b) = a & b", [a, meet], "a & b", meet),
            ("a | (a & b) = a", [a, meet], "a | b", a),
            ("(a & b) | (a - b) = a", [meet, rest], "a | b", a),
            ("a - (a & b) = a - b", [a, meet], "a - b", rest),
            ("(a ^ b) ^ b = a", [apart, b], "a ^ b", a),
        ];
        for (what, sets, text, expected) in laws {
            let found = YinSet::combine(&sets, &BooleanFormula::parse(text, &[]).unwrap());
            if let Some(found) = refused.of(found, what, &pair) {
                check_equal(found.set(), expected, known + found.area_error(), what, &pair);
            }
        }
    }
    for (class, own) in &refused.classes {
        println!("{} x {class}", own.len());
        own.iter().take(3).for_each(|one| println!("    {one}"));
    }
    let count: usize = refused.classes.values().map(Vec::len).sum();
    println!("{count} of {} are refused", refused.asked);
    assert!(40 * count <= refused.asked, "{count} of {} are refused", refused.asked);
}

/// A small component beside a large one is no bigon that may be contracted, however often the set is laid over itself.
#[test]
fn small_components_stay() {
    for (offset, small) in [(0.0, 1e-8), (1e3, 1e-9), (1e6, 1e-5), (1e6, 1e-6)] {
        let square = |x: f64, side: f64| {
            let corners = [[x, offset], [x + side, offset], [x + side, offset + side], [x, offset + side]];
            Curve::fit_closed(&corners, &[0, 1, 2, 3], Order::CUBIC, &EndCondition::NotAKnot).unwrap()
        };
        let both = YinSet::new(&[square(offset, 10.0), square(offset + 20.0, small)]).unwrap();
        for found in [both.meet(&both).unwrap(), both.join(&both).unwrap()] {
            assert_eq!(found.betti_open().unwrap(), [2, 0], "{offset} {small}");
        }
    }
}

/// Sides that are parallel, and nearer to each other than bounds on heights tell.
#[test]
fn diamonds_that_are_scaled_by_little() {
    let diamond = |scale: f64| {
        let corners = [[scale, 0.0], [0.0, scale], [-scale, 0.0], [0.0, -scale]];
        let curve =
            Curve::fit_closed(&corners, &[0, 1, 2, 3], Order::CUBIC, &EndCondition::NotAKnot).unwrap();
        YinSet::new(&[curve]).unwrap()
    };
    for little in [1e-12, 1e-13, 3e-14] {
        let (a, b) = (diamond(1.0), diamond(1.0 - little));
        assert_eq!(a.meet(&b).unwrap().area(), b.area(), "{little}");
        assert_eq!(a.join(&b).unwrap().area(), a.area(), "{little}");
        let ring = a.difference(&b).unwrap();
        assert!((ring.area().unwrap() - 4.0 * little).abs() < 1e-15, "{little}");
        assert_eq!(b.difference(&a).unwrap().curve_count(), 0, "{little}");
    }
}

/// Sets that are the same but for the last digits of their coordinates.
#[test]
fn turned_by_a_symmetry_far_from_the_origin() {
    let count = case_count(8) as u32;
    for corners in 8..8 + count.min(8) {
        let polygon = |first: u32| {
            let point = |at: u32| {
                let (sine, cosine) = (TAU * f64::from(first + at) / f64::from(corners)).sin_cos();
                [1e6 + cosine, 1e6 + sine]
            };
            let points: Vec<[f64; 2]> = (0..corners).map(point).collect();
            let curve =
                Curve::fit_closed(&points, &[], Order::new(6).unwrap(), &EndCondition::NotAKnot).unwrap();
            YinSet::new(&[curve]).unwrap()
        };
        let (a, b) = (polygon(0), polygon(1));
        for text in ["a & b", "a | b"] {
            let found = YinSet::combine(&[&a, &b], &BooleanFormula::parse(text, &[]).unwrap()).unwrap();
            let miss = (found.set().area().unwrap() - a.area().unwrap()).abs();
            assert!(
                miss <= found.area_error() + rounding(&a) && found.area_error() < 1e-6,
                "{corners} {miss:e}"
            );
        }
    }
}

/// Ends of sides that become one take what is between the sides: that is no curve that comes back along itself.
#[test]
fn sides_with_ends_that_became_one() {
    let set = |little: f64| {
        let controls = [
            [[0.0, little], [3.0, 4.0], [4.0, 1.0], [4.0, -little]],
            [[4.0, -little], [10.0 / 3.0, -1.0], [8.0 / 3.0, -2.0], [2.0, -3.0]],
            [[2.0, -3.0], [4.0 / 3.0, -2.0], [2.0 / 3.0, -1.0], [0.0, little]],
        ];
        let straight =
            |[a, b]: [[f64; 2]; 2]| Curve::polyline(&[a, b]).unwrap().raised(Order::CUBIC).unwrap();
        let mut all = controls[0].to_vec();
        for piece in [[controls[1][0], controls[1][3]], [controls[2][0], controls[2][3]]] {
            all.extend_from_slice(&straight(piece).controls()[1..]);
        }
        // The set is on the right of the curve.
        YinSet::new(&[Curve::from_controls(Order::CUBIC, all, vec![0.0, 1.0, 2.0, 3.0]).unwrap().reversed()])
            .unwrap()
    };
    let (a, b) = (set(0.0), set(1e-13));
    match YinSet::combine(&[&a, &b], &BooleanFormula::parse("a ^ b", &[]).unwrap()) {
        Ok(found) => {
            for curve in 0..found.set().curve_count() {
                assert!(found.set().curve(curve).signed_area() != 0.0, "{:?}", found.set().curve(curve));
            }
        }
        Err(error) => assert!(error.cure().is_some(), "{error}"),
    }
}
