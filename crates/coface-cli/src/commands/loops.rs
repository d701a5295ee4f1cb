//! `coface loops`: loops that generate the fundamental group.

use crate::arguments::Common;
use crate::failure::Failure;
use crate::groups::{self, Asked, FEW};
use crate::output::{print_json, print_text};
use crate::progress::Progress;
use clap::Args;
use coface::algebra::Word;
use coface::answers::answer::LoopsAnswer;
use coface::answers::text;
use coface::answers::{GroupsRequest, SurfaceLoops};
use std::path::PathBuf;

/// Loops that generate the fundamental group of each component, as closed paths on its edges.
///
/// Without an option there are as few loops as simplifying finds. Of a surface --shortest gives the shortest loops at the
/// base, and --canonical gives a1, b1, a2, b2, .. with the relator a1 b1 a1^-1 b1^-1 .., or c1, c2, .. with c1^2 c2^2 ..
///
/// The file of -o has the loops: JSON {"loops":[[v0,v1,..,v0],..]}, or lines in OBJ, VTK, ...
#[derive(Args)]
pub(crate) struct Loops {
    /// The model; - is standard input
    #[arg(value_name = "INPUT")]
    input: PathBuf,
    /// Of a surface: the shortest loops at the base, by the lengths of edges, or by their number without positions
    #[arg(long, conflicts_with = "canonical")]
    shortest: bool,
    /// Of a surface: canonical loops
    #[arg(long)]
    canonical: bool,
    /// The base vertex of its component, which comes first; other components have their lowest vertex
    #[arg(long, value_name = "VERTEX")]
    base: Option<u32>,
    /// Print every loop whole, not just the first few
    #[arg(long)]
    all: bool,
    /// What coface cycles does
    #[arg(long, hide = true)]
    handles: bool,
    /// What coface cycles does
    #[arg(long, hide = true, value_name = "LENGTH")]
    fill_handles: Option<String>,
}

impl Loops {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        let input = self.input.display();
        if let Some(length) = &self.fill_handles {
            return Err(Failure::new(format!(
                "coface loops has the generators of the fundamental group; fill handles with: coface cycles {input} --fill-handles {length} -o OUT.off"
            )));
        }
        if self.handles {
            return Err(Failure::new(format!(
                "coface loops has the generators of the fundamental group; for those of handles ask: coface cycles {input} --handles"
            )));
        }
        let progress = Progress::start(common.quiet);
        let kind = match (self.shortest, self.canonical) {
            (true, _) => SurfaceLoops::Shortest,
            (_, true) => SurfaceLoops::Canonical,
            _ => SurfaceLoops::Any,
        };
        let request = GroupsRequest::new().simplified(true).base(self.base).loops(true).surface_loops(kind);
        let other = Some("leave --shortest and --canonical out");
        let asked = Asked::of(&self.input, &request, other, common, &progress)?;
        let answer =
            asked.found.loops_answer(&asked.name).map_err(|error| error.in_file(asked.name.clone()))?;
        crate::remarks::say_remarks(&answer.remarks[asked.found.remarks().len()..], common);
        if let Some(path) = &common.output {
            asked.write_paths(path, &progress)?;
        }
        drop(progress);
        match (common.json, &common.output) {
            (true, _) => print_json(&answer),
            (false, Some(_)) => Ok(()),
            (false, None) => print_text(&page(&answer, if self.all { usize::MAX } else { FEW })),
        }
    }
}

fn page(answer: &LoopsAnswer, limit: usize) -> String {
    let mut facts = Vec::new();
    let row = |label: &str, value: String| (label.to_owned(), value, String::new());
    for (i, component) in answer.components.iter().enumerate().take(limit) {
        if answer.components.len() > 1 {
            facts.push(row("component", format!("{} of {}", i + 1, answer.components.len())));
        }
        facts.push(row("group", component.name.clone().unwrap_or_else(|| "not recognized".to_owned())));
        facts.push(row("base", format!("vertex {}", component.base)));
        for (number, path) in component.loops.iter().enumerate().take(limit) {
            facts.push(groups::fact_of_path(&format!("loop {}", number + 1), path, limit));
        }
        if component.loops.len() > limit {
            let more = component.loops.len() - limit;
            facts.push(row("", format!("and {more} more loops (--all prints all)")));
        }
        for relator in component.relators.iter().take(limit) {
            facts.push(row("relator", Word::from_letters(relator.iter().copied()).to_string()));
        }
        if component.relators.len() > limit {
            let more = component.relators.len() - limit;
            facts.push(row("", format!("and {more} more relators (--all prints all)")));
        }
    }
    if let Some(trees) = &answer.trees {
        for (label, edges, gloss) in [
            ("tree", &trees.tree, "edges of the spanning tree of vertices"),
            ("cotree", &trees.cotree, "edges that the faces make known"),
            ("left", &trees.generators, "edges in neither: each makes a loop"),
        ] {
            let edges: Vec<String> = edges.iter().map(|[from, to]| format!("{from}-{to}")).collect();
            let none = if edges.is_empty() { "none".to_owned() } else { edges.join(" ") };
            facts.push((label.to_owned(), none, gloss.to_owned()));
        }
    }
    if answer.components.len() > limit {
        let more = text::count(answer.components.len() - limit, "more component");
        facts.push(row("", format!("and {more} (--all prints all)")));
    }
    if answer.components.is_empty() {
        facts.push(row("loops", "none: the complex is empty".to_owned()));
    }
    text::facts(&format!("loops of {}", answer.file), &facts)
}
