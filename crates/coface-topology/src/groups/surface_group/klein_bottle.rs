//! The group of the Klein bottle: $a^i t^j$ with $t a = a^{-1} t$.

use super::canonical_system::CanonicalSystem;
use super::polygon_scheme::PolygonScheme;
use coface_algebra::Word;

/// The generators of a scheme of the Klein bottle as exponents [i, j] of $a^i t^j$, and back.
///
/// For crosscaps $c_1, c_2$ with $c_1^2 c_2^2 = 1$ take $t = c_2$, $a = c_1 c_2$.
#[derive(Clone, Debug)]
pub(super) struct KleinBottle {
    generators: [[i64; 2]; 2],
    a: Word,
    t: Word,
}

/// The product of two elements.
pub(super) fn product([i, j]: [i64; 2], [k, l]: [i64; 2]) -> [i64; 2] {
    [if j % 2 == 0 { i + k } else { i - k }, j + l]
}

/// The inverse of an element.
pub(super) fn inverse([i, j]: [i64; 2]) -> [i64; 2] {
    [if j % 2 == 0 { -i } else { i }, -j]
}

/// The least of all conjugates: conjugation by t changes the sign of i, conjugation by a adds 2 to it if j is odd.
pub(super) fn least_conjugate([i, j]: [i64; 2]) -> [i64; 2] {
    [if j % 2 == 0 { i.abs() } else { i.rem_euclid(2) }, j]
}

impl KleinBottle {
    pub(super) fn new(scheme: &PolygonScheme) -> Self {
        let crosscaps = CanonicalSystem::of_scheme(scheme);
        let [c1, c2] = [&crosscaps.generators()[0], &crosscaps.generators()[1]];
        // c1 = a t^-1, c2 = t.
        let exponents = |word: &Word| {
            let letters = word.letters().iter().map(|letter| match letter {
                1 => [1, -1],
                -1 => inverse([1, -1]),
                2 => [0, 1],
                _ => [0, -1],
            });
            letters.fold([0, 0], product)
        };
        let images = crosscaps.images();
        Self { generators: [exponents(&images[0]), exponents(&images[1])], a: c1.times(c2), t: c2.clone() }
    }

    /// The exponents of a letter.
    pub(super) fn letter(&self, letter: i32) -> [i64; 2] {
        let own = self.generators[letter.unsigned_abs() as usize - 1];
        if letter > 0 { own } else { inverse(own) }
    }

    /// A word for the element with these exponents.
    pub(super) fn word(&self, [i, j]: [i64; 2]) -> Word {
        let power = |word: &Word, exponent: i64| {
            let word = if exponent < 0 { word.inverse() } else { word.clone() };
            let letters = std::iter::repeat_n(word.letters(), exponent.unsigned_abs() as usize);
            Word::from_letters(letters.flatten().copied())
        };
        power(&self.a, i).times(&power(&self.t, j))
    }
}
