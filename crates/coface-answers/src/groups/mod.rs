//! Fundamental groups of a model, and what is known of loops on its surface.
//!
//! * [`GroupsRequest`] says what is asked; [`GroupsRequest::found`] answers it about a model.
//! * [`FoundGroups`] has the presentations and the loops, and makes the answers of `pi1`, `loops`, `cycles`, `homotopic` and
//!   `subgroups`.

mod certificate;
mod found;
mod surface;
mod walks;
mod walks_certificate;

pub use found::FoundGroups;
pub(crate) use surface::roles_of_edges;

use crate::Producer;
use crate::answer::{
    GroupCounts, HomomorphismAnswer, Remark, RemarkCode, SpaceAnswer, SubgroupCount, TreesAnswer,
};
use crate::facts::group_of_space;
use coface_algebra::chains::{ChainComplex, TwoSkeleton};
use coface_algebra::progress::stage;
use coface_algebra::{CellId, Error, VertexId, Word};
use coface_topology::{
    AbelianGroup, EdgePathGroups, Effort, GroupName, HomomorphismCount, PermutationGroup, Presentation,
    Simplification, SubgroupClass, SurfaceGroup, homology,
};
use std::time::{Duration, Instant};

/// Asks for the fundamental groups of the components of a model, and for more about loops on its surface.
///
/// # Examples
/// The rim of a triangle has one loop, and nothing contracts it.
/// ```
/// use coface_answers::{GroupsRequest, Producer};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let rim = Producer::of(coface_io::read(&b"[[0,1],[1,2],[0,2]]"[..], coface_io::Format::Json)?)?;
/// let found = GroupsRequest::new().found(&rim)?;
/// assert_eq!(found.answer("rim.json").components[0].name.as_deref(), Some("Z"));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, Default)]
pub struct GroupsRequest {
    is_simplified: bool,
    base: Option<u32>,
    highest_index: Option<usize>,
    time_limit: Option<Duration>,
    has_loops: bool,
    surface_loops: SurfaceLoops,
    walks: Option<GivenWalks>,
    short: Option<(ShortPaths, Option<u32>)>,
}

/// Which loops generate the group of a surface.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SurfaceLoops {
    /// Those of a spanning tree of any complex.
    #[default]
    Any,
    /// The shortest loops at the base.
    Shortest,
    /// Canonical loops, whose relator is a product of commutators or of squares.
    Canonical,
}

/// Which closed paths are to be short.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ShortPaths {
    /// One that cannot be contracted.
    NonContractible,
    /// One that does not cut its component apart.
    NonSeparating,
    /// A basis of homology modulo 2.
    HomologyBasis,
}

impl ShortPaths {
    /// The word of the answer.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_answers::ShortPaths::HomologyBasis.name(), "homology-basis");
    /// ```
    pub fn name(self) -> &'static str {
        match self {
            Self::NonContractible => "non-contractible",
            Self::NonSeparating => "non-separating",
            Self::HomologyBasis => "homology-basis",
        }
    }
}

/// Closed walks as the user writes them.
#[derive(Clone, Debug)]
pub struct GivenWalks {
    /// Where they come from, in messages.
    pub place: String,
    /// Each by its vertices, numbered as in the file; the first is repeated at the end.
    pub walks: Vec<Vec<u32>>,
}

impl GroupsRequest {
    /// Asks for the presentations of the groups.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{GroupsRequest, Producer};
    /// let rim = Producer::of(coface_io::read(&b"[[0,1],[1,2],[0,2]]"[..], coface_io::Format::Json)?)?;
    /// assert_eq!(GroupsRequest::new().found(&rim)?.presentations().len(), 1);
    /// # Ok(()) }
    /// ```
    pub fn new() -> Self {
        Self::default()
    }

    /// Whether presentations have fewer generators and shorter relators.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{GroupsRequest, Producer};
    /// let rim = Producer::of(coface_io::read(&b"[[0,1],[1,2],[0,2]]"[..], coface_io::Format::Json)?)?;
    /// let found = GroupsRequest::new().simplified(true).found(&rim)?;
    /// assert!(found.answer("rim.json").simplified);
    /// # Ok(()) }
    /// ```
    pub fn simplified(mut self, is_simplified: bool) -> Self {
        self.is_simplified = is_simplified;
        self
    }

