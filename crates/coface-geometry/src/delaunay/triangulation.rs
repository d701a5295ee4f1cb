//! Regular triangulations.

use super::cells::{Cells, MOST_POINTS};
use super::order::insertion_order;
use super::space::Space;
use crate::Positions;
use crate::predicates::WeightedPoint;
use coface_algebra::progress::stage;
use coface_algebra::{Error, ErrorKind, RaggedArray, VertexId};

/// The Delaunay triangulation of points, or, if they have weights, their regular triangulation, exactly. Of points on one sphere one triangulation
/// of several is taken: the one that is left when each point is moved away by a little, those later in lexicographic order of coordinates by much more.
///
/// Points may lie on one line or in one plane, be equal, and be any in number. The triangulation does not depend on the order of the points, and moves with
/// them.
///
/// # Examples
/// The corners of a square and its middle: four triangles.
/// ```
/// use coface_geometry::{Positions, RegularTriangulation};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let points = Positions::from_flat(2, vec![0., 0., 2., 0., 2., 2., 0., 2., 1., 1.])?;
/// let triangulation = RegularTriangulation::new(&points, None)?;
/// assert_eq!((triangulation.dimension(), triangulation.cells().len()), (Some(2), 4));
/// assert!(triangulation.hidden().is_empty());
/// // The corners have more weight, which hides the middle.
/// let weighted = RegularTriangulation::new(&points, Some(&[3., 3., 3., 3., 0.]))?;
/// assert_eq!((weighted.cells().len(), weighted.hidden().len()), (2, 1));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct RegularTriangulation {
    cells: RaggedArray,
    hidden: Vec<VertexId>,
}

impl RegularTriangulation {
    /// The triangulation of points of one, two or three coordinates, with a weight for each point if there are weights: squared radii, which may be negative.
    ///
    /// Points are inserted one by one along a space-filling curve, each found by a walk from the one before.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] for points of more than three coordinates and unless there is one weight for each point;
    /// [`ErrorKind::InvalidInput`] naming a weight that is not finite; [`ErrorKind::TooLarge`] for more than 2^32 - 3 points.
    ///
    /// # Complexity
    /// $O(n \log n)$ for n points that are spread evenly, quadratic in space at worst, as the triangulation is then. Memory: some 300 bytes a point of
    /// space, 100 of the plane.
    ///
    /// # References
    /// H. Edelsbrunner, N. Shah, *Incremental topological flipping works for regular triangulations* (1996), for weights; N. Amenta, S. Choi, G. Rote,
    /// *Incremental constructions con BRIO* (2003), for the order; O. Devillers, M. Teillaud, *Perturbations for Delaunay and weighted Delaunay 3D
    /// triangulations* (2011), for points on one sphere.
    ///
    /// # Examples
    /// See [`RegularTriangulation`].
    pub fn new(points: &Positions, weights: Option<&[f64]>) -> Result<Self, Error> {
        let points = weighted_points(points, weights)?;
        let is_planar = points.iter().all(|point| point.point()[2] == 0.0);
        let order = insertion_order(&points, is_planar);
        let (space, spanning) = Space::new(order.iter().map(|&id| points[id as usize]).collect(), is_planar);
        let mut cells: Vec<u32> = match *spanning {
            [] => Vec::new(),
            [first] => vec![first],
            [a, b] => triangulated(&space, [a, b]),
            [a, b, c] => triangulated(&space, [a, b, c]),
            [a, b, c, d, ..] => triangulated(&space, [a, b, c, d]),
        };
        let mut is_hidden = vec![true; points.len()];
        for id in &mut cells {
            *id = order[*id as usize];
            is_hidden[*id as usize] = false;
        }
        let width = spanning.len().max(1);
        let mut rows: Vec<&mut [u32]> = cells.chunks_mut(width).collect();
        rows.iter_mut().for_each(|row| row.sort_unstable());
        rows.sort_unstable();
        let sorted = rows.into_iter().flat_map(|row| row.iter().copied()).collect();
        let hidden = (0..points.len()).filter(|&id| is_hidden[id]).map(VertexId::new).collect();
        Ok(Self { cells: RaggedArray::uniform(width, sorted)?, hidden })
    }

    /// The dimension of the flat that the points span; `None` if there is no point.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::{Positions, RegularTriangulation};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let on_a_line = Positions::from_flat(3, vec![0., 0., 0., 2., 2., 2., 1., 1., 1.])?;
    /// let triangulation = RegularTriangulation::new(&on_a_line, None)?;
    /// assert_eq!(triangulation.dimension(), Some(1));
    /// assert_eq!(triangulation.cells().iter().collect::<Vec<_>>(), [[0, 2], [1, 2]]);
    /// # Ok(()) }
    /// ```
    pub fn dimension(&self) -> Option<usize> {
        self.cells.iter().next().map(|cell| cell.len() - 1)
    }

    /// The cells: simplices of the highest dimension by their points, which rise, in lexicographic order.
    ///
    /// # Examples
    /// See [`RegularTriangulation`].
    pub fn cells(&self) -> &RaggedArray {
        &self.cells
    }

    /// The points in no cell, rising: each equals another one or is hidden by weights.
    ///
    /// # Examples
    /// See [`RegularTriangulation`].
    pub fn hidden(&self) -> &[VertexId] {
        &self.hidden
    }
}

/// Points with their weights, with zeros for the coordinates that they lack.
pub(super) fn weighted_points(
    points: &Positions,
    weights: Option<&[f64]>,
) -> Result<Vec<WeightedPoint>, Error> {
    let (dimension, count) = (points.dimension(), points.len());
    if dimension > 3 {
        return Err(Error::new(
            ErrorKind::Shape,
            format!("points of {dimension} coordinates have no triangulation here: it is made in dimension 1, 2 and 3"),
        )
        .with_cure("give points of at most three coordinates"));
    }
    if count > MOST_POINTS {
        return Err(Error::new(ErrorKind::TooLarge, format!("{count} points are too many")));
    }
    if let Some(weights) = weights {
        if weights.len() != count {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("{} weights for {count} points", weights.len()),
            )
            .with_cure("give one weight for each point"));
        }
        if let Some(bad) = weights.iter().position(|weight| !weight.is_finite()) {
            return Err(Error::invalid(format!("the weight of point {bad} is {}", weights[bad]))
                .with_cure("give finite weights"));
        }
    }
    let point = |id: usize| {
        let coordinates = points.point(VertexId::new(id));
        let along = |axis: usize| coordinates.get(axis).copied().unwrap_or(0.0);
        WeightedPoint::new([along(0), along(1), along(2)], weights.map_or(0.0, |weights| weights[id]))
    };
    Ok((0..count).map(point).collect())
}

/// The cells of all points of a flat, one after the other, from the corners of a first cell on.
fn triangulated<const N: usize>(space: &Space, first: [u32; N]) -> Vec<u32> {
    let mut cells = Cells::new(space, first);
    let count = space.points.len();
    let steps = stage("triangulating points", count);
    for id in steps.each(0..count as u32).filter(|id| !first.contains(id)) {
        cells.insert(id);
    }
    cells.bounded().flatten().collect()
}
