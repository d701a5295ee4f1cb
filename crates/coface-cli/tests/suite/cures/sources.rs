//! The string literals of the sources that name a command or an option.

use std::path::Path;

/// A literal in the sources that names a command or an option.
pub(super) struct Literal {
    /// The path within `crates`, with `/` between its parts.
    pub(super) file: String,
    pub(super) line: usize,
    /// The text with single spaces.
    pub(super) text: String,
    /// The options and commands that it names, such as `--rule` and `coface convert`.
    pub(super) names: Vec<String>,
}

/// All literals of the library and the program that name a command or an option, by file and line.
pub(super) fn literals(crates: &Path, verbs: &[String]) -> Vec<Literal> {
    let mut files = Vec::new();
    for entry in std::fs::read_dir(crates).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap().to_owned();
        if !["coface-bench", "coface-py"].contains(&name.as_str()) {
            collect(&path.join("src"), &format!("{name}/src"), &mut files);
        }
    }
    files.sort();
    let mut found = Vec::new();
    for (file, path) in files {
        let source = std::fs::read_to_string(path).unwrap();
        for (line, text) in strings(&source) {
            let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
            let names = names(&text, verbs);
            // An option alone is a word for the program, not a message.
            if !names.is_empty() && names[0] != text {
                found.push(Literal { file: file.clone(), line, text, names });
            }
        }
    }
    found
}

fn collect(folder: &Path, name: &str, files: &mut Vec<(String, std::path::PathBuf)>) {
    let Ok(entries) = std::fs::read_dir(folder) else { return };
    for entry in entries {
        let path = entry.unwrap().path();
        let own = path.file_name().unwrap().to_str().unwrap().to_owned();
        let place = format!("{name}/{own}");
        if path.is_dir() {
            if own != "tests" && own != "samples" {
                collect(&path, &place, files);
            }
        } else if own.ends_with(".rs") && own != "tests.rs" && own != "samples.rs" {
            files.push((place, path));
        }
    }
}

/// The options and commands that a text names, in order.
pub(super) fn names(text: &str, verbs: &[String]) -> Vec<String> {
    let is_part = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
    let before = |at: usize| text[..at].chars().next_back();
    let mut found = Vec::new();
    for (at, _) in text.match_indices("--") {
        let rest = &text[at + 2..];
        let end = rest.find(|c| !is_part(c)).unwrap_or(rest.len());
        let is_start = before(at).is_none_or(|c| c == '(' || c == '`' || c == '"' || c.is_whitespace());
        if is_start && rest.starts_with(|c: char| c.is_ascii_lowercase()) {
            found.push((at, format!("--{}", &rest[..end])));
        }
    }
    for (at, _) in text.match_indices("coface ") {
        let rest = &text[at + 7..];
        let end = rest.find(|c| !is_part(c)).unwrap_or(rest.len());
        let is_start = before(at).is_none_or(|c| !c.is_alphanumeric());
        if is_start && verbs.iter().any(|verb| *verb == rest[..end]) {
            found.push((at, format!("coface {}", &rest[..end])));
        }
    }
    found.sort();
    found.into_iter().map(|(_, name)| name).collect()
}

/// The string literals of Rust source outside of comments, attributes and what is compiled for tests alone, with lines.
pub(super) fn strings(source: &str) -> Vec<(usize, String)> {
    let bytes = source.as_bytes();
    let (mut found, mut at, mut line) = (Vec::new(), 0, 1);
    // What is compiled for tests alone goes to a semicolon or a closing brace of its own level.
    let (mut is_of_tests, mut depth) = (false, 0_usize);
    while at < bytes.len() {
        let rest = &source[at..];
        let end = if rest.starts_with("//") {
            at + rest.find('\n').unwrap_or(rest.len())
        } else if rest.starts_with("/*") {
            at + rest.find("*/").map_or(rest.len(), |end| end + 2)
        } else if rest.starts_with("#[") || rest.starts_with("#![") {
            let end = at + end_of_attribute(rest);
            is_of_tests |= source[at..end] == *"#[cfg(test)]";
            end
        } else if let Some((start, end)) = raw_string(rest).filter(|_| at == 0 || !is_word(bytes[at - 1])) {
            if !is_of_tests {
                found.push((line, rest[start.0..start.1].to_owned()));
            }
            at + end
        } else if rest.starts_with('"') {
            let end = end_of_string(rest);
            if !is_of_tests {
                found.push((line, unescaped(&rest[1..end - 1])));
            }
            at + end
        } else if rest.starts_with('\'') {
            at + end_of_quote(rest)
        } else {
            match bytes[at] {
                b'{' => depth += usize::from(is_of_tests),
                // A variant or an arm of tests ends with what it is in.
                b'}' if is_of_tests => {
                    depth = depth.saturating_sub(1);
                    is_of_tests = depth > 0;
                }
                b';' if depth == 0 => is_of_tests = false,
                _ => {}
            }
            at + rest.chars().next().map_or(1, char::len_utf8)
        };
        line += source[at..end].matches('\n').count();
        at = end;
    }
    found
}

