//! The algorithm of Dehn.

use super::polygon_scheme::PolygonScheme;
use coface_algebra::{Sign, Word};

/// A side of the polygon and the direction in which it is run through.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Place {
    side: u32,
    direction: Sign,
}

/// A letter of the word with the longest piece of the polygon's boundary that ends there.
#[derive(Clone, Copy, Debug)]
struct Read {
    letter: i32,
    /// Where it is on the boundary, once two letters have told.
    place: Option<Place>,
    length: u32,
}

impl PolygonScheme {
    /// The letters along the shorter way around the boundary from one corner to another.
    pub(super) fn letters_between(&self, from: u32, to: u32) -> Vec<i32> {
        let degree = self.side_count();
        let (from, to) = (from as usize, to as usize);
        let forward = (to + degree - from) % degree;
        if 2 * forward <= degree {
            (0..forward).map(|i| self.letters()[(from + i) % degree]).collect()
        } else {
            (1..=degree - forward).map(|i| -self.letters()[(from + degree - i) % degree]).collect()
        }
    }

    fn letter_at(&self, place: Place) -> i32 {
        self.letters()[place.side as usize] * place.direction.to_i32()
    }

    fn after(&self, place: Place) -> Place {
        let degree = self.side_count() as u32;
        let step = if place.direction == Sign::Plus { 1 } else { degree - 1 };
        Place { side: (place.side + step) % degree, ..place }
    }

    /// The two places where a letter is read.
    fn places(&self, letter: i32) -> [Place; 2] {
        let side = self.first_side(letter);
        [side, self.mate(side)].map(|side| Place {
            side: side as u32,
            direction: if self.letters()[side] == letter { Sign::Plus } else { Sign::Minus },
        })
    }

    /// The word with every piece that is more than half of the relator replaced by the inverse of the rest.
    ///
    /// For 3 or more generators the unit is the only element whose reduced word is empty: two copies of the relator
    /// have at most one letter in common and at least three meet at every vertex (small cancellation C'(1/4), T(4)).
    ///
    /// # Complexity
    /// Linear in the word times the number of generators.
    ///
    /// # References
    /// M. Dehn, *Transformation der Kurven auf zweiseitigen Flaechen* (1912); R. C. Lyndon, P. E. Schupp,
    /// *Combinatorial group theory* (1977), chapter V, theorem 4.4.
    pub(super) fn dehn_reduced(&self, word: &Word) -> Word {
        let half = self.generator_count() as u32;
        let mut read: Vec<Read> = Vec::new();
        let mut ahead: Vec<i32> = word.letters().iter().rev().copied().collect();
        while let Some(letter) = ahead.pop() {
            if read.last().is_some_and(|last| last.letter == -letter) {
                read.pop();
                continue;
            }
            let next = self.read_after(read.last(), letter);
            let (length, place) = (next.length, next.place);
            read.push(next);
            if let Some(mut at) = place.filter(|_| length > half) {
                read.truncate(read.len() - length as usize);
                // The rest of the boundary, against the direction of the piece.
                let rest = 2 * half - length;
                for _ in 0..rest {
                    at = self.after(at);
                    ahead.push(-self.letter_at(at));
                }
                // The inverse of the rest starts with its last letter, which is on top.
            }
        }
        Word::from_letters(read.into_iter().map(|read| read.letter))
    }

    /// A letter with the piece that it continues or starts.
    fn read_after(&self, last: Option<&Read>, letter: i32) -> Read {
        let single = Read { letter, place: None, length: 1 };
        let Some(last) = last else { return single };
        let continued = |place: Place, length: u32| {
            let next = self.after(place);
            (self.letter_at(next) == letter).then_some(Read { letter, place: Some(next), length: length + 1 })
        };
        if let Some(read) = last.place.and_then(|place| continued(place, last.length)) {
            return read;
        }
        self.places(last.letter).into_iter().find_map(|place| continued(place, 1)).unwrap_or(single)
    }
}
