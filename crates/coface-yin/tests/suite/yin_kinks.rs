//! Kinks of Yin sets: fits between them, edits one by one against fits of everything, names, and what is refused.

#![allow(clippy::unwrap_used)]

use coface_algebra::{ErrorKind, VertexId};
use coface_complexes::simplicial::{Simplex, SimplicialComplex};
use coface_yin::{Curve, EndCondition, KnotIndex, Order, YinSet, turning_kinks};
use std::f64::consts::{PI, TAU};

const CUBIC: Order = Order::CUBIC;

fn at(curve: u32, knot: u32) -> KnotIndex {
    KnotIndex { curve, knot }
}

fn flower(count: usize, size: f64, sense: f64) -> Vec<[f64; 2]> {
    (0..count)
        .map(|i| {
            let t = sense * TAU * i as f64 / count as f64;
            let radius = size * (1.0 + 0.15 * (5.0 * t).cos());
            [radius * t.cos() + 0.25, radius * t.sin() - 0.5]
        })
        .collect()
}

/// A flower with a hole and a small disk beside it.
fn garden(kinks: &[Vec<u32>], order: Order) -> YinSet {
    // Splines of higher orders go further away between points.
    let finer = if order > CUBIC { 3 } else { 1 };
    let mut island = flower(17 * finer, 0.3, 1.0);
    island.iter_mut().for_each(|[x, _]| *x += 4.0);
    YinSet::fit(
        &[flower(40 * finer, 2.0, 1.0), flower(23 * finer, 0.8, -1.0), island],
        kinks,
        order,
        &EndCondition::NotAKnot,
    )
    .unwrap()
}

/// All bits of all curves.
fn bits(set: &YinSet) -> Vec<u64> {
    (0..set.curve_count())
        .flat_map(|own| {
            let curve = set.curve(own);
            let numbers = curve.controls().as_flattened().iter().chain(curve.knots()).copied();
            numbers.map(f64::to_bits).collect::<Vec<_>>()
        })
        .collect()
}

fn fitted_from_scratch(set: &YinSet, own: usize) -> Curve<'static> {
    let curve = set.curve(own);
    let points: Vec<_> = (0..curve.piece_count()).map(|knot| curve.knot_point(knot)).collect();
    let kinks: Vec<u32> = set.kinks().on_curve(own as u32).collect();
    Curve::fit_closed(&points, &kinks, set.order(), &EndCondition::NotAKnot).unwrap()
}

struct Random(u64);

impl Random {
    fn below(&mut self, bound: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % bound
    }
}

#[test]
fn edits_one_by_one_give_what_fits_of_everything_give() {
    for order in [2, 4, 6] {
        let mut set = garden(&[vec![3, 20], vec![], vec![5]], Order::new(order).unwrap());
        let mut random = Random(7);
        let mut live: Vec<VertexId> = set.kinks().iter().map(|(_, vertex)| vertex).collect();
        let mut names = live.len();
        let mut refused = 0;
        for _ in 0..120 {
            let before = set.clone();
            if live.is_empty() || random.below(5) < 3 {
                let curve = random.below(3);
                let knot = at(curve as u32, random.below(set.curve(curve).piece_count()) as u32);
                match set.insert_kink(knot) {
                    Ok(vertex) => {
                        assert_eq!(vertex.index(), names, "names are new");
                        names += 1;
                        live.push(vertex);
                        assert_eq!(set.vertex_to_knot(vertex), Some(knot));
                        assert_eq!(set.knot_to_vertex(knot).unwrap(), Some(vertex));
                    }
                    Err(_) => {
                        refused += 1;
                        assert_eq!((bits(&set), &set), (bits(&before), &before));
                    }
                }
            } else {
                let vertex = live.swap_remove(random.below(live.len()));
                let knot = set.erase_kink(vertex).unwrap();
                assert_eq!((set.vertex_to_knot(vertex), set.vertex_to_point(vertex)), (None, None));
                assert_eq!(set.knot_to_vertex(knot).unwrap(), None);
            }
            assert_eq!(set.kinks().len(), live.len());
            for own in 0..3 {
                assert_eq!(set.curve(own), fitted_from_scratch(&set, own));
            }
        }
        assert!(refused < 60, "{refused}");
    }
}

