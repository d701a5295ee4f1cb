//! Arrangements whose vertices are exactly where their rounded coordinates say.

use super::settling::Drawing;
use super::{SpatialArrangement, SpatialOptions};
use crate::near::{CoordinatePrecision, least_tolerance};
use coface_algebra::{Error, FaceId, Sign, VertexId};

impl SpatialArrangement {
    /// Whether the rounded positions of all vertices are their exact ones: then the faces, read again as polygons with
    /// these positions, have the same arrangement.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::{SpatialArrangement, SpatialOptions, SpatialPolygons};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let polygons = SpatialPolygons::from_polygons(corners, sides)?;
    /// let tetrahedron = SpatialArrangement::new(&polygons, &SpatialOptions::new())?;
    /// assert!(tetrahedron.is_exactly_rounded());
    /// # Ok(()) }
    /// ```
    pub fn is_exactly_rounded(&self) -> bool {
        (0..self.cut.complex().vertex_count() as u32)
            .filter(|&fine| !self.is_omitted(fine))
            .all(|fine| self.is_exact(fine))
    }

    /// Whether the rounded coordinates of all drawn vertices are numbers of this precision.
    pub(super) fn is_held(&self, precision: CoordinatePrecision) -> bool {
        let is_held = |fine: usize| {
            let point = self.cut.positions().point(VertexId::new(fine));
            self.is_omitted(fine as u32) || point.iter().all(|&x| precision.holds(x))
        };
        precision == CoordinatePrecision::Double || (0..self.cut.complex().vertex_count()).all(is_held)
    }

    pub(super) fn is_exact(&self, fine: u32) -> bool {
        self.cut.point(VertexId::from_u32(fine)).is_exactly_rounded()
    }

    /// How many times coordinates were rounded; 0 if they were exact from the beginning, or are not exact.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::{SpatialArrangement, SpatialOptions, SpatialPolygons};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let polygons = SpatialPolygons::from_polygons(corners, sides)?;
    /// let tetrahedron = SpatialArrangement::new(&polygons, &SpatialOptions::new())?;
    /// assert_eq!(tetrahedron.snapped(&SpatialOptions::new())?.round_count(), 0);
    /// # Ok(()) }
    /// ```
    pub fn round_count(&self) -> usize {
        self.round_count
    }

    /// The arrangement of the faces drawn with rounded coordinates, where features that are nearly one become one, until
    /// all vertices are exact.
    ///
    /// Vertices, edges and faces a few units of the last place apart are put together, and what is left is arranged
    /// again; that is repeated with more units until no face goes through another. Faces bend by so much, and are
    /// still faces; straight edges have no more vertices than before. Polygons, inputs and their numbers are those of
    /// this arrangement. Thin cells may vanish; none is turned inside out. [`Self::joined`] says how far points moved.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if that does not come to an end; else as
    /// [`Self::new`].
    ///
    /// # References
    /// D. Halperin, E. Packer, *Iterated snap rounding* (2002), for the plane.
    ///
    /// # Examples
    /// A tetrahedron cut by a triangle, at heights that are not binary fractions.
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::{SpatialArrangement, SpatialOptions, SpatialPolygons};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let tetrahedron = [0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.];
    /// let triangle = [-1., -1., 0.1, 5., -1., 0.2, -1., 5., 0.3];
    /// let positions = Positions::from_flat(3, [&tetrahedron[..], &triangle].concat())?;
    /// let lists = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2], [4, 5, 6]]);
    /// let polygons = SpatialPolygons::from_polygons(positions, lists)?.with_inputs(vec![0, 0, 0, 0, 1])?;
    /// let options = SpatialOptions::default();
    /// let arrangement = SpatialArrangement::new(&polygons, &options)?;
    /// let snapped = arrangement.snapped(&options)?;
    /// assert!(!arrangement.is_exactly_rounded() && snapped.is_exactly_rounded());
    /// assert!(snapped.round_count() > 0);
    /// assert_eq!(snapped.f_vector(), arrangement.f_vector());
    /// # Ok(()) }
    /// ```
    pub fn snapped(&self, options: &SpatialOptions) -> Result<Self, Error> {
        if self.is_exactly_rounded() && self.is_held(options.precision) {
            return Ok(self.clone());
        }
        let tolerance = least_tolerance(self.cut.positions().as_flat().as_chunks::<3>().0, options.precision);
        let drawing = Drawing::of(self, tolerance, options.precision)?;
        let settled = drawing.settled(options, tolerance, true)?;
        Ok(settled.with_notes_of(self))
    }

    /// The same for some faces alone, which have one more input in the end: a polygon of all of them, with their fronts where
    /// the signs say. A surface around some cells takes less than the whole arrangement.
    ///
    /// # Errors
    /// As [`Self::snapped`].
    ///
    /// # Examples
    /// A tetrahedron that a triangle cuts in two, without the triangle:
    /// ```
    /// use coface_algebra::{FaceId, RaggedArray, Sign};
    /// use coface_arrange::spatial::{SpatialArrangement, SpatialOptions, SpatialPolygons};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let tetrahedron = [0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.];
    /// let triangle = [-1., -1., 0.1, 5., -1., 0.2, -1., 5., 0.3];
    /// let positions = Positions::from_flat(3, [&tetrahedron[..], &triangle].concat())?;
    /// let lists = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2], [4, 5, 6]]);
    /// let polygons = SpatialPolygons::from_polygons(positions, lists)?.with_inputs(vec![0, 0, 0, 0, 1])?;
    /// let options = SpatialOptions::default();
    /// let arrangement = SpatialArrangement::new(&polygons, &options)?;
    /// let of_first = |face: usize| arrangement.polygons_of_face(FaceId::new(face)).iter().all(|own| own.0 < 4);
    /// let surface: Vec<_> = (0..arrangement.complex().face_count())
    ///     .filter(|&face| of_first(face))
    ///     .map(|face| (FaceId::new(face), Sign::Plus))
    ///     .collect();
    /// let snapped = arrangement.snapped_surface(&surface, &options)?;
    /// // The two halves of the tetrahedron are one, and what was the triangle's is gone.
    /// assert!(snapped.is_exactly_rounded());
    /// assert_eq!((arrangement.fine().cell_count(), snapped.fine().cell_count()), (2, 1));
    /// # Ok(()) }
    /// ```
    pub fn snapped_surface(
        &self,
        surface: &[(FaceId, Sign)],
        options: &SpatialOptions,
    ) -> Result<Self, Error> {
        let tolerance = least_tolerance(self.cut.positions().as_flat().as_chunks::<3>().0, options.precision);
        let drawing = Drawing::of_surface(self, surface, tolerance, options.precision)?;
        let settled = drawing.settled(options, tolerance, true)?;
        Ok(settled.with_notes_of(self))
    }
}
