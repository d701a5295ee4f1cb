//! The binary `.dat` of curves as polynomials.

use super::{BoundaryCurve, BoundaryDrawing, Filling};
use crate::{Remark, RemarkCode};
use coface_algebra::{Error, ErrorKind};
use coface_yin::{Curve, Order, YinSet};
use std::io::{Read, Write};

/// The longest file that is read.
const LONGEST: u64 = 1 << 32;
/// A piece ends where the next begins within this part of the largest coordinate of its curve.
const GAP: f64 = 1e-9;
const CURE: &str = "write it again: it is damaged, or no file of curves";

/// Whether these are the first bytes of such a file.
pub(crate) fn is_dat(start: &[u8], whole: bool) -> bool {
    let word = |i: usize| {
        start.get(4 * i..4 * i + 4).map(|bytes| i32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]))
    };
    match (word(0), word(1), word(2), word(3)) {
        (Some(0), None, ..) => whole && start.len() == 4,
        (Some(1..), Some(2), Some(2 | 4 | 6 | 8), Some(1..)) => true,
        _ => false,
    }
}

/// Reads closed curves from the binary format.
///
/// The end of a piece becomes the beginning of the next, from which it may differ by 1e-9 of the largest coordinate. Curves of
/// several orders become curves of the highest.
///
/// # Errors
/// [`ErrorKind::Parse`] with the byte: a count that cannot be, a number that is not finite, a gap, an open curve, a file that ends
/// too soon or goes on; counts that a file merely claims take no memory. [`ErrorKind::TooLarge`] beyond 2^32 bytes.
///
/// # Complexity
/// Linear.
///
/// # Examples
/// ```
/// use coface_io::yin::{read_dat, write_dat};
/// use coface_yin::{Order, YinSet};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let mut bytes = Vec::new();
/// write_dat(&YinSet::empty(Order::CUBIC), &mut bytes)?;
/// assert_eq!(bytes, [0; 4]);
/// assert!(read_dat(&bytes[..])?.curves().is_empty());
/// assert!(read_dat(&[1, 0, 0, 0, 2, 0][..]).is_err());
/// # Ok(()) }
/// ```
pub fn read_dat(input: impl Read) -> Result<BoundaryDrawing, Error> {
    let mut bytes = Vec::new();
    input.take(LONGEST + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > LONGEST {
        return Err(
            Error::new(ErrorKind::TooLarge, "the file is longer than 2^32 bytes").with_cure("divide it")
        );
    }
    let mut words = Words { bytes: &bytes, at: 0 };
    let count = words.count("the number of curves", 0)?;
    let mut curves: Vec<Curve<'static>> = Vec::new();
    for number in 0..count {
        curves.push(words.curve(number)?);
    }
    if words.at < bytes.len() {
        return Err(words.fault(words.at, format!("the file goes on behind its {count} curves")));
    }
    let order = curves.iter().map(Curve::order).max().unwrap_or(Order::CUBIC);
    let mut drawing = BoundaryDrawing::new(order);
    let mut raised_count = 0;
    let boundary = curves.into_iter().map(|curve| {
        let curve = match curve.order() < order {
            true => {
                raised_count += 1;
                curve.raised(order)?
            }
            false => curve,
        };
        let points = (0..curve.piece_count()).map(|knot| curve.knot_point(knot)).collect();
        let mut boundary = BoundaryCurve::new(points);
        if order > Order::LINEAR {
            boundary.set_curve(curve);
        } else {
            boundary.set_knots(curve.knots().to_vec());
        }
        Ok(boundary)
    });
    let boundary: Vec<BoundaryCurve> = boundary.collect::<Result<_, Error>>()?;
    if raised_count > 0 {
        drawing.remark(Remark::new(
            RemarkCode::OrderRaised,
            format!("{raised_count} of {count} curves were raised to order {order}"),
        ));
    }
    if !boundary.is_empty() {
        drawing.push(Filling::Left, boundary);
    }
    Ok(drawing)
}

/// The numbers of a file.
struct Words<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl Words<'_> {
    fn fault(&self, at: usize, message: String) -> Error {
        Error::parse(message).at_byte(at as u64).with_cure(CURE)
    }

    fn take<const N: usize>(&mut self, what: &str) -> Result<[u8; N], Error> {
        let bytes = self.bytes.get(self.at..).and_then(|rest| rest.first_chunk::<N>());
        let found = bytes.copied().ok_or_else(|| {
            self.fault(
                self.bytes.len(),
                format!("the file ends before {what}, which begins at byte {}", self.at),
            )
        })?;
        self.at += N;
        Ok(found)
    }

    fn count(&mut self, what: &str, least: i32) -> Result<usize, Error> {
        let at = self.at;
        let number = i32::from_le_bytes(self.take(what)?);
        if number < least {
            return Err(self.fault(at, format!("{what} is {number}, less than {least}")));
        }
        Ok(number as usize)
    }

    fn number(&mut self, what: &str) -> Result<f64, Error> {
        let at = self.at;
        let number = f64::from_le_bytes(self.take(what)?);
        if number.is_finite() {
            return Ok(number);
        }
        Err(self.fault(at, format!("{what} is {number}, not finite")))
    }

    fn curve(&mut self, number: usize) -> Result<Curve<'static>, Error> {
        let start = self.at;
        let dimension = self.count(&format!("the dimension of curve {number}"), 1)?;
        if dimension != 2 {
            let message = format!("curve {number} has dimension {dimension}, and the plane has 2");
            return Err(self.fault(start, message));
        }
        let order_at = self.at;
        let order = self.count(&format!("the order of curve {number}"), 1)?;
        let order = Order::new(order).map_err(|error| error.at_byte(order_at as u64))?;
        let counted_at = self.at;
        let count = self.count(&format!("the number of pieces of curve {number}"), 1)?;
        let needed = (count as u64 + 1) * 8 + count as u64 * 16 * order.value() as u64;
        if needed > (self.bytes.len() - self.at) as u64 {
            let left = self.bytes.len() - self.at;
            return Err(self.fault(
                counted_at,
                format!("{count} pieces of curve {number} take {needed} bytes, but {left} are left"),
            ));
        }
        let knots_at = self.at;
        let knots: Vec<f64> = (0..=count)
            .map(|knot| self.number(&format!("knot {knot} of curve {number}")))
            .collect::<Result<_, _>>()?;
        if let Some(at) = knots.windows(2).position(|pair| pair[0] >= pair[1]) {
            let message = format!("knot {} of curve {number} is not above the one before it", at + 1);
            return Err(self.fault(knots_at + 8 * (at + 1), message));
        }
        let degree = order.degree();
        let mut controls: Vec<[f64; 2]> = Vec::with_capacity(count * degree + 1);
        // The place of each piece in the file, and where it ends by its own account.
        let mut ends = Vec::with_capacity(count);
        for piece in 0..count {
            let at = self.at;
            let length = knots[piece + 1] - knots[piece];
            let mut points = [[0.0; 2]; 8];
            for axis in [0, 1] {
                let mut power = [0.0; 8];
                for coefficient in &mut power[..=degree] {
                    *coefficient =
                        self.number(&format!("a coefficient of piece {piece} of curve {number}"))?;
                }
                let bernstein = bernstein_of_power(&power[..=degree], length);
                points.iter_mut().zip(bernstein).for_each(|(point, value)| point[axis] = value);
            }
            controls.extend_from_slice(&points[..degree]);
            ends.push((at, points[degree]));
        }
        let largest = controls.as_flattened().iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
        for (piece, &(at, end)) in ends.iter().enumerate() {
            let next = controls[(piece + 1) % count * degree];
            let gap = (end[0] - next[0]).hypot(end[1] - next[1]);
            // A gap that is no number is one.
            if !matches!(
                gap.partial_cmp(&(GAP * largest)),
                Some(std::cmp::Ordering::Less | std::cmp::Ordering::Equal)
            ) {
                let what = match piece + 1 == count {
                    true => "but the curve begins",
                    false => "but the next begins",
                };
                return Err(self.fault(
                    at,
                    format!(
                        "piece {piece} of curve {number} ends at ({}, {}), {what} at ({}, {}): the curve is open",
                        end[0], end[1], next[0], next[1]
                    ),
                ));
            }
        }
        controls.push(controls[0]);
        Curve::from_controls(order, controls, knots)
            .map_err(|error| error.at_byte(knots_at as u64).with_cure(CURE))
    }
}

