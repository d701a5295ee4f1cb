//! Rings cut into chains between their nodes.

use super::super::crossings::Soup;
use coface_algebra::RaggedArray;
use coface_geometry::Positions;
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
    /// The ring that each side is on.
    ring_of_side: Vec<u32>,
}

impl Rings {
    /// Corners that are equal to the one before them are left out, then rings with less than two corners. One with two
    /// is a segment there and back.
    pub(super) fn new(positions: &Positions, rings: &RaggedArray) -> Self {
        let coordinates = positions.as_flat().as_chunks::<2>().0;
        let count = rings.item_count();
        let mut found = Self {
            soup: Soup {
                points: Vec::with_capacity(count),
                segments: Vec::with_capacity(count),
                exact: None,
            },
            points: Vec::with_capacity(count),
            places: Vec::with_capacity(count),
            starts: vec![0],
            numbers: Vec::with_capacity(rings.len()),
            ring_of_side: Vec::with_capacity(count),
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
            found.ring_of_side.resize(end, found.numbers.len() as u32);
            found.starts.push(end as u32);
            found.numbers.push(number as u32);
        }
        found
    }

    /// The ring that a side is on.
    pub(super) fn ring_of(&self, side: u32) -> usize {
        self.ring_of_side[side as usize] as usize
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
    pub(super) fn lowest_corner(&self, corners: Range<u32>) -> Option<u32> {
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
    /// Twice the node, and one more for a node on the inside of the side; else it is the corner that the side starts
    /// at.
    place: u32,
}

impl Break {
    pub(super) fn new(side: u32, node: u32, is_within: bool) -> Self {
        Self { side, place: 2 * node + u32::from(is_within) }
    }

    pub(super) fn node(&self) -> u32 {
        self.place / 2
    }

    pub(super) fn is_within(&self) -> bool {
        self.place % 2 == 1
    }
}

/// The part of a ring from one break to the next.
#[derive(Clone, Copy)]
pub(super) struct Chain {
    pub(super) ring: u32,
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
        if self.corner_count == 0 {
            return None;
        }
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
    /// What is at each node: a corner, or after the corners a crossing. Nodes are in the order in which rings come to
    /// them, so that near nodes have near numbers.
    pub(super) nodes: Vec<u32>,
    /// Along one ring after the other. From each to the next on its ring runs a chain.
    pub(super) breaks: Vec<Break>,
    /// The first break, and chain, of each ring, and where the last ring ends.
    pub(super) starts: Vec<u32>,
    /// The nodes that are not alone on their ring.
    pub(super) meeting_count: usize,
}

impl Chains {
    pub(super) fn len(&self) -> usize {
        self.breaks.len()
    }

    /// The breaks that a chain begins and ends with, and its ring.
    fn ends(&self, rings: &Rings, chain: u32) -> ([Break; 2], u32) {
        let from = self.breaks[chain as usize];
        let ring = rings.ring_of(from.side);
        let next = if chain + 1 == self.starts[ring + 1] { self.starts[ring] } else { chain + 1 };
        ([from, self.breaks[next as usize]], ring as u32)
    }

    /// The nodes at both ends of a chain.
    pub(super) fn nodes_of(&self, rings: &Rings, chain: u32) -> [u32; 2] {
        self.ends(rings, chain).0.map(|at| at.node())
    }

    pub(super) fn ring_of(&self, rings: &Rings, chain: u32) -> u32 {
        rings.ring_of(self.breaks[chain as usize].side) as u32
    }

    /// The side along which a chain leaves its first node, or with `is_against` the one along which it comes to its
    /// last.
    pub(super) fn end_side(&self, rings: &Rings, chain: u32, is_against: bool) -> u32 {
        if !is_against {
            return self.breaks[chain as usize].side;
        }
        let ([_, to], ring) = self.ends(rings, chain);
        if to.is_within() { to.side } else { rings.side_before(to.side, ring as usize) }
    }

    pub(super) fn chain(&self, rings: &Rings, chain: u32) -> Chain {
        let ([from, to], ring) = self.ends(rings, chain);
        let sides = rings.sides(ring as usize);
        // The last chain of a ring runs past the first corner of the ring, or begins and ends in the only break.
        let is_last = chain + 1 == self.starts[ring as usize + 1];
        let length = if is_last { sides.end - sides.start } else { 0 };
        let is_corner = !to.is_within();
        Chain {
            ring,
            sides: [from.side, if is_corner { rings.side_before(to.side, ring as usize) } else { to.side }],
            corner_count: to.side + length - from.side - u32::from(is_corner),
        }
    }
}
