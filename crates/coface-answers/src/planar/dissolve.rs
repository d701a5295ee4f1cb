//! Features of maps united by the values of their properties.

use super::boolean::{BooleanRequest, RegionBoolean};
use super::drawing::{NO_FEATURE, NO_RING, PlanarDrawing, Polygon, Region, Ring};
use super::exact::points_rounded;
use super::feature_model::FeatureModel;
use crate::answer::{DissolveAnswer, DissolvedGroupAnswer, Remark, RemarkCode};
use crate::text;
use coface_algebra::Error;
use coface_arrange::boolean::BooleanFormula;
use coface_geometry::{Positions, Sum};
use coface_io as io;
use coface_io::geojson::{equal_text, property_pairs};
use coface_io::{Format, Model};
use rayon::prelude::*;
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::io::Write;

/// Names of properties that a message lists.
const LISTED: usize = 5;

/// Which features are united, and how.
///
/// # Examples
/// ```
/// use coface_answers::DissolveRequest;
/// assert_eq!(DissolveRequest::new(["zone", "year"]).names(), ["zone", "year"]);
/// ```
#[derive(Clone, Debug)]
pub struct DissolveRequest {
    names: Vec<String>,
    boolean: BooleanRequest,
}

impl DissolveRequest {
    /// Features with the same values of all these properties are united.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_answers::DissolveRequest::new(["zone"]).names(), ["zone"]);
    /// ```
    pub fn new<S: Into<String>>(names: impl IntoIterator<Item = S>) -> Self {
        Self { names: names.into_iter().map(Into::into).collect(), boolean: BooleanRequest::default() }
    }

    /// How each union is made.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{BooleanRequest, DissolveRequest};
    /// assert_eq!(DissolveRequest::new(["zone"]).boolean(BooleanRequest::default()).names().len(), 1);
    /// ```
    pub fn boolean(mut self, boolean: BooleanRequest) -> Self {
        self.boolean = boolean;
        self
    }

    /// The names of the properties.
    ///
    /// # Examples
    /// ```
    /// assert!(coface_answers::DissolveRequest::new::<String>([]).names().is_empty());
    /// ```
    pub fn names(&self) -> &[String] {
        &self.names
    }
}

/// Features united by the values of properties: one feature for each list of values.
///
/// Groups stand in the order of their first features. Features without the properties, or with null for all of them, are a group of
/// their own, the last. A feature of the result has the properties of the request, then `features` (how many were united) and `area`, and what all features of the
/// group have with one value. Groups are united each by itself: two of them may overlap where their features do.
///
/// # Examples
/// Two lots of one owner lose their common side.
/// ```
/// use coface_answers::{DissolveRequest, Dissolved, PlanarDrawing, RegionSource};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let text = br#"{"type": "FeatureCollection", "features": [
///     {"type": "Feature", "properties": {"owner": "A"}, "geometry":
///         {"type": "Polygon", "coordinates": [[[0, 0], [2, 0], [2, 1], [0, 1], [0, 0]]]}},
///     {"type": "Feature", "properties": {"owner": "A"}, "geometry":
///         {"type": "Polygon", "coordinates": [[[2, 0], [3, 0], [3, 1], [2, 1], [2, 0]]]}}]}"#;
/// let lots = coface_io::read(&text[..], coface_io::Format::GeoJson)?;
/// let drawing = PlanarDrawing::new([("lots", &lots)], RegionSource::Models)?;
/// let dissolved = Dissolved::new(&drawing, &DissolveRequest::new(["owner"]))?;
/// let answer = dissolved.answer();
/// assert_eq!((answer.measure, answer.groups.len(), answer.groups[0].polygons), (3.0, 1, 1));
/// assert_eq!(dissolved.model().features().properties(0), r#"{"owner":"A","features":2,"area":3}"#);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct Dissolved {
    answer: DissolveAnswer,
    model: Model,
    losses: BTreeMap<Format, Vec<Remark>>,
}

