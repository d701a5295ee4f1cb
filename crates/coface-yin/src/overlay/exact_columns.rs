//! Where pieces cross a vertical line, by exact arithmetic: for boundaries that are nearer to each other than double coordinates of points tell.

use super::boundaries::Boundaries;
use super::columns::{ColumnCrossing, NearDegenerate};
use crate::curve::bernstein;
use coface_geometry::predicates::Dyadic;
use std::cmp::Ordering;

/// How deep a piece is halved to tell its crossings apart.
const MOST_DEPTH: u32 = 48;

/// How often the parameters of a crossing are halved.
const HALVINGS: u32 = 96;

/// The Bernstein coefficients of one coordinate.
type Coefficients = Vec<Dyadic>;

fn half(a: &Dyadic, b: &Dyadic) -> Dyadic {
    &(a + b) * &Dyadic::from(0.5)
}

/// Both halves of a polynomial.
fn halves(whole: &[Dyadic]) -> [Coefficients; 2] {
    let mut row = whole.to_vec();
    let (mut before, mut after) = (vec![row[0].clone()], vec![row[row.len() - 1].clone()]);
    while row.len() > 1 {
        row = row.windows(2).map(|pair| half(&pair[0], &pair[1])).collect();
        before.push(row[0].clone());
        after.push(row[row.len() - 1].clone());
    }
    after.reverse();
    [before, after]
}

/// The part of a polynomial between parameters that are multiples of 2^-53, which may fall.
fn between(whole: &[Dyadic], [from, to]: [f64; 2]) -> Coefficients {
    let reversed = |own: &[Dyadic]| own.iter().rev().cloned().collect::<Coefficients>();
    if from > to {
        return reversed(&between(whole, [to, from]));
    }
    let [from, to] = [from, to].map(Dyadic::from);
    let blossom = |before: usize| {
        // The value of the blossom at so many times the beginning, and the end else.
        let mut row = whole.to_vec();
        for step in 0..whole.len() - 1 {
            let t = if step < before { &from } else { &to };
            let rest = &Dyadic::from(1.0) - t;
            row = row.windows(2).map(|pair| &(&rest * &pair[0]) + &(t * &pair[1])).collect();
        }
        row[0].clone()
    };
    (0..whole.len()).map(|j| blossom(whole.len() - 1 - j)).collect()
}

/// A number as the nearest ones below and above.
fn bounds(x: &Dyadic) -> [f64; 2] {
    let near = x.rounded_ratio(&Dyadic::from(1.0));
    match x.sign() {
        Ordering::Equal => [0.0; 2],
        _ => [near.next_down(), near.next_up()],
    }
}

/// Adds all crossings of a piece with the line of this x, with heights from a base on.
pub(super) fn exact_crossings(
    boundaries: &Boundaries<'_>,
    piece: u32,
    x: f64,
    base: f64,
    found: &mut Vec<ColumnCrossing>,
) -> Result<(), NearDegenerate> {
    let carrier = boundaries.carriers.controls(boundaries.carriers.of_piece(piece));
    let margin = 2.0 * boundaries.rounding;
    if carrier.iter().all(|point| point[0] > x + margin) || carrier.iter().all(|point| point[0] < x - margin)
    {
        return Ok(());
    }
    // Segments are straight whatever rounding did to the control points between their ends.
    let ends = [carrier[0], carrier[carrier.len() - 1]];
    let carrier = if bernstein::is_straight(carrier) { &ends[..] } else { carrier };
    let span = [0.0, boundaries.length(piece)].map(|way| boundaries.carriers.on_carrier(piece, way));
    let [xs, ys] = [(0, x), (1, base)].map(|(axis, zero)| {
        let zero = Dyadic::from(zero);
        let whole: Coefficients = carrier.iter().map(|point| &Dyadic::from(point[axis]) - &zero).collect();
        match span {
            [0.0, 1.0] => whole,
            _ => between(&whole, span),
        }
    });
    search(piece, &xs, &ys, [0.0, 1.0], 0, found)
}

