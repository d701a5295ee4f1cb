//! Where rings meet: the nodes, and the breaks that they make on rings.
//!
//! Points are only compared with others on the same side, along which both coordinates are in order. That is enough to
//! find which meetings are at one place: all sides through a point meet each other there in pairs, so that one follows
//! from another.

use super::super::crossings::Meetings;
use super::super::faces::NONE;
use super::super::vertices::{Place, split_into_classes};
use super::chains::{Break, Chains, Rings};
use coface_algebra::UnionFind;
use coface_algebra::progress::stage;
use coface_geometry::predicates::PlanarPoint;
use rayon::prelude::*;
use std::cmp::Ordering;

/// So many breaks are worth a task of their own.
const AT_ONCE: usize = 1 << 14;

/// The corners that are nodes, with their numbers among them.
struct SpecialCorners {
    /// A bit for each corner.
    bits: Vec<u64>,
    /// How many special corners come before each word of bits.
    counts: Vec<u32>,
    corners: Vec<u32>,
}

impl SpecialCorners {
    fn new(corner_count: usize, special: impl Iterator<Item = u32>) -> Self {
        let mut bits = vec![0u64; corner_count.div_ceil(64)];
        special.for_each(|corner| bits[corner as usize / 64] |= 1 << (corner % 64));
        let mut counts = Vec::with_capacity(bits.len());
        let mut count = 0;
        for word in &bits {
            counts.push(count);
            count += word.count_ones();
        }
        let mut corners = Vec::with_capacity(count as usize);
        for (first, &word) in (0u32..).step_by(64).zip(&bits) {
            let mut rest = word;
            while rest != 0 {
                corners.push(first + rest.trailing_zeros());
                rest &= rest - 1;
            }
        }
        Self { bits, counts, corners }
    }

    /// How many special corners are below a corner: the number of one that is special.
    fn number(&self, corner: u32) -> u32 {
        let word = corner as usize / 64;
        let Some(&bits) = self.bits.get(word) else { return self.corners.len() as u32 };
        self.counts[word] + (bits & ((1 << (corner % 64)) - 1)).count_ones()
    }
}

/// What happens on rings: special corners, by their numbers among them, and after them crossings.
struct Events<'a> {
    rings: &'a Rings,
    meetings: &'a Meetings,
    special: SpecialCorners,
}