/// Features with the same values of the properties that were asked for.
#[derive(Default)]
struct Group {
    /// The texts of the values, null for what is missing.
    values: Vec<String>,
    feature_count: usize,
    /// What all features have with one value: the key, its value, and a text that equal values have in common.
    common: Option<Vec<(String, String, String)>>,
}

impl Group {
    /// One more feature with these properties.
    fn add(&mut self, pairs: &[(String, &str)]) {
        self.feature_count += 1;
        match &mut self.common {
            None => {
                let own =
                    pairs.iter().map(|(key, value)| (key.clone(), (*value).to_owned(), equal_text(value)));
                self.common = Some(own.collect());
            }
            Some(common) if !common.is_empty() => {
                let values: BTreeMap<&str, &str> =
                    pairs.iter().map(|(key, value)| (key.as_str(), *value)).collect();
                common.retain(|(key, text, known)| {
                    let value = values.get(key.as_str());
                    value.is_some_and(|value| *value == text.as_str() || equal_text(value) == *known)
                });
            }
            Some(_) => {}
        }
    }

    /// The properties of the united feature, the text of a JSON object.
    fn properties(&self, names: &[String], area: f64) -> String {
        let mut pairs: Vec<(&str, String)> =
            names.iter().map(String::as_str).zip(self.values.iter().cloned()).collect();
        let own = [("features", Value::from(self.feature_count)), ("area", number(area))];
        let common = self.common.iter().flatten().map(|(key, value, _)| (key.as_str(), value.clone()));
        for (key, value) in own.map(|(key, value)| (key, value.to_string())).into_iter().chain(common) {
            if pairs.iter().all(|(other, _)| *other != key) {
                pairs.push((key, value));
            }
        }
        let pairs: Vec<String> =
            pairs.iter().map(|(key, value)| format!("{}:{value}", Value::from(*key))).collect();
        format!("{{{}}}", pairs.join(","))
    }
}

/// A number as JSON; whole ones have no point.
fn number(value: f64) -> Value {
    if value.fract() == 0.0 && value.abs() < 2f64.powi(53) {
        Value::from(value as i64)
    } else {
        Value::from(value)
    }
}

impl Dissolved {
    /// Unites the features of a drawing.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if no name is asked for, or naming a property that no feature with polygons has; those of
    /// [`RegionBoolean::new`].
    ///
    /// # Complexity
    /// That of the unions, and $O(n \log n)$ for n features.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{DissolveRequest, Dissolved, PlanarDrawing, RegionSource};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = coface_io::read(&b"POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))"[..], coface_io::Format::Wkt)?;
    /// let drawing = PlanarDrawing::new([("square", &square)], RegionSource::Models)?;
    /// let fault = Dissolved::new(&drawing, &DissolveRequest::new(["zone"])).unwrap_err();
    /// assert!(fault.message().contains("\"zone\""));
    /// # Ok(()) }
    /// ```
    pub fn new(drawing: &PlanarDrawing, request: &DissolveRequest) -> Result<Self, Error> {
        drawing.check_regions()?;
        let names = &request.names;
        if names.is_empty() {
            return Err(Error::invalid("no property is named by which features are united")
                .with_cure("name one that the features have"));
        }
        let (groups, group_of_polygon) = groups_of(drawing, names)?;
        let parts = parts_of(drawing, &group_of_polygon, groups.len());
        let formula = BooleanFormula::union(1);
        let results: Vec<Result<RegionBoolean, Error>> =
            parts.into_par_iter().map(|part| RegionBoolean::new(part, &formula, &request.boolean)).collect();
        let results = results.into_iter().collect::<Result<Vec<RegionBoolean>, Error>>()?;
        let mut map = FeatureModel::new(!drawing.heights.is_empty());
        let mut answers = Vec::with_capacity(groups.len());
        let (mut sum, mut f_vector) = (Sum::default(), [0; 3]);
        let mut remarks = drawing.remarks.clone();
        let exact = drawing.exact.iter().map(|part| &drawing.names[part.model as usize]);
        remarks.extend(exact.map(|name| points_rounded(name, "its features are united each by itself")));
        remarks.extend(drawing.remarks_of_lines(request.boolean.rule, true));
        let (mut of_groups, mut without_heights) = (Vec::new(), 0);
        for (group, result) in groups.iter().zip(&results) {
            let answer = result.answer();
            sum.add(answer.measure);
            f_vector = std::array::from_fn(|i| f_vector[i] + answer.f_vector[i]);
            of_groups.extend(answer.remarks);
            map.begin_feature(group.properties(names, answer.measure));
            let positions = result.lifted_positions()?;
            if positions.dimension() == 2 && !drawing.heights.is_empty() {
                without_heights += positions.len();
            }
            map.set_vertices(positions);
            let outline = &result.found.outline;
            (0..outline.polygon_count()).for_each(|polygon| map.add_polygon(outline.rings_of(polygon)));
            answers.push(DissolvedGroupAnswer {
                values: group.values.iter().map(|text| parsed(text)).collect(),
                features: group.feature_count,
                measure: answer.measure,
                polygons: answer.polygons,
                holes: answer.holes,
                components: answer.components,
            });
        }
        remarks.extend(remark_of_missing(&groups, names));
        remarks.extend(joined(of_groups));
        if without_heights > 0 {
            let vertices = text::count(without_heights, "vertex");
            let message =
                format!("no feature of some groups has heights: {vertices} of them are at height 0");
            remarks.push(Remark::new(RemarkCode::HeightsAssumed, message).at(without_heights, []));
        }
        let losses = [Format::Wkt, Format::Wkb, Format::WkbHex, Format::Svg, Format::GeoJson, Format::Lines]
            .map(|format| (format, drawing.losses(format)));
        let answer = DissolveAnswer {
            dimension: 2,
            properties: names.clone(),
            measure: sum.value(),
            f_vector,
            groups: answers,
            inputs: drawing.input_answers(),
            remarks,
        };
        Ok(Self {
            answer,
            model: map.finish(drawing.reference.clone())?,
            losses: losses.into_iter().collect(),
        })
    }