fn search(
    piece: u32,
    xs: &[Dyadic],
    ys: &[Dyadic],
    range: [f64; 2],
    depth: u32,
    found: &mut Vec<ColumnCrossing>,
) -> Result<(), NearDegenerate> {
    let signs: Vec<Ordering> = xs.iter().map(Dyadic::sign).collect();
    if signs[0].is_eq() || signs[signs.len() - 1].is_eq() {
        return Err(NearDegenerate);
    }
    let told: Vec<Ordering> = signs.into_iter().filter(|sign| sign.is_ne()).collect();
    let changes = told.windows(2).filter(|pair| pair[0] != pair[1]).count();
    match changes {
        0 => return Ok(()),
        1 => {
            found.push(crossing(piece, xs, ys, range));
            return Ok(());
        }
        _ if depth == MOST_DEPTH => return Err(NearDegenerate),
        _ => {}
    }
    let middle = 0.5 * (range[0] + range[1]);
    let ([before, after], [low, high]) = (halves(xs), halves(ys));
    search(piece, &before, &low, [range[0], middle], depth + 1, found)?;
    search(piece, &after, &high, [middle, range[1]], depth + 1, found)
}

/// The one crossing of a polynomial whose first coordinate changes its sign once.
fn crossing(piece: u32, xs: &[Dyadic], ys: &[Dyadic], range: [f64; 2]) -> ColumnCrossing {
    let is_rightward = xs[0].sign().is_lt();
    let (mut xs, mut ys) = (xs.to_vec(), ys.to_vec());
    let [mut low, mut high] = range;
    for _ in 0..HALVINGS {
        let ([before, after], [bottom, top]) = (halves(&xs), halves(&ys));
        let middle = 0.5 * (low + high);
        let sign = after[0].sign();
        if sign.is_eq() {
            // The place itself.
            ys = vec![top[0].clone()];
            [low, high] = [middle; 2];
            break;
        }
        if sign.is_gt() == is_rightward {
            (xs, ys, high) = (before, bottom, middle);
        } else {
            (xs, ys, low) = (after, top, middle);
        }
    }
    let heights = ys.iter().map(bounds).reduce(|[a, b], [c, d]| [a.min(c), b.max(d)]);
    let range = [low.next_down().max(0.0), high.next_up().min(1.0)];
    ColumnCrossing { piece, range, heights: heights.expect("a piece has control points"), is_rightward }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn exact(numbers: &[f64]) -> Coefficients {
        numbers.iter().map(|&x| Dyadic::from(x)).collect()
    }

    #[test]
    fn parts_are_those_of_the_polynomial() {
        // The cubic t^3, and its part from 1/4 to 3/4: blossoms are products.
        let found = between(&exact(&[0.0, 0.0, 0.0, 1.0]), [0.25, 0.75]);
        let expected = exact(&[1.0 / 64.0, 3.0 / 64.0, 9.0 / 64.0, 27.0 / 64.0]);
        assert!(found.iter().zip(&expected).all(|(a, b)| (a - b).sign().is_eq()));
        let turned = between(&exact(&[0.0, 0.0, 0.0, 1.0]), [0.75, 0.25]);
        assert!(turned.iter().rev().zip(&expected).all(|(a, b)| (a - b).sign().is_eq()));
        let [before, after] = halves(&exact(&[0.0, 0.0, 1.0]));
        assert!(before.iter().zip(&exact(&[0.0, 0.0, 0.25])).all(|(a, b)| (a - b).sign().is_eq()));
        assert!(after.iter().zip(&exact(&[0.25, 0.5, 1.0])).all(|(a, b)| (a - b).sign().is_eq()));
    }

    #[test]
    fn heights_are_told_apart_far_below_the_last_digit() {
        // Two lines that rise from (0, 1) to (3, 2), the second by 2^-52 less in the end, with heights from 4/3 on.
        let base = Dyadic::from(4.0 / 3.0);
        let line = |end: f64| -> ColumnCrossing {
            let (xs, ys) = (exact(&[-1.0, 2.0]), [1.0, end].map(|y| &Dyadic::from(y) - &base));
            let mut found = Vec::new();
            search(0, &xs, &ys, [0.0, 1.0], 0, &mut found).expect("the line is away from both ends");
            found[0]
        };
        let [a, b] = [line(2.0), line(2.0 - f64::EPSILON)];
        assert!(b.heights[1] < a.heights[0] && a.is_rightward);
        assert!(a.heights[0].abs() < 1e-15 && a.range[0] <= 1.0 / 3.0 && 1.0 / 3.0 <= a.range[1]);
    }

    #[test]
    fn a_line_through_an_end_tells_nothing() {
        let mut found = Vec::new();
        let (xs, ys) = (exact(&[0.0, 1.0]), exact(&[0.0, 1.0]));
        assert!(search(0, &xs, &ys, [0.0, 1.0], 0, &mut found).is_err());
    }
}
