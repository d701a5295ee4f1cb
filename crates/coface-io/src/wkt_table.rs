//! Tables with a column of well-known text, as databases and GIS export them.
//!
//! Entries stand between commas, semicolons, tabs or bars, in double quotes where they hold one of these; a quote within quotes is doubled
//! (RFC 4180). The first row whose entries are no geometry gives the names of the columns. Each row is a feature: the first entry that is
//! a geometry is drawn, the others are its properties in the order of the columns. Numbers are numbers, `true` and `false` are truth
//! values, empty entries are null. A second column of the name `a` is `a_2`.

use crate::drawing::Drawing;
use crate::scanner::Scanner;
use crate::wkt;
use coface_algebra::Error;
use serde_json::Value;
use std::borrow::Cow;
use std::collections::HashSet;
use std::io::Read;

const DELIMITERS: [u8; 4] = *b",;\t|";
/// The geometry is looked for in so many rows.
const MOST_ROWS: usize = 16;
/// What stands for no geometry.
const NOTHING: [&[u8]; 4] = [b"", b"NULL", b"null", b"\\N"];

/// Whether a file begins as a table whose rows have a geometry.
pub(super) fn is_table(start: &[u8]) -> bool {
    let is_filled = |line: &&[u8]| !line.is_empty() && line[0] != b'#';
    let first = start.split(|&byte| byte == b'\n').map(<[u8]>::trim_ascii).find(is_filled);
    if first.is_none_or(wkt::is_geometry) {
        return false;
    }
    let mut lines = start.split(|&byte| byte == b'\n');
    let mut record = Vec::new();
    let mut rows = 0;
    while rows < MOST_ROWS {
        let Some(line) = lines.next() else { return !record.is_empty() && form_of(&record).is_some() };
        record.extend_from_slice(line);
        if is_whole(&record) {
            if form_of(&record).is_some() {
                return true;
            }
            rows += usize::from(!record.trim_ascii().is_empty());
            record.clear();
        } else {
            record.push(b'\n');
        }
    }
    false
}

/// Reads the rest of a stream as a table.
///
/// # Errors
/// [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) with the line for a row with fewer or more entries than the first, for a quote that is not closed and for a
/// geometry that is none; those of [`wkt::read`].
pub(super) fn read<R: Read>(scanner: Scanner<R>, mut drawing: Drawing) -> Result<Drawing, Error> {
    drawing.tell_empty_features();
    let mut records = Records { scanner, line: 0, record: Vec::new() };
    let mut table = Table { form: None, names: Vec::new(), width: 0, drawing };
    // Rows before the first with a geometry; the first of all has the names.
    let mut before: Vec<(u64, Vec<u8>)> = Vec::new();
    while records.next()? {
        if table.form.is_none() {
            table.form = form_of(&records.record);
            if table.form.is_none() {
                if before.len() == MOST_ROWS {
                    return Err(Error::parse("no row has a geometry").at_line(records.line));
                }
                before.push((records.line, records.record.clone()));
                continue;
            }
            for (line, record) in before.drain(..) {
                table.take(&record, line)?;
            }
        }
        table.take(&records.record, records.line)?;
    }
    Ok(table.drawing)
}

/// Rows, which may go over several lines within quotes.
struct Records<R> {
    scanner: Scanner<R>,
    /// The line on which the row begins.
    line: u64,
    record: Vec<u8>,
}

impl<R: Read> Records<R> {
    /// Takes the next row that is neither empty nor a comment, if there is one.
    fn next(&mut self) -> Result<bool, Error> {
        self.record.clear();
        while let Some(line) = self.scanner.next_line()? {
            let is_first = self.record.is_empty();
            if is_first && (line.trim_ascii().is_empty() || line.starts_with(b"#")) {
                continue;
            }
            self.record.extend_from_slice(line);
            if is_first {
                self.line = self.scanner.line_number();
            }
            if is_whole(&self.record) {
                return Ok(true);
            }
            self.record.push(b'\n');
        }
        if self.record.is_empty() {
            return Ok(false);
        }
        let fault = Error::parse("a quote is opened and never closed").at_line(self.line);
        Err(fault.with_cure("close it, or double it where it is part of a text"))
    }
}

/// How a table is written.
#[derive(Clone, Copy)]
struct Form {
    delimiter: u8,
    column: usize,
}

struct Table {
    form: Option<Form>,
    /// Of the columns, none twice.
    names: Vec<String>,
    width: usize,
    drawing: Drawing,
}

