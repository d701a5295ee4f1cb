//! Moments: integrals of monomials over curves, surfaces and solids, and mass properties of solids.

use super::Positions;
use super::measure::{Scaled, Sum, cross, determinant, dot};
use coface_algebra::RaggedArray;

/// The exponents a, b, c of a monomial $x^a y^b z^c$.
type Exponents = [u32; 3];

/// The integrals of monomials over simplices with vertices in space, by complete homogeneous sums.
///
/// For a simplex with vertices $v_0, \ldots, v_m$ and volume $V$ let $h$ be the coefficient of $s^a t^b u^c$ in the
/// product of the series $1 / (1 - x_i s - y_i t - z_i u)$. Then the integral of $x^a y^b z^c$ is
/// $V \, m! \, a! \, b! \, c! / (a + b + c + m)! \cdot h$. All terms of $h$ are products of coordinates: nothing is
/// subtracted that the coordinates do not subtract themselves.
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

/// The integral of the monomial $x^a y^b z^c$ over all polygons, with respect to area; `None` unless the positions have
/// three coordinates.
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
/// V. Baldoni, N. Berline, J. De Loera, M. Koeppe, M. Vergne, *How to integrate a polynomial over a simplex* (2011); C.
/// Cattani, A. Paoluzzi, *Boundary integration over linear polyhedra* (1990).
///
/// # Examples
/// The area of a triangle and the integral of x over it: its area times the mean of x.
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_geometry::{Positions, surface_moment};
/// # fn main() -> Result<(), coface_algebra::Error> {
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

