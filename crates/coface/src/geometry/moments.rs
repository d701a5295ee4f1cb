//! Moments: integrals of monomials over curves, surfaces and solids, and the mass properties that come of them.

use super::Positions;
use super::measure::{Scaled, Sum, cross, determinant, dot};
use crate::algebra::RaggedArray;

/// The exponents a, b, c of a monomial $x^a y^b z^c$.
type Exponents = [u32; 3];

/// The integrals of monomials over simplices with vertices in space, by complete homogeneous sums.
///
/// For a simplex with vertices $v_0, \ldots, v_m$ and volume $V$ let $h$ be the coefficient of $s^a t^b u^c$ in the product of
/// the series $1 / (1 - x_i s - y_i t - z_i u)$. Then the integral of $x^a y^b z^c$ is
/// $V \, m! \, a! \, b! \, c! / (a + b + c + m)! \cdot h$. All terms of $h$ are products of coordinates: nothing is subtracted
/// that the coordinates do not subtract themselves.
#[derive(Clone)]
struct Series {
    exponents: Exponents,
    coefficients: Vec<f64>,
}

impl Series {
    fn new(exponents: Exponents) -> Self {
        let size = exponents.iter().map(|&exponent| exponent as usize + 1).product();
        Self { exponents, coefficients: vec![0.0; size] }
    }

    /// The coefficient for these vertices.
    fn coefficient(&mut self, vertices: &[[f64; 3]]) -> f64 {
        let [a, b, c] = self.exponents.map(|exponent| exponent as usize + 1);
        self.coefficients.fill(0.0);
        self.coefficients[0] = 1.0;
        for vertex in vertices {
            // Times one more series: what is there plus the vertex times the neighbors below.
            for i in 0..a {
                for j in 0..b {
                    for k in 0..c {
                        let at = (i * b + j) * c + k;
                        let mut sum = self.coefficients[at];
                        if i > 0 {
                            sum += vertex[0] * self.coefficients[at - b * c];
                        }
                        if j > 0 {
                            sum += vertex[1] * self.coefficients[at - c];
                        }
                        if k > 0 {
                            sum += vertex[2] * self.coefficients[at - 1];
                        }
                        self.coefficients[at] = sum;
                    }
                }
            }
        }
        self.coefficients[a * b * c - 1]
    }

    /// $m! \, a! \, b! \, c! / (a + b + c + m)!$, as a product of fractions that neither overflow nor vanish early.
    fn factor(&self, dimension: u32) -> f64 {
        let mut factor = 1.0;
        let mut below = 0.0;
        for part in [dimension, self.exponents[0], self.exponents[1], self.exponents[2]] {
            for i in 1..=part {
                below += 1.0;
                factor *= f64::from(i) / below;
            }
        }
        factor
    }
}

/// The integral of the monomial $x^a y^b z^c$ over all polygons, with respect to area; `None` unless the positions have three
/// coordinates.
///
/// `exponents` are a, b, c. The orientation of polygons does not matter. A polygon of four or more vertices is a fan of
/// triangles around the mean of its vertices, whose areas have signs, so that flat polygons may be non-convex.
///
/// # Panics
/// If a polygon names a vertex without position.
///
/// # Complexity
/// $O(n (a + 1) (b + 1) (c + 1))$ for n corners.
///
/// # References
/// V. Baldoni, N. Berline, J. De Loera, M. Koeppe, M. Vergne, *How to integrate a polynomial over a simplex* (2011); C. Cattani,
/// A. Paoluzzi, *Boundary integration over linear polyhedra* (1990).
///
/// # Examples
/// The area of a triangle and the integral of x over it: its area times the mean of x.
/// ```
/// use coface::algebra::RaggedArray;
/// use coface::geometry::{Positions, surface_moment};
/// # fn main() -> Result<(), coface::Error> {
/// let positions = Positions::from_flat(3, vec![0., 0., 0., 3., 0., 0., 0., 4., 0.])?;
/// let triangle = RaggedArray::from_lists([[0, 1, 2]]);
/// assert_eq!(surface_moment(&positions, &triangle, [0, 0, 0]), Some(6.0));
/// assert_eq!(surface_moment(&positions, &triangle, [1, 0, 0]), Some(6.0));
/// # Ok(()) }
/// ```
pub fn surface_moment(positions: &Positions, polygons: &RaggedArray, exponents: [u32; 3]) -> Option<f64> {
    if positions.dimension() != 3 {
        return None;
    }
    let scaled = Scaled::new(positions);
    let series = Series::new(exponents);
    let integral = Sum::of(polygons.len(), |face| {
        let corners: Vec<[f64; 3]> =
            polygons.list(face).iter().map(|&vertex| scaled.origin_at(vertex)).collect();
        let mut vector = [0.0; 3];
        for triangle in triangles(&corners) {
            let product = area_vector(&triangle);
            (0..3).for_each(|axis| vector[axis] += product[axis]);
        }
        let mut series = series.clone();
        let integrals = triangles(&corners).map(|triangle| {
            let part = area_vector(&triangle);
            dot(part, part).sqrt().copysign(dot(part, vector)) * series.coefficient(&triangle)
        });
        integrals.sum()
    });
    let power = 2 + exponents.iter().sum::<u32>() as usize;
    Some(scaled.unscaled(integral / 2.0 * series.factor(2), power))
}