    /// What became of the features.
    ///
    /// # Examples
    /// See [`Dissolved`].
    pub fn answer(&self) -> &DissolveAnswer {
        &self.answer
    }

    /// The united features as a map.
    ///
    /// # Examples
    /// See [`Dissolved`].
    pub fn model(&self) -> &Model {
        &self.model
    }

    /// Writes the united features: as GeoJSON with their properties, as WKT and WKB a `POLYGON` or `MULTIPOLYGON` each.
    ///
    /// # Errors
    /// [`ErrorKind::UnsupportedFormat`](coface_algebra::ErrorKind::UnsupportedFormat) if the format cannot hold lines; [`ErrorKind::Io`](coface_algebra::ErrorKind::Io) from the output.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{DissolveRequest, Dissolved, PlanarDrawing, RegionSource};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = br#"{"type": "Feature", "properties": {"use": "wood"}, "geometry":
    ///     {"type": "Polygon", "coordinates": [[[0, 0], [2, 0], [2, 1], [0, 0]]]}}"#;
    /// let wood = coface_io::read(&text[..], coface_io::Format::GeoJson)?;
    /// let drawing = PlanarDrawing::new([("wood", &wood)], RegionSource::Models)?;
    /// let mut written = Vec::new();
    /// let dissolved = Dissolved::new(&drawing, &DissolveRequest::new(["use"]))?;
    /// dissolved.write(&mut written, coface_io::Format::Wkt)?;
    /// assert_eq!(written, b"POLYGON ((0 0, 2 0, 2 1, 0 0))\n");
    /// # Ok(()) }
    /// ```
    pub fn write(&self, out: &mut dyn Write, format: Format) -> Result<(), Error> {
        let is_well_known = matches!(format, Format::Wkt | Format::Wkb | Format::WkbHex);
        if is_well_known && self.model.lines().is_empty() {
            return io::write_empty_polygon(self.model.reference_system(), out, format);
        }
        io::write(&self.model, out, format)
    }

