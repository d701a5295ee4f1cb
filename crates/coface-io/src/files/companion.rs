//! Files that other files name.

use coface_algebra::{Error, ErrorKind};
use std::fs::{self, File};
use std::io;
use std::path::{Component, Path, PathBuf};

/// Where the files lie that a file may name.
#[derive(Clone, Debug)]
pub(crate) struct Companions {
    folder: PathBuf,
    may_be_outside: bool,
}

impl Companions {
    /// Those in the folder of a file and below, or anywhere.
    pub(crate) fn of(file: &Path, may_be_outside: bool) -> Self {
        let folder = file.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        Self { folder: folder.to_path_buf(), may_be_outside }
    }

    /// The path that a name stands for.
    pub(crate) fn path(&self, name: &Path) -> PathBuf {
        if self.folder == Path::new(".") { name.to_path_buf() } else { self.folder.join(name) }
    }

    /// Opens the file of this name for reading.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] with the cure for a file that lies outside of the folder, once links are
    /// followed, and for what is no regular file; [`ErrorKind::Io`] for one that is not there or may not be read.
    /// They do not name the file.
    pub(crate) fn open(&self, name: &Path) -> Result<File, Error> {
        let path = self.folder.join(name);
        if self.may_be_outside {
            return open_regular(&path);
        }
        // First by the words alone: what lies outside is not even looked at.
        if !self.is_inside_by_words(name) {
            return Err(outside());
        }
        match (self.folder.canonicalize(), path.canonicalize()) {
            (Ok(folder), Ok(path)) if path.starts_with(&folder) => open_regular(&path),
            (Ok(_), Ok(_)) => Err(outside()),
            (Err(error), _) | (_, Err(error)) => {
                Err(unopened(&error, "put it beside the file that names it"))
            }
        }
    }

    fn is_inside_by_words(&self, name: &Path) -> bool {
        if name.has_root() || matches!(name.components().next(), Some(Component::Prefix(_))) {
            let rest = self
                .folder
                .canonicalize()
                .ok()
                .and_then(|folder| name.strip_prefix(folder).ok().map(Path::to_path_buf));
            let rest = rest.or_else(|| name.strip_prefix(&self.folder).ok().map(Path::to_path_buf));
            return rest.is_some_and(|rest| stays_below(&rest));
        }
        stays_below(name)
    }
}

/// Whether no step of a relative path leads out of where it begins.
fn stays_below(path: &Path) -> bool {
    let mut depth = 0_usize;
    path.components().all(|part| match part {
        Component::Normal(_) => {
            depth += 1;
            true
        }
        Component::CurDir => true,
        Component::ParentDir => {
            let is_below = depth > 0;
            depth = depth.saturating_sub(1);
            is_below
        }
        Component::RootDir | Component::Prefix(_) => false,
    })
}

fn outside() -> Error {
    Error::invalid("the file lies outside the folder of the file that names it")
        .with_cure("copy it into that folder, or allow it by --allow-outside if you trust the file")
}

fn unopened(error: &io::Error, cure: &str) -> Error {
    match error.kind() {
        io::ErrorKind::NotFound => Error::new(ErrorKind::Io, "there is no such file").with_cure(cure),
        io::ErrorKind::PermissionDenied => Error::new(ErrorKind::Io, "the file may not be read")
            .with_cure("change its permissions, or copy it"),
        _ => Error::new(ErrorKind::Io, format!("the file cannot be opened: {error}"))
            .with_cure("check the path"),
    }
}

