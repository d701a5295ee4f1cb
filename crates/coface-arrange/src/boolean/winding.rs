//! Winding numbers of inputs around cells.

use super::InputRim;
use coface_algebra::chains::ChainComplex;
use coface_algebra::progress::stage;
use coface_algebra::{CellId, Error, ErrorKind};
use coface_algebra::{Column, SparseMatrix};

/// Where a facet has the exterior, or one cell on both sides.
const EXTERIOR: u32 = u32::MAX;

/// Which winding numbers mean inside.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum InsideRule {
    /// All but zero.
    #[default]
    Nonzero,
    /// Those above zero: what an input that is turned inside out encloses is outside.
    Positive,
    /// The odd ones: what is enclosed twice is outside.
    Odd,
}

/// What is counted.
#[derive(Clone, Copy, PartialEq)]
enum Count {
    Whole,
    Parity,
}

impl Count {
    fn of(self, number: i64) -> i64 {
        match self {
            Self::Whole => number,
            Self::Parity => number.rem_euclid(2),
        }
    }
}

impl InsideRule {
    /// Whether this winding number means inside.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::boolean::InsideRule;
    /// assert!(InsideRule::Nonzero.is_inside(-2));
    /// assert!(!InsideRule::Positive.is_inside(-2) && !InsideRule::Odd.is_inside(-2));
    /// ```
    pub fn is_inside(self, number: i32) -> bool {
        match self {
            Self::Nonzero => number != 0,
            Self::Positive => number > 0,
            Self::Odd => number % 2 != 0,
        }
    }
}

/// How often each of several inputs winds around each cell of an arrangement.
///
/// # Examples
/// Two triangles on a common edge; the first input is the rim of the first, the second input the rim of both:
/// ```
/// use coface_algebra::SparseMatrix;
/// use coface_arrange::boolean::WindingNumbers;
/// use coface_algebra::chains::ChainComplex;
/// use coface_algebra::CellId;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let ends = [[0, 1], [1, 2], [2, 0], [1, 3], [3, 2]];
/// let edges = ends.iter().enumerate().flat_map(|(e, &[a, b])| [(a, e, -1), (b, e, 1)]);
/// let edges = SparseMatrix::from_entries(4, 5, edges)?;
/// let faces = [(0, 0, 1), (1, 0, 1), (2, 0, 1), (1, 1, -1), (3, 1, 1), (4, 1, 1)];
/// let faces = SparseMatrix::from_entries(5, 2, faces)?;
/// let rims = [(0, 0, 1), (1, 0, 1), (2, 0, 1), (0, 1, 1), (2, 1, 1), (3, 1, 1), (4, 1, 1)];
/// let inputs = SparseMatrix::from_entries(5, 2, rims)?;
/// let complex = ChainComplex::new(vec![edges, faces])?;
/// let winding = WindingNumbers::new(&complex, &inputs)?;
/// assert_eq!(winding.of_cell(CellId::new(0)), [1, 1]);
/// assert_eq!(winding.of_cell(CellId::new(1)), [0, 1]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WindingNumbers {
    input_count: usize,
    /// The first of the numbers of each cell, and the count of all.
    starts: Vec<usize>,
    /// The numbers that are not zero, each with its input, rising; those of one cell after those of another.
    numbers: Vec<(u32, i32)>,
}

impl WindingNumbers {
    /// The winding numbers around the cells of highest degree of an arrangement, the exterior not among them. Column i
    /// of `inputs` is input i as a chain of facets.
    ///
    /// From a facet's front to its back the winding number of an input rises by the multiplicity of the facet; the
    /// numbers are carried from the exterior, where they are zero, across the facets.
    ///
    /// # Errors
    /// [`ErrorKind::NotACycle`] naming the first input with a boundary, and a part of that boundary;
    /// [`ErrorKind::Shape`] when there is not a row for each facet, when a facet is more than once in front of cells or
    /// behind them, or when cells cannot be reached from the exterior; [`ErrorKind::TooLarge`] for numbers beyond 32
    /// bits.
    ///
    /// # Complexity
    /// Linear in the matrices, in the cells, and in the pairs of a facet or cell and an input that winds around it.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, SparseMatrix};
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_arrange::boolean::WindingNumbers;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A line of two edges; the first input is the first edge, the second input the whole line.
    /// let edges = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1)])?;
    /// let inputs = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (0, 1, -1), (2, 1, 1)])?;
    /// let winding = WindingNumbers::new(&ChainComplex::new(vec![edges])?, &inputs)?;
    /// assert_eq!(winding.of_cell(CellId::new(0)), [1, 1]);
    /// # Ok(()) }
    /// ```
    pub fn new(complex: &ChainComplex, inputs: &SparseMatrix) -> Result<Self, Error> {
        Self::counted(complex, inputs, Count::Whole)
    }

