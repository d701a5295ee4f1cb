//! Persistent homology by reduction of coboundaries.

use super::sum::Sum;
use super::{Filtration, PersistenceDiagram, PersistencePair};
use crate::homology::Coefficients;
use coface_algebra::chains::ChainComplex;
use coface_algebra::progress::stage;
use coface_algebra::{Binary, Field, Odd, SparseMatrix, UnionFind, is_prime};
use coface_algebra::{Error, ErrorKind};

/// The persistent homology of a filtered complex over a prime field: every pair of birth and death, also those of
/// persistence zero (see [`PersistenceDiagram::longer_than`]).
///
/// Cells of equal value enter by rising degree, then by rising id. Incidences other than 1 and -1 are ordinary entries,
/// reduced modulo the prime.
///
/// Vertices are paired with edges by union-find. From degree 1 on coboundaries are reduced, from the last cell to the
/// first, with clearing: a cell that kills a class of the degree below brings none. A cell whose first coface is still
/// free is paired with it at once; only the others are worked on, as sums with a place for each cell.
///
/// # Errors
/// [`ErrorKind::Coefficient`] unless the coefficients are modulo a prime below 2^31; those of [`Filtration::check`]
/// if the filtration is not one of this complex.
///
/// # Complexity
/// Near-linear on meshes, where almost all cells are paired at once; cubic in the number of cells at worst.
///
/// # References
/// H. Edelsbrunner, D. Letscher, A. Zomorodian, *Topological persistence and simplification* (2002); V. de Silva, D.
/// Morozov, M. Vejdemo-Johansson, *Dualities in persistent (co)homology* (2011); C. Chen, M. Kerber, *Persistent
/// homology computation with a twist* (2011); U. Bauer, *Ripser: efficient computation of Vietoris-Rips persistence
/// barcodes* (2021).
///
/// # Examples
/// A path of heights 0, 2, 1: two valleys, of which the higher one dies at the pass between them.
/// ```
/// use coface_algebra::SparseMatrix;
/// use coface_algebra::chains::ChainComplex;
/// use coface_topology::{Coefficients, Filtration, persistence};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let edges = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1)])?;
/// let path = ChainComplex::new(vec![edges])?;
/// let filtration = Filtration::lower_star(&path, &[0.0, 2.0, 1.0])?;
/// let diagram = persistence(&path, &filtration, Coefficients::Modulo(2))?;
/// let valleys: Vec<_> = diagram.longer_than(0.0).pairs().iter().map(|pair| (pair.birth(), pair.death())).collect();
/// assert_eq!(valleys, [(0.0, None), (1.0, Some(2.0))]);
/// assert_eq!(diagram.betti_numbers(), [1, 0]);
/// # Ok(()) }
/// ```
pub fn persistence(
    complex: &ChainComplex,
    filtration: &Filtration,
    coefficients: Coefficients,
) -> Result<PersistenceDiagram, Error> {
    let prime = prime(coefficients)?;
    filtration.check(complex)?;
    Ok(match prime {
        2 => over(&Binary, complex, filtration, prime),
        _ => over(&Odd::new(prime), complex, filtration, prime),
    })
}

pub(super) fn prime(coefficients: Coefficients) -> Result<u32, Error> {
    let number = match coefficients {
        Coefficients::Modulo(n) => u32::try_from(n).ok().filter(|&n| n < 1 << 31 && is_prime(n.into())),
        Coefficients::Integers | Coefficients::Rationals => None,
    };
    number.ok_or_else(|| {
        Error::new(ErrorKind::Coefficient, format!("there is no persistence over {coefficients}"))
            .with_cure("take a prime field of fewer than 2^31 elements: f2, f3, f5, ...")
    })
}

/// No cell: of a place that is free.
pub(super) const NONE: u32 = u32::MAX;

