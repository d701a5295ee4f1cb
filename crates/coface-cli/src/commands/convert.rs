//! `coface convert`: from one format to another.

use super::view::read_result;
use crate::arguments::{Common, format_of_name};
use crate::commands::yin::lost_kinks;
use crate::failure::Failure;
use crate::input::{self, Loaded};
use crate::output::{print_bytes, print_json, write_json};
use crate::progress::Progress;
use crate::remarks::{self, say_remarks};
use crate::target::unknown_extension;
use clap::{Args, ValueEnum};
use coface::answers::answer::{
    CarriersAnswer, ConvertAnswer, MapAnswer, MeshRepairAnswer, Remark, RemarkCode,
};
use coface::answers::{
    MapResult, MapTask, PlanarSet, RepairMethod, RepairRequest, SetRequest, SurfaceRepairRequest,
    dual_graph_model, dual_model, gluing_model, halfedge_model, losses_of, polygon_model,
    polygons_of_fill_rules, repaired, repaired_surface, triangulated, truncated, welded,
};
use coface::complexes::surface::FacesAtEdge;
use coface::io;
use coface::io::{Format, GroupKind, Model, Structure, never_written};
use coface::pictures::{Coloring, GltfForm, Scene, colored, gltf, gltf_rounding, vertex_colors};
use std::path::{Path, PathBuf};

/// Convert a model to another format.
///
/// The file named by -o is written in the format of its extension, unless --to says another; without -o the model goes to
/// standard output in the format of --to. What the new format cannot hold is an error, never dropped in silence. Of a volume of voxels,
/// meshes and pictures get the squares between voxels that are set and the others, JSON and .cfc the chain complex, .npy the voxels.
/// GeoJSON written from GeoJSON or TopoJSON has the properties and the ids of all features as they stand. GeoJSON, WKT and WKB keep the
/// reference system (crs, SRID) and heights; .hex is WKB as hexadecimal digits.
#[derive(Args)]
pub(crate) struct Convert {
    /// The model; - is standard input
    #[arg(value_name = "INPUT")]
    input: PathBuf,
    /// The format to write: off, obj, ply, stl, mesh, msh, vtk, vtu, vtp, json, isosig, lines, geojson, wkt, wkb, hex, svg, dat, npy, cfc, glb, gltf
    #[arg(long, value_name = "FORMAT", value_parser = target_of_name)]
    to: Option<Target>,
    /// Color vertices by component, by boundary, or by the JSON of another verb such as homology --generators; for obj, ply, vtk, vtu, vtp,
    /// glb and gltf
    #[arg(long, value_name = "component|boundary|RESULT.json")]
    color_by: Option<PathBuf>,
    /// Make a gluing table, or halfedge permutations, a facet list: the first barycentric subdivision, or the second where that is needed
    #[arg(long, visible_alias = "triangles")]
    triangulate: bool,
    /// Cut the ideal vertices of a triangulation of a 3-manifold off: the gluing table of the manifold with boundary that is left
    #[arg(long)]
    truncate: bool,
    /// With --triangulate: for each new vertex the cell [degree, number] of the table that it lies in, as JSON
    #[arg(long, value_name = "FILE", requires = "triangulate")]
    labels: Option<PathBuf>,
    /// Make an oriented surface the permutations next and twin of its halfedges, with outer faces along its boundary; a name that ends in
    /// .halfedges.json does so too
    #[arg(long, conflicts_with = "triangulate")]
    halfedges: bool,
    /// Make a surface its dual: a vertex in each face, a face around each vertex
    #[arg(long, conflicts_with_all = ["triangulate", "dual_graph"])]
    dual: bool,
    /// Make a surface its dual graph: a vertex in each face, a line across each edge
    #[arg(long, conflicts_with_all = ["triangulate", "halfedges"])]
    dual_graph: bool,
    /// Give each fan of faces its own copy of a vertex where several fans meet
    #[arg(long)]
    split_vertices: bool,
    /// Split edges in three or more faces: apart (each face gets the edge for itself) or pairs (coherent pairs stay together)
    #[arg(long, value_name = "HOW")]
    split_edges: Option<Together>,
    /// Turn faces so that all agree; closed parts in space look outwards then, and voids inwards if they look against their shell
    #[arg(long)]
    orient: bool,
    /// Make a surface: merge equal vertices, leave out collapsed and repeated polygons and what is in no face, split, turn; `closed` also
    /// fills the holes. Of a drawing: make its polygons valid, by `structure` (outer rings minus holes; without a goal) or by `linework`
    #[arg(long, value_name = "GOAL", num_args = 0..=1, default_missing_value = "surface",
          conflicts_with_all = ["split_vertices", "split_edges", "orient"])]
    repair: Option<RepairGoal>,
    /// Merge vertices within this distance of each other, in the unit of the file, before any repair; none moves farther
    #[arg(long, value_name = "LENGTH", allow_negative_numbers = true, value_parser = weld_length)]
    weld: Option<f64>,
}

