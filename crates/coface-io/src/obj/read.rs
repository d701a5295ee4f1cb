//! Reading OBJ.

use super::groups::{Change, Counts, Groups, Statement};
use crate::blocks::{Block, Blocks};
use crate::decimal::{is_blank, short_decimal, short_natural, skip_blanks};
use crate::lists::Elements;
use crate::model::{placed, repeated_vertex};
use crate::numbers::Numbers;
use crate::oddities::{Oddities, Oddity, without_repetition, without_standing_still};
use crate::scanner::{parse_coordinate, parse_f64, parse_i64, quoted};
use crate::{CellData, GroupKind, Model, Place, ReadOptions};
use coface_algebra::{Error, ErrorKind, RaggedArray, VertexId};
use std::borrow::Cow;
use std::io::Read;
use std::sync::Arc;

/// Reads a model in OBJ.
///
/// Polygons belong to a [`Group`](crate::Group) for each name that `g`, `o` or `usemtl` gives them, lines and the vertices of `p` to others of that name. A vertex that a face or
/// line repeats is dropped; what two different vertices are left of is an edge, and what is less is left out. Coordinates that are NaN or infinite are
/// [partial positions](Model::partial_positions). A remark says so, and how many lines that are no statements were passed over.
///
/// # Errors
/// [`ErrorKind::Parse`] or [`ErrorKind::InvalidInput`] with the line: a line of numbers alone, or of words that are no statement
/// in a file without vertices, a number that is none, a face without vertices, index 0 or an index of a vertex that the file lacks; [`ErrorKind::TooLarge`] beyond 2^32 - 1 vertices or 64 names in one `g`; [`ErrorKind::Io`] if the
/// stream fails.
///
/// # Complexity
/// Linear in the file; memory is the model and a few blocks of text.
///
/// # References
/// Wavefront Technologies, *Advanced Visualizer Manual*, appendix B1, "Object files" (1992).
///
/// # Examples
/// ```
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\ng sheet\nf 1/1 2/2 3/3 -1/4\n";
/// let square = coface_io::obj::read(text.as_bytes())?;
/// assert_eq!(square.polygons().list(0), [0, 1, 2, 3]);
/// assert_eq!(square.groups()[0].name(), "sheet");
/// # Ok(()) }
/// ```
pub fn read(input: impl Read) -> Result<Model, Error> {
    read_with(input, &ReadOptions::default())
}

/// The same, up to the first fault if reading is partial.
pub(crate) fn read_with(input: impl Read, options: &ReadOptions) -> Result<Model, Error> {
    let mut coordinates: Vec<f64> = Vec::new();
    let mut elements = Elements::default();
    let mut groups = Groups::default();
    let mut ahead: Vec<(u32, u64)> = Vec::new();
    let mut seen = false;
    let mut foreign = None;
    let mut oddities = Oddities::default();
    let (mut colors, mut passed) = (Vec::new(), Passed::default());
    let parsed = Blocks::new(input).ending_behind(|line| !is_continued(line)).parse(
        count_vertices,
        parse_block,
        |piece| {
            let before = counts(&elements);
            coordinates.extend_from_slice(&piece.coordinates);
            elements.append(&piece.elements)?;
            ahead.extend(piece.ahead);
            seen |= piece.seen;
            foreign = foreign.take().or(piece.foreign);
            oddities.append(piece.oddities);
            colors.extend_from_slice(&piece.colors);
            passed.add(piece.passed);
            for (behind, change) in piece.changes {
                groups.change(change, std::array::from_fn(|kind| before[kind] + behind[kind]));
            }
            piece.fault.map_or(Ok(()), Err)
        },
    );
    let mut fault = match parsed {
        Err(fault) if !options.partial || fault.kind() == ErrorKind::Io => return Err(fault),
        parsed => parsed.err(),
    };
    if !seen {
        return Err(Error::parse("the file is empty")
            .at_line(1)
            .with_cure("an OBJ file has a line \"v x y z\" for each vertex"));
    }
    let vertex_count = coordinates.len() / 3;
    if let Some(foreign) = foreign.filter(|_| vertex_count == 0) {
        return Err(foreign);
    }
    if let Some(&(vertex, line)) = ahead.iter().find(|&&(vertex, _)| vertex as usize >= vertex_count) {
        let missing = out_of_range(i64::from(vertex) + 1, vertex_count as u64).at_line(line);
        if !options.partial {
            return Err(missing);
        }
        fault.get_or_insert(missing);
    }
    let mut groups = groups.finish(counts(&elements), &elements.points);
    let Elements { polygons, lines, points } = elements;
    let (positions, partial_positions) = placed(3, coordinates)?;
    let (mut polygons, mut lines, mut points) = (polygons.into_ragged()?, lines.into_ragged()?, points);
    let mut remarks = oddities.remarks();
    if let Some(fault) = fault {
        // What names vertices that are not there any more goes with them.
        let is_there = |cell: &&[u32]| cell.iter().all(|&vertex| (vertex as usize) < vertex_count);
        let whole = |cells: &RaggedArray| RaggedArray::from_lists(cells.iter().take_while(is_there));
        (polygons, lines) = (whole(&polygons), whole(&lines));
        points.retain(|point| point.index() < vertex_count);
        for group in &mut groups {
            let count = match group.kind {
                GroupKind::Lines => lines.len(),
                GroupKind::Vertices => vertex_count,
                _ => polygons.len(),
            };
            group.members.retain(|&member| (member as usize) < count);
        }
        remarks.insert(0, crate::remark::partial(&fault));
    }
    let mut unread = passed.into_unread();
    let mut data = Vec::new();
    if colors.len() == 3 * vertex_count {
        data.extend(color_data(&colors)?.into_iter().filter(|_| vertex_count > 0));
    } else if !colors.is_empty() {
        unread.push(("colors, which other vertices do not have", colors.len() / 3));
    }
    let model = Model {
        vertex_count,
        data,
        unread,
        oddities: Some(Arc::new(oddities)),
        positions,
        partial_positions,
        polygons,
        lines,
        points,
        groups,
        remarks,
        ..Model::default()
    };
    debug_assert!(model.check().is_ok(), "the reader has checked what it read");
    Ok(model)
}

