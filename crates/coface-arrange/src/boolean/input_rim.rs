//! Where inputs are open.

use coface_algebra::chains::ChainComplex;
use coface_algebra::progress::stage;
use coface_algebra::{CellId, Error, ErrorKind};
use coface_algebra::{Column, SparseMatrix};
use rayon::prelude::*;
use std::collections::BTreeMap;

/// So many cells are named in a message.
const MOST_NAMED: usize = 12;

/// The boundary of an input that is not closed: the ridges where it is open.
///
/// # Examples
/// A path of two edges is open at its ends:
/// ```
/// use coface_algebra::CellId;
/// use coface_algebra::SparseMatrix;
/// use coface_arrange::boolean::InputRim;
/// use coface_algebra::chains::ChainComplex;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let edges = [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1), (0, 2, -1), (2, 2, 1)];
/// let face = [(0, 0, 1), (1, 0, 1), (2, 0, -1)];
/// let triangle = vec![SparseMatrix::from_entries(3, 3, edges)?, SparseMatrix::from_entries(3, 1, face)?];
/// let path = SparseMatrix::from_entries(3, 1, [(0, 0, 1), (1, 0, 1)])?;
/// let rims = InputRim::of_inputs(&ChainComplex::new(triangle)?, &path)?;
/// assert_eq!(rims[0].ridges(), [(CellId::new(0), -1), (CellId::new(2), 1)]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct InputRim {
    input: usize,
    ridges: Vec<(CellId, i64)>,
    walk: Vec<CellId>,
}