/// The integral of the monomial $x^a y^b z^c$ over the solid that a closed, coherently oriented surface encloses; `None`
/// unless the positions have three coordinates.
///
/// `exponents` are a, b, c. It is the sum of the integrals over the cones over the faces, with the signs of their volumes:
/// positive where the faces run counterclockwise seen from outside. For surfaces that are not closed and coherent the number
/// means nothing. A polygon of four or more vertices is a fan of triangles around the mean of its vertices.
///
/// # Panics
/// If a polygon names a vertex without position.
///
/// # Complexity
/// $O(n (a + 1) (b + 1) (c + 1))$ for n corners.
///
/// # References
/// As for [`surface_moment`].
///
/// # Examples
/// The tetrahedron of the unit points: $a! \\, b! \\, c! / (a + b + c + 3)!$.
/// ```
/// use coface::algebra::RaggedArray;
/// use coface::geometry::{Positions, enclosed_moment};
/// # fn main() -> Result<(), coface::Error> {
/// let positions = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
/// let outward = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
/// let moment = |exponents| enclosed_moment(&positions, &outward, exponents).expect("there are three coordinates");
/// assert!((moment([1, 0, 0]) * 24.0 - 1.0).abs() < 1e-15);
/// assert!((moment([10, 10, 10]) / 5.503049403185398e-18 - 1.0).abs() < 1e-12);
/// # Ok(()) }
/// ```
pub fn enclosed_moment(positions: &Positions, polygons: &RaggedArray, exponents: [u32; 3]) -> Option<f64> {
    if positions.dimension() != 3 {
        return None;
    }
    let scaled = Scaled::new(positions);
    let power = 3 + exponents.iter().sum::<u32>() as usize;
    Some(scaled.unscaled(moment_about(scaled, polygons, exponents, [0.0; 3]), power))
}

/// The integral over the enclosed solid of a monomial in the differences to an origin, all in scaled coordinates.
fn moment_about(scaled: Scaled<'_>, polygons: &RaggedArray, exponents: Exponents, origin: [f64; 3]) -> f64 {
    // An apex on the surface, so that what cancels is no larger than the solid.
    let apex = polygons.items().first().map_or([0.0; 3], |&vertex| scaled.relative(vertex, origin));
    let series = Series::new(exponents);
    let integral = Sum::of(polygons.len(), |face| {
        let corners: Vec<[f64; 3]> =
            polygons.list(face).iter().map(|&vertex| scaled.relative(vertex, origin)).collect();
        let mut series = series.clone();
        let cones = triangles(&corners).map(|[p, q, r]| {
            let volume = determinant(minus(p, apex), minus(q, apex), minus(r, apex));
            if volume == 0.0 { 0.0 } else { volume * series.coefficient(&[apex, p, q, r]) }
        });
        cones.sum()
    });
    integral / 6.0 * series.factor(3)
}

/// Volume, center and inertia of a solid of density 1.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct MassProperties {
    volume: f64,
    centroid: [f64; 3],
    inertia: [[f64; 3]; 3],
}

