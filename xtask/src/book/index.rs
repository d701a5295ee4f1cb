//! The index of the book: terms in the order of the alphabet, with links to the sections that explain them.
//!
//! `terms.txt` has a line for each term: `term: chapter#heading, chapter`. A chapter is named by its file, a heading as in links. A place without a
//! heading is the whole chapter.

use super::page::headings;
use super::{Chapter, keep, source};
use std::collections::BTreeMap;

/// The terms and their places.
const TERMS: &str = include_str!("terms.txt");

/// The name of the page.
pub(super) const NAME: &str = "index-of-terms";

/// Writes or compares the index. The faults are places that no chapter has, and a page that differs.
pub(super) fn index(chapters: &[Chapter], is_written: bool) -> Vec<String> {
    let (text, mut faults) = page(TERMS, chapters);
    faults.extend(keep(&source().join(format!("{NAME}.md")), &text, is_written));
    faults
}

/// The page, and the faults of the list.
fn page(terms: &str, chapters: &[Chapter]) -> (String, Vec<String>) {
    let titles: BTreeMap<&str, (&str, BTreeMap<String, String>)> = chapters
        .iter()
        .map(|chapter| (chapter.name.as_str(), (chapter.title.as_str(), headings(&chapter.text))))
        .collect();
    let mut faults = Vec::new();
    let mut text = "# Index\n\nEach term leads to the sections that explain it. The [glossary](glossary.md) says in one line what a term means.\n".to_owned();
    let mut last = String::new();
    for line in terms.lines().filter(|line| !line.is_empty()) {
        let Some((term, places)) = line.split_once(": ") else {
            faults.push(format!("terms.txt: {line:?} has no places behind a colon"));
            continue;
        };
        let order = term.to_lowercase();
        if order <= last {
            faults.push(format!("terms.txt: {term:?} stands behind a term that it comes before, or twice"));
        }
        let letter = |word: &str| word.chars().next().map(|letter| letter.to_uppercase().to_string());
        if letter(&order) != letter(&last) {
            text.push_str(&format!("\n## {}\n\n", letter(&order).unwrap_or_default()));
        }
        let mut links = Vec::new();
        for place in places.split(", ") {
            let (name, heading) =
                place.split_once('#').map_or((place, None), |(name, heading)| (name, Some(heading)));
            let found = titles.get(name).and_then(|(title, headings)| match heading {
                None => Some(format!("[{title}]({name}.md)")),
                Some(heading) => {
                    headings.get(heading).map(|said| format!("[{title}: {said}]({name}.md#{heading})"))
                }
            });
            match found {
                Some(link) => links.push(link),
                None => faults.push(format!("terms.txt: {term:?} leads to {place}, which no chapter has")),
            }
        }
        text.push_str(&format!("- {term}: {}\n", links.join(", ")));
        last = order;
    }
    (text, faults)
}

#[cfg(test)]
mod tests {
    use super::{TERMS, page};
    use crate::book::{Chapter, chapters};

    #[test]
    fn places_of_terms_are_headings_of_the_book() {
        let (text, faults) = page(TERMS, &chapters().expect("the summary names pages that are there"));
        assert_eq!(faults, Vec::<String>::new());
        assert!(text.lines().filter(|line| line.starts_with("- ")).count() > 100);
    }

    #[test]
    fn terms_are_sorted_linked_and_checked() {
        let chapter = Chapter {
            name: "cells".to_owned(),
            title: "Cells".to_owned(),
            depth: 0,
            text: "# Cells\n\n## The `VE` operator\n".to_owned(),
        };
        let (text, faults) = page("Chain: cells\ncell: cells#the-ve-operator\nlink: rooms\nloop", &[chapter]);
        assert!(text.ends_with("\n## C\n\n- Chain: [Cells](cells.md)\n- cell: [Cells: The VE operator](cells.md#the-ve-operator)\n\n## L\n\n- link: \n"));
        assert_eq!(faults.len(), 3, "{faults:?}");
        assert!(faults[0].contains("\"cell\" stands behind"));
    }
}
