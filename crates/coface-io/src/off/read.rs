//! Reading OFF.

use super::words;
use crate::blocks::{Block, Blocks};
use crate::decimal::{is_blank, short_decimal, short_natural, skip_blanks};
use crate::lists::Elements;
use crate::oddities::Oddities;
use crate::scanner::{Scanner, parse_coordinate, parse_i64, quoted};
use crate::{Model, Place, ReadOptions, Remark, RemarkCode, readers};
use coface_algebra::{Error, ErrorKind};
use std::io::{Cursor, Read};
use std::path::Path;

/// What the keyword and the counts say.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Header {
    /// The number of coordinates of a vertex.
    pub(super) dimension: usize,
    /// The numbers that follow the coordinates of a vertex: normal, color, texture coordinates.
    pub(super) attributes: usize,
    pub(super) vertices: u64,
    pub(super) faces: u64,
}

/// What the letters before `OFF` ask for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Keyword {
    texture: bool,
    color: bool,
    normal: bool,
    four: bool,
    pub(super) any_dimension: bool,
}

impl Keyword {
    /// The keyword that a token spells; `None` if it is none.
    pub(super) fn parse(token: &[u8]) -> Option<Self> {
        let mut rest = token.strip_suffix(b"OFF")?;
        let mut keyword = Self::default();
        while let Some(&letter) = rest.first() {
            let (flag, length) = match letter {
                b'S' if rest.starts_with(b"ST") => (&mut keyword.texture, 2),
                b'C' => (&mut keyword.color, 1),
                b'N' => (&mut keyword.normal, 1),
                b'4' => (&mut keyword.four, 1),
                b'n' => (&mut keyword.any_dimension, 1),
                _ => return None,
            };
            if *flag {
                return None;
            }
            *flag = true;
            rest = &rest[length..];
        }
        Some(keyword)
    }

    /// The keyword that a token begins with, and the count that stands behind it without a blank (`OFF8 6 12`), mostly none.
    pub(super) fn before_count(token: &[u8]) -> Option<(Self, &[u8])> {
        let end = memchr::memmem::find(token, b"OFF")? + 3;
        let (keyword, count) = token.split_at(end);
        let is_count = count.iter().all(u8::is_ascii_digit);
        Some((Self::parse(keyword).filter(|_| is_count)?, count))
    }

    /// The keyword of a binary file, and where its numbers begin.
    fn of_binary(bytes: &[u8]) -> Option<(Self, usize)> {
        let end = memchr::memchr(b'\n', bytes)?;
        let mut words = words(&bytes[..end]);
        let keyword = Self::parse(words.next()?)?;
        (words.next() == Some(b"BINARY")).then_some((keyword, end + 1))
    }

    /// The number of coordinates and of further numbers at each vertex.
    fn widths(self, dimension: usize) -> (usize, usize) {
        let attributes = if self.normal { dimension } else { 0 }
            + if self.color { 4 } else { 0 }
            + if self.texture { 2 } else { 0 };
        (dimension, attributes)
    }
}

/// Reads a model in OFF, text or binary.
///
/// # Errors
/// [`ErrorKind::Parse`] or [`ErrorKind::InvalidInput`] with the line (or the byte, in the binary form): text that is no
/// OFF, a number that is none, an index out of range, a face that repeats a vertex, fewer vertices or
/// faces than the counts promise; [`ErrorKind::Io`] if the stream fails.
///
/// # Complexity
/// Linear in the file; memory is the model and a few blocks of text, whatever the counts claim.
///
/// # References
/// Geomview manual, section "OFF Files".
///
/// # Examples
/// ```
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let text = "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3  0.5 0.5 0.5\n";
/// let square = coface_io::off::read(text.as_bytes())?;
/// assert_eq!(square.vertex_count(), 4);
/// assert_eq!(square.polygons().list(0), [0, 1, 2, 3]);
/// # Ok(()) }
/// ```
pub fn read(input: impl Read) -> Result<Model, Error> {
    read_with(input, &ReadOptions::default())
}

