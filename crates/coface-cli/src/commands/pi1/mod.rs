//! `coface pi1`: fundamental groups.

mod surface;
mod walks;

use crate::arguments::Common;
use crate::failure::Failure;
use crate::input;
use crate::output::{give, write_json};
use crate::progress::Progress;
use clap::Args;
use coface::VertexId;
use coface::algebra::chains::ChainComplex;
use coface::algebra::{RaggedArray, Word};
use coface::answers::Producer;
use coface::answers::answer::{
    ClosedPath, GroupAnswer, GroupCounts, HomomorphismAnswer, Pi1Answer, Pi1Component, Remark, SubgroupCount,
};
use coface::answers::text;
use coface::geometry::Positions;
use coface::io::{Model, write_path};
use coface::topology::{
    AbelianGroup, EdgePathGroups, Effort, GroupName, HomomorphismCount, PermutationGroup, Presentation,
    Simplification, SubgroupClass, SurfaceGroup, homology,
};
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// The fundamental group of each component, by generators and relators: loops at a base vertex up to deformation.
///
/// A relator is a list of letters: +i is generator i, -i its inverse, and the product of the letters is the unit. The
/// abelianization is checked against H_1. The group is named when it can be proved which one it is: "trivial", "Z/5",
/// "Z^3", "Free(4)", "orientable surface group of genus 2", "Q8", "SL(2,5)", "Z/2 * Z/2", ...; else the name is null, which
/// says nothing.
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
    /// Stop simplifying after so many seconds; without it, results do not depend on the machine
    #[arg(long, value_name = "SECONDS", value_parser = seconds)]
    time_limit: Option<Duration>,
}

/// Which closed paths are to be short.
#[derive(Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum CycleRequest {
    /// One that cannot be contracted
    NonContractible,
    /// One that does not cut its component apart
    NonSeparating,
    /// A basis of homology modulo 2
    HomologyBasis,
}

fn seconds(text: &str) -> Result<Duration, String> {
    let seconds = text.parse().map_err(|_| "not a number of seconds".to_owned())?;
    Duration::try_from_secs_f64(seconds).map_err(|error| error.to_string())
}

/// The group of one component as it is shown.
struct Shown {
    presentation: Presentation,
    /// Its generators as words in those of the edge-path group.
    generators: Vec<Word>,
    name: Option<GroupName>,
    counts: Option<Counts>,
    /// The lengths of the loops, of a surface.
    lengths: Option<Vec<f64>>,
}

impl Shown {
    /// The group of an isolated vertex.
    fn of_point() -> Self {
        let name = Some(SurfaceGroup::free(0).name());
        let presentation = SurfaceGroup::free(0).presentation();
        Self { presentation, generators: Vec::new(), name, counts: None, lengths: Some(Vec::new()) }
    }
}

/// Numbers that tell groups apart; those that take too long are missing.
struct Counts {
    /// For each index from 1 on the numbers of subgroups and of their classes.
    subgroups: Option<Vec<[usize; 2]>>,
    homomorphisms: Vec<(PermutationGroup, Option<HomomorphismCount>)>,
}

impl Counts {
    fn new(group: &Presentation, highest: usize, effort: Effort) -> Self {
        let targets = [
            PermutationGroup::Symmetric(3),
            PermutationGroup::Symmetric(4),
            PermutationGroup::Alternating(5),
        ];
        let subgroups = group.subgroups_up_to(highest, effort).map(|classes| {
            let of_index = |index| classes.iter().filter(move |class| class.index() == index);
            let count = |index| of_index(index).map(SubgroupClass::conjugate_count).sum();
            (1..=highest).map(|index| [count(index), of_index(index).count()]).collect()
        });
        let homomorphisms = targets.map(|target| (target, group.homomorphisms_to(target, effort)));
        Self { subgroups, homomorphisms: homomorphisms.to_vec() }
    }

    fn answer(&self) -> GroupCounts {
        let count = |(i, &[subgroups, classes]): (usize, &[usize; 2])| SubgroupCount {
            index: i + 1,
            subgroups,
            classes,
        };
        let homomorphisms = self.homomorphisms.iter().map(|(target, count)| {
            (target.to_string(), count.map(|count| HomomorphismAnswer { all: count.all, onto: count.onto }))
        });
        GroupCounts {
            subgroups: self.subgroups.as_ref().map(|counts| counts.iter().enumerate().map(count).collect()),
            homomorphisms: homomorphisms.collect(),
        }
    }
}

