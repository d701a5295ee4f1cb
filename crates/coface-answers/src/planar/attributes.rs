//! The faces of an arrangement with the properties of all inputs that contain them, as a table that GIS reads.

use super::arrangement::DrawingArrangement;
use super::drawing::NO_FEATURE;
use super::feature_model::FeatureModel;
use super::heights::Heights;
use super::outline::Outline;
use crate::answer::{AttributeColumn, Remark, RemarkCode};
use crate::text;
use coface_algebra::{EdgeId, Error, FaceId, VertexId};
use coface_io::Model;
use coface_io::geojson::{MergedProperties, property_pairs};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};

/// The faces that inputs contain, each a feature with the properties of all that contain it.
///
/// All features have the same keys, which are the [columns](Self::columns). A key that features of one input have keeps its name. A key that features of several
/// inputs have is a column for each of these inputs, named `key_1` for the first input, `key_2` for the second; where that is a key already, with one more
/// `_` behind it. Where no feature of the input contains the face, the value is null; where several do and differ, it is the list of their values.
///
/// # Examples
/// A wood and a road across it: three faces are wood, road, and both.
/// ```
/// use coface_answers::{ArrangementRequest, DrawingArrangement, PlanarDrawing, RegionSource};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let wood = br#"{"type": "Feature", "properties": {"use": "wood", "age": 80}, "geometry":
///     {"type": "Polygon", "coordinates": [[[0, 0], [2, 0], [2, 1], [0, 1], [0, 0]]]}}"#;
/// let road = br#"{"type": "Feature", "properties": {"use": "road"}, "geometry":
///     {"type": "Polygon", "coordinates": [[[1, 0], [3, 0], [3, 1], [1, 1], [1, 0]]]}}"#;
/// let models = [&wood[..], &road[..]].map(|text| coface_io::read(text, coface_io::Format::GeoJson));
/// let [wood, road] = models;
/// let (wood, road) = (wood?, road?);
/// let drawing = PlanarDrawing::new([("wood", &wood), ("road", &road)], RegionSource::Models)?;
/// let arranged = DrawingArrangement::new(drawing, &ArrangementRequest::default())?;
/// let found = arranged.attributes()?;
/// let features = found.model().features();
/// assert_eq!(features.len(), 3);
/// assert_eq!(features.properties(1), r#"{"use_1":"wood","age":80,"use_2":"road"}"#);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct FaceAttributes {
    model: Model,
    columns: Vec<AttributeColumn>,
    faces: Vec<FaceId>,
    remarks: Vec<Remark>,
}

impl FaceAttributes {
    /// The faces as a map with properties.
    ///
    /// # Examples
    /// See [`FaceAttributes`].
    pub fn model(&self) -> &Model {
        &self.model
    }

    /// The columns: each a key of an input.
    ///
    /// # Examples
    /// See [`DrawingArrangement::attributes`].
    pub fn columns(&self) -> &[AttributeColumn] {
        &self.columns
    }

    /// The face of the arrangement that each feature is.
    ///
    /// # Examples
    /// See [`DrawingArrangement::attributes`].
    pub fn faces(&self) -> &[FaceId] {
        &self.faces
    }

    /// What is left out: faces that no input contains.
    ///
    /// # Examples
    /// See [`DrawingArrangement::attributes`].
    pub fn remarks(&self) -> &[Remark] {
        &self.remarks
    }
}