/// Reads a file a line a record. One that is laid out in another way is read again, word by word, from what is kept of it.
pub(crate) fn read_with(input: impl Read, options: &ReadOptions) -> Result<Model, Error> {
    let mut kept = Kept { input, bytes: Vec::new(), is_whole: true };
    let fault = match read_lines(&mut kept, options) {
        Ok(model) => return Ok(model),
        Err(fault) => fault,
    };
    let mut rest = [0; 1 << 13];
    while kept.is_whole {
        match kept.read(&mut rest) {
            Ok(0) => break,
            Ok(_) => {}
            Err(error) if error.kind() == std::io::ErrorKind::Interrupted => {}
            Err(_) => return Err(fault),
        }
    }
    if kept.is_whole { read_otherwise(&kept.bytes, fault, options) } else { Err(fault) }
}

/// The same from a file on disk, of which nothing is kept: it is opened again where it is laid out in another way.
pub(crate) fn read_file(input: impl Read, path: &Path, options: &ReadOptions) -> Result<Model, Error> {
    let fault = match read_lines(input, options) {
        Ok(model) => return Ok(model),
        Err(fault) => fault,
    };
    let mut bytes = Vec::new();
    match readers::bytes_again(path).and_then(|mut input| Ok(input.read_to_end(&mut bytes)?)) {
        Ok(_) => read_otherwise(&bytes, fault, options),
        Err(_) => Err(fault),
    }
}

/// Reads a file that is not laid out line by line, or the part of it before its fault.
fn read_otherwise(bytes: &[u8], fault: Error, options: &ReadOptions) -> Result<Model, Error> {
    let (other, remark) = if is_binary(bytes) {
        let other = |layout: Layout| {
            let (keyword, at) = Keyword::of_binary(bytes)?;
            read_binary(Scanner::new(&bytes[at..]), keyword, layout).ok()
        };
        let little = Layout { big: false, has_colors: true };
        match other(little) {
            Some(model) => {
                (Some(model), "the numbers of the binary file are little-endian; OFF files are big-endian")
            }
            // As the library pmp writes them.
            None => (
                other(Layout { has_colors: false, ..little }),
                "the numbers of the binary file are little-endian, and faces have no number of color components; OFF files are big-endian, and have it",
            ),
        }
    } else {
        let words = words::read(bytes);
        (words, "the vertices and faces do not have a line each; the file is read word by word")
    };
    match other {
        Some(mut model) => {
            model.remarks.insert(0, Remark::new(RemarkCode::InputReading, remark));
            Ok(model)
        }
        None if options.partial => read_lines_partly(bytes, &fault, options),
        None => Err(fault),
    }
}

/// What stands before the fault.
fn read_lines_partly(bytes: &[u8], fault: &Error, options: &ReadOptions) -> Result<Model, Error> {
    let mut blocks = Blocks::new(Cursor::new(bytes));
    match read_header(&mut blocks)? {
        Start::Text(header) => read_text(blocks, header, options),
        Start::Binary(_) => Err(fault.clone()),
    }
}

fn read_lines(input: impl Read, options: &ReadOptions) -> Result<Model, Error> {
    let mut blocks = Blocks::new(input);
    // What stands before a fault is only wanted when there is no other way to read the file.
    let whole = ReadOptions { partial: false, ..*options };
    match read_header(&mut blocks)? {
        Start::Text(header) => read_text(blocks, header, &whole),
        Start::Binary(keyword) => read_binary(blocks.into_scanner(), keyword, Layout::OFF),
    }
}

/// So much of a file is kept for a second reading.
const LONGEST_KEPT: usize = 1 << 26;

/// A stream whose beginning is kept.
struct Kept<R> {
    input: R,
    bytes: Vec<u8>,
    is_whole: bool,
}

