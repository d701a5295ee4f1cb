//! Edge lists: a line an edge.

use super::rows::{FORM, Rows, at};
use crate::decimal_commas::{whole_text, with_decimal_points};
use crate::scanner::{Scanner, parse_coordinate, quoted};
use coface_algebra::Error;
use std::borrow::Cow;
use std::io::Read;

/// What columns of vertices are called in headers, where no third column tells.
const ENDS: [&str; 14] =
    ["source", "target", "from", "to", "u", "v", "i", "j", "src", "dst", "tail", "head", "node1", "vertex1"];
/// What columns of values are called.
const VALUES: [&str; 7] = ["weight", "value", "distance", "length", "cost", "w", "d"];

/// The edges of a text.
pub(super) fn rows(input: impl Read) -> Result<Rows, Error> {
    let text = whole_text(input)?;
    let (text, commas) = with_decimal_points(&text)?;
    let mut scanner = Scanner::new(&text[..]);
    let mut rows = Rows::default();
    rows.remarks.extend(commas);
    let mut columns = Columns::default();
    let mut section = None;
    let mut is_first = true;
    while let Some(line) = scanner.next_line()? {
        let line = line.strip_prefix(b"\xef\xbb\xbf").unwrap_or(line).trim_ascii().to_vec();
        if line.starts_with(b"#") || line.starts_with(b"//") || line.starts_with(b"%") {
            continue;
        }
        let words = words(&line);
        if words.is_empty() {
            continue;
        }
        let number = Some(scanner.line_number());
        if let Some(found) = section_of(&words) {
            section = Some(found);
        } else if section == Some(Section::Vertices) {
            values_of_vertices(&mut rows, &words, number)?;
        } else if is_first && section.is_none() && columns.take_header(&words) {
            // The columns are known now.
        } else {
            row(&mut rows, &columns, &words, number)?;
        }
        is_first = false;
    }
    Ok(rows)
}

/// A part of a file of flagser.
#[derive(Clone, Copy, PartialEq)]
enum Section {
    Vertices,
    Edges,
}

/// The part that a line `dim 0:` or `dim 1` begins.
fn section_of(words: &[Cow<'_, [u8]>]) -> Option<Section> {
    match words {
        [dim, degree] if dim.eq_ignore_ascii_case(b"dim") => {
            match degree.strip_suffix(b":").unwrap_or(degree) {
                b"0" => Some(Section::Vertices),
                b"1" => Some(Section::Edges),
                _ => None,
            }
        }
        _ => None,
    }
}

fn values_of_vertices(rows: &mut Rows, words: &[Cow<'_, [u8]>], line: Option<u64>) -> Result<(), Error> {
    for word in words {
        let value = parse_coordinate(word, "each value of a vertex")
            .map_err(|error| at(error.with_cure(FORM), line))?;
        let vertex = rows.vertex(&rows.vertex_count().to_string());
        rows.push_birth(vertex, value, line)?;
    }
    Ok(())
}

/// Where the values are.
#[derive(Default)]
struct Columns {
    /// Of a file with a header, the number of columns and the one of values.
    named: Option<(usize, Option<usize>)>,
}

impl Columns {
    /// Takes a first line of words for a header.
    fn take_header(&mut self, words: &[Cow<'_, [u8]>]) -> bool {
        let is_number = |word: &Cow<'_, [u8]>| parse_coordinate(word, "").is_ok();
        let is_called =
            |names: &[&str], word: &[u8]| names.iter().any(|name| word.eq_ignore_ascii_case(name.as_bytes()));
        if words.len() < 2 || words.iter().any(is_number) {
            return false;
        }
        if words.len() == 2 && !words.iter().all(|word| is_called(&ENDS, word)) {
            return false;
        }
        let named = (2..words.len()).find(|&column| is_called(&VALUES, &words[column]));
        let only = (words.len() == 3).then_some(2);
        self.named = Some((words.len(), named.or(only)));
        true
    }
}

fn row(rows: &mut Rows, columns: &Columns, words: &[Cow<'_, [u8]>], line: Option<u64>) -> Result<(), Error> {
    let fault = |message: String| at(Error::parse(message).with_cure(FORM), line);
    let (width, place) = columns.named.unwrap_or((3, Some(2)));
    if words.len() > width {
        return Err(fault(format!("the row has {} entries, not {width}", words.len())));
    }
    let mut ends = Vec::with_capacity(2);
    for word in words.iter().take(2) {
        ends.push(vertex(rows, word).map_err(fault)?);
    }
    let value = match place.and_then(|place| words.get(place)) {
        Some(word) => Some(
            parse_coordinate(word, "the value of an edge")
                .map_err(|error| at(error.with_cure(FORM), line))?,
        ),
        None => None,
    };
    match ends[..] {
        [i, j] => rows.push_row(i, j, value, line),
        _ => Ok(()),
    }
}

fn vertex(rows: &mut Rows, word: &[u8]) -> Result<u32, String> {
    let is_number =
        !word.iter().all(u8::is_ascii_digit) && parse_coordinate(word, "").is_ok_and(f64::is_finite);
    match std::str::from_utf8(word) {
        Ok(name) if !is_number => Ok(rows.vertex(name)),
        _ => Err(format!("{} is no vertex", quoted(word))),
    }
}

/// The words of a line, without the quotes of those that have some.
fn words(line: &[u8]) -> Vec<Cow<'_, [u8]>> {
    let is_separator = |byte: u8| matches!(byte, b' ' | b'\t' | b',' | b';');
    let mut words = Vec::new();
    let mut at = 0;
    while at < line.len() {
        if is_separator(line[at]) {
            at += 1;
            continue;
        }
        if line[at] == b'"'
            && let Some((word, end)) = quoted_word(&line[at + 1..])
        {
            words.push(word);
            at += 1 + end;
            continue;
        }
        let end = line[at..].iter().position(|&byte| is_separator(byte)).map_or(line.len(), |end| at + end);
        words.push(Cow::Borrowed(&line[at..end]));
        at = end;
    }
    words
}

/// The word up to its quote, where two quotes are one, and how long it is with that.
fn quoted_word(rest: &[u8]) -> Option<(Cow<'_, [u8]>, usize)> {
    let mut word = Vec::new();
    let mut at = 0;
    loop {
        match (rest.get(at)?, rest.get(at + 1)) {
            (b'"', Some(b'"')) => {
                word.push(b'"');
                at += 2;
            }
            (b'"', _) => return Some((Cow::Owned(word), at + 1)),
            (&byte, _) => {
                word.push(byte);
                at += 1;
            }
        }
    }
}
