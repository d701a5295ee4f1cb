//! Files that appear whole or not at all.

use super::temporary::TemporaryFile;
use crate::counted_stream::{name_of, writing};
use coface_algebra::{Error, ErrorKind};
use std::cell::RefCell;
use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

/// Writes a file by way of a temporary one in its folder, which takes its place when it is complete and stored:
/// nothing half-written is ever left at `path`, and on an error the temporary file is removed and an older file at
/// `path` stays as it was.
///
/// A symbolic link is followed: the file that it points at is replaced. The new file has the permissions of the
/// older one. An older file that may not be written is not replaced. What is no regular file, such as `/dev/stdout`,
/// is written to directly.
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
    let staged = || hold_or_finish(Staged::new(path, write)?, path);
    staged().map_err(|error| error.in_file(path.display().to_string()))
}

thread_local! {
    /// Files that are complete and wait until all others of [`replace_together`] are.
    static HELD: RefCell<Option<Vec<(Staged, PathBuf)>>> = const { RefCell::new(None) };
}

/// Puts a file in its place, or keeps it until the others are complete.
fn hold_or_finish(staged: Staged, path: &Path) -> Result<(), Error> {
    let rest = HELD.with_borrow_mut(|held| match held {
        Some(held) => {
            held.push((staged, path.to_path_buf()));
            None
        }
        None => Some(staged),
    });
    rest.map_or(Ok(()), Staged::finish)
}

/// Does some work; the files that [`replace_file`] writes in this thread meanwhile are put in their places when all of it is done, and
/// none of them when it ends with an error.
///
/// What is no regular file is written to directly. The files are open until then: they should be few.
///
/// # Errors
/// Those of the work; [`ErrorKind::Io`] with the path when a file cannot be put in its place, those before it are then.
///
/// # Examples
/// ```
/// use coface_algebra::Error;
/// use coface_io::{replace_file, replace_together};
/// let path = std::env::temp_dir().join("coface-replace-together.txt");
/// let done: Result<(), Error> = replace_together(|| {
///     replace_file(&path, |out| Ok(out.write_all(b"first")?))?;
///     Err(Error::invalid("the second cannot be made"))
/// });
/// assert!(done.is_err() && !path.exists());
/// ```
pub fn replace_together<T, E: From<Error>>(work: impl FnOnce() -> Result<T, E>) -> Result<T, E> {
    /// Leaves nothing held behind, whatever ends the work.
    struct Holding;
    impl Drop for Holding {
        fn drop(&mut self) {
            HELD.take();
        }
    }
    if HELD.with_borrow(Option::is_some) {
        return work();
    }
    HELD.set(Some(Vec::new()));
    let holding = Holding;
    let done = work()?;
    let held = HELD.take().unwrap_or_default();
    drop(holding);
    for (staged, path) in held {
        staged.finish().map_err(|error| error.in_file(path.display().to_string()))?;
    }
    Ok(done)
}

/// Writes these files as [`replace_file`] does, and replaces none before all of them are complete and stored.
///
/// # Errors
/// As of [`replace_file`].
pub fn replace_files(files: &[(PathBuf, Vec<u8>)]) -> Result<(), Error> {
    let in_path = |path: &Path| {
        let name = path.display().to_string();
        move |error: Error| error.in_file(name)
    };
    let mut staged = Vec::with_capacity(files.len());
    for (path, bytes) in files {
        staged.push(Staged::new(path, |out| Ok(out.write_all(bytes)?)).map_err(in_path(path))?);
    }
    staged
        .into_iter()
        .zip(files)
        .try_for_each(|(staged, (path, _))| hold_or_finish(staged, path).map_err(in_path(path)))
}

/// A file that is complete, but not in its place.
struct Staged {
    /// Nothing where the target was written to directly.
    complete: Option<(TemporaryFile, PathBuf)>,
}

impl Staged {
    fn new(path: &Path, write: impl FnOnce(&mut dyn Write) -> Result<(), Error>) -> Result<Self, Error> {
        let old = fs::metadata(path).ok();
        if old.as_ref().is_some_and(fs::Metadata::is_dir) {
            return Err(Error::new(ErrorKind::Io, "is a directory, not a file to write")
                .with_cure("name a file in it"));
        }
        if old.as_ref().is_some_and(|old| !old.is_file()) || is_stream(path) {
            let file = OpenOptions::new().append(true).open(path)?;
            write_all(path, &file, write)?;
            return Ok(Self { complete: None });
        }
        let target = followed(path)?;
        if let Some(old) = &old {
            check_permissions(&target, old)?;
        }
        if target.file_name().is_none() {
            return Err(Error::new(ErrorKind::Io, "names no file to write"));
        }
        let temporary = TemporaryFile::create_in(folder_of(&target))?;
        write_all(path, temporary.file(), write)?;
        if let Some(old) = old {
            keep_owner(&old, temporary.file());
            temporary.file().set_permissions(old.permissions())?;
        }
        store(temporary.file())?;
        Ok(Self { complete: Some((temporary, target)) })
    }

