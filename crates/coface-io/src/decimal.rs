//! Short decimal numbers at the speed of the text, exactly rounded.
//!
//! A number with at most 19 digits, a mantissa of at most 53 bits and a decimal exponent of at most 22 in absolute value
//! is the quotient or product of two numbers that `f64` holds exactly, so one rounded operation gives the nearest
//! `f64`: W. D. Clinger, *How to read floating point numbers accurately* (1990). Whatever is not of this kind is left to
//! the full parser.

use coface_algebra::Error;
use std::io::Write;

/// The powers of ten that `f64` holds exactly.
const POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18,
    1e19, 1e20, 1e21, 1e22,
];

/// Whether a byte separates words within a line.
pub(crate) fn is_blank(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | b'\r' | b'\x0c')
}

/// The position of the first byte from `at` on that is no blank.
pub(crate) fn skip_blanks(text: &[u8], mut at: usize) -> usize {
    while at < text.len() && is_blank(text[at]) {
        at += 1;
    }
    at
}

/// The number that starts at `at` and the position behind it; `None` unless it is short and ends at a blank, a line end
/// or the end of the text.
pub(crate) fn short_decimal(text: &[u8], at: usize) -> Option<(f64, usize)> {
    let mut at = at;
    let negative = match text.get(at)? {
        b'-' => {
            at += 1;
            true
        }
        b'+' => {
            at += 1;
            false
        }
        _ => false,
    };
    let (mut mantissa, next) = digits(text, at, 0);
    let mut digit_count = next - at;
    at = next;
    let mut exponent = 0;
    if text.get(at) == Some(&b'.') {
        at += 1;
        let (with_fraction, next) = digits(text, at, mantissa);
        mantissa = with_fraction;
        exponent = at as i64 - next as i64;
        digit_count += next - at;
        at = next;
    }
    if digit_count == 0 || digit_count > 19 || mantissa > 1 << 53 {
        return None;
    }
    if matches!(text.get(at), Some(b'e' | b'E')) {
        let (sign, start) = match text.get(at + 1) {
            Some(b'-') => (-1, at + 2),
            Some(b'+') => (1, at + 2),
            _ => (1, at + 1),
        };
        let (value, next) = digits(text, start, 0);
        if next == start || next > start + 4 {
            return None;
        }
        exponent += sign * value as i64;
        at = next;
    }
    if text.get(at).is_some_and(|&byte| byte != b'\n' && !is_blank(byte)) {
        return None;
    }
    let power = *POWERS.get(exponent.unsigned_abs() as usize)?;
    let value = if exponent < 0 { mantissa as f64 / power } else { mantissa as f64 * power };
    Some((if negative { -value } else { value }, at))
}

/// The digits from `at` on, appended to `value` (wrapping), and the position behind them.
fn digits(text: &[u8], mut at: usize, mut value: u64) -> (u64, usize) {
    while let Some(eight) = text.get(at..at + 8).and_then(|bytes| <[u8; 8]>::try_from(bytes).ok()) {
        let Some(number) = eight_digits(u64::from_le_bytes(eight)) else { break };
        value = value.wrapping_mul(100_000_000).wrapping_add(number);
        at += 8;
    }
    while let Some(digit) = text.get(at).map(|byte| byte.wrapping_sub(b'0')).filter(|&digit| digit < 10) {
        value = value.wrapping_mul(10).wrapping_add(u64::from(digit));
        at += 1;
    }
    (value, at)
}

/// The number that eight ASCII digits spell, the first in the lowest byte; `None` if one is no digit.
fn eight_digits(bytes: u64) -> Option<u64> {
    // A byte is a digit if its high half is 3, and still is after 6 is added.
    let high = bytes & 0xf0f0_f0f0_f0f0_f0f0;
    let raised = bytes.wrapping_add(0x0606_0606_0606_0606) & 0xf0f0_f0f0_f0f0_f0f0;
    if high != 0x3030_3030_3030_3030 || raised != high {
        return None;
    }
    // Neighbors are joined to numbers of two, four, eight digits.
    let ones = bytes & 0x0f0f_0f0f_0f0f_0f0f;
    let pairs = (ones.wrapping_mul(10) + (ones >> 8)) & 0x00ff_00ff_00ff_00ff;
    let fours = (pairs.wrapping_mul(100) + (pairs >> 16)) & 0x0000_ffff_0000_ffff;
    Some((fours.wrapping_mul(10_000) + (fours >> 32)) & 0xffff_ffff)
}

