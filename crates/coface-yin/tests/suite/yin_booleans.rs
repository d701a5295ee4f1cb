//! The Boolean algebra of Yin sets: laws bit for bit, oracles, invariance, grids, sets with known answers.

#![allow(clippy::print_stdout, reason = "a test says what it skips")]
#![allow(clippy::unwrap_used)]

use coface_algebra::Rational;
use coface_arrange::boolean::{BooleanFormula, InsideRule};
use coface_yin::{Curve, KnotIndex, Order, YinSet};

/// A generator of numbers that is the same everywhere (splitmix64).
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn below(&mut self, bound: u64) -> f64 {
        (self.next() % bound) as f64
    }

    fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1u64 << 53) as f64
    }
}

fn soup_count(usual: usize) -> usize {
    std::env::var("COFACE_SOUPS").ok().and_then(|text| text.parse().ok()).unwrap_or(usual)
}

/// Rectangles and right triangles with slopes 0, 1, -1 and infinity: they cross in halves of integers, so nothing is rounded. The set
/// may be unbounded, touch itself, and overlap others.
fn random_set(random: &mut Random) -> YinSet {
    let mut rings = Vec::new();
    for _ in 0..1 + random.next() % 4 {
        let [x, y] = [random.below(10), random.below(10)];
        let [w, h] = [1.0 + random.below(6), 1.0 + random.below(6)];
        rings.push(match random.next() % 3 {
            0 => vec![[x, y], [x + w, y], [x + w, y + h], [x, y + h]],
            1 => vec![[x, y], [x + w, y], [x, y + w]],
            _ => vec![[x, y - w], [x + w, y], [x, y + w], [x - w, y]],
        });
    }
    let rule = if random.next().is_multiple_of(2) { InsideRule::Odd } else { InsideRule::Nonzero };
    let set = YinSet::from_rings(&rings, rule).unwrap();
    let set = if random.next().is_multiple_of(4) { set.complement().unwrap() } else { set };
    set.straightened()
}

/// The unique form.
#[allow(clippy::needless_pass_by_value, reason = "sets that nothing else needs")]
fn form(set: YinSet) -> YinSet {
    set.straightened().canonical()
}

