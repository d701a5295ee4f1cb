//! The rings around selected faces.

use super::regions::Parts;
use super::ring_cells::TracedRings;
use super::{PlanarOverlay, PlanarPolygons};
use crate::boolean::{BooleanFormula, InsideRule};
use crate::planar::faces::NONE;
use coface_algebra::Error;
use coface_algebra::RaggedArray;
use coface_geometry::Positions;
use coface_geometry::predicates::{PlanarPoint, direction_turn};
use rayon::prelude::*;

impl PlanarOverlay {
    /// The polygons of the faces whose winding numbers satisfy a Boolean formula of the regions; regions that are not
    /// there have nothing inside.
    ///
    /// # Errors
    /// As [`Self::select`].
    ///
    /// # Complexity
    /// As [`Self::select`], times the length of the formula.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::boolean::{BooleanFormula, InsideRule};
    /// use coface_arrange::planar::PlanarOverlay;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two squares that overlap in a quarter.
    /// let points = Positions::from_flat(2, vec![0., 0., 2., 0., 2., 2., 0., 2., 1., 1., 3., 1., 3., 3., 1., 3.])?;
    /// let rings = RaggedArray::from_lists([[0, 1, 2, 3], [4, 5, 6, 7]]);
    /// let overlay = PlanarOverlay::new(&points, &rings, &[0, 1])?;
    /// let union = BooleanFormula::parse("a | b", &[])?;
    /// assert_eq!(overlay.boolean(&union, InsideRule::Nonzero)?.area(), 7.0);
    /// # Ok(()) }
    /// ```
    pub fn boolean(&self, formula: &BooleanFormula, rule: InsideRule) -> Result<PlanarPolygons<'_>, Error> {
        self.select(|windings| {
            formula.evaluate(|input| {
                let found = windings.binary_search_by_key(&(input as u32), |&(region, _)| region);
                found.is_ok_and(|at| rule.is_inside(windings[at].1))
            })
        })
    }

    /// The polygons of the faces whose winding numbers satisfy a condition: for each face it gets the regions with a
    /// winding number that is not zero, rising, with that number; for the unbounded face the empty list.
    ///
    /// Faces with an edge in common are one polygon; edges with the selection on both sides are left out, and so are
    /// crossings at which a ring goes straight on.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`](coface_algebra::ErrorKind::TooLarge) beyond 2^32 vertices.
    ///
    /// # Complexity
    /// Linear in the nodes, edges and faces, and in what comes out.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_arrange::planar::PlanarOverlay;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two squares that overlap in a quarter.
    /// let points = Positions::from_flat(2, vec![0., 0., 2., 0., 2., 2., 0., 2., 1., 1., 3., 1., 3., 3., 1., 3.])?;
    /// let rings = RaggedArray::from_lists([[0, 1, 2, 3], [4, 5, 6, 7]]);
    /// let overlay = PlanarOverlay::new(&points, &rings, &[0, 1])?;
    /// assert_eq!(overlay.select(|windings| windings.len() == 2)?.area(), 1.0);
    /// # Ok(()) }
    /// ```
    pub fn select(&self, condition: impl Fn(&[(u32, i32)]) -> bool) -> Result<PlanarPolygons<'_>, Error> {
        self.outline(&self.cells.faces_where(condition), false)
    }

    /// The same, and the smallest ring around each ring, if there is one.
    ///
    /// # Errors
    /// As [`Self::select`].
    #[doc(hidden)]
    pub fn select_nested(
        &self,
        condition: impl Fn(&[(u32, i32)]) -> bool,
    ) -> Result<(PlanarPolygons<'_>, Vec<Option<u32>>), Error> {
        let mut traced = self.trace(&self.cells.faces_where(condition), false);
        let polygon_of_face = std::mem::take(&mut traced.polygon_of_face);
        let (polygons, parents) = rayon::join(
            || self.write(&traced, polygon_of_face),
            || self.cells.parents_in_order(&traced.halfedges, &traced.starts, traced.by_polygon.items()),
        );
        Ok((polygons?, parents))
    }

    /// The polygons of faces, of which the unbounded one is the last. With shared edges kept, each face is a polygon by
    /// itself.
    ///
    /// # Errors
    /// As [`Self::select`].
    #[doc(hidden)]
    pub fn outline(&self, is_inside: &[bool], walls: bool) -> Result<PlanarPolygons<'_>, Error> {
        let mut traced = self.trace(is_inside, walls);
        let polygon_of_face = std::mem::take(&mut traced.polygon_of_face);
        self.write(&traced, polygon_of_face)
    }

    fn trace(&self, is_inside: &[bool], walls: bool) -> TracedRings {
        let parts = self.parts();
        self.cells.trace_with(is_inside, walls, |halfedges| self.is_counterclockwise(&parts, halfedges))
    }

    /// The polygons along traced rings, given the polygon of each bounded face.
    fn write(&self, traced: &TracedRings, polygon_of_face: Vec<u32>) -> Result<PlanarPolygons<'_>, Error> {
        let TracedRings { halfedges, starts, by_polygon, has_exterior, .. } = traced;
        // Rings are written polygon after polygon.
        let mut writer = Writer::new(self, halfedges);
        let passages = writer.passages(halfedges, starts);
        for &ring in by_polygon.items() {
            let own = starts[ring as usize]..starts[ring as usize + 1];
            writer.write(&halfedges[own.clone()], &passages[own]);
        }
        drop(passages);
        let mut ring_numbers = 0u32..;
        let polygons = RaggedArray::from_lists(
            by_polygon.iter().map(|list| ring_numbers.by_ref().take(list.len()).collect::<Vec<_>>()),
        );
        writer.finish(polygons, polygon_of_face, *has_exterior)
    }

    /// Whether a simple ring runs counterclockwise: it does at its lowest point.
    fn is_counterclockwise(&self, parts: &Parts<'_>, halfedges: &[u32]) -> bool {
        let tail = |at: usize| self.cells.tail(halfedges[at]);
        let lowest_node = (0..halfedges.len()).min_by(|&a, &b| parts.compare_nodes(tail(a), tail(b)));
        let Some(at_node) = lowest_node else { return false };
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

/// What a ring makes of one of its halfedges.
#[derive(Clone, Copy)]
struct Passage {
    /// The side along which the halfedge leaves its node.
    departure: u32,
    corner_count: u32,
    /// Whether the ring has a vertex where the halfedge begins.
    is_kept: bool,
}

/// Writes rings with positions and sources.
struct Writer<'a> {
    overlay: &'a PlanarOverlay,
    parts: Parts<'a>,
    /// The vertex at each node that has one already.
    vertex_of_node: Vec<u32>,
    /// How many edges of the boundary end at each node.
    degrees: Vec<u8>,
    /// For each edge that has been written the vertex at its first corner, if there are walls: these are written twice.
    first_corners: Vec<u32>,
    positions: Vec<f64>,
    events: Vec<u32>,
    pinches: Vec<u32>,
    rings: Vec<u32>,
    starts: Vec<u32>,
    sides: Vec<u32>,
    other_sides: Vec<[u32; 2]>,
}

