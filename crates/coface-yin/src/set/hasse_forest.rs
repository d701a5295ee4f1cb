//! Which curve lies in which.

/// No number. The arrays that hold it have one entry a cell, and an `Option` would double their size.
const NONE: u32 = u32::MAX;

/// The Hasse diagram of almost disjoint curves under inclusion of what they bound: a forest. The parent of a curve is the smallest
/// curve around it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct HasseForest {
    parents: Vec<Option<u32>>,
    depths: Vec<u32>,
}

impl HasseForest {
    /// The forest in which each curve has this parent.
    pub(crate) fn new(parents: Vec<Option<u32>>) -> Self {
        let mut depths = vec![NONE; parents.len()];
        let mut way = Vec::new();
        for curve in 0..parents.len() {
            let mut at = Some(curve as u32);
            while let Some(own) = at.filter(|&own| depths[own as usize] == NONE) {
                way.push(own);
                at = parents[own as usize];
            }
            let mut depth = at.map_or(0, |above| depths[above as usize] + 1);
            while let Some(own) = way.pop() {
                depths[own as usize] = depth;
                depth += 1;
            }
        }
        Self { parents, depths }
    }

    /// The smallest curve around a curve; none for roots.
    ///
    /// # Panics
    /// If there is no such curve.
    ///
    /// # Examples
    /// A square of side 4 with a square hole of side 1.
    /// ```
    /// use coface_yin::{Curve, YinSet};
    /// let outer = Curve::polyline(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [0.0, 0.0]])?;
    /// let hole = Curve::polyline(&[[1.0, 1.0], [1.0, 2.0], [2.0, 2.0], [2.0, 1.0], [1.0, 1.0]])?;
    /// let ring = YinSet::new(&[outer, hole])?;
    /// assert_eq!([ring.forest().parent(0), ring.forest().parent(1)], [None, Some(0)]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn parent(&self, curve: usize) -> Option<usize> {
        self.parents[curve].map(|parent| parent as usize)
    }

    /// The number of curves around a curve.
    ///
    /// # Panics
    /// If there is no such curve.
    ///
    /// # Examples
    /// A square of side 4 with a square hole of side 1.
    /// ```
    /// use coface_yin::{Curve, YinSet};
    /// let outer = Curve::polyline(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [0.0, 0.0]])?;
    /// let hole = Curve::polyline(&[[1.0, 1.0], [1.0, 2.0], [2.0, 2.0], [2.0, 1.0], [1.0, 1.0]])?;
    /// let ring = YinSet::new(&[outer, hole])?;
    /// assert_eq!(ring.forest().depth(1), 1);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn depth(&self, curve: usize) -> usize {
        self.depths[curve] as usize
    }

    /// The curves that lie in no other.
    ///
    /// # Examples
    /// A square of side 4 with a square hole of side 1.
    /// ```
    /// use coface_yin::{Curve, YinSet};
    /// let outer = Curve::polyline(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [0.0, 0.0]])?;
    /// let hole = Curve::polyline(&[[1.0, 1.0], [1.0, 2.0], [2.0, 2.0], [2.0, 1.0], [1.0, 1.0]])?;
    /// let ring = YinSet::new(&[outer, hole])?;
    /// assert_eq!(ring.forest().roots().collect::<Vec<_>>(), [0]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn roots(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.parents.len()).filter(|&curve| self.parents[curve].is_none())
    }
}
