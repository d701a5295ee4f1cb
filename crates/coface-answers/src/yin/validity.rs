//! Whether the curves of a file bound a set, the unique form of a set, and its images.

use super::{PlanarSet, SetRequest};
use crate::answer::{
    YinFaultAnswer, YinFaultKind, YinNormalizeAnswer, YinRoughKnot, YinSetAnswer, YinValidationAnswer,
};
use coface_algebra::Error;
use coface_geometry::AffineMap;
use coface_io::yin::{BoundaryDrawing, Filling};
use coface_yin::{Curve, Order, YinFault, YinSet};

impl PlanarSet {
    /// Whether the curves of a drawing bound a set: all faults of curves by themselves, or the first of curves together.
    ///
    /// # Errors
    /// Those of [`YinSet::bends`].
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{PlanarSet, SetRequest, answer::YinFaultKind};
    /// use coface_io::{Format, ReadOptions, read_boundary};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = br#"{"curves": [{"points": [[0, 0], [2, 2], [2, 0], [0, 2]]}]}"#;
    /// let drawing = read_boundary(&text[..], Format::Json, &ReadOptions::default())?;
    /// let found = PlanarSet::validation("bow.json", &drawing, &SetRequest::default())?;
    /// assert!(!found.valid && found.faults[0].kind == YinFaultKind::SelfMeeting);
    /// assert_eq!(found.faults[0].point, Some([1.0, 1.0]));
    /// # Ok(()) }
    /// ```
    pub fn validation(
        file: &str,
        drawing: &BoundaryDrawing,
        request: &SetRequest,
    ) -> Result<YinValidationAnswer, Error> {
        let made = Self::of(drawing, request);
        let mut answer = YinValidationAnswer {
            file: file.to_owned(),
            valid: made.is_ok(),
            faults: Vec::new(),
            curves: drawing.curves().len(),
            roughest: None,
            remarks: drawing.remarks().to_vec(),
        };
        match made {
            Ok(set) => {
                answer.roughest = if set.set.order() == Order::LINEAR { None } else { roughest(&set.set)? };
                answer.remarks = set.remarks;
            }
            Err(fault) => {
                let has_rule = |(filling, _): &(Filling, _)| matches!(filling, Filling::Stated(_));
                if request.rule.is_none() && !drawing.groups().iter().any(has_rule) {
                    answer.faults = faults_of_curves(drawing, request);
                }
                if answer.faults.is_empty() {
                    answer.faults = vec![other(Vec::new(), &fault)];
                }
            }
        }
        Ok(answer)
    }

    /// The set in its unique form: curves that cross by rounding cut and pasted, knots within straight parts of polylines left out,
    /// curves from their lowest knots and in one order. Two sets of order 2 have the same points if and only if these are equal.
    ///
    /// # Errors
    /// Those of [`YinSet::normalized`] and [`Self::answer`].
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{PlanarSet, SetRequest};
    /// use coface_io::{Format, ReadOptions, read_boundary};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = b"POLYGON ((4 0, 4 4, 0 4, 0 0, 2 0, 4 0))";
    /// let square = PlanarSet::of(&read_boundary(&text[..], Format::Wkt, &ReadOptions::default())?, &SetRequest::default())?;
    /// let (unique, answer) = square.normalized("square.wkt")?;
    /// assert_eq!((answer.rounds, answer.straightened), (0, 1));
    /// assert_eq!(unique.set().curve(0).knot_point(0), [0.0, 0.0]);
    /// # Ok(()) }
    /// ```
    pub fn normalized(self, file: &str) -> Result<(Self, YinNormalizeAnswer), Error> {
        let found = self.set.normalized()?;
        let rounds = found.round_count();
        let found = found.into_set();
        let knots =
            |set: &YinSet| (0..set.curve_count()).map(|curve| set.curve(curve).piece_count()).sum::<usize>();
        let straight = if found.order() == Order::LINEAR { found.straightened() } else { found.clone() };
        let straightened = knots(&found).saturating_sub(knots(&straight));
        let unique = Self { set: straight.canonical(), names: Vec::new(), remarks: self.remarks };
        let set: YinSetAnswer = unique.answer()?;
        Ok((unique, YinNormalizeAnswer { file: file.to_owned(), rounds, straightened, set }))
    }

