//! `coface yin`: sets of the plane with smooth boundaries and kinks.

mod advect;
mod combine;
mod compare;
mod cut_cells;
mod edit;
mod given;
mod interface;
mod page;
mod phase_places;
mod places;
mod validity;

use self::given::Given;
use self::interface::InterfaceOutput;
use crate::arguments::Common;
use crate::commands::arrange::{Rule, output_format};
use crate::failure::Failure;
use crate::input;
use crate::output::{print_json, print_text};
use crate::progress::Progress;
use crate::remarks::say_remarks;
use clap::{Args, Subcommand, ValueEnum};
use coface::answers::answer::{
    Remark, RemarkCode, YinAdvectAnswer, YinCombinationAnswer, YinEventAnswer, YinInfoAnswer, YinKinkPoint,
    YinKinksAnswer, YinNormalizeAnswer, YinSetAnswer,
};
use coface::answers::{KinkRequest, PlanarSet, SetRequest};
use coface::arrange::boolean::BooleanFormula;
use coface::io::{Format, replace_file};
use coface::pictures::{SetPicture, set_picture};
use coface::yin::{EndCondition, KnotIndex, Order};
use serde::Serialize;
use std::io::Write;
use std::path::{Path, PathBuf};

/// Yin sets: regions of the plane with curved boundaries, unbounded ones too, and their Boolean algebra.
///
/// Inputs are our JSON {"order":2|4,"curves":[{"points":[[0.5,1.0],..],"kinks":[i,..]},..]} (closed curves, the first point not repeated,
/// the set on their left), {"plane":true}, {"curves":[]}, the binary .dat of splines, or a drawing: GeoJSON, WKT, SVG (curves are kept),
/// closed lines. Polygons have order 2; --order 4 makes cubics of their sides, which stay straight, and `coface yin fit` smooth splines
/// through their corners.
///
/// The .json of an interface (`coface yin interface -o`) is an input too: `info`, `validate`, `normalize`, `fit`, `kinks`, `cut-cells`, `locate`,
/// `sample`, `curvature`, `transform`, `compare`, `interface` and `advect` take it whole, and every verb takes one of its phases, named FILE.json#NAME or by its number from 0,
/// FILE.json#0.
///
/// With -o the set is written: .json keeps everything, .svg and .dat keep curves, others are polygons (--flatten for curves).
///
/// With --json: "empty", "plane", "bounded", "area" (null if unbounded), "perimeter", "curve_counts" (positive and negative curves, by
/// the rule of the papers), "betti_open" and "betti_closed" (components and holes of the set and of its closure), "order", "curves" (each
/// with "sign", "area", "length", "knots", "kinks", "vertices", "parent", "depth", "name"), "atoms", "kinks", "bounding_box".
#[derive(Args)]
pub(crate) struct Yin {
    #[command(subcommand)]
    task: Task,
}

#[derive(Subcommand)]
enum Task {
    /// What a set is: area, perimeter, components and holes, its curves and how they lie in each other; of an interface its phases, edges
    /// and junctions
    Info(One),
    /// The exterior of a set: what is neither in it nor on its boundary
    Complement(One),
    /// The intersection of sets
    Meet(Several),
    /// The union of sets, with the boundary that they share
    Join(Several),
    /// The first set without all others
    Difference(Several),
    /// What lies in an odd number of sets
    Xor(Several),
    /// Any formula of sets, such as "(a | b) - c"
    Combine(combine::Formula),
    /// Splines through the knots of a set, smooth but for kinks [default: --order 4]
    Fit(One),
    /// The kinks of a set: list, insert, erase or reset them; what lies beside them is fitted again
    Kinks(edit::Kinks),
    Compare(compare::Compare),
    Interface(interface::Interface),
    CutCells(cut_cells::Cells),
    Advect(advect::Advect),
    Locate(places::Locate),
    Sample(places::SampleVerb),
    Curvature(places::Curvature),
    Validate(validity::Validate),
    Normalize(validity::Normalize),
    Transform(validity::Transform),
}

