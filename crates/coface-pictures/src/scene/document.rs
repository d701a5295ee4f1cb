//! A scene as the JSON document that a page holds.

use super::parts::common_width;
use super::{Layer, Pane, Scene};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use coface_algebra::RaggedArray;
use serde_json::{Value, json};

/// 32 bits each, little-endian.
fn numbers(numbers: impl IntoIterator<Item = u32>) -> String {
    let bytes: Vec<u8> = numbers.into_iter().flat_map(u32::to_le_bytes).collect();
    STANDARD.encode(bytes)
}

/// 32 bits each, little-endian.
fn reals(reals: impl IntoIterator<Item = f64>) -> String {
    let bytes: Vec<u8> = reals.into_iter().flat_map(|x| (x as f32).to_le_bytes()).collect();
    STANDARD.encode(bytes)
}

/// Lists by where they start; lists that all have one length say it instead.
fn lists(lists: &RaggedArray) -> Value {
    let items = numbers(lists.items().iter().copied());
    if let Some(width) = common_width(lists) {
        return json!({ "width": width, "items": items });
    }
    let starts = numbers((0..=lists.len()).map(|i| lists.start(i) as u32));
    json!({ "starts": starts, "items": items })
}

impl Scene {
    /// The scene as the JSON document that a page shows: arrays of numbers are base64 of little-endian bytes, 32 bits each.
    pub fn to_json(&self) -> Value {
        let shifted = |point: &[f64; 3]| [0, 1, 2].map(|axis| point[axis] - self.origin[axis]);
        let layers: Vec<Value> = self.layers.iter().map(|layer| layer_to_json(layer, shifted)).collect();
        let mut object = json!({
            "coface_scene": 1,
            "title": self.title,
            "report": self.report,
            "dimension": self.dimension,
            "origin": self.origin,
            "positions": reals(self.positions.iter().flat_map(shifted)),
            "polygons": lists(&self.parts.polygons),
            "rims": lists(&self.parts.rims),
            "polygonsOfRims": numbers(self.parts.polygon_of_rim.iter().copied()),
            "simplices": lists(&self.parts.simplices),
            "cells": lists(&self.parts.cells),
            "signs": numbers(self.parts.cell_signs.iter().map(|&is_negative| u32::from(is_negative))),
            "notes": self.notes,
            "triangles": null,
            "layers": layers,
            "panes": self.panes.iter().map(pane_to_json).collect::<Vec<_>>(),
        });
        // Triangles that are the polygons need not be there twice.
        let is_plain = self.parts.cells.is_empty()
            && common_width(&self.parts.polygons) == Some(3)
            && self.triangles.as_flattened() == self.parts.polygons.items();
        if !is_plain {
            object["triangles"] = json!({
                "items": numbers(self.triangles.as_flattened().iter().copied()),
                "polygons": numbers(self.polygon_of_triangle.iter().copied()),
                "cells": numbers(self.cell_of_triangle.iter().copied()),
            });
        }
        object
    }
}

fn layer_to_json(layer: &Layer, shifted: impl Fn(&[f64; 3]) -> [f64; 3] + Copy) -> Value {
    let labels: Vec<Value> =
        layer.labels.iter().map(|(point, text)| json!({ "point": point, "text": text })).collect();
    let mut object = json!({
        "name": layer.name,
        "group": layer.group,
        "detail": layer.detail,
        "on": layer.is_on,
        "lines": lists(&layer.lines),
        "points": numbers(layer.points.iter().copied()),
        "triangles": numbers(layer.triangles.as_flattened().iter().copied()),
        "labels": labels,
    });
    if let Some(color) = layer.color {
        object["color"] = color.into();
    }
    if layer.has_arrows {
        object["arrows"] = true.into();
    }
    if let Some(positions) = &layer.positions {
        object["positions"] = reals(positions.iter().flat_map(shifted)).into();
    }
    object
}

fn pane_to_json(pane: &Pane) -> Value {
    let layers: Vec<Value> = pane.layers.iter().map(|layer| layer_to_json(layer, |point| *point)).collect();
    let mut object = json!({
        "name": pane.name,
        "positions": reals(pane.positions.iter().flatten().copied()),
        "layers": layers,
    });
    if let Some(axes) = &pane.axes {
        object["axes"] = json!(axes);
    }
    object
}
