//! The rings of a drawing as closed walks, for an overlay of them.

use super::drawing::{Filling, NO_RING, PlanarDrawing};
use coface_algebra::RaggedArray;
use coface_algebra::{EdgeId, Error, VertexId};
use coface_arrange::planar::{
    PlanarArrangement, PlanarOptions, PlanarOverlay, SnappedArrangement, VertexSource,
};
use coface_geometry::Positions;
use coface_geometry::predicates::orientation;
use std::cmp::Ordering;

/// Closed walks along the segments of a drawing: what is laid over each other.
///
/// Each ring of a polygon is a walk. Lines that bound a region are walks in any directions: only parities count there. A
/// segment of no ring is a walk there and back, which bounds nothing. In a snapped drawing, walks run through the places that
/// segments were moved to.
pub(super) struct Walks<'a> {
    drawing: &'a PlanarDrawing,
    snapped: Option<Snapped<'a>>,
    /// The corners of each walk, vertices of the drawing or of the snapped arrangement.
    corners: RaggedArray,
    /// The ring of each walk; the number of rings for segments of none.
    rings: Vec<u32>,
    /// The segment of the drawing along each side of the walks.
    segments: Vec<u32>,
}

/// The walks along some of the rings of a drawing.
pub(super) struct RingWalks {
    pub(super) corners: RaggedArray,
    /// The ring of each walk.
    pub(super) rings: Vec<u32>,
    /// The segment of the drawing along each side of the walks.
    pub(super) segments: Vec<u32>,
}

struct Snapped<'a> {
    arrangement: &'a SnappedArrangement,
    /// The edges along each segment of the drawing.
    edges_of_segment: RaggedArray,
}

impl<'a> Walks<'a> {
    /// The walks of a drawing, through the vertices of the arrangement that it was snapped to if there is one.
    pub(super) fn new(drawing: &'a PlanarDrawing, snapped: Option<&'a SnappedArrangement>) -> Self {
        let snapped = snapped.map(|arrangement| Snapped {
            arrangement,
            edges_of_segment: arrangement.segments_of_edges().transposed(drawing.segments.len()),
        });
        let (mut corners, mut rings, mut segments) = (RaggedArray::new(), Vec::new(), Vec::new());
        let mut add = |ring: u32, halfsegments: &mut dyn Iterator<Item = u32>| {
            let mut own = Vec::new();
            for halfsegment in halfsegments {
                match &snapped {
                    Some(snapped) => {
                        snapped.corners_along(drawing, halfsegment, &mut own);
                        segments.resize(corners.item_count() + own.len(), halfsegment / 2);
                    }
                    None => {
                        own.push(drawing.segments[halfsegment as usize / 2][halfsegment as usize % 2]);
                        segments.push(halfsegment / 2);
                    }
                }
            }
            corners.push(&own);
            rings.push(ring);
        };
        // The segments of a ring follow each other. Halfsegment 2s goes along segment s, 2s + 1 back.
        let mut next = 0;
        for group in drawing.ring_of_segment.chunk_by(|a, b| a == b) {
            let (first, ring) = (next, group[0]);
            next += group.len() as u32;
            let mut along = (first..next).map(|segment| 2 * segment);
            if ring == NO_RING {
                along.for_each(|halfsegment| {
                    add(drawing.rings.len() as u32, &mut [halfsegment, halfsegment + 1].into_iter());
                });
            } else if drawing.polygons[drawing.rings[ring as usize].polygon as usize].filling
                == Filling::Lines
            {
                for walk in closed_walks(drawing, first, group.len()) {
                    add(ring, &mut walk.into_iter());
                }
            } else {
                add(ring, &mut along);
            }
        }
        Self { drawing, snapped, corners, rings, segments }
    }

    /// The overlay of all walks, in which rings are regions.
    ///
    /// # Errors
    /// As [`PlanarOverlay::with_options`].
    pub(super) fn overlay(&self, options: &PlanarOptions) -> Result<PlanarOverlay, Error> {
        let positions: &Positions = match &self.snapped {
            Some(snapped) => snapped.arrangement.arrangement().positions(),
            None => &self.drawing.positions,
        };
        PlanarOverlay::without_windings(positions, &self.corners, &self.rings, options)
    }

    /// The walks along rings alone, of those rings that are wanted.
    pub(super) fn along_rings(&self, is_wanted: impl Fn(u32) -> bool) -> RingWalks {
        let ring_count = self.drawing.rings.len() as u32;
        let mut found = RingWalks { corners: RaggedArray::new(), rings: Vec::new(), segments: Vec::new() };
        for (walk, &ring) in
            self.rings.iter().enumerate().filter(|(_, ring)| **ring < ring_count && is_wanted(**ring))
        {
            let first = self.corners.start(walk);
            let corners = self.corners.list(walk);
            found.corners.push(corners);
            found.rings.push(ring);
            found.segments.extend_from_slice(&self.segments[first..first + corners.len()]);
        }
        found
    }

    /// The segment of the drawing along a side of the walks.
    pub(super) fn segment(&self, side: usize) -> u32 {
        self.segments[side]
    }

    /// Where a vertex of the overlay comes from in the drawing.
    pub(super) fn source(&self, source: VertexSource) -> VertexSource {
        match source {
            VertexSource::Given(corner) => match &self.snapped {
                Some(snapped) => snapped.arrangement.source(VertexId::new(corner)),
                None => source,
            },
            VertexSource::Crossing(sides) => {
                VertexSource::Crossing(sides.map(|side| self.segments[side] as usize))
            }
        }
    }
}

