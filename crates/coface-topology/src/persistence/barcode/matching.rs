//! Matchings of barcodes, and how intervals with infinite ends are matched.

use super::Barcode;
use super::intervals::is_finite;

/// A matching of two barcodes that is as short as any, and its length.
///
/// # Examples
/// ```
/// use coface_topology::Barcode;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let first = Barcode::new(vec![[0.0, 4.0], [1.0, 1.5]])?;
/// let second = Barcode::new(vec![[0.5, 4.0]])?;
/// let matching = first.bottleneck_matching(&second);
/// assert_eq!(matching.distance(), 0.5);
/// // The short interval goes to the diagonal.
/// assert_eq!(matching.pairs(), [(Some(0), Some(0)), (Some(1), None)]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct BarcodeMatching {
    distance: f64,
    lower_bound: f64,
    pairs: Vec<(Option<usize>, Option<usize>)>,
}

impl BarcodeMatching {
    pub(super) fn new(
        distance: f64,
        lower_bound: f64,
        mut pairs: Vec<(Option<usize>, Option<usize>)>,
    ) -> Self {
        // What has no place in the first barcode comes last.
        pairs.sort_unstable_by_key(|&(first, second)| (first.is_none(), first, second));
        Self { distance, lower_bound, pairs }
    }

    /// Of barcodes that have no matching: their intervals with infinite ends differ in number.
    pub(super) fn none() -> Self {
        Self { distance: f64::INFINITY, lower_bound: f64::INFINITY, pairs: Vec::new() }
    }

    /// The length of the matching; infinite if there is none.
    ///
    /// # Examples
    /// See [`BarcodeMatching`].
    pub fn distance(&self) -> f64 {
        self.distance
    }

    /// No matching is shorter than this. It is the distance itself but for rounding, and a proof that comes with it: the value of a solution of
    /// the dual problem.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::Barcode;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let (first, second) = (Barcode::new(vec![[0.0, 4.0]])?, Barcode::new(vec![[0.5, 4.0]])?);
    /// assert_eq!(first.wasserstein_matching(&second, 1.0, 2.0)?.lower_bound(), 0.5);
    /// # Ok(()) }
    /// ```
    pub fn lower_bound(&self) -> f64 {
        self.lower_bound
    }

    /// The places of matched intervals in the first barcode and in the second; `None` is the diagonal. Intervals of length 0 are left out where
    /// they go to the diagonal. Empty if the distance is infinite.
    ///
    /// # Examples
    /// See [`BarcodeMatching`].
    pub fn pairs(&self) -> &[(Option<usize>, Option<usize>)] {
        &self.pairs
    }
}

/// The intervals that have points: both ends are finite and differ.
pub(super) struct Points {
    /// The place of each in the barcode.
    pub(super) places: Vec<usize>,
    pub(super) points: Vec<[f64; 2]>,
}

impl Points {
    pub(super) fn of(barcode: &Barcode) -> Self {
        let all = barcode.intervals().iter().enumerate();
        let (places, points) =
            all.filter(|(_, interval)| is_finite(interval) && interval[0] != interval[1]).unzip();
        Self { places, points }
    }
}

/// The pairs of intervals with infinite ends, and how far apart the finite ends of each pair are. `None` if their numbers differ.
///
/// Of the intervals with one finite end the n-th of one barcode goes to the n-th of the other, in the order of these ends: on a line no other
/// matching is shorter, whatever the order of the distance.
pub(super) fn essential_pairs(first: &Barcode, second: &Barcode) -> Option<Vec<(usize, usize, f64)>> {
    /// Intervals by the ends that are infinite, then by the finite end.
    fn sorted(barcode: &Barcode) -> Vec<([f64; 2], f64, usize)> {
        let key = |(place, interval): (usize, &[f64; 2])| {
            let infinite = interval.map(|end| if end.is_finite() { 0.0 } else { end });
            let finite = interval.iter().find(|end| end.is_finite()).copied().unwrap_or(0.0);
            // A class of [inf, inf] lives nowhere.
            (!is_finite(interval) && interval[0] != interval[1]).then_some((infinite, finite, place))
        };
        let mut all: Vec<_> = barcode.intervals().iter().enumerate().filter_map(key).collect();
        all.sort_by(|a, b| {
            let ends = a.0[0].total_cmp(&b.0[0]).then(a.0[1].total_cmp(&b.0[1]));
            ends.then(a.1.total_cmp(&b.1)).then(a.2.cmp(&b.2))
        });
        all
    }
    let (first, second) = (sorted(first), sorted(second));
    let is_one_kind = first.len() == second.len() && first.iter().zip(&second).all(|(a, b)| a.0 == b.0);
    is_one_kind.then(|| first.iter().zip(&second).map(|(a, b)| (a.2, b.2, (a.1 - b.1).abs())).collect())
}
