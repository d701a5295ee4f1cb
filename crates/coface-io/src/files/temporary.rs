//! Files and folders that go with a run.

use super::hold::{Hold, have_one_owner};
use coface_algebra::{Error, ErrorKind};
use std::collections::BTreeSet;
use std::fs::{self, File, OpenOptions};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;

/// What is there now and goes away. Files and folders are made, renamed and removed under this lock.
static UNFINISHED: Mutex<Unfinished> =
    Mutex::new(Unfinished { paths: BTreeSet::new(), made: BTreeSet::new() });

pub(super) struct Unfinished {
    /// Files, and folders with all that is in them.
    pub(super) paths: BTreeSet<PathBuf>,
    /// Folders that go where they are empty.
    made: BTreeSet<PathBuf>,
}

pub(super) fn unfinished() -> MutexGuard<'static, Unfinished> {
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Removes the temporary files and folders of this process, those that [`replace_file`](crate::replace_file) is
/// writing in other threads among them, and lets no other be made or finished: for a program that is about to end
/// before its work is done, when its user interrupts it. Whoever writes a file afterwards waits for ever.
///
/// # Examples
/// ```no_run
/// // In what is called when the user interrupts:
/// coface_io::abandon_files();
/// std::process::exit(130);
/// ```
pub fn abandon_files() {
    let unfinished = unfinished();
    for path in &unfinished.paths {
        // What cannot be removed is removed by the next run.
        if path.is_dir() {
            remove_folder(path, None);
        } else {
            let _ = fs::remove_file(path);
        }
    }
    // A folder stands before those in it.
    for folder in unfinished.made.iter().rev() {
        let _ = fs::remove_dir(folder);
    }
    std::mem::forget(unfinished);
}

/// How temporary files beside their targets are named: nothing else may be, since they are removed when nobody holds
/// them.
const BEFORE: &str = ".coface-";
const BEHIND: &str = ".part";
/// The file in a temporary folder that its process holds.
const OWNER: &str = ".coface-owner";
/// So many random letters and digits are in a name.
const LETTERS: usize = 12;
/// So often a name is tried.
const ATTEMPTS: usize = 100;
/// After so many faults a folder is not to blame.
const SURE: usize = 4;

/// A file that is removed unless it is renamed.
pub(super) struct TemporaryFile {
    path: PathBuf,
    file: File,
    is_renamed: bool,
}

impl TemporaryFile {
    /// Makes a new file in a folder. Those that processes have left that are dead are removed, once in the life of
    /// this process.
    pub(super) fn create_in(folder: &Path) -> Result<Self, Error> {
        for _ in 0..ATTEMPTS {
            let mut unfinished = unfinished();
            let made = tempfile::Builder::new()
                .prefix(BEFORE)
                .suffix(BEHIND)
                .rand_bytes(LETTERS)
                .make_in(folder, |path| OpenOptions::new().write(true).create_new(true).open(path));
            let (file, path) = made.and_then(|made| Ok(made.keep()?)).map_err(|error| unmade(&error))?;
            // It is known before anything else is asked of it: whoever abandons files meanwhile removes it.
            unfinished.paths.insert(path.clone());
            let hold = Hold::of(&file, &path);
            let made = Self { path, file, is_renamed: false };
            if hold.is_good() {
                drop(unfinished);
                made.remove_abandoned(folder);
                return Ok(made);
            }
            drop(unfinished);
        }
        Err(Error::new(ErrorKind::Io, "no temporary file can be made beside the target")
            .with_cure("name another folder"))
    }

    /// What is to be written.
    pub(super) fn file(&self) -> &File {
        &self.file
    }

    /// Puts the file in this place.
    pub(super) fn rename(mut self, target: &Path) -> io::Result<()> {
        let mut unfinished = unfinished();
        fs::rename(&self.path, target)?;
        unfinished.paths.remove(&self.path);
        self.is_renamed = true;
        Ok(())
    }

