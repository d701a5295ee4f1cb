//! Whether polygons with holes are valid as they are drawn.

use super::PlanarOverlay;
use super::chains::Rings;
use crate::planar::PlanarOptions;
use crate::planar::crossings::Meetings;
use crate::planar::tour::Step;
use coface_algebra::{Error, RaggedArray, UnionFind};
use coface_geometry::Positions;
use coface_geometry::predicates::{PlanarLine, orientation};
use std::cmp::Ordering;
use std::collections::BTreeMap;

/// Whether polygons with holes are a valid multipolygon at these positions, exactly: as OGC's *Simple feature access*
/// says.
///
/// `rings` run through their vertices and back to the first, in any direction; `polygons` have the numbers of their rings,
/// the outer one first. Valid polygons have simple rings; the holes of each are inside of its
/// outer ring, not inside of each other; the inside of each is connected; two polygons touch in points at most, and two
/// rings of one polygon as well. With `shares_edges` polygons may have edges in common.
///
/// # Errors
/// As [`PlanarOverlay::new`].
///
/// # Complexity
/// That of an overlay of the rings.
///
/// # References
/// ISO 19125-1 (2004), *Simple feature access*, 6.1.11 and 6.1.14.
///
/// # Examples
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_arrange::planar::are_valid_polygons;
/// use coface_geometry::Positions;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let square = vec![0., 0., 4., 0., 4., 4., 0., 4., 1., 1., 1., 2., 2., 1.];
/// let (rings, polygons) = (RaggedArray::from_lists([&[0, 1, 2, 3][..], &[4, 5, 6]]), RaggedArray::from_lists([[0, 1]]));
/// assert!(are_valid_polygons(&Positions::from_flat(2, square.clone())?, &rings, &polygons, false)?);
/// // A hole that comes to the outer ring along a part of an edge.
/// let mut cut = square;
/// cut[9] = 0.0;
/// cut[13] = 0.0;
/// assert!(!are_valid_polygons(&Positions::from_flat(2, cut)?, &rings, &polygons, false)?);
/// # Ok(()) }
/// ```
pub fn are_valid_polygons(
    positions: &Positions,
    rings: &RaggedArray,
    polygons: &RaggedArray,
    shares_edges: bool,
) -> Result<bool, Error> {
    let mut polygon_of_ring = vec![0; rings.len()];
    for (polygon, own) in (0..).zip(polygons.iter()) {
        own.iter().for_each(|&ring| polygon_of_ring[ring as usize] = polygon);
    }
    let options = PlanarOptions::default();
    let turned = turned_rings(positions, rings, polygons);
    let mut numbers = turned.iter();
    let directed = RaggedArray::from_lists(rings.iter().map(|ring| {
        let is_turned = *numbers.next().expect("a flag for each ring");
        if is_turned { ring.iter().rev().copied().collect::<Vec<u32>>() } else { ring.to_vec() }
    }));
    let overlay = PlanarOverlay::without_windings(positions, &directed, &polygon_of_ring, &options)?;
    Ok(overlay.rings.numbers.len() == rings.len()
        && overlay.crossings.is_empty()
        && overlay.has_simple_edges(shares_edges)
        && overlay.winds_once(polygons.len())
        && overlay.touches_apart(&polygon_of_ring))
}

/// Whether a ring has three corners or more and no point twice.
#[doc(hidden)]
pub fn is_simple_ring(positions: &Positions, ring: &[u32]) -> bool {
    let mut one = RaggedArray::new();
    one.push(ring);
    let rings = Rings::new(positions, &one);
    if rings.points.len() <= FEW_SIDES
        && let Some(is_simple) = is_simple_by_pairs(&rings)
    {
        return is_simple;
    }
    is_simple_by_tree(&rings)
}