fn over<F: Field>(
    field: &F,
    complex: &ChainComplex,
    filtration: &Filtration,
    prime: u32,
) -> PersistenceDiagram {
    let mut degrees = Vec::with_capacity(complex.degree_count());
    let mut entrance = filtration.entrance(0);
    // Whether the cell number i to enter, of the degree at hand, kills a class of the degree below.
    let mut is_death = vec![false; entrance.len()];
    for degree in 0..complex.degree_count() {
        let next = filtration.entrance(degree + 1);
        // For each cell of the degree above, in the order of entrance, the one it is paired with.
        let partner = match complex.boundary_matrix(degree + 1) {
            None => Vec::new(),
            Some(matrix) => {
                let level = Level { field, matrix, cells: next, faces: entrance };
                let merged = if degree == 0 { level.merge(|_, _| ()) } else { None };
                merged
                    .unwrap_or_else(|| level.reduce(&is_death, |_| true).expect("units of a field are leads"))
            }
        };
        let mut killer = vec![NONE; entrance.len()];
        for (cell, &face) in partner.iter().enumerate().filter(|&(_, &face)| face != NONE) {
            killer[face as usize] = cell as u32;
        }
        let births = (0..entrance.len()).filter(|&i| !is_death[i]);
        let pair = |i: usize| {
            let death = (killer[i] != NONE).then(|| next[killer[i] as usize]);
            PersistencePair::new(filtration, degree, entrance[i], death)
        };
        degrees.push(births.map(pair).collect());
        is_death = partner.iter().map(|&face| face != NONE).collect();
        entrance = next;
    }
    PersistenceDiagram::new(prime, filtration.is_falling(), degrees)
}

/// The boundaries from one degree to the one below. Cells and faces have their numbers in the order of entrance.
pub(super) struct Level<'a, F> {
    pub(super) field: &'a F,
    pub(super) matrix: &'a SparseMatrix,
    /// The id of each cell in the order of entrance.
    pub(super) cells: &'a [u32],
    /// The id of each face in the order of entrance.
    pub(super) faces: &'a [u32],
}

/// The number of each cell in an order.
pub(super) fn numbers(order: &[u32]) -> Vec<u32> {
    let mut numbers = vec![0; order.len()];
    (0..).zip(order).for_each(|(number, &cell)| numbers[cell as usize] = number);
    numbers
}

impl<F: Field> Level<'_, F> {
    /// The pairs of a graph, for each edge its vertex or [`NONE`]: an edge that joins two trees kills the younger one.
    /// `None` unless the boundary of each edge is zero or a multiple of a difference of two vertices. What is called has the oldest vertices of two trees
    /// that are joined, the older one first.
    pub(super) fn merge(&self, mut joined: impl FnMut(u32, u32)) -> Option<Vec<u32>> {
        let numbers = numbers(self.faces);
        let mut trees = UnionFind::new(self.faces.len());
        // The oldest vertex of the tree of each root.
        let mut oldest: Vec<u32> = (0..self.faces.len() as u32).collect();
        let mut partner = vec![NONE; self.cells.len()];
        let steps = stage("merging components", self.cells.len());
        for (edge, &id) in steps.each(self.cells.iter().enumerate()) {
            let mut ends = self
                .matrix
                .column(id as usize)
                .iter()
                .filter_map(|(row, entry)| Some((numbers[row], self.field.unit(entry)?)));
            let Some((a, x)) = ends.next() else { continue };
            let (b, y) = ends.next()?;
            if ends.next().is_some() || self.field.sum(x, y).is_some() {
                return None;
            }
            let (a, b) = (oldest[trees.find(a) as usize], oldest[trees.find(b) as usize]);
            if trees.unite(a, b) {
                oldest[trees.find(a) as usize] = a.min(b);
                partner[edge] = a.max(b);
                joined(a.min(b), a.max(b));
            }
        }
        Some(partner)
    }

    /// For each face its cofaces, rising.
    pub(super) fn coboundaries(&self) -> Columns<F::Unit> {
        let numbers = numbers(self.faces);
        let mut starts = vec![0; self.faces.len() + 1];
        for (row, _) in self
            .matrix
            .columns()
            .flat_map(|column| column.iter())
            .filter(|&(_, x)| self.field.unit(x).is_some())
        {
            starts[numbers[row] as usize + 1] += 1;
        }
        for i in 1..starts.len() {
            starts[i] += starts[i - 1];
        }
        let mut next = starts.clone();
        let mut entries = Vec::new();
        let Some(any) = self.matrix.entries().iter().find_map(|&entry| self.field.unit(entry)) else {
            return Columns { starts, entries };
        };
        entries.resize(starts[self.faces.len()], (NONE, any));
        let steps = stage("transposing boundaries", self.cells.len());
        for (cell, &id) in steps.each(self.cells.iter().enumerate()) {
            for (row, entry) in self.matrix.column(id as usize).iter() {
                if let Some(unit) = self.field.unit(entry) {
                    let at = &mut next[numbers[row] as usize];
                    entries[*at] = (cell as u32, unit);
                    *at += 1;
                }
            }
        }
        Columns { starts, entries }
    }

    /// The pairs, for each cell the face that it kills or [`NONE`], by reduction of the coboundaries of all faces but
    /// those that kill. `None` at the first leading coefficient with which it may not go on.
    pub(super) fn reduce(&self, is_death: &[bool], may_lead: impl Fn(F::Unit) -> bool) -> Option<Vec<u32>> {
        self.coboundaries().partners(self.field, self.cells.len(), is_death, may_lead)
    }
}

