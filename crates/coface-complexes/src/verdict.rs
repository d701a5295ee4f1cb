//! Whether a complex is a manifold: yes, no or unknown, with a witness, for every producer that can be asked.

/// What a manifold test found: yes, no or unknown, whether there is a boundary, and the place that shows why not.
///
/// The **witness** is of the producer's own type: edges and vertices of a mesh, simplices of a complex, face classes of a
/// gluing table. The **findings** are what the test counted on its way, for all three answers.
///
/// # Examples
/// ```
/// use coface_complexes::known_spaces::simplex_boundary;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let sphere = simplex_boundary(3)?;
/// assert_eq!(sphere.manifold_verdict()?.as_str(), "yes");
/// let v = coface_algebra::VertexId::new(0);
/// let pinched = sphere.wedge(v, &sphere, v)?.into_complex();
/// assert_eq!(pinched.manifold_verdict()?.to_bool(), Some(false));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Verdict<Witness, Findings> {
    pub(crate) decision: Decision<Witness>,
    pub(crate) is_closed: bool,
    pub(crate) findings: Findings,
}

/// The three answers of a test that may stay open.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Decision<Witness> {
    /// It is.
    Yes,
    /// It is not, for the reason that the witness names.
    No(Witness),
    /// The witness was not recognized, and nothing is known to be bad.
    Unknown(Witness),
}

impl<Witness> Decision<Witness> {
    /// The answer of a test that is never open: no if there is a witness.
    pub(crate) fn of(witness: Option<Witness>) -> Self {
        witness.map_or(Self::Yes, Self::No)
    }
}

impl<Witness, Findings> Verdict<Witness, Findings> {
    /// The same findings with the answer no, for a crate above that refutes what stayed open.
    #[doc(hidden)]
    #[must_use]
    pub fn refuted(self, witness: Witness) -> Self {
        Self { decision: Decision::No(witness), ..self }
    }

    /// Yes, no, or `None` for unknown.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::known_spaces::simplex_boundary;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let verdict = simplex_boundary(3)?.manifold_verdict()?;
    /// assert_eq!(verdict.to_bool(), Some(true));
    /// # Ok(()) }
    /// ```
    pub fn to_bool(&self) -> Option<bool> {
        match self.decision {
            Decision::Yes => Some(true),
            Decision::No(_) => Some(false),
            Decision::Unknown(_) => None,
        }
    }

    /// Whether it was found to be a manifold, with or without boundary: the answer is yes.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::PolygonMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let book = PolygonMesh::new(5, RaggedArray::from_lists([[0, 1, 2], [0, 1, 3], [0, 1, 4]]), &[])?;
    /// assert!(!book.manifold_verdict().is_manifold());
    /// # Ok(()) }
    /// ```
    pub fn is_manifold(&self) -> bool {
        matches!(self.decision, Decision::Yes)
    }

    /// The word of the report: "yes", "no" or "unknown".
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::known_spaces::simplex_boundary;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let verdict = simplex_boundary(3)?.manifold_verdict()?;
    /// assert_eq!(verdict.as_str(), "yes");
    /// # Ok(()) }
    /// ```
    pub fn as_str(&self) -> &'static str {
        match self.decision {
            Decision::Yes => "yes",
            Decision::No(_) => "no",
            Decision::Unknown(_) => "unknown",
        }
    }

    /// Whether there is no boundary: no cell of codimension one lies in exactly one top cell. Loose cells, such as an
    /// edge without a face, have no part in it.
    ///
    /// # Examples
    /// A tetrahedron has four boundary faces:
    /// ```
    /// use coface_complexes::known_spaces::{simplex, simplex_boundary};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert!(!simplex(3)?.manifold_verdict()?.is_closed());
    /// assert!(simplex_boundary(3)?.manifold_verdict()?.is_closed());
    /// # Ok(()) }
    /// ```
    pub fn is_closed(&self) -> bool {
        self.is_closed
    }

    /// The first place that shows "no", or that keeps the answer "unknown".
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::known_spaces::simplex_boundary;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let verdict = simplex_boundary(3)?.manifold_verdict()?;
    /// assert!(verdict.witness().is_none());
    /// # Ok(()) }
    /// ```
    pub fn witness(&self) -> Option<&Witness> {
        match &self.decision {
            Decision::Yes => None,
            Decision::No(witness) | Decision::Unknown(witness) => Some(witness),
        }
    }

    /// What the test counted on its way.
    ///
    /// # Examples
    /// A 4-simplex has five boundary facets, and five vertex links that were collapsed:
    /// ```
    /// use coface_complexes::known_spaces::simplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let verdict = simplex(4)?.manifold_verdict()?;
    /// let found = verdict.findings();
    /// assert_eq!((found.boundary_facet_count(), found.collapsed_link_count()), (5, 5));
    /// # Ok(()) }
    /// ```
    pub fn findings(&self) -> &Findings {
        &self.findings
    }
}

/// What the manifold test counts where links of any dimension are recognized.
///
/// # Examples
/// ```
/// use coface_complexes::known_spaces::simplex_boundary;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let verdict = simplex_boundary(3)?.manifold_verdict()?;
/// assert_eq!(verdict.findings().boundary_facet_count(), 0);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LinkFindings {
    pub(crate) boundary_facet_count: usize,
    pub(crate) collapsed_link_count: usize,
}

impl LinkFindings {
    /// The number of cells of codimension one in exactly one top cell. The boundary vertices are theirs: the vertices whose
    /// link is a ball.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::known_spaces::simplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(simplex(2)?.manifold_verdict()?.findings().boundary_facet_count(), 3);
    /// # Ok(()) }
    /// ```
    pub fn boundary_facet_count(&self) -> usize {
        self.boundary_facet_count
    }

    /// How many links of dimension 3 and more were collapsed to show that they are spheres or balls; links of lower
    /// dimension are recognized by their Euler characteristic.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::known_spaces::simplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(simplex(3)?.manifold_verdict()?.findings().collapsed_link_count(), 0);
    /// # Ok(()) }
    /// ```
    pub fn collapsed_link_count(&self) -> usize {
        self.collapsed_link_count
    }
}
