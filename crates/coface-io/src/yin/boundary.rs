//! What a file says about the boundary of a set.

use super::flattening::{NO_BOUNDS, default_tolerance, flattened, flattening_remark};
use crate::Remark;
use crate::{CellData, Format, Group, GroupKind, Model};
use coface_algebra::RaggedArray;
use coface_algebra::{Error, ErrorKind};
use coface_arrange::boolean::InsideRule;
use coface_geometry::Positions;
use coface_yin::{Carrier, Curve, EndCondition, Order};
use std::ops::Range;

/// The highest name that a kink may have: as many are left for those to come.
const HIGHEST_NAME: u32 = 1 << 31;

/// What is inside of some closed curves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Filling {
    /// What is on their left: they are the boundary of a set, which may be unbounded.
    Left,
    /// What is inside of the first and of no other, whatever their directions are: a polygon with holes.
    OuterWithoutHoles,
    /// What they wind around as a rule says.
    Stated(InsideRule),
}

/// A closed curve as a file has it.
#[derive(Clone, Debug, PartialEq)]
pub struct BoundaryCurve {
    points: Vec<[f64; 2]>,
    kinks: Vec<u32>,
    kink_names: Option<Vec<u32>>,
    name: Option<String>,
    knots: Option<Vec<f64>>,
    /// The curve, where the file has more than points.
    curve: Option<Curve<'static>>,
    /// What its pieces are parts of.
    carriers: Vec<Carrier>,
    line: Option<u64>,
}

impl BoundaryCurve {
    /// The curve to be fitted to these points; the first is not repeated.
    ///
    /// # Examples
    /// ```
    /// use coface_io::yin::BoundaryCurve;
    /// let curve = BoundaryCurve::new(vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]);
    /// assert_eq!(curve.points().len(), 3);
    /// ```
    pub fn new(points: Vec<[f64; 2]>) -> Self {
        Self {
            points,
            kinks: Vec::new(),
            kink_names: None,
            name: None,
            knots: None,
            curve: None,
            carriers: Vec::new(),
            line: None,
        }
    }

    pub(crate) fn set_name(&mut self, name: Option<String>) {
        self.name = name;
    }

    pub(crate) fn set_line(&mut self, line: u64) {
        self.line = Some(line);
    }

    #[doc(hidden)]
    pub fn set_kinks(&mut self, kinks: Vec<u32>) {
        self.kinks = kinks;
    }

    pub(crate) fn set_kink_names(&mut self, names: Vec<u32>) {
        self.kink_names = Some(names);
    }

    pub(crate) fn set_knots(&mut self, knots: Vec<f64>) {
        self.knots = Some(knots);
    }

    pub(crate) fn set_curve(&mut self, curve: Curve<'static>) {
        self.curve = Some(curve);
    }

    /// Takes what pieces are parts of, if that fits the curve that the file has or that is fitted to its points.
    pub(crate) fn set_carriers(&mut self, carriers: Vec<Carrier>, order: Order) -> Result<(), Error> {
        let curve = self.curve(order, &EndCondition::NotAKnot)?.with_carriers(carriers)?;
        self.carriers = curve.carriers().to_vec();
        Ok(())
    }

    /// The points at the knots, the first not repeated.
    ///
    /// # Examples
    /// ```
    /// use coface_io::yin::BoundaryCurve;
    /// let curve = BoundaryCurve::new(vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]);
    /// assert_eq!(curve.points()[1], [1.0, 0.0]);
    /// ```
    pub fn points(&self) -> &[[f64; 2]] {
        &self.points
    }

    /// The numbers of the points that are kinks, as the file has them.
    ///
    /// # Examples
    /// ```
    /// use coface_io::yin::BoundaryCurve;
    /// let curve = BoundaryCurve::new(vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]);
    /// assert!(curve.kinks().is_empty());
    /// ```
    pub fn kinks(&self) -> &[u32] {
        &self.kinks
    }

    /// The names of the kinks, if the file has any.
    ///
    /// # Examples
    /// ```
    /// use coface_io::yin::BoundaryCurve;
    /// let curve = BoundaryCurve::new(vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]);
    /// assert_eq!(curve.kink_names(), None);
    /// ```
    pub fn kink_names(&self) -> Option<&[u32]> {
        self.kink_names.as_deref()
    }

