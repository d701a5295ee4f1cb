//! Subgroups of low index.

use super::tietze::is_past;
use super::{CosetTable, Effort, Presentation};
use coface_algebra::Word;
use std::time::Instant;

/// No coset yet.
const NONE: u32 = u32::MAX;

/// A class of conjugate subgroups of finite index.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SubgroupClass {
    table: CosetTable,
    conjugate_count: usize,
}

impl SubgroupClass {
    /// The cosets of one subgroup of the class; those of the others are the same with another coset as the first.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::{Effort, Presentation};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The infinite cyclic group has one subgroup of each index.
    /// let classes = Presentation::new(1, vec![])?.subgroups_up_to(3, Effort::default()).expect("there are three");
    /// assert_eq!(classes[2].table().index(), 3);
    /// # Ok(()) }
    /// ```
    pub fn table(&self) -> &CosetTable {
        &self.table
    }

    /// The index of the subgroups.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::{Effort, Presentation};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The infinite cyclic group has one subgroup of each index.
    /// let classes = Presentation::new(1, vec![])?.subgroups_up_to(3, Effort::default()).expect("there are three");
    /// assert_eq!(classes.iter().map(|class| class.index()).collect::<Vec<_>>(), [1, 2, 3]);
    /// # Ok(()) }
    /// ```
    pub fn index(&self) -> usize {
        self.table.index()
    }

    /// The number of subgroups in the class; 1 for a normal subgroup.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::{Effort, Presentation};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The infinite cyclic group has one subgroup of each index.
    /// let classes = Presentation::new(1, vec![])?.subgroups_up_to(3, Effort::default()).expect("there are three");
    /// assert!(classes.iter().all(|class| class.conjugate_count() == 1));
    /// # Ok(()) }
    /// ```
    pub fn conjugate_count(&self) -> usize {
        self.conjugate_count
    }
}

impl Presentation {
    /// The classes of conjugate subgroups of index up to `highest`, by their coset tables; `None` if that takes more
    /// than the effort. How many there are is an invariant of the group: groups that differ in it are not isomorphic.
    ///
    /// # Complexity
    /// Exponential in the index; the search goes through partial coset tables in standard order and leaves those that a
    /// conjugate comes before.
    ///
    /// # References
    /// C. C. Sims, *Computation with finitely presented groups* (1994), section 5.6.
    ///
    /// # Examples
    /// A free group of rank 2 has 3 subgroups of index 2 and 13 of index 3, in 7 classes.
    /// ```
    /// use coface_topology::{Effort, Presentation};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let free = Presentation::new(2, vec![])?;
    /// let classes = free.subgroups_up_to(3, Effort::default()).expect("there are few");
    /// let count = |index| classes.iter().filter(move |class| class.index() == index).map(|class| class.conjugate_count());
    /// assert_eq!([1, 2, 3].map(|index| count(index).sum::<usize>()), [1, 3, 13]);
    /// assert_eq!(count(3).count(), 7);
    /// # Ok(()) }
    /// ```
    pub fn subgroups_up_to(&self, highest: usize, effort: Effort) -> Option<Vec<SubgroupClass>> {
        let width = 2 * self.generator_count();
        let mut relators: Vec<Word> = self.relators().iter().map(Word::cyclically_reduced).collect();
        relators.retain(|relator| !relator.is_empty());
        relators.sort_by_key(Word::len);
        let mut search = Search {
            width,
            highest,
            relators: relators
                .iter()
                .map(|relator| relator.letters().iter().map(|&l| column(l)).collect())
                .collect(),
            images: vec![NONE; width * highest.max(1)],
            count: 1,
            trail: Vec::new(),
            found: Vec::new(),
            steps: effort.steps,
            deadline: effort.deadline(),
        };
        if highest > 0 && search.close() {
            search.descend(0)?;
        }
        search.found.sort_by_key(SubgroupClass::index);
        Some(search.found)
    }
}

fn column(letter: i32) -> usize {
    2 * (letter.unsigned_abs() as usize - 1) + usize::from(letter < 0)
}

struct Search {
    width: usize,
    highest: usize,
    /// The relators as columns of the table.
    relators: Vec<Vec<usize>>,
    images: Vec<u32>,
    /// The number of cosets so far.
    count: usize,
    /// The entries that were made, to be taken back.
    trail: Vec<(u32, u32)>,
    found: Vec<SubgroupClass>,
    steps: u64,
    deadline: Option<Instant>,
}

impl Search {
    fn image(&self, coset: u32, place: usize) -> u32 {
        self.images[coset as usize * self.width + place]
    }

    fn join(&mut self, coset: u32, place: usize, image: u32) {
        self.images[coset as usize * self.width + place] = image;
        self.images[image as usize * self.width + (place ^ 1)] = coset;
        self.trail.push((coset, place as u32));
    }

    fn take_back(&mut self, mark: usize) {
        for (coset, place) in self.trail.drain(mark..) {
            let at = coset as usize * self.width + place as usize;
            let image = self.images[at] as usize;
            self.images[at] = NONE;
            self.images[image * self.width + (place as usize ^ 1)] = NONE;
        }
    }

    /// Fills in what the relators say until nothing follows any more; `false` if they do not close.
    fn close(&mut self) -> bool {
        loop {
            let before = self.trail.len();
            for coset in 0..self.count as u32 {
                for r in 0..self.relators.len() {
                    if !self.scan(coset, r) {
                        return false;
                    }
                }
            }
            if self.trail.len() == before {
                return true;
            }
        }
    }

