//! Features of drawings that are nearer to each other than a tolerance become one.

use super::rounding::SnappedArrangement;
use super::{PlanarArrangement, VertexSource};
use crate::near::{
    Chain, CoordinatePrecision, JoinedFeatures, NONE, NearChains, NearCounts, least_tolerance, minus, plus,
    reach, squared,
};
use coface_algebra::{Error, RaggedArray};
use coface_geometry::{Positions, dot};

/// Features up to eight times as far apart may be put together to come to an end.
const MOST_ROUNDS: usize = 8;
/// In so many rounds crossings are left out where straight edges go through them.
const ROUNDS_OF_STRAIGHTENING: usize = 4;

impl PlanarArrangement {
    /// The arrangement with all that is at most `tolerance` apart put together: vertices, then vertices and edges. All of
    /// it is cut and put together again until nothing new comes of it.
    ///
    /// A point of the input moves by at most the tolerance each time that it is put somewhere; crossings give way to
    /// points of the input, and are left out where only edges that are straight within the tolerance go through them. The
    /// result depends neither on the order of the segments nor on their directions. A
    /// tolerance below four units of the last place of the largest coordinate counts as that.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if the tolerance is negative or no number, or
    /// if there is no end to what is put together.
    ///
    /// # Complexity
    /// That of an arrangement of the edges a round, and $O(n \log n)$ for n edges that are near few others.
    ///
    /// # Examples
    /// Two squares with a side in common, but for a hundredth:
    /// ```
    /// use coface_arrange::planar::PlanarArrangement;
    /// use coface_geometry::{Positions, dot};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let corners = vec![0., 0., 1., 0., 1., 1., 0., 1., 1.01, 0., 2., 0., 2., 1., 0.99, 1.];
    /// let sides = [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4]];
    /// let squares = PlanarArrangement::new(&Positions::from_flat(2, corners)?, &sides)?;
    /// assert_eq!(squares.face_count(), 3);
    /// let joined = squares.within(0.05)?;
    /// assert_eq!(joined.arrangement().f_vector(), [6, 7, 2]);
    /// let moved = joined.joined().map(|joined| joined.largest_movement);
    /// assert!(moved.is_some_and(|way| way < 0.011));
    /// # Ok(()) }
    /// ```
    pub fn within(&self, tolerance: f64) -> Result<SnappedArrangement, Error> {
        self.in_rounds(tolerance, |drawing, tolerance, round| {
            drawing.joined(tolerance, round < ROUNDS_OF_STRAIGHTENING)
        })
    }

    /// What this does to a drawing again and again, until it says that nothing new comes of it.
    pub(super) fn in_rounds(
        &self,
        tolerance: f64,
        mut next: impl FnMut(&Drawing, f64, usize) -> Result<(Drawing, NearCounts, bool), Error>,
    ) -> Result<SnappedArrangement, Error> {
        if !(tolerance.is_finite() && tolerance >= 0.0) {
            return Err(Error::invalid(format!("{tolerance} is no tolerance"))
                .with_cure("give a length in the unit of the drawing, like 0.001"));
        }
        let mut drawing = Drawing::of(self);
        let first = drawing.points.clone();
        let tolerance = tolerance.max(least_tolerance(&first, CoordinatePrecision::Double));
        let mut joined = JoinedFeatures { tolerance, ..JoinedFeatures::default() };
        for round in 0..MOST_ROUNDS {
            joined.tolerance = reach(tolerance, round);
            let (after, counts, is_settled) = next(&drawing, joined.tolerance, round)?;
            joined.counts.add(&counts);
            drawing = after;
            if is_settled {
                joined.tell(&first, &drawing.places, &drawing.points);
                let places = self.places_in(&drawing);
                let segments =
                    drawing.segments.iter().map(|own| own.iter().map(|&own| own >> 1).collect::<Vec<_>>());
                return Ok(SnappedArrangement {
                    segments_of_edge: RaggedArray::from_lists(segments),
                    runs_up: Some(drawing.segments.items().iter().map(|own| own & 1 == 0).collect()),
                    arrangement: drawing.arrangement,
                    sources: drawing.sources,
                    places,
                    place_of_point: drawing.places,
                    round_count: round + 1,
                    joined: Some(joined),
                    stacked: None,
                });
            }
        }
        Err(Error::invalid(format!(
            "features less than {:e} apart are put together again and again: {MOST_ROUNDS} rounds are not enough",
            joined.tolerance
        ))
        .with_cure("take a smaller tolerance, or put the drawing on a grid"))
    }

