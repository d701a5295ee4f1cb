//! `coface yin locate`, `sample` and `curvature`: places on and around a boundary.

use super::given::Given;
use super::{SetOptions, Shown, pair, phase_places};
use crate::arguments::Common;
use crate::failure::Failure;
use crate::input;
use crate::output::{is_json, print_json, print_text, write_file, write_json};
use crate::progress::Progress;
use clap::Args;
use coface::answers::answer::{YinBendPlace, YinCurvatureAnswer, YinLocateAnswer, YinSampleAnswer};
use coface::answers::text;
use coface::yin::Sampling;
use serde::Serialize;
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// So many lines are shown of a list.
pub(super) const LISTED: usize = 20;

/// Where points lie of a set: inside, on the boundary or outside, with the nearest point of the boundary and the signed distance.
///
/// Which side a point is on is exact for straight pieces, and certain for others but for points that rounding does not tell from the
/// boundary. Distances are positive inside.
///
#[derive(Args)]
pub(super) struct Locate {
    /// The set, or an interface; - is standard input
    #[arg(value_name = "INPUT")]
    input: PathBuf,
    #[command(flatten)]
    options: SetOptions,
    /// A point: X,Y; may be given several times
    #[arg(long, value_name = "POINT", value_parser = pair, allow_hyphen_values = true)]
    point: Vec<[f64; 2]>,
    /// A file of points, such as .xyz, .csv, .geojson or .wkt: its vertices in their order, the heights of points in space left out
    #[arg(long, value_name = "FILE")]
    points: Option<PathBuf>,
}

/// Points along the boundary of a set, with lengths, directions and curvatures.
///
/// Without options each piece gives 8 points at equally spaced parameters; --count and --spacing give points at equal distances along each
/// curve. At a knot direction and curvature are those of the piece that begins there.
///
/// With -o the points are written, to .csv (curve, piece, parameter, length, x, y, tangent_x, tangent_y, curvature) or .json. With --json:
/// "samples", for each "curve", "piece", "parameter", "length", "point", "tangent", "curvature".
///
/// Of an interface its edges are sampled, each with the phases on its "left" and "right"; those that are not closed give the point at their
/// end too.
#[derive(Args)]
pub(super) struct SampleVerb {
    /// The set, or an interface; - is standard input
    #[arg(value_name = "INPUT")]
    input: PathBuf,
    #[command(flatten)]
    options: SetOptions,
    /// So many points on each piece [default: 8]
    #[arg(long, value_name = "N", conflicts_with_all = ["count", "spacing"])]
    per_piece: Option<usize>,
    /// So many points on each curve, at equal distances along it
    #[arg(long, value_name = "N", conflicts_with = "spacing")]
    count: Option<usize>,
    /// The distance of points along each curve: the greatest that is not above this and fits into the curve a whole number of times
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    spacing: Option<f64>,
}

/// How the curves of a set bend: the least and the greatest curvature of each, and where it turns most at a knot.
///
/// Curvatures are positive where the curve turns left, with the set on its left: a disk has the curvature one over its radius, a hole
/// minus that. For the curvature all along the boundary ask for `coface yin sample`.
///
/// With --json, and with -o FILE.json: "curves", for each "least" and "greatest" (curvatures), "sharpest" (the knot at which it turns most,
/// in degrees) and "roughest" (the same among knots that are no kinks; null if all are), each with "piece", "parameter", "point", "value". Of
/// an interface: "edges", each with "left" and "right" phase, "least", "greatest" and "sharpest".
#[derive(Args)]
pub(super) struct Curvature {
    /// The set, or an interface; - is standard input
    #[arg(value_name = "INPUT")]
    input: PathBuf,
    #[command(flatten)]
    options: SetOptions,
}

/// Refuses pictures and file names that are not for tables.
fn check_output(options: &SetOptions, common: &Common, has_table: bool) -> Result<(), Failure> {
    if options.picture != Shown::Set {
        return Err(Failure::new(
            "--picture draws a set, not places on it: ask for it with `coface yin info`",
        ));
    }
    match common.output.as_deref().filter(|path| !(is_json(path) || has_table && is_table(path))) {
        None => Ok(()),
        Some(path) if has_table => Err(Failure::new(format!(
            "{}: places are written as .csv or .json; name the file so",
            path.display()
        ))),
        Some(path) => Err(Failure::new(format!(
            "{}: curvatures are written as .json; name the file so",
            path.display()
        ))),
    }
}

