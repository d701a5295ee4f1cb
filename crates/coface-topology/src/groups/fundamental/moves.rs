//! Tietze moves: the steps that change a presentation and keep its group.

use coface_algebra::Word;
use coface_algebra::{Error, ErrorKind};
use std::collections::BTreeSet;

/// One step of a simplification. Generators and relators keep their numbers while the steps are done; relators are
/// cyclically reduced, and one that is gone is empty.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum TietzeMove {
    /// A relator is removed because it is equivalent to another: both have one cyclic form, or their inverses do.
    Duplicate {
        /// The relator that goes.
        relator: u32,
        /// The relator that stays.
        like: u32,
    },
    /// In a relator a part u is replaced by the inverse of v, where uv is a rotation of another relator or its inverse.
    Rewrite {
        /// The relator that changes.
        relator: u32,
        /// Where u starts in it; it may run over the end.
        at: u32,
        /// The other relator.
        by: u32,
        /// Whether it is inverted.
        inverted: bool,
        /// Where u starts in the other relator, after the inversion.
        from: u32,
        /// The length of u.
        length: u32,
    },
    /// A generator that occurs once in a relator is solved for and replaced everywhere; both are gone.
    Eliminate {
        /// The generator, from 1.
        generator: u32,
        /// The relator.
        relator: u32,
    },
    /// A generator x is replaced by its product with a letter l: x l if `on_right`, else l x. In the relators x becomes
    /// $x l^{-1}$ or $l^{-1} x$.
    Multiply {
        /// The generator, from 1.
        generator: u32,
        /// The letter, of another generator.
        letter: i32,
        /// The side of the letter.
        on_right: bool,
    },
}

/// A presentation while it changes.
#[derive(Clone, Debug)]
pub(super) struct Work {
    /// Cyclically reduced; the empty ones are gone.
    pub(super) relators: Vec<Word>,
    pub(super) is_alive: Vec<bool>,
    /// The relators that have each generator.
    pub(super) places: Vec<BTreeSet<u32>>,
    /// The number of letters of all relators.
    pub(super) length: usize,
    /// How many letters were read or written: a measure of time that is the same on every machine.
    pub(super) effort: u64,
}

fn position(letter: i32) -> usize {
    letter.unsigned_abs() as usize - 1
}

impl Work {
    pub(super) fn new(generator_count: usize, relators: &[Word]) -> Self {
        let mut work = Self {
            relators: vec![Word::new(); relators.len()],
            is_alive: vec![true; generator_count],
            places: vec![BTreeSet::new(); generator_count],
            length: 0,
            effort: 0,
        };
        for (i, relator) in relators.iter().enumerate() {
            work.set(i, relator.cyclically_reduced());
        }
        work
    }

    /// Replaces a relator by a cyclically reduced word.
    pub(super) fn set(&mut self, relator: usize, word: Word) {
        let old = std::mem::replace(&mut self.relators[relator], word);
        for &letter in old.letters() {
            self.places[position(letter)].remove(&(relator as u32));
        }
        for &letter in self.relators[relator].letters() {
            self.places[position(letter)].insert(relator as u32);
        }
        self.length = self.length + self.relators[relator].len() - old.len();
        self.effort += (self.relators[relator].len() + old.len()) as u64;
    }

    /// How often a generator occurs in a relator.
    pub(super) fn occurrences(&self, generator: u32, relator: usize) -> usize {
        self.relators[relator].letters().iter().filter(|letter| letter.unsigned_abs() == generator).count()
    }

    /// What a generator is in the others by a relator in which it occurs once.
    fn solution(&self, generator: u32, relator: usize) -> Option<Word> {
        let letters = self.relators[relator].letters();
        let mut at = (0..letters.len()).filter(|&i| letters[i].unsigned_abs() == generator);
        let (Some(place), None) = (at.next(), at.next()) else { return None };
        // x w is the unit: x is the inverse of w.
        let rest = Word::from_letters(letters[place + 1..].iter().chain(&letters[..place]).copied());
        Some(if letters[place] > 0 { rest.inverse() } else { rest })
    }

