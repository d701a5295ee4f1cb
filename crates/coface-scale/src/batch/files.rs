//! Finding the files that a batch is about.

use coface_algebra::{Error, ErrorKind};
use coface_io::{Format, entries_of_path, parts_of_path};
use std::collections::HashSet;
use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};

/// The files that these words name, in their order, none twice.
///
/// A word is a file; a folder, which stands for the files in it that have the extension of a format, in the order of their names, with
/// `is_recursive` those of the folders in it too; a pattern with `*`, `?` or `[`, in which `**` is any number of folders; `@list.txt`, a
/// file with one path a line; or `-`, the same on standard input. A path that exists is never a pattern or a list. A file need not exist: its row says so.
/// Links to folders are not followed inside of folders. A file of several models, which are signatures or JSON, stands for each of
/// them: `census.sig#L(3,1)`. An OBJ of several objects, or an STL of several solids, is there as a whole and then for each of them.
///
/// # Errors
/// [`ErrorKind::Io`] when a folder or list cannot be read; [`ErrorKind::InvalidInput`] when a pattern is none or nothing is named.
///
/// # Examples
/// ```
/// use coface_scale::batch::find_files;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let folder = std::env::temp_dir().join("coface-find-files");
/// std::fs::create_dir_all(&folder)?;
/// for name in ["b.off", "a.ply", "notes.txt"] {
///     std::fs::write(folder.join(name), "")?;
/// }
/// let found = find_files(&[folder.join("*.off"), folder.clone()], false, std::io::empty())?;
/// assert_eq!(found, [folder.join("b.off"), folder.join("a.ply")]);
/// # std::fs::remove_dir_all(&folder)?;
/// # Ok(()) }
/// ```
pub fn find_files(
    words: &[PathBuf],
    is_recursive: bool,
    mut standard_input: impl Read,
) -> Result<Vec<PathBuf>, Error> {
    let mut files = Vec::new();
    for word in words {
        if word.as_os_str() == "-" {
            let mut list = Vec::new();
            standard_input
                .read_to_end(&mut list)
                .map_err(|error| Error::from(error).in_file("standard input"))?;
            add_list(&list, is_recursive, &mut files)?;
        } else if let (false, Some(path)) = (word.exists(), list_of(word)) {
            let list = fs::read(&path).map_err(|error| in_path(error, &path))?;
            add_list(&list, is_recursive, &mut files)?;
        } else {
            add(word, is_recursive, &mut files)?;
        }
    }
    let mut files: Vec<PathBuf> = files.into_iter().flat_map(entries_of).collect();
    let mut seen = HashSet::new();
    files.retain(|file| seen.insert(file.clone()));
    if files.is_empty() {
        return Err(Error::invalid("no files are named here")
            .with_cure("name files, folders with files of known formats, or patterns"));
    }
    Ok(files)
}

/// The models of a file that holds several, as `file#name`, or a mesh and its parts; otherwise the file, whatever is wrong with it.
fn entries_of(file: PathBuf) -> Vec<PathBuf> {
    let format = Format::from_input_path(&file).filter(|_| file.is_file());
    let names = match format {
        Some(Format::Json | Format::Isosig) => entries_of_path(&file, None),
        Some(Format::Obj | Format::Stl) => parts_of_path(&file, None),
        _ => Ok(Vec::new()),
    };
    let entry = |name: String| {
        let mut path = file.clone().into_os_string();
        path.push(format!("#{name}"));
        PathBuf::from(path)
    };
    let entries: Vec<PathBuf> = names.unwrap_or_default().into_iter().map(entry).collect();
    if entries.is_empty() {
        return vec![file];
    }
    let whole = matches!(format, Some(Format::Obj | Format::Stl)).then_some(file);
    whole.into_iter().chain(entries).collect()
}

/// The file of a list `@file`.
fn list_of(word: &Path) -> Option<PathBuf> {
    word.to_str()?.strip_prefix('@').map(PathBuf::from)
}

fn in_path(error: std::io::Error, path: &Path) -> Error {
    Error::from(error).in_file(path.display().to_string())
}

