//! Groups that were found, and the answers that are made of them.

use super::{GroupsRequest, Shown, SurfaceLoops};
use crate::Producer;
use crate::answer::{
    ClosedPath, CyclesAnswer, GroupAnswer, HomotopicAnswer, HomotopicComponent, LoopsAnswer, LoopsComponent,
    Pi1Answer, Pi1Component, Remark, RemarkCode, SubgroupsAnswer, SubgroupsComponent, TreesAnswer,
    Unrecognized, WalkAnswer, WalkPair,
};
use coface_algebra::{Error, Word};
use coface_geometry::Positions;
use coface_topology::{GroupName, Presentation};

/// The fundamental groups of the components of a model, with the loops, walks and short paths that were asked for.
#[derive(Clone, Debug)]
pub struct FoundGroups {
    request: GroupsRequest,
    shown: Vec<Shown>,
    positions: Positions,
    pub(super) compared: Option<(Vec<WalkAnswer>, Vec<WalkPair>)>,
    pub(super) short: Option<Vec<ClosedPath>>,
    /// No closed path of the kind that was asked for is shorter.
    pub(super) lower_bound: Option<f64>,
    pub(super) trees: Option<TreesAnswer>,
    pub(super) remarks: Vec<Remark>,
}

impl FoundGroups {
    pub(super) fn new(request: &GroupsRequest, shown: Vec<Shown>, producer: &Producer) -> Self {
        let (request, positions) = (request.clone(), producer.positions().clone());
        Self {
            request,
            shown,
            positions,
            compared: None,
            short: None,
            lower_bound: None,
            trees: None,
            remarks: Vec::new(),
        }
    }

    /// The presentation of the group of each component, as it was asked for.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{GroupsRequest, Producer};
    /// let rim = Producer::of(coface_io::read(&b"[[0,1],[1,2],[0,2]]"[..], coface_io::Format::Json)?)?;
    /// let found = GroupsRequest::new().found(&rim)?;
    /// assert!(found.presentations().all(|group| group.relators().is_empty()));
    /// # Ok(()) }
    /// ```
    pub fn presentations(&self) -> impl ExactSizeIterator<Item = &Presentation> {
        self.shown.iter().map(|shown| &shown.presentation)
    }

    /// The generators of all components as closed paths, by the numbers of vertices in the file.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{GroupsRequest, Producer};
    /// let rim = Producer::of(coface_io::read(&b"[[0,1],[1,2],[0,2]]"[..], coface_io::Format::Json)?)?;
    /// let found = GroupsRequest::new().loops(true).found(&rim)?;
    /// assert_eq!(found.loops().count(), 1);
    /// # Ok(()) }
    /// ```
    pub fn loops(&self) -> impl Iterator<Item = &[u32]> {
        self.shown.iter().flat_map(|shown| shown.loops.iter().map(Vec::as_slice))
    }

    /// The short closed paths, if they were asked for.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{GroupsRequest, Producer};
    /// let rim = Producer::of(coface_io::read(&b"[[0,1],[1,2],[0,2]]"[..], coface_io::Format::Json)?)?;
    /// assert_eq!(GroupsRequest::new().found(&rim)?.short_paths(), None);
    /// # Ok(()) }
    /// ```
    pub fn short_paths(&self) -> Option<&[ClosedPath]> {
        self.short.as_deref()
    }

    /// What was assumed or left out.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{GroupsRequest, Producer};
    /// let rim = Producer::of(coface_io::read(&b"[[0,1],[1,2],[0,2]]"[..], coface_io::Format::Json)?)?;
    /// assert!(GroupsRequest::new().found(&rim)?.remarks().is_empty());
    /// # Ok(()) }
    /// ```
    pub fn remarks(&self) -> &[Remark] {
        &self.remarks
    }

    /// The answer of `pi1`, with this name of the input.
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
    pub fn answer(&self, file: &str) -> Pi1Answer {
        let (walks, pairs) = self.compared.clone().unzip();
        Pi1Answer {
            file: file.to_owned(),
            simplified: self.request.is_simplified,
            components: self.shown.iter().map(component).collect(),
            cycles: self.short.clone(),
            walks,
            pairs,
            remarks: self.remarks.clone(),
        }
    }

    /// The answer of `loops`, with this name of the input.
    ///
    /// # Errors
    /// None: the loops are those of the model.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{GroupsRequest, Producer};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let rim = Producer::of(coface_io::read(&b"[[0,1],[1,2],[0,2]]"[..], coface_io::Format::Json)?)?;
    /// let answer = GroupsRequest::new().loops(true).found(&rim)?.loops_answer("rim.json")?;
    /// assert_eq!(answer.components[0].loops[0].length, 3.0);
    /// # Ok(()) }
    /// ```
    pub fn loops_answer(&self, file: &str) -> Result<LoopsAnswer, Error> {
        let of_component = |shown: &Shown| -> Result<LoopsComponent, Error> {
            let path = |vertices: &Vec<u32>| -> Result<ClosedPath, Error> {
                Ok(ClosedPath { length: self.length(vertices)?, vertices: vertices.clone() })
            };
            Ok(LoopsComponent {
                base: shown.base,
                name: shown.name.as_ref().map(GroupName::to_string),
                loops: shown.loops.iter().map(path).collect::<Result<_, _>>()?,
                relators: relators(shown),
            })
        };
        let mut remarks = self.remarks.clone();
        let has_loops = self.shown.iter().any(|shown| !shown.loops.is_empty());
        let is_said = remarks.iter().any(|said| said.code == RemarkCode::UnitLengths);
        if self.positions.dimension() == 0 && has_loops && !is_said {
            remarks.push(unit_lengths());
        }
        let kind = match self.request.surface_loops {
            SurfaceLoops::Any => "any",
            SurfaceLoops::Shortest => "shortest",
            SurfaceLoops::Canonical => "canonical",
        };
        Ok(LoopsAnswer {
            trees: self.trees.clone(),
            file: file.to_owned(),
            kind: kind.to_owned(),
            components: self.shown.iter().map(of_component).collect::<Result<_, _>>()?,
            remarks,
        })
    }

