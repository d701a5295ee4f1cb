//! What models draw in the plane: segments, rings, polygons and regions.

use super::chain_faces::{ChainFaces, has_faces};
use super::drawing_options::DrawingOptions;
use super::exact::{ExactPart, points_rounded};
use super::fill_rules::FillRules;
use super::properties::DrawnFeatures;
use crate::RegionSource;
use crate::answer::{DrawingInput, Place, Remark, RemarkCode, VertexOrigin, remarks_of_file};
use crate::text;
use coface_algebra::{Error, ErrorKind, UnionFind, VertexId};
use coface_arrange::boolean::InsideRule;
use coface_arrange::planar::VertexSource;
use coface_geometry::Positions;
use coface_geometry::predicates::orientation;
use coface_io::{
    Features, Format, GroupKind, Model, ReferenceSystem, Shape, Structure, features_of_shapes, shapes,
};
use std::collections::BTreeMap;

/// A segment that is in no ring.
pub(super) const NO_RING: u32 = u32::MAX;
/// The feature of what is of none with properties.
pub(super) const NO_FEATURE: u32 = u32::MAX;

/// Segments in the plane with the model that each is of, and the regions that rings of them bound.
///
/// # Examples
/// ```
/// use coface_io as io;
/// use coface_io::Format;
/// use coface_answers::{PlanarDrawing, RegionSource};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let square = io::read(&b"POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))"[..], Format::Wkt)?;
/// let cut = io::read(&b"0.5,-1,0.5,2\n"[..], Format::Lines)?;
/// let drawing = PlanarDrawing::new([("square", &square), ("cut", &cut)], RegionSource::Models)?;
/// assert_eq!((drawing.segments().len(), drawing.region_names().len()), (5, 2));
/// assert_eq!(drawing.segment_source(4), (1, 0));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, Default)]
pub struct PlanarDrawing {
    pub(super) names: Vec<String>,
    pub(super) positions: Positions,
    /// The heights of the vertices, NaN for those of models without; empty if no model has some.
    pub(super) heights: Vec<f64>,
    /// The reference system of the models that name one.
    pub(super) reference: Option<ReferenceSystem>,
    /// The first vertex of each model, and of none behind the last.
    pub(super) vertex_starts: Vec<u32>,
    pub(super) segments: Vec<[u32; 2]>,
    /// The models that are known exactly, whose vertices are rounded here.
    pub(super) exact: Vec<ExactPart>,
    pub(super) segment_starts: Vec<u32>,
    pub(super) ring_of_segment: Vec<u32>,
    pub(super) rings: Vec<Ring>,
    pub(super) polygons: Vec<Polygon>,
    pub(super) regions: Vec<Region>,
    pub(super) features: DrawnFeatures,
    /// The lines that end where they begin and bound nothing.
    pub(super) closed_line_count: usize,
    /// The segments of exact models that have one thing on both sides: no lines of their own.
    pub(super) shared_segment_count: usize,
    /// The number of points of their own.
    pub(super) point_count: usize,
    /// Those of the models.
    pub(super) remarks: Vec<Remark>,
}

/// A closed walk of segments.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ring {
    pub(super) polygon: u32,
    pub(super) is_hole: bool,
}

/// Rings that bound one set.
#[derive(Clone, Copy, Debug)]
pub(super) struct Polygon {
    pub(super) region: u32,
    /// Its feature among those of all models.
    pub(super) feature: u32,
    pub(super) filling: Filling,
    /// Its place among the polygons of its model.
    pub(super) number: u32,
}

/// What is inside of a polygon.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Filling {
    /// What is inside of the outer ring and of no hole, whatever the directions of the rings are.
    OuterWithoutHoles,
    /// What all rings together wind around as the drawing says.
    Stated(InsideRule),
    /// Lines without directions: the parity.
    Lines,
}

/// The polygons that are one operand.
#[derive(Clone, Debug)]
pub(super) struct Region {
    pub(super) name: String,
    pub(super) model: u32,
    /// A vertex at which lines of a model without polygons end, of all vertices.
    pub(super) open_at: Option<u32>,
    pub(super) is_empty: bool,
}

/// Whether a model lies in the plane: its points have two coordinates, or a third that is zero, and it has no 3-cells; or it is a
/// map of lines and polygons with holes, such as WKT and GeoJSON have, whose heights are carried along.
///
/// # Examples
/// ```
/// use coface_io as io;
/// use coface_io::Format;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let flat = io::read(&b"v 0 0 0\nv 1 0 0\nl 1 2\n"[..], Format::Obj)?;
/// let steep = io::read(&b"v 0 0 0\nv 1 0 2\nl 1 2\n"[..], Format::Obj)?;
/// assert!(coface_answers::is_planar(&flat) && !coface_answers::is_planar(&steep));
/// # Ok(()) }
/// ```
pub fn is_planar(model: &Model) -> bool {
    let positions = model.positions();
    model.cells().is_empty()
        && match positions.dimension() {
            2 => true,
            3 if model.is_map_with_heights() => true,
            3 => positions.as_flat().iter().skip(2).step_by(3).all(|&height| height == 0.0),
            dimension => dimension == 0 && model.is_empty(),
        }
}

