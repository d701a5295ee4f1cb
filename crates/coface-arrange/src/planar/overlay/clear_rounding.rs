//! Whether rounding the crossings of an overlay changes nothing, seen from the sides alone.
//!
//! A crossing is moved by less than a unit of the last place of its coordinates, and stays within the boxes around both sides
//! that cross. Move all crossings to their rounded places at once, in straight lines. If no two edges come to meet on the way
//! but in nodes that they have in common, the polygons of any selection are at the end what they were. For two edges on
//!
//! * sides whose boxes are apart that is so, since rounding is monotone;
//! * sides that do not meet, if one of them lies on one side of the other by many units;
//! * one side, if rounded places on it are in strict order;
//! * two sides that have a point in common, if the places before and after it on each lie off the other by many units:
//!   edges at that point keep their directions apart, and edges beyond these places are farther off still.
//!
//! What is in doubt is not told to be clear: corners on other sides, several crossings at one place, sides on one line.

use super::super::crossings::{Crossing, is_clear_of};
use super::chains::{Break, Chains, Rings};
use coface_geometry::predicates::PlanarLine;

/// Whether polygons between these chains are valid with rounded crossings as they are with exact ones; `false` says nothing.
/// `close` are pairs of sides that do not meet and are not clear of each other.
pub(super) fn rounds_clearly(
    rings: &Rings,
    chains: &Chains,
    crossings: &[Crossing],
    close: &[[u32; 2]],
) -> bool {
    if crossings.is_empty() {
        return true;
    }
    let mut is_crossed = vec![false; rings.points.len()];
    crossings.iter().for_each(|own| own.segments.iter().for_each(|&side| is_crossed[side as usize] = true));
    if close.as_flattened().iter().any(|&side| is_crossed[side as usize]) {
        return false;
    }
    drop(is_crossed);
    let mut sides_through = vec![0u8; chains.nodes.len()];
    for at in &chains.breaks {
        let count = &mut sides_through[at.node() as usize];
        *count = count.saturating_add(1);
    }
    let nodes = CrossedNodes { rings, chains, crossings, sides_through };
    let mut sides: Vec<&[Break]> = Vec::new();
    chains.starts.windows(2).enumerate().all(|(ring, ends)| {
        sides.clear();
        sides.extend(chains.breaks[ends[0] as usize..ends[1] as usize].chunk_by(|a, b| a.side == b.side));
        (0..sides.len()).all(|at| {
            let before = sides[(at + sides.len() - 1) % sides.len()];
            let after = sides[(at + 1) % sides.len()];
            // A ring that meets no other has its lowest corner for a node.
            !sides[at].iter().any(|own| own.is_within()) || nodes.is_clear(ring, [before, sides[at], after])
        })
    })
}

struct CrossedNodes<'a> {
    rings: &'a Rings,
    chains: &'a Chains,
    crossings: &'a [Crossing],
    /// How many breaks there are at each node.
    sides_through: Vec<u8>,
}

impl CrossedNodes<'_> {
    /// The crossing at a break, if there is one alone.
    fn crossing(&self, at: &Break) -> Option<&Crossing> {
        let node = at.node() as usize;
        let crossing = (self.chains.nodes[node] as usize).checked_sub(self.rings.points.len())?;
        (at.is_within() && self.sides_through[node] == 2).then(|| &self.crossings[crossing])
    }

    /// Whether a side with crossings on it is clear, given the breaks on the broken side before it on the ring, on itself,
    /// and on the one after it.
    fn is_clear(&self, ring: usize, [before, own, after]: [&[Break]; 3]) -> bool {
        let side = own[0].side;
        let sides = self.rings.sides(ring);
        let next = if side + 1 == sides.end { sides.start } else { side + 1 };
        let line = self.rings.soup.line(side);
        let axis = usize::from((line[1][1] - line[0][1]).abs() > (line[1][0] - line[0][0]).abs());
        let mut last = line[0];
        let place = |i: usize| match own.get(i) {
            Some(at) => self.crossing(at).map(|crossing| crossing.rounded),
            None => Some(line[1]),
        };
        for (i, at) in own.iter().enumerate() {
            let Some(crossing) = self.crossing(at) else { return false };
            let Some(following) = place(i + 1) else { return false };
            let here = crossing.rounded;
            let other = crossing.segments[usize::from(crossing.segments[0] == side)];
            let other = self.rings.soup.line(other);
            let is_between = is_strictly_between(last, here, following, axis);
            if !is_between || !is_clear_of(other, last) || !is_clear_of(other, following) {
                return false;
            }
            last = here;
        }
        // The neighbors on the ring, and the places on them that are nearest to the corner.
        let (Some(first), Some(last)) = (place(0), place(own.len() - 1)) else { return false };
        let previous = self.rings.side_before(side, ring);
        let before = before.last().filter(|at| at.side == previous);
        let after = after.first().filter(|at| at.side == next);
        let (lines, mut ends) = ([previous, next].map(|own| self.rings.soup.line(own)), [[0.0; 2]; 2]);
        for (end, at, corner) in [(0, before, lines[0][0]), (1, after, lines[1][1])] {
            ends[end] = match at.map(|at| self.crossing(at)) {
                None => corner,
                Some(None) => return false,
                Some(Some(crossing)) => crossing.rounded,
            };
        }
        turns_clearly([lines[0], line], [ends[0], line[0], first])
            && turns_clearly([line, lines[1]], [last, line[1], ends[1]])
    }
}

