//! Options of an arrangement in space.

use super::flat_polygons::NonPlanar;
use crate::near::CoordinatePrecision;

/// Options of an arrangement in space.
///
/// # Examples
/// ```
/// use coface_arrange::spatial::{NonPlanar, SpatialOptions};
/// let options = SpatialOptions::new().non_planar(NonPlanar::Refuse).merge_coplanar(true).max_cells(1_000_000);
/// assert_ne!(options, SpatialOptions::default());
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Default)]
#[non_exhaustive]
pub struct SpatialOptions {
    pub(super) non_planar: NonPlanar,
    pub(super) merge_coplanar: bool,
    pub(super) max_cells: Option<usize>,
    pub(super) tolerance: Option<f64>,
    pub(super) precision: CoordinatePrecision,
}

impl SpatialOptions {
    /// Splits polygons that are not planar, keeps the faces of different polygons apart, and has no bound on the
    /// number of cells.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::spatial::SpatialOptions;
    /// assert_eq!(SpatialOptions::new(), SpatialOptions::default());
    /// ```
    pub const fn new() -> Self {
        Self {
            non_planar: NonPlanar::Split,
            merge_coplanar: false,
            max_cells: None,
            tolerance: None,
            precision: CoordinatePrecision::Double,
        }
    }

    /// Does this with polygons whose points are not exactly in one plane.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::spatial::{NonPlanar, SpatialOptions};
    /// assert_ne!(SpatialOptions::new().non_planar(NonPlanar::Refuse), SpatialOptions::new());
    /// ```
    #[must_use]
    pub const fn non_planar(mut self, non_planar: NonPlanar) -> Self {
        self.non_planar = non_planar;
        self
    }

    /// Whether faces that are exactly in one plane and belong to the same inputs become one face where nothing else
    /// meets them, whatever polygons they come from. Vertices on the straight edges that remain are removed.
    ///
    /// # Examples
    /// Two triangles that make a square are two faces, or one:
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::{SpatialArrangement, SpatialOptions, SpatialPolygons};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 1., 1., 0., 0., 1., 0.])?;
    /// let polygons = SpatialPolygons::from_polygons(corners, RaggedArray::from_lists([[0, 1, 2], [0, 2, 3]]))?;
    /// let options = SpatialOptions::new();
    /// assert_eq!(SpatialArrangement::new(&polygons, &options)?.f_vector(), [4, 5, 2, 0]);
    /// assert_eq!(SpatialArrangement::new(&polygons, &options.merge_coplanar(true))?.f_vector(), [4, 4, 1, 0]);
    /// # Ok(()) }
    /// ```
    #[must_use]
    pub const fn merge_coplanar(mut self, merge_coplanar: bool) -> Self {
        self.merge_coplanar = merge_coplanar;
        self
    }

    /// Refuses more vertices, edges and faces together than this; pieces of polygons count one by one.
    ///
    /// # Examples
    /// A triangle has seven cells:
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::{SpatialArrangement, SpatialOptions, SpatialPolygons};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0.])?;
    /// let triangle = SpatialPolygons::from_polygons(corners, RaggedArray::from_lists([[0, 1, 2]]))?;
    /// assert!(SpatialArrangement::new(&triangle, &SpatialOptions::new().max_cells(7)).is_ok());
    /// assert!(SpatialArrangement::new(&triangle, &SpatialOptions::new().max_cells(6)).is_err());
    /// # Ok(()) }
    /// ```
    #[must_use]
    pub fn max_cells(mut self, most: impl Into<Option<usize>>) -> Self {
        self.max_cells = most.into();
        self
    }

    /// Puts planes, vertices, edges and faces together that are at most this far apart, before all is cut exactly; at
    /// least a few units of the last place of the largest coordinate.
    ///
    /// Planes come first: those that are near each other over the extent of their polygons are replaced by one.
    /// Then vertices are put to vertices, on edges and on faces, each by at most the tolerance, in an order that
    /// depends on where they are and not on their numbers. No point goes further than twice the tolerance in all; where
    /// features come near each other again and again, they are cut as they are, and
    /// [`JoinedFeatures::unsettled`](crate::JoinedFeatures::unsettled) counts the places.
    ///
    /// # Examples
    /// Two cubes with a gap of a thousandth between them have one wall in common:
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::{SpatialArrangement, SpatialOptions, SpatialPolygons};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let cube = |low: f64| {
    ///     let corner = |i: u32| [low + f64::from(i & 1), f64::from(i >> 1 & 1), f64::from(i >> 2)];
    ///     let positions = Positions::from_flat(3, (0..8).flat_map(corner).collect())?;
    ///     let squares = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    ///     SpatialPolygons::from_polygons(positions, RaggedArray::from_lists(squares))
    /// };
    /// let polygons = SpatialPolygons::joined(&[cube(0.0)?, cube(1.001)?])?;
    /// let options = SpatialOptions::new();
    /// assert_eq!(SpatialArrangement::new(&polygons, &options)?.f_vector(), [16, 24, 12, 2]);
    /// let joined = SpatialArrangement::new(&polygons, &options.tolerance(0.01))?;
    /// assert_eq!(joined.f_vector(), [12, 20, 11, 2]);
    /// # Ok(()) }
    /// ```
    #[must_use]
    pub fn tolerance(mut self, tolerance: impl Into<Option<f64>>) -> Self {
        self.tolerance = tolerance.into();
        self
    }

    /// Rounds to these numbers, where coordinates are rounded so that the result is valid: by
    /// [`SpatialArrangement::snapped`](super::SpatialArrangement::snapped), or within a tolerance.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::CoordinatePrecision;
    /// use coface_arrange::spatial::{SpatialArrangement, SpatialOptions, SpatialPolygons};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 0.1, 0., 0., 0., 0.1, 0.])?;
    /// let triangle = SpatialPolygons::from_polygons(corners, RaggedArray::from_lists([[0, 1, 2]]))?;
    /// let options = SpatialOptions::new().precision(CoordinatePrecision::Single);
    /// let snapped = SpatialArrangement::new(&triangle, &options)?.snapped(&options)?;
    /// assert_eq!(snapped.positions().as_flat()[3], f64::from(0.1f32));
    /// # Ok(()) }
    /// ```
    #[must_use]
    pub const fn precision(mut self, precision: CoordinatePrecision) -> Self {
        self.precision = precision;
        self
    }
}
