//! Yin sets that move.

use super::graphs::at_time;
use super::markers::{MarkerRange, moved_markers, polyline_length};
use super::{TrackingCounts, TrackingOptions};
use crate::Error;
use crate::yin::set::CurveArena;
use crate::yin::{Curve, EndCondition, KnotIndex, YinSet};

/// A curve that became too short to have a shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VanishedCurve {
    /// Its number at the beginning.
    pub curve: u32,
    /// The time at the end of the step in which it vanished.
    pub time: f64,
    /// The length of the polygon of its markers then.
    pub length: f64,
}

/// A Yin set that has moved.
#[derive(Clone, Debug)]
pub struct TrackedSet {
    set: YinSet,
    counts: TrackingCounts,
    vanished: Vec<VanishedCurve>,
    curves: Vec<u32>,
}

impl TrackedSet {
    /// The set at the end.
    pub fn set(&self) -> &YinSet {
        &self.set
    }

    /// The set alone.
    pub fn into_set(self) -> YinSet {
        self.set
    }

    /// What happened to markers.
    pub fn counts(&self) -> TrackingCounts {
        self.counts
    }

    /// The curves that vanished, by time.
    pub fn vanished(&self) -> &[VanishedCurve] {
        &self.vanished
    }

    /// For each curve its number at the beginning.
    pub fn curves(&self) -> &[u32] {
        &self.curves
    }
}

/// A curve on its way.
struct Front {
    curve: Curve<'static>,
    kinks: Vec<u32>,
    parent: Option<u32>,
    is_there: bool,
}

impl YinSet {
    /// The set after all points of the plane have moved with a velocity, which depends on the point and the time.
    ///
    /// The exact flow keeps the topology, and so does the result: its curves are those of the set, with the same kinks and places in
    /// the forest, but for those without curves in them that became shorter than three times the least distance of markers.
    /// Where curves have come closer to each other than the error of tracking, [`YinSet::validate`] tells whether they still bound a set.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](crate::ErrorKind::InvalidInput) for options without meaning, a velocity that is not finite, and a
    /// curve that cannot be fitted any more; the time is named.
    ///
    /// # Complexity
    /// Linear in markers times steps, in parallel over markers.
    ///
    /// # Examples
    /// A quarter turn.
    /// ```
    /// use coface::yin::{Curve, Flow, TrackingOptions, YinSet};
    /// # fn main() -> Result<(), coface::Error> {
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
        let (steps, step) = options.steps()?;
        let range = MarkerRange { least: options.least_ratio * options.spacing, most: options.spacing };
        let mut fronts: Vec<Front> = (0..self.curve_count())
            .map(|curve| Front {
                curve: self.curve(curve).into_owned(),
                kinks: Vec::new(),
                parent: self.forest().parent(curve).map(|parent| parent as u32),
                is_there: true,
            })
            .collect();
        for (kink, _) in self.kinks().iter() {
            fronts[kink.curve as usize].kinks.push(kink.knot);
        }
        let mut counts = TrackingCounts { steps, ..TrackingCounts::default() };
        let mut vanished = Vec::new();
        for at in 0..steps {
            let time = options.start + at as f64 * step;
            let map = |point| options.scheme.mapped(&velocity, point, time, step);
            let mut inner_counts = vec![0u32; fronts.len()];
            for front in fronts.iter().filter(|front| front.is_there) {
                if let Some(parent) = front.parent {
                    inner_counts[parent as usize] += 1;
                }
            }
            for (number, front) in fronts.iter_mut().enumerate().filter(|(_, front)| front.is_there) {
                let end_time = time + step;
                let is_kink = |knot: usize| front.kinks.binary_search(&(knot as u32)).is_ok();
                let moved = moved_markers(&front.curve, is_kink, &map, range, &mut counts)
                    .map_err(|error| at_time(&error, end_time))?;
                let length = polyline_length(&moved.points);
                let ring = &moved.points[..moved.points.len() - 1];
                if inner_counts[number] == 0 && (ring.len() < 3 || length < 3.0 * range.least) {
                    front.is_there = false;
                    vanished.push(VanishedCurve { curve: number as u32, time: end_time, length });
                    continue;
                }
                let kinks = (0..ring.len() as u32)
                    .filter(|&knot| {
                        moved.origins[knot as usize].is_some_and(|origin| is_kink(origin as usize))
                    })
                    .collect();
                front.kinks = kinks;
                front.curve = Curve::fit_closed(ring, &front.kinks, self.order(), &EndCondition::NotAKnot)
                    .map_err(|error| at_time(&error, end_time))?;
            }
        }
        let mut numbers = vec![u32::MAX; fronts.len()];
        let mut curves = Vec::new();
        let mut arena = CurveArena::new(self.order());
        let mut kinks = Vec::new();
        for (number, front) in fronts.iter().enumerate().filter(|(_, front)| front.is_there) {
            numbers[number] = curves.len() as u32;
            kinks.extend(front.kinks.iter().map(|&knot| KnotIndex { curve: curves.len() as u32, knot }));
            curves.push(number as u32);
            arena.push(&front.curve);
        }
        // What is around a curve that is there has not vanished.
        let parents = curves
            .iter()
            .map(|&number| fronts[number as usize].parent.map(|parent| numbers[parent as usize]))
            .collect();
        let set = Self::from_parts(arena, !self.is_bounded(), parents, kinks);
        Ok(TrackedSet { set, counts, vanished, curves })
    }
}
