//! Sets of axes.

use std::fmt;

/// A set of axes of a grid, which has at most 32.
///
/// Sets are ordered as the bit strings with a 1 for each axis in the set, axis 0 first: {2} < {1} < {1,2} < {0}. Cells of a
/// grid come in this order. Printed as `{0,2}`.
///
/// # Examples
/// ```
/// use coface_complexes::grids::AxisSet;
/// let set: AxisSet = [2, 0].into_iter().collect();
/// assert!(set.contains(2) && !set.contains(1));
/// assert_eq!(set.iter().collect::<Vec<_>>(), [0, 2]);
/// assert!(AxisSet::from_iter([2]) < AxisSet::from_iter([1]));
/// ```
#[derive(Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
// Axis a is bit 31 - a, so that numbers compare as the bit strings do.
pub struct AxisSet(u32);

impl AxisSet {
    /// The greatest number of axes.
    pub const LIMIT: usize = 32;

    /// The number of axes in the set.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::grids::AxisSet;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let axes: AxisSet = [0, 2].into_iter().collect();
    /// assert_eq!(axes.len(), 2);
    /// # Ok(()) }
    /// ```
    pub fn len(self) -> usize {
        self.0.count_ones() as usize
    }

    /// Whether there is no axis in the set.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::grids::AxisSet;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let axes: AxisSet = [0, 2].into_iter().collect();
    /// assert!(!axes.is_empty());
    /// # Ok(()) }
    /// ```
    pub fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// Whether an axis is in the set.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::grids::AxisSet;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let axes: AxisSet = [0, 2].into_iter().collect();
    /// assert!(axes.contains(2) && !axes.contains(1));
    /// # Ok(()) }
    /// ```
    pub fn contains(self, axis: usize) -> bool {
        axis < Self::LIMIT && self.0 << axis >> 31 == 1
    }

    /// The set with this axis as well.
    ///
    /// # Panics
    /// If `axis` is not below [`Self::LIMIT`].
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::grids::AxisSet;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let axes: AxisSet = [0, 2].into_iter().collect();
    /// assert_eq!(axes.with(1).len(), 3);
    /// # Ok(()) }
    /// ```
    #[must_use]
    pub fn with(self, axis: usize) -> Self {
        Self(self.0 | bit(axis))
    }

    /// The set without this axis.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::grids::AxisSet;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let axes: AxisSet = [0, 2].into_iter().collect();
    /// assert_eq!(axes.without(2).len(), 1);
    /// # Ok(()) }
    /// ```
    #[must_use]
    pub fn without(self, axis: usize) -> Self {
        if self.contains(axis) { Self(self.0 & !bit(axis)) } else { self }
    }

    /// The number of axes in the set that come before this one.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::grids::AxisSet;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let axes: AxisSet = [0, 2].into_iter().collect();
    /// assert_eq!(axes.rank(2), 1);
    /// # Ok(()) }
    /// ```
    pub fn rank(self, axis: usize) -> usize {
        self.iter().take_while(|&own| own < axis).count()
    }

    /// The axes in rising order.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::grids::AxisSet;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let axes: AxisSet = [0, 2].into_iter().collect();
    /// assert!(axes.iter().eq([0, 2]));
    /// # Ok(()) }
    /// ```
    pub fn iter(self) -> impl Iterator<Item = usize> + Clone {
        let mut rest = self.0;
        std::iter::from_fn(move || {
            let axis = rest.leading_zeros();
            (rest != 0).then(|| {
                rest &= !(1 << (31 - axis));
                axis as usize
            })
        })
    }

    /// All subsets in rising order, the empty set first.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::grids::AxisSet;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let axes: AxisSet = [0, 2].into_iter().collect();
    /// assert_eq!(axes.subsets().count(), 4);
    /// # Ok(()) }
    /// ```
    pub fn subsets(self) -> impl Iterator<Item = Self> {
        let mut next = Some(0u32);
        std::iter::from_fn(move || {
            let own = next?;
            next = (own != self.0).then(|| own.wrapping_sub(self.0) & self.0);
            Some(Self(own))
        })
    }
}

fn bit(axis: usize) -> u32 {
    assert!(axis < AxisSet::LIMIT, "an axis is below {}, not {axis}", AxisSet::LIMIT);
    1 << (31 - axis)
}

impl FromIterator<usize> for AxisSet {
    /// # Panics
    /// If an axis is not below [`Self::LIMIT`].
    fn from_iter<I: IntoIterator<Item = usize>>(axes: I) -> Self {
        axes.into_iter().fold(Self::default(), Self::with)
    }
}

impl fmt::Debug for AxisSet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("{")?;
        for (i, axis) in self.iter().enumerate() {
            write!(f, "{}{axis}", if i == 0 { "" } else { "," })?;
        }
        f.write_str("}")
    }
}

impl fmt::Display for AxisSet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(self, f)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn subsets_rise_and_are_all() {
        let set = AxisSet::from_iter([0, 3, 31]);
        let subsets: Vec<AxisSet> = set.subsets().collect();
        assert_eq!(subsets.len(), 8);
        assert!(subsets.is_sorted_by(|a, b| a < b));
        assert!(subsets.iter().all(|subset| subset.iter().all(|axis| set.contains(axis))));
        assert_eq!(AxisSet::default().subsets().count(), 1);
        let all = AxisSet::from_iter(0..32);
        assert_eq!((all.len(), all.rank(31), all.to_string().len()), (32, 31, 2 + 10 + 44 + 31));
        assert_eq!(all.without(0).with(0), all);
        assert!(!all.contains(40));
        assert_eq!(all.without(40), all);
    }
}
