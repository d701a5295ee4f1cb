//! What ends a run without its result.

use clap::error::ErrorKind;
use coface::Error;
use coface::algebra::escaped;
use std::io::Write;

/// Why a verb did not do its work.
pub(crate) enum Failure {
    /// One message for the user, with place, fault and cure.
    Message(String),
    /// The same where there is not enough memory.
    Memory(String),
    /// Every message has been said already; the exit status is all that is left.
    Said,
    /// The command line asks for what there is not; the exit status is 2.
    Usage(ErrorKind, String),
    /// The reader of standard output went away.
    ClosedPipe,
}

impl Failure {
    pub(crate) fn new(message: impl Into<String>) -> Self {
        Self::Message(message.into())
    }

    /// A failure to write to the thing of this name.
    pub(crate) fn writing(name: &str, error: &std::io::Error) -> Self {
        if error.kind() == std::io::ErrorKind::BrokenPipe {
            return Self::ClosedPipe;
        }
        Self::Message(format!("{name}: cannot write: {error}"))
    }

    /// Prints `error: ...` on standard error.
    pub(crate) fn say(&self) {
        if let Self::Message(message) | Self::Memory(message) = self {
            let style = anstyle::AnsiColor::Red.on_default().bold();
            // A closed standard error leaves nobody to tell.
            let _ = writeln!(anstream::stderr(), "{style}error:{style:#} {}", escaped(message));
        }
    }
}

impl From<Error> for Failure {
    fn from(error: Error) -> Self {
        if error.is_out_of_memory() {
            return Self::Memory(error.to_string());
        }
        Self::Message(in_words(error).to_string())
    }
}

/// The same error; a cure of the library that the program has commands for names them.
fn in_words(error: Error) -> Error {
    let cure = match error.cure() {
        Some("triangulate the model first") => {
            "triangulate the model first: coface arrange INPUT --dimension 3 --triangles -o OUT"
        }
        Some("read it as an interface") => {
            "read it as an interface: coface yin info INPUT says what it is, and coface view INPUT -o OUT.html shows it"
        }
        Some("ask for homology, or take triangles of its boundary") => {
            "ask for homology: coface homology INPUT; or take triangles of its boundary: \
             coface convert INPUT -o boundary.obj and coface arrange boundary.obj --triangles -o OUT"
        }
        _ => return error,
    };
    error.with_cure(cure)
}
