//! What is wrong with polygons as they are drawn, fault by fault.

use super::PlanarArrangement;
use super::tour::Step;
use coface_algebra::{EdgeId, Error, RaggedArray, UnionFind, VertexId};
use coface_geometry::Positions;
use std::collections::{BTreeMap, BTreeSet};

/// What sort of fault a ring or polygon has.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum PolygonFaultKind {
    /// A ring has fewer than three different points.
    TooFewPoints,
    /// Sides of a ring cross, or a ring runs along itself in one direction.
    RingCrossesItself,
    /// A ring runs back along itself.
    Spike,
    /// A ring comes to a point twice.
    RingTouchesItself,
    /// Two rings of a polygon cross.
    RingsCross,
    /// Two rings of a polygon have a part of a side in common.
    RingsOverlap,
    /// Two rings of a polygon, or two polygons, have the same boundary.
    DuplicateRing,
    /// A hole is not inside of the outer ring of its polygon.
    HoleOutside,
    /// A hole is inside of another hole of its polygon.
    HolesNested,
    /// Rings that touch each other cut the inside of a polygon into pieces.
    InteriorDisconnected,
    /// Rings of two polygons cross.
    PolygonsCross,
    /// Rings of two polygons have a part of a side in common.
    PolygonsOverlap,
    /// A polygon is inside of another one.
    PolygonsNested,
}

impl PolygonFaultKind {
    /// All kinds, in the order of their numbers.
    pub const ALL: [Self; 13] = [
        Self::TooFewPoints,
        Self::RingCrossesItself,
        Self::Spike,
        Self::RingTouchesItself,
        Self::RingsCross,
        Self::RingsOverlap,
        Self::DuplicateRing,
        Self::HoleOutside,
        Self::HolesNested,
        Self::InteriorDisconnected,
        Self::PolygonsCross,
        Self::PolygonsOverlap,
        Self::PolygonsNested,
    ];

    /// The word for it.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::planar::PolygonFaultKind;
    /// assert_eq!(PolygonFaultKind::HoleOutside.name(), "hole_outside");
    /// ```
    pub fn name(self) -> &'static str {
        match self {
            Self::TooFewPoints => "too_few_points",
            Self::RingCrossesItself => "ring_crosses_itself",
            Self::Spike => "spike",
            Self::RingTouchesItself => "ring_touches_itself",
            Self::RingsCross => "rings_cross",
            Self::RingsOverlap => "rings_overlap",
            Self::DuplicateRing => "duplicate_ring",
            Self::HoleOutside => "hole_outside",
            Self::HolesNested => "holes_nested",
            Self::InteriorDisconnected => "interior_disconnected",
            Self::PolygonsCross => "polygons_cross",
            Self::PolygonsOverlap => "polygons_overlap",
            Self::PolygonsNested => "polygons_nested",
        }
    }

    /// What programs that follow OGC's *Simple feature access* call it, as in `ST_IsValidReason`.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::planar::PolygonFaultKind;
    /// assert_eq!(PolygonFaultKind::Spike.reason(), "Self-intersection");
    /// ```
    pub fn reason(self) -> &'static str {
        match self {
            Self::TooFewPoints => "Too few points in geometry component",
            Self::RingCrossesItself
            | Self::Spike
            | Self::RingsCross
            | Self::RingsOverlap
            | Self::DuplicateRing
            | Self::PolygonsCross
            | Self::PolygonsOverlap => "Self-intersection",
            Self::RingTouchesItself => "Ring Self-intersection",
            Self::HoleOutside => "Hole lies outside shell",
            Self::HolesNested => "Holes are nested",
            Self::InteriorDisconnected => "Interior is disconnected",
            Self::PolygonsNested => "Nested shells",
        }
    }
}

/// A fault with its place.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct PolygonFault {
    /// What is wrong.
    pub kind: PolygonFaultKind,
    /// A point of the place, rounded.
    pub point: [f64; 2],
    /// The ring, or the two rings, that have it.
    pub rings: Vec<u32>,
}

