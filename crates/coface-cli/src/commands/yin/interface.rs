//! `coface yin interface`: sets as phases that share the arcs between them.

use super::{SetOptions, Shown};
use crate::arguments::Common;
use crate::failure::Failure;
use crate::input;
use crate::output::{is_json, print_json, print_text, write_file, write_json};
use crate::pictures::PictureFormat;
use crate::progress::Progress;
use crate::remarks::{accept, say_remarks, take};
use clap::{Args, ValueEnum};
use coface::answers::answer::{JunctionKind, YinInterfaceAnswer};
use coface::answers::{LabelImage, NamedSet, PlanarInterface, PlanarSet, text};
use coface::io::{Format, NumberTable, StagedFiles};
use coface::pictures::interface_picture;
use coface::yin::{InterfaceOptions, Overlaps};
use std::path::{Path, PathBuf};

/// So many lines are shown of a list.
const LISTED: usize = 20;

/// The interface of sets that lie side by side: its arcs, junctions and phases, with areas, lengths and neighbors.
///
/// Each file is a phase; a single file of polygons (GeoJSON, WKT, ..) gives one for each feature, and an image
/// of labels (.pgm, or .npy of two axes) one for each value but 0, its pixels as unit squares from the lower left corner. What is in no set is in no phase. Sets may
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
    /// What of the files is a phase [default: features of a single file of polygons, else files]
    #[arg(long = "inputs", value_name = "WHAT")]
    parts: Option<Parts>,
    /// Where points go that several sets have in common
    #[arg(long, value_name = "WHERE", default_value = "refuse")]
    overlaps: CommonPoints,
    /// By how many degrees edges may turn at a junction and still go on smoothly into each other
    #[arg(long, value_name = "DEGREES", default_value = "1", allow_hyphen_values = true)]
    smooth: f64,
    /// Write each phase as a set: NAME-001.json, NAME-002.json, .. for NAME.json
    #[arg(long, value_name = "FILE")]
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
        if self.options.picture != Shown::Set {
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
        if !(self.smooth.is_finite() && self.smooth < 180.0) {
            return Err(Failure::new(format!(
                "--smooth {}: give an angle below 180 degrees; a negative one lets no edges go on smoothly",
                self.smooth
            )));
        }
        let progress = Progress::start(common.quiet);
        let sets = self.read(common, &progress)?;
        progress.stage("laying boundaries over each other");
        let options = InterfaceOptions::new(PlanarInterface::order_for(&sets));
        let options = options.smooth_angle(self.smooth.to_radians());
        let overlaps = match self.overlaps {
            CommonPoints::Refuse => Overlaps::Refused,
            CommonPoints::First => Overlaps::ToTheFirst,
            CommonPoints::Last => Overlaps::ToTheLast,
        };
        let names: Vec<String> = sets.iter().map(|one| one.name.clone()).collect();
        let interface =
            PlanarInterface::of(sets, &options, overlaps).map_err(|error| named(error, &names))?;
        accept(interface.remarks(), common)?;
        progress.stage("measuring");
        let files: Vec<String> = self.inputs.iter().map(|path| input::name(path)).collect();
        let answer = interface.answer(&files, false)?;
        progress.stage("writing");
        if let Some(path) = &self.sets {
            self.write_sets(path, &interface.phases()?, common)?;
        }
        if let Some(path) = &common.output {
            let whole = interface.answer(&files, true)?;
            match format {
                Some(format) => {
                    let picture = interface_picture(&self.title(), &whole)?;
                    write_file(path, &format.bytes(&picture, None)?)?;
                }
                None => write_json(path, &whole)?,
            }
        }
        drop(progress);
        say_remarks(interface.remarks(), common);
        match (common.json, &common.output) {
            (true, _) => print_json(&answer),
            (false, Some(_)) => Ok(()),
            (false, None) => print_text(&page(&answer)),
        }
    }

    /// What a picture is called: the files without their folders.
    fn title(&self) -> String {
        let name = |path: &PathBuf| {
            path.file_name().map_or_else(|| input::name(path), |name| name.to_string_lossy().into_owned())
        };
        let names: Vec<String> = self.inputs.iter().map(name).collect();
        format!("interface of {}", names.join(", "))
    }

    fn read(&self, common: &Common, progress: &Progress) -> Result<Vec<NamedSet>, Failure> {
        let mut sets = Vec::new();
        for path in &self.inputs {
            let name = input::name(path);
            let ends_in = |word: &str| path.extension().is_some_and(|own| own.eq_ignore_ascii_case(word));
            if ends_in("pgm") || ends_in("npy") {
                progress.stage(format!("reading {name}"));
                let image = match ends_in("npy") {
                    true => NumberTable::read_path(path).and_then(|table| LabelImage::of_table(&table)),
                    false => std::fs::read(path)
                        .map_err(coface::Error::from)
                        .and_then(|bytes| LabelImage::read_pgm(&bytes)),
                };
                let found = image.and_then(|image| image.sets());
                sets.extend(found.map_err(|error| error.in_file(name.clone()))?);
                continue;
            }
            let is_split = match self.parts {
                Some(parts) => parts == Parts::Features,
                None => self.inputs.len() == 1,
            };
            if is_split {
                let drawing = self.options.drawing(path, common, progress)?;
                let request = self.options.request(common);
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
            let set = self.options.read(path, common, false, progress)?;
            sets.push(NamedSet::new(name, set));
        }
        Ok(sets)
    }

    fn write_sets(&self, path: &Path, sets: &[PlanarSet], common: &Common) -> Result<(), Failure> {
        let format = Format::from_path(path).ok_or_else(|| {
            Failure::new(format!("{}: sets are written as .json; name the file so", path.display()))
        })?;
        let mut staged = StagedFiles::beside(path)?;
        for (number, set) in (1..).zip(sets) {
            let path = super::advect::numbered(path, number);
            staged.write(&path, |out| self.options.write_to(set, out, format, common))?;
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

fn page(answer: &YinInterfaceAnswer) -> String {
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
    text::facts("Interface", &facts)
}
