//! Words of free groups.

use std::fmt;

/// An element of a free group: a freely reduced word in letters +1, -1, +2, -2, ..., where -i is the inverse of i.
///
/// # Examples
/// ```
/// use coface_algebra::Word;
/// let word = Word::from_letters([1, 2, -2, 1, -3]);
/// assert_eq!(word.letters(), [1, 1, -3]);
/// assert_eq!(word.to_string(), "x1^2 x3^-1");
/// assert!(word.times(&word.inverse()).is_empty());
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Word {
    letters: Vec<i32>,
}

impl Word {
    /// The empty word: the unit of the group.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_algebra::Word::new().to_string(), "1");
    /// ```
    pub const fn new() -> Self {
        Self { letters: Vec::new() }
    }

    /// The word with these letters, freely reduced.
    ///
    /// # Panics
    /// If a letter is 0.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// assert_eq!(Word::from_letters([1, 2, -2, -1, 3]).letters(), [3]);
    /// ```
    pub fn from_letters(letters: impl IntoIterator<Item = i32>) -> Self {
        let mut word = Self::new();
        for letter in letters {
            word.push(letter);
        }
        word
    }

    /// The letters, no two neighbors inverse to each other.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// assert_eq!(Word::from_letters([1, -2]).letters(), [1, -2]);
    /// ```
    pub fn letters(&self) -> &[i32] {
        &self.letters
    }

    /// The number of letters.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// assert_eq!(Word::from_letters([1, 1, -2]).len(), 3);
    /// ```
    pub fn len(&self) -> usize {
        self.letters.len()
    }

    /// Whether this is the unit.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// assert!(Word::from_letters([1, -1]).is_empty());
    /// ```
    pub fn is_empty(&self) -> bool {
        self.letters.is_empty()
    }

    /// Multiplies by a letter from the right.
    ///
    /// # Panics
    /// If the letter is 0.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// let mut word = Word::from_letters([1, 2]);
    /// word.push(-2);
    /// assert_eq!(word.letters(), [1]);
    /// ```
    pub fn push(&mut self, letter: i32) {
        assert_ne!(letter, 0, "letters are +1, -1, +2, -2, ...");
        if self.letters.last() == Some(&-letter) {
            self.letters.pop();
        } else {
            self.letters.push(letter);
        }
    }

    /// Multiplies by a word from the right.
    ///
    /// # Complexity
    /// Linear in the other word.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// let mut word = Word::from_letters([1, 2]);
    /// word.append(&Word::from_letters([-2, 3]));
    /// assert_eq!(word.letters(), [1, 3]);
    /// ```
    pub fn append(&mut self, other: &Self) {
        let cancelled =
            self.letters.iter().rev().zip(&other.letters).take_while(|(a, b)| **a == -**b).count();
        self.letters.truncate(self.letters.len() - cancelled);
        self.letters.extend_from_slice(&other.letters[cancelled..]);
    }

    /// The product, this word first.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// assert_eq!(Word::from_letters([1, 2]).times(&Word::from_letters([-2, 3])).letters(), [1, 3]);
    /// ```
    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        let mut product = self.clone();
        product.append(other);
        product
    }

    /// The inverse: the inverse letters backwards.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// assert_eq!(Word::from_letters([1, -2]).inverse().letters(), [2, -1]);
    /// ```
    #[must_use]
    pub fn inverse(&self) -> Self {
        Self { letters: self.letters.iter().rev().map(|letter| -letter).collect() }
    }

    /// The power with this exponent, which may be negative or 0.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// assert_eq!(Word::from_letters([1, 2, -1]).power(-3).letters(), [1, -2, -2, -2, -1]);
    /// ```
    #[must_use]
    pub fn power(&self, exponent: i32) -> Self {
        let factor = if exponent < 0 { self.inverse() } else { self.clone() };
        let mut power = Self::new();
        for _ in 0..exponent.unsigned_abs() {
            power.append(&factor);
        }
        power
    }

    /// The commutator $u v u^{-1} v^{-1}$ of this word u with v.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// let (a, b) = (Word::from_letters([1]), Word::from_letters([2]));
    /// assert_eq!(a.commutator(&b).letters(), [1, 2, -1, -2]);
    /// ```
    #[must_use]
    pub fn commutator(&self, other: &Self) -> Self {
        self.times(other).times(&self.inverse()).times(&other.inverse())
    }

    /// The cyclically reduced conjugate: what is left when inverse letters at both ends are removed.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// assert_eq!(Word::from_letters([1, 2, 3, -1]).cyclically_reduced().letters(), [2, 3]);
    /// ```
    #[must_use]
    pub fn cyclically_reduced(&self) -> Self {
        let n = self.letters.len();
        let ends = (0..n / 2).take_while(|&i| self.letters[i] == -self.letters[n - 1 - i]).count();
        Self { letters: self.letters[ends..n - ends].to_vec() }
    }

    /// One word for all cyclic conjugates of this word and its inverse: the least rotation of the cyclically reduced
    /// word or of its inverse. Two relators with the same form are equivalent.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # References
    /// K. S. Booth, *Lexicographically least circular substrings* (1980).
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// let (word, rotated) = (Word::from_letters([2, 1, -2, 1]), Word::from_letters([-1, 2, -1, -2]));
    /// assert_eq!(word.cyclic_form(), rotated.cyclic_form());
    /// ```
    #[must_use]
    pub fn cyclic_form(&self) -> Self {
        let word = self.cyclically_reduced();
        let inverse = word.inverse();
        let [a, b] = [least_rotation(word.letters), least_rotation(inverse.letters)];
        Self { letters: a.min(b) }
    }

    /// The word with each letter +i replaced by `images[i - 1]` and -i by its inverse.
    ///
    /// # Panics
    /// If a letter has no image.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// let images = [Word::from_letters([2, 2]), Word::from_letters([-1])];
    /// assert_eq!(Word::from_letters([1, -2]).image(&images).letters(), [2, 2, 1]);
    /// ```
    #[must_use]
    pub fn image(&self, images: &[Self]) -> Self {
        let mut word = Self::new();
        for &letter in &self.letters {
            let image = &images[letter.unsigned_abs() as usize - 1];
            if letter > 0 {
                word.append(image);
            } else {
                word.append(&image.inverse());
            }
        }
        word
    }

    /// The sum of the exponents of each of the letters 1, ..., `count`: the word in the free abelian group.
    ///
    /// # Panics
    /// If a letter is beyond `count`.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// assert_eq!(Word::from_letters([1, 2, 1, -2]).exponent_sums(2), [2, 0]);
    /// ```
    pub fn exponent_sums(&self, count: usize) -> Vec<i64> {
        let mut sums = vec![0; count];
        for &letter in &self.letters {
            sums[letter.unsigned_abs() as usize - 1] += i64::from(letter.signum());
        }
        sums
    }

    /// The greatest letter without its sign; 0 for the empty word.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// assert_eq!(Word::from_letters([1, -4, 2]).highest_letter(), 4);
    /// ```
    pub fn highest_letter(&self) -> usize {
        self.letters.iter().map(|letter| letter.unsigned_abs() as usize).max().unwrap_or(0)
    }
}

