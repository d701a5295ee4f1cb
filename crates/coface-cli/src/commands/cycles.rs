//! `coface cycles`: short closed paths on a surface.

use crate::arguments::{Common, Limit, length, time_limit};
use crate::commands::pi1::CycleRequest;
use crate::failure::Failure;
use crate::groups::{self, Asked, FEW, Fact};
use crate::input;
use crate::output::{is_json, print_json, print_text, write_json};
use crate::progress::Progress;
use crate::remarks::{accept, say_remarks};
use crate::target::write_model;
use clap::Args;
use coface::algebra::RaggedArray;
use coface::answers::answer::{
    ClosedPath, CyclesAnswer, FilledHandle, FilledHandlesAnswer, HandleAnswer, HandleCounts, HandlesAnswer,
    LoopKind,
};
use coface::answers::{FillHandlesRequest, GroupsRequest, HandlesRequest, text};
use coface::io::Model;
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// The shortest closed paths of a kind on a surface, by the lengths of edges; with --handles a handle loop and a tunnel loop of each handle
/// of a closed surface in space.
///
/// The file of -o has the paths: JSON {"loops":[[v0,v1,..,v0],..]}, or lines in OBJ, VTK, ...; with --fill-handles it has the surface
/// without these handles.
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
    /// For each handle of a closed surface in space a short loop around it, which bounds on the inside, and one through it, which bounds on the
    /// outside
    #[arg(long, conflicts_with_all = ["kind", "through"])]
    handles: bool,
    /// With --handles: only handles with a loop shorter than this, in the unit of the file
    #[arg(long, value_name = "LENGTH", requires = "handles", allow_negative_numbers = true, value_parser = length)]
    shorter_than: Option<f64>,
    /// Cut a closed surface in space along handle loops and tunnel loops shorter than this and fill the cuts with triangles, until no
    /// such loop is left; all fills all handles. The file of -o has the surface
    #[arg(long, value_name = "LENGTH", conflicts_with_all = ["kind", "through", "handles"],
          allow_negative_numbers = true, value_parser = length_or_all)]
    fill_handles: Option<f64>,
    /// With --kind non-contractible or non-separating: stop after this time (500ms, 60s, 5m; a number alone is seconds) with the best closed
    /// path so far and a length that none falls below; without it, results do not depend on the machine
    #[arg(long, value_name = "TIME", value_parser = time_limit)]
    time_limit: Option<Limit<Duration>>,
    /// Print every path whole, not just its first vertices
    #[arg(long)]
    all: bool,
}

fn length_or_all(text: &str) -> Result<f64, String> {
    match text {
        "all" | "inf" => Ok(f64::INFINITY),
        _ => length(text).map_err(|how| format!("{how}, or all")),
    }
}

impl Cycles {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        let progress = Progress::start(common.quiet);
        if self.handles {
            return self.handles(common, progress);
        }
        if let Some(length) = self.fill_handles {
            return self.fill(length, common, progress);
        }
        let request = GroupsRequest::new()
            .short_paths(self.kind.kind(), self.through)
            .time_limit(self.time_limit.and_then(|limit| limit.0));
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
        print_text(&self.page(&answer))
    }

    /// Whether a search that is stopped has a best path and a lower bound.
    pub(crate) fn has_bounds(&self) -> bool {
        let is_one = matches!(self.kind, CycleRequest::NonContractible | CycleRequest::NonSeparating);
        is_one && self.through.is_none() && !self.handles && self.fill_handles.is_none()
    }

    fn limit(&self) -> usize {
        if self.all { usize::MAX } else { FEW }
    }

    fn page(&self, answer: &CyclesAnswer) -> String {
        let mut facts: Vec<Fact> =
            answer.cycles.iter().map(|path| groups::fact_of_path("cycle", path, self.limit())).collect();
        if facts.is_empty() {
            facts.push(groups::no_paths());
        }
        text::facts(&format!("short closed paths on {}", answer.file), &facts)
    }

    fn handles(&self, common: &Common, progress: Progress) -> Result<(), Failure> {
        let loaded = input::read(&self.input, common.reading(), &progress)?;
        progress.stage("looking for handles");
        let request = HandlesRequest::new().shorter_than(self.shorter_than);
        let answer =
            request.found(&loaded.model, &loaded.name).map_err(|error| error.in_file(loaded.name.clone()))?;
        accept(&answer.remarks, common)?;
        say_remarks(&answer.remarks, common);
        if let Some(path) = &common.output {
            progress.stage(format!("writing {}", path.display()));
            write_loops(&answer.handles, &loaded.model, path)?;
        }
        drop(progress);
        match (common.json, &common.output) {
            (true, _) => print_json(&answer),
            (false, Some(_)) => Ok(()),
            (false, None) => print_text(&page_of_handles(&answer, self.limit())),
        }
    }

    fn fill(&self, length: f64, common: &Common, progress: Progress) -> Result<(), Failure> {
        let loaded = input::read(&self.input, common.reading(), &progress)?;
        progress.stage("looking for handles");
        let request = FillHandlesRequest::new().shorter_than(length);
        let (model, answer) = request
            .filled(&loaded.model, &loaded.name)
            .map_err(|error| error.in_file(loaded.name.clone()))?;
        accept(&answer.remarks, common)?;
        say_remarks(&answer.remarks, common);
        if let Some(path) = &common.output {
            progress.stage(format!("writing {}", path.display()));
            write_model(path, &model)?;
        }
        drop(progress);
        match (common.json, &common.output) {
            (true, _) => print_json(&answer),
            (false, Some(_)) if common.quiet => Ok(()),
            (false, _) => print_text(&page_of_filling(&answer, self.limit())),
        }
    }
}

