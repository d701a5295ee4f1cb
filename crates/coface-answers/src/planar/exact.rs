//! Drawings whose segments are known exactly: results that are input again.

use super::arrangement::DrawingArrangement;
use super::boolean::RegionBoolean;
use super::drawing::{Filling, NO_FEATURE, NO_RING, PlanarDrawing, Polygon, Region, Ring};
use crate::RegionSource;
use crate::answer::{Place, Remark, RemarkCode, remarks_of_file};
use coface_algebra::{EdgeId, Error, ErrorKind, FaceId, HalfedgeId, RaggedArray, VertexId};
use coface_arrange::planar::{
    ExactPiece, ExactPlace, ExactSegments, ExactVertex, PlanarArrangement, PlanarOptions, VertexSource,
    is_between,
};
use coface_geometry::predicates::{PlanarLine, PlanarPoint};
use coface_io::Model;
use std::collections::HashMap;
use std::sync::Arc;

/// Exact segments of a model in a drawing.
#[derive(Clone, Debug)]
pub(super) struct ExactPart {
    pub(super) place: ExactPlace,
    pub(super) model: u32,
    /// For each vertex the number of its place among them.
    place_numbers: Vec<u32>,
}

/// That a model is taken with rounded points, for this reason.
pub(super) fn points_rounded(name: &str, why: &str) -> Remark {
    Remark::new(RemarkCode::PointsRounded, format!("{name}: its points are rounded, since {why}"))
        .at(1, [Place::file(name)])
}

impl PlanarDrawing {
    /// The arrangement of all segments.
    ///
    /// # Errors
    /// As [`PlanarArrangement::with_options`].
    pub(super) fn arrange(&self, options: &PlanarOptions) -> Result<PlanarArrangement, Error> {
        let places: Vec<ExactPlace> = self.exact.iter().map(|part| part.place.clone()).collect();
        PlanarArrangement::with_exact(&self.positions, &self.segments, &places, options)
    }

    /// Adds a model by its exact segments: those that are not shared bound a region if an even number of them ends everywhere. Of a
    /// model of faces these are what bounds all of them together.
    pub(super) fn add_exact(
        &mut self,
        name: &str,
        model: &Model,
        exact: &Arc<ExactSegments>,
        source: RegionSource,
        flat: &mut Vec<f64>,
    ) -> Result<(), Error> {
        let (first, number) = (self.positions_in(flat), self.names.len() as u32);
        let start = self.segments.len();
        if flat.len() / 2 + exact.vertices().len() >= 1 << 31 || start + exact.pieces().len() >= 1 << 31 {
            return Err(Error::new(ErrorKind::TooLarge, "more than 2^31 vertices or segments in all"));
        }
        self.names.push(name.to_owned());
        self.remarks.extend(remarks_of_file(name, model));
        flat.extend(exact.vertex_points().iter().flat_map(PlanarPoint::rounded));
        self.vertex_starts.push(self.positions_in(flat));
        self.heights.resize(flat.len() / 2, f64::NAN);
        self.segments.extend(exact.pieces().iter().map(|piece| piece.ends.map(|end| first + end)));
        self.ring_of_segment.resize(self.segments.len(), NO_RING);
        self.segment_starts.push(self.segments.len() as u32);
        self.features.extend_to(self.segments.len(), NO_FEATURE);
        let place =
            ExactPlace { first_point: first as usize, first_segment: start, segments: Arc::clone(exact) };
        let place_numbers = exact.place_numbers();
        let own = &exact.pieces()[..exact.own_count()];
        self.shared_segment_count += exact.pieces().len() - own.len();
        let mut degrees = vec![0usize; place_numbers.len()];
        own.iter()
            .flat_map(|piece| piece.ends)
            .for_each(|end| degrees[place_numbers[end as usize] as usize] += 1);
        let is_odd = |end: &u32| degrees[place_numbers[*end as usize] as usize] % 2 == 1;
        let open_at = own.iter().flat_map(|piece| piece.ends).find(is_odd).map(|end| first + end);
        self.exact.push(ExactPart { place, model: number, place_numbers });
        let is_empty = own.is_empty() || open_at.is_some();
        if source == RegionSource::Models || !own.is_empty() {
            let name = match source {
                RegionSource::Models => name.to_owned(),
                _ => format!("{name}#0"),
            };
            self.regions.push(Region { name, model: number, open_at, is_empty });
        }
        if !is_empty {
            let region = self.regions.len() as u32 - 1;
            self.polygons.push(Polygon { region, feature: NO_FEATURE, filling: Filling::Lines, number: 0 });
            self.rings.push(Ring { polygon: self.polygons.len() as u32 - 1, is_hole: false });
            self.ring_of_segment[start..start + own.len()].fill(self.rings.len() as u32 - 1);
        }
        Ok(())
    }

