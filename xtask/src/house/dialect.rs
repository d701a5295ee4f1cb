//! Words of our own that the field has other words for: they must not come back into what users read.
//!
//! The texts are doc comments, which are the help of the program too, and the pages in Markdown.

use super::{sources, walk};
use crate::root;
use std::collections::BTreeMap;
use std::path::Path;

/// Our words, and what the field says.
const WORDS: &[(&str, &str)] = &[
    ("door", "reader"),
    ("doors", "readers"),
    ("mood", "state"),
    ("soup", "unstructured triangles, polygons or segments"),
    ("hang together", "are connected"),
    ("hangs together", "is connected"),
    ("taken away", "removed"),
    ("walls", "shared faces"),
];

/// How often a word may still stand in the docs of a crate, or in `docs` for the pages. Take out what is mended; add nothing.
const LEFT: &[(&str, &str, usize)] = &[
    ("coface-answers", "taken away", 1),
    ("coface-answers", "walls", 10),
    ("coface-arrange", "door", 1),
    ("coface-arrange", "soup", 2),
    ("coface-arrange", "taken away", 2),
    ("coface-arrange", "walls", 4),
    ("coface-cli", "taken away", 2),
    ("coface-cli", "walls", 4),
    ("coface-complexes", "hang together", 1),
    ("coface-complexes", "hangs together", 3),
    ("coface-complexes", "soup", 3),
    ("coface-complexes", "taken away", 1),
    ("coface-complexes", "walls", 13),
    ("coface-pictures", "hangs together", 1),
    ("coface-pictures", "taken away", 1),
    ("docs", "door", 2),
    ("docs", "doors", 1),
    ("docs", "walls", 1),
];

#[test]
fn docs_have_the_words_of_the_field() {
    let counts = counts();
    let mut faults = Vec::new();
    for ((place, word), lines) in &counts {
        let most = LEFT.iter().find(|(p, w, _)| p == place && w == word).map_or(0, |&(_, _, most)| most);
        if lines.len() > most {
            let better = WORDS.iter().find(|(ours, _)| ours == word).map_or("", |(_, better)| better);
            faults.push(format!(
                "{place}: {word:?} stands {} times, say {better:?}:\n{}",
                lines.len(),
                lines.join("\n")
            ));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn words_are_found_whole() {
    assert!(has_phrase("two Doors, open", "doors"));
    assert!(!has_phrase("indoors", "doors"));
    assert!(has_phrase("what is taken away.", "taken away"));
    assert!(!has_phrase("taken far away", "taken away"));
}

/// The lines with each word, by the crate or `docs`.
fn counts() -> BTreeMap<(String, &'static str), Vec<String>> {
    let mut found: BTreeMap<(String, &'static str), Vec<String>> = BTreeMap::new();
    let mut texts = Vec::new();
    for entry in std::fs::read_dir(root().join("crates")).expect("the folder of the crates") {
        let folder = entry.expect("an entry can be read").path();
        let place = folder.file_name().unwrap_or_default().to_string_lossy().into_owned();
        texts.extend(sources(&folder.join("src")).into_iter().map(|path| (place.clone(), path)));
    }
    let mut pages = Vec::new();
    for folder in ["docs", "crates"] {
        walk(&root().join(folder), &mut pages);
    }
    pages.push(root().join("README.md"));
    pages.retain(|path| path.extension().is_some_and(|extension| extension == "md"));
    // The walls and doors of this page are those of a building.
    pages.retain(|path| !path.ends_with("docs/buildings.md"));
    // Generated from doc comments and help, which are counted where they stand.
    for name in ["verbs.md", "answers.md", "remarks.md"] {
        pages.retain(|path| !path.ends_with(Path::new("docs/book/src").join(name)));
    }
    texts.extend(pages.into_iter().map(|path| ("docs".to_owned(), path)));
    for (place, path) in texts {
        let text = std::fs::read_to_string(&path).expect("a text can be read");
        let is_page = place == "docs";
        for (i, line) in text.lines().enumerate() {
            let said = line.trim_start();
            if !is_page && !said.starts_with("///") && !said.starts_with("//!") {
                continue;
            }
            for (word, _) in WORDS.iter().filter(|(word, _)| has_phrase(said, word)) {
                let name = path.strip_prefix(root()).unwrap_or(&path).display();
                found.entry((place.clone(), word)).or_default().push(format!("  {name}:{}", i + 1));
            }
        }
    }
    found
}

/// Whether the words stand in the line, one after the other, whole.
fn has_phrase(line: &str, phrase: &str) -> bool {
    let line = line.to_lowercase();
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    line.match_indices(phrase)
        .any(|(at, found)| !line[..at].ends_with(is_word) && !line[at + found.len()..].starts_with(is_word))
}
