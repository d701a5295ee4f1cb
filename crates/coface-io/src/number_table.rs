//! Tables of numbers: points of any dimension, distances.

use crate::counted_stream::{name_of, reading};
use crate::decimal_commas::{whole_text, with_decimal_points};
use crate::files::open_regular;
use crate::matrix_market::{self, Relation};
use crate::scanner::Scanner;
use crate::stream_start::plain_bytes;
use crate::volume::{NPY_MAGIC, write_npy_header};
use crate::word_columns::{Header, WordColumns, entries, is_word};
use crate::{Format, Remark, RemarkCode, TableForm, VolumeStream};
use coface_algebra::Error;
use std::io::{Read, Write};
use std::path::Path;

/// Rows of numbers, which may have different lengths, and the line of each.
///
/// # Examples
/// ```
/// use coface_io::NumberTable;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let table = NumberTable::read(&b"# a triangle\n0,0\n1;0\n0 1\n"[..])?;
/// assert_eq!(table.row_count(), 3);
/// assert_eq!(table.row(1), [1.0, 0.0]);
/// assert_eq!(table.line(0), Some(2));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct NumberTable {
    numbers: Vec<f64>,
    starts: Vec<usize>,
    /// Empty where there are no lines.
    lines: Vec<u64>,
    /// That columns of words were left out.
    left_out: Option<Remark>,
    /// That commas are decimal commas.
    commas: Option<Remark>,
    /// Whether it was read from text, in which no row is no point.
    is_text: bool,
    /// See [`Self::is_list_of_pairs`].
    is_list_of_pairs: bool,
}

impl NumberTable {
    /// The table of a file: a NumPy array of one or two axes, or text as [`Self::read`] reads it.
    ///
    /// # Errors
    /// [`ErrorKind::Io`](coface_algebra::ErrorKind::Io) where the file cannot be read,
    /// [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) for a damaged one, and
    /// [`ErrorKind::Shape`](coface_algebra::ErrorKind::Shape) for an array of more than two axes. All name the file.
    pub fn read_path(path: impl AsRef<Path>) -> Result<Self, Error> {
        Self::of_path(path.as_ref(), Self::read)
    }

    /// The table of a file as [`Self::read_distances`] reads it.
    pub(crate) fn read_distances_of_path(path: &Path) -> Result<Self, Error> {
        Self::of_path(path, Self::read_distances)
    }

    fn of_path(path: &Path, read: impl FnOnce(Box<dyn Read>) -> Result<Self, Error>) -> Result<Self, Error> {
        let named = |error: Error| error.in_file(path.display().to_string());
        let file = open_regular(path).map_err(named)?;
        let size = file.metadata().map_or(0, |metadata| metadata.len());
        read(Box::new(reading(&name_of(path), file, size))).map_err(named)
    }

    /// The table of a stream: a NumPy array of one or two axes, or text in UTF-8 or UTF-16; either may be compressed. A row is a line of numbers with blanks, commas or semicolons between
    /// them. A comma in numbers that semicolons, tabs or quotes hold apart is a decimal comma, of which [`Self::remarks`] tells. Empty lines and lines that begin with `#`
    /// or `//` are passed over, and so are a first line of words, with as many of them as there are columns, and columns of words, of which [`Self::left_out`] tells.
    ///
    /// # Errors
    /// As of [`Self::read_path`], without the name.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # Examples
    /// See [`NumberTable`].
    pub fn read(input: impl Read) -> Result<Self, Error> {
        let table = Self::read_distances(input)?;
        if table.is_list_of_pairs {
            let error = Error::invalid(
                "a matrix of Matrix Market is a graph, or has distances, and no rows of points",
            );
            return Err(error.with_cure("read it as a graph (--flag) or as distances (--rips)"));
        }
        Ok(table)
    }

