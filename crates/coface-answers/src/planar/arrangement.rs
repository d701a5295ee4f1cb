//! The complex that drawings cut the plane into.

use super::containment::{Containment, ContainmentSearch};
use super::crossings::{MOST_PLACES, crossed_rings, crossing_remark, refuse_crossings};
use super::drawing::PlanarDrawing;
use super::settling::{Movement, Placing, Settled, thin_faces};
use super::sides::Sides;
use crate::answer::{
    CongruentPieces, JoinedFeatures, PlanarArrangementAnswer, PlanarArrangementProvenance, PlanarRounding,
    Remark, RemarkCode,
};
use coface_algebra::RaggedArray;
use coface_algebra::{EdgeId, Error, FaceId, VertexId};
use coface_arrange::boolean::InsideRule;
use coface_arrange::planar::{
    PlanarArrangement, PlanarOptions, RoundingCertificate, SnappedArrangement, Step, VertexSource,
};

/// How the cells of an arrangement are found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum ArrangementMethod {
    /// All decisions are exact; a tolerance puts features together before.
    #[default]
    Exact,
    /// Each segment or polygon is cut for itself, and pieces that coincide within a tolerance become one: the chain complex congruence
    /// of the source texts.
    Congruence,
}

/// How drawings are arranged.
#[derive(Clone, Copy, Debug, Default)]
#[non_exhaustive]
pub struct ArrangementRequest {
    /// Which winding numbers are inside of a region. Without a rule those that are not zero are, holes of polygons count against
    /// their outer rings whatever their direction is, and drawings that state a rule keep it.
    pub rule: Option<InsideRule>,
    /// Refuse rings that cross themselves if neither the request nor the drawing states a rule.
    pub strict: bool,
    /// Leave out edges with one face on both sides, and the vertices that no edge is left at.
    pub prune: bool,
    /// Round coordinates and arrange again until all vertices are where their coordinates say.
    pub snap: bool,
    /// Put all vertices on the grid with this step: their coordinates are multiples of it.
    pub grid: Option<f64>,
    /// Put vertices and edges together that are at most this far apart, in the unit of the inputs.
    pub tolerance: Option<f64>,
    /// How cells are found. By congruence a tolerance is taken from the extent of the drawing where none is given.
    pub method: ArrangementMethod,
    /// Keep the exact complex where the drawing with rounded coordinates is another one. Else edges are cut and bent there by
    /// a few units of the last digit.
    pub exact: bool,
    /// The most vertices, edges and faces together.
    pub max_cells: Option<usize>,
}

/// The vertices, edges and faces of drawings in the plane, with the segments along each edge and the regions around each face.
///
/// # Examples
/// Two squares that overlap in a quarter.
/// ```
/// use coface_io as io;
/// use coface_io::Format;
/// use coface_answers::{ArrangementRequest, DrawingArrangement, PlanarDrawing, RegionSource};
/// use coface_algebra::FaceId;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let a = io::read(&b"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"[..], Format::Wkt)?;
/// let b = io::read(&b"POLYGON ((1 1, 3 1, 3 3, 1 3, 1 1))"[..], Format::Wkt)?;
/// let drawing = PlanarDrawing::new([("a", &a), ("b", &b)], RegionSource::Models)?;
/// let arranged = DrawingArrangement::new(drawing, &ArrangementRequest::default())?;
/// assert_eq!(arranged.arrangement().f_vector(), [10, 12, 3]);
/// let inside: Vec<&[u32]> = (0..3).map(|face| arranged.regions_around(FaceId::new(face))).collect();
/// assert_eq!(inside, [&[0][..], &[0, 1], &[1]]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct DrawingArrangement {
    pub(super) drawing: PlanarDrawing,
    pub(super) arrangement: PlanarArrangement,
    pub(super) sources: Vec<VertexSource>,
    pub(super) segments_of_edge: RaggedArray,
    /// How often coordinates were rounded, if that was asked for.
    pub(super) snap_rounds: Option<usize>,
    /// What moved so that rounded coordinates are valid, if that was needed.
    movement: Option<Movement>,
    /// Whether vertices are not where the drawing has them.
    pub(super) is_moved: bool,
    /// Whether files keep exact points.
    pub(super) keeps_exact: bool,
    /// What rounding does, if that is known.
    certificate: Option<RoundingCertificate>,
    pub(super) containment: Containment,
    crossings: Option<Remark>,
    /// What was put together within a tolerance.
    joined: Option<JoinedFeatures>,
    /// What congruence glued.
    congruence: Option<CongruentPieces>,
    /// What is said of vertices that were put elsewhere.
    placed: Vec<Remark>,
    pub(super) rule: Option<InsideRule>,
}