fn is_table(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("csv"))
}

/// Gives an answer as the command line asks.
fn give(
    answer: &impl Serialize,
    table: impl FnOnce() -> String,
    page: impl FnOnce() -> String,
    common: &Common,
    progress: Progress,
) -> Result<(), Failure> {
    if let Some(path) = &common.output {
        progress.stage("writing");
        match is_json(path) {
            true => write_json(path, answer)?,
            false => write_file(path, table().as_bytes())?,
        }
    }
    drop(progress);
    match (common.json, &common.output) {
        (true, _) => print_json(answer),
        (false, Some(_)) => Ok(()),
        (false, None) => print_text(&page()),
    }
}

impl Locate {
    pub(super) fn run(&self, common: &Common) -> Result<(), Failure> {
        check_output(&self.options, common, true)?;
        let progress = Progress::start(common.quiet);
        let mut points = self.point.clone();
        // One point in the place of a file of points.
        let as_point = |path: &PathBuf| pair(path.to_str()?).ok().filter(|_| !path.exists());
        if let Some(point) = self.points.as_ref().and_then(as_point) {
            points.push(point);
        } else if let Some(path) = &self.points {
            let loaded = input::read(path, common.reading(), &progress)?;
            let positions = loaded.model.positions();
            if positions.dimension() < 2 && !positions.is_empty() {
                return Err(Failure::new(format!(
                    "{}: its points have one coordinate; give a file of points with two",
                    loaded.name
                )));
            }
            let dimension = positions.dimension().max(2);
            points.extend(positions.as_flat().chunks_exact(dimension).map(|point| [point[0], point[1]]));
        }
        if points.is_empty() {
            return Err(Failure::new("there are no points to locate; give --point X,Y, or --points FILE"));
        }
        let (given, name) = (self.options.given(&self.input, common, &progress)?, input::name(&self.input));
        progress.stage("locating");
        match given {
            Given::Set(set) => {
                let answer = set.located(&name, &points)?;
                give(&answer, || located_table(&answer), || located_page(&answer), common, progress)
            }
            Given::Interface(interface) => {
                let answer = interface.located(&name, &points)?;
                let [table, page] = [phase_places::located_table, phase_places::located_page];
                give(&answer, || table(&answer), || page(&answer), common, progress)
            }
        }
    }
}

/// A number of a table; nothing if there is none.
pub(super) fn cell(number: Option<f64>) -> String {
    number.map_or(String::new(), |number| format!("{number:?}"))
}

fn located_table(answer: &YinLocateAnswer) -> String {
    let mut table = "x,y,location,signed_distance,nearest_x,nearest_y,curve,piece,parameter\n".to_owned();
    for found in &answer.points {
        let [x, y] = found.point;
        let whole = |number: Option<usize>| number.map_or(String::new(), |number| number.to_string());
        // Writing to a string does not fail.
        let _ = writeln!(
            table,
            "{x:?},{y:?},{},{},{},{},{},{},{}",
            found.location.word(),
            cell(found.signed_distance),
            cell(found.nearest.map(|[x, _]| x)),
            cell(found.nearest.map(|[_, y]| y)),
            whole(found.curve),
            whole(found.piece),
            cell(found.parameter)
        );
    }
    table
}

pub(super) fn place([x, y]: [f64; 2]) -> String {
    format!("({}, {})", text::number(x), text::number(y))
}

fn located_page(answer: &YinLocateAnswer) -> String {
    let mut facts = vec![
        ("inside".to_owned(), text::grouped(answer.inside), String::new()),
        ("boundary".to_owned(), text::grouped(answer.boundary), String::new()),
        ("outside".to_owned(), text::grouped(answer.outside), String::new()),
    ];
    for (number, found) in answer.points.iter().enumerate().take(LISTED) {
        let label = if number == 0 { "point by point" } else { "" };
        let gloss = match (found.nearest, found.signed_distance) {
            (Some(nearest), Some(distance)) => {
                format!("signed distance {} from {}", text::number(distance), place(nearest))
            }
            _ => "the set has no boundary".to_owned(),
        };
        facts.push((label.to_owned(), format!("{}: {}", place(found.point), found.location.word()), gloss));
    }
    more(&mut facts, answer.points.len());
    text::facts("Location", &facts)
}