impl<R: Read> Read for Kept<R> {
    fn read(&mut self, out: &mut [u8]) -> std::io::Result<usize> {
        let count = self.input.read(out)?;
        if self.is_whole {
            if self.bytes.len() + count > LONGEST_KEPT {
                (self.bytes, self.is_whole) = (Vec::new(), false);
            } else {
                self.bytes.extend_from_slice(&out[..count]);
            }
        }
        Ok(count)
    }
}

fn is_binary(bytes: &[u8]) -> bool {
    Keyword::of_binary(bytes).is_some()
}

/// How the data go on behind the header.
enum Start {
    Text(Header),
    Binary(Keyword),
}

/// Reads words line by line up to the counts.
fn read_header<R: Read>(blocks: &mut Blocks<R>) -> Result<Start, Error> {
    let mut keyword = None;
    let mut dimension = None;
    let mut counts: Vec<u64> = Vec::new();
    let mut last = 1;
    while let Some((line, number)) = blocks.next_line()? {
        last = number;
        let mut words = words(&line).peekable();
        if words.peek().is_none() {
            continue;
        }
        if counts.len() == 2 {
            // The number of edges, alone on its line, is not needed; anything else is the first vertex.
            let alone = words.next().is_some_and(|word| word.iter().all(u8::is_ascii_digit))
                && words.next().is_none();
            if !alone {
                blocks.put_back(&line);
            }
            break;
        }
        let mut glued = None;
        if keyword.is_none() {
            let word = words.peek().copied().unwrap_or_default();
            keyword = Some(match Keyword::before_count(word) {
                Some((keyword, count)) => {
                    words.next();
                    glued = Some(count).filter(|count| !count.is_empty());
                    keyword
                }
                None if word.iter().all(u8::is_ascii_digit) => Keyword::default(),
                None => {
                    return Err(Error::parse(format!("{} is neither OFF nor a count", quoted(word)))
                        .at_line(number)
                        .with_cure(
                            "an OFF file begins with OFF and the numbers of vertices, faces and edges",
                        ));
                }
            });
            if words.peek().is_some_and(|word| *word == b"BINARY") {
                return Ok(Start::Binary(keyword.unwrap_or_default()));
            }
        }
        let any_dimension = keyword.is_some_and(|keyword| keyword.any_dimension);
        for word in glued.into_iter().chain(words) {
            let what = match counts.len() {
                _ if any_dimension && dimension.is_none() => "the dimension",
                0 => "the number of vertices",
                1 => "the number of faces",
                2 => "the number of edges",
                _ => {
                    return Err(Error::parse(format!("{} stands behind the counts", quoted(word)))
                        .at_line(number)
                        .with_cure("begin a new line for the first vertex"));
                }
            };
            let value = parse_i64(word, what).map_err(|error| error.at_line(number))?;
            let value = u64::try_from(value).map_err(|_| {
                Error::parse(format!("{what} is {value}; it cannot be negative")).at_line(number)
            })?;
            if any_dimension && dimension.is_none() {
                dimension = Some(value);
            } else {
                counts.push(value);
            }
        }
        if counts.len() == 3 {
            break;
        }
    }
    let keyword = keyword.ok_or_else(|| {
        Error::parse("the file is empty")
            .at_line(last)
            .with_cure("an OFF file begins with OFF and three counts")
    })?;
    let &[vertices, faces, ..] = counts.as_slice() else {
        return Err(Error::parse("the file ends before the numbers of vertices and faces").at_line(last));
    };
    header(keyword, dimension.unwrap_or(3), vertices, faces)
        .map(Start::Text)
        .map_err(|error| error.at_line(last))
}

/// The words of a line up to a comment.
fn words(line: &[u8]) -> impl Iterator<Item = &[u8]> {
    let end = memchr::memchr(b'#', line).unwrap_or(line.len());
    line[..end].split(|&byte| is_blank(byte) || byte == b'\n').filter(|word| !word.is_empty())
}

