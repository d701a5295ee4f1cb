//! Isomorphism signatures of gluing tables of dimension 3, one a line.
//!
//! The signature is the one of the program Regina: see
//! [`GluingTable::from_isomorphism_signature`]. What stands behind or before it on its line is its name, as in the lists of
//! censuses: `cMcabbgqw L(3,1)`, or `L(3,1)` and the signature behind a tab. Empty lines and lines that begin with `#` are passed over. It names a table
//! up to the numbering of its simplices and their vertices: writing and reading again gives an isomorphic table.

use super::{Model, Structure};
use crate::entries::Entry;
use crate::{Remark, RemarkCode};
use coface_algebra::{Error, ErrorKind};
use coface_complexes::gluing::GluingTable;
use std::io::{BufRead, BufReader, Read, Write};
use std::path::Path;

/// The dimension of the tables: signatures do not tell it.
const DIMENSION: usize = 3;

/// A signature of millions of tetrahedra fits.
const LONGEST_LINE: usize = 1 << 26;

/// Reads the first table of a file; if it has several, a remark says how many, and [`read_entry`] chooses one.
///
/// # Errors
/// [`ErrorKind::Parse`] naming the line and the character that is wrong.
///
/// # Complexity
/// Linear.
///
/// # Examples
/// ```
/// use coface_io::{Structure, isosig};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let model = isosig::read(&b"cPcbbbiht\n"[..])?;
/// let Some(Structure::Gluings(knot_complement)) = model.structure() else { panic!("a gluing table") };
/// assert_eq!(knot_complement.simplex_count(), 2);
/// # Ok(()) }
/// ```
pub fn read(input: impl Read) -> Result<Model, Error> {
    let found = scan(input, None)?;
    match (found.count, found.line) {
        (count, Some(line)) => {
            let mut model = to_model(line)?;
            if count > 1 {
                let message = format!(
                    "the file has {count} signatures, and the first is taken; choose one by its place or name after a #: \
                     FILE#{count}"
                );
                model.remarks.push(Remark::new(RemarkCode::SeveralModels, message).at(count, []));
            }
            Ok(model)
        }
        (_, None) => Err(Error::parse("the file has no signature").with_cure("write one a line")),
    }
}

/// Reads the table of one of several signatures, chosen by its place among them, counted from 1, or by the name behind it on its line.
///
/// # Errors
/// [`ErrorKind::InvalidInput`] when there is none at this place or of this name; otherwise those of [`read`].
///
/// # Complexity
/// Linear.
///
/// # Examples
/// ```
/// use coface_io::isosig;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let list = b"# lens spaces\ncMcabbgqw\ncMcabbjak L(8,3)\n";
/// assert_eq!(isosig::read_entry(&list[..], "2")?, isosig::read(&b"cMcabbjak"[..])?);
/// assert_eq!(isosig::read_entry(&list[..], "L(8,3)")?, isosig::read(&b"cMcabbjak"[..])?);
/// assert!(isosig::read_entry(&list[..], "3").is_err());
/// # Ok(()) }
/// ```
pub fn read_entry(input: impl Read, place: &str) -> Result<Model, Error> {
    let found = scan(input, Some(place))?;
    match (found.count, found.line) {
        _ if found.named > 1 => {
            Err(Error::invalid(format!("{} signatures have the name {}", found.named, place.escape_debug()))
                .with_cure("choose one by its place"))
        }
        (_, Some(line)) => to_model(line),
        (count, None) => Err(Error::invalid(format!("there is no signature {}", place.escape_debug()))
            .with_cure(format!("the file has {count}: give a place from 1 to that, or the name behind one"))),
    }
}

