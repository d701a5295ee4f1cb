//! Sparse matrices in the coordinate format of Matrix Market.
//!
//! A first line `%%MatrixMarket matrix coordinate integer general`, or `pattern` for matrices whose entries are all 1;
//! comments after `%`; a line `rows columns entries`; then a line `row column entry` for each entry, counted from 1, without
//! the entry in a pattern.
//!
//! As a model such a file is a chain complex of two degrees with this boundary matrix. As a graph or as distances its entries may be real numbers, and the
//! matrix symmetric, with one triangle in the file.
//!
//! # References
//! R. F. Boisvert, R. Pozo, K. A. Remington, *The Matrix Market exchange formats: initial design* (1996).

use super::decimal::push_natural;
use super::json::most_cells;
use super::scanner::{Scanner, parse_coordinate, parse_i64, quoted};
use crate::{Model, Remark, RemarkCode, Structure};
use coface_algebra::SparseMatrix;
use coface_algebra::chains::ChainComplex;
use coface_algebra::{Error, ErrorKind};
use std::io::{BufWriter, Read, Write};

/// What stands in a Matrix Market file for each entry.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum MatrixField {
    /// Its value.
    Integer,
    /// Its place only.
    Pattern,
}

/// Writes a matrix in the coordinate format of Matrix Market, column by column; as a pattern the places alone.
///
/// # Errors
/// [`ErrorKind::Io`] from the output.
///
/// # Examples
/// ```
/// use coface_algebra::SparseMatrix;
/// use coface_io::matrix_market;
/// use coface_io::matrix_market::MatrixField;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let edge = SparseMatrix::from_entries(2, 1, [(0, 0, -1), (1, 0, 1)])?;
/// let mut out = Vec::new();
/// matrix_market::write(&edge, MatrixField::Integer, &mut out)?;
/// assert_eq!(out, b"%%MatrixMarket matrix coordinate integer general\n2 1 2\n1 1 -1\n2 1 1\n");
/// assert_eq!(matrix_market::read(&out[..])?, edge);
/// # Ok(()) }
/// ```
pub fn write(matrix: &SparseMatrix, field: MatrixField, out: impl Write) -> Result<(), Error> {
    let mut out = BufWriter::with_capacity(1 << 16, out);
    let name = match field {
        MatrixField::Integer => "integer",
        MatrixField::Pattern => "pattern",
    };
    writeln!(out, "%%MatrixMarket matrix coordinate {name} general")?;
    writeln!(out, "{} {} {}", matrix.row_count(), matrix.column_count(), matrix.entry_count())?;
    let mut line = Vec::new();
    for (j, column) in matrix.columns().enumerate() {
        for (i, entry) in column.iter() {
            line.clear();
            push_natural(&mut line, i as u64 + 1);
            line.push(b' ');
            push_natural(&mut line, j as u64 + 1);
            if field == MatrixField::Integer {
                line.push(b' ');
                if entry < 0 {
                    line.push(b'-');
                }
                push_natural(&mut line, entry.unsigned_abs().into());
            }
            line.push(b'\n');
            out.write_all(&line)?;
        }
    }
    out.flush()?;
    Ok(())
}

/// Reads a matrix in the coordinate format of Matrix Market: `integer` or `pattern`, `general`. Entries of a pattern are 1;
/// entries at one place are added, and zeros are left out.
///
/// # Errors
/// [`ErrorKind::Parse`] with the line where the text breaks the rules of the format, or says other counts than there are;
/// [`ErrorKind::UnsupportedFormat`] for arrays, real and complex entries and symmetric matrices;
/// [`ErrorKind::TooLarge`] for values beyond 32 bits, and for many more rows or columns than entries;
/// [`ErrorKind::Io`] from the input.
///
/// # Complexity
/// $O(m \log m)$ for m entries; memory grows with what is read, not with what the header says.
///
/// # Examples
/// ```
/// use coface_io::matrix_market;
/// let text = b"%%MatrixMarket matrix coordinate integer general\n2 2 1\n1 2 -5\n";
/// let matrix = matrix_market::read(&text[..])?;
/// assert_eq!((matrix.row_count(), matrix.column_count()), (2, 2));
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn read(input: impl Read) -> Result<SparseMatrix, Error> {
    let mut scanner = Scanner::new(input);
    let header = Header::read(&mut scanner)?;
    let field = header.of_whole_numbers()?;
    let value = |word: Option<&[u8]>| match (field, word) {
        (MatrixField::Integer, Some(word)) => parse_i64(word, "the entry"),
        (MatrixField::Integer, None) => Err(Error::parse("the entry is missing")),
        (MatrixField::Pattern, None) => Ok(1),
        (MatrixField::Pattern, Some(word)) => Err(behind_place(word)),
    };
    let (rows, columns, entries) = read_entries(&mut scanner, value)?;
    SparseMatrix::from_entries(
        rows,
        columns,
        entries.into_iter().map(|entry| (entry.row, entry.column, entry.value)),
    )
}

