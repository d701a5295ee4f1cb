//! Apache Parquet: tables by columns.
//!
//! The file has, between two marks, blocks of rows and a footer. A **block** (row group) has one page a column: a bit a row that says
//! whether there is a value, as runs, and then the values in plain encoding. The footer is a struct of Thrift in its compact protocol. Nothing
//! is compressed.
//!
//! Source: *Apache Parquet format*, `parquet.thrift` and `Encodings.md` (version 2.10); Apache Thrift, *Thrift compact protocol encoding*.

use super::{Cell, Column, Kind};
use coface_algebra::Error;
use std::io::Write;

const MARK: &[u8; 4] = b"PAR1";

/// A block ends with so many rows, or so many bytes.
const ROWS: usize = 1 << 16;
const BYTES: usize = 1 << 24;

/// Writes a table row by row; a block of rows is kept until it is whole.
pub(crate) struct ParquetWriter<'a> {
    out: &'a mut dyn Write,
    /// How many bytes were written.
    offset: usize,
    columns: Vec<Column>,
    pages: Vec<Page>,
    row_count: usize,
    blocks: Vec<Block>,
}

/// The values of one column in the block that is being filled.
#[derive(Clone, Default)]
struct Page {
    /// Runs of rows with a value, and of rows without.
    runs: Vec<(bool, usize)>,
    values: Vec<u8>,
    /// Booleans are eight to a byte.
    flag_count: usize,
}

/// A block that was written.
struct Block {
    row_count: usize,
    /// Where the page of each column begins, and how long it is.
    pages: Vec<(usize, usize)>,
}

impl<'a> ParquetWriter<'a> {
    /// Begins a file with these columns.
    ///
    /// # Errors
    /// [`ErrorKind::Io`](coface_algebra::ErrorKind::Io) from the stream.
    pub(super) fn begin(out: &'a mut dyn Write, columns: Vec<Column>) -> Result<Self, Error> {
        out.write_all(MARK)?;
        let pages = vec![Page::default(); columns.len()];
        Ok(Self { out, offset: MARK.len(), columns, pages, row_count: 0, blocks: Vec::new() })
    }

    /// Adds a row. A value that is not of the kind of its column is text in a column of text and nothing in any other.
    ///
    /// # Errors
    /// [`ErrorKind::Io`](coface_algebra::ErrorKind::Io) from the stream.
    pub(super) fn row(&mut self, cells: &[Cell]) -> Result<(), Error> {
        for ((column, page), cell) in self.columns.iter().zip(&mut self.pages).zip(cells) {
            page.add(column.kind, cell);
        }
        self.row_count += 1;
        let bytes: usize = self.pages.iter().map(|page| page.values.len()).sum();
        if self.row_count == ROWS || bytes >= BYTES { self.end_block() } else { Ok(()) }
    }

    fn end_block(&mut self) -> Result<(), Error> {
        if self.row_count == 0 {
            return Ok(());
        }
        let mut block = Block { row_count: self.row_count, pages: Vec::with_capacity(self.pages.len()) };
        for page in &mut self.pages {
            let bytes = std::mem::take(page).to_bytes(self.row_count);
            self.out.write_all(&bytes)?;
            block.pages.push((self.offset, bytes.len()));
            self.offset += bytes.len();
        }
        self.blocks.push(block);
        self.row_count = 0;
        Ok(())
    }

    /// Writes what is left, and the footer.
    ///
    /// # Errors
    /// [`ErrorKind::Io`](coface_algebra::ErrorKind::Io) from the stream.
    pub(super) fn end(mut self) -> Result<(), Error> {
        self.end_block()?;
        let footer = self.footer();
        self.out.write_all(&footer)?;
        let length =
            u32::try_from(footer.len()).map_err(|_| Error::invalid("the table has too many blocks"))?;
        self.out.write_all(&length.to_le_bytes())?;
        Ok(self.out.write_all(MARK)?)
    }

    /// `FileMetaData`.
    fn footer(&self) -> Vec<u8> {
        let mut file = Struct::default();
        file.int32(1, 1);
        file.list(2, STRUCT, self.columns.len() + 1, |elements| {
            let mut root = Struct::default();
            root.text(4, "schema");
            root.int32(5, self.columns.len());
            elements.extend(root.end());
            for column in &self.columns {
                elements.extend(schema_element(column));
            }
        });
        file.int64(3, self.blocks.iter().map(|block| block.row_count).sum());
        file.list(4, STRUCT, self.blocks.len(), |blocks| {
            self.blocks.iter().for_each(|block| blocks.extend(self.row_group(block)));
        });
        file.text(6, concat!("coface version ", env!("CARGO_PKG_VERSION")));
        file.end()
    }

