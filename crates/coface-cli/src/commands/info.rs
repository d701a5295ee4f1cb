//! `coface info`: the report.

use super::map::{Method, repair_facts};
use crate::arguments::Common;
use crate::certified;
use crate::failure::Failure;
use crate::input;
use crate::output::{check_page, check_text, give, is_html, is_json, print_json, write_file};
use crate::progress::Progress;
use crate::remarks::{accept, are_on_the_page};
use clap::{Args, ValueEnum};
use coface::answers::answer::{
    FailedInput, InfoAnswer, InfoEntry, InfoReports, MapRepairAnswer, to_pretty_json,
};
use coface::answers::text;
use coface::answers::{GeometryCheck, MapResult, MapTask, Producer, Report, ReportRequest};
use coface::io::{Format, Model};
use coface::pictures::pages::html::{self, Figure, Section};
use coface::pictures::{Scene, matrix_picture};
use serde::Serialize;
use std::path::{Path, PathBuf};

/// Say what a model is, and what is wrong with it and where.
///
/// The report: counts, dimension, components, Euler characteristic, whether it is a manifold, boundary loops,
/// orientation, genus and name of a surface, integral homology, area, volume and mass properties, and every problem with
/// its place: of a surface in space also faces that cross, overlap, are not flat, and what keeps it from bounding a
/// solid, with the codes of ISO 19107. Center of mass and inertia are those of a solid of density 1, the inertia about the center.
///
/// With --json one input gives one report object; several give {"reports":[..]}, where an input that cannot be served
/// has the keys "file" and "error" alone and the exit status is 1. With -o the report goes to the file, as JSON if its
/// name ends in .json, as a page for browsers with pictures if it ends in .html.
#[derive(Args)]
pub(crate) struct Info {
    /// Files to report on; - is standard input
    #[arg(required = true, value_name = "INPUT")]
    inputs: Vec<PathBuf>,
    /// List every place of every problem and all boundary loops, not just the first few
    #[arg(long)]
    all: bool,
    /// Write the report with pictures as one page for browsers; opens from disk without a network
    #[arg(long, value_name = "PAGE.html")]
    html: Option<PathBuf>,
    /// Integrate x^A y^B z^C over the volume and over the surface; may be given several times
    #[arg(long, value_name = "A,B,C", value_parser = exponents)]
    moment: Vec<[u32; 3]>,
    /// How hard to try for the manifold verdict above dimension 3: `full` looks at all links, however long it takes
    #[arg(long, value_name = "EFFORT", default_value = "usual")]
    verdict: VerdictEffort,
    /// What is checked beside the cells: whether the faces of a surface cross, overlap, are flat and bound a solid
    #[arg(long, value_name = "WHAT", default_value = "usual")]
    check: Check,
    /// How far points of a flat face may be from its plane, in the unit of the file [default: a hundredth of the face]
    #[arg(long, value_name = "LENGTH", value_parser = length)]
    flatness: Option<f64>,
    /// Say what a repair of the polygons of a drawing would do, by structure (outer rings minus holes) or by linework: convert --repair
    /// writes it
    #[arg(long, value_name = "METHOD", num_args = 0..=1, default_missing_value = "structure")]
    repair: Option<Method>,
    /// A certificate of the report on one input, which coface check verifies: counts, components, manifold up to dimension 3, orientability,
    /// boundary loops, genus, homology; of a facet list, or a surface as plain OFF or OBJ; in
    /// the binary form if OUT ends in .bin
    #[arg(long, value_name = "OUT")]
    certificate: Option<PathBuf>,
}

/// What is checked beside the cells.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Check {
    /// The geometry of surfaces of up to 200,000 faces
    Usual,
    /// The geometry of all surfaces
    Geometry,
    /// No geometry
    Topology,
}

/// A length from 0.
fn length(text: &str) -> Result<f64, String> {
    let length = text.parse::<f64>().ok().filter(|length| length.is_finite() && *length >= 0.0);
    length.ok_or_else(|| "give a number from 0, like 0.01".to_owned())
}

