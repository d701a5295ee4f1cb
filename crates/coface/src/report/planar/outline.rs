//! Sets of faces as polygons with holes.

use super::sides::Sides;
use crate::algebra::{RaggedArray, UnionFind};
use crate::geometry::predicates::orientation;
use crate::{EdgeId, FaceId, HalfedgeId, VertexId};
use std::cmp::Ordering;

/// A face in no set, a vertex that is not there.
pub(super) const NONE: u32 = u32::MAX;

/// The rims of sets of faces: polygons whose inner points are connected, with holes; all rings are simple.
///
/// Rings have the set on their left: outer ones run counterclockwise, holes clockwise. Rings may touch in vertices.
#[derive(Clone, Debug, Default)]
pub(super) struct Outline {
    /// The vertices of the arrangement that are corners, rising.
    pub(super) vertices: Vec<u32>,
    /// The rings by positions in `vertices`, the lowest first; of each polygon the outer ring, then the holes.
    pub(super) rings: RaggedArray,
    /// The first ring of each polygon, and the number of rings.
    pub(super) polygons: Vec<u32>,
    /// The polygon of each face, `NONE` for those in no set.
    pub(super) polygon_of_face: Vec<u32>,
    /// The sides of all rings, lower end first, rising, each once, with the segments along it.
    pub(super) edges: Vec<[u32; 2]>,
    pub(super) segments: RaggedArray,
}

/// How outlines are made.
struct Tracer<'a> {
    sides: &'a Sides<'a>,
    /// The set of each face.
    labels: &'a [u32],
}

impl Tracer<'_> {
    fn label(&self, halfedge: u32) -> u32 {
        let face = self.sides.arrangement.face_of(HalfedgeId::from_u32(halfedge));
        face.map_or(NONE, |face| self.labels[face.index()])
    }

    /// Whether a halfedge has a set on its left and something else on its right.
    fn is_rim(&self, halfedge: u32) -> bool {
        let label = self.label(halfedge);
        label != NONE && label != self.label(halfedge ^ 1)
    }

    fn tail(&self, halfedge: u32) -> u32 {
        self.sides.arrangement.ends(EdgeId::from_u32(halfedge / 2))[halfedge as usize % 2].to_u32()
    }

    /// The rim after this one with the same connected part on its left.
    fn next(&self, halfedge: u32) -> u32 {
        let after = |halfedge: u32| self.sides.arrangement.next(HalfedgeId::from_u32(halfedge)).to_u32();
        let mut next = after(halfedge);
        while !self.is_rim(next) {
            next = after(next ^ 1);
        }
        next
    }

    /// Whether a simple ring of halfedges runs counterclockwise.
    fn is_outer(&self, ring: &[u32]) -> bool {
        let lowest = (0..ring.len()).min_by_key(|&i| self.tail(ring[i])).unwrap_or(0);
        let (out, back) = (ring[lowest], ring[(lowest + ring.len() - 1) % ring.len()] ^ 1);
        // Everything at the lowest vertex goes up, from straight down on counterclockwise.
        let around = self.sides.arrangement.halfedges_around(VertexId::from_u32(self.tail(out)));
        let first = around.map(HalfedgeId::to_u32).find(|&halfedge| halfedge == out || halfedge == back);
        first == Some(out)
    }

    /// Cuts a closed walk where it comes back to a vertex, so that all rings are simple.
    fn cut(&self, walk: &[u32], places: &mut [u32], mut ring: impl FnMut(&[u32])) {
        let mut open: Vec<u32> = Vec::new();
        for &halfedge in walk {
            let tail = self.tail(halfedge) as usize;
            if places[tail] != NONE {
                let closed = open.split_off(places[tail] as usize);
                closed.iter().for_each(|&h| places[self.tail(h) as usize] = NONE);
                ring(&closed);
            }
            places[tail] = open.len() as u32;
            open.push(halfedge);
        }
        open.iter().for_each(|&h| places[self.tail(h) as usize] = NONE);
        ring(&open);
    }
}

