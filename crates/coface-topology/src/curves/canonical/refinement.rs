//! Refinements: surfaces whose edges and faces are subdivided, with the way back.

use coface_algebra::RaggedArray;
use coface_algebra::chains::TwoSkeleton;
use coface_algebra::{EdgeId, FaceId, HalfedgeId, IdVec, VertexId};
use coface_complexes::surface::GeneralizedMap;

/// The cell of a surface that a cell of its refinement lies in: the one of least dimension.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Carrier {
    /// It is this vertex.
    Vertex(VertexId),
    /// It lies inside this edge.
    Edge(EdgeId),
    /// It lies inside this face.
    Face(FaceId),
}

/// A surface with edges and faces subdivided, and where its cells lie in the surface before.
///
/// The vertices before keep their numbers; others follow. Each vertex is a convex combination of vertices before: those of its
/// carrier. A face lies in one face before, in the direction of its rim.
///
/// # Examples
/// The torus made of one square, with a canonical system of loops drawn on it.
/// ```
/// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
/// use coface_topology::CanonicalCut;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
/// let cut = CanonicalCut::new(&torus, None)?;
/// let refined = cut.refinement();
/// assert_eq!(refined.map().surfaces(), torus.surfaces());
/// assert!(refined.map().vertex_count() > 1);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Refinement {
    map: GeneralizedMap,
    vertex_carriers: IdVec<VertexId, Carrier>,
    edge_carriers: IdVec<EdgeId, Carrier>,
    face_sources: IdVec<FaceId, FaceId>,
    /// The weights of vertex v are those from `weight_starts[v]` to the next start.
    weight_starts: Vec<usize>,
    weights: Vec<(VertexId, f64)>,
}

/// A point of a face's boundary: on a side, or at the corner where the side starts if it is a vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Mark {
    pub(super) side: HalfedgeId,
    pub(super) point: u32,
}

/// A straight line through a face from one point of its boundary to another; part of a strand.
#[derive(Clone, Copy, Debug)]
pub(super) struct Segment {
    pub(super) ends: [Mark; 2],
    pub(super) strand: u32,
}

impl Refinement {
    /// The surface after it is subdivided.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::CanonicalCut;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let cut = CanonicalCut::new(&torus, None)?;
    /// assert_eq!(cut.refinement().map().surfaces()[0].to_string(), "torus");
    /// # Ok(()) }
    /// ```
    pub fn map(&self) -> &GeneralizedMap {
        &self.map
    }

    /// The cell before that each vertex lies in.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::{CanonicalCut, Carrier};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let cut = CanonicalCut::new(&torus, None)?;
    /// let first = VertexId::new(0);
    /// assert_eq!(cut.refinement().vertex_carriers()[first], Carrier::Vertex(first));
    /// # Ok(()) }
    /// ```
    pub fn vertex_carriers(&self) -> &IdVec<VertexId, Carrier> {
        &self.vertex_carriers
    }

    /// The cell before that each edge lies in: an edge or a face.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::CanonicalCut;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let cut = CanonicalCut::new(&torus, None)?;
    /// assert_eq!(cut.refinement().edge_carriers().len(), cut.refinement().map().edge_count());
    /// # Ok(()) }
    /// ```
    pub fn edge_carriers(&self) -> &IdVec<EdgeId, Carrier> {
        &self.edge_carriers
    }

    /// The face before that each face lies in.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::FaceId;
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::CanonicalCut;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let cut = CanonicalCut::new(&torus, None)?;
    /// assert!(cut.refinement().face_sources().iter().all(|&face| face == FaceId::new(0)));
    /// # Ok(()) }
    /// ```
    pub fn face_sources(&self) -> &IdVec<FaceId, FaceId> {
        &self.face_sources
    }

    /// The vertices before whose convex combination a vertex is, with their weights, which add up to 1.
    ///
    /// # Panics
    /// If there is no such vertex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgeMesh};
    /// use coface_topology::CanonicalCut;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = GeneralizedMap::new(HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.two_skeleton()?)?;
    /// let cut = CanonicalCut::new(&torus, None)?;
    /// assert_eq!(cut.refinement().weights(VertexId::new(0)), [(VertexId::new(0), 1.0)]);
    /// # Ok(()) }
    /// ```
    pub fn weights(&self, vertex: VertexId) -> &[(VertexId, f64)] {
        &self.weights[self.weight_starts[vertex.index()]..self.weight_starts[vertex.index() + 1]]
    }