/// The chain complex of two degrees with this boundary matrix.
pub(crate) fn read_model(input: impl Read) -> Result<Model, Error> {
    let complex = ChainComplex::new(vec![read(input)?])?;
    let message =
        "the matrix was taken for a boundary: its rows are cells of degree 0, its columns of degree 1";
    let mut model = Model::from_structure(Structure::Chains(complex));
    model.remarks.push(Remark::new(RemarkCode::InputReading, message));
    Ok(model)
}

/// The bytes with which files begin, in letters of any case.
const BANNER: &[u8] = b"%%MatrixMarket";
/// So many bytes of a file tell whether it is one, blanks before it included.
pub(crate) const START: u64 = 64;

/// Whether a file begins as one of Matrix Market.
pub(crate) fn is_matrix_market(start: &[u8]) -> bool {
    let start = start.trim_ascii_start();
    start.get(..BANNER.len()).is_some_and(|start| start.eq_ignore_ascii_case(BANNER))
}

/// A square matrix as it says what is between things: a weighted graph, or distances.
pub(crate) struct Relation {
    /// How many things there are.
    pub(crate) count: usize,
    /// Whether an entry holds in both directions.
    pub(crate) is_symmetric: bool,
    /// The entries as they stand in the file; those of a pattern have no value.
    pub(crate) entries: Vec<Entry<Option<f64>>>,
}

/// An entry, counted from 0, and its line.
pub(crate) struct Entry<V> {
    pub(crate) row: usize,
    pub(crate) column: usize,
    pub(crate) value: V,
    pub(crate) line: u64,
}

impl Relation {
    /// Reads a square matrix of whole or real numbers, or a pattern.
    ///
    /// # Errors
    /// As of [`read`], and for matrices that are not square.
    pub(crate) fn read(input: impl Read) -> Result<Self, Error> {
        let mut scanner = Scanner::new(input);
        let header = Header::read(&mut scanner)?;
        header.require_coordinates()?;
        let is_symmetric = match header.symmetry.as_str() {
            "symmetric" => true,
            "general" => false,
            symmetry => {
                return Err(header.unsupported(
                    format!("a {symmetry:?} matrix is no graph, and has no distances"),
                    "write it as symmetric, or as general with all entries",
                ));
            }
        };
        let is_pattern = match header.field.as_str() {
            "pattern" => true,
            "integer" | "real" | "double" => false,
            field => {
                return Err(header.unsupported(
                    format!("{field:?} entries are not read"),
                    "write real numbers, or a pattern",
                ));
            }
        };
        let value = |word: Option<&[u8]>| match word {
            Some(word) if is_pattern => Err(behind_place(word)),
            Some(word) => parse_coordinate(word, "the entry").map(Some),
            None if is_pattern => Ok(None),
            None => Err(Error::parse("the entry is missing")),
        };
        let (rows, columns, entries) = read_entries(&mut scanner, value)?;
        if rows != columns {
            let message = format!(
                "the matrix has {rows} rows and {columns} columns: a graph or distances have a square one"
            );
            return Err(
                Error::new(ErrorKind::Shape, message).with_cure("write a row and a column for each point")
            );
        }
        Ok(Self { count: rows, is_symmetric, entries })
    }
}

fn behind_place(word: &[u8]) -> Error {
    Error::parse(format!("{} stands after the place of a pattern", quoted(word)))
}