/// The header, with the limits of a model checked.
pub(super) fn header(keyword: Keyword, dimension: u64, vertices: u64, faces: u64) -> Result<Header, Error> {
    let dimension = match (keyword.any_dimension, keyword.four) {
        (true, four) => dimension.saturating_add(u64::from(four)),
        (false, four) => 3 + u64::from(four),
    };
    if dimension == 0 || dimension > 1 << 16 {
        return Err(Error::invalid(format!("the dimension is {dimension}; it must be from 1 to 65536"))
            .with_cure("write the number of coordinates that a vertex has"));
    }
    if vertices > u64::from(u32::MAX) {
        return Err(Error::new(ErrorKind::TooLarge, format!("{vertices} vertices; the limit is 2^32 - 1"))
            .with_cure("write the number of vertices that are there, or divide the model"));
    }
    let (dimension, attributes) = keyword.widths(dimension as usize);
    Ok(Header { dimension, attributes, vertices, faces })
}

/// What was read of a block, up to the fault.
#[derive(Default)]
pub(super) struct Piece {
    pub(super) coordinates: Vec<f64>,
    pub(super) elements: Elements,
    records: u64,
    /// The lines behind the last face.
    pub(super) surplus: u64,
    pub(super) oddities: Oddities,
    fault: Option<Error>,
}

fn read_text<R: Read>(blocks: Blocks<R>, header: Header, options: &ReadOptions) -> Result<Model, Error> {
    let mut whole = Piece::default();
    let read = blocks.parse(
        count_records,
        |block| parse_block(block, header),
        |piece| {
            whole.coordinates.extend_from_slice(&piece.coordinates);
            whole.elements.append(&piece.elements)?;
            whole.records += piece.records;
            whole.surplus += piece.surplus;
            whole.oddities.append(piece.oddities);
            piece.fault.map_or(Ok(()), Err)
        },
    );
    let mut fault = read.err();
    if fault.is_none() && whole.records < header.vertices + header.faces {
        let (what, promised, found) = if whole.records < header.vertices {
            ("vertices", header.vertices, whole.records)
        } else {
            ("faces", header.faces, whole.records - header.vertices)
        };
        fault = Some(
            Error::parse(format!(
                "the header promises {promised} {what}, but the file ends after {found}: {} lines are missing",
                header.vertices + header.faces - whole.records
            ))
            .with_cure("correct the counts, or read what is there with --partial"),
        );
    }
    match fault {
        Some(fault) if !options.partial => Err(fault),
        Some(fault) => {
            // The last vertex may be there in part.
            let vertices = whole.records.min(header.vertices);
            whole.coordinates.truncate(vertices as usize * header.dimension);
            whole.elements.polygons.abandon();
            let mut model = model(Header { vertices, ..header }, whole)?;
            model.remarks.insert(0, crate::remark::partial(&fault));
            Ok(model)
        }
        None => model(header, whole),
    }
}

pub(super) fn model(header: Header, whole: Piece) -> Result<Model, Error> {
    let Elements { polygons, lines, points } = whole.elements;
    let (positions, partial_positions) = crate::model::placed(header.dimension, whole.coordinates)?;
    let mut remarks = whole.oddities.into_remarks();
    if whole.surplus > 0 {
        remarks.push(Remark::new(
            RemarkCode::TrailingContent,
            format!("{} lines behind the last face that the header promises are left out", whole.surplus),
        ));
    }
    let model = Model {
        vertex_count: header.vertices as usize,
        positions,
        partial_positions,
        polygons: polygons.into_ragged()?,
        lines: lines.into_ragged()?,
        points,
        remarks,
        ..Model::default()
    };
    debug_assert!(model.check().is_ok(), "the reader has checked what it read");
    Ok(model)
}

/// The number of lines that hold more than blanks and a comment.
fn count_records(text: &[u8]) -> u64 {
    let mut start = 0;
    let mut count = 0;
    for end in memchr::memchr_iter(b'\n', text) {
        let at = skip_blanks(text, start);
        count += u64::from(at < end && text[at] != b'#');
        start = end + 1;
    }
    count
}