impl DrawingArrangement {
    /// Arranges a drawing.
    ///
    /// # Errors
    /// Those of [`PlanarArrangement::with_options`] and [`PlanarArrangement::snapped`]; if the request is strict,
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) naming the crossing of a ring with itself.
    ///
    /// # Complexity
    /// That of the arrangement, and linear in the segments along all edges.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{ArrangementRequest, DrawingArrangement, PlanarDrawing, RegionSource};
    /// let square = coface_io::read(&b"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let cut = coface_io::read(&b"1,-1,1,3\n"[..], coface_io::Format::Lines)?;
    /// let drawing = PlanarDrawing::new([("square", &square), ("cut", &cut)], RegionSource::Models)?;
    /// let arranged = DrawingArrangement::new(drawing, &ArrangementRequest::default())?;
    /// // The line goes through the square, and beyond it at both ends.
    /// assert_eq!(arranged.arrangement().f_vector(), [8, 9, 2]);
    /// # Ok(()) }
    /// ```
    pub fn new(drawing: PlanarDrawing, request: &ArrangementRequest) -> Result<Self, Error> {
        let options = PlanarOptions::new().max_cells(request.max_cells);
        let exact = drawing.arrange(&options)?;
        let (mut snap_rounds, mut joined, mut congruence, mut placed) = (None, None, None, Vec::new());
        let (mut movement, mut certificate, mut is_placed) = (None, None, false);
        let placing = Placing {
            snap: request.snap,
            grid: request.grid,
            tolerance: request.tolerance,
            method: request.method,
        };
        // The exact arrangement is kept where another one is made of it.
        let (mut parts, exact) = if placing.is_asked() {
            let own = placing.of(&exact)?;
            (snap_rounds, joined, placed) = (own.snap_rounds, own.joined, own.remarks);
            congruence = own.congruence;
            is_placed = own.snapped.round_count() > 0;
            (Parts::of_snapped(&own.snapped, |source| source, |segment| [segment]), Some(exact))
        } else {
            if !request.exact {
                certificate = Some(exact.rounding_certificate()?).filter(RoundingCertificate::is_valid);
            }
            let parts = Parts::of(exact);
            if request.exact || certificate.is_some() {
                (parts, None)
            } else {
                (parts.settled(&mut movement)?, Some(parts.arrangement))
            }
        };
        let is_exact = movement.is_none() && !is_placed;
        if request.prune {
            parts = parts.pruned()?;
        }
        let containment = parts.containment(&drawing, request.rule, is_exact);
        let mut crossings = match request.rule {
            Some(_) => Vec::new(),
            None => crossed_rings(&drawing, &containment.windings),
        };
        // Rings that rounding turns inside out somewhere do not cross themselves as they were drawn.
        let drawn = exact.filter(|_| !is_exact && !crossings.is_empty()).map(Parts::of);
        if let Some(drawn) = &drawn {
            crossings = crossed_rings(&drawing, &drawn.containment(&drawing, None, true).windings);
        }
        let drawn = drawn.as_ref().unwrap_or(&parts);
        let places = |ring: u32| drawn.meetings_of(&drawing, ring);
        if request.strict {
            refuse_crossings(&drawing, &crossings, places)?;
        }
        let crossings = crossing_remark(&drawing, &crossings, places);
        let Parts { arrangement, sources, segments_of_edge, .. } = parts;
        Ok(Self {
            drawing,
            arrangement,
            sources,
            segments_of_edge,
            snap_rounds,
            movement,
            is_moved: !is_exact,
            keeps_exact: request.exact,
            certificate,
            containment,
            crossings,
            joined,
            congruence,
            placed,
            rule: request.rule,
        })
    }

    /// What moved so that rounded coordinates are exact, if that was needed.
    pub(super) fn remark_of_movement(&self) -> Option<Remark> {
        self.movement.map(|movement| movement.remark("face"))
    }

    /// What was drawn.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{ArrangementRequest, DrawingArrangement, PlanarDrawing, RegionSource};
    /// let square = coface_io::read(&b"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let cut = coface_io::read(&b"1,-1,1,3\n"[..], coface_io::Format::Lines)?;
    /// let drawing = PlanarDrawing::new([("square", &square), ("cut", &cut)], RegionSource::Models)?;
    /// let arranged = DrawingArrangement::new(drawing, &ArrangementRequest::default())?;
    /// assert_eq!(arranged.drawing().names(), ["square", "cut"]);
    /// # Ok(()) }
    /// ```
    pub fn drawing(&self) -> &PlanarDrawing {
        &self.drawing
    }

    /// The arrangement: pruned or snapped if that was asked for. Its own segments are those of the drawing unless it is snapped.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{ArrangementRequest, DrawingArrangement, PlanarDrawing, RegionSource};
    /// let square = coface_io::read(&b"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let cut = coface_io::read(&b"1,-1,1,3\n"[..], coface_io::Format::Lines)?;
    /// let drawing = PlanarDrawing::new([("square", &square), ("cut", &cut)], RegionSource::Models)?;
    /// let arranged = DrawingArrangement::new(drawing, &ArrangementRequest::default())?;
    /// assert_eq!(arranged.arrangement().face_count(), 2);
    /// # Ok(()) }
    /// ```
    pub fn arrangement(&self) -> &PlanarArrangement {
        &self.arrangement
    }

    /// The segments of the drawing along each edge, rising.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{ArrangementRequest, DrawingArrangement, PlanarDrawing, RegionSource};
    /// let square = coface_io::read(&b"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let cut = coface_io::read(&b"1,-1,1,3\n"[..], coface_io::Format::Lines)?;
    /// let drawing = PlanarDrawing::new([("square", &square), ("cut", &cut)], RegionSource::Models)?;
    /// let arranged = DrawingArrangement::new(drawing, &ArrangementRequest::default())?;
    /// assert_eq!(arranged.segments_of_edges().len(), arranged.arrangement().edge_count());
    /// # Ok(()) }
    /// ```
    pub fn segments_of_edges(&self) -> &RaggedArray {
        &self.segments_of_edge
    }

    /// Where a vertex comes from: a vertex of the drawing, or the crossing of two segments of the drawing.
    ///
    /// # Panics
    /// If there is no such vertex.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{ArrangementRequest, DrawingArrangement, PlanarDrawing, RegionSource};
    /// let square = coface_io::read(&b"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let cut = coface_io::read(&b"1,-1,1,3\n"[..], coface_io::Format::Lines)?;
    /// let drawing = PlanarDrawing::new([("square", &square), ("cut", &cut)], RegionSource::Models)?;
    /// let arranged = DrawingArrangement::new(drawing, &ArrangementRequest::default())?;
    /// let source = arranged.source(coface_algebra::VertexId::new(0));
    /// assert_eq!(source, coface_arrange::planar::VertexSource::Given(0));
    /// # Ok(()) }
    /// ```
    pub fn source(&self, vertex: VertexId) -> VertexSource {
        self.sources[vertex.index()]
    }

    /// The regions that contain a face, rising.
    ///
    /// # Panics
    /// If there is no such face.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{ArrangementRequest, DrawingArrangement, PlanarDrawing, RegionSource};
    /// let square = coface_io::read(&b"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let cut = coface_io::read(&b"1,-1,1,3\n"[..], coface_io::Format::Lines)?;
    /// let drawing = PlanarDrawing::new([("square", &square), ("cut", &cut)], RegionSource::Models)?;
    /// let arranged = DrawingArrangement::new(drawing, &ArrangementRequest::default())?;
    /// assert_eq!(arranged.regions_around(coface_algebra::FaceId::new(0)), [0]);
    /// # Ok(()) }
    /// ```
    pub fn regions_around(&self, face: FaceId) -> &[u32] {
        self.containment.regions.list(face.index())
    }

    /// What is odd about the inputs, each with the name of a model: holes that are not inside of their outer rings.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{ArrangementRequest, DrawingArrangement, PlanarDrawing, RegionSource};
    /// let square = coface_io::read(&b"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let cut = coface_io::read(&b"1,-1,1,3\n"[..], coface_io::Format::Lines)?;
    /// let drawing = PlanarDrawing::new([("square", &square), ("cut", &cut)], RegionSource::Models)?;
    /// let arranged = DrawingArrangement::new(drawing, &ArrangementRequest::default())?;
    /// assert!(arranged.warnings().is_empty());
    /// # Ok(()) }
    /// ```
    pub fn warnings(&self) -> Vec<String> {
        self.containment.warnings(&self.drawing)
    }

    /// The number of edges with one face on both sides that hang on the rest by one end, or by none: taken away one by one from
    /// vertices with a single edge.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{ArrangementRequest, DrawingArrangement, PlanarDrawing, RegionSource};
    /// let square = coface_io::read(&b"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let cut = coface_io::read(&b"1,-1,1,3\n"[..], coface_io::Format::Lines)?;
    /// let drawing = PlanarDrawing::new([("square", &square), ("cut", &cut)], RegionSource::Models)?;
    /// let arranged = DrawingArrangement::new(drawing, &ArrangementRequest::default())?;
    /// assert_eq!(arranged.dangling_edge_count(), 2);
    /// # Ok(()) }
    /// ```
    pub fn dangling_edge_count(&self) -> usize {
        let arrangement = &self.arrangement;
        let around = |vertex: VertexId| arrangement.halfedges_around(vertex).map(|h| h.to_u32() / 2);
        let mut degrees: Vec<usize> =
            (0..arrangement.vertex_count()).map(|v| around(VertexId::new(v)).count()).collect();
        let mut is_gone = vec![false; arrangement.edge_count()];
        let mut leaves: Vec<usize> = (0..degrees.len()).filter(|&v| degrees[v] == 1).collect();
        let mut count = 0;
        while let Some(leaf) = leaves.pop() {
            let Some(edge) = around(VertexId::new(leaf)).find(|&edge| !is_gone[edge as usize]) else {
                continue;
            };
            is_gone[edge as usize] = true;
            count += 1;
            for end in arrangement.ends(EdgeId::from_u32(edge)) {
                degrees[end.index()] -= 1;
                if degrees[end.index()] == 1 {
                    leaves.push(end.index());
                }
            }
        }
        count
    }

    /// Whether the product of the two boundary matrices is zero, found by multiplying them.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`](coface_algebra::ErrorKind::TooLarge) if a matrix does not fit in 32 bits.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{ArrangementRequest, DrawingArrangement, PlanarDrawing, RegionSource};
    /// let square = coface_io::read(&b"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let cut = coface_io::read(&b"1,-1,1,3\n"[..], coface_io::Format::Lines)?;
    /// let drawing = PlanarDrawing::new([("square", &square), ("cut", &cut)], RegionSource::Models)?;
    /// let arranged = DrawingArrangement::new(drawing, &ArrangementRequest::default())?;
    /// assert!(arranged.products_are_zero()?);
    /// # Ok(()) }
    /// ```
    pub fn products_are_zero(&self) -> Result<bool, Error> {
        let complex = self.arrangement.coarse_complex()?;
        match (complex.boundary_matrix(1), complex.boundary_matrix(2)) {
            (Some(edges), Some(faces)) => Ok(edges.product(faces)?.is_zero()),
            _ => Ok(true),
        }
    }

    /// The arrangement as an answer: counts, areas, what contains each face, and what rounding does.
    ///
    /// # Errors
    /// Those of [`Self::products_are_zero`] and [`PlanarArrangement::rounding_certificate`].
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{ArrangementRequest, DrawingArrangement, PlanarDrawing, RegionSource};
    /// let square = coface_io::read(&b"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let cut = coface_io::read(&b"1,-1,1,3\n"[..], coface_io::Format::Lines)?;
    /// let drawing = PlanarDrawing::new([("square", &square), ("cut", &cut)], RegionSource::Models)?;
    /// let arranged = DrawingArrangement::new(drawing, &ArrangementRequest::default())?;
    /// let answer = arranged.answer()?;
    /// assert_eq!((answer.f_vector, answer.measures), ([8, 9, 2], vec![2.0, 2.0]));
    /// # Ok(()) }
    /// ```
    pub fn answer(&self) -> Result<PlanarArrangementAnswer, Error> {
        let arrangement = &self.arrangement;
        let (vertices, edges, faces) =
            (arrangement.vertex_count(), arrangement.edge_count(), arrangement.face_count());
        let bridges = (0..edges).filter(|&edge| arrangement.is_bridge(EdgeId::new(edge))).count();
        let certificate = match &self.certificate {
            Some(certificate) => certificate.clone(),
            None => arrangement.rounding_certificate()?,
        };
        let is_exact = self.movement.is_none() && arrangement.is_exactly_rounded();
        let rounding = rounding_answer(&certificate, is_exact, &self.movement.unwrap_or_default());
        let mut remarks = self.drawing.remarks.clone();
        remarks.extend(self.drawing.remarks_of_lines(self.rule, false));
        remarks.extend(self.crossings.iter().chain(&self.placed).cloned());
        remarks.extend(self.containment.remarks(&self.drawing));
        if !rounding.valid {
            remarks.push(Remark::new(
                RemarkCode::RoundedInvalid,
                "coordinates are rounded, and drawn with them this is another complex; without --exact it is made valid",
            ));
        }
        remarks.extend(self.movement.map(|movement| movement.remark("face")));
        let measures = arrangement.areas();
        if self.joined.is_none() {
            remarks.extend(thin_faces(arrangement, &measures));
        }
        Ok(PlanarArrangementAnswer {
            dimension: 2,
            f_vector: [vertices, edges, faces],
            measures,
            inside: self.containment.regions.iter().map(<[u32]>::to_vec).collect(),
            products_zero: self.products_are_zero()?,
            holes: arrangement.hole_count(),
            components: arrangement.component_count(),
            euler_characteristic: vertices as i64 - edges as i64 + faces as i64,
            bridges,
            dangling_edges: self.dangling_edge_count(),
            rounding,
            snap_rounds: self.snap_rounds,
            joined: self.joined.clone(),
            congruence: self.congruence.clone(),
            inputs: self.drawing.input_answers(),
            regions: self.drawing.region_names().into_iter().map(str::to_owned).collect(),
            attributes: None,
            warnings: self.warnings(),
            remarks,
        })
    }

    /// Where everything comes from: of each vertex the vertex of the inputs or the two segments that cross there, of each
    /// edge the segments along it, of each face the regions around it.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{ArrangementRequest, DrawingArrangement, PlanarDrawing, RegionSource};
    /// let square = coface_io::read(&b"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let cut = coface_io::read(&b"1,-1,1,3\n"[..], coface_io::Format::Lines)?;
    /// let drawing = PlanarDrawing::new([("square", &square), ("cut", &cut)], RegionSource::Models)?;
    /// let arranged = DrawingArrangement::new(drawing, &ArrangementRequest::default())?;
    /// assert_eq!(arranged.provenance().inputs, ["square", "cut"]);
    /// # Ok(()) }
    /// ```
    pub fn provenance(&self) -> PlanarArrangementProvenance {
        let drawing = &self.drawing;
        let segments = |segments: &[u32]| {
            segments.iter().map(|&segment| drawing.segment_source(segment as usize)).collect()
        };
        PlanarArrangementProvenance {
            inputs: drawing.names.clone(),
            regions: drawing.region_names().into_iter().map(str::to_owned).collect(),
            vertices: self.sources.iter().map(|source| drawing.vertex_origin(source)).collect(),
            edges: self.segments_of_edge.iter().map(segments).collect(),
            faces: self.containment.regions.iter().map(<[u32]>::to_vec).collect(),
        }
    }
}

