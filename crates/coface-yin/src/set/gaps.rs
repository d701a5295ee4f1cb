//! How far boundaries are from each other, as distances of nearest points and along normal lines.

use super::comparison::Controls;
use crate::curve::roots::sign_changes;
use crate::curve::{bernstein, distance, distance_to};
use coface_geometry::{AxisBox, BoxTree};
use rayon::prelude::*;

/// At how many places of a piece distances are taken, and at its end.
const PLACES: usize = 16;

/// How often the way around a place of greatest distance is narrowed.
const NARROWINGS: u32 = 40;

/// The greatest of several numbers along pieces.
#[derive(Clone, Copy, Default)]
pub(super) struct Greatest {
    /// The greatest that was found.
    pub(super) most: f64,
    /// How high parabolas through places next to each other rise.
    pub(super) peak: f64,
}

impl Greatest {
    fn or(self, other: Self) -> Self {
        Self { most: self.most.max(other.most), peak: self.peak.max(other.peak) }
    }

    /// The greatest of numbers at places with equal steps; there is none where the number is missing.
    fn of_places(places: &[Option<f64>]) -> Self {
        let mut found = places
            .iter()
            .flatten()
            .fold(Self::default(), |known, &number| known.or(Self { most: number, peak: number }));
        for triple in places.windows(3) {
            if let &[Some(a), Some(b), Some(c)] = triple {
                found.peak = found.peak.max(peak([a, b, c]));
            }
        }
        found
    }
}

/// The height of the parabola through three numbers at equal steps between the first and the last.
fn peak([a, b, c]: [f64; 3]) -> f64 {
    let (slope, bend) = (0.5 * (c - a), a - 2.0 * b + c);
    if b >= a && b >= c && bend < 0.0 { b - 0.5 * slope * slope / bend } else { a.max(b).max(c) }
}

fn boxes_of(pieces: &[Controls]) -> Vec<AxisBox> {
    let box_of = |piece: &Controls| {
        let [low, high] = bernstein::control_box(piece);
        [[low[0], high[0]], [low[1], high[1]], [0.0; 2]]
    };
    pieces.iter().map(box_of).collect()
}

fn box_around(point: [f64; 2], reach: f64) -> AxisBox {
    [[point[0] - reach, point[0] + reach], [point[1] - reach, point[1] + reach], [0.0; 2]]
}

/// The greatest distance of points of the first pieces from the others.
pub(super) fn farthest(from: &[Controls], to: &[Controls]) -> Greatest {
    if from.is_empty() {
        return Greatest::default();
    }
    if to.is_empty() {
        return Greatest { most: f64::INFINITY, peak: f64::INFINITY };
    }
    let tree = BoxTree::new(&boxes_of(to));
    let nearest = |point: [f64; 2], guess: f64| {
        let mut reach = guess;
        loop {
            let mut best = f64::INFINITY;
            tree.visit(&box_around(point, reach), |piece| {
                best = best.min(distance_to(&to[piece as usize], point, best));
            });
            if best <= reach {
                return best;
            }
            reach = if best.is_finite() { best } else { 4.0 * reach };
        }
    };
    let of_piece = |piece: &Controls| {
        let [low, high] = bernstein::control_box(piece);
        let step = distance(low, high) / PLACES as f64;
        let mut guess = step.max(f64::MIN_POSITIVE);
        let mut at = |s: f64| {
            let found = nearest(bernstein::value(piece, s), guess);
            guess = (2.0 * found).max(1e-3 * step).max(f64::MIN_POSITIVE);
            found
        };
        let places: Vec<f64> = (0..=PLACES).map(|i| at(i as f64 / PLACES as f64)).collect();
        let Some(best) = (0..=PLACES).max_by(|&i, &j| places[i].total_cmp(&places[j])) else {
            return Greatest::default();
        };
        let [mut low, mut high] =
            [best.saturating_sub(1), (best + 1).min(PLACES)].map(|i| i as f64 / PLACES as f64);
        let mut most = places[best];
        for _ in 0..NARROWINGS {
            let [a, b] = [1.0 / 3.0, 2.0 / 3.0].map(|part| low + part * (high - low));
            let [of_a, of_b] = [at(a), at(b)];
            most = most.max(of_a).max(of_b);
            if of_a < of_b {
                low = a;
            } else {
                high = b;
            }
        }
        // Around the place that was narrowed down nothing is hidden.
        let others = (1..PLACES).filter(|at| at.abs_diff(best) > 1);
        let hidden = others.map(|at| peak([places[at - 1], places[at], places[at + 1]])).fold(most, f64::max);
        Greatest { most, peak: hidden }
    };
    from.par_iter().with_min_len(8).map(of_piece).reduce(Greatest::default, Greatest::or)
}