    /// The base vertex of its component, by its number in the file.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{GroupsRequest, Producer};
    /// let rim = Producer::of(coface_io::read(&b"[[0,1],[1,2],[0,2]]"[..], coface_io::Format::Json)?)?;
    /// let found = GroupsRequest::new().base(Some(2)).found(&rim)?;
    /// assert_eq!(found.answer("rim.json").components[0].base, 2);
    /// # Ok(()) }
    /// ```
    pub fn base(mut self, base: Option<u32>) -> Self {
        self.base = base;
        self
    }

    /// Counts subgroups up to this index, and homomorphisms to some finite groups.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{GroupsRequest, Producer};
    /// let rim = Producer::of(coface_io::read(&b"[[0,1],[1,2],[0,2]]"[..], coface_io::Format::Json)?)?;
    /// // The integers have one subgroup of each index.
    /// let found = GroupsRequest::new().subgroups(Some(3)).found(&rim)?;
    /// let counts = found.answer("rim.json").components[0].counts.clone();
    /// assert_eq!(counts.and_then(|counts| counts.subgroups).map(|subgroups| subgroups.len()), Some(3));
    /// # Ok(()) }
    /// ```
    pub fn subgroups(mut self, highest_index: Option<usize>) -> Self {
        self.highest_index = highest_index;
        self
    }

    /// Stops simplifying, and looking for the shortest closed path of a kind, after so long; what is known then is given.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{GroupsRequest, Producer};
    /// let rim = Producer::of(coface_io::read(&b"[[0,1],[1,2],[0,2]]"[..], coface_io::Format::Json)?)?;
    /// let request = GroupsRequest::new().simplified(true).time_limit(Some(std::time::Duration::from_secs(1)));
    /// assert_eq!(request.found(&rim)?.presentations().len(), 1);
    /// # Ok(()) }
    /// ```
    pub fn time_limit(mut self, limit: Option<Duration>) -> Self {
        self.time_limit = limit;
        self
    }

    /// Whether the generators are wanted as closed paths.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{GroupsRequest, Producer};
    /// let rim = Producer::of(coface_io::read(&b"[[0,1],[1,2],[0,2]]"[..], coface_io::Format::Json)?)?;
    /// let found = GroupsRequest::new().loops(true).found(&rim)?;
    /// assert_eq!(found.loops().map(|walk| walk.len()).collect::<Vec<_>>(), [4]);
    /// # Ok(()) }
    /// ```
    pub fn loops(mut self, has_loops: bool) -> Self {
        self.has_loops = has_loops;
        self
    }

    /// Which loops generate the group of a surface; other than [`SurfaceLoops::Any`] need a surface.
    pub fn surface_loops(mut self, loops: SurfaceLoops) -> Self {
        self.surface_loops = loops;
        self
    }

    /// Compares these walks on a surface.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{GivenWalks, GroupsRequest, Producer};
    /// let ring = &b"[[0,1,4],[0,4,3],[1,2,5],[1,5,4],[2,0,3],[2,3,5]]"[..];
    /// let ring = Producer::of(coface_io::read(ring, coface_io::Format::Json)?)?;
    /// let walks = GivenWalks { place: "walks.json".to_owned(), walks: vec![vec![0, 1, 2, 0], vec![0, 1, 4, 0]] };
    /// let found = GroupsRequest::new().walks(Some(walks)).found(&ring)?;
    /// let walks = found.answer("ring.json").walks.unwrap_or_default();
    /// assert_eq!(walks.iter().map(|walk| walk.contractible).collect::<Vec<_>>(), [false, true]);
    /// # Ok(()) }
    /// ```
    pub fn walks(mut self, walks: Option<GivenWalks>) -> Self {
        self.walks = walks;
        self
    }

    /// Looks for short closed paths on a surface, all of them or those through a vertex, by its number in the file.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{GroupsRequest, Producer, ShortPaths};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let ring = &b"[[0,1,4],[0,4,3],[1,2,5],[1,5,4],[2,0,3],[2,3,5]]"[..];
    /// let ring = Producer::of(coface_io::read(ring, coface_io::Format::Json)?)?;
    /// let found = GroupsRequest::new().short_paths(ShortPaths::NonContractible, None).found(&ring)?;
    /// assert_eq!(found.short_paths().map(|paths| paths[0].length), Some(3.0));
    /// # Ok(()) }
    /// ```
    pub fn short_paths(mut self, kind: ShortPaths, through: Option<u32>) -> Self {
        self.short = Some((kind, through));
        self
    }

