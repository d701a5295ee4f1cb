//! Cycles, bounding chains and cocycles of the classes of a diagram.

use super::elimination::Elimination;
use super::reduction::{Columns, Level, NONE, numbers};
use super::shortening::Shortening;
use super::sum::Sum;
use super::trees::{DualGraph, Trees};
use super::{Filtration, PersistenceDiagram, PersistencePair};
use coface_algebra::chains::{Chain, ChainComplex, Cochain};
use coface_algebra::progress::{Steps, stage};
use coface_algebra::{Binary, CellId, Error, Field, Integer, Odd, Sign, SparseMatrix};
use rayon::prelude::*;
use std::cmp::Reverse;

/// A class of a diagram with what proves it: a cycle that is there from the birth on, the chain that it bounds from the death on, and a cocycle.
///
/// Over the field of p elements coefficients are the whole numbers of least absolute value.
///
/// # Examples
/// See [`persistent_cycles`].
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct PersistentCycle {
    pair: PersistencePair,
    cycle: Chain<Integer>,
    bounding_chain: Option<Chain<Integer>>,
    cocycle: Cochain<Integer>,
}

impl PersistentCycle {
    /// The birth and the death of the class.
    ///
    /// # Examples
    /// See [`persistent_cycles`].
    pub fn pair(&self) -> &PersistencePair {
        &self.pair
    }

    /// A cycle of the class. The cell that makes the class is the last one of its cells to enter, and has the coefficient 1.
    ///
    /// # Examples
    /// See [`persistent_cycles`].
    pub fn cycle(&self) -> &Chain<Integer> {
        &self.cycle
    }

    /// The chain whose boundary the cycle is; the cell that ends the class is the last one of its cells to enter. `None` for a class that never dies.
    ///
    /// # Examples
    /// See [`persistent_cycles`].
    pub fn bounding_chain(&self) -> Option<&Chain<Integer>> {
        self.bounding_chain.as_ref()
    }

    /// A cocycle of the cells that enter before the cell that ends the class, of all cells if none does. Its value on the cycle is 1, and it is 0 on
    /// cells that enter before the one that makes the class.
    ///
    /// # Examples
    /// See [`persistent_cycles`].
    pub fn cocycle(&self) -> &Cochain<Integer> {
        &self.cocycle
    }
}

/// Cycles of the classes of a diagram whose persistence is greater than `length`, in the order of the diagram. The diagram is the whole one of this
/// complex and this filtration, or that [up to a degree](PersistenceDiagram::up_to_degree).
///
/// Only what these cycles need is reduced: boundaries of cells that end classes, by those that end earlier ones, and coboundaries of cells that make
/// classes. In a graph, and where each face has at most two cells with opposite coefficients, as in a surface with an orientation, union-find
/// does that. Then boundaries of single cells that enter no later than the class are added to a cycle while that makes it shorter, in the number of cells
/// with multiplicity, and to its bounding chain: the class stays the same. Shortest cycles are not promised.
///
/// # Errors
/// Those of [`Filtration::check`]; [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if classes were taken from the diagram.
///
/// # Complexity
/// That of [`persistence`](super::persistence) and the size of what is given, at worst quadratic in the number of cells for each class. Boundaries and
/// coboundaries are reduced side by side, and many cycles are made shorter at a time.
///
/// # References
/// M. Čufar, Ž. Virk, *Fast computation of persistent homology representatives with involuted persistent homology* (2023): only boundaries of cells
/// that are known to end classes are reduced.
///
/// # Examples
/// The rim of a triangle, which is filled later: a loop from 1 to 5.
/// ```
/// use coface_algebra::SparseMatrix;
/// use coface_algebra::chains::ChainComplex;
/// use coface_topology::{Coefficients, Filtration, persistence, persistent_cycles};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let edges = [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1), (0, 2, -1), (2, 2, 1)];
/// let triangle = ChainComplex::new(vec![
///     SparseMatrix::from_entries(3, 3, edges)?,
///     SparseMatrix::from_entries(3, 1, [(0, 0, 1), (1, 0, 1), (2, 0, -1)])?,
/// ])?;
/// let filtration = Filtration::new(&triangle, vec![vec![0.0; 3], vec![1.0; 3], vec![5.0]])?;
/// let diagram = persistence(&triangle, &filtration, Coefficients::Modulo(3))?;
/// let found = persistent_cycles(&triangle, &filtration, &diagram, 2.0)?;
/// let rim = &found[1];
/// assert_eq!((rim.pair().birth(), rim.pair().death()), (1.0, Some(5.0)));
/// assert_eq!(rim.cycle().terms().len(), 3);
/// assert_eq!(triangle.boundary(rim.bounding_chain().expect("it dies"))?.terms().len(), 3);
/// assert_eq!(rim.cocycle().pairing(rim.cycle())?, Some(1.into()));
/// # Ok(()) }
/// ```
pub fn persistent_cycles(
    complex: &ChainComplex,
    filtration: &Filtration,
    diagram: &PersistenceDiagram,
    length: f64,
) -> Result<Vec<PersistentCycle>, Error> {
    filtration.check(complex)?;
    require_whole(complex, diagram)?;
    match diagram.prime() {
        2 => over(&Binary, |()| 1, complex, filtration, diagram, length),
        prime => {
            let least = |unit: u32| {
                let unit = i64::from(unit);
                if 2 * unit > i64::from(prime) { unit - i64::from(prime) } else { unit }
            };
            over(&Odd::new(prime), least, complex, filtration, diagram, length)
        }
    }
}