#[test]
fn laws_of_boolean_algebras_hold_bit_for_bit() {
    let [empty, plane] = [YinSet::empty(Order::LINEAR), YinSet::plane(Order::LINEAR)];
    for case in 0..soup_count(150) {
        let mut random = Random(case as u64);
        let [a, b, c] = std::array::from_fn(|_| random_set(&mut random));
        let not = |a: &YinSet| form(a.complement().unwrap());
        let and = |a: &YinSet, b: &YinSet| form(a.meet(b).unwrap());
        let or = |a: &YinSet, b: &YinSet| form(a.join(b).unwrap());
        assert_eq!(and(&a, &not(&a)), empty, "{case}");
        assert_eq!(or(&a, &not(&a)), plane, "{case}");
        assert_eq!(not(&not(&a)), a.canonical(), "{case}");
        assert_eq!(not(&and(&a, &b)), or(&not(&a), &not(&b)), "{case}");
        assert_eq!(not(&or(&a, &b)), and(&not(&a), &not(&b)), "{case}");
        assert_eq!(and(&a, &or(&a, &b)), a.canonical(), "{case}");
        assert_eq!(or(&a, &and(&a, &b)), a.canonical(), "{case}");
        assert_eq!(and(&a, &or(&b, &c)), or(&and(&a, &b), &and(&a, &c)), "{case}");
        assert_eq!(or(&a, &and(&b, &c)), and(&or(&a, &b), &or(&a, &c)), "{case}");
        assert_eq!(and(&a, &and(&b, &c)), and(&and(&a, &b), &c), "{case}");
        assert_eq!(or(&a, &or(&b, &c)), or(&or(&a, &b), &c), "{case}");
        assert_eq!((and(&a, &b), or(&a, &b)), (and(&b, &a), or(&b, &a)), "{case}");
        assert_eq!((and(&a, &a), or(&a, &a)), (a.canonical(), a.canonical()), "{case}");
        assert_eq!((and(&a, &plane), or(&a, &empty)), (a.canonical(), a.canonical()), "{case}");
        assert_eq!((and(&a, &empty), or(&a, &plane)), (empty.clone(), plane.clone()), "{case}");
        let difference = form(a.difference(&b).unwrap());
        assert_eq!(difference, and(&a, &not(&b)), "{case}");
        let either = form(a.symmetric_difference(&b).unwrap());
        assert_eq!(either, or(&difference, &form(b.difference(&a).unwrap())), "{case}");
        // Many at once, and by a formula.
        let all = YinSet::join_all(&[&a, &b, &c]).unwrap();
        assert_eq!(form(all), or(&a, &or(&b, &c)), "{case}");
        assert_eq!(form(YinSet::meet_all(&[&a, &b, &c]).unwrap()), and(&a, &and(&b, &c)), "{case}");
        let formula = BooleanFormula::parse("a & !(b | c)", &[]).unwrap();
        let found = YinSet::combine(&[&a, &b, &c], &formula).unwrap();
        assert_eq!(form(found.into_set()), and(&a, &not(&or(&b, &c))), "{case}");
        // The order.
        assert!(and(&a, &b).is_subset_of(&a).unwrap() && a.is_subset_of(&or(&a, &b)).unwrap(), "{case}");
        assert_eq!(a.is_subset_of(&b).unwrap(), and(&a, &b) == a.canonical(), "{case}");
        assert_eq!(a.has_points_of(&b).unwrap(), a.canonical() == b.canonical(), "{case}");
        assert!([&either, &difference].iter().all(|set| set.validate().unwrap().is_none()), "{case}");
        // Areas as fractions.
        let area = |set: &YinSet| set.exact_area().unwrap();
        assert_eq!(&area(&a) + &area(&b), &area(&and(&a, &b)) + &area(&or(&a, &b)), "{case}");
    }
}

/// Where boundaries only cross, the join is the union of open sets.
#[test]
fn euler_characteristics_add_up_where_boundaries_cross() {
    for case in 0..soup_count(100) {
        let mut random = Random(1_000_000 + case as u64);
        let mut rectangles = |shift: f64| {
            let rings: Vec<_> = (0..1 + random.next() % 8)
                .map(|_| {
                    let [x, y] = [random.below(10) + shift, random.below(10) + shift];
                    let [w, h] = [1.0 + random.below(5), 1.0 + random.below(5)];
                    [[x, y], [x + w, y], [x + w, y + h], [x, y + h]]
                })
                .collect();
            YinSet::from_rings(&rings, InsideRule::Odd).unwrap()
        };
        let (a, b) = (rectangles(0.0), rectangles(0.5));
        let chi = |set: &YinSet| {
            let [components, cycles] = set.betti_open().unwrap();
            components as i64 - cycles as i64
        };
        let (both, either) = (a.meet(&b).unwrap(), a.join(&b).unwrap());
        assert_eq!(chi(&a) + chi(&b), chi(&both) + chi(&either), "{case}");
    }
}

fn mapped(set: &YinSet, map: impl Fn([f64; 2]) -> [f64; 2]) -> YinSet {
    if set.curve_count() == 0 {
        return set.clone();
    }
    let curves: Vec<Curve<'_>> = (0..set.curve_count())
        .map(|curve| {
            let points: Vec<[f64; 2]> = set.curve(curve).controls().iter().map(|&point| map(point)).collect();
            Curve::polyline(&points).unwrap()
        })
        .collect();
    YinSet::new(&curves).unwrap()
}