/// The integral of the monomial $x^a y^b z^c$ over the solid that a closed, coherently oriented surface encloses;
/// `None` unless the positions have three coordinates.
///
/// `exponents` are a, b, c. It is the sum of the integrals over the cones over the faces, with the signs of their
/// volumes: positive where the faces run counterclockwise seen from outside. For surfaces that are not closed and
/// coherent the number has no meaning. A polygon of four or more vertices is a fan of triangles around the mean of its
/// vertices.
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
/// use coface_algebra::RaggedArray;
/// use coface_geometry::{Positions, enclosed_moment};
/// # fn main() -> Result<(), coface_algebra::Error> {
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
    /// The mass properties of the solid that a closed, coherently oriented surface encloses; `None` unless the
    /// positions have three coordinates and the volume is other than zero. A volume of $2^{-44}$ of the cones from a corner
    /// of the surface is zero: shells turned against each other cancel, and what rounding leaves has no center.
    ///
    /// # Examples
    /// The cube with corners at 0 and 6: its inertia about the center is $V s^2 / 6 = 216 \\cdot 36 / 6$ on each axis.
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_geometry::{MassProperties, Positions};
    /// # fn main() -> Result<(), coface_algebra::Error> {
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
        // An apex on the surface, so that what cancels is no larger than the solid.
        let apex = polygons.items().first().map_or([0.0; 3], |&vertex| scaled.origin_at(vertex));
        let [volume, x, y, z, all] = Sum::of_each(polygons.len(), |face| {
            let mut sums = [0.0; 5];
            fan(&scaled, polygons.list(face), apex, |&[p, q, r]| {
                let cone = determinant(p, q, r);
                sums[0] += cone;
                (0..3).for_each(|axis| sums[axis + 1] += cone * (p[axis] + q[axis] + r[axis]));
                sums[4] += cone.abs();
            });
            sums
        });
        // What is left where shells cancel is the rounding of cones, of which each is off by a few units in its last place.
        if volume.abs() <= all * f64::EPSILON * 256.0 {
            return None;
        }
        // The center as seen from the apex: the mean of the four corners of each cone, one of which is 0.
        let from_apex = [x, y, z].map(|moment| moment / (4.0 * volume));
        let center = [0, 1, 2].map(|axis| apex[axis] + from_apex[axis]);
        // About the center: products of differences, not differences of products.
        const PAIRS: [[usize; 2]; 6] = [[0, 0], [1, 1], [2, 2], [0, 1], [0, 2], [1, 2]];
        let products = Sum::of_each(polygons.len(), |face| {
            let mut sums = [0.0; 6];
            fan(&scaled, polygons.list(face), apex, |corners| {
                let cone = determinant(corners[0], corners[1], corners[2]);
                let [a, b, c, d] =
                    [[0.0; 3], corners[0], corners[1], corners[2]].map(|p| minus(p, from_apex));
                for (sum, [i, j]) in sums.iter_mut().zip(PAIRS) {
                    let all = |axis: usize| a[axis] + b[axis] + c[axis] + d[axis];
                    *sum += cone * (all(i) * all(j) + a[i] * a[j] + b[i] * b[j] + c[i] * c[j] + d[i] * d[j]);
                }
            });
            sums
        });
        // The integral of a product over a tetrahedron is its volume / 20 times that; a cone is six volumes.
        let product = |i: usize, j: usize| {
            let place = PAIRS.iter().position(|&pair| pair == [i.min(j), i.max(j)]).unwrap_or(0);
            products[place] / 120.0
        };
        let volume = volume / 6.0;
        let squares = [0, 1, 2].map(|axis| product(axis, axis));
        let trace: f64 = squares.iter().sum();
        let inertia = [0, 1, 2].map(|i| {
            let beside = |j: usize| if i == j { trace - squares[i] } else { -product(i, j) };
            // A sum with 0 has no negative zero.
            [0, 1, 2].map(|j| scaled.unscaled(beside(j), 5) + 0.0)
        });
        let centroid = center.map(|coordinate| scaled.unscaled(coordinate, 1));
        Some(Self { volume: scaled.unscaled(volume, 3), centroid, inertia })
    }

    /// The signed volume: negative for a surface that is inside out. The inertia has the same sign.
    ///
    /// # Examples
    /// The tetrahedron of the origin and three points on the axes:
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_geometry::{MassProperties, Positions};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let positions = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 6.])?;
    /// let outward = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let solid = MassProperties::enclosed(&positions, &outward).expect("a solid");
    /// assert!((solid.volume() - 1.0).abs() < 1e-15);
    /// # Ok(()) }
    /// ```
    pub fn volume(&self) -> f64 {
        self.volume
    }

    /// The center of mass.
    ///
    /// # Examples
    /// The center of a tetrahedron is the mean of its corners:
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_geometry::{MassProperties, Positions};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let positions = Positions::from_flat(3, vec![0., 0., 0., 4., 0., 0., 0., 4., 0., 0., 0., 4.])?;
    /// let outward = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let solid = MassProperties::enclosed(&positions, &outward).expect("a solid");
    /// assert!(solid.centroid().iter().all(|x| (x - 1.0).abs() < 1e-14));
    /// # Ok(()) }
    /// ```
    pub fn centroid(&self) -> [f64; 3] {
        self.centroid
    }

    /// The inertia tensor about the center of mass: on the diagonal integrals like $y^2 + z^2$, beside it like $-xy$.
    ///
    /// # Examples
    /// The inertia tensor is symmetric:
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_geometry::{MassProperties, Positions};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let positions = Positions::from_flat(3, vec![0., 0., 0., 4., 0., 0., 0., 4., 0., 0., 0., 4.])?;
    /// let outward = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let inertia = MassProperties::enclosed(&positions, &outward).expect("a solid").inertia();
    /// assert!(inertia[0][0] > 0.0 && inertia[0][1] == inertia[1][0]);
    /// # Ok(()) }
    /// ```
    pub fn inertia(&self) -> [[f64; 3]; 3] {
        self.inertia
    }
}

