//! Properties of the features of drawings, and what cells and polygons get of them.

use super::arrangement::DrawingArrangement;
use super::boolean::RegionBoolean;
use super::drawing::NO_FEATURE;
use coface_algebra::{EdgeId, Error, ErrorKind, FaceId, HalfedgeId, VertexId};
use coface_io::FeatureTable;
use coface_io::geojson::MergedProperties;
use serde::Serialize;
use serde_json::Value;
use std::collections::BTreeMap;

/// The features of all models of a drawing, numbered one model after the other.
#[derive(Clone, Debug, Default)]
pub(super) struct DrawnFeatures {
    tables: Vec<FeatureTable>,
    /// The first feature of each table, and of none behind the last.
    starts: Vec<u32>,
    /// The feature of each segment; empty up to the first model with features.
    of_segments: Vec<u32>,
    /// Features with the vertices that are points of them.
    points: Vec<(u32, u32)>,
}

impl DrawnFeatures {
    /// The features of a model come next, behind so many segments; gives the number of the first.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] for more than 2^31 features.
    pub(super) fn add_table(&mut self, table: &FeatureTable, segment_count: usize) -> Result<u32, Error> {
        let first = self.starts.last().copied().unwrap_or(0);
        if table.is_empty() {
            return Ok(first);
        }
        if first as usize + table.len() > 1 << 31 {
            return Err(Error::new(ErrorKind::TooLarge, "more than 2^31 features in all"));
        }
        if self.tables.is_empty() {
            self.starts.push(0);
            self.of_segments.resize(segment_count, NO_FEATURE);
        }
        self.tables.push(table.clone());
        self.starts.push(first + table.len() as u32);
        Ok(first)
    }

    /// The number of a feature of the last table, which begins with this one, if it has properties.
    pub(super) fn described(&self, first: u32, feature: Option<usize>) -> u32 {
        let table = self.tables.last();
        let has_properties = |feature: &usize| table.is_some_and(|table| table.properties(*feature) != "{}");
        feature.filter(has_properties).map_or(NO_FEATURE, |feature| first + feature as u32)
    }

    /// Segments up to this one are of a feature, but those that are known.
    pub(super) fn extend_to(&mut self, segment_count: usize, feature: u32) {
        if !self.tables.is_empty() {
            self.of_segments.resize(segment_count, feature);
        }
    }

    pub(super) fn add_point(&mut self, feature: u32, vertex: u32) {
        if feature != NO_FEATURE {
            self.points.push((feature, vertex));
        }
    }

    /// The feature that all segments from this one on are of.
    pub(super) fn only_one_from(&self, segment: u32) -> u32 {
        let features = self.of_segments.get(segment as usize..).unwrap_or_default();
        match features.first() {
            Some(first) if features.iter().all(|feature| feature == first) => *first,
            _ => NO_FEATURE,
        }
    }

    /// The number of features.
    pub(super) fn count(&self) -> usize {
        self.starts.last().map_or(0, |&count| count as usize)
    }

    /// The properties of a feature.
    pub(super) fn properties(&self, feature: u32) -> &str {
        let table = self.starts.partition_point(|&start| start <= feature) - 1;
        self.tables[table].properties((feature - self.starts[table]) as usize)
    }

    /// Those of several features, in the order of their numbers.
    fn merged(&self, mut features: Vec<u32>) -> Result<MergedProperties<'_>, Error> {
        features.sort_unstable();
        features.dedup();
        let mut merged = MergedProperties::default();
        for feature in features.into_iter().filter(|&feature| feature != NO_FEATURE) {
            merged.add(self.properties(feature))?;
        }
        Ok(merged)
    }
}

/// Our own properties, then those that have other keys, as the text of one object.
pub(super) fn with_own(own: &impl Serialize, mut others: MergedProperties<'_>) -> Result<String, Error> {
    let own = serde_json::to_value(own).map_err(std::io::Error::from)?;
    own.as_object().into_iter().flatten().for_each(|(key, _)| others.remove(key));
    let others = others.to_string();
    Ok(match own {
        Value::Object(own) if !own.is_empty() => {
            let own = Value::Object(own).to_string();
            let comma = if others == "{}" { "" } else { "," };
            format!("{}{comma}{}", &own[..own.len() - 1], &others[1..])
        }
        _ => others,
    })
}

