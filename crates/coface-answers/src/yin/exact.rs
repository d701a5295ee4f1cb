//! Disks and ellipses as sets right to rounding, and series of sets that come near one.

use super::PlanarSet;
use crate::answer::{Remark, RemarkCode, YinSeriesAnswer, YinSeriesRow};
use coface_algebra::Error;
use coface_geometry::{AffineMap, Angle};
use coface_yin::{Curve, Order, VelocityExpression, YinSet};
use std::f64::consts::TAU;

/// The number of knots of exact shapes. Splines of order 8 through so many points of a circle are off by less than rounding.
const KNOTS: usize = 256;

/// The part of the largest extent that lengths are known to.
const PRECISION: f64 = 1e-13;

impl PlanarSet {
    /// What is inside of an ellipse, given by its center, the lengths of its half axes and the angle of the first of them with the x axis.
    /// The boundary is a spline of order 8 that is off by rounding alone.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for numbers that are not finite and for half axes that are not positive.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::PlanarSet;
    /// use coface_geometry::Angle;
    /// let ellipse = PlanarSet::ellipse([1.0, 2.0], [2.0, 0.5], Angle::degrees(30.0)?)?;
    /// let area = ellipse.set().area().expect("an ellipse is bounded");
    /// assert!((area - std::f64::consts::PI).abs() < 1e-13);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn ellipse(center: [f64; 2], half_axes: [f64; 2], angle: Angle) -> Result<Self, Error> {
        if !half_axes.iter().all(|axis| *axis > 0.0 && axis.is_finite()) {
            return Err(Error::invalid("the half axes of an ellipse are not positive")
                .with_cure("give two positive lengths, or one radius of a circle"));
        }
        let unit = YinSet::new(&[Curve::circle([0.0, 0.0], 1.0, KNOTS, Order::new(8)?)?])?;
        let map = AffineMap::scaling(&half_axes)?
            .then(&AffineMap::rotation(2, [0, 1], angle)?)?
            .then(&AffineMap::translation(&center)?)?;
        Ok(Self::from_set(unit.transformed(&map)?))
    }

    /// What is inside of a closed curve, given by two expressions of `t` with a semicolon between them, as in `"2*cos(t); sin(t)"`, in the
    /// words of [`VelocityExpression`]: t runs from 0 to $2 \\pi$, which is `T`. The boundary is a spline of order 8 that has the points of the
    /// curve at 8 places of each piece, and as many pieces as it takes until it is off by rounding alone; where a curve is so rough that 2048
    /// are not enough, a remark says by how much it is off. Whatever way the curve runs, its inside is the set.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for what cannot be read, for expressions that have no value
    /// somewhere or name x or y, for curves that do not close, and for those that cross themselves.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::PlanarSet;
    /// let ellipse = PlanarSet::function("2*cos(t); 0.5*sin(t)")?;
    /// let area = ellipse.set().area().expect("an ellipse is bounded");
    /// assert!((area - std::f64::consts::PI).abs() < 1e-13);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn function(text: &str) -> Result<Self, Error> {
        /// The numbers of pieces that are tried.
        const PIECES: std::ops::RangeInclusive<u32> = 6..=11;
        let curve = VelocityExpression::parse(text, TAU)?;
        let mut best: Option<(Curve<'static>, [f64; 2])> = None;
        for exponent in PIECES {
            let (found, off) = interpolated(&curve, 1 << exponent)?;
            let is_done = off[0] <= off[1];
            best = Some((found, off));
            if is_done {
                break;
            }
        }
        let (found, [off, rounding]) = best.expect("some number of pieces is tried");
        let mut made = Self::from_set(YinSet::oriented(&[found])?);
        if off > rounding {
            let message = format!("the spline that stands for {text} is off by about {off:.1e}");
            made.remarks.push(Remark::new(RemarkCode::ArcsApproximated, message));
        }
        Ok(made)
    }

    /// How far sets are from this one, one after the other, and how fast they come near it: rates are exponents of the mean distance of
    /// knots. Each set comes with the name of its file, and so does this one.
    ///
    /// # Errors
    /// Those of [`YinSet::comparison`].
    ///
    /// # Examples
    /// Squares that shrink to the one they are compared with, at order 1.
    /// ```
    /// use coface_answers::{PlanarSet, SetRequest};
    /// use coface_io::{Format, ReadOptions, read_boundary};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = |side: f64| {
    ///     let text = format!("POLYGON ((0 0, {side} 0, {side} 1, 0 1, 0 0))");
    ///     PlanarSet::of(&read_boundary(text.as_bytes(), Format::Wkt, &ReadOptions::default())?, &SetRequest::default())
    /// };
    /// let sets = [("a".to_owned(), square(1.5)?), ("b".to_owned(), square(1.25)?)];
    /// let found = square(1.0)?.series("c", &sets)?;
    /// for (row, area) in found.rows.iter().zip([0.5, 0.25]) {
    ///     assert!((row.area_xor.unwrap_or(0.0) - area).abs() <= row.area_xor_error);
    /// }
    /// # Ok(()) }
    /// ```
    pub fn series(&self, name: &str, sets: &[(String, Self)]) -> Result<YinSeriesAnswer, Error> {
        let mut rows: Vec<YinSeriesRow> = Vec::with_capacity(sets.len());
        let mut remarks = self.remarks.clone();
        for (file, one) in sets {
            remarks.extend(one.remarks.iter().filter(|remark| !self.remarks.contains(remark)).cloned());
            let found = one.compared_with(file, self, name)?;
            let knots: usize =
                (0..one.set.curve_count()).map(|curve| one.set.curve(curve).piece_count()).sum();
            let extent = one.bounding_box().map_or(0.0, |[a, b]| f64::max(b[0] - a[0], b[1] - a[1]));
            let perimeter = one.set.perimeter((PRECISION * extent).max(f64::MIN_POSITIVE));
            let spacing = Some(perimeter / knots as f64).filter(|spacing| spacing.is_finite());
            let rate = |of: fn(&YinSeriesRow) -> Option<f64>, error: Option<f64>| {
                let before = rows.last()?;
                let fall = (of(before)? / error?).ln() / (before.spacing? / spacing?).ln();
                Some(fall).filter(|rate| rate.is_finite())
            };
            rows.push(YinSeriesRow {
                file: file.clone(),
                knots,
                spacing,
                area_xor: found.area_xor,
                area_xor_error: found.area_xor_error,
                // Below its own error an area says nothing.
                area_rate: rate(
                    |row| row.area_xor,
                    found.area_xor.filter(|area| *area > found.area_xor_error),
                ),
                area_signed: found.area_signed,
                area_signed_error: found.area_signed_error,
                hausdorff: found.hausdorff,
                hausdorff_rate: rate(|row| row.hausdorff, found.hausdorff),
                hausdorff_error: found.hausdorff_error,
                along_normals: found.along_normals,
                along_normals_error: found.along_normals_error,
                curvature: found.curvature,
                curvature_error: found.curvature_error,
                curvature_rate: rate(|row| row.curvature, found.curvature),
                components: found.components[0],
                holes: found.holes[0],
            });
        }
        Ok(YinSeriesAnswer { reference: name.to_owned(), rows, remarks })
    }
}

