//! Products against the definition.
#![allow(clippy::unwrap_used, reason = "a test that cannot go on is the test failing")]

use coface_graphblas::{Error, Matrix};
use proptest::prelude::*;
use std::collections::BTreeMap;

type Entries = Vec<(u32, u32, i32)>;

/// The entries of a matrix that are not zero, added by places.
fn added(entries: &Entries) -> BTreeMap<(u32, u32), i64> {
    let mut sums = BTreeMap::new();
    for &(row, column, entry) in entries {
        *sums.entry((row, column)).or_insert(0) += i64::from(entry);
    }
    sums.retain(|_, sum| *sum != 0);
    sums
}

fn places(matrix: &Matrix) -> BTreeMap<(u32, u32), i64> {
    let columns = matrix.to_columns().unwrap();
    assert_eq!(columns.starts.len(), matrix.column_count() + 1);
    let mut places = BTreeMap::new();
    for (column, pair) in (0..).zip(columns.starts.windows(2)) {
        let range = pair[0] as usize..pair[1] as usize;
        assert!(columns.rows[range.clone()].is_sorted_by(|a, b| a < b));
        for i in range {
            places.insert((columns.rows[i], column), i64::from(columns.entries[i]));
        }
    }
    places
}

#[test]
fn faults_are_named() {
    let one = Matrix::from_entries(1, 1, &[(0, 0, i32::MAX)]).unwrap();
    let wide = Matrix::from_entries(2, 1, &[]).unwrap();
    assert!(matches!(wide.product(&wide), Err(Error::Shape(_))));
    let square = one.product(&one).unwrap();
    assert!(matches!(square.to_columns(), Err(Error::TooLarge(_))));
    assert!(matches!(square.product(&square), Err(Error::TooLarge(_))));
    assert!(matches!(Matrix::from_entries(1, 1, &[(0, 1, 1)]), Err(Error::Shape(_))));
    assert!(matches!(Matrix::from_columns(2, &[0, 1], &[2], &[1]), Err(Error::Shape(_))));
    assert!(matches!(Matrix::from_columns(2, &[0, 2], &[1], &[1]), Err(Error::Shape(_))));
    assert!(matches!(Matrix::from_columns(2, &[], &[], &[]), Err(Error::Shape(_))));
    // Rows in any order are fine, a row twice is not: in sorted and in unsorted columns.
    assert!(Matrix::from_columns(3, &[0, 1, 4], &[1, 2, 0, 1], &[1; 4]).is_ok());
    for rows in [[1, 0, 1, 1], [1, 1, 0, 1], [1, 2, 0, 2]] {
        let error = Matrix::from_columns(3, &[0, 1, 4], &rows, &[1; 4]).unwrap_err();
        assert!(
            matches!(&error, Error::Shape(message) if message.contains("twice in column 1")),
            "{rows:?}: {error}"
        );
    }
    let none = Matrix::from_columns(0, &[0], &[], &[]).unwrap();
    assert_eq!(none.product(&none).unwrap().to_columns().unwrap().starts, [0]);
}

proptest! {
    #[test]
    fn products_agree_with_the_definition(
        counts in (1usize..9, 1usize..9, 1usize..9),
        first in prop::collection::vec((any::<u32>(), any::<u32>(), -3i32..4), 0..30),
        second in prop::collection::vec((any::<u32>(), any::<u32>(), -3i32..4), 0..30),
    ) {
        let (m, n, k) = counts;
        let within = |entries: &Entries, rows: usize, columns: usize| -> Entries {
            entries.iter().map(|&(i, j, entry)| (i % rows as u32, j % columns as u32, entry)).collect()
        };
        let (first, second) = (within(&first, m, n), within(&second, n, k));
        let [a, b] = [
            Matrix::from_entries(m, n, &first).unwrap(),
            Matrix::from_entries(n, k, &second).unwrap(),
        ];
        prop_assert_eq!(places(&a), added(&first));
        // Through compressed columns and back it is the same matrix.
        let columns = b.to_columns().unwrap();
        let again = Matrix::from_columns(n, &columns.starts, &columns.rows, &columns.entries).unwrap();
        prop_assert_eq!(again.to_columns().unwrap(), columns);
        let mut expected = BTreeMap::new();
        for (&(i, j), x) in &added(&first) {
            for (&(l, c), y) in &added(&second) {
                if j == l {
                    *expected.entry((i, c)).or_insert(0) += x * y;
                }
            }
        }
        expected.retain(|_, sum| *sum != 0);
        for b in [&b, &again] {
            prop_assert_eq!(places(&a.product(b).unwrap()), expected.clone());
        }
    }
}