/// The counts of rows and columns, and the entries, behind the first line.
fn read_entries<R: Read, V>(
    scanner: &mut Scanner<R>,
    value: impl Fn(Option<&[u8]>) -> Result<V, Error>,
) -> Result<(usize, usize, Vec<Entry<V>>), Error> {
    let [rows, columns, count] = read_counts(scanner)?;
    let limit_line = scanner.line_number();
    let mut entries: Vec<Entry<V>> = Vec::new();
    while let Some(words) = scanner.next_line()? {
        let found = parse_entry(words, rows, columns, &value);
        let line = scanner.line_number();
        if let Some((row, column, value)) = found.map_err(|error| error.at_line(line))? {
            entries.push(Entry { row, column, value, line });
        }
        if entries.len() as u64 > count {
            return Err(scanner.error(format!("there are more than the {count} entries that the file says")));
        }
    }
    if (entries.len() as u64) < count {
        return Err(Error::parse(format!(
            "the file ends after {} entries; it says that there are {count}",
            entries.len()
        ))
        .at_line(scanner.line_number()));
    }
    if rows.max(columns) > most_cells(entries.len() as u64) {
        return Err(Error::new(
            ErrorKind::TooLarge,
            format!("the matrix has {rows} rows and {columns} columns, but only {} entries", entries.len()),
        )
        .at_line(limit_line)
        .with_cure("check the counts"));
    }
    // Both counts are at most 2^37 here, and entries are within them.
    Ok((rows as usize, columns as usize, entries))
}

/// The first line, in small letters.
struct Header {
    object: String,
    form: String,
    field: String,
    symmetry: String,
}

impl Header {
    fn read<R: Read>(scanner: &mut Scanner<R>) -> Result<Self, Error> {
        let words: Vec<String> = match scanner.next_line()? {
            Some(line) => line
                .split(u8::is_ascii_whitespace)
                .filter(|word| !word.is_empty())
                .take(6)
                .map(|word| String::from_utf8_lossy(&word[..word.len().min(64)]).to_ascii_lowercase())
                .collect(),
            None => return Err(Error::parse("the file is empty").at_line(1)),
        };
        const CURE: &str = "begin with %%MatrixMarket matrix coordinate integer general";
        let Ok([banner, object, form, field, symmetry]) = <[String; 5]>::try_from(words) else {
            let error = scanner.error("the first line is not that of a Matrix Market file");
            return Err(error.with_cure(CURE));
        };
        if !is_matrix_market(banner.as_bytes()) || banner.len() != BANNER.len() {
            return Err(scanner.error(format!("{banner:?} is not %%MatrixMarket")).with_cure(CURE));
        }
        Ok(Self { object, form, field, symmetry })
    }

    #[expect(clippy::unused_self, reason = "it is the first line that is not supported")]
    fn unsupported(&self, what: String, cure: &str) -> Error {
        Error::new(ErrorKind::UnsupportedFormat, what).at_line(1).with_cure(cure)
    }

    fn require_coordinates(&self) -> Result<(), Error> {
        if (self.object.as_str(), self.form.as_str()) == ("matrix", "coordinate") {
            return Ok(());
        }
        Err(self.unsupported(
            format!("the file has a {:?} in {:?} form", self.object, self.form),
            "write a sparse matrix in coordinate form",
        ))
    }

    /// Of a general matrix what its entries are, which must be whole numbers.
    fn of_whole_numbers(&self) -> Result<MatrixField, Error> {
        self.require_coordinates()?;
        if self.symmetry != "general" {
            return Err(self.unsupported(
                format!("a {:?} matrix is no boundary matrix", self.symmetry),
                "write all entries, as general, or read it as a graph (--flag) or as distances (--rips)",
            ));
        }
        match self.field.as_str() {
            "integer" => Ok(MatrixField::Integer),
            "pattern" => Ok(MatrixField::Pattern),
            field => Err(self.unsupported(
                format!("a boundary matrix has whole numbers, not {field:?} entries"),
                "write integers or a pattern, or read it as a graph (--flag) or as distances (--rips)",
            )),
        }
    }
}

/// The line of counts, after comments.
fn read_counts<R: Read>(scanner: &mut Scanner<R>) -> Result<[u64; 3], Error> {
    loop {
        let Some(line) = scanner.next_line()? else {
            let error = Error::parse("the file ends before the line of counts");
            return Err(error.at_line(scanner.line_number()));
        };
        match parse_counts(line) {
            Ok(None) => {}
            Ok(Some(counts)) => return Ok(counts),
            Err(error) => return Err(error.at_line(scanner.line_number())),
        }
    }
}