/// Each cell of the degrees of the diagram makes a class or ends one.
fn require_whole(complex: &ChainComplex, diagram: &PersistenceDiagram) -> Result<(), Error> {
    if diagram.degree_count() > complex.degree_count() {
        return Err(not_whole());
    }
    let mut counts = vec![0; complex.degree_count() + 1];
    for pair in diagram.pairs() {
        counts[pair.degree()] += 1;
        counts[pair.degree() + 1] += usize::from(!pair.is_essential());
    }
    let is_whole = (diagram.degree_count() > 0 || complex.degree_count() == 0)
        && (0..diagram.degree_count()).all(|degree| counts[degree] == complex.cell_count(degree));
    if is_whole {
        return Ok(());
    }
    Err(not_whole())
}

fn not_whole() -> Error {
    Error::invalid("the diagram is not the whole one of the complex")
        .with_cure("give the diagram as persistence makes it, and the length of the classes that are wanted")
}

/// The cells of a degree in the order of entrance.
pub(super) struct Entrance<'a> {
    pub(super) cells: &'a [u32],
    pub(super) numbers: Vec<u32>,
}

impl<'a> Entrance<'a> {
    fn new(filtration: &'a Filtration, degree: usize) -> Self {
        let cells = filtration.entrance(degree);
        Self { cells, numbers: numbers(cells) }
    }

    pub(super) fn number(&self, cell: CellId) -> u32 {
        self.numbers[cell.index()]
    }

    /// The number counted from the last cell to enter; twice it is the number itself.
    fn counted_back(&self, number: u32) -> u32 {
        self.cells.len() as u32 - 1 - number
    }
}

/// What is computed, as terms by numbers of entrance.
pub(super) type Terms<U> = Vec<(u32, U)>;

/// A field with what names its elements.
struct Over<'a, F: Field, N> {
    field: &'a F,
    integer: N,
    one: F::Unit,
}

