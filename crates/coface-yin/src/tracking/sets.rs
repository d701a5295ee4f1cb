//! Yin sets that move.

use super::fronts::Fronts;
use super::watch::Watch;
use super::{TopologyEvent, TrackingCounts, TrackingOptions};
use crate::{YinFault, YinSet};
use coface_algebra::Error;
use coface_algebra::progress::stage;

/// A curve that became too short to have a shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VanishedCurve {
    pub(crate) curve: u32,
    pub(crate) time: f64,
    pub(crate) length: f64,
}

impl VanishedCurve {
    /// Its number at the beginning.
    pub fn curve(&self) -> u32 {
        self.curve
    }

    /// The time at the end of the step in which it vanished.
    pub fn time(&self) -> f64 {
        self.time
    }

    /// The length of the polygon of its markers then.
    pub fn length(&self) -> f64 {
        self.length
    }
}

/// A boundary that came to meet itself, and was cut and pasted by a rule.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Repair {
    pub(crate) step: usize,
    pub(crate) time: f64,
    pub(crate) fault: YinFault,
}

impl Repair {
    /// The step, counted from 1.
    pub fn step(&self) -> usize {
        self.step
    }

    /// The time at its end.
    pub fn time(&self) -> f64 {
        self.time
    }

    /// What was found first; curves have the numbers that they had at the beginning.
    pub fn fault(&self) -> YinFault {
        self.fault
    }
}

/// A Yin set that has moved.
#[derive(Clone, Debug)]
pub struct TrackedSet {
    pub(super) set: YinSet,
    pub(super) counts: TrackingCounts,
    pub(super) vanished: Vec<VanishedCurve>,
    pub(super) repairs: Vec<Repair>,
    pub(super) curves: Vec<u32>,
    pub(super) events: Vec<TopologyEvent>,
}

impl TrackedSet {
    /// The set at the end.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Curve, Flow, TrackingOptions, YinSet};
    /// let square = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?])?;
    /// let shift = Flow::Translation { velocity: [1.0, 0.0] };
    /// let moved = square.advected(|point, time| shift.velocity(point, time), &TrackingOptions::new(1.0, 0.5, 2.0))?;
    /// let [low, _] = moved.set().bounding_box().expect("a square is bounded");
    /// assert!((low[0] - 1.0).abs() < 1e-12);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn set(&self) -> &YinSet {
        &self.set
    }

    /// The set alone.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Curve, Flow, TrackingOptions, YinSet};
    /// let square = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?])?;
    /// let shift = Flow::Translation { velocity: [1.0, 0.0] };
    /// let moved = square.advected(|point, time| shift.velocity(point, time), &TrackingOptions::new(1.0, 0.5, 2.0))?;
    /// assert_eq!(moved.into_set().area(), Some(4.0));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn into_set(self) -> YinSet {
        self.set
    }

    /// What happened to markers.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Curve, Flow, TrackingOptions, YinSet};
    /// let square = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?])?;
    /// let shift = Flow::Translation { velocity: [1.0, 0.0] };
    /// let moved = square.advected(|point, time| shift.velocity(point, time), &TrackingOptions::new(1.0, 0.5, 2.0))?;
    /// assert_eq!((moved.counts().steps(), moved.counts().added()), (2, 0));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn counts(&self) -> TrackingCounts {
        self.counts
    }

    /// The curves that vanished, by time.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Curve, Flow, TrackingOptions, YinSet};
    /// let square = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?])?;
    /// let shift = Flow::Translation { velocity: [1.0, 0.0] };
    /// let moved = square.advected(|point, time| shift.velocity(point, time), &TrackingOptions::new(1.0, 0.5, 2.0))?;
    /// assert!(moved.vanished().is_empty());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn vanished(&self) -> &[VanishedCurve] {
        &self.vanished
    }

    /// What was cut and pasted on the way, by time; nothing without [`TrackingOptions::repair`].
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Curve, Flow, TrackingOptions, YinSet};
    /// let square = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?])?;
    /// let shift = Flow::Translation { velocity: [1.0, 0.0] };
    /// let moved = square.advected(|point, time| shift.velocity(point, time), &TrackingOptions::new(1.0, 0.5, 2.0))?;
    /// assert!(moved.repairs().is_empty());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn repairs(&self) -> &[Repair] {
        &self.repairs
    }

    /// For each curve its number at the beginning; after repairs the lowest number of the curves that it has parts of.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Curve, Flow, TrackingOptions, YinSet};
    /// let square = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?])?;
    /// let shift = Flow::Translation { velocity: [1.0, 0.0] };
    /// let moved = square.advected(|point, time| shift.velocity(point, time), &TrackingOptions::new(1.0, 0.5, 2.0))?;
    /// assert_eq!(moved.curves(), [0]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn curves(&self) -> &[u32] {
        &self.curves
    }

    /// The changes of the topology, by time; nothing without [`TrackingOptions::events`] or [`TrackingOptions::on_contact`].
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Curve, Flow, TrackingOptions, YinSet};
    /// let square = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?])?;
    /// let turn = Flow::Rotation { center: [0.0, 0.0], speed: 1.0 };
    /// let options = TrackingOptions::new(1.0, 0.5, 2.0).events(true);
    /// let moved = square.advected(|point, time| turn.velocity(point, time), &options)?;
    /// assert!(moved.events().is_empty());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn events(&self) -> &[TopologyEvent] {
        &self.events
    }
}

