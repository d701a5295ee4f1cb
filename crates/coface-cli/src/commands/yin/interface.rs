//! `coface yin interface`: sets as phases that share the arcs between them.

use super::{SetOptions, Shown, given};
use crate::arguments::Common;
use crate::failure::Failure;
use crate::input;
use crate::output::{is_json, json_bytes, print_json, print_text, write_file};
use crate::pictures::PictureFormat;
use crate::progress::Progress;
use crate::remarks::{accept, say_remarks, take};
use clap::{Args, ValueEnum};
use coface::answers::answer::{JunctionKind, YinInterfaceAnswer};
use coface::answers::{LabelImage, NamedSet, PlanarInterface, PlanarSet, text};
use coface::io::{Format, NumberTable, StagedFiles};
use coface::pictures::interface_picture;
use coface::yin::{InterfaceOptions, Overlaps};
use serde::Serialize;
use std::path::{Path, PathBuf};

/// So many lines are shown of a list.
const LISTED: usize = 20;

/// The interface of sets that lie side by side: its arcs, junctions and phases, with areas, lengths and neighbors.
///
/// Each file is a phase; a single file of polygons (GeoJSON, WKT, ..) gives one for each feature, and an image
/// of labels (.pgm, .png, or .npy of two axes) one for each value but 0, its pixels as unit squares from the lower left corner. The .json that this
/// verb or `coface yin advect` has written gives its phases again. What is in no set is in no phase. Sets may
/// have different knots where they meet, but their common arcs must be the same: what two sets have in common is an error, unless
/// --overlaps gives it to one of them.
///
/// With -o FILE.json the interface is written, with the control points of all edges; with -o FILE.svg, .png or .pdf it is drawn: phases in colors,
/// junctions marked with their types. coface render draws FILE.json the same. With --sets NAME.json each phase as a set:
/// NAME-001.json, NAME-002.json, .., which every verb of `yin` takes, and this one gives the same interface for.
///
/// With --json: "phases" (each with "name", "area", "perimeter", "components", "holes", and "neighbors" with the number and the length of
/// common edges), "edges" ("ends", "left", "right", "length", "pieces"), "vertices", "junctions" ("vertex", "point", "degree", "smooth_pairs",
/// "kind": y, t, x or other, "edges" and "phases" counterclockwise) and "length" of all edges.
#[derive(Args)]
pub(super) struct Interface {
    /// The sets; - is standard input
    #[arg(required = true, value_name = "INPUT")]
    inputs: Vec<PathBuf>,
    #[command(flatten)]
    options: SetOptions,
    #[command(flatten)]
    phases: PhaseOptions,
}

