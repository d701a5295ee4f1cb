//! Points in space: given points, and intersections of lines and planes that are never computed.

use super::arithmetic::{Arithmetic, cross, dot, normal, vector};
use super::double_double::{Approximation, widened};
use super::estimate::Estimate;
use super::short_dyadic::ShortDyadic;
use super::spatial_quotient::{Quotient, line_and_plane, sign_over, three_planes, two_lines};
use super::{Dyadic, SpatialLine, SpatialPlane, spatial_orientation};
use coface_algebra::Rational;
use std::cmp::Ordering;

/// A point of space: given by coordinates, or the intersection of a line and a plane, of three planes or of two lines.
///
/// Decisions about it are exact, whatever its coordinates. The point remembers them to about 106 bits, which settles
/// nearly all of them; integers of any size settle the rest.
///
/// # Examples
/// Three planes meet in a point that has no exact coordinates in binary; it is in all of them.
/// ```
/// use coface_geometry::predicates::SpatialPoint;
/// use std::cmp::Ordering;
/// let planes = [
///     [[1., 0., 0.], [0., 1., 0.], [0., 0., 1.]], // x + y + z = 1
///     [[0., 0., 0.], [1., 1., 0.], [0., 0., 1.]], // x = y
///     [[0., 0., 0.], [1., 0., 0.], [0., 1., 1.]], // y = z
/// ];
/// let third = SpatialPoint::of_planes(planes).expect("they meet in one point");
/// assert_eq!(third.rounded(), [1.0 / 3.0; 3]);
/// assert!(planes.iter().all(|&plane| third.side_of(plane).is_eq()));
/// // A third of 1 is more than its nearest floating-point number.
/// assert_eq!(third.compare(&SpatialPoint::given([1.0 / 3.0; 3])), Ordering::Greater);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct SpatialPoint {
    /// The coordinates, correctly rounded.
    rounded: [f64; 3],
    /// What rounding took away, ...
    rest: [f64; 3],
    /// ... up to this much.
    error: [f64; 3],
    /// How each coordinate compares with its rounded value.
    residues: [Ordering; 3],
    definition: Definition,
}

/// What a point of space is known by.
///
/// # Examples
/// ```
/// use coface_geometry::predicates::{PointDefinition, SpatialPoint};
/// let line = [[0., 0., 1.], [3., 3., 1.]];
/// let point = SpatialPoint::on_plane(line, [[1., 0., 0.], [0., 1., 0.], [0., 2., 5.]]).expect("not parallel");
/// assert!(matches!(point.definition(), PointDefinition::LineAndPlane(own, _) if own == line));
/// // Points with floating-point coordinates are known by these.
/// let point = SpatialPoint::on_plane(line, [[2., 0., 0.], [0., 2., 0.], [0., 2., 5.]]).expect("not parallel");
/// assert_eq!(point.definition(), PointDefinition::Given([1., 1., 1.]));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PointDefinition {
    /// Coordinates.
    Given([f64; 3]),
    /// Where a line meets a plane.
    LineAndPlane(SpatialLine, SpatialPlane),
    /// Where three planes meet.
    Planes([SpatialPlane; 3]),
    /// Where two lines of one plane cross.
    Lines([SpatialLine; 2]),
}

impl PointDefinition {
    /// The point; `None` unless the lines and planes have exactly one in common.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::predicates::PointDefinition;
    /// let lines = [[[0., 0., 5.], [2., 2., 5.]], [[0., 2., 5.], [2., 0., 5.]]];
    /// assert_eq!(PointDefinition::Lines(lines).point().map(|point| point.rounded()), Some([1., 1., 5.]));
    /// assert!(PointDefinition::Lines([lines[0]; 2]).point().is_none());
    /// ```
    pub fn point(self) -> Option<SpatialPoint> {
        match self {
            Self::Given(coordinates) => Some(SpatialPoint::given(coordinates)),
            Self::LineAndPlane(line, plane) => SpatialPoint::on_plane(line, plane),
            Self::Planes(planes) => SpatialPoint::of_planes(planes),
            Self::Lines([s, t]) => SpatialPoint::of_lines(s, t),
        }
    }
}

