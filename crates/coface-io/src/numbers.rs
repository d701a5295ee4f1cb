//! Arrays of numbers in the width that they have in a file.

use super::decimal::{push_f32, push_f64, push_natural};
use super::scanner::{parse_i64, quoted};
use coface_algebra::Error;
use std::ops::Range;

/// Numbers in the width that they have in a file.
#[derive(Clone, Debug)]
pub(crate) enum Numbers {
    UInt8(Vec<u8>),
    Int32(Vec<i32>),
    Int64(Vec<i64>),
    Float32(Vec<f32>),
    Float64(Vec<f64>),
}

/// Does the same with the vector of whatever type.
macro_rules! with_each {
    ($numbers:expr, $values:ident => $action:expr) => {
        match $numbers {
            Self::UInt8($values) => $action,
            Self::Int32($values) => $action,
            Self::Int64($values) => $action,
            Self::Float32($values) => $action,
            Self::Float64($values) => $action,
        }
    };
}

impl Numbers {
    pub(crate) fn len(&self) -> usize {
        with_each!(self, values => values.len())
    }

    pub(crate) fn is_integral(&self) -> bool {
        matches!(self, Self::UInt8(_) | Self::Int32(_) | Self::Int64(_))
    }

    /// The number at this position if it is an integer.
    pub(crate) fn integer(&self, i: usize) -> Option<i64> {
        match self {
            Self::UInt8(values) => Some(values[i].into()),
            Self::Int32(values) => Some(values[i].into()),
            Self::Int64(values) => Some(values[i]),
            Self::Float32(_) | Self::Float64(_) => None,
        }
    }

    /// The number at this position.
    pub(crate) fn real(&self, i: usize) -> f64 {
        match self {
            Self::UInt8(values) => values[i].into(),
            Self::Int32(values) => values[i].into(),
            Self::Int64(values) => values[i] as f64,
            Self::Float32(values) => values[i].into(),
            Self::Float64(values) => values[i],
        }
    }

    /// Appends an integer that the type holds; to integers of 32 bits or less one that fits.
    pub(crate) fn push_integer(&mut self, value: i64) {
        match self {
            Self::UInt8(values) => match u8::try_from(value) {
                Ok(value) => values.push(value),
                Err(_) => self.widened(value),
            },
            Self::Int32(values) => match i32::try_from(value) {
                Ok(value) => values.push(value),
                Err(_) => self.widened(value),
            },
            Self::Int64(values) => values.push(value),
            Self::Float32(values) => values.push(value as f32),
            Self::Float64(values) => values.push(value as f64),
        }
    }

    /// Appends an integer that does not fit the type: all become integers of 64 bits.
    fn widened(&mut self, value: i64) {
        let integer = |i| self.integer(i).expect("the type is one of integers");
        let mut values: Vec<i64> = (0..self.len()).map(integer).collect();
        values.push(value);
        *self = Self::Int64(values);
    }

    /// Appends a number of a stated type, such as `property uchar red`. A text may have others there than it
    /// says: then all become reals.
    #[inline]
    pub(crate) fn push_real(&mut self, value: f64) {
        match self {
            Self::Float32(values) => values.push(value as f32),
            Self::Float64(values) => values.push(value),
            Self::UInt8(values) if f64::from(value as u8) == value => values.push(value as u8),
            Self::Int32(values) if f64::from(value as i32) == value => values.push(value as i32),
            Self::Int64(values) if value.abs() < 9e15 && value.fract() == 0.0 => values.push(value as i64),
            _ => {
                let mut values: Vec<f64> = (0..self.len()).map(|i| self.real(i)).collect();
                values.push(value);
                *self = Self::Float64(values);
            }
        }
    }

    /// Appends what a word of a text says; `what` names it in an error.
    pub(crate) fn push_word(&mut self, word: &[u8], what: &str) -> Result<(), Error> {
        match self {
            Self::Float32(values) => match fast_float2::parse::<f32, _>(word) {
                Ok(value) => values.push(value),
                Err(_) => return Err(no_number(word, what)),
            },
            Self::Float64(values) => match fast_float2::parse::<f64, _>(word) {
                Ok(value) => values.push(value),
                Err(_) => return Err(no_number(word, what)),
            },
            _ => match parse_i64(word, what) {
                Ok(value) => self.push_integer(value),
                Err(_) => match fast_float2::parse::<f64, _>(word) {
                    Ok(value) => self.push_real(value),
                    Err(_) => return Err(no_number(word, what)),
                },
            },
        }
        Ok(())
    }

    /// Appends the decimal number at this position to a text, the shortest that reads back as the same.
    pub(crate) fn write_word(&self, i: usize, text: &mut Vec<u8>) {
        match self {
            Self::UInt8(values) => push_natural(text, values[i].into()),
            Self::Int32(_) | Self::Int64(_) => {
                let value = self.integer(i).unwrap_or_default();
                if value < 0 {
                    text.push(b'-');
                }
                push_natural(text, value.unsigned_abs());
            }
            Self::Float32(values) => push_f32(text, values[i]),
            Self::Float64(values) => push_f64(text, values[i]),
        }
    }

    /// Appends the bytes of the number at this position, the least significant one first unless `big`.
    pub(crate) fn write_bytes(&self, i: usize, big: bool, bytes: &mut Vec<u8>) {
        let start = bytes.len();
        with_each!(self, values => bytes.extend_from_slice(&values[i].to_le_bytes()));
        if big {
            bytes[start..].reverse();
        }
    }

    /// None yet, of the same type.
    pub(crate) fn of_same_type(&self) -> Self {
        match self {
            Self::UInt8(_) => Self::UInt8(Vec::new()),
            Self::Int32(_) => Self::Int32(Vec::new()),
            Self::Int64(_) => Self::Int64(Vec::new()),
            Self::Float32(_) => Self::Float32(Vec::new()),
            Self::Float64(_) => Self::Float64(Vec::new()),
        }
    }

