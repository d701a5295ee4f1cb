//! The arrangement of polygons in space.

use super::axis_view::AxisView;
use super::cells::{CellParts, SpatialCells};
use super::cutting::{CutOptions, CutTriangles, PartOutlines};
use super::flat_polygons::{NonPlanar, PolygonTriangles, SplitPolygon};
use super::merging::{Merged, merge};
use super::near::{flat_faces, flattened};
use super::patches::{Patches, SameOrigin};
use super::polygons::SpatialPolygons;
use super::predicates::SpatialPredicates;
use super::settling::Drawing;
use super::{PolygonalComplex, SpatialOptions};
use crate::near::{JoinedFeatures, least_tolerance};
use coface_algebra::chains::{ChainComplex, ChainMap};
use coface_algebra::progress::stage;
use coface_algebra::{CellId, EdgeId, Error, FaceId, VertexId};
use coface_algebra::{RaggedArray, Sign, SparseMatrix};
use coface_geometry::Positions;
use coface_geometry::predicates::{SpatialPoint, are_coplanar, plane_axis};
use std::cmp::Ordering;
use std::sync::Arc;

/// The vertices, edges, faces and cells that polygons cut space into, exactly.
///
/// Polygons may cross, touch, overlap in a plane and be there twice. A face is a part of a plane that no polygon
/// crosses, with holes and slits where need be, and knows the polygons that it is part of. A cell is a bounded
/// connected part of space without the faces; it can have voids. No tolerance is in any decision; coordinates of new
/// vertices are rounded once, for output.
///
/// # Conventions
/// Vertices are the points of the input that polygons run through, by their first occurrences, then new ones. Edges
/// point from their lower to their higher vertex and rise by them. Faces are in the order of the first polygons, and
/// run as these do: the front of a face is where the outer walk runs counterclockwise. A face has coefficient 1 in the
/// boundary of the cell behind it.
///
/// The **fine** cells are those before pieces of one polygon are put together: polygons are triangulated first. Each
/// vertex is a fine vertex, each edge a path of fine edges, each face a sum of fine faces. Cells are the same in both.
///
/// # Examples
/// A cube, and the same moved by one half along all axes:
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_arrange::spatial::{SpatialArrangement, SpatialOptions, SpatialPolygons};
/// use coface_geometry::Positions;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let cube = |low: f64| {
///     let corner = |i: usize| (0..3).map(move |axis| low + f64::from(i as u32 >> axis & 1));
///     let positions = Positions::from_flat(3, (0..8).flat_map(corner).collect())?;
///     let squares =
///         [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
///     SpatialPolygons::from_polygons(positions, RaggedArray::from_lists(squares))
/// };
/// let polygons = SpatialPolygons::joined(&[cube(0.0)?, cube(0.5)?])?;
/// let arrangement = SpatialArrangement::new(&polygons, &SpatialOptions::default())?;
/// assert_eq!(arrangement.f_vector(), [22, 36, 18, 3]);
/// assert_eq!(arrangement.volumes()?, [0.875, 0.125, 0.875]);
/// assert_eq!(arrangement.inside(Default::default())?, [vec![0], vec![0, 1], vec![1]]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct SpatialArrangement {
    pub(super) cut: CutTriangles,
    pub(super) cells: SpatialCells,
    /// `None` when the fine cells are the cells.
    pub(super) merged: Option<Merged>,
    pub(super) patches: Patches,
    pub(super) patches_of_face: RaggedArray,
    /// Fine vertices on straight edges, where they are not needed to draw anything.
    pub(super) is_omitted: Vec<bool>,
    positions: Option<Positions>,
    without_area: Vec<u32>,
    split: Vec<SplitPolygon>,
    pub(super) round_count: usize,
    /// What was put together, where features that are near each other were.
    pub(super) joined: Option<JoinedFeatures>,
    /// The outlines of triangles that are there in part.
    outlines: Option<Arc<PartOutlines>>,
    pub(super) options: SpatialOptions,
}