/// The least of all rotations of a list.
pub fn least_rotation<T: Ord>(mut letters: Vec<T>) -> Vec<T> {
    let n = letters.len();
    let (mut best, mut rival, mut same) = (0, 1, 0);
    while best < n && rival < n && same < n {
        match letters[(best + same) % n].cmp(&letters[(rival + same) % n]) {
            std::cmp::Ordering::Equal => same += 1,
            std::cmp::Ordering::Less => {
                rival += same + 1;
                same = 0;
            }
            std::cmp::Ordering::Greater => {
                best += same + 1;
                same = 0;
            }
        }
        if best == rival {
            rival += 1;
        }
    }
    letters.rotate_left(best.min(rival));
    letters
}

/// Generators as `x1`, `x2`, ..., powers collected; the unit as `1`.
impl fmt::Display for Word {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_empty() {
            return f.write_str("1");
        }
        for (i, run) in self.letters.chunk_by(|a, b| a == b).enumerate() {
            f.write_str(if i > 0 { " " } else { "" })?;
            write!(f, "x{}", run[0].unsigned_abs())?;
            let exponent = run.len() as i64 * i64::from(run[0].signum());
            if exponent != 1 {
                write!(f, "^{exponent}")?;
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn words() -> impl Strategy<Value = Word> {
        let letter = (1..4i32, any::<bool>()).prop_map(|(i, negative)| if negative { -i } else { i });
        prop::collection::vec(letter, 0..14).prop_map(Word::from_letters)
    }

    proptest! {
        #[test]
        fn words_are_a_group(a in words(), b in words(), c in words()) {
            prop_assert_eq!(a.times(&b).times(&c), a.times(&b.times(&c)));
            prop_assert!(a.times(&a.inverse()).is_empty());
            prop_assert_eq!(a.times(&b).inverse(), b.inverse().times(&a.inverse()));
            prop_assert_eq!(a.power(2).times(&a.power(-3)), a.inverse());
            let product = a.times(&b);
            prop_assert!(product.letters().windows(2).all(|pair| pair[0] != -pair[1]));
            let images = [b.clone(), c, a.clone()];
            prop_assert_eq!(a.times(&b).image(&images), a.image(&images).times(&b.image(&images)));
        }

        #[test]
        fn cyclic_forms_are_those_of_conjugates(a in words(), b in words()) {
            let conjugate = b.times(&a).times(&b.inverse());
            prop_assert_eq!(conjugate.cyclic_form(), a.cyclic_form());
            prop_assert_eq!(a.inverse().cyclic_form(), a.cyclic_form());
            // Against trying all rotations.
            let reduced = a.cyclically_reduced();
            let rotations = [reduced.clone(), reduced.inverse()].into_iter().flat_map(|word| {
                (0..word.len().max(1)).map(move |k| {
                    let mut letters = word.letters.clone();
                    letters.rotate_left(k);
                    letters
                })
            });
            prop_assert_eq!(a.cyclic_form().letters, rotations.min().unwrap());
        }
    }

    #[test]
    fn words_are_printed_with_powers() {
        assert_eq!(Word::new().to_string(), "1");
        assert_eq!(Word::from_letters([-1, -1, 2]).to_string(), "x1^-2 x2");
        assert_eq!(Word::from_letters([2, 1, -2]).exponent_sums(3), [1, 0, 0]);
    }
}
