//! The primes on which a persistence diagram depends.

use super::reduction::{Columns, Level, NONE, numbers, persistence};
use super::trees::DualGraph;
use super::{Filtration, PersistenceDiagram};
use crate::homology::Coefficients;
use coface_algebra::chains::ChainComplex;
use coface_algebra::progress::stage;
use coface_algebra::{Binary, Error, Field, Integer, SparseMatrix};
use std::cell::{Cell, RefCell};
use std::collections::{BTreeMap, BTreeSet};

/// The primes p below 2^31 for which the diagram over the field of p elements pairs other cells than the one over the rational numbers.
///
/// They are the primes of torsion that comes or goes somewhere along the filtration. Where there are none, cycles over any field have the births and the
/// deaths of integral cycles.
///
/// Coboundaries are reduced over the integers; a prime that divides no leading coefficient changes nothing. Diagrams over the others are compared. The
/// matrix of a graph is totally unimodular, and so is the one of the last degree where each face has at most two cells, which can be oriented
/// coherently: there no field matters, and nothing is reduced.
///
/// # Errors
/// Those of [`Filtration::check`].
///
/// # Complexity
/// That of [`persistence`] while numbers have 32 bits and leading coefficients divide what they eliminate; else that in integers of any size. Once more
/// for each prime that divides a leading coefficient.
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
    let matrices = complex.boundary_matrices();
    // The matrices of the last degree and of the first do not depend on the field where they are totally unimodular.
    let last = matrices.last().and_then(coherent_graph);
    let count = matrices.len() - usize::from(last.is_some());
    let is_graph = matrices.first().is_some_and(is_graph);
    // The pairs of the other ones.
    let mut partners = Vec::new();
    let mut is_death = vec![false; complex.cell_count(0)];
    for (degree, matrix) in matrices.iter().enumerate().take(count).skip(usize::from(is_graph && count == 1))
    {
        let (faces, cells) = (filtration.entrance(degree), filtration.entrance(degree + 1));
        let graph = last.as_ref().filter(|_| degree + 1 == count);
        let merged = if degree == 0 && is_graph { merged(matrix, faces, cells) } else { None };
        let partner = merged
            .or_else(|| {
                by_boundaries(matrix, faces, cells, graph?, filtration.entrance(degree + 2), &mut leads)
            })
            .or_else(|| by_coboundaries(matrix, faces, cells, &is_death, &mut leads))
            .unwrap_or_else(|| reduce(matrix, faces, cells, &is_death, &mut leads));
        is_death = partner.iter().map(|&face| face != NONE).collect();
        if degree > 0 || !is_graph {
            partners.push((degree, partner));
        }
    }
    let mut primes = BTreeSet::new();
    for lead in &leads {
        primes.extend(prime_divisors(lead));
    }
    if primes.is_empty() {
        return Ok(Vec::new());
    }
    let pairs =
        partners.iter().map(|(degree, partner)| (degree, pairs_of_partner(partner, filtration, *degree)));
    let pairs: Vec<_> = pairs.collect();
    let mut found = Vec::new();
    for prime in primes {
        let diagram = persistence(complex, filtration, Coefficients::Modulo(u64::from(prime)))?;
        if pairs.iter().any(|(degree, pairs)| pairs_of(&diagram, **degree) != *pairs) {
            found.push(prime);
        }
    }
    Ok(found)
}

/// The graph of cells and faces, if each face has at most two cells, with coefficients 1 and -1, and the cells can be oriented so that the two have
/// opposite ones. Such a matrix is totally unimodular: whatever the order of the cells, all leading coefficients are 1 and -1.
fn coherent_graph(matrix: &SparseMatrix) -> Option<DualGraph> {
    DualGraph::of(matrix).filter(|graph| graph.orientations().is_some())
}

/// The cells that make and end the classes of a degree that die, by rising cells that make one.
fn pairs_of_partner(partner: &[u32], filtration: &Filtration, degree: usize) -> Vec<(u32, u32)> {
    let (faces, cells) = (filtration.entrance(degree), filtration.entrance(degree + 1));
    let dying = partner.iter().zip(cells).filter(|&(&face, _)| face != NONE);
    let mut pairs: Vec<(u32, u32)> = dying.map(|(&face, &cell)| (faces[face as usize], cell)).collect();
    pairs.sort_unstable();
    pairs
}

/// Whether each edge joins two vertices or none: a matrix that is totally unimodular, too.
fn is_graph(matrix: &SparseMatrix) -> bool {
    matrix.columns().all(|column| {
        let mut entries = column.iter().map(|(_, x)| x);
        match [entries.next(), entries.next(), entries.next()] {
            [None, ..] => true,
            [Some(x), Some(y), None] => x.abs() == 1 && x + y == 0,
            _ => false,
        }
    })
}

