//! Files seen as memory: the system reads pages as they are looked at and drops them again when memory is short, so that a file may be larger
//! than memory.
//!
//! # Words
//! * A [`MappedFile`] is the bytes of a file. Mapping one is unsafe, because bytes that are mapped are memory that other programs can change.
//! * A [`ScratchFile`] has no name, so no other program can open it. It is written, then mapped: that is safe.
//!
//! # What happens when another process changes a mapped file
//! * It shortens the file: a look at a page behind the new end raises the signal SIGBUS (an exception of structured handling on Windows, where
//!   the system refuses to shorten a mapped file at all), and the program ends. No wrong bytes are seen, and nothing can be caught.
//! * It overwrites the file: the bytes of a slice change while the slice is borrowed, which is undefined behavior.
//! * It replaces the file by renaming another one: the map stays as it was.
//!
//! Files that other programs can open are therefore read into memory elsewhere in this library, and only scratch files are mapped.

use memmap2::Mmap;
use std::fs::File;
use std::io::{self, Write};
use std::ops::Deref;
use std::path::Path;

/// A file as a slice of bytes.
///
/// # Examples
/// ```
/// use coface_mapped::MappedFile;
/// # fn main() -> std::io::Result<()> {
/// let path = std::env::temp_dir().join("coface-mapped-file.bin");
/// std::fs::write(&path, [1, 2, 3])?;
/// // SAFETY: nobody else knows the file.
/// let map = unsafe { MappedFile::open(&path) }?;
/// assert_eq!(map[..], [1, 2, 3]);
/// # std::fs::remove_file(&path)
/// # }
/// ```
#[derive(Debug)]
pub struct MappedFile {
    /// Nothing for an empty file, which the system does not map.
    map: Option<Mmap>,
}

impl MappedFile {
    /// Maps a regular file for reading.
    ///
    /// # Safety
    /// As long as the map exists, no program, this one included, changes the bytes of the file or shortens it. Another file may take its
    /// place by a rename, and the file may be removed. The first page of the crate says what happens otherwise.
    ///
    /// # Errors
    /// Those of the system where the file cannot be opened or mapped; `InvalidInput` for what is no regular file.
    ///
    /// # Complexity
    /// Constant: pages are read when they are looked at.
    ///
    /// # Examples
    /// ```
    /// use coface_mapped::MappedFile;
    /// // SAFETY: there is no such file.
    /// assert!(unsafe { MappedFile::open("no such file") }.is_err());
    /// ```
    pub unsafe fn open(path: impl AsRef<Path>) -> io::Result<Self> {
        // SAFETY: the caller vouches for the file.
        unsafe { Self::of(&File::open(path)?) }
    }

    /// # Safety
    /// As of [`Self::open`].
    unsafe fn of(file: &File) -> io::Result<Self> {
        let metadata = file.metadata()?;
        if !metadata.is_file() {
            return Err(io::Error::new(
                io::ErrorKind::InvalidInput,
                "is no regular file, so it cannot be mapped",
            ));
        }
        if metadata.len() == 0 {
            return Ok(Self { map: None });
        }
        // SAFETY: the caller vouches that the bytes do not change while they are mapped.
        let map = unsafe { Mmap::map(file) }?;
        Ok(Self { map: Some(map) })
    }
}

impl Deref for MappedFile {
    type Target = [u8];

    fn deref(&self) -> &[u8] {
        self.map.as_deref().unwrap_or_default()
    }
}

impl AsRef<[u8]> for MappedFile {
    fn as_ref(&self) -> &[u8] {
        self
    }
}

/// A file without a name, to be written and then mapped. The system removes it when it is dropped, or when the program ends.
///
/// # Examples
/// ```
/// use coface_mapped::ScratchFile;
/// use std::io::Write;
/// # fn main() -> std::io::Result<()> {
/// let mut file = ScratchFile::create_in(std::env::temp_dir())?;
/// file.write_all(&[1, 2, 3])?;
/// assert_eq!(file.into_map()?[..], [1, 2, 3]);
/// # Ok(()) }
/// ```
#[derive(Debug)]
pub struct ScratchFile {
    file: File,
}

impl ScratchFile {
    /// An empty file on the file system of this folder.
    ///
    /// # Errors
    /// Those of the system.
    ///
    /// # Examples
    /// ```
    /// use coface_mapped::ScratchFile;
    /// # fn main() -> std::io::Result<()> {
    /// assert!(ScratchFile::create_in(std::env::temp_dir())?.into_map()?.is_empty());
    /// assert!(ScratchFile::create_in("no such folder").is_err());
    /// # Ok(()) }
    /// ```
    pub fn create_in(folder: impl AsRef<Path>) -> io::Result<Self> {
        Ok(Self { file: tempfile::tempfile_in(folder)? })
    }

    /// The bytes that were written, seen as memory. They can be changed no more.
    ///
    /// # Errors
    /// Those of the system where the file cannot be mapped.
    ///
    /// # Examples
    /// ```
    /// use coface_mapped::ScratchFile;
    /// use std::io::Write;
    /// # fn main() -> std::io::Result<()> {
    /// let mut file = ScratchFile::create_in(std::env::temp_dir())?;
    /// file.write_all(b"bytes")?;
    /// assert_eq!(file.into_map()?.as_ref(), b"bytes");
    /// # Ok(()) }
    /// ```
    pub fn into_map(self) -> io::Result<MappedFile> {
        // SAFETY: the file has no name, so that no other program opens it, and the only handle to it ends here.
        unsafe { MappedFile::of(&self.file) }
    }
}

impl Write for ScratchFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]
    use super::*;

    fn open(path: impl AsRef<Path>) -> io::Result<MappedFile> {
        // SAFETY: the tests only replace their files.
        unsafe { MappedFile::open(path) }
    }

    #[test]
    fn empty_files_and_folders() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("empty");
        std::fs::write(&path, b"").unwrap();
        assert!(open(&path).unwrap().is_empty());
        assert!(open(folder.path()).is_err());
        assert_eq!(open(folder.path().join("none")).unwrap_err().kind(), io::ErrorKind::NotFound);
    }

    #[test]
    fn a_renamed_file_leaves_the_map_as_it_was() {
        let folder = tempfile::tempdir().unwrap();
        let (path, newer) = (folder.path().join("a"), folder.path().join("b"));
        std::fs::write(&path, vec![7; 10_000]).unwrap();
        let map = open(&path).unwrap();
        std::fs::write(&newer, b"short").unwrap();
        std::fs::rename(&newer, &path).unwrap();
        assert_eq!(map[..], vec![7; 10_000]);
        assert_eq!(open(&path).unwrap()[..], b"short"[..]);
    }

    #[test]
    fn a_scratch_file_leaves_nothing_in_its_folder() {
        let folder = tempfile::tempdir().unwrap();
        let mut file = ScratchFile::create_in(folder.path()).unwrap();
        file.write_all(&vec![7; 100_000]).unwrap();
        let map = file.into_map().unwrap();
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
        assert_eq!(map[..], vec![7; 100_000]);
    }
}
