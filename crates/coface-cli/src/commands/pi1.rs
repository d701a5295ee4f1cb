//! `coface pi1`: fundamental groups.

use crate::arguments::{Common, Limit};
use crate::certified;
use crate::failure::Failure;
use crate::groups::{self, Asked, FEW};
use crate::output::give;
use crate::progress::Progress;
use crate::written::Written;
use clap::Args;
use coface::answers::answer::{GroupCounts, Pi1Answer, Unrecognized};
use coface::answers::text;
use coface::answers::{GroupsRequest, ShortPaths, SurfaceLoops};
use coface::topology::Presentation;
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::time::Duration;

/// The fundamental group of each component, by generators and relators: loops at a base vertex up to deformation.
///
/// A relator is a list of letters: +i is generator i, -i its inverse, and the product of the letters is the unit. The
/// abelianization is checked against H_1. The group is named when it can be proved which one it is: "trivial", "Z/5",
/// "Z^3", "Free(4)", "orientable surface group of genus 2", "Q8", "SL(2,5)", "Z/2 * Z/2", ...; of a closed
/// 3-manifold with a name the group follows from that, in standard form: "<x1, x2, x3, h | h central, x1^2 h, ...>". Else the name is null,
/// and "unrecognized" says why.
///
/// The verbs loops, cycles, homotopic and subgroups answer one question each about such groups.
#[derive(Args)]
pub(crate) struct Pi1 {
    /// The model; - is standard input
    #[arg(value_name = "INPUT")]
    input: PathBuf,
    /// Simplify the presentations: fewer generators, shorter relators
    #[arg(long, conflicts_with_all = ["shortest", "canonical", "walks"])]
    simplify: bool,
    /// Of a surface: the shortest loops at the base, by the lengths of edges, or by their number without positions
    #[arg(long)]
    shortest: bool,
    /// Of a surface: canonical loops a1, b1, a2, b2, .. with the relator a1 b1 a1^-1 b1^-1 .., or c1, c2, .. with c1^2 c2^2 ..
    #[arg(long)]
    canonical: bool,
    /// On a surface: which of these closed paths can be contracted, which bound, which are homotopic or homologous; JSON {"walks":[[v0,v1,..,v0],..]}
    #[arg(long, value_name = "FILE", conflicts_with = "shortest")]
    walks: Option<PathBuf>,
    /// Of a surface: the shortest closed path of a kind, or shortest ones that are a basis of homology modulo 2, by the lengths of edges; --loops writes these then
    #[arg(long, value_enum, value_name = "KIND", conflicts_with_all = ["simplify", "canonical", "walks"])]
    cycles: Option<CycleRequest>,
    /// With --cycles: only closed paths through this vertex
    #[arg(long, value_name = "VERTEX", requires = "cycles")]
    through: Option<u32>,
    /// Write the generators as closed paths at the base: JSON {"loops":[[v0,v1,..,v0],..]}, or lines in OBJ, VTK, ...
    #[arg(long, value_name = "OUT")]
    loops: Option<PathBuf>,
    /// The base vertex of its component, which comes first; other components have their lowest vertex
    #[arg(long, value_name = "VERTEX")]
    base: Option<u32>,
    /// Count the subgroups of index up to N, and the homomorphisms to S3, S4 and A5
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(1..=20))]
    subgroups: Option<u8>,
    /// Print every component and every pair of walks, not just the first few
    #[arg(long)]
    all: bool,
    /// Stop simplifying, and looking for a shortest path, after this time (500ms, 60s, 5m; a number alone is seconds) and say what is known then; without it, results do
    /// not depend on the machine
    #[arg(long, value_name = "TIME", value_parser = groups::effort)]
    time_limit: Option<Limit<Duration>>,
    /// A certificate of the groups, which coface check verifies: presentations by paths along edges, the Tietze moves that simplify them, names that
    /// the last presentation shows; of a facet list, or a surface as plain OFF or OBJ; in
    /// the binary form if OUT ends in .bin
    #[arg(long, value_name = "OUT", conflicts_with_all = ["shortest", "canonical", "walks", "cycles", "time_limit"])]
    certificate: Option<PathBuf>,
}

/// Which closed paths are to be short.
#[derive(Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum CycleRequest {
    /// One that cannot be contracted
    NonContractible,
    /// One that does not cut its component apart
    NonSeparating,
    /// A basis of homology modulo 2
    HomologyBasis,
}

impl CycleRequest {
    /// What the library calls it.
    pub(crate) fn kind(self) -> ShortPaths {
        match self {
            Self::NonContractible => ShortPaths::NonContractible,
            Self::NonSeparating => ShortPaths::NonSeparating,
            Self::HomologyBasis => ShortPaths::HomologyBasis,
        }
    }
}

/// What helps when the options of surfaces are given for a model that is no surface.
const NO_SURFACE: &str = "leave --shortest, --canonical, --walks and --cycles out";

