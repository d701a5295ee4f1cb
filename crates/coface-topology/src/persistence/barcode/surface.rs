//! Persistence images.

use super::Barcode;
use super::curves::length;
use coface_algebra::{Error, ErrorKind};

/// The pixels of a persistence image, and how points are spread over them.
///
/// An interval [b, d] is the point (b, |d - b|) of the plane. A surface stands over the plane: for each point a normal distribution with the
/// standard deviation `bandwidth` around it, times the power of its length. A pixel of the image is the volume under the surface over it.
///
/// # References
/// H. Adams et al., *Persistence images: a stable vector representation of persistent homology* (2017), section 4.
///
/// # Examples
/// ```
/// use coface_topology::{Barcode, PersistenceSurface};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let barcode = Barcode::new(vec![[1.0, 3.0]])?;
/// let surface = PersistenceSurface::new([0.0, 2.0], [1.0, 3.0], [2, 2], 0.1)?;
/// // The point (1, 2) is the middle of four pixels, which share its weight 2.
/// let image = surface.image(&barcode);
/// assert!(image.iter().all(|pixel| (pixel - 0.5).abs() < 1e-12));
/// # Ok(()) }
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PersistenceSurface {
    births: [f64; 2],
    lengths: [f64; 2],
    resolution: [usize; 2],
    bandwidth: f64,
    power: f64,
}

/// More pixels than this are no image.
const MOST_PIXELS: usize = 1 << 28;

impl PersistenceSurface {
    /// The image over these births and lengths, with so many pixels in the direction of births and of lengths. Weights are the lengths.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] for a range that is empty or not finite, no pixels, and a bandwidth that is not above 0;
    /// [`ErrorKind::TooLarge`] for more than 268,435,456 pixels.
    ///
    /// # Examples
    /// See [`PersistenceSurface`].
    pub fn new(
        births: [f64; 2],
        lengths: [f64; 2],
        resolution: [usize; 2],
        bandwidth: f64,
    ) -> Result<Self, Error> {
        for [low, high] in [births, lengths] {
            if !(low < high && (high - low).is_finite()) {
                return Err(Error::invalid(format!("{low} to {high} is no range of an image"))
                    .with_cure("give two finite numbers, the lesser one first"));
            }
        }
        if !(bandwidth > 0.0 && bandwidth.is_finite()) {
            return Err(Error::invalid(format!("the bandwidth is {bandwidth}"))
                .with_cure("give a finite number above 0"));
        }
        let [width, height] = resolution;
        match width.checked_mul(height) {
            Some(1..=MOST_PIXELS) => {}
            Some(0) => {
                return Err(Error::invalid(format!("an image of {width} x {height} pixels"))
                    .with_cure("give two numbers from 1 on"));
            }
            _ => {
                return Err(Error::new(
                    ErrorKind::TooLarge,
                    format!("an image of {width} x {height} pixels has more than {MOST_PIXELS}"),
                )
                .with_cure("give lower numbers"));
            }
        }
        Ok(Self { births, lengths, resolution, bandwidth, power: 1.0 })
    }

    /// The power of the length that is the weight of an interval; 0 gives all intervals the weight 1.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::{Barcode, PersistenceSurface};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let surface = PersistenceSurface::new([0.0, 2.0], [1.0, 3.0], [1, 1], 0.01)?.power(2.0);
    /// assert!((surface.image(&Barcode::new(vec![[1.0, 3.0]])?)[0] - 4.0).abs() < 1e-12);
    /// # Ok(()) }
    /// ```
    pub fn power(mut self, power: f64) -> Self {
        self.power = power;
        self
    }

    /// The numbers of pixels in the direction of births and of lengths.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::PersistenceSurface;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(PersistenceSurface::new([0.0, 2.0], [1.0, 3.0], [4, 5], 0.01)?.resolution(), [4, 5]);
    /// # Ok(()) }
    /// ```
    pub fn resolution(&self) -> [usize; 2] {
        self.resolution
    }

    /// The image of a barcode: a row for each range of lengths, from the shortest on, in which births run. Intervals with an infinite end are left
    /// out.
    ///
    /// # Complexity
    /// $O(n p)$ for n intervals and p pixels.
    ///
    /// # Examples
    /// See [`PersistenceSurface`].
    pub fn image(&self, barcode: &Barcode) -> Vec<f64> {
        let [width, height] = self.resolution;
        let mut pixels = vec![0.0; width * height];
        let (mut across, mut up) = (vec![0.0; width], vec![0.0; height]);
        for interval in barcode.finite().filter(|&interval| length(interval) > 0.0) {
            self.spread(interval[0], self.births, &mut across);
            self.spread(length(interval), self.lengths, &mut up);
            let weight = length(interval).powf(self.power);
            for (row, y) in pixels.chunks_exact_mut(width).zip(&up) {
                let share = weight * y;
                if share != 0.0 {
                    row.iter_mut().zip(&across).for_each(|(pixel, x)| *pixel += share * x);
                }
            }
        }
        pixels
    }

    /// How much of a normal distribution around a place lies in each of equal parts of a range.
    fn spread(&self, center: f64, [low, high]: [f64; 2], shares: &mut [f64]) {
        let count = shares.len() as f64;
        let scale = self.bandwidth * std::f64::consts::SQRT_2;
        let below = |part: f64| libm::erf((low + (high - low) * (part / count) - center) / scale) / 2.0;
        let mut last = below(0.0);
        for (part, share) in shares.iter_mut().enumerate() {
            let next = below(part as f64 + 1.0);
            (*share, last) = (next - last, next);
        }
    }
}
