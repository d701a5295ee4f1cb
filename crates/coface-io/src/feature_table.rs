//! The features of a map: what a file says of them beside their shapes.

use crate::keeping::KeptFeatures;
use crate::{Model, Remark};
use coface_algebra::{Error, VertexId};
use std::sync::Arc;

/// The number of the feature of what is of none.
pub(crate) const NO_FEATURE: u32 = u32::MAX;

/// The features of a map, each with its properties and its id as the file has them, and which lines and points are of
/// which feature.
///
/// GeoJSON, TopoJSON and CityJSON have features, and geometries of WKT and WKB are such. The table is empty for other formats, and where no feature has
/// properties or an id, several lines or points, or shapes of several kinds. Properties are kept as text, without the white space between their parts: numbers have all their digits and
/// keys their order.
///
/// # Examples
/// ```
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let text = r#"{"type": "Feature", "id": 7, "properties": {"lanes": 2, "surface": null},
///     "geometry": {"type": "LineString", "coordinates": [[0, 0], [1, 0], [1, 2]]}}"#;
/// let model = coface_io::geojson::read(text.as_bytes())?;
/// let features = model.features();
/// let road = features.of_line(0).expect("the line is of a feature");
/// assert_eq!(features.properties(road), r#"{"lanes":2,"surface":null}"#);
/// assert_eq!((features.len(), features.id(road)), (1, Some("7")));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FeatureTable(Arc<Table>);

#[derive(Debug, Default, PartialEq, Eq)]
struct Table {
    texts: FeatureTexts,
    of_lines: Vec<u32>,
    of_points: Vec<u32>,
    of_polygons: Vec<u32>,
}

/// The properties and ids of features, one text after the other.
#[derive(Debug, Default, PartialEq, Eq)]
pub(crate) struct FeatureTexts {
    text: String,
    /// For each feature where its properties end and where its id ends; both texts may be empty.
    ends: Vec<[usize; 2]>,
}

impl FeatureTexts {
    /// Adds a feature; its number is the number of those before.
    pub(crate) fn push(&mut self, properties: &str, id: &str) {
        self.text.push_str(properties);
        let end = self.text.len();
        self.text.push_str(id);
        self.ends.push([end, self.text.len()]);
    }

    pub(crate) fn len(&self) -> usize {
        self.ends.len()
    }

    /// The properties and the id of a feature; both may be empty.
    fn of(&self, feature: usize) -> [&str; 2] {
        let start = feature.checked_sub(1).map_or(0, |before| self.ends[before][1]);
        let [middle, end] = self.ends[feature];
        [&self.text[start..middle], &self.text[middle..end]]
    }
}

impl FeatureTable {
    /// The table of these features and the feature of each line and of each point; empty if they say nothing.
    pub(crate) fn new(texts: FeatureTexts, of_lines: Vec<u32>, of_points: Vec<u32>) -> Self {
        if texts.text.is_empty() {
            return Self::default();
        }
        Self(Arc::new(Table { texts, of_lines, of_points, of_polygons: Vec::new() }))
    }

    /// The same, kept where the features say nothing too: some have several shapes.
    pub(crate) fn of_shapes(texts: FeatureTexts, of_lines: Vec<u32>, of_points: Vec<u32>) -> Self {
        Self(Arc::new(Table { texts, of_lines, of_points, of_polygons: Vec::new() }))
    }

    /// The table of these features and the feature of each polygon; empty if they say nothing.
    pub(crate) fn of_city(texts: FeatureTexts, of_polygons: Vec<u32>) -> Self {
        if texts.text.is_empty() {
            return Self::default();
        }
        Self(Arc::new(Table { texts, of_lines: Vec::new(), of_points: Vec::new(), of_polygons }))
    }

