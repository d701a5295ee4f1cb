//! Yin sets: tables of known sets, what curves are refused for, where points lie.

#![allow(clippy::unwrap_used)]

use coface_arrange::boolean::{BooleanFormula, InsideRule};
use coface_yin::{AtomKind, Curve, Order, SetLocation, YinFault, YinSet};

/// The polygons of the tables; diamonds, squares and triangles on the integers.
fn spadjor(number: usize) -> YinSet {
    let rings: &[&[[f64; 2]]] = match number {
        1 => &[
            &[[0., 4.], [3., 0.], [8., 4.], [2., 8.]],
            &[[3., 3.], [3., 5.], [5., 5.], [5., 3.]],
            &[[10., 4.], [10., 8.], [6., 0.]],
        ],
        2 => &[
            &[[8., 4.], [4., 0.], [0., 4.], [4., 8.]],
            &[[2., 2.], [6., 2.], [6., 6.], [2., 6.]],
            &[[8., 0.], [8., 2.], [10., 2.], [10., 0.]],
        ],
        3 => &[&[[0., 2.], [4., -2.], [8., 2.], [4., 6.]]],
        4 => &[&[[4., 2.], [8., -2.], [12., 2.], [8., 6.]]],
        5 => &[&[[4., 2.], [2., 4.], [4., 6.], [6., 4.]]],
        6 => &[&[[0., 2.], [2., 0.], [8., 6.], [6., 8.]]],
        7 => &[&[[2., 0.], [2., 4.], [6., 4.]]],
        8 => &[&[[0., 0.], [0., 4.], [4., 4.], [4., 0.]], &[[7., 3.], [7., 5.], [9., 5.], [9., 3.]]],
        9 => &[&[[4., 4.], [4., 8.], [8., 8.], [8., 4.]], &[[-1., 3.], [-1., 5.], [1., 5.], [1., 3.]]],
        10 => &[&[[8., 2.], [9., 2.], [9., 1.], [8., 1.]], &[[0., 2.], [0., 6.], [4., 6.], [4., 2.]]],
        11 => &[&[[0., 4.], [2., -2.], [6., -2.], [8., 4.], [4., 6.]], &[[4., 6.], [6., 0.], [2., 0.]]],
        12 => &[&[[-2., -4.], [10., -4.], [10., 8.], [-2., 8.]], &[[3.5, 2.], [4.5, 2.], [4., 0.5]]],
        13 => {
            &[&[[-2., -4.], [10., -4.], [10., 8.], [-2., 8.]], &[[-1., 2.], [9., 2.], [9., -3.], [-1., -3.]]]
        }
        _ => unreachable!(),
    };
    of_rings(rings).unwrap()
}

fn curve(ring: &[[f64; 2]]) -> Curve<'static> {
    let mut points = ring.to_vec();
    points.push(points[0]);
    Curve::polyline(&points).unwrap()
}

/// Rings as they are, or reversed so that they alternate by depth from positive roots.
fn of_rings(rings: &[&[[f64; 2]]]) -> Result<YinSet, coface_algebra::Error> {
    let curves: Vec<_> = rings.iter().map(|ring| curve(ring)).collect();
    YinSet::new(&curves)
}

/// The signed areas of the curves, rising.
fn areas(set: &YinSet) -> Vec<f64> {
    let mut areas: Vec<f64> = (0..set.curve_count())
        .map(|number| {
            let only = YinSet::new(&[set.curve(number)]).unwrap();
            assert_eq!(only.is_bounded(), set.is_positive(number));
            only.signed_area()
        })
        .collect();
    areas.sort_by(f64::total_cmp);
    areas
}

fn assert_areas(set: &YinSet, expected: &[f64]) {
    let (mut expected, found) = (expected.to_vec(), areas(set));
    expected.sort_by(f64::total_cmp);
    assert_eq!(found.len(), expected.len(), "{found:?} {expected:?}");
    for (a, b) in found.iter().zip(&expected) {
        assert!((a - b).abs() <= 1e-12 * b.abs(), "{found:?} {expected:?}");
    }
}

