//! Filtrations: the order in which cells enter.

use coface_algebra::chains::ChainComplex;
use coface_algebra::progress::stage;
use coface_algebra::{CellId, Error, ErrorKind};
use rayon::prelude::*;
use std::cmp::Ordering;
use std::sync::OnceLock;

/// The value at which each cell of a complex enters; no face enters after a coface.
///
/// Values are finite. They rise along the filtration, but for an [upper star](Self::upper_star) and where they are [said to fall](Self::falling_in_order).
///
/// # Examples
/// A path 0 - 1 - 2 with heights 0, 2, 1 at its vertices: both edges enter with the vertex in the middle.
/// ```
/// use coface_algebra::SparseMatrix;
/// use coface_algebra::chains::ChainComplex;
/// use coface_topology::Filtration;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let edges = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1)])?;
/// let path = ChainComplex::new(vec![edges])?;
/// let filtration = Filtration::lower_star(&path, &[0.0, 2.0, 1.0])?;
/// assert_eq!(filtration.values(1), [2.0, 2.0]);
/// let error = Filtration::new(&path, vec![vec![0.0, 2.0, 1.0], vec![2.0, 1.5]]).unwrap_err();
/// assert!(error.message().contains("its face c1"));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct Filtration {
    /// The value of each cell of degree k at position k.
    values: Vec<Vec<f64>>,
    is_falling: bool,
    /// For each degree the cells in the order of entrance, from when they are asked for.
    entrances: Vec<OnceLock<Vec<u32>>>,
}

impl PartialEq for Filtration {
    fn eq(&self, other: &Self) -> bool {
        (&self.values, self.is_falling) == (&other.values, other.is_falling)
            && (0..self.values.len()).all(|degree| self.entrance(degree) == other.entrance(degree))
    }
}

impl Filtration {
    /// The filtration with these values: for each degree a list, for each cell a value.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless there is one value for each cell; [`ErrorKind::InvalidInput`] naming a cell whose
    /// value is not finite, or a face that enters after its coface.
    ///
    /// # Complexity
    /// Linear in the entries of the boundary matrices.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::Filtration;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edges = SparseMatrix::from_entries(2, 1, [(0, 0, -1), (1, 0, 1)])?;
    /// let segment = ChainComplex::new(vec![edges])?;
    /// assert!(Filtration::new(&segment, vec![vec![0.0, 2.0], vec![2.5]]).is_ok());
    /// // The edge would enter before one of its ends.
    /// assert!(Filtration::new(&segment, vec![vec![0.0, 2.0], vec![1.0]]).is_err());
    /// # Ok(()) }
    /// ```
    pub fn new(complex: &ChainComplex, mut values: Vec<Vec<f64>>) -> Result<Self, Error> {
        check_shape(complex, &values)?;
        for (degree, values) in values.iter_mut().enumerate() {
            check_finite(degree, values)?;
        }
        let filtration = Self::of_values(values, false);
        filtration.check(complex)?;
        Ok(filtration)
    }

    /// The same with the order in which the cells of each degree enter, which says what [`Self::new`] leaves to the numbers of cells: which of those with one
    /// value come first. Pairs depend on it, births and deaths do not.
    ///
    /// # Errors
    /// Those of [`Self::new`]; [`ErrorKind::InvalidInput`] for a degree whose list does not have each cell once, by rising values.
    ///
    /// # Complexity
    /// As of [`Self::new`].
    ///
    /// # Examples
    /// Of two points that enter together, the one that enters first stays.
    /// ```
    /// use coface_algebra::{CellId, SparseMatrix};
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::{Coefficients, Filtration, persistence};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let segment = ChainComplex::new(vec![SparseMatrix::from_entries(2, 1, [(0, 0, -1), (1, 0, 1)])?])?;
    /// let filtration = Filtration::in_order(&segment, vec![vec![0.0; 2], vec![3.0]], vec![vec![1, 0], vec![0]])?;
    /// let diagram = persistence(&segment, &filtration, Coefficients::Modulo(2))?;
    /// assert_eq!(diagram.pairs()[0].birth_cell(), CellId::new(1));
    /// assert!(Filtration::in_order(&segment, vec![vec![0.0, 1.0], vec![3.0]], vec![vec![1, 0], vec![0]]).is_err());
    /// # Ok(()) }
    /// ```
    pub fn in_order(
        complex: &ChainComplex,
        values: Vec<Vec<f64>>,
        order: Vec<Vec<u32>>,
    ) -> Result<Self, Error> {
        Self::new(complex, values)?.with_order(order)
    }