/// Sparse columns in flat arrays, the rows of each rising.
pub(super) struct Columns<U> {
    pub(super) starts: Vec<usize>,
    pub(super) entries: Vec<(u32, U)>,
}

impl<U: Copy> Columns<U> {
    pub(super) fn new() -> Self {
        Self { starts: vec![0], entries: Vec::new() }
    }

    /// The entries that were added since the last column are one.
    pub(super) fn end_column(&mut self) {
        self.starts.push(self.entries.len());
    }

    pub(super) fn column(&self, j: usize) -> &[(u32, U)] {
        &self.entries[self.starts[j]..self.starts[j + 1]]
    }

    /// For each row the column that it leads, or [`NONE`], when columns are reduced from the last one to the first; those that are known to become zero are
    /// left out. `None` at the first leading coefficient with which it may not go on.
    pub(super) fn partners<F: Field<Unit = U>>(
        &self,
        field: &F,
        row_count: usize,
        is_zero: &[bool],
        may_lead: impl Fn(U) -> bool,
    ) -> Option<Vec<u32>> {
        let count = self.starts.len() - 1;
        let mut partner = vec![NONE; row_count];
        // Where the reduced column is that begins with a row; NONE for the column as it was.
        let mut place = vec![NONE; row_count];
        let mut reduced = Columns::new();
        let mut sum = Sum::new(row_count);
        let steps = stage("pairing cells", count);
        for j in steps.each((0..count).rev()).filter(|&j| !is_zero[j]) {
            let column = self.column(j);
            let Some(&(first, lead)) = column.first() else { continue };
            if partner[first as usize] == NONE {
                if !may_lead(lead) {
                    return None;
                }
                partner[first as usize] = j as u32;
                continue;
            }
            column.iter().for_each(|&(row, x)| sum.add(field, row, x));
            while let Some((first, coefficient)) = sum.pop() {
                // A single column may take long.
                steps.advance(0);
                let other = match (partner[first as usize], place[first as usize]) {
                    (NONE, _) => {
                        if !may_lead(coefficient) {
                            return None;
                        }
                        partner[first as usize] = j as u32;
                        place[first as usize] = reduced.starts.len() as u32 - 1;
                        reduced.entries.push((first, coefficient));
                        while let Some(term) = sum.pop() {
                            reduced.entries.push(term);
                        }
                        reduced.end_column();
                        break;
                    }
                    (owner, NONE) => self.column(owner as usize),
                    (_, place) => reduced.column(place as usize),
                };
                let factor = field.eliminator(coefficient, other[0].1);
                for &(row, x) in &other[1..] {
                    sum.add(field, row, field.product(factor, x));
                }
            }
        }
        Some(partner)
    }
}