    /// The image of the set under an affine map of the plane; curves and kinks keep their names.
    ///
    /// # Errors
    /// Those of [`YinSet::transformed`].
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{PlanarSet, SetRequest};
    /// use coface_geometry::AffineMap;
    /// use coface_io::{Format, ReadOptions, read_boundary};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = b"POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))";
    /// let square = PlanarSet::of(&read_boundary(&text[..], Format::Wkt, &ReadOptions::default())?, &SetRequest::default())?;
    /// let moved = square.transformed(&AffineMap::new(vec![0.0, 2.0, 1.0, 0.0], vec![1.0, 0.0])?)?;
    /// assert_eq!((moved.set().area(), moved.bounding_box()), (Some(32.0), Some([[1.0, 0.0], [9.0, 4.0]])));
    /// # Ok(()) }
    /// ```
    pub fn transformed(&self, map: &AffineMap) -> Result<Self, Error> {
        let set = self.set.transformed(map)?;
        Ok(Self { set, names: self.names.clone(), remarks: self.remarks.clone() })
    }
}

/// What is wrong with curves by themselves; if nothing is, with curves that have the set on their left together.
fn faults_of_curves(drawing: &BoundaryDrawing, request: &SetRequest) -> Vec<YinFaultAnswer> {
    let mut faults = Vec::new();
    let mut curves: Vec<Curve<'static>> = Vec::new();
    for (number, given) in drawing.curves().iter().enumerate() {
        let curve = match given.curve(drawing.order(), &request.ends) {
            Ok(curve) => curve,
            Err(error) => {
                faults.push(other(vec![number], &super::making::named(number, &error)));
                continue;
            }
        };
        match YinSet::fault(std::slice::from_ref(&curve)) {
            Ok(None) => curves.push(curve),
            Ok(Some(fault)) => faults.push(answer_of(&fault, Some(number))),
            Err(error) => faults.push(other(vec![number], &super::making::named(number, &error))),
        }
    }
    let are_left = drawing.groups().iter().all(|(filling, _)| *filling == Filling::Left);
    if faults.is_empty()
        && are_left
        && let Ok(Some(fault)) = YinSet::fault(&curves)
    {
        faults.push(answer_of(&fault, None));
    }
    faults
}

fn other(curves: Vec<usize>, error: &Error) -> YinFaultAnswer {
    YinFaultAnswer { kind: YinFaultKind::Other, curves, point: None, message: error.message().to_owned() }
}

/// A fault as an answer, of the curve with this number in the file if it is about one alone.
fn answer_of(fault: &YinFault, alone: Option<usize>) -> YinFaultAnswer {
    let (kind, curves, point) = match *fault {
        YinFault::Open { curve } => (YinFaultKind::Open, vec![curve], None),
        YinFault::TooFewPieces { curve } => (YinFaultKind::TooFewPieces, vec![curve], None),
        YinFault::ZeroLength { curve, .. } => (YinFaultKind::ZeroLength, vec![curve], None),
        YinFault::SelfMeeting { curve, point } => (YinFaultKind::SelfMeeting, vec![curve], Some(point)),
        YinFault::Crossing { curves, point } => (YinFaultKind::Crossing, curves.to_vec(), Some(point)),
        YinFault::Overlap { curves, ends } => (YinFaultKind::Overlap, curves.to_vec(), Some(ends[0])),
        YinFault::Orientation { curve, parent } => (YinFaultKind::Orientation, vec![curve, parent], None),
        YinFault::MixedRoots { curves } => (YinFaultKind::MixedRoots, curves.to_vec(), None),
        _ => (YinFaultKind::Other, Vec::new(), None),
    };
    let Some(number) = alone else {
        return YinFaultAnswer { kind, curves, point, message: fault.to_string() };
    };
    let message = fault.to_string().replace("curve 0", &format!("curve {number}"));
    YinFaultAnswer {
        kind,
        curves: vec![number],
        point,
        message: message.replace("polyline 0", &format!("polyline {number}")),
    }
}

/// The knot that is no kink at which a curve turns most.
fn roughest(set: &YinSet) -> Result<Option<YinRoughKnot>, Error> {
    let bends = set.bends()?;
    let places =
        bends.iter().enumerate().filter_map(|(curve, bend)| bend.roughest.map(|place| (curve, place)));
    let most = places.max_by(|(_, a), (_, b)| a.value.abs().total_cmp(&b.value.abs()));
    Ok(most.map(|(curve, place)| YinRoughKnot {
        curve,
        knot: place.piece,
        point: place.point,
        degrees: place.value.to_degrees(),
    }))
}