/// How far a boundary is from another along the normals of the first, and how their curvatures differ there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct NormalGaps {
    pub(super) distance: f64,
    pub(super) distance_error: f64,
    pub(super) curvature: f64,
    pub(super) curvature_error: f64,
    /// The part of the places whose normals do not meet the other boundary.
    unmet: f64,
    /// The part of the places where curvatures are not compared.
    pub(super) left_out: f64,
}

impl Default for NormalGaps {
    fn default() -> Self {
        Self {
            distance: 0.0,
            distance_error: 0.0,
            curvature: 0.0,
            curvature_error: 0.0,
            unmet: 1.0,
            left_out: 1.0,
        }
    }
}

impl NormalGaps {
    /// Whether some normal meets the other boundary.
    pub(super) fn is_matched(&self) -> bool {
        self.unmet < 1.0
    }

    /// Whether curvatures are compared somewhere.
    pub(super) fn has_curvature(&self) -> bool {
        self.left_out < 1.0
    }
}

/// For each piece of a closed curve the cosine of half the angle by which the curve turns at its less sharp kink; less than that for pieces
/// without.
///
/// What goes in another direction than that by more belongs to the other side of the kink.
pub(super) fn turn_limits(pieces: &[Controls]) -> Vec<f64> {
    /// The cosine of an angle that is far above what rounding makes between smooth neighbors.
    const SMOOTH: f64 = 1.0 - 1e-6;
    let tangents: Vec<[Option<[f64; 2]>; 2]> =
        pieces.iter().map(|piece| [0.0, 1.0].map(|s| bend(piece, s).map(|own| own.tangent))).collect();
    let limit = |before: usize, after: usize| {
        let ([_, Some(a)], [Some(b), _]) = (tangents[before], tangents[after]) else { return -2.0 };
        let cosine = a[0] * b[0] + a[1] * b[1];
        if cosine > SMOOTH { -2.0 } else { (0.5 * (1.0 + cosine)).max(0.0).sqrt() }
    };
    let count = pieces.len();
    (0..count).map(|at| limit((at + count - 1) % count, at).max(limit(at, (at + 1) % count))).collect()
}

/// A point of a piece with its unit tangent and its curvature.
struct Bend {
    point: [f64; 2],
    tangent: [f64; 2],
    curvature: f64,
    /// How far rounding of control points lets the curvature be off.
    doubt: f64,
}

/// Nothing where the piece stands still.
fn bend(piece: &[[f64; 2]], s: f64) -> Option<Bend> {
    let first = bernstein::derivative(piece);
    let way = bernstein::value(&first, s);
    let speed = way[0].hypot(way[1]);
    if speed == 0.0 {
        return None;
    }
    let second = match first.len() {
        1 => [0.0; 2],
        _ => bernstein::value(&bernstein::derivative(&first), s),
    };
    let curvature = (way[0] * second[1] - way[1] * second[0]) / (speed * speed * speed);
    let degree = (piece.len() - 1) as f64;
    let largest = piece.as_flattened().iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
    let doubt = 8.0 * f64::EPSILON * largest * degree * (degree - 1.0) / (speed * speed);
    Some(Bend { point: bernstein::value(piece, s), tangent: way.map(|x| x / speed), curvature, doubt })
}

/// A place at which a normal meets a boundary.
struct Hit {
    far: f64,
    tangent: [f64; 2],
    curvature: f64,
    doubt: f64,
    limit: f64,
}

/// What is found at a place: how far the other boundary is along the normal, and the difference of curvatures with how far that is off.
struct Gap {
    far: f64,
    curvature: Option<[f64; 2]>,
}

