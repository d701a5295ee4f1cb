//! One call of the program, and what is kept of it.

use serde_json::{Map, Value, json};
use std::fs::File;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

/// Parts of answers that are longer than this are kept by their hash.
const LONGEST_PART: usize = 50_000;

/// The words of a call, and the folder where it takes place.
#[derive(Debug, Clone)]
pub(super) struct Run {
    /// Which of the folders of files this is: a word for names, as the folder itself differs from machine to machine.
    pub(super) place: &'static str,
    pub(super) folder: PathBuf,
    pub(super) words: Vec<String>,
    /// A file that the call writes, kept beside what it prints: its ending.
    pub(super) output: Option<&'static str>,
}

impl Run {
    /// The call as a line of text.
    pub(super) fn name(&self) -> String {
        format!("[{}] {}", self.place, self.words.join(" "))
    }

    /// The file of its record: legible, and different for different calls.
    pub(super) fn file_name(&self) -> String {
        let name = self.name();
        let legible: String =
            name.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).take(80).collect();
        format!("{}-{:016x}.json", legible.trim_matches('_'), hash(name.as_bytes()))
    }
}

/// What came of a call.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Record {
    /// The exit status; `None` if the time was over, or a signal ended the call.
    pub(super) status: Option<i32>,
    pub(super) has_timed_out: bool,
    /// The answer, with long parts replaced by their hashes.
    pub(super) answer: Value,
    pub(super) errors: String,
}

impl Record {
    pub(super) fn write(&self, path: &Path) -> Result<(), String> {
        let value = json!({"status": self.status, "timeout": self.has_timed_out, "answer": self.answer, "errors": self.errors});
        std::fs::write(path, format!("{value:#}\n")).map_err(|error| format!("{}: {error}", path.display()))
    }

    /// The record in a file; `None` if there is no such file.
    pub(super) fn read(path: &Path) -> Result<Option<Self>, String> {
        let Ok(text) = std::fs::read_to_string(path) else { return Ok(None) };
        let fault = || format!("{}: not a record of answers", path.display());
        let value: Value = serde_json::from_str(&text).map_err(|_| fault())?;
        let status = match value.get("status").ok_or_else(fault)? {
            Value::Null => None,
            number => Some(number.as_i64().and_then(|n| i32::try_from(n).ok()).ok_or_else(fault)?),
        };
        Ok(Some(Self {
            status,
            has_timed_out: value.get("timeout").and_then(Value::as_bool).ok_or_else(fault)?,
            answer: value.get("answer").cloned().ok_or_else(fault)?,
            errors: value.get("errors").and_then(Value::as_str).ok_or_else(fault)?.to_owned(),
        }))
    }
}

/// Runs a program.
#[derive(Debug)]
pub(super) struct Runner<'a> {
    pub(super) program: &'a Path,
    pub(super) scratch: &'a Path,
    pub(super) limit: Duration,
}

impl Runner<'_> {
    /// Calls the program, waits for it, and stops it when the time is over.
    pub(super) fn record(&self, run: &Run) -> Result<Record, String> {
        let stem = self.scratch.join(format!("{:016x}", hash(run.name().as_bytes())));
        let [printed, said] = ["out", "err"].map(|ending| stem.with_extension(ending));
        let written = run.output.map(|ending| stem.with_extension(format!("result.{ending}")));
        let mut words = run.words.clone();
        if let Some(path) = &written {
            words.extend(["-o".to_owned(), path.display().to_string()]);
        }
        let fault = |error: std::io::Error| format!("{}: {error}", run.name());
        let mut child = Command::new(self.program)
            .args(&words)
            .args(["--threads", "1"])
            .current_dir(&run.folder)
            .stdin(Stdio::null())
            .stdout(File::create(&printed).map_err(fault)?)
            .stderr(File::create(&said).map_err(fault)?)
            .spawn()
            .map_err(fault)?;
        let begin = Instant::now();
        let status = loop {
            if let Some(status) = child.try_wait().map_err(fault)? {
                break Some(status);
            }
            if begin.elapsed() > self.limit {
                child.kill().map_err(fault)?;
                child.wait().map_err(fault)?;
                break None;
            }
            std::thread::sleep(
                Duration::from_millis(3).max(begin.elapsed() / 20).min(Duration::from_millis(100)),
            );
        };
        let neutral = |text: &[u8]| {
            let text = String::from_utf8_lossy(text).replace(&stem.display().to_string(), "OUT");
            text.replace(&self.scratch.display().to_string(), "SCRATCH")
        };
        let printed_bytes = std::fs::read(&printed).map_err(fault)?;
        let errors = neutral(&std::fs::read(&said).map_err(fault)?);
        let mut answer = answer(&printed_bytes, neutral);
        if let Some(path) = &written {
            let bytes = std::fs::read(path).unwrap_or_default();
            answer = json!({"printed": answer, "written": lines_or_bytes(&bytes)});
            std::fs::remove_file(path).ok();
        }
        for path in [printed, said] {
            std::fs::remove_file(path).ok();
        }
        Ok(Record {
            status: status.and_then(|status| status.code()),
            has_timed_out: status.is_none(),
            answer,
            errors,
        })
    }
}