fn parse_block(block: &Block, header: Header) -> Piece {
    let mut piece = Piece::default();
    let text = &block.text;
    let mut line = block.line;
    let mut at = 0;
    while at < text.len() {
        let start = skip_blanks(text, at);
        let record = block.record + piece.records;
        if text[start] == b'\n' || text[start] == b'#' {
            at = line_end(text, start);
        } else if record >= header.vertices + header.faces {
            piece.surplus += 1;
            at = line_end(text, start);
        } else {
            let next = if record < header.vertices {
                vertex(text, start, header, (record, line), &mut piece)
            } else {
                face(text, start, header, line, &mut piece)
            };
            match next {
                Ok(next) => at = line_end(text, next),
                Err(error) => {
                    piece.fault = Some(error.at_line(line));
                    return piece;
                }
            }
            piece.records += 1;
        }
        line += 1;
    }
    piece
}

/// The position behind the end of the line that `at` is on.
fn line_end(text: &[u8], at: usize) -> usize {
    if text.get(at) == Some(&b'\n') {
        return at + 1;
    }
    memchr::memchr(b'\n', &text[at..]).map_or(text.len(), |found| at + found + 1)
}

/// The word that starts at `at`; empty at the end of the line or at a comment.
fn word(text: &[u8], at: usize) -> &[u8] {
    let length = text[at..].iter().position(|&byte| is_blank(byte) || byte == b'\n' || byte == b'#');
    &text[at..at + length.unwrap_or(text.len() - at)]
}

/// Reads the coordinates of the vertex with this number, on this line; gives the position behind them.
fn vertex(
    text: &[u8],
    mut at: usize,
    header: Header,
    (number, line): (u64, u64),
    piece: &mut Piece,
) -> Result<usize, Error> {
    for i in 0..header.dimension {
        at = skip_blanks(text, at);
        if let Some((value, next)) = short_decimal(text, at) {
            piece.coordinates.push(value);
            at = next;
            continue;
        }
        let word = word(text, at);
        if word.is_empty() {
            return Err(Error::parse(format!(
                "a vertex with {i} coordinates; it needs {}",
                header.dimension
            ))
            .with_cure("write each vertex on a line of its own with all its coordinates"));
        }
        piece.coordinates.push(parse_coordinate(word, "a coordinate")?);
        at += word.len();
    }
    let first = piece.coordinates.len() - header.dimension;
    piece.oddities.note_unplaced(&piece.coordinates[first..], number, Some(line));
    Ok(at)
}

/// Reads the number of vertices of a face and the vertices; gives the position behind them.
fn face(text: &[u8], at: usize, header: Header, line: u64, piece: &mut Piece) -> Result<usize, Error> {
    let (size, mut at) = natural(text, at, "the number of vertices of a face")?;
    for i in 0..size {
        at = skip_blanks(text, at);
        if text[at] == b'\n' || text[at] == b'#' {
            return Err(Error::parse(format!("a face of {size} vertices names only {i}"))
                .with_cure("write each face on a line of its own"));
        }
        let (vertex, next) = natural(text, at, "a vertex of a face")?;
        piece.elements.polygons.items_mut().push(checked_vertex(vertex, header.vertices)?);
        at = next;
    }
    piece.elements.finish_face(&mut piece.oddities, Place::line(line));
    Ok(at)
}

/// The index if there is such a vertex.
pub(super) fn checked_vertex(vertex: i64, count: u64) -> Result<u32, Error> {
    if u64::try_from(vertex).is_ok_and(|vertex| vertex < count) {
        return Ok(vertex as u32);
    }
    Err(Error::invalid(format!(
        "a face names vertex {vertex}, but there are {count} vertices, numbered from 0"
    ))
    .with_cure("correct the index"))
}