/// Writes the signature of a gluing table.
///
/// # Errors
/// [`ErrorKind::UnsupportedFormat`] for everything but gluing tables of dimension 3; [`ErrorKind::Io`] from the output.
///
/// # Examples
/// ```
/// use coface_io::isosig;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let mut out = Vec::new();
/// isosig::write(&isosig::read(&b"cPcbbbiht"[..])?, &mut out)?;
/// assert_eq!(out, b"cPcbbbiht\n");
/// # Ok(()) }
/// ```
pub fn write(model: &Model, mut out: impl Write) -> Result<(), Error> {
    let unsupported = |what: String, cure: &str| {
        Err(Error::new(
            ErrorKind::UnsupportedFormat,
            format!("isomorphism signatures are of gluing tables of tetrahedra, {what}"),
        )
        .with_cure(cure))
    };
    match model.structure() {
        Some(Structure::Gluings(table)) if table.dimension() == DIMENSION => {
            writeln!(out, "{}", table.isomorphism_signature()?)?;
            out.flush()?;
            Ok(())
        }
        Some(Structure::Gluings(table)) => {
            unsupported(format!("but this one has dimension {}", table.dimension()), "write it as JSON")
        }
        _ => unsupported("and the model is none".to_owned(), "give a gluing table, or choose another format"),
    }
}

/// The signatures of a file with their names; their lines are where they stand.
pub(crate) fn outline(input: impl Read) -> Result<Vec<Entry>, Error> {
    let mut entries = Vec::new();
    let mut lines = RawLines::new(input);
    while let Some(line) = lines.next_line()? {
        let text = line?;
        let name = Columns::of(&text.text).name;
        entries.push(Entry { name, start: text.start, length: text.length });
    }
    Ok(entries)
}

/// Whether a column of the line is the signature of a table with a simplex.
pub(super) fn is_signature(line: &[u8]) -> bool {
    let Ok(text) = std::str::from_utf8(line) else { return false };
    let signature = Columns::of(text.trim()).signature;
    GluingTable::from_isomorphism_signature(&signature, DIMENSION)
        .is_ok_and(|table| table.simplex_count() > 0)
}

/// One line of a list of signatures: where it stands, what it says, and its table unless something is wrong with it.
#[derive(Clone, Debug)]
pub struct SignatureLine {
    number: u64,
    signature: String,
    name: Option<String>,
    table: Result<GluingTable, Error>,
}

impl SignatureLine {
    /// The number of the line in its file, from 1.
    ///
    /// # Examples
    /// ```
    /// use coface_io::SignatureLines;
    /// let numbers: Vec<u64> = SignatureLines::new(&b"# two\n\ncMcabbjak\n"[..]).flatten().map(|line| line.number()).collect();
    /// assert_eq!(numbers, [3]);
    /// ```
    pub fn number(&self) -> u64 {
        self.number
    }

    /// The signature as it is written; where no column is one, the first column.
    ///
    /// # Examples
    /// ```
    /// use coface_io::SignatureLines;
    /// let line = SignatureLines::new(&b"L(3,1)\tcMcabbjak\n"[..]).flatten().next();
    /// assert_eq!(line.map(|line| line.signature().to_owned()).as_deref(), Some("cMcabbjak"));
    /// ```
    pub fn signature(&self) -> &str {
        &self.signature
    }

    /// The name beside the signature.
    ///
    /// # Examples
    /// ```
    /// use coface_io::SignatureLines;
    /// let line = SignatureLines::new(&b"cMcabbjak L(3,1) : #1\n"[..]).flatten().next();
    /// assert_eq!(line.as_ref().and_then(|line| line.name()), Some("L(3,1) : #1"));
    /// ```
    pub fn name(&self) -> Option<&str> {
        self.name.as_deref()
    }

    /// The gluing table, or what is wrong with the line; the error has its number.
    ///
    /// # Examples
    /// ```
    /// use coface_io::SignatureLines;
    /// let lines = SignatureLines::new(&b"cMcabbjak\nnone\n"[..]).flatten();
    /// let faults: Vec<Option<u64>> = lines.map(|line| line.table().as_ref().err().and_then(|error| error.line())).collect();
    /// assert_eq!(faults, [None, Some(2)]);
    /// ```
    pub fn table(&self) -> &Result<GluingTable, Error> {
        &self.table
    }
}