    /// Removes the files of dead processes.
    fn remove_abandoned(&self, folder: &Path) {
        static SEEN: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());
        let (Ok(own), Ok(folder)) = (self.file.metadata(), folder.canonicalize()) else { return };
        if !SEEN.lock().unwrap_or_else(PoisonError::into_inner).insert(folder.clone()) {
            return;
        }
        let Ok(entries) = fs::read_dir(folder) else { return };
        for entry in entries.filter_map(Result::ok) {
            let name = entry.file_name();
            let is_named = name.to_str().is_some_and(|name| {
                let letters = name.strip_prefix(BEFORE).and_then(|rest| rest.strip_suffix(BEHIND));
                letters.is_some_and(|letters| letters.len() == LETTERS)
            });
            // The file itself is looked at, not what a link points at.
            let is_ours = || {
                fs::symlink_metadata(entry.path())
                    .is_ok_and(|found| found.is_file() && have_one_owner(&found, &own))
            };
            if is_named
                && is_ours()
                && let Ok(file) = File::open(entry.path())
                && Hold::of(&file, &entry.path()) == Hold::Ours
            {
                let _ = fs::remove_file(entry.path());
            }
        }
    }
}

impl Drop for TemporaryFile {
    fn drop(&mut self) {
        if !self.is_renamed {
            let mut unfinished = unfinished();
            unfinished.paths.remove(&self.path);
            // The file is of no use; if it cannot be removed the next run does it.
            let _ = fs::remove_file(&self.path);
        }
    }
}

/// Why nothing can be made in a folder.
fn unmade(error: &io::Error) -> Error {
    match error.kind() {
        io::ErrorKind::NotFound => Error::new(ErrorKind::Io, "the folder to write to does not exist")
            .with_cure("make the folder first, or name another"),
        // The one who made the name says it with the whole path; the system's own words are behind that.
        kind => {
            let code =
                error.get_ref().and_then(|said| said.source()?.downcast_ref::<io::Error>()?.raw_os_error());
            let cause =
                code.or(error.raw_os_error()).map_or(io::Error::from(kind), io::Error::from_raw_os_error);
            Error::from(cause).with_cure("choose a folder that can be written to")
        }
    }
}

/// A folder that only its user can look into, and that is removed with all that is in it when it is dropped.
#[derive(Debug)]
pub struct TemporaryFolder {
    path: PathBuf,
    /// Held as long as the folder is in use.
    owner: Option<File>,
}

impl TemporaryFolder {
    /// Makes a folder in another one, with a random name that begins with `prefix`, and removes those of that
    /// beginning whose processes are dead.
    ///
    /// # Errors
    /// [`ErrorKind::Io`] when it cannot be made.
    pub fn create_in(base: &Path, prefix: &str) -> Result<Self, Error> {
        let in_base = |error: Error| error.in_file(base.display().to_string());
        for _ in 0..ATTEMPTS {
            let mut unfinished = unfinished();
            let mut builder = tempfile::Builder::new();
            builder.prefix(prefix).rand_bytes(LETTERS);
            #[cfg(unix)]
            builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o700));
            let path = builder.tempdir_in(base).map_err(|error| in_base(unmade(&error)))?.keep();
            unfinished.paths.insert(path.clone());
            drop(unfinished);
            let mut folder = Self { path, owner: None };
            let name = folder.path.join(OWNER);
            let opened = OpenOptions::new().write(true).create_new(true).open(&name);
            match opened {
                Ok(file) if Hold::of(&file, &name).is_good() => {
                    folder.owner = Some(file);
                    folder.remove_abandoned(base, prefix);
                    return Ok(folder);
                }
                // Another run has taken it for one of a dead process, before it was held.
                Ok(_) => {}
                Err(error) if error.kind() == io::ErrorKind::NotFound => {}
                Err(error) => return Err(in_base(unmade(&error))),
            }
        }
        Err(in_base(
            Error::new(ErrorKind::Io, "no temporary folder can be made").with_cure("name another folder"),
        ))
    }

    /// The path.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Removes the folders of dead processes.
    fn remove_abandoned(&self, base: &Path, prefix: &str) {
        let (Ok(own), Ok(entries)) = (fs::symlink_metadata(&self.path), fs::read_dir(base)) else { return };
        for entry in entries.filter_map(Result::ok) {
            let name = entry.file_name();
            let letters = name.to_str().and_then(|name| name.strip_prefix(prefix));
            if letters.is_none_or(|letters| letters.len() != LETTERS) || entry.path() == self.path {
                continue;
            }
            // A link is no folder here, and what others may look into was not made by this function.
            let is_ours = fs::symlink_metadata(entry.path()).is_ok_and(|found| {
                found.is_dir() && have_one_owner(&found, &own) && found.permissions() == own.permissions()
            });
            if is_ours {
                remove_unless_held(&entry.path());
            }
        }
    }
}

