//! Euler characteristic curves.

use crate::persistence::Filtration;

/// The Euler characteristic of the cells that have entered, as a function of the value: a step at each value at which it changes.
///
/// # Examples
/// The rim of a triangle at 1, and its inside at 5.
/// ```
/// use coface_algebra::SparseMatrix;
/// use coface_algebra::chains::ChainComplex;
/// use coface_topology::{EulerCurve, Filtration};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let edges = [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1), (0, 2, -1), (2, 2, 1)];
/// let triangle = ChainComplex::new(vec![
///     SparseMatrix::from_entries(3, 3, edges)?,
///     SparseMatrix::from_entries(3, 1, [(0, 0, 1), (1, 0, 1), (2, 0, -1)])?,
/// ])?;
/// let filtration = Filtration::new(&triangle, vec![vec![0.0; 3], vec![1.0; 3], vec![5.0]])?;
/// let curve = EulerCurve::of_filtration(&filtration);
/// assert_eq!(curve.steps(), [(0.0, 3), (1.0, 0), (5.0, 1)]);
/// assert_eq!((curve.at(-1.0), curve.at(4.0), curve.last()), (0, 0, 1));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct EulerCurve {
    /// The values, in the order of entrance, each with the characteristic from there on.
    steps: Vec<(f64, i64)>,
    /// The least and the greatest value at which something enters.
    range: Option<[f64; 2]>,
    is_falling: bool,
}

impl EulerCurve {
    /// The curve of a filtration.
    ///
    /// # Complexity
    /// That of sorting the cells.
    ///
    /// # Examples
    /// See [`EulerCurve`].
    pub fn of_filtration(filtration: &Filtration) -> Self {
        let mut changes = Vec::new();
        for degree in 0..filtration.degree_count() {
            let sign = if degree % 2 == 0 { 1 } else { -1 };
            changes.extend(filtration.values(degree).iter().map(|&value| (value, sign)));
        }
        changes.sort_by(|a, b| a.0.total_cmp(&b.0));
        if filtration.is_falling() {
            changes.reverse();
        }
        Self::of_changes(changes, filtration.is_falling())
    }

    /// The curve that changes by these numbers, at values in the order of entrance.
    pub(in crate::persistence) fn of_changes(
        changes: impl IntoIterator<Item = (f64, i64)>,
        is_falling: bool,
    ) -> Self {
        let mut steps: Vec<(f64, i64)> = Vec::new();
        let (mut now, mut range) = (0, None);
        for (value, change) in changes {
            now += change;
            let [low, high] = range.unwrap_or([value; 2]);
            range = Some([value.min(low), value.max(high)]);
            match steps.last_mut() {
                Some(last) if last.0 == value => last.1 = now,
                // A step of height 0 is none.
                _ => {
                    drop_even(&mut steps);
                    steps.push((value, now));
                }
            }
        }
        drop_even(&mut steps);
        Self { steps, range, is_falling }
    }

    /// The first value at which something enters, and those at which the characteristic changes, in the order of entrance, each with the characteristic from
    /// there on.
    ///
    /// # Examples
    /// See [`EulerCurve`].
    pub fn steps(&self) -> &[(f64, i64)] {
        &self.steps
    }

    /// The least and the greatest value at which something enters; `None` if nothing does.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::ImageFiltration;
    /// // A row of equal pixels that grows at one end.
    /// let curve = ImageFiltration::new(&[3], [0.0, 1.0, 2.0])?.euler_curve()?;
    /// assert_eq!((curve.steps(), curve.range()), (&[(0.0, 1)][..], Some([0.0, 2.0])));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn range(&self) -> Option<[f64; 2]> {
        self.range
    }

    /// Whether cells enter from high values to low ones.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::ImageFiltration;
    /// let image = ImageFiltration::new(&[2], [0.0, 1.0])?.superlevel(true);
    /// assert!(image.euler_curve()?.is_falling());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn is_falling(&self) -> bool {
        self.is_falling
    }

    /// The characteristic of the cells that have entered at a value.
    ///
    /// # Complexity
    /// $O(\log n)$ for n steps.
    ///
    /// # Examples
    /// See [`EulerCurve`].
    pub fn at(&self, value: f64) -> i64 {
        let has_come = |step: &(f64, i64)| if self.is_falling { step.0 >= value } else { step.0 <= value };
        match self.steps.partition_point(has_come) {
            0 => 0,
            count => self.steps[count - 1].1,
        }
    }

    /// The characteristic of all cells.
    ///
    /// # Examples
    /// See [`EulerCurve`].
    pub fn last(&self) -> i64 {
        self.steps.last().map_or(0, |step| step.1)
    }

    /// The smooth curve over a range of values: at each value the integral, from the first end of the range on, of what the characteristic is above its mean
    /// over the range. It is 0 at both ends.
    ///
    /// # Complexity
    /// $O(n + m \log n)$ for n steps and m values.
    ///
    /// # References
    /// L. Crawford, A. Monod, A. X. Chen, S. Mukherjee, R. Rabadán, *Predicting clinical outcomes in glioblastoma: an application of topological and functional
    /// data analysis* (2020).
    ///
    /// # Examples
    /// Over the range from 0 to 2 the characteristic is 0, then 1: its mean is 1 / 2.
    /// ```
    /// use coface_topology::ImageFiltration;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let curve = ImageFiltration::new(&[1], [1.0])?.euler_curve()?;
    /// assert_eq!(curve.smooth([0.0, 2.0], &[0.0, 1.0, 1.5, 2.0]), [0.0, -0.5, -0.25, 0.0]);
    /// # Ok(()) }
    /// ```
    pub fn smooth(&self, range: [f64; 2], values: &[f64]) -> Vec<f64> {
        let [low, high] = range;
        // The places where the characteristic changes inside of the range, rising, with that behind each, and the integral up to each.
        let inside = self.steps.iter().map(|step| step.0).filter(|&value| low < value && value < high);
        let mut ends: Vec<f64> = std::iter::once(low).chain(inside).collect();
        ends.sort_by(f64::total_cmp);
        let behind: Vec<i64> = (0..ends.len())
            .map(|place| {
                let next = ends.get(place + 1).copied().unwrap_or(high);
                self.at(ends[place].midpoint(next))
            })
            .collect();
        let mut integrals = vec![0.0];
        for place in 0..ends.len() {
            let next = ends.get(place + 1).copied().unwrap_or(high);
            integrals.push(integrals[place] + behind[place] as f64 * (next - ends[place]));
        }
        let length = high - low;
        let whole = integrals[ends.len()];
        let one = |&value: &f64| {
            let value = value.clamp(low, high);
            if length <= 0.0 || value == high {
                return 0.0;
            }
            let place = ends.partition_point(|&end| end <= value) - 1;
            integrals[place] + behind[place] as f64 * (value - ends[place]) - whole * ((value - low) / length)
        };
        values.iter().map(one).collect()
    }
}

/// Drops the last step if it changes nothing, unless it is the first one, from where on there is something.
fn drop_even(steps: &mut Vec<(f64, i64)>) {
    if let [.., before, last] = &steps[..]
        && before.1 == last.1
    {
        steps.pop();
    }
}