/// Says how many are not shown.
pub(super) fn more(facts: &mut Vec<(String, String, String)>, count: usize) {
    if count > LISTED {
        facts.push((String::new(), format!("and {} more", text::grouped(count - LISTED)), String::new()));
    }
}

impl SampleVerb {
    pub(super) fn run(&self, common: &Common) -> Result<(), Failure> {
        check_output(&self.options, common, true)?;
        let sampling = match (self.per_piece, self.count, self.spacing) {
            (_, Some(count), _) => Sampling::PerCurve(count),
            (_, _, Some(spacing)) => Sampling::Spacing(spacing),
            (count, ..) => Sampling::PerPiece(count.unwrap_or(8)),
        };
        let progress = Progress::start(common.quiet);
        let (given, name) = (self.options.given(&self.input, common, &progress)?, input::name(&self.input));
        progress.stage("sampling");
        match given {
            Given::Set(set) => {
                let answer = set.sampled(&name, sampling)?;
                give(&answer, || sample_table(&answer), || sample_page(&answer), common, progress)
            }
            Given::Interface(interface) => {
                let answer = interface.sampled(&name, sampling)?;
                let [table, page] = [phase_places::sample_table, phase_places::sample_page];
                give(&answer, || table(&answer), || page(&answer), common, progress)
            }
        }
    }
}

fn sample_table(answer: &YinSampleAnswer) -> String {
    let mut table = "curve,piece,parameter,length,x,y,tangent_x,tangent_y,curvature\n".to_owned();
    for sample in &answer.samples {
        let [x, y] = sample.point;
        // Writing to a string does not fail.
        let _ = writeln!(
            table,
            "{},{},{:?},{:?},{x:?},{y:?},{},{},{}",
            sample.curve,
            sample.piece,
            sample.parameter,
            sample.length,
            cell(sample.tangent.map(|[x, _]| x)),
            cell(sample.tangent.map(|[_, y]| y)),
            cell(sample.curvature)
        );
    }
    table
}

fn sample_page(answer: &YinSampleAnswer) -> String {
    let mut facts = vec![("points".to_owned(), text::grouped(answer.samples.len()), String::new())];
    for (number, sample) in answer.samples.iter().enumerate().take(LISTED) {
        let label = if number == 0 { "point by point" } else { "" };
        let curvature = sample
            .curvature
            .map_or("no direction".to_owned(), |curvature| format!("curvature {}", text::number(curvature)));
        let gloss = format!("curve {}, length {}, {curvature}", sample.curve, text::number(sample.length));
        facts.push((label.to_owned(), place(sample.point), gloss));
    }
    more(&mut facts, answer.samples.len());
    text::facts("Samples", &facts)
}

impl Curvature {
    pub(super) fn run(&self, common: &Common) -> Result<(), Failure> {
        check_output(&self.options, common, false)?;
        let progress = Progress::start(common.quiet);
        let (given, name) = (self.options.given(&self.input, common, &progress)?, input::name(&self.input));
        progress.stage("measuring");
        match given {
            Given::Set(set) => {
                let answer = set.curvature(&name).map_err(|error| error.in_file(name))?;
                give(&answer, String::new, || curvature_page(&answer), common, progress)
            }
            Given::Interface(interface) => {
                let answer = interface.curvature(&name).map_err(|error| error.in_file(name))?;
                give(&answer, String::new, || phase_places::curvature_page(&answer), common, progress)
            }
        }
    }
}

fn curvature_page(answer: &YinCurvatureAnswer) -> String {
    let at = |found: &YinBendPlace| format!("{} at {}", text::number(found.value), place(found.point));
    let mut facts = Vec::new();
    for bend in answer.curves.iter().take(LISTED) {
        let rough = match &bend.roughest {
            Some(found) => {
                format!("; at most {} degrees where there is no kink", text::number(found.value.abs()))
            }
            None => String::new(),
        };
        facts.push((format!("curve {}", bend.curve), format!("least {}", at(&bend.least)), String::new()));
        facts.push((String::new(), format!("greatest {}", at(&bend.greatest)), String::new()));
        let gloss = format!("degrees, at a knot{rough}");
        facts.push((String::new(), format!("turns {}", at(&bend.sharpest)), gloss));
    }
    more(&mut facts, answer.curves.len());
    text::facts("Curvature", &facts)
}
