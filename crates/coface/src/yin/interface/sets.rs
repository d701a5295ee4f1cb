//! Interfaces of Yin sets that lie side by side.

use super::{DirectedEdge, InterfaceEdge, InterfaceGraph};
use crate::Error;
use crate::yin::{Kinks, KnotIndex, Order, YinSet};
use std::collections::BTreeSet;

const NONE: u32 = u32::MAX;

/// A segment between two points by their numbers, the first one lower, with the sets on its sides.
struct Segment {
    points: [u32; 2],
    sides: [Option<u32>; 2],
}

impl InterfaceGraph {
    /// The interface of sets of order 2 that share parts of their boundaries segment by segment: set i becomes phase i.
    ///
    /// Points where three or more segments end become junctions, and kinks of the sets vertices; between them the boundary is fitted as
    /// a spline of the given order through the corners of the sets. At a junction two edges go on smoothly into each other when the way
    /// turns by at most `smooth_angle` (radians) there, the ones that turn least first; with 0 only straight ways do, and with a negative
    /// number none.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](crate::ErrorKind::InvalidInput) for a set of another order, for two sets on the same side of a segment,
    /// and as [`Self::new`]: so for sets that overlap at a vertex, and where a vertex of one set lies on a segment of another.
    ///
    /// # Complexity
    /// $O(n \log n)$ for n segments.
    ///
    /// # Examples
    /// Two squares side by side: the segment between them is one edge.
    /// ```
    /// use coface::yin::{Curve, InterfaceGraph, Order, YinSet};
    /// # fn main() -> Result<(), coface::Error> {
    /// let left = Curve::polyline(&[[0., 0.], [1., 0.], [1., 1.], [0., 1.], [0., 0.]])?;
    /// let right = left.translated([1.0, 0.0]);
    /// let sets = [YinSet::new(&[left])?, YinSet::new(&[right])?];
    /// let graph = InterfaceGraph::of_sets(&sets, Order::LINEAR, -1.0)?;
    /// assert_eq!((graph.edge_count(), graph.junctions().count()), (3, 2));
    /// assert_eq!(graph.phase_area(1)?, 1.0);
    /// # Ok(()) }
    /// ```
    pub fn of_sets(sets: &[YinSet], order: Order, smooth_angle: f64) -> Result<Self, Error> {
        if let Some(set) = sets.iter().position(|set| set.order() != Order::LINEAR) {
            return Err(Error::invalid(format!("set {set} has order {}, not 2", sets[set].order()))
                .with_cure("give sets of polylines; they are fitted together"));
        }
        let plain = |point: [f64; 2]| point.map(|x| x + 0.0);
        let before = |a: &[f64; 2], b: &[f64; 2]| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1]));
        let mut points: Vec<[f64; 2]> = sets
            .iter()
            .flat_map(|set| (0..set.curve_count()).flat_map(|curve| set.curve(curve).controls().to_vec()))
            .map(plain)
            .collect();
        points.sort_unstable_by(before);
        points.dedup();
        let number = |point: [f64; 2]| {
            points.binary_search_by(|own| before(own, &plain(point))).expect("the point is among all") as u32
        };
        let mut kinks = BTreeSet::new();
        let mut segments: Vec<Segment> = Vec::new();
        for (phase, set) in sets.iter().enumerate() {
            let phase = Some(phase as u32);
            for curve in 0..set.curve_count() {
                let corners: Vec<u32> =
                    set.curve(curve).controls().iter().map(|&point| number(point)).collect();
                segments.extend(corners.windows(2).map(|pair| match (pair[0], pair[1]) {
                    (a, b) if a < b => Segment { points: [a, b], sides: [phase, None] },
                    (a, b) => Segment { points: [b, a], sides: [None, phase] },
                }));
            }
            let at = |kink: KnotIndex| number(set.curve(kink.curve as usize).knot_point(kink.knot as usize));
            kinks.extend(set.kinks().iter().map(|(kink, _)| at(kink)));
        }
        let segments = merged(segments, &points)?;
        let edges = chains(&segments, points.len(), &kinks);
        let mut vertices: Vec<u32> = edges.iter().flat_map(|(way, _)| [way[0], way[way.len() - 1]]).collect();
        vertices.sort_unstable();
        vertices.dedup();
        let place = |point: u32| vertices.binary_search(&point).expect("ends of edges are vertices") as u32;
        let interface_edges: Vec<InterfaceEdge> = edges
            .iter()
            .map(|(way, phases)| InterfaceEdge {
                ends: [place(way[0]), place(way[way.len() - 1])],
                markers: way[1..way.len() - 1].iter().map(|&point| points[point as usize]).collect(),
                phases: *phases,
            })
            .collect();
        let vertex_points: Vec<[f64; 2]> = vertices.iter().map(|&point| points[point as usize]).collect();
        // The polylines tell exactly whether the sets fit together.
        let polylines = Self::new(&vertex_points, &interface_edges, &[], Order::LINEAR)?;
        let is_kink: Vec<bool> = vertices.iter().map(|point| kinks.contains(point)).collect();
        let pairs = polylines.smooth_choices(smooth_angle, &is_kink);
        if order == Order::LINEAR && pairs.is_empty() {
            return Ok(polylines);
        }
        Self::new(&vertex_points, &interface_edges, &pairs, order)
    }

    /// A phase as a Yin set, with kinks at the vertices where its boundary does not go on smoothly.
    ///
    /// # Errors
    /// As [`Self::phase_curves`] and [`YinSet::new`]: fitted edges may cross where the polylines through their markers do not.
    ///
    /// # Examples
    /// ```
    /// use coface::yin::{InterfaceEdge, InterfaceGraph, Order};
    /// # fn main() -> Result<(), coface::Error> {
    /// let edge = InterfaceEdge { ends: [0, 0], markers: vec![[1.0, 0.0], [0.0, 1.0]], phases: [Some(0), None] };
    /// let triangle = InterfaceGraph::new(&[[0.0, 0.0]], &[edge], &[], Order::LINEAR)?.phase_set(0)?;
    /// assert_eq!((triangle.area(), triangle.kinks().len()), (Some(0.5), 1));
    /// # Ok(()) }
    /// ```
    pub fn phase_set(&self, phase: u32) -> Result<YinSet, Error> {
        let mut set = YinSet::new(&self.phase_curves(phase)?)?;
        let mut kinks = Vec::new();
        for (curve, walk) in self.phase_walks(phase).iter().enumerate() {
            let mut knot = 0;
            for (at, &edge) in walk.iter().enumerate() {
                let before = walk[(at + walk.len() - 1) % walk.len()];
                if !self.is_smooth(before, edge) {
                    kinks.push(KnotIndex { curve: curve as u32, knot });
                }
                knot += self.curve(edge.edge as usize).piece_count() as u32;
            }
        }
        *set.kinks_mut() = Kinks::new(kinks);
        Ok(set)
    }

    /// Whether the way goes on smoothly from one edge to another.
    fn is_smooth(&self, from: DirectedEdge, to: DirectedEdge) -> bool {
        let pairs = self.smooth_pairs();
        pairs.iter().any(|&[a, b]| (a, b) == (from, to) || (b.reversed(), a.reversed()) == (from, to))
    }

    /// The pairs of edges that go on into each other: at base points of closed edges, and where the way turns by at most an angle.
    fn smooth_choices(&self, angle: f64, is_kink: &[bool]) -> Vec<[DirectedEdge; 2]> {
        let mut pairs = Vec::new();
        for (vertex, leaving) in self.around.iter().enumerate() {
            if is_kink[vertex] {
                continue;
            }
            if let [a, b] = leaving[..] {
                pairs.push([a.reversed(), b]);
                continue;
            }
            let direction = |edge: DirectedEdge| {
                let controls = self.curves[edge.edge as usize].controls();
                let next = if edge == DirectedEdge::along(edge.edge) {
                    controls[1]
                } else {
                    controls[controls.len() - 2]
                };
                [0, 1].map(|axis| next[axis] - self.vertices[vertex][axis])
            };
            let mut choices: Vec<(f64, usize, usize)> = Vec::new();
            for i in 0..leaving.len() {
                for j in i + 1..leaving.len() {
                    let ([ax, ay], [bx, by]) = (direction(leaving[i]), direction(leaving[j]));
                    // The turn from coming along the first to leaving along the second.
                    let turn = (ay * bx - ax * by).atan2(-(ax * bx + ay * by)).abs();
                    if turn <= angle {
                        choices.push((turn, i, j));
                    }
                }
            }
            choices.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)).then(a.2.cmp(&b.2)));
            let mut is_taken = vec![false; leaving.len()];
            for (_, i, j) in choices {
                if !is_taken[i] && !is_taken[j] {
                    (is_taken[i], is_taken[j]) = (true, true);
                    pairs.push([leaving[i].reversed(), leaving[j]]);
                }
            }
        }
        pairs
    }
}