    /// Finds the groups of a model.
    ///
    /// # Errors
    /// Those of [`Producer::two_skeleton`]; [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for a vertex that is not there and for walks that do
    /// not close or leave the edges; [`ErrorKind::NonManifold`](coface_algebra::ErrorKind::NonManifold) if a surface is asked for and the model is none.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{GroupsRequest, Producer};
    /// let rim = Producer::of(coface_io::read(&b"[[0,1],[1,2],[0,2]]"[..], coface_io::Format::Json)?)?;
    /// let answer = GroupsRequest::new().found(&rim)?.answer("rim.json");
    /// assert_eq!(answer.components[0].name.as_deref(), Some("Z"));
    /// # Ok(()) }
    /// ```
    pub fn found(&self, producer: &Producer) -> Result<FoundGroups, Error> {
        if self.surface_loops != SurfaceLoops::Any || self.walks.is_some() || self.short.is_some() {
            return surface::found(self, producer);
        }
        let skeleton = producer.two_skeleton()?;
        let number = |vertex: VertexId| producer.cell_vertices(0, CellId::new(vertex.index()))[0];
        let steps = stage("walking around faces", 0);
        let groups = self.edge_paths(producer, &skeleton)?;
        let is_small = skeleton.edge_count() <= surface::MOST_EDGES;
        let small = is_small.then(|| (skeleton.vertex_count(), skeleton.edge_ends().to_vec()));
        drop((skeleton, steps));
        let steps = stage("comparing with homology", 0);
        check(&groups.first_homology(), &producer.chain_complex()?)?;
        drop(steps);
        let _steps = stage("simplifying presentations", 0);
        let effort = self.efforts();
        let shown = (0..groups.component_count()).map(|component| -> Result<Shown, Error> {
            let mut shown = self.shown(groups.presentation(component), &effort);
            shown.base = number(groups.base(component));
            if self.has_loops {
                let words = shown.generators.iter();
                let path = |word| groups.loop_vertices(component, word).into_iter().map(number).collect();
                shown.loops = words.map(path).collect();
            }
            let is_known = shown.name.as_ref().is_some_and(GroupName::is_complete);
            if let Some((name, space)) = if is_known { None } else { group_of_space(producer)? } {
                (shown.name, shown.space) = (Some(name), Some(SpaceAnswer::of(&space)));
            }
            Ok(shown)
        });
        let mut found = FoundGroups::new(self, shown.collect::<Result<_, _>>()?, producer);
        let cut = |said: &&Remark| said.code == RemarkCode::IdealVerticesCut;
        found.remarks.extend(producer.remarks().iter().filter(cut).cloned());
        found.trees = small.map(|(vertices, ends)| trees_of(&groups, vertices, &ends, number));
        Ok(found)
    }

    /// The groups by paths along edges, with the base that was asked for.
    fn edge_paths(&self, producer: &Producer, skeleton: &TwoSkeleton) -> Result<EdgePathGroups, Error> {
        let Some(base) = self.base else { return Ok(EdgePathGroups::new(skeleton)) };
        let number = |vertex: &VertexId| producer.cell_vertices(0, CellId::new(vertex.index()))[0];
        let vertex = (0..skeleton.vertex_count()).map(VertexId::new).find(|vertex| number(vertex) == base);
        EdgePathGroups::with_base(skeleton, vertex.ok_or_else(|| no_vertex(base, "to be the base"))?)
    }

    /// What may be spent on each part of the work: of the time limit, which is for all parts together, what is left then.
    fn efforts(&self) -> impl Fn() -> Effort + use<> {
        let timed = self.time_limit.map(|limit| (limit, Instant::now()));
        move || Effort::new().time_limit(timed.map(|(limit, start)| limit.saturating_sub(start.elapsed())))
    }

    fn shown(&self, presentation: &Presentation, effort: impl Fn() -> Effort) -> Shown {
        let simpler = Simplification::new(presentation, effort());
        let name = simpler.presentation().recognized(effort());
        let counts = self.highest_index.map(|highest| Counts::new(simpler.presentation(), highest, effort));
        let letters = |count: usize| (1..=count as i32).map(|letter| Word::from_letters([letter]));
        let (presentation, generators) = if self.is_simplified {
            let presentation = simpler.presentation().clone();
            let generators = letters(presentation.generator_count()).map(|word| simpler.to_original(&word));
            (presentation, generators.collect())
        } else {
            (presentation.clone(), letters(presentation.generator_count()).collect())
        };
        Shown {
            presentation,
            generators,
            name,
            space: None,
            counts,
            lengths: None,
            base: 0,
            loops: Vec::new(),
        }
    }
}

