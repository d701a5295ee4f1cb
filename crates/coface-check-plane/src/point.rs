//! Points with fractions as coordinates, and what is decided about them.

use coface_check::Fault;
use coface_check::json::{integer, list};
use dashu_int::IBig;
use serde_json::Value;
use std::cmp::Ordering;

/// The point (x / w, y / w); w is above zero.
#[derive(Clone, Debug)]
pub(crate) struct Point {
    pub(crate) x: IBig,
    pub(crate) y: IBig,
    pub(crate) w: IBig,
}

/// A finite number as an integer times a power of two.
///
/// # Examples
/// ```
/// assert_eq!(coface_check_plane::parts(-0.75), (dashu_int::IBig::from(-3), -2));
/// ```
pub fn parts(number: f64) -> (IBig, i32) {
    let bits = number.to_bits();
    let (exponent, fraction) = ((bits >> 52 & 0x7ff) as i32, bits & ((1 << 52) - 1));
    let (mantissa, exponent) =
        if exponent == 0 { (fraction, -1074) } else { (fraction | 1 << 52, exponent - 1075) };
    let zeros = if mantissa == 0 { 0 } else { mantissa.trailing_zeros() };
    let mantissa = IBig::from(mantissa >> zeros);
    let exponent = if mantissa == IBig::ZERO { 0 } else { exponent + zeros as i32 };
    (if number < 0.0 { -mantissa } else { mantissa }, exponent)
}

impl Point {
    /// The point with these coordinates, exactly.
    pub(crate) fn of([x, y]: [f64; 2]) -> Self {
        let ((x, of_x), (y, of_y)) = (parts(x), parts(y));
        let least = of_x.min(of_y).min(0);
        let shifted = |value: IBig, exponent: i32| value << (exponent - least) as usize;
        Self { x: shifted(x, of_x), y: shifted(y, of_y), w: IBig::ONE << -least as usize }
    }

    /// Three integers of a certificate.
    pub(crate) fn read(value: &Value, step: &str) -> Result<Self, Fault> {
        let [x, y, w] = list(value, "a vertex", step)? else {
            return Err(Fault::new(step, "a vertex is no list of three integers x, y and w"));
        };
        let [x, y, w] = [integer(x, "x", step)?, integer(y, "y", step)?, integer(w, "w", step)?];
        if w <= IBig::ZERO {
            return Err(Fault::new(step, "the w of a vertex is not above zero"));
        }
        Ok(Self { x, y, w })
    }

    /// By x, and by y where these are equal.
    pub(crate) fn compare(&self, other: &Self) -> Ordering {
        let by = |a: &IBig, b: &IBig| (a * &other.w).cmp(&(b * &self.w));
        by(&self.x, &other.x).then_with(|| by(&self.y, &other.y))
    }
}

/// On which side of the line from a to b the point c lies: greater on the left, equal on the line. This is the sign of the determinant of
/// the rows (x, y, w), since each w is above zero.
pub(crate) fn side(a: &Point, b: &Point, c: &Point) -> Ordering {
    let minor = |p: &IBig, q: &IBig, r: &IBig, s: &IBig| p * s - q * r;
    let determinant = &a.x * minor(&b.y, &b.w, &c.y, &c.w) - &a.y * minor(&b.x, &b.w, &c.x, &c.w)
        + &a.w * minor(&b.x, &b.y, &c.x, &c.y);
    determinant.cmp(&IBig::ZERO)
}

#[cfg(test)]
mod tests {
    use super::{Point, parts, side};
    use dashu_int::IBig;
    use std::cmp::Ordering;

    #[test]
    fn numbers_are_taken_exactly() {
        assert_eq!(parts(-0.75), (IBig::from(-3), -2));
        assert_eq!(parts(0.0), (IBig::ZERO, 0));
        assert_eq!(parts(f64::from_bits(1)), (IBig::ONE, -1074));
        assert_eq!(parts(6.0), (IBig::from(3), 1));
    }

    #[test]
    fn sides_are_those_of_the_plane() {
        let [a, b, c] = [[0.0, 0.0], [1.0, 1.0], [0.5, 0.5]].map(Point::of);
        assert_eq!(side(&a, &b, &c), Ordering::Equal);
        assert_eq!(side(&a, &b, &Point::of([0.5, 0.5 + f64::EPSILON])), Ordering::Greater);
        assert_eq!(side(&a, &b, &Point::of([0.5, 0.5 - f64::EPSILON])), Ordering::Less);
        assert_eq!(a.compare(&c), Ordering::Less);
    }
}