fn over<F: Field<Unit: Send + Sync> + Sync>(
    field: &F,
    integer: impl Fn(F::Unit) -> i64 + Sync,
    complex: &ChainComplex,
    filtration: &Filtration,
    diagram: &PersistenceDiagram,
    length: f64,
) -> Result<Vec<PersistentCycle>, Error> {
    let one = field.unit(1).expect("1 is not 0 in a field");
    let over = Over { field, integer, one };
    let wanted: Vec<Vec<&PersistencePair>> = (0..diagram.degree_count())
        .map(|degree| {
            diagram.pairs_of_degree(degree).iter().filter(|pair| pair.persistence() > length).collect()
        })
        .collect();
    let mut found = Vec::new();
    let mut here = Entrance::new(filtration, 0);
    // The cycles of classes that never die, of the degree at hand.
    let mut essential = over.singles(&here, wanted.first().map_or(&[][..], Vec::as_slice));
    for (degree, wanted_here) in wanted.iter().enumerate() {
        let next = Entrance::new(filtration, degree + 1);
        let level = Pairs { degree, complex, all: diagram.pairs_of_degree(degree), here: &here, next: &next };
        let wanted_next = wanted.get(degree + 1).map_or(&[][..], Vec::as_slice);
        let steps = stage("finding cycles and cocycles", 2 * wanted_here.len() + wanted_next.len());
        let (cycles, (cofaces, cocycles)) = rayon::join(
            || over.cycles(&level, wanted_here, wanted_next, &steps),
            || over.cocycles(&level, wanted_here, &steps),
        );
        drop(steps);
        let steps = stage("shortening cycles", wanted_here.len());
        // Few work spaces, which are as large as the complex.
        let least = wanted_here.len().div_ceil(8 * rayon::current_num_threads());
        let shortening = || Shortening::new(field, &over.integer, filtration, &level, cofaces.as_ref());
        let of_degree = wanted_here.par_iter().enumerate().with_min_len(least).map_init(
            shortening,
            |shortening, (class, pair)| {
                steps.advance(1);
                let (cycle, bounding) = match pair.death_cell() {
                    Some(_) => (cycles.dying.column(class), Some(cycles.bounding.column(class))),
                    None => (essential.column(class), None),
                };
                let shorter = shortening.as_mut().and_then(|one| one.shorter(pair, cycle, bounding));
                let (cycle, bounding) = match &shorter {
                    Some((cycle, chain)) => (&cycle[..], bounding.map(|_| &chain[..])),
                    None => (cycle, bounding),
                };
                let bounding = bounding
                    .map(|chain| Chain::of_cells(degree + 1, over.terms(&next, chain)))
                    .transpose()?;
                Ok(PersistentCycle {
                    pair: **pair,
                    cycle: Chain::of_cells(degree, over.terms(&here, cycle))?,
                    bounding_chain: bounding,
                    cocycle: Cochain::of_cells(degree, over.terms(&here, cocycles.column(class)))?,
                })
            },
        );
        found.extend(of_degree.collect::<Result<Vec<_>, Error>>()?);
        (here, essential) = (next, cycles.staying);
    }
    Ok(found)
}

/// The pairs of a degree, and the cells of it and of the next one.
pub(super) struct Pairs<'a> {
    pub(super) degree: usize,
    pub(super) complex: &'a ChainComplex,
    pub(super) all: &'a [PersistencePair],
    pub(super) here: &'a Entrance<'a>,
    pub(super) next: &'a Entrance<'a>,
}

/// What reduced boundaries say of the classes of a degree, a column a class, cells from the last one to enter to the first.
struct Cycles<U> {
    /// Cycles of the classes that die, and the chains that they bound; empty for others.
    dying: Columns<U>,
    bounding: Columns<U>,
    /// Cycles of the classes of the next degree that never die; empty for others.
    staying: Columns<U>,
}

