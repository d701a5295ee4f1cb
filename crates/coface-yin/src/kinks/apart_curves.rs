//! Whether curves surely meet at their common ends only.

use super::apartness::{Tube, share_nothing, share_one_knot};
use super::piece_boxes::PieceBoxes;
use crate::Curve;
use rayon::prelude::*;

/// Whether curves surely have no points in common but their ends, and are simple; each comes with names of its two ends, equal for ends
/// that are one point. When that is not proven nothing is said.
///
/// # Complexity
/// $O(n \log n)$ for n pieces that are nearly straight and not too near each other, in parallel.
pub(crate) fn are_surely_apart<'a>(curves: impl Iterator<Item = (Curve<'a>, [u32; 2])>) -> bool {
    // The names of the knots come after those of the ends.
    let mut tubes: Vec<Tube> = Vec::new();
    let mut knots: Vec<[u64; 2]> = Vec::new();
    for (curve, ends) in curves {
        let count = curve.piece_count();
        let first = (1 << 32) + tubes.len() as u64;
        let name = |at: usize| match at {
            0 => u64::from(ends[0]),
            at if at == count => u64::from(ends[1]),
            at => first + at as u64,
        };
        for piece in 0..count {
            tubes.push(Tube::new(curve.piece(piece), curve.piece(piece)));
            knots.push([name(piece), name(piece + 1)]);
        }
    }
    let boxes = PieceBoxes::new(tubes.iter().map(Tube::bounds));
    (0..tubes.len()).into_par_iter().with_min_len(64).all(|at| {
        let own = knots[at];
        own[0] != own[1]
            && tubes[at].is_simple()
            && boxes.all_meeting(&tubes[at].bounds(), |other| {
                if other >= at {
                    // The other one looks at this one.
                    return true;
                }
                let shared = |i: usize, j: usize| own[i] == knots[other][j];
                let count = (0..4).filter(|pair| shared(pair / 2, pair % 2)).count();
                match (0..4).find(|pair| shared(pair / 2, pair % 2)).map(|pair| [pair / 2, pair % 2]) {
                    None => share_nothing(&tubes[at], &tubes[other]),
                    Some([i, j]) => {
                        let to = if i == 1 { tubes[at] } else { tubes[at].reversed() };
                        let from = if j == 0 { tubes[other] } else { tubes[other].reversed() };
                        count == 1 && share_one_knot(&to, &from)
                    }
                }
            })
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Order;

    #[test]
    fn curves_apart_are_told_from_curves_that_meet() {
        let circle = |x: f64| Curve::circle([x, 0.0], 1.0, 16, Order::CUBIC).expect("a circle");
        let pair = |x: f64| [circle(0.0), circle(x)].into_iter().zip([[0; 2], [1; 2]]);
        assert!(are_surely_apart(pair(2.5)));
        assert!(!are_surely_apart(pair(1.9)));
        let line = |points: &[[f64; 2]]| Curve::polyline(points).expect("a line");
        let (across, up) = (line(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]]), line(&[[1.0, 2.0], [0.0, 0.0]]));
        assert!(are_surely_apart([(across.clone(), [0, 1]), (up.clone(), [2, 0])].into_iter()));
        assert!(!are_surely_apart([(across, [0, 1]), (up, [2, 3])].into_iter()));
        // A bow that crosses itself.
        let bow = line(&[[0.0, 0.0], [2.0, 2.0], [2.0, 0.0], [0.0, 2.0], [0.0, 0.0]]);
        assert!(!are_surely_apart([(bow, [0, 0])].into_iter()));
    }
}
