//! Whether a file still has the content that it had.

use super::open_regular;
use crate::{Format, ReadOptions, VolumeStream, entry_of};
use coface_algebra::Error;
use std::io::Read;
use std::path::{Path, PathBuf};
use xxhash_rust::xxh3::Xxh3;

/// A number that changes with the bytes of a file and of the files that are read with it: the numbers beside the header of a volume, the
/// nodes beside the elements of TetGen. Of `FILE#3` it is that of the whole file.
///
/// It tells whether results that are kept are still those of the file; it is no protection against somebody who wants to deceive.
///
/// # Errors
/// [`ErrorKind::Io`](coface_algebra::ErrorKind::Io) where a file cannot be read;
/// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for what is no regular file.
///
/// # Complexity
/// Linear in the bytes of the files, at the speed of reading; 256 KiB of memory.
///
/// # References
/// Y. Collet, *xxHash: XXH3, 128 bits* (2019).
///
/// # Examples
/// ```
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let path = std::env::temp_dir().join("coface-content-hash.off");
/// std::fs::write(&path, "OFF")?;
/// let options = coface_io::ReadOptions::new();
/// let before = coface_io::content_hash(&path, &options)?;
/// std::fs::write(&path, "off")?;
/// assert_ne!(coface_io::content_hash(&path, &options)?, before);
/// # std::fs::remove_file(&path)?;
/// # Ok(()) }
/// ```
pub fn content_hash(path: impl AsRef<Path>, options: &ReadOptions) -> Result<u128, Error> {
    let path = path.as_ref();
    let whole = if path.exists() { path } else { entry_of(path).map_or(path, |(file, _)| file) };
    let mut hash = Xxh3::new();
    let mut bytes = vec![0; 1 << 18];
    for file in files_read(whole, options) {
        let in_file = |error: std::io::Error| Error::from(error).in_file(file.display().to_string());
        let mut input = open_regular(&file).map_err(|error| error.in_file(file.display().to_string()))?;
        loop {
            match input.read(&mut bytes).map_err(in_file)? {
                0 => break,
                count => hash.update(&bytes[..count]),
            }
        }
        // Where one file ends and the next begins is a part of the content.
        hash.update(&input.metadata().map_err(in_file)?.len().to_le_bytes());
    }
    Ok(hash.digest128())
}

/// The file, and those that are read with it.
fn files_read(path: &Path, options: &ReadOptions) -> Vec<PathBuf> {
    let extension = path.extension().map(|extension| extension.to_ascii_lowercase());
    let format = match extension.as_deref().and_then(|extension| extension.to_str()) {
        Some("nhdr" | "nrrd") => Format::Nrrd,
        Some("mha" | "mhd") => Format::MetaImage,
        Some("hdr" | "img" | "nii") => Format::Nifti,
        Some("ele" | "face" | "edge") => {
            let nodes = path.with_extension("node");
            let is_there = nodes.is_file();
            return [path.to_owned()].into_iter().chain(is_there.then_some(nodes)).collect();
        }
        _ => return vec![path.to_owned()],
    };
    match VolumeStream::open_with(path, format, options.allow_outside) {
        Ok(stream) => stream.files().to_vec(),
        // What is wrong with it is said where it is read.
        Err(_) => vec![path.to_owned()],
    }
}

#[cfg(test)]
mod tests {
    use crate::ReadOptions;
    use std::fs;
    use std::path::Path;

    fn content_hash(path: impl AsRef<Path>) -> Result<u128, coface_algebra::Error> {
        super::content_hash(path, &ReadOptions::new())
    }

    #[test]
    fn companions_count() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        fs::write(
            at("a.nhdr"),
            "NRRD0001\ntype: uint8\ndimension: 1\nsizes: 2\nencoding: raw\ndata file: other.raw\n\n",
        )
        .unwrap();
        fs::write(at("other.raw"), [1, 2]).unwrap();
        fs::write(at("m.ele"), "1 4 0\n1 1 2 3 4\n").unwrap();
        fs::write(at("m.node"), "4 3 0 0\n").unwrap();
        fs::write(at("m.raw"), "not read").unwrap();
        for (header, companion) in [("a.nhdr", "other.raw"), ("m.ele", "m.node")] {
            let before = content_hash(at(header)).unwrap();
            assert_eq!(content_hash(at(header)).unwrap(), before);
            fs::write(at("m.raw"), header).unwrap();
            assert_eq!(content_hash(at(header)).unwrap(), before, "{header} is not read with m.raw");
            fs::write(at(companion), [9, 9]).unwrap();
            assert_ne!(content_hash(at(header)).unwrap(), before, "{header} is read with {companion}");
        }
        assert_eq!(content_hash(at("m.ele#2")).unwrap(), content_hash(at("m.ele")).unwrap());
        assert!(content_hash(at("none")).unwrap_err().to_string().contains("none"));
    }
}
