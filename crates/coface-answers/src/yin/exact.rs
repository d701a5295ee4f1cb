//! Disks and ellipses as sets right to rounding, and series of sets that come near one.

use super::PlanarSet;
use crate::answer::{YinSeriesAnswer, YinSeriesRow};
use coface_algebra::Error;
use coface_geometry::{AffineMap, Angle};
use coface_yin::{Curve, Order, YinSet};

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
                components: found.components[0],
                holes: found.holes[0],
            });
        }
        Ok(YinSeriesAnswer { reference: name.to_owned(), rows, remarks })
    }
}
