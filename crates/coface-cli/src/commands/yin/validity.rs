//! `coface yin validate`, `normalize` and `transform`.

use super::given::{self, Given};
use super::interface::{self, InterfaceOutput};
use super::{SetOptions, Shown, give, pair};
use crate::arguments::Common;
use crate::commands::arrange::Rule;
use crate::failure::Failure;
use crate::input;
use crate::output::{is_json, print_json, print_text, write_json};
use crate::progress::Progress;
use crate::remarks::{accept, take};
use clap::Args;
use coface::answers::answer::{YinInfoAnswer, YinInterfaceAnswer, YinValidationAnswer};
use coface::answers::{PlanarInterface, PlanarSet, text};
use coface::geometry::{AffineMap, Angle};
use std::path::PathBuf;

/// Whether the curves of a file bound a set: exit status 0 if they do, and 1 with a list of what is wrong.
///
/// Curves may touch in points; they must not cross, share arcs or come to a point twice, must have the set on their left, and alternate
/// where one lies in the other. Faults of curves by themselves are all listed, of curves together the first.
///
/// With --json, and with -o FILE.json: "valid", "faults" (each with its "kind", "curves", "point" and "message"), "curves" (their number),
/// "roughest" (of order 4 and more the knot that is no kink at which a curve turns most, in degrees). Of an interface its edges are checked:
/// whether they meet at their ends only, and phases lie on the right sides.
#[derive(Args)]
pub(super) struct Validate {
    /// The file; - is standard input
    #[arg(value_name = "INPUT")]
    input: PathBuf,
    #[command(flatten)]
    options: SetOptions,
}

/// The unique form of a set: curves that cross are cut and pasted by a fill rule, knots within straight parts of polylines left out,
/// curves begin at their lowest knots and come in one order.
///
/// Two sets of order 2 have the same points if and only if their unique forms are equal. Without --rule, curves that cross are repaired
/// by the rule nonzero, and what bounds a set stays as it is.
///
/// Of an interface edges that cross are cut and pasted, what then lies in several phases goes to the first of them, edges that go on smoothly where nothing
/// else ends become one, and edges and vertices come in one order; junctions and phases stay.
///
/// With --json also "rounds" (how often rounding made curves cross again) and "straightened" (knots that were left out); of an interface "repaired" (what
/// was wrong, null if nothing was), "joined" (vertices at which two edges became one) and "straightened".
#[derive(Args)]
pub(super) struct Normalize {
    /// The set, or an interface; - is standard input
    #[arg(value_name = "INPUT")]
    input: PathBuf,
    #[command(flatten)]
    options: SetOptions,
}

/// The image of a set under an affine map of the plane: scaled, then turned, then moved, or by a matrix.
///
/// Control points are mapped; kinks and names stay, and an interface stays one. Curves that touch and come to cross by rounding are an error, with the place.
#[derive(Args)]
pub(super) struct Transform {
    /// The set; - is standard input
    #[arg(value_name = "INPUT")]
    input: PathBuf,
    #[command(flatten)]
    options: SetOptions,
    /// Scale by a factor F, or by X,Y along the axes; negative factors mirror
    #[arg(long, value_name = "FACTORS", value_parser = factors, allow_hyphen_values = true)]
    scale: Option<[f64; 2]>,
    /// Turn counterclockwise by so many degrees; multiples of 90 are exact about the origin
    #[arg(long, value_name = "DEGREES", allow_hyphen_values = true)]
    rotate: Option<f64>,
    /// The point that scaling and turning leave where it is: X,Y
    #[arg(long, value_name = "POINT", default_value = "0,0", value_parser = pair, allow_hyphen_values = true)]
    center: [f64; 2],
    /// Move by a vector: X,Y
    #[arg(long, value_name = "VECTOR", value_parser = pair, allow_hyphen_values = true)]
    translate: Option<[f64; 2]>,
    /// A map instead: A,B,C,D,E,F takes (x, y) to (A x + B y + C, D x + E y + F)
    #[arg(long, value_name = "NUMBERS", value_parser = matrix, allow_hyphen_values = true,
          conflicts_with_all = ["scale", "rotate", "translate", "center"])]
    matrix: Option<[f64; 6]>,
}

