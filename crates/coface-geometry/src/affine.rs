//! Affine maps of a space to itself.

use super::{Angle, Positions};
use coface_algebra::{Error, ErrorKind};
use coface_algebra::{Integer, Sign};
use rayon::prelude::*;

/// The map $x \mapsto A x + b$ of the space of some dimension to itself.
///
/// # Examples
/// A quarter turn of the plane about (1, 0), exactly:
/// ```
/// use coface_geometry::{AffineMap, Angle, Positions};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let about = AffineMap::translation(&[-1.0, 0.0])?
///     .then(&AffineMap::rotation(2, [0, 1], Angle::turns(1, 4))?)?
///     .then(&AffineMap::translation(&[1.0, 0.0])?)?;
/// let moved = about.apply(&Positions::from_flat(2, vec![3.0, 0.0])?)?;
/// assert_eq!(moved.as_flat(), [1.0, 2.0]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct AffineMap {
    dimension: usize,
    /// Row after row.
    matrix: Vec<f64>,
    offset: Vec<f64>,
}

impl AffineMap {
    /// The map with this matrix, row after row, and this offset, whose length is the dimension.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless the matrix has as many rows and columns as the offset has entries;
    /// [`ErrorKind::InvalidInput`] if a number is not finite.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::AffineMap;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // x goes to y + 1, y goes to x.
    /// let map = AffineMap::new(vec![0., 1., 1., 0.], vec![1., 0.])?;
    /// assert_eq!(map.image(&[5., 7.]), [8., 5.]);
    /// # Ok(()) }
    /// ```
    pub fn new(matrix: Vec<f64>, offset: Vec<f64>) -> Result<Self, Error> {
        let dimension = offset.len();
        if matrix.len() != dimension * dimension {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("a matrix of {} entries does not map dimension {dimension} to itself", matrix.len()),
            ));
        }
        if let Some(bad) = matrix.iter().chain(&offset).find(|x| !x.is_finite()) {
            return Err(Error::invalid(format!("{bad} in an affine map is not a finite number")));
        }
        Ok(Self { dimension, matrix, offset })
    }

    /// The map that leaves every point where it is.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_geometry::AffineMap::identity(2).image(&[5., 7.]), [5., 7.]);
    /// ```
    pub fn identity(dimension: usize) -> Self {
        let matrix =
            (0..dimension * dimension).map(|k| f64::from(u8::from(k % (dimension + 1) == 0))).collect();
        Self { dimension, matrix, offset: vec![0.0; dimension] }
    }

    /// The map that moves every point by a vector.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] if a number is not finite.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::AffineMap;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(AffineMap::translation(&[1., -1.])?.image(&[5., 7.]), [6., 6.]);
    /// # Ok(()) }
    /// ```
    pub fn translation(by: &[f64]) -> Result<Self, Error> {
        Self::new(Self::identity(by.len()).matrix, by.to_vec())
    }

    /// The map that multiplies each coordinate with its factor; a negative factor mirrors, zero flattens.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] if a factor is not finite.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::AffineMap;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(AffineMap::scaling(&[2., -1.])?.image(&[5., 7.]), [10., -7.]);
    /// # Ok(()) }
    /// ```
    pub fn scaling(factors: &[f64]) -> Result<Self, Error> {
        let mut map = Self::identity(factors.len());
        for (i, &factor) in factors.iter().enumerate() {
            map.matrix[i * (factors.len() + 1)] = factor;
        }
        Self::new(map.matrix, map.offset)
    }

    /// The rotation about the origin that takes the first axis of `plane` towards the second and leaves all others.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] unless these are two axes below the dimension.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::{AffineMap, Angle};
    /// let quarter = AffineMap::rotation(3, [0, 1], Angle::turns(1, 4))?;
    /// assert_eq!(quarter.image(&[1.0, 0.0, 5.0]), [0.0, 1.0, 5.0]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn rotation(dimension: usize, plane: [usize; 2], angle: Angle) -> Result<Self, Error> {
        let [i, j] = plane;
        if i == j || i >= dimension || j >= dimension {
            return Err(Error::invalid(format!(
                "the axes {i} and {j} span no plane of dimension {dimension}"
            ))
            .with_cure(format!("name two axes below {dimension}, numbered from 0")));
        }
        let (cosine, sine) = angle.cosine_and_sine();
        let mut map = Self::identity(dimension);
        map.matrix[i * dimension + i] = cosine;
        map.matrix[j * dimension + j] = cosine;
        map.matrix[i * dimension + j] = 0.0 - sine;
        map.matrix[j * dimension + i] = sine;
        Ok(map)
    }

    /// The rotation of space about an axis through the origin, counterclockwise when seen against the direction of the
    /// axis.
    ///
    /// $R x = \cos\varphi\, x + \sin\varphi\, u \times x + (1 - \cos\varphi)\, (u \cdot x)\, u$ for the unit vector u
    /// along the axis.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] if the axis is zero or not finite.
    ///
    /// # References
    /// O. Rodrigues, *Des lois géométriques qui régissent les déplacements d'un système solide* (1840).
    ///
    /// # Examples
    /// A third of a turn about (1, 1, 1) exchanges the axes:
    /// ```
    /// use coface_geometry::{AffineMap, Angle};
    /// let map = AffineMap::rotation_about([1.0, 1.0, 1.0], Angle::turns(1, 3))?;
    /// let image = map.image(&[1.0, 0.0, 0.0]);
    /// assert!(image.iter().zip([0.0, 1.0, 0.0]).all(|(x, y)| (x - y).abs() < 1e-15));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn rotation_about(axis: [f64; 3], angle: Angle) -> Result<Self, Error> {
        let largest = axis.iter().fold(0.0f64, |largest, x| largest.max(x.abs()));
        if !(largest > 0.0 && axis.iter().all(|x| x.is_finite())) {
            return Err(Error::invalid(format!("{axis:?} is no axis of rotation"))
                .with_cure("give three finite numbers that are not all zero"));
        }
        // Divided first, so that squares neither overflow nor vanish.
        let scaled = axis.map(|x| x / largest);
        let length = scaled.iter().map(|x| x * x).sum::<f64>().sqrt();
        let u = scaled.map(|x| x / length);
        let (cosine, sine) = angle.cosine_and_sine();
        let cross = [[0.0, -u[2], u[1]], [u[2], 0.0, -u[0]], [-u[1], u[0], 0.0]];
        let mut matrix = Vec::with_capacity(9);
        for i in 0..3 {
            for j in 0..3 {
                let unit = if i == j { cosine } else { 0.0 };
                matrix.push(unit + sine * cross[i][j] + (1.0 - cosine) * u[i] * u[j]);
            }
        }
        Self::new(matrix, vec![0.0; 3])
    }

    /// The dimension of the space.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_geometry::AffineMap::identity(3).dimension(), 3);
    /// ```
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// The matrix, row after row.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_geometry::AffineMap::identity(2).matrix(), [1., 0., 0., 1.]);
    /// ```
    pub fn matrix(&self) -> &[f64] {
        &self.matrix
    }

    /// The image of the origin.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::AffineMap;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(AffineMap::translation(&[1., -1.])?.offset(), [1., -1.]);
    /// # Ok(()) }
    /// ```
    pub fn offset(&self) -> &[f64] {
        &self.offset
    }

    /// The map that does first this and then `next`.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] if the dimensions differ; [`ErrorKind::InvalidInput`] if a number becomes infinite.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::AffineMap;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let (double, shift) = (AffineMap::scaling(&[2.0])?, AffineMap::translation(&[1.0])?);
    /// assert_eq!(double.then(&shift)?.image(&[5.0]), [11.0]);
    /// assert_eq!(shift.then(&double)?.image(&[5.0]), [12.0]);
    /// # Ok(()) }
    /// ```
    pub fn then(&self, next: &Self) -> Result<Self, Error> {
        let n = self.dimension;
        if next.dimension != n {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("a map of dimension {} cannot follow one of dimension {n}", next.dimension),
            ));
        }
        let entry = |k: usize| (0..n).map(|l| next.matrix[k / n * n + l] * self.matrix[l * n + k % n]).sum();
        Self::new((0..n * n).map(entry).collect(), next.image(&self.offset))
    }

    /// The image of one point.
    ///
    /// # Panics
    /// If the point has fewer coordinates than the map has dimensions.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::AffineMap;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(AffineMap::scaling(&[2., 3.])?.image(&[1., 1.]), [2., 3.]);
    /// # Ok(()) }
    /// ```
    pub fn image(&self, point: &[f64]) -> Vec<f64> {
        let mut image = vec![0.0; self.dimension];
        self.write_image(point, &mut image);
        image
    }

    fn write_image(&self, point: &[f64], image: &mut [f64]) {
        for (i, x) in image.iter_mut().enumerate() {
            let row = &self.matrix[i * self.dimension..(i + 1) * self.dimension];
            *x = row.iter().zip(point).map(|(a, x)| a * x).sum::<f64>() + self.offset[i];
        }
    }

    /// The images of all points.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] if the points have another dimension; [`ErrorKind::InvalidInput`] if a coordinate becomes
    /// infinite.
    ///
    /// # Complexity
    /// $O(n d^2)$ for n points, parallel.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::{AffineMap, Positions};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let segment = Positions::from_flat(1, vec![0.0, 1.0])?;
    /// assert_eq!(AffineMap::translation(&[5.0])?.apply(&segment)?.as_flat(), [5.0, 6.0]);
    /// # Ok(()) }
    /// ```
    pub fn apply(&self, positions: &Positions) -> Result<Positions, Error> {
        if positions.is_empty() && positions.dimension() == 0 {
            return Ok(positions.clone());
        }
        let n = self.dimension;
        if positions.dimension() != n {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("a map of dimension {n} cannot move points of dimension {}", positions.dimension()),
            ));
        }
        const BLOCK: usize = 1 << 10;
        let mut images = vec![0.0; positions.as_flat().len()];
        images.par_chunks_mut(BLOCK * n).zip(positions.as_flat().par_chunks(BLOCK * n)).for_each(
            |(images, points)| {
                for (image, point) in images.chunks_mut(n).zip(points.chunks(n)) {
                    self.write_image(point, image);
                }
            },
        );
        Positions::from_flat(n, images)
    }

    /// The sign of the determinant of the matrix, exact for the numbers that it has: minus for a map that turns
    /// orientations over; `None` for a map that flattens.
    ///
    /// # Complexity
    /// $O(d^3)$ products of integers.
    ///
    /// # References
    /// E. H. Bareiss, *Sylvester's identity and multistep integer-preserving Gaussian elimination* (1968).
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Sign;
    /// use coface_geometry::AffineMap;
    /// assert_eq!(AffineMap::scaling(&[2.0, -1e-300])?.determinant_sign(), Some(Sign::Minus));
    /// assert_eq!(AffineMap::new(vec![0.1, 0.2, 0.1, 0.2], vec![0.0; 2])?.determinant_sign(), None);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn determinant_sign(&self) -> Option<Sign> {
        let n = self.dimension;
        let mut rows: Vec<Vec<Integer>> = self.matrix.chunks(n.max(1)).map(integer_row).collect();
        let (mut sign, mut last) = (Sign::Plus, Integer::from(1i64));
        for k in 0..n {
            let pivot = (k..n).find(|&i| !rows[i][k].is_zero())?;
            if pivot != k {
                rows.swap(pivot, k);
                sign = sign.opposite();
            }
            let (done, rest) = rows.split_at_mut(k + 1);
            let top = &done[k];
            for row in rest {
                for j in k + 1..n {
                    let minor = &(&top[k] * &row[j]) - &(&row[k] * &top[j]);
                    row[j] = minor.exact_quotient(&last).expect("a minor of the matrix is an integer");
                }
            }
            last = rows[k][k].clone();
        }
        Some(if last.signum() < 0 { sign.opposite() } else { sign })
    }

    /// The inverse map.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] if the determinant is zero, or so small that the inverse has no finite numbers.
    ///
    /// # Complexity
    /// $O(d^3)$ by elimination with the largest pivots; its results are rounded.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::AffineMap;
    /// let map = AffineMap::new(vec![2.0, 1.0, 0.0, 1.0], vec![4.0, 1.0])?;
    /// assert_eq!(map.inverse()?.image(&map.image(&[3.0, -5.0])), [3.0, -5.0]);
    /// assert!(AffineMap::scaling(&[1.0, 0.0])?.inverse().is_err());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn inverse(&self) -> Result<Self, Error> {
        let singular = || {
            Error::invalid("the affine map has no inverse: it flattens the space")
                .with_cure("scale no axis by zero, and give rows of a matrix that are independent")
        };
        self.determinant_sign().ok_or_else(singular)?;
        let n = self.dimension;
        let width = n + n;
        let mut rows = vec![0.0; n * width];
        for i in 0..n {
            rows[i * width..i * width + n].copy_from_slice(&self.matrix[i * n..(i + 1) * n]);
            rows[i * width + n + i] = 1.0;
        }
        for k in 0..n {
            let size = |i: &usize| rows[i * width + k].abs();
            let pivot = (k..n).max_by(|a, b| size(a).total_cmp(&size(b))).unwrap_or(k);
            for j in 0..width {
                rows.swap(k * width + j, pivot * width + j);
            }
            let divisor = rows[k * width + k];
            rows[k * width..(k + 1) * width].iter_mut().for_each(|x| *x /= divisor);
            for i in (0..n).filter(|&i| i != k) {
                let factor = rows[i * width + k];
                for j in 0..width {
                    rows[i * width + j] -= factor * rows[k * width + j];
                }
            }
        }
        let matrix = (0..n).flat_map(|i| rows[i * width + n..(i + 1) * width].to_vec()).collect();
        let mut inverse = Self::new(matrix, vec![0.0; n]).map_err(|_| singular())?;
        let offset = inverse.image(&self.offset).iter().map(|x| 0.0 - x).collect();
        inverse = Self::new(inverse.matrix, offset).map_err(|_| singular())?;
        Ok(inverse)
    }
}

