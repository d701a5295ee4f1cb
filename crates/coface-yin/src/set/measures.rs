//! Area and perimeter.

use super::YinSet;
use crate::Order;
use coface_algebra::Rational;
use coface_arrange::planar::walks_area;
use coface_geometry::Sum;
use coface_geometry::predicates::PlanarPoint;

impl YinSet {
    /// The area, in the square of the unit of the coordinates; none if the set is unbounded.
    ///
    /// Of sets of order 2 the relative error is below $2^{-49}$.
    ///
    /// # Complexity
    /// Linear in the pieces.
    ///
    /// # Examples
    /// A square of side 4 with a square hole of side 1.
    /// ```
    /// use coface_yin::{Curve, YinSet};
    /// let outer = Curve::polyline(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [0.0, 0.0]])?;
    /// let hole = Curve::polyline(&[[1.0, 1.0], [1.0, 2.0], [2.0, 2.0], [2.0, 1.0], [1.0, 1.0]])?;
    /// let ring = YinSet::new(&[outer, hole])?;
    /// assert_eq!(ring.area(), Some(15.0));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn area(&self) -> Option<f64> {
        self.is_bounded().then(|| self.signed_area())
    }

    /// The sum of the areas within the curves, negative for negative ones: the area of a bounded set, minus the area of the complement
    /// of an unbounded one.
    ///
    /// # Complexity
    /// Linear in the pieces.
    ///
    /// # Examples
    /// A square of side 4 with a square hole of side 1.
    /// ```
    /// use coface_yin::{Curve, YinSet};
    /// let outer = Curve::polyline(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [0.0, 0.0]])?;
    /// let hole = Curve::polyline(&[[1.0, 1.0], [1.0, 2.0], [2.0, 2.0], [2.0, 1.0], [1.0, 1.0]])?;
    /// let ring = YinSet::new(&[outer, hole])?;
    /// assert_eq!(ring.signed_area(), 15.0);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn signed_area(&self) -> f64 {
        if self.curve_count() == 0 {
            return 0.0;
        }
        if self.order() == Order::LINEAR {
            // The first point of each curve comes again at its end, which is a triangle of no area.
            let controls = self.arena().controls();
            let places: Vec<u32> = (0..controls.len() as u32).collect();
            let mut walks = Vec::with_capacity(self.curve_count());
            let mut first = 0;
            for curve in 0..self.curve_count() {
                let count = self.curve(curve).piece_count();
                walks.push(&places[first..first + count]);
                first += count + 1;
            }
            let area = walks_area(walks.into_iter(), |at| PlanarPoint::given(controls[at as usize]));
            if let Some(area) = area.or_else(|| Some(self.exact_area()?.to_f64())) {
                return area;
            }
        }
        let mut sum = Sum::default();
        self.arena().iter().for_each(|curve| sum.add(curve.signed_area()));
        sum.value()
    }

    /// The sum of the areas within the curves as a fraction, as [`Self::signed_area`]; none for sets of order 4 and more.
    ///
    /// # Complexity
    /// Linear in the pieces in operations on fractions, whose size grows with the range of the coordinates.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::boolean::InsideRule;
    /// use coface_yin::YinSet;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = YinSet::from_rings(&[[[0., 0.], [1., 0.], [0., 3.]]], InsideRule::Nonzero)?;
    /// assert_eq!(triangle.exact_area().map(|area| area.to_string()).as_deref(), Some("3/2"));
    /// # Ok(()) }
    /// ```
    pub fn exact_area(&self) -> Option<Rational> {
        if self.order() != Order::LINEAR {
            return None;
        }
        let mut doubled = Rational::ZERO;
        for curve in self.arena().iter() {
            let mut corners = curve.controls().iter().map(|&point| PlanarPoint::given(point).to_rational());
            let first = corners.next()?;
            let mut last = [Rational::ZERO, Rational::ZERO];
            for corner in corners {
                let corner = [&corner[0] - &first[0], &corner[1] - &first[1]];
                doubled += &(&(&last[0] * &corner[1]) - &(&last[1] * &corner[0]));
                last = corner;
            }
        }
        Some(&doubled * &Rational::from(2).inverse().expect("2 is not zero"))
    }

    /// The length of the boundary, in the unit of the coordinates. Of polylines it is the sum of the lengths of their pieces; that of
    /// other curves is off by at most `tolerance` (an absolute length) in all, as far as the rounding of numbers allows.
    ///
    /// # Complexity
    /// Linear in the pieces, and in the quadrature of those that are not straight.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::boolean::InsideRule;
    /// use coface_yin::YinSet;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = YinSet::from_rings(&[[[0., 0.], [4., 0.], [0., 3.]]], InsideRule::Nonzero)?;
    /// assert_eq!(triangle.perimeter(0.0), 12.0);
    /// # Ok(()) }
    /// ```
    pub fn perimeter(&self, tolerance: f64) -> f64 {
        let share = tolerance / self.curve_count().max(1) as f64;
        let mut sum = Sum::default();
        self.arena().iter().for_each(|curve| sum.add(curve.length(share)));
        sum.value()
    }

    /// The lowest and the highest coordinates of the boundary; none without curves. The boxes of curves that are not straight hold
    /// them up to rounding.
    ///
    /// # Examples
    /// A square of side 4 with a square hole of side 1.
    /// ```
    /// use coface_yin::{Curve, YinSet};
    /// let outer = Curve::polyline(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [0.0, 0.0]])?;
    /// let hole = Curve::polyline(&[[1.0, 1.0], [1.0, 2.0], [2.0, 2.0], [2.0, 1.0], [1.0, 1.0]])?;
    /// let ring = YinSet::new(&[outer, hole])?;
    /// assert_eq!(ring.bounding_box(), Some([[0.0, 0.0], [4.0, 4.0]]));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn bounding_box(&self) -> Option<[[f64; 2]; 2]> {
        self.arena()
            .iter()
            .map(|curve| curve.bounding_box())
            .reduce(|[a, b], [c, d]| [[a[0].min(c[0]), a[1].min(c[1])], [b[0].max(d[0]), b[1].max(d[1])]])
    }
}
