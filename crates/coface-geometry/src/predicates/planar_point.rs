//! Points in the plane: given points, and crossings of two lines that are never computed.

use super::double_double::{Approximation, is_ordinary, widened};
use super::{Dyadic, PlanarLine, direction_turn};
use coface_algebra::Rational;
use std::cmp::Ordering;

/// A point of the plane: given by coordinates, or the crossing of two lines.
///
/// # Examples
/// The diagonals of a rectangle cross in a point that has no exact coordinates in binary; it is on both.
/// ```
/// use coface_geometry::predicates::PlanarPoint;
/// use std::cmp::Ordering;
/// let diagonals = [[[0.0, 0.0], [1.0, 1.0]], [[0.0, 0.5], [1.0, 0.0]]];
/// let crossing = PlanarPoint::crossing(diagonals[0], diagonals[1]).expect("they are not parallel");
/// assert_eq!(crossing.rounded(), [1.0 / 3.0, 1.0 / 3.0]);
/// assert_eq!(crossing.side_of(diagonals[0]), Ordering::Equal);
/// // A third of 1 is more than its nearest floating-point number.
/// assert_eq!(crossing.compare(&PlanarPoint::given([1.0 / 3.0, 1.0])), Ordering::Greater);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct PlanarPoint {
    lines: Option<[PlanarLine; 2]>,
    rounded: [f64; 2],
    residues: [Option<Ordering>; 2],
}

impl PlanarPoint {
    /// The point with these coordinates, which are finite.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::predicates::PlanarPoint;
    /// assert_eq!(PlanarPoint::given([1., 2.]).rounded(), [1., 2.]);
    /// ```
    pub fn given(coordinates: [f64; 2]) -> Self {
        Self { lines: None, rounded: coordinates, residues: [Some(Ordering::Equal); 2] }
    }

    /// The point where two lines cross; `None` if they are parallel or one.
    ///
    /// # Complexity
    /// Constant: a hundred operations in floating point unless the lines are nearly parallel.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::predicates::PlanarPoint;
    /// let diagonal = [[0., 0.], [2., 2.]];
    /// let crossing = PlanarPoint::crossing(diagonal, [[0., 2.], [2., 0.]]).expect("not parallel");
    /// assert_eq!(crossing.rounded(), [1., 1.]);
    /// assert!(PlanarPoint::crossing(diagonal, [[5., 0.], [6., 1.]]).is_none());
    /// ```
    pub fn crossing(s: PlanarLine, t: PlanarLine) -> Option<Self> {
        // Lines along the axes know one coordinate each.
        let is_along = |line: PlanarLine, axis: usize| {
            line[0][1 - axis] == line[1][1 - axis] && line[0][axis] != line[1][axis]
        };
        let upright = if is_along(s, 0) && is_along(t, 1) {
            Some([t[0][0], s[0][1]])
        } else if is_along(s, 1) && is_along(t, 0) {
            Some([s[0][0], t[0][1]])
        } else {
            None
        };
        if let Some(rounded) = upright {
            return Some(Self { lines: Some([s, t]), rounded, residues: [Some(Ordering::Equal); 2] });
        }
        if let Some(found) = filtered_crossing(s, t) {
            return Some(found);
        }
        if direction_turn(s, t).is_eq() {
            return None;
        }
        let exact = HomogeneousPoint::crossing(s, t);
        let [(x, x_residue), (y, y_residue)] = [0, 1].map(|axis| exact.rounded(axis));
        Some(Self { lines: Some([s, t]), rounded: [x, y], residues: [Some(x_residue), Some(y_residue)] })
    }

    /// The crossing of two lines with the known results of [`Self::rounded`] and [`Self::residues`].
    #[doc(hidden)]
    pub fn known_crossing(
        lines: [PlanarLine; 2],
        rounded: [f64; 2],
        residues: [Option<Ordering>; 2],
    ) -> Self {
        Self { lines: Some(lines), rounded, residues }
    }

