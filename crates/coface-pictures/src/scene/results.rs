//! Answers that were written as JSON, as layers and panes.

use super::cochains::cocycle_layers;
use super::cover::cover_pane;
use super::domain::domain_panes;
use super::forest::{NestedCurve, forest_pane};
use super::persistence::diagram_pane;
use super::values::{array, push_chain, vertices};
use super::{Layer, Scene};
use coface_algebra::Error;
use serde::Serialize;
use serde_json::Value;

impl Scene {
    /// Adds what an answer of coface says, as its type or as the JSON object of its verb: generators, cocycles, harmonic forms, seams with the domain
    /// that they cut, covers, loops, sets of simplices, facts about the cells of an arrangement, forests, persistence diagrams.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for an object with nothing that could be shown, that has no number
    /// where one should be, or that names vertices or counts cells which the model does not have.
    pub fn add_result(&mut self, name: &str, answer: &impl Serialize) -> Result<(), Error> {
        let result = &serde_json::to_value(answer)
            .map_err(|error| Error::invalid(format!("{name} is no answer: {error}")))?;
        super::answers::check(name, result)?;
        let before = (self.layers.len(), self.panes.len());
        let mut layers = Vec::new();
        generators(result, &mut layers);
        seams(result, &mut layers);
        loops(result, &mut layers);
        cocycle_layers(result, &mut layers);
        simplex_sets(result, &mut layers);
        layers.extend(self.harmonic_layers(result));
        let vertex_count = self.positions.len();
        let other_model = |what: String| {
            Err(Error::invalid(format!("{what} in {name}"))
                .with_cure("show it with the model that it was computed from"))
        };
        let sources =
            vertices(&result["source"]).into_iter().max().filter(|&last| last as usize >= vertex_count);
        if let Some(last) = sources {
            return other_model(format!("the model has {vertex_count} vertices, but there is vertex {last}"));
        }
        let too_high = layers.iter().find_map(|layer| {
            let count = layer.positions.as_ref().map_or(vertex_count, Vec::len);
            layer.last_point().filter(|&last| last as usize >= count).map(|last| (layer, last))
        });
        if let Some((layer, last)) = too_high {
            let what = layer.name.clone();
            return other_model(format!(
                "the model has {vertex_count} vertices, but {what} has vertex {last}"
            ));
        }
        let has_notes = match self.add_notes(result) {
            Ok(has_notes) => has_notes,
            Err([here, there]) => {
                return other_model(format!(
                    "the model has {here} top cells, but there are {there} measures"
                ));
            }
        };
        for layer in layers {
            self.push_layer(layer);
        }
        self.panes.extend(domain_panes(result));
        self.panes.extend(cover_pane(result));
        self.panes.extend(diagram_pane(result));
        self.panes.extend(nested(result).and_then(|curves| forest_pane(&curves)));
        if (self.layers.len(), self.panes.len()) == before && !has_notes {
            return Err(Error::invalid(format!("{name} has nothing that could be shown over a model")).with_cure(
                "give the JSON of homology --generators, cut, cover, pi1, cocycles, arrange, persistence, star, link, ...",
            ));
        }
        Ok(())
    }

    /// What an arrangement says about its cells: volumes or areas, and the inputs that they lie in. The counts if they differ.
    fn add_notes(&mut self, result: &Value) -> Result<bool, [usize; 2]> {
        let Some(measures) = result["measures"].as_array() else { return Ok(false) };
        let count =
            if self.parts.cells.is_empty() { self.parts.polygons.len() } else { self.parts.cells.len() };
        if count != measures.len() {
            return Err([count, measures.len()]);
        }
        let files = if result["files"].is_array() { "files" } else { "inputs" };
        let names: Vec<&str> =
            array(result, files).iter().map(|file| file["file"].as_str().unwrap_or("input")).collect();
        let word = if self.parts.cells.is_empty() { "area" } else { "volume" };
        let note = |(cell, measure): (usize, &Value)| {
            let inside: Vec<String> = vertices(&result["inside"][cell])
                .into_iter()
                .map(|input| {
                    names.get(input as usize).map_or_else(|| input.to_string(), |name| (*name).to_owned())
                })
                .collect();
            let inside = if inside.is_empty() { "no input".to_owned() } else { inside.join(", ") };
            format!("{word} {}, inside {inside}", measure.as_f64().unwrap_or(f64::NAN))
        };
        self.notes = measures.iter().enumerate().map(note).collect();
        Ok(true)
    }
}

