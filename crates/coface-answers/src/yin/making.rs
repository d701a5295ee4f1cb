//! From what a file says about a boundary to a set.

use crate::answer::{Remark, RemarkCode};
use crate::text;
use coface_algebra::{Error, ErrorKind};
use coface_arrange::boolean::InsideRule;
use coface_io::yin::{BoundaryCurve, BoundaryDrawing, Filling, flattened};
use coface_yin::{Combination, Curve, EndCondition, KnotIndex, Order, YinSet, turning_kinks};
use std::borrow::Cow;

/// Which knots are kinks.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum KinkRequest {
    /// None.
    None,
    /// All knots.
    All,
    /// Those at which the boundary turns by more than this angle, in radians.
    Detected(f64),
    /// These.
    Listed(Vec<KnotIndex>),
}

/// How a file becomes a set.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct SetRequest {
    /// The order; that of the file if none is said. Lines stay straight where the order rises.
    pub order: Option<Order>,
    /// Fit splines to the knots, instead of taking the curves of the file.
    pub fit: bool,
    /// Which winding numbers are inside. Without a rule, curves that cross themselves or each other are refused, unless the file has a
    /// rule.
    pub rule: Option<InsideRule>,
    /// The kinks; those of the file if none are said.
    pub kinks: Option<KinkRequest>,
    /// The ends of splines at kinks.
    pub ends: EndCondition,
    /// How far chords may be from curves where the order falls to 2, in the unit of the file.
    pub flatten: Option<f64>,
    /// Let curves begin at their lowest knots, and come in one order whatever the file's is.
    pub canonical: bool,
    /// Leave knots where splines have a corner as they are, instead of taking them as kinks: for what was a set before.
    #[doc(hidden)]
    pub as_declared: bool,
}

impl Default for SetRequest {
    fn default() -> Self {
        Self {
            order: None,
            fit: false,
            rule: None,
            kinks: None,
            ends: EndCondition::NotAKnot,
            flatten: None,
            canonical: false,
            as_declared: false,
        }
    }
}

/// A set of the plane that a file describes.
///
/// # Examples
/// ```
/// use coface_io as io;
/// use coface_io::{Format, ReadOptions};
/// use coface_answers::{PlanarSet, SetRequest};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let text = b"POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 2 1, 2 2, 1 2, 1 1))";
/// let drawing = io::read_boundary(&text[..], Format::Wkt, &ReadOptions::default())?;
/// let set = PlanarSet::of(&drawing, &SetRequest::default())?;
/// assert_eq!((set.set().area(), set.set().betti_open()?), (Some(80.0), [1, 1]));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct PlanarSet {
    pub(super) set: YinSet,
    pub(super) names: Vec<Option<String>>,
    pub(super) remarks: Vec<Remark>,
}

/// A curve with its kinks.
#[derive(Clone)]
struct Made {
    curve: Curve<'static>,
    kinks: Vec<u32>,
    /// The names of the kinks, if the file has any.
    kink_names: Option<Vec<u32>>,
    name: Option<String>,
}

impl Made {
    /// The same with the other side on its left; it begins at the same knot.
    fn reversed(&self) -> Self {
        let count = self.curve.piece_count() as u32;
        Self {
            curve: self.curve.reversed(),
            kinks: self.kinks.iter().map(|&kink| (count - kink) % count).collect(),
            kink_names: self.kink_names.clone(),
            name: self.name.clone(),
        }
    }
}