    /// What vertices became: points their places, and a crossing the nearest vertex on the paths of both of its segments.
    fn places_in(&self, drawing: &Drawing) -> Vec<u32> {
        let edges_of_segment = drawing.segments.transposed(2 * self.segments.len());
        let on_path = |segment: usize| {
            let edges = [2 * segment, 2 * segment + 1].into_iter().flat_map(|way| edges_of_segment.list(way));
            let mut own: Vec<u32> = edges.flat_map(|&edge| drawing.ends[edge as usize]).collect();
            own.sort_unstable();
            own.dedup();
            if own.is_empty() { vec![drawing.places[self.segments[segment][0] as usize]] } else { own }
        };
        let place = |(source, point): (&VertexSource, [f64; 3])| match *source {
            VertexSource::Given(point) => drawing.places[point],
            VertexSource::Crossing([s, t]) => {
                let (mut own, other) = (on_path(s), on_path(t));
                if own.iter().any(|vertex| other.binary_search(vertex).is_ok()) {
                    own.retain(|vertex| other.binary_search(vertex).is_ok());
                }
                let way = |&vertex: &u32| squared(minus(drawing.points[vertex as usize], point));
                let nearest = own.into_iter().min_by(|a, b| way(a).total_cmp(&way(b)));
                nearest.expect("a path has a vertex")
            }
        };
        self.sources.iter().zip(in_space(&self.positions)).map(place).collect()
    }
}

/// A drawing on the way: points and edges between them.
pub(super) struct Drawing {
    pub(super) points: Vec<[f64; 3]>,
    pub(super) sources: Vec<VertexSource>,
    pub(super) ends: Vec<[u32; 2]>,
    /// The segments of the input along each edge, **packed** as twice the segment, plus one where it runs against the edge.
    pub(super) segments: RaggedArray,
    /// The point that each point of the input became.
    places: Vec<u32>,
    pub(super) arrangement: PlanarArrangement,
}

/// Points and edges that a drawing became, before they are cut.
pub(super) struct Redrawn {
    pub(super) points: Vec<[f64; 2]>,
    pub(super) sources: Vec<VertexSource>,
    /// The point that each point of the drawing became.
    pub(super) places: Vec<u32>,
    pub(super) ends: Vec<[u32; 2]>,
    /// The segments along each edge, packed.
    pub(super) segments: RaggedArray,
}

impl Redrawn {
    /// The edges cut where they cross.
    pub(super) fn cut(self, before: &Drawing) -> Result<Drawing, Error> {
        let Self { points, sources, places, ends, segments } = self;
        let arrangement = PlanarArrangement::new(&Positions::from_flat(2, points.concat())?, &ends)?;
        let source = |source: &VertexSource| match *source {
            VertexSource::Given(point) => sources[point],
            VertexSource::Crossing(sides) => {
                VertexSource::Crossing(sides.map(|side| segments.list(side)[0] as usize >> 1))
            }
        };
        let sources = arrangement.sources.iter().map(source).collect();
        let number_of = |point: u32| arrangement.vertex_of_point[point as usize];
        let along = |sides: &[u32]| {
            let packed = sides.iter().flat_map(|&side| {
                let [low, high] = ends[side as usize].map(number_of);
                segments.list(side as usize).iter().map(move |own| own ^ u32::from(low > high))
            });
            once(packed.collect())
        };
        let segments = RaggedArray::from_lists(arrangement.segments_of_edge.iter().map(along));
        let places = before.places.iter().map(|&place| number_of(places[place as usize])).collect();
        Ok(Drawing {
            points: in_space(&arrangement.positions),
            sources,
            ends: arrangement.ends.clone(),
            segments,
            places,
            arrangement,
        })
    }
}

impl Drawing {
    /// The segments as they were drawn, not cut: those that nearly coincide are to become one before they cross.
    fn of(arrangement: &PlanarArrangement) -> Self {
        let points: Vec<[f64; 3]> = arrangement.points.iter().map(|&[x, y]| [x, y, 0.0]).collect();
        let numbers = 0..points.len() as u32;
        let segments = (0..arrangement.segments.len() as u32).map(|segment| [2 * segment]);
        Self {
            sources: numbers.clone().map(|point| VertexSource::Given(point as usize)).collect(),
            ends: arrangement.segments.clone(),
            segments: RaggedArray::from_lists(segments),
            places: numbers.collect(),
            points,
            arrangement: arrangement.clone(),
        }
    }

