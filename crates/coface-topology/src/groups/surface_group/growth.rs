//! How many elements there are of each length.

use super::SurfaceGroup;
use super::group::Kind;
use coface_algebra::Integer;
use std::collections::VecDeque;

/// The sizes of the spheres one after the other, without end.
struct SphereSizes {
    /// The number of generators.
    count: i64,
    /// Whether there is a relator.
    is_closed: bool,
    radius: usize,
    /// The last sizes, the latest first: at most as many as there are generators.
    latest: VecDeque<Integer>,
    /// The sum of the latest sizes except the n-th.
    sum: Integer,
}

impl Iterator for SphereSizes {
    type Item = Integer;

    fn next(&mut self) -> Option<Integer> {
        let n = self.count;
        let radius = self.radius as i64;
        let size = if radius == 0 {
            Integer::ONE
        } else if !self.is_closed {
            // Every element has one letter that leads back.
            let last = self.latest.front().cloned().unwrap_or_default();
            last * Integer::from(if radius == 1 { 2 * n } else { 2 * n - 1 })
        } else if n == 1 {
            Integer::from(i64::from(radius == 1))
        } else {
            let own = if radius < n { 2 } else { i64::from(radius == n) };
            let mut size = Integer::from(own) + Integer::from(2 * n - 2) * self.sum.clone();
            if radius >= n {
                size -= &self.latest[n as usize - 1];
            }
            size
        };
        self.radius += 1;
        self.latest.push_front(size.clone());
        self.sum += &size;
        // The sum has the latest n - 1 sizes.
        if let Some(old) = self.latest.get((n - 1).max(0) as usize) {
            self.sum -= old;
        }
        self.latest.truncate(n.max(1) as usize);
        Some(size)
    }
}

impl SurfaceGroup {
    fn growth(&self) -> SphereSizes {
        SphereSizes {
            count: self.generator_count() as i64,
            is_closed: !matches!(self.kind, Kind::Free),
            radius: 0,
            latest: VecDeque::new(),
            sum: Integer::ZERO,
        }
    }

    /// The number of elements of each length from 0 to `radius`, without listing them.
    ///
    /// For n generators and a relator the universal cover is the tiling by polygons with 2n sides, 2n at each vertex,
    /// whichever scheme it is, and the numbers are the coefficients of the power series of
    /// $$\frac{1 + 2z + \dots + 2z^{n-1} + z^n}{1 - (2n-2)(z + \dots + z^{n-1}) + z^n}.$$
    ///
    /// # Complexity
    /// Linear in the radius, with integers that grow as long as the radius.
    ///
    /// # References
    /// J. W. Cannon, P. Wagreich, *Growth functions of surface groups* (1992).
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::SurfaceGroup;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let sizes = |letters: &[i32]| -> Result<String, coface_algebra::Error> {
    ///     let group = SurfaceGroup::closed(&Word::from_letters(letters.iter().copied()))?;
    ///     Ok(format!("{:?}", group.sphere_sizes(4)))
    /// };
    /// assert_eq!(sizes(&[1, 2, -1, -2, 3, 4, -3, -4])?, "[1, 8, 56, 392, 2736]");
    /// assert_eq!(sizes(&[1, 2, 1, -2])?, "[1, 4, 8, 12, 16]");
    /// assert_eq!(sizes(&[1, 1])?, "[1, 1, 0, 0, 0]");
    /// # Ok(()) }
    /// ```
    pub fn sphere_sizes(&self, radius: usize) -> Vec<Integer> {
        self.growth().take(radius.saturating_add(1)).collect()
    }

    /// The number of elements of length at most `radius`, or `None` if there are more than `most`.
    ///
    /// # Complexity
    /// No more than $O(\min(r, m))$ steps for the radius r and m the greatest number; logarithmic in m when the group
    /// grows exponentially.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::SurfaceGroup;
    /// let free = SurfaceGroup::free(2);
    /// assert_eq!(free.ball_size(2, 1000), Some(17));
    /// assert_eq!(free.ball_size(1_000_000_000, 1000), None);
    /// assert_eq!(SurfaceGroup::free(0).ball_size(1_000_000_000, 1000), Some(1));
    /// ```
    pub fn ball_size(&self, radius: usize, most: usize) -> Option<usize> {
        let mut total = 0usize;
        for size in self.growth().take(radius.saturating_add(1)) {
            if size.is_zero() {
                break;
            }
            let size = size.to_i64().and_then(|size| usize::try_from(size).ok())?;
            total = total.checked_add(size).filter(|&total| total <= most)?;
        }
        Some(total)
    }
}