impl SpatialArrangement {
    /// The arrangement of polygons.
    ///
    /// # Errors
    /// [`InvalidInput`](coface_algebra::ErrorKind::InvalidInput) naming the first polygon whose sides cross or touch
    /// elsewhere than in vertices, with the place, or which is not planar when that is refused, with the distance;
    /// [`TooLarge`](coface_algebra::ErrorKind::TooLarge) when there would be more cells than the options allow, with
    /// the count so far.
    ///
    /// # Complexity
    /// $O((n + k) \log (n + k))$ for n sides and k fine cells where boxes that meet are not many more than polygons
    /// that do.
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
    /// assert_eq!(tetrahedron.f_vector(), [4, 6, 4, 1]);
    /// # Ok(()) }
    /// ```
    pub fn new(polygons: &SpatialPolygons, options: &SpatialOptions) -> Result<Self, Error> {
        let Some(tolerance) = options.tolerance else {
            let mut made = Made::new(polygons, options.non_planar)?;
            let extended = made.add_exact(polygons)?;
            let (positions, outlines) = match extended {
                None => (polygons.positions(), None),
                Some((ref positions, ref outlines)) => (positions, Some(Arc::clone(outlines))),
            };
            let found = Self::of_triangles(positions, &made.triangles, made.patches, outlines, options)?;
            return Ok(Self { without_area: made.without_area, split: made.split, ..found });
        };
        if options.non_planar != NonPlanar::Split {
            polygons.check(options.non_planar)?;
        }
        let first = polygons.positions().as_flat().as_chunks::<3>().0.to_vec();
        let tolerance = tolerance.max(least_tolerance(&first, options.precision));
        let (mut points, fitted) = flattened(polygons, tolerance);
        points.iter_mut().for_each(|point| *point = options.precision.rounded_point(*point));
        let flat = polygons.clone().with_points(&points)?;
        // Where a polygon is narrower than the tolerance its sides may cross now.
        let mut made = Made::of(&flat, PolygonTriangles::of_moved(&flat, polygons)?);
        made.join_faces(&flat_faces(polygons, tolerance));
        let drawing = Drawing::new(first, points, made.triangles, made.patches);
        let mut found = drawing.settled(options, tolerance, false)?;
        if let Some(joined) = &mut found.joined {
            joined.counts.planes = fitted;
        }
        Ok(Self { without_area: made.without_area, split: made.split, ..found })
    }

    /// What was put together, where that was asked for: by a tolerance, or by [`Self::snapped`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::{SpatialArrangement, SpatialOptions, SpatialPolygons};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two triangles on one edge, but for a thousandth.
    /// let corners = vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 1.001, 0., 0., 0., 1., 0.001, 1., 1., 5.];
    /// let corners = Positions::from_flat(3, corners)?;
    /// let polygons = SpatialPolygons::from_polygons(corners, RaggedArray::from_lists([[0, 1, 2], [3, 5, 4]]))?;
    /// let options = SpatialOptions::new();
    /// assert_eq!(SpatialArrangement::new(&polygons, &options)?.f_vector()[..3], [6, 6, 2]);
    /// let joined = SpatialArrangement::new(&polygons, &options.tolerance(0.01))?;
    /// assert_eq!(joined.f_vector()[..3], [4, 5, 2]);
    /// let joined = joined.joined().ok_or_else(|| coface_algebra::Error::invalid("nothing"))?;
    /// assert_eq!(joined.counts.vertices, 2);
    /// assert!((joined.largest_movement - 0.001).abs() < 1e-12);
    /// # Ok(()) }
    /// ```
    pub fn joined(&self) -> Option<&JoinedFeatures> {
        self.joined.as_ref()
    }

    pub(super) fn of_triangles(
        positions: &Positions,
        triangles: &[[u32; 3]],
        mut patches: Patches,
        outlines: Option<Arc<PartOutlines>>,
        options: &SpatialOptions,
    ) -> Result<Self, Error> {
        let mut cut =
            CutTriangles::new(positions, triangles, &CutOptions::new().max_cells(options.max_cells))?;
        if let Some(outlines) = &outlines {
            cut = cut.within(outlines)?;
        }
        let predicates = cut.predicates();
        let steps = stage("sorting faces around edges", cut.complex().edge_count());
        let (ordered, patches_of_face) =
            rayon::join(|| cut.ordered_faces(&predicates, &steps), || patches.of_faces(&cut));
        drop(steps);
        let ordered = ordered?;
        patches.tear(&cut, &patches_of_face);
        let around = ordered.around();
        let steps = stage("finding and merging cells", cut.complex().edge_count());
        let (parts, merged) = rayon::join(
            || CellParts::new(&ordered, &predicates, &steps),
            || {
                let of_face = &patches_of_face;
                let rules =
                    SameOrigin::new(&cut, &predicates, &patches, of_face, around, options.merge_coplanar);
                merge(cut.complex(), around, &rules, &steps)
            },
        );
        drop(steps);
        let parts = parts?;
        let mut is_omitted = Vec::new();
        let mut coarse_positions = None;
        if let Some(merged) = &merged {
            is_omitted =
                omitted_vertices(merged, cut.complex(), &patches, &patches_of_face, around, &predicates);
            let point = |&vertex: &u32| cut.positions().point(VertexId::from_u32(vertex)).iter().copied();
            coarse_positions =
                Some(Positions::from_flat(3, merged.vertices.iter().flat_map(point).collect())?);
        }
        drop(predicates);
        let cells = SpatialCells::from_parts(ordered, parts);
        Ok(Self {
            cut,
            cells,
            merged,
            patches,
            patches_of_face,
            is_omitted,
            positions: coarse_positions,
            without_area: Vec::new(),
            split: Vec::new(),
            round_count: 0,
            joined: None,
            outlines,
            options: *options,
        })
    }

