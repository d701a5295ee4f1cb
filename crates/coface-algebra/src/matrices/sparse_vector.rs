//! Sparse integer vectors, the columns and rows of eliminations and the chains of a reduction.

use crate::integers::Integer;
use std::collections::BTreeMap;

/// An integer vector by its entries: (position, entry), positions rising, no entry zero.
pub type SparseVector = Vec<(u32, Integer)>;

/// The entry at a position.
pub(crate) fn entry_of(vector: &[(u32, Integer)], position: u32) -> Option<&Integer> {
    vector.binary_search_by_key(&position, |&(at, _)| at).ok().map(|at| &vector[at].1)
}

/// The inner product of two vectors.
pub fn inner_product(a: &[(u32, Integer)], b: &[(u32, Integer)]) -> Integer {
    // The shorter one is walked, the longer one searched: vectors here are a few entries against many.
    let (short, long) = if a.len() <= b.len() { (a, b) } else { (b, a) };
    let mut sum = Integer::ZERO;
    for (position, x) in short {
        if let Some(y) = entry_of(long, *position) {
            sum += &(x * y);
        }
    }
    sum
}

/// The sum of multiples of vectors.
pub fn linear_combination<'a>(
    terms: impl IntoIterator<Item = (&'a Integer, &'a [(u32, Integer)])>,
) -> SparseVector {
    let mut sum: BTreeMap<u32, Integer> = BTreeMap::new();
    for (factor, vector) in terms {
        for (position, entry) in vector {
            *sum.entry(*position).or_default() += &(factor * entry);
        }
    }
    sum.into_iter().filter(|(_, entry)| !entry.is_zero()).collect()
}

/// $x a + y b$ of two vectors.
pub fn combination(x: &Integer, a: &[(u32, Integer)], y: &Integer, b: &[(u32, Integer)]) -> SparseVector {
    let mut sum = SparseVector::with_capacity(a.len() + b.len());
    let (mut i, mut j) = (0, 0);
    while i < a.len() || j < b.len() {
        let at = match (a.get(i), b.get(j)) {
            (Some(left), Some(right)) => left.0.min(right.0),
            (Some(one), None) | (None, Some(one)) => one.0,
            (None, None) => break,
        };
        let mut value = Integer::ZERO;
        if let Some((_, entry)) = a.get(i).filter(|&&(position, _)| position == at) {
            value += &(x * entry);
            i += 1;
        }
        if let Some((_, entry)) = b.get(j).filter(|&&(position, _)| position == at) {
            value += &(y * entry);
            j += 1;
        }
        if !value.is_zero() {
            sum.push((at, value));
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    fn vector(entries: &[(u32, i64)]) -> SparseVector {
        entries.iter().map(|&(at, x)| (at, x.into())).collect()
    }

    #[test]
    fn sums_drop_what_cancels() {
        let (a, b) = (vector(&[(0, 2), (3, 1)]), vector(&[(0, 4), (2, 5)]));
        let two = Integer::from(2);
        let difference = combination(&two, &a, &Integer::from(-1), &b);
        assert_eq!(difference, vector(&[(2, -5), (3, 2)]));
        assert_eq!(linear_combination([(&two, &a[..]), (&Integer::from(-1), &b[..])]), difference);
        assert_eq!(inner_product(&a, &b), Integer::from(8));
        assert_eq!(inner_product(&a, &[]), Integer::ZERO);
    }
}
