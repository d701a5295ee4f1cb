//! `cargo xtask api`: what each crate offers, one item a line, kept in `docs/api` so that a change of it is seen.
//!
//! The list is made of the sources: items that are `pub`, with the module of their file, and what an `impl` of a type adds. Hidden items and
//! those of tests are left out.

use crate::root;
use crate::tokens::tokens;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// The crates that others may depend on.
const CRATES: &[&str] = &[
    "coface",
    "coface-algebra",
    "coface-geometry",
    "coface-complexes",
    "coface-topology",
    "coface-arrange",
    "coface-yin",
    "coface-io",
    "coface-answers",
    "coface-pictures",
    "coface-scale",
];

/// Writes the lists with `--write`; else says which of them have changed.
pub(crate) fn api(words: &[String]) -> ExitCode {
    let is_writing = match words {
        [] => false,
        [word] if word == "--write" => true,
        _ => {
            eprintln!("usage: cargo xtask api [--write]");
            return ExitCode::from(2);
        }
    };
    let mut is_current = true;
    for name in CRATES {
        let (path, new) = (list_of(name), listed(name));
        if is_writing {
            let folder = path.parent().map(std::fs::create_dir_all).transpose();
            if let Err(error) = folder.and_then(|_| std::fs::write(&path, new)) {
                eprintln!("error: {}: {error}", path.display());
                return ExitCode::FAILURE;
            }
        } else {
            let changes = changes(&std::fs::read_to_string(&path).unwrap_or_default(), &new);
            print!("{changes}");
            is_current &= changes.is_empty();
        }
    }
    if is_current { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// The file that holds the list of a crate.
fn list_of(name: &str) -> PathBuf {
    root().join("docs/api").join(name).with_extension("txt")
}

/// The list of a crate as its sources have it.
fn listed(name: &str) -> String {
    let src = root().join("crates").join(name).join("src");
    let mut lines = Vec::new();
    walk(&src, &mut Vec::new(), &mut lines);
    lines.sort();
    lines.dedup();
    lines.into_iter().map(|line| line + "\n").collect()
}

fn walk(folder: &Path, module: &mut Vec<String>, lines: &mut Vec<String>) {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    for path in entries.map(|entry| entry.path()) {
        let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        if stem.ends_with("tests") {
            continue;
        }
        let is_page = matches!(stem.as_str(), "lib" | "mod");
        if !is_page {
            module.push(stem);
        }
        if path.is_dir() {
            walk(&path, module, lines);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            let text = std::fs::read_to_string(&path).unwrap_or_default();
            let place = module.join("::");
            lines.extend(items(&text).into_iter().map(|item| format!("{place}: {item}")));
        }
        if !is_page {
            module.pop();
        }
    }
}

/// The public items of a file, in the order of the text.
fn items(text: &str) -> Vec<String> {
    let tokens = tokens(text);
    let mut found = Vec::new();
    read(&tokens, "", &mut found);
    found
}

/// Reads the items of a block; `owner` is the type that an `impl` is of.
fn read(tokens: &[String], owner: &str, found: &mut Vec<String>) {
    let mut i = 0;
    let mut is_hidden = false;
    while i < tokens.len() {
        let token = |k: usize| tokens.get(i + k).map_or("", String::as_str);
        match token(0) {
            "#" => {
                let start = i + if token(1) == "!" { 2 } else { 1 };
                let end = closing(tokens, start);
                let words = tokens[start..end].join("");
                is_hidden |= words.contains("doc(hidden)") || words.contains("cfg(test)");
                i = end;
                continue;
            }
            "pub" if token(1) != "(" => {
                let kind = (1..5).map(token).find(|word| {
                    ["fn", "struct", "enum", "trait", "mod", "const", "static", "type", "use", "union"]
                        .contains(word)
                });
                let whole = kind.is_some_and(|kind| matches!(kind, "enum" | "trait" | "use"));
                let (signature, end) = signature(tokens, i + 1, whole);
                if !is_hidden {
                    let owner = if owner.is_empty() { String::new() } else { format!("{owner}::") };
                    found.push(format!("{owner}{signature}"));
                    // Fields: those of a struct stand in its braces.
                    if kind == Some("struct") && tokens.get(end).is_some_and(|token| token == "{") {
                        let name = tokens.get(i + 2).map_or("", String::as_str);
                        fields(&tokens[end + 1..closing(tokens, end) - 1], name, found);
                    }
                }
                i = end;
                i = match (kind, tokens.get(i).map(String::as_str)) {
                    (Some("mod"), Some("{")) if !is_hidden => i + 1,
                    (_, Some("{")) => closing(tokens, i),
                    _ => i + 1,
                };
            }
            "impl" => {
                let open = (i..tokens.len()).find(|&k| tokens[k] == "{").unwrap_or(tokens.len());
                let end = closing(tokens, open);
                let head = &tokens[i + 1..open];
                // What a trait gives to a type is listed as one line, without its items.
                if head.iter().any(|word| word == "for") {
                    if !is_hidden {
                        found.push(format!("impl {}", join(head)));
                    }
                } else if open < tokens.len() && !is_hidden {
                    read(&tokens[open + 1..end - 1], &join(head), found);
                }
                i = end;
            }
            "{" => i = closing(tokens, i),
            _ => {
                // An item that is not public: its attributes do not belong to the next one.
                let is_sign = matches!(token(0), ";" | "}");
                let is_item = matches!(
                    token(0),
                    "fn" | "struct" | "enum" | "trait" | "mod" | "const" | "static" | "type" | "use"
                );
                is_hidden &= !is_sign;
                if is_item {
                    let end = (i..tokens.len())
                        .find(|&k| matches!(tokens[k].as_str(), ";" | "{"))
                        .unwrap_or(tokens.len());
                    i = if tokens.get(end).is_some_and(|token| token == "{") {
                        closing(tokens, end)
                    } else {
                        end + 1
                    };
                    is_hidden = false;
                } else {
                    i += 1;
                }
                continue;
            }
        }
        is_hidden = false;
    }
}

/// The public fields of a struct.
fn fields(tokens: &[String], name: &str, found: &mut Vec<String>) {
    let mut depth = 0_i32;
    let mut start = None;
    for (i, token) in tokens.iter().enumerate() {
        match token.as_str() {
            "(" | "[" | "{" | "<" => depth += 1,
            ")" | "]" | "}" => depth -= 1,
            ">" if i > 0 && tokens[i - 1] != "-" => depth -= 1,
            "pub" if depth == 0 && tokens.get(i + 1).is_some_and(|next| next != "(") => start = Some(i + 1),
            "," if depth == 0 => {
                found.extend(start.take().map(|start| format!("{name}.{}", join(&tokens[start..i]))));
            }
            _ => {}
        }
    }
    found.extend(start.map(|start| format!("{name}.{}", join(&tokens[start..]))));
}

/// The words of an item up to its body, or with its body (without bodies within it), and the place after them.
fn signature(tokens: &[String], start: usize, is_whole: bool) -> (String, usize) {
    let mut depth = 0_usize;
    let mut angles = 0_usize;
    let mut words: Vec<String> = Vec::new();
    let mut i = start;
    while let Some(token) = tokens.get(i) {
        match token.as_str() {
            ";" if depth == 0 => break,
            // The value of a constant, or what a type is short for; not `Iterator<Item = ..>`.
            "=" if depth == 0 && angles == 0 => break,
            "<" => angles += 1,
            ">" if words.last().is_none_or(|last| last != "-") => angles = angles.saturating_sub(1),
            "{" if depth == 0 && !is_whole => break,
            "#" => {
                i = closing(tokens, i + 1);
                continue;
            }
            // A body of a function in a trait.
            "{" if depth == 1 && words.first().is_some_and(|word| word == "trait") => {
                i = closing(tokens, i);
                words.push(";".to_owned());
                continue;
            }
            "{" | "(" | "[" => depth += 1,
            "}" | ")" | "]" => depth = depth.saturating_sub(1),
            _ => {}
        }
        words.push(token.clone());
        i += 1;
        if token == "}" && depth == 0 {
            return (join(&words), i.saturating_sub(1));
        }
    }
    (join(&words), i)
}

/// The place after the bracket that closes the one at `open`.
fn closing(tokens: &[String], open: usize) -> usize {
    let mut depth = 0_usize;
    for (i, token) in tokens.iter().enumerate().skip(open) {
        match token.as_str() {
            "{" | "(" | "[" => depth += 1,
            "}" | ")" | "]" => {
                depth = depth.saturating_sub(1);
                if depth == 0 {
                    return i + 1;
                }
            }
            _ => {}
        }
    }
    tokens.len()
}

/// Words with spaces between them where two of them meet.
fn join(tokens: &[String]) -> String {
    let is_word = |text: &str| text.ends_with(|c: char| c.is_alphanumeric() || c == '_');
    let mut text = String::new();
    for token in tokens {
        if is_word(&text) && is_word(token) || matches!(text.chars().last(), Some(',' | ';')) {
            text.push(' ');
        }
        text.push_str(token);
    }
    text
}

/// The lines that are in one text only.
fn changes(old: &str, new: &str) -> String {
    let only = |of: &str, other: &str, sign: char| {
        let others: std::collections::BTreeSet<&str> = other.lines().collect();
        of.lines()
            .filter(|line| !others.contains(line))
            .map(|line| format!("{sign} {line}\n"))
            .collect::<String>()
    };
    only(old, new, '-') + &only(new, old, '+')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_lists_are_those_of_the_sources() {
        let mut faults = String::new();
        for name in CRATES {
            let old = std::fs::read_to_string(list_of(name)).unwrap_or_default();
            let changes = changes(&old, &listed(name));
            if !changes.is_empty() {
                faults += &format!("{name}\n{changes}");
            }
        }
        assert!(
            faults.is_empty(),
            "what the crates offer has changed; if that is meant: cargo xtask api --write\n{faults}"
        );
    }

    #[test]
    fn public_items_are_listed_with_their_signatures() {
        let text = "
            #[derive(Debug)] pub struct Pair<T> { pub first: Vec<(u32, T)>, second: T, pub(crate) third: u8 }
            pub(crate) fn hidden() {}
            #[doc(hidden)] pub fn also_hidden() { }
            impl<T> Pair<T> { pub fn first(&self) -> &[T] { if a { b } } fn own(&self) {} pub const N: usize = 3; }
            impl Clone for Pair<u8> { fn clone(&self) -> Self { } }
            pub trait Cells { fn count(&self) -> usize; fn is_empty(&self) -> bool { self.count() == 0 } }
            pub enum Sign { Plus, Minus }
            pub use self::x::{A, B};
            #[cfg(test)] mod tests { pub fn f() {} }
            pub fn last() -> impl Iterator<Item = u8> {}
            pub type Pairs = Vec<(u8, u8)>;
        ";
        assert_eq!(
            items(text),
            [
                "struct Pair<T>",
                "Pair.first:Vec<(u32, T)>",
                "<T>Pair<T>::fn first(&self)->&[T]",
                "<T>Pair<T>::const N:usize",
                "impl Clone for Pair<u8>",
                "trait Cells{fn count(&self)->usize; fn is_empty(&self)->bool; }",
                "enum Sign{Plus, Minus}",
                "use self::x::{A, B}",
                "fn last()->impl Iterator<Item=u8>",
                "type Pairs",
            ]
        );
    }

    #[test]
    fn changes_are_lines_of_one_side() {
        assert_eq!(changes("a\nb\n", "b\nc\n"), "- a\n+ c\n");
    }
}
