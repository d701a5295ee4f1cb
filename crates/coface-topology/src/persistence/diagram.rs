//! Persistence diagrams: births and deaths of classes.

use super::{Barcode, Filtration};
use coface_algebra::CellId;

/// A class of persistent homology: the cell and the value of its birth, and those of its death if it dies.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct PersistencePair {
    degree: usize,
    birth: f64,
    death: Option<f64>,
    birth_cell: CellId,
    death_cell: Option<CellId>,
}

impl PersistencePair {
    pub(super) fn new(
        filtration: &Filtration,
        degree: usize,
        birth_cell: u32,
        death_cell: Option<u32>,
    ) -> Self {
        Self {
            degree,
            birth: filtration.values(degree)[birth_cell as usize],
            death: death_cell.map(|cell| filtration.values(degree + 1)[cell as usize]),
            birth_cell: CellId::new(birth_cell as usize),
            death_cell: death_cell.map(|cell| CellId::new(cell as usize)),
        }
    }

    /// The degree of the class.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::{Coefficients, Filtration, persistence};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A path 0 - 1 - 2 with heights 0, 2, 1 at its vertices.
    /// let edges = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1)])?;
    /// let path = ChainComplex::new(vec![edges])?;
    /// let filtration = Filtration::lower_star(&path, &[0.0, 2.0, 1.0])?;
    /// let diagram = persistence(&path, &filtration, Coefficients::Modulo(2))?;
    /// let valleys = diagram.longer_than(0.0);
    /// assert_eq!(valleys.pairs()[1].degree(), 0);
    /// # Ok(()) }
    /// ```
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// The value at which the class is born.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::{Coefficients, Filtration, persistence};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A path 0 - 1 - 2 with heights 0, 2, 1 at its vertices.
    /// let edges = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1)])?;
    /// let path = ChainComplex::new(vec![edges])?;
    /// let filtration = Filtration::lower_star(&path, &[0.0, 2.0, 1.0])?;
    /// let diagram = persistence(&path, &filtration, Coefficients::Modulo(2))?;
    /// let valleys = diagram.longer_than(0.0);
    /// assert_eq!(valleys.pairs()[1].birth(), 1.0);
    /// # Ok(()) }
    /// ```
    pub fn birth(&self) -> f64 {
        self.birth
    }

    /// The value at which the class dies; `None` for an essential class.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::{Coefficients, Filtration, persistence};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A path 0 - 1 - 2 with heights 0, 2, 1 at its vertices.
    /// let edges = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1)])?;
    /// let path = ChainComplex::new(vec![edges])?;
    /// let filtration = Filtration::lower_star(&path, &[0.0, 2.0, 1.0])?;
    /// let diagram = persistence(&path, &filtration, Coefficients::Modulo(2))?;
    /// let valleys = diagram.longer_than(0.0);
    /// assert_eq!(valleys.pairs()[1].death(), Some(2.0));
    /// assert_eq!(valleys.pairs()[0].death(), None);
    /// # Ok(()) }
    /// ```
    pub fn death(&self) -> Option<f64> {
        self.death
    }

    /// The cell whose entry creates the class; it has the degree of the class.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, SparseMatrix};
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::{Coefficients, Filtration, persistence};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A path 0 - 1 - 2 with heights 0, 2, 1 at its vertices.
    /// let edges = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1)])?;
    /// let path = ChainComplex::new(vec![edges])?;
    /// let filtration = Filtration::lower_star(&path, &[0.0, 2.0, 1.0])?;
    /// let diagram = persistence(&path, &filtration, Coefficients::Modulo(2))?;
    /// let valleys = diagram.longer_than(0.0);
    /// assert_eq!(valleys.pairs()[1].birth_cell(), CellId::new(2));
    /// # Ok(()) }
    /// ```
    pub fn birth_cell(&self) -> CellId {
        self.birth_cell
    }

