//! From bytes or digits to a model.

use super::{
    ARCS, COLLECTION, COMPOUND, CURVE_POLYGON, HAS_M, HAS_SRID, HAS_Z, LINE, POINT, POLYGON,
    POLYHEDRAL_SURFACE, TIN,
};
use crate::drawing::{Drawing, Place};
use crate::scanner::Scanner;
use crate::{Model, ReferenceSystem};
use coface_algebra::{Error, ErrorKind};
use std::io::Read;

/// Collections in collections.
const DEEPEST: usize = 64;
const CURE: &str = "write it as well-known text, as in POLYGON ((0 0, 1 0, 0 1, 0 0))";

/// Whether a line begins as binary in digits does: the byte order and a kind of geometry.
pub(crate) fn is_digits(line: &[u8]) -> bool {
    let Some(start) = line.get(..10) else { return false };
    let mut bytes = [0; 5];
    for (byte, pair) in bytes.iter_mut().zip(start.chunks(2)) {
        let Some(value) = value_of(pair) else { return false };
        *byte = value;
    }
    let rest = line[10..].trim_ascii_end();
    kind_at(&bytes).is_some() && rest.len() >= 8 && rest.iter().all(u8::is_ascii_hexdigit)
}

/// Whether a file begins as a geometry in bytes does: the byte order, a kind of geometry, and a number of parts that a file can
/// hold.
pub(crate) fn is_binary(start: &[u8]) -> bool {
    let Some(kind) = kind_at(start) else { return false };
    let rest = &start[if kind.has_srid { 9 } else { 5 }.min(start.len())..];
    if kind.number == POINT {
        return rest.len() >= 16;
    }
    let Some(&count) = rest.first_chunk() else { return false };
    let count = if start[0] == 0 { u32::from_be_bytes(count) } else { u32::from_le_bytes(count) };
    count < 1 << 28
}

/// The kind of the geometry that begins here.
fn kind_at(start: &[u8]) -> Option<Kind> {
    let [order, code @ ..] = *start.first_chunk::<5>()?;
    let code = if order == 0 { u32::from_be_bytes(code) } else { u32::from_le_bytes(code) };
    if order < 2 { Kind::of(code) } else { None }
}

/// The byte that two digits are.
fn value_of(pair: &[u8]) -> Option<u8> {
    let digit = |byte: u8| char::from(byte).to_digit(16);
    match *pair {
        [high, low] => u8::try_from(16 * digit(high)? + digit(low)?).ok(),
        _ => None,
    }
}

/// What a geometry is, and the numbers of its positions.
#[derive(Clone, Copy)]
struct Kind {
    number: u32,
    has_z: bool,
    has_m: bool,
    has_srid: bool,
}

impl Kind {
    /// The kind with this code.
    fn of(code: u32) -> Option<Self> {
        let plain = code & 0x1fff_ffff;
        let (number, axes) = (plain % 1000, plain / 1000);
        ((1..=17).contains(&number) && axes < 4).then_some(Self {
            number,
            has_z: code & HAS_Z > 0 || axes % 2 == 1,
            has_m: code & HAS_M > 0 || axes > 1,
            has_srid: code & HAS_SRID > 0,
        })
    }
}

/// Reads a file of geometries in bytes, one after the other. A file that is one collection is read as one feature for each of
/// its parts.
///
/// # Errors
/// [`ErrorKind::Parse`] with the byte for a file that ends too early, a kind of geometry that is none, an arc without an end, coordinates that are not
/// finite, and geometries of different reference systems; [`ErrorKind::TooLarge`] for collections nested deeper than
/// 64 or beyond 2^32 - 2 corners; [`ErrorKind::Io`] if the stream fails.
///
/// # Complexity
/// $O(n \log n)$ for n corners, to find equal ones.
///
/// # References
/// ISO 19125-1 (2004), *Simple feature access*, section 8.
///
/// # Examples
/// ```
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let mut point = vec![1, 1, 0, 0, 0];
/// point.extend([3.0f64, 4.0].map(f64::to_le_bytes).concat());
/// let model = coface_io::wkb::read(&point[..])?;
/// assert_eq!((model.points().len(), model.positions().as_flat()), (1, &[3.0, 4.0][..]));
/// # Ok(()) }
/// ```
pub fn read(input: impl Read) -> Result<Model, Error> {
    read_flattened(input, None)
}

/// Reads geometries as [`read`] does. Arcs of circles become chords that are within a distance of them, 32 for a quarter of a circle if it is
/// `None`, with a remark then.
pub(crate) fn read_flattened(input: impl Read, flatten: Option<f64>) -> Result<Model, Error> {
    let (mut scanner, mut drawing, mut byte) = (Scanner::new(input), Drawing::flattened(flatten), 0);
    loop {
        if scanner.available(1)?.is_empty() {
            if byte == 0 {
                return Err(Error::parse("the file has no geometry").at_byte(0).with_cure(CURE));
            }
            return drawing.finish();
        }
        drawing.begin_feature(None);
        let place = Site::Byte(byte);
        let mut reader = Reader { scanner: &mut scanner, drawing: &mut drawing, place, is_big: false };
        reader.geometry(0)?;
        if let Site::Byte(end) = reader.place {
            byte = end;
        }
    }
}