    /// The surface as it is.
    pub(super) fn identity(map: GeneralizedMap) -> Self {
        let vertices = || (0..map.vertex_count()).map(VertexId::new);
        Self {
            vertex_carriers: vertices().map(Carrier::Vertex).collect(),
            edge_carriers: (0..map.edge_count()).map(|edge| Carrier::Edge(EdgeId::new(edge))).collect(),
            face_sources: (0..map.face_count()).map(FaceId::new).collect(),
            weight_starts: (0..=map.vertex_count()).collect(),
            weights: vertices().map(|vertex| (vertex, 1.0)).collect(),
            map,
        }
    }

    /// Adds a vertex with its weights.
    fn push_vertex(&mut self, carrier: Carrier, weights: impl IntoIterator<Item = (VertexId, f64)>) {
        self.vertex_carriers.push(carrier);
        self.weights.extend(weights);
        self.weight_starts.push(self.weights.len());
    }

    /// The surface with a new vertex in the middle of each of these faces, joined to its corners.
    pub(super) fn poked(map: &GeneralizedMap, faces: &[FaceId]) -> Self {
        let skeleton = map.skeleton();
        let mut refined = Self::identity(map.clone());
        refined.face_sources = IdVec::new();
        let mut ends = skeleton.edge_ends().to_vec();
        let mut rims = RaggedArray::new();
        let mut is_poked = vec![false; map.face_count()];
        faces.iter().for_each(|face| is_poked[face.index()] = true);
        for face in (0..map.face_count()).map(FaceId::new) {
            let sides: Vec<HalfedgeId> = map.sides_of(face).collect();
            if !is_poked[face.index()] {
                rims.push(skeleton.faces().list(face.index()));
                refined.face_sources.push(face);
                continue;
            }
            let center = refined.vertex_carriers.len() as u32;
            let share = 1.0 / sides.len() as f64;
            refined.push_vertex(Carrier::Face(face), sides.iter().map(|&side| (map.source(side), share)));
            // Edge i leads from the center to the start of side i.
            let first = (ends.len() / 2) as u32;
            for (i, &side) in sides.iter().enumerate() {
                ends.extend([center, map.source(side).to_u32()]);
                refined.edge_carriers.push(Carrier::Face(face));
                let after = (i + 1) % sides.len();
                rims.push(&[2 * (first + i as u32), map.step(side), 2 * (first + after as u32) + 1]);
                refined.face_sources.push(face);
            }
        }
        let skeleton = TwoSkeleton::new(refined.vertex_carriers.len(), ends, rims)
            .expect("triangles around a center are closed paths");
        refined.map = GeneralizedMap::new(skeleton).expect("a face becomes a disk of triangles");
        refined
    }

    /// The surface with these points on its edges, `points.list(e)` from the start of edge e to its end, evenly spaced, and faces
    /// cut along the segments, which do not cross and come face by face. Points are numbered after the vertices. What triangles
    /// become is triangulated. With it come the steps along the segments.
    pub(super) fn along(
        map: &GeneralizedMap,
        points: &RaggedArray,
        segments: &[Segment],
    ) -> (Self, Vec<u32>) {
        let mut cutting = Cutting::new(map, points);
        let mut steps = Vec::with_capacity(segments.len());
        for segment in segments {
            steps.push(cutting.push_edge(segment.ends.map(|end| end.point), map.face(segment.ends[0].side)));
        }
        let mut at = 0;
        for face in (0..map.face_count()).map(FaceId::new) {
            cutting.walk(map, points, face);
            let first = at;
            while segments.get(at).is_some_and(|segment| map.face(segment.ends[0].side) == face) {
                at += 1;
            }
            cutting.cut_face(map, face, &segments[first..at], &steps[first..at]);
        }
        assert_eq!(at, segments.len(), "segments come face by face");
        (cutting.finish(map, points), steps)
    }

    /// The first part of each edge before: the edge itself where it is not split.
    pub(super) fn first_parts(&self, edge_count: usize) -> Vec<u32> {
        let mut parts = vec![0; edge_count];
        for (edge, &carrier) in self.edge_carriers.iter().enumerate().rev() {
            if let Carrier::Edge(before) = carrier {
                parts[before.index()] = edge as u32;
            }
        }
        parts
    }

