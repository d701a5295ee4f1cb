//! Cells that a formula selects, and their boundary.

use super::pinches::Pinches;
use super::winding::sides_of_facets;
use super::{BooleanFormula, InsideRule, WindingNumbers};
use coface_algebra::Sign;
use coface_algebra::chains::ChainComplex;
use coface_algebra::{CellId, Error, ErrorKind};

/// Some cells of an arrangement, possibly with the exterior.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CellSelection {
    cells: Vec<bool>,
    exterior: bool,
}

/// The boundary of a selection of cells.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SelectionBoundary {
    facets: Vec<(CellId, Sign)>,
    walls: Vec<CellId>,
    pinches: Pinches,
}

impl CellSelection {
    /// The cells with `true`, and the exterior if asked.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::CellId;
    /// use coface_arrange::boolean::CellSelection;
    /// let selection = CellSelection::new(vec![true, false, true], false);
    /// assert!(selection.cells().eq([CellId::new(0), CellId::new(2)]));
    /// ```
    pub fn new(cells: Vec<bool>, exterior: bool) -> Self {
        Self { cells, exterior }
    }

    /// The cells for which a formula holds. The exterior is in it when the formula holds with all inputs false.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] if the formula names an input that is not there.
    ///
    /// # Complexity
    /// Linear in the cells times the length of the formula.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, SparseMatrix};
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_arrange::boolean::{BooleanFormula, CellSelection, InsideRule, WindingNumbers};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A line of two edges; the first input is the first edge, the second input the whole line.
    /// let edges = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1)])?;
    /// let inputs = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (0, 1, -1), (2, 1, 1)])?;
    /// let winding = WindingNumbers::new(&ChainComplex::new(vec![edges])?, &inputs)?;
    /// let formula = BooleanFormula::parse("b - a", &[])?;
    /// let selection = CellSelection::by_formula(&winding, &formula, InsideRule::Nonzero)?;
    /// assert!(selection.cells().eq([CellId::new(1)]));
    /// # Ok(()) }
    /// ```
    pub fn by_formula(
        winding: &WindingNumbers,
        formula: &BooleanFormula,
        rule: InsideRule,
    ) -> Result<Self, Error> {
        if formula.input_count() > winding.input_count() {
            return Err(Error::invalid(format!(
                "the formula names input {}, but there are {} inputs from 0",
                formula.input_count() - 1,
                winding.input_count()
            )));
        }
        let is_inside = |cell: CellId, input: usize| rule.is_inside(winding.number(cell, input));
        Ok(Self::by_membership(winding.cell_count(), formula, is_inside))
    }

    /// The same where `is_inside` tells whether a cell is inside an input.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::CellId;
    /// use coface_arrange::boolean::{BooleanFormula, CellSelection};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let formula = BooleanFormula::parse("a - b", &[])?;
    /// let selection = CellSelection::by_membership(3, &formula, |cell, input| cell.index() == input);
    /// assert_eq!(selection.cells().collect::<Vec<_>>(), [CellId::new(0)]);
    /// # Ok(()) }
    /// ```
    pub fn by_membership(
        cell_count: usize,
        formula: &BooleanFormula,
        is_inside: impl Fn(CellId, usize) -> bool,
    ) -> Self {
        let mut stack = Vec::new();
        let cells = (0..cell_count)
            .map(|cell| formula.evaluate_on(&mut stack, |input| is_inside(CellId::new(cell), input)))
            .collect();
        Self { cells, exterior: formula.evaluate(|_| false) }
    }

    /// Whether a cell is selected.
    ///
    /// # Panics
    /// If there is no such cell.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::CellId;
    /// use coface_arrange::boolean::CellSelection;
    /// let selection = CellSelection::new(vec![true, false, true], false);
    /// assert!(selection.contains(CellId::new(2)) && !selection.contains(CellId::new(1)));
    /// ```
    pub fn contains(&self, cell: CellId) -> bool {
        self.cells[cell.index()]
    }

    /// Whether the exterior is selected.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::boolean::CellSelection;
    /// let selection = CellSelection::new(vec![true, false, true], false);
    /// assert!(!selection.has_exterior());
    /// ```
    pub fn has_exterior(&self) -> bool {
        self.exterior
    }

