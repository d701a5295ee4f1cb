//! The new map, and what was done in numbers.

use super::buffer::buffered;
use super::clip::clipped;
use super::coverage::examined;
use super::layer::{Geometry, MapLayer, Rings, drawn_area};
use super::lines::{noded, polygonized};
use super::map_builder::MapBuilder;
use super::repair::{Repaired, repaired};
use super::simplify::simplified;
use super::task::{MapTask, RepairMethod};
use crate::answer::{DrawnFaultAnswer, MapAnswer, MapCounts, MapRepairAnswer, Remark, RemarkCode};
use crate::facts::{DrawnFault, DrawnPlace};
use crate::text;
use coface_algebra::Error;
use coface_arrange::planar::PolygonFaultKind;
use coface_geometry::Sum;
use coface_io as io;
use coface_io::{Format, Model};
use rayon::prelude::*;
use std::io::Write;

use super::super::writing::reference_loss;

/// How many places of a fault are listed.
const LISTED: usize = 100;

/// A map after a [`MapTask`].
///
/// Features keep their order, properties and ids. `node` and `polygonize` make new features of all inputs together, `coverage` lists the
/// sides that are not valid, feature by feature.
///
/// # Examples
/// A bow tie becomes two triangles.
/// ```
/// use coface_answers::{MapResult, MapTask, RepairMethod};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let tie = coface_io::read(&b"POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))"[..], coface_io::Format::Wkt)?;
/// let valid = MapResult::new([("tie", &tie)], &MapTask::Repair(RepairMethod::Structure))?;
/// let answer = valid.answer();
/// assert_eq!((answer.measure, answer.counts.polygons), (2.0, 2));
/// let mut text = Vec::new();
/// valid.write(&mut text, coface_io::Format::Wkt)?;
/// assert_eq!(text, b"MULTIPOLYGON (((0 0, 1 1, 0 2, 0 0)), ((1 1, 2 0, 2 2, 1 1)))\n");
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct MapResult {
    answer: MapAnswer,
    model: Model,
    has_heights: bool,
    has_properties: bool,
}

/// What became of the features.
pub(super) struct Change {
    /// Each with the place of its feature, or none for a new one.
    pub(super) geometries: Vec<(Option<usize>, Geometry)>,
    pub(super) keeps_heights: bool,
    pub(super) answer: MapAnswer,
}

