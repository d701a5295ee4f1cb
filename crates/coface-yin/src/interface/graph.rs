//! Graphs of interfaces.

use super::trails::{DirectedEdge, Trail, fitted_edges, trails_of};
use crate::{Curve, Order};
use coface_algebra::{EdgeId, Error, Sign, VertexId};

/// An arc of an interface.
#[derive(Clone, Debug, PartialEq)]
pub struct InterfaceEdge {
    /// The vertices where it starts and ends; twice the same for closed edges.
    pub ends: [u32; 2],
    /// The points between its ends that it runs through.
    pub markers: Vec<[f64; 2]>,
    /// The phases on its left and on its right.
    pub phases: [Option<u32>; 2],
}

/// Vertices, and how edges lie between them and phases.
#[derive(Clone, Debug)]
pub(crate) struct Arcs {
    pub(crate) vertices: Vec<[f64; 2]>,
    pub(crate) ends: Vec<[u32; 2]>,
    pub(crate) phases: Vec<[Option<u32>; 2]>,
    pub(crate) smooth_pairs: Vec<[DirectedEdge; 2]>,
}

/// Phases that share the arcs of their boundaries.
///
/// Each edge is one curve, the same numbers for the phases on both of its sides, so that these fit together bit for bit.
///
/// # Examples
/// A unit square in two phases, left and right of the line x = 1/2.
/// ```
/// use coface_yin::{InterfaceEdge, InterfaceGraph, Order};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let vertices = [[0.5, 0.0], [0.5, 1.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0], [0.0, 0.0]];
/// let edge = |ends, left, right| InterfaceEdge { ends, markers: vec![], phases: [left, right] };
/// let edges = [
///     edge([0, 1], Some(0), Some(1)),
///     edge([0, 3], Some(1), None),
///     edge([3, 2], Some(1), None),
///     edge([2, 1], Some(1), None),
///     edge([1, 4], Some(0), None),
///     edge([4, 5], Some(0), None),
///     edge([5, 0], Some(0), None),
/// ];
/// let graph = InterfaceGraph::new(&vertices, &edges, &[], Order::CUBIC)?;
/// assert_eq!(graph.phase_curves(0)?.len(), 1);
/// assert_eq!((graph.phase_area(0)?, graph.phase_area(1)?), (0.5, 0.5));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct InterfaceGraph {
    pub(super) order: Order,
    pub(super) vertices: Vec<[f64; 2]>,
    pub(super) ends: Vec<[u32; 2]>,
    pub(super) phases: Vec<[Option<u32>; 2]>,
    pub(super) smooth_pairs: Vec<[DirectedEdge; 2]>,
    trails: Vec<Trail>,
    pub(super) curves: Vec<Curve<'static>>,
    /// The edges that leave each vertex, counterclockwise.
    pub(super) around: Vec<Vec<DirectedEdge>>,
}