/// Adds what the lines of a list name.
fn add_list(list: &[u8], is_recursive: bool, files: &mut Vec<PathBuf>) -> Result<(), Error> {
    for line in list.split(|&byte| byte == b'\n') {
        let line = line.strip_suffix(b"\r").unwrap_or(line);
        if !line.is_empty() {
            add(&path_of(line), is_recursive, files)?;
        }
    }
    Ok(())
}

#[cfg(unix)]
fn path_of(bytes: &[u8]) -> PathBuf {
    use std::os::unix::ffi::OsStrExt;
    std::ffi::OsStr::from_bytes(bytes).into()
}

#[cfg(not(unix))]
fn path_of(bytes: &[u8]) -> PathBuf {
    String::from_utf8_lossy(bytes).into_owned().into()
}

/// Adds a file, what is in a folder, or what fits a pattern.
fn add(path: &Path, is_recursive: bool, files: &mut Vec<PathBuf>) -> Result<(), Error> {
    if path.is_dir() {
        return add_folder(path, is_recursive, files);
    }
    let pattern = path.to_str().filter(|text| text.contains(['*', '?', '[']));
    let Some(pattern) = pattern.filter(|_| !path.exists()) else {
        files.push(path.to_path_buf());
        return Ok(());
    };
    let matches = glob::glob(pattern)
        .map_err(|error| Error::invalid(format!("the pattern \"{pattern}\" is none: {error}")))?;
    let before = files.len();
    for path in matches {
        let path = path.map_err(|error| {
            let path = error.path().to_path_buf();
            in_path(error.into(), &path)
        })?;
        if !path.is_dir() {
            files.push(path);
        }
    }
    if files.len() == before {
        return Err(Error::new(ErrorKind::InvalidInput, format!("no file fits the pattern \"{pattern}\"")));
    }
    Ok(())
}

/// Whether a file has the rows of a batch, or an answer a line, and not a model.
fn is_rows(path: &Path) -> bool {
    let extension = path.extension().and_then(|extension| extension.to_str()).map(str::to_ascii_lowercase);
    let mark: &[u8] = match extension.as_deref() {
        Some("csv") => b"path,bytes,",
        Some("jsonl" | "ndjson") => b"{\"path\":",
        _ => return false,
    };
    let mut start = Vec::new();
    let read = fs::File::open(path).and_then(|file| file.take(mark.len() as u64).read_to_end(&mut start));
    read.is_ok() && start == mark
}

