//! Areas as close as is asked for.

use crate::point::parts;
use crate::subdivision::Subdivision;
use coface_check::Fault;
use dashu_int::IBig;
use serde_json::Value;
use std::cmp::Ordering;

/// Claims agree with areas to one part in 2 to this power.
const PRECISION: usize = 46;
/// Fractions have at most so many binary digits before an area is given up.
const MOST_DIGITS: usize = 1 << 14;

/// An area that is above zero, as close as [`PRECISION`] asks: twice the area is at least the integer in units of 2^-digits.
pub(crate) struct Area {
    doubled: IBig,
    digits: usize,
}

impl Area {
    /// The area on the left of these closed walks of halfedges.
    ///
    /// Twice the area is the sum of the determinants of the ends of all halfedges (the shoelace formula). Each is rounded down to a multiple
    /// of 2^-digits, so the sum is too low by less than their number of such units.
    pub(crate) fn of(plane: &Subdivision, walks: &[u32], what: &str) -> Result<Self, Fault> {
        let mut digits = 64;
        loop {
            let parts = walks.iter().map(|&halfedge| determinant(plane, halfedge, digits));
            let doubled = parts.fold(IBig::ZERO, |sum, part| sum + part);
            if (IBig::from(walks.len()) << (PRECISION + 2)) <= doubled {
                return Ok(Self { doubled, digits });
            }
            if digits > MOST_DIGITS {
                return Err(Fault::new("answer", format!("{what} is not above zero")));
            }
            digits *= 2;
        }
    }

    pub(crate) fn compare(&self, other: &Self) -> Ordering {
        (&self.doubled << other.digits).cmp(&(&other.doubled << self.digits))
    }

    /// Tests that a claim is this area: |claim - area| is at most area / 2^[`PRECISION`].
    pub(crate) fn agrees(&self, claim: &Value, what: &str) -> Result<f64, Fault> {
        let fault = |message: String| Fault::new("answer", message);
        let number = claim.as_f64().filter(|area| area.is_finite());
        let number = number.ok_or_else(|| fault(format!("{what} is {claim}, not a number")))?;
        let (mantissa, exponent) = parts(number);
        let shift = exponent + self.digits as i32 + 1;
        let claimed = if shift >= 0 { mantissa << shift as usize } else { mantissa };
        let doubled = &self.doubled << (-shift).max(0) as usize;
        let difference = &claimed - &doubled;
        let difference = if difference < IBig::ZERO { -difference } else { difference };
        if (difference << PRECISION) > doubled {
            return Err(fault(format!("{what} is not {number}")));
        }
        Ok(number)
    }
}

/// The determinant of the ends of a halfedge in units of 2^-digits, rounded down.
fn determinant(plane: &Subdivision, halfedge: u32, digits: usize) -> IBig {
    let ends = plane.edges[halfedge as usize / 2].map(|vertex| &plane.vertices[vertex as usize]);
    let [a, b] = if halfedge.is_multiple_of(2) { ends } else { [ends[1], ends[0]] };
    let (above, below) = ((&a.x * &b.y - &a.y * &b.x) << digits, &a.w * &b.w);
    let quotient = &above / &below;
    if &quotient * &below > above { quotient - IBig::ONE } else { quotient }
}
