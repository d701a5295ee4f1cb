//! Boundaries that move.

use super::planar::drawing;
use super::{Clock, Task, Work};
use coface::Error;
use coface::yin::{EndCondition, Flow, Order, TrackingOptions, Verification, YinSet};
use std::f64::consts::TAU;
use std::path::Path;

/// So many steps of time.
const STEPS: u32 = 10;

pub(super) const TASK: Task = Task {
    name: "yin-advect",
    about: "ten steps of a cubic spline in a vortex, with markers added, the boundary verified after each step",
    extension: "raw3",
    inputs: &["circle_25000", "circle_50000", "circle_100000"],
    work: Work::Inside(moved),
};

fn moved(path: &Path, clock: &mut Clock) -> Result<String, Error> {
    let (positions, mesh) = drawing(path)?;
    let points = positions.as_flat().as_chunks::<2>().0;
    let ring = mesh.lists.iter().next().ok_or_else(|| Error::invalid("there is no polygon"))?;
    // A disk of a tenth of the size, in the unit square where the vortex turns.
    let place = |point: [f64; 2]| [0.5 + 0.1 * point[0], 0.7 + 0.1 * point[1]];
    let ring: Vec<[f64; 2]> = ring.iter().map(|&point| place(points[point as usize])).collect();
    let count = ring.len();
    let disk = YinSet::fit(&[ring], &[], Order::CUBIC, &EndCondition::NotAKnot)?;
    let flow = Flow::Vortex { period: 4.0 };
    let end = 0.5;
    let options = TrackingOptions {
        verification: Verification::EachStep,
        ..TrackingOptions::new(end, end / f64::from(STEPS), 1.2 * 0.1 * TAU / count as f64)
    };
    let found = clock.time(count, || disk.advected(|point, time| flow.velocity(point, time), &options))?;
    let counts = found.counts();
    let lost = (found.set().signed_area() - disk.signed_area()).abs();
    Ok(format!("markers {} added {} area lost {lost:.0e}", found.set().curve(0).piece_count(), counts.added))
}
