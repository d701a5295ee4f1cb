//! Named numbers on the vertices, lines, polygons or 3-cells of a model.

use super::GroupKind;
use super::numbers::Numbers;
use crate::{Remark, RemarkCode};
use coface_algebra::{Error, ErrorKind};
use std::ops::Range;

/// A named array of numbers on all vertices, lines, polygons or 3-cells of a [`Model`](super::Model): values of a
/// cocycle, colors, the vertex that a vertex lies over.
///
/// Each cell has the same number of components, one after the other: a row. The numbers are all integers or all reals;
/// they are kept in the width that they have in a file. Reals may be infinite or not a number: files use that for what is
/// not known.
///
/// Two arrays are equal when their names, places and numbers are; widths do not matter, and NaN is equal to NaN.
///
/// # Examples
/// ```
/// use coface_io as io;
/// use coface_io::{CellData, Format, GroupKind};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let triangle = io::read(&b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"[..], Format::Obj)?;
/// let colors = CellData::integers("color", GroupKind::Polygons, 3, vec![255, 128, 0])?;
/// let model = triangle.with_data(colors)?;
/// let mut out = Vec::new();
/// io::write(&model, &mut out, Format::Vtk)?;
/// assert_eq!(io::read(&out[..], Format::Vtk)?.data()[0].integer_row(0), Some(vec![255, 128, 0]));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct CellData {
    name: String,
    kind: GroupKind,
    components: usize,
    numbers: Numbers,
}

impl CellData {
    /// Integers, row after row.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] if the name is empty or there are no components; [`ErrorKind::Shape`] if the numbers
    /// cannot be cut into rows.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{CellData, GroupKind};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let ends = CellData::integers("source", GroupKind::Lines, 2, vec![0, 1, 1, 2])?;
    /// assert_eq!((ends.len(), ends.integer_row(1)), (2, Some(vec![1, 2])));
    /// # Ok(()) }
    /// ```
    pub fn integers(
        name: impl Into<String>,
        kind: GroupKind,
        components: usize,
        values: Vec<i64>,
    ) -> Result<Self, Error> {
        Self::checked(name.into(), kind, components, Numbers::Int64(values))
    }

    /// Reals, row after row.
    ///
    /// # Errors
    /// As those of [`Self::integers`].
    ///
    /// # Examples
    /// ```
    /// use coface_io::{CellData, GroupKind};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let heights = CellData::reals("height", GroupKind::Vertices, 1, vec![0.5, 2.0])?;
    /// assert_eq!((heights.real_row(1), heights.integer_row(1)), (vec![2.0], None));
    /// # Ok(()) }
    /// ```
    pub fn reals(
        name: impl Into<String>,
        kind: GroupKind,
        components: usize,
        values: Vec<f64>,
    ) -> Result<Self, Error> {
        Self::checked(name.into(), kind, components, Numbers::Float64(values))
    }

    /// Numbers from 0 to 255, row after row, such as colors; formats with types keep them in one byte each.
    ///
    /// # Errors
    /// As those of [`Self::integers`].
    ///
    /// # Examples
    /// ```
    /// use coface_io::{CellData, GroupKind};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let red = CellData::bytes("red", GroupKind::Vertices, 1, vec![255, 0])?;
    /// assert_eq!(red.integer_row(0), Some(vec![255]));
    /// # Ok(()) }
    /// ```
    pub fn bytes(
        name: impl Into<String>,
        kind: GroupKind,
        components: usize,
        values: Vec<u8>,
    ) -> Result<Self, Error> {
        Self::checked(name.into(), kind, components, Numbers::UInt8(values))
    }

    fn checked(name: String, kind: GroupKind, components: usize, numbers: Numbers) -> Result<Self, Error> {
        if name.is_empty() {
            return Err(Error::invalid("data without a name").with_cure("name them"));
        }
        if components == 0 {
            return Err(Error::invalid(format!("the data \"{name}\" have no components"))
                .with_cure("give each cell at least one number"));
        }
        if !numbers.len().is_multiple_of(components) {
            let message = format!("{} numbers cannot be cut into rows of {components}", numbers.len());
            return Err(Error::new(ErrorKind::Shape, message)
                .with_cure(format!("give the data \"{name}\" {components} numbers a cell")));
        }
        Ok(Self { name, kind, components, numbers })
    }

    /// What a reader found: a name, and numbers that can be cut into rows.
    pub(crate) fn of_file(name: String, kind: GroupKind, components: usize, numbers: Numbers) -> Self {
        debug_assert!(!name.is_empty() && numbers.len().is_multiple_of(components));
        Self { name, kind, components, numbers }
    }

    /// The name.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{CellData, GroupKind};
    /// let data = CellData::reals("height", GroupKind::Vertices, 1, vec![0.5, 2.0])?;
    /// assert_eq!(data.name(), "height");
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn name(&self) -> &str {
        &self.name
    }