/// Whether one coordinate of the second point is strictly between those of the others.
fn is_strictly_between(a: [f64; 2], b: [f64; 2], c: [f64; 2], axis: usize) -> bool {
    (a[axis] < b[axis] && b[axis] < c[axis]) || (a[axis] > b[axis] && b[axis] > c[axis])
}

/// Whether two sides with a common corner, the second of three places, have no other point in common between the other places,
/// wherever these are within some units.
fn turns_clearly([before, after]: [PlanarLine; 2], [from, corner, to]: [[f64; 2]; 3]) -> bool {
    (is_clear_of(before, to) && is_clear_of(after, from))
        || (0..2).any(|axis| is_strictly_between(from, corner, to, axis))
}

#[cfg(test)]
mod tests {
    use super::super::{PlanarOverlay, are_valid_polygons, turned_rings};
    use coface_algebra::RaggedArray;
    use coface_geometry::Positions;
    use proptest::prelude::*;

    /// An overlay of rings, a region each, on integers from 2^52 on: crossings are rounded to integers.
    fn overlay(rings: &[Vec<[u32; 2]>]) -> PlanarOverlay {
        let place = |&x: &u32| (1u64 << 52) as f64 + f64::from(x);
        let flat = rings.iter().flatten().flatten().map(place).collect();
        let mut numbers = 0u32..;
        let lists = RaggedArray::from_lists(
            rings.iter().map(|ring| numbers.by_ref().take(ring.len()).collect::<Vec<_>>()),
        );
        let regions: Vec<u32> = (0..rings.len() as u32).collect();
        PlanarOverlay::new(&Positions::from_flat(2, flat).unwrap(), &lists, &regions).unwrap()
    }

    fn check(overlay: &PlanarOverlay) {
        type Condition = fn(&[(u32, i32)]) -> bool;
        let conditions: [Condition; 4] = [
            |windings| !windings.is_empty(),
            |windings| windings.len() > 1,
            |windings| windings.iter().map(|&(_, winding)| winding).sum::<i32>() % 2 != 0,
            |windings| windings.first().is_some_and(|&(region, _)| region == 0) && windings.len() == 1,
        ];
        for condition in conditions {
            let found = overlay.select(condition).unwrap();
            let (positions, rings, polygons) = (found.positions(), found.rings(), found.polygons());
            assert!(are_valid_polygons(positions, rings, polygons, false).unwrap());
            assert!(!turned_rings(positions, rings, polygons).contains(&true));
        }
    }

    #[test]
    fn what_is_far_apart_is_clear() {
        // The shift is also the angle, in units of 1e-7, by which a star is turned.
        let star = |shift: u32| {
            let corner = |i: u32| {
                let (sine, cosine) = (f64::from(i) * 0.2 + f64::from(shift) * 1e-7).sin_cos();
                let radius = if i.is_multiple_of(2) { 9e7 } else { 4e7 };
                [cosine, sine].map(|x| (1e8 + f64::from(shift) + radius * x) as u32)
            };
            (0..31).map(corner).collect::<Vec<_>>()
        };
        let shifts = [0, 7_000_000, 19_000_000];
        let found = overlay(&shifts.map(star));
        assert!(found.crossings.len() > 20 && found.rounds_clearly(), "{}", found.crossings.len());
        assert!(!found.select(|windings| !windings.is_empty()).unwrap().is_exactly_rounded());
        check(&found);
        // The same in units that are a million times as large.
        let small = |shift: u32| star(shift).into_iter().map(|point| point.map(|x| x / 1_000_000)).collect();
        assert!(!overlay(&shifts.map(small)).rounds_clearly());
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4096))]

        #[test]
        fn what_is_clear_stays_valid(
            rings in (10u32..2000).prop_flat_map(|size| {
                let corner = [0..size, 0..size];
                prop::collection::vec(prop::collection::vec(corner, 3..7), 1..4)
            }),
        ) {
            let found = overlay(&rings);
            if found.rounds_clearly() {
                check(&found);
            }
        }
    }
}
