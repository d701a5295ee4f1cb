//! Areas of faces.

use super::PlanarArrangement;
use coface_algebra::FaceId;
use coface_algebra::Rational;
use coface_geometry::predicates::{PlanarPoint, approximate_area};
use rayon::prelude::*;

impl PlanarArrangement {
    /// The areas of the bounded faces, without their holes, in the square of the unit of the input; all positive unless
    /// they are below the smallest number.
    ///
    /// They are areas between exact positions, not rounded ones, with relative errors below $2^{-49}$: sums in twice
    /// the usual precision, and fractions where their error bounds leave more open.
    ///
    /// # Complexity
    /// Linear in the halfedges, in parallel.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::planar::PlanarArrangement;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(2, vec![0., 0., 0., 1., 1., 0.])?;
    /// let triangle = PlanarArrangement::new(&corners, &[[0, 1], [1, 2], [2, 0]])?;
    /// assert_eq!(triangle.areas(), [0.5]);
    /// # Ok(()) }
    /// ```
    pub fn areas(&self) -> Vec<f64> {
        let area = |face: usize| self.signed_area(Some(FaceId::new(face)));
        (0..self.face_count()).into_par_iter().with_min_len(256).map(area).collect()
    }

    /// The area that all bounded faces cover together: minus the signed area of the walks around the unbounded face.
    ///
    /// # Complexity
    /// Linear in the halfedges around the unbounded face.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::planar::PlanarArrangement;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A triangle within a triangle.
    /// let corners = Positions::from_flat(2, vec![0., 0., 9., 0., 0., 9., 1., 1., 2., 1., 1., 2.])?;
    /// let walks = RaggedArray::from_lists([[0, 1, 2, 0], [3, 4, 5, 3]]);
    /// let nested = PlanarArrangement::from_polylines(&corners, &walks)?;
    /// // The smaller triangle is within the larger one.
    /// assert_eq!(nested.covered_area(), 40.5);
    /// # Ok(()) }
    /// ```
    pub fn covered_area(&self) -> f64 {
        if self.face_count() == 0 { 0.0 } else { -self.signed_area(None) }
    }

    fn signed_area(&self, face: Option<FaceId>) -> f64 {
        walks_area(self.walks(face), |halfedge| self.vertices[self.tail(halfedge) as usize])
            .unwrap_or_else(|| self.exact_area(face).to_f64())
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
    /// use coface_arrange::planar::PlanarArrangement;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = Positions::from_flat(2, vec![0., 0., 1., 0., 0., 3., 2., 0., 0., 1.])?;
    /// // Their hypotenuses cross at (4/5, 3/5).
    /// let arrangement = PlanarArrangement::new(&points, &[[0, 1], [1, 2], [2, 0], [0, 3], [3, 4], [4, 0]])?;
    /// assert_eq!(arrangement.exact_area(None).to_string(), "-9/5");
    /// # Ok(()) }
    /// ```
    pub fn exact_area(&self, face: Option<FaceId>) -> Rational {
        exact_walks_area(self.walks(face), |halfedge| self.vertices[self.tail(halfedge) as usize])
    }

    /// The vertex where a halfedge starts.
    pub(super) fn tail(&self, halfedge: u32) -> u32 {
        self.ends[halfedge as usize / 2][halfedge as usize % 2]
    }
}

/// The part of an area that may be wrong.
const RELATIVE: f64 = 1.0 / (1u64 << 50) as f64;
/// The area within closed walks along corners that `point` knows, positive where they run counterclockwise, with a
/// relative error below $2^{-49}$; `None` if that is not certain.
pub fn walks_area<'a>(
    walks: impl Iterator<Item = &'a [u32]>,
    point: impl Fn(u32) -> PlanarPoint,
) -> Option<f64> {
    let corners = |walk: &'a [u32]| walk.iter().map(|&corner| point(corner));
    let [area, error] = approximate_area(walks.map(corners))?;
    (area.abs() * RELATIVE > error * (1.0 + RELATIVE)).then_some(area)
}

/// The same area as a fraction.
pub(super) fn exact_walks_area<'a>(
    walks: impl Iterator<Item = &'a [u32]>,
    point: impl Fn(u32) -> PlanarPoint,
) -> Rational {
    let mut doubled = Rational::ZERO;
    for walk in walks {
        let mut corners = walk.iter().map(|&corner| point(corner).to_rational());
        let Some(first) = corners.next() else { continue };
        let mut last = [Rational::ZERO, Rational::ZERO];
        for corner in corners {
            let corner = [&corner[0] - &first[0], &corner[1] - &first[1]];
            doubled += &(&(&last[0] * &corner[1]) - &(&last[1] * &corner[0]));
            last = corner;
        }
    }
    &doubled * &Rational::from(2).inverse().expect("2 is not zero")
}
