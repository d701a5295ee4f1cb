//! The unique form of an interface.

use super::edits::{Parts, joined, knot_points, pieces_of};
use super::graph::Arcs;
use super::trails::DirectedEdge;
use super::{InterfaceFault, InterfaceGraph};
use crate::curve::chord_lengths;
use crate::{Curve, Order};
use coface_algebra::{EdgeId, Error, Sign, VertexId};
use coface_arrange::boolean::InsideRule;
use coface_geometry::predicates::orientation;
use std::collections::BTreeSet;

/// An interface in its unique form, and what had to be done for that.
///
/// # Examples
/// See [`InterfaceGraph::normalized`].
#[derive(Clone, Debug)]
pub struct NormalizedInterface {
    graph: InterfaceGraph,
    fault: Option<InterfaceFault>,
    joined: usize,
    straightened: usize,
}

impl NormalizedInterface {
    /// The interface.
    pub fn graph(&self) -> &InterfaceGraph {
        &self.graph
    }

    /// The interface alone.
    pub fn into_graph(self) -> InterfaceGraph {
        self.graph
    }

    /// What was wrong, if edges had to be cut and pasted by the rule.
    pub fn fault(&self) -> Option<&InterfaceFault> {
        self.fault.as_ref()
    }

    /// The number of vertices at which two edges became one.
    pub fn joined_count(&self) -> usize {
        self.joined
    }

    /// The number of knots within straight parts of polylines that were left out.
    pub fn straightened_count(&self) -> usize {
        self.straightened
    }
}

impl InterfaceGraph {
    /// The interface in its unique form. Edges that meet elsewhere than at their ends are cut and pasted by a rule, which says what is inside of each
    /// phase; what then lies in several goes to the lowest. Edges that go on smoothly into each other where nothing else ends become one, knots within
    /// straight parts of polylines are left out, and so are kinks of polylines, which they do not change. Closed edges without a kink begin at
    /// their lexicographically lowest knot, edges have the phase with the lower number on their left (what is in no phase comes last),
    /// vertices rise lexicographically, and edges by their vertices, phases and control points.
    ///
    /// Junctions, phases and points stay what they are. Two interfaces of order 2 whose phases have the same points have the same edges in their
    /// unique forms, bit for bit.
    ///
    /// # Errors
    /// Those of [`Self::fault`], and if the edges cannot be cut and pasted.
    ///
    /// # Complexity
    /// That of an overlay of all edges.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::boolean::InsideRule;
    /// use coface_yin::{InterfaceEdge, InterfaceGraph, Order};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edge = InterfaceEdge { ends: [0, 0], markers: vec![[2.0, 2.0], [0.0, 2.0], [0.0, 0.0], [1.0, 0.0]], phases: [Some(0), None] };
    /// let unique = InterfaceGraph::new(&[[2.0, 0.0]], &[edge], &[], Order::LINEAR)?.normalized(InsideRule::Nonzero)?;
    /// assert_eq!((unique.straightened_count(), unique.fault()), (1, None));
    /// assert_eq!(unique.graph().vertices(), [[0.0, 0.0]]);
    /// # Ok(()) }
    /// ```
    pub fn normalized(&self, rule: InsideRule) -> Result<NormalizedInterface, Error> {
        let fault = self.fault()?;
        let repaired = fault.as_ref().map(|_| self.repaired(rule)).transpose()?;
        let graph = repaired.as_ref().unwrap_or(self);
        if repaired.is_some()
            && let Some(fault) = graph.fault()?
        {
            return Err(fault.into_error().with_cure("give another fill rule"));
        }
        let mut parts = Parts::of(graph);
        if graph.order == Order::LINEAR {
            let kinks: BTreeSet<u32> = graph.kinks().into_iter().map(VertexId::to_u32).collect();
            parts.smooth(&kinks);
        }
        let joined = parts.join(|_| true)?;
        parts.begin_at_lowest();
        let straightened = if graph.order == Order::LINEAR { parts.straighten() } else { 0 };
        parts.turn_to_lower_phases();
        parts.sort();
        Ok(NormalizedInterface {
            graph: parts.into_graph_by_directions(graph.order)?,
            fault,
            joined,
            straightened,
        })
    }
}

impl Parts {
    /// Lets closed edges at smooth vertices of their own begin at their lowest knots.
    fn begin_at_lowest(&mut self) {
        let own_pairs: BTreeSet<EdgeId> = self
            .arcs
            .smooth_pairs
            .iter()
            .filter(|pair| pair[0].edge == pair[1].edge)
            .map(|pair| pair[0].edge)
            .collect();
        for edge in own_pairs {
            let edge = edge.index();
            let [start, end] = self.arcs.ends[edge];
            if start != end || self.around[start as usize].len() != 2 {
                continue;
            }
            let points = knot_points(&self.curves[edge]);
            let lowest =
                (0..points.len() - 1).reduce(|a, b| if points[b] < points[a] { b } else { a }).unwrap_or(0);
            if lowest > 0 {
                let curve = &self.curves[edge];
                let [before, after] =
                    [pieces_of(curve, 0, lowest), pieces_of(curve, lowest, points.len() - 1)];
                self.curves[edge] = joined([&after, &before].map(|part| (part, Sign::Plus)).into_iter());
                self.arcs.vertices[start as usize] = points[lowest];
            }
        }
    }