/// Which sets are phases, how they go together, and where they are written.
#[derive(Args)]
pub(super) struct PhaseOptions {
    /// What of the files is a phase [default: features of a single file of polygons, else files]
    #[arg(long = "inputs", value_name = "WHAT", help_heading = "Interfaces")]
    parts: Option<Parts>,
    /// Where points go that several sets have in common [default: refuse]
    #[arg(long, value_name = "WHERE", help_heading = "Interfaces")]
    overlaps: Option<CommonPoints>,
    /// By how many degrees edges may turn at a junction and still go on smoothly into each other [default: 1, or as an interface of a
    /// file says]
    #[arg(long, value_name = "DEGREES", allow_hyphen_values = true, help_heading = "Interfaces")]
    smooth: Option<f64>,
    /// Write each phase as a set: NAME-001.json, NAME-002.json, .. for NAME.json
    #[arg(long, value_name = "FILE", help_heading = "Interfaces")]
    sets: Option<PathBuf>,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Parts {
    /// Each file
    Files,
    /// Each feature: polygons with one name, and each polygon without a name
    Features,
}

#[derive(Clone, Copy, ValueEnum)]
enum CommonPoints {
    /// Nowhere: sets that overlap are an error
    Refuse,
    /// To the set that comes first
    First,
    /// To the set that comes last
    Last,
}

impl Interface {
    pub(super) fn run(&self, common: &Common) -> Result<(), Failure> {
        let output = InterfaceOutput::new(&self.options, common)?;
        let progress = Progress::start(common.quiet);
        let interface = self.phases.read(&self.inputs, &self.options, common, &progress)?;
        progress.stage("writing");
        self.phases.write_sets(&interface, &self.options, common)?;
        give(&interface, "Interface", &self.inputs, &output, common, progress)
    }
}

/// Gives an interface as the command line asks.
pub(super) fn give(
    interface: &PlanarInterface,
    what: &str,
    inputs: &[PathBuf],
    output: &InterfaceOutput,
    common: &Common,
    progress: Progress,
) -> Result<(), Failure> {
    progress.stage("measuring");
    let files: Vec<String> = inputs.iter().map(|path| input::name(path)).collect();
    let answer = interface.answer(&files, false)?;
    let text = || page(what, &answer);
    give_answer(interface, &answer, text, inputs, output, common, progress)
}

/// Writes an interface, and gives an answer about it or the page of that.
pub(super) fn give_answer(
    interface: &PlanarInterface,
    answer: &impl Serialize,
    text: impl Fn() -> String,
    inputs: &[PathBuf],
    output: &InterfaceOutput,
    common: &Common,
    progress: Progress,
) -> Result<(), Failure> {
    if let Some(path) = &common.output {
        progress.stage("writing");
        write_file(path, &output.bytes(interface, inputs)?)?;
    }
    drop(progress);
    say_remarks(interface.remarks(), common);
    match (common.json, &common.output) {
        (true, _) => print_json(answer),
        (false, Some(_)) => Ok(()),
        (false, None) => print_text(&text()),
    }
}

/// How an interface is written: as JSON, or drawn.
pub(super) struct InterfaceOutput {
    format: Option<PictureFormat>,
}

impl InterfaceOutput {
    pub(super) fn new(options: &SetOptions, common: &Common) -> Result<Self, Failure> {
        if options.picture != Shown::Set {
            return Err(Failure::new(
                "--picture draws a set, not an interface: write the phases with --sets, and ask for it with `coface yin info`",
            ));
        }
        let format = common.output.as_deref().and_then(PictureFormat::of);
        if let Some(path) = common.output.as_deref().filter(|path| !is_json(path) && format.is_none()) {
            return Err(Failure::new(format!(
                "{}: an interface is written as .json, or drawn as .svg, .png or .pdf; name the file so, or write its phases with --sets",
                path.display()
            )));
        }
        Ok(Self { format })
    }

    /// What is in the file of an interface of these inputs.
    pub(super) fn bytes(
        &self,
        interface: &PlanarInterface,
        inputs: &[PathBuf],
    ) -> Result<Vec<u8>, coface::Error> {
        let files: Vec<String> = inputs.iter().map(|path| input::name(path)).collect();
        let whole = interface.answer(&files, true)?;
        match self.format {
            Some(format) => format.bytes(&interface_picture(&title(inputs), &whole)?, None),
            None => Ok(json_bytes(&whole)),
        }
    }
}

/// What a picture is called: the files without their folders.
fn title(inputs: &[PathBuf]) -> String {
    let name = |path: &PathBuf| {
        path.file_name().map_or_else(|| input::name(path), |name| name.to_string_lossy().into_owned())
    };
    let names: Vec<String> = inputs.iter().map(name).collect();
    format!("interface of {}", names.join(", "))
}

/// The format of an image of labels, by the name of the file.
fn label_format(path: &Path) -> Option<Format> {
    Format::from_path(path).filter(|format| matches!(format, Format::Npy | Format::Pgm | Format::Png))
}

impl PhaseOptions {
    /// Whether files are an interface, and not one set.
    pub(super) fn are_phases(&self, inputs: &[PathBuf]) -> Result<bool, Failure> {
        if inputs.len() > 1 || self.is_asked() || inputs.iter().any(|path| label_format(path).is_some()) {
            return Ok(true);
        }
        Ok(given::interface_answer(&inputs[0])?.is_some())
    }

