//! `coface yin compare`: how far two sets are apart.

use super::{SetOptions, Shown, given, phase_places};
use crate::arguments::Common;
use crate::failure::Failure;
use crate::input;
use crate::output::{is_json, print_json, print_text, write_json};
use crate::progress::Progress;
use crate::remarks::say_remarks;
use clap::Args;
use coface::answers::answer::{YinComparisonAnswer, YinSeriesAnswer};
use coface::answers::{PlanarSet, text};
use coface::geometry::Angle;
use serde::Serialize;
use std::path::PathBuf;

/// How far two sets are apart: the area of their symmetric difference, right to about 1e-14 of the box around both.
///
/// Nothing is decided about how the curves cross, so no resolution limits it: sets that differ by 1e-11 of their size are told apart, and
/// parts of curves that run along each other do no harm.
///
/// With --json, and with -o FILE.json: "area_xor" (null if it is infinite), "area_xor_error" (an estimate from above), "area_signed" (the
/// first less the second), "area_signed_error", "hausdorff" (the greatest distance of a point of one boundary from the other),
/// "along_normals" (the greatest distance along the normals of the first boundary), "curvature" (the greatest difference of curvatures where
/// these normals meet the second), each with its "_error", "normals_left_out" (the part of the first boundary whose normals do not meet the
/// second within twice the Hausdorff distance), "components" and "holes" of both.
///
/// Two interfaces are compared phase by phase, namesakes with each other: "phases", each with "numbers" and the keys above, "area_xor" (the
/// sum of theirs), "area_xor_error", and "junctions" of both.
///
/// With --exact the sets are compared with a shape instead of a last file; with --series any number of them, one after the other: a table
/// of convergence with the rates at which areas and distances fall with the mean distance of knots. With --json: "reference", "rows" (each
/// with "file", "knots", "spacing", the keys above, "area_rate", "hausdorff_rate" and "curvature_rate").
#[derive(Args)]
pub(super) struct Compare {
    /// The two sets, or those of a series and the one that they come near; - is standard input
    #[arg(required = true, value_name = "INPUT")]
    inputs: Vec<PathBuf>,
    #[command(flatten)]
    options: SetOptions,
    /// Compare with a shape, right to rounding: circle:X,Y,RADIUS, ellipse:X,Y,A,B,DEGREES with half axes A and B, or the curve of two
    /// expressions of t from 0 to 2*pi, as in "function:2*cos(t); sin(t)", with the words of `coface yin advect --velocity`
    #[arg(long, value_name = "SHAPE", value_parser = shape)]
    exact: Option<Shape>,
    /// Compare any number of sets, each with the last one or with --exact, in a table with rates
    #[arg(long)]
    series: bool,
}

/// A shape as the command line names it.
#[derive(Clone)]
struct Shape {
    name: String,
    outline: Outline,
}

#[derive(Clone)]
enum Outline {
    Ellipse { center: [f64; 2], half_axes: [f64; 2], degrees: f64 },
    Function(String),
}

fn shape(text: &str) -> Result<Shape, String> {
    let fault = || {
        format!(
            "\"{text}\" is no shape: write circle:X,Y,RADIUS or ellipse:X,Y,A,B[,DEGREES] with positive lengths, or function:X(t); Y(t)"
        )
    };
    let (kind, numbers) = text.split_once(':').ok_or_else(fault)?;
    if kind == "function" {
        return Ok(Shape { name: text.to_owned(), outline: Outline::Function(numbers.to_owned()) });
    }
    let numbers: Option<Vec<f64>> =
        numbers.split(',').map(|word| word.trim().parse().ok().filter(|x: &f64| x.is_finite())).collect();
    let (center, half_axes, degrees) = match (kind, numbers.ok_or_else(fault)?.as_slice()) {
        ("circle", &[x, y, radius]) => ([x, y], [radius; 2], 0.0),
        ("ellipse", &[x, y, a, b]) => ([x, y], [a, b], 0.0),
        ("ellipse", &[x, y, a, b, degrees]) => ([x, y], [a, b], degrees),
        _ => return Err(fault()),
    };
    if half_axes.iter().any(|axis| *axis <= 0.0) {
        return Err(fault());
    }
    Ok(Shape { name: text.to_owned(), outline: Outline::Ellipse { center, half_axes, degrees } })
}

impl Shape {
    fn set(&self) -> Result<PlanarSet, Failure> {
        match &self.outline {
            Outline::Ellipse { center, half_axes, degrees } => {
                Ok(PlanarSet::ellipse(*center, *half_axes, Angle::degrees(*degrees)?)?)
            }
            Outline::Function(text) => {
                let found = PlanarSet::function(text);
                found.map_err(|error| Failure::new(format!("--exact: {error}")))
            }
        }
    }
}