/// How many links are looked at.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum VerdictEffort {
    /// Up to 200 million simplices of links; beyond, the verdict is unknown
    Usual,
    /// All links
    Full,
}

/// Three exponents with commas between them.
fn exponents(text: &str) -> Result<[u32; 3], String> {
    let numbers: Option<Vec<u32>> = text.split(',').map(|number| number.trim().parse().ok()).collect();
    numbers
        .and_then(|numbers| numbers.try_into().ok())
        .ok_or_else(|| "give three numbers from 0 with commas between them, like 2,0,0".to_owned())
}

/// How many places of a problem JSON lists when not all are asked for.
const PLACES_IN_JSON: usize = 100;

impl Info {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        if let Some(place) = &self.certificate {
            certified::check_place(place, &self.inputs, "info", common)?;
            if self.inputs.len() > 1 {
                return Err(Failure::new(
                    "--certificate is for one input: name one, or run the command once for each",
                ));
            }
        }
        if let Some(path) = &self.html {
            check_page(path)?;
        }
        let progress = Progress::start(common.quiet);
        let as_json = common.json || common.output.as_deref().is_some_and(is_json);
        let page_file = common.output.as_deref().filter(|path| is_html(path));
        let text_file = common.output.as_deref().is_some_and(|path| !is_json(path) && !is_html(path));
        if let Some(path) = common.output.as_deref().filter(|_| text_file) {
            check_text(path)?;
        }
        let is_shown = text_file || !as_json && common.output.is_none() && self.html.is_none();
        let (mut entries, mut page, mut failed) = (Vec::new(), String::new(), false);
        let mut sections = Vec::new();
        for path in &self.inputs {
            let is_drawn = self.html.is_some() || page_file.is_some();
            let report = match self.report(path, common, is_drawn, &progress) {
                Ok((report, figures)) => {
                    if is_drawn {
                        sections.push(Section {
                            items: text::items(
                                &report.name,
                                report.format.title(),
                                &report.report,
                                self.limit(text::FEW),
                            ),
                            figures,
                            object: to_pretty_json(&self.answer(&report)),
                        });
                    }
                    report
                }
                Err(failure) if self.inputs.len() == 1 => return Err(failure),
                Err(failure) => {
                    failed = true;
                    if let Failure::Message(message) | Failure::Memory(message) = &failure {
                        let (file, error) = (input::name(path), message.clone());
                        entries.push(InfoEntry::Failed(FailedInput { file, error }));
                    }
                    failure.say();
                    continue;
                }
            };
            if let Some(place) = &self.certificate {
                progress.stage(format!("proving {}", place.display()));
                let answer = self.answer(&report);
                certified::save(place, &self.inputs, |inputs| answer.certificate(inputs))?;
            }
            if as_json {
                entries.push(InfoEntry::Report(Box::new(self.answer(&report))));
            }
            if is_shown {
                if !page.is_empty() {
                    page.push('\n');
                }
                page +=
                    &text::report(&report.name, report.format.title(), &report.report, self.limit(text::FEW));
                if let Some(repair) = &report.repair {
                    page.push('\n');
                    page += &text::facts("Repair", &repair_facts(repair));
                }
            }
        }
        progress.stage("writing");
        if !sections.is_empty() {
            let names: Vec<String> = self.inputs.iter().map(|path| input::name(path)).collect();
            let written = html::page(&names.join(", "), &sections);
            for path in self.html.as_deref().into_iter().chain(page_file) {
                write_file(path, written.as_bytes())?;
            }
        }
        drop(progress);
        if failed && page.is_empty() && !as_json {
            return Err(Failure::Said);
        }
        let is_given = is_shown || common.output.as_deref().is_some_and(is_json);
        if is_shown {
            are_on_the_page();
        }
        if self.inputs.len() == 1 {
            show(common, is_given, &entries.pop(), &page)?;
        } else {
            show(common, is_given, &InfoReports { reports: entries }, &page)?;
        }
        if failed { Err(Failure::Said) } else { Ok(()) }
    }

    fn report(
        &self,
        path: &Path,
        common: &Common,
        is_drawn: bool,
        progress: &Progress,
    ) -> Result<(Named, Vec<(Figure, String)>), Failure> {
        let loaded = input::read(path, common.reading(), progress)?;
        let in_file = |error: coface::Error| error.in_file(loaded.name.clone());
        progress.stage(format!("examining {}", loaded.name));
        let format = loaded.format;
        let model = if is_drawn { Some(loaded.model.clone()) } else { None };
        let mut repair = None;
        if let Some(method) = self.repair {
            let task = MapTask::Repair(method.method());
            let result = MapResult::new([(&loaded.name[..], &loaded.model)], &task)?;
            repair.clone_from(&result.answer().repair);
        }
        let request = ReportRequest::new()
            .moments(self.moment.clone())
            .full_verdict(self.verdict == VerdictEffort::Full)
            .geometry(match self.check {
                Check::Usual => GeometryCheck::Usual,
                Check::Geometry => GeometryCheck::Always,
                Check::Topology => GeometryCheck::Never,
            })
            .flatness(self.flatness)
            .geometry_places(self.limit(PLACES_IN_JSON));
        let report = Report::answering(loaded.model, &request).map_err(in_file)?;
        accept(report.remarks(), common)?;
        let mut figures = Vec::new();
        if let Some(model) = model {
            progress.stage("drawing");
            figures = figures_of(&loaded.name, model, &report).map_err(in_file)?;
        }
        Ok((Named { name: loaded.name, format, report, repair }, figures))
    }

    fn limit(&self, usual: usize) -> usize {
        if self.all { usize::MAX } else { usual }
    }

    fn answer(&self, named: &Named) -> InfoAnswer {
        let answer = named.report.answer(self.limit(PLACES_IN_JSON));
        let mut answer = answer.of_file(&named.name, named.format.name());
        answer.repair.clone_from(&named.repair);
        answer
    }
}