/// Many edits at once against the same one after the other; what is refused changes nothing.
#[test]
fn edits_all_at_once_give_what_edits_one_by_one_give() {
    let mut random = Random(11);
    for order in [2, 4] {
        for _ in 0..12 {
            let mut set = garden(&[vec![3, 20], vec![], vec![5]], Order::new(order).unwrap());
            let mut single = set.clone();
            for _ in 0..3 {
                let knot = |random: &mut Random| {
                    let curve = random.below(3);
                    at(curve as u32, random.below(set.curve(curve).piece_count()) as u32)
                };
                let knots: Vec<KnotIndex> = (0..random.below(24)).map(|_| knot(&mut random)).collect();
                let before = (bits(&set), set.clone());
                let one_by_one = |single: &mut YinSet| {
                    knots.iter().map(|&knot| single.insert_kink(knot)).collect::<Result<Vec<_>, _>>()
                };
                let mut trial = single.clone();
                match (set.insert_kinks(&knots), one_by_one(&mut trial)) {
                    (Ok(names), Ok(expected)) => {
                        assert_eq!(names, expected);
                        single = trial;
                    }
                    // On the way the boundary may cross itself where it does not in the end.
                    (Ok(_), Err(error)) => {
                        assert!(error.to_string().contains("with this change"), "{error}");
                        set = before.1;
                    }
                    (Err(_), _) => assert_eq!((bits(&set), &set), (before.0, &before.1)),
                }
                assert_eq!((bits(&set), &set), (bits(&single), &single));
                for own in 0..3 {
                    assert_eq!(set.curve(own), fitted_from_scratch(&set, own));
                }
                let live: Vec<VertexId> = set.kinks().iter().map(|(_, vertex)| vertex).collect();
                let gone: Vec<VertexId> = live.into_iter().filter(|_| random.below(3) > 0).collect();
                let before = (bits(&set), set.clone());
                let mut trial = single.clone();
                let expected = gone.iter().map(|&kink| trial.erase_kink(kink)).collect::<Result<Vec<_>, _>>();
                match (set.erase_kinks(&gone), expected) {
                    (Ok(knots), Ok(expected)) => {
                        assert_eq!(knots, expected);
                        single = trial;
                    }
                    (Ok(_), Err(_)) => set = before.1,
                    (Err(_), _) => assert_eq!((bits(&set), &set), (before.0, &before.1)),
                }
                assert_eq!((bits(&set), &set), (bits(&single), &single));
            }
        }
    }
    let mut set = garden(&[vec![3, 20], vec![], vec![5]], CUBIC);
    let before = set.clone();
    for knots in [vec![at(0, 1), at(0, 3)], vec![at(1, 2), at(1, 2)], vec![at(0, 7), at(9, 0)]] {
        assert_eq!(set.insert_kinks(&knots).unwrap_err().kind(), ErrorKind::InvalidInput);
        assert_eq!(set, before);
    }
    let kink = set.kinks().iter().next().unwrap().1;
    assert!(set.erase_kinks(&[kink, kink]).is_err() && set.erase_kinks(&[kink, VertexId::new(99)]).is_err());
    assert_eq!((set.erase_kinks(&[]).unwrap().len(), set), (0, before));
}

#[test]
fn other_polynomials_keep_their_bits_and_erasing_brings_back_all() {
    let set = garden(&[vec![3, 20, 33], vec![], vec![]], CUBIC);
    let before = bits(&set);
    for (knot, changed) in [(at(0, 10), 3..20), (at(0, 25), 20..33), (at(1, 4), 0..23)] {
        let mut edited = set.clone();
        let kink = edited.insert_kink(knot).unwrap();
        assert_ne!(bits(&edited), before);
        for own in 0..3 {
            let [old, new] = [set.curve(own), edited.curve(own)];
            assert_eq!(old.knots(), new.knots());
            for piece in 0..old.piece_count() {
                let is_same = old.piece(piece) == new.piece(piece);
                assert!(is_same || own == knot.curve as usize && changed.contains(&piece), "{own} {piece}");
                assert_eq!(old.knot_point(piece), new.knot_point(piece));
            }
        }
        assert_eq!(edited.erase_kink(kink).unwrap(), knot);
        assert_eq!((bits(&edited), &edited), (before.clone(), &set));
        // A kink that was erased is another one when it comes again.
        assert_ne!(edited.insert_kink(knot).unwrap(), kink);
    }
    // The piece over the beginning of the curve.
    let mut edited = set.clone();
    edited.insert_kink(at(0, 0)).unwrap();
    let [old, new] = [set.curve(0), edited.curve(0)];
    for piece in 0..40 {
        assert_eq!(old.piece(piece) == new.piece(piece), (3..33).contains(&piece), "{piece}");
    }
}

