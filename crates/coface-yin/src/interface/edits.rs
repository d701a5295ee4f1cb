//! Interfaces whose edges are cut at kinks and joined again where kinks go.

use super::InterfaceGraph;
use super::graph::Arcs;
use super::trails::{DirectedEdge, Trail, fitted_edges, trails_of};
use crate::curve::distance;
use crate::kinks::turning_at;
use crate::{Curve, KnotIndex, Order};
use coface_algebra::{EdgeId, Error, ErrorKind, Sign, VertexId};
use std::collections::BTreeSet;

/// A graph taken apart, with edges cut and joined, and nothing fitted again yet.
pub(super) struct Parts {
    pub(super) arcs: Arcs,
    pub(super) curves: Vec<Curve<'static>>,
    /// The edges that leave each vertex, counterclockwise.
    pub(super) around: Vec<Vec<DirectedEdge>>,
    /// Which edges have to be fitted again.
    pub(super) is_stale: Vec<bool>,
}

impl Parts {
    pub(super) fn of(graph: &InterfaceGraph) -> Self {
        Self {
            arcs: Arcs {
                vertices: graph.vertices.clone(),
                ends: graph.ends.clone(),
                phases: graph.phases.clone(),
                smooth_pairs: graph.smooth_pairs.clone(),
            },
            curves: graph.curves.clone(),
            around: graph.around.clone(),
            is_stale: vec![false; graph.edge_count()],
        }
    }

    /// Cuts edges at inner knots that rise, each of which becomes a vertex. What is behind the first knot of an edge gets new numbers.
    fn cut(&mut self, knots: &[KnotIndex]) {
        for on_edge in knots.chunk_by(|a, b| a.curve == b.curve) {
            let edge = on_edge[0].curve as usize;
            let whole = self.curves[edge].clone();
            let (last_end, phases, is_stale) =
                (self.arcs.ends[edge][1], self.arcs.phases[edge], self.is_stale[edge]);
            let cuts: Vec<usize> =
                (on_edge.iter().map(|at| at.knot as usize)).chain([whole.piece_count()]).collect();
            self.curves[edge] = pieces_of(&whole, 0, cuts[0]);
            let mut before = DirectedEdge::along(EdgeId::new(edge));
            for (number, pair) in cuts.windows(2).enumerate() {
                let vertex = self.arcs.vertices.len() as u32;
                self.arcs.vertices.push(whole.knot_point(pair[0]));
                self.arcs.ends[before.edge.index()][1] = vertex;
                let own = DirectedEdge::along(EdgeId::new(self.curves.len()));
                self.curves.push(pieces_of(&whole, pair[0], pair[1]));
                let end = if number + 2 == cuts.len() { last_end } else { vertex + 1 };
                self.arcs.ends.push([vertex, end]);
                self.arcs.phases.push(phases);
                self.is_stale.push(is_stale);
                self.around.push(vec![before.reversed(), own]);
                before = own;
            }
            // What came to the last vertex by the edge comes by its last part.
            let [old, new] = [DirectedEdge::against(EdgeId::new(edge)), before.reversed()];
            for leaving in self.around[last_end as usize].iter_mut().filter(|leaving| **leaving == old) {
                *leaving = new;
            }
            for pair in &mut self.arcs.smooth_pairs {
                if pair[0] == old.reversed() {
                    pair[0] = new.reversed();
                }
                if pair[1] == old {
                    pair[1] = new;
                }
            }
        }
    }