/// Adds the files of a folder that have the extension of a format, compressed or not; rows of an earlier batch are none of them.
fn add_folder(folder: &Path, is_recursive: bool, files: &mut Vec<PathBuf>) -> Result<(), Error> {
    let mut entries = Vec::new();
    for entry in fs::read_dir(folder).map_err(|error| in_path(error, folder))? {
        let entry = entry.map_err(|error| in_path(error, folder))?;
        let kind = entry.file_type().map_err(|error| in_path(error, folder))?;
        entries.push((entry.path(), kind));
    }
    entries.sort_by(|(a, _), (b, _)| a.cmp(b));
    for (path, kind) in entries {
        if kind.is_dir() {
            if is_recursive {
                add_folder(&path, true, files)?;
            }
        } else if Format::from_input_path(&path).is_some() && !path.is_dir() && !is_rows(&path) {
            files.push(path);
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_folder_has_compressed_files_and_no_rows() {
        let folder = tempfile::tempdir().unwrap();
        let files = [
            ("a.off.gz", ""),
            ("b.mesh.xz", ""),
            ("c.csv", "x,y\n0,1\n"),
            ("d.csv", "path,bytes,seconds\na.off,7,0.5\n"),
            ("e.jsonl", "{\"path\":\"a.off\"}\n"),
            ("f.jsonl", "{\"facets\":[[0,1]]}\n"),
            ("g.txt.gz", ""),
        ];
        for (name, text) in files {
            fs::write(folder.path().join(name), text).unwrap();
        }
        let found = find_files(&[folder.path().to_path_buf()], false, std::io::empty()).unwrap();
        let names: Vec<&str> = found.iter().filter_map(|path| path.file_name()?.to_str()).collect();
        assert_eq!(names, ["a.off.gz", "b.mesh.xz", "c.csv", "f.jsonl"]);
    }

    #[test]
    fn words_name_files_folders_patterns_and_lists() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        fs::create_dir_all(at("deep/deeper")).unwrap();
        for name in ["b.off", "a.obj", "notes.txt", "deep/c.ply", "deep/deeper/d.stl", "[x].off", "@odd.off"]
        {
            fs::write(at(name), "").unwrap();
        }
        fs::write(
            at("list.txt"),
            format!("{}\r\n\n{}\n", at("b.off").display(), at("missing.off").display()),
        )
        .unwrap();
        let find = |words: &[&str], is_recursive| {
            let words: Vec<PathBuf> = words.iter().map(|word| at(word)).collect();
            let found = find_files(&words, is_recursive, std::io::empty()).unwrap();
            let names =
                found.iter().map(|path| path.strip_prefix(folder.path()).unwrap().display().to_string());
            names.collect::<Vec<_>>().join(" ")
        };
        assert_eq!(find(&[""], false), "@odd.off [x].off a.obj b.off");
        assert_eq!(find(&["deep", "b.off"], true), "deep/c.ply deep/deeper/d.stl b.off");
        assert_eq!(find(&["b.off", "*.o*", "b.off"], false), "b.off @odd.off [x].off a.obj");
        assert_eq!(find(&["**/*.stl", "[x].off"], false), "deep/deeper/d.stl [x].off");
        assert_eq!(find(&["notes.txt", "missing.off"], false), "notes.txt missing.off");
        let list = PathBuf::from(format!("@{}", at("list.txt").display()));
        assert_eq!(find_files(&[list], false, std::io::empty()).unwrap(), [at("b.off"), at("missing.off")]);
        let given = find_files(&["-".into()], false, &b"x.off\ny.off\n"[..]).unwrap();
        assert_eq!(given, [PathBuf::from("x.off"), "y.off".into()]);
    }

    #[test]
    fn files_of_several_models_stand_for_each() {
        let folder = tempfile::tempdir().unwrap();
        for (name, text) in [
            ("census.sig", "cMcabbgqw L(3,1) : #1\ncMcabbjak\n"),
            ("lines.jsonl", "[[0, 1, 2]]\n[[0, 1]]\n"),
            ("list.json", r#"[{"name": "a", "facets": [[0]]}, {"name": "a", "facets": [[1]]}]"#),
            ("nested.json", "[[[0, 1, 2]], [[0, 1, 2, 3], [1, 2, 3, 4]]]"),
            ("one.json", "[[0, 1, 2]]"),
            ("torn.json", "[[[0, 1"),
            ("two.obj", "o low\nv 0 0 0\no high\n"),
        ] {
            fs::write(folder.path().join(name), text).unwrap();
        }
        let found = find_files(&[folder.path().into()], false, std::io::empty()).unwrap();
        let names: Vec<_> =
            found.iter().map(|path| path.strip_prefix(folder.path()).unwrap().to_str().unwrap()).collect();
        let expected = [
            "census.sig#L(3,1) : #1",
            "census.sig#2",
            "lines.jsonl#1",
            "lines.jsonl#2",
            "list.json#1",
            "list.json#2",
            "nested.json#1",
            "nested.json#2",
            "one.json",
            "torn.json",
            "two.obj",
            "two.obj#low",
            "two.obj#high",
        ];
        assert_eq!(names, expected);
    }

    #[test]
    fn nothing_is_said() {
        let folder = tempfile::tempdir().unwrap();
        for word in ["", "*.off", "***", "@none.txt"] {
            let word = match word.strip_prefix('@') {
                Some(name) => format!("@{}", folder.path().join(name).display()),
                None => folder.path().join(word).display().to_string(),
            };
            assert!(find_files(&[word.clone().into()], false, std::io::empty()).is_err(), "{word}");
        }
        assert!(find_files(&["-".into()], false, std::io::empty()).is_err());
    }
}