impl InterfaceGraph {
    /// The graph with these vertices and edges. A smooth pair is an edge that comes to a vertex and the one by which the way goes on.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) naming the edge, vertex or pair: an end that is no vertex, a pair whose
    /// edges do not meet or one of which is in another pair at the same end, points that cannot be fitted, edges that leave a vertex in
    /// the same direction, and neighbors around a vertex that do not agree on the phase between them.
    ///
    /// # Complexity
    /// Linear in the markers, but for sorting the edges around each vertex.
    ///
    /// # Examples
    /// One triangle, whose boundary is an edge from a base point to itself.
    /// ```
    /// use coface_algebra::EdgeId;
    /// use coface_yin::{DirectedEdge, InterfaceEdge, InterfaceGraph, Order};
    /// let edge = InterfaceEdge { ends: [0, 0], markers: vec![[1.0, 0.0], [0.0, 1.0]], phases: [Some(0), None] };
    /// let around = [DirectedEdge::along(EdgeId::new(0)); 2];
    /// let graph = InterfaceGraph::new(&[[0.0, 0.0]], &[edge], &[around], Order::LINEAR)?;
    /// assert_eq!(graph.phase_area(0)?, 0.5);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn new(
        vertices: &[[f64; 2]],
        edges: &[InterfaceEdge],
        smooth_pairs: &[[DirectedEdge; 2]],
        order: Order,
    ) -> Result<Self, Error> {
        check_edges(vertices, edges.iter().map(|edge| (edge.ends, edge.phases)))?;
        let points: Vec<Vec<[f64; 2]>> = edges
            .iter()
            .map(|edge| {
                let [start, end] = edge.ends.map(|end| vertices[end as usize]);
                std::iter::once(start).chain(edge.markers.iter().copied()).chain([end]).collect()
            })
            .collect();
        let ends = edges.iter().map(|edge| edge.ends).collect();
        let phases = edges.iter().map(|edge| edge.phases).collect();
        let (vertices, smooth_pairs) = (vertices.to_vec(), smooth_pairs.to_vec());
        Self::with_points(Arcs { vertices, ends, phases, smooth_pairs }, &points, &[], order, None)
    }

    /// The graph with these vertices, and edges that are these curves; nothing is fitted. `ends` and `phases` (on the left and on the right)
    /// are those of the edges.
    ///
    /// # Errors
    /// Those of [`Self::new`]; and a curve of another order, or one that does not begin and end at the vertices of its edge.
    ///
    /// # Complexity
    /// Linear in the pieces, but for sorting the edges around each vertex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::EdgeId;
    /// use coface_yin::{DirectedEdge, InterfaceEdge, InterfaceGraph, Order};
    /// let edge = InterfaceEdge { ends: [0, 0], markers: vec![[1.0, 0.0], [0.0, 1.0]], phases: [Some(0), None] };
    /// let graph = InterfaceGraph::new(&[[0.0, 0.0]], &[edge], &[], Order::LINEAR)?;
    /// let curves = vec![graph.curve(EdgeId::new(0)).clone()];
    /// let again = InterfaceGraph::from_curves(&[[0.0, 0.0]], &[[0, 0]], &[[Some(0), None]], curves, &[], Order::LINEAR)?;
    /// assert_eq!(again.phase_area(0)?, 0.5);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn from_curves(
        vertices: &[[f64; 2]],
        ends: &[[u32; 2]],
        phases: &[[Option<u32>; 2]],
        curves: Vec<Curve<'static>>,
        smooth_pairs: &[[DirectedEdge; 2]],
        order: Order,
    ) -> Result<Self, Error> {
        if ends.len() != curves.len() || phases.len() != curves.len() {
            return Err(Error::invalid(format!(
                "there are {} curves, ends of {} edges and phases of {}",
                curves.len(),
                ends.len(),
                phases.len()
            ))
            .with_cure("give ends and phases for each curve"));
        }
        check_edges(vertices, ends.iter().copied().zip(phases.iter().copied()))?;
        for (number, (curve, own)) in curves.iter().zip(ends).enumerate() {
            let [start, end] = own.map(|end| vertices[end as usize]);
            let points = [curve.knot_point(0), curve.knot_point(curve.piece_count())];
            if curve.order() != order || points != [start, end] {
                return Err(Error::invalid(format!(
                    "edge {number} has a curve of another order, or one that does not lead from vertex {} to vertex {}",
                    own[0], own[1]
                ))
                .with_cure("give a curve of the order of the interface that begins and ends at its vertices"));
            }
            let is_point =
                |piece: usize| curve.piece(piece).iter().all(|point| *point == curve.piece(piece)[0]);
            if let Some(piece) = (0..curve.piece_count()).find(|&piece| is_point(piece)) {
                return Err(Error::invalid(format!("piece {piece} of edge {number} has no length"))
                    .with_cure("leave the piece out"));
            }
        }
        let (ends, phases) = (ends.to_vec(), phases.to_vec());
        let (vertices, smooth_pairs) = (vertices.to_vec(), smooth_pairs.to_vec());
        let trails = trails_of(&ends, &smooth_pairs)?;
        Self::of_fitted(Arcs { vertices, ends, phases, smooth_pairs }, trails, curves, order, None)
    }

    /// The graph whose edges run through these points, the ends among them, with these parameters where they are given. The edges that leave
    /// each vertex, counterclockwise, may be known; else their directions tell.
    pub(crate) fn with_points(
        arcs: Arcs,
        points: &[Vec<[f64; 2]>],
        parameters: &[Option<Vec<f64>>],
        order: Order,
        around: Option<Vec<Vec<DirectedEdge>>>,
    ) -> Result<Self, Error> {
        let trails = trails_of(&arcs.ends, &arcs.smooth_pairs)?;
        // Each edge is in one trail.
        let mut curves = fitted_edges(points, parameters, &trails, order)?;
        curves.sort_unstable_by_key(|&(edge, _)| edge);
        let curves = curves.into_iter().map(|(_, curve)| curve).collect();
        Self::of_fitted(arcs, trails, curves, order, around)
    }

    /// The graph whose edges are these curves.
    pub(crate) fn with_curves(
        arcs: Arcs,
        curves: Vec<Curve<'static>>,
        order: Order,
        around: Vec<Vec<DirectedEdge>>,
    ) -> Result<Self, Error> {
        let trails = trails_of(&arcs.ends, &arcs.smooth_pairs)?;
        Self::of_fitted(arcs, trails, curves, order, Some(around))
    }

    fn of_fitted(
        arcs: Arcs,
        trails: Vec<Trail>,
        curves: Vec<Curve<'static>>,
        order: Order,
        around: Option<Vec<Vec<DirectedEdge>>>,
    ) -> Result<Self, Error> {
        let Arcs { vertices, ends, phases, smooth_pairs } = arcs;
        let mut graph =
            Self { order, vertices, ends, phases, smooth_pairs, trails, curves, around: Vec::new() };
        graph.around = match around {
            Some(around) => around,
            None => graph.edges_around()?,
        };
        graph.check_sectors()?;
        Ok(graph)
    }

    /// The number of coefficients of the polynomials of the edges.
    ///
    /// # Examples
    /// One triangle, whose boundary is an edge from a base point to itself.
    /// ```
    /// use coface_algebra::EdgeId;
    /// use coface_yin::{DirectedEdge, InterfaceEdge, InterfaceGraph, Order};
    /// let edge = InterfaceEdge { ends: [0, 0], markers: vec![[1.0, 0.0], [0.0, 1.0]], phases: [Some(0), None] };
    /// let around = [DirectedEdge::along(EdgeId::new(0)); 2];
    /// let graph = InterfaceGraph::new(&[[0.0, 0.0]], &[edge], &[around], Order::LINEAR)?;
    /// assert_eq!(graph.order(), Order::LINEAR);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn order(&self) -> Order {
        self.order
    }

    /// The points where edges end.
    ///
    /// # Examples
    /// One triangle, whose boundary is an edge from a base point to itself.
    /// ```
    /// use coface_algebra::EdgeId;
    /// use coface_yin::{DirectedEdge, InterfaceEdge, InterfaceGraph, Order};
    /// let edge = InterfaceEdge { ends: [0, 0], markers: vec![[1.0, 0.0], [0.0, 1.0]], phases: [Some(0), None] };
    /// let around = [DirectedEdge::along(EdgeId::new(0)); 2];
    /// let graph = InterfaceGraph::new(&[[0.0, 0.0]], &[edge], &[around], Order::LINEAR)?;
    /// assert_eq!(graph.vertices(), [[0.0, 0.0]]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn vertices(&self) -> &[[f64; 2]] {
        &self.vertices
    }

    /// The number of edges.
    ///
    /// # Examples
    /// One triangle, whose boundary is an edge from a base point to itself.
    /// ```
    /// use coface_algebra::EdgeId;
    /// use coface_yin::{DirectedEdge, InterfaceEdge, InterfaceGraph, Order};
    /// let edge = InterfaceEdge { ends: [0, 0], markers: vec![[1.0, 0.0], [0.0, 1.0]], phases: [Some(0), None] };
    /// let around = [DirectedEdge::along(EdgeId::new(0)); 2];
    /// let graph = InterfaceGraph::new(&[[0.0, 0.0]], &[edge], &[around], Order::LINEAR)?;
    /// assert_eq!(graph.edge_count(), 1);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn edge_count(&self) -> usize {
        self.ends.len()
    }

    /// The vertices where an edge starts and ends.
    ///
    /// # Panics
    /// If there is no such edge.
    ///
    /// # Examples
    /// One triangle, whose boundary is an edge from a base point to itself.
    /// ```
    /// use coface_algebra::{EdgeId, VertexId};
    /// use coface_yin::{DirectedEdge, InterfaceEdge, InterfaceGraph, Order};
    /// let edge = InterfaceEdge { ends: [0, 0], markers: vec![[1.0, 0.0], [0.0, 1.0]], phases: [Some(0), None] };
    /// let around = [DirectedEdge::along(EdgeId::new(0)); 2];
    /// let graph = InterfaceGraph::new(&[[0.0, 0.0]], &[edge], &[around], Order::LINEAR)?;
    /// assert_eq!(graph.ends(EdgeId::new(0)), [VertexId::new(0); 2]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn ends(&self, edge: EdgeId) -> [VertexId; 2] {
        self.ends[edge.index()].map(VertexId::from_u32)
    }

    /// The phases on the left and on the right of an edge.
    ///
    /// # Panics
    /// If there is no such edge.
    ///
    /// # Examples
    /// One triangle, whose boundary is an edge from a base point to itself.
    /// ```
    /// use coface_algebra::EdgeId;
    /// use coface_yin::{DirectedEdge, InterfaceEdge, InterfaceGraph, Order};
    /// let edge = InterfaceEdge { ends: [0, 0], markers: vec![[1.0, 0.0], [0.0, 1.0]], phases: [Some(0), None] };
    /// let around = [DirectedEdge::along(EdgeId::new(0)); 2];
    /// let graph = InterfaceGraph::new(&[[0.0, 0.0]], &[edge], &[around], Order::LINEAR)?;
    /// assert_eq!(graph.phases_of(EdgeId::new(0)), [Some(0), None]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn phases_of(&self, edge: EdgeId) -> [Option<u32>; 2] {
        self.phases[edge.index()]
    }

    /// The curve of an edge.
    ///
    /// # Panics
    /// If there is no such edge.
    ///
    /// # Examples
    /// One triangle, whose boundary is an edge from a base point to itself.
    /// ```
    /// use coface_algebra::EdgeId;
    /// use coface_yin::{DirectedEdge, InterfaceEdge, InterfaceGraph, Order};
    /// let edge = InterfaceEdge { ends: [0, 0], markers: vec![[1.0, 0.0], [0.0, 1.0]], phases: [Some(0), None] };
    /// let around = [DirectedEdge::along(EdgeId::new(0)); 2];
    /// let graph = InterfaceGraph::new(&[[0.0, 0.0]], &[edge], &[around], Order::LINEAR)?;
    /// assert_eq!(graph.curve(EdgeId::new(0)).piece_count(), 3);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn curve(&self, edge: EdgeId) -> &Curve<'static> {
        &self.curves[edge.index()]
    }

    /// The edges that were fitted together.
    ///
    /// # Examples
    /// One triangle, whose boundary is an edge from a base point to itself.
    /// ```
    /// use coface_algebra::EdgeId;
    /// use coface_yin::{DirectedEdge, InterfaceEdge, InterfaceGraph, Order};
    /// let edge = InterfaceEdge { ends: [0, 0], markers: vec![[1.0, 0.0], [0.0, 1.0]], phases: [Some(0), None] };
    /// let around = [DirectedEdge::along(EdgeId::new(0)); 2];
    /// let graph = InterfaceGraph::new(&[[0.0, 0.0]], &[edge], &[around], Order::LINEAR)?;
    /// assert!(graph.trails()[0].is_circuit());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn trails(&self) -> &[Trail] {
        &self.trails
    }

    /// The pairs of an edge that comes to a vertex and the one by which it goes on smoothly.
    ///
    /// # Examples
    /// One triangle, whose boundary is an edge from a base point to itself.
    /// ```
    /// use coface_algebra::EdgeId;
    /// use coface_yin::{DirectedEdge, InterfaceEdge, InterfaceGraph, Order};
    /// let edge = InterfaceEdge { ends: [0, 0], markers: vec![[1.0, 0.0], [0.0, 1.0]], phases: [Some(0), None] };
    /// let around = [DirectedEdge::along(EdgeId::new(0)); 2];
    /// let graph = InterfaceGraph::new(&[[0.0, 0.0]], &[edge], &[around], Order::LINEAR)?;
    /// assert_eq!(graph.smooth_pairs(), [around]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn smooth_pairs(&self) -> &[[DirectedEdge; 2]] {
        &self.smooth_pairs
    }

    /// The number of ends of edges at a vertex.
    ///
    /// # Panics
    /// If there is no such vertex.
    ///
    /// # Examples
    /// One triangle, whose boundary is an edge from a base point to itself.
    /// ```
    /// use coface_algebra::{EdgeId, VertexId};
    /// use coface_yin::{DirectedEdge, InterfaceEdge, InterfaceGraph, Order};
    /// let edge = InterfaceEdge { ends: [0, 0], markers: vec![[1.0, 0.0], [0.0, 1.0]], phases: [Some(0), None] };
    /// let around = [DirectedEdge::along(EdgeId::new(0)); 2];
    /// let graph = InterfaceGraph::new(&[[0.0, 0.0]], &[edge], &[around], Order::LINEAR)?;
    /// assert_eq!(graph.degree(VertexId::new(0)), 2);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn degree(&self, vertex: VertexId) -> usize {
        self.around[vertex.index()].len()
    }

    /// The vertices at which three or more edges end.
    ///
    /// # Examples
    /// One triangle, whose boundary is an edge from a base point to itself.
    /// ```
    /// use coface_algebra::EdgeId;
    /// use coface_yin::{DirectedEdge, InterfaceEdge, InterfaceGraph, Order};
    /// let edge = InterfaceEdge { ends: [0, 0], markers: vec![[1.0, 0.0], [0.0, 1.0]], phases: [Some(0), None] };
    /// let around = [DirectedEdge::along(EdgeId::new(0)); 2];
    /// let graph = InterfaceGraph::new(&[[0.0, 0.0]], &[edge], &[around], Order::LINEAR)?;
    /// assert_eq!(graph.junctions().count(), 0);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn junctions(&self) -> impl Iterator<Item = VertexId> + '_ {
        (0..self.vertices.len()).map(VertexId::new).filter(|&vertex| self.degree(vertex) > 2)
    }

    /// The phases that edges name, rising.
    ///
    /// # Examples
    /// One triangle, whose boundary is an edge from a base point to itself.
    /// ```
    /// use coface_algebra::EdgeId;
    /// use coface_yin::{DirectedEdge, InterfaceEdge, InterfaceGraph, Order};
    /// let edge = InterfaceEdge { ends: [0, 0], markers: vec![[1.0, 0.0], [0.0, 1.0]], phases: [Some(0), None] };
    /// let around = [DirectedEdge::along(EdgeId::new(0)); 2];
    /// let graph = InterfaceGraph::new(&[[0.0, 0.0]], &[edge], &[around], Order::LINEAR)?;
    /// assert_eq!(graph.phases(), [0]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn phases(&self) -> Vec<u32> {
        let mut found: Vec<u32> = self.phases.iter().flatten().copied().flatten().collect();
        found.sort_unstable();
        found.dedup();
        found
    }

    /// The phases on both sides of all edges.
    pub(crate) fn phases_mut(&mut self) -> impl Iterator<Item = &mut Option<u32>> {
        self.phases.as_flattened_mut().iter_mut()
    }

    /// The edges that leave a vertex, counterclockwise.
    ///
    /// # Panics
    /// If there is no such vertex.
    ///
    /// # Examples
    /// One triangle, whose boundary is an edge from a base point to itself.
    /// ```
    /// use coface_algebra::{EdgeId, VertexId};
    /// use coface_yin::{DirectedEdge, InterfaceEdge, InterfaceGraph, Order};
    /// let edge = InterfaceEdge { ends: [0, 0], markers: vec![[1.0, 0.0], [0.0, 1.0]], phases: [Some(0), None] };
    /// let around = [DirectedEdge::along(EdgeId::new(0)); 2];
    /// let graph = InterfaceGraph::new(&[[0.0, 0.0]], &[edge], &[around], Order::LINEAR)?;
    /// assert_eq!(graph.edges_at(VertexId::new(0)).len(), 2);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn edges_at(&self, vertex: VertexId) -> &[DirectedEdge] {
        &self.around[vertex.index()]
    }

    /// The vertex from which a directed edge leads.
    pub(super) fn tail(&self, edge: DirectedEdge) -> usize {
        self.ends[edge.edge.index()][usize::from(edge.sign == Sign::Minus)] as usize
    }

    /// The vertex to which a directed edge leads.
    pub(super) fn head(&self, edge: DirectedEdge) -> usize {
        self.tail(edge.reversed())
    }

    /// The phase on the left of a directed edge.
    pub(crate) fn left(&self, edge: DirectedEdge) -> Option<u32> {
        self.phases[edge.edge.index()][usize::from(edge.sign == Sign::Minus)]
    }
}

/// Whether edges, given by their ends and their phases, end at vertices and have different phases on their sides.
fn check_edges(
    vertices: &[[f64; 2]],
    edges: impl Iterator<Item = ([u32; 2], [Option<u32>; 2])>,
) -> Result<(), Error> {
    for (number, (ends, [left, right])) in edges.enumerate() {
        if let Some(end) = ends.iter().find(|&&end| end as usize >= vertices.len()) {
            return Err(Error::invalid(format!("edge {number} ends at vertex {end}, which there is not"))
                .with_cure(format!("give ends below {}", vertices.len())));
        }
        if left == right {
            return Err(Error::invalid(format!("edge {number} has the same phase on both sides"))
                .with_cure("leave out the edge"));
        }
    }
    Ok(())
}
