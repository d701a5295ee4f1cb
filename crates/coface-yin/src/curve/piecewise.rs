//! Piecewise polynomial curves in the plane.

use super::bernstein::Piece;
use super::{Carrier, Order, bernstein};
use coface_algebra::{Error, ErrorKind};
use rayon::prelude::*;
use std::borrow::Cow;

/// So many chords are worth a task of their own.
const AT_ONCE: usize = 1 << 14;

/// A curve made of polynomial pieces, each from one knot to the next.
///
/// Piece i belongs to the parameters from knot i to knot i + 1 and is kept as its control points in the Bernstein basis: as many as
/// the order, the first and the last of which are on the curve. Neighbors share a control point, so that a curve has no gaps,
/// whatever is rounded. A curve of order 2 is the polyline through its control points. Parameters and coordinates are in the unit of
/// the input where the parameter is the chord length.
///
/// A curve is **closed** when its last control point is its first; then knot n is the same point as knot 0.
///
/// # Examples
/// Three sides of a unit square.
/// ```
/// use coface_yin::Curve;
/// let curve = Curve::polyline(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])?;
/// assert_eq!((curve.piece_count(), curve.is_closed()), (3, false));
/// assert_eq!(curve.knots(), [0.0, 1.0, 2.0, 3.0]);
/// assert_eq!(curve.piece(1), [[1.0, 0.0], [1.0, 1.0]]);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
///
/// Curves are equal when their control points and knots are; what their pieces are parts of, their [carriers](Carrier), is not compared.
#[derive(Clone, Debug)]
pub struct Curve<'a> {
    order: Order,
    controls: Cow<'a, [[f64; 2]]>,
    knots: Cow<'a, [f64]>,
    pub(super) carriers: Cow<'a, [Carrier]>,
}

impl PartialEq for Curve<'_> {
    fn eq(&self, other: &Self) -> bool {
        self.order == other.order && self.controls == other.controls && self.knots == other.knots
    }
}

impl Curve<'static> {
    /// A curve from its control points, `degree` for each piece and one more at the end, and its knots.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] when the counts do not fit together; [`ErrorKind::InvalidInput`] naming a number that is not finite or
    /// a knot that is not above the one before it.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Curve, Order};
    /// let segment = Curve::from_controls(Order::LINEAR, vec![[0.0, 0.0], [3.0, 4.0]], vec![0.0, 5.0])?;
    /// assert_eq!(segment.piece_count(), 1);
    /// assert!(Curve::from_controls(Order::CUBIC, vec![[0.0, 0.0], [3.0, 4.0]], vec![0.0, 5.0]).is_err());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn from_controls(order: Order, controls: Vec<[f64; 2]>, knots: Vec<f64>) -> Result<Self, Error> {
        let piece_count = knots.len().saturating_sub(1);
        if piece_count == 0 || controls.len() != piece_count * order.degree() + 1 {
            return Err(Error::new(
                ErrorKind::Shape,
                format!(
                    "{} control points and {} knots make no curve of order {order}",
                    controls.len(),
                    knots.len()
                ),
            )
            .with_cure(format!("give {} control points a piece and one more", order.degree())));
        }
        if let Some(at) = controls.iter().position(|point| point.iter().any(|x| !x.is_finite())) {
            return Err(Error::invalid(format!("control point {at} is not finite")));
        }
        if let Some(at) =
            knots.windows(2).position(|pair| pair[0].partial_cmp(&pair[1]) != Some(std::cmp::Ordering::Less))
        {
            return Err(Error::invalid(format!("knot {} is not above knot {at}", at + 1))
                .with_cure("give knots that rise"));
        }
        if knots.iter().any(|knot| !knot.is_finite()) {
            return Err(Error::invalid("a knot is not finite"));
        }
        Ok(Self::from_trusted(order, controls, knots))
    }

    /// The polyline through points, with the length of the way along it as parameter.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] naming a point that is not finite or equal to the one before it, and for less than two points.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::Curve;
    /// let square = Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?;
    /// assert_eq!(square.signed_area(), 4.0);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn polyline(points: &[[f64; 2]]) -> Result<Self, Error> {
        Ok(Self::from_trusted(Order::LINEAR, points.to_vec(), checked_chord_lengths(points)?))
    }

    /// A curve that is known to be well made.
    pub(crate) fn from_trusted(order: Order, controls: Vec<[f64; 2]>, knots: Vec<f64>) -> Self {
        debug_assert_eq!(controls.len(), (knots.len() - 1) * order.degree() + 1);
        Self { order, controls: controls.into(), knots: knots.into(), carriers: Cow::default() }
    }
}