    /// What the numbers are on.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{CellData, GroupKind};
    /// let data = CellData::reals("height", GroupKind::Vertices, 1, vec![0.5, 2.0])?;
    /// assert_eq!(data.kind(), GroupKind::Vertices);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn kind(&self) -> GroupKind {
        self.kind
    }

    /// The number of components of a row.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{CellData, GroupKind};
    /// let data = CellData::reals("height", GroupKind::Vertices, 1, vec![0.5, 2.0])?;
    /// assert_eq!(data.components(), 1);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn components(&self) -> usize {
        self.components
    }

    /// The number of rows: that of vertices, lines, polygons or cells of the model.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{CellData, GroupKind};
    /// let data = CellData::reals("height", GroupKind::Vertices, 1, vec![0.5, 2.0])?;
    /// assert_eq!(data.len(), 2);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn len(&self) -> usize {
        self.numbers.len() / self.components
    }

    /// Whether there are no rows.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{CellData, GroupKind};
    /// let data = CellData::reals("height", GroupKind::Vertices, 1, vec![0.5, 2.0])?;
    /// assert!(!data.is_empty());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Whether the numbers are integers.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{CellData, GroupKind};
    /// let data = CellData::reals("height", GroupKind::Vertices, 1, vec![0.5, 2.0])?;
    /// assert!(!data.is_integral());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn is_integral(&self) -> bool {
        self.numbers.is_integral()
    }

    /// The numbers of one cell if they are integers.
    ///
    /// # Panics
    /// If there is no such row.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{CellData, GroupKind};
    /// let data = CellData::integers("face", GroupKind::Polygons, 2, vec![1, 2, 3, 4])?;
    /// assert_eq!(data.integer_row(1), Some(vec![3, 4]));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn integer_row(&self, cell: usize) -> Option<Vec<i64>> {
        self.row(cell).map(|i| self.numbers.integer(i)).collect()
    }

    /// The numbers of one cell; integers beyond 2^53 are rounded.
    ///
    /// # Panics
    /// If there is no such row.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{CellData, GroupKind};
    /// let data = CellData::reals("height", GroupKind::Vertices, 1, vec![0.5, 2.0])?;
    /// assert_eq!(data.real_row(1), [2.0]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn real_row(&self, cell: usize) -> Vec<f64> {
        self.row(cell).map(|i| self.numbers.real(i)).collect()
    }

    /// The least and the largest of the numbers; NaN is passed over. `None` if there are none.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{CellData, GroupKind};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let values = CellData::reals("x", GroupKind::Lines, 1, vec![2.0, f64::NAN, -1.0])?;
    /// assert_eq!(values.range(), Some([-1.0, 2.0]));
    /// # Ok(()) }
    /// ```
    pub fn range(&self) -> Option<[f64; 2]> {
        let numbers = (0..self.numbers.len()).map(|i| self.numbers.real(i)).filter(|x| !x.is_nan());
        numbers.fold(None, |range, x| match range {
            None => Some([x, x]),
            Some([least, largest]) => Some([least.min(x), largest.max(x)]),
        })
    }

    fn row(&self, cell: usize) -> Range<usize> {
        cell * self.components..(cell + 1) * self.components
    }

    pub(crate) fn numbers(&self) -> &Numbers {
        &self.numbers
    }

    /// The same data on other cells: row i is that of cell `sources[i]` here.
    ///
    /// # Panics
    /// If there is no such row.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{CellData, GroupKind};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let heights = CellData::reals("height", GroupKind::Vertices, 1, vec![0.5, 2.0])?;
    /// assert_eq!(heights.taken_from([1, 1, 0]).real_row(1), [2.0]);
    /// # Ok(()) }
    /// ```
    pub fn taken_from(&self, sources: impl IntoIterator<Item = usize>) -> Self {
        let mut numbers = self.numbers.of_same_type();
        for cell in sources {
            numbers.extend(&self.numbers, self.row(cell));
        }
        Self { name: self.name.clone(), numbers, ..*self }
    }
}

/// The names of arrays as they are read, none twice on one kind of cells.
///
/// The first of a name is kept; what is left out is said.
pub(crate) fn without_repeated_names(data: Vec<CellData>, remarks: &mut Vec<Remark>) -> Vec<CellData> {
    let mut kept: Vec<CellData> = Vec::with_capacity(data.len());
    for array in data {
        if kept.iter().any(|other| other.kind == array.kind && other.name == array.name) {
            remarks.push(Remark::new(
                RemarkCode::DataLeftOut,
                format!(
                    "there are two arrays \"{}\" on {}; the second is left out",
                    array.name.escape_debug(),
                    array.kind
                ),
            ));
        } else {
            kept.push(array);
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_cut_and_faults_named() {
        let data = CellData::reals("height", GroupKind::Vertices, 2, vec![0.0, 1.0, f64::NAN, 2.0]).unwrap();
        assert_eq!((data.len(), data.components(), data.is_integral()), (2, 2, false));
        assert_eq!((data.real_row(0), data.integer_row(0)), (vec![0.0, 1.0], None));
        assert_eq!((data.range(), &data), (Some([0.0, 2.0]), &data.clone()));
        let fault = |name: &str, components| {
            CellData::integers(name, GroupKind::Lines, components, vec![1, 2, 3]).unwrap_err().to_string()
        };
        assert!(fault("", 1).contains("without a name"));
        assert!(fault("a", 0).contains("no components"));
        assert!(fault("a", 2).contains("3 numbers cannot be cut into rows of 2"));
    }
}
