//! Arcs that two pieces have in common.

use super::polynomial::{dot, is_apart, is_near, minus, size};
use super::simple_fractions::{Fraction, is_part};
use super::{Overlap, Pieces, Polynomial};

/// How many times the resolution the ends of an overlap are apart at least.
const LEAST_LENGTH: f64 = 16.0;

/// The overlaps of two pieces, of which one at least is no segment.
///
/// Equal control points, in the same or the opposite order, are one arc for certain, and a cubic that is a part of another between
/// parameters that are simple fractions. Else ends of one that are within the resolution
/// of the other are the ends of a common arc when at more places between them than two different algebraic curves of these degrees
/// can share, the product of the degrees, the pieces are within the resolution of each other.
pub(super) fn overlaps_of(pieces: &Pieces<'_>, pair: [u32; 2]) -> Vec<Overlap> {
    let [p, q] = pair.map(|piece| piece as usize);
    let [a, b] = [pieces.polynomial(p), pieces.polynomial(q)];
    if a.controls() == b.controls() {
        return vec![Overlap { pieces: pair, ranges: [[0.0, 1.0], [0.0, 1.0]], is_certified: true }];
    }
    if a.controls().iter().eq(b.controls().iter().rev()) {
        return vec![Overlap { pieces: pair, ranges: [[0.0, 1.0], [1.0, 0.0]], is_certified: true }];
    }
    let tolerance = pieces.frame.resolution;
    // Whether the ends of one are in the hull of the other; an end of both is one point.
    let is_in = |hull: &Polynomial, point: [f64; 2]| !is_apart(hull.controls(), &[point; 2], tolerance);
    let ends = [a.first(), a.last()].map(|end| is_in(&b, end));
    let other_ends = [b.first(), b.last()].map(|end| is_in(&a, end));
    let is_shared = [b.first(), b.last()].map(|end| end == a.first() || end == a.last());
    let counts = ends.into_iter().chain((0..2).map(|k| other_ends[k] && !is_shared[k]));
    if counts.filter(|counts| *counts).count() < 2 {
        return Vec::new();
    }
    let mut common: Vec<[f64; 2]> = Vec::new();
    let mut add = |at: [f64; 2]| {
        let point = a.at(at[0]);
        let is_new = common.iter().all(|known| {
            !is_near(a.at(known[0]), point, LEAST_LENGTH * tolerance)
                || !is_near(b.at(known[1]), b.at(at[1]), LEAST_LENGTH * tolerance)
                || (known[0] - at[0]).abs() > 0.5
                || (known[1] - at[1]).abs() > 0.5
        });
        if is_new {
            common.push(at);
        }
    };
    let mut near = Vec::new();
    for (i, end) in [a.first(), a.last()].into_iter().enumerate().filter(|(i, _)| ends[*i]) {
        near_parameters(&b, end, tolerance, &mut near);
        near.iter().for_each(|&s| add([i as f64, s]));
    }
    for (j, end) in [b.first(), b.last()].into_iter().enumerate().filter(|(j, _)| other_ends[*j]) {
        near_parameters(&a, end, tolerance, &mut near);
        near.iter().for_each(|&t| add([t, j as f64]));
    }
    if common.len() < 2 {
        return Vec::new();
    }
    common.sort_by(|x, y| x[0].total_cmp(&y[0]).then(x[1].total_cmp(&y[1])));
    let mut found: Vec<Overlap> = Vec::new();
    for ends in common.windows(2) {
        let ranges = [[ends[0][0], ends[1][0]], [ends[0][1], ends[1][1]]];
        if !is_common(&a, &b, ranges, tolerance) {
            continue;
        }
        if let Some(before) = found.last_mut().filter(|before| {
            let ends = [before.ranges[0][1], before.ranges[1][1]];
            let is_same_way = (before.ranges[1][1] > before.ranges[1][0]) == (ranges[1][1] > ranges[1][0]);
            ends == [ranges[0][0], ranges[1][0]] && is_same_way
        }) {
            [before.ranges[0][1], before.ranges[1][1]] = [ranges[0][1], ranges[1][1]];
        } else {
            found.push(Overlap { pieces: pair, ranges, is_certified: false });
        }
    }
    found.iter_mut().for_each(|overlap| certify(pieces, overlap));
    found
}

/// Tells whether what two cubic pieces have in common is one cubic for certain: the parameters of one at the ends of the other, if it went on
/// so far, are simple fractions then.
fn certify(pieces: &Pieces<'_>, overlap: &mut Overlap) {
    /// Fractions are looked for so near to what was found.
    const NEAR: f64 = 1e-9;
    let given = overlap.pieces.map(|piece| pieces.given(piece as usize));
    let cubic = |k: usize| <[[f64; 2]; 4]>::try_from(given[k]).ok();
    let (Some(a), Some(b)) = (cubic(0), cubic(1)) else { return };
    let [of_a, of_b] = overlap.ranges;
    let opposite = |s: f64| of_a[0] + (s - of_b[0]) * (of_a[1] - of_a[0]) / (of_b[1] - of_b[0]);
    let ends = [0.0, 1.0].map(|s| Fraction::near(opposite(s), NEAR));
    let [Some(from), Some(to)] = ends else { return };
    overlap.is_certified = is_part(&a, &b, [from, to]);
}