impl<'a> Curve<'a> {
    /// A curve that is known to be well made, borrowed.
    pub(crate) fn borrowed(order: Order, controls: &'a [[f64; 2]], knots: &'a [f64]) -> Self {
        debug_assert_eq!(controls.len(), (knots.len() - 1) * order.degree() + 1);
        Self { order, controls: controls.into(), knots: knots.into(), carriers: Cow::default() }
    }

    /// The same curve with carriers of its pieces that are known to be right.
    pub(crate) fn carried_by(mut self, carriers: impl Into<Cow<'a, [Carrier]>>) -> Self {
        self.carriers = carriers.into();
        self
    }

    /// The same curve without numbers of its own.
    pub(crate) fn as_borrowed(&self) -> Curve<'_> {
        Curve::borrowed(self.order, self.controls(), self.knots()).carried_by(&*self.carriers)
    }

    /// The number of coefficients of each polynomial.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Curve, Order};
    /// let square = Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?;
    /// assert_eq!(square.order(), Order::LINEAR);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn order(&self) -> Order {
        self.order
    }

    /// The number of polynomial pieces.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::Curve;
    /// let square = Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?;
    /// assert_eq!(square.piece_count(), 4);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn piece_count(&self) -> usize {
        self.knots.len() - 1
    }

    /// The parameters at which pieces begin and end, one more than there are pieces.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::Curve;
    /// let square = Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?;
    /// assert_eq!(square.knots(), [0.0, 2.0, 4.0, 6.0, 8.0]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn knots(&self) -> &[f64] {
        &self.knots
    }

    /// All control points in order.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Curve, Order};
    /// let square = Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?;
    /// assert_eq!(square.controls().len(), 5);
    /// assert_eq!(square.raised(Order::CUBIC)?.controls().len(), 13);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn controls(&self) -> &[[f64; 2]] {
        &self.controls
    }

    /// The control points of a piece, as many as the order.
    ///
    /// # Panics
    /// If there is no such piece.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::Curve;
    /// let square = Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?;
    /// assert_eq!(square.piece(1), [[2.0, 0.0], [2.0, 2.0]]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn piece(&self, piece: usize) -> &[[f64; 2]] {
        let first = piece * self.order.degree();
        &self.controls[first..=first + self.order.degree()]
    }

    /// The point at a knot.
    ///
    /// # Panics
    /// If there is no such knot.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::Curve;
    /// let square = Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?;
    /// assert_eq!(square.knot_point(2), [2.0, 2.0]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn knot_point(&self, knot: usize) -> [f64; 2] {
        self.controls[knot * self.order.degree()]
    }

    /// Whether the curve ends in the point where it begins.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::Curve;
    /// let square = Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?;
    /// assert!(square.is_closed());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn is_closed(&self) -> bool {
        self.controls.first() == self.controls.last()
    }

    /// The same curve with polynomials of a higher order; straight pieces stay straight.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] when the order is below that of the curve.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Curve, Order};
    /// let line = Curve::polyline(&[[0.0, 0.0], [3.0, 6.0]])?;
    /// assert_eq!(line.raised(Order::CUBIC)?.piece(0), [[0.0, 0.0], [1.0, 2.0], [2.0, 4.0], [3.0, 6.0]]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn raised(&self, order: Order) -> Result<Curve<'static>, Error> {
        if order < self.order {
            return Err(Error::invalid(format!(
                "a curve of order {} has no lower order {order}",
                self.order
            ))
            .with_cure("fit the points of its knots anew"));
        }
        if order == self.order {
            return Ok(self.clone().into_owned());
        }
        let raised = |controls: &[[f64; 2]]| bernstein::raised(controls, order.value());
        let carriers: Vec<Carrier> = self.carriers.iter().map(|own| own.mapped(1.0, raised)).collect();
        Ok(self.with_pieces(order, |piece| raised(self.piece(piece))).carried_by(carriers))
    }

    /// A curve with the same knots, the pieces of which are given; each begins where the one before it ends.
    pub(crate) fn with_pieces(&self, order: Order, piece: impl Fn(usize) -> Piece) -> Curve<'static> {
        let mut controls = Vec::with_capacity(self.piece_count() * order.degree() + 1);
        for at in 0..self.piece_count() {
            controls.extend_from_slice(&piece(at)[..order.degree()]);
        }
        controls.extend(piece(self.piece_count() - 1).last());
        Curve::from_trusted(order, controls, self.knots.to_vec())
    }

    /// The same curve with its own storage.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Curve, YinSet};
    /// let square = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?])?;
    /// let curve: Curve<'static> = square.curve(0).into_owned();
    /// assert_eq!(curve, square.curve(0));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn into_owned(self) -> Curve<'static> {
        Curve {
            order: self.order,
            controls: self.controls.into_owned().into(),
            knots: self.knots.into_owned().into(),
            carriers: self.carriers.into_owned().into(),
        }
    }
}