    fn finish(self) -> Result<(), Error> {
        if let Some((temporary, target)) = self.complete {
            temporary.rename(&target)?;
            store_names_in(folder_of(&target));
        }
        Ok(())
    }
}

/// Looks whether a file that is there may be replaced: to be asked before long work whose result it is to hold.
///
/// # Errors
/// [`ErrorKind::Io`] with the path when it is there, and may not be written.
pub fn check_output(path: &Path) -> Result<(), Error> {
    match fs::metadata(path) {
        Ok(old) if old.is_file() && !is_stream(path) => {
            check_permissions(path, &old).map_err(|error| error.in_file(path.display().to_string()))
        }
        // What is wrong with others is said when they are written.
        _ => Ok(()),
    }
}

/// Who may write in a folder could replace every file in it: the permissions of the file say what is meant.
fn check_permissions(target: &Path, old: &fs::Metadata) -> Result<(), Error> {
    let may_not = || {
        Error::new(ErrorKind::Io, "the file may not be written, so it is not replaced")
            .with_cure("change its permissions, or name another file")
    };
    if old.permissions().readonly() {
        return Err(may_not());
    }
    OpenOptions::new().append(true).open(target).map(drop).map_err(|error| match error.kind() {
        io::ErrorKind::PermissionDenied => may_not(),
        _ => error.into(),
    })
}

fn write_all(
    path: &Path,
    file: &File,
    write: impl FnOnce(&mut dyn Write) -> Result<(), Error>,
) -> Result<(), Error> {
    let mut out = BufWriter::with_capacity(1 << 16, writing(&name_of(path), file));
    let written = write(&mut out).and_then(|()| Ok(out.flush()?));
    if written.is_err() {
        // What was not written is not tried again when the buffer is dropped.
        drop(out.into_parts());
    }
    written
}

