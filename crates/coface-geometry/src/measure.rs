//! Measures: areas of polygons in any dimension, volumes that surfaces enclose.
//!
//! Coordinates are scaled by a power of two and differences are taken before products, so coordinates near the largest
//! and smallest numbers lose nothing; sums are compensated. Results are rounded, and no topological answer depends on
//! them.

use super::Positions;
use coface_algebra::RaggedArray;
use coface_algebra::VertexId;
use coface_algebra::progress::stage_of_many;
use rayon::prelude::*;

/// A sum of many numbers whose rounding errors are carried along.
///
/// # References
/// A. Neumaier, *Rundungsfehleranalyse einiger Verfahren zur Summation endlicher Summen* (1974).
#[derive(Clone, Copy, Debug, Default)]
pub struct Sum {
    rounded: f64,
    lost: f64,
}

impl Sum {
    #[doc(hidden)]
    pub fn add(&mut self, term: f64) {
        let sum = self.rounded + term;
        self.lost += if self.rounded.abs() >= term.abs() {
            (self.rounded - sum) + term
        } else {
            (term - sum) + self.rounded
        };
        self.rounded = sum;
    }

    #[doc(hidden)]
    pub fn value(self) -> f64 {
        self.rounded + self.lost
    }

    /// The sum of `term(i)` for `i` below `count`, in blocks that do not depend on the number of threads.
    #[doc(hidden)]
    pub fn of(count: usize, term: impl Fn(usize) -> f64 + Sync) -> f64 {
        Self::of_each(count, |i| [term(i)])[0]
    }

    /// The sums of the numbers that `terms(i)` gives for `i` below `count`, each as [`Self::of`] takes it.
    pub(crate) fn of_each<const N: usize>(
        count: usize,
        terms: impl Fn(usize) -> [f64; N] + Sync,
    ) -> [f64; N] {
        const BLOCK: usize = 1 << 12;
        let steps = stage_of_many("measuring", count);
        let blocks: Vec<[Self; N]> = (0..count.div_ceil(BLOCK))
            .into_par_iter()
            .map(|block| {
                steps.advance(BLOCK.min(count - block * BLOCK));
                let mut sums = [Self::default(); N];
                for i in block * BLOCK..((block + 1) * BLOCK).min(count) {
                    sums.iter_mut().zip(terms(i)).for_each(|(sum, term)| sum.add(term));
                }
                sums
            })
            .collect();
        let mut totals = [Self::default(); N];
        for block in blocks {
            for (total, sum) in totals.iter_mut().zip(block) {
                total.add(sum.rounded);
                total.add(sum.lost);
            }
        }
        totals.map(Self::value)
    }
}

/// Positions scaled by a power of two into the cube from -1 to 1.
#[derive(Clone, Copy, Debug)]
pub struct Scaled<'a> {
    positions: &'a Positions,
    /// The power of two that coordinates are multiplied by.
    factor: f64,
}

impl<'a> Scaled<'a> {
    #[doc(hidden)]
    #[allow(clippy::cast_possible_truncation, reason = "the exponent is clamped to 1000")]
    pub fn new(positions: &'a Positions) -> Self {
        let largest = positions.as_flat().par_iter().copied().map(f64::abs).reduce(|| 0.0, f64::max);
        // Infinite for zero; clamped, so that the factor and its inverse are ordinary numbers.
        let exponent = largest.log2().ceil().clamp(-1000.0, 1000.0) as i32;
        Self { positions, factor: if largest == 0.0 { 1.0 } else { 2f64.powi(-exponent) } }
    }

    /// A length, area or volume (power 1, 2, 3) of scaled positions in the unit of the positions.
    #[doc(hidden)]
    pub fn unscaled(&self, measure: f64, power: usize) -> f64 {
        (0..power).fold(measure, |value, _| value / self.factor)
    }

    fn coordinate(&self, vertex: u32, axis: usize) -> f64 {
        self.positions.point(VertexId::from_u32(vertex))[axis] * self.factor
    }

