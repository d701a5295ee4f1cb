//! Simplicial grids: cubes cut into simplices by repeated extrusion of a point, in closed form.

use super::prism::{fill_windows, window_sign};
use super::{FrozenComplex, SignedSimplices};
use coface_algebra::{Error, ErrorKind};
use coface_algebra::{RaggedArray, Sign};
use coface_geometry::Positions;
use rayon::prelude::*;

/// A grid of `shape[i]` unit cubes along axis i, each cut into d! simplices: a point, extruded along one axis after the
/// other ([`extrude`](super::extrude)). Vertices are numbered with the first axis fastest.
///
/// All cubes are cut alike and fit together. Each simplex lies between two neighboring hyperplanes of constant sum of the
/// first i coordinates, for each i: this is Stanley's triangulation of the cube. Up to dimension 2 it is Kuhn's
/// up to a reflection; from dimension 3 on it is not, for some simplices have no diagonal of the cube.
///
/// # References
/// R. P. Stanley, *Eulerian partitions of a unit hypercube*, in *Higher Combinatorics* (1977).
///
/// # Examples
/// ```
/// use coface_complexes::simplicial::SimplicialGrid;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let grid = SimplicialGrid::new(&[2, 1])?;
/// assert_eq!((grid.vertex_count(), grid.simplex_count()), (6, 4));
/// assert!(grid.simplices()?.lists().iter().eq([[0, 1, 3], [1, 3, 4], [1, 2, 4], [2, 4, 5]]));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SimplicialGrid {
    shape: Vec<u32>,
    vertex_count: u32,
    cube_count: u32,
    simplex_count: u32,
}

impl SimplicialGrid {
    /// The grid with this number of cubes along each axis; without axes it is a point, and with no cube along some axis it
    /// has vertices only.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] if vertices or simplices are more than $2^{32} - 1$.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::SimplicialGrid;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let grid = SimplicialGrid::new(&[2, 1])?;
    /// assert_eq!(grid.simplex_count(), 4);
    /// # Ok(()) }
    /// ```
    pub fn new(shape: &[u32]) -> Result<Self, Error> {
        let product = |factors: &mut dyn Iterator<Item = u64>, what: &str| {
            let mut product = 1u64;
            for factor in factors {
                product = product.saturating_mul(factor);
                // A later factor may be zero, but then the vertices are too many already.
                if product > u64::from(u32::MAX) {
                    return Err(Error::new(
                        ErrorKind::TooLarge,
                        format!("a grid of shape {shape:?} has more than 2^32 - 1 {what}"),
                    )
                    .with_cure("make it of several smaller grids"));
                }
            }
            Ok(product as u32)
        };
        let vertex_count = product(&mut shape.iter().map(|&n| u64::from(n) + 1), "vertices")?;
        let is_flat = shape.contains(&0);
        let cube_count =
            if is_flat { 0 } else { product(&mut shape.iter().map(|&n| u64::from(n)), "cubes")? };
        let factors = (1..=shape.len() as u64).chain([u64::from(cube_count)]);
        let simplex_count = if is_flat { 0 } else { product(&mut factors.into_iter(), "simplices")? };
        Ok(Self { shape: shape.to_vec(), vertex_count, cube_count, simplex_count })
    }

    /// The number of cubes along each axis.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::SimplicialGrid;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let grid = SimplicialGrid::new(&[2, 1])?;
    /// assert_eq!(grid.shape(), [2, 1]);
    /// # Ok(()) }
    /// ```
    pub fn shape(&self) -> &[u32] {
        &self.shape
    }

    /// The number of vertices: the product of the numbers of cubes, each plus 1.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::SimplicialGrid;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let grid = SimplicialGrid::new(&[2, 1])?;
    /// assert_eq!(grid.vertex_count(), 6);
    /// # Ok(()) }
    /// ```
    pub fn vertex_count(&self) -> usize {
        self.vertex_count as usize
    }

    /// The number of simplices of full dimension d: d! times the number of cubes.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::SimplicialGrid;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let grid = SimplicialGrid::new(&[2, 1])?;
    /// assert_eq!(grid.simplex_count(), 4);
    /// # Ok(()) }
    /// ```
    pub fn simplex_count(&self) -> usize {
        self.simplex_count as usize
    }

