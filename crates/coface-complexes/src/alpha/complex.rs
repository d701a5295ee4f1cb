//! Alpha complexes of points.

use crate::filtered::FilteredComplex;
use crate::simplicial::FrozenComplex;
use coface_algebra::progress::stage;
use coface_algebra::{Error, SparseMatrix, VertexId};
use coface_geometry::predicates::{WeightedPoint, smallest_sphere, smallest_sphere_side};
use coface_geometry::{Positions, RegularTriangulation};
use rayon::prelude::*;

/// The alpha complex of points of the plane or of space, with weights or without: the simplices of the Delaunay triangulation, each with the squared
/// radius at which it enters.
///
/// At the value $a$ it has the homotopy type of the union of the balls of squared radius $a$ around the points; with a weight w, of squared radius
/// $a + w$. A simplex enters with the smallest sphere through its points if no other point lies inside of that, and else with its first coface. Points enter at 0,
/// those of weight w at -w or later. **Values are squared radii**, as in GUDHI's `AlphaComplex` (`output_squared_values=True`). Each is the number nearest
/// to the exact value, so that diagrams depend neither on the order of the points nor on which of several Delaunay triangulations is taken.
///
/// # Examples
/// A right triangle with the legs 6 and 8: its edges enter with their halves, 3, 4 and 5, squared, and the triangle with the longest.
/// ```
/// use coface_complexes::alpha::AlphaComplex;
/// use coface_geometry::Positions;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let corners = Positions::from_flat(2, vec![0., 0., 6., 0., 0., 8.])?;
/// let alpha = AlphaComplex::new(&corners, None)?;
/// assert_eq!((alpha.values(1), alpha.values(2)), (&[9., 16., 25.][..], &[25.][..]));
/// assert_eq!(alpha.complex().f_vector(), [3, 3, 1]);
/// assert_eq!(alpha.up_to(16.).complex().f_vector(), [3, 2]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AlphaComplex {
    filtered: FilteredComplex,
    hidden: Vec<VertexId>,
}

impl AlphaComplex {
    /// The alpha complex of points of at most three coordinates, with a weight for each point if there are weights: squared radii, which may be negative.
    /// Points that equal others, and those that weights hide, are in no simplex.
    ///
    /// # Errors
    /// Those of [`RegularTriangulation::new`]; [`ErrorKind::TooLarge`](coface_algebra::ErrorKind::TooLarge) for more than 2^28 simplices.
    ///
    /// # Complexity
    /// That of [`RegularTriangulation::new`], and a few operations for each simplex.
    ///
    /// # References
    /// H. Edelsbrunner, E. Mücke, *Three-dimensional alpha shapes* (1994); H. Edelsbrunner, *The union of balls and its dual shape* (1995), for weights.
    ///
    /// # Examples
    /// See [`AlphaComplex`].
    pub fn new(points: &Positions, weights: Option<&[f64]>) -> Result<Self, Error> {
        let triangulation = RegularTriangulation::new(points, weights)?;
        let complex = FrozenComplex::from_facets(triangulation.cells())?;
        let coordinate = |id: usize, axis: usize| points.point(VertexId::new(id)).get(axis).copied();
        let at = |id: usize| {
            let point = [0, 1, 2].map(|axis| coordinate(id, axis).unwrap_or(0.0));
            WeightedPoint::new(point, weights.map_or(0.0, |weights| weights[id]))
        };
        let points: Vec<WeightedPoint> = (0..points.len()).map(at).collect();
        let values = Radii { complex: &complex, points, is_weighted: weights.is_some() }.values()?;
        let filtered = FilteredComplex::from_trusted_parts(complex, values);
        Ok(Self { filtered, hidden: triangulation.hidden().to_vec() })
    }

    /// The simplices of the Delaunay triangulation.
    ///
    /// # Examples
    /// See [`AlphaComplex`].
    pub fn complex(&self) -> &FrozenComplex {
        self.filtered.complex()
    }

    /// The values of the simplices of a degree, in the order of the complex: squared radii. Empty beyond the dimension.
    ///
    /// # Examples
    /// See [`AlphaComplex`].
    pub fn values(&self, degree: usize) -> &[f64] {
        self.filtered.values(degree)
    }

    /// The complex with its values.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::alpha::AlphaComplex;
    /// assert!(AlphaComplex::default().into_filtered().complex().is_empty());
    /// ```
    pub fn into_filtered(self) -> FilteredComplex {
        self.filtered
    }

