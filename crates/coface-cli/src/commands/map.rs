//! `coface map`: maps changed feature by feature.

use super::arrange::{output_target, read_all};
use crate::arguments::{Common, length};
use crate::failure::Failure;
use crate::output::{print_json, print_text};
use crate::progress::Progress;
use crate::remarks::{accept, say_remarks};
use crate::target::{Target, write_seen};
use clap::{Args, Subcommand, ValueEnum};
use coface::answers::answer::{MapAnswer, MapCoverageAnswer, MapRepairAnswer};
use coface::answers::{
    BufferCaps, BufferJoins, BufferOptions, LineOptions, MapResult, MapTask, RepairMethod, text,
};
use coface::io::{Model, replace_file};
use std::path::PathBuf;

/// Maps in the plane: repair, buffer, clip, node, polygonize, simplify, and check coverages.
///
/// Inputs are drawings: WKT, WKB, GeoJSON and others. Features keep their order, properties and ids; what need not change keeps its
/// coordinates. What is cut is cut exactly, then rounded so that it is valid. With -o the new map is written, in the reference system of the inputs.
///
/// With --json: "task", "counts" (features, polygons, holes, lines, points, vertices), "measure" (area), "length" (of lines), and what the
/// task adds: "repair", "arcs", "left_out", "simplification" or "coverage".
#[derive(Args)]
pub(crate) struct MapVerb {
    #[command(subcommand)]
    task: Task,
}

#[derive(Subcommand)]
enum Task {
    Repair(Repair),
    Buffer(Buffer),
    Clip(Clip),
    Node(Node),
    Polygonize(Polygonize),
    Simplify(Simplify),
    Coverage(Coverage),
}

/// Make polygons valid, and turn rings as RFC 7946 has them: outer ones counterclockwise, holes clockwise
#[derive(Args)]
struct Repair {
    #[command(flatten)]
    inputs: Inputs,
    /// What is inside of a polygon that is not valid, as GEOS names it
    #[arg(long, value_name = "METHOD", default_value = "structure")]
    method: Method,
}

/// What is at most a distance away from each feature; for a negative distance, what is inside and at least so far from the border
#[derive(Args)]
struct Buffer {
    #[command(flatten)]
    inputs: Inputs,
    /// The distance, in the unit of the map
    #[arg(long, value_name = "R", allow_negative_numbers = true)]
    distance: f64,
    /// How far flattened arcs may be from true ones, in the unit of the map [default: a thousandth of the distance]
    #[arg(long, value_name = "E")]
    error: Option<f64>,
    /// How corners are joined
    #[arg(long, value_name = "HOW", default_value = "round")]
    joins: Joins,
    /// With --joins mitre: how many times the distance a corner may be away; beyond it is cut off
    #[arg(long, value_name = "RATIO", default_value = "5")]
    mitre_limit: f64,
    /// How the ends of lines are closed; around points: a disk, nothing or a square
    #[arg(long, value_name = "HOW", default_value = "round")]
    caps: Caps,
}

/// What of each feature is in a box along the axes
#[derive(Args)]
struct Clip {
    #[command(flatten)]
    inputs: Inputs,
    /// The box: least x, least y, greatest x, greatest y
    #[arg(long = "box", value_name = "X,Y,X,Y", allow_hyphen_values = true, value_parser = frame)]
    frame: [f64; 4],
}

/// Cut all lines and rings where they meet: each piece between two meetings is a line; what several run along is there once
#[derive(Args)]
struct Node {
    #[command(flatten)]
    inputs: Inputs,
    #[command(flatten)]
    nearness: Nearness,
}

/// The faces that lines and rings bound, cut where they meet: each is a polygon, with holes
#[derive(Args)]
struct Polygonize {
    #[command(flatten)]
    inputs: Inputs,
    #[command(flatten)]
    nearness: Nearness,
}

/// Leave out vertices of borders and lines: common borders stay common, nothing crosses, vanishes or changes sides
#[derive(Args)]
struct Simplify {
    #[command(flatten)]
    inputs: Inputs,
    /// How far a border may be from where it was, in the unit of the map
    #[arg(long, value_name = "R")]
    tolerance: f64,
}

/// Gaps and overlaps of polygons that should cover an area; -o writes the sides that do not fit those of their neighbors
#[derive(Args)]
struct Coverage {
    #[command(flatten)]
    inputs: Inputs,
    /// Gaps up to this width are faults, in the unit of the map [default: none is]
    #[arg(long, value_name = "W")]
    gap_width: Option<f64>,
}