    /// The first three coordinates of a vertex minus those of an origin.
    #[doc(hidden)]
    pub fn relative(&self, vertex: u32, origin: [f64; 3]) -> [f64; 3] {
        let point = self.positions.point(VertexId::from_u32(vertex));
        [0, 1, 2].map(|axis| point[axis] * self.factor - origin[axis])
    }

    /// Half the length of the sum of $(p_i - p_0) \wedge (p_{i+1} - p_0)$.
    fn polygon_area(&self, polygon: &[u32]) -> f64 {
        let Some((&first, rest)) = polygon.split_first() else { return 0.0 };
        let dimension = self.positions.dimension();
        if dimension == 3 {
            let origin = [0, 1, 2].map(|axis| self.coordinate(first, axis));
            let mut sum = [0.0; 3];
            for pair in rest.windows(2) {
                let product = cross(self.relative(pair[0], origin), self.relative(pair[1], origin));
                (0..3).for_each(|axis| sum[axis] += product[axis]);
            }
            return dot(sum, sum).sqrt() / 2.0;
        }
        let mut square = 0.0;
        for i in 0..dimension {
            for j in 0..i {
                let (x, y) = (self.coordinate(first, i), self.coordinate(first, j));
                let mut component = 0.0;
                for pair in rest.windows(2) {
                    let [a, b] =
                        [0, 1].map(|k| (self.coordinate(pair[k], i) - x, self.coordinate(pair[k], j) - y));
                    component += a.0 * b.1 - a.1 * b.0;
                }
                square += component * component;
            }
        }
        square.sqrt() / 2.0
    }

    /// Six times the signed volume of the cone over a polygon with the origin as apex: positive when the polygon runs
    /// counterclockwise seen from the side away from the apex. A polygon of four or more vertices is a fan around the
    /// mean of its vertices, so that the same polygon has the same cone whatever vertex it starts at.
    #[doc(hidden)]
    pub fn cone(&self, polygon: impl ExactSizeIterator<Item = u32> + Clone, origin: [f64; 3]) -> f64 {
        let point = |vertex| self.relative(vertex, origin);
        let count = polygon.len();
        let mut vertices = polygon.clone();
        let (Some(a), Some(b), Some(c)) = (vertices.next(), vertices.next(), vertices.next()) else {
            return 0.0;
        };
        if count == 3 {
            return determinant(point(a), point(b), point(c));
        }
        let mut mean = [0.0; 3];
        for p in polygon.clone().map(point) {
            (0..3).for_each(|axis| mean[axis] += p[axis] / count as f64);
        }
        let next = polygon.clone().skip(1).chain([a]);
        polygon.zip(next).map(|(from, to)| determinant(mean, point(from), point(to))).sum()
    }

    /// The scaled coordinates of a vertex, as an origin.
    #[doc(hidden)]
    pub fn origin_at(&self, vertex: u32) -> [f64; 3] {
        self.relative(vertex, [0.0; 3])
    }
}

/// The cross product of two vectors.
///
/// # Examples
/// ```
/// use coface_geometry::cross;
/// assert_eq!(cross([1., 0., 0.], [0., 1., 0.]), [0., 0., 1.]);
/// ```
pub fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The inner product of two vectors.
///
/// # Examples
/// ```
/// assert_eq!(coface_geometry::dot([1., 2., 3.], [4., 5., 6.]), 32.0);
/// ```
pub fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The determinant of three vectors: the signed volume of the parallelepiped that they span, rounded.
///
/// # Examples
/// ```
/// use coface_geometry::determinant;
/// assert_eq!(determinant([2., 0., 0.], [0., 3., 0.], [0., 0., 4.]), 24.0);
/// ```
pub fn determinant(a: [f64; 3], b: [f64; 3], c: [f64; 3]) -> f64 {
    dot(a, cross(b, c))
}

