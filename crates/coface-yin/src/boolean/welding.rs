//! Pieces of several sets that are one but for rounding, made one.
//!
//! A set that was moved, turned by a symmetry of its own, or written by another program has its control points where another set has them, up to
//! the last digits. Curves like these cross at random: what they bound between them cannot be written, and where they cross cannot be told.

use crate::curve::bernstein;
use crate::curve::bernstein::Piece;
use crate::set::CurveArena;
use crate::{Assumption, Carrier, Curve, KnotIndex, PieceSource, UncertifiedDecision, YinSet};

/// Sets of which some have pieces of others.
pub(super) struct Welded {
    pub(super) sets: Vec<YinSet>,
    /// The pieces that were taken for one.
    pub(super) decisions: Vec<UncertifiedDecision>,
}

/// A piece of a set.
#[derive(Clone, Copy)]
struct Place {
    operand: usize,
    curve: usize,
    piece: usize,
    /// The first coordinate of the middle between its ends.
    middle: f64,
}

/// The piece that another one becomes, and whether that runs against it.
#[derive(Clone, Copy)]
struct Replacement {
    other: Place,
    is_against: bool,
}

/// The sets with pieces of an earlier one in place of pieces of later ones that have all control points within a distance of the ones there; nothing
/// if there are no such pieces, or the sets are of several orders.
///
/// Pieces beside those that are replaced end where these do. Curves and pieces keep their numbers.
pub(super) fn welded(sets: &[&YinSet], limit: f64) -> Option<Welded> {
    let order = sets.first()?.order();
    if sets.iter().any(|set| set.order() != order) {
        return None;
    }
    let mut places: Vec<Place> = Vec::new();
    for (operand, set) in sets.iter().enumerate() {
        for curve in 0..set.curve_count() {
            let own = set.curve(curve);
            places.extend((0..own.piece_count()).map(|piece| {
                let controls = own.piece(piece);
                let middle = 0.5 * controls[0][0] + 0.5 * controls[controls.len() - 1][0];
                Place { operand, curve, piece, middle }
            }));
        }
    }
    let mut sorted = places.clone();
    sorted.sort_by(|a, b| a.middle.total_cmp(&b.middle));
    let mut found = Welded { sets: Vec::with_capacity(sets.len()), decisions: Vec::new() };
    let mut rest = &places[..];
    for (operand, &set) in sets.iter().enumerate() {
        let mut curves = CurveArena::new(order);
        for curve in 0..set.curve_count() {
            let (own, others) = rest.split_at(set.curve(curve).piece_count());
            rest = others;
            let replaced: Vec<Option<Replacement>> =
                own.iter().map(|place| replacement(sets, &sorted, place, limit)).collect();
            curves.push(&with_pieces(&set.curve(curve), &found.sets, replaced, |piece, other| {
                let source = |place: &Place| PieceSource {
                    operand: place.operand as u32,
                    curve: place.curve as u32,
                    piece: place.piece as u32,
                    range: [0.0, 1.0],
                };
                let place = Place { operand, curve, piece, middle: 0.0 };
                found.decisions.push(UncertifiedDecision {
                    point: set.curve(curve).piece(piece)[0],
                    pieces: [source(other), source(&place)],
                    assumption: Assumption::SameArc,
                    misplaced: 0.0,
                });
            }));
        }
        let parents = (0..set.curve_count())
            .map(|curve| set.forest().parent(curve).map(|parent| parent as u32))
            .collect();
        let kinks: Vec<KnotIndex> = set.kinks().iter().map(|(knot, _)| knot).collect();
        found.sets.push(YinSet::from_parts(curves, !set.is_bounded(), parents, kinks));
    }
    (!found.decisions.is_empty()).then_some(found)
}

/// Whether control points are within a distance of each other, one by one.
fn are_near<'a>(
    a: impl Iterator<Item = &'a [f64; 2]>,
    b: impl Iterator<Item = &'a [f64; 2]>,
    limit: f64,
) -> bool {
    a.zip(b).all(|(a, b)| (0..2).all(|axis| (a[axis] - b[axis]).abs() <= limit))
}

