//! The result of matrix arithmetic: entries of 32 bits if they suffice, of any size if not.

use crate::error::Error;
use crate::matrices::sparse_matrix::{SparseMatrix, WideMatrix};

/// A sparse integer matrix with 32-bit entries if they suffice, and with integers of any size if not.
///
/// # Examples
/// ```
/// use coface_algebra::SparseMatrix;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let matrix = SparseMatrix::from_entries(1, 1, [(0, 0, 2_000_000_000)])?;
/// let double = matrix.sum(&matrix)?;
/// assert!(double.as_narrow().is_none());
/// assert_eq!(double.to_wide().difference(&matrix)?.into_narrow()?, matrix);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum IntegerMatrix {
    /// All entries fit in 32 bits.
    Narrow(SparseMatrix),
    /// At least one entry does not.
    Wide(WideMatrix),
}

impl IntegerMatrix {
    /// The matrix with 32-bit entries, if it is one.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{IntegerMatrix, SparseMatrix};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let identity = SparseMatrix::identity(2)?;
    /// assert_eq!(IntegerMatrix::from(identity.clone()).as_narrow(), Some(&identity));
    /// # Ok(()) }
    /// ```
    pub fn as_narrow(&self) -> Option<&SparseMatrix> {
        match self {
            Self::Narrow(matrix) => Some(matrix),
            Self::Wide(_) => None,
        }
    }

    /// The matrix with 32-bit entries.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`](crate::error::ErrorKind::TooLarge) naming the first entry beyond 32 bits.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let identity = SparseMatrix::identity(2)?;
    /// assert_eq!(identity.product(&identity)?.into_narrow()?, identity);
    /// # Ok(()) }
    /// ```
    pub fn into_narrow(self) -> Result<SparseMatrix, Error> {
        match self {
            Self::Narrow(matrix) => Ok(matrix),
            Self::Wide(matrix) => matrix.to_narrow(),
        }
    }

    /// The matrix with entries of any size.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let double = SparseMatrix::identity(2)?.scaled(&2.into());
    /// assert_eq!(double.into_wide().entry(1, 1), 2.into());
    /// # Ok(()) }
    /// ```
    pub fn into_wide(self) -> WideMatrix {
        match self {
            Self::Narrow(matrix) => matrix.to_wide(),
            Self::Wide(matrix) => matrix,
        }
    }

    /// A copy of the matrix with entries of any size.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{IntegerMatrix, SparseMatrix};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let matrix = IntegerMatrix::from(SparseMatrix::identity(3)?);
    /// assert_eq!(matrix.to_wide().entry_count(), 3);
    /// # Ok(()) }
    /// ```
    pub fn to_wide(&self) -> WideMatrix {
        match self {
            Self::Narrow(matrix) => matrix.to_wide(),
            Self::Wide(matrix) => matrix.clone(),
        }
    }

    /// Whether every entry is zero.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let identity = SparseMatrix::identity(2)?;
    /// assert!(identity.difference(&identity)?.is_zero());
    /// # Ok(()) }
    /// ```
    pub fn is_zero(&self) -> bool {
        match self {
            Self::Narrow(matrix) => matrix.is_zero(),
            Self::Wide(matrix) => matrix.is_zero(),
        }
    }
}

impl From<WideMatrix> for IntegerMatrix {
    fn from(matrix: WideMatrix) -> Self {
        match matrix.to_narrow() {
            Ok(narrow) => Self::Narrow(narrow),
            Err(_) => Self::Wide(matrix),
        }
    }
}

impl From<SparseMatrix> for IntegerMatrix {
    fn from(matrix: SparseMatrix) -> Self {
        Self::Narrow(matrix)
    }
}