    /// `RowGroup`.
    fn row_group(&self, block: &Block) -> Vec<u8> {
        let mut group = Struct::default();
        group.list(1, STRUCT, self.columns.len(), |chunks| {
            for (column, &(offset, length)) in self.columns.iter().zip(&block.pages) {
                let mut data = Struct::default();
                data.int32(1, physical_type(column.kind));
                data.list(2, INT32, 2, |encodings| [PLAIN, RLE].iter().for_each(|&e| zigzag(encodings, e)));
                data.list(3, TEXT, 1, |path| push_text(path, &column.name));
                data.int32(4, UNCOMPRESSED);
                data.int64(5, block.row_count);
                data.int64(6, length);
                data.int64(7, length);
                data.int64(9, offset);
                let mut chunk = Struct::default();
                chunk.int64(2, offset);
                chunk.inner(3, data);
                chunks.extend(chunk.end());
            }
        });
        group.int64(2, block.pages.iter().map(|&(_, length)| length).sum());
        group.int64(3, block.row_count);
        group.end()
    }
}

impl Page {
    fn add(&mut self, kind: Kind, cell: &Cell) {
        let has_value = self.push(kind, cell);
        match self.runs.last_mut() {
            Some((last, count)) if *last == has_value => *count += 1,
            _ => self.runs.push((has_value, 1)),
        }
    }

    /// Adds a value, if there is one of this kind.
    fn push(&mut self, kind: Kind, cell: &Cell) -> bool {
        let number = match (kind, cell) {
            (_, Cell::Nothing) => return false,
            (Kind::Flag, &Cell::Flag(flag)) => {
                if self.flag_count.is_multiple_of(8) {
                    self.values.push(0);
                }
                if let Some(last) = self.values.last_mut() {
                    *last |= u8::from(flag) << (self.flag_count % 8);
                }
                self.flag_count += 1;
                return true;
            }
            (Kind::Text, Cell::Text(text)) => {
                self.push_text(text);
                return true;
            }
            (Kind::Text, other) => {
                self.push_text(&serde_json::to_string(other).expect("values of tables are JSON"));
                return true;
            }
            (Kind::Whole, &Cell::Whole(number)) => Some(number.to_le_bytes()),
            (Kind::Whole, &Cell::Count(count)) => i64::try_from(count).ok().map(i64::to_le_bytes),
            (Kind::Real, &Cell::Real(number)) => Some(number.to_le_bytes()),
            (Kind::Real, &Cell::Whole(number)) => Some((number as f64).to_le_bytes()),
            (Kind::Real, &Cell::Count(count)) => Some((count as f64).to_le_bytes()),
            _ => None,
        };
        self.values.extend(number.iter().flatten());
        number.is_some()
    }

    fn push_text(&mut self, text: &str) {
        // A text beyond 4 GiB fits in no file of signatures or report: it would be cut.
        let length = u32::try_from(text.len()).unwrap_or(u32::MAX);
        self.values.extend(length.to_le_bytes());
        self.values.extend(&text.as_bytes()[..length as usize]);
    }

    /// The page with its header.
    fn to_bytes(&self, row_count: usize) -> Vec<u8> {
        let mut levels = Vec::new();
        for &(has_value, count) in &self.runs {
            varint(&mut levels, (count as u64) << 1);
            levels.push(u8::from(has_value));
        }
        let size = 4 + levels.len() + self.values.len();
        let mut data = Struct::default();
        data.int32(1, row_count);
        data.int32(2, PLAIN);
        data.int32(3, RLE);
        data.int32(4, RLE);
        let mut header = Struct::default();
        header.int32(1, DATA_PAGE);
        header.int32(2, size);
        header.int32(3, size);
        header.inner(5, data);
        let mut bytes = header.end();
        // Runs take two bytes or more of a block's.
        bytes.extend((levels.len() as u32).to_le_bytes());
        bytes.extend(levels);
        bytes.extend(&self.values);
        bytes
    }
}

const PLAIN: usize = 0;
const RLE: usize = 3;
const UNCOMPRESSED: usize = 0;
const DATA_PAGE: usize = 0;
const OPTIONAL: usize = 1;
const UTF8: usize = 0;

/// The number of the physical type of a column.
fn physical_type(kind: Kind) -> usize {
    match kind {
        Kind::Flag => 0,
        Kind::Whole => 2,
        Kind::Real => 5,
        Kind::Text => 6,
    }
}

/// `SchemaElement`.
fn schema_element(column: &Column) -> Vec<u8> {
    let mut element = Struct::default();
    element.int32(1, physical_type(column.kind));
    element.int32(3, OPTIONAL);
    element.text(4, &column.name);
    if column.kind == Kind::Text {
        element.int32(6, UTF8);
    }
    element.end()
}

