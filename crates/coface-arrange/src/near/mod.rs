//! Edges whose ends and insides that are nearer to each other than a tolerance become one.
//!
//! A **chain** is a list of sides, as around a face or along a segment. All that is done is a chain map: vertices are put
//! together, a side becomes a path through a vertex near it in all chains, and so do two sides that pass near each
//! other; sides that cancel are gone. So what has no boundary before has none after, whatever the tolerance.
//!
//! All distances are in floating point. The order in which things are done depends on distances and coordinates alone,
//! not on numbers.

mod edges;
mod hot_places;
mod joined;
mod movement;
mod precision;
mod vertices;

pub(crate) use hot_places::HotPlaces;
pub use joined::JoinedFeatures;
pub(crate) use joined::{NONE, STEADY_ROUNDS, least_tolerance, reach};
pub use precision::CoordinatePrecision;

use coface_geometry::{AxisBox, dot};
use movement::MovementBound;

/// After so many passes a rest that is still near something is left to the next cut.
const MOST_PASSES: usize = 64;

/// Chains of edges on points.
#[derive(Clone, Debug, Default)]
pub(crate) struct NearChains {
    pub(crate) points: Vec<[f64; 3]>,
    pub(crate) chains: Vec<Chain>,
    /// Edges that need not be in a chain, as where two faces cross and both go on.
    pub(crate) lines: Vec<[u32; 2]>,
    /// Vertices that need not be in a chain.
    pub(crate) alone: Vec<u32>,
    /// Whether a point gives way to others, as those do that no input has.
    pub(crate) is_passing: Vec<bool>,
    /// The point that each point was put to; itself for most.
    target: Vec<u32>,
    pub(crate) counts: NearCounts,
    /// What new points are rounded to.
    pub(crate) precision: CoordinatePrecision,
    /// Where features are put together; everywhere without.
    hot: Option<HotPlaces>,
    /// How far points may go in all, where that is bounded.
    bound: Option<MovementBound>,
    /// With more points features are not put together any more, where that is bounded.
    pub(crate) most_points: Option<usize>,
}

/// Sides, of which no two cancel.
#[derive(Clone, Debug)]
pub(crate) struct Chain {
    /// What the chain is of, by a number of its own.
    pub(crate) owner: u32,
    /// Of a side that is there more than once, all.
    pub(crate) sides: Vec<[u32; 2]>,
    /// The vertices that were put inside of what the chain is around.
    pub(crate) inside: Vec<u32>,
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
    pub(crate) fn add(&mut self, other: &Self) {
        self.planes += other.planes;
        self.vertices += other.vertices;
        self.edges += other.edges;
        self.crossings += other.crossings;
        self.faces += other.faces;
    }
}

impl NearChains {
    /// Points that are where they are, and chains on them.
    pub(crate) fn new(
        points: Vec<[f64; 3]>,
        chains: Vec<Chain>,
        lines: Vec<[u32; 2]>,
        is_passing: Vec<bool>,
    ) -> Self {
        let target = (0..points.len() as u32).collect();
        Self { points, chains, lines, is_passing, target, ..Self::default() }
    }

    /// Puts together what is at most this far apart. `go_on` does so with what is more than edges, and says whether there
    /// was anything. Returns whether nothing is left that is so near.
    ///
    /// # Complexity
    /// $O(n \log n)$ a pass for n sides that are near few others; a few passes.
    pub(crate) fn join(&mut self, tolerance: f64, go_on: impl Fn(&mut Self) -> bool) -> bool {
        for _ in 0..MOST_PASSES {
            if self.has_too_many_points() {
                return false;
            }
            let joined = self.join_vertices(tolerance);
            let went_on = self.put_vertices_on_edges(tolerance) || self.cross_edges(tolerance) || go_on(self);
            if !joined && !went_on {
                return true;
            }
        }
        false
    }

    /// Whether there are more points than there may be.
    pub(crate) fn has_too_many_points(&self) -> bool {
        self.most_points.is_some_and(|most| self.points.len() > most)
    }

    /// The vertices that there are and that may be put together, rising.
    pub(crate) fn hot_vertices(&self) -> Vec<u32> {
        let mut used = self.used();
        if self.hot.is_some() {
            used.retain(|&vertex| self.is_hot(self.point(vertex)));
        }
        used
    }

    /// The vertices that there are, rising.
    pub(crate) fn used(&self) -> Vec<u32> {
        let mut is_used = vec![false; self.points.len()];
        let sides = self.chains.iter().flat_map(|chain| chain.sides.as_flattened());
        let ends = sides.chain(self.lines.as_flattened()).chain(&self.alone);
        ends.for_each(|&end| is_used[end as usize] = true);
        (0..self.points.len() as u32).filter(|&point| is_used[point as usize]).collect()
    }

