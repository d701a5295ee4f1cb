//! GraphML.

use super::rows::{Rows, at};
use crate::scanner::quoted;
use crate::xml_text::document;
use crate::{Place, Remark, RemarkCode};
use coface_algebra::Error;
use roxmltree::Node;
use std::collections::BTreeMap;
use std::io::Read;

/// The nodes and edges of a document.
pub(super) fn rows(mut input: impl Read) -> Result<Rows, Error> {
    let mut text = String::new();
    input.read_to_string(&mut text).map_err(|error| {
        Error::parse(format!("the document cannot be read as text: {error}"))
            .with_cure("write GraphML in UTF-8")
    })?;
    let document = document(&text)?;
    let lines = Lines::of(&text);
    let root = document.root_element();
    if root.tag_name().name() != "graphml" {
        let name = quoted(root.tag_name().name().as_bytes());
        return Err(Error::parse(format!("the document is {name}, not a graph"))
            .with_cure("give GraphML, or an edge list with rows u v value"));
    }
    let keys = Keys::of(root, &lines)?;
    let mut rows = Rows::default();
    let elements = |name: &'static str| root.descendants().filter(move |node| node.tag_name().name() == name);
    for node in elements("node") {
        let line = lines.line(node);
        let vertex = rows.vertex(attribute(node, "id", line)?);
        if let Some(value) = keys.value(node, &keys.of_nodes, line)? {
            rows.push_birth(vertex, value, line)?;
        }
    }
    for edge in elements("edge") {
        let line = lines.line(edge);
        let end = |name: &str| -> Result<u32, Error> {
            let id = attribute(edge, name, line)?;
            rows.known(id).ok_or_else(|| {
                let error = Error::invalid(format!(
                    "the {name} of an edge is {}, and no node has this id",
                    quoted(id.as_bytes())
                ));
                at(error.with_cure("give each node a <node id=\"..\"/>"), line)
            })
        };
        let (from, to) = (end("source")?, end("target")?);
        let is_directed = is_directed(edge);
        rows.has_directions |= is_directed;
        match keys.value(edge, &keys.of_edges, line)? {
            _ if from == to => rows.push_loop(line),
            value => rows.push_edge((from, to), value.unwrap_or(1.0), line, !is_directed)?,
        }
    }
    let others: Vec<_> = elements("hyperedge").map(|node| lines.line(node)).collect();
    if !others.is_empty() {
        let message = format!("{} of more than two nodes were left out (hyperedge)", others.len());
        let remark = Remark::new(RemarkCode::ElementsLeftOut, message);
        rows.remarks.push(remark.at(others.len(), others.into_iter().flatten().map(Place::line)));
    }
    Ok(rows)
}

/// The keys of values, each with the value of what has none.
struct Keys {
    of_nodes: BTreeMap<String, Option<f64>>,
    of_edges: BTreeMap<String, Option<f64>>,
}

impl Keys {
    fn of(root: Node<'_, '_>, lines: &Lines) -> Result<Self, Error> {
        let mut keys = Self { of_nodes: BTreeMap::new(), of_edges: BTreeMap::new() };
        for key in root.children().filter(|node| node.tag_name().name() == "key") {
            let line = lines.line(key);
            let id = attribute(key, "id", line)?;
            let name = key.attribute("attr.name").unwrap_or(id);
            if !name.eq_ignore_ascii_case("weight") {
                continue;
            }
            let default = key.children().find(|node| node.tag_name().name() == "default");
            let default = default.map(|node| number(node, line)).transpose()?;
            let domain = key.attribute("for").unwrap_or("all");
            if matches!(domain, "node" | "all") {
                keys.of_nodes.insert(id.to_owned(), default);
            }
            if matches!(domain, "edge" | "all") {
                keys.of_edges.insert(id.to_owned(), default);
            }
        }
        Ok(keys)
    }

    /// The value of a node or an edge, if it has one.
    fn value(
        &self,
        of: Node<'_, '_>,
        keys: &BTreeMap<String, Option<f64>>,
        line: Option<u64>,
    ) -> Result<Option<f64>, Error> {
        let data = of.children().filter(|node| node.tag_name().name() == "data");
        for data in data {
            if data.attribute("key").is_some_and(|key| keys.contains_key(key)) {
                return number(data, line).map(Some);
            }
        }
        Ok(keys.values().flatten().next().copied())
    }
}

fn number(node: Node<'_, '_>, line: Option<u64>) -> Result<f64, Error> {
    let text = node.text().unwrap_or("").trim();
    text.parse().map_err(|_| {
        let error = Error::parse(format!("the weight {} is no number", quoted(text.as_bytes())));
        at(error.with_cure("write the weight as a number, or leave it out"), line)
    })
}

fn attribute<'a>(node: Node<'a, '_>, name: &str, line: Option<u64>) -> Result<&'a str, Error> {
    node.attribute(name).ok_or_else(|| {
        let error = Error::parse(format!("<{}> has no {name}", node.tag_name().name()));
        at(error.with_cure("the file is damaged: write it again"), line)
    })
}

/// Whether an edge has a direction: by itself, or as the edges of its graph.
fn is_directed(edge: Node<'_, '_>) -> bool {
    let own = edge.attribute("directed").map(|word| word == "true");
    let graph = edge.ancestors().find(|node| node.tag_name().name() == "graph");
    own.or(graph.and_then(|graph| graph.attribute("edgedefault")).map(|word| word == "directed"))
        .unwrap_or(false)
}

/// Where lines end.
struct Lines(Vec<usize>);

impl Lines {
    fn of(text: &str) -> Self {
        Self(memchr::memchr_iter(b'\n', text.as_bytes()).collect())
    }

    fn line(&self, node: Node<'_, '_>) -> Option<u64> {
        Some(self.0.partition_point(|&end| end < node.range().start) as u64 + 1)
    }
}
