//! The rings around selected faces.

use super::regions::Parts;
use super::ring_cells::TracedRings;
use super::{PlanarOverlay, PlanarPolygons};
use crate::Error;
use crate::algebra::RaggedArray;
use crate::arrangement::planar::faces::NONE;
use crate::geometry::Positions;
use crate::geometry::predicates::{PlanarPoint, direction_turn};

impl PlanarOverlay {
    /// The polygons of the faces whose winding numbers satisfy a condition: for each face it gets the regions with a winding number
    /// that is not zero, rising, with that number; for the unbounded face the empty list.
    ///
    /// Faces with an edge in common are one polygon; edges with the selection on both sides are left out, and so are crossings at
    /// which a ring goes straight on.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`](crate::ErrorKind::TooLarge) beyond 2^32 vertices.
    ///
    /// # Complexity
    /// Linear in the nodes, edges and faces, and in what comes out.
    pub fn select(&self, condition: impl Fn(&[(u32, i32)]) -> bool) -> Result<PlanarPolygons<'_>, Error> {
        Ok(self.outline(condition, false)?.0)
    }

    /// The same, and the smallest ring around each ring, if there is one.
    ///
    /// # Errors
    /// As [`Self::select`].
    pub(crate) fn select_nested(
        &self,
        condition: impl Fn(&[(u32, i32)]) -> bool,
    ) -> Result<(PlanarPolygons<'_>, Vec<Option<u32>>), Error> {
        self.outline(condition, true)
    }

    fn outline(
        &self,
        condition: impl Fn(&[(u32, i32)]) -> bool,
        is_nested: bool,
    ) -> Result<(PlanarPolygons<'_>, Vec<Option<u32>>), Error> {
        let is_inside = self.cells.faces_where(condition);
        let parts = self.parts();
        let traced = self.cells.trace(&is_inside, |halfedges| self.is_counterclockwise(&parts, halfedges));
        let TracedRings { halfedges, starts, by_polygon, has_exterior } = traced;
        let parents = if is_nested {
            self.cells.parents_in_order(&halfedges, &starts, by_polygon.items())
        } else {
            Vec::new()
        };
        // Rings are written polygon after polygon.
        let mut writer = Writer::new(self, parts, &halfedges);
        for &ring in by_polygon.items() {
            writer.write(&halfedges[starts[ring as usize]..starts[ring as usize + 1]]);
        }
        let mut ring_numbers = 0u32..;
        let polygons = RaggedArray::from_lists(
            by_polygon.iter().map(|list| ring_numbers.by_ref().take(list.len()).collect::<Vec<_>>()),
        );
        Ok((writer.finish(polygons, has_exterior)?, parents))
    }

    /// Whether a simple ring runs counterclockwise: it does at its lowest point.
    fn is_counterclockwise(&self, parts: &Parts<'_>, halfedges: &[u32]) -> bool {
        let rank = |at: &usize| self.chains.ranks[self.cells.tail(halfedges[*at]) as usize];
        let Some(at_node) = (0..halfedges.len()).min_by_key(rank) else { return false };
        let point = |corner: u32| self.rings.soup.points[corner as usize];
        let corners = halfedges.iter().enumerate().filter_map(|(at, &halfedge)| {
            let corner = self.lowest_corners[halfedge as usize / 2];
            (corner != NONE).then_some((at, corner))
        });
        let lowest = corners.reduce(|a, b| if point(b.1) < point(a.1) { b } else { a });
        let node = parts.node_point(self.cells.tail(halfedges[at_node]));
        let lowest = lowest.filter(|&(_, corner)| PlanarPoint::given(point(corner)).compare(&node).is_lt());
        let (at, corner) = lowest.map_or((at_node, None), |(at, corner)| (at, Some(corner)));
        match corner {
            Some(corner) => {
                let turns_left = parts.turn_at(corner, parts.ring_of_edge(halfedges[at] / 2)).is_gt();
                turns_left == halfedges[at].is_multiple_of(2)
            }
            None => {
                let before = halfedges[if at == 0 { halfedges.len() } else { at } - 1];
                let [a, b] = parts.departure(before ^ 1);
                direction_turn([b, a], parts.departure(halfedges[at])).is_gt()
            }
        }
    }
}

/// Writes rings with positions and sources.
struct Writer<'a> {
    overlay: &'a PlanarOverlay,
    parts: Parts<'a>,
    /// The vertex at each node that has one already.
    vertex_of_node: Vec<u32>,
    /// How many rings run through each node that rings run through.
    passes: Vec<u8>,
    positions: Vec<f64>,
    events: Vec<u32>,
    pinches: Vec<u32>,
    rings: Vec<u32>,
    starts: Vec<u32>,
    sides: Vec<u32>,
    other_sides: Vec<[u32; 2]>,
}

impl<'a> Writer<'a> {
    fn new(overlay: &'a PlanarOverlay, parts: Parts<'a>, rings: &[u32]) -> Self {
        let mut passes = vec![0u8; overlay.chains.nodes.len()];
        for &halfedge in rings {
            let passes = &mut passes[overlay.cells.tail(halfedge) as usize];
            *passes = passes.saturating_add(1);
        }
        let corner_counts =
            rings.iter().map(|&halfedge| parts.first_chain(halfedge / 2).corner_count as usize + 1);
        let corner_count: usize = corner_counts.sum();
        Self {
            overlay,
            parts,
            vertex_of_node: vec![NONE; overlay.chains.nodes.len()],
            passes,
            positions: Vec::with_capacity(2 * corner_count),
            events: Vec::with_capacity(corner_count),
            pinches: Vec::new(),
            rings: Vec::with_capacity(corner_count),
            starts: vec![0],
            sides: Vec::with_capacity(corner_count),
            other_sides: Vec::new(),
        }
    }

