//! `coface arrange` in space.

use super::{Arrange, CellOptions, Inputs, Method, Rule};
use crate::arguments::Common;
use crate::certified;
use crate::failure::Failure;
use crate::output::{print_json, print_text, write_json};
use crate::progress::Progress;
use crate::remarks::{accept, say_remarks};
use crate::target::{Seen, Target, write_seen};
use clap::{Args, ValueEnum};
use coface::Error;
use coface::answers::answer::{
    CellGraph, CongruentPieces, Remark, RemarkCode, SpatialArrangementAnswer, SpatialRounding,
};
use coface::answers::text;
use coface::answers::{
    CongruentScene, SceneArrangement, SpatialRequest, SpatialScene, remarks_of_single_precision,
};
use coface::arrange::CoordinatePrecision;
use coface::arrange::spatial::NonPlanar;
use coface::io;
use coface::io::{Format, Model};
use std::path::Path;

/// So many inputs are on the page.
const MOST_FILES: usize = 20;

/// Options of polygons in space.
#[derive(Args)]
#[command(next_help_heading = "In space")]
pub(crate) struct SpaceOptions {
    /// What becomes of polygons whose points are not exactly in one plane [default: split; with --strict: rounded]
    #[arg(long, value_name = "WHAT")]
    non_planar: Option<Bent>,
    /// Merge faces in exactly one plane that are of the same inputs, be they of different polygons
    #[arg(long)]
    merge_coplanar: bool,
    /// Cut faces into triangles
    #[arg(long, visible_alias = "triangulate", conflicts_with = "polygons")]
    triangles: bool,
    /// Keep faces polygons; those with holes are cut where the format has none [default, but for STL and where all inputs are triangles]
    #[arg(long)]
    polygons: bool,
}

/// What becomes of polygons that are not planar.
#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Bent {
    /// Refused, with the deviation
    Refuse,
    /// Split if the deviation is 16 units in the last place of the largest coordinate or less, refused otherwise
    Rounded,
    /// Split into triangles: quadrangles along the shorter diagonal
    Split,
}

impl SpaceOptions {
    pub(crate) fn request(
        &self,
        cells: &CellOptions,
        common: &Common,
        output: Option<(&Path, Target)>,
    ) -> SpatialRequest {
        let mut request = SpatialRequest::default();
        request.non_planar = match self.non_planar {
            Some(Bent::Refuse) => NonPlanar::Refuse,
            Some(Bent::Rounded) => NonPlanar::Rounded,
            None if common.strict => NonPlanar::Rounded,
            Some(Bent::Split) | None => NonPlanar::Split,
        };
        request.merge_coplanar = self.merge_coplanar;
        request.snap = cells.snap;
        request.tolerance = cells.tolerance;
        request.max_cells = cells.max_cells;
        if is_stl(output) {
            request.precision = CoordinatePrecision::Single;
        }
        request
    }

    /// Whether faces are cut into triangles.
    pub(crate) fn triangles(&self, scene: &SpatialScene, output: Option<(&Path, Target)>) -> bool {
        self.triangles || (!self.polygons && (holds_triangles(output) || scene.is_triangulated()))
    }
}

/// Whether the result goes to an STL file, which holds triangles whose coordinates have 32 bits.
pub(crate) fn is_stl(output: Option<(&Path, Target)>) -> bool {
    output.is_some_and(|(_, target)| target == Target::Model(Format::Stl))
}

/// Whether the result goes to a file that holds no other polygons than triangles.
fn holds_triangles(output: Option<(&Path, Target)>) -> bool {
    let format = output.and_then(|(_, target)| target.format());
    matches!(format, Some(Format::Stl | Format::ThreeMf | Format::Amf))
}

/// The number of polygons that the format of the output has no elements for: it holds triangles and quadrangles. None where
/// polygons are asked for.
pub(crate) fn larger_polygons(
    space: &SpaceOptions,
    output: Option<(&Path, Target)>,
    mesh: impl FnOnce() -> Result<Model, Error>,
) -> Result<usize, Error> {
    let holds_few = matches!(output, Some((_, Target::Model(Format::Msh | Format::Medit))));
    if !holds_few || space.polygons || space.triangles {
        return Ok(0);
    }
    Ok(mesh()?.polygons().iter().filter(|polygon| polygon.len() > 4).count())
}