    /// The name.
    ///
    /// # Examples
    /// ```
    /// use coface_io::yin::BoundaryCurve;
    /// let curve = BoundaryCurve::new(vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]);
    /// assert_eq!(curve.name(), None);
    /// ```
    pub fn name(&self) -> Option<&str> {
        self.name.as_deref()
    }

    /// The line of the file that it begins at, if that is known.
    ///
    /// # Examples
    /// ```
    /// use coface_io::yin::BoundaryCurve;
    /// let curve = BoundaryCurve::new(vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]);
    /// assert_eq!(curve.line(), None);
    /// ```
    pub fn line(&self) -> Option<u64> {
        self.line
    }

    /// Whether the file has more of the curve than its points: pieces that nothing is fitted to.
    ///
    /// # Examples
    /// ```
    /// use coface_io::yin::BoundaryCurve;
    /// let curve = BoundaryCurve::new(vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]);
    /// assert!(!curve.has_pieces());
    /// ```
    pub fn has_pieces(&self) -> bool {
        self.curve.is_some()
    }

    /// The curve: as the file has it, or fitted to its points with this order, these kinks and these ends.
    ///
    /// # Errors
    /// Those of [`Curve::fit_closed`].
    ///
    /// # Examples
    /// ```
    /// use coface_io::yin::BoundaryCurve;
    /// use coface_yin::{EndCondition, Order};
    /// let curve = BoundaryCurve::new(vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]);
    /// assert_eq!(curve.curve(Order::LINEAR, &EndCondition::NotAKnot)?.signed_area(), 0.5);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn curve(&self, order: Order, ends: &EndCondition) -> Result<Curve<'static>, Error> {
        if let Some(curve) = &self.curve {
            let curve = self.carried(curve.clone());
            return match curve.order() < order {
                true => curve.raised(order),
                false => Ok(curve),
            };
        }
        let curve = Curve::fit_closed(&self.points, &self.kinks, order, ends)?;
        let curve = match &self.knots {
            Some(knots) => Curve::from_controls(order, curve.controls().to_vec(), knots.clone())?,
            None => curve,
        };
        Ok(self.carried(curve))
    }

    /// A curve of these points with what its pieces are parts of; where it is fitted otherwise than the file was, they are parts of
    /// nothing.
    fn carried(&self, curve: Curve<'static>) -> Curve<'static> {
        if self.carriers.is_empty() {
            return curve;
        }
        curve.clone().with_carriers(self.carriers.clone()).unwrap_or(curve)
    }

    /// Verifies that kinks are points, none twice, that they have as many names as they are, and there are as many parameters as
    /// points, and one more.
    fn check(&self, number: usize) -> Result<(), Error> {
        let count = self.points.len();
        let fail = |message: String, cure: &str| Err(Error::invalid(message).with_cure(cure));
        let mut is_kink = vec![false; count];
        for &kink in &self.kinks {
            match is_kink.get_mut(kink as usize) {
                None => {
                    return fail(
                        format!(
                            "kink {kink} of curve {number} is none of its {count} points, numbered from 0"
                        ),
                        "name points that are there",
                    );
                }
                Some(true) => {
                    return fail(
                        format!("point {kink} of curve {number} is a kink twice"),
                        "give each kink once",
                    );
                }
                Some(is_kink) => *is_kink = true,
            }
        }
        let (kinks, names) = (self.kinks.len(), self.kink_names.as_ref().map(Vec::len));
        if names.is_some_and(|names| names != kinks) {
            let message = format!("curve {number} has {} names for {kinks} kinks", names.unwrap_or_default());
            return fail(message, "give each kink one name");
        }
        if self.knots.as_ref().is_some_and(|knots| knots.len() != count + 1) {
            let knots = self.knots.as_ref().map_or(0, Vec::len);
            return fail(
                format!("curve {number} has {knots} knots for {count} points"),
                "give one knot for each point, and one for the first again",
            );
        }
        Ok(())
    }
}

