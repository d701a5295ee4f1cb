//! Rows as tables in files.

use super::flat::{Columns, TableRow};
use crate::tables::{Column, Kind, TableFormat, TableWriter};
use coface_algebra::Error;
use std::fs::File;
use std::io::{BufRead, BufReader};
use std::path::Path;

/// Writes rows in a file of JSON lines as a table, which takes the place of `out` when it is whole. Its name says the format, which is not JSON
/// lines again.
///
/// # Errors
/// Those of [`TableFormat::of_path`];
/// [`ErrorKind::Io`](coface_algebra::ErrorKind::Io) when a file cannot be read or written; [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) with the line that is no row.
///
/// # Examples
/// ```
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let folder = std::env::temp_dir();
/// let (lines, out) = (folder.join("coface-rows.jsonl"), folder.join("coface-rows.csv"));
/// use coface_scale::batch::{Examiner, ReportRequest, table_of_lines};
/// let request = ReportRequest::new("memory://segment.lines").to_line();
/// let row = Examiner::default().examine_with(&request, |_| Some(Ok(b"0,0,1,1".to_vec())));
/// std::fs::write(&lines, row + "\n")?;
/// table_of_lines(&lines, &out, false)?;
/// let text = std::fs::read_to_string(&out)?;
/// assert!(text.starts_with("path,bytes,") && text.contains(",f_0,f_1,") && text.contains(",edge=1,"), "{text}");
/// # std::fs::remove_file(&lines)?;
/// # std::fs::remove_file(&out)?;
/// # Ok(()) }
/// ```
pub fn table_of_lines(lines: &Path, out: &Path, timings: bool) -> Result<(), Error> {
    let each = |take: &mut dyn FnMut(&TableRow) -> Result<(), Error>| -> Result<(), Error> {
        let in_lines = |error: Error| error.in_file(lines.display().to_string());
        let file = File::open(lines).map_err(|error| in_lines(error.into()))?;
        for (line, number) in BufReader::new(file).lines().zip(1..) {
            let line = line.map_err(|error| in_lines(error.into()))?;
            let row = TableRow::of_line(&line).map_err(|fault| {
                in_lines(Error::parse(format!("this is no row: {fault}")).at_line(number))
            })?;
            take(&row)?;
        }
        Ok(())
    };
    write_table(out, TableFormat::of_path(out)?, timings, each)
}

/// Writes rows as a table of this format; they are gone through once more to know the columns.
pub(crate) fn write_table(
    out: &Path,
    format: TableFormat,
    timings: bool,
    each: impl Fn(&mut dyn FnMut(&TableRow) -> Result<(), Error>) -> Result<(), Error>,
) -> Result<(), Error> {
    let mut columns = Columns::default();
    each(&mut |row| {
        columns.see(row);
        Ok(())
    })?;
    let mut kinds = Vec::new();
    if format == TableFormat::Parquet {
        each(&mut |row| {
            Kind::see(&mut kinds, &columns.values(row, timings));
            Ok(())
        })?;
    }
    let kind = |at: usize| kinds.get(at).copied().flatten().unwrap_or(Kind::Text);
    let named = columns.names(timings).into_iter().enumerate();
    let header: Vec<Column> = named.map(|(at, name)| Column::new(name, kind(at))).collect();
    coface_io::replace_file(out, |file| {
        let mut table = match format {
            TableFormat::Parquet => TableWriter::parquet(file, header)?,
            _ => TableWriter::csv(file, &header)?,
        };
        each(&mut |row| table.row(&columns.values(row, timings)))?;
        table.end()
    })
}