impl DrawingArrangement {
    /// The faces that inputs contain, each with the properties of all features that contain it.
    ///
    /// # Errors
    /// [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) if the properties of a feature are no JSON object, which no reader lets through.
    ///
    /// # Complexity
    /// The faces times the columns, and linear in the features around all faces.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{ArrangementRequest, DrawingArrangement, PlanarDrawing, RegionSource};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let wood = br#"{"type": "Feature", "properties": {"use": "wood"}, "geometry":
    ///     {"type": "Polygon", "coordinates": [[[0, 0], [2, 0], [2, 1], [0, 1], [0, 0]]]}}"#;
    /// let wood = coface_io::read(&wood[..], coface_io::Format::GeoJson)?;
    /// let drawing = PlanarDrawing::new([("wood", &wood)], RegionSource::Models)?;
    /// let found = DrawingArrangement::new(drawing, &ArrangementRequest::default())?.attributes()?;
    /// assert_eq!((found.columns()[0].name.as_str(), found.columns()[0].input), ("use", 0));
    /// assert_eq!((found.faces().len(), found.remarks().len()), (1, 0));
    /// # Ok(()) }
    /// ```
    pub fn attributes(&self) -> Result<FaceAttributes, Error> {
        let count = self.arrangement.face_count();
        let faces: Vec<FaceId> =
            (0..count).map(FaceId::new).filter(|&face| !self.regions_around(face).is_empty()).collect();
        let columns = self.columns(&faces)?;
        let mut names: BTreeMap<(usize, &str), usize> = BTreeMap::new();
        for (place, column) in columns.iter().enumerate() {
            names.insert((column.input, &column.key), place);
        }
        let model_of_feature = self.models_of_features();
        let mut map = FeatureModel::new(Heights::new(&self.drawing).is_some());
        let positions = self.arrangement.positions().clone();
        map.set_vertices(match Heights::new(&self.drawing) {
            Some(heights) => {
                let edges = (0..self.arrangement.edge_count())
                    .map(|edge| self.arrangement.ends(EdgeId::new(edge)).map(VertexId::to_u32));
                heights.lift(&positions, &self.sources, edges, &self.segments_of_edge)?
            }
            None => positions,
        });
        let [rings, polygons] = self.arrangement.face_polygons();
        let outline = Outline { rings, polygons };
        for &face in &faces {
            let mut values = vec!["null".to_owned(); columns.len()];
            let features = self.features_around(face);
            for around in features.chunk_by(|a, b| model_of_feature.get(a) == model_of_feature.get(b)) {
                let Some(&model) = model_of_feature.get(&around[0]) else { continue };
                let mut merged = MergedProperties::default();
                for &feature in around {
                    merged.add(self.drawing.features.properties(feature))?;
                }
                let merged = merged.to_string();
                for (key, value) in property_pairs(&merged)? {
                    if let Some(&place) = names.get(&(model, key.as_str())) {
                        values[place] = value.to_owned();
                    }
                }
            }
            let pairs = columns.iter().zip(&values);
            let pairs: Vec<String> = pairs
                .map(|(column, value)| format!("{}:{value}", Value::from(column.name.as_str())))
                .collect();
            map.begin_feature(format!("{{{}}}", pairs.join(",")));
            map.add_polygon(outline.rings_of(face.index()));
        }
        let mut remarks = Vec::new();
        let outside = count - faces.len();
        if outside > 0 {
            let is = if outside == 1 { "is" } else { "are" };
            let message = format!(
                "{} {is} inside no input and {is} left out of the table",
                text::count(outside, "face")
            );
            remarks.push(Remark::new(RemarkCode::CellsLeftOut, message).at(outside, []));
        }
        Ok(FaceAttributes { model: map.finish(self.drawing.reference.clone())?, columns, faces, remarks })
    }

    /// The model of each feature that has polygons.
    fn models_of_features(&self) -> BTreeMap<u32, usize> {
        let polygons = self.drawing.polygons.iter().filter(|polygon| polygon.feature != NO_FEATURE);
        let regions = &self.drawing.regions;
        polygons.map(|polygon| (polygon.feature, regions[polygon.region as usize].model as usize)).collect()
    }

