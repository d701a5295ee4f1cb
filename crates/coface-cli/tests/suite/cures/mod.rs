//! Every cure that a message names is run: the command line that fails or remarks, and what the message says to do.
//!
//! [`Case`] is a message with its cures; the tables are in the files of this folder, by what the messages are about.
//! A test walks the sources for messages that name a command or an option and finds each in a table, or in
//! [`EXCEPTIONS`].

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

mod diagrams;
mod drawings;
mod formats;
mod maps;
mod pages;
mod parts;
mod sources;
mod surfaces;
mod verbs;
mod yin;

use crate::program::{Run, coface, coface_in};
use std::path::Path;

/// Names and texts of files.
type Files = &'static [(&'static str, &'static str)];

/// A message that names a cure, and the cure.
struct Case {
    /// The end of the path of the source that says it.
    at: &'static str,
    /// A piece of the message as it stands there.
    says: &'static str,
    files: Files,
    more_files: Files,
    /// Command lines that make more files.
    before: &'static [&'static str],
    /// Files that come in the place of others then.
    damaged: Files,
    /// The command line that gets the message.
    line: &'static str,
    status: i32,
    /// The ways out: each is one command line or several, and the last one does what was asked for.
    cures: &'static [&'static [&'static str]],
    /// What a cure shows, and the first command line does not.
    shows: &'static str,
    /// Whether a remark is said as well where the cure lists what it counts.
    stays: bool,
}

impl Case {
    const fn new(at: &'static str, says: &'static str) -> Self {
        Self {
            at,
            says,
            files: &[],
            more_files: &[],
            before: &[],
            damaged: &[],
            line: "",
            status: 1,
            cures: &[],
            shows: "",
            stays: false,
        }
    }

    const fn files(mut self, files: Files) -> Self {
        self.files = files;
        self
    }

    /// More files beside those that cases share.
    const fn with(mut self, files: Files) -> Self {
        self.more_files = files;
        self
    }

    const fn before(mut self, lines: &'static [&'static str]) -> Self {
        self.before = lines;
        self
    }

    const fn damaged(mut self, files: Files) -> Self {
        self.damaged = files;
        self
    }

    /// The command line that fails with the message.
    const fn refused(mut self, line: &'static str) -> Self {
        self.line = line;
        self
    }

    /// The command line that is wrong usage, and says so with the message.
    const fn misused(mut self, line: &'static str) -> Self {
        self.line = line;
        self.status = 2;
        self
    }

    /// The command line that answers, with the message in the answer or in a remark.
    const fn answered(mut self, line: &'static str) -> Self {
        self.line = line;
        self.status = 0;
        self
    }

    const fn cured(mut self, cures: &'static [&'static [&'static str]]) -> Self {
        self.cures = cures;
        self
    }

    const fn shows(mut self, text: &'static str) -> Self {
        self.shows = text;
        self
    }

    const fn stays(mut self) -> Self {
        self.stays = true;
        self
    }

    /// The words of all command lines.
    fn words(&self) -> Vec<String> {
        let cures = self.cures.iter().copied().flatten();
        [self.line].iter().chain(self.before).chain(cures).flat_map(|line| words(line)).collect()
    }

    /// Runs the command lines; gives what is wrong.
    fn faults(&self) -> Result<(), String> {
        let folder = tempfile::tempdir().unwrap();
        let place = folder.path();
        for (name, text) in self.files.iter().chain(self.more_files) {
            std::fs::write(place.join(name), text).unwrap();
        }
        for line in self.before {
            let run = run_in(place, line);
            if run.status != 0 {
                return Err(format!("{line}\n{}", run.stderr));
            }
        }
        for (name, text) in self.damaged {
            std::fs::write(place.join(name), text).unwrap();
        }
        let first = run_in(place, self.line);
        let said = flat(&format!("{} {}", first.stdout, first.stderr));
        let piece = spoken(self.says);
        if first.status != self.status || !piece.iter().all(|piece| said.contains(piece)) {
            return Err(format!("{}\nstatus {}: {said}", self.line, first.status));
        }
        for cure in self.cures {
            let mut shown = String::new();
            for line in *cure {
                let run = run_in(place, line);
                if run.status != 0 {
                    return Err(format!("{line}\nstatus {}: {}", run.status, run.stderr));
                }
                shown = flat(&format!("{} {}", run.stdout, run.stderr));
            }
            if !self.stays && piece.iter().all(|piece| shown.contains(piece)) {
                return Err(format!("{cure:?} gets the message that it cures:\n{shown}"));
            }
            if !self.shows.is_empty() && (said.contains(self.shows) || !shown.contains(self.shows)) {
                return Err(format!("{cure:?} does not show {:?}, or the first does:\n{shown}", self.shows));
            }
        }
        Ok(())
    }
}

