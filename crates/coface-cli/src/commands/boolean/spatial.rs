//! `coface boolean` in space.

use super::{Boolean, Task};
use crate::arguments::Common;
use crate::certified;
use crate::commands::arrange::{
    Rule, asks_for_exact_cells, in_space, is_stl, larger_polygons, refuse_certificate, rounding, scene_of,
    stacked, written_as_triangles,
};
use crate::failure::Failure;
use crate::output::{print_json, print_text, write_json};
use crate::progress::Progress;
use crate::remarks::{accept, say_remarks};
use crate::target::{Target, write_seen};
use clap::{Args, ValueEnum};
use coface::Error;
use coface::answers::answer::{
    BoundaryVerdict, Remark, RemarkCode, SolidBooleanAnswer, SolidBooleanProvenance,
};
use coface::answers::text;
use coface::answers::{
    ArrangementMethod, CongruentBoolean, CongruentScene, SceneArrangement, SolidBoolean, SolidRequest,
    SpatialScene, remarks_of_single_precision,
};
use coface::arrange::spatial::NonPlanar;
use coface::io;
use coface::io::{Format, Model};
use std::path::{Path, PathBuf};

/// Options of solids.
#[derive(Args)]
#[command(next_help_heading = "In space")]
pub(super) struct SolidOptions {
    /// What becomes of surfaces that are open: refused with their rim, or their mouths closed with patches of least area
    #[arg(long, value_name = "WHAT", default_value = "refuse")]
    open: Open,
    /// What becomes of vertices and edges where the result is pinched: counted, or split so that what touches comes apart
    /// [default: split in files of meshes that keep no cells apart]
    #[arg(long, value_name = "WHAT")]
    pinches: Option<Pinches>,
    /// Keep faces in one plane apart that are parts of different polygons; by default they are put together where nothing separates them
    #[arg(long, conflicts_with = "merge_coplanar")]
    keep_coplanar: bool,
}

#[derive(Clone, Copy, ValueEnum)]
enum Open {
    Refuse,
    #[value(alias = "winding")]
    Close,
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
    inputs: &[PathBuf],
    models: &[(String, Model)],
    progress: Progress,
) -> Result<(), Failure> {
    let output = output.map(in_space).transpose()?;
    progress.stage("arranging");
    let mut scene = scene_of(verb.inputs, task.least_inputs(), models, verb.keep_walls)?;
    if matches!(verb.solids.open, Open::Close) {
        scene.close_mouths()?;
    }
    let mut spatial = verb.space.request(&verb.cells, common, output);
    let triangles = verb.space.triangles(&scene, output);
    let mut gluing = None;
    if verb.cells.method() == ArrangementMethod::Congruence {
        refuse_certificate(&verb.cells)?;
        let glued = CongruentScene::with_bent(scene, verb.cells.tolerance, spatial.non_planar)?;
        glued.refuse_more_cells(verb.cells.max_cells)?;
        let splits = match verb.solids.pinches {
            Some(pinches) => matches!(pinches, Pinches::Split),
            None => {
                is_mesh(output)
                    && !verb.keep_walls
                    && CongruentBoolean::of(&glued, &glued_request(verb, task, output, &glued))?.is_pinched()
            }
        };
        if !splits && !asks_for_exact_cells(&verb.cells, &verb.space) {
            return by_congruence(verb, task, common, output, &glued, progress);
        }
        gluing = Some(glued.gluing()?);
        (spatial.tolerance, spatial.non_planar) = (None, NonPlanar::Split);
        scene = glued.glued_scene();
    }
    let count = scene.names().len();
    // Whose faces are parts of the result alone.
    spatial.merge_coplanar |= !verb.solids.keep_coplanar;
    let mut request = SolidRequest::of(task.formula(count));
    request.rule = verb.cells.rule.map(Rule::inside).unwrap_or_default();
    request.triangles = triangles;
    request.split_pinches = match verb.solids.pinches {
        Some(pinches) => matches!(pinches, Pinches::Split),
        None => is_mesh(output) && !verb.keep_walls,
    };
    request.keep_walls = verb.keep_walls;
    // Numbers of 32 bits hold nothing exact.
    let is_exact = verb.cells.exact && !is_stl(output);
    request.merge_coplanar = spatial.merge_coplanar && !is_exact;
    // A certificate is of all cells.
    let arrangement = match verb.cells.certificate {
        Some(_) => SceneArrangement::of_scene(scene, &spatial)?,
        None => SceneArrangement::for_result(scene, &spatial, &request)?,
    };
    progress.stage("combining");
    let rounded;
    let mut combined = &arrangement;
    let mut result = SolidBoolean::of(combined, &request)?;
    if !is_exact && !result.is_valid()? {
        progress.stage("rounding");
        // A certificate is of all cells.
        let valid = match verb.cells.certificate {
            Some(_) => arrangement.validly_rounded()?,
            None => result.validly_rounded()?,
        };
        if let Some(valid) = valid {
            rounded = valid;
            combined = &rounded;
            result = SolidBoolean::of(combined, &request)?;
        }
    }
    let triangulated = larger_polygons(&verb.space, output, || result.to_mesh())?;
    if triangulated > 0 {
        request.triangles = true;
        result = SolidBoolean::of(combined, &request)?;
    }
    let mut answer = result.answer()?;
    answer.remarks.extend(written_as_triangles(triangulated, output));
    if let Some((done, joined)) = gluing {
        answer.congruence = Some(done);
        answer.joined = answer.joined.or(Some(joined));
    }
    answer.remarks.extend(name_loss(arrangement.scene(), output));
    let made = Made {
        chains: &|| {
            let model = result.to_chains()?;
            Ok(if verb.cells.exact {
                model.with_exact_polygons(result.exact_polygons()?.into())
            } else {
                model
            })
        },
        mesh: &|| result.to_mesh(),
        provenance: &|| result.provenance(),
        certificate: &|place| certified::save(place, inputs, |inputs| result.certificate(inputs)),
    };
    finish(verb, common, output, answer, &made, progress)
}