    /// This refinement of a surface after the one that made that surface.
    pub(super) fn after(mut self, before: &Self) -> Self {
        let carrier = |carrier: Carrier| match carrier {
            Carrier::Vertex(vertex) => before.vertex_carriers[vertex],
            Carrier::Edge(edge) => before.edge_carriers[edge],
            Carrier::Face(face) => Carrier::Face(before.face_sources[face]),
        };
        self.vertex_carriers = self.vertex_carriers.iter().map(|&found| carrier(found)).collect();
        self.edge_carriers = self.edge_carriers.iter().map(|&found| carrier(found)).collect();
        self.face_sources = self.face_sources.iter().map(|&face| before.face_sources[face]).collect();
        let (mut starts, mut weights) = (vec![0], Vec::with_capacity(self.weights.len()));
        let mut sums: Vec<(VertexId, f64)> = Vec::new();
        for vertex in (0..self.vertex_carriers.len()).map(VertexId::new) {
            sums.clear();
            for &(over, weight) in self.weights(vertex) {
                sums.extend(before.weights(over).iter().map(|&(under, share)| (under, weight * share)));
            }
            sums.sort_by_key(|&(under, _)| under);
            sums.dedup_by(|next, kept| {
                let is_same = next.0 == kept.0;
                kept.1 += if is_same { next.1 } else { 0.0 };
                is_same
            });
            weights.extend_from_slice(&sums);
            starts.push(weights.len());
        }
        (self.weight_starts, self.weights) = (starts, weights);
        self
    }
}

/// A surface while its faces are cut.
struct Cutting {
    ends: Vec<u32>,
    edge_carriers: IdVec<EdgeId, Carrier>,
    /// The first part of each edge before.
    parts: Vec<u32>,
    /// The places of each point around the face that is cut: of the first side of its edge and of the other.
    places: Vec<[u32; 2]>,
    /// Around the face that is cut: vertices, each with the step to the next.
    rim: Vec<(u32, u32)>,
    /// Where each of its sides starts.
    side_places: Vec<u32>,
    /// The place after each place along what is left of the face, and the step to it.
    next: Vec<(u32, u32)>,
    rims: RaggedArray,
    face_sources: IdVec<FaceId, FaceId>,
    vertex_count: u32,
}

impl Cutting {
    fn new(map: &GeneralizedMap, points: &RaggedArray) -> Self {
        let vertex_count = map.vertex_count() as u32;
        let mut cutting = Self {
            ends: Vec::with_capacity(2 * (map.edge_count() + points.item_count())),
            edge_carriers: IdVec::new(),
            parts: Vec::with_capacity(map.edge_count()),
            places: vec![[0; 2]; points.item_count()],
            rim: Vec::new(),
            side_places: Vec::new(),
            next: Vec::new(),
            rims: RaggedArray::new(),
            face_sources: IdVec::new(),
            vertex_count,
        };
        for (edge, inner) in points.iter().enumerate() {
            cutting.parts.push((cutting.ends.len() / 2) as u32);
            let [from, to] = map.skeleton().edge(EdgeId::new(edge)).map(VertexId::to_u32);
            let mut at = from;
            for &end in inner.iter().chain([&to]) {
                cutting.ends.extend([at, end]);
                cutting.edge_carriers.push(Carrier::Edge(EdgeId::new(edge)));
                at = end;
            }
        }
        cutting
    }

    /// Adds an edge inside a face; the step along it.
    fn push_edge(&mut self, ends: [u32; 2], face: FaceId) -> u32 {
        let step = self.ends.len() as u32;
        self.ends.extend(ends);
        self.edge_carriers.push(Carrier::Face(face));
        step
    }

    /// Goes around a face with the points on its sides.
    fn walk(&mut self, map: &GeneralizedMap, points: &RaggedArray, face: FaceId) {
        self.rim.clear();
        self.side_places.clear();
        for side in map.sides_of(face) {
            let (step, edge) = (map.step(side), map.edge(side));
            let inner = points.list(edge.index());
            let slot = usize::from(map.first_side(edge) != side);
            self.side_places.push(self.rim.len() as u32);
            for i in 0..=inner.len() {
                // The part before point i in the direction of the side.
                let part = if step & 1 == 0 { i } else { inner.len() - i };
                let out = 2 * (self.parts[edge.index()] + part as u32) + (step & 1);
                let start = match (i, step & 1) {
                    (0, _) => map.source(side).to_u32(),
                    (_, 0) => inner[i - 1],
                    _ => inner[inner.len() - i],
                };
                if i > 0 {
                    self.places[(start - self.vertex_count) as usize][slot] = self.rim.len() as u32;
                }
                self.rim.push((start, out));
            }
        }
    }

