//! Places on and around a boundary: points located, samples, curvature.

use super::PlanarSet;
use crate::answer::{
    YinBendPlace, YinBoundarySample, YinCurvatureAnswer, YinCurveBend, YinLocateAnswer, YinLocatedPoint,
    YinLocation, YinSampleAnswer,
};
use coface_algebra::Error;
use coface_yin::{CurveBend, CurvePlace, Sample, Sampling, SetLocation};

impl PlanarSet {
    /// Where points lie: in the set, on its boundary or outside, with the nearest point of the boundary and the distance from it,
    /// positive inside. For a point on the boundary the distance is 0.
    ///
    /// # Errors
    /// Those of [`YinSet::locate_all`](coface_yin::YinSet::locate_all).
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{PlanarSet, SetRequest, answer::YinLocation};
    /// use coface_io::{Format, ReadOptions, read_boundary};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = b"POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))";
    /// let square = PlanarSet::of(&read_boundary(&text[..], Format::Wkt, &ReadOptions::default())?, &SetRequest::default())?;
    /// let found = square.located("square.wkt", &[[1.0, 2.0], [4.0, 1.0], [7.0, 8.0]])?;
    /// assert_eq!(found.points[1].location, YinLocation::Boundary);
    /// assert_eq!(found.points.iter().map(|point| point.signed_distance).collect::<Vec<_>>(), [Some(1.0), Some(0.0), Some(-5.0)]);
    /// # Ok(()) }
    /// ```
    pub fn located(&self, file: &str, points: &[[f64; 2]]) -> Result<YinLocateAnswer, Error> {
        let locations = self.set.locate_all(points)?;
        let nearest = self.set.nearest_all(points)?;
        let answer = |((&point, location), nearest)| {
            let (location, sign) = match location {
                SetLocation::Inside => (YinLocation::Inside, 1.0),
                SetLocation::Boundary { .. } => (YinLocation::Boundary, 0.0),
                SetLocation::Outside => (YinLocation::Outside, -1.0),
            };
            let nearest: Option<coface_yin::NearestPoint> = nearest;
            YinLocatedPoint {
                point,
                location,
                signed_distance: nearest.map(|found| if sign == 0.0 { 0.0 } else { sign * found.distance }),
                nearest: nearest.map(|found| found.point),
                curve: nearest.map(|found| found.curve),
                piece: nearest.map(|found| found.piece),
                parameter: nearest.map(|found| found.parameter),
            }
        };
        let points: Vec<YinLocatedPoint> = points.iter().zip(locations).zip(nearest).map(answer).collect();
        let count = |location| points.iter().filter(|point| point.location == location).count();
        Ok(YinLocateAnswer {
            file: file.to_owned(),
            inside: count(YinLocation::Inside),
            boundary: count(YinLocation::Boundary),
            outside: count(YinLocation::Outside),
            points,
            remarks: self.remarks.clone(),
        })
    }

    /// Points along the boundary, with lengths, directions and curvatures.
    ///
    /// # Errors
    /// Those of [`YinSet::samples`](coface_yin::YinSet::samples).
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{PlanarSet, SetRequest};
    /// use coface_io::{Format, ReadOptions, read_boundary};
    /// use coface_yin::Sampling;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = b"POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))";
    /// let square = PlanarSet::of(&read_boundary(&text[..], Format::Wkt, &ReadOptions::default())?, &SetRequest::default())?;
    /// let found = square.sampled("square.wkt", Sampling::PerCurve(16))?;
    /// assert_eq!((found.samples.len(), found.samples[5].point), (16, [4.0, 1.0]));
    /// # Ok(()) }
    /// ```
    pub fn sampled(&self, file: &str, sampling: Sampling) -> Result<YinSampleAnswer, Error> {
        let answer = |sample: Sample| YinBoundarySample {
            curve: sample.curve,
            piece: sample.piece,
            parameter: sample.parameter,
            length: sample.length,
            point: sample.point,
            tangent: sample.tangent,
            curvature: sample.curvature,
        };
        let samples = self.set.samples(sampling)?.into_iter().map(answer).collect();
        Ok(YinSampleAnswer { file: file.to_owned(), samples, remarks: self.remarks.clone() })
    }

    /// How each curve bends: its least and greatest curvature, and where it turns most at a knot.
    ///
    /// # Errors
    /// Those of [`YinSet::bends`](coface_yin::YinSet::bends).
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{PlanarSet, SetRequest};
    /// use coface_io::{Format, ReadOptions, read_boundary};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = b"POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))";
    /// let square = PlanarSet::of(&read_boundary(&text[..], Format::Wkt, &ReadOptions::default())?, &SetRequest::default())?;
    /// let found = &square.curvature("square.wkt")?.curves[0];
    /// assert_eq!((found.greatest.value, found.sharpest.value), (0.0, 90.0));
    /// # Ok(()) }
    /// ```
    pub fn curvature(&self, file: &str) -> Result<YinCurvatureAnswer, Error> {
        let bent = |(curve, bend): (usize, CurveBend)| YinCurveBend {
            curve,
            least: bend_place(bend.least),
            greatest: bend_place(bend.greatest),
            sharpest: in_degrees(bend.sharpest),
            roughest: bend.roughest.map(in_degrees),
        };
        let curves = self.set.bends()?.into_iter().enumerate().map(bent).collect();
        Ok(YinCurvatureAnswer { file: file.to_owned(), curves, remarks: self.remarks.clone() })
    }
}

pub(super) fn bend_place(place: CurvePlace) -> YinBendPlace {
    YinBendPlace { piece: place.piece, parameter: place.parameter, point: place.point, value: place.value }
}

pub(super) fn in_degrees(turn: CurvePlace) -> YinBendPlace {
    YinBendPlace { value: turn.value.to_degrees(), ..bend_place(turn) }
}