/// That faces are written as triangles, since the format has no such polygons.
pub(crate) fn written_as_triangles(count: usize, output: Option<(&Path, Target)>) -> Option<Remark> {
    let format = output.and_then(|(_, target)| target.format()).filter(|_| count > 0)?;
    let polygons = text::count(count, "polygon");
    let message = format!(
        "{polygons} of more than four vertices, which {} has not: all faces are written as triangles",
        format.title()
    );
    Some(Remark::new(RemarkCode::FacesTriangulated, message).at(count, []))
}

/// The models with their names as borrowed pairs.
fn named(models: &[(String, Model)]) -> impl Iterator<Item = (&str, &Model)> {
    models.iter().map(|(name, model)| (name.as_str(), model))
}

/// Refuses a file of a graph that is not named as one of its formats.
pub(super) fn check_graph(path: &Path) -> Result<(), Failure> {
    let is_graphml = path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("graphml"));
    if is_graphml || crate::output::is_json(path) {
        return Ok(());
    }
    Err(Failure::new(format!(
        "{}: a graph is written as JSON or GraphML: name a .json or .graphml file",
        path.display()
    )))
}

/// The polygons of the models; without `--inputs` objects are inputs if a formula needs more inputs than there are
/// files.
pub(crate) fn scene_of(
    inputs: Option<Inputs>,
    count: usize,
    models: &[(String, Model)],
    walls: bool,
) -> Result<SpatialScene, Failure> {
    Ok(match inputs {
        Some(inputs) => SpatialScene::with_inputs(named(models), inputs.source(), walls)?,
        None => SpatialScene::of_at_least(count, named(models), walls)?,
    })
}

/// Refuses formats of drawings in the plane; SVG is a picture of what is in space.
pub(crate) fn in_space((path, target): (&Path, Target)) -> Result<(&Path, Target), Failure> {
    let Some(format) = target.format() else { return Ok((path, target)) };
    match format {
        Format::Svg => Ok((path, Target::Seen(Seen::Svg))),
        Format::Off
        | Format::Obj
        | Format::Ply
        | Format::Stl
        | Format::Medit
        | Format::Msh
        | Format::Vtk
        | Format::VtkGrid
        | Format::VtkPolygons
        | Format::ThreeMf
        | Format::Amf
        | Format::Json => Ok((path, target)),
        _ => Err(Failure::new(format!(
            "{}: that format holds no polygons in space; write .vtk, .vtu, .vtp, .ply, .obj, .off, .stl, .3mf, .amf, .mesh, .msh or .json, or .glb, .gltf, .png or .svg to look at",
            path.display()
        ))),
    }
}

pub(super) fn run(
    verb: &Arrange,
    common: &Common,
    output: Option<(&Path, Target)>,
    models: &[(String, Model)],
    progress: Progress,
) -> Result<(), Failure> {
    if verb.prune {
        return Err(Failure::new(
            "--prune is for drawings in the plane; faces in space with one cell on both sides are kept: leave it out",
        ));
    }
    let output = output.map(in_space).transpose()?;
    progress.stage("arranging");
    let scene = scene_of(verb.source, 1, models, true)?;
    let mut request = verb.space.request(&verb.cells, common, output);
    let triangles = verb.space.triangles(&scene, output);
    let mut gluing = None;
    let scene = match verb.cells.method {
        Some(Method::Congruence) => {
            refuse_certificate(&verb.cells)?;
            let glued = CongruentScene::with_bent(scene, verb.cells.tolerance, request.non_planar)?;
            glued.refuse_more_cells(verb.cells.max_cells)?;
            if !asks_for_exact_cells(&verb.cells, &verb.space) {
                return by_congruence(verb, common, output, &glued, progress);
            }
            gluing = Some(glued.gluing()?);
            (request.tolerance, request.non_planar) = (None, NonPlanar::Split);
            glued.glued_scene()
        }
        _ => scene,
    };
    let mut arrangement = SceneArrangement::of_scene(scene, &request)?;
    // Numbers of 32 bits hold nothing exact.
    if (!verb.cells.exact || is_stl(output)) && !arrangement.is_valid()? {
        progress.stage("rounding");
        arrangement = arrangement.validly_rounded()?.unwrap_or(arrangement);
    }
    progress.stage("multiplying boundaries");
    let rule = verb.cells.rule.map(Rule::inside).unwrap_or_default();
    let triangulated = larger_polygons(&verb.space, output, || arrangement.to_mesh(triangles, false))?;
    let triangles = triangles || triangulated > 0;
    let mut answer = arrangement.answer(rule)?;
    answer.remarks.extend(written_as_triangles(triangulated, output));
    if let Some((done, joined)) = gluing {
        answer.congruence = Some(done);
        answer.joined = answer.joined.or(Some(joined));
    }
    accept(&answer.remarks, common)?;
    progress.stage("writing");
    if let Some((path, target)) = output {
        answer.remarks.extend(target.format().and_then(|format| arrangement.scene().name_loss(format)));
        match target {
            Target::Model(Format::Json) => {
                let mut model = arrangement.to_chains(verb.space.triangles)?;
                if verb.cells.exact {
                    model = model.with_exact_polygons(arrangement.exact_polygons().into());
                }
                answer.remarks.extend(model.remarks().iter().cloned());
                io::write_path(&model, path, Some(Format::Json))?;
            }
            Target::Model(format) => {
                let has_groups = matches!(format, Format::Obj | Format::Msh | Format::Medit);
                io::write_path(&arrangement.to_mesh(triangles, has_groups)?, path, Some(format))?;
            }
            Target::Seen(seen) => write_seen(path, &arrangement.to_mesh(triangles, false)?, seen)?,
        }
    }
    if let Some(path) = &verb.provenance {
        write_json(path, &arrangement.provenance())?;
    }
    if let Some(place) = &verb.cells.certificate {
        progress.stage(format!("proving {}", place.display()));
        certified::save(place, &verb.inputs, |inputs| arrangement.certificate(rule, inputs))?;
    }
    if let Some(path) = &verb.graph {
        write_graph(path, &arrangement.graph(rule)?)?;
    }
    drop(progress);
    say_remarks(&answer.remarks, common);
    if common.json {
        return print_json(&answer);
    }
    if common.output.is_some() || verb.provenance.is_some() || verb.graph.is_some() {
        return Ok(());
    }
    print_text(&page(&answer))
}