    /// The simplices of full dimension d, rising, in the order of the extrusions: cube by cube, the first axis fastest, and
    /// in each cube by window of the extrusion along axis 1, then axis 2, ... Their signs make them positive, all
    /// coherently oriented.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] if the lists have more than $2^{32} - 1$ vertices.
    ///
    /// # Complexity
    /// Linear in the result, in parallel.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::SimplicialGrid;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let grid = SimplicialGrid::new(&[2, 1])?;
    /// assert_eq!(grid.simplices()?.len(), 4);
    /// # Ok(()) }
    /// ```
    pub fn simplices(&self) -> Result<SignedSimplices, Error> {
        let width = self.shape.len() + 1;
        let total = self.item_count()?;
        if self.simplex_count == 0 {
            return Ok(SignedSimplices::default());
        }
        let strides = self.strides();
        let (template, signs) = unit_cube(&strides);
        let mut items = vec![0u32; total];
        items
            .par_chunks_mut(template.len())
            .with_min_len(1 + (1 << 12) / template.len())
            .enumerate()
            .for_each(|(cube, simplices)| {
                let corner = self.corner(cube as u32, &strides);
                simplices.iter_mut().zip(&template).for_each(|(vertex, offset)| *vertex = corner + offset);
            });
        let lists = RaggedArray::uniform(width, items)?;
        Ok(SignedSimplices::from_trusted(lists, signs.repeat(self.cube_count as usize)))
    }

