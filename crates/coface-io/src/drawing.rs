//! Points, lines and polygons with holes, as drawings and maps have them, and the models that they are.
//!
//! A polygon with holes is no polygon of a mesh, so its rings become closed lines, and two arrays of integers on the lines say
//! what they bound: `polygon` numbers the polygons, `ring` is 0 for an outer ring and 1, 2, .. for the holes; both are -1
//! for a line that is no ring. Where a feature without a name has several polygons a third array, `feature`, numbers the features without
//! names that have lines or rings, one after the other, and is -1 for what has a name.

use super::arcs;
use super::equal_corners::weld;
use super::feature_table::{FeatureTable, FeatureTexts, NO_FEATURE};
use super::numbers::Numbers;
use super::space_faces::SpaceFaces;
use super::{CellData, Format, Model};
use super::{Group, GroupKind};
use crate::{ReferenceSystem, Remark, RemarkCode};
use coface_algebra::{Error, ErrorKind, RaggedArray, VertexId};
use coface_geometry::Positions;
use std::collections::BTreeMap;
use std::ops::Range;

/// The array that says which polygon a ring belongs to.
const POLYGON: &str = "polygon";
/// The array that says which ring of its polygon a line is.
const RING: &str = "ring";
/// The array that says which feature a line is of.
const FEATURE: &str = "feature";
/// Warnings of one kind that are listed one by one.
const LISTED: usize = 8;

/// A position as a file gives it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Place {
    pub(super) x: f64,
    pub(super) y: f64,
    /// The height, if there is one.
    pub(super) z: Option<f64>,
}

impl Place {
    fn coordinates(self) -> [f64; 3] {
        [self.x, self.y, self.z.unwrap_or(0.0)]
    }
}

/// A line that has been read.
struct Line {
    /// The corner behind its last.
    end: usize,
    /// The polygon and the ring; -1 if it is none.
    polygon: i64,
    ring: i64,
    feature: i64,
    name: Option<usize>,
    described: u32,
    /// The surface that it is a ring of; `NO_SURFACE` if it is of none.
    surface: u32,
}

const NO_SURFACE: u32 = u32::MAX;

/// A point that has been read.
struct Point {
    place: [f64; 3],
    name: Option<usize>,
    described: u32,
}

/// A drawing while it is read: lines corner by corner.
#[derive(Default)]
pub(super) struct Drawing {
    /// The corners of all lines, and of the line that is being made.
    corners: Vec<[f64; 3]>,
    lines: Vec<Line>,
    points: Vec<Point>,
    names: Vec<String>,
    number_of_name: BTreeMap<String, usize>,
    /// The name of what comes next.
    name: Option<usize>,
    /// What the file says of the features, and whether what comes next is of the last of them.
    descriptions: FeatureTexts,
    is_described: bool,
    /// How much had been drawn before that feature, and how many features have drawn nothing.
    drawn_before: usize,
    empty_features: usize,
    /// Whether these are told where others are drawn.
    tells_empty: bool,
    /// The features without names that have lines, and whether the next such line is of another one.
    feature_count: i64,
    begins_feature: bool,
    /// The feature of the last polygon, and whether a feature has had several.
    feature_of_polygon: Option<i64>,
    has_many_polygons: bool,
    /// The feature of which a shape other than a hole was drawn last, and whether one had several that are not all polygons.
    shape_of: Option<(u32, bool)>,
    has_many_shapes: bool,
    /// Whether what comes next begins a feature of which the file says nothing.
    is_geometry: bool,
    polygon_count: i64,
    /// The rings that the polygon has had.
    ring_count: i64,
    /// Whether the polygon that is being drawn has an outer ring that is more than a point; none before that ring.
    has_outer: Option<bool>,
    /// The holes of polygons without one.
    lone_holes: usize,
    /// Whether all corners of each surface have heights so far, and whether what is drawn is of the last surface.
    surfaces: Vec<bool>,
    is_surface: bool,
    heights: bool,
    flat_places: usize,
    surplus: usize,
    single_points: usize,
    /// The number of rings that were closed, and the first of them with where they begin and end.
    unclosed_rings: usize,
    unclosed: Vec<(String, [[f64; 3]; 2])>,
    /// The reference system of what names one, and how much does not.
    reference: Option<ReferenceSystem>,
    unreferenced: usize,
    /// How far chords may be from arcs, where that is said; the arcs so far, and how far one is from its chords at most.
    flatten: Option<f64>,
    arc_count: usize,
    arc_distance: f64,
    remarks: Vec<Remark>,
}

