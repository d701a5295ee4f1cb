//! Well-known binary as hexadecimal digits, which databases give for geometries: read within well-known text.
//!
//! Both byte orders, the numbers of ISO (1003 for a polygon with heights) and the flags of EWKB are read; a reference
//! system is passed over, as in text.

use super::drawing::{Drawing, Place};
use super::scanner::Scanner;
use coface_algebra::{Error, ErrorKind};
use std::io::Read;

/// Collections in collections.
const DEEPEST: usize = 64;
const CURE: &str = "write it as well-known text, as in POLYGON ((0 0, 1 0, 0 1, 0 0))";
/// The flags of EWKB.
const HAS_Z: u32 = 1 << 31;
const HAS_M: u32 = 1 << 30;
const HAS_SRID: u32 = 1 << 29;

/// Whether a line begins as binary in digits does: the byte order and a kind of geometry.
pub(super) fn is_digits(line: &[u8]) -> bool {
    let Some(start) = line.get(..10) else { return false };
    let mut bytes = [0; 5];
    for (byte, pair) in bytes.iter_mut().zip(start.chunks(2)) {
        let Some(value) = value_of(pair) else { return false };
        *byte = value;
    }
    let [order, code @ ..] = bytes;
    let code = if order == 0 { u32::from_be_bytes(code) } else { u32::from_le_bytes(code) };
    let rest = line[10..].trim_ascii_end();
    order < 2 && Kind::of(code).is_some() && rest.len() >= 8 && rest.iter().all(u8::is_ascii_hexdigit)
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

/// Reads one geometry into a drawing.
///
/// # Errors
/// [`ErrorKind::Parse`] with the line for digits that are missing or are none, kinds that are none, curves and coordinates
/// that are not finite; [`ErrorKind::TooLarge`] for collections nested deeper than 64.
pub(super) fn read<R: Read>(scanner: &mut Scanner<R>, drawing: &mut Drawing, line: u64) -> Result<(), Error> {
    Reader { scanner, drawing, line, is_big: false }.geometry(0)
}

struct Reader<'a, R> {
    scanner: &'a mut Scanner<R>,
    drawing: &'a mut Drawing,
    line: u64,
    is_big: bool,
}

impl<R: Read> Reader<'_, R> {
    fn fault(&self, message: impl Into<String>) -> Error {
        Error::parse(message).at_line(self.line).with_cure(CURE)
    }

    fn bytes<const N: usize>(&mut self) -> Result<[u8; N], Error> {
        let mut bytes = [0; N];
        let digits = self.scanner.available(2 * N)?;
        let value =
            digits.get(..2 * N).map(|digits| digits.chunks(2).map(value_of).collect::<Option<Vec<u8>>>());
        match value {
            None => return Err(self.fault("the binary geometry ends too early")),
            Some(None) => {
                return Err(self.fault("a binary geometry has a byte that is not two hexadecimal digits"));
            }
            Some(Some(value)) => bytes.copy_from_slice(&value),
        }
        self.scanner.consume(2 * N);
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
            return Err(Error::new(ErrorKind::TooLarge, message)
                .at_line(self.line)
                .with_cure("nest them less"));
        }
        self.is_big = match self.bytes::<1>()? {
            [0] => true,
            [1] => false,
            [order] => return Err(self.fault(format!("{order} is no byte order of a binary geometry"))),
        };
        let code = self.number()?;
        let Some(kind) = Kind::of(code) else {
            return Err(self.fault(format!("{code} is no kind of a binary geometry")));
        };
        if kind.has_srid {
            self.number()?;
        }
        match kind.number {
            1 => {
                if let Some(place) = self.place(kind)? {
                    self.drawing.point(place);
                }
                Ok(())
            }
            2 => self.path(kind, false),
            3 | 17 => {
                self.drawing.begin_polygon();
                for _ in 0..self.number()? {
                    self.path(kind, true)?;
                }
                Ok(())
            }
            4..=7 | 15 | 16 => {
                for _ in 0..self.number()? {
                    let is_big = self.is_big;
                    self.geometry(depth + 1)?;
                    self.is_big = is_big;
                }
                Ok(())
            }
            number => {
                let message = format!("a binary geometry of kind {number} has curved sides");
                Err(self.fault(message).with_cure("write it with straight lines"))
            }
        }
    }

    fn path(&mut self, kind: Kind, is_ring: bool) -> Result<(), Error> {
        for _ in 0..self.number()? {
            match self.place(kind)? {
                Some(place) => self.drawing.corner(place),
                None => return Err(self.fault("a coordinate is not a finite number")),
            }
        }
        let line = self.line;
        if is_ring {
            self.drawing.end_ring(|| format!("a ring of the binary geometry in line {line}"));
        } else {
            self.drawing.end_line(|| format!("a line of the binary geometry in line {line}"));
        }
        Ok(())
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
