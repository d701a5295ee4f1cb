//! What can go wrong.

use std::fmt;

/// A fault in a request or in the C library.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Error {
    /// Columns, rows or factors do not fit together.
    Shape(String),
    /// Numbers or counts that the representation does not hold.
    TooLarge(String),
    /// A function of the library failed with this code, as `GrB_Info` in its header.
    Library {
        /// The name of the function.
        function: &'static str,
        /// Its result.
        code: i32,
    },
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Shape(message) | Self::TooLarge(message) => f.write_str(message),
            Self::Library { function, code } => {
                let meaning = match code {
                    -6 => "dimensions do not match",
                    -102 => "out of memory",
                    -101 => "unknown fault",
                    -105 => "an index is out of bounds",
                    _ => "see GrB_Info in GraphBLAS.h",
                };
                write!(f, "{function} of GraphBLAS failed with code {code}: {meaning}")
            }
        }
    }
}

impl std::error::Error for Error {}
