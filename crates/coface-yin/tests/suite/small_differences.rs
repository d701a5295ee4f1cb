//! Sets that differ by little: what the overlay of their curves gives has the right shape and area.
#![allow(clippy::unwrap_used, reason = "a failing test shows where")]

use coface_arrange::boolean::BooleanFormula;
use coface_yin::{Combination, Curve, EndCondition, Flow, KnotIndex, Order, TrackingOptions, YinSet};

fn circle(knots: usize, shift: [f64; 2]) -> YinSet {
    YinSet::new(&[Curve::circle([0.0, 0.0], 1.0, knots, Order::CUBIC).unwrap().translated(shift)]).unwrap()
}

fn xor(a: &YinSet, b: &YinSet) -> Combination {
    YinSet::combine(&[a, b], &BooleanFormula::parse("a ^ b", &[]).unwrap()).unwrap()
}

fn check_area(found: &Combination, truth: f64) {
    let area = found.set().area().unwrap();
    assert!(
        (area - truth).abs() <= found.area_error(),
        "{area:e} is not {truth:e} up to {:e}",
        found.area_error()
    );
}

/// A moved circle differs by four times the way; the curves cross at an angle as small as the way.
#[test]
fn circles_that_are_moved_by_little() {
    let own = circle(32, [0.0, 0.0]);
    for (shift, error) in [(1e-6, 1e-12), (1e-10, 4e-11), (1e-11, 4e-12), (1e-12, 1e-12)] {
        for shift in [[shift, 0.0], [0.6 * shift, -0.8 * shift]] {
            let found = xor(&own, &circle(32, shift));
            let truth = own.comparison(&circle(32, shift)).unwrap();
            let size = shift[0].hypot(shift[1]);
            assert_eq!(found.set().betti_open().unwrap(), [2, 0], "{shift:?}");
            check_area(&found, truth.area_xor());
            let area = found.set().area().unwrap();
            assert!(
                (area - 4.0 * size).abs() < 1e-2 * size && found.area_error() < error,
                "{shift:?} {area:e} {:e}",
                found.area_error()
            );
        }
    }
}

/// Splines through n and n + 1 points of one circle change places 2 n - 2 times, and touch in the knot that they share.
#[test]
fn splines_of_one_circle_change_places() {
    for (knots, area) in [(32, 9.4212254e-6), (64, 5.9436644e-7), (128, 3.749989e-8), (512, 1.4788661e-10)] {
        let [a, b] = [circle(knots, [0.0, 0.0]), circle(knots + 1, [0.0, 0.0])];
        let found = xor(&a, &b);
        assert_eq!(found.set().betti_open().unwrap(), [2 * knots - 1, 0], "{knots}");
        assert!(found.report().is_empty(), "{knots}: {:?}", found.report()[0]);
        check_area(&found, a.comparison(&b).unwrap().area_xor());
        assert!((found.set().area().unwrap() / area - 1.0).abs() < 1e-5, "{knots}");
        // What is written is read again.
        let curves: Vec<Curve<'_>> = (0..found.set().curve_count()).map(|i| found.set().curve(i)).collect();
        assert_eq!(YinSet::fault(&curves).unwrap(), None, "{knots}");
    }
}

/// Where rounding takes more than what curves differ by, in some places or in all, that is an error or what is lost is no more than rounding:
/// the set is never empty where the curves are farther apart.
#[test]
fn differences_at_the_end_of_double_coordinates() {
    let own = circle(16, [0.0, 0.0]);
    let formula = BooleanFormula::parse("a ^ b", &[]).unwrap();
    for shift in [1e-12, 1e-13, 3e-14, 1e-14, 1e-15] {
        for shift in [[shift, 0.0], [0.6 * shift, -0.8 * shift]] {
            let other = circle(16, shift);
            let truth = own.comparison(&other).unwrap().area_xor();
            match YinSet::combine(&[&own, &other], &formula) {
                Ok(found) => {
                    check_area(&found, truth);
                    let is_empty = found.set().curve_count() == 0;
                    assert!(!is_empty || truth < 6e-14, "{shift:?}");
                    assert!(is_empty || found.set().betti_open().unwrap() == [2, 0], "{shift:?}");
                }
                Err(error) => assert!(shift[0] > 1e-14 && error.cure().is_some(), "{shift:?} {error}"),
            }
        }
    }
}