    fn write(&mut self, halfedges: &[u32]) {
        let count = halfedges.len();
        // Begin where an edge of the ring begins. Other sides run along chains without corners only.
        let has_corners = |i: usize| self.parts.first_chain(halfedges[i] / 2).corner_count > 0;
        let start =
            (0..count).find(|&i| self.is_kept(halfedges, i)).or_else(|| (0..count).find(|&i| has_corners(i)));
        let start = start.unwrap_or(0);
        for i in (start..count).chain(0..start) {
            let halfedge = halfedges[i];
            let chain = self.parts.first_chain(halfedge / 2);
            let is_along = halfedge.is_multiple_of(2);
            let departure = chain.sides[usize::from(!is_along)];
            if self.is_kept(halfedges, i) {
                self.push_node(self.overlay.cells.tail(halfedge));
                self.sides.push(departure);
            }
            // Where no edge of the ring begins, one goes on, and other sides may run along this part of it only.
            self.push_other_sides(halfedge);
            let corners = chain.corners(&self.overlay.rings);
            let points = &self.overlay.rings.soup.points;
            let first = self.events.len() as u32;
            if is_along {
                for range in corners {
                    let own = &points[range.start as usize..range.end as usize];
                    self.positions.extend_from_slice(own.as_flattened());
                    self.events.extend(range.clone());
                    self.sides.extend(range);
                }
            } else {
                let ring = chain.ring as usize;
                for range in corners.into_iter().rev() {
                    for corner in range.rev() {
                        self.positions.extend(points[corner as usize]);
                        self.events.push(corner);
                        self.sides.push(self.overlay.rings.side_before(corner, ring));
                    }
                }
            }
            self.rings.extend(first..self.events.len() as u32);
        }
        self.starts.push(self.rings.len() as u32);
    }

    /// Whether a ring has a vertex where one of its halfedges begins.
    fn is_kept(&self, halfedges: &[u32], i: usize) -> bool {
        let before = halfedges[if i == 0 { halfedges.len() } else { i } - 1];
        self.passes[self.overlay.cells.tail(halfedges[i]) as usize] > 1
            || !self.goes_straight_on(before, halfedges[i])
    }

    fn push_node(&mut self, node: u32) {
        let vertex = &mut self.vertex_of_node[node as usize];
        if *vertex == NONE {
            *vertex = self.events.len() as u32;
            let event = self.overlay.chains.nodes[node as usize];
            self.events.push(event);
            self.positions.extend(self.parts.event_point(event).rounded());
            if self.passes[node as usize] > 1 {
                self.pinches.push(*vertex);
            }
        }
        self.rings.push(*vertex);
    }

    /// Whether one side of the input runs along both halfedges.
    fn goes_straight_on(&self, before: u32, halfedge: u32) -> bool {
        let sides = |h: u32, is_end: bool| {
            let chains = self.overlay.cells.edges.chains.list(h as usize / 2);
            chains.iter().map(move |&chain| {
                let along = self.overlay.cells.edges.halfedge_of_chain[chain as usize] == h;
                self.overlay.chains.chains[chain as usize].sides[usize::from(is_end == along)]
            })
        };
        sides(before, true).any(|side| sides(halfedge, false).any(|other| other == side))
    }

    /// The sides along the start of a halfedge go with the last edge, if they do not yet.
    fn push_other_sides(&mut self, halfedge: u32) {
        // A ring that does not begin with an edge of its own begins on its last one, along one side.
        let begin = self.starts.last().map_or(0, |&start| start as usize);
        let Some((edge, &first)) = self.sides.iter().enumerate().skip(begin).next_back() else { return };
        for &chain in self.overlay.cells.edges.chains.list(halfedge as usize / 2) {
            let along = self.overlay.cells.edges.halfedge_of_chain[chain as usize] == halfedge;
            let side = self.overlay.chains.chains[chain as usize].sides[usize::from(!along)];
            if side != first {
                self.other_sides.push([edge as u32, side]);
            }
        }
    }

    fn finish(mut self, polygons: RaggedArray, has_exterior: bool) -> Result<PlanarPolygons<'a>, Error> {
        let places = &self.overlay.rings.places;
        self.sides.iter_mut().for_each(|side| *side = places[*side as usize]);
        self.other_sides.iter_mut().for_each(|[_, side]| *side = places[*side as usize]);
        self.other_sides.sort_unstable();
        self.other_sides.dedup();
        self.pinches.sort_unstable();
        Ok(PlanarPolygons {
            overlay: self.overlay,
            positions: Positions::from_flat(2, self.positions)?,
            rings: RaggedArray::from_parts(self.starts, self.rings)?,
            polygons,
            has_exterior,
            sides: self.sides,
            other_sides: self.other_sides,
            pinch_vertices: self.pinches,
            events: self.events,
        })
    }
}
