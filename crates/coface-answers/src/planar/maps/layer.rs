//! The features of maps, each with its polygons, lines and points.

use super::super::chain_faces::ChainFaces;
use super::super::drawing::{Filling, NO_FEATURE, PlanarDrawing, Polygon, Region, Ring};
use super::super::drawing_options::DrawingOptions;
use super::super::fill_rules::FillRules;
use super::filled_polygons::polygons_by_rule;
use crate::answer::{DrawingInput, Remark};
use coface_algebra::chains::ChainComplex;
use coface_algebra::{Error, VertexId};
use coface_geometry::Positions;
use coface_io::{Features, Model, ReferenceSystem, Shape, Structure, features_of_shapes, shapes};
use std::collections::BTreeMap;

/// A place with its height, which is NaN if it has none.
pub(super) type Point = [f64; 3];
/// The corners of a closed walk, the first not repeated.
pub(super) type Corners = Vec<Point>;
/// A polygon by its rings, the outer one first.
pub(super) type Rings = Vec<Corners>;

/// What a feature draws.
#[derive(Clone, Debug, Default)]
pub(super) struct Geometry {
    pub(super) polygons: Vec<Rings>,
    /// A closed line ends where it begins.
    pub(super) lines: Vec<Vec<Point>>,
    pub(super) points: Vec<Point>,
}

impl Geometry {
    /// All corners.
    pub(super) fn corners(&self) -> impl Iterator<Item = &Point> {
        let rings = self.polygons.iter().flatten();
        rings.chain(&self.lines).flatten().chain(&self.points)
    }

    /// The box around it; of nothing, one without points.
    pub(super) fn frame(&self) -> [[f64; 2]; 2] {
        let mut frame = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
        for &[x, y, _] in self.corners() {
            let [low, high] = &mut frame;
            *low = [low[0].min(x), low[1].min(y)];
            *high = [high[0].max(x), high[1].max(y)];
        }
        frame
    }
}

/// A feature of a map.
#[derive(Clone, Debug)]
pub(super) struct MapFeature {
    pub(super) geometry: Geometry,
    /// The text of a JSON object.
    pub(super) properties: String,
    /// A number or a text in quotation marks; empty if there is none.
    pub(super) id: String,
}

/// The features of all maps that are given, in their order.
#[derive(Clone, Debug)]
pub(super) struct MapLayer {
    pub(super) features: Vec<MapFeature>,
    /// How many polygons of drawings have others in their place, since their rule fills something else.
    pub(super) filled_count: usize,
    pub(super) inputs: Vec<DrawingInput>,
    pub(super) reference: Option<ReferenceSystem>,
    pub(super) has_heights: bool,
    pub(super) remarks: Vec<Remark>,
}

/// What makes shapes of a model one feature.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
enum Key {
    Described(usize),
    Numbered(i64),
    Named(usize),
}

impl MapLayer {
    /// The features of models with their names.
    pub(super) fn new(models: &[(&str, &Model)]) -> Result<Self, Error> {
        let drawing = PlanarDrawing::with_options(models.iter().copied(), &DrawingOptions::of_map())?;
        let (mut features, mut filled_count) = (Vec::new(), 0);
        for &(name, model) in models {
            let coarse = model.coarse().map_err(|error| error.in_file(name))?;
            let model = coarse.as_ref().unwrap_or(model);
            match model.structure() {
                None => {
                    filled_count +=
                        add_features(model, &mut features).map_err(|error| error.in_file(name))?;
                }
                Some(Structure::Chains(complex)) if !model.positions().is_empty() => {
                    add_cells(model, complex, &mut features).map_err(|error| error.in_file(name))?;
                }
                Some(_) => {
                    let fault = Error::invalid("cells have no features").in_file(name);
                    return Err(fault.with_cure("give polygons and lines, such as .geojson and .wkt have"));
                }
            }
        }
        Ok(Self {
            features,
            filled_count,
            inputs: drawing.input_answers(),
            has_heights: !drawing.heights.is_empty(),
            remarks: drawing.remarks,
            reference: drawing.reference,
        })
    }

    /// The numbers of polygons of the features before each, and of all.
    pub(super) fn polygon_starts(&self) -> Vec<usize> {
        let mut count = 0;
        let counts = self.features.iter().map(|feature| feature.geometry.polygons.len());
        std::iter::once(0)
            .chain(counts.map(|own| {
                count += own;
                count
            }))
            .collect()
    }
}

/// The faces of a chain complex as features, each a polygon, then the edges of none as lines.
fn add_cells(model: &Model, complex: &ChainComplex, features: &mut Vec<MapFeature>) -> Result<(), Error> {
    let chains = ChainFaces::new(complex)?;
    let point = |&vertex: &u32| -> Point {
        let point = model.positions().point(VertexId::from_u32(vertex));
        [point[0], point[1], f64::NAN]
    };
    let mut add = |geometry: Geometry| {
        features.push(MapFeature { geometry, properties: "{}".to_owned(), id: String::new() });
    };
    for own in chains.faces.iter() {
        let ring = |&own: &u32| -> Corners { chains.loops.list(own as usize).iter().map(point).collect() };
        let mut rings: Rings = own.iter().map(ring).collect();
        // The outer one has the largest area.
        rings.sort_by(|a, b| doubled_area(b).abs().total_cmp(&doubled_area(a).abs()));
        if !rings.is_empty() {
            add(Geometry { polygons: vec![rings], ..Geometry::default() });
        }
    }
    for (ends, _) in chains.edges.iter().zip(&chains.is_side).filter(|(_, is_side)| !**is_side) {
        add(Geometry { lines: vec![ends.iter().map(point).collect()], ..Geometry::default() });
    }
    Ok(())
}