    /// The arrangement of the same triangles and of rectangles, which are polygons after all others, of an input of their
    /// own.
    pub(super) fn with_cuts(&self, cuts: &[[[f64; 3]; 4]]) -> Result<Self, Error> {
        let (mut points, mut triangles) = self.cut.input(self.patches.patch_of_triangle.len());
        let mut patches = self.patches.clone();
        patches.keeps_vertices = true;
        for corners in cuts {
            let first = points.len() as u32;
            points.extend(corners);
            triangles.extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
            let polygon = patches.input_of_polygon.len() as u32;
            patches.input_of_polygon.push(self.patches.input_count as u32);
            let patch = match &mut patches.polygons_of_patch {
                None => polygon,
                Some(lists) => {
                    lists.push(&[2 * polygon]);
                    lists.len() as u32 - 1
                }
            };
            patches.patch_of_triangle.extend([patch; 2]);
        }
        patches.input_count += 1;
        let positions = Positions::from_flat(3, points.into_flattened())?;
        Self::of_triangles(&positions, &triangles, patches, self.outlines.clone(), &self.options)
    }

    /// Whether all polygons that a fine face is part of have this number or a higher one.
    pub(super) fn fine_face_is_from(&self, fine: u32, first_polygon: usize) -> bool {
        let mut is_from = true;
        self.patches.for_each_polygon(self.patches_of_face.list(fine as usize), |polygon| {
            is_from &= (polygon >> 1) as usize >= first_polygon;
        });
        is_from
    }

    /// Whether two faces on the two sides of an edge would be one without polygons from this number on.
    pub(super) fn are_one_without(&self, faces: [u32; 2], first_polygon: usize) -> bool {
        let fine = faces.map(|face| self.first_fine_face(FaceId::from_u32(face)));
        let before = |face: FaceId| -> Vec<u32> {
            let own = self.patches_of_face.list(face.index()).iter();
            let is_before = |patch: &&u32| {
                let mut is_before = true;
                self.patches.for_each_polygon(std::slice::from_ref(*patch), |polygon| {
                    is_before &= ((polygon >> 1) as usize) < first_polygon;
                });
                is_before
            };
            own.filter(is_before).copied().collect()
        };
        let [x, y] = fine.map(before);
        let [f, g] = fine.map(|face| self.cut.plane(face));
        if x == y {
            return !self.patches.are_torn(&x) || are_coplanar(f, g);
        }
        self.options.merge_coplanar
            && self.patches.have_same_inputs(&x, &y, Sign::Plus)
            && self.patches.fold(&x).is_none()
            && self.patches.fold(&y).is_none()
            && are_coplanar(f, g)
    }

    /// The numbers of vertices, edges, faces and bounded cells.
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
    /// assert_eq!(tetrahedron.f_vector(), [4, 6, 4, 1]);
    /// # Ok(()) }
    /// ```
    pub fn f_vector(&self) -> Vec<usize> {
        let mut counts = self.complex().f_vector();
        counts.push(self.cells.cell_count());
        counts
    }

    /// The vertices, edges and faces.
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
    /// assert_eq!(tetrahedron.complex().face_count(), 4);
    /// # Ok(()) }
    /// ```
    pub fn complex(&self) -> &PolygonalComplex {
        self.merged.as_ref().map_or(self.cut.complex(), |merged| &merged.complex)
    }

