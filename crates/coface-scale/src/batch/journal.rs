//! What is finished of a batch that is not: rows in a file beside the output.
//!
//! The first line says what the rows depend on; each further line is a checksum, what the row is about, and the answer, with tabs
//! between them. A line whose checksum is wrong is no line: whatever was being written when the run was cut short.

use super::Row;
use crate::batch::examination::PathText;
use coface_algebra::{Error, ErrorKind};
use coface_io::ReadOptions;
use serde::{Deserialize, Serialize};
use std::collections::HashMap;
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{BufRead, BufReader, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::time::UNIX_EPOCH;
use xxhash_rust::xxh3::xxh3_64;

/// The state of a file: its size and when it was changed.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Stamp(Option<(u64, String)>);

impl Stamp {
    /// Of a file, or of the file in whose list `file#entry` is.
    pub(crate) fn of(path: &Path) -> Self {
        let whole = fs::metadata(path).ok();
        let found = whole.or_else(|| fs::metadata(coface_io::entry_of(path)?.0).ok());
        Self(found.map(|found| {
            let changed = found.modified().ok().and_then(|time| time.duration_since(UNIX_EPOCH).ok());
            (found.len(), changed.map_or_else(String::new, |time| time.as_nanos().to_string()))
        }))
    }

    pub(crate) fn bytes(&self) -> Option<u64> {
        self.0.as_ref().map(|(bytes, _)| *bytes)
    }
}

/// The state of a file with its content: a file may change and have the same size and time.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Seal {
    pub(crate) stamp: Stamp,
    /// The hash of the content; none where it could not be read.
    content: Option<String>,
}

/// Seals files. The entries of one file, one after the other, read it once.
#[derive(Default)]
pub(crate) struct Sealer {
    options: ReadOptions,
    last: Option<(PathBuf, Seal)>,
}

impl Sealer {
    pub(crate) fn new(options: ReadOptions) -> Self {
        Self { options, last: None }
    }

    pub(crate) fn seal(&mut self, path: &Path) -> Seal {
        let stamp = Stamp::of(path);
        let file =
            if path.exists() { path } else { coface_io::entry_of(path).map_or(path, |(file, _)| file) };
        match &self.last {
            Some((last, seal)) if last == file && seal.stamp == stamp => seal.clone(),
            _ => {
                let content =
                    coface_io::content_hash(file, &self.options).ok().map(|hash| format!("{hash:032x}"));
                let seal = Seal { stamp, content };
                self.last = Some((file.to_path_buf(), seal.clone()));
                seal
            }
        }
    }
}

/// The rows of a batch that are finished.
pub(crate) struct Journal {
    path: PathBuf,
    file: File,
    length: u64,
    /// Where the line of each file begins.
    lines: Vec<Option<u64>>,
    /// What lines say of each file.
    names: Vec<PathText>,
}

impl Journal {
    /// The journal beside an output, with the rows of an earlier run with these options whose files have not changed; and why there are
    /// none of it, if there was one.
    pub(crate) fn open(
        out: &Path,
        options: &str,
        files: &[PathBuf],
        restart: bool,
        sealer: &mut Sealer,
    ) -> Result<(Self, Option<String>), Error> {
        let path = beside(out)?;
        let in_path = |error: Error| error.in_file(path.display().to_string());
        let open = || -> Result<File, Error> {
            let file =
                OpenOptions::new().read(true).append(true).create(true).open(&path).map_err(|error| {
                    match error.kind() {
                        std::io::ErrorKind::NotFound => {
                            Error::new(ErrorKind::Io, "the folder to write to does not exist")
                                .with_cure("make the folder first, or name another")
                        }
                        _ => Error::from(error).with_cure("choose a folder that can be written to"),
                    }
                })?;
            match file.try_lock() {
                Ok(()) => Ok(file),
                Err(TryLockError::WouldBlock) => {
                    Err(Error::new(ErrorKind::Io, "another run is writing this output")
                        .with_cure("wait for it, or name another output"))
                }
                Err(TryLockError::Error(error)) => Err(error.into()),
            }
        };
        let file = open().map_err(in_path)?;
        let names = files.iter().map(|file| PathText::of(file)).collect();
        let mut journal = Self { path: path.clone(), file, length: 0, lines: vec![None; files.len()], names };
        match journal.take(options, files, restart, sealer) {
            Ok(refused) => Ok((journal, refused)),
            Err(error) => Err(journal.given_up(in_path(error))),
        }
    }