/// Reads one geometry in digits into a drawing.
///
/// # Errors
/// [`ErrorKind::Parse`] with the line for digits that are missing or are none, kinds that are none, arcs without an end and coordinates
/// that are not finite; [`ErrorKind::TooLarge`] for collections nested deeper than 64.
pub(crate) fn read_digits<R: Read>(
    scanner: &mut Scanner<R>,
    drawing: &mut Drawing,
    line: u64,
) -> Result<(), Error> {
    Reader { scanner, drawing, place: Site::Line(line), is_big: false }.geometry(0)
}

/// Where the reader is: in a line of digits, or at a byte.
#[derive(Clone, Copy)]
enum Site {
    Line(u64),
    Byte(u64),
}

struct Reader<'a, R> {
    scanner: &'a mut Scanner<R>,
    drawing: &'a mut Drawing,
    place: Site,
    is_big: bool,
}

impl<R: Read> Reader<'_, R> {
    fn fault(&self, message: impl Into<String>) -> Error {
        self.located(Error::parse(message)).with_cure(CURE)
    }

    fn located(&self, fault: Error) -> Error {
        match self.place {
            Site::Line(line) => fault.at_line(line),
            Site::Byte(byte) => fault.at_byte(byte),
        }
    }

    fn bytes<const N: usize>(&mut self) -> Result<[u8; N], Error> {
        let mut bytes = [0; N];
        let width = if matches!(self.place, Site::Line(_)) { 2 } else { 1 };
        let Some(given) = self.scanner.available(width * N)?.get(..width * N) else {
            return Err(self.fault("the binary geometry ends too early"));
        };
        if width == 1 {
            bytes.copy_from_slice(given);
        } else {
            for (byte, pair) in bytes.iter_mut().zip(given.chunks_exact(2)) {
                let Some(value) = value_of(pair) else {
                    return Err(self.fault("a binary geometry has a byte that is not two hexadecimal digits"));
                };
                *byte = value;
            }
        }
        self.scanner.consume(width * N);
        if let Site::Byte(byte) = &mut self.place {
            *byte += N as u64;
        }
        if self.is_big {
            bytes.reverse();
        }
        Ok(bytes)
    }

    fn number(&mut self) -> Result<u32, Error> {
        Ok(u32::from_le_bytes(self.bytes()?))
    }

    fn geometry(&mut self, depth: usize) -> Result<(), Error> {
        if depth > DEEPEST {
            let message = format!("collections are nested deeper than {DEEPEST}");
            return Err(self.located(Error::new(ErrorKind::TooLarge, message)).with_cure("nest them less"));
        }
        let start = self.place;
        let kind = self.kind()?;
        let srid = if kind.has_srid { self.number()? } else { 0 };
        if depth == 0 || srid > 0 {
            let system = ReferenceSystem::from_srid(srid);
            self.drawing.set_reference(system).map_err(|fault| self.located(fault))?;
        }
        // A file that is one collection has a feature for each of its parts.
        let has_features = depth == 0 && kind.number == COLLECTION && matches!(start, Site::Byte(0));
        if depth == 0 && matches!(start, Site::Byte(_)) && !has_features {
            self.drawing.begin_geometry();
        }
        match kind.number {
            POINT => {
                if let Some(place) = self.place(kind)? {
                    self.drawing.point(place);
                }
                Ok(())
            }
            LINE | ARCS => {
                self.positions(kind)?;
                self.end(false);
                Ok(())
            }
            COMPOUND => {
                for _ in 0..self.number()? {
                    self.part(true)?;
                }
                self.end(false);
                Ok(())
            }
            POLYGON | 17 => {
                self.drawing.begin_polygon();
                for _ in 0..self.number()? {
                    self.positions(kind)?;
                    self.end(true);
                }
                Ok(())
            }
            CURVE_POLYGON => {
                self.drawing.begin_polygon();
                for _ in 0..self.number()? {
                    self.part(false)?;
                    self.end(true);
                }
                Ok(())
            }
            4..=COLLECTION | 11 | 12 | POLYHEDRAL_SURFACE | TIN => {
                let is_surface = matches!(kind.number, POLYHEDRAL_SURFACE | TIN);
                if is_surface {
                    self.drawing.begin_surface();
                }
                for _ in 0..self.number()? {
                    let is_big = self.is_big;
                    if has_features {
                        self.drawing.begin_geometry();
                    }
                    self.geometry(depth + 1)?;
                    self.is_big = is_big;
                }
                if is_surface {
                    self.drawing.end_surface();
                }
                Ok(())
            }
            number => {
                Err(self
                    .fault(format!("a binary geometry is of kind {number}, which has no shape of its own")))
            }
        }
    }

    /// The byte order and the kind of a geometry.
    fn kind(&mut self) -> Result<Kind, Error> {
        self.is_big = match self.bytes::<1>()? {
            [0] => true,
            [1] => false,
            [order] => return Err(self.fault(format!("{order} is no byte order of a binary geometry"))),
        };
        let code = self.number()?;
        Kind::of(code).ok_or_else(|| self.fault(format!("{code} is no kind of a binary geometry")))
    }

    /// A curve as part of a curve or as a ring, with its own byte order and kind.
    fn part(&mut self, is_nested: bool) -> Result<(), Error> {
        let is_big = self.is_big;
        let kind = self.kind()?;
        if kind.has_srid {
            self.number()?;
        }
        match kind.number {
            LINE | ARCS => self.positions(kind)?,
            // A ring may be compound; what it has is not.
            COMPOUND if !is_nested => {
                for _ in 0..self.number()? {
                    self.part(true)?;
                }
            }
            _ => return Err(self.fault("a curve has a part that is none")),
        }
        self.is_big = is_big;
        Ok(())
    }

    /// The positions of a line, or of one of arcs.
    fn positions(&mut self, kind: Kind) -> Result<(), Error> {
        let count = self.number()?;
        let mut middle = None;
        let mut i = 0;
        while i < count {
            // The positions behind the first, many at a time.
            if i > 0 && kind.number != ARCS {
                i += self.corners_at_hand(kind, count - i)?;
                if i == count {
                    break;
                }
            }
            let Some(place) = self.place(kind)? else {
                return Err(self.fault("a coordinate is not a finite number"));
            };
            if i == 0 {
                self.drawing.begin_part(place).map_err(|fault| self.located(fault))?;
            } else if kind.number != ARCS {
                self.drawing.corner(place);
            } else if let Some(middle) = middle.take() {
                self.drawing.arc(middle, place).map_err(|fault| self.located(fault))?;
            } else {
                middle = Some(place);
            }
            i += 1;
        }
        if middle.is_some() {
            let message =
                format!("a circular string has {count} positions: each arc needs a middle and an end");
            return Err(self.fault(message));
        }
        Ok(())
    }

    /// Adds the positions in bytes that have been read from the stream, at most so many and up to one that is not finite,
    /// and gives their number.
    fn corners_at_hand(&mut self, kind: Kind, most: u32) -> Result<u32, Error> {
        let Site::Byte(byte) = &mut self.place else { return Ok(0) };
        let width = 8 * (2 + usize::from(kind.has_z) + usize::from(kind.has_m));
        let given = self.scanner.available(width)?;
        let is_big = self.is_big;
        let coordinate = |bytes: &[u8; 8]| {
            let bits = if is_big { u64::from_be_bytes(*bytes) } else { u64::from_le_bytes(*bytes) };
            f64::from_bits(bits)
        };
        let mut count = 0;
        for position in given.chunks_exact(width).take(most as usize) {
            let numbers = position.as_chunks::<8>().0;
            let [x, y] = [&numbers[0], &numbers[1]].map(coordinate);
            let z = if kind.has_z { Some(coordinate(&numbers[2])) } else { None };
            if ![x, y, z.unwrap_or(0.0)].iter().all(|number| number.is_finite()) {
                break;
            }
            self.drawing.corner(Place { x, y, z });
            if kind.has_m {
                self.drawing.note_surplus();
            }
            count += 1;
        }
        self.scanner.consume(width * count as usize);
        *byte += (width * count as usize) as u64;
        Ok(count)
    }

    /// Ends a line or a ring.
    fn end(&mut self, is_ring: bool) {
        let place = match self.place {
            Site::Line(line) => format!("of the binary geometry in line {line}"),
            Site::Byte(byte) => format!("that ends at byte {byte}"),
        };
        if is_ring {
            self.drawing.end_ring(|| format!("a ring {place}"));
        } else {
            self.drawing.end_line(|| format!("a line {place}"));
        }
    }

    /// A position; `None` for that of an empty point.
    fn place(&mut self, kind: Kind) -> Result<Option<Place>, Error> {
        let mut coordinate = || Ok::<f64, Error>(f64::from_le_bytes(self.bytes()?));
        let (x, y) = (coordinate()?, coordinate()?);
        let z = if kind.has_z { Some(coordinate()?) } else { None };
        if kind.has_m {
            coordinate()?;
            self.drawing.note_surplus();
        }
        let all = [x, y, z.unwrap_or(0.0)];
        match all.iter().all(|number| number.is_finite()) {
            true => Ok(Some(Place { x, y, z })),
            false if all[..2].iter().all(|number| number.is_nan()) => Ok(None),
            false => Err(self.fault("a coordinate is not a finite number")),
        }
    }
}