    /// The same with values that fall: superlevel sets grow, and no face has a lower value than a coface.
    ///
    /// # Errors
    /// As of [`Self::in_order`], with a list for each degree by falling values.
    ///
    /// # Complexity
    /// As of [`Self::new`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::Filtration;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let segment = ChainComplex::new(vec![SparseMatrix::from_entries(2, 1, [(0, 0, -1), (1, 0, 1)])?])?;
    /// let values = || vec![vec![1.0, 2.0], vec![0.5]];
    /// assert!(Filtration::falling_in_order(&segment, values(), vec![vec![1, 0], vec![0]])?.is_falling());
    /// assert!(Filtration::falling_in_order(&segment, values(), vec![vec![0, 1], vec![0]]).is_err());
    /// # Ok(()) }
    /// ```
    pub fn falling_in_order(
        complex: &ChainComplex,
        mut values: Vec<Vec<f64>>,
        order: Vec<Vec<u32>>,
    ) -> Result<Self, Error> {
        check_shape(complex, &values)?;
        for (degree, values) in values.iter_mut().enumerate() {
            check_finite(degree, values)?;
        }
        let filtration = Self::of_values(values, true);
        filtration.check(complex)?;
        filtration.with_order(order)
    }

    fn with_order(self, order: Vec<Vec<u32>>) -> Result<Self, Error> {
        let mut filtration = self;
        let mut is_there = Vec::new();
        for (degree, values) in filtration.values.iter().enumerate() {
            let cells = order.get(degree).map_or(&[][..], Vec::as_slice);
            is_there.clear();
            is_there.resize(values.len(), false);
            let is_new = |&cell: &u32| {
                is_there.get_mut(cell as usize).is_some_and(|is_there| !std::mem::replace(is_there, true))
            };
            let is_right = cells.len() == values.len()
                && cells.iter().all(is_new)
                && cells.is_sorted_by(|&a, &b| {
                    filtration.order(values[a as usize], values[b as usize]) != Ordering::Greater
                });
            if !is_right {
                let direction = if filtration.is_falling { "falling" } else { "rising" };
                return Err(Error::invalid(format!(
                    "the order of degree {degree} is not one of its cells by {direction} values"
                ))
                .with_cure("list each cell once, in the order of the values"));
            }
        }
        filtration.entrances = order.into_iter().map(OnceLock::from).collect();
        filtration.entrances.resize_with(filtration.values.len(), OnceLock::new);
        Ok(filtration)
    }

    /// The lower star filtration of a function on vertices: each cell enters with its highest vertex, the sublevel sets
    /// of the function grow.
    ///
    /// The vertices of a cell are those that its faces have, down to degree 0.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless there is one value for each vertex; [`ErrorKind::InvalidInput`] naming a vertex
    /// whose value is not finite, or a cell of positive degree with zero boundary (a loop): the complex does not say
    /// which vertices it has.
    ///
    /// # Complexity
    /// Linear in the entries of the boundary matrices.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::Filtration;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edges = SparseMatrix::from_entries(2, 1, [(0, 0, -1), (1, 0, 1)])?;
    /// let segment = ChainComplex::new(vec![edges])?;
    /// // The edge enters with its higher end.
    /// assert_eq!(Filtration::lower_star(&segment, &[0.0, 2.0])?.values(1), [2.0]);
    /// # Ok(()) }
    /// ```
    pub fn lower_star(complex: &ChainComplex, vertex_values: &[f64]) -> Result<Self, Error> {
        Self::star(complex, vertex_values, false)
    }