#[derive(Clone, Copy, Debug)]
enum Definition {
    Given,
    LineAndPlane(SpatialLine, SpatialPlane),
    Planes([SpatialPlane; 3]),
    /// The lines, and an axis along which they are seen to cross.
    Lines([SpatialLine; 2], usize),
}

impl SpatialPoint {
    /// The point with these coordinates, which are finite.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::predicates::SpatialPoint;
    /// assert_eq!(SpatialPoint::given([1., 2., 3.]).rounded(), [1., 2., 3.]);
    /// ```
    pub fn given(coordinates: [f64; 3]) -> Self {
        Self {
            // Zero has no sign here, that equal coordinates have equal bits.
            rounded: coordinates.map(|x| x + 0.0),
            rest: [0.0; 3],
            error: [0.0; 3],
            residues: [Ordering::Equal; 3],
            definition: Definition::Given,
        }
    }

    /// The point where a line meets a plane; `None` if it is parallel to the plane or in it.
    ///
    /// # Complexity
    /// Constant: some hundred operations in floating point unless the line is nearly parallel to the plane.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::predicates::SpatialPoint;
    /// let ground = [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.]];
    /// let point = SpatialPoint::on_plane([[2., 3., 1.], [2., 3., 5.]], ground).expect("not parallel");
    /// assert_eq!(point.rounded(), [2., 3., 0.]);
    /// assert!(SpatialPoint::on_plane([[0., 0., 1.], [1., 0., 1.]], ground).is_none());
    /// ```
    pub fn on_plane(line: SpatialLine, plane: SpatialPlane) -> Option<Self> {
        let known = [0, 1, 2].map(|axis| constant(&plane, axis).or_else(|| constant(&line, axis)));
        Self::found(Definition::LineAndPlane(line, plane), known, &line_and_plane(line, plane))
    }

    /// The only point that three planes have in common; `None` if they have none or more.
    ///
    /// # Complexity
    /// Constant: two thousand operations in floating point unless two of the planes, or the third and the line where
    /// the others meet, are nearly parallel.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::predicates::SpatialPoint;
    /// let x = [[7., 0., 0.], [7., 1., 0.], [7., 0., 1.]];
    /// let y = [[0., 8., 0.], [0., 8., 1.], [1., 8., 0.]];
    /// let z = [[0., 0., 9.], [1., 0., 9.], [0., 1., 9.]];
    /// assert_eq!(SpatialPoint::of_planes([x, y, z]).map(|point| point.rounded()), Some([7., 8., 9.]));
    /// assert!(SpatialPoint::of_planes([x, x, z]).is_none());
    /// ```
    pub fn of_planes(planes: [SpatialPlane; 3]) -> Option<Self> {
        let known = [0, 1, 2].map(|axis| planes.iter().find_map(|plane| constant(plane, axis)));
        Self::found(Definition::Planes(planes), known, &three_planes(&planes))
    }

    /// The point where two lines of one plane cross; `None` if they are parallel, one or in no common plane.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::predicates::SpatialPoint;
    /// let (s, t) = ([[0., 0., 5.], [2., 2., 5.]], [[0., 2., 5.], [2., 0., 5.]]);
    /// assert_eq!(SpatialPoint::of_lines(s, t).map(|point| point.rounded()), Some([1., 1., 5.]));
    /// ```
    pub fn of_lines(s: SpatialLine, t: SpatialLine) -> Option<Self> {
        if spatial_orientation(s[0], s[1], t[0], t[1]).is_ne() {
            return None;
        }
        let known = [0, 1, 2].map(|axis| constant(&s, axis).or_else(|| constant(&t, axis)));
        let axis = crossing_axis(s, t)?;
        Self::found(Definition::Lines([s, t], axis), known, &two_lines([s, t], axis))
    }