    /// The keys of all features that contain faces, by inputs.
    fn columns(&self, faces: &[FaceId]) -> Result<Vec<AttributeColumn>, Error> {
        let model_of_feature = self.models_of_features();
        let features: BTreeSet<u32> =
            faces.iter().flat_map(|&face| self.features_around(face)).copied().collect();
        let (mut columns, mut known) = (Vec::new(), BTreeSet::new());
        let mut models_of_key: BTreeMap<String, BTreeSet<usize>> = BTreeMap::new();
        for feature in features {
            let Some(&input) = model_of_feature.get(&feature) else { continue };
            for (key, _) in property_pairs(self.drawing.features.properties(feature))? {
                if known.insert((input, key.clone())) {
                    models_of_key.entry(key.clone()).or_default().insert(input);
                    columns.push(AttributeColumn::new(input, key));
                }
            }
        }
        let is_shared = |key: &str| models_of_key.get(key).is_some_and(|models| models.len() > 1);
        let mut taken: BTreeSet<String> = columns
            .iter()
            .filter(|column| !is_shared(&column.key))
            .map(|column| column.key.clone())
            .collect();
        for column in columns.iter_mut().filter(|column| is_shared(&column.key)) {
            column.name = format!("{}_{}", column.key, column.input + 1);
            while !taken.insert(column.name.clone()) {
                column.name.push('_');
            }
        }
        Ok(columns)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{ArrangementRequest, PlanarDrawing, RegionSource};
    use coface_io::Format;
    use proptest::prelude::*;

    fn square([x, y, w]: [i32; 3], properties: &str) -> String {
        let (right, top) = (x + w, y + w);
        format!(
            "{{\"type\":\"Feature\",\"properties\":{properties},\"geometry\":{{\"type\":\"Polygon\",\"coordinates\":\
             [[[{x},{y}],[{right},{y}],[{right},{top}],[{x},{top}],[{x},{y}]]]}}}}"
        )
    }

    fn map(features: &[String]) -> Model {
        let text = format!("{{\"type\":\"FeatureCollection\",\"features\":[{}]}}", features.join(","));
        coface_io::read(text.as_bytes(), Format::GeoJson).unwrap()
    }

    fn arranged(models: &[Model]) -> DrawingArrangement {
        let models = models.iter().map(|model| ("map", model));
        let drawing = PlanarDrawing::new(models, RegionSource::Models).unwrap();
        DrawingArrangement::new(drawing, &ArrangementRequest::default()).unwrap()
    }

    fn properties(found: &FaceAttributes) -> Vec<&str> {
        let features = found.model().features();
        (0..features.len()).map(|feature| features.properties(feature)).collect()
    }

    #[test]
    fn keys_of_several_inputs_are_columns_of_their_own() {
        let a =
            map(&[square([0, 0, 2], r#"{"use":"wood","use_2":5}"#), square([0, 0, 1], r#"{"use":"oak"}"#)]);
        let b = map(&[square([0, 0, 1], r#"{"use":"road","lanes":2}"#)]);
        let found = arranged(&[a, b]).attributes().unwrap();
        let names: Vec<&str> = found.columns().iter().map(|column| column.name.as_str()).collect();
        assert_eq!(names, ["use_1", "use_2", "use_2_", "lanes"]);
        let mut rows = properties(&found);
        rows.sort_unstable();
        let expected = [
            r#"{"use_1":"wood","use_2":5,"use_2_":null,"lanes":null}"#,
            r#"{"use_1":["wood","oak"],"use_2":5,"use_2_":"road","lanes":2}"#,
        ];
        assert_eq!(rows, expected);
    }

    #[test]
    fn faces_outside_of_all_inputs_are_left_out() {
        // Four bars around a square that nothing covers.
        let frame = r#"{"type":"Feature","properties":{"a":1},"geometry":{"type":"Polygon","coordinates":
            [[[0,0],[3,0],[3,3],[0,3],[0,0]],[[1,1],[1,2],[2,2],[2,1],[1,1]]]}}"#;
        let found = arranged(&[map(&[frame.to_owned()])]).attributes().unwrap();
        assert_eq!((found.faces().len(), found.remarks()[0].count), (1, 1));
        // A map without properties has faces and no columns.
        let bare = coface_io::read(&b"POLYGON ((0 0, 1 0, 1 1, 0 0))"[..], Format::Wkt).unwrap();
        let found = arranged(&[bare]).attributes().unwrap();
        assert_eq!((found.faces().len(), found.columns().len(), found.model().lines().len()), (1, 0, 1));
    }

    proptest! {
        #[test]
        fn faces_have_what_contains_them(
            squares in prop::collection::vec(((0..7i32, 0..7i32, 1..5i32), 0..3usize), 1..9),
        ) {
            let models: Vec<Model> = (0..3)
                .map(|input| {
                    let own = squares.iter().enumerate().filter(|(_, (_, other))| *other == input);
                    let features: Vec<String> = own
                        .map(|(id, &((x, y, w), _))| square([x, y, w], &format!("{{\"id\":{id},\"k{input}\":1}}")))
                        .collect();
                    map(&features)
                })
                .collect();
            let arranged = arranged(&models);
            let found = arranged.attributes().unwrap();
            let areas = arranged.arrangement().areas();
            // Unit squares by the ids that cover them, against the areas of faces by the ids that they have.
            let mut expected: BTreeMap<Vec<u64>, f64> = BTreeMap::new();
            for (x, y) in (0..12).flat_map(|x| (0..12).map(move |y| (x, y))) {
                let covers = |&((left, low, w), _): &((i32, i32, i32), usize)| {
                    (left..left + w).contains(&x) && (low..low + w).contains(&y)
                };
                let ids: Vec<u64> = (0..).zip(&squares).filter(|(_, own)| covers(own)).map(|(id, _)| id).collect();
                if !ids.is_empty() {
                    *expected.entry(ids).or_default() += 1.0;
                }
            }
            let mut by_ids: BTreeMap<Vec<u64>, f64> = BTreeMap::new();
            for (row, face) in properties(&found).into_iter().zip(found.faces()) {
                let row: Value = serde_json::from_str(row).unwrap();
                let mut ids: Vec<u64> = Vec::new();
                for column in found.columns().iter().filter(|column| column.key == "id") {
                    match &row[&column.name] {
                        Value::Array(list) => ids.extend(list.iter().filter_map(Value::as_u64)),
                        value => ids.extend(value.as_u64()),
                    }
                }
                ids.sort_unstable();
                *by_ids.entry(ids).or_default() += areas[face.index()];
            }
            prop_assert_eq!(by_ids, expected);
            // Read back, the table is the same.
            let mut text = Vec::new();
            coface_io::write(found.model(), &mut text, Format::GeoJson).unwrap();
            let back = coface_io::read(&text[..], Format::GeoJson).unwrap();
            let again = self::arranged(&[back]).attributes().unwrap();
            prop_assert_eq!(properties(&again), properties(&found));
            let mut twice = Vec::new();
            coface_io::write(again.model(), &mut twice, Format::GeoJson).unwrap();
            prop_assert_eq!(String::from_utf8(text).unwrap(), String::from_utf8(twice).unwrap());
        }
    }
}