    /// Replaces a generator by a word in all relators.
    fn substitute(&mut self, generator: u32, word: &Word) {
        let inverse = word.inverse();
        let places: Vec<u32> = self.places[generator as usize - 1].iter().copied().collect();
        for place in places {
            let old = &self.relators[place as usize];
            let mut new = Word::new();
            for &letter in old.letters() {
                if letter.unsigned_abs() != generator {
                    new.push(letter);
                } else {
                    new.append(if letter > 0 { word } else { &inverse });
                }
            }
            self.set(place as usize, new.cyclically_reduced());
        }
    }

    /// What a relator becomes by a rewriting step; `None` if the step does not fit.
    pub(super) fn rewritten(&self, step: &TietzeMove) -> Option<Word> {
        let TietzeMove::Rewrite { relator, at, by, inverted, from, length } = *step else { return None };
        let part = rotated(self.relators.get(by as usize)?, inverted, from as usize);
        let whole = rotated(self.relators.get(relator as usize)?, false, at as usize);
        let length = length as usize;
        if relator == by || part.get(..length)? != whole.get(..length)? {
            return None;
        }
        let mut word = Word::from_letters(part[length..].iter().rev().map(|letter| -letter));
        word.append(&Word::from_letters(whole[length..].iter().copied()));
        Some(word.cyclically_reduced())
    }

    /// Does one step and gives the image of the generator that it replaces, if it does.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] if the step does not keep the group.
    pub(super) fn apply(&mut self, step: &TietzeMove) -> Result<Option<(u32, Word)>, Error> {
        let refused = || {
            Error::new(ErrorKind::InvalidInput, format!("the step {step:?} does not fit the presentation"))
        };
        let relator = |i: u32| -> Result<usize, Error> {
            Some(i as usize).filter(|&i| i < self.relators.len()).ok_or_else(refused)
        };
        let generator = |i: u32| -> Result<u32, Error> {
            let is_alive = i > 0 && self.is_alive.get(i as usize - 1) == Some(&true);
            Some(i).filter(|_| is_alive).ok_or_else(refused)
        };
        match *step {
            TietzeMove::Duplicate { relator: i, like } => {
                let (i, like) = (relator(i)?, relator(like)?);
                if i == like || self.relators[i].cyclic_form() != self.relators[like].cyclic_form() {
                    return Err(refused());
                }
                self.set(i, Word::new());
                Ok(None)
            }
            TietzeMove::Rewrite { relator: i, .. } => {
                let word = self.rewritten(step).ok_or_else(refused)?;
                self.set(i as usize, word);
                Ok(None)
            }
            TietzeMove::Eliminate { generator: x, relator: i } => {
                let (x, i) = (generator(x)?, relator(i)?);
                let word = self.solution(x, i).ok_or_else(refused)?;
                self.set(i, Word::new());
                self.substitute(x, &word);
                self.is_alive[x as usize - 1] = false;
                Ok(Some((x, word)))
            }
            TietzeMove::Multiply { generator: x, letter, on_right } => {
                let (x, other) = (generator(x)?, generator(letter.unsigned_abs())?);
                if x == other {
                    return Err(refused());
                }
                let word = if on_right { [x as i32, -letter] } else { [-letter, x as i32] };
                let word = Word::from_letters(word);
                self.substitute(x, &word);
                Ok(Some((x, word)))
            }
        }
    }
}

/// The letters of a word or of its inverse, from a place on and around.
pub(super) fn rotated(word: &Word, inverted: bool, from: usize) -> Vec<i32> {
    let word = if inverted { word.inverse() } else { word.clone() };
    let mut letters = word.letters().to_vec();
    if !letters.is_empty() {
        let count = letters.len();
        letters.rotate_left(from % count);
    }
    letters
}