/// The numbers of rows, columns and entries that a line holds; none in an empty line or comment.
fn parse_counts(line: &[u8]) -> Result<Option<[u64; 3]>, Error> {
    let words: Vec<&[u8]> = words_of(line).take(4).collect();
    match words[..] {
        [] => Ok(None),
        [rows, columns, count] => Ok(Some([
            natural(rows, "the number of rows")?,
            natural(columns, "the number of columns")?,
            natural(count, "the number of entries")?,
        ])),
        _ => Err(Error::parse("a line of three counts is expected: rows, columns, entries")),
    }
}

/// The entry that a line holds, counted from 0; none in an empty line or comment.
fn parse_entry<V>(
    line: &[u8],
    rows: u64,
    columns: u64,
    value: &impl Fn(Option<&[u8]>) -> Result<V, Error>,
) -> Result<Option<(usize, usize, V)>, Error> {
    let mut words = words_of(line);
    let Some(row) = words.next() else { return Ok(None) };
    let place = |word: &[u8], what: &str, count: u64| match natural(word, what)? {
        place if place >= 1 && place <= count => Ok(place as usize - 1),
        place => {
            Err(Error::parse(format!("{what} is {place}; the matrix has {count}")).with_cure("count from 1"))
        }
    };
    let row = place(row, "the row", rows)?;
    let Some(column) = words.next() else { return Err(Error::parse("the column is missing")) };
    let column = place(column, "the column", columns)?;
    let value = value(words.next())?;
    match words.next() {
        Some(word) => Err(Error::parse(format!("{} stands after the entry", quoted(word)))),
        None => Ok(Some((row, column, value))),
    }
}

/// The words of a line before its comment.
fn words_of(line: &[u8]) -> impl Iterator<Item = &[u8]> {
    let end = line.iter().position(|&byte| byte == b'%').unwrap_or(line.len());
    line[..end].split(u8::is_ascii_whitespace).filter(|word| !word.is_empty())
}

