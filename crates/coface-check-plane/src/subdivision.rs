//! The vertices and edges of a certificate: they are what the segments of the inputs are cut into, and no two edges cross.

use crate::drawing::Drawing;
use crate::point::{Point, side};
use coface_check::Fault;
use coface_check::json::{field, index, list};
use serde_json::Value;
use std::cmp::Ordering;

/// Vertices and edges of which no two meet but in vertices, with what a sweep finds.
pub(crate) struct Subdivision {
    pub(crate) vertices: Vec<Point>,
    /// The lower vertex of each edge, then the upper one.
    pub(crate) edges: Vec<[u32; 2]>,
    /// For each edge the rings along it, and 1 for those that run up, -1 for those that run down.
    pub(crate) rings: Vec<Vec<(u32, i64)>>,
    /// Around each vertex the halfedges that leave it, counterclockwise. Halfedge 2e runs up edge e, and 2e + 1 down.
    pub(crate) around: Vec<Vec<u32>>,
    /// For each vertex the edge next below it.
    pub(crate) below: Vec<Option<u32>>,
}

impl Subdivision {
    /// Reads the proof and tests it against the segments.
    pub(crate) fn read(proof: &Value, drawing: &Drawing) -> Result<Self, Fault> {
        let step = "vertices";
        let vertices = list(field(proof, "vertices", step)?, "\"vertices\"", step)?;
        let vertices = vertices.iter().map(|vertex| Point::read(vertex, step));
        let vertices = vertices.collect::<Result<Vec<_>, _>>()?;
        if let Some(at) = vertices.windows(2).position(|pair| pair[0].compare(&pair[1]).is_ge()) {
            return Err(Fault::new(step, format!("vertices {at} and {} do not rise", at + 1)));
        }
        let (pieces, reasons) = pieces(proof, drawing, &vertices)?;
        let mut edges: Vec<[u32; 2]> = Vec::new();
        let mut rings: Vec<Vec<(u32, i64)>> = Vec::new();
        for ends in pieces.chunk_by(|a, b| a.0 == b.0) {
            edges.push(ends[0].0);
            rings.push(ends.iter().filter_map(|&(_, ring, sign)| Some((ring?, sign))).collect());
        }
        let count = vertices.len();
        let (around, below) = (vec![Vec::new(); count], vec![None; count]);
        let mut found = Self { vertices, edges, rings, around, below };
        found.sweep()?;
        if let Some(at) = reasons.iter().position(|reason| *reason != Reason::Corner) {
            let message = format!("vertex {at} is no end of a segment, and no two segments cross there");
            return Err(Fault::new(step, message));
        }
        Ok(found)
    }

    fn ends(&self, edge: u32) -> [&Point; 2] {
        self.edges[edge as usize].map(|vertex| &self.vertices[vertex as usize])
    }

    /// On which side of an edge, which runs up, a vertex lies: greater above it.
    fn above(&self, vertex: usize, edge: u32) -> Ordering {
        let [low, high] = self.ends(edge);
        side(low, high, &self.vertices[vertex])
    }

    /// Runs through the vertices in their order with the edges that are on the sweep line, from below. Edges that become neighbors there
    /// are tested (M. I. Shamos and D. Hoey, 1976).
    fn sweep(&mut self) -> Result<(), Fault> {
        let mut ending = vec![0usize; self.vertices.len()];
        let mut starting: Vec<Vec<u32>> = vec![Vec::new(); self.vertices.len()];
        for (edge, ends) in (0u32..).zip(&self.edges) {
            starting[ends[0] as usize].push(edge);
            ending[ends[1] as usize] += 1;
        }
        let mut line: Vec<u32> = Vec::new();
        for vertex in 0..self.vertices.len() {
            let fault = |message: String| Err(Fault::new("sweep", message));
            let first = line.partition_point(|&edge| self.above(vertex, edge).is_gt());
            let last = first + ending[vertex];
            for (i, &edge) in line.iter().enumerate().skip(first).take(ending[vertex] + 1) {
                let ends_here = self.edges[edge as usize][1] as usize == vertex;
                if ends_here != (i < last) || (!ends_here && self.above(vertex, edge).is_ge()) {
                    return fault(format!("vertex {vertex} lies on edge {edge}, or edges cross before it"));
                }
            }
            if last > line.len() {
                return fault(format!("edges that end at vertex {vertex} cross others before it"));
            }
            let own = &mut starting[vertex];
            let upper = |edge: u32| &self.vertices[self.edges[edge as usize][1] as usize];
            own.sort_by(|&a, &b| side(&self.vertices[vertex], upper(b), upper(a)));
            for pair in own.windows(2) {
                if side(&self.vertices[vertex], upper(pair[0]), upper(pair[1])).is_eq() {
                    return fault(format!("edges {} and {} overlap", pair[0], pair[1]));
                }
            }
            let leaving = own.iter().map(|edge| 2 * edge);
            let arriving = line[first..last].iter().rev().map(|edge| 2 * edge + 1);
            self.around[vertex] = leaving.chain(arriving).collect();
            self.below[vertex] = first.checked_sub(1).map(|below| line[below]);
            let count = own.len();
            line.splice(first..last, own.drain(..));
            for upper in [first, first + count] {
                if let (Some(&a), Some(&b)) =
                    (upper.checked_sub(1).and_then(|a| line.get(a)), line.get(upper))
                    && self.cross(a, b)
                {
                    return fault(format!("edges {a} and {b} cross"));
                }
            }
        }
        Ok(())
    }