impl Pi1 {
    pub(crate) fn run(&self, common: &Common) -> Result<(), Failure> {
        if self.shortest || self.canonical || self.walks.is_some() || self.cycles.is_some() {
            return surface::run(self, common);
        }
        let progress = Progress::start(common.quiet);
        let (name, producer) = input::produce(&self.input, common.reading(), &progress)?;
        let skeleton = producer.two_skeleton().map_err(|error| error.in_file(name.clone()))?;
        let number = |vertex: VertexId| producer.cell_vertices(0, vertex.index())[0];
        progress.stage("walking around faces");
        let groups = match self.base {
            None => EdgePathGroups::new(&skeleton),
            Some(base) => {
                let vertices = (0..skeleton.vertex_count()).map(VertexId::new);
                let vertex = vertices.into_iter().find(|&vertex| number(vertex) == base);
                let missing = || Failure::new(format!("{name}: there is no vertex {base} to be the base"));
                EdgePathGroups::with_base(&skeleton, vertex.ok_or_else(missing)?)?
            }
        };
        drop(skeleton);
        progress.stage("comparing with homology");
        check(&groups.first_homology(), &producer.chain_complex()?)?;
        progress.stage("simplifying presentations");
        let effort = Effort::new().time_limit(self.time_limit);
        let shown: Vec<Shown> =
            (0..groups.component_count()).map(|i| self.show(groups.presentation(i), effort)).collect();
        let loops = shown
            .iter()
            .enumerate()
            .flat_map(|(component, group)| group.generators.iter().map(move |word| (component, word)));
        let loops: Vec<Vec<VertexId>> = match &self.loops {
            None => Vec::new(),
            Some(_) => loops.map(|(component, word)| groups.loop_vertices(component, word)).collect(),
        };
        let bases: Vec<u32> = (0..shown.len()).map(|i| number(groups.base(i))).collect();
        let found = Found { shown, bases, loops, walks: None, cycles: None, remarks: Vec::new() };
        found.give(self, common, progress, &name, &producer, &number)
    }

    fn show(&self, presentation: &Presentation, effort: Effort) -> Shown {
        let simpler = Simplification::new(presentation, effort);
        let name = simpler.presentation().recognized(effort);
        let highest = self.subgroups.map(usize::from);
        let counts = highest.map(|highest| Counts::new(simpler.presentation(), highest, effort));
        let letters = |count: usize| (1..=count as i32).map(|letter| Word::from_letters([letter]));
        if self.simplify {
            let presentation = simpler.presentation().clone();
            let generators = letters(presentation.generator_count()).map(|word| simpler.to_original(&word));
            return Shown { generators: generators.collect(), presentation, name, counts, lengths: None };
        }
        let generators = letters(presentation.generator_count()).collect();
        Shown { generators, presentation: presentation.clone(), name, counts, lengths: None }
    }
}

/// What a run has found.
struct Found {
    shown: Vec<Shown>,
    bases: Vec<u32>,
    /// The loops of all components, if they are to be written.
    loops: Vec<Vec<VertexId>>,
    walks: Option<walks::Compared>,
    /// Short closed paths that were asked for.
    cycles: Option<Vec<Cycle>>,
    remarks: Vec<Remark>,
}

/// A closed path with its length.
struct Cycle {
    length: f64,
    vertices: Vec<VertexId>,
}

impl Found {
    fn give(
        self,
        verb: &Pi1,
        common: &Common,
        progress: Progress,
        name: &str,
        producer: &Producer,
        number: &dyn Fn(VertexId) -> u32,
    ) -> Result<(), Failure> {
        if let Some(path) = &verb.loops {
            progress.stage("writing loops");
            let cycles: Option<Vec<Vec<VertexId>>> = self
                .cycles
                .as_ref()
                .map(|cycles| cycles.iter().map(|cycle| cycle.vertices.clone()).collect());
            let loops = cycles.as_ref().unwrap_or(&self.loops);
            write_loops(path, loops, producer.positions().clone(), number)?;
        }
        drop(progress);
        let components = self.shown.iter().zip(&self.bases);
        let components = components.map(|(group, &base)| component(group, base)).collect();
        let page = page(name, &self, number);
        let cycle = |cycle: &Cycle| ClosedPath {
            length: cycle.length,
            vertices: cycle.vertices.iter().map(|&vertex| number(vertex)).collect(),
        };
        let (walks, pairs) = self.walks.map(|compared| (compared.walks, compared.pairs)).unzip();
        let object = Pi1Answer {
            file: name.to_owned(),
            simplified: verb.simplify,
            components,
            cycles: self.cycles.as_ref().map(|cycles| cycles.iter().map(cycle).collect()),
            walks,
            pairs,
            remarks: self.remarks,
        };
        give(common, &object, &page)
    }
}

