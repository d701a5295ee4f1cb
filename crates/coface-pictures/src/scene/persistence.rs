//! Persistence diagrams.

use super::values::array;
use super::{Layer, Pane};
use coface_algebra::RaggedArray;
use serde_json::Value;

/// The points of a persistence diagram, with the diagonal.
pub(super) fn diagram_pane(result: &Value) -> Option<Pane> {
    let pairs = array(result, "diagram");
    let values = || pairs.iter().flat_map(|pair| [pair["birth"].as_f64(), pair["death"].as_f64()]).flatten();
    let (low, high) =
        values().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
    if low > high {
        return None;
    }
    // What never dies stands above everything else.
    let top = high + 0.1 * (high - low).max(f64::MIN_POSITIVE);
    let mut pane = Pane {
        name: "persistence diagram".to_owned(),
        axes: Some(["birth".to_owned(), "death".to_owned()]),
        ..Pane::default()
    };
    pane.positions = vec![[low, low], [high, high], [low, top], [high, top]];
    let mut frame = Layer::new("diagram", "diagonal");
    frame.lines = RaggedArray::from_lists([[0, 1], [2, 3]]);
    frame.labels.push((2, "never".to_owned()));
    pane.layers.push(frame);
    let highest = pairs.iter().filter_map(|pair| pair["degree"].as_u64()).max().unwrap_or(0);
    for degree in 0..=highest {
        let mut layer = Layer::new("diagram", format!("H{degree}"));
        layer.is_on = true;
        for pair in pairs.iter().filter(|pair| pair["degree"].as_u64() == Some(degree)) {
            let Some(birth) = pair["birth"].as_f64() else { continue };
            layer.points.push(pane.positions.len() as u32);
            pane.positions.push([birth, pair["death"].as_f64().unwrap_or(top)]);
        }
        if !layer.is_empty() {
            pane.layers.push(layer);
        }
    }
    Some(pane)
}
