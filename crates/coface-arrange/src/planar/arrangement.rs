//! The arrangement of segments in the plane.

use super::PlanarOptions;
use super::crossings::{Meetings, Soup};
use super::edges::Edges;
use super::exact_ends::ExactEnds;
use super::faces::{Faces, NONE, Orbits};
use super::nesting::{Ray, rising_line};
use super::segment_tree::SegmentTree;
use super::vertices::Vertices;
use coface_algebra::chains::ChainComplex;
use coface_algebra::{EdgeId, Error, ErrorKind, FaceId, HalfedgeId, VertexId};
use coface_algebra::{RaggedArray, SparseMatrix};
use coface_geometry::Positions;
use coface_geometry::predicates::PlanarPoint;
use rayon::prelude::*;
use std::sync::Arc;

/// Where a vertex of an arrangement comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VertexSource {
    /// The point of the input at this position; the first of those that are equal.
    Given(usize),
    /// The crossing of two segments of the input.
    Crossing([usize; 2]),
}

/// The vertices, edges and faces that segments cut the plane into, exactly.
///
/// Vertices are in lexicographic order of their exact positions. An edge goes from its lower to its upper vertex; edges
/// are in the order of their ends. Halfedge 2e goes along edge e and 2e + 1 against it, and each has its face on its
/// left. Bounded faces have numbers; a face can have holes. The unbounded face is `None`.
///
/// # Examples
/// A square and both its diagonals, one of them drawn as two overlapping segments.
/// ```
/// use coface_arrange::planar::PlanarArrangement;
/// use coface_geometry::Positions;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let corners = Positions::from_flat(2, vec![0., 0., 3., 0., 3., 3., 0., 3., 1., 1., 2., 2.])?;
/// let segments = [[0, 1], [1, 2], [2, 3], [3, 0], [0, 5], [4, 2], [1, 3]];
/// let arrangement = PlanarArrangement::new(&corners, &segments)?;
/// // The centre is new; the diagonal has vertices at 1, 1.5 and 2.
/// assert_eq!(arrangement.f_vector(), [7, 10, 4]);
/// assert_eq!(arrangement.areas().iter().sum::<f64>(), 9.0);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct PlanarArrangement {
    pub(super) points: Vec<[f64; 2]>,
    pub(super) segments: Vec<[u32; 2]>,
    /// Exact ends, if segments are pieces of others.
    pub(super) exact: Option<Arc<ExactEnds>>,
    pub(super) sources: Vec<VertexSource>,
    pub(super) vertices: Vec<PlanarPoint>,
    pub(super) positions: Positions,
    pub(super) vertex_of_point: Vec<u32>,
    pub(super) ends: Vec<[u32; 2]>,
    pub(super) segments_of_edge: RaggedArray,
    pub(super) edges_of_segment: RaggedArray,
    pub(super) orbits: Orbits,
    pub(super) faces: Faces,
}

impl PlanarArrangement {
    /// The arrangement of segments between points of the plane, given by the positions of their ends.
    ///
    /// Segments may cross, touch, overlap, be there twice or have no length. Every point is a vertex, also if no
    /// segment ends there. Nothing is decided with a tolerance.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless positions have two coordinates; [`ErrorKind::NotInComplex`] naming a segment with an
    /// end that is not there; [`ErrorKind::TooLarge`] beyond 2^31 pieces.
    ///
    /// # Complexity
    /// $O((n + k) \log (n + k))$ for n segments with k crossings where segments are evenly sized or crowd in few
    /// places, at most $O(n^2 \log n)$; in parallel, with the same result whatever the number of threads.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::planar::PlanarArrangement;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two segments that cross in (1, 1).
    /// let ends = Positions::from_flat(2, vec![0., 0., 2., 2., 0., 2., 2., 0.])?;
    /// let cross = PlanarArrangement::new(&ends, &[[0, 1], [2, 3]])?;
    /// assert_eq!(cross.f_vector(), [5, 4, 0]);
    /// # Ok(()) }
    /// ```
    pub fn new(positions: &Positions, segments: &[[u32; 2]]) -> Result<Self, Error> {
        Self::with_options(positions, segments, &PlanarOptions::default())
    }

