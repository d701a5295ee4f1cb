//! The primes on which a persistence diagram depends.

use super::reduction::{Level, NONE, persistence};
use super::{Filtration, PersistenceDiagram};
use crate::homology::Coefficients;
use coface_algebra::chains::ChainComplex;
use coface_algebra::progress::stage;
use coface_algebra::{Error, Integer, Odd, SparseMatrix};
use std::collections::{BTreeMap, BTreeSet};

/// The primes p below 2^31 for which the diagram over the field of p elements pairs other cells than the one over the rational numbers.
///
/// They are the primes of torsion that comes or goes somewhere along the filtration. Where there are none, cycles over any field have the births and the
/// deaths of integral cycles.
///
/// Coboundaries are reduced over the integers; a prime that divides no leading coefficient changes nothing. Diagrams over the others are compared.
///
/// # Errors
/// Those of [`Filtration::check`].
///
/// # Complexity
/// That of [`persistence`], in integers of any size, and once more for each prime that divides a leading coefficient.
///
/// # References
/// I. Obayashi, M. Yoshiwaki, *Field choice problem in persistent homology* (2023).
///
/// # Examples
/// A disk that runs twice along a loop fills it over Q and F_3, and not over F_2.
/// ```
/// use coface_algebra::SparseMatrix;
/// use coface_algebra::chains::ChainComplex;
/// use coface_topology::{Filtration, torsion_primes};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let plane = ChainComplex::new(vec![SparseMatrix::zero(1, 1)?, SparseMatrix::from_entries(1, 1, [(0, 0, 2)])?])?;
/// let filtration = Filtration::new(&plane, vec![vec![0.0], vec![1.0], vec![2.0]])?;
/// assert_eq!(torsion_primes(&plane, &filtration)?, [2]);
/// # Ok(()) }
/// ```
pub fn torsion_primes(complex: &ChainComplex, filtration: &Filtration) -> Result<Vec<u32>, Error> {
    filtration.check(complex)?;
    let mut leads = BTreeSet::new();
    let mut pairs = Vec::with_capacity(complex.degree_count());
    let mut entrance = filtration.entrance(0);
    let mut is_death = vec![false; entrance.len()];
    for degree in 0..complex.degree_count() {
        let next = filtration.entrance(degree + 1);
        let partner = match complex.boundary_matrix(degree + 1) {
            None => Vec::new(),
            Some(matrix) => {
                let merged = if degree == 0 { merged(matrix, &entrance, &next) } else { None };
                merged.unwrap_or_else(|| reduce(matrix, &entrance, &next, &is_death, &mut leads))
            }
        };
        let mut of_degree: Vec<(u32, u32)> = partner
            .iter()
            .enumerate()
            .filter(|&(_, &face)| face != NONE)
            .map(|(cell, &face)| (entrance[face as usize], next[cell]))
            .collect();
        of_degree.sort_unstable();
        pairs.push(of_degree);
        is_death = partner.iter().map(|&face| face != NONE).collect();
        entrance = next;
    }
    let mut primes = BTreeSet::new();
    for lead in &leads {
        primes.extend(prime_divisors(lead));
    }
    let mut found = Vec::new();
    for prime in primes {
        let diagram = persistence(complex, filtration, Coefficients::Modulo(u64::from(prime)))?;
        if (0..complex.degree_count()).any(|degree| pairs_of(&diagram, degree) != pairs[degree]) {
            found.push(prime);
        }
    }
    Ok(found)
}

/// The pairs of vertices and edges, if each edge joins two vertices or none: those of a graph, which has no torsion.
fn merged(matrix: &SparseMatrix, vertices: &[u32], edges: &[u32]) -> Option<Vec<u32>> {
    /// Large enough that 1 and -1 alone have the sum zero.
    const PRIME: u32 = (1 << 31) - 1;
    let is_graph = matrix.entries().iter().all(|x| x.abs() == 1);
    let field = Odd::new(PRIME);
    is_graph.then(|| Level { field: &field, matrix, cells: edges, faces: vertices }.merge()).flatten()
}

/// The cells that make and end the classes of a degree that die.
fn pairs_of(diagram: &PersistenceDiagram, degree: usize) -> Vec<(u32, u32)> {
    let pairs = diagram.pairs_of_degree(degree).iter();
    let mut pairs: Vec<(u32, u32)> = pairs
        .filter_map(|pair| Some((pair.birth_cell().index() as u32, pair.death_cell()?.index() as u32)))
        .collect();
    pairs.sort_unstable();
    pairs
}