/// Each segment once, with what is on both of its sides.
fn merged(mut segments: Vec<Segment>, points: &[[f64; 2]]) -> Result<Vec<Segment>, Error> {
    segments.sort_by_key(|segment| segment.points);
    let mut found: Vec<Segment> = Vec::with_capacity(segments.len());
    for segment in segments {
        match found.last_mut().filter(|last| last.points == segment.points) {
            Some(last) => {
                for side in 0..2 {
                    if let (Some(a), Some(b)) = (last.sides[side], segment.sides[side]) {
                        let [[ax, ay], [bx, by]] = segment.points.map(|point| points[point as usize]);
                        return Err(Error::invalid(format!(
                            "sets {a} and {b} are on the same side of the segment from ({ax}, {ay}) to ({bx}, {by})"
                        ))
                        .with_cure("give sets that do not overlap"));
                    }
                    last.sides[side] = last.sides[side].or(segment.sides[side]);
                }
            }
            None => found.push(segment),
        }
    }
    // A set on both sides bounds nothing there.
    found.retain(|segment| segment.sides[0] != segment.sides[1]);
    Ok(found)
}

/// The maximal chains of segments through points where nothing else ends and that are no kinks, each with its points and the phases on
/// its sides; those that are closed begin at their lowest point.
fn chains(
    segments: &[Segment],
    point_count: usize,
    kinks: &BTreeSet<u32>,
) -> Vec<(Vec<u32>, [Option<u32>; 2])> {
    let mut ends: Vec<[u32; 2]> = vec![[NONE; 2]; point_count];
    let mut degrees = vec![0u32; point_count];
    for (at, segment) in segments.iter().enumerate() {
        for point in segment.points {
            let point = point as usize;
            if degrees[point] < 2 {
                ends[point][degrees[point] as usize] = at as u32;
            }
            degrees[point] += 1;
        }
    }
    let is_vertex = |point: u32| degrees[point as usize] != 2 || kinks.contains(&point);
    let mut is_used = vec![false; segments.len()];
    let mut found = Vec::new();
    // First those that start at vertices, then what is closed.
    for is_closed in [false, true] {
        for at in 0..segments.len() {
            for turn in 0..2 {
                let start = segments[at].points[turn];
                if is_used[at] || (!is_closed && !is_vertex(start)) {
                    continue;
                }
                let [left, right] = segments[at].sides;
                let phases = if turn == 0 { [left, right] } else { [right, left] };
                let mut way = vec![start];
                let mut segment = at;
                loop {
                    is_used[segment] = true;
                    let last = way[way.len() - 1];
                    let [a, b] = segments[segment].points;
                    let next = if a == last { b } else { a };
                    way.push(next);
                    if is_vertex(next) || next == start {
                        break;
                    }
                    let [e, f] = ends[next as usize];
                    segment = if e as usize == segment { f } else { e } as usize;
                }
                found.push((way, phases));
            }
        }
    }
    found
}
