//! Rings cut into chains between their nodes.

use super::super::crossings::{Meetings, Soup};
use super::super::vertices::Vertices;
use crate::algebra::RaggedArray;
use crate::geometry::Positions;
use crate::geometry::predicates::PlanarPoint;
use rayon::prelude::*;
use std::ops::Range;

/// The rings of an overlay without sides of no length.
pub(super) struct Rings {
    /// Corner c, and side c that starts there.
    pub(super) soup: Soup,
    /// The point of the input at each corner.
    pub(super) points: Vec<u32>,
    /// The place of each side in the lists of all rings together.
    pub(super) places: Vec<u32>,
    /// The first side of each ring, and where the last ends.
    pub(super) starts: Vec<u32>,
    /// The ring of the input.
    pub(super) numbers: Vec<u32>,
}

impl Rings {
    /// Corners that are equal to the one before them are left out, then rings with less than two corners. One with two is a segment
    /// there and back.
    pub(super) fn new(positions: &Positions, rings: &RaggedArray) -> Self {
        let coordinates = positions.as_flat().as_chunks::<2>().0;
        let count = rings.item_count();
        let mut found = Self {
            soup: Soup { points: Vec::with_capacity(count), segments: Vec::with_capacity(count) },
            points: Vec::with_capacity(count),
            places: Vec::with_capacity(count),
            starts: vec![0],
            numbers: Vec::with_capacity(rings.len()),
        };
        for (number, ring) in rings.iter().enumerate() {
            let place = rings.start(number);
            let first = found.points.len();
            let has_length = |i: usize| {
                let next = ring[if i + 1 == ring.len() { 0 } else { i + 1 }];
                coordinates[ring[i] as usize] != coordinates[next as usize]
            };
            if (0..ring.len()).all(has_length) {
                found.points.extend_from_slice(ring);
                found.places.extend(place as u32..(place + ring.len()) as u32);
            } else {
                for i in (0..ring.len()).filter(|&i| has_length(i)) {
                    found.points.push(ring[i]);
                    found.places.push((place + i) as u32);
                }
            }
            let end = found.points.len();
            if end - first < 2 {
                found.points.truncate(first);
                found.places.truncate(first);
                continue;
            }
            found.soup.points.extend(found.points[first..].iter().map(|&point| coordinates[point as usize]));
            found.soup.segments.extend((first as u32..end as u32).map(|side| [side, side + 1]));
            found.soup.segments[end - 1][1] = first as u32;
            found.starts.push(end as u32);
            found.numbers.push(number as u32);
        }
        found
    }

    /// The ring that a side is on.
    pub(super) fn ring_of(&self, side: u32) -> usize {
        self.starts.partition_point(|&start| start <= side) - 1
    }

    pub(super) fn sides(&self, ring: usize) -> Range<u32> {
        self.starts[ring]..self.starts[ring + 1]
    }

    /// The side before this one on its ring.
    pub(super) fn side_before(&self, side: u32, ring: usize) -> u32 {
        let sides = self.sides(ring);
        if side == sides.start { sides.end - 1 } else { side - 1 }
    }

    /// The lexicographically lowest of some corners, which are not equal.
    fn lowest_corner(&self, corners: Range<u32>) -> Option<u32> {
        let at = |corner: u32| self.soup.points[corner as usize];
        corners.reduce(|a, b| {
            let ([ax, ay], [bx, by]) = (at(a), at(b));
            if bx < ax || (bx == ax && by < ay) { b } else { a }
        })
    }
}

/// A node on a ring: where a chain ends and the next begins.
#[derive(Clone, Copy)]
pub(super) struct Break {
    pub(super) side: u32,
    /// 0 for the corner that the side starts at; from 1 for nodes on the inside of the side, in its direction.
    pub(super) rank: u32,
    pub(super) node: u32,
}

/// The part of a ring from one break to the next.
#[derive(Clone, Copy)]
pub(super) struct Chain {
    pub(super) ring: u32,
    pub(super) nodes: [u32; 2],
    /// The sides that it begins and ends on.
    pub(super) sides: [u32; 2],
    /// How many corners lie between its nodes, from the one at the end of its first side.
    pub(super) corner_count: u32,
}

impl Chain {
    /// The corners between the nodes in order: two ranges, the second one from the start of the ring.
    pub(super) fn corners(&self, rings: &Rings) -> [Range<u32>; 2] {
        let sides = rings.sides(self.ring as usize);
        let first = self.sides[0] + 1;
        let end = (first + self.corner_count).min(sides.end);
        let rest = self.corner_count - (end - first);
        [first..end, sides.start..sides.start + rest]
    }

    pub(super) fn lowest_corner(&self, rings: &Rings) -> Option<u32> {
        let [a, b] = self.corners(rings).map(|range| rings.lowest_corner(range));
        match (a, b) {
            (Some(a), Some(b)) => {
                let at = |corner: u32| rings.soup.points[corner as usize];
                Some(if at(b) < at(a) { b } else { a })
            }
            (found, None) | (None, found) => found,
        }
    }
}

