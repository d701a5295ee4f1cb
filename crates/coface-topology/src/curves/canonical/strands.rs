//! Strands: disjoint curves from a base that cross edges, drawn through a disk that faces make.

use super::refinement::{Mark, Refinement, Segment};
use coface_algebra::{EdgeId, FaceId, HalfedgeId, RaggedArray, Sign, VertexId};
use coface_complexes::surface::GeneralizedMap;

const NONE: u32 = u32::MAX;

/// A vertex with the faces around it, from where strands go out.
#[derive(Clone, Debug)]
pub(super) struct Root {
    pub(super) vertex: VertexId,
    /// The two sides at the vertex of each face around it, counterclockwise.
    pub(super) corners: Vec<[HalfedgeId; 2]>,
}

impl Root {
    /// The root at a vertex, if no face or edge is twice around it.
    pub(super) fn new(map: &GeneralizedMap, flag: u32) -> Option<Self> {
        let vertex = map.flag_vertex(flag);
        let corners: Vec<[HalfedgeId; 2]> = map
            .fan(flag)
            .chunks_exact(2)
            .map(|pair| [pair[0], pair[1]].map(|f| HalfedgeId::from_u32(f >> 1)))
            .collect();
        let mut faces: Vec<FaceId> = corners.iter().map(|corner| map.face(corner[0])).collect();
        faces.sort_unstable();
        let is_single = faces.windows(2).all(|pair| pair[0] != pair[1]);
        let is_loop = |side: HalfedgeId| map.source(side) == map.target(side);
        (is_single && !corners.iter().flatten().any(|&side| is_loop(side)))
            .then_some(Self { vertex, corners })
    }

    /// Whether faces are all around it.
    pub(super) fn is_inside(&self, map: &GeneralizedMap) -> bool {
        let [first, last] = [self.corners[0][0], self.corners[self.corners.len() - 1][1]];
        map.edge(first) == map.edge(last) && map.mate(first).is_some()
    }

    /// The corners around the first edge, as far as the next barriers.
    pub(super) fn wedge(mut self, map: &GeneralizedMap, walls: &[bool]) -> Self {
        let is_wall = |corner: &[HalfedgeId; 2]| walls[map.edge(corner[0]).index()];
        // Where walls stand before corners.
        let first = self.corners.iter().position(is_wall);
        let last = self.corners.iter().rposition(is_wall);
        if let (Some(first), Some(last)) = (first, last) {
            let mut corners = self.corners.split_off(last);
            corners.extend_from_slice(&self.corners[..first]);
            self.corners = corners;
        }
        self
    }

    /// Whether its faces have the direction in which the corners are counterclockwise.
    fn sign(&self, map: &GeneralizedMap, corner: usize) -> Sign {
        let [first, last] = self.corners[corner];
        // Of a face with two sides the order of the rim decides.
        let is_outgoing = map.source(first) == self.vertex && map.next(last) == first;
        if is_outgoing { Sign::Plus } else { Sign::Minus }
    }

    /// The corner of a face, as a mark.
    fn mark(&self, map: &GeneralizedMap, corner: usize) -> Mark {
        let [first, last] = self.corners[corner];
        let side = if self.sign(map, corner) == Sign::Plus { first } else { last };
        Mark { side, point: self.vertex.to_u32() }
    }
}

/// The faces around roots with all faces that can be reached from there, glued to disks along the edges of spanning trees.
///
/// The edges at a root are crossed by no tree; the faces around it make one disk with it inside.
#[derive(Debug)]
pub(super) struct Disks<'m> {
    map: &'m GeneralizedMap,
    roots: Vec<Root>,
    /// The side by which each face is reached.
    entries: Vec<u32>,
    signs: Vec<Sign>,
    pub(super) depths: Vec<u32>,
    /// The faces that are reached, nearer ones first, without those at roots.
    order: Vec<FaceId>,
}

/// Strands as they cross edges.
#[derive(Debug, Default)]
pub(super) struct Crossings {
    /// The points on edges at the rim of the disks, from the start of each edge to its end: the edge, then points.
    pub(super) points: Vec<(EdgeId, Vec<u32>)>,
    /// For each point the strand that ends there in the face of the first side of the edge, and in that of the other.
    pub(super) strands: Vec<[u32; 2]>,
    /// The number of strands. Those that end at a root once are spokes.
    pub(super) strand_count: usize,
}

