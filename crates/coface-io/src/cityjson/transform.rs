//! Whole numbers to coordinates, as the decimal numbers of a transform say.

use super::document::Coordinate;
use coface_algebra::Error;

/// The powers of ten that `f64` holds exactly have at most this exponent.
const EXACT: i32 = 22;

/// A decimal number: mantissa times a power of ten.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Decimal {
    mantissa: i128,
    exponent: i32,
}

impl Decimal {
    /// The number that a text says; `None` for more than 30 digits, and for what is no number.
    fn parse(text: &str) -> Option<Self> {
        let (digits, exponent) = match text.find(['e', 'E']) {
            Some(at) => (&text[..at], text[at + 1..].parse::<i32>().ok().filter(|e| e.abs() < 400)?),
            None => (text, 0),
        };
        let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
        if whole.len() + fraction.len() > 30 {
            return None;
        }
        let mantissa = format!("{whole}{fraction}").parse().ok()?;
        Some(Self { mantissa, exponent: exponent - fraction.len() as i32 })
    }

    fn times(self, other: Self) -> Option<Self> {
        let mantissa = self.mantissa.checked_mul(other.mantissa)?;
        Some(Self { mantissa, exponent: self.exponent + other.exponent })
    }

    fn plus(self, other: Self) -> Option<Self> {
        let exponent = self.exponent.min(other.exponent);
        let shifted = |number: Self| {
            let power = 10i128.checked_pow((number.exponent - exponent) as u32)?;
            number.mantissa.checked_mul(power)
        };
        Some(Self { mantissa: shifted(self)?.checked_add(shifted(other)?)?, exponent })
    }

    /// The nearest `f64`.
    fn rounded(self) -> f64 {
        if self.mantissa.unsigned_abs() <= 1 << 53 && self.exponent.abs() <= EXACT {
            // One operation on two exact numbers rounds once.
            let power = 10f64.powi(self.exponent.abs());
            return match self.exponent < 0 {
                true => self.mantissa as f64 / power,
                false => self.mantissa as f64 * power,
            };
        }
        format!("{}e{}", self.mantissa, self.exponent).parse().unwrap_or(f64::NAN)
    }
}

/// What becomes of the coordinates of vertices.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Transform([[Decimal; 2]; 3]);

impl Transform {
    /// The transform of these texts: scales, and translations.
    pub(super) fn new(scale: &[impl AsRef<str>], translate: &[impl AsRef<str>]) -> Result<Self, Error> {
        let fault = |what: &str| {
            Error::invalid(format!("\"{what}\" of the transform is not three numbers of up to 30 digits"))
                .with_cure("write it as {\"scale\": [0.001, 0.001, 0.001], \"translate\": [0.0, 0.0, 0.0]}")
        };
        let scale = three(scale).ok_or_else(|| fault("scale"))?;
        let translate = three(translate).ok_or_else(|| fault("translate"))?;
        Ok(Self([0, 1, 2].map(|axis| [scale[axis], translate[axis]])))
    }

    /// The position that three coordinates stand for.
    pub(super) fn apply(&self, point: [Coordinate; 3]) -> [f64; 3] {
        [0, 1, 2].map(|axis| {
            let [scale, translate] = self.0[axis];
            let given = match point[axis] {
                Coordinate::Whole(number) => Some(Decimal { mantissa: number.into(), exponent: 0 }),
                Coordinate::Real(number) => Decimal::parse(&format!("{number:?}")),
            };
            let exact = given.and_then(|given| given.times(scale)?.plus(translate));
            match exact {
                Some(exact) => exact.rounded(),
                None => point[axis].to_f64() * scale.rounded() + translate.rounded(),
            }
        })
    }
}

fn three(texts: &[impl AsRef<str>]) -> Option<[Decimal; 3]> {
    let list: Option<Vec<Decimal>> = texts.iter().map(|text| Decimal::parse(text.as_ref())).collect();
    <[Decimal; 3]>::try_from(list?).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coordinates_are_the_nearest_to_the_decimal() {
        let transform =
            Transform::new(&["0.001", "1e-3", "2"], &["84616.468", "-4.5E5", "0.1"]).expect("numbers");
        let whole = [4567, 5_000_000_123, -7].map(Coordinate::Whole);
        assert_eq!(transform.apply(whole), [84621.035, 4_550_000.123, -13.9]);
        assert_ne!(4567.0 * 0.001 + 84616.468, 84621.035, "floating point is not enough");
        // A coordinate that is no whole number, and one beyond the exact path.
        let odd = [Coordinate::Real(0.5), Coordinate::Whole(i64::MAX), Coordinate::Real(0.05)];
        assert_eq!(transform.apply(odd), [84616.4685, 9_223_372_036_404_775.807, 0.2]);
        assert!(Transform::new(&["1", "1"], &["0", "0", "0"]).is_err());
        assert!(Transform::new(&["1", "1", "x"], &["0", "0", "0"]).is_err());
    }
}