    fn positions_in(&self, flat: &[f64]) -> u32 {
        (flat.len() / 2) as u32
    }

    /// What the ends of segments of one model at one place have in common, and no others of it.
    pub(super) fn place_key(&self, vertex: u32) -> [u64; 2] {
        let after = self.exact.partition_point(|part| part.place.first_point <= vertex as usize);
        let part = self.exact[..after].last().map(|part| (part, vertex as usize - part.place.first_point));
        match part.and_then(|(part, own)| part.place_numbers.get(own)) {
            Some(&number) => [u64::from(number), u64::MAX],
            // Zeros of both signs are equal.
            None => self.place(vertex).map(|x| (x + 0.0).to_bits()),
        }
    }

    /// The exact segments that a vertex or a segment is of, with its number there.
    fn exact_of(
        &self,
        at: usize,
        first: impl Fn(&ExactPlace) -> usize,
        count: impl Fn(&ExactSegments) -> usize,
    ) -> Option<(&ExactSegments, usize)> {
        let after = self.exact.partition_point(|part| first(&part.place) <= at);
        let place = &self.exact[..after].last()?.place;
        let own = at - first(place);
        (own < count(&place.segments)).then_some((&place.segments, own))
    }

    /// The support of a segment.
    fn support(&self, segment: usize) -> PlanarLine {
        match self.exact_of(segment, |place| place.first_segment, |own| own.pieces().len()) {
            Some((exact, piece)) => exact.line(exact.pieces()[piece].support),
            None => self.segments[segment].map(|end| self.place(end)),
        }
    }

    /// What a vertex is known by: a point, or two supports.
    fn definition(&self, source: &VertexSource) -> Result<[f64; 2], [PlanarLine; 2]> {
        match *source {
            VertexSource::Crossing(segments) => Err(segments.map(|segment| self.support(segment))),
            VertexSource::Given(vertex) => {
                match self.exact_of(vertex, |place| place.first_point, |own| own.vertices().len()) {
                    Some((exact, own)) => match exact.vertices()[own] {
                        ExactVertex::Point(point) => Ok(exact.points()[point as usize]),
                        ExactVertex::Crossing(supports) => Err(supports.map(|support| exact.line(support))),
                    },
                    None => Ok(self.place(vertex as u32)),
                }
            }
        }
    }

    /// Edges between vertices with these sources as exact segments, those that bound something first. Along an edge are these segments.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] beyond 2^31 points.
    fn exact_segments<'a>(
        &self,
        sources: &[VertexSource],
        edges: impl Iterator<Item = ([u32; 2], &'a [u32], bool)>,
    ) -> Result<ExactSegments, Error> {
        let definitions: Vec<Result<[f64; 2], [PlanarLine; 2]>> =
            sources.iter().map(|source| self.definition(source)).collect();
        let mut numbers = Numbers::default();
        let (mut pieces, mut shared) = (Vec::new(), Vec::new());
        for (ends, segments, is_shared) in edges {
            let line = self.covering(&definitions, ends, segments);
            let piece = ExactPiece { support: numbers.support(line), ends };
            if is_shared { &mut shared } else { &mut pieces }.push(piece);
        }
        let vertices = definitions.iter().map(|definition| match definition {
            Ok(point) => ExactVertex::Point(numbers.point(*point)),
            Err(lines) => ExactVertex::Crossing(lines.map(|line| numbers.support(line))),
        });
        let vertices = vertices.collect();
        ExactSegments::new(numbers.points, numbers.supports, vertices, pieces, shared)
    }