/// Compares the abelianizations with H_1.
fn check(found: &AbelianGroup, complex: &ChainComplex) -> Result<(), Failure> {
    let upper = complex.boundary_matrices().len().min(3);
    let homology = match upper {
        0 => return Ok(()),
        _ => homology(&ChainComplex::new(complex.boundary_matrices()[..upper].to_vec())?),
    };
    let expected = &homology.groups()[1];
    if found == expected {
        return Ok(());
    }
    Err(Failure::new(format!(
        "the loops give H_1 = {found}, but the boundary matrices {expected}: please report this model as a fault of coface"
    )))
}

/// Closed paths in a file.
#[derive(Serialize)]
struct Loops {
    loops: Vec<Vec<u32>>,
}

/// Writes closed paths as JSON, or as polylines in a format that has positions.
fn write_loops(
    path: &Path,
    loops: &[Vec<VertexId>],
    positions: Positions,
    number: &dyn Fn(VertexId) -> u32,
) -> Result<(), Failure> {
    let numbered = loops.iter().map(|vertices| vertices.iter().map(|&vertex| number(vertex)).collect());
    let numbered: Vec<Vec<u32>> = numbered.collect();
    if path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("json")) {
        return write_json(path, &Loops { loops: numbered });
    }
    if positions.dimension() == 0 {
        return Err(Failure::new(format!(
            "{}: the model has no positions to draw loops with; write them as .json",
            path.display()
        )));
    }
    let lines = RaggedArray::from_lists(numbered.iter().filter(|vertices| vertices.len() > 1));
    Ok(write_path(&Model::from_lines(positions, lines)?, path, None)?)
}

fn component(group: &Shown, base: u32) -> Pi1Component {
    let relators = group.presentation.relators().iter().map(Word::letters);
    Pi1Component {
        base,
        generators: group.presentation.generator_count(),
        relators: relators.map(<[i32]>::to_vec).collect(),
        abelianization: GroupAnswer::from(&group.presentation.abelianization()),
        name: group.name.as_ref().map(GroupName::to_string),
        lengths: group.lengths.clone(),
        counts: group.counts.as_ref().map(Counts::answer),
    }
}

/// How many relators, and letters of them, a page for people shows of a component.
const FEW: usize = 12;
const LETTERS: usize = 400;

fn page(name: &str, found: &Found, number: &dyn Fn(VertexId) -> u32) -> String {
    let (groups, bases, walks) = (&found.shown, &found.bases, found.walks.as_ref());
    let mut facts = Vec::new();
    let mut fact = |label: &str, value: String, gloss: &str| {
        facts.push((label.to_owned(), value, gloss.to_owned()));
    };
    for (i, (group, base)) in groups.iter().zip(bases).enumerate() {
        if groups.len() > 1 {
            fact("component", format!("{} of {}", i + 1, groups.len()), "");
        }
        let (name, gloss) = match &group.name {
            Some(name) => (name.to_string(), ""),
            None => ("not recognized".to_owned(), "it may still be a well-known one"),
        };
        fact("group", name, gloss);
        fact("base", format!("vertex {base}"), "");
        let presentation = &group.presentation;
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
            let too_long = || "too long to count".to_owned();
            let subgroups = counts.subgroups.as_ref().map_or_else(too_long, |counts| {
                counts.iter().map(|[count, _]| count.to_string()).collect::<Vec<_>>().join(", ")
            });
            fact("subgroups", subgroups, "of index 1, 2, ...");
            for (target, count) in &counts.homomorphisms {
                let count = count
                    .map_or_else(too_long, |count| format!("{}, {} of them onto", count.all, count.onto));
                fact(&format!("maps to {target}"), count, "");
            }
        }
    }
    for (label, verdict) in walks.into_iter().flat_map(|walks| &walks.facts) {
        fact(label, verdict.clone(), "");
    }
    for cycle in found.cycles.iter().flatten() {
        let few: Vec<String> =
            cycle.vertices.iter().take(FEW).map(|&vertex| number(vertex).to_string()).collect();
        let more = if cycle.vertices.len() > FEW { " .." } else { "" };
        let gloss = format!("long, through {}{more}", few.join(" "));
        fact("cycle", format!("{:.6}", cycle.length), &gloss);
    }
    if found.cycles.as_ref().is_some_and(Vec::is_empty) {
        fact("cycles", "none".to_owned(), "no closed path is of this kind");
    }
    if groups.is_empty() {
        fact("group", "none".to_owned(), "the complex is empty");
    }
    text::facts(&format!("fundamental group of {name}"), &facts)
}