    /// Appends a part of others; the type is kept if they have the same.
    pub(crate) fn extend(&mut self, others: &Self, part: Range<usize>) {
        match (&mut *self, others) {
            (Self::UInt8(values), Self::UInt8(others)) => values.extend_from_slice(&others[part]),
            (Self::Int32(values), Self::Int32(others)) => values.extend_from_slice(&others[part]),
            (Self::Int64(values), Self::Int64(others)) => values.extend_from_slice(&others[part]),
            (Self::Float32(values), Self::Float32(others)) => values.extend_from_slice(&others[part]),
            (Self::Float64(values), Self::Float64(others)) => values.extend_from_slice(&others[part]),
            _ => {
                for i in part {
                    match others.integer(i) {
                        Some(value) => self.push_integer(value),
                        None => self.push_real(others.real(i)),
                    }
                }
            }
        }
    }

    /// Appends zeros.
    pub(crate) fn extend_zeros(&mut self, count: usize) {
        with_each!(self, values => values.resize(values.len() + count, Default::default()));
    }

    /// Puts zeros in front.
    pub(crate) fn prepend_zeros(&mut self, count: usize) {
        if count > 0 {
            let mut numbers = self.of_same_type();
            numbers.extend_zeros(count);
            numbers.extend(self, 0..self.len());
            *self = numbers;
        }
    }

    pub(crate) fn truncate(&mut self, length: usize) {
        with_each!(self, values => values.truncate(length));
    }

    /// The type that holds these and those: the same, or the widest of integers or of reals.
    pub(crate) fn common_type(&self, other: &Self) -> Self {
        if std::mem::discriminant(self) == std::mem::discriminant(other) {
            self.of_same_type()
        } else if self.is_integral() && other.is_integral() {
            Self::Int64(Vec::new())
        } else {
            Self::Float64(Vec::new())
        }
    }
}

fn no_number(word: &[u8], what: &str) -> Error {
    Error::parse(format!("{} is not a number, as {what} must be", quoted(word)))
        .with_cure("correct it, or remove the data")
}

impl PartialEq for Numbers {
    fn eq(&self, other: &Self) -> bool {
        let same = |i: usize| match (self.integer(i), other.integer(i)) {
            (Some(a), Some(b)) => a == b,
            _ => {
                let (a, b) = (self.real(i), other.real(i));
                a == b || (a.is_nan() && b.is_nan())
            }
        };
        self.is_integral() == other.is_integral() && self.len() == other.len() && (0..self.len()).all(same)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn numbers_that_do_not_fit_widen() {
        let mut bytes = Numbers::UInt8(vec![7]);
        bytes.push_real(255.0);
        assert!(matches!(bytes, Numbers::UInt8(_)));
        bytes.push_integer(-1);
        assert_eq!(bytes, Numbers::Int64(vec![7, 255, -1]));
        bytes.push_real(0.5);
        assert_eq!(bytes, Numbers::Float64(vec![7.0, 255.0, -1.0, 0.5]));
        let mut integers = Numbers::Int32(vec![]);
        integers.push_real(f64::NAN);
        assert_eq!(integers, Numbers::Float32(vec![f32::NAN]));
        assert_ne!(Numbers::Int32(vec![1]), Numbers::Float32(vec![1.0]));
        assert_eq!(Numbers::Int32(vec![1]), Numbers::UInt8(vec![1]));
    }

    #[test]
    fn parts_and_zeros_keep_the_type() {
        let mut numbers = Numbers::Float32(vec![1.0, 2.0, 3.0]);
        let others = numbers.clone();
        numbers.extend(&others, 1..3);
        numbers.truncate(4);
        numbers.prepend_zeros(1);
        numbers.extend_zeros(1);
        assert!(matches!(&numbers, Numbers::Float32(v) if *v == [0.0, 1.0, 2.0, 3.0, 2.0, 0.0]));
        let common = Numbers::UInt8(vec![1]).common_type(&Numbers::Int32(vec![]));
        assert!(matches!(common, Numbers::Int64(_)));
    }

    proptest! {
        #[test]
        fn words_and_bytes_read_back(a: u8, b: i32, c: i64, d: f32, e: f64) {
            let all = [
                Numbers::UInt8(vec![a]),
                Numbers::Int32(vec![b]),
                Numbers::Int64(vec![c]),
                Numbers::Float32(vec![d]),
                Numbers::Float64(vec![e]),
            ];
            for numbers in all {
                let (mut text, mut read) = (Vec::new(), numbers.of_same_type());
                numbers.write_word(0, &mut text);
                read.push_word(&text, "a number").unwrap();
                prop_assert_eq!(&read, &numbers);
                prop_assert_eq!(std::mem::discriminant(&read), std::mem::discriminant(&numbers));
                let (mut little, mut big) = (Vec::new(), Vec::new());
                numbers.write_bytes(0, false, &mut little);
                numbers.write_bytes(0, true, &mut big);
                big.reverse();
                prop_assert_eq!(little, big);
            }
        }
    }

    #[test]
    fn words_that_are_no_numbers_are_refused() {
        let mut numbers = Numbers::UInt8(vec![]);
        assert!(numbers.push_word(b"red", "a color").unwrap_err().to_string().contains("as a color must be"));
        for word in [&b"1"[..], b"300", b"-inf"] {
            numbers.push_word(word, "a color").unwrap();
        }
        assert_eq!(numbers, Numbers::Float64(vec![1.0, 300.0, f64::NEG_INFINITY]));
    }
}