/// How many elements of each kind there are.
fn counts(elements: &Elements) -> Counts {
    [elements.polygons.len() as u32, elements.lines.len() as u32, elements.points.len() as u32]
}

/// What was read of a block, up to the fault.
#[derive(Default)]
struct Piece {
    coordinates: Vec<f64>,
    elements: Elements,
    /// Changes of names, each with the numbers of elements of this piece before it.
    changes: Vec<(Counts, Change)>,
    /// Vertices that were named before they came, each larger than those before, with the line.
    ahead: Vec<(u32, u64)>,
    /// Whether there was anything but blanks.
    seen: bool,
    oddities: Oddities,
    fault: Option<Error>,
    /// The fault of a file that has nothing but such lines: the first one that is no statement.
    foreign: Option<Error>,
    /// Three numbers for each vertex that has a color.
    colors: Vec<f64>,
    passed: Passed,
}

/// What is passed over.
#[derive(Clone, Copy, Default)]
struct Passed {
    /// Vertices with numbers behind the coordinates that are no color.
    more: usize,
    texture: usize,
    normals: usize,
    libraries: usize,
}

impl Passed {
    fn add(&mut self, other: Self) {
        self.more += other.more;
        self.texture += other.texture;
        self.normals += other.normals;
        self.libraries += other.libraries;
    }

    fn into_unread(self) -> Vec<(&'static str, usize)> {
        let kinds = [
            ("vertices have more numbers behind x y z (v)", self.more),
            ("texture coordinates (vt)", self.texture),
            ("normals (vn)", self.normals),
            ("names of material files (mtllib)", self.libraries),
        ];
        kinds.into_iter().filter(|&(_, count)| count > 0).collect()
    }
}

impl Piece {
    /// Notes the largest of the vertices if it stands further down, if at all; `count` stand before.
    fn look_ahead(&mut self, vertices: &[u32], count: u64, line: u64) {
        for &vertex in vertices {
            if u64::from(vertex) >= count && self.ahead.last().is_none_or(|&(largest, _)| vertex > largest) {
                self.ahead.push((vertex, line));
            }
        }
    }
}

/// The number of vertices that statements in a text give.
fn count_vertices(text: &[u8]) -> u64 {
    let mut count = 0;
    let mut start = 0;
    let mut continued = false;
    for end in memchr::memchr_iter(b'\n', text) {
        let mut at = start;
        if text[at] != b'v' {
            at = skip_blanks(text, at);
        }
        count += u64::from(!continued && text[at] == b'v' && text.get(at + 1).is_some_and(|&b| ends_word(b)));
        continued = is_continued(&text[start..end]);
        start = end + 1;
    }
    count
}

fn ends_word(byte: u8) -> bool {
    byte == b'\n' || byte == b'\\' || is_blank(byte)
}

