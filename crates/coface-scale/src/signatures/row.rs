//! What is said of one line.

use crate::batch::Fault;
use coface_algebra::Error;
use coface_answers::SignatureRequest;
use coface_answers::answer::SignatureAnswer;
use coface_io::SignatureLine;
use serde::Serialize;

/// What is said of one line of a list of signatures, or of a list that cannot be read.
#[derive(Clone, Debug, PartialEq)]
pub struct SignatureRow {
    pub(super) path: String,
    pub(super) line: Option<u64>,
    pub(super) name: Option<String>,
    pub(super) signature: Option<String>,
    pub(super) outcome: Result<SignatureAnswer, Fault>,
}

/// The row as an object of JSON.
#[derive(Serialize)]
struct Shown<'a> {
    path: &'a str,
    line: Option<u64>,
    name: Option<&'a str>,
    signature: Option<&'a str>,
    error: Option<&'a Fault>,
    #[serde(flatten)]
    answer: Option<&'a SignatureAnswer>,
}

impl SignatureRow {
    /// The row of a line of this file.
    pub(super) fn of_line(path: &str, line: &SignatureLine, request: SignatureRequest) -> Self {
        let in_line = |error: Error| error.at_line(line.number()).in_file(path.to_owned());
        let answered = match line.table() {
            Ok(table) => request.answer(table),
            Err(error) => Err(error.clone()),
        };
        Self {
            path: path.to_owned(),
            line: Some(line.number()),
            name: line.name().map(str::to_owned),
            signature: Some(line.signature().to_owned()),
            outcome: answered.map_err(|error| Fault::of(&in_line(error))),
        }
    }

    /// The row of a file that cannot be read, or not to its end.
    pub(super) fn of_file(path: &str, error: &Error) -> Self {
        let outcome = Err(Fault::of(error));
        Self { path: path.to_owned(), line: None, name: None, signature: None, outcome }
    }

    /// The number of the line in its file, from 1; `None` for a file that cannot be read.
    pub fn line(&self) -> Option<u64> {
        self.line
    }

    /// What is known of the table, if the line has one.
    pub fn answer(&self) -> Option<&SignatureAnswer> {
        self.outcome.as_ref().ok()
    }

    /// The kind of the error, if the row is one.
    pub fn error_kind(&self) -> Option<&str> {
        self.outcome.as_ref().err().map(|fault| fault.kind.as_str())
    }

    /// The row as one object in a line: `path`, `line`, `name`, `signature`, `error` (null or `kind`, `message`, `cure`), then what is known.
    pub fn to_line(&self) -> String {
        let shown = Shown {
            path: &self.path,
            line: self.line,
            name: self.name.as_deref(),
            signature: self.signature.as_deref(),
            error: self.outcome.as_ref().err(),
            answer: self.answer(),
        };
        serde_json::to_string(&shown).expect("rows have texts as keys")
    }
}
