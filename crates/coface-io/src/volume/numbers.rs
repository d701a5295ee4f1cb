//! The types of numbers in volume files.

use super::rule::VoxelRule;
use coface_algebra::Error;
use std::cell::Cell;
use std::io::Read;

/// A type of numbers, as they lie in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum NumberType {
    /// A byte; all but 0 are 1.
    Bool,
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    I64,
    U64,
    F16,
    F32,
    F64,
}

impl NumberType {
    /// The bytes of a number.
    pub(super) fn size(self) -> usize {
        match self {
            Self::Bool | Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 | Self::F16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::I64 | Self::U64 | Self::F64 => 8,
        }
    }

    /// Whether each number is a floating point number of 32 bits.
    pub(super) fn is_single(self) -> bool {
        self.size() < 4 || self == Self::F32
    }

    /// The range of integers; `None` for floating point numbers.
    fn range(self) -> Option<(i128, i128)> {
        Some(match self {
            Self::Bool => (0, 1),
            Self::I8 => (i8::MIN.into(), i8::MAX.into()),
            Self::U8 => (0, u8::MAX.into()),
            Self::I16 => (i16::MIN.into(), i16::MAX.into()),
            Self::U16 => (0, u16::MAX.into()),
            Self::I32 => (i32::MIN.into(), i32::MAX.into()),
            Self::U32 => (0, u32::MAX.into()),
            Self::I64 => (i64::MIN.into(), i64::MAX.into()),
            Self::U64 => (0, u64::MAX.into()),
            Self::F16 | Self::F32 | Self::F64 => return None,
        })
    }
}

/// What becomes of the numbers of a file.
pub(super) trait Decode {
    type Item;

    /// Decodes numbers; the bytes are those of whole numbers.
    fn of_bytes(&self, bytes: &[u8], is_big_endian: bool, out: &mut Vec<Self::Item>);

    /// Decodes a number as text.
    ///
    /// # Errors
    /// [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) for what is no number of the type.
    fn of_word(&self, word: &str) -> Result<Self::Item, Error>;
}

/// What is asked of the numbers of a file.
#[derive(Clone, Copy, Debug)]
pub(super) struct Test {
    rule: VoxelRule,
    integers: Option<(i128, i128)>,
    /// Factor and summand that make of a number of the file the one that is meant.
    scale: Option<(f64, f64)>,
    number_type: NumberType,
}

impl Test {
    pub(super) fn new(rule: VoxelRule, number_type: NumberType, scale: Option<(f64, f64)>) -> Self {
        let nearest = match (rule, number_type, scale) {
            (VoxelRule::Equal(value), NumberType::F32, None) => VoxelRule::Equal(f64::from(value as f32)),
            (VoxelRule::Equal(value), NumberType::F16, None) => VoxelRule::Equal(nearest_half(value)),
            _ => rule,
        };
        Self { rule: nearest, integers: rule.integers(), scale, number_type }
    }

    #[inline]
    fn integer(&self, number: i128) -> bool {
        match (self.scale, self.integers) {
            (Some((factor, summand)), _) => self.rule.holds(factor * number as f64 + summand),
            (None, Some((first, last))) => first <= number && number <= last,
            (None, None) => number != 0,
        }
    }

    #[inline]
    fn real(&self, number: f64) -> bool {
        match self.scale {
            Some((factor, summand)) => self.rule.holds(factor * number + summand),
            None => self.rule.holds(number),
        }
    }
}

/// Calls with each number of some bytes.
macro_rules! each_number {
    ($number_type:expr, $bytes:expr, $is_big_endian:expr, $out:expr, $integer:expr, $real:expr) => {{
        macro_rules! each {
            ($number:ty, $item:expr) => {{
                const SIZE: usize = size_of::<$number>();
                let numbers = $bytes.chunks_exact(SIZE).map(|bytes| {
                    let bytes: [u8; SIZE] = bytes.try_into().expect("chunks have the size of a number");
                    if $is_big_endian {
                        <$number>::from_be_bytes(bytes)
                    } else {
                        <$number>::from_le_bytes(bytes)
                    }
                });
                $out.extend(numbers.map($item));
            }};
        }
        let (integer, real) = ($integer, $real);
        match $number_type {
            NumberType::Bool => each!(u8, |x| integer(i128::from(x != 0))),
            NumberType::I8 => each!(i8, |x| integer(x.into())),
            NumberType::U8 => each!(u8, |x| integer(x.into())),
            NumberType::I16 => each!(i16, |x| integer(x.into())),
            NumberType::U16 => each!(u16, |x| integer(x.into())),
            NumberType::I32 => each!(i32, |x| integer(x.into())),
            NumberType::U32 => each!(u32, |x| integer(x.into())),
            NumberType::I64 => each!(i64, |x| integer(x.into())),
            NumberType::U64 => each!(u64, |x| integer(x.into())),
            NumberType::F16 => each!(u16, |x| real(half(x))),
            NumberType::F32 => each!(f32, |x| real(x.into())),
            NumberType::F64 => each!(f64, |x| real(x)),
        }
    }};
}