    /// The upper star filtration of a function on vertices: each cell enters with its lowest vertex, from high values
    /// to low ones, and the superlevel sets of the function grow.
    ///
    /// A class is then born at a value that is at least the value at which it dies.
    ///
    /// # Errors
    /// As [`Self::lower_star`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::Filtration;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edge = ChainComplex::new(vec![SparseMatrix::from_entries(2, 1, [(0, 0, -1), (1, 0, 1)])?])?;
    /// assert_eq!(Filtration::upper_star(&edge, &[0.0, 2.0])?.values(1), [0.0]);
    /// # Ok(()) }
    /// ```
    pub fn upper_star(complex: &ChainComplex, vertex_values: &[f64]) -> Result<Self, Error> {
        Self::star(complex, vertex_values, true)
    }

    fn star(complex: &ChainComplex, vertex_values: &[f64], is_falling: bool) -> Result<Self, Error> {
        let mut first = vertex_values.to_vec();
        if first.len() != complex.cell_count(0) {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("{} values for {} vertices", first.len(), complex.cell_count(0)),
            )
            .with_cure("give one value for each vertex"));
        }
        check_finite(0, &mut first)?;
        let later = if is_falling { f64::min } else { f64::max };
        let mut values = Vec::with_capacity(complex.degree_count());
        if complex.degree_count() > 0 {
            values.push(first);
        }
        for (below, matrix) in complex.boundary_matrices().iter().enumerate() {
            let faces = &values[below];
            let value = |(cell, column): (usize, coface_algebra::Column<'_>)| {
                let values = column.rows().iter().map(|&face| faces[face as usize]);
                values.reduce(later).ok_or_else(|| no_vertices(below + 1, cell))
            };
            let steps = stage("finding when cells enter", matrix.column_count());
            let level = steps.each(matrix.columns().enumerate()).map(value).collect::<Result<_, Error>>()?;
            values.push(level);
        }
        Ok(Self::of_values(values, is_falling))
    }

    /// The filtration in which some cells have a given value and each other cell enters with the first of its cofaces.
    ///
    /// This is how values on facets become a filtration.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless there is one place for each cell; [`ErrorKind::InvalidInput`] naming a cell that has
    /// neither a value nor a coface with one, and those of [`Self::new`].
    ///
    /// # Complexity
    /// Linear in the entries of the boundary matrices.
    ///
    /// # Examples
    /// Two edges in a row that enter at 1 and 2; the vertex between them enters with the first.
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::Filtration;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edges = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1)])?;
    /// let path = ChainComplex::new(vec![edges])?;
    /// let filtration = Filtration::from_cofaces(&path, &[vec![None; 3], vec![Some(1.0), Some(2.0)]])?;
    /// assert_eq!(filtration.values(0), [1.0, 1.0, 2.0]);
    /// # Ok(()) }
    /// ```
    pub fn from_cofaces(complex: &ChainComplex, given: &[Vec<Option<f64>>]) -> Result<Self, Error> {
        check_shape(complex, given)?;
        let mut values = given.to_vec();
        for degree in (1..complex.degree_count()).rev() {
            let matrix = complex.boundary_matrix(degree).expect("each degree below the count has its matrix");
            let (below, level) = values.split_at_mut(degree);
            let below = &mut below[degree - 1];
            let steps = stage("finding when cells enter", matrix.column_count());
            for (column, value) in steps.each(matrix.columns().zip(&level[0])) {
                let Some(value) = *value else { continue };
                for &face in column.rows() {
                    let face = face as usize;
                    if given[degree - 1][face].is_none() {
                        below[face] = Some(below[face].map_or(value, |least| least.min(value)));
                    }
                }
            }
        }
        let known = |(degree, level): (usize, Vec<Option<f64>>)| {
            let value = |(cell, value): (usize, Option<f64>)| {
                value.ok_or_else(|| {
                    Error::invalid(format!(
                        "cell {} of degree {degree} has no value, and no coface with one",
                        CellId::new(cell)
                    ))
                    .with_cure("give it a value")
                })
            };
            level.into_iter().enumerate().map(value).collect()
        };
        Self::new(complex, values.into_iter().enumerate().map(known).collect::<Result<_, Error>>()?)
    }

    /// The value of each cell of this degree; empty beyond the dimension.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::Filtration;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edges = SparseMatrix::from_entries(2, 1, [(0, 0, -1), (1, 0, 1)])?;
    /// let segment = ChainComplex::new(vec![edges])?;
    /// let filtration = Filtration::lower_star(&segment, &[0.0, 2.0])?;
    /// assert_eq!(filtration.values(0), [0.0, 2.0]);
    /// # Ok(()) }
    /// ```
    pub fn values(&self, degree: usize) -> &[f64] {
        self.values.get(degree).map_or(&[], Vec::as_slice)
    }

    /// Whether cells enter from high values to low ones, as for an upper star.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::Filtration;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edges = SparseMatrix::from_entries(2, 1, [(0, 0, -1), (1, 0, 1)])?;
    /// let segment = ChainComplex::new(vec![edges])?;
    /// assert!(!Filtration::lower_star(&segment, &[0.0, 2.0])?.is_falling());
    /// assert!(Filtration::upper_star(&segment, &[0.0, 2.0])?.is_falling());
    /// # Ok(()) }
    /// ```
    pub fn is_falling(&self) -> bool {
        self.is_falling
    }

    /// That the filtration is one of this complex: a value for each cell, and no face enters after a coface.
    ///
    /// # Errors
    /// Those of [`Self::new`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::Filtration;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edges = SparseMatrix::from_entries(2, 1, [(0, 0, -1), (1, 0, 1)])?;
    /// let segment = ChainComplex::new(vec![edges])?;
    /// let filtration = Filtration::lower_star(&segment, &[0.0, 2.0])?;
    /// filtration.check(&segment)?;
    /// assert!(filtration.check(&ChainComplex::of_points(1)).is_err());
    /// # Ok(()) }
    /// ```
    pub fn check(&self, complex: &ChainComplex) -> Result<(), Error> {
        check_shape(complex, &self.values)?;
        for (below, matrix) in complex.boundary_matrices().iter().enumerate() {
            let (faces, cells) = (&self.values[below], &self.values[below + 1]);
            let steps = stage("checking when cells enter", matrix.column_count());
            for (cell, column) in steps.each(matrix.columns().enumerate()) {
                for &face in column.rows() {
                    if self.order(faces[face as usize], cells[cell]) == Ordering::Greater {
                        return Err(Error::invalid(format!(
                            "cell {} of degree {} enters at {}, before its face {} of degree {below}, at {}",
                            CellId::new(cell),
                            below + 1,
                            cells[cell],
                            CellId::new(face as usize),
                            faces[face as usize]
                        ))
                        .with_cure("let each cell enter no earlier than its faces"));
                    }
                }
            }
        }
        Ok(())
    }

    /// Which of two values comes first.
    fn order(&self, a: f64, b: f64) -> Ordering {
        // Values are finite and there is no negative zero: this is the order of numbers.
        if self.is_falling { b.total_cmp(&a) } else { a.total_cmp(&b) }
    }

    /// The cells of a degree in the order in which they enter; ties by rising ids, unless their [order was given](Self::in_order).
    ///
    /// # Complexity
    /// n log n for n cells, when a degree is asked for first.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::Filtration;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let segment = ChainComplex::new(vec![SparseMatrix::from_entries(2, 1, [(0, 0, -1), (1, 0, 1)])?])?;
    /// assert_eq!(Filtration::lower_star(&segment, &[3.0, 2.0])?.entrance(0), [1, 0]);
    /// # Ok(()) }
    /// ```
    pub fn entrance(&self, degree: usize) -> &[u32] {
        let Some(order) = self.entrances.get(degree) else { return &[] };
        order.get().unwrap_or_else(|| {
            // Sorted before the lock is taken: a thread that waits for others while it sorts may be given work that asks for the same order.
            let sorted = self.sorted(degree);
            order.get_or_init(|| sorted)
        })
    }

    /// The filtration of some cells alone: `cells[k]` are those of degree k, by rising numbers, and their places are their new numbers. It is one of the
    /// complex that they are, or of that relative to the others.
    ///
    /// # Panics
    /// If there is no such cell.
    ///
    /// # Complexity
    /// Linear in the cells of all degrees that are listed, and n log n where they were not put in order before.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, SparseMatrix};
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::Filtration;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let segment = ChainComplex::new(vec![SparseMatrix::from_entries(2, 1, [(0, 0, -1), (1, 0, 1)])?])?;
    /// let filtration = Filtration::lower_star(&segment, &[3.0, 2.0])?;
    /// let edge = filtration.restricted(&[vec![], vec![CellId::new(0)]]);
    /// assert_eq!((edge.values(0), edge.values(1)), (&[][..], &[3.0][..]));
    /// # Ok(()) }
    /// ```
    #[must_use]
    pub fn restricted(&self, cells: &[Vec<CellId>]) -> Self {
        let of_degree = |(degree, cells): (usize, &Vec<CellId>)| -> (Vec<f64>, OnceLock<Vec<u32>>) {
            let values = self.values(degree);
            let mut numbers = vec![u32::MAX; values.len()];
            (0..).zip(cells).for_each(|(number, cell)| numbers[cell.index()] = number);
            let order = self.entrance(degree).iter().map(|&cell| numbers[cell as usize]);
            let order: Vec<u32> = order.filter(|&number| number != u32::MAX).collect();
            (cells.iter().map(|cell| values[cell.index()]).collect(), OnceLock::from(order))
        };
        let (values, entrances) = cells.iter().enumerate().map(of_degree).unzip();
        Self { values, is_falling: self.is_falling, entrances }
    }

    /// How many degrees have values.
    pub(super) fn degree_count(&self) -> usize {
        self.values.len()
    }

    fn of_values(values: Vec<Vec<f64>>, is_falling: bool) -> Self {
        let entrances = values.iter().map(|_| OnceLock::new()).collect();
        Self { values, is_falling, entrances }
    }

    fn sorted(&self, degree: usize) -> Vec<u32> {
        let _steps = stage("sorting cells", 0);
        // Numbers whose order is that of the values: sorting them reads memory in a row.
        let key = |value: f64| {
            // Zeros of both signs are equal.
            let bits = (value + 0.0).to_bits();
            let rising = if bits >> 63 == 1 { !bits } else { bits | 1 << 63 };
            if self.is_falling { !rising } else { rising }
        };
        let mut cells: Vec<(u64, u32)> =
            self.values[degree].iter().enumerate().map(|(cell, &value)| (key(value), cell as u32)).collect();
        cells.par_sort_unstable();
        cells.into_iter().map(|(_, cell)| cell).collect()
    }
}