/// The area of all polygons together, in the square of the unit of the positions; `None` without positions.
///
/// The area of one polygon is half the length of its area vector $\sum (p_i - p_0) \wedge (p_{i+1} - p_0)$, in any
/// dimension: half the square root of the Gram determinant for a triangle, the shoelace sum in the plane, M. E.
/// Newell's sum in space. It is the area of a flat polygon, convex or not, and the largest area of a shadow of one that
/// is not flat. The result is infinite when it exceeds the largest number.
///
/// # Panics
/// If a polygon names a vertex without position.
///
/// # Complexity
/// Linear; parallel, with the same rounding whatever the number of threads.
///
/// # Examples
/// A unit square in a space of four dimensions, standing on its third and fourth axis:
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_geometry::{Positions, polygon_area};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let corners = vec![5., 7., 0., 0., 5., 7., 1., 0., 5., 7., 1., 1., 5., 7., 0., 1.];
/// let positions = Positions::from_flat(4, corners)?;
/// let square = RaggedArray::from_lists([[0, 1, 2, 3]]);
/// assert_eq!(polygon_area(&positions, &square), Some(1.0));
/// # Ok(()) }
/// ```
pub fn polygon_area(positions: &Positions, polygons: &RaggedArray) -> Option<f64> {
    if positions.dimension() == 0 {
        return None;
    }
    let scaled = Scaled::new(positions);
    let area = Sum::of(polygons.len(), |i| scaled.polygon_area(polygons.list(i)));
    Some(scaled.unscaled(area, 2))
}

/// The signed volume that a closed, coherently oriented surface encloses, in the cube of the unit of the positions;
/// `None` unless the positions have three coordinates.
///
/// It is the sum of the signed volumes of the cones over the faces; for a closed coherent surface the apex does not
/// matter. Positive when the faces run counterclockwise seen from outside. For other surfaces the number has no
/// meaning. A face of four or more vertices that is not flat is taken as the fan around the mean of its vertices. The
/// result is infinite when it exceeds the largest number.
///
/// # Panics
/// If a polygon names a vertex without position.
///
/// # Complexity
/// Linear; parallel, with the same rounding whatever the number of threads.
///
/// # Examples
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_geometry::{Positions, enclosed_volume};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let positions = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 6.])?;
/// let outward = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
/// assert_eq!(enclosed_volume(&positions, &outward), Some(1.0));
/// # Ok(()) }
/// ```
pub fn enclosed_volume(positions: &Positions, polygons: &RaggedArray) -> Option<f64> {
    if positions.dimension() != 3 {
        return None;
    }
    let scaled = Scaled::new(positions);
    // An apex on the surface: no volume that cancels is larger than the surface itself.
    let origin = polygons.items().first().map_or([0.0; 3], |&vertex| scaled.origin_at(vertex));
    let six_fold = Sum::of(polygons.len(), |i| scaled.cone(polygons.list(i).iter().copied(), origin));
    Some(scaled.unscaled(six_fold / 6.0, 3))
}

