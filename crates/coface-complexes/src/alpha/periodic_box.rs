//! The lengths after which points repeat.

use coface_algebra::{Error, ErrorKind};

/// A box whose opposite sides are glued, by its side along each of at most three axes: a circle, a flat torus of two or of three dimensions.
///
/// # Examples
/// ```
/// use coface_complexes::alpha::PeriodicBox;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let domain = PeriodicBox::new(&[4.0, 2.5])?;
/// assert_eq!(domain.lengths(), [4.0, 2.5]);
/// assert!(PeriodicBox::new(&[4.0, 0.0]).is_err());
/// # Ok(()) }
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PeriodicBox {
    lengths: [f64; 3],
    dimension: usize,
}

impl PeriodicBox {
    /// The box with these sides.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless there are one, two or three; [`ErrorKind::InvalidInput`] naming a side that is not a positive number, or so small or large that
    /// squares of it are beyond the range of numbers.
    ///
    /// # Examples
    /// See [`PeriodicBox`].
    pub fn new(lengths: &[f64]) -> Result<Self, Error> {
        if !(1..=3).contains(&lengths.len()) {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("a periodic box has one, two or three sides, and {} are given", lengths.len()),
            )
            .with_cure("give one length for each coordinate of the points"));
        }
        if let Some(&length) = lengths.iter().find(|length| !LENGTHS.contains(length)) {
            return Err(Error::invalid(format!("a side of a periodic box is {length}"))
                .with_cure("give positive lengths, from 1e-100 to 1e100"));
        }
        let mut all = [1.0; 3];
        all[..lengths.len()].copy_from_slice(lengths);
        Ok(Self { lengths: all, dimension: lengths.len() })
    }

    /// The sides, one for each axis.
    ///
    /// # Examples
    /// See [`PeriodicBox`].
    pub fn lengths(&self) -> &[f64] {
        &self.lengths[..self.dimension]
    }

    /// The number of axes.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::alpha::PeriodicBox;
    /// assert_eq!(PeriodicBox::new(&[4.0, 2.5])?.dimension(), 2);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn dimension(&self) -> usize {
        self.dimension
    }
}

/// Lengths with squares, and squares of their fractions.
const LENGTHS: std::ops::RangeInclusive<f64> = 1e-100..=1e100;