    /// All of it, for [`Model::kept`].
    pub(crate) fn kept(&self) -> KeptFeatures {
        let Table { texts, of_lines, of_points, of_polygons } = &*self.0;
        KeptFeatures {
            texts: (0..texts.len()).map(|feature| texts.of(feature).map(str::to_owned).into()).collect(),
            of_lines: of_lines.clone(),
            of_points: of_points.clone(),
            of_polygons: of_polygons.clone(),
        }
    }

    /// The table of what [`Self::kept`] gave.
    pub(crate) fn of_kept(kept: KeptFeatures) -> Self {
        let mut texts = FeatureTexts::default();
        kept.texts.iter().for_each(|(properties, id)| texts.push(properties, id));
        let KeptFeatures { of_lines, of_points, of_polygons, .. } = kept;
        Self(Arc::new(Table { texts, of_lines, of_points, of_polygons }))
    }

    /// The number of features, those without shapes included.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_io::Model::default().features().len(), 0);
    /// ```
    pub fn len(&self) -> usize {
        self.0.texts.len()
    }

    /// Whether there is no feature, or none that has properties or an id.
    ///
    /// # Examples
    /// ```
    /// let bare = r#"{"type": "Feature", "properties": {}, "geometry": {"type": "Point", "coordinates": [1, 2]}}"#;
    /// assert!(coface_io::geojson::read(bare.as_bytes())?.features().is_empty());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The properties of a feature, the text of a JSON object: `{}` if it has none.
    ///
    /// # Panics
    /// If there is no such feature.
    ///
    /// # Examples
    /// ```
    /// let text = r#"{"type": "Feature", "properties": {"kind" : "well"}, "geometry": null}"#;
    /// let model = coface_io::geojson::read(text.as_bytes())?;
    /// assert_eq!(model.features().properties(0), r#"{"kind":"well"}"#);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn properties(&self, feature: usize) -> &str {
        match self.0.texts.of(feature)[0] {
            "" => "{}",
            properties => properties,
        }
    }

    /// The id of a feature, a number or a text in quotation marks as JSON has it, if it has one.
    ///
    /// # Panics
    /// If there is no such feature.
    ///
    /// # Examples
    /// ```
    /// let text = r#"{"type": "Feature", "id": "n17", "properties": null, "geometry": null}"#;
    /// let model = coface_io::geojson::read(text.as_bytes())?;
    /// assert_eq!(model.features().id(0), Some("\"n17\""));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn id(&self, feature: usize) -> Option<&str> {
        Some(self.0.texts.of(feature)[1]).filter(|id| !id.is_empty())
    }

    /// The feature of a line of the model; `None` if it is of none, or if there is no such line.
    ///
    /// # Examples
    /// A geometry that is no feature stands beside one.
    /// ```
    /// let text = r#"{"type": "FeatureCollection", "features": [
    ///     {"type": "LineString", "coordinates": [[0, 0], [1, 1]]},
    ///     {"type": "Feature", "id": 3, "geometry": {"type": "LineString", "coordinates": [[5, 5], [6, 7]]}}]}"#;
    /// let model = coface_io::geojson::read(text.as_bytes())?;
    /// assert_eq!([0, 1].map(|line| model.features().of_line(line)), [None, Some(0)]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn of_line(&self, line: usize) -> Option<usize> {
        feature_at(&self.0.of_lines, line)
    }

    /// The feature of a point of [`Model::points`](crate::Model::points), by its place there; `None` if it is of
    /// none, or if there is no such point.
    ///
    /// # Examples
    /// ```
    /// let text = r#"{"type": "Feature", "id": 3, "geometry": {"type": "Point", "coordinates": [0, 1]}}"#;
    /// let model = coface_io::geojson::read(text.as_bytes())?;
    /// assert_eq!([0, 1].map(|point| model.features().of_point(point)), [Some(0), None]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn of_point(&self, point: usize) -> Option<usize> {
        feature_at(&self.0.of_points, point)
    }

    /// The feature of a polygon of the model, such as the object of a city; `None` if it is of none, or if there is no
    /// such polygon.
    ///
    /// # Examples
    /// ```
    /// let text = r#"{"type": "Feature", "id": 3, "geometry": {"type": "Point", "coordinates": [0, 1]}}"#;
    /// assert_eq!(coface_io::geojson::read(text.as_bytes())?.features().of_polygon(0), None);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn of_polygon(&self, polygon: usize) -> Option<usize> {
        feature_at(&self.0.of_polygons, polygon)
    }

    /// Whether the table says of each of so many lines, points and polygons what feature it is of, and names only
    /// features that
    /// are there. A table says it of lines and points, or of polygons.
    pub(crate) fn fits(&self, line_count: usize, point_count: usize, polygon_count: usize) -> bool {
        let is_known = |&feature: &u32| feature == NO_FEATURE || (feature as usize) < self.len();
        let Table { of_lines, of_points, of_polygons, .. } = &*self.0;
        let fits = if of_polygons.is_empty() {
            [of_lines.len(), of_points.len()] == [line_count, point_count]
        } else {
            of_polygons.len() == polygon_count
        };
        self.is_empty() || fits && of_lines.iter().chain(of_points).chain(of_polygons).all(is_known)
    }
}