impl<'a> Writer<'a> {
    fn new(overlay: &'a PlanarOverlay, halfedges: &[u32]) -> Self {
        let parts = overlay.parts();
        let edge_count = overlay.cells.edges.ends.len();
        let mut degrees = vec![0u8; overlay.chains.nodes.len()];
        let mut is_known = vec![false; edge_count];
        let corner_counts = halfedges.par_iter().with_min_len(1 << 12);
        let corner_count = corner_counts
            .map(|&halfedge| parts.first_chain(halfedge / 2).corner_count as usize + 1)
            .sum::<usize>();
        let mut has_walls = false;
        for edge in halfedges.iter().map(|halfedge| halfedge / 2) {
            // An edge with polygons on both sides counts once.
            if std::mem::replace(&mut is_known[edge as usize], true) {
                has_walls = true;
                continue;
            }
            for &end in &overlay.cells.edges.ends[edge as usize] {
                degrees[end as usize] = degrees[end as usize].saturating_add(1);
            }
        }
        Self {
            overlay,
            parts,
            first_corners: vec![NONE; if has_walls { edge_count } else { 0 }],
            vertex_of_node: vec![NONE; overlay.chains.nodes.len()],
            degrees,
            positions: Vec::with_capacity(2 * corner_count),
            events: Vec::with_capacity(corner_count),
            pinches: Vec::new(),
            rings: Vec::with_capacity(corner_count),
            starts: vec![0],
            sides: Vec::with_capacity(corner_count),
            other_sides: Vec::new(),
        }
    }

    /// What the halfedges of rings are to them.
    fn passages(&self, halfedges: &[u32], starts: &[usize]) -> Vec<Passage> {
        let positions = (0..halfedges.len()).into_par_iter().with_min_len(1 << 12);
        positions
            .map_init(
                || 0,
                |ring, at| {
                    // Mostly the same ring as before, or the next.
                    let is_on = |ring: usize| starts[ring] <= at && at < starts[ring + 1];
                    if !is_on(*ring) {
                        *ring = match *ring + 1 {
                            next if next + 1 < starts.len() && is_on(next) => next,
                            _ => starts.partition_point(|&start| start <= at) - 1,
                        };
                    }
                    let before = halfedges[if at == starts[*ring] { starts[*ring + 1] } else { at } - 1];
                    let halfedge = halfedges[at];
                    let chain = self.parts.first_chain(halfedge / 2);
                    Passage {
                        departure: chain.sides[usize::from(!halfedge.is_multiple_of(2))],
                        corner_count: chain.corner_count,
                        is_kept: self.degrees[self.overlay.cells.tail(halfedge) as usize] != 2
                            || !self.goes_straight_on(before, halfedge),
                    }
                },
            )
            .collect()
    }