    /// The positions of the vertices: each coordinate is the floating-point number nearest to the exact one.
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
    /// assert_eq!(tetrahedron.positions().len(), 4);
    /// # Ok(()) }
    /// ```
    pub fn positions(&self) -> &Positions {
        self.positions.as_ref().unwrap_or_else(|| self.cut.positions())
    }

    /// The exact position of a vertex.
    ///
    /// # Panics
    /// If there is no such vertex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{RaggedArray, VertexId};
    /// use coface_arrange::spatial::{SpatialArrangement, SpatialOptions, SpatialPolygons};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let polygons = SpatialPolygons::from_polygons(corners, sides)?;
    /// let tetrahedron = SpatialArrangement::new(&polygons, &SpatialOptions::new())?;
    /// assert!(tetrahedron.point(VertexId::new(0)).is_exactly_rounded());
    /// # Ok(()) }
    /// ```
    pub fn point(&self, vertex: VertexId) -> SpatialPoint {
        self.cut.point(self.fine_vertex(vertex))
    }

    /// The cells before pieces of polygons are put together.
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
    /// assert_eq!(tetrahedron.fine().cell_count(), 1);
    /// # Ok(()) }
    /// ```
    pub fn fine(&self) -> &SpatialCells {
        &self.cells
    }

    /// The triangles that polygons were cut into, cut against each other: the fine vertices, edges and faces with what
    /// they come from. Its triangles are those of the polygons in order, without those that have no area.
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
    /// assert_eq!(tetrahedron.fine_triangles().complex().face_count(), 4);
    /// # Ok(()) }
    /// ```
    pub fn fine_triangles(&self) -> &CutTriangles {
        &self.cut
    }

    /// The fine vertex that a vertex is.
    ///
    /// # Panics
    /// If there is no such vertex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{RaggedArray, VertexId};
    /// use coface_arrange::spatial::{SpatialArrangement, SpatialOptions, SpatialPolygons};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let polygons = SpatialPolygons::from_polygons(corners, sides)?;
    /// let tetrahedron = SpatialArrangement::new(&polygons, &SpatialOptions::new())?;
    /// // Nothing was merged.
    /// assert_eq!(tetrahedron.fine_vertex(VertexId::new(3)), VertexId::new(3));
    /// # Ok(()) }
    /// ```
    pub fn fine_vertex(&self, vertex: VertexId) -> VertexId {
        match &self.merged {
            None => vertex,
            Some(merged) => VertexId::from_u32(merged.vertices[vertex.index()]),
        }
    }

    /// The vertex that a fine vertex is, if it is one.
    pub(super) fn vertex_of_fine(&self, fine: u32) -> Option<u32> {
        match &self.merged {
            None => Some(fine),
            Some(merged) => merged.vertices.binary_search(&fine).ok().map(|vertex| vertex as u32),
        }
    }