/// An arrangement with where its parts come from in the drawing.
pub(super) struct Parts {
    pub(super) arrangement: PlanarArrangement,
    pub(super) sources: Vec<VertexSource>,
    pub(super) segments_of_edge: RaggedArray,
    /// Whether each of these segments runs up, if that is known.
    runs_up: Option<Vec<bool>>,
}

impl Parts {
    pub(super) fn of(arrangement: PlanarArrangement) -> Self {
        let sources = (0..arrangement.vertex_count()).map(|vertex| arrangement.source(VertexId::new(vertex)));
        Self {
            sources: sources.collect(),
            segments_of_edge: arrangement.segments_of_edges().clone(),
            runs_up: None,
            arrangement,
        }
    }

    /// A snapped arrangement, with the sources of its vertices and the segments along each of its segments.
    fn of_snapped<I: IntoIterator<Item = u32>>(
        snapped: &SnappedArrangement,
        source: impl Fn(VertexSource) -> VertexSource,
        segments: impl Fn(u32) -> I,
    ) -> Self {
        let arrangement = snapped.arrangement().clone();
        let vertices = (0..arrangement.vertex_count()).map(VertexId::new);
        let lists = snapped.segments_of_edges().iter().map(|along| {
            let mut list: Vec<u32> = along.iter().flat_map(|&segment| segments(segment)).collect();
            list.sort_unstable();
            list.dedup();
            list
        });
        Self {
            sources: vertices.map(|vertex| source(snapped.source(vertex))).collect(),
            segments_of_edge: RaggedArray::from_lists(lists),
            runs_up: snapped.runs_up().map(<[bool]>::to_vec),
            arrangement,
        }
    }

