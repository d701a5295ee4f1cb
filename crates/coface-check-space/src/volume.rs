//! Volumes as close as is asked for.

use crate::point::{Point, determinant};
use coface_check::Fault;
use coface_check_plane::parts;
use dashu_int::IBig;
use serde_json::Value;

/// Claims agree with volumes to one part in 2 to this power.
const PRECISION: usize = 43;
/// Fractions have at most so many binary digits before a volume is given up.
const MOST_DIGITS: usize = 1 << 14;

/// Tests that a claim is the volume that triangles enclose which turn counterclockwise seen from outside.
///
/// Six times the volume is the sum of the determinants of their corners. Each is rounded down to a multiple of 2^-digits, so the sum is too low
/// by less than their number of such units; digits are added until that is less than 2^-[`PRECISION`] of the volume.
pub(crate) fn agrees(triangles: &[[&Point; 3]], claim: &Value) -> Result<f64, Fault> {
    let fault = |message: String| Fault::new("answer", message);
    let number = claim.as_f64().filter(|volume| volume.is_finite());
    let number = number.ok_or_else(|| fault(format!("the volume is {claim}, not a number")))?;
    if triangles.is_empty() {
        return if number == 0.0 { Ok(0.0) } else { Err(fault(format!("the volume is 0, not {number}"))) };
    }
    let mut digits = 64;
    let volume = loop {
        let sum = triangles.iter().fold(IBig::ZERO, |sum, triangle| sum + part(triangle, digits));
        if (IBig::from(triangles.len()) << (PRECISION + 2)) <= sum {
            break sum;
        }
        if digits > MOST_DIGITS {
            return Err(fault("the volume is not above zero".to_owned()));
        }
        digits *= 2;
    };
    let (mantissa, exponent) = parts(number);
    let shift = exponent + digits as i32;
    let claimed: IBig = (mantissa * 6) << shift.max(0) as usize;
    let volume: IBig = volume << (-shift).max(0) as usize;
    let difference: IBig = &claimed - &volume;
    let difference = if difference < IBig::ZERO { -difference } else { difference };
    match difference << PRECISION <= volume {
        true => Ok(number),
        false => Err(fault(format!("the volume is not {number}"))),
    }
}

/// The determinant of the corners in units of 2^-digits, rounded down.
fn part([a, b, c]: &[&Point; 3], digits: usize) -> IBig {
    let rows = [a, b, c].map(|point| [&point.exact[0], &point.exact[1], &point.exact[2]]);
    let (above, below) = (determinant(rows) << digits, &a.exact[3] * &b.exact[3] * &c.exact[3]);
    let quotient = &above / &below;
    if &quotient * &below > above { quotient - IBig::ONE } else { quotient }
}
