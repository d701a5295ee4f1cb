//! Words in groups of surfaces: which are the unit, and which are conjugate.

use coface_check_loops::Classes;
use coface_check_loops::words::{Word, append, cyclically_reduced, inverse, least_rotation, rotated};

/// The group of a surface: free, or with one relator in which each generator occurs twice.
#[derive(Debug)]
pub(crate) struct Group {
    generators: usize,
    relator: Word,
    kind: Kind,
}

#[derive(Debug)]
enum Kind {
    Free,
    /// The relator is the square of the one generator.
    Plane,
    /// The relator is the commutator of the two generators.
    Torus,
    /// The exponents i and j of each generator, which is a^i b^j in the group where a b a b^-1 is the unit.
    Klein([[i64; 2]; 2]),
    /// There are at least three generators.
    Hyperbolic(Circles),
}

/// The relator around a circle, and its inverse around another one.
#[derive(Debug)]
struct Circles {
    letters: Word,
    /// For each generator, then for each inverse, the two places where it stands on the circles.
    places: Vec<[usize; 2]>,
}

impl Group {
    /// The group of these generators and a cyclically reduced relator, or none, if it is the group of a closed surface with one vertex, or free.
    pub(crate) fn of(generators: usize, relators: &[Word]) -> Option<Self> {
        let relator = match relators {
            [] => return Some(Self { generators, relator: Word::new(), kind: Kind::Free }),
            [relator] => relator.clone(),
            _ => return None,
        };
        let mut counts = vec![0; generators];
        relator.iter().for_each(|letter| counts[letter.unsigned_abs() as usize - 1] += 1);
        // A corner of the polygon joins the end of one letter to the start of the next: all corners are to be around one vertex.
        let place = |letter: i64| 2 * (letter.unsigned_abs() as u32 - 1) + u32::from(letter < 0);
        let mut ends = Classes::new(2 * generators);
        let next = rotated(&relator, 1);
        let joined =
            relator.iter().zip(&next).filter(|(last, next)| ends.join(place(-**last), place(**next)));
        if joined.count() + 1 != 2 * generators || counts.iter().any(|count| *count != 2) {
            return None;
        }
        let kind = match (generators, is_orientable(&relator)) {
            (1, _) => Kind::Plane,
            (2, true) => Kind::Torus,
            (2, false) => Kind::Klein(klein(&relator)?),
            _ => Kind::Hyperbolic(Circles::of(generators, &relator)),
        };
        Some(Self { generators, relator, kind })
    }

    /// Whether this is the group of the same surface: there is an isomorphism then.
    pub(crate) fn is_like(&self, other: &Self) -> bool {
        let kind = |group: &Self| (group.generators, group.relator.len(), is_orientable(&group.relator));
        kind(self) == kind(other)
    }

    /// How often each generator occurs, its inverse counted as -1.
    pub(crate) fn sums(&self, word: &[i64]) -> Vec<i64> {
        let mut sums = vec![0; self.generators];
        word.iter().for_each(|letter| sums[letter.unsigned_abs() as usize - 1] += letter.signum());
        sums
    }

    /// Whether sums of letters are zero in the first homology: a multiple of those of the relator.
    pub(crate) fn is_boundary(&self, sums: &[i64]) -> bool {
        let relation = self.sums(&self.relator);
        let times = relation.iter().zip(sums).find(|(r, _)| **r != 0).map_or(0, |(r, sum)| sum / r);
        // Sums of a stranger may be any numbers.
        relation.iter().zip(sums).all(|(r, sum)| i128::from(*sum) == i128::from(times) * i128::from(*r))
    }

    /// A word for the same element, of few letters.
    pub(crate) fn reduced(&self, word: &[i64]) -> Word {
        let mut free = Word::new();
        append(&mut free, word.iter().copied());
        match &self.kind {
            Kind::Hyperbolic(circles) => circles.reduced(&free),
            _ => free,
        }
    }

    /// Whether a word is the unit.
    pub(crate) fn is_unit(&self, word: &[i64]) -> bool {
        match &self.kind {
            Kind::Free | Kind::Hyperbolic(_) => self.reduced(word).is_empty(),
            Kind::Plane => word.len().is_multiple_of(2),
            Kind::Torus => self.sums(word) == [0, 0],
            Kind::Klein(letters) => exponents(letters, word) == [0, 0],
        }
    }