impl Drawing {
    /// A drawing whose arcs become chords within this distance.
    pub(super) fn flattened(flatten: Option<f64>) -> Self {
        Self { flatten, ..Self::default() }
    }

    /// What comes next is in this reference system, or names none.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if what came before is in another one.
    pub(super) fn set_reference(&mut self, system: Option<ReferenceSystem>) -> Result<(), Error> {
        match (system, &self.reference) {
            (None, _) => self.unreferenced += 1,
            (Some(system), None) => self.reference = Some(system),
            (Some(system), Some(known)) if system != *known => {
                let message = format!("what came before is in {known}, but this is in {system}");
                return Err(Error::invalid(message).with_cure(known.transformation()));
            }
            _ => {}
        }
        Ok(())
    }

    /// What comes next is another feature, with this name or none.
    pub(super) fn begin_feature(&mut self, name: Option<String>) {
        self.begins_feature = true;
        self.empty_features += usize::from(self.is_described && self.drawn() == self.drawn_before);
        (self.is_described, self.is_geometry) = (false, false);
        self.name = name.filter(|name| !name.is_empty()).map(|name| {
            *self.number_of_name.entry(name).or_insert_with_key(|name| {
                self.names.push(name.clone());
                self.names.len() - 1
            })
        });
    }

    /// What comes next is another feature, with this name or none, of which the file says this; both texts may be
    /// empty.
    pub(super) fn begin_described(&mut self, name: Option<&str>, properties: &str, id: &str) {
        self.begin_feature(name.map(str::to_owned));
        self.descriptions.push(properties, id);
        self.is_described = true;
        self.drawn_before = self.drawn();
    }

    /// What comes next is a geometry of which the file says nothing else; one that draws nothing is not told.
    pub(super) fn begin_geometry(&mut self) {
        self.begin_feature(None);
        self.is_geometry = true;
    }

    /// A shape of the feature is drawn: a polygon, or a line or point.
    fn note_shape(&mut self, is_polygon: bool) {
        if std::mem::take(&mut self.is_geometry) {
            self.descriptions.push("", "");
            (self.is_described, self.drawn_before) = (true, usize::MAX);
        }
        let feature = self.described();
        if let Some((last, was_polygon)) = self.shape_of
            && last == feature
            && feature != NO_FEATURE
        {
            self.has_many_shapes |= !is_polygon || !was_polygon;
        }
        self.shape_of = Some((feature, is_polygon));
    }

    /// Features without a geometry are told, also where others have one.
    pub(super) fn tell_empty_features(&mut self) {
        self.tells_empty = true;
    }

    fn drawn(&self) -> usize {
        self.lines.len() + self.points.len() + self.corners.len()
    }

    /// The feature of what is drawn now, by its place among the descriptions.
    fn described(&self) -> u32 {
        // `finish` refuses more features than there are numbers.
        if self.is_described { self.descriptions.len().wrapping_sub(1) as u32 } else { NO_FEATURE }
    }

    /// Numbers behind the third coordinate were passed over.
    pub(super) fn note_surplus(&mut self) {
        self.surplus += 1;
    }

    fn note(&mut self, place: Place) {
        match place.z {
            Some(_) => self.heights = true,
            None => {
                self.flat_places += 1;
                if let Some(has_heights) = self.surfaces.last_mut().filter(|_| self.is_surface) {
                    *has_heights = false;
                }
            }
        }
    }

    /// The polygons that follow are the faces of a surface: in space, if all their corners have heights.
    pub(super) fn begin_surface(&mut self) {
        self.surfaces.push(true);
        self.is_surface = true;
    }

    /// The surface has no more faces.
    pub(super) fn end_surface(&mut self) {
        self.is_surface = false;
    }

    /// A point of its own.
    pub(super) fn point(&mut self, place: Place) {
        self.note(place);
        self.push_point(place.coordinates());
    }

    fn push_point(&mut self, place: [f64; 3]) {
        self.note_shape(false);
        self.points.push(Point { place, name: self.name, described: self.described() });
    }

    /// The next corner of the line that is being made. One that equals the last is left out.
    pub(super) fn corner(&mut self, place: Place) {
        self.note(place);
        let (corner, start) = (place.coordinates(), self.open());
        if self.corners[start..].last() != Some(&corner) {
            self.corners.push(corner);
        }
    }

    /// The last corner of the line that is being made.
    fn last_corner(&self) -> Option<[f64; 3]> {
        self.corners[self.open()..].last().copied()
    }