/// The integer that starts at `at`, and the position behind it.
fn natural(text: &[u8], at: usize, what: &str) -> Result<(i64, usize), Error> {
    if let Some((value, next)) = short_natural(text, at)
        && text.get(next).is_none_or(|&byte| byte == b'\n' || is_blank(byte))
    {
        return Ok((i64::from(value), next));
    }
    let word = word(text, at);
    Ok((parse_i64(word, what)?, at + word.len()))
}

/// How a binary file is laid out.
#[derive(Clone, Copy)]
struct Layout {
    /// Whether the highest byte of a number comes first.
    big: bool,
    /// Whether the number of its color components stands behind each face.
    has_colors: bool,
}

impl Layout {
    const OFF: Self = Self { big: true, has_colors: true };
}

fn read_binary<R: Read>(mut input: Scanner<R>, keyword: Keyword, layout: Layout) -> Result<Model, Error> {
    let Layout { big, has_colors } = layout;
    let dimension = if keyword.any_dimension { count(&mut input, big, "the dimension")? } else { 3 };
    let vertices = count(&mut input, big, "the number of vertices")?;
    let faces = count(&mut input, big, "the number of faces")?;
    count(&mut input, big, "the number of edges")?;
    let header =
        header(keyword, dimension, vertices, faces).map_err(|error| error.at_byte(input.byte_offset()))?;
    let mut whole = Piece::default();
    for i in 0..vertices {
        let promised = |error: Error| promise(&error, "vertex", i, vertices);
        for _ in 0..header.dimension {
            let bytes = four(&mut input, big, "a vertex").map_err(promised)?;
            whole.coordinates.push(f64::from(f32::from_be_bytes(bytes)));
        }
        let first = whole.coordinates.len() - header.dimension;
        whole.oddities.note_unplaced(&whole.coordinates[first..], i, None);
        for _ in 0..header.attributes {
            four(&mut input, big, "a vertex").map_err(promised)?;
        }
    }
    for i in 0..faces {
        let promised = |error: Error| promise(&error, "face", i, faces);
        let start = input.byte_offset();
        let size = count(&mut input, big, "the number of vertices of a face").map_err(promised)?;
        for _ in 0..size {
            let vertex = i32::from_be_bytes(four(&mut input, big, "a face").map_err(promised)?);
            let vertex = checked_vertex(i64::from(vertex), vertices).map_err(|error| error.at_byte(start))?;
            whole.elements.polygons.items_mut().push(vertex);
        }
        whole.elements.finish_face(&mut whole.oddities, Place::default());
        if has_colors {
            let colors = count(&mut input, big, "the number of color components").map_err(promised)?;
            for _ in 0..colors {
                four(&mut input, big, "a color").map_err(promised)?;
            }
        }
    }
    if !has_colors && !input.available(1)?.is_empty() {
        return Err(Error::parse("the file goes on behind its last face").at_byte(input.byte_offset()));
    }
    model(header, whole)
}

/// The error, which happened inside this item, with how many of them were promised.
fn promise(error: &Error, what: &str, i: u64, count: u64) -> Error {
    let message = format!("{} ({what} {i} of the {count} that the header promises)", error.message());
    let promised = Error::parse(message).with_cure("correct the count or complete the file");
    match error.byte() {
        Some(byte) => promised.at_byte(byte),
        None => promised,
    }
}

/// The next four bytes, the highest one first.
fn four<R: Read>(input: &mut Scanner<R>, big: bool, what: &str) -> Result<[u8; 4], Error> {
    let mut bytes = [0; 4];
    input.read_exact(&mut bytes, what)?;
    if !big {
        bytes.reverse();
    }
    Ok(bytes)
}

/// A 32-bit integer that is not negative.
fn count<R: Read>(input: &mut Scanner<R>, big: bool, what: &str) -> Result<u64, Error> {
    let value = i32::from_be_bytes(four(input, big, what)?);
    u64::try_from(value).map_err(|_| {
        Error::parse(format!("{what} is {value}; it cannot be negative")).at_byte(input.byte_offset() - 4)
    })
}