#[test]
fn booleans_move_with_their_operands() {
    for case in 0..soup_count(40) {
        let mut random = Random(2_000_000 + case as u64);
        let [a, b] = std::array::from_fn(|_| random_set(&mut random));
        let maps: [fn([f64; 2]) -> [f64; 2]; 4] = [
            |[x, y]| [x + 1024.0, y - 77.0],
            |[x, y]| [x * 0.125, y * 0.125],
            |[x, y]| [-y, x],
            |[x, y]| [-x * 1024.0, -y * 1024.0],
        ];
        for map in maps {
            let (c, d) = (mapped(&a, map), mapped(&b, map));
            for [(p, q), (r, s)] in [[(&a, &b), (&c, &d)], [(&b, &a), (&d, &c)]] {
                let expected = form(mapped(&form(p.meet(q).unwrap()), map));
                assert_eq!(form(r.meet(s).unwrap()), expected, "{case}");
                let expected = form(mapped(&form(p.symmetric_difference(q).unwrap()), map));
                assert_eq!(form(r.symmetric_difference(s).unwrap()), expected, "{case}");
            }
        }
    }
}

/// Squares in rows and columns, and the same shifted: all counts and areas in closed form. Lengths are integers, a hundred a step.
#[test]
fn grids_of_squares_have_their_counts_and_areas() {
    for m in [5usize, 15, 50] {
        let squares = |shift: [f64; 2]| {
            let curves: Vec<Curve<'_>> = (0..m * m)
                .map(|at| {
                    let [x, y] = [(at % m) as f64 * 100.0 + shift[0], (at / m) as f64 * 100.0 + shift[1]];
                    let corners = [[x, y], [x + 70.0, y], [x + 70.0, y + 70.0], [x, y + 70.0], [x, y]];
                    Curve::polyline(&corners).unwrap()
                })
                .collect();
            YinSet::new(&curves).unwrap()
        };
        let (a, b) = (squares([0.0, 0.0]), squares([30.0, 37.0]));
        let (both, either) = (a.meet(&b).unwrap(), a.join(&b).unwrap());
        let area = (m * m * 1320 + m * (m - 1) * 280) as f64;
        assert_eq!(both.area(), Some(area));
        assert_eq!(either.area(), Some((m * m) as f64 * 9800.0 - area));
        assert_eq!(both.curve_counts(), [m * m + m * (m - 1), 0]);
        assert_eq!(either.curve_counts(), [1, 2 * (m - 1) * (m - 1)]);
        assert_eq!(either.betti_open().unwrap(), [1, 2 * (m - 1) * (m - 1)]);
        assert_eq!(either.betti_closed().unwrap(), either.betti_open().unwrap());
    }
}

#[test]
fn sources_and_kinks_of_results() {
    let square = |x: f64, y: f64| {
        let corners = [[x, y], [x + 2., y], [x + 2., y + 2.], [x, y + 2.], [x, y]];
        YinSet::new(&[Curve::polyline(&corners).unwrap()]).unwrap()
    };
    let (a, b) = (square(0., 0.), square(1., 1.));
    let formula = BooleanFormula::union(2);
    let both = YinSet::combine(&[&a, &b], &formula).unwrap();
    let points: Vec<_> = (0..8).map(|knot| both.set().curve(0).knot_point(knot)).collect();
    assert_eq!(points[..4], [[0., 0.], [2., 0.], [2., 1.], [3., 1.]]);
    let sources: Vec<_> = both.sources().iter().map(|s| (s.operand, s.curve, s.piece, s.range)).collect();
    assert_eq!(sources[..3], [(0, 0, 0, [0., 1.]), (0, 0, 1, [0., 0.5]), (1, 0, 0, [0.5, 1.])]);
    // Corners where one set passes into the other are kinks; the others were none.
    let kinks: Vec<_> = both.set().kinks().iter().map(|(knot, _)| (knot.curve, knot.knot)).collect();
    assert_eq!(kinks, [(0, 2), (0, 6)]);
    // Kinks of operands stay: those of the join in a join with itself.
    let again = both.set().join(both.set()).unwrap();
    assert_eq!(&again, both.set());
    assert!(again.kinks().vertex(KnotIndex { curve: 0, knot: 2 }).is_some());
    // In a complement pieces run against their sources.
    let outside = YinSet::combine(&[&a], &BooleanFormula::parse("!a", &[]).unwrap()).unwrap();
    assert!(outside.sources().iter().all(|source| source.range == [1., 0.]));
    assert_eq!(outside.sources()[0].piece, 3);
    // Sides that both operands share have two sources.
    let twice = YinSet::combine(&[&a, &square(0., 0.)], &formula).unwrap();
    let operands: Vec<u32> = twice.sources_of(1).map(|source| source.operand).collect();
    assert_eq!(operands, [0, 1]);
    assert_eq!((twice.collapsed_curve_count(), twice.report().len()), (0, 0));
}

