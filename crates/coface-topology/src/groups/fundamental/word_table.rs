//! Words stored once each, with their inverses beside them.

use coface_algebra::Word;
use std::collections::HashMap;

/// The number of the empty word.
pub(super) const UNIT: u32 = 0;

/// Many words of which most are equal or inverse to others: each is a number, that of its inverse differs in the last
/// bit, and the empty word is 0.
#[derive(Clone, Debug)]
pub(super) struct WordTable {
    /// Word 2k at position k.
    words: Vec<Word>,
    numbers: HashMap<Word, u32>,
    products: HashMap<(u32, u32), u32>,
}

impl WordTable {
    pub(super) fn new() -> Self {
        Self { words: vec![Word::new()], numbers: HashMap::new(), products: HashMap::new() }
    }

    /// The number of a word; new words get the next one.
    pub(super) fn insert(&mut self, word: Word) -> u32 {
        if word.is_empty() {
            return UNIT;
        }
        if let Some(&number) = self.numbers.get(&word) {
            return number;
        }
        let number = 2 * self.words.len() as u32;
        self.numbers.insert(word.inverse(), number + 1);
        self.numbers.insert(word.clone(), number);
        self.words.push(word);
        number
    }

    /// The number of the inverse.
    pub(super) fn inverse(number: u32) -> u32 {
        if number == UNIT { UNIT } else { number ^ 1 }
    }

    /// The number of letters of a word.
    pub(super) fn len(&self, number: u32) -> usize {
        self.words[number as usize / 2].len()
    }

    /// The word with this number.
    pub(super) fn word(&self, number: u32) -> Word {
        let word = &self.words[number as usize / 2];
        if number & 1 == 0 { word.clone() } else { word.inverse() }
    }

    /// The number of the product of two words; `None` if it would have more than `longest` letters.
    pub(super) fn product(&mut self, a: u32, b: u32, longest: usize) -> Option<u32> {
        if a == UNIT || b == UNIT || a == Self::inverse(b) {
            return Some(if a == UNIT {
                b
            } else if b == UNIT {
                a
            } else {
                UNIT
            });
        }
        if let Some(&product) = self.products.get(&(a, b)) {
            return Some(product);
        }
        let word = self.word(a).times(&self.word(b));
        if word.len() > longest {
            return None;
        }
        let product = self.insert(word);
        self.products.insert((a, b), product);
        Some(product)
    }

    /// Replaces the letters of all words, keeping their numbers. Nothing can be inserted after.
    pub(super) fn into_words(self, mut rename: impl FnMut(i32) -> i32) -> Vec<Word> {
        let renamed = |word: Word| Word::from_letters(word.letters().iter().map(|&letter| rename(letter)));
        self.words.into_iter().map(renamed).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_and_inverses_share_a_place() {
        let mut table = WordTable::new();
        let (a, b) = (table.insert(Word::from_letters([1])), table.insert(Word::from_letters([2])));
        let ab = table.product(a, b, 9).unwrap();
        assert_eq!(table.word(ab).letters(), [1, 2]);
        let inverse = table.product(WordTable::inverse(b), WordTable::inverse(a), 9).unwrap();
        assert_eq!(inverse, WordTable::inverse(ab));
        assert_eq!(table.product(ab, WordTable::inverse(b), 9), Some(a));
        assert_eq!(table.product(ab, inverse, 9), Some(UNIT));
        assert_eq!((table.product(ab, ab, 3), table.len(inverse)), (None, 2));
        assert_eq!(table.insert(Word::new()), UNIT);
        assert_eq!(table.into_words(|letter| -letter)[1].letters(), [-1]);
    }
}