/// How near lines must be to meet.
#[derive(Args)]
struct Nearness {
    /// Round coordinates and cut again until all vertices are where their coordinates say
    #[arg(long)]
    snap: bool,
    /// Put all vertices on the grid with this step, in the unit of the map: coordinates are multiples of R
    #[arg(long, value_name = "R", allow_negative_numbers = true, value_parser = length)]
    grid: Option<f64>,
    /// Put vertices and lines together that are at most R apart, in the unit of the map
    #[arg(long, value_name = "R", conflicts_with = "grid", allow_negative_numbers = true, value_parser = length)]
    tolerance: Option<f64>,
}

impl Nearness {
    fn options(&self) -> LineOptions {
        LineOptions::new().snap(self.snap).grid(self.grid).tolerance(self.tolerance)
    }
}

#[derive(Args)]
struct Inputs {
    /// The maps; - is standard input
    #[arg(required = true, value_name = "INPUT")]
    inputs: Vec<PathBuf>,
}

/// How a polygon is repaired.
#[derive(Clone, Copy, ValueEnum)]
pub(crate) enum Method {
    /// Outer rings minus holes; a hole outside of its outer ring is a polygon
    Structure,
    /// What lies behind an odd number of lines
    Linework,
}

impl Method {
    pub(crate) fn method(self) -> RepairMethod {
        match self {
            Self::Structure => RepairMethod::Structure,
            Self::Linework => RepairMethod::Linework,
        }
    }
}

#[derive(Clone, Copy, ValueEnum)]
enum Joins {
    Round,
    Mitre,
    Bevel,
}

#[derive(Clone, Copy, ValueEnum)]
enum Caps {
    Round,
    Flat,
    Square,
}

/// Four numbers with commas between them.
fn frame(text: &str) -> Result<[f64; 4], String> {
    let numbers: Option<Vec<f64>> = text.split(',').map(|number| number.trim().parse().ok()).collect();
    numbers
        .and_then(|numbers| numbers.try_into().ok())
        .ok_or_else(|| "give four numbers with commas between them, like 0,0,10,5".to_owned())
}

impl MapVerb {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        let (inputs, task) = self.task.parts();
        let output = output_target(common)?;
        let progress = Progress::start(common.quiet);
        let models = read_all(&inputs.inputs, common, &progress)?;
        progress.stage(self.task.stage());
        let result = MapResult::new(borrowed(&models), &task)?;
        let mut answer = result.answer().clone();
        accept(&answer.remarks, common)?;
        progress.stage("writing");
        match output {
            Some((path, Target::Model(format))) => {
                answer.remarks.extend(result.losses(format));
                replace_file(path, |out| result.write(out, format))?;
            }
            Some((path, Target::Seen(seen))) => write_seen(path, result.model(), seen)?,
            None => {}
        }
        drop(progress);
        say_remarks(&answer.remarks, common);
        if common.json {
            return print_json(&answer);
        }
        if common.output.is_some() {
            return Ok(());
        }
        print_text(&page(&answer))
    }
}

fn borrowed(models: &[(String, Model)]) -> impl Iterator<Item = (&str, &Model)> {
    models.iter().map(|(name, model)| (name.as_str(), model))
}

impl Task {
    fn parts(&self) -> (&Inputs, MapTask) {
        match self {
            Self::Repair(verb) => (&verb.inputs, MapTask::Repair(verb.method.method())),
            Self::Buffer(verb) => (&verb.inputs, MapTask::Buffer(verb.options())),
            Self::Clip(verb) => (&verb.inputs, MapTask::Clip(verb.frame)),
            Self::Node(verb) => (&verb.inputs, MapTask::Node(verb.nearness.options())),
            Self::Polygonize(verb) => (&verb.inputs, MapTask::Polygonize(verb.nearness.options())),
            Self::Simplify(verb) => (&verb.inputs, MapTask::Simplify(verb.tolerance)),
            Self::Coverage(verb) => (&verb.inputs, MapTask::Coverage { gap_width: verb.gap_width }),
        }
    }

    fn stage(&self) -> &'static str {
        match self {
            Self::Repair(_) => "repairing",
            Self::Buffer(_) => "buffering",
            Self::Clip(_) => "clipping",
            Self::Node(_) | Self::Polygonize(_) => "arranging",
            Self::Simplify(_) => "simplifying",
            Self::Coverage(_) => "examining",
        }
    }
}

