//! All that two cubic pieces have in common, by exact arithmetic, however near to each other they run.

use super::isolation::places_on;
use super::overlaps::{foot, near_parameters};
use super::polynomial::minus;
use super::segments::enclosure;
use super::{Meeting, Pieces};

/// How well a parameter of the second piece is known at least.
const DOUBT: f64 = 1e-11;

/// A common point on the way along the first piece.
struct Place {
    /// Numbers between which the parameter is.
    own: [f64; 2],
    /// The parameter on the other piece.
    other: f64,
    /// Whether both pieces end here.
    is_end: bool,
}

/// The control points of two different pieces if they are cubics that are not straight.
pub(super) fn cubics(pieces: &Pieces<'_>, pair: [u32; 2]) -> Option<[[[f64; 2]; 4]; 2]> {
    if pair[0] == pair[1] || pair.iter().any(|&piece| pieces.is_straight(piece as usize)) {
        return None;
    }
    let [a, b] = pair.map(|piece| <[[f64; 2]; 4]>::try_from(pieces.given(piece as usize)).ok());
    Some([a?, b?])
}

/// The meetings of two cubic pieces at a fine resolution: all their crossings, and their common ends where they are not neighbors there.
/// Nothing where exact arithmetic does not tell: they touch, are parts of one cubic, cross within rounding of an end, or are nearer to
/// each other all the way between two crossings than rounding of results.
pub(super) fn meetings_of_cubics(pieces: &Pieces<'_>, pair: [u32; 2]) -> Option<Vec<Meeting>> {
    if !pieces.frame.is_fine {
        return None;
    }
    let cubics = cubics(pieces, pair)?;
    [0, 1].into_iter().find_map(|own| meetings_along(pieces, pair, &cubics, own))
}

/// The same with the places on one of both.
fn meetings_along(
    pieces: &Pieces<'_>,
    pair: [u32; 2],
    cubics: &[[[f64; 2]; 4]; 2],
    own: usize,
) -> Option<Vec<Meeting>> {
    /// What points of pieces are off at most, in coordinates of the frame, several times.
    const NEAR: f64 = 64.0 * f64::EPSILON;
    let [a, b] = [cubics[own], cubics[1 - own]];
    let [p, q] = [own, 1 - own].map(|k| pieces.polynomial(pair[k] as usize));
    let common = |end: usize| [0, 3].iter().position(|&other| a[3 * end] == b[other]);
    let ends = [0, 1].map(common);
    let mut places: Vec<Place> = Vec::new();
    if let Some(other) = ends[0] {
        places.push(Place { own: [0.0; 2], other: other as f64, is_end: true });
    }
    let mut near = Vec::new();
    for place in places_on(&a, &b, [0.0, 1.0], ends.map(|end| end.is_some()))? {
        near_parameters(&q, p.at(0.5 * (place[0] + place[1])), NEAR, &mut near);
        match near[..] {
            // On the continuation of the other one.
            [] => {}
            [s] if s > DOUBT && s < 1.0 - DOUBT => places.push(Place { own: place, other: s, is_end: false }),
            _ => return None,
        }
    }
    if let Some(other) = ends[1] {
        places.push(Place { own: [1.0; 2], other: other as f64, is_end: true });
    }
    // Crossings so near to a common end that rounding may make them are no more than the end.
    let gap = |from: &Place, to: &Place| {
        let point = p.at(0.5 * (from.own[1] + to.own[0]));
        let [x, y] = minus(q.at(foot(&q, point, 0.5 * (from.other + to.other)).clamp(0.0, 1.0)), point);
        x.hypot(y)
    };
    let mut is_certified = vec![true; places.len()];
    let mut is_dropped = vec![false; places.len()];
    for at in 1..places.len() {
        let [before, after] = [&places[at - 1], &places[at]];
        if gap(before, after) > pieces.frame.finest {
            continue;
        }
        match [before.is_end, after.is_end] {
            [true, false] => (is_certified[at - 1], is_dropped[at]) = (false, true),
            [false, true] => (is_dropped[at - 1], is_certified[at]) = (true, false),
            _ => return None,
        }
    }
    let kept = places.iter().zip(is_certified.into_iter().zip(is_dropped));
    let meeting = |(place, (is_certified, is_dropped)): (&Place, (bool, bool))| {
        let t = 0.5 * (place.own[0] + place.own[1]);
        let ordered = |x: [f64; 2]| if own == 0 { x } else { [x[1], x[0]] };
        let at = ordered([t, place.other]);
        let is_joint = || pieces.joints(pair).any(|ends| ends.map(|end| end as f64) == at);
        if is_dropped || (place.is_end && is_joint()) {
            return None;
        }
        let point = if t == 0.0 || t == 1.0 {
            pieces.ends(pair[own] as usize)[t as usize]
        } else {
            pieces.frame.to_world(p.at(t))
        };
        let mut parameters = [at[0], at[1]].map(|t| [t; 2]);
        if !place.is_end {
            parameters[own] = place.own;
            parameters[1 - own] = enclosure(pieces, pair[1 - own] as usize, place.other);
        }
        Some(Meeting { pieces: pair, parameters, at, point, is_certified })
    };
    Some(kept.filter_map(meeting).collect())
}