impl PlanarSet {
    /// The set that a drawing describes.
    ///
    /// Curves with the set on their left are taken as they are. Of a polygon, the outer ring is turned counterclockwise and the others
    /// clockwise. Where the file has a rule, what it says is inside. Several polygons are joined.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] with the place at which curves cross or share an arc, naming a point that is not finite, a kink that is
    /// none of the knots, or curves that would have to be flattened; those of the fit.
    ///
    /// # Complexity
    /// That of an overlay of all curves.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{PlanarSet, SetRequest};
    /// use coface_io::{Format, ReadOptions, read_boundary};
    /// let text = &b"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"[..];
    /// let drawing = read_boundary(text, Format::Wkt, &ReadOptions::default())?;
    /// let square = PlanarSet::of(&drawing, &SetRequest::default())?;
    /// assert_eq!(square.set().area(), Some(4.0));
    /// # Ok(()) }
    /// ```
    pub fn of(drawing: &BoundaryDrawing, request: &SetRequest) -> Result<Self, Error> {
        drawing.check()?;
        let order = match (request.order, request.fit) {
            (Some(order), _) => order,
            (None, true) => drawing.order().max(Order::CUBIC),
            (None, false) => drawing.order(),
        };
        let mut remarks = drawing.remarks().to_vec();
        if drawing.is_plane() || drawing.curves().is_empty() {
            let set = if drawing.is_plane() { YinSet::plane(order) } else { YinSet::empty(order) };
            check_listed(&set, request.kinks.as_ref())?;
            return Ok(Self { set, names: Vec::new(), remarks });
        }
        check_curves_of_kinks(drawing.curves().len(), request)?;
        let mut request = Cow::Borrowed(request);
        if order == Order::LINEAR && drawing.order() > order && !request.fit && request.flatten.is_none() {
            let (tolerance, remark) = assumed_flattening(drawing, &request.ends)?;
            request.to_mut().flatten = Some(tolerance);
            remarks.push(remark);
        }
        let request = &*request;
        let mut made = Vec::with_capacity(drawing.curves().len());
        for (number, curve) in drawing.curves().iter().enumerate() {
            let of_curve = make(number, curve, drawing.order(), order, request);
            made.push(of_curve.map_err(|error| {
                let error = named(number, &error);
                curve.line().map_or(error.clone(), |line| error.at_line(line))
            })?);
        }
        let (mut set, names) = combined(drawing, &made, request)?;
        if set.curve_count() == 0 {
            remarks.push(Remark::new(
                RemarkCode::EmptyBoundary,
                "the curves bound nothing: the set has no boundary",
            ));
        }
        set.set_ends(&request.ends);
        match &request.kinks {
            // Splines are fitted with them already.
            Some(asked) if !request.fit => {
                let knots = knots_of(&set, asked)?;
                set = set.with_declared_kinks(&knots, None, None)?;
            }
            _ => {
                if let Some(next) = drawing.next_kink_name() {
                    let kinks: (Vec<KnotIndex>, Vec<u32>) =
                        set.kinks().iter().map(|(at, vertex)| (at, vertex.to_u32())).unzip();
                    set = set.with_declared_kinks(&kinks.0, Some(&kinks.1), Some(next))?;
                }
                if !request.fit && !request.as_declared {
                    let (with_corners, count) = with_kinks_at_corners(set)?;
                    set = with_corners;
                    remarks.extend(corners_as_kinks(count, "the file does not tell kinks"));
                }
            }
        }
        let mut planar = Self { set, names, remarks };
        if request.canonical {
            planar = planar.canonical();
        }
        Ok(planar)
    }

