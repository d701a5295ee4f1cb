//! What homology is of: the whole model or some groups of it, relative to a part.

use crate::{Pair, Producer, named_groups};
use coface_algebra::Error;
use coface_algebra::chains::ChainComplex;
use coface_io::{Model, msh};

/// What homology is relative to.
#[derive(Clone, Debug)]
pub enum RelativeTo {
    /// The boundary of the domain.
    Boundary,
    /// The subcomplex of the cells of another model, by the same vertex numbers.
    Part {
        /// What the part is called in messages.
        name: String,
        /// The part.
        model: Box<Model>,
    },
    /// Groups of the model by names or numbers, as [`named_groups`] finds them.
    Groups(Vec<String>),
}

impl RelativeTo {
    /// What the part is called: `boundary`, the name of the other model, or those of the groups.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::RelativeTo;
    /// assert_eq!(RelativeTo::Groups(vec!["lid".to_owned(), "rim".to_owned()]).name(), "lid, rim");
    /// ```
    pub fn name(&self) -> String {
        match self {
            Self::Boundary => "boundary".to_owned(),
            Self::Part { name, .. } => name.clone(),
            Self::Groups(words) => words.join(", "),
        }
    }
}

/// The domain of homology and what it is relative to; by default the whole model.
///
/// # Examples
/// ```
/// use coface_answers::{Domain, RelativeTo};
/// assert!(Domain::default().is_whole());
/// assert!(!Domain { relative: Some(RelativeTo::Boundary), ..Domain::default() }.is_whole());
/// ```
#[derive(Clone, Debug, Default)]
pub struct Domain {
    /// The groups of the model, by names or numbers, whose cells and faces are the domain; the whole model without any.
    pub groups: Vec<String>,
    /// What the domain is taken relative to.
    pub relative: Option<RelativeTo>,
}

impl Domain {
    /// Whether it is the whole model, relative to nothing.
    ///
    /// # Examples
    /// See [`Domain`].
    pub fn is_whole(&self) -> bool {
        self.groups.is_empty() && self.relative.is_none()
    }

    /// Whether groups of the model are named.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{Domain, RelativeTo};
    /// assert!(Domain { groups: vec!["air".to_owned()], relative: None }.has_groups());
    /// assert!(!Domain { groups: vec![], relative: Some(RelativeTo::Boundary) }.has_groups());
    /// ```
    pub fn has_groups(&self) -> bool {
        !self.groups.is_empty() || matches!(self.relative, Some(RelativeTo::Groups(_)))
    }

    /// The pair of the domain and what it is relative to; `None` for the whole model. The mesh is what the producer was made of, and must be
    /// there if groups are named.
    ///
    /// # Errors
    /// Those of [`named_groups`], and of [`Pair::with_model`] with the name of the part.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{Domain, Producer, RelativeTo};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let disk = Producer::of(coface_io::read(&b"[[0,1,2],[0,2,3]]"[..], coface_io::Format::Json)?)?;
    /// let domain = Domain { groups: vec![], relative: Some(RelativeTo::Boundary) };
    /// let pair = domain.pair(&disk, &disk.chain_complex()?, None)?;
    /// assert_eq!(pair.map(|pair| pair.chains().f_vector().to_vec()), Some(vec![0, 1, 2]));
    /// # Ok(()) }
    /// ```
    pub fn pair(
        &self,
        producer: &Producer,
        whole: &ChainComplex,
        mesh: Option<&Model>,
    ) -> Result<Option<Pair>, Error> {
        let cells = |words: &[String]| match mesh {
            Some(mesh) => producer.cells_of_groups(mesh, &named_groups(mesh, words)?),
            None => Err(Error::invalid("the groups of the model are not known")),
        };
        let domain = match self.groups.is_empty() {
            true => None,
            false => Some(Pair::of_cells(whole, &cells(&self.groups)?)?),
        };
        let absolute = |domain: Option<Pair>| domain.unwrap_or_else(|| Pair::absolute(whole.clone()));
        Ok(match (&self.relative, domain) {
            (None, domain) => domain,
            (Some(RelativeTo::Boundary), None) => Some(Pair::with_boundary(producer, whole)?),
            (Some(RelativeTo::Boundary), Some(domain)) => Some(domain.modulo_boundary()?),
            (Some(RelativeTo::Groups(words)), domain) => {
                Some(absolute(domain).modulo_cells(whole, &cells(words)?)?)
            }
            (Some(RelativeTo::Part { name, model }), None) => {
                let pair = Pair::with_model(producer, whole, model);
                Some(pair.map_err(|error| error.in_file(name.clone()))?)
            }
            (Some(RelativeTo::Part { name, model }), Some(domain)) => {
                let cells = Pair::cells_of_model(producer, whole, model);
                let cells = cells.map_err(|error| error.in_file(name.clone()))?;
                Some(domain.modulo_cells(whole, &cells)?)
            }
        })
    }

    /// The domain as Gmsh writes it in the names of generators: `{1},{70,71}`, with the tags of groups, 0 for the whole mesh.
    pub(crate) fn words(&self, mesh: &Model) -> Result<String, Error> {
        let tags = msh::physical_tags(mesh);
        let listed = |words: &[String]| {
            let found = named_groups(mesh, words)?;
            let groups = mesh.groups().iter().zip(&tags);
            // In the order in which they are named, one tag once.
            let mut listed: Vec<String> = Vec::new();
            for named in found {
                let tag = groups
                    .clone()
                    .find(|(group, _)| std::ptr::eq(*group, named))
                    .map(|(_, tag)| tag.to_string());
                listed.extend(tag.filter(|tag| !listed.contains(tag)));
            }
            Ok::<_, Error>(listed.join(","))
        };
        let domain = if self.groups.is_empty() { "0".to_owned() } else { listed(&self.groups)? };
        Ok(match &self.relative {
            None => format!("{{{domain}}}"),
            Some(RelativeTo::Boundary) => format!("{{{domain}}},{{boundary}}"),
            Some(RelativeTo::Part { .. }) => format!("{{{domain}}},{{file}}"),
            Some(RelativeTo::Groups(words)) => format!("{{{domain}}},{{{}}}", listed(words)?),
        })
    }

    /// In a certificate, what the whole model is relative to.
    pub(crate) fn word(&self) -> Option<&'static str> {
        match self.relative.as_ref()? {
            RelativeTo::Boundary => Some("boundary"),
            RelativeTo::Part { .. } => Some("file"),
            RelativeTo::Groups(_) => None,
        }
    }
}