/// The combination of cells that are glued.
fn by_congruence(
    verb: &Boolean,
    task: &Task,
    common: &Common,
    output: Option<(&Path, Target)>,
    arrangement: &CongruentScene,
    progress: Progress,
) -> Result<(), Failure> {
    progress.stage("combining");
    let mut request = glued_request(verb, task, output, arrangement);
    let mut result = CongruentBoolean::of(arrangement, &request)?;
    let triangulated = larger_polygons(&verb.space, output, || result.to_mesh())?;
    if triangulated > 0 {
        request.triangles = true;
        result = CongruentBoolean::of(arrangement, &request)?;
    }
    let made = Made {
        chains: &|| result.to_chains(),
        mesh: &|| result.to_mesh(),
        provenance: &|| result.provenance(),
        // Refused before.
        certificate: &|_| Ok(()),
    };
    let mut answer = result.answer()?;
    answer.remarks.extend(written_as_triangles(triangulated, output));
    answer.remarks.extend(name_loss(arrangement.scene(), output));
    if is_stl(output) {
        answer.remarks.extend(remarks_of_single_precision(&result.to_mesh()?)?);
    }
    finish(verb, common, output, answer, &made, progress)
}

/// What is asked of glued cells.
fn glued_request(
    verb: &Boolean,
    task: &Task,
    output: Option<(&Path, Target)>,
    arrangement: &CongruentScene,
) -> SolidRequest {
    let mut request = SolidRequest::of(task.formula(arrangement.scene().names().len()));
    request.rule = verb.cells.rule.map(Rule::inside).unwrap_or_default();
    request.triangles = verb.space.triangles(arrangement.scene(), output);
    request.keep_walls = verb.keep_walls;
    request
}

/// Whether the result goes to a file of a mesh, which keeps no cells apart.
fn is_mesh(output: Option<(&Path, Target)>) -> bool {
    output.and_then(|(_, target)| target.format()).is_some_and(|format| format != Format::Json)
}

/// That the file which is written has no names of inputs.
fn name_loss(scene: &SpatialScene, output: Option<(&Path, Target)>) -> Option<Remark> {
    scene.name_loss(output?.1.format()?)
}

/// What is written of a result.
struct Made<'a> {
    chains: &'a dyn Fn() -> Result<Model, Error>,
    mesh: &'a dyn Fn() -> Result<Model, Error>,
    provenance: &'a dyn Fn() -> Result<SolidBooleanProvenance, Error>,
    certificate: &'a dyn Fn(&Path) -> Result<(), Failure>,
}

