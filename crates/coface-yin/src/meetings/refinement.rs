//! Meetings that are known too little: where exactly they are.

use super::Meeting;
use super::carriers::Carriers;
use crate::curve::bernstein;

/// Parameters of meetings that are known no better than this are found anew.
const WIDE: f64 = 1e-10;

/// How often two pieces are brought nearer to each other.
const MOST_STEPS: usize = 40;

/// How much steps are held back, one after the other until one leads nearer.
const HELD_BACK: [f64; 6] = [0.0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3];

/// Puts an uncertified meeting where its pieces come nearest to each other: whether that is within the resolution.
///
/// Meetings that are not certified are where hulls of short arcs are within the resolution of each other; the arcs themselves may be
/// a little farther apart, and then they do not meet.
pub(super) fn refine(carriers: &Carriers, meeting: &mut Meeting, resolution: f64) -> bool {
    let is_wide = meeting.parameters.iter().any(|[low, high]| high - low > WIDE);
    if meeting.is_certified && !is_wide {
        return true;
    }
    let controls = meeting.pieces.map(|carrier| carriers.controls(carrier));
    let rounding = 2.0 * controls.map(bernstein::rounding_bound).into_iter().fold(0.0, f64::max);
    let offset = |at: [f64; 2]| {
        let [p, q] = [0, 1].map(|side| bernstein::value(controls[side], at[side]));
        ([p[0] - q[0], p[1] - q[1]], p)
    };
    let length = |[x, y]: [f64; 2]| x.hypot(y);
    let derivatives = controls.map(bernstein::derivative);
    let mut at = meeting.at;
    let mut distance = length(offset(at).0);
    for _ in 0..MOST_STEPS {
        if distance <= rounding {
            break;
        }
        let [x, y] = offset(at).0;
        let [u, v] = [0, 1].map(|side| bernstein::value(&derivatives[side], at[side]));
        let cross = |[a, b]: [f64; 2], [c, d]: [f64; 2]| a * d - b * c;
        let squares = u[0] * u[0] + u[1] * u[1] + v[0] * v[0] + v[1] * v[1];
        let turn = cross(u, v);
        // Least squares of offset + s u - t v, held back no more than needed: where the two are nearly parallel steps would be too long.
        let trial = |part: f64| {
            let held = part * squares;
            let determinant = turn * turn + held * (squares + held);
            let step = [
                -(turn * cross([x, y], v) + held * (u[0] * x + u[1] * y)) / determinant,
                (turn * cross(u, [x, y]) + held * (v[0] * x + v[1] * y)) / determinant,
            ];
            let next = [0, 1].map(|side| (at[side] + step[side]).clamp(0.0, 1.0));
            (next, length(offset(next).0))
        };
        let Some((next, found)) =
            HELD_BACK.iter().map(|&part| trial(part)).find(|&(_, found)| found < distance)
        else {
            break;
        };
        (at, distance) = (next, found);
    }
    if length(offset(meeting.at).0) > resolution {
        meeting.at = at;
        meeting.parameters = at.map(|own| [own; 2]);
        meeting.point = offset(at).1;
    }
    distance <= resolution || meeting.is_certified
}