/// The distance of two points, also where squares of differences are too small or too large for a number.
///
/// # Examples
/// ```
/// use coface_geometry::distance;
/// assert_eq!(distance(&[0.0, 0.0], &[3.0, 4.0]), 5.0);
/// assert!((distance(&[0.0, 0.0], &[3e-200, 4e-200]) / 5e-200 - 1.0).abs() < 1e-15);
/// assert!((distance(&[0.0, 0.0], &[3e200, 4e200]) / 5e200 - 1.0).abs() < 1e-15);
/// ```
#[doc(hidden)]
pub fn distance(a: &[f64], b: &[f64]) -> f64 {
    let of_squares = |scale: f64| -> f64 {
        a.iter().zip(b).map(|(x, y)| (x - y) * scale).map(|difference| difference * difference).sum()
    };
    let square = of_squares(1.0);
    if (1e-270..=f64::MAX).contains(&square) {
        return square.sqrt();
    }
    // A power of two, which rounds nothing: of differences below 1e-135, or of those whose squares are infinite.
    let scale = 2f64.powi(if square < 1.0 { 600 } else { -600 });
    of_squares(scale).sqrt() / scale
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn cube(corner: [f64; 3], side: f64) -> (Positions, RaggedArray) {
        let flat =
            (0..8).flat_map(|i| (0..3).map(move |axis| corner[axis] + side * f64::from(i >> axis & 1)));
        let faces = [[0u32, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        (Positions::from_flat(3, flat.collect()).unwrap(), RaggedArray::from_lists(faces))
    }

    fn is_close(a: f64, b: f64, tolerance: f64) -> bool {
        (a - b).abs() <= tolerance * b.abs()
    }

    #[test]
    fn a_cube_far_out_and_of_any_size_keeps_its_measures() {
        for side in [1e-100, 1.0, 1e100] {
            for offset in [0.0, 3.0, -1e6] {
                let (positions, faces) = cube([offset * side; 3], side);
                let area = polygon_area(&positions, &faces).unwrap();
                let volume = enclosed_volume(&positions, &faces).unwrap();
                assert!(is_close(area, 6.0 * side * side, 1e-8), "{side} {offset} {area}");
                assert!(is_close(volume, side.powi(3), 1e-8), "{side} {offset} {volume}");
            }
        }
        // Beyond the largest number: infinite, not an accident in between.
        let (positions, faces) = cube([0.0; 3], 1e300);
        assert_eq!(polygon_area(&positions, &faces), Some(f64::INFINITY));
    }

    #[test]
    fn measures_that_do_not_apply_are_none() {
        let none = Positions::default();
        assert_eq!(polygon_area(&none, &RaggedArray::new()), None);
        let plane = Positions::from_flat(2, vec![0., 0., 4., 0., 4., 4., 2., 1.]).unwrap();
        // An arrowhead: not convex.
        let polygons = RaggedArray::from_lists([[0, 1, 2, 3]]);
        assert_eq!(polygon_area(&plane, &polygons), Some(6.0));
        assert_eq!(enclosed_volume(&plane, &polygons), None);
        let (positions, _) = cube([0.0; 3], 1.0);
        assert_eq!(polygon_area(&positions, &RaggedArray::new()), Some(0.0));
        assert_eq!(enclosed_volume(&positions, &RaggedArray::new()), Some(0.0));
    }

    proptest! {
        /// The area vector against Heron's rule, in dimensions 2 to 5.
        #[test]
        fn triangles_agree_with_heron(dimension in 2usize..6, flat in prop::collection::vec(-10i32..10, 15)) {
            let flat: Vec<f64> = flat[..3 * dimension].iter().map(|&x| f64::from(x)).collect();
            let positions = Positions::from_flat(dimension, flat).unwrap();
            let length = |i: usize, j: usize| {
                let (p, q) = (positions.point(VertexId::new(i)), positions.point(VertexId::new(j)));
                p.iter().zip(q).map(|(x, y)| (x - y) * (x - y)).sum::<f64>()
            };
            let (a, b, c) = (length(0, 1), length(1, 2), length(2, 0));
            let sixteen_squares = 2.0 * (a * b + b * c + c * a) - (a * a + b * b + c * c);
            let area = polygon_area(&positions, &RaggedArray::from_lists([[0, 1, 2]])).unwrap();
            prop_assert!((16.0 * area * area - sixteen_squares).abs() <= 1e-9 * (1.0 + sixteen_squares));
        }

        /// A sum with heavy cancellation against exact integers.
        #[test]
        fn compensated_sums_keep_small_terms(terms in prop::collection::vec(-1000i64..1000, 0..200)) {
            let big = 1i64 << 52;
            let padded: Vec<i64> = terms.iter().flat_map(|&t| [big, t, -big]).collect();
            let sum = Sum::of(padded.len(), |i| padded[i] as f64 / 1024.0);
            prop_assert_eq!(sum * 1024.0, terms.iter().sum::<i64>() as f64);
        }
    }
}