/// Whether models are a drawing in the plane: all of them are, but for empty ones, which are the empty set in space as
/// well. If all are empty, they are a drawing, but for chain complexes with a degree 3.
///
/// # Complexity
/// As [`is_planar`].
///
/// # Examples
/// ```
/// use coface_io as io;
/// use coface_io::Format;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let nothing = io::read(&b"OFF\n0 0 0\n"[..], Format::Off)?;
/// let triangle = io::read(&b"v 0 0 0\nv 1 0 0\nv 0 1 2\nf 1 2 3\n"[..], Format::Obj)?;
/// assert!(coface_answers::are_planar([&nothing]) && !coface_answers::are_planar([&nothing, &triangle]));
/// # Ok(()) }
/// ```
pub fn are_planar<'a>(models: impl IntoIterator<Item = &'a Model>) -> bool {
    let (mut is_drawn, mut is_in_space) = (false, false);
    for model in models {
        if model.is_empty() {
            is_in_space |=
                matches!(model.structure(), Some(Structure::Chains(complex)) if complex.degree_count() > 3);
        } else if is_planar(model) {
            is_drawn = true;
        } else {
            return false;
        }
    }
    is_drawn || !is_in_space
}

impl PlanarDrawing {
    /// The drawing of models with their names.
    ///
    /// Lines, then the sides of the polygons, are the segments of a model, in its order. A polygon with holes (rings of GeoJSON,
    /// WKT, SVG) is one polygon, a polygon of a mesh is another, and so is a face of a chain complex with positions, whose edges that are
    /// in no face come first.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] with the name of a model that does not lie in the plane, has 3-cells or no positions;
    /// [`ErrorKind::UnsupportedFormat`] for an abstract structure that is no chain complex with positions;
    /// [`ErrorKind::TooLarge`] beyond 2^31 vertices or segments.
    ///
    /// # Complexity
    /// Linear, and $O(n \log n)$ for the n ends of lines of models without polygons.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{PlanarDrawing, RegionSource};
    /// let square = coface_io::read(&b"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let cut = coface_io::read(&b"1,-1,1,3\n"[..], coface_io::Format::Lines)?;
    /// let drawing = PlanarDrawing::new([("square", &square), ("cut", &cut)], RegionSource::Models)?;
    /// assert_eq!(drawing.segments().len(), 4 + 1);
    /// # Ok(()) }
    /// ```
    pub fn new<'a>(
        models: impl IntoIterator<Item = (&'a str, &'a Model)>,
        source: RegionSource,
    ) -> Result<Self, Error> {
        Self::with_options(models, &DrawingOptions::new().source(source))
    }

    /// The same with options.
    ///
    /// # Errors
    /// Those of [`Self::new`].
    ///
    /// # Examples
    /// A closed line of a map is a line, or else a ring.
    /// ```
    /// use coface_answers::{DrawingOptions, PlanarDrawing};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let ring = coface_io::read(&b"LINESTRING (0 0, 2 0, 2 2, 0 0)"[..], coface_io::Format::Wkt)?;
    /// let unbounded = |close_lines: bool| {
    ///     let options = DrawingOptions::new().close_lines(close_lines);
    ///     PlanarDrawing::with_options([("ring", &ring)], &options).map(|drawing| drawing.unbounded_segment_count())
    /// };
    /// assert_eq!((unbounded(false)?, unbounded(true)?), (3, 0));
    /// # Ok(()) }
    /// ```
    pub fn with_options<'a>(
        models: impl IntoIterator<Item = (&'a str, &'a Model)>,
        options: &DrawingOptions,
    ) -> Result<Self, Error> {
        let mut drawing = Self { vertex_starts: vec![0], segment_starts: vec![0], ..Self::default() };
        let mut flat = Vec::new();
        let models: Vec<(&str, &Model)> = models.into_iter().collect();
        for &(name, model) in &models {
            drawing.add(name, model, options, &mut flat).map_err(|error| error.in_file(name))?;
        }
        if drawing.heights.iter().all(|height| height.is_nan()) {
            drawing.heights.clear();
        }
        let systems = models.iter().map(|&(name, model)| (name, model.reference_system()));
        if let Some((system, without)) = ReferenceSystem::common(systems)? {
            drawing.reference = Some(system.clone());
            if let Some(first) = without.first() {
                let others = match without.len() {
                    1 => String::new(),
                    count => format!(" (and {} more)", text::count(count - 1, "input")),
                };
                let message = format!(
                    "{first}{others} names no reference system, and is taken to be in {system} as the others are"
                );
                drawing
                    .remarks
                    .push(Remark::new(RemarkCode::ReferenceAssumed, message).at(without.len(), []));
            }
        }
        drawing.positions = Positions::from_flat(2, flat)?;
        drawing.remarks.extend(drawing.remark_of_flat_polygons(Filling::OuterWithoutHoles));
        Ok(drawing)
    }

    /// That polygons of this filling have no area, seen from above: all corners of each are on one line.
    fn remark_of_flat_polygons(&self, filling: Filling) -> Option<Remark> {
        let flat: Vec<u32> = (self.ring_of_segment.chunk_by(|a, b| a == b))
            .scan(0, |start, ring| {
                let segments = &self.segments[*start..*start + ring.len()];
                *start += ring.len();
                Some((ring[0], segments))
            })
            .filter(|&(ring, _)| ring != NO_RING && !self.rings[ring as usize].is_hole)
            .filter(|(ring, _)| {
                let polygon = self.polygons[self.rings[*ring as usize].polygon as usize];
                polygon.filling == filling
            })
            .filter(|(_, segments)| self.are_on_one_line(segments))
            .map(|(_, segments)| segments[0][0])
            .collect();
        let (first, count) = (*flat.first()?, flat.len());
        let [x, y] = self.place(first);
        let what = if filling == Filling::Lines { "closed line" } else { "polygon" };
        let message = match count {
            1 => format!("the {what} at ({x}, {y}) has no area in the plane and bounds nothing"),
            _ => format!(
                "{count} {what}s, the first at ({x}, {y}), have no area in the plane and bound nothing"
            ),
        };
        let places = flat.iter().map(|&vertex| Place::point(&self.place(vertex)));
        Some(Remark::new(RemarkCode::UnboundedSegments, message).at(count, places))
    }

    /// Whether the ends of these segments are on one line.
    fn are_on_one_line(&self, segments: &[[u32; 2]]) -> bool {
        let places = || segments.iter().flatten().map(|&end| self.place(end));
        let Some(first) = places().next() else { return true };
        let Some(second) = places().find(|&place| place != first) else { return true };
        places().all(|place| orientation(first, second, place).is_eq())
    }

    /// The same without heights, and a remark if there were some.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{BooleanRequest, PlanarDrawing, RegionBoolean, RegionSource};
    /// use coface_arrange::boolean::BooleanFormula;
    /// let roof = coface_io::read(&b"POLYGON Z ((0 0 5, 2 0 5, 2 2 7, 0 0 5))"[..], coface_io::Format::Wkt)?;
    /// let drawing = PlanarDrawing::new([("roof", &roof)], RegionSource::Models)?.without_heights();
    /// let result = RegionBoolean::new(drawing, &BooleanFormula::union(1), &BooleanRequest::default())?;
    /// let mut text = Vec::new();
    /// result.write(&mut text, coface_io::Format::Wkt)?;
    /// assert_eq!(text, b"POLYGON ((0 0, 2 0, 2 2, 0 0))\n");
    /// # Ok(()) }
    /// ```
    pub fn without_heights(mut self) -> Self {
        let count = self.heights.iter().filter(|height| !height.is_nan() && **height != 0.0).count();
        if count > 0 {
            let message = format!("the heights of {} are left out", text::count(count, "vertex"));
            self.remarks.push(Remark::new(RemarkCode::HeightsLeftOut, message).at(count, []));
        }
        self.heights.clear();
        self
    }

    fn add(
        &mut self,
        name: &str,
        model: &Model,
        options: &DrawingOptions,
        flat: &mut Vec<f64>,
    ) -> Result<(), Error> {
        let source = options.source;
        if let Some(exact) = model.exact_segments() {
            let is_of_lines =
                matches!(model.structure(), Some(Structure::Chains(complex)) if !has_faces(complex));
            let rounds = match source {
                _ if options.rounds_exact => Some("it is taken as a map"),
                _ if source == RegionSource::Models || is_of_lines => None,
                _ => Some("its parts are inputs of their own"),
            };
            match rounds {
                None => {
                    ShapeLabels::new(name, model, source)?;
                    return self.add_exact(name, model, exact, source, flat);
                }
                Some(why) => self.remarks.push(points_rounded(name, why)),
            }
        }
        if let Some(coarse) = model.coarse()? {
            return self.add(name, &coarse, options, flat);
        }
        check_plane(model)?;
        let first = self.vertex_starts.last().copied().unwrap_or(0);
        let number = self.names.len() as u32;
        if first as usize + model.vertex_count() >= 1 << 31 {
            return Err(Error::new(ErrorKind::TooLarge, "more than 2^31 vertices in all"));
        }
        self.names.push(name.to_owned());
        self.remarks.extend(remarks_of_file(name, model));
        self.point_count += model.points().len();
        self.vertex_starts.push(first + model.vertex_count() as u32);
        let dimension = model.positions().dimension();
        let points = || model.positions().as_flat().chunks_exact(dimension.max(1));
        if dimension == 2 {
            flat.extend_from_slice(model.positions().as_flat());
        } else {
            points().for_each(|point| flat.extend_from_slice(&point[..2]));
        }
        if model.is_map_with_heights() {
            self.heights.extend(points().map(|point| point[2]));
        } else {
            self.heights.resize(flat.len() / 2, f64::NAN);
        }
        let mut regions =
            Regions { source, number, name, of_group: BTreeMap::new(), last_feature: None, feature_count: 0 };
        let features = Features::new(model);
        let labels = ShapeLabels::new(name, model, source)?;
        if source == RegionSource::Models {
            self.regions.push(Region { name: name.to_owned(), model: number, open_at: None, is_empty: true });
        }
        let first_feature = self.features.add_table(model.features(), self.segments.len())?;
        let mut polygon_number = 0;
        let fill_rules = FillRules::of(model);
        let shapes = shapes(model);
        for (feature, (shape, group)) in features_of_shapes(model, &shapes).into_iter().zip(shapes) {
            let described = self.features.described(first_feature, feature);
            // The corners of a line that has fewer have no inside.
            let is_closed = |line: &[u32]| line.len() > 3 && line.first() == line.last();
            let shape = match shape {
                Shape::Line(line) if options.close_lines && is_closed(model.lines().list(line)) => {
                    Shape::Rings(line..line + 1)
                }
                shape => shape,
            };
            if let Shape::Line(line) = shape {
                self.closed_line_count += usize::from(is_closed(model.lines().list(line)));
            }
            let filling = match &shape {
                Shape::Rings(lines) => {
                    fill_rules.of_polygon(lines).map_or(Filling::OuterWithoutHoles, Filling::Stated)
                }
                _ => Filling::OuterWithoutHoles,
            };
            if matches!(shape, Shape::Rings(_) | Shape::Face(_)) {
                let region = match labels.name(model, &shape) {
                    Some(label) => regions.region_of(self, Some(&label), None),
                    None => {
                        let name = group.map(|group| model.groups()[group].name());
                        regions.region_of(self, name, features.of(&shape))
                    }
                };
                self.regions[region as usize].is_empty = false;
                self.polygons.push(Polygon { region, feature: described, filling, number: polygon_number });
                polygon_number += 1;
            }
            match shape {
                Shape::Line(i) => self.path(first, model.lines().list(i).iter().copied(), NO_RING)?,
                Shape::Rings(lines) => {
                    for (i, line) in lines.enumerate() {
                        let ring = self.begin_ring(i > 0);
                        self.path(first, model.lines().list(line).iter().copied(), ring)?;
                    }
                }
                Shape::Face(i) => {
                    let ring = self.begin_ring(false);
                    let polygon = model.polygons().list(i);
                    self.path(first, polygon.iter().chain(polygon.first()).copied(), ring)?;
                }
                Shape::Point(vertex) => self.features.add_point(described, first + vertex.to_u32()),
            }
            self.features.extend_to(self.segments.len(), described);
        }
        if let Some(Structure::Chains(complex)) = model.structure() {
            let chains = ChainFaces::new(complex)?;
            for (ends, _) in chains.edges.iter().zip(&chains.is_side).filter(|(_, is_side)| !**is_side) {
                self.path(first, ends.iter().copied(), NO_RING)?;
            }
            for own in chains.faces.iter() {
                let corner = own.first().map(|&own| chains.loops.list(own as usize)[0]);
                let label = corner.and_then(|corner| labels.name_at(corner));
                let region = regions.region_of(self, label.as_deref(), None);
                self.regions[region as usize].is_empty &= own.is_empty();
                let filling = Filling::OuterWithoutHoles;
                self.polygons.push(Polygon { region, feature: NO_FEATURE, filling, number: polygon_number });
                polygon_number += 1;
                for &own in own {
                    let ring = self.begin_ring(false);
                    let corners = chains.loops.list(own as usize);
                    self.path(first, corners.iter().chain(corners.first()).copied(), ring)?;
                }
            }
        }
        self.features.extend_to(self.segments.len(), NO_FEATURE);
        let start = self.segment_starts.last().copied().unwrap_or(0);
        self.segment_starts.push(self.segments.len() as u32);
        let is_map = model.format().is_some_and(Format::keeps_heights);
        if polygon_number == 0 && !is_map && self.segments.len() > start as usize {
            self.region_of_lines(model, start, first, &mut regions);
        }
        Ok(())
    }

    /// Lines of a model without polygons: a region if none of them ends.
    fn region_of_lines(&mut self, model: &Model, start: u32, first: u32, regions: &mut Regions<'_>) {
        let place = |vertex: u32| {
            let point = &model.positions().point(VertexId::from_u32(vertex - first))[..2];
            // Zeros of both signs are equal.
            [point[0] + 0.0, point[1] + 0.0].map(f64::to_bits)
        };
        let mut ends: Vec<([u64; 2], u32)> = self.segments[start as usize..]
            .as_flattened()
            .iter()
            .map(|&vertex| (place(vertex), vertex))
            .collect();
        ends.sort_unstable();
        let odd = ends.chunk_by(|a, b| a.0 == b.0).find(|group| group.len() % 2 == 1);
        let region = regions.region_of(self, None, None);
        if let Some(group) = odd {
            self.regions[region as usize].open_at = Some(group[0].1);
            return;
        }
        self.regions[region as usize].is_empty = false;
        let feature = self.features.only_one_from(start);
        self.polygons.push(Polygon { region, feature, filling: Filling::Lines, number: 0 });
        self.rings.push(Ring { polygon: self.polygons.len() as u32 - 1, is_hole: false });
        self.ring_of_segment[start as usize..].fill(self.rings.len() as u32 - 1);
    }

    fn begin_ring(&mut self, is_hole: bool) -> u32 {
        self.rings.push(Ring { polygon: self.polygons.len() as u32 - 1, is_hole });
        self.rings.len() as u32 - 1
    }

    fn path(&mut self, first: u32, path: impl Iterator<Item = u32>, ring: u32) -> Result<(), Error> {
        let mut last = None;
        for vertex in path {
            if let Some(last) = last {
                self.segments.push([first + last, first + vertex]);
                self.ring_of_segment.push(ring);
            }
            last = Some(vertex);
        }
        if self.segments.len() >= 1 << 31 {
            return Err(Error::new(ErrorKind::TooLarge, "more than 2^31 segments in all"));
        }
        Ok(())
    }

    /// The names of the models.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{PlanarDrawing, RegionSource};
    /// let square = coface_io::read(&b"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let cut = coface_io::read(&b"1,-1,1,3\n"[..], coface_io::Format::Lines)?;
    /// let drawing = PlanarDrawing::new([("square", &square), ("cut", &cut)], RegionSource::Models)?;
    /// assert_eq!(drawing.names(), ["square", "cut"]);
    /// # Ok(()) }
    /// ```
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// The positions of the vertices of all models, one model after the other.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{PlanarDrawing, RegionSource};
    /// let square = coface_io::read(&b"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let cut = coface_io::read(&b"1,-1,1,3\n"[..], coface_io::Format::Lines)?;
    /// let drawing = PlanarDrawing::new([("square", &square), ("cut", &cut)], RegionSource::Models)?;
    /// assert_eq!(drawing.positions().len(), 4 + 2);
    /// # Ok(()) }
    /// ```
    pub fn positions(&self) -> &Positions {
        &self.positions
    }

    /// The segments of all models, one model after the other, by the positions of their ends.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{PlanarDrawing, RegionSource};
    /// let square = coface_io::read(&b"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let cut = coface_io::read(&b"1,-1,1,3\n"[..], coface_io::Format::Lines)?;
    /// let drawing = PlanarDrawing::new([("square", &square), ("cut", &cut)], RegionSource::Models)?;
    /// assert_eq!(drawing.segments()[4], [4, 5]);
    /// # Ok(()) }
    /// ```
    pub fn segments(&self) -> &[[u32; 2]] {
        &self.segments
    }

    /// The model that a segment is of, and its place among the segments of that model.
    ///
    /// # Panics
    /// If there is no such segment.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{PlanarDrawing, RegionSource};
    /// let square = coface_io::read(&b"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let cut = coface_io::read(&b"1,-1,1,3\n"[..], coface_io::Format::Lines)?;
    /// let drawing = PlanarDrawing::new([("square", &square), ("cut", &cut)], RegionSource::Models)?;
    /// assert_eq!(drawing.segment_source(4), (1, 0), "the first of the second drawing");
    /// # Ok(()) }
    /// ```
    pub fn segment_source(&self, segment: usize) -> (usize, usize) {
        assert!(segment < self.segments.len(), "there are {} segments", self.segments.len());
        source_in(&self.segment_starts, segment)
    }

    /// The model that a vertex is of, and its place among the vertices of that model.
    ///
    /// # Panics
    /// If there is no such vertex.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_algebra::VertexId;
    /// use coface_answers::{PlanarDrawing, RegionSource};
    /// let square = coface_io::read(&b"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let cut = coface_io::read(&b"1,-1,1,3\n"[..], coface_io::Format::Lines)?;
    /// let drawing = PlanarDrawing::new([("square", &square), ("cut", &cut)], RegionSource::Models)?;
    /// assert_eq!(drawing.vertex_source(VertexId::new(5)), (1, 1), "the second of the second drawing");
    /// # Ok(()) }
    /// ```
    pub fn vertex_source(&self, vertex: VertexId) -> (usize, usize) {
        let vertex = vertex.index();
        assert!(vertex < self.positions.len(), "there are {} vertices", self.positions.len());
        source_in(&self.vertex_starts, vertex)
    }

    /// The names of the regions.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{PlanarDrawing, RegionSource};
    /// let square = coface_io::read(&b"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let cut = coface_io::read(&b"1,-1,1,3\n"[..], coface_io::Format::Lines)?;
    /// let drawing = PlanarDrawing::new([("square", &square), ("cut", &cut)], RegionSource::Models)?;
    /// assert_eq!(drawing.region_names(), ["square", "cut"]);
    /// # Ok(()) }
    /// ```
    pub fn region_names(&self) -> Vec<&str> {
        self.regions.iter().map(|region| region.name.as_str()).collect()
    }

    /// The number of features of all models, one model after the other: 0 where none has properties.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{PlanarDrawing, RegionSource};
    /// let text = br#"{"type": "Feature", "properties": {"use": "wood"}, "geometry":
    ///     {"type": "Polygon", "coordinates": [[[0, 0], [2, 0], [2, 1], [0, 0]]]}}"#;
    /// let wood = coface_io::read(&text[..], coface_io::Format::GeoJson)?;
    /// let drawing = PlanarDrawing::new([("wood", &wood)], RegionSource::Models)?;
    /// assert_eq!(drawing.feature_count(), 1);
    /// # Ok(()) }
    /// ```
    pub fn feature_count(&self) -> usize {
        self.features.count()
    }

    /// The properties of a feature as its file has them, the text of a JSON object.
    ///
    /// # Panics
    /// If there is no such feature.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{PlanarDrawing, RegionSource};
    /// let text = br#"{"type": "Feature", "properties": {"use": "wood"}, "geometry":
    ///     {"type": "Polygon", "coordinates": [[[0, 0], [2, 0], [2, 1], [0, 0]]]}}"#;
    /// let wood = coface_io::read(&text[..], coface_io::Format::GeoJson)?;
    /// let drawing = PlanarDrawing::new([("wood", &wood)], RegionSource::Models)?;
    /// assert_eq!(drawing.properties_of_feature(0), r#"{"use":"wood"}"#);
    /// # Ok(()) }
    /// ```
    pub fn properties_of_feature(&self, feature: usize) -> &str {
        self.features.properties(feature as u32)
    }

    /// The number of segments that bound no polygon.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{PlanarDrawing, RegionSource};
    /// let square = coface_io::read(&b"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let cut = coface_io::read(&b"1,-1,1,3\n"[..], coface_io::Format::Lines)?;
    /// let drawing = PlanarDrawing::new([("square", &square), ("cut", &cut)], RegionSource::Models)?;
    /// assert_eq!(drawing.unbounded_segment_count(), 1);
    /// # Ok(()) }
    /// ```
    pub fn unbounded_segment_count(&self) -> usize {
        self.ring_of_segment.iter().filter(|&&ring| ring == NO_RING).count()
    }

    /// What is said where parts of a drawing bound nothing, and where a rule does not apply.
    pub(super) fn remarks_of_lines(&self, rule: Option<InsideRule>, is_region: bool) -> Vec<Remark> {
        let mut remarks = Vec::new();
        let count = self.unbounded_segment_count() - self.shared_segment_count;
        let closed = self.closed_line_count;
        if count > 0 && is_region {
            let cure = match closed {
                0 => String::new(),
                1 => "; 1 line is closed: --close takes closed lines as rings".to_owned(),
                _ => format!("; {closed} lines are closed: --close takes closed lines as rings"),
            };
            let segments = text::count(count, "segment");
            let message = format!("{segments} of lines bound nothing and are passed over{cure}");
            remarks.push(Remark::new(RemarkCode::UnboundedSegments, message).at(count, []));
        }
        if self.point_count > 0 && is_region {
            let count = self.point_count;
            let message = format!("{} left out: a point bounds nothing", text::count(count, "point"));
            remarks.push(Remark::new(RemarkCode::UnboundedSegments, message).at(count, []));
        }
        // Lines that enclose nothing are lines still, unless an inside is asked for.
        remarks.extend(self.remark_of_flat_polygons(Filling::Lines).filter(|_| is_region));
        let by_parity = self.polygons.iter().filter(|polygon| polygon.filling == Filling::Lines).count();
        if by_parity > 0 && rule.is_some_and(|rule| rule != InsideRule::Odd) {
            let message = format!(
                "what lines without polygons enclose an odd number of times is inside: the rule does not apply to {}",
                text::count(by_parity, "input")
            );
            remarks.push(Remark::new(RemarkCode::DrawingAssumption, message).at(by_parity, []));
        }
        remarks
    }

    /// The models with how much they draw.
    pub(super) fn input_answers(&self) -> Vec<DrawingInput> {
        let mut polygon_counts = vec![0; self.names.len()];
        for polygon in &self.polygons {
            polygon_counts[self.regions[polygon.region as usize].model as usize] += 1;
        }
        let models = self.names.iter().zip(polygon_counts).enumerate();
        models
            .map(|(model, (name, polygons))| DrawingInput {
                file: name.clone(),
                segments: (self.segment_starts[model + 1] - self.segment_starts[model]) as usize,
                polygons,
            })
            .collect()
    }

    /// The source of a vertex of a result, by inputs.
    pub(super) fn vertex_origin(&self, source: &VertexSource) -> VertexOrigin {
        match *source {
            VertexSource::Given(vertex) => VertexOrigin::Vertex(self.vertex_source(VertexId::new(vertex))),
            VertexSource::Crossing(segments) => {
                VertexOrigin::Segments(segments.map(|segment| self.segment_source(segment)))
            }
        }
    }

    /// `NotACycle` naming a region of open lines, or `InvalidInput` naming one of nothing that has an inside.
    pub(super) fn check_regions(&self) -> Result<(), Error> {
        let is_empty = self.regions.iter().all(|region| region.is_empty && region.open_at.is_none());
        if is_empty && !self.segments.is_empty() {
            let fault = Error::invalid("the inputs have lines and no polygons, and lines bound nothing");
            return Err(fault.with_cure(match self.closed_line_count {
                0 => "give polygons, or lines that end where they begin",
                _ => "take closed lines as rings with --close, or give polygons",
            }));
        }
        for region in &self.regions {
            let file = |error: Error| error.in_file(self.names[region.model as usize].clone());
            if let Some(vertex) = region.open_at {
                let [x, y] = self.place(vertex);
                return Err(file(
                    Error::new(
                        ErrorKind::NotACycle,
                        format!("lines end at ({x}, {y}), so they have no inside"),
                    )
                    .with_cure("close them, or give polygons: only what is closed can be combined"),
                ));
            }
        }
        Ok(())
    }

    /// What a ring is called within its model.
    pub(super) fn ring_name(&self, ring: u32) -> String {
        let polygon = self.rings[ring as usize].polygon;
        let first = self.rings.partition_point(|other| other.polygon < polygon);
        let number = self.polygons[polygon as usize].number;
        match ring as usize - first {
            0 => format!("polygon {number}"),
            hole => format!("hole {hole} of polygon {number}"),
        }
    }

    /// The name of the model that a ring is of.
    pub(super) fn model_of_ring(&self, ring: u32) -> &str {
        let polygon = self.polygons[self.rings[ring as usize].polygon as usize];
        &self.names[self.regions[polygon.region as usize].model as usize]
    }

    /// The coordinates of a vertex.
    pub(super) fn place(&self, vertex: u32) -> [f64; 2] {
        let point = self.positions.point(VertexId::from_u32(vertex));
        [point[0], point[1]]
    }
}

