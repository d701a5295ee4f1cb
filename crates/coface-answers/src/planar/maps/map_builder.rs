//! A map made feature by feature.

use super::layer::{Geometry, Point};
use coface_algebra::{Error, RaggedArray, VertexId};
use coface_geometry::Positions;
use coface_io::{CellData, Format, GroupKind, Model, ReferenceSystem};

/// A map while it is made.
#[derive(Default)]
pub(super) struct MapBuilder {
    has_heights: bool,
    flat: Vec<f64>,
    lines: RaggedArray,
    polygons: Vec<i64>,
    rings: Vec<i64>,
    features: Vec<u32>,
    points: Vec<VertexId>,
    of_points: Vec<u32>,
    texts: Vec<(String, String)>,
    polygon_count: i64,
}

impl MapBuilder {
    /// An empty map; points without heights are at height 0 if it has heights.
    pub(super) fn new(has_heights: bool) -> Self {
        Self { has_heights, ..Self::default() }
    }

    /// Adds a feature.
    pub(super) fn add(&mut self, geometry: &Geometry, properties: &str, id: &str) {
        let feature = self.texts.len() as u32;
        self.texts.push((properties.to_owned(), id.to_owned()));
        for rings in &geometry.polygons {
            for (number, ring) in (0..).zip(rings) {
                let first = self.vertex_count();
                let mut line: Vec<u32> = ring.iter().map(|corner| self.vertex(corner)).collect();
                line.push(first);
                self.push_line(&line, self.polygon_count, number, feature);
            }
            self.polygon_count += 1;
        }
        for line in &geometry.lines {
            let first = self.vertex_count();
            let is_closed = line.len() > 3 && line.first().map(bits) == line.last().map(bits);
            let own = if is_closed { &line[..line.len() - 1] } else { &line[..] };
            let mut numbers: Vec<u32> = own.iter().map(|corner| self.vertex(corner)).collect();
            if is_closed {
                numbers.push(first);
            }
            self.push_line(&numbers, -1, -1, feature);
        }
        for point in &geometry.points {
            let vertex = self.vertex(point);
            self.points.push(VertexId::from_u32(vertex));
            self.of_points.push(feature);
        }
    }

    fn push_line(&mut self, line: &[u32], polygon: i64, ring: i64, feature: u32) {
        self.lines.push(line);
        self.polygons.push(polygon);
        self.rings.push(ring);
        self.features.push(feature);
    }

    fn vertex_count(&self) -> u32 {
        (self.flat.len() / if self.has_heights { 3 } else { 2 }) as u32
    }

    fn vertex(&mut self, point: &Point) -> u32 {
        let number = self.vertex_count();
        self.flat.extend_from_slice(&point[..2]);
        if self.has_heights {
            self.flat.push(if point[2].is_nan() { 0.0 } else { point[2] });
        }
        number
    }

    /// The map, in a reference system.
    ///
    /// # Errors
    /// Those of [`Model::from_lines`].
    pub(super) fn finish(self, system: Option<ReferenceSystem>) -> Result<Model, Error> {
        let dimension = if self.has_heights { 3 } else { 2 };
        let numbers = self.features.iter().map(|&feature| i64::from(feature)).collect();
        let mut model = Model::from_lines(Positions::from_flat(dimension, self.flat)?, self.lines)?;
        if !self.features.is_empty() {
            model = model
                .with_data(CellData::integers("polygon", GroupKind::Lines, 1, self.polygons)?)?
                .with_data(CellData::integers("ring", GroupKind::Lines, 1, self.rings)?)?
                .with_data(CellData::integers("feature", GroupKind::Lines, 1, numbers)?)?;
        }
        let model = model
            .with_map_features(self.texts, self.features, self.points, self.of_points)?
            .with_reference_system(system);
        // Heights that are all zero are heights of a map.
        Ok(if self.has_heights { model.with_format(Format::GeoJson) } else { model })
    }
}

fn bits(point: &Point) -> [u64; 2] {
    [point[0] + 0.0, point[1] + 0.0].map(f64::to_bits)
}