fn is_simple_by_tree(rings: &Rings) -> bool {
    let Ok(meetings) = Meetings::of(&rings.soup, &rings.soup.tree(), &PlanarOptions::default()) else {
        return false;
    };
    rings.points.len() > 2
        && meetings.crossings.is_empty()
        && meetings.touches.is_empty()
        && meetings.equal_points.is_empty()
        && meetings.collinear.is_empty()
}

/// Sides of so few are compared all with each other.
const FEW_SIDES: usize = 96;

/// Whether sides of one ring have no common points but those of neighbors; `None` where a ring goes straight on.
fn is_simple_by_pairs(rings: &Rings) -> Option<bool> {
    let count = rings.points.len();
    let lines: Vec<PlanarLine> = (0..count as u32).map(|side| rings.soup.line(side)).collect();
    let goes_straight = |i: usize| {
        let [a, b] = lines[i];
        orientation(a, b, lines[(i + 1) % count][1]).is_eq()
    };
    if count < 3 || (0..count).any(goes_straight) {
        return None;
    }
    let boxes: Vec<[[f64; 2]; 2]> = (lines.iter())
        .map(|[p, q]| [[0, 1].map(|axis| p[axis].min(q[axis])), [0, 1].map(|axis| p[axis].max(q[axis]))])
        .collect();
    let meet = |i: usize, j: usize| {
        let ([a, b], [c, d]) = (lines[i], lines[j]);
        let beside = |a, b, c, d| {
            let side = orientation(a, b, c);
            side.is_ne() && side == orientation(a, b, d)
        };
        !beside(a, b, c, d) && !beside(c, d, a, b)
    };
    for (i, &[low, high]) in boxes.iter().enumerate() {
        // The last side is a neighbor of the first.
        let end = count - usize::from(i == 0);
        for (j, &[from, to]) in (i + 2..).zip(&boxes[(i + 2).min(end)..end]) {
            let is_apart = (high[0] < from[0]) | (to[0] < low[0]) | (high[1] < from[1]) | (to[1] < low[1]);
            if !is_apart && meet(i, j) {
                return Some(false);
            }
        }
    }
    Some(true)
}

/// For each ring whether it runs the other way than outer rings, which run counterclockwise, or holes, which run clockwise.
#[doc(hidden)]
pub fn turned_rings(positions: &Positions, rings: &RaggedArray, polygons: &RaggedArray) -> Vec<bool> {
    let flat = positions.as_flat().as_chunks::<2>().0;
    let mut is_turned = vec![false; rings.len()];
    for own in polygons.iter() {
        for (i, &ring) in own.iter().enumerate() {
            let turn = turn(rings.list(ring as usize).iter().map(|&vertex| flat[vertex as usize]).collect());
            is_turned[ring as usize] = if i == 0 { turn.is_lt() } else { turn.is_gt() };
        }
    }
    is_turned
}

/// How a simple ring runs: `Greater` for counterclockwise.
fn turn(mut corners: Vec<[f64; 2]>) -> Ordering {
    corners.dedup();
    let lowest = (0..corners.len()).min_by(|&i, &j| {
        let ([x, y], [u, v]) = (corners[i], corners[j]);
        (x + 0.0).total_cmp(&(u + 0.0)).then_with(|| (y + 0.0).total_cmp(&(v + 0.0)))
    });
    let Some(lowest) = lowest else { return Ordering::Equal };
    let at = |i: usize| corners[i % corners.len()];
    let is_other = |i: &usize| at(*i) != at(lowest);
    let after = (lowest + 1..lowest + corners.len()).find(is_other);
    let before = (lowest + 1..lowest + corners.len()).rev().find(is_other);
    match (before, after) {
        (Some(before), Some(after)) => orientation(at(before), at(lowest), at(after)),
        _ => Ordering::Equal,
    }
}