#[test]
fn smooth_pieces_that_are_no_fits_come_back_in_any_order() {
    let [start, end] = [vec![[0.0, 3.0]], vec![[0.1, 2.5]]];
    let ring = flower(30, 1.0, 1.0);
    let ends = EndCondition::Complete { start, end };
    let set = YinSet::fit(&[ring], &[vec![0]], CUBIC, &ends).unwrap();
    assert_ne!(set.curve(0), fitted_from_scratch(&set, 0));
    let before = bits(&set);
    for order in [[0, 1, 2], [2, 1, 0], [1, 0, 2], [1, 2, 0]] {
        let mut edited = set.clone();
        let kinks = [5, 12, 22].map(|knot| edited.insert_kink(at(0, knot)).unwrap());
        for which in order {
            assert_ne!(bits(&edited), before);
            edited.erase_kink(kinks[which]).unwrap();
        }
        assert_eq!(bits(&edited), before);
    }
    // Without its kink the curve is the periodic spline; with a kink there again it is what it was.
    let mut edited = set;
    edited.erase_kink(VertexId::new(0)).unwrap();
    assert_eq!(edited.curve(0), fitted_from_scratch(&edited, 0));
    assert_eq!(edited.insert_kink(at(0, 30)).unwrap().index(), 1);
    assert_eq!(bits(&edited), before);
}

#[test]
fn smooth_pieces_are_the_splines_between_kinks() {
    let points = flower(20, 1.0, 1.0);
    for order in [4, 6, 8].map(|order| Order::new(order).unwrap()) {
        for ends in [EndCondition::NotAKnot, EndCondition::Natural] {
            let curve = Curve::fit_closed(&points, &[17, 4, 5], order, &ends).unwrap();
            for [first, last] in [[4, 5], [5, 17], [17, 24]] {
                let own: Vec<_> = (first..=last).map(|knot| points[knot % 20]).collect();
                let piece = Curve::fit(&own, order, &ends).unwrap();
                for at in 0..last - first {
                    assert_eq!(curve.piece((first + at) % 20), piece.piece(at));
                }
            }
        }
        // The knots are the chord lengths from point 0, whatever the kinks are.
        let smooth = Curve::fit_closed(&points, &[], order, &EndCondition::NotAKnot).unwrap();
        assert_eq!(
            smooth.knots(),
            Curve::fit_closed(&points, &[3], order, &EndCondition::NotAKnot).unwrap().knots()
        );
        // One kink: a spline from it round to it.
        let one = Curve::fit_closed(&points, &[3], order, &EndCondition::NotAKnot).unwrap();
        let own: Vec<_> = (3..=23).map(|knot| points[knot % 20]).collect();
        let open = Curve::fit(&own, order, &EndCondition::NotAKnot).unwrap();
        assert!((0..20).all(|at| one.piece((3 + at) % 20) == open.piece(at)));
        // The index after the last point is the first one.
        let [first, last] =
            [0, 20].map(|kink| Curve::fit_closed(&points, &[kink], order, &EndCondition::NotAKnot));
        assert_eq!(first.unwrap(), last.unwrap());
    }
}

#[test]
fn where_a_ring_begins_does_not_matter() {
    let points = flower(24, 1.0, 1.0);
    let whole = Curve::fit_closed(&points, &[2, 9, 15], CUBIC, &EndCondition::NotAKnot).unwrap();
    for turn in 1..24 {
        let mut turned = points.clone();
        turned.rotate_left(turn);
        let kinks = [2, 9, 15].map(|kink| ((kink + 24 - turn) % 24) as u32);
        let curve = Curve::fit_closed(&turned, &kinks, CUBIC, &EndCondition::NotAKnot).unwrap();
        assert!((0..24).all(|at| curve.piece(at) == whole.piece((at + turn) % 24)), "{turn}");
    }
}

#[test]
fn with_all_knots_kinks_the_boundary_is_straight() {
    let mut set = garden(&[], CUBIC);
    let polygons: f64 = garden(&[], Order::LINEAR).area().unwrap();
    let all: Vec<_> = (0..3)
        .flat_map(|own| (0..set.curve(own).piece_count()).map(move |knot| at(own as u32, knot as u32)))
        .collect();
    let all: Vec<_> = all.into_iter().rev().collect();
    set.reset_all_kinks(&all).unwrap();
    assert_eq!(set.kinks().len(), 80);
    assert!((set.area().unwrap() - polygons).abs() < 1e-14);
    let names: Vec<usize> = set.kinks().iter().map(|(_, vertex)| vertex.index()).collect();
    assert_eq!(names, (0..80).collect::<Vec<_>>());
    set.reset_all_kinks(&[]).unwrap();
    assert_eq!(bits(&set), bits(&garden(&[], CUBIC)));
    // At order 2 kinks are names.
    let mut lines = garden(&[], Order::LINEAR);
    let before = bits(&lines);
    lines.insert_kink(at(1, 22)).unwrap();
    lines.reset_all_kinks(&all).unwrap();
    assert_eq!((bits(&lines), lines.kinks().len()), (before, 80));
}

