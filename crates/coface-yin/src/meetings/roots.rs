//! The one point where two pieces cross whose tangents are nowhere parallel.

use super::Polynomial;
use super::polynomial::{cross, minus, size};

/// A bound on the error of the difference of two points, whatever halvings the pieces come from.
const GAP_ERROR: f64 = 1.0 / (1u64 << 46) as f64;
/// Steps of Newton's iteration that are tried.
const STEPS: usize = 14;
/// How far beyond the ends of a piece the iteration may go.
const OUTSIDE: f64 = 0.25;

/// The part of a piece that a root is told up to at least.
const LARGEST_RADIUS: f64 = 1.0 / 32.0;
/// The part of a proven box in which the root lies; in all of it there is no other.
pub(super) const IMAGE: f64 = 0.75;

/// What is known of the common points of two pieces without parallel tangents.
pub(super) enum Transversal {
    /// There is one, with parameters that are proven to lie within these distances; it may be beyond an end by less than the
    /// resolution or the uncertainty.
    Root { at: [f64; 2], radii: [f64; 2] },
    /// There is none.
    Nothing,
    /// The pieces are too long to tell.
    Unknown,
}

/// Looks for the root of $A(t) - B(s)$ for two pieces of which [`Polynomial::is_transversal`] holds, so that there is one at most.
///
/// Existence is proven by the operator of Krawczyk: with the inverse of the Jacobian at the approximate root as preconditioner, the
/// image of a box around it lies in the box.
pub(super) fn transversal_root(a: &Polynomial, b: &Polynomial, resolution: f64) -> Transversal {
    let [mut t, mut s] = [0.5, 0.5];
    let mut is_found = false;
    for _ in 0..STEPS {
        let [p, d, _] = a.jet(t);
        let [q, e, _] = b.jet(s);
        let gap = minus(q, p);
        let turn = cross(d, e);
        if turn == 0.0 {
            return Transversal::Unknown;
        }
        let step = [cross(gap, e) / turn, cross(gap, d) / turn];
        let next = [t + step[0], s + step[1]].map(|x| x.clamp(-OUTSIDE, 1.0 + OUTSIDE));
        let moved = (next[0] - t).abs().max((next[1] - s).abs());
        [t, s] = next;
        if moved <= 1e-10 {
            is_found = true;
            break;
        }
    }
    if !is_found {
        return Transversal::Unknown;
    }
    let [p, d, _] = a.jet(t);
    let [q, e, _] = b.jet(s);
    let gap = minus(q, p);
    let turn = cross(d, e);
    if turn == 0.0 {
        return Transversal::Unknown;
    }
    // One more step costs nothing.
    t += cross(gap, e) / turn;
    s += cross(gap, d) / turn;
    let error = size(gap) + GAP_ERROR;
    let radii = [2.0 * error * size(e) / turn.abs(), 2.0 * error * size(d) / turn.abs()];
    // The second derivatives may be larger beyond the ends, up to (1 + 2 OUTSIDE)^(degree - 2).
    let bend = |piece: &Polynomial, radius: f64| 8.0 * piece.largest_second_derivative() * radius * radius;
    // Also false for what is not a number. The image of the box is three quarters of it or less.
    let is_proven = bend(a, radii[0]) + bend(b, radii[1]) <= 0.5 * error;
    // Where a root may be anywhere on the pieces, nothing is told.
    if !is_proven || radii.iter().any(|&radius| radius > LARGEST_RADIUS) {
        return Transversal::Unknown;
    }
    let beyond = [t, s].map(|x| (-x).max(x - 1.0).max(0.0));
    let is_inside = |k: usize, slope: [f64; 2]| {
        beyond[k] <= radii[k] || (beyond[k] * slope[0].abs().max(slope[1].abs()) <= resolution)
    };
    if is_inside(0, d) && is_inside(1, e) {
        return Transversal::Root { at: [t, s], radii };
    }
    // There is no second root where no tangents are parallel on the way to the first one.
    let reaching = |piece: &Polynomial, t: f64| {
        if t < 0.0 {
            piece.split(t)[1]
        } else if t > 1.0 {
            piece.split(t)[0]
        } else {
            *piece
        }
    };
    if reaching(a, t).is_transversal(&reaching(b, s)) { Transversal::Nothing } else { Transversal::Unknown }
}
