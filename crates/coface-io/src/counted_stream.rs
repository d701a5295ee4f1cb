//! Streams whose bytes count as progress.

use coface_algebra::progress::{Steps, stage_of_bytes};
use coface_algebra::{Error, ErrorKind, escaped};
use std::fs::File;
use std::io::{Read, Write};
use std::path::Path;

/// A stream whose bytes are counted as the progress of a stage.
pub(super) struct CountedStream<S> {
    stream: S,
    steps: Steps,
}

/// Begins to read a stream of so many bytes, 0 where the length is unknown. The name may have any character.
pub(super) fn reading<R: Read>(name: &str, stream: R, total: u64) -> CountedStream<R> {
    CountedStream { stream, steps: stage_of_bytes(&format!("reading {}", escaped(name)), total) }
}

/// Begins to write a stream.
pub(super) fn writing<W: Write>(name: &str, stream: W) -> CountedStream<W> {
    CountedStream { stream, steps: stage_of_bytes(&format!("writing {}", escaped(name)), 0) }
}

/// The name of a file without its folder.
pub(super) fn name_of(path: &Path) -> String {
    path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned()
}

/// A stage never takes more bytes than this at once, so that it can be stopped.
const PIECE: usize = 1 << 20;

impl<R: Read> Read for CountedStream<R> {
    fn read(&mut self, bytes: &mut [u8]) -> std::io::Result<usize> {
        let most = bytes.len().min(PIECE);
        let count = self.stream.read(&mut bytes[..most])?;
        self.steps.advance(count);
        Ok(count)
    }
}

impl<W: Write> Write for CountedStream<W> {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        let count = self.stream.write(&bytes[..bytes.len().min(PIECE)])?;
        self.steps.advance(count);
        Ok(count)
    }

    fn flush(&mut self) -> std::io::Result<()> {
        self.stream.flush()
    }
}

/// Opens a file to read it.
///
/// # Errors
/// [`ErrorKind::Io`] for what is not there, is no file, or may not be read.
pub(crate) fn open(path: &Path) -> Result<File, Error> {
    // Some systems say of a directory that it may not be read.
    if path.is_dir() {
        return Err(Error::new(ErrorKind::Io, "is a directory, not a file").with_cure("name a file in it"));
    }
    let fault = |error: &std::io::Error| match error.kind() {
        std::io::ErrorKind::NotFound => {
            Error::new(ErrorKind::Io, "there is no such file").with_cure("check the path")
        }
        std::io::ErrorKind::PermissionDenied => Error::new(ErrorKind::Io, "the file may not be read")
            .with_cure("change its permissions, or copy it"),
        _ => Error::new(ErrorKind::Io, format!("the file cannot be opened: {error}"))
            .with_cure("check the path"),
    };
    File::open(path).map_err(|error| fault(&error))
}