    /// The same with edges that are cut and bent until rounded coordinates are exact.
    fn settled(&self, movement: &mut Option<Movement>) -> Result<Self, Error> {
        let arrangement = &self.arrangement;
        let edges: Vec<[u32; 2]> = (0..arrangement.edge_count())
            .map(|edge| arrangement.ends(EdgeId::new(edge)).map(VertexId::to_u32))
            .collect();
        let settled = Settled::new(arrangement.positions(), &edges)?;
        let mut moved = settled.movement;
        moved.vanished = arrangement.face_count().saturating_sub(settled.snapped.arrangement().face_count());
        *movement = Some(moved);
        let source = |source: VertexSource| match source {
            VertexSource::Given(vertex) => self.sources[vertex],
            VertexSource::Crossing(edges) => {
                VertexSource::Crossing(edges.map(|edge| self.segments_of_edge.list(edge)[0] as usize))
            }
        };
        let segments = |edge: u32| self.segments_of_edge.list(edge as usize).iter().copied();
        Ok(Self::of_snapped(&settled.snapped, source, segments))
    }

    /// The same without edges with one face on both sides, and the vertices that no edge is left at.
    fn pruned(mut self) -> Result<Self, Error> {
        let arrangement = &self.arrangement;
        let is_kept = |edge: &usize| !arrangement.is_bridge(EdgeId::new(*edge));
        let edges: Vec<usize> = (0..arrangement.edge_count()).filter(is_kept).collect();
        let mut is_end = vec![false; arrangement.vertex_count()];
        for &edge in &edges {
            arrangement.ends(EdgeId::new(edge)).iter().for_each(|end| is_end[end.index()] = true);
        }
        let lists = edges.iter().map(|&edge| self.segments_of_edge.list(edge));
        let segments_of_edge = RaggedArray::from_lists(lists);
        let ranges = edges
            .iter()
            .map(|&edge| self.segments_of_edge.start(edge)..self.segments_of_edge.start(edge + 1));
        let runs_up = self.runs_up.take().map(|known| ranges.flat_map(|own| known[own].to_vec()).collect());
        let mut kept = is_end.iter();
        self.sources.retain(|_| *kept.next().expect("each vertex has a source"));
        Ok(Self { arrangement: arrangement.pruned()?, sources: self.sources, segments_of_edge, runs_up })
    }

