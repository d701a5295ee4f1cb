//! The examples of the README are what the program prints.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::coface_in;
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize().unwrap()
}

/// The commands that a sentence names, `coface ..; coface ..`, before a block of text, and the lines of the block.
fn examples(readme: &str) -> Vec<(Vec<String>, Vec<String>)> {
    let mut found = Vec::new();
    let mut commands: Vec<String> = Vec::new();
    let mut lines = readme.lines();
    while let Some(line) = lines.next() {
        let named = line.split('`').skip(1).step_by(2).find(|word| word.starts_with("coface "));
        if let Some(named) = named {
            commands = named.split("; ").map(str::to_owned).collect();
        } else if line == "```text" && !commands.is_empty() {
            let block = lines.by_ref().take_while(|line| *line != "```").map(str::to_owned).collect();
            found.push((std::mem::take(&mut commands), block));
        }
    }
    found
}

#[test]
fn each_kind_of_reader_has_an_example_that_is_true() {
    let folder = tempfile::tempdir().unwrap();
    for place in ["data", "data/curves"] {
        std::fs::create_dir(folder.path().join(place)).unwrap();
        for path in std::fs::read_dir(root().join(place)).unwrap().map(|entry| entry.unwrap().path()) {
            if path.is_file() {
                std::fs::copy(&path, folder.path().join(place).join(path.file_name().unwrap())).unwrap();
            }
        }
    }
    let examples = examples(&std::fs::read_to_string(root().join("README.md")).unwrap());
    assert!(examples.len() >= 5, "{examples:?}");
    for (commands, block) in examples {
        let mut printed = String::new();
        for command in &commands {
            let words: Vec<&str> = command.split(' ').skip(1).collect();
            let run = coface_in(folder.path(), &words);
            assert_eq!(run.status, 0, "{command}: {}", run.stderr);
            printed = run.stdout;
        }
        for line in block {
            assert!(printed.lines().any(|other| other.trim_end() == line), "{commands:?}: {line}\n{printed}");
        }
    }
}
