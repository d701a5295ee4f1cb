//! What of a set lies in each cell of a grid.

use super::arcs::arcs_of;
use super::integrals::Integrals;
use super::{CartesianGrid, CutArc};
use crate::YinSet;
use coface_algebra::progress::stage;
use coface_algebra::{Error, ErrorKind};
use coface_geometry::Sum;

/// How much of a cell belongs to a set.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Coverage {
    /// Nothing.
    Empty,
    /// All, up to boundary along its sides.
    Full,
    /// A part; the boundary runs through the cell.
    Cut,
}

/// A cell that has a part of the boundary of a set.
#[derive(Clone, Debug, PartialEq)]
pub struct CutCell {
    column: u32,
    row: u32,
    area: f64,
    length: f64,
    coverage: Coverage,
    /// Its arcs among those of all cells.
    pub(super) arcs: [u32; 2],
    /// Whether the set is around the closed curves in a cell that no chain comes into.
    pub(super) is_inside: bool,
}

impl CutCell {
    /// The column.
    ///
    /// # Examples
    /// A triangle on four unit squares.
    /// ```
    /// use coface_yin::{CartesianGrid, Curve, CutCells, YinSet};
    /// let triangle = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [0.0, 2.0], [0.0, 0.0]])?])?;
    /// let cells = CutCells::new(&triangle, CartesianGrid::new([0.0, 0.0], [1.0, 1.0], [2, 2])?)?;
    /// assert_eq!(cells.cell(1, 0).map(|cell| cell.column()), Some(1));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn column(&self) -> usize {
        self.column as usize
    }

    /// The row.
    ///
    /// # Examples
    /// A triangle on four unit squares.
    /// ```
    /// use coface_yin::{CartesianGrid, Curve, CutCells, YinSet};
    /// let triangle = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [0.0, 2.0], [0.0, 0.0]])?])?;
    /// let cells = CutCells::new(&triangle, CartesianGrid::new([0.0, 0.0], [1.0, 1.0], [2, 2])?)?;
    /// assert_eq!(cells.cell(1, 0).map(|cell| cell.row()), Some(0));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn row(&self) -> usize {
        self.row as usize
    }

    /// The area of what of the set is in the cell.
    ///
    /// # Examples
    /// A triangle on four unit squares.
    /// ```
    /// use coface_yin::{CartesianGrid, Curve, CutCells, YinSet};
    /// let triangle = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [0.0, 2.0], [0.0, 0.0]])?])?;
    /// let cells = CutCells::new(&triangle, CartesianGrid::new([0.0, 0.0], [1.0, 1.0], [2, 2])?)?;
    /// assert_eq!(cells.cell(1, 0).map(|cell| cell.area()), Some(0.5));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn area(&self) -> f64 {
        self.area
    }

    /// The length of the boundary in the cell; what runs along a line of the grid counts on its left.
    pub fn length(&self) -> f64 {
        self.length
    }

    /// How much of the cell belongs to the set.
    ///
    /// # Examples
    /// A triangle on four unit squares.
    /// ```
    /// use coface_yin::{CartesianGrid, Coverage, Curve, CutCells, YinSet};
    /// let triangle = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [0.0, 2.0], [0.0, 0.0]])?])?;
    /// let cells = CutCells::new(&triangle, CartesianGrid::new([0.0, 0.0], [1.0, 1.0], [2, 2])?)?;
    /// assert_eq!(cells.cell(1, 0).map(|cell| cell.coverage()), Some(Coverage::Cut));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn coverage(&self) -> Coverage {
        self.coverage
    }
}