    /// The floating-point coordinates nearest to those of the point, ties to even; infinite beyond the range.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::predicates::PlanarPoint;
    /// let third = PlanarPoint::crossing([[0., 0.], [1., 1.]], [[0., 0.5], [1., 0.]]).expect("not parallel");
    /// assert_eq!(third.rounded(), [1.0 / 3.0; 2]);
    /// ```
    pub fn rounded(&self) -> [f64; 2] {
        self.rounded
    }

    /// How each coordinate compares with its rounded value; `None` where that is not known yet.
    #[doc(hidden)]
    pub fn residues(&self) -> [Option<Ordering>; 2] {
        self.residues
    }

    /// Whether the coordinates are floating-point numbers.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::predicates::PlanarPoint;
    /// let third = PlanarPoint::crossing([[0., 0.], [1., 1.]], [[0., 0.5], [1., 0.]]).expect("not parallel");
    /// assert!(PlanarPoint::given([0.1, 0.2]).is_exactly_rounded() && !third.is_exactly_rounded());
    /// ```
    pub fn is_exactly_rounded(&self) -> bool {
        (0..2)
            .all(|axis| self.residues[axis].unwrap_or_else(|| self.to_homogeneous().rounded(axis).1).is_eq())
    }

    /// The order of one coordinate of two points: 0 for x, 1 for y. Exact.
    ///
    /// # Panics
    /// If `axis` is neither 0 nor 1.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::predicates::PlanarPoint;
    /// let (a, b) = (PlanarPoint::given([1., 5.]), PlanarPoint::given([2., 4.]));
    /// assert!(a.compare_coordinate(&b, 0).is_lt() && a.compare_coordinate(&b, 1).is_gt());
    /// ```
    pub fn compare_coordinate(&self, other: &Self, axis: usize) -> Ordering {
        match known_order(self, other, axis) {
            Some(order) => order,
            None => self.to_homogeneous().compare_coordinate(&other.to_homogeneous(), axis),
        }
    }

    /// The order by x, then by y. Exact; `Equal` exactly for equal points.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::predicates::PlanarPoint;
    /// let (a, b) = (PlanarPoint::given([1., 5.]), PlanarPoint::given([1., 4.]));
    /// assert!(a.compare(&b).is_gt() && a.compare(&a).is_eq());
    /// ```
    pub fn compare(&self, other: &Self) -> Ordering {
        self.compare_coordinate(other, 0).then_with(|| self.compare_coordinate(other, 1))
    }

    /// On which side of a line the point lies: `Greater` for left, `Less` for right, `Equal` for on it. Exact.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::predicates::PlanarPoint;
    /// let east = [[0., 0.], [1., 0.]];
    /// assert!(PlanarPoint::given([5., 1e-300]).side_of(east).is_gt());
    /// assert!(PlanarPoint::given([5., 0.]).side_of(east).is_eq());
    /// ```
    pub fn side_of(&self, line: PlanarLine) -> Ordering {
        if line.as_flattened().iter().chain(&self.rounded).all(|&x| is_ordinary(x)) {
            let d = |axis: usize| Approximation::difference(line[1][axis], line[0][axis]);
            let to = |axis: usize| self.approximation(axis).minus(Approximation::new(line[0][axis], 0.0));
            if let Some(sign) = d(0).times(to(1)).minus(d(1).times(to(0))).sign() {
                return sign;
            }
        }
        self.to_homogeneous().side_of(line)
    }

    /// The order of the heights of two lines above the x of this point. Neither line is vertical. Exact.
    #[doc(hidden)]
    pub fn compare_heights(&self, s: PlanarLine, t: PlanarLine) -> Ordering {
        let mut coordinates = s.as_flattened().iter().chain(t.as_flattened()).chain(&self.rounded);
        if coordinates.all(|&x| is_ordinary(x)) {
            let height = |line: PlanarLine| {
                let d = |axis: usize| Approximation::difference(line[1][axis], line[0][axis]);
                let along = self.approximation(0).minus(Approximation::new(line[0][0], 0.0)).over(d(0))?;
                Some(Approximation::new(line[0][1], 0.0).plus(along.times(d(1))))
            };
            if let (Some(a), Some(b)) = (height(s), height(t))
                && let Some(sign) = a.minus(b).sign()
            {
                return sign;
            }
        }
        self.to_homogeneous().compare_heights(s, t)
    }

