//! Simplicial complexes that change: simplices come with their faces and go with their cofaces.

use super::Simplex;
use crate::{Error, ErrorKind, VertexId};
use std::collections::BTreeSet;
use std::fmt;

/// A finite set of simplices that holds with each one all its faces.
///
/// # Examples
/// Two triangles with a common edge:
/// ```
/// use coface::simplicial::{Simplex, SimplicialComplex};
/// # fn main() -> Result<(), coface::Error> {
/// let mut complex = SimplicialComplex::from_facets([[0, 1, 2], [1, 2, 3]])?;
/// assert_eq!(complex.f_vector(), [4, 5, 2]);
/// complex.erase(&Simplex::from([1, 2]));
/// assert_eq!(complex.f_vector(), [4, 4]);
/// assert_eq!(complex.dimension(), Some(1));
/// # Ok(()) }
/// ```
#[derive(Clone, Default, PartialEq, Eq)]
pub struct SimplicialComplex {
    simplices: BTreeSet<Simplex>,
}

impl SimplicialComplex {
    /// The complex without simplices.
    pub fn new() -> Self {
        Self::default()
    }

    /// The smallest complex with these simplices, given as lists of vertex numbers in any order.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] naming the first list without a vertex or with a repeated one;
    /// [`ErrorKind::TooLarge`] if there would be too many simplices.
    pub fn from_facets<L: AsRef<[u32]>>(facets: impl IntoIterator<Item = L>) -> Result<Self, Error> {
        let mut complex = Self::new();
        complex.extend(facets)?;
        Ok(complex)
    }

    /// The complex of exactly these simplices.
    ///
    /// # Errors
    /// [`ErrorKind::NotAComplex`] naming the faces that are missing.
    pub fn from_simplices(simplices: impl IntoIterator<Item = Simplex>) -> Result<Self, Error> {
        let given: BTreeSet<Simplex> = simplices.into_iter().collect();
        let complex = Self::from_facets(&given)?;
        let missing: Vec<&Simplex> = complex.simplices.difference(&given).collect();
        match missing.as_slice() {
            [] => Ok(complex),
            [first, ..] => Err(Error::new(
                ErrorKind::NotAComplex,
                format!("{} faces are missing, the first is {first}", missing.len()),
            )),
        }
    }

    /// Inserts these simplices with all faces.
    ///
    /// # Errors
    /// As [`Self::from_facets`]; the complex is then as before.
    pub fn extend<L: AsRef<[u32]>>(&mut self, facets: impl IntoIterator<Item = L>) -> Result<(), Error> {
        for facet in facets {
            self.insert(&Simplex::from_numbers(facet.as_ref())?)?;
        }
        Ok(())
    }

    /// Inserts a simplex with all its faces; tells whether it was new.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] if it has more than 2^28 faces.
    pub fn insert(&mut self, simplex: &Simplex) -> Result<bool, Error> {
        self.insert_skeleton(simplex, simplex.dimension())
    }

    /// Inserts the faces of dimension up to `dimension` of a simplex; tells whether one of them was new.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] if there are more than 2^28 such faces.
    pub fn insert_skeleton(&mut self, simplex: &Simplex, dimension: usize) -> Result<bool, Error> {
        if simplex.vertex_count() > 28 {
            return Err(Error::new(ErrorKind::TooLarge, "too many faces"));
        }
        let before = self.simplices.len();
        self.simplices.extend(simplex.faces().take_while(|face| face.dimension() <= dimension));
        Ok(self.simplices.len() > before)
    }

    /// Erases a simplex with all its cofaces; tells whether it was there.
    pub fn erase(&mut self, simplex: &Simplex) -> bool {
        let before = self.simplices.len();
        self.simplices.retain(|other| !simplex.is_face_of(other));
        self.simplices.len() < before
    }

    /// Whether the simplex is in the complex.
    pub fn contains(&self, simplex: &Simplex) -> bool {
        self.simplices.contains(simplex)
    }

