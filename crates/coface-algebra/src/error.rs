//! The one error of the library: what went wrong, where, and what to do about it.
//!
//! An [`Error`] has two readers. A person reads its message, which names the place, the fault and the cure. A program
//! matches on its [`ErrorKind`] and, where the fault is about cells or numbers, on its typed [`Fault`].

use crate::escapes::escaped;
use crate::ids::{CellId, FaceId, VertexId};
use std::fmt;

/// The kind of an [`Error`]; stable for matching, while messages may be reworded.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum ErrorKind {
    /// A file or stream could not be opened, read or written.
    Io,
    /// The text or bytes break the rules of their format.
    Parse,
    /// The format is unknown, or this part of it is not supported.
    UnsupportedFormat,
    /// The data is readable but cannot be what is asked for (an index out of range, a face with a repeated vertex).
    InvalidInput,
    /// A simplex, cell or vertex that was named does not exist.
    NotInComplex,
    /// A set of cells that had to be closed under faces is not.
    NotAComplex,
    /// A complex that had to be pure is not.
    NotPure,
    /// The boundary of a boundary is not zero.
    BoundaryOfBoundary,
    /// A chain that had to be a cycle has a boundary.
    NotACycle,
    /// Matrices or chains of shapes that do not fit together.
    Shape,
    /// More cells, or larger numbers, than the representation holds.
    TooLarge,
    /// A surface operation met an edge or vertex that no surface has.
    NonManifold,
    /// A coefficient that must be invertible is not, or two coefficients come from different rings.
    Coefficient,
}

impl ErrorKind {
    /// The kind as a word for programs: `io`, `parse`, `unsupported_format`, `invalid_input`, `not_in_complex`,
    /// `not_a_complex`, `not_pure`, `boundary_of_boundary`, `not_a_cycle`, `shape`, `too_large`, `non_manifold`,
    /// `coefficient`.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_algebra::ErrorKind::UnsupportedFormat.word(), "unsupported_format");
    /// ```
    pub const fn word(self) -> &'static str {
        match self {
            Self::Io => "io",
            Self::Parse => "parse",
            Self::UnsupportedFormat => "unsupported_format",
            Self::InvalidInput => "invalid_input",
            Self::NotInComplex => "not_in_complex",
            Self::NotAComplex => "not_a_complex",
            Self::NotPure => "not_pure",
            Self::BoundaryOfBoundary => "boundary_of_boundary",
            Self::NotACycle => "not_a_cycle",
            Self::Shape => "shape",
            Self::TooLarge => "too_large",
            Self::NonManifold => "non_manifold",
            Self::Coefficient => "coefficient",
        }
    }
}

/// The cells and numbers that a fault is about, for programs that act on them.
///
/// Faults of files have no variant here: their place is [`Error::file`], [`Error::line`] and [`Error::byte`].
///
/// # Examples
/// ```
/// use coface_algebra::{Error, ErrorKind, FaceId, Fault, VertexId};
/// let faces = [0, 3, 7].map(FaceId::new).to_vec();
/// let fault = Fault::EdgeInFaces { edge: [4, 9].map(VertexId::new), faces };
/// let error = Error::new(ErrorKind::NonManifold, "edge {v4, v9} lies in 3 faces").with_fault(fault);
/// let Some(Fault::EdgeInFaces { faces, .. }) = error.fault() else { panic!("the fault is an edge") };
/// assert_eq!(faces.len(), 3);
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Fault {
    /// An edge lies in a number of faces that no surface allows: in none, or in three or more.
    EdgeInFaces {
        /// The ends of the edge.
        edge: [VertexId; 2],
        /// The faces around the edge; a face that runs along it twice is listed twice.
        faces: Vec<FaceId>,
    },
    /// Two faces run along an edge in the same direction, so their orientations do not agree.
    IncoherentFaces {
        /// The source and the target of the edge, in the direction of both faces.
        edge: [VertexId; 2],
        /// The two faces; they are equal if one face runs along the edge twice.
        faces: [FaceId; 2],
    },
    /// The faces at a vertex form several fans that share the vertex only.
    VertexWithFans {
        /// The vertex.
        vertex: VertexId,
        /// The faces of each fan.
        fans: Vec<Vec<FaceId>>,
    },
    /// A closed chain of faces cannot be oriented coherently: it is a Moebius band.
    OddCycle {
        /// The faces of the chain, each next to the one before; the last one is next to the first.
        faces: Vec<FaceId>,
    },
    /// A set of cells has a cell without one of its faces.
    MissingFace {
        /// The degree of the cell.
        degree: usize,
        /// The cell.
        cell: CellId,
        /// The missing face, of one degree less.
        face: CellId,
    },
    /// The boundary of the boundary of a cell is not zero.
    BoundaryNotCycle {
        /// The degree of the cell.
        degree: usize,
        /// The cell.
        cell: CellId,
    },
    /// A number names a thing that does not exist.
    OutOfRange {
        /// The number.
        index: usize,
        /// How many such things there are: numbers from 0 to `count - 1` are valid.
        count: usize,
    },
    /// A matrix does not have the shape that its place asks for.
    Shape {
        /// The rows and columns of the matrix.
        found: [usize; 2],
        /// The rows and columns that would fit; `None` where any number does.
        expected: [Option<usize>; 2],
    },
    /// A list does not have the length that its place asks for.
    Length {
        /// The length of the list.
        found: usize,
        /// The length that would fit.
        expected: usize,
    },
}

