//! Cycles, bounding chains and cocycles of the classes of a diagram.

use super::elimination::Elimination;
use super::reduction::{Columns, Level, NONE};
use super::shortening::Shortening;
use super::{Filtration, PersistenceDiagram, PersistencePair};
use coface_algebra::chains::{Chain, ChainComplex, Cochain};
use coface_algebra::progress::stage;
use coface_algebra::{Binary, CellId, Error, Field, Integer, Odd};

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
/// classes. Then boundaries of single cells that enter no later than the class are added to a cycle while that makes it shorter, in the number of cells
/// with multiplicity, and to its bounding chain: the class stays the same. Shortest cycles are not promised.
///
/// # Errors
/// Those of [`Filtration::check`]; [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if classes were taken from the diagram.
///
/// # Complexity
/// That of [`persistence`](super::persistence) and the size of what is given, at worst quadratic in the number of cells for each class.
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
pub(super) struct Entrance {
    pub(super) cells: Vec<u32>,
    pub(super) numbers: Vec<u32>,
}

impl Entrance {
    fn new(filtration: &Filtration, degree: usize) -> Self {
        let cells = filtration.entrance(degree);
        let mut numbers = vec![0; cells.len()];
        for (number, &cell) in cells.iter().enumerate() {
            numbers[cell as usize] = number as u32;
        }
        Self { cells, numbers }
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

fn over<F: Field>(
    field: &F,
    integer: impl Fn(F::Unit) -> i64,
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
    let mut essential: Vec<Terms<F::Unit>> =
        wanted.first().into_iter().flatten().map(|pair| over.single(&here, pair)).collect();
    for (degree, wanted_here) in wanted.iter().enumerate() {
        let next = Entrance::new(filtration, degree + 1);
        let level = Pairs { degree, complex, all: diagram.pairs_of_degree(degree), here: &here, next: &next };
        let wanted_next = wanted.get(degree + 1).map_or(&[][..], Vec::as_slice);
        let (dying, staying) = over.cycles(&level, wanted_here, wanted_next);
        let cocycles = over.cocycles(&level, wanted_here);
        let mut dying = dying.into_iter();
        let shortening = Shortening::new(field, &over.integer, &level);
        let steps = stage("shortening cycles", wanted_here.len());
        for ((pair, staying), cocycle) in steps.each(wanted_here.iter().zip(essential).zip(cocycles)) {
            let (mut cycle, mut bounding) = match pair.death_cell() {
                None => (staying, None),
                Some(_) => {
                    let (cycle, bounding) = dying.next().expect("a class that dies has a bounding chain");
                    (cycle, Some(bounding))
                }
            };
            if let Some(shortening) = &shortening {
                shortening.shorten(filtration, pair, &mut cycle, bounding.as_mut());
            }
            let chain = |degree, entrance: &Entrance, terms: &Terms<F::Unit>| {
                Chain::of_cells(degree, over.terms(entrance, terms))
            };
            found.push(PersistentCycle {
                pair: **pair,
                cycle: chain(degree, &here, &cycle)?,
                bounding_chain: bounding.map(|bounding| chain(degree + 1, &next, &bounding)).transpose()?,
                cocycle: Cochain::of_cells(degree, over.terms(&here, &cocycle))?,
            });
        }
        (here, essential) = (next, staying);
    }
    Ok(found)
}

/// The pairs of a degree, and the cells of it and of the next one.
pub(super) struct Pairs<'a> {
    pub(super) degree: usize,
    pub(super) complex: &'a ChainComplex,
    pub(super) all: &'a [PersistencePair],
    pub(super) here: &'a Entrance,
    pub(super) next: &'a Entrance,
}

impl<F: Field, N: Fn(F::Unit) -> i64> Over<'_, F, N> {
    fn terms(&self, entrance: &Entrance, terms: &Terms<F::Unit>) -> Vec<(CellId, Integer)> {
        let cell = |number: u32| CellId::new(entrance.cells[number as usize] as usize);
        terms.iter().map(|&(number, unit)| (cell(number), Integer::from((self.integer)(unit)))).collect()
    }

    /// The chain of the cell that makes a class.
    fn single(&self, here: &Entrance, pair: &PersistencePair) -> Terms<F::Unit> {
        vec![(here.number(pair.birth_cell()), self.one)]
    }

