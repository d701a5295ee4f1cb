//! Regions of the plane: polygons with holes of drawings.

use super::Layer;
use super::shading::triangulated_walks;
use coface_io::{GroupKind, Model};

/// Of so many regions each has a layer of its own; more are one layer.
const MOST_LAYERS: usize = 24;

/// The regions that the rings of a drawing bound, as layers of triangles.
pub(super) fn region_layers(model: &Model, positions: &[[f64; 3]]) -> Vec<Layer> {
    let Some(data) = model.data_named("polygon", GroupKind::Lines) else { return Vec::new() };
    let mut rings: Vec<(i64, usize)> = (0..model.lines().len())
        .filter_map(|line| data.integer_row(line).map(|row| (row[0], line)))
        .filter(|&(polygon, line)| {
            let ring = model.lines().list(line);
            polygon >= 0 && ring.len() > 3 && ring.first() == ring.last()
        })
        .collect();
    rings.sort_unstable();
    let at = |vertex: u32| [positions[vertex as usize][0], positions[vertex as usize][1]];
    let mut layers: Vec<Layer> = Vec::new();
    let is_split = rings.chunk_by(|a, b| a.0 == b.0).count() <= MOST_LAYERS;
    for group in rings.chunk_by(|a, b| a.0 == b.0) {
        let walks = group.iter().enumerate().map(|(place, &(_, line))| {
            let ring = model.lines().list(line);
            let mut walk = ring[..ring.len() - 1].to_vec();
            // The first ring is around the others.
            if (doubled_area(&walk, &at) > 0.0) != (place == 0) {
                walk.reverse();
            }
            walk
        });
        let Some(triangles) = triangulated_walks(walks.collect(), &at) else { continue };
        if is_split || layers.is_empty() {
            let name = if is_split { format!("region {}", group[0].0) } else { "regions".to_owned() };
            let mut layer = Layer::new("regions", name);
            layer.is_on = true;
            layers.push(layer);
        }
        if let Some(layer) = layers.last_mut() {
            layer.triangles.extend(triangles);
            if is_split && group.len() > 1 {
                layer.detail = holes_text(group.len() - 1);
            }
        }
    }
    layers
}

/// The number of holes in words.
pub(super) fn holes_text(count: usize) -> String {
    if count == 1 { "1 hole".to_owned() } else { format!("{count} holes") }
}

/// Twice the area that a walk is counterclockwise around.
fn doubled_area(walk: &[u32], at: &impl Fn(u32) -> [f64; 2]) -> f64 {
    let origin = walk.first().map_or([0.0; 2], |&vertex| at(vertex));
    let sides = (0..walk.len()).map(|i| [at(walk[i]), at(walk[(i + 1) % walk.len()])]);
    sides
        .map(|[a, b]| (a[0] - origin[0]) * (b[1] - origin[1]) - (b[0] - origin[0]) * (a[1] - origin[1]))
        .sum()
}
