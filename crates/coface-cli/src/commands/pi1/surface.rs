//! Loops of surfaces: shortest, canonical, and walks that are given.

use super::{Counts, Cycle, CycleRequest, Found, Pi1, Shown, check, walks};
use crate::arguments::Common;
use crate::failure::Failure;
use crate::input;
use crate::output::say_remarks;
use crate::progress::Progress;
use coface::VertexId;
use coface::algebra::Word;
use coface::answers::Producer;
use coface::answers::answer::{Remark, RemarkCode};
use coface::complexes::surface::GeneralizedMap;
use coface::topology::{
    AbelianGroup, ClosedWalk, CycleKind, Effort, Presentation, ShortestCycle, SurfaceGroup, SurfaceHomotopy,
    TreeCotree, shortest_cycle, shortest_cycle_through, shortest_homology_basis, shortest_loops,
};

/// The group of one component of a surface, in the generators that are shown.
pub(super) struct SurfaceComponent {
    pub(super) presentation: Presentation,
    loops: Vec<ClosedWalk>,
    /// The generators of the trees as words in those that are shown, where they differ.
    pub(super) images: Option<Vec<Word>>,
}

impl SurfaceComponent {
    fn new(verb: &Pi1, surface: &Surface<'_>, component: usize) -> Result<Self, Failure> {
        let (homotopy, trees) = (&surface.homotopy, surface.trees);
        let group: &SurfaceGroup = &homotopy.groups()[component];
        if verb.canonical
            && let Some((loops, system)) = homotopy.canonical_loops(component)
        {
            let relators = if loops.is_empty() { Vec::new() } else { vec![system.relator()] };
            let presentation = Presentation::new(loops.len(), relators)?;
            return Ok(Self { presentation, loops, images: Some(system.images().to_vec()) });
        }
        let presentation = group.presentation();
        let found = &trees.components()[component];
        let loops = if verb.shortest && found.has_boundary() {
            let loops = shortest_loops(surface.map, found.base(), surface.lengths)?;
            loops.into_iter().map(|cycle| cycle.walk().clone()).collect()
        } else {
            let letters = (1..=found.generators().len() as i32).map(|letter| Word::from_letters([letter]));
            letters.map(|letter| homotopy.walk_of_word(component, &letter)).collect()
        };
        Ok(Self { presentation, loops, images: None })
    }
}

/// A surface with its loops.
pub(super) struct Surface<'a> {
    pub(super) map: &'a GeneralizedMap,
    trees: &'a TreeCotree,
    pub(super) homotopy: SurfaceHomotopy<'a>,
    lengths: Option<&'a [f64]>,
}