/// The words of a command line; a quote holds words together.
fn words(line: &str) -> Vec<String> {
    let quoted = line.split('\'').enumerate();
    quoted
        .flat_map(|(i, part)| match i % 2 {
            0 => part.split_whitespace().map(str::to_owned).collect(),
            _ => vec![part.to_owned()],
        })
        .collect()
}

fn run_in(folder: &Path, line: &str) -> Run {
    let words = words(line);
    assert_eq!(words[0], "coface", "{line}");
    let arguments: Vec<&str> = words[1..].iter().map(String::as_str).collect();
    coface_in(folder, &arguments)
}

/// A text with single spaces: pages break lines where they are full.
fn flat(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The parts of a piece of source between the values that stand in it.
fn spoken(piece: &str) -> Vec<String> {
    let parts = piece.split('{').enumerate().map(|(i, part)| match i {
        0 => part,
        _ => part.split_once('}').map_or(part, |(_, rest)| rest),
    });
    parts.map(flat).filter(|part| !part.is_empty()).collect()
}

fn tables() -> [&'static [Case]; 9] {
    [
        diagrams::CASES,
        drawings::CASES,
        formats::CASES,
        maps::CASES,
        pages::CASES,
        parts::CASES,
        surfaces::CASES,
        verbs::CASES,
        yin::CASES,
    ]
}

/// Messages that no command line of a test gets, or literals that are no messages, with the reason.
const EXCEPTIONS: &[(&str, &str, &str)] = &[
    ("answer/schema.rs", "For each verb of the program the object", "the title of a schema, not a message"),
    ("answer/schema.rs", "cover --orientation", "a title in the schema, not a message"),
    ("answer/schema.rs", "boolean --dissolve", "a title in the schema, not a message"),
    ("answer/schema.rs", "cocycles --test", "a title in the schema, not a message"),
    ("answer/schema.rs", "cycles --handles", "a title in the schema, not a message"),
    ("answer/schema.rs", "cycles --fill-handles", "a title in the schema, not a message"),
    ("answer/schema.rs", "persistence --vineyard", "a title in the schema, not a message"),
    ("answer/schema.rs", "yin compare --series", "a title in the schema, not a message"),
    ("answer/schema.rs", "yin advect --inputs", "a title in the schema, not a message"),
    ("pages/html.rs", ":root { --paper", "a style sheet, not a message"),
    ("cli/src/verbs.rs", "Vertices are numbered from 0", "the end of the help, not a message"),
    ("cli/src/examples.rs", "coface ", "an example in the help, which a test of its own parses"),
    ("certified.rs", "a certificate is of a file", "needs a model on standard input, which no case has"),
    (
        "commands/edit.rs",
        "Split a face by an edge between the sources",
        "the help of an option, not a message",
    ),
    (
        "persistence/points_certificate.rs",
        "(--threshold {low})",
        "needs more simplices than a test has time for",
    ),
    (
        "persistence/points.rs",
        "(--threshold {fitting})",
        "has a test of its own, which asks for the threshold that it names",
    ),
    (
        "filtered/flag.rs",
        "(--threshold {fitting})",
        "has a test of its own, which asks for the threshold that it names",
    ),
    (
        "filtered/cech.rs",
        "(--threshold {fitting})",
        "has a test of its own, which asks for the threshold that it names",
    ),
    (
        "filtered/directed.rs",
        "(--threshold {fitting})",
        "has a test of its own, which asks for the threshold that it names",
    ),
    ("cli/src/classes.rs", "build it with --features arrow", "needs another build of the program"),
    ("facts/volume.rs", "coface homology --parts N", "needs a volume of a thousand million voxels"),
    (
        "planar/writing.rs",
        "leave --exact out, or write GeoJSON",
        "needs a hole that rounding moves across its ring",
    ),
    (
        "homology/parts.rs",
        "merge fewer at once by --fan-in 2",
        "needs parts with a common boundary of 64 MiB",
    ),
    (
        "persistence/parts.rs",
        "cut into more by --parts {}, or allow more by --memory",
        "needs a block of a million voxels",
    ),
    (
        "persistence/parts.rs",
        "merge fewer at once by --fan-in 2, or allow more by --memory",
        "needs parts whose common sides take 64 MiB",
    ),
    (
        "commands/cut.rs",
        "are not made shorter; --rounds 1 does it",
        "needs a surface that takes minutes to be cut",
    ),
    (
        "shards/reduced.rs",
        "by one call of coface shard",
        "the program compares parts with shards.json before",
    ),
];

#[track_caller]
fn check(cases: &[Case]) {
    let faults: Vec<String> = cases
        .iter()
        .filter_map(|case| Some(format!("{}: \"{}\"\n{}\n", case.at, case.says, case.faults().err()?)))
        .collect();
    assert!(faults.is_empty(), "{} of {} cases:\n{}", faults.len(), cases.len(), faults.join("\n"));
}

#[test]
fn cures_about_diagrams() {
    check(diagrams::CASES);
}

#[test]
fn cures_about_drawings() {
    check(drawings::CASES);
}

#[test]
fn cures_about_formats() {
    check(formats::CASES);
}

#[test]
fn cures_of_maps_do_what_they_say() {
    check(maps::CASES);
}

/// What says that an option lists all is right: it lists what was left out.
#[test]
fn cures_of_pages() {
    check(pages::CASES);
}

#[test]
fn cures_about_parts() {
    check(parts::CASES);
}

#[test]
fn cures_about_surfaces() {
    check(surfaces::CASES);
}

#[test]
fn cures_about_verbs() {
    check(verbs::CASES);
}

#[test]
fn cures_about_yin_sets() {
    check(yin::CASES);
}

/// The verbs that the help lists.
fn verbs_of_the_program() -> Vec<String> {
    let help = coface(&["--help"]).stdout;
    let list = help.split_once("Commands:\n").unwrap().1.split_once("\n\n").unwrap().0;
    let verb = |line: &str| line.strip_prefix("  ").filter(|line| !line.starts_with(' ')).map(str::to_owned);
    list.lines().filter_map(verb).map(|line| line.split(' ').next().unwrap().to_owned()).collect()
}

#[test]
fn every_message_that_names_a_cure_is_in_a_table() {
    let verbs = verbs_of_the_program();
    assert!(verbs.len() > 25 && verbs.contains(&"convert".to_owned()), "{verbs:?}");
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let literals = sources::literals(&crates, &verbs);
    assert!(literals.len() > 80, "{}", literals.len());
    let cases: Vec<&Case> = tables().into_iter().flatten().collect();
    let is_meant = |at: &str, says: &str, literal: &sources::Literal| {
        literal.file.ends_with(at) && literal.text.contains(says)
    };
    let mut faults = Vec::new();
    for literal in &literals {
        let (file, line, text) = (&literal.file, literal.line, &literal.text);
        if EXCEPTIONS.iter().any(|(at, says, _)| is_meant(at, says, literal)) {
            continue;
        }
        let its: Vec<&&Case> = cases.iter().filter(|case| is_meant(case.at, case.says, literal)).collect();
        if its.is_empty() {
            faults.push(format!(
                "{file}:{line}: \"{text}\" names a cure that no test runs; write a Case for it in tests/suite/cures, \
                 with the command line that gets the message and the one that does what it says, or give the \
                 reason in EXCEPTIONS"
            ));
            continue;
        }
        let words: Vec<String> = its.iter().flat_map(|case| case.words()).collect();
        for name in &literal.names {
            let is_run = match name.strip_prefix("coface ") {
                Some(verb) => words.windows(2).any(|pair| pair[0] == "coface" && pair[1] == verb),
                None => words.iter().any(|word| word.split('=').next() == Some(name)),
            };
            if !is_run {
                faults.push(format!(
                    "{file}:{line}: \"{text}\" names {name}, which no command line of its cases has"
                ));
            }
        }
    }
    let old = cases.iter().map(|case| (case.at, case.says)).chain(EXCEPTIONS.iter().map(|e| (e.0, e.1)));
    for (at, says) in old {
        if !literals.iter().any(|literal| is_meant(at, says, literal)) {
            faults.push(format!(
                "{at}: no message says \"{says}\" any more; mend or remove what stands in tests/suite/cures"
            ));
        }
    }
    assert!(faults.is_empty(), "{} faults:\n{}", faults.len(), faults.join("\n"));
}
