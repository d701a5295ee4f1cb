//! Where the models of a file begin and end.

use crate::entries::Entry;
use std::io::{BufRead, BufReader, Read};

/// A longer text is no name.
const LONGEST_NAME: usize = 1 << 12;

/// The models of a file of several, with their names; none if it holds one, or is no JSON: that is for the parser to say. Brackets
/// and quotes are matched, nothing else is looked at.
///
/// # Complexity
/// Linear, in a stream; memory is the list.
pub(crate) fn outline(input: impl Read) -> std::io::Result<Vec<Entry>> {
    let mut input = BufReader::with_capacity(1 << 16, input);
    let mut scan = Scan::default();
    loop {
        let piece = input.fill_buf()?;
        if piece.is_empty() {
            return Ok(scan.into_entries());
        }
        for &byte in piece {
            scan.take(byte);
            scan.position += 1;
        }
        let used = piece.len();
        input.consume(used);
    }
}

/// What was seen so far.
#[derive(Default)]
struct Scan {
    position: u64,
    depth: usize,
    /// Within a text, and whether a backslash stands before the byte.
    is_text: bool,
    is_escaped: bool,
    /// The last text, with its quotes.
    text: Vec<u8>,
    /// The values of the file, and the models of the first where that is a list.
    values: Vec<Entry>,
    elements: Vec<Entry>,
    /// Where the value and the element of a list begin that are being read.
    value: Open,
    element: Open,
    /// Whether the value is a list.
    is_list: bool,
    /// Whether something stands between the values that is none.
    is_odd: bool,
}

/// A value that has begun.
#[derive(Default)]
struct Open {
    start: u64,
    name: Option<String>,
    /// Whether the name follows.
    is_named: bool,
    is_model: bool,
    /// Whether nothing stands behind its bracket yet.
    is_new: bool,
}

impl Open {
    fn closed(&mut self, end: u64) -> Entry {
        Entry { name: self.name.take(), start: self.start, length: end - self.start }
    }
}

impl Scan {
    fn take(&mut self, byte: u8) {
        if self.is_text {
            self.take_text(byte);
            return;
        }
        match byte {
            b' ' | b'\t' | b'\n' | b'\r' => {}
            // What was no text is no name.
            b',' => {
                if let Some(object) = self.object() {
                    object.is_named = false;
                }
            }
            b'"' => {
                (self.is_text, self.element.is_new) = (true, false);
                self.text.clear();
                self.text.push(byte);
                self.is_odd |= self.depth == 0;
            }
            b'[' | b'{' => self.open(byte),
            b']' | b'}' => self.close(),
            b':' if self.text == b"\"name\"" => {
                if let Some(object) = self.object() {
                    object.is_named = true;
                }
            }
            _ => {
                self.is_odd |= self.depth == 0;
                self.element.is_new = false;
            }
        }
    }

    fn take_text(&mut self, byte: u8) {
        if self.text.len() < LONGEST_NAME {
            self.text.push(byte);
        }
        let is_escaped = std::mem::take(&mut self.is_escaped);
        if is_escaped || byte != b'"' {
            self.is_escaped = byte == b'\\' && !is_escaped;
            return;
        }
        self.is_text = false;
        if self.object().is_some_and(|object| std::mem::take(&mut object.is_named)) {
            let name = serde_json::from_slice(&self.text).ok();
            self.object().expect("it is there").name = name;
        }
    }

    /// The object whose keys stand here, if it is a value or the element of a list.
    fn object(&mut self) -> Option<&mut Open> {
        match (self.is_list, self.depth) {
            (false, 1) => Some(&mut self.value),
            (true, 2) => Some(&mut self.element),
            _ => None,
        }
    }

    fn open(&mut self, byte: u8) {
        let start =
            Open { start: self.position, is_model: byte == b'{', is_new: byte == b'[', ..Open::default() };
        match self.depth {
            0 => (self.value, self.is_list) = (start, byte == b'['),
            1 if self.is_list => self.element = start,
            // A list whose first element is a list is one of facets.
            2 if self.is_list && std::mem::take(&mut self.element.is_new) && byte == b'[' => {
                self.element.is_model = true;
            }
            _ => {}
        }
        self.depth += 1;
    }

    fn close(&mut self) {
        let Some(depth) = self.depth.checked_sub(1) else {
            self.is_odd = true;
            return;
        };
        self.depth = depth;
        let end = self.position + 1;
        if depth == 0 {
            let value = self.value.closed(end);
            self.values.push(value);
        } else if depth == 1 && self.is_list && self.element.is_model && self.values.is_empty() {
            let element = self.element.closed(end);
            self.elements.push(element);
        }
    }

    fn into_entries(self) -> Vec<Entry> {
        match self.values.len() {
            _ if self.is_odd || self.depth > 0 || self.is_text => Vec::new(),
            1 => self.elements,
            _ => self.values,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(text: &str) -> Vec<(Option<String>, &str)> {
        let part = |entry: Entry| {
            let start = entry.start as usize;
            (entry.name, &text[start..start + entry.length as usize])
        };
        outline(text.as_bytes()).unwrap().into_iter().map(part).collect()
    }

    #[test]
    fn models_are_found_with_their_names() {
        let named = |name: &str| Some(name.to_owned());
        for one in
            ["", "[]", "[[0, 1], [1, 2]]", r#"{"facets": [[0, 1]], "name": "a"}"#, "[[0, 1]", "7", "[] x"]
        {
            assert_eq!(of(one), [], "{one}");
        }
        let text = r#" [{"name": "a", "facets": [[0]]}, {"facets": [[1]], "other": {"name": "x"}, "name": "b \" ]"}] "#;
        let parts = [r#"{"name": "a", "facets": [[0]]}"#, &text[34..text.len() - 2]];
        assert_eq!(of(text), [(named("a"), parts[0]), (named("b \" ]"), parts[1])]);
        // Names that are no texts.
        assert_eq!(
            of("[{\"name\": 5, \"facets\": []}, {\"name\": null, \"next\": []}]"),
            [(None, "{\"name\": 5, \"facets\": []}"), (None, "{\"name\": null, \"next\": []}")]
        );
        assert_eq!(of("[[[0, 1]], [ [1], [2]]]"), [(None, "[[0, 1]]"), (None, "[ [1], [2]]")]);
        assert_eq!(
            of("[[0, 1]]\n{\"name\":\"b\"}\n"),
            [(None, "[[0, 1]]"), (named("b"), "{\"name\":\"b\"}")]
        );
    }
}