    /// The factor that makes a coefficient 1.
    fn to_one(&self, unit: F::Unit) -> F::Unit {
        // 1 + x u = 0, and 1 + y x = 0 with y = -1 gives the negative.
        let negative = self.field.eliminator(self.one, unit);
        let minus_one = self.field.eliminator(self.one, self.one);
        self.field.product(negative, minus_one)
    }

    /// Cycles and bounding chains of the classes that die, of those wanted here; and cycles of all classes wanted of the next degree, empty for those
    /// that die.
    #[expect(clippy::type_complexity, reason = "pairs of chains, and chains")]
    fn cycles(
        &self,
        level: &Pairs<'_>,
        wanted: &[&PersistencePair],
        wanted_next: &[&PersistencePair],
    ) -> (Vec<(Terms<F::Unit>, Terms<F::Unit>)>, Vec<Terms<F::Unit>>) {
        let (here, next) = (level.here, level.next);
        let is_needed = wanted.iter().any(|pair| !pair.is_essential())
            || wanted_next.iter().any(|pair| pair.is_essential());
        let Some(matrix) = level.complex.boundary_matrix(level.degree + 1).filter(|_| is_needed) else {
            return (Vec::new(), vec![Vec::new(); wanted_next.len()]);
        };
        let column = |number: usize| {
            let faces = matrix.column(next.cells[number] as usize);
            let mut column: Terms<F::Unit> = faces
                .iter()
                .filter_map(|(face, x)| Some((here.counted_back(here.numbers[face]), self.field.unit(x)?)))
                .collect();
            column.sort_unstable();
            column
        };
        let mut owners = vec![NONE; here.cells.len()];
        for pair in level.all {
            if let Some(death) = pair.death_cell() {
                owners[here.counted_back(here.number(pair.birth_cell())) as usize] = next.number(death);
            }
        }
        let columns = Columns::of((0..next.cells.len()).map(column));
        let mut elimination = Elimination::new(self.field, self.one, columns, owners);
        let steps = stage("finding cycles", wanted.len() + wanted_next.len());
        let dying = steps.each(wanted.iter()).filter_map(|pair| {
            let number = next.number(pair.death_cell()?);
            let reduced = elimination.reduced(number);
            let factor = self.to_one(reduced[0].1);
            let scaled = |&(number, x): &(u32, F::Unit)| (number, self.field.product(factor, x));
            let cycle =
                reduced.iter().map(scaled).map(|(number, x)| (here.counted_back(number), x)).collect();
            Some((cycle, elimination.combination(number).iter().map(scaled).collect()))
        });
        let dying = dying.collect();
        let staying = wanted_next.iter().map(|pair| match pair.death_cell() {
            Some(_) => Vec::new(),
            None => elimination.combination(next.number(pair.birth_cell())),
        });
        (dying, staying.collect())
    }

    /// Cocycles of the classes that are wanted.
    fn cocycles(&self, pairs: &Pairs<'_>, wanted: &[&PersistencePair]) -> Vec<Terms<F::Unit>> {
        let (here, next) = (pairs.here, pairs.next);
        let Some(matrix) = pairs.complex.boundary_matrix(pairs.degree + 1).filter(|_| !wanted.is_empty())
        else {
            return wanted.iter().map(|pair| self.single(here, pair)).collect();
        };
        // Columns are the coboundaries, numbered from the last cell to enter: what is added to one has lower numbers.
        let level = Level { field: self.field, matrix, cells: &next.cells, faces: &here.cells };
        let columns = level.coboundaries_by(&|number| here.counted_back(number));
        let mut owners = vec![NONE; next.cells.len()];
        for pair in pairs.all {
            if let Some(death) = pair.death_cell() {
                owners[next.number(death) as usize] = here.counted_back(here.number(pair.birth_cell()));
            }
        }
        let mut elimination = Elimination::new(self.field, self.one, columns, owners);
        let steps = stage("finding cocycles", wanted.len());
        let cocycle = |pair: &&PersistencePair| {
            let column = here.counted_back(here.number(pair.birth_cell()));
            let cochain = elimination.combination(column);
            cochain.into_iter().map(|(number, x)| (here.counted_back(number), x)).collect()
        };
        steps.each(wanted.iter()).map(cocycle).collect()
    }
}