/// A verb of one set.
#[derive(Args)]
struct One {
    /// The set; - is standard input
    #[arg(value_name = "INPUT")]
    input: PathBuf,
    #[command(flatten)]
    options: SetOptions,
}

/// A verb of any number of sets.
#[derive(Args)]
struct Several {
    /// The sets; - is standard input
    #[arg(required = true, value_name = "INPUT")]
    inputs: Vec<PathBuf>,
    #[command(flatten)]
    options: SetOptions,
    /// Write where each piece of the boundary comes from: .json
    #[arg(long, value_name = "FILE")]
    provenance: Option<PathBuf>,
}

/// How files become sets, and sets pictures.
#[derive(Args, Clone)]
struct SetOptions {
    /// The order: 2 for polylines, 4 for cubics, 6, 8 [default: that of the file]
    #[arg(long, value_name = "ORDER", value_parser = order)]
    order: Option<Order>,
    /// What is inside of curves that cross: they are refused without a rule, unless an SVG has one
    #[arg(long, value_name = "RULE")]
    rule: Option<Rule>,
    /// The kinks: none, all, detect:DEGREES (where the polygon of the knots turns by more), or a list such as 0:3,1:5 (curve:knot)
    #[arg(long, value_name = "KINKS", value_parser = kinks)]
    kinks: Option<KinkRequest>,
    /// How splines end at kinks
    #[arg(long, value_name = "ENDS", default_value = "not-a-knot")]
    ends: Ends,
    /// Let each curve begin at its lowest knot, and the curves come in one order
    #[arg(long)]
    canonical: bool,
    /// What an .svg of -o shows
    #[arg(long, value_name = "WHAT", default_value = "set")]
    picture: Shown,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Ends {
    /// The first two and the last two polynomials are one
    NotAKnot,
    /// No curvature at the ends
    Natural,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Shown {
    /// The set, to be read again
    Set,
    /// The set with knots and kinks
    Kinks,
    /// The set with its curves numbered, and which lies in which
    Forest,
}

fn order(text: &str) -> Result<Order, String> {
    let number = text.parse().map_err(|_| "the order is 2, 4, 6 or 8".to_owned())?;
    Order::new(number).map_err(|error| error.to_string())
}

/// Kinks as the command line names them.
fn kinks(text: &str) -> Result<KinkRequest, String> {
    match text {
        "none" | "" => return Ok(KinkRequest::None),
        "all" => return Ok(KinkRequest::All),
        _ => {}
    }
    if let Some(degrees) = text.strip_prefix("detect:") {
        let angle: Option<f64> = degrees.trim_end_matches("deg").parse().ok();
        return match angle.filter(|angle| (0.0..=180.0).contains(angle)) {
            Some(angle) => Ok(KinkRequest::Detected(angle.to_radians())),
            None => Err(format!("\"{degrees}\" is no angle between 0 and 180 degrees")),
        };
    }
    text.split([',', ' '])
        .filter(|word| !word.is_empty())
        .map(knot)
        .collect::<Result<_, _>>()
        .map(KinkRequest::Listed)
}

/// A knot as `curve:knot`, or as the knot of curve 0.
fn knot(text: &str) -> Result<KnotIndex, String> {
    let (curve, knot) = text.split_once(':').unwrap_or(("0", text));
    match (curve.trim().parse(), knot.trim().parse()) {
        (Ok(curve), Ok(knot)) => Ok(KnotIndex { curve, knot }),
        _ => Err(format!("\"{text}\" is no knot: write CURVE:KNOT, both numbered from 0")),
    }
}

/// Two numbers with a comma between.
fn pair(text: &str) -> Result<[f64; 2], String> {
    let number = |word: &str| word.trim().parse().ok().filter(|x: &f64| x.is_finite());
    match text.split_once(',').map(|(x, y)| (number(x), number(y))) {
        Some((Some(x), Some(y))) => Ok([x, y]),
        _ => Err(format!("\"{text}\" are no two numbers: write X,Y")),
    }
}

impl SetOptions {
    fn request(&self, common: &Common) -> SetRequest {
        let mut request = SetRequest::default();
        request.order = self.order;
        request.rule = self.rule.map(Rule::inside);
        request.kinks = self.kinks.clone();
        request.ends = match self.ends {
            Ends::NotAKnot => EndCondition::NotAKnot,
            Ends::Natural => EndCondition::Natural,
        };
        request.flatten = common.flatten;
        request.canonical = self.canonical;
        request
    }

    /// The file of -o and its format; pictures other than the set need an SVG.
    fn output<'a>(&self, common: &'a Common) -> Result<Option<(&'a Path, Format)>, Failure> {
        let output = output_format(common)?;
        if self.picture != Shown::Set && output.is_none_or(|(_, format)| format != Format::Svg) {
            return Err(Failure::new("--picture draws an SVG: name it with -o FILE.svg"));
        }
        Ok(output)
    }

    fn write(
        &self,
        set: &PlanarSet,
        output: Option<(&Path, Format)>,
        common: &Common,
    ) -> Result<Option<Remark>, coface::Error> {
        let Some((path, format)) = output else { return Ok(None) };
        replace_file(path, |out| self.write_to(set, out, format, common))?;
        let lost = self.lost_kinks(set, format);
        say_remarks(lost.as_slice(), common);
        Ok(lost)
    }

    fn write_to(
        &self,
        set: &PlanarSet,
        out: &mut dyn Write,
        format: Format,
        common: &Common,
    ) -> Result<(), coface::Error> {
        match self.picture {
            Shown::Set => set.write(out, format, common.flatten),
            Shown::Kinks => Ok(out.write_all(set_picture(set, SetPicture::Kinks)?.svg(None)?.as_bytes())?),
            Shown::Forest => Ok(out.write_all(set_picture(set, SetPicture::Forest)?.svg(None)?.as_bytes())?),
        }
    }

    /// That a file does not keep the kinks.
    fn lost_kinks(&self, set: &PlanarSet, format: Format) -> Option<Remark> {
        if self.picture == Shown::Set { lost_kinks(set, format) } else { None }
    }
}

/// That a file of this format does not keep the kinks of a set, where it has some.
pub(super) fn lost_kinks(set: &PlanarSet, format: Format) -> Option<Remark> {
    let count = set.set().kinks().len();
    if format == Format::Json || count == 0 {
        return None;
    }
    let message = format!("kinks are not kept by {}", format.title());
    Some(Remark::new(RemarkCode::FormatKeepsLess, message).at(count, []))
}

/// What a verb of `yin` says about a set.
trait SetReport: Serialize {
    /// The set.
    fn set(&self) -> &YinSetAnswer;