impl Fault {
    /// The fault with other numbers for the vertices.
    fn with_vertices(mut self, number: &impl Fn(u32) -> u32) -> Self {
        match &mut self {
            Self::EdgeInFaces { edge, .. } | Self::IncoherentFaces { edge, .. } => {
                *edge = edge.map(|vertex| VertexId::from_u32(number(vertex.to_u32())));
            }
            Self::VertexWithFans { vertex, .. } => *vertex = VertexId::from_u32(number(vertex.to_u32())),
            _ => {}
        }
        self
    }
}

/// Where in a file a fault was found.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
struct Place {
    file: Option<String>,
    line: Option<u64>,
    byte: Option<u64>,
}

/// A fault in data or in a request: it names the place, the fault and the cure.
///
/// It is shown in one line, whatever the names of files and objects in it are: as by [`escaped`].
///
/// # Examples
/// ```
/// use coface_algebra::{Error, ErrorKind};
/// let error = Error::new(ErrorKind::Parse, "\"abc\" is not a coordinate")
///     .at_line(12)
///     .in_file("cube.off")
///     .with_cure("write a decimal number");
/// assert_eq!(error.to_string(), "cube.off:12: \"abc\" is not a coordinate; write a decimal number");
/// assert_eq!(error.kind(), ErrorKind::Parse);
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Error(Box<Inner>);

#[derive(Clone, Debug, PartialEq, Eq)]
struct Inner {
    kind: ErrorKind,
    message: String,
    place: Place,
    cure: Option<String>,
    cells: Vec<Vec<u32>>,
    fault: Option<Fault>,
}

impl Error {
    /// An error of this kind. The message says what is wrong, in lower case and without a full stop.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{Error, ErrorKind};
    /// let error = Error::new(ErrorKind::TooLarge, "there are 2^40 cells");
    /// assert_eq!(error.to_string(), "there are 2^40 cells");
    /// ```
    pub fn new(kind: ErrorKind, message: impl Into<String>) -> Self {
        Self(Box::new(Inner {
            kind,
            message: message.into(),
            place: Place::default(),
            cure: None,
            cells: Vec::new(),
            fault: None,
        }))
    }

    /// A fault in the text or bytes of a file.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{Error, ErrorKind};
    /// assert_eq!(Error::parse("the file ends in a number").kind(), ErrorKind::Parse);
    /// ```
    pub fn parse(message: impl Into<String>) -> Self {
        Self::new(ErrorKind::Parse, message)
    }

    /// Readable data that cannot be what is asked for.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{Error, ErrorKind};
    /// assert_eq!(Error::invalid("a face repeats a vertex").kind(), ErrorKind::InvalidInput);
    /// ```
    pub fn invalid(message: impl Into<String>) -> Self {
        Self::new(ErrorKind::InvalidInput, message)
    }

    /// The same error with its cure: what to do about the fault.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Error;
    /// let error = Error::invalid("there are no faces").with_cure("add a face");
    /// assert_eq!(error.to_string(), "there are no faces; add a face");
    /// ```
    #[must_use]
    pub fn with_cure(mut self, cure: impl Into<String>) -> Self {
        self.0.cure = Some(cure.into());
        self
    }