/// Whether a line, given without its line feed, is joined to the next one.
fn is_continued(line: &[u8]) -> bool {
    matches!(line, [.., b'\\'] | [.., b'\\', b'\r'])
}

fn parse_block(block: &Block) -> Piece {
    let mut piece = Piece::default();
    let text = &block.text;
    let (mut at, mut line) = (0, block.line);
    while at < text.len() {
        let next = match (text[at], text.get(at + 1)) {
            (b'v', Some(b' ')) => plain_vertex(text, at + 2, &mut piece),
            (b'f', Some(b' ')) => plain_face(text, at + 2, block.record, line, &mut piece),
            _ => None,
        };
        if let Some(next) = next {
            at = next;
            line += 1;
            continue;
        }
        let (statement, next, lines) = statement(text, at);
        // Some programs end a file with zero bytes.
        let is_nothing = statement.iter().all(|&byte| byte == 0);
        if !is_nothing && let Err(error) = read_statement(&statement, block.record, line, &mut piece) {
            piece.fault = Some(error.at_line(line));
            break;
        }
        at = next;
        line += lines;
    }
    piece.seen |= piece.elements.polygons.len() > 0 || !piece.coordinates.is_empty();
    piece
}

/// Reads a vertex whose numbers are short; gives the position behind the line, or `None` and changes nothing.
fn plain_vertex(text: &[u8], at: usize, piece: &mut Piece) -> Option<usize> {
    let (x, at) = short_decimal(text, skip_blanks(text, at))?;
    let (y, at) = short_decimal(text, skip_blanks(text, at))?;
    let (z, at) = short_decimal(text, skip_blanks(text, at))?;
    let at = skip_blanks(text, at);
    if text[at] != b'\n' {
        // A color may follow.
        return None;
    }
    let next = at + 1;
    piece.coordinates.extend_from_slice(&[x, y, z]);
    Some(next)
}

/// Reads a face without anything unusual; gives the position behind the line, or `None` and changes nothing.
fn plain_face(text: &[u8], at: usize, before: u64, line: u64, piece: &mut Piece) -> Option<usize> {
    let count = before + piece.coordinates.len() as u64 / 3;
    let next = face_vertices(text, at, count, piece.elements.polygons.items_mut());
    let face = piece.elements.polygons.open();
    let distinct = match *face {
        [a, b, c] => a != b && b != c && c != a,
        _ => face.len() > 3 && repeated_vertex(face).is_none(),
    };
    if next.is_none() || !distinct {
        piece.elements.polygons.abandon();
        return None;
    }
    if face.iter().any(|&vertex| u64::from(vertex) >= count) {
        let face = face.to_vec();
        piece.look_ahead(&face, count, line);
    }
    piece.elements.polygons.finish();
    next
}

/// Pushes the vertices up to the end of the line; gives the position behind it.
fn face_vertices(text: &[u8], mut at: usize, count: u64, vertices: &mut Vec<u32>) -> Option<usize> {
    loop {
        at = skip_blanks(text, at);
        let byte = text[at];
        if byte == b'\n' {
            return Some(at + 1);
        }
        let (number, next) = short_natural(text, at + usize::from(byte == b'-'))?;
        let vertex = if byte == b'-' {
            count.checked_sub(u64::from(number))?
        } else {
            u64::from(number).checked_sub(1)?
        };
        if number == 0 {
            return None;
        }
        vertices.push(vertex as u32);
        at = next;
        if text[at] == b'/' {
            // Texture and normal are read over.
            while matches!(text[at], b'/' | b'-' | b'0'..=b'9') {
                at += 1;
            }
        }
        if text[at] != b'\n' && !is_blank(text[at]) {
            return None;
        }
    }
}

/// The statement at `at` with its continued lines joined, the position behind it and the number of its lines.
fn statement(text: &[u8], at: usize) -> (Cow<'_, [u8]>, usize, u64) {
    let end_from = |at: usize| memchr::memchr(b'\n', &text[at..]).map_or(text.len(), |found| at + found);
    let mut end = end_from(at);
    if !is_continued(&text[at..end]) {
        return (Cow::Borrowed(&text[at..end]), end + 1, 1);
    }
    let mut joined = Vec::new();
    let (mut start, mut lines) = (at, 1);
    while is_continued(&text[start..end]) {
        let line = text[start..end].trim_ascii_end();
        joined.extend_from_slice(&line[..line.len() - 1]);
        joined.push(b' ');
        if end + 1 >= text.len() {
            return (Cow::Owned(joined), text.len(), lines);
        }
        start = end + 1;
        end = end_from(start);
        lines += 1;
    }
    joined.extend_from_slice(&text[start..end]);
    (Cow::Owned(joined), end + 1, lines)
}

