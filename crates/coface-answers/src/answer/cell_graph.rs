//! The graph of the cells of an arrangement in space: which are adjacent, across how much area, and whose faces are
//! between them.

use serde::{Deserialize, Serialize};
use std::fmt::Write;

/// The bounded cells of an arrangement, and the pairs of them that have faces in common.
///
/// # Examples
/// Two tetrahedra on a common triangle with corners (0, 0, 0), (1, 0, 0), (0, 1, 0):
/// ```
/// use coface_answers::{RegionSource, SceneArrangement, SpatialRequest, SpatialScene};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nv 0 0 -12\n\
///     o up\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\no down\nf 1 2 3\nf 2 1 5\nf 3 2 5\nf 1 3 5\n";
/// let model = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
/// let scene = SpatialScene::with_inputs([("both.obj", &model)], RegionSource::Objects, true)?;
/// let graph = SceneArrangement::of_scene(scene, &SpatialRequest::default())?.graph(Default::default())?;
/// assert_eq!(graph.inputs, ["up", "down"]);
/// assert_eq!((graph.edges[0].area, &graph.edges[0].inputs[..]), (0.5, &[0, 1][..]));
/// assert_eq!(graph.nodes.iter().map(|node| node.volume).sum::<f64>(), 3.0);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct CellGraph {
    /// The names of the inputs in their order.
    pub inputs: Vec<String>,
    /// The bounded cells in their order.
    pub nodes: Vec<CellNode>,
    /// The pairs of different bounded cells that have a face in common, rising.
    pub edges: Vec<CellEdge>,
}

/// A bounded cell.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct CellNode {
    /// The number of the cell, from 0.
    pub cell: usize,
    /// Its volume without its voids, in the cube of the unit of the inputs.
    pub volume: f64,
    /// The center of its mass.
    pub centroid: [f64; 3],
    /// The least and the largest coordinates.
    pub bounds: [[f64; 3]; 2],
    /// The inputs that contain the cell, numbered from 0, rising: none for a room of a building.
    pub inputs: Vec<usize>,
    /// Whether it has a face in common with the exterior.
    pub exterior: bool,
    /// The area of its faces in common with the exterior, in the square of the unit of the inputs.
    pub exterior_area: f64,
    /// The number of these faces.
    pub exterior_faces: usize,
    /// The inputs that have polygons on these faces, numbered from 0, rising.
    pub exterior_inputs: Vec<usize>,
}

/// Two bounded cells that have faces in common.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct CellEdge {
    /// The two cells, rising.
    pub cells: [usize; 2],
    /// The area of the faces that they have in common, in the square of the unit of the inputs.
    pub area: f64,
    /// The number of these faces.
    pub faces: usize,
    /// The inputs that have polygons on these faces, numbered from 0, rising.
    pub inputs: Vec<usize>,
}

/// Keys of GraphML: what they are of, their names and their types.
const KEYS: [(&str, &str, &str); 18] = [
    ("node", "volume", "double"),
    ("node", "x", "double"),
    ("node", "y", "double"),
    ("node", "z", "double"),
    ("node", "min_x", "double"),
    ("node", "min_y", "double"),
    ("node", "min_z", "double"),
    ("node", "max_x", "double"),
    ("node", "max_y", "double"),
    ("node", "max_z", "double"),
    ("node", "inputs", "string"),
    ("node", "exterior", "boolean"),
    ("node", "exterior_area", "double"),
    ("node", "exterior_faces", "int"),
    ("node", "exterior_inputs", "string"),
    ("edge", "area", "double"),
    ("edge", "faces", "int"),
    ("edge", "inputs", "string"),
];

impl CellGraph {
    /// The names of inputs with these numbers.
    fn names(&self, inputs: &[usize]) -> String {
        let name = |&input: &usize| self.inputs.get(input).map_or("", String::as_str);
        inputs.iter().map(name).collect::<Vec<_>>().join("; ")
    }

