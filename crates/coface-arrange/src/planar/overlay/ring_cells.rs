//! What rings make of the plane, without coordinates: edges, faces, winding numbers, and the rings around selected
//! faces.

use super::chains::{Chains, Rings};
use crate::planar::faces::{Faces, NONE, Orbits};
use crate::planar::simple_rings::simple_rings;
use crate::planar::windings::Windings;
use coface_algebra::{RaggedArray, UnionFind};
use rayon::prelude::*;

/// Edges, the faces between them, and how often regions wind around each.
#[derive(Clone, Debug)]
pub struct RingCells {
    pub(crate) edges: ChainEdges,
    pub(crate) orbits: Orbits,
    pub(crate) faces: Faces,
    pub(crate) windings: Windings,
}

/// The simple rings around selected faces.
#[derive(Clone, Debug)]
pub struct TracedRings {
    /// The halfedges of one ring after those of another.
    pub(crate) halfedges: Vec<u32>,
    /// Where each ring begins, and where the last ends.
    pub(crate) starts: Vec<usize>,
    /// The rings of each polygon, the outer one first; with an exterior one more list comes last: the holes in what
    /// reaches to infinity.
    pub(crate) by_polygon: RaggedArray,
    pub(crate) has_exterior: bool,
    /// The polygon of each bounded face; [`NONE`] for those that are not selected.
    pub(crate) polygon_of_face: Vec<u32>,
}

impl TracedRings {
    /// The halfedges of one ring after those of another.
    #[doc(hidden)]
    pub fn halfedges(&self) -> &[u32] {
        &self.halfedges
    }

    /// Where each ring begins, and where the last ends.
    #[doc(hidden)]
    pub fn starts(&self) -> &[usize] {
        &self.starts
    }
}

impl RingCells {
    /// The cells with these parts, which belong together.
    #[doc(hidden)]
    pub fn new(edges: ChainEdges, orbits: Orbits, faces: Faces, windings: Windings) -> Self {
        Self { edges, orbits, faces, windings }
    }

    /// The edges.
    #[doc(hidden)]
    pub fn edges(&self) -> &ChainEdges {
        &self.edges
    }

    /// The orbits of halfedges.
    #[doc(hidden)]
    pub fn orbits(&self) -> &Orbits {
        &self.orbits
    }

    /// The number of bounded faces.
    #[doc(hidden)]
    pub fn face_count(&self) -> usize {
        self.faces.orbits.len()
    }

    /// The winding numbers around the faces.
    #[doc(hidden)]
    pub fn windings(&self) -> &Windings {
        &self.windings
    }

    /// The face on the left of a halfedge; [`NONE`] for the unbounded one.
    #[doc(hidden)]
    pub fn face(&self, halfedge: u32) -> u32 {
        self.faces.of_orbit[self.orbits.orbit_of[halfedge as usize] as usize]
    }

    /// The node that a halfedge leaves.
    #[doc(hidden)]
    pub fn tail(&self, halfedge: u32) -> u32 {
        self.edges.ends[halfedge as usize / 2][halfedge as usize % 2]
    }

    /// Whether the winding numbers around each face satisfy a condition; the unbounded face comes last.
    #[doc(hidden)]
    pub fn faces_where(&self, condition: impl Fn(&[(u32, i32)]) -> bool) -> Vec<bool> {
        self.windings.where_satisfied(condition)
    }

    /// The rings around faces, of which the unbounded one comes last. `is_counterclockwise` is asked about simple
    /// rings.
    #[doc(hidden)]
    pub fn trace(
        &self,
        is_inside: &[bool],
        is_counterclockwise: impl Fn(&[u32]) -> bool + Sync,
    ) -> TracedRings {
        self.trace_with(is_inside, false, is_counterclockwise)
    }