    /// The points in no simplex of the triangulation, rising.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::alpha::AlphaComplex;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let twice = Positions::from_flat(2, vec![0., 0., 1., 0., 0., 0.])?;
    /// assert_eq!(AlphaComplex::new(&twice, None)?.hidden()[0].index(), 2);
    /// # Ok(()) }
    /// ```
    pub fn hidden(&self) -> &[VertexId] {
        &self.hidden
    }

    /// The same with radii, the square roots of the values, which are not negative where points have no weights.
    ///
    /// # Panics
    /// If a value is negative.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::alpha::AlphaComplex;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let two = Positions::from_flat(2, vec![0., 0., 6., 0.])?;
    /// assert_eq!(AlphaComplex::new(&two, None)?.with_radii().values(1), [3.]);
    /// # Ok(()) }
    /// ```
    pub fn with_radii(self) -> Self {
        assert!(self.filtered.all_values().all(|value| value >= 0.0), "negative values have no roots");
        Self { filtered: self.filtered.map_values(f64::sqrt), hidden: self.hidden }
    }

    /// The part that is there at a value: the simplices that enter at it or before.
    ///
    /// # Complexity
    /// $O(n \log n)$ for n simplices.
    ///
    /// # Examples
    /// See [`AlphaComplex`].
    pub fn up_to(&self, bound: f64) -> Self {
        Self { filtered: self.filtered.up_to(bound), hidden: self.hidden.clone() }
    }
}

/// What the values of simplices are found from.
struct Radii<'a> {
    complex: &'a FrozenComplex,
    points: Vec<WeightedPoint>,
    is_weighted: bool,
}