    /// A coordinate with the error that rounding made.
    fn approximation(&self, axis: usize) -> Approximation {
        let value = self.rounded[axis];
        let exact = self.residues[axis] == Some(Ordering::Equal);
        Approximation::new(value, if exact { 0.0 } else { value.abs() * f64::EPSILON + f64::from_bits(1) })
    }

    fn coordinates_in_twice_the_precision(&self) -> Option<[Approximation; 2]> {
        match self.lines {
            Some([s, t]) => approximate_crossing(s, t),
            None if self.rounded.iter().all(|&x| is_ordinary(x)) => {
                Some(self.rounded.map(|x| Approximation::new(x, 0.0)))
            }
            None => None,
        }
    }

    /// The exact coordinates as fractions.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::predicates::PlanarPoint;
    /// let third = PlanarPoint::crossing([[0., 0.], [1., 1.]], [[0., 0.5], [1., 0.]]).expect("not parallel");
    /// assert_eq!(third.to_rational().map(|x| x.to_string()), ["1/3", "1/3"]);
    /// ```
    pub fn to_rational(&self) -> [Rational; 2] {
        let exact = self.to_homogeneous();
        [0, 1].map(|axis| exact.coordinates[axis].quotient(&exact.weight))
    }

    /// The point as a quotient of exact numbers.
    #[doc(hidden)]
    pub fn to_homogeneous(self) -> HomogeneousPoint {
        match self.lines {
            Some([s, t]) => HomogeneousPoint::crossing(s, t),
            None => HomogeneousPoint::given(self.rounded),
        }
    }
}

/// The order of one coordinate as far as the rounded values tell: rounding is monotone, so different ones are in order,
/// and of equal ones the sides they were rounded from may tell.
pub(crate) fn known_order(a: &PlanarPoint, b: &PlanarPoint, axis: usize) -> Option<Ordering> {
    let order = a.rounded[axis].partial_cmp(&b.rounded[axis]).expect("coordinates are numbers");
    if order.is_ne() {
        return Some(order);
    }
    let (x, y) = (a.residues[axis]?, b.residues[axis]?);
    (x != y || x.is_eq()).then(|| x.cmp(&y))
}

/// The crossing in twice the usual precision, if that is enough to round it.
fn filtered_crossing(s: PlanarLine, t: PlanarLine) -> Option<PlanarPoint> {
    let mut rounded = [0.0; 2];
    let mut residues = [None; 2];
    for (axis, at) in approximate_crossing(s, t)?.into_iter().enumerate() {
        let (value, [below, above]) = (at.high, at.rest());
        // All numbers between two that are rounded to the same are rounded to it.
        if value + below != value || value + above != value {
            return None;
        }
        rounded[axis] = value;
        residues[axis] = if below > 0.0 {
            Some(Ordering::Greater)
        } else if above < 0.0 {
            Some(Ordering::Less)
        } else {
            (at.error == 0.0).then_some(Ordering::Equal)
        };
    }
    Some(PlanarPoint { lines: Some([s, t]), rounded, residues })
}

