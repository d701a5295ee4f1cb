//! Reading STL.

use super::weld::{Corner, bits, weld};
use crate::blocks::{Block, Blocks};
use crate::decimal::is_blank;
use crate::lists::Lists;
use crate::oddities::{Oddities, Oddity};
use crate::scanner::{Scanner, parse_coordinate, quoted};
use crate::{Group, GroupKind, Model, Place, ReadOptions, Remark, RemarkCode};
use coface_algebra::{Error, ErrorKind};
use std::collections::BTreeMap;
use std::io::Read;

/// The length of the header and the count of a binary file.
const HEADER: usize = 84;
/// The length of a binary triangle: a normal, three corners and two bytes that mean nothing.
const RECORD: usize = 50;
/// How many triangles that are left out are named.
const NAMED: usize = 5;

/// Reads a model in STL, text or binary.
///
/// # Errors
/// [`ErrorKind::Parse`] with the line or the byte: text that is no STL, a number that is none, a
/// facet that is no triangle, fewer triangles than the count promises; [`ErrorKind::TooLarge`] beyond
/// 2^32 - 1 corners; [`ErrorKind::Io`] if the stream fails.
///
/// # Complexity
/// $O(n \log n)$ time for $n$ triangles, for welding by sorting; linear memory, whatever the count claims.
///
/// # References
/// 3D Systems, *StereoLithography Interface Specification* (1988).
///
/// # Examples
/// ```
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let text = "solid two\n\
///     facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n\
///     facet normal 0 0 1\nouter loop\nvertex 0 1 0\nvertex 1 0 0\nvertex 1 1 0\nendloop\nendfacet\nendsolid two\n";
/// let model = coface_io::stl::read(text.as_bytes())?;
/// assert_eq!(model.vertex_count(), 4);
/// assert_eq!(model.polygons().list(1), [2, 1, 3]);
/// # Ok(()) }
/// ```
pub fn read(input: impl Read) -> Result<Model, Error> {
    read_with(input, &ReadOptions::default())
}

pub(crate) fn read_with(input: impl Read, options: &ReadOptions) -> Result<Model, Error> {
    let mut blocks = Blocks::new(input);
    let mut soup = Soup::default();
    let read = if is_text(blocks.peek(1 << 12)?)? {
        read_text(blocks.ending_behind(ends_facet), &mut soup)
    } else {
        read_binary(blocks.into_scanner(), &mut soup)
    };
    if let Err(fault) = read {
        if !options.partial {
            return Err(fault);
        }
        soup.corners.truncate(soup.corners.len() / 3 * 3);
        soup.remarks.push(crate::remark::partial(&fault));
    }
    model(&soup)
}

/// Whether a file that begins like this is text. A text begins with `solid`, but so do the headers of some binary
/// files; those have zero bytes or many control characters, or exactly the length that their count asks for.
fn is_text(head: &[u8]) -> Result<bool, Error> {
    const CURE: &str = "a text file begins with \"solid\", a binary one with 80 bytes and a count";
    if head.is_empty() {
        return Err(Error::parse("the file is empty").at_byte(0).with_cure(CURE));
    }
    // A text may have a stray control character; floating-point numbers have many.
    let controls = head.iter().filter(|&&byte| byte < b' ' && byte != b'\n' && !is_blank(byte)).count();
    let printable = controls * 50 < head.len() && memchr::memchr(0, head).is_none();
    let start = head.trim_ascii_start();
    let solid = start.len() >= 5 && start[..5].eq_ignore_ascii_case(b"solid");
    let fits = head.len() >= HEADER && (head.len() - HEADER) as u64 == promised(head) * RECORD as u64;
    if printable && !solid && !fits {
        let line = start.split(|&byte| byte == b'\n').next().unwrap_or_default();
        return Err(Error::parse(format!("the file begins with {}, not with solid", quoted(line)))
            .at_line(1)
            .with_cure(CURE));
    }
    Ok(printable && solid && !fits)
}

/// The number of triangles that the header of a binary file promises.
fn promised(head: &[u8]) -> u64 {
    u32::from_le_bytes([head[80], head[81], head[82], head[83]]).into()
}