    /// The same for inputs that are known to have no rims.
    #[doc(hidden)]
    pub fn of_cycles(complex: &ChainComplex, inputs: &SparseMatrix) -> Result<Self, Error> {
        Self::carried(complex, inputs, Count::Whole)
    }

    /// The winding numbers modulo 2, as 0 and 1. They need no directions: inputs whose facets do not run coherently
    /// have them, as long as an even number of facets meets in each ridge.
    ///
    /// # Errors
    /// As [`Self::new`]; [`ErrorKind::NotACycle`] only for ridges with odd coefficients.
    ///
    /// # Examples
    /// A triangle with one of its edges turned:
    /// ```
    /// use coface_algebra::CellId;
    /// use coface_algebra::SparseMatrix;
    /// use coface_arrange::boolean::WindingNumbers;
    /// use coface_algebra::chains::ChainComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edges = [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1), (0, 2, -1), (2, 2, 1)];
    /// let face = [(0, 0, 1), (1, 0, 1), (2, 0, -1)];
    /// let triangle = vec![SparseMatrix::from_entries(3, 3, edges)?, SparseMatrix::from_entries(3, 1, face)?];
    /// let complex = ChainComplex::new(triangle)?;
    /// let turned = SparseMatrix::from_entries(3, 1, [(0, 0, 1), (1, 0, 1), (2, 0, 1)])?;
    /// assert!(WindingNumbers::new(&complex, &turned).is_err());
    /// assert_eq!(WindingNumbers::parities(&complex, &turned)?.of_cell(CellId::new(0)), [1]);
    /// # Ok(()) }
    /// ```
    pub fn parities(complex: &ChainComplex, inputs: &SparseMatrix) -> Result<Self, Error> {
        Self::counted(complex, inputs, Count::Parity)
    }

    fn counted(complex: &ChainComplex, inputs: &SparseMatrix, count: Count) -> Result<Self, Error> {
        if complex.degree_count() < 2 {
            return Err(Error::new(ErrorKind::Shape, "a complex of points has no facets"));
        }
        let rims = InputRim::of_inputs(complex, inputs)?;
        if let Some(rim) = rims.iter().find(|rim| count == Count::Whole || !rim.is_even()) {
            return Err(rim.error(complex));
        }
        Self::carried(complex, inputs, count)
    }

    /// Carries the numbers of inputs that are closed from the exterior across the facets.
    fn carried(complex: &ChainComplex, inputs: &SparseMatrix, count: Count) -> Result<Self, Error> {
        let degree = complex.degree_count().saturating_sub(1);
        let Some(boundaries) = complex.boundary_matrix(degree) else {
            return Err(Error::new(ErrorKind::Shape, "a complex of points has no facets"));
        };
        let sides = sides_of_facets(boundaries)?;
        let (cell_count, input_count) = (boundaries.column_count(), inputs.column_count());
        let jumps = inputs.transpose();
        // In the order in which cells are reached.
        let mut numbers: Vec<(u32, i32)> = Vec::new();
        let mut spans: Vec<Option<[usize; 2]>> = vec![None; cell_count];
        let mut queue: Vec<u32> = Vec::new();
        let outer = (0..sides.len() as u32).filter(|&facet| {
            let [back, front] = sides[facet as usize];
            (back == EXTERIOR) != (front == EXTERIOR)
        });
        let mut frontier: Vec<u32> = outer.collect();
        let steps = stage("counting windings", cell_count);
        let mut sum = Vec::new();
        while !frontier.is_empty() {
            steps.advance(0);
            for facet in frontier.drain(..) {
                let [back, front] = sides[facet as usize];
                let span_of = |cell: u32| if cell == EXTERIOR { Some([0; 2]) } else { spans[cell as usize] };
                let ([from, end], to, sign) = match (span_of(back), span_of(front)) {
                    (None, Some(front)) => (front, back, 1),
                    (Some(back), None) => (back, front, -1),
                    _ => continue,
                };
                add_jumps(&numbers[from..end], jumps.column(facet as usize), sign, count, &mut sum)?;
                spans[to as usize] = Some([numbers.len(), numbers.len() + sum.len()]);
                numbers.append(&mut sum);
                queue.push(to);
            }
            steps.advance(queue.len());
            for cell in queue.drain(..) {
                frontier.extend_from_slice(boundaries.column(cell as usize).rows());
            }
        }
        let (mut starts, mut sorted) =
            (Vec::with_capacity(cell_count + 1), Vec::with_capacity(numbers.len()));
        for (cell, span) in spans.into_iter().enumerate() {
            let Some([from, end]) = span else {
                return Err(Error::new(
                    ErrorKind::Shape,
                    format!("cell c{cell} cannot be reached from the exterior across facets"),
                ));
            };
            starts.push(sorted.len());
            sorted.extend_from_slice(&numbers[from..end]);
        }
        starts.push(sorted.len());
        let found = Self { input_count, starts, numbers: sorted };
        found.check(&sides, &jumps, count)?;
        Ok(found)
    }