/// A Yin set on a Cartesian grid: the coverage of all cells, and area, arcs and walks of those that have boundary.
///
/// # Examples
/// A triangle on four unit squares.
/// ```
/// use coface_yin::{CartesianGrid, Coverage, Curve, CutCells, YinSet};
/// let triangle = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [0.0, 2.0], [0.0, 0.0]])?])?;
/// let cells = CutCells::new(&triangle, CartesianGrid::new([0.0, 0.0], [1.0, 1.0], [2, 2])?)?;
/// assert_eq!(cells.coverage(0, 0), Coverage::Full);
/// assert_eq!(cells.coverage(1, 1), Coverage::Empty);
/// assert_eq!((cells.area(0, 0), cells.area(1, 0), cells.area(0, 1), cells.area(1, 1)), (1.0, 0.5, 0.5, 0.0));
/// assert_eq!(cells.total_area(), 2.0);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct CutCells<'a> {
    pub(super) set: &'a YinSet,
    grid: CartesianGrid,
    /// By cell, row by row; those of one cell in the order of the curves.
    pub(super) arcs: Vec<CutArc>,
    cells: Vec<CutCell>,
    coverage: Vec<Coverage>,
}

impl<'a> CutCells<'a> {
    /// Cuts a set at the lines of a grid. What is outside of the grid is left out.
    ///
    /// Where the straight pieces of a boundary run is decided exactly; where others cross lines is found to the last digits.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] for coordinates whose products leave the range of numbers, and above 2^32 arcs.
    ///
    /// # Complexity
    /// $O(c + n \log c + k \log k)$ time for c cells, n pieces and k arcs; one byte a cell, and 80 bytes an arc.
    ///
    /// # Examples
    /// A triangle on four unit squares.
    /// ```
    /// use coface_yin::{CartesianGrid, Curve, CutCells, YinSet};
    /// let triangle = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [0.0, 2.0], [0.0, 0.0]])?])?;
    /// let cells = CutCells::new(&triangle, CartesianGrid::new([0.0, 0.0], [1.0, 1.0], [2, 2])?)?;
    /// assert_eq!(cells.total_area(), 2.0);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn new(set: &'a YinSet, grid: CartesianGrid) -> Result<Self, Error> {
        check_size(set, &grid)?;
        let mut arcs = arcs_of(set, &grid);
        if u32::try_from(arcs.len()).is_err() {
            return Err(Error::new(ErrorKind::TooLarge, format!("{} arcs in cells", arcs.len()))
                .with_cure("cut parts of the set one by one, or take a coarser grid"));
        }
        arcs.sort_by_key(|arc| (arc.cell[1], arc.cell[0]));
        let [columns, rows] = grid.cell_counts();
        let mut found =
            Self { set, grid, arcs, cells: Vec::new(), coverage: Vec::with_capacity(columns * rows) };
        let integrals = Integrals::new(set.order().degree());
        let mut first = 0;
        let steps = stage("cutting rows of cells", rows);
        for row in 0..rows {
            steps.advance(1);
            let count = found.arcs[first..].partition_point(|arc| arc.cell[1] as usize <= row);
            found.sweep(row, [first, first + count], &integrals);
            first += count;
        }
        Ok(found)
    }

    /// Goes through a row from left to right, with the arcs that belong to it.
    fn sweep(&mut self, row: usize, [mut first, end]: [usize; 2], integrals: &Integrals) {
        let columns = self.grid.cell_counts()[0];
        let [low, high] = [self.grid.lines(1)[row], self.grid.lines(1)[row + 1]];
        let mut winding = i64::from(!self.set.is_bounded());
        let base = winding;
        // How far the boundary left of here rises in all.
        let mut rise = Sum::default();
        for column in -1..columns as i32 {
            let begin = first;
            while first < end && self.arcs[first].cell[0] == column {
                first += 1;
            }
            let own = &self.arcs[begin..first];
            if own.is_empty() {
                if column >= 0 {
                    // All of the boundary on the left goes through the row from side to side.
                    rise = Sum::default();
                    rise.add((base - winding) as f64 * (high - low));
                    self.coverage.push(if winding == 0 { Coverage::Empty } else { Coverage::Full });
                }
                continue;
            }
            let before = winding;
            winding -= own.iter().map(|arc| i64::from(arc.rise)).sum::<i64>();
            if column >= 0 {
                let [[left, _], [right, _]] = self.grid.cell_box(column as usize, row);
                let mut area = Sum::default();
                area.add((right - left) * (base as f64 * (high - low) - rise.value()));
                let mut length = Sum::default();
                for arc in own {
                    let controls = arc.controls(self.set);
                    area.add(-integrals.left_of(right, &controls));
                    length.add(integrals.length(&controls));
                }
                let is_full = own.iter().all(|arc| {
                    let [a, b] = arc.ends;
                    let on = |axis: usize, lines: [f64; 2]| a[axis] == b[axis] && lines.contains(&a[axis]);
                    on(0, [left, right]) || on(1, [low, high])
                });
                let all = (right - left) * (high - low);
                let coverage = if is_full { Coverage::Full } else { Coverage::Cut };
                self.coverage.push(coverage);
                self.cells.push(CutCell {
                    column: column as u32,
                    row: row as u32,
                    area: if is_full { all } else { area.value().clamp(0.0, all) },
                    length: length.value(),
                    coverage,
                    arcs: [begin as u32, first as u32],
                    is_inside: before != 0,
                });
            }
            own.iter().for_each(|arc| rise.add(arc.ends[1][1] - arc.ends[0][1]));
        }
    }

    /// The grid.
    ///
    /// # Examples
    /// A triangle on four unit squares.
    /// ```
    /// use coface_yin::{CartesianGrid, Curve, CutCells, YinSet};
    /// let triangle = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [0.0, 2.0], [0.0, 0.0]])?])?;
    /// let cells = CutCells::new(&triangle, CartesianGrid::new([0.0, 0.0], [1.0, 1.0], [2, 2])?)?;
    /// assert_eq!(cells.grid().cell_counts(), [2, 2]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn grid(&self) -> &CartesianGrid {
        &self.grid
    }

    /// How much of a cell belongs to the set.
    ///
    /// # Panics
    /// If there is no such cell.
    ///
    /// # Examples
    /// A triangle on four unit squares.
    /// ```
    /// use coface_yin::{CartesianGrid, Coverage, Curve, CutCells, YinSet};
    /// let triangle = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [0.0, 2.0], [0.0, 0.0]])?])?;
    /// let cells = CutCells::new(&triangle, CartesianGrid::new([0.0, 0.0], [1.0, 1.0], [2, 2])?)?;
    /// assert_eq!(cells.coverage(1, 1), Coverage::Empty);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn coverage(&self, column: usize, row: usize) -> Coverage {
        let [columns, _] = self.grid.cell_counts();
        assert!(column < columns, "there are {columns} columns");
        self.coverage[row * columns + column]
    }

    /// The coverage of all cells, row by row.
    ///
    /// # Examples
    /// A triangle on four unit squares.
    /// ```
    /// use coface_yin::{CartesianGrid, Coverage, Curve, CutCells, YinSet};
    /// let triangle = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [0.0, 2.0], [0.0, 0.0]])?])?;
    /// let cells = CutCells::new(&triangle, CartesianGrid::new([0.0, 0.0], [1.0, 1.0], [2, 2])?)?;
    /// assert_eq!(cells.coverages()[0], Coverage::Full);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn coverages(&self) -> &[Coverage] {
        &self.coverage
    }

    /// The cells that have boundary, row by row.
    pub fn cells(&self) -> &[CutCell] {
        &self.cells
    }

    /// A cell, if it has boundary.
    ///
    /// # Examples
    /// A triangle on four unit squares.
    /// ```
    /// use coface_yin::{CartesianGrid, Curve, CutCells, YinSet};
    /// let triangle = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [0.0, 2.0], [0.0, 0.0]])?])?;
    /// let cells = CutCells::new(&triangle, CartesianGrid::new([0.0, 0.0], [1.0, 1.0], [2, 2])?)?;
    /// assert!(cells.cell(1, 0).is_some() && cells.cell(1, 1).is_none());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn cell(&self, column: usize, row: usize) -> Option<&CutCell> {
        let at = self.cells.binary_search_by_key(&(row, column), |cell| (cell.row(), cell.column())).ok()?;
        Some(&self.cells[at])
    }

    /// The arcs of a cell in the order of the curves.
    pub fn arcs(&self, cell: &CutCell) -> &[CutArc] {
        let [first, end] = cell.arcs;
        &self.arcs[first as usize..end as usize]
    }

    /// The curve, the piece and the length of each arc in the grid.
    #[doc(hidden)]
    pub fn arc_lengths(&self) -> Vec<(usize, usize, f64)> {
        let integrals = Integrals::new(self.set.order().degree());
        let arcs = self.cells.iter().flat_map(|cell| self.arcs(cell));
        arcs.map(|arc| (arc.curve(), arc.piece(), integrals.length(&arc.controls(self.set)))).collect()
    }

    /// The area of what of the set is in a cell.
    ///
    /// # Panics
    /// If there is no such cell.
    ///
    /// # Examples
    /// A triangle on four unit squares.
    /// ```
    /// use coface_yin::{CartesianGrid, Curve, CutCells, YinSet};
    /// let triangle = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [0.0, 2.0], [0.0, 0.0]])?])?;
    /// let cells = CutCells::new(&triangle, CartesianGrid::new([0.0, 0.0], [1.0, 1.0], [2, 2])?)?;
    /// assert_eq!([cells.area(0, 0), cells.area(1, 0), cells.area(1, 1)], [1.0, 0.5, 0.0]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn area(&self, column: usize, row: usize) -> f64 {
        if let Some(cell) = self.cell(column, row) {
            return cell.area;
        }
        let [low, high] = self.grid.cell_box(column, row);
        match self.coverage(column, row) {
            Coverage::Empty => 0.0,
            _ => (high[0] - low[0]) * (high[1] - low[1]),
        }
    }

    /// The area of the set in the grid: the sum over all cells.
    ///
    /// # Complexity
    /// $O(c)$ for c cells.
    ///
    /// # Examples
    /// A triangle on four unit squares.
    /// ```
    /// use coface_yin::{CartesianGrid, Curve, CutCells, YinSet};
    /// let triangle = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [0.0, 2.0], [0.0, 0.0]])?])?;
    /// let cells = CutCells::new(&triangle, CartesianGrid::new([0.0, 0.0], [1.0, 1.0], [2, 2])?)?;
    /// assert_eq!(cells.total_area(), 2.0);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn total_area(&self) -> f64 {
        let [columns, _] = self.grid.cell_counts();
        let mut sum = Sum::default();
        let mut cells = self.cells.iter().peekable();
        for (row, coverages) in self.coverage.chunks_exact(columns).enumerate() {
            for (column, coverage) in coverages.iter().enumerate() {
                if let Some(cell) = cells.next_if(|cell| (cell.row(), cell.column()) == (row, column)) {
                    sum.add(cell.area);
                } else if *coverage == Coverage::Full {
                    let [low, high] = self.grid.cell_box(column, row);
                    sum.add((high[0] - low[0]) * (high[1] - low[1]));
                }
            }
        }
        sum.value()
    }

    /// The length of the boundary in the grid: the sum over all cells.
    pub fn total_length(&self) -> f64 {
        let mut sum = Sum::default();
        self.cells.iter().for_each(|cell| sum.add(cell.length));
        sum.value()
    }

    /// The number of cells of a coverage.
    ///
    /// # Examples
    /// A triangle on four unit squares.
    /// ```
    /// use coface_yin::{CartesianGrid, Coverage, Curve, CutCells, YinSet};
    /// let triangle = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [0.0, 2.0], [0.0, 0.0]])?])?;
    /// let cells = CutCells::new(&triangle, CartesianGrid::new([0.0, 0.0], [1.0, 1.0], [2, 2])?)?;
    /// assert_eq!(cells.count(Coverage::Empty), 1);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn count(&self, coverage: Coverage) -> usize {
        self.coverage.iter().filter(|&&own| own == coverage).count()
    }
}

fn check_size(set: &YinSet, grid: &CartesianGrid) -> Result<(), Error> {
    const MOST: f64 = 1e140;
    let is_small = |points: &[f64]| points.iter().all(|x| x.abs() < MOST);
    let are_lines_small = (0..2).all(|axis| is_small(grid.lines(axis)));
    if are_lines_small && (0..set.curve_count()).all(|own| is_small(set.curve(own).controls().as_flattened()))
    {
        return Ok(());
    }
    Err(Error::new(ErrorKind::TooLarge, "coordinates from 1e140 have no areas that are numbers".to_owned())
        .with_cure("scale the set and the grid"))
}