    /// The regions around the faces; whether edges lie on their segments exactly.
    pub(super) fn containment(
        &self,
        drawing: &PlanarDrawing,
        rule: Option<InsideRule>,
        is_exact: bool,
    ) -> Containment {
        let arrangement = &self.arrangement;
        let runs_up = self.runs_up.as_deref();
        let sides = Sides { drawing, arrangement, segments: &self.segments_of_edge, is_exact, runs_up };
        let mut search = ContainmentSearch::new(drawing, rule, arrangement.face_count());
        arrangement.tour(|step| match step {
            Step::Into { face, across } => {
                sides.across(across, |ring, by| search.wind(ring, by));
                search.enter(face);
            }
            Step::Back { across, .. } => sides.across(across, |ring, by| search.wind(ring, by)),
        });
        search.finish()
    }

    /// The first points where a ring meets itself: crossings of its segments before others, from the lowest.
    pub(super) fn meetings_of(&self, drawing: &PlanarDrawing, ring: u32) -> Vec<[f64; 2]> {
        let Self { arrangement, sources, segments_of_edge, .. } = self;
        let is_own = |segment: usize| drawing.ring_of_segment[segment] == ring;
        let mut degrees = vec![0u8; arrangement.vertex_count()];
        for (edge, segments) in segments_of_edge.iter().enumerate() {
            if segments.iter().any(|&segment| is_own(segment as usize)) {
                for end in arrangement.ends(EdgeId::new(edge)) {
                    degrees[end.index()] = degrees[end.index()].saturating_add(1);
                }
            }
        }
        let is_crossing = |vertex: usize| match sources[vertex] {
            VertexSource::Crossing(segments) => segments.into_iter().all(is_own),
            VertexSource::Given(_) => false,
        };
        let place = |vertex: usize| {
            let point = arrangement.positions().point(VertexId::new(vertex));
            [point[0], point[1]]
        };
        let mut meetings: Vec<usize> = (0..degrees.len()).filter(|&vertex| degrees[vertex] > 2).collect();
        meetings.sort_by(|&a, &b| {
            let ([x, y], [u, v]) = (place(a), place(b));
            is_crossing(b).cmp(&is_crossing(a)).then(x.total_cmp(&u)).then(y.total_cmp(&v))
        });
        meetings.into_iter().take(MOST_PLACES).map(place).collect()
    }
}

/// What rounding does to a drawing.
fn rounding_answer(certificate: &RoundingCertificate, is_exact: bool, movement: &Movement) -> PlanarRounding {
    PlanarRounding {
        exact: is_exact,
        valid: certificate.is_valid(),
        merged_vertices: certificate.merged_vertices.len(),
        broken_edges: certificate.broken_edges.len(),
        turned_vertices: certificate.turned_vertices.len(),
        moved_components: certificate.moved_components.len(),
        repair: movement.answer(),
    }
}
