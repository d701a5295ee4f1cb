//! Kinks of Yin sets that come and go.

use super::planar::drawing;
use super::{Clock, Task, Work};
use coface::Error;
use coface::yin::{EndCondition, KnotIndex, Order, YinSet};
use std::path::Path;

/// The knots from kink to kink.
const PIECE: u32 = 100;
/// As many kinks are inserted and erased.
const COUNT: u32 = 1000;

pub(super) const EDIT: Task = Task {
    name: "kink-edit",
    about: "1000 kinks inserted and erased, one after the other, on a cubic spline with a kink at every 100th knot",
    extension: "raw3",
    inputs: &["circle_10000", "circle_100000", "circle_1000000"],
    work: Work::Inside(edited),
};

pub(super) const INSERTION: Task = Task {
    name: "kink-insertion",
    about: "every fourth knot of a smooth cubic spline made a kink, all at once",
    extension: "raw3",
    inputs: &["circle_20000", "circle_40000", "circle_80000"],
    work: Work::Inside(inserted),
};

fn inserted(path: &Path, clock: &mut Clock) -> Result<String, Error> {
    let (positions, mesh) = drawing(path)?;
    let points = positions.as_flat().as_chunks::<2>().0;
    let ring: Vec<[f64; 2]> = mesh.lists.list(0).iter().map(|&point| points[point as usize]).collect();
    let count = ring.len() as u32;
    let mut set = YinSet::fit(&[ring], &[], Order::CUBIC, &EndCondition::NotAKnot)?;
    let knots: Vec<KnotIndex> = (0..count).step_by(4).map(|knot| KnotIndex { curve: 0, knot }).collect();
    clock.time(count as usize, || set.insert_kinks(&knots))?;
    Ok(format!("kinks {} area {:e}", set.kinks().len(), set.curve(0).signed_area()))
}

fn edited(path: &Path, clock: &mut Clock) -> Result<String, Error> {
    let (positions, mesh) = drawing(path)?;
    let points = positions.as_flat().as_chunks::<2>().0;
    let ring: Vec<[f64; 2]> = mesh.lists.list(0).iter().map(|&point| points[point as usize]).collect();
    let count = ring.len() as u32;
    let kinks = (0..count).step_by(PIECE as usize).collect();
    let mut set = YinSet::fit(&[ring], &[kinks], Order::CUBIC, &EndCondition::NotAKnot)?;
    let before = set.clone();
    // The first edit makes the boxes around all polynomials.
    let knot = |step: u32| {
        let piece = u64::from(step) * 7919 % u64::from(count / PIECE);
        KnotIndex { curve: 0, knot: piece as u32 * PIECE + 1 + step % (PIECE - 1) }
    };
    let first = set.insert_kink(knot(0))?;
    set.erase_kink(first)?;
    clock.time(2 * COUNT as usize, || {
        (0..COUNT).try_for_each(|step| {
            let kink = set.insert_kink(knot(step))?;
            set.erase_kink(kink).map(|_| ())
        })
    })?;
    Ok(format!("kinks {} unchanged {}", set.kinks().len(), set == before))
}