/// Whether pieces stay within the resolution of each other between parameters.
fn is_common(a: &Polynomial, b: &Polynomial, [of_a, of_b]: [[f64; 2]; 2], tolerance: f64) -> bool {
    if of_a[0] == of_a[1] || of_b[0] == of_b[1] {
        return false;
    }
    let count = a.degree() * b.degree() + 1;
    let [low, high] = [of_b[0].min(of_b[1]), of_b[0].max(of_b[1])];
    (1..=count).all(|i| {
        let part = i as f64 / (count + 1) as f64;
        let point = a.at(of_a[0] + part * (of_a[1] - of_a[0]));
        let guess = of_b[0] + part * (of_b[1] - of_b[0]);
        place(b, point, guess, [low, high], tolerance).is_some()
    })
}

/// The parameter in a range at which a piece is within a distance of a point: that next to a guess, or where a search finds one.
///
/// Newton's iteration finds none where the piece nearly stands still at the guess.
fn place(piece: &Polynomial, point: [f64; 2], guess: f64, range: [f64; 2], tolerance: f64) -> Option<f64> {
    let s = foot(piece, point, guess).clamp(range[0], range[1]);
    if is_near(piece.at(s), point, tolerance) {
        return Some(s);
    }
    let mut found = Vec::new();
    near_parameters(piece, point, tolerance, &mut found);
    found.retain(|s| (range[0]..=range[1]).contains(s));
    found.into_iter().min_by(|s, t| (s - guess).abs().total_cmp(&(t - guess).abs()))
}

/// The parameter of the second piece opposite one of the first, between which they have an arc in common.
///
/// Two pieces run through a common arc at different speeds, unless they are parts of one polynomial.
pub(super) fn opposite_on_arc(
    [a, b]: [&Polynomial; 2],
    [of_a, of_b]: [[f64; 2]; 2],
    t: f64,
    tolerance: f64,
) -> f64 {
    if let Some(end) = (0..2).find(|&end| t == of_a[end]) {
        return of_b[end];
    }
    let guess = of_b[0] + (t - of_a[0]) * (of_b[1] - of_b[0]) / (of_a[1] - of_a[0]);
    let range = [of_b[0].min(of_b[1]), of_b[0].max(of_b[1])];
    // The ends of the arc are within the resolution of each other, and what is between them is too.
    place(b, a.at(t), guess, range, 2.0 * tolerance).unwrap_or(guess)
}

/// The parameter of the nearest point of a piece, from a guess: the root of $(B(s) - P) \cdot B'(s)$.
pub(super) fn foot(piece: &Polynomial, point: [f64; 2], guess: f64) -> f64 {
    let mut s = guess;
    for _ in 0..8 {
        let [at, d, e] = piece.jet(s);
        let to = minus(at, point);
        let slope = dot(d, d) + dot(to, e);
        // Where the distance is not convex the plain step of Gauss and Newton is taken.
        let slope = if slope > 0.25 * dot(d, d) { slope } else { dot(d, d) };
        if slope == 0.0 {
            break;
        }
        let next = (s - dot(to, d) / slope).clamp(-0.25, 1.25);
        let is_done = (next - s).abs() <= 4.0 * f64::EPSILON;
        s = next;
        if is_done {
            break;
        }
    }
    s
}

/// The parameters at which a piece comes within a distance of a point: one for each run of them, 0 or 1 where the run has an end.
pub(super) fn near_parameters(piece: &Polynomial, point: [f64; 2], tolerance: f64, found: &mut Vec<f64>) {
    found.clear();
    if is_near(piece.first(), point, tolerance) {
        found.push(0.0);
    }
    if is_near(piece.last(), point, tolerance) {
        found.push(1.0);
    }
    let mut stack = vec![(*piece, [0.0, 1.0])];
    while let Some((own, [low, high])) = stack.pop() {
        let [least, most] = own.bounds();
        if (0..2).any(|k| point[k] < least[k] - tolerance || point[k] > most[k] + tolerance) {
            continue;
        }
        let middle = 0.5 * (low + high);
        let is_straight = own.largest_second_derivative() <= 0.25 * size(own.chord());
        if is_straight || high - low < 1e-9 {
            let s = foot(piece, point, middle).clamp(low, high);
            if is_near(piece.at(s), point, tolerance) {
                // The same place as a known one unless the way between them leads away.
                let is_known = found.iter().any(|&known| {
                    let way = piece.part([known.min(s), known.max(s)]).bounds();
                    (0..2).all(|k| way[1][k] - way[0][k] <= 8.0 * tolerance)
                });
                if !is_known {
                    found.push(s);
                }
            }
            continue;
        }
        let [before, after] = own.split(0.5);
        stack.push((after, [middle, high]));
        stack.push((before, [low, middle]));
    }
}
