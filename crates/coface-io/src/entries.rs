//! Files that hold several models.

use crate::readers::{self, ReadOptions};
use crate::{Format, Model, isosig, json};
use coface_algebra::Error;
use std::collections::HashMap;
use std::fs::File;
use std::io::{Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};

/// One of several models in a file: its name, and where it stands in the bytes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Entry {
    pub(crate) name: Option<String>,
    pub(crate) start: u64,
    pub(crate) length: u64,
}

/// The models of a file that holds several: the objects and lists of facets of a list in JSON, the lines of JSON lines, and
/// isomorphism signatures. It knows where each stands, so that all of them are read in linear time.
///
/// # Examples
/// ```
/// use coface_io::{FileEntries, ReadOptions};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let path = std::env::temp_dir().join("coface-file-entries.jsonl");
/// std::fs::write(&path, "[[0, 1, 2]]\n{\"name\": \"path\", \"facets\": [[0, 1]]}\n")?;
/// let entries = FileEntries::of_path(&path, None)?;
/// assert_eq!(entries.names().collect::<Vec<_>>(), ["1", "path"]);
/// assert!(entries.read("path", &ReadOptions::new())?.structure().is_some());
/// # std::fs::remove_file(&path)?;
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct FileEntries {
    file: PathBuf,
    format: Format,
    is_unpacked: bool,
    entries: Vec<Entry>,
    /// The number of each name and place.
    numbers: HashMap<String, usize>,
}

impl FileEntries {
    /// Finds the models of a file; none are listed of a file that holds one.
    ///
    /// # Errors
    /// As [`read_path`](crate::read_path), for what is wrong with the start of the file.
    ///
    /// # Complexity
    /// Linear, without making any model; memory is the list.
    pub fn of_path(path: impl AsRef<Path>, format: Option<Format>) -> Result<Self, Error> {
        let file = path.as_ref();
        let found = || {
            let opened = readers::opened(readers::counted(file)?, Some(file), format)?;
            let (format, mut is_unpacked) = (opened.format, opened.is_unpacked);
            // Places count from the first byte of the text.
            is_unpacked |= opened.has_mark();
            let entries = match format {
                Format::Isosig => isosig::outline(opened.bytes())?,
                Format::Json => json::outline(opened.bytes())?,
                _ => Vec::new(),
            };
            Ok((format, is_unpacked, entries))
        };
        let (format, is_unpacked, mut entries) =
            found().map_err(|error: Error| error.in_file(file.display().to_string()))?;
        if entries.len() < 2 {
            entries.clear();
        }
        let mut counts: HashMap<String, usize> = HashMap::new();
        for name in entries.iter().filter_map(|entry| entry.name.clone()) {
            *counts.entry(name).or_default() += 1;
        }
        let mut numbers = HashMap::with_capacity(entries.len());
        for (number, entry) in entries.iter_mut().enumerate() {
            // A name chooses an entry if no other has it and it can stand in a line.
            entry.name = entry
                .name
                .take()
                .filter(|name| counts[name] == 1 && !name.is_empty() && !name.chars().any(char::is_control));
            if let Some(name) = &entry.name {
                numbers.insert(name.clone(), number);
            }
        }
        for (number, entry) in entries.iter_mut().enumerate() {
            // A name comes before a place; a place with zeros in front is no name of another entry.
            let mut place = (number + 1).to_string();
            while entry.name.is_none() && counts.contains_key(&place) {
                place.insert(0, '0');
            }
            entry.name.get_or_insert_with(|| place.clone());
            numbers.entry(place).or_insert(number);
        }
        Ok(Self { file: file.to_path_buf(), format, is_unpacked, entries, numbers })
    }

    /// What [`read_path`](crate::read_path) takes behind a `#`: the name of each model, or its place from 1 where it has none of its own.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.entries.iter().filter_map(|entry| entry.name.as_deref())
    }

    /// Reads one of them, by its name or its place from 1.
    ///
    /// # Errors
    /// As [`read_path_with`](crate::read_path_with) for `file#name`.
    ///
    /// # Complexity
    /// Linear in the size of the entry, where the file is not compressed.
    pub fn read(&self, name: &str, options: &ReadOptions) -> Result<Model, Error> {
        let whole = || readers::read_path_with(format!("{}#{name}", self.file.display()), options);
        let Some(&number) = self.numbers.get(name).filter(|_| !self.is_unpacked) else { return whole() };
        let entry = &self.entries[number];
        let mut file = File::open(&self.file)?;
        file.seek(SeekFrom::Start(entry.start))?;
        // What is wrong with it is better said with its line.
        readers::read_with(file.take(entry.length), &options.format(self.format)).or_else(|_| whole())
    }
}

/// The entries of a file that holds several models: what [`read_path`](crate::read_path) takes behind a `#`. Empty for a file that holds one.
/// They are the names, or the places from 1, of isomorphism signatures, and of the models of a list or of lines in JSON.
///
/// # Errors
/// As [`read_path`](crate::read_path).
///
/// # Examples
/// ```
/// use coface_io as io;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let path = std::env::temp_dir().join("coface-entries-of-path.sig");
/// std::fs::write(&path, "cMcabbgqw L(3,1)\ncMcabbjak\n")?;
/// assert_eq!(io::entries_of_path(&path, None)?, ["L(3,1)", "2"]);
/// # std::fs::remove_file(&path)?;
/// # Ok(()) }
/// ```
pub fn entries_of_path(path: impl AsRef<Path>, format: Option<Format>) -> Result<Vec<String>, Error> {
    Ok(FileEntries::of_path(path, format)?.names().map(str::to_owned).collect())
}
