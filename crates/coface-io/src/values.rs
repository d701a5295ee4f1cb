//! Numbers from a stream that is text or binary.

use super::numbers::Numbers;
use super::scanner::{Scanner, parse_f64, parse_i64};
use coface_algebra::Error;
use std::io::Read;

/// How numbers stand in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Encoding {
    /// Decimal, between white space.
    Ascii,
    /// The lowest byte first.
    LittleEndian,
    /// The highest byte first.
    BigEndian,
}

/// The size of a number in a binary file; in text all are alike.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum NumberType {
    Int8,
    UInt8,
    Int16,
    UInt16,
    Int32,
    UInt32,
    Int64,
    UInt64,
    Float32,
    Float64,
}

impl NumberType {
    /// The number of bytes.
    pub(crate) fn size(self) -> usize {
        match self {
            Self::Int8 | Self::UInt8 => 1,
            Self::Int16 | Self::UInt16 => 2,
            Self::Int32 | Self::UInt32 | Self::Float32 => 4,
            Self::Int64 | Self::UInt64 | Self::Float64 => 8,
        }
    }
}

/// A [`Scanner`] that gives numbers whether the file is text or binary, and places faults by line or by byte.
pub(crate) struct Values<R> {
    pub(crate) scanner: Scanner<R>,
    pub(crate) encoding: Encoding,
}

impl<R: Read> Values<R> {
    pub(crate) fn new(scanner: Scanner<R>, encoding: Encoding) -> Self {
        Self { scanner, encoding }
    }

    pub(crate) fn is_ascii(&self) -> bool {
        self.encoding == Encoding::Ascii
    }

    /// The next integer; `what` names it in an error.
    pub(crate) fn integer(&mut self, number: NumberType, what: &str) -> Result<i64, Error> {
        if self.is_ascii() {
            return self.scanner.expect_i64(what);
        }
        let bytes = self.bytes(number, what)?;
        Ok(match number {
            NumberType::Int8 => i64::from(bytes as i8),
            NumberType::Int16 => i64::from(bytes as i16),
            NumberType::Int32 => i64::from(bytes as i32),
            NumberType::UInt8 | NumberType::UInt16 | NumberType::UInt32 => bytes as i64,
            NumberType::Int64 => bytes as i64,
            NumberType::UInt64 => i64::try_from(bytes)
                .map_err(|_| self.located(Error::parse(format!("{what} {bytes} is out of range"))))?,
            NumberType::Float32 => {
                whole(f64::from(f32::from_bits(bytes as u32)), what).map_err(|e| self.located(e))?
            }
            NumberType::Float64 => whole(f64::from_bits(bytes), what).map_err(|e| self.located(e))?,
        })
    }

    /// The next label: an integer, which a text may write as a fraction such as `0.0`; then the second is true.
    pub(crate) fn label(&mut self, number: NumberType, what: &str) -> Result<(i64, bool), Error> {
        if !self.is_ascii() {
            return self.integer(number, what).map(|value| (value, false));
        }
        let token = self.scanner.expect_token(what)?;
        let value = match parse_i64(token, what) {
            Ok(value) => Ok((value, false)),
            Err(fault) => match parse_f64(token, what) {
                Ok(value) if value.fract() == 0.0 && value.abs() < 9e15 => Ok((value as i64, true)),
                _ => Err(fault),
            },
        };
        value.map_err(|fault| self.located(fault))
    }

    /// The next integer, which must not be negative.
    pub(crate) fn count(&mut self, number: NumberType, what: &str) -> Result<u64, Error> {
        let value = self.integer(number, what)?;
        u64::try_from(value).map_err(|_| self.error(format!("{what} is {value}; it cannot be negative")))
    }

    /// The next number as a finite floating-point number.
    ///
    /// # Errors
    /// A parse error with the place of a number that is none or not finite.
    pub(crate) fn float(&mut self, number: NumberType, what: &str) -> Result<f64, Error> {
        if self.is_ascii() {
            return self.scanner.expect_f64(what);
        }
        let value = self.coordinate(number, what)?;
        if value.is_finite() {
            return Ok(value);
        }
        let fault = Error::invalid(format!("{what} is {value}, not a finite number"));
        Err(self.located(fault.with_cure("remove the point or give it finite coordinates")))
    }

    /// The next number as a coordinate, which need not be finite.
    pub(crate) fn coordinate(&mut self, number: NumberType, what: &str) -> Result<f64, Error> {
        if self.is_ascii() {
            return self.scanner.expect_coordinate(what);
        }
        Ok(match number {
            NumberType::Float32 => f64::from(f32::from_bits(self.bytes(number, what)? as u32)),
            NumberType::Float64 => f64::from_bits(self.bytes(number, what)?),
            _ => self.integer(number, what)? as f64,
        })
    }

    /// The line of the text that was read last; `None` in a binary file.
    pub(crate) fn line(&self) -> Option<u64> {
        self.is_ascii().then(|| self.scanner.line_number())
    }