/// Strands drawn.
#[derive(Debug)]
pub(super) struct Drawn {
    pub(super) refinement: Refinement,
    /// For each point the steps away from it along strands.
    steps: Vec<[u32; 2]>,
    /// For each strand that goes out from a root the step out.
    spokes: Vec<u32>,
}

impl<'m> Disks<'m> {
    /// Breadth-first from all faces at the roots, not across barriers.
    pub(super) fn new(map: &'m GeneralizedMap, roots: Vec<Root>, walls: &[bool]) -> Self {
        let count = map.face_count();
        let mut disks = Self {
            map,
            roots: Vec::new(),
            entries: vec![NONE; count],
            signs: vec![Sign::Plus; count],
            depths: vec![NONE; count],
            order: Vec::new(),
        };
        let mut queue: Vec<FaceId> = Vec::new();
        for root in &roots {
            for (i, corner) in root.corners.iter().enumerate() {
                let face = map.face(corner[0]);
                disks.signs[face.index()] = root.sign(map, i);
                disks.depths[face.index()] = 0;
                queue.push(face);
            }
        }
        let at_roots = queue.len();
        let rims: Vec<[HalfedgeId; 2]> = roots.iter().flat_map(|root| root.corners.iter().copied()).collect();
        let mut at = 0;
        while at < queue.len() {
            let face = queue[at];
            let sides = match rims.get(at) {
                Some(&[first, last]) => disks.between(first, last),
                None => disks.rim(face),
            };
            for side in sides {
                let is_wall = walls.get(map.edge(side).index()).is_some_and(|&is_wall| is_wall);
                let Some(mate) = map.mate(side).filter(|_| !is_wall) else { continue };
                let other = map.face(mate);
                if disks.depths[other.index()] == NONE {
                    let relative = if map.agrees(side) { Sign::Plus } else { Sign::Minus };
                    disks.depths[other.index()] = disks.depths[face.index()] + 1;
                    disks.entries[other.index()] = mate.to_u32();
                    disks.signs[other.index()] = disks.signs[face.index()].times(relative);
                    queue.push(other);
                }
            }
            at += 1;
        }
        disks.order = queue.split_off(at_roots);
        disks.roots = roots;
        disks
    }

    /// The side after this one, counterclockwise around its face.
    fn turn(&self, side: HalfedgeId) -> HalfedgeId {
        match self.signs[self.map.face(side).index()] {
            Sign::Plus => self.map.next(side),
            Sign::Minus => self.map.previous(side),
        }
    }

    /// The sides of a face between two of its sides, counterclockwise.
    fn between(&self, first: HalfedgeId, last: HalfedgeId) -> Vec<HalfedgeId> {
        let sides = std::iter::successors(Some(self.turn(first)), |&side| Some(self.turn(side)));
        sides.take_while(|&side| side != last && side != first).collect()
    }

    /// The sides of a face that is not at a root, counterclockwise after the one by which it is reached.
    fn rim(&self, face: FaceId) -> Vec<HalfedgeId> {
        let entry = HalfedgeId::from_u32(self.entries[face.index()]);
        self.between(entry, entry)
    }

    /// Whether the way around the disk counterclockwise runs along the edge of a side, not against it.
    pub(super) fn runs_along(&self, side: HalfedgeId) -> bool {
        (self.map.step(side) & 1 == 0) == (self.signs[self.map.face(side).index()] == Sign::Plus)
    }

    /// The face that the tree reaches through a side.
    fn child(&self, side: HalfedgeId) -> Option<FaceId> {
        let mate = self.map.mate(side)?;
        let face = self.map.face(mate);
        (self.entries[face.index()] == mate.to_u32()).then_some(face)
    }

    /// Whether an edge is crossed by a tree.
    pub(super) fn is_crossed(&self, edge: EdgeId) -> bool {
        let side = self.map.first_side(edge);
        let sides = [Some(side), self.map.mate(side)];
        sides.into_iter().flatten().any(|side| self.entries[self.map.face(side).index()] == side.to_u32())
    }

    /// The sides around the disk of a root, counterclockwise from its first edge.
    pub(super) fn around(&self, root: usize) -> Vec<HalfedgeId> {
        let mut found = Vec::new();
        let mut stack = Vec::new();
        for &[first, last] in &self.roots[root].corners {
            stack.extend(self.between(first, last).into_iter().rev());
            while let Some(side) = stack.pop() {
                match self.child(side) {
                    Some(face) => stack.extend(self.rim(face).into_iter().rev()),
                    None => found.push(side),
                }
            }
        }
        found
    }