    /// Whether an option says that there are phases.
    fn is_asked(&self) -> bool {
        self.parts.is_some() || self.overlaps.is_some() || self.smooth.is_some() || self.sets.is_some()
    }

    /// The interface of files.
    pub(super) fn read(
        &self,
        inputs: &[PathBuf],
        options: &SetOptions,
        common: &Common,
        progress: &Progress,
    ) -> Result<PlanarInterface, Failure> {
        let smooth = self.smooth.unwrap_or(1.0);
        if !(smooth.is_finite() && smooth < 180.0) {
            return Err(Failure::new(format!(
                "--smooth {smooth}: give an angle below 180 degrees; a negative one lets no edges go on smoothly",
            )));
        }
        if let ([path], None, None) = (inputs, self.smooth, self.overlaps) {
            progress.stage(format!("reading {}", input::name(path)));
            if let Some(interface) = given::interface(path)? {
                options.check_interface(path)?;
                accept(interface.remarks(), common)?;
                return Ok(interface);
            }
        }
        let sets = self.sets_of(inputs, options, common, progress)?;
        progress.stage("laying boundaries over each other");
        let fit = InterfaceOptions::new(PlanarInterface::order_for(&sets)).smooth_angle(smooth.to_radians());
        let overlaps = match self.overlaps {
            None | Some(CommonPoints::Refuse) => Overlaps::Refused,
            Some(CommonPoints::First) => Overlaps::ToTheFirst,
            Some(CommonPoints::Last) => Overlaps::ToTheLast,
        };
        let names: Vec<String> = sets.iter().map(|one| one.name.clone()).collect();
        let interface = PlanarInterface::of(sets, &fit, overlaps).map_err(|error| named(error, &names))?;
        accept(interface.remarks(), common)?;
        Ok(interface)
    }

    fn sets_of(
        &self,
        inputs: &[PathBuf],
        options: &SetOptions,
        common: &Common,
        progress: &Progress,
    ) -> Result<Vec<NamedSet>, Failure> {
        let mut sets = Vec::new();
        for path in inputs {
            let name = input::name(path);
            if let Some(format) = label_format(path) {
                progress.stage(format!("reading {name}"));
                let image = match format {
                    Format::Npy => NumberTable::read_path(path)
                        .and_then(NumberTable::of_numbers_only)
                        .and_then(|table| LabelImage::of_table(&table)),
                    _ => {
                        let read = std::fs::read(path).map_err(coface::Error::from);
                        read.and_then(|bytes| LabelImage::read(&bytes, format)).map(|(image, said)| {
                            take(&name, &said);
                            image
                        })
                    }
                };
                let found = image.and_then(|image| image.sets());
                let found = found.and_then(|sets| options.applied(sets, common));
                sets.extend(found.map_err(|error| error.in_file(name.clone()))?);
                continue;
            }
            if let Some(interface) = given::interface(path)? {
                options.check_interface(path)?;
                sets.extend(interface.named_phases()?);
                continue;
            }
            let is_split = match self.parts {
                Some(parts) => parts == Parts::Features,
                None => inputs.len() == 1 && !given::is_phase(path),
            };
            if is_split {
                let drawing = options.drawing(path, common, progress)?;
                let request = options.request(common);
                let found = NamedSet::of_features(&name, &drawing, &request);
                if let Some(found) = found.map_err(|error| error.in_file(name.clone()))? {
                    accept(drawing.remarks(), common)?;
                    take(&name, drawing.remarks());
                    sets.extend(found);
                    continue;
                }
                if self.parts == Some(Parts::Features) {
                    return Err(Failure::new(format!(
                        "{name}: it has no features, but curves that bound one set; give a file for each phase: --inputs files"
                    )));
                }
                // What standard input had has been read.
                let set = PlanarSet::of(&drawing, &request).map_err(|error| error.in_file(name.clone()))?;
                accept(set.remarks(), common)?;
                take(&name, set.remarks());
                sets.push(NamedSet::new(name, set));
                continue;
            }
            let set = options.read(path, common, false, progress)?;
            sets.push(NamedSet::new(name, set));
        }
        Ok(sets)
    }

