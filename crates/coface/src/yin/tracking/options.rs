//! How boundaries are tracked.

use crate::Error;

/// A scheme for mapping points over a step of time.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum RungeKutta {
    /// The midpoint rule, of order two.
    Midpoint,
    /// The classical scheme with four stages, of order four.
    #[default]
    Classical,
}

impl RungeKutta {
    /// Where a point is after a step.
    pub(super) fn mapped(
        self,
        velocity: &impl Fn([f64; 2], f64) -> [f64; 2],
        point: [f64; 2],
        time: f64,
        step: f64,
    ) -> [f64; 2] {
        let moved =
            |velocity: [f64; 2], step: f64| [point[0] + step * velocity[0], point[1] + step * velocity[1]];
        let (half, middle) = (0.5 * step, time + 0.5 * step);
        let first = velocity(point, time);
        let second = velocity(moved(first, half), middle);
        if self == Self::Midpoint {
            return moved(second, step);
        }
        let third = velocity(moved(second, half), middle);
        let fourth = velocity(moved(third, step), time + step);
        moved(
            [0, 1].map(|axis| (first[axis] + 2.0 * (second[axis] + third[axis]) + fourth[axis]) / 6.0),
            step,
        )
    }
}

/// From when to when, in which steps, and with which spacing of markers a boundary is tracked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TrackingOptions {
    /// The time at which the boundary is as given.
    pub start: f64,
    /// The time at which it is asked for; it may be earlier.
    pub end: f64,
    /// The longest step of time; all steps are equally long.
    pub time_step: f64,
    /// The greatest distance h of neighboring markers.
    pub spacing: f64,
    /// The least distance of neighboring markers as a part r of h, at most 1/3 so that both can be kept.
    pub least_ratio: f64,
    /// The scheme that maps markers.
    pub scheme: RungeKutta,
}

impl TrackingOptions {
    /// From time 0 to `end` with steps and spacing as given; r = 1/10 and the scheme of order four.
    pub fn new(end: f64, time_step: f64, spacing: f64) -> Self {
        Self { start: 0.0, end, time_step, spacing, least_ratio: 0.1, scheme: RungeKutta::Classical }
    }

    /// The number of steps, and their length.
    pub(super) fn steps(&self) -> Result<(usize, f64), Error> {
        let span = self.end - self.start;
        let count = (span.abs() / self.time_step).ceil();
        let is_positive = |x: f64| x > 0.0 && x.is_finite();
        if !span.is_finite() || !is_positive(self.time_step) || count > 1e9 {
            return Err(Error::invalid(format!(
                "the time from {} to {} has no steps of {}",
                self.start, self.end, self.time_step
            ))
            .with_cure("give finite times and a positive step"));
        }
        if !is_positive(self.spacing) {
            return Err(Error::invalid(format!("markers cannot have the spacing {}", self.spacing))
                .with_cure("give a positive length"));
        }
        if !(0.0..=1.0 / 3.0).contains(&self.least_ratio) {
            return Err(Error::invalid(format!(
                "the least ratio {} of distances cannot be kept",
                self.least_ratio
            ))
            .with_cure("give a number from 0 to 1/3"));
        }
        Ok((count as usize, if count > 0.0 { span / count } else { 0.0 }))
    }
}

/// What tracking did to markers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct TrackingCounts {
    /// The number of steps of time.
    pub steps: usize,
    /// The markers that were added.
    pub added: usize,
    /// The markers that were left out.
    pub removed: usize,
}
