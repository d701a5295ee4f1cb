//! One row: what is said about one file.

use crate::workers::Outcome;
use coface_algebra::Error;
use serde::Deserialize;
use serde_json::{Value, json};
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

/// The answer of a worker on a file that it could not serve.
#[derive(Deserialize)]
struct Failed {
    error: Fault,
}

#[derive(Deserialize)]
struct Fault {
    kind: String,
}

impl Row {
    /// What became of the request for a report on this file of so many bytes.
    pub(crate) fn new(path: &Path, bytes: Option<u64>, outcome: Outcome) -> Self {
        let head = format!("\"path\":{},\"bytes\":{}", json!(path.to_string_lossy()), json!(bytes));
        let whole = |time: Duration| u64::try_from(time.as_micros()).ok();
        let (microseconds, answer) = match outcome {
            Ok(answer) => (whole(answer.time), answer.line),
            Err(loss) => {
                let error = json!({"kind": loss.kind(), "message": loss.to_string(), "cure": loss.cure()});
                (None, json!({ "error": error }).to_string())
            }
        };
        Self { head, microseconds, answer }
    }

    /// The kind of the error, if the row is one.
    pub fn error_kind(&self) -> Option<String> {
        if !self.answer.starts_with(ERROR) {
            return None;
        }
        let failed: Option<Failed> = serde_json::from_str(&self.answer).ok();
        Some(failed.map_or_else(|| "unknown".to_owned(), |failed| failed.error.kind))
    }

    /// The row as one object in a line: `path`, `bytes`, `seconds` if timings are asked for, `error` (null or `kind`, `message`, `cure`), then
    /// what `coface info --json` says.
    pub fn to_line(&self, timings: bool) -> String {
        let seconds = match timings {
            true => format!(",\"seconds\":{}", json!(self.seconds())),
            false => String::new(),
        };
        let body = self.answer.strip_prefix('{').unwrap_or("}");
        let error = if self.answer.starts_with(ERROR) { "" } else { "\"error\":null," };
        format!("{{{}{seconds},{error}{body}", self.head)
    }

    /// The row as a value.
    ///
    /// # Errors
    /// [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) if the worker did not answer with an object.
    pub(crate) fn to_json(&self, timings: bool) -> Result<Value, Error> {
        serde_json::from_str(&self.to_line(timings))
            .map_err(|error| Error::parse(format!("a worker answered what is no object: {error}")))
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
        assert_eq!(
            row.to_json(false).unwrap(),
            json!({"path": "a\"b", "bytes": 7, "error": null, "area": 2, "file": "a\"b"})
        );
        let row = Row::new("a".as_ref(), None, Err(Loss::Memory { limit: Some(1 << 20) }));
        assert_eq!(row.error_kind().as_deref(), Some("memory"));
        let error = json!({"kind": "memory", "message": "needed more than 1 MiB of memory", "cure": "allow more memory"});
        assert_eq!(
            row.to_json(true).unwrap(),
            json!({"path": "a", "bytes": null, "seconds": null, "error": error})
        );
    }
}