    /// The answer of `cycles`, with this name of the input; `None` unless short paths were asked for.
    pub fn cycles_answer(&self, file: &str) -> Option<CyclesAnswer> {
        let (kind, _) = self.request.short?;
        Some(CyclesAnswer {
            file: file.to_owned(),
            kind: kind.name().to_owned(),
            cycles: self.short.clone()?,
            lower_bound: self.lower_bound,
            remarks: self.remarks.clone(),
        })
    }

    /// The answer of `homotopic`, with this name of the input; `None` unless walks were given.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{GivenWalks, GroupsRequest, Producer};
    /// let ring = &b"[[0,1,4],[0,4,3],[1,2,5],[1,5,4],[2,0,3],[2,3,5]]"[..];
    /// let ring = Producer::of(coface_io::read(ring, coface_io::Format::Json)?)?;
    /// let walks = GivenWalks { place: "walks.json".to_owned(), walks: vec![vec![0, 1, 2, 0], vec![0, 1, 4, 0]] };
    /// let found = GroupsRequest::new().walks(Some(walks)).found(&ring)?;
    /// let answer = found.homotopic_answer("ring.json");
    /// assert_eq!(answer.map(|answer| answer.pairs[0].homotopic), Some(Some(false)));
    /// # Ok(()) }
    /// ```
    pub fn homotopic_answer(&self, file: &str) -> Option<HomotopicAnswer> {
        let (walks, pairs) = self.compared.clone()?;
        let of_component = |shown: &Shown| HomotopicComponent {
            base: shown.base,
            generators: shown.presentation.generator_count(),
            relators: relators(shown),
        };
        Some(HomotopicAnswer {
            file: file.to_owned(),
            components: self.shown.iter().map(of_component).collect(),
            walks,
            pairs,
            remarks: self.remarks.clone(),
        })
    }

    /// The answer of `subgroups`, with this name of the input; `None` unless subgroups were counted.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{GroupsRequest, Producer};
    /// let rim = Producer::of(coface_io::read(&b"[[0,1],[1,2],[0,2]]"[..], coface_io::Format::Json)?)?;
    /// let found = GroupsRequest::new().subgroups(Some(3)).found(&rim)?;
    /// assert_eq!(found.subgroups_answer("rim.json").map(|answer| answer.highest_index), Some(3));
    /// # Ok(()) }
    /// ```
    pub fn subgroups_answer(&self, file: &str) -> Option<SubgroupsAnswer> {
        let highest_index = self.request.highest_index?;
        let of_component = |shown: &Shown| {
            let Pi1Component { base, abelianization, name, counts, .. } = component(shown);
            SubgroupsComponent { base, abelianization, name, counts }
        };
        Some(SubgroupsAnswer {
            file: file.to_owned(),
            highest_index,
            components: self.shown.iter().map(of_component).collect(),
            remarks: self.remarks.clone(),
        })
    }

    /// The length of a closed path, or the number of its edges without positions that are all finite.
    fn length(&self, vertices: &[u32]) -> Result<f64, Error> {
        if self.positions.dimension() == 0 {
            return Ok(vertices.len().saturating_sub(1) as f64);
        }
        let ends: Vec<u32> = vertices.windows(2).flatten().copied().collect();
        Ok(self.positions.distances(&ends)?.iter().sum())
    }
}

/// That lengths are numbers of edges.
pub(super) fn unit_lengths() -> Remark {
    Remark::new(RemarkCode::UnitLengths, "there are no positions: each edge has the length 1")
}

fn relators(shown: &Shown) -> Vec<Vec<i32>> {
    shown.presentation.relators().iter().map(Word::letters).map(<[i32]>::to_vec).collect()
}

fn component(shown: &Shown) -> Pi1Component {
    Pi1Component {
        base: shown.base,
        generators: shown.presentation.generator_count(),
        relators: relators(shown),
        abelianization: GroupAnswer::from(&shown.presentation.abelianization()),
        name: shown.name.as_ref().map(GroupName::to_string),
        unrecognized: match (&shown.name, shown.presentation.abelianization().betti()) {
            (Some(_), _) => None,
            (None, 0) => Some(Unrecognized::GaveUp),
            (None, _) => Some(Unrecognized::NoRule),
        },
        space: shown.space.clone(),
        lengths: shown.lengths.clone(),
        counts: shown.counts.as_ref().map(super::Counts::answer),
    }
}
