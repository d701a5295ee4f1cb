//! One row: what is said about one file.

use super::examination::{Failure, Fault};
use super::flat::TableRow;
use crate::workers::Outcome;
use coface_algebra::Error;
use serde::Serialize;
use std::path::Path;
use std::time::Duration;

/// What is said about one file of a batch.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// `"path":..,"bytes":..`
    pub(crate) head: String,
    /// The time from request to answer.
    pub(crate) microseconds: Option<u64>,
    /// The answer of a worker: an object with what is said, or one with the key `error` alone.
    pub(crate) answer: String,
}

/// What an answer begins with that is an error: no other has that key.
const ERROR: &str = "{\"error\":";

/// A value as JSON.
fn json(value: &impl Serialize) -> String {
    serde_json::to_string(value).expect("texts and numbers are JSON")
}

impl Row {
    /// What became of the request for a report on this file of so many bytes.
    pub(crate) fn new(path: &Path, bytes: Option<u64>, outcome: Outcome) -> Self {
        let head = format!("\"path\":{},\"bytes\":{}", json(&path.to_string_lossy()), json(&bytes));
        let whole = |time: Duration| u64::try_from(time.as_micros()).ok();
        let (microseconds, answer) = match outcome {
            Ok(answer) => (whole(answer.time), answer.line),
            Err(loss) => {
                let error = Fault {
                    cure: Some(loss.cure().to_owned()),
                    kind: loss.kind().to_owned(),
                    message: loss.to_string(),
                };
                (None, Failure { error }.to_line())
            }
        };
        Self { head, microseconds, answer }
    }

    /// The kind of the error, if the row is one.
    pub fn error_kind(&self) -> Option<String> {
        if !self.answer.starts_with(ERROR) {
            return None;
        }
        let failure: Option<Failure> = serde_json::from_str(&self.answer).ok();
        Some(failure.map_or_else(|| "unknown".to_owned(), |failure| failure.error.kind))
    }

    /// The row as one object in a line: `path`, `bytes`, `seconds` if timings are asked for, `error` (null or `kind`, `message`, `cure`), then
    /// what `coface info --json` says.
    pub fn to_line(&self, timings: bool) -> String {
        let seconds = match timings {
            true => format!(",\"seconds\":{}", json(&self.seconds())),
            false => String::new(),
        };
        let body = self.answer.strip_prefix('{').unwrap_or("}");
        let error = if self.answer.starts_with(ERROR) { "" } else { "\"error\":null," };
        format!("{{{}{seconds},{error}{body}", self.head)
    }

    /// The row as tables have it.
    ///
    /// # Errors
    /// [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) if the worker did not answer with a report or an error.
    pub(crate) fn to_table_row(&self) -> Result<TableRow, Error> {
        TableRow::of_line(&self.to_line(true)).map_err(|fault| {
            Error::parse(format!("a worker answered with something else than a report: {fault}"))
        })
    }

    /// The time from request to answer in seconds.
    pub fn seconds(&self) -> Option<f64> {
        self.microseconds.map(|time| time as f64 / 1e6)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::workers::{Answer, Loss};

    #[test]
    fn rows_are_objects() {
        let answer = Answer { line: r#"{"area":2,"file":"a\"b"}"#.into(), time: Duration::from_millis(1500) };
        let row = Row::new("a\"b".as_ref(), Some(7), Ok(answer));
        assert_eq!(row.error_kind(), None);
        let expected = r#"{"path":"a\"b","bytes":7,"seconds":1.5,"error":null,"area":2,"file":"a\"b"}"#;
        assert_eq!(row.to_line(true), expected);
        assert_eq!(row.to_line(false), expected.replace("\"seconds\":1.5,", ""));
        assert!(row.to_table_row().unwrap_err().to_string().contains("missing field"));
        let row = Row::new("a".as_ref(), None, Err(Loss::Memory { limit: Some(1 << 20) }));
        assert_eq!(row.error_kind().as_deref(), Some("memory"));
        let error =
            r#"{"cure":"allow more memory","kind":"memory","message":"needed more than 1 MiB of memory"}"#;
        let expected = format!(r#"{{"path":"a","bytes":null,"seconds":null,"error":{error}}}"#);
        assert_eq!(row.to_line(true), expected);
        assert_eq!(row.to_table_row(), TableRow::of_line(&expected).map_err(Error::parse));
    }
}