    /// The cell whose entry ends the class, one degree higher; `None` for an essential class.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::{Coefficients, Filtration, persistence};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A path 0 - 1 - 2 with heights 0, 2, 1 at its vertices.
    /// let edges = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1)])?;
    /// let path = ChainComplex::new(vec![edges])?;
    /// let filtration = Filtration::lower_star(&path, &[0.0, 2.0, 1.0])?;
    /// let diagram = persistence(&path, &filtration, Coefficients::Modulo(2))?;
    /// let valleys = diagram.longer_than(0.0);
    /// assert!(valleys.pairs()[1].death_cell().is_some());
    /// assert_eq!(valleys.pairs()[0].death_cell(), None);
    /// # Ok(()) }
    /// ```
    pub fn death_cell(&self) -> Option<CellId> {
        self.death_cell
    }

    /// Whether the class never dies.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::{Coefficients, Filtration, persistence};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A path 0 - 1 - 2 with heights 0, 2, 1 at its vertices.
    /// let edges = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1)])?;
    /// let path = ChainComplex::new(vec![edges])?;
    /// let filtration = Filtration::lower_star(&path, &[0.0, 2.0, 1.0])?;
    /// let diagram = persistence(&path, &filtration, Coefficients::Modulo(2))?;
    /// let valleys = diagram.longer_than(0.0);
    /// assert!(valleys.pairs()[0].is_essential());
    /// # Ok(()) }
    /// ```
    pub fn is_essential(&self) -> bool {
        self.death.is_none()
    }

    /// The distance between birth and death; infinite for an essential class.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::{Coefficients, Filtration, persistence};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A path 0 - 1 - 2 with heights 0, 2, 1 at its vertices.
    /// let edges = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1)])?;
    /// let path = ChainComplex::new(vec![edges])?;
    /// let filtration = Filtration::lower_star(&path, &[0.0, 2.0, 1.0])?;
    /// let diagram = persistence(&path, &filtration, Coefficients::Modulo(2))?;
    /// let valleys = diagram.longer_than(0.0);
    /// assert_eq!(valleys.pairs()[1].persistence(), 1.0);
    /// assert_eq!(valleys.pairs()[0].persistence(), f64::INFINITY);
    /// # Ok(()) }
    /// ```
    pub fn persistence(&self) -> f64 {
        self.death.map_or(f64::INFINITY, |death| (death - self.birth).abs())
    }
}

/// All pairs of a filtration over one field: by rising degree, then in the order of births.
///
/// # Examples
/// See [`persistence`](super::persistence).
#[derive(Clone, Debug, PartialEq)]
pub struct PersistenceDiagram {
    prime: u32,
    is_falling: bool,
    /// The pairs of degree k at `starts[k]..starts[k + 1]`.
    pairs: Vec<PersistencePair>,
    starts: Vec<usize>,
}

impl PersistenceDiagram {
    pub(super) fn new(prime: u32, is_falling: bool, degrees: Vec<Vec<PersistencePair>>) -> Self {
        let mut starts = vec![0];
        starts.extend(degrees.iter().scan(0, |total, pairs| {
            *total += pairs.len();
            Some(*total)
        }));
        Self { prime, is_falling, pairs: degrees.into_iter().flatten().collect(), starts }
    }

    /// The number of elements of the field.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::{Coefficients, Filtration, persistence};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A path 0 - 1 - 2 with heights 0, 2, 1 at its vertices.
    /// let edges = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1)])?;
    /// let path = ChainComplex::new(vec![edges])?;
    /// let filtration = Filtration::lower_star(&path, &[0.0, 2.0, 1.0])?;
    /// let diagram = persistence(&path, &filtration, Coefficients::Modulo(2))?;
    /// assert_eq!(diagram.prime(), 2);
    /// # Ok(()) }
    /// ```
    pub fn prime(&self) -> u32 {
        self.prime
    }

