//! Columns of words in tables of numbers: names, labels, dates.

use crate::scanner::{parse_coordinate, quoted};
use crate::{Remark, RemarkCode};
use coface_algebra::Error;

/// Which columns of a table have words: those whose first entry is one.
#[derive(Debug, Default)]
pub(crate) struct WordColumns {
    has_words: Vec<bool>,
}

impl WordColumns {
    /// By the first row. A row of words alone is not a row of such columns.
    pub(crate) fn of(row: &[&[u8]]) -> Self {
        let mut has_words: Vec<bool> = row.iter().map(|word| is_word(word)).collect();
        if !has_words.contains(&false) {
            has_words.clear();
        }
        Self { has_words }
    }

    /// Whether a column has words.
    pub(crate) fn has_words(&self, column: usize) -> bool {
        self.has_words.get(column).is_some_and(|&has_words| has_words)
    }

    pub(crate) fn count(&self) -> usize {
        self.has_words.iter().filter(|&&has_words| has_words).count()
    }

    /// That these columns are left out, and what else is said.
    pub(crate) fn remark(&self, more: &str) -> Remark {
        let columns = if self.count() == 1 { "a column of words is" } else { "columns of words are" };
        Remark::new(RemarkCode::DataLeftOut, format!("{columns} left out{more}")).at(self.count(), [])
    }

    /// The numbers of a row; `what` is one of them.
    ///
    /// # Errors
    /// `Parse` for a word where a number should be, and where columns have words for a number among them and for a row of another length.
    pub(crate) fn numbers(&self, row: &[&[u8]], what: &str) -> Result<Vec<f64>, Error> {
        if self.count() > 0 && row.len() != self.has_words.len() {
            let message =
                format!("a line has {} entries, and the first has {}", row.len(), self.has_words.len());
            return Err(Error::parse(message).with_cure("give each line as many entries"));
        }
        let mut numbers = Vec::with_capacity(row.len());
        for (column, word) in row.iter().enumerate() {
            if !self.has_words(column) {
                numbers.push(parse_coordinate(word, what)?);
            } else if !is_word(word) {
                let message = format!("{} is a number, and the column begins with a word", quoted(word));
                return Err(
                    Error::parse(message).with_cure("write numbers into all lines of a column, or words")
                );
            }
        }
        Ok(numbers)
    }
}

/// A first line of words: how many columns it names, and whether a row has as many entries.
#[derive(Debug, Default)]
pub(crate) struct Header {
    /// The number of columns and the line.
    names: Option<(usize, u64)>,
    /// The entries of the first row.
    first: Option<usize>,
    fits: bool,
}

impl Header {
    pub(crate) fn of(count: usize, line: u64) -> Self {
        Self { names: Some((count, line)), ..Self::default() }
    }

    pub(crate) fn is_none(&self) -> bool {
        self.names.is_none()
    }

    /// A row has so many entries.
    pub(crate) fn note_row(&mut self, count: usize) {
        self.first.get_or_insert(count);
        self.fits |= self.names.is_none_or(|(names, _)| names == count);
    }

    /// Refuses a header that names other columns than there are.
    ///
    /// # Errors
    /// `Parse` with its line.
    pub(crate) fn check(&self) -> Result<(), Error> {
        let (Some((names, line)), Some(first), false) = (self.names, self.first, self.fits) else {
            return Ok(());
        };
        let columns = if names == 1 { "column" } else { "columns" };
        let entries = if first == 1 { "entry" } else { "entries" };
        let message = format!("the header has {names} {columns}, and the first row has {first} {entries}");
        Err(Error::parse(message).at_line(line).with_cure(
            "name all columns, begin the line with # if it is a title, and write decimal points or semicolons between numbers that have decimal commas",
        ))
    }
}

/// The entries of a line: between blanks, tabs, commas or semicolons, of which several are one. In double quotes these are part of an entry.
pub(crate) fn entries(line: &[u8]) -> Vec<&[u8]> {
    let is_separator = |byte: &u8| matches!(byte, b' ' | b'\t' | b',' | b';' | b'\r');
    let (mut entries, mut rest) = (Vec::new(), line);
    while let Some(start) = rest.iter().position(|byte| !is_separator(byte)) {
        rest = &rest[start..];
        let mut is_quoted = false;
        let begins_quoted = rest[0] == b'"';
        let end = rest.iter().position(|byte| {
            is_quoted ^= begins_quoted && *byte == b'"';
            !is_quoted && is_separator(byte)
        });
        let (entry, others) = rest.split_at(end.unwrap_or(rest.len()));
        let inner = entry.strip_prefix(b"\"").and_then(|inner| inner.strip_suffix(b"\""));
        entries.push(inner.unwrap_or(entry));
        rest = others;
    }
    entries
}

pub(crate) fn is_word(entry: &[u8]) -> bool {
    parse_coordinate(entry, "").is_err()
}

#[cfg(test)]
mod tests {
    use super::entries;

    #[test]
    fn quotes_hold_an_entry_together() {
        let parts = |line: &str| -> Vec<String> {
            entries(line.as_bytes()).iter().map(|entry| String::from_utf8_lossy(entry).into_owned()).collect()
        };
        assert_eq!(parts("1,\"a b, c\" ;;\t\"2.5\"\r"), ["1", "a b, c", "2.5"]);
        assert_eq!(parts("\"say \"\"so, so\"\"\",7"), ["say \"\"so, so\"\"", "7"]);
        assert_eq!(parts("5\" nail 3\""), ["5\"", "nail", "3\""]);
        assert_eq!(parts(" ,"), [""; 0]);
        assert_eq!(parts("1 \"open 2"), ["1", "\"open 2"]);
    }
}
