//! Coset enumeration: how many cosets a subgroup has, by filling a table.

use super::Presentation;
use coface_algebra::Word;
use coface_algebra::progress::stage;
use std::collections::VecDeque;

/// No coset yet.
const NONE: u32 = u32::MAX;

/// The cosets of a subgroup of finite index, with what each generator does to them from the right.
///
/// Coset 0 is the subgroup. Cosets are numbered in the order in which they are met when the generators and their
/// inverses, in the order +1, -1, +2, -2, ..., are tried on one coset after the other.
///
/// # Examples
/// The group of the cube's rotations has 24 elements, and 6 cosets of the turns about one face:
/// ```
/// use coface_algebra::Word;
/// use coface_topology::{CosetTable, Presentation};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let relators = [vec![1, 1], vec![2, 2, 2], vec![1, 2, 1, 2, 1, 2, 1, 2]].map(Word::from_letters);
/// let cube = Presentation::new(2, relators.to_vec())?;
/// assert_eq!(CosetTable::new(&cube, &[], 1000).map(|table| table.index()), Some(24));
/// let turn = Word::from_letters([1, 2]);
/// assert_eq!(CosetTable::new(&cube, &[turn], 1000).map(|table| table.index()), Some(6));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CosetTable {
    generator_count: usize,
    /// For each coset the images under +1, -1, +2, -2, ...
    images: Vec<u32>,
}

/// The column of a letter.
fn column(letter: i32) -> usize {
    2 * (letter.unsigned_abs() as usize - 1) + usize::from(letter < 0)
}

impl CosetTable {
    /// The cosets of the subgroup that these words generate; `None` if more than `limit` cosets are in the table at
    /// some time, which says nothing about the index. Without words the cosets are the elements of the group.
    ///
    /// # Panics
    /// If a word has a letter that is no generator.
    ///
    /// # Complexity
    /// No bound in terms of the index is possible. Up to $20 L$ cosets are made for a limit of L.
    ///
    /// # References
    /// J. A. Todd, H. S. M. Coxeter, *A practical method for enumerating cosets of a finite abstract group* (1936); the
    /// strategy is that of C. B. Haselgrove, J. Leech and H. F. Trotter: every relator is closed at every coset.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::{CosetTable, Presentation};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The symmetric group of three things, with the cosets of a transposition.
    /// let relators = [vec![1, 1], vec![2, 2, 2], vec![1, 2, 1, 2]].map(Word::from_letters);
    /// let group = Presentation::new(2, relators.to_vec())?;
    /// let swap = Word::from_letters([1]);
    /// let cosets = CosetTable::new(&group, &[swap.clone()], 100).expect("there are three cosets");
    /// assert_eq!(cosets.index(), 3);
    /// assert!(CosetTable::new(&Presentation::new(1, vec![])?, &[], 100).is_none(), "Z is infinite");
    /// # Ok(()) }
    /// ```
    pub fn new(presentation: &Presentation, subgroup: &[Word], limit: usize) -> Option<Self> {
        let letters_fit = |word: &Word| word.highest_letter() <= presentation.generator_count();
        assert!(subgroup.iter().all(letters_fit), "letters are generators of the group");
        let mut table = Filling::new(presentation.generator_count(), limit);
        for word in subgroup {
            table.trace(0, word.letters())?;
        }
        // Short relators close soon and keep the table small.
        let mut relators: Vec<&Word> = presentation.relators().iter().collect();
        relators.sort_by_key(|relator| relator.len());
        let mut coset = 0;
        let steps = stage("enumerating cosets", 0);
        while coset < table.parents.len() {
            steps.advance(1);
            for relator in &relators {
                if table.parents[coset] != coset as u32 {
                    break;
                }
                table.trace(coset as u32, relator.letters())?;
            }
            if table.parents[coset] == coset as u32 {
                for place in 0..table.width {
                    if table.images[coset * table.width + place] == NONE {
                        table.define(coset as u32, place)?;
                    }
                }
            }
            coset += 1;
        }
        Some(table.standardized(presentation.generator_count()))
    }

    /// The table with these images under +1, -1, +2, -2, ... of each coset.
    pub(super) fn from_images(generator_count: usize, images: Vec<u32>) -> Self {
        Self { generator_count, images }
    }

