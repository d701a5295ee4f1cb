//! Edges go through vertices near them, and get a common vertex where they pass near each other.

use super::{NearChains, compare, divided, minus, plus, squared};
use coface_algebra::RaggedArray;
use coface_geometry::{AxisBox, BoxTree, dot};
use rayon::prelude::*;

/// A vertex so many units of the last place of the coordinates away from an edge is on it.
const ON_UNITS: f64 = 4.0;

/// A vertex to put on an edge, and how far along from the lower end.
struct OnEdge {
    edge: u32,
    part: f64,
    vertex: u32,
}

impl NearChains {
    /// Puts vertices on edges that they are near, other than the ends.
    pub(super) fn put_vertices_on_edges(&mut self, tolerance: f64) -> bool {
        let (edges, used) = (self.edges(), self.hot_vertices());
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
                    if let Some(part) = self.part_beside(ends, vertex, limit) {
                        own.push(OnEdge { edge, part, vertex });
                    }
                });
                own
            })
            .collect();
        if self.join_corners(&edges, &found, limit) {
            return true;
        }
        let is_off = |on: &&OnEdge| self.is_off_edge(edges[on.edge as usize], on.vertex, on.part);
        self.counts.edges += found.iter().filter(is_off).count();
        self.divide_edges(&edges, found)
    }

    /// Whether a vertex is not on an edge, but for rounding.
    fn is_off_edge(&self, ends: [u32; 2], vertex: u32, part: f64) -> bool {
        let [a, b] = ends.map(|end| self.point(end));
        let largest = a.iter().chain(&b).fold(0.0, |most: f64, x| most.max(x.abs()));
        let off = plus(minus(self.point(vertex), a), -part, minus(b, a));
        squared(off) > (ON_UNITS * f64::EPSILON * largest).powi(2)
    }

    /// How far along an edge a vertex is, if it is beside the inside and near.
    fn part_beside(&self, ends: [u32; 2], vertex: u32, limit: f64) -> Option<f64> {
        let [a, b] = ends.map(|end| self.point(end));
        let (along, to) = (minus(b, a), minus(self.point(vertex), a));
        let part = dot(along, to) / squared(along);
        (part > 0.0 && part < 1.0 && squared(plus(to, -part, along)) <= limit).then_some(part)
    }

    /// Puts a vertex near an edge and one end of it together where that end is as near to the edge from the vertex to the
    /// other end: each would be put on the edge of the other again and again. They are at most $2 / \sqrt 3$ tolerances
    /// apart.
    fn join_corners(&mut self, edges: &[[u32; 2]], found: &[OnEdge], limit: f64) -> bool {
        let mut pairs: Vec<[u32; 2]> = Vec::new();
        for on in found {
            let [a, b] = edges[on.edge as usize];
            for (from, to) in [(a, b), (b, a)] {
                if self.part_beside([from, on.vertex], to, limit).is_some() {
                    pairs.push([on.vertex, to]);
                }
            }
        }
        let is_first = |a: u32, b: u32| {
            let [first, second] = [a, b].map(|own| self.is_passing[own as usize]);
            first.cmp(&second).then_with(|| compare(self.point(a), self.point(b))).is_lt()
        };
        pairs.iter_mut().filter(|pair| is_first(pair[1], pair[0])).for_each(|pair| pair.swap(0, 1));
        pairs.retain(|&[first, second]| self.may_go(second, first));
        if pairs.is_empty() {
            return false;
        }
        let distance = |&[a, b]: &[u32; 2]| squared(minus(self.point(a), self.point(b)));
        pairs.sort_by(|x, y| {
            let places = |i: usize| compare(self.point(x[i]), self.point(y[i]));
            distance(x).total_cmp(&distance(y)).then_with(|| places(0)).then_with(|| places(1))
        });
        let mut is_used = vec![false; self.points.len()];
        let mut targets = Vec::new();
        for [first, second] in pairs {
            if !is_used[first as usize] && !is_used[second as usize] {
                is_used[first as usize] = true;
                is_used[second as usize] = true;
                targets.push((second, first));
            }
        }
        self.counts.vertices += targets.len();
        self.put(&targets);
        true
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
                    if let Some((parts, middle)) = passing(lines, limit)
                        && self.is_hot(middle)
                    {
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

    /// Makes edges paths through these vertices, in all chains.
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
        let mut is_at_divided = vec![false; self.points.len()];
        for own in &on {
            edges[own.edge as usize].iter().for_each(|&end| is_at_divided[end as usize] = true);
        }
        let path = |[from, to]: [u32; 2]| {
            if !is_at_divided[from as usize] || !is_at_divided[to as usize] {
                return &[][..];
            }
            let edge = edges.binary_search(&[from.min(to), from.max(to)]);
            edge.map_or(&[][..], |edge| paths.list(edge))
        };
        self.chains.par_iter_mut().for_each(|chain| chain.divide(path));
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