impl Table {
    fn take(&mut self, record: &[u8], line: u64) -> Result<(), Error> {
        let Some(form) = self.form else { return Ok(()) };
        let entries = entries(record, form.delimiter);
        if self.width == 0 {
            self.width = entries.len();
            let text = |entry: &Cow<'_, [u8]>| String::from_utf8_lossy(entry).trim().to_owned();
            if !wkt::is_geometry(entry_at(&entries, form.column)) {
                self.names = distinct(entries.iter().map(text).collect());
                return Ok(());
            }
            self.names = distinct(vec![String::new(); self.width]);
        }
        if entries.len() != self.width {
            let message = format!("a row has {} entries, and the first has {}", entries.len(), self.width);
            return Err(Error::parse(message).at_line(line).with_cure(format!(
                "put entries that hold {} in double quotes",
                match form.delimiter {
                    b'\t' => "a tab".to_owned(),
                    other => format!("\"{}\"", char::from(other)),
                }
            )));
        }
        let geometry = entry_at(&entries, form.column);
        let (mut properties, mut called) = (Vec::new(), None);
        for (column, entry) in entries.iter().enumerate().filter(|&(column, _)| column != form.column) {
            let name = &self.names[column];
            let text = String::from_utf8_lossy(entry);
            properties.push(format!("{}:{}", Value::from(name.as_str()), value_of(&text)));
            if called.is_none() && name.eq_ignore_ascii_case("name") && !text.is_empty() {
                called = Some(text);
            }
        }
        let text =
            if properties.is_empty() { String::new() } else { format!("{{{}}}", properties.join(",")) };
        self.drawing.begin_described(called.as_deref(), &text, "");
        if !NOTHING.contains(&geometry) {
            let drawing = std::mem::take(&mut self.drawing);
            self.drawing = wkt::draw(geometry, line, drawing)?;
        }
        self.drawing.begin_feature(None);
        Ok(())
    }
}

/// The names of columns with none twice; those without are named by their number.
fn distinct(mut names: Vec<String>) -> Vec<String> {
    let mut taken: HashSet<String> = names.iter().cloned().collect();
    let mut seen = HashSet::new();
    for (column, name) in names.iter_mut().enumerate() {
        if name.is_empty() {
            *name = format!("column_{}", column + 1);
        }
        if !seen.insert(name.clone()) {
            let mut others = (2..).map(|number| format!("{name}_{number}"));
            *name = others.find(|other| !taken.contains(other)).unwrap_or_default();
            seen.insert(name.clone());
        }
        taken.insert(name.clone());
    }
    names
}

fn entry_at<'a>(entries: &'a [Cow<'_, [u8]>], column: usize) -> &'a [u8] {
    entries.get(column).map_or(&[][..], |entry| entry.trim_ascii())
}

/// The value that an entry is, as JSON has values.
fn value_of(entry: &str) -> Value {
    match entry.trim() {
        "" => Value::Null,
        "true" | "TRUE" | "True" => Value::Bool(true),
        "false" | "FALSE" | "False" => Value::Bool(false),
        // A number that is written as it would be written again; others, as 007, are names.
        word => match serde_json::from_str::<Value>(word) {
            Ok(Value::Number(number)) => Value::Number(number),
            _ => Value::String(entry.to_owned()),
        },
    }
}

/// The delimiter and column for which a row has a geometry.
fn form_of(record: &[u8]) -> Option<Form> {
    DELIMITERS.into_iter().find_map(|delimiter| {
        let entries = entries(record, delimiter);
        let column = entries.iter().position(|entry| wkt::is_geometry(entry.trim_ascii()))?;
        // The semicolon behind the number of a reference system is part of the geometry.
        let before = column.checked_sub(1).map_or(&[][..], |before| entries[before].trim_ascii());
        let digits = before.iter().rev().take_while(|byte| byte.is_ascii_digit()).count();
        let is_system = before[..before.len() - digits].to_ascii_uppercase().ends_with(b"SRID=");
        if delimiter == b';' && is_system {
            return None;
        }
        Some(Form { delimiter, column })
    })
}

/// Whether the quotes of a row are closed.
fn is_whole(record: &[u8]) -> bool {
    memchr::memchr_iter(b'"', record).count().is_multiple_of(2)
}

/// The entries of a row, without their quotes. Delimiters within the parentheses of a geometry are its own.
fn entries(record: &[u8], delimiter: u8) -> Vec<Cow<'_, [u8]>> {
    let mut entries = Vec::new();
    let mut rest = record;
    loop {
        let length = match rest.first() {
            Some(b'"') => {
                let mut is_quoted = false;
                rest.iter().position(|&byte| {
                    is_quoted ^= byte == b'"';
                    !is_quoted && byte == delimiter
                })
            }
            Some(_) if wkt::is_geometry(rest) => {
                let mut depth = 0;
                rest.iter().position(|&byte| {
                    depth += i32::from(byte == b'(') - i32::from(byte == b')');
                    depth <= 0 && byte == delimiter
                })
            }
            _ => memchr::memchr(delimiter, rest),
        };
        let entry = &rest[..length.unwrap_or(rest.len())];
        entries.push(unquoted(entry));
        let Some(length) = length else { return entries };
        rest = &rest[length + 1..];
    }
}