/// Closed curves of one order in groups, each with what is inside.
///
/// # Examples
/// ```
/// use coface_io as io;
/// use coface_io::Format;
/// use coface_yin::Order;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let text = br#"{"order": 2, "curves": [{"points": [[0, 0], [1, 0], [0, 1]], "kinks": [1]}]}"#;
/// let drawing = io::read_boundary(&text[..], Format::Json, &io::ReadOptions::default())?;
/// assert_eq!((drawing.order(), drawing.curves().len()), (Order::LINEAR, 1));
/// assert_eq!(drawing.curves()[0].kinks(), [1]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct BoundaryDrawing {
    order: Order,
    is_plane: bool,
    curves: Vec<BoundaryCurve>,
    groups: Vec<(Filling, Range<usize>)>,
    next_kink_name: Option<u32>,
    remarks: Vec<Remark>,
    format: Option<Format>,
}

impl BoundaryDrawing {
    /// A drawing without curves.
    ///
    /// # Examples
    /// ```
    /// use coface_io::yin::BoundaryDrawing;
    /// use coface_yin::Order;
    /// assert!(BoundaryDrawing::new(Order::LINEAR).curves().is_empty());
    /// ```
    pub fn new(order: Order) -> Self {
        Self {
            order,
            is_plane: false,
            curves: Vec::new(),
            groups: Vec::new(),
            next_kink_name: None,
            remarks: Vec::new(),
            format: None,
        }
    }

    /// The whole plane.
    ///
    /// # Examples
    /// ```
    /// use coface_io::yin::BoundaryDrawing;
    /// use coface_yin::Order;
    /// assert!(BoundaryDrawing::plane(Order::LINEAR).is_plane());
    /// ```
    pub fn plane(order: Order) -> Self {
        Self { is_plane: true, ..Self::new(order) }
    }

    /// Adds curves of a group.
    ///
    /// # Examples
    /// ```
    /// use coface_io::yin::{BoundaryCurve, BoundaryDrawing, Filling};
    /// use coface_yin::Order;
    /// let mut drawing = BoundaryDrawing::new(Order::LINEAR);
    /// drawing.push(Filling::Left, vec![BoundaryCurve::new(vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])]);
    /// assert_eq!(drawing.groups(), [(Filling::Left, 0..1)]);
    /// ```
    pub fn push(&mut self, filling: Filling, curves: Vec<BoundaryCurve>) {
        let start = self.curves.len();
        self.curves.extend(curves);
        self.groups.push((filling, start..self.curves.len()));
    }

    pub(crate) fn remark(&mut self, remark: Remark) {
        self.remarks.push(remark);
    }

    pub(crate) fn set_next_kink_name(&mut self, name: Option<u32>) {
        self.next_kink_name = name;
    }

    pub(crate) fn with_format(self, format: Format) -> Self {
        Self { format: Some(format), ..self }
    }

    /// Verifies kinks, names and counts of all curves.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] naming the curve and the fault.
    ///
    /// # Examples
    /// ```
    /// use coface_io::yin::{BoundaryCurve, BoundaryDrawing, Filling};
    /// use coface_yin::Order;
    /// let mut drawing = BoundaryDrawing::new(Order::LINEAR);
    /// drawing.push(Filling::Left, vec![BoundaryCurve::new(vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])]);
    /// assert!(drawing.check().is_ok());
    /// ```
    pub fn check(&self) -> Result<(), Error> {
        for (number, curve) in self.curves.iter().enumerate() {
            let check = curve.check(number);
            check.map_err(|error| curve.line.map_or(error.clone(), |line| error.at_line(line)))?;
        }
        let mut names: Vec<u32> =
            self.curves.iter().filter_map(|curve| curve.kink_names.as_deref()).flatten().copied().collect();
        names.sort_unstable();
        if let Some(pair) = names.windows(2).find(|pair| pair[0] == pair[1]) {
            return Err(Error::invalid(format!("two kinks have the name {}", pair[0]))
                .with_cure("give each kink a name of its own"));
        }
        let highest = names.last().copied().max(self.next_kink_name);
        if let Some(highest) = highest.filter(|&highest| highest > HIGHEST_NAME) {
            return Err(Error::new(
                ErrorKind::TooLarge,
                format!("the name {highest} of a kink is above 2^31"),
            )
            .with_cure("number kinks from 0"));
        }
        if let (Some(next), Some(&largest)) = (self.next_kink_name, names.last())
            && next <= largest
        {
            return Err(Error::invalid(format!(
                "\"next_vertex\" is {next}, but a kink has the name {largest}"
            ))
            .with_cure("make it larger than all names"));
        }
        Ok(())
    }

