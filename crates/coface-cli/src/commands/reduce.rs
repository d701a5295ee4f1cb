//! `coface reduce`: what is left of shards.

use crate::arguments::Common;
use crate::failure::Failure;
use crate::output::{print_json, print_text};
use crate::progress::Progress;
use clap::Args;
use coface::algebra::escaped;
use coface::answers::answer::{ReduceAnswer, ReducedShard};
use coface::scale::shards::{ReducedStep, ShardFolder, reduce_file};
use std::path::PathBuf;

/// Reduce shards: leave their critical cells, each with its exact boundary.
///
/// Beside each part-000000.shard a part-000000.reduced is written; one that is there, whole and made of this shard, is left as it is. Shards
/// need nothing of each other, so any number of calls may work on different ones.
#[derive(Args)]
pub(crate) struct Reduce {
    /// Shards, or folders of shards
    #[arg(value_name = "SHARD", required = true)]
    shards: Vec<PathBuf>,
    /// Reduce finished ones again
    #[arg(long)]
    force: bool,
}

impl Reduce {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        if common.output.is_some() {
            return Err(Failure::new("a reduced shard stands beside its shard; leave -o away"));
        }
        let mut shards = Vec::new();
        for path in &self.shards {
            if path.is_dir() {
                let folder = ShardFolder::open(path)?;
                shards.extend((0..folder.manifest().part_count).map(|number| folder.shard_path(number)));
            } else {
                shards.push(path.clone());
            }
        }
        let progress = Progress::start(common.quiet);
        let mut steps = Vec::with_capacity(shards.len());
        for (i, shard) in shards.iter().enumerate() {
            progress.stage(format!("reducing {} ({} of {})", shard.display(), i + 1, shards.len()));
            steps.push(reduce_file(shard, self.force)?);
        }
        drop(progress);
        if common.json {
            let reduced = steps.iter().map(reduced).collect();
            return print_json(&ReduceAnswer { reduced, remarks: Vec::new() });
        }
        print_text(&steps.iter().map(line).collect::<String>())
    }
}

/// A step as plain data.
fn reduced(step: &ReducedStep) -> ReducedShard {
    let summary = step.summary();
    ReducedShard {
        file: step.path().display().to_string(),
        skipped: !step.is_new(),
        level: summary.place().level,
        number: summary.place().number,
        cells: summary.cells().to_vec(),
        strata: summary.strata(),
        critical: summary.critical().to_vec(),
        bytes: summary.bytes(),
        checksum: format!("{:016x}", summary.checksum()),
    }
}

fn line(step: &ReducedStep) -> String {
    let summary = step.summary();
    format!(
        "{}: {} cells, {} strata, {} critical cells, {} bytes{}\n",
        escaped(&step.path().display().to_string()),
        summary.cells().iter().sum::<u64>(),
        summary.strata(),
        summary.critical().iter().sum::<u64>(),
        summary.bytes(),
        if step.is_new() { "" } else { " (finished before)" }
    )
}
