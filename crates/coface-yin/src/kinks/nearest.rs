//! Knots and kinks by places.

use super::KnotIndex;
use crate::YinSet;
use crate::curve::distance;
use coface_algebra::{Error, VertexId};

impl YinSet {
    /// The knot of the boundary that is nearest to a point, the first of several; none without curves.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if the point is not finite.
    ///
    /// # Complexity
    /// Linear in the knots.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Curve, YinSet};
    /// let square = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?])?;
    /// assert_eq!(square.nearest_knot([1.9, 2.5])?.map(|at| (at.curve, at.knot)), Some((0, 2)));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn nearest_knot(&self, point: [f64; 2]) -> Result<Option<KnotIndex>, Error> {
        let on_curve = |curve: usize| {
            let knots = 0..self.curve(curve).piece_count() as u32;
            knots.map(move |knot| KnotIndex { curve: curve as u32, knot })
        };
        self.nearest_of((0..self.curve_count()).flat_map(on_curve), point)
    }

    /// The kink that is nearest to a point, the first of several; none without kinks.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if the point is not finite.
    ///
    /// # Complexity
    /// Linear in the kinks.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{EndCondition, Order, YinSet};
    /// let ring = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    /// let set = YinSet::fit(&[ring], &[vec![0, 2]], Order::LINEAR, &EndCondition::NotAKnot)?;
    /// let kink = set.nearest_kink([0.9, 0.2])?.expect("there are kinks");
    /// assert_eq!(set.vertex_to_point(kink), Some([1.0, 1.0]));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn nearest_kink(&self, point: [f64; 2]) -> Result<Option<VertexId>, Error> {
        let knots = self.kinks().iter().map(|(at, _)| at);
        Ok(self.nearest_of(knots, point)?.and_then(|at| self.kinks().vertex(at)))
    }

    fn nearest_of(
        &self,
        knots: impl Iterator<Item = KnotIndex>,
        point: [f64; 2],
    ) -> Result<Option<KnotIndex>, Error> {
        if point.iter().any(|x| !x.is_finite()) {
            return Err(Error::invalid("a point is not finite").with_cure("give finite coordinates"));
        }
        let with_distance = |at: KnotIndex| {
            let own = self.curve(at.curve as usize).knot_point(at.knot as usize);
            (distance(own, point), at)
        };
        let nearest = knots.map(with_distance).min_by(|a, b| a.0.total_cmp(&b.0));
        Ok(nearest.map(|(_, at)| at))
    }
}
