//! Splines through points.

use super::bernstein::{self, Piece};
use super::block_tridiagonal::{cyclic_solution, open_solution};
use super::hermite::{BlockRow, Chord, Columns, HermiteRules, binomial};
use super::separators::{Elimination, Separators};
use super::{Curve, EndCondition, Order, checked_chord_lengths};
use coface_algebra::Error;
use coface_geometry::predicates::orientation;
use rayon::prelude::*;
use std::cmp::Ordering;
use std::ops::Range;

impl Curve<'static> {
    /// The spline of an order through points, with the cumulated distance of the points as parameter.
    ///
    /// Its knots are the points, bit for bit. Points on a line that is run through in one direction give straight pieces, exactly, unless
    /// the condition says otherwise. The polyline is the spline of order 2.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) naming the point that is not finite, that is equal to the one before
    /// it or so close that no chord length is left; for fewer than two points, or three and the first again for
    /// [`EndCondition::Periodic`], and for a list that is not closed there; for a wrong number of derivatives; where numbers leave
    /// the range of `f64`.
    ///
    /// # Complexity
    /// Linear in the points: the derivatives at the knots solve a block tridiagonal system, factored once for x and y. From some
    /// ten thousand points on in parallel, with the same result whatever the number of threads.
    ///
    /// # References
    /// C. de Boor, *A Practical Guide to Splines* (1978), chapters IV and XIII; G. Farin, *Curves and Surfaces for Computer-Aided Geometric
    /// Design* (1988), chapter 9.
    ///
    /// # Examples
    /// Three points give a parabola; this one is $y = x (2 - x)$, for both chords are as long.
    /// ```
    /// use coface_yin::{Curve, EndCondition, Order};
    /// let curve = Curve::fit(&[[0.0, 0.0], [1.0, 1.0], [2.0, 0.0]], Order::CUBIC, &EndCondition::NotAKnot)?;
    /// let [x, y] = curve.point(0.5 * curve.knots()[1]);
    /// assert!((x - 0.5).abs() < 1e-15 && (y - 0.75).abs() < 1e-15);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn fit(points: &[[f64; 2]], order: Order, ends: &EndCondition) -> Result<Self, Error> {
        Self::fit_to(points, checked_chord_lengths(points)?, order, ends)
    }

    /// The same with these parameters of the points instead of their cumulated distance: where points are values of a smooth function of
    /// a parameter that is known, the spline is within the power of its order, however uneven their distances are. The parameters of the curve
    /// are counted from the first.
    ///
    /// # Errors
    /// As [`Self::fit`]; and for parameters that are not one for each point, not finite, or do not rise.
    ///
    /// # Examples
    /// Eight points of $(t, t^2)$, which is of order 4.
    /// ```
    /// use coface_yin::{Curve, EndCondition, Order};
    /// let parameters: Vec<f64> = (0..8).map(|i| f64::from(i * i)).collect();
    /// let points: Vec<[f64; 2]> = parameters.iter().map(|t| [*t, t * t]).collect();
    /// let curve = Curve::fit_at(&points, &parameters, Order::CUBIC, &EndCondition::NotAKnot)?;
    /// let [x, y] = curve.point(20.0);
    /// assert!((x - 20.0).abs() < 1e-11 && (y - 400.0).abs() < 1e-9);
    /// assert!(Curve::fit_at(&points, &[0.0; 8], Order::CUBIC, &EndCondition::NotAKnot).is_err());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn fit_at(
        points: &[[f64; 2]],
        parameters: &[f64],
        order: Order,
        ends: &EndCondition,
    ) -> Result<Self, Error> {
        checked_chord_lengths(points)?;
        let first = parameters.first().copied().unwrap_or_default();
        let knots: Vec<f64> = parameters.iter().map(|parameter| parameter - first).collect();
        if knots.len() != points.len() {
            return Err(Error::invalid(format!(
                "{} parameters are given for {} points",
                knots.len(),
                points.len()
            ))
            .with_cure("give one for each point"));
        }
        let rises = |pair: &[f64]| pair[0] < pair[1] && pair[1].is_finite();
        if let Some(at) = knots.windows(2).position(|pair| !rises(pair)) {
            return Err(Error::invalid(format!("parameter {} is not above parameter {at}", at + 1))
                .with_cure("give finite parameters that rise"));
        }
        Self::fit_to(points, knots, order, ends)
    }

    /// The same with knots that are known to rise from 0.
    pub(super) fn fit_to(
        points: &[[f64; 2]],
        knots: Vec<f64>,
        order: Order,
        ends: &EndCondition,
    ) -> Result<Self, Error> {
        let is_periodic = *ends == EndCondition::Periodic;
        if is_periodic && points[0] != points[points.len() - 1] {
            return Err(Error::invalid("a periodic spline needs points that end where they begin")
                .with_cure("give the first point again as the last, or take another end condition"));
        }
        if is_periodic && points.len() < 4 {
            return Err(Error::invalid(format!("{} points make no closed spline", points.len() - 1))
                .with_cure("give three points and the first of them again"));
        }
        let wanted = order.value() / 2 - 1;
        if let EndCondition::Complete { start, end } = ends
            && [start, end].iter().any(|given| given.len() != wanted)
        {
            return Err(Error::invalid(format!(
                "{} and {} derivatives are given at the ends of a spline of order {order}",
                start.len(),
                end.len()
            ))
            .with_cure(format!("give {wanted} at each end")));
        }
        let can_be_straight = matches!(ends, EndCondition::NotAKnot | EndCondition::Natural);
        if order == Order::LINEAR || can_be_straight && is_line(points) {
            let polyline = Self::from_trusted(Order::LINEAR, points.to_vec(), knots);
            return polyline.raised(order);
        }
        let controls = if *ends == EndCondition::NotAKnot && points.len() <= order.value() {
            one_polynomial(points, &knots, order)
        } else {
            match order.value() {
                4 => spline::<1>(points, &knots, ends),
                6 => spline::<2>(points, &knots, ends),
                _ => spline::<3>(points, &knots, ends),
            }
        };
        let Some(controls) = controls else {
            return Err(Error::invalid("a spline through these points leaves the range of numbers")
                .with_cure("give points whose distances and coordinates are of similar size"));
        };
        Ok(Self::from_trusted(order, controls, knots))
    }
}