/// The parameters at which a piece has the points of the curve: the extrema of a Chebyshev polynomial.
fn nodes(count: usize) -> Vec<f64> {
    let last = (count - 1) as f64;
    (0..count).map(|i| 0.5 - 0.5 * (std::f64::consts::PI * i as f64 / last).cos()).collect()
}

/// The Bernstein polynomials of a degree at a parameter.
fn bernstein(degree: usize, s: f64) -> Vec<f64> {
    let mut values = vec![0.0; degree + 1];
    values[0] = 1.0;
    for raised in 1..=degree {
        for at in (0..=raised).rev() {
            let before = if at > 0 { values[at - 1] } else { 0.0 };
            values[at] = (1.0 - s) * values[at] + s * before;
        }
    }
    values
}

/// A closed spline of order 8 with so many pieces through points of a curve; how far it is off between them, and how far rounding lets it be.
fn interpolated(curve: &VelocityExpression, pieces: usize) -> Result<(Curve<'static>, [f64; 2]), Error> {
    /// Points may be off by so many times the last digit of the largest coordinate.
    const ROUNDING: f64 = 32.0;
    let order = Order::new(8)?;
    let count = order.value();
    let nodes = nodes(count);
    let point = |t: f64| -> Result<[f64; 2], Error> {
        let found = curve.velocity([f64::NAN; 2], t);
        match found.iter().all(|x| x.is_finite()) {
            true => Ok(found),
            false => Err(Error::invalid(format!("the curve has no point at t = {t}"))
                .with_cure("write expressions of t alone that have values from 0 to 2*pi")),
        }
    };
    let start = point(0.0)?;
    let step = TAU / pieces as f64;
    let mut controls = vec![start];
    let mut largest = 0.0f64;
    let mut off = 0.0f64;
    for piece in 0..pieces {
        let at = |s: f64| step * (piece as f64 + s);
        let mut rows: Vec<(Vec<f64>, [f64; 2])> = Vec::with_capacity(count);
        for &s in &nodes {
            rows.push((bernstein(count - 1, s), point(at(s))?));
        }
        let own = solved(rows);
        largest = own.as_flattened().iter().fold(largest, |largest, x| largest.max(x.abs()));
        for pair in nodes.windows(2) {
            let s = 0.5 * (pair[0] + pair[1]);
            let (there, weights) = (point(at(s))?, bernstein(count - 1, s));
            for axis in 0..2 {
                let value: f64 = weights.iter().zip(&own).map(|(weight, point)| weight * point[axis]).sum();
                off = off.max((value - there[axis]).abs());
            }
        }
        controls.extend(&own[1..]);
    }
    let rounding = ROUNDING * f64::EPSILON * largest;
    let end = controls[controls.len() - 1];
    if (0..2).any(|axis| (end[axis] - start[axis]).abs() > 1e-9 * largest) {
        return Err(Error::invalid(format!(
            "the curve does not close: it begins at ({}, {}) and ends at ({}, {})",
            start[0], start[1], end[0], end[1]
        ))
        .with_cure("write expressions of t that have one value at 0 and 2*pi"));
    }
    let last = controls.len() - 1;
    controls[last] = start;
    let knots = (0..=pieces).map(|piece| step * piece as f64).collect();
    Ok((Curve::from_controls(order, controls, knots)?, [off, rounding]))
}

/// The solution of linear equations with two right sides, by elimination with pivots.
fn solved(mut rows: Vec<(Vec<f64>, [f64; 2])>) -> Vec<[f64; 2]> {
    let count = rows.len();
    for column in 0..count {
        let pivot =
            (column..count).max_by(|&a, &b| rows[a].0[column].abs().total_cmp(&rows[b].0[column].abs()));
        rows.swap(column, pivot.expect("there are rows left"));
        let (weights, right) = rows[column].clone();
        for row in &mut rows[column + 1..] {
            let factor = row.0[column] / weights[column];
            for (own, weight) in row.0.iter_mut().zip(&weights).skip(column) {
                *own -= factor * weight;
            }
            row.1 = [0, 1].map(|axis| row.1[axis] - factor * right[axis]);
        }
    }
    let mut found = vec![[0.0; 2]; count];
    for row in (0..count).rev() {
        let (weights, right) = &rows[row];
        found[row] = [0, 1].map(|axis| {
            let known: f64 = (row + 1..count).map(|at| weights[at] * found[at][axis]).sum();
            (right[axis] - known) / weights[row]
        });
    }
    found
}