    /// `Shape` naming a facet across which the numbers do not rise by its multiplicity: then the cells are not all
    /// there.
    fn check(&self, sides: &[[u32; 2]], jumps: &SparseMatrix, count: Count) -> Result<(), Error> {
        let around = |cell: u32| if cell == EXTERIOR { &[][..] } else { self.around(CellId::from_u32(cell)) };
        let mut sum = Vec::new();
        for (facet, &[back, front]) in sides.iter().enumerate() {
            add_jumps(around(front), jumps.column(facet), 1, count, &mut sum)?;
            let expected = around(back);
            if sum != expected {
                let differ = sum.iter().zip(expected).position(|(a, b)| a != b);
                let at = differ.unwrap_or(sum.len().min(expected.len()));
                let input = sum.get(at).into_iter().chain(expected.get(at)).map(|&(input, _)| input).min();
                return Err(Error::new(
                    ErrorKind::Shape,
                    format!(
                        "input {} is closed, but does not bound cells: see facet {facet}",
                        input.unwrap_or_default()
                    ),
                )
                .with_cure("give all bounded cells of the arrangement"));
            }
            sum.clear();
        }
        Ok(())
    }

    /// The number of inputs.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_arrange::boolean::WindingNumbers;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A line of two edges; the first input is the first edge, the second input the whole line.
    /// let edges = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1)])?;
    /// let inputs = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (0, 1, -1), (2, 1, 1)])?;
    /// let winding = WindingNumbers::new(&ChainComplex::new(vec![edges])?, &inputs)?;
    /// assert_eq!(winding.input_count(), 2);
    /// # Ok(()) }
    /// ```
    pub fn input_count(&self) -> usize {
        self.input_count
    }

    /// The number of cells.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_arrange::boolean::WindingNumbers;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A line of two edges; the first input is the first edge, the second input the whole line.
    /// let edges = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1)])?;
    /// let inputs = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (0, 1, -1), (2, 1, 1)])?;
    /// let winding = WindingNumbers::new(&ChainComplex::new(vec![edges])?, &inputs)?;
    /// assert_eq!(winding.cell_count(), 2);
    /// # Ok(()) }
    /// ```
    pub fn cell_count(&self) -> usize {
        self.starts.len() - 1
    }

    /// The winding number of each input around a cell.
    ///
    /// # Panics
    /// If there is no such cell.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, SparseMatrix};
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_arrange::boolean::WindingNumbers;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A line of two edges; the first input is the first edge, the second input the whole line.
    /// let edges = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1)])?;
    /// let inputs = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (0, 1, -1), (2, 1, 1)])?;
    /// let winding = WindingNumbers::new(&ChainComplex::new(vec![edges])?, &inputs)?;
    /// assert_eq!(winding.of_cell(CellId::new(1)), [0, 1]);
    /// # Ok(()) }
    /// ```
    pub fn of_cell(&self, cell: CellId) -> Vec<i32> {
        let mut all = vec![0; self.input_count];
        self.around(cell).iter().for_each(|&(input, number)| all[input as usize] = number);
        all
    }

