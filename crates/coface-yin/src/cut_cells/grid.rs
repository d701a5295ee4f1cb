//! Rectangular cells in rows and columns.

use coface_algebra::{Error, ErrorKind};

/// The most cells of a grid.
const MOST: usize = 1 << 30;

/// Rectangular cells between vertical and horizontal lines. Column c lies between the vertical lines c and c + 1, row r between the
/// horizontal lines r and r + 1.
///
/// # Examples
/// ```
/// use coface_yin::CartesianGrid;
/// let grid = CartesianGrid::new([-1.0, 0.0], [0.5, 0.25], [4, 2])?;
/// assert_eq!(grid.cell_counts(), [4, 2]);
/// assert_eq!(grid.cell_box(0, 1), [[-1.0, 0.25], [-0.5, 0.5]]);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct CartesianGrid {
    lines: [Vec<f64>; 2],
}

impl CartesianGrid {
    /// Cells of one size: the lines are the origin and multiples of the spacing from it, rounded.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] for no cells, numbers that are not finite, and spacings that are not positive or too small for the
    /// origin; [`ErrorKind::TooLarge`] above 2^30 cells.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::CartesianGrid;
    /// let grid = CartesianGrid::new([0.0, 0.0], [1.0, 0.5], [2, 4])?;
    /// assert_eq!(grid.cell_box(1, 3), [[1.0, 1.5], [2.0, 2.0]]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn new(origin: [f64; 2], spacing: [f64; 2], counts: [usize; 2]) -> Result<Self, Error> {
        check_counts(counts)?;
        for axis in 0..2 {
            if !(spacing[axis] > 0.0 && spacing[axis].is_finite() && origin[axis].is_finite()) {
                return Err(Error::invalid(format!(
                    "cells of size {} from {} make no grid along axis {axis}",
                    spacing[axis], origin[axis]
                ))
                .with_cure("give finite numbers, the size positive"));
            }
        }
        let line = |axis: usize| {
            (0..=counts[axis]).map(move |at| origin[axis] + at as f64 * spacing[axis]).collect()
        };
        Self::with_lines([line(0), line(1)])
    }

    /// Cells between given lines: the first coordinates of the vertical ones, the second coordinates of the horizontal ones.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] naming a line that is not finite or not beyond the one before it, and for fewer than two lines;
    /// [`ErrorKind::TooLarge`] above 2^30 cells.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::CartesianGrid;
    /// let grid = CartesianGrid::with_lines([vec![0.0, 1.0, 4.0], vec![0.0, 2.0]])?;
    /// assert_eq!(grid.cell_box(1, 0), [[1.0, 0.0], [4.0, 2.0]]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn with_lines(lines: [Vec<f64>; 2]) -> Result<Self, Error> {
        check_counts([0, 1].map(|axis| lines[axis].len().saturating_sub(1)))?;
        for (axis, own) in lines.iter().enumerate() {
            if let Some(at) = own.iter().position(|x| !x.is_finite()) {
                return Err(Error::invalid(format!("line {at} across axis {axis} is not finite"))
                    .with_cure("give finite coordinates"));
            }
            if let Some(at) = own.windows(2).position(|pair| pair[0] >= pair[1]) {
                return Err(Error::invalid(format!(
                    "line {} across axis {axis} is not beyond line {at}",
                    at + 1
                ))
                .with_cure("give lines that rise, further apart than numbers of their size can tell"));
            }
        }
        Ok(Self { lines })
    }

    /// The numbers of columns and rows.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::CartesianGrid;
    /// let grid = CartesianGrid::new([0.0, 0.0], [1.0, 0.5], [2, 4])?;
    /// assert_eq!(grid.cell_counts(), [2, 4]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn cell_counts(&self) -> [usize; 2] {
        [0, 1].map(|axis| self.lines[axis].len() - 1)
    }

    /// The lines across an axis, 0 for the vertical ones.
    ///
    /// # Panics
    /// If the axis is not 0 or 1.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::CartesianGrid;
    /// let grid = CartesianGrid::new([0.0, 0.0], [1.0, 0.5], [2, 4])?;
    /// assert_eq!(grid.lines(0), [0.0, 1.0, 2.0]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn lines(&self, axis: usize) -> &[f64] {
        &self.lines[axis]
    }

    /// The least and the greatest coordinates of a cell.
    ///
    /// # Panics
    /// If there is no such cell.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::CartesianGrid;
    /// let grid = CartesianGrid::new([0.0, 0.0], [1.0, 0.5], [2, 4])?;
    /// assert_eq!(grid.cell_box(0, 1), [[0.0, 0.5], [1.0, 1.0]]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn cell_box(&self, column: usize, row: usize) -> [[f64; 2]; 2] {
        [0, 1].map(|step| [self.lines[0][column + step], self.lines[1][row + step]])
    }

    /// The column or row that lies before a coordinate: the coordinate may be at its end. -1 before the first line.
    pub(super) fn before(&self, axis: usize, x: f64) -> i64 {
        self.lines[axis].partition_point(|&line| line < x) as i64 - 1
    }

    /// The column or row that lies after a coordinate: the coordinate may be at its beginning. -1 before the first line.
    pub(super) fn after(&self, axis: usize, x: f64) -> i64 {
        self.lines[axis].partition_point(|&line| line <= x) as i64 - 1
    }
}

fn check_counts(counts: [usize; 2]) -> Result<(), Error> {
    if counts.contains(&0) {
        return Err(Error::invalid(format!(
            "a grid of {} columns and {} rows has no cells",
            counts[0], counts[1]
        ))
        .with_cure("give at least one column and one row"));
    }
    match counts[0].checked_mul(counts[1]) {
        Some(count) if count <= MOST => Ok(()),
        _ => Err(Error::new(ErrorKind::TooLarge, format!("a grid of {} by {} cells", counts[0], counts[1]))
            .with_cure("take at most 2^30 cells")),
    }
}