    /// What is near is put together once, and cut; with whether nothing came of that any more.
    fn joined(&self, tolerance: f64, straightens: bool) -> Result<(Self, NearCounts, bool), Error> {
        let count = self.points.len();
        let chains = (0..).zip(&self.ends).filter(|(_, ends)| ends[0] != ends[1]);
        let chains = chains.map(|(edge, &ends)| Chain::new(edge, vec![ends]));
        let is_passing = self.sources.iter().map(|source| matches!(source, VertexSource::Crossing(_)));
        let mut near =
            NearChains::new(self.points.clone(), chains.collect(), Vec::new(), is_passing.collect());
        near.alone = (0..count as u32).collect();
        let is_apart = near.join(tolerance, |_| false);
        let mut drawn = DrawnSides::of(&near, &self.segments);
        let left_out = if straightens { drawn.straighten(&near, tolerance) } else { Vec::new() };
        let DrawnSides { mut ends, segments } = drawn;
        // What points became stays, be there edges or not.
        let end_of = |point: u32| {
            let end = near.end_of(point);
            left_out.binary_search_by_key(&end, |own| own.0).map_or(end, |at| left_out[at].1)
        };
        let mut number = vec![NONE; near.points.len()];
        (0..count as u32).for_each(|point| number[end_of(point) as usize] = 0);
        ends.as_flattened().iter().for_each(|&end| number[end as usize] = 0);
        let mut used: Vec<u32> = Vec::new();
        for (point, number) in (0..).zip(&mut number).filter(|(_, number)| **number != NONE) {
            *number = used.len() as u32;
            used.push(point);
        }
        ends.as_flattened_mut().iter_mut().for_each(|end| *end = number[*end as usize]);
        // New points are where two segments cross.
        let mut segments_at: Vec<(u32, u32)> = Vec::new();
        for (own, segments) in ends.iter().zip(segments.iter()) {
            for &end in own.iter().filter(|&&end| used[end as usize] as usize >= count) {
                segments_at.extend(segments.iter().map(|&segment| (end, segment >> 1)));
            }
        }
        segments_at.sort_unstable();
        let crossing = |point: u32| {
            let start = segments_at.partition_point(|own| own.0 < point);
            let own = segments_at[start..].iter().take_while(|own| own.0 == point).map(|own| own.1 as usize);
            VertexSource::Crossing([own.clone().next(), own.last()].map(Option::unwrap_or_default))
        };
        let source = |(point, &old): (u32, &u32)| match old as usize {
            old if old < count => self.sources[old],
            _ => crossing(point),
        };
        let redrawn = Redrawn {
            points: used.iter().map(|&point| [0, 1].map(|axis| near.points[point as usize][axis])).collect(),
            sources: (0..).zip(&used).map(source).collect(),
            places: (0..count as u32).map(|point| number[end_of(point) as usize]).collect(),
            ends,
            segments,
        };
        let next = redrawn.cut(self)?;
        let is_settled = next.arrangement.vertex_count() == used.len() && left_out.is_empty() && is_apart;
        Ok((next, near.counts, is_settled))
    }
}

/// Packed segments, each once: one that goes to and fro is none.
pub(super) fn once(mut packed: Vec<u32>) -> Vec<u32> {
    packed.sort_unstable();
    let ways = packed.chunk_by(|a, b| a >> 1 == b >> 1).filter(|ways| ways.len() % 2 == 1);
    ways.map(|ways| ways[ways.len() / 2]).collect()
}

/// The sides of chains.
struct DrawnSides {
    /// The lower end first, rising.
    ends: Vec<[u32; 2]>,
    /// The segments along each side, packed: some for each.
    segments: RaggedArray,
}

impl DrawnSides {
    fn of(near: &NearChains, segments: &RaggedArray) -> Self {
        let sides = near.chains.iter().flat_map(|chain| chain.sides.iter().map(|&ends| (ends, chain.owner)));
        let all =
            sides.flat_map(|(ends, edge)| segments.list(edge as usize).iter().map(move |&own| (ends, own)));
        Self::grouped(all.collect())
    }