impl YinSet {
    /// The set after all points of the plane have moved with a velocity, which depends on the point and the time.
    ///
    /// The exact flow keeps the topology, and so does the result: its curves are those of the set, with the same kinks, names of kinks
    /// and places in the forest, but for those without curves in them that became shorter than three times the least distance of markers.
    /// Where curves come closer to each other than the error of tracking they may meet: that is an error, or repaired by the rule of
    /// [`TrackingOptions::repair`]; slivers that come of that, whose mean width (twice the area by the length) is below half of the least distance
    /// of markers, vanish unless small curves are kept. [`TrackingOptions::verification`] says when it is looked for.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for options without meaning, a velocity that is not finite, a
    /// curve that cannot be fitted any more, and curves that do not bound a set any more; the step, the time and the place are named.
    ///
    /// # Complexity
    /// Linear in markers times steps, in parallel over markers; and an overlay of the curves for each verification.
    ///
    /// # Examples
    /// A quarter turn.
    /// ```
    /// use coface_yin::{Curve, Flow, TrackingOptions, YinSet};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = Curve::polyline(&[[0., 0.], [1., 0.], [1., 1.], [0., 1.], [0., 0.]])?;
    /// let turn = Flow::Rotation { center: [0.0, 0.0], speed: std::f64::consts::FRAC_PI_2 };
    /// let moved = YinSet::new(&[square])?.advected(|p, t| turn.velocity(p, t), &TrackingOptions::new(1.0, 0.01, 1.0))?;
    /// let [x, y] = moved.set().curve(0).knot_point(0);
    /// assert!(x.abs() < 1e-15 && y.abs() < 1e-15);
    /// assert!((moved.set().area().expect("a square is bounded") - 1.0).abs() < 1e-9);
    /// # Ok(()) }
    /// ```
    pub fn advected(
        &self,
        velocity: impl Fn([f64; 2], f64) -> [f64; 2] + Sync,
        options: &TrackingOptions,
    ) -> Result<TrackedSet, Error> {
        let scheme = options.scheme_for(self.order());
        self.advected_by(|points, time, step| scheme.mapped_each(&velocity, points, time, step), options)
    }