fn is_word(byte: u8) -> bool {
    byte.is_ascii_alphanumeric() || byte == b'_'
}

fn end_of_attribute(rest: &str) -> usize {
    let (mut depth, mut at) = (0, 0);
    while at < rest.len() {
        match rest.as_bytes()[at] {
            b'"' => at += end_of_string(&rest[at..]) - 1,
            b'[' => depth += 1,
            b']' if depth == 1 => return at + 1,
            b']' => depth -= 1,
            _ => {}
        }
        at += 1;
    }
    rest.len()
}

/// Where the text of a raw string begins and ends, and where the literal ends.
fn raw_string(rest: &str) -> Option<((usize, usize), usize)> {
    let after = rest.strip_prefix("br").or_else(|| rest.strip_prefix('r'))?;
    let marks = after.len() - after.trim_start_matches('#').len();
    after[marks..].strip_prefix('"')?;
    let start = rest.len() - after.len() + marks + 1;
    let closing = format!("\"{}", "#".repeat(marks));
    let end = start + rest[start..].find(&closing)?;
    Some(((start, end), end + closing.len()))
}

fn end_of_string(rest: &str) -> usize {
    let bytes = rest.as_bytes();
    let mut at = 1;
    while bytes[at] != b'"' {
        at += if bytes[at] == b'\\' { 2 } else { 1 };
    }
    at + 1
}

/// The end of a character, or of the mark of a lifetime.
fn end_of_quote(rest: &str) -> usize {
    let mut chars = rest.char_indices().skip(1);
    match chars.next() {
        Some((_, '\\')) => rest[3..].find('\'').map_or(rest.len(), |end| end + 4),
        _ => match chars.next() {
            Some((at, '\'')) => at + 1,
            _ => 1,
        },
    }
}

fn unescaped(text: &str) -> String {
    let mut plain = String::with_capacity(text.len());
    let mut chars = text.chars();
    while let Some(c) = chars.next() {
        match (c, chars.as_str().chars().next()) {
            ('\\', Some('\n')) => {
                let rest = chars.as_str().trim_start();
                chars = rest.chars();
            }
            ('\\', Some(next)) => {
                chars.next();
                plain.push(if next == 'n' || next == 't' { ' ' } else { next });
            }
            _ => plain.push(c),
        }
    }
    plain
}

/// The reader of sources sees messages, and neither comments, attributes nor tests.
#[test]
fn literals_of_messages_are_found() {
    let source = r##"
//! "--comment"
#[arg(help = "--attribute ]")]
const A: &str = "one \"--rule\"; \
                 and more";
const B: char = '"'; const C: &'static str = r#"raw "--snap""#;
#[cfg(test)]
mod tests { const D: &str = "--of-tests"; fn f() { g("{"); } }
#[cfg(test)]
mod more;
fn f<'a>(text: &'a str) { g("coface convert FILE --repair", '\'', "a--b coface of"); }
"##;
    let found = strings(source);
    let texts: Vec<&str> = found.iter().map(|(_, text)| text.as_str()).collect();
    assert_eq!(
        texts,
        ["one \"--rule\"; and more", "raw \"--snap\"", "coface convert FILE --repair", "a--b coface of"]
    );
    let lines: Vec<usize> = found.iter().map(|(line, _)| *line).collect();
    assert_eq!(lines, [4, 6, 11, 11]);
    let verbs = ["convert".to_owned()];
    let named: Vec<Vec<String>> = texts.iter().map(|text| names(text, &verbs)).collect();
    assert_eq!(named, [vec!["--rule"], vec!["--snap"], vec!["coface convert", "--repair"], vec![]]);
}