    /// Whether two words are conjugate; `None` if finding out takes more than this many letters, of which it takes what it needs.
    pub(crate) fn are_conjugate(&self, a: &[i64], b: &[i64], budget: &mut u64) -> Option<bool> {
        let difference: Vec<i64> = self.sums(a).iter().zip(self.sums(b)).map(|(a, b)| a - b).collect();
        // Conjugate words are homologous.
        if !self.is_boundary(&difference) {
            return Some(false);
        }
        Some(match &self.kind {
            Kind::Free => {
                let [a, b] = [a, b].map(|word| least_rotation(&cyclically_reduced(&self.reduced(word))));
                a == b
            }
            // These groups are commutative.
            Kind::Plane | Kind::Torus => true,
            // a a^i b^j a^-1 is a^(i+1) b^j a^-1, and b a^i b^j b^-1 is a^-i b^j; b^j a^-1 is a^(-1 or 1) b^j.
            Kind::Klein(letters) => {
                let [[i, j], [k, l]] = [a, b].map(|word| exponents(letters, word));
                j == l && if j % 2 == 0 { i.abs() == k.abs() } else { (i - k) % 2 == 0 }
            }
            Kind::Hyperbolic(circles) => return circles.are_conjugate(a, b, budget),
        })
    }
}

/// Whether each generator of the relator occurs there with its inverse.
fn is_orientable(relator: &[i64]) -> bool {
    relator.iter().all(|letter| relator.contains(&-letter))
}

/// The exponents of the two generators of a relator that is x x y y or x y x y^-1, read from anywhere: in the first case x is a b and y is b^-1, and in the
/// second x is a and y is b.
fn klein(relator: &[i64]) -> Option<[[i64; 2]; 2]> {
    (0..4).find_map(|from| {
        let [x, y] = match rotated(relator, from)[..] {
            [x, x_again, y, y_again] if x == x_again && y == y_again => [(x, [1, 1]), (y, [0, -1])],
            [x, y, x_again, y_back] if x == x_again && y == -y_back => [(x, [1, 0]), (y, [0, 1])],
            _ => return None,
        };
        let mut letters = [[0; 2]; 2];
        for (letter, element) in [x, y] {
            letters[letter.unsigned_abs() as usize - 1] = if letter < 0 { back(element) } else { element };
        }
        Some(letters)
    })
}

/// The product of a^i b^j and a^k b^l, where b a is a^-1 b.
fn product([i, j]: [i64; 2], [k, l]: [i64; 2]) -> [i64; 2] {
    [if j % 2 == 0 { i + k } else { i - k }, j + l]
}

/// The inverse of a^i b^j.
fn back([i, j]: [i64; 2]) -> [i64; 2] {
    [if j % 2 == 0 { -i } else { i }, -j]
}

fn exponents(letters: &[[i64; 2]; 2], word: &[i64]) -> [i64; 2] {
    word.iter().fold([0, 0], |so_far, letter| {
        let own = letters[letter.unsigned_abs() as usize - 1];
        product(so_far, if *letter < 0 { back(own) } else { own })
    })
}

impl Circles {
    fn of(generators: usize, relator: &[i64]) -> Self {
        let letters = [relator.to_vec(), inverse(relator)].concat();
        let mut places: Vec<Vec<usize>> = vec![Vec::new(); 2 * generators];
        letters.iter().enumerate().for_each(|(i, letter)| places[place(*letter)].push(i));
        Self { letters, places: places.iter().map(|both| [both[0], both[1]]).collect() }
    }

    /// As many letters as there are around a circle.
    fn length(&self) -> usize {
        self.letters.len() / 2
    }

    /// The place so many letters after another one, on the same circle.
    fn after(&self, from: usize, steps: usize) -> usize {
        let length = self.length();
        from - from % length + (from + steps) % length
    }

