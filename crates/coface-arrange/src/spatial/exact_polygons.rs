//! Polygons in space that are known exactly, wherever their vertices are.

use super::wanted_parts::WantedParts;
use coface_algebra::{Error, ErrorKind, RaggedArray};
use coface_geometry::predicates::{PointDefinition, SpatialPlane, SpatialPoint, plane_axis};

/// Polygons in space whose vertices need not be floating-point numbers.
///
/// A polygon is made of **parts**, each cut out of a triangle with given corners. The outlines of a part run from vertex to
/// vertex; a **vertex** is a given point, or where lines and planes through given points meet. So polygons that were cut
/// out of others are known by the numbers that those had, and nothing was rounded.
///
/// # Conventions
/// A vertex is a list of numbers of points: `[a]` is that point, `[a, b, c, d]` where the lines $ab$ and $cd$ cross,
/// `[a, b, c, d, e]` where the line $ab$ meets the plane $cde$, and nine numbers are where three planes meet. Walks have the
/// part on their left, seen from where its triangle runs counterclockwise. A **shared** polygon has cells on both sides.
///
/// Polygons that are arranged have outlines along edges of their triangles, or where these meet each other: those of
/// [`SpatialArrangement::exact_polygons`](super::SpatialArrangement::exact_polygons) have.
///
/// # Examples
/// A triangle, without its corner beyond a line:
/// ```
/// use coface_arrange::spatial::{ExactPart, ExactPolygons};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let points = vec![[0., 0., 0.], [3., 0., 0.], [0., 3., 0.], [1., 0., 0.], [2., 3., 0.]];
/// // The line from (1, 0) to (2, 3) crosses the long side at (1.5, 1.5).
/// let vertices = [vec![0], vec![3], vec![3, 4, 1, 2], vec![2]];
/// let part = ExactPart { polygon: 0, triangle: [0, 1, 2], walks: vec![vec![0, 1, 2, 3]] };
/// let polygons = ExactPolygons::new(points, &vertices, vec![part], vec![false])?;
/// assert_eq!(polygons.vertex_points()[2].rounded(), [1.5, 1.5, 0.]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Default)]
pub struct ExactPolygons {
    points: Vec<[f64; 3]>,
    vertices: RaggedArray,
    parts: Vec<ExactPart>,
    is_shared: Vec<bool>,
}

/// A part of a triangle.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ExactPart {
    /// The polygon that it is part of.
    pub polygon: u32,
    /// The points at the corners of the triangle.
    pub triangle: [u32; 3],
    /// The vertices along its outlines.
    pub walks: Vec<Vec<u32>>,
}

impl ExactPart {
    /// The sides of the part, from vertex to vertex.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::spatial::ExactPart;
    /// let part = ExactPart { polygon: 0, triangle: [0, 1, 2], walks: vec![vec![5, 6, 7]] };
    /// assert_eq!(part.sides().collect::<Vec<_>>(), [[5, 6], [6, 7], [7, 5]]);
    /// ```
    pub fn sides(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        self.walks.iter().flat_map(|walk| {
            let next = walk.iter().cycle().skip(1);
            walk.iter().zip(next).map(|(&a, &b)| [a, b])
        })
    }
}

impl ExactPolygons {
    /// Polygons by their points, vertices and parts; for each polygon whether two cells share it.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] naming what is no vertex, no triangle, or not in the plane of its triangle, and points
    /// that are not finite; [`ErrorKind::NotInComplex`] naming points, vertices and polygons that are not there.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::spatial::{ExactPart, ExactPolygons};
    /// let points = vec![[0., 0., 0.], [3., 0., 0.], [0., 3., 0.], [0., 0., 9.]];
    /// let part = ExactPart { polygon: 0, triangle: [0, 1, 2], walks: vec![vec![0, 1, 2]] };
    /// let polygons = |vertices: &[Vec<u32>]| ExactPolygons::new(points.clone(), vertices, vec![part.clone()], vec![false]);
    /// assert!(polygons(&[vec![0], vec![1], vec![2]]).is_ok());
    /// // The last vertex is above the triangle.
    /// assert!(polygons(&[vec![0], vec![1], vec![3]]).is_err());
    /// ```
    pub fn new(
        points: Vec<[f64; 3]>,
        vertices: &[Vec<u32>],
        parts: Vec<ExactPart>,
        is_shared: Vec<bool>,
    ) -> Result<Self, Error> {
        if let Some(bad) = points.iter().position(|point| point.iter().any(|x| !x.is_finite())) {
            return Err(Error::invalid(format!("point {bad} has a coordinate that is not finite")));
        }
        let missing = |what: &str, number: u32| {
            Error::new(ErrorKind::NotInComplex, format!("{what} names {number}, which is not there"))
        };
        for (vertex, own) in vertices.iter().enumerate() {
            if !matches!(own.len(), 1 | 4 | 5 | 9) {
                return Err(Error::invalid(format!("vertex {vertex} is a list of {} points", own.len()))
                    .with_cure(
                        "give 1 point, 4 for two lines, 5 for a line and a plane, or 9 for three planes",
                    ));
            }
            if let Some(&bad) = own.iter().find(|&&point| point as usize >= points.len()) {
                return Err(missing(&format!("vertex {vertex}"), bad));
            }
        }
        let made = Self { vertices: RaggedArray::from_lists(vertices), points, parts, is_shared };
        let found: Vec<Option<SpatialPoint>> =
            (0..vertices.len()).map(|vertex| made.definition(vertex).point()).collect();
        if let Some(bad) = found.iter().position(Option::is_none) {
            return Err(Error::invalid(format!(
                "the lines and planes of vertex {bad} do not meet in one point"
            )));
        }
        for (number, part) in made.parts.iter().enumerate() {
            let name = || format!("part {number}");
            if part.polygon as usize >= made.is_shared.len() {
                return Err(missing(&name(), part.polygon));
            }
            if let Some(&bad) = part.triangle.iter().find(|&&point| point as usize >= made.points.len()) {
                return Err(missing(&name(), bad));
            }
            let plane = made.plane(part);
            if plane_axis(plane).1.is_eq() {
                return Err(Error::invalid(format!("the triangle of part {number} has no area")));
            }
            for &vertex in part.walks.iter().flatten() {
                let Some(point) = found.get(vertex as usize) else { return Err(missing(&name(), vertex)) };
                if point.is_none_or(|point| point.side_of(plane).is_ne()) {
                    return Err(Error::invalid(format!(
                        "vertex {vertex} is not in the plane of part {number}, which runs through it"
                    )));
                }
            }
        }
        Ok(made)
    }