    /// The same. With shared edges kept, each face is a polygon by itself; else faces with an edge in common are one.
    pub(crate) fn trace_with(
        &self,
        is_inside: &[bool],
        walls: bool,
        is_counterclockwise: impl Fn(&[u32]) -> bool + Sync,
    ) -> TracedRings {
        let face_count = self.faces.orbits.len() as u32;
        let face_of_orbit = |orbit: u32| self.faces.of_orbit[orbit as usize].min(face_count);
        let face = |halfedge: u32| face_of_orbit(self.orbits.orbit_of[halfedge as usize]);
        // Orbits are asked one by one, so that halfedges have little to look up.
        let orbit_count = self.faces.of_orbit.len() as u32;
        let is_orbit_inside: Vec<bool> = (0..orbit_count)
            .into_par_iter()
            .with_min_len(1 << 14)
            .map(|orbit| is_inside[face_of_orbit(orbit) as usize])
            .collect();
        let orbit_pairs = self.orbits.orbit_of.as_chunks::<2>().0;
        let mut is_boundary = vec![false; self.orbits.next.len()];
        let by_edge = is_boundary.as_chunks_mut::<2>().0;
        by_edge.par_iter_mut().zip(orbit_pairs).with_min_len(1 << 14).for_each(|(sides, orbits)| {
            let [left, right] = orbits.map(|orbit| is_orbit_inside[orbit as usize]);
            let is_wall = walls && left && right && face_of_orbit(orbits[0]) != face_of_orbit(orbits[1]);
            *sides = [left && (!right || is_wall), right && (!left || is_wall)];
        });
        let mut polygons = UnionFind::new(is_inside.len());
        if !walls {
            let pairs = orbit_pairs.par_iter().with_min_len(1 << 14);
            let inner = pairs.filter(|orbits| orbits.iter().all(|&orbit| is_orbit_inside[orbit as usize]));
            let inner: Vec<[u32; 2]> = inner.map(|orbits| orbits.map(face_of_orbit)).collect();
            for [left, right] in inner {
                polygons.unite(left, right);
            }
        }
        drop(is_orbit_inside);
        let (rings, starts) = simple_rings(&self.orbits, &self.edges.ends, &is_boundary);
        let has_exterior = is_inside[face_count as usize];
        let exterior = polygons.find(face_count);
        // Polygons by their first rings; what reaches to infinity is the last, and has no ring around it.
        let mut number_of = vec![NONE; is_inside.len()];
        let mut polygon_of_ring = Vec::with_capacity(starts.len());
        let mut polygon_count = 0;
        for range in starts.windows(2) {
            let halfedges = &rings[range[0]..range[1]];
            let class = polygons.find(face(halfedges[0]));
            let number = &mut number_of[class as usize];
            if *number == NONE && !(has_exterior && class == exterior) {
                *number = polygon_count as u32;
                polygon_count += 1;
            }
            polygon_of_ring.push(*number);
        }
        for number in polygon_of_ring.iter_mut().filter(|number| **number == NONE) {
            *number = polygon_count as u32;
        }
        let list_count = polygon_count + usize::from(has_exterior);
        let mut by_polygon = RaggedArray::grouped(list_count, polygon_of_ring.iter().copied());
        let list_starts: Vec<usize> = (0..=polygon_count).map(|polygon| by_polygon.start(polygon)).collect();
        // The last ring that runs counterclockwise comes first; of one ring alone it is known.
        let outer_places: Vec<(u32, u32)> = (0..polygon_count as u32)
            .into_par_iter()
            .filter(|&polygon| by_polygon.list(polygon as usize).len() > 1)
            .filter_map(|polygon| {
                let place = by_polygon.list(polygon as usize).iter().rposition(|&ring| {
                    is_counterclockwise(&rings[starts[ring as usize]..starts[ring as usize + 1]])
                });
                place.map(|place| (polygon, place as u32))
            })
            .collect();
        for (polygon, place) in outer_places {
            let first = list_starts[polygon as usize];
            by_polygon.items_mut()[first..=first + place as usize].rotate_right(1);
        }
        let polygon_of_face = (0..face_count)
            .map(|face| if is_inside[face as usize] { number_of[polygons.find(face) as usize] } else { NONE })
            .collect();
        TracedRings { halfedges: rings, starts, by_polygon, has_exterior, polygon_of_face }
    }
}

