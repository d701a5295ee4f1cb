//! Names of operators between cells: pairs of degrees.

use coface_algebra::{Error, ErrorKind};
use std::fmt;
use std::str::FromStr;

/// The letters of degrees 0, 1, 2, 3: vertices, edges, faces, cells.
const LETTERS: [char; 4] = ['V', 'E', 'F', 'C'];

/// An operator between the cells of two degrees: its rows are the cells of one, its columns those of the other.
///
/// As a map it goes from chains of cells of the columns to chains of cells of the rows. It is written as two of the letters
/// V, E, F, C for vertices, edges, faces and 3-cells, rows first, or as two degrees with a colon between them.
///
/// # Examples
/// ```
/// use coface_complexes::lar::Operator;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let operator: Operator = "FE".parse()?;
/// assert_eq!((operator.rows(), operator.columns()), (2, 1));
/// assert_eq!(operator.transposed().to_string(), "EF");
/// assert_eq!("4:3".parse::<Operator>()?, Operator::new(4, 3));
/// assert!("FX".parse::<Operator>().is_err());
/// # Ok(()) }
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Operator {
    rows: usize,
    columns: usize,
}

impl Operator {
    /// The operator whose rows and columns are the cells of these degrees.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::lar::Operator;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let faces_on_vertices = Operator::new(2, 0);
    /// assert!(!faces_on_vertices.is_square());
    /// # Ok(()) }
    /// ```
    pub fn new(rows: usize, columns: usize) -> Self {
        Self { rows, columns }
    }

    /// The degree of the cells that are rows.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::lar::Operator;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let faces_on_vertices = Operator::new(2, 0);
    /// assert_eq!(faces_on_vertices.rows(), 2);
    /// # Ok(()) }
    /// ```
    pub fn rows(self) -> usize {
        self.rows
    }

    /// The degree of the cells that are columns.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::lar::Operator;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let faces_on_vertices = Operator::new(2, 0);
    /// assert_eq!(faces_on_vertices.columns(), 0);
    /// # Ok(()) }
    /// ```
    pub fn columns(self) -> usize {
        self.columns
    }

    /// The operator with rows and columns exchanged.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::lar::Operator;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let faces_on_vertices = Operator::new(2, 0);
    /// assert_eq!(faces_on_vertices.transposed().rows(), 0);
    /// # Ok(()) }
    /// ```
    #[must_use]
    pub fn transposed(self) -> Self {
        Self { rows: self.columns, columns: self.rows }
    }

    /// Whether rows and columns are the same cells.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::lar::Operator;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let faces_on_vertices = Operator::new(2, 0);
    /// assert!(Operator::new(1, 1).is_square() && !faces_on_vertices.is_square());
    /// # Ok(()) }
    /// ```
    pub fn is_square(self) -> bool {
        self.rows == self.columns
    }
}

impl FromStr for Operator {
    type Err = Error;

    /// # Errors
    /// [`ErrorKind::Parse`] for anything but two letters or two degrees with a colon between them.
    fn from_str(text: &str) -> Result<Self, Error> {
        let degree = |letter: char| LETTERS.iter().position(|&l| l == letter.to_ascii_uppercase());
        let mut letters = text.chars();
        if let (Some(rows), Some(columns), None) = (letters.next(), letters.next(), letters.next())
            && let (Some(rows), Some(columns)) = (degree(rows), degree(columns))
        {
            return Ok(Self { rows, columns });
        }
        if let Some((rows, columns)) = text.split_once(':')
            && let (Ok(rows), Ok(columns)) = (rows.parse::<u16>(), columns.parse::<u16>())
        {
            return Ok(Self::new(rows.into(), columns.into()));
        }
        Err(Error::new(ErrorKind::Parse, format!("{text:?} is not an operator")).with_cure(
            "write two of the letters V, E, F, C, rows first, as in FE; or two degrees, as in 4:3",
        ))
    }
}

impl fmt::Display for Operator {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (LETTERS.get(self.rows), LETTERS.get(self.columns)) {
            (Some(rows), Some(columns)) => write!(f, "{rows}{columns}"),
            _ => write!(f, "{}:{}", self.rows, self.columns),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sixteen_names_and_the_numbers_are_read_back() {
        for rows in 0..6 {
            for columns in 0..6 {
                let operator = Operator::new(rows, columns);
                assert_eq!(operator.to_string().parse::<Operator>().unwrap(), operator);
                assert_eq!(operator.to_string().to_lowercase().parse::<Operator>().unwrap(), operator);
                assert_eq!(operator.to_string().len(), if rows < 4 && columns < 4 { 2 } else { 3 });
            }
        }
    }

    #[test]
    fn other_texts_are_refused() {
        for text in ["", "F", "FEV", "fx", "1:", ":2", "1:2:3", "-1:2", "70000:1", "F:E", "\u{c9}F"] {
            let error = text.parse::<Operator>().unwrap_err();
            assert_eq!(error.kind(), ErrorKind::Parse, "{text}");
        }
    }
}