/// All nodes and chains.
pub(super) struct Chains {
    /// What is at each node: a corner, or after the corners a crossing. Nodes are in the order in which rings come to them, so that
    /// near nodes have near numbers.
    pub(super) nodes: Vec<u32>,
    /// The place of each node in the lexicographic order of nodes; those that are alone on their ring come last.
    pub(super) ranks: Vec<u32>,
    /// By side and rank.
    pub(super) breaks: Vec<Break>,
    /// From each break to the next on its ring.
    pub(super) chains: Vec<Chain>,
    /// The first chain of each ring, and where the last ring ends.
    pub(super) starts: Vec<u32>,
    /// The nodes that are not alone on their ring.
    pub(super) meeting_count: usize,
}

impl Chains {
    pub(super) fn new(rings: &Rings, meetings: &Meetings) -> Self {
        let corner_count = rings.soup.points.len() as u32;
        let mut special: Vec<u32> = meetings.touches.iter().map(|touch| touch[1]).collect();
        special.extend(meetings.equal_points.as_flattened());
        // A ring there and back is cut at both ends, so that it is one edge.
        special.extend(
            rings.starts.windows(2).filter(|ends| ends[1] - ends[0] == 2).flat_map(|ends| ends[0]..ends[1]),
        );
        special.par_sort_unstable();
        special.dedup();
        let of_crossing = |crossing: usize| (special.len() + crossing) as u32;
        let Vertices { events, vertex_of_event } = {
            let given = special.iter().map(|&corner| rings.soup.points[corner as usize]);
            let crossed = meetings.crossings.iter().map(|crossing| crossing.rounded);
            Vertices::new(given.chain(crossed), |event| match special.get(event as usize) {
                Some(&corner) => PlanarPoint::given(rings.soup.points[corner as usize]),
                None => meetings.crossings[event as usize - special.len()].point(&rings.soup),
            })
        };
        let mut nodes: Vec<u32> = events
            .iter()
            .map(|&event| match special.get(event as usize) {
                Some(&corner) => corner,
                None => corner_count + (event - special.len() as u32),
            })
            .collect();
        let meeting_count = nodes.len();
        // Nodes within sides as pairs of the side and the node, which rise along sides that rise.
        let key = |side: u32, node: u32| u64::from(side) << 32 | u64::from(node);
        let mut within: Vec<u64> = Vec::with_capacity(meetings.touches.len() + 2 * meetings.crossings.len());
        within.extend(meetings.touches.iter().map(|&[side, corner]| {
            let event = special.binary_search(&corner).expect("corners that touch are special");
            key(side, vertex_of_event[event])
        }));
        for (i, crossing) in meetings.crossings.iter().enumerate() {
            let node = vertex_of_event[of_crossing(i) as usize];
            within.extend(crossing.segments.map(|side| key(side, node)));
        }
        within.par_sort_unstable();
        within.dedup();
        let mut breaks = Vec::with_capacity(special.len() + within.len() + rings.numbers.len());
        let (mut next_special, mut next_within) = (0, 0);
        let (mut chains, mut starts) = (Vec::new(), vec![0]);
        for ring in 0..rings.numbers.len() {
            let sides = rings.sides(ring);
            let first = breaks.len();
            loop {
                let corner = special.get(next_special).copied().unwrap_or(u32::MAX);
                let side = within.get(next_within).map_or(u32::MAX, |pair| (pair >> 32) as u32);
                if corner.min(side) >= sides.end {
                    break;
                }
                if corner <= side {
                    breaks.push(Break { side: corner, rank: 0, node: vertex_of_event[next_special] });
                    next_special += 1;
                } else {
                    let own = within[next_within..].iter().take_while(|&pair| (pair >> 32) as u32 == side);
                    let start = breaks.len();
                    breaks.extend(own.map(|&pair| Break { side, rank: 0, node: pair as u32 }));
                    next_within += breaks.len() - start;
                    let [a, b] = rings.soup.line(side);
                    if a > b {
                        breaks[start..].reverse();
                    }
                    breaks[start..].iter_mut().zip(1..).for_each(|(own, rank)| own.rank = rank);
                }
            }
            if breaks.len() == first {
                // A ring that meets no other gets a node of its own.
                let corner = rings.lowest_corner(sides.clone()).expect("rings have corners");
                breaks.push(Break { side: corner, rank: 0, node: nodes.len() as u32 });
                nodes.push(corner);
            }
            for at in first..breaks.len() {
                let (from, is_last) = (breaks[at], at + 1 == breaks.len());
                let to = breaks[if is_last { first } else { at + 1 }];
                let length = if is_last { sides.end - sides.start } else { 0 };
                let before = |side: u32| if side == sides.start { sides.end - 1 } else { side - 1 };
                chains.push(Chain {
                    ring: ring as u32,
                    nodes: [from.node, to.node],
                    sides: [from.side, if to.rank == 0 { before(to.side) } else { to.side }],
                    corner_count: to.side + length - from.side - u32::from(to.rank == 0),
                });
            }
            starts.push(chains.len() as u32);
        }
        let mut number_of = vec![u32::MAX; nodes.len()];
        let mut ranks = Vec::with_capacity(nodes.len());
        for at in &mut breaks {
            let number = &mut number_of[at.node as usize];
            if *number == u32::MAX {
                *number = ranks.len() as u32;
                ranks.push(at.node);
            }
            at.node = *number;
        }
        chains.par_iter_mut().for_each(|chain: &mut Chain| {
            chain.nodes = chain.nodes.map(|node| number_of[node as usize]);
        });
        let nodes = ranks.iter().map(|&rank| nodes[rank as usize]).collect();
        Self { nodes, ranks, breaks, chains, starts, meeting_count }
    }
}