fn unquoted(entry: &[u8]) -> Cow<'_, [u8]> {
    let trimmed = entry.trim_ascii();
    let Some(inner) = trimmed.strip_prefix(b"\"") else { return Cow::Borrowed(entry) };
    let inner = inner.strip_suffix(b"\"").unwrap_or(inner);
    if !inner.contains(&b'"') {
        return Cow::Borrowed(inner);
    }
    let mut text = Vec::with_capacity(inner.len());
    let mut bytes = inner.iter().peekable();
    while let Some(&byte) = bytes.next() {
        text.push(byte);
        if byte == b'"' {
            bytes.next_if_eq(&&b'"');
        }
    }
    Cow::Owned(text)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{GroupKind, Model};
    use coface_algebra::ErrorKind;

    fn read(text: &str) -> Result<Model, Error> {
        assert!(is_table(text.as_bytes()), "{text}");
        crate::wkt::read(text.as_bytes())
    }

    #[test]
    fn rows_are_features_with_properties() {
        let text = "id,name,wkt\r\n7,\"a, \"\"b\"\"\",\"POLYGON((0 0,2 0,2 2,0 2,0 0))\"\r\n008,c,\"MULTIPOINT(5 5,6 6)\"\r\n9,,\r\n";
        let model = read(text).unwrap();
        assert_eq!((model.lines().len(), model.points().len()), (1, 2));
        assert_eq!(model.features().properties(0), r#"{"id":7,"name":"a, \"b\""}"#);
        assert_eq!(model.features().properties(1), r#"{"id":"008","name":"c"}"#);
        let groups: Vec<_> = model.groups().iter().map(|group| (group.kind(), group.name())).collect();
        assert_eq!(groups, [(GroupKind::Vertices, "c"), (GroupKind::Lines, "a, \"b\"")]);
        assert!(model.remarks()[0].message.starts_with("1 feature has no geometry"), "{:?}", model.remarks());
    }

    #[test]
    fn columns_keep_their_order_and_names_are_distinct() {
        let of = |text: &str| read(text).unwrap().features().properties(0).to_owned();
        assert_eq!(
            of("b,wkt,a,b,,b_2\n1,POINT(1 1),2,3,4,5\n"),
            r#"{"b":1,"a":2,"b_3":3,"column_5":4,"b_2":5}"#
        );
        assert_eq!(of("x,POINT(1 1),7\n"), r#"{"column_1":"x","column_3":7}"#);
    }

    #[test]
    fn other_delimiters_and_no_names_will_do() {
        for text in [
            "1;POLYGON((0 0,2 0,2 2,0 0));x\n2;POINT(1 1);y\n",
            "a\tb\tc\n1\tSRID=4326;POLYGON((0 0,2 0,2 2,0 0))\tx\n2\tSRID=4326;POINT(1 1)\ty\n",
            "id,the_geom,c\n1,POLYGON((0 0,2 0,2 2,0 0)),x\n2,POINT(1 1),y\n",
            "WKT\n\"POLYGON((0 0,2 0,\n2 2,0 0))\"\nPOINT(1 1)\n",
            "0,0101000000000000000000F03F000000000000F03F\n1,\"LINESTRING(0 0,2 0,2 2,0 0)\"\n",
        ] {
            let model = read(text).unwrap();
            assert_eq!((model.lines().len(), model.points().len()), (1, 1), "{text}");
        }
        for text in ["x,y\n1,2\n", "POINT (1 1)\n", "", "1 2 3\n4 5 6\n", "\"a\n"] {
            assert!(!is_table(text.as_bytes()), "{text}");
        }
    }

    #[test]
    fn faults_are_named_with_their_line() {
        let fault = |text: &str| read(text).unwrap_err();
        let short = fault("id,wkt\n1,\"POINT(1 1)\"\n2,3,\"POINT(1 1)\"\n");
        assert_eq!((short.line(), short.kind()), (Some(3), ErrorKind::Parse));
        assert!(short.to_string().contains("3 entries, and the first has 2"), "{short}");
        assert_eq!(fault("id,wkt\n1,\"POINT(1 1)\"\n2,\"POINT(1\n\n x)\"\n").line(), Some(5));
        assert!(fault("id,wkt\n1,\"POINT(1 1)\"\n2,\"POINT(1 1)\n").to_string().contains("never closed"));
        assert!(fault("id,wkt\n1,\"POINT(1 1)\"\n2,POINT(1 1) x\n").to_string().contains("behind"));
    }
}