/// The edges of a complex by what they are for its loops: in a tree, generators, or known by the faces.
fn trees_of(
    groups: &EdgePathGroups,
    vertex_count: usize,
    ends: &[u32],
    number: impl Fn(VertexId) -> u32,
) -> TreesAnswer {
    let last = |vertex: usize| groups.path_to(VertexId::new(vertex)).last().map(|&(edge, _)| edge.index());
    let tree: Vec<usize> = (0..vertex_count).filter_map(last).collect();
    let components = 0..groups.component_count();
    let generators: Vec<usize> =
        components.flat_map(|component| groups.generator_edges(component)).map(|edge| edge.index()).collect();
    let mut answer = TreesAnswer::default();
    for (edge, ends) in ends.chunks_exact(2).enumerate() {
        let ends = [ends[0], ends[1]].map(|end| number(VertexId::new(end as usize)));
        if tree.contains(&edge) {
            answer.tree.push(ends);
        } else if generators.contains(&edge) {
            answer.generators.push(ends);
        } else {
            answer.cotree.push(ends);
        }
    }
    answer
}

fn no_vertex(number: u32, purpose: &str) -> Error {
    Error::invalid(format!("there is no vertex {number} {purpose}"))
}

/// The group of one component as it is shown.
#[derive(Clone, Debug)]
struct Shown {
    presentation: Presentation,
    /// Its generators as words in those of the edge-path group.
    generators: Vec<Word>,
    name: Option<GroupName>,
    /// The space that the name follows from, if it does not follow from the presentation.
    space: Option<SpaceAnswer>,
    counts: Option<Counts>,
    /// The lengths of the loops, of a surface.
    lengths: Option<Vec<f64>>,
    /// The number of the base vertex in the file.
    base: u32,
    /// The generators as closed paths, by the numbers of vertices in the file; empty unless they are wanted.
    loops: Vec<Vec<u32>>,
}

impl Shown {
    /// The group of an isolated vertex.
    fn of_point(base: u32) -> Self {
        let name = Some(SurfaceGroup::free(0).name());
        let presentation = SurfaceGroup::free(0).presentation();
        let (generators, loops) = (Vec::new(), Vec::new());
        Self {
            presentation,
            generators,
            name,
            space: None,
            counts: None,
            lengths: Some(Vec::new()),
            base,
            loops,
        }
    }
}

/// Numbers that tell groups apart; those that take too long are missing.
#[derive(Clone, Debug)]
struct Counts {
    /// For each index from 1 on the numbers of subgroups and of their classes.
    subgroups: Option<Vec<[usize; 2]>>,
    homomorphisms: Vec<(PermutationGroup, Option<HomomorphismCount>)>,
}

impl Counts {
    fn new(group: &Presentation, highest: usize, effort: impl Fn() -> Effort) -> Self {
        let targets = [
            PermutationGroup::Symmetric(3),
            PermutationGroup::Symmetric(4),
            PermutationGroup::Alternating(5),
        ];
        let subgroups = group.subgroups_up_to(highest, effort()).map(|classes| {
            let of_index = |index| classes.iter().filter(move |class| class.index() == index);
            let count = |index| of_index(index).map(SubgroupClass::conjugate_count).sum();
            (1..=highest).map(|index| [count(index), of_index(index).count()]).collect()
        });
        let homomorphisms = targets.map(|target| (target, group.homomorphisms_to(target, effort())));
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

/// Compares the abelianizations with H_1.
fn check(found: &AbelianGroup, complex: &ChainComplex) -> Result<(), Error> {
    let upper = complex.boundary_matrices().len().min(3);
    let homology = match upper {
        0 => return Ok(()),
        _ => homology(&ChainComplex::new(complex.boundary_matrices()[..upper].to_vec())?),
    };
    let expected = &homology.groups()[1];
    if found == expected {
        return Ok(());
    }
    Err(Error::invalid(format!("the loops give H_1 = {found}, but the boundary matrices {expected}"))
        .with_cure("please report this model as a fault of coface"))
}