impl Buffer {
    fn options(&self) -> BufferOptions {
        let options = BufferOptions::new(self.distance)
            .joins(match self.joins {
                Joins::Round => BufferJoins::Round,
                Joins::Mitre => BufferJoins::Mitre(self.mitre_limit),
                Joins::Bevel => BufferJoins::Bevel,
            })
            .caps(match self.caps {
                Caps::Round => BufferCaps::Round,
                Caps::Flat => BufferCaps::Flat,
                Caps::Square => BufferCaps::Square,
            });
        self.error.map_or(options, |error| options.error(error))
    }
}

/// Facts about a repair.
pub(crate) fn repair_facts(repair: &MapRepairAnswer) -> Vec<(String, String, String)> {
    let fact = |label: &str, value: String, gloss: &str| (label.to_owned(), value, gloss.to_owned());
    let mut facts = vec![
        fact("method", repair.method.clone(), ""),
        fact("made valid", text::count(repair.features, "feature"), ""),
    ];
    for fault in &repair.faults {
        facts.push(fact("", fault.reason.clone(), &fault.message));
    }
    if repair.features > 0 {
        facts.push(fact(
            "area before",
            text::number(repair.area_before),
            "outer rings minus holes, as drawn",
        ));
        facts.push(fact("area now", text::number(repair.area), ""));
        let gloss = "inside now and not enclosed an odd number of times before, or the other way around";
        facts.push(fact("area changed", text::number(repair.area_changed), gloss));
    }
    facts.push(fact("rings reversed", text::grouped(repair.rings_turned), "of valid polygons (RFC 7946)"));
    facts
}

fn page(answer: &MapAnswer) -> String {
    let mut facts = Vec::new();
    let mut fact = |label: &str, value: String, gloss: String| facts.push((label.to_owned(), value, gloss));
    let counts = &answer.counts;
    let is_examined = answer.coverage.is_some();
    if let Some(coverage) = &answer.coverage {
        let MapCoverageAnswer { overlaps, gaps, .. } = coverage;
        let verdict = if coverage.valid { "yes" } else { "no" };
        fact("a coverage", verdict.to_owned(), String::new());
        fact("sides that do not fit", text::grouped(coverage.invalid_edges), String::new());
        fact("overlaps", text::grouped(overlaps.len()), String::new());
        for overlap in overlaps.iter().take(LISTED) {
            let [x, y] = overlap.point;
            let features = listed(&overlap.features);
            fact("", text::number(overlap.area), format!("area of features {features} at ({x}, {y})"));
        }
        fact("gaps", text::grouped(gaps.len()), String::new());
        for gap in gaps.iter().take(LISTED) {
            let ([x, y], features) = (gap.point, listed(&gap.features));
            let width = text::number(gap.width);
            let gloss = format!("area between features {features} at ({x}, {y}), width {width}");
            fact("", text::number(gap.area), gloss);
        }
    } else {
        fact("features", text::grouped(counts.features), String::new());
        fact("polygons", text::grouped(counts.polygons), text::count(counts.holes, "hole"));
        fact("area", text::number(answer.measure), String::new());
        if counts.lines > 0 {
            fact("lines", text::grouped(counts.lines), format!("length {}", text::number(answer.length)));
        }
        if counts.points > 0 {
            fact("points", text::grouped(counts.points), String::new());
        }
        fact("vertices", text::grouped(counts.vertices), String::new());
    }
    if let Some(arcs) = &answer.arcs {
        fact(
            "arcs",
            format!("within {}", text::number(arcs.error)),
            format!("{} sides a circle", arcs.sides),
        );
    }
    if let Some(left_out) = &answer.left_out {
        fact("dangles", text::grouped(left_out.dangles), "edges that hang on the rest".to_owned());
        let gloss = "other edges with one face on both sides".to_owned();
        fact("cut edges", text::grouped(left_out.cut_edges), gloss);
    }
    if let Some(simpler) = &answer.simplification {
        let gloss = format!("of {} different ones", text::grouped(simpler.vertices_before));
        fact("kept", text::grouped(simpler.vertices), gloss);
        let gloss = format!("allowed {}", text::number(simpler.tolerance));
        fact("largest distance", text::number(simpler.largest_distance), gloss);
    }
    if let Some(repair) = &answer.repair {
        facts.extend(repair_facts(repair));
    }
    let title = if is_examined { "Coverage".to_owned() } else { format!("Map after {}", answer.task) };
    text::facts(&title, &facts)
}

/// How many gaps and overlaps the page lists.
const LISTED: usize = 10;

fn listed(features: &[u32]) -> String {
    features.iter().map(u32::to_string).collect::<Vec<_>>().join(", ")
}
