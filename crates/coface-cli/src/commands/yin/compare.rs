//! `coface yin compare`: how far two sets are apart.

use super::{SetOptions, Shown};
use crate::arguments::Common;
use crate::failure::Failure;
use crate::input;
use crate::output::{is_json, print_json, print_text, write_json};
use crate::progress::Progress;
use clap::Args;
use coface::answers::answer::YinComparisonAnswer;
use coface::answers::text;
use std::path::PathBuf;

/// How far two sets are apart: the area of their symmetric difference, right to about 1e-14 of the box around both.
///
/// Nothing is decided about how the curves cross, so no resolution limits it: sets that differ by 1e-11 of their size are told apart, and
/// parts of curves that run along each other do no harm.
///
/// With --json, and with -o FILE.json: "area_xor" (null if it is infinite), "area_xor_error" (an estimate from above), "area_signed" (the
/// first less the second), "area_signed_error", "hausdorff" (the greatest distance of a point of one boundary from the other),
/// "components" and "holes" of both.
#[derive(Args)]
pub(super) struct Compare {
    /// The first set; - is standard input
    #[arg(value_name = "A")]
    first: PathBuf,
    /// The second set
    #[arg(value_name = "B")]
    second: PathBuf,
    #[command(flatten)]
    options: SetOptions,
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
        let progress = Progress::start(common.quiet);
        let first = self.options.read(&self.first, common, false, &progress)?;
        let second = self.options.read(&self.second, common, false, &progress)?;
        progress.stage("comparing");
        let names = [&self.first, &self.second].map(|path| input::name(path));
        let answer = first.compared_with(&names[0], &second, &names[1])?;
        if let Some(path) = &common.output {
            write_json(path, &answer)?;
        }
        drop(progress);
        match (common.json, &common.output) {
            (true, _) => print_json(&answer),
            (false, Some(_)) => Ok(()),
            (false, None) => print_text(&page(&answer)),
        }
    }
}

fn page(answer: &YinComparisonAnswer) -> String {
    let real = |number: Option<f64>| number.map_or("infinite".to_owned(), text::number);
    let error = |error: f64| format!("off by at most about {error:.1e}");
    let pair = |[a, b]: [usize; 2]| format!("{} and {}", text::grouped(a), text::grouped(b));
    let facts = [
        ("area of a xor b", real(answer.area_xor), error(answer.area_xor_error)),
        ("area a less b", real(answer.area_signed), error(answer.area_signed_error)),
        (
            "Hausdorff",
            real(answer.hausdorff),
            "greatest distance of a point of one boundary from the other".to_owned(),
        ),
        ("components", pair(answer.components), String::new()),
        ("holes", pair(answer.holes), String::new()),
    ];
    let facts: Vec<(String, String, String)> =
        facts.into_iter().map(|(label, value, gloss)| (label.to_owned(), value, gloss)).collect();
    text::facts("Comparison", &facts)
}
