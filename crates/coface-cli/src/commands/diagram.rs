//! `coface diagram`: persistence diagrams as data.

use crate::arguments::Common;
use crate::failure::Failure;
use crate::input::{self, Source};
use crate::output::{give, print_json, print_text, write_file};
use crate::progress::Progress;
use crate::remarks::say_remarks;
use crate::written::Written;
use clap::{Args, Subcommand, ValueEnum};
use coface::algebra::escaped;
use coface::answers::answer::{
    DegreeDistance, DiagramCurvesAnswer, DiagramDistanceAnswer, DiagramImageAnswer,
};
use coface::answers::{
    CurveValues, DiagramCurveKind, DiagramCurvesRequest, DiagramDistanceRequest, DiagramImageRequest,
    DiagramMetric, GivenDiagram, text,
};
use coface::io::NumberTable;
use serde::Serialize;
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Persistence diagrams as data: distances of two, and one as curves or an image.
///
/// A diagram is a file that `coface persistence` writes (.json, .csv, .pers, .txt), one of GUDHI or Ripser, a .npy array of births and
/// deaths, or a table with the columns birth, death and, behind them, the degree; a first line of words may name the columns. The death of a class
/// that never dies is inf.
///
/// With -o curves and images are written as .csv, .npy or .json.
#[derive(Args)]
pub(crate) struct Diagram {
    #[command(subcommand)]
    task: Task,
}

#[derive(Subcommand)]
enum Task {
    Distance(Distance),
    /// Betti curves: how many classes of each degree live at a value
    Betti(Steps),
    /// The Euler characteristic curve: the alternating sum of the numbers of classes that live at a value
    Euler(Steps),
    /// Persistence landscapes: at each value the highest tents over the intervals of births and deaths
    Landscape(Landscape),
    /// Silhouettes: the mean of the tents over the intervals, weighted by a power of their lengths
    Silhouette(Silhouette),
    Image(Image),
}