/// Far from the origin rounding of coordinates is coarse, and the resolution with it: a square of four units is no near bigon.
#[test]
fn squares_far_from_the_origin() {
    for order in [Order::LINEAR, Order::CUBIC] {
        let square = |x: f64| {
            let corners = [[x, x], [x + 4.0, x], [x + 4.0, x + 4.0], [x, x + 4.0]];
            if order == Order::LINEAR {
                return YinSet::new(&[Curve::polyline(&[
                    corners[0], corners[1], corners[2], corners[3], corners[0],
                ])
                .unwrap()])
                .unwrap();
            }
            let curve = Curve::fit_closed(&corners, &[0, 1, 2, 3], order, &EndCondition::NotAKnot).unwrap();
            let kinks = [0, 1, 2, 3].map(|knot| KnotIndex { curve: 0, knot });
            YinSet::new(&[curve]).unwrap().with_declared_kinks(&kinks, None, None).unwrap()
        };
        let [a, b] = [square(1e12), square(1e12 + 2.0)];
        assert_eq!(a.meet(&b).unwrap().area(), Some(4.0), "{order}");
        assert_eq!(a.join(&b).unwrap().area(), Some(28.0), "{order}");
        assert_eq!(a.symmetric_difference(&b).unwrap().area(), Some(24.0), "{order}");
    }
}

/// Two arcs that are short beside the resolution of a far larger operand, and bulge apart.
#[test]
fn a_blob_is_not_two_near_arcs() {
    let frame = Curve::circle([0.0, 0.0], 1e3, 64, Order::CUBIC).unwrap();
    let disk = |x: f64| YinSet::new(&[Curve::circle([x, 0.0], 1e-6, 32, Order::CUBIC).unwrap()]).unwrap();
    let around = YinSet::new(&[frame]).unwrap();
    let formula = BooleanFormula::parse("a & b & c", &[]).unwrap();
    let found = YinSet::combine(&[&around, &disk(0.0), &disk(1e-6)], &formula).unwrap();
    // The lens of two unit circles with centers a unit apart.
    let lens = (2.0 * std::f64::consts::PI / 3.0 - 0.75f64.sqrt()) * 1e-12;
    let area = found.set().area().unwrap();
    assert!((area / lens - 1.0).abs() < 1e-4, "{area:e} {lens:e}");
}

/// What a vortex moves there and back differs from where it came from by less and less, down to rounding here and there.
#[test]
fn what_a_vortex_gives_back() {
    let flow = Flow::Vortex { period: 4.0 };
    for (cells, steps) in [(64.0, 1.0), (64.0, 2.0), (128.0, 2.0)] {
        let spacing = 0.2 / cells;
        let count = (std::f64::consts::TAU * 0.15 / spacing).ceil() as usize;
        let start = YinSet::new(&[Curve::circle([0.5, 0.75], 0.15, count, Order::CUBIC).unwrap()]).unwrap();
        let options = TrackingOptions::new(4.0, 1.0 / (steps * cells), spacing);
        let back = start.advected(|point, time| flow.velocity(point, time), &options).unwrap().into_set();
        let found = xor(&start, &back);
        let truth = start.comparison(&back).unwrap();
        let miss = (found.set().area().unwrap() - truth.area_xor()).abs();
        assert!(miss <= found.area_error() + truth.area_xor_error(), "{cells} {steps} {miss:e}");
        assert!(found.area_error() < 1e-3 * truth.area_xor(), "{cells} {steps}");
    }
}