    /// The first corner of a part of a line, which is where the part before it ends.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] if it is not.
    pub(super) fn begin_part(&mut self, place: Place) -> Result<(), Error> {
        let [x, y, z] = place.coordinates();
        if let Some(last) = self.last_corner().filter(|&last| last != [x, y, z]) {
            let [a, b, _] = last;
            let message =
                format!("a part of a curve begins at ({x}, {y}), but the part before it ends at ({a}, {b})");
            return Err(Error::invalid(message).with_cure("let each part begin where the one before it ends"));
        }
        self.corner(place);
        Ok(())
    }

    /// The line goes on along an arc through the middle to the end, by chords.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] if the line has no corner yet, or the circle is beyond the range of numbers; [`ErrorKind::TooLarge`]
    /// for too many chords.
    pub(super) fn arc(&mut self, middle: Place, end: Place) -> Result<(), Error> {
        let [x, y, z] = self.last_corner().ok_or_else(|| Error::invalid("an arc has no beginning"))?;
        let from = Place { x, y, z: end.z.map(|_| z) };
        let found = arcs::chords([from, middle, end], self.flatten)?;
        found.places.into_iter().for_each(|place| self.corner(place));
        self.arc_count += 1;
        self.arc_distance = self.arc_distance.max(found.distance);
        Ok(())
    }

    /// The first corner of the line that is being made.
    fn open(&self) -> usize {
        self.lines.last().map_or(0, |line| line.end)
    }

    /// Ends a line. One whose corners are all equal is kept as a point, and `place` names it in a remark; says whether it is
    /// more than a point.
    pub(super) fn end_line(&mut self, place: impl FnOnce() -> String) -> bool {
        self.end(-1, -1, place)
    }

    /// The rings that follow are those of another polygon: the outer one, then its holes.
    pub(super) fn begin_polygon(&mut self) {
        (self.ring_count, self.has_outer) = (0, None);
    }

    /// The rings that follow are those of another path, none of which is the outer one.
    pub(super) fn begin_path(&mut self) {
        (self.ring_count, self.has_outer) = (0, Some(true));
    }

    /// Ends a ring. One whose first corner does not stand at its end again is closed, and `place` names it in a remark; says
    /// whether it is more than a point.
    pub(super) fn end_ring(&mut self, place: impl FnOnce() -> String) -> bool {
        let start = self.open();
        if let (Some(&first), Some(&last)) = (self.corners[start..].first(), self.corners.last())
            && first != last
        {
            self.corners.push(first);
            self.unclosed_rings += 1;
            if self.unclosed.len() < LISTED {
                self.unclosed.push((place(), [first, last]));
            }
            return self.end_closed_ring(String::new);
        }
        self.end_closed_ring(place)
    }

    fn end_closed_ring(&mut self, place: impl FnOnce() -> String) -> bool {
        if self.has_outer == Some(false) {
            // What is taken out of nothing bounds nothing.
            let is_kept = self.end(-1, -1, place);
            self.lone_holes += usize::from(is_kept);
            return is_kept;
        }
        let corners = &self.corners[self.open()..];
        if corners.len() > 1 && self.ring_count == 0 {
            self.polygon_count += 1;
        }
        let is_kept = self.end(self.polygon_count - 1, self.ring_count, place);
        self.ring_count += i64::from(is_kept);
        self.has_outer.get_or_insert(is_kept);
        is_kept
    }

    /// The feature of the line that is being made; -1 if it has a name, which tells it.
    fn feature(&mut self) -> i64 {
        if self.name.is_some() {
            return -1;
        }
        if std::mem::take(&mut self.begins_feature) || self.feature_count == 0 {
            self.feature_count += 1;
        }
        self.feature_count - 1
    }

    /// Ends a line or ring; says whether it is more than a point.
    fn end(&mut self, polygon: i64, ring: i64, place: impl FnOnce() -> String) -> bool {
        let start = self.open();
        match self.corners.len() - start {
            0 => false,
            1 => {
                let corner = self.corners[start];
                self.corners.truncate(start);
                self.push_point(corner);
                self.single_points += 1;
                if self.single_points <= LISTED {
                    self.remarks.push(Remark::new(
                        RemarkCode::SinglePoint,
                        format!("{} is a single point and kept as one", place()),
                    ));
                }
                false
            }
            _ => {
                let feature = self.feature();
                if ring == 0 && feature >= 0 {
                    self.has_many_polygons |= self.feature_of_polygon == Some(feature);
                    self.feature_of_polygon = Some(feature);
                }
                if ring <= 0 {
                    self.note_shape(ring == 0);
                }
                let (end, described) = (self.corners.len(), self.described());
                let surface = if self.is_surface { self.surfaces.len() as u32 - 1 } else { NO_SURFACE };
                self.lines.push(Line { end, polygon, ring, feature, name: self.name, described, surface });
                true
            }
        }
    }