impl MassProperties {
    /// Those of the solid that a closed, coherently oriented surface encloses; `None` unless the positions have three
    /// coordinates and the volume is a number other than zero.
    ///
    /// # Examples
    /// The cube with corners at 0 and 6: its inertia about the center is $V s^2 / 6 = 216 \\cdot 36 / 6$ on each axis.
    /// ```
    /// use coface::algebra::RaggedArray;
    /// use coface::geometry::{MassProperties, Positions};
    /// # fn main() -> Result<(), coface::Error> {
    /// let corners = (0..8).flat_map(|i| [0, 1, 2].map(|axis| f64::from(6 * (i >> axis & 1))));
    /// let positions = Positions::from_flat(3, corners.collect())?;
    /// let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    /// let cube = MassProperties::enclosed(&positions, &RaggedArray::from_lists(faces)).expect("a solid");
    /// assert_eq!(cube.centroid(), [3.0; 3]);
    /// assert!((cube.inertia()[0][0] - 1296.0).abs() < 1e-9 && cube.inertia()[0][1].abs() < 1e-9);
    /// # Ok(()) }
    /// ```
    pub fn enclosed(positions: &Positions, polygons: &RaggedArray) -> Option<Self> {
        if positions.dimension() != 3 {
            return None;
        }
        let scaled = Scaled::new(positions);
        let volume = moment_about(scaled, polygons, [0; 3], [0.0; 3]);
        if volume == 0.0 {
            return None;
        }
        let unit = |axis: usize| [0, 1, 2].map(|other| u32::from(other == axis));
        let center = [0, 1, 2].map(|axis| moment_about(scaled, polygons, unit(axis), [0.0; 3]) / volume);
        // About the center: products of differences, not differences of products.
        let product = |i: usize, j: usize| {
            let exponents = [0, 1, 2].map(|axis| u32::from(axis == i) + u32::from(axis == j));
            moment_about(scaled, polygons, exponents, center)
        };
        let squares = [0, 1, 2].map(|axis| product(axis, axis));
        let trace: f64 = squares.iter().sum();
        let inertia = [0, 1, 2].map(|i| {
            [0, 1, 2].map(|j| {
                scaled.unscaled(if i == j { trace - squares[i] } else { -product(i.min(j), i.max(j)) }, 5)
            })
        });
        let centroid = center.map(|coordinate| scaled.unscaled(coordinate, 1));
        Some(Self { volume: scaled.unscaled(volume, 3), centroid, inertia })
    }

    /// The signed volume: negative for a surface that is inside out. The inertia has the same sign.
    pub fn volume(&self) -> f64 {
        self.volume
    }

    /// The center of mass.
    pub fn centroid(&self) -> [f64; 3] {
        self.centroid
    }

    /// The inertia tensor about the center of mass: on the diagonal integrals like $y^2 + z^2$, beside it like $-xy$.
    pub fn inertia(&self) -> [[f64; 3]; 3] {
        self.inertia
    }
}

/// The triangles of a polygon: itself, or a fan around the mean of its vertices.
fn triangles(corners: &[[f64; 3]]) -> impl Iterator<Item = [[f64; 3]; 3]> + '_ {
    let count = corners.len();
    let mean = [0, 1, 2].map(|axis| corners.iter().map(|corner| corner[axis]).sum::<f64>() / count as f64);
    let is_triangle = count == 3;
    let steps = if is_triangle { 1 } else { count };
    (0..steps).map(move |i| {
        let apex = if is_triangle { corners[2] } else { mean };
        [corners[i], corners[(i + 1) % count], apex]
    })
}

fn minus(p: [f64; 3], q: [f64; 3]) -> [f64; 3] {
    [p[0] - q[0], p[1] - q[1], p[2] - q[2]]
}

