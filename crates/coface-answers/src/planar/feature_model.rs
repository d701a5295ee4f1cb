//! Polygons of several features with properties, put together as a map.

use coface_algebra::{Error, RaggedArray, VertexId};
use coface_geometry::Positions;
use coface_io::{CellData, Format, GroupKind, Model, ReferenceSystem};

/// A map that is made polygon by polygon, feature by feature. Vertices that no polygon has are left out.
#[derive(Default)]
pub(super) struct FeatureModel {
    has_heights: bool,
    flat: Vec<f64>,
    /// The vertices of the polygons that come next, and their numbers in the map.
    given: Positions,
    numbers: Vec<u32>,
    lines: RaggedArray,
    polygons: Vec<i64>,
    rings: Vec<i64>,
    features: Vec<u32>,
    properties: Vec<String>,
    polygon_count: i64,
}

impl FeatureModel {
    const NO_NUMBER: u32 = u32::MAX;

    /// A map without polygons; vertices without heights are at height 0 if it has heights.
    pub(super) fn new(has_heights: bool) -> Self {
        Self { has_heights, ..Self::default() }
    }

    /// The polygons that come next have these vertices.
    pub(super) fn set_vertices(&mut self, positions: Positions) {
        self.numbers = vec![Self::NO_NUMBER; positions.len()];
        self.given = positions;
    }

    /// The polygons that come next are of a new feature with these properties, the text of a JSON object.
    pub(super) fn begin_feature(&mut self, properties: String) {
        self.properties.push(properties);
    }

    /// Adds a polygon by its rings, the outer one first.
    pub(super) fn add_polygon<'a>(&mut self, rings: impl Iterator<Item = &'a [u32]>) {
        let mut line = Vec::new();
        for (ring, corners) in rings.enumerate() {
            line.clear();
            for &corner in corners.iter().chain(corners.first()) {
                line.push(self.number_of(corner));
            }
            self.lines.push(&line);
            self.polygons.push(self.polygon_count);
            self.rings.push(ring as i64);
            self.features.push(self.properties.len().saturating_sub(1) as u32);
        }
        self.polygon_count += 1;
    }

    fn number_of(&mut self, vertex: u32) -> u32 {
        let number = &mut self.numbers[vertex as usize];
        if *number == Self::NO_NUMBER {
            let dimension = if self.has_heights { 3 } else { 2 };
            *number = (self.flat.len() / dimension) as u32;
            let point = self.given.point(VertexId::from_u32(vertex));
            self.flat.extend_from_slice(&point[..2]);
            if self.has_heights {
                self.flat.push(point.get(2).copied().unwrap_or(0.0));
            }
        }
        *number
    }

    /// The map, in a reference system.
    ///
    /// # Errors
    /// Those of [`Model::from_lines`].
    pub(super) fn finish(self, system: Option<ReferenceSystem>) -> Result<Model, Error> {
        let dimension = if self.has_heights { 3 } else { 2 };
        let numbers = self.features.iter().map(|&feature| i64::from(feature)).collect();
        let model = Model::from_lines(Positions::from_flat(dimension, self.flat)?, self.lines)?
            .with_data(CellData::integers("polygon", GroupKind::Lines, 1, self.polygons)?)?
            .with_data(CellData::integers("ring", GroupKind::Lines, 1, self.rings)?)?
            .with_data(CellData::integers("feature", GroupKind::Lines, 1, numbers)?)?
            .with_feature_properties(self.properties, self.features)?
            .with_reference_system(system);
        // Heights that are all zero are heights of a map.
        Ok(if self.has_heights { model.with_format(Format::GeoJson) } else { model })
    }
}