    /// Whether each of two edges has its ends on both sides of the other.
    fn cross(&self, a: u32, b: u32) -> bool {
        let parts = |a: u32, b: u32| {
            let [low, high] = self.ends(a);
            let [p, q] = self.ends(b).map(|end| side(low, high, end));
            p.is_ne() && p == q.reverse()
        };
        parts(a, b) && parts(b, a)
    }
}

/// The vertices at the ends of a piece, the lower first; the ring along it; 1 if that runs up, else -1.
type Piece = ([u32; 2], Option<u32>, i64);

/// Why a point is a vertex.
#[derive(Clone, Copy, PartialEq)]
enum Reason {
    /// There is none yet.
    Nothing,
    /// It lies inside of this segment, and of others along the same line.
    Inside(usize),
    /// It is an end of a segment, or two that run in different directions have it.
    Corner,
}

/// The pieces of all segments, sorted, and why each vertex is one. Each segment is
/// covered by its pieces, and each piece lies on it.
fn pieces(proof: &Value, drawing: &Drawing, vertices: &[Point]) -> Result<(Vec<Piece>, Vec<Reason>), Fault> {
    let step = "chains";
    let chains = list(field(proof, "chains", step)?, "\"chains\"", step)?;
    let segments = drawing.segments();
    if chains.len() != segments.len() {
        let message = format!("{} chains are there for {} segments", chains.len(), segments.len());
        return Err(Fault::new(step, message));
    }
    let mut pieces = Vec::new();
    let mut reasons = vec![Reason::Nothing; vertices.len()];
    for (number, (chain, ends)) in chains.iter().zip(segments).enumerate() {
        let fault = |what: &str| Err(Fault::new(step, format!("the chain of segment {number} {what}")));
        let chain = list(chain, "a chain", step)?.iter().map(|vertex| index(vertex, "a vertex", step));
        let chain = chain.collect::<Result<Vec<u32>, _>>()?;
        if chain.iter().any(|&vertex| vertex as usize >= vertices.len()) {
            return fault("has a vertex that is not there");
        }
        let point = |vertex: u32| &vertices[vertex as usize];
        let [from, to] = ends.map(Point::of);
        let (Some(&first), Some(&last)) = (chain.first(), chain.last()) else { return fault("is empty") };
        if point(first).compare(&from).is_ne() || point(last).compare(&to).is_ne() {
            return fault("does not have the ends of the segment");
        }
        // Along a line the order of vertices is that of their numbers, or its reverse.
        let rises = first < last;
        if !chain.windows(2).all(|pair| pair[0] != pair[1] && (pair[0] < pair[1]) == rises) {
            return fault("does not run straight on");
        }
        if chain.iter().any(|&vertex| side(&from, &to, point(vertex)).is_ne()) {
            return fault("leaves the line of the segment");
        }
        for (at, &vertex) in chain.iter().enumerate() {
            let reason = &mut reasons[vertex as usize];
            *reason = match *reason {
                _ if at == 0 || at + 1 == chain.len() => Reason::Corner,
                Reason::Nothing => Reason::Inside(number),
                // Both segments have the vertex: they lie on one line if an end of the one is on the line of the other.
                Reason::Inside(first) if side(&from, &to, &Point::of(segments[first][0])).is_ne() => {
                    Reason::Corner
                }
                before => before,
            };
        }
        let ring = drawing.ring_of(number);
        pieces.extend(
            chain
                .windows(2)
                .map(|pair| ([pair[0].min(pair[1]), pair[0].max(pair[1])], ring, if rises { 1 } else { -1 })),
        );
    }
    pieces.sort_unstable();
    Ok((pieces, reasons))
}