/// The curves of a set.
fn nested(result: &Value) -> Option<Vec<NestedCurve>> {
    let curve = |curve: &Value| NestedCurve {
        parent: curve["parent"].as_u64().map(|parent| parent as usize),
        is_clockwise: curve["sign"].as_i64() == Some(-1),
    };
    Some(result["curves"].as_array()?.iter().map(curve).collect())
}

/// Generators of homology or cohomology, by degrees.
fn generators(result: &Value, layers: &mut Vec<Layer>) {
    let is_dual = result["cohomology"] == Value::Bool(true);
    let group = if is_dual { "cohomology" } else { "homology" };
    for (degree, list) in array(result, "generators").iter().enumerate() {
        for (number, generator) in list.as_array().into_iter().flatten().enumerate() {
            let power = if is_dual { "H^" } else { "H" };
            let mut layer = Layer::new(group, format!("{power}{degree} generator {number}"));
            let count = push_chain(&mut layer, &generator["chain"]);
            let order = match &generator["order"] {
                Value::String(digits) => digits.clone(),
                number => number.as_u64().unwrap_or(0).to_string(),
            };
            let order = if order == "0" { "infinite order".to_owned() } else { format!("order {order}") };
            layer.detail =
                format!("length {}, {order}", generator["length"].as_u64().unwrap_or(count as u64));
            layer.is_on = degree == 1;
            layer.has_arrows = degree == 1;
            layers.push(layer);
        }
    }
}

/// Seams of cut surfaces, and loops of fundamental groups. Each seam has the color of its sides in the domain.
fn seams(result: &Value, layers: &mut Vec<Layer>) {
    for (at, component) in array(result, "components").iter().enumerate() {
        for (place, seam) in array(component, "seams").iter().enumerate() {
            let number = seam["number"].as_u64().map_or_else(String::new, |number| format!(" {number}"));
            let kind = seam["kind"].as_str().unwrap_or("seam");
            let mut layer = Layer::new("cut", format!("{kind}{number} of component {at}"));
            layer.lines.push(&vertices(&seam["vertices"]));
            layer.detail = edges(seam["edges"].as_u64().unwrap_or(0));
            layer.color = Some(place as u32);
            layer.has_arrows = true;
            layer.is_on = true;
            layers.push(layer);
        }
        for (number, walk) in array(component, "loops").iter().enumerate() {
            layers.push(loop_layer(walk, format!("loop {} of component {at}", number + 1)));
        }
    }
}

/// Loops that stand for themselves: closed walks, or chains.
fn loops(result: &Value, layers: &mut Vec<Layer>) {
    for key in ["loops", "walks"] {
        for (number, walk) in array(result, key).iter().enumerate() {
            let mut layer = loop_layer(walk, format!("loop {}", number + 1));
            // Cocycles are shown first, and then the loops that they are measured on.
            layer.is_on = array(result, "cocycles").is_empty();
            layers.push(layer);
        }
    }
}

fn loop_layer(walk: &Value, name: String) -> Layer {
    let mut layer = Layer::new("loops", name);
    let walk = if walk.is_array() { walk } else { &walk["vertices"] };
    let count = if walk[0].is_array() {
        push_chain(&mut layer, walk)
    } else {
        let walk = vertices(walk);
        layer.lines.push(&walk);
        walk.len().saturating_sub(1)
    };
    layer.detail = edges(count as u64);
    layer.has_arrows = true;
    layer.is_on = true;
    layer
}

fn edges(count: u64) -> String {
    if count == 1 { "1 edge".to_owned() } else { format!("{count} edges") }
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
