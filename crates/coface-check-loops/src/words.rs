//! Words in free groups: i is generator i, counted from 1, and -i its inverse.

use coface_check::Fault;
use coface_check::json::list;
use serde_json::Value;

/// A word without a letter beside its inverse.
pub type Word = Vec<i64>;

/// Appends letters, of which each cancels with its inverse before it.
pub fn append(word: &mut Word, letters: impl IntoIterator<Item = i64>) {
    for letter in letters {
        match word.last() {
            Some(last) if *last == -letter => drop(word.pop()),
            _ => word.push(letter),
        }
    }
}

/// The inverse of a word.
pub fn inverse(word: &[i64]) -> Word {
    word.iter().rev().map(|letter| -letter).collect()
}

/// Without letters at the end that cancel with those at the start: a conjugate of the word.
pub fn cyclically_reduced(word: &[i64]) -> Word {
    let mut rest = word;
    while let [first, middle @ .., last] = rest
        && *first == -last
    {
        rest = middle;
    }
    rest.to_vec()
}

/// The letters from a place on and around.
pub fn rotated(word: &[i64], from: usize) -> Word {
    let from = if word.is_empty() { 0 } else { from % word.len() };
    [&word[from..], &word[..from]].concat()
}

/// The least rotation (K. S. Booth, 1980; in the form of J. Duval).
pub fn least_rotation(word: &[i64]) -> Word {
    let (count, mut best, mut other, mut same) = (word.len(), 0, 1, 0);
    while best < count && other < count && same < count {
        let [a, b] = [best, other].map(|start| word[(start + same) % count]);
        if a == b {
            same += 1;
            continue;
        }
        if a > b {
            best += same + 1;
        } else {
            other += same + 1;
        }
        other += usize::from(best == other);
        same = 0;
    }
    rotated(word, best.min(other))
}

/// One form of all rotations of a word and of its inverse: as relators they mean the same.
pub fn cyclic_form(word: &[i64]) -> Word {
    let word = cyclically_reduced(word);
    least_rotation(&word).min(least_rotation(&inverse(&word)))
}

/// A word of a certificate, in so many generators.
pub fn read(value: &Value, generators: usize, step: &str) -> Result<Word, Fault> {
    let mut word = Word::new();
    for letter in list(value, "a word", step)? {
        let letter =
            letter.as_i64().filter(|letter| (1..=generators as u64).contains(&letter.unsigned_abs()));
        append(&mut word, [letter.ok_or_else(|| Fault::new(step, "a letter is no generator"))?]);
    }
    Ok(word)
}

#[cfg(test)]
mod tests {
    use super::{append, cyclic_form, cyclically_reduced, least_rotation};

    #[test]
    fn rotations_and_inverses_have_one_form() {
        let word = [2, 1, -2, -1, 1, 3];
        let mut reduced = Vec::new();
        append(&mut reduced, word);
        assert_eq!(reduced, [2, 1, -2, 3]);
        assert_eq!(cyclically_reduced(&[1, 2, 3, -1]), [2, 3]);
        for i in 0..4 {
            let rotation = super::rotated(&reduced, i);
            assert_eq!(cyclic_form(&rotation), cyclic_form(&reduced));
            assert_eq!(cyclic_form(&super::inverse(&rotation)), cyclic_form(&reduced));
            let all = (0..4).map(|j| super::rotated(&rotation, j));
            assert_eq!(Some(least_rotation(&rotation)), all.min());
        }
        assert_ne!(cyclic_form(&[1, 2, -1, -2]), cyclic_form(&[1, 2, 1, 2]));
        assert!(cyclic_form(&[]).is_empty());
    }
}