    /// The table of a stream as [`Self::read`] has it, or of a square matrix in the coordinate format of Matrix Market: rows `i j distance` with points from
    /// 0 on, which [`TableForm::of`] takes for sparse distances.
    ///
    /// # Errors
    /// As of [`Self::read`], and [`ErrorKind::Shape`](coface_algebra::ErrorKind::Shape) for a matrix that is not square.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{NumberTable, TableForm};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = b"%%MatrixMarket matrix coordinate real symmetric\n3 3 1\n2 1 0.5\n";
    /// let table = NumberTable::read_distances(&text[..])?;
    /// assert_eq!((table.row(0), TableForm::of(&table).0), (&[1.0, 0.0, 0.5][..], TableForm::Sparse));
    /// assert!(NumberTable::read(&text[..]).is_err());
    /// # Ok(()) }
    /// ```
    pub fn read_distances(input: impl Read) -> Result<Self, Error> {
        let mut input = plain_bytes(input)?;
        let mut start = Vec::new();
        input.by_ref().take(matrix_market::START).read_to_end(&mut start)?;
        let is_array = start.starts_with(NPY_MAGIC);
        let is_matrix = matrix_market::is_matrix_market(&start);
        let is_markup =
            ["<?xml", "<graphml"].iter().any(|tag| start.trim_ascii_start().starts_with(tag.as_bytes()));
        if is_markup {
            return Err(Error::invalid("a file of XML, such as GraphML, has no rows of numbers")
                .with_cure("read a graph as one (--flag), or write rows of numbers"));
        }
        let whole = std::io::Cursor::new(start).chain(input);
        if is_matrix {
            return Self::of_matrix(&Relation::read(whole)?);
        }
        if is_array { Self::of_array(VolumeStream::new(whole, Format::Npy)?) } else { Self::of_text(whole) }
    }

    /// Rows `i j distance` with points from 0 on.
    fn of_matrix(matrix: &Relation) -> Result<Self, Error> {
        let mut table = Self { starts: vec![0], is_list_of_pairs: true, ..Self::default() };
        for entry in &matrix.entries {
            let Some(distance) = entry.value else {
                let error =
                    Error::invalid("a pattern has no distances").with_cure("write a matrix of real numbers");
                return Err(error.at_line(entry.line));
            };
            table.push_row(&[entry.row as f64, entry.column as f64, distance], entry.line);
        }
        if let Some(last) = matrix.count.checked_sub(1) {
            // So that points without distances are there.
            table.push_row(&[last as f64, last as f64, 0.0], 2);
        }
        Ok(table)
    }

    /// Whether its rows are two points and their distance, as a sparse matrix has it.
    pub(crate) fn is_list_of_pairs(&self) -> bool {
        self.is_list_of_pairs
    }

    fn of_array(stream: VolumeStream<'_>) -> Result<Self, Error> {
        let shape: Vec<usize> = stream.shape().iter().map(|&length| length as usize).collect();
        let (rows, columns) = match shape[..] {
            [columns] => (1, columns),
            [rows, columns] => (rows, columns),
            _ => {
                return Err(Error::new(
                    coface_algebra::ErrorKind::Shape,
                    format!("an array of shape {shape:?} is no table of points or distances"),
                )
                .with_cure("write an array of shape (points, coordinates)"));
            }
        };
        let is_transposed = shape.len() == 2 && stream.fastest_axis() == 0;
        let (mut numbers, _) = stream.numbers()?;
        if is_transposed {
            let place = |at: usize| (at % columns) * rows + at / columns;
            numbers = (0..numbers.len()).map(|at| numbers[place(at)]).collect();
        }
        Ok(Self {
            numbers,
            starts: (0..=rows).map(|row| row * columns).collect(),
            lines: Vec::new(),
            left_out: None,
            commas: None,
            is_text: false,
            is_list_of_pairs: false,
        })
    }

    fn of_text(input: impl Read) -> Result<Self, Error> {
        let text = whole_text(input)?;
        let (text, commas) = with_decimal_points(&text)?;
        let mut scanner = Scanner::new(&text[..]);
        let mut table = Self { starts: vec![0], commas, is_text: true, ..Self::default() };
        let mut columns = WordColumns::default();
        let (mut header, mut has_unnamed) = (Header::default(), false);
        while let Some(line) = scanner.next_line()? {
            let begins_unnamed = matches!(line.first(), Some(b'\t' | b',' | b';'));
            let line = line.trim_ascii();
            if line.starts_with(b"#") || line.starts_with(b"//") {
                continue;
            }
            let words = entries(line);
            if words.is_empty() {
                continue;
            }
            if table.numbers.is_empty() {
                // The first line of words has the names of the columns.
                if header.is_none() && words.iter().all(|word| is_word(word)) {
                    has_unnamed = begins_unnamed;
                    header = Header::of(words.len() + usize::from(has_unnamed), scanner.line_number());
                    continue;
                }
                columns = WordColumns::of(&words);
            }
            header.note_row(words.len());
            let numbers = columns.numbers(&words, "each entry of a table");
            let numbers = numbers.map_err(|error| {
                let cure =
                    error.cure().unwrap_or("write numbers with blanks or commas between them").to_owned();
                error.at_line(scanner.line_number()).with_cure(cure)
            })?;
            table.push_row(&numbers, scanner.line_number());
        }
        header.check()?;
        table.left_out = (columns.count() > 0).then(|| columns.remark(" of the table"));
        if has_unnamed && table.first_column_counts() {
            table.leave_out_first_column();
        }
        Ok(table)
    }

