//! Closed curves through points, smooth between kinks.

use super::KnotIndex;
use super::smooth_pieces::piece_length;
use crate::curve::chord_lengths;
use crate::{Curve, EndCondition, Order, YinSet};
use coface_algebra::Error;

impl Curve<'static> {
    /// The closed curve through points that is smooth but at kinks: one spline from each kink to the next, periodic without kinks.
    ///
    /// `points` are the knots, the first one not again at the end; `kinks` are some of them by index, in any order, where the index
    /// after the last one is that of the first. Point 0 stays the origin of the parameter, also inside of a smooth piece. `ends` says
    /// how the smooth pieces of a curve with kinks end: a piece with 2 points is straight, with 3 a parabola by
    /// [`EndCondition::NotAKnot`].
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput), naming the points or the kink: fewer than 3 points, a point that is
    /// not finite, equal neighbors, a kink that is no point or is given twice, given derivatives without exactly one kink, and
    /// kinks with [`EndCondition::Periodic`].
    ///
    /// # Complexity
    /// $O(n)$ for n points, and $O(m \log m)$ for m kinks that do not rise.
    ///
    /// # Examples
    /// With kinks at all of its corners a square is straight.
    /// ```
    /// use coface_yin::{Curve, EndCondition, Order};
    /// let corners = [[0.0, 0.0], [3.0, 0.0], [3.0, 3.0], [0.0, 3.0]];
    /// let square = Curve::fit_closed(&corners, &[0, 1, 2, 3], Order::CUBIC, &EndCondition::NotAKnot)?;
    /// assert_eq!(square.piece(0), [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [3.0, 0.0]]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn fit_closed(
        points: &[[f64; 2]],
        kinks: &[u32],
        order: Order,
        ends: &EndCondition,
    ) -> Result<Self, Error> {
        closed_spline(points, kinks, order, ends, Parameters::Chords)
    }

    /// The same by [`Curve::fit_by_length`]: orders 6 and 8 keep their accuracy where the distances of points are uneven.
    ///
    /// # Errors
    /// As [`Self::fit_closed`].
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Curve, EndCondition, Order};
    /// let corners = [[0.0, 0.0], [3.0, 0.0], [3.0, 2.0], [0.0, 2.0]];
    /// let fits = [Curve::fit_closed, Curve::fit_closed_by_length];
    /// let [a, b] = fits.map(|fit| fit(&corners, &[], Order::CUBIC, &EndCondition::NotAKnot));
    /// assert_eq!(a?, b?);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn fit_closed_by_length(
        points: &[[f64; 2]],
        kinks: &[u32],
        order: Order,
        ends: &EndCondition,
    ) -> Result<Self, Error> {
        closed_spline(points, kinks, order, ends, Parameters::Lengths)
    }

    /// The same by [`Curve::fit_at`], with the parameters of the points and of the first one again at the end. Those of the curve are counted
    /// from the first.
    ///
    /// # Errors
    /// As [`Self::fit_closed`] and [`Self::fit_at`].
    ///
    /// # Examples
    /// An ellipse, 3 times as long as it is wide, by 24 points that lie three times as near together at its ends.
    /// ```
    /// use coface_yin::{Curve, EndCondition, Order};
    /// use std::f64::consts::{PI, TAU};
    /// let parameters: Vec<f64> = (0..=24).map(|i| f64::from(i) * TAU / 24.0).collect();
    /// let points: Vec<[f64; 2]> = parameters[..24].iter().map(|t| [3.0 * t.cos(), t.sin()]).collect();
    /// let (order, ends) = (Order::new(8)?, EndCondition::NotAKnot);
    /// let miss = |curve: Curve<'_>| (curve.signed_area() - 3.0 * PI).abs();
    /// assert!(miss(Curve::fit_closed_at(&points, &parameters, &[], order, &ends)?) < 1e-9);
    /// assert!(miss(Curve::fit_closed_by_length(&points, &[], order, &ends)?) > 1e-5);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn fit_closed_at(
        points: &[[f64; 2]],
        parameters: &[f64],
        kinks: &[u32],
        order: Order,
        ends: &EndCondition,
    ) -> Result<Self, Error> {
        if parameters.len() != points.len() + 1 {
            return Err(Error::invalid(format!(
                "{} parameters are given for {} points of a closed curve",
                parameters.len(),
                points.len()
            ))
            .with_cure("give a parameter for each point, and one for the first point again at the end"));
        }
        let knots: Vec<f64> = parameters.iter().map(|parameter| parameter - parameters[0]).collect();
        closed_spline(points, kinks, order, ends, Parameters::Given(&knots))
    }
}