    /// The simplices with all their faces; without simplices, the vertices.
    ///
    /// # Errors
    /// Those of [`Self::simplices`] and [`FrozenComplex::from_facets`].
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::SimplicialGrid;
    /// assert_eq!(SimplicialGrid::new(&[2, 1])?.to_frozen()?.f_vector(), [6, 9, 4]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn to_frozen(&self) -> Result<FrozenComplex, Error> {
        if self.simplex_count == 0 {
            return FrozenComplex::from_facets(&RaggedArray::uniform(1, (0..self.vertex_count).collect())?);
        }
        FrozenComplex::from_facets(self.simplices()?.lists())
    }

    /// The facets of only one simplex, with the signs that they have in its boundary: together they are the boundary of the
    /// sum of all positive simplices. They come axis by axis, at each axis first those of its first, then those of its last
    /// hyperplane.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] as [`Self::simplices`].
    ///
    /// # Complexity
    /// Linear in the result, times d for dimension d.
    ///
    /// # Examples
    /// The boundary of a cube has two triangles on each side:
    /// ```
    /// use coface_complexes::simplicial::SimplicialGrid;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(SimplicialGrid::new(&[1, 1, 1])?.boundary_facets()?.len(), 12);
    /// assert_eq!(SimplicialGrid::new(&[4, 3, 2])?.boundary_facets()?.len(), 4 * (4 * 3 + 3 * 2 + 2 * 4));
    /// # Ok(()) }
    /// ```
    pub fn boundary_facets(&self) -> Result<SignedSimplices, Error> {
        let dimension = self.shape.len();
        if self.simplex_count == 0 || dimension == 0 {
            return Ok(SignedSimplices::default());
        }
        self.item_count()?;
        let strides = self.strides();
        let (template, signs) = unit_cube(&strides);
        // The digits of an offset in the unit cube, whatever the strides are.
        let (bits, _) = unit_cube(&(0..dimension as u32).map(|axis| 1 << axis).collect::<Vec<_>>());
        let (mut items, mut facet_signs) = (Vec::new(), Vec::new());
        for axis in 0..dimension {
            for end in [0, 1] {
                // In the unit cube: the simplices with a facet on this side, and the vertex away from it.
                let on_side: Vec<(usize, usize)> = bits
                    .chunks_exact(dimension + 1)
                    .enumerate()
                    .filter_map(|(i, simplex)| {
                        let mut away = (0..=dimension).filter(|&j| simplex[j] >> axis & 1 != end);
                        away.next().filter(|_| away.next().is_none()).map(|j| (i, j))
                    })
                    .collect();
                let layer = if end == 0 { 0 } else { self.shape[axis] - 1 };
                let below: u32 = self.shape[..axis].iter().product();
                let above: u32 = self.shape[axis + 1..].iter().product();
                for outer in 0..above {
                    for inner in 0..below {
                        let cube = (outer * self.shape[axis] + layer) * below + inner;
                        let corner = self.corner(cube, &strides);
                        for &(i, away) in &on_side {
                            let simplex = &template[i * (dimension + 1)..(i + 1) * (dimension + 1)];
                            let kept = (0..=dimension).filter(|&j| j != away);
                            items.extend(kept.map(|j| corner + simplex[j]));
                            facet_signs.push(signs[i].times(Sign::power_of_minus_one(away)));
                        }
                    }
                }
            }
        }
        Ok(SignedSimplices::from_trusted(RaggedArray::uniform(dimension, items)?, facet_signs))
    }

    /// The positions of the vertices: integer points, the first coordinate fastest. The grid without axes has a vertex but no
    /// positions.
    ///
    /// # Errors
    /// None for a grid that could be made.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::SimplicialGrid;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let grid = SimplicialGrid::new(&[2, 1])?;
    /// assert_eq!(grid.positions()?.len(), 6);
    /// # Ok(()) }
    /// ```
    pub fn positions(&self) -> Result<Positions, Error> {
        let dimension = self.shape.len();
        if dimension == 0 {
            return Ok(Positions::default());
        }
        let mut coordinates = Vec::with_capacity(self.vertex_count() * dimension);
        let mut place = vec![0.0; dimension];
        for _ in 0..self.vertex_count {
            coordinates.extend_from_slice(&place);
            for (x, &n) in place.iter_mut().zip(&self.shape) {
                if *x < f64::from(n) {
                    *x += 1.0;
                    break;
                }
                *x = 0.0;
            }
        }
        Positions::from_flat(dimension, coordinates)
    }

    /// The number of vertices in the lists of all simplices.
    fn item_count(&self) -> Result<usize, Error> {
        let total = u64::from(self.simplex_count) * (self.shape.len() as u64 + 1);
        if u32::try_from(total).is_err() {
            return Err(Error::new(
                ErrorKind::TooLarge,
                format!("the simplices have {total} vertices in all; the limit is 2^32 - 1"),
            )
            .with_cure("make the grid of several smaller ones"));
        }
        Ok(total as usize)
    }

    /// By how much vertex numbers grow along each axis.
    fn strides(&self) -> Vec<u32> {
        let lines = self.shape.iter().map(|&n| n + 1);
        lines.scan(1u32, |next, n| Some(std::mem::replace(next, next.wrapping_mul(n)))).collect()
    }

    /// The first vertex of a cube.
    fn corner(&self, mut cube: u32, strides: &[u32]) -> u32 {
        let mut corner = 0;
        for (&n, stride) in self.shape.iter().zip(strides) {
            corner += cube % n * stride;
            cube /= n;
        }
        corner
    }
}

