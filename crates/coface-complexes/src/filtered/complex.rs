//! A simplicial complex with values.

use crate::simplicial::FrozenComplex;
use coface_algebra::RaggedArray;

/// A simplicial complex whose simplices enter at values, no simplex sooner than its faces.
///
/// # Examples
/// The flag complex of a triangle, whose last edge comes at 5.
/// ```
/// use coface_complexes::filtered::{FilteredComplex, WeightedGraph};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let graph = WeightedGraph::new(vec![0.0; 3], [(0, 1, 3.0), (1, 2, 4.0), (0, 2, 5.0)])?;
/// let triangle = FilteredComplex::flag(&graph, f64::INFINITY, 2)?;
/// assert_eq!((triangle.values(1), triangle.values(2)), (&[3.0, 5.0, 4.0][..], &[5.0][..]));
/// assert_eq!(triangle.up_to(4.0).complex().f_vector(), [3, 2]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FilteredComplex {
    complex: FrozenComplex,
    /// For each degree the value of each simplex.
    values: Vec<Vec<f64>>,
}

impl FilteredComplex {
    /// The complex with these values, which a construction has just made right: for each degree a list in the order of the complex.
    pub(crate) fn from_trusted_parts(complex: FrozenComplex, values: Vec<Vec<f64>>) -> Self {
        Self { complex, values }
    }

    /// The simplices.
    ///
    /// # Examples
    /// See [`FilteredComplex`].
    pub fn complex(&self) -> &FrozenComplex {
        &self.complex
    }

    /// The values of the simplices of a degree, in the order of the complex. Empty beyond the dimension.
    ///
    /// # Examples
    /// See [`FilteredComplex`].
    pub fn values(&self, degree: usize) -> &[f64] {
        self.values.get(degree).map_or(&[], Vec::as_slice)
    }

    /// The complex, and for each degree the values.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::filtered::FilteredComplex;
    /// let (complex, values) = FilteredComplex::default().into_parts();
    /// assert!(complex.is_empty() && values.is_empty());
    /// ```
    pub fn into_parts(self) -> (FrozenComplex, Vec<Vec<f64>>) {
        (self.complex, self.values)
    }

    /// The part that is there at a value: the simplices that enter at it or before.
    ///
    /// # Complexity
    /// $O(n \log n)$ for n simplices.
    ///
    /// # Examples
    /// See [`FilteredComplex`].
    pub fn up_to(&self, bound: f64) -> Self {
        let facets = self.facets_up_to(bound);
        let complex = FrozenComplex::from_facets(&facets).expect("a part of a complex is no larger");
        let value = |degree: usize, i: usize| {
            let here = self.complex.index_of(complex.numbers(degree, i)).expect("a part of the complex");
            self.values[degree][here]
        };
        let of_degree = |(degree, count): (usize, usize)| (0..count).map(|i| value(degree, i)).collect();
        let values = complex.f_vector().into_iter().enumerate().map(of_degree).collect();
        Self { complex, values }
    }

    /// The simplices that enter at a value or before and are in no larger one that does, by their points: those of the highest dimension first.
    ///
    /// # Complexity
    /// As of [`Self::up_to`].
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::filtered::{FilteredComplex, WeightedGraph};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let graph = WeightedGraph::new(vec![0.0; 3], [(0, 1, 3.0), (1, 2, 4.0), (0, 2, 5.0)])?;
    /// let triangle = FilteredComplex::flag(&graph, f64::INFINITY, 2)?;
    /// assert_eq!(triangle.facets_up_to(3.0).iter().collect::<Vec<_>>(), [&[0, 1][..], &[2]]);
    /// assert_eq!(triangle.facets_up_to(5.0).iter().collect::<Vec<_>>(), [[0, 1, 2]]);
    /// # Ok(()) }
    /// ```
    pub fn facets_up_to(&self, bound: f64) -> RaggedArray {
        let mut facets = RaggedArray::new();
        let mut is_covered: Vec<bool> = Vec::new();
        for degree in (0..self.values.len()).rev() {
            let below = degree.checked_sub(1).map_or(0, |below| self.complex.simplex_count(below));
            let mut is_covered_below = vec![false; below];
            for (i, _) in self.values[degree].iter().enumerate().filter(|&(_, &value)| value <= bound) {
                let is_facet = !is_covered.get(i).copied().unwrap_or(false);
                if is_facet {
                    facets.push(self.complex.numbers(degree, i));
                }
                for (_, face) in self.complex.facets(degree, i) {
                    is_covered_below[face] = true;
                }
            }
            is_covered = is_covered_below;
        }
        facets
    }

    /// The same with other values, each a function of the old one that does not fall.
    pub(crate) fn map_values(mut self, map: impl Fn(f64) -> f64) -> Self {
        self.values.iter_mut().flatten().for_each(|value| *value = map(*value));
        self
    }

    /// The values of all degrees.
    pub(crate) fn all_values(&self) -> impl Iterator<Item = f64> + '_ {
        self.values.iter().flatten().copied()
    }
}
