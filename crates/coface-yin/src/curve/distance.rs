//! The nearest point of a piece of a curve.

use super::bernstein::Piece;
use super::{bernstein, distance};

/// Between these parameters of a part that is nearly straight is one nearest point at most, but near the centers of its curvature.
const QUARTERS: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];

/// The distance of a point from a piece, if it is less than what is known.
pub(crate) fn distance_to(piece: &[[f64; 2]], point: [f64; 2], known: f64) -> f64 {
    nearest_on(piece, point, known).map_or(known, |[distance, _]| distance)
}

/// The distance of a point from a piece, and the parameter of the nearest point on it in [0, 1], if that is nearer than what is known.
pub(crate) fn nearest_on(piece: &[[f64; 2]], point: [f64; 2], known: f64) -> Option<[f64; 2]> {
    let mut best = known;
    let mut place = None;
    let mut waiting = vec![(Piece::new(piece), [0.0, 1.0], 0)];
    while let Some((part, [from, to], depth)) = waiting.pop() {
        let [low, high] = bernstein::control_box(&part);
        let gap = [0, 1].map(|k| (low[k] - point[k]).max(point[k] - high[k]).max(0.0));
        if distance([0.0; 2], gap) >= best {
            continue;
        }
        let mut take = |far: f64, s: f64| {
            if far < best {
                best = far;
                place = Some(if s == 1.0 { to } else { from + s * (to - from) });
            }
        };
        let [first, last] = [part[0], part[part.len() - 1]];
        take(distance(first, point), 0.0);
        take(distance(last, point), 1.0);
        let way = [0, 1].map(|k| last[k] - first[k]);
        let square = way[0] * way[0] + way[1] * way[1];
        let bend = bernstein::derivative(&bernstein::derivative(&part));
        let bent = if part.len() > 2 {
            bend.iter().fold(0.0, |most: f64, v| most.max(v[0].abs() + v[1].abs()))
        } else {
            0.0
        };
        if part.len() == 2 || bent * bent <= 1e-4 * square || depth >= 40 {
            // Nearly straight: where the way to the point turns from before the curve to behind it, by Newton's iteration between bounds.
            let slopes = bernstein::derivative(&part);
            let ahead = |s: f64| {
                let (at, slope) = (bernstein::value(&part, s), bernstein::value(&slopes, s));
                let gap = [0, 1].map(|k| point[k] - at[k]);
                let speed = slope[0] * slope[0] + slope[1] * slope[1];
                (gap[0] * slope[0] + gap[1] * slope[1], gap, speed, distance(at, point))
            };
            let places = QUARTERS.map(|s| ahead(s).0);
            for (ends, signs) in QUARTERS.windows(2).zip(places.windows(2)) {
                if signs[0] <= 0.0 || signs[1] > 0.0 {
                    continue;
                }
                let [mut low, mut high] = [ends[0], ends[1]];
                let mut s = low + (high - low) * (signs[0] / (signs[0] - signs[1]));
                for _ in 0..60 {
                    let (forward, gap, speed, far) = ahead(s);
                    take(far, s);
                    if forward > 0.0 {
                        low = s;
                    } else {
                        high = s;
                    }
                    let bend = if bend.is_empty() { [0.0; 2] } else { bernstein::value(&bend, s) };
                    let step = s + forward / (speed - gap[0] * bend[0] - gap[1] * bend[1]);
                    let next = if low < step && step < high { step } else { 0.5 * (low + high) };
                    if (next - s).abs() <= f64::EPSILON || next <= low || next >= high {
                        break;
                    }
                    s = next;
                }
            }
            continue;
        }
        let [before, after] = bernstein::split(&part, 0.5);
        let middle = 0.5 * (from + to);
        waiting.push((after, [middle, to], depth + 1));
        waiting.push((before, [from, middle], depth + 1));
    }
    place.map(|s| [best, s])
}