/// How far two diagrams are from each other: the bottleneck or a Wasserstein distance
///
/// Classes are matched with classes of their degree or with the diagonal. The distance of all degrees together is the greatest one, of the Wasserstein
/// distance the root of the sum of powers. It is infinite if the numbers of classes that never die differ.
///
/// The bottleneck distance is exact. A Wasserstein distance is exact but for rounding: "lower_bound" of --json is a proof of how near it is.
#[derive(Args)]
struct Distance {
    /// The first diagram; - is standard input
    #[arg(value_name = "A")]
    first: PathBuf,
    /// The second diagram
    #[arg(value_name = "B")]
    second: PathBuf,
    /// Which distance
    #[arg(long, value_name = "METRIC", default_value = "bottleneck")]
    metric: Metric,
    /// The order of a Wasserstein distance, from 1 on [default: 1]
    #[arg(long, value_name = "Q", value_parser = number)]
    order: Option<f64>,
    /// The exponent of the norm that measures a pair of a Wasserstein distance, from 1 on, or inf [default: inf]
    #[arg(long, value_name = "P", value_parser = number)]
    internal_p: Option<f64>,
    /// The classes of this degree alone
    #[arg(long, value_name = "K")]
    degree: Option<u8>,
    /// Give the matched pairs with --json: the places of classes in their files, null for the diagonal
    #[arg(long)]
    matching: bool,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Metric {
    /// The longest pair, as short as possible
    Bottleneck,
    /// The root of the sum of powers of the lengths of pairs
    Wasserstein,
}

/// The diagram of curves and images.
#[derive(Args)]
struct One {
    /// The diagram; - is standard input
    #[arg(value_name = "INPUT")]
    input: PathBuf,
    /// Let classes that never die, die at T
    #[arg(long, value_name = "T", allow_negative_numbers = true, value_parser = finite)]
    end: Option<f64>,
}

/// At which values curves are given.
#[derive(Args)]
pub(super) struct Values {
    /// At N values, evenly
    #[arg(long, value_name = "N")]
    samples: Option<usize>,
    /// From the value A to the value B [default: from the least to the greatest at which something changes]
    #[arg(long, value_names = ["A", "B"], num_args = 2, allow_negative_numbers = true, value_parser = finite)]
    range: Option<Vec<f64>>,
}

impl Values {
    /// What is asked for; `None` where the command line says nothing.
    pub(super) fn asked(&self) -> Option<CurveValues> {
        let range = self.range.as_deref().and_then(|range| range.try_into().ok());
        let is_given = self.samples.is_some() || range.is_some();
        is_given.then(|| CurveValues::Even { count: self.samples.unwrap_or(100), range })
    }
}

/// Curves that are steps: without --samples and --range they are given at all births and deaths, where they change.
#[derive(Args)]
struct Steps {
    #[command(flatten)]
    one: One,
    /// The classes of this degree alone; the Euler characteristic is of all
    #[arg(long, value_name = "K")]
    degree: Option<u8>,
    #[command(flatten)]
    values: Values,
}

#[derive(Args)]
struct Landscape {
    #[command(flatten)]
    one: One,
    /// The classes of this degree alone
    #[arg(long, value_name = "K")]
    degree: Option<u8>,
    /// How many landscapes of each degree
    #[arg(long, value_name = "N", default_value = "5")]
    count: usize,
    #[command(flatten)]
    values: Values,
}

#[derive(Args)]
struct Silhouette {
    #[command(flatten)]
    one: One,
    /// The classes of this degree alone
    #[arg(long, value_name = "K")]
    degree: Option<u8>,
    /// The power of the persistence that is the weight of a class
    #[arg(long, value_name = "P", default_value = "1", allow_negative_numbers = true, value_parser = finite)]
    power: f64,
    #[command(flatten)]
    values: Values,
}

/// The persistence image of a degree: pixels over births and persistences, with a normal distribution around each class
///
/// Each class has the weight of a power of its persistence; a pixel is the volume over it (Adams et al., 2017). The rows of --json and .npy run from
/// the shortest persistence on, births run in a row; .csv has a line a pixel.
#[derive(Args)]
struct Image {
    #[command(flatten)]
    one: One,
    /// The classes of this degree
    #[arg(long, value_name = "K", default_value = "1")]
    degree: u8,
    /// The numbers of pixels in the direction of births and of persistences
    #[arg(long, value_names = ["W", "H"], num_args = 2, default_values = ["20", "20"])]
    resolution: Vec<usize>,
    /// From the birth A to the birth B [default: those of the classes]
    #[arg(long, value_names = ["A", "B"], num_args = 2, allow_negative_numbers = true, value_parser = finite)]
    births: Option<Vec<f64>>,
    /// From the persistence A to the persistence B [default: from 0 to the greatest]
    #[arg(long, value_names = ["A", "B"], num_args = 2, allow_negative_numbers = true, value_parser = finite)]
    persistences: Option<Vec<f64>>,
    /// The standard deviation around a class [default: the longer side of a pixel]
    #[arg(long, value_name = "S", value_parser = finite)]
    bandwidth: Option<f64>,
    /// The power of the persistence that is the weight of a class
    #[arg(long, value_name = "P", default_value = "1", allow_negative_numbers = true, value_parser = finite)]
    power: f64,
}

fn number(text: &str) -> Result<f64, String> {
    text.parse().ok().filter(|number: &f64| !number.is_nan()).ok_or_else(|| "not a number".to_owned())
}

pub(super) fn finite(text: &str) -> Result<f64, String> {
    number(text).ok().filter(|number| number.is_finite()).ok_or_else(|| "not a finite number".to_owned())
}

impl Diagram {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        let curves = |kind, one: &One, degree: Option<u8>, values: &Values| {
            give_curves(common, kind, one, degree, values)
        };
        match &self.task {
            Task::Distance(distance) => distance.run(common),
            Task::Betti(one) => curves(DiagramCurveKind::Betti, &one.one, one.degree, &one.values),
            Task::Euler(one) => curves(DiagramCurveKind::Euler, &one.one, one.degree, &one.values),
            Task::Landscape(one) => {
                curves(DiagramCurveKind::Landscape(one.count), &one.one, one.degree, &one.values)
            }
            Task::Silhouette(one) => {
                curves(DiagramCurveKind::Silhouette(one.power), &one.one, one.degree, &one.values)
            }
            Task::Image(image) => image.run(common),
        }
    }
}

