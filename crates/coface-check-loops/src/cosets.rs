//! How many elements a group has, by the cosets of its unit (J. A. Todd and H. S. M. Coxeter, 1936).

use crate::words::Word;

/// So many cosets are made at most, and fewer of groups with many generators or long relators.
const MOST_COSETS: usize = 1 << 17;
const MOST_PLACES: usize = 1 << 22;
const MOST_STEPS: usize = 1 << 27;

/// The order of a group, if it is finite and few cosets are needed to see it.
pub(crate) fn order((generators, relators): &(usize, Vec<Word>)) -> Option<usize> {
    if *generators == 0 {
        return Some(1);
    }
    let letters: usize = relators.iter().map(Vec::len).sum();
    let width = 2 * generators;
    let most = MOST_COSETS.min(MOST_PLACES / width).min(MOST_STEPS / letters.max(1));
    let mut table = Table { width, most, rows: vec![None; width], above: vec![0] };
    let mut coset = 0;
    while coset < table.above.len() {
        for relator in relators {
            if table.is_there(coset) {
                table.trace(coset as u32, relator)?;
            }
        }
        for column in 0..table.width {
            if table.is_there(coset) && table.get(coset as u32, column).is_none() {
                table.define(coset as u32, column)?;
            }
        }
        coset += 1;
    }
    let cosets: Vec<u32> =
        (0..table.above.len()).filter(|&coset| table.is_there(coset)).map(|coset| coset as u32).collect();
    // What is left is a group of permutations of the cosets in which all relators are the unit.
    let is_closed = |coset: u32, relator: &Word| {
        relator.iter().try_fold(coset, |at, letter| table.get(at, column(*letter))) == Some(coset)
    };
    let is_group = cosets.iter().all(|&coset| relators.iter().all(|relator| is_closed(coset, relator)));
    is_group.then_some(cosets.len())
}

/// The column of a generator, or of its inverse next to it.
fn column(letter: i64) -> usize {
    2 * (letter.unsigned_abs() as usize - 1) + usize::from(letter < 0)
}

/// Where generators and their inverses lead each coset.
struct Table {
    width: usize,
    most: usize,
    rows: Vec<Option<u32>>,
    /// An earlier coset that a coset is; itself if it is there.
    above: Vec<u32>,
}

impl Table {
    fn is_there(&self, coset: usize) -> bool {
        self.above[coset] as usize == coset
    }

    fn get(&self, coset: u32, column: usize) -> Option<u32> {
        self.rows[coset as usize * self.width + column]
    }

    fn set(&mut self, coset: u32, column: usize, to: Option<u32>) {
        self.rows[coset as usize * self.width + column] = to;
    }

    fn find(&self, mut coset: u32) -> u32 {
        while self.above[coset as usize] != coset {
            coset = self.above[coset as usize];
        }
        coset
    }

    /// A new coset behind a column.
    fn define(&mut self, coset: u32, column: usize) -> Option<u32> {
        let new = self.above.len() as u32;
        if self.above.len() >= self.most {
            return None;
        }
        self.above.push(new);
        self.rows.extend((0..self.width).map(|_| None));
        self.set(coset, column, Some(new));
        self.set(new, column ^ 1, Some(coset));
        Some(new)
    }

    /// Follows a relator from a coset, which it leads back to; what is missing between is made.
    fn trace(&mut self, coset: u32, relator: &Word) -> Option<()> {
        let (mut front, mut back) = (coset, coset);
        let (mut first, mut last) = (0, relator.len());
        loop {
            while first < last
                && let Some(next) = self.get(front, column(relator[first]))
            {
                front = next;
                first += 1;
            }
            while first < last
                && let Some(next) = self.get(back, column(-relator[last - 1]))
            {
                back = next;
                last -= 1;
            }
            if first == last {
                if front != back {
                    self.unite(front, back);
                }
                return Some(());
            }
            if first + 1 == last {
                let own = column(relator[first]);
                self.set(front, own, Some(back));
                self.set(back, own ^ 1, Some(front));
                return Some(());
            }
            front = self.define(front, column(relator[first]))?;
            first += 1;
        }
    }

    /// Two cosets are one: so are those that a generator leads them to.
    fn unite(&mut self, a: u32, b: u32) {
        let mut waiting = vec![(a, b)];
        while let Some((a, b)) = waiting.pop() {
            let (a, b) = (self.find(a), self.find(b));
            if a == b {
                continue;
            }
            let (kept, gone) = (a.min(b), a.max(b));
            self.above[gone as usize] = kept;
            for column in 0..self.width {
                let Some(to) = self.get(gone, column) else { continue };
                self.set(gone, column, None);
                if self.get(to, column ^ 1) == Some(gone) {
                    self.set(to, column ^ 1, None);
                }
                let (from, to) = (self.find(kept), self.find(to));
                match (self.get(from, column), self.get(to, column ^ 1)) {
                    (Some(other), _) => waiting.push((other, to)),
                    (None, Some(other)) => waiting.push((other, from)),
                    (None, None) => {
                        self.set(from, column, Some(to));
                        self.set(to, column ^ 1, Some(from));
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::order;

    #[test]
    fn known_groups_have_their_orders() {
        for (generators, relators, expected) in [
            (0, vec![], Some(1)),
            (1, vec![vec![1; 12]], Some(12)),
            (1, vec![vec![1; 6], vec![1; 10]], Some(2)),
            // The symmetric group of three letters, the quaternions, and the binary icosahedral group.
            (2, vec![vec![1, 1], vec![2, 2], vec![1, 2, 1, 2, 1, 2]], Some(6)),
            (2, vec![vec![1, 1, -2, -2], vec![1, 2, 1, -2]], Some(8)),
            (2, vec![vec![1, 1, 1, 1, 1, -2, -2, -2], vec![1, 1, 1, 1, 1, -2, -1, -2, -1]], Some(120)),
            // A presentation of the trivial group whose cosets first grow.
            (2, vec![vec![-2, 1, 2, -1, -1], vec![-1, 2, 1, -2, -2]], Some(1)),
            // The free abelian group of rank 2 has no end.
            (2, vec![vec![1, 2, -1, -2]], None),
        ] {
            assert_eq!(order(&(generators, relators.clone())), expected, "{relators:?}");
        }
    }
}