    /// M. Dehn's algorithm: a part of the relator, or of its inverse, that is longer than half of it is replaced by the inverse of the rest.
    fn reduced(&self, word: &[i64]) -> Word {
        let (length, mut rest) = (self.length(), word.iter().rev().copied().collect::<Word>());
        // The letters so far, each with the lengths of the parts that end with it at its two places.
        let mut found: Vec<(i64, [usize; 2])> = Vec::new();
        while let Some(letter) = rest.pop() {
            if found.last().is_some_and(|(last, _)| *last == -letter) {
                found.pop();
                continue;
            }
            let places = self.places[place(letter)];
            let lengths = places.map(|here| {
                let before = found.last().and_then(|(last, lengths)| {
                    let at = self.places[place(*last)].iter().position(|at| self.after(*at, 1) == here)?;
                    Some(lengths[at])
                });
                1 + before.unwrap_or(0)
            });
            found.push((letter, lengths));
            if let Some(long) = (0..2).find(|&i| 2 * lengths[i] > length) {
                found.truncate(found.len() - lengths[long]);
                let others = 1..=length - lengths[long];
                rest.extend(others.map(|step| -self.letters[self.after(places[long], step)]));
            }
        }
        found.into_iter().map(|(letter, _)| letter).collect()
    }

    /// The word around a circle without long parts of the relator: a conjugate.
    fn cyclically_reduced(&self, word: &[i64]) -> Word {
        let mut word = cyclically_reduced(&self.reduced(word));
        loop {
            // A part around the end is within the word that begins so few letters later.
            let mut turns = 0..word.len().min(self.length() + 2);
            let shorter = turns.find_map(|turn| {
                Some(self.reduced(&rotated(&word, turn))).filter(|shorter| shorter.len() < word.len())
            });
            match shorter {
                Some(shorter) => word = cyclically_reduced(&shorter),
                None => return word,
            }
        }
    }

    /// Whether two words are conjugate: rotations of their reduced forms are equal, or conjugates by a letter.
    fn are_conjugate(&self, a: &[i64], b: &[i64], budget: &mut u64) -> Option<bool> {
        let [a, b] = [a, b].map(|word| self.cyclically_reduced(word));
        if a.is_empty() || b.is_empty() {
            return Some(a.is_empty() && b.is_empty());
        }
        let turns = a.len().min(self.length() / 2 + 1);
        let letters = (1..=self.length() as i64 / 2).flat_map(|x| [vec![x], vec![-x]]);
        let letters: Vec<Word> = std::iter::once(Word::new()).chain(letters).collect();
        let work = (turns * b.len()) as u64 * letters.len() as u64 * (a.len() + b.len()) as u64;
        *budget = budget.checked_sub(work)?;
        Some((0..turns).any(|i| {
            let a = inverse(&rotated(&a, i));
            (0..b.len()).any(|j| {
                let b = rotated(&b, j);
                letters.iter().any(|by| {
                    let mut word = a.clone();
                    append(&mut word, by.iter().chain(&b).copied().chain(inverse(by)));
                    self.reduced(&word).is_empty()
                })
            })
        }))
    }
}

/// The place of a letter in a list of generators and their inverses.
fn place(letter: i64) -> usize {
    2 * (letter.unsigned_abs() as usize - 1) + usize::from(letter < 0)
}

#[cfg(test)]
mod tests {
    use super::Group;
    use coface_check_loops::words::{Word, inverse};

    /// A shuffle that is the same each time.
    fn random(state: &mut u64, below: usize) -> usize {
        *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (*state >> 33) as usize % below
    }

    fn word(state: &mut u64, generators: usize, length: usize) -> Word {
        let letter = |state: &mut u64| {
            let letter = random(state, generators) as i64 + 1;
            if random(state, 2) == 0 { letter } else { -letter }
        };
        (0..length).map(|_| letter(state)).collect()
    }

    const RELATORS: [(usize, &[i64]); 9] = [
        (1, &[1, 1]),
        (2, &[1, 2, -1, -2]),
        (2, &[1, 1, 2, 2]),
        (2, &[2, 1, 2, -1]),
        (2, &[1, -2, 1, 2]),
        (3, &[1, 1, 2, 2, 3, 3]),
        (3, &[1, 2, -1, -2, 3, 3]),
        (4, &[1, 2, 3, 4, -1, -2, -3, -4]),
        (4, &[1, 2, -1, -2, 3, 4, -3, -4]),
    ];