/// A certificate is of what files contain, not of what was put together.
pub(crate) fn refuse_certificate(cells: &CellOptions) -> Result<(), Failure> {
    match cells.certificate {
        None => Ok(()),
        Some(_) => Err(Failure::new(
            "--certificate is of cells as they are, and --method congruence puts vertices together: leave one of them out",
        )),
    }
}

/// Whether what is asked for are exact cells: then what congruence glued is arranged exactly, on the points where it is.
pub(crate) fn asks_for_exact_cells(cells: &CellOptions, space: &SpaceOptions) -> bool {
    cells.snap || cells.exact || space.merge_coplanar
}

/// The arrangement by congruence.
fn by_congruence(
    verb: &Arrange,
    common: &Common,
    output: Option<(&Path, Target)>,
    arrangement: &CongruentScene,
    progress: Progress,
) -> Result<(), Failure> {
    let triangles = verb.space.triangles(arrangement.scene(), output);
    let triangulated = larger_polygons(&verb.space, output, || arrangement.to_mesh(triangles, false))?;
    let triangles = triangles || triangulated > 0;
    progress.stage("multiplying boundaries");
    let mut answer = arrangement.answer(verb.cells.rule.map(Rule::inside).unwrap_or_default())?;
    answer.remarks.extend(written_as_triangles(triangulated, output));
    accept(&answer.remarks, common)?;
    progress.stage("writing");
    let format = output.and_then(|(_, target)| target.format());
    answer.remarks.extend(format.and_then(|format| arrangement.scene().name_loss(format)));
    match output {
        Some((path, Target::Model(Format::Json))) => {
            let model = arrangement.to_chains()?;
            answer.remarks.extend(model.remarks().iter().cloned());
            io::write_path(&model, path, Some(Format::Json))?;
        }
        Some((path, Target::Model(format))) => {
            let has_groups = matches!(format, Format::Obj | Format::Msh | Format::Medit);
            let mesh = arrangement.to_mesh(triangles, has_groups)?;
            if format == Format::Stl {
                answer.remarks.extend(remarks_of_single_precision(&mesh)?);
            }
            io::write_path(&mesh, path, Some(format))?;
        }
        Some((path, Target::Seen(seen))) => write_seen(path, &arrangement.to_mesh(triangles, false)?, seen)?,
        None => {}
    }
    if let Some(path) = &verb.provenance {
        write_json(path, &arrangement.provenance())?;
    }
    if let Some(path) = &verb.graph {
        write_graph(path, &arrangement.graph(verb.cells.rule.map(Rule::inside).unwrap_or_default())?)?;
    }
    drop(progress);
    say_remarks(&answer.remarks, common);
    if common.json {
        return print_json(&answer);
    }
    if common.output.is_some() || verb.provenance.is_some() || verb.graph.is_some() {
        return Ok(());
    }
    print_text(&page(&answer))
}