    /// The same with velocities of many points at once: `velocities` gets points and a time, and gives a velocity for each of
    /// the points, in their order. Where a velocity of one point costs little beside a call, this is the faster way.
    ///
    /// # Errors
    /// As [`Self::advected`]; a list that is too short counts as velocities that are not finite.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Curve, EndCondition, Order, TrackingOptions, YinSet};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    /// let square = YinSet::new(&[Curve::fit_closed(&corners, &[], Order::LINEAR, &EndCondition::NotAKnot)?])?;
    /// let options = TrackingOptions::new(1.0, 0.5, 2.0);
    /// let moved = square.advected_together(|points, _| vec![[3.0, 0.0]; points.len()], &options)?;
    /// assert_eq!(moved.set().bounding_box(), Some([[3.0, 0.0], [4.0, 1.0]]));
    /// # Ok(()) }
    /// ```
    pub fn advected_together(
        &self,
        velocities: impl Fn(&[[f64; 2]], f64) -> Vec<[f64; 2]>,
        options: &TrackingOptions,
    ) -> Result<TrackedSet, Error> {
        let scheme = options.scheme_for(self.order());
        self.advected_by(
            |points, time, step| scheme.mapped_together(&velocities, points, time, step),
            options,
        )
    }

    fn advected_by(
        &self,
        map: impl Fn(&[[f64; 2]], f64, f64) -> Vec<[f64; 2]>,
        options: &TrackingOptions,
    ) -> Result<TrackedSet, Error> {
        let (steps, step) = options.steps()?;
        let range = options.range();
        let mut fronts = Fronts::new(self);
        let mut counts = TrackingCounts { steps, ..TrackingCounts::default() };
        let (mut vanished, mut repairs) = (Vec::new(), Vec::new());
        let mut watch = options.times_within()?.map(|tolerance| Watch::new(options, tolerance, &fronts));
        let steps_done = stage("moving", steps);
        for at in 0..steps {
            steps_done.advance(1);
            let time = options.start + at as f64 * step;
            let end_time = time + step;
            let in_step = |error: Error| in_step(&error, at + 1, end_time);
            if let Some(watch) = &mut watch {
                fronts = watch.step(fronts, &map, at + 1, [time, end_time], &mut counts).map_err(in_step)?;
                continue;
            }
            let map = |points: &[[f64; 2]]| map(points, time, step);
            let gone = fronts.advance(&map, range, &mut counts).map_err(in_step)?;
            vanished.extend(gone.into_iter().map(|gone| VanishedCurve {
                curve: gone.origin,
                time: end_time,
                length: gone.length,
            }));
            if !options.is_verified_after(at, steps) {
                continue;
            }
            let Some(fault) = fronts.fault(at + 1 == steps).map_err(in_step)? else { continue };
            let Some(rule) = options.repair else {
                return Err(in_step(met(fault)));
            };
            fronts.repair(rule).map_err(in_step)?;
            if !options.keep_small {
                let slivers = fronts.close_pasted_slivers(range.least);
                vanished.extend(slivers.into_iter().map(|gone| VanishedCurve {
                    curve: gone.origin,
                    time: end_time,
                    length: gone.length,
                }));
            }
            repairs.push(Repair { step: at + 1, time: end_time, fault });
        }
        let mut events = Vec::new();
        if let Some(mut watch) = watch {
            watch.finish(&mut fronts, steps).map_err(|error| in_step(&error, steps, options.end))?;
            (vanished, repairs, events) = watch.into_parts();
        }
        let (set, curves) = fronts.into_set();
        Ok(TrackedSet { set, counts, vanished, repairs, curves, events })
    }
}

/// That curves do not bound a set any more.
pub(super) fn met(fault: YinFault) -> Error {
    Error::invalid(fault.to_string())
        .with_cure("take shorter steps or a smaller spacing, or repair the set by a fill rule")
}

/// The same error, with the step in which it came, counted from 1, and the time at its end.
pub(super) fn in_step(error: &Error, step: usize, time: f64) -> Error {
    let said = Error::new(error.kind(), format!("in step {step}, at time {time}: {}", error.message()));
    match error.cure() {
        Some(cure) => said.with_cure(cure),
        None => said,
    }
}
