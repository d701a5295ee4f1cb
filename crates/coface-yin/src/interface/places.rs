//! Edges of an interface point by point, and their images.

use super::InterfaceGraph;
use crate::set::{extreme_curvatures, is_more, samples_along, turn_at};
use crate::{Curve, CurvePlace, Sample, Sampling};
use coface_algebra::{Error, Sign};
use coface_geometry::AffineMap;

/// How an edge of an interface bends.
///
/// # Examples
/// See [`InterfaceGraph::bends`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct EdgeBend {
    /// Where its curvature is least: positive where it turns left, one over the unit of the coordinates.
    pub least: CurvePlace,
    /// Where its curvature is greatest.
    pub greatest: CurvePlace,
    /// The knot between its ends at which its direction turns most at once, in radians, positive to the left; none for an edge of one piece.
    pub sharpest: Option<CurvePlace>,
}

impl InterfaceGraph {
    /// Points along the edges, edge by edge, with lengths, directions and curvatures. [`Sample::curve`] is the number of the edge. Edges that
    /// are not closed give the point at their end too.
    ///
    /// # Errors
    /// Those of [`YinSet::samples`](crate::YinSet::samples).
    ///
    /// # Complexity
    /// Linear in the pieces and points.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{InterfaceEdge, InterfaceGraph, Order, Sampling};
    /// let edge = |markers, phases| InterfaceEdge { ends: [0, 1], markers, phases };
    /// let edges = [
    ///     edge(vec![], [Some(0), Some(1)]),
    ///     edge(vec![[0.0, 2.0], [4.0, 2.0]], [None, Some(0)]),
    ///     edge(vec![[0.0, -2.0], [4.0, -2.0]], [Some(1), None]),
    /// ];
    /// let graph = InterfaceGraph::new(&[[0.0, 0.0], [4.0, 0.0]], &edges, &[], Order::LINEAR)?;
    /// let found = graph.samples(Sampling::PerCurve(4))?;
    /// assert_eq!((found.len(), found[4].point, found[4].length), (15, [4.0, 0.0], 4.0));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn samples(&self, sampling: Sampling) -> Result<Vec<Sample>, Error> {
        samples_along(self.curves.iter().map(Curve::as_borrowed), sampling)
    }

    /// How each edge bends: its least and its greatest curvature, and where it turns most at a knot between its ends, as in
    /// [`YinSet::bends`](crate::YinSet::bends).
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for an edge without a direction at a knot.
    ///
    /// # Complexity
    /// Linear in the pieces.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{InterfaceEdge, InterfaceGraph, Order};
    /// let edge = InterfaceEdge { ends: [0, 0], markers: vec![[1.0, 0.0], [0.0, 1.0]], phases: [Some(0), None] };
    /// let bend = InterfaceGraph::new(&[[0.0, 0.0]], &[edge], &[], Order::LINEAR)?.bends()?[0];
    /// assert_eq!((bend.least.value, bend.greatest.value), (0.0, 0.0));
    /// assert_eq!(bend.sharpest.map(|place| place.value.to_degrees().round()), Some(135.0));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn bends(&self) -> Result<Vec<EdgeBend>, Error> {
        let bend = |(number, curve): (usize, &Curve<'static>)| {
            let [least, greatest] = extreme_curvatures(curve);
            let mut sharpest: Option<CurvePlace> = None;
            for knot in 1..curve.piece_count() {
                let place = turn_at(curve, knot).ok_or_else(|| {
                    Error::invalid(format!("edge {number} has no direction at knot {knot}"))
                        .with_cure("fit the edge again through its knots")
                })?;
                if is_more(&place, sharpest.as_ref()) {
                    sharpest = Some(place);
                }
            }
            Ok(EdgeBend { least, greatest, sharpest })
        };
        self.curves.iter().enumerate().map(bend).collect()
    }

    /// The image under an affine map of the plane: control points are mapped, phases and smooth pairs stay. Under a map that mirrors, what was
    /// on the left of an edge is on its right.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for a map of another dimension, one that takes the plane to a line,
    /// an image that is not finite, and edges that come to meet by rounding, with the place.
    ///
    /// # Complexity
    /// That of an overlay of the edges.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::AffineMap;
    /// use coface_yin::{InterfaceEdge, InterfaceGraph, Order};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edge = InterfaceEdge { ends: [0, 0], markers: vec![[1.0, 0.0], [0.0, 1.0]], phases: [Some(0), None] };
    /// let graph = InterfaceGraph::new(&[[0.0, 0.0]], &[edge], &[], Order::LINEAR)?;
    /// let mirrored = graph.transformed(&AffineMap::scaling(&[-2.0, 2.0])?)?;
    /// assert_eq!(mirrored.phase_area(0)?, 2.0);
    /// # Ok(()) }
    /// ```
    pub fn transformed(&self, map: &AffineMap) -> Result<Self, Error> {
        if map.dimension() != 2 {
            return Err(Error::invalid(format!("the map is of dimension {}", map.dimension()))
                .with_cure("give a map of the plane: a matrix of two rows and two columns"));
        }
        let Some(sign) = map.determinant_sign() else {
            return Err(Error::invalid("the map takes the plane to a line or a point")
                .with_cure("give a matrix whose determinant is not zero"));
        };
        let curves: Vec<Curve<'static>> = self.curves.iter().map(|curve| curve.mapped(map)).collect();
        let mut vertices = self.vertices.clone();
        for (number, (curve, ends)) in curves.iter().zip(&self.ends).enumerate() {
            if curve.controls().iter().flatten().any(|x| !x.is_finite()) {
                return Err(Error::invalid(format!("the image of edge {number} is not finite"))
                    .with_cure("give a map with smaller numbers"));
            }
            // Bit for bit what the edges have.
            vertices[ends[0] as usize] = curve.knot_point(0);
            vertices[ends[1] as usize] = curve.knot_point(curve.piece_count());
        }
        let mut phases = self.phases.clone();
        if sign == Sign::Minus {
            phases.iter_mut().for_each(|sides| sides.reverse());
        }
        let image =
            Self::from_curves(&vertices, &self.ends, &phases, curves, &self.smooth_pairs, self.order)?;
        match image.fault()? {
            None => Ok(image),
            Some(fault) => Err(fault.into_error().with_cure("give a map that shrinks less")),
        }
    }
}
