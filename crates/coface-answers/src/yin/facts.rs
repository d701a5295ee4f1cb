//! What is known of a set.

use super::PlanarSet;
use crate::answer::{
    Remark, RemarkCode, YinComparisonAnswer, YinCurve, YinDecision, YinKinkPoint, YinPieceSource,
    YinProvenance, YinSetAnswer,
};
use coface_algebra::{Error, VertexId};
use coface_yin::{Assumption, Combination, KnotIndex, PieceSource, UncertifiedDecision, YinSet};

/// The part of the largest extent of a set that its perimeter is known to.
const PRECISION: f64 = 1e-13;

impl PlanarSet {
    /// The box around all curves; none without curves.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{PlanarSet, SetRequest};
    /// use coface_io::{Format, ReadOptions, read_boundary};
    /// let text = &b"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"[..];
    /// let drawing = read_boundary(text, Format::Wkt, &ReadOptions::default())?;
    /// let square = PlanarSet::of(&drawing, &SetRequest::default())?;
    /// assert_eq!(square.bounding_box(), Some([[0.0, 0.0], [2.0, 2.0]]));
    /// # Ok(()) }
    /// ```
    pub fn bounding_box(&self) -> Option<[[f64; 2]; 2]> {
        let boxes = (0..self.set.curve_count()).map(|curve| self.set.curve(curve).bounding_box());
        boxes.reduce(|[low, high], [lower, higher]| {
            [
                [0, 1].map(|axis| f64::min(low[axis], lower[axis])),
                [0, 1].map(|axis| f64::max(high[axis], higher[axis])),
            ]
        })
    }

    /// How far another set is from this one, as an answer; both with the names of their files.
    ///
    /// # Errors
    /// Those of [`YinSet::comparison`] and [`YinSet::betti_open`].
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{PlanarSet, SetRequest};
    /// use coface_io::{Format, ReadOptions, read_boundary};
    /// let read = |text: &str| {
    ///     let drawing = read_boundary(text.as_bytes(), Format::Wkt, &ReadOptions::default())?;
    ///     PlanarSet::of(&drawing, &SetRequest::default())
    /// };
    /// let square = read("POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))")?;
    /// let taller = read("POLYGON ((0 0, 2 0, 2 3, 0 3, 0 0))")?;
    /// let found = square.compared_with("a.wkt", &taller, "b.wkt")?;
    /// assert!((found.area_xor.unwrap_or(0.0) - 2.0).abs() <= found.area_xor_error && found.area_xor_error < 1e-12);
    /// assert!((found.hausdorff.unwrap_or(0.0) - 1.0).abs() < 1e-12);
    /// # Ok(()) }
    /// ```
    pub fn compared_with(
        &self,
        name: &str,
        other: &Self,
        other_name: &str,
    ) -> Result<YinComparisonAnswer, Error> {
        let found = self.set.comparison(&other.set)?;
        let betti = [self.set.betti_open()?, other.set.betti_open()?];
        Ok(YinComparisonAnswer {
            files: vec![name.to_owned(), other_name.to_owned()],
            area_xor: finite(found.area_xor()),
            area_xor_error: found.area_xor_error(),
            area_signed: finite(found.area_signed()),
            area_signed_error: found.area_signed_error(),
            hausdorff: finite(found.hausdorff()),
            hausdorff_error: found.hausdorff_error(),
            along_normals: found.along_normals().and_then(finite),
            along_normals_error: found.along_normals_error(),
            normals_left_out: found.normals_left_out(),
            curvature: found.curvature().and_then(finite),
            curvature_error: found.curvature_error(),
            components: betti.map(|[components, _]| components),
            holes: betti.map(|[_, holes]| holes),
            remarks: self.remarks.iter().chain(&other.remarks).cloned().collect(),
        })
    }