    /// So many numbers as they are, NaN and infinities too; memory grows with what is there.
    pub(crate) fn numbers(&mut self, count: u64, number: NumberType, what: &str) -> Result<Numbers, Error> {
        let mut numbers = match number {
            NumberType::UInt8 => Numbers::UInt8(Vec::new()),
            NumberType::Int8 | NumberType::Int16 | NumberType::UInt16 | NumberType::Int32 => {
                Numbers::Int32(Vec::new())
            }
            NumberType::UInt32 | NumberType::Int64 => Numbers::Int64(Vec::new()),
            NumberType::Float32 => Numbers::Float32(Vec::new()),
            // Integers without sign need not fit in 64 bits with one.
            NumberType::UInt64 | NumberType::Float64 => Numbers::Float64(Vec::new()),
        };
        for _ in 0..count {
            if self.is_ascii() {
                let pushed = numbers.push_word(self.scanner.expect_token(what)?, what);
                pushed.map_err(|fault| fault.at_line(self.scanner.line_number()))?;
                continue;
            }
            match number {
                NumberType::Float32 => {
                    numbers.push_real(f32::from_bits(self.bytes(number, what)? as u32).into());
                }
                NumberType::Float64 => numbers.push_real(f64::from_bits(self.bytes(number, what)?)),
                NumberType::UInt64 => numbers.push_real(self.bytes(number, what)? as f64),
                _ => numbers.push_integer(self.integer(number, what)?),
            }
        }
        Ok(numbers)
    }

    /// The bytes of one number as an integer without sign.
    fn bytes(&mut self, number: NumberType, what: &str) -> Result<u64, Error> {
        let (mut bytes, size) = ([0; 8], number.size());
        if self.encoding == Encoding::BigEndian {
            self.scanner.read_exact(&mut bytes[8 - size..], what)?;
            Ok(u64::from_be_bytes(bytes))
        } else {
            self.scanner.read_exact(&mut bytes[..size], what)?;
            Ok(u64::from_le_bytes(bytes))
        }
    }

    /// Passes over so many numbers of a binary file, or words of a text.
    pub(crate) fn skip(&mut self, count: u64, number: NumberType, what: &str) -> Result<(), Error> {
        if self.is_ascii() {
            for _ in 0..count {
                self.scanner.expect_token(what)?;
            }
            return Ok(());
        }
        self.skip_bytes(count.saturating_mul(number.size() as u64), what)
    }

    /// Passes over so many bytes.
    pub(crate) fn skip_bytes(&mut self, count: u64, what: &str) -> Result<(), Error> {
        let mut bytes = [0; 4096];
        let mut left = count;
        while left > 0 {
            let step = left.min(bytes.len() as u64);
            self.scanner.read_exact(&mut bytes[..step as usize], what)?;
            left -= step;
        }
        Ok(())
    }

    /// Passes over the rest of a line, behind which binary data begin.
    pub(crate) fn end_line(&mut self) -> Result<(), Error> {
        if !self.is_ascii() {
            self.scanner.next_line()?;
        }
        Ok(())
    }

    /// The fault at the number that was given last: by its line, or by the byte behind it.
    pub(crate) fn located(&self, fault: Error) -> Error {
        if self.is_ascii() {
            fault.at_line(self.scanner.line_number())
        } else {
            fault.at_byte(self.scanner.byte_offset())
        }
    }

    /// A fault in the format at the number that was given last.
    pub(crate) fn error(&self, message: impl Into<String>) -> Error {
        self.located(Error::parse(message))
    }
}

fn whole(value: f64, what: &str) -> Result<i64, Error> {
    if value.fract() == 0.0 && value.abs() < 9e15 {
        return Ok(value as i64);
    }
    Err(Error::parse(format!("{what} is {value}, not an integer")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_read_in_every_encoding() {
        let values = |bytes: &'static [u8], encoding| Values::new(Scanner::new(bytes), encoding);
        let mut text = values(b"-7 2.5 x", Encoding::Ascii);
        assert_eq!(text.integer(NumberType::Int8, "a").unwrap(), -7);
        assert_eq!(text.float(NumberType::Int8, "a").unwrap(), 2.5);
        assert!(text.count(NumberType::Int8, "a").is_err());
        let mut little = values(b"\xfe\xff\xfe\xff\0\0\x20\x40\xff", Encoding::LittleEndian);
        assert_eq!(little.integer(NumberType::Int16, "a").unwrap(), -2);
        assert_eq!(little.integer(NumberType::UInt16, "a").unwrap(), 65534);
        assert_eq!(little.float(NumberType::Float32, "a").unwrap(), 2.5);
        assert_eq!(little.count(NumberType::Int8, "a").unwrap_err().byte(), Some(9));
        let mut big = values(b"\0\0\0\0\0\0\x01\x02\x7f\xf0\0\0\0\0\0\0\xff", Encoding::BigEndian);
        assert_eq!(big.integer(NumberType::UInt64, "a").unwrap(), 258);
        assert!(big.float(NumberType::Float64, "a").unwrap_err().to_string().contains("inf"));
        let mut big_again = values(b"\x7f\xc0\0\0\x80\0\xff", Encoding::BigEndian);
        assert!(big_again.numbers(1, NumberType::Float32, "data").unwrap().real(0).is_nan());
        assert_eq!(big_again.numbers(1, NumberType::Int16, "data").unwrap(), Numbers::Int32(vec![-32768]));
        assert!(big_again.numbers(u64::MAX, NumberType::UInt8, "data").unwrap_err().byte().is_some());
        assert!(
            big.skip(u64::MAX, NumberType::Int64, "a block")
                .unwrap_err()
                .to_string()
                .contains("the file ends")
        );
    }
}