    /// The set, to add to its remarks.
    fn set_mut(&mut self) -> &mut YinSetAnswer;

    /// The kinks that are listed one by one.
    fn kink_points(&self) -> &[YinKinkPoint] {
        &[]
    }

    /// The changes of its topology, if it moved and they were looked for.
    fn events(&self) -> Option<&[YinEventAnswer]> {
        None
    }
}

impl SetReport for YinSetAnswer {
    fn set(&self) -> &YinSetAnswer {
        self
    }

    fn set_mut(&mut self) -> &mut YinSetAnswer {
        self
    }
}

macro_rules! set_reports {
    ($($answer:ty),*) => {
        $(impl SetReport for $answer {
            fn set(&self) -> &YinSetAnswer {
                &self.set
            }

            fn set_mut(&mut self) -> &mut YinSetAnswer {
                &mut self.set
            }
        })*
    };
}

set_reports!(YinInfoAnswer, YinCombinationAnswer, YinNormalizeAnswer);

impl SetReport for YinAdvectAnswer {
    fn set(&self) -> &YinSetAnswer {
        &self.set
    }

    fn set_mut(&mut self) -> &mut YinSetAnswer {
        &mut self.set
    }

    fn events(&self) -> Option<&[YinEventAnswer]> {
        self.events.as_deref()
    }
}

impl SetReport for YinKinksAnswer {
    fn set(&self) -> &YinSetAnswer {
        &self.set
    }

    fn set_mut(&mut self) -> &mut YinSetAnswer {
        &mut self.set
    }