impl Radii<'_> {
    /// The values by degree.
    fn values(&self) -> Result<Vec<Vec<f64>>, Error> {
        let Some(dimension) = self.complex.dimension() else { return Ok(Vec::new()) };
        let chains = self.complex.chain_complex()?;
        let _steps = stage("measuring simplices", 0);
        let top = (0..self.complex.simplex_count(dimension)).into_par_iter();
        let mut values =
            vec![top.map(|i| smallest_sphere(&self.corners(dimension, i))).collect::<Vec<f64>>()];
        for degree in (0..dimension).rev() {
            let below = match chains.boundary_matrix(degree + 1) {
                Some(matrix) if degree > 0 || self.is_weighted => {
                    self.values_below(degree, matrix, values.last().expect("of the degree above"))
                }
                _ => vec![0.0; self.complex.simplex_count(degree)],
            };
            values.push(below);
        }
        values.reverse();
        Ok(values)
    }

    fn corners(&self, degree: usize, i: usize) -> Vec<WeightedPoint> {
        self.complex.numbers(degree, i).iter().map(|&id| self.points[id as usize]).collect()
    }

    /// The values of the simplices of a degree from those of their cofaces, whose boundaries are the columns of a matrix.
    fn values_below(&self, degree: usize, matrix: &SparseMatrix, above: &[f64]) -> Vec<f64> {
        // Bit j of a coface: its facet number j, in the order of the column, has the point that is left inside its smallest sphere.
        let attached: Vec<u8> = (0..above.len())
            .into_par_iter()
            .map(|coface| {
                let points = self.complex.numbers(degree + 1, coface);
                let is_attached = |&j: &usize| {
                    // Facets that lack later points come first.
                    let lacked = points[degree + 1 - j];
                    let facet: Vec<WeightedPoint> = points
                        .iter()
                        .filter(|&&point| point != lacked)
                        .map(|&point| self.points[point as usize])
                        .collect();
                    smallest_sphere_side(&facet, self.points[lacked as usize]).is_gt()
                };
                (0..degree + 2).filter(is_attached).fold(0, |bits, j| bits | 1 << j)
            })
            .collect();
        let count = self.complex.simplex_count(degree);
        let (mut first, mut is_attached) = (vec![f64::INFINITY; count], vec![false; count]);
        for (coface, &bits) in attached.iter().enumerate() {
            for (j, (face, _)) in matrix.column(coface).iter().enumerate() {
                first[face] = first[face].min(above[coface]);
                is_attached[face] |= bits >> j & 1 == 1;
            }
        }
        let own =
            |i: usize| if is_attached[i] { first[i] } else { smallest_sphere(&self.corners(degree, i)) };
        (0..count).into_par_iter().map(own).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Small points of a grid, many of them on common circles, lines and places.
    fn grid_points(dimension: usize) -> impl Strategy<Value = Vec<f64>> {
        prop::collection::vec(0i32..4, 0..8 * dimension).prop_map(move |mut flat| {
            flat.truncate(flat.len() / dimension * dimension);
            flat.into_iter().map(f64::from).collect()
        })
    }

    fn euler_characteristic(alpha: &AlphaComplex, bound: f64) -> i64 {
        let counts = alpha.up_to(bound).complex().f_vector();
        counts.iter().enumerate().map(|(k, &n)| if k % 2 == 0 { n as i64 } else { -(n as i64) }).sum()
    }

    proptest! {
        /// A simplex enters no sooner than its faces; the whole is a ball.
        #[test]
        fn values_rise(flat in (1usize..4).prop_flat_map(|d| grid_points(d).prop_map(move |flat| (d, flat)))) {
            let (dimension, flat) = flat;
            let points = Positions::from_flat(dimension, flat).unwrap();
            let alpha = AlphaComplex::new(&points, None).unwrap();
            alpha.complex().check().unwrap();
            for degree in 1..alpha.complex().f_vector().len() {
                for (i, &value) in alpha.values(degree).iter().enumerate() {
                    for (_, face) in alpha.complex().facets(degree, i) {
                        prop_assert!(alpha.values(degree - 1)[face] <= value);
                    }
                }
            }
            prop_assert_eq!(euler_characteristic(&alpha, f64::INFINITY), i64::from(!points.is_empty()));
            prop_assert_eq!(alpha.complex().simplex_count(0) + alpha.hidden.len(), points.len());
        }

        /// The Euler characteristics along the values are those of the points in another order.
        #[test]
        fn the_order_of_points_does_not_matter((flat, shift) in (grid_points(3), 0usize..8)) {
            let points = Positions::from_flat(3, flat.clone()).unwrap();
            let mut turned: Vec<&[f64]> = flat.chunks(3).collect();
            if !turned.is_empty() {
                let shift = shift % turned.len();
                turned.rotate_left(shift);
            }
            turned.reverse();
            let turned = Positions::from_flat(3, turned.concat()).unwrap();
            let [one, other] = [points, turned].map(|points| AlphaComplex::new(&points, None).unwrap());
            for bound in one.filtered.all_values().chain(other.filtered.all_values()) {
                prop_assert_eq!(euler_characteristic(&one, bound), euler_characteristic(&other, bound));
            }
        }
    }

    #[test]
    fn an_obtuse_triangle_has_an_attached_edge() {
        let flat = Positions::from_flat(2, vec![0., 0., 8., 0., 4., 2.]).unwrap();
        let alpha = AlphaComplex::new(&flat, None).unwrap();
        // The circle through all three has the radius 5.
        assert_eq!((alpha.values(1), alpha.values(2)), (&[25., 5., 5.][..], &[25.][..]));
        assert_eq!(alpha.clone().with_radii().values(2), [5.]);
        assert_eq!(alpha.into_filtered().facets_up_to(f64::INFINITY).len(), 1);
    }

    #[test]
    fn weights_move_values() {
        let two = Positions::from_flat(1, vec![0., 4.]).unwrap();
        let alpha = AlphaComplex::new(&two, Some(&[4., 0.])).unwrap();
        // The balls of squared radii a + 4 and a meet on the way where x^2 - 4 = (4 - x)^2.
        assert_eq!((alpha.values(0), alpha.values(1)), (&[-4., 0.][..], &[2.25][..]));
        // The second ball comes when its center leaves the first one.
        let alpha = AlphaComplex::new(&two, Some(&[20., 0.])).unwrap();
        assert_eq!((alpha.values(0), alpha.values(1)), (&[-20., 0.25][..], &[0.25][..]));
        let three = Positions::from_flat(1, vec![0., 4., 2.]).unwrap();
        assert_eq!(AlphaComplex::new(&three, Some(&[8., 8., 0.])).unwrap().hidden(), [VertexId::new(2)]);
    }

    #[test]
    fn nothing_and_one_point() {
        let none = AlphaComplex::new(&Positions::default(), None).unwrap();
        assert_eq!((none.complex().f_vector(), none.values(0)), (vec![], &[][..]));
        let one = Positions::from_flat(3, vec![1.0; 9]).unwrap();
        let alpha = AlphaComplex::new(&one, Some(&[1., 3., 3.])).unwrap();
        assert_eq!((alpha.values(0), alpha.complex().numbers(0, 0)), (&[-3.0][..], &[1][..]));
        assert_eq!(alpha.up_to(-4.0).complex().f_vector(), Vec::<usize>::new());
    }
}