    /// The inputs whose winding number around a cell is not zero, rising, each with that number.
    ///
    /// # Panics
    /// If there is no such cell.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, SparseMatrix};
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_arrange::boolean::WindingNumbers;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A line of two edges; the first input is the first edge, the second input the whole line.
    /// let edges = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1)])?;
    /// let inputs = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (0, 1, -1), (2, 1, 1)])?;
    /// let winding = WindingNumbers::new(&ChainComplex::new(vec![edges])?, &inputs)?;
    /// assert_eq!(winding.around(CellId::new(1)), [(1, 1)]);
    /// # Ok(()) }
    /// ```
    pub fn around(&self, cell: CellId) -> &[(u32, i32)] {
        assert!(cell.index() < self.cell_count(), "there is no cell {cell}");
        &self.numbers[self.starts[cell.index()]..self.starts[cell.index() + 1]]
    }

    /// The winding number of an input around a cell.
    ///
    /// # Panics
    /// If there is no such cell.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, SparseMatrix};
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_arrange::boolean::WindingNumbers;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A line of two edges; the first input is the first edge, the second input the whole line.
    /// let edges = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1)])?;
    /// let inputs = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (0, 1, -1), (2, 1, 1)])?;
    /// let winding = WindingNumbers::new(&ChainComplex::new(vec![edges])?, &inputs)?;
    /// assert_eq!([0, 1].map(|input| winding.number(CellId::new(1), input)), [0, 1]);
    /// # Ok(()) }
    /// ```
    pub fn number(&self, cell: CellId, input: usize) -> i32 {
        let around = self.around(cell);
        around.binary_search_by_key(&input, |pair| pair.0 as usize).map_or(0, |at| around[at].1)
    }

    /// The inputs that a cell is inside of, rising.
    ///
    /// # Panics
    /// If there is no such cell.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, SparseMatrix};
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_arrange::boolean::{InsideRule, WindingNumbers};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A line of two edges; the first input is the first edge, the second input the whole line.
    /// let edges = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1)])?;
    /// let inputs = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (0, 1, -1), (2, 1, 1)])?;
    /// let winding = WindingNumbers::new(&ChainComplex::new(vec![edges])?, &inputs)?;
    /// assert!(winding.inputs_around(CellId::new(1), InsideRule::Nonzero).eq([1]));
    /// # Ok(()) }
    /// ```
    pub fn inputs_around(&self, cell: CellId, rule: InsideRule) -> impl Iterator<Item = usize> + '_ {
        let numbers = self.around(cell).iter();
        numbers.filter(move |&&(_, number)| rule.is_inside(number)).map(|&(input, _)| input as usize)
    }
}

/// Appends the numbers on one side of a facet to `sum`: those of the other side, and the multiplicities of the facet
/// with a sign.
fn add_jumps(
    numbers: &[(u32, i32)],
    jumps: Column<'_>,
    sign: i64,
    count: Count,
    sum: &mut Vec<(u32, i32)>,
) -> Result<(), Error> {
    let mut rest = numbers;
    for (input, multiplicity) in jumps.iter() {
        let (before, behind) = rest.split_at(rest.partition_point(|pair| (pair.0 as usize) < input));
        sum.extend_from_slice(before);
        rest = behind;
        let mut number = count.of(sign * i64::from(multiplicity));
        if let Some((&(_, own), behind)) = rest.split_first().filter(|(pair, _)| pair.0 as usize == input) {
            number = count.of(i64::from(own) + number);
            rest = behind;
        }
        if number != 0 {
            let number = i32::try_from(number).map_err(|_| {
                Error::new(ErrorKind::TooLarge, format!("input {input} winds {number} times around a cell"))
            })?;
            sum.push((input as u32, number));
        }
    }
    sum.extend_from_slice(rest);
    Ok(())
}

/// The cells behind and in front of each facet.
pub(super) fn sides_of_facets(boundaries: &SparseMatrix) -> Result<Vec<[u32; 2]>, Error> {
    let mut sides = vec![[EXTERIOR; 2]; boundaries.row_count()];
    for (cell, column) in boundaries.columns().enumerate() {
        for (facet, entry) in column.iter() {
            let side = match entry {
                1 => &mut sides[facet][0],
                -1 => &mut sides[facet][1],
                _ => {
                    return Err(Error::new(
                        ErrorKind::Shape,
                        format!(
                            "cell c{cell} has the coefficient {entry} on facet {facet}; only 1 and -1 are sides"
                        ),
                    ));
                }
            };
            if *side != EXTERIOR {
                return Err(Error::new(
                    ErrorKind::Shape,
                    format!("cells c{side} and c{cell} are on one side of facet {facet}"),
                ));
            }
            *side = cell as u32;
        }
    }
    Ok(sides)
}