/// What the parameters of splines are.
#[derive(Clone, Copy, PartialEq)]
enum Parameters<'a> {
    Chords,
    Lengths,
    Given(&'a [f64]),
}

impl Parameters<'_> {
    /// The parameters of so many points from one on around a closed curve, where they are given.
    fn around(self, first: usize, length: usize) -> Vec<f64> {
        let Self::Given(given) = self else { return Vec::new() };
        let count = given.len() - 1;
        let turn = given[count] - given[0];
        let at = |knot: usize| given[knot % count] + if knot < count { 0.0 } else { turn };
        (first..=first + length).map(at).collect()
    }
}

/// The closed curve of the splines through the points from kink to kink.
fn closed_spline(
    points: &[[f64; 2]],
    kinks: &[u32],
    order: Order,
    ends: &EndCondition,
    parameters: Parameters<'_>,
) -> Result<Curve<'static>, Error> {
    let fit = |points: &[[f64; 2]], first: usize, ends: &EndCondition| match parameters {
        Parameters::Chords => Curve::fit(points, order, ends),
        Parameters::Lengths => Curve::fit_by_length(points, order, ends),
        Parameters::Given(_) => {
            Curve::fit_at(points, &parameters.around(first, points.len() - 1), order, ends)
        }
    };
    check_points(points)?;
    let kinks = sorted_kinks(kinks, points.len())?;
    let mut closed = Vec::with_capacity(points.len() + 1);
    closed.extend_from_slice(points);
    closed.push(points[0]);
    if order == Order::LINEAR {
        let knots = match parameters {
            Parameters::Given(given) => given.to_vec(),
            _ => chord_lengths(&closed),
        };
        return Curve::from_controls(order, closed, knots);
    }
    if kinks.is_empty() {
        return fit(&closed, 0, &EndCondition::Periodic);
    }
    match ends {
        EndCondition::Periodic => {
            return Err(Error::invalid("a curve with kinks is not periodic")
                .with_cure("take another condition at the ends of smooth pieces, or no kinks"));
        }
        EndCondition::Complete { .. } if kinks.len() > 1 => {
            return Err(Error::invalid(format!(
                "one pair of derivatives is given for the ends of {} smooth pieces",
                kinks.len()
            ))
            .with_cure("give derivatives for curves with one kink only"));
        }
        _ => {}
    }
    let (count, degree) = (points.len(), order.degree());
    let mut controls = vec![[0.0; 2]; count * degree + 1];
    let mut lengths = vec![0.0; count];
    let mut own = Vec::new();
    for (at, &first) in kinks.iter().enumerate() {
        let first = first as usize;
        let length = piece_length(first, kinks[(at + 1) % kinks.len()] as usize, count);
        own.clear();
        own.extend((first..=first + length).map(|knot| points[knot % count]));
        let found = fit(&own, first, ends).map_err(|error| {
            let last = (first + length) % count;
            renamed(&error, &format!("the smooth piece from point {first} to point {last}"))
        })?;
        for (step, control) in found.controls().iter().take(length * degree).enumerate() {
            controls[(first * degree + step) % (count * degree)] = *control;
        }
        for (step, pair) in found.knots().windows(2).enumerate() {
            lengths[(first + step) % count] = pair[1] - pair[0];
        }
    }
    controls[count * degree] = controls[0];
    let knots = match parameters {
        Parameters::Chords => chord_lengths(&closed),
        Parameters::Given(given) => given.to_vec(),
        Parameters::Lengths => {
            let sums = lengths.iter().scan(0.0, |sum, length| {
                *sum += length;
                Some(*sum)
            });
            std::iter::once(0.0).chain(sums).collect()
        }
    };
    Curve::from_controls(order, controls, knots)
}

