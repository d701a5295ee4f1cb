//! `coface cycles`: short closed paths on a surface.

use crate::arguments::Common;
use crate::commands::pi1::CycleRequest;
use crate::failure::Failure;
use crate::groups::{self, Asked, FEW};
use crate::output::{print_json, print_text};
use crate::progress::Progress;
use clap::Args;
use coface::answers::GroupsRequest;
use coface::answers::text;
use std::path::PathBuf;

/// The shortest closed paths of a kind on a surface, by the lengths of edges.
///
/// The file of -o has the paths: JSON {"loops":[[v0,v1,..,v0],..]}, or lines in OBJ, VTK, ...
#[derive(Args)]
pub(crate) struct Cycles {
    /// The model; - is standard input
    #[arg(value_name = "INPUT")]
    input: PathBuf,
    /// Which closed paths
    #[arg(long, value_enum, value_name = "KIND", default_value = "homology-basis")]
    kind: CycleRequest,
    /// Only closed paths through this vertex
    #[arg(long, value_name = "VERTEX")]
    through: Option<u32>,
    /// Print every path whole, not just its first vertices
    #[arg(long)]
    all: bool,
}

impl Cycles {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        let progress = Progress::start(common.quiet);
        let request = GroupsRequest::new().short_paths(self.kind.kind(), self.through);
        let asked = Asked::of(&self.input, &request, None, common, &progress)?;
        if let Some(path) = &common.output {
            asked.write_paths(path, &progress)?;
        }
        drop(progress);
        let Some(answer) = asked.found.cycles_answer(&asked.name) else { return Ok(()) };
        match (common.json, &common.output) {
            (true, _) => return print_json(&answer),
            (false, Some(_)) => return Ok(()),
            (false, None) => {}
        }
        let limit = if self.all { usize::MAX } else { FEW };
        let mut facts: Vec<_> =
            answer.cycles.iter().map(|path| groups::fact_of_path("cycle", path, limit)).collect();
        if facts.is_empty() {
            facts.push(groups::no_paths());
        }
        print_text(&text::facts(&format!("short closed paths on {}", answer.file), &facts))
    }
}