/// A word as a number of a type.
enum Number {
    Integer(i128),
    Real(f64),
}

impl Number {
    /// # Errors
    /// [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) for what is no number of the type.
    fn of_word(word: &str, number_type: NumberType) -> Result<Self, Error> {
        let fault = || {
            let what = if number_type.range().is_some() { "integer of the file's type" } else { "number" };
            Error::parse(format!("\"{}\" is no {what}", word.escape_debug()))
                .with_cure("write numbers with white space between them")
        };
        match number_type.range() {
            Some((least, most)) => {
                let number: i128 = word.parse().map_err(|_| fault())?;
                if number < least || most < number {
                    return Err(fault());
                }
                Ok(Self::Integer(number))
            }
            None if number_type == NumberType::F32 => {
                Ok(Self::Real(word.parse::<f32>().map_err(|_| fault())?.into()))
            }
            None => Ok(Self::Real(word.parse().map_err(|_| fault())?)),
        }
    }
}

impl Decode for Test {
    type Item = bool;

    /// Says of each number whether it sets its voxel.
    fn of_bytes(&self, bytes: &[u8], is_big_endian: bool, is_set: &mut Vec<bool>) {
        each_number!(self.number_type, bytes, is_big_endian, is_set, |x: i128| self.integer(x), |x: f64| {
            self.real(x)
        });
    }

    fn of_word(&self, word: &str) -> Result<bool, Error> {
        Ok(match Number::of_word(word, self.number_type)? {
            Number::Integer(number) => self.integer(number),
            Number::Real(number) => self.real(number),
        })
    }
}

/// The numbers themselves.
#[derive(Debug)]
pub(super) struct Values {
    pub(super) number_type: NumberType,
    /// Factor and summand that make of a number of the file the one that is meant.
    pub(super) scale: Option<(f64, f64)>,
    /// How many integers have no double.
    pub(super) rounded: Cell<u64>,
}

impl Values {
    /// The number nearest to an integer; one that is not equal is counted.
    #[inline]
    fn nearest(&self, integer: i128) -> f64 {
        let number = integer as f64;
        if number as i128 != integer {
            self.rounded.set(self.rounded.get() + 1);
        }
        number
    }

    #[inline]
    fn meant(&self, number: f64) -> f64 {
        self.scale.map_or(number, |(factor, summand)| factor * number + summand)
    }
}

impl Decode for Values {
    type Item = f64;

    fn of_bytes(&self, bytes: &[u8], is_big_endian: bool, out: &mut Vec<f64>) {
        each_number!(
            self.number_type,
            bytes,
            is_big_endian,
            out,
            |x: i128| self.meant(self.nearest(x)),
            |x: f64| self.meant(x)
        );
    }

    fn of_word(&self, word: &str) -> Result<f64, Error> {
        Ok(self.meant(match Number::of_word(word, self.number_type)? {
            Number::Integer(number) => self.nearest(number),
            Number::Real(number) => number,
        }))
    }
}

/// A floating point number of 16 bits.
fn half(bits: u16) -> f64 {
    let sign = if bits >> 15 == 1 { -1.0 } else { 1.0 };
    let fraction = f64::from(bits & 0x3ff);
    match (bits >> 10) & 0x1f {
        0 => sign * fraction * 2f64.powi(-24),
        31 if fraction == 0.0 => sign * f64::INFINITY,
        31 => f64::NAN,
        exponent => sign * (1024.0 + fraction) * 2f64.powi(i32::from(exponent) - 25),
    }
}

