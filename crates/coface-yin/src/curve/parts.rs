//! Parts of curves, and curves run through backward.

use super::bernstein::{self, Piece};
use super::{Carrier, Curve};
use coface_algebra::Error;

impl Curve<'_> {
    /// The same curve from its end to its beginning, over the same parameters.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::Curve;
    /// let curve = Curve::polyline(&[[0.0, 0.0], [1.0, 0.0], [1.0, 2.0]])?.reversed();
    /// assert_eq!(curve.knots(), [0.0, 2.0, 3.0]);
    /// assert_eq!(curve.knot_point(0), [1.0, 2.0]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn reversed(&self) -> Curve<'static> {
        let knots = self.knots();
        let [first, last] = [knots[0], knots[knots.len() - 1]];
        let mut turned: Vec<f64> = knots.iter().rev().map(|knot| first + (last - knot)).collect();
        // Rounding may have moved the ends, and knots onto each other.
        turned[0] = first;
        for at in 1..turned.len() {
            turned[at] = turned[at].max(turned[at - 1].next_up());
        }
        let controls = self.controls().iter().rev().copied().collect();
        let last_piece = self.piece_count() as u32 - 1;
        let carriers: Vec<Carrier> =
            self.carriers().iter().rev().map(|own| own.reversed(last_piece - own.piece())).collect();
        Curve::from_trusted(self.order(), controls, turned).carried_by(carriers)
    }

    /// The parts before and after a parameter; both keep their parameters. They share their common end.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) unless the parameter is between the first and the last knot.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::Curve;
    /// let curve = Curve::polyline(&[[0.0, 0.0], [1.0, 0.0], [1.0, 2.0]])?;
    /// let [before, after] = curve.split(2.0)?;
    /// assert_eq!(before.knots(), [0.0, 1.0, 2.0]);
    /// assert_eq!(after.controls(), [[1.0, 1.0], [1.0, 2.0]]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn split(&self, parameter: f64) -> Result<[Curve<'static>; 2], Error> {
        let [first, last] = self.range();
        if !(first < parameter && parameter < last) {
            return Err(Error::invalid(format!("{parameter} is not within the curve"))
                .with_cure(format!("give a parameter between {first} and {last}")));
        }
        Ok([self.part_within(first, parameter), self.part_within(parameter, last)])
    }

    /// The part from one parameter to another, which keeps its parameters. Of a closed curve it may run through the last knot: where
    /// `to` is not above `from`, and its parameters then go on rising beyond the last knot.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for parameters beyond the knots, and for an open curve unless they rise.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::Curve;
    /// let triangle = Curve::polyline(&[[0.0, 0.0], [4.0, 0.0], [0.0, 3.0], [0.0, 0.0]])?;
    /// let corner = triangle.part([11.0, 2.0])?;
    /// assert_eq!(corner.controls(), [[0.0, 1.0], [0.0, 0.0], [2.0, 0.0]]);
    /// assert_eq!(corner.knots(), [11.0, 12.0, 14.0]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn part(&self, [from, to]: [f64; 2]) -> Result<Curve<'static>, Error> {
        let [first, last] = self.range();
        let within = |parameter: f64| first <= parameter && parameter <= last;
        if !(within(from) && within(to)) {
            return Err(Error::invalid(format!("the part from {from} to {to} is not within the curve"))
                .with_cure(format!("give parameters from {first} to {last}")));
        }
        if from < to {
            return Ok(self.part_within(from, to));
        }
        if !self.is_closed() {
            return Err(Error::invalid(format!("a part of an open curve cannot run from {from} to {to}"))
                .with_cure("give parameters that rise"));
        }
        if from == last {
            return if to > first { Ok(self.part_within(first, to)) } else { Ok(self.clone().into_owned()) };
        }
        let mut part = self.part_within(from, last);
        if to > first {
            let rest = self.part_within(first, to);
            let mut controls = part.controls().to_vec();
            controls.extend_from_slice(&rest.controls()[1..]);
            let mut knots = part.knots().to_vec();
            for knot in &rest.knots()[1..] {
                let least = knots[knots.len() - 1].next_up();
                knots.push((last + (knot - first)).max(least));
            }
            part = Curve::from_trusted(self.order(), controls, knots);
        }
        Ok(part)
    }

    /// The first and the last knot.
    pub(crate) fn range(&self) -> [f64; 2] {
        [self.knots()[0], self.knots()[self.piece_count()]]
    }

    fn part_within(&self, from: f64, to: f64) -> Curve<'static> {
        let (first, start) = self.place(from);
        let (mut last, mut end) = self.place(to);
        if end == 0.0 {
            (last, end) = (last - 1, 1.0);
        }
        let mut knots = vec![from];
        knots.extend_from_slice(&self.knots()[first + 1..=last]);
        knots.push(to);
        let mut controls: Vec<[f64; 2]> = Vec::with_capacity((last - first + 1) * self.order().degree() + 1);
        for piece in first..=last {
            let range = [if piece == first { start } else { 0.0 }, if piece == last { end } else { 1.0 }];
            let part = bernstein::sub_range(self.piece(piece), range);
            controls.pop();
            controls.extend_from_slice(&part);
        }
        Curve::from_trusted(self.order(), controls, knots)
    }

    /// The curve with each control point moved by a function that keeps straight lines straight; straight pieces stay so exactly.
    pub(super) fn moved(&self, stretch: f64, image: impl Fn([f64; 2]) -> [f64; 2]) -> Curve<'static> {
        let order = self.order();
        let of_piece = |controls: &[[f64; 2]]| {
            if bernstein::is_straight(controls) {
                let ends = [controls[0], controls[order.degree()]].map(&image);
                bernstein::straight_piece(ends, order.value())
            } else {
                Piece::with(order.value(), |j| image(controls[j]))
            }
        };
        let carriers: Vec<Carrier> =
            self.carriers().iter().map(|own| own.mapped(stretch, of_piece)).collect();
        let moved = self.with_pieces(order, |piece| of_piece(self.piece(piece))).carried_by(carriers);
        if stretch == 1.0 {
            return moved;
        }
        let knots = self.knots().iter().map(|knot| knot * stretch).collect();
        let carriers = moved.carriers().to_vec();
        Curve::from_trusted(order, moved.controls().to_vec(), knots).carried_by(carriers)
    }
}