fn natural(word: &[u8], what: &str) -> Result<u64, Error> {
    let value = parse_i64(word, what)?;
    u64::try_from(value).map_err(|_| Error::parse(format!("{what} is {value}; it cannot be negative")))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn error(text: &str) -> String {
        read(text.as_bytes()).unwrap_err().to_string()
    }

    #[test]
    fn faults_have_their_line() {
        let header = "%%MatrixMarket matrix coordinate integer general\n";
        for (text, message) in [
            ("1 1 1\n1 1 7\n1 1 1\n", "line 4: there are more than the 1 entries that the file says"),
            ("% c\n\n1 1 1\n0 1 7\n", "line 5: the row is 0; the matrix has 1; count from 1"),
            ("1 1 1\n1 2 7\n", "line 3: the column is 2; the matrix has 1; count from 1"),
            ("1 1 1\n1 1\n", "line 3: the entry is missing"),
            ("1 1 1\n1\n", "line 3: the column is missing"),
            ("1 1 1\n1 1 1.5\n", "line 3: \"1.5\" is not an integer, as the entry must be"),
            ("1 1 1\n1 1 1 1\n", "line 3: \"1\" stands after the entry"),
            ("1 1\n", "line 2: a line of three counts is expected: rows, columns, entries"),
            ("1 -1 1\n", "line 2: the number of columns is -1; it cannot be negative"),
            ("", "line 1: the file ends before the line of counts"),
        ] {
            assert_eq!(error(&format!("{header}{text}")), message);
        }
        assert!(error(&format!("{header}1 1 2\n1 1 1\n")).contains("the file ends after 1 entries"));
        assert!(error("").contains("empty"));
        assert!(error("hello\n").contains("first line"));
        assert!(error("%%MatrixMarket matrix array real general\n").contains("\"array\""));
        assert!(error("%%MatrixMarket matrix coordinate real general\n").contains("\"real\""));
        assert!(error("%%MatrixMarket matrix coordinate integer symmetric\n").contains("\"symmetric\""));
    }

    #[test]
    fn graphs_and_distances_have_real_entries_and_may_be_symmetric() {
        let read = |text: &str| Relation::read(format!("%%MatrixMarket matrix coordinate {text}").as_bytes());
        let found = read("real symmetric\n% c\n4 4 2\n2 1 0.5\n3 3 1e-3\n").unwrap();
        let entries: Vec<_> = found.entries.iter().map(|e| (e.row, e.column, e.value, e.line)).collect();
        assert_eq!((found.count, found.is_symmetric), (4, true));
        assert_eq!(entries, [(1, 0, Some(0.5), 4), (2, 2, Some(0.001), 5)]);
        let found = read("pattern general\n2 2 1\n1 2\n").unwrap();
        assert!(!found.is_symmetric && found.entries[0].value.is_none());
        let error = |text: &str| read(text).map(|found| found.count).unwrap_err().to_string();
        assert!(error("real general\n2 3 1\n1 2 5\n").contains("2 rows and 3 columns"));
        assert!(error("real skew-symmetric\n2 2 0\n").contains("\"skew-symmetric\""));
        assert!(error("complex general\n2 2 0\n").contains("\"complex\""));
        assert!(error("real general\n2 2 1\n1 2 x\n").contains("line 3"));
        assert!(error("pattern general\n2 2 1\n1 2 1\n").contains("stands after the place of a pattern"));
        assert!(error("real general\n4000000000 4000000000 0\n").contains("only 0 entries"));
    }

    #[test]
    fn claimed_counts_take_no_memory() {
        let text = "%%MatrixMarket matrix coordinate pattern general\n";
        let kind = |counts: &str| read(format!("{text}{counts}").as_bytes()).unwrap_err().kind();
        assert_eq!(kind("4000000000 4000000000 0\n"), ErrorKind::TooLarge);
        assert_eq!(kind("1 9000000000000000000 0\n"), ErrorKind::TooLarge);
        assert_eq!(kind("1 1 9000000000000000000\n"), ErrorKind::Parse);
        let wide =
            format!("{text}1 1 1\n1 1\n").replace("pattern", "integer").replace("1 1\n", "1 1 4294967296\n");
        assert_eq!(read(wide.as_bytes()).unwrap_err().kind(), ErrorKind::Parse);
    }

    #[test]
    fn what_other_programs_write_is_read() {
        let text = "%%MatrixMarket MATRIX Coordinate Integer general\r\n% by hand\r\n 3 2 4 \r\n1 1 +2\r\n\r\n3 2 -1\r\n3 2 1\r\n2 1 0 % zero\r\n";
        let matrix = read(text.as_bytes()).unwrap();
        assert_eq!(matrix, SparseMatrix::from_entries(3, 2, [(0, 0, 2)]).unwrap());
        let pattern = "%%MatrixMarket matrix coordinate pattern general\n2 2 1\n2 1";
        assert_eq!(read(pattern.as_bytes()).unwrap().entry(1, 0), 1);
    }

    fn matrices() -> impl Strategy<Value = SparseMatrix> {
        prop::collection::vec((0usize..7, 0usize..5, any::<i32>()), 0..20).prop_map(|places| {
            let places: std::collections::BTreeMap<(usize, usize), i64> =
                places.into_iter().map(|(i, j, x)| ((i, j), i64::from(x.max(-i32::MAX)))).collect();
            SparseMatrix::from_entries(7, 5, places.into_iter().map(|((i, j), x)| (i, j, x))).unwrap()
        })
    }

    proptest! {
        #[test]
        fn write_then_read_gives_the_matrix(matrix in matrices()) {
            let mut text = Vec::new();
            write(&matrix, MatrixField::Integer, &mut text).unwrap();
            prop_assert_eq!(&read(&text[..]).unwrap(), &matrix);
            prop_assert_eq!(String::from_utf8(text).unwrap(), matrix.to_string());
            let mut text = Vec::new();
            write(&matrix, MatrixField::Pattern, &mut text).unwrap();
            let pattern = read(&text[..]).unwrap();
            prop_assert_eq!(pattern.rows(), matrix.rows());
            prop_assert!(pattern.entries().iter().all(|&entry| entry == 1));
        }

        /// A file cut short or with a byte changed gives a matrix or an error.
        #[test]
        fn no_bytes_make_the_reader_panic(
            matrix in matrices(),
            cut in any::<prop::sample::Index>(),
            changed in any::<prop::sample::Index>(),
            byte in any::<u8>(),
            noise in prop::collection::vec(any::<u8>(), 0..80),
        ) {
            let mut text = Vec::new();
            write(&matrix, MatrixField::Integer, &mut text).unwrap();
            let _ = read(&text[..cut.index(text.len())]);
            let at = changed.index(text.len());
            text[at] = byte;
            if let Ok(read) = read(&text[..]) {
                prop_assert!(read.entry_count() <= matrix.entry_count());
            }
            let _ = read(&noise[..]);
            let mut with_header = b"%%MatrixMarket matrix coordinate integer general\n".to_vec();
            with_header.extend(noise);
            let _ = read(&with_header[..]);
        }
    }
}