/// Spec of each row: curves, whether bounded, counts, the same of the complement.
#[test]
fn complements_of_the_table() {
    #[allow(clippy::type_complexity, reason = "a table")]
    let rows: [(usize, &[f64], bool, [usize; 2], [usize; 2], &[f64]); 9] = [
        (1, &[32., -4., 8.], true, [2, 1], [2, 2], &[-32., 4., -8.]),
        (2, &[-32., 16., -4.], false, [2, 2], [5, 0], &[4., 4., 4., 4., 4.]),
        (3, &[32.], true, [1, 0], [1, 1], &[-32.]),
        (5, &[-8.], false, [1, 1], [1, 0], &[8.]),
        (8, &[-16., -4.], false, [1, 2], [2, 0], &[16., 4.]),
        (10, &[-1., -16.], false, [1, 2], [2, 0], &[1., 16.]),
        (11, &[44., -12.], true, [1, 1], [2, 1], &[-44., 12.]),
        (12, &[144., -0.75], true, [1, 1], [2, 1], &[-144., 0.75]),
        (13, &[144., -50.], true, [1, 1], [2, 1], &[-144., 50.]),
    ];
    for (number, own, is_bounded, counts, outer_counts, outer) in rows {
        let set = spadjor(number);
        assert_areas(&set, own);
        assert_eq!((set.is_bounded(), set.curve_counts()), (is_bounded, counts), "{number}");
        let complement = set.complement().unwrap();
        assert_areas(&complement, outer);
        assert_eq!((complement.is_bounded(), complement.curve_counts()), (!is_bounded, outer_counts));
        assert_eq!(complement.validate().unwrap(), None);
        let back = complement.complement().unwrap();
        assert_eq!(back.straightened(), set.canonical().straightened(), "{number}");
        assert_eq!(back.complement().unwrap(), complement, "{number}");
    }
}

#[test]
fn meets_and_joins_of_the_table() {
    type Row = (usize, usize, &'static [f64], [usize; 2], &'static [f64], [usize; 2]);
    let rows: [Row; 8] = [
        (3, 4, &[8.], [1, 0], &[56.], [1, 0]),
        (3, 5, &[24.], [1, 0], &[], [1, 0]),
        (3, 6, &[16.], [1, 0], &[40.], [1, 0]),
        (3, 7, &[16., 4., 4.], [3, 0], &[], [1, 0]),
        (3, 10, &[24.], [1, 0], &[-8., -1.], [1, 2]),
        (8, 9, &[-19., -19.], [1, 2], &[-1., -1.], [1, 2]),
        (11, 12, &[44., -12.], [1, 1], &[144., -0.75], [1, 1]),
        (11, 13, &[26. / 3., 26. / 3.], [2, 0], &[144., -86. / 3., -20. / 3.], [1, 2]),
    ];
    for (a, b, meet, meet_counts, join, join_counts) in rows {
        let (left, right) = (spadjor(a), spadjor(b));
        for [a, b] in [[&left, &right], [&right, &left]] {
            let (both, either) = (a.meet(b).unwrap(), a.join(b).unwrap());
            assert_areas(&both, meet);
            assert_areas(&either, join);
            assert_eq!((both.curve_counts(), either.curve_counts()), (meet_counts, join_counts));
        }
        assert_eq!(left.meet(&right).unwrap(), right.meet(&left).unwrap());
    }
    let knots = |set: &YinSet| set.curve(0).piece_count();
    assert_eq!(knots(&spadjor(3).join(&spadjor(4)).unwrap()), 8);
    assert_eq!(knots(&spadjor(3).meet(&spadjor(5)).unwrap()), 6);
    assert_eq!(knots(&spadjor(3).meet(&spadjor(10)).unwrap()), 5);
    for (a, b) in [(3, 5), (3, 7)] {
        assert!(spadjor(a).join(&spadjor(b)).unwrap().is_plane());
    }
}

