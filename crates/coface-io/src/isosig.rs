//! Isomorphism signatures of gluing tables of dimension 3, one a line.
//!
//! The signature is the one of the program Regina: see
//! [`GluingTable::from_isomorphism_signature`]. Empty lines and lines that begin with `#` are passed over. It names a table
//! up to the numbering of its simplices and their vertices: writing and reading again gives an isomorphic table.

use super::{Model, Structure};
use coface_algebra::{Error, ErrorKind};
use coface_complexes::gluing::GluingTable;
use std::io::{BufRead, BufReader, Read, Write};

/// The dimension of the tables: signatures do not tell it.
const DIMENSION: usize = 3;

/// A signature of millions of tetrahedra fits.
const LONGEST_LINE: usize = 1 << 26;

/// Reads the table of a file with one signature.
///
/// # Errors
/// [`ErrorKind::Parse`] naming the line and the character that is wrong; [`ErrorKind::InvalidInput`] for several
/// signatures, of which [`read_entry`] chooses one.
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
    match scan(input, None)? {
        (1, Some(line)) => to_model(&line),
        (0, _) => Err(Error::parse("the file has no signature").with_cure("write one a line")),
        (count, _) => Err(Error::invalid(format!("the file has {count} signatures"))
            .with_cure("choose one by its place, from 1, after a #: file.isosig#3")),
    }
}

/// Reads the table of one of several signatures, chosen by its place among them, counted from 1.
///
/// # Errors
/// [`ErrorKind::InvalidInput`] when there is none at this place; otherwise those of [`read`].
///
/// # Complexity
/// Linear.
///
/// # Examples
/// ```
/// use coface_io::isosig;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let list = b"# lens spaces\ncMcabbgqw\ncMcabbjak\n";
/// assert_eq!(isosig::read_entry(&list[..], "2")?, isosig::read(&b"cMcabbjak"[..])?);
/// assert!(isosig::read_entry(&list[..], "3").is_err());
/// # Ok(()) }
/// ```
pub fn read_entry(input: impl Read, place: &str) -> Result<Model, Error> {
    // No signature has the place 0.
    match scan(input, Some(place.parse().unwrap_or(0)))? {
        (_, Some(line)) => to_model(&line),
        (count, None) => Err(Error::invalid(format!("there is no signature {}", place.escape_debug()))
            .with_cure(format!("the file has {count}: give a place from 1 to that"))),
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

/// Whether the line is the signature of a table with a simplex.
pub(super) fn is_signature(line: &[u8]) -> bool {
    std::str::from_utf8(line).is_ok_and(|line| {
        GluingTable::from_isomorphism_signature(line, DIMENSION).is_ok_and(|table| table.simplex_count() > 0)
    })
}

/// A signature with the number of its line.
struct Line {
    number: u64,
    text: String,
}

/// The number of signatures, and that at the place that is wanted, from 1, or the first.
fn scan(input: impl Read, wanted: Option<usize>) -> Result<(usize, Option<Line>), Error> {
    let mut input = BufReader::with_capacity(1 << 16, input);
    let (mut count, mut found, mut number, mut line) = (0, None, 1, Vec::new());
    loop {
        let piece = input.fill_buf()?;
        let (used, is_end) = match piece.iter().position(|&byte| byte == b'\n') {
            Some(at) => (at + 1, true),
            None => (piece.len(), piece.is_empty()),
        };
        let is_last = piece.is_empty();
        let strange =
            piece[..used].iter().position(|byte| !byte.is_ascii_graphic() && !byte.is_ascii_whitespace());
        line.extend_from_slice(&piece[..used]);
        input.consume(used);
        if let Some(at) = strange.filter(|_| !line.trim_ascii_start().starts_with(b"#")) {
            let byte = line[line.len() - used + at];
            return Err(Error::parse(format!("the byte {byte} is of no signature")).at_line(number));
        }
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
            count += 1;
            if wanted.unwrap_or(1) == count {
                // Only ASCII is left.
                found = Some(Line { number, text: text.iter().copied().map(char::from).collect() });
            }
        }
        if is_last {
            return Ok((count, found));
        }
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
        assert!(read(&text[..]).unwrap_err().cure().unwrap().contains('#'));
        assert!(read(&b"# nothing\n\n"[..]).is_err());
        assert_eq!(read(&b"cMc\xffabbgqw"[..]).unwrap_err().line(), Some(1));
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
