//! The folder of input files that the measured processes read.

use crate::inputs;
use coface::Error;
use std::path::{Path, PathBuf};

/// Input files of this run, written on demand and removed at the end.
pub(crate) struct Store {
    folder: PathBuf,
}

impl Store {
    /// # Errors
    /// If the folder cannot be made.
    pub(crate) fn new() -> Result<Self, Error> {
        let folder = std::env::temp_dir().join(format!("coface-bench-{}", std::process::id()));
        std::fs::create_dir_all(&folder)?;
        Ok(Self { folder })
    }

    /// The file of an input in a format.
    ///
    /// # Errors
    /// If there is no such input, or it cannot be written in that format.
    pub(crate) fn file(&self, input: &str, extension: &str) -> Result<PathBuf, Error> {
        let path = self.folder.join(format!("{input}.{extension}"));
        if !Path::new(&path).exists() {
            inputs::write(input, &path)?;
        }
        Ok(path)
    }
}

impl Drop for Store {
    fn drop(&mut self) {
        // A leftover in the temporary folder is no reason to fail.
        let _ = std::fs::remove_dir_all(&self.folder);
    }
}