    /// Whether the entries of the first column are the numbers of the rows, from 0 or 1, and there are others.
    fn first_column_counts(&self) -> bool {
        let Some(first) = (self.row_count() > 0).then(|| self.row(0)[0]) else { return false };
        let counts = |row: usize| self.row(row).len() > 1 && self.row(row)[0] == first + row as f64;
        (first == 0.0 || first == 1.0) && (0..self.row_count()).all(counts)
    }

    /// Leaves the first column out, which has no name and counts the rows, as tables of pandas have it.
    fn leave_out_first_column(&mut self) {
        let mut kept =
            Self { starts: vec![0], commas: self.commas.take(), is_text: self.is_text, ..Self::default() };
        for row in 0..self.row_count() {
            kept.push_row(&self.row(row)[1..], self.line(row).unwrap_or_default());
        }
        let message = match &self.left_out {
            Some(words) => format!("the first column, which counts the rows, is left out; {}", words.message),
            None => "the first column, which counts the rows, is left out".to_owned(),
        };
        let count = 1 + self.left_out.as_ref().map_or(0, |words| words.count as usize);
        kept.left_out = Some(Remark::new(RemarkCode::DataLeftOut, message).at(count, []));
        *self = kept;
    }

    /// What was left out: columns of words, such as names, labels and dates.
    ///
    /// # Examples
    /// ```
    /// use coface_io::NumberTable;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let table = NumberTable::read(&b"length,width,species\n5.1,3.5,setosa\n4.9,3.0,setosa\n"[..])?;
    /// assert_eq!((table.row(1), table.left_out().expect("the species").count), (&[4.9, 3.0][..], 1));
    /// # Ok(()) }
    /// ```
    pub fn left_out(&self) -> Option<Remark> {
        self.left_out.clone()
    }

    /// What was assumed and left out: [`Self::left_out`], and that commas were read as decimal commas.
    ///
    /// # Examples
    /// ```
    /// use coface_io::NumberTable;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let table = NumberTable::read(&b"0,5;1,25\n2;3,5\n"[..])?;
    /// assert_eq!((table.row(0), table.remarks().len()), (&[0.5, 1.25][..], 1));
    /// # Ok(()) }
    /// ```
    pub fn remarks(&self) -> Vec<Remark> {
        self.left_out.iter().chain(&self.commas).cloned().collect()
    }

    /// The same table, which must not have had words.
    ///
    /// # Errors
    /// [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) if columns of words were left out.
    ///
    /// # Examples
    /// ```
    /// use coface_io::NumberTable;
    /// let table = NumberTable::read(&b"1,a\n2,b\n"[..]).expect("numbers with letters");
    /// assert!(table.of_numbers_only().is_err());
    /// ```
    pub fn of_numbers_only(self) -> Result<Self, Error> {
        match self.left_out {
            None => Ok(self),
            Some(_) => Err(Error::parse("the table has a column of words").with_cure("write numbers alone")),
        }
    }

    /// The table with these rows.
    ///
    /// # Examples
    /// ```
    /// let table = coface_io::NumberTable::from_rows([[1.0, 2.0], [3.0, 4.0]]);
    /// assert_eq!((table.row_count(), table.row(1)), (2, &[3.0, 4.0][..]));
    /// ```
    pub fn from_rows(rows: impl IntoIterator<Item = impl AsRef<[f64]>>) -> Self {
        let mut table = Self { starts: vec![0], ..Self::default() };
        for row in rows {
            table.numbers.extend_from_slice(row.as_ref());
            table.starts.push(table.numbers.len());
        }
        table
    }

    /// Adds a row, which stands on this line.
    ///
    /// # Examples
    /// ```
    /// use coface_io::NumberTable;
    /// let mut table = NumberTable::default();
    /// table.push_row(&[1.0, 2.0], 7);
    /// assert_eq!((table.row(0), table.line(0)), (&[1.0, 2.0][..], Some(7)));
    /// ```
    pub fn push_row(&mut self, numbers: &[f64], line: u64) {
        if self.starts.is_empty() {
            self.starts.push(0);
        }
        self.numbers.extend_from_slice(numbers);
        self.starts.push(self.numbers.len());
        self.lines.push(line);
    }

