//! Faces whose vertices, edges and insides that are nearer to each other than a tolerance become one.
//!
//! A **panel** is a face that is flat within the tolerance, by the chain of its sides; a polygon that is not is a panel
//! for each of its triangles. All that is done is a chain map: vertices are put together, a side becomes a path through
//! a vertex near it in all panels, and so do two sides that pass near each other; sides that cancel are gone. In the end
//! each panel is a chain of triangles with that boundary. So what has no boundary before has none after, whatever the
//! tolerance.
//!
//! When nothing is near anything any more, vertices and sides are further apart than the tolerance, but for sides that
//! go through panels far from everything else: these are for the exact cut to find. Sides and vertices that lie on a
//! panel divide it, and each part is triangulated by its own sides alone, seen along the same axis whatever panel it
//! is part of: so panels that lie on each other have the same triangles there.
//!
//! All distances are in floating point. The order in which things are done depends on distances and coordinates alone,
//! not on numbers.

mod edges;
mod panels;
mod planes;
mod vertices;

pub(super) use planes::flattened;

use coface_geometry::{AxisBox, dot};
use panels::Panel;

/// After so many passes a rest that is still near something is left to the next cut.
const MOST_PASSES: usize = 64;

/// Panels on points.
#[derive(Clone, Debug, Default)]
pub(super) struct NearFeatures {
    pub(super) points: Vec<[f64; 3]>,
    panels: Vec<Panel>,
    /// Edges that need not be sides, as where two faces cross and both go on.
    lines: Vec<[u32; 2]>,
    /// Whether a point is none of those of polygons: it gives way to these.
    pub(super) is_passing: Vec<bool>,
    /// The point that each point was put to; itself for most.
    target: Vec<u32>,
    pub(super) counts: NearCounts,
}

/// How often features were put together.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct NearCounts {
    /// Polygons whose planes were replaced by one that fits several.
    pub planes: usize,
    /// Vertices put to another vertex.
    pub vertices: usize,
    /// Vertices put on edges.
    pub edges: usize,
    /// Pairs of edges that were given a common vertex.
    pub crossings: usize,
    /// Vertices put on faces.
    pub faces: usize,
}

impl NearCounts {
    pub(super) fn add(&mut self, other: &Self) {
        self.planes += other.planes;
        self.vertices += other.vertices;
        self.edges += other.edges;
        self.crossings += other.crossings;
        self.faces += other.faces;
    }
}

impl NearFeatures {
    /// Puts together what is at most this far apart.
    ///
    /// # Complexity
    /// $O(n \log n)$ a pass for n sides that are near few others; a few passes.
    pub(super) fn join(&mut self, tolerance: f64) {
        for _ in 0..MOST_PASSES {
            let joined = self.join_vertices(tolerance);
            let went_on = self.put_vertices_on_edges(tolerance)
                || self.cross_edges(tolerance)
                || self.put_vertices_on_panels(tolerance);
            if !joined && !went_on {
                break;
            }
        }
    }

    /// The vertices that panels have, rising.
    fn used(&self) -> Vec<u32> {
        let mut is_used = vec![false; self.points.len()];
        let sides = self.panels.iter().flat_map(|panel| panel.sides.as_flattened());
        sides.chain(self.lines.as_flattened()).for_each(|&end| is_used[end as usize] = true);
        (0..self.points.len() as u32).filter(|&point| is_used[point as usize]).collect()
    }

    /// The sides of panels and the lines, rising, the lower end first.
    fn edges(&self) -> Vec<[u32; 2]> {
        let sides = self.panels.iter().flat_map(|panel| &panel.sides).chain(&self.lines);
        let mut edges: Vec<[u32; 2]> = sides.map(|&[a, b]| [a.min(b), a.max(b)]).collect();
        edges.sort_unstable();
        edges.dedup();
        edges
    }

    fn point(&self, vertex: u32) -> [f64; 3] {
        self.points[vertex as usize]
    }

    /// The box around some vertices, and this much around that.
    fn box_of(&self, vertices: impl IntoIterator<Item = u32>, margin: f64) -> AxisBox {
        let mut own = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
        for vertex in vertices {
            for (own, x) in own.iter_mut().zip(self.point(vertex)) {
                *own = [own[0].min(x), own[1].max(x)];
            }
        }
        own.map(|[low, high]| [low - margin, high + margin])
    }

    fn add_point(&mut self, point: [f64; 3]) -> u32 {
        let number = self.points.len() as u32;
        self.points.push(point);
        self.target.push(number);
        self.is_passing.push(true);
        number
    }

    /// The point that a point was put to in the end.
    pub(super) fn end_of(&self, mut point: u32) -> u32 {
        while self.target[point as usize] != point {
            point = self.target[point as usize];
        }
        point
    }
}

/// `a - b`.
fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// `a + t d`.
fn plus(a: [f64; 3], t: f64, d: [f64; 3]) -> [f64; 3] {
    [a[0] + t * d[0], a[1] + t * d[1], a[2] + t * d[2]]
}

fn squared(a: [f64; 3]) -> f64 {
    dot(a, a)
}

/// The lexicographic order of points.
fn compare(a: [f64; 3], b: [f64; 3]) -> std::cmp::Ordering {
    let pairs = a.iter().zip(&b);
    pairs.map(|(a, b)| a.total_cmp(b)).find(|order| order.is_ne()).unwrap_or(std::cmp::Ordering::Equal)
}
