//! A set cut at the lines of a grid.

use super::PlanarSet;
use crate::answer::{CoverageAnswer, CutCellAnswer, GridAnswer, YinCutCellsAnswer};
use coface_algebra::Error;
use coface_yin::{CartesianGrid, Coverage, CutCells};

/// The grid that a set is cut at.
///
/// # Examples
/// ```
/// let request = coface_answers::CutCellsRequest::new([4, 2]).origin(Some([0.0, 0.0])).spacing(None);
/// assert_eq!((request.counts, request.origin), ([4, 2], Some([0.0, 0.0])));
/// ```
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct CutCellsRequest {
    /// The numbers of columns and of rows.
    pub counts: [usize; 2],
    /// The lower left corner of the grid; that of the box around the set if none is given.
    pub origin: Option<[f64; 2]>,
    /// The width and the height of cells; such that the grid covers the box around the set if none are given.
    pub spacing: Option<[f64; 2]>,
}

impl CutCellsRequest {
    /// A grid of so many columns and rows over the box around the set.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::CutCellsRequest;
    /// assert_eq!(CutCellsRequest::new([4, 2]).counts, [4, 2]);
    /// ```
    pub fn new(counts: [usize; 2]) -> Self {
        Self { counts, origin: None, spacing: None }
    }

    /// The same with this lower left corner.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::CutCellsRequest;
    /// assert_eq!(CutCellsRequest::new([4, 2]).origin(Some([1.0, 0.0])).origin, Some([1.0, 0.0]));
    /// ```
    #[must_use]
    pub fn origin(mut self, origin: Option<[f64; 2]>) -> Self {
        self.origin = origin;
        self
    }

    /// The same with cells of this width and height.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::CutCellsRequest;
    /// assert_eq!(CutCellsRequest::new([4, 2]).spacing(Some([0.5, 0.5])).spacing, Some([0.5, 0.5]));
    /// ```
    #[must_use]
    pub fn spacing(mut self, spacing: Option<[f64; 2]>) -> Self {
        self.spacing = spacing;
        self
    }

    /// The grid, of a boundary with this box around it.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::CutCellsRequest;
    /// let grid = CutCellsRequest::new([4, 2]).over(Some([[0.0, 0.0], [2.0, 2.0]]));
    /// assert_eq!((grid.origin, grid.spacing), ([0.0, 0.0], [0.5, 1.0]));
    /// ```
    pub fn over(&self, around: Option<[[f64; 2]; 2]>) -> GridAnswer {
        let [low, high] = around.unwrap_or([[0.0; 2], [1.0; 2]]);
        let origin = self.origin.unwrap_or(low);
        let spacing = self.spacing.unwrap_or_else(|| {
            [0, 1].map(|axis| {
                let extent = high[axis] - origin[axis];
                if extent > 0.0 { extent / self.counts[axis] as f64 } else { 1.0 }
            })
        });
        GridAnswer { origin, spacing, counts: self.counts }
    }
}

impl PlanarSet {
    /// Cuts the set at the lines of a grid; the answer lists the cells that have some of the set or of its boundary.
    ///
    /// # Errors
    /// Those of [`CartesianGrid::new`], [`CutCells::new`] and [`Self::answer`].
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{CutCellsRequest, PlanarSet, SetRequest};
    /// use coface_io::{Format, ReadOptions, read_boundary};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = b"POLYGON ((0 0, 4 0, 0 4, 0 0))";
    /// let triangle = PlanarSet::of(&read_boundary(&text[..], Format::Wkt, &ReadOptions::default())?, &SetRequest::default())?;
    /// let answer = triangle.cut_cells("triangle", &CutCellsRequest::new([2, 2]))?;
    /// assert_eq!((answer.full, answer.cut, answer.empty, answer.area), (1, 2, 1, 8.0));
    /// # Ok(()) }
    /// ```
    pub fn cut_cells(&self, file: &str, request: &CutCellsRequest) -> Result<YinCutCellsAnswer, Error> {
        let grid = request.over(self.bounding_box());
        let cells = CutCells::new(self.set(), CartesianGrid::new(grid.origin, grid.spacing, grid.counts)?)
            .map_err(|error| error.in_file(file))?;
        let set = self.answer()?;
        Ok(YinCutCellsAnswer {
            file: file.to_owned(),
            full: cells.count(Coverage::Full),
            cut: cells.count(Coverage::Cut),
            empty: cells.count(Coverage::Empty),
            area: cells.total_area(),
            length: cells.total_length(),
            area_of_set: set.area,
            perimeter_of_set: set.perimeter,
            cells: Some(listed(&cells, grid.counts)),
            grid,
            remarks: set.remarks,
        })
    }
}

/// The cells that have something, row by row.
pub(super) fn listed(cells: &CutCells<'_>, [columns, rows]: [usize; 2]) -> Vec<CutCellAnswer> {
    let places = (0..rows).flat_map(|row| (0..columns).map(move |column| (column, row)));
    let answer = |(column, row): (usize, usize)| {
        let cell = cells.cell(column, row);
        let coverage = match cells.coverage(column, row) {
            Coverage::Full => CoverageAnswer::Full,
            Coverage::Cut => CoverageAnswer::Cut,
            Coverage::Empty if cell.is_none() => return None,
            Coverage::Empty => CoverageAnswer::Empty,
        };
        let length = cell.map_or(0.0, |cell| cell.length());
        Some(CutCellAnswer { column, row, coverage, area: cells.area(column, row), length })
    };
    places.filter_map(answer).collect()
}