// The types of the compact protocol.
const INT32: u8 = 5;
const INT64: u8 = 6;
const TEXT: u8 = 8;
const LIST: u8 = 9;
const STRUCT: u8 = 12;

/// A struct of Thrift; its fields are added in rising order.
#[derive(Default)]
struct Struct {
    bytes: Vec<u8>,
    last: u8,
}

impl Struct {
    fn head(&mut self, field: u8, of_type: u8) {
        self.bytes.push((field - self.last) << 4 | of_type);
        self.last = field;
    }

    fn int32(&mut self, field: u8, number: usize) {
        self.head(field, INT32);
        zigzag(&mut self.bytes, number);
    }

    fn int64(&mut self, field: u8, number: usize) {
        self.head(field, INT64);
        zigzag(&mut self.bytes, number);
    }

    fn text(&mut self, field: u8, text: &str) {
        self.head(field, TEXT);
        push_text(&mut self.bytes, text);
    }

    fn list(&mut self, field: u8, of_type: u8, count: usize, add: impl FnOnce(&mut Vec<u8>)) {
        self.head(field, LIST);
        match count {
            0..15 => self.bytes.push((count as u8) << 4 | of_type),
            _ => {
                self.bytes.push(0xf0 | of_type);
                varint(&mut self.bytes, count as u64);
            }
        }
        add(&mut self.bytes);
    }

    fn inner(&mut self, field: u8, inner: Self) {
        self.head(field, STRUCT);
        self.bytes.extend(inner.end());
    }

    fn end(mut self) -> Vec<u8> {
        self.bytes.push(0);
        self.bytes
    }
}

fn push_text(bytes: &mut Vec<u8>, text: &str) {
    varint(bytes, text.len() as u64);
    bytes.extend(text.as_bytes());
}

/// A number from 0 as a signed one: twice itself.
fn zigzag(bytes: &mut Vec<u8>, number: usize) {
    varint(bytes, (number as u64) << 1);
}

fn varint(bytes: &mut Vec<u8>, mut number: u64) {
    while number >= 0x80 {
        bytes.push((number & 0x7f) as u8 | 0x80);
        number >>= 7;
    }
    bytes.push(number as u8);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_in_groups_of_seven_bits() {
        let mut bytes = Vec::new();
        varint(&mut bytes, 300);
        zigzag(&mut bytes, 64);
        assert_eq!(bytes, [0xac, 0x02, 0x80, 0x01]);
    }

    /// The bytes of a file of one column and three rows, by hand from the specification.
    #[test]
    fn a_file_has_its_marks_page_and_footer() {
        let mut out = Vec::new();
        let columns = vec![Column { name: "n".to_owned(), kind: Kind::Whole }];
        let mut writer = ParquetWriter::begin(&mut out, columns).unwrap();
        for cell in [Cell::Whole(-1), Cell::Nothing, Cell::Count(2)] {
            writer.row(&[cell]).unwrap();
        }
        writer.end().unwrap();
        let page = [0x15, 0, 0x15, 52, 0x15, 52, 0x2c, 0x15, 6, 0x15, 0, 0x15, 6, 0x15, 6, 0, 0];
        let levels = [6, 0, 0, 0, 2, 1, 2, 0, 2, 1];
        assert_eq!(out[..4], *MARK);
        assert_eq!(out[4..4 + page.len()], page);
        assert_eq!(out[4 + page.len()..][..levels.len()], levels);
        let values = 4 + page.len() + levels.len();
        assert_eq!(out[values..][..8], (-1_i64).to_le_bytes());
        assert_eq!(out[values + 8..][..8], 2_i64.to_le_bytes());
        let footer = values + 16;
        let schema = [0x15, 2, 0x19, 0x2c, 0x48, 6, b's', b'c', b'h', b'e', b'm', b'a', 0x15, 2, 0];
        assert_eq!(out[footer..][..schema.len()], schema);
        let length = out.len() - footer - 8;
        assert_eq!(out[out.len() - 8..][..4], (length as u32).to_le_bytes());
        assert_eq!(out[out.len() - 4..], *MARK);
    }

    #[test]
    fn rows_beyond_a_block_begin_another() {
        let mut out = Vec::new();
        let columns = vec![Column { name: "flag".to_owned(), kind: Kind::Flag }];
        let mut writer = ParquetWriter::begin(&mut out, columns).unwrap();
        (0..ROWS + 1).for_each(|i| writer.row(&[Cell::Flag(i % 3 == 0)]).unwrap());
        assert_eq!((writer.blocks.len(), writer.row_count), (1, 1));
        writer.end().unwrap();
        assert!(out.len() > ROWS / 8);
    }
}