/// The lines of a list of signatures as they come: what is wrong with one is said in it, and the next one follows. Empty lines and
/// comments behind `#` are passed over.
///
/// A line has a signature and perhaps a name, in either order, with tabs or blanks between them. The signature is the first column that is
/// one; where none is, the first column.
///
/// # Complexity
/// Linear; memory is that of the longest line.
///
/// # Examples
/// ```
/// use coface_io::SignatureLines;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let list = b"# closed\ncMcabbjak L(3,1)\nL(8,3)\tcMcabbjqs\n";
/// let names: Vec<Option<String>> =
///     SignatureLines::new(&list[..]).map(|line| Ok(line?.name().map(str::to_owned))).collect::<Result<_, coface_algebra::Error>>()?;
/// assert_eq!(names, [Some("L(3,1)".to_owned()), Some("L(8,3)".to_owned())]);
/// # Ok(()) }
/// ```
#[derive(Debug)]
pub struct SignatureLines<R> {
    lines: RawLines<R>,
    is_over: bool,
}

impl<R: Read> SignatureLines<R> {
    /// The lines of a stream.
    ///
    /// # Examples
    /// ```
    /// use coface_io::SignatureLines;
    /// assert_eq!(SignatureLines::new(&b"# nothing\n"[..]).count(), 0);
    /// ```
    pub fn new(input: R) -> Self {
        Self { lines: RawLines::new(input), is_over: false }
    }
}

impl SignatureLines<Box<dyn Read>> {
    /// The lines of a file, which may be compressed.
    ///
    /// # Errors
    /// [`ErrorKind::Io`] when the file cannot be read.
    pub fn of_path(path: &Path) -> Result<Self, Error> {
        let bytes = crate::readers::bytes_again(path);
        let bytes = bytes.map_err(|error| error.in_file(path.display().to_string()))?;
        Ok(Self::new(Box::new(bytes)))
    }
}

impl<R: Read> Iterator for SignatureLines<R> {
    type Item = Result<SignatureLine, Error>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.is_over {
            return None;
        }
        match self.lines.next_line() {
            Ok(Some(Ok(line))) => Some(Ok(line.read())),
            Ok(Some(Err(error))) => Some(Ok(SignatureLine {
                number: error.line().unwrap_or(0),
                signature: String::new(),
                name: None,
                table: Err(error),
            })),
            Ok(None) => {
                self.is_over = true;
                None
            }
            Err(error) => {
                self.is_over = true;
                Some(Err(error))
            }
        }
    }
}

/// The columns of a line.
struct Columns {
    signature: String,
    name: Option<String>,
    /// The table, where it had to be read to know which column is the signature.
    table: Option<GluingTable>,
}

impl Columns {
    fn of(text: &str) -> Self {
        let mut choices = choices(text);
        let mut words = choices.iter().enumerate().filter(|(_, (word, _))| is_word(word)).map(|(at, _)| at);
        let (at, table) = match (words.next(), words.next()) {
            (None, _) => (0, None),
            // A first column with a wrong letter is better named than a name that looks like one.
            (Some(only), None) if only > 0 => match table_of(choices[only].0) {
                Some(table) => (only, Some(table)),
                None => (0, None),
            },
            (Some(only), None) => (only, None),
            _ => choices
                .iter()
                .enumerate()
                .find_map(|(at, (word, _))| Some((at, Some(table_of(word)?))))
                .unwrap_or((0, None)),
        };
        let (signature, name) = choices.swap_remove(at);
        Self { signature: signature.to_owned(), name: (!name.is_empty()).then_some(name), table }
    }
}

/// What may be the signature of a line, each with what is the name then: any column between tabs; otherwise the first or the last word, as a
/// name may have blanks in it. There is one at least.
fn choices(text: &str) -> Vec<(&str, String)> {
    if text.contains('\t') {
        let columns: Vec<&str> =
            text.split('\t').map(str::trim).filter(|column| !column.is_empty()).collect();
        let without = |at: usize| [&columns[..at], &columns[at + 1..]].concat().join(" ");
        return (0..columns.len()).map(|at| (columns[at], without(at))).collect();
    }
    let first = text.split_once(|letter: char| letter.is_ascii_whitespace());
    let last = text.rsplit_once(|letter: char| letter.is_ascii_whitespace());
    match (first, last) {
        (Some((first, rest)), Some((before, last))) => {
            vec![(first, rest.trim().to_owned()), (last, before.trim().to_owned())]
        }
        _ => vec![(text, String::new())],
    }
}