    /// The sides of chains and the lines, rising, the lower end first.
    pub(crate) fn edges(&self) -> Vec<[u32; 2]> {
        let sides = self.chains.iter().flat_map(|chain| &chain.sides).chain(&self.lines);
        let mut edges: Vec<[u32; 2]> = sides.map(|&[a, b]| [a.min(b), a.max(b)]).collect();
        edges.sort_unstable();
        edges.dedup();
        edges
    }

    pub(crate) fn point(&self, vertex: u32) -> [f64; 3] {
        self.points[vertex as usize]
    }

    /// The box around some vertices, and this much around that.
    pub(crate) fn box_of(&self, vertices: impl IntoIterator<Item = u32>, margin: f64) -> AxisBox {
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
        self.points.push(self.precision.rounded_point(point));
        self.target.push(number);
        self.is_passing.push(true);
        if let Some(bound) = &mut self.bound {
            bound.ways.push(0.0);
        }
        number
    }

    /// The point that a point was put to in the end.
    pub(crate) fn end_of(&self, mut point: u32) -> u32 {
        while self.target[point as usize] != point {
            point = self.target[point as usize];
        }
        point
    }
}

impl Chain {
    pub(crate) fn new(owner: u32, sides: Vec<[u32; 2]>) -> Self {
        Self { owner, sides, inside: Vec::new() }
    }

    /// Follows vertices to where they were put.
    fn put(&mut self, target: &[u32]) {
        let is_put = |&vertex: &u32| target[vertex as usize] != vertex;
        if self.sides.as_flattened().iter().any(is_put) {
            self.sides.as_flattened_mut().iter_mut().for_each(|end| *end = target[*end as usize]);
            self.cancel();
        }
        self.inside.iter_mut().for_each(|vertex| *vertex = target[*vertex as usize]);
    }

    /// Makes sides paths through the vertices that are given for them, from the lower end on.
    fn divide<'a>(&mut self, path: impl Fn([u32; 2]) -> &'a [u32]) {
        if self.sides.iter().all(|&side| path(side).is_empty()) {
            return;
        }
        self.sides = divided(&self.sides, path);
        self.cancel();
    }

    /// Drops sides without length and pairs of opposite ones. The rest is in no order.
    pub(crate) fn cancel(&mut self) {
        self.sides.retain(|[a, b]| a != b);
        self.sides.sort_unstable_by_key(|&[a, b]| ([a.min(b), a.max(b)], a > b));
        let mut kept: Vec<[u32; 2]> = Vec::with_capacity(self.sides.len());
        for group in self.sides.chunk_by(|x, y| x == y || *x == [y[1], y[0]]) {
            let up = group.iter().filter(|[a, b]| a < b).count();
            let down = group.len() - up;
            let first = if up > down { group[0] } else { group[group.len() - 1] };
            kept.extend(std::iter::repeat_n(first, up.abs_diff(down)));
        }
        self.sides = kept;
    }
}

/// Whether some sides are the boundary of triangles.
pub(crate) fn is_boundary(sides: impl IntoIterator<Item = [u32; 2]>, triangles: &[[u32; 3]]) -> bool {
    let of_triangles = triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    let back = sides.into_iter().map(|[a, b]| [b, a]);
    let mut rest = Chain::new(0, of_triangles.chain(back).collect());
    rest.cancel();
    rest.sides.is_empty()
}

/// Sides as paths through the vertices that are given for them, from the lower end on.
fn divided<'a>(sides: &[[u32; 2]], path: impl Fn([u32; 2]) -> &'a [u32]) -> Vec<[u32; 2]> {
    let mut divided = Vec::with_capacity(2 * sides.len());
    for &[from, to] in sides {
        let mut last = from;
        let inner = path([from, to]);
        let mut step = |next: u32| {
            divided.push([last, next]);
            last = next;
        };
        if from < to {
            inner.iter().copied().for_each(&mut step);
        } else {
            inner.iter().rev().copied().for_each(&mut step);
        }
        step(to);
    }
    divided
}

/// `a - b`.
pub(crate) fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// `a + t d`.
pub(crate) fn plus(a: [f64; 3], t: f64, d: [f64; 3]) -> [f64; 3] {
    [a[0] + t * d[0], a[1] + t * d[1], a[2] + t * d[2]]
}

pub(crate) fn squared(a: [f64; 3]) -> f64 {
    dot(a, a)
}

/// The lexicographic order of points.
pub(crate) fn compare(a: [f64; 3], b: [f64; 3]) -> std::cmp::Ordering {
    let pairs = a.iter().zip(&b);
    pairs.map(|(a, b)| a.total_cmp(b)).find(|order| order.is_ne()).unwrap_or(std::cmp::Ordering::Equal)
}