/// Edges: chains, equal ones made one.
#[derive(Clone, Debug)]
pub struct ChainEdges {
    /// The chains of each edge; the edge has the direction of the first.
    pub(crate) chains: RaggedArray,
    /// For each chain twice its edge, and one more where it runs against the edge.
    pub(crate) halfedge_of_chain: Vec<u32>,
    /// The nodes that each edge goes from and to.
    pub(crate) ends: Vec<[u32; 2]>,
}

impl ChainEdges {
    /// The edges of the chains of an overlay, given the sides that may run along each other.
    pub(super) fn new(rings: &Rings, chains: &Chains, collinear: &[[u32; 2]]) -> Self {
        let mut is_collinear = vec![false; if collinear.is_empty() { 0 } else { rings.points.len() }];
        collinear.as_flattened().iter().for_each(|&side| is_collinear[side as usize] = true);
        let has_equals = |chain: &u32| {
            let side = chains.breaks[*chain as usize].side as usize;
            is_collinear[side] && chains.chain(rings, *chain).corner_count == 0
        };
        let numbers = (0..chains.len() as u32).into_par_iter().with_min_len(1 << 12);
        let nodes: Vec<[u32; 2]> = numbers.map(|chain| chains.nodes_of(rings, chain)).collect();
        // Straight pieces between the same nodes are equal.
        let candidates = 0..if collinear.is_empty() { 0 } else { chains.len() as u32 };
        let mut straight: Vec<(u64, u32)> = candidates
            .into_par_iter()
            .with_min_len(1 << 12)
            .filter(has_equals)
            .map(|chain| {
                let [a, b] = nodes[chain as usize];
                (u64::from(a.min(b)) << 32 | u64::from(a.max(b)), chain)
            })
            .collect();
        straight.par_sort_unstable();
        let mut first_of: Vec<u32> = (0..chains.len() as u32).collect();
        for group in straight.chunk_by(|a, b| a.0 == b.0) {
            group[1..].iter().for_each(|&(_, number)| first_of[number as usize] = group[0].1);
        }
        drop(straight);
        Self::of_equal_chains(nodes.iter().copied(), &first_of, |chain, first| {
            nodes[chain as usize] != nodes[first as usize]
        })
    }

    /// The edges of chains, given the nodes that each goes from and to, for each the first that it is equal to, and
    /// whether it runs against that.
    #[doc(hidden)]
    pub fn of_equal_chains(
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
        let chains = if ends.len() == halfedge_of_chain.len() {
            RaggedArray::uniform(1, (0..ends.len() as u32).collect()).expect("a chain for each edge")
        } else {
            RaggedArray::grouped(ends.len(), halfedge_of_chain.iter().map(|&h| h / 2))
        };
        Self { chains, halfedge_of_chain, ends }
    }

    /// The chains of each edge; the edge has the direction of the first.
    #[doc(hidden)]
    pub fn chains(&self) -> &RaggedArray {
        &self.chains
    }

    /// For each chain twice its edge, and one more where it runs against the edge.
    #[doc(hidden)]
    pub fn halfedge_of_chain(&self) -> &[u32] {
        &self.halfedge_of_chain
    }

    /// The nodes that each edge goes from and to.
    #[doc(hidden)]
    pub fn ends(&self) -> &[[u32; 2]] {
        &self.ends
    }

    /// The chain that an edge has its direction from.
    #[doc(hidden)]
    pub fn first_chain(&self, edge: u32) -> u32 {
        self.chains.list(edge as usize)[0]
    }
}
