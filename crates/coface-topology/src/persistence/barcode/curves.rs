//! Barcodes as functions of the value.

use super::Barcode;
use super::intervals::is_finite;

impl Barcode {
    /// The number of classes that live at each of these values.
    ///
    /// A class with the interval [b, d] lives at v if b <= v < d, where values fall if d < v <= b.
    ///
    /// # Complexity
    /// $O((n + m) \log n)$ for n intervals and m values.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::Barcode;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let barcode = Barcode::new(vec![[0.0, f64::INFINITY], [1.0, 3.0]])?;
    /// assert_eq!(barcode.betti_curve(&[-1.0, 0.0, 1.0, 3.0]), [0, 1, 2, 1]);
    /// # Ok(()) }
    /// ```
    pub fn betti_curve(&self, values: &[f64]) -> Vec<usize> {
        let sorted = |ends: &mut dyn Iterator<Item = f64>| {
            let mut ends: Vec<f64> = ends.collect();
            ends.sort_by(f64::total_cmp);
            ends
        };
        let rising = || self.intervals().iter().filter(|[birth, death]| birth < death);
        let falling = || self.intervals().iter().filter(|[birth, death]| birth > death);
        let births = sorted(&mut rising().map(|interval| interval[0]));
        let deaths = sorted(&mut rising().map(|interval| interval[1]));
        let falling_births = sorted(&mut falling().map(|interval| interval[0]));
        let falling_deaths = sorted(&mut falling().map(|interval| interval[1]));
        let living = |&value: &f64| {
            let begun = births.partition_point(|&birth| birth <= value);
            let ended = deaths.partition_point(|&death| death <= value);
            let begun_below = falling_deaths.partition_point(|&death| death < value);
            let ended_below = falling_births.partition_point(|&birth| birth < value);
            begun - ended + begun_below - ended_below
        };
        values.iter().map(living).collect()
    }

    /// The first persistence landscapes at these values: a row for each of them, from the largest one on, with an entry for each value.
    ///
    /// The tent of an interval [b, d] is $\max(0, \min(v - b, d - v))$ at v: as high as v is far from its ends. The k-th landscape is at each
    /// value the k-th highest tent. (GUDHI multiplies them by the root of 2.)
    ///
    /// # Complexity
    /// $O(n m)$ for n intervals and m values.
    ///
    /// # References
    /// P. Bubenik, *Statistical topological data analysis using persistence landscapes* (2015).
    ///
    /// # Examples
    /// ```
    /// use coface_topology::Barcode;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let barcode = Barcode::new(vec![[0.0, 4.0], [1.0, 3.0]])?;
    /// assert_eq!(barcode.landscapes(2, &[1.0, 2.0, 3.5]), [[1.0, 2.0, 0.5], [0.0, 1.0, 0.0]]);
    /// # Ok(()) }
    /// ```
    pub fn landscapes(&self, count: usize, values: &[f64]) -> Vec<Vec<f64>> {
        let kept = count.min(self.intervals().len());
        let mut rows = vec![vec![0.0; values.len()]; count];
        let mut tents = Vec::new();
        for (place, &value) in values.iter().enumerate() {
            tents.clear();
            tents.extend(self.intervals().iter().map(|&interval| tent(interval, value)).filter(|&x| x > 0.0));
            tents.sort_by(|a: &f64, b| b.total_cmp(a));
            for (row, &height) in rows.iter_mut().zip(tents.iter().take(kept)) {
                row[place] = height;
            }
        }
        rows
    }

    /// The silhouette at these values: the mean of the tents of [`Self::landscapes`], weighted by the power of the lengths of the intervals.
    ///
    /// Intervals with an infinite end have no weight and are left out.
    ///
    /// # Complexity
    /// $O(n m)$ for n intervals and m values.
    ///
    /// # References
    /// F. Chazal, B. T. Fasy, F. Lecci, A. Rinaldo, L. Wasserman, *Stochastic convergence of persistence landscapes and silhouettes* (2014).
    ///
    /// # Examples
    /// ```
    /// use coface_topology::Barcode;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let barcode = Barcode::new(vec![[0.0, 6.0], [1.0, 3.0]])?;
    /// // (6 * 2 + 2 * 1) / 8
    /// assert!((barcode.silhouette(1.0, &[2.0])[0] - 1.75).abs() < 1e-15);
    /// # Ok(()) }
    /// ```
    pub fn silhouette(&self, power: f64, values: &[f64]) -> Vec<f64> {
        let longest = self.finite().map(length).fold(0.0, f64::max);
        let weighted: Vec<([f64; 2], f64)> = self
            .finite()
            .filter(|&interval| length(interval) > 0.0)
            .map(|interval| (interval, (length(interval) / longest).powf(power)))
            .collect();
        let total: f64 = weighted.iter().map(|&(_, weight)| weight).sum();
        let mean = |&value: &f64| {
            let sum: f64 = weighted.iter().map(|&(interval, weight)| weight * tent(interval, value)).sum();
            if total > 0.0 { sum / total } else { 0.0 }
        };
        values.iter().map(mean).collect()
    }
}

pub(super) fn length([birth, death]: [f64; 2]) -> f64 {
    (death - birth).abs()
}

/// How far a value lies inside of an interval.
fn tent([birth, death]: [f64; 2], value: f64) -> f64 {
    if !is_finite(&[birth, death]) && birth == death {
        return 0.0;
    }
    (value - birth.min(death)).min(birth.max(death) - value).max(0.0)
}

/// The Euler characteristic of the complex at each of these values: the alternating sum of the numbers of living classes. The barcodes are those
/// of the degrees from 0 on, all that the complex has.
///
/// # Examples
/// A circle that is born at 1 by its last edge:
/// ```
/// use coface_topology::{Barcode, euler_characteristic_curve};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let degrees = [Barcode::new(vec![[0.0, f64::INFINITY]])?, Barcode::new(vec![[1.0, f64::INFINITY]])?];
/// assert_eq!(euler_characteristic_curve(&degrees, &[-1.0, 0.5, 1.0]), [0, 1, 0]);
/// # Ok(()) }
/// ```
pub fn euler_characteristic_curve(degrees: &[Barcode], values: &[f64]) -> Vec<i64> {
    let mut sums = vec![0; values.len()];
    for (degree, barcode) in degrees.iter().enumerate() {
        for (sum, living) in sums.iter_mut().zip(barcode.betti_curve(values)) {
            *sum += if degree % 2 == 0 { living as i64 } else { -(living as i64) };
        }
    }
    sums
}
