//! Answers that were written as JSON, as layers and panes.

use super::{Layer, Pane, Scene};
use crate::Error;
use crate::algebra::RaggedArray;
use serde_json::Value;

/// The vertices of a cell.
pub(super) fn vertices(cell: &Value) -> Vec<u32> {
    cell.as_array()
        .into_iter()
        .flatten()
        .filter_map(|vertex| vertex.as_u64().and_then(|vertex| u32::try_from(vertex).ok()))
        .collect()
}

fn array<'a>(value: &'a Value, key: &str) -> &'a [Value] {
    value[key].as_array().map_or(&[], Vec::as_slice)
}

/// The cells of a chain `[[coefficient, cell], ..]`.
fn push_chain(layer: &mut Layer, chain: &Value) -> usize {
    let terms = chain.as_array().map_or(&[][..], Vec::as_slice);
    terms.iter().for_each(|term| layer.push_simplex(&vertices(&term[1])));
    terms.len()
}

impl Scene {
    /// Adds what an answer of coface says, given as the JSON object of its verb: generators, seams, loops, cocycles, sets of
    /// simplices, a persistence diagram.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](crate::ErrorKind::InvalidInput) for an object with nothing that could be shown, or that names vertices which the model does not have.
    pub fn add_result(&mut self, name: &str, result: &Value) -> Result<(), Error> {
        let before = (self.layers.len(), self.panes.len());
        let mut layers = Vec::new();
        generators(result, &mut layers);
        seams(result, &mut layers);
        cocycles(result, &mut layers);
        simplex_sets(result, &mut layers);
        let vertex_count = self.positions.len();
        if let Some(layer) =
            layers.iter().find(|layer| layer.last_point().is_some_and(|last| last as usize >= vertex_count))
        {
            return Err(Error::invalid(format!(
                "{} in {name} has vertex {}, but the model has {vertex_count}",
                layer.name,
                layer.last_point().unwrap_or(0)
            ))
            .with_cure("show it with the model that it was computed from"));
        }
        for layer in layers {
            self.push_layer(layer);
        }
        self.panes.extend(diagram(result));
        if (self.layers.len(), self.panes.len()) == before {
            return Err(Error::invalid(format!("{name} has nothing that could be shown over a model"))
                .with_cure("give the JSON of homology --generators, cut, pi1, cocycles, persistence, star, link, ..."));
        }
        Ok(())
    }
}

/// Generators of homology, by degrees.
fn generators(result: &Value, layers: &mut Vec<Layer>) {
    for (degree, list) in array(result, "generators").iter().enumerate() {
        for (number, generator) in list.as_array().into_iter().flatten().enumerate() {
            let mut layer = Layer::new("homology", format!("H{degree} generator {number}"));
            let count = push_chain(&mut layer, &generator["chain"]);
            let order = generator["order"].as_u64().unwrap_or(0);
            let free = if order == 0 { "free".to_owned() } else { format!("order {order}") };
            layer.detail = format!("{count} cells, {free}");
            layer.is_on = degree == 1;
            layers.push(layer);
        }
    }
}

/// Seams of cut surfaces, and loops of fundamental groups.
fn seams(result: &Value, layers: &mut Vec<Layer>) {
    for (at, component) in array(result, "components").iter().enumerate() {
        for seam in array(component, "seams") {
            let number = seam["number"].as_u64().map_or_else(String::new, |number| format!(" {number}"));
            let kind = seam["kind"].as_str().unwrap_or("seam");
            let mut layer = Layer::new("cut", format!("{kind}{number} of component {at}"));
            layer.lines.push(&vertices(&seam["vertices"]));
            layer.detail = format!("{} edges", seam["edges"]);
            layer.is_on = true;
            layers.push(layer);
        }
        for (number, walk) in array(component, "loops").iter().enumerate() {
            let mut layer = Layer::new("loops", format!("loop {} of component {at}", number + 1));
            let walk = if walk.is_array() { walk } else { &walk["vertices"] };
            layer.lines.push(&vertices(walk));
            layer.is_on = true;
            layers.push(layer);
        }
    }
}

/// Cocycles: the edges where they are not zero.
fn cocycles(result: &Value, layers: &mut Vec<Layer>) {
    for (number, cocycle) in array(result, "cocycles").iter().enumerate() {
        let mut layer = Layer::new("cocycles", format!("cocycle {number}"));
        let count = push_chain(&mut layer, cocycle);
        layer.detail = format!("{count} edges");
        layers.push(layer);
    }
}

/// Stars, links, closures, boundaries, skeleta.
fn simplex_sets(result: &Value, layers: &mut Vec<Layer>) {
    let simplices = array(result, "simplices");
    if !simplices.is_empty() {
        let mut layer = Layer::new("simplices", "simplices");
        simplices.iter().for_each(|simplex| layer.push_simplex(&vertices(simplex)));
        layer.detail = format!("{} of them", simplices.len());
        layer.is_on = true;
        layers.push(layer);
    }
}

/// The points of a persistence diagram, with the diagonal.
fn diagram(result: &Value) -> Option<Pane> {
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