/// Whether a word has the characters of signatures alone.
fn is_word(word: &str) -> bool {
    !word.is_empty() && word.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'+' || byte == b'-')
}

/// The table of a word, if it is the signature of one with a simplex.
fn table_of(word: &str) -> Option<GluingTable> {
    GluingTable::from_isomorphism_signature(word, DIMENSION).ok().filter(|table| table.simplex_count() > 0)
}

/// A line that is no comment, with its number and where it stands in the file.
struct RawLine {
    number: u64,
    start: u64,
    length: u64,
    text: String,
}

impl RawLine {
    fn read(self) -> SignatureLine {
        let Columns { signature, name, table } = Columns::of(&self.text);
        let read = || GluingTable::from_isomorphism_signature(&signature, DIMENSION);
        let table = table.map_or_else(read, Ok).map_err(|error| error.at_line(self.number));
        SignatureLine { number: self.number, signature, name, table }
    }
}

/// The lines of a stream.
struct RawLines<R> {
    input: BufReader<R>,
    number: u64,
    start: u64,
    line: Vec<u8>,
}

impl<R> std::fmt::Debug for RawLines<R> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("RawLines").field("number", &self.number).finish_non_exhaustive()
    }
}

impl<R: Read> RawLines<R> {
    fn new(input: R) -> Self {
        Self { input: BufReader::with_capacity(1 << 16, input), number: 0, start: 0, line: Vec::new() }
    }

    /// The next line that says something; an error in it if it is too long. `None` at the end.
    fn next_line(&mut self) -> Result<Option<Result<RawLine, Error>>, Error> {
        loop {
            self.line.clear();
            let (length, is_last) = self.fill()?;
            let start = self.start;
            self.start += length;
            self.number += 1;
            if length > LONGEST_LINE as u64 {
                let message = format!("the line has more than {LONGEST_LINE} characters");
                let error = Error::new(ErrorKind::TooLarge, message).at_line(self.number);
                return Ok(Some(Err(error.with_cure("write one signature a line"))));
            }
            let text = String::from_utf8_lossy(self.line.trim_ascii());
            if !text.is_empty() && !text.starts_with('#') {
                let text = text.into_owned();
                return Ok(Some(Ok(RawLine { number: self.number, start, length, text })));
            }
            if is_last {
                return Ok(None);
            }
        }
    }

    /// Reads up to the end of a line: how many bytes it has, and whether it is the last. Of a line that is too long the start is kept.
    fn fill(&mut self) -> Result<(u64, bool), Error> {
        let mut length = 0;
        loop {
            let piece = self.input.fill_buf()?;
            if piece.is_empty() {
                return Ok((length, true));
            }
            let end = memchr::memchr(b'\n', piece);
            let used = end.map_or(piece.len(), |at| at + 1);
            if self.line.len() <= LONGEST_LINE {
                self.line.extend_from_slice(&piece[..used]);
            }
            self.input.consume(used);
            length += used as u64;
            if end.is_some() {
                return Ok((length, false));
            }
        }
    }
}

/// What was found in a file.
struct Found {
    /// The number of signatures, and of those with the name that is wanted.
    count: usize,
    named: usize,
    /// The one that is wanted, by its name or its place from 1, or the first.
    line: Option<RawLine>,
}

fn scan(input: impl Read, wanted: Option<&str>) -> Result<Found, Error> {
    let place = wanted.map_or(Some(1), |wanted| wanted.parse::<usize>().ok());
    let mut found = Found { count: 0, named: 0, line: None };
    let mut lines = RawLines::new(input);
    while let Some(line) = lines.next_line()? {
        let line = line?;
        found.count += 1;
        let has_name = |wanted: &str| {
            line.text.contains(wanted) && Columns::of(&line.text).name.as_deref() == Some(wanted)
        };
        let is_named = wanted.is_some_and(|wanted| !wanted.is_empty() && has_name(wanted));
        found.named += usize::from(is_named);
        // A name comes before a place.
        if (is_named && found.named == 1) || (found.named == 0 && place == Some(found.count)) {
            found.line = Some(line);
        }
    }
    Ok(found)
}

