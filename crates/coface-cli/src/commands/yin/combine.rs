//! Boolean combinations of sets.

use super::{SetOptions, Several, say};
use crate::arguments::Common;
use crate::commands::arrange::check_json;
use crate::failure::Failure;
use crate::input;
use crate::progress::Progress;
use crate::remarks::say_remarks;
use clap::Args;
use coface::answers::PlanarSet;
use coface::answers::answer::{Place, Remark, RemarkCode, YinCombinationAnswer, to_json};
use coface::answers::text;
use coface::arrange::boolean::BooleanFormula;
use coface::io::replace_file;
use coface::yin::YinSet;
use std::path::{Path, PathBuf};

/// The named combinations.
#[derive(Clone, Copy)]
pub(super) enum Operation {
    Meet,
    Join,
    Difference,
    Xor,
}

/// Combine sets by a formula.
///
/// It names the inputs by letters, or by numbers from 0, and has ! for complement, & for meet, - for difference, ^ for xor, | for join,
/// from the tightest to the loosest. A formula that holds outside of all inputs gives an unbounded set.
#[derive(Args)]
pub(super) struct Formula {
    /// The formula
    #[arg(value_name = "FORMULA")]
    formula: String,
    #[command(flatten)]
    sets: Several,
}

impl Several {
    pub(super) fn run(&self, operation: Operation, common: &Common) -> Result<(), Failure> {
        let count = self.inputs.len();
        let (title, formula) = match operation {
            Operation::Meet => ("Meet", BooleanFormula::intersection(count)),
            Operation::Join => ("Join", BooleanFormula::union(count)),
            Operation::Difference => ("Difference", BooleanFormula::difference(count)),
            Operation::Xor => ("Symmetric difference", BooleanFormula::xor(count)),
        };
        self.combine(title, &formula, common)
    }

    fn combine(&self, title: &str, formula: &BooleanFormula, common: &Common) -> Result<(), Failure> {
        combined(title, &self.inputs, formula, &self.options, self.provenance.as_deref(), common)
    }
}

/// Combines sets by a formula, and gives the result.
pub(super) fn combined(
    title: &str,
    inputs: &[PathBuf],
    formula: &BooleanFormula,
    options: &SetOptions,
    provenance: Option<&Path>,
    common: &Common,
) -> Result<(), Failure> {
    let output = options.output(common)?;
    if let Some(path) = provenance {
        check_json(path)?;
    }
    let progress = Progress::start(common.quiet);
    let sets: Vec<PlanarSet> =
        inputs.iter().map(|path| options.read(path, common, false, &progress)).collect::<Result<_, _>>()?;
    progress.stage("combining");
    let operands: Vec<&YinSet> = sets.iter().map(PlanarSet::set).collect();
    let combination = YinSet::combine(&operands, formula)?;
    let decisions = PlanarSet::decisions(&combination);
    let bounds = [combination.resolution(), combination.area_error()];
    let uncertified = (!decisions.is_empty()).then(|| {
        let message = format!(
            "{} could not be certified at the resolution of the arithmetic; --json lists them; the resolution is {:.1e}, and the area \
             is off by at most {:.1e}; `coface yin compare` measures how far two sets are apart without such decisions",
            text::count(decisions.len(), "decision"),
            bounds[0],
            bounds[1]
        );
        Remark::new(RemarkCode::DecisionUncertified, message).at(decisions.len(), [])
    });
    say_remarks(uncertified.as_slice(), common);
    let files: Vec<String> = inputs.iter().map(|path| input::name(path)).collect();
    let sources = provenance.map(|path| (path, PlanarSet::provenance(&combination)));
    let result = PlanarSet::of_combination(combination, &sets);
    progress.stage("measuring");
    let mut answer = YinCombinationAnswer::new(files, decisions, bounds, result.answer()?);
    for (set, name) in sets.iter().zip(&answer.files) {
        let of_file = |remark: &Remark| remark.clone().at(remark.count as usize, [Place::file(name)]);
        answer.set.remarks.extend(set.remarks().iter().map(of_file));
    }
    answer.set.remarks.extend(uncertified);
    progress.stage("writing");
    let lost = match sources {
        None => options.write(&result, output, common)?,
        // Of two files none comes to be if the other cannot.
        Some((path, sources)) => {
            let mut lost = None;
            replace_file(path, |out| {
                writeln!(out, "{}", to_json(&sources))?;
                lost = options.write(&result, output, common)?;
                Ok(())
            })?;
            lost
        }
    };
    answer.set.remarks.extend(lost);
    drop(progress);
    say(title, &answer, output.is_some(), common)
}

impl Formula {
    pub(super) fn run(&self, common: &Common) -> Result<(), Failure> {
        let formula = BooleanFormula::parse(&self.formula, &[])
            .map_err(|error| Failure::new(format!("the formula: {error}")))?;
        let count = self.sets.inputs.len();
        if formula.input_count() > count {
            return Err(Failure::new(format!(
                "the formula names input {}, but there are {count}, numbered from 0; give a file for each input that it names",
                formula.input_count() - 1
            )));
        }
        self.sets.combine("Combination", &formula, common)
    }
}