/// Removes a folder of a dead process.
fn remove_unless_held(folder: &Path) {
    let owner = folder.join(OWNER);
    match File::open(&owner) {
        Ok(file) if Hold::of(&file, &owner) == Hold::Ours => {
            remove_folder(folder, Some(file));
        }
        Ok(_) => {}
        // Its process died before it said that it is its own, or is about to say it: then it makes another. What is
        // not empty is left.
        Err(_) => {
            let _ = fs::remove_dir(folder);
        }
    }
}

/// Removes a temporary folder with all that is in it. The file that says that it is one goes last, so that whoever is
/// killed meanwhile leaves a folder that the next run removes. Its handle is closed just before: other systems keep a
/// file that is open, and the folder with it.
fn remove_folder(folder: &Path, mut held: Option<File>) {
    let owner = folder.join(OWNER);
    for _ in 0..ATTEMPTS {
        let Ok(entries) = fs::read_dir(folder) else { return };
        for entry in entries.filter_map(Result::ok).filter(|entry| entry.file_name() != OWNER) {
            let is_folder = entry.file_type().is_ok_and(|kind| kind.is_dir());
            // What cannot be removed is removed by the next run.
            let _ = if is_folder { fs::remove_dir_all(entry.path()) } else { fs::remove_file(entry.path()) };
        }
        if let Some(held) = held.take() {
            // A process that is being started may still share the file, and the lock with it.
            let _ = held.unlock();
        }
        let _ = fs::remove_file(&owner);
        match fs::remove_dir(folder) {
            // A worker that has not seen yet that its parent is dead has put something there.
            Err(error) if error.kind() == io::ErrorKind::DirectoryNotEmpty => {
                let _ = File::create(&owner);
            }
            _ => return,
        }
    }
}

impl Drop for TemporaryFolder {
    fn drop(&mut self) {
        let mut unfinished = unfinished();
        unfinished.paths.remove(&self.path);
        remove_folder(&self.path, self.owner.take());
    }
}

/// Folders that were made for a run, and are removed again where they are empty in the end.
#[derive(Debug)]
pub struct MadeFolders(Vec<PathBuf>);

impl MadeFolders {
    /// Makes a folder and those that it lies in.
    ///
    /// # Errors
    /// [`ErrorKind::Io`] with the folder.
    pub fn of(folder: &Path) -> Result<Self, Error> {
        let missing = folder.ancestors().take_while(|path| !path.as_os_str().is_empty() && !path.exists());
        let made = Self(missing.map(Path::to_path_buf).collect());
        unfinished().made.extend(made.0.iter().cloned());
        fs::create_dir_all(folder).map_err(|error| {
            let fault = Error::new(ErrorKind::Io, format!("the folder cannot be made: {error}"));
            fault.with_cure("choose another").in_file(folder.display().to_string())
        })?;
        Ok(made)
    }

    /// Makes a folder, and what comes first into it; again where another run, which made the folder, has removed it in between.
    ///
    /// # Errors
    /// As [`Self::of`], and what `first` says.
    pub fn with<T>(folder: &Path, first: impl Fn(&Path) -> Result<T, Error>) -> Result<(Self, T), Error> {
        let mut faults = 0;
        for _ in 1..ATTEMPTS {
            let made = Self::of(folder)?;
            match first(folder) {
                Ok(found) => return Ok((made, found)),
                // The folder may be another one, which a further run has made at the same place: then the next attempt goes well.
                Err(error) if folder.exists() => {
                    faults += 1;
                    if faults == SURE {
                        return Err(error);
                    }
                    std::thread::sleep(Duration::from_millis(1));
                }
                Err(_) => {}
            }
        }
        let made = Self::of(folder)?;
        first(folder).map(|found| (made, found))
    }
}

