//! Simplification of presentations by Tietze moves, with an isomorphism both ways.

use super::Presentation;
use super::moves::{TietzeMove, Work, rotated};
use coface_algebra::Error;
use coface_algebra::Word;
use coface_algebra::progress::stage;
use std::collections::{BTreeMap, HashMap};
use std::time::{Duration, Instant};

/// How much work may be done. The number of steps is the same on every machine, so a result that only they limit is
/// always the same; a time limit can be set beside it.
///
/// # Examples
/// ```
/// use coface_topology::{Effort, Presentation};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let free = Presentation::new(3, vec![])?;
/// assert!(free.subgroups_up_to(20, Effort::new().max_steps(1000)).is_none());
/// # Ok(()) }
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Effort {
    pub(crate) steps: u64,
    pub(crate) time: Option<Duration>,
}

impl Effort {
    /// 10^8 letters, about a second, and no time limit.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::Effort;
    /// assert_eq!(Effort::new(), Effort::default());
    /// ```
    pub fn new() -> Self {
        Self { steps: 100_000_000, time: None }
    }

    /// How many letters may be read or written.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::Effort;
    /// assert_ne!(Effort::new().max_steps(10), Effort::new());
    /// ```
    #[must_use]
    pub fn max_steps(mut self, steps: u64) -> Self {
        self.steps = steps;
        self
    }

    /// How long the work may take; with `None` only the steps count.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::Effort;
    /// use std::time::Duration;
    /// let minute = Effort::new().time_limit(Duration::from_secs(60));
    /// assert_eq!(minute.time_limit(None), Effort::new());
    /// ```
    #[must_use]
    pub fn time_limit(mut self, limit: impl Into<Option<Duration>>) -> Self {
        self.time = limit.into();
        self
    }

    /// When the work that begins now has to end.
    pub(crate) fn deadline(self) -> Option<Instant> {
        self.time.and_then(|limit| Instant::now().checked_add(limit))
    }
}

/// Whether a deadline is there and has passed.
pub(crate) fn is_past(deadline: Option<Instant>) -> bool {
    deadline.is_some_and(|end| Instant::now() >= end)
}

impl Default for Effort {
    fn default() -> Self {
        Self::new()
    }
}

/// A simpler presentation of a group, and how it was found: the moves, and the isomorphism that they are.
///
/// # Examples
/// ```
/// use coface_algebra::Word;
/// use coface_topology::{Effort, Presentation, Simplification};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// // x2 is the inverse of x1, so x1 x1 x2 x1 x1 is the third power of x1.
/// let group = Presentation::new(2, vec![Word::from_letters([1, 2]), Word::from_letters([1, 1, 2, 1, 1])])?;
/// let simple = Simplification::new(&group, Effort::default());
/// assert_eq!(simple.presentation().to_string(), "<x1 | x1^3>");
/// let old = simple.to_original(&Word::from_letters([1]));
/// assert_eq!(simple.to_simplified(&old).letters(), [1]);
/// assert_eq!(&simple.replay(&group)?, simple.presentation());
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct Simplification {
    presentation: Presentation,
    moves: Vec<TietzeMove>,
    /// The generators that the moves replace, with their images, in the order of the moves.
    replaced: Vec<(u32, Word)>,
    /// The old number, from 1, of each generator that is left.
    kept: Vec<u32>,
    generator_count: usize,
}

/// Relators beyond this length are not searched for parts of others.
const LONGEST_SEARCHED: usize = 4096;