    /// The point of a definition of which some coordinates are known at once, and all of them about.
    fn found(
        definition: Definition,
        known: [Option<f64>; 3],
        about: &Quotient<Approximation>,
    ) -> Option<Self> {
        let mut point = Self { definition, ..Self::given([0.0; 3]) };
        let mut exact = None;
        match about.weight.sign() {
            Some(Ordering::Equal) => return None,
            Some(_) => {}
            None => {
                let short = exact.insert(definition.quotient::<ShortDyadic>([0.0; 3]));
                if short.weight.certain_sign() == Some(Ordering::Equal) {
                    return None;
                }
            }
        }
        let certain = (0..3).all(|axis| {
            let at = match known[axis] {
                Some(coordinate) => Some(Approximation::new(coordinate, 0.0)),
                None => about.offset[axis]
                    .over(about.weight)
                    .map(|along| Approximation::new(about.base[axis], 0.0).plus(along)),
            };
            at.is_some_and(|at| {
                point.set_if_certain(axis, at, || {
                    let exact = exact.get_or_insert_with(|| definition.quotient([0.0; 3]));
                    sign_over(&exact.above(at.high, axis), &[&exact.weight])
                })
            })
        });
        if !certain {
            let exact = definition.quotient::<Dyadic>([0.0; 3]).with_positive_weight()?;
            for axis in 0..3 {
                let (high, low, residue) = exact.rounded(axis);
                point.rounded[axis] = high + 0.0;
                point.rest[axis] = low;
                point.error[axis] = if !high.is_finite() {
                    f64::INFINITY
                } else if residue.is_eq() {
                    0.0
                } else {
                    low.abs() * f64::EPSILON + f64::MIN_POSITIVE
                };
                point.residues[axis] = residue;
            }
        }
        if point.is_exactly_rounded() {
            point.definition = Definition::Given;
        }
        Some(point)
    }

    /// Takes over a coordinate if its rounding is certain; `residue` tells exactly how it compares with `at.high`,
    /// unless that takes long.
    fn set_if_certain(
        &mut self,
        axis: usize,
        at: Approximation,
        residue: impl FnOnce() -> Option<Ordering>,
    ) -> bool {
        let [below, above] = at.rest();
        // All numbers between two that are rounded to the same are rounded to it.
        if at.high + below != at.high || at.high + above != at.high {
            return false;
        }
        let residue = if below > 0.0 {
            Ordering::Greater
        } else if above < 0.0 {
            Ordering::Less
        } else if at.error == 0.0 {
            Ordering::Equal
        } else {
            match residue() {
                Some(residue) => residue,
                None => return false,
            }
        };
        self.residues[axis] = residue;
        self.rounded[axis] = at.high + 0.0;
        if residue.is_ne() {
            self.rest[axis] = at.low;
            self.error[axis] = at.error;
        }
        true
    }

    /// The floating-point coordinates nearest to those of the point, ties to even; infinite beyond the range.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::predicates::SpatialPoint;
    /// let (s, t) = ([[0., 0., 0.], [1., 1., 0.]], [[0., 0.5, 0.], [1., 0., 0.]]);
    /// let crossing = SpatialPoint::of_lines(s, t).expect("they cross");
    /// assert_eq!(crossing.rounded(), [1.0 / 3.0, 1.0 / 3.0, 0.0]);
    /// ```
    pub fn rounded(&self) -> [f64; 3] {
        self.rounded
    }

    /// Whether the coordinates are floating-point numbers.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::predicates::SpatialPoint;
    /// let (s, t) = ([[0., 0., 0.], [1., 1., 0.]], [[0., 0.5, 0.], [1., 0., 0.]]);
    /// assert!(SpatialPoint::given([0.1; 3]).is_exactly_rounded());
    /// assert!(!SpatialPoint::of_lines(s, t).expect("they cross").is_exactly_rounded());
    /// ```
    pub fn is_exactly_rounded(&self) -> bool {
        self.residues.iter().all(|residue| residue.is_eq())
    }