    /// Takes what is there, or begins anew.
    fn take(
        &mut self,
        options: &str,
        files: &[PathBuf],
        restart: bool,
        sealer: &mut Sealer,
    ) -> Result<Option<String>, Error> {
        let mut input = BufReader::new(&self.file);
        let mut line = Vec::new();
        input.read_until(b'\n', &mut line)?;
        let is_same = unsealed(&line).is_some_and(|found| found == options);
        if restart || !is_same {
            let refused = (!line.is_empty() && !restart).then(|| {
                "rows of an earlier run with other options or another version are not taken".to_owned()
            });
            self.file.set_len(0)?;
            self.length = 0;
            self.append(options)?;
            return Ok(refused);
        }
        let places: HashMap<&Path, usize> =
            files.iter().enumerate().map(|(place, file)| (file.as_path(), place)).collect();
        let mut start = line.len() as u64;
        loop {
            line.clear();
            let count = input.read_until(b'\n', &mut line)? as u64;
            if count == 0 {
                break;
            }
            if let Some((path, Some(seal))) = unsealed(&line).and_then(about)
                && let Some(&place) = places.get(path.as_path())
                && Stamp::of(&path) == seal.stamp
                && sealer.seal(&path) == seal
            {
                self.lines[place] = Some(start);
            }
            start += count;
        }
        self.length = start;
        if line_is_torn(&self.file, self.length)? {
            self.file.write_all(b"\n")?;
            self.length += 1;
        }
        Ok(None)
    }

    /// Whether the row of this file is there.
    pub(crate) fn has(&self, place: usize) -> bool {
        self.lines[place].is_some()
    }

    /// Adds the row of a file.
    pub(crate) fn add(&mut self, place: usize, seal: &Seal, row: &Row) -> Result<(), Error> {
        let is_lasting = seal.content.is_some() && row.error_kind().as_deref() != Some("killed");
        let about = About {
            path: self.names[place].clone(),
            head: row.head.clone(),
            microseconds: row.microseconds,
            // What may be otherwise next time fits no file then.
            seal: is_lasting.then(|| seal.clone()),
        };
        let about = serde_json::to_string(&about).expect("lines have texts as keys");
        let start = self.append(&format!("{about}\t{}", row.answer));
        self.lines[place] = Some(start.map_err(|error| error.in_file(self.path.display().to_string()))?);
        Ok(())
    }

    /// Writes a line with its checksum, and says where it begins.
    fn append(&mut self, text: &str) -> Result<u64, Error> {
        let line = format!("{:016x}\t{text}\n", xxh3_64(text.as_bytes()));
        let start = self.length;
        if let Err(error) = self.file.write_all(line.as_bytes()) {
            // Half a line is no line, but takes room.
            let _ = self.file.set_len(start);
            return Err(error.into());
        }
        self.length += line.len() as u64;
        Ok(start)
    }

    /// Goes through the rows in the order of the files.
    pub(crate) fn each(&self, mut take: impl FnMut(&Row) -> Result<(), Error>) -> Result<(), Error> {
        let mut input = BufReader::new(&self.file);
        let mut at = None;
        let mut line = Vec::new();
        for start in &self.lines {
            let fault = || {
                Error::new(ErrorKind::Io, "another program changed the journal")
                    .in_file(self.path.display().to_string())
                    .with_cure("run the batch again")
            };
            let start = start.ok_or_else(fault)?;
            if at != Some(start) {
                input.seek(SeekFrom::Start(start))?;
            }
            line.clear();
            let count = input.read_until(b'\n', &mut line)? as u64;
            at = Some(start + count);
            take(&unsealed(&line).and_then(row_of).ok_or_else(fault)?)?;
        }
        Ok(())
    }

    /// What is said of a run that ends with this error: the journal goes if it has no row, else a later run takes
    /// its rows.
    pub(crate) fn given_up(self, error: Error) -> Error {
        match self.lines.iter().flatten().count() {
            0 => {
                self.remove();
                error
            }
            count if error.kind() == ErrorKind::Io => {
                let cure = error.cure().unwrap_or("make room").to_owned();
                let rows = if count == 1 { "row is" } else { "rows are" };
                error.with_cure(format!(
                    "{cure}, then run it again: {count} finished {rows} kept beside the output"
                ))
            }
            _ => error,
        }
    }