impl Simplification {
    /// Simplifies a presentation: fewest generators first, then short relators.
    ///
    /// Relators of one cyclic form are kept once. A generator that occurs once in a relator is solved for, as long as
    /// the relators do not grow much. A part of a relator that is more than half of another is replaced by the rest
    /// of that one; a part of exactly half, if the relator becomes earlier in the lexicographic order. A generator is
    /// multiplied by a letter that follows it in most places.
    ///
    /// # Complexity
    /// Bounded by `effort`; each round reads all letters a few times.
    ///
    /// # References
    /// H. Tietze, *Ueber die topologischen Invarianten mehrdimensionaler Mannigfaltigkeiten* (1908); G. Havas, P. E.
    /// Kenne, J. S. Richardson, E. F. Robertson, *A Tietze transformation program* (1984).
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::{Effort, Presentation, Simplification};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // x2 is the inverse of x1, so x1 x1 x2 x1 x1 is the third power of x1.
    /// let relators = vec![Word::from_letters([1, 2]), Word::from_letters([1, 1, 2, 1, 1])];
    /// let group = Presentation::new(2, relators)?;
    /// let simple = Simplification::new(&group, Effort::default());
    /// assert_eq!(simple.presentation().to_string(), "<x1 | x1^3>");
    /// # Ok(()) }
    /// ```
    pub fn new(presentation: &Presentation, effort: Effort) -> Self {
        let mut search = Search {
            work: Work::new(presentation.generator_count(), presentation.relators()),
            moves: Vec::new(),
            replaced: Vec::new(),
            effort,
            deadline: effort.deadline(),
        };
        search.run();
        let Search { work, moves, replaced, .. } = search;
        let (presentation, kept) = finished(&work);
        Self { presentation, moves, replaced, kept, generator_count: work.is_alive.len() }
    }

    /// The simpler presentation.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::{Effort, Presentation, Simplification};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // x2 is the inverse of x1, so x1 x1 x2 x1 x1 is the third power of x1.
    /// let relators = vec![Word::from_letters([1, 2]), Word::from_letters([1, 1, 2, 1, 1])];
    /// let group = Presentation::new(2, relators)?;
    /// let simple = Simplification::new(&group, Effort::default());
    /// assert_eq!(simple.presentation().generator_count(), 1);
    /// # Ok(()) }
    /// ```
    pub fn presentation(&self) -> &Presentation {
        &self.presentation
    }

    /// The moves that lead to it.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::{Effort, Presentation, Simplification};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // x2 is the inverse of x1, so x1 x1 x2 x1 x1 is the third power of x1.
    /// let relators = vec![Word::from_letters([1, 2]), Word::from_letters([1, 1, 2, 1, 1])];
    /// let group = Presentation::new(2, relators)?;
    /// let simple = Simplification::new(&group, Effort::default());
    /// assert!(!simple.moves().is_empty());
    /// # Ok(()) }
    /// ```
    pub fn moves(&self) -> &[TietzeMove] {
        &self.moves
    }

    /// Does the moves again on the presentation that they were found for, checking that each keeps the group.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::InvalidInput`] naming a move that does not fit.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::{Effort, Presentation, Simplification};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // x2 is the inverse of x1, so x1 x1 x2 x1 x1 is the third power of x1.
    /// let relators = vec![Word::from_letters([1, 2]), Word::from_letters([1, 1, 2, 1, 1])];
    /// let group = Presentation::new(2, relators)?;
    /// let simple = Simplification::new(&group, Effort::default());
    /// assert_eq!(&simple.replay(&group)?, simple.presentation());
    /// # Ok(()) }
    /// ```
    pub fn replay(&self, presentation: &Presentation) -> Result<Presentation, Error> {
        let mut work = Work::new(presentation.generator_count(), presentation.relators());
        for step in &self.moves {
            work.apply(step)?;
        }
        Ok(finished(&work).0)
    }

    /// A word in the old generators, written in those of the simpler presentation.
    ///
    /// # Panics
    /// If a letter is no old generator.
    ///
    /// # Complexity
    /// Linear in the words between the moves, which may be much longer than the first and the last.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::{Effort, Presentation, Simplification};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // x2 is the inverse of x1, so x1 x1 x2 x1 x1 is the third power of x1.
    /// let relators = vec![Word::from_letters([1, 2]), Word::from_letters([1, 1, 2, 1, 1])];
    /// let group = Presentation::new(2, relators)?;
    /// let simple = Simplification::new(&group, Effort::default());
    /// let both = Word::from_letters([1, 2]);
    /// assert!(simple.to_simplified(&both).is_empty());
    /// # Ok(()) }
    /// ```
    pub fn to_simplified(&self, word: &Word) -> Word {
        assert!(word.highest_letter() <= self.generator_count, "letters are generators of the group");
        let mut word = word.clone();
        for (generator, image) in &self.replaced {
            if word.letters().iter().any(|letter| letter.unsigned_abs() == *generator) {
                word = substituted(&word, *generator, image);
            }
        }
        let new = |letter: i32| {
            let place =
                self.kept.binary_search(&letter.unsigned_abs()).expect("other generators are replaced");
            (place as i32 + 1) * letter.signum()
        };
        Word::from_letters(word.letters().iter().map(|&letter| new(letter)))
    }