/// The binomial coefficient of n over k, for small n.
fn binomial(n: usize, k: usize) -> f64 {
    (0..k).fold(1.0, |product, i| product * (n - i) as f64 / (i + 1) as f64)
}

/// The Bernstein coefficients on [0, 1] of the polynomial with these coefficients on [0, length].
fn bernstein_of_power(power: &[f64], length: f64) -> [f64; 8] {
    let degree = power.len() - 1;
    let mut scale = 1.0;
    let mut scaled = [0.0; 8];
    for (k, &coefficient) in power.iter().enumerate() {
        scaled[k] = coefficient * scale / binomial(degree, k);
        scale *= length;
    }
    let mut bernstein = [0.0; 8];
    for (j, value) in bernstein[..=degree].iter_mut().enumerate() {
        *value = (0..=j).map(|k| binomial(j, k) * scaled[k]).sum();
    }
    bernstein
}

/// The coefficients on [0, length] of the polynomial with these Bernstein coefficients on [0, 1].
fn power_of_bernstein(bernstein: &[f64], length: f64) -> [f64; 8] {
    let degree = bernstein.len() - 1;
    let mut differences = [0.0; 8];
    differences[..=degree].copy_from_slice(bernstein);
    let mut scale = 1.0;
    let mut power = [0.0; 8];
    for (k, coefficient) in power[..=degree].iter_mut().enumerate() {
        *coefficient = binomial(degree, k) * differences[0] / scale;
        scale *= length;
        for j in 0..degree - k {
            differences[j] = differences[j + 1] - differences[j];
        }
    }
    power
}

