//! `coface arrange` in the plane.

use super::Arrange;
use crate::arguments::Common;
use crate::failure::Failure;
use crate::output::{print_json, print_text, remark, write_json};
use crate::progress::Progress;
use crate::target::{Target, write_seen};
use coface::answers::text;
use coface::answers::{ArrangementRequest, DrawingArrangement, PlanarDrawing};
use coface::io::{Model, replace_file};
use serde_json::{Value, json};
use std::path::Path;

pub(super) fn run(
    verb: &Arrange,
    common: &Common,
    output: Option<(&Path, Target)>,
    models: &[(String, Model)],
    progress: Progress,
) -> Result<(), Failure> {
    progress.stage("arranging");
    let models = models.iter().map(|(name, model)| (name.as_str(), model));
    let drawing = PlanarDrawing::new(models, verb.source.source())?;
    let mut request = ArrangementRequest::default();
    request.rule = verb.cells.rule.map(super::Rule::inside);
    request.prune = verb.prune;
    request.snap = verb.cells.snap;
    request.max_cells = verb.cells.max_cells;
    let arranged = DrawingArrangement::new(drawing, &request)?;
    progress.stage("multiplying boundaries and checking coordinates");
    let object = arranged.to_json()?;
    progress.stage("writing");
    match output {
        Some((path, Target::Model(format))) => replace_file(path, |out| arranged.write(out, format))?,
        Some((path, Target::Seen(seen))) => write_seen(path, &arranged.to_mesh()?, seen)?,
        None => {}
    }
    if let Some(path) = &verb.provenance {
        write_json(path, &arranged.provenance_to_json())?;
    }
    drop(progress);
    if !common.quiet {
        arranged.warnings().iter().for_each(|warning| remark(warning));
    }
    if object["rounding"]["valid"] == json!(false) && !common.quiet {
        remark(
            "coordinates are rounded, and drawn with them this is another complex; --snap makes one that stays as it is",
        );
    }
    if common.json {
        return print_json(&object);
    }
    if common.output.is_some() || verb.provenance.is_some() {
        return Ok(());
    }
    print_text(&page(&arranged, &object))
}

fn page(arranged: &DrawingArrangement, object: &Value) -> String {
    let mut facts = Vec::new();
    let mut fact = |label: &str, value: String, gloss: &str| {
        facts.push((label.to_owned(), value, gloss.to_owned()));
    };
    let count = |key: &str| text::grouped(object[key].as_u64().unwrap_or(0) as usize);
    let arrangement = arranged.arrangement();
    let (vertices, edges, faces) =
        (arrangement.vertex_count(), arrangement.edge_count(), arrangement.face_count());
    fact("vertices", text::grouped(vertices), "");
    fact("edges", text::grouped(edges), "");
    fact("faces", text::grouped(faces), "bounded ones");
    fact("holes", count("holes"), "in bounded faces");
    fact("components", count("components"), "of vertices and edges");
    fact("Euler char.", object["euler_characteristic"].to_string(), "vertices - edges + bounded faces");
    fact("bridges", count("bridges"), "edges with one face on both sides");
    fact("dangling edges", count("dangling_edges"), "those of them that hang on the rest by one end");
    let areas = arranged.arrangement().areas();
    fact("area", text::number(areas.iter().sum()), "of all bounded faces");
    let is_zero = object["products_zero"] == json!(true);
    fact(
        "boundaries",
        if is_zero { "of boundaries are zero" } else { "of boundaries are NOT zero" }.to_owned(),
        "found by multiplying the matrices",
    );
    let rounding = &object["rounding"];
    let value = match (rounding["exact"] == json!(true), rounding["valid"] == json!(true)) {
        (true, _) => "none",
        (_, true) => "harmless",
        _ => "changes the complex",
    };
    fact("rounding", value.to_owned(), "of the coordinates of crossings");
    let title = match arranged.drawing().names() {
        [one] => format!("arrangement of {one}"),
        many => format!("arrangement of {} drawings", many.len()),
    };
    text::facts(&title, &facts)
}
