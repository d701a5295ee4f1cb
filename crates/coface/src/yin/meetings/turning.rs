//! Where a polynomial changes its sign.

use crate::yin::curve::bernstein::Piece;

/// Below this the coefficients of a derivative are what rounding made.
const FLAT: f64 = 1.0 / (1u64 << 50) as f64;

/// Adds the roots of a polynomial in the Bernstein basis at which its sign changes, within rounding; `range` are its parameters.
///
/// There are no more roots than changes of sign of the coefficients, and one if there is one change.
pub(super) fn add_sign_changes(coefficients: &[f64], range: [f64; 2], depth: usize, found: &mut Vec<f64>) {
    if coefficients.iter().all(|x| x.abs() <= FLAT) {
        return;
    }
    let signs = coefficients.iter().filter(|x| **x != 0.0).map(|x| x.signum());
    let changes = signs.clone().zip(signs.skip(1)).filter(|(a, b)| a != b).count();
    if changes == 0 {
        return;
    }
    let ends = [coefficients[0], coefficients[coefficients.len() - 1]];
    if changes == 1 && ends[0] * ends[1] < 0.0 {
        let t = bracketed_root(coefficients);
        let at = range[0] + t * (range[1] - range[0]);
        if 0.0 < at && at < 1.0 {
            found.push(at);
        }
        return;
    }
    let middle = range[0] + 0.5 * (range[1] - range[0]);
    if depth == 50 {
        found.push(middle);
        return;
    }
    let mut before = [0.0; Piece::MOST];
    let mut after = [0.0; Piece::MOST];
    let last = coefficients.len() - 1;
    after[..=last].copy_from_slice(coefficients);
    before[0] = after[0];
    for level in 1..=last {
        for i in 0..=last - level {
            after[i] = 0.5 * (after[i] + after[i + 1]);
        }
        before[level] = after[0];
    }
    add_sign_changes(&before[..=last], [range[0], middle], depth + 1, found);
    if after[0] == 0.0 && middle > 0.0 {
        found.push(middle);
    }
    add_sign_changes(&after[..=last], [middle, range[1]], depth + 1, found);
}

fn value(coefficients: &[f64], t: f64) -> f64 {
    let mut own = [0.0; Piece::MOST];
    own[..coefficients.len()].copy_from_slice(coefficients);
    for left in (1..coefficients.len()).rev() {
        for i in 0..left {
            own[i] = (1.0 - t) * own[i] + t * own[i + 1];
        }
    }
    own[0]
}

/// The one root between 0 and 1 of a polynomial whose ends have different signs.
fn bracketed_root(coefficients: &[f64]) -> f64 {
    let [mut low, mut high] = [0.0, 1.0];
    let [mut at_low, mut at_high] = [coefficients[0], coefficients[coefficients.len() - 1]];
    let mut side = 0;
    for step in 0..80 {
        // False position with the Illinois rule, and a bisection every fourth time.
        let mut t = (low * at_high - high * at_low) / (at_high - at_low);
        if step % 4 == 3 || !(low < t && t < high) {
            t = 0.5 * (low + high);
        }
        if !(low < t && t < high) {
            break;
        }
        let x = value(coefficients, t);
        if x == 0.0 {
            return t;
        }
        if (x < 0.0) == (at_low < 0.0) {
            (low, at_low) = (t, x);
            if side == 1 {
                at_high *= 0.5;
            }
            side = 1;
        } else {
            (high, at_high) = (t, x);
            if side == 2 {
                at_low *= 0.5;
            }
            side = 2;
        }
        if high - low <= f64::EPSILON * high {
            break;
        }
    }
    0.5 * (low + high)
}
