//! Guide 7: Yin sets: boundaries of splines, their Boolean algebra, kinks, cut cells, and a boundary that moves.
//!
//! Run with `cargo run -p coface --example 07_yin_sets`.

use coface::arrange::boolean::BooleanFormula;
use coface::yin::{
    CartesianGrid, Curve, CutCells, EndCondition, Flow, KnotIndex, Order, TrackingOptions, YinSet,
};
use std::f64::consts::PI;

fn main() -> Result<(), coface::Error> {
    // A disk by a cubic spline through 64 points of its circle; its area is right to the fourth order.
    let disk = |x: f64| YinSet::new(&[Curve::circle([x, 0.0], 1.0, 64, Order::CUBIC)?]);
    let (left, right) = (disk(0.0)?, disk(1.0)?);
    let area = left.area().expect("a disk is bounded");
    assert!((area - PI).abs() < 1e-6);

    // Meet and join keep the arcs of both, and their areas add up.
    let (meet, join) = (left.meet(&right)?, left.join(&right)?);
    assert_eq!((meet.curve_counts(), join.curve_counts()), ([1, 0], [1, 0]));
    let sum = meet.area().expect("bounded") + join.area().expect("bounded");
    assert!((sum - 2.0 * area).abs() < 1e-13);
    // The corners of the lens are kinks.
    assert_eq!(meet.kinks().len(), 2);

    // The complement reaches to infinity: no area, one hole. Together with the disk it is the plane.
    let outside = left.complement()?;
    assert!(!outside.is_bounded() && outside.area().is_none());
    assert!(left.join(&outside)?.is_plane() && left.meet(&outside)?.is_empty());

    // Any formula of any number of sets at once, with where each piece of the boundary comes from.
    let crescent = YinSet::combine(&[&left, &right], &BooleanFormula::parse("a - b", &[])?)?;
    assert!(crescent.sources().iter().any(|source| source.operand == 1));
    assert!(crescent.report().is_empty(), "nothing was left to the resolution");

    // Which curves touch matters: a triangular hole that touches the rim leaves no loop in the open set.
    let closed = |points: &[[f64; 2]]| Curve::polyline(&[points, &points[..1]].concat());
    let pierced = YinSet::new(&[
        closed(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]])?,
        closed(&[[0.0, 0.0], [1.0, 2.0], [2.0, 1.0]])?,
    ])?;
    assert_eq!(
        (pierced.curve_counts(), pierced.betti_open()?, pierced.betti_closed()?),
        ([1, 1], [1, 0], [1, 1])
    );

    // Kinks come and go; erasing brings back every bit.
    let ring: Vec<[f64; 2]> =
        (0..32).map(|i| PI * f64::from(i) / 16.0).map(|t| [2.0 * t.cos(), t.sin()]).collect();
    let mut ellipse = YinSet::fit(&[ring], &[], Order::CUBIC, &EndCondition::NotAKnot)?;
    let smooth = ellipse.clone();
    let kink = ellipse.insert_kink(KnotIndex { curve: 0, knot: 0 })?;
    assert_ne!(ellipse.curve(0), smooth.curve(0));
    ellipse.erase_kink(kink)?;
    assert_eq!(ellipse.curve(0), smooth.curve(0));

    // On a grid the parts in all cells add up to the set.
    let grid = CartesianGrid::new([-2.5, -1.5], [0.1, 0.1], [50, 30])?;
    let cells = CutCells::new(&ellipse, grid)?;
    let whole = ellipse.area().expect("an ellipse is bounded");
    assert!((cells.total_area() - whole).abs() < 1e-12);

    // A boundary in a flow: after a quarter turn the ellipse stands upright.
    let turn = Flow::Rotation { center: [0.0, 0.0], speed: PI / 2.0 };
    let options = TrackingOptions::new(1.0, 0.01, 0.2);
    let turned = ellipse.advected(|point, time| turn.velocity(point, time), &options)?;
    let [low, high] = turned.set().bounding_box().expect("an ellipse has a box");
    assert!((high[1] - low[1] - 4.0).abs() < 1e-3);
    Ok(())
}
