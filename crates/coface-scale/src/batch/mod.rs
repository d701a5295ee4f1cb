//! The report on many files: one row a file, errors as rows, and a run that was cut short goes on where it was.
//!
//! A [`Batch`] is a list of [files](find_files) and how they are read. Its **rows** are objects: `path`, `bytes`, `seconds`, `error` and, where
//! there is none, everything that `coface info --json` says. [`Batch::write`] keeps finished rows in a **journal** beside the output until the
//! output appears whole, as JSON lines or as a [table](TableFormat) with one value a column.

mod examination;
mod files;
mod flat;
mod journal;
mod row;
mod table;

pub use crate::tables::TableFormat;
pub(crate) use examination::Fault;
pub use examination::{Examiner, Reading, ReportRequest};
pub use files::find_files;
pub use flat::flat_line;
pub use row::Row;
pub use table::table_of_lines;

use crate::workers::{Outcome, WorkerPool};
use coface_algebra::Error;
use examination::ReadingText;
use journal::{Journal, Sealer, Stamp};
use serde::Serialize;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Files to report on, and how.
///
/// # Examples
/// ```no_run
/// use coface_scale::batch::{Batch, TableFormat, find_files};
/// use coface_scale::workers::{Limits, WorkerCommand, WorkerPool};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let batch = Batch::new(find_files(&["models".into()], true, std::io::stdin())?);
/// let pool = WorkerPool::new(WorkerCommand::new("coface", ["worker", "info"]), 2, Limits::default());
/// let summary = batch.write(&pool, "models.jsonl".as_ref(), TableFormat::JsonLines)?;
/// println!("{} files, {} errors", summary.files(), summary.error_count());
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Batch {
    /// The files, in the order of the rows.
    pub files: Vec<PathBuf>,
    /// How they are read.
    pub reading: Reading,
    /// Whether rows tell how long each file took: then no two runs have the same bytes.
    pub timings: bool,
    /// Whether rows that an earlier run finished are done again.
    pub restart: bool,
}

/// What came of a batch.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Summary {
    pub(crate) files: usize,
    pub(crate) errors: BTreeMap<String, usize>,
    pub(crate) resumed: usize,
    pub(crate) refused: Option<String>,
}

impl Summary {
    /// The number of rows: of files, or of lines of lists of signatures.
    pub fn files(&self) -> usize {
        self.files
    }

    /// The number of rows that are errors, by kind.
    pub fn errors(&self) -> &BTreeMap<String, usize> {
        &self.errors
    }

    /// The number of rows taken from an earlier run that was cut short.
    pub fn resumed(&self) -> usize {
        self.resumed
    }

    /// Why the rows of an earlier run were not taken, where they were not.
    pub fn refused(&self) -> Option<&str> {
        self.refused.as_deref()
    }
}

impl Summary {
    /// The number of rows that are errors.
    ///
    /// # Examples
    /// ```
    /// use coface_scale::batch::Summary;
    /// assert_eq!(Summary::default().error_count(), 0);
    /// ```
    pub fn error_count(&self) -> usize {
        self.errors.values().sum()
    }

    /// Counts a row, which has this kind of error or none.
    pub(crate) fn count_row(&mut self, error_kind: Option<&str>) {
        self.files += 1;
        if let Some(kind) = error_kind {
            *self.errors.entry(kind.to_owned()).or_default() += 1;
        }
    }
}

/// The name of the stage in the progress of the work.
const STAGE: &str = "examining files";

impl Batch {
    /// These files, read by what their names and contents tell, with timings.
    ///
    /// # Examples
    /// ```
    /// use coface_scale::batch::Batch;
    /// assert!(Batch::new(vec!["a.off".into()]).timings);
    /// ```
    pub fn new(files: Vec<PathBuf>) -> Self {
        Self { files, reading: Reading::default(), timings: true, restart: false }
    }