/// The first piece of an earlier set that is a piece but for rounding.
fn replacement(sets: &[&YinSet], sorted: &[Place], own: &Place, limit: f64) -> Option<Replacement> {
    let controls = sets[own.operand].curve(own.curve);
    let controls = controls.piece(own.piece);
    let first = sorted.partition_point(|place| place.middle < own.middle - 2.0 * limit);
    let near = sorted[first..].iter().take_while(|place| place.middle <= own.middle + 2.0 * limit);
    let found = near.filter(|place| place.operand < own.operand).filter_map(|other| {
        let curve = sets[other.operand].curve(other.curve);
        let other_controls = curve.piece(other.piece);
        let is_along = are_near(controls.iter(), other_controls.iter(), limit);
        let is_against = !is_along && are_near(controls.iter(), other_controls.iter().rev(), limit);
        (is_along || is_against).then_some(Replacement { other: *other, is_against })
    });
    found.min_by_key(|found| (found.other.operand, found.other.curve, found.other.piece))
}

/// A curve with pieces of sets in place of its own, as far as they are connected.
fn with_pieces(
    curve: &Curve<'_>,
    sets: &[YinSet],
    mut replaced: Vec<Option<Replacement>>,
    mut tell: impl FnMut(usize, &Place),
) -> Curve<'static> {
    let (order, count) = (curve.order().value(), curve.piece_count());
    let piece_of = |found: &Replacement| {
        let other = sets[found.other.operand].curve(found.other.curve);
        let piece = Piece::new(other.piece(found.other.piece));
        if found.is_against { piece.reversed() } else { piece }
    };
    // Where two of them do not follow each other, one stays as it was.
    for at in 0..count {
        let next = (at + 1) % count;
        if let [Some(a), Some(b)] = [&replaced[at], &replaced[next]]
            && piece_of(a)[order - 1] != piece_of(b)[0]
        {
            replaced[next] = None;
        }
    }
    if let [Some(first), .., Some(last)] = &replaced[..]
        && piece_of(last)[order - 1] != piece_of(first)[0]
    {
        replaced[count - 1] = None;
    }
    if replaced.iter().all(Option::is_none) {
        return curve.clone().into_owned();
    }
    let pieces: Vec<Option<Piece>> = replaced.iter().map(|found| found.as_ref().map(piece_of)).collect();
    let mut controls: Vec<[f64; 2]> = Vec::with_capacity(count * (order - 1) + 1);
    let mut carriers: Vec<Carrier> = Vec::new();
    for at in 0..count {
        let own = curve.carriers().iter().find(|carrier| carrier.piece() as usize == at);
        let piece = match (&pieces[at], &replaced[at]) {
            (Some(piece), Some(found)) => {
                let other = sets[found.other.operand].curve(found.other.curve);
                let number = found.other.piece;
                let carrier = other.carriers().iter().find(|carrier| carrier.piece() as usize == number);
                if *piece != Piece::new(curve.piece(at)) {
                    tell(at, &found.other);
                }
                carriers.extend(carrier.map(|carrier| match found.is_against {
                    true => carrier.reversed(at as u32),
                    false => carrier.of_piece(at as u32),
                }));
                *piece
            }
            _ => {
                let whole = Piece::new(curve.piece(at));
                let before = &pieces[(at + count - 1) % count];
                let after = &pieces[(at + 1) % count];
                let ends = [
                    before.as_ref().map_or(whole[0], |piece| piece[order - 1]),
                    after.as_ref().map_or(whole[order - 1], |piece| piece[0]),
                ];
                carriers.extend(own.copied());
                if bernstein::is_straight(curve.piece(at)) {
                    bernstein::straight_piece(ends, order)
                } else {
                    whole.between(ends)
                }
            }
        };
        controls.extend_from_slice(&piece[..order - 1]);
    }
    controls.push(controls[0]);
    Curve::from_trusted(curve.order(), controls, curve.knots().to_vec()).carried_by(carriers)
}
