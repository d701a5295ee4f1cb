//! Loops of surfaces: shortest, canonical, and walks that are given.

use super::found::{FoundGroups, unit_lengths};
use super::{Counts, GroupsRequest, ShortPaths, Shown, SurfaceLoops, check, no_vertex, walks};
use crate::Producer;
use crate::answer::{ClosedPath, Remark, RemarkCode, TreesAnswer};
use coface_algebra::progress::stage;
use coface_algebra::{CellId, Error, VertexId, Word};
use coface_complexes::surface::GeneralizedMap;
use coface_topology::{
    AbelianGroup, ClosedWalk, CycleKind, EdgeRole, Presentation, ShortestCycle, SurfaceGroup,
    SurfaceHomotopy, TreeCotree, shortest_cycle, shortest_cycle_through, shortest_cycle_until,
    shortest_homology_basis, shortest_loops,
};
use std::time::{Duration, Instant};

/// The group of one component of a surface, in the generators that are shown.
pub(super) struct SurfaceComponent {
    pub(super) presentation: Presentation,
    loops: Vec<ClosedWalk>,
    /// The generators of the trees as words in those that are shown, where they differ.
    pub(super) images: Option<Vec<Word>>,
}

impl SurfaceComponent {
    fn new(request: &GroupsRequest, surface: &Surface<'_>, component: usize) -> Result<Self, Error> {
        let (homotopy, trees) = (&surface.homotopy, surface.trees);
        let group: &SurfaceGroup = &homotopy.groups()[component];
        if request.surface_loops == SurfaceLoops::Canonical
            && let Some((loops, system)) = homotopy.canonical_loops(component)
        {
            let relators = if loops.is_empty() { Vec::new() } else { vec![system.relator()] };
            let presentation = Presentation::new(loops.len(), relators)?;
            return Ok(Self { presentation, loops, images: Some(system.images().to_vec()) });
        }
        let presentation = group.presentation();
        let found = &trees.components()[component];
        let loops = if request.surface_loops == SurfaceLoops::Shortest && found.has_boundary() {
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

pub(super) fn found(request: &GroupsRequest, producer: &Producer) -> Result<FoundGroups, Error> {
    let skeleton = producer.two_skeleton()?;
    let numbers: Vec<u32> = (0..skeleton.vertex_count())
        .map(|vertex| producer.cell_vertices(0, CellId::new(vertex))[0])
        .collect();
    let number = |vertex: VertexId| numbers[vertex.index()];
    let steps = stage("cutting the surface open", 0);
    let map = GeneralizedMap::new(skeleton)?;
    let has_lengths = request.surface_loops == SurfaceLoops::Shortest || request.short.is_some();
    if has_lengths {
        producer.require_finite()?;
    }
    let lengths = if has_lengths { lengths(producer, &map, &numbers)? } else { None };
    let trees = surface_trees(request, &map, &numbers, lengths.as_deref())?;
    let homotopy = SurfaceHomotopy::new(&map, &trees)?;
    let surface = Surface { map: &map, trees: &trees, homotopy, lengths: lengths.as_deref() };
    let components = (0..trees.components().len())
        .map(|component| SurfaceComponent::new(request, &surface, component))
        .collect::<Result<Vec<_>, _>>()?;
    drop(steps);
    let steps = stage("comparing with homology", 0);
    let groups: Vec<AbelianGroup> =
        components.iter().map(|component| component.presentation.abelianization()).collect();
    let betti = groups.iter().map(AbelianGroup::betti).sum();
    let torsion = groups.iter().flat_map(|group| group.torsion().to_vec()).collect();
    check(&AbelianGroup::new(betti, torsion), &producer.chain_complex()?)?;
    drop(steps);
    let effort = request.efforts();
    let mut shown = Vec::new();
    for (i, (found, group)) in components.iter().zip(surface.homotopy.groups()).enumerate() {
        let length = |walk: &ClosedWalk| {
            let steps = walk.steps().iter();
            steps.map(|&step| lengths.as_ref().map_or(1.0, |lengths| lengths[(step >> 1) as usize])).sum()
        };
        let path = |walk: &ClosedWalk| walk.vertices(map.skeleton()).into_iter().map(number).collect();
        let loops = if request.has_loops { found.loops.iter().map(path).collect() } else { Vec::new() };
        shown.push(Shown {
            space: None,
            presentation: found.presentation.clone(),
            generators: Vec::new(),
            name: Some(group.name()),
            counts: request.highest_index.map(|highest| Counts::new(&found.presentation, highest, &effort)),
            lengths: Some(found.loops.iter().map(length).collect()),
            base: number(trees.components()[i].base()),
            loops,
        });
    }
    for vertex in (0..numbers.len()).map(VertexId::new) {
        if trees.component_of_vertex(vertex).is_none() {
            shown.push(Shown::of_point(number(vertex)));
        }
    }
    let mut groups = FoundGroups::new(request, shown, producer);
    groups.trees =
        (map.skeleton().edge_count() <= MOST_EDGES).then(|| roles_of_edges(&map, &trees, &numbers));
    if has_lengths && lengths.is_none() {
        groups.remarks.push(unit_lengths());
    }
    if let Some(given) = &request.walks {
        let _steps = stage("comparing walks", 0);
        groups.compared = Some(walks::compare(given, &surface, &components, &numbers)?);
    }
    if let Some((kind, through)) = request.short {
        let _steps = stage("looking for short closed paths", 0);
        let through = through.map(|wanted| vertex_numbered(&numbers, wanted, "to go through")).transpose()?;
        let path = |found: ShortestCycle| ClosedPath {
            length: found.length(),
            vertices: found.walk().vertices(map.skeleton()).into_iter().map(number).collect(),
        };
        let found = short_paths(kind, through, &map, lengths.as_deref(), request.time_limit)?;
        if found.is_cut_short() {
            groups.remarks.push(Remark::new(
                RemarkCode::SearchEnded,
                format!(
                    "the search ended early: no closed path of this kind is shorter than {}",
                    found.lower_bound.unwrap_or(0.0)
                ),
            ));
        }
        groups.lower_bound = found.lower_bound;
        groups.short = Some(found.cycles.into_iter().map(path).collect());
    }
    Ok(groups)
}

/// The trees of a surface whose vertices have these numbers, with the base that was asked for.
pub(super) fn surface_trees(
    request: &GroupsRequest,
    map: &GeneralizedMap,
    numbers: &[u32],
    lengths: Option<&[f64]>,
) -> Result<TreeCotree, Error> {
    let base = request.base.map(|base| vertex_numbered(numbers, base, "to be the base")).transpose()?;
    TreeCotree::greedy(map, base, lengths)
}

fn vertex_numbered(numbers: &[u32], wanted: u32, purpose: &str) -> Result<VertexId, Error> {
    let place = numbers.iter().position(|&number| number == wanted);
    place.map(VertexId::new).ok_or_else(|| no_vertex(wanted, purpose))
}

/// The edges of larger surfaces are not listed by their roles.
pub(super) const MOST_EDGES: usize = 40;

/// The edges of a surface by what they are in a tree-cotree decomposition, with these numbers of vertices.
pub(crate) fn roles_of_edges(map: &GeneralizedMap, trees: &TreeCotree, numbers: &[u32]) -> TreesAnswer {
    let mut answer = TreesAnswer::default();
    for (ends, role) in map.skeleton().edge_ends().chunks_exact(2).zip(trees.roles()) {
        let ends = [ends[0], ends[1]].map(|end| numbers[end as usize]);
        match role {
            EdgeRole::Tree => answer.tree.push(ends),
            EdgeRole::Cotree => answer.cotree.push(ends),
            EdgeRole::Generator => answer.generators.push(ends),
        }
    }
    answer
}

/// How many vertices searches from all roots may reach in all.
const MOST_REACHED: usize = 2_000_000_000;

/// Short closed paths.
struct ShortCycles {
    cycles: Vec<ShortestCycle>,
    /// Of the one path of a kind: no other one is shorter than this.
    lower_bound: Option<f64>,
}

impl ShortCycles {
    /// Whether there may be a shorter path.
    fn is_cut_short(&self) -> bool {
        self.lower_bound.is_some_and(|bound| self.cycles.iter().any(|cycle| cycle.length() > bound))
    }
}

fn short_paths(
    kind: ShortPaths,
    through: Option<VertexId>,
    map: &GeneralizedMap,
    lengths: Option<&[f64]>,
    time_limit: Option<Duration>,
) -> Result<ShortCycles, Error> {
    let start = Instant::now();
    let is_over = || time_limit.is_some_and(|limit| start.elapsed() >= limit);
    let one = |kind: CycleKind| -> Result<ShortCycles, Error> {
        if let Some(vertex) = through {
            let cycles: Vec<_> = shortest_cycle_through(map, vertex, lengths, kind)?.into_iter().collect();
            return Ok(ShortCycles { cycles, lower_bound: None });
        }
        if time_limit.is_none() {
            // Lower bounds on the way take time.
            let cycles: Vec<_> = shortest_cycle(map, lengths, kind, MOST_REACHED)?.into_iter().collect();
            let lower_bound = cycles.first().map(ShortestCycle::length);
            return Ok(ShortCycles { cycles, lower_bound });
        }
        let found = shortest_cycle_until(map, lengths, kind, MOST_REACHED, &is_over)?;
        let lower_bound = found.cycle().map(|_| found.lower_bound());
        Ok(ShortCycles { cycles: found.cycle().cloned().into_iter().collect(), lower_bound })
    };
    match kind {
        ShortPaths::NonContractible => one(CycleKind::NonContractible),
        ShortPaths::NonSeparating => one(CycleKind::NonSeparating),
        ShortPaths::HomologyBasis if through.is_some() => {
            Err(Error::invalid("a basis of homology does not go through one vertex")
                .with_cure("ask for it without the vertex"))
        }
        ShortPaths::HomologyBasis => {
            let cycles = shortest_homology_basis(map, lengths, MOST_REACHED)?;
            Ok(ShortCycles { cycles, lower_bound: None })
        }
    }
}

/// The lengths of edges by the positions of their ends, if there are positions.
fn lengths(producer: &Producer, map: &GeneralizedMap, numbers: &[u32]) -> Result<Option<Vec<f64>>, Error> {
    let positions = producer.positions();
    if positions.dimension() == 0 {
        return Ok(None);
    }
    let ends: Vec<u32> = map.skeleton().edge_ends().iter().map(|&end| numbers[end as usize]).collect();
    Ok(Some(positions.distances(&ends)?))
}