/// Loops in a file, with the kind of each.
#[derive(Serialize)]
struct Loops<'a> {
    loops: Vec<&'a [u32]>,
    kinds: Vec<LoopKind>,
}

/// Writes the handle loop and the tunnel loop of each handle as JSON, or as polylines in a format that has positions.
fn write_loops(handles: &[HandleAnswer], model: &Model, place: &Path) -> Result<(), Failure> {
    let pairs = handles
        .iter()
        .flat_map(|found| [(LoopKind::Handle, &found.handle), (LoopKind::Tunnel, &found.tunnel)]);
    let (kinds, loops): (Vec<LoopKind>, Vec<&[u32]>) =
        pairs.map(|(kind, path)| (kind, &path.vertices[..])).unzip();
    if is_json(place) {
        return write_json(place, &Loops { loops, kinds });
    }
    write_model(place, &Model::from_lines(model.positions().clone(), RaggedArray::from_lists(loops))?)
}

fn fact(label: &str, value: impl Into<String>, gloss: impl Into<String>) -> Fact {
    (label.to_owned(), value.into(), gloss.into())
}

fn page_of_handles(answer: &HandlesAnswer, limit: usize) -> String {
    let mut facts =
        vec![fact("handles", text::grouped(answer.genus), "the sum of the genera of the components")];
    if let Some(length) = answer.shorter_than {
        let gloss = format!("have a loop shorter than {length}");
        facts.push(fact("listed", text::grouped(answer.handles.len()), gloss));
    }
    for (number, found) in answer.handles.iter().enumerate().take(limit) {
        let gloss = format!("is shorter, on component {}", found.component);
        facts.push(fact(
            &format!("handle {}", number + 1),
            format!("{:.6}", found.length),
            format!("the {} loop {gloss}", found.shorter.name()),
        ));
        facts.push(groups::fact_of_path("  handle loop", &found.handle, limit));
        facts.push(groups::fact_of_path("  tunnel loop", &found.tunnel, limit));
    }
    if answer.handles.len() > limit {
        let more = text::count(answer.handles.len() - limit, "more handle");
        facts.push(fact("", format!("and {more} (--all prints all)"), ""));
    }
    text::facts(&format!("handles of {}", answer.file), &facts)
}

fn page_of_filling(answer: &FilledHandlesAnswer, limit: usize) -> String {
    let kind = |counts: &HandleCounts| {
        let closed = if counts.closed { "closed" } else { "open" };
        let orientable = if counts.orientable { "orientable" } else { "not orientable" };
        format!("of {}, {closed} and {orientable}", text::count(counts.components, "component"))
    };
    let (before, after) = (&answer.before, &answer.after);
    let mut facts = vec![
        fact("genus before", text::grouped(before.genus), kind(before)),
        fact("genus after", text::grouped(after.genus), kind(after)),
        fact("Euler char.", format!("{} to {}", before.euler_characteristic, after.euler_characteristic), ""),
        fact(
            "triangles",
            format!("{} to {}", text::grouped(before.f_vector[2]), text::grouped(after.f_vector[2])),
            "",
        ),
        fact("filled", text::grouped(answer.filled.len()), "loops, each cut and both rims filled"),
    ];
    let row = |kind: LoopKind, path: &ClosedPath, more: String| {
        let (_, length, gloss) = groups::fact_of_path("", path, limit);
        fact(&format!("  {} loop", kind.name()), length, format!("{gloss}{more}"))
    };
    for FilledHandle { kind, path, added_triangles, .. } in answer.filled.iter().take(limit) {
        facts.push(row(*kind, path, format!("; {}", text::count(*added_triangles, "triangle"))));
    }
    if answer.filled.len() > limit {
        let more = text::count(answer.filled.len() - limit, "more loop");
        facts.push(fact("", format!("and {more} (--all prints all)"), ""));
    }
    if !answer.left.is_empty() {
        facts.push(fact("left", text::grouped(answer.left.len()), "loops on which no patch fits"));
        facts.extend(answer.left.iter().take(limit).map(|left| row(left.kind, &left.path, String::new())));
    }
    text::facts(&format!("{} with handles filled", answer.file), &facts)
}