    /// What a file in this format does not keep: properties, heights, the reference system.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{DissolveRequest, Dissolved, PlanarDrawing, RegionSource};
    /// use coface_io::Format;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = br#"{"type": "Feature", "properties": {"use": "wood"}, "geometry":
    ///     {"type": "Polygon", "coordinates": [[[0, 0], [2, 0], [2, 1], [0, 0]]]}}"#;
    /// let wood = coface_io::read(&text[..], Format::GeoJson)?;
    /// let drawing = PlanarDrawing::new([("wood", &wood)], RegionSource::Models)?;
    /// let dissolved = Dissolved::new(&drawing, &DissolveRequest::new(["use"]))?;
    /// assert_eq!([Format::GeoJson, Format::Wkt].map(|format| dissolved.losses(format).len()), [0, 1]);
    /// # Ok(()) }
    /// ```
    pub fn losses(&self, format: Format) -> Vec<Remark> {
        let mut losses = self.losses.get(&format).cloned().unwrap_or_default();
        if format != Format::GeoJson {
            let count = self.answer.groups.len();
            let message = format!(
                "a file of {} does not keep properties of features: those of {} are left out",
                format.title(),
                text::count(count, "feature")
            );
            losses.push(Remark::new(RemarkCode::FormatKeepsLess, message).at(count, []));
        }
        losses
    }
}

/// A value by its text.
fn parsed(text: &str) -> Value {
    // What is nested too deep stays as text.
    serde_json::from_str(text).unwrap_or_else(|_| Value::from(text))
}

/// The groups, and that of each polygon.
fn groups_of(drawing: &PlanarDrawing, names: &[String]) -> Result<(Vec<Group>, Vec<u32>), Error> {
    let mut groups: Vec<Group> = Vec::new();
    let (mut by_values, mut of_feature) = (BTreeMap::new(), BTreeMap::new());
    let (mut known, mut found) = (BTreeSet::new(), BTreeSet::new());
    let mut group_of_polygon = Vec::with_capacity(drawing.polygons.len());
    for polygon in &drawing.polygons {
        if let Some(&group) = of_feature.get(&polygon.feature).filter(|_| polygon.feature != NO_FEATURE) {
            group_of_polygon.push(group);
            continue;
        }
        let properties = match polygon.feature {
            NO_FEATURE => "{}",
            feature => drawing.features.properties(feature),
        };
        let pairs = property_pairs(properties)?;
        // Of keys that stand there twice the last counts.
        let value = |name: &String| pairs.iter().rev().find(|(key, _)| key == name).map(|&(_, value)| value);
        found.extend(names.iter().filter(|name| value(name).is_some()).cloned());
        known.extend(pairs.iter().map(|(key, _)| key.clone()));
        let values: Vec<&str> = names.iter().map(|name| value(name).unwrap_or("null")).collect();
        let equal: Vec<String> = values.iter().map(|value| equal_text(value)).collect();
        let group = *by_values.entry(equal).or_insert_with(|| {
            let values = values.iter().map(|&value| value.to_owned()).collect();
            groups.push(Group { values, ..Group::default() });
            groups.len() as u32 - 1
        });
        groups[group as usize].add(&pairs);
        of_feature.insert(polygon.feature, group);
        group_of_polygon.push(group);
    }
    if let Some(name) = names.iter().find(|name| !found.contains(*name)) {
        let others: Vec<String> = known.iter().take(LISTED).map(|key| format!("\"{key}\"")).collect();
        let more = if known.len() > LISTED { ", .." } else { "" };
        let fault = Error::invalid(format!("no feature with polygons has the property \"{name}\""));
        return Err(match others.is_empty() {
            true => fault.with_cure("give GeoJSON or TopoJSON whose features have properties"),
            false => fault.with_cure(format!("name one that there is: {}{more}", others.join(", "))),
        });
    }
    // Those without values come last.
    let is_missing = |group: &Group| group.values.iter().all(|value| value == "null");
    let mut order: Vec<usize> = (0..groups.len()).collect();
    order.sort_by_key(|&group| is_missing(&groups[group]));
    let mut places = vec![0; groups.len()];
    (0..).zip(&order).for_each(|(place, &group)| places[group] = place);
    group_of_polygon.iter_mut().for_each(|group| *group = places[*group as usize]);
    let mut taken: Vec<Option<Group>> = groups.into_iter().map(Some).collect();
    Ok((order.into_iter().filter_map(|group| taken[group].take()).collect(), group_of_polygon))
}

