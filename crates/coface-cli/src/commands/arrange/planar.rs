//! `coface arrange` in the plane.

use super::{Arrange, stacked};
use crate::arguments::Common;
use crate::certified;
use crate::failure::Failure;
use crate::output::{print_json, print_text, write_json};
use crate::progress::Progress;
use crate::remarks::{accept, say_remarks};
use crate::target::{Target, write_seen};
use coface::answers::answer::PlanarArrangementAnswer;
use coface::answers::text;
use coface::answers::{ArrangementRequest, DrawingArrangement, DrawingOptions, PlanarDrawing};
use coface::io;
use coface::io::{Format, Model, replace_file};
use std::path::Path;

pub(super) fn run(
    verb: &Arrange,
    common: &Common,
    output: Option<(&Path, Target)>,
    models: &[(String, Model)],
    progress: Progress,
) -> Result<(), Failure> {
    if verb.graph.is_some() {
        return Err(Failure::new(
            "--graph is for cells in space, and the inputs lie in the plane: leave it out",
        ));
    }
    let method = verb.cells.method();
    progress.stage("arranging");
    let models = models.iter().map(|(name, model)| (name.as_str(), model));
    let source = verb.source.map_or_else(Default::default, super::Inputs::source);
    let options = DrawingOptions::new().source(source).close_lines(verb.cells.close);
    let mut drawing = PlanarDrawing::with_options(models, &options)?;
    if verb.cells.dimension == Some(2) {
        drawing = drawing.without_heights();
    }
    let mut request = ArrangementRequest::default();
    request.strict = common.strict;
    request.rule = verb.cells.rule.map(super::Rule::inside);
    request.prune = verb.prune;
    request.snap = verb.cells.snap;
    request.grid = verb.cells.grid;
    request.tolerance = verb.cells.tolerance;
    request.method = method;
    request.exact = verb.cells.exact;
    request.max_cells = verb.cells.max_cells;
    let arranged = DrawingArrangement::new(drawing, &request)?;
    progress.stage("multiplying boundaries and checking coordinates");
    let mut answer = arranged.answer()?;
    let table = match verb.attributes.as_deref() {
        Some(path) => Some((path, arranged.attributes()?)),
        None => None,
    };
    if let Some((_, found)) = &table {
        answer.remarks.extend_from_slice(found.remarks());
        answer.attributes = Some(found.columns().to_vec());
    }
    accept(&answer.remarks, common)?;
    progress.stage("writing");
    if let Some((path, found)) = &table {
        replace_file(path, |out| io::write(found.model(), out, Format::GeoJson))?;
    }
    match output {
        Some((path, Target::Model(format))) => {
            answer.remarks.extend(arranged.drawing().losses(format));
            replace_file(path, |out| arranged.write(out, format))?;
        }
        Some((path, Target::Seen(seen))) => write_seen(path, &arranged.to_mesh()?, seen)?,
        None => {}
    }
    if let Some(path) = &verb.provenance {
        write_json(path, &arranged.provenance())?;
    }
    if let Some(place) = &verb.cells.certificate {
        progress.stage(format!("proving {}", place.display()));
        certified::save(place, &verb.inputs, |inputs| arranged.certificate(inputs))?;
    }
    drop(progress);
    say_remarks(&answer.remarks, common);
    if common.json {
        return print_json(&answer);
    }
    if common.output.is_some() || verb.provenance.is_some() || table.is_some() {
        return Ok(());
    }
    print_text(&page(&answer))
}

fn page(answer: &PlanarArrangementAnswer) -> String {
    let mut facts = Vec::new();
    let mut fact = |label: &str, value: String, gloss: &str| {
        facts.push((label.to_owned(), value, gloss.to_owned()));
    };
    let [vertices, edges, faces] = answer.f_vector;
    fact("vertices", text::grouped(vertices), "");
    fact("edges", text::grouped(edges), "");
    fact("faces", text::grouped(faces), "bounded ones");
    fact("holes", text::grouped(answer.holes), "in bounded faces");
    fact("components", text::grouped(answer.components), "of vertices and edges");
    fact("Euler char.", answer.euler_characteristic.to_string(), "vertices - edges + bounded faces");
    fact("bridges", text::grouped(answer.bridges), "edges with one face on both sides");
    fact(
        "dangling edges",
        text::grouped(answer.dangling_edges),
        "those of them that hang on the rest by one end",
    );
    fact("area", text::number(answer.measures.iter().sum()), "of all bounded faces");
    fact(
        "boundaries",
        if answer.products_zero { "of boundaries are zero" } else { "of boundaries are NOT zero" }.to_owned(),
        "found by multiplying the matrices",
    );
    let value = match (answer.rounding.exact, answer.rounding.valid) {
        (true, _) => "none",
        (_, true) if answer.rounding.repair.rounds > 0 => "made valid",
        (_, true) => "harmless",
        _ => "changes the complex",
    };
    fact("rounding", value.to_owned(), "of the coordinates of crossings");
    if let Some(done) = &answer.congruence {
        facts.push(stacked(done));
    }
    let title = match &answer.inputs[..] {
        [one] => format!("arrangement of {}", one.file),
        many => format!("arrangement of {} drawings", many.len()),
    };
    text::facts(&title, &facts)
}
