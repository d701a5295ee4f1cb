//! Groups by generators and relators.

use crate::homology::AbelianGroup;
use coface_algebra::{Error, ErrorKind};
use coface_algebra::{SparseMatrix, Word, invariant_factors};
use std::fmt;

/// A group given by generators 1, ..., n and relators: words in them that are the unit.
///
/// # Examples
/// The Klein bottle group:
/// ```
/// use coface_algebra::Word;
/// use coface_topology::Presentation;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let klein = Presentation::new(2, vec![Word::from_letters([1, 2, 1, -2])])?;
/// assert_eq!(klein.to_string(), "<x1, x2 | x1 x2 x1 x2^-1>");
/// assert_eq!(klein.abelianization().to_string(), "Z + Z/2");
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Presentation {
    generator_count: usize,
    relators: Vec<Word>,
}

impl Presentation {
    /// The group with so many generators and these relators.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] naming the first relator with a letter that is no generator.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::Presentation;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let klein = Presentation::new(2, vec![Word::from_letters([1, 2, 1, -2])])?;
    /// assert_eq!(klein.to_string(), "<x1, x2 | x1 x2 x1 x2^-1>");
    /// assert!(Presentation::new(1, vec![Word::from_letters([2])]).is_err());
    /// # Ok(()) }
    /// ```
    pub fn new(generator_count: usize, relators: Vec<Word>) -> Result<Self, Error> {
        match relators.iter().position(|relator| relator.highest_letter() > generator_count) {
            None => Ok(Self { generator_count, relators }),
            Some(i) => Err(Error::new(
                ErrorKind::InvalidInput,
                format!(
                    "relator {i} has the letter {}, but there are {generator_count} generators",
                    relators[i].highest_letter()
                ),
            )),
        }
    }

    /// The number of generators.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::Presentation;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let klein = Presentation::new(2, vec![Word::from_letters([1, 2, 1, -2])])?;
    /// assert_eq!(klein.generator_count(), 2);
    /// # Ok(()) }
    /// ```
    pub fn generator_count(&self) -> usize {
        self.generator_count
    }

    /// The relators.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::Presentation;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let klein = Presentation::new(2, vec![Word::from_letters([1, 2, 1, -2])])?;
    /// assert_eq!(klein.relators()[0].letters(), [1, 2, 1, -2]);
    /// # Ok(()) }
    /// ```
    pub fn relators(&self) -> &[Word] {
        &self.relators
    }

    /// The number of letters of all relators.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::Presentation;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let klein = Presentation::new(2, vec![Word::from_letters([1, 2, 1, -2])])?;
    /// assert_eq!(klein.length(), 4);
    /// # Ok(()) }
    /// ```
    pub fn length(&self) -> usize {
        self.relators.iter().map(Word::len).sum()
    }

    /// The group made commutative, by Smith normal form of the exponent sums. For a fundamental group it is H_1.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::Presentation;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let klein = Presentation::new(2, vec![Word::from_letters([1, 2, 1, -2])])?;
    /// assert_eq!(klein.abelianization().to_string(), "Z + Z/2");
    /// # Ok(()) }
    /// ```
    pub fn abelianization(&self) -> AbelianGroup {
        let entries = self.relators.iter().enumerate().flat_map(|(column, relator)| {
            let letters = relator.letters().iter();
            letters
                .map(move |letter| (letter.unsigned_abs() as usize - 1, column, i64::from(letter.signum())))
        });
        let matrix = SparseMatrix::from_entries(self.generator_count, self.relators.len(), entries)
            .expect("relators have fewer than 2^31 letters");
        let factors = invariant_factors(&matrix);
        AbelianGroup::new(self.generator_count - factors.len(), factors)
    }
}

impl fmt::Display for Presentation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let generators: Vec<String> = (1..=self.generator_count).map(|i| format!("x{i}")).collect();
        let relators: Vec<String> = self.relators.iter().map(Word::to_string).collect();
        write!(f, "<{} | {}>", generators.join(", "), relators.join(", "))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_groups_have_known_abelianizations() {
        let table: [(usize, &[&[i32]], &str); 5] = [
            (0, &[], "0"),
            (3, &[], "Z^3"),
            (2, &[&[1, 2, -1, -2]], "Z^2"),
            (2, &[&[1, 1, 2, 2, 2], &[2, 2, 2, 2]], "Z/8"),
            (2, &[&[1, 2, 1, -2, -1, -2]], "Z"),
        ];
        for (count, relators, expected) in table {
            let relators =
                relators.iter().map(|letters| Word::from_letters(letters.iter().copied())).collect();
            let group = Presentation::new(count, relators).unwrap();
            assert_eq!(group.abelianization().to_string(), expected, "{group}");
        }
        let error = Presentation::new(1, vec![Word::from_letters([1, -2])]).unwrap_err();
        assert_eq!(error.message(), "relator 0 has the letter 2, but there are 1 generators");
    }
}