    /// The roots.
    pub(super) fn roots(&self) -> &[Root] {
        &self.roots
    }

    /// Draws strands: they go straight through each face, and no two cross.
    ///
    /// # Panics
    /// If that cannot be.
    pub(super) fn draw(&self, crossings: &Crossings) -> Drawn {
        let mut drawing = Drawing::new(self, crossings);
        for &face in self.order.iter().rev() {
            drawing.pass_face(face);
        }
        for root in 0..self.roots.len() {
            drawing.pass_root(root);
        }
        drawing.finish(crossings)
    }
}

/// A strand that is under way, with its last point.
#[derive(Clone, Copy)]
struct Open {
    strand: u32,
    mark: Mark,
}

/// Strands while they are drawn, from the leaves of the trees to the roots.
struct Drawing<'d, 'm> {
    disks: &'d Disks<'m>,
    crossings: &'d Crossings,
    /// The list of points of each edge at the rim; none of others.
    lists: Vec<u32>,
    /// For each face the first point on the edge by which it is reached, and how many there are. They lie counterclockwise around
    /// the face from which it is reached.
    passed: Vec<[u32; 2]>,
    /// The strands of points on edges that trees cross.
    strands: Vec<u32>,
    segments: Vec<Segment>,
    /// Points on edges at roots, from the start of the edge to its end.
    at_roots: Vec<(EdgeId, Vec<u32>)>,
    open: Vec<Open>,
}

impl<'d, 'm> Drawing<'d, 'm> {
    fn new(disks: &'d Disks<'m>, crossings: &'d Crossings) -> Self {
        let mut lists = vec![NONE; disks.map.edge_count()];
        for ((edge, _), list) in crossings.points.iter().zip(0..) {
            lists[edge.index()] = list;
        }
        Self {
            disks,
            crossings,
            lists,
            passed: vec![[0; 2]; disks.map.face_count()],
            strands: Vec::new(),
            segments: Vec::new(),
            at_roots: Vec::new(),
            open: Vec::new(),
        }
    }

    /// A new point that a strand passes.
    fn point(&mut self, strand: u32) -> u32 {
        self.strands.push(strand);
        (self.disks.map.vertex_count() + self.crossings.strands.len() + self.strands.len() - 1) as u32
    }

    /// Meets the strands at a side: those that are under way end, others begin.
    fn enter(&mut self, side: HalfedgeId, mut spoke: impl FnMut(&mut Self, Open) -> bool) {
        let map = self.disks.map;
        let first = (map.vertex_count() + self.crossings.strands.len()) as u32;
        let own: Vec<(u32, u32)> = if let Some(face) = self.disks.child(side) {
            let [start, count] = self.passed[face.index()];
            (start..start + count).map(|point| (self.strands[(point - first) as usize], point)).collect()
        } else if let Some((edge, points)) =
            self.crossings.points.get(self.lists[map.edge(side).index()] as usize)
        {
            let slot = usize::from(map.first_side(*edge) != side);
            let strand = |&point: &u32| {
                (self.crossings.strands[point as usize][slot], map.vertex_count() as u32 + point)
            };
            if self.disks.runs_along(side) {
                points.iter().map(strand).collect()
            } else {
                points.iter().rev().map(strand).collect()
            }
        } else {
            return;
        };
        for (strand, point) in own {
            let found = Open { strand, mark: Mark { side, point } };
            match self.open.last().copied() {
                Some(open) if open.strand == strand => {
                    self.segments.push(Segment { ends: [open.mark, found.mark], strand });
                    self.open.pop();
                }
                _ if strand == NONE || spoke(self, found) => {}
                _ => self.open.push(found),
            }
        }
    }

    /// Draws the strands in a face that is not at a root; the rest leaves by the edge by which the face is reached.
    fn pass_face(&mut self, face: FaceId) {
        let disks = self.disks;
        for side in disks.rim(face) {
            self.enter(side, |_, _| false);
        }
        let entry = HalfedgeId::from_u32(disks.entries[face.index()]);
        let open = std::mem::take(&mut self.open);
        for (i, from) in open.iter().enumerate() {
            let point = self.point(from.strand);
            if i == 0 {
                self.passed[face.index()] = [point, open.len() as u32];
            }
            let mark = Mark { side: entry, point };
            self.segments.push(Segment { ends: [from.mark, mark], strand: from.strand });
        }
        self.open = open;
        self.open.clear();
    }

