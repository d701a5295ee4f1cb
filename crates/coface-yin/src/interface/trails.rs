//! Edges that go on smoothly into each other, and their common splines.

use crate::{Curve, EndCondition, Order};
use coface_algebra::{EdgeId, Error, Sign};

/// An edge in one of its two directions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct DirectedEdge {
    /// The edge.
    pub edge: EdgeId,
    /// Along it or against it.
    pub sign: Sign,
}

impl DirectedEdge {
    /// The edge from its start to its end.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::EdgeId;
    /// use coface_yin::DirectedEdge;
    /// assert_eq!(DirectedEdge::along(EdgeId::new(3)).edge, EdgeId::new(3));
    /// ```
    pub fn along(edge: EdgeId) -> Self {
        Self { edge, sign: Sign::Plus }
    }

    /// The edge from its end to its start.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::EdgeId;
    /// use coface_yin::DirectedEdge;
    /// let edge = EdgeId::new(3);
    /// assert_ne!(DirectedEdge::against(edge), DirectedEdge::along(edge));
    /// ```
    pub fn against(edge: EdgeId) -> Self {
        Self { edge, sign: Sign::Minus }
    }

    /// The other direction.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::EdgeId;
    /// use coface_yin::DirectedEdge;
    /// let edge = EdgeId::new(3);
    /// assert_eq!(DirectedEdge::against(edge).reversed(), DirectedEdge::along(edge));
    /// ```
    pub fn reversed(self) -> Self {
        Self { sign: self.sign.opposite(), ..self }
    }

    /// The place in arrays with two entries an edge.
    pub(super) fn index(self) -> usize {
        2 * self.edge.index() + usize::from(self.sign == Sign::Minus)
    }

    pub(super) fn at(index: usize) -> Self {
        let edge = EdgeId::new(index / 2);
        if index.is_multiple_of(2) { Self::along(edge) } else { Self::against(edge) }
    }
}

/// Edges that are fitted by one spline.
#[derive(Clone, Debug, PartialEq)]
pub struct Trail {
    edges: Vec<DirectedEdge>,
    is_circuit: bool,
}

impl Trail {
    /// The edges in order.
    ///
    /// # Examples
    /// One triangle, whose boundary is an edge from a base point to itself.
    /// ```
    /// use coface_algebra::EdgeId;
    /// use coface_yin::{DirectedEdge, InterfaceEdge, InterfaceGraph, Order};
    /// let edge = InterfaceEdge { ends: [0, 0], markers: vec![[1.0, 0.0], [0.0, 1.0]], phases: [Some(0), None] };
    /// let around = [DirectedEdge::along(EdgeId::new(0)); 2];
    /// let graph = InterfaceGraph::new(&[[0.0, 0.0]], &[edge], &[around], Order::LINEAR)?;
    /// assert_eq!(graph.trails()[0].edges(), [DirectedEdge::along(EdgeId::new(0))]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn edges(&self) -> &[DirectedEdge] {
        &self.edges
    }

    /// Whether the last edge goes on smoothly into the first.
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
    pub fn is_circuit(&self) -> bool {
        self.is_circuit
    }
}

