//! The answer to a question that may stay open.

/// Yes with a certificate, no with a witness, or unknown with what was not recognized.
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
#[non_exhaustive]
pub enum Verdict<Certificate, Witness> {
    /// It is.
    Yes(Certificate),
    /// It is not, for the reason that the witness names.
    No(Witness),
    /// The witness was not recognized, and nothing is known to be bad.
    Unknown(Witness),
}

impl<Certificate, Witness> Verdict<Certificate, Witness> {
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
        match self {
            Self::Yes(_) => Some(true),
            Self::No(_) => Some(false),
            Self::Unknown(_) => None,
        }
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
        match self {
            Self::Yes(_) => "yes",
            Self::No(_) => "no",
            Self::Unknown(_) => "unknown",
        }
    }

    /// The witness of "no" and "unknown".
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
        match self {
            Self::Yes(_) => None,
            Self::No(witness) | Self::Unknown(witness) => Some(witness),
        }
    }
}
