//! Permutations of `0..n`.

use crate::Sign;
use crate::error::{Error, ErrorKind, Fault};
use crate::ids::narrow;
use std::fmt;

/// A permutation of `0..n`: i goes to `image(i)`.
///
/// # Examples
/// ```
/// use coface_algebra::{Permutation, Sign};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let turn = Permutation::from_images(vec![1, 2, 0, 3])?;
/// assert_eq!(turn.to_string(), "(0 1 2)");
/// assert_eq!(turn.sign(), Sign::Plus);
/// assert_eq!(turn.then(&turn), turn.inverse());
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Permutation {
    images: Vec<u32>,
}

impl Permutation {
    /// The permutation that leaves all `count` numbers where they are.
    ///
    /// # Panics
    /// Beyond 2^32 - 1 numbers.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Permutation;
    /// assert_eq!(Permutation::identity(3).images(), [0, 1, 2]);
    /// ```
    pub fn identity(count: usize) -> Self {
        Self {
            images: (0..u32::try_from(count).expect("a permutation is of fewer than 2^32 numbers")).collect(),
        }
    }

    /// The permutation with these images of 0, 1, ...
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] naming the first image that is out of range or repeated.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Permutation;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(Permutation::from_images(vec![1, 0])?.to_string(), "(0 1)");
    /// assert!(Permutation::from_images(vec![1, 1]).is_err());
    /// # Ok(()) }
    /// ```
    pub fn from_images(images: Vec<u32>) -> Result<Self, Error> {
        let mut is_met = vec![false; images.len()];
        for (i, &image) in images.iter().enumerate() {
            match is_met.get_mut(image as usize) {
                Some(met) if !*met => *met = true,
                fault => {
                    let (count, is_repeated) = (images.len(), fault.is_some());
                    let reason =
                        if is_repeated { "is the image of an earlier number too" } else { "is out of range" };
                    let message =
                        format!("no permutation of {count} numbers: the image {image} of {i} {reason}");
                    let error = Error::new(ErrorKind::InvalidInput, message);
                    return Err(if is_repeated {
                        error
                    } else {
                        error.with_fault(Fault::OutOfRange { index: image as usize, count })
                    });
                }
            }
        }
        Ok(Self { images })
    }

    /// The permutation that sorts a list: the item at place i goes to place `image(i)`. Equal items keep their order.
    ///
    /// Its sign relates an ordered list of vertices to the sorted one.
    ///
    /// # Panics
    /// Beyond 2^32 - 1 items.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{Permutation, Sign};
    /// assert_eq!(Permutation::sorting(&[7, 2, 5]).images(), [2, 0, 1]);
    /// assert_eq!(Permutation::sorting(&[2, 7, 5]).sign(), Sign::Minus);
    /// ```
    pub fn sorting<T: Ord>(items: &[T]) -> Self {
        let mut order = Self::identity(items.len()).images;
        order.sort_by_key(|&i| &items[i as usize]);
        Self { images: order }.inverse()
    }

    /// The number of numbers that are permuted.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_algebra::Permutation::identity(3).len(), 3);
    /// ```
    pub fn len(&self) -> usize {
        self.images.len()
    }

    /// Whether there is nothing to permute.
    ///
    /// # Examples
    /// ```
    /// assert!(coface_algebra::Permutation::identity(0).is_empty());
    /// ```
    pub fn is_empty(&self) -> bool {
        self.images.is_empty()
    }

    /// Whether every number stays where it is.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Permutation;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let swap = Permutation::from_images(vec![1, 0])?;
    /// assert!(!swap.is_identity() && swap.then(&swap).is_identity());
    /// # Ok(()) }
    /// ```
    pub fn is_identity(&self) -> bool {
        self.images.iter().enumerate().all(|(i, &image)| i == image as usize)
    }

    /// Where i goes.
    ///
    /// # Panics
    /// If `i` is not below [`Self::len`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Permutation;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(Permutation::from_images(vec![2, 0, 1])?.image(0), 2);
    /// # Ok(()) }
    /// ```
    pub fn image(&self, i: usize) -> usize {
        self.images[i] as usize
    }

    /// The images of 0, 1, ...
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Permutation;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(Permutation::from_images(vec![2, 0, 1])?.images(), [2, 0, 1]);
    /// # Ok(()) }
    /// ```
    pub fn images(&self) -> &[u32] {
        &self.images
    }

    /// The permutation that undoes this one.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Permutation;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(Permutation::from_images(vec![2, 0, 1])?.inverse().images(), [1, 2, 0]);
    /// # Ok(()) }
    /// ```
    #[must_use]
    pub fn inverse(&self) -> Self {
        let mut images = vec![0; self.len()];
        for (i, &image) in self.images.iter().enumerate() {
            images[image as usize] = narrow(i);
        }
        Self { images }
    }

    /// This permutation first, then `next`: i goes to `next.image(self.image(i))`.
    ///
    /// # Panics
    /// If the two are of different lengths.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Permutation;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let (turn, swap) = (Permutation::from_images(vec![1, 2, 0])?, Permutation::from_images(vec![1, 0, 2])?);
    /// // 0 goes to 1 by the turn, then to 0 by the swap.
    /// assert_eq!(turn.then(&swap).images(), [0, 2, 1]);
    /// # Ok(()) }
    /// ```
    #[must_use]
    pub fn then(&self, next: &Self) -> Self {
        assert_eq!(self.len(), next.len(), "permutations of one length are composed");
        Self { images: self.images.iter().map(|&image| next.images[image as usize]).collect() }
    }

    /// The cycles of two or more numbers, each from its least number on, in the order of those.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Permutation;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(Permutation::from_images(vec![3, 2, 1, 0])?.cycles(), [[0, 3], [1, 2]]);
    /// # Ok(()) }
    /// ```
    pub fn cycles(&self) -> Vec<Vec<u32>> {
        let mut is_met = vec![false; self.len()];
        let mut cycles = Vec::new();
        for start in 0..self.len() {
            let mut cycle = Vec::new();
            let mut at = start;
            while !is_met[at] {
                is_met[at] = true;
                cycle.push(narrow(at));
                at = self.image(at);
            }
            if cycle.len() > 1 {
                cycles.push(cycle);
            }
        }
        cycles
    }

    /// Plus for an even number of transpositions, minus for an odd one.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{Permutation, Sign};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(Permutation::from_images(vec![1, 0, 2])?.sign(), Sign::Minus);
    /// # Ok(()) }
    /// ```
    pub fn sign(&self) -> Sign {
        Sign::power_of_minus_one(self.cycles().iter().map(|cycle| cycle.len() - 1).sum())
    }
}