/// The floating point number of 16 bits that is next to a number, and of two the even one.
fn nearest_half(number: f64) -> f64 {
    if !number.is_finite() {
        return number;
    }
    let exponent = if number == 0.0 { -14 } else { (number.abs().log2().floor() as i32).max(-14) };
    let unit = 2f64.powi(exponent - 10);
    let rounded = (number / unit).round_ties_even() * unit;
    if rounded.abs() > 65504.0 { rounded.signum() * f64::INFINITY } else { rounded }
}

/// Words of a text, as they come.
pub(super) struct Words<R> {
    input: R,
    buffer: Vec<u8>,
    at: usize,
    word: String,
}

/// No number is as long as this.
const LONGEST_WORD: usize = 400;

impl<R: Read> Words<R> {
    pub(super) fn new(input: R) -> Self {
        Self { input, buffer: Vec::new(), at: 0, word: String::new() }
    }

    fn byte(&mut self) -> Result<Option<u8>, Error> {
        if self.at == self.buffer.len() {
            self.buffer.resize(1 << 16, 0);
            let count = loop {
                match self.input.read(&mut self.buffer) {
                    Err(error) if error.kind() == std::io::ErrorKind::Interrupted => {}
                    count => break count?,
                }
            };
            self.buffer.truncate(count);
            self.at = 0;
        }
        let byte = self.buffer.get(self.at).copied();
        self.at += usize::from(byte.is_some());
        Ok(byte)
    }

    /// The next word; `None` at the end.
    ///
    /// # Errors
    /// Where the stream cannot be read; [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) for a word that is too long for a number.
    pub(super) fn next(&mut self) -> Result<Option<&str>, Error> {
        self.word.clear();
        while let Some(byte) = self.byte()? {
            if byte.is_ascii_whitespace() || byte == b',' {
                if !self.word.is_empty() {
                    break;
                }
                continue;
            }
            self.word.push(char::from(byte));
            if self.word.len() > LONGEST_WORD {
                return Err(Error::parse("a word is too long to be a number")
                    .with_cure("check the encoding that the header names"));
            }
        }
        Ok((!self.word.is_empty()).then_some(&self.word[..]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn halves_are_exact() {
        for (bits, number) in [
            (0, 0.0),
            (1, 2f64.powi(-24)),
            (0x3c00, 1.0),
            (0xc000, -2.0),
            (0x7bff, 65504.0),
            (0x3555, 0.333251953125),
        ] {
            assert_eq!(half(bits), number);
            assert_eq!(nearest_half(number), number);
        }
        assert!(half(0x7e00).is_nan() && half(0xfc00) == f64::NEG_INFINITY);
        assert_eq!(nearest_half(1.0 / 3.0), half(0x3555));
        assert_eq!(nearest_half(1e9), f64::INFINITY);
        // All of them, in order.
        let all: Vec<f64> = (0..0x7c00).map(half).collect();
        assert!(all.is_sorted_by(|a, b| a < b));
        assert!(all.iter().all(|&x| nearest_half(x) == x && nearest_half(-x) == -x));
    }

    #[test]
    fn wide_integers_are_compared_exactly() {
        let test = |rule| Test::new(rule, NumberType::I64, None);
        let big = (1i64 << 53) + 1;
        let holds = |test: Test, number: i64| {
            let mut out = Vec::new();
            test.of_bytes(&number.to_be_bytes(), true, &mut out);
            assert_eq!(test.of_word(&number.to_string()).unwrap(), out[0]);
            out[0]
        };
        let bound = (1i64 << 53) as f64;
        assert!(holds(test(VoxelRule::AtLeast(bound)), big) && !holds(test(VoxelRule::Equal(bound)), big));
        assert!(!holds(test(VoxelRule::Between(0.0, bound)), big));
        assert!(holds(test(VoxelRule::Below(0.5)), 0) && !holds(test(VoxelRule::Below(0.0)), 0));
        assert!(!holds(test(VoxelRule::AtLeast(0.5)), 0) && holds(test(VoxelRule::AtLeast(-0.5)), 0));
        assert!(holds(test(VoxelRule::AtLeast(f64::NEG_INFINITY)), i64::MIN));
        assert!(!holds(test(VoxelRule::Equal(0.5)), 0) && !holds(test(VoxelRule::Nonzero), 0));
    }
}