/// The simplices of one cube whose vertices lie at sums of these strides: one after the other, with their signs.
fn unit_cube(strides: &[u32]) -> (Vec<u32>, Vec<Sign>) {
    let (mut simplices, mut signs) = (vec![0u32], vec![Sign::Plus]);
    for (dimension, &stride) in strides.iter().enumerate() {
        let width = dimension + 1;
        let mut next = vec![0; simplices.len() * (width + 1)];
        let mut next_signs = Vec::with_capacity(signs.len() * width);
        for ((simplex, &sign), own) in
            simplices.chunks_exact(width).zip(&signs).zip(next.chunks_exact_mut(width * (width + 1)))
        {
            fill_windows(simplex, 0, stride, own);
            next_signs.extend((0..width).map(|window| window_sign(window, dimension).times(sign)));
        }
        (simplices, signs) = (next, next_signs);
    }
    (simplices, signs)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simplicial::{SimplicialComplex, extrude};
    use coface_algebra::VertexId;
    use proptest::prelude::*;

    /// The determinant of some rows, by expansion along the first.
    fn determinant(rows: &[Vec<f64>]) -> f64 {
        let Some((first, rest)) = rows.split_first() else { return 1.0 };
        let without = |k: usize| -> Vec<Vec<f64>> {
            let others =
                |row: &Vec<f64>| row.iter().enumerate().filter(|&(i, _)| i != k).map(|(_, &x)| x).collect();
            rest.iter().map(others).collect()
        };
        let terms = first.iter().enumerate().filter(|(_, x)| **x != 0.0);
        terms.map(|(k, x)| if k % 2 == 0 { *x } else { -x } * determinant(&without(k))).sum()
    }

    #[test]
    fn counts_and_facets_of_known_grids() {
        for (shape, vertices, simplices, facets) in [
            (&[1][..], 2, 1, 2),
            (&[2], 3, 2, 3),
            (&[1, 1], 4, 2, 5),
            (&[2, 1], 6, 4, 9),
            (&[1, 1, 1], 8, 6, 18),
            (&[1, 1, 1, 1], 16, 24, 84),
            (&[2, 2, 2], 27, 48, 120),
            (&[10, 10, 1], 242, 600, 1440),
        ] {
            let grid = SimplicialGrid::new(shape).unwrap();
            assert_eq!((grid.vertex_count(), grid.simplex_count()), (vertices, simplices), "{shape:?}");
            let complex = SimplicialComplex::from_facets(grid.simplices().unwrap().lists().iter()).unwrap();
            assert_eq!(complex.simplex_count(shape.len() - 1), facets, "{shape:?}");
        }
    }

    #[test]
    fn degenerate_and_huge_shapes() {
        let point = SimplicialGrid::new(&[]).unwrap();
        assert_eq!((point.vertex_count(), point.simplex_count()), (1, 1));
        assert_eq!(point.simplices().unwrap().lists().items(), [0]);
        assert!(point.boundary_facets().unwrap().is_empty());
        let flat = SimplicialGrid::new(&[3, 0]).unwrap();
        assert_eq!((flat.vertex_count(), flat.simplex_count()), (4, 0));
        assert!(flat.simplices().unwrap().is_empty() && flat.boundary_facets().unwrap().is_empty());
        assert_eq!(flat.positions().unwrap().len(), 4);
        for shape in [&[u32::MAX][..], &[1 << 16, 1 << 16], &[1; 13], &[1; 40]] {
            assert_eq!(SimplicialGrid::new(shape).unwrap_err().kind(), ErrorKind::TooLarge, "{shape:?}");
        }
        assert_eq!(
            SimplicialGrid::new(&[1 << 31]).unwrap().simplices().unwrap_err().kind(),
            ErrorKind::TooLarge
        );
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(32))]

        #[test]
        fn grids_are_repeated_extrusions(shape in prop::collection::vec(0u32..4, 0..5)) {
            let grid = SimplicialGrid::new(&shape).unwrap();
            let mut simplices = RaggedArray::from_lists([[0]]);
            let mut vertex_count = 1;
            let mut positions = Positions::default();
            let mut signed = SignedSimplices::new(&simplices).unwrap();
            for &count in &shape {
                let extrusion = extrude(vertex_count, &simplices, &vec![1.0; count as usize]).unwrap();
                positions = extrusion.positions(&positions).unwrap();
                vertex_count = extrusion.vertex_count();
                signed = extrusion.into_simplices();
                simplices = signed.to_oriented();
            }
            prop_assert_eq!(grid.vertex_count(), vertex_count);
            prop_assert_eq!(grid.positions().unwrap(), positions);
            prop_assert_eq!(grid.simplices().unwrap(), signed);
        }

        #[test]
        fn grids_are_manifolds_of_positive_simplices(shape in prop::collection::vec(1u32..3, 1..5)) {
            let grid = SimplicialGrid::new(&shape).unwrap();
            let simplices = grid.simplices().unwrap();
            let positions = grid.positions().unwrap();
            for oriented in simplices.to_oriented().iter() {
                let point = |v: u32| positions.point(VertexId::from_u32(v));
                let sides = oriented[1..].iter().map(|&v| point(v).iter().zip(point(oriented[0])).map(|(a, b)| a - b).collect());
                prop_assert_eq!(determinant(&sides.collect::<Vec<_>>()), 1.0);
            }
            let complex = SimplicialComplex::from_facets(simplices.lists().iter()).unwrap();
            prop_assert_eq!(complex.euler_characteristic(), 1);
            if shape.len() <= 3 {
                prop_assert_eq!(complex.manifold_verdict().unwrap().to_bool(), Some(true));
            }
        }
    }
}