    /// Lets a relator go from a coset to itself; one missing image is filled in.
    fn scan(&mut self, coset: u32, r: usize) -> bool {
        let relator = &self.relators[r];
        self.steps = self.steps.saturating_sub(relator.len() as u64);
        let (mut first, mut last) = (0, relator.len());
        let (mut ahead, mut behind) = (coset, coset);
        while first < last {
            match self.image(ahead, relator[first]) {
                NONE => break,
                next => ahead = next,
            }
            first += 1;
        }
        while first < last {
            match self.image(behind, relator[last - 1] ^ 1) {
                NONE => break,
                next => behind = next,
            }
            last -= 1;
        }
        match last - first {
            0 => ahead == behind,
            1 => {
                let place = relator[first];
                self.join(ahead, place, behind);
                true
            }
            _ => true,
        }
    }

    /// Goes through all tables that continue the one at hand from this entry on; `None` when the effort is used up.
    fn descend(&mut self, from: usize) -> Option<()> {
        if self.steps == 0 || is_past(self.deadline) {
            return None;
        }
        let Some(conjugates) = self.conjugates() else { return Some(()) };
        let end = self.count * self.width;
        let Some(entry) = (from..end).find(|&entry| self.images[entry] == NONE) else {
            let table = CosetTable::from_images(self.width / 2, self.images[..end].to_vec());
            self.found.push(SubgroupClass { table, conjugate_count: self.count / conjugates });
            return Some(());
        };
        let (coset, place) = ((entry / self.width) as u32, entry % self.width);
        let old_count = self.count;
        for image in 0..=old_count.min(self.highest - 1) {
            let is_new = image == old_count;
            if !is_new && self.image(image as u32, place ^ 1) != NONE {
                continue;
            }
            self.count = old_count + usize::from(is_new);
            let mark = self.trail.len();
            self.join(coset, place, image as u32);
            if self.close() {
                self.descend(entry + 1)?;
            }
            self.take_back(mark);
        }
        self.count = old_count;
        Some(())
    }

    /// Compares the table with those of the conjugate subgroups, numbered anew from another coset on. `None` if one of
    /// them comes first; else how many are equal as far as they are known (all, when the table is full).
    fn conjugates(&mut self) -> Option<usize> {
        let mut equal = 1;
        for base in 1..self.count as u32 {
            match self.compare_from(base) {
                std::cmp::Ordering::Less => return None,
                std::cmp::Ordering::Equal => equal += 1,
                std::cmp::Ordering::Greater => {}
            }
        }
        Some(equal)
    }

    /// The table numbered from a coset on, against the table itself, up to the first entry that either does not have
    /// (then it counts as greater).
    fn compare_from(&mut self, base: u32) -> std::cmp::Ordering {
        let mut number = vec![NONE; self.count];
        let mut order = vec![base];
        number[base as usize] = 0;
        let mut at = 0;
        while at < order.len() {
            for place in 0..self.width {
                self.steps = self.steps.saturating_sub(1);
                let (own, other) = (self.image(at as u32, place), self.image(order[at], place));
                if own == NONE || other == NONE {
                    return std::cmp::Ordering::Greater;
                }
                if number[other as usize] == NONE {
                    number[other as usize] = order.len() as u32;
                    order.push(other);
                }
                let ordering = number[other as usize].cmp(&own);
                if ordering.is_ne() {
                    return ordering;
                }
            }
            at += 1;
        }
        std::cmp::Ordering::Equal
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn group(count: usize, relators: &[&[i32]]) -> Presentation {
        let relators = relators.iter().map(|letters| Word::from_letters(letters.iter().copied())).collect();
        Presentation::new(count, relators).unwrap()
    }

    /// The numbers of subgroups of index 1, 2, ...
    fn counts(group: &Presentation, highest: usize) -> Vec<usize> {
        let classes = group.subgroups_up_to(highest, Effort::default()).unwrap();
        (1..=highest)
            .map(|index| {
                classes
                    .iter()
                    .filter(|class| class.index() == index)
                    .map(SubgroupClass::conjugate_count)
                    .sum()
            })
            .collect()
    }

    #[test]
    fn subgroups_are_as_many_as_in_the_literature() {
        // M. Hall, Subgroups of finite index in free groups (1949).
        assert_eq!(counts(&group(2, &[]), 5), [1, 3, 13, 71, 461]);
        // Z^2: the sum of the divisors.
        assert_eq!(counts(&group(2, &[&[1, 2, -1, -2]]), 8), [1, 3, 4, 7, 6, 12, 8, 15]);
        assert_eq!(counts(&group(1, &[]), 4), [1, 1, 1, 1]);
        assert_eq!(counts(&group(1, &[&[1; 6]]), 8), [1, 1, 1, 0, 0, 1, 0, 0]);
        // S4 has 1 subgroup of index 2, 3 of index 3, 4 of index 4, 4 of index 6 and so on.
        let symmetric = group(2, &[&[1, 1], &[2, 2, 2], &[1, 2, 1, 2, 1, 2, 1, 2]]);
        assert_eq!(
            counts(&symmetric, 24),
            [1, 1, 3, 4, 0, 7, 0, 4, 0, 0, 0, 9, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1]
        );
        let classes = symmetric.subgroups_up_to(24, Effort::default()).unwrap();
        assert_eq!(classes.len(), 11);
        assert_eq!(counts(&group(0, &[]), 3), [1, 0, 0]);
        assert_eq!(group(3, &[]).subgroups_up_to(20, Effort::new().max_steps(1000)), None);
        assert_eq!(counts(&group(2, &[]), 0), [0usize; 0]);
    }
}
