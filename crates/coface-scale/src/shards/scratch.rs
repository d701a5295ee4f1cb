//! Files that are needed while shards are made.

use coface_algebra::Error;
use coface_mapped::{MappedFile, ScratchFile};
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// A folder for files that are needed while shards are made.
pub(super) struct Scratch {
    path: PathBuf,
}

impl Scratch {
    pub(super) fn new(folder: &Path) -> Result<Self, Error> {
        let path = folder.join(".scratch");
        // What a run that was killed has left.
        let _ = fs::remove_dir_all(&path);
        fs::create_dir_all(&path).map_err(|error| Error::from(error).in_file(path.display().to_string()))?;
        Ok(Self { path })
    }

    /// The path of the folder.
    pub(super) fn path(&self) -> &Path {
        &self.path
    }

    /// A nameless file on the file system of the folder.
    pub(super) fn stream(&self) -> Result<ScratchStream, Error> {
        let file = ScratchFile::create_in(&self.path)
            .map_err(|error| Error::from(error).in_file(self.path.display().to_string()))?;
        Ok(ScratchStream(Arc::new(Mutex::new(file))))
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        // What cannot be removed is removed by the next run.
        let _ = fs::remove_dir_all(&self.path);
    }
}

/// A nameless file that is written through clones of this stream, and mapped when all others are dropped.
#[derive(Clone)]
pub(super) struct ScratchStream(Arc<Mutex<ScratchFile>>);

impl ScratchStream {
    fn file(&self) -> MutexGuard<'_, ScratchFile> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The bytes that were written.
    pub(super) fn into_map(self) -> Result<MappedFile, Error> {
        let file = Arc::into_inner(self.0).expect("the other streams are dropped when reading has ended");
        Ok(file.into_inner().unwrap_or_else(PoisonError::into_inner).into_map()?)
    }
}

impl Write for ScratchStream {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file().write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file().flush()
    }
}