    /// Takes out what is a face in space.
    fn space_faces(&mut self) -> SpaceFaces {
        let mut faces = SpaceFaces::default();
        if !self.surfaces.contains(&true) {
            return faces;
        }
        let is_in_space = |line: &Line| self.surfaces.get(line.surface as usize) == Some(&true);
        let (mut start, mut kept) = (0, Vec::new());
        let mut lines = Vec::new();
        for mut line in std::mem::take(&mut self.lines) {
            let corners = &self.corners[std::mem::replace(&mut start, line.end)..line.end];
            if is_in_space(&line) {
                faces.add(corners, line.surface, line.ring > 0);
            } else {
                kept.extend_from_slice(corners);
                line.end = kept.len();
                lines.push(line);
            }
        }
        (self.lines, self.corners) = (lines, kept);
        faces
    }

    /// The model. Lines and points share their vertices; a ring has vertices of its own, so that polygons that touch stay
    /// apart. The faces of a surface in space are polygons of a mesh, which have theirs in common. Within these, equal coordinates are one vertex, and vertices are numbered as they come, lines before points.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] beyond 2^32 - 1 corners.
    pub(super) fn finish(mut self) -> Result<Model, Error> {
        self.begin_feature(None);
        let faces = self.space_faces();
        if self.empty_features > 0 && (self.tells_empty || self.drawn() == 0) {
            let message = match self.empty_features {
                1 => "1 feature has no geometry, and nothing is drawn for it".to_owned(),
                count => format!("{count} features have no geometry, and nothing is drawn for them"),
            };
            self.remarks.push(Remark::new(RemarkCode::DataLeftOut, message).at(self.empty_features, []));
        }
        let remark = |remarks: &mut Vec<Remark>, code: RemarkCode, count: usize, what: &str| {
            if count > 0 {
                remarks.push(Remark::new(code, format!("{count} {what}")).at(count, []));
            }
        };
        if let Some((name, [first, last])) = self.unclosed.first() {
            let others = match self.unclosed_rings {
                1 => String::new(),
                2 => "; 1 more ring is closed so".to_owned(),
                count => format!("; {} more rings are closed so", count - 1),
            };
            let [[x, y, _], [u, v, _]] = [first, last];
            let message =
                format!("{name} begins at ({x}, {y}) but ends at ({u}, {v}), and is closed{others}");
            let places = self.unclosed.iter().map(|(_, [_, last])| crate::Place::point(&last[..2]));
            self.remarks.push(Remark::new(RemarkCode::UnclosedRing, message).at(self.unclosed_rings, places));
        }
        let unlisted = self.single_points.saturating_sub(LISTED);
        remark(
            &mut self.remarks,
            RemarkCode::SinglePoint,
            unlisted,
            "more lines or rings are single points and kept as such",
        );
        if self.lone_holes > 0 {
            let message = match self.lone_holes {
                1 => "1 hole of a polygon whose outer ring is a single point bounds nothing, and is kept as a line".to_owned(),
                count => format!(
                    "{count} holes of polygons whose outer rings are single points bound nothing, and are kept as lines"
                ),
            };
            self.remarks.push(Remark::new(RemarkCode::SinglePoint, message).at(self.lone_holes, []));
        }
        remark(
            &mut self.remarks,
            RemarkCode::DataLeftOut,
            self.surplus,
            "positions have numbers behind the third, which are passed over",
        );
        if self.heights {
            remark(
                &mut self.remarks,
                RemarkCode::HeightsAssumed,
                self.flat_places,
                "positions without a height are at height 0",
            );
        }
        if self.arc_count > 0 && self.flatten.is_none() {
            let [subject, them] = match self.arc_count {
                1 => ["1 arc of a circle".to_owned(), "it".to_owned()],
                count => [format!("{count} arcs of circles"), "them".to_owned()],
            };
            let message = format!(
                "{subject} became chords, 32 for a quarter of a circle, that are within {:.3e} of {them}; --flatten LENGTH says another distance",
                self.arc_distance
            );
            self.remarks.push(Remark::new(RemarkCode::CurvesFlattened, message).at(self.arc_count, []));
        }
        if let Some(system) = self.reference.as_ref().filter(|_| self.unreferenced > 0) {
            let message = match self.unreferenced {
                1 => format!(
                    "1 geometry names no reference system, and is taken to be in {system} as the others are"
                ),
                count => format!(
                    "{count} geometries name no reference system, and are taken to be in {system} as the others are"
                ),
            };
            self.remarks.push(Remark::new(RemarkCode::ReferenceAssumed, message).at(self.unreferenced, []));
        }
        let line_corners = self.corners.len();
        self.corners.extend(self.points.iter().map(|point| point.place));
        let face_corners = self.corners.len();
        self.corners.extend_from_slice(&faces.corners);
        let too_many = |what: &str| {
            Error::new(ErrorKind::TooLarge, format!("the drawing has more than 2^32 - 2 {what}"))
                .with_cure("divide it")
        };
        if self.corners.len() >= u32::MAX as usize {
            return Err(too_many("corners"));
        }
        if self.descriptions.len() >= NO_FEATURE as usize {
            return Err(too_many("features"));
        }
        let mut owners = vec![0u32; self.corners.len()];
        let mut ends = vec![0u32];
        for (i, line) in self.lines.iter().enumerate() {
            if line.polygon >= 0 {
                owners[ends[i] as usize..line.end].fill(i as u32 + 1);
            }
            ends.push(line.end as u32);
        }
        for (owner, surface) in owners[face_corners..].iter_mut().zip(faces.surface_of_corners()) {
            *owner = self.lines.len() as u32 + 1 + surface;
        }
        let (vertices, firsts) = weld(&self.corners, &owners);
        let dimension = if self.heights { 3 } else { 2 };
        let mut coordinates = Vec::with_capacity(dimension * firsts.len());
        for &corner in &firsts {
            coordinates.extend_from_slice(&self.corners[corner as usize][..dimension]);
        }
        let points: Vec<u32> = vertices[line_corners..face_corners].to_vec();
        let place = |vertex: u32| self.corners[firsts[vertex as usize] as usize];
        let (elements, surfaces) = faces.elements(&vertices[face_corners..], place, &mut self.remarks);
        let lines = RaggedArray::from_parts(ends, vertices[..line_corners].to_vec())?;
        let mut data = Vec::new();
        if self.lines.iter().any(|line| line.polygon >= 0) {
            let column = |name: &str, value: fn(&Line) -> i64| {
                let numbers = Numbers::Int64(self.lines.iter().map(value).collect());
                CellData::of_file(name.to_owned(), GroupKind::Lines, 1, numbers)
            };
            data = vec![column(POLYGON, |line| line.polygon), column(RING, |line| line.ring)];
            if self.has_many_polygons {
                data.push(column(FEATURE, |line| line.feature));
            }
        }
        let named_points = self.points.iter().zip(&points).map(|(point, &vertex)| (point.name, vertex));
        let mut groups = groups_of(&self.names, GroupKind::Vertices, named_points);
        let named_lines = self.lines.iter().zip(0..).map(|(line, i)| (line.name, i));
        groups.extend(groups_of(&self.names, GroupKind::Lines, named_lines));
        // Several surfaces are told apart by their numbers.
        if self.surfaces.len() > 1 {
            let mut face = 0;
            for same in surfaces.chunk_by(|a, b| a == b) {
                let faces = face..face + same.len() as u32;
                face = faces.end;
                groups.push(Group::new(
                    format!("surface {}", same[0] + 1),
                    GroupKind::Polygons,
                    faces.collect(),
                ));
            }
        }
        let of_lines = self.lines.iter().map(|line| line.described).collect();
        let of_points = self.points.iter().map(|point| point.described).collect();
        let features = match self.has_many_shapes {
            true => FeatureTable::of_shapes(self.descriptions, of_lines, of_points),
            false => FeatureTable::new(self.descriptions, of_lines, of_points),
        };
        let model = Model {
            vertex_count: firsts.len(),
            positions: Positions::from_flat(dimension, coordinates)?,
            lines,
            points: points.into_iter().map(VertexId::from_u32).collect(),
            polygons: elements.polygons.into_ragged()?,
            groups,
            data,
            features,
            reference: self.reference,
            remarks: self.remarks,
            ..Model::default()
        };
        debug_assert!(model.check().is_ok(), "what a drawing makes is sound");
        Ok(model)
    }
}