    /// The fine faces that a face is the sum of, rising; minus for those whose fronts are its back.
    ///
    /// # Panics
    /// If there is no such face.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{FaceId, RaggedArray, Sign};
    /// use coface_arrange::spatial::{SpatialArrangement, SpatialOptions, SpatialPolygons};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let polygons = SpatialPolygons::from_polygons(corners, sides)?;
    /// let tetrahedron = SpatialArrangement::new(&polygons, &SpatialOptions::new())?;
    /// assert!(tetrahedron.fine_faces(FaceId::new(2)).eq([(FaceId::new(2), Sign::Plus)]));
    /// # Ok(()) }
    /// ```
    pub fn fine_faces(&self, face: FaceId) -> impl Iterator<Item = (FaceId, Sign)> + '_ {
        let single = self.merged.is_none().then_some(2 * face.to_u32());
        let list = self.merged.as_ref().map_or(&[][..], |merged| merged.faces.list(face.index()));
        list.iter().copied().chain(single).map(unpacked)
    }

    /// The fine edges along an edge, from its first to its last; minus for those that run against it.
    ///
    /// # Panics
    /// If there is no such edge.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{EdgeId, RaggedArray, Sign};
    /// use coface_arrange::spatial::{SpatialArrangement, SpatialOptions, SpatialPolygons};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let polygons = SpatialPolygons::from_polygons(corners, sides)?;
    /// let tetrahedron = SpatialArrangement::new(&polygons, &SpatialOptions::new())?;
    /// assert!(tetrahedron.fine_edges(EdgeId::new(2)).eq([(EdgeId::new(2), Sign::Plus)]));
    /// # Ok(()) }
    /// ```
    pub fn fine_edges(&self, edge: EdgeId) -> impl Iterator<Item = (EdgeId, Sign)> + '_ {
        let single = self.merged.is_none().then_some(2 * edge.to_u32());
        let list = self.merged.as_ref().map_or(&[][..], |merged| merged.edges.list(edge.index()));
        list.iter().copied().chain(single).map(|packed| (EdgeId::from_u32(packed >> 1), sign_of_bit(packed)))
    }

    /// The chain map that sends each cell to the sum of the fine cells that it is made of.
    ///
    /// # Errors
    /// [`TooLarge`](coface_algebra::ErrorKind::TooLarge) beyond 2^32 - 1 entries in a matrix.
    ///
    /// # Examples
    /// A square, of two triangles:
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::spatial::{SpatialArrangement, SpatialOptions, SpatialPolygons};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 1., 1., 0., 0., 1., 0.])?;
    /// let square = SpatialPolygons::from_polygons(corners, RaggedArray::from_lists([[0, 1, 2, 3]]))?;
    /// let arrangement = SpatialArrangement::new(&square, &SpatialOptions::default())?;
    /// assert_eq!((arrangement.f_vector(), arrangement.fine().complex().f_vector()), (vec![4, 4, 1, 0], vec![4, 5, 2]));
    /// assert_eq!(arrangement.chain_map_to_fine()?.matrix(2).map(|m| m.entries().to_vec()), Some(vec![1, 1]));
    /// # Ok(()) }
    /// ```
    pub fn chain_map_to_fine(&self) -> Result<ChainMap, Error> {
        let complex = self.complex();
        let (vertices, edges, faces) = (complex.vertex_count(), complex.edge_count(), complex.face_count());
        let cells = self.cells.cell_count();
        let fine = self.cells.chain_complex()?;
        let unit = |row: usize, column: usize, sign: Sign| (row, column, i64::from(sign.to_i32()));
        let vertex = |i: usize| unit(self.fine_vertex(VertexId::new(i)).index(), i, Sign::Plus);
        let edge =
            |i: usize| self.fine_edges(EdgeId::new(i)).map(move |(fine, sign)| unit(fine.index(), i, sign));
        let face =
            |i: usize| self.fine_faces(FaceId::new(i)).map(move |(fine, sign)| unit(fine.index(), i, sign));
        let matrices = vec![
            SparseMatrix::from_entries(fine.cell_count(0), vertices, (0..vertices).map(vertex))?,
            SparseMatrix::from_entries(fine.cell_count(1), edges, (0..edges).flat_map(edge))?,
            SparseMatrix::from_entries(fine.cell_count(2), faces, (0..faces).flat_map(face))?,
            SparseMatrix::from_entries(cells, cells, (0..cells).map(|i| unit(i, i, Sign::Plus)))?,
        ];
        ChainMap::new(&self.coarse_complex()?, &fine, matrices)
    }

    /// The first fine face of a face; it has the same front.
    pub(super) fn first_fine_face(&self, face: FaceId) -> FaceId {
        self.merged.as_ref().map_or(face, |merged| FaceId::from_u32(merged.faces.list(face.index())[0] >> 1))
    }

    /// The polygons that a face is part of, rising; minus for those whose fronts are its back. Polygons that overlap
    /// share faces; a face that coplanar ones were merged to has the polygons of all of them.
    ///
    /// # Panics
    /// If there is no such face.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{FaceId, RaggedArray, Sign};
    /// use coface_arrange::spatial::{SpatialArrangement, SpatialOptions, SpatialPolygons};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let polygons = SpatialPolygons::from_polygons(corners, sides)?;
    /// let tetrahedron = SpatialArrangement::new(&polygons, &SpatialOptions::new())?;
    /// assert_eq!(tetrahedron.polygons_of_face(FaceId::new(1)), [(1, Sign::Plus)]);
    /// # Ok(()) }
    /// ```
    pub fn polygons_of_face(&self, face: FaceId) -> Vec<(u32, Sign)> {
        let mut packed = Vec::new();
        for (fine, sign) in self.fine_faces(face) {
            let turned = u32::from(sign == Sign::Minus);
            self.patches.for_each_polygon(self.patches_of_face.list(fine.index()), |polygon| {
                if self.patches.surface != Some(polygon >> 1) {
                    packed.push(polygon ^ turned);
                }
            });
        }
        packed.sort_unstable();
        packed.dedup();
        packed.into_iter().map(|polygon| (polygon >> 1, sign_of_bit(polygon))).collect()
    }

    /// The cell at the back of a face (plus) or at its front (minus); `None` for the exterior.
    ///
    /// # Panics
    /// If there is no such face.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, FaceId, RaggedArray, Sign};
    /// use coface_arrange::spatial::{SpatialArrangement, SpatialOptions, SpatialPolygons};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(3, vec![0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.])?;
    /// let sides = RaggedArray::from_lists([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    /// let polygons = SpatialPolygons::from_polygons(corners, sides)?;
    /// let tetrahedron = SpatialArrangement::new(&polygons, &SpatialOptions::new())?;
    /// assert_eq!(tetrahedron.cell_at(FaceId::new(0), Sign::Plus), Some(CellId::new(0)));
    /// assert_eq!(tetrahedron.cell_at(FaceId::new(0), Sign::Minus), None);
    /// # Ok(()) }
    /// ```
    pub fn cell_at(&self, face: FaceId, side: Sign) -> Option<CellId> {
        self.cells.cell_at(self.first_fine_face(face), side)
    }

    /// The faces with the same cell, or the exterior, on both sides, rising.
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
    /// assert_eq!(tetrahedron.dangling_faces().count(), 0);
    /// # Ok(()) }
    /// ```
    pub fn dangling_faces(&self) -> impl Iterator<Item = FaceId> + '_ {
        (0..self.complex().face_count())
            .map(FaceId::new)
            .filter(|&face| self.cell_at(face, Sign::Plus) == self.cell_at(face, Sign::Minus))
    }

    /// The boundary matrix of the cells: rows are faces, columns cells.
    ///
    /// # Errors
    /// [`TooLarge`](coface_algebra::ErrorKind::TooLarge) beyond 2^32 - 1 entries.
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
    /// assert_eq!(tetrahedron.cell_boundaries()?.column(0).entries(), [1; 4]);
    /// # Ok(()) }
    /// ```
    pub fn cell_boundaries(&self) -> Result<SparseMatrix, Error> {
        let Some(merged) = &self.merged else { return self.cells.cell_boundaries() };
        let faces = (0..merged.faces.len()).map(FaceId::new);
        let entries = faces.flat_map(|face| {
            let [back, front] = [Sign::Plus, Sign::Minus].map(|side| self.cell_at(face, side));
            let entry = move |cell: Option<CellId>, sign: i64| {
                cell.filter(|_| back != front).map(|cell| (face.index(), cell.index(), sign))
            };
            [entry(back, 1), entry(front, -1)].into_iter().flatten()
        });
        SparseMatrix::from_entries(merged.faces.len(), self.cells.cell_count(), entries)
    }

    /// Vertices, edges, faces and cells as they are, without the exterior: the boundary matrices are the transposes of
    /// EV, FE and CF. The product of two of them one after the other is zero. With holes, voids or tunnels the homology is not that
    /// of the space: see [`Self::chain_complex`].
    ///
    /// # Errors
    /// [`TooLarge`](coface_algebra::ErrorKind::TooLarge) beyond 2^32 - 1 entries in a matrix.
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
    /// assert_eq!(tetrahedron.coarse_complex()?.f_vector(), [4, 6, 4, 1]);
    /// # Ok(()) }
    /// ```
    pub fn coarse_complex(&self) -> Result<ChainComplex, Error> {
        let complex = self.complex();
        let (faces, (edges, cells)) =
            rayon::join(|| complex.face_boundaries(), || (complex.edge_boundaries(), self.cell_boundaries()));
        Ok(ChainComplex::from_trusted_boundaries(vec![edges?, faces?, cells?]))
    }

    /// The chain complex of vertices, edges, faces and cells, without the exterior, refined until each cell is a ball: faces with
    /// holes are cut into triangles, bridges join what is apart, and cells with tunnels are cut. Its homology is that of
    /// the union of all faces and bounded cells. [`Self::ball_complex`] says what is a piece of what.
    ///
    /// # Errors
    /// Those of [`Self::ball_complex`].
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
    /// assert_eq!(tetrahedron.chain_complex()?.f_vector(), [4, 6, 4, 1]);
    /// # Ok(()) }
    /// ```
    pub fn chain_complex(&self) -> Result<ChainComplex, Error> {
        Ok(self.ball_complex()?.into_parts().0)
    }

    /// The volume of each cell, without its voids, in the cube of the unit of the positions, rounded.
    ///
    /// # Errors
    /// As [`SpatialCells::volumes`].
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
    /// assert!((tetrahedron.volumes()?[0] - 1.0 / 6.0).abs() < 1e-15);
    /// # Ok(()) }
    /// ```
    pub fn volumes(&self) -> Result<Vec<f64>, Error> {
        self.cells.volumes(self.cut.positions())
    }

    /// The number of voids of all cells: components of faces within them.
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
    /// assert_eq!(tetrahedron.void_count(), 0);
    /// # Ok(()) }
    /// ```
    pub fn void_count(&self) -> usize {
        let cells = (0..self.cells.cell_count()).map(CellId::new);
        cells.map(|cell| self.cells.shells(Some(cell)).len() - 1).sum()
    }

    /// The number of polygons of the input.
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
    /// assert_eq!(tetrahedron.polygon_count(), 4);
    /// # Ok(()) }
    /// ```
    pub fn polygon_count(&self) -> usize {
        self.patches.input_of_polygon.len()
    }

    /// The number of inputs.
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
    /// assert_eq!(tetrahedron.input_count(), 1);
    /// # Ok(()) }
    /// ```
    pub fn input_count(&self) -> usize {
        self.patches.input_count
    }

    /// The input of each polygon.
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
    /// assert_eq!(tetrahedron.input_of_polygon(), [0; 4]);
    /// # Ok(()) }
    /// ```
    pub fn input_of_polygon(&self) -> &[u32] {
        &self.patches.input_of_polygon
    }

    /// The polygons without area, rising. They are part of no face.
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
    /// assert!(tetrahedron.polygons_without_area().is_empty());
    /// # Ok(()) }
    /// ```
    pub fn polygons_without_area(&self) -> &[u32] {
        &self.without_area
    }

    /// The polygons that were split because they are not planar, rising.
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
    /// assert!(tetrahedron.split_polygons().is_empty());
    /// # Ok(()) }
    /// ```
    pub fn split_polygons(&self) -> &[SplitPolygon] {
        &self.split
    }

    /// The picture of a face that is not planar with its front towards the eye.
    pub(super) fn fold(&self, face: FaceId) -> Option<AxisView> {
        self.patches.fold(self.patches_of_face.list(self.first_fine_face(face).index()))
    }

    /// The picture of a face with its front towards the eye.
    pub(super) fn view(&self, face: FaceId) -> AxisView {
        self.fold(face).unwrap_or_else(|| self.plane_view(self.first_fine_face(face)))
    }

    /// The picture of a fine face with its front towards the eye.
    pub(super) fn plane_view(&self, fine: FaceId) -> AxisView {
        let (axis, sign) = plane_axis(self.cut.plane(fine));
        AxisView { axis: axis as u8, from: if sign == Ordering::Less { Sign::Minus } else { Sign::Plus } }
    }

    /// Takes over what only the polygons that were given first could say.
    pub(super) fn with_notes_of(mut self, first: &Self) -> Self {
        self.without_area.clone_from(&first.without_area);
        self.split.clone_from(&first.split);
        match (&mut self.joined, &first.joined) {
            (Some(joined), Some(before)) => joined.join_before(before),
            (own, before) => *own = own.take().or_else(|| before.clone()),
        }
        self
    }
}