    /// Whether values fall along the filtration, so that no class dies above its birth.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::{Coefficients, Filtration, persistence};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A path 0 - 1 - 2 with heights 0, 2, 1 at its vertices.
    /// let edges = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1)])?;
    /// let path = ChainComplex::new(vec![edges])?;
    /// let filtration = Filtration::lower_star(&path, &[0.0, 2.0, 1.0])?;
    /// let diagram = persistence(&path, &filtration, Coefficients::Modulo(2))?;
    /// assert!(!diagram.is_falling());
    /// # Ok(()) }
    /// ```
    pub fn is_falling(&self) -> bool {
        self.is_falling
    }

    /// The number of degrees of the complex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::{Coefficients, Filtration, persistence};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A path 0 - 1 - 2 with heights 0, 2, 1 at its vertices.
    /// let edges = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1)])?;
    /// let path = ChainComplex::new(vec![edges])?;
    /// let filtration = Filtration::lower_star(&path, &[0.0, 2.0, 1.0])?;
    /// let diagram = persistence(&path, &filtration, Coefficients::Modulo(2))?;
    /// assert_eq!(diagram.degree_count(), 2);
    /// # Ok(()) }
    /// ```
    pub fn degree_count(&self) -> usize {
        self.starts.len() - 1
    }

    /// All pairs: by rising degree, then in the order of births.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::{Coefficients, Filtration, persistence};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A path 0 - 1 - 2 with heights 0, 2, 1 at its vertices.
    /// let edges = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1)])?;
    /// let path = ChainComplex::new(vec![edges])?;
    /// let filtration = Filtration::lower_star(&path, &[0.0, 2.0, 1.0])?;
    /// let diagram = persistence(&path, &filtration, Coefficients::Modulo(2))?;
    /// // Three components are born, two of them die.
    /// assert_eq!(diagram.pairs().len(), 3);
    /// # Ok(()) }
    /// ```
    pub fn pairs(&self) -> &[PersistencePair] {
        &self.pairs
    }

    /// The pairs of this degree; empty beyond the dimension.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::{Coefficients, Filtration, persistence};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A path 0 - 1 - 2 with heights 0, 2, 1 at its vertices.
    /// let edges = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1)])?;
    /// let path = ChainComplex::new(vec![edges])?;
    /// let filtration = Filtration::lower_star(&path, &[0.0, 2.0, 1.0])?;
    /// let diagram = persistence(&path, &filtration, Coefficients::Modulo(2))?;
    /// assert_eq!(diagram.pairs_of_degree(0).len(), 3);
    /// assert!(diagram.pairs_of_degree(1).is_empty());
    /// # Ok(()) }
    /// ```
    pub fn pairs_of_degree(&self, degree: usize) -> &[PersistencePair] {
        match self.starts.get(degree + 1) {
            Some(&end) => &self.pairs[self.starts[degree]..end],
            None => &[],
        }
    }

    /// The degrees up to one: of a complex that lacks its cells of higher degree, those that it tells.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::{Coefficients, Filtration, persistence};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edges = SparseMatrix::from_entries(2, 2, [(0, 0, -1), (1, 0, 1), (0, 1, -1), (1, 1, 1)])?;
    /// let circle = ChainComplex::new(vec![edges])?;
    /// let filtration = Filtration::lower_star(&circle, &[0.0, 1.0])?;
    /// let diagram = persistence(&circle, &filtration, Coefficients::Modulo(2))?;
    /// assert_eq!(diagram.up_to_degree(0).betti_numbers(), [1]);
    /// # Ok(()) }
    /// ```
    pub fn up_to_degree(mut self, degree: usize) -> Self {
        if let Some(&end) = degree.checked_add(1).and_then(|next| self.starts.get(next)) {
            self.pairs.truncate(end);
            self.starts.truncate(degree + 2);
        }
        self
    }

