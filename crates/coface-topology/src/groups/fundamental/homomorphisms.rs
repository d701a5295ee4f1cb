//! How many homomorphisms a group has to small permutation groups.

use super::tietze::is_past;
use super::{Effort, Presentation};
use coface_algebra::{Permutation, Sign, Word};
use std::collections::BTreeMap;
use std::fmt;
use std::time::Instant;

/// A symmetric or an alternating group.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PermutationGroup {
    /// All permutations of so many things.
    Symmetric(usize),
    /// The even permutations of so many things.
    Alternating(usize),
}

impl fmt::Display for PermutationGroup {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Symmetric(count) => write!(f, "S{count}"),
            Self::Alternating(count) => write!(f, "A{count}"),
        }
    }
}

/// How many homomorphisms there are from one group to another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct HomomorphismCount {
    /// All of them.
    pub all: u64,
    /// Those that are onto.
    pub onto: u64,
}

/// The most things that are permuted.
const MOST_THINGS: usize = 6;

/// A permutation group as a multiplication table, with the unit first.
struct Table {
    order: usize,
    products: Vec<u32>,
    inverses: Vec<u32>,
}

impl Table {
    fn new(group: PermutationGroup) -> Self {
        let (count, even_only) = match group {
            PermutationGroup::Symmetric(count) => (count, false),
            PermutationGroup::Alternating(count) => (count, true),
        };
        let mut all = vec![Vec::new()];
        for thing in 0..count as u32 {
            all = all
                .into_iter()
                .flat_map(|images: Vec<u32>| {
                    (0..=images.len()).map(move |at| {
                        let mut longer = images.clone();
                        longer.insert(at, thing);
                        longer
                    })
                })
                .collect();
        }
        all.sort_unstable();
        let elements: Vec<Permutation> = all
            .into_iter()
            .map(|images| Permutation::from_images(images).expect("each thing is an image once"))
            .filter(|permutation| !even_only || permutation.sign() == Sign::Plus)
            .collect();
        let number: BTreeMap<&Permutation, u32> = elements.iter().zip(0..).collect();
        let products: Vec<u32> =
            elements.iter().flat_map(|a| elements.iter().map(|b| number[&a.then(b)])).collect();
        let inverses = elements.iter().map(|a| number[&a.inverse()]).collect();
        Self { order: elements.len(), products, inverses }
    }

    fn product(&self, a: u32, b: u32) -> u32 {
        self.products[a as usize * self.order + b as usize]
    }

    fn value(&self, word: &Word, images: &[u32]) -> u32 {
        word.letters().iter().fold(0, |at, &letter| {
            let image = images[letter.unsigned_abs() as usize - 1];
            self.product(at, if letter > 0 { image } else { self.inverses[image as usize] })
        })
    }

    fn is_generated_by(&self, elements: &[u32]) -> bool {
        let mut is_met = vec![false; self.order];
        is_met[0] = true;
        let (mut queue, mut met) = (vec![0], 1);
        while let Some(x) = queue.pop() {
            for &y in elements {
                let next = self.product(x, y);
                if !std::mem::replace(&mut is_met[next as usize], true) {
                    met += 1;
                    queue.push(next);
                }
            }
        }
        met == self.order
    }
}

impl Presentation {
    /// The number of homomorphisms to a permutation group of at most 6 things; `None` if counting takes more than the
    /// effort, or for more things. It is an invariant of the group.
    ///
    /// # Complexity
    /// The order of the permutation group to the power of the number of generators at worst.
    ///
    /// # Examples
    /// The trefoil group has 12 homomorphisms to S3: one for each coloring with 3 colors and its like.
    /// ```
    /// use coface_algebra::Word;
    /// use coface_topology::{Effort, PermutationGroup, Presentation};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let trefoil = Presentation::new(2, vec![Word::from_letters([1, 2, 1, -2, -1, -2])])?;
    /// let count = trefoil.homomorphisms_to(PermutationGroup::Symmetric(3), Effort::default());
    /// assert_eq!(count.map(|count| (count.all, count.onto)), Some((12, 6)));
    /// # Ok(()) }
    /// ```
    pub fn homomorphisms_to(&self, group: PermutationGroup, effort: Effort) -> Option<HomomorphismCount> {
        let (PermutationGroup::Symmetric(things) | PermutationGroup::Alternating(things)) = group;
        if things > MOST_THINGS {
            return None;
        }
        // A relator is looked at as soon as all its generators have images.
        let mut relators: Vec<Vec<&Word>> = vec![Vec::new(); self.generator_count() + 1];
        for relator in self.relators() {
            relators[relator.highest_letter()].push(relator);
        }
        let mut count = Count {
            table: Table::new(group),
            relators,
            images: Vec::new(),
            steps: effort.steps,
            deadline: effort.deadline(),
            found: HomomorphismCount { all: 0, onto: 0 },
        };
        count.choose(self.generator_count())?;
        Some(count.found)
    }
}