    /// Of segments along sides in both directions.
    fn grouped(mut all: Vec<([u32; 2], u32)>) -> Self {
        for (ends, segment) in &mut all {
            *segment ^= u32::from(ends[0] > ends[1]);
            ends.sort_unstable();
        }
        all.sort_unstable();
        let (mut ends, mut segments) = (Vec::new(), RaggedArray::new());
        for group in all.chunk_by(|x, y| x.0 == y.0) {
            let own = once(group.iter().map(|own| own.1).collect());
            if !own.is_empty() {
                ends.push(group[0].0);
                segments.push(&own);
            }
        }
        Self { ends, segments }
    }

    /// The segments along a side as it is seen from one of its ends.
    fn seen_from(&self, side: usize, end: u32) -> impl Iterator<Item = u32> {
        let against = u32::from(self.ends[side][0] != end);
        self.segments.list(side).iter().map(move |own| own ^ against)
    }

    /// Leaves out passing points on paths that are straight within the tolerance, and on which the same segments run all the
    /// way: each with the nearer end of its path, rising.
    fn straighten(&mut self, near: &NearChains, tolerance: f64) -> Vec<(u32, u32)> {
        let sides_at = RaggedArray::grouped(near.points.len(), self.ends.iter().flatten().copied());
        // Each side is there by both of its ends.
        let around = |point: u32| sides_at.list(point as usize).iter().map(|&end| end as usize / 2);
        let is_between = |point: u32| {
            near.is_passing[point as usize]
                && match around(point).collect::<Vec<_>>()[..] {
                    [one, other] => {
                        self.seen_from(one, point).map(|own| own ^ 1).eq(self.seen_from(other, point))
                    }
                    _ => false,
                }
        };
        let is_between: Vec<bool> = (0..near.points.len() as u32).map(is_between).collect();
        let mut is_seen = vec![false; self.ends.len()];
        let mut is_gone = vec![false; self.ends.len()];
        let (mut left_out, mut straight) = (Vec::new(), Vec::new());
        for first in 0..self.ends.len() {
            let ends = self.ends[first];
            let Some(&start) = ends.iter().find(|&&end| !is_between[end as usize]) else { continue };
            if is_seen[first] || !ends.iter().any(|&end| is_between[end as usize]) {
                continue;
            }
            let (mut path, mut along, mut side) = (vec![start], vec![first], first);
            loop {
                is_seen[side] = true;
                let [a, b] = self.ends[side];
                let next = if path.last() == Some(&a) { b } else { a };
                path.push(next);
                if !is_between[next as usize] {
                    break;
                }
                let Some(other) = around(next).find(|&other| other != side) else { break };
                side = other;
                along.push(side);
            }
            let [start, inner @ .., end] = &path[..] else { continue };
            if start == end || !is_straight(near, &path, tolerance) {
                continue;
            }
            along.iter().for_each(|&side| is_gone[side] = true);
            straight.extend(self.seen_from(first, *start).map(|own| ([*start, *end], own)));
            let distance = |a: u32, b: u32| squared(minus(near.point(a), near.point(b)));
            let is_first = |own: u32| distance(own, *start) <= distance(own, *end);
            left_out.extend(inner.iter().map(|&own| (own, if is_first(own) { *start } else { *end })));
        }
        if !left_out.is_empty() {
            for side in (0..self.ends.len()).filter(|&side| !is_gone[side]) {
                straight.extend(self.segments.list(side).iter().map(|&own| (self.ends[side], own)));
            }
            *self = Self::grouped(straight);
            left_out.sort_unstable();
        }
        left_out
    }
}

/// Whether points follow each other from the first to the last, this near to the line between them.
fn is_straight(near: &NearChains, path: &[u32], tolerance: f64) -> bool {
    let [first, inner @ .., last] = path else { return true };
    let (origin, along) = (near.point(*first), minus(near.point(*last), near.point(*first)));
    let mut before = 0.0;
    inner.iter().all(|&point| {
        let to = minus(near.point(point), origin);
        let part = dot(to, along) / squared(along);
        let is_further = part > before && part < 1.0;
        before = part;
        is_further && squared(plus(to, -part, along)) <= tolerance * tolerance
    })
}

/// Points in the plane z = 0.
fn in_space(positions: &Positions) -> Vec<[f64; 3]> {
    positions.as_flat().as_chunks::<2>().0.iter().map(|&[x, y]| [x, y, 0.0]).collect()
}
