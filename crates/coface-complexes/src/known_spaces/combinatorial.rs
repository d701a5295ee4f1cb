//! Complexes of combinatorics: boards, matchings, sums, books.

use super::{from_rule, require};
use crate::simplicial::SimplicialComplex;
use coface_algebra::Error;

/// The book: `pages` triangles on one common edge {0, 1}.
///
/// # Errors
/// [`coface_algebra::ErrorKind::InvalidInput`] for more than 2^24 pages.
///
/// # Examples
/// ```
/// use coface_complexes::known_spaces;
/// assert_eq!(known_spaces::book(3)?.f_vector(), [5, 7, 3]);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn book(pages: u32) -> Result<SimplicialComplex, Error> {
    require(pages <= 1 << 24, || format!("a book of {pages} pages is not built; up to 2^24 are"))?;
    from_rule((0..pages).map(|i| vec![0, 1, 2 + i]).chain([vec![0, 1]]))
}

/// The chessboard complex: the vertices are the squares of a board of `rows` x `columns` (number row * columns +
/// column), the simplices the sets of rooks that do not attack each other.
///
/// # Errors
/// [`coface_algebra::ErrorKind::InvalidInput`] without squares or beyond 8 rows and columns.
///
/// # Examples
/// ```
/// use coface_complexes::known_spaces;
/// assert_eq!(known_spaces::chessboard(3, 4)?.f_vector(), [12, 36, 24]);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn chessboard(rows: u32, columns: u32) -> Result<SimplicialComplex, Error> {
    require((1..=8).contains(&rows) && (1..=8).contains(&columns), || {
        format!("a chessboard of {rows} x {columns} squares is not built; 1 to 8 each are")
    })?;
    // Each facet has a rook in every line of the shorter direction.
    let (short, long) = (rows.min(columns), rows.max(columns));
    let mut facets = Vec::new();
    let mut chosen = Vec::new();
    fn extend(chosen: &mut Vec<u32>, short: u32, long: u32, facets: &mut Vec<Vec<u32>>) {
        if chosen.len() == short as usize {
            return facets.push(chosen.clone());
        }
        for place in 0..long {
            if !chosen.contains(&place) {
                chosen.push(place);
                extend(chosen, short, long, facets);
                chosen.pop();
            }
        }
    }
    extend(&mut chosen, short, long, &mut facets);
    from_rule(facets.into_iter().map(|facet| {
        let square = |(line, place): (usize, u32)| {
            if rows <= columns { line as u32 * columns + place } else { place * columns + line as u32 }
        };
        facet.into_iter().enumerate().map(square).collect()
    }))
}

/// The matching complex: the vertices are the pairs of `0..count` in lexicographic order, the simplices the sets of
/// disjoint pairs.
///
/// # Errors
/// [`coface_algebra::ErrorKind::InvalidInput`] unless the count is 2 to 12.
///
/// # Examples
/// ```
/// use coface_complexes::known_spaces;
/// assert_eq!(known_spaces::matching_complex(7)?.f_vector(), [21, 105, 105]);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn matching_complex(count: u32) -> Result<SimplicialComplex, Error> {
    require((2..=12).contains(&count), || {
        format!("a matching complex on {count} points is not built; 2 to 12 are")
    })?;
    // The pair a < b has the number of pairs before it.
    let pair = |a: u32, b: u32| a * count - a * (a + 1) / 2 + b - a - 1;
    let mut facets = Vec::new();
    fn extend(free: &[u32], spare: bool, chosen: &mut Vec<[u32; 2]>, facets: &mut Vec<Vec<[u32; 2]>>) {
        let Some((&a, rest)) = free.split_first() else { return facets.push(chosen.clone()) };
        if spare {
            extend(rest, false, chosen, facets);
        }
        for (i, &b) in rest.iter().enumerate() {
            let others: Vec<u32> =
                rest.iter().enumerate().filter(|&(j, _)| j != i).map(|(_, &v)| v).collect();
            chosen.push([a, b]);
            extend(&others, spare, chosen, facets);
            chosen.pop();
        }
    }
    extend(&(0..count).collect::<Vec<_>>(), count % 2 == 1, &mut Vec::new(), &mut facets);
    from_rule(facets.into_iter().map(|matching| matching.into_iter().map(|[a, b]| pair(a, b)).collect()))
}

/// The sum complex: vertices are the integers modulo `modulus`; the facets are the sets of as many vertices as
/// `sums` has members whose sum is among them; every smaller set is a simplex.
///
/// # Errors
/// [`coface_algebra::ErrorKind::InvalidInput`] unless there are 2 to 5 different sums and the modulus is larger and at most 200.
///
/// # References
/// N. Linial, R. Meshulam, M. Rosenthal, *Sum complexes: a new family of hypertrees* (2010).
///
/// # Examples
/// ```
/// use coface_complexes::known_spaces;
/// assert_eq!(known_spaces::sum_complex(11, &[0, 1, 3])?.f_vector(), [11, 55, 45]);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn sum_complex(modulus: u32, sums: &[u32]) -> Result<SimplicialComplex, Error> {
    let mut sums: Vec<u32> = sums.iter().map(|s| s % modulus.max(1)).collect();
    sums.sort_unstable();
    sums.dedup();
    let size = sums.len();
    require((2..=5).contains(&size) && size < modulus as usize && modulus <= 200, || {
        format!(
            "a sum complex modulo {modulus} with {size} different sums is not built; 2 to 5 sums are, modulo at most 200"
        )
    })?;
    let mut facets = Vec::new();
    let mut chosen: Vec<u32> = (0..size as u32).collect();
    loop {
        if sums.contains(&(chosen.iter().sum::<u32>() % modulus)) {
            facets.push(chosen.clone());
        } else {
            // Every proper subset stays a simplex.
            facets.extend(
                (0..size)
                    .map(|i| chosen.iter().enumerate().filter(|&(j, _)| j != i).map(|(_, &v)| v).collect()),
            );
        }
        // The next combination in lexicographic order.
        let Some(i) = (0..size).rev().find(|&i| chosen[i] < modulus - (size - i) as u32) else { break };
        chosen[i] += 1;
        for j in i + 1..size {
            chosen[j] = chosen[j - 1] + 1;
        }
    }
    from_rule(facets)
}