impl InputRim {
    /// The rims of the inputs that have one, by rising input. Column i of `inputs` is input i as a chain of the facets
    /// of the complex, the cells of one degree less than its highest.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless there is a row of `inputs` for each facet.
    ///
    /// # Complexity
    /// $O(n \log n)$ for n sides of facets of inputs.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_arrange::boolean::InputRim;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two edges of a triangle are open at their ends.
    /// let edges = [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1), (0, 2, -1), (2, 2, 1)];
    /// let face = SparseMatrix::from_entries(3, 1, [(0, 0, 1), (1, 0, 1), (2, 0, -1)])?;
    /// let triangle = ChainComplex::new(vec![SparseMatrix::from_entries(3, 3, edges)?, face])?;
    /// let path = SparseMatrix::from_entries(3, 1, [(0, 0, 1), (1, 0, 1)])?;
    /// let rims = InputRim::of_inputs(&triangle, &path)?;
    /// assert_eq!(rims.len(), 1);
    /// # Ok(()) }
    /// ```
    pub fn of_inputs(complex: &ChainComplex, inputs: &SparseMatrix) -> Result<Vec<Self>, Error> {
        let Some(degree) = complex.degree_count().checked_sub(2) else { return Ok(Vec::new()) };
        if inputs.row_count() != complex.cell_count(degree) {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("{} rows of inputs for {} facets", inputs.row_count(), complex.cell_count(degree)),
            ));
        }
        let Some(ridges) = complex.boundary_matrix(degree) else { return Ok(Vec::new()) };
        // A few long runs, as each has sums of its own.
        let columns =
            (0..inputs.column_count()).into_par_iter().with_min_len(inputs.column_count().div_ceil(4));
        let no_sums = || vec![0i64; ridges.row_count()];
        let steps = stage("checking that inputs are closed", inputs.column_count());
        let rims = columns.map_init(no_sums, |sum, input| {
            steps.advance(1);
            let open = boundary(ridges, inputs.column(input), sum);
            if open.is_empty() {
                return None;
            }
            let open_cells: Vec<u32> = open.iter().map(|(ridge, _)| ridge.to_u32()).collect();
            let walk = match complex.boundary_matrix(degree - 1) {
                Some(ends) if degree == 2 => walk_through(ends, &open_cells),
                _ => open_cells,
            };
            Some(Self { input, ridges: open, walk: walk.into_iter().map(CellId::from_u32).collect() })
        });
        Ok(rims.flatten_iter().collect())
    }

    /// The number of the input.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_arrange::boolean::InputRim;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two edges of a triangle are open at their ends.
    /// let edges = [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1), (0, 2, -1), (2, 2, 1)];
    /// let face = SparseMatrix::from_entries(3, 1, [(0, 0, 1), (1, 0, 1), (2, 0, -1)])?;
    /// let triangle = ChainComplex::new(vec![SparseMatrix::from_entries(3, 3, edges)?, face])?;
    /// let path = SparseMatrix::from_entries(3, 1, [(0, 0, 1), (1, 0, 1)])?;
    /// let rims = InputRim::of_inputs(&triangle, &path)?;
    /// assert_eq!(rims[0].input(), 0);
    /// # Ok(()) }
    /// ```
    pub fn input(&self) -> usize {
        self.input
    }

    /// The ridges where the input is open, rising, each with its coefficient in the boundary of the input.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, SparseMatrix};
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_arrange::boolean::InputRim;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two edges of a triangle are open at their ends.
    /// let edges = [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1), (0, 2, -1), (2, 2, 1)];
    /// let face = SparseMatrix::from_entries(3, 1, [(0, 0, 1), (1, 0, 1), (2, 0, -1)])?;
    /// let triangle = ChainComplex::new(vec![SparseMatrix::from_entries(3, 3, edges)?, face])?;
    /// let path = SparseMatrix::from_entries(3, 1, [(0, 0, 1), (1, 0, 1)])?;
    /// let rims = InputRim::of_inputs(&triangle, &path)?;
    /// assert_eq!(rims[0].ridges(), [(CellId::new(0), -1), (CellId::new(2), 1)]);
    /// # Ok(()) }
    /// ```
    pub fn ridges(&self) -> &[(CellId, i64)] {
        &self.ridges
    }

    /// In space a closed walk along edges of the rim; else all its ridges.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, SparseMatrix};
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_arrange::boolean::InputRim;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two edges of a triangle are open at their ends.
    /// let edges = [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1), (0, 2, -1), (2, 2, 1)];
    /// let face = SparseMatrix::from_entries(3, 1, [(0, 0, 1), (1, 0, 1), (2, 0, -1)])?;
    /// let triangle = ChainComplex::new(vec![SparseMatrix::from_entries(3, 3, edges)?, face])?;
    /// let path = SparseMatrix::from_entries(3, 1, [(0, 0, 1), (1, 0, 1)])?;
    /// let rims = InputRim::of_inputs(&triangle, &path)?;
    /// // In the plane these are all ridges of the rim.
    /// assert_eq!(rims[0].walk(), [CellId::new(0), CellId::new(2)]);
    /// # Ok(()) }
    /// ```
    pub fn walk(&self) -> &[CellId] {
        &self.walk
    }

    /// The vertices that a closed walk in space runs through, in its order.
    pub fn walk_vertices(&self, complex: &ChainComplex) -> Vec<CellId> {
        let Some(ends) = complex.boundary_matrix(1) else { return Vec::new() };
        let rows = |edge: CellId| ends.column(edge.index()).rows();
        let next = |i: usize| rows(self.walk[(i + 1) % self.walk.len()]);
        (0..self.walk.len())
            .filter_map(|i| rows(self.walk[i]).iter().find(|vertex| next(i).contains(vertex)))
            .map(|&vertex| CellId::from_u32(vertex))
            .collect()
    }

    /// Whether all coefficients are even: then the input has facets on both sides of each ridge and is closed but for
    /// their directions, which do not agree. Its winding numbers are known up to even numbers.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_arrange::boolean::InputRim;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two edges of a triangle are open at their ends.
    /// let edges = [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1), (0, 2, -1), (2, 2, 1)];
    /// let face = SparseMatrix::from_entries(3, 1, [(0, 0, 1), (1, 0, 1), (2, 0, -1)])?;
    /// let triangle = ChainComplex::new(vec![SparseMatrix::from_entries(3, 3, edges)?, face])?;
    /// let path = SparseMatrix::from_entries(3, 1, [(0, 0, 1), (1, 0, 1)])?;
    /// let rims = InputRim::of_inputs(&triangle, &path)?;
    /// assert!(!rims[0].is_even());
    /// # Ok(()) }
    /// ```
    pub fn is_even(&self) -> bool {
        self.ridges.iter().all(|(_, coefficient)| coefficient % 2 == 0)
    }

    /// The error for an input that is not closed; it names cells of the complex.
    pub(super) fn error(&self, complex: &ChainComplex) -> Error {
        let letter = match complex.degree_count() {
            4 => 'e',
            3 => 'v',
            _ => 'c',
        };
        let name = |ridge: &CellId| format!("{letter}{}", ridge.index());
        let mut list: Vec<String> = self.walk.iter().take(MOST_NAMED).map(name).collect();
        if self.walk.len() > MOST_NAMED {
            list.push(format!("... ({} in all)", self.walk.len()));
        }
        Error::new(
            ErrorKind::NotACycle,
            format!("input {} is not closed: it is open along {}", self.input, list.join(" ")),
        )
        .with_cure("close the input; only closed inputs have an inside")
    }
}

