//! What is wrong with a model, and where.

use coface_algebra::RaggedArray;
use std::fmt;

/// What sort of fault a [`Problem`] is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum ProblemKind {
    /// A facet of the top cells (an edge of a surface, a face of a volume) that lies in more than two of them.
    NonManifoldRidge,
    /// An edge of a volume around which its cells form no single fan or ring.
    NonManifoldEdge,
    /// A vertex whose neighborhood is no disk, half disk, ball or half ball: several fans meet there.
    NonManifoldVertex,
    /// A ridge across which the two top cells run against each other although another choice would agree.
    OrientationConflict,
    /// A closed chain of top cells along which the orientation comes back reversed.
    OneSidedChain,
    /// A cell that the file has more than once.
    DuplicateCell,
    /// A vertex that nothing uses.
    IsolatedVertex,
    /// A cell of lower dimension that is no face of a top cell.
    LooseCell,
}

impl ProblemKind {
    /// The word for programs.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_answers::ProblemKind::IsolatedVertex.word(), "isolated_vertex");
    /// ```
    pub fn word(self) -> &'static str {
        match self {
            Self::NonManifoldRidge => "nonmanifold_ridge",
            Self::NonManifoldEdge => "nonmanifold_edge",
            Self::NonManifoldVertex => "nonmanifold_vertex",
            Self::OrientationConflict => "orientation_conflict",
            Self::OneSidedChain => "one_sided_chain",
            Self::DuplicateCell => "duplicate_cell",
            Self::IsolatedVertex => "isolated_vertex",
            Self::LooseCell => "loose_cell",
        }
    }
}

impl fmt::Display for ProblemKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.word())
    }
}

/// One sort of fault with all the places where it is.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Problem {
    kind: ProblemKind,
    message: String,
    cells: RaggedArray,
    tops: RaggedArray,
    top_name: &'static str,
}

impl Problem {
    /// A problem at these cells, each by its vertices. The list `i` of `tops` are the top cells that make cell `i` a
    /// problem, or it is empty; `top_name` says what they are: `"face"`, `"cell"`.
    pub(crate) fn new(
        kind: ProblemKind,
        message: String,
        cells: RaggedArray,
        tops: RaggedArray,
        top_name: &'static str,
    ) -> Self {
        Self { kind, message, cells, tops, top_name }
    }

    /// A problem at these vertices.
    pub(crate) fn at_vertices(kind: ProblemKind, message: String, vertices: &[u32]) -> Self {
        let cells = RaggedArray::from_lists(vertices.iter().map(|&vertex| [vertex]));
        Self::new(kind, message, cells, RaggedArray::new(), "face")
    }

    /// What sort of fault it is.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let model = coface_io::read(&b"OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n5 5 5\n3 0 1 2\n"[..], coface_io::Format::Off)?;
    /// let report = coface_answers::Report::of(model)?;
    /// assert_eq!(report.problems()[0].kind(), coface_answers::ProblemKind::IsolatedVertex);
    /// # Ok(()) }
    /// ```
    pub fn kind(&self) -> ProblemKind {
        self.kind
    }

    /// One sentence that says how many places have it and what it means.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let model = coface_io::read(&b"OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n5 5 5\n3 0 1 2\n"[..], coface_io::Format::Off)?;
    /// let report = coface_answers::Report::of(model)?;
    /// assert_eq!(report.problems()[0].message(), "1 vertex is isolated: in no edge");
    /// # Ok(()) }
    /// ```
    pub fn message(&self) -> &str {
        &self.message
    }

    /// In how many places it is.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let model = coface_io::read(&b"OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n5 5 5\n3 0 1 2\n"[..], coface_io::Format::Off)?;
    /// let report = coface_answers::Report::of(model)?;
    /// assert_eq!(report.problems()[0].count(), 1);
    /// # Ok(()) }
    /// ```
    pub fn count(&self) -> usize {
        self.cells.len()
    }

    /// The cells that have it, each by its vertices.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let model = coface_io::read(&b"OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n5 5 5\n3 0 1 2\n"[..], coface_io::Format::Off)?;
    /// let report = coface_answers::Report::of(model)?;
    /// assert_eq!(report.problems()[0].cells().list(0), [3]);
    /// # Ok(()) }
    /// ```
    pub fn cells(&self) -> &RaggedArray {
        &self.cells
    }

    /// For each of the [`Self::cells`] the numbers of the top cells of the file that meet there; empty lists, or no
    /// list, when that says nothing.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let model = coface_io::read(&b"OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n5 5 5\n3 0 1 2\n"[..], coface_io::Format::Off)?;
    /// let report = coface_answers::Report::of(model)?;
    /// assert!(report.problems()[0].tops().is_empty());
    /// # Ok(()) }
    /// ```
    pub fn tops(&self) -> &RaggedArray {
        &self.tops
    }

    /// What the top cells are called: `"face"`, `"cell"`.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let model = coface_io::read(&b"OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n5 5 5\n3 0 1 2\n"[..], coface_io::Format::Off)?;
    /// let report = coface_answers::Report::of(model)?;
    /// assert_eq!(report.problems()[0].top_name(), "face");
    /// # Ok(()) }
    /// ```
    pub fn top_name(&self) -> &'static str {
        self.top_name
    }
}