/// What a repair ends in.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum RepairGoal {
    Surface,
    Closed,
    Structure,
    Linework,
}

fn weld_length(text: &str) -> Result<f64, String> {
    text.parse()
        .ok()
        .filter(|length: &f64| length.is_finite() && *length >= 0.0)
        .ok_or_else(|| "give a finite length from 0".to_owned())
}

/// What is written.
#[derive(Clone, Copy)]
enum Target {
    /// The model in a format that holds it.
    Model(Format),
    /// What is seen of it.
    Scene(GltfForm),
}

impl Target {
    fn name(self) -> &'static str {
        match self {
            Self::Model(format) => format.name(),
            Self::Scene(GltfForm::Binary) => "glb",
            Self::Scene(GltfForm::Json) => "gltf",
        }
    }
}

fn target_of_name(name: &str) -> Result<Target, String> {
    match name.trim_start_matches('.').to_ascii_lowercase().as_str() {
        "glb" => Ok(Target::Scene(GltfForm::Binary)),
        "gltf" => Ok(Target::Scene(GltfForm::Json)),
        _ => format_of_name(name).map(Target::Model),
    }
}

fn target_of_path(path: &Path) -> Option<Target> {
    let extension = path.extension()?.to_str()?;
    match extension.to_ascii_lowercase().as_str() {
        "glb" | "gltf" => target_of_name(extension).ok(),
        _ => Format::from_path(path).map(Target::Model),
    }
}

/// The faces that stay together at an edge that is split.
#[derive(Clone, Copy, ValueEnum)]
enum Together {
    Apart,
    Pairs,
}

