//! What rings make of the plane, without coordinates: edges, faces, winding numbers, and the rings around selected faces.

use super::chains::Chain;
use crate::algebra::{RaggedArray, UnionFind};
use crate::arrangement::planar::faces::{Faces, NONE, Orbits};
use crate::arrangement::planar::simple_rings::simple_rings;
use crate::arrangement::planar::windings::Windings;
use rayon::prelude::*;

/// Edges, the faces between them, and how often regions wind around each.
pub(crate) struct RingCells {
    pub(crate) edges: ChainEdges,
    pub(crate) orbits: Orbits,
    pub(crate) faces: Faces,
    pub(crate) windings: Windings,
}

/// The simple rings around selected faces.
pub(crate) struct TracedRings {
    /// The halfedges of one ring after those of another.
    pub(crate) halfedges: Vec<u32>,
    /// Where each ring begins, and where the last ends.
    pub(crate) starts: Vec<usize>,
    /// The rings of each polygon, the outer one first; with an exterior one more list comes last: the holes in what reaches to
    /// infinity.
    pub(crate) by_polygon: RaggedArray,
    pub(crate) has_exterior: bool,
    /// The polygon of each bounded face; [`NONE`] for those that are not selected.
    pub(crate) polygon_of_face: Vec<u32>,
}

impl RingCells {
    /// The face on the left of a halfedge; [`NONE`] for the unbounded one.
    pub(crate) fn face(&self, halfedge: u32) -> u32 {
        self.faces.of_orbit[self.orbits.orbit_of[halfedge as usize] as usize]
    }

    /// The node that a halfedge leaves.
    pub(crate) fn tail(&self, halfedge: u32) -> u32 {
        self.edges.ends[halfedge as usize / 2][halfedge as usize % 2]
    }

    /// Whether the winding numbers around each face satisfy a condition; the unbounded face comes last.
    pub(crate) fn faces_where(&self, condition: impl Fn(&[(u32, i32)]) -> bool) -> Vec<bool> {
        let face_count = self.faces.orbits.len() as u32;
        let mut is_inside: Vec<bool> =
            (0..face_count).map(|face| condition(self.windings.of_face(face))).collect();
        is_inside.push(condition(&[]));
        is_inside
    }

    /// The rings around faces, of which the unbounded one comes last. `is_counterclockwise` is asked about simple rings.
    pub(crate) fn trace(
        &self,
        is_inside: &[bool],
        is_counterclockwise: impl Fn(&[u32]) -> bool,
    ) -> TracedRings {
        self.trace_with(is_inside, false, is_counterclockwise)
    }

    /// The same. With walls each face is a polygon by itself; else faces with an edge in common are one.
    pub(crate) fn trace_with(
        &self,
        is_inside: &[bool],
        walls: bool,
        is_counterclockwise: impl Fn(&[u32]) -> bool,
    ) -> TracedRings {
        let face_count = self.faces.orbits.len() as u32;
        let face = |halfedge: u32| self.face(halfedge).min(face_count);
        let is_boundary: Vec<bool> = (0..self.orbits.next.len() as u32)
            .map(|h| {
                let [left, right] = [face(h), face(h ^ 1)];
                is_inside[left as usize] && (!is_inside[right as usize] || (walls && left != right))
            })
            .collect();
        let mut polygons = UnionFind::new(is_inside.len());
        for edge in (0..self.edges.ends.len() as u32).filter(|_| !walls) {
            let [left, right] = [face(2 * edge), face(2 * edge + 1)];
            if left != right && is_inside[left as usize] && is_inside[right as usize] {
                polygons.unite(left, right);
            }
        }
        let (rings, starts) = simple_rings(&self.orbits, &self.edges.ends, &is_boundary);
        let has_exterior = is_inside[face_count as usize];
        let exterior = polygons.find(face_count);
        // Polygons by their first rings; what reaches to infinity is the last, and has no ring around it.
        let mut number_of = vec![NONE; is_inside.len()];
        let (mut polygon_of_ring, mut outer_rings) = (Vec::with_capacity(starts.len()), Vec::new());
        for (ring, range) in starts.windows(2).enumerate() {
            let halfedges = &rings[range[0]..range[1]];
            let class = polygons.find(face(halfedges[0]));
            let number = &mut number_of[class as usize];
            if *number == NONE && !(has_exterior && class == exterior) {
                *number = outer_rings.len() as u32;
                outer_rings.push(NONE);
            }
            polygon_of_ring.push(*number);
            if *number != NONE && is_counterclockwise(halfedges) {
                outer_rings[*number as usize] = ring as u32;
            }
        }
        let polygon_count = outer_rings.len();
        for number in polygon_of_ring.iter_mut().filter(|number| **number == NONE) {
            *number = polygon_count as u32;
        }
        let list_count = polygon_count + usize::from(has_exterior);
        let mut by_polygon = RaggedArray::grouped(list_count, polygon_of_ring.iter().copied());
        let list_starts: Vec<usize> = (0..=polygon_count).map(|polygon| by_polygon.start(polygon)).collect();
        for (polygon, &outer) in outer_rings.iter().enumerate() {
            let list = &mut by_polygon.items_mut()[list_starts[polygon]..list_starts[polygon + 1]];
            if let Some(at) = list.iter().position(|&ring| ring == outer) {
                list[..=at].rotate_right(1);
            }
        }
        let polygon_of_face = (0..face_count)
            .map(|face| if is_inside[face as usize] { number_of[polygons.find(face) as usize] } else { NONE })
            .collect();
        TracedRings { halfedges: rings, starts, by_polygon, has_exterior, polygon_of_face }
    }
}