    fn kink_points(&self) -> &[YinKinkPoint] {
        &self.kink_points
    }
}

/// Says on standard output what the command line asks for, once all files are written.
fn say(title: &str, answer: &impl SetReport, is_written: bool, common: &Common) -> Result<(), Failure> {
    if common.json {
        return print_json(answer);
    }
    if is_written && answer.events().is_none() {
        return Ok(());
    }
    print_text(&page::of(title, answer.set(), answer.kink_points(), answer.events()))
}

/// Gives a set as the command line asks.
fn give(
    set: &PlanarSet,
    title: &str,
    mut answer: impl SetReport,
    options: &SetOptions,
    output: Option<(&Path, Format)>,
    common: &Common,
    progress: Progress,
) -> Result<(), Failure> {
    progress.stage("writing");
    let lost = options.write(set, output, common)?;
    say_remarks(&answer.set().remarks, common);
    answer.set_mut().remarks.extend(lost);
    drop(progress);
    say(title, &answer, output.is_some(), common)
}

impl Yin {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        use combine::Operation;
        match &self.task {
            Task::Info(verb) => verb.info(common),
            Task::Complement(verb) => verb.complement(common),
            Task::Meet(verb) => verb.run(Operation::Meet, common),
            Task::Join(verb) => verb.run(Operation::Join, common),
            Task::Difference(verb) => verb.run(Operation::Difference, common),
            Task::Xor(verb) => verb.run(Operation::Xor, common),
            Task::Combine(verb) => verb.run(common),
            Task::Fit(verb) => verb.fit(common),
            Task::Kinks(verb) => verb.run(common),
            Task::Compare(verb) => verb.run(common),
            Task::Interface(verb) => verb.run(common),
            Task::CutCells(verb) => verb.run(common),
            Task::Advect(verb) => verb.run(common),
            Task::Locate(verb) => verb.run(common),
            Task::Sample(verb) => verb.run(common),
            Task::Curvature(verb) => verb.run(common),
            Task::Validate(verb) => verb.run(common),
            Task::Normalize(verb) => verb.run(common),
            Task::Transform(verb) => verb.run(common),
        }
    }
}

impl One {
    fn info(&self, common: &Common) -> Result<(), Failure> {
        let progress = Progress::start(common.quiet);
        let set = match self.options.given(&self.input, common, &progress)? {
            Given::Set(set) => set,
            Given::Interface(interface) => {
                let output = InterfaceOutput::new(&self.options, common)?;
                let inputs = std::slice::from_ref(&self.input);
                return interface::give(&interface, "Interface", inputs, &output, common, progress);
            }
        };
        let output = self.options.output(common)?;
        progress.stage("measuring");
        let name = input::name(&self.input);
        let answer = YinInfoAnswer::new(name.clone(), set.answer()?);
        give(&set, &name, answer, &self.options, output, common, progress)
    }

    fn complement(&self, common: &Common) -> Result<(), Failure> {
        let formula = BooleanFormula::parse("!a", &[])?;
        let inputs = std::slice::from_ref(&self.input);
        combine::combined("Complement", inputs, &formula, &self.options, None, common)
    }

    fn fit(&self, common: &Common) -> Result<(), Failure> {
        let progress = Progress::start(common.quiet);
        let allowed = ["--order", "--kinks"];
        if let Some(found) = self.options.given_interface(&self.input, &allowed, common, &progress)? {
            let output = InterfaceOutput::new(&self.options, common)?;
            progress.stage("fitting");
            let name = input::name(&self.input);
            let fitted = found.fitted(self.options.order, self.options.kinks.as_ref());
            let fitted = fitted.map_err(|error| error.in_file(name))?;
            let inputs = std::slice::from_ref(&self.input);
            return interface::give(&fitted, "Fitted interface", inputs, &output, common, progress);
        }
        let output = self.options.output(common)?;
        let set = self.options.read(&self.input, common, true, &progress)?;
        progress.stage("measuring");
        let answer = set.answer()?;
        give(&set, "Fitted splines", answer, &self.options, output, common, progress)
    }
}