/// Reads any statement, or says what is wrong with it.
fn read_statement(statement: &[u8], before: u64, line: u64, piece: &mut Piece) -> Result<(), Error> {
    let statement = statement.trim_ascii();
    if statement.is_empty() {
        return Ok(());
    }
    piece.seen = true;
    if statement[0] == b'#' {
        return Ok(());
    }
    let length = statement.iter().position(|&byte| is_blank(byte)).unwrap_or(statement.len());
    let (keyword, rest) = statement.split_at(length);
    let count = before + piece.coordinates.len() as u64 / 3;
    match keyword {
        b"v" => read_vertex(rest, count, line, piece),
        b"f" => {
            let face = read_vertices(rest, count)?;
            if face.is_empty() {
                return Err(Error::invalid("a face with 0 vertices; it needs 3").with_cure("remove it"));
            }
            piece.look_ahead(&face, count, line);
            let place = || Place::cell(&face).on_line(line);
            let distinct = without_repetition(&face);
            match *distinct.as_slice() {
                [_] => piece.oddities.note(Oddity::Collapsed, place),
                [from, to] => {
                    piece.oddities.note(Oddity::FaceIsEdge, place);
                    piece.elements.lines.push(&[from, to]);
                }
                _ => {
                    if distinct.len() < face.len() {
                        piece.oddities.note(Oddity::Repeated, place);
                    }
                    piece.elements.polygons.push(&distinct);
                }
            }
            Ok(())
        }
        b"l" => {
            let path = read_vertices(rest, count)?;
            if path.is_empty() {
                return Err(Error::invalid("a line with 0 vertices; it needs 2").with_cure("remove it"));
            }
            piece.look_ahead(&path, count, line);
            let place = || Place::cell(&path).on_line(line);
            let moving = without_standing_still(&path);
            if moving.len() < 2 {
                piece.oddities.note(Oddity::Collapsed, place);
                return Ok(());
            }
            if moving.len() < path.len() {
                piece.oddities.note(Oddity::Repeated, place);
            }
            piece.elements.lines.push(&moving);
            Ok(())
        }
        b"p" => {
            let points = read_vertices(rest, count)?;
            if points.is_empty() {
                return Err(Error::invalid("a point statement without a vertex").with_cure("remove it"));
            }
            piece.elements.points.extend(points.iter().map(|&vertex| VertexId::from_u32(vertex)));
            piece.look_ahead(&points, count, line);
            Ok(())
        }
        b"g" => read_names(Statement::Group, rest, piece),
        b"o" => read_names(Statement::Object, rest, piece),
        b"usemtl" => read_names(Statement::Material, rest, piece),
        b"vt" => {
            piece.passed.texture += 1;
            Ok(())
        }
        b"vn" => {
            piece.passed.normals += 1;
            Ok(())
        }
        b"mtllib" => {
            piece.passed.libraries += 1;
            Ok(())
        }
        _ if READ_OVER.contains(&keyword) => Ok(()),
        _ if FREE_FORM.contains(&keyword) => {
            piece.oddities.note(Oddity::FreeForm, || Place::line(line));
            Ok(())
        }
        _ => {
            let error = Error::parse(format!("{} is not an OBJ statement", quoted(keyword)))
                .with_cure("correct the line, or tell the format if this is no OBJ file");
            // Numbers may be the rest of a statement, and a letter in capitals one that is meant: the model would be wrong without them.
            let is_statement = [&b"v"[..], b"vt", b"vn", b"f", b"l", b"p", b"o", b"g"];
            let is_remark = !matches!(keyword[0], b'0'..=b'9' | b'+' | b'-' | b'.')
                && !is_statement.iter().any(|known| known.eq_ignore_ascii_case(keyword))
                && !statement.iter().any(|byte| byte.is_ascii_control() && !byte.is_ascii_whitespace());
            if !is_remark {
                return Err(error);
            }
            piece.oddities.note(Oddity::NoStatement, || Place::line(line));
            piece.foreign.get_or_insert_with(|| error.at_line(line));
            Ok(())
        }
    }
}