/// What equal points have in common: zeros of both signs are equal.
fn key_of(point: [f64; 2]) -> [u64; 2] {
    point.map(|x| (x + 0.0).to_bits())
}

impl DrawingArrangement {
    /// The features with properties that contain a face, rising.
    ///
    /// # Panics
    /// If there is no such face and features have properties.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{ArrangementRequest, DrawingArrangement, PlanarDrawing, RegionSource};
    /// let text = br#"{"type": "Feature", "properties": {"use": "wood"}, "geometry":
    ///     {"type": "Polygon", "coordinates": [[[0, 0], [2, 0], [2, 1], [0, 0]]]}}"#;
    /// let wood = coface_io::read(&text[..], coface_io::Format::GeoJson)?;
    /// let drawing = PlanarDrawing::new([("wood", &wood)], RegionSource::Models)?;
    /// let arranged = DrawingArrangement::new(drawing, &ArrangementRequest::default())?;
    /// assert_eq!(arranged.features_around(coface_algebra::FaceId::new(0)), [0]);
    /// # Ok(()) }
    /// ```
    pub fn features_around(&self, face: FaceId) -> &[u32] {
        match self.containment.features.is_empty() {
            true => &[],
            false => self.containment.features.list(face.index()),
        }
    }

    /// The properties of all features that contain a face, the text of a JSON object: see [`MergedProperties`].
    ///
    /// # Errors
    /// [`ErrorKind::Parse`] if the properties of a feature are no JSON object, which no reader lets through.
    ///
    /// # Panics
    /// If there is no such face and features have properties.
    ///
    /// # Examples
    /// A field within a parish.
    /// ```
    /// use coface_io as io;
    /// use coface_io::Format;
    /// use coface_answers::{ArrangementRequest, DrawingArrangement, PlanarDrawing, RegionSource};
    /// use coface_algebra::FaceId;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let map = br#"{"type": "FeatureCollection", "features": [
    ///     {"type": "Feature", "properties": {"kind": "parish", "id": 4}, "geometry":
    ///         {"type": "Polygon", "coordinates": [[[0, 0], [9, 0], [9, 9], [0, 9], [0, 0]]]}},
    ///     {"type": "Feature", "properties": {"kind": "field", "crop": "rye"}, "geometry":
    ///         {"type": "Polygon", "coordinates": [[[1, 1], [2, 1], [2, 2], [1, 2], [1, 1]]]}}]}"#;
    /// let map = io::read(&map[..], Format::GeoJson)?;
    /// let drawing = PlanarDrawing::new([("map", &map)], RegionSource::Models)?;
    /// let arranged = DrawingArrangement::new(drawing, &ArrangementRequest::default())?;
    /// let properties = [0, 1].map(|face| arranged.properties_of_face(FaceId::new(face)).unwrap_or_default());
    /// assert_eq!(properties[0], r#"{"kind":"parish","id":4}"#);
    /// assert_eq!(properties[1], r#"{"kind":["parish","field"],"id":4,"crop":"rye"}"#);
    /// # Ok(()) }
    /// ```
    pub fn properties_of_face(&self, face: FaceId) -> Result<String, Error> {
        Ok(self.merged_of_face(face)?.to_string())
    }