fn check_shape<T>(complex: &ChainComplex, values: &[Vec<T>]) -> Result<(), Error> {
    let mut counts: Vec<usize> = values.iter().map(Vec::len).collect();
    // What is left of points without any of them has no degrees.
    counts.truncate(
        complex.degree_count().max(counts.iter().rposition(|&count| count > 0).map_or(0, |last| last + 1)),
    );
    if counts == complex.f_vector() {
        return Ok(());
    }
    Err(Error::new(
        ErrorKind::Shape,
        format!("the values have the counts {counts:?}, but the complex has {:?} cells", complex.f_vector()),
    )
    .with_cure("give for each degree one value a cell"))
}

/// That values are finite; negative zeros become zeros, so that equal numbers have one order.
fn check_finite(degree: usize, values: &mut [f64]) -> Result<(), Error> {
    for (cell, value) in values.iter_mut().enumerate() {
        if !value.is_finite() {
            return Err(Error::invalid(format!(
                "the value of cell {} of degree {degree} is {value}, not a finite number",
                CellId::new(cell)
            )));
        }
        *value += 0.0;
    }
    Ok(())
}

fn no_vertices(degree: usize, cell: usize) -> Error {
    Error::invalid(format!(
        "cell {} of degree {degree} has zero boundary, so its vertices are not known",
        CellId::new(cell)
    ))
    .with_cure("give a value for each cell instead of a function on vertices")
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_algebra::SparseMatrix;

    fn triangle() -> ChainComplex {
        ChainComplex::new(vec![
            SparseMatrix::from_entries(
                3,
                3,
                [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1), (0, 2, -1), (2, 2, 1)],
            )
            .unwrap(),
            SparseMatrix::from_entries(3, 1, [(0, 0, 1), (1, 0, 1), (2, 0, -1)]).unwrap(),
        ])
        .unwrap()
    }

    #[test]
    fn stars_are_maxima_and_minima() {
        let lower = Filtration::lower_star(&triangle(), &[3.0, -0.0, 1.0]).unwrap();
        assert_eq!((lower.values(1), lower.values(2)), (&[3.0, 1.0, 3.0][..], &[3.0][..]));
        let upper = Filtration::upper_star(&triangle(), &[3.0, 0.0, 1.0]).unwrap();
        assert_eq!((upper.values(1), upper.values(2)), (&[0.0, 0.0, 1.0][..], &[0.0][..]));
        assert_eq!((lower.entrance(0), upper.entrance(0)), (&[1, 2, 0][..], &[0, 2, 1][..]));
        lower.check(&triangle()).unwrap();
        upper.check(&triangle()).unwrap();
        assert!(lower.values(3).is_empty());
    }

    #[test]
    fn faults_are_named() {
        let fault = |values| Filtration::new(&triangle(), values).unwrap_err();
        let error = fault(vec![vec![0.0; 3], vec![0.0, 2.0, 0.0], vec![1.0]]);
        assert_eq!(error.kind(), ErrorKind::InvalidInput);
        assert_eq!(error.message(), "cell c0 of degree 2 enters at 1, before its face c1 of degree 1, at 2");
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let error = fault(vec![vec![0.0; 3], vec![0.0, 0.0, bad], vec![0.0]]);
            assert!(error.message().contains("c2 of degree 1"), "{error}");
        }
        assert_eq!(fault(vec![vec![0.0; 3], vec![0.0; 3]]).kind(), ErrorKind::Shape);
        assert_eq!(Filtration::lower_star(&triangle(), &[0.0]).unwrap_err().kind(), ErrorKind::Shape);
        let lonely = vec![vec![None; 3], vec![Some(1.0), None, None], vec![None]];
        let error = Filtration::from_cofaces(&triangle(), &lonely).unwrap_err();
        assert!(error.message().contains("c2 of degree 0 has no value"), "{error}");
        let circle = ChainComplex::new(vec![SparseMatrix::zero(1, 1).unwrap()]).unwrap();
        let error = Filtration::lower_star(&circle, &[0.0]).unwrap_err();
        assert!(error.message().contains("zero boundary"), "{error}");
    }

    #[test]
    fn given_values_are_kept_above_those_of_cofaces() {
        let given = vec![vec![Some(-1.0), None, None], vec![None, Some(0.5), None], vec![Some(2.0)]];
        let filtration = Filtration::from_cofaces(&triangle(), &given).unwrap();
        assert_eq!(
            (filtration.values(0), filtration.values(1)),
            (&[-1.0, 0.5, 0.5][..], &[2.0, 0.5, 2.0][..])
        );
    }

    #[test]
    fn the_empty_complex_has_the_empty_filtration() {
        let empty = ChainComplex::of_points(0);
        assert!(Filtration::lower_star(&empty, &[]).unwrap().values(0).is_empty());
    }
}