impl PlanarOverlay {
    /// Whether no edge has two sides along it; `shares_edges` allows those of two regions.
    fn has_simple_edges(&self, shares_edges: bool) -> bool {
        let region = |chain: u32| self.regions[self.chains.ring_of(&self.rings, chain) as usize];
        self.cells.edges.chains.iter().all(|chains| match *chains {
            [_] => true,
            [a, b] => shares_edges && region(a) != region(b),
            _ => false,
        })
    }

    /// Whether each region winds around each face once or not at all, and all together as well.
    fn winds_once(&self, region_count: usize) -> bool {
        let (mut windings, mut all, mut outside) = (vec![0; region_count], 0, 0_usize);
        let mut is_sound = true;
        let mut wind = |region: u32, by: i32| {
            let winding: &mut i32 = &mut windings[region as usize];
            let was_outside = usize::from(!(0..=1).contains(winding));
            *winding += by;
            all += by;
            outside = outside + usize::from(!(0..=1).contains(winding)) - was_outside;
            outside == 0 && (0..=1).contains(&all)
        };
        self.tour(|step| match step {
            Step::Into { across, .. } => {
                // Several rings along one edge are crossed one after the other: only the last counts.
                let mut is_fine = true;
                self.across(across, |region, by| is_fine = wind(region, by));
                is_sound &= is_fine;
            }
            Step::Back { across, .. } => self.across(across, |region, by| {
                wind(region, by);
            }),
        });
        is_sound
    }

    /// Whether no ring comes to a point twice, and the rings of no region make a circle by touching each other.
    fn touches_apart(&self, region_of_ring: &[u32]) -> bool {
        let chains = &self.chains;
        let mut ring_count_at = vec![0u32; chains.nodes.len()];
        let mut last_ring = vec![u32::MAX; chains.nodes.len()];
        for (ring, ends) in (0..).zip(chains.starts.windows(2)) {
            for at in &chains.breaks[ends[0] as usize..ends[1] as usize] {
                let node = at.node() as usize;
                if last_ring[node] == ring {
                    return false;
                }
                last_ring[node] = ring;
                ring_count_at[node] += 1;
            }
        }
        // Rings, and for each region the nodes where several of its rings may meet.
        let mut number_of: BTreeMap<(u32, u32), u32> = BTreeMap::new();
        let mut joins: Vec<[u32; 2]> = Vec::new();
        let ring_count = self.rings.numbers.len() as u32;
        for (ring, ends) in (0..).zip(chains.starts.windows(2)) {
            let region = region_of_ring[self.rings.numbers[ring as usize] as usize];
            for at in &chains.breaks[ends[0] as usize..ends[1] as usize] {
                if ring_count_at[at.node() as usize] > 1 {
                    let next = ring_count + number_of.len() as u32;
                    joins.push([ring, *number_of.entry((region, at.node())).or_insert(next)]);
                }
            }
        }
        let mut parts = UnionFind::new(ring_count as usize + number_of.len());
        joins.into_iter().all(|[ring, place]| parts.unite(ring, place))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn pairs_and_trees_find_the_same_rings_simple(
            corners in prop::collection::vec([0i8..7, 0i8..7], 3..24),
            turn in 0..2usize,
        ) {
            // Also stars, most of which are simple.
            let star = |(i, &[x, _]): (usize, &[i8; 2])| {
                let (sine, cosine) = (std::f64::consts::TAU * i as f64 / corners.len() as f64).sin_cos();
                [cosine, sine].map(|part| (1.0 + f64::from(x)) * part)
            };
            let flat: Vec<f64> = match turn {
                0 => corners.as_flattened().iter().map(|&x| f64::from(x)).collect(),
                _ => corners.iter().enumerate().flat_map(star).collect(),
            };
            let all: Vec<u32> = (0..corners.len() as u32).collect();
            let rings = Rings::new(&Positions::from_flat(2, flat).unwrap(), &RaggedArray::from_lists([all]));
            if let Some(is_simple) = is_simple_by_pairs(&rings) {
                prop_assert_eq!(is_simple, is_simple_by_tree(&rings));
            }
        }
    }
}
