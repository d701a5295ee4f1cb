//! What is left of a group when its elements are made to commute.

use crate::words::Word;

/// Larger tables of exponents are not looked at.
const MOST_EXPONENTS: usize = 1 << 18;

/// The rank and the torsion of an abelianized group, factors that divide the next, from the exponents of the generators in its relators. `None` for
/// tables or numbers that are too large.
pub(crate) fn abelianized((generators, relators): &(usize, Vec<Word>)) -> Option<(usize, Vec<u64>)> {
    if generators.checked_mul(relators.len())? > MOST_EXPONENTS {
        return None;
    }
    let mut rows: Vec<Vec<i128>> = Vec::with_capacity(relators.len());
    for relator in relators {
        let mut row = vec![0i128; *generators];
        for letter in relator {
            *row.get_mut(letter.unsigned_abs() as usize - 1)? += i128::from(letter.signum());
        }
        rows.push(row);
    }
    // Rows and columns are added to each other, and what is left alone in its row and its column is taken out.
    let mut factors: Vec<u64> = Vec::new();
    loop {
        rows.retain(|row| row.iter().any(|x| *x != 0));
        let places = rows
            .iter()
            .enumerate()
            .flat_map(|(i, row)| row.iter().enumerate().map(move |(j, x)| (x.abs(), i, j)));
        let Some((_, i, j)) = places.filter(|place| place.0 != 0).min() else { break };
        let pivot_row = rows[i].clone();
        let pivot = pivot_row[j];
        let mut is_alone = true;
        let others = rows.iter_mut().enumerate().filter(|(other, row)| *other != i && row[j] != 0);
        for (_, row) in others {
            let times = row[j] / pivot;
            for (x, y) in row.iter_mut().zip(&pivot_row) {
                *x = x.checked_sub(times.checked_mul(*y)?)?;
            }
            is_alone &= row[j] == 0;
        }
        for k in (0..*generators).filter(|&k| k != j && pivot_row[k] != 0) {
            let times = pivot_row[k] / pivot;
            for row in &mut rows {
                row[k] = row[k].checked_sub(times.checked_mul(row[j])?)?;
            }
            is_alone &= rows[i][k] == 0;
        }
        if is_alone {
            factors.push(u64::try_from(pivot.abs()).ok()?);
            rows.swap_remove(i);
        }
    }
    let rank = generators - factors.len();
    // Z/a + Z/b is Z/gcd + Z/lcm.
    for i in 0..factors.len() {
        for j in i + 1..factors.len() {
            let (a, b) = (factors[i], factors[j]);
            let common = gcd(a, b);
            factors[i] = common;
            factors[j] = (a / common).checked_mul(b)?;
        }
    }
    factors.retain(|&factor| factor > 1);
    Some((rank, factors))
}

fn gcd(a: u64, b: u64) -> u64 {
    if b == 0 { a } else { gcd(b, a % b) }
}

#[cfg(test)]
mod tests {
    use super::abelianized;

    #[test]
    fn groups_of_spaces_have_their_first_homology() {
        for (generators, relators, expected) in [
            (2, vec![vec![1, 2, -1, -2]], (2, vec![])),
            (2, vec![vec![1, 2, -1, 2]], (1, vec![2])),
            (1, vec![vec![1; 6], vec![1; 10]], (0, vec![2])),
            (2, vec![vec![1, 1], vec![2, 2, 2]], (0, vec![6])),
            // The binary icosahedral group, and the group of quaternions.
            (2, vec![vec![1, 1, 1, 1, 1, -2, -2, -2], vec![1, 1, 1, 1, 1, -2, -1, -2, -1]], (0, vec![])),
            (2, vec![vec![1, 1, -2, -2], vec![1, 2, 1, -2]], (0, vec![2, 2])),
            (3, vec![], (3, vec![])),
            (0, vec![], (0, vec![])),
        ] {
            assert_eq!(abelianized(&(generators, relators)), Some(expected));
        }
    }
}