/// Reads a diagram.
fn read(path: &Path) -> Result<GivenDiagram, Failure> {
    let name = input::name(path);
    let bytes = match Source::of(path)? {
        Source::File(path) => {
            std::fs::read(path).map_err(|error| coface::Error::from(error).in_file(name.clone()))?
        }
        Source::Bytes(bytes) => bytes.to_vec(),
    };
    Ok(GivenDiagram::read(&name, &bytes)?)
}

impl Distance {
    fn run(&self, common: &Common) -> Result<(), Failure> {
        let metric = match self.metric {
            Metric::Wasserstein => DiagramMetric::Wasserstein {
                order: self.order.unwrap_or(1.0),
                internal_p: self.internal_p.unwrap_or(f64::INFINITY),
            },
            Metric::Bottleneck => {
                let given = [("--order", self.order.is_some()), ("--internal-p", self.internal_p.is_some())];
                if let Some((option, _)) = given.into_iter().find(|&(_, is_given)| is_given) {
                    return Err(Failure::new(format!(
                        "{option} is for Wasserstein distances; say --metric wasserstein"
                    )));
                }
                DiagramMetric::Bottleneck
            }
        };
        Written::Answer.check_output(common)?;
        let progress = Progress::start(common.quiet);
        progress.stage("reading");
        let (first, second) = (read(&self.first)?, read(&self.second)?);
        progress.stage("matching");
        let request = DiagramDistanceRequest::new().metric(metric).matching(self.matching);
        let answer = request.degree(self.degree.map(usize::from)).answer(&first, &second)?;
        drop(progress);
        say_remarks(&answer.remarks, common);
        give(common, &answer, &distance_page(&answer))
    }
}

fn distance_page(answer: &DiagramDistanceAnswer) -> String {
    let [first, second] = &answer.files;
    let fact = |label: String, value: String, gloss: String| (label, value, gloss);
    let shown =
        |distance: Option<f64>| distance.map_or("infinite".to_owned(), |distance| distance.to_string());
    let mut facts: Vec<_> = answer
        .degrees
        .iter()
        .map(|degree: &DegreeDistance| {
            let [a, b] = degree.essential;
            let gloss = match degree.distance {
                None if a == b => {
                    "classes that never die, here while values rise and there while they fall".to_owned()
                }
                None if a == 1 => format!("1 class that never dies against {b}"),
                None => format!("{} that never die against {b}", text::count(a, "class")),
                Some(_) => String::new(),
            };
            fact(format!("degree {}", degree.degree), shown(degree.distance), gloss)
        })
        .collect();
    let metric = match answer.order {
        Some(order) => {
            let p = answer.internal_p.map_or("inf".to_owned(), |p| p.to_string());
            format!("order {order}, internal p {p}")
        }
        None => String::new(),
    };
    facts.push(fact("distance".to_owned(), shown(answer.distance), metric));
    let title = format!("{} distance of {} and {}", answer.metric, escaped(first), escaped(second));
    text::facts(&title, &facts)
}

fn give_curves(
    common: &Common,
    kind: DiagramCurveKind,
    one: &One,
    degree: Option<u8>,
    values: &Values,
) -> Result<(), Failure> {
    let output = table_output(common)?;
    let diagram = read(&one.input)?;
    let mut request = DiagramCurvesRequest::new(kind).degree(degree.map(usize::from)).end(one.end);
    if let Some(values) = values.asked() {
        request = request.values(values);
    }
    let answer = request.answer(&diagram).map_err(|error| error.in_file(diagram.name().to_owned()))?;
    say_remarks(&answer.remarks, common);
    give_table(common, output, &answer, || answer.csv(), || answer.table(), || curves_page(&answer))
}

/// How many values the page for people lists.
pub(super) const LISTED: usize = 20;

fn curves_page(answer: &DiagramCurvesAnswer) -> String {
    let mut page = format!("  {} of {}\n\n", answer.kind, escaped(&answer.file));
    for curve in &answer.curves {
        // Writing to a string does not fail.
        let _ = writeln!(page, "    {}", curve.name);
        let step = answer.values.len().div_ceil(LISTED).max(1);
        for (value, number) in answer.values.iter().zip(&curve.numbers).step_by(step) {
            let _ = writeln!(page, "      at {value}: {number}");
        }
    }
    if answer.values.len() > LISTED {
        page.push_str("    all values with -o or --json\n");
    }
    page
}

