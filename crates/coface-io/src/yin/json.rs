//! Sets as our JSON.

use crate::decimal::{flush, push_f64, push_natural};
use coface_algebra::Error;
use coface_yin::{Curve, EndCondition, Order, YinSet};
use std::io::Write;

/// Writes a set so that it is read again bit for bit, kinks and their names included. A curve has a name where `names` has one.
///
/// Control points are written where the curve is not the one that is fitted to its points with ends that are not-a-knot; parameters
/// where they are not the lengths of the way along the chords, and the carriers of pieces that are parts of others.
///
/// # Errors
/// [`ErrorKind::Io`](coface_algebra::ErrorKind::Io) from the output.
///
/// # Complexity
/// Linear.
///
/// # Examples
/// ```
/// use coface_io::yin::write_json;
/// use coface_yin::{Order, YinSet};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let mut text = Vec::new();
/// write_json(&YinSet::plane(Order::LINEAR), &[], &mut text)?;
/// assert_eq!(text, b"{\"order\":2,\"plane\":true}\n");
/// # Ok(()) }
/// ```
pub fn write_json(set: &YinSet, names: &[Option<String>], mut out: impl Write) -> Result<(), Error> {
    let mut text = format!("{{\"order\":{},", set.order()).into_bytes();
    if set.is_plane() {
        text.extend_from_slice(b"\"plane\":true}\n");
        out.write_all(&text)?;
        out.flush()?;
        return Ok(());
    }
    let kinks: Vec<_> = set.kinks().iter().collect();
    let next_name = set.kinks().next_name();
    let are_numbered = kinks.iter().zip(0..).all(|((_, name), number)| name.to_u32() == number)
        && next_name as usize == kinks.len();
    if !are_numbered {
        text.extend_from_slice(format!("\"next_vertex\":{next_name},").as_bytes());
    }
    text.extend_from_slice(b"\"curves\":[");
    let mut rest = &kinks[..];
    for number in 0..set.curve_count() {
        let curve = set.curve(number);
        text.extend_from_slice(if number == 0 { b"\n{" } else { b",\n{" });
        if let Some(Some(name)) = names.get(number) {
            let name = serde_json::to_string(name).map_err(|error| Error::invalid(error.to_string()))?;
            text.extend_from_slice(format!("\"name\":{name},").as_bytes());
        }
        let count = rest.iter().take_while(|(knot, _)| knot.curve as usize == number).count();
        let (own, later) = rest.split_at(count);
        rest = later;
        let points: Vec<[f64; 2]> = (0..curve.piece_count()).map(|knot| curve.knot_point(knot)).collect();
        push_points(&mut text, "points", &points, &mut out)?;
        let own_kinks: Vec<u32> = own.iter().map(|(knot, _)| knot.knot).collect();
        if !own.is_empty() {
            push_list(&mut text, "kinks", own_kinks.iter().copied());
            if !are_numbered {
                push_list(&mut text, "vertices", own.iter().map(|(_, name)| name.to_u32()));
            }
        }
        push_difference(&mut text, &curve, &points, &own_kinks, &mut out)?;
        push_carriers(&mut text, &curve, &mut out)?;
        text.push(b'}');
        flush(&mut text, &mut out)?;
    }
    text.extend_from_slice(if set.curve_count() > 0 { b"\n]}\n" } else { b"]}\n" });
    out.write_all(&text)?;
    out.flush()?;
    Ok(())
}

/// Parameters and control points, where points and kinks do not say them.
fn push_difference(
    text: &mut Vec<u8>,
    curve: &Curve<'_>,
    points: &[[f64; 2]],
    kinks: &[u32],
    out: &mut impl Write,
) -> Result<(), Error> {
    let fitted = Curve::fit_closed(points, kinks, curve.order(), &EndCondition::NotAKnot).ok();
    let has_controls = curve.order() > Order::LINEAR
        && !fitted.as_ref().is_some_and(|fitted| same(fitted.controls(), curve.controls()));
    let has_knots = !fitted.as_ref().is_some_and(|fitted| {
        fitted.knots().iter().zip(curve.knots()).all(|(a, b)| a.to_bits() == b.to_bits())
    });
    if has_knots {
        text.extend_from_slice(b",\"knots\":[");
        for (i, &knot) in curve.knots().iter().enumerate() {
            if i > 0 {
                text.push(b',');
            }
            push_f64(text, knot);
        }
        text.push(b']');
    }
    if has_controls || has_knots && curve.order() > Order::LINEAR {
        text.push(b',');
        push_points(text, "controls", &curve.controls()[..curve.controls().len() - 1], out)?;
    }
    Ok(())
}

/// What pieces are parts of.
fn push_carriers(text: &mut Vec<u8>, curve: &Curve<'_>, out: &mut impl Write) -> Result<(), Error> {
    for (number, carrier) in curve.carriers().iter().enumerate() {
        text.extend_from_slice(if number == 0 { b",\"carriers\":[{" } else { b",{" });
        text.extend_from_slice(format!("\"piece\":{},\"range\":[", carrier.piece()).as_bytes());
        push_f64(text, carrier.range()[0]);
        text.push(b',');
        push_f64(text, carrier.range()[1]);
        text.extend_from_slice(b"],\"growth\":");
        push_f64(text, carrier.growth());
        text.push(b',');
        push_points(text, "controls", carrier.controls(), out)?;
        text.push(b'}');
    }
    if !curve.carriers().is_empty() {
        text.push(b']');
    }
    Ok(())
}

fn same(a: &[[f64; 2]], b: &[[f64; 2]]) -> bool {
    let bits = |points: &[[f64; 2]]| points.as_flattened().iter().map(|x| x.to_bits()).collect::<Vec<_>>();
    a.len() == b.len() && bits(a) == bits(b)
}

fn push_points(
    text: &mut Vec<u8>,
    key: &str,
    points: &[[f64; 2]],
    out: &mut impl Write,
) -> Result<(), Error> {
    text.extend_from_slice(format!("\"{key}\":[").as_bytes());
    for (i, &[x, y]) in points.iter().enumerate() {
        text.extend_from_slice(if i == 0 { b"[" } else { b",[" });
        push_f64(text, x);
        text.push(b',');
        push_f64(text, y);
        text.push(b']');
        flush(text, out)?;
    }
    text.push(b']');
    Ok(())
}

fn push_list(text: &mut Vec<u8>, key: &str, numbers: impl Iterator<Item = u32>) {
    text.extend_from_slice(format!(",\"{key}\":[").as_bytes());
    for (i, number) in numbers.enumerate() {
        if i > 0 {
            text.push(b',');
        }
        push_natural(text, u64::from(number));
    }
    text.push(b']');
}
