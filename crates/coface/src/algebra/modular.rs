//! Rank and a determinant of an integer matrix from its residues modulo many primes.

use super::{Integer, SparseVector};
use rayon::prelude::*;

/// The rank of a matrix, and a non-zero minor of that size, positive.
///
/// The matrix is eliminated modulo primes of 31 bits until their product exceeds twice the bound of Hadamard for minors
/// of one more than the rank: a larger minor would vanish modulo all of them, so it is zero, and the minor is known from
/// its residues. Nothing is left to chance; a prime that sees a larger rank starts the search anew.
///
/// # Complexity
/// With b the bits of that bound, b / 30 dense eliminations of 32-bit residues, in parallel.
pub(super) fn rank_and_minor(rows: &[SparseVector], column_count: usize) -> (usize, Integer) {
    let mut first_prime = next_prime_below(1 << 31);
    'search: loop {
        let mut whole = Residues::new(rows, column_count, first_prime);
        let (pivot_rows, pivot_columns) = whole.eliminate().pivots;
        let rank = pivot_rows.len();
        let is_full = rank == rows.len().min(column_count);
        let minor = submatrix(rows, &pivot_rows, &pivot_columns);
        let bits = hadamard_bits(rows, rank + 1) + 1;
        let mut primes = Vec::with_capacity(bits / 30 + 1);
        let mut prime = 1 << 31;
        while primes.len() * 30 < bits {
            prime = next_prime_below(prime);
            primes.push(prime);
        }
        let residues: Vec<(u64, bool)> = primes
            .par_iter()
            .map(|&prime| {
                let determinant = Residues::new(&minor, rank, prime).eliminate().determinant;
                let grows =
                    !is_full && Residues::new(rows, column_count, prime).eliminate().pivots.0.len() > rank;
                (determinant, grows)
            })
            .collect();
        if let Some(at) = residues.iter().position(|&(_, grows)| grows) {
            first_prime = primes[at];
            continue 'search;
        }
        let (mut value, mut product) = (Integer::ZERO, Integer::ONE);
        for (&prime, &(determinant, _)) in primes.iter().zip(&residues) {
            let difference = (determinant + prime - residue(&value, prime)) % prime;
            let step = difference * inverse(residue(&product, prime), prime) % prime;
            value += &(&product * &Integer::from(step as i64));
            product *= &Integer::from(prime as i64);
        }
        let opposite = &product - &value;
        return (rank, value.min(opposite));
    }
}

/// A dense matrix modulo a prime below 2^31.
struct Residues {
    prime: u64,
    column_count: usize,
    rows: Vec<Vec<u32>>,
}

/// What an elimination found.
struct Eliminated {
    /// The rows and the columns of a minor that is not zero modulo the prime.
    pivots: (Vec<u32>, Vec<u32>),
    /// The determinant modulo the prime, if the matrix is square.
    determinant: u64,
}

impl Residues {
    fn new(rows: &[SparseVector], column_count: usize, prime: u64) -> Self {
        let dense = |row: &SparseVector| {
            let mut values = vec![0; column_count];
            for (j, entry) in row {
                values[*j as usize] = residue(entry, prime) as u32;
            }
            values
        };
        Self { prime, column_count, rows: rows.iter().map(dense).collect() }
    }

    fn eliminate(&mut self) -> Eliminated {
        let prime = self.prime;
        let mut order: Vec<u32> = (0..self.rows.len() as u32).collect();
        let (mut pivot_columns, mut determinant) = (Vec::new(), 1);
        for column in 0..self.column_count {
            let rank = pivot_columns.len();
            let Some(at) = (rank..self.rows.len()).find(|&i| self.rows[i][column] != 0) else { continue };
            if at != rank {
                self.rows.swap(at, rank);
                order.swap(at, rank);
                determinant = (prime - determinant) % prime;
            }
            let (above, below) = self.rows.split_at_mut(rank + 1);
            let pivot_row = &above[rank][column..];
            let pivot = u64::from(pivot_row[0]);
            determinant = determinant * pivot % prime;
            let reciprocal = inverse(pivot, prime);
            for row in below {
                if row[column] == 0 {
                    continue;
                }
                let factor = prime - u64::from(row[column]) * reciprocal % prime;
                for (entry, &above) in row[column..].iter_mut().zip(pivot_row) {
                    *entry = ((u64::from(*entry) + factor * u64::from(above)) % prime) as u32;
                }
            }
            pivot_columns.push(column as u32);
        }
        if pivot_columns.len() < self.rows.len() {
            determinant = 0;
        }
        order.truncate(pivot_columns.len());
        Eliminated { pivots: (order, pivot_columns), determinant }
    }
}

/// The rows and columns of these numbers, columns rising.
fn submatrix(rows: &[SparseVector], row_numbers: &[u32], columns: &[u32]) -> Vec<SparseVector> {
    let pick = |&i: &u32| {
        let terms = rows[i as usize].iter();
        terms.filter_map(|(j, entry)| Some((columns.binary_search(j).ok()? as u32, entry.clone()))).collect()
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

/// The residue from 0 to `prime` - 1.
fn residue(value: &Integer, prime: u64) -> u64 {
    match value.to_i64() {
        Some(small) => small.rem_euclid(prime as i64) as u64,
        None => {
            let rest = value.div_rem_floor(&Integer::from(prime as i64)).1;
            rest.to_i64().expect("a remainder is below its divisor") as u64
        }
    }
}

/// The inverse modulo a prime, by Fermat's theorem.
fn inverse(value: u64, prime: u64) -> u64 {
    let (mut base, mut exponent, mut power) = (value, prime - 2, 1);
    while exponent > 0 {
        if exponent & 1 == 1 {
            power = power * base % prime;
        }
        base = base * base % prime;
        exponent >>= 1;
    }
    power
}

/// The largest prime below `limit`, which is above 2^30; there are 50 million of them between 2^30 and 2^31.
fn next_prime_below(limit: u64) -> u64 {
    let is_prime = |n: u64| {
        !n.is_multiple_of(2) && (3u64..).step_by(2).take_while(|d| d * d <= n).all(|d| !n.is_multiple_of(d))
    };
    (0..limit).rev().find(|&n| is_prime(n)).expect("there is a prime below any number above 2")
}