/// The shapes of a model as features; how many polygons have others in their place, since their drawing fills something else.
fn add_features(model: &Model, features: &mut Vec<MapFeature>) -> Result<usize, Error> {
    let rules = FillRules::of(model);
    let mut filled_count = 0;
    let table = model.features();
    let numbers = Features::new(model);
    let mut known: BTreeMap<Key, usize> = BTreeMap::new();
    let mut begin = |features: &mut Vec<MapFeature>, key: Option<Key>, properties: String, id: String| {
        let place = features.len();
        features.push(MapFeature { geometry: Geometry::default(), properties, id });
        if let Some(key) = key {
            known.insert(key, place);
        }
        place
    };
    for feature in 0..table.len() {
        let id = table.id(feature).unwrap_or_default().to_owned();
        begin(features, Some(Key::Described(feature)), table.properties(feature).to_owned(), id);
    }
    let point = |vertex: u32| -> Point {
        let point = model.positions().point(VertexId::from_u32(vertex));
        // Meshes in the plane have no heights.
        let height = if model.is_map_with_heights() { point[2] } else { f64::NAN };
        [point[0], point[1], height]
    };
    let all = shapes(model);
    for (described, (shape, group)) in features_of_shapes(model, &all).into_iter().zip(all) {
        let key = match (described, numbers.of(&shape), group) {
            (Some(feature), ..) => Some(Key::Described(feature)),
            (None, Some(number), _) => Some(Key::Numbered(number)),
            (None, None, Some(group)) => Some(Key::Named(group)),
            _ => None,
        };
        let place = match key.as_ref().and_then(|key| known.get(key)) {
            Some(&place) => place,
            None => {
                let name = group.map(|group| serde_json::Value::from(model.groups()[group].name()));
                let properties = name.map_or_else(|| "{}".to_owned(), |name| format!("{{\"name\":{name}}}"));
                let place = features.len();
                features.push(MapFeature { geometry: Geometry::default(), properties, id: String::new() });
                if let Some(key) = key {
                    known.insert(key, place);
                }
                place
            }
        };
        let geometry = &mut features[place].geometry;
        match shape {
            Shape::Line(line) => {
                geometry.lines.push(model.lines().list(line).iter().map(|&vertex| point(vertex)).collect());
            }
            Shape::Rings(lines) => {
                let ring = |line: usize| {
                    let corners = model.lines().list(line);
                    corners[..corners.len().saturating_sub(1)].iter().map(|&vertex| point(vertex)).collect()
                };
                let rule = rules.of_polygon(&lines);
                let rings: Rings = lines.map(ring).collect();
                match rule.map(|rule| polygons_by_rule(&rings, rule)).transpose()?.flatten() {
                    Some(polygons) => {
                        filled_count += 1;
                        geometry.polygons.extend(polygons);
                    }
                    None => geometry.polygons.push(rings),
                }
            }
            Shape::Face(face) => {
                let ring = model.polygons().list(face).iter().map(|&vertex| point(vertex)).collect();
                geometry.polygons.push(vec![ring]);
            }
            Shape::Point(vertex) => geometry.points.push(point(vertex.to_u32())),
        }
    }
    Ok(filled_count)
}

/// A drawing in which each list of polygons is a region, with what is inside of these.
pub(super) fn drawing_of<'a>(
    regions: impl IntoIterator<Item = (&'a [Rings], Filling)>,
) -> Result<PlanarDrawing, Error> {
    let name = || "map".to_owned();
    let mut drawing = PlanarDrawing { names: vec![name()], ..PlanarDrawing::default() };
    let mut flat = Vec::new();
    for (number, (polygons, filling)) in (0..).zip(regions) {
        let is_empty = polygons.is_empty();
        drawing.regions.push(Region { name: name(), model: 0, open_at: None, is_empty });
        for rings in polygons {
            let polygon = drawing.polygons.len() as u32;
            drawing.polygons.push(Polygon { region: number, feature: NO_FEATURE, filling, number: polygon });
            for (hole, ring) in rings.iter().enumerate() {
                let (first, count) = (flat.len() as u32 / 2, ring.len() as u32);
                drawing.rings.push(Ring { polygon, is_hole: hole > 0 });
                for (i, corner) in (0..).zip(ring) {
                    flat.extend_from_slice(&corner[..2]);
                    drawing.heights.push(corner[2]);
                    let next = if i + 1 == count { first } else { first + i + 1 };
                    drawing.segments.push([first + i, next]);
                    drawing.ring_of_segment.push(drawing.rings.len() as u32 - 1);
                }
            }
        }
    }
    drawing.vertex_starts = vec![0, flat.len() as u32 / 2];
    drawing.segment_starts = vec![0, drawing.segments.len() as u32];
    drawing.positions = Positions::from_flat(2, flat)?;
    if drawing.heights.iter().all(|height| height.is_nan()) {
        drawing.heights.clear();
    }
    Ok(drawing)
}

/// Twice the signed area of a ring.
pub(super) fn doubled_area(ring: &[Point]) -> f64 {
    let Some(&[x, y, _]) = ring.first() else { return 0.0 };
    let sides = ring.iter().zip(ring.iter().cycle().skip(1));
    sides.map(|(a, b)| (a[0] - x) * (b[1] - y) - (a[1] - y) * (b[0] - x)).sum()
}

/// The area of polygons as they are drawn: outer rings minus holes.
pub(super) fn drawn_area(polygons: &[Rings]) -> f64 {
    let area = |ring: &Corners| doubled_area(ring).abs() / 2.0;
    let of_polygon = |rings: &Rings| {
        rings.iter().enumerate().map(|(i, ring)| if i == 0 { area(ring) } else { -area(ring) }).sum::<f64>()
    };
    polygons.iter().map(of_polygon).sum()
}
