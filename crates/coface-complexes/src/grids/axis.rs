//! One axis of a grid: an interval cut by lines, with full and empty intervals between them.

use coface_algebra::{Error, ErrorKind};

/// An axis. Its **points** are the lines at an end of a full interval (all lines where there is no interval); points and
/// full intervals are numbered without gaps.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Axis {
    /// So many full intervals of length 1.
    Unit(u32),
    /// Intervals of any length.
    Listed(Listed),
}

#[derive(Clone, Debug, PartialEq)]
pub(super) struct Listed {
    /// Where the lines are.
    coordinates: Vec<f64>,
    /// The lines that are points, rising.
    points: Vec<u32>,
    /// For each full interval, the point at its lower end, rising; the next point is the upper end.
    intervals: Vec<u32>,
}

impl Axis {
    /// The axis with intervals of these lengths from 0 on; a negative length makes an empty interval.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] for a length that is zero or not finite, or so small that its lines coincide.
    pub(super) fn from_lengths(axis: usize, lengths: &[f64]) -> Result<Self, Error> {
        let mut coordinates = Vec::with_capacity(lengths.len() + 1);
        let (mut points, mut intervals) = (Vec::new(), Vec::new());
        let mut end = 0.0;
        coordinates.push(end);
        if lengths.is_empty() {
            points.push(0);
        }
        for (i, &length) in lengths.iter().enumerate() {
            let start = end;
            end += length.abs();
            if !end.is_finite() || end <= start {
                return Err(Error::invalid(format!(
                    "length {i} of axis {axis} is {length}, which does not lead from {start} to a greater finite number"
                ))
                .with_cure("give a positive length for a full interval, a negative one for an empty interval"));
            }
            coordinates.push(end);
            if length > 0.0 {
                let line = fits(i, axis)?;
                if points.last() != Some(&line) {
                    points.push(line);
                }
                intervals.push(points.len() as u32 - 1);
                points.push(fits(i + 1, axis)?);
            }
        }
        Ok(Self::Listed(Listed { coordinates, points, intervals }))
    }

    /// The number of points.
    pub(super) fn point_count(&self) -> u64 {
        match self {
            Self::Unit(count) => u64::from(*count) + 1,
            Self::Listed(listed) => listed.points.len() as u64,
        }
    }

    /// The number of full intervals.
    pub(super) fn interval_count(&self) -> u64 {
        match self {
            Self::Unit(count) => u64::from(*count),
            Self::Listed(listed) => listed.intervals.len() as u64,
        }
    }

    /// The points at the lower ends of the full intervals; `None` if interval i starts at point i.
    pub(super) fn lower_points(&self) -> Option<&[u32]> {
        match self {
            Self::Unit(_) => None,
            Self::Listed(listed) => Some(&listed.intervals),
        }
    }

    /// The point at the lower end of a full interval.
    pub(super) fn lower_point(&self, interval: u32) -> u32 {
        self.lower_points().map_or(interval, |points| points[interval as usize])
    }

    /// The full interval that ends at a point.
    pub(super) fn interval_below(&self, point: u32) -> Option<u32> {
        self.interval_above(point.checked_sub(1)?)
    }

    /// The full interval that starts at a point.
    pub(super) fn interval_above(&self, point: u32) -> Option<u32> {
        match self {
            Self::Unit(count) => (point < *count).then_some(point),
            Self::Listed(listed) => listed.intervals.binary_search(&point).ok().map(|i| i as u32),
        }
    }

    /// The line of a point.
    pub(super) fn line(&self, point: u32) -> u32 {
        match self {
            Self::Unit(_) => point,
            Self::Listed(listed) => listed.points[point as usize],
        }
    }

    /// The point on a line.
    pub(super) fn point_on(&self, line: u32) -> Option<u32> {
        match self {
            Self::Unit(count) => (line <= *count).then_some(line),
            Self::Listed(listed) => listed.points.binary_search(&line).ok().map(|i| i as u32),
        }
    }

    /// Where a point is.
    pub(super) fn coordinate(&self, point: u32) -> f64 {
        match self {
            Self::Unit(_) => f64::from(point),
            Self::Listed(listed) => listed.coordinates[listed.points[point as usize] as usize],
        }
    }
}

fn fits(line: usize, axis: usize) -> Result<u32, Error> {
    u32::try_from(line)
        .map_err(|_| Error::new(ErrorKind::TooLarge, format!("axis {axis} has more than 2^32 - 1 lines")))
}