/// The polygons of each group as a drawing with one region.
fn parts_of(drawing: &PlanarDrawing, group_of_polygon: &[u32], count: usize) -> Vec<PlanarDrawing> {
    let mut parts: Vec<PlanarDrawing> = (0..count)
        .map(|_| PlanarDrawing { names: drawing.names.clone(), ..PlanarDrawing::default() })
        .collect();
    let mut flats: Vec<Vec<f64>> = vec![Vec::new(); count];
    let mut last_polygons = vec![u32::MAX; count];
    // The group that has each vertex last, and its number there.
    let mut numbers = vec![(u32::MAX, 0); drawing.positions.len()];
    let mut start = 0;
    for ring in drawing.ring_of_segment.chunk_by(|a, b| a == b) {
        let segments = &drawing.segments[start..start + ring.len()];
        start += ring.len();
        if ring[0] == NO_RING {
            continue;
        }
        let Ring { polygon: number, is_hole } = drawing.rings[ring[0] as usize];
        let group = group_of_polygon[number as usize];
        let (part, flat) = (&mut parts[group as usize], &mut flats[group as usize]);
        let polygon = drawing.polygons[number as usize];
        if std::mem::replace(&mut last_polygons[group as usize], number) != number {
            if part.regions.is_empty() {
                let model = drawing.regions[polygon.region as usize].model;
                let name = drawing.names[model as usize].clone();
                part.regions.push(Region { name, model, open_at: None, is_empty: false });
            }
            part.polygons.push(Polygon { region: 0, feature: NO_FEATURE, ..polygon });
        }
        part.rings.push(Ring { polygon: part.polygons.len() as u32 - 1, is_hole });
        for segment in segments {
            let ends = segment.map(|end| {
                let known = &mut numbers[end as usize];
                if known.0 != group {
                    *known = (group, flat.len() as u32 / 2);
                    flat.extend_from_slice(&drawing.place(end));
                    part.heights.extend(drawing.heights.get(end as usize));
                }
                known.1
            });
            part.segments.push(ends);
            part.ring_of_segment.push(part.rings.len() as u32 - 1);
        }
    }
    for (part, flat) in parts.iter_mut().zip(flats) {
        let ends = |count: usize| {
            let mut starts = vec![count as u32; part.names.len() + 1];
            starts[0] = 0;
            starts
        };
        (part.vertex_starts, part.segment_starts) = (ends(flat.len() / 2), ends(part.segments.len()));
        if part.heights.iter().all(|height| height.is_nan()) {
            part.heights.clear();
        }
        part.positions = Positions::from_flat(2, flat).expect("two coordinates of each vertex");
    }
    parts
}

/// That features do not have the properties.
fn remark_of_missing(groups: &[Group], names: &[String]) -> Option<Remark> {
    let group = groups.last().filter(|group| group.values.iter().all(|value| value == "null"))?;
    let names: Vec<String> = names.iter().map(|name| format!("\"{name}\"")).collect();
    let (has, is) = if group.feature_count == 1 { ("has", "is") } else { ("have", "are") };
    let message = format!(
        "{} {has} no value of {} and {is} a group of their own",
        text::count(group.feature_count, "feature"),
        names.join(", ")
    );
    let message = if group.feature_count == 1 { message.replace("their", "its") } else { message };
    Some(Remark::new(RemarkCode::PropertyMissing, message).at(group.feature_count, []))
}