impl Snapped<'_> {
    /// Adds the vertices from the start of a halfsegment on to before its end. Those at which it goes straight on are left out.
    fn corners_along(&self, drawing: &PlanarDrawing, halfsegment: u32, corners: &mut Vec<u32>) {
        let segment = halfsegment as usize / 2;
        if let Some(runs_up) = self.arrangement.runs_up() {
            return self.follow(drawing, halfsegment, runs_up, corners);
        }
        let [from, to] = drawing.segments[segment].map(|vertex| drawing.place(vertex));
        let ends = if halfsegment % 2 == 1 { [to, from] } else { [from, to] };
        corners_along(self.arrangement.arrangement(), self.edges_of_segment.list(segment), ends, corners);
    }
}

impl Snapped<'_> {
    /// Adds the vertices along a halfsegment by the ways in which it runs along edges.
    fn follow(&self, drawing: &PlanarDrawing, halfsegment: u32, runs_up: &[bool], corners: &mut Vec<u32>) {
        let (segment, is_back) = (halfsegment / 2, halfsegment % 2 == 1);
        let along = self.arrangement.segments_of_edges();
        let step = |&edge: &u32| {
            let own =
                along.list(edge as usize).binary_search(&segment).expect("the segment is along the edge");
            let [low, high] =
                self.arrangement.arrangement().ends(EdgeId::from_u32(edge)).map(VertexId::to_u32);
            if runs_up[along.start(edge as usize) + own] == is_back { [high, low] } else { [low, high] }
        };
        let mut steps: Vec<[u32; 2]> =
            self.edges_of_segment.list(segment as usize).iter().map(step).collect();
        steps.sort_unstable();
        let start = drawing.segments[segment as usize][usize::from(is_back)];
        let Some(start) = self.arrangement.place_of_point(start as usize) else { return };
        // All steps in one walk: what is left of loops at a vertex is gone around before that is left.
        let (mut open, mut walk) = (vec![start.to_u32()], Vec::with_capacity(steps.len() + 1));
        let mut is_taken = vec![false; steps.len()];
        while let Some(&last) = open.last() {
            let first = steps.partition_point(|step| step[0] < last);
            let mut leaving = (first..steps.len()).take_while(|&own| steps[own][0] == last);
            match leaving.find(|&own| !is_taken[own]) {
                Some(next) => {
                    is_taken[next] = true;
                    open.push(steps[next][1]);
                }
                None => walk.extend(open.pop()),
            }
        }
        walk.reverse();
        walk.pop();
        corners.extend(walk);
    }
}

/// Adds the vertices of edges that a segment was bent to, from its start on to before its end. Those at which it goes
/// straight on are left out.
pub(super) fn corners_along(
    arrangement: &PlanarArrangement,
    edges: &[u32],
    ends: [[f64; 2]; 2],
    corners: &mut Vec<u32>,
) {
    let place = |vertex: u32| {
        let point = arrangement.positions().point(VertexId::from_u32(vertex));
        [point[0], point[1]]
    };
    let vertices = vertices_along(arrangement, edges, ends);
    for i in 0..vertices.len().saturating_sub(1) {
        let goes_straight = i > 0 && {
            let [p, q, r] = [vertices[i - 1], vertices[i], vertices[i + 1]].map(place);
            orientation(p, q, r).is_eq()
        };
        if !goes_straight {
            corners.push(vertices[i]);
        }
    }
}

/// The vertices of edges that a segment was bent to, from its start to its end.
pub(super) fn vertices_along(
    arrangement: &PlanarArrangement,
    edges: &[u32],
    [from, to]: [[f64; 2]; 2],
) -> Vec<u32> {
    let place = |vertex: u32| {
        let point = arrangement.positions().point(VertexId::from_u32(vertex));
        [point[0], point[1]]
    };
    let mut vertices: Vec<u32> = edges
        .iter()
        .flat_map(|&edge| arrangement.ends(EdgeId::from_u32(edge)).map(VertexId::to_u32))
        .collect();
    // Rounding never turns the order of coordinates around: pieces go the way of the segment on both axes, or stand still on one.
    let along = |a: f64, b: f64, axis: usize| match from[axis].total_cmp(&to[axis]) {
        Ordering::Greater => b.total_cmp(&a),
        _ => a.total_cmp(&b),
    };
    vertices.sort_unstable_by(|&a, &b| {
        let [p, q] = [a, b].map(place);
        along(p[0], q[0], 0).then_with(|| along(p[1], q[1], 1)).then(a.cmp(&b))
    });
    vertices.dedup();
    vertices
}

/// Lines of which an even number ends at every point as closed walks of halfsegments.
fn closed_walks(drawing: &PlanarDrawing, first: u32, count: usize) -> Vec<Vec<u32>> {
    // End 2s is where segment s starts, 2s + 1 where it ends, from the first segment on.
    let place =
        |end: u32| drawing.place_key(drawing.segments[first as usize + end as usize / 2][end as usize % 2]);
    let mut ends: Vec<([u64; 2], u32)> = (0..2 * count as u32).map(|end| (place(end), end)).collect();
    ends.sort_unstable();
    let mut partners = vec![0; ends.len()];
    for pair in ends.chunks_exact(2) {
        let [a, b] = [pair[0].1, pair[1].1];
        (partners[a as usize], partners[b as usize]) = (b, a);
    }
    let mut is_done = vec![false; count];
    let mut walks = Vec::new();
    for start in 0..count as u32 {
        let (mut walk, mut end) = (Vec::new(), 2 * start);
        while !std::mem::replace(&mut is_done[end as usize / 2], true) {
            walk.push(2 * first + end);
            end = partners[(end ^ 1) as usize];
        }
        if !walk.is_empty() {
            walks.push(walk);
        }
    }
    walks
}