/// The pairs of the vertices and edges of a graph.
fn merged(matrix: &SparseMatrix, vertices: &[u32], edges: &[u32]) -> Option<Vec<u32>> {
    // Over one field as over the others.
    Level { field: &Binary, matrix, cells: edges, faces: vertices }.merge(|_, _| ())
}

/// The pairs over the rational numbers, if coboundaries can be reduced in integers of 32 bits without division; leading coefficients other than 1 and -1
/// are noted.
fn by_coboundaries(
    matrix: &SparseMatrix,
    faces: &[u32],
    cells: &[u32],
    is_death: &[bool],
    leads: &mut BTreeSet<Integer>,
) -> Option<Vec<u32>> {
    let integers = Small::default();
    let level = Level { field: &integers, matrix, cells, faces };
    let partner = level.reduce(is_death, |lead| integers.may_lead(lead))?;
    integers.note(leads)?;
    Some(partner)
}

/// The same by boundaries, where the cells are the faces of a graph of cells of the next degree. Those whose classes end there are left out, which leaves
/// shorter columns than coboundaries are.
fn by_boundaries(
    matrix: &SparseMatrix,
    faces: &[u32],
    cells: &[u32],
    graph: &DualGraph,
    next: &[u32],
    leads: &mut BTreeSet<Integer>,
) -> Option<Vec<u32>> {
    let integers = Small::default();
    // Both are counted from the last one to enter.
    let mut is_zero = vec![false; cells.len()];
    graph.join(cells.iter().rev().copied(), &numbers(next), |place, _, _| is_zero[place] = true);
    let numbers = numbers(faces);
    let mut columns = Columns::new();
    for &cell in cells.iter().rev() {
        let start = columns.entries.len();
        let column = matrix.column(cell as usize);
        columns.entries.extend(column.iter().map(|(face, x)| (faces.len() as u32 - 1 - numbers[face], x)));
        columns.entries[start..].sort_unstable();
        columns.end_column();
    }
    let owners = columns.partners(&integers, faces.len(), &is_zero, |lead| integers.may_lead(lead))?;
    integers.note(leads)?;
    let mut partner = vec![NONE; cells.len()];
    for (face, &cell) in owners.iter().enumerate().filter(|&(_, &cell)| cell != NONE) {
        partner[cells.len() - 1 - cell as usize] = (faces.len() - 1 - face) as u32;
    }
    Some(partner)
}

/// The integers of 32 bits, as far as they are enough: multiples of a column are added to others, and no column is multiplied.
#[derive(Default)]
pub(super) struct Small {
    /// Whether a number left the range, or was to be eliminated by one that does not divide it: results are not valid then.
    is_left: Cell<bool>,
    /// The leading coefficients other than 1 and -1.
    leads: RefCell<BTreeSet<i32>>,
}

impl Small {
    fn may_lead(&self, lead: i32) -> bool {
        if lead.unsigned_abs() != 1 {
            self.leads.borrow_mut().insert(lead);
        }
        !self.is_left.get()
    }

    /// Notes the leading coefficients; `None` if results are not valid.
    fn note(&self, leads: &mut BTreeSet<Integer>) -> Option<()> {
        if self.is_left.get() {
            return None;
        }
        leads.extend(self.leads.borrow().iter().map(|&lead| Integer::from(lead).abs()));
        Some(())
    }

    /// Whether a number left the range: results are not valid then.
    pub(super) fn is_left(&self) -> bool {
        self.is_left.get()
    }

    fn checked(&self, value: Option<i32>) -> i32 {
        value.unwrap_or_else(|| {
            self.is_left.set(true);
            1
        })
    }
}

impl Field for Small {
    type Unit = i32;

    fn unit(&self, value: i32) -> Option<i32> {
        (value != 0).then_some(value)
    }

    fn sum(&self, a: i32, b: i32) -> Option<i32> {
        Some(self.checked(a.checked_add(b))).filter(|&sum| sum != 0)
    }

    fn product(&self, a: i32, b: i32) -> i32 {
        self.checked(a.checked_mul(b))
    }

    fn eliminator(&self, a: i32, b: i32) -> i32 {
        let is_multiple = a.checked_rem(b) == Some(0);
        self.checked(if is_multiple { a.checked_div(b).and_then(i32::checked_neg) } else { None })
    }
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
    let numbers = numbers(faces);
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
