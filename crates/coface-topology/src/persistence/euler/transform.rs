//! Euler characteristic transforms.

use super::EulerCurve;
use coface_algebra::chains::ChainComplex;
use coface_algebra::{Error, ErrorKind};
use rayon::prelude::*;

/// The Euler characteristic curves of a complex whose vertices have positions, one for each direction: cells enter with their highest vertex along it.
///
/// The curves for all directions tell a simplicial complex in space apart from every other one.
///
/// # References
/// K. Turner, S. Mukherjee, D. M. Boyer, *Persistent homology transform for modeling shapes and surfaces* (2014).
///
/// # Examples
/// A segment from the origin to (3, 4), whose length is 5.
/// ```
/// use coface_algebra::SparseMatrix;
/// use coface_algebra::chains::ChainComplex;
/// use coface_topology::EulerTransform;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let segment = ChainComplex::new(vec![SparseMatrix::from_entries(2, 1, [(0, 0, -1), (1, 0, 1)])?])?;
/// let transform = EulerTransform::new(&segment, &[0.0, 0.0, 3.0, 4.0], 2)?;
/// // The second end comes at the height 5, with the edge, and changes nothing.
/// assert_eq!(transform.curve(&[3.0, 4.0])?.steps(), [(0.0, 1)]);
/// assert_eq!(transform.curve(&[-3.0, -4.0])?.steps(), [(-5.0, 1)]);
/// assert_eq!(transform.range(), [-5.0, 5.0]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct EulerTransform<'a> {
    complex: &'a ChainComplex,
    positions: &'a [f64],
    dimension: usize,
}

impl<'a> EulerTransform<'a> {
    /// The transform of a complex, with a row of so many coordinates for each cell of degree 0.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] for another number of coordinates; [`ErrorKind::InvalidInput`] for one that is not finite, and for a cell of higher degree
    /// without faces, which has no height.
    ///
    /// # Examples
    /// See [`EulerTransform`].
    pub fn new(complex: &'a ChainComplex, positions: &'a [f64], dimension: usize) -> Result<Self, Error> {
        let count = complex.cell_count(0);
        if dimension == 0 || positions.len() != count * dimension {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("{} coordinates for {count} vertices in dimension {dimension}", positions.len()),
            )
            .with_cure("give a row of coordinates for each vertex"));
        }
        if let Some(place) = positions.iter().position(|x| !x.is_finite()) {
            let (vertex, x) = (place / dimension, positions[place]);
            return Err(Error::invalid(format!("vertex {vertex} has the coordinate {x}"))
                .with_cure("give finite positions"));
        }
        for (below, matrix) in complex.boundary_matrices().iter().enumerate() {
            if let Some(cell) = matrix.columns().position(|column| column.rows().is_empty()) {
                return Err(Error::invalid(format!(
                    "cell {cell} of degree {} has no boundary: the complex does not say its vertices",
                    below + 1
                ))
                .with_cure("give a model whose cells have vertices"));
            }
        }
        Ok(Self { complex, positions, dimension })
    }

    /// The curve along a direction, which is made as long as a unit: values are heights in the unit of the positions.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] for a direction with another number of coordinates, and for one that is zero or not finite.
    ///
    /// # Complexity
    /// $O(n \log n + m)$ for n vertices and m entries of the boundary matrices.
    ///
    /// # Examples
    /// See [`EulerTransform`].
    pub fn curve(&self, direction: &[f64]) -> Result<EulerCurve, Error> {
        let unit = self.unit(direction)?;
        let height = |point: &[f64]| point.iter().zip(&unit).map(|(x, u)| x * u).sum::<f64>() + 0.0;
        let heights: Vec<f64> = self.positions.chunks_exact(self.dimension).map(height).collect();
        let mut order: Vec<u32> = (0..heights.len() as u32).collect();
        order.sort_unstable_by(|&a, &b| heights[a as usize].total_cmp(&heights[b as usize]).then(a.cmp(&b)));
        let mut ranks = vec![0; heights.len()];
        (0..).zip(&order).for_each(|(rank, &vertex)| ranks[vertex as usize] = rank);
        let mut changes = vec![1_i64; heights.len()];
        let mut sign = 1;
        for matrix in self.complex.boundary_matrices() {
            sign = -sign;
            let last = |column: coface_algebra::Column<'_>| -> u32 {
                column.rows().iter().map(|&face| ranks[face as usize]).max().unwrap_or(0)
            };
            let above: Vec<u32> = matrix.columns().map(last).collect();
            above.iter().for_each(|&rank| changes[rank as usize] += sign);
            ranks = above;
        }
        let changes = order.iter().zip(changes).map(|(&vertex, change)| (heights[vertex as usize], change));
        Ok(EulerCurve::of_changes(changes, false))
    }

    /// A function of the curve of each direction, in parallel: curves of large models are not all held.
    ///
    /// # Errors
    /// Those of [`Self::curve`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::EulerTransform;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = ChainComplex::of_points(2);
    /// let transform = EulerTransform::new(&points, &[0.0, 1.0], 1)?;
    /// assert_eq!(transform.each(&[vec![1.0], vec![-1.0]], |curve| curve.at(0.0))?, [1, 2]);
    /// # Ok(()) }
    /// ```
    pub fn each<T: Send>(
        &self,
        directions: &[Vec<f64>],
        of_curve: impl Fn(&EulerCurve) -> T + Sync,
    ) -> Result<Vec<T>, Error> {
        directions.par_iter().map(|direction| Ok(of_curve(&self.curve(direction)?))).collect()
    }

    /// The heights that vertices can have along any direction: up to their greatest distance from the origin, to both sides.
    ///
    /// # Examples
    /// See [`EulerTransform`].
    pub fn range(&self) -> [f64; 2] {
        let length = |point: &[f64]| point.iter().map(|x| x * x).sum::<f64>().sqrt();
        let farthest = self.positions.chunks_exact(self.dimension).map(length).fold(0.0, f64::max);
        [-farthest, farthest]
    }

    /// A direction as long as a unit.
    ///
    /// # Errors
    /// Those of [`Self::curve`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::EulerTransform;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let point = ChainComplex::of_points(1);
    /// assert_eq!(EulerTransform::new(&point, &[0.0, 0.0], 2)?.unit(&[3.0, 4.0])?, [0.6, 0.8]);
    /// # Ok(()) }
    /// ```
    pub fn unit(&self, direction: &[f64]) -> Result<Vec<f64>, Error> {
        if direction.len() != self.dimension {
            return Err(Error::invalid(format!(
                "a direction has {} coordinates, and positions have {}",
                direction.len(),
                self.dimension
            ))
            .with_cure("give directions with as many coordinates as the positions"));
        }
        // Scaled first, so that squares neither overflow nor vanish.
        let largest = direction.iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
        if !(largest > 0.0 && direction.iter().all(|x| x.is_finite())) {
            return Err(Error::invalid(format!("{direction:?} is no direction"))
                .with_cure("give finite coordinates that are not all 0"));
        }
        let scaled = direction.iter().map(|x| x / largest);
        let length = scaled.clone().map(|x| x * x).sum::<f64>().sqrt();
        Ok(scaled.map(|x| x / length).collect())
    }
}