    /// The rows as they come, each with the place of its file in the list.
    ///
    /// # Errors
    /// Those of [`WorkerPool::run`]. What is wrong with a file is a row.
    pub fn rows(
        &self,
        pool: &WorkerPool,
        mut take: impl FnMut(usize, &Row) -> Result<(), Error>,
    ) -> Result<Summary, Error> {
        let mut summary = Summary::default();
        pool.run(
            STAGE,
            self.files.len(),
            |place| self.request(place),
            |place, outcome| {
                let row = self.row(place, &Stamp::of(&self.files[place]), outcome);
                summary.count_row(row.error_kind().as_deref());
                take(place, &row)
            },
        )?;
        Ok(summary)
    }

    /// Writes all rows to a file, in the order of the files. Finished rows are kept in a journal beside it (its name with a dot before and
    /// `.journal` behind), from which a later run with the same options takes those of files that are as they were; it goes
    /// when the file is there.
    ///
    /// The same files give the same bytes, but for `seconds`, whatever the number of workers and however often it was cut short.
    ///
    /// # Errors
    /// [`ErrorKind::Io`](coface_algebra::ErrorKind::Io) when the output or its journal cannot be written, or another run is writing it; those of
    /// [`WorkerPool::run`].
    pub fn write(&self, pool: &WorkerPool, out: &Path, format: TableFormat) -> Result<Summary, Error> {
        coface_io::check_output(out)?;
        let mut sealer = Sealer::new(self.reading.options());
        let (mut journal, refused) =
            Journal::open(out, &self.options(pool), &self.files, self.restart, &mut sealer)?;
        let left: Vec<usize> = (0..self.files.len()).filter(|&place| !journal.has(place)).collect();
        let resumed = self.files.len() - left.len();
        let mut summary = Summary { resumed, refused, ..Summary::default() };
        match self.finish(pool, (&mut journal, &mut sealer), &left, &mut summary, (out, format)) {
            Ok(()) => {
                journal.remove();
                Ok(summary)
            }
            Err(error) => Err(journal.given_up(error)),
        }
    }

    /// Has the files examined that are left, and writes all rows.
    fn finish(
        &self,
        pool: &WorkerPool,
        (journal, sealer): (&mut Journal, &mut Sealer),
        left: &[usize],
        summary: &mut Summary,
        (out, format): (&Path, TableFormat),
    ) -> Result<(), Error> {
        pool.run(
            STAGE,
            left.len(),
            |i| self.request(left[i]),
            |i, outcome| {
                let seal = sealer.seal(&self.files[left[i]]);
                journal.add(left[i], &seal, &self.row(left[i], &seal.stamp, outcome))
            },
        )?;
        journal.each(|row| {
            summary.count_row(row.error_kind().as_deref());
            Ok(())
        })?;
        if format == TableFormat::JsonLines {
            return coface_io::replace_file(out, |file| {
                journal.each(|row| Ok(writeln!(file, "{}", row.to_line(self.timings))?))
            });
        }
        table::write_table(out, format, self.timings, |take| journal.each(|row| take(&row.to_table_row()?)))
    }

    fn request(&self, place: usize) -> String {
        let mut request = ReportRequest::new(&self.files[place]);
        request.reading = self.reading;
        request.to_line()
    }

    fn row(&self, place: usize, stamp: &Stamp, outcome: Outcome) -> Row {
        Row::new(&self.files[place], stamp.bytes(), outcome)
    }

    /// What rows depend on beside their files.
    fn options(&self, pool: &WorkerPool) -> String {
        let limits = pool.limits();
        let milliseconds = limits.time.map(|time| time.as_millis() as u64);
        let options = Options {
            journal: 3,
            program: env!("CARGO_PKG_VERSION"),
            reading: ReadingText::of(self.reading),
            memory: limits.memory,
            milliseconds,
        };
        serde_json::to_string(&options).expect("options have texts as keys")
    }
}

/// What the rows of a journal depend on.
#[derive(Serialize)]
struct Options {
    /// The version of the journal.
    journal: u32,
    program: &'static str,
    reading: ReadingText,
    memory: Option<u64>,
    milliseconds: Option<u64>,
}
