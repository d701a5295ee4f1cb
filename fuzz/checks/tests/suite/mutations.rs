//! Files of the corpora with a few changes, the same ones in each run: a short search that needs no fuzzer.
//!
//! `COFACE_MUTATIONS=20000 cargo test -p coface-fuzz-checks --test suite mutations` tries more; an input that breaks a promise is written to
//! the folder for temporary files.

use crate::{check_named, corpus, fuzz};
use coface_fuzz_checks::CHECKS;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// So many changed files of each corpus are tried.
const USUAL: usize = 60;
/// Longer than this no changed file takes, even on a busy machine and without optimization.
const MOST_TIME: Duration = Duration::from_secs(30);
/// Changes do not make a file longer than this.
const MOST_LENGTH: usize = 8 << 10;

/// Numbers that look random and are the same everywhere (splitmix64).
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut x = self.0;
        x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        x ^ (x >> 31)
    }

    fn below(&mut self, count: usize) -> usize {
        (self.next() % count.max(1) as u64) as usize
    }

    fn one_of<'a, T>(&mut self, items: &'a [T]) -> Option<&'a T> {
        items.get(self.below(items.len()))
    }
}

/// Texts that readers have had trouble with.
const ODD: [&str; 22] = [
    "0",
    "-1",
    "1",
    "2",
    "255",
    "4294967295",
    "4294967296",
    "2147483648",
    "-2147483648",
    "9223372036854775807",
    "18446744073709551616",
    "1e308",
    "-1e308",
    "1e-320",
    "nan",
    "inf",
    "0.1",
    "",
    " ",
    "\n",
    "[[",
    "\"",
];

/// The quoted words of a list of keywords; escapes are left as they are.
fn words(name: &str) -> Vec<String> {
    let text =
        std::fs::read_to_string(fuzz().join("words").join(name).with_extension("txt")).unwrap_or_default();
    let quoted = text.lines().filter_map(|line| line.strip_prefix('"')?.strip_suffix('"'));
    quoted.map(|word| word.replace("\\\"", "\"")).collect()
}

/// Where a number or a word begins and ends around a place.
fn token(bytes: &[u8], at: usize) -> (usize, usize) {
    let is_part = |byte: &u8| byte.is_ascii_alphanumeric() || matches!(byte, b'-' | b'+' | b'.' | b'_');
    let start = bytes[..at].iter().rposition(|byte| !is_part(byte)).map_or(0, |before| before + 1);
    let end = bytes[at..].iter().position(|byte| !is_part(byte)).map_or(bytes.len(), |after| at + after);
    (start, end.max(start))
}

fn changed(random: &mut Random, seeds: &[(String, Vec<u8>)], words: &[String]) -> Vec<u8> {
    let mut bytes = random.one_of(seeds).map(|(_, bytes)| bytes.clone()).unwrap_or_default();
    for _ in 0..=random.below(6) {
        let at = random.below(bytes.len() + 1);
        let end = (at + random.below(24)).min(bytes.len());
        match random.below(11) {
            0 if at < bytes.len() => bytes[at] ^= 1 << random.below(8),
            1 if at < bytes.len() => bytes[at] = [0, 1, 2, 127, 128, 255, b' ', b'9'][random.below(8)],
            2 => drop(
                bytes.splice(at..at, (0..random.below(9)).map(|_| random.next() as u8).collect::<Vec<u8>>()),
            ),
            3 => drop(bytes.drain(at..end)),
            4 => {
                let copy = bytes[at..end].to_vec();
                let to = random.below(bytes.len() + 1);
                bytes.splice(to..to, copy);
            }
            5 | 6 if at < bytes.len() => {
                let (start, end) = token(&bytes, at);
                let odd = random.one_of(&ODD).copied().unwrap_or_default();
                bytes.splice(start..end, odd.bytes());
            }
            7 => {
                if let Some(word) = random.one_of(words) {
                    bytes.splice(at..at, word.bytes());
                }
            }
            8 => {
                let Some((_, other)) = random.one_of(seeds) else { continue };
                let from = random.below(other.len() + 1);
                let to = (from + random.below(64)).min(other.len());
                bytes.splice(at..end, other[from..to].iter().copied());
            }
            9 if at + 8 <= bytes.len() => {
                let number = [0, 1, 255, u64::MAX, 1 << 31, 1 << 32, random.next()][random.below(7)];
                let width = [2, 4, 8][random.below(3)];
                bytes[at..at + width].copy_from_slice(&number.to_le_bytes()[..width]);
            }
            10 if random.below(4) == 0 => bytes.truncate(at),
            _ => {}
        }
    }
    bytes.truncate(MOST_LENGTH);
    bytes
}

/// What is tried now, and since when, for the thread that looks at the time.
static TRIED: Mutex<Option<(String, Instant)>> = Mutex::new(None);

#[test]
fn mutations() {
    let given = std::env::var("COFACE_MUTATIONS").ok().and_then(|count| count.parse::<usize>().ok());
    let only = std::env::var("COFACE_MUTATIONS_OF").ok();
    std::thread::spawn(|| {
        loop {
            std::thread::sleep(Duration::from_secs(1));
            let tried = TRIED.lock().unwrap().clone();
            if let Some((path, since)) = tried.filter(|(_, since)| since.elapsed() > MOST_TIME) {
                eprintln!("{path} takes longer than {} s (since {since:?})", MOST_TIME.as_secs());
                std::process::abort();
            }
        }
    });
    let mut faults = Vec::new();
    for (name, _) in CHECKS.iter().filter(|(name, _)| only.as_ref().is_none_or(|only| only == name)) {
        let (check, seeds, words) = (check_named(name), corpus(name), words(name));
        let start = given.unwrap_or(0) as u64;
        let mut random = Random(name.bytes().fold(start, |sum, byte| sum.wrapping_mul(31) ^ u64::from(byte)));
        let mut found = 0;
        for i in 0..given.unwrap_or(USUAL) {
            let bytes = changed(&mut random, &seeds, &words);
            let path = temporary(name, i);
            *TRIED.lock().unwrap() = Some((path.display().to_string(), Instant::now()));
            if given.is_some() {
                // What ends the whole program leaves its input behind.
                std::fs::write(temporary(name, usize::MAX), &bytes).unwrap();
            }
            if catch_unwind(AssertUnwindSafe(|| check(&bytes))).is_err() {
                std::fs::write(&path, &bytes).unwrap();
                faults.push(path.display().to_string());
                found += 1;
            }
            if found == 20 {
                break;
            }
        }
        *TRIED.lock().unwrap() = None;
        std::fs::remove_file(temporary(name, usize::MAX)).ok();
    }
    assert!(faults.is_empty(), "these break a promise: {}", faults.join(", "));
}

fn temporary(name: &str, number: usize) -> PathBuf {
    let number = if number == usize::MAX { "last".to_owned() } else { number.to_string() };
    std::env::temp_dir().join(format!("coface-mutation-{name}-{number}"))
}