/// The groups of things of one kind, in the order of their first members.
fn groups_of(
    names: &[String],
    kind: GroupKind,
    things: impl Iterator<Item = (Option<usize>, u32)>,
) -> Vec<Group> {
    let mut group_of_name: Vec<Option<usize>> = vec![None; names.len()];
    let mut groups: Vec<Group> = Vec::new();
    for (name, thing) in things.filter_map(|(name, thing)| Some((name?, thing))) {
        let group = *group_of_name[name].get_or_insert_with(|| {
            groups.push(Group::new(names[name].clone(), kind, Vec::new()));
            groups.len() - 1
        });
        groups[group].members.push(thing);
    }
    for group in &mut groups {
        group.members.sort_unstable();
        group.members.dedup();
    }
    groups
}

impl Model {
    /// Whether this is a map with heights: lines, rings and points with three coordinates, of a format of maps or with polygons
    /// that have holes.
    #[doc(hidden)]
    pub fn is_map_with_heights(&self) -> bool {
        let is_map = self.format().is_some_and(Format::keeps_heights)
            || self.data_named(RING, GroupKind::Lines).is_some();
        is_map
            && self.positions().dimension() == 3
            && self.polygons().is_empty()
            && self.cells().is_empty()
            && self.structure().is_none()
    }
}