impl MapResult {
    /// Does what is asked for with the features of models.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if a model does not lie in the plane, if distances, boxes or errors are not finite or make no
    /// sense, or if the reference systems of the inputs differ.
    ///
    /// # Complexity
    /// $O((n + k) \log n)$ for n sides of a feature and k meetings of them, one feature after the other in parallel; of all features
    /// together for `node`, `polygonize`, `simplify` and `coverage`.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{BufferJoins, BufferOptions, MapResult, MapTask};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = coface_io::read(&b"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let wider = BufferOptions::new(1.0).joins(BufferJoins::Mitre(5.0));
    /// let result = MapResult::new([("square", &square)], &MapTask::Buffer(wider))?;
    /// assert_eq!(result.answer().measure, 16.0);
    /// # Ok(()) }
    /// ```
    pub fn new<'a>(
        models: impl IntoIterator<Item = (&'a str, &'a Model)>,
        task: &MapTask,
    ) -> Result<Self, Error> {
        let models: Vec<(&str, &Model)> = models.into_iter().collect();
        for &(name, model) in &models {
            model.require_finite().map_err(|error| error.in_file(name))?;
        }
        let layer = MapLayer::new(&models)?;
        let mut change = match task {
            MapTask::Repair(method) => repaired_map(&layer, *method, true)?.1,
            MapTask::Buffer(options) => buffered(&layer, options)?,
            MapTask::Clip(frame) => clipped(&layer, *frame)?,
            MapTask::Node(options) => noded(&layer, options)?,
            MapTask::Polygonize(options) => polygonized(&layer, options)?,
            MapTask::Simplify(tolerance) => simplified(&layer, *tolerance)?,
            MapTask::Coverage { gap_width } => examined(&layer, *gap_width)?,
        };
        change.answer.task = task.name().to_owned();
        let has_heights = layer.has_heights && change.keeps_heights;
        if layer.has_heights && !has_heights {
            let message = format!("{} decides in the plane: heights are left out", task.name());
            change.answer.remarks.push(Remark::new(RemarkCode::HeightsLeftOut, message));
        }
        let mut builder = MapBuilder::new(has_heights);
        let counts = &mut change.answer.counts;
        let (mut area, mut length, mut has_properties) = (Sum::default(), Sum::default(), false);
        for (feature, geometry) in &change.geometries {
            let feature = feature.map(|feature| &layer.features[feature]);
            let (properties, id) =
                feature.map_or(("{}", ""), |feature| (&feature.properties[..], &feature.id[..]));
            has_properties |= properties != "{}" || !id.is_empty();
            builder.add(geometry, properties, id);
            counts.features += 1;
            counts.polygons += geometry.polygons.len();
            counts.holes += geometry.polygons.iter().map(|rings| rings.len() - 1).sum::<usize>();
            counts.lines += geometry.lines.len();
            counts.points += geometry.points.len();
            counts.vertices += geometry.corners().count();
            area.add(drawn_area(&geometry.polygons));
            for line in &geometry.lines {
                for side in line.windows(2) {
                    length.add((side[1][0] - side[0][0]).hypot(side[1][1] - side[0][1]));
                }
            }
        }
        change.answer.measure = area.value();
        change.answer.length = length.value();
        let remarks = layer.remarks.into_iter().chain(std::mem::take(&mut change.answer.remarks)).collect();
        let answer = MapAnswer { inputs: layer.inputs, remarks, ..change.answer };
        Ok(Self { answer, model: builder.finish(layer.reference)?, has_heights, has_properties })
    }

    /// What was done, in numbers.
    ///
    /// # Examples
    /// See [`MapResult`].
    pub fn answer(&self) -> &MapAnswer {
        &self.answer
    }

    /// The new map.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{MapResult, MapTask};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let cross = coface_io::read(&b"LINESTRING (0 0, 2 2)\nLINESTRING (0 2, 2 0)"[..], coface_io::Format::Wkt)?;
    /// assert_eq!(MapResult::new([("cross", &cross)], &MapTask::Node(Default::default()))?.model().lines().len(), 4);
    /// # Ok(()) }
    /// ```
    pub fn model(&self) -> &Model {
        &self.model
    }

    /// Writes the new map; one that draws nothing is an empty geometry.
    ///
    /// # Errors
    /// [`ErrorKind::UnsupportedFormat`](coface_algebra::ErrorKind::UnsupportedFormat) if the format cannot hold lines; [`ErrorKind::Io`](coface_algebra::ErrorKind::Io) from the output.
    ///
    /// # Examples
    /// See [`MapResult`].
    pub fn write(&self, out: &mut dyn Write, format: Format) -> Result<(), Error> {
        let is_well_known = matches!(format, Format::Wkt | Format::Wkb | Format::WkbHex);
        if is_well_known && self.model.vertex_count() == 0 {
            return io::write_empty_polygon(self.model.reference_system(), out, format);
        }
        io::write(&self.model, out, format)
    }

    /// What a file in this format does not keep: properties, heights, the reference system.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{MapResult, MapTask};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let line = coface_io::read(&b"LINESTRING Z (0 0 1, 2 2 1)"[..], coface_io::Format::Wkt)?;
    /// let result = MapResult::new([("line", &line)], &MapTask::Clip([0.0, 0.0, 1.0, 1.0]))?;
    /// assert_eq!([coface_io::Format::Wkt, coface_io::Format::Svg].map(|format| result.losses(format).len()), [0, 1]);
    /// # Ok(()) }
    /// ```
    pub fn losses(&self, format: Format) -> Vec<Remark> {
        let mut losses = Vec::new();
        let mut lose = |what: &str| {
            let message = format!("a file of {} does not keep {what}", format.title());
            losses.push(Remark::new(RemarkCode::FormatKeepsLess, message));
        };
        if self.has_properties && format != Format::GeoJson {
            lose("properties and ids of features: they are left out");
        }
        if self.has_heights && !format.keeps_heights() {
            lose("heights of a map: they are left out");
        }
        losses.extend(self.model.reference_system().and_then(|system| reference_loss(system, format)));
        losses
    }
}