    /// The number of cosets.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::{CosetTable, Presentation};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The symmetric group of three things, with the cosets of a transposition.
    /// let relators = [vec![1, 1], vec![2, 2, 2], vec![1, 2, 1, 2]].map(Word::from_letters);
    /// let group = Presentation::new(2, relators.to_vec())?;
    /// let swap = Word::from_letters([1]);
    /// let cosets = CosetTable::new(&group, &[swap.clone()], 100).expect("there are three cosets");
    /// assert_eq!(cosets.index(), 3);
    /// # Ok(()) }
    /// ```
    pub fn index(&self) -> usize {
        if self.generator_count == 0 { 1 } else { self.images.len() / (2 * self.generator_count) }
    }

    /// The number of generators of the group.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::{CosetTable, Presentation};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The symmetric group of three things, with the cosets of a transposition.
    /// let relators = [vec![1, 1], vec![2, 2, 2], vec![1, 2, 1, 2]].map(Word::from_letters);
    /// let group = Presentation::new(2, relators.to_vec())?;
    /// let swap = Word::from_letters([1]);
    /// let cosets = CosetTable::new(&group, &[swap.clone()], 100).expect("there are three cosets");
    /// assert_eq!(cosets.generator_count(), 2);
    /// # Ok(()) }
    /// ```
    pub fn generator_count(&self) -> usize {
        self.generator_count
    }

    /// The coset that a letter takes a coset to, from the right.
    ///
    /// # Panics
    /// If there is no such coset or letter.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::{CosetTable, Presentation};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The symmetric group of three things, with the cosets of a transposition.
    /// let relators = [vec![1, 1], vec![2, 2, 2], vec![1, 2, 1, 2]].map(Word::from_letters);
    /// let group = Presentation::new(2, relators.to_vec())?;
    /// let swap = Word::from_letters([1]);
    /// let cosets = CosetTable::new(&group, &[swap.clone()], 100).expect("there are three cosets");
    /// // The transposition keeps its own coset, three turns come back to it.
    /// assert_eq!(cosets.image(0, 1), 0);
    /// assert_eq!(cosets.image(cosets.image(cosets.image(0, 2), 2), 2), 0);
    /// # Ok(()) }
    /// ```
    pub fn image(&self, coset: usize, letter: i32) -> usize {
        self.images[coset * 2 * self.generator_count + column(letter)] as usize
    }

    /// The coset that a word takes a coset to.
    ///
    /// # Panics
    /// If there is no such coset or letter.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::{CosetTable, Presentation};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The symmetric group of three things, with the cosets of a transposition.
    /// let relators = [vec![1, 1], vec![2, 2, 2], vec![1, 2, 1, 2]].map(Word::from_letters);
    /// let group = Presentation::new(2, relators.to_vec())?;
    /// let swap = Word::from_letters([1]);
    /// let cosets = CosetTable::new(&group, &[swap.clone()], 100).expect("there are three cosets");
    /// assert_eq!(cosets.image_by(1, &Word::from_letters([2, 2, 2])), 1);
    /// # Ok(()) }
    /// ```
    pub fn image_by(&self, coset: usize, word: &Word) -> usize {
        word.letters().iter().fold(coset, |at, &letter| self.image(at, letter))
    }

    /// A shortest word that takes coset 0 to each coset.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::{CosetTable, Presentation};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The symmetric group of three things, with the cosets of a transposition.
    /// let relators = [vec![1, 1], vec![2, 2, 2], vec![1, 2, 1, 2]].map(Word::from_letters);
    /// let group = Presentation::new(2, relators.to_vec())?;
    /// let swap = Word::from_letters([1]);
    /// let cosets = CosetTable::new(&group, &[swap.clone()], 100).expect("there are three cosets");
    /// let words = cosets.representatives();
    /// assert!((0..3).all(|coset| cosets.image_by(0, &words[coset]) == coset));
    /// # Ok(()) }
    /// ```
    pub fn representatives(&self) -> Vec<Word> {
        let mut words: Vec<Option<Word>> = vec![None; self.index()];
        words[0] = Some(Word::new());
        let mut queue = VecDeque::from([0]);
        while let Some(coset) = queue.pop_front() {
            for generator in 1..=self.generator_count as i32 {
                for letter in [generator, -generator] {
                    let next = self.image(coset, letter);
                    if words[next].is_none() {
                        let step = Word::from_letters([letter]);
                        words[next] = words[coset].as_ref().map(|word| word.times(&step));
                        queue.push_back(next);
                    }
                }
            }
        }
        words.into_iter().map(|word| word.expect("generators reach all cosets")).collect()
    }
}