impl Outline {
    /// The outline of the faces with a label, where faces with one label and a common edge are not divided.
    ///
    /// With `dissolve`, vertices at which two sides go on straight along one segment are no corners.
    pub(super) fn new(sides: &Sides<'_>, labels: &[u32], dissolve: bool) -> Self {
        let arrangement = sides.arrangement;
        let tracer = Tracer { sides, labels };
        let edge_count = arrangement.edge_count() as u32;
        let mut parts = UnionFind::new(labels.len());
        for edge in 0..edge_count {
            let [left, right] =
                [2 * edge, 2 * edge + 1].map(|h| arrangement.face_of(HalfedgeId::from_u32(h)));
            if let (Some(left), Some(right)) = (left, right)
                && tracer.label(2 * edge) != NONE
                && tracer.label(2 * edge) == tracer.label(2 * edge + 1)
            {
                parts.unite(left.to_u32(), right.to_u32());
            }
        }
        let mut number_of_part = vec![NONE; labels.len()];
        let mut polygon_of_face = vec![NONE; labels.len()];
        let mut polygon_count = 0;
        for face in (0..labels.len()).filter(|&face| labels[face] != NONE) {
            let number = &mut number_of_part[parts.find(face as u32) as usize];
            if *number == NONE {
                *number = polygon_count;
                polygon_count += 1;
            }
            polygon_of_face[face] = *number;
        }
        let is_corner = corners(&tracer, edge_count, dissolve);
        let mut is_done = vec![false; 2 * edge_count as usize];
        let mut places = vec![NONE; arrangement.vertex_count()];
        let mut rings: Vec<(u32, bool, Vec<u32>)> = Vec::new();
        let mut pieces: Vec<([u32; 2], u32)> = Vec::new();
        for start in (0..2 * edge_count).filter(|&halfedge| tracer.is_rim(halfedge)) {
            if is_done[start as usize] {
                continue;
            }
            let mut walk = Vec::new();
            let mut halfedge = start;
            while !std::mem::replace(&mut is_done[halfedge as usize], true) {
                walk.push(halfedge);
                halfedge = tracer.next(halfedge);
            }
            let face = arrangement.face_of(HalfedgeId::from_u32(start)).map_or(0, FaceId::index);
            tracer.cut(&walk, &mut places, |ring| {
                let outer = tracer.is_outer(ring);
                let first = (0..ring.len())
                    .filter(|&i| is_corner[tracer.tail(ring[i]) as usize])
                    .min_by_key(|&i| tracer.tail(ring[i]))
                    .unwrap_or(0);
                let mut corners = Vec::new();
                let mut from = pieces.len();
                for i in 0..ring.len() {
                    let halfedge = ring[(first + i) % ring.len()];
                    let tail = tracer.tail(halfedge);
                    if is_corner[tail as usize] {
                        close(&mut pieces[from..], corners.last().copied(), tail);
                        from = pieces.len();
                        corners.push(tail);
                    }
                    pieces.push(([NONE; 2], halfedge / 2));
                }
                close(&mut pieces[from..], corners.last().copied(), corners[0]);
                rings.push((polygon_of_face[face], !outer, corners));
            });
        }
        rings.sort_by_key(|&(polygon, is_hole, _)| (polygon, is_hole));
        let mut vertices: Vec<u32> = rings.iter().flat_map(|(_, _, ring)| ring.iter().copied()).collect();
        vertices.sort_unstable();
        vertices.dedup();
        let mut numbers = places;
        vertices.iter().zip(0..).for_each(|(&vertex, number)| numbers[vertex as usize] = number);
        let number = |vertex: u32| numbers[vertex as usize];
        let mut polygons: Vec<u32> = Vec::new();
        for (i, (polygon, _, _)) in rings.iter().enumerate() {
            if *polygon as usize == polygons.len() {
                polygons.push(i as u32);
            }
        }
        polygons.push(rings.len() as u32);
        for (ends, _) in &mut pieces {
            *ends = ends.map(number);
        }
        pieces.sort_unstable();
        pieces.dedup();
        let (mut edges, mut segments) = (Vec::new(), RaggedArray::new());
        let mut list = Vec::new();
        for pieces in pieces.chunk_by(|a, b| a.0 == b.0) {
            edges.push(pieces[0].0);
            list.clear();
            list.extend(pieces.iter().flat_map(|&(_, edge)| sides.segments.list(edge as usize)).copied());
            list.sort_unstable();
            list.dedup();
            segments.push(&list);
        }
        let rings = RaggedArray::from_lists(
            rings.iter().map(|(_, _, ring)| ring.iter().map(|&vertex| number(vertex)).collect::<Vec<_>>()),
        );
        Self { vertices, rings, polygons, polygon_of_face, edges, segments }
    }

    /// The rings of a polygon, the outer one first.
    pub(super) fn rings_of(&self, polygon: usize) -> impl ExactSizeIterator<Item = &[u32]> {
        (self.polygons[polygon]..self.polygons[polygon + 1]).map(|ring| self.rings.list(ring as usize))
    }

    pub(super) fn polygon_count(&self) -> usize {
        self.polygons.len().saturating_sub(1)
    }

    pub(super) fn hole_count(&self) -> usize {
        self.rings.len() - self.polygon_count()
    }
}

/// Gives pieces of arrangement edges their two corners, the lower first.
fn close(pieces: &mut [([u32; 2], u32)], from: Option<u32>, to: u32) {
    let Some(from) = from else { return };
    for (ends, _) in pieces {
        *ends = [from.min(to), from.max(to)];
    }
}

/// The vertices of rims that are corners.
fn corners(tracer: &Tracer<'_>, edge_count: u32, dissolve: bool) -> Vec<bool> {
    let arrangement = tracer.sides.arrangement;
    let mut degrees = vec![0u32; arrangement.vertex_count()];
    let mut edges = vec![[NONE; 2]; arrangement.vertex_count()];
    for edge in (0..edge_count).filter(|&edge| tracer.is_rim(2 * edge) || tracer.is_rim(2 * edge + 1)) {
        for end in arrangement.ends(EdgeId::from_u32(edge)) {
            let degree = &mut degrees[end.index()];
            if let Some(place) = edges[end.index()].get_mut(*degree as usize) {
                *place = edge;
            }
            *degree += 1;
        }
    }
    let goes_straight = |vertex: usize| {
        let [a, b] = edges[vertex];
        let [one, other] = [a, b].map(|edge| tracer.sides.segments.list(edge as usize));
        one.iter().any(|segment| other.contains(segment)) && {
            tracer.sides.is_exact || {
                let far = [a, b].map(|edge| {
                    let [lower, upper] = arrangement.ends(EdgeId::from_u32(edge));
                    if lower.index() == vertex { upper } else { lower }
                });
                let [p, q, r] = [far[0], VertexId::new(vertex), far[1]].map(|v| {
                    let point = arrangement.positions().point(v);
                    [point[0], point[1]]
                });
                orientation(p, q, r) == Ordering::Equal
            }
        }
    };
    (0..degrees.len())
        .map(|vertex| degrees[vertex] > 0 && !(dissolve && degrees[vertex] == 2 && goes_straight(vertex)))
        .collect()
}
