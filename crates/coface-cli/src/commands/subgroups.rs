//! `coface subgroups`: subgroups of the fundamental group counted.

use crate::arguments::{Common, Limit};
use crate::commands::pi1::facts_of_counts;
use crate::failure::Failure;
use crate::groups::{self, Asked, FEW};
use crate::output::give;
use crate::progress::Progress;
use clap::Args;
use coface::answers::GroupsRequest;
use coface::answers::text;
use std::path::PathBuf;
use std::time::Duration;

/// Count the subgroups of low index of the fundamental group of each component, and its homomorphisms to S3, S4 and A5.
///
/// Such numbers tell groups apart that have the same abelianization.
#[derive(Args)]
pub(crate) struct Subgroups {
    /// The model; - is standard input
    #[arg(value_name = "INPUT")]
    input: PathBuf,
    /// Count subgroups of index up to N
    #[arg(long, value_name = "N", default_value_t = 4, value_parser = clap::value_parser!(u8).range(1..=20))]
    index: u8,
    /// The base vertex of its component, which comes first; other components have their lowest vertex
    #[arg(long, value_name = "VERTEX")]
    base: Option<u32>,
    /// Print every component, not just the first few
    #[arg(long)]
    all: bool,
    /// Stop simplifying and counting after this time, for all components together (500ms, 60s, 5m; a number alone is seconds) and say what is known then; without it, results do
    /// not depend on the machine
    #[arg(long, value_name = "TIME", value_parser = groups::effort)]
    time_limit: Option<Limit<Duration>>,
}

impl Subgroups {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        let progress = Progress::start(common.quiet);
        let request = GroupsRequest::new()
            .simplified(true)
            .base(self.base)
            .subgroups(Some(usize::from(self.index)))
            .time_limit(self.time_limit.and_then(|limit| limit.0));
        let asked = Asked::of(&self.input, &request, None, common, &progress)?;
        drop(progress);
        let Some(answer) = asked.found.subgroups_answer(&asked.name) else { return Ok(()) };
        let mut facts = Vec::new();
        let mut fact = |label: &str, value: String, gloss: &str| {
            facts.push((label.to_owned(), value, gloss.to_owned()));
        };
        let (count, limit) = (answer.components.len(), if self.all { usize::MAX } else { FEW });
        for (i, component) in answer.components.iter().enumerate().take(limit) {
            if count > 1 {
                fact("component", format!("{} of {count}", i + 1), "");
            }
            fact("group", component.name.clone().unwrap_or_else(|| "not recognized".to_owned()), "");
            fact("base", format!("vertex {}", component.base), "");
            if let Some(counts) = &component.counts {
                facts_of_counts(counts, &mut fact);
            }
        }
        if count > limit {
            let more = text::count(count - limit, "more component");
            fact("", format!("and {more} (--all prints all)"), "");
        }
        give(common, &answer, &text::facts(&format!("subgroups of {}", answer.file), &facts))
    }
}