fn to_model(line: RawLine) -> Result<Model, Error> {
    Ok(Model::from_structure(Structure::Gluings(line.read().table?)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(text: &[u8]) -> Vec<Option<String>> {
        let at = |entry: &Entry| &text[entry.start as usize..][..entry.length as usize];
        let entries = outline(text).unwrap();
        assert!(
            entries.iter().all(|entry| is_signature(at(entry).trim_ascii()) || at(entry).contains(&b'*'))
        );
        entries.into_iter().map(|entry| entry.name).collect()
    }

    #[test]
    fn lines_are_counted_and_faults_named() {
        let text = b"# lens spaces: \xc3\xa9\n\n cMcabbgqw \r\n# more\ncMcabbj*k\ncMcabbjxr";
        let model = |place| read_entry(&text[..], place);
        assert_eq!(model("1").unwrap(), read(&b"cMcabbgqw"[..]).unwrap());
        assert_eq!(model("3").unwrap(), read(&b"cMcabbjxr\n"[..]).unwrap());
        let error = model("2").unwrap_err();
        assert_eq!(error.line(), Some(5));
        assert!(error.message().contains("character 8"), "{error}");
        for place in ["0", "4", "-1", "x", ""] {
            assert!(model(place).unwrap_err().to_string().contains("the file has 3"), "{place}");
        }
        assert_eq!(read(&text[..]).unwrap().remarks()[0].code, RemarkCode::SeveralModels);
        assert_eq!(names(&text[..]), [None, None, None]);
        assert!(read(&b"# nothing\n\n"[..]).is_err());
        assert_eq!(read(&b"cMc\xffabbgqw"[..]).unwrap_err().line(), Some(1));
    }

    #[test]
    fn names_stand_behind_signatures() {
        let list = "cMcabbgqw L(3,1) : #1\ncMcabbjak 1\n\ncMcabbjxr\tL(7,2)\n".as_bytes();
        assert_eq!(
            names(list),
            [Some("L(3,1) : #1".to_owned()), Some("1".to_owned()), Some("L(7,2)".to_owned())]
        );
        // A name comes before a place.
        for (entry, signature) in [("L(3,1) : #1", "cMcabbgqw"), ("1", "cMcabbjak"), ("3", "cMcabbjxr")] {
            assert_eq!(read_entry(list, entry).unwrap(), read(signature.as_bytes()).unwrap(), "{entry}");
        }
        assert!(read_entry(list, "L(9,2)").is_err());
        let twice = &b"cMcabbgqw S\ncMcabbjak S\n"[..];
        let error = read_entry(twice, "S").unwrap_err().to_string();
        assert!(error.contains("2 signatures have the name S; choose one by its place"), "{error}");
        assert_eq!(read_entry(twice, "2").unwrap(), read(&b"cMcabbjak"[..]).unwrap());
        // A name may stand before its signature.
        let list = "L(3,1) : #1 cMcabbgqw\nRP3\tcMcabbjak\ncMcabbjxr\ta\tb".as_bytes();
        assert_eq!(names(list), ["L(3,1) : #1", "RP3", "a b"].map(|name| Some(name.to_owned())));
        assert_eq!(read_entry(list, "RP3").unwrap(), read(&b"cMcabbjak"[..]).unwrap());
        let model = crate::read_unknown(&b"cMcabbgqw L(3,1)\n"[..]).unwrap();
        assert_eq!((model.format(), model.remarks().len()), (Some(crate::Format::Isosig), 0));
    }

    #[test]
    fn only_tables_of_tetrahedra_are_written() {
        let fault = |structure| {
            let mut out = Vec::new();
            let error = write(&Model::from_structure(structure), &mut out).unwrap_err();
            assert!(out.is_empty());
            assert_eq!(error.kind(), ErrorKind::UnsupportedFormat);
            error.to_string()
        };
        assert!(fault(Structure::Gluings(GluingTable::unglued(2, 1).unwrap())).contains("dimension 2"));
        assert!(fault(Structure::Facets(coface_algebra::RaggedArray::new())).contains("the model is none"));
    }
}