impl Events<'_> {
    fn count(&self) -> usize {
        self.special.corners.len() + self.meetings.crossings.len()
    }

    /// The corner, or the crossing.
    fn origin(&self, event: u32) -> Result<u32, usize> {
        let special = &self.special.corners;
        special.get(event as usize).copied().ok_or_else(|| event as usize - special.len())
    }

    fn rounded(&self, event: u32) -> [f64; 2] {
        match self.origin(event) {
            Ok(corner) => self.rings.soup.points[corner as usize],
            Err(crossing) => self.meetings.crossings[crossing].rounded,
        }
    }

    fn point(&self, event: u32) -> PlanarPoint {
        match self.origin(event) {
            Ok(corner) => PlanarPoint::given(self.rings.soup.points[corner as usize]),
            Err(crossing) => self.meetings.crossings[crossing].point(&self.rings.soup),
        }
    }

    /// The events within sides, as pairs of the side and the event, by rising sides.
    fn within_sides(&self) -> Vec<u64> {
        let key = |side: u32, event: u32| u64::from(side) << 32 | u64::from(event);
        let Meetings { touches, crossings, .. } = self.meetings;
        let mut found = vec![0; touches.len() + 2 * crossings.len()];
        let (of_touches, of_crossings) = found.split_at_mut(touches.len());
        let of_touches = of_touches.par_iter_mut().zip(touches).with_min_len(AT_ONCE);
        of_touches.for_each(|(pair, &[side, corner])| *pair = key(side, self.special.number(corner)));
        let of_crossings = of_crossings.as_chunks_mut::<2>().0.par_iter_mut().zip(crossings).enumerate();
        of_crossings.with_min_len(AT_ONCE).for_each(|(number, (pairs, crossing))| {
            let event = (self.special.corners.len() + number) as u32;
            *pairs = crossing.segments.map(|side| key(side, event));
        });
        found.par_sort_unstable();
        found
    }

    /// Puts the events of one side in the order of the side; of equal ones all but one become [`NONE`], and are told.
    fn put_along_side(&self, own: &mut [u64], sorted: &mut Vec<Place>, equal: &mut Vec<[u32; 2]>) {
        let side = (own[0] >> 32) as u32;
        let [a, b] = self.rings.soup.line(side);
        sorted.clear();
        let mut last = NONE;
        for event in own.iter().map(|&pair| pair as u32) {
            if event != last {
                // Adding zero makes the negative zero positive.
                sorted.push(Place { rounded: self.rounded(event).map(|x| x + 0.0), event });
                last = event;
            }
        }
        // Rounding is monotone: along the side both coordinates are in its order, as far as they tell.
        let along = |p: &Place, q: &Place, axis: usize| {
            let order = p.rounded[axis].total_cmp(&q.rounded[axis]);
            if a[axis] <= b[axis] { order } else { order.reverse() }
        };
        let by_place = |p: &Place, q: &Place| along(p, q, 0).then_with(|| along(p, q, 1));
        sorted.sort_unstable_by(|p, q| by_place(p, q).then(p.event.cmp(&q.event)));
        own.fill(u64::from(side) << 32 | u64::from(NONE));
        let mut places = own.iter_mut();
        let mut put = |event: u32| {
            if let Some(place) = places.next() {
                *place = u64::from(side) << 32 | u64::from(event);
            }
        };
        for same in sorted.chunk_by(|p, q| by_place(p, q) == Ordering::Equal) {
            if let [one] = same {
                put(one.event);
                continue;
            }
            let mut classes = Vec::new();
            split_into_classes(same, &|event| self.point(event), &mut classes);
            if a > b {
                classes.reverse();
            }
            for class in classes {
                put(class[0]);
                equal.extend(class[1..].iter().map(|&event| [class[0], event]));
            }
        }
    }

    /// The lowest of the events at the place of each event, if some are at one place.
    fn lowest_at_place(&self, equal: &[Vec<[u32; 2]>]) -> Option<Vec<u32>> {
        let corners = &self.meetings.equal_points;
        if corners.is_empty() && equal.iter().all(Vec::is_empty) {
            return None;
        }
        let mut classes = UnionFind::new(self.count());
        for &[a, b] in equal.iter().flatten() {
            classes.unite(a, b);
        }
        for &[a, b] in corners {
            classes.unite(self.special.number(a), self.special.number(b));
        }
        let mut lowest = vec![NONE; self.count()];
        let events = 0..self.count() as u32;
        Some(
            events
                .map(|event| {
                    let first = &mut lowest[classes.find(event) as usize];
                    *first = event.min(*first);
                    *first
                })
                .collect(),
        )
    }
}

/// Cuts pairs into parts, no side in two of them.
fn parts_by_side(mut rest: &mut [u64]) -> Vec<&mut [u64]> {
    let mut parts = Vec::with_capacity(rest.len() / AT_ONCE + 1);
    while !rest.is_empty() {
        let mut end = AT_ONCE.min(rest.len());
        while end < rest.len() && rest[end] >> 32 == rest[end - 1] >> 32 {
            end += 1;
        }
        let (part, after) = rest.split_at_mut(end);
        parts.push(part);
        rest = after;
    }
    parts
}

/// The breaks on some rings, with events for nodes.
#[derive(Default)]
struct RingBreaks {
    /// The event, or [`NONE`] for a node that is alone on its ring.
    breaks: Vec<(u32, u32, bool)>,
    /// Where the breaks of each ring end.
    ends: Vec<u32>,
}