/// What a model draws.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Shape {
    /// This line.
    Line(usize),
    /// The polygon that these lines are the rings of.
    Rings(Range<usize>),
    /// This polygon of a mesh.
    Face(usize),
    /// This vertex.
    Point(VertexId),
}

/// What a model draws, each with the number of the group that names it: lines and rings, then the polygons, then the
/// points and the vertices that nothing uses.
///
/// # Examples
/// ```
/// use coface_io as io;
/// use coface_io::{Format, Shape, shapes};
/// let model = io::read(&b"POLYGON ((0 0, 1 0, 0 1, 0 0))"[..], Format::Wkt)?;
/// assert_eq!(shapes(&model).len(), 1);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn shapes(model: &Model) -> Vec<(Shape, Option<usize>)> {
    let mut shapes = Vec::new();
    let names = names_of(model, GroupKind::Lines);
    let [polygons, rings] = [POLYGON, RING].map(|name| match model.data_named(name, GroupKind::Lines) {
        Some(data) if data.components() == 1 && data.is_integral() => {
            (0..data.len()).map(|i| data.integer_row(i).map_or(-1, |row| row[0])).collect()
        }
        _ => vec![-1; model.lines.len()],
    });
    let is_ring = |i: usize| {
        let line = model.lines.list(i);
        polygons[i] >= 0 && rings[i] >= 0 && line.first() == line.last()
    };
    let mut i = 0;
    while i < model.lines.len() {
        let start = i;
        i += 1;
        if !is_ring(start) {
            shapes.push((Shape::Line(start), names[start]));
            continue;
        }
        let is_hole = |i: usize| {
            is_ring(i) && rings[i] > 0 && polygons[i] == polygons[start] && names[i] == names[start]
        };
        while i < model.lines.len() && is_hole(i) {
            i += 1;
        }
        shapes.push((Shape::Rings(start..i), names[start]));
    }
    let names = names_of(model, GroupKind::Polygons);
    shapes.extend(names.into_iter().enumerate().map(|(i, name)| (Shape::Face(i), name)));
    let names = names_of(model, GroupKind::Vertices);
    let mut used = vec![false; model.vertex_count];
    for &vertex in model.lines.items().iter().chain(model.polygons.items()) {
        used[vertex as usize] = true;
    }
    for point in &model.points {
        used[point.index()] = true;
        shapes.push((Shape::Point(*point), names[point.index()]));
    }
    let isolated = (0..model.vertex_count).filter(|&vertex| !used[vertex]);
    shapes.extend(isolated.map(|vertex| (Shape::Point(VertexId::new(vertex)), names[vertex])));
    shapes
}

/// The features without names that the lines of a model are of; none where no such feature has several polygons.
#[derive(Debug)]
pub struct Features(Vec<i64>);

impl Features {
    #[doc(hidden)]
    pub fn new(model: &Model) -> Self {
        let data = model.data_named(FEATURE, GroupKind::Lines);
        let data = data.filter(|data| data.components() == 1 && data.is_integral());
        let number = |data: &CellData, i: usize| data.integer_row(i).map_or(-1, |row| row[0]);
        Self(data.map_or(Vec::new(), |data| (0..data.len()).map(|i| number(data, i)).collect()))
    }

    /// The feature of a line or of rings, if it is known.
    #[doc(hidden)]
    pub fn of(&self, shape: &Shape) -> Option<i64> {
        let line = match shape {
            Shape::Line(line) => *line,
            Shape::Rings(lines) => lines.start,
            Shape::Face(_) | Shape::Point(_) => return None,
        };
        self.0.get(line).copied().filter(|&feature| feature >= 0)
    }

    /// Whether two shapes are known to be of one feature.
    pub(crate) fn are_one(&self, a: &Shape, b: &Shape) -> bool {
        self.of(a).is_some() && self.of(a) == self.of(b)
    }
}