    /// The order of the curves.
    ///
    /// # Examples
    /// ```
    /// use coface_io::yin::{BoundaryCurve, BoundaryDrawing, Filling};
    /// use coface_yin::Order;
    /// let mut drawing = BoundaryDrawing::new(Order::LINEAR);
    /// drawing.push(Filling::Left, vec![BoundaryCurve::new(vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])]);
    /// assert_eq!(drawing.order(), Order::LINEAR);
    /// ```
    pub fn order(&self) -> Order {
        self.order
    }

    /// Whether the set is the whole plane.
    ///
    /// # Examples
    /// ```
    /// use coface_io::yin::{BoundaryCurve, BoundaryDrawing, Filling};
    /// use coface_yin::Order;
    /// let mut drawing = BoundaryDrawing::new(Order::LINEAR);
    /// drawing.push(Filling::Left, vec![BoundaryCurve::new(vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])]);
    /// assert!(!drawing.is_plane());
    /// ```
    pub fn is_plane(&self) -> bool {
        self.is_plane
    }

    /// All curves.
    ///
    /// # Examples
    /// ```
    /// use coface_io::yin::{BoundaryCurve, BoundaryDrawing, Filling};
    /// use coface_yin::Order;
    /// let mut drawing = BoundaryDrawing::new(Order::LINEAR);
    /// drawing.push(Filling::Left, vec![BoundaryCurve::new(vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])]);
    /// assert_eq!(drawing.curves().len(), 1);
    /// ```
    pub fn curves(&self) -> &[BoundaryCurve] {
        &self.curves
    }

    /// The groups: what is inside, and the range of their curves.
    ///
    /// # Examples
    /// ```
    /// use coface_io::yin::{BoundaryCurve, BoundaryDrawing, Filling};
    /// use coface_yin::Order;
    /// let mut drawing = BoundaryDrawing::new(Order::LINEAR);
    /// drawing.push(Filling::Left, vec![BoundaryCurve::new(vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])]);
    /// assert_eq!(drawing.groups(), [(Filling::Left, 0..1)]);
    /// ```
    pub fn groups(&self) -> &[(Filling, Range<usize>)] {
        &self.groups
    }

    /// The first name that no kink ever had, if the file says it.
    ///
    /// # Examples
    /// ```
    /// use coface_io::yin::{BoundaryCurve, BoundaryDrawing, Filling};
    /// use coface_yin::Order;
    /// let mut drawing = BoundaryDrawing::new(Order::LINEAR);
    /// drawing.push(Filling::Left, vec![BoundaryCurve::new(vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])]);
    /// assert_eq!(drawing.next_kink_name(), None);
    /// ```
    pub fn next_kink_name(&self) -> Option<u32> {
        self.next_kink_name
    }

    /// What is odd, or was changed: one sentence each.
    ///
    /// # Examples
    /// ```
    /// use coface_io::yin::{BoundaryCurve, BoundaryDrawing, Filling};
    /// use coface_yin::Order;
    /// let mut drawing = BoundaryDrawing::new(Order::LINEAR);
    /// drawing.push(Filling::Left, vec![BoundaryCurve::new(vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])]);
    /// assert!(drawing.remarks().is_empty());
    /// ```
    pub fn remarks(&self) -> &[Remark] {
        &self.remarks
    }

    /// The format of the file.
    ///
    /// # Examples
    /// ```
    /// use coface_io::yin::{BoundaryCurve, BoundaryDrawing, Filling};
    /// use coface_yin::Order;
    /// let mut drawing = BoundaryDrawing::new(Order::LINEAR);
    /// drawing.push(Filling::Left, vec![BoundaryCurve::new(vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])]);
    /// assert_eq!(drawing.format(), None);
    /// ```
    pub fn format(&self) -> Option<Format> {
        self.format
    }
}

