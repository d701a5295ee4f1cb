//! One run at a time in a folder.

use super::hold::Hold;
use super::temporary::unfinished;
use coface_algebra::{Error, ErrorKind};
use std::fs::{File, OpenOptions};
use std::path::{Path, PathBuf};

/// Says that a run works in a folder, until it is dropped or the process ends.
#[derive(Debug)]
pub struct FolderLock {
    path: PathBuf,
    file: File,
}

/// So often a lock is looked for that another run has just removed.
const ATTEMPTS: usize = 100;

impl FolderLock {
    /// Takes the lock of this name in a folder that is there. On a file system without locks every run gets it.
    ///
    /// # Errors
    /// [`ErrorKind::Io`] when another run has it, or nothing can be written in the folder.
    pub fn take(folder: &Path, name: &str) -> Result<Self, Error> {
        let path = folder.join(name);
        let fault = |error: Error| error.in_file(folder.display().to_string());
        for _ in 0..ATTEMPTS {
            let mut unfinished = unfinished();
            let opened = OpenOptions::new().read(true).write(true).create(true).truncate(false).open(&path);
            let file = opened.map_err(|error| {
                fault(Error::from(error).with_cure("choose a folder that can be written to"))
            })?;
            match Hold::of(&file, &path) {
                Hold::Ours | Hold::Unknown => {
                    unfinished.paths.insert(path.clone());
                    return Ok(Self { path, file });
                }
                Hold::Others => {
                    return Err(fault(
                        Error::new(ErrorKind::Io, "another run works in this folder")
                            .with_cure("wait for it, or name another folder"),
                    ));
                }
                Hold::Gone => {}
            }
        }
        Err(fault(
            Error::new(ErrorKind::Io, "other runs take this folder over and over")
                .with_cure("name another folder"),
        ))
    }
}

impl Drop for FolderLock {
    fn drop(&mut self) {
        let mut unfinished = unfinished();
        unfinished.paths.remove(&self.path);
        // Removed while it is held: who opened it meanwhile sees that it is gone. A lock that stays is taken by the
        // next run.
        let _ = std::fs::remove_file(&self.path);
        // A process that is being started may still share the file, and the lock with it.
        let _ = self.file.unlock();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_run_at_a_time() {
        let folder = tempfile::tempdir().unwrap();
        let lock = FolderLock::take(folder.path(), ".lock").unwrap();
        let error = FolderLock::take(folder.path(), ".lock").unwrap_err().to_string();
        assert!(
            error.ends_with("another run works in this folder; wait for it, or name another folder"),
            "{error}"
        );
        assert!(FolderLock::take(folder.path(), ".other").is_ok());
        drop(lock);
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
        // What a run that was killed has left is taken over.
        std::fs::write(folder.path().join(".lock"), "").unwrap();
        drop(FolderLock::take(folder.path(), ".lock").unwrap());
        assert!(FolderLock::take(&folder.path().join("none"), ".lock").is_err());
    }

    #[test]
    fn many_threads_take_turns() {
        let folder = tempfile::tempdir().unwrap();
        let inside = std::sync::atomic::AtomicUsize::new(0);
        let done = std::sync::atomic::AtomicUsize::new(0);
        use std::sync::atomic::Ordering::SeqCst;
        std::thread::scope(|scope| {
            for _ in 0..4 {
                scope.spawn(|| {
                    while done.load(SeqCst) < 200 {
                        if let Ok(lock) = FolderLock::take(folder.path(), ".lock") {
                            assert_eq!(inside.fetch_add(1, SeqCst), 0, "two have the lock");
                            std::thread::yield_now();
                            inside.fetch_sub(1, SeqCst);
                            done.fetch_add(1, SeqCst);
                            drop(lock);
                        }
                    }
                });
            }
        });
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
    }
}