/// Polygons made triangles in patches.
struct Made {
    triangles: Vec<[u32; 3]>,
    patches: Patches,
    without_area: Vec<u32>,
    split: Vec<SplitPolygon>,
}

impl Made {
    fn new(polygons: &SpatialPolygons, non_planar: NonPlanar) -> Result<Self, Error> {
        Ok(Self::of(polygons, PolygonTriangles::new(polygons, non_planar)?))
    }

    fn of(polygons: &SpatialPolygons, triangles: PolygonTriangles) -> Self {
        let PolygonTriangles { triangles, polygon_of_triangle, without_area, split, apart } = triangles;
        let (patch_of_triangle, polygons_of_patch) =
            patches_with_triangles(polygons.polygon_count(), polygon_of_triangle, &apart);
        let patches = Patches {
            patch_of_triangle,
            folded: split.iter().map(|&(split, view)| (split.polygon, view)).collect(),
            bent: split.iter().filter(|own| !own.0.is_rounding()).map(|own| own.0.polygon).collect(),
            torn: None,
            polygons_of_patch,
            input_of_polygon: polygons.input_of_polygon().to_vec(),
            input_count: polygons.input_count(),
            surface: None,
            is_passing: Vec::new(),
            keeps_vertices: false,
            has_new_corners: false,
        };
        let split = split.into_iter().map(|split| split.0).collect();
        Self { triangles, patches, without_area, split }
    }

