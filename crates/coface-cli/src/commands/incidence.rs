//! `coface incidence`: operators between the cells of a model.

use crate::arguments::Common;
use crate::failure::Failure;
use crate::input;
use crate::output::{is_json, print_bytes, print_text};
use crate::progress::Progress;
use clap::Args;
use coface::algebra::chains::ChainComplex;
use coface::algebra::{RaggedArray, SparseMatrix};
use coface::answers::Producer;
use coface::answers::answer::{IncidenceAnswer, to_json};
use coface::answers::text;
use coface::complexes::lar::{LarModel, Operator, Shared};
use coface::io::matrix_market;
use coface::io::matrix_market::MatrixField;
use coface::io::replace_file;
use std::collections::BTreeMap;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Operators between cells: shared vertices, adjacency, incidence, boundaries.
///
/// An operator is named by two of the letters V, E, F, C for vertices, edges, faces and 3-cells: the rows of FE are faces,
/// its columns edges. Degrees beyond 3 are written as 4:3. Cells are numbered as in the chain complex of the model.
///
/// Without an option that says otherwise an entry is the number of vertices that two cells share, and for VV the number of
/// edges between two vertices, on the diagonal at one. Such counts are not incidence: an edge whose ends lie on a face that
/// is not convex need not be an edge of it. --incident gives incidence by the faces and edges of the model itself.
///
/// The file named by -o is a matrix in Matrix Market form if its name ends in .mtx, or the object of --json with entries if it
/// ends in .json.
#[derive(Args)]
pub(crate) struct Incidence {
    /// The model; - is standard input
    #[arg(value_name = "INPUT")]
    input: PathBuf,
    /// Rows and columns: VV, VE, VF, VC, EV, EE, EF, EC, FV, FE, FF, FC, CV, CE, CF, CC, or two degrees as in 4:3
    #[arg(long, value_name = "ROWS COLUMNS", value_parser = operator)]
    operator: Operator,
    /// Only which cells share at least N vertices, 1 each; none with itself
    #[arg(long, value_name = "N", group = "kind", value_parser = clap::value_parser!(u32).range(1..))]
    at_least: Option<u32>,
    /// Only which cells share exactly N vertices, 1 each; none with itself
    #[arg(long, value_name = "N", group = "kind", value_parser = clap::value_parser!(u32).range(1..))]
    exactly: Option<u32>,
    /// Which cells are faces of others; for cells of one degree which share a facet, for vertices which an edge joins
    #[arg(long, group = "kind")]
    incident: bool,
    /// The signs of boundaries: EV, FE and CF are coboundary operators, VE, EF and FC boundary operators
    #[arg(long, group = "kind")]
    signed: bool,
    /// List the entries in JSON: [row, column, entry] by rows, counted from 0
    #[arg(long)]
    entries: bool,
}

fn operator(name: &str) -> Result<Operator, String> {
    name.parse().map_err(|error: coface::Error| error.to_string())
}

/// What entries of an operator are.
#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Counts,
    Shared(Shared),
    Incident,
    Signed,
}

impl Kind {
    fn name(self) -> &'static str {
        match self {
            Self::Counts => "shared vertices",
            Self::Shared(Shared::AtLeast(_)) => "at least",
            Self::Shared(_) => "exactly",
            Self::Incident => "incident",
            Self::Signed => "signed",
        }
    }

    fn field(self) -> MatrixField {
        match self {
            Self::Counts | Self::Signed => MatrixField::Integer,
            Self::Shared(_) | Self::Incident => MatrixField::Pattern,
        }
    }
}

/// An operator as it is shown and written.
struct Shown {
    file: String,
    operator: Operator,
    kind: Kind,
    rows: usize,
    columns: usize,
    /// How often each entry stands there.
    histogram: BTreeMap<i64, u64>,
    /// The entries, if they are asked for: column j is row j of the operator.
    by_rows: Option<SparseMatrix>,
}