    /// The births and deaths of a degree; deaths of essential classes are infinite.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::{Coefficients, Filtration, persistence};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A path 0 - 1 - 2 with heights 0, 2, 1 at its vertices.
    /// let edges = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1)])?;
    /// let path = ChainComplex::new(vec![edges])?;
    /// let filtration = Filtration::lower_star(&path, &[0.0, 2.0, 1.0])?;
    /// let diagram = persistence(&path, &filtration, Coefficients::Modulo(2))?;
    /// assert_eq!(diagram.longer_than(0.0).barcode(0).intervals(), [[0.0, f64::INFINITY], [1.0, 2.0]]);
    /// # Ok(()) }
    /// ```
    pub fn barcode(&self, degree: usize) -> Barcode {
        let never = if self.is_falling { f64::NEG_INFINITY } else { f64::INFINITY };
        let pairs = self.pairs_of_degree(degree).iter();
        Barcode::of(pairs.map(|pair| [pair.birth, pair.death.unwrap_or(never)]))
    }

    /// The Betti numbers of the whole complex over the field: the numbers of essential classes by degree.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::{Coefficients, Filtration, persistence};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A path 0 - 1 - 2 with heights 0, 2, 1 at its vertices.
    /// let edges = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1)])?;
    /// let path = ChainComplex::new(vec![edges])?;
    /// let filtration = Filtration::lower_star(&path, &[0.0, 2.0, 1.0])?;
    /// let diagram = persistence(&path, &filtration, Coefficients::Modulo(2))?;
    /// assert_eq!(diagram.betti_numbers(), [1, 0]);
    /// # Ok(()) }
    /// ```
    pub fn betti_numbers(&self) -> Vec<usize> {
        let essential =
            |degree| self.pairs_of_degree(degree).iter().filter(|pair| pair.is_essential()).count();
        (0..self.degree_count()).map(essential).collect()
    }

    /// The same with other numbers of cells: `cells[k][i]` is the new number of cell i of degree k. Diagrams of some cells of a complex, made with
    /// [`Filtration::restricted`], have the numbers of the whole so.
    ///
    /// # Panics
    /// If a cell has no new number.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::CellId;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::{Coefficients, Filtration, persistence};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = ChainComplex::of_points(1);
    /// let diagram = persistence(&points, &Filtration::lower_star(&points, &[1.0])?, Coefficients::Modulo(2))?;
    /// assert_eq!(diagram.with_cells(&[vec![CellId::new(7)]]).pairs()[0].birth_cell(), CellId::new(7));
    /// # Ok(()) }
    /// ```
    #[must_use]
    pub fn with_cells(mut self, cells: &[Vec<CellId>]) -> Self {
        for pair in &mut self.pairs {
            pair.birth_cell = cells[pair.degree][pair.birth_cell.index()];
            pair.death_cell = pair.death_cell.map(|cell| cells[pair.degree + 1][cell.index()]);
        }
        self
    }

    /// The diagram without the pairs whose persistence is `length` or less: 0 removes the diagonal, a negative length
    /// removes nothing. Essential classes stay.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::{Coefficients, Filtration, persistence};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A path 0 - 1 - 2 with heights 0, 2, 1 at its vertices.
    /// let edges = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1)])?;
    /// let path = ChainComplex::new(vec![edges])?;
    /// let filtration = Filtration::lower_star(&path, &[0.0, 2.0, 1.0])?;
    /// let diagram = persistence(&path, &filtration, Coefficients::Modulo(2))?;
    /// assert_eq!(diagram.longer_than(0.0).pairs().len(), 2);
    /// assert_eq!(diagram.longer_than(1.0).pairs().len(), 1);
    /// # Ok(()) }
    /// ```
    #[must_use]
    pub fn longer_than(&self, length: f64) -> Self {
        let kept = |degree| {
            let pairs = self.pairs_of_degree(degree).iter();
            pairs.filter(|pair| pair.persistence() > length).copied().collect()
        };
        Self::new(self.prime, self.is_falling, (0..self.degree_count()).map(kept).collect())
    }
}