/// Edges: chains, equal ones made one.
pub(crate) struct ChainEdges {
    /// The chains of each edge; the edge has the direction of the first.
    pub(crate) chains: RaggedArray,
    /// For each chain twice its edge, and one more where it runs against the edge.
    pub(crate) halfedge_of_chain: Vec<u32>,
    /// The nodes that each edge goes from and to.
    pub(crate) ends: Vec<[u32; 2]>,
}

impl ChainEdges {
    /// The edges of the chains of an overlay.
    pub(super) fn new(chains: &[Chain]) -> Self {
        // Straight pieces between the same nodes are equal.
        let mut straight: Vec<([u32; 2], u32)> = (0..)
            .zip(chains)
            .filter(|(_, chain)| chain.corner_count == 0)
            .map(|(number, chain)| {
                let [a, b] = chain.nodes;
                ([a.min(b), a.max(b)], number)
            })
            .collect();
        straight.par_sort_unstable();
        let mut first_of: Vec<u32> = (0..chains.len() as u32).collect();
        for group in straight.chunk_by(|a, b| a.0 == b.0) {
            group[1..].iter().for_each(|&(_, number)| first_of[number as usize] = group[0].1);
        }
        Self::of_equal_chains(chains.iter().map(|chain| chain.nodes), &first_of, |chain, first| {
            chains[chain as usize].nodes != chains[first as usize].nodes
        })
    }

    /// The edges of chains, given the nodes that each goes from and to, for each the first that it is equal to, and whether it runs
    /// against that.
    pub(crate) fn of_equal_chains(
        nodes: impl ExactSizeIterator<Item = [u32; 2]>,
        first_of: &[u32],
        is_against: impl Fn(u32, u32) -> bool,
    ) -> Self {
        let (mut ends, mut halfedge_of_chain): (Vec<[u32; 2]>, Vec<u32>) =
            (Vec::with_capacity(nodes.len()), Vec::with_capacity(nodes.len()));
        for (chain, (nodes, &first)) in (0..).zip(nodes.zip(first_of)) {
            if first == chain {
                halfedge_of_chain.push(2 * ends.len() as u32);
                ends.push(nodes);
            } else {
                let halfedge = halfedge_of_chain[first as usize];
                halfedge_of_chain.push(halfedge ^ u32::from(is_against(chain, first)));
            }
        }
        let chains = RaggedArray::grouped(ends.len(), halfedge_of_chain.iter().map(|&h| h / 2));
        Self { chains, halfedge_of_chain, ends }
    }

    pub(crate) fn first_chain(&self, edge: u32) -> u32 {
        self.chains.list(edge as usize)[0]
    }
}