    /// Draws the strands in the faces at a root: spokes to the root, the others past it.
    fn pass_root(&mut self, index: usize) {
        let disks = self.disks;
        let (map, root) = (disks.map, &disks.roots[index]);
        let is_spoke = spokes(self.crossings);
        for (i, &[first, last]) in root.corners.iter().enumerate() {
            let corner = root.mark(map, i);
            for side in disks.between(first, last) {
                self.enter(side, |drawing, open| {
                    if !is_spoke[open.strand as usize] {
                        return false;
                    }
                    assert!(drawing.open.is_empty(), "no strand passes between the root and a spoke");
                    drawing.segments.push(Segment { ends: [corner, open.mark], strand: open.strand });
                    true
                });
            }
            // The rest goes on through the next edge; what came first is nearest to the root.
            let mut open = std::mem::take(&mut self.open);
            let mut points = Vec::with_capacity(open.len());
            for passing in &mut open {
                let point = self.point(passing.strand);
                let mark = Mark { side: last, point };
                self.segments.push(Segment { ends: [passing.mark, mark], strand: passing.strand });
                let beyond = map.mate(last).expect("no strand leaves by the boundary");
                passing.mark = Mark { side: beyond, point };
                points.push(point);
            }
            self.open = open;
            if !points.is_empty() {
                if map.skeleton().edge(map.edge(last))[0] != root.vertex {
                    points.reverse();
                }
                self.at_roots.push((map.edge(last), points));
            }
        }
        assert!(self.open.is_empty(), "each strand that begins in a disk ends in it");
    }

    /// The surface refined along the strands.
    fn finish(mut self, crossings: &Crossings) -> Drawn {
        let map = self.disks.map;
        let vertex_count = map.vertex_count() as u32;
        let mut lists: Vec<Vec<u32>> = vec![Vec::new(); map.edge_count()];
        for (edge, points) in &crossings.points {
            lists[edge.index()] = points.iter().map(|point| vertex_count + point).collect();
        }
        for (edge, points) in self.at_roots.drain(..) {
            lists[edge.index()] = points;
        }
        for &face in &self.disks.order {
            let [start, count] = self.passed[face.index()];
            let entry = HalfedgeId::from_u32(self.disks.entries[face.index()]);
            let points = start..start + count;
            let mate = map.mate(entry).expect("a face is reached from another one");
            lists[map.edge(entry).index()] =
                if self.disks.runs_along(mate) { points.collect() } else { points.rev().collect() };
        }
        let points = RaggedArray::from_lists(lists);
        self.segments.sort_by_key(|segment| map.face(segment.ends[0].side));
        let (refinement, steps) = Refinement::along(map, &points, &self.segments);
        let mut drawn = Drawn {
            refinement,
            steps: vec![[NONE; 2]; points.item_count()],
            spokes: vec![NONE; crossings.strand_count],
        };
        for (segment, &step) in self.segments.iter().zip(&steps) {
            for (end, step) in segment.ends.iter().zip([step, step ^ 1]) {
                match end.point.checked_sub(vertex_count) {
                    None => drawn.spokes[segment.strand as usize] = step,
                    Some(point) => {
                        let slots = &mut drawn.steps[point as usize];
                        slots[usize::from(slots[0] != NONE)] = step;
                    }
                }
            }
        }
        drawn
    }
}

/// Which strands have one end at an edge only.
fn spokes(crossings: &Crossings) -> Vec<bool> {
    let mut counts = vec![0_u8; crossings.strand_count];
    for &strand in crossings.strands.iter().flatten().filter(|&&strand| strand != NONE) {
        counts[strand as usize] += 1;
    }
    counts.into_iter().map(|count| count == 1).collect()
}

impl Drawn {
    /// The steps along the curve that begins with this spoke, to a root or to the boundary.
    pub(super) fn curve(&self, spoke: usize) -> Vec<u32> {
        let ends = self.refinement.map().skeleton().edge_ends();
        let vertex_count = self.refinement.map().vertex_count() - self.steps.len();
        let mut steps = vec![self.spokes[spoke]];
        loop {
            let step = steps[steps.len() - 1];
            let Some(point) = (ends[(step ^ 1) as usize] as usize).checked_sub(vertex_count) else {
                return steps;
            };
            let [a, b] = self.steps[point];
            let next = if a == step ^ 1 { b } else { a };
            if next == NONE {
                return steps;
            }
            steps.push(next);
        }
    }
}
