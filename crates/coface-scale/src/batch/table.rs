//! Rows as lines of a file.

use super::flat::{Cell, Columns, TableRow};
use coface_algebra::{Error, escaped};
use std::fs::File;
use std::io::{BufRead, BufReader, Write};
use std::path::Path;

/// How rows are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum TableFormat {
    /// One object a line, with all that is said about the file.
    JsonLines,
    /// Comma-separated values after RFC 4180: a line of names, then one line a file. What is not there is empty.
    Csv,
}

impl TableFormat {
    /// The format of a file by its name: `.jsonl` or `.ndjson`, `.csv`.
    ///
    /// # Errors
    /// [`ErrorKind::UnsupportedFormat`](coface_algebra::ErrorKind::UnsupportedFormat) for every other extension.
    ///
    /// # Examples
    /// ```
    /// use coface_scale::batch::TableFormat;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(TableFormat::of_path("models.csv".as_ref())?, TableFormat::Csv);
    /// # Ok(()) }
    /// ```
    pub fn of_path(path: &Path) -> Result<Self, Error> {
        let extension = path.extension().map(|extension| extension.to_string_lossy().to_ascii_lowercase());
        let fault = |message: String, cure: &str| {
            let error = Error::new(coface_algebra::ErrorKind::UnsupportedFormat, message).with_cure(cure);
            Err(error.in_file(path.display().to_string()))
        };
        match extension.as_deref() {
            Some("jsonl" | "ndjson") => Ok(Self::JsonLines),
            Some("csv") => Ok(Self::Csv),
            Some("parquet") => fault(
                "Parquet is not written by the program".to_owned(),
                "end it in .csv or .jsonl, or use coface.batch of the Python package",
            ),
            Some(other) => {
                fault(format!("the extension \"{other}\" is no table known here"), "end it in .jsonl or .csv")
            }
            None => fault(
                "the name has no extension, which states the format".to_owned(),
                "end it in .jsonl or .csv",
            ),
        }
    }
}

/// Writes the names of the columns.
pub(crate) fn write_header(out: &mut dyn Write, columns: &Columns, timings: bool) -> Result<(), Error> {
    Ok(writeln!(out, "{}", columns.names(timings).join(","))?)
}

/// Writes a row, one value a column.
pub(crate) fn write_row(
    out: &mut dyn Write,
    columns: &Columns,
    row: &TableRow,
    timings: bool,
) -> Result<(), Error> {
    let values: Vec<String> = columns.values(row, timings).iter().map(field).collect();
    Ok(writeln!(out, "{}", values.join(","))?)
}

/// Writes rows in a file of JSON lines as CSV, which takes the place of `out` when it is whole.
///
/// # Errors
/// [`ErrorKind::Io`](coface_algebra::ErrorKind::Io) when a file cannot be read or written; [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) with the line that is no row.
///
/// # Examples
/// ```
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let folder = std::env::temp_dir();
/// let (lines, out) = (folder.join("coface-rows.jsonl"), folder.join("coface-rows.csv"));
/// use coface_scale::batch::{Examiner, ReportRequest, csv_of_lines};
/// let request = ReportRequest::new("memory://segment.lines").to_line();
/// let row = Examiner::default().examine_with(&request, |_| Some(Ok(b"0,0,1,1".to_vec())));
/// std::fs::write(&lines, row + "\n")?;
/// csv_of_lines(&lines, &out, false)?;
/// let text = std::fs::read_to_string(&out)?;
/// assert!(text.starts_with("path,bytes,") && text.contains(",f_0,f_1,") && text.contains(",edge=1,"), "{text}");
/// # std::fs::remove_file(&lines)?;
/// # std::fs::remove_file(&out)?;
/// # Ok(()) }
/// ```
pub fn csv_of_lines(lines: &Path, out: &Path, timings: bool) -> Result<(), Error> {
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
    let mut columns = Columns::default();
    each(&mut |row| {
        columns.see(row);
        Ok(())
    })?;
    coface_io::replace_file(out, |file| {
        write_header(file, &columns, timings)?;
        each(&mut |row| write_row(file, &columns, row, timings))
    })
}

/// A value as a field: empty for null, in one line, in quotes where it must be. What a spreadsheet would take for a
/// formula has an apostrophe before it, which says that it is text.
fn field(value: &Cell) -> String {
    let text = match value {
        Cell::Nothing => return String::new(),
        Cell::Text(text) => {
            let text = escaped(text);
            if is_formula(&text) { format!("'{text}") } else { text.into_owned() }
        }
        number => serde_json::to_string(number).expect("numbers are JSON"),
    };
    if text.contains([',', '"', '\n', '\r']) || text.is_empty() || text.trim() != text {
        return format!("\"{}\"", text.replace('"', "\"\""));
    }
    text
}

/// Whether a spreadsheet may take a text for a formula: one that begins as a formula does and is no number.
fn is_formula(text: &str) -> bool {
    let is_number = || {
        text.bytes().all(|byte| byte.is_ascii_digit() || b"+-.eE".contains(&byte))
            && text.parse::<f64>().is_ok()
    };
    text.starts_with(['=', '+', '-', '@', '\t', '\r']) && !is_number()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fields_are_quoted_where_they_must_be() {
        let text = |text: &str| Cell::from(text);
        let fields =
            [Cell::Nothing, true.into(), 0.1.into(), text("a b"), text("a,\"b\""), text("\n"), text("")];
        let expected = ["", "true", "0.1", "a b", "\"a,\"\"b\"\"\"", "\\n", "\"\""];
        assert_eq!(fields.map(|value| field(&value)), expected);
    }

    #[test]
    fn formulas_are_text_and_numbers_are_numbers() {
        for text in ["=1+1", "+cmd|' /C calc'!A0", "-2+3", "@SUM(A1)", "-", "+1-1", "-inf", "-1e5 "] {
            let cell = field(&text.into());
            assert!(cell.trim_start_matches('"').starts_with(&format!("'{}", &text[..1])), "{text}: {cell}");
        }
        assert_eq!([field(&"\t=1".into()), field(&"\r\n=1".into())], ["\\t=1", "\\r\\n=1"]);
        assert_eq!(field(&"=a,b".into()), "\"'=a,b\"");
        for text in ["-1.5", "+2", "-1e-5", "a=b", "1-1", "."] {
            assert_eq!(field(&text.into()), text);
        }
        assert_eq!([field(&(-1.5).into()), field(&Cell::Whole(-3))], ["-1.5", "-3"]);
    }

    #[test]
    fn extensions_tell_the_format() {
        let of = |name: &str| TableFormat::of_path(Path::new(name)).map_err(|error| error.to_string());
        assert_eq!(
            (of("a.JSONL"), of("a.ndjson"), of("b.csv")),
            (Ok(TableFormat::JsonLines), Ok(TableFormat::JsonLines), Ok(TableFormat::Csv))
        );
        assert!(of("a.parquet").unwrap_err().contains("Python"));
        assert!(of("a.txt").is_err() && of("a").is_err());
    }
}