pub(super) fn run(verb: &Pi1, common: &Common) -> Result<(), Failure> {
    let progress = Progress::start(common.quiet);
    let (name, producer) = input::produce(&verb.input, common.reading(), &progress)?;
    let skeleton = producer.two_skeleton().map_err(|error| error.in_file(name.clone()))?;
    let numbers: Vec<u32> =
        (0..skeleton.vertex_count()).map(|vertex| producer.cell_vertices(0, vertex)[0]).collect();
    let number = |vertex: VertexId| numbers[vertex.index()];
    let base = match verb.base {
        None => None,
        Some(base) => {
            let place = numbers.iter().position(|&number| number == base);
            let missing = || Failure::new(format!("{name}: there is no vertex {base} to be the base"));
            Some(VertexId::new(place.ok_or_else(missing)?))
        }
    };
    progress.stage("cutting the surface open");
    let map = GeneralizedMap::new(skeleton).map_err(|error| {
        let cure = "leave the options of surfaces out, or split it first: coface convert --split-edges pairs --split-vertices";
        error.with_cure(cure).in_file(name.clone())
    })?;
    let lengths = lengths(verb, &producer, &map, &numbers)?;
    let mut remarks = Vec::new();
    if (verb.shortest || verb.cycles.is_some()) && lengths.is_none() {
        let message = "there are no positions: each edge has the length 1";
        remarks.push(Remark::new(RemarkCode::UnitLengths, message));
    }
    say_remarks(&remarks, common);
    let trees = TreeCotree::greedy(&map, base, lengths.as_deref())?;
    let homotopy = SurfaceHomotopy::new(&map, &trees)?;
    let surface = Surface { map: &map, trees: &trees, homotopy, lengths: lengths.as_deref() };
    let components = (0..trees.components().len())
        .map(|component| SurfaceComponent::new(verb, &surface, component))
        .collect::<Result<Vec<_>, _>>()?;
    progress.stage("comparing with homology");
    let groups: Vec<AbelianGroup> =
        components.iter().map(|component| component.presentation.abelianization()).collect();
    let betti = groups.iter().map(AbelianGroup::betti).sum();
    let torsion = groups.iter().flat_map(|group| group.torsion().to_vec()).collect();
    check(&AbelianGroup::new(betti, torsion), &producer.chain_complex()?)?;
    let effort = Effort::new().time_limit(verb.time_limit);
    let mut shown = Vec::new();
    let mut bases = Vec::new();
    let mut paths = Vec::new();
    for (i, (found, group)) in components.iter().zip(surface.homotopy.groups()).enumerate() {
        let highest = verb.subgroups.map(usize::from);
        let length = |walk: &ClosedWalk| {
            let steps = walk.steps().iter();
            steps.map(|&step| lengths.as_ref().map_or(1.0, |lengths| lengths[(step >> 1) as usize])).sum()
        };
        shown.push(Shown {
            presentation: found.presentation.clone(),
            generators: Vec::new(),
            name: Some(group.name()),
            counts: highest.map(|highest| Counts::new(&found.presentation, highest, effort)),
            lengths: Some(found.loops.iter().map(length).collect()),
        });
        bases.push(number(trees.components()[i].base()));
        paths.extend(found.loops.iter().map(|walk| walk.vertices(map.skeleton())));
    }
    for vertex in (0..numbers.len()).map(VertexId::new) {
        if trees.component_of_vertex(vertex).is_none() {
            shown.push(Shown::of_point());
            bases.push(number(vertex));
        }
    }
    let walks = match &verb.walks {
        None => None,
        Some(path) => {
            progress.stage("comparing walks");
            Some(walks::compare(path, &surface, &components, &numbers)?)
        }
    };
    let cycles = match verb.cycles {
        None => None,
        Some(request) => {
            progress.stage("looking for short closed paths");
            let through = match verb.through {
                None => None,
                Some(wanted) => {
                    let place = numbers.iter().position(|&number| number == wanted);
                    let missing =
                        || Failure::new(format!("{name}: there is no vertex {wanted} to go through"));
                    Some(VertexId::new(place.ok_or_else(missing)?))
                }
            };
            Some(cycles(request, through, &map, lengths.as_deref())?)
        }
    };
    let found = Found { shown, bases, loops: paths, walks, cycles, remarks };
    found.give(verb, common, progress, &name, &producer, &number)
}

/// How many vertices searches from all roots may reach in all.
const MOST_REACHED: usize = 2_000_000_000;

fn cycles(
    request: CycleRequest,
    through: Option<VertexId>,
    map: &GeneralizedMap,
    lengths: Option<&[f64]>,
) -> Result<Vec<Cycle>, Failure> {
    let one = |kind: CycleKind| -> Result<Vec<ShortestCycle>, coface::Error> {
        Ok(match through {
            Some(vertex) => shortest_cycle_through(map, vertex, lengths, kind)?,
            None => shortest_cycle(map, lengths, kind, MOST_REACHED)?,
        }
        .into_iter()
        .collect())
    };
    let found = match request {
        CycleRequest::NonContractible => one(CycleKind::NonContractible)?,
        CycleRequest::NonSeparating => one(CycleKind::NonSeparating)?,
        CycleRequest::HomologyBasis if through.is_some() => {
            return Err(Failure::new(
                "a basis of homology does not go through one vertex; leave --through out",
            ));
        }
        CycleRequest::HomologyBasis => shortest_homology_basis(map, lengths, MOST_REACHED)?,
    };
    let cycle = |found: ShortestCycle| Cycle {
        length: found.length(),
        vertices: found.walk().vertices(map.skeleton()),
    };
    Ok(found.into_iter().map(cycle).collect())
}

/// The lengths of edges by the positions of their ends, if they are asked for and there.
fn lengths(
    verb: &Pi1,
    producer: &Producer,
    map: &GeneralizedMap,
    numbers: &[u32],
) -> Result<Option<Vec<f64>>, Failure> {
    let positions = producer.positions();
    if !(verb.shortest || verb.cycles.is_some()) || positions.dimension() == 0 {
        return Ok(None);
    }
    let ends: Vec<u32> = map.skeleton().edge_ends().iter().map(|&end| numbers[end as usize]).collect();
    Ok(Some(positions.distances(&ends)?))
}
