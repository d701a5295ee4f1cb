//! What verbs write, by the names of the files: looked at before anything is read.

use crate::arguments::Common;
use crate::failure::Failure;
use crate::output::check_text;
use crate::target::check_extension;
use coface::io::format_of_output;
use std::path::Path;

/// What a verb writes into a file.
#[derive(Clone, Copy)]
pub(crate) enum Written {
    /// A model in the format of the name, which has an extension.
    Model,
    /// A model in the format of the name; without an extension it is JSON.
    ModelOrJson,
    /// An answer as JSON, or as text under any name that is not that of something else.
    Answer,
    /// What the verb itself knows, and looks at before it reads.
    Other,
}

impl Written {
    /// Refuses the name of a file that the verb could not write when its work is done.
    pub(crate) fn check(self, path: &Path) -> Result<(), Failure> {
        match self {
            Self::Model => Ok(format_of_output(path).map(drop)?),
            Self::ModelOrJson => check_extension(path),
            Self::Answer => check_text(path),
            Self::Other => Ok(()),
        }
    }

    /// The same of the file of -o.
    pub(crate) fn check_output(self, common: &Common) -> Result<(), Failure> {
        common.output.as_deref().map_or(Ok(()), |path| self.check(path))
    }
}