impl<F: Field, N: Fn(F::Unit) -> i64> Over<'_, F, N> {
    fn terms(&self, entrance: &Entrance<'_>, terms: &[(u32, F::Unit)]) -> Vec<(CellId, Integer)> {
        let cell = |&(number, unit): &(u32, F::Unit)| (entrance.cells[number as usize], unit);
        let mut terms: Terms<F::Unit> = terms.iter().map(cell).collect();
        terms.sort_unstable();
        let integral = |(cell, unit)| (CellId::new(cell as usize), Integer::from((self.integer)(unit)));
        terms.into_iter().map(integral).collect()
    }

    /// The chains of the cells that make classes.
    fn singles(&self, here: &Entrance<'_>, pairs: &[&PersistencePair]) -> Columns<F::Unit> {
        let mut singles = Columns::new();
        for pair in pairs {
            singles.entries.push((here.number(pair.birth_cell()), self.one));
            singles.end_column();
        }
        singles
    }

    /// The factor that makes a coefficient 1.
    fn to_one(&self, unit: F::Unit) -> F::Unit {
        // 1 + x u = 0, and 1 + y x = 0 with y = -1 gives the negative.
        let negative = self.field.eliminator(self.one, unit);
        let minus_one = self.field.eliminator(self.one, self.one);
        self.field.product(negative, minus_one)
    }

    /// Cycles of the classes wanted here that die, and of those wanted of the next degree that do not.
    fn cycles(
        &self,
        level: &Pairs<'_>,
        wanted: &[&PersistencePair],
        wanted_next: &[&PersistencePair],
        steps: &Steps,
    ) -> Cycles<F::Unit> {
        let (here, next) = (level.here, level.next);
        let [mut dying, mut bounding, mut staying] = [(); 3].map(|()| Columns::new());
        let is_needed = wanted.iter().any(|pair| !pair.is_essential())
            || wanted_next.iter().any(|pair| pair.is_essential());
        let Some(matrix) = level.complex.boundary_matrix(level.degree + 1).filter(|_| is_needed) else {
            wanted.iter().for_each(|_| dying.end_column());
            wanted.iter().for_each(|_| bounding.end_column());
            wanted_next.iter().for_each(|_| staying.end_column());
            return Cycles { dying, bounding, staying };
        };
        if let Some(cycles) = self.cycles_of_manifold(level, matrix, wanted, wanted_next, steps) {
            return cycles;
        }
        let boundary =
            |number: u32, terms: &mut Terms<F::Unit>| {
                let faces = matrix.column(next.cells[number as usize] as usize);
                terms.extend(faces.iter().filter_map(|(face, x)| {
                    Some((here.counted_back(here.numbers[face]), self.field.unit(x)?))
                }));
                terms.sort_unstable();
            };
        let mut owners = vec![NONE; here.cells.len()];
        for pair in level.all {
            if let Some(death) = pair.death_cell() {
                owners[here.counted_back(here.number(pair.birth_cell())) as usize] = next.number(death);
            }
        }
        let mut elimination = Elimination::new(self.field, next.cells.len(), boundary, owners);
        // Those that others need come first, so that few columns wait.
        let deaths = wanted.iter().filter_map(|pair| pair.death_cell());
        let mut deaths: Vec<u32> = deaths.map(|death| next.number(death)).collect();
        deaths.sort_unstable();
        for death in deaths {
            steps.advance(0);
            elimination.reduce(death);
        }
        for pair in steps.each(wanted.iter()) {
            if let Some(death) = pair.death_cell() {
                let reduced = elimination.reduced(next.number(death));
                let factor = self.to_one(reduced[0].1);
                dying.entries.extend(
                    reduced.iter().map(|&(row, x)| (here.counted_back(row), self.field.product(factor, x))),
                );
                elimination.combination(next.number(death), factor, &mut bounding.entries);
            }
            dying.end_column();
            bounding.end_column();
        }
        for pair in steps.each(wanted_next.iter()) {
            if pair.is_essential() {
                elimination.combination(next.number(pair.birth_cell()), self.one, &mut staying.entries);
            }
            staying.end_column();
        }
        Cycles { dying, bounding, staying }
    }

    /// The same where each face has at most two cells, with opposite coefficients. The reduced boundary of a cell is that of the cells which are connected
    /// to it by faces that enter after its partner. `None` for other matrices.
    fn cycles_of_manifold(
        &self,
        level: &Pairs<'_>,
        matrix: &SparseMatrix,
        wanted: &[&PersistencePair],
        wanted_next: &[&PersistencePair],
        steps: &Steps,
    ) -> Option<Cycles<F::Unit>> {
        let (here, next) = (level.here, level.next);
        let graph = DualGraph::of(matrix)?;
        // Over two elements all signs are equal.
        let orientations = match self.field.unit(2) {
            Some(_) => graph.orientations()?,
            None => vec![Sign::Plus; next.cells.len()],
        };
        let mut trees = Trees::new(next.cells.len() + 1);
        graph.join(here.cells.iter().rev().copied(), &next.numbers, |_, older, younger| {
            trees.join(older, younger);
        });
        let sign = |number: u32| orientations[next.cells[number as usize] as usize];
        let units = [1, -1].map(|x| self.field.unit(x).expect("1 and -1 are not 0 in a field"));
        let relative = |a: u32, b: u32| units[usize::from(sign(a) != sign(b))];
        let [mut dying, mut bounding, mut staying] = [(); 3].map(|()| Columns::new());
        let mut sum = Sum::new(here.cells.len());
        for pair in steps.each(wanted.iter()) {
            if let Some(death) = pair.death_cell() {
                let death = next.number(death);
                for cell in trees.vertices(death) {
                    for (face, x) in matrix.column(next.cells[cell as usize] as usize).iter() {
                        let Some(x) = self.field.unit(x) else { continue };
                        let row = here.counted_back(here.numbers[face]);
                        sum.add(self.field, row, self.field.product(relative(cell, death), x));
                    }
                }
                let first = sum.pop().expect("the boundary has the cell that makes the class");
                let factor = self.to_one(first.1);
                let terms = std::iter::once(first).chain(std::iter::from_fn(|| sum.pop()));
                dying
                    .entries
                    .extend(terms.map(|(row, x)| (here.counted_back(row), self.field.product(factor, x))));
                let chain = trees
                    .vertices(death)
                    .map(|cell| (cell, self.field.product(factor, relative(cell, death))));
                bounding.entries.extend(chain);
            }
            dying.end_column();
            bounding.end_column();
        }
        for pair in steps.each(wanted_next.iter()) {
            if pair.is_essential() {
                let birth = next.number(pair.birth_cell());
                let cycle = staying.entries.len();
                staying.entries.extend(trees.vertices(birth).map(|cell| (cell, relative(cell, birth))));
                staying.entries[cycle..].sort_unstable_by_key(|&(cell, _)| Reverse(cell));
            }
            staying.end_column();
        }
        Some(Cycles { dying, bounding, staying })
    }

    /// The cofaces of all cells, if they are needed, and cocycles of the classes that are wanted.
    fn cocycles(
        &self,
        pairs: &Pairs<'_>,
        wanted: &[&PersistencePair],
        steps: &Steps,
    ) -> (Option<Columns<F::Unit>>, Columns<F::Unit>) {
        let (here, next) = (pairs.here, pairs.next);
        let Some(matrix) = pairs.complex.boundary_matrix(pairs.degree + 1).filter(|_| !wanted.is_empty())
        else {
            return (None, self.singles(here, wanted));
        };
        let mut cocycles = Columns::new();
        let level = Level { field: self.field, matrix, cells: next.cells, faces: here.cells };
        // The cochain that is 1 on the vertices of a tree is closed until the tree is joined to an older one.
        let mut trees = Trees::new(here.cells.len());
        if pairs.degree == 0 && level.merge(|older, younger| trees.join(older, younger)).is_some() {
            for pair in steps.each(wanted.iter()) {
                let vertices = trees.vertices(here.number(pair.birth_cell()));
                cocycles.entries.extend(vertices.map(|vertex| (vertex, self.one)));
                cocycles.end_column();
            }
            return (None, cocycles);
        }
        let cofaces = level.coboundaries();
        // Columns are the coboundaries, numbered from the last cell to enter: what is added to one has lower numbers.
        let coboundary = |number: u32, terms: &mut Terms<F::Unit>| {
            terms.extend_from_slice(cofaces.column(here.counted_back(number) as usize));
        };
        let mut owners = vec![NONE; next.cells.len()];
        for pair in pairs.all {
            if let Some(death) = pair.death_cell() {
                owners[next.number(death) as usize] = here.counted_back(here.number(pair.birth_cell()));
            }
        }
        let mut elimination = Elimination::new(self.field, here.cells.len(), coboundary, owners);
        // Those that others need come first, so that few columns wait.
        for pair in wanted.iter().rev() {
            steps.advance(0);
            elimination.reduce(here.counted_back(here.number(pair.birth_cell())));
        }
        for pair in steps.each(wanted.iter()) {
            let birth = here.counted_back(here.number(pair.birth_cell()));
            elimination.combination(birth, self.one, &mut cocycles.entries);
            cocycles.end_column();
        }
        for (number, _) in &mut cocycles.entries {
            *number = here.counted_back(*number);
        }
        (Some(cofaces), cocycles)
    }
}