/// Whether points are on a line, one after the other.
fn is_line(points: &[[f64; 2]]) -> bool {
    points.windows(3).all(|corner| {
        let [a, b, c] = [corner[0], corner[1], corner[2]];
        // On a line they are in order when they are so by one coordinate in which they differ.
        let between = |axis: usize| (a[axis] < b[axis]) == (b[axis] < c[axis]) || a[axis] == c[axis];
        orientation(a, b, c) == Ordering::Equal && between(0) && between(1) && (a[0] != c[0] || a[1] != c[1])
    })
}

/// The control points of all pieces, if they are finite, where they are one polynomial whose degree is the number of pieces.
fn one_polynomial(points: &[[f64; 2]], knots: &[f64], order: Order) -> Option<Vec<[f64; 2]>> {
    let degree = points.len() - 1;
    let whole = knots[degree];
    let inner = degree - 1;
    // Rows: the inner points. Columns: the inner control points, relative to the first point; x and y of the right sides.
    let mut rows: Vec<Vec<f64>> = (1..degree)
        .map(|i| {
            let s = knots[i] / whole;
            let basis =
                |j: usize| binomial(degree, j) * s.powi(j as i32) * (1.0 - s).powi((degree - j) as i32);
            let right = [0, 1].map(|axis| {
                points[i][axis] - points[0][axis] - basis(degree) * (points[degree][axis] - points[0][axis])
            });
            (1..degree).map(basis).chain(right).collect()
        })
        .collect();
    for column in 0..inner {
        let pivot = (column..inner)
            .max_by(|&a, &b| rows[a][column].abs().total_cmp(&rows[b][column].abs()))
            .expect("there is a row for each column");
        rows.swap(column, pivot);
        let used = rows[column].clone();
        for (at, row) in rows.iter_mut().enumerate() {
            if at != column {
                let factor = row[column] / used[column];
                row.iter_mut().zip(&used).for_each(|(x, y)| *x -= factor * y);
            }
        }
    }
    let polynomial = Piece::with(degree + 1, |j| match j {
        0 => points[0],
        j if j == degree => points[degree],
        j => [0, 1].map(|axis| points[0][axis] + rows[j - 1][inner + axis] / rows[j - 1][j - 1]),
    });
    let raised = bernstein::raised_as_it_is(&polynomial, order.value());
    let mut controls = Vec::with_capacity(degree * order.degree() + 1);
    for i in 0..degree {
        let range = [knots[i] / whole, knots[i + 1] / whole];
        let piece = bernstein::sub_range_between(&raised, range, [points[i], points[i + 1]]);
        controls.extend_from_slice(&piece[..order.degree()]);
    }
    controls.push(points[degree]);
    controls.as_flattened().iter().all(|x| x.is_finite()).then_some(controls)
}

