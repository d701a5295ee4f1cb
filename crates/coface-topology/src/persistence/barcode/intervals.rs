//! The type of barcodes.

use coface_algebra::Error;

/// The intervals of one degree: births and deaths, in any order, as often as they occur.
///
/// # Examples
/// ```
/// use coface_topology::Barcode;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let barcode = Barcode::new(vec![[0.0, f64::INFINITY], [1.0, 3.0]])?;
/// assert_eq!(barcode.intervals()[1], [1.0, 3.0]);
/// assert_eq!(barcode.essential_count(), 1);
/// assert_eq!(barcode.finite_range(), Some([0.0, 3.0]));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Barcode {
    intervals: Vec<[f64; 2]>,
}

impl Barcode {
    /// The barcode with these births and deaths.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for an interval with NaN, and for one whose finite ends are so far
    /// apart that their distance is no finite number.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::Barcode;
    /// assert!(Barcode::new(vec![[2.0, 1.0], [f64::NEG_INFINITY, 0.0]]).is_ok());
    /// assert!(Barcode::new(vec![[0.0, f64::NAN]]).is_err());
    /// ```
    pub fn new(mut intervals: Vec<[f64; 2]>) -> Result<Self, Error> {
        for (place, interval) in intervals.iter_mut().enumerate() {
            let [birth, death] = *interval;
            if birth.is_nan() || death.is_nan() {
                return Err(Error::invalid(format!("interval {place} is [{birth}, {death}]"))
                    .with_cure("give two numbers, or inf for the death of a class that never dies"));
            }
            if birth.is_finite() && death.is_finite() && (death - birth).is_infinite() {
                return Err(Error::invalid(format!(
                    "interval {place} is [{birth}, {death}]: its length is no finite number"
                ))
                .with_cure("divide the values by a large number"));
            }
            // Equal numbers have one order.
            *interval = [birth + 0.0, death + 0.0];
        }
        Ok(Self { intervals })
    }

    /// The barcode of pairs of a filtration, which are numbers.
    pub(in crate::persistence) fn of(pairs: impl Iterator<Item = [f64; 2]>) -> Self {
        Self { intervals: pairs.collect() }
    }

    /// The births and deaths.
    ///
    /// # Examples
    /// See [`Barcode`].
    pub fn intervals(&self) -> &[[f64; 2]] {
        &self.intervals
    }

    /// The number of intervals with an infinite end.
    ///
    /// # Examples
    /// See [`Barcode`].
    pub fn essential_count(&self) -> usize {
        self.intervals.len() - self.finite().count()
    }

    /// The least and the greatest finite number of all births and deaths; `None` if there is none.
    ///
    /// # Examples
    /// See [`Barcode`].
    pub fn finite_range(&self) -> Option<[f64; 2]> {
        let numbers = self.intervals.iter().flatten().filter(|number| number.is_finite());
        numbers.fold(None, |range: Option<[f64; 2]>, &number| {
            let [least, greatest] = range.unwrap_or([number; 2]);
            Some([least.min(number), greatest.max(number)])
        })
    }

    /// The barcode in which classes that never die, die at `end`.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::Barcode;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let barcode = Barcode::new(vec![[0.0, f64::INFINITY], [1.0, 3.0]])?;
    /// assert_eq!(barcode.ended_at(5.0)?.intervals(), [[0.0, 5.0], [1.0, 3.0]]);
    /// # Ok(()) }
    /// ```
    ///
    /// # Errors
    /// Those of [`Self::new`]; [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if a class that never dies is born behind the
    /// end.
    pub fn ended_at(&self, end: f64) -> Result<Self, Error> {
        let ended = |&[birth, death]: &[f64; 2]| {
            if death.is_finite() {
                return Ok([birth, death]);
            }
            if (death > 0.0) != (end >= birth) && end != birth {
                return Err(Error::invalid(format!(
                    "a class that never dies is born at {birth}, behind {end}"
                ))
                .with_cure("give an end that lies behind all births"));
            }
            Ok([birth, end])
        };
        Self::new(self.intervals.iter().map(ended).collect::<Result<_, Error>>()?)
    }

    /// The intervals with two finite ends.
    pub(super) fn finite(&self) -> impl Iterator<Item = [f64; 2]> + Clone {
        self.intervals.iter().copied().filter(is_finite)
    }
}

/// Whether both ends are finite.
pub(super) fn is_finite(interval: &[f64; 2]) -> bool {
    interval.iter().all(|end| end.is_finite())
}