impl Compare {
    pub(super) fn run(&self, common: &Common) -> Result<(), Failure> {
        if self.options.picture != Shown::Set {
            return Err(Failure::new(
                "--picture draws a set, not a comparison: ask for it with `coface yin xor`",
            ));
        }
        if let Some(path) = common.output.as_deref().filter(|path| !is_json(path)) {
            return Err(Failure::new(format!(
                "{}: a comparison is written as .json; name the file so",
                path.display()
            )));
        }
        let (count, files) = (self.inputs.len() + usize::from(self.exact.is_some()), self.inputs.len());
        if count < 2 {
            return Err(Failure::new(
                "there is one set; give another one, or a shape with --exact circle:X,Y,RADIUS",
            ));
        }
        if count > 2 && !self.series {
            let what = if self.exact.is_some() { " and a shape" } else { "" };
            return Err(Failure::new(format!(
                "there are {files} sets{what}; give two, or compare all with the last one in a table: --series"
            )));
        }
        let progress = Progress::start(common.quiet);
        if let [first, second] = &self.inputs[..]
            && !self.series
            && let (Some(a), Some(b)) = (given::interface(first)?, given::interface(second)?)
        {
            let names = [first, second].map(|path| input::name(path));
            [first, second].iter().try_for_each(|path| self.options.check_interface(path))?;
            progress.stage("comparing");
            let answer = a.compared_with(&names[0], &b, &names[1])?;
            return give(&answer, || phase_places::comparison_page(&answer), common, progress);
        }
        let mut sets = Vec::with_capacity(count);
        for path in &self.inputs {
            sets.push((input::name(path), self.options.read(path, common, false, &progress)?));
        }
        if let Some(shape) = &self.exact {
            let set = shape.set()?;
            say_remarks(set.remarks(), common);
            sets.push((shape.name.clone(), set));
        }
        progress.stage("comparing");
        let (reference, last) = sets.pop().expect("there are two sets at least");
        if self.series {
            let answer = last.series(&reference, &sets)?;
            return give(&answer, || table(&answer), common, progress);
        }
        let (name, first) = &sets[0];
        let answer = first.compared_with(name, &last, &reference)?;
        give(&answer, || page(&answer), common, progress)
    }
}

/// Gives an answer as the command line asks.
fn give(
    answer: &impl Serialize,
    page: impl FnOnce() -> String,
    common: &Common,
    progress: Progress,
) -> Result<(), Failure> {
    if let Some(path) = &common.output {
        write_json(path, answer)?;
    }
    drop(progress);
    match (common.json, &common.output) {
        (true, _) => print_json(answer),
        (false, Some(_)) => Ok(()),
        (false, None) => print_text(&page()),
    }
}

/// The table of a series.
fn table(answer: &YinSeriesAnswer) -> String {
    let real = |number: Option<f64>| number.map_or("infinite".to_owned(), |number| text::rounded(number, 3));
    let rate = |rate: Option<f64>| rate.map_or("-".to_owned(), |rate| format!("{rate:.2}"));
    let titles =
        ["set", "knots", "area of xor", "off by at most", "rate", "Hausdorff", "rate", "curvature", "rate"];
    let mut rows = vec![titles.map(str::to_owned).to_vec()];
    rows.extend(answer.rows.iter().map(|row| {
        vec![
            row.file.clone(),
            text::grouped(row.knots),
            real(row.area_xor),
            text::rounded(row.area_xor_error, 1),
            rate(row.area_rate),
            real(row.hausdorff),
            rate(row.hausdorff_rate),
            row.curvature.map_or("-".to_owned(), |apart| text::rounded(apart, 3)),
            rate(row.curvature_rate),
        ]
    }));
    let widths: Vec<usize> =
        (0..titles.len()).map(|k| rows.iter().map(|row| row[k].chars().count()).max().unwrap_or(0)).collect();
    let mut page = format!("  Compared with {}\n", answer.reference);
    for row in rows {
        let cells = row.iter().zip(&widths).enumerate().map(|(k, (cell, &width))| match k {
            0 => format!("  {cell:<width$}"),
            _ => format!("  {cell:>width$}"),
        });
        page += &cells.collect::<String>();
        page.push('\n');
    }
    page
}

fn page(answer: &YinComparisonAnswer) -> String {
    let real = |number: Option<f64>| number.map_or("infinite".to_owned(), text::number);
    let error = |error: f64| format!("off by at most about {}", text::rounded(error, 1));
    let normal = |number: Option<f64>| number.map_or("unknown".to_owned(), text::number);
    let normals = |off: f64| match answer.normals_left_out {
        0.0 => error(off),
        1.0 => "no normal of the first boundary meets the second near by".to_owned(),
        part => format!("{}; without {:.1} % of the first boundary", error(off), 100.0 * part),
    };
    let pair = |[a, b]: [usize; 2]| format!("{} and {}", text::grouped(a), text::grouped(b));
    let facts = [
        ("area of a xor b", real(answer.area_xor), error(answer.area_xor_error)),
        ("area a less b", real(answer.area_signed), error(answer.area_signed_error)),
        ("Hausdorff", real(answer.hausdorff), error(answer.hausdorff_error)),
        ("along normals", normal(answer.along_normals), normals(answer.along_normals_error)),
        ("curvature", normal(answer.curvature), normals(answer.curvature_error)),
        ("components", pair(answer.components), String::new()),
        ("holes", pair(answer.holes), String::new()),
    ];
    let facts: Vec<(String, String, String)> =
        facts.into_iter().map(|(label, value, gloss)| (label.to_owned(), value, gloss)).collect();
    text::facts("Comparison", &facts)
}