    /// Makes the triangles of a flat face one patch, for which the first of them stands; `first_of` has the first one of each polygon.
    fn join_faces(&mut self, first_of: &[u32]) {
        for patch in &mut self.patches.patch_of_triangle {
            *patch = first_of.get(*patch as usize).copied().unwrap_or(*patch);
        }
    }

    /// Adds the triangles of polygons that are known exactly; the points with their corners, and the outlines in them, if
    /// there are any.
    fn add_exact(
        &mut self,
        polygons: &SpatialPolygons,
    ) -> Result<Option<(Positions, Arc<PartOutlines>)>, Error> {
        if polygons.exact().is_empty() {
            return Ok(None);
        }
        let mut flat = polygons.positions().as_flat().to_vec();
        let mut outlines = PartOutlines::new(self.triangles.len());
        self.patches.is_passing = vec![false; flat.len() / 3];
        self.patches.has_new_corners = true;
        for (first, exact) in polygons.exact() {
            let corners = (flat.len() / 3) as u32;
            flat.extend(exact.points().as_flattened());
            for part in exact.parts() {
                self.triangles.push(part.triangle.map(|point| point + corners));
                self.patches.patch_of_triangle.push(first + part.polygon);
            }
            outlines.add(exact);
        }
        self.patches.is_passing.resize(flat.len() / 3, true);
        Ok(Some((Positions::from_flat(3, flat)?, Arc::new(outlines))))
    }
}

