//! The points of a boundary that are nearest to given points.

use super::YinSet;
use super::location::check_points;
use crate::curve::{bernstein, distance, nearest_on};
use coface_algebra::Error;
use rayon::prelude::*;

/// Boxes of so many pieces, and boxes of so many boxes.
const WIDTH: usize = 8;

/// Numbers whose squares are numbers too.
const SAFE: std::ops::Range<f64> = 1e-100..1e100;

/// The point of a boundary that is nearest to a given point.
///
/// # Examples
/// ```
/// use coface_yin::{Curve, YinSet};
/// let square = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?])?;
/// let found = square.nearest_all(&[[1.5, 1.0]])?[0].expect("it has a boundary");
/// assert_eq!((found.point, found.distance), ([2.0, 1.0], 0.5));
/// assert_eq!((found.curve, found.piece, found.parameter), (0, 1, 0.5));
/// # Ok::<(), coface_algebra::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct NearestPoint {
    /// The curve that it is on; the first of several.
    pub curve: usize,
    /// The piece of the curve.
    pub piece: usize,
    /// The parameter in [0, 1] on that piece.
    pub parameter: f64,
    /// The point.
    pub point: [f64; 2],
    /// Its distance from the given point, in the unit of the coordinates.
    pub distance: f64,
}

/// Boxes around control points, by their lower left and upper right corners.
type PlaneBox = [[f64; 2]; 2];

fn around([a, b]: PlaneBox, [c, d]: PlaneBox) -> PlaneBox {
    [[0, 1].map(|k| f64::min(a[k], c[k])), [0, 1].map(|k| f64::max(b[k], d[k]))]
}

fn gap([low, high]: PlaneBox, point: [f64; 2]) -> f64 {
    distance([0.0; 2], [0, 1].map(|k| (low[k] - point[k]).max(point[k] - high[k]).max(0.0)))
}

/// Boxes around pieces that come one after the other, in levels.
struct Levels<'a> {
    pieces: Vec<&'a [[f64; 2]]>,
    levels: Vec<Vec<PlaneBox>>,
}

impl<'a> Levels<'a> {
    fn new(pieces: Vec<&'a [[f64; 2]]>) -> Self {
        let nothing = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
        let mut levels: Vec<Vec<PlaneBox>> = vec![
            pieces
                .par_chunks(WIDTH)
                .map(|own| own.iter().map(|piece| bernstein::control_box(piece)).fold(nothing, around))
                .collect(),
        ];
        while let Some(last) = levels.last().filter(|last| last.len() > 1) {
            levels.push(last.chunks(WIDTH).map(|own| own.iter().copied().fold(nothing, around)).collect());
        }
        Self { pieces, levels }
    }

    /// The nearest piece with its distance and the parameter on it.
    fn nearest(&self, point: [f64; 2]) -> Option<(usize, [f64; 2])> {
        let mut best: Option<(usize, [f64; 2])> = None;
        let mut stack = vec![(self.levels.len() - 1, 0)];
        while let Some((level, at)) = stack.pop() {
            let Some(&own) = self.levels[level].get(at) else { continue };
            let known = best.map_or(f64::INFINITY, |(_, [far, _])| far);
            if gap(own, point) >= known {
                continue;
            }
            if level > 0 {
                let children = at * WIDTH..((at + 1) * WIDTH).min(self.levels[level - 1].len());
                let mut near: Vec<(f64, usize)> =
                    children.map(|child| (gap(self.levels[level - 1][child], point), child)).collect();
                // The nearest is taken first, the first of those that are equally near.
                near.sort_by(|a, b| b.0.total_cmp(&a.0).then(b.1.cmp(&a.1)));
                stack.extend(near.into_iter().map(|(_, child)| (level - 1, child)));
                continue;
            }
            let first = at * WIDTH;
            for (piece, controls) in (first..).zip(self.pieces[first..].iter().take(WIDTH)) {
                let known = best.map_or(f64::INFINITY, |(_, [far, _])| far);
                if let Some(found) = nearest_on(controls, point, known) {
                    best = Some((piece, found));
                }
            }
        }
        best
    }
}

impl YinSet {
    /// The points of the boundary that are nearest to points; none for a set without curves. Right to rounding for straight pieces, and
    /// for others as far as Newton's iteration from parts that are nearly straight comes, about 1e-15 times the coordinates.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) naming a point that is not finite.
    ///
    /// # Complexity
    /// Linear in the pieces, and logarithmic in them for each point that is near few of them.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Curve, Order, YinSet};
    /// let disk = YinSet::new(&[Curve::circle([0.0, 0.0], 1.0, 256, Order::CUBIC)?])?;
    /// let found = disk.nearest_all(&[[3.0, 4.0], [0.0, 0.5]])?;
    /// let distances = found.iter().map(|found| found.expect("it has a boundary").distance).collect::<Vec<_>>();
    /// assert!((distances[0] - 4.0).abs() < 1e-8 && (distances[1] - 0.5).abs() < 1e-8);
    /// assert_eq!(YinSet::plane(Order::CUBIC).nearest_all(&[[0.0, 0.0]])?, [None]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn nearest_all(&self, points: &[[f64; 2]]) -> Result<Vec<Option<NearestPoint>>, Error> {
        check_points(points)?;
        let curves: Vec<_> = (0..self.curve_count()).map(|curve| self.curve(curve)).collect();
        if curves.is_empty() {
            return Ok(vec![None; points.len()]);
        }
        let mut starts = Vec::with_capacity(curves.len());
        let mut pieces: Vec<&[[f64; 2]]> = Vec::new();
        for curve in &curves {
            starts.push(pieces.len());
            pieces.extend((0..curve.piece_count()).map(|piece| curve.piece(piece)));
        }
        // Squares of coordinates that are very large or small are not numbers: they are scaled by a power of two, which is exact.
        let coordinates = pieces.iter().flat_map(|piece| piece.iter()).chain(points).flatten();
        let largest = coordinates.fold(0.0, |largest: f64, x| largest.max(x.abs()));
        let scale =
            if largest == 0.0 || SAFE.contains(&largest) { 1.0 } else { 2f64.powi(-(largest.log2() as i32)) };
        let scaled = |point: &[f64; 2]| point.map(|x| x * scale);
        let copies: Vec<Vec<[f64; 2]>> = match scale {
            1.0 => Vec::new(),
            _ => pieces.iter().map(|piece| piece.iter().map(scaled).collect()).collect(),
        };
        let given = pieces.clone();
        let levels = Levels::new(match scale {
            1.0 => pieces,
            _ => copies.iter().map(Vec::as_slice).collect(),
        });
        let answer = |point: &[f64; 2]| {
            let (at, [far, parameter]) = levels.nearest(scaled(point))?;
            let curve = starts.partition_point(|&start| start <= at) - 1;
            let nearest = bernstein::value(given[at], parameter);
            Some(NearestPoint {
                curve,
                piece: at - starts[curve],
                parameter,
                point: nearest,
                distance: far / scale,
            })
        };
        Ok(points.par_iter().map(answer).collect())
    }
}