    /// Two floating-point numbers that are equal or neighbors, between which a coordinate lies: 0 for x, 1 for y, 2 for
    /// z.
    ///
    /// # Panics
    /// If `axis` is not below 3.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::predicates::SpatialPoint;
    /// let line = [[0., 0., 0.], [1., 3., 3.]];
    /// let point = SpatialPoint::on_plane(line, [[0., 1., 0.], [1., 1., 0.], [0., 1., 1.]]).expect("not parallel");
    /// assert_eq!(point.range(1), [1.0, 1.0]);
    /// assert_eq!(point.range(0), [1.0 / 3.0, (1.0f64 / 3.0).next_up()]);
    /// ```
    pub fn range(&self, axis: usize) -> [f64; 2] {
        let value = self.rounded[axis];
        match self.residues[axis] {
            _ if value == f64::INFINITY => [f64::MAX, value],
            _ if value == f64::NEG_INFINITY => [value, f64::MIN],
            Ordering::Less => [value.next_down(), value],
            Ordering::Equal => [value, value],
            Ordering::Greater => [value, value.next_up()],
        }
    }

    /// The order of one coordinate of two points: 0 for x, 1 for y, 2 for z. Exact.
    ///
    /// # Panics
    /// If `axis` is not below 3.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::predicates::SpatialPoint;
    /// let (a, b) = (SpatialPoint::given([1., 5., 0.]), SpatialPoint::given([2., 4., 0.]));
    /// assert!(a.compare_coordinate(&b, 0).is_lt() && a.compare_coordinate(&b, 1).is_gt());
    /// ```
    pub fn compare_coordinate(&self, other: &Self, axis: usize) -> Ordering {
        self.known_order(other, axis)
            .or_else(|| exact_order(&self.quotient::<ShortDyadic>(), &other.quotient(), axis))
            .or_else(|| exact_order(&self.quotient::<Dyadic>(), &other.quotient(), axis))
            .expect("exact numbers have a sign")
    }

    /// The order by x, then by y, then by z. Exact; `Equal` exactly for equal points.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::predicates::SpatialPoint;
    /// let (a, b) = (SpatialPoint::given([1., 5., 0.]), SpatialPoint::given([1., 4., 9.]));
    /// assert!(a.compare(&b).is_gt() && a.compare(&a).is_eq());
    /// ```
    pub fn compare(&self, other: &Self) -> Ordering {
        let mut short = None;
        for axis in 0..3 {
            let order = match self.known_order(other, axis) {
                Some(order) => order,
                // Points that leading digits do not tell apart are equal as a rule.
                None if short.is_none() && (self.is_in_planes_of(other) || other.is_in_planes_of(self)) => {
                    return Ordering::Equal;
                }
                None => {
                    let [a, b] =
                        short.get_or_insert_with(|| [self.quotient::<ShortDyadic>(), other.quotient()]);
                    exact_order(a, b, axis)
                        .or_else(|| exact_order(&self.quotient::<Dyadic>(), &other.quotient(), axis))
                        .expect("exact numbers have a sign")
                }
            };
            if order.is_ne() {
                return order;
            }
        }
        Ordering::Equal
    }

    /// Whether this is the other point, where that is defined by three planes; false if it would take long to tell.
    fn is_in_planes_of(&self, other: &Self) -> bool {
        let Definition::Planes(planes) = &other.definition else { return false };
        let mut short = None;
        planes.iter().filter(|plane| !self.is_by(plane)).all(|&plane| {
            let own = short.get_or_insert_with(|| self.quotient::<ShortDyadic>());
            exact_side(own, plane) == Some(Ordering::Equal)
        })
    }