    /// The greatest dimension of a simplex; `None` for the empty complex.
    pub fn dimension(&self) -> Option<usize> {
        self.simplices.iter().map(Simplex::dimension).max()
    }

    /// The number of simplices of this dimension.
    pub fn simplex_count(&self, dimension: usize) -> usize {
        self.simplices(dimension).count()
    }

    /// The numbers of simplices of dimension 0, 1, ...; empty for the empty complex.
    pub fn f_vector(&self) -> Vec<usize> {
        self.dimension().map_or(Vec::new(), |top| (0..=top).map(|k| self.simplex_count(k)).collect())
    }

    /// The number of simplices.
    pub fn len(&self) -> usize {
        self.simplices.len()
    }

    /// Whether there is no simplex.
    pub fn is_empty(&self) -> bool {
        self.simplices.is_empty()
    }

    /// All simplices in lexicographic order (the order of [`Simplex`]).
    pub fn iter(&self) -> impl Iterator<Item = Simplex> + '_ {
        self.simplices.iter().cloned()
    }

    /// The simplices of one dimension in lexicographic order.
    pub fn simplices(&self, dimension: usize) -> impl Iterator<Item = Simplex> + '_ {
        self.iter().filter(move |simplex| simplex.dimension() == dimension)
    }

    /// The vertices, rising.
    pub fn vertices(&self) -> impl Iterator<Item = VertexId> + '_ {
        self.simplices(0).map(|simplex| VertexId::from_u32(simplex.numbers()[0]))
    }

    /// The cofaces of a simplex, itself included: its star. None if it is not in the complex. Their order is the same
    /// in each run but is not specified.
    pub fn cofaces<'a>(&'a self, simplex: &Simplex) -> impl Iterator<Item = Simplex> + use<'a> {
        let simplex = simplex.clone();
        self.simplices.iter().filter(move |other| simplex.is_face_of(other)).cloned()
    }

    /// The vertices that share an edge with `vertex`, rising.
    ///
    /// # Errors
    /// [`ErrorKind::NotInComplex`] if `vertex` is not in the complex.
    pub fn adjacent_vertices(&self, vertex: VertexId) -> Result<Vec<VertexId>, Error> {
        let of = Simplex::vertex(vertex);
        self.require(&of)?;
        let edges = self.cofaces(&of).filter(|coface| coface.dimension() == 1);
        Ok(edges.filter_map(|edge| edge.vertices().find(|&other| other != vertex)).collect())
    }

    /// The complex of all faces of all cofaces of a simplex: the closure of its star.
    ///
    /// # Errors
    /// [`ErrorKind::NotInComplex`] if `simplex` is not in the complex.
    pub fn closed_star(&self, simplex: &Simplex) -> Result<Self, Error> {
        self.require(simplex)?;
        Self::from_facets(self.cofaces(simplex))
    }

    /// The maximal simplices in lexicographic order.
    pub fn facets(&self) -> Vec<Simplex> {
        self.iter().filter(|simplex| self.cofaces(simplex).count() == 1).collect()
    }

    /// Verifies the invariants: every face of every simplex is there.
    ///
    /// # Errors
    /// [`ErrorKind::NotAComplex`] naming the first broken one.
    pub fn check(&self) -> Result<(), Error> {
        Self::from_simplices(self.iter()).map(|_| ())
    }

    /// An error unless the simplex is in the complex.
    ///
    /// # Errors
    /// [`ErrorKind::NotInComplex`].
    pub(super) fn require(&self, simplex: &Simplex) -> Result<(), Error> {
        if self.contains(simplex) {
            return Ok(());
        }
        Err(Error::new(ErrorKind::NotInComplex, format!("the simplex {simplex} is not in the complex")))
    }
}

impl fmt::Debug for SimplicialComplex {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_set().entries(self.iter()).finish()
    }
}
