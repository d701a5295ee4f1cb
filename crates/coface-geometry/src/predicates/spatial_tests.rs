//! Decisions about points in space against plain fractions.
#![allow(clippy::unwrap_used, reason = "a test that cannot go on is failing")]

use super::common_line::CommonLine;
use super::samples::{coordinate, rational};
use super::*;
use coface_algebra::Rational;
use proptest::prelude::*;
use std::cmp::Ordering;

type Vector = [Rational; 3];

fn vector(a: &Vector, b: &Vector) -> Vector {
    [0, 1, 2].map(|axis| &b[axis] - &a[axis])
}

fn cross(a: &Vector, b: &Vector) -> Vector {
    [(1, 2), (2, 0), (0, 1)].map(|(j, k)| &(&a[j] * &b[k]) - &(&a[k] * &b[j]))
}

fn dot(a: &Vector, b: &Vector) -> Rational {
    (0..3).fold(Rational::ZERO, |sum, axis| &sum + &(&a[axis] * &b[axis]))
}

fn plus_times(a: &Vector, d: &Vector, s: &Rational) -> Vector {
    [0, 1, 2].map(|axis| &a[axis] + &(&d[axis] * s))
}

fn point(p: [f64; 3]) -> Vector {
    p.map(rational)
}

fn normal(plane: SpatialPlane) -> Vector {
    let [a, b, c] = plane.map(point);
    cross(&vector(&a, &b), &vector(&a, &c))
}

fn sign(x: &Rational) -> Ordering {
    x.cmp(&Rational::ZERO)
}

fn on_plane(line: SpatialLine, plane: SpatialPlane) -> Option<Vector> {
    let [s, t] = line.map(point);
    let (n, d) = (normal(plane), vector(&s, &t));
    let along = &dot(&n, &vector(&s, &point(plane[0]))) * &dot(&n, &d).inverse()?;
    Some(plus_times(&s, &d, &along))
}

/// The line where two planes meet, cut by the third.
fn of_planes([f, g, h]: [SpatialPlane; 3]) -> Option<Vector> {
    let [nf, ng, nh] = [f, g, h].map(normal);
    let d = cross(&nf, &ng);
    let scale = dot(&d, &nh).inverse()?;
    let height = |n: &Vector, plane: SpatialPlane| dot(n, &point(plane[0]));
    // x = (c_f (g x h) + c_g (h x f) + c_h (f x g)) / det
    let terms = [(height(&nf, f), cross(&ng, &nh)), (height(&ng, g), cross(&nh, &nf)), (height(&nh, h), d)];
    let zero = [Rational::ZERO, Rational::ZERO, Rational::ZERO];
    let sum = terms.iter().fold(zero, |sum, (height, d)| plus_times(&sum, d, height));
    Some(sum.map(|x| &x * &scale))
}

fn of_lines(s: SpatialLine, t: SpatialLine) -> Option<Vector> {
    let ([a, b], [c, d]) = (s.map(point), t.map(point));
    let (u, v, across) = (vector(&a, &b), vector(&c, &d), vector(&a, &c));
    let n = cross(&u, &v);
    let square = dot(&n, &n).inverse()?;
    if sign(&dot(&n, &across)).is_ne() {
        return None;
    }
    Some(plus_times(&a, &u, &(&dot(&cross(&across, &v), &n) * &square)))
}

fn compare(a: &Vector, b: &Vector) -> Ordering {
    (0..3).fold(Ordering::Equal, |order, axis| order.then(a[axis].cmp(&b[axis])))
}

/// Coordinates of one sort: any size, a small grid, a grid that is not exact in binary, close numbers, and some that
/// are huge.
fn sorts() -> Vec<BoxedStrategy<f64>> {
    let near = (-3i32..4, -2i64..3)
        .prop_map(|(x, ulps)| f64::from_bits((f64::from(x) + 7.3).to_bits().wrapping_add_signed(ulps)));
    vec![
        coordinate().boxed(),
        (-2i32..3).prop_map(f64::from).boxed(),
        (-3i32..4).prop_map(|x| f64::from(x) * 0.1).boxed(),
        near.boxed(),
        (-1.0..1.0).boxed(),
        (-2i32..3, prop::sample::select(vec![1e-6, 1.0, 1e6])).prop_map(|(x, s)| f64::from(x) * s).boxed(),
        (-1000i32..1000).prop_map(|x| f64::from(x) * 1e38).boxed(),
        (-9i32..9).prop_map(|x| f64::from(x) * 1e-300).boxed(),
    ]
}

/// As many points of one sort.
fn points(count: usize) -> impl Strategy<Value = Vec<[f64; 3]>> {
    let of_a_sort =
        sorts().into_iter().map(|sort| prop::collection::vec(prop::array::uniform3(sort), count).boxed());
    prop::strategy::Union::new(of_a_sort)
}

