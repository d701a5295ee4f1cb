//! What was put together, and how far apart it was.

use super::{CoordinatePrecision, NearCounts};
use coface_algebra::{RaggedArray, VertexId};
use coface_geometry::dot;

/// No number. The arrays that hold it have one entry a point, and an `Option` would double their size.
pub(crate) const NONE: u32 = u32::MAX;
/// After so many rounds features are joined that are twice as far apart as in the round before.
pub(crate) const STEADY_ROUNDS: usize = 4;

/// What was put together to make an arrangement within a tolerance.
///
/// Points are those of the input, or where an arrangement in space was rounded, the drawn vertices of it. In the plane the
/// third coordinate is 0.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct JoinedFeatures {
    /// How often features were put together.
    pub counts: NearCounts,
    /// The longest way that a point went.
    pub largest_movement: f64,
    /// The points that went anywhere, rising, each with where to.
    pub moved: Vec<(VertexId, [f64; 3])>,
    /// The points that became one although they were apart, each class rising.
    pub classes: RaggedArray,
    /// The distance within which features were put together in the end; more than what was asked for where that did
    /// not come to an end.
    pub tolerance: f64,
    /// The number of places where faces were still cut anew when that was given up, since points would have gone too far.
    pub unsettled: usize,
}

impl JoinedFeatures {
    /// Adds what was put together before; points are those of before.
    pub(crate) fn join_before(&mut self, before: &Self) {
        self.counts.add(&before.counts);
        self.largest_movement += before.largest_movement;
        self.moved.clone_from(&before.moved);
        self.classes.clone_from(&before.classes);
        self.tolerance = self.tolerance.max(before.tolerance);
    }

    /// Notes where points went: from the first places to those of points that are given by number.
    pub(crate) fn tell(&mut self, first: &[[f64; 3]], place: &[u32], points: &[[f64; 3]]) {
        let at = |place: u32| points[place as usize];
        let mut order: Vec<u32> =
            (0..first.len() as u32).filter(|&point| place[point as usize] != NONE).collect();
        for &point in &order {
            let (from, to) = (first[point as usize], at(place[point as usize]));
            if from != to {
                let way = [0, 1, 2].map(|axis| to[axis] - from[axis]);
                self.largest_movement = self.largest_movement.max(dot(way, way).sqrt());
                self.moved.push((VertexId::from_u32(point), to));
            }
        }
        order.sort_by_key(|&point| (place[point as usize], point));
        for class in order.chunk_by(|&a, &b| place[a as usize] == place[b as usize]) {
            if class.iter().any(|&point| first[point as usize] != first[class[0] as usize]) {
                self.classes.push(class);
            }
        }
    }
}

/// Features are at least so many units of the last place of the largest coordinate apart.
const UNITS_APART: f64 = 4.0;

/// The least tolerance that means something for points with such coordinates.
pub(crate) fn least_tolerance(points: &[[f64; 3]], precision: CoordinatePrecision) -> f64 {
    let largest = points.as_flattened().iter().fold(f64::MIN_POSITIVE, |most, x| x.abs().max(most));
    UNITS_APART * precision.unit() * largest
}

/// The distance within which features are put together in a round: that of the first ones, and then twice that of the round
/// before.
pub(crate) fn reach(tolerance: f64, round: usize) -> f64 {
    tolerance * 2f64.powi(round.saturating_sub(STEADY_ROUNDS) as i32)
}