/// The feature of each of the [`shapes()`] of a model, if the file says something of it.
#[doc(hidden)]
pub fn features_of_shapes(model: &Model, shapes: &[(Shape, Option<usize>)]) -> Vec<Option<usize>> {
    let (features, mut points) = (model.features(), 0..);
    let feature = |(shape, _): &(Shape, Option<usize>)| match shape {
        Shape::Line(line) => features.of_line(*line),
        Shape::Rings(lines) => features.of_line(lines.start),
        Shape::Face(_) => None,
        // The listed points come before the others, in their order.
        Shape::Point(_) => points.next().and_then(|point| features.of_point(point)),
    };
    shapes.iter().map(feature).collect()
}

/// The first group of a kind that each thing is in.
pub(super) fn names_of(model: &Model, kind: GroupKind) -> Vec<Option<usize>> {
    let mut names = vec![None; model.count_of(kind)];
    for (i, group) in model.groups.iter().enumerate().rev().filter(|(_, group)| group.kind == kind) {
        for &member in &group.members {
            names[member as usize] = Some(i);
        }
    }
    names
}

/// The coordinates that are written for each vertex: two, or three if one is above or below the plane or if the model is a map with
/// heights.
///
/// # Errors
/// [`ErrorKind::UnsupportedFormat`] if the model has no positions, cells, or more than three coordinates a vertex;
/// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) naming a coordinate that is not finite.
pub(super) fn written_dimension(model: &Model, format: &str) -> Result<usize, Error> {
    super::limits::require_mesh(model, format, "MEDIT, MSH or VTK")?;
    super::limits::require_dimension(model, format, 3)?;
    // The plane needs coordinates.
    model.require_finite()?;
    let is_map = model.format.is_some_and(Format::keeps_heights);
    let in_plane = model.positions.dimension() < 3
        || !is_map && model.positions.as_flat().iter().skip(2).step_by(3).all(|&height| height == 0.0);
    Ok(if in_plane { 2 } else { 3 })
}

/// Things between two brackets with something between them.
pub(super) fn push_list<T>(
    text: &mut Vec<u8>,
    [open, between, close]: [&[u8]; 3],
    items: impl Iterator<Item = T>,
    push: impl Fn(T, &mut Vec<u8>),
) {
    text.extend_from_slice(open);
    for (i, item) in items.enumerate() {
        if i > 0 {
            text.extend_from_slice(between);
        }
        push(item, text);
    }
    text.extend_from_slice(close);
}

/// Appends the coordinates of a vertex, with something between them.
pub(super) fn push_place(model: &Model, vertex: u32, dimension: usize, between: u8, text: &mut Vec<u8>) {
    let width = model.positions.dimension();
    let start = vertex as usize * width;
    for axis in 0..dimension {
        if axis > 0 {
            text.push(between);
        }
        let coordinate = if axis < width { model.positions.as_flat()[start + axis] } else { 0.0 };
        super::decimal::push_f64(text, coordinate);
    }
}

