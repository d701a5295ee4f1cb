//! Where a polynomial in the Bernstein basis changes its sign.

/// The most coefficients that are asked for.
const MOST: usize = 8;

/// The parameters in (0, 1) at which a polynomial changes its sign, rising, each to the nearest numbers or so.
///
/// A polynomial has no more roots in an interval than its coefficients there have changes of sign, and one if they have one: so
/// intervals are halved until they have one change, or are too short to halve.
///
/// # References
/// R. T. Farouki, V. T. Rajan, *On the numerical condition of polynomials in Bernstein form* (1987); J. M. Lane, R. F. Riesenfeld,
/// *Bounds on a polynomial* (1981).
pub(crate) fn sign_changes(coefficients: &[f64]) -> Vec<f64> {
    let mut found = Vec::new();
    if change_count(coefficients) == 0 {
        return found;
    }
    let mut first = [0.0; MOST];
    first[..coefficients.len()].copy_from_slice(coefficients);
    let mut intervals = vec![(first, 0.0, 1.0)];
    while let Some((own, low, high)) = intervals.pop() {
        let own_coefficients = &own[..coefficients.len()];
        let changes = change_count(own_coefficients);
        if changes == 0 {
            continue;
        }
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high || high - low < f64::EPSILON * 0.25 {
            // An even number of changes in so short an interval is a touch.
            if changes % 2 == 1 {
                found.push(middle);
            }
            continue;
        }
        if changes == 1 && own[0] != 0.0 && own[coefficients.len() - 1] != 0.0 {
            found.push(low + (high - low) * bracketed(own_coefficients));
            continue;
        }
        let [before, after] = halves(own_coefficients);
        // A root at the middle is at the end of both halves, where it does not count.
        if after[0] == 0.0 && change_count(&[before[coefficients.len() - 2], after[1]]) == 1 {
            found.push(middle);
        }
        intervals.push((after, middle, high));
        intervals.push((before, low, middle));
    }
    found.retain(|&s| 0.0 < s && s < 1.0);
    found.sort_unstable_by(f64::total_cmp);
    found.dedup();
    found
}

/// The changes of sign, without zeros.
fn change_count(coefficients: &[f64]) -> usize {
    let mut last = 0.0;
    let mut count = 0;
    for &x in coefficients {
        if x != 0.0 {
            count += usize::from(last * x.signum() < 0.0);
            last = x.signum();
        }
    }
    count
}

fn halves(coefficients: &[f64]) -> [[f64; MOST]; 2] {
    let count = coefficients.len();
    let (mut before, mut after) = ([0.0; MOST], [0.0; MOST]);
    after[..count].copy_from_slice(coefficients);
    before[0] = after[0];
    for (step, own) in before[..count].iter_mut().enumerate().skip(1) {
        for j in 0..count - step {
            after[j] = 0.5 * after[j] + 0.5 * after[j + 1];
        }
        *own = after[0];
    }
    [before, after]
}

fn value(coefficients: &[f64], s: f64) -> f64 {
    let mut points = [0.0; MOST];
    points[..coefficients.len()].copy_from_slice(coefficients);
    for left in (1..coefficients.len()).rev() {
        for j in 0..left {
            points[j] = (1.0 - s) * points[j] + s * points[j + 1];
        }
    }
    points[0]
}

/// The only change of sign in (0, 1): false position with the Illinois rule, and every fourth time the middle.
fn bracketed(coefficients: &[f64]) -> f64 {
    let [mut low, mut high] = [0.0, 1.0];
    let [mut at_low, mut at_high] = [coefficients[0], coefficients[coefficients.len() - 1]];
    let mut moved_last = None;
    let mut step = 0;
    loop {
        step += 1;
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high || high - low < f64::EPSILON * 0.25 {
            return middle;
        }
        let guess = (low * at_high - high * at_low) / (at_high - at_low);
        let t = if step % 4 != 0 && low < guess && guess < high { guess } else { middle };
        let x = value(coefficients, t);
        if x == 0.0 {
            return t;
        }
        let moves_low = (x < 0.0) == (coefficients[0] < 0.0);
        // An end that stays twice counts half.
        let is_again = moved_last == Some(moves_low);
        if moves_low {
            (low, at_low) = (t, x);
            at_high *= if is_again { 0.5 } else { 1.0 };
        } else {
            (high, at_high) = (t, x);
            at_low *= if is_again { 0.5 } else { 1.0 };
        }
        moved_last = Some(moves_low);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_are_found_where_they_are() {
        assert_eq!(sign_changes(&[-1.0, 1.0]), [0.5]);
        assert!(sign_changes(&[1.0, 1.0, 1.0]).is_empty());
        // (1 - 2s)^2 touches zero.
        assert!(sign_changes(&[1.0, -1.0, 1.0]).is_empty());
        // s (1 - s) is zero at both ends only.
        assert!(sign_changes(&[0.0, 0.5, 0.0]).is_empty());
        // (s - 1/4)(s - 1/2)(s - 3/4), in the power basis -3/32 + 11/16 s - 3/2 s^2 + s^3.
        let power = [-3.0 / 32.0, 11.0 / 16.0, -1.5, 1.0];
        let cubic: Vec<f64> = (0..4usize)
            .map(|j| {
                (0..=j)
                    .map(|k| {
                        power[k] * [1.0, j as f64, (j * j.saturating_sub(1)) as f64 / 2.0, 1.0][k]
                            / [1.0, 3.0, 3.0, 1.0][k]
                    })
                    .sum()
            })
            .collect();
        let found = sign_changes(&cubic);
        assert_eq!(found.len(), 3, "{found:?}");
        for (found, right) in found.iter().zip([0.25, 0.5, 0.75]) {
            assert!((found - right).abs() < 1e-15);
        }
    }
}