/// The crossing in twice the usual precision; `None` for numbers out of the ordinary, and for lines that are parallel
/// or nearly so.
fn approximate_crossing(s: PlanarLine, t: PlanarLine) -> Option<[Approximation; 2]> {
    if !s.as_flattened().iter().chain(t.as_flattened()).all(|&x| is_ordinary(x)) {
        return None;
    }
    let d = |line: PlanarLine, axis: usize| Approximation::difference(line[1][axis], line[0][axis]);
    let [sx, sy, tx, ty] = [d(s, 0), d(s, 1), d(t, 0), d(t, 1)];
    let across = |axis: usize| Approximation::difference(t[0][axis], s[0][axis]);
    let denominator = sx.times(ty).minus(sy.times(tx));
    let along = across(0).times(ty).minus(across(1).times(tx)).over(denominator)?;
    let coordinate = |axis: usize, direction: Approximation| {
        // A line that is parallel to an axis knows one coordinate.
        match [s, t].into_iter().find(|line| line[0][axis] == line[1][axis]) {
            Some(line) => Approximation::new(line[0][axis], 0.0),
            None => Approximation::new(s[0][axis], 0.0).plus(along.times(direction)),
        }
    };
    Some([coordinate(0, sx), coordinate(1, sy)])
}

/// The area within closed walks, positive where they run counterclockwise, with a bound on its error; `None` for
/// numbers out of the ordinary.
pub fn approximate_area<W: Iterator<Item = PlanarPoint>>(walks: impl Iterator<Item = W>) -> Option<[f64; 2]> {
    // Bounds are summed apart: what an addition makes wider is its own only.
    let (mut doubled, mut error) = (Approximation::new(0.0, 0.0), 0.0);
    for mut walk in walks {
        let Some(first) = walk.next() else { continue };
        let first = first.coordinates_in_twice_the_precision()?;
        let mut last = [Approximation::new(0.0, 0.0); 2];
        for corner in walk {
            let corner = corner.coordinates_in_twice_the_precision()?;
            let corner = [0, 1].map(|axis| corner[axis].minus(first[axis]));
            let sum = doubled.plus(last[0].times(corner[1]).minus(last[1].times(corner[0])));
            error += sum.error;
            doubled = Approximation { error: 0.0, ..sum };
            last = corner;
        }
    }
    Some([doubled.high * 0.5, widened(error) * 0.5 + doubled.low.abs()])
}

/// The point $(x / w, y / w)$ with exact numbers; w is positive.
#[derive(Clone, Debug)]
pub struct HomogeneousPoint {
    coordinates: [Dyadic; 2],
    weight: Dyadic,
}

impl HomogeneousPoint {
    fn given(coordinates: [f64; 2]) -> Self {
        Self { coordinates: coordinates.map(Dyadic::from), weight: Dyadic::from(1.0) }
    }

    /// The crossing of two lines that are not parallel:
    /// $s_0 + (s_1 - s_0) ((t_0 - s_0) \times d_t) / (d_s \times d_t)$.
    fn crossing(s: PlanarLine, t: PlanarLine) -> Self {
        let [s0, s1, t0, t1] = [s[0], s[1], t[0], t[1]].map(|point| point.map(Dyadic::from));
        let minus = |a: &[Dyadic; 2], b: &[Dyadic; 2]| [&a[0] - &b[0], &a[1] - &b[1]];
        let cross = |a: &[Dyadic; 2], b: &[Dyadic; 2]| &(&a[0] * &b[1]) - &(&a[1] * &b[0]);
        let (ds, dt) = (minus(&s1, &s0), minus(&t1, &t0));
        let mut weight = cross(&ds, &dt);
        let mut along = cross(&minus(&t0, &s0), &dt);
        if weight.sign().is_lt() {
            (weight, along) = (-&weight, -&along);
        }
        let coordinates = [0, 1].map(|axis| &(&s0[axis] * &weight) + &(&ds[axis] * &along));
        Self { coordinates, weight }
    }

    /// The nearest floating-point number of a coordinate, and how the coordinate compares with it.
    pub(crate) fn rounded(&self, axis: usize) -> (f64, Ordering) {
        self.coordinates[axis].rounded_quotient(&self.weight)
    }

    pub(crate) fn compare_coordinate(&self, other: &Self, axis: usize) -> Ordering {
        (&(&self.coordinates[axis] * &other.weight) - &(&other.coordinates[axis] * &self.weight)).sign()
    }