/// Gives the answer as the command line asks, or prints the object alone with --json.
fn show(common: &Common, is_given: bool, answer: &impl Serialize, page: &str) -> Result<(), Failure> {
    match (is_given, common.json) {
        (true, _) => give(common, answer, page),
        (false, true) => print_json(answer),
        (false, false) => Ok(()),
    }
}

/// The boundary matrices of more cells than this are not drawn.
const CELLS_OF_MATRICES: usize = 3000;

/// The pictures of a model: itself with what is wrong and its boundary in red, and its boundary matrices if they are small.
fn figures_of(name: &str, model: Model, report: &Report) -> Result<Vec<(Figure, String)>, coface::Error> {
    let mut figures = Vec::new();
    // What has nothing to be seen has no picture.
    if let Ok(scene) = Scene::of(name, &model) {
        let scene = scene.with_boundary().with_report(&report.answer(PLACES_IN_JSON));
        let mut caption = "The model".to_owned();
        if scene.layers().iter().any(|layer| layer.group == "witness") {
            caption += ", what is wrong with it in red";
        } else if scene.layers().iter().any(|layer| layer.group == "boundary" && layer.is_on) {
            caption += ", its boundary in red";
        }
        let figure = Figure::of(&scene)?;
        for remark in scene.remarks() {
            caption += "; ";
            caption += &remark.message;
        }
        figures.push((figure, caption + "."));
    }
    let cells: usize = report.f_vector().iter().sum();
    if cells <= CELLS_OF_MATRICES && report.f_vector().len() > 1 {
        let complex = Producer::of(model)?.into_chain_complex()?;
        let picture = matrix_picture(&format!("boundary matrices of {name}"), &complex);
        let caption = "The boundary matrices: blue entries are positive, orange ones negative.";
        figures.push((Figure::Svg(picture.svg(None)?), caption.to_owned()));
    }
    Ok(figures)
}

/// A report with what it is about.
struct Named {
    name: String,
    format: Format,
    report: Report,
    /// What a repair of a drawing would do, if that was asked for.
    repair: Option<MapRepairAnswer>,
}