    /// A segment between given points that an edge is a part of.
    ///
    /// An edge may go on from one segment to another on the same line: then the points are the outermost ends of all of them.
    fn covering(
        &self,
        definitions: &[Result<[f64; 2], [PlanarLine; 2]>],
        ends: [u32; 2],
        segments: &[u32],
    ) -> PlanarLine {
        let lines = || segments.iter().map(|&segment| self.support(segment as usize));
        let first = lines().next().expect("a segment runs along each edge");
        if segments.len() == 1 {
            return first;
        }
        let ends = ends.map(|end| match definitions[end as usize] {
            Ok(point) => PlanarPoint::given(point),
            Err([s, t]) => PlanarPoint::crossing(s, t).expect("segments that cross are not parallel"),
        });
        lines().find(|&line| ends.iter().all(|end| is_between(end, line))).unwrap_or_else(|| {
            let below = |a: &[f64; 2], b: &[f64; 2]| (a[0], a[1]) < (b[0], b[1]);
            let points = || lines().flatten();
            let low = points().reduce(|a, b| if below(&b, &a) { b } else { a });
            let high = points().reduce(|a, b| if below(&a, &b) { b } else { a });
            [low.unwrap_or(first[0]), high.unwrap_or(first[1])]
        })
    }
}

/// Numbers of points and supports, by their first use.
#[derive(Default)]
struct Numbers {
    points: Vec<[f64; 2]>,
    supports: Vec<[u32; 2]>,
    point_numbers: HashMap<[u64; 2], u32>,
    support_numbers: HashMap<[u32; 2], u32>,
}

impl Numbers {
    fn point(&mut self, point: [f64; 2]) -> u32 {
        // Zeros of both signs are equal.
        let point = point.map(|x| x + 0.0);
        *self.point_numbers.entry(point.map(f64::to_bits)).or_insert_with(|| {
            self.points.push(point);
            self.points.len() as u32 - 1
        })
    }

    fn support(&mut self, line: PlanarLine) -> u32 {
        let ends = line.map(|point| self.point(point));
        let key = [ends[0].min(ends[1]), ends[0].max(ends[1])];
        *self.support_numbers.entry(key).or_insert_with(|| {
            self.supports.push(ends);
            self.supports.len() as u32 - 1
        })
    }
}

impl DrawingArrangement {
    /// The edges as they are before coordinates are rounded, for [`Model::with_exact_segments`]: none unless
    /// [`ArrangementRequest::exact`](super::ArrangementRequest::exact) asks for them, or if vertices were moved, as within a tolerance or on a
    /// grid. Edge e is piece e, and vertices have their numbers. Files of JSON have these pieces in another order: first the edges with a
    /// bounded face on one side alone, since the faces of a file are inside of it.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] beyond 2^31 points.
    ///
    /// # Complexity
    /// Linear, in exact decisions.
    ///
    /// # Examples
    /// Two segments that cross at a third.
    /// ```
    /// use coface_answers::{ArrangementRequest, DrawingArrangement, PlanarDrawing, RegionSource};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let crossed = coface_io::read(&b"0,0,3,1\n1,0,1,5\n"[..], coface_io::Format::Lines)?;
    /// let drawing = PlanarDrawing::new([("crossed", &crossed)], RegionSource::Models)?;
    /// let mut request = ArrangementRequest::default();
    /// request.exact = true;
    /// let arranged = DrawingArrangement::new(drawing, &request)?;
    /// let exact = arranged.exact_segments()?.expect("nothing was moved");
    /// assert_eq!((exact.supports().len(), exact.pieces().len()), (2, 4));
    /// # Ok(()) }
    /// ```
    pub fn exact_segments(&self) -> Result<Option<ExactSegments>, Error> {
        self.exact_edges(|_| false)
    }

    /// The same for a model of the faces: edges with bounded faces on both sides, or none, bound nothing.
    #[doc(hidden)]
    pub fn exact_segments_of_faces(&self) -> Result<Option<ExactSegments>, Error> {
        let is_bounded = |halfedge: u32| self.arrangement.face_of(HalfedgeId::from_u32(halfedge)).is_some();
        self.exact_edges(|edge| is_bounded(2 * edge) == is_bounded(2 * edge + 1))
    }

    fn exact_edges(&self, is_shared: impl Fn(u32) -> bool) -> Result<Option<ExactSegments>, Error> {
        if self.is_moved || !self.keeps_exact {
            return Ok(None);
        }
        let edges = (0..).zip(self.segments_of_edge.iter()).map(|(edge, segments)| {
            let ends = self.arrangement.ends(EdgeId::from_u32(edge)).map(VertexId::to_u32);
            (ends, segments, is_shared(edge))
        });
        self.drawing.exact_segments(&self.sources, edges).map(Some)
    }
}