    /// Leaves knots out at which edges that are polylines go straight on.
    fn straighten(&mut self) -> usize {
        let mut count = 0;
        for curve in &mut self.curves {
            let points = knot_points(curve);
            let turns = |knot: usize| {
                let [a, b, c] = [points[knot - 1], points[knot], points[knot + 1]];
                let is_between = (0..2).all(|axis| {
                    (a[axis] <= b[axis] && b[axis] <= c[axis]) || (a[axis] >= b[axis] && b[axis] >= c[axis])
                });
                orientation(a, b, c).is_ne() || !is_between
            };
            let last = points.len() - 1;
            let kept: Vec<[f64; 2]> = (0..=last)
                .filter(|&knot| knot == 0 || knot == last || turns(knot))
                .map(|knot| points[knot])
                .collect();
            count += points.len() - kept.len();
            let knots = chord_lengths(&kept);
            *curve = Curve::from_trusted(Order::LINEAR, kept, knots);
        }
        count
    }

    /// Turns edges so that the phase with the lower number is on their left.
    fn turn_to_lower_phases(&mut self) {
        let rank = |phase: Option<u32>| phase.map_or(u64::MAX, u64::from);
        let is_turned: Vec<bool> =
            self.arcs.phases.iter().map(|&[left, right]| rank(left) > rank(right)).collect();
        for edge in (0..is_turned.len()).filter(|&edge| is_turned[edge]) {
            self.arcs.phases[edge].reverse();
            self.arcs.ends[edge].reverse();
            self.curves[edge] = self.curves[edge].reversed();
        }
        self.rename(|edge| if is_turned[edge.edge.index()] { edge.reversed() } else { edge });
    }

    /// Lets vertices and edges rise.
    fn sort(&mut self) {
        let Arcs { vertices, ends, phases, .. } = &self.arcs;
        let mut by_place: Vec<usize> = (0..vertices.len()).collect();
        let compare = |a: [f64; 2], b: [f64; 2]| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1]));
        by_place.sort_by(|&a, &b| compare(vertices[a], vertices[b]));
        let mut numbers = vec![0u32; vertices.len()];
        (0..).zip(&by_place).for_each(|(number, &vertex)| numbers[vertex] = number);
        let ends: Vec<[u32; 2]> = ends.iter().map(|ends| ends.map(|end| numbers[end as usize])).collect();
        let rank = |edge: usize| (ends[edge], phases[edge].map(|phase| phase.map_or(u64::MAX, u64::from)));
        let points = |edge: usize| self.curves[edge].controls();
        let mut order: Vec<usize> = (0..ends.len()).collect();
        order.sort_by(|&a, &b| {
            let by_points = || {
                let pairs = points(a).iter().zip(points(b));
                let first = pairs.map(|(&a, &b)| compare(a, b)).find(|order| order.is_ne());
                first.unwrap_or_else(|| points(a).len().cmp(&points(b).len()))
            };
            rank(a).cmp(&rank(b)).then_with(by_points)
        });
        let mut edge_numbers = vec![EdgeId::new(0); order.len()];
        (0..).zip(&order).for_each(|(number, &edge)| edge_numbers[edge] = EdgeId::new(number));
        self.arcs.vertices = by_place.iter().map(|&vertex| self.arcs.vertices[vertex]).collect();
        self.around = by_place.iter().map(|&vertex| std::mem::take(&mut self.around[vertex])).collect();
        self.arcs.ends = order.iter().map(|&edge| ends[edge]).collect();
        self.arcs.phases = order.iter().map(|&edge| self.arcs.phases[edge]).collect();
        self.curves = order.iter().map(|&edge| self.curves[edge].clone()).collect();
        self.rename(|edge| DirectedEdge { edge: edge_numbers[edge.edge.index()], ..edge });
        // Each pair in one of its two directions.
        for pair in &mut self.arcs.smooth_pairs {
            let [from, to] = *pair;
            *pair = std::cmp::min([from, to], [to.reversed(), from.reversed()]);
        }
        self.arcs.smooth_pairs.sort_unstable();
        self.arcs.smooth_pairs.dedup();
    }

    fn rename(&mut self, name: impl Fn(DirectedEdge) -> DirectedEdge) {
        self.around.iter_mut().flatten().for_each(|edge| *edge = name(*edge));
        self.arcs.smooth_pairs.iter_mut().flatten().for_each(|edge| *edge = name(*edge));
    }

    /// The graph, with the edges around vertices from the direction of x on, as a file has them, where their directions differ.
    fn into_graph_by_directions(self, order: Order) -> Result<InterfaceGraph, Error> {
        let Arcs { vertices, ends, phases, smooth_pairs } = &self.arcs;
        let graph =
            InterfaceGraph::from_curves(vertices, ends, phases, self.curves.clone(), smooth_pairs, order);
        graph.or_else(|_| self.into_graph(order))
    }
}
