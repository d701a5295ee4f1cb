//! What a curved piece has in common with a line, by exact arithmetic.

use super::sturm::{RationalPolynomial, SturmChain};
use coface_geometry::predicates::{Dyadic, PlanarLine};

/// The common points of a curved piece and a line in a range of parameters.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum LineContact {
    /// There are none, and the distance is more than the least that counts.
    Nothing,
    /// Exactly these, each between two parameters of the piece that are next to each other or equal. A single one may be a crossing
    /// or a touching; two of them are crossings, and in between the distance is more than the least that counts.
    Points(Vec<[f64; 2]>),
    /// The piece is on the line, or comes to it so often or so near that rounding of results could change what is found.
    Unclear,
}

/// The contact of the piece with these control points with the line through two points, between two parameters.
///
/// The signed distance $(b - a) \times (P(t) - a)$, times the length of $b - a$, is a polynomial whose coefficients in the Bernstein
/// basis are computed exactly. The chain of Sturm counts its roots, multiple ones once: so whether the piece crosses the line twice,
/// touches it, or passes by, the sign of the discriminant, is decided exactly.
///
/// `turn` is about where the distance is extremal; `least` is the distance below which what crosses twice or passes by is left open.
pub(super) fn line_contact(
    piece: &[[f64; 2]],
    [a, b]: PlanarLine,
    [low, high]: [f64; 2],
    turn: f64,
    least: f64,
) -> LineContact {
    let minus = |p: [f64; 2], q: [f64; 2]| [0, 1].map(|k| &Dyadic::from(p[k]) - &Dyadic::from(q[k]));
    let [x, y] = minus(b, a);
    let distances: Vec<Dyadic> = piece
        .iter()
        .map(|&point| {
            let [to_x, to_y] = minus(point, a);
            &(&x * &to_y) - &(&y * &to_x)
        })
        .collect();
    let polynomial = RationalPolynomial::from_bernstein(&distances);
    if polynomial.is_zero() {
        return LineContact::Unclear;
    }
    let length = (b[0] - a[0]).hypot(b[1] - a[1]);
    let distance = |t: f64| polynomial.value(t).to_f64().abs() / length;
    let chain = SturmChain::new(&polynomial);
    let turn = turn.clamp(low, high);
    let [below, above, inner] = [low, high, turn].map(|t| polynomial.sign(t));
    match chain.count([low, high]) {
        0 if [low, turn, high].iter().all(|&t| distance(t) > least) => LineContact::Nothing,
        1 if below.is_eq() => LineContact::Points(vec![[low; 2]]),
        1 if above.is_eq() => LineContact::Points(vec![[high; 2]]),
        1 => LineContact::Points(vec![chain.bracket([low, high])]),
        2 if below.is_ne() && below == above && inner == below.reverse() && distance(turn) > least => {
            LineContact::Points(vec![chain.bracket([low, turn]), chain.bracket([turn, high])])
        }
        _ => LineContact::Unclear,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The parabola $y = 4 (x - 1/2)^2$ over [0, 1], raised to order 4 where thirds are exact: scaled by 3.
    fn parabola(height: f64) -> [[f64; 2]; 4] {
        [[0.0, 3.0 + height], [1.0, -1.0 + height], [2.0, -1.0 + height], [3.0, 3.0 + height]]
    }

    #[test]
    fn a_parabola_over_a_line() {
        let line = [[-8.0, 0.0], [8.0, 0.0]];
        let contact = |height: f64| line_contact(&parabola(height), line, [0.25, 0.75], 0.5, 1e-14);
        assert_eq!(contact(0.0), LineContact::Points(vec![[0.5; 2]]));
        assert_eq!(contact(2f64.powi(-40)), LineContact::Nothing);
        let LineContact::Points(points) = contact(-(2f64.powi(-40))) else { panic!("it crosses twice") };
        // 12 (t - 1/2)^2 = 2^-40.
        let offset = (2f64.powi(-40) / 12.0).sqrt();
        assert_eq!(points.len(), 2);
        assert!(
            (points[0][0] - (0.5 - offset)).abs() < 1e-15 && (points[1][1] - (0.5 + offset)).abs() < 1e-15
        );
        // One digit more or less than touching is known, but left open.
        assert_eq!(contact(2f64.powi(-50)), LineContact::Unclear);
        assert_eq!(contact(-(2f64.powi(-50))), LineContact::Unclear);
    }

    #[test]
    fn general_position() {
        // The line through (1, 2) and (4, 8) touches where the cubic (t - 1/3)^2 (t + 1) is zero over it.
        let line = [[1.0, 2.0], [4.0, 8.0]];
        // Bernstein coefficients of 9 (t - 1/3)^2 (t + 1) = 9 t^3 + 3 t^2 - 5 t + 1, times 3: 3, -2, -4, 24.
        let heights = [3.0, -2.0, -4.0, 24.0];
        let piece = [0, 1, 2, 3].map(|j| [j as f64, 2.0 * j as f64 + heights[j]]);
        let LineContact::Points(points) = line_contact(&piece, line, [0.25, 0.5], 0.33, 1e-14) else {
            panic!("it touches")
        };
        // A third is no floating-point number.
        assert!(points.len() == 1 && points[0][0] < points[0][1] && points[0][1] == points[0][0].next_up());
        assert!(3.0 * points[0][0] <= 1.0 && 3.0 * points[0][1] >= 1.0);
        let moved = piece.map(|[x, y]| [x, y + 2f64.powi(-46)]);
        assert_eq!(line_contact(&moved, line, [0.25, 0.5], 1.0 / 3.0, 1e-15), LineContact::Nothing);
        let on_line = piece.map(|[x, _]| [x, 2.0 * x]);
        assert_eq!(line_contact(&on_line, line, [0.0, 1.0], 0.5, 1e-14), LineContact::Unclear);
    }
}