impl Drop for MadeFolders {
    fn drop(&mut self) {
        let mut unfinished = unfinished();
        self.0.iter().for_each(|folder| {
            unfinished.made.remove(folder);
        });
        // From the inside out; the first one with something in it stays, and with it the others.
        // Another run may have removed one before.
        let _ = self.0.iter().try_for_each(|folder| match fs::remove_dir(folder) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(()),
            removed => removed,
        });
    }
}

/// The names of what lies in a folder, sorted.
#[cfg(test)]
pub(super) fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    let mut names: Vec<String> =
        entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn folders_that_others_remove_are_made_again() {
        let base = tempfile::tempdir().unwrap();
        let folder = base.path().join("a/b");
        // The first attempts find that another run has removed what was made.
        let attempts = std::cell::Cell::new(0);
        let (made, ()) = MadeFolders::with(&folder, |folder| {
            attempts.set(attempts.get() + 1);
            if attempts.get() < 4 {
                fs::remove_dir(folder).unwrap();
                return Err(Error::new(ErrorKind::Io, "it is gone"));
            }
            Ok(())
        })
        .unwrap();
        assert!(attempts.get() == 4 && folder.exists());
        drop(made);
        assert!(!base.path().join("a").exists());
        // Another run makes it again before the fault is looked at.
        let attempts = std::cell::Cell::new(0);
        let (made, ()) = MadeFolders::with(&folder, |folder| {
            attempts.set(attempts.get() + 1);
            if attempts.get() < SURE {
                fs::remove_dir(folder).unwrap();
                let fault = Err(Error::new(ErrorKind::Io, "it is gone"));
                fs::create_dir(folder).unwrap();
                return fault;
            }
            Ok(())
        })
        .unwrap();
        assert_eq!(attempts.get(), SURE);
        drop(made);
        // What fails for another reason is said soon.
        let failed = MadeFolders::with(&folder, |_| Err::<(), _>(Error::new(ErrorKind::Io, "a full disk")));
        assert_eq!(failed.unwrap_err().to_string(), "a full disk");
        // Many threads make it and remove it all the time.
        std::thread::scope(|scope| {
            for _ in 0..4 {
                scope.spawn(|| {
                    for _ in 0..500 {
                        drop(
                            MadeFolders::with(&folder, |folder| TemporaryFolder::create_in(folder, "t-"))
                                .unwrap(),
                        );
                    }
                });
            }
        });
    }

    /// A folder as a process leaves it that was killed.
    fn abandoned(base: &Path, prefix: &str) -> PathBuf {
        let folder = TemporaryFolder::create_in(base, prefix).unwrap();
        let path = folder.path().to_path_buf();
        fs::create_dir(path.join("deep")).unwrap();
        fs::write(path.join("deep/part"), "half").unwrap();
        unfinished().paths.remove(&path);
        // The handle is closed, as the system does it, and nothing is removed.
        let mut folder = std::mem::ManuallyDrop::new(folder);
        drop(folder.owner.take());
        path
    }

    #[test]
    fn a_temporary_folder_is_private_and_goes_away() {
        let base = tempfile::tempdir().unwrap();
        let folder = TemporaryFolder::create_in(base.path(), "scratch-").unwrap();
        let name = folder.path().file_name().unwrap().to_str().unwrap().to_owned();
        assert!(name.starts_with("scratch-") && name.len() == 8 + LETTERS, "{name}");
        #[cfg(unix)]
        {
            use std::os::unix::fs::PermissionsExt;
            assert_eq!(fs::metadata(folder.path()).unwrap().permissions().mode() & 0o7777, 0o700);
        }
        let other = TemporaryFolder::create_in(base.path(), "scratch-").unwrap();
        assert_ne!(folder.path(), other.path());
        fs::write(folder.path().join("a"), "a").unwrap();
        drop((folder, other));
        assert_eq!(names(base.path()), [""; 0]);
        let error = TemporaryFolder::create_in(&base.path().join("none"), "a").unwrap_err().to_string();
        assert!(error.contains("does not exist"), "{error}");
    }

    #[test]
    fn folders_of_the_dead_are_removed_and_nothing_else() {
        let base = tempfile::tempdir().unwrap();
        let kept = tempfile::tempdir().unwrap();
        fs::write(kept.path().join(OWNER), "").unwrap();
        let dead = abandoned(base.path(), "scratch-");
        let living = TemporaryFolder::create_in(base.path(), "scratch-").unwrap();
        assert!(!dead.exists() && living.path().exists());
        let dead = abandoned(base.path(), "scratch-");
        // Not ours: another beginning, another length, a file, a folder that others may look into, one with files
        // but no owner, a link.
        let at = |name: &str| base.path().join(name);
        for name in ["other-abcdefabcdef", "scratch-short", "scratch-abcdefabcdef"] {
            fs::create_dir(at(name)).unwrap();
            fs::write(at(name).join("precious"), "a").unwrap();
        }
        fs::write(at("scratch-filefilefile"), "a").unwrap();
        #[cfg(unix)]
        {
            use std::os::unix::fs::PermissionsExt;
            fs::create_dir(at("scratch-openopenopen")).unwrap();
            fs::write(at("scratch-openopenopen").join(OWNER), "").unwrap();
            fs::set_permissions(at("scratch-openopenopen"), fs::Permissions::from_mode(0o755)).unwrap();
            fs::set_permissions(at("scratch-abcdefabcdef"), fs::Permissions::from_mode(0o700)).unwrap();
            fs::set_permissions(kept.path(), fs::Permissions::from_mode(0o700)).unwrap();
            std::os::unix::fs::symlink(kept.path(), at("scratch-linklinklink")).unwrap();
        }
        let before = names(base.path()).len();
        let newest = TemporaryFolder::create_in(base.path(), "scratch-").unwrap();
        assert!(!dead.exists() && living.path().exists() && kept.path().join(OWNER).exists());
        assert_eq!(names(base.path()).len(), before, "one came, one went");
        drop(newest);
        // An empty one is that of a process that died before it held it.
        #[cfg(unix)]
        {
            use std::os::unix::fs::DirBuilderExt;
            fs::DirBuilder::new().mode(0o700).create(at("scratch-emptyempty12")).unwrap();
            drop(TemporaryFolder::create_in(base.path(), "scratch-").unwrap());
            assert!(!at("scratch-emptyempty12").exists());
        }
    }

    #[test]
    fn a_folder_that_was_removed_in_part_is_removed_by_the_next_run() {
        let base = tempfile::tempdir().unwrap();
        let dead = abandoned(base.path(), "scratch-");
        fs::write(dead.join("a"), "a").unwrap();
        // Whoever removes it is killed after any step: then either it is still known as one, or it is empty.
        fs::remove_file(dead.join("a")).unwrap();
        assert!(dead.join(OWNER).exists());
        drop(TemporaryFolder::create_in(base.path(), "scratch-").unwrap());
        assert_eq!(names(base.path()), [""; 0]);
        // While it is removed somebody goes on writing into it.
        let folder = TemporaryFolder::create_in(base.path(), "scratch-").unwrap();
        let path = folder.path().to_path_buf();
        std::thread::scope(|scope| {
            scope.spawn(|| {
                for i in 0..2000 {
                    if fs::write(path.join(i.to_string()), "a").is_err() {
                        break;
                    }
                }
            });
            drop(folder);
        });
        drop(TemporaryFolder::create_in(base.path(), "scratch-").unwrap());
        assert_eq!(names(base.path()), [""; 0]);
    }

    #[test]
    fn many_threads_make_and_remove_folders_of_one_beginning() {
        let base = tempfile::tempdir().unwrap();
        std::thread::scope(|scope| {
            for thread in 0..4 {
                let base = base.path();
                scope.spawn(move || {
                    for round in 0..25 {
                        let folder = TemporaryFolder::create_in(base, "scratch-").unwrap();
                        let file = folder.path().join("own");
                        fs::write(&file, format!("{thread} {round}")).unwrap();
                        std::thread::yield_now();
                        assert_eq!(fs::read_to_string(&file).unwrap(), format!("{thread} {round}"));
                    }
                });
            }
        });
        assert_eq!(names(base.path()), [""; 0]);
    }
}
