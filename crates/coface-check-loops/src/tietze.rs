//! Tietze moves, one after the other.

use crate::words::{Word, append, cyclic_form, cyclically_reduced, inverse, read, rotated};
use coface_check::Fault;
use coface_check::json::{field, index, list, text, truth};
use serde_json::Value;

/// Relators have at most so many letters together for each byte of the certificate.
const MOST_LETTERS: usize = 1 << 26;

/// Generators and cyclically reduced relators. Those that are gone keep their numbers: relators are empty then.
pub(crate) struct Presentation {
    is_there: Vec<bool>,
    relators: Vec<Word>,
}

impl Presentation {
    pub(crate) fn new(generators: usize, relators: Vec<Word>) -> Self {
        Self { is_there: vec![true; generators], relators }
    }

    /// The generators with new numbers, in their order, and the relators that are left: how many there are, and their sorted forms.
    pub(crate) fn left(&self) -> (usize, Vec<Word>) {
        let mut numbers = Vec::new();
        let mut next = 0;
        for is_there in &self.is_there {
            next += i64::from(*is_there);
            numbers.push(next);
        }
        let new = |letter: &i64| letter.signum() * numbers[letter.unsigned_abs() as usize - 1];
        let left = self.relators.iter().filter(|relator| !relator.is_empty());
        let mut left: Vec<Word> =
            left.map(|word| cyclic_form(&word.iter().map(new).collect::<Word>())).collect();
        left.sort_unstable();
        (next as usize, left)
    }

    /// Does a move, which keeps the group.
    pub(crate) fn apply(&mut self, step: &Value) -> Result<(), Fault> {
        let place = "moves";
        let fault = |message: &str| Err(Fault::new(place, message));
        let number = |key: &str| index(field(step, key, place)?, key, place).map(|number| number as usize);
        let relator = |key: &str| match number(key)? {
            found if found < self.relators.len() => Ok(found),
            _ => Err(Fault::new(place, "there is no such relator")),
        };
        let generator = |letter: i64| match usize::try_from(letter.unsigned_abs()) {
            Ok(found) if found > 0 && self.is_there.get(found - 1) == Some(&true) => Ok(letter),
            _ => Err(Fault::new(place, "there is no such generator")),
        };
        match text(field(step, "move", place)?, "\"move\"", place)? {
            // A relator that another one says, or its inverse, is not needed.
            "duplicate" => {
                let (gone, like) = (relator("relator")?, relator("like")?);
                if gone == like || cyclic_form(&self.relators[gone]) != cyclic_form(&self.relators[like]) {
                    return fault("the relators are not alike");
                }
                self.relators[gone].clear();
            }
            // Where u v is the unit, u is the inverse of v.
            "rewrite" => {
                let (changed, by) = (relator("relator")?, relator("by")?);
                let (at, from, length) = (number("at")?, number("from")?, number("length")?);
                let other = match truth(field(step, "inverted", place)?, "\"inverted\"", place)? {
                    true => inverse(&self.relators[by]),
                    false => self.relators[by].clone(),
                };
                let (other, whole) = (rotated(&other, from), rotated(&self.relators[changed], at));
                let (Some(part), Some(same)) = (other.get(..length), whole.get(..length)) else {
                    return fault("the part is longer than a relator");
                };
                if changed == by || part != same {
                    return fault("the part is not in both relators");
                }
                let mut word = inverse(&other[length..]);
                append(&mut word, whole[length..].iter().copied());
                self.relators[changed] = cyclically_reduced(&word);
            }
            // x w = 1 with x once says that x is the inverse of w: x and this relator go.
            "eliminate" => {
                let x = generator(number("generator")? as i64)?;
                let gone = relator("relator")?;
                let word = &self.relators[gone];
                let mut places = (0..word.len()).filter(|&i| word[i].abs() == x);
                let (Some(at), None) = (places.next(), places.next()) else {
                    return fault("the generator is not once in the relator");
                };
                let around = rotated(word, at);
                let rest = around[1..].to_vec();
                let value = if around[0] > 0 { inverse(&rest) } else { rest };
                self.relators[gone].clear();
                self.substitute(x, &value)?;
                self.is_there[x as usize - 1] = false;
            }
            // The new generator is x l or l x.
            "multiply" => {
                let x = generator(number("generator")? as i64)?;
                let letter = field(step, "letter", place)?.as_i64().unwrap_or(0);
                let letter = generator(letter)?;
                if letter.abs() == x {
                    return fault("a generator is multiplied by itself");
                }
                match truth(field(step, "on_right", place)?, "\"on_right\"", place)? {
                    true => self.substitute(x, &[x, -letter])?,
                    false => self.substitute(x, &[-letter, x])?,
                }
            }
            other => return fault(&format!("{other:.20?} is no move")),
        }
        Ok(())
    }

    /// Replaces a generator by a word in all relators.
    fn substitute(&mut self, x: i64, value: &[i64]) -> Result<(), Fault> {
        let back = inverse(value);
        for relator in &mut self.relators {
            if !relator.iter().any(|letter| letter.abs() == x) {
                continue;
            }
            let mut word = Word::new();
            for &letter in relator.iter() {
                match letter.abs() == x {
                    true => append(&mut word, (if letter > 0 { value } else { &back }).iter().copied()),
                    false => append(&mut word, [letter]),
                }
                if word.len() > MOST_LETTERS {
                    return Err(Fault::new("moves", "a relator has too many letters"));
                }
            }
            *relator = cyclically_reduced(&word);
        }
        match self.relators.iter().map(Vec::len).sum::<usize>() > MOST_LETTERS {
            true => Err(Fault::new("moves", "the relators have too many letters")),
            false => Ok(()),
        }
    }
}

/// Relators of a certificate, cyclically reduced.
pub(crate) fn relators(value: &Value, generators: usize, step: &str) -> Result<Vec<Word>, Fault> {
    let words = list(value, "the relators", step)?.iter().map(|word| read(word, generators, step));
    words.map(|word| word.map(|word| cyclically_reduced(&word))).collect()
}
