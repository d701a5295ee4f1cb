//! The exact decisions about points in space that cells are made by.

use coface_algebra::{Error, ErrorKind, VertexId};
use coface_geometry::Positions;
use coface_geometry::predicates::{orientation, spatial_orientation};
use std::cmp::Ordering;

/// Exact decisions about vertices in space, by their numbers.
///
/// Whatever the points are - given by coordinates, or crossings that are never computed - cells need no more than
/// these. A sign is an [`Ordering`] with zero.
pub trait SpatialPredicates: Sync {
    /// How coordinate `axis` of `a` compares with that of `b`.
    fn compare(&self, axis: usize, a: u32, b: u32) -> Ordering;

    /// The sign of coordinate `axis` of $(b - a) \times (c - a)$: which way the triangle runs seen from the far end of
    /// that axis, `Greater` for counterclockwise.
    fn normal_sign(&self, axis: usize, triangle: [u32; 3]) -> Ordering;

    /// The sign of the determinant of $b - a$, $c - a$, $d - a$: `Greater` when the triangle $a b c$ runs
    /// counterclockwise seen from `d`, `Equal` when the four points are in one plane.
    fn orientation(&self, points: [u32; 4]) -> Ordering;

    /// Numbers between which coordinate `axis` of the vertex lies.
    fn range(&self, axis: usize, vertex: u32) -> [f64; 2];

    /// Three vertices of the plane of a face, on it or not, which run counterclockwise seen from its front, where they
    /// are known; all of the face is in that plane.
    fn corners_of_plane(&self, _face: u32) -> Option<[u32; 3]> {
        None
    }

    /// Whether [`Self::corners_of_plane`] are known for all faces.
    fn knows_planes(&self) -> bool {
        false
    }

    /// An axis that is not in the plane of a face with [`Self::corners_of_plane`], and the sign of the normal along it,
    /// `Greater` where the front is towards the far end of the axis.
    fn axis_of_plane(&self, face: u32) -> Option<(usize, Ordering)> {
        let corners = self.corners_of_plane(face)?;
        (0..3).map(|axis| (axis, self.normal_sign(axis, corners))).find(|(_, front)| front.is_ne())
    }

    /// Two vertices of the line of an edge, on it or not, in its direction, where they are known. Then the faces around
    /// the edge are known to leave it in different directions.
    fn points_of_line(&self, _edge: u32) -> Option<[u32; 2]> {
        None
    }

    /// Sorts the packed sides of faces at an edge counterclockwise seen from its second end, from the first of them on,
    /// if their order is known without decisions; whether it is.
    fn sort_around(&self, _edge: u32, _sides: &mut [u32]) -> bool {
        false
    }
}

/// Points that are given by three coordinates, taken at their exact values.
///
/// Signs come from floating point where a bound on the error allows it, else from expansions, and from integers of any
/// size for numbers so large or small that products leave the range.
///
/// # References
/// J. R. Shewchuk, *Adaptive precision floating-point arithmetic and fast robust geometric predicates* (1997).
///
/// # Examples
/// ```
/// use coface_arrange::spatial::{GivenPoints, SpatialPredicates};
/// use coface_geometry::Positions;
/// use std::cmp::Ordering;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let flat = vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1e-300];
/// let positions = Positions::from_flat(3, flat)?;
/// let points = GivenPoints::new(&positions)?;
/// assert_eq!(points.orientation([0, 1, 2, 3]), Ordering::Greater);
/// # Ok(()) }
/// ```
#[derive(Clone, Copy, Debug)]
pub struct GivenPoints<'a>(&'a Positions);

impl<'a> GivenPoints<'a> {
    /// The points at these positions.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless the positions have three coordinates.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::spatial::GivenPoints;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert!(GivenPoints::new(&Positions::from_flat(3, vec![0., 0., 0.])?).is_ok());
    /// assert!(GivenPoints::new(&Positions::from_flat(2, vec![0., 0.])?).is_err());
    /// # Ok(()) }
    /// ```
    pub fn new(positions: &'a Positions) -> Result<Self, Error> {
        if positions.dimension() != 3 {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("points with {} coordinates are not points in space", positions.dimension()),
            )
            .with_cure("give three coordinates a point"));
        }
        Ok(Self(positions))
    }

    pub(super) fn point(&self, vertex: u32) -> [f64; 3] {
        let point = self.0.point(VertexId::from_u32(vertex));
        [point[0], point[1], point[2]]
    }
}

