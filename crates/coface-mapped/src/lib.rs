//! Files seen as memory: the system reads pages as they are looked at and drops them again when memory is short, so that a file may be larger
//! than memory.
//!
//! This crate is one unsafe call and what must hold for it; see [`MappedFile`].

use memmap2::Mmap;
use std::fs::File;
use std::io;
use std::ops::Deref;
use std::path::Path;

/// A file as a slice of bytes.
///
/// # What must hold
/// Nobody changes or shortens the file while it is mapped. Files that coface writes for itself are made under another name and renamed when
/// they are complete, so a newer one takes the place of the older without touching its bytes; that stays mapped as it was. What is mapped is
/// read only after its checksum was compared. A file that somebody else shortens meanwhile ends the program by a signal, never with wrong
/// bytes of another process.
///
/// # Examples
/// ```
/// use coface_mapped::MappedFile;
/// # fn main() -> std::io::Result<()> {
/// let path = std::env::temp_dir().join("coface-mapped-file.bin");
/// std::fs::write(&path, [1, 2, 3])?;
/// assert_eq!(MappedFile::open(&path)?[..], [1, 2, 3]);
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
    /// # Errors
    /// Where it cannot be opened or mapped, and for what is no regular file.
    ///
    /// # Complexity
    /// Constant: pages are read when they are looked at.
    pub fn open(path: impl AsRef<Path>) -> io::Result<Self> {
        let file = File::open(path)?;
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
        // SAFETY: the bytes do not change while they are mapped: see "What must hold" above.
        let map = unsafe { Mmap::map(&file) }?;
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

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]
    use super::*;

    #[test]
    fn empty_files_and_folders() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("empty");
        std::fs::write(&path, b"").unwrap();
        assert!(MappedFile::open(&path).unwrap().is_empty());
        assert!(MappedFile::open(folder.path()).is_err());
        assert_eq!(MappedFile::open(folder.path().join("none")).unwrap_err().kind(), io::ErrorKind::NotFound);
    }

    #[test]
    fn a_renamed_file_leaves_the_map_as_it_was() {
        let folder = tempfile::tempdir().unwrap();
        let (path, newer) = (folder.path().join("a"), folder.path().join("b"));
        std::fs::write(&path, vec![7; 10_000]).unwrap();
        let map = MappedFile::open(&path).unwrap();
        std::fs::write(&newer, b"short").unwrap();
        std::fs::rename(&newer, &path).unwrap();
        assert_eq!(map[..], vec![7; 10_000]);
        assert_eq!(MappedFile::open(&path).unwrap()[..], b"short"[..]);
    }
}
