//! Whether two cubic pieces with a common end have another common point near it, by exact arithmetic.

use coface_geometry::predicates::Dyadic;

/// The coefficients of a polynomial, the constant one first.
pub(super) type Coefficients = Vec<Dyadic>;

/// Whether two cubic pieces that begin in one point have, for certain, no other common point up to a parameter of the first.
///
/// The resultant of $x_B(s) - x_A(t)$ and $y_B(s) - y_A(t)$ by s, the determinant of Bezout, is a polynomial $F(t) = t^m G(t)$ of degree
/// 9 that is zero wherever $A(t)$ is on $B$ or its continuation. There is no such place where the constant coefficient of G is larger
/// than all others together can be.
///
/// # References
/// T. W. Sederberg, D. C. Anderson, R. N. Goldman, *Implicit representation of parametric curves and surfaces* (1984).
pub(super) fn has_no_other_point(a: &[[f64; 2]; 4], b: &[[f64; 2]; 4], reach: f64) -> bool {
    let origin = a[0];
    if b[0] != origin {
        return false;
    }
    let of_a = [0, 1].map(|axis| power_coefficients(a.map(|point| point[axis]), origin[axis]));
    let of_b = [0, 1].map(|axis| power_coefficients(b.map(|point| point[axis]), origin[axis]));
    is_alone(&of_a, &of_b, reach)
}

/// The same for cubics by their power coefficients, the constant ones zero; up to a parameter of the first in both directions.
pub(super) fn is_alone(of_a: &[Coefficients; 2], of_b: &[Coefficients; 2], reach: f64) -> bool {
    is_away_from_roots(resultant(of_a, of_b).into_iter().skip_while(|c| c.sign().is_eq()), reach)
}

/// Whether two cubic pieces that begin in one point have, for certain, no common point where the parameter of the first is between
/// two numbers.
///
/// As in [`has_no_other_point`], with the polynomial around the middle of the interval, or of its halves and their halves: it may have
/// roots next to the common end, which is where rounding puts some.
pub(super) fn has_no_point_between(a: &[[f64; 2]; 4], b: &[[f64; 2]; 4], range: [f64; 2]) -> bool {
    /// How often the interval is halved.
    const DEPTH: usize = 16;
    let origin = a[0];
    if b[0] != origin {
        return false;
    }
    let of = |piece: &[[f64; 2]; 4]| {
        [0, 1].map(|axis| power_coefficients(piece.map(|point| point[axis]), origin[axis]))
    };
    let resultant = resultant(&of(a), &of(b));
    let mut waiting = vec![(range, DEPTH)];
    while let Some(([low, high], depth)) = waiting.pop() {
        let middle = 0.5 * (low + high);
        // Also false for what is not a number.
        if !(low < middle && middle < high) {
            return false;
        }
        let reach = (middle - low).max(high - middle).next_up();
        if is_away_from_roots(around(&resultant, middle).into_iter(), reach) {
            continue;
        }
        if depth == 0 {
            return false;
        }
        waiting.extend([[low, middle], [middle, high]].map(|half| (half, depth - 1)));
    }
    true
}

/// Whether the constant coefficient of a polynomial is larger than all others together can be, up to an argument.
fn is_away_from_roots(coefficients: impl Iterator<Item = Dyadic>, reach: f64) -> bool {
    let mut others = coefficients.map(|c| size(&c));
    let Some(constant) = others.next() else { return false };
    let reach = Dyadic::from(reach);
    let mut power = reach.clone();
    let mut sum = Dyadic::from(0.0);
    for coefficient in others {
        sum = &sum + &(&coefficient * &power);
        power = &power * &reach;
    }
    (&constant - &sum).sign().is_gt()
}

/// The coefficients of a polynomial in the argument from a number on.
pub(super) fn around(coefficients: &[Dyadic], at: f64) -> Coefficients {
    let at = Dyadic::from(at);
    let mut found = coefficients.to_vec();
    // Horner's scheme, again and again.
    for first in 0..found.len() {
        for k in (first..found.len() - 1).rev() {
            found[k] = &found[k] + &(&at * &found[k + 1]);
        }
    }
    found
}

/// The resultant by s of $x_B(s) - x_A(t)$ and $y_B(s) - y_A(t)$, by the power coefficients of both cubics, the constant ones of
/// B zero.
pub(super) fn resultant(of_a: &[Coefficients; 2], of_b: &[Coefficients; 2]) -> Coefficients {
    // The coefficients of both polynomials in s; the constant ones are polynomials in t.
    let coefficient = |axis: usize, power: usize| -> Coefficients {
        if power == 0 { of_a[axis].iter().map(|c| -c).collect() } else { vec![of_b[axis][power].clone()] }
    };
    let entry = |i: usize, j: usize| {
        let mut sum = Vec::new();
        for k in 0..=i.min(2 - j) {
            let [up, down] = [j + k + 1, i - k];
            sum = plus(&sum, &times(&coefficient(0, up), &coefficient(1, down)));
            sum = minus(&sum, &times(&coefficient(0, down), &coefficient(1, up)));
        }
        sum
    };
    let [e00, e01, e02, e11, e12, e22] =
        [[0, 0], [0, 1], [0, 2], [1, 1], [1, 2], [2, 2]].map(|[i, j]| entry(i, j));
    // The matrix is symmetric.
    let minor = |a: &Coefficients, b: &Coefficients, c: &Coefficients, d: &Coefficients| {
        minus(&times(a, d), &times(b, c))
    };
    let first = times(&e00, &minor(&e11, &e12, &e12, &e22));
    let second = times(&e01, &minor(&e01, &e12, &e02, &e22));
    let third = times(&e02, &minor(&e01, &e11, &e02, &e12));
    plus(&minus(&first, &second), &third)
}