    /// The set as an answer.
    ///
    /// # Errors
    /// Those of [`YinSet::betti_open`].
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{PlanarSet, SetRequest};
    /// use coface_io::{Format, ReadOptions, read_boundary};
    /// let text = &b"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"[..];
    /// let drawing = read_boundary(text, Format::Wkt, &ReadOptions::default())?;
    /// let square = PlanarSet::of(&drawing, &SetRequest::default())?;
    /// assert_eq!((square.answer()?.area, square.answer()?.perimeter), (Some(4.0), Some(8.0)));
    /// # Ok(()) }
    /// ```
    pub fn answer(&self) -> Result<YinSetAnswer, Error> {
        /// Areas and lengths of sets that are so much smaller are numbers.
        const DOWN: f64 = 1e-200;
        /// And areas of sets that are so much larger.
        const UP: f64 = 1e100;
        let set = &self.set;
        let frame = self.bounding_box();
        let extent = frame.map_or(0.0, |[low, high]| (high[0] - low[0]).max(high[1] - low[1]));
        let tolerance = (PRECISION * extent).max(f64::MIN_POSITIVE);
        let mut kinks = set.kinks().iter().peekable();
        let mut perimeter = 0.0;
        let mut curves = Vec::with_capacity(set.curve_count());
        for number in 0..set.curve_count() {
            let curve = set.curve(number);
            let (mut own, mut vertices) = (Vec::new(), Vec::new());
            while let Some((knot, vertex)) = kinks.next_if(|(knot, _)| knot.curve as usize == number) {
                own.push(knot.knot);
                vertices.push(vertex.to_u32());
            }
            let area = curve.signed_area();
            let length = curve.length(tolerance);
            perimeter += length;
            curves.push(YinCurve {
                sign: if area < 0.0 { -1 } else { 1 },
                area: finite(area),
                length: finite(length),
                knots: curve.piece_count(),
                kinks: own,
                vertices,
                parent: set.forest().parent(number),
                depth: set.forest().depth(number),
                name: self.names.get(number).cloned().flatten(),
            });
        }
        let area = set.area();
        let mut remarks = self.remarks.clone();
        if area.is_some_and(|area| !area.is_finite()) || !perimeter.is_finite() {
            let what = if perimeter.is_finite() { "the area" } else { "the perimeter" };
            let message = format!("{what} is beyond the range of numbers: scale the set down by {DOWN:e}");
            remarks.push(Remark::new(RemarkCode::BeyondRange, message));
        }
        if area.is_some_and(|area| area.abs() < f64::MIN_POSITIVE) && set.curve_count() > 0 {
            let message = format!("the area is below the range of numbers: scale the set up by {UP:e}");
            remarks.push(Remark::new(RemarkCode::BeyondRange, message));
        }
        Ok(YinSetAnswer {
            empty: set.is_empty(),
            plane: set.is_plane(),
            bounded: set.is_bounded(),
            area: area.and_then(finite),
            perimeter: finite(perimeter),
            curve_counts: set.curve_counts(),
            betti_open: set.betti_open()?,
            betti_closed: set.betti_closed()?,
            curves,
            order: set.order().value(),
            atoms: set.atoms().iter().map(|atom| atom.curves().collect()).collect(),
            kinks: set.kinks().len(),
            bounding_box: frame,
            remarks,
        })
    }

    /// The kinks with their names and places.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{PlanarSet, SetRequest};
    /// use coface_io::{Format, ReadOptions, read_boundary};
    /// let text = &b"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"[..];
    /// let drawing = read_boundary(text, Format::Wkt, &ReadOptions::default())?;
    /// let square = PlanarSet::of(&drawing, &SetRequest::default())?;
    /// assert!(square.kink_points().is_empty(), "the corners of a polyline are no kinks");
    /// # Ok(()) }
    /// ```
    pub fn kink_points(&self) -> Vec<YinKinkPoint> {
        let place = |(at, vertex): (KnotIndex, VertexId)| {
            let point = self.set.curve(at.curve as usize).knot_point(at.knot as usize);
            YinKinkPoint::new(vertex.to_u32(), at.curve, at.knot, point)
        };
        self.set.kinks().iter().map(place).collect()
    }

    /// Where the pieces of the boundary of a combination come from: for each curve the source of each of its pieces, the part of a
    /// piece of an operand by parameters in the unit interval, which fall where the result runs against its source.
    pub fn provenance(combination: &Combination) -> YinProvenance {
        let set: &YinSet = combination.set();
        let mut sources = combination.sources().iter();
        let of_curve =
            |curve: usize| sources.by_ref().take(set.curve(curve).piece_count()).map(piece_source).collect();
        YinProvenance { sources: (0..set.curve_count()).map(of_curve).collect() }
    }

    /// The decisions of a combination that were taken without proof.
    pub fn decisions(combination: &Combination) -> Vec<YinDecision> {
        let answer = |decision: &UncertifiedDecision| YinDecision {
            point: decision.point(),
            pieces: decision.pieces().iter().map(piece_source).collect(),
            assumed: match decision.assumption() {
                Assumption::SamePoint => "the same point",
                Assumption::SameArc => "the same arc",
                Assumption::ArcOrder => "the order of arcs at a point",
                Assumption::SmallCurve => "a curve too small to be kept",
            }
            .to_owned(),
        };
        combination.report().iter().map(answer).collect()
    }
}

fn piece_source(source: &PieceSource) -> YinPieceSource {
    let [from, to] = source.range;
    (source.operand, source.curve, source.piece, from, to)
}

/// A number within the range of numbers.
fn finite(number: f64) -> Option<f64> {
    number.is_finite().then_some(number)
}
