//! Lists of isomorphism signatures as tables: a row a line, as the lines come.
//!
//! A [`SignatureBatch`] reads lines of `signature name` or `name signature`, asks each table a
//! [`SignatureRequest`], and writes one [`SignatureRow`] after the other. What is wrong with a line is in
//! its row. Only one block of lines is in memory at a time, whatever the length of the file.

mod columns;
mod row;
mod rows;

pub use row::SignatureRow;
pub use rows::SignatureRows;

use crate::batch::Summary;
use crate::tables::{TableFormat, TableWriter};
use coface_algebra::Error;
use coface_answers::SignatureRequest;
use coface_io::Format;
use std::collections::VecDeque;
use std::path::{Path, PathBuf};

/// Lists of signatures, and what is asked about each line.
///
/// # Examples
/// ```
/// use coface_scale::batch::TableFormat;
/// use coface_scale::signatures::SignatureBatch;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let folder = std::env::temp_dir();
/// let (list, out) = (folder.join("coface-signatures.sig"), folder.join("coface-signatures.csv"));
/// std::fs::write(&list, "cMcabbjak L(3,1)\nno signature\n")?;
/// let summary = SignatureBatch::new(vec![list.clone()]).write(&out, TableFormat::Csv)?;
/// assert_eq!((summary.files(), summary.error_count()), (2, 1));
/// let text = std::fs::read_to_string(&out)?;
/// assert!(text.starts_with("path,line,name,signature,error_kind,"), "{text}");
/// assert!(text.contains("\"L(3,1)\",cMcabbjak,"), "{text}");
/// # std::fs::remove_file(&list)?;
/// # std::fs::remove_file(&out)?;
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct SignatureBatch {
    /// The lists, in the order of the rows.
    pub files: Vec<PathBuf>,
    /// What is asked about each line.
    pub request: SignatureRequest,
    /// How many lines are looked at at once.
    pub jobs: usize,
}

/// Whether all these files are lists of signatures: by what was said, by their names, or by their first lines.
///
/// # Examples
/// ```
/// use coface_scale::signatures::are_signature_lists;
/// assert!(are_signature_lists(&["census.sig".into()], None));
/// assert!(!are_signature_lists(&["census.sig".into(), "spot.obj".into()], None) && !are_signature_lists(&[], None));
/// ```
pub fn are_signature_lists(files: &[PathBuf], format: Option<Format>) -> bool {
    let is_list = |path: &PathBuf| match format {
        Some(format) => format == Format::Isosig,
        None if path.is_dir() => false,
        None => {
            Format::from_path(path) == Some(Format::Isosig)
                || path.is_file()
                    && coface_io::format_of_path(path, None).is_ok_and(|found| found == Format::Isosig)
        }
    };
    !files.is_empty() && files.iter().all(is_list)
}

impl SignatureBatch {
    /// These lists, asked for homology and verdicts, one line at a time.
    ///
    /// # Examples
    /// ```
    /// use coface_scale::signatures::SignatureBatch;
    /// assert_eq!(SignatureBatch::new(vec!["census.sig".into()]).jobs, 1);
    /// ```
    pub fn new(files: Vec<PathBuf>) -> Self {
        Self { files, request: SignatureRequest::new(), jobs: 1 }
    }

    /// The rows in the order of the lines. What is wrong with a file or a line is a row.
    ///
    /// # Complexity
    /// That of the request for each line; memory is that of some hundred lines.
    ///
    /// # Examples
    /// ```
    /// use coface_scale::signatures::SignatureBatch;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// for row in SignatureBatch::new(vec!["/no/such/list.sig".into()]).rows() {
    ///     assert_eq!(row?.error_kind(), Some("io"));
    /// }
    /// # Ok(()) }
    /// ```
    pub fn rows(&self) -> SignatureRows {
        SignatureRows {
            request: self.request,
            jobs: self.jobs,
            files: self.files.clone().into_iter(),
            open: None,
            ready: VecDeque::new(),
            pool: None,
        }
    }

    /// Writes all rows to a file, which appears whole at the end. The same lists give the same bytes, whatever the number of jobs.
    ///
    /// # Errors
    /// [`ErrorKind::Io`](coface_algebra::ErrorKind::Io) when the output cannot be written.
    pub fn write(&self, out: &Path, format: TableFormat) -> Result<Summary, Error> {
        coface_io::check_output(out)?;
        let mut summary = Summary::default();
        coface_io::replace_file(out, |file| {
            if format == TableFormat::JsonLines {
                return self.rows().try_for_each(|row| {
                    let row = row?;
                    summary.count_row(row.error_kind());
                    Ok(writeln!(file, "{}", row.to_line())?)
                });
            }
            let columns = columns::columns(self.request);
            let mut table = match format {
                TableFormat::Parquet => TableWriter::parquet(file, columns)?,
                _ => TableWriter::csv(file, &columns)?,
            };
            for row in self.rows() {
                let row = row?;
                summary.count_row(row.error_kind());
                table.row(&columns::values(&row, self.request))?;
            }
            table.end()
        })?;
        Ok(summary)
    }
}
