//! Diagrams of Vietoris-Rips filtrations.

use crate::persistence::Barcode;
use coface_algebra::VertexId;

/// A class of a Vietoris-Rips filtration: the diameters at which it is born and dies, and the simplices that make and end it.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct RipsPair {
    pub(super) degree: usize,
    pub(super) birth: f64,
    pub(super) death: Option<f64>,
    pub(super) birth_simplex: Vec<VertexId>,
    pub(super) death_simplex: Option<Vec<VertexId>>,
}

impl RipsPair {
    /// The degree of the class.
    ///
    /// # Examples
    /// See [`RipsDiagram`].
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// The diameter at which it is born.
    ///
    /// # Examples
    /// See [`RipsDiagram`].
    pub fn birth(&self) -> f64 {
        self.birth
    }

    /// The diameter at which it dies; `None` if it lives at the threshold.
    ///
    /// # Examples
    /// See [`RipsDiagram`].
    pub fn death(&self) -> Option<f64> {
        self.death
    }

    /// The points of the simplex that makes the class, rising.
    ///
    /// # Examples
    /// See [`RipsDiagram`].
    pub fn birth_simplex(&self) -> &[VertexId] {
        &self.birth_simplex
    }

    /// The points of the simplex that ends the class, rising, one more than those that make it.
    ///
    /// # Examples
    /// See [`RipsDiagram`].
    pub fn death_simplex(&self) -> Option<&[VertexId]> {
        self.death_simplex.as_deref()
    }
}

/// A sum of simplices of a Vietoris-Rips filtration whose coboundary begins with the simplex that ends the class of its first term, or is zero.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct RipsCochain {
    pub(super) terms: Vec<(u32, Vec<VertexId>)>,
}

impl RipsCochain {
    /// The simplices by their points, rising, with their coefficients, from 1 to the prime less 1: first the one that makes the class, then others that enter later.
    /// A simplex without the i-th of its points, counted from the last one down from 0, has the incidence $(-1)^i$ in it.
    ///
    /// # Examples
    /// See [`RipsFiltration::persistence_with_cochains`](super::RipsFiltration::persistence_with_cochains).
    pub fn terms(&self) -> &[(u32, Vec<VertexId>)] {
        &self.terms
    }
}

/// The classes of a Vietoris-Rips filtration that live longer than a moment: by rising degree, then in the order of births.
///
/// # Examples
/// The corners of a unit square: the loop of the four sides is filled when the diagonals come.
/// ```
/// use coface_complexes::filtered::Distances;
/// use coface_topology::{Coefficients, RipsFiltration};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let root = 2f64.sqrt();
/// let square = Distances::from_lower_triangle(4, vec![1.0, root, 1.0, 1.0, root, 1.0])?;
/// let diagram = RipsFiltration::new(&square, Some(2.0))?.persistence(1, Coefficients::Modulo(2))?;
/// let hole = &diagram.pairs_of_degree(1)[0];
/// assert_eq!((hole.degree(), hole.birth(), hole.death()), (1, 1.0, Some(root)));
/// assert_eq!((hole.birth_simplex().len(), hole.death_simplex().map(<[_]>::len)), (2, Some(3)));
/// assert_eq!(diagram.betti_numbers(), [1, 0]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct RipsDiagram {
    pub(super) prime: u32,
    pub(super) threshold: f64,
    pub(super) degrees: Vec<Vec<RipsPair>>,
}

impl RipsDiagram {
    /// The number of elements of the field.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::filtered::Distances;
    /// use coface_topology::{Coefficients, RipsFiltration};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let two = RipsFiltration::new(&Distances::from_lower_triangle(2, vec![3.0])?, None)?;
    /// assert_eq!(two.persistence(0, Coefficients::Modulo(5))?.prime(), 5);
    /// # Ok(()) }
    /// ```
    pub fn prime(&self) -> u32 {
        self.prime
    }

    /// The largest diameter of the simplices that were looked at.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::filtered::Distances;
    /// use coface_topology::{Coefficients, RipsFiltration};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let two = RipsFiltration::new(&Distances::from_lower_triangle(2, vec![3.0])?, None)?;
    /// assert_eq!(two.persistence(0, Coefficients::Modulo(2))?.threshold(), 3.0);
    /// # Ok(()) }
    /// ```
    pub fn threshold(&self) -> f64 {
        self.threshold
    }

    /// The number of degrees.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::filtered::Distances;
    /// use coface_topology::{Coefficients, RipsFiltration};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let two = RipsFiltration::new(&Distances::from_lower_triangle(2, vec![3.0])?, None)?;
    /// assert_eq!(two.persistence(1, Coefficients::Modulo(2))?.degree_count(), 2);
    /// # Ok(()) }
    /// ```
    pub fn degree_count(&self) -> usize {
        self.degrees.len()
    }

    /// All pairs.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::filtered::Distances;
    /// use coface_topology::{Coefficients, RipsFiltration};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let two = RipsFiltration::new(&Distances::from_lower_triangle(2, vec![3.0])?, None)?;
    /// // One point stays, the other one is joined to it at 3.
    /// assert_eq!(two.persistence(1, Coefficients::Modulo(2))?.pairs().count(), 2);
    /// # Ok(()) }
    /// ```
    pub fn pairs(&self) -> impl Iterator<Item = &RipsPair> {
        self.degrees.iter().flatten()
    }

    /// The pairs of a degree; empty beyond the degrees that were asked for.
    ///
    /// # Examples
    /// See [`RipsDiagram`].
    pub fn pairs_of_degree(&self, degree: usize) -> &[RipsPair] {
        self.degrees.get(degree).map_or(&[], Vec::as_slice)
    }

    /// The births and deaths of a degree; deaths of essential classes are infinite.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::filtered::Distances;
    /// use coface_topology::{Coefficients, RipsFiltration};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let two = RipsFiltration::new(&Distances::from_lower_triangle(2, vec![3.0])?, None)?;
    /// let diagram = two.persistence(0, Coefficients::Modulo(2))?;
    /// assert_eq!(diagram.barcode(0).intervals(), [[0.0, f64::INFINITY], [0.0, 3.0]]);
    /// # Ok(()) }
    /// ```
    pub fn barcode(&self, degree: usize) -> Barcode {
        let pairs = self.pairs_of_degree(degree).iter();
        Barcode::of(pairs.map(|pair| [pair.birth, pair.death.unwrap_or(f64::INFINITY)]))
    }

    /// The numbers of classes that live at the threshold, by degree.
    ///
    /// # Examples
    /// See [`RipsDiagram`].
    pub fn betti_numbers(&self) -> Vec<usize> {
        let essential = |pairs: &Vec<RipsPair>| pairs.iter().filter(|pair| pair.death.is_none()).count();
        self.degrees.iter().map(essential).collect()
    }
}
