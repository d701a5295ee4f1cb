//! Arrangements whose vertices are exactly where their rounded coordinates say.

use super::patches::Patches;
use super::{SpatialArrangement, SpatialOptions};
use coface_algebra::RaggedArray;
use coface_algebra::{Error, FaceId, VertexId};

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

    fn is_exact(&self, fine: u32) -> bool {
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

    /// The arrangement of the faces drawn with rounded coordinates, rounded and arranged again until all vertices are
    /// exact.
    ///
    /// Faces with a vertex that moves fall into triangles; others stay polygons. Polygons, inputs and their numbers are
    /// those of this arrangement; of coplanar faces that were merged, the polygons of the first are reported. The cells
    /// mean the same as long as rounding turns nothing inside out; thin ones may vanish.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if that does not come to an end within
    /// fifty rounds; else as [`Self::new`].
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
    /// assert_eq!(snapped.f_vector()[3], 2);
    /// # Ok(()) }
    /// ```
    pub fn snapped(&self, options: &SpatialOptions) -> Result<Self, Error> {
        const MOST_ROUNDS: usize = 50;
        let mut snapped = self.clone();
        for round in 1..=MOST_ROUNDS {
            if snapped.is_exactly_rounded() {
                return Ok(snapped);
            }
            snapped = snapped.next_round(options)?.with_notes_of(self, round);
        }
        if snapped.is_exactly_rounded() {
            return Ok(snapped);
        }
        Err(Error::invalid(format!(
            "rounding moves faces through each other again and again: {MOST_ROUNDS} rounds are not enough"
        ))
        .with_cure("scale the model up, or remove polygons that nearly coincide"))
    }

    fn next_round(&self, options: &SpatialOptions) -> Result<Self, Error> {
        let drawn = self.drawn_triangles()?;
        let is_exact: Vec<bool> =
            (0..self.cut.complex().vertex_count() as u32).map(|fine| self.is_exact(fine)).collect();
        let mut patch_of_triangle = Vec::with_capacity(drawn.triangles.len());
        let (mut polygons_of_patch, mut packed) = (RaggedArray::new(), Vec::new());
        let lists = drawn.triangles.iter().zip(&drawn.face_of_triangle).collect::<Vec<_>>();
        for own in lists.chunk_by(|x, y| x.1 == y.1) {
            let face = FaceId::from_u32(*own[0].1);
            // Of faces that were merged each has as many polygons of each input as all others.
            let first = self.patches_of_face.list(self.first_fine_face(face).index());
            packed.clear();
            self.patches.for_each_polygon(first, |polygon| packed.push(polygon));
            let fold = self.patches.fold(first);
            let stays = fold.is_none() && own.iter().all(|(t, _)| t.iter().all(|&v| is_exact[v as usize]));
            for i in 0..own.len() {
                if i == 0 || !stays {
                    polygons_of_patch.push(&packed);
                }
                patch_of_triangle.push(polygons_of_patch.len() as u32 - 1);
            }
        }
        let patches = Patches {
            patch_of_triangle,
            folded: Vec::new(),
            polygons_of_patch: Some(polygons_of_patch),
            input_of_polygon: self.patches.input_of_polygon.clone(),
            input_count: self.patches.input_count,
        };
        Self::of_triangles(self.cut.positions(), &drawn.triangles, patches, options)
    }
}