/// Directions that are spread evenly: 1 and -1 on a line, equal angles in the plane from the first axis on, and in space the points of a Fibonacci lattice
/// on the sphere.
///
/// # Errors
/// [`ErrorKind::InvalidInput`] in dimension 0 and above 3, where directions are to be given.
///
/// # References
/// Á. González, *Measurement of areas on a sphere using Fibonacci and latitude-longitude lattices* (2010).
///
/// # Examples
/// ```
/// use coface_topology::even_directions;
/// let square = even_directions(2, 4)?;
/// assert_eq!(square[0], [1.0, 0.0]);
/// assert!((square[1][1] - 1.0).abs() < 1e-15);
/// assert_eq!(even_directions(3, 100)?.len(), 100);
/// assert!(even_directions(4, 10).is_err());
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn even_directions(dimension: usize, count: usize) -> Result<Vec<Vec<f64>>, Error> {
    use std::f64::consts::TAU;
    match dimension {
        1 => Ok([vec![1.0], vec![-1.0]].into_iter().take(count).collect()),
        2 => Ok((0..count)
            .map(|place| {
                let (sine, cosine) = (TAU * place as f64 / count as f64).sin_cos();
                vec![cosine, sine]
            })
            .collect()),
        3 => {
            let golden = (1.0 + 5.0_f64.sqrt()) / 2.0;
            let point = |place: usize| {
                let z = 1.0 - (2 * place + 1) as f64 / count as f64;
                let (sine, cosine) = (TAU * (place as f64 / golden).fract()).sin_cos();
                let radius = (1.0 - z * z).max(0.0).sqrt();
                vec![radius * cosine, radius * sine, z]
            };
            Ok((0..count).map(point).collect())
        }
        _ => Err(Error::invalid(format!("directions in dimension {dimension} are not spread here"))
            .with_cure("give the directions themselves")),
    }
}