    /// The order of one coordinate as far as its leading digits tell: rounding is monotone, so different ones are in
    /// order.
    pub(super) fn known_order(&self, other: &Self, axis: usize) -> Option<Ordering> {
        let order = self.rounded[axis].partial_cmp(&other.rounded[axis]).expect("coordinates are numbers");
        if order.is_ne() {
            return Some(order);
        }
        let (x, y) = (self.residues[axis], other.residues[axis]);
        if x != y || x.is_eq() {
            return Some(x.cmp(&y));
        }
        let difference = self.rest[axis] - other.rest[axis];
        let error = self.error[axis] + other.error[axis] + difference.abs() * f64::EPSILON;
        (difference.abs() > widened(error)).then(|| difference.total_cmp(&0.0))
    }

    /// On which side of a plane the point lies: `Greater` where the plane's triangle is seen to run counterclockwise,
    /// `Less` on the other side, `Equal` in the plane. Exact.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::predicates::SpatialPoint;
    /// let ground = [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.]];
    /// assert!(SpatialPoint::given([5., 5., 1e-300]).side_of(ground).is_gt());
    /// ```
    pub fn side_of(&self, plane: SpatialPlane) -> Ordering {
        if let Some(given) = self.as_given() {
            return spatial_orientation(plane[0], plane[1], plane[2], given);
        }
        if self.is_by(&plane) {
            return Ordering::Equal;
        }
        side_of_plane::<Estimate>(self, plane)
            .certain_sign()
            .or_else(|| side_of_plane::<Approximation>(self, plane).certain_sign())
            .or_else(|| exact_side(&self.quotient::<ShortDyadic>(), plane))
            .or_else(|| exact_side(&self.quotient::<Dyadic>(), plane))
            .expect("exact numbers have a sign")
    }

    /// The exact coordinates as fractions.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::predicates::SpatialPoint;
    /// let lines = [[[0., 0., 7.], [1., 1., 7.]], [[0., 0.5, 7.], [1., 0., 7.]]];
    /// let crossing = SpatialPoint::of_lines(lines[0], lines[1]).expect("they cross");
    /// assert_eq!(crossing.to_rational().map(|x| x.to_string()), ["1/3", "1/3", "7"]);
    /// ```
    pub fn to_rational(&self) -> [Rational; 3] {
        let exact = self.quotient::<Dyadic>().with_positive_weight();
        exact.expect("the point was found").to_rational()
    }

    /// What the point is known by: its coordinates where they are floating-point numbers, else lines and planes.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::predicates::{PointDefinition, SpatialPoint};
    /// assert_eq!(SpatialPoint::given([1., 2., 3.]).definition(), PointDefinition::Given([1., 2., 3.]));
    /// ```
    pub fn definition(&self) -> PointDefinition {
        match self.definition {
            Definition::Given => PointDefinition::Given(self.rounded),
            Definition::LineAndPlane(line, plane) => PointDefinition::LineAndPlane(line, plane),
            Definition::Planes(planes) => PointDefinition::Planes(planes),
            Definition::Lines(lines, _) => PointDefinition::Lines(lines),
        }
    }

    /// The coordinates if they were given or are floating-point numbers.
    pub(super) fn as_given(&self) -> Option<[f64; 3]> {
        matches!(self.definition, Definition::Given).then_some(self.rounded)
    }

    /// The planes that define the point.
    pub(super) fn planes(&self) -> [Option<SpatialPlane>; 3] {
        match self.definition {
            Definition::Given | Definition::Lines(..) => [None; 3],
            Definition::LineAndPlane(_, plane) => [Some(plane), None, None],
            Definition::Planes(planes) => planes.map(Some),
        }
    }

    /// The line that defines the point together with a plane.
    pub(super) fn line(&self) -> Option<SpatialLine> {
        match self.definition {
            Definition::LineAndPlane(line, _) => Some(line),
            _ => None,
        }
    }

    /// Whether a plane is one of those that define the point, or has a line that does between its corners.
    pub(super) fn is_by(&self, plane: &SpatialPlane) -> bool {
        let contains = |line: &SpatialLine| line.iter().all(|end| plane.contains(end));
        match &self.definition {
            Definition::Given => plane.contains(&self.rounded),
            Definition::LineAndPlane(line, own) => plane == own || contains(line),
            Definition::Planes(own) => own.contains(plane),
            Definition::Lines(lines, _) => lines.iter().any(contains),
        }
    }

