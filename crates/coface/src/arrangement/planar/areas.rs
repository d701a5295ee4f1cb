//! Areas of faces.

use super::PlanarArrangement;
use crate::algebra::Rational;
use crate::geometry::Sum;
use crate::geometry::predicates::two_product;
use crate::{FaceId, VertexId};
use rayon::prelude::*;

impl PlanarArrangement {
    /// The areas of the bounded faces, holes taken away, in the square of the unit of the input; all positive unless they
    /// are below the smallest number.
    ///
    /// An area is summed with compensation from rounded coordinates; where their rounding could change it by more than
    /// a 2^-40th part, it is summed with fractions from exact ones and rounded once.
    ///
    /// # Complexity
    /// Linear in the halfedges, in parallel.
    pub fn areas(&self) -> Vec<f64> {
        let face = |face: usize| {
            let face = FaceId::new(face);
            let (area, error) = self.rounded_area(Some(face));
            // Also for what is not a number.
            if area.abs() * RELATIVE > error { area } else { self.exact_area(Some(face)).to_f64() }
        };
        (0..self.face_count()).into_par_iter().with_min_len(256).map(face).collect()
    }

    /// The area that all bounded faces cover together: minus the signed area of the walks around the unbounded face.
    ///
    /// # Complexity
    /// Linear in the halfedges around the unbounded face.
    pub fn covered_area(&self) -> f64 {
        let (area, error) = self.rounded_area(None);
        if area.abs() * RELATIVE > error || error == 0.0 { -area } else { -self.exact_area(None).to_f64() }
    }

    /// The exact area of a face as a fraction; of the unbounded face (`None`) minus the area of all others.
    ///
    /// # Panics
    /// If there is no such face.
    ///
    /// # Complexity
    /// Linear in the halfedges around the face in operations on fractions, whose size grows with their number.
    ///
    /// # Examples
    /// Two right triangles at the origin: 3/2 + 1 less the 7/10 that they share.
    /// ```
    /// use coface::arrangement::planar::PlanarArrangement;
    /// use coface::geometry::Positions;
    /// # fn main() -> Result<(), coface::Error> {
    /// let points = Positions::from_flat(2, vec![0., 0., 1., 0., 0., 3., 2., 0., 0., 1.])?;
    /// // Their hypotenuses cross at (4/5, 3/5).
    /// let arrangement = PlanarArrangement::new(&points, &[[0, 1], [1, 2], [2, 0], [0, 3], [3, 4], [4, 0]])?;
    /// assert_eq!(arrangement.exact_area(None).to_string(), "-9/5");
    /// # Ok(()) }
    /// ```
    pub fn exact_area(&self, face: Option<FaceId>) -> Rational {
        let mut doubled = Rational::ZERO;
        for walk in self.walks(face) {
            let mut corners = walk.iter().map(|&h| self.vertices[self.tail(h) as usize].to_rational());
            let Some(first) = corners.next() else { continue };
            let minus = |p: &[Rational; 2]| [&p[0] - &first[0], &p[1] - &first[1]];
            let mut last = [Rational::ZERO, Rational::ZERO];
            for corner in corners {
                let corner = minus(&corner);
                doubled += &(&(&last[0] * &corner[1]) - &(&last[1] * &corner[0]));
                last = corner;
            }
        }
        &doubled * &Rational::from(2).inverse().expect("2 is not zero")
    }

    /// The signed area within the walks around a face from rounded coordinates, and what their rounding can change.
    fn rounded_area(&self, face: Option<FaceId>) -> (f64, f64) {
        let mut doubled = Sum::default();
        let mut error = 0.0;
        for walk in self.walks(face) {
            let point = |h: u32| {
                let point = self.positions.point(VertexId::from_u32(self.tail(h)));
                [point[0], point[1]]
            };
            let origin = point(walk[0]);
            let mut last = [0.0; 2];
            for (i, &halfedge) in walk.iter().enumerate().skip(1) {
                let at = point(halfedge);
                let corner = [at[0] - origin[0], at[1] - origin[1]];
                if i > 1 {
                    let ([left, left_low], [right, right_low]) =
                        (two_product(last[0], corner[1]), two_product(last[1], corner[0]));
                    [left, -right, left_low, -right_low].into_iter().for_each(|term| doubled.add(term));
                }
                // Each coordinate is off by half a unit, as is each difference; the other factor is no longer than these.
                let largest = at[0].abs().max(at[1].abs()).max(origin[0].abs()).max(origin[1].abs());
                let reach = corner[0].abs().max(corner[1].abs()) + last[0].abs().max(last[1].abs());
                error += 4.0 * f64::EPSILON * largest * reach;
                last = corner;
            }
        }
        (doubled.value() * 0.5, error)
    }

    /// The vertex where a halfedge starts.
    pub(super) fn tail(&self, halfedge: u32) -> u32 {
        self.ends[halfedge as usize / 2][halfedge as usize % 2]
    }
}

/// What rounding may change of an area.
const RELATIVE: f64 = 1.0 / (1u64 << 40) as f64;