/// The folder of a file.
fn folder_of(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// Whether a path names what another program has opened for this one, whatever that is.
fn is_stream(path: &Path) -> bool {
    cfg!(unix)
        && (["/dev/stdout", "/dev/stderr"].iter().any(|name| path == Path::new(name))
            || ["/dev/fd", "/proc"].iter().any(|folder| path.starts_with(folder)))
}

/// No chain of links is longer.
const MOST_LINKS: usize = 40;

/// The file that a path names in the end, which need not be there.
fn followed(path: &Path) -> Result<PathBuf, Error> {
    if let Ok(target) = fs::canonicalize(path) {
        return Ok(target);
    }
    let mut target = path.to_path_buf();
    for _ in 0..MOST_LINKS {
        match fs::read_link(&target) {
            Ok(next) => target = folder_of(&target).join(next),
            Err(_) => return Ok(target),
        }
    }
    Err(Error::new(ErrorKind::Io, "the link leads to links without end").with_cure("name another file"))
}

/// Has the system store the bytes of a file.
fn store(file: &File) -> io::Result<()> {
    match file.sync_all() {
        // Some file systems store at once, and know no such request.
        Err(error) if matches!(error.kind(), io::ErrorKind::Unsupported | io::ErrorKind::InvalidInput) => {
            Ok(())
        }
        stored => stored,
    }
}

/// Has the system store which files are in a folder.
#[cfg(unix)]
fn store_names_in(folder: &Path) {
    // The file is complete and in its place: that the folder may not be read, or has nothing to store, is no fault
    // of it.
    let _ = File::open(folder).and_then(|folder| folder.sync_all());
}

#[cfg(not(unix))]
fn store_names_in(_: &Path) {}

/// Gives the new file the owner and group of the old one, where that is allowed.
#[cfg(unix)]
fn keep_owner(old: &fs::Metadata, new: &File) {
    use std::os::unix::fs::{MetadataExt, fchown};
    let is_other = new.metadata().is_ok_and(|new| (new.uid(), new.gid()) != (old.uid(), old.gid()));
    if is_other && fchown(new, Some(old.uid()), Some(old.gid())).is_err() {
        let _ = fchown(new, None, Some(old.gid()));
    }
}

#[cfg(not(unix))]
fn keep_owner(_: &fs::Metadata, _: &File) {}

#[cfg(test)]
mod tests {
    use super::super::temporary::names;
    use super::*;

    fn old(path: &Path) -> Result<(), Error> {
        replace_file(path, |out| Ok(out.write_all(b"old")?))
    }

    #[test]
    fn a_failed_write_leaves_the_old_file_and_nothing_else() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.txt");
        old(&path).unwrap();
        let failed = replace_file(&path, |out| {
            out.write_all(&[b'x'; 100_000])?;
            Err(Error::invalid("no more"))
        });
        assert!(failed.unwrap_err().to_string().ends_with("a.txt: no more"));
        assert_eq!(fs::read(&path).unwrap(), b"old");
        replace_file(&path, |out| Ok(out.write_all(b"new")?)).unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"new");
        assert_eq!(names(folder.path()), ["a.txt"]);
    }

    #[test]
    fn impossible_targets_are_named() {
        let folder = tempfile::tempdir().unwrap();
        let error = replace_file(folder.path(), |_| Ok(())).unwrap_err().to_string();
        assert!(error.contains("is a directory"), "{error}");
        let error = replace_file(&folder.path().join("no/a.off"), |_| Ok(())).unwrap_err().to_string();
        assert!(error.contains("does not exist; make the folder"), "{error}");
    }

    #[test]
    fn a_file_that_may_not_be_written_is_not_replaced() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.txt");
        old(&path).unwrap();
        let mut permissions = fs::metadata(&path).unwrap().permissions();
        permissions.set_readonly(true);
        fs::set_permissions(&path, permissions.clone()).unwrap();
        let error = replace_file(&path, |_| Ok(())).unwrap_err().to_string();
        assert!(
            error.contains("a.txt: the file may not be written, so it is not replaced; change"),
            "{error}"
        );
        assert_eq!(fs::read(&path).unwrap(), b"old");
        assert_eq!(names(folder.path()), ["a.txt"]);
        #[cfg(unix)]
        {
            // The link may be replaced, but it is the file that is meant.
            let link = folder.path().join("link");
            std::os::unix::fs::symlink("a.txt", &link).unwrap();
            assert!(replace_file(&link, |_| Ok(())).is_err());
            assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        }
    }

    #[cfg(unix)]
    #[test]
    fn links_stay_and_their_files_are_replaced() {
        use std::os::unix::fs::symlink;
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        fs::create_dir(at("deep")).unwrap();
        symlink("deep/a.txt", at("first")).unwrap();
        symlink("first", at("second")).unwrap();
        // The first time there is no file, the second time there is.
        for bytes in [b"one", b"two"] {
            replace_file(&at("second"), |out| Ok(out.write_all(bytes)?)).unwrap();
            assert_eq!(fs::read(at("deep/a.txt")).unwrap(), bytes);
        }
        assert!(["first", "second"].iter().all(|name| fs::symlink_metadata(at(name)).unwrap().is_symlink()));
        symlink("round", at("round")).unwrap();
        assert!(old(&at("round")).is_err());
        assert_eq!((names(folder.path()).len(), names(&at("deep")).len()), (4, 1));
    }

    #[cfg(unix)]
    #[test]
    fn permissions_are_kept() {
        use std::os::unix::fs::PermissionsExt;
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.txt");
        old(&path).unwrap();
        for mode in [0o600, 0o640, 0o755, 0o222] {
            fs::set_permissions(&path, fs::Permissions::from_mode(mode)).unwrap();
            old(&path).unwrap();
            assert_eq!(fs::metadata(&path).unwrap().permissions().mode() & 0o7777, mode);
        }
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn devices_are_written_directly() {
        let error =
            replace_file(Path::new("/dev/full"), |out| Ok(out.write_all(b"a")?)).unwrap_err().to_string();
        assert!(error.starts_with("/dev/full: No space left"), "{error}");
        old(Path::new("/dev/null")).unwrap();
        assert!(!fs::metadata("/dev/null").unwrap().is_file());
    }

    #[test]
    fn several_files_are_replaced_together() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        old(&at("a")).unwrap();
        let files = |last: &str| {
            vec![(at("a"), b"new".to_vec()), (at("b"), b"new".to_vec()), (at(last), b"new".to_vec())]
        };
        assert!(replace_files(&files("no/c")).unwrap_err().to_string().contains("no/c: the folder"));
        assert_eq!(
            (fs::read(at("a")).unwrap(), names(folder.path())),
            (b"old".to_vec(), vec!["a".to_owned()])
        );
        replace_files(&files("c")).unwrap();
        assert_eq!(names(folder.path()), ["a", "b", "c"]);
        assert_eq!(fs::read(at("a")).unwrap(), b"new");
    }

    #[test]
    fn what_the_dead_have_left_is_removed_and_nothing_else() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        let kept = [".coface-short.part", ".coface-abcdefabcdef.part.txt", "coface-abcdefabcdef.part"];
        kept.iter().for_each(|name| fs::write(at(name), "precious").unwrap());
        fs::write(at(".coface-abcdefabcdef.part"), "half").unwrap();
        fs::create_dir(at(".coface-ffffffffffff.part")).unwrap();
        replace_file(&at("a"), |out| {
            // While this one is written another thread cleans up.
            out.write_all(b"a")?;
            let part = fs::read_dir(folder.path())?
                .filter_map(Result::ok)
                .find(|entry| {
                    entry.file_type().is_ok_and(|kind| kind.is_file())
                        && entry.metadata().is_ok_and(|found| found.len() == 0)
                })
                .expect("the file that is being written");
            assert_eq!(
                super::super::hold::Hold::of(&File::open(part.path())?, &part.path()),
                super::super::hold::Hold::Others
            );
            Ok(())
        })
        .unwrap();
        let mut left: Vec<&str> = kept.into_iter().chain(["a", ".coface-ffffffffffff.part"]).collect();
        left.sort_unstable();
        assert_eq!(names(folder.path()), left);
    }
}