/// An answer that says nothing yet.
pub(super) fn blank() -> MapAnswer {
    MapAnswer {
        task: String::new(),
        dimension: 2,
        counts: MapCounts::default(),
        measure: 0.0,
        length: 0.0,
        inputs: Vec::new(),
        repair: None,
        arcs: None,
        left_out: None,
        simplification: None,
        coverage: None,
        remarks: Vec::new(),
    }
}

/// The valid polygons of all features, and the map with them.
pub(super) fn repaired_map(
    layer: &MapLayer,
    method: RepairMethod,
    is_task: bool,
) -> Result<(Vec<Vec<Rings>>, Change), Error> {
    let own: Vec<Result<Repaired, Error>> =
        layer.features.par_iter().map(|feature| repaired(&feature.geometry.polygons, method)).collect();
    let own = own.into_iter().collect::<Result<Vec<Repaired>, Error>>()?;
    let mut answer = MapRepairAnswer {
        method: method.name().to_owned(),
        features: 0,
        faults: Vec::new(),
        area_before: 0.0,
        area: 0.0,
        area_changed: 0.0,
        rings_turned: 0,
        vanished: 0,
        largest_movement: 0.0,
    };
    let starts = layer.polygon_starts();
    let mut places = Vec::new();
    let (mut polygons, mut geometries) = (Vec::new(), Vec::new());
    for (number, (done, feature)) in own.into_iter().zip(&layer.features).enumerate() {
        answer.rings_turned += done.turned;
        if let Some(area) = done.area {
            answer.features += 1;
            answer.area_before += drawn_area(&feature.geometry.polygons);
            answer.area += area;
            answer.area_changed += done.changed;
            answer.vanished += usize::from(done.polygons.is_empty());
            answer.largest_movement = answer.largest_movement.max(done.largest_movement);
        }
        for fault in &done.faults {
            let ring = |&ring: &u32| {
                let (polygon, ring) = done.rings[ring as usize];
                (starts[number] + polygon, ring)
            };
            let rings = fault.rings.iter().map(ring).collect();
            places.push((fault.kind, DrawnPlace { point: fault.point, rings }));
        }
        let geometry = Geometry { polygons: done.polygons.clone(), ..feature.geometry.clone() };
        geometries.push((Some(number), geometry));
        polygons.push(done.polygons);
    }
    let mut remarks = Vec::new();
    for kind in PolygonFaultKind::ALL {
        let places: Vec<DrawnPlace> =
            places.iter().filter(|(own, _)| *own == kind).map(|(_, place)| place.clone()).collect();
        if !places.is_empty() {
            let points = places.iter().map(|place| crate::answer::Place::point(&place.point));
            let fault = DrawnFault { kind, places: places.clone() };
            let message = format!("{}; repaired", fault.sentence());
            remarks.push(Remark::new(RemarkCode::InvalidPolygon, message).at(places.len(), points));
            answer.faults.push(DrawnFaultAnswer::of(&fault, LISTED));
        }
    }
    if answer.features > 0 {
        let mut message = format!(
            "{} made valid by {}: area {} before as it was drawn, {} now; {} of it changed sides",
            text::count(answer.features, "feature"),
            answer.method,
            text::number(answer.area_before),
            text::number(answer.area),
            text::number(answer.area_changed),
        );
        if answer.vanished > 0 {
            message += &format!("; {} enclose nothing", text::count(answer.vanished, "feature"));
        }
        remarks.push(Remark::new(RemarkCode::ModelRepaired, message).at(answer.features, []));
    }
    if is_task && answer.rings_turned > 0 {
        let message = format!(
            "{} reversed: outer rings run counterclockwise and holes clockwise (RFC 7946)",
            text::count(answer.rings_turned, "ring")
        );
        remarks.push(Remark::new(RemarkCode::ModelRepaired, message).at(answer.rings_turned, []));
    }
    let repair = (is_task || answer.features > 0).then_some(answer);
    let answer = MapAnswer { repair, remarks, ..blank() };
    Ok((polygons, Change { geometries, keeps_heights: true, answer }))
}