    /// The graph as GraphML: node `c0` is cell 0, x, y and z are the centroid, and inputs are named, with a semicolon
    /// between two names.
    ///
    /// # References
    /// U. Brandes et al., *GraphML Progress Report* (2002).
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{SceneArrangement, SpatialRequest};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let arranged = SceneArrangement::of([("a&b", &solid)], &SpatialRequest::default())?;
    /// let text = arranged.graph(Default::default())?.to_graphml();
    /// assert!(text.contains("<node id=\"c0\"><data key=\"node_volume\">1</data>"));
    /// assert!(text.contains("<data key=\"node_inputs\">a&amp;b</data>"));
    /// # Ok(()) }
    /// ```
    pub fn to_graphml(&self) -> String {
        let mut text = String::from(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<graphml xmlns=\"http://graphml.graphdrawing.org/xmlns\">\n",
        );
        // Writing to a string does not fail.
        for (domain, name, kind) in KEYS {
            let _ = writeln!(
                text,
                "<key id=\"{domain}_{name}\" for=\"{domain}\" attr.name=\"{name}\" attr.type=\"{kind}\"/>"
            );
        }
        text += "<graph id=\"cells\" edgedefault=\"undirected\">\n";
        for node in &self.nodes {
            let _ = write!(text, "<node id=\"c{}\">", node.cell);
            let mut data = |name: &str, value: String| push_data(&mut text, "node", name, &value);
            data("volume", node.volume.to_string());
            for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
                data(name, node.centroid[axis].to_string());
                data(&format!("min_{name}"), node.bounds[0][axis].to_string());
                data(&format!("max_{name}"), node.bounds[1][axis].to_string());
            }
            data("inputs", self.names(&node.inputs));
            data("exterior", node.exterior.to_string());
            data("exterior_area", node.exterior_area.to_string());
            data("exterior_faces", node.exterior_faces.to_string());
            data("exterior_inputs", self.names(&node.exterior_inputs));
            text += "</node>\n";
        }
        for edge in &self.edges {
            let _ = write!(text, "<edge source=\"c{}\" target=\"c{}\">", edge.cells[0], edge.cells[1]);
            let mut data = |name: &str, value: String| push_data(&mut text, "edge", name, &value);
            data("area", edge.area.to_string());
            data("faces", edge.faces.to_string());
            data("inputs", self.names(&edge.inputs));
            text += "</edge>\n";
        }
        text += "</graph>\n</graphml>\n";
        text
    }
}

fn push_data(text: &mut String, domain: &str, name: &str, value: &str) {
    let _ = write!(text, "<data key=\"{domain}_{name}\">");
    for character in value.chars() {
        match character {
            '&' => *text += "&amp;",
            '<' => *text += "&lt;",
            '>' => *text += "&gt;",
            // A reader would take it for a line feed.
            '\r' => *text += "&#13;",
            // XML 1.0 has no way to write these.
            '\0'..='\u{8}' | '\u{b}' | '\u{c}' | '\u{e}'..='\u{1f}' | '\u{fffe}' | '\u{ffff}' => {
                text.push(char::REPLACEMENT_CHARACTER);
            }
            _ => text.push(character),
        }
    }
    *text += "</data>";
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_escaped_and_every_key_is_declared() {
        let node = CellNode {
            cell: 0,
            volume: 2.5,
            centroid: [0.0, 0.5, 1e-7],
            bounds: [[-1.0; 3], [1.0; 3]],
            inputs: vec![0, 1],
            exterior: true,
            exterior_area: 1e20,
            exterior_faces: 3,
            exterior_inputs: vec![1],
        };
        let other = CellNode { cell: 1, ..node.clone() };
        let edge = CellEdge { cells: [0, 1], area: 7.5, faces: 2, inputs: vec![0] };
        let inputs = vec!["<a> & \"b\"".to_owned(), "bell\u{7}".to_owned()];
        let text = CellGraph { inputs, nodes: vec![node, other], edges: vec![edge] }.to_graphml();
        assert!(text.contains("&lt;a&gt; &amp; \"b\"; bell\u{fffd}</data>"), "{text}");
        assert!(
            text.contains("<edge source=\"c0\" target=\"c1\"><data key=\"edge_area\">7.5</data>"),
            "{text}"
        );
        assert!(!text.contains("e20") && !text.contains("e-7"), "{text}");
        let declared = |key: &str| text.contains(&format!("<key id=\"{key}\" "));
        let used = text.split("<data key=\"").skip(1).map(|rest| rest.split('"').next().unwrap_or_default());
        assert!(used.clone().all(declared));
        assert_eq!(used.collect::<std::collections::BTreeSet<_>>().len(), KEYS.len());
    }
}