/// What is wrong with polygons as one multipolygon, exactly, as OGC's *Simple feature access* says: nothing if they are
/// valid.
///
/// `rings` run through their vertices and back to the first, in any direction; `polygons` have the numbers of their
/// rings, the outer one first. Of what two rings do to each other several times, each place is a fault where they
/// cross; where they overlap, one place is.
///
/// # Errors
/// As [`PlanarArrangement::new`].
///
/// # Complexity
/// That of an arrangement of the sides, and linear in the rings around each ring.
///
/// # References
/// ISO 19125-1 (2004), *Simple feature access*, 6.1.11 and 6.1.14.
///
/// # Examples
/// A bow tie.
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_arrange::planar::{PolygonFaultKind, polygon_faults};
/// use coface_geometry::Positions;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let corners = Positions::from_flat(2, vec![0., 0., 2., 2., 2., 0., 0., 2.])?;
/// let rings = RaggedArray::from_lists([[0, 1, 2, 3]]);
/// let faults = polygon_faults(&corners, &rings, &RaggedArray::from_lists([[0]]))?;
/// assert_eq!((faults[0].kind, faults[0].point), (PolygonFaultKind::RingCrossesItself, [1.0, 1.0]));
/// # Ok(()) }
/// ```
pub fn polygon_faults(
    positions: &Positions,
    rings: &RaggedArray,
    polygons: &RaggedArray,
) -> Result<Vec<PolygonFault>, Error> {
    let mut search = FaultSearch::new(positions, rings, polygons)?;
    search.overlaps();
    search.meetings();
    search.pieces();
    search.nesting();
    let mut faults = search.faults;
    faults.sort_by(|a, b| {
        (a.kind, &a.rings)
            .cmp(&(b.kind, &b.rings))
            .then_with(|| a.point[0].total_cmp(&b.point[0]).then_with(|| a.point[1].total_cmp(&b.point[1])))
    });
    Ok(faults)
}

/// A ring that comes through a vertex: along these edges, as halfedges that leave it.
#[derive(Clone, Copy)]
struct Passage {
    ring: u32,
    halfedges: [u32; 2],
}

struct FaultSearch {
    arrangement: PlanarArrangement,
    /// The ring and the direction of each segment: whether it rises.
    segments: Vec<(u32, bool)>,
    /// The polygon of each ring, and whether it is a hole.
    of_ring: Vec<(u32, bool)>,
    /// The rings of each polygon.
    polygons: RaggedArray,
    /// The halfedges along each ring in order.
    walks: RaggedArray,
    faults: Vec<PolygonFault>,
    /// Pairs of rings that cross or overlap: how they nest is not looked at.
    entangled: BTreeSet<[u32; 2]>,
    /// The vertices at which rings of each polygon touch.
    touches: Vec<(u32, u32, Vec<u32>)>,
}

impl FaultSearch {
    fn new(positions: &Positions, rings: &RaggedArray, polygons: &RaggedArray) -> Result<Self, Error> {
        let flat = positions.as_flat().as_chunks::<2>().0;
        let place = |vertex: u32| flat[vertex as usize].map(|x| x + 0.0);
        let mut of_ring = vec![(0, false); rings.len()];
        for (polygon, own) in (0..).zip(polygons.iter()) {
            own.iter().enumerate().for_each(|(i, &ring)| of_ring[ring as usize] = (polygon, i > 0));
        }
        let mut faults = Vec::new();
        let (mut ends, mut segments, mut starts) = (Vec::new(), Vec::new(), vec![0]);
        for (number, ring) in (0u32..).zip(rings.iter()) {
            let mut places: Vec<[u64; 2]> =
                ring.iter().map(|&vertex| place(vertex).map(f64::to_bits)).collect();
            places.sort_unstable();
            places.dedup();
            if places.len() < 3 {
                let point = ring.first().map_or([f64::NAN; 2], |&vertex| place(vertex));
                faults.push(PolygonFault {
                    kind: PolygonFaultKind::TooFewPoints,
                    point,
                    rings: vec![number],
                });
            } else {
                for (i, &from) in ring.iter().enumerate() {
                    let to = ring[if i + 1 == ring.len() { 0 } else { i + 1 }];
                    let [a, b] = [from, to].map(place);
                    if a != b {
                        ends.push([from, to]);
                        segments.push((number, (a[0], a[1]) < (b[0], b[1])));
                    }
                }
            }
            starts.push(segments.len());
        }
        let arrangement = PlanarArrangement::new(positions, &ends)?;
        let mut walks = RaggedArray::new();
        let mut walk = Vec::new();
        for own in starts.windows(2) {
            walk.clear();
            for (segment, &(_, rises)) in (own[0]..own[1]).zip(&segments[own[0]..own[1]]) {
                let edges = arrangement.edges_of_segment.list(segment);
                if rises {
                    walk.extend(edges.iter().map(|edge| 2 * edge));
                } else {
                    walk.extend(edges.iter().rev().map(|edge| 2 * edge + 1));
                }
            }
            walks.push(&walk);
        }
        Ok(Self {
            arrangement,
            segments,
            of_ring,
            polygons: polygons.clone(),
            walks,
            faults,
            entangled: BTreeSet::new(),
            touches: Vec::new(),
        })
    }

    fn add(&mut self, kind: PolygonFaultKind, vertex: u32, rings: &[u32]) {
        let point = self.arrangement.positions.point(VertexId::from_u32(vertex));
        self.faults.push(PolygonFault { kind, point: [point[0], point[1]], rings: rings.to_vec() });
    }

