//! Files that a process holds as long as it lives.

use std::fs::{self, File, TryLockError};
use std::path::Path;

/// Whether this handle has the lock of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Hold {
    /// It has.
    Ours,
    /// Another handle has, of this process or another.
    Others,
    /// The file was removed before it was locked.
    Gone,
    /// The file system has no locks.
    Unknown,
}

impl Hold {
    /// Tries to lock a file that was opened by this path. The lock ends with the last copy of the handle, so with
    /// the process at the latest.
    pub(super) fn of(file: &File, path: &Path) -> Self {
        match file.try_lock() {
            Ok(()) if is_at(file, path) => Self::Ours,
            Ok(()) => Self::Gone,
            Err(TryLockError::WouldBlock) => Self::Others,
            Err(TryLockError::Error(_)) => Self::Unknown,
        }
    }

    /// Whether the one who made the file may go on: nobody else removes or takes it.
    pub(super) fn is_good(self) -> bool {
        matches!(self, Self::Ours | Self::Unknown)
    }
}

/// Whether the path still names the file of this handle.
#[cfg(unix)]
fn is_at(file: &File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    match (file.metadata(), fs::symlink_metadata(path)) {
        (Ok(held), Ok(there)) => (held.dev(), held.ino()) == (there.dev(), there.ino()),
        _ => false,
    }
}

#[cfg(not(unix))]
fn is_at(_: &File, path: &Path) -> bool {
    fs::symlink_metadata(path).is_ok()
}

/// Whether both belong to one user.
#[cfg(unix)]
pub(super) fn have_one_owner(a: &fs::Metadata, b: &fs::Metadata) -> bool {
    use std::os::unix::fs::MetadataExt;
    a.uid() == b.uid()
}

#[cfg(not(unix))]
pub(super) fn have_one_owner(_: &fs::Metadata, _: &fs::Metadata) -> bool {
    true
}
