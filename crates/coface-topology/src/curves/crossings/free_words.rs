//! Elements of a free group as numbers, so that equal ones are equal numbers.

use std::collections::HashMap;

/// The number of the neutral element.
pub(super) const NEUTRAL: u32 = 0;

/// The elements of a free group that were met so far, with the products that were asked for.
#[derive(Debug)]
pub(super) struct FreeWords {
    words: Vec<Box<[i32]>>,
    numbers: HashMap<Box<[i32]>, u32>,
    products: HashMap<(u32, u32), u32>,
}

impl FreeWords {
    pub(super) fn new() -> Self {
        let empty: Box<[i32]> = Box::new([]);
        let numbers = HashMap::from([(empty.clone(), NEUTRAL)]);
        Self { words: vec![empty], numbers, products: HashMap::new() }
    }

    /// The number of a word: letter i is generator i, -i its inverse.
    pub(super) fn number(&mut self, letters: &[i32]) -> u32 {
        if letters.is_empty() {
            return NEUTRAL;
        }
        self.reduced(letters.iter().copied())
    }

    pub(super) fn times(&mut self, a: u32, b: u32) -> u32 {
        match (a, b) {
            (a, NEUTRAL) => return a,
            (NEUTRAL, b) => return b,
            _ => {}
        }
        if let Some(&known) = self.products.get(&(a, b)) {
            return known;
        }
        let letters: Vec<i32> =
            self.words[a as usize].iter().chain(&*self.words[b as usize]).copied().collect();
        let product = self.reduced(letters.into_iter());
        self.products.insert((a, b), product);
        product
    }

    pub(super) fn inverse(&mut self, a: u32) -> u32 {
        if a == NEUTRAL {
            return NEUTRAL;
        }
        let letters: Vec<i32> = self.words[a as usize].iter().rev().map(|letter| -letter).collect();
        self.reduced(letters.into_iter())
    }

    fn reduced(&mut self, letters: impl Iterator<Item = i32>) -> u32 {
        let mut word: Vec<i32> = Vec::new();
        for letter in letters {
            if word.last() == Some(&-letter) {
                word.pop();
            } else {
                word.push(letter);
            }
        }
        let word = word.into_boxed_slice();
        if let Some(&known) = self.numbers.get(&word) {
            return known;
        }
        let number = self.words.len() as u32;
        self.words.push(word.clone());
        self.numbers.insert(word, number);
        number
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_elements_have_equal_numbers() {
        let mut words = FreeWords::new();
        let [a, b] = [1, 2].map(|letter| words.number(&[letter]));
        let ab = words.times(a, b);
        assert_eq!(words.number(&[1, 3, -3, 2]), ab);
        let back = words.inverse(ab);
        assert_eq!(words.times(ab, back), NEUTRAL);
        assert_ne!(words.times(b, a), ab);
        let again = words.inverse(b);
        assert_eq!(words.times(ab, again), a);
    }
}