    /// The place of a mark around the face that is cut.
    fn place(&self, map: &GeneralizedMap, mark: Mark) -> u32 {
        match mark.point.checked_sub(self.vertex_count) {
            Some(point) => {
                self.places[point as usize][usize::from(map.first_side(map.edge(mark.side)) != mark.side)]
            }
            None => {
                let first = map.skeleton().faces().start(map.face(mark.side).index());
                self.side_places[mark.side.index() - first]
            }
        }
    }

    /// Cuts off the face what lies on the short side of each segment, shorter ones first.
    fn cut_face(&mut self, map: &GeneralizedMap, face: FaceId, segments: &[Segment], steps: &[u32]) {
        let mut chords: Vec<(u32, u32, u32)> = (segments.iter().zip(steps))
            .map(|(segment, &step)| match segment.ends.map(|end| self.place(map, end)) {
                [a, b] if a < b => (a, b, step),
                [a, b] => (b, a, step ^ 1),
            })
            .collect();
        chords.sort_unstable_by_key(|&(a, b, _)| (b - a, a));
        let count = self.rim.len() as u32;
        self.next.clear();
        self.next.extend((0..count).map(|place| ((place + 1) % count, self.rim[place as usize].1)));
        let is_triangle = self.side_places.len() == 3;
        for (a, b, step) in chords {
            self.push_piece(a, b, Some(step ^ 1), face, is_triangle);
            self.next[a as usize] = (b, step);
        }
        self.push_piece(0, 0, None, face, is_triangle);
    }

    /// The piece from one place to another along what is left, closed by a step if they differ.
    fn push_piece(&mut self, from: u32, to: u32, closing: Option<u32>, face: FaceId, is_triangle: bool) {
        let mut piece: Vec<(u32, u32)> = Vec::new();
        let mut at = from;
        loop {
            let (after, step) = self.next[at as usize];
            piece.push((self.rim[at as usize].0, step));
            at = after;
            if at == to {
                break;
            }
        }
        if let Some(step) = closing {
            piece.push((self.rim[to as usize].0, step));
        }
        if !is_triangle || piece.len() <= 3 {
            self.push_face(piece.iter().map(|&(_, step)| step), face);
            return;
        }
        let mut first = piece[0].1;
        for i in 1..piece.len() - 2 {
            let across = self.push_edge([piece[i + 1].0, piece[0].0], face);
            self.push_face([first, piece[i].1, across].into_iter(), face);
            first = across ^ 1;
        }
        self.push_face([first, piece[piece.len() - 2].1, piece[piece.len() - 1].1].into_iter(), face);
    }

    fn push_face(&mut self, steps: impl Iterator<Item = u32>, face: FaceId) {
        self.rims.push(&steps.collect::<Vec<u32>>());
        self.face_sources.push(face);
    }

    fn finish(self, map: &GeneralizedMap, points: &RaggedArray) -> Refinement {
        let mut of_points = vec![(EdgeId::new(0), 0.0); points.item_count()];
        for (edge, inner) in points.iter().enumerate() {
            for (i, &point) in inner.iter().enumerate() {
                let share = (i + 1) as f64 / (inner.len() + 1) as f64;
                of_points[(point - self.vertex_count) as usize] = (EdgeId::new(edge), share);
            }
        }
        let mut refined = Refinement::identity(map.clone());
        for (edge, share) in of_points {
            let [from, to] = map.skeleton().edge(edge);
            refined.push_vertex(Carrier::Edge(edge), [(from, 1.0 - share), (to, share)]);
        }
        let skeleton = TwoSkeleton::new(refined.vertex_carriers.len(), self.ends, self.rims)
            .expect("a face cut along segments becomes closed paths");
        refined.map = GeneralizedMap::new(skeleton).expect("a face cut along segments stays a disk");
        (refined.edge_carriers, refined.face_sources) = (self.edge_carriers, self.face_sources);
        refined
    }
}