impl SpatialPredicates for GivenPoints<'_> {
    fn compare(&self, axis: usize, a: u32, b: u32) -> Ordering {
        let [a, b] = [a, b].map(|vertex| self.point(vertex)[axis]);
        a.partial_cmp(&b).expect("coordinates are numbers")
    }

    fn normal_sign(&self, axis: usize, triangle: [u32; 3]) -> Ordering {
        let [a, b, c] = triangle.map(|vertex| {
            let point = self.point(vertex);
            [point[(axis + 1) % 3], point[(axis + 2) % 3]]
        });
        orientation(a, b, c)
    }

    fn orientation(&self, points: [u32; 4]) -> Ordering {
        let [a, b, c, d] = points.map(|vertex| self.point(vertex));
        spatial_orientation(a, b, c, d)
    }

    fn range(&self, axis: usize, vertex: u32) -> [f64; 2] {
        [self.point(vertex)[axis]; 2]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashu_int::IBig;
    use proptest::prelude::*;

    /// Small integers, close numbers, and powers of two that leave the range when multiplied.
    fn coordinate() -> impl Strategy<Value = f64> {
        prop_oneof![
            (-4i32..5).prop_map(f64::from),
            (-3i32..4).prop_map(|k| 1.0 + f64::from(k) * f64::EPSILON),
            (-3i32..4, prop::sample::select(vec![-1074, -1000, -400, -160, 400, 1000])).prop_map(
                |(k, exponent)| f64::from(k) * 2f64.powi(exponent / 2) * 2f64.powi(exponent - exponent / 2)
            ),
        ]
    }

    /// The exact value in units of the smallest number.
    fn integer(x: f64) -> IBig {
        let bits = x.to_bits();
        let (biased, fraction) = ((bits >> 52 & 0x7ff) as usize, (bits & ((1 << 52) - 1)) as i64);
        let value =
            if biased == 0 { IBig::from(fraction) } else { IBig::from(fraction | 1 << 52) << (biased - 1) };
        if x < 0.0 { -value } else { value }
    }

    proptest! {
        #[test]
        fn signs_are_those_of_integers(flat in prop::collection::vec(coordinate(), 12)) {
            let positions = Positions::from_flat(3, flat.clone()).unwrap();
            let points = GivenPoints::new(&positions).unwrap();
            let corners = [0, 3, 6, 9].map(|i| [flat[i], flat[i + 1], flat[i + 2]]);
            let p = corners.map(|point| point.map(integer));
            let edge = |i: usize, axis: usize| &p[i][axis] - &p[0][axis];
            for axis in 0..3 {
                let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
                let normal = edge(1, j) * edge(2, k) - edge(1, k) * edge(2, j);
                prop_assert_eq!(points.normal_sign(axis, [0, 1, 2]), normal.cmp(&IBig::ZERO));
                prop_assert_eq!(points.compare(axis, 1, 0), edge(1, axis).cmp(&IBig::ZERO));
            }
            // Along the first row.
            let determinant: IBig = (0..3).map(|i| {
                let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                edge(1, i) * (edge(2, j) * edge(3, k) - edge(2, k) * edge(3, j))
            }).fold(IBig::ZERO, |sum, term| sum + term);
            let found = points.orientation([0, 1, 2, 3]);
            prop_assert_eq!(found, determinant.cmp(&IBig::ZERO));
            prop_assert_eq!(points.orientation([1, 0, 2, 3]), found.reverse());
            prop_assert_eq!(points.orientation([3, 2, 1, 0]), found);
        }
    }

    #[test]
    fn planes_are_not_space() {
        let plane = Positions::from_flat(2, vec![0.0, 1.0]).unwrap();
        assert_eq!(GivenPoints::new(&plane).unwrap_err().kind(), ErrorKind::Shape);
    }
}
