//! Which cells have coboundaries that are a basis of all coboundaries.

use coface_algebra::chains::MorseComplex;
use coface_algebra::progress::stage;
use coface_algebra::{Field, Integer, Odd, large_primes, smith_form};

/// Cells of `degree - 1` whose coboundaries are a basis, over the rational numbers, of all coboundaries of that degree;
/// rising. The answer is exact.
///
/// The faces of the matched pairs are independent, because their incidences are triangular with units on the diagonal.
/// Eliminating them leaves the coboundaries of the Morse complex; of its critical cells those are added that are
/// independent modulo a large prime. What is independent modulo a prime is so over the rationals, and with as many as
/// the rank it is a basis; for the few primes where they are fewer another prime is taken.
pub(super) fn image_basis(morse: &MorseComplex<'_>, degree: usize) -> Vec<u32> {
    let matching = morse.matching();
    let mut cells: Vec<u32> =
        matching.pairs(morse.complex(), degree).iter().map(|pair| pair.face().to_u32()).collect();
    let boundary = morse.boundary_matrix(degree);
    if boundary.entry_count() > 0 {
        let rank = smith_form(&boundary).rank();
        let coboundary = boundary.transpose();
        let columns: Vec<Vec<(u32, Integer)>> = coboundary
            .columns()
            .map(|column| column.terms().map(|(row, x)| (row as u32, x.clone())).collect())
            .collect();
        let independent = large_primes()
            .map(|prime| independent_columns(&columns, coboundary.row_count(), prime))
            .find(|found| found.len() == rank)
            .expect("a minor that is not zero has few prime divisors");
        let critical = matching.critical_cells(degree - 1);
        cells.extend(independent.into_iter().map(|i| critical[i]));
    }
    cells.sort_unstable();
    cells
}

/// The columns that are no combinations, modulo the prime, of those before.
fn independent_columns(columns: &[Vec<(u32, Integer)>], row_count: usize, prime: u32) -> Vec<usize> {
    let field = Odd::new(prime);
    let mut reduced: Vec<Option<Vec<(u32, u32)>>> = vec![None; row_count];
    let mut independent = Vec::new();
    let steps = stage("finding independent columns", columns.len());
    for (j, column) in columns.iter().enumerate() {
        steps.advance(1);
        let mut rest: Vec<(u32, u32)> =
            column.iter().filter_map(|(row, x)| Some((*row, field.class(x)?))).collect();
        while let Some(&(first, x)) = rest.first() {
            match &reduced[first as usize] {
                Some(other) => rest = plus_multiple(&field, &rest, field.eliminator(x, other[0].1), other),
                None => {
                    reduced[first as usize] = Some(std::mem::take(&mut rest));
                    independent.push(j);
                }
            }
        }
    }
    independent
}

/// The sum of a column and a multiple of another one.
fn plus_multiple(field: &Odd, column: &[(u32, u32)], factor: u32, other: &[(u32, u32)]) -> Vec<(u32, u32)> {
    let mut sum = Vec::with_capacity(column.len() + other.len());
    let (mut a, mut b) = (column.iter().copied().peekable(), other.iter().copied().peekable());
    loop {
        match (a.peek().copied(), b.peek().copied()) {
            (Some((i, x)), Some((j, y))) if i == j => {
                sum.extend(field.sum(x, field.product(factor, y)).map(|total| (i, total)));
                a.next();
                b.next();
            }
            (Some((i, x)), next) if next.is_none_or(|(j, _)| i < j) => {
                sum.push((i, x));
                a.next();
            }
            (_, Some((j, y))) => {
                sum.push((j, field.product(factor, y)));
                b.next();
            }
            _ => return sum,
        }
    }
}
