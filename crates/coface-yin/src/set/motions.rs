//! Sets under affine maps.

use super::YinSet;
use crate::{Curve, KnotIndex};
use coface_algebra::{Error, Sign};
use coface_geometry::AffineMap;

impl YinSet {
    /// The image of the set under an affine map of the plane, with its kinks and their names.
    ///
    /// Control points are mapped, so that curves are the images of the curves up to rounding; a map that mirrors turns them around. The
    /// images are checked: where rounding makes curves that touch cross, that is an error.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for a map that is not of the plane or not invertible, for images
    /// that are not finite, and where curves come to cross, with the place.
    ///
    /// # Complexity
    /// That of an overlay of all curves.
    ///
    /// # Examples
    /// A square mirrored and stretched.
    /// ```
    /// use coface_geometry::AffineMap;
    /// use coface_yin::{Curve, YinSet};
    /// let square = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?])?;
    /// let moved = square.transformed(&AffineMap::scaling(&[-3.0, 1.0])?)?;
    /// assert_eq!((moved.area(), moved.bounding_box()), (Some(12.0), Some([[-6.0, 0.0], [0.0, 2.0]])));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn transformed(&self, map: &AffineMap) -> Result<Self, Error> {
        if map.dimension() != 2 {
            return Err(Error::invalid(format!("the map is of dimension {}", map.dimension()))
                .with_cure("give a map of the plane: a matrix of two rows and two columns"));
        }
        let Some(sign) = map.determinant_sign() else {
            return Err(Error::invalid("the map takes the plane to a line or a point")
                .with_cure("give a matrix whose determinant is not zero"));
        };
        if self.curve_count() == 0 {
            return Ok(self.clone());
        }
        let is_mirror = sign == Sign::Minus;
        let mut curves: Vec<Curve<'static>> = Vec::with_capacity(self.curve_count());
        for number in 0..self.curve_count() {
            let image = self.curve(number).mapped(map);
            if image.controls().iter().flatten().any(|x| !x.is_finite()) {
                return Err(Error::invalid(format!("the image of curve {number} is not finite"))
                    .with_cure("give a map with smaller numbers"));
            }
            curves.push(if is_mirror { image.reversed() } else { image });
        }
        let set = Self::new(&curves)?;
        let mut kinks: Vec<(KnotIndex, u32)> = self
            .kinks()
            .iter()
            .map(|(at, vertex)| {
                let count = curves[at.curve as usize].piece_count() as u32;
                let knot = if is_mirror { (count - at.knot) % count } else { at.knot };
                (KnotIndex { curve: at.curve, knot }, vertex.to_u32())
            })
            .collect();
        kinks.sort_unstable();
        let (knots, names): (Vec<KnotIndex>, Vec<u32>) = kinks.into_iter().unzip();
        set.with_declared_kinks(&knots, Some(&names), Some(self.kinks().next_name()))
    }
}