fn factors(text: &str) -> Result<[f64; 2], String> {
    match text.contains(',') {
        true => pair(text),
        false => {
            pair(&format!("{text},{text}")).map_err(|_| format!("\"{text}\" is no factor: write F, or X,Y"))
        }
    }
}

fn matrix(text: &str) -> Result<[f64; 6], String> {
    let numbers: Option<Vec<f64>> =
        text.split(',').map(|word| word.trim().parse().ok().filter(|x: &f64| x.is_finite())).collect();
    numbers
        .and_then(|numbers| numbers.try_into().ok())
        .ok_or_else(|| format!("\"{text}\" are no six numbers: write A,B,C,D,E,F"))
}

impl Validate {
    pub(super) fn run(&self, common: &Common) -> Result<(), Failure> {
        if self.options.picture != Shown::Set {
            return Err(Failure::new(
                "--picture draws a set, not its faults: ask for it with `coface yin info`",
            ));
        }
        if let Some(path) = common.output.as_deref().filter(|path| !is_json(path)) {
            return Err(Failure::new(format!(
                "{}: what is wrong is written as .json; name the file so",
                path.display()
            )));
        }
        let progress = Progress::start(common.quiet);
        let name = input::name(&self.input);
        let found = given::interface_answer(&self.input)?;
        let is_set = found.is_none();
        let answer = match found {
            Some(found) => {
                self.options.check_interface(&self.input)?;
                progress.stage("checking");
                PlanarInterface::validation(&name, &found)
            }
            None => {
                let drawing = self.options.drawing(&self.input, common, &progress)?;
                progress.stage("checking");
                let request = self.options.request(common);
                PlanarSet::validation(&name, &drawing, &request)
            }
        };
        let answer = answer.map_err(|error| error.in_file(name.clone()))?;
        accept(&answer.remarks, common)?;
        take(&name, &answer.remarks);
        if let Some(path) = &common.output {
            write_json(path, &answer)?;
        }
        drop(progress);
        match (common.json, &common.output) {
            (true, _) => print_json(&answer)?,
            (false, Some(_)) => {}
            (false, None) => print_text(&page(&answer, is_set))?,
        }
        match answer.faults.first() {
            None => Ok(()),
            Some(first) if !is_set => Err(Failure::new(format!(
                "{name}: the edges are no interface: {}; make it from sets again: coface yin interface SETS --overlaps first",
                first.message
            ))),
            Some(first) => Err(Failure::new(format!(
                "{name}: the curves bound no set: {}; repair them with `coface yin normalize`",
                first.message
            ))),
        }
    }
}

fn page(answer: &YinValidationAnswer, is_set: bool) -> String {
    let mut facts = vec![
        ("valid".to_owned(), if answer.valid { "yes" } else { "no" }.to_owned(), String::new()),
        (if is_set { "curves" } else { "edges" }.to_owned(), text::grouped(answer.curves), String::new()),
    ];
    for (number, fault) in answer.faults.iter().enumerate() {
        let label = if number == 0 { "faults" } else { "" };
        facts.push((label.to_owned(), fault.message.clone(), String::new()));
    }
    if let Some(rough) = &answer.roughest {
        let gloss =
            format!("at knot {} of curve {}, the most where there is no kink", rough.knot, rough.curve);
        facts.push((
            "turns by".to_owned(),
            format!("{} degrees", text::rounded(rough.degrees.abs(), 1)),
            gloss,
        ));
    }
    text::facts("Validity", &facts)
}