/// Triangles by their corners, and the solids they belong to.
#[derive(Default)]
struct Soup {
    corners: Vec<Corner>,
    /// The names that begin (or, if `None`, end) in front of a triangle.
    solids: Vec<(usize, Option<String>)>,
    /// The lines of corners whose coordinates are not finite, of the first ones in each block of a text.
    unplaced: BTreeMap<usize, u64>,
    remarks: Vec<Remark>,
}

fn read_binary<R: Read>(mut input: Scanner<R>, soup: &mut Soup) -> Result<(), Error> {
    let mut head = [0; HEADER];
    input.read_exact(&mut head, "the header of 84 bytes")?;
    let count = promised(&head);
    let mut read = 0;
    while read < count {
        let base = input.byte_offset();
        let bytes = input.available(RECORD)?;
        let records = (bytes.len() / RECORD).min(usize::try_from(count - read).unwrap_or(usize::MAX));
        if records == 0 {
            return Err(Error::parse(format!(
                "the header promises {count} triangles, but the file ends after {read}"
            ))
            .at_byte(base + bytes.len() as u64)
            .with_cure("complete the file, or correct the count at byte 80"));
        }
        for record in bytes[..records * RECORD].chunks_exact(RECORD) {
            let float =
                |at: usize| f32::from_le_bytes([record[at], record[at + 1], record[at + 2], record[at + 3]]);
            let values: [f32; 9] = std::array::from_fn(|j| float(12 + 4 * j));
            soup.corners.extend(values.chunks_exact(3).map(|xyz| [bits(xyz[0]), bits(xyz[1]), bits(xyz[2])]));
        }
        input.consume(records * RECORD);
        read += records as u64;
        check_count(soup.corners.len())?;
    }
    if !input.available(1)?.is_empty() {
        if count == 0 {
            return Err(Error::parse("the header promises no triangle, but the file goes on")
                .at_byte(HEADER as u64)
                .with_cure("correct the count at byte 80, or tell the format if this is no STL file"));
        }
        soup.remarks.push(Remark::new(
            RemarkCode::TrailingContent,
            format!("the file goes on behind its {count} triangles; that is left out"),
        ));
    }
    Ok(())
}

fn check_count(corners: usize) -> Result<(), Error> {
    if u32::try_from(corners).is_err() {
        return Err(Error::new(ErrorKind::TooLarge, "more than 2^32 - 1 corners of triangles"));
    }
    Ok(())
}

/// Whether a line of text ends a facet; between facets a block may end.
fn ends_facet(line: &[u8]) -> bool {
    let line = line.trim_ascii();
    line.len() >= 8 && line[..8].eq_ignore_ascii_case(b"endfacet")
}

/// What was read of a block, up to the fault.
#[derive(Default)]
struct Piece {
    corners: Vec<Corner>,
    solids: Vec<(usize, Option<String>)>,
    unplaced: Vec<(usize, u64)>,
    /// The number of lines in the file up to the end of this piece, and where its last statement leaves the reader.
    lines: u64,
    state: State,
    oddities: Oddities,
    fault: Option<Error>,
}

/// What the reader is inside of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum State {
    #[default]
    Solid,
    Facet,
    Loop(usize),
    /// The loop of this facet has ended.
    Closed,
}

fn read_text<R: Read>(blocks: Blocks<R>, soup: &mut Soup) -> Result<(), Error> {
    let mut lines = 0;
    let mut state = State::Solid;
    let mut oddities = Oddities::default();
    blocks.parse(
        |_| 0,
        parse_block,
        |piece| {
            let (corner, before) = (soup.corners.len(), soup.corners.len() / 3);
            soup.unplaced.extend(piece.unplaced.iter().map(|&(at, line)| (corner + at, line)));
            soup.corners.extend_from_slice(&piece.corners);
            soup.solids.extend(piece.solids.into_iter().map(|(at, name)| (before + at, name)));
            (lines, state) = (piece.lines, piece.state);
            oddities.append(piece.oddities);
            check_count(soup.corners.len())?;
            piece.fault.map_or(Ok(()), Err)
        },
    )?;
    soup.remarks.extend(oddities.into_remarks());
    let open = soup.solids.last().is_some_and(|(_, name)| name.is_some());
    if state != State::Solid {
        return Err(Error::parse("the file ends where endfacet should be")
            .at_line(lines)
            .with_cure("complete the file"));
    }
    if open {
        soup.remarks.push(Remark::new(RemarkCode::MissingEnd, "the file ends without endsolid"));
    }
    Ok(())
}