    /// A word in the generators of the simpler presentation, written in the old ones.
    ///
    /// # Panics
    /// If a letter is no generator.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::{Effort, Presentation, Simplification};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // x2 is the inverse of x1, so x1 x1 x2 x1 x1 is the third power of x1.
    /// let relators = vec![Word::from_letters([1, 2]), Word::from_letters([1, 1, 2, 1, 1])];
    /// let group = Presentation::new(2, relators)?;
    /// let simple = Simplification::new(&group, Effort::default());
    /// let old = simple.to_original(&Word::from_letters([1]));
    /// assert_eq!(simple.to_simplified(&old).letters(), [1]);
    /// # Ok(()) }
    /// ```
    pub fn to_original(&self, word: &Word) -> Word {
        let old = |letter: i32| self.kept[letter.unsigned_abs() as usize - 1] as i32 * letter.signum();
        let mut word = Word::from_letters(word.letters().iter().map(|&letter| old(letter)));
        let multiplied = self.moves.iter().rev().filter_map(|step| match *step {
            TietzeMove::Multiply { generator, letter, on_right } => Some((generator, letter, on_right)),
            _ => None,
        });
        for (generator, letter, on_right) in multiplied {
            let x = generator as i32;
            let image = Word::from_letters(if on_right { [x, letter] } else { [letter, x] });
            word = substituted(&word, generator, &image);
        }
        word
    }
}

fn substituted(word: &Word, generator: u32, image: &Word) -> Word {
    let inverse = image.inverse();
    let mut new = Word::new();
    for &letter in word.letters() {
        if letter.unsigned_abs() != generator {
            new.push(letter);
        } else {
            new.append(if letter > 0 { image } else { &inverse });
        }
    }
    new
}

/// The presentation that is left, with generators numbered anew, and their old numbers.
fn finished(work: &Work) -> (Presentation, Vec<u32>) {
    let kept: Vec<u32> =
        (1..=work.is_alive.len() as u32).filter(|&generator| work.is_alive[generator as usize - 1]).collect();
    let new = |letter: i32| {
        let place = kept.binary_search(&letter.unsigned_abs()).expect("letters of relators are alive");
        (place as i32 + 1) * letter.signum()
    };
    let mut relators: Vec<Word> = work
        .relators
        .iter()
        .filter(|relator| !relator.is_empty())
        .map(|relator| handsome(&Word::from_letters(relator.letters().iter().map(|&letter| new(letter)))))
        .collect();
    relators.sort_by_key(|relator| {
        (relator.len(), relator.letters().iter().map(|&l| (l.abs(), l < 0)).collect::<Vec<_>>())
    });
    (Presentation::new(kept.len(), relators).expect("letters are numbered among those kept"), kept)
}

/// The rotation of a relator or its inverse that people like best: few inverse letters, the first generators first.
fn handsome(relator: &Word) -> Word {
    let rank = |letters: &Vec<i32>| letters.iter().map(|&l| (l.unsigned_abs(), l < 0)).collect::<Vec<_>>();
    let best = [false, true]
        .into_iter()
        .min_by_key(|&inverted| rotated(relator, inverted, 0).iter().filter(|letter| **letter < 0).count())
        .expect("there are two");
    let same = |inverted| rotated(relator, inverted, 0).iter().filter(|letter| **letter < 0).count();
    let ways = if same(false) == same(true) { vec![false, true] } else { vec![best] };
    let first = relator.letters().iter().map(|letter| letter.unsigned_abs()).min().unwrap_or(0);
    let letters = ways
        .into_iter()
        .flat_map(|inverted| {
            let own = rotated(relator, inverted, 0);
            (0..own.len()).filter(move |&i| own[i].unsigned_abs() == first).map(move |from| (inverted, from))
        })
        .take(256)
        .map(|(inverted, from)| rotated(relator, inverted, from))
        .min_by_key(rank)
        .unwrap_or_default();
    Word::from_letters(letters)
}

struct Search {
    work: Work,
    moves: Vec<TietzeMove>,
    replaced: Vec<(u32, Word)>,
    effort: Effort,
    deadline: Option<Instant>,
}