    /// The cells that are selected, rising.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::CellId;
    /// use coface_arrange::boolean::CellSelection;
    /// let selection = CellSelection::new(vec![true, false, true], false);
    /// assert!(selection.cells().eq([CellId::new(0), CellId::new(2)]));
    /// ```
    pub fn cells(&self) -> impl Iterator<Item = CellId> + '_ {
        self.cells.iter().enumerate().filter(|(_, is_in)| **is_in).map(|(cell, _)| CellId::new(cell))
    }

    /// The boundary in the arrangement: facets with the selection on one side.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless the complex has the cells of the selection as cells of highest degree, at least one,
    /// each facet once in front of cells and once behind them at most.
    ///
    /// # Complexity
    /// Linear in the boundary matrices, and nearly linear in the boundary.
    ///
    /// # Examples
    /// Of two edges in a row the first: its boundary is its ends.
    /// ```
    /// use coface_algebra::{Sign, SparseMatrix};
    /// use coface_arrange::boolean::CellSelection;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_algebra::CellId;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edges = [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1)];
    /// let complex = ChainComplex::new(vec![SparseMatrix::from_entries(3, 2, edges)?])?;
    /// let boundary = CellSelection::new(vec![true, false], false).boundary(&complex)?;
    /// assert_eq!(boundary.facets(), [(CellId::new(0), Sign::Minus), (CellId::new(1), Sign::Plus)]);
    /// let both = CellSelection::new(vec![true, true], false).boundary(&complex)?;
    /// assert_eq!(both.walls(), [CellId::new(1)]);
    /// # Ok(()) }
    /// ```
    pub fn boundary(&self, complex: &ChainComplex) -> Result<SelectionBoundary, Error> {
        let mut boundary = self.boundary_without_pinches(complex)?;
        boundary.find_pinches(complex, &[], &[]);
        Ok(boundary)
    }

    /// The same with pinches still to be found.
    #[doc(hidden)]
    pub fn boundary_without_pinches(&self, complex: &ChainComplex) -> Result<SelectionBoundary, Error> {
        let degree = complex.degree_count().saturating_sub(1);
        let boundaries = complex.boundary_matrix(degree);
        let Some(boundaries) = boundaries.filter(|matrix| matrix.column_count() == self.cells.len()) else {
            return Err(Error::new(
                ErrorKind::Shape,
                format!(
                    "a selection of {} cells in a complex with {}",
                    self.cells.len(),
                    complex.cell_count(degree)
                ),
            ));
        };
        let is_in = |cell: u32| self.cells.get(cell as usize).copied().unwrap_or(self.exterior);
        let (mut facets, mut walls) = (Vec::new(), Vec::new());
        for (facet, [back, front]) in sides_of_facets(boundaries)?.into_iter().enumerate() {
            let facet = CellId::new(facet);
            match (is_in(back), is_in(front)) {
                (true, false) => facets.push((facet, Sign::Plus)),
                (false, true) => facets.push((facet, Sign::Minus)),
                (true, true) if back != front => walls.push(facet),
                _ => {}
            }
        }
        Ok(SelectionBoundary { facets, walls, pinches: Pinches::default() })
    }
}

impl SelectionBoundary {
    /// Finds the pinches in the complex that this is a boundary in. Slits are facets with ridges that they have on both sides,
    /// points are facets with vertices inside of them that no ridge of them ends at; both rise.
    #[doc(hidden)]
    pub fn find_pinches(&mut self, complex: &ChainComplex, slits: &[(u32, u32)], points: &[(u32, u32)]) {
        self.pinches = Pinches::new(complex, &self.facets, slits, points);
    }

    /// The facets with a selected cell on one side only, with plus where it is behind: a cycle. Rising.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, Sign, SparseMatrix};
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_arrange::boolean::CellSelection;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A line of three edges, of which the first two are selected.
    /// let ends = [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1), (2, 2, -1), (3, 2, 1)];
    /// let line = ChainComplex::new(vec![SparseMatrix::from_entries(4, 3, ends)?])?;
    /// let boundary = CellSelection::new(vec![true, true, false], false).boundary(&line)?;
    /// assert_eq!(boundary.facets(), [(CellId::new(0), Sign::Minus), (CellId::new(2), Sign::Plus)]);
    /// # Ok(()) }
    /// ```
    pub fn facets(&self) -> &[(CellId, Sign)] {
        &self.facets
    }

    /// The facets between two selected cells, rising. A facet with one cell on both sides is not among them.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, SparseMatrix};
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_arrange::boolean::CellSelection;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A line of three edges, of which the first two are selected.
    /// let ends = [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1), (2, 2, -1), (3, 2, 1)];
    /// let line = ChainComplex::new(vec![SparseMatrix::from_entries(4, 3, ends)?])?;
    /// let boundary = CellSelection::new(vec![true, true, false], false).boundary(&line)?;
    /// assert_eq!(boundary.walls(), [CellId::new(1)]);
    /// # Ok(()) }
    /// ```
    pub fn walls(&self) -> &[CellId] {
        &self.walls
    }

    /// The cells of two degrees less than the selection - vertices in the plane, edges in space - with more than two
    /// facets of the boundary, rising.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_arrange::boolean::CellSelection;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A line of three edges, of which the first two are selected.
    /// let ends = [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1), (2, 2, -1), (3, 2, 1)];
    /// let line = ChainComplex::new(vec![SparseMatrix::from_entries(4, 3, ends)?])?;
    /// let boundary = CellSelection::new(vec![true, true, false], false).boundary(&line)?;
    /// assert!(boundary.pinched_ridges().is_empty());
    /// # Ok(()) }
    /// ```
    pub fn pinched_ridges(&self) -> &[CellId] {
        &self.pinches.ridges
    }

    /// The vertices at which the boundary of a selection in space falls apart into several fans of facets, rising. In
    /// the plane these are the pinched ridges.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_arrange::boolean::CellSelection;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A line of three edges, of which the first two are selected.
    /// let ends = [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1), (2, 2, -1), (3, 2, 1)];
    /// let line = ChainComplex::new(vec![SparseMatrix::from_entries(4, 3, ends)?])?;
    /// let boundary = CellSelection::new(vec![true, true, false], false).boundary(&line)?;
    /// assert!(boundary.pinched_vertices().is_empty());
    /// # Ok(()) }
    /// ```
    pub fn pinched_vertices(&self) -> &[CellId] {
        &self.pinches.vertices
    }

    /// Whether the boundary is a closed curve or surface near each of its points.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_arrange::boolean::CellSelection;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A line of three edges, of which the first two are selected.
    /// let ends = [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1), (2, 2, -1), (3, 2, 1)];
    /// let line = ChainComplex::new(vec![SparseMatrix::from_entries(4, 3, ends)?])?;
    /// let boundary = CellSelection::new(vec![true, true, false], false).boundary(&line)?;
    /// assert!(boundary.is_manifold());
    /// # Ok(()) }
    /// ```
    pub fn is_manifold(&self) -> bool {
        self.pinches == Pinches::default()
    }
}