    /// The polygons of parts that are known to be sound.
    pub(super) fn from_trusted_parts(
        points: Vec<[f64; 3]>,
        vertices: RaggedArray,
        parts: Vec<ExactPart>,
        is_shared: Vec<bool>,
    ) -> Self {
        Self { points, vertices, parts, is_shared }
    }

    /// The polygons that are wanted, on the same points. Those that are cut out of one triangle and share a side become one
    /// polygon, since the polygon that ended there may not be wanted: then nothing cuts the triangle at that side.
    ///
    /// # Panics
    /// Unless there is an entry for each polygon.
    ///
    /// # Complexity
    /// $O(n \log n)$ for n sides of parts.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::spatial::ExactPolygons;
    /// assert_eq!(ExactPolygons::default().with(&[]), ExactPolygons::default());
    /// ```
    #[must_use]
    pub fn with(&self, is_wanted: &[bool]) -> Self {
        assert_eq!(is_wanted.len(), self.is_shared.len(), "an entry for each polygon");
        if !is_wanted.contains(&false) {
            return self.clone();
        }
        WantedParts::new(self, is_wanted).polygons(self)
    }

    /// The given points.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::spatial::ExactPolygons;
    /// assert!(ExactPolygons::default().points().is_empty());
    /// ```
    pub fn points(&self) -> &[[f64; 3]] {
        &self.points
    }

    /// The points that each vertex is known by.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::spatial::ExactPolygons;
    /// assert!(ExactPolygons::default().vertices().is_empty());
    /// ```
    pub fn vertices(&self) -> &RaggedArray {
        &self.vertices
    }

    /// The parts of all polygons.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::spatial::ExactPolygons;
    /// assert!(ExactPolygons::default().parts().is_empty());
    /// ```
    pub fn parts(&self) -> &[ExactPart] {
        &self.parts
    }

    /// For each polygon whether two cells share it.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::spatial::ExactPolygons;
    /// assert_eq!(ExactPolygons::default().shared().len(), 0);
    /// ```
    pub fn shared(&self) -> &[bool] {
        &self.is_shared
    }

    /// The exact place of each vertex.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::spatial::ExactPolygons;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let polygons = ExactPolygons::new(vec![[1., 2., 3.]], &[vec![0]], vec![], vec![])?;
    /// assert_eq!(polygons.vertex_points()[0].rounded(), [1., 2., 3.]);
    /// # Ok(()) }
    /// ```
    pub fn vertex_points(&self) -> Vec<SpatialPoint> {
        let point = |vertex| self.definition(vertex).point().expect("vertices were checked");
        (0..self.vertices.len()).map(point).collect()
    }

    /// The corners of the triangle of a part.
    pub(super) fn plane(&self, part: &ExactPart) -> SpatialPlane {
        part.triangle.map(|point| self.points[point as usize])
    }

    pub(super) fn definition(&self, vertex: usize) -> PointDefinition {
        let at = |point: u32| self.points[point as usize];
        match *self.vertices.list(vertex) {
            [a] => PointDefinition::Given(at(a)),
            [a, b, c, d] => PointDefinition::Lines([[at(a), at(b)], [at(c), at(d)]]),
            [a, b, c, d, e] => PointDefinition::LineAndPlane([at(a), at(b)], [at(c), at(d), at(e)]),
            [a, b, c, d, e, f, g, h, i] => {
                PointDefinition::Planes([[a, b, c], [d, e, f], [g, h, i]].map(|plane| plane.map(at)))
            }
            _ => unreachable!("vertices are lists of 1, 4, 5 or 9 points"),
        }
    }
}