/// The same by the exact area of what is not rounded: coordinates that only exact predicates keep apart.
#[test]
fn gaps_and_slivers_below_any_tolerance() {
    let rectangle = |x0: f64, y0: f64, x1: f64, y1: f64| {
        YinSet::from_rings(&[[[x0, y0], [x1, y0], [x1, y1], [x0, y1]]], InsideRule::Nonzero).unwrap()
    };
    // A gap of one unit in the last place.
    let next = 1f64.next_up();
    let (a, b) = (rectangle(0., 0., 1., 1.), rectangle(next, 0., 2., 1.));
    assert_eq!(a.join(&b).unwrap().curve_counts(), [2, 0]);
    assert!(a.meet(&b).unwrap().is_empty());
    assert_eq!(a.join(&rectangle(1., 0., 2., 1.)).unwrap().curve_counts(), [1, 0]);
    // An overlap of one unit in the last place has an area.
    let both = rectangle(0., 0., next, 1.).meet(&rectangle(1., 0., 2., 1.)).unwrap();
    assert_eq!(both.area(), Some(f64::EPSILON));
    assert_eq!(both.validate().unwrap(), None);
    // Far from the origin.
    let far = |shift: f64| rectangle(1e6 + shift, 1e6, 1e6 + 1.0, 1e6 + 1.0);
    let ring = far(0.0).difference(&far(1e-9)).unwrap();
    assert_eq!(ring.curve_counts(), [1, 0]);
    assert_eq!(ring.area(), Some((1e6 + 1e-9) - 1e6));
    // 1e-16 next to the origin is much.
    let thin = rectangle(0., 0., 1e-16, 1.).join(&rectangle(2e-16, 0., 3e-16, 1.)).unwrap();
    assert_eq!((thin.curve_counts(), thin.area()), ([2, 0], Some(1e-16 + (3e-16 - 2e-16))));
    // Slivers: triangles whose long sides cross at a tiny angle.
    let triangle = |points: [[f64; 2]; 3]| YinSet::from_rings(&[points], InsideRule::Nonzero).unwrap();
    let a = triangle([[0., 0.], [1e8, 1.], [1e8, 1. + 1e-8]]);
    let b = triangle([[0., 1e-9], [1e8, 1. + 5e-9], [1e8, 1. - 1e-8]]);
    let (both, either) = (a.meet(&b).unwrap(), a.join(&b).unwrap());
    for set in [&both, &either] {
        let normal = set.normalized().unwrap();
        assert_eq!(normal.set().validate().unwrap(), None);
    }
    let residue = [&a, &b].map(|set| set.area().unwrap()).iter().sum::<f64>()
        - both.area().unwrap()
        - either.area().unwrap();
    assert!(residue.abs() <= 1e-9, "{residue}");
}