/// The natural number of at most nine digits that starts at `at`, and the position behind its digits.
pub(crate) fn short_natural(text: &[u8], at: usize) -> Option<(u32, usize)> {
    let mut value = 0u32;
    let mut next = at;
    while let Some(digit) = text.get(next).map(|byte| byte.wrapping_sub(b'0')).filter(|&digit| digit < 10) {
        value = value.wrapping_mul(10).wrapping_add(u32::from(digit));
        next += 1;
    }
    (next > at && next <= at + 9).then_some((value, next))
}

/// Appends the shortest decimal number that reads back as the same `f64`.
pub(crate) fn push_f64(text: &mut Vec<u8>, value: f64) {
    let size = value.abs();
    let written = if size == 0.0 || (1e-5..1e16).contains(&size) {
        write!(text, "{value}")
    } else {
        write!(text, "{value:e}")
    };
    written.expect("writing to memory does not fail");
}

/// Appends the shortest decimal number that reads back as the same `f32`.
pub(crate) fn push_f32(text: &mut Vec<u8>, value: f32) {
    let size = value.abs();
    let written = if size == 0.0 || (1e-5..1e8).contains(&size) {
        write!(text, "{value}")
    } else {
        write!(text, "{value:e}")
    };
    written.expect("writing to memory does not fail");
}

/// Appends a natural number.
pub(crate) fn push_natural(text: &mut Vec<u8>, value: u64) {
    let mut digits = [0; 20];
    let mut at = digits.len();
    let mut rest = value;
    loop {
        at -= 1;
        digits[at] = b'0' + (rest % 10) as u8;
        rest /= 10;
        if rest == 0 {
            break;
        }
    }
    text.extend_from_slice(&digits[at..]);
}

/// Hands the text on when there is a block of it.
pub(crate) fn flush(text: &mut Vec<u8>, output: &mut impl Write) -> Result<(), Error> {
    if text.len() >= 1 << 16 {
        output.write_all(text)?;
        text.clear();
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn only_short_plain_numbers_are_taken() {
        let value = |text: &str| short_decimal(text.as_bytes(), 0).map(|(value, _)| value);
        assert_eq!(value("0.1"), Some(0.1));
        assert_eq!(value("-12345678.25e-3"), Some(-12345.67825));
        assert_eq!(value("1.\n"), Some(1.0));
        assert_eq!(value(".5 "), Some(0.5));
        assert_eq!(value("-0").map(f64::to_bits), Some((-0.0f64).to_bits()));
        for left in
            ["", "-", ".", "1e", "1e99999", "nan", "1.5x", "12345678901234567890", "9007199254740993", "1e23"]
        {
            assert_eq!(value(left), None, "{left}");
        }
        assert_eq!(short_natural(b"x123/4", 1), Some((123, 4)));
        assert_eq!(short_natural(b"1234567890", 0), None);
        assert_eq!(short_natural(b"-1", 0), None);
    }

    proptest! {
        #[test]
        fn the_short_way_and_the_long_way_agree(integer in "[+-]?[0-9]{0,12}", fraction in "(\\.[0-9]{0,12})?", exponent in "([eE][+-]?[0-9]{1,3})?") {
            let text = format!("{integer}{fraction}{exponent}");
            if let Some((value, end)) = short_decimal(text.as_bytes(), 0) {
                prop_assert_eq!(end, text.len());
                prop_assert_eq!(value.to_bits(), text.parse::<f64>().unwrap().to_bits(), "{}", text);
            }
        }

        #[test]
        fn numbers_are_written_so_that_they_read_back(value in any::<f64>().prop_filter("finite", |x| x.is_finite()), natural in any::<u64>()) {
            let mut text = Vec::new();
            push_f64(&mut text, value);
            prop_assert_eq!(fast_float2::parse::<f64, _>(&text).unwrap().to_bits(), value.to_bits());
            text.clear();
            push_natural(&mut text, natural);
            prop_assert_eq!(String::from_utf8(text).unwrap(), natural.to_string());
        }
    }
}
