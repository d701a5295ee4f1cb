//! Files that appear whole or not at all.

use super::counted_stream::{name_of, writing};
use coface_algebra::{Error, ErrorKind};
use std::fs::{self, File, OpenOptions};
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// The temporary files that are there now. Files are made and renamed under this lock.
static UNFINISHED: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

fn unfinished() -> MutexGuard<'static, Vec<PathBuf>> {
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Removes the temporary files that [`replace_file`] is writing in other threads, and lets no other be made or finished: for a program that
/// is about to end before its work is done, when its user interrupts it. Whoever writes a file afterwards waits for ever.
///
/// # Examples
/// ```no_run
/// // In what is called when the user interrupts:
/// coface_io::abandon_files();
/// std::process::exit(130);
/// ```
pub fn abandon_files() {
    let files = unfinished();
    for path in files.iter() {
        // What cannot be removed stays; there is nobody to tell any more.
        let _ = fs::remove_file(path);
    }
    std::mem::forget(files);
}

/// Writes a file by way of a temporary one beside it, which takes its place when it is complete: nothing half-written
/// is ever left at `path`, and on an error the temporary file is removed and an older file at `path` stays as it was.
///
/// What is no regular file, such as `/dev/stdout`, is written to directly.
///
/// # Errors
/// [`ErrorKind::Io`] with the path when a file cannot be made or written; the errors of `write`.
///
/// # Examples
/// ```
/// use std::io::Write;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let folder = std::env::temp_dir();
/// let path = folder.join("coface-replace-file.txt");
/// coface_io::replace_file(&path, |out| Ok(writeln!(out, "whole")?))?;
/// assert_eq!(std::fs::read(&path)?, b"whole\n");
/// std::fs::remove_file(&path)?;
/// # Ok(()) }
/// ```
pub fn replace_file(
    path: &Path,
    write: impl FnOnce(&mut dyn Write) -> Result<(), Error>,
) -> Result<(), Error> {
    replace(path, write).map_err(|error| error.in_file(path.display().to_string()))
}

fn replace(path: &Path, write: impl FnOnce(&mut dyn Write) -> Result<(), Error>) -> Result<(), Error> {
    // A link is followed, so that it is its target that is replaced.
    let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_path_buf());
    let old = fs::metadata(&target).ok();
    if old.as_ref().is_some_and(fs::Metadata::is_dir) {
        return Err(
            Error::new(ErrorKind::Io, "is a directory, not a file to write").with_cure("name a file in it")
        );
    }
    if old.as_ref().is_some_and(|old| !old.is_file()) {
        return write_all(&target, OpenOptions::new().write(true).open(&target)?, write);
    }
    let (temporary, file) = Temporary::beside(&target)?;
    write_all(&target, file, write)?;
    if let Some(old) = old {
        fs::set_permissions(&temporary.path, old.permissions())?;
    }
    temporary.rename(&target)
}

fn write_all(
    path: &Path,
    file: File,
    write: impl FnOnce(&mut dyn Write) -> Result<(), Error>,
) -> Result<(), Error> {
    let mut out = BufWriter::with_capacity(1 << 16, writing(&name_of(path), file));
    write(&mut out)?;
    out.flush()?;
    Ok(())
}

/// A file that is removed unless it is renamed.
struct Temporary {
    path: PathBuf,
    renamed: bool,
}

impl Temporary {
    /// Makes a new file in the folder of `target`, so that a rename stays within one file system.
    fn beside(target: &Path) -> Result<(Self, File), Error> {
        let Some(name) = target.file_name() else {
            return Err(Error::new(ErrorKind::Io, "names no file to write"));
        };
        for attempt in 0..1000 {
            let mut hidden = std::ffi::OsString::from(".");
            hidden.push(name);
            hidden.push(format!(".{}-{attempt}.part", std::process::id()));
            let path = target.with_file_name(hidden);
            let mut unfinished = unfinished();
            match OpenOptions::new().write(true).create_new(true).open(&path) {
                Ok(file) => {
                    unfinished.push(path.clone());
                    return Ok((Self { path, renamed: false }, file));
                }
                Err(error) if error.kind() == std::io::ErrorKind::AlreadyExists => {}
                Err(error) if error.kind() == std::io::ErrorKind::NotFound => {
                    return Err(Error::new(ErrorKind::Io, "the folder to write to does not exist")
                        .with_cure("make the folder first, or name another"));
                }
                Err(error) => {
                    return Err(Error::from(error).with_cure("choose a folder that can be written to"));
                }
            }
        }
        Err(Error::new(ErrorKind::Io, "no temporary file can be made beside the target")
            .with_cure("remove the .part files of earlier runs"))
    }

    fn rename(mut self, target: &Path) -> Result<(), Error> {
        let mut unfinished = unfinished();
        fs::rename(&self.path, target)?;
        unfinished.retain(|path| *path != self.path);
        self.renamed = true;
        Ok(())
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        if !self.renamed {
            let mut unfinished = unfinished();
            unfinished.retain(|path| *path != self.path);
            // The file is of no use; if it cannot be removed there is nothing better to do.
            let _ = fs::remove_file(&self.path);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_failed_write_leaves_the_old_file_and_nothing_else() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.txt");
        replace_file(&path, |out| Ok(out.write_all(b"old")?)).unwrap();
        let failed = replace_file(&path, |out| {
            out.write_all(&[b'x'; 100_000])?;
            Err(Error::invalid("no more"))
        });
        assert!(failed.unwrap_err().to_string().ends_with("a.txt: no more"));
        assert_eq!(fs::read(&path).unwrap(), b"old");
        replace_file(&path, |out| Ok(out.write_all(b"new")?)).unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"new");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[test]
    fn impossible_targets_are_named() {
        let folder = tempfile::tempdir().unwrap();
        let error = replace_file(folder.path(), |_| Ok(())).unwrap_err().to_string();
        assert!(error.contains("is a directory"), "{error}");
        let error = replace_file(&folder.path().join("no/a.off"), |_| Ok(())).unwrap_err().to_string();
        assert!(error.contains("does not exist; make the folder"), "{error}");
    }
}