/// All points of all definitions on some corners, with their fractions.
fn defined(corners: &[[f64; 3]]) -> Vec<(SpatialPoint, Vector)> {
    let plane = |i: usize| [corners[i % 9], corners[(i + 1) % 9], corners[(i + 3) % 9]];
    let line = |i: usize, j: usize| [corners[i % 9], corners[j % 9]];
    let mut found = vec![(SpatialPoint::given(corners[0]), point(corners[0]))];
    let mut add = |here: Option<SpatialPoint>, plain: Option<Vector>| {
        assert_eq!(here.is_some(), plain.is_some());
        found.extend(here.zip(plain));
    };
    for i in 0..3 {
        let (s, f) = (line(i, i + 5), plane(i + 1));
        add(SpatialPoint::on_plane(s, f), on_plane(s, f));
        let planes = [plane(i), plane(i + 3), plane(i + 4)];
        add(SpatialPoint::of_planes(planes), of_planes(planes));
        // The same point again.
        let planes = [plane(i + 4), plane(i), plane(i + 3)];
        add(SpatialPoint::of_planes(planes), of_planes(planes));
        // A line and a plane through one of its points.
        let s = line(i, i + 1);
        add(SpatialPoint::on_plane(s, plane(i)), on_plane(s, plane(i)));
        add(SpatialPoint::of_lines(s, line(i + 2, i + 1)), of_lines(s, line(i + 2, i + 1)));
        add(SpatialPoint::of_lines(s, line(i + 2, i + 6)), of_lines(s, line(i + 2, i + 6)));
    }
    found
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn given_points_decide_as_fractions(corners in points(9)) {
        let [a, b, c, d] = [0, 1, 2, 3].map(|i| corners[i]);
        let side = sign(&dot(&normal([a, b, c]), &vector(&point(a), &point(d))));
        prop_assert_eq!(spatial_orientation(a, b, c, d), side);
        let planes = [0, 3, 6].map(|i| [corners[i], corners[i + 1], corners[i + 2]]);
        let [f, g, h] = planes.map(normal);
        prop_assert_eq!(normals_turn(planes[0], planes[1], planes[2]), sign(&dot(&cross(&f, &g), &h)));
        prop_assert_eq!(direction_side([a, d], planes[1]), sign(&dot(&g, &vector(&point(a), &point(d)))));
        let (axis, found) = plane_axis(planes[0]);
        prop_assert_eq!(found, sign(&f[axis]));
        prop_assert_eq!(found.is_eq(), f.iter().all(|x| sign(x).is_eq()));
        let in_plane = planes[1].map(|p| sign(&dot(&f, &vector(&point(a), &point(p)))).is_eq());
        prop_assert_eq!(are_coplanar(planes[0], planes[1]), in_plane.iter().all(|&x| x));
    }

    #[test]
    fn implicit_points_decide_as_fractions(corners in points(9)) {
        let defined = defined(&corners);
        let planes = [0, 2, 5].map(|i| [corners[i], corners[i + 1], corners[(i + 3) % 9]]);
        for (p, plain) in &defined {
            prop_assert_eq!(&p.to_rational(), plain);
            for (axis, coordinate) in plain.iter().enumerate() {
                let rounded = p.rounded()[axis];
                let [low, high] = p.range(axis);
                prop_assert!((low == high || low.next_up() == high) && (rounded == low || rounded == high));
                if low.is_finite() && high.is_finite() {
                    prop_assert!(rational(low) <= *coordinate && *coordinate <= rational(high));
                    prop_assert_eq!(low == high, rational(rounded) == *coordinate);
                    // The nearest of the two, a tie to the even one.
                    let to_low = (coordinate - &rational(low)).cmp(&(&rational(high) - coordinate));
                    let nearest = if to_low.is_lt() || to_low.is_eq() && low.to_bits() % 2 == 0 { low } else { high };
                    prop_assert_eq!(rounded, nearest);
                }
            }
            let exactly = (0..3).all(|axis| p.range(axis)[0] == p.range(axis)[1]);
            prop_assert_eq!(p.is_exactly_rounded(), exactly);
            for plane in planes {
                let side = sign(&dot(&normal(plane), &vector(&point(plane[0]), plain)));
                prop_assert_eq!(p.side_of(plane), side);
            }
            for (q, other) in &defined {
                prop_assert_eq!(p.compare(q), compare(plain, other));
                for axis in 0..3 {
                    prop_assert_eq!(p.compare_coordinate(q, axis), plain[axis].cmp(&other[axis]));
                }
            }
        }
    }

    #[test]
    fn triangles_and_tetrahedra_run_as_fractions(corners in points(9), picks in prop::array::uniform16(0usize..19)) {
        let defined = defined(&corners);
        for pick in picks.chunks(4) {
            let [a, b, c, d] = [0, 1, 2, 3].map(|i| &defined[pick[i] % defined.len()]);
            let n = cross(&vector(&a.1, &b.1), &vector(&a.1, &c.1));
            for (axis, coordinate) in n.iter().enumerate() {
                prop_assert_eq!(normal_sign(axis, [&a.0, &b.0, &c.0]), sign(coordinate));
            }
            let side = sign(&dot(&n, &vector(&a.1, &d.1)));
            prop_assert_eq!(orientation_of_points([&a.0, &b.0, &c.0, &d.0]), side);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    #[test]
    fn lines_of_two_planes_decide_as_fractions(corners in points(10)) {
        let c = |i: usize| corners[i];
        let (f, g) = ([c(0), c(1), c(2)], [c(3), c(4), c(5)]);
        let others = [[c(6), c(7), c(8)], [c(0), c(9), c(4)]];
        // All these points are in f and in g.
        let mut shared: Vec<SpatialPoint> = Vec::new();
        for (own, other) in [(f, g), (g, f)] {
            shared.extend([[0, 1], [1, 2], [2, 0]].iter().filter_map(|ends| SpatialPoint::on_plane(ends.map(|i| own[i]), other)));
        }
        shared.extend(others.iter().filter_map(|&h| SpatialPoint::of_planes([f, h, g])));
        let cross_over = sign(&{ let n = cross(&normal(f), &normal(g)); dot(&n, &n) }).is_gt();
        for p in &shared {
            for q in &shared {
                let Some(line) = CommonLine::new(p, q) else {
                    // Points that are floating-point numbers forget their planes.
                    let known = !p.is_exactly_rounded() && !q.is_exactly_rounded();
                    prop_assert!(!(cross_over && known) || p.compare(q).is_eq());
                    continue;
                };
                let (a, b) = (p.to_rational(), q.to_rational());
                for pair in [[c(9), c(7)], [c(0), c(8)], [c(1), c(4)]] {
                    let [x, y] = pair.map(point);
                    let n = cross(&vector(&a, &b), &vector(&a, &x));
                    for (axis, coordinate) in n.iter().enumerate() {
                        prop_assert_eq!(line.normal_sign(axis, pair[0]), sign(coordinate));
                    }
                    prop_assert_eq!(line.orientation(pair[0], pair[1]), sign(&dot(&n, &vector(&a, &y))));
                    // The same cyclic order of three of them.
                    let given = pair.map(SpatialPoint::given);
                    prop_assert_eq!(orientation_of_points([&given[0], q, &given[1], p]), sign(&dot(&n, &vector(&a, &y))));
                    prop_assert_eq!(normal_sign(1, [&given[0], p, q]), sign(&n[1]));
                }
            }
        }
    }
}

#[test]
fn planes_through_one_point_meet_there() {
    // The corners of these triangles sum up to (1, 1, 1): all have the middle (1/3, 1/3, 1/3).
    let planes: Vec<SpatialPlane> = (0..8)
        .map(|i| {
            let number = |k: i32| f64::from((i * 37 + k * 23 + i * i * k) % 19 - 9);
            let [a, b] = [[0, 1, 2], [3, 4, 5]].map(|k| k.map(number));
            [a, b, [0, 1, 2].map(|axis| 1.0 - a[axis] - b[axis])]
        })
        .collect();
    let mut found = Vec::new();
    for i in 0..8 {
        for j in 0..i {
            found.extend((0..j).filter_map(|k| SpatialPoint::of_planes([planes[i], planes[j], planes[k]])));
            let line = [[-1.0; 3], [3.0; 3]];
            found.extend(SpatialPoint::on_plane(line, planes[i]));
        }
    }
    assert!(found.len() > 60);
    for point in &found {
        assert_eq!(point.rounded(), [1.0 / 3.0; 3]);
        assert!(!point.is_exactly_rounded());
        assert!(planes.iter().all(|&plane| point.side_of(plane).is_eq()));
        assert!(point.compare(&found[0]).is_eq());
        assert!(normal_sign(0, [point, &found[0], &found[1]]).is_eq());
        assert!(orientation_of_points([&SpatialPoint::given([5.0; 3]), point, &found[1], &found[2]]).is_eq());
    }
}

#[test]
fn points_are_small() {
    assert!(size_of::<SpatialPoint>() <= 320);
}

#[test]
fn beyond_the_largest_number_is_a_range_too() {
    let (line, plane) = ([[0., 0., 0.], [0., 1., 5e-309]], [[0., 0., -3.], [1., 0., -3.], [0., -1., -3.]]);
    let point = SpatialPoint::on_plane(line, plane).unwrap();
    assert_eq!((point.rounded()[1], point.range(1)), (f64::NEG_INFINITY, [f64::NEG_INFINITY, f64::MIN]));
    assert!(!point.is_exactly_rounded());
}