/// The power coefficients of a cubic from those in the Bernstein basis, less a constant.
pub(super) fn power_coefficients(controls: [f64; 4], constant: f64) -> Coefficients {
    let constant = Dyadic::from(constant);
    let mut differences: Vec<Dyadic> = controls.iter().map(|&x| &Dyadic::from(x) - &constant).collect();
    [1.0, 3.0, 3.0, 1.0]
        .into_iter()
        .map(|binomial| {
            let found = &differences[0] * &Dyadic::from(binomial);
            differences = differences.windows(2).map(|pair| &pair[1] - &pair[0]).collect();
            found
        })
        .collect()
}

pub(super) fn size(x: &Dyadic) -> Dyadic {
    if x.sign().is_lt() { -x } else { x.clone() }
}

fn combined(a: &[Dyadic], b: &[Dyadic], with: impl Fn(&Dyadic, &Dyadic) -> Dyadic) -> Coefficients {
    let zero = Dyadic::from(0.0);
    (0..a.len().max(b.len())).map(|k| with(a.get(k).unwrap_or(&zero), b.get(k).unwrap_or(&zero))).collect()
}

fn plus(a: &[Dyadic], b: &[Dyadic]) -> Coefficients {
    combined(a, b, |x, y| x + y)
}

fn minus(a: &[Dyadic], b: &[Dyadic]) -> Coefficients {
    combined(a, b, |x, y| x - y)
}

fn times(a: &[Dyadic], b: &[Dyadic]) -> Coefficients {
    let mut found = vec![Dyadic::from(0.0); (a.len() + b.len()).saturating_sub(1)];
    for (i, x) in a.iter().enumerate() {
        for (j, y) in b.iter().enumerate() {
            found[i + j] = &found[i + j] + &(x * y);
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arcs_that_touch_in_their_end() {
        // Mirror images in a line that both touch.
        let upper = [[0.125, 0.0], [1.125, 0.0], [2.0, 0.75], [2.5, 2.0]];
        let lower = upper.map(|[x, y]| [x, -y]);
        assert!(has_no_other_point(&upper, &lower, 1e-4));
        assert!(has_no_other_point(&lower, &upper, 1e-4));
        // One that bends more, on the same side.
        let steeper = [[0.125, 0.0], [1.125, 0.0], [2.0, 1.5], [2.5, 4.0]];
        assert!(has_no_other_point(&upper, &steeper, 1e-4));
        // The same arc, a part of it, and one that begins elsewhere.
        assert!(!has_no_other_point(&upper, &upper, 1e-4));
        let half = &crate::curve::bernstein::split(&upper, 0.5)[0];
        assert!(!has_no_other_point(&upper, &[0, 1, 2, 3].map(|j| half[j]), 1e-4));
        assert!(!has_no_other_point(&upper, &upper.map(|[x, y]| [x, y + 1.0]), 1e-4));
    }

    #[test]
    fn a_second_crossing_near_the_end_is_seen() {
        // y = x^2 and y = x^3 + x^2 - x / 1024 ... cross at 0 and near 1 / 32.
        let parabola = [[0.0, 0.0], [1.0, 0.0], [2.0, 3.0], [3.0, 9.0]];
        let cubic =
            |slope: f64| [[0.0, 0.0], [1.0, slope], [2.0, 2.0 * slope + 3.0], [3.0, 3.0 * slope + 36.0]];
        // With x = 3 s: 9 s^2 against 27 s^3 + 9 s^2 + 3 slope s.
        let slope = -1.0 / 4096.0;
        assert!(has_no_other_point(&parabola, &cubic(slope), 1e-3));
        assert!(!has_no_other_point(&parabola, &cubic(slope), 1e-2));
        // The crossing is at 1 / 192.
        assert!(has_no_point_between(&parabola, &cubic(slope), [1e-6, 5.2e-3]));
        assert!(!has_no_point_between(&parabola, &cubic(slope), [5.2e-3, 5.21e-3]));
        assert!(has_no_point_between(&parabola, &cubic(slope), [5.21e-3, 1.0]));
    }

    /// Both arcs turn alike at their common end, but for rounding, which makes their continuations cross near it.
    #[test]
    fn arcs_are_apart_between_parameters() {
        let first = [
            [0.0, -0.5],
            [0.022898896049784862, -0.5],
            [0.045797792099569724, -0.4989512811194023],
            [0.06860063013082557, -0.4970459593952649],
        ];
        let second = [
            [0.0, -0.5],
            [0.02679491924311228, -0.5],
            [0.04928203230275511, -0.49856406460551017],
            [0.068, -0.496],
        ];
        assert!(!has_no_other_point(&first, &second, 1e-4));
        assert!(has_no_point_between(&first, &second, [1e-6, 1e-3]));
        assert!(has_no_point_between(&first, &second, [1e-12, 1e-9]));
        assert!(!has_no_point_between(&first, &second, [0.0, 1e-3]));
        assert!(!has_no_point_between(&first, &first, [1e-6, 1e-3]));
        assert!(!has_no_point_between(&first, &second, [f64::NAN, 1e-3]));
    }

    #[test]
    fn a_polynomial_around_a_number_has_the_same_values() {
        // (t - 1) (t - 2) (t - 3) from 2 on is (t + 1) t (t - 1).
        let found = around(&[-6.0, 11.0, -6.0, 1.0].map(Dyadic::from), 2.0);
        let expected = [0.0, -1.0, 0.0, 1.0].map(Dyadic::from);
        assert!(found.iter().zip(&expected).all(|(a, b)| (a - b).sign().is_eq()) && found.len() == 4);
        assert!(around(&[], 2.0).is_empty());
    }
}
