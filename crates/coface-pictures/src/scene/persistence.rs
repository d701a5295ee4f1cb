//! Persistence diagrams.

use super::shown::Pair;
use super::{Layer, Pane};
use coface_algebra::RaggedArray;

/// The points of a persistence diagram, with the diagonal.
pub(super) fn diagram_pane(pairs: &[Pair]) -> Option<Pane> {
    let death = |pair: &Pair| pair.death.as_ref().map(|death| death.0);
    let values = || pairs.iter().flat_map(|pair| [Some(pair.birth.0), death(pair)]).flatten();
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
    let highest = pairs.iter().map(|pair| pair.degree.0).max().unwrap_or(0);
    for degree in 0..=highest {
        let mut layer = Layer::new("diagram", format!("H{degree}"));
        layer.is_on = true;
        for pair in pairs.iter().filter(|pair| pair.degree.0 == degree) {
            layer.points.push(pane.positions.len() as u32);
            pane.positions.push([pair.birth.0, death(pair).unwrap_or(top)]);
        }
        if !layer.is_empty() {
            pane.layers.push(layer);
        }
    }
    Some(pane)
}