struct Count<'a> {
    table: Table,
    /// The relators whose highest generator is this one.
    relators: Vec<Vec<&'a Word>>,
    images: Vec<u32>,
    steps: u64,
    deadline: Option<Instant>,
    found: HomomorphismCount,
}

impl Count<'_> {
    /// Chooses images for the remaining generators in all ways; `None` when the effort is used up.
    fn choose(&mut self, generator_count: usize) -> Option<()> {
        let chosen = self.images.len();
        let letters: usize = self.relators[chosen].iter().map(|relator| relator.len()).sum();
        self.steps = self.steps.checked_sub(1 + letters as u64)?;
        if is_past(self.deadline) {
            return None;
        }
        if self.relators[chosen].iter().any(|relator| self.table.value(relator, &self.images) != 0) {
            return Some(());
        }
        if chosen == generator_count {
            self.found.all += 1;
            self.steps = self.steps.saturating_sub(self.table.order as u64);
            self.found.onto += u64::from(self.table.is_generated_by(&self.images));
            return Some(());
        }
        for image in 0..self.table.order as u32 {
            self.images.push(image);
            self.choose(generator_count)?;
            self.images.pop();
        }
        Some(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn free_groups_map_everywhere() {
        let free = Presentation::new(2, vec![]).unwrap();
        let count = |group| free.homomorphisms_to(group, Effort::default()).unwrap();
        // P. Hall, The Eulerian functions of a group (1936): 19 classes of generating pairs of A5, 9 of S4, 3 of S3.
        assert_eq!(count(PermutationGroup::Alternating(5)), HomomorphismCount { all: 3600, onto: 19 * 120 });
        assert_eq!(count(PermutationGroup::Symmetric(4)), HomomorphismCount { all: 576, onto: 9 * 24 });
        assert_eq!(count(PermutationGroup::Symmetric(3)), HomomorphismCount { all: 36, onto: 3 * 6 });
        assert_eq!(free.homomorphisms_to(PermutationGroup::Symmetric(7), Effort::default()), None);
        let over = Effort::new().time_limit(std::time::Duration::ZERO);
        assert_eq!(free.homomorphisms_to(PermutationGroup::Symmetric(3), over), None);
        assert_eq!(free.subgroups_up_to(2, over), None);
        let few = Effort::new().max_steps(10);
        assert_eq!(free.homomorphisms_to(PermutationGroup::Symmetric(3), few), None);
        assert_eq!(PermutationGroup::Alternating(5).to_string(), "A5");
    }

    #[test]
    fn homomorphisms_and_subgroups_count_each_other() {
        // M. Hall, Subgroups of finite index in free groups (1949), holds for every group.
        let word = |letters: &[i32]| Word::from_letters(letters.iter().copied());
        for relators in [
            vec![],
            vec![word(&[1, 2, 1, -2])],
            vec![word(&[1, 1, 1, 2, 2])],
            vec![word(&[1, 1]), word(&[2; 3])],
        ] {
            let group = Presentation::new(2, relators).unwrap();
            let classes = group.subgroups_up_to(5, Effort::default()).unwrap();
            let subgroups = |index: usize| -> u64 {
                let own = classes.iter().filter(|class| class.index() == index);
                own.map(|class| class.conjugate_count() as u64).sum()
            };
            let maps = |n: usize| {
                group.homomorphisms_to(PermutationGroup::Symmetric(n), Effort::default()).unwrap().all
            };
            let factorial = |n: usize| (1..=n as u64).product::<u64>();
            for n in 1..=5 {
                // h_n = sum over k of (n-1)! / (n-k)! a_k h_(n-k), with h_0 = 1.
                let sum: u64 = (1..=n)
                    .map(|k| {
                        let rest = if k == n { 1 } else { maps(n - k) };
                        factorial(n - 1) / factorial(n - k) * subgroups(k) * rest
                    })
                    .sum();
                assert_eq!(maps(n), sum, "{group}, {n} things");
            }
        }
    }
}