/// Remarks of several groups, those of one code together.
fn joined(remarks: Vec<Remark>) -> Vec<Remark> {
    let mut joined: Vec<(Remark, usize)> = Vec::new();
    for remark in remarks {
        match joined.iter_mut().find(|(first, _)| first.code == remark.code) {
            None => joined.push((remark, 0)),
            Some((first, others)) => {
                let places = std::mem::take(&mut first.places);
                let count = (first.count + remark.count) as usize;
                *first = first.clone().at(count, places.into_iter().chain(remark.places));
                *others += 1;
            }
        }
    }
    joined
        .into_iter()
        .map(|(mut remark, others)| {
            match others {
                0 => {}
                1 => remark.message += "; likewise in 1 more group",
                _ => remark.message += &format!("; likewise in {others} more groups"),
            }
            remark
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{RegionSource, Report};
    use proptest::prelude::*;

    fn read(text: &str) -> Model {
        coface_io::read(text.as_bytes(), Format::GeoJson).unwrap()
    }

    fn dissolved(model: &Model, names: &[&str]) -> Result<Dissolved, Error> {
        let drawing = PlanarDrawing::new([("map", model)], RegionSource::Models).unwrap();
        Dissolved::new(&drawing, &DissolveRequest::new(names.iter().copied()))
    }

    fn written(dissolved: &Dissolved, format: Format) -> String {
        let mut text = Vec::new();
        dissolved.write(&mut text, format).unwrap();
        String::from_utf8(text).unwrap()
    }

    /// Rectangles with properties.
    fn map(features: &[([i32; 4], &str)]) -> String {
        let feature = |([x, y, w, h], properties): &([i32; 4], &str)| {
            let (right, top) = (x + w, y + h);
            format!(
                "{{\"type\":\"Feature\",\"properties\":{properties},\"geometry\":{{\"type\":\"Polygon\",\"coordinates\":\
                 [[[{x},{y}],[{right},{y}],[{right},{top}],[{x},{top}],[{x},{y}]]]}}}}"
            )
        };
        let features: Vec<String> = features.iter().map(feature).collect();
        format!("{{\"type\":\"FeatureCollection\",\"features\":[{}]}}", features.join(","))
    }

    #[test]
    fn features_are_united_by_value() {
        let text = map(&[
            ([0, 0, 2, 1], r#"{"zone":"A","year":1,"state":"X","area":99}"#),
            ([9, 0, 1, 1], r#"{"state":"X"}"#),
            ([2, 0, 1, 1], r#"{"zone":"A","year":1.0,"state":"X","lot":7}"#),
            ([0, 1, 3, 1], r#"{"zone":"B","year":2,"state":"X"}"#),
            ([5, 5, 1, 1], r#"{"zone":"A","year":2,"state":"X"}"#),
            ([7, 7, 1, 1], r#"{"zone":null,"state":"Y"}"#),
        ]);
        let model = read(&text);
        let by_zone = dissolved(&model, &["zone"]).unwrap();
        let features = by_zone.model().features();
        let expected = [
            r#"{"zone":"A","features":3,"area":4,"state":"X"}"#,
            r#"{"zone":"B","features":1,"area":3,"year":2,"state":"X"}"#,
            r#"{"zone":null,"features":2,"area":2}"#,
        ];
        assert_eq!([0, 1, 2].map(|feature| features.properties(feature)), expected);
        let answer = by_zone.answer();
        let polygons: Vec<usize> = answer.groups.iter().map(|group| group.polygons).collect();
        assert_eq!((answer.measure, polygons), (9.0, vec![2, 1, 2]));
        let remark = answer.remarks.iter().find(|remark| remark.code == RemarkCode::PropertyMissing).unwrap();
        assert_eq!(
            (remark.count, &remark.message[..]),
            (2, "2 features have no value of \"zone\" and are a group of their own")
        );
        let by_both = dissolved(&model, &["zone", "year"]).unwrap();
        let values: Vec<String> = by_both
            .answer()
            .groups
            .iter()
            .map(|group| Value::from(group.values.clone()).to_string())
            .collect();
        assert_eq!(values, [r#"["A",1]"#, r#"["B",2]"#, r#"["A",2]"#, "[null,null]"]);
        let wkt = written(&by_zone, Format::Wkt);
        assert_eq!(
            wkt.lines().map(|line| &line[..12]).collect::<Vec<_>>(),
            ["MULTIPOLYGON", "POLYGON ((0 ", "MULTIPOLYGON"]
        );
    }

    #[test]
    fn properties_that_are_not_there_are_refused() {
        let model = read(&map(&[([0, 0, 1, 1], r#"{"zone":"A","year":1}"#)]));
        let fault = dissolved(&model, &["zone", "Zone"]).unwrap_err();
        assert!(fault.message().contains("\"Zone\""), "{fault}");
        assert_eq!(fault.cure(), Some("name one that there is: \"year\", \"zone\""));
        assert!(dissolved(&model, &[]).is_err());
        let line = read(
            r#"{"type":"Feature","properties":{"zone":1},"geometry":{"type":"LineString","coordinates":[[0,0],[1,1]]}}"#,
        );
        assert!(dissolved(&line, &["zone"]).is_err());
    }

    #[test]
    fn heights_and_reference_systems_are_kept() {
        let text = r#"{"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"EPSG:25832"}},"features":[
            {"type":"Feature","properties":{"a":1},"geometry":{"type":"Polygon","coordinates":[[[0,0,5],[2,0,5],[2,2,7],[0,0,5]]]}},
            {"type":"Feature","properties":{"a":2},"geometry":{"type":"Polygon","coordinates":[[[4,0,5],[6,0,5],[6,2,7],[4,0,5]]]}}]}"#;
        let wkt = written(&dissolved(&read(text), &["a"]).unwrap(), Format::Wkt);
        let expected = "SRID=25832;POLYGON Z ((0 0 5, 2 0 5, 2 2 7, 0 0 5))\nSRID=25832;POLYGON Z ((4 0 5, 6 0 5, 6 2 7, 4 0 5))\n";
        assert_eq!(wkt, expected);
    }

    proptest! {
        #[test]
        fn groups_are_the_unions_of_their_features(
            boxes in prop::collection::vec(((0..9i32, 0..9i32, 1..5i32, 1..5i32), 0..4usize), 1..14),
        ) {
            const VALUES: [&str; 4] = [r#"{"k":"a"}"#, r#"{"k":2}"#, "{}", r#"{"k":[1,{"b":null}]}"#];
            let features: Vec<([i32; 4], &str)> =
                boxes.iter().map(|&((x, y, w, h), value)| ([x, y, w, h], VALUES[value])).collect();
            prop_assume!(boxes.iter().any(|(_, value)| *value != 2));
            let once = dissolved(&read(&map(&features)), &["k"]).unwrap();
            let mut areas = BTreeMap::new();
            for (value, properties) in VALUES.iter().enumerate() {
                // Unit squares that some box of the group covers.
                let own = || boxes.iter().filter(|(_, other)| *other == value).map(|(own, _)| own);
                let covered = (0..14).flat_map(|x| (0..14).map(move |y| (x, y))).filter(|&(x, y)| {
                    own().any(|&(left, low, w, h)| (left..left + w).contains(&x) && (low..low + h).contains(&y))
                });
                if own().next().is_some() {
                    let value = property_pairs(properties).unwrap().first().map_or("null", |pair| pair.1);
                    areas.insert(value.to_owned(), covered.count() as f64);
                }
            }
            let found: BTreeMap<String, f64> =
                once.answer().groups.iter().map(|group| (group.values[0].to_string(), group.measure)).collect();
            prop_assert_eq!(&found, &areas);
            // Read back, it is the same again, and valid.
            let text = written(&once, Format::GeoJson);
            let back = read(&text);
            let report = Report::of(back.clone()).unwrap();
            prop_assert!(report.drawn_polygons().is_some_and(|found| found.faults().is_empty()), "{}", text);
            let twice = dissolved(&back, &["k"]).unwrap();
            let ones = |dissolved: &Dissolved| -> Vec<(String, u64, usize, usize)> {
                let groups = dissolved.answer().groups.iter();
                groups.map(|group| (group.values[0].to_string(), group.measure.to_bits(), group.polygons, group.holes)).collect()
            };
            prop_assert_eq!(ones(&once), ones(&twice));
            prop_assert_eq!(written(&once, Format::Wkt), written(&twice, Format::Wkt));
        }
    }
}