/// The boundary of a chain; `sum` is zero before and after.
fn boundary(ridges: &SparseMatrix, chain: Column<'_>, sum: &mut [i64]) -> Vec<(CellId, i64)> {
    let mut touched = Vec::new();
    for (facet, multiplicity) in chain.iter() {
        for (ridge, entry) in ridges.column(facet).iter() {
            sum[ridge] += i64::from(entry) * i64::from(multiplicity);
            touched.push(ridge as u32);
        }
    }
    if touched.len() >= sum.len() / 16 {
        let open = (0..).zip(sum).map(|(ridge, sum)| (CellId::from_u32(ridge), std::mem::take(sum)));
        return open.filter(|&(_, coefficient)| coefficient != 0).collect();
    }
    touched.sort_unstable();
    touched.dedup();
    let own =
        touched.into_iter().map(|ridge| (CellId::from_u32(ridge), std::mem::take(&mut sum[ridge as usize])));
    own.filter(|&(_, coefficient)| coefficient != 0).collect()
}

/// A walk along edges that are the support of a cycle, from the first of them until it comes back to where it was.
fn walk_through(ends: &SparseMatrix, edges: &[u32]) -> Vec<u32> {
    let mut at_vertex: Vec<(u32, u32)> = edges
        .iter()
        .flat_map(|&edge| ends.column(edge as usize).rows().iter().map(move |&vertex| (vertex, edge)))
        .collect();
    at_vertex.sort_unstable();
    let Some(&start) = ends.column(edges[0] as usize).rows().first() else { return edges.to_vec() };
    let mut walk = vec![edges[0]];
    // The vertex that the walk is at, and the place in it of each edge's first vertex.
    let mut here = start;
    let mut places = BTreeMap::from([(start, 0)]);
    let mut edge = edges[0];
    loop {
        let Some(&next) = ends.column(edge as usize).rows().iter().find(|&&vertex| vertex != here) else {
            return walk;
        };
        if let Some(&first) = places.get(&next) {
            walk.drain(..first);
            return walk;
        }
        places.insert(next, walk.len());
        // A vertex of the support of a cycle has another edge of it.
        let from = at_vertex.partition_point(|&(vertex, _)| vertex < next);
        let around = at_vertex[from..].iter().take_while(|&&(vertex, _)| vertex == next);
        let Some(&(_, other)) = { around }.find(|&&(_, other)| other != edge) else { return walk };
        walk.push(other);
        (here, edge) = (next, other);
    }
}
