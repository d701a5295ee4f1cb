//! `coface boolean` in the plane.

use super::{Boolean, Task};
use crate::arguments::Common;
use crate::certified;
use crate::commands::arrange::{Rule, stacked};
use crate::failure::Failure;
use crate::output::{print_json, print_text, write_json};
use crate::progress::Progress;
use crate::remarks::{accept, say_remarks};
use crate::target::{Target, write_seen};
use coface::answers::answer::PlanarBooleanAnswer;
use coface::answers::text;
use coface::answers::{BooleanRequest, DrawingOptions, PlanarDrawing, RegionBoolean};
use coface::io::{Model, replace_file};
use std::path::{Path, PathBuf};

pub(super) fn run(
    verb: &Boolean,
    task: &Task,
    common: &Common,
    output: Option<(&Path, Target)>,
    inputs: &[PathBuf],
    models: &[(String, Model)],
    progress: Progress,
) -> Result<(), Failure> {
    let method = verb.cells.method();
    progress.stage("arranging");
    let models = models.iter().map(|(name, model)| (name.as_str(), model));
    let options = DrawingOptions::new().source(verb.region_source()).close_lines(verb.cells.close);
    let mut drawing = PlanarDrawing::with_options(models, &options)?;
    if verb.cells.dimension == Some(2) {
        drawing = drawing.without_heights();
    }
    let region_count = drawing.region_names().len();
    if region_count == 0 {
        return Err(Failure::new("there is no region in the inputs: give polygons or closed lines"));
    }
    let mut request = BooleanRequest::default();
    request.strict = common.strict;
    request.rule = verb.cells.rule.map(Rule::inside);
    request.keep_walls = verb.keep_walls;
    request.snap = verb.cells.snap;
    request.grid = verb.cells.grid;
    request.tolerance = verb.cells.tolerance;
    request.method = method;
    request.exact = verb.cells.exact;
    request.max_cells = verb.cells.max_cells;
    if !verb.dissolve.is_empty() {
        return super::dissolve::run(verb, &drawing, request, common, output, progress);
    }
    let result = RegionBoolean::new(drawing, &task.formula(region_count), &request)?;
    let mut answer = result.answer();
    accept(&answer.remarks, common)?;
    progress.stage("writing");
    match output {
        Some((path, Target::Model(format))) => {
            answer.remarks.extend(result.drawing().losses(format));
            replace_file(path, |out| result.write(out, format))?;
        }
        Some((path, Target::Seen(seen))) => write_seen(path, &result.to_mesh()?, seen)?,
        None => {}
    }
    if let Some(path) = &verb.provenance {
        write_json(path, &result.provenance())?;
    }
    if let Some(place) = &verb.cells.certificate {
        progress.stage(format!("proving {}", place.display()));
        certified::save(place, inputs, |inputs| result.certificate(inputs))?;
    }
    drop(progress);
    say_remarks(&answer.remarks, common);
    if common.json {
        return print_json(&answer);
    }
    if common.output.is_some() || verb.provenance.is_some() {
        return Ok(());
    }
    print_text(&page(&answer))
}

fn page(answer: &PlanarBooleanAnswer) -> String {
    let mut facts = Vec::new();
    let mut fact = |label: &str, value: String, gloss: &str| {
        facts.push((label.to_owned(), value, gloss.to_owned()));
    };
    let [vertices, edges, polygons] = answer.f_vector;
    fact("area", text::number(answer.measure), "");
    fact("polygons", text::grouped(polygons), "");
    fact("holes", text::grouped(answer.holes), "");
    fact(
        "components",
        text::grouped(answer.components),
        "parts that touch in points only are different ones",
    );
    fact("vertices", text::grouped(vertices), "");
    fact("edges", text::grouped(edges), "");
    let manifold = match answer.pinches {
        0 => "a curve everywhere".to_owned(),
        pinches => format!("pinched at {}", text::count(pinches, "vertex")),
    };
    fact("boundary", manifold, "");
    let value = match (answer.rounding.exact, answer.rounding.valid) {
        (true, _) => "none",
        (_, true) if answer.rounding.repair.rounds > 0 => "made valid",
        (_, true) => "harmless",
        _ => "breaks polygons",
    };
    fact("rounding", value.to_owned(), "of the coordinates of crossings");
    if let Some(done) = &answer.congruence {
        facts.push(stacked(done));
    }
    text::facts("Boolean combination of regions", &facts)
}
