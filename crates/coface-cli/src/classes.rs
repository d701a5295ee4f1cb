//! The classes of a congruence as a file: JSON or Arrow.

use crate::failure::Failure;
use coface::answers::ModelCongruence;
use coface::io::replace_file;
use std::path::Path;

#[cfg(feature = "arrow")]
mod table;

/// How classes are written.
#[derive(Clone, Copy)]
pub(crate) enum ClassFormat {
    Json,
    #[cfg(feature = "arrow")]
    Arrow,
}

impl ClassFormat {
    /// The format that the extension of a file names.
    pub(crate) fn of(path: &Path) -> Result<Self, Failure> {
        let extension = path.extension().map(|extension| extension.to_ascii_lowercase());
        match extension.as_ref().and_then(|extension| extension.to_str()) {
            Some("json") => Ok(Self::Json),
            #[cfg(feature = "arrow")]
            Some("arrow" | "feather" | "ipc") => Ok(Self::Arrow),
            #[cfg(not(feature = "arrow"))]
            Some("arrow" | "feather" | "ipc") => Err(Failure::new(format!(
                "{}: this program was built without the feature arrow; write .json, or build it with --features arrow",
                path.display()
            ))),
            _ => Err(Failure::new(format!(
                "{}: classes are written as .json or .arrow; name the file so",
                path.display()
            ))),
        }
    }
}

/// Writes the classes of all degrees to a file that appears whole or not at all, and lets `write_other` write what belongs
/// with it before it appears: if either fails, neither is there.
pub(crate) fn write_classes(
    congruence: &ModelCongruence,
    path: &Path,
    format: ClassFormat,
    write_other: impl FnOnce() -> Result<(), coface::Error>,
) -> Result<(), Failure> {
    Ok(replace_file(path, |out| {
        match format {
            ClassFormat::Json => congruence.write_classes(out)?,
            #[cfg(feature = "arrow")]
            ClassFormat::Arrow => table::write(congruence.chains().classes(), out)?,
        }
        write_other()
    })?)
}