/// A table being filled. Cosets that turn out to be equal are joined to the smaller one.
struct Filling {
    width: usize,
    limit: usize,
    images: Vec<u32>,
    /// The coset that each one is equal to, or itself.
    parents: Vec<u32>,
    alive: usize,
}

impl Filling {
    fn new(generator_count: usize, limit: usize) -> Self {
        let width = 2 * generator_count;
        Self { width, limit, images: vec![NONE; width], parents: vec![0], alive: 1 }
    }

    fn image(&self, coset: u32, place: usize) -> u32 {
        self.images[coset as usize * self.width + place]
    }

    fn join(&mut self, coset: u32, place: usize, image: u32) {
        self.images[coset as usize * self.width + place] = image;
        self.images[image as usize * self.width + (place ^ 1)] = coset;
    }

    /// Makes a coset the image of one; `None` when there would be too many.
    fn define(&mut self, coset: u32, place: usize) -> Option<u32> {
        if self.alive >= self.limit || self.parents.len() >= 20 * self.limit {
            return None;
        }
        let new = self.parents.len() as u32;
        self.parents.push(new);
        self.images.extend(std::iter::repeat_n(NONE, self.width));
        self.alive += 1;
        self.join(coset, place, new);
        Some(new)
    }

    /// Lets a word go from a coset back to itself, making cosets where it has no way; `None` when there would be
    /// too many.
    fn trace(&mut self, coset: u32, word: &[i32]) -> Option<()> {
        if word.is_empty() {
            return Some(());
        }
        let (mut first, mut last) = (0, word.len());
        let (mut ahead, mut behind) = (coset, coset);
        loop {
            while first < last {
                match self.image(ahead, column(word[first])) {
                    NONE => break,
                    next => ahead = next,
                }
                first += 1;
            }
            while first < last {
                match self.image(behind, column(-word[last - 1])) {
                    NONE => break,
                    next => behind = next,
                }
                last -= 1;
            }
            match last - first {
                0 => {
                    if ahead != behind {
                        self.coincide(ahead, behind);
                    }
                    return Some(());
                }
                1 => {
                    self.join(ahead, column(word[first]), behind);
                    return Some(());
                }
                _ => {
                    self.define(ahead, column(word[first]))?;
                }
            }
        }
    }

    fn root(&mut self, coset: u32) -> u32 {
        let mut root = coset;
        while self.parents[root as usize] != root {
            root = self.parents[root as usize];
        }
        let mut at = coset;
        while self.parents[at as usize] != root {
            at = std::mem::replace(&mut self.parents[at as usize], root);
        }
        root
    }

    fn merge(&mut self, a: u32, b: u32, gone: &mut VecDeque<u32>) {
        let (a, b) = (self.root(a), self.root(b));
        if a != b {
            self.parents[a.max(b) as usize] = a.min(b);
            self.alive -= 1;
            gone.push_back(a.max(b));
        }
    }

    /// Two cosets are equal: joins them and all that follows.
    fn coincide(&mut self, a: u32, b: u32) {
        let mut gone = VecDeque::new();
        self.merge(a, b, &mut gone);
        while let Some(coset) = gone.pop_front() {
            for place in 0..self.width {
                let image = self.image(coset, place);
                if image == NONE {
                    continue;
                }
                self.images[coset as usize * self.width + place] = NONE;
                if self.image(image, place ^ 1) == coset {
                    self.images[image as usize * self.width + (place ^ 1)] = NONE;
                }
                let (from, to) = (self.root(coset), self.root(image));
                let forward = self.image(from, place);
                let backward = self.image(to, place ^ 1);
                if forward != NONE {
                    self.merge(forward, to, &mut gone);
                } else if backward != NONE {
                    self.merge(backward, from, &mut gone);
                } else {
                    self.join(from, place, to);
                }
            }
        }
    }

