//! Isomorphism signatures of gluing tables of dimension 3, one a line.
//!
//! The signature is the one of the program Regina: see
//! [`GluingTable::from_isomorphism_signature`]. What stands behind it on its line is its name, as in the lists of censuses:
//! `cMcabbgqw L(3,1)`. Empty lines and lines that begin with `#` are passed over. It names a table
//! up to the numbering of its simplices and their vertices: writing and reading again gives an isomorphic table.

use super::{Model, Structure};
use crate::entries::Entry;
use crate::{Remark, RemarkCode};
use coface_algebra::{Error, ErrorKind};
use coface_complexes::gluing::GluingTable;
use std::io::{BufRead, BufReader, Read, Write};

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
            let mut model = to_model(&line)?;
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
        (_, Some(line)) => to_model(&line),
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

/// The signatures of a file with the names behind them; their lines are where they stand.
pub(crate) fn outline(input: impl Read) -> Result<Vec<Entry>, Error> {
    let mut entries = Vec::new();
    scan_with(input, |line| {
        let name = (!line.name.is_empty()).then_some(line.name);
        entries.push(Entry { name, start: line.start, length: line.length });
    })?;
    Ok(entries)
}

/// Whether the first word of the line is the signature of a table with a simplex.
pub(super) fn is_signature(line: &[u8]) -> bool {
    let word = line.split(u8::is_ascii_whitespace).next().unwrap_or_default();
    std::str::from_utf8(word).is_ok_and(|line| {
        GluingTable::from_isomorphism_signature(line, DIMENSION).is_ok_and(|table| table.simplex_count() > 0)
    })
}

/// A signature with the number of its line, where that stands in the file, and the name behind it.
struct Line {
    number: u64,
    start: u64,
    length: u64,
    text: String,
    name: String,
}

/// What was found in a file.
struct Found {
    /// The number of signatures, and of those with the name that is wanted.
    count: usize,
    named: usize,
    /// The one that is wanted, by its name or its place from 1, or the first.
    line: Option<Line>,
}

fn scan(input: impl Read, wanted: Option<&str>) -> Result<Found, Error> {
    let place = wanted.map_or(Some(1), |wanted| wanted.parse::<usize>().ok());
    let mut found = Found { count: 0, named: 0, line: None };
    scan_with(input, |line| {
        found.count += 1;
        let is_named = wanted.is_some_and(|wanted| !wanted.is_empty() && line.name == wanted);
        // A name comes before a place.
        if found.named == 0 && (is_named || place == Some(found.count)) {
            found.line = Some(line);
        }
        found.named += usize::from(is_named);
    })?;
    Ok(found)
}

/// Gives each signature to a function.
fn scan_with(input: impl Read, mut take: impl FnMut(Line)) -> Result<(), Error> {
    let mut input = BufReader::with_capacity(1 << 16, input);
    let (mut number, mut start, mut line) = (1, 0, Vec::new());
    loop {
        let piece = input.fill_buf()?;
        let (used, is_end) = match piece.iter().position(|&byte| byte == b'\n') {
            Some(at) => (at + 1, true),
            None => (piece.len(), piece.is_empty()),
        };
        let is_last = piece.is_empty();
        line.extend_from_slice(&piece[..used]);
        input.consume(used);
        if line.len() > LONGEST_LINE {
            return Err(Error::new(
                ErrorKind::TooLarge,
                format!("the line has more than {LONGEST_LINE} characters"),
            )
            .at_line(number)
            .with_cure("write one signature a line"));
        }
        if !is_end {
            continue;
        }
        let text = line.trim_ascii();
        if !text.is_empty() && text[0] != b'#' {
            let length = text.iter().position(u8::is_ascii_whitespace).unwrap_or(text.len());
            let (signature, name) = text.split_at(length);
            if let Some(byte) = signature.iter().find(|byte| !byte.is_ascii_graphic()) {
                return Err(Error::parse(format!("the byte {byte} is of no signature")).at_line(number));
            }
            // Only ASCII is left.
            let text = signature.iter().copied().map(char::from).collect();
            let name = String::from_utf8_lossy(name).trim().to_owned();
            take(Line { number, start, length: line.len() as u64, text, name });
        }
        if is_last {
            return Ok(());
        }
        start += line.len() as u64;
        line.clear();
        number += 1;
    }
}

fn to_model(line: &Line) -> Result<Model, Error> {
    let table = GluingTable::from_isomorphism_signature(&line.text, DIMENSION)
        .map_err(|error| error.at_line(line.number))?;
    Ok(Model::from_structure(Structure::Gluings(table)))
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