/// Twice the area of a triangle, as a vector along its normal.
fn area_vector(&[p, q, r]: &[[f64; 3]; 3]) -> [f64; 3] {
    cross(minus(q, p), minus(r, p))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn tetrahedron() -> (Positions, RaggedArray) {
        let positions =
            Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.]).unwrap();
        (positions, RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]))
    }

    fn factorial(n: u32) -> f64 {
        (1..=n).map(f64::from).product()
    }

    #[test]
    fn moments_of_the_unit_tetrahedron_are_quotients_of_factorials() {
        let (positions, faces) = tetrahedron();
        for a in 0..6 {
            for b in 0..6 {
                for c in 0..6 {
                    let moment = enclosed_moment(&positions, &faces, [a, b, c]).unwrap();
                    let expected = factorial(a) * factorial(b) * factorial(c) / factorial(a + b + c + 3);
                    assert!((moment / expected - 1.0).abs() < 1e-13, "{a} {b} {c}");
                }
            }
        }
        let area = surface_moment(&positions, &faces, [0; 3]).unwrap();
        assert!((area - 2.366_025_403_784_438_4).abs() < 1e-15);
        let reversed = RaggedArray::from_lists([[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]]);
        assert!((enclosed_moment(&positions, &reversed, [0; 3]).unwrap() + 1.0 / 6.0).abs() < 1e-15);
        let solid = MassProperties::enclosed(&positions, &faces).unwrap();
        assert!((solid.centroid()[1] - 0.25).abs() < 1e-15);
        // 1/30 about the origin; about the center less 2 * (1/4)^2 / 6.
        assert!((solid.inertia()[2][2] - (1.0 / 30.0 - 1.0 / 48.0)).abs() < 1e-15);
    }

    #[test]
    fn moments_over_a_unit_triangle_are_those_of_the_tables() {
        let positions = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0.]).unwrap();
        let triangle = RaggedArray::from_lists([[0, 1, 2]]);
        let table =
            [([0, 0], 2.0), ([1, 0], 6.0), ([1, 1], 24.0), ([2, 0], 12.0), ([2, 1], 60.0), ([3, 2], 420.0)];
        for ([a, b], inverse) in table {
            let moment = surface_moment(&positions, &triangle, [a, b, 0]).unwrap();
            assert!((moment * inverse - 1.0).abs() < 1e-14);
        }
    }

    #[test]
    fn nothing_and_the_plane_are_ordinary() {
        let (positions, _) = tetrahedron();
        assert_eq!(enclosed_moment(&positions, &RaggedArray::new(), [1, 2, 3]), Some(0.0));
        assert_eq!(MassProperties::enclosed(&positions, &RaggedArray::new()), None);
        let plane = Positions::from_flat(2, vec![0., 0., 1., 0., 0., 1.]).unwrap();
        assert_eq!(surface_moment(&plane, &RaggedArray::from_lists([[0, 1, 2]]), [0; 3]), None);
        // An arrowhead, not convex: area 6, and symmetric in x and y.
        let arrow = Positions::from_flat(3, vec![0., 0., 5., 4., 0., 5., 2., 2., 5., 0., 4., 5.]).unwrap();
        let arrow_face = RaggedArray::from_lists([[0, 1, 2, 3]]);
        assert!((surface_moment(&arrow, &arrow_face, [0; 3]).unwrap() - 8.0).abs() < 1e-14);
    }

    proptest! {
        /// Boxes: the product of integrals on the axes, with faces of four corners.
        #[test]
        fn boxes_have_products_of_integrals(
            low in prop::array::uniform3(-5i32..5), sides in prop::array::uniform3(1i32..6),
            exponents in prop::array::uniform3(0u32..5),
        ) {
            let corners = (0..8).flat_map(|i| [0, 1, 2].map(|axis| f64::from(low[axis] + sides[axis] * (i >> axis & 1))));
            let positions = Positions::from_flat(3, corners.collect()).unwrap();
            let faces = [[0u32, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
            let moment = enclosed_moment(&positions, &RaggedArray::from_lists(faces), exponents).unwrap();
            let power = |x: i32, n: u32| f64::from(x).powi(n as i32 + 1) / f64::from(n + 1);
            let expected: f64 = (0..3)
                .map(|axis| power(low[axis] + sides[axis], exponents[axis]) - power(low[axis], exponents[axis]))
                .product();
            let largest: f64 = (0..3).map(|axis| 10f64.powi(exponents[axis] as i32 + 1)).product();
            prop_assert!((moment - expected).abs() <= 1e-13 * largest, "{moment} {expected}");
        }
    }
}