    /// The same error with the cells at fault, each by the numbers of its vertices; a cell without vertices by its own
    /// number.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{Error, ErrorKind};
    /// let error = Error::new(ErrorKind::NonManifold, "the edge {v4 v9} lies in three faces").with_cells([[4, 9]]);
    /// assert_eq!(error.cells(), [[4, 9]]);
    /// ```
    #[must_use]
    pub fn with_cells<L: Into<Vec<u32>>>(mut self, cells: impl IntoIterator<Item = L>) -> Self {
        self.0.cells = cells.into_iter().map(Into::into).collect();
        self
    }

    /// The same error with the cells and numbers of its fault as typed data.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{Error, ErrorKind, Fault};
    /// let error = Error::new(ErrorKind::Shape, "row 7 of a matrix of 3 rows");
    /// let error = error.with_fault(Fault::OutOfRange { index: 7, count: 3 });
    /// assert_eq!(error.fault(), Some(&Fault::OutOfRange { index: 7, count: 3 }));
    /// ```
    #[must_use]
    pub fn with_fault(mut self, fault: Fault) -> Self {
        self.0.fault = Some(fault);
        self
    }

    /// The same error with other numbers for the vertices of its cells and of its fault; the message stays.
    #[doc(hidden)]
    #[must_use]
    pub fn with_vertex_numbers(mut self, number: impl Fn(u32) -> u32) -> Self {
        self.0.cells.iter_mut().flatten().for_each(|vertex| *vertex = number(*vertex));
        self.0.fault = self.0.fault.map(|fault| fault.with_vertices(&number));
        self
    }

    /// The same error at a line of a text file, counted from 1. A line that is set already is kept.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Error;
    /// assert_eq!(Error::parse("a number is missing").at_line(3).to_string(), "line 3: a number is missing");
    /// ```
    #[must_use]
    pub fn at_line(mut self, line: u64) -> Self {
        self.0.place.line.get_or_insert(line);
        self
    }

    /// The same error at a byte of a binary file, counted from 0. A byte that is set already is kept.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Error;
    /// assert_eq!(Error::parse("the data ends").at_byte(84).to_string(), "at byte 84: the data ends");
    /// ```
    #[must_use]
    pub fn at_byte(mut self, byte: u64) -> Self {
        self.0.place.byte.get_or_insert(byte);
        self
    }

    /// The same error in the file of this name. A file that is set already is kept.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Error;
    /// assert_eq!(Error::parse("the file is empty").in_file("a.off").to_string(), "a.off: the file is empty");
    /// ```
    #[must_use]
    pub fn in_file(mut self, file: impl Into<String>) -> Self {
        self.0.place.file.get_or_insert_with(|| file.into());
        self
    }

    /// Whether memory was asked for that there is not.
    ///
    /// # Examples
    /// ```
    /// let error = coface_algebra::Error::from(std::io::Error::from(std::io::ErrorKind::OutOfMemory));
    /// assert!(error.is_out_of_memory() && error.in_file("a.off").is_out_of_memory());
    /// assert!(!coface_algebra::Error::parse("the file is empty").is_out_of_memory());
    /// ```
    pub fn is_out_of_memory(&self) -> bool {
        self.0.kind == ErrorKind::TooLarge && self.0.message == OUT_OF_MEMORY
    }

    /// The kind of the fault.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{ErrorKind, RaggedArray};
    /// let error = RaggedArray::uniform(3, vec![0, 1]).unwrap_err();
    /// assert_eq!(error.kind(), ErrorKind::Shape);
    /// ```
    pub fn kind(&self) -> ErrorKind {
        self.0.kind
    }

    /// The message alone, without place and cure.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Error;
    /// let error = Error::parse("a number is missing").at_line(3).with_cure("add it");
    /// assert_eq!(error.message(), "a number is missing");
    /// ```
    pub fn message(&self) -> &str {
        &self.0.message
    }

    /// The cure: what to do about the fault.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Error;
    /// assert_eq!(Error::invalid("there are no faces").with_cure("add a face").cure(), Some("add a face"));
    /// ```
    pub fn cure(&self) -> Option<&str> {
        self.0.cure.as_deref()
    }

    /// The cells at fault, each by the numbers of its vertices, so that a program can show them; empty if no cells are
    /// at fault.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Error;
    /// assert_eq!(Error::invalid("triangle 2 is flat").with_cells([[0, 1, 4]]).cells(), [[0, 1, 4]]);
    /// ```
    pub fn cells(&self) -> &[Vec<u32>] {
        &self.0.cells
    }

