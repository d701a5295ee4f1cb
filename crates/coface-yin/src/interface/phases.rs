//! The boundaries of phases, and the check that they fit together.

use super::{DirectedEdge, InterfaceGraph};
use crate::Curve;
use coface_algebra::Error;
use coface_algebra::Sign;
use coface_geometry::Sum;
use coface_geometry::predicates::direction_turn;
use std::cmp::Ordering;

/// No number. The arrays that hold it have one entry a cell, and an `Option` would double their size.
const NONE: u32 = u32::MAX;

impl InterfaceGraph {
    /// The edges that leave each vertex, counterclockwise by their directions there.
    pub(super) fn edges_around(&self) -> Result<Vec<Vec<DirectedEdge>>, Error> {
        let mut around: Vec<Vec<(DirectedEdge, [[f64; 2]; 2])>> = vec![Vec::new(); self.vertices.len()];
        let bend = |edge: DirectedEdge| self.bend_at_tail(edge).unwrap_or_default();
        for at in 0..2 * self.edge_count() {
            let edge = DirectedEdge::at(at);
            let controls = self.curves[edge.edge.index()].controls();
            let start = self.vertices[self.tail(edge)];
            // The first control point elsewhere tells the direction.
            let elsewhere = |control: &&[f64; 2]| **control != start;
            let to = match edge.sign {
                Sign::Plus => controls.iter().find(elsewhere),
                Sign::Minus => controls.iter().rev().find(elsewhere),
            };
            let to = *to.expect("chords of fitted curves have a length");
            around[self.tail(edge)].push((edge, [start, to]));
        }
        let mut found = Vec::with_capacity(around.len());
        for (vertex, mut leaving) in around.into_iter().enumerate() {
            // By half planes from the direction of x, then by turns.
            let is_lower = |[a, b]: [[f64; 2]; 2]| b[1] < a[1] || (b[1] == a[1] && b[0] < a[0]);
            let order = |s: [[f64; 2]; 2], t: [[f64; 2]; 2]| {
                is_lower(s).cmp(&is_lower(t)).then_with(|| direction_turn(s, t).reverse())
            };
            // Of edges that leave in one direction the one that bends more to the left comes later.
            leaving.sort_by(|a, b| order(a.1, b.1).then_with(|| bend(a.0)[0].total_cmp(&bend(b.0)[0])));
            for pair in leaving.windows(2) {
                let are_apart = || {
                    let bends = [pair[0].0, pair[1].0].map(|edge| self.bend_at_tail(edge));
                    matches!(bends, [Some([a, near]), Some([b, far])] if b - a > near + far)
                };
                if order(pair[0].1, pair[1].1) == Ordering::Equal && !are_apart() {
                    return Err(Error::invalid(format!(
                        "edges {} and {} leave vertex {vertex} in the same direction",
                        pair[0].0.edge.index(),
                        pair[1].0.edge.index()
                    ))
                    .with_cure("give edges that share no arc, with vertices where they meet"));
                }
            }
            found.push(leaving.into_iter().map(|(edge, _)| edge).collect());
        }
        Ok(found)
    }

    /// The curvature with which an edge leaves its vertex, positive to the left, and how far it may be off; none without a direction there.
    fn bend_at_tail(&self, edge: DirectedEdge) -> Option<[f64; 2]> {
        let curve = &self.curves[edge.edge.index()];
        let degree = curve.order().degree();
        let mut controls = match edge.sign {
            Sign::Plus => curve.piece(0).to_vec(),
            Sign::Minus => curve.piece(curve.piece_count() - 1).to_vec(),
        };
        if edge.sign == Sign::Minus {
            controls.reverse();
        }
        let difference = |at: usize| [0, 1].map(|axis| controls[at + 1][axis] - controls[at][axis]);
        let [x, y] = difference(0);
        let length = x.hypot(y);
        if length == 0.0 {
            return None;
        }
        let [u, v] = if degree > 1 { difference(1) } else { [x, y] };
        let part = (degree - 1) as f64 / degree as f64;
        let bend = part * ((x / length) * (v / length) - (y / length) * (u / length)) / length;
        Some([bend, 1e-12 * ((1.0 + u.hypot(v) / length) / length + bend.abs())])
    }

    /// Whether the edges around each vertex agree on the phases between them: there is neither a gap nor an overlap.
    pub(super) fn check_sectors(&self) -> Result<(), Error> {
        for (vertex, leaving) in self.around.iter().enumerate() {
            for (at, &edge) in leaving.iter().enumerate() {
                let after = leaving[(at + 1) % leaving.len()];
                let [left, right] = [self.left(edge), self.left(after.reversed())];
                if left != right {
                    let name = |phase: Option<u32>| {
                        phase.map_or("no phase".to_owned(), |phase| format!("phase {phase}"))
                    };
                    return Err(Error::invalid(format!(
                        "between edges {} and {} at vertex {vertex} there is {} by the first and {} by the second",
                        edge.edge.index(),
                        after.edge.index(),
                        name(left),
                        name(right)
                    ))
                    .with_cure("give phases that meet along edges"));
                }
            }
        }
        Ok(())
    }