#[test]
fn kinks_are_a_complex_of_dimension_zero() {
    let mut set = garden(&[vec![30, 4], vec![0], vec![]], CUBIC);
    let found: Vec<_> = set.kinks().iter().map(|(knot, vertex)| (knot, vertex.index())).collect();
    assert_eq!(found, [(at(0, 4), 0), (at(0, 30), 1), (at(1, 0), 2)]);
    set.erase_kink(VertexId::new(1)).unwrap();
    let new = set.insert_kink(at(2, 1)).unwrap();
    assert_eq!(new.index(), 3);
    let mut complex = set.kinks().complex();
    assert_eq!(complex.f_vector(), [3]);
    assert!(complex.contains(&Simplex::from([3])) && !complex.contains(&Simplex::from([1])));
    // It is the user's own.
    complex.erase(&Simplex::from([0]));
    assert_eq!(set.kinks().complex().f_vector(), [3]);
    assert_eq!(set.vertex_to_point(new), Some(set.curve(2).knot_point(1)));
    assert_eq!(garden(&[], CUBIC).kinks().complex().dimension(), None);
    assert_eq!(SimplicialComplex::new().dimension(), None);
    // What was refused has no name.
    assert!(set.insert_kink(at(2, 1)).is_err());
    assert_eq!(set.insert_kink(at(2, 2)).unwrap().index(), 4);
}

#[test]
fn what_is_wrong_is_named() {
    let ring = flower(12, 1.0, 1.0);
    let fit = |ring: &[[f64; 2]], kinks: &[u32]| {
        Curve::fit_closed(ring, kinks, CUBIC, &EndCondition::NotAKnot).unwrap_err().to_string()
    };
    assert_eq!(fit(&ring[..2], &[]), "2 points make no closed curve; give 3 points or more");
    assert_eq!(fit(&ring, &[13]), "there is no point 13 to be a kink; the points are 0 to 11");
    assert_eq!(fit(&ring, &[5, 0, 12]), "kink 0 is given twice; give each kink once");
    let mut broken = ring.clone();
    broken[7][1] = f64::NAN;
    assert_eq!(fit(&broken, &[]), "point 7 is not finite; give finite coordinates");
    broken[7] = ring[6];
    assert!(fit(&broken, &[]).starts_with("points 6 and 7 are both ("));
    broken[7] = ring[7];
    broken[11] = ring[0];
    assert!(fit(&broken, &[]).starts_with("points 11 and 0 are both ("));
    let periodic = Curve::fit_closed(&ring, &[1], CUBIC, &EndCondition::Periodic).unwrap_err();
    assert!(periodic.to_string().starts_with("a curve with kinks is not periodic"));

    let set = |rings: &[Vec<[f64; 2]>], kinks: &[Vec<u32>]| {
        YinSet::fit(rings, kinks, CUBIC, &EndCondition::NotAKnot).unwrap_err().to_string()
    };
    let other: Vec<_> = ring.iter().map(|[x, y]| [x + 9.0, *y]).collect();
    assert_eq!(
        set(&[ring.clone(), other], &[vec![], vec![3, 3]]),
        "ring 1: kink 3 is given twice; give each kink once"
    );
    assert!(set(&[ring], &[vec![], vec![]]).starts_with("there are 2 lists of kinks for 1 rings"));

    let mut set = garden(&[vec![3]], CUBIC);
    let before = set.clone();
    for (error, words) in [
        (
            set.insert_kink(at(0, 3)).unwrap_err(),
            "knot 3 of curve 0 is a kink already: v0; insert kinks at other knots",
        ),
        (set.insert_kink(at(0, 41)).unwrap_err(), "there is no knot 41 on curve 0; the knots are 0 to 39"),
        (set.insert_kink(at(3, 0)).unwrap_err(), "there is no curve 3; the curves are 0 to 2"),
        (
            set.reset_all_kinks(&[at(1, 23), at(1, 0)]).unwrap_err(),
            "kink 0 of curve 1 is given twice; give each kink once",
        ),
        (
            set.erase_kink(VertexId::new(1)).unwrap_err(),
            "there is no kink v1; take the vertex of a kink that is there",
        ),
        (
            YinSet::plane(CUBIC).insert_kink(at(0, 0)).unwrap_err(),
            "there is no curve 0; sets without boundary have no knots",
        ),
    ] {
        assert_eq!(error.to_string(), words);
    }
    assert_eq!(set.erase_kink(VertexId::new(9)).unwrap_err().kind(), ErrorKind::NotInComplex);
    assert_eq!((bits(&set), set.kinks()), (bits(&before), before.kinks()));
    // The same knot by its other index.
    let kink = set.insert_kink(at(1, 23)).unwrap();
    assert_eq!(set.vertex_to_knot(kink), Some(at(1, 0)));
}