impl YinSet {
    /// The set whose boundary is fitted through rings of points: each ring a closed curve as [`Curve::fit_closed`] makes it, with the
    /// set on its left. The lists of `kinks` belong to the rings in order; rings without a list have no kinks.
    ///
    /// Curves, knots and their order are those of the rings. `ends` also holds for pieces that are refitted later, where given
    /// derivatives make way for [`EndCondition::NotAKnot`].
    ///
    /// # Errors
    /// As [`Curve::fit_closed`], naming the ring; more lists of kinks than rings; and curves that are not the boundary of a set, as
    /// [`YinSet::new`] says.
    ///
    /// # Examples
    /// A spline through 16 points of the unit circle bounds nearly as much as the circle.
    /// ```
    /// use coface_yin::{EndCondition, Order, YinSet};
    /// let ring = (0..16).map(|i| f64::from(i) * std::f64::consts::PI / 8.0).map(|t| [t.cos(), t.sin()]).collect::<Vec<_>>();
    /// let disk = YinSet::fit(&[ring], &[], Order::CUBIC, &EndCondition::NotAKnot)?;
    /// assert!((disk.curve(0).signed_area() - std::f64::consts::PI).abs() < 3e-4);
    /// assert!(disk.kinks().is_empty());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn fit(
        rings: &[Vec<[f64; 2]>],
        kinks: &[Vec<u32>],
        order: Order,
        ends: &EndCondition,
    ) -> Result<Self, Error> {
        if kinks.len() > rings.len() {
            return Err(Error::invalid(format!(
                "there are {} lists of kinks for {} rings",
                kinks.len(),
                rings.len()
            ))
            .with_cure("give one list of kinks a ring"));
        }
        let mut curves = Vec::with_capacity(rings.len());
        let mut at = Vec::new();
        for (ring, points) in rings.iter().enumerate() {
            let own = kinks.get(ring).map_or(&[][..], Vec::as_slice);
            let curve = Curve::fit_closed(points, own, order, ends)
                .map_err(|error| renamed(&error, &format!("ring {ring}")))?;
            at.extend(
                sorted_kinks(own, points.len())?
                    .into_iter()
                    .map(|knot| KnotIndex { curve: ring as u32, knot }),
            );
            curves.push(curve);
        }
        let mut set = Self::of_curves(order, &curves)?;
        let mut kinks = super::Kinks::new(at);
        kinks.pieces.set_ends(ends);
        *set.kinks_mut() = kinks;
        Ok(set)
    }
}

/// The same error, said of something.
pub(super) fn renamed(error: &Error, of: &str) -> Error {
    let said = Error::new(error.kind(), format!("{of}: {}", error.message()));
    match error.cure() {
        Some(cure) => said.with_cure(cure),
        None => said,
    }
}

fn check_points(points: &[[f64; 2]]) -> Result<(), Error> {
    if points.len() < 3 {
        return Err(Error::invalid(format!("{} points make no closed curve", points.len()))
            .with_cure("give 3 points or more"));
    }
    if let Some(at) = points.iter().position(|point| point.iter().any(|x| !x.is_finite())) {
        return Err(Error::invalid(format!("point {at} is not finite")).with_cure("give finite coordinates"));
    }
    let next = |at: usize| (at + 1) % points.len();
    if let Some(at) = (0..points.len()).find(|&at| points[at] == points[next(at)]) {
        let [x, y] = points[at];
        return Err(Error::invalid(format!("points {at} and {} are both ({x}, {y})", next(at)))
            .with_cure("give each point once; the first one is not repeated at the end"));
    }
    Ok(())
}

/// Kinks that rise, with the index after the last point as that of the first.
fn sorted_kinks(kinks: &[u32], count: usize) -> Result<Vec<u32>, Error> {
    if let Some(kink) = kinks.iter().find(|&&kink| kink as usize > count) {
        return Err(Error::invalid(format!("there is no point {kink} to be a kink"))
            .with_cure(format!("the points are 0 to {}", count.saturating_sub(1))));
    }
    let mut sorted: Vec<u32> =
        kinks.iter().map(|&kink| if kink as usize == count { 0 } else { kink }).collect();
    sorted.sort_unstable();
    if let Some(pair) = sorted.windows(2).find(|pair| pair[0] == pair[1]) {
        return Err(
            Error::invalid(format!("kink {} is given twice", pair[0])).with_cure("give each kink once")
        );
    }
    Ok(sorted)
}