    /// Refuses a text without rows, in which there is no point; of distances alone no row is one point, and arrays may be empty.
    pub(crate) fn require_points(&self, form: TableForm) -> Result<(), Error> {
        let is_one_point = matches!(form, TableForm::Lower | TableForm::Upper);
        if self.row_count() > 0 || is_one_point || !self.is_text {
            return Ok(());
        }
        Err(Error::invalid("there is no point").with_cure("give a row of numbers for each point"))
    }

    /// The points of a time series: the numbers of row i, of row i + delay, and so on, `dimension` rows in all, one after the other.
    ///
    /// The shape of their Vietoris-Rips filtration is that of the dynamics (F. Takens, *Detecting strange attractors in turbulence*, 1981).
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for a delay or a dimension of 0, and where the series is too short
    /// for a point.
    ///
    /// # Examples
    /// ```
    /// use coface_io::NumberTable;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let series = NumberTable::from_rows([[1.0], [2.0], [3.0], [4.0]]);
    /// assert_eq!(series.delayed(2, 2)?, NumberTable::from_rows([[1.0, 3.0], [2.0, 4.0]]));
    /// # Ok(()) }
    /// ```
    pub fn delayed(&self, delay: usize, dimension: usize) -> Result<Self, Error> {
        // A file of one line is a series too.
        if self.row_count() == 1 && self.numbers.len() > 1 {
            return Self::from_rows(self.numbers.chunks(1)).delayed(delay, dimension);
        }
        let (1.., 1..) = (delay, dimension) else {
            return Err(Error::invalid(format!(
                "a delay of {delay} and {dimension} values a point make no points"
            ))
            .with_cure("give numbers from 1 on"));
        };
        let spread = delay.checked_mul(dimension - 1);
        let Some(count) = spread.and_then(|spread| self.row_count().checked_sub(spread)).filter(|&n| n > 0)
        else {
            return Err(Error::invalid(format!(
                "a series of {} has no {dimension} values that are {delay} apart",
                self.row_count()
            ))
            .with_cure("give a shorter delay, fewer values a point, or a longer series"));
        };
        let point = |i: usize| -> Vec<f64> {
            (0..dimension).flat_map(|step| self.row(i + step * delay)).copied().collect()
        };
        Ok(Self::from_rows((0..count).map(point)))
    }

    /// How many coordinates the points have that are the rows; 0 without rows.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) with the line of a row of another length, for which this is the cure, and of one
    /// with a coordinate that is not finite.
    ///
    /// # Examples
    /// ```
    /// use coface_io::NumberTable;
    /// assert_eq!(NumberTable::from_rows([[1.0, 2.0], [3.0, 4.0]]).point_dimension("").expect("points"), 2);
    /// let uneven = NumberTable::from_rows([vec![1.0], vec![1.0, 2.0]]);
    /// assert!(uneven.point_dimension("give each point as many numbers").is_err());
    /// ```
    pub fn point_dimension(&self, cure: &str) -> Result<usize, Error> {
        let dimension = if self.row_count() == 0 { 0 } else { self.row(0).len() };
        for row in 0..self.row_count() {
            let fault = |message: String, cure: &str| {
                let error = Error::invalid(message).with_cure(cure);
                match self.line(row) {
                    Some(line) => error.at_line(line),
                    None => error,
                }
            };
            let point = self.row(row);
            if point.len() != dimension {
                let count = point.len();
                let coordinates = if count == 1 { "coordinate" } else { "coordinates" };
                let message = format!("point {row} has {count} {coordinates}, and point 0 has {dimension}");
                return Err(fault(message, cure));
            }
            if let Some(number) = point.iter().find(|number| !number.is_finite()) {
                let message = format!("a coordinate of point {row} is {number}");
                return Err(fault(message, "give finite coordinates, or leave the point out"));
            }
        }
        Ok(dimension)
    }

