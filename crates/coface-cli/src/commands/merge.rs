//! `coface merge`: the homology of the whole from what is left of its shards.

use crate::arguments::Common;
use crate::failure::Failure;
use crate::output::{give, is_json, write_json};
use crate::progress::Progress;
use crate::remarks::say_remarks;
use clap::Args;
use coface::algebra::Integer;
use coface::answers::answer::{
    GeneratorAnswer, GeneratorsFile, HomologyAnswer, LevelAnswer, PartsAnswer, WholeNumber,
};
use coface::answers::text;
use coface::scale::shards::{FolderLevel, FolderSummary, ShardChain, ShardChains, ShardFolder, ShardTerm};
use coface::topology::{AbelianGroup, Coefficients};
use std::path::PathBuf;

/// Merge reduced shards, level after level, to the homology of the whole.
///
/// Levels that are merged already, from what stands there, are left as they are. What neighbors found in the cells that they share is compared. The JSON is
/// that of `coface homology`, with the key "parts" for levels, strata, critical cells and bytes.
#[derive(Args)]
pub(crate) struct Merge {
    /// The folder of the shards
    #[arg(value_name = "FOLDER")]
    folder: PathBuf,
    #[command(flatten)]
    question: Question,
    /// Merge finished levels again
    #[arg(long)]
    force: bool,
}

/// What is asked about the whole.
#[derive(Args, Clone)]
pub(crate) struct Question {
    /// Z, Q, a prime field or the integers modulo N: z, q, f2, f3, z6, ...
    #[arg(long, value_name = "RING", default_value = "z", value_parser = crate::arguments::ring)]
    pub(crate) coefficients: Coefficients,
    /// Cohomology instead of homology
    #[arg(long)]
    pub(crate) cohomology: bool,
    /// Cycles that generate the integral groups; written to OUT if given, as .json
    #[arg(long, value_name = "OUT", num_args = 0..=1)]
    pub(crate) generators: Option<Option<PathBuf>>,
}

impl Question {
    /// Refuses what parts do not answer.
    pub(crate) fn check(&self) -> Result<(), Failure> {
        let Some(place) = &self.generators else { return Ok(()) };
        if self.coefficients != Coefficients::Integers || self.cohomology {
            return Err(Failure::new(
                "generators from parts are integral cycles; leave --coefficients and --cohomology away",
            ));
        }
        match place {
            Some(path) if !is_json(path) => Err(Failure::new(format!(
                "{}: generators from parts are written as JSON; end the name in .json",
                path.display()
            ))),
            _ => Ok(()),
        }
    }
}

impl Merge {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        self.question.check()?;
        let folder = ShardFolder::open(&self.folder)?;
        let progress = Progress::start(common.quiet);
        progress.stage("merging");
        let answer = Answer::of(&folder, &self.question, self.force)?;
        drop(progress);
        answer.give(&self.question, common)
    }
}

/// What is said about a merged folder.
pub(crate) struct Answer {
    pub(crate) object: HomologyAnswer,
    pub(crate) page: String,
}

impl Answer {
    /// Merges what is not merged, and answers.
    pub(crate) fn of(folder: &ShardFolder, question: &Question, replaces: bool) -> Result<Self, Failure> {
        let summary = folder.merge_all(replaces)?;
        let chains = question.generators.is_some().then(|| folder.generators()).transpose()?;
        let (name, fan_in) = (&folder.manifest().source.name, folder.manifest().fan_in);
        let groups = match question.cohomology {
            true => summary.homology().dual(question.coefficients),
            false => summary.homology().with_coefficients(question.coefficients),
        };
        let groups = groups.groups();
        let level = |level: &FolderLevel| LevelAnswer {
            parts: level.parts(),
            strata: level.strata(),
            critical: level.critical().to_vec(),
            critical_per_stratum: level.critical_per_stratum(),
            bytes: level.bytes(),
            widest_bits: level.widest(),
        };
        let mut object = HomologyAnswer::of(name, question.coefficients, question.cohomology, groups);
        object.f_vector = Some(summary.cells().to_vec());
        object.remarks.extend_from_slice(&folder.manifest().source.remarks);
        object.parts = Some(PartsAnswer {
            count: summary.levels()[0].parts(),
            fan_in,
            critical_per_stratum: summary.levels()[0].critical_per_stratum(),
            bytes: summary.levels().iter().map(|level| level.bytes()).sum(),
            levels: summary.levels().iter().map(level).collect(),
        });
        let mut page = page(name, question, groups, &summary);
        if let Some(chains) = &chains {
            object.generators = Some(generators(chains));
            page += &list(chains);
        }
        Ok(Self { object, page })
    }

    /// Gives the answer, with its remarks and the file of generators.
    pub(crate) fn give(&self, question: &Question, common: &Common) -> Result<(), Failure> {
        self.save_generators(question)?;
        say_remarks(&self.object.remarks, common);
        give(common, &self.object, &self.page)
    }

    /// Writes the generators to their file, if one is named.
    fn save_generators(&self, question: &Question) -> Result<(), Failure> {
        if let (Some(Some(place)), Some(generators)) = (&question.generators, &self.object.generators) {
            write_json(place, &GeneratorsFile { generators: generators.clone() })?;
        }
        Ok(())
    }
}

fn page(name: &str, question: &Question, groups: &[AbelianGroup], summary: &FolderSummary) -> String {
    let what = if question.cohomology { "cohomology" } else { "homology" };
    let title = format!("{what} of {name} over {}", question.coefficients);
    let mut page =
        text::groups(&title, groups, if question.cohomology { "H^" } else { "H_" }, question.coefficients);
    let words = |counts: &[u64]| counts.iter().map(u64::to_string).collect::<Vec<_>>().join(" ");
    page += &format!("  cells by dimension: {}\n", words(summary.cells()));
    for (number, level) in summary.levels().iter().enumerate() {
        page += &format!(
            "  level {number}: parts {}, strata {}, critical cells {} ({:.2} a stratum), bytes {}\n",
            level.parts(),
            level.strata(),
            words(level.critical()),
            level.critical_per_stratum(),
            level.bytes()
        );
    }
    page
}

fn length(terms: &[ShardTerm]) -> Integer {
    let mut length = Integer::ZERO;
    terms.iter().for_each(|term| length += &term.coefficient.abs());
    length
}

fn generators(chains: &ShardChains) -> Vec<Vec<GeneratorAnswer>> {
    let term = |term: &ShardTerm| (WholeNumber::from(&term.coefficient), term.name.clone());
    let generator = |chain: &ShardChain| GeneratorAnswer {
        order: WholeNumber::of_order(chain.order.as_ref()),
        length: WholeNumber::from(&length(&chain.terms)),
        chain: chain.terms.iter().map(term).collect(),
        bounding: None,
    };
    chains.degrees.iter().map(|chains| chains.iter().map(generator).collect()).collect()
}

fn list(chains: &ShardChains) -> String {
    let mut page = String::new();
    for (degree, chains) in chains.degrees.iter().enumerate() {
        for (i, chain) in chains.iter().enumerate() {
            let order = chain.order.as_ref().map_or(String::new(), |order| format!(" of order {order}"));
            let length = length(&chain.terms);
            let cells = if length == Integer::ONE { "cell" } else { "cells" };
            page += &format!(
                "    generator {} of degree {degree}: a cycle{order}, length {length} {cells}\n",
                i + 1
            );
        }
    }
    page
}