    #[doc(hidden)]
    pub fn compare(&self, other: &Self) -> Ordering {
        self.compare_coordinate(other, 0).then_with(|| self.compare_coordinate(other, 1))
    }

    fn side_of(&self, line: PlanarLine) -> Ordering {
        let [a, b] = line.map(|point| point.map(Dyadic::from));
        let to = |axis: usize| &self.coordinates[axis] - &(&a[axis] * &self.weight);
        let d = |axis: usize| &b[axis] - &a[axis];
        (&(&d(0) * &to(1)) - &(&d(1) * &to(0))).sign()
    }

    fn compare_heights(&self, s: PlanarLine, t: PlanarLine) -> Ordering {
        // The height of a line times its run and the weight; the run made positive.
        let height = |line: PlanarLine| {
            let [a, b] = if line[0][0] < line[1][0] { line } else { [line[1], line[0]] };
            let [a, b] = [a, b].map(|point| point.map(Dyadic::from));
            let [run, rise] = [0, 1].map(|axis| &b[axis] - &a[axis]);
            let to = &self.coordinates[0] - &(&a[0] * &self.weight);
            (&(&(&a[1] * &run) * &self.weight) + &(&to * &rise), run)
        };
        let ((height_s, run_s), (height_t, run_t)) = (height(s), height(t));
        (&(&height_s * &run_t) - &(&height_t * &run_s)).sign()
    }
}

#[cfg(test)]
mod tests {
    use super::super::samples::{coordinate, rational};
    use super::*;
    use proptest::prelude::*;

    /// The crossing in plain fractions.
    fn plain_crossing(s: PlanarLine, t: PlanarLine) -> Option<[Rational; 2]> {
        let [s0, s1, t0, t1] = [s[0], s[1], t[0], t[1]].map(|point| point.map(rational));
        let minus = |a: &[Rational; 2], b: &[Rational; 2]| [&a[0] - &b[0], &a[1] - &b[1]];
        let cross = |a: &[Rational; 2], b: &[Rational; 2]| &(&a[0] * &b[1]) - &(&a[1] * &b[0]);
        let (ds, dt) = (minus(&s1, &s0), minus(&t1, &t0));
        let along = &cross(&minus(&t0, &s0), &dt) * &cross(&ds, &dt).inverse()?;
        Some([0, 1].map(|axis| &s0[axis] + &(&along * &ds[axis])))
    }

    fn plain_side(point: &[Rational; 2], line: PlanarLine) -> Ordering {
        let [a, b] = line.map(|point| point.map(rational));
        let left = &(&b[0] - &a[0]) * &(&point[1] - &a[1]);
        (&left - &(&(&b[1] - &a[1]) * &(&point[0] - &a[0]))).cmp(&Rational::ZERO)
    }

    fn plain_height(x: &Rational, line: PlanarLine) -> Rational {
        let [a, b] = line.map(|point| point.map(rational));
        let slope = &(&b[1] - &a[1]) * &(&b[0] - &a[0]).inverse().unwrap();
        &a[1] + &(&(x - &a[0]) * &slope)
    }

    #[test]
    fn one_point_is_no_line() {
        let (level, upright) = ([[0., 1.], [-1., 1.]], [[0., 0.], [0., 2.]]);
        assert!(PlanarPoint::crossing(level, [[0.; 2]; 2]).is_none());
        assert!(PlanarPoint::crossing([[0.; 2]; 2], upright).is_none());
        assert_eq!(PlanarPoint::crossing(upright, level).unwrap().rounded(), [0., 1.]);
    }