/// The maximal chains under smooth pairs, by their lowest edges.
pub(super) fn trails_of(ends: &[[u32; 2]], pairs: &[[DirectedEdge; 2]]) -> Result<Vec<Trail>, Error> {
    let tail = |edge: DirectedEdge| ends[edge.edge.index()][usize::from(edge.sign == Sign::Minus)];
    let mut next: Vec<Option<DirectedEdge>> = vec![None; 2 * ends.len()];
    for (number, &[from, to]) in pairs.iter().enumerate() {
        if let Some(edge) = [from, to].iter().find(|edge| edge.edge.index() >= ends.len()) {
            return Err(Error::invalid(format!(
                "smooth pair {number} names edge {}, which there is not",
                edge.edge.index()
            )));
        }
        if tail(from.reversed()) != tail(to) || from == to.reversed() {
            return Err(Error::invalid(format!(
                "edge {} of smooth pair {number} does not lead to where edge {} begins",
                from.edge.index(),
                to.edge.index()
            ))
            .with_cure("give an edge that comes to a vertex and another end there"));
        }
        for [from, to] in [[from, to], [to.reversed(), from.reversed()]] {
            if next[from.index()].is_some_and(|known| known != to) {
                return Err(Error::invalid(format!(
                    "edge {} goes on smoothly into two edges at vertex {}",
                    from.edge.index(),
                    tail(from.reversed())
                ))
                .with_cure("give each end of an edge in one pair at most"));
            }
            next[from.index()] = Some(to);
        }
    }
    let mut is_used = vec![false; ends.len()];
    let mut trails = Vec::new();
    for edge in 0..ends.len() {
        if is_used[edge] {
            continue;
        }
        // Back to the beginning, or around to the edge itself.
        let own = DirectedEdge::along(EdgeId::new(edge));
        let mut first = own;
        let mut is_circuit = false;
        while let Some(before) = next[first.reversed().index()] {
            first = before.reversed();
            if first == own {
                is_circuit = true;
                break;
            }
        }
        let mut edges = vec![first];
        is_used[first.edge.index()] = true;
        let mut at = first;
        while let Some(after) = next[at.index()].filter(|&after| after != first) {
            edges.push(after);
            is_used[after.edge.index()] = true;
            at = after;
        }
        trails.push(Trail { edges, is_circuit });
    }
    Ok(trails)
}

/// The curves of the edges of trails: parts of the splines of these. Where parameters of the points of all edges of a trail are given they are those of
/// the spline, else it is fitted by length.
pub(super) fn fitted_edges(
    points: &[Vec<[f64; 2]>],
    parameters: &[Option<Vec<f64>>],
    trails: &[Trail],
    order: Order,
) -> Result<Vec<(EdgeId, Curve<'static>)>, Error> {
    let mut curves = Vec::new();
    for trail in trails {
        let mut way: Vec<[f64; 2]> = Vec::new();
        for edge in &trail.edges {
            let own = &points[edge.edge.index()];
            way.pop();
            match edge.sign {
                Sign::Plus => way.extend_from_slice(own),
                Sign::Minus => way.extend(own.iter().rev()),
            }
        }
        let ends = if trail.is_circuit { EndCondition::Periodic } else { EndCondition::NotAKnot };
        let named = |error: Error| {
            let said = Error::new(
                error.kind(),
                format!("the trail from edge {}: {}", trail.edges[0].edge.index(), error.message()),
            );
            match error.cure() {
                Some(cure) => said.with_cure(cure),
                None => said,
            }
        };
        let spline = match trail_parameters(trail, parameters) {
            Some(known) => Curve::fit_at(&way, &known, order, &ends),
            None => Curve::fit_by_length(&way, order, &ends),
        };
        let spline = spline.map_err(named)?;
        let mut from = 0;
        for edge in &trail.edges {
            let to = from + points[edge.edge.index()].len() - 1;
            let degree = order.degree();
            let controls = spline.controls()[from * degree..=to * degree].to_vec();
            let knots = spline.knots()[from..=to].iter().map(|knot| knot - spline.knots()[from]).collect();
            let part = Curve::from_controls(order, controls, knots)?;
            curves.push((edge.edge, if edge.sign == Sign::Plus { part } else { part.reversed() }));
            from = to;
        }
    }
    Ok(curves)
}

/// The parameters of the points of a trail, from those of its edges one after the other, if they are given and rise.
fn trail_parameters(trail: &Trail, parameters: &[Option<Vec<f64>>]) -> Option<Vec<f64>> {
    let mut known = vec![0.0];
    for edge in &trail.edges {
        let own = parameters.get(edge.edge.index())?.as_deref()?;
        let (start, end) = (known[known.len() - 1], (own[0], own[own.len() - 1]));
        match edge.sign {
            Sign::Plus => known.extend(own[1..].iter().map(|parameter| start + (parameter - end.0))),
            Sign::Minus => {
                known.extend(own.iter().rev().skip(1).map(|parameter| start + (end.1 - parameter)));
            }
        }
    }
    known.windows(2).all(|pair| pair[0] < pair[1]).then_some(known)
}
