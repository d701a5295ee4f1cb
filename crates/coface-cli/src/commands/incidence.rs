//! `coface incidence`: operators between the cells of a model.

use crate::arguments::Common;
use crate::failure::Failure;
use crate::input;
use crate::output::{is_json, print_bytes, print_text};
use crate::progress::Progress;
use crate::remarks::object;
use clap::Args;
use coface::algebra::SparseMatrix;
use coface::answers::answer::IncidenceAnswer;
use coface::answers::text;
use coface::answers::{FoundOperator, OperatorKind, OperatorRequest};
use coface::complexes::lar::{Operator, Shared};
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
/// Of two different dimensions an entry is 1 where one cell is a face of the other: the incidence matrix, by the faces and
/// edges of the model itself. Of one dimension, and with --shared, an entry is the number of vertices that two cells share,
/// and for VV the number of edges between two vertices, on the diagonal at one. Such counts are not incidence: an edge whose
/// ends lie on a face that is not convex need not be an edge of it.
///
/// A small matrix is printed whole.
///
/// The file named by -o is a matrix in Matrix Market form if its name ends in .mtx, or the object of --json with entries if it
/// ends in .json.
#[derive(Args)]
pub(crate) struct Incidence {
    /// The model; - is standard input
    #[arg(value_name = "INPUT")]
    input: PathBuf,
    /// Rows and columns: VV, VE, VF, VC, EV, EE, EF, EC, FV, FE, FF, FC, CV, CE, CF, CC, or two degrees as in 4:3
    #[arg(value_name = "OPERATOR", value_parser = operator, required_unless_present = "operator")]
    named: Option<Operator>,
    /// The operator, as an option
    #[arg(long, value_name = "OPERATOR", value_parser = operator, conflicts_with = "named")]
    operator: Option<Operator>,
    /// The number of vertices that two cells share; of two vertices the number of edges between them
    #[arg(long, group = "kind")]
    shared: bool,
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

impl Incidence {
    fn operator(&self) -> Operator {
        self.named.or(self.operator).expect("clap requires one of both")
    }

    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        let output = common.output.as_deref().map(Output::of).transpose()?;
        let progress = Progress::start(common.quiet);
        let (file, producer) = input::produce(&self.input, common.reading(), &progress)?;
        progress.stage("relating cells");
        let needs_entries = output.is_some() || (common.json && self.entries);
        let kind = self.kind();
        let found = OperatorRequest::new(self.operator(), kind)
            .entries(needs_entries)
            .found(&producer)
            .map_err(|error| error.in_file(file.clone()))?;
        progress.stage("writing");
        match output {
            Some(Output::Matrix(path)) => replace_file(path, |out| {
                let matrix = found.by_rows().map(SparseMatrix::transpose);
                matrix.map_or(Ok(()), |matrix| matrix_market::write(&matrix, field(kind), out))
            })?,
            Some(Output::Json(path)) => {
                replace_file(path, |out| Ok(write_entries(&found, &file, true, out)?))?;
            }
            None => {}
        }
        drop(progress);
        match (common.json, output) {
            (true, _) => print_bytes(|out| write_entries(&found, &file, self.entries, out)),
            (false, Some(_)) => Ok(()),
            (false, None) => {
                let counts = found.counts(&file);
                let mut whole = String::new();
                if (1..=SMALL[0]).contains(&counts.rows) && (1..=SMALL[1]).contains(&counts.columns) {
                    let found = OperatorRequest::new(self.operator(), kind).entries(true).found(&producer)?;
                    whole = found.by_rows().map_or_else(String::new, matrix);
                }
                let page = page(&counts, self.operator(), kind, found.histogram());
                print_text(&format!("{page}{whole}"))
            }
        }
    }

    fn kind(&self) -> OperatorKind {
        match (self.at_least, self.exactly) {
            (Some(n), _) => OperatorKind::Shared(Shared::AtLeast(n)),
            (_, Some(n)) => OperatorKind::Shared(Shared::Exactly(n)),
            _ if self.signed => OperatorKind::Signed,
            _ if self.incident => OperatorKind::Incident,
            _ if self.shared || self.operator().is_square() => OperatorKind::Counts,
            _ => OperatorKind::Incident,
        }
    }
}

/// What the entries of a matrix in Matrix Market form are.
fn field(kind: OperatorKind) -> MatrixField {
    match kind {
        OperatorKind::Counts | OperatorKind::Signed => MatrixField::Integer,
        OperatorKind::Shared(_) | OperatorKind::Incident => MatrixField::Pattern,
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

/// The object, entry after entry.
fn write_entries(
    found: &FoundOperator,
    file: &str,
    with_entries: bool,
    out: &mut dyn Write,
) -> io::Result<()> {
    // Entries are written one by one: there may be many.
    let text = object(&found.counts(file));
    match found.by_rows().filter(|_| with_entries) {
        Some(by_rows) => {
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
        None => writeln!(out, "{text}"),
    }
}

/// The counts for people.
fn page(
    answer: &IncidenceAnswer,
    operator: Operator,
    kind: OperatorKind,
    histogram: &BTreeMap<i64, u64>,
) -> String {
    let kind = match kind {
        OperatorKind::Counts if (operator.rows(), operator.columns()) == (0, 0) => {
            "the edges between two vertices, on the diagonal at one".to_owned()
        }
        OperatorKind::Counts => "the vertices that two cells share".to_owned(),
        OperatorKind::Shared(Shared::AtLeast(n)) => {
            format!("1 where two cells share at least {}", vertices(n))
        }
        OperatorKind::Shared(Shared::Exactly(n)) => {
            format!("1 where two cells share exactly {}", vertices(n))
        }
        OperatorKind::Shared(_) => String::new(),
        OperatorKind::Incident if operator.is_square() => "1 where two cells are adjacent".to_owned(),
        OperatorKind::Incident => "1 where one cell is a face of the other".to_owned(),
        OperatorKind::Signed if operator.rows() > operator.columns() => "the coboundary operator".to_owned(),
        OperatorKind::Signed => "the boundary operator".to_owned(),
    };
    let fact = |label: &str, value: String, gloss: String| (label.to_owned(), value, gloss);
    let mut facts = vec![
        fact("rows", answer.rows.to_string(), cells(operator.rows())),
        fact("columns", answer.columns.to_string(), cells(operator.columns())),
        fact("entries", answer.entries_count.to_string(), kind),
    ];
    for (entry, times) in histogram {
        facts.push(fact(&format!("  {entry}"), times.to_string(), String::new()));
    }
    text::facts(&format!("operator {} of {}", operator, answer.file), &facts)
}

/// The largest matrix that a page prints whole, in rows and columns.
const SMALL: [usize; 2] = [40, 30];

/// The rows of a small matrix, with a dot for 0.
fn matrix(by_rows: &SparseMatrix) -> String {
    let columns = by_rows.row_count();
    let mut text = String::from("\n");
    for entries in by_rows.columns() {
        let mut row = vec![".".to_owned(); columns];
        for (column, entry) in entries.iter() {
            row[column] = entry.to_string();
        }
        let cells: Vec<String> = row.iter().map(|entry| format!("{entry:>2}")).collect();
        text += &format!("  {}\n", cells.join(" "));
    }
    text
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