/// Statements of how a model looks.
const READ_OVER: [&[u8]; 13] = [
    b"s",
    b"mg",
    b"lod",
    b"bevel",
    b"c_interp",
    b"d_interp",
    b"usemap",
    b"maplib",
    b"shadow_obj",
    b"trace_obj",
    b"ctech",
    b"stech",
    b"usemat",
];

/// Statements of curved geometry, superseded ones among them, and of other files.
const FREE_FORM: [&[u8]; 22] = [
    b"vp", b"cstype", b"deg", b"bmat", b"step", b"curv", b"curv2", b"surf", b"parm", b"trim", b"hole",
    b"scrv", b"sp", b"end", b"con", b"bzp", b"bsp", b"cdc", b"cdp", b"res", b"call", b"csh",
];

fn read_names(statement: Statement, rest: &[u8], piece: &mut Piece) -> Result<(), Error> {
    piece.changes.push((counts(&piece.elements), Change::new(statement, rest)?));
    Ok(())
}

/// The words of a statement up to a comment.
fn words(rest: &[u8]) -> impl Iterator<Item = &[u8]> {
    let end = memchr::memchr(b'#', rest).unwrap_or(rest.len());
    rest[..end].split(|&byte| is_blank(byte)).filter(|word| !word.is_empty())
}

/// Reads the vertex with this number.
fn read_vertex(rest: &[u8], vertex: u64, line: u64, piece: &mut Piece) -> Result<(), Error> {
    let mut words = words(rest);
    let mut point = [0.0; 3];
    for (i, coordinate) in point.iter_mut().enumerate() {
        let Some(word) = words.next() else {
            return Err(Error::parse(format!("a vertex with {i} coordinates; it needs 3"))
                .with_cure("write \"v x y z\""));
        };
        *coordinate = parse_coordinate(word, "a coordinate")?;
    }
    piece.oddities.note_unplaced(&point, vertex, Some(line));
    piece.coordinates.extend_from_slice(&point);
    let mut more = words.map(|word| parse_f64(word, "a color").ok());
    match [more.next(), more.next(), more.next(), more.next()] {
        [None, ..] => {}
        [Some(Some(red)), Some(Some(green)), Some(Some(blue)), None] => {
            piece.colors.extend_from_slice(&[red, green, blue]);
        }
        _ => piece.passed.more += 1,
    }
    Ok(())
}

/// Colors as data on vertices: bytes if all are shares of 255, or bytes themselves.
fn color_data(colors: &[f64]) -> Result<[CellData; 3], Error> {
    // Shares are written with three decimals at least.
    let of_share = |x: f64| (x * 255.0).round();
    let are_shares =
        colors.iter().all(|&x| (0.0..=1.0).contains(&x) && (of_share(x) / 255.0 - x).abs() < 6e-4);
    let are_bytes = !are_shares && colors.iter().all(|&x| (0.0..=255.0).contains(&x) && x.fract() == 0.0);
    let channel = |at: usize, name: &str| {
        let values = colors.iter().skip(at).step_by(3).copied();
        if are_shares || are_bytes {
            let bytes = values.map(|x| if are_shares { of_share(x) as u8 } else { x as u8 }).collect();
            return Ok(CellData::of_file(name.to_owned(), GroupKind::Vertices, 1, Numbers::UInt8(bytes)));
        }
        CellData::reals(name, GroupKind::Vertices, 1, values.collect())
    };
    Ok([channel(0, "red")?, channel(1, "green")?, channel(2, "blue")?])
}

/// The vertices that a statement names, from 0, when `count` vertices stand before it.
fn read_vertices(rest: &[u8], count: u64) -> Result<Vec<u32>, Error> {
    words(rest)
        .map(|word| {
            let length = memchr::memchr(b'/', word).unwrap_or(word.len());
            let index = parse_i64(&word[..length], "a vertex index")?;
            let vertex = match index {
                0 => {
                    return Err(Error::invalid("vertex index 0; they are numbered from 1")
                        .with_cure("correct the index"));
                }
                1.. => index as u64 - 1,
                _ => count.checked_sub(index.unsigned_abs()).ok_or_else(|| out_of_range(index, count))?,
            };
            u32::try_from(vertex).map_err(|_| out_of_range(index, count))
        })
        .collect()
}

fn out_of_range(index: i64, count: u64) -> Error {
    let message = if index < 0 {
        format!("vertex index {index} counts back over the {count} vertices before it")
    } else {
        format!("vertex index {index}, but there are {count} vertices, numbered from 1")
    };
    Error::new(ErrorKind::InvalidInput, message).with_cure("correct the index or add the vertices")
}