/// Results of random polygons, rounded, are combined again and again: nothing fails, areas add up.
#[test]
fn rounded_results_are_operands_again() {
    for case in 0..soup_count(20) {
        let mut random = Random(3_000_000 + case as u64);
        let mut polygon = || {
            let points: Vec<[f64; 2]> = (0..12).map(|_| [random.unit(), random.unit()]).collect();
            YinSet::from_rings(&[points], InsideRule::Odd).unwrap()
        };
        let mut set = polygon();
        for _ in 0..6 {
            let other = polygon();
            let (both, either) = (set.meet(&other).unwrap(), set.join(&other).unwrap());
            let areas = [&set, &other, &both, &either].map(|set| set.area().unwrap());
            assert!((areas[0] + areas[1] - areas[2] - areas[3]).abs() < 1e-12, "{case}: {areas:?}");
            let normal = either.normalized().unwrap();
            assert_eq!(normal.set().validate().unwrap(), None, "{case}");
            assert!((normal.set().area().unwrap() - areas[3]).abs() < 1e-12, "{case}");
            set = set.symmetric_difference(&other).unwrap();
        }
    }
}

fn data(name: &str) -> Option<serde_json::Value> {
    let Some(folder) = std::env::var_os("COFACE_DATA") else {
        println!("skipped: COFACE_DATA names no folder");
        return None;
    };
    let text = std::fs::read_to_string(std::path::Path::new(&folder).join(name)).unwrap();
    Some(serde_json::from_str(&text).unwrap())
}

fn ring(value: &serde_json::Value) -> Vec<[f64; 2]> {
    let point = |point: &serde_json::Value| [0, 1].map(|axis| point[axis].as_f64().unwrap());
    value.as_array().unwrap().iter().map(point).collect()
}

fn shape(value: &serde_json::Value, shift: [f64; 2]) -> YinSet {
    let curves: Vec<Curve<'_>> = value
        .as_array()
        .unwrap()
        .iter()
        .map(|value| {
            let mut points: Vec<_> =
                ring(value).into_iter().map(|[x, y]| [x + shift[0], y + shift[1]]).collect();
            points.push(points[0]);
            Curve::polyline(&points).unwrap()
        })
        .collect();
    YinSet::new(&curves).unwrap()
}

fn is_close(found: f64, expected: f64, digits: f64) -> bool {
    (found - expected).abs() <= digits * expected.abs().max(1.0)
}

#[test]
fn panda_and_mickey_at_three_shifts() {
    let Some(shapes) = data("yin/polygons.json") else { return };
    let panda = shape(&shapes["Panda"], [0.0, 0.0]);
    let mickey = shape(&shapes["mickey.input"], [0.0, 0.0]);
    assert_eq!((panda.curve_counts(), mickey.curve_counts()), ([6, 4], [2, 4]));
    assert!(is_close(panda.area().unwrap(), 9.58648331242411, 1e-14));
    assert!(is_close(mickey.area().unwrap(), 7.81145623042809, 1e-14));
    let mut depths = [0; 5];
    (0..10).for_each(|curve| depths[panda.forest().depth(curve)] += 1);
    assert_eq!(depths, [1, 2, 4, 2, 1]);
    assert_eq!((0..6).map(|curve| mickey.forest().depth(curve)).max(), Some(3));
    let rows = [
        (-1.0, 3.65915098097378, [5, 0], 13.7387885618784, [6, 11], 5.92733233145, [13, 2]),
        (0.0, 3.87856540970183, [14, 2], 13.5193741331503, [1, 13], 5.70791790272, [17, 0]),
        (1.0, 1.85918172228191, [15, 1], 15.5387578205703, [2, 16], 7.72730159014, [13, 1]),
    ];
    for (shift, meet, meet_counts, join, join_counts, difference, difference_counts) in rows {
        let other = shape(&shapes["mickey.input"], [shift, 0.0]);
        let sets = [panda.meet(&other), panda.join(&other), panda.difference(&other)].map(Result::unwrap);
        let counts = sets.each_ref().map(YinSet::curve_counts);
        assert_eq!(counts, [meet_counts, join_counts, difference_counts], "{shift}");
        for (set, (expected, digits)) in sets.iter().zip([(meet, 1e-13), (join, 1e-13), (difference, 1e-11)])
        {
            assert!(is_close(set.area().unwrap(), expected, digits), "{shift}: {:?} {expected}", set.area());
            assert_eq!(set.normalized().unwrap().set().curve_counts(), set.curve_counts());
        }
    }
}