#[test]
fn betti_numbers_where_curves_touch() {
    // A hole that touches the curve around it: nothing leads around it.
    let set = spadjor(11);
    assert_eq!((set.betti_open().unwrap(), set.betti_closed().unwrap()), ([1, 0], [1, 1]));
    // Three triangles that touch in a ring.
    let ring = spadjor(3).meet(&spadjor(7)).unwrap();
    assert_eq!((ring.betti_open().unwrap(), ring.betti_closed().unwrap()), ([3, 0], [1, 1]));
    // Two holes that touch in a point.
    let holes = spadjor(8).meet(&spadjor(9)).unwrap();
    assert_eq!((holes.curve_counts(), holes.betti_open().unwrap()), ([1, 2], [1, 1]));
    // A diamond hole around a square that touches its sides.
    let set = spadjor(2);
    assert_eq!((set.betti_open().unwrap(), set.betti_closed().unwrap()), ([2, 2], [1, 5]));
    // A diamond whose square hole touches each side: four triangles in a ring.
    let ring = |points: &[[f64; 2]]| Curve::polyline(&[points, &points[..1]].concat()).unwrap();
    let diamond = ring(&[[0.0, 2.0], [4.0, -2.0], [8.0, 2.0], [4.0, 6.0]]);
    let square = ring(&[[2.0, 0.0], [2.0, 4.0], [6.0, 4.0], [6.0, 0.0]]);
    let set = YinSet::new(&[diamond, square]).unwrap();
    assert_eq!((set.betti_open().unwrap(), set.betti_closed().unwrap()), ([4, 0], [1, 1]));
    assert!(!set.is_connected().unwrap());
    // Four square holes that touch in a ring cut out the square between them.
    let at = |x: f64, y: f64| ring(&[[x, y], [x, y + 1.0], [x + 1.0, y + 1.0], [x + 1.0, y]]);
    let around = ring(&[[-9.0, -9.0], [9.0, -9.0], [9.0, 9.0], [-9.0, 9.0]]);
    let set = YinSet::new(&[around, at(0.0, 0.0), at(1.0, 1.0), at(2.0, 0.0), at(1.0, -1.0)]).unwrap();
    assert_eq!((set.betti_open().unwrap(), set.betti_closed().unwrap()), ([2, 1], [1, 4]));
    for (set, betti) in [(YinSet::empty(Order::LINEAR), [0, 0]), (YinSet::plane(Order::LINEAR), [1, 0])] {
        assert_eq!((set.betti_open().unwrap(), set.betti_closed().unwrap()), (betti, betti));
        assert_eq!(set.curve_counts(), betti);
    }
}

#[test]
fn atoms_and_depths() {
    let set = spadjor(2);
    let atoms = set.atoms();
    let kinds: Vec<_> = atoms.iter().map(|atom| (atom.kind(), atom.hole_count())).collect();
    assert_eq!(kinds, [(AtomKind::Minus, 2), (AtomKind::Plus, 0)]);
    let own: Vec<Vec<usize>> = atoms.iter().map(|atom| atom.curves().collect()).collect();
    assert_eq!(own, [vec![0, 2], vec![1]]);
    assert!(!set.is_connected().unwrap() && spadjor(3).is_connected().unwrap());
    assert!(spadjor(11).forest().parent(1) == Some(0) && spadjor(11).forest().depth(1) == 1);
}

#[test]
fn points_of_a_quadrilateral() {
    let ring = [[0., 2.], [0., -1.], [1., 0.], [1., 1.]];
    let mut reversed = ring;
    reversed.reverse();
    let sets = [of_rings(&[&ring]).unwrap(), of_rings(&[&reversed]).unwrap()];
    for (set, [inside, outside]) in sets
        .iter()
        .zip([[SetLocation::Inside, SetLocation::Outside], [SetLocation::Outside, SetLocation::Inside]])
    {
        for point in [[0., 2.], [1., 1.], [1., 0.5], [0., -1.]] {
            assert!(matches!(set.locate(point).unwrap(), SetLocation::Boundary { curve: 0, .. }));
        }
        assert_eq!(set.locate([0.5, 0.5]).unwrap(), inside);
        assert_eq!(set.locate_all(&[[-1., 0.], [0.5, -2.]]).unwrap(), [outside; 2]);
        assert!(set.locate([f64::NAN, 0.0]).is_err());
    }
}

