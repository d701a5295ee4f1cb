//! The formats of tables.

use coface_algebra::Error;
use std::path::Path;

/// How rows are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum TableFormat {
    /// One object a line, with all that is said about the file.
    JsonLines,
    /// Comma-separated values after RFC 4180: a line of names, then one line a row. What is not there is empty.
    Csv,
    /// Apache Parquet, with columns of booleans, 64-bit integers, 64-bit numbers and texts. What is not there is null.
    Parquet,
}

impl TableFormat {
    /// The format of a file by its name: `.jsonl` or `.ndjson`, `.csv`, `.parquet`.
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
            Some("parquet") => Ok(Self::Parquet),
            Some(other) => fault(
                format!("the extension \"{other}\" is no table known here"),
                "end it in .jsonl, .csv or .parquet",
            ),
            None => fault(
                "the name has no extension, which states the format".to_owned(),
                "end it in .jsonl, .csv or .parquet",
            ),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn extensions_tell_the_format() {
        let of = |name: &str| TableFormat::of_path(Path::new(name)).map_err(|error| error.to_string());
        assert_eq!(
            (of("a.JSONL"), of("a.ndjson"), of("b.csv")),
            (Ok(TableFormat::JsonLines), Ok(TableFormat::JsonLines), Ok(TableFormat::Csv))
        );
        assert_eq!(of("a.Parquet"), Ok(TableFormat::Parquet));
        assert!(of("a.txt").is_err() && of("a").is_err());
    }
}
