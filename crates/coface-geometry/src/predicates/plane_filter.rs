//! Quick decisions on which side of one plane many points lie.

use super::SpatialPlane;
use super::arithmetic::normal;
use super::estimate::Estimate;
use std::cmp::Ordering;

/// A plane with precomputed bounds, which decide for nearly all points at once on which side of it they lie.
///
/// # Examples
/// ```
/// use coface_geometry::predicates::{PlaneFilter, spatial_orientation};
/// use std::cmp::Ordering;
/// let plane = [[0.1, 0., 0.], [0., 0.1, 0.], [0., 0., 0.1]];
/// let filter = PlaneFilter::new(plane);
/// assert_eq!(filter.side_of([1., 1., 1.]), Some(Ordering::Greater));
/// assert_eq!(filter.side_of([0., 0., 0.]), Some(Ordering::Less));
/// // Too close to tell.
/// assert_eq!(filter.side_of(plane[0]), None);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct PlaneFilter {
    point: [f64; 3],
    normal: [f64; 3],
    /// What a difference of coordinates is multiplied with to bound the error.
    error: [f64; 3],
}

impl PlaneFilter {
    /// The filter of a plane. The filter of three points on one line decides no point.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::predicates::PlaneFilter;
    /// let ground = PlaneFilter::new([[0., 0., 0.], [1., 0., 0.], [0., 1., 0.]]);
    /// assert!(ground.side_of([5., 5., 1.]).is_some());
    /// ```
    pub fn new(plane: SpatialPlane) -> Self {
        let normal = normal::<Estimate>(plane);
        Self {
            point: plane[0],
            normal: normal.map(Estimate::value),
            // A product and the sum lose four unit roundoffs.
            error: normal.map(|x| x.bound() + 8.0 * f64::EPSILON / 2.0 * x.value().abs()),
        }
    }

    /// The plane's [`side_of`](super::SpatialPoint::side_of) for a point with these coordinates, if a bound on the
    /// error leaves no doubt.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::predicates::PlaneFilter;
    /// use std::cmp::Ordering;
    /// let ground = PlaneFilter::new([[0., 0., 0.], [1., 0., 0.], [0., 1., 0.]]);
    /// assert_eq!(ground.side_of([5., 5., -1.]), Some(Ordering::Less));
    /// ```
    #[inline]
    pub fn side_of(&self, point: [f64; 3]) -> Option<Ordering> {
        let to = [0, 1, 2].map(|axis| point[axis] - self.point[axis]);
        let value = self.normal[0] * to[0] + self.normal[1] * to[1] + self.normal[2] * to[2];
        let bound = self.error[0] * to[0].abs() + self.error[1] * to[1].abs() + self.error[2] * to[2].abs();
        // The last number is for products that are too small for their precision. Also false for what is not a number.
        let certain = value.abs() > bound + f64::MIN_POSITIVE && value.abs() <= f64::MAX;
        certain.then(|| value.total_cmp(&0.0))
    }
}

#[cfg(test)]
mod tests {
    use super::super::samples::coordinate;
    use super::super::spatial_orientation;
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]
        #[test]
        fn what_is_certain_is_right(flat in prop::array::uniform12(coordinate())) {
            let [a, b, c, d] = [0, 3, 6, 9].map(|i| [flat[i], flat[i + 1], flat[i + 2]]);
            let found = PlaneFilter::new([a, b, c]).side_of(d);
            prop_assert!(found.is_none_or(|side| side == spatial_orientation(a, b, c, d)));
        }

        #[test]
        fn points_off_the_plane_are_told(flat in prop::array::uniform12(-1000i32..1000)) {
            let [a, b, c, d] = [0, 3, 6, 9].map(|i| [0, 1, 2].map(|j| f64::from(flat[i + j])));
            let side = spatial_orientation(a, b, c, d);
            prop_assert_eq!(PlaneFilter::new([a, b, c]).side_of(d), Some(side).filter(|side| side.is_ne()));
        }
    }
}