    /// The same, with a bound on the number of cells.
    ///
    /// # Errors
    /// As [`Self::new`], and [`ErrorKind::TooLarge`] for more cells than [`PlanarOptions::max_cells`]: crossings are
    /// counted while they are found, so that a drawing far above the bound is refused early. The message does not
    /// depend on the number of threads.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::planar::{PlanarArrangement, PlanarOptions};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(2, vec![0., 0., 1., 0., 0., 1.])?;
    /// let arrange = |most| {
    ///     let options = PlanarOptions::new().max_cells(most);
    ///     PlanarArrangement::with_options(&corners, &[[0, 1], [1, 2], [2, 0]], &options)
    /// };
    /// // A triangle has seven cells.
    /// assert!(arrange(7).is_ok() && arrange(6).is_err());
    /// # Ok(()) }
    /// ```
    pub fn with_options(
        positions: &Positions,
        segments: &[[u32; 2]],
        options: &PlanarOptions,
    ) -> Result<Self, Error> {
        Self::check_ends(positions, segments)?;
        Self::arranged(positions, segments, None, options)
    }

    /// # Errors
    /// If points do not lie in the plane, or segments have ends that are not there.
    pub(super) fn check_ends(positions: &Positions, segments: &[[u32; 2]]) -> Result<(), Error> {
        if positions.dimension() != 2 && !positions.is_empty() {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("points of dimension {} do not lie in the plane", positions.dimension()),
            )
            .with_cure("give two coordinates for each point"));
        }
        let count = positions.len();
        if let Some((s, ends)) =
            segments.iter().enumerate().find(|(_, ends)| ends.iter().any(|&p| p as usize >= count))
        {
            return Err(Error::new(
                ErrorKind::NotInComplex,
                format!(
                    "segment {s} goes from point {} to point {}; there are {count} points",
                    ends[0], ends[1]
                ),
            ));
        }
        if segments.len() + count >= 1 << 31 {
            return Err(Error::new(ErrorKind::TooLarge, "more than 2^31 segments and points"));
        }
        Ok(())
    }

    /// The arrangement of segments with these ends, rounded where they are known exactly.
    pub(super) fn arranged(
        positions: &Positions,
        segments: &[[u32; 2]],
        exact: Option<Arc<ExactEnds>>,
        options: &PlanarOptions,
    ) -> Result<Self, Error> {
        let count = positions.len();
        let mut soup =
            Soup::with_loose_points(positions.as_flat().as_chunks::<2>().0.to_vec(), segments.to_vec());
        soup.exact = exact;
        let tree = soup.tree();
        let meetings = Meetings::of(&soup, &tree, options)?;
        if meetings.crossings.len() + count >= 1 << 31 {
            return Err(Error::new(ErrorKind::TooLarge, "more than 2^31 crossings")
                .with_cure("arrange the segments in parts"));
        }
        let Vertices { events, vertex_of_event } = Vertices::of_soup(&soup, &meetings);
        let edges = Edges::new(&soup, &meetings, &vertex_of_event)?;
        let (mut sources, mut vertices) =
            (Vec::with_capacity(events.len()), Vec::with_capacity(events.len()));
        for event in events {
            match (event as usize).checked_sub(count) {
                None => {
                    sources.push(VertexSource::Given(event as usize));
                    vertices.push(soup.point(event));
                }
                Some(i) => {
                    let crossing = &meetings.crossings[i];
                    sources.push(VertexSource::Crossing(crossing.segments.map(|s| s as usize)));
                    vertices.push(crossing.point(&soup));
                }
            }
        }
        let mut vertex_of_point = vertex_of_event;
        vertex_of_point.truncate(count);
        options.check(edges.ends.len() + vertices.len(), "without its faces")?;
        let found = Self::assemble(soup, &tree, segments.len(), sources, vertices, vertex_of_point, edges)?;
        options.check(found.f_vector().iter().sum(), "in all")?;
        Ok(found)
    }

    /// The arrangement of polylines: each list runs through its points in order. Segment numbers count the sides of all
    /// polylines, one after the other; a list of fewer than two points has none.
    ///
    /// # Errors
    /// As [`Self::new`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::planar::PlanarArrangement;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = Positions::from_flat(2, vec![0., 0., 2., 2., 2., 0., 0., 2.])?;
    /// let bow_tie = PlanarArrangement::from_polylines(&points, &RaggedArray::from_lists([[0, 1, 2, 3, 0]]))?;
    /// assert_eq!(bow_tie.f_vector(), [5, 6, 2]);
    /// # Ok(()) }
    /// ```
    pub fn from_polylines(positions: &Positions, polylines: &RaggedArray) -> Result<Self, Error> {
        let sides = polylines.iter().flat_map(|line| line.windows(2).map(|side| [side[0], side[1]]));
        Self::new(positions, &sides.collect::<Vec<_>>())
    }

    pub(super) fn assemble(
        soup: Soup,
        tree: &SegmentTree,
        segment_count: usize,
        sources: Vec<VertexSource>,
        vertices: Vec<PlanarPoint>,
        vertex_of_point: Vec<u32>,
        edges: Edges,
    ) -> Result<Self, Error> {
        let Edges { ends, segments: segments_of_edge, of_segment: edges_of_segment } = edges;
        let line = |edge: u32| rising_line(soup.support(segments_of_edge.list(edge as usize)[0]));
        let orbits = Orbits::new(vertices.len(), &ends, |halfedge| {
            let [low, high] = line(halfedge / 2);
            if halfedge.is_multiple_of(2) { [low, high] } else { [high, low] }
        });
        let halfedge_below = |&vertex: &u32| {
            let ray = Ray { from: vertices[vertex as usize] };
            let edge = |segment: u32| {
                ray.edge_below(edges_of_segment.list(segment as usize), &ends, |vertex| {
                    vertices[vertex as usize]
                })
            };
            let found = match soup.exact {
                None => ray.first_below(tree, edge),
                Some(_) => {
                    let line = |segment: u32, _| rising_line(soup.support(segment));
                    let ends = |segment: u32, _| soup.rising_ends(segment);
                    ray.first_below_of(tree, line, ends, edge)
                }
            };
            found.map(|edge| 2 * edge)
        };
        // There is nothing to the left of the lowest vertex of all.
        let mut below = vec![None; orbits.lowest_vertices.len().min(1)];
        below.par_extend(orbits.lowest_vertices.par_iter().skip(1).with_min_len(16).map(halfedge_below));
        let faces = Faces::new(&orbits, &below, 0..below.len());
        let flat = vertices.iter().flat_map(PlanarPoint::rounded).collect();
        let positions = Positions::from_flat(2, flat)?;
        let Soup { points, mut segments, exact } = soup;
        segments.truncate(segment_count);
        Ok(Self {
            points,
            segments,
            exact,
            sources,
            vertices,
            positions,
            vertex_of_point,
            ends,
            segments_of_edge,
            edges_of_segment,
            orbits,
            faces,
        })
    }

    /// The number of vertices.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::planar::PlanarArrangement;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two segments that cross in (1, 1).
    /// let ends = Positions::from_flat(2, vec![0., 0., 2., 2., 0., 2., 2., 0.])?;
    /// let cross = PlanarArrangement::new(&ends, &[[0, 1], [2, 3]])?;
    /// assert_eq!(cross.vertex_count(), 5);
    /// # Ok(()) }
    /// ```
    pub fn vertex_count(&self) -> usize {
        self.vertices.len()
    }

    /// The number of edges.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::planar::PlanarArrangement;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two segments that cross in (1, 1).
    /// let ends = Positions::from_flat(2, vec![0., 0., 2., 2., 0., 2., 2., 0.])?;
    /// let cross = PlanarArrangement::new(&ends, &[[0, 1], [2, 3]])?;
    /// assert_eq!(cross.edge_count(), 4);
    /// # Ok(()) }
    /// ```
    pub fn edge_count(&self) -> usize {
        self.ends.len()
    }

    /// The number of bounded faces; a face with holes counts once.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::planar::PlanarArrangement;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(2, vec![0., 0., 0., 1., 1., 0.])?;
    /// let triangle = PlanarArrangement::new(&corners, &[[0, 1], [1, 2], [2, 0]])?;
    /// assert_eq!(triangle.face_count(), 1);
    /// # Ok(()) }
    /// ```
    pub fn face_count(&self) -> usize {
        self.faces.orbits.len()
    }

    /// The numbers of vertices, edges and bounded faces.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::planar::PlanarArrangement;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(2, vec![0., 0., 0., 1., 1., 0.])?;
    /// let triangle = PlanarArrangement::new(&corners, &[[0, 1], [1, 2], [2, 0]])?;
    /// assert_eq!(triangle.f_vector(), [3, 3, 1]);
    /// # Ok(()) }
    /// ```
    pub fn f_vector(&self) -> Vec<usize> {
        vec![self.vertex_count(), self.edge_count(), self.face_count()]
    }

    /// The number of connected components of vertices and edges; a vertex on its own is one.
    ///
    /// Vertices minus edges plus bounded faces is this number.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::planar::PlanarArrangement;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A triangle within a triangle.
    /// let corners = Positions::from_flat(2, vec![0., 0., 9., 0., 0., 9., 1., 1., 2., 1., 1., 2.])?;
    /// let walks = RaggedArray::from_lists([[0, 1, 2, 0], [3, 4, 5, 3]]);
    /// let nested = PlanarArrangement::from_polylines(&corners, &walks)?;
    /// assert_eq!(nested.component_count(), 2);
    /// # Ok(()) }
    /// ```
    pub fn component_count(&self) -> usize {
        self.orbits.lowest_vertices.len()
    }

    /// The number of holes in bounded faces: components with edges that lie in them. Vertices on their own are no
    /// holes.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::planar::PlanarArrangement;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A triangle within a triangle.
    /// let corners = Positions::from_flat(2, vec![0., 0., 9., 0., 0., 9., 1., 1., 2., 1., 1., 2.])?;
    /// let walks = RaggedArray::from_lists([[0, 1, 2, 0], [3, 4, 5, 3]]);
    /// let nested = PlanarArrangement::from_polylines(&corners, &walks)?;
    /// assert_eq!((nested.face_count(), nested.hole_count()), (2, 1));
    /// # Ok(()) }
    /// ```
    pub fn hole_count(&self) -> usize {
        self.faces.orbits.item_count() - self.face_count()
    }

    /// The positions of the vertices: each coordinate is the floating-point number nearest to the exact one.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_arrange::planar::PlanarArrangement;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two segments that cross in (1, 1).
    /// let ends = Positions::from_flat(2, vec![0., 0., 2., 2., 0., 2., 2., 0.])?;
    /// let cross = PlanarArrangement::new(&ends, &[[0, 1], [2, 3]])?;
    /// // Vertices are in lexicographic order.
    /// assert_eq!(cross.positions().point(VertexId::new(2)), [1.0, 1.0]);
    /// # Ok(()) }
    /// ```
    pub fn positions(&self) -> &Positions {
        &self.positions
    }

    /// The exact position of a vertex.
    ///
    /// # Panics
    /// If there is no such vertex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_arrange::planar::PlanarArrangement;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two segments that cross in (1, 1).
    /// let ends = Positions::from_flat(2, vec![0., 0., 2., 2., 0., 2., 2., 0.])?;
    /// let cross = PlanarArrangement::new(&ends, &[[0, 1], [2, 3]])?;
    /// assert!(cross.point(VertexId::new(2)).is_exactly_rounded());
    /// assert_eq!(cross.point(VertexId::new(2)).rounded(), [1.0, 1.0]);
    /// # Ok(()) }
    /// ```
    pub fn point(&self, vertex: VertexId) -> PlanarPoint {
        self.vertices[vertex.index()]
    }

    /// Where a vertex comes from.
    ///
    /// # Panics
    /// If there is no such vertex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_arrange::planar::{PlanarArrangement, VertexSource};
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two segments that cross in (1, 1).
    /// let ends = Positions::from_flat(2, vec![0., 0., 2., 2., 0., 2., 2., 0.])?;
    /// let cross = PlanarArrangement::new(&ends, &[[0, 1], [2, 3]])?;
    /// assert_eq!(cross.source(VertexId::new(0)), VertexSource::Given(0));
    /// assert_eq!(cross.source(VertexId::new(2)), VertexSource::Crossing([0, 1]));
    /// # Ok(()) }
    /// ```
    pub fn source(&self, vertex: VertexId) -> VertexSource {
        self.sources[vertex.index()]
    }

    /// The vertex at each point of the input; `None` where pruning has removed it.
    ///
    /// # Panics
    /// If there is no such point.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_arrange::planar::PlanarArrangement;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two segments that cross in (1, 1).
    /// let ends = Positions::from_flat(2, vec![0., 0., 2., 2., 0., 2., 2., 0.])?;
    /// let cross = PlanarArrangement::new(&ends, &[[0, 1], [2, 3]])?;
    /// assert_eq!(cross.vertex_of_point(1), Some(VertexId::new(4)));
    /// # Ok(()) }
    /// ```
    pub fn vertex_of_point(&self, point: usize) -> Option<VertexId> {
        let vertex = self.vertex_of_point[point];
        (vertex != NONE).then(|| VertexId::from_u32(vertex))
    }

    /// The ends of an edge, the lower vertex first.
    ///
    /// # Panics
    /// If there is no such edge.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{EdgeId, VertexId};
    /// use coface_arrange::planar::PlanarArrangement;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two segments that cross in (1, 1).
    /// let ends = Positions::from_flat(2, vec![0., 0., 2., 2., 0., 2., 2., 0.])?;
    /// let cross = PlanarArrangement::new(&ends, &[[0, 1], [2, 3]])?;
    /// assert_eq!(cross.ends(EdgeId::new(0)), [VertexId::new(0), VertexId::new(2)]);
    /// # Ok(()) }
    /// ```
    pub fn ends(&self, edge: EdgeId) -> [VertexId; 2] {
        self.ends[edge.index()].map(VertexId::from_u32)
    }

    /// The segments of the input that run along each edge, rising: list e is edge e.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::planar::PlanarArrangement;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two segments that cross in (1, 1).
    /// let ends = Positions::from_flat(2, vec![0., 0., 2., 2., 0., 2., 2., 0.])?;
    /// let cross = PlanarArrangement::new(&ends, &[[0, 1], [2, 3]])?;
    /// // The two edges that end in the crossing from the left belong to different segments.
    /// assert_eq!([0, 1].map(|edge| cross.segments_of_edges().list(edge).to_vec()), [vec![0], vec![1]]);
    /// # Ok(()) }
    /// ```
    pub fn segments_of_edges(&self) -> &RaggedArray {
        &self.segments_of_edge
    }

    /// The edges along a segment of the input, from its lexicographically lower end to its upper one; without those
    /// that pruning has taken away.
    ///
    /// # Panics
    /// If there is no such segment.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::EdgeId;
    /// use coface_arrange::planar::PlanarArrangement;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two segments that cross in (1, 1).
    /// let ends = Positions::from_flat(2, vec![0., 0., 2., 2., 0., 2., 2., 0.])?;
    /// let cross = PlanarArrangement::new(&ends, &[[0, 1], [2, 3]])?;
    /// assert!(cross.edges_of_segment(0).eq([EdgeId::new(0), EdgeId::new(3)]));
    /// # Ok(()) }
    /// ```
    pub fn edges_of_segment(&self, segment: usize) -> impl Iterator<Item = EdgeId> {
        assert!(segment < self.segments.len(), "there are {} segments", self.segments.len());
        self.edges_of_segment.list(segment).iter().filter(|&&edge| edge != NONE).map(|&e| EdgeId::from_u32(e))
    }

    /// The halfedges that leave a vertex, counterclockwise, the first one after straight down.
    ///
    /// # Panics
    /// If there is no such vertex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{HalfedgeId, VertexId};
    /// use coface_arrange::planar::PlanarArrangement;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two segments that cross in (1, 1).
    /// let ends = Positions::from_flat(2, vec![0., 0., 2., 2., 0., 2., 2., 0.])?;
    /// let cross = PlanarArrangement::new(&ends, &[[0, 1], [2, 3]])?;
    /// // Halfedge 2e goes along edge e and 2e + 1 against it: right down, right up, left up, left down.
    /// assert!(cross.halfedges_around(VertexId::new(2)).eq([4, 6, 3, 1].map(HalfedgeId::new)));
    /// # Ok(()) }
    /// ```
    pub fn halfedges_around(&self, vertex: VertexId) -> impl Iterator<Item = HalfedgeId> {
        self.orbits.rotation.list(vertex.index()).iter().map(|&h| HalfedgeId::from_u32(h))
    }

    /// The halfedge after this one around the face on its left.
    ///
    /// # Panics
    /// If there is no such halfedge.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::HalfedgeId;
    /// use coface_arrange::planar::PlanarArrangement;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(2, vec![0., 0., 0., 1., 1., 0.])?;
    /// let triangle = PlanarArrangement::new(&corners, &[[0, 1], [1, 2], [2, 0]])?;
    /// // Around the triangle: from (0, 0) to (1, 0), and on to (0, 1).
    /// assert_eq!(triangle.next(HalfedgeId::new(2)), HalfedgeId::new(5));
    /// # Ok(()) }
    /// ```
    pub fn next(&self, halfedge: HalfedgeId) -> HalfedgeId {
        HalfedgeId::from_u32(self.orbits.next[halfedge.index()])
    }

    /// The face on the left of a halfedge; `None` for the unbounded one.
    ///
    /// # Panics
    /// If there is no such halfedge.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{FaceId, HalfedgeId};
    /// use coface_arrange::planar::PlanarArrangement;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(2, vec![0., 0., 0., 1., 1., 0.])?;
    /// let triangle = PlanarArrangement::new(&corners, &[[0, 1], [1, 2], [2, 0]])?;
    /// // The edge from (0, 0) up to (0, 1) has the triangle on its right.
    /// assert_eq!([0, 1].map(|h| triangle.face_of(HalfedgeId::new(h))), [None, Some(FaceId::new(0))]);
    /// # Ok(()) }
    /// ```
    pub fn face_of(&self, halfedge: HalfedgeId) -> Option<FaceId> {
        let face = self.faces.of_orbit[self.orbits.orbit_of[halfedge.index()] as usize];
        (face != NONE).then(|| FaceId::from_u32(face))
    }

    /// The closed walks around a face as lists of halfedges with the face on their left: of a bounded face the outer
    /// one first, counterclockwise, then one around each hole. A walk runs over a dangling edge twice.
    ///
    /// # Panics
    /// If there is no such face.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::FaceId;
    /// use coface_arrange::planar::PlanarArrangement;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(2, vec![0., 0., 0., 1., 1., 0.])?;
    /// let triangle = PlanarArrangement::new(&corners, &[[0, 1], [1, 2], [2, 0]])?;
    /// assert_eq!(triangle.walks(Some(FaceId::new(0))).collect::<Vec<_>>(), [[1, 2, 5]]);
    /// assert_eq!(triangle.walks(None).len(), 1);
    /// # Ok(()) }
    /// ```
    pub fn walks(&self, face: Option<FaceId>) -> impl ExactSizeIterator<Item = &[u32]> {
        let orbits = match face {
            Some(face) => self.faces.orbits.list(face.index()),
            None => &self.faces.unbounded_orbits,
        };
        orbits.iter().map(|&orbit| self.orbits.orbits.list(orbit as usize))
    }

    /// The component of a vertex, below [`Self::component_count`].
    ///
    /// # Panics
    /// If there is no such vertex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{RaggedArray, VertexId};
    /// use coface_arrange::planar::PlanarArrangement;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A triangle within a triangle.
    /// let corners = Positions::from_flat(2, vec![0., 0., 9., 0., 0., 9., 1., 1., 2., 1., 1., 2.])?;
    /// let walks = RaggedArray::from_lists([[0, 1, 2, 0], [3, 4, 5, 3]]);
    /// let nested = PlanarArrangement::from_polylines(&corners, &walks)?;
    /// assert_eq!(nested.component(VertexId::new(0)), 0);
    /// assert_eq!(nested.component(VertexId::new(2)), 1);
    /// # Ok(()) }
    /// ```
    pub fn component(&self, vertex: VertexId) -> usize {
        self.orbits.component_of[vertex.index()] as usize
    }

    /// The face that a component lies in; `None` for the unbounded one.
    ///
    /// # Panics
    /// If there is no such component.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{FaceId, RaggedArray};
    /// use coface_arrange::planar::PlanarArrangement;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A triangle within a triangle.
    /// let corners = Positions::from_flat(2, vec![0., 0., 9., 0., 0., 9., 1., 1., 2., 1., 1., 2.])?;
    /// let walks = RaggedArray::from_lists([[0, 1, 2, 0], [3, 4, 5, 3]]);
    /// let nested = PlanarArrangement::from_polylines(&corners, &walks)?;
    /// assert_eq!(nested.face_around_component(0), None);
    /// assert_eq!(nested.face_around_component(1), Some(FaceId::new(0)));
    /// # Ok(()) }
    /// ```
    pub fn face_around_component(&self, component: usize) -> Option<FaceId> {
        let face = self.faces.around_component[component];
        (face != NONE).then(|| FaceId::from_u32(face))
    }

    /// The chain complex of vertices, edges and bounded faces. The boundary of an edge is its upper minus its lower
    /// end; that of a face has coefficient 1 on edges that the face is on the left of, -1 on those it is on the right
    /// of, and 0 where it is on both sides.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] if a matrix does not fit in 32 bits.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::planar::PlanarArrangement;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(2, vec![0., 0., 0., 1., 1., 0.])?;
    /// let triangle = PlanarArrangement::new(&corners, &[[0, 1], [1, 2], [2, 0]])?;
    /// assert_eq!(triangle.coarse_complex()?.f_vector(), [3, 3, 1]);
    /// # Ok(()) }
    /// ```
    pub fn coarse_complex(&self) -> Result<ChainComplex, Error> {
        let edge_count = self.edge_count();
        let starts = (0..=edge_count as u32).map(|e| 2 * e).collect();
        let rows = self.ends.as_flattened().to_vec();
        let edges =
            SparseMatrix::from_trusted_parts(self.vertex_count(), starts, rows, [-1, 1].repeat(edge_count))?;
        let mut starts = vec![0u32; self.face_count() + 1];
        for (_, [left, right]) in self.separating_edges() {
            for face in [left, right].into_iter().filter(|&face| face != NONE) {
                starts[face as usize + 1] += 1;
            }
        }
        for face in 1..starts.len() {
            starts[face] += starts[face - 1];
        }
        let mut places = starts.clone();
        let entry_count = starts[self.face_count()] as usize;
        let (mut rows, mut entries) = (vec![0; entry_count], vec![0; entry_count]);
        for (edge, sides) in self.separating_edges() {
            for (face, sign) in sides.into_iter().zip([1, -1]).filter(|&(face, _)| face != NONE) {
                let place = &mut places[face as usize];
                rows[*place as usize] = edge;
                entries[*place as usize] = sign;
                *place += 1;
            }
        }
        let faces = SparseMatrix::from_trusted_parts(edge_count, starts, rows, entries)?;
        ChainComplex::new(vec![edges, faces])
    }

    /// The chain complex of vertices, edges and bounded faces, refined until each face is a disk: faces with holes are cut into
    /// triangles, and bridges join what is apart in a face. Its homology is that of the union of all edges, faces and
    /// vertices. [`Self::ball_complex`] says what is a piece of what.
    ///
    /// # Errors
    /// Those of [`Self::ball_complex`].
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::planar::PlanarArrangement;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A triangle with a triangular hole in its inner face.
    /// let corners = vec![0., 0., 6., 0., 0., 6., 1., 1., 2., 1., 1., 2.];
    /// let corners = Positions::from_flat(2, corners)?;
    /// let nested = PlanarArrangement::new(&corners, &[[0, 1], [1, 2], [2, 0], [3, 4], [4, 5], [5, 3]])?;
    /// assert_eq!(nested.coarse_complex()?.f_vector(), [6, 6, 2]);
    /// // The ring is six triangles.
    /// assert_eq!(nested.chain_complex()?.f_vector(), [6, 12, 7]);
    /// # Ok(()) }
    /// ```
    pub fn chain_complex(&self) -> Result<ChainComplex, Error> {
        Ok(self.ball_complex()?.0)
    }

    /// The boundary of the unbounded face: edges, rising, with 1 if it is on their left and -1 if it is on their right.
    /// With the boundaries of all bounded faces it adds up to zero.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::EdgeId;
    /// use coface_arrange::planar::PlanarArrangement;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = Positions::from_flat(2, vec![0., 0., 0., 1., 1., 0.])?;
    /// let triangle = PlanarArrangement::new(&corners, &[[0, 1], [1, 2], [2, 0]])?;
    /// // The outside is on the left of the first and the last edge.
    /// assert_eq!(triangle.unbounded_boundary(), [(0, 1), (1, -1), (2, 1)].map(|(e, sign)| (EdgeId::new(e), sign)));
    /// # Ok(()) }
    /// ```
    pub fn unbounded_boundary(&self) -> Vec<(EdgeId, i32)> {
        let sign = |[left, right]: [u32; 2]| i32::from(left == NONE) - i32::from(right == NONE);
        let edges = self.separating_edges().map(|(edge, sides)| (EdgeId::from_u32(edge), sign(sides)));
        edges.filter(|&(_, sign)| sign != 0).collect()
    }

    /// Whether an edge has the same face on both sides: it dangles, or it is a bridge.
    ///
    /// # Panics
    /// If there is no such edge.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::EdgeId;
    /// use coface_arrange::planar::PlanarArrangement;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two segments that cross in (1, 1).
    /// let ends = Positions::from_flat(2, vec![0., 0., 2., 2., 0., 2., 2., 0.])?;
    /// let cross = PlanarArrangement::new(&ends, &[[0, 1], [2, 3]])?;
    /// assert!(cross.is_bridge(EdgeId::new(0)));
    /// # Ok(()) }
    /// ```
    pub fn is_bridge(&self, edge: EdgeId) -> bool {
        let [left, right] = self.sides(edge.to_u32());
        left == right
    }

    /// The edges with different faces on their left and on their right.
    pub(super) fn separating_edges(&self) -> impl Iterator<Item = (u32, [u32; 2])> {
        (0..self.ends.len() as u32)
            .map(|edge| (edge, self.sides(edge)))
            .filter(|&(_, [left, right])| left != right)
    }

    /// The faces on the left and on the right of an edge.
    pub(super) fn sides(&self, edge: u32) -> [u32; 2] {
        [2 * edge, 2 * edge + 1].map(|h| self.faces.of_orbit[self.orbits.orbit_of[h as usize] as usize])
    }
}