#[test]
fn what_curves_are_refused_for() {
    let square =
        |x: f64, y: f64, side: f64| curve(&[[x, y], [x + side, y], [x + side, y + side], [x, y + side]]);
    let fault = |curves: &[Curve<'_>]| YinSet::fault(curves).unwrap();
    let bow = curve(&[[0., 0.], [2., 2.], [2., 0.], [0., 2.]]);
    assert_eq!(fault(std::slice::from_ref(&bow)), Some(YinFault::SelfMeeting { curve: 0, point: [1., 1.] }));
    let message = YinSet::new(&[square(5., 5., 1.), bow]).unwrap_err().to_string();
    assert!(message.starts_with("curve 1 comes to (1, 1) more than once; "), "{message}");
    // Touching itself in a corner is no Jordan curve either.
    let pinched = curve(&[[0., 0.], [2., 0.], [1., 1.], [2., 2.], [0., 2.], [1., 1.]]);
    assert_eq!(fault(&[pinched]), Some(YinFault::SelfMeeting { curve: 0, point: [1., 1.] }));
    let crossing = [square(0., 0., 2.), square(1., 1., 2.)];
    assert!(matches!(
        fault(&crossing),
        Some(YinFault::Crossing { curves: [0, 1], point: [2., 1.] | [1., 2.] })
    ));
    let sharing = [square(0., 0., 2.), square(2., 0., 2.)];
    let Some(YinFault::Overlap { curves: [0, 1], mut ends }) = fault(&sharing) else { panic!() };
    ends.sort_by(|a, b| a.partial_cmp(b).unwrap());
    assert_eq!(ends, [[2., 0.], [2., 2.]]);
    let slit = curve(&[[0., 0.], [2., 0.], [2., 2.], [1., 2.], [1., 1.], [1., 2.], [0., 2.]]);
    assert!(matches!(fault(&[slit]), Some(YinFault::Overlap { curves: [0, 0], .. })));
    assert_eq!(
        fault(&[square(0., 0., 4.), square(1., 1., 1.)]),
        Some(YinFault::Orientation { curve: 1, parent: 0 })
    );
    let mut hole = vec![[5., 5.], [5., 6.], [6., 6.]];
    assert_eq!(fault(&[square(0., 0., 4.), curve(&hole)]), Some(YinFault::MixedRoots { curves: [0, 1] }));
    hole.push([5., 5.]);
    assert!(
        fault(&[Curve::polyline(&[[0., 0.], [1., 0.], [1., 1.]]).unwrap()])
            .is_some_and(|fault| fault == YinFault::Open { curve: 0 })
    );
    assert_eq!(
        fault(&[Curve::polyline(&[[0., 0.], [1., 0.], [0., 0.]]).unwrap()]),
        Some(YinFault::TooFewPieces { curve: 0 })
    );
    assert!(YinSet::new(&[]).is_err());
    // Squares that touch in a corner are a set.
    assert_eq!(fault(&[square(0., 0., 1.), square(1., 1., 1.)]), None);
    // All of these have a repair.
    let wild = [[0., 0.], [2., 2.], [2., 0.], [0., 2.]];
    assert_eq!(YinSet::from_rings(&[wild], InsideRule::Nonzero).unwrap().curve_counts(), [2, 0]);
    assert_eq!(YinSet::from_rings(&[wild], InsideRule::Positive).unwrap().curve_counts(), [1, 0]);
    let error = YinSet::from_rings(&[wild, [[0., f64::NAN]; 4]], InsideRule::Odd).unwrap_err();
    assert!(error.to_string().starts_with("point 0 of ring 1 is not finite"), "{error}");
    let formula = BooleanFormula::parse("a & c", &[]).unwrap();
    assert!(YinSet::combine(&[&spadjor(3), &spadjor(4)], &formula).is_err());
}

/// Curves that run either way bound what is inside of them; each turned by hand is the second method.
#[test]
fn curves_of_any_direction_bound_their_inside() {
    let ring = |radius: f64, order: Order| Curve::circle([0.1, -0.2], radius, 12, order).unwrap();
    for order in [Order::LINEAR, Order::CUBIC] {
        let nested: Vec<Curve<'_>> = [3.0, 2.0, 1.0, 0.5].iter().map(|&radius| ring(radius, order)).collect();
        let turned: Vec<Curve<'_>> = nested
            .iter()
            .enumerate()
            .map(|(at, curve)| if at % 2 == 0 { curve.clone() } else { curve.reversed() })
            .collect();
        let right = YinSet::new(&turned).unwrap();
        for mask in 0..16 {
            let given: Vec<Curve<'_>> = nested
                .iter()
                .enumerate()
                .map(|(at, curve)| if mask >> at & 1 == 0 { curve.clone() } else { curve.reversed() })
                .collect();
            let found = YinSet::oriented(&given).unwrap();
            // Knots that are turned twice are off by rounding, the curves are not.
            assert_eq!(found.curve_counts(), right.curve_counts(), "{order} {mask}");
            assert_eq!(found.area(), right.area(), "{order} {mask}");
            assert!(found.has_points_of(&right).unwrap(), "{order} {mask}");
        }
    }
    assert!(YinSet::oriented(&[]).is_err());
    let crossing = [ring(1.0, Order::CUBIC), ring(1.0, Order::CUBIC).translated([0.5, 0.0])];
    assert!(YinSet::oriented(&crossing).is_err());
}
