//! Pieces that run side by side: whether they stay apart, or within the resolution of each other.

use super::polynomial::{cross, dot, minus};
use super::{Frame, Polynomial};

/// How two pieces lie that run in nearly one direction or against each other.
pub(super) enum SideBySide {
    /// No points of them are within the resolution of each other.
    Apart,
    /// Between these parameters, each in [0, 1], all points of one are within the resolution of the other, or twice that if it is fine; elsewhere no points are
    /// opposite each other.
    Near([[f64; 2]; 2]),
    /// Neither is certain.
    Unclear,
}

/// The steepest that a piece is over a direction, if it is a graph over it.
fn slope(piece: &Polynomial, axis: [f64; 2]) -> Option<f64> {
    let mut steepest: f64 = 0.0;
    let mut direction = 0.0;
    for pair in piece.controls().windows(2) {
        let step = minus(pair[1], pair[0]);
        let along = dot(axis, step);
        if along == 0.0 || along * direction < 0.0 {
            return None;
        }
        direction = along;
        steepest = steepest.max((cross(axis, step) / along).abs());
    }
    Some(steepest)
}

/// The parameter at which a piece, a graph over a direction, is above a place of it; it may be outside of [0, 1].
fn above(piece: &Polynomial, axis: [f64; 2], place: f64) -> f64 {
    let mut t = (place - dot(axis, piece.first())) / dot(axis, piece.chord());
    for _ in 0..3 {
        let [point, derivative, _] = piece.jet(t);
        t -= (dot(axis, point) - place) / dot(axis, derivative);
    }
    t
}

/// Compares pieces as graphs over the chord of the first, by the polynomial $D(t) = A(t) - B(\varphi(t))$ with linear $\varphi$ that
/// brings equal places together up to a small offset e: where B is nowhere steeper than m, its graph is off $A(t)$ by the part of D
/// across the chord, up to $m e$.
pub(super) fn side_by_side(a: &Polynomial, b: &Polynomial, frame: Frame) -> SideBySide {
    let resolution = frame.resolution;
    /// Far above rounding of control points between -1 and 1.
    const ROUNDING: f64 = 1.0 / (1u64 << 47) as f64;
    let chord = a.chord();
    let length = chord[0].hypot(chord[1]);
    if length <= 4.0 * resolution {
        return SideBySide::Unclear;
    }
    let axis = chord.map(|x| x / length);
    let (Some(_), Some(of_b)) = (slope(a, axis), slope(b, axis)) else { return SideBySide::Unclear };
    let [from, to] = [a.first(), a.last()].map(|point| above(b, axis, dot(axis, point)));
    // Also false for what is not a number.
    if !((-0.5..=1.5).contains(&from) && (-0.5..=1.5).contains(&to) && from != to) {
        return SideBySide::Unclear;
    }
    let opposite = b.part([from, to]);
    let Some(of_opposite) = slope(&opposite, axis) else { return SideBySide::Unclear };
    let steepest = of_b.max(of_opposite);
    let [mut low, mut high, mut offset] = [f64::INFINITY, f64::NEG_INFINITY, 0.0f64];
    for (&p, &q) in a.controls().iter().zip(opposite.controls()) {
        let difference = minus(p, q);
        let across = cross(axis, difference);
        low = low.min(across);
        high = high.max(across);
        offset = offset.max(dot(axis, difference).abs());
    }
    let doubt = steepest * (offset + resolution) + ROUNDING;
    if low.max(-high) > doubt + resolution {
        return SideBySide::Apart;
    }
    // At a fine resolution, of which the doubt is a large part, one of both has to be certain where the distance hardly changes.
    let near = if frame.is_fine { 2.0 * resolution } else { resolution };
    if high.max(-low) + doubt <= near {
        // Where the parameters opposite each other are in [0, 1] for both.
        let place = |s: f64| ((s - from) / (to - from)).clamp(0.0, 1.0);
        let [s, t] = [place(0.0), place(1.0)];
        let of_a = [s.min(t), s.max(t)];
        let [s, t] = of_a.map(|t| (from + t * (to - from)).clamp(0.0, 1.0));
        if of_a[0] < of_a[1] && s != t {
            return SideBySide::Near([of_a, [s.min(t), s.max(t)]]);
        }
    }
    SideBySide::Unclear
}