    /// Joins the edges that go on smoothly into each other at vertices where nothing else ends, if those are chosen. Gives the number of
    /// vertices that are gone.
    pub(super) fn join(&mut self, is_chosen: impl Fn(u32) -> bool) -> Result<usize, Error> {
        let tail = |ends: &[[u32; 2]], edge: DirectedEdge| {
            ends[edge.edge.index()][usize::from(edge.sign == Sign::Minus)]
        };
        let is_joint = |pair: &&[DirectedEdge; 2]| {
            let vertex = tail(&self.arcs.ends, pair[1]);
            self.around[vertex as usize].len() == 2 && pair[0].edge != pair[1].edge && is_chosen(vertex)
        };
        let joints: Vec<[DirectedEdge; 2]> =
            self.arcs.smooth_pairs.iter().filter(is_joint).copied().collect();
        if joints.is_empty() {
            return Ok(0);
        }
        let trails = trails_of(&self.arcs.ends, &joints)?;
        // For each edge the one that it is a part of, and whether it runs along that.
        let mut whole_of = vec![DirectedEdge::along(EdgeId::new(0)); self.curves.len()];
        let (mut ends, mut phases, mut curves, mut is_stale) =
            (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        for (number, trail) in trails.iter().enumerate() {
            let own = trail.edges();
            let whole = DirectedEdge::along(EdgeId::new(number));
            for edge in own {
                whole_of[edge.edge.index()] = DirectedEdge { sign: edge.sign, ..whole };
            }
            let [first, last] = [own[0], own[own.len() - 1]];
            ends.push([tail(&self.arcs.ends, first), tail(&self.arcs.ends, last.reversed())]);
            let sides = self.arcs.phases[first.edge.index()];
            phases.push(if first.sign == Sign::Plus { sides } else { [sides[1], sides[0]] });
            is_stale.push(own.iter().any(|edge| self.is_stale[edge.edge.index()]));
            curves.push(match own {
                [edge] if edge.sign == Sign::Plus => self.curves[edge.edge.index()].clone(),
                _ => joined(own.iter().map(|edge| (&self.curves[edge.edge.index()], edge.sign))),
            });
        }
        let renamed = |edge: DirectedEdge| {
            let whole = whole_of[edge.edge.index()];
            if edge.sign == Sign::Plus { whole } else { whole.reversed() }
        };
        let mut is_kept = vec![false; self.arcs.vertices.len()];
        ends.iter().flatten().for_each(|&end| is_kept[end as usize] = true);
        // The base points of ways that are closed are joints, but stay.
        let pairs =
            self.arcs.smooth_pairs.iter().filter(|pair| is_kept[tail(&self.arcs.ends, pair[1]) as usize]);
        let pairs: Vec<[DirectedEdge; 2]> = pairs.map(|pair| pair.map(renamed)).collect();
        let gone = is_kept.iter().filter(|is| !**is).count();
        let mut numbers = vec![u32::MAX; is_kept.len()];
        let mut kept = (Vec::new(), Vec::new());
        for (vertex, _) in is_kept.iter().enumerate().filter(|(_, is)| **is) {
            numbers[vertex] = kept.0.len() as u32;
            kept.0.push(self.arcs.vertices[vertex]);
            kept.1.push(self.around[vertex].iter().map(|&edge| renamed(edge)).collect());
        }
        ends.iter_mut().flatten().for_each(|end| *end = numbers[*end as usize]);
        self.arcs = Arcs { vertices: kept.0, ends, phases, smooth_pairs: pairs };
        (self.curves, self.around, self.is_stale) = (curves, kept.1, is_stale);
        Ok(gone)
    }

    /// Adds that edges go on smoothly at these vertices where two ends are.
    pub(super) fn smooth(&mut self, vertices: &BTreeSet<u32>) {
        for &vertex in vertices {
            let [a, b] = self.around[vertex as usize][..] else { continue };
            self.arcs.smooth_pairs.push([a.reversed(), b]);
            [a, b].iter().for_each(|edge| self.is_stale[edge.edge.index()] = true);
        }
    }

    /// Takes out that edges go on smoothly at these vertices.
    fn sharpen(&mut self, vertices: &BTreeSet<u32>) {
        let ends = &self.arcs.ends;
        let vertex = |edge: &DirectedEdge| ends[edge.edge.index()][usize::from(edge.sign == Sign::Minus)];
        let is_stale = &mut self.is_stale;
        self.arcs.smooth_pairs.retain(|pair| {
            let stays = !vertices.contains(&vertex(&pair[1]));
            if !stays {
                pair.iter().for_each(|edge| is_stale[edge.edge.index()] = true);
            }
            stays
        });
    }

    /// The graph, with edges fitted where that is needed, through their knots.
    fn fitted(mut self, order: Order) -> Result<InterfaceGraph, Error> {
        let trails = trails_of(&self.arcs.ends, &self.arcs.smooth_pairs)?;
        let is_stale = |trail: &Trail| trail.edges().iter().any(|edge| self.is_stale[edge.edge.index()]);
        let stale: Vec<Trail> = trails.into_iter().filter(is_stale).collect();
        let points: Vec<Vec<[f64; 2]>> = self.curves.iter().map(knot_points).collect();
        let parameters: Vec<Option<Vec<f64>>> = self.curves.iter().map(kept_parameters).collect();
        for (edge, curve) in fitted_edges(&points, &parameters, &stale, order)? {
            self.curves[edge.index()] = curve;
        }
        InterfaceGraph::with_curves(self.arcs, self.curves, order, self.around)
    }

    /// The graph as it is.
    pub(super) fn into_graph(self, order: Order) -> Result<InterfaceGraph, Error> {
        InterfaceGraph::with_curves(self.arcs, self.curves, order, self.around)
    }
}

/// The knots of a curve.
pub(super) fn knot_points(curve: &Curve<'static>) -> Vec<[f64; 2]> {
    (0..=curve.piece_count()).map(|knot| curve.knot_point(knot)).collect()
}

/// The parameters at which the knots of an edge are fitted again: those that they have where these are nearer to the boundary than distances are, in
/// orders above 4, and even.
fn kept_parameters(curve: &Curve<'static>) -> Option<Vec<f64>> {
    /// Parameters go by so much more or less of the distance of knots at most.
    const UNEVEN: f64 = 2.0;
    if curve.order() <= Order::CUBIC {
        return None;
    }
    let speeds = (0..curve.piece_count()).map(|piece| {
        let way = distance(curve.knot_point(piece), curve.knot_point(piece + 1));
        way / (curve.knots()[piece + 1] - curve.knots()[piece])
    });
    let (least, most) =
        speeds.fold((f64::INFINITY, 0.0f64), |(least, most), own| (least.min(own), most.max(own)));
    (most <= UNEVEN * least).then(|| curve.knots().to_vec())
}

/// The pieces of a curve between two knots, which are parameters from 0.
pub(super) fn pieces_of(curve: &Curve<'static>, from: usize, to: usize) -> Curve<'static> {
    let degree = curve.order().degree();
    let controls = curve.controls()[from * degree..=to * degree].to_vec();
    let start = curve.knots()[from];
    Curve::from_trusted(
        curve.order(),
        controls,
        curve.knots()[from..=to].iter().map(|knot| knot - start).collect(),
    )
}

/// Curves one after the other, each along or against its direction.
pub(super) fn joined<'a>(curves: impl Iterator<Item = (&'a Curve<'static>, Sign)>) -> Curve<'static> {
    let (mut controls, mut knots, mut order) = (Vec::<[f64; 2]>::new(), vec![0.0], Order::LINEAR);
    for (curve, sign) in curves {
        order = curve.order();
        controls.pop();
        let own = curve.knots();
        let count = curve.piece_count();
        let mut at: f64 = knots[knots.len() - 1];
        match sign {
            Sign::Plus => controls.extend_from_slice(curve.controls()),
            Sign::Minus => controls.extend(curve.controls().iter().rev()),
        }
        for piece in 0..count {
            let piece = if sign == Sign::Plus { piece } else { count - 1 - piece };
            at = (at + (own[piece + 1] - own[piece])).max(at.next_up());
            knots.push(at);
        }
    }
    Curve::from_trusted(order, controls, knots)
}

impl InterfaceGraph {
    /// The kinks: the vertices where two edges end and do not go on smoothly into each other, rising. Junctions, where three or more
    /// edges end, are not among them.
    ///
    /// # Complexity
    /// Linear in the edges.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_yin::{InterfaceEdge, InterfaceGraph, Order};
    /// let edge = InterfaceEdge { ends: [0, 0], markers: vec![[1.0, 0.0], [0.0, 1.0]], phases: [Some(0), None] };
    /// let graph = InterfaceGraph::new(&[[0.0, 0.0]], &[edge], &[], Order::LINEAR)?;
    /// assert_eq!(graph.kinks(), [VertexId::new(0)]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn kinks(&self) -> Vec<VertexId> {
        let mut is_smooth = vec![false; self.vertices.len()];
        self.smooth_pairs.iter().for_each(|pair| is_smooth[self.tail(pair[1])] = true);
        let is_kink = |vertex: &usize| self.around[*vertex].len() == 2 && !is_smooth[*vertex];
        (0..self.vertices.len()).filter(is_kink).map(VertexId::new).collect()
    }

    /// The knot of an edge that is nearest to a point, junctions left out: the first of several, with the number of the edge for
    /// [`KnotIndex::curve`].
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] if the point is not finite.
    ///
    /// # Complexity
    /// Linear in the knots.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{InterfaceEdge, InterfaceGraph, Order};
    /// let edge = InterfaceEdge { ends: [0, 0], markers: vec![[1.0, 0.0], [0.0, 1.0]], phases: [Some(0), None] };
    /// let graph = InterfaceGraph::new(&[[0.0, 0.0]], &[edge], &[], Order::LINEAR)?;
    /// assert_eq!(graph.nearest_knot([0.9, 0.2])?.map(|at| (at.curve, at.knot)), Some((0, 1)));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn nearest_knot(&self, point: [f64; 2]) -> Result<Option<KnotIndex>, Error> {
        check_point(point)?;
        let knots_of = |edge: usize| {
            let curve = &self.curves[edge];
            let count = curve.piece_count();
            let is_free = move |end: usize| self.around[self.ends[edge][end] as usize].len() == 2;
            (0..=count).filter(move |&knot| (0 < knot || is_free(0)) && (knot < count || is_free(1))).map(
                move |knot| {
                    (
                        distance(curve.knot_point(knot), point),
                        KnotIndex { curve: edge as u32, knot: knot as u32 },
                    )
                },
            )
        };
        let all = (0..self.edge_count()).flat_map(knots_of);
        Ok(all.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, at)| at))
    }

    /// The kink that is nearest to a point, the first of several; none without kinks.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] if the point is not finite.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_yin::{InterfaceEdge, InterfaceGraph, Order};
    /// let edge = InterfaceEdge { ends: [0, 0], markers: vec![[1.0, 0.0], [0.0, 1.0]], phases: [Some(0), None] };
    /// let graph = InterfaceGraph::new(&[[0.0, 0.0]], &[edge], &[], Order::LINEAR)?;
    /// assert_eq!(graph.nearest_kink([9.0, 0.0])?, Some(VertexId::new(0)));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn nearest_kink(&self, point: [f64; 2]) -> Result<Option<VertexId>, Error> {
        check_point(point)?;
        let far = |vertex: &VertexId| distance(self.vertices[vertex.index()], point);
        Ok(self.kinks().into_iter().min_by(|a, b| far(a).total_cmp(&far(b))))
    }

    /// The inner knots of edges, and base points of closed ones, at which the polygon through the knots turns by more than an angle, in
    /// radians: what may become kinks, and those that are.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] unless the angle is between 0 and pi.
    ///
    /// # Complexity
    /// Linear in the knots.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{InterfaceEdge, InterfaceGraph, Order};
    /// let edge = InterfaceEdge { ends: [0, 0], markers: vec![[1.0, 0.0], [2.0, 0.0], [0.0, 1.0]], phases: [Some(0), None] };
    /// let graph = InterfaceGraph::new(&[[0.0, 0.0]], &[edge], &[], Order::LINEAR)?;
    /// assert_eq!(graph.detected_kinks(0.5)?.iter().map(|at| at.knot).collect::<Vec<_>>(), [0, 2, 3]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn detected_kinks(&self, angle: f64) -> Result<Vec<KnotIndex>, Error> {
        let mut found = Vec::new();
        // At vertices the way goes on along the other edge; each is looked at once.
        let mut next = vec![None; 2 * self.edge_count()];
        for leaving in self.around.iter().filter(|leaving| leaving.len() == 2) {
            next[leaving[0].reversed().index()] = Some(leaving[1]);
        }
        for (edge, curve) in self.curves.iter().enumerate() {
            let count = curve.piece_count();
            let own = DirectedEdge::along(EdgeId::new(edge));
            let mut look = |before: [f64; 2], knot: usize, after: [f64; 2]| -> Result<(), Error> {
                if turning_at(before, curve.knot_point(knot), after, angle)? {
                    found.push(KnotIndex { curve: edge as u32, knot: knot as u32 });
                }
                Ok(())
            };
            if let Some(other) = next[own.reversed().index()] {
                look(curve.knot_point(1), 0, self.second_knot(other))?;
            }
            for knot in 1..count {
                look(curve.knot_point(knot - 1), knot, curve.knot_point(knot + 1))?;
            }
            if let Some(other) = next[own.index()] {
                look(curve.knot_point(count - 1), count, self.second_knot(other))?;
            }
        }
        if self.edge_count() == 0 {
            turning_at([0.0; 2], [1.0, 0.0], [2.0, 0.0], angle)?;
        }
        Ok(found)
    }

    /// The knot after the vertex that an edge leaves.
    fn second_knot(&self, edge: DirectedEdge) -> [f64; 2] {
        let curve = &self.curves[edge.edge.index()];
        curve.knot_point(if edge.sign == Sign::Plus { 1 } else { curve.piece_count() - 1 })
    }

    /// The interface with kinks erased and inserted, all at once: names and places are those of before. An edge with a new kink is cut into two
    /// there, the second of which gets the next free number; where a kink goes, its two edges become one. The splines beside the kinks are fitted
    /// again through their knots, once, so phases on both sides stay the same curve; all other edges stay bit for bit.
    ///
    /// In `inserted` [`KnotIndex::curve`] is the number of an edge. Knots at junctions cannot be kinks.
    ///
    /// # Errors
    /// [`ErrorKind::NotInComplex`] for a vertex that is no kink; [`ErrorKind::InvalidInput`] for a knot that is not there, a junction, or a kink already, for
    /// one that comes twice, and if edges would come to meet.
    ///
    /// # Complexity
    /// That of an overlay of all edges.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::EdgeId;
    /// use coface_yin::{DirectedEdge, InterfaceEdge, InterfaceGraph, KnotIndex, Order};
    /// let edge = InterfaceEdge { ends: [0, 0], markers: vec![[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], phases: [Some(0), None] };
    /// let around = [DirectedEdge::along(EdgeId::new(0)); 2];
    /// let round = InterfaceGraph::new(&[[0.0, 0.0]], &[edge], &[around], Order::CUBIC)?;
    /// let knots = [0, 1, 2, 3].map(|knot| KnotIndex { curve: 0, knot });
    /// let square = round.with_kinks_changed(&[], &knots)?;
    /// assert_eq!((square.edge_count(), square.phase_area(0)?), (4, 1.0));
    /// assert_eq!(square.with_kinks_changed(&square.kinks(), &[])?.edge_count(), 1);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn with_kinks_changed(&self, erased: &[VertexId], inserted: &[KnotIndex]) -> Result<Self, Error> {
        let graph = self.parts_with_kinks_changed(erased, inserted)?.fitted(self.order)?;
        match graph.fault()? {
            None => Ok(graph),
            Some(fault) => {
                Err(fault.into_error().with_cure("choose other kinks, or give more points along the edges"))
            }
        }
    }

    /// The interface with these kinks and no others, and all edges fitted again. In `knots` [`KnotIndex::curve`] is the number of an edge.
    ///
    /// # Errors
    /// As [`Self::with_kinks_changed`].
    ///
    /// # Complexity
    /// As [`Self::with_kinks_changed`].
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{InterfaceEdge, InterfaceGraph, KnotIndex, Order};
    /// let edge = InterfaceEdge { ends: [0, 0], markers: vec![[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], phases: [Some(0), None] };
    /// let graph = InterfaceGraph::new(&[[0.0, 0.0]], &[edge], &[], Order::CUBIC)?;
    /// let other = graph.with_kinks(&[KnotIndex { curve: 0, knot: 2 }])?;
    /// assert_eq!(other.kinks().iter().map(|kink| other.vertices()[kink.index()]).collect::<Vec<_>>(), [[1.0, 1.0]]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn with_kinks(&self, knots: &[KnotIndex]) -> Result<Self, Error> {
        let mut parts = self.parts_with_kinks(knots)?;
        parts.is_stale.fill(true);
        let graph = parts.fitted(self.order)?;
        match graph.fault()? {
            None => Ok(graph),
            Some(fault) => {
                Err(fault.into_error().with_cure("choose other kinks, or give more points along the edges"))
            }
        }
    }

    /// The interface of splines of another order, or of the same, through the knots of the edges: smooth but for junctions and kinks, which are
    /// these knots, with the number of an edge for [`KnotIndex::curve`]; without a list those that there are.
    ///
    /// Edges that go on smoothly into each other are one spline. Each edge is fitted once, so the phases on both sides stay the same curve.
    ///
    /// # Errors
    /// As [`Self::with_kinks_changed`], and those of the fit, with the number of the edge.
    ///
    /// # Complexity
    /// As [`Self::with_kinks_changed`].
    ///
    /// # Examples
    /// The corners of a square become a curve that is nearly round.
    /// ```
    /// use coface_yin::{Curve, InterfaceGraph, Order, YinSet};
    /// let square = YinSet::new(&[Curve::polyline(&[[0., 0.], [2., 0.], [2., 2.], [0., 2.], [0., 0.]])?])?;
    /// let graph = InterfaceGraph::of_sets(&[square], Order::LINEAR, -1.0)?;
    /// let smooth = graph.fitted(Order::CUBIC, None)?;
    /// assert!(graph.phase_area(0)? == 4.0 && smooth.phase_area(0)? > 5.5);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn fitted(&self, order: Order, kinks: Option<&[KnotIndex]>) -> Result<Self, Error> {
        let Parts { arcs, curves, around, .. } = match kinks {
            Some(knots) => self.parts_with_kinks(knots)?,
            None => Parts::of(self),
        };
        let points: Vec<Vec<[f64; 2]>> = curves.iter().map(knot_points).collect();
        let graph = Self::with_points(arcs, &points, &[], order, Some(around))?;
        match graph.fault()? {
            None => Ok(graph),
            Some(fault) => {
                Err(fault.into_error().with_cure("give more points, or kinks where boundaries bend"))
            }
        }
    }

    /// The graph taken apart, with these kinks and no others.
    fn parts_with_kinks(&self, knots: &[KnotIndex]) -> Result<Parts, Error> {
        let (inner, vertices) = self.places_of(knots)?;
        let kinks: BTreeSet<u32> = self.kinks().into_iter().map(VertexId::to_u32).collect();
        let mut parts = Parts::of(self);
        parts.smooth(&kinks.difference(&vertices).copied().collect());
        parts.sharpen(&vertices.difference(&kinks).copied().collect());
        self.cut_and_join(parts, &inner, &kinks.difference(&vertices).copied().collect())
    }

    fn parts_with_kinks_changed(&self, erased: &[VertexId], inserted: &[KnotIndex]) -> Result<Parts, Error> {
        let kinks: BTreeSet<u32> = self.kinks().into_iter().map(VertexId::to_u32).collect();
        let mut gone = BTreeSet::new();
        for &kink in erased {
            if !kinks.contains(&kink.to_u32()) {
                return Err(Error::new(ErrorKind::NotInComplex, format!("there is no kink {kink:?}"))
                    .with_cure("take the vertex of a kink that is there"));
            }
            if !gone.insert(kink.to_u32()) {
                return Err(
                    Error::invalid(format!("kink {kink:?} comes twice")).with_cure("name each kink once")
                );
            }
        }
        let (inner, vertices) = self.places_of(inserted)?;
        if let Some(kink) = vertices.iter().find(|vertex| kinks.contains(vertex)) {
            return Err(Error::invalid(format!("vertex {kink} is a kink already"))
                .with_cure("insert kinks at other knots"));
        }
        let mut parts = Parts::of(self);
        for at in &inner {
            parts.is_stale[at.curve as usize] = true;
        }
        parts.smooth(&gone);
        parts.sharpen(&vertices);
        // What was one spline with an edge that changes is fitted again.
        for trail in self.trails() {
            if trail.edges().iter().any(|edge| parts.is_stale[edge.edge.index()]) {
                trail.edges().iter().for_each(|edge| parts.is_stale[edge.edge.index()] = true);
            }
        }
        self.cut_and_join(parts, &inner, &gone)
    }

    fn cut_and_join(
        &self,
        mut parts: Parts,
        inner: &BTreeSet<KnotIndex>,
        gone: &BTreeSet<u32>,
    ) -> Result<Parts, Error> {
        parts.cut(&inner.iter().copied().collect::<Vec<_>>());
        parts.join(|vertex| gone.contains(&vertex))?;
        Ok(parts)
    }

    /// Inner knots of edges, and vertices where two edges end, that are named as knots of edges.
    fn places_of(&self, knots: &[KnotIndex]) -> Result<(BTreeSet<KnotIndex>, BTreeSet<u32>), Error> {
        let (mut inner, mut vertices) = (BTreeSet::new(), BTreeSet::new());
        for &at in knots {
            let KnotIndex { curve: edge, knot } = at;
            let Some(curve) = self.curves.get(edge as usize) else {
                return Err(Error::invalid(format!("there is no edge {edge}")).with_cure(
                    match self.edge_count() {
                        0 => "interfaces without edges have no knots".to_owned(),
                        count => format!("the edges are 0 to {}", count - 1),
                    },
                ));
            };
            let count = curve.piece_count() as u32;
            let end = match knot {
                0 => self.ends[edge as usize][0],
                _ if knot == count => self.ends[edge as usize][1],
                _ if knot < count => {
                    if !inner.insert(at) {
                        return Err(Error::invalid(format!("knot {knot} of edge {edge} comes twice"))
                            .with_cure("name each knot once"));
                    }
                    continue;
                }
                _ => {
                    return Err(Error::invalid(format!("there is no knot {knot} on edge {edge}"))
                        .with_cure(format!("the knots are 0 to {count}")));
                }
            };
            if self.around[end as usize].len() > 2 {
                return Err(Error::invalid(format!(
                    "knot {knot} of edge {edge} is a junction, where edges end anyway"
                ))
                .with_cure("name a knot between junctions"));
            }
            if !vertices.insert(end) {
                return Err(
                    Error::invalid(format!("vertex {end} comes twice")).with_cure("name each knot once")
                );
            }
        }
        Ok((inner, vertices))
    }
}

fn check_point(point: [f64; 2]) -> Result<(), Error> {
    if point.iter().all(|x| x.is_finite()) {
        return Ok(());
    }
    Err(Error::invalid("a point is not finite").with_cure("give finite coordinates"))
}
