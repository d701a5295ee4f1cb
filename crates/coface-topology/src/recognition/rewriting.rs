//! Rewriting of words: proofs that two words are equal in a group.

use crate::groups::Presentation;
use coface_algebra::Word;
use std::cmp::Ordering;
use std::collections::{BTreeMap, VecDeque};

/// Rules that replace parts of words by earlier ones and change no element of the group: what reduces to the empty word
/// is the unit. When [`Self::is_complete`], the converse is true too.
#[derive(Clone, Debug)]
pub(super) struct Rewriting {
    /// The rules by the last letter of their left sides; replaced ones are gone.
    rules: Vec<Option<(Vec<i32>, Vec<i32>)>>,
    by_last: BTreeMap<i32, Vec<u32>>,
    is_complete: bool,
}

/// Shorter words first, then the order of the letters +1, -1, +2, -2, ...
fn order(a: &[i32], b: &[i32]) -> Ordering {
    let rank = |&letter: &i32| (letter.unsigned_abs(), letter < 0);
    a.len().cmp(&b.len()).then_with(|| a.iter().map(rank).cmp(b.iter().map(rank)))
}

impl Rewriting {
    /// The rules that follow from the relators of a group, until they are complete, there are `most` of them, or so
    /// many `steps` (letters compared) are done.
    ///
    /// Source: D. E. Knuth, P. B. Bendix, *Simple word problems in universal algebras* (1970), with the shortest words
    /// first.
    pub(super) fn new(group: &Presentation, most: usize, mut steps: u64) -> Self {
        let mut system = Self { rules: Vec::new(), by_last: BTreeMap::new(), is_complete: false };
        let mut equations: VecDeque<(Vec<i32>, Vec<i32>)> = VecDeque::new();
        for letter in 1..=group.generator_count() as i32 {
            equations.push_back((vec![letter, -letter], Vec::new()));
            equations.push_back((vec![-letter, letter], Vec::new()));
        }
        let mut relators: Vec<&Word> = group.relators().iter().collect();
        relators.sort_by_key(|relator| relator.len());
        for relator in relators {
            // Half of the relator against the inverse of the rest.
            let (head, tail) = relator.letters().split_at(relator.len().div_ceil(2));
            equations.push_back((head.to_vec(), tail.iter().rev().map(|letter| -letter).collect()));
        }
        let longest = 4 + 2 * group.relators().iter().map(Word::len).max().unwrap_or(0);
        let mut alive = 0;
        let mut is_cut = false;
        while let Some((a, b)) = equations.pop_front() {
            let (a, b) = (system.reduced(&a, &mut steps), system.reduced(&b, &mut steps));
            let (left, right) = match order(&a, &b) {
                Ordering::Equal => continue,
                Ordering::Less => (b, a),
                Ordering::Greater => (a, b),
            };
            if alive >= most || steps == 0 {
                return system;
            }
            if left.len() > longest {
                is_cut = true;
                continue;
            }
            // Rules with the new left side inside theirs are equations again.
            for rule in &mut system.rules {
                if rule.as_ref().is_some_and(|(old, _)| old.windows(left.len()).any(|part| part == left)) {
                    equations.extend(rule.take());
                    alive -= 1;
                }
            }
            let number = system.rules.len() as u32;
            let last = *left.last().expect("a left side is not empty");
            system.rules.push(Some((left, right)));
            system.by_last.entry(last).or_default().push(number);
            alive += 1;
            system.overlaps(number as usize, &mut equations, &mut steps);
        }
        system.is_complete = !is_cut;
        system
    }

    /// The equations that overlapping left sides of a rule and all rules give.
    fn overlaps(&self, number: usize, equations: &mut VecDeque<(Vec<i32>, Vec<i32>)>, steps: &mut u64) {
        let Some((left, right)) = &self.rules[number] else { return };
        for (other_left, other_right) in self.rules.iter().flatten() {
            for (first, second) in
                [((left, right), (other_left, other_right)), ((other_left, other_right), (left, right))]
            {
                // The first ends with what the second begins with.
                let shared = 1..=first.0.len().min(second.0.len());
                for common in shared {
                    *steps = steps.saturating_sub(common as u64);
                    if first.0[first.0.len() - common..] == second.0[..common] {
                        let one = [first.1, &second.0[common..]].concat();
                        let two = [&first.0[..first.0.len() - common], second.1].concat();
                        if one != two {
                            equations.push_back((one, two));
                        }
                    }
                }
            }
        }
    }

    /// The word that is left when no rule fits any more, or when the steps are used up.
    fn reduced(&self, word: &[i32], steps: &mut u64) -> Vec<i32> {
        let mut done: Vec<i32> = Vec::with_capacity(word.len());
        let mut ahead: Vec<i32> = word.iter().rev().copied().collect();
        while let Some(letter) = ahead.pop() {
            done.push(letter);
            let numbers = self.by_last.get(&letter).map_or(&[][..], Vec::as_slice);
            *steps = steps.saturating_sub(1 + numbers.len() as u64);
            let rules = numbers.iter().filter_map(|&number| self.rules[number as usize].as_ref());
            if let Some((left, right)) = rules.into_iter().find(|(left, _)| done.ends_with(left))
                && *steps > 0
            {
                done.truncate(done.len() - left.len());
                ahead.extend(right.iter().rev());
            }
        }
        done
    }

    /// Whether the rules prove that a word is the unit.
    pub(super) fn proves_unit(&self, word: &Word) -> bool {
        let mut steps = 1_000_000;
        self.reduced(word.letters(), &mut steps).is_empty()
    }

    /// Whether the rules prove that two words commute.
    pub(super) fn proves_commute(&self, a: &Word, b: &Word) -> bool {
        self.proves_unit(&a.commutator(b))
    }

    /// Whether every word that is the unit is known to be.
    #[cfg(test)]
    fn is_complete(&self) -> bool {
        self.is_complete
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn group(count: usize, relators: &[&[i32]]) -> Presentation {
        let relators = relators.iter().map(|letters| Word::from_letters(letters.iter().copied())).collect();
        Presentation::new(count, relators).unwrap()
    }

    #[test]
    fn word_problems_of_small_groups_are_solved() {
        let word = |letters: &[i32]| Word::from_letters(letters.iter().copied());
        let torus = Rewriting::new(&group(2, &[&[1, 2, -1, -2]]), 200, 1_000_000);
        assert!(torus.is_complete());
        assert!(torus.proves_unit(&word(&[1, 1, 2, -1, -1, -2])) && !torus.proves_unit(&word(&[1, 2])));
        let quaternions = Rewriting::new(&group(2, &[&[1, 1, -2, -2], &[1, 2, 1, -2]]), 200, 1_000_000);
        assert!(quaternions.is_complete());
        assert!(quaternions.proves_unit(&word(&[1, 1, 1, 1])) && !quaternions.proves_unit(&word(&[1, 1])));
        assert!(quaternions.proves_commute(&word(&[1, 1]), &word(&[2])));
        // The Heisenberg group: the commutator is central.
        let commutator = word(&[1, 2, -1, -2]);
        let relators = [1, 2].map(|letter| commutator.commutator(&word(&[letter])));
        let heisenberg = Presentation::new(2, relators.to_vec()).unwrap();
        let heisenberg = Rewriting::new(&heisenberg, 400, 10_000_000);
        assert!(heisenberg.proves_commute(&commutator, &word(&[1])));
        assert!(heisenberg.proves_commute(&commutator.power(2), &word(&[2, 1])));
        assert!(!heisenberg.proves_unit(&commutator));
    }
}