impl Pi1 {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        if let Some(place) = &self.certificate {
            certified::check_place(place, std::slice::from_ref(&self.input), "pi1", common)?;
        }
        if let Some(path) = &self.loops {
            Written::Model.check(path)?;
        }
        let progress = Progress::start(common.quiet);
        let walks = self.walks.as_deref().map(groups::walks_in).transpose()?;
        let mut request = GroupsRequest::new()
            .simplified(self.simplify)
            .base(self.base)
            .subgroups(self.subgroups.map(usize::from))
            .time_limit(self.time_limit.and_then(|limit| limit.0))
            .loops(self.loops.is_some())
            .surface_loops(match (self.canonical, self.shortest) {
                (true, _) => SurfaceLoops::Canonical,
                (false, true) => SurfaceLoops::Shortest,
                (false, false) => SurfaceLoops::Any,
            })
            .walks(walks);
        if let Some(cycles) = self.cycles {
            request = request.short_paths(cycles.kind(), self.through);
        }
        let asked = Asked::of(&self.input, &request, Some(NO_SURFACE), common, &progress)?;
        if let Some(place) = &self.certificate {
            progress.stage(format!("proving {}", place.display()));
            certified::save(place, std::slice::from_ref(&self.input), |inputs| {
                request.certificate(&asked.found, &asked.producer, inputs)
            })?;
        }
        if let Some(path) = &self.loops {
            asked.write_paths(path, &progress)?;
        }
        drop(progress);
        let answer = asked.found.answer(&asked.name);
        let presentations: Vec<&Presentation> = asked.found.presentations().collect();
        give(common, &answer, &page(&asked.name, &answer, &presentations, self.all))
    }
}

/// How many letters of relators a page for people shows of a component.
const LETTERS: usize = 400;
/// How many walks and pairs of them a page shows.
const PAIRS: usize = 100;

fn page(name: &str, answer: &Pi1Answer, presentations: &[&Presentation], is_all: bool) -> String {
    let groups = &answer.components;
    let mut facts = Vec::new();
    let mut fact = |label: &str, value: String, gloss: &str| {
        facts.push((label.to_owned(), value, gloss.to_owned()));
    };
    let is_summary = groups.len() > FEW && !is_all;
    if is_summary {
        fact("components", text::grouped(groups.len()), "--all prints the group of each");
        let mut counts: BTreeMap<(Option<&str>, usize), usize> = BTreeMap::new();
        for group in groups {
            *counts.entry((group.name.as_deref(), group.generators)).or_default() += 1;
        }
        for ((name, generators), count) in counts.into_iter().take(FEW) {
            let gloss =
                format!("of {}, {}", text::count(count, "component"), text::count(generators, "generator"));
            fact("group", name.unwrap_or("not recognized").to_owned(), &gloss);
        }
    }
    let shown = if is_summary { 0 } else { groups.len() };
    for (i, (group, presentation)) in groups.iter().zip(presentations).enumerate().take(shown) {
        if groups.len() > 1 {
            fact("component", format!("{} of {}", i + 1, groups.len()), "");
        }
        let (name, gloss) = match (&group.name, &group.space) {
            (Some(name), Some(space)) => (name.clone(), format!("the space is {}", space.name)),
            (Some(name), None) => (name.clone(), String::new()),
            (None, _) => {
                let why = match group.unrecognized {
                    Some(Unrecognized::GaveUp) => {
                        "counting its elements was given up: it may be finite or not"
                    }
                    _ => "infinite, and no rule fits: it may still be a well-known one",
                };
                ("not recognized".to_owned(), why.to_owned())
            }
        };
        fact("group", name, &gloss);
        fact("base", format!("vertex {}", group.base), "");
        fact("generators", presentation.generator_count().to_string(), "loops at the base");
        let relators = presentation.relators();
        fact("relators", relators.len().to_string(), "products of generators that can be contracted");
        let mut letters = 0;
        for relator in relators.iter().take(FEW) {
            letters += relator.len();
            if letters > LETTERS {
                break;
            }
            fact("", relator.to_string(), "");
        }
        if let Some(lengths) = group.lengths.as_ref().filter(|lengths| !lengths.is_empty()) {
            let few: Vec<String> = lengths.iter().take(FEW).map(|length| format!("{length:.6}")).collect();
            let more = if lengths.len() > FEW { " .." } else { "" };
            fact("lengths", format!("{}{more}", few.join(" ")), "of the loops");
        }
        fact("abelianization", presentation.abelianization().to_string(), "agrees with H_1");
        if let Some(counts) = &group.counts {
            facts_of_counts(counts, &mut fact);
        }
    }
    let limit = if is_all { usize::MAX } else { PAIRS };
    if let (Some(walks), Some(pairs)) = (&answer.walks, &answer.pairs) {
        facts.extend(groups::facts_of_walks(walks, pairs, limit));
    }
    for cycle in answer.cycles.iter().flatten() {
        facts.push(groups::fact_of_path("cycle", cycle, FEW));
    }
    if answer.cycles.as_ref().is_some_and(Vec::is_empty) {
        facts.push(groups::no_paths());
    }
    if groups.is_empty() {
        facts.push(("group".to_owned(), "none".to_owned(), "the complex is empty".to_owned()));
    }
    text::facts(&format!("fundamental group of {name}"), &facts)
}

/// The numbers of subgroups and of maps to finite groups.
pub(crate) fn facts_of_counts(counts: &GroupCounts, fact: &mut impl FnMut(&str, String, &str)) {
    let too_long = || "too long to count".to_owned();
    let subgroups = counts.subgroups.as_ref().map_or_else(too_long, |counts| {
        counts.iter().map(|count| count.subgroups.to_string()).collect::<Vec<_>>().join(", ")
    });
    fact("subgroups", subgroups, "of index 1, 2, ...");
    for (target, count) in &counts.homomorphisms {
        let count = count
            .as_ref()
            .map_or_else(too_long, |count| format!("{}, {} of them onto", count.all, count.onto));
        fact(&format!("maps to {target}"), count, "");
    }
}