    fn polygon(&self, ring: u32) -> u32 {
        self.of_ring[ring as usize].0
    }

    /// Edges that several sides run along.
    fn overlaps(&mut self) {
        use PolygonFaultKind::{DuplicateRing, PolygonsOverlap, RingCrossesItself, RingsOverlap, Spike};
        // Of each pair of rings, or ring with itself, the first edge and how many there are.
        let mut shared: BTreeMap<(PolygonFaultKind, [u32; 2]), (u32, usize)> = BTreeMap::new();
        for (edge, segments) in
            self.arrangement.segments_of_edge.iter().enumerate().filter(|(_, s)| s.len() > 1)
        {
            let mut sides: Vec<(u32, bool)> = segments.iter().map(|&s| self.segments[s as usize]).collect();
            sides.sort_unstable();
            for (i, &(ring, way)) in sides.iter().enumerate() {
                // Of many rings each is compared with the one before it.
                let Some(&(other, other_way)) = i.checked_sub(1).and_then(|i| sides.get(i)) else { continue };
                let kind = match (ring == other, self.polygon(ring) == self.polygon(other)) {
                    (true, _) if way != other_way => Spike,
                    (true, _) => RingCrossesItself,
                    (_, true) => RingsOverlap,
                    _ => PolygonsOverlap,
                };
                shared.entry((kind, [other, ring])).or_insert((edge as u32, 0)).1 += 1;
            }
        }
        for ((kind, rings), (edge, count)) in shared {
            let [low, _] = self.arrangement.ends(EdgeId::from_u32(edge)).map(VertexId::to_u32);
            self.entangled.insert(rings);
            let is_same = kind != Spike
                && rings[0] != rings[1]
                && rings.iter().all(|&ring| self.walks.list(ring as usize).len() == count);
            let kind = if is_same { DuplicateRing } else { kind };
            let list = if rings[0] == rings[1] { &rings[..1] } else { &rings[..] };
            self.add(kind, low, list);
        }
    }

    /// Vertices that rings come through more than once.
    fn meetings(&mut self) {
        let is_shared =
            |halfedge: u32| self.arrangement.segments_of_edge.list(halfedge as usize / 2).len() > 1;
        let mut passages: Vec<(u32, Passage)> = Vec::new();
        for (ring, walk) in (0..).zip(self.walks.iter()) {
            for (i, &halfedge) in walk.iter().enumerate() {
                let next = walk[if i + 1 == walk.len() { 0 } else { i + 1 }];
                let vertex = self.arrangement.tail(next);
                if self.arrangement.orbits.rotation.list(vertex as usize).len() > 2 {
                    passages.push((vertex, Passage { ring, halfedges: [halfedge ^ 1, next] }));
                }
            }
        }
        passages.sort_unstable_by_key(|(vertex, passage)| (*vertex, passage.ring));
        let mut found = Vec::new();
        for group in passages.chunk_by(|a, b| a.0 == b.0) {
            let own: Vec<Passage> = (group.iter().map(|(_, passage)| *passage))
                .filter(|passage| !passage.halfedges.iter().any(|&halfedge| is_shared(halfedge)))
                .collect();
            found.push((group[0].0, self.crossings(group[0].0, &own), own));
        }
        for (vertex, crossings, passages) in found {
            use PolygonFaultKind::{PolygonsCross, RingCrossesItself, RingTouchesItself, RingsCross};
            let mut told = BTreeSet::new();
            for pair in crossings {
                let [a, b] = [pair[0].min(pair[1]), pair[0].max(pair[1])];
                self.entangled.insert([a, b]);
                if !told.insert([a, b]) {
                    continue;
                }
                match (a == b, self.polygon(a) == self.polygon(b)) {
                    (true, _) => self.add(RingCrossesItself, vertex, &[a]),
                    (_, true) => self.add(RingsCross, vertex, &[a, b]),
                    _ => self.add(PolygonsCross, vertex, &[a, b]),
                }
            }
            for own in passages.chunk_by(|a, b| a.ring == b.ring) {
                let ring = own[0].ring;
                if own.len() > 1 && !told.contains(&[ring, ring]) {
                    self.add(RingTouchesItself, vertex, &[ring]);
                }
            }
            let mut by_polygon: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
            for own in passages.chunk_by(|a, b| a.ring == b.ring) {
                by_polygon.entry(self.polygon(own[0].ring)).or_default().push(own[0].ring);
            }
            let several = by_polygon.into_iter().filter(|(_, rings)| rings.len() > 1);
            self.touches.extend(several.map(|(polygon, rings)| (polygon, vertex, rings)));
        }
    }