fn parse_block(block: &Block) -> Piece {
    let mut piece = Piece { lines: block.line, ..Piece::default() };
    let mut start = 0;
    for end in memchr::memchr_iter(b'\n', &block.text) {
        let line = &block.text[start..end];
        if let Err(error) = read_line(line, &mut piece) {
            piece.fault = Some(error.at_line(piece.lines));
            return piece;
        }
        start = end + 1;
        piece.lines += 1;
    }
    piece.lines -= 1;
    piece
}

fn begins_with_solid(rest: &[u8]) -> bool {
    rest.trim_ascii_start().get(..5).is_some_and(|word| word.eq_ignore_ascii_case(b"solid"))
}

fn read_line(line: &[u8], piece: &mut Piece) -> Result<(), Error> {
    let line = line.trim_ascii();
    let length = line.iter().position(|&byte| is_blank(byte)).unwrap_or(line.len());
    let (keyword, rest) = line.split_at(length);
    let is = |word: &[u8]| keyword.eq_ignore_ascii_case(word);
    match piece.state {
        _ if line.is_empty() => return Ok(()),
        State::Loop(count) if count < 3 && is(b"vertex") => {
            let corner = read_corner(rest)?;
            // Most blocks have none, and the first places are enough.
            if !is_finite(corner) && piece.unplaced.len() < 64 {
                piece.unplaced.push((piece.corners.len(), piece.lines));
            }
            piece.corners.push(corner);
            piece.state = State::Loop(count + 1);
            return Ok(());
        }
        State::Loop(3) if is(b"endloop") => piece.state = State::Closed,
        State::Closed if is(b"endfacet") => piece.state = State::Solid,
        State::Facet if is(b"outer") && rest.trim_ascii().eq_ignore_ascii_case(b"loop") => {
            piece.state = State::Loop(0);
            return Ok(());
        }
        // The normal is not needed: the order of the corners says it, and many files have zeros there.
        State::Solid if is(b"facet") => {
            piece.state = State::Facet;
            return Ok(());
        }
        // Some programs write the end in two words.
        State::Solid if is(b"solid") || is(b"endsolid") || is(b"end") && begins_with_solid(rest) => {
            let name = is(b"solid").then(|| String::from_utf8_lossy(rest).trim().to_owned());
            piece.solids.push((piece.corners.len() / 3, name));
            return Ok(());
        }
        State::Loop(3) if is(b"vertex") => {
            return Err(Error::parse("a facet with more than three vertices")
                .with_cure("cut it into triangles, or use OBJ, PLY or OFF, which have polygons"));
        }
        state => {
            let wanted = match state {
                State::Solid => "solid, facet or endsolid",
                State::Facet => "outer loop",
                State::Loop(3) => "endloop",
                State::Loop(_) => "vertex",
                State::Closed => "endfacet",
            };
            return Err(Error::parse(format!("{} where {wanted} should be", quoted(line)))
                .with_cure("a facet is: facet normal, outer loop, three vertices, endloop, endfacet"));
        }
    }
    if !rest.trim_ascii().is_empty() {
        piece.oddities.note(Oddity::MoreWords, || Place::line(piece.lines));
    }
    Ok(())
}

fn read_corner(rest: &[u8]) -> Result<Corner, Error> {
    let mut words = rest.split(|&byte| is_blank(byte)).filter(|word| !word.is_empty());
    let mut corner = [0; 3];
    for (i, coordinate) in corner.iter_mut().enumerate() {
        let word = words.next().ok_or_else(|| {
            Error::parse(format!("a vertex with {i} coordinates; it needs 3"))
                .with_cure("write \"vertex x y z\"")
        })?;
        *coordinate = match (fast_float2::parse::<f32, _>(word), parse_coordinate(word, "a coordinate")) {
            (Ok(value), _) => bits(value),
            // NaN with more words behind it, as some libraries write it.
            (Err(_), Ok(_)) => bits(f32::NAN),
            (Err(_), Err(error)) => return Err(error.with_cure("write a decimal number")),
        };
    }
    match words.next() {
        Some(word) => Err(Error::parse(format!("{} behind the three coordinates of a vertex", quoted(word)))
            .with_cure("remove it")),
        None => Ok(corner),
    }
}