/// Opens a regular file, and never waits: a device or a pipe is not opened at all, or closed again where it has just
/// taken the place of a file.
///
/// # Errors
/// [`ErrorKind::InvalidInput`] for what is no regular file; [`ErrorKind::Io`] for one that is not there or may not be read.
/// They do not name the file.
pub fn open_regular(path: &Path) -> Result<File, Error> {
    let no_file = || Error::invalid("is no regular file").with_cure("name a regular file there");
    if !fs::metadata(path).map_err(|error| unopened(&error, "check the path"))?.is_file() {
        return Err(no_file());
    }
    let mut options = File::options();
    options.read(true);
    #[cfg(unix)]
    {
        use nix::fcntl::OFlag;
        let flags = OFlag::O_NONBLOCK | OFlag::O_NOCTTY;
        std::os::unix::fs::OpenOptionsExt::custom_flags(&mut options, flags.bits());
    }
    let file = options.open(path).map_err(|error| unopened(&error, "check the path"))?;
    if file.metadata().map_err(|error| unopened(&error, "check the path"))?.is_file() {
        Ok(file)
    } else {
        Err(no_file())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Read;

    fn content(companions: &Companions, name: &str) -> Result<String, String> {
        let mut text = String::new();
        let mut file = companions.open(Path::new(name)).map_err(|error| error.to_string())?;
        file.read_to_string(&mut text).unwrap();
        Ok(text)
    }

    #[test]
    fn only_files_below_the_folder_are_opened() {
        let base = tempfile::tempdir().unwrap();
        let at = |name: &str| base.path().join(name);
        fs::create_dir_all(at("in/deep")).unwrap();
        for name in ["secret", "in/a", "in/deep/b"] {
            fs::write(at(name), name).unwrap();
        }
        let inside = Companions::of(&at("in/header"), false);
        let anywhere = Companions::of(&at("in/header"), true);
        for (name, file) in [("a", "in/a"), ("./a", "in/a"), ("deep/b", "in/deep/b"), ("deep/../a", "in/a")] {
            assert_eq!(content(&inside, name), Ok(file.to_owned()));
            assert_eq!(content(&anywhere, name), Ok(file.to_owned()));
        }
        assert_eq!(content(&inside, at("in/a").to_str().unwrap()), Ok("in/a".to_owned()));
        let secret = at("secret");
        for name in ["../secret", "deep/../../secret", "./../in/../secret", secret.to_str().unwrap()] {
            let error = content(&inside, name).unwrap_err();
            assert!(
                error.contains("outside the folder") && error.contains("--allow-outside"),
                "{name}: {error}"
            );
            assert_eq!(content(&anywhere, name), Ok("secret".to_owned()));
        }
        // One that leads out and in again is not looked at either.
        assert!(content(&inside, "../in/a").unwrap_err().contains("outside"));
        assert!(content(&inside, "none").unwrap_err().starts_with("there is no such file"));
        assert!(content(&inside, "deep").unwrap_err().starts_with("is no regular file"));
        assert!(content(&inside, "").unwrap_err().starts_with("is no regular file"));
    }

    #[cfg(unix)]
    #[test]
    fn links_are_followed_before_it_is_decided() {
        use std::os::unix::fs::symlink;
        let base = tempfile::tempdir().unwrap();
        let at = |name: &str| base.path().join(name);
        fs::create_dir_all(at("in")).unwrap();
        fs::write(at("secret"), "secret").unwrap();
        fs::write(at("in/a"), "a").unwrap();
        symlink("a", at("in/same")).unwrap();
        symlink("../secret", at("in/out")).unwrap();
        symlink("..", at("in/up")).unwrap();
        symlink("in", at("door")).unwrap();
        for header in ["in/header", "door/header"] {
            let inside = Companions::of(&at(header), false);
            assert_eq!(content(&inside, "same"), Ok("a".to_owned()));
            assert!(content(&inside, "out").unwrap_err().contains("--allow-outside"));
            assert!(content(&inside, "up/secret").unwrap_err().contains("--allow-outside"));
            assert_eq!(content(&Companions::of(&at(header), true), "out"), Ok("secret".to_owned()));
        }
    }

    #[cfg(unix)]
    #[test]
    fn pipes_and_devices_are_not_opened() {
        let base = tempfile::tempdir().unwrap();
        let pipe = base.path().join("pipe");
        assert!(std::process::Command::new("mkfifo").arg(&pipe).status().unwrap().success());
        for may_be_outside in [false, true] {
            let companions = Companions::of(&base.path().join("header"), may_be_outside);
            assert!(content(&companions, "pipe").unwrap_err().starts_with("is no regular file"));
        }
        let anywhere = Companions::of(&base.path().join("header"), true);
        assert!(content(&anywhere, "/dev/zero").unwrap_err().starts_with("is no regular file"));
    }
}
