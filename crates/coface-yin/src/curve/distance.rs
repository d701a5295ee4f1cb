//! The distance of a point from a piece of a curve.

use super::bernstein::Piece;
use super::{bernstein, distance};

/// The distance of a point from a piece, if it is less than what is known.
pub(crate) fn distance_to(piece: &[[f64; 2]], point: [f64; 2], known: f64) -> f64 {
    let mut best = known;
    let mut waiting = vec![(Piece::new(piece), 0)];
    while let Some((part, depth)) = waiting.pop() {
        let [low, high] = bernstein::control_box(&part);
        let gap = [0, 1].map(|k| (low[k] - point[k]).max(point[k] - high[k]).max(0.0));
        if distance([0.0; 2], gap) >= best {
            continue;
        }
        let [first, last] = [part[0], part[part.len() - 1]];
        best = best.min(distance(first, point)).min(distance(last, point));
        let way = [0, 1].map(|k| last[k] - first[k]);
        let square = way[0] * way[0] + way[1] * way[1];
        let bend = bernstein::derivative(&bernstein::derivative(&part));
        let bent = if part.len() > 2 {
            bend.iter().fold(0.0, |most: f64, v| most.max(v[0].abs() + v[1].abs()))
        } else {
            0.0
        };
        if part.len() == 2 || bent * bent <= 1e-4 * square || depth >= 40 {
            // Nearly straight: Newton's iteration for the foot of the point.
            let slopes = bernstein::derivative(&part);
            let offset = [0, 1].map(|k| point[k] - first[k]);
            let mut s = if square > 0.0 { (way[0] * offset[0] + way[1] * offset[1]) / square } else { 0.0 };
            for _ in 0..6 {
                s = s.clamp(0.0, 1.0);
                let (at, slope) = (bernstein::value(&part, s), bernstein::value(&slopes, s));
                let gap = [0, 1].map(|k| point[k] - at[k]);
                best = best.min(distance(at, point));
                let speed = slope[0] * slope[0] + slope[1] * slope[1];
                if speed == 0.0 {
                    break;
                }
                s += (gap[0] * slope[0] + gap[1] * slope[1]) / speed;
            }
            continue;
        }
        let [before, after] = bernstein::split(&part, 0.5);
        waiting.push((after, depth + 1));
        waiting.push((before, depth + 1));
    }
    best
}
