//! Lists of oriented simplices: sorted vertices and a sign.

use super::lists::in_list;
use super::simplex::repeated;
use coface_algebra::Error;
use coface_algebra::{Permutation, RaggedArray, Sign};

/// A list of oriented simplices: each one its rising vertices and a sign, minus where its orientation is opposite to that
/// of the rising order. Simplices may repeat, and their dimensions may differ.
///
/// Rising lists make simplices that share a face agree on its order, so that prisms over them fit together.
///
/// # Examples
/// ```
/// use coface_algebra::{RaggedArray, Sign};
/// use coface_complexes::simplicial::SignedSimplices;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let triangles = SignedSimplices::new(&RaggedArray::from_lists([[0, 1, 2], [2, 1, 3]]))?;
/// assert_eq!(triangles.lists().list(1), [1, 2, 3]);
/// assert_eq!(triangles.signs(), [Sign::Plus, Sign::Minus]);
/// assert_eq!(triangles.to_oriented().list(1), [2, 1, 3]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct SignedSimplices {
    lists: RaggedArray,
    signs: Vec<Sign>,
}

impl SignedSimplices {
    /// The simplices with these vertices, whose order is the orientation: two orders that differ by an even permutation
    /// are the same.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) naming the first list without a vertex or with a
    /// repeated one.
    ///
    /// # Complexity
    /// Linear for simplices of a few vertices; those of many vertices are sorted.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::simplicial::SignedSimplices;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = SignedSimplices::new(&RaggedArray::from_lists([[1, 0, 2]]))?;
    /// assert_eq!(triangle.lists().list(0), [0, 1, 2]);
    /// # Ok(()) }
    /// ```
    pub fn new(simplices: &RaggedArray) -> Result<Self, Error> {
        let mut lists = simplices.clone();
        let mut signs = Vec::with_capacity(lists.len());
        for i in 0..simplices.len() {
            let own = &mut lists.items_mut()[simplices.start(i)..simplices.start(i + 1)];
            signs.push(sort_with_sign(own));
            if own.is_empty() {
                return Err(Error::invalid(format!("list {i} has no vertex"))
                    .with_cure("name at least one vertex in each simplex"));
            }
            if let Some(pair) = own.windows(2).find(|pair| pair[0] == pair[1]) {
                return Err(in_list(&repeated(pair[0], simplices.list(i)), i));
            }
        }
        Ok(Self { lists, signs })
    }

    /// Simplices that a rule has made with rising vertices.
    pub(crate) fn from_trusted(lists: RaggedArray, signs: Vec<Sign>) -> Self {
        debug_assert_eq!(lists.len(), signs.len());
        debug_assert!(lists.iter().all(|list| !list.is_empty() && list.is_sorted_by(|a, b| a < b)));
        Self { lists, signs }
    }

    /// The vertices of each simplex, rising.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::simplicial::SignedSimplices;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = SignedSimplices::new(&RaggedArray::from_lists([[1, 0, 2]]))?;
    /// assert_eq!(triangle.lists().list(0), [0, 1, 2]);
    /// # Ok(()) }
    /// ```
    pub fn lists(&self) -> &RaggedArray {
        &self.lists
    }

    /// The sign of each simplex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::simplicial::SignedSimplices;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = SignedSimplices::new(&RaggedArray::from_lists([[1, 0, 2]]))?;
    /// assert_eq!(triangle.signs(), [coface_algebra::Sign::Minus]);
    /// # Ok(()) }
    /// ```
    pub fn signs(&self) -> &[Sign] {
        &self.signs
    }

    /// The number of simplices.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::simplicial::SignedSimplices;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = SignedSimplices::new(&RaggedArray::from_lists([[1, 0, 2]]))?;
    /// assert_eq!(triangle.len(), 1);
    /// # Ok(()) }
    /// ```
    pub fn len(&self) -> usize {
        self.signs.len()
    }

    /// Whether there is no simplex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::simplicial::SignedSimplices;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = SignedSimplices::new(&RaggedArray::from_lists([[1, 0, 2]]))?;
    /// assert!(!triangle.is_empty());
    /// # Ok(()) }
    /// ```
    pub fn is_empty(&self) -> bool {
        self.signs.is_empty()
    }

    /// The simplices as lists whose order is the orientation: the first two vertices are swapped where the sign is minus.
    /// A single vertex has one order only, so its sign is lost.
    pub fn to_oriented(&self) -> RaggedArray {
        let mut lists = self.lists.clone();
        for (i, _) in self.signs.iter().enumerate().filter(|&(_, &sign)| sign == Sign::Minus) {
            let start = lists.start(i);
            if lists.start(i + 1) - start > 1 {
                lists.items_mut().swap(start, start + 1);
            }
        }
        lists
    }

    /// The rising lists alone.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::simplicial::SignedSimplices;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = SignedSimplices::new(&RaggedArray::from_lists([[1, 0, 2]]))?;
    /// assert_eq!(triangle.into_lists().list(0), [0, 1, 2]);
    /// # Ok(()) }
    /// ```
    pub fn into_lists(self) -> RaggedArray {
        self.lists
    }
}

/// Sorts a list and gives the sign of the permutation; equal numbers count as being in order.
pub(super) fn sort_with_sign(list: &mut [u32]) -> Sign {
    if list.len() > 32 {
        let sign = Permutation::sorting(list).sign();
        list.sort_unstable();
        return sign;
    }
    let mut swaps = 0;
    for end in 1..list.len() {
        let mut at = end;
        while at > 0 && list[at - 1] > list[at] {
            list.swap(at - 1, at);
            at -= 1;
            swaps += 1;
        }
    }
    Sign::power_of_minus_one(swaps)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_sign_is_that_of_the_permutation(list in prop::collection::vec(0u32..1000, 0..60)) {
            let mut sorted = list.clone();
            let sign = sort_with_sign(&mut sorted);
            prop_assert!(sorted.is_sorted());
            prop_assert_eq!(sign, Permutation::sorting(&list).sign());
        }

        #[test]
        fn orders_and_signs_tell_the_same(lists in prop::collection::vec(prop::collection::btree_set(0u32..99, 2..6), 0..9)) {
            let given = RaggedArray::from_lists(lists.iter().map(|list| list.iter().rev().copied().collect::<Vec<_>>()));
            let signed = SignedSimplices::new(&given).unwrap();
            prop_assert_eq!(&SignedSimplices::new(&signed.to_oriented()).unwrap(), &signed);
            for (list, (own, &sign)) in lists.iter().zip(signed.lists().iter().zip(signed.signs())) {
                prop_assert!(list.iter().eq(own));
                prop_assert_eq!(sign, Sign::power_of_minus_one(list.len() * (list.len() - 1) / 2));
            }
        }
    }

    #[test]
    fn lists_that_are_no_simplices_are_named() {
        let message = |lists: &[&[u32]]| {
            SignedSimplices::new(&RaggedArray::from_lists(lists)).unwrap_err().message().to_owned()
        };
        assert!(message(&[&[0, 1], &[]]).contains("list 1"));
        assert!(message(&[&[0, 1], &[7, 3, 7]]).contains("vertex 7 is repeated"));
        assert!(SignedSimplices::new(&RaggedArray::new()).unwrap().is_empty());
    }
}