    fn write(&mut self, halfedges: &[u32], passages: &[Passage]) {
        let count = halfedges.len();
        // Begin where an edge of the ring begins. Other sides run along chains without corners only.
        let start = passages.iter().position(|own| own.is_kept);
        let start = start.or_else(|| passages.iter().position(|own| own.corner_count > 0)).unwrap_or(0);
        for i in (start..count).chain(0..start) {
            let (halfedge, own) = (halfedges[i], passages[i]);
            if own.is_kept {
                self.push_node(self.overlay.cells.tail(halfedge));
                self.sides.push(own.departure);
            }
            // Where no edge of the ring begins, one goes on, and other sides may run along this part of it only.
            if !own.is_kept || self.overlay.cells.edges.chains.list(halfedge as usize / 2).len() > 1 {
                self.push_other_sides(halfedge);
            }
            if own.corner_count > 0 {
                self.push_corners(halfedge);
            }
        }
        self.starts.push(self.rings.len() as u32);
    }

    /// The corners within an edge, with the sides that go on from them. What is a wall is written again with the same
    /// vertices.
    fn push_corners(&mut self, halfedge: u32) {
        let rings = &self.overlay.rings;
        let chain = self.parts.first_chain(halfedge / 2);
        let corners = chain.corners(rings);
        let written = self.first_corners.get(halfedge as usize / 2).copied().filter(|&first| first != NONE);
        let first = written.unwrap_or(self.events.len() as u32);
        if written.is_none() {
            for range in corners.clone() {
                let own = &rings.soup.points[range.start as usize..range.end as usize];
                self.positions.extend_from_slice(own.as_flattened());
                self.events.extend(range);
            }
            if let Some(own) = self.first_corners.get_mut(halfedge as usize / 2) {
                *own = first;
            }
        }
        let vertices = first..first + chain.corner_count;
        if halfedge.is_multiple_of(2) {
            self.sides.extend(corners.into_iter().flatten());
            self.rings.extend(vertices);
        } else {
            let before = |corner| rings.side_before(corner, chain.ring as usize);
            self.sides.extend(corners.into_iter().rev().flat_map(|range| range.rev().map(before)));
            self.rings.extend(vertices.rev());
        }
    }

    fn push_node(&mut self, node: u32) {
        let vertex = &mut self.vertex_of_node[node as usize];
        if *vertex == NONE {
            *vertex = self.events.len() as u32;
            let event = self.overlay.chains.nodes[node as usize];
            self.events.push(event);
            self.positions.extend(self.parts.rounded_node(node));
            if self.degrees[node as usize] > 2 {
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
                self.parts.end_side(chain, is_end == along)
            })
        };
        sides(before, true)
            .filter(|&side| !self.overlay.is_chord(side))
            .any(|side| sides(halfedge, false).any(|other| other == side))
    }

    /// The sides along the start of a halfedge go with the last edge, if they do not yet.
    fn push_other_sides(&mut self, halfedge: u32) {
        // A ring that does not begin with an edge of its own begins on its last one, along one side.
        let begin = self.starts.last().map_or(0, |&start| start as usize);
        let Some((edge, &first)) = self.sides.iter().enumerate().skip(begin).next_back() else { return };
        for &chain in self.overlay.cells.edges.chains.list(halfedge as usize / 2) {
            let along = self.overlay.cells.edges.halfedge_of_chain[chain as usize] == halfedge;
            let side = self.parts.end_side(chain, !along);
            if side != first {
                self.other_sides.push([edge as u32, side]);
            }
        }
    }

    fn finish(
        mut self,
        polygons: RaggedArray,
        polygon_of_face: Vec<u32>,
        has_exterior: bool,
    ) -> Result<PlanarPolygons<'a>, Error> {
        let places = &self.overlay.rings.places;
        self.sides.par_iter_mut().with_min_len(1 << 12).for_each(|side| *side = places[*side as usize]);
        self.other_sides.iter_mut().for_each(|[_, side]| *side = places[*side as usize]);
        self.other_sides.par_sort_unstable();
        self.other_sides.dedup();
        let mut other_starts = Vec::new();
        if !self.other_sides.is_empty() {
            other_starts.reserve_exact(self.sides.len() + 1);
            let mut at = 0;
            for edge in 0..=self.sides.len() as u32 {
                while self.other_sides.get(at).is_some_and(|pair| pair[0] < edge) {
                    at += 1;
                }
                other_starts.push(at as u32);
            }
        }
        self.pinches.sort_unstable();
        Ok(PlanarPolygons {
            overlay: self.overlay,
            positions: Positions::from_flat(2, self.positions)?,
            rings: RaggedArray::from_parts(self.starts, self.rings)?,
            polygons,
            polygon_of_face,
            has_exterior,
            sides: self.sides,
            other_sides: self.other_sides.into_iter().map(|pair| pair[1]).collect(),
            other_starts,
            pinch_vertices: self.pinches,
            events: self.events,
        })
    }
}