/// A column of integers by its rows.
type Column = Vec<(u32, Integer)>;

/// The pairs over the rational numbers, for each cell the face that it kills or [`NONE`]; leading coefficients other than 1 and -1 are noted.
fn reduce(
    matrix: &SparseMatrix,
    faces: &[u32],
    cells: &[u32],
    is_death: &[bool],
    leads: &mut BTreeSet<Integer>,
) -> Vec<u32> {
    let mut numbers = vec![0; faces.len()];
    faces.iter().enumerate().for_each(|(number, &face)| numbers[face as usize] = number as u32);
    let mut columns: Vec<Vec<(u32, i32)>> = vec![Vec::new(); faces.len()];
    for (cell, &id) in cells.iter().enumerate() {
        for (face, x) in matrix.column(id as usize).iter() {
            columns[numbers[face] as usize].push((cell as u32, x));
        }
    }
    let raw =
        |face: usize| -> Column { columns[face].iter().map(|&(row, x)| (row, Integer::from(x))).collect() };
    let mut partner = vec![NONE; cells.len()];
    let mut reduced: BTreeMap<u32, Column> = BTreeMap::new();
    let mut note = |lead: &Integer| {
        if !lead.is_unit() {
            leads.insert(lead.abs());
        }
    };
    let steps = stage("looking for torsion", faces.len());
    for face in steps.each((0..faces.len()).rev()).filter(|&face| !is_death[face]) {
        let Some(&(first, x)) = columns[face].first() else { continue };
        if partner[first as usize] == NONE {
            partner[first as usize] = face as u32;
            note(&Integer::from(x));
            continue;
        }
        let mut sum: BTreeMap<u32, Integer> = raw(face).into_iter().collect();
        while let Some((row, lead)) = sum.pop_first() {
            steps.advance(0);
            let owner = partner[row as usize];
            if owner == NONE {
                note(&lead);
                let common = sum.values().fold(lead.clone(), |common, x| common.gcd(x));
                let mut column = vec![(row, lead)];
                column.extend(sum);
                if !common.is_unit() {
                    for (_, x) in &mut column {
                        *x = x.exact_quotient(&common).expect("the common divisor divides all");
                    }
                }
                partner[row as usize] = face as u32;
                reduced.insert(row, column);
                break;
            }
            let raw_column;
            let other = match reduced.get(&row) {
                Some(column) => column,
                None => {
                    raw_column = raw(owner as usize);
                    &raw_column
                }
            };
            eliminate(&mut sum, &lead, other);
        }
    }
    partner
}

/// Adds a multiple of another column, whose lead stands where the lead of the sum was; the sum is multiplied first as far as it has to.
fn eliminate(sum: &mut BTreeMap<u32, Integer>, lead: &Integer, other: &Column) {
    let common = lead.gcd(&other[0].1);
    let part = |x: &Integer| x.exact_quotient(&common).expect("the common divisor divides both");
    let (mut own, mut factor) = (part(&other[0].1), -&part(lead));
    if own.signum() < 0 {
        (own, factor) = (-&own, -&factor);
    }
    if !own.is_unit() {
        sum.values_mut().for_each(|x| *x = &*x * &own);
    }
    for (row, x) in &other[1..] {
        let entry = sum.entry(*row).or_insert(Integer::ZERO);
        *entry += &(x * &factor);
        if entry.is_zero() {
            sum.remove(row);
        }
    }
}

/// The primes below 2^31 that divide a number, found by division up to its root or 2^20; a rest without small divisors is left out.
fn prime_divisors(number: &Integer) -> Vec<u32> {
    let mut rest = number.abs();
    let mut found = Vec::new();
    for prime in (2u32..1 << 20).filter(|n| n % 2 == 1 || *n == 2) {
        if rest.is_unit() {
            break;
        }
        if rest.to_i64().is_some_and(|rest| rest < i64::from(prime) * i64::from(prime)) {
            break;
        }
        let divisor = Integer::from(i64::from(prime));
        let mut divides = false;
        while let Some(quotient) = rest.exact_quotient(&divisor) {
            (rest, divides) = (quotient, true);
        }
        if divides {
            found.push(prime);
        }
    }
    // What is left has no divisor below its root: a prime.
    found.extend(
        rest.to_i64().and_then(|rest| u32::try_from(rest).ok()).filter(|&rest| rest > 1 && rest < 1 << 31),
    );
    found
}