impl Normalize {
    pub(super) fn run(&self, common: &Common) -> Result<(), Failure> {
        let progress = Progress::start(common.quiet);
        if let Some(found) = given::interface_answer(&self.input)? {
            return self.run_interface(&found, common, progress);
        }
        let output = self.options.output(common)?;
        let options =
            SetOptions { rule: Some(self.options.rule.unwrap_or(Rule::Nonzero)), ..self.options.clone() };
        let planar = options.read(&self.input, common, false, &progress)?;
        progress.stage("normalizing");
        let name = input::name(&self.input);
        let (planar, answer) = planar.normalized(&name).map_err(|error| error.in_file(name))?;
        give(&planar, "Unique form", answer, &options, output, common, progress)
    }
}

impl Normalize {
    /// The same of an interface, whose edges may cross.
    fn run_interface(
        &self,
        found: &YinInterfaceAnswer,
        common: &Common,
        progress: Progress,
    ) -> Result<(), Failure> {
        let name = input::name(&self.input);
        self.options.check_interface_but(&self.input, &["--rule", "--canonical"])?;
        let output = InterfaceOutput::new(&self.options, common)?;
        progress.stage("normalizing");
        let rule = self.options.rule.unwrap_or(Rule::Nonzero).inside();
        let unique = PlanarInterface::unchecked(found)
            .and_then(|found| found.normalized(std::slice::from_ref(&name), rule));
        let (unique, answer) = unique.map_err(|error| error.in_file(name.clone()))?;
        let inputs = std::slice::from_ref(&self.input);
        let text = || {
            let mut page = interface::page("Unique form", &answer.interface);
            let mut facts = vec![
                (
                    "joined".to_owned(),
                    text::grouped(answer.joined),
                    "vertices at which two edges became one".to_owned(),
                ),
                (
                    "straightened".to_owned(),
                    text::grouped(answer.straightened),
                    "knots within straight parts left out".to_owned(),
                ),
            ];
            if let Some(fault) = &answer.repaired {
                facts.push(("repaired".to_owned(), fault.clone(), String::new()));
            }
            page.push_str(&text::facts("What was done", &facts));
            page
        };
        interface::give_answer(&unique, &answer, text, inputs, &output, common, progress)
    }
}

impl Transform {
    pub(super) fn run(&self, common: &Common) -> Result<(), Failure> {
        let map = self.map()?;
        let progress = Progress::start(common.quiet);
        let name = input::name(&self.input);
        let set = match self.options.given(&self.input, common, &progress)? {
            Given::Set(set) => set,
            Given::Interface(found) => {
                let output = InterfaceOutput::new(&self.options, common)?;
                progress.stage("transforming");
                let image = found.transformed(&map).map_err(|error| error.in_file(name.clone()))?;
                let inputs = std::slice::from_ref(&self.input);
                return interface::give(&image, "Image", inputs, &output, common, progress);
            }
        };
        let output = self.options.output(common)?;
        progress.stage("transforming");
        let planar = set.transformed(&map).map_err(|error| error.in_file(name.clone()))?;
        progress.stage("measuring");
        let answer = YinInfoAnswer::new(name, planar.answer()?);
        give(&planar, "Image", answer, &self.options, output, common, progress)
    }

    fn map(&self) -> Result<AffineMap, Failure> {
        if let Some([a, b, c, d, e, f]) = self.matrix {
            return Ok(AffineMap::new(vec![a, b, d, e], vec![c, f])?);
        }
        if self.scale.is_none() && self.rotate.is_none() && self.translate.is_none() {
            return Err(Failure::new("there is no map; give --scale, --rotate, --translate or --matrix"));
        }
        let center = self.center;
        let mut map = AffineMap::translation(&center.map(|x| -x))?;
        if let Some(factors) = self.scale {
            map = map.then(&AffineMap::scaling(&factors)?)?;
        }
        if let Some(degrees) = self.rotate {
            map = map.then(&AffineMap::rotation(2, [0, 1], Angle::degrees(degrees)?)?)?;
        }
        map = map.then(&AffineMap::translation(&center)?)?;
        if let Some(by) = self.translate {
            map = map.then(&AffineMap::translation(&by)?)?;
        }
        Ok(map)
    }
}
