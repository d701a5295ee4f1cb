//! The ring in which a question about homology is asked.

use coface_algebra::is_prime;
use coface_algebra::{Error, ErrorKind};
use std::fmt;
use std::str::FromStr;

/// The coefficients of homology or cohomology: an argument of the question, not a type of the complex.
///
/// Written `z`, `q` (or `r`: real Betti numbers are the rational ones), `f5` for a prime field, `z6` for Z/6.
///
/// # Examples
/// ```
/// use coface_topology::Coefficients;
/// assert_eq!("f2".parse(), Ok(Coefficients::Modulo(2)));
/// assert_eq!("z".parse(), Ok(Coefficients::Integers));
/// assert!("f4".parse::<Coefficients>().is_err());
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Coefficients {
    /// Z.
    Integers,
    /// Q; the real numbers give the same ranks.
    Rationals,
    /// Z/n, a field when n is prime; n is at least 2.
    Modulo(u64),
}

impl FromStr for Coefficients {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self, Error> {
        let lower = text.to_ascii_lowercase();
        let wrong = |message: String| {
            Err(Error::new(ErrorKind::Coefficient, message).with_cure(
                "say z, q, f2, f3, ... for a prime field, or z4, z6, ... for the integers modulo n",
            ))
        };
        let number = |digits: &str| digits.trim_start_matches('/').parse::<u64>().ok().filter(|&n| n >= 2);
        match lower.as_str() {
            "z" => Ok(Self::Integers),
            "q" | "r" => Ok(Self::Rationals),
            _ => match (lower.split_at_checked(1), lower.get(1..).and_then(number)) {
                (Some(("f", _)), Some(n)) if is_prime(n) => Ok(Self::Modulo(n)),
                (Some(("f", _)), Some(n)) => wrong(format!("there is no prime field of {n} elements")),
                (Some(("z", _)), Some(n)) => Ok(Self::Modulo(n)),
                _ => wrong(format!("{text:?} names no coefficients")),
            },
        }
    }
}

impl fmt::Display for Coefficients {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Integers => f.write_str("Z"),
            Self::Rationals => f.write_str("Q"),
            Self::Modulo(n) => write!(f, "Z/{n}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_read() {
        for (text, coefficients) in [
            ("Z", Coefficients::Integers),
            ("q", Coefficients::Rationals),
            ("F11", Coefficients::Modulo(11)),
            ("z/6", Coefficients::Modulo(6)),
            ("f2147483647", Coefficients::Modulo(2_147_483_647)),
        ] {
            assert_eq!(text.parse(), Ok(coefficients), "{text}");
        }
        for bad in ["", "f", "f1", "f9", "z1", "z0", "x3", "f-2", "é2"] {
            assert!(bad.parse::<Coefficients>().is_err(), "{bad}");
        }
    }
}