    /// Lines between points of a few sorts: any size, a small grid, a grid that is not exact in binary.
    fn lines() -> impl Strategy<Value = Vec<PlanarLine>> {
        let grid = (-3i32..4).prop_map(f64::from);
        let tenths = (-3i32..4).prop_map(|x| f64::from(x) * 0.1);
        let near = (-3i32..4, -2i64..3)
            .prop_map(|(x, ulps)| f64::from_bits((f64::from(x) + 7.3).to_bits().wrapping_add_signed(ulps)));
        let line = |x: BoxedStrategy<f64>| prop::array::uniform4(x).prop_map(|[a, b, c, d]| [[a, b], [c, d]]);
        let sorts = [coordinate().boxed(), grid.boxed(), tenths.boxed(), near.boxed()];
        let of_a_sort = sorts.map(|sort| prop::collection::vec(line(sort), 5).boxed());
        prop::strategy::Union::new(of_a_sort)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(400))]
        #[test]
        fn decisions_are_those_of_fractions(lines in lines()) {
            let [s, t, u, v, w] = [0, 1, 2, 3, 4].map(|i| lines[i]);
            let mut points = vec![(PlanarPoint::given(s[0]), s[0].map(rational))];
            for (a, b) in [(s, t), (t, s), (u, v), (s, u), (t, u), (s, [t[1], t[0]]), (v, w)] {
                let found = PlanarPoint::crossing(a, b);
                let plain = plain_crossing(a, b);
                prop_assert_eq!(found.is_some(), plain.is_some());
                if let (Some(found), Some(plain)) = (found, plain) {
                    points.push((found, plain));
                }
            }
            for (p, plain) in &points {
                let exact = p.to_homogeneous();
                for (axis, plain) in plain.iter().enumerate() {
                    let (rounded, residue) = exact.rounded(axis);
                    prop_assert_eq!(p.rounded()[axis], rounded);
                    if rounded.is_finite() {
                        prop_assert_eq!(plain.cmp(&rational(rounded)), residue);
                    }
                    prop_assert!(p.residues()[axis].is_none_or(|known| known == residue));
                }
                for line in [s, t, u, v, w] {
                    prop_assert_eq!(p.side_of(line), plain_side(plain, line));
                }
                for (q, other) in &points {
                    prop_assert_eq!(p.compare(q), plain.cmp(other));
                    prop_assert_eq!(p.compare_coordinate(q, 1), plain[1].cmp(&other[1]));
                }
                for (a, b) in [(s, t), (u, v), (s, w)] {
                    if a[0][0] != a[1][0] && b[0][0] != b[1][0] {
                        let plain = plain_height(&plain[0], a).cmp(&plain_height(&plain[0], b));
                        prop_assert_eq!(p.compare_heights(a, b), plain);
                    }
                }
            }
        }
    }

    #[test]
    fn a_height_next_to_the_middle_of_two_numbers_is_rounded_exactly() {
        // The height is below the middle by less than the rest in twice the precision tells.
        let s = [[9.300000000000002, 8.300000000000002], [5.299999999999998, 8.299999999999999]];
        let t = [[6.299999999999998, 10.3], [6.300000000000001, 5.3]];
        for (s, t) in [(s, t), (t, s), ([s[1], s[0]], t)] {
            let crossing = PlanarPoint::crossing(s, t).unwrap();
            let exact = HomogeneousPoint::crossing(s, t);
            assert_eq!(crossing.rounded(), [0, 1].map(|axis| exact.rounded(axis).0));
            assert_eq!(crossing.rounded()[1], 8.299999999999999);
        }
    }

    #[test]
    fn three_lines_through_one_point_cross_once() {
        // A pencil of lines through (1/3, 1/3): all crossings are equal, and none is exact.
        let pencil: Vec<PlanarLine> =
            (0..6).map(|i| [[0.0, f64::from(i) - 1.0], [1.0, 3.0 - 2.0 * f64::from(i)]]).collect();
        let points: Vec<PlanarPoint> = (0..6)
            .flat_map(|i| (0..i).map(move |j| (i, j)))
            .map(|(i, j)| PlanarPoint::crossing(pencil[i], pencil[j]).unwrap())
            .collect();
        assert!(points.iter().all(|p| p.compare(&points[0]).is_eq() && !p.is_exactly_rounded()));
        assert_eq!(points[0].rounded(), [1.0 / 3.0; 2]);
    }
}