    /// Writes the phases as sets, if that is asked for.
    pub(super) fn write_sets(
        &self,
        interface: &PlanarInterface,
        options: &SetOptions,
        common: &Common,
    ) -> Result<(), Failure> {
        let Some(path) = &self.sets else { return Ok(()) };
        let format = Format::from_path(path).ok_or_else(|| {
            Failure::new(format!("{}: sets are written as .json; name the file so", path.display()))
        })?;
        let mut staged = StagedFiles::beside(path)?;
        for (number, set) in (1..).zip(&interface.phases()?) {
            let path = super::advect::numbered(path, number);
            staged.write(&path, |out| options.write_to(set, out, format, common))?;
        }
        staged.finish()?;
        Ok(())
    }
}

/// The same error, with the options of the program as its cure and the names of the sets.
fn named(error: coface::Error, names: &[String]) -> coface::Error {
    if !error.cure().is_some_and(|cure| cure.starts_with("give sets that do not overlap")) {
        return error;
    }
    let mut message = error.message().to_owned();
    let numbers: Vec<usize> = message.split(' ').filter_map(|word| word.parse().ok()).take(2).collect();
    if let [Some(first), Some(second)] =
        [0, 1].map(|at| numbers.get(at).and_then(|&number| names.get(number)))
    {
        message = format!("{message}; they are {first} and {second}");
    }
    coface::Error::new(error.kind(), message).with_cure(
        "give sets that do not overlap, or say to which of them common points go: --overlaps first or --overlaps last",
    )
}

/// The page of an interface.
pub(super) fn page(title: &str, answer: &YinInterfaceAnswer) -> String {
    let real = |number: Option<f64>| number.map_or("infinite".to_owned(), text::number);
    let kinds = [JunctionKind::Y, JunctionKind::T, JunctionKind::X, JunctionKind::Other].map(|kind| {
        let count = answer.junctions.iter().filter(|junction| junction.kind == kind).count();
        (count > 0).then(|| format!("{} {}", text::grouped(count), kind.word()))
    });
    let kinds: Vec<String> = kinds.into_iter().flatten().collect();
    let mut facts = vec![
        ("phases".to_owned(), text::grouped(answer.phases.len()), String::new()),
        ("edges".to_owned(), text::grouped(answer.edges.len()), format!("order {}", answer.order)),
        ("junctions".to_owned(), text::grouped(answer.junctions.len()), kinds.join(", ")),
        ("length".to_owned(), real(answer.length), "of all edges, each once".to_owned()),
    ];
    let name_of = |phase: Option<u32>| match phase {
        Some(phase) => answer.phases[phase as usize].name.clone(),
        None => "outside".to_owned(),
    };
    for phase in answer.phases.iter().take(LISTED) {
        let neighbors: Vec<String> = phase
            .neighbors
            .iter()
            .take(4)
            .map(|one| format!("{} {}", name_of(one.phase), real(one.length)))
            .collect();
        let more = if phase.neighbors.len() > 4 { ", .." } else { "" };
        facts.push((
            phase.name.clone(),
            format!("area {}", real(phase.area)),
            format!("{} in common with {}{more}", real(phase.perimeter), neighbors.join(", ")),
        ));
    }
    if answer.phases.len() > LISTED {
        facts.push((
            "..".to_owned(),
            String::new(),
            format!("{} in all", text::count(answer.phases.len(), "phase")),
        ));
    }
    text::facts(title, &facts)
}