impl Incidence {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        let output = common.output.as_deref().map(Output::of).transpose()?;
        let progress = Progress::start(common.quiet);
        let (file, producer) = input::produce(&self.input, common.reading(), &progress)?;
        progress.stage("relating cells");
        let needs_entries = output.is_some() || (common.json && self.entries);
        let shown =
            self.shown(file.clone(), &producer, needs_entries).map_err(|error| error.in_file(file))?;
        progress.stage("writing");
        match output {
            Some(Output::Matrix(path)) => replace_file(path, |out| {
                let by_rows = shown.by_rows.as_ref().map(SparseMatrix::transpose);
                by_rows.map_or(Ok(()), |matrix| matrix_market::write(&matrix, shown.kind.field(), out))
            })?,
            Some(Output::Json(path)) => replace_file(path, |out| Ok(shown.write_json(true, out)?))?,
            None => {}
        }
        drop(progress);
        match (common.json, output) {
            (true, _) => print_bytes(|out| shown.write_json(self.entries, out)),
            (false, Some(_)) => Ok(()),
            (false, None) => print_text(&shown.page()),
        }
    }

    fn kind(&self) -> Kind {
        match (self.at_least, self.exactly) {
            (Some(n), _) => Kind::Shared(Shared::AtLeast(n)),
            (_, Some(n)) => Kind::Shared(Shared::Exactly(n)),
            _ if self.incident => Kind::Incident,
            _ if self.signed => Kind::Signed,
            _ => Kind::Counts,
        }
    }

    fn shown(&self, file: String, producer: &Producer, needs_entries: bool) -> Result<Shown, coface::Error> {
        let (operator, kind) = (self.operator, self.kind());
        let mut shown =
            Shown { file, operator, kind, rows: 0, columns: 0, histogram: BTreeMap::new(), by_rows: None };
        if kind == Kind::Signed {
            let complex = producer.chain_complex()?;
            (shown.rows, shown.columns) =
                (complex.cell_count(operator.rows()), complex.cell_count(operator.columns()));
            let by_rows = signed(&complex, operator)?;
            shown.count_entries(&by_rows);
            shown.by_rows = Some(by_rows);
            return Ok(shown);
        }
        let model = producer.lar_model()?;
        (shown.rows, shown.columns) =
            (model.cell_count(operator.rows()), model.cell_count(operator.columns()));
        if kind == Kind::Counts && !needs_entries {
            // Counting alone stores no matrix.
            let counts = model.counts(operator).into_iter();
            shown.histogram = (0i64..).zip(counts).filter(|&(entry, times)| entry > 0 && times > 0).collect();
            return Ok(shown);
        }
        let by_rows = match kind {
            Kind::Shared(shared) => pattern(&model, operator, &model.related(operator, shared)?)?,
            Kind::Incident => pattern(&model, operator, &model.incident(operator)?)?,
            Kind::Counts | Kind::Signed => model.shared_vertices(operator.transposed())?,
        };
        shown.count_entries(&by_rows);
        shown.by_rows = Some(by_rows);
        Ok(shown)
    }
}

/// The matrix with an entry 1 for each item, list j as column j.
fn pattern(model: &LarModel, operator: Operator, lists: &RaggedArray) -> Result<SparseMatrix, coface::Error> {
    let starts = (0..=lists.len()).map(|row| lists.start(row) as u32).collect();
    let ones = vec![1; lists.item_count()];
    SparseMatrix::from_parts(model.cell_count(operator.columns()), starts, lists.items().to_vec(), ones)
}

/// The boundary or coboundary operator, transposed.
fn signed(complex: &ChainComplex, operator: Operator) -> Result<SparseMatrix, coface::Error> {
    let (rows, columns) = (operator.rows(), operator.columns());
    if rows.abs_diff(columns) != 1 {
        return Err(coface::Error::invalid(format!("{operator} is no boundary or coboundary operator"))
            .with_cure("signs are those of neighboring degrees: EV, FE, CF and VE, EF, FC"));
    }
    match complex.boundary_matrix(rows.max(columns)) {
        // A coboundary matrix has the boundary of each row's cell in the row.
        Some(boundary) if rows > columns => Ok(boundary.clone()),
        Some(boundary) => Ok(boundary.transpose()),
        None => SparseMatrix::zero(complex.cell_count(columns), complex.cell_count(rows)),
    }
}

