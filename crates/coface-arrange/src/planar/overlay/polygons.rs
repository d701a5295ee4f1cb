//! Polygons with holes that an overlay selects.

use super::PlanarOverlay;
use crate::planar::VertexSource;
use crate::planar::areas::{exact_walks_area, walks_area};
use crate::planar::faces::NONE;
use coface_algebra::{EdgeId, VertexId};
use coface_algebra::{RaggedArray, Rational};
use coface_geometry::Positions;
use coface_geometry::predicates::PlanarPoint;
use rayon::prelude::*;

/// Polygons with holes: the boundary of a selection of faces of an overlay, with what each part comes from.
///
/// Rings are simple, with the selection on their left: outer rings run counterclockwise, holes clockwise. The inside of
/// each polygon is connected; rings touch each other in vertices at most. The edges of ring r are numbered like its
/// vertices in the list of all rings together: edge i goes from vertex i to the next on the ring.
///
/// # Examples
/// A square with a smaller one taken out that touches its side: one ring, which is simple.
/// ```
/// use coface_algebra::{EdgeId, RaggedArray};
/// use coface_arrange::planar::PlanarOverlay;
/// use coface_geometry::Positions;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let points = Positions::from_flat(2, vec![0., 0., 3., 0., 3., 3., 0., 3., 1., 0., 2., 0., 2., 1., 1., 1.])?;
/// let rings = RaggedArray::from_lists([[0, 1, 2, 3], [4, 5, 6, 7]]);
/// let overlay = PlanarOverlay::new(&points, &rings, &[0, 1])?;
/// let rest = overlay.select(|windings| windings == [(0, 1)])?;
/// assert_eq!(rest.f_vector(), [8, 8, 1]);
/// assert_eq!(rest.area(), 8.0);
/// // Both squares together are the first one; its lower side has no vertices of the second.
/// let both = overlay.select(|windings| !windings.is_empty())?;
/// assert_eq!(both.rings().list(0).len(), 4);
/// // The lower side of the second square runs along the middle of one edge.
/// let sides: Vec<Vec<usize>> = (0..4).map(|edge| both.sides_of_edge(EdgeId::new(edge)).collect()).collect();
/// assert!(sides.contains(&vec![0, 4]));
/// # Ok(()) }
/// ```
pub struct PlanarPolygons<'a> {
    pub(super) overlay: &'a PlanarOverlay,
    pub(super) positions: Positions,
    pub(super) rings: RaggedArray,
    pub(super) polygons: RaggedArray,
    /// The polygon of each bounded face, `NONE` for those that are not selected.
    pub(super) polygon_of_face: Vec<u32>,
    pub(super) has_exterior: bool,
    /// A side along each edge.
    pub(super) sides: Vec<u32>,
    /// Further sides of edges.
    pub(super) other_sides: Vec<u32>,
    /// Where those of each edge begin, and those of the last end; nothing if there are none.
    pub(super) other_starts: Vec<u32>,
    pub(super) pinch_vertices: Vec<u32>,
    /// The corner or crossing at each vertex.
    pub(super) events: Vec<u32>,
}

impl std::fmt::Debug for PlanarPolygons<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("PlanarPolygons")
            .field("rings", &self.rings.len())
            .field("polygons", &self.polygons.len())
            .finish_non_exhaustive()
    }
}