/// What is found at places of the first pieces, whose normals are followed so far to either side; both with [`turn_limits`].
///
/// At a kink and near it the normal of one side may meet the other side of the kink of the other boundary: curvatures are compared where
/// both go the same way, up to half the angle of the kinks at the ends of both pieces.
pub(super) fn normal_gaps(
    [from, to]: [&[Controls]; 2],
    [own_limits, other_limits]: [&[f64]; 2],
    reach: f64,
) -> NormalGaps {
    if from.is_empty() || to.is_empty() {
        return NormalGaps::default();
    }
    let tree = BoxTree::new(&boxes_of(to));
    let at_place = |own: &Bend, own_limit: f64| -> Option<Gap> {
        let along = |point: [f64; 2]| {
            (point[0] - own.point[0]) * own.tangent[0] + (point[1] - own.point[1]) * own.tangent[1]
        };
        let across = |point: [f64; 2]| {
            (point[1] - own.point[1]) * own.tangent[0] - (point[0] - own.point[0]) * own.tangent[1]
        };
        let cosine = |hit: &Hit| hit.tangent[0] * own.tangent[0] + hit.tangent[1] * own.tangent[1];
        let mut nearest = f64::INFINITY;
        let mut best: Option<Hit> = None;
        let normal = [own.tangent[1].abs() * reach, own.tangent[0].abs() * reach];
        let query = [
            [own.point[0] - normal[0], own.point[0] + normal[0]],
            [own.point[1] - normal[1], own.point[1] + normal[1]],
            [0.0; 2],
        ];
        tree.visit(&query, |number| {
            let other = &to[number as usize];
            // Where neighbors come together rounding may leave the place out for both.
            let slack = 2.0 * bernstein::rounding_bound(other);
            let offsets: Vec<f64> = other.iter().map(|&point| along(point)).collect();
            let mut roots = sign_changes(&offsets);
            roots.extend(
                [(offsets[0], 0.0), (offsets[offsets.len() - 1], 1.0)]
                    .into_iter()
                    .filter_map(|(offset, end)| (offset.abs() <= slack).then_some(end)),
            );
            for s in roots {
                let far = across(bernstein::value(other, s)).abs();
                if far > reach {
                    continue;
                }
                nearest = nearest.min(far);
                let Some(Bend { tangent, curvature, doubt, .. }) = bend(other, s) else { continue };
                let hit = Hit { far, tangent, curvature, doubt, limit: other_limits[number as usize] };
                if cosine(&hit) < own_limit.max(hit.limit) {
                    continue;
                }
                // Of those that are one point the one that goes on as this one does.
                let is_better = best.as_ref().is_none_or(|known| {
                    let is_one = (far - known.far).abs() <= slack;
                    if is_one { cosine(&hit) > cosine(known) } else { far < known.far }
                });
                if is_better {
                    best = Some(hit);
                }
            }
        });
        let curvature = best.map(|hit| [(own.curvature - hit.curvature).abs(), own.doubt + hit.doubt]);
        (nearest <= reach).then_some(Gap { far: nearest, curvature })
    };
    let of_piece = |(piece, &limit): (&Controls, &f64)| {
        let places: Vec<Option<Gap>> =
            (0..=PLACES).map(|i| at_place(&bend(piece, i as f64 / PLACES as f64)?, limit)).collect();
        let of = |number: &dyn Fn(&Gap) -> Option<f64>| {
            Greatest::of_places(&places.iter().map(|at| at.as_ref().and_then(number)).collect::<Vec<_>>())
        };
        let found = [
            of(&|gap| Some(gap.far)),
            of(&|gap| gap.curvature.map(|[apart, _]| apart)),
            of(&|gap| gap.curvature.map(|[_, doubt]| doubt)),
        ];
        let unmet = places.iter().filter(|at| at.is_none()).count();
        let is_left_out = |at: &&Option<Gap>| at.as_ref().is_none_or(|gap| gap.curvature.is_none());
        (found, [unmet, places.iter().filter(is_left_out).count()])
    };
    let none = || ([Greatest::default(); 3], [0; 2]);
    let ([far, curvature, doubt], missing) = from
        .par_iter()
        .zip(own_limits)
        .with_min_len(8)
        .map(of_piece)
        .reduce(none, |(a, m), (b, n)| ([0, 1, 2].map(|k| a[k].or(b[k])), [0, 1].map(|k| m[k] + n[k])));
    let [unmet, left_out] = missing.map(|count| count as f64 / (from.len() * (PLACES + 1)) as f64);
    NormalGaps {
        distance: far.most,
        distance_error: far.peak - far.most + f64::EPSILON * reach,
        curvature: curvature.most,
        curvature_error: curvature.peak - curvature.most + doubt.most,
        unmet,
        left_out,
    }
}
