//! Where two cubic pieces cross that run side by side, by exact arithmetic.

use super::common_end::{Coefficients, around, power_coefficients, resultant, size};
use coface_geometry::predicates::Dyadic;
use std::cmp::Ordering;

/// How often a range is halved to tell roots apart; those of several multiplicities never are.
const DEEPEST: u32 = 48;

/// The places in a range of parameters at which a cubic piece is on another one, or on its continuation: each between two numbers next to
/// each other or equal. Nothing where they are too near each other to be told apart, or the pieces touch.
///
/// The resultant of $x_B(s) - x_A(t)$ and $y_B(s) - y_A(t)$ by s is computed exactly; its roots are isolated by the rule of Descartes.
/// The ends of the first piece that are told to be common are left out.
///
/// # References
/// G. E. Collins, A. G. Akritas, *Polynomial real root isolation using Descartes' rule of signs* (1976).
pub(super) fn places_on(
    a: &[[f64; 2]; 4],
    b: &[[f64; 2]; 4],
    range: [f64; 2],
    is_common: [bool; 2],
) -> Option<Vec<[f64; 2]>> {
    let origin = b[0];
    let of = |piece: &[[f64; 2]; 4]| {
        [0, 1].map(|axis| power_coefficients(piece.map(|point| point[axis]), origin[axis]))
    };
    let mut found = resultant(&of(a), &of(b));
    if is_common[0] {
        let zeros = found.iter().take_while(|c| c.sign().is_eq()).count();
        found.drain(..zeros);
    }
    if is_common[1] {
        while let Some(quotient) = without_one(&found) {
            found = quotient;
        }
    }
    isolated_roots(&found, range)
}

/// A polynomial divided by $t - 1$, if 1 is a root of it.
fn without_one(polynomial: &[Dyadic]) -> Option<Coefficients> {
    let mut sum = Dyadic::from(0.0);
    let mut quotient: Coefficients = polynomial
        .iter()
        .rev()
        .map(|c| {
            sum = &sum + c;
            sum.clone()
        })
        .collect();
    // The last sum is the value at 1.
    let is_root = quotient.pop().is_some_and(|value| value.sign().is_eq());
    quotient.reverse();
    (is_root && !quotient.is_empty()).then_some(quotient)
}

/// The roots of a polynomial in a range, each between two numbers next to each other or equal; nothing if they cannot be told apart.
fn isolated_roots(polynomial: &[Dyadic], [low, high]: [f64; 2]) -> Option<Vec<[f64; 2]>> {
    // Also so for what is not a number.
    if low.partial_cmp(&high) != Some(Ordering::Less) || polynomial.iter().all(|c| c.sign().is_eq()) {
        return None;
    }
    let width = (high - low).next_up();
    let factor = Dyadic::from(width);
    let mut power = Dyadic::from(1.0);
    let mut scaled = around(polynomial, low);
    for coefficient in &mut scaled {
        *coefficient = &*coefficient * &power;
        power = &power * &factor;
    }
    let place = |part: f64| (low + part * width).min(high);
    let mut found = Vec::new();
    let mut waiting = vec![(scaled, 0.0f64, 0)];
    while let Some((mut own, from, depth)) = waiting.pop() {
        let part = 0.5f64.powi(depth as i32);
        if own.first().is_some_and(|c| c.sign().is_eq()) {
            own.remove(0);
            // A root twice is not told apart from itself.
            if own.first().is_none_or(|c| c.sign().is_eq()) {
                return None;
            }
            found.push(around_number(place(from), from > 0.0));
        }
        match variations(&own) {
            0 => {}
            1 => {
                let guess = place(from + part * guessed_root(&own));
                found.push(bracket(polynomial, [place(from), place(from + part)], guess)?);
            }
            _ if depth == DEEPEST => return None,
            _ => {
                let [left, right] = halves(&own);
                waiting.push((right, from + 0.5 * part, depth + 1));
                waiting.push((left, from, depth + 1));
            }
        }
    }
    found.sort_by(|a, b| a[0].total_cmp(&b[0]));
    found.dedup();
    Some(found)
}

/// A number that may be rounded, between its neighbors.
fn around_number(t: f64, is_rounded: bool) -> [f64; 2] {
    if is_rounded { [t.next_down(), t.next_up()] } else { [t; 2] }
}

/// A bound on the number of roots between 0 and 1, which is right where it is 0 or 1: the changes of sign of $(1 + x)^n P(1 / (1 + x))$.
fn variations(polynomial: &[Dyadic]) -> usize {
    let reversed: Coefficients = polynomial.iter().rev().cloned().collect();
    let signs: Vec<Ordering> =
        around(&reversed, 1.0).iter().map(Dyadic::sign).filter(|sign| sign.is_ne()).collect();
    signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
}

/// A polynomial on both halves of [0, 1], each again over [0, 1], scaled by a power of two.
fn halves(polynomial: &[Dyadic]) -> [Coefficients; 2] {
    let degree = polynomial.len() as i32 - 1;
    let left: Coefficients =
        polynomial.iter().zip(0..).map(|(c, k)| c * &Dyadic::from(2f64.powi(degree - k))).collect();
    let right = around(&left, 1.0);
    [left, right]
}