fn source_in(starts: &[u32], at: usize) -> (usize, usize) {
    let model = starts.partition_point(|&start| start as usize <= at) - 1;
    (model, at - starts[model] as usize)
}

/// Which region a polygon of one model is of.
struct Regions<'a> {
    source: RegionSource,
    number: u32,
    name: &'a str,
    of_group: BTreeMap<String, u32>,
    /// The feature of the last polygon, if it is known, and the region of it.
    last_feature: Option<(i64, u32)>,
    /// The number of features that have polygons.
    feature_count: u32,
}

impl Regions<'_> {
    /// The region of a polygon of a named group, or of a feature; of its own if it has neither.
    fn region_of(&mut self, drawing: &mut PlanarDrawing, group: Option<&str>, feature: Option<i64>) -> u32 {
        let count = drawing.regions.len() as u32;
        if self.source == RegionSource::Models {
            return count - 1;
        }
        let known = self.last_feature.filter(|&(last, _)| feature == Some(last));
        self.feature_count += u32::from(known.is_none());
        let name = match group {
            Some(group) => match self.of_group.get(group) {
                Some(&region) => {
                    self.last_feature = feature.map(|feature| (feature, region));
                    return region;
                }
                None => {
                    self.of_group.insert(group.to_owned(), count);
                    group.to_owned()
                }
            },
            None => {
                if let Some((_, region)) = known {
                    return region;
                }
                format!("{}#{}", self.name, self.feature_count - 1)
            }
        };
        self.last_feature = feature.map(|feature| (feature, count));
        drawing.regions.push(Region { name, model: self.number, open_at: None, is_empty: true });
        count
    }
}

