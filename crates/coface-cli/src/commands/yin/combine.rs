//! Boolean combinations of sets.

use super::{SetOptions, Several, give};
use crate::arguments::Common;
use crate::commands::arrange::check_json;
use crate::failure::Failure;
use crate::input;
use crate::output::{remark, write_json};
use crate::progress::Progress;
use crate::text;
use clap::Args;
use coface::arrangement::boolean::BooleanFormula;
use coface::report::PlanarSet;
use coface::yin::YinSet;
use serde_json::{Value, json};
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
    #[arg(value_name = "FORMULA", allow_hyphen_values = true)]
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
        let options: &SetOptions = &self.options;
        let output = options.output(common)?;
        if let Some(path) = &self.provenance {
            check_json(path)?;
        }
        let progress = Progress::start(common.quiet);
        let sets: Vec<PlanarSet> = self
            .inputs
            .iter()
            .map(|path: &PathBuf| options.read(path, common, false, &progress))
            .collect::<Result<_, _>>()?;
        progress.stage("combining");
        let operands: Vec<&YinSet> = sets.iter().map(PlanarSet::set).collect();
        let combination = YinSet::combine(&operands, formula)?;
        let decisions: Vec<Value> = combination.report().iter().map(PlanarSet::decision_to_json).collect();
        if let Some(path) = &self.provenance {
            write_json(path, &PlanarSet::provenance_to_json(&combination))?;
        }
        if !decisions.is_empty() && !common.quiet {
            remark(&format!(
                "{} could not be certified at the resolution of the arithmetic; --json lists them",
                text::count(decisions.len(), "decision")
            ));
        }
        let files: Vec<String> =
            self.inputs.iter().map(|path: &PathBuf| input::name(Path::new(path))).collect();
        let more = vec![("files", json!(files)), ("uncertified", Value::from(decisions))];
        let result = PlanarSet::from_set(combination.into_set());
        give(&result, title, more, options, output, common, progress)
    }
}

impl Formula {
    pub(super) fn run(&self, common: &Common) -> Result<(), Failure> {
        let formula = BooleanFormula::parse(&self.formula, &[])
            .map_err(|error| Failure::new(format!("the formula: {error}")))?;
        let count = self.sets.inputs.len();
        if formula.input_count() > count {
            return Err(Failure::new(format!(
                "the formula names input {}, but there are {count}, numbered from 0",
                formula.input_count() - 1
            )));
        }
        self.sets.combine("Combination", &formula, common)
    }
}