impl RegionBoolean {
    /// The edges around the polygons as they are before coordinates are rounded, for [`Model::with_exact_segments`]: none unless
    /// [`BooleanRequest::exact`](super::BooleanRequest::exact) asks for them, or if vertices were moved. Edges between polygons, which
    /// [`BooleanRequest::keep_walls`](super::BooleanRequest::keep_walls) keeps, are shared.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] beyond 2^31 points.
    ///
    /// # Complexity
    /// Linear, in exact decisions.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{BooleanRequest, PlanarDrawing, RegionBoolean, RegionSource};
    /// use coface_arrange::boolean::BooleanFormula;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = coface_io::read(&b"POLYGON ((0 0, 3 0, 0 3, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let drawing = PlanarDrawing::new([("triangle", &triangle)], RegionSource::Models)?;
    /// let mut request = BooleanRequest::default();
    /// request.exact = true;
    /// let same = RegionBoolean::new(drawing, &BooleanFormula::union(1), &request)?;
    /// assert_eq!(same.exact_segments()?.expect("nothing was moved").supports().len(), 3);
    /// # Ok(()) }
    /// ```
    pub fn exact_segments(&self) -> Result<Option<ExactSegments>, Error> {
        if self.is_moved() || !self.keeps_exact {
            return Ok(None);
        }
        let found = &self.found;
        let mut side_counts = vec![0u8; found.edges.len()];
        if found.has_walls {
            for ring in found.outline.rings.iter() {
                for (i, &from) in ring.iter().enumerate() {
                    let to = ring[if i + 1 == ring.len() { 0 } else { i + 1 }];
                    let edge = found.edges.binary_search(&[from.min(to), from.max(to)]);
                    side_counts[edge.expect("the sides of rings are edges")] += 1;
                }
            }
        }
        let edges = found.edges.iter().zip(found.segments_of_edge.iter()).zip(&side_counts);
        let edges = edges.map(|((&ends, segments), &count)| (ends, segments, count > 1));
        self.drawing.exact_segments(&found.sources, edges).map(Some)
    }
}

/// The faces that some arrangement has of a formula, as polygons.
pub(super) struct SelectedFaces {
    pub(super) rings: RaggedArray,
    pub(super) polygons: RaggedArray,
    /// The vertices of the arrangement, rising.
    pub(super) vertices: Vec<u32>,
    pub(super) edges: Vec<[u32; 2]>,
    pub(super) segments_of_edge: RaggedArray,
    pub(super) areas: Vec<f64>,
    pub(super) component_count: usize,
    pub(super) pinches: Vec<VertexId>,
    /// The polygon of each face.
    pub(super) polygon_of_face: Vec<Option<usize>>,
}

impl SelectedFaces {
    /// The polygons of selected faces, on the vertices that they have.
    pub(super) fn new(arrangement: &PlanarArrangement, is_selected: &[bool], keeps_walls: bool) -> Self {
        let outline = arrangement.outline(is_selected, keeps_walls);
        let mut vertices = outline.rings().items().to_vec();
        vertices.sort_unstable();
        vertices.dedup();
        let number = |vertex: u32| vertices.partition_point(|&own| own < vertex) as u32;
        let rings = RaggedArray::from_lists(
            outline.rings().iter().map(|ring| ring.iter().map(|&vertex| number(vertex)).collect::<Vec<_>>()),
        );
        let mut sides: Vec<([u32; 2], u32)> = Vec::with_capacity(rings.item_count());
        for ring in rings.iter() {
            for (i, &from) in ring.iter().enumerate() {
                let to = ring[if i + 1 == ring.len() { 0 } else { i + 1 }];
                sides.push(([from.min(to), from.max(to)], sides.len() as u32));
            }
        }
        sides.sort_unstable();
        let (mut edges, mut segments_of_edge) = (Vec::with_capacity(sides.len()), RaggedArray::new());
        for same in sides.chunk_by(|a, b| a.0 == b.0) {
            edges.push(same[0].0);
            let along = same.iter().flat_map(|&(_, side)| outline.edges_of_sides().list(side as usize));
            segments_of_edge.push(&arrangement.segments_along(along.map(|&edge| EdgeId::from_u32(edge))));
        }
        let pinches =
            outline.pinches().iter().map(|vertex| VertexId::from_u32(number(vertex.to_u32()))).collect();
        let faces = (0..arrangement.face_count()).map(FaceId::new);
        Self {
            rings,
            polygons: outline.polygons().clone(),
            edges,
            segments_of_edge,
            areas: outline.areas(arrangement),
            component_count: outline.component_count(),
            pinches,
            polygon_of_face: faces.map(|face| outline.polygon_of_face(face)).collect(),
            vertices,
        }
    }
}