/// The center of the area of all polygons; `None` unless the positions have three coordinates and the area is a number
/// other than zero.
///
/// The orientation of polygons does not matter. A polygon of four or more vertices is a fan of triangles, as in
/// [`surface_moment`].
///
/// # Panics
/// If a polygon names a vertex without position.
///
/// # Complexity
/// Linear; parallel, with the same rounding whatever the number of threads.
///
/// # Examples
/// A triangle, whose center is the mean of its corners:
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_geometry::{Positions, surface_centroid};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let positions = Positions::from_flat(3, vec![0., 0., 0., 3., 0., 0., 0., 6., 9.])?;
/// let triangle = RaggedArray::from_lists([[0, 1, 2]]);
/// let center = surface_centroid(&positions, &triangle).expect("a triangle with an area");
/// assert!(center.iter().zip([1.0, 2.0, 3.0]).all(|(x, expected)| (x - expected).abs() < 1e-14));
/// # Ok(()) }
/// ```
pub fn surface_centroid(positions: &Positions, polygons: &RaggedArray) -> Option<[f64; 3]> {
    if positions.dimension() != 3 {
        return None;
    }
    let scaled = Scaled::new(positions);
    let origin = polygons.items().first().map_or([0.0; 3], |&vertex| scaled.origin_at(vertex));
    let [area, x, y, z] = Sum::of_each(polygons.len(), |face| {
        let polygon = polygons.list(face);
        let mut vector = [0.0; 3];
        if polygon.len() > 3 {
            fan(&scaled, polygon, origin, |triangle| {
                let part = area_vector(triangle);
                (0..3).for_each(|axis| vector[axis] += part[axis]);
            });
        }
        let mut sums = [0.0; 4];
        fan(&scaled, polygon, origin, |triangle| {
            let part = area_vector(triangle);
            let size = dot(part, part).sqrt();
            let area = if polygon.len() > 3 { size.copysign(dot(part, vector)) } else { size };
            let [p, q, r] = triangle;
            sums[0] += area;
            (0..3).for_each(|axis| sums[axis + 1] += area * (p[axis] + q[axis] + r[axis]));
        });
        sums
    });
    let center = [x, y, z].map(|moment| moment / (3.0 * area));
    let center = [0, 1, 2].map(|axis| scaled.unscaled(center[axis] + origin[axis], 1));
    center.iter().all(|coordinate| coordinate.is_finite()).then_some(center)
}

