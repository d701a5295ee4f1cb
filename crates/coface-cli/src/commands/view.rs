//! `coface view`: a page that shows a model and what is known about it.

use crate::arguments::Common;
use crate::failure::Failure;
use crate::input;
use crate::output::{check_page, print_bytes, print_json, write_file};
use crate::progress::Progress;
use crate::remarks::say_remarks;
use clap::Args;
use coface::answers::answer::{LayerAnswer, ViewAnswer, to_pretty_json};
use coface::answers::{PlanarInterface, PlanarSet, Report, SetRequest, text};
use coface::io::{Format, Model};
use coface::pictures::Scene;
use coface::pictures::pages::html::{Figure, Section};
use serde_json::Value;
use std::path::{Path, PathBuf};

/// Write one page that shows a model: opens from disk in any browser, without a network.
///
/// The page has the model to turn, cut and take apart, the report beside it, its boundary and what is wrong with it, and layers for what
/// --with gives: generators of homology, cocycles and harmonic forms, loops, seams with the fundamental domain (coface cut -o cut.json),
/// the universal cover (coface cover -o cover.json), facts about the cells of an arrangement (coface arrange --json), sets of simplices,
/// forests, persistence diagrams. A click on a vertex, an edge, a face or a cell shows its star, closure, link and boundary.
///
/// Models are all that coface reads: surfaces, volumes, drawings, chain complexes with positions, Yin sets with their splines, kinks and
/// knots, and interfaces (coface yin interface -o FILE.json) with their phases, edges and junctions.
#[derive(Args)]
pub(crate) struct View {
    /// The model; - is standard input
    #[arg(value_name = "INPUT")]
    input: PathBuf,
    /// Show an answer of coface over the model: the JSON of another verb, or a chain or cochain of your own as [[coefficient,
    /// [vertices..]],..]; may be given several times
    #[arg(long, value_name = "RESULT.json")]
    with: Vec<PathBuf>,
    /// Leave the report out, which takes most of the time on large models
    #[arg(long)]
    no_report: bool,
}

/// What the page shows.
struct Shown {
    /// Its name for people.
    name: String,
    scene: Scene,
    /// The model and its format, if it can be examined: sets have their report already.
    model: Option<(Model, Format)>,
}

impl View {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        if let Some(path) = &common.output {
            check_page(path)?;
        }
        let progress = Progress::start(common.quiet);
        let Shown { name, mut scene, model } = self.read(common, &progress)?;
        say_remarks(&scene.remarks(), common);
        for path in &self.with {
            let result = read_result(path)?;
            scene.add_result(&input::name(path), &result)?;
        }
        let mut still = None;
        if let Some((model, format)) = model.filter(|_| !self.no_report) {
            progress.stage(format!("examining {name}"));
            let in_file = |error: coface::Error| error.in_file(name.clone());
            let report = Report::of(model).map_err(in_file)?;
            let answer = report.answer(100);
            scene = scene.with_boundary().with_report(&answer);
            still = Some(Section {
                items: text::items(&name, format.title(), &report, text::FEW),
                figures: vec![(Figure::of(&scene).map_err(in_file)?, "The model.".to_owned())],
                object: to_pretty_json(&answer),
            });
        }
        progress.stage("writing the page");
        let page = coface::pictures::pages::viewer::page_of(&scene.document(), still.as_ref());
        drop(progress);
        match &common.output {
            Some(path) => write_file(path, page.as_bytes())?,
            None if common.json => {}
            None => return print_bytes(|out| out.write_all(page.as_bytes())),
        }
        if common.json {
            let layers = scene.layers().iter().map(|layer| LayerAnswer {
                group: layer.group.clone(),
                name: layer.name.clone(),
                detail: layer.detail.clone(),
            });
            print_json(&ViewAnswer {
                file: name,
                page: common.output.as_ref().map(|path| path.display().to_string()),
                bytes: page.len(),
                triangles: scene.triangles().len(),
                layers: layers.collect(),
                panes: scene.panes().iter().map(|pane| pane.name.clone()).collect(),
                remarks: scene.remarks(),
            })?;
        }
        Ok(())
    }

    /// Reads the input as a set of the plane, or else as a model.
    fn read(&self, common: &Common, progress: &Progress) -> Result<Shown, Failure> {
        let source = input::Source::of(&self.input)?;
        let name = input::name(&self.input);
        let in_file = |error: coface::Error| error.in_file(name.clone());
        let title = |name: &str| {
            Path::new(name).file_name().map_or(name.to_owned(), |name| name.to_string_lossy().into_owned())
        };
        if let Some(answer) = source.interface().map_err(in_file)? {
            progress.stage("drawing");
            let interface = PlanarInterface::of_answer(&answer).map_err(in_file)?;
            let scene = Scene::of_interface(&title(&name), &interface).map_err(in_file)?;
            return Ok(Shown { name, scene, model: None });
        }
        let loaded = source.model(common.reading(), progress);
        progress.stage("drawing");
        let may_be_set = match &loaded {
            Ok(loaded) => {
                let model = &loaded.model;
                matches!(loaded.format, Format::Json | Format::Dat)
                    && model.polygons().is_empty()
                    && model.cells().is_empty()
                    && model.structure().is_none()
            }
            Err(_) => true,
        };
        if may_be_set && let Ok(drawing) = source.boundary(&common.reading()) {
            let set = PlanarSet::of(&drawing, &SetRequest::default()).map_err(in_file)?;
            let scene = Scene::of_set(&title(&name), &set).map_err(in_file)?;
            return Ok(Shown { name, scene, model: None });
        }
        let loaded = loaded?;
        let scene = Scene::of(&title(&loaded.name), &loaded.model)
            .map_err(|error| error.in_file(loaded.name.clone()))?;
        Ok(Shown { name: loaded.name, scene, model: Some((loaded.model, loaded.format)) })
    }
}

pub(super) fn read_result(path: &Path) -> Result<Value, Failure> {
    let name = input::name(path);
    let bytes = std::fs::read(path).map_err(|error| coface::Error::from(error).in_file(name.clone()))?;
    serde_json::from_slice(&bytes).map_err(|error| {
        Failure::new(format!(
            "{name}:{}: {error}; give the JSON that another verb of coface wrote",
            error.line()
        ))
    })
}