/// The lengths of the way along a polyline up to each of its points.
pub(crate) fn chord_lengths(points: &[[f64; 2]]) -> Vec<f64> {
    let mut length = 0.0;
    let mut found = Vec::with_capacity(points.len());
    found.extend(points.first().map(|_| 0.0));
    found.extend(points.windows(2).map(|pair| {
        length += distance(pair[0], pair[1]);
        length
    }));
    found
}

/// The distance of two points.
pub(crate) fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    let [x, y] = [b[0] - a[0], b[1] - a[1]];
    let square = x * x + y * y;
    // The square root alone is quicker, where squares are ordinary numbers.
    if (1e-280..1e280).contains(&square) { square.sqrt() } else { x.hypot(y) }
}

/// The chord lengths, which rise.
pub(crate) fn checked_chord_lengths(points: &[[f64; 2]]) -> Result<Vec<f64>, Error> {
    if points.len() < 2 {
        return Err(Error::invalid(format!("{} points make no curve", points.len()))
            .with_cure("give two points or more"));
    }
    let not_finite = |at: usize| Error::invalid(format!("point {at} is not finite"));
    if points[0].iter().any(|x| !x.is_finite()) {
        return Err(not_finite(0));
    }
    let mut knots = vec![0.0; points.len()];
    let chord = |(knot, pair): (&mut f64, &[[f64; 2]])| *knot = distance(pair[0], pair[1]);
    if points.len() < AT_ONCE {
        knots[1..].iter_mut().zip(points.windows(2)).for_each(chord);
    } else {
        let lengths = knots[1..].par_iter_mut().zip(points.par_windows(2));
        lengths.with_min_len(AT_ONCE).for_each(chord);
    }
    // They are added up in order, so that sums do not depend on the number of threads.
    let mut length = 0.0;
    for (at, (knot, pair)) in knots[1..].iter_mut().zip(points.windows(2)).enumerate() {
        let next = length + *knot;
        if !(next > length && next.is_finite()) {
            let at = at + 1;
            return Err(if pair[1].iter().any(|x| !x.is_finite()) {
                not_finite(at)
            } else if pair[0] == pair[1] {
                Error::invalid(format!("points {} and {at} are equal", at - 1))
                    .with_cure("leave out one of them")
            } else if !next.is_finite() {
                Error::invalid(format!("the way to point {at} is longer than any number"))
                    .with_cure("scale the points down")
            } else {
                Error::invalid(format!(
                    "the chord from point {} to point {at} has no length that counts",
                    at - 1
                ))
                .with_cure("give points whose distances are of similar size")
            });
        }
        length = next;
        *knot = length;
    }
    Ok(knots)
}