#[test]
fn panda_and_mickey_at_many_shifts() {
    let Some(shapes) = data("yin/polygons.json") else { return };
    let panda = shape(&shapes["Panda"], [0.0, 0.0]);
    let mut random = Random(7);
    for case in 0..soup_count(20).min(1000) {
        let shift = [random.unit() * 4.0 - 2.0, random.unit() * 4.0 - 2.0];
        let mickey = shape(&shapes["mickey.input"], shift);
        let (both, either) = (panda.meet(&mickey).unwrap(), panda.join(&mickey).unwrap());
        let areas = [&panda, &mickey, &both, &either].map(|set| set.area().unwrap());
        assert!((areas[0] + areas[1] - areas[2] - areas[3]).abs() < 1e-13, "{case} {shift:?}: {areas:?}");
        // Boundaries only cross here.
        let chi = |set: &YinSet| {
            let [components, cycles] = set.betti_open().unwrap();
            components as i64 - cycles as i64
        };
        assert_eq!(chi(&panda) + chi(&mickey), chi(&both) + chi(&either), "{case} {shift:?}");
    }
}

fn map(name: &str) -> Option<YinSet> {
    let mut rings = Vec::new();
    let value = data(name)?;
    let mut stack = vec![&value];
    while let Some(value) = stack.pop() {
        match (value["features"].as_array(), &value["geometry"], value["type"].as_str()) {
            (Some(features), ..) => stack.extend(features),
            (_, geometry, _) if geometry.is_object() => stack.push(geometry),
            (_, _, Some("Polygon")) => {
                rings.extend(value["coordinates"].as_array().unwrap().iter().map(ring));
            }
            (_, _, Some("MultiPolygon")) => {
                let polygons = value["coordinates"].as_array().unwrap().iter();
                rings.extend(polygons.flat_map(|polygon| polygon.as_array().unwrap().iter().map(ring)));
            }
            _ => panic!("{name} has something else"),
        }
    }
    Some(YinSet::from_rings(&rings, InsideRule::Odd).unwrap())
}

#[test]
fn overlays_of_maps() {
    let Some(manifest) = data("MANIFEST.json") else { return };
    let mut row_count = 0;
    for row in manifest["overlays"].as_array().unwrap() {
        let [a, b] = ["a", "b"].map(|name| row[name].as_str().unwrap());
        if !(a.ends_with("json") && b.ends_with("json")) {
            continue;
        }
        let (left, right) = (map(a).unwrap(), map(b).unwrap());
        row_count += 1;
        for (name, set) in [
            ("union", left.join(&right).unwrap()),
            ("intersection", left.meet(&right).unwrap()),
            ("a_minus_b", left.difference(&right).unwrap()),
            ("b_minus_a", right.difference(&left).unwrap()),
        ] {
            let expected = &row[name];
            assert!(
                is_close(set.area().unwrap(), expected["area"].as_f64().unwrap(), 1e-9),
                "{a} {b} {name}"
            );
            let count = expected["polygons"].as_u64().unwrap() as usize;
            println!("{a} {b} {name}: {:?}, expected {count} polygons", set.curve_counts());
        }
    }
    assert!(row_count > 0);
}

#[test]
fn the_exact_area_is_a_fraction() {
    let third = YinSet::from_rings(&[[[0., 0.], [3., 0.], [0., 1.]]], InsideRule::Nonzero).unwrap();
    assert_eq!(third.exact_area(), Some(&Rational::from(3) * &Rational::from(2).inverse().unwrap()));
    assert_eq!(YinSet::plane(Order::LINEAR).area(), None);
    assert_eq!(YinSet::empty(Order::CUBIC).area(), Some(0.0));
}
