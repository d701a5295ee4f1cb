//! What one request may take, and how that is written.

use coface_algebra::Error;
use std::time::Duration;

/// What a worker may take for one request.
///
/// # Examples
/// ```
/// use coface_scale::workers::{Limits, parse_bytes, parse_duration};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let limits = Limits { time: Some(parse_duration("90s")?), memory: Some(parse_bytes("2G")?) };
/// assert_eq!(limits.memory, Some(2 << 30));
/// # Ok(()) }
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Limits {
    /// The time from request to answer; `None` is any.
    pub time: Option<Duration>,
    /// The address space of the process in bytes; `None` is any.
    pub memory: Option<u64>,
}

/// Units of time in milliseconds.
const TIMES: [(&str, f64); 4] = [("ms", 1.0), ("s", 1e3), ("m", 60e3), ("h", 3600e3)];

/// Units of memory in bytes. A single letter is a power of 2, as shells have it.
const SIZES: [(&str, f64); 12] = [
    ("KiB", 1024.0),
    ("MiB", 1_048_576.0),
    ("GiB", 1_073_741_824.0),
    ("TiB", 1_099_511_627_776.0),
    ("KB", 1e3),
    ("MB", 1e6),
    ("GB", 1e9),
    ("TB", 1e12),
    ("K", 1024.0),
    ("M", 1_048_576.0),
    ("G", 1_073_741_824.0),
    ("T", 1_099_511_627_776.0),
];

/// A duration as people write it: `500ms`, `60s`, `1.5m`, `2h`; without a unit it is seconds.
///
/// # Errors
/// [`coface_algebra::ErrorKind::InvalidInput`] if it is none, not above 0, or above a year.
///
/// # Examples
/// ```
/// use coface_scale::workers::parse_duration;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// assert_eq!(parse_duration("1.5m")?.as_secs(), 90);
/// assert!(parse_duration("soon").is_err());
/// # Ok(()) }
/// ```
pub fn parse_duration(text: &str) -> Result<Duration, Error> {
    let most = 365.0 * 24.0 * 3600e3;
    let milliseconds = quantity(text, &TIMES, 1e3).filter(|&time| time >= 1.0 && time <= most);
    milliseconds.map(|time| Duration::from_millis(time.round() as u64)).ok_or_else(|| {
        Error::invalid(format!("\"{text}\" is no duration"))
            .with_cure("write a number above 0 and a unit: 500ms, 60s, 5m, 2h")
    })
}

/// A number of bytes as people write it: `2G`, `500M`, `1.5GiB`, `4GB`. K, M, G and T are powers of 1024, KB to TB powers of 1000.
///
/// # Errors
/// [`coface_algebra::ErrorKind::InvalidInput`] if it is none, below 1 or above $2^{53}$.
///
/// # Examples
/// ```
/// use coface_scale::workers::parse_bytes;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// assert_eq!([parse_bytes("64K")?, parse_bytes("4GB")?, parse_bytes("12")?], [65536, 4_000_000_000, 12]);
/// # Ok(()) }
/// ```
pub fn parse_bytes(text: &str) -> Result<u64, Error> {
    let bytes = quantity(text, &SIZES, 1.0).filter(|&bytes| (1.0..=9e15).contains(&bytes));
    bytes.map(|bytes| bytes.round() as u64).ok_or_else(|| {
        Error::invalid(format!("\"{text}\" is no amount of memory"))
            .with_cure("write a number above 0 and a unit: 500M, 2G")
    })
}

/// A decimal number with one of these units, or with none, which then stands for `bare`.
fn quantity(text: &str, units: &[(&str, f64)], bare: f64) -> Option<f64> {
    let text = text.trim();
    let lower = text.to_ascii_lowercase();
    let (number, unit) = units
        .iter()
        .find_map(|(name, unit)| Some((lower.strip_suffix(&name.to_ascii_lowercase())?, *unit)))
        .unwrap_or((&lower, bare));
    let number = number.trim_end();
    let is_decimal = number.bytes().all(|byte| byte.is_ascii_digit() || byte == b'.');
    let number: f64 = if is_decimal { number.parse().ok()? } else { return None };
    Some(number * unit).filter(|value| value.is_finite())
}

/// A duration for people, in seconds: `60 s`, `0.5 s`.
///
/// # Examples
/// ```
/// use std::time::Duration;
/// assert_eq!(coface_scale::workers::seconds_text(Duration::from_millis(1500)), "1.5 s");
/// ```
pub fn seconds_text(duration: Duration) -> String {
    format!("{} s", duration.as_secs_f64())
}

/// A number of bytes for people, in the largest unit that does not need a fraction: `2 GiB`, `1500 MiB`.
///
/// # Examples
/// ```
/// use coface_scale::workers::bytes_text;
/// assert_eq!([bytes_text(2 << 30), bytes_text(1500 << 20), bytes_text(1001)], ["2 GiB", "1500 MiB", "1001 bytes"]);
/// ```
pub fn bytes_text(bytes: u64) -> String {
    let units = [(40, "TiB"), (30, "GiB"), (20, "MiB"), (10, "KiB")];
    match units.into_iter().find(|(power, _)| bytes >> power > 0 && bytes.trailing_zeros() >= *power) {
        Some((power, unit)) => format!("{} {unit}", bytes >> power),
        None => format!("{bytes} bytes"),
    }
}

#[cfg(test)]
mod tests {
    use super::{parse_bytes, parse_duration};

    #[test]
    fn durations_have_units() {
        for (text, milliseconds) in [
            ("500ms", 500),
            ("60s", 60_000),
            ("60", 60_000),
            ("5m", 300_000),
            (" 2 h ", 7_200_000),
            ("0.5S", 500),
        ] {
            assert_eq!(parse_duration(text).unwrap().as_millis(), milliseconds, "{text}");
        }
        for text in ["", "s", "-1s", "0", "1e3s", "nan", "inf", "5 weeks", "1.2.3s", "999999999h"] {
            assert!(parse_duration(text).is_err(), "{text}");
        }
    }

    #[test]
    fn memory_has_units() {
        for (text, bytes) in [("2G", 2 << 30), ("2 gib", 2 << 30), ("1.5M", 3 << 19), ("3kb", 3000), ("7", 7)]
        {
            assert_eq!(parse_bytes(text).unwrap(), bytes, "{text}");
        }
        for text in ["", "G", "-2G", "0", "2X", "1e9", "99999999T"] {
            assert!(parse_bytes(text).is_err(), "{text}");
        }
    }
}