impl PlanarPolygons<'_> {
    /// The vertices: each coordinate is the floating-point number nearest to the exact one. Corners of the input are
    /// exact.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::planar::PlanarOverlay;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two squares that overlap in a quarter.
    /// let points = Positions::from_flat(2, vec![0., 0., 2., 0., 2., 2., 0., 2., 1., 1., 3., 1., 3., 3., 1., 3.])?;
    /// let rings = RaggedArray::from_lists([[0, 1, 2, 3], [4, 5, 6, 7]]);
    /// let overlay = PlanarOverlay::new(&points, &rings, &[0, 1])?;
    /// let both = overlay.select(|windings| windings.len() == 2)?;
    /// assert_eq!(both.positions().len(), 4);
    /// # Ok(()) }
    /// ```
    pub fn positions(&self) -> &Positions {
        &self.positions
    }

    /// The vertices of each ring in order; no ring comes to a vertex twice.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::planar::PlanarOverlay;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two squares that overlap in a quarter.
    /// let points = Positions::from_flat(2, vec![0., 0., 2., 0., 2., 2., 0., 2., 1., 1., 3., 1., 3., 3., 1., 3.])?;
    /// let rings = RaggedArray::from_lists([[0, 1, 2, 3], [4, 5, 6, 7]]);
    /// let overlay = PlanarOverlay::new(&points, &rings, &[0, 1])?;
    /// let both = overlay.select(|windings| windings.len() == 2)?;
    /// assert_eq!(both.rings().list(0).len(), 4);
    /// # Ok(()) }
    /// ```
    pub fn rings(&self) -> &RaggedArray {
        &self.rings
    }

    /// The rings of each polygon, the outer one first; polygon after polygon. With [`Self::has_exterior`] one more list
    /// comes last: the holes in what reaches to infinity.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::planar::PlanarOverlay;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two squares that overlap in a quarter.
    /// let points = Positions::from_flat(2, vec![0., 0., 2., 0., 2., 2., 0., 2., 1., 1., 3., 1., 3., 3., 1., 3.])?;
    /// let rings = RaggedArray::from_lists([[0, 1, 2, 3], [4, 5, 6, 7]]);
    /// let overlay = PlanarOverlay::new(&points, &rings, &[0, 1])?;
    /// let both = overlay.select(|windings| windings.len() == 2)?;
    /// assert_eq!(both.polygons().list(0), [0]);
    /// # Ok(()) }
    /// ```
    pub fn polygons(&self) -> &RaggedArray {
        &self.polygons
    }

    /// The polygon that a bounded face of the overlay is in, if it is selected.
    #[doc(hidden)]
    pub fn polygon_of_face(&self, face: usize) -> Option<usize> {
        let polygon = self.polygon_of_face[face];
        (polygon != NONE).then_some(polygon as usize)
    }

    /// What is at a vertex: vertices of different selections from one overlay are at one place if this is equal.
    #[doc(hidden)]
    pub fn event(&self, vertex: VertexId) -> u32 {
        self.events[vertex.index()]
    }

    /// Whether the selection reaches to infinity.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::planar::PlanarOverlay;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two squares that overlap in a quarter.
    /// let points = Positions::from_flat(2, vec![0., 0., 2., 0., 2., 2., 0., 2., 1., 1., 3., 1., 3., 3., 1., 3.])?;
    /// let rings = RaggedArray::from_lists([[0, 1, 2, 3], [4, 5, 6, 7]]);
    /// let overlay = PlanarOverlay::new(&points, &rings, &[0, 1])?;
    /// let both = overlay.select(|windings| windings.len() == 2)?;
    /// assert!(!both.has_exterior());
    /// assert!(overlay.select(|windings| windings.is_empty())?.has_exterior());
    /// # Ok(()) }
    /// ```
    pub fn has_exterior(&self) -> bool {
        self.has_exterior
    }

    /// The numbers of vertices, edges and bounded polygons.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::planar::PlanarOverlay;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two squares that overlap in a quarter.
    /// let points = Positions::from_flat(2, vec![0., 0., 2., 0., 2., 2., 0., 2., 1., 1., 3., 1., 3., 3., 1., 3.])?;
    /// let rings = RaggedArray::from_lists([[0, 1, 2, 3], [4, 5, 6, 7]]);
    /// let overlay = PlanarOverlay::new(&points, &rings, &[0, 1])?;
    /// let both = overlay.select(|windings| windings.len() == 2)?;
    /// assert_eq!(both.f_vector(), [4, 4, 1]);
    /// # Ok(()) }
    /// ```
    pub fn f_vector(&self) -> [usize; 3] {
        [self.positions.len(), self.rings.item_count(), self.polygons.len() - usize::from(self.has_exterior)]
    }

    /// The number of rings that are holes.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::planar::PlanarOverlay;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two squares that overlap in a quarter.
    /// let points = Positions::from_flat(2, vec![0., 0., 2., 0., 2., 2., 0., 2., 1., 1., 3., 1., 3., 3., 1., 3.])?;
    /// let rings = RaggedArray::from_lists([[0, 1, 2, 3], [4, 5, 6, 7]]);
    /// let overlay = PlanarOverlay::new(&points, &rings, &[0, 1])?;
    /// let both = overlay.select(|windings| windings.len() == 2)?;
    /// assert_eq!(both.hole_count(), 0);
    /// assert_eq!(overlay.select(|windings| windings.is_empty())?.hole_count(), 1);
    /// # Ok(()) }
    /// ```
    pub fn hole_count(&self) -> usize {
        self.rings.len() - self.f_vector()[2]
    }

    /// The rounded positions around a ring.
    ///
    /// # Panics
    /// If there is no such ring.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::planar::PlanarOverlay;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two squares that overlap in a quarter.
    /// let points = Positions::from_flat(2, vec![0., 0., 2., 0., 2., 2., 0., 2., 1., 1., 3., 1., 3., 3., 1., 3.])?;
    /// let rings = RaggedArray::from_lists([[0, 1, 2, 3], [4, 5, 6, 7]]);
    /// let overlay = PlanarOverlay::new(&points, &rings, &[0, 1])?;
    /// let both = overlay.select(|windings| windings.len() == 2)?;
    /// assert!(both.ring_positions(0).any(|corner| corner == [2.0, 1.0]));
    /// # Ok(()) }
    /// ```
    pub fn ring_positions(&self, ring: usize) -> impl ExactSizeIterator<Item = [f64; 2]> + '_ {
        let flat = self.positions.as_flat();
        self.rings.list(ring).iter().map(move |&v| [flat[2 * v as usize], flat[2 * v as usize + 1]])
    }

    /// The vertices that several rings run through, rising: there the boundary of the selection is not a curve.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::planar::PlanarOverlay;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two squares that overlap in a quarter.
    /// let points = Positions::from_flat(2, vec![0., 0., 2., 0., 2., 2., 0., 2., 1., 1., 3., 1., 3., 3., 1., 3.])?;
    /// let rings = RaggedArray::from_lists([[0, 1, 2, 3], [4, 5, 6, 7]]);
    /// let overlay = PlanarOverlay::new(&points, &rings, &[0, 1])?;
    /// // What is in one square only touches itself where the squares cross.
    /// let one = overlay.select(|windings| windings.len() == 1)?;
    /// assert_eq!(one.pinch_vertices().len(), 2);
    /// # Ok(()) }
    /// ```
    pub fn pinch_vertices(&self) -> impl ExactSizeIterator<Item = VertexId> + '_ {
        self.pinch_vertices.iter().map(|&vertex| VertexId::from_u32(vertex))
    }

    /// Where a vertex comes from: a point of the input, or a crossing of two sides by their places in the lists of all
    /// rings of the input together.
    ///
    /// # Panics
    /// If there is no such vertex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{RaggedArray, VertexId};
    /// use coface_arrange::planar::{PlanarOverlay, VertexSource};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two squares that overlap in a quarter.
    /// let points = Positions::from_flat(2, vec![0., 0., 2., 0., 2., 2., 0., 2., 1., 1., 3., 1., 3., 3., 1., 3.])?;
    /// let rings = RaggedArray::from_lists([[0, 1, 2, 3], [4, 5, 6, 7]]);
    /// let overlay = PlanarOverlay::new(&points, &rings, &[0, 1])?;
    /// let both = overlay.select(|windings| windings.len() == 2)?;
    /// let crossing = |vertex| matches!(both.source(VertexId::new(vertex)), VertexSource::Crossing(_));
    /// assert_eq!((0..4).filter(|&vertex| crossing(vertex)).count(), 2);
    /// # Ok(()) }
    /// ```
    pub fn source(&self, vertex: VertexId) -> VertexSource {
        self.overlay.source(self.events[vertex.index()])
    }

    /// The sides of the input that run along an edge or along a part of it, by their places in the lists of all rings
    /// of the input together; one after the other they run along all of it.
    ///
    /// # Panics
    /// If there is no such edge.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{EdgeId, RaggedArray};
    /// use coface_arrange::planar::PlanarOverlay;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two squares that overlap in a quarter.
    /// let points = Positions::from_flat(2, vec![0., 0., 2., 0., 2., 2., 0., 2., 1., 1., 3., 1., 3., 3., 1., 3.])?;
    /// let rings = RaggedArray::from_lists([[0, 1, 2, 3], [4, 5, 6, 7]]);
    /// let overlay = PlanarOverlay::new(&points, &rings, &[0, 1])?;
    /// let both = overlay.select(|windings| windings.len() == 2)?;
    /// // Two sides of each square bound the quarter.
    /// let mut sides: Vec<usize> = (0..4).flat_map(|edge| both.sides_of_edge(EdgeId::new(edge))).collect();
    /// sides.sort_unstable();
    /// assert_eq!(sides, [1, 2, 4, 7]);
    /// # Ok(()) }
    /// ```
    pub fn sides_of_edge(&self, edge: EdgeId) -> impl Iterator<Item = usize> + '_ {
        let edge = edge.index();
        let others = match self.other_starts.get(edge..edge + 2) {
            Some(ends) => &self.other_sides[ends[0] as usize..ends[1] as usize],
            None => &[],
        };
        std::iter::once(self.sides[edge] as usize).chain(others.iter().map(|&side| side as usize))
    }

    /// The exact position of a vertex.
    ///
    /// # Panics
    /// If there is no such vertex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{RaggedArray, VertexId};
    /// use coface_arrange::planar::PlanarOverlay;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two squares that overlap in a quarter.
    /// let points = Positions::from_flat(2, vec![0., 0., 2., 0., 2., 2., 0., 2., 1., 1., 3., 1., 3., 3., 1., 3.])?;
    /// let rings = RaggedArray::from_lists([[0, 1, 2, 3], [4, 5, 6, 7]]);
    /// let overlay = PlanarOverlay::new(&points, &rings, &[0, 1])?;
    /// let both = overlay.select(|windings| windings.len() == 2)?;
    /// assert!(both.point(VertexId::new(0)).is_exactly_rounded());
    /// # Ok(()) }
    /// ```
    pub fn point(&self, vertex: VertexId) -> PlanarPoint {
        self.overlay.parts().event_point(self.events[vertex.index()])
    }

    /// Whether the rounded positions of all vertices are their exact ones.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::planar::PlanarOverlay;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two squares that overlap in a quarter.
    /// let points = Positions::from_flat(2, vec![0., 0., 2., 0., 2., 2., 0., 2., 1., 1., 3., 1., 3., 3., 1., 3.])?;
    /// let rings = RaggedArray::from_lists([[0, 1, 2, 3], [4, 5, 6, 7]]);
    /// let overlay = PlanarOverlay::new(&points, &rings, &[0, 1])?;
    /// let both = overlay.select(|windings| windings.len() == 2)?;
    /// assert!(both.is_exactly_rounded());
    /// # Ok(()) }
    /// ```
    pub fn is_exactly_rounded(&self) -> bool {
        (0..self.events.len())
            .into_par_iter()
            .with_min_len(1 << 12)
            .all(|v| self.is_exactly_rounded_at(VertexId::new(v)))
    }

    /// Whether the rounded position of a vertex is exact.
    #[doc(hidden)]
    pub fn is_exactly_rounded_at(&self, vertex: VertexId) -> bool {
        let is_corner = (self.events[vertex.index()] as usize) < self.overlay.rings.points.len();
        is_corner || self.point(vertex).is_exactly_rounded()
    }

    /// The areas of the polygons, without their holes, in the square of the unit of the input, with relative errors
    /// below $2^{-49}$: sums in twice the usual precision, and fractions where their error bounds leave more open. What
    /// reaches to infinity has none.
    ///
    /// # Complexity
    /// Linear in the vertices, in parallel over the polygons.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::planar::PlanarOverlay;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two squares that overlap in a quarter.
    /// let points = Positions::from_flat(2, vec![0., 0., 2., 0., 2., 2., 0., 2., 1., 1., 3., 1., 3., 3., 1., 3.])?;
    /// let rings = RaggedArray::from_lists([[0, 1, 2, 3], [4, 5, 6, 7]]);
    /// let overlay = PlanarOverlay::new(&points, &rings, &[0, 1])?;
    /// let both = overlay.select(|windings| windings.len() == 2)?;
    /// assert_eq!(both.areas(), [1.0]);
    /// # Ok(()) }
    /// ```
    pub fn areas(&self) -> Vec<f64> {
        (0..self.f_vector()[2])
            .into_par_iter()
            .with_min_len(64)
            .map(|polygon| self.area_of(polygon))
            .collect()
    }

    /// The area of all polygons together; with [`Self::has_exterior`] minus the area of what is not selected.
    ///
    /// # Complexity
    /// As [`Self::areas`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::planar::PlanarOverlay;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two squares that overlap in a quarter.
    /// let points = Positions::from_flat(2, vec![0., 0., 2., 0., 2., 2., 0., 2., 1., 1., 3., 1., 3., 3., 1., 3.])?;
    /// let rings = RaggedArray::from_lists([[0, 1, 2, 3], [4, 5, 6, 7]]);
    /// let overlay = PlanarOverlay::new(&points, &rings, &[0, 1])?;
    /// let both = overlay.select(|windings| windings.len() == 2)?;
    /// assert_eq!(both.area(), 1.0);
    /// // What is in no square reaches to infinity: minus the area of both squares together.
    /// assert_eq!(overlay.select(|windings| windings.is_empty())?.area(), -7.0);
    /// # Ok(()) }
    /// ```
    pub fn area(&self) -> f64 {
        let exterior = if self.has_exterior { self.area_of(self.polygons.len() - 1) } else { 0.0 };
        self.areas().iter().sum::<f64>() + exterior
    }

    fn area_of(&self, polygon: usize) -> f64 {
        let rings = self.polygons.list(polygon);
        let walks = rings.iter().map(|&ring| self.rings.list(ring as usize));
        walks_area(walks, |vertex| self.point(VertexId::from_u32(vertex))).unwrap_or_else(|| {
            rings.iter().fold(Rational::ZERO, |sum, &ring| &sum + &self.exact_ring_area(ring)).to_f64()
        })
    }

    /// The exact area within all rings as a fraction; with [`Self::has_exterior`] minus the area of what is not
    /// selected.
    ///
    /// # Complexity
    /// Linear in the vertices in operations on fractions, whose size grows with the number of crossings.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::planar::PlanarOverlay;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two squares that overlap in a quarter.
    /// let points = Positions::from_flat(2, vec![0., 0., 2., 0., 2., 2., 0., 2., 1., 1., 3., 1., 3., 3., 1., 3.])?;
    /// let rings = RaggedArray::from_lists([[0, 1, 2, 3], [4, 5, 6, 7]]);
    /// let overlay = PlanarOverlay::new(&points, &rings, &[0, 1])?;
    /// let both = overlay.select(|windings| windings.len() == 2)?;
    /// assert_eq!(both.exact_area().to_string(), "1");
    /// # Ok(()) }
    /// ```
    pub fn exact_area(&self) -> Rational {
        (0..self.rings.len() as u32).fold(Rational::ZERO, |sum, ring| &sum + &self.exact_ring_area(ring))
    }

    fn exact_ring_area(&self, ring: u32) -> Rational {
        let walk = std::iter::once(self.rings.list(ring as usize));
        exact_walks_area(walk, |vertex| self.point(VertexId::from_u32(vertex)))
    }
}
