//! Files that appear together.

use super::{TemporaryFolder, check_output, replace_file};
use coface_algebra::Error;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

/// Files of one run that appear together: each is written when it is known, into a folder beside its place, and none is in its place
/// before all of them are complete. Dropped before that they leave nothing behind.
///
/// # Examples
/// ```
/// use coface_io::StagedFiles;
/// use std::io::Write;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let target = std::env::temp_dir().join("coface-staged-1.txt");
/// let mut files = StagedFiles::beside(&target)?;
/// files.write(&target, |out| Ok(writeln!(out, "first")?))?;
/// assert!(!target.exists());
/// files.finish()?;
/// assert_eq!(std::fs::read(&target)?, b"first\n");
/// # std::fs::remove_file(&target)?;
/// # Ok(()) }
/// ```
pub struct StagedFiles {
    folder: TemporaryFolder,
    targets: Vec<PathBuf>,
}

impl std::fmt::Debug for StagedFiles {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.debug_struct("StagedFiles").field("targets", &self.targets).finish_non_exhaustive()
    }
}

impl StagedFiles {
    /// No files yet, in the folder of this path.
    ///
    /// # Errors
    /// [`ErrorKind::Io`](coface_algebra::ErrorKind::Io) if nothing can be made in that folder.
    ///
    /// # Examples
    /// ```
    /// let folder = std::env::temp_dir();
    /// assert!(coface_io::StagedFiles::beside(&folder.join("frame-001.svg")).is_ok());
    /// assert!(coface_io::StagedFiles::beside(&folder.join("no/such/frame-001.svg")).is_err());
    /// ```
    pub fn beside(path: &Path) -> Result<Self, Error> {
        let folder = match path.parent() {
            Some(folder) if !folder.as_os_str().is_empty() => folder,
            _ => Path::new("."),
        };
        let folder = TemporaryFolder::create_in(folder, ".coface-staged-");
        let folder = folder.map_err(|error| error.in_file(path.display().to_string()))?;
        Ok(Self { folder, targets: Vec::new() })
    }

    /// Writes the file that will be at `target`.
    ///
    /// # Errors
    /// [`ErrorKind::Io`](coface_algebra::ErrorKind::Io) with the target when the file cannot be written, or the one that is there may not be
    /// replaced; the errors of `write`.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let target = std::env::temp_dir().join("coface-staged-2.txt");
    /// let mut files = coface_io::StagedFiles::beside(&target)?;
    /// files.write(&target, |out| Ok(out.write_all(b"of no use")?))?;
    /// drop(files);
    /// assert!(!target.exists());
    /// # Ok(()) }
    /// ```
    pub fn write(
        &mut self,
        target: &Path,
        write: impl FnOnce(&mut dyn Write) -> Result<(), Error>,
    ) -> Result<(), Error> {
        let staged = || {
            check_output(target)?;
            let mut out = BufWriter::with_capacity(1 << 16, File::create_new(self.path(self.targets.len()))?);
            write(&mut out)?;
            Ok(out.flush()?)
        };
        staged().map_err(|error: Error| error.in_file(target.display().to_string()))?;
        self.targets.push(target.to_path_buf());
        Ok(())
    }

    /// Puts all files in their places, in the order in which they were written.
    ///
    /// # Errors
    /// Those of [`replace_file`]; the files before the one with the error are in their places then.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let target = std::env::temp_dir().join("coface-staged-3.txt");
    /// let mut files = coface_io::StagedFiles::beside(&target)?;
    /// files.write(&target, |out| Ok(out.write_all(b"whole")?))?;
    /// files.finish()?;
    /// assert_eq!(std::fs::read(&target)?, b"whole");
    /// # std::fs::remove_file(&target)?;
    /// # Ok(()) }
    /// ```
    pub fn finish(self) -> Result<(), Error> {
        for (number, target) in self.targets.iter().enumerate() {
            let staged = self.path(number);
            // A copy, so that a file keeps its owner and its permissions, and a link stays one.
            replace_file(target, |out| Ok(io::copy(&mut File::open(&staged)?, out).map(|_| ())?))?;
            fs::remove_file(staged)?;
        }
        Ok(())
    }

    fn path(&self, number: usize) -> PathBuf {
        self.folder.path().join(number.to_string())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_algebra::ErrorKind;

    fn names(folder: &Path) -> Vec<String> {
        let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name());
        let mut names: Vec<String> = entries.map(|name| name.into_string().unwrap()).collect();
        names.sort();
        names
    }

    #[test]
    fn files_appear_together_or_not_at_all() {
        let folder = tempfile::tempdir().unwrap();
        let at = |number: usize| folder.path().join(format!("{number:04}"));
        fs::write(at(0), "old").unwrap();
        let mut files = StagedFiles::beside(&at(0)).unwrap();
        // More than a process may have open.
        for number in 0..2000 {
            files.write(&at(number), |out| Ok(write!(out, "{number}")?)).unwrap();
            assert_eq!(names(folder.path()).len(), 2);
        }
        let fault = |_: &mut dyn Write| Err(Error::new(ErrorKind::InvalidInput, "no text"));
        assert!(files.write(&at(2000), fault).unwrap_err().to_string().contains("2000: no text"));
        drop(files);
        assert_eq!(
            (names(folder.path()), fs::read(at(0)).unwrap()),
            (vec!["0000".to_owned()], b"old".to_vec())
        );
        let mut files = StagedFiles::beside(&at(0)).unwrap();
        for number in 0..3 {
            files.write(&at(number), |out| Ok(write!(out, "{number}")?)).unwrap();
        }
        files.finish().unwrap();
        assert_eq!(names(folder.path()), ["0000", "0001", "0002"]);
        assert_eq!([0, 2].map(|number| fs::read(at(number)).unwrap()), [b"0", b"2"]);
    }
}