/// A row multiplied by the power of two that makes all its numbers integers; finite numbers only.
fn integer_row(row: &[f64]) -> Vec<Integer> {
    let parts: Vec<(i64, i32)> = row.iter().map(|&x| mantissa_and_exponent(x)).collect();
    let least = parts.iter().filter(|part| part.0 != 0).map(|part| part.1).min().unwrap_or(0);
    let scaled = |&(mantissa, exponent): &(i64, i32)| {
        let mut value = Integer::from(mantissa);
        let mut left = if mantissa == 0 { 0 } else { exponent - least };
        while left > 0 {
            let step = left.min(62);
            value = &value * &Integer::from(1i64 << step);
            left -= step;
        }
        value
    };
    parts.iter().map(scaled).collect()
}

/// The integers m and e with $x = m 2^e$.
fn mantissa_and_exponent(x: f64) -> (i64, i32) {
    let bits = x.to_bits();
    let (exponent, fraction) = ((bits >> 52 & 0x7ff) as i32, (bits & ((1 << 52) - 1)) as i64);
    let mantissa = if exponent == 0 { fraction } else { fraction | 1 << 52 };
    (if x < 0.0 { -mantissa } else { mantissa }, exponent.max(1) - 1075)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn map(dimension: usize) -> impl Strategy<Value = AffineMap> {
        let numbers = |count| prop::collection::vec(-4i32..5, count);
        (numbers(dimension * dimension), numbers(dimension)).prop_map(|(matrix, offset)| {
            let float = |list: Vec<i32>| list.into_iter().map(f64::from).collect();
            AffineMap::new(float(matrix), float(offset)).unwrap()
        })
    }

    /// The determinant of a small integer matrix along its first row.
    fn determinant(rows: &[Vec<f64>]) -> f64 {
        let minor = |j: usize| -> Vec<Vec<f64>> {
            let without = |row: &Vec<f64>| (0..row.len()).filter(|&k| k != j).map(|k| row[k]).collect();
            rows[1..].iter().map(without).collect()
        };
        match rows.first() {
            None => 1.0,
            Some(first) => {
                let term = |(j, x): (usize, &f64)| if j % 2 == 0 { *x } else { -x } * determinant(&minor(j));
                first.iter().enumerate().map(term).sum()
            }
        }
    }

    #[test]
    fn faults_are_named() {
        assert!(AffineMap::new(vec![1.0; 3], vec![0.0; 2]).is_err());
        assert!(AffineMap::translation(&[f64::NAN]).is_err());
        assert!(AffineMap::rotation(2, [0, 2], Angle::ZERO).unwrap_err().to_string().contains("below 2"));
        assert!(AffineMap::rotation_about([0.0; 3], Angle::ZERO).is_err());
        let two = AffineMap::identity(2);
        assert_eq!(two.then(&AffineMap::identity(3)).unwrap_err().kind(), ErrorKind::Shape);
        assert!(two.apply(&Positions::from_flat(3, vec![0.0; 3]).unwrap()).is_err());
        let nowhere = AffineMap::identity(0);
        assert_eq!(nowhere.determinant_sign(), Some(Sign::Plus));
        assert_eq!(nowhere.inverse().unwrap(), nowhere);
        assert!(
            AffineMap::scaling(&[1e-320]).unwrap().inverse().unwrap_err().to_string().contains("no inverse")
        );
    }

    #[test]
    fn signs_do_not_depend_on_rounding() {
        // In floating point the determinant of each of these is 0 or has the wrong sign.
        let tiny = AffineMap::new(vec![1.0 + f64::EPSILON, 1.0, 1.0, 1.0 - f64::EPSILON / 2.0], vec![0.0; 2])
            .unwrap();
        assert_eq!(tiny.determinant_sign(), Some(Sign::Plus));
        let far = AffineMap::scaling(&[1e-200, 1e-200, -1e-200, 1e308]).unwrap();
        assert_eq!(far.determinant_sign(), Some(Sign::Minus));
    }

    #[test]
    fn rotations_about_the_axes_are_those_of_planes() {
        for (axis, plane) in [([0., 0., 5.], [0, 1]), ([1e-200, 0., 0.], [1, 2]), ([0., 1e300, 0.], [2, 0])] {
            for i in 0..8 {
                let angle = Angle::turns(i, 8);
                let about = AffineMap::rotation_about(axis, angle).unwrap();
                let within = AffineMap::rotation(3, plane, angle).unwrap();
                let close = about.matrix.iter().zip(&within.matrix).all(|(x, y)| (x - y).abs() < 1e-15);
                assert!(close, "{about:?} {within:?}");
            }
        }
    }

    proptest! {
        #[test]
        fn signs_of_determinants_are_those_of_leibniz(map in (0usize..5).prop_flat_map(map)) {
            let rows: Vec<Vec<f64>> = map.matrix.chunks(map.dimension.max(1)).map(<[f64]>::to_vec).collect();
            let expected = determinant(&rows);
            let found = map.determinant_sign().map_or(0.0, |sign| f64::from(sign.to_i32()));
            prop_assert_eq!(found, if expected == 0.0 { 0.0 } else { expected.signum() });
            prop_assert_eq!(map.inverse().is_err(), expected == 0.0);
        }

        #[test]
        fn composition_is_one_after_the_other(a in map(3), b in map(3), point in prop::collection::vec(-9i32..9, 6)) {
            let points = Positions::from_flat(3, point.into_iter().map(f64::from).collect()).unwrap();
            let both = a.then(&b).unwrap().apply(&points).unwrap();
            prop_assert_eq!(&both, &b.apply(&a.apply(&points).unwrap()).unwrap());
            if let Ok(back) = a.inverse() {
                let there = back.apply(&a.apply(&points).unwrap()).unwrap();
                let near = there.as_flat().iter().zip(points.as_flat()).all(|(x, y)| (x - y).abs() < 1e-9);
                prop_assert!(near, "{there:?} {points:?}");
            }
        }
    }
}