    /// Pairs of rings that cross at a vertex. Of several that cross there some are found, at least one.
    fn crossings(&self, vertex: u32, passages: &[Passage]) -> Vec<[u32; 2]> {
        let mut of_halfedge: BTreeMap<u32, usize> = BTreeMap::new();
        for (i, passage) in passages.iter().enumerate() {
            of_halfedge.extend(passage.halfedges.map(|halfedge| (halfedge, i)));
        }
        // Around the vertex, passages that do not cross begin and end like parentheses.
        let (mut open, mut found) = (Vec::new(), Vec::new());
        for halfedge in self.arrangement.orbits.rotation.list(vertex as usize) {
            let Some(&passage) = of_halfedge.get(halfedge) else { continue };
            match open.iter().rposition(|&other| other == passage) {
                Some(place) => {
                    for &other in &open[place + 1..] {
                        found.push([passage, other].map(|i: usize| passages[i].ring));
                    }
                    open.remove(place);
                }
                None => open.push(passage),
            }
        }
        found
    }

    /// Polygons whose rings make a circle by touching each other.
    fn pieces(&mut self) {
        let mut touches = std::mem::take(&mut self.touches);
        touches.sort_by_key(|(polygon, vertex, _)| (*polygon, *vertex));
        let (mut faults, mut number_of) = (Vec::new(), BTreeMap::new());
        for own in touches.chunk_by(|a, b| a.0 == b.0) {
            number_of.clear();
            let rings = self.polygons.list(own[0].0 as usize);
            number_of.extend(rings.iter().copied().zip(0u32..));
            let mut parts = UnionFind::new(rings.len() + own.len());
            for (place, (_, vertex, touching)) in (rings.len() as u32..).zip(own) {
                let is_tangled = touching
                    .iter()
                    .any(|&a| touching.iter().any(|&b| a <= b && self.entangled.contains(&[a, b])));
                let joins = touching.iter().filter(|&ring| !parts.unite(place, number_of[ring])).count();
                if joins > 0 && !is_tangled {
                    faults.push((*vertex, touching.clone()));
                    break;
                }
            }
        }
        for (vertex, rings) in faults {
            self.add(PolygonFaultKind::InteriorDisconnected, vertex, &rings);
        }
    }

    /// How rings lie in each other.
    fn nesting(&mut self) {
        use PolygonFaultKind::{HoleOutside, HolesNested, PolygonsNested};
        let arrangement = &self.arrangement;
        let mut windings = vec![0i32; self.of_ring.len()];
        let mut is_known = vec![false; self.of_ring.len()];
        let mut around: Vec<u32> = Vec::new();
        let mut found: Vec<(PolygonFaultKind, u32, Vec<u32>)> = Vec::new();
        let mut cross = |across: u32, around: &mut Vec<u32>, new: &mut Vec<u32>| {
            for &segment in arrangement.segments_of_edge.list(across as usize / 2) {
                let (ring, rises) = self.segments[segment as usize];
                let winding = &mut windings[ring as usize];
                let was_in = *winding != 0;
                *winding += if rises == across.is_multiple_of(2) { 1 } else { -1 };
                match (was_in, *winding != 0) {
                    (false, true) => {
                        around.push(ring);
                        new.push(ring);
                    }
                    (true, false) => around.retain(|&other| other != ring),
                    _ => {}
                }
            }
        };
        let is_tangled = |a: u32, b: u32| self.entangled.contains(&[a.min(b), a.max(b)]);
        let mut new = Vec::new();
        arrangement.tour(|step| match step {
            Step::Into { across, .. } => {
                new.clear();
                cross(across, &mut around, &mut new);
                for &ring in &new {
                    if std::mem::replace(&mut is_known[ring as usize], true) {
                        continue;
                    }
                    let vertex = arrangement.tail(across);
                    let (polygon, is_hole) = self.of_ring[ring as usize];
                    let shell = self.polygons.list(polygon as usize)[0];
                    if is_hole {
                        if !around.contains(&shell) && !is_tangled(ring, shell) {
                            found.push((HoleOutside, vertex, vec![ring]));
                        }
                        let others = around.iter().filter(|&&other| {
                            other != ring
                                && self.of_ring[other as usize] == (polygon, true)
                                && !is_tangled(ring, other)
                        });
                        found.extend(others.map(|&other| (HolesNested, vertex, vec![ring, other])));
                        continue;
                    }
                    for &other in around.iter().filter(|&&other| other != ring) {
                        let (outer, is_hole) = self.of_ring[other as usize];
                        let is_in_hole = |hole: &u32| self.of_ring[*hole as usize] == (outer, true);
                        if outer != polygon
                            && !is_hole
                            && !around.iter().any(is_in_hole)
                            && !is_tangled(ring, other)
                        {
                            found.push((PolygonsNested, vertex, vec![ring, other]));
                        }
                    }
                }
            }
            Step::Back { across, .. } => cross(across, &mut around, &mut new),
        });
        for (kind, vertex, rings) in found {
            self.add(kind, vertex, &rings);
        }
    }
}