    pub(super) fn merged_of_face(&self, face: FaceId) -> Result<MergedProperties<'_>, Error> {
        self.drawing.features.merged(self.features_around(face).to_vec())
    }

    /// The properties of the features that contain an edge with one face on both sides, or run along it.
    pub(super) fn properties_of_bridge(&self, edge: EdgeId) -> Result<String, Error> {
        let features = &self.drawing.features;
        if features.count() == 0 {
            return Ok("{}".to_owned());
        }
        let around = self
            .arrangement
            .face_of(HalfedgeId::from_u32(2 * edge.to_u32()))
            .map(|face| self.features_around(face));
        let along = self.segments_of_edge.list(edge.index());
        let along = along.iter().map(|&segment| features.of_segments[segment as usize]);
        let features = features.merged(around.unwrap_or_default().iter().copied().chain(along).collect())?;
        Ok(features.to_string())
    }

    /// The features that have points, by the coordinates of these.
    pub(super) fn features_of_points(&self) -> BTreeMap<[u64; 2], Vec<u32>> {
        let mut features: BTreeMap<_, Vec<u32>> = BTreeMap::new();
        for &(feature, vertex) in &self.drawing.features.points {
            features.entry(key_of(self.drawing.place(vertex))).or_default().push(feature);
        }
        features
    }

    /// The properties of the features that contain a vertex at which no edge ends, or have it as a point.
    pub(super) fn properties_of_lone(
        &self,
        vertex: VertexId,
        of_points: &BTreeMap<[u64; 2], Vec<u32>>,
    ) -> Result<String, Error> {
        let features = &self.drawing.features;
        if features.count() == 0 {
            return Ok("{}".to_owned());
        }
        let face = self.arrangement.face_around_component(self.arrangement.component(vertex));
        let around = face.map(|face| self.features_around(face)).unwrap_or_default();
        let place = self.arrangement.positions().point(vertex);
        let points = of_points.get(&key_of([place[0], place[1]])).map(Vec::as_slice).unwrap_or_default();
        Ok(features.merged([around, points].concat())?.to_string())
    }
}

impl RegionBoolean {
    /// The features with properties that contain some of a polygon, rising.
    ///
    /// # Panics
    /// If there is no such polygon.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_algebra::FaceId;
    /// use coface_arrange::boolean::BooleanFormula;
    /// use coface_answers::{BooleanRequest, PlanarDrawing, RegionBoolean, RegionSource};
    /// let text = br#"{"type": "Feature", "properties": {"use": "wood"}, "geometry":
    ///     {"type": "Polygon", "coordinates": [[[0, 0], [2, 0], [2, 1], [0, 0]]]}}"#;
    /// let wood = coface_io::read(&text[..], coface_io::Format::GeoJson)?;
    /// let drawing = PlanarDrawing::new([("wood", &wood)], RegionSource::Models)?;
    /// let same = RegionBoolean::new(drawing, &BooleanFormula::parse("a", &[])?, &BooleanRequest::default())?;
    /// assert_eq!(same.features_of_polygon(FaceId::new(0)), [0]);
    /// # Ok(()) }
    /// ```
    pub fn features_of_polygon(&self, polygon: FaceId) -> &[u32] {
        self.found.features_of_polygon.list(polygon.index())
    }

    /// The properties of all features that contain some of a polygon, the text of a JSON object: see
    /// [`MergedProperties`].
    ///
    /// # Errors
    /// [`ErrorKind::Parse`] if the properties of a feature are no JSON object, which no reader lets through.
    ///
    /// # Panics
    /// If there is no such polygon.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::FaceId;
    /// use coface_arrange::boolean::BooleanFormula;
    /// use coface_io as io;
    /// use coface_io::Format;
    /// use coface_answers::{BooleanRequest, PlanarDrawing, RegionBoolean, RegionSource};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let wood = br#"{"type": "Feature", "properties": {"use": "wood", "age": 80}, "geometry":
    ///     {"type": "Polygon", "coordinates": [[[0, 0], [2, 0], [2, 1], [0, 1], [0, 0]]]}}"#;
    /// let road = br#"{"type": "Feature", "properties": {"use": "road"}, "geometry":
    ///     {"type": "Polygon", "coordinates": [[[1, -1], [1.5, -1], [1.5, 3], [1, 3], [1, -1]]]}}"#;
    /// let models = [io::read(&wood[..], Format::GeoJson)?, io::read(&road[..], Format::GeoJson)?];
    /// let drawing = PlanarDrawing::new([("wood", &models[0]), ("road", &models[1])], RegionSource::Models)?;
    /// let result = RegionBoolean::new(drawing, &BooleanFormula::difference(2), &BooleanRequest::default())?;
    /// assert_eq!(result.properties_of_polygon(FaceId::new(1))?, r#"{"use":"wood","age":80}"#);
    /// # Ok(()) }
    /// ```
    pub fn properties_of_polygon(&self, polygon: FaceId) -> Result<String, Error> {
        Ok(self.merged_of_polygon(polygon)?.to_string())
    }

    pub(super) fn merged_of_polygon(&self, polygon: FaceId) -> Result<MergedProperties<'_>, Error> {
        self.drawing.features.merged(self.features_of_polygon(polygon).to_vec())
    }
}
