//! Files that are needed while shards are made.

use coface_algebra::Error;
use coface_io::{MadeFolders, TemporaryFolder};
use coface_mapped::{MappedFile, ScratchFile};
use std::io::{self, Write};
use std::path::Path;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// A folder for files that are needed while shards are made.
pub(super) struct Scratch {
    folder: TemporaryFolder,
    /// Removed after it, where nothing else was put into them.
    _made: MadeFolders,
}

impl Scratch {
    /// Makes it in a folder, which is made too.
    pub(super) fn new(folder: &Path) -> Result<Self, Error> {
        let (made, folder) =
            MadeFolders::with(folder, |folder| TemporaryFolder::create_in(folder, ".coface-scratch-"))?;
        Ok(Self { folder, _made: made })
    }

    /// The path of the folder.
    pub(super) fn path(&self) -> &Path {
        self.folder.path()
    }

    /// A nameless file on the file system of the folder.
    pub(super) fn stream(&self) -> Result<ScratchStream, Error> {
        let file = ScratchFile::create_in(self.path())
            .map_err(|error| Error::from(error).in_file(self.path().display().to_string()))?;
        Ok(ScratchStream(Arc::new(Mutex::new(file))))
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

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn folders_that_stay_empty_go_away() {
        let base = tempfile::tempdir().unwrap();
        let deep = base.path().join("a/b/c");
        drop(Scratch::new(&deep).unwrap());
        assert_eq!(fs::read_dir(base.path()).unwrap().count(), 0);
        let made = MadeFolders::of(&deep).unwrap();
        fs::write(base.path().join("a/kept"), "").unwrap();
        drop(made);
        assert!(base.path().join("a/kept").exists() && !base.path().join("a/b").exists());
        // A folder that was there stays, and so does what is in it: a user may have a folder of any name.
        fs::create_dir_all(base.path().join("a/.scratch")).unwrap();
        fs::write(base.path().join("a/.scratch/precious"), "").unwrap();
        drop(Scratch::new(&base.path().join("a")).unwrap());
        assert!(base.path().join("a/.scratch/precious").exists());
    }
}