/// Whether all coordinates of a corner are finite.
fn is_finite(corner: Corner) -> bool {
    corner.iter().all(|&bits| f32::from_bits(bits).is_finite())
}

/// Welds the corners and leaves out the triangles that repeat a vertex.
fn model(soup: &Soup) -> Result<Model, Error> {
    let welded = weld(&soup.corners);
    let coordinates: Vec<f64> = welded
        .first_corners
        .iter()
        .flat_map(|&corner| soup.corners[corner as usize].map(|bits| f64::from(f32::from_bits(bits))))
        .collect();
    let mut oddities = Oddities::default();
    for (vertex, &corner) in welded.first_corners.iter().enumerate() {
        if !is_finite(soup.corners[corner as usize]) {
            let line = soup.unplaced.get(&(corner as usize)).copied();
            oddities.note_unplaced(&coordinates[3 * vertex..3 * vertex + 3], vertex as u64, line);
        }
    }
    let (positions, partial_positions) = crate::model::placed(3, coordinates)?;
    let mut polygons = Lists::default();
    let mut left_out = Vec::new();
    let mut left_out_count = 0u64;
    let mut groups = Solids::default();
    let mut solids = soup.solids.iter().peekable();
    for (i, triangle) in welded.vertices.chunks_exact(3).enumerate() {
        while let Some((_, name)) = solids.next_if(|solid| solid.0 <= i) {
            groups.begin(name.as_deref());
        }
        let [a, b, c] = [triangle[0], triangle[1], triangle[2]];
        if a == b || b == c || c == a {
            left_out_count += 1;
            if left_out.len() < NAMED {
                left_out.push(i.to_string());
            }
            continue;
        }
        groups.add(polygons.len() as u32);
        polygons.push_triangle([a, b, c]);
    }
    solids.for_each(|(_, name)| groups.begin(name.as_deref()));
    let mut remarks = soup.remarks.clone();
    remarks.extend(oddities.into_remarks());
    if left_out_count > 0 {
        let dots = if left_out_count > NAMED as u64 { ", .." } else { "" };
        let (s, verb) = if left_out_count == 1 { ("", "repeats") } else { ("s", "repeat") };
        remarks.push(Remark::new(RemarkCode::CollapsedCell, format!(
            "{left_out_count} triangle{s} {verb} a vertex once equal corners are welded and left out: {}{dots} \
             (counted from 0)",
            left_out.join(", ")
        )));
    }
    let model = Model {
        vertex_count: welded.first_corners.len(),
        positions,
        partial_positions,
        polygons: polygons.into_ragged()?,
        groups: groups.groups(),
        remarks,
        ..Model::default()
    };
    debug_assert!(model.check().is_ok(), "the reader has checked what it read");
    Ok(model)
}

/// The solids with a name while triangles are given to them.
#[derive(Default)]
struct Solids {
    known: BTreeMap<String, usize>,
    groups: Vec<(String, Vec<u32>)>,
    current: Option<usize>,
}

impl Solids {
    /// A solid begins, or the last one ends.
    fn begin(&mut self, name: Option<&str>) {
        self.current = name.filter(|name| !name.is_empty()).map(|name| {
            let next = self.groups.len();
            let group = *self.known.entry(name.to_owned()).or_insert(next);
            if group == next {
                self.groups.push((name.to_owned(), Vec::new()));
            }
            group
        });
    }

    fn add(&mut self, polygon: u32) {
        if let Some(group) = self.current {
            self.groups[group].1.push(polygon);
        }
    }

    fn groups(self) -> Vec<Group> {
        self.groups
            .into_iter()
            .map(|(name, members)| Group::new(name, GroupKind::Polygons, members))
            .collect()
    }
}