/// Writes the curves of a set, all of the set's order, as polynomials.
///
/// Points and parameters are kept bit for bit, other control points to some units in the last place; kinks are not kept.
///
/// # Errors
/// [`ErrorKind::UnsupportedFormat`] for the whole plane, which would be the empty set; [`ErrorKind::TooLarge`] beyond 2^31 curves or
/// pieces of one; [`ErrorKind::Io`] from the output.
pub fn write_dat(set: &YinSet, mut out: impl Write) -> Result<(), Error> {
    if set.is_plane() {
        return Err(Error::new(ErrorKind::UnsupportedFormat, ".dat cannot hold the whole plane")
            .with_cure("write .json"));
    }
    let mut bytes = word(set.curve_count())?.to_vec();
    for curve in (0..set.curve_count()).map(|curve| set.curve(curve)) {
        push_curve(&mut bytes, &curve)?;
        if bytes.len() >= 1 << 16 {
            out.write_all(&bytes)?;
            bytes.clear();
        }
    }
    out.write_all(&bytes)?;
    out.flush()?;
    Ok(())
}

fn word(number: usize) -> Result<[u8; 4], Error> {
    i32::try_from(number).map(i32::to_le_bytes).map_err(|_| {
        Error::new(ErrorKind::TooLarge, ".dat holds at most 2^31 - 1 curves and pieces of each")
            .with_cure("write .json")
    })
}

/// Appends a curve.
pub(super) fn push_curve(bytes: &mut Vec<u8>, curve: &Curve<'_>) -> Result<(), Error> {
    for number in [2, curve.order().value(), curve.piece_count()] {
        bytes.extend(word(number)?);
    }
    bytes.extend(curve.knots().iter().flat_map(|knot| knot.to_le_bytes()));
    for piece in 0..curve.piece_count() {
        let controls = curve.piece(piece);
        let length = curve.knots()[piece + 1] - curve.knots()[piece];
        for axis in 0..2 {
            let mut bernstein = [0.0; 8];
            controls.iter().zip(&mut bernstein).for_each(|(point, value)| *value = point[axis]);
            let power = power_of_bernstein(&bernstein[..controls.len()], length);
            bytes.extend(power[..controls.len()].iter().flat_map(|x| x.to_le_bytes()));
        }
    }
    Ok(())
}