impl Convert {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        let target = common.output.as_deref();
        let Some(format) = self.to.or_else(|| target.and_then(target_of_path)) else {
            return Err(match target {
                Some(path) => unknown_extension(path, ", glb, gltf; or say it with --to"),
                None => Failure::new("no format to write: give -o OUT, or --to FORMAT for standard output"),
            });
        };
        // Sets of the plane are written as .dat; nothing else is.
        if let Target::Model(other) = format
            && other != Format::Dat
            && let Some(error) = never_written(other)
        {
            return Err(match target {
                Some(path) => error.in_file(path.display().to_string()).into(),
                None => error.into(),
            });
        }
        if target.is_none() && common.json {
            return Err(Failure::new("standard output cannot hold both the model and --json; give -o OUT"));
        }
        let progress = Progress::start(common.quiet);
        if let Target::Model(format) = format
            && let Some(set) = self.planar_set(format, common, &progress)?
        {
            return self.write_set(&set, format, common, progress);
        }
        let mut loaded = input::read(&self.input, common.reading(), &progress)?;
        let unread = io::unread_remark(&loaded.model);
        if self.truncate {
            progress.stage("cutting ideal vertices off");
            loaded.model = truncated(&loaded.model).map_err(|error| error.in_file(loaded.name.clone()))?;
        }
        if self.triangulate {
            progress.stage("subdividing");
            let (model, carriers) =
                triangulated(&loaded.model).map_err(|error| error.in_file(loaded.name.clone()))?;
            loaded.model = model;
            if let Some(place) = &self.labels {
                let carriers = carriers.iter().map(|&(degree, cell)| (degree, cell.index())).collect();
                write_json(place, &CarriersAnswer::new(carriers))?;
            }
        }
        let mut reshaped = self.reshape(&mut loaded, format, target, &progress)?;
        if !matches!(format, Target::Model(Format::Npy | Format::Json | Format::Container))
            && matches!(loaded.model.structure(), Some(Structure::Volume(_)))
        {
            progress.stage("finding the boundary");
            let in_file = |error: coface::Error| error.in_file(loaded.name.clone());
            let placed = loaded.model.voxel_remark();
            let (positions, squares) = loaded.model.voxel_surface().map_err(in_file)?.unwrap_or_default();
            reshaped.extend(placed);
            loaded.model = Model::from_polygons(positions, squares).map_err(in_file)?;
        }
        let valid = self.valid_map(&mut loaded, &progress)?;
        // These have no rule for what is inside of rings.
        if let Target::Model(Format::Wkt | Format::Wkb | Format::WkbHex | Format::GeoJson) = format {
            let in_file = |error: coface::Error| error.in_file(loaded.name.clone());
            if let Some((model, remark)) = polygons_of_fill_rules(&loaded.model).map_err(in_file)? {
                loaded.model = model;
                reshaped.push(remark);
            }
        }
        if let Some(radius) = self.weld.filter(|_| self.repair.is_none()) {
            progress.stage("merging vertices");
            let (model, done) =
                welded(&loaded.model, radius).map_err(|error| error.in_file(loaded.name.clone()))?;
            loaded.model = model;
            reshaped.extend(done.remark());
        }
        let repair = if valid.is_some() { None } else { self.repaired(&mut loaded, &progress)? };
        let (model, scene) = self.colored(loaded.model, &loaded.name, format)?;
        progress.stage("writing");
        let write = |out: &mut dyn std::io::Write| match (format, &scene) {
            (Target::Scene(form), Some((scene, colors))) => {
                Ok(out.write_all(&gltf(scene, colors.as_deref(), form)?)?)
            }
            (Target::Model(format), _) => io::write(&model, out, format),
            (Target::Scene(_), None) => unreachable!("a scene is made for what shows one"),
        };
        reshaped.extend(match format {
            Target::Model(format) => losses_of(&model, format),
            Target::Scene(_) => scene.as_ref().map_or_else(Vec::new, |(scene, _)| {
                scene.remarks().into_iter().chain(gltf_rounding(scene)).collect()
            }),
        });
        let losses: Vec<Remark> = unread
            .into_iter()
            .chain(reshaped)
            .chain(valid.iter().flat_map(|valid| valid.remarks.iter().cloned()))
            .collect();
        let Some(path) = target else {
            // Made in memory first: a model that the format cannot hold leaves nothing on standard output.
            let mut bytes = Vec::new();
            write(&mut bytes)?;
            drop(progress);
            say_remarks(repair.as_ref().map(remark_of_repair).as_slice(), common);
            say_remarks(&losses, common);
            return print_bytes(|out| out.write_all(&bytes));
        };
        io::replace_file(path, |out| write(out))?;
        drop(progress);
        say_remarks(&losses, common);
        let repaired = repair.as_ref().map(remark_of_repair);
        if common.json {
            let output = path.display().to_string();
            let mut answer =
                ConvertAnswer::of_model(&loaded.name, loaded.format.name(), &output, format.name(), &model)
                    .with_repair(repair)
                    .with_map_repair(valid.and_then(|valid| valid.repair));
            answer.remarks = losses.into_iter().chain(repaired).collect();
            return print_json(&answer);
        }
        say_remarks(repaired.as_slice(), common);
        Ok(())
    }

    /// The model with colors on its vertices where they are asked for; and what is seen of it, with its own colors, where that is written.
    #[expect(clippy::type_complexity, reason = "a scene with its colors is used once")]
    fn colored(
        &self,
        model: Model,
        name: &str,
        target: Target,
    ) -> Result<(Model, Option<(Scene, Option<Vec<[u8; 3]>>)>), Failure> {
        let is_scene = matches!(target, Target::Scene(_));
        if self.color_by.is_none() && !is_scene {
            return Ok((model, None));
        }
        if is_scene && model.is_empty() {
            return Err(Failure::new(format!("{name}: there is nothing in it that a scene could show")));
        }
        let title = Path::new(name).file_name().map_or(name.into(), |name| name.to_string_lossy());
        if self.color_by.is_some() {
            // Components and boundaries are those of what is drawn, which would not be all.
            model.require_finite().map_err(|error| error.in_file(name.to_owned()))?;
        }
        let mut scene = Scene::of(&title, &model).map_err(|error| error.in_file(name.to_owned()))?;
        let Some(how) = &self.color_by else { return Ok((model, Some((scene, None)))) };
        let coloring = match how.to_str() {
            Some("component") => Coloring::Components,
            Some("boundary") => Coloring::Boundary,
            _ => {
                scene.add_result(&input::name(how), &read_result(how)?)?;
                Coloring::Layers
            }
        };
        if is_scene {
            // Layers are there themselves.
            let colors = (coloring != Coloring::Layers).then(|| vertex_colors(&scene, coloring));
            return Ok((model, Some((scene, colors))));
        }
        if let Target::Model(format) = target
            && !(format.keeps_data() || matches!(format, Format::Obj | Format::ThreeMf | Format::Amf))
        {
            return Err(Failure::new(format!(
                "a file of {} holds no colors; write obj, ply, vtk, vtu, vtp, 3mf, amf, glb or gltf",
                format.title()
            )));
        }
        let colors = vertex_colors(&scene, coloring);
        Ok((colored(model, &colors).map_err(|error| error.in_file(name.to_owned()))?, None))
    }

    /// The input as a set of the plane, if it is one and the format can hold its curves, or can hold nothing else.
    fn planar_set(
        &self,
        format: Format,
        common: &Common,
        progress: &Progress,
    ) -> Result<Option<PlanarSet>, Failure> {
        let keeps_curves = matches!(format, Format::Json | Format::Dat | Format::Svg);
        let is_plain = self.color_by.is_none()
            && !self.triangulate
            && !self.truncate
            && self.request().is_none()
            && self.repair.is_none()
            && self.weld.is_none()
            && common.flatten.is_none();
        if !keeps_curves || !is_plain || self.input.as_os_str() == "-" {
            return Ok(None);
        }
        let name = input::name(&self.input);
        let drawing = match io::read_boundary_path(&self.input, &common.reading()) {
            Ok(drawing) => drawing,
            Err(error) if format == Format::Dat => return Err(error.into()),
            // Whoever reads models says what is wrong.
            Err(_) => return Ok(None),
        };
        if format != Format::Dat && !matches!(drawing.format(), Some(Format::Json | Format::Dat)) {
            return Ok(None);
        }
        remarks::take(&name, drawing.remarks());
        progress.stage("checking");
        let set = PlanarSet::of(&drawing, &SetRequest::default()).map_err(|error| error.in_file(name))?;
        Ok(Some(set))
    }

    fn write_set(
        &self,
        set: &PlanarSet,
        format: Format,
        common: &Common,
        progress: Progress,
    ) -> Result<(), Failure> {
        remarks::accept(set.remarks(), common)?;
        let Some(path) = &common.output else {
            let mut bytes = Vec::new();
            set.write(&mut bytes, format, None)?;
            drop(progress);
            return print_bytes(|out| out.write_all(&bytes));
        };
        progress.stage(format!("writing {}", path.display()));
        io::replace_file(path, |out| set.write(out, format, None))?;
        drop(progress);
        let remarks: Vec<Remark> = set.remarks().iter().cloned().chain(lost_kinks(set, format)).collect();
        say_remarks(&remarks, common);
        if common.json {
            let (file, output) = (input::name(&self.input), path.display().to_string());
            let mut answer = ConvertAnswer::of_set(&file, &output, format.name(), set);
            answer.remarks = remarks;
            return print_json(&answer);
        }
        Ok(())
    }

    /// Makes the dual or the halfedges that were asked for, and polygons of halfedges for what has no words for these: says what changed.
    fn reshape(
        &self,
        loaded: &mut Loaded,
        format: Target,
        path: Option<&Path>,
        progress: &Progress,
    ) -> Result<Vec<Remark>, Failure> {
        let file = loaded.name.clone();
        let in_file = |error: coface::Error| error.in_file(file.clone());
        let name = path.map(|path| path.to_string_lossy().to_ascii_lowercase());
        let is_named = name.is_some_and(|name| name.ends_with(".halfedges.json"));
        let is_json = matches!(format, Target::Model(Format::Json | Format::Container));
        if self.dual || self.dual_graph {
            progress.stage("finding the dual");
            let model = std::mem::take(&mut loaded.model);
            loaded.model =
                if self.dual { dual_model(model) } else { dual_graph_model(model) }.map_err(in_file)?;
        }
        if self.halfedges || is_named {
            if !is_json {
                return Err(Failure::new("only JSON holds halfedges: give -o OUT.halfedges.json"));
            }
            progress.stage("identifying cells");
            let model = halfedge_model(std::mem::take(&mut loaded.model)).map_err(in_file)?;
            let remarks = model.remarks().to_vec();
            loaded.model = model;
            return Ok(remarks);
        }
        // A signature is of any triangulation with tetrahedra; what is none is said by the writer.
        if matches!(format, Target::Model(Format::Isosig))
            && !matches!(loaded.model.structure(), Some(Structure::Gluings(_)))
            && let Ok(model) = gluing_model(&loaded.model)
        {
            let losses = io::signature_losses(&loaded.model);
            loaded.model = model;
            return Ok(losses);
        }
        if !is_json && matches!(loaded.model.structure(), Some(Structure::Halfedges { .. })) {
            loaded.model = polygon_model(std::mem::take(&mut loaded.model)).map_err(in_file)?;
        }
        Ok(Vec::new())
    }

    /// Makes the polygons of a drawing valid, if a repair was asked for and it is one: says what was done.
    fn valid_map(&self, loaded: &mut Loaded, progress: &Progress) -> Result<Option<MapAnswer>, Failure> {
        let method = match self.repair {
            Some(RepairGoal::Structure) => RepairMethod::Structure,
            Some(RepairGoal::Linework) => RepairMethod::Linework,
            Some(RepairGoal::Surface) if is_drawn(&loaded.model) => RepairMethod::Structure,
            _ => return Ok(None),
        };
        progress.stage("repairing");
        let result = MapResult::new([(&loaded.name[..], &loaded.model)], &MapTask::Repair(method))?;
        let answer = result.answer().clone();
        loaded.model = result.model().clone();
        Ok(Some(answer))
    }

    /// Repairs the model as was asked for, if anything was: says what was done.
    fn repaired(
        &self,
        loaded: &mut Loaded,
        progress: &Progress,
    ) -> Result<Option<MeshRepairAnswer>, Failure> {
        let in_file = |error: coface::Error| error.in_file(loaded.name.clone());
        let (model, answer) = if let Some(goal) = self.repair {
            progress.stage("repairing");
            let request = SurfaceRepairRequest::new()
                .tolerance(self.weld.unwrap_or(0.0))
                .closed(goal == RepairGoal::Closed);
            let (model, done) = repaired_surface(&loaded.model, &request).map_err(in_file)?;
            (model, MeshRepairAnswer::from(&done))
        } else if let Some(request) = self.request() {
            progress.stage("repairing");
            let (model, done) = repaired(&loaded.model, request).map_err(in_file)?;
            (model, MeshRepairAnswer::from(&done))
        } else {
            return Ok(None);
        };
        loaded.model = model;
        Ok(Some(answer))
    }

    /// The single repairs that were asked for, if any.
    fn request(&self) -> Option<RepairRequest> {
        let mut request = RepairRequest::default();
        request.split_edges = self.split_edges.map(|together| match together {
            Together::Apart => FacesAtEdge::Apart,
            Together::Pairs => FacesAtEdge::CoherentPairs,
        });
        request.split_vertices = self.split_vertices;
        request.orient = self.orient;
        (request != RepairRequest::default()).then_some(request)
    }
}

/// Whether a model is a drawing with polygons that have rings.
fn is_drawn(model: &Model) -> bool {
    model.polygons().is_empty() && model.data_named("ring", GroupKind::Lines).is_some()
}

/// What was repaired, in numbers.
fn remark_of_repair(repair: &MeshRepairAnswer) -> Remark {
    let (edges, vertices) = (repair.edges_split.len(), repair.vertices_split.len());
    let turned = repair.faces_turned.len();
    let mut message = format!("edges split: {edges}; vertices split: {vertices}; faces turned: {turned}");
    let mut count = edges + vertices + turned;
    if let Some(done) = repair.surface {
        let steps = [
            ("vertices merged", done.vertices_merged),
            ("vertices without a face left out", done.vertices_left_out),
            ("collapsed polygons left out", done.polygons_collapsed),
            ("repeated polygons left out", done.polygons_repeated),
            ("loose lines left out", done.lines_left_out),
            ("holes filled", done.holes_filled),
            ("triangles added", done.triangles_added),
        ];
        for (what, number) in steps.into_iter().filter(|&(_, number)| number > 0) {
            message += &format!("; {what}: {number}");
            count += number;
        }
    }
    Remark::new(RemarkCode::ModelRepaired, message).at(count, [])
}