    /// The set that closed curves bound, each with the numbers of the knots that are its kinks: it keeps them. A knot of a spline at which the
    /// boundary has a corner is a kink too, and a remark says so. With `orient` curves are turned as [`YinSet::oriented`] does it.
    ///
    /// # Errors
    /// Those of [`YinSet::new`], and [`ErrorKind::InvalidInput`] for a kink that is none of the knots.
    ///
    /// # Complexity
    /// That of an overlay of all curves.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::PlanarSet;
    /// use coface_yin::{Curve, EndCondition, Order};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
    /// let square = Curve::fit_closed(&corners, &[0, 1, 2, 3], Order::CUBIC, &EndCondition::NotAKnot)?;
    /// let set = PlanarSet::of_curves(&[(square, vec![0, 1, 2, 3])], false)?;
    /// assert_eq!((set.set().kinks().len(), set.remarks().len()), (4, 0));
    /// # Ok(()) }
    /// ```
    #[doc(hidden)]
    pub fn of_curves(curves: &[(Curve<'_>, Vec<u32>)], orient: bool) -> Result<Self, Error> {
        let bare: Vec<Curve<'_>> = curves.iter().map(|(curve, _)| curve.clone()).collect();
        let set = if orient { YinSet::oriented(&bare)? } else { YinSet::new(&bare)? };
        let mut knots = Vec::new();
        for (curve, (given, kinks)) in (0..).zip(curves) {
            let count = given.piece_count() as u32;
            if let Some(kink) = kinks.iter().find(|&&kink| kink >= count) {
                return Err(Error::invalid(format!("curve {curve} has no knot {kink}"))
                    .with_cure(format!("give kinks below {count}")));
            }
            // Of one or two pieces both ways have the same numbers.
            let is_turned = set.curve(curve as usize).knot_point(1) != given.knot_point(1);
            let at = |kink: u32| if is_turned { (count - kink) % count } else { kink };
            knots.extend(kinks.iter().map(|&kink| KnotIndex { curve, knot: at(kink) }));
        }
        let (set, count) = with_kinks_at_corners(set.with_declared_kinks(&knots, None, None)?)?;
        let remarks = corners_as_kinks(count, "the curves do not tell them").into_iter().collect();
        Ok(Self { set, names: Vec::new(), remarks })
    }

    /// The number of the curve that has a name, the first of several.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] if there is none.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{PlanarSet, SetRequest};
    /// use coface_io::{Format, ReadOptions, read_boundary};
    /// let text = &br#"{"order":2,"curves":[{"points":[[0,0],[2,0],[2,2]],"name":"rim"}]}"#[..];
    /// let drawing = read_boundary(text, Format::Json, &ReadOptions::default())?;
    /// let set = PlanarSet::of(&drawing, &SetRequest::default())?;
    /// assert_eq!(set.curve_of_name("rim")?, 0);
    /// assert!(set.curve_of_name("hole").is_err());
    /// # Ok(()) }
    /// ```
    pub fn curve_of_name(&self, name: &str) -> Result<u32, Error> {
        let found = self.names.iter().position(|own| own.as_deref() == Some(name));
        found.map(|curve| curve as u32).ok_or_else(|| {
            Error::invalid(format!("no curve is named \"{name}\"")).with_cure("take the number of the curve")
        })
    }

    /// A set without names and remarks.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{PlanarSet, SetRequest};
    /// use coface_io::{Format, ReadOptions, read_boundary};
    /// let text = &b"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"[..];
    /// let drawing = read_boundary(text, Format::Wkt, &ReadOptions::default())?;
    /// let square = PlanarSet::of(&drawing, &SetRequest::default())?;
    /// assert_eq!(PlanarSet::from_set(square.set().clone()).set().area(), Some(4.0));
    /// # Ok(()) }
    /// ```
    pub fn from_set(set: YinSet) -> Self {
        Self { set, names: Vec::new(), remarks: Vec::new() }
    }

    /// A set whose curves are those of this one that are listed, by their numbers, moved: they keep their names.
    ///
    /// # Examples
    /// ```
    /// use coface_io as io;
    /// use coface_io::{Format, ReadOptions};
    /// use coface_answers::{PlanarSet, SetRequest};
    /// use coface_yin::{Flow, TrackingOptions};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = br#"{"curves": [{"name": "drop", "points": [[0, 0], [1, 0], [1, 1], [0, 1]]}]}"#;
    /// let drop = PlanarSet::of(&io::read_boundary(&text[..], Format::Json, &ReadOptions::default())?, &SetRequest::default())?;
    /// let flow = Flow::Translation { velocity: [1.0, 0.0] };
    /// let moved = drop.set().advected(|point, time| flow.velocity(point, time), &TrackingOptions::new(1.0, 0.1, 1.0))?;
    /// let curves = moved.curves().to_vec();
    /// assert_eq!(drop.followed_by(moved.into_set(), &curves).names(), [Some("drop".to_owned())]);
    /// # Ok(()) }
    /// ```
    #[must_use]
    pub fn followed_by(&self, set: YinSet, curves: &[u32]) -> Self {
        let names = curves.iter().map(|&curve| self.name_of(curve)).collect();
        Self { set, names, remarks: Vec::new() }
    }

    /// The set of a combination of sets: a curve that has parts of one curve alone keeps its name.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::boolean::BooleanFormula;
    /// use coface_io as io;
    /// use coface_io::{Format, ReadOptions};
    /// use coface_answers::{PlanarSet, SetRequest};
    /// use coface_yin::YinSet;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = br#"{"curves": [{"name": "lake", "points": [[0, 0], [1, 0], [1, 1], [0, 1]]}]}"#;
    /// let lake = PlanarSet::of(&io::read_boundary(&text[..], Format::Json, &ReadOptions::default())?, &SetRequest::default())?;
    /// let land = YinSet::combine(&[lake.set()], &BooleanFormula::parse("!a", &[])?)?;
    /// assert_eq!(PlanarSet::of_combination(land, &[lake]).names(), [Some("lake".to_owned())]);
    /// # Ok(()) }
    /// ```
    pub fn of_combination(combination: Combination, operands: &[Self]) -> Self {
        let set = combination.set();
        let mut sources = combination.sources();
        let mut names = Vec::with_capacity(set.curve_count());
        for curve in 0..set.curve_count() {
            let (own, rest) = sources.split_at(set.curve(curve).piece_count());
            sources = rest;
            let first = [own[0].operand, own[0].curve];
            let is_one = own.iter().all(|source| [source.operand, source.curve] == first);
            let operand = operands.get(first[0] as usize).filter(|_| is_one);
            names.push(operand.and_then(|operand| operand.name_of(first[1])));
        }
        Self { set: combination.into_set(), names, remarks: Vec::new() }
    }

    fn name_of(&self, curve: u32) -> Option<String> {
        self.names.get(curve as usize).cloned().flatten()
    }

    /// The same with the curves in canonical order; names go.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{PlanarSet, SetRequest};
    /// use coface_io::{Format, ReadOptions, read_boundary};
    /// let text = &b"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"[..];
    /// let drawing = read_boundary(text, Format::Wkt, &ReadOptions::default())?;
    /// let square = PlanarSet::of(&drawing, &SetRequest::default())?;
    /// assert_eq!(square.canonical().set().area(), Some(4.0));
    /// # Ok(()) }
    /// ```
    #[must_use]
    pub fn canonical(self) -> Self {
        Self { set: self.set.canonical(), names: Vec::new(), remarks: self.remarks }
    }

    /// The set.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{PlanarSet, SetRequest};
    /// use coface_io::{Format, ReadOptions, read_boundary};
    /// let text = &b"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"[..];
    /// let drawing = read_boundary(text, Format::Wkt, &ReadOptions::default())?;
    /// let square = PlanarSet::of(&drawing, &SetRequest::default())?;
    /// assert_eq!(square.set().area(), Some(4.0));
    /// # Ok(()) }
    /// ```
    pub fn set(&self) -> &YinSet {
        &self.set
    }

    /// The set, to change its kinks: curves stay where they are, and keep their names.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{PlanarSet, SetRequest};
    /// use coface_io::{Format, ReadOptions, read_boundary};
    /// let text = &b"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"[..];
    /// let drawing = read_boundary(text, Format::Wkt, &ReadOptions::default())?;
    /// let mut square = PlanarSet::of(&drawing, &SetRequest::default())?;
    /// assert_eq!(square.set_mut().area(), Some(4.0));
    /// # Ok(()) }
    /// ```
    pub fn set_mut(&mut self) -> &mut YinSet {
        &mut self.set
    }

    /// The name of each curve; none at the end of the list are left out.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{PlanarSet, SetRequest};
    /// use coface_io::{Format, ReadOptions, read_boundary};
    /// let text = &b"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"[..];
    /// let drawing = read_boundary(text, Format::Wkt, &ReadOptions::default())?;
    /// let square = PlanarSet::of(&drawing, &SetRequest::default())?;
    /// assert!(square.names().iter().all(Option::is_none));
    /// # Ok(()) }
    /// ```
    pub fn names(&self) -> &[Option<String>] {
        &self.names
    }

    /// Replaces all kinks, and fits everything between them again.
    ///
    /// # Errors
    /// Those of [`YinSet::reset_all_kinks`]; the set stays as it was then.
    pub fn reset_kinks(&mut self, request: &KinkRequest) -> Result<(), Error> {
        let knots = knots_of(&self.set, request)?;
        self.set.reset_all_kinks(&knots).map(drop)
    }

    /// What was changed or passed over.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{PlanarSet, SetRequest};
    /// use coface_io::{Format, ReadOptions, read_boundary};
    /// let text = &b"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"[..];
    /// let drawing = read_boundary(text, Format::Wkt, &ReadOptions::default())?;
    /// let square = PlanarSet::of(&drawing, &SetRequest::default())?;
    /// assert!(square.remarks().is_empty());
    /// # Ok(()) }
    /// ```
    pub fn remarks(&self) -> &[Remark] {
        &self.remarks
    }
}

/// How far chords may be from the curves of a drawing where nothing is said, a thousandth of the diagonal of the box around them, and the remark on it.
fn assumed_flattening(drawing: &BoundaryDrawing, ends: &EndCondition) -> Result<(f64, Remark), Error> {
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for (number, curve) in drawing.curves().iter().enumerate() {
        let curve = curve.curve(drawing.order(), ends).map_err(|error| named(number, &error))?;
        let [least, most] = curve.bounding_box();
        for axis in 0..2 {
            (low[axis], high[axis]) = (low[axis].min(least[axis]), high[axis].max(most[axis]));
        }
    }
    let tolerance = (1e-3 * (high[0] - low[0]).hypot(high[1] - low[1])).max(f64::MIN_POSITIVE);
    let count = drawing.curves().len();
    let message = format!(
        "{} became chords that are within {tolerance:.3e} of {}, a thousandth of the size of the set; --flatten LENGTH says another length",
        text::count(count, "curve"),
        if count == 1 { "it" } else { "them" }
    );
    Ok((tolerance, Remark::new(RemarkCode::CurvesFlattened, message).at(count, [])))
}

/// An error of one curve.
pub(super) fn named(number: usize, error: &Error) -> Error {
    let message = error.message();
    if message.contains(&format!("curve {number}")) {
        return error.clone();
    }
    let renamed = Error::new(error.kind(), format!("curve {number}: {message}"));
    match error.cure() {
        Some(cure) => renamed.with_cure(cure),
        None => renamed,
    }
}

/// Refuses kinks of splines that are to be fitted on curves that the file does not have.
fn check_curves_of_kinks(count: usize, request: &SetRequest) -> Result<(), Error> {
    let Some(KinkRequest::Listed(knots)) = request.kinks.as_ref().filter(|_| request.fit) else {
        return Ok(());
    };
    match knots.iter().find(|at| at.curve as usize >= count) {
        None => Ok(()),
        Some(at) => Err(Error::invalid(format!("there is no curve {}", at.curve))
            .with_cure(format!("the curves are 0 to {}", count.saturating_sub(1)))),
    }
}

/// Where the boundary turns by more than this angle, in radians, it is meant to have a corner.
const CORNER: f64 = 0.1;

/// The set with the corners of its splines as kinks, which nobody told, and how many these are: what moves or changes it keeps them then.
fn with_kinks_at_corners(set: YinSet) -> Result<(YinSet, usize), Error> {
    if set.order() == Order::LINEAR {
        return Ok((set, 0));
    }
    let (mut knots, mut names): (Vec<KnotIndex>, Vec<u32>) =
        set.kinks().iter().map(|(at, vertex)| (at, vertex.to_u32())).unzip();
    let mut corners = set.corners(CORNER)?;
    corners.retain(|at| knots.binary_search(at).is_err());
    let count = corners.len();
    if count == 0 {
        return Ok((set, 0));
    }
    let next = set.kinks().next_name();
    names.extend((next..).take(count));
    knots.extend(corners);
    let next = next + count as u32;
    Ok((set.with_declared_kinks(&knots, Some(&names), Some(next))?, count))
}

fn corners_as_kinks(count: usize, why: &str) -> Option<Remark> {
    let knots = match count {
        0 => return None,
        1 => "1 knot where the boundary has a corner is taken as a kink".to_owned(),
        count => format!("{count} knots where the boundary has a corner are taken as kinks"),
    };
    let message = format!("{knots}; {why}");
    Some(Remark::new(RemarkCode::InputReading, message).at(count, []))
}

fn check_listed(set: &YinSet, kinks: Option<&KinkRequest>) -> Result<(), Error> {
    match kinks {
        Some(KinkRequest::Listed(knots)) if !knots.is_empty() => {
            set.clone().with_declared_kinks(knots, None, None).map(drop)
        }
        _ => Ok(()),
    }
}

/// The knots of a set that are asked for.
fn knots_of(set: &YinSet, request: &KinkRequest) -> Result<Vec<KnotIndex>, Error> {
    Ok(match request {
        KinkRequest::None => Vec::new(),
        KinkRequest::All => (0..set.curve_count() as u32)
            .flat_map(|curve| {
                let count = set.curve(curve as usize).piece_count() as u32;
                (0..count).map(move |knot| KnotIndex { curve, knot })
            })
            .collect(),
        KinkRequest::Detected(angle) => set.detect_kinks(*angle)?,
        KinkRequest::Listed(knots) => knots.clone(),
    })
}

/// A curve of the order that is wanted.
fn make(
    number: usize,
    curve: &BoundaryCurve,
    from: Order,
    order: Order,
    request: &SetRequest,
) -> Result<Made, Error> {
    let mut kinks = curve.kinks().to_vec();
    let mut kink_names = curve.kink_names().map(<[u32]>::to_vec);
    let mut made = if request.fit {
        if let Some(asked) = &request.kinks {
            kink_names = None;
            kinks = match asked {
                KinkRequest::None => Vec::new(),
                KinkRequest::All => (0..curve.points().len() as u32).collect(),
                KinkRequest::Detected(angle) => turning_kinks(curve.points(), *angle)?,
                KinkRequest::Listed(knots) => {
                    knots.iter().filter(|at| at.curve as usize == number).map(|at| at.knot).collect()
                }
            };
        }
        let mut bare = BoundaryCurve::new(curve.points().to_vec());
        bare.set_kinks(kinks.clone());
        bare.curve(order, &request.ends)?
    } else if from > order {
        let Some(tolerance) = request.flatten else {
            return Err(Error::invalid(format!("curve {number} is of order {from}, not {order}"))
                .with_cure("say how far chords may be from it: --flatten LENGTH"));
        };
        (kinks, kink_names) = (Vec::new(), None);
        let mut corners = flattened(&curve.curve(from, &request.ends)?, tolerance)?;
        corners.push(corners[0]);
        Curve::polyline(&corners)?
    } else {
        curve.curve(from, &request.ends)?
    };
    if made.order() < order {
        // Lines stay lines: they bend at every knot.
        if from == Order::LINEAR {
            (kinks, kink_names) = ((0..made.piece_count() as u32).collect(), None);
        }
        made = made.raised(order)?;
    }
    Ok(Made { curve: made, kinks, kink_names, name: curve.name().map(str::to_owned) })
}

/// The set of all groups, and the names of its curves.
fn combined(
    drawing: &BoundaryDrawing,
    made: &[Made],
    request: &SetRequest,
) -> Result<(YinSet, Vec<Option<String>>), Error> {
    let turned: Vec<Vec<Made>> = drawing
        .groups()
        .iter()
        .map(|(filling, curves)| turn(*filling, &made[curves.clone()], request.rule))
        .collect();
    let mut sets = Vec::with_capacity(turned.len());
    // Whether no curve was changed so far.
    let mut are_whole = true;
    for (number, ((filling, curves), group)) in drawing.groups().iter().zip(&turned).enumerate() {
        let whole = set_of(group);
        let is_bounded = whole.as_ref().is_ok_and(YinSet::is_bounded);
        let set = match (whole, rule_of(*filling, request.rule)) {
            // What bounds a bounded set on its left is inside by every rule; on the left alone also the unbounded.
            (Ok(set), None) => Ok(set),
            (Ok(set), Some(_)) if is_bounded || *filling == Filling::Left => Ok(set),
            (Err(fault), None) => Err(with_rule_as_cure(&fault)),
            (_, Some(rule)) => {
                are_whole = false;
                let curves: Vec<(Curve<'_>, Vec<u32>)> =
                    group.iter().map(|made| (made.curve.clone(), made.kinks.clone())).collect();
                YinSet::combine_kinked_curves(&curves, 0, rule).map(Combination::into_set)
            }
        };
        sets.push(set.map_err(|fault| {
            let error = if turned.len() > 1 { in_polygon(number, &fault) } else { fault };
            match drawing.curves()[curves.start].line() {
                Some(line) => error.at_line(line),
                None => error,
            }
        })?);
    }
    let names = |turned: Vec<Vec<Made>>| turned.into_iter().flatten().map(|made| made.name).collect();
    if sets.len() == 1 {
        let set = sets.pop().expect("there is one");
        return Ok((set, if are_whole { names(turned) } else { Vec::new() }));
    }
    // Sets whose curves bound one together are apart: no knot is lost, and no name.
    if are_whole {
        let all: Vec<Made> = turned.iter().flatten().cloned().collect();
        if let Ok(set) = set_of(&all) {
            return Ok((set, names(turned)));
        }
    }
    // Winding numbers of sets add up: their union is where they do not cancel. What lies in many of them costs no more than what is in one.
    let around = sets.iter().filter(|set| !set.is_bounded()).count() as i32;
    let curves: Vec<(Curve<'_>, Vec<u32>)> = sets
        .iter()
        .flat_map(|set| {
            (0..set.curve_count())
                .map(|curve| (set.curve(curve), set.kinks().on_curve(curve as u32).collect()))
        })
        .collect();
    let set = YinSet::combine_kinked_curves(&curves, around, InsideRule::Positive)?.into_set();
    Ok((set, Vec::new()))
}

fn in_polygon(number: usize, fault: &Error) -> Error {
    let error = Error::new(fault.kind(), format!("polygon {number}: {}", fault.message()));
    match fault.cure() {
        Some(cure) => error.with_cure(cure),
        None => error,
    }
}

fn with_rule_as_cure(fault: &Error) -> Error {
    let error = Error::new(fault.kind(), fault.message());
    let cure = "repair the curves with a fill rule: --rule nonzero, evenodd or positive";
    match (fault.kind(), fault.cure()) {
        (ErrorKind::InvalidInput, Some(own)) => {
            // What the fault itself says of fill rules is said once, with their names.
            let own = own.strip_suffix("repair the curves with a fill rule").unwrap_or(own);
            let own = own.trim_end_matches(", or ");
            error.with_cure(if own.is_empty() { cure.to_owned() } else { format!("{own}; or {cure}") })
        }
        (ErrorKind::InvalidInput, None) => error.with_cure(cure),
        (_, Some(own)) => error.with_cure(own),
        _ => error,
    }
}

/// The rule of a group, if it has one.
fn rule_of(filling: Filling, asked: Option<InsideRule>) -> Option<InsideRule> {
    match (filling, asked) {
        (_, Some(rule)) => Some(rule),
        (Filling::Stated(rule), None) => Some(rule),
        _ => None,
    }
}

/// The curves of a group turned so that they bound the set on their left, if that is in question.
fn turn(filling: Filling, curves: &[Made], asked: Option<InsideRule>) -> Vec<Made> {
    match filling {
        Filling::Left => curves.to_vec(),
        Filling::OuterWithoutHoles => curves
            .iter()
            .enumerate()
            .map(|(ring, made)| {
                let is_positive = made.curve.signed_area() > 0.0;
                if is_positive == (ring == 0) { made.clone() } else { made.reversed() }
            })
            .collect(),
        Filling::Stated(rule) => {
            let area: f64 = curves.iter().map(|made| made.curve.signed_area()).sum();
            // Other rules than the positive one do not ask for directions.
            if area < 0.0 && asked.unwrap_or(rule) != InsideRule::Positive {
                curves.iter().map(Made::reversed).collect()
            } else {
                curves.to_vec()
            }
        }
    }
}

/// The set on the left of curves, with their kinks.
fn set_of(curves: &[Made]) -> Result<YinSet, Error> {
    let bare: Vec<Curve<'_>> = curves.iter().map(|made| made.curve.clone()).collect();
    let set = YinSet::new(&bare)?;
    let mut kinks: Vec<(KnotIndex, Option<u32>)> = Vec::new();
    for (curve, made) in (0..).zip(curves) {
        let from = kinks.len();
        let name = |i: usize| made.kink_names.as_ref().map(|names| names[i]);
        kinks.extend(made.kinks.iter().enumerate().map(|(i, &knot)| (KnotIndex { curve, knot }, name(i))));
        kinks[from..].sort_unstable_by_key(|&(at, _)| at);
    }
    let knots: Vec<KnotIndex> = kinks.iter().map(|&(at, _)| at).collect();
    let names: Option<Vec<u32>> = kinks.iter().map(|&(_, name)| name).collect();
    set.with_declared_kinks(&knots, names.as_deref(), None)
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_io::yin::read_factories;
    use std::f64::consts::PI;

    fn set(text: &str) -> Result<PlanarSet, Error> {
        PlanarSet::of(&read_factories(text.as_bytes())?, &SetRequest::default())
    }

    #[test]
    fn circles_rectangles_and_lists_of_points_are_read() -> Result<(), Error> {
        let text =
            "1e-10\n# a frame with a disk in it\nRectangle -2 -1 2 1 0 1 0.3\nCircle 0.5 0 0.5 0 0.01\n";
        let read = set(text)?;
        assert_eq!((read.set().kinks().len(), read.set().curve_counts()), (4, [1, 1]));
        assert!((read.set().area().expect("bounded") - (8.0 - 0.25 * PI)).abs() < 1e-8);
        assert_eq!(read.set().curve(0).piece_count(), 2 * (14 + 7));
        assert_eq!(read.set().curve(1).piece_count(), 315);
        // Clockwise, all of the plane but a turned square.
        let hole = set("Rectangle 0 0 1 1 0.7 0 0.6")?;
        assert!(!hole.set().is_bounded() && hole.set().kinks().len() == 4);
        let triangle = set("OrientedJordanCurve 3 0 0 4 0 0 4 0 0 0 1 2")?;
        assert_eq!((triangle.set().area(), triangle.set().kinks().len()), (Some(8.0), 3));
        Ok(())
    }

    #[test]
    fn faults_have_line_and_column() {
        for (text, line, said) in [
            ("Circle 0 0 1 1 0.1\nOval 1 2", 2, "column 1: \"Oval\" is no curve"),
            ("Circle 0 zero 1 1 0.1", 1, "column 10: \"zero\" is not a number"),
            ("Circle 0 0 -1 1 0.1", 1, "column 12: the radius is -1"),
            ("Circle 0 0 1 2 0.1", 1, "column 14: the orientation is 2"),
            ("Circle 0 0 1 1", 1, "column 15: the line ends"),
            ("Circle 0 0 1 1 0.1 9", 1, "column 20: \"9\" comes behind"),
            ("Circle 0 0 1 1 9", 1, "has no area"),
            ("Circle 0 0 1 1 1e-300", 1, "more than 2^24"),
            ("Rectangle 0 0 0 1 0 1 0.1", 1, "has no area"),
            ("OrientedJordanCurve 3 0 0 1 0 0 1 0 1", 1, "column 35: the last point (0, 1) is not the first"),
            ("OrientedJordanCurve 4000000000 0 0", 1, "the line ends"),
            ("OrientedJordanCurve 3 0 0 1 0 0 1 0 0 4", 1, "column 39: there is no point 4"),
            ("OrientedJordanCurve 3 0 0 1 0 0 1 0 nan", 1, "column 37"),
            ("OrientedJordanCurve 3 0 0 1 0 0 1 0 0 0 3", 1, "a kink twice"),
            ("1\n2\nCircle 0 0 1 1 0.1", 2, "without a name"),
        ] {
            let error = set(text).err().unwrap_or_else(|| panic!("{text} is read"));
            assert_eq!(error.line(), Some(line), "{text}: {error}");
            assert!(error.to_string().contains(said), "{text}: {error}");
        }
    }
}