    /// The cells and numbers of the fault as typed data, for a program that acts on them; `None` where the fault has
    /// none.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{Fault, SparseMatrix};
    /// let error = SparseMatrix::from_entries(2, 1, [(5, 0, 1)]).unwrap_err();
    /// assert_eq!(error.fault(), Some(&Fault::OutOfRange { index: 5, count: 2 }));
    /// ```
    pub fn fault(&self) -> Option<&Fault> {
        self.0.fault.as_ref()
    }

    /// The file of the fault.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Error;
    /// assert_eq!(Error::parse("the file is empty").in_file("a.off").file(), Some("a.off"));
    /// ```
    pub fn file(&self) -> Option<&str> {
        self.0.place.file.as_deref()
    }

    /// The line of the fault, counted from 1.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Error;
    /// assert_eq!(Error::parse("a number is missing").at_line(3).line(), Some(3));
    /// ```
    pub fn line(&self) -> Option<u64> {
        self.0.place.line
    }

    /// The byte of the fault, counted from 0.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Error;
    /// assert_eq!(Error::parse("the data ends").at_byte(84).byte(), Some(84));
    /// ```
    pub fn byte(&self) -> Option<u64> {
        self.0.place.byte
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Place { file, line, byte } = &self.0.place;
        let file = file.as_deref().map(escaped);
        match (file, line) {
            (Some(file), Some(line)) => write!(f, "{file}:{line}: ")?,
            (Some(file), None) => write!(f, "{file}: ")?,
            (None, Some(line)) => write!(f, "line {line}: ")?,
            (None, None) => {}
        }
        if let (None, Some(byte)) = (line, byte) {
            write!(f, "at byte {byte}: ")?;
        }
        f.write_str(&escaped(&self.0.message))?;
        if let Some(cure) = &self.0.cure {
            write!(f, "; {}", escaped(cure))?;
        }
        Ok(())
    }
}

impl std::error::Error for Error {}

/// What is said where memory is asked for that there is not.
const OUT_OF_MEMORY: &str = "there is not enough memory";

impl From<std::io::Error> for Error {
    fn from(error: std::io::Error) -> Self {
        match error.kind() {
            std::io::ErrorKind::OutOfMemory => {
                Self::new(ErrorKind::TooLarge, OUT_OF_MEMORY).with_cure("allow more memory")
            }
            std::io::ErrorKind::NotFound => {
                Self::new(ErrorKind::Io, "there is no such file or folder").with_cure("check the path")
            }
            _ => Self::new(ErrorKind::Io, error.to_string()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_place_is_kept() {
        let error = Error::parse("bad").at_line(3).at_line(9).in_file("a").in_file("b");
        assert_eq!((error.line(), error.file()), (Some(3), Some("a")));
    }

    #[test]
    fn vertices_of_cells_and_fault_are_renumbered_together() {
        let error = Error::new(ErrorKind::NonManifold, "two fans meet at vertex v1")
            .with_cells([[1]])
            .with_fault(Fault::VertexWithFans {
                vertex: VertexId::new(1),
                fans: vec![vec![FaceId::new(1)]; 2],
            })
            .with_vertex_numbers(|vertex| vertex + 10);
        assert_eq!(error.cells(), [[11]]);
        let fans = vec![vec![FaceId::new(1)]; 2];
        assert_eq!(error.fault(), Some(&Fault::VertexWithFans { vertex: VertexId::new(11), fans }));
    }

    #[test]
    fn names_of_strangers_stay_in_one_line() {
        let error = Error::invalid("no object \"a\x1b[2J\"")
            .with_cure("name b\nc")
            .in_file("x\ny\u{202e}.off")
            .at_line(2);
        assert_eq!(error.to_string(), "x\\ny\\u{202e}.off:2: no object \"a\\u{1b}[2J\"; name b\\nc");
        assert_eq!(error.file(), Some("x\ny\u{202e}.off"));
    }

    #[test]
    fn a_byte_is_named_when_there_is_no_line() {
        let error = Error::parse("the data ends").at_byte(84).in_file("x.stl");
        assert_eq!(error.to_string(), "x.stl: at byte 84: the data ends");
    }
}
