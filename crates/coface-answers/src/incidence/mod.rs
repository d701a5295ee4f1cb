//! Operators between the cells of a model: shared vertices, adjacency, incidence, boundaries.
//!
//! [`OperatorRequest`] names the [`Operator`] and the [`OperatorKind`] of its entries; [`FoundOperator`] has them and
//! makes the [`IncidenceAnswer`].

use crate::Producer;
use crate::answer::IncidenceAnswer;
use coface_algebra::chains::ChainComplex;
use coface_algebra::{Error, RaggedArray, SparseMatrix};
use coface_complexes::lar::{LarModel, Operator, Shared};
use std::collections::BTreeMap;

/// What the entries of an operator are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OperatorKind {
    /// The numbers of vertices that two cells share.
    Counts,
    /// 1 where two cells share so many vertices.
    Shared(Shared),
    /// 1 where one cell is a face of the other, or two of one degree are adjacent.
    Incident,
    /// The signs of boundaries.
    Signed,
}

impl OperatorKind {
    /// The word of the answer.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_answers::OperatorKind::Signed.name(), "signed");
    /// ```
    pub fn name(self) -> &'static str {
        match self {
            Self::Counts => "shared vertices",
            Self::Shared(Shared::AtLeast(_)) => "at least",
            Self::Shared(_) => "exactly",
            Self::Incident => "incident",
            Self::Signed => "signed",
        }
    }
}

/// Asks for an operator between the cells of a model.
///
/// # Examples
/// The coboundary of the one edge of a model: minus its start plus its end.
/// ```
/// use coface_answers::{OperatorKind, OperatorRequest, Producer};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let edge = Producer::of(coface_io::read(&b"[[3,8]]"[..], coface_io::Format::Json)?)?;
/// let request = OperatorRequest::new("EV".parse()?, OperatorKind::Signed).entries(true);
/// let answer = request.found(&edge)?.answer("edge.json");
/// assert_eq!((answer.rows, answer.columns), (1, 2));
/// assert_eq!(answer.entries, Some(vec![(0, 0, -1), (0, 1, 1)]));
/// # Ok(()) }
/// ```
#[derive(Clone, Copy, Debug)]
pub struct OperatorRequest {
    operator: Operator,
    kind: OperatorKind,
    has_entries: bool,
}

impl OperatorRequest {
    /// Asks for the counts of the entries of an operator.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{OperatorKind, OperatorRequest, Producer};
    /// let edge = Producer::of(coface_io::read(&b"[[3,8]]"[..], coface_io::Format::Json)?)?;
    /// let request = OperatorRequest::new("EV".parse()?, OperatorKind::Signed);
    /// assert_eq!(request.found(&edge)?.answer("edge.json").rows, 1);
    /// # Ok(()) }
    /// ```
    pub fn new(operator: Operator, kind: OperatorKind) -> Self {
        Self { operator, kind, has_entries: false }
    }

    /// Whether the entries themselves are wanted.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{OperatorKind, OperatorRequest, Producer};
    /// let edge = Producer::of(coface_io::read(&b"[[3,8]]"[..], coface_io::Format::Json)?)?;
    /// let request = OperatorRequest::new("EV".parse()?, OperatorKind::Signed);
    /// assert_eq!(request.entries(true).found(&edge)?.answer("edge.json").entries, Some(vec![(0, 0, -1), (0, 1, 1)]));
    /// # Ok(()) }
    /// ```
    pub fn entries(mut self, has_entries: bool) -> Self {
        self.has_entries = has_entries;
        self
    }

    /// Finds the operator of a model.
    ///
    /// # Errors
    /// Those of [`Producer::lar_model`] and [`Producer::chain_complex`];
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if signs are asked for and the degrees are no
    /// neighbors.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{OperatorKind, OperatorRequest, Producer};
    /// let edge = Producer::of(coface_io::read(&b"[[3,8]]"[..], coface_io::Format::Json)?)?;
    /// let request = OperatorRequest::new("EV".parse()?, OperatorKind::Signed);
    /// assert_eq!(request.found(&edge)?.answer("edge.json").columns, 2);
    /// # Ok(()) }
    /// ```
    pub fn found(&self, producer: &Producer) -> Result<FoundOperator, Error> {
        let (operator, kind) = (self.operator, self.kind);
        let found = |[rows, columns]: [usize; 2], by_rows: SparseMatrix| {
            let mut histogram = BTreeMap::new();
            for &entry in by_rows.entries() {
                *histogram.entry(i64::from(entry)).or_default() += 1;
            }
            FoundOperator { request: *self, rows, columns, histogram, by_rows: Some(by_rows) }
        };
        if kind == OperatorKind::Signed {
            let complex = producer.chain_complex()?;
            let counts = [operator.rows(), operator.columns()].map(|degree| complex.cell_count(degree));
            return Ok(found(counts, signed(&complex, operator)?));
        }
        let model = producer.lar_model()?;
        let [rows, columns] = [operator.rows(), operator.columns()].map(|degree| model.cell_count(degree));
        if kind == OperatorKind::Counts && !self.has_entries {
            // Counting alone stores no matrix.
            let counts = (0i64..).zip(model.counts(operator));
            let histogram = counts.filter(|&(entry, times)| entry > 0 && times > 0).collect();
            return Ok(FoundOperator { request: *self, rows, columns, histogram, by_rows: None });
        }
        let by_rows = match kind {
            OperatorKind::Shared(shared) => pattern(&model, operator, &model.related(operator, shared)?)?,
            OperatorKind::Incident => pattern(&model, operator, &model.incident(operator)?)?,
            OperatorKind::Counts | OperatorKind::Signed => model.shared_vertices(operator.transposed())?,
        };
        Ok(found([rows, columns], by_rows))
    }
}