/// The form of the file to write.
#[derive(Clone, Copy)]
enum Output<'a> {
    Matrix(&'a Path),
    Json(&'a Path),
}

impl<'a> Output<'a> {
    fn of(path: &'a Path) -> Result<Self, Failure> {
        if is_json(path) {
            return Ok(Self::Json(path));
        }
        match path.extension() {
            Some(extension) if extension.eq_ignore_ascii_case("mtx") => Ok(Self::Matrix(path)),
            _ => Err(Failure::new(format!(
                "{}: an operator is written as .mtx or .json; name the file so",
                path.display()
            ))),
        }
    }
}

impl Shown {
    fn count_entries(&mut self, by_rows: &SparseMatrix) {
        for &entry in by_rows.entries() {
            *self.histogram.entry(entry.into()).or_default() += 1;
        }
    }

    fn entry_count(&self) -> u64 {
        self.histogram.values().sum()
    }

    /// The object, entry after entry.
    fn write_json(&self, with_entries: bool, out: &mut dyn Write) -> io::Result<()> {
        // Entries are written one by one: there may be many.
        let text = to_json(&IncidenceAnswer {
            file: self.file.clone(),
            operator: self.operator.to_string(),
            kind: self.kind.name().to_owned(),
            rows: self.rows,
            columns: self.columns,
            entries_count: self.entry_count(),
            histogram: self.histogram.iter().map(|(entry, &times)| (entry.to_string(), times)).collect(),
            entries: None,
            remarks: Vec::new(),
        });
        match (&self.by_rows, with_entries) {
            (Some(by_rows), true) => {
                // Before the brace that ends the object.
                write!(out, "{},\"entries\":[", &text[..text.len() - 1])?;
                let mut separator = "";
                for (row, entries) in by_rows.columns().enumerate() {
                    for (column, entry) in entries.iter() {
                        write!(out, "{separator}[{row},{column},{entry}]")?;
                        separator = ",\n";
                    }
                }
                out.write_all(b"]}\n")
            }
            _ => writeln!(out, "{text}"),
        }
    }

    fn page(&self) -> String {
        let kind = match self.kind {
            Kind::Counts if (self.operator.rows(), self.operator.columns()) == (0, 0) => {
                "the edges between two vertices, on the diagonal at one".to_owned()
            }
            Kind::Counts => "the vertices that two cells share".to_owned(),
            Kind::Shared(Shared::AtLeast(n)) => format!("1 where two cells share at least {}", vertices(n)),
            Kind::Shared(Shared::Exactly(n)) => format!("1 where two cells share exactly {}", vertices(n)),
            Kind::Shared(_) => String::new(),
            Kind::Incident if self.operator.is_square() => "1 where two cells are adjacent".to_owned(),
            Kind::Incident => "1 where one cell is a face of the other".to_owned(),
            Kind::Signed if self.operator.rows() > self.operator.columns() => {
                "the coboundary operator".to_owned()
            }
            Kind::Signed => "the boundary operator".to_owned(),
        };
        let fact = |label: &str, value: String, gloss: String| (label.to_owned(), value, gloss);
        let mut facts = vec![
            fact("rows", self.rows.to_string(), cells(self.operator.rows())),
            fact("columns", self.columns.to_string(), cells(self.operator.columns())),
            fact("entries", self.entry_count().to_string(), kind),
        ];
        for (entry, times) in &self.histogram {
            facts.push(fact(&format!("  {entry}"), times.to_string(), String::new()));
        }
        text::facts(&format!("operator {} of {}", self.operator, self.file), &facts)
    }
}

fn vertices(count: u32) -> String {
    text::count(count as usize, "vertex")
}

/// What the cells of a degree are called.
fn cells(degree: usize) -> String {
    match ["vertices", "edges", "faces", "3-cells"].get(degree) {
        Some(&name) => name.to_owned(),
        None => format!("cells of degree {degree}"),
    }
}