impl Search {
    fn run(&mut self) {
        let roomy = 4 * self.work.length + 1000;
        // How much all relators together may grow by one elimination.
        let steps = stage("simplifying a presentation", 0);
        for growth in [0, 16, 256, 4096] {
            loop {
                steps.advance(1);
                let mut changed = self.drop_duplicates();
                changed |= self.eliminate(growth, roomy);
                changed |= self.shorten(false);
                if !changed {
                    changed |= self.multiply();
                }
                if !changed {
                    changed |= self.shorten(true);
                }
                if !changed || self.is_over() {
                    break;
                }
            }
        }
    }

    fn is_over(&self) -> bool {
        self.work.effort >= self.effort.steps || is_past(self.deadline)
    }

    fn apply(&mut self, step: TietzeMove) {
        let replaced = self.work.apply(&step).expect("the search only finds moves that fit");
        self.replaced.extend(replaced);
        self.moves.push(step);
    }

    fn drop_duplicates(&mut self) -> bool {
        let mut met: BTreeMap<Word, u32> = BTreeMap::new();
        let mut found = Vec::new();
        for (i, relator) in self.work.relators.iter().enumerate().filter(|(_, relator)| !relator.is_empty()) {
            self.work.effort += 2 * relator.len() as u64;
            match met.entry(relator.cyclic_form()) {
                std::collections::btree_map::Entry::Vacant(place) => {
                    place.insert(i as u32);
                }
                std::collections::btree_map::Entry::Occupied(place) => {
                    found.push(TietzeMove::Duplicate { relator: i as u32, like: *place.get() });
                }
            }
        }
        let changed = !found.is_empty();
        found.into_iter().for_each(|step| self.apply(step));
        changed
    }

    /// Solves for generators, shortest relators first, as long as the relators grow by at most `growth` each time and
    /// are not longer than `roomy` after.
    fn eliminate(&mut self, growth: usize, roomy: usize) -> bool {
        let mut order: Vec<usize> =
            (0..self.work.relators.len()).filter(|&i| !self.work.relators[i].is_empty()).collect();
        order.sort_by_key(|&i| self.work.relators[i].len());
        let mut changed = false;
        for relator in order {
            if self.is_over() {
                break;
            }
            if let Some((generator, more)) = self.cheapest(relator)
                && more <= growth
                && self.work.length + more <= roomy
            {
                self.apply(TietzeMove::Eliminate { generator, relator: relator as u32 });
                changed = true;
            }
        }
        changed
    }

    /// The generator that occurs once in a relator and costs least to eliminate, with the letters that come in
    /// addition.
    fn cheapest(&mut self, relator: usize) -> Option<(u32, usize)> {
        let mut counts: BTreeMap<u32, usize> = BTreeMap::new();
        for letter in self.work.relators[relator].letters() {
            *counts.entry(letter.unsigned_abs()).or_default() += 1;
        }
        let length = self.work.relators[relator].len();
        self.work.effort += length as u64;
        let mut best: Option<(u32, usize)> = None;
        for (generator, _) in counts.into_iter().filter(|&(_, count)| count == 1) {
            let places = &self.work.places[generator as usize - 1];
            let mut elsewhere = 0;
            for &place in places.iter().filter(|&&place| place as usize != relator) {
                elsewhere += self.work.occurrences(generator, place as usize);
                self.work.effort += self.work.relators[place as usize].len() as u64;
            }
            // Each occurrence becomes length - 1 letters, and the relator goes.
            let more = (elsewhere * length.saturating_sub(2)).saturating_sub(length);
            if best.is_none_or(|(_, least)| more < least) {
                best = Some((generator, more));
            }
        }
        best
    }