/// An operator between the cells of a model.
#[derive(Clone, Debug)]
pub struct FoundOperator {
    request: OperatorRequest,
    rows: usize,
    columns: usize,
    /// How often each entry occurs.
    histogram: BTreeMap<i64, u64>,
    /// The transpose, where it was made.
    by_rows: Option<SparseMatrix>,
}

impl FoundOperator {
    /// How often each entry occurs that is not zero.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{OperatorKind, OperatorRequest, Producer};
    /// let edge = Producer::of(coface_io::read(&b"[[3,8]]"[..], coface_io::Format::Json)?)?;
    /// let request = OperatorRequest::new("EV".parse()?, OperatorKind::Signed);
    /// assert_eq!(request.found(&edge)?.histogram().iter().collect::<Vec<_>>(), [(&-1, &1), (&1, &1)]);
    /// # Ok(()) }
    /// ```
    pub fn histogram(&self) -> &BTreeMap<i64, u64> {
        &self.histogram
    }

    /// The transpose of the operator, whose column j is row j; `None` where only counts were asked for.
    pub fn by_rows(&self) -> Option<&SparseMatrix> {
        self.by_rows.as_ref()
    }

    /// The answer as plain data, with this name of the input; with the entries if they were asked for.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{OperatorKind, OperatorRequest, Producer};
    /// let edge = Producer::of(coface_io::read(&b"[[3,8]]"[..], coface_io::Format::Json)?)?;
    /// let request = OperatorRequest::new("EV".parse()?, OperatorKind::Signed);
    /// assert_eq!(request.found(&edge)?.answer("edge.json").file, "edge.json");
    /// # Ok(()) }
    /// ```
    pub fn answer(&self, file: &str) -> IncidenceAnswer {
        let entries = |by_rows: &SparseMatrix| {
            let mut list = Vec::with_capacity(by_rows.entries().len());
            for (row, entries) in by_rows.columns().enumerate() {
                list.extend(entries.iter().map(|(column, x)| (row, column, i64::from(x))));
            }
            list
        };
        let by_rows = self.by_rows.as_ref().filter(|_| self.request.has_entries);
        IncidenceAnswer { entries: by_rows.map(entries), ..self.counts(file) }
    }

    /// The same without the entries, for those that write them one by one.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{OperatorKind, OperatorRequest, Producer};
    /// let edge = Producer::of(coface_io::read(&b"[[3,8]]"[..], coface_io::Format::Json)?)?;
    /// let request = OperatorRequest::new("EV".parse()?, OperatorKind::Signed);
    /// assert_eq!(request.entries(true).found(&edge)?.counts("edge.json").entries, None);
    /// # Ok(()) }
    /// ```
    pub fn counts(&self, file: &str) -> IncidenceAnswer {
        IncidenceAnswer {
            file: file.to_owned(),
            operator: self.request.operator.to_string(),
            kind: self.request.kind.name().to_owned(),
            rows: self.rows,
            columns: self.columns,
            entries_count: self.histogram.values().sum(),
            histogram: self.histogram.iter().map(|(entry, &times)| (entry.to_string(), times)).collect(),
            entries: None,
            remarks: Vec::new(),
        }
    }
}

/// The matrix with an entry 1 for each item, list j as column j.
fn pattern(model: &LarModel, operator: Operator, lists: &RaggedArray) -> Result<SparseMatrix, Error> {
    let starts = (0..=lists.len()).map(|row| lists.start(row) as u32).collect();
    let ones = vec![1; lists.item_count()];
    SparseMatrix::from_parts(model.cell_count(operator.columns()), starts, lists.items().to_vec(), ones)
}

/// The boundary or coboundary operator, transposed.
fn signed(complex: &ChainComplex, operator: Operator) -> Result<SparseMatrix, Error> {
    let (rows, columns) = (operator.rows(), operator.columns());
    if rows.abs_diff(columns) != 1 {
        return Err(Error::invalid(format!("{operator} is no boundary or coboundary operator"))
            .with_cure("signs are those of neighboring degrees: EV, FE, CF and VE, EF, FC"));
    }
    match complex.boundary_matrix(rows.max(columns)) {
        // A coboundary matrix has the boundary of each row's cell in the row.
        Some(boundary) if rows > columns => Ok(boundary.clone()),
        Some(boundary) => Ok(boundary.transpose()),
        None => SparseMatrix::zero(complex.cell_count(columns), complex.cell_count(rows)),
    }
}