/// Visits the triangles of a polygon, seen from an origin: itself, or a fan around the mean of its vertices.
fn fan(scaled: &Scaled<'_>, polygon: &[u32], origin: [f64; 3], mut visit: impl FnMut(&[[f64; 3]; 3])) {
    let point = |vertex| scaled.relative(vertex, origin);
    if let &[a, b, c] = polygon {
        return visit(&[point(a), point(b), point(c)]);
    }
    let mut mean = [0.0; 3];
    for &vertex in polygon {
        let p = point(vertex);
        (0..3).for_each(|axis| mean[axis] += p[axis] / polygon.len() as f64);
    }
    for (i, &vertex) in polygon.iter().enumerate() {
        visit(&[point(vertex), point(polygon[(i + 1) % polygon.len()]), mean]);
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
    fn shells_that_cancel_have_no_center() {
        // One tetrahedron looks outward and its copy, three tenths aside, inward: what is left of 1/6 - 1/6 is rounding.
        let (positions, faces) = tetrahedron();
        let aside = positions.as_flat().iter().map(|x| x + 0.3);
        let both =
            Positions::from_flat(3, positions.as_flat().iter().copied().chain(aside).collect()).unwrap();
        let turned = |scale: f64| {
            let inward = faces.iter().map(|face| face.iter().rev().map(|v| v + 4).collect::<Vec<_>>());
            let lists = faces.iter().map(<[u32]>::to_vec).chain(inward);
            let flat = both.as_flat().iter().enumerate();
            let flat = flat.map(|(at, &x)| if at < 12 { x * scale } else { x }).collect();
            MassProperties::enclosed(&Positions::from_flat(3, flat).unwrap(), &RaggedArray::from_lists(lists))
        };
        assert_eq!(turned(1.0), None);
        // A little more of the one is a volume, with a center far away.
        let solid = turned(1.0 + 1e-9).unwrap();
        assert!((solid.volume() / 0.5e-9 - 1.0).abs() < 1e-3, "{}", solid.volume());
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

    /// Nodes and weights on the segment from 0 to 1 that are exact for polynomials of degree 2n - 1.
    fn gauss_legendre(n: usize) -> Vec<[f64; 2]> {
        let legendre = |x: f64| {
            let (mut before, mut value) = (1.0, x);
            for k in 2..=n {
                let next = ((2 * k - 1) as f64 * x * value - (k - 1) as f64 * before) / k as f64;
                (before, value) = (value, next);
            }
            (value, n as f64 * (x * value - before) / (x * x - 1.0))
        };
        let node = |i: usize| {
            let mut x = (std::f64::consts::PI * (i as f64 + 0.75) / (n as f64 + 0.5)).cos();
            for _ in 0..50 {
                let (value, slope) = legendre(x);
                x -= value / slope;
            }
            let slope = legendre(x).1;
            [(x + 1.0) / 2.0, 1.0 / ((1.0 - x * x) * slope * slope)]
        };
        (0..n).map(node).collect()
    }

    proptest! {
        /// Tetrahedra against quadrature on a cube that is folded onto them.
        #[test]
        fn tetrahedra_agree_with_quadrature(
            flat in prop::collection::vec(-5i32..5, 12), exponents in prop::array::uniform3(0u32..4),
        ) {
            let flat: Vec<f64> = flat.into_iter().map(f64::from).collect();
            let corner = |i: usize| [flat[3 * i], flat[3 * i + 1], flat[3 * i + 2]];
            let sides = [1, 2, 3].map(|i| minus(corner(i), corner(0)));
            let six_volumes = determinant(sides[0], sides[1], sides[2]);
            let rule = gauss_legendre(8);
            let mut expected = 0.0;
            for &[r, weight] in &rule {
                for &[s, other] in &rule {
                    for &[t, last] in &rule {
                        let [u, v, w] = [r, s * (1.0 - r), t * (1.0 - s) * (1.0 - r)];
                        let value: f64 = (0..3).map(|axis| {
                            let x = corner(0)[axis] + u * sides[0][axis] + v * sides[1][axis] + w * sides[2][axis];
                            x.powi(exponents[axis] as i32)
                        }).product();
                        expected += weight * other * last * (1.0 - r) * (1.0 - r) * (1.0 - s) * value * six_volumes;
                    }
                }
            }
            let positions = Positions::from_flat(3, flat.clone()).unwrap();
            let faces = RaggedArray::from_lists([[0u32, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
            let moment = enclosed_moment(&positions, &faces, exponents).unwrap();
            let largest = 1000.0 * 5f64.powi(exponents.iter().sum::<u32>() as i32);
            prop_assert!((moment - expected).abs() <= 1e-12 * largest, "{moment} {expected}");
        }

        /// Mass properties of boxes that are turned and moved: the volume stays, the center follows, the inertia turns
        /// along.
        #[test]
        fn mass_properties_move_along(
            sides in prop::array::uniform3(1i32..6), turn in 0.0..6.0f64, tilt in 0.0..6.0f64,
            shift in prop::array::uniform3(-50.0..50.0f64),
        ) {
            let rotated = |[x, y, z]: [f64; 3]| {
                let [x, y] = [x * turn.cos() - y * turn.sin(), x * turn.sin() + y * turn.cos()];
                [x, y * tilt.cos() - z * tilt.sin(), y * tilt.sin() + z * tilt.cos()]
            };
            let corner = |i: i32| rotated([0, 1, 2].map(|axis| f64::from(sides[axis] * (i >> axis & 1))));
            let flat = (0..8).flat_map(|i| [0, 1, 2].map(|axis| corner(i)[axis] + shift[axis]));
            let positions = Positions::from_flat(3, flat.collect()).unwrap();
            let faces = [[0u32, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
            let faces = RaggedArray::from_lists(faces);
            let solid = MassProperties::enclosed(&positions, &faces).unwrap();
            let lengths = sides.map(f64::from);
            let volume = lengths[0] * lengths[1] * lengths[2];
            prop_assert!((solid.volume() - volume).abs() < 1e-9 * volume);
            let middle = rotated(lengths.map(|length| length / 2.0));
            let area = surface_centroid(&positions, &faces).unwrap();
            for axis in 0..3 {
                prop_assert!((solid.centroid()[axis] - middle[axis] - shift[axis]).abs() < 1e-11);
                prop_assert!((area[axis] - middle[axis] - shift[axis]).abs() < 1e-11);
            }
            // The columns of the rotation are the images of the axes.
            let axes = [rotated([1., 0., 0.]), rotated([0., 1., 0.]), rotated([0., 0., 1.])];
            let squares = lengths.map(|length| length * length);
            let own = [0, 1, 2].map(|i| volume * (squares.iter().sum::<f64>() - squares[i]) / 12.0);
            for i in 0..3 {
                for j in 0..3 {
                    let expected: f64 = (0..3).map(|k| axes[k][i] * own[k] * axes[k][j]).sum();
                    prop_assert!((solid.inertia()[i][j] - expected).abs() < 1e-8 * volume * 50.0, "{i} {j}");
                }
            }
        }

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
