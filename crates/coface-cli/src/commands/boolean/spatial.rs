//! `coface boolean` in space.

use super::{Boolean, Task};
use crate::arguments::Common;
use crate::commands::arrange::{Rule, in_space, named, rounding, say_remarks};
use crate::failure::Failure;
use crate::output::{print_json, print_text, remark, write_json};
use crate::progress::Progress;
use crate::target::{Target, write_seen};
use clap::{Args, ValueEnum};
use coface::answers::text;
use coface::answers::{OpenInputs, SceneArrangement, SolidBoolean, SolidRequest, SpatialScene};
use coface::io;
use coface::io::{Format, Model};
use serde_json::{Value, json};
use std::path::Path;

/// Options of solids.
#[derive(Args)]
#[command(next_help_heading = "In space")]
pub(super) struct SolidOptions {
    /// What becomes of surfaces that are open: refused with their rim, or cells are inside by generalized winding numbers, in
    /// floating point
    #[arg(long, value_name = "WHAT", default_value = "refuse")]
    open: Open,
    /// What becomes of vertices and edges where the result is pinched: told, or split so that what touches comes apart
    #[arg(long, value_name = "WHAT", default_value = "tell")]
    pinches: Pinches,
}

#[derive(Clone, Copy, ValueEnum)]
enum Open {
    Refuse,
    /// Generalized winding numbers
    Winding,
}

#[derive(Clone, Copy, ValueEnum)]
enum Pinches {
    Tell,
    Split,
}

pub(super) fn run(
    verb: &Boolean,
    task: &Task,
    common: &Common,
    output: Option<(&Path, Target)>,
    models: &[(String, Model)],
    progress: Progress,
) -> Result<(), Failure> {
    let output = output.map(in_space).transpose()?;
    if verb.has_features() {
        return Err(Failure::new(
            "--inputs features is for regions in the plane; in space each file is an input",
        ));
    }
    progress.stage("arranging");
    let scene = SpatialScene::of(named(models), verb.keep_walls)?;
    let triangles = verb.space.triangles(&scene, output);
    let arrangement = SceneArrangement::of_scene(scene, &verb.space.request(&verb.cells))?;
    progress.stage("combining");
    let mut request = SolidRequest::of(task.formula(models.len()));
    request.rule = verb.cells.rule.map(Rule::inside).unwrap_or_default();
    request.open = match verb.solids.open {
        Open::Refuse => OpenInputs::Refuse,
        Open::Winding => OpenInputs::Generalized,
    };
    request.triangles = triangles;
    request.split_pinches = matches!(verb.solids.pinches, Pinches::Split);
    request.keep_walls = verb.keep_walls;
    let result = SolidBoolean::of(&arrangement, &request)?;
    let object = result.to_json()?;
    progress.stage("writing");
    match output {
        Some((path, Target::Model(format))) => {
            let model = if format == Format::Json { result.to_chains()? } else { result.to_mesh()? };
            io::write_path(&model, path, Some(format))?;
        }
        Some((path, Target::Seen(seen))) => write_seen(path, &result.to_mesh()?, seen)?,
        None => {}
    }
    if let Some(path) = &verb.provenance {
        write_json(path, &result.provenance()?)?;
    }
    drop(progress);
    if !common.quiet {
        say_remarks(&object);
        for file in object["files"].as_array().into_iter().flatten() {
            if file["inside_by"] == json!("generalized_winding") {
                let name = file["file"].as_str().unwrap_or_default();
                remark(&format!("{name} is open: what is inside of it was decided in floating point"));
            }
        }
        if output.is_some()
            && result.faces_cut() > 0
            && output.is_some_and(|(_, target)| target != Target::Model(Format::Json))
        {
            let count = text::count(result.faces_cut(), "face");
            remark(&format!("{count} with holes or slits, which the format has not, written as triangles"));
        }
    }
    if common.json {
        return print_json(&object);
    }
    if common.output.is_some() || verb.provenance.is_some() {
        return Ok(());
    }
    print_text(&page(&result, &object))
}

fn page(result: &SolidBoolean<'_>, object: &Value) -> String {
    let mut facts = Vec::new();
    let mut fact = |label: &str, value: String, gloss: &str| {
        facts.push((label.to_owned(), value, gloss.to_owned()));
    };
    let number = |value: &Value| value.as_u64().unwrap_or(0) as usize;
    match result.volume() {
        Some(volume) => fact("volume", text::number(volume), ""),
        None => fact("volume", "infinite".to_owned(), "the exterior is in the result"),
    }
    let [solids, voids] = result.part_counts();
    fact("solids", text::grouped(solids), "parts that are connected through faces");
    fact("voids", text::grouped(voids), "");
    let [vertices, edges, faces] = result.f_vector();
    let sort = if object["triangles"] == json!(true) { "triangles" } else { "polygons, holes included" };
    fact("vertices", text::grouped(vertices), "");
    fact("edges", text::grouped(edges), "");
    fact("faces", text::grouped(faces), sort);
    fact("components", text::grouped(number(&object["components"])), "of the surface");
    fact("area", text::number(object["area"].as_f64().unwrap_or(0.0)), "");
    let pinches = &object["pinches"];
    let (at_edges, at_vertices) = (number(&pinches["edge_count"]), number(&pinches["vertex_count"]));
    let is_manifold = object["manifold"]["verdict"] == json!("yes");
    let gloss = match (at_edges + at_vertices, object["manifold"]["witness"]["message"].as_str()) {
        (0, _) => String::new(),
        (_, None) => {
            format!("split at {} and {}", text::count(at_edges, "edge"), text::count(at_vertices, "vertex"))
        }
        (_, Some(witness)) => format!(
            "pinched at {} and {}, so: {witness}; --pinches split makes copies",
            text::count(at_edges, "edge"),
            text::count(at_vertices, "vertex")
        ),
    };
    fact("manifold", if is_manifold { "yes" } else { "no" }.to_owned(), &gloss);
    facts.push(rounding(object));
    text::facts("Boolean combination of solids", &facts)
}