    /// The point as a quotient.
    pub(super) fn quotient<T: Arithmetic>(&self) -> Quotient<T> {
        self.definition.quotient(self.rounded)
    }
}

impl Definition {
    fn quotient<T: Arithmetic>(&self, given: [f64; 3]) -> Quotient<T> {
        match *self {
            Self::Given => Quotient::given(given),
            Self::LineAndPlane(line, plane) => line_and_plane(line, plane),
            Self::Planes(ref planes) => three_planes(planes),
            Self::Lines(lines, axis) => two_lines(lines, axis),
        }
    }
}

fn exact_order<T: Arithmetic>(a: &Quotient<T>, b: &Quotient<T>, axis: usize) -> Option<Ordering> {
    sign_over(&a.difference(b, axis), &[&a.weight, &b.weight])
}

fn exact_side<T: Arithmetic>(point: &Quotient<T>, plane: SpatialPlane) -> Option<Ordering> {
    sign_over(&point.height(plane), &[&point.weight])
}

/// The coordinate that all of some points share.
fn constant(points: &[[f64; 3]], axis: usize) -> Option<f64> {
    points.iter().all(|point| point[axis] == points[0][axis]).then(|| points[0][axis])
}

/// An axis along which two lines are not seen parallel; `None` if they are.
fn crossing_axis(s: SpatialLine, t: SpatialLine) -> Option<usize> {
    let [d, e] = [s, t].map(|line| vector::<Estimate>(line[0], line[1]));
    let across = cross(&d, &e);
    let size = |axis: usize| across[axis].value().abs();
    let largest = (1..3).fold(0, |best, axis| if size(axis) > size(best) { axis } else { best });
    if across[largest].sign().is_some() {
        return Some(largest);
    }
    let [d, e] = [s, t].map(|line| vector::<Dyadic>(line[0], line[1]));
    cross(&d, &e).iter().position(|coordinate| coordinate.sign().is_ne())
}

/// The numbers that the coordinates of a point are kept in.
pub(super) trait Coordinates: Arithmetic {
    /// A coordinate of a point minus a number.
    fn from_number(point: &SpatialPoint, axis: usize, number: f64) -> Self;
    /// A coordinate of a point minus that of another.
    fn from_point(point: &SpatialPoint, axis: usize, other: &SpatialPoint) -> Self;
}

impl Coordinates for Estimate {
    fn from_number(point: &SpatialPoint, axis: usize, number: f64) -> Self {
        Self::new(point.rounded[axis], lost(point, axis)).minus(Self::new(number, 0.0))
    }
    fn from_point(point: &SpatialPoint, axis: usize, other: &SpatialPoint) -> Self {
        Self::new(point.rounded[axis], lost(point, axis))
            .minus(Self::new(other.rounded[axis], lost(other, axis)))
    }
}

/// At least what rounding took away.
fn lost(point: &SpatialPoint, axis: usize) -> f64 {
    point.rest[axis].abs() + point.error[axis]
}

impl Coordinates for Approximation {
    fn from_number(point: &SpatialPoint, axis: usize, number: f64) -> Self {
        approximation(point, axis).minus(Self::new(number, 0.0))
    }
    fn from_point(point: &SpatialPoint, axis: usize, other: &SpatialPoint) -> Self {
        approximation(point, axis).minus(approximation(other, axis))
    }
}

fn approximation(point: &SpatialPoint, axis: usize) -> Approximation {
    Approximation::known(point.rounded[axis], point.rest[axis], point.error[axis])
}

fn side_of_plane<T: Coordinates>(point: &SpatialPoint, plane: SpatialPlane) -> T {
    let to = [0, 1, 2].map(|axis| T::from_number(point, axis, plane[0][axis]));
    dot(&normal(plane), &to)
}