/// The JSON that was printed with long parts shortened, or the hash of other bytes.
fn answer(bytes: &[u8], neutral: impl Fn(&[u8]) -> String) -> Value {
    match serde_json::from_str::<Value>(&neutral(bytes)) {
        Ok(value) => shortened(value),
        Err(_) if bytes.is_empty() => Value::Null,
        Err(_) => digest(bytes),
    }
}

/// JSON lines as a list; other bytes by their hash.
fn lines_or_bytes(bytes: &[u8]) -> Value {
    let rows: Option<Vec<Value>> = std::str::from_utf8(bytes)
        .ok()
        .and_then(|text| text.lines().map(|line| serde_json::from_str(line).ok()).collect());
    rows.filter(|rows| !rows.is_empty())
        .map_or_else(|| digest(bytes), |rows| rows.into_iter().map(shortened).collect())
}

fn digest(bytes: &[u8]) -> Value {
    json!(format!("{} bytes, hash {:016x}", bytes.len(), hash(bytes)))
}

/// The value with lists and texts that are too long replaced by their hashes; keys stay.
fn shortened(value: Value) -> Value {
    match value {
        Value::Object(map) => {
            let parts: Map<String, Value> =
                map.into_iter().map(|(key, value)| (key, shortened(value))).collect();
            Value::Object(parts)
        }
        Value::Array(_) | Value::String(_) => {
            let text = value.to_string();
            if text.len() > LONGEST_PART { digest(text.as_bytes()) } else { value }
        }
        other => other,
    }
}

/// The hash FNV-1a of 64 bits.
pub(super) fn hash(bytes: &[u8]) -> u64 {
    bytes
        .iter()
        .fold(0xcbf2_9ce4_8422_2325, |hash, &byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

/// Does a thing for each run, `jobs` at a time, and says how far it is. The first fault ends it.
pub(super) fn each(
    runs: &[Run],
    jobs: usize,
    work: impl Fn(&Run) -> Result<(), String> + Sync,
) -> Result<(), String> {
    let next = AtomicUsize::new(0);
    let worker = || {
        loop {
            let i = next.fetch_add(1, Ordering::Relaxed);
            let Some(run) = runs.get(i) else { return Ok(()) };
            if i > 0 && i.is_multiple_of(500) {
                println!("{i} of {} runs", runs.len());
            }
            if let Err(fault) = work(run) {
                next.store(runs.len(), Ordering::Relaxed);
                return Err(fault);
            }
        }
    };
    std::thread::scope(|scope| {
        let workers: Vec<_> = (0..jobs).map(|_| scope.spawn(worker)).collect();
        workers
            .into_iter()
            .map(|worker| worker.join().unwrap_or_else(|_| Err("a run panicked".to_owned())))
            .collect::<Result<Vec<()>, String>>()
            .map(drop)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hash_is_that_of_the_standard() {
        // Published values of FNV-1a with 64 bits.
        assert_eq!(hash(b""), 0xcbf2_9ce4_8422_2325);
        assert_eq!(hash(b"a"), 0xaf63_dc4c_8601_ec8c);
    }

    #[test]
    fn long_lists_become_hashes_and_keys_stay() {
        let long: Vec<usize> = (0..20_000).collect();
        let short = shortened(json!({"a": {"long": long, "short": [1, 2]}}));
        assert_eq!(short["a"]["short"], json!([1, 2]));
        assert!(short["a"]["long"].as_str().is_some_and(|text| text.contains("bytes, hash ")));
    }

    #[test]
    fn runs_that_differ_have_files_that_differ() {
        let run = |words: &[&str]| Run {
            place: "data",
            folder: PathBuf::new(),
            words: words.iter().map(|&word| word.to_owned()).collect(),
            output: None,
        };
        let names = [run(&["info", "a.off"]), run(&["info", "a_off"])].map(|run| run.file_name());
        assert_ne!(names[0], names[1]);
        assert!(names[0].starts_with("data__info_a_off-"));
    }

    #[test]
    fn a_record_is_read_as_it_was_written() {
        let folder = std::env::temp_dir().join(format!("coface-xtask-record-{}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("a folder");
        let record = Record {
            status: Some(1),
            has_timed_out: false,
            answer: json!({"area": 0.1, "betti": [1, 0]}),
            errors: "error: no".to_owned(),
        };
        let path = folder.join("x.json");
        record.write(&path).expect("written");
        assert_eq!(Record::read(&path), Ok(Some(record)));
        assert_eq!(Record::read(&folder.join("y.json")), Ok(None));
        std::fs::write(&path, "{}").expect("written");
        assert!(Record::read(&path).is_err());
        std::fs::remove_dir_all(&folder).expect("the folder goes away");
    }
}