impl Chains {
    pub(super) fn new(rings: &Rings, meetings: &Meetings) -> Self {
        // A ring there and back is cut at both ends, so that it is one edge.
        let there_and_back = rings.starts.windows(2).filter(|ends| ends[1] - ends[0] == 2);
        let special = meetings.touches.iter().map(|touch| touch[1]);
        let special = special.chain(meetings.equal_points.as_flattened().iter().copied());
        let special = special.chain(there_and_back.flat_map(|ends| ends[0]..ends[1]));
        let special = SpecialCorners::new(rings.soup.points.len(), special);
        let events = Events { rings, meetings, special };
        let mut within = events.within_sides();
        let parts = parts_by_side(&mut within);
        let steps = stage("sorting crossings along sides", parts.len());
        let equal: Vec<Vec<[u32; 2]>> = parts
            .into_par_iter()
            .map(|part| {
                steps.advance(1);
                let (mut sorted, mut equal) = (Vec::new(), Vec::new());
                for own in part.chunk_by_mut(|a, b| a >> 32 == b >> 32).filter(|own| own.len() > 1) {
                    events.put_along_side(own, &mut sorted, &mut equal);
                }
                equal
            })
            .collect();
        let lowest = events.lowest_at_place(&equal);
        let special = &events.special.corners;
        let (corner_count, special_count) = (rings.soup.points.len() as u32, special.len() as u32);
        let ring_count = rings.numbers.len();
        let at_once = (ring_count / 64).clamp(1, AT_ONCE);
        let parts: Vec<RingBreaks> = (0..ring_count.div_ceil(at_once))
            .into_par_iter()
            .map(|part| {
                let own = part * at_once..((part + 1) * at_once).min(ring_count);
                breaks_on_rings(&events, &within, lowest.as_deref(), own)
            })
            .collect();
        drop(within);
        let break_count: usize = parts.iter().map(|part| part.breaks.len()).sum();
        let mut number_of = vec![NONE; events.count()];
        let mut found = Self {
            nodes: Vec::with_capacity(events.count() + ring_count),
            breaks: Vec::with_capacity(break_count),
            starts: Vec::with_capacity(ring_count + 1),
            meeting_count: 0,
        };
        found.starts.push(0);
        for RingBreaks { breaks, ends } in parts {
            let first = found.breaks.len() as u32;
            found.starts.extend(ends.iter().map(|end| first + end));
            for (side, event, is_within) in breaks {
                let next = found.nodes.len() as u32;
                let node = match number_of.get_mut(event as usize) {
                    // A corner alone.
                    None => {
                        found.nodes.push(side);
                        next
                    }
                    Some(number) => {
                        if *number == NONE {
                            *number = next;
                            found.nodes.push(match special.get(event as usize) {
                                Some(&corner) => corner,
                                None => corner_count + (event - special_count),
                            });
                            found.meeting_count += 1;
                        }
                        *number
                    }
                };
                found.breaks.push(Break::new(side, node, is_within));
            }
        }
        found
    }
}

/// Special corners and events within sides, merged along some rings.
fn breaks_on_rings(
    events: &Events<'_>,
    within: &[u64],
    lowest: Option<&[u32]>,
    own: std::ops::Range<usize>,
) -> RingBreaks {
    let rings = events.rings;
    let mut found = RingBreaks::default();
    let class_of = |event: u32| lowest.map_or(event, |lowest| lowest[event as usize]);
    let first_side = rings.starts[own.start];
    let mut next_special = events.special.number(first_side);
    let mut next_within = within.partition_point(|&pair| ((pair >> 32) as u32) < first_side);
    for ring in own {
        let sides = rings.sides(ring);
        let first = found.breaks.len();
        loop {
            let corner = events.special.corners.get(next_special as usize).copied().unwrap_or(NONE);
            let side = within.get(next_within).map_or(NONE, |pair| (pair >> 32) as u32);
            if corner.min(side) >= sides.end {
                break;
            }
            if corner <= side {
                found.breaks.push((corner, class_of(next_special), false));
                next_special += 1;
            } else {
                let event = within[next_within] as u32;
                if event != NONE {
                    found.breaks.push((side, class_of(event), true));
                }
                next_within += 1;
            }
        }
        if found.breaks.len() == first {
            // A ring that meets no other gets a node of its own.
            let corner = rings.lowest_corner(sides).expect("rings have corners");
            found.breaks.push((corner, NONE, false));
        }
        found.ends.push(found.breaks.len() as u32);
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn special_corners_are_numbered_as_they_rise() {
        let special = SpecialCorners::new(200, [130, 3, 64, 130, 63, 199].into_iter());
        assert_eq!(special.corners, [3, 63, 64, 130, 199]);
        for (number, corner) in (0..).zip(special.corners.iter().copied()) {
            assert_eq!(special.number(corner), number);
        }
        assert_eq!([0, 4, 131, 200, 1000].map(|corner| special.number(corner)), [0, 1, 4, 5, 5]);
        assert_eq!(SpecialCorners::new(0, std::iter::empty()).number(0), 0);
    }
}