    /// Replaces parts of relators that are more than half of another one, or with `half` exactly half of one.
    fn shorten(&mut self, half: bool) -> bool {
        let mut changed = false;
        // The parts to look for: by length, the words and where they stand.
        let mut order: Vec<usize> = (0..self.work.relators.len())
            .filter(|&i| {
                let length = self.work.relators[i].len();
                length > 0 && length <= LONGEST_SEARCHED && !(half && length % 2 == 1)
            })
            .collect();
        order.sort_by_key(|&i| self.work.relators[i].len());
        let steps = stage("shortening relators", order.len());
        for by in order {
            steps.advance(1);
            let length = self.work.relators[by].len();
            if self.is_over() {
                break;
            }
            if length == 0 || (half && length % 2 == 1) {
                continue;
            }
            let part = if half { length / 2 } else { length / 2 + 1 };
            let doubled: Vec<Vec<i32>> = [false, true]
                .map(|inverted| {
                    let letters = rotated(&self.work.relators[by], inverted, 0);
                    [letters.clone(), letters].concat()
                })
                .to_vec();
            let mut parts: HashMap<&[i32], (bool, u32)> = HashMap::with_capacity(2 * length);
            for (inverted, letters) in [false, true].into_iter().zip(&doubled) {
                for from in 0..length {
                    parts.entry(&letters[from..from + part]).or_insert((inverted, from as u32));
                }
            }
            self.work.effort += (2 * length) as u64;
            // Only relators with a letter of this one can have a part of it.
            let mut others: Vec<u32> = Vec::new();
            for &letter in &doubled[0][..length] {
                others.extend(&self.work.places[letter.unsigned_abs() as usize - 1]);
                others.sort_unstable();
                others.dedup();
            }
            for other in others {
                if other as usize == by {
                    continue;
                }
                while let Some((at, (inverted, from))) = self.find(other as usize, part, &parts) {
                    let step = TietzeMove::Rewrite {
                        relator: other,
                        at,
                        by: by as u32,
                        inverted,
                        from,
                        length: part as u32,
                    };
                    if half && !self.improves(&step) {
                        break;
                    }
                    self.apply(step);
                    changed = true;
                }
            }
        }
        changed
    }

    /// Where a relator has one of these parts.
    fn find(
        &mut self,
        relator: usize,
        part: usize,
        parts: &HashMap<&[i32], (bool, u32)>,
    ) -> Option<(u32, (bool, u32))> {
        let letters = self.work.relators[relator].letters();
        if letters.len() < part || letters.len() > LONGEST_SEARCHED {
            return None;
        }
        self.work.effort += letters.len() as u64;
        let around = [letters, &letters[..part - 1]].concat();
        (0..letters.len()).find_map(|at| Some((at as u32, *parts.get(&around[at..at + part])?)))
    }

    /// Whether a step makes its relator shorter or earlier.
    fn improves(&self, step: &TietzeMove) -> bool {
        let TietzeMove::Rewrite { relator, .. } = *step else { return false };
        let after = self.work.rewritten(step).expect("the search only finds moves that fit");
        let key = |word: &Word| (word.len(), word.cyclic_form());
        key(&after) < key(&self.work.relators[relator as usize])
    }

    /// Multiplies generators by letters that stand beside them in most places.
    fn multiply(&mut self) -> bool {
        // How often generator x is followed by a letter; the inverse of the pair counts too.
        let mut after: BTreeMap<(u32, i32), usize> = BTreeMap::new();
        let mut before: BTreeMap<(u32, i32), usize> = BTreeMap::new();
        let mut counts: BTreeMap<u32, usize> = BTreeMap::new();
        for relator in &self.work.relators {
            let letters = relator.letters();
            self.work.effort += letters.len() as u64;
            for (i, &letter) in letters.iter().enumerate() {
                let next = letters[(i + 1) % letters.len()];
                *counts.entry(letter.unsigned_abs()).or_default() += 1;
                // The pair (letter, next), and the pair of inverses (-next, -letter).
                for (a, b) in [(letter, next), (-next, -letter)] {
                    if a > 0 && a.unsigned_abs() != b.unsigned_abs() {
                        *after.entry((a.unsigned_abs(), b)).or_default() += 1;
                    }
                    if b > 0 && a.unsigned_abs() != b.unsigned_abs() {
                        *before.entry((b.unsigned_abs(), a)).or_default() += 1;
                    }
                }
            }
        }
        let sides = [(after, true), (before, false)];
        let best = sides
            .iter()
            .flat_map(|(pairs, on_right)| pairs.iter().map(move |(&pair, &count)| (pair, count, *on_right)))
            .map(|((generator, letter), count, on_right)| {
                let gain = 2 * count as i64 - counts[&generator] as i64;
                (gain, TietzeMove::Multiply { generator, letter, on_right })
            })
            .filter(|&(gain, _)| gain > 0)
            .reduce(|best, other| if other.0 > best.0 { other } else { best });
        match best {
            Some((_, step)) => {
                self.apply(step);
                true
            }
            None => false,
        }
    }
}