/// Writes a result and says what it is.
fn finish(
    verb: &Boolean,
    common: &Common,
    output: Option<(&Path, Target)>,
    mut answer: SolidBooleanAnswer,
    made: &Made<'_>,
    progress: Progress,
) -> Result<(), Failure> {
    accept(&answer.remarks, common)?;
    progress.stage("writing");
    match output {
        Some((path, Target::Model(format))) => {
            let model = if format == Format::Json { (made.chains)()? } else { (made.mesh)()? };
            answer.remarks.extend(model.remarks().iter().cloned());
            io::write_path(&model, path, Some(format))?;
        }
        Some((path, Target::Seen(seen))) => write_seen(path, &(made.mesh)()?, seen)?,
        None => {}
    }
    if let Some(path) = &verb.provenance {
        write_json(path, &(made.provenance)()?)?;
    }
    if let Some(place) = &verb.cells.certificate {
        progress.stage(format!("proving {}", place.display()));
        (made.certificate)(place)?;
    }
    drop(progress);
    if answer.faces_cut > 0 && output.is_some_and(|(_, target)| target != Target::Model(Format::Json)) {
        let faces = text::count(answer.faces_cut, "face");
        let message = format!("{faces} with holes or slits, which the format has not, written as triangles");
        answer.remarks.push(Remark::new(RemarkCode::FacesTriangulated, message).at(answer.faces_cut, []));
    }
    if answer.pinches.copies > 0 && verb.solids.pinches.is_none() {
        let at = pinched_at(&answer);
        let message = format!("pinched at {at}, which are written as copies; --pinches tell keeps them");
        answer.remarks.push(Remark::new(RemarkCode::ModelRepaired, message).at(answer.pinches.copies, []));
    }
    say_remarks(&answer.remarks, common);
    if common.json {
        return print_json(&answer);
    }
    if common.output.is_some() || verb.provenance.is_some() {
        return Ok(());
    }
    print_text(&page(&answer))
}

fn page(answer: &SolidBooleanAnswer) -> String {
    let mut facts = Vec::new();
    let mut fact = |label: &str, value: String, gloss: &str| {
        facts.push((label.to_owned(), value, gloss.to_owned()));
    };
    match answer.measure {
        Some(volume) => fact("volume", text::number(volume), ""),
        None => fact("volume", "infinite".to_owned(), "the exterior is in the result"),
    }
    fact("solids", text::grouped(answer.solids), "parts that are connected through faces");
    fact("voids", text::grouped(answer.voids), "");
    let [vertices, edges, faces] = answer.f_vector;
    let sort = if answer.triangles { "triangles" } else { "polygons, holes included" };
    fact("vertices", text::grouped(vertices), "");
    fact("edges", text::grouped(edges), "");
    fact("faces", text::grouped(faces), sort);
    fact("components", text::grouped(answer.components), "of the surface");
    fact("area", answer.area.map_or("too large".to_owned(), text::number), "");
    let at = pinched_at(answer);
    let gloss = match (answer.pinches.edge_count + answer.pinches.vertex_count, &answer.manifold.witness) {
        (0, _) => String::new(),
        (_, None) if answer.pinches.copies > 0 => format!("split at {at}"),
        // A vertex inside of a face, which the face as a polygon has not.
        (_, None) => format!("touches itself at {at}"),
        (_, Some(witness)) => {
            format!("pinched at {at}, so: {}; --pinches split makes copies", witness.message)
        }
    };
    let is_manifold = answer.manifold.verdict == BoundaryVerdict::Yes;
    fact("manifold", if is_manifold { "yes" } else { "no" }.to_owned(), &gloss);
    match &answer.congruence {
        None => facts.push(rounding(&answer.rounding)),
        Some(done) => facts.push(stacked(done)),
    }
    text::facts("Boolean combination of solids", &facts)
}

/// The edges and vertices where a result is pinched, by their numbers.
fn pinched_at(answer: &SolidBooleanAnswer) -> String {
    let edges = text::count(answer.pinches.edge_count, "edge");
    let vertices = text::count(answer.pinches.vertex_count, "vertex");
    match (answer.pinches.edge_count, answer.pinches.vertex_count) {
        (_, 0) => edges,
        (0, _) => vertices,
        _ => format!("{edges} and {vertices}"),
    }
}