    /// Writes the table as a NumPy array of two axes: numbers of 8 bytes, a row after the other.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`](coface_algebra::ErrorKind::Shape) if rows have different lengths; [`ErrorKind::Io`](coface_algebra::ErrorKind::Io) if
    /// the stream cannot be written.
    ///
    /// # Examples
    /// ```
    /// use coface_io::NumberTable;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let table = NumberTable::from_rows([[1.0, 2.5], [3.0, f64::INFINITY]]);
    /// let mut file = Vec::new();
    /// table.write_npy(&mut file)?;
    /// assert_eq!(NumberTable::read(&file[..])?.numbers(), table.numbers());
    /// # Ok(()) }
    /// ```
    pub fn write_npy(&self, mut out: impl Write) -> Result<(), Error> {
        let rows = self.row_count();
        let columns = if rows == 0 { 0 } else { self.row(0).len() };
        if let Some(row) = (0..rows).find(|&row| self.row(row).len() != columns) {
            let message = format!("row {row} has {} numbers, and row 0 has {columns}", self.row(row).len());
            return Err(Error::new(coface_algebra::ErrorKind::Shape, message)
                .with_cure("give all rows of an array the same length"));
        }
        write_npy_header(&[rows, columns], "<f8", &mut out)?;
        let bytes: Vec<u8> = self.numbers.iter().flat_map(|number| number.to_le_bytes()).collect();
        out.write_all(&bytes)?;
        Ok(())
    }

    /// The number of rows that have numbers.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_io::NumberTable::read(&b"x y\n\n1 2\n"[..]).expect("a table").row_count(), 1);
    /// ```
    pub fn row_count(&self) -> usize {
        self.starts.len().saturating_sub(1)
    }

    /// The numbers of a row.
    ///
    /// # Panics
    /// If there is no such row.
    ///
    /// # Examples
    /// See [`NumberTable`].
    pub fn row(&self, row: usize) -> &[f64] {
        &self.numbers[self.starts[row]..self.starts[row + 1]]
    }

    /// All numbers, one row after the other.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_io::NumberTable::read(&b"1\n2,3\n"[..]).expect("a table").numbers(), [1.0, 2.0, 3.0]);
    /// ```
    pub fn numbers(&self) -> &[f64] {
        &self.numbers
    }

    /// The line of a row, from 1; `None` for an array.
    ///
    /// # Examples
    /// See [`NumberTable`].
    pub fn line(&self, row: usize) -> Option<u64> {
        self.lines.get(row).copied()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_first_column_without_a_name_that_counts_the_rows_is_no_coordinate() {
        let read = |text: &str| NumberTable::read(text.as_bytes()).unwrap();
        let table = read(",x,y\n0,5,6\n1,7,8\n2,9,9\n");
        assert_eq!((table.row_count(), table.row(1), table.line(1)), (3, &[7.0, 8.0][..], Some(3)));
        assert!(table.left_out().unwrap().message.contains("counts the rows"));
        let named = read("\tx\tkind\n1\t5\ta\n2\t7\tb\n");
        assert_eq!((named.row(1), named.left_out().unwrap().count), (&[7.0][..], 2));
        // Other numbers are coordinates, and so is what has a name.
        for text in [",x,y\n0,5,6\n2,7,8\n", "n,x,y\n0,5,6\n1,7,8\n", "0,5,6\n1,7,8\n"] {
            assert_eq!(read(text).row(1).len(), 3, "{text}");
        }
    }

    #[test]
    fn headers_name_all_columns() {
        for text in ["x;y;z\n1;2\n", "t\n0,5\n1,5\n", "x y\n1 2 3\n4 5 6\n"] {
            let error = NumberTable::read(text.as_bytes()).unwrap_err();
            assert!(error.to_string().contains("the header has") && error.line() == Some(1), "{error}");
        }
        // Distances below the diagonal have rows of all lengths.
        assert_eq!(NumberTable::read(&b"a b\n3\n5 4\n"[..]).unwrap().row_count(), 2);
    }

    #[test]
    fn marks_and_packing_make_no_difference() {
        let text = "0,1\n2,3.5\n";
        let table = NumberTable::read(text.as_bytes()).unwrap();
        let marked = format!("\u{feff}{text}");
        assert_eq!(NumberTable::read(marked.as_bytes()).unwrap(), table, "the mark is no word of a header");
        let wide: Vec<u8> = marked.encode_utf16().flat_map(u16::to_le_bytes).collect();
        assert_eq!(NumberTable::read(&wide[..]).unwrap(), table);
        let mut array = Vec::new();
        table.write_npy(&mut array).unwrap();
        #[cfg(feature = "compression")]
        for bytes in [text.as_bytes(), &wide[..], &array[..]] {
            let mut packed = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
            packed.write_all(bytes).unwrap();
            assert_eq!(NumberTable::read(&packed.finish().unwrap()[..]).unwrap().numbers(), table.numbers());
        }
    }
}