/// About where the one root of a polynomial between 0 and 1 is, by bisection in floating-point numbers.
fn guessed_root(polynomial: &[Dyadic]) -> f64 {
    let zero = Dyadic::from(0.0);
    let largest = polynomial.iter().fold(zero, |largest, c| {
        let size = size(c);
        if (&size - &largest).sign().is_gt() { size } else { largest }
    });
    if largest.sign().is_eq() {
        return 0.5;
    }
    let rounded: Vec<f64> = polynomial.iter().map(|c| c.rounded_ratio(&largest)).collect();
    let value = |t: f64| rounded.iter().rev().fold(0.0, |sum, c| sum * t + c);
    let is_rising = value(1.0) > 0.0;
    let [mut low, mut high] = [0.0, 1.0];
    for _ in 0..54 {
        let middle = 0.5 * (low + high);
        if (value(middle) > 0.0) == is_rising { high = middle } else { low = middle }
    }
    0.5 * (low + high)
}

/// Numbers next to each other, or one, between which the only root of a polynomial in a range lies.
///
/// It is looked for on both sides of a guess first, in steps that grow.
fn bracket(polynomial: &[Dyadic], [mut low, mut high]: [f64; 2], guess: f64) -> Option<[f64; 2]> {
    let sign = |t: f64| {
        let t = Dyadic::from(t);
        polynomial.iter().rev().fold(Dyadic::from(0.0), |sum, c| &(&sum * &t) + c).sign()
    };
    let [mut below, above] = [sign(low), sign(high)];
    if above.is_eq() {
        return Some([high; 2]);
    }
    if below.is_eq() {
        // The root is inside; the range begins at another one.
        low = low.next_up();
        below = sign(low);
    }
    if below != above.reverse() {
        return None;
    }
    let mut step = 2.0 * f64::EPSILON * guess.abs().max(f64::MIN_POSITIVE);
    loop {
        let [from, to] = [guess - step, guess + step];
        let is_below = from <= low || sign(from) == below;
        let is_above = high <= to || sign(to) == above;
        if is_below {
            low = low.max(from);
        }
        if is_above {
            high = high.min(to);
        }
        if is_below && is_above {
            break;
        }
        step *= 64.0;
    }
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            return Some([low, high]);
        }
        match sign(middle) {
            Ordering::Equal => return Some([middle; 2]),
            sign if sign == below => low = middle,
            _ => high = middle,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn of_roots(roots: &[i32]) -> Coefficients {
        roots.iter().fold(vec![Dyadic::from(1.0)], |product, &root| {
            let mut found = vec![Dyadic::from(0.0); product.len() + 1];
            for (k, c) in product.iter().enumerate() {
                found[k + 1] = &found[k + 1] + c;
                found[k] = &found[k] - &(c * &Dyadic::from(f64::from(root)));
            }
            found
        })
    }

    proptest! {
        #[test]
        fn roots_that_are_known_are_found(roots in prop::collection::btree_set(-40..40i32, 1..9), low in -50..50i32, length in 1..60i32) {
            let roots: Vec<i32> = roots.into_iter().collect();
            let range = [f64::from(low), f64::from(low + length)];
            let found = isolated_roots(&of_roots(&roots), range);
            let inside: Vec<i32> = roots.into_iter().filter(|root| (low..=low + length).contains(root)).collect();
            let found = found.expect("simple roots are told apart");
            prop_assert_eq!(found.len(), inside.len(), "{:?} {:?}", found, inside);
            for (own, root) in found.iter().zip(inside) {
                prop_assert!(own[0] <= f64::from(root) && f64::from(root) <= own[1], "{own:?} {root}");
                prop_assert!(own[1] - own[0] < 1e-13);
            }
        }
    }

    #[test]
    fn double_roots_are_not_told_apart() {
        assert_eq!(isolated_roots(&of_roots(&[1, 3, 3]), [0.0, 4.0]), None);
        assert_eq!(isolated_roots(&of_roots(&[1, 3, 3]), [0.0, 2.5]).map(|found| found.len()), Some(1));
        assert_eq!(isolated_roots(&[], [0.0, 1.0]), None);
        assert_eq!(isolated_roots(&of_roots(&[1]), [f64::NAN, 1.0]), None);
    }

    /// Two cubics that cross at an angle of 2^-40: $y = 27 t^3$ over $x = 3 t$, and the same with a slope that is zero at the middle.
    #[test]
    fn pieces_that_cross_at_a_small_angle() {
        let a = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [3.0, 27.0]];
        let slope = 2f64.powi(-40);
        let b = [0, 1, 2, 3].map(|j| [a[j][0], a[j][1] + slope * (j as f64 - 1.5)]);
        assert_eq!(places_on(&a, &b, [0.0, 1.0], [false; 2]), Some(vec![[0.5; 2]]));
        assert_eq!(places_on(&a, &b, [0.0, 0.499], [false; 2]), Some(Vec::new()));
        // Beginning in one point they leave it on both sides.
        let c = [0, 1, 2, 3].map(|j| [a[j][0], a[j][1] + slope * j as f64]);
        assert_eq!(places_on(&a, &c, [0.0, 1.0], [true, false]), Some(Vec::new()));
        assert_eq!(places_on(&a, &c, [0.0, 1.0], [false; 2]), Some(vec![[0.0; 2]]));
        assert_eq!(places_on(&a, &a, [0.0, 1.0], [false; 2]), None);
    }
}