/// The vertices of a polygon of a mesh as a ring: the first again at the end.
pub(super) fn closed(polygon: &[u32]) -> impl Iterator<Item = u32> + Clone {
    polygon.iter().chain(polygon.first()).copied()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn place(x: f64, y: f64) -> Place {
        Place { x, y, z: None }
    }

    fn draw(drawing: &mut Drawing, corners: &[[f64; 2]]) {
        for &[x, y] in corners {
            drawing.corner(place(x, y));
        }
    }

    #[test]
    fn lines_share_vertices_and_rings_do_not() {
        let mut drawing = Drawing::default();
        drawing.begin_feature(Some("way".to_owned()));
        draw(&mut drawing, &[[0., 0.], [1., 0.], [1., 0.], [1., 1.]]);
        drawing.end_line(String::new);
        drawing.begin_feature(None);
        draw(&mut drawing, &[[1., 1.], [0., 1.], [-0.0, 0.]]);
        drawing.end_line(String::new);
        drawing.begin_polygon();
        draw(&mut drawing, &[[0., 0.], [1., 0.], [0., 1.], [0., 0.]]);
        drawing.end_ring(String::new);
        drawing.point(place(1., 0.));
        let model = drawing.finish().unwrap();
        assert_eq!(model.lines, RaggedArray::from_lists([vec![0, 1, 2], vec![2, 3, 0], vec![4, 5, 6, 4]]));
        assert_eq!(model.points, [VertexId::new(1)]);
        assert_eq!(model.groups, [Group::new("way", GroupKind::Lines, vec![0])]);
        let ring = model.data_named("ring", GroupKind::Lines).unwrap();
        assert_eq!(ring.integer_row(0), Some(vec![-1]));
        assert_eq!(ring.integer_row(2), Some(vec![0]));
        let expected = [Shape::Line(0), Shape::Line(1), Shape::Rings(2..3), Shape::Point(VertexId::new(1))];
        assert!(shapes(&model).into_iter().map(|(shape, _)| shape).eq(expected));
    }

    #[test]
    fn features_are_told_where_one_has_several_polygons() {
        let square = |drawing: &mut Drawing, x: f64| {
            drawing.begin_polygon();
            draw(drawing, &[[x, 0.], [x + 1., 0.], [x, 1.], [x, 0.]]);
            drawing.end_ring(String::new);
        };
        let features = |has_second: bool| {
            let mut drawing = Drawing::default();
            drawing.begin_feature(None);
            square(&mut drawing, 0.);
            // One that draws nothing does not count.
            drawing.begin_feature(None);
            drawing.begin_feature(None);
            draw(&mut drawing, &[[5., 5.], [6., 6.]]);
            drawing.end_line(String::new);
            square(&mut drawing, 2.);
            if has_second {
                square(&mut drawing, 4.);
            }
            let model = drawing.finish().unwrap();
            let features = Features::new(&model);
            shapes(&model).iter().map(|(shape, _)| features.of(shape)).collect::<Vec<_>>()
        };
        assert_eq!(features(true), [Some(0), Some(1), Some(1), Some(1)]);
        assert_eq!(features(false), [None; 3]);
        // What has a name is told by it.
        let mut drawing = Drawing::default();
        drawing.begin_feature(Some("lakes".to_owned()));
        square(&mut drawing, 0.);
        square(&mut drawing, 2.);
        assert!(drawing.finish().unwrap().data_named("feature", GroupKind::Lines).is_none());
    }

    #[test]
    fn one_feature_of_lines_or_points_is_one_geometry() {
        for text in [
            "MULTILINESTRING ((5 5, 8 5), (0 0, 1 0, 1 1))\nLINESTRING (7 7, 8 8)\n",
            "POINT (9 9)\nMULTIPOINT ((1 2), (3 4))\nLINESTRING (7 7, 8 8)\n",
            "GEOMETRYCOLLECTION (LINESTRING (0 0, 1 1), POINT (5 5))\nPOINT (3 3)\n",
            "MULTIPOLYGON (((0 0, 1 0, 0 1, 0 0)), ((5 5, 6 5, 5 6, 5 5)))\nMULTIPOINT ((0 0), (1 1))\n",
        ] {
            let model = crate::wkt::read(text.as_bytes()).unwrap();
            model.check().unwrap();
            let mut written = Vec::new();
            crate::wkt::write(&model, &mut written).unwrap();
            assert_eq!(String::from_utf8(written).unwrap(), text);
            for format in [Format::WkbHex, Format::Wkb, Format::GeoJson] {
                let mut bytes = Vec::new();
                crate::write(&model, &mut bytes, format).unwrap();
                let back = crate::read(&bytes[..], format).unwrap();
                let mut written = Vec::new();
                crate::wkt::write(&back, &mut written).unwrap();
                assert_eq!(String::from_utf8(written).unwrap(), text, "{format:?}");
            }
        }
    }

    #[test]
    fn what_is_degenerate_is_kept_and_said() {
        let mut drawing = Drawing::default();
        draw(&mut drawing, &[[2., 3.], [2., 3.]]);
        drawing.end_line(|| "line 7".to_owned());
        drawing.begin_polygon();
        draw(&mut drawing, &[[0., 0.], [1., 0.], [0., 0.]]);
        drawing.end_ring(String::new);
        drawing.end_line(String::new);
        draw(&mut drawing, &[[0., 0.], [1., 0.]]);
        // Such a ring is closed.
        assert!(drawing.end_ring(|| "the last ring".to_owned()));
        drawing.point(Place { x: 1., y: 2., z: Some(3.) });
        let model = drawing.finish().unwrap();
        assert_eq!(model.lines, RaggedArray::from_lists([vec![0, 1, 0], vec![2, 3, 2]]));
        assert_eq!((model.points.len(), model.positions.dimension()), (2, 3));
        assert!(model.remarks[0].message.starts_with("line 7 is a single point"), "{:?}", model.remarks);
        assert_eq!(
            model.remarks[1].message,
            "the last ring begins at (0, 0) but ends at (1, 0), and is closed"
        );
        assert_eq!(model.remarks[2].message, "7 positions without a height are at height 0");
    }
}