    /// The cosets that are left, in standard order.
    fn standardized(&self, generator_count: usize) -> CosetTable {
        let mut number = vec![NONE; self.parents.len()];
        let mut order = vec![0u32];
        number[0] = 0;
        let mut images = Vec::with_capacity(self.alive * self.width);
        let mut at = 0;
        while at < order.len() {
            for place in 0..self.width {
                let image = self.image(order[at], place);
                if number[image as usize] == NONE {
                    number[image as usize] = order.len() as u32;
                    order.push(image);
                }
                images.push(number[image as usize]);
            }
            at += 1;
        }
        CosetTable { generator_count, images }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn group(count: usize, relators: &[&[i32]]) -> Presentation {
        let relators = relators.iter().map(|letters| Word::from_letters(letters.iter().copied())).collect();
        Presentation::new(count, relators).unwrap()
    }

    fn power(letters: &[i32], exponent: usize) -> Vec<i32> {
        letters.repeat(exponent)
    }

    #[test]
    fn orders_are_those_of_the_literature() {
        let triangle =
            |l: usize, m: usize, n: usize| group(2, &[&power(&[1], l), &power(&[2], m), &power(&[1, 2], n)]);
        // Coxeter, Moser, Generators and relations for discrete groups, tables 1 and 2.
        assert_eq!(CosetTable::new(&triangle(2, 3, 3), &[], 500).unwrap().index(), 12);
        assert_eq!(CosetTable::new(&triangle(2, 3, 5), &[], 500).unwrap().index(), 60);
        assert_eq!(CosetTable::new(&triangle(2, 2, 17), &[], 500).unwrap().index(), 34);
        assert_eq!(CosetTable::new(&triangle(2, 3, 6), &[], 500), None);
        let binary = group(2, &[&[1, 1, 1, -2, -2, -2, -2, -2], &[1, 2, 1, 2, -1, -1, -1]]);
        assert_eq!(CosetTable::new(&binary, &[], 2000).unwrap().index(), 120);
        // The Fibonacci group F(2, 5) is cyclic of order 11.
        let fibonacci = group(5, &[&[1, 2, -3], &[2, 3, -4], &[3, 4, -5], &[4, 5, -1], &[5, 1, -2]]);
        assert_eq!(CosetTable::new(&fibonacci, &[], 500).unwrap().index(), 11);
        // PSL(2, 7) as (2, 3, 7; 4), and its index 7 subgroup.
        let klein = group(2, &[&[1, 1], &[2, 2, 2], &power(&[1, 2], 7), &power(&[1, 2, -1, -2], 4)]);
        assert_eq!(CosetTable::new(&klein, &[], 2000).unwrap().index(), 168);
        assert_eq!(CosetTable::new(&group(0, &[]), &[], 5).unwrap().index(), 1);
        assert_eq!(CosetTable::new(&group(1, &[&[1]]), &[], 5).unwrap().index(), 1);
        assert_eq!(CosetTable::new(&group(1, &[]), &[], 50), None);
        // A trivial group in hard dress: a^-1 b a = b^2, b^-1 a b = a^2.
        let trivial = group(2, &[&[-1, 2, 1, -2, -2], &[-2, 1, 2, -1, -1]]);
        assert_eq!(CosetTable::new(&trivial, &[], 500).unwrap().index(), 1);
    }

    #[test]
    fn relators_close_at_every_coset() {
        let group = group(2, &[&[1, 1], &[2, 2, 2], &power(&[1, 2], 4)]);
        let table = CosetTable::new(&group, &[Word::from_letters([2])], 100).unwrap();
        assert_eq!(table.index(), 8);
        for coset in 0..8 {
            for relator in group.relators() {
                assert_eq!(table.image_by(coset, relator), coset);
            }
            for letter in [1, -1, 2, -2] {
                assert_eq!(table.image(table.image(coset, letter), -letter), coset);
            }
        }
        for (coset, word) in table.representatives().iter().enumerate() {
            assert_eq!(table.image_by(0, word), coset);
        }
    }
}
