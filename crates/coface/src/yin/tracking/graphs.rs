//! Interfaces that move.

use super::markers::{MarkerRange, MovedMarkers, moved_markers, polyline_length};
use super::{TrackingCounts, TrackingOptions};
use crate::Error;
use crate::yin::{DirectedEdge, InterfaceGraph};

/// An interface that has moved.
#[derive(Clone, Debug)]
pub struct TrackedGraph {
    graph: InterfaceGraph,
    counts: TrackingCounts,
    vanished: Vec<(f64, u32)>,
    edges: Vec<u32>,
}

impl TrackedGraph {
    /// The interface at the end.
    pub fn graph(&self) -> &InterfaceGraph {
        &self.graph
    }

    /// What happened to markers.
    pub fn counts(&self) -> TrackingCounts {
        self.counts
    }

    /// The closed edges that became too short and were taken out, each with the time and its number at the beginning.
    pub fn vanished(&self) -> &[(f64, u32)] {
        &self.vanished
    }

    /// For each edge its number at the beginning.
    pub fn edges(&self) -> &[u32] {
        &self.edges
    }
}

impl InterfaceGraph {
    /// The interface after all its points have moved with a velocity, which depends on the point and the time.
    ///
    /// Vertices stay vertices and edges stay edges, each fitted anew after each step. Closed edges at vertices of their own vanish when
    /// they are shorter than three times the least distance of markers. Other edges stay, however short.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](crate::ErrorKind::InvalidInput) for options without meaning, a velocity that is not finite, and an
    /// interface that cannot be fitted any more; the time is named.
    ///
    /// # Complexity
    /// Linear in markers times steps, in parallel over markers.
    ///
    /// # Examples
    /// ```
    /// use coface::yin::{DirectedEdge, Flow, InterfaceEdge, InterfaceGraph, Order, TrackingOptions};
    /// # fn main() -> Result<(), coface::Error> {
    /// let circle = (0..32).map(|i| f64::from(i) * std::f64::consts::PI / 16.0).map(|t| [t.cos(), t.sin()]).collect::<Vec<_>>();
    /// let edge = InterfaceEdge { ends: [0, 0], markers: circle[1..].to_vec(), phases: [Some(0), Some(1)] };
    /// let base_point = [DirectedEdge::along(0), DirectedEdge::along(0)];
    /// let graph = InterfaceGraph::new(&circle[..1], &[edge], &[base_point], Order::CUBIC)?;
    /// let shift = Flow::Translation { velocity: [1.0, 0.0] };
    /// let moved = graph.advected(|point, time| shift.velocity(point, time), &TrackingOptions::new(2.0, 0.5, 0.2))?;
    /// assert!((moved.graph().phase_area(0)? - graph.phase_area(0)?).abs() < 1e-12);
    /// # Ok(()) }
    /// ```
    pub fn advected(
        &self,
        velocity: impl Fn([f64; 2], f64) -> [f64; 2] + Sync,
        options: &TrackingOptions,
    ) -> Result<TrackedGraph, Error> {
        let (steps, step) = options.steps()?;
        let range = MarkerRange { least: options.least_ratio * options.spacing, most: options.spacing };
        let mut graph = self.clone();
        let mut counts = TrackingCounts { steps, ..TrackingCounts::default() };
        let mut vanished = Vec::new();
        let mut numbers: Vec<u32> = (0..self.edge_count() as u32).collect();
        for at in 0..steps {
            let time = options.start + at as f64 * step;
            let map = |point| options.scheme.mapped(&velocity, point, time, step);
            let mut points = Vec::with_capacity(graph.edge_count());
            for edge in 0..graph.edge_count() {
                let MovedMarkers { points: own, .. } =
                    moved_markers(graph.curve(edge), |_| false, &map, range, &mut counts)?;
                points.push(own);
            }
            let mut vertices: Vec<[f64; 2]> = graph.vertices().iter().map(|&vertex| map(vertex)).collect();
            for (edge, own) in points.iter().enumerate() {
                // Bit for bit what the edges have.
                let [start, end] = graph.ends(edge).map(|end| end as usize);
                (vertices[start], vertices[end]) = (own[0], own[own.len() - 1]);
            }
            let is_gone = |edge: usize| {
                let [start, end] = graph.ends(edge);
                let is_alone = start == end && graph.degree(start as usize) == 2;
                is_alone && (points[edge].len() < 4 || polyline_length(&points[edge]) < 3.0 * range.least)
            };
            let stays: Vec<bool> = (0..graph.edge_count()).map(|edge| !is_gone(edge)).collect();
            let end_time = time + step;
            for edge in (0..stays.len()).filter(|&edge| !stays[edge]) {
                vanished.push((end_time, numbers[edge]));
            }
            graph = graph.moved(vertices, &points, &stays).map_err(|error| at_time(&error, end_time))?;
            let mut kept = stays.iter();
            numbers.retain(|_| *kept.next().expect("there is an entry for each edge"));
        }
        Ok(TrackedGraph { graph, counts, vanished, edges: numbers })
    }

    /// The same graph with vertices and the points of edges elsewhere, and only the edges that stay.
    fn moved(
        &self,
        vertices: Vec<[f64; 2]>,
        points: &[Vec<[f64; 2]>],
        stays: &[bool],
    ) -> Result<Self, Error> {
        let mut numbers = vec![u32::MAX; stays.len()];
        let mut count = 0;
        for edge in 0..stays.len() {
            if stays[edge] {
                numbers[edge] = count;
                count += 1;
            }
        }
        fn kept<T: Clone>(all: impl Iterator<Item = T>, stays: &[bool]) -> Vec<T> {
            all.zip(stays).filter(|(_, stays)| **stays).map(|(item, _)| item).collect()
        }
        let ends = kept((0..stays.len()).map(|edge| self.ends(edge)), stays);
        let phases = kept((0..stays.len()).map(|edge| self.phases_of(edge)), stays);
        let points: Vec<Vec<[f64; 2]>> = kept(points.iter().cloned(), stays);
        let renumbered = |edge: DirectedEdge| DirectedEdge { edge: numbers[edge.edge as usize], ..edge };
        let pairs = self.smooth_pairs().iter().map(|pair| pair.map(renumbered));
        let pairs = pairs.filter(|pair| pair[0].edge != u32::MAX && pair[1].edge != u32::MAX).collect();
        Self::with_points(vertices, ends, phases, &points, pairs, self.order())
    }
}

/// The same error, with the time at which it came.
pub(super) fn at_time(error: &Error, time: f64) -> Error {
    let said = Error::new(error.kind(), format!("at time {time}: {}", error.message()));
    match error.cure() {
        Some(cure) => said.with_cure(cure),
        None => said,
    }
}
