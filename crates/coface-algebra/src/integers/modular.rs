//! Rank and a determinant of an integer matrix from its residues modulo many primes.

use crate::ids::narrow;
use crate::integers::integer::Integer;
use crate::integers::prime_field::{Field, Odd};
use crate::integers::primes::large_primes;
use crate::matrices::SparseVector;
use crate::progress::{Steps, stage};
use crate::threads;

/// The rank of a matrix, and a non-zero minor of that size, positive.
///
/// The matrix is eliminated modulo primes of 31 bits until their product exceeds twice the bound of Hadamard for minors
/// of one more than the rank: a larger minor would vanish modulo all of them, so it is zero, and the minor is known
/// from its residues. The result is certain: a prime with a larger rank restarts the search.
///
/// # Complexity
/// With b the bits of that bound, b / 30 dense eliminations of 32-bit residues, in parallel.
pub(crate) fn rank_and_minor(rows: &[SparseVector], column_count: usize) -> (usize, Integer) {
    let mut first_prime = large_primes().next().expect("there are odd primes");
    'search: loop {
        let ranking = stage("finding the rank", column_count);
        let mut whole = Residues::new(rows, column_count, first_prime);
        let (pivot_rows, pivot_columns) = whole.eliminate(&ranking).pivots;
        drop(ranking);
        let rank = pivot_rows.len();
        let is_full = rank == rows.len().min(column_count);
        let minor = submatrix(rows, &pivot_rows, &pivot_columns);
        let bits = hadamard_bits(rows, rank + 1) + 1;
        // Each of them has more than 30 bits.
        let primes: Vec<u32> = large_primes().take(bits.div_ceil(30)).collect();
        let steps = stage(
            "finding a minor modulo primes",
            primes.len() * (rank + if is_full { 0 } else { column_count }),
        );
        let work = primes.len().saturating_mul(rows.len()).saturating_mul(rank * column_count);
        let residues: Vec<(u32, bool)> = threads::mapped(primes.len(), work, |at| {
            let prime = primes[at];
            let determinant = Residues::new(&minor, rank, prime).eliminate(&steps).determinant;
            let grows =
                !is_full && Residues::new(rows, column_count, prime).eliminate(&steps).pivots.0.len() > rank;
            (determinant, grows)
        });
        if let Some(at) = residues.iter().position(|&(_, grows)| grows) {
            first_prime = primes[at];
            continue 'search;
        }
        let (mut value, mut product) = (Integer::ZERO, Integer::ONE);
        for (&prime, &(determinant, _)) in primes.iter().zip(&residues) {
            let field = Odd::new(prime);
            let missing = field.class(&(&Integer::from(i64::from(determinant)) - &value));
            let product_here = field.class(&product).expect("the primes differ");
            let step = missing.map_or(0, |missing| field.product(missing, field.inverse(product_here)));
            value += &(&product * &Integer::from(i64::from(step)));
            product *= &Integer::from(i64::from(prime));
        }
        let opposite = &product - &value;
        return (rank, value.min(opposite));
    }
}

/// A dense matrix modulo a prime below 2^31.
struct Residues {
    prime: u32,
    column_count: usize,
    rows: Vec<Vec<u32>>,
}

/// What an elimination found.
struct Eliminated {
    /// The rows and the columns of a minor that is not zero modulo the prime.
    pivots: (Vec<u32>, Vec<u32>),
    /// The determinant modulo the prime, if the matrix is square.
    determinant: u32,
}

impl Residues {
    fn new(rows: &[SparseVector], column_count: usize, prime: u32) -> Self {
        let field = Odd::new(prime);
        let dense = |row: &SparseVector| {
            let mut values = vec![0; column_count];
            for (j, entry) in row {
                values[*j as usize] = field.class(entry).unwrap_or(0);
            }
            values
        };
        Self { prime, column_count, rows: rows.iter().map(dense).collect() }
    }

    /// Each column is a step.
    #[allow(clippy::cast_possible_truncation, reason = "residues are below the prime, which has 31 bits")]
    fn eliminate(&mut self, steps: &Steps) -> Eliminated {
        let (field, prime) = (Odd::new(self.prime), u64::from(self.prime));
        let mut order: Vec<u32> = (0..narrow(self.rows.len())).collect();
        let (mut pivot_columns, mut determinant) = (Vec::new(), 1u64);
        for column in 0..self.column_count {
            steps.advance(1);
            let rank = pivot_columns.len();
            let Some(at) = (rank..self.rows.len()).find(|&i| self.rows[i][column] != 0) else { continue };
            if at != rank {
                self.rows.swap(at, rank);
                order.swap(at, rank);
                determinant = (prime - determinant) % prime;
            }
            let (above, below) = self.rows.split_at_mut(rank + 1);
            let pivot_row = &above[rank][column..];
            let pivot = pivot_row[0];
            determinant = determinant * u64::from(pivot) % prime;
            let reciprocal = u64::from(field.inverse(pivot));
            for row in below {
                if row[column] == 0 {
                    continue;
                }
                let factor = prime - u64::from(row[column]) * reciprocal % prime;
                for (entry, &above) in row[column..].iter_mut().zip(pivot_row) {
                    *entry = ((u64::from(*entry) + factor * u64::from(above)) % prime) as u32;
                }
            }
            pivot_columns.push(narrow(column));
        }
        if pivot_columns.len() < self.rows.len() {
            determinant = 0;
        }
        order.truncate(pivot_columns.len());
        Eliminated { pivots: (order, pivot_columns), determinant: determinant as u32 }
    }
}

/// The rows and columns of these numbers, columns rising.
fn submatrix(rows: &[SparseVector], row_numbers: &[u32], columns: &[u32]) -> Vec<SparseVector> {
    let pick = |&i: &u32| {
        let terms = rows[i as usize].iter();
        terms.filter_map(|(j, entry)| Some((narrow(columns.binary_search(j).ok()?), entry.clone()))).collect()
    };
    row_numbers.iter().map(pick).collect()
}

/// Bits of a bound on the minors of up to `size` rows: the product of the longest rows, by Hadamard's inequality.
fn hadamard_bits(rows: &[SparseVector], size: usize) -> usize {
    // A row of m entries of at most b bits is shorter than sqrt(m) 2^b; twice the bits keeps the halves.
    let mut doubled: Vec<usize> = rows
        .iter()
        .map(|row| {
            let bits = row.iter().map(|(_, entry)| entry.bit_length()).max().unwrap_or(0);
            2 * bits + row.len().next_power_of_two().ilog2() as usize
        })
        .collect();
    doubled.sort_unstable_by(|a, b| b.cmp(a));
    doubled.iter().take(size).sum::<usize>().div_ceil(2) + 1
}
