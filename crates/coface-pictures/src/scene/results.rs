//! Answers that were written as JSON, as layers and panes.

use super::cochains::cocycle_layers;
use super::cover::cover_pane;
use super::domain::domain_panes;
use super::forest::{NestedCurve, forest_pane};
use super::persistence::diagram_pane;
use super::shown::{AddedVertex, Curve, Number, Shown, Walk};
use super::{Layer, Scene};
use coface_algebra::{Error, RaggedArray};
use serde::Serialize;
use std::collections::BTreeMap;

/// Polygons of more sides may have lines anywhere across them.
const MOST_SIDES: usize = 64;

impl Scene {
    /// Adds what an answer of coface says, as its type or as the JSON object of its verb: generators, cocycles, harmonic forms, seams with the domain
    /// that they cut, covers, loops, sets of simplices, facts about the cells of an arrangement, forests, persistence diagrams. A list of terms
    /// `[[coefficient, [vertices..]], ..]` is a chain or cochain of one's own.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for an object with nothing that could be shown, that has no number
    /// where one should be, or that names vertices or counts cells which the model does not have.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_pictures::Scene;
    /// let square = &b"v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4\n"[..];
    /// let square = coface_io::read(square, coface_io::Format::Obj)?;
    /// let mut scene = Scene::of("square", &square)?;
    /// // The link of vertex 0 in the boundary: two points.
    /// scene.add_result("link", &serde_json::json!({"simplices": [[1], [3]]}))?;
    /// assert_eq!(scene.layers()[0].points, [1, 3]);
    /// let fault = scene.add_result("link", &serde_json::json!({"simplices": [[1], ["x"]]}));
    /// assert!(fault.is_err_and(|fault| fault.message().starts_with("simplices[1][0] is")));
    /// # Ok(()) }
    /// ```
    pub fn add_result(&mut self, name: &str, answer: &impl Serialize) -> Result<(), Error> {
        let written = serde_json::to_value(answer)
            .map_err(|error| Error::invalid(format!("{name} is no answer: {error}")))?;
        let result = &Shown::of(name, written)?;
        let before = (self.layers.len(), self.panes.len());
        let mut layers = Vec::new();
        generators(result, &mut layers);
        seams(result, &mut layers);
        roles(result, &mut layers);
        loops(result, &mut layers);
        cocycle_layers(result, &mut layers);
        simplex_sets(result, &mut layers);
        layers.extend(self.harmonic_layers(result));
        layers.extend(self.real_layers(result));
        let added = self.added_vertices(result);
        layers.iter_mut().for_each(|layer| self.place_added(layer, &added));
        let vertex_count = self.positions.len();
        let other_model = |what: String| {
            Err(Error::invalid(format!("{what} in {name}"))
                .with_cure("show it with the model that it was computed from"))
        };
        let is_there = |vertex: u32| (self.numbering.of(vertex) as usize) < vertex_count;
        if let Some(vertex) = result.source.0.iter().copied().find(|&vertex| !is_there(vertex)) {
            return other_model(format!(
                "the model has {vertex_count} vertices, but there is vertex {vertex}"
            ));
        }
        for layer in &layers {
            let count = layer.positions.as_ref().map_or(vertex_count, Vec::len);
            let renumbered = self.numbering.of_layer(layer.clone());
            if renumbered.last_point().is_none_or(|last| (last as usize) < count) {
                continue;
            }
            let vertex = layer.last_point().filter(|&last| !is_there(last));
            let vertex = vertex.map_or("another one".to_owned(), |vertex| format!("vertex {vertex}"));
            return other_model(format!(
                "the model has {vertex_count} vertices, but {} has {vertex}",
                layer.name
            ));
        }
        if let Some((what, [a, b])) = self.strange_edge(&layers, result) {
            return other_model(format!(
                "the model has no edge from vertex {a} to vertex {b}, but {what} has one"
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
        self.panes.extend(diagram_pane(result.diagram.list()));
        self.panes.extend(forest_pane(&nested(result)));
        if (self.layers.len(), self.panes.len()) == before && !has_notes {
            return Err(Error::invalid(format!("{name} has nothing that could be shown over a model")).with_cure(
                "give the JSON of homology --generators, cut, cover -o, pi1 --loops, cycles, cocycles, arrange, persistence, star, link, .., or a chain as [[coefficient,[vertices..]],..]",
            ));
        }
        Ok(())
    }

    /// Where the vertices lie that a cut has added to the model; none if it names vertices that the model does not have.
    fn added_vertices(&self, result: &Shown) -> BTreeMap<u32, [f64; 3]> {
        let place = |added: &AddedVertex| {
            let mut point = [0.0; 3];
            for (place, &vertex) in added.of.0.iter().enumerate() {
                let weight = added.weights.list().get(place)?.0;
                let of = self.positions.get(self.numbering.of(vertex) as usize)?;
                point.iter_mut().zip(of).for_each(|(sum, x)| *sum += weight * x);
            }
            Some((added.vertex.0, point))
        };
        let added = result.refinement.iter().flat_map(|refinement| refinement.vertices.list());
        added.map(place).collect::<Option<_>>().unwrap_or_default()
    }

    /// Gives a layer with lines through vertices that were added positions of its own.
    fn place_added(&self, layer: &mut Layer, added: &BTreeMap<u32, [f64; 3]>) {
        let is_added = layer.lines.items().iter().any(|vertex| added.contains_key(vertex));
        if !is_added || layer.positions.is_some() {
            return;
        }
        let place = |vertex: &u32| match added.get(vertex) {
            Some(point) => Some(*point),
            None => self.positions.get(self.numbering.of(*vertex) as usize).copied(),
        };
        let Some(positions) = layer.lines.items().iter().map(place).collect::<Option<Vec<_>>>() else {
            return;
        };
        let mut next = 0..;
        let numbered = |line: &[u32]| next.by_ref().take(line.len()).collect::<Vec<u32>>();
        let lines: Vec<Vec<u32>> = layer.lines.iter().map(numbered).collect();
        layer.lines = RaggedArray::from_lists(lines);
        layer.positions = Some(positions);
    }

    /// The first edge of layers or of a chain that runs from one vertex of a mesh to another and is no edge of it, with its name. Over points
    /// alone, complexes of them may have any edges.
    fn strange_edge(&self, layers: &[Layer], result: &Shown) -> Option<(String, [u32; 2])> {
        let of_layers = layers.iter().filter(|layer| layer.positions.is_none()).flat_map(|layer| {
            let pairs = layer.lines.iter().flat_map(|line| line.windows(2));
            pairs.map(|pair| (&layer.name[..], [pair[0], pair[1]]))
        });
        // Chains on edges are drawn as arrows, which have places of their own.
        let of_chain =
            result.chain.iter().flat_map(|chain| &chain.0).filter_map(|term| match term.cell[..] {
                [a, b] => Some(("the chain", [a, b])),
                _ => None,
            });
        let mut pairs = of_layers.chain(of_chain).peekable();
        let is_mesh = !self.parts.polygons.is_empty() || !self.parts.cells.is_empty();
        if !is_mesh || pairs.peek().is_none() {
            return None;
        }
        let mut edges = self.parts.edges();
        // What cuts polygons into triangles has lines across them.
        let large: Vec<&[u32]> = self.parts.polygons.iter().filter(|polygon| polygon.len() > 3).collect();
        if large.iter().any(|polygon| polygon.len() > MOST_SIDES) {
            return None;
        }
        for polygon in large {
            for (i, &a) in polygon.iter().enumerate() {
                edges.extend(polygon[i + 1..].iter().map(|&b| [a.min(b), a.max(b)]));
            }
        }
        edges.sort_unstable();
        pairs.find_map(|(name, edge)| {
            let [a, b] = edge.map(|vertex| self.numbering.of(vertex));
            let is_strange = a != b && edges.binary_search(&[a.min(b), a.max(b)]).is_err();
            is_strange.then(|| (name.to_owned(), edge))
        })
    }

    /// What an arrangement says about its cells: volumes or areas, and the inputs that they lie in. The counts if they differ.
    fn add_notes(&mut self, result: &Shown) -> Result<bool, [usize; 2]> {
        let Some(measures) = result.measures.given() else { return Ok(false) };
        let count =
            if self.parts.cells.is_empty() { self.parts.polygons.len() } else { self.parts.cells.len() };
        if count != measures.len() {
            return Err([count, measures.len()]);
        }
        let inputs = result.files.given().unwrap_or_else(|| result.inputs.list());
        let name = |&input: &u32| match inputs.get(input as usize) {
            Some(input) => input.file.0.clone().unwrap_or_else(|| "input".to_owned()),
            None => input.to_string(),
        };
        let word = if self.parts.cells.is_empty() { "area" } else { "volume" };
        let note = |(cell, measure): (usize, &Option<Number>)| {
            let inside = result.inside.list().get(cell).map_or(&[][..], |inputs| &inputs.0[..]);
            let inside: Vec<String> = inside.iter().map(name).collect();
            let inside = if inside.is_empty() { "no input".to_owned() } else { inside.join(", ") };
            format!("{word} {}, inside {inside}", measure.as_ref().map_or(f64::NAN, |measure| measure.0))
        };
        self.notes = measures.iter().enumerate().map(note).collect();
        Ok(true)
    }
}

/// The curves of a set.
fn nested(result: &Shown) -> Vec<NestedCurve> {
    let curve = |curve: &Curve| NestedCurve {
        parent: curve.parent.as_ref().map(|parent| parent.0),
        is_clockwise: curve.sign.as_ref().is_some_and(|sign| sign.0 < 0.0),
    };
    result.curves.list().iter().map(curve).collect()
}

/// Generators of homology or cohomology, by degrees.
fn generators(result: &Shown, layers: &mut Vec<Layer>) {
    let is_dual = result.cohomology.0;
    let group = if is_dual { "cohomology" } else { "homology" };
    for (degree, list) in result.generators.list().iter().enumerate() {
        for (number, generator) in list.list().iter().enumerate() {
            let power = if is_dual { "H^" } else { "H" };
            let mut layer = Layer::new(group, format!("{power}{degree} generator {}", number + 1));
            generator.chain.push_onto(&mut layer);
            let order = match &generator.order {
                Some(order) if !order.0.is_zero() => format!("order {}", order.0),
                _ => "infinite order".to_owned(),
            };
            let length = generator.length.as_ref().map(|length| length.0.to_string());
            let length = length.unwrap_or_else(|| generator.chain.0.len().to_string());
            layer.detail = format!("length {length}, {order}");
            layer.is_on = degree == 1;
            layer.has_arrows = degree == 1;
            layers.push(layer);
        }
    }
}

/// Seams of cut surfaces, and loops of fundamental groups. Each seam has the color of its sides in the domain.
fn seams(result: &Shown, layers: &mut Vec<Layer>) {
    for (at, component) in result.components.list().iter().enumerate() {
        for (place, seam) in component.seams.list().iter().enumerate() {
            let number = seam.number.as_ref().map_or_else(String::new, |number| format!(" {}", number.0));
            let kind = seam.kind.0.as_deref().unwrap_or("seam");
            let mut layer = Layer::new("cut", format!("{kind}{number} of component {}", at + 1));
            layer.lines.push(&seam.vertices.0);
            layer.detail = edges(seam.edges.as_ref().map_or(0, |edges| edges.0));
            layer.color = Some(place as u32);
            layer.has_arrows = true;
            layer.is_on = true;
            layers.push(layer);
        }
        for (number, walk) in component.loops.list().iter().enumerate() {
            layers.push(loop_layer(walk, format!("loop {} of component {}", number + 1, at + 1)));
        }
    }
}

/// The edges of a tree-cotree decomposition by what they are.
fn roles(result: &Shown, layers: &mut Vec<Layer>) {
    for roles in [&result.roles, &result.trees].into_iter().flatten() {
        let parts = [
            ("tree", &roles.tree, "edges of the spanning tree of vertices"),
            ("cotree", &roles.cotree, "edges that the spanning tree of faces crosses"),
            ("generators", &roles.generators, "edges in neither: each closes a loop of the tree"),
        ];
        for (place, (name, list, detail)) in parts.into_iter().enumerate() {
            if list.list().is_empty() {
                continue;
            }
            let mut layer = Layer::new("tree and cotree", name.to_owned());
            list.list().iter().for_each(|ends| {
                layer.lines.push(&ends.0);
            });
            layer.detail = format!("{}: {detail}", edges(list.list().len()));
            layer.color = Some(place as u32);
            layer.is_on = true;
            layers.push(layer);
        }
    }
}

/// Loops that stand for themselves: closed walks, or chains.
fn loops(result: &Shown, layers: &mut Vec<Layer>) {
    let kinds = result.kinds.list();
    let of_kind = |kind: &str| {
        let listed =
            result.loops.list().iter().zip(kinds).filter(move |(_, own)| own.0.as_deref() == Some(kind));
        listed.map(|(walk, _)| walk).collect::<Vec<&Walk>>()
    };
    let handles = result.handles.list();
    let [mut around, mut through] = ["handle", "tunnel"].map(of_kind);
    around.extend(handles.iter().filter_map(|handle| handle.handle.as_ref()));
    through.extend(handles.iter().filter_map(|handle| handle.tunnel.as_ref()));
    for (place, (name, walks)) in
        [("handle loops", around), ("tunnel loops", through)].into_iter().enumerate()
    {
        layers.extend(layer_of_loops(name, &walks, place as u32));
    }
    let others = if kinds.is_empty() { result.loops.list() } else { &[] };
    let lists = [("loop", others), ("loop", result.walks.list()), ("cycle", result.cycles.list())];
    for (name, walks) in lists {
        for (number, walk) in walks.iter().enumerate() {
            if name == "cycle" && matches!(walk, Walk::Vertices(vertices) if vertices.is_empty()) {
                continue;
            }
            let mut layer = loop_layer(walk, format!("{name} {}", number + 1));
            // Cocycles are shown first, and then the loops that they are measured on.
            layer.is_on = result.cocycles.list().is_empty();
            layers.push(layer);
        }
    }
}

/// All loops of a kind in one color; none if there are none.
fn layer_of_loops(name: &str, walks: &[&Walk], color: u32) -> Option<Layer> {
    let mut layer = Layer::new("loops", name);
    let count: usize = walks.iter().map(|walk| push_walk(walk, &mut layer)).sum();
    layer.detail = format!("{} of them, {}", walks.len(), edges(count));
    layer.color = Some(color);
    layer.is_on = true;
    (!walks.is_empty()).then_some(layer)
}

/// Draws a walk, and counts its edges.
fn push_walk(walk: &Walk, layer: &mut Layer) -> usize {
    match walk {
        Walk::Cycle(chain) => {
            chain.push_onto(layer);
            chain.0.len()
        }
        Walk::Vertices(walk) => {
            layer.lines.push(walk);
            walk.len().saturating_sub(1)
        }
    }
}

fn loop_layer(walk: &Walk, name: String) -> Layer {
    let mut layer = Layer::new("loops", name);
    let count = push_walk(walk, &mut layer);
    layer.detail = edges(count);
    layer.has_arrows = true;
    layer.is_on = true;
    layer
}

fn edges(count: usize) -> String {
    if count == 1 { "1 edge".to_owned() } else { format!("{count} edges") }
}

/// Stars, links, closures, boundaries, skeleta.
fn simplex_sets(result: &Shown, layers: &mut Vec<Layer>) {
    let simplices = result.simplices.list();
    if !simplices.is_empty() {
        let mut layer = Layer::new("simplices", "simplices");
        simplices.iter().for_each(|simplex| layer.push_simplex(&simplex.0));
        layer.detail = format!("{} of them", simplices.len());
        layer.is_on = true;
        layers.push(layer);
    }
}