    #[test]
    fn products_of_conjugates_of_the_relator_are_the_unit_and_conjugates_are_conjugate() {
        let mut state = 12;
        for (generators, relator) in RELATORS {
            let group = Group::of(generators, &[relator.to_vec()]).expect("a surface");
            for _ in 0..60 {
                let (mut product, mut other) = (Word::new(), Word::new());
                for _ in 0..random(&mut state, 5) {
                    let length = random(&mut state, 6);
                    let by = word(&mut state, generators, length);
                    let own = if random(&mut state, 2) == 0 { relator.to_vec() } else { inverse(relator) };
                    product.extend(by.iter().copied().chain(own).chain(inverse(&by)));
                }
                assert!(group.is_unit(&product), "{relator:?} {product:?}");
                let length = random(&mut state, 9);
                let one = word(&mut state, generators, length);
                let by = word(&mut state, generators, 5);
                other.extend(by.iter().chain(&one).copied().chain(product).chain(inverse(&by)));
                assert_eq!(
                    group.are_conjugate(&one, &other, &mut u64::MAX.clone()),
                    Some(true),
                    "{relator:?} {one:?} {other:?}"
                );
            }
        }
    }

    /// A second method: the words that are the unit go to the unit of a finite group under each homomorphism.
    #[test]
    fn words_that_permutations_tell_apart_are_not_the_unit() {
        let mut state = 4;
        let apply = |of: &[Vec<usize>], word: &[i64]| -> Vec<usize> {
            let step = |at: usize, letter: &i64| {
                let own = &of[letter.unsigned_abs() as usize - 1];
                if *letter > 0 {
                    own[at]
                } else {
                    own.iter().position(|to| *to == at).expect("a permutation")
                }
            };
            (0..4).map(|at| word.iter().fold(at, step)).collect()
        };
        let cycles = |permutation: &[usize]| {
            let mut lengths: Vec<usize> = (0..4)
                .map(|at| {
                    let mut next = permutation[at];
                    let mut length = 1;
                    while next != at {
                        (next, length) = (permutation[next], length + 1);
                    }
                    length
                })
                .collect();
            lengths.sort_unstable();
            lengths
        };
        let mut told = 0;
        for (generators, relator) in RELATORS {
            let group = Group::of(generators, &[relator.to_vec()]).expect("a surface");
            for _ in 0..4_000 {
                let mut permutations: Vec<Vec<usize>> = vec![(0..4).collect(); generators];
                for permutation in &mut permutations {
                    (1..4).rev().for_each(|i| permutation.swap(i, random(&mut state, i + 1)));
                }
                if apply(&permutations, relator) != [0, 1, 2, 3] {
                    continue;
                }
                let [one, two] = [6, 6].map(|length| word(&mut state, generators, length));
                let [of_one, of_two] = [&one, &two].map(|word| apply(&permutations, word));
                assert!(of_one == [0, 1, 2, 3] || !group.is_unit(&one), "{relator:?} {one:?}");
                let is_conjugate = group.are_conjugate(&one, &two, &mut u64::MAX.clone());
                assert!(
                    cycles(&of_one) == cycles(&of_two) || is_conjugate == Some(false),
                    "{relator:?} {one:?} {two:?}"
                );
                told += 1;
            }
        }
        assert!(told > 1_000, "{told}");
    }

    #[test]
    fn what_is_no_relator_of_a_surface_with_one_vertex_is_refused() {
        let refused: [(usize, &[&[i64]]); 7] = [
            (2, &[&[1, 1]]),
            (2, &[&[1, 2, 1, 2]]),
            (1, &[&[1, 1, 1]]),
            (1, &[&[1, -1]]),
            (3, &[&[1, 2, 3, -1, -2, -3]]),
            (1, &[&[1, 1], &[1, 1]]),
            (1, &[&[]]),
        ];
        for (generators, relators) in refused {
            let relators: Vec<Word> = relators.iter().map(|relator| relator.to_vec()).collect();
            assert!(Group::of(generators, &relators).is_none(), "{relators:?}");
        }
        assert!(
            Group::of(2, &[])
                .is_some_and(|free| free.is_unit(&[1, 2, -2, -1]) && !free.is_unit(&[1, 2, -1, -2]))
        );
    }
}