fn patches_with_triangles(
    polygon_count: usize,
    polygon_of_triangle: Vec<u32>,
    apart: &[u32],
) -> (Vec<u32>, Option<RaggedArray>) {
    if apart.is_empty() {
        return (polygon_of_triangle, None);
    }
    let mut polygon_of_patch: Vec<u32> = (0..polygon_count as u32).collect();
    let mut patch_of_triangle = polygon_of_triangle;
    for patch in &mut patch_of_triangle {
        if apart.binary_search(patch).is_ok() {
            polygon_of_patch.push(*patch);
            *patch = polygon_of_patch.len() as u32 - 1;
        }
    }
    (patch_of_triangle, Some(RaggedArray::from_lists(polygon_of_patch.iter().map(|&polygon| [2 * polygon]))))
}

fn sign_of_bit(packed: u32) -> Sign {
    Sign::power_of_minus_one((packed & 1) as usize)
}

fn unpacked(packed: u32) -> (FaceId, Sign) {
    (FaceId::from_u32(packed >> 1), sign_of_bit(packed))
}

/// The fine vertices inside edges and faces that nothing needs: those on straight edges and in flat faces.
fn omitted_vertices(
    merged: &Merged,
    fine: &PolygonalComplex,
    patches: &Patches,
    patches_of_face: &RaggedArray,
    around: &RaggedArray,
    predicates: &impl SpatialPredicates,
) -> Vec<bool> {
    let mut is_omitted = vec![true; fine.vertex_count()];
    merged.vertices.iter().for_each(|&vertex| is_omitted[vertex as usize] = false);
    let is_straight = |a: u32, b: u32, c: u32| {
        (patches.folded.is_empty() && patches.is_passing.is_empty())
            || (0..3).all(|axis| predicates.normal_sign(axis, [a, b, c]).is_eq())
    };
    for own in merged.edges.iter() {
        for pair in own.windows(2) {
            let ([a, b], [_, c]) = (fine.side_ends(pair[0]), fine.side_ends(pair[1]));
            is_omitted[b as usize] = is_straight(a, b, c);
        }
    }
    if !patches.folded.is_empty() {
        for (edge, ends) in fine.edges().iter().enumerate().filter(|&(edge, _)| merged.is_inside_face[edge]) {
            let is_fold = |&side: &u32| patches.fold(patches_of_face.list((side >> 1) as usize)).is_some();
            if around.list(edge).iter().any(is_fold) {
                ends.iter().for_each(|&vertex| is_omitted[vertex as usize] = false);
            }
        }
    }
    is_omitted
}