impl fmt::Display for Permutation {
    /// The cycles of two or more numbers, `()` for the identity.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let cycles = self.cycles();
        if cycles.is_empty() {
            return f.write_str("()");
        }
        for cycle in cycles {
            let numbers: Vec<String> = cycle.iter().map(u32::to_string).collect();
            write!(f, "({})", numbers.join(" "))?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn permutations(count: u32) -> impl Strategy<Value = Permutation> {
        Just((0..count).collect::<Vec<_>>())
            .prop_shuffle()
            .prop_map(|images| Permutation::from_images(images).unwrap())
    }

    proptest! {
        #[test]
        fn the_sign_counts_inversions(p in permutations(7), q in permutations(7)) {
            let inversions = (0..7).flat_map(|j| (0..j).map(move |i| (i, j))).filter(|&(i, j)| p.image(i) > p.image(j));
            prop_assert_eq!(p.sign(), Sign::power_of_minus_one(inversions.count()));
            prop_assert_eq!(p.then(&q).sign(), p.sign().times(q.sign()));
            prop_assert!(p.then(&p.inverse()).is_identity() && p.inverse().then(&p).is_identity());
            prop_assert_eq!(p.then(&q).inverse(), q.inverse().then(&p.inverse()));
        }

        #[test]
        fn sorting_sorts(items in prop::collection::vec(0u8..6, 0..8)) {
            let permutation = Permutation::sorting(&items);
            let mut moved = items.clone();
            for (i, &item) in items.iter().enumerate() {
                moved[permutation.image(i)] = item;
            }
            prop_assert!(moved.is_sorted());
            for j in 1..items.len() {
                prop_assert!(items[j - 1] != items[j] || permutation.image(j - 1) < permutation.image(j));
            }
        }
    }

    #[test]
    fn faults_are_named() {
        let message =
            |images: &[u32]| Permutation::from_images(images.to_vec()).unwrap_err().message().to_owned();
        assert_eq!(message(&[0, 2]), "no permutation of 2 numbers: the image 2 of 1 is out of range");
        assert!(message(&[1, 1]).ends_with("the image 1 of 1 is the image of an earlier number too"));
        assert_eq!(Permutation::identity(0).to_string(), "()");
    }
}