/// The control points of a spline of order 2N + 2, if they are finite.
///
/// With [`EndCondition::NotAKnot`] the first N + 1 pieces are one from the start, and the points within are conditions on it; so are
/// the last.
fn spline<const N: usize>(points: &[[f64; 2]], knots: &[f64], ends: &EndCondition) -> Option<Vec<[f64; 2]>> {
    let rules = HermiteRules::<N>::new();
    let last = points.len() - 1;
    // Powers of lengths stay in range when lengths are about one; the factor is a power of two.
    let scale = (last as f64 / knots[last]).log2().floor().clamp(-1000.0, 1000.0).exp2();
    let inner = if *ends == EndCondition::NotAKnot { N } else { 0 };
    let piece_count = last - 2 * inner;
    let knot = |node: usize| match node {
        0 => 0,
        node if node == piece_count => last,
        node => node + inner,
    };
    let way = |from: usize, to: usize| [0, 1].map(|axis| points[to][axis] - points[from][axis]);
    let chord = |piece: usize| {
        let [from, to] = [knot(piece), knot(piece + 1)];
        Chord { length: scale * (knots[to] - knots[from]), way: way(from, to) }
    };
    let row = |node: usize| -> BlockRow<N> {
        let is_end = node == 0 || node == piece_count;
        match ends {
            EndCondition::Periodic => {
                let before = if node == 0 { piece_count - 1 } else { node - 1 };
                rules.smooth_row([Some(chord(before)), Some(chord(node))])
            }
            EndCondition::NotAKnot if node == 0 => {
                let whole = knots[knot(1)];
                rules.through(chord(0), std::array::from_fn(|i| (knots[i + 1] / whole, way(0, i + 1))), false)
            }
            EndCondition::NotAKnot if is_end => {
                let whole = knots[last] - knots[knot(node - 1)];
                let mirrored =
                    |i: usize| ((knots[last] - knots[last - i - 1]) / whole, way(last, last - i - 1));
                let Chord { length, way } = chord(node - 1);
                let chord = Chord { length, way: way.map(|x| -x) };
                rules.through(chord, std::array::from_fn(mirrored), true)
            }
            EndCondition::Complete { start, end } if is_end => {
                let given = if node == 0 { start } else { end };
                let mut power = 1.0;
                BlockRow::known(std::array::from_fn(|k| {
                    power /= scale;
                    given[k].map(|x| x * power)
                }))
            }
            _ => rules
                .smooth_row([(node > 0).then(|| chord(node - 1)), (node < piece_count).then(|| chord(node))]),
        }
    };
    let degree = 2 * N + 1;
    let is_cyclic = *ends == EndCondition::Periodic;
    let count = piece_count + usize::from(!is_cyclic);
    let mut controls = vec![[0.0; 2]; last * degree + 1];
    controls[last * degree] = points[last];
    // The control points of some pieces, given the derivatives at all of their ends; whether they are finite.
    let write = |pieces: Range<usize>, derivatives: &[Columns<N>], out: &mut [[f64; 2]]| {
        let mut is_finite = true;
        let mut out = out.chunks_exact_mut(degree);
        for (piece, pair) in pieces.zip(derivatives.windows(2)) {
            let [from, to] = [knot(piece), knot(piece + 1)];
            let (length, ends) = (scale * (knots[to] - knots[from]), [points[from], points[to]]);
            let derivatives = [&pair[0], &pair[1]];
            if to == from + 1 {
                let Some(own) = out.next() else { break };
                let mut at = 0;
                rules.for_each_control(length, ends, derivatives, |control| {
                    is_finite &= control[0].is_finite() & control[1].is_finite();
                    own[at] = control;
                    at += 1;
                });
                continue;
            }
            let mut fitted = Vec::with_capacity(degree + 1);
            rules.for_each_control(length, ends, derivatives, |control| fitted.push(control));
            fitted.push(points[to]);
            is_finite &= fitted.as_flattened().iter().all(|x| x.is_finite());
            let whole = knots[to] - knots[from];
            for (i, own) in (from..to).zip(out.by_ref()) {
                let range = [(knots[i] - knots[from]) / whole, (knots[i + 1] - knots[from]) / whole];
                let part = bernstein::sub_range_between(&fitted, range, [points[i], points[i + 1]]);
                own.copy_from_slice(&part[..degree]);
            }
        }
        is_finite
    };
    let is_finite = if let Some(separators) = Separators::new(count, is_cyclic, &row) {
        let mut parts = Vec::with_capacity(separators.part_count());
        let mut rest = &mut controls[..last * degree];
        for part in 0..separators.part_count() {
            let Range { start, end } = separators.part(part);
            let pieces = start..end.min(piece_count);
            let (own, after) =
                std::mem::take(&mut rest).split_at_mut((knot(pieces.end) - knot(pieces.start)) * degree);
            parts.push((part, pieces, own));
            rest = after;
        }
        let each = |room: &mut Elimination<N>,
                    (part, pieces, own): (usize, Range<usize>, &mut [[f64; 2]])| {
            separators.solve(part, row, room);
            write(pieces, &room.unknowns, own)
        };
        parts.into_par_iter().map_init(Elimination::default, each).all(|is_finite| is_finite)
    } else {
        let mut derivatives = if is_cyclic { cyclic_solution(count, row) } else { open_solution(count, row) };
        if is_cyclic {
            derivatives.push(derivatives[0]);
        }
        write(0..piece_count, &derivatives, &mut controls[..last * degree])
    };
    is_finite.then_some(controls)
}