    /// Removes it: the output is there.
    pub(crate) fn remove(self) {
        // What cannot be removed is taken for an earlier run that finished all rows.
        let _ = fs::remove_file(&self.path);
    }
}

impl Drop for Journal {
    fn drop(&mut self) {
        // A process that is being started may still share the file, and the lock with it.
        let _ = self.file.unlock();
    }
}

/// The journal of this output.
fn beside(out: &Path) -> Result<PathBuf, Error> {
    let Some(name) = out.file_name() else {
        return Err(Error::new(ErrorKind::Io, "names no file to write").in_file(out.display().to_string()));
    };
    let mut hidden = std::ffi::OsString::from(".");
    hidden.push(name);
    hidden.push(".journal");
    Ok(out.with_file_name(hidden))
}

/// Whether the last line has no end.
fn line_is_torn(mut file: &File, length: u64) -> Result<bool, Error> {
    if length == 0 {
        return Ok(false);
    }
    let mut last = [0];
    file.seek(SeekFrom::Start(length - 1))?;
    file.read_exact(&mut last)?;
    Ok(last != *b"\n")
}

/// The text of a line, if its checksum is right.
fn unsealed(line: &[u8]) -> Option<&str> {
    let line = std::str::from_utf8(line).ok()?.strip_suffix('\n')?;
    let (sum, text) = line.split_once('\t')?;
    (u64::from_str_radix(sum, 16).ok()? == xxh3_64(text.as_bytes())).then_some(text)
}

/// What a line says before the answer.
#[derive(Serialize, Deserialize)]
struct About {
    path: PathText,
    head: String,
    microseconds: Option<u64>,
    /// The state of the file then; none where the row may be otherwise next time.
    seal: Option<Seal>,
}

/// The file that a line is about, and its state then.
fn about(text: &str) -> Option<(PathBuf, Option<Seal>)> {
    let about: About = serde_json::from_str(text.split_once('\t')?.0).ok()?;
    Some((about.path.into_path(), about.seal))
}