impl Model {
    /// The model with these remarks behind its own.
    #[doc(hidden)]
    pub fn with_remarks(mut self, remarks: impl IntoIterator<Item = Remark>) -> Self {
        self.remarks.extend(remarks);
        self
    }

    /// The model with the features of another one, which it was made of: its lines and points are the same, and polygon i comes from polygon
    /// `polygon_sources[i]`.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if there are other lines, points or polygons.
    #[doc(hidden)]
    pub fn with_features_of(mut self, other: &Self, polygon_sources: &[usize]) -> Result<Self, Error> {
        self.features = other.features.clone();
        if !other.features.0.of_polygons.is_empty() {
            let mut kept = other.features.kept();
            let of = |&source: &usize| kept.of_polygons.get(source).copied().unwrap_or(NO_FEATURE);
            kept.of_polygons = polygon_sources.iter().map(of).collect();
            self.features = FeatureTable::of_kept(kept);
        }
        self.check()?;
        Ok(self)
    }

    /// The model with features that have these properties, texts of JSON objects, by the feature of each line. Its points are of none.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if there are other lines, or such features are not there.
    #[doc(hidden)]
    pub fn with_feature_properties(
        mut self,
        properties: impl IntoIterator<Item = String>,
        of_lines: Vec<u32>,
    ) -> Result<Self, Error> {
        let mut texts = FeatureTexts::default();
        for properties in properties {
            texts.push(if properties == "{}" { "" } else { &properties }, "");
        }
        self.features = FeatureTable::new(texts, of_lines, vec![NO_FEATURE; self.points.len()]);
        self.check()?;
        Ok(self)
    }
}

impl Model {
    /// The model with features that have these properties (texts of JSON objects) and ids (numbers or texts in quotation marks, or
    /// nothing), by the features of its lines and of its points, which are these vertices.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if there are other lines, or such features or vertices are not there.
    #[doc(hidden)]
    pub fn with_map_features(
        mut self,
        texts: impl IntoIterator<Item = (String, String)>,
        of_lines: Vec<u32>,
        points: Vec<VertexId>,
        of_points: Vec<u32>,
    ) -> Result<Self, Error> {
        let mut all = FeatureTexts::default();
        for (properties, id) in texts {
            all.push(if properties == "{}" { "" } else { &properties }, &id);
        }
        self.points = points;
        self.features = FeatureTable::new(all, of_lines, of_points);
        self.check()?;
        Ok(self)
    }
}

fn feature_at(features: &[u32], at: usize) -> Option<usize> {
    features.get(at).filter(|&&feature| feature != NO_FEATURE).map(|&feature| feature as usize)
}