#[test]
fn edits_that_let_the_boundary_cross_leave_all_as_it_was() {
    // Two rectangles with little between them: a parabola over a corner goes through the other one.
    let low = vec![[0.0, 0.0], [4.0, 0.0], [4.0, 2.0], [0.0, 2.0]];
    let high = vec![[0.0, 2.1], [4.0, 2.1], [4.0, 3.0], [0.0, 3.0]];
    let all = vec![0, 1, 2, 3];
    let mut set = YinSet::fit(&[low, high], &[all.clone(), all], CUBIC, &EndCondition::NotAKnot).unwrap();
    assert_eq!(set.area(), Some(8.0 + 3.6));
    let before = set.clone();
    for kink in [2, 3, 4, 5] {
        set.erase_kink(VertexId::new(kink)).unwrap_err();
        assert_eq!((bits(&set), &set), (bits(&before), &before));
    }
    set.reset_all_kinks(&[]).unwrap_err();
    assert_eq!((bits(&set), &set), (bits(&before), &before));
    // On the other side there is room.
    set.erase_kink(VertexId::new(0)).unwrap();
    assert!(set.area().unwrap() > 11.7);
    let next = set.insert_kink(at(0, 0)).unwrap();
    assert_eq!((next.index(), bits(&set)), (8, bits(&before)));
}

#[test]
fn kinks_are_found_by_their_turns() {
    // A half disk: two corners, everything else turns by little.
    let ring: Vec<[f64; 2]> =
        (0..=60).map(|i| PI * f64::from(i) / 60.0).map(|t| [t.cos(), t.sin()]).collect();
    assert_eq!(turning_kinks(&ring, 0.5).unwrap(), [0, 60]);
    let set = YinSet::fit(&[ring], &[], CUBIC, &EndCondition::NotAKnot).unwrap();
    assert!(set.corners(1e-6).unwrap().is_empty());
    assert_eq!(set.detect_kinks(0.5).unwrap(), [at(0, 0), at(0, 60)]);
    let sharp = set.with_detected_kinks(0.5).unwrap();
    assert_eq!(sharp.corners(0.5).unwrap(), [at(0, 0), at(0, 60)]);
    assert!((sharp.area().unwrap() - PI / 2.0).abs() < 2e-6);
    assert!((set.area().unwrap() - PI / 2.0).abs() > 1e-4);
    for angle in [-1.0, 4.0, f64::NAN] {
        let error = set.detect_kinks(angle).unwrap_err().to_string();
        assert!(
            error.ends_with("is no angle to turn by; give radians between 0 and pi, for instance 0.5"),
            "{error}"
        );
    }
}

#[test]
fn knots_and_kinks_near_points() {
    let ring = vec![[0.0, 0.0], [4.0, 0.0], [5.0, 2.0], [4.0, 4.0], [0.0, 4.0]];
    let set = YinSet::fit(std::slice::from_ref(&ring), &[vec![1, 3]], Order::CUBIC, &EndCondition::NotAKnot)
        .unwrap();
    for x in -4..=24 {
        for y in -4..=20 {
            let point = [0.25 * f64::from(x), 0.25 * f64::from(y)];
            let far = |knot: u32| {
                let own = ring[knot as usize];
                (own[0] - point[0]).hypot(own[1] - point[1])
            };
            let nearest = |knots: &[u32]| knots.iter().map(|&knot| far(knot)).fold(f64::INFINITY, f64::min);
            let at = set.nearest_knot(point).unwrap().unwrap();
            assert_eq!(far(at.knot), nearest(&[0, 1, 2, 3, 4]));
            let kink = set.vertex_to_knot(set.nearest_kink(point).unwrap().unwrap()).unwrap();
            assert_eq!(far(kink.knot), nearest(&[1, 3]));
        }
    }
    assert_eq!(YinSet::plane(Order::CUBIC).nearest_knot([0.0; 2]).unwrap(), None);
    assert!(set.nearest_knot([f64::NAN, 0.0]).is_err());
    assert!(set.nearest_kink([0.0, f64::INFINITY]).is_err());
}