fn write_graph(path: &Path, graph: &CellGraph) -> Result<(), Failure> {
    if crate::output::is_json(path) {
        write_json(path, graph)
    } else {
        Ok(io::replace_file(path, |out| Ok(out.write_all(graph.to_graphml().as_bytes())?))?)
    }
}

/// The fact about what congruence stacked and glued.
pub(crate) fn stacked(done: &CongruentPieces) -> (String, String, String) {
    let counts: Vec<String> = done.stacked_f_vector.iter().map(|&count| text::grouped(count)).collect();
    let what = match counts.len() {
        3 => "vertices, edges and faces of all polygons",
        _ => "vertices and edges of all segments",
    };
    let gloss = format!(
        "{what}, put together within {:e}; what became one was at most {:.1e} apart",
        done.tolerance, done.largest_class_diameter
    );
    ("stacked".to_owned(), counts.join(", "), gloss)
}

/// The fact about rounding that results in space have in common.
pub(crate) fn rounding(rounding: &SpatialRounding) -> (String, String, String) {
    let (value, gloss) = match rounding.rounded_vertices {
        0 => ("none".to_owned(), "of coordinates"),
        count => (text::count(count, "vertex"), "of coordinates; --snap makes them exact"),
    };
    ("rounding".to_owned(), value, gloss.to_owned())
}

fn page(answer: &SpatialArrangementAnswer) -> String {
    let mut facts = Vec::new();
    let mut fact = |label: &str, value: String, gloss: &str| {
        facts.push((label.to_owned(), value, gloss.to_owned()));
    };
    let names = [("vertices", ""), ("edges", ""), ("faces", ""), ("cells", "bounded ones")];
    for ((name, gloss), &count) in names.into_iter().zip(&answer.f_vector) {
        fact(name, text::grouped(count), gloss);
    }
    fact("holes", text::grouped(answer.holes), "of faces");
    fact("voids", text::grouped(answer.voids), "of cells");
    fact("components", text::grouped(answer.components), "of faces");
    fact("Euler char.", answer.euler_characteristic.to_string(), "vertices - edges + faces - bounded cells");
    fact(
        "dangling faces",
        text::grouped(answer.dangling_faces),
        "those with one cell, or the exterior, on both sides",
    );
    fact("volume", text::number(answer.measures.iter().sum()), "of all bounded cells");
    fact(
        "boundaries",
        if answer.products_zero { "of boundaries are zero" } else { "of boundaries are NOT zero" }.to_owned(),
        "found by multiplying the matrices",
    );
    match &answer.congruence {
        None => facts.push(rounding(&answer.rounding)),
        Some(done) => facts.push(stacked(done)),
    }
    let mut fact = |label: &str, value: String, gloss: &str| {
        facts.push((label.to_owned(), value, gloss.to_owned()));
    };
    let dropped = answer.degenerate_polygons.count;
    if dropped > 0 {
        fact("without area", text::count(dropped, "polygon"), "left out");
    }
    let split = &answer.split_polygons;
    if split.count > 0 {
        let gloss = format!("not planar by up to {:e}", split.largest_deviation);
        fact("split", text::count(split.count, "polygon"), &gloss);
    }
    for file in answer.files.iter().take(MOST_FILES) {
        let edges = text::count(file.rim_edges, "edge");
        let (value, gloss) = match (file.closed, file.coherent) {
            (true, true) => ("closed", String::new()),
            (true, false) => ("closed", format!("polygons disagree in direction across {edges}")),
            _ => ("open", format!("along {edges}: it contains no cell")),
        };
        let label = if file.name.is_some() { "input" } else { "file" };
        fact(label, format!("{}: {value}", file.label()), &gloss);
    }
    if answer.files.len() > MOST_FILES {
        let open = answer.files.iter().filter(|file| !file.closed).count();
        let value = format!("and {} more", text::grouped(answer.files.len() - MOST_FILES));
        fact("inputs", value, &format!("{} of all are open", text::grouped(open)));
    }
    let title = match &answer.files[..] {
        [one] => format!("arrangement of {}", one.label()),
        many if answer.regions.is_empty() => format!("arrangement of {} models", many.len()),
        many => format!("arrangement of {} inputs", many.len()),
    };
    text::facts(&title, &facts)
}
