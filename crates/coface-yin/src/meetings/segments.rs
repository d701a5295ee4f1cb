//! Where two segments meet, exactly.

use super::meeting::Found;
use super::polynomial::{cross, dot, minus};
use super::{Meeting, Overlap, Pieces};
use coface_geometry::predicates::{PlanarLine, PlanarPoint, orientation};

/// Adds the meeting or overlap of two pieces that are segments.
pub(super) fn meet_segments(pieces: &Pieces<'_>, pair: [u32; 2], found: &mut Found) {
    let [p, q] = pair.map(|piece| piece as usize);
    let lines = [pieces.ends(p), pieces.ends(q)];
    if let Some(overlap) = parts_of_one_line(pieces, pair) {
        found.overlaps.push(overlap);
        return;
    }
    let [[a, b], [c, d]] = lines;
    let of_q = [orientation(a, b, c), orientation(a, b, d)];
    if of_q[0] == of_q[1] && of_q[0].is_ne() {
        return;
    }
    let of_p = [orientation(c, d, a), orientation(c, d, b)];
    if of_p[0] == of_p[1] && of_p[0].is_ne() {
        return;
    }
    if of_p.iter().chain(&of_q).all(|side| side.is_ne()) {
        let point = PlanarPoint::crossing(lines[0], lines[1]).expect("segments that cross are not parallel");
        let point = point.rounded();
        let at = [parameter(pieces, p, point), parameter(pieces, q, point)];
        found.points.push(Meeting {
            pieces: pair,
            parameters: [0, 1].map(|k| enclosure(pieces, pair[k] as usize, at[k])),
            at,
            point,
            is_certified: true,
        });
        return;
    }
    // Ends of one that lie on the other, by different points.
    let mut common: Vec<([f64; 2], [f64; 2])> = Vec::with_capacity(4);
    let mut add = |at: [f64; 2], point: [f64; 2]| {
        if common.iter().all(|known| known.1 != point) {
            common.push((at, point));
        }
    };
    for (i, end) in [a, b].into_iter().enumerate() {
        if of_p[i].is_eq() && is_in_box(lines[1], end) {
            add([i as f64, parameter(pieces, q, end)], end);
        }
    }
    for (j, end) in [c, d].into_iter().enumerate() {
        if of_q[j].is_eq() && is_in_box(lines[0], end) {
            add([parameter(pieces, p, end), j as f64], end);
        }
    }
    match common[..] {
        [] => {}
        [(at, point)] => {
            let is_shared = pieces.joints(pair).any(|ends| ends.map(|end| end as f64) == at);
            if !is_shared {
                let parameters = [0, 1].map(|k| match at[k] {
                    end if end == 0.0 || end == 1.0 => [end; 2],
                    inner => enclosure(pieces, pair[k] as usize, inner),
                });
                found.points.push(Meeting { pieces: pair, parameters, at, point, is_certified: true });
            }
        }
        _ => {
            common.sort_by(|x, y| x.0[0].total_cmp(&y.0[0]));
            let [first, last] = [common[0].0, common[common.len() - 1].0];
            let ranges = [[first[0], last[0]], [first[1], last[1]]];
            found.overlaps.push(Overlap { pieces: pair, ranges, is_certified: true });
        }
    }
}

/// What two segments have in common that are parts of one line but for rounding, if that is more than what rounding makes.
///
/// Such are parts of a side in files that do not say of what they are parts: their ends were moved to the nearest floating-point numbers.
/// Segments with an angle between them that ends so little apart can tell are not exact; neither can what they bound be.
fn parts_of_one_line(pieces: &Pieces<'_>, pair: [u32; 2]) -> Option<Overlap> {
    let [p, q] = pair.map(|piece| piece as usize);
    let given = [pieces.ends(p), pieces.ends(q)];
    if (0..2).all(|k| {
        let other = given[1 - k];
        given[k].iter().all(|&end| orientation(other[0], other[1], end).is_eq())
    }) {
        return None;
    }
    // Coordinates along the first segment, and across it.
    let [[origin, end], other] = given;
    let chord = minus(end, origin);
    let length = chord[0].hypot(chord[1]);
    // What rounding of coordinates makes across the segment: nothing where it runs along an axis through the origin.
    let largest =
        [0, 1].map(|axis| given.as_flattened().iter().fold(0.0, |x: f64, end| x.max(end[axis].abs())));
    let rounding = 32.0 * f64::EPSILON * (chord[1].abs() * largest[0] + chord[0].abs() * largest[1]) / length;
    let place = |point: [f64; 2]| {
        let way = minus(point, origin);
        [dot(chord, way) / length, cross(chord, way) / length]
    };
    let [from, to] = other.map(place);
    let [low, high] = [from[0].min(to[0]).max(0.0), from[0].max(to[0]).min(length)];
    if high - low <= 4096.0 * pieces.frame.world_length(pieces.frame.rounding) {
        return None;
    }
    let height = |x: f64| from[1] + (x - from[0]) * ((to[1] - from[1]) / (to[0] - from[0]));
    if [low, high].iter().any(|&x| height(x).abs() > rounding) {
        return None;
    }
    let parameters = |x: f64| {
        let on_q = ((x - from[0]) / (to[0] - from[0])).clamp(0.0, 1.0);
        [if x == length { 1.0 } else { x / length }, if x == to[0] { 1.0 } else { on_q }]
    };
    let [start, end] = [low, high].map(parameters);
    Some(Overlap { pieces: pair, ranges: [0, 1].map(|k| [start[k], end[k]]), is_certified: false })
}

fn is_in_box(line: PlanarLine, point: [f64; 2]) -> bool {
    (0..2).all(|k| {
        let [low, high] = [line[0][k].min(line[1][k]), line[0][k].max(line[1][k])];
        low <= point[k] && point[k] <= high
    })
}

/// The parameter of a point of a segment; 0 and 1 are for its ends alone.
fn parameter(pieces: &Pieces<'_>, piece: usize, point: [f64; 2]) -> f64 {
    let [a, b] = pieces.ends(piece);
    if point == a {
        return 0.0;
    }
    if point == b {
        return 1.0;
    }
    let [from, to, at] = [a, b, point].map(|x| pieces.frame.to_local(x));
    let axis = usize::from((to[0] - from[0]).abs() < (to[1] - from[1]).abs());
    let t = (at[axis] - from[axis]) / (to[axis] - from[axis]);
    // The next numbers to 0 and 1.
    t.clamp(f64::MIN_POSITIVE, 1.0 - f64::EPSILON / 2.0)
}

pub(super) fn enclosure(pieces: &Pieces<'_>, piece: usize, t: f64) -> [f64; 2] {
    let chord = pieces.polynomial(piece).chord();
    let error = 8.0 * f64::EPSILON * (1.0 + 1.0 / chord[0].abs().max(chord[1].abs()));
    [(t - error).max(0.0), (t + error).min(1.0)]
}