impl Image {
    fn run(&self, common: &Common) -> Result<(), Failure> {
        let output = table_output(common)?;
        let diagram = read(&self.one.input)?;
        let pair = |range: &Option<Vec<f64>>| range.as_deref().and_then(|range| range.try_into().ok());
        let request = DiagramImageRequest::new(self.degree.into())
            .resolution([self.resolution[0], self.resolution[1]])
            .births(pair(&self.births))
            .persistences(pair(&self.persistences))
            .bandwidth(self.bandwidth)
            .power(self.power)
            .end(self.one.end);
        let answer = request.answer(&diagram).map_err(|error| error.in_file(diagram.name().to_owned()))?;
        say_remarks(&answer.remarks, common);
        let table = || NumberTable::from_rows(&answer.rows);
        give_table(common, output, &answer, || image_csv(&answer), table, || image_page(&answer))
    }
}

/// A line for each pixel: the middle of its births and persistences, and its number.
fn image_csv(answer: &DiagramImageAnswer) -> String {
    let mut lines = "birth,persistence,pixel\n".to_owned();
    let middle = |[low, high]: [f64; 2], place: usize, count: usize| {
        low + (high - low) * ((place as f64 + 0.5) / count as f64)
    };
    for (y, row) in answer.rows.iter().enumerate() {
        for (x, pixel) in row.iter().enumerate() {
            let birth = middle(answer.births, x, row.len());
            let persistence = middle(answer.persistences, y, answer.rows.len());
            let _ = writeln!(lines, "{birth},{persistence},{pixel}");
        }
    }
    lines
}

fn image_page(answer: &DiagramImageAnswer) -> String {
    let range = |[low, high]: [f64; 2]| format!("{low} to {high}");
    let width = answer.rows.first().map_or(0, Vec::len);
    let greatest = answer.rows.iter().flatten().copied().fold(0.0, f64::max);
    let facts = [
        (
            "pixels",
            format!("{width} x {}", answer.rows.len()),
            "births x persistences; all with -o or --json",
        ),
        ("births", range(answer.births), ""),
        ("persistences", range(answer.persistences), ""),
        ("bandwidth", answer.bandwidth.to_string(), ""),
        ("greatest pixel", greatest.to_string(), ""),
    ];
    let facts = facts.map(|(label, value, gloss)| (label.to_owned(), value, gloss.to_owned()));
    text::facts(&format!("persistence image of {}, degree {}", escaped(&answer.file), answer.degree), &facts)
}

/// The form of the file of curves and images.
#[derive(Clone, Copy)]
pub(super) enum TableOutput {
    Csv,
    Npy,
    Json,
}

/// The form that -o asks for.
pub(super) fn table_output(common: &Common) -> Result<Option<TableOutput>, Failure> {
    let Some(path) = &common.output else { return Ok(None) };
    let extension = path.extension().and_then(|extension| extension.to_str()).unwrap_or("");
    match extension.to_ascii_lowercase().as_str() {
        "csv" => Ok(Some(TableOutput::Csv)),
        "npy" => Ok(Some(TableOutput::Npy)),
        "json" => Ok(Some(TableOutput::Json)),
        _ => Err(Failure::new(format!(
            "{}: curves and images are written as .csv, .npy or .json; name the file so",
            path.display()
        ))),
    }
}

/// Gives curves or an image as the command line asks.
pub(super) fn give_table(
    common: &Common,
    output: Option<TableOutput>,
    answer: &impl Serialize,
    csv: impl FnOnce() -> String,
    table: impl FnOnce() -> NumberTable,
    page: impl FnOnce() -> String,
) -> Result<(), Failure> {
    match (output, &common.output) {
        (Some(TableOutput::Csv), Some(path)) => write_file(path, csv().as_bytes())?,
        (Some(TableOutput::Npy), Some(path)) => {
            let mut bytes = Vec::new();
            table().write_npy(&mut bytes)?;
            write_file(path, &bytes)?;
        }
        (Some(TableOutput::Json), _) => return give(common, answer, ""),
        _ if !common.json => return print_text(&page()),
        _ => {}
    }
    if common.json { print_json(answer) } else { Ok(()) }
}
