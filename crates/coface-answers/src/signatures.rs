//! What is asked about each gluing table of a census.

use crate::answer::{GroupAnswer, HomologyGroup, PresentedGroup, SignatureAnswer, SpaceAnswer};
use coface_algebra::{Error, Word};
use coface_complexes::gluing::{FaceClasses, GluingTable};
use coface_topology::{
    EdgePathGroups, Effort, GroupName, Simplification, gluing_manifold_verdict, homology, named_space,
};

/// Asks what is known of gluing tables of tetrahedra, one after the other.
///
/// # Examples
/// The complement of the figure-eight knot: its ideal vertex is cut off.
/// ```
/// use coface_answers::SignatureRequest;
/// use coface_complexes::gluing::GluingTable;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let knot = GluingTable::from_isomorphism_signature("cPcbbbiht", 3)?;
/// let answer = SignatureRequest::new().answer(&knot)?;
/// assert_eq!((answer.ideal_vertices, answer.homology[1].betti), (1, 1));
/// # Ok(()) }
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SignatureRequest {
    has_groups: bool,
    has_names: bool,
    is_pseudomanifold: bool,
}

/// Letters that the search for the name of one group reads or writes: a few milliseconds. It is the same on every machine.
const STEPS: u64 = 10_000_000;

/// How often moves are tried where a triangulation does not show which space it is.
const ATTEMPTS: usize = 12;

impl SignatureRequest {
    /// Homology and verdicts.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::SignatureRequest;
    /// assert_eq!(SignatureRequest::new(), SignatureRequest::default());
    /// ```
    pub fn new() -> Self {
        Self::default()
    }

    /// Whether fundamental groups are asked for too.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::SignatureRequest;
    /// use coface_complexes::gluing::GluingTable;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let lens = GluingTable::from_isomorphism_signature("cMcabbjxr", 3)?;
    /// let groups = SignatureRequest::new().groups(true).answer(&lens)?.groups;
    /// assert_eq!(groups.as_ref().and_then(|groups| groups[0].name.as_deref()), Some("Z/5"));
    /// # Ok(()) }
    /// ```
    #[must_use]
    pub fn groups(mut self, has_groups: bool) -> Self {
        self.has_groups = has_groups;
        self
    }

    /// Whether [fundamental groups](Self::groups) are asked for.
    ///
    /// # Examples
    /// ```
    /// assert!(!coface_answers::SignatureRequest::new().has_groups());
    /// ```
    pub fn has_groups(&self) -> bool {
        self.has_groups
    }

    /// Whether the names of the spaces are asked for too.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::SignatureRequest;
    /// use coface_complexes::gluing::GluingTable;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let lens = GluingTable::from_isomorphism_signature("cMcabbjqs", 3)?;
    /// let space = SignatureRequest::new().names(true).answer(&lens)?.space.flatten();
    /// assert_eq!(space.map(|space| space.name).as_deref(), Some("L(8,3)"));
    /// # Ok(()) }
    /// ```
    #[must_use]
    pub fn names(mut self, has_names: bool) -> Self {
        self.has_names = has_names;
        self
    }

    /// Whether the [names of the spaces](Self::names) are asked for.
    ///
    /// # Examples
    /// ```
    /// assert!(!coface_answers::SignatureRequest::new().has_names());
    /// ```
    pub fn has_names(&self) -> bool {
        self.has_names
    }

    /// Whether ideal vertices are points, and are not cut off.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::SignatureRequest;
    /// use coface_complexes::gluing::GluingTable;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let knot = GluingTable::from_isomorphism_signature("cPcbbbiht", 3)?;
    /// let answer = SignatureRequest::new().pseudomanifold(true).answer(&knot)?;
    /// assert_eq!((answer.manifold.as_str(), answer.homology[1].betti), ("no", 0));
    /// # Ok(()) }
    /// ```
    #[must_use]
    pub fn pseudomanifold(mut self, is_pseudomanifold: bool) -> Self {
        self.is_pseudomanifold = is_pseudomanifold;
        self
    }

    /// What is known of a table of dimension 3.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`](coface_algebra::ErrorKind::TooLarge) for subdivisions beyond their limits.
    ///
    /// # Complexity
    /// Near-linear for homology; names of groups within a fixed number of steps.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::SignatureRequest;
    /// use coface_complexes::gluing::GluingTable;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let lens = GluingTable::from_isomorphism_signature("cMcabbjxr", 3)?;
    /// let answer = SignatureRequest::new().answer(&lens)?;
    /// assert_eq!((answer.manifold.as_str(), answer.homology[1].torsion.len()), ("yes", 1));
    /// # Ok(()) }
    /// ```
    pub fn answer(&self, table: &GluingTable) -> Result<SignatureAnswer, Error> {
        let faces = table.faces()?;
        let ideal_vertices = table.ideal_vertices(&faces)?.len();
        let f_vector = faces.class_counts();
        let closed = table.is_closed();
        if ideal_vertices == 0 || self.is_pseudomanifold {
            return self.of_space(table, &faces, (f_vector, closed, ideal_vertices));
        }
        let bounded = table.truncated(&faces)?;
        self.of_space(&bounded, &bounded.faces()?, (f_vector, closed, ideal_vertices))
    }

    /// What is known of the space of a table, beside what was counted before.
    fn of_space(
        &self,
        table: &GluingTable,
        faces: &FaceClasses,
        (f_vector, closed, ideal_vertices): (Vec<usize>, bool, usize),
    ) -> Result<SignatureAnswer, Error> {
        let verdict = gluing_manifold_verdict(table, faces)?;
        let groups = homology(&faces.chain_complex()?);
        Ok(SignatureAnswer {
            f_vector,
            components: table.components().count(),
            closed,
            ideal_vertices,
            euler_characteristic: groups.euler_characteristic(),
            manifold: verdict.as_str().to_owned(),
            witness: verdict.witness().map(|witness| witness.message().to_owned()),
            orientable: table.orientation().odd_cycle().is_none(),
            homology: HomologyGroup::list(groups.groups()),
            space: match self.has_names {
                true => Some(named_space(table, faces, ATTEMPTS)?.as_ref().map(SpaceAnswer::of)),
                false => None,
            },
            groups: if self.has_groups { Some(presented(table, faces)?) } else { None },
        })
    }
}

/// The fundamental groups of the components; where a presentation does not say which group it is, the name of the space may.
fn presented(table: &GluingTable, faces: &FaceClasses) -> Result<Vec<PresentedGroup>, Error> {
    let groups = EdgePathGroups::new(&faces.two_skeleton()?);
    let effort = Effort::new().max_steps(STEPS);
    let of_component = |component: usize| -> Result<PresentedGroup, Error> {
        let simpler = Simplification::new(groups.presentation(component), effort);
        let presentation = simpler.presentation();
        let mut name = presentation.recognized(effort);
        if !name.as_ref().is_some_and(GroupName::is_complete) {
            let space = named_space(table, faces, ATTEMPTS)?;
            name = space.and_then(|space| space.name().fundamental_group()).or(name);
        }
        Ok(PresentedGroup {
            name: name.as_ref().map(GroupName::to_string),
            generators: presentation.generator_count(),
            relators: presentation.relators().iter().map(Word::letters).map(<[i32]>::to_vec).collect(),
            abelianization: GroupAnswer::from(&presentation.abelianization()),
        })
    };
    (0..groups.component_count()).map(of_component).collect()
}
