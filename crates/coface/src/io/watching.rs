//! How far reading has come.

use std::io::Read;
use std::sync::atomic::{AtomicU64, Ordering};

/// How many bytes of the file that is being read have been taken, for whoever shows it in another thread.
///
/// # Examples
/// ```
/// use coface::io::{self, ReadOptions, ReadProgress};
/// # fn main() -> Result<(), coface::Error> {
/// static PROGRESS: ReadProgress = ReadProgress::new();
/// let path = std::env::temp_dir().join("coface-read-progress.json");
/// std::fs::write(&path, "[[0, 1, 2]]")?;
/// let mut options = ReadOptions::default();
/// options.progress = Some(&PROGRESS);
/// io::read_path_with(&path, &options)?;
/// assert_eq!((PROGRESS.done(), PROGRESS.total()), (11, 11));
/// # std::fs::remove_file(&path)?;
/// # Ok(()) }
/// ```
#[derive(Debug, Default)]
pub struct ReadProgress {
    done: AtomicU64,
    total: AtomicU64,
}

impl ReadProgress {
    /// Nothing is being read.
    pub const fn new() -> Self {
        Self { done: AtomicU64::new(0), total: AtomicU64::new(0) }
    }

    /// The bytes that have been taken from the file.
    pub fn done(&self) -> u64 {
        self.done.load(Ordering::Relaxed)
    }

    /// The bytes of the whole file; 0 before there is one.
    pub fn total(&self) -> u64 {
        self.total.load(Ordering::Relaxed)
    }

    fn start(&self, total: u64) {
        self.done.store(0, Ordering::Relaxed);
        self.total.store(total, Ordering::Relaxed);
    }
}

/// A stream whose bytes are counted.
pub(super) struct Watched<R> {
    input: R,
    progress: Option<&'static ReadProgress>,
}

impl<R> Watched<R> {
    pub(super) fn new(input: R, total: u64, progress: Option<&'static ReadProgress>) -> Self {
        if let Some(progress) = progress {
            progress.start(total);
        }
        Self { input, progress }
    }
}

impl<R: Read> Read for Watched<R> {
    fn read(&mut self, bytes: &mut [u8]) -> std::io::Result<usize> {
        let count = self.input.read(bytes)?;
        if let Some(progress) = self.progress {
            progress.done.fetch_add(count as u64, Ordering::Relaxed);
        }
        Ok(count)
    }
}
