//! Edges go through vertices near them, and get a common vertex where they pass near each other.

use super::panels::divided;
use super::{NearFeatures, compare, minus, plus, squared};
use coface_algebra::RaggedArray;
use coface_geometry::{AxisBox, BoxTree, dot};
use rayon::prelude::*;

/// A vertex to put on an edge, and how far along from the lower end.
struct OnEdge {
    edge: u32,
    part: f64,
    vertex: u32,
}

impl NearFeatures {
    /// Puts vertices on edges that they are near, other than the ends.
    pub(super) fn put_vertices_on_edges(&mut self, tolerance: f64) -> bool {
        let (edges, used) = (self.edges(), self.used());
        let boxes: Vec<AxisBox> = edges.par_iter().map(|&ends| self.box_of(ends, 0.0)).collect();
        let tree = BoxTree::new(&boxes);
        let limit = tolerance * tolerance;
        let found: Vec<OnEdge> = used
            .par_iter()
            .flat_map_iter(|&vertex| {
                let mut own = Vec::new();
                tree.visit(&self.box_of([vertex], tolerance), |edge| {
                    let ends = edges[edge as usize];
                    if ends.contains(&vertex) {
                        return;
                    }
                    let [a, b] = ends.map(|end| self.point(end));
                    let (along, to) = (minus(b, a), minus(self.point(vertex), a));
                    let part = dot(along, to) / squared(along);
                    if part > 0.0 && part < 1.0 && squared(plus(to, -part, along)) <= limit {
                        own.push(OnEdge { edge, part, vertex });
                    }
                });
                own
            })
            .collect();
        self.counts.edges += found.len();
        self.divide_edges(&edges, found)
    }

    /// Gives edges a common vertex where they pass each other inside.
    pub(super) fn cross_edges(&mut self, tolerance: f64) -> bool {
        let edges = self.edges();
        let boxes: Vec<AxisBox> = edges.par_iter().map(|&ends| self.box_of(ends, tolerance / 2.0)).collect();
        let tree = BoxTree::new(&boxes);
        let limit = tolerance * tolerance;
        let mut found: Vec<([u32; 2], [f64; 2], [f64; 3])> = (0..tree.group_count())
            .into_par_iter()
            .flat_map_iter(|group| {
                let mut own = Vec::new();
                tree.pairs_of_group(group, |d, e| {
                    let (d, e) = (d.min(e), d.max(e));
                    let ends = [d, e].map(|edge| edges[edge as usize]);
                    if ends[0].iter().any(|end| ends[1].contains(end)) {
                        return;
                    }
                    let lines = ends.map(|ends| ends.map(|end| self.point(end)));
                    if let Some((parts, middle)) = passing(lines, limit) {
                        own.push(([d, e], parts, middle));
                    }
                });
                own
            })
            .collect();
        found.sort_by(|x, y| compare(x.2, y.2));
        self.counts.crossings += found.len();
        let mut on = Vec::with_capacity(2 * found.len());
        for (pair, parts, middle) in found {
            let vertex = self.add_point(middle);
            on.extend([0, 1].map(|i| OnEdge { edge: pair[i], part: parts[i], vertex }));
        }
        self.divide_edges(&edges, on)
    }

    /// Makes edges paths through these vertices, in all panels.
    fn divide_edges(&mut self, edges: &[[u32; 2]], mut on: Vec<OnEdge>) -> bool {
        if on.is_empty() {
            return false;
        }
        on.sort_by(|x, y| {
            let places = || compare(self.point(x.vertex), self.point(y.vertex));
            x.edge.cmp(&y.edge).then(x.part.total_cmp(&y.part)).then_with(places)
        });
        let mut paths = RaggedArray::grouped(edges.len(), on.iter().map(|own| own.edge));
        paths.items_mut().iter_mut().for_each(|item| *item = on[*item as usize].vertex);
        let path = |[from, to]: [u32; 2]| {
            let edge = edges.binary_search(&[from.min(to), from.max(to)]);
            edge.map_or(&[][..], |edge| paths.list(edge))
        };
        self.panels.par_iter_mut().for_each(|panel| panel.divide(path));
        self.lines = divided(&self.lines, path);
        true
    }
}

/// Where two segments pass each other inside, if that is near: how far along each, and the point in the middle.
fn passing([[a, b], [c, d]]: [[[f64; 3]; 2]; 2], limit: f64) -> Option<([f64; 2], [f64; 3])> {
    let (u, v, w) = (minus(b, a), minus(d, c), minus(a, c));
    let (uu, uv, vv) = (dot(u, u), dot(u, v), dot(v, v));
    let (uw, vw) = (dot(u, w), dot(v, w));
    let determinant = uu * vv - uv * uv;
    if determinant <= 0.0 {
        return None;
    }
    let (s, t) = ((uv * vw - vv * uw) / determinant, (uu * vw - uv * uw) / determinant);
    let is_inside = |part: f64| part > 0.0 && part < 1.0;
    if !is_inside(s) || !is_inside(t) {
        return None;
    }
    let (p, q) = (plus(a, s, u), plus(c, t, v));
    let between = minus(q, p);
    (squared(between) <= limit).then(|| ([s, t], plus(p, 0.5, between)))
}