    /// The closed walks along the boundary of a phase, the phase on their left, through no vertex twice.
    ///
    /// At each vertex a walk goes on by the edge that comes first when turning clockwise from where it came; what is closed is cut off
    /// at once.
    ///
    /// # Examples
    /// One triangle, whose boundary is an edge from a base point to itself.
    /// ```
    /// use coface_algebra::EdgeId;
    /// use coface_yin::{DirectedEdge, InterfaceEdge, InterfaceGraph, Order};
    /// let edge = InterfaceEdge { ends: [0, 0], markers: vec![[1.0, 0.0], [0.0, 1.0]], phases: [Some(0), None] };
    /// let around = [DirectedEdge::along(EdgeId::new(0)); 2];
    /// let graph = InterfaceGraph::new(&[[0.0, 0.0]], &[edge], &[around], Order::LINEAR)?;
    /// assert_eq!(graph.phase_walks(0), [[DirectedEdge::along(EdgeId::new(0))]]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn phase_walks(&self, phase: u32) -> Vec<Vec<DirectedEdge>> {
        self.walks_of(Some(phase))
    }

    /// The same, also of what is in no phase.
    pub(crate) fn walks_of(&self, phase: Option<u32>) -> Vec<Vec<DirectedEdge>> {
        let mut place = vec![0u32; 2 * self.edge_count()];
        for leaving in &self.around {
            for (at, edge) in leaving.iter().enumerate() {
                place[edge.index()] = at as u32;
            }
        }
        let mut is_used = vec![false; 2 * self.edge_count()];
        // The place on the current walk at which a vertex was left.
        let mut stamp = vec![NONE; self.vertices.len()];
        let mut walks = Vec::new();
        for first in 0..2 * self.edge_count() {
            let mut edge = DirectedEdge::at(first);
            if self.left(edge) != phase {
                continue;
            }
            let mut walk: Vec<DirectedEdge> = Vec::new();
            while !is_used[edge.index()] {
                is_used[edge.index()] = true;
                stamp[self.tail(edge)] = walk.len() as u32;
                walk.push(edge);
                let head = self.head(edge);
                if stamp[head] != NONE {
                    let cut = walk.split_off(stamp[head] as usize);
                    for own in &cut {
                        stamp[self.tail(*own)] = NONE;
                    }
                    walks.push(cut);
                }
                let leaving = &self.around[head];
                let back = place[edge.reversed().index()] as usize;
                edge = leaving[(back + leaving.len() - 1) % leaving.len()];
            }
        }
        walks
    }

    /// The Jordan curves that bound a phase, the phase on their left: their pieces are those of the edges, bit for bit.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if no edge names the phase.
    ///
    /// # Examples
    /// One triangle, whose boundary is an edge from a base point to itself.
    /// ```
    /// use coface_algebra::EdgeId;
    /// use coface_yin::{DirectedEdge, InterfaceEdge, InterfaceGraph, Order};
    /// let edge = InterfaceEdge { ends: [0, 0], markers: vec![[1.0, 0.0], [0.0, 1.0]], phases: [Some(0), None] };
    /// let around = [DirectedEdge::along(EdgeId::new(0)); 2];
    /// let graph = InterfaceGraph::new(&[[0.0, 0.0]], &[edge], &[around], Order::LINEAR)?;
    /// assert_eq!(graph.phase_curves(0)?[0].signed_area(), 0.5);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn phase_curves(&self, phase: u32) -> Result<Vec<Curve<'static>>, Error> {
        let walks = self.phase_walks(phase);
        if walks.is_empty() {
            return Err(Error::invalid(format!("no edge has phase {phase} at its side"))
                .with_cure("take one of the phases that edges name"));
        }
        walks.iter().map(|walk| self.walk_curve(walk)).collect()
    }

    /// The closed curve along a walk.
    pub(crate) fn walk_curve(&self, walk: &[DirectedEdge]) -> Result<Curve<'static>, Error> {
        let (mut controls, mut knots) = (Vec::<[f64; 2]>::new(), vec![0.0]);
        for edge in walk {
            let curve = &self.curves[edge.edge.index()];
            controls.pop();
            match edge.sign {
                Sign::Plus => controls.extend_from_slice(curve.controls()),
                Sign::Minus => controls.extend(curve.controls().iter().rev()),
            }
            let own = curve.knots();
            let mut at: f64 = knots[knots.len() - 1];
            for piece in 0..curve.piece_count() {
                let piece = if edge.sign == Sign::Plus { piece } else { curve.piece_count() - 1 - piece };
                at += own[piece + 1] - own[piece];
                knots.push(at);
            }
        }
        Curve::from_controls(self.order, controls, knots)
    }

    /// The area of a phase; of one that reaches to infinity minus the area of what it leaves out.
    ///
    /// # Errors
    /// As [`Self::phase_curves`].
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
    pub fn phase_area(&self, phase: u32) -> Result<f64, Error> {
        let mut sum = Sum::default();
        for curve in self.phase_curves(phase)? {
            sum.add(curve.signed_area());
        }
        Ok(sum.value())
    }

    /// The areas that all phases cover together, twice: as their sum, and as what the edges with a phase on one side only enclose.
    /// They agree up to rounding, for edges between two phases count in both directions.
    ///
    /// # Errors
    /// As [`Self::phase_curves`].
    ///
    /// # Examples
    /// See [`InterfaceGraph`].
    pub fn covered_areas(&self) -> Result<[f64; 2], Error> {
        let (mut phases, mut border) = (Sum::default(), Sum::default());
        for phase in self.phases() {
            phases.add(self.phase_area(phase)?);
        }
        let base = self.vertices.first().copied().unwrap_or_default();
        for (edge, curve) in self.curves.iter().enumerate() {
            // Between the curve and its chord, and the triangle of the chord with a common point.
            let [a, b] = [curve.knot_point(0), curve.knot_point(curve.piece_count())];
            let triangle = 0.5 * ((a[0] - base[0]) * (b[1] - base[1]) - (a[1] - base[1]) * (b[0] - base[0]));
            let sign = match self.phases[edge] {
                [Some(_), None] => 1.0,
                [None, Some(_)] => -1.0,
                _ => continue,
            };
            border.add(sign * curve.signed_area());
            border.add(sign * triangle);
        }
        Ok([phases.value(), border.value()])
    }
}