fn row_of(text: &str) -> Option<Row> {
    let (about, answer) = text.split_once('\t')?;
    let about: About = serde_json::from_str(about).ok()?;
    Some(Row { head: about.head, microseconds: about.microseconds, answer: answer.to_owned() })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::workers::Answer;
    use std::time::Duration;

    fn row(path: &Path, number: usize) -> Row {
        let answer = Answer { line: format!("{{\"area\":{number}}}"), time: Duration::from_millis(5) };
        Row::new(path, Some(1), Ok(answer))
    }

    /// A folder with files, and a journal with a row of each.
    fn finished(count: usize) -> (tempfile::TempDir, Vec<PathBuf>, PathBuf) {
        let folder = tempfile::tempdir().unwrap();
        let files: Vec<PathBuf> = (0..count).map(|i| folder.path().join(format!("{i}.off"))).collect();
        for file in &files {
            fs::write(file, "OFF").unwrap();
        }
        let out = folder.path().join("out.jsonl");
        let (mut journal, refused) =
            Journal::open(&out, "options", &files, false, &mut Sealer::default()).unwrap();
        assert_eq!(refused, None);
        for place in (0..count).rev() {
            journal.add(place, &Sealer::default().seal(&files[place]), &row(&files[place], place)).unwrap();
        }
        (folder, files, out)
    }

    fn taken(out: &Path, options: &str, files: &[PathBuf]) -> Vec<bool> {
        let (journal, _) = Journal::open(out, options, files, false, &mut Sealer::default()).unwrap();
        (0..files.len()).map(|place| journal.has(place)).collect()
    }

    #[test]
    fn rows_come_back_in_the_order_of_the_files() {
        let (_folder, files, out) = finished(3);
        let (journal, _) = Journal::open(&out, "options", &files, false, &mut Sealer::default()).unwrap();
        let mut found = Vec::new();
        journal
            .each(|row| {
                found.push(row.clone());
                Ok(())
            })
            .unwrap();
        let expected: Vec<Row> = files.iter().enumerate().map(|(place, file)| row(file, place)).collect();
        assert_eq!(found, expected);
        journal.remove();
        assert_eq!(taken(&out, "options", &files), [false; 3]);
    }

    #[test]
    fn only_what_still_holds_is_taken() {
        let (folder, mut files, out) = finished(3);
        fs::write(&files[1], "OFF longer").unwrap();
        assert_eq!(taken(&out, "options", &files), [true, false, true]);
        // The same size and time.
        let changed = fs::metadata(&files[2]).unwrap().modified().unwrap();
        fs::write(&files[2], "off").unwrap();
        File::options().write(true).open(&files[2]).unwrap().set_modified(changed).unwrap();
        assert_eq!(taken(&out, "options", &files), [true, false, false]);
        fs::write(&files[2], "OFF").unwrap();
        File::options().write(true).open(&files[2]).unwrap().set_modified(changed).unwrap();
        files.swap(0, 2);
        files.push(folder.path().join("new.off"));
        assert_eq!(taken(&out, "options", &files), [true, false, true, false]);
        let (_, refused) = Journal::open(&out, "others", &files, false, &mut Sealer::default()).unwrap();
        assert!(refused.unwrap().contains("other options"));
        assert_eq!(taken(&out, "others", &files), [false; 4]);
    }

    #[test]
    fn nothing_is_taken_of_a_restart() {
        let (_folder, files, out) = finished(2);
        let (journal, refused) =
            Journal::open(&out, "options", &files, true, &mut Sealer::default()).unwrap();
        assert_eq!((journal.has(0), refused), (false, None));
    }

    #[test]
    fn what_is_killed_may_be_otherwise_next_time() {
        let (_folder, files, out) = finished(1);
        {
            let (mut journal, _) =
                Journal::open(&out, "options", &files, true, &mut Sealer::default()).unwrap();
            let loss = crate::workers::Loss::Killed { signal: "SIGKILL".into(), attempts: 3 };
            journal
                .add(0, &Sealer::default().seal(&files[0]), &Row::new(&files[0], Some(3), Err(loss)))
                .unwrap();
            assert!(journal.has(0));
        }
        assert_eq!(taken(&out, "options", &files), [false]);
    }

    #[test]
    fn a_journal_cut_anywhere_gives_whole_rows_only() {
        let (folder, files, out) = finished(3);
        let path = folder.path().join(".out.jsonl.journal");
        let whole = fs::read(&path).unwrap();
        for length in 0..whole.len() {
            fs::write(&path, &whole[..length]).unwrap();
            let (mut journal, _) =
                Journal::open(&out, "options", &files, false, &mut Sealer::default()).unwrap();
            let lines = whole[..length].iter().filter(|&&byte| byte == b'\n').count();
            let has: Vec<usize> = (0..3).filter(|&place| journal.has(place)).collect();
            assert_eq!(has.len(), lines.saturating_sub(1), "{length}");
            for (place, file) in files.iter().enumerate() {
                if !journal.has(place) {
                    journal.add(place, &Sealer::default().seal(file), &row(file, place)).unwrap();
                }
            }
            let mut found = Vec::new();
            journal
                .each(|row| {
                    found.push(row.clone());
                    Ok(())
                })
                .unwrap();
            assert_eq!(found.len(), 3);
            drop(journal);
            assert_eq!(taken(&out, "options", &files), [true; 3], "{length}");
        }
    }

    #[test]
    fn a_flipped_bit_costs_its_row_alone() {
        let (folder, files, out) = finished(3);
        let path = folder.path().join(".out.jsonl.journal");
        let mut bytes = fs::read(&path).unwrap();
        let last = bytes.len() - 10;
        bytes[last] ^= 1;
        fs::write(&path, bytes).unwrap();
        assert_eq!(taken(&out, "options", &files), [false, true, true]);
    }

    #[test]
    fn two_runs_do_not_write_one_output() {
        let (_folder, files, out) = finished(1);
        let (journal, _) = Journal::open(&out, "options", &files, false, &mut Sealer::default()).unwrap();
        let error =
            Journal::open(&out, "options", &files, false, &mut Sealer::default()).map(drop).unwrap_err();
        assert!(error.to_string().contains("another run"), "{error}");
        drop(journal);
        let nowhere = out.with_file_name("no").join("out.csv");
        assert!(Journal::open(&nowhere, "options", &files, false, &mut Sealer::default()).map(drop).is_err());
    }
}