/// The names of the polygons of one model where its objects, groups or components are regions.
enum ShapeLabels<'a> {
    /// Files or features are regions.
    Unlabeled,
    /// The first such group of each line and of each polygon, and the name of what is in none.
    Groups { of_lines: Vec<Option<usize>>, of_polygons: Vec<Option<usize>>, rest: &'a str },
    /// The component of each vertex, and the name of the file.
    Components { of_vertices: Vec<u32>, file: &'a str },
}

impl<'a> ShapeLabels<'a> {
    fn new(file: &'a str, model: &Model, source: RegionSource) -> Result<Self, Error> {
        if source == RegionSource::Components {
            return Ok(Self::Components { of_vertices: connected_vertices(model), file });
        }
        let Some(role) = source.role() else { return Ok(Self::Unlabeled) };
        let mut is_there = false;
        let mut first = |kind: GroupKind, count: usize| {
            let mut first = vec![None; count];
            for (i, group) in model.groups().iter().enumerate().rev() {
                if group.kind() == kind && group.has_role(role) {
                    is_there |= !group.members().is_empty();
                    group.members().iter().for_each(|&member| first[member as usize] = Some(i));
                }
            }
            first
        };
        let of_lines = first(GroupKind::Lines, model.lines().len());
        let of_polygons = first(GroupKind::Polygons, model.polygons().len());
        if !is_there {
            return Err(source.missing(model));
        }
        Ok(Self::Groups { of_lines, of_polygons, rest: file })
    }

    fn name(&self, model: &Model, shape: &Shape) -> Option<String> {
        let group = |group: Option<usize>, rest: &str| match group {
            Some(group) => model.groups()[group].name().to_owned(),
            None => rest.to_owned(),
        };
        match (self, shape) {
            (Self::Unlabeled, _) | (_, Shape::Point(_)) => None,
            (Self::Groups { of_polygons, rest, .. }, Shape::Face(face)) => {
                Some(group(of_polygons[*face], rest))
            }
            (Self::Groups { of_lines, rest, .. }, Shape::Line(line)) => Some(group(of_lines[*line], rest)),
            (Self::Groups { of_lines, rest, .. }, Shape::Rings(lines)) => {
                Some(group(of_lines[lines.start], rest))
            }
            (Self::Components { of_vertices, file }, shape) => {
                let vertex = match shape {
                    Shape::Face(face) => model.polygons().list(*face).first(),
                    Shape::Line(line) => model.lines().list(*line).first(),
                    Shape::Rings(lines) => model.lines().list(lines.start).first(),
                    Shape::Point(_) => None,
                };
                vertex.map(|&vertex| format!("{file}#{}", of_vertices[vertex as usize]))
            }
        }
    }

    /// The name of what has a vertex, where components are regions.
    fn name_at(&self, vertex: u32) -> Option<String> {
        match self {
            Self::Components { of_vertices, file } => {
                Some(format!("{file}#{}", of_vertices[vertex as usize]))
            }
            _ => None,
        }
    }
}

/// The connected component of each vertex: vertices at one place are one, and the rings of a polygon with holes are
/// together. Components are
/// numbered as the first of their lines and polygons come.
fn connected_vertices(model: &Model) -> Vec<u32> {
    let mut vertices = UnionFind::new(model.vertex_count());
    let dimension = model.positions().dimension().max(1);
    let mut places: BTreeMap<[u64; 2], u32> = BTreeMap::new();
    for (vertex, point) in (0..).zip(model.positions().as_flat().chunks_exact(dimension)) {
        if let [x, y, ..] = *point {
            // Zeros of both signs are equal.
            let first = *places.entry([(x + 0.0).to_bits(), (y + 0.0).to_bits()]).or_insert(vertex);
            vertices.unite(first, vertex);
        }
    }
    for list in model.lines().iter().chain(model.polygons().iter()) {
        for pair in list.windows(2) {
            vertices.unite(pair[0], pair[1]);
        }
    }
    let shapes = shapes(model);
    for (shape, _) in &shapes {
        if let Shape::Rings(lines) = shape {
            for line in lines.clone() {
                vertices.unite(model.lines().list(lines.start)[0], model.lines().list(line)[0]);
            }
        }
    }
    let mut edges: Vec<u32> = Vec::new();
    if let Some(Structure::Chains(complex)) = model.structure()
        && let Some(matrix) = complex.boundary_matrix(1)
    {
        for column in matrix.columns() {
            let mut ends = column.iter().map(|(vertex, _)| vertex as u32);
            if let Some(first) = ends.next() {
                for end in ends {
                    vertices.unite(first, end);
                }
                edges.push(first);
            }
        }
    }
    let classes = vertices.class_numbers();
    let mut numbers: BTreeMap<u32, u32> = BTreeMap::new();
    let firsts = model.lines().iter().chain(model.polygons().iter()).map(|list| list[0]);
    for first in firsts.chain(edges) {
        let next = numbers.len() as u32;
        numbers.entry(classes[first as usize]).or_insert(next);
    }
    classes.iter().map(|class| numbers.get(class).copied().unwrap_or_default()).collect()
}

/// Refuses a model that does not lie in the plane.
fn check_plane(model: &Model) -> Result<(), Error> {
    match model.structure() {
        None => {}
        Some(Structure::Chains(_)) if !model.positions().is_empty() => {}
        Some(_) if model.is_empty() => {}
        Some(_) => {
            return Err(Error::new(
                ErrorKind::UnsupportedFormat,
                "an abstract structure has no place in the plane",
            )
            .with_cure("give a drawing: segments, polylines or polygons with coordinates"));
        }
    }
    if !model.cells().is_empty() {
        return Err(Error::invalid(format!("{} 3-cells do not lie in the plane", model.cells().len()))
            .with_cure("arrange them in space: leave --dimension 2 out"));
    }
    model.require_finite()?;
    let positions = model.positions();
    match positions.dimension() {
        2 => Ok(()),
        3 if model.is_map_with_heights() => Ok(()),
        0 if model.is_empty() => Ok(()),
        0 => {
            Err(Error::invalid("the vertices have no positions").with_cure("give a drawing with coordinates"))
        }
        3 => match positions.as_flat().iter().skip(2).step_by(3).position(|&height| height != 0.0) {
            None => Ok(()),
            Some(vertex) => Err(Error::invalid(format!(
                "v{vertex} is at height {}, not in the plane z = 0",
                positions.as_flat()[3 * vertex + 2]
            ))
            .with_cure("set all heights to 0, or arrange the model in space")),
        },
        dimension => Err(Error::new(
            ErrorKind::Shape,
            format!("points with {dimension} coordinates do not lie in the plane"),
        )
        .with_cure("give two coordinates for each point, or three of which the last is 0")),
    }
}