/// The box around the curves of a drawing, nearly: curves are seen as chords within a thousandth of the box of their controls.
fn bounds_of(drawing: &BoundaryDrawing) -> Result<[[f64; 2]; 2], Error> {
    let mut bounds = NO_BOUNDS;
    let extend = |bounds: &mut [[f64; 2]; 2], points: &[[f64; 2]]| {
        for (point, axis) in points.iter().flat_map(|point| [(point, 0), (point, 1)]) {
            bounds[0][axis] = bounds[0][axis].min(point[axis]);
            bounds[1][axis] = bounds[1][axis].max(point[axis]);
        }
    };
    if drawing.order != Order::LINEAR {
        for curve in &drawing.curves {
            let curve = curve.curve(drawing.order, &EndCondition::NotAKnot)?;
            let mut hull = NO_BOUNDS;
            (0..curve.piece_count()).for_each(|piece| extend(&mut hull, curve.piece(piece)));
            extend(&mut bounds, &flattened(&curve, default_tolerance(hull))?);
        }
    }
    Ok(bounds)
}

/// The curves of a drawing as closed lines, for all that asks about lines and polygons. Curves become chords within a tolerance, a thousandth of the
/// size of the drawing with a remark if none is stated.
///
/// # Errors
/// [`ErrorKind::UnsupportedFormat`] for the whole plane and for unbounded sets, which no model holds; those of the fit.
pub(crate) fn model_of_drawing(drawing: &BoundaryDrawing, stated: Option<f64>) -> Result<Model, Error> {
    let refuse = |what: &str| {
        Err(Error::new(ErrorKind::UnsupportedFormat, format!("this is {what}, which no model holds"))
            .with_cure("ask coface yin, which knows unbounded sets"))
    };
    if drawing.is_plane {
        return refuse("the whole plane");
    }
    let tolerance = match stated {
        Some(tolerance) => tolerance,
        None => default_tolerance(bounds_of(drawing)?),
    };
    let mut flat: Vec<f64> = Vec::new();
    let (mut lines, mut rings) = (RaggedArray::new(), Vec::new());
    let mut names: Vec<(String, Vec<u32>)> = Vec::new();
    let mut polygons = Vec::new();
    let mut doubled_areas = vec![0.0; drawing.groups.len()];
    for (group, number) in (0..)
        .zip(&drawing.groups)
        .flat_map(|(group, (_, curves))| curves.clone().map(move |number| (group, number)))
    {
        let curve = &drawing.curves[number];
        let points = if drawing.order == Order::LINEAR {
            Curve::polyline(&curve.points)?;
            curve.points.clone()
        } else {
            flattened(&curve.curve(drawing.order, &EndCondition::NotAKnot)?, tolerance)?
        };
        doubled_areas[group] += (0..points.len())
            .map(|i| [points[i], points[(i + 1) % points.len()]])
            .map(|[a, b]| {
                (a[0] - points[0][0]) * (b[1] - points[0][1]) - (b[0] - points[0][0]) * (a[1] - points[0][1])
            })
            .sum::<f64>();
        let start = (flat.len() / 2) as u32;
        flat.extend(points.as_flattened());
        let line: Vec<u32> = (start..start + points.len() as u32).chain([start]).collect();
        if let Some(name) = &curve.name {
            match names.iter_mut().find(|(other, _)| other == name) {
                Some((_, members)) => members.push(number as u32),
                None => names.push((name.clone(), vec![number as u32])),
            }
        }
        lines.push(&line);
        rings.push((number - drawing.groups[group].1.start) as i64);
        polygons.push(group as i64);
    }
    if doubled_areas.iter().any(|&doubled_area| doubled_area < 0.0) {
        return refuse("an unbounded set");
    }
    let count = lines.len();
    let model = Model::from_lines(Positions::from_flat(2, flat)?, lines)?;
    let column = |name: &str, numbers: Vec<i64>| CellData::integers(name, GroupKind::Lines, 1, numbers);
    let mut model = model
        .with_data(column("polygon", polygons)?)?
        .with_data(column("ring", rings)?)?
        .with_data(column("fill_rule", vec![0; count])?)?;
    for (name, members) in names {
        model = model.with_group(Group::new(name, GroupKind::Lines, members))?;
    }
    model.remarks.extend(drawing.remarks.iter().cloned());
    if stated.is_none() && drawing.order != Order::LINEAR {
        model.remarks.push(flattening_remark(count, tolerance));
    }
    Ok(model)
}
