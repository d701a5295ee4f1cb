//! Harmonic cochains and the Hodge decomposition.

use super::MetricComplex;
use super::image::image_basis;
use super::least_squares::ExactProjection;
use crate::homology::HomologyBasis;
use coface_algebra::Error;
use coface_algebra::Integer;
use coface_algebra::chains::{ChainComplex, Cochain, MorseComplex};
use coface_algebra::progress::stage;

/// The harmonic cochain of an integral cohomology class, with measures of what rounding left.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct HarmonicCochain {
    cochain: Cochain<f64>,
    class: Cochain<Integer>,
    closed_residual: f64,
    coclosed_residual: f64,
}

impl HarmonicCochain {
    /// The harmonic cochain. On cycles it has the values of [`Self::class`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::{HodgeSpace, MetricComplex};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A circle of two edges from vertex 0 to vertex 1.
    /// let edges = SparseMatrix::from_entries(2, 2, [(0, 0, -1), (1, 0, 1), (0, 1, -1), (1, 1, 1)])?;
    /// let circle = ChainComplex::new(vec![edges])?;
    /// let metric = MetricComplex::new(&circle);
    /// let space = HodgeSpace::new(&metric, 1)?;
    /// let harmonic = &space.harmonic_basis()[0];
    /// // It has the value 1/2 along one edge and -1/2 along the other.
    /// let values = harmonic.cochain().terms().iter().map(|(_, x)| x.abs());
    /// assert!(values.into_iter().all(|x| (x - 0.5).abs() < 1e-12));
    /// # Ok(()) }
    /// ```
    pub fn cochain(&self) -> &Cochain<f64> {
        &self.cochain
    }

    /// A closed integral cochain of the same class.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::{HodgeSpace, MetricComplex};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A circle of two edges from vertex 0 to vertex 1.
    /// let edges = SparseMatrix::from_entries(2, 2, [(0, 0, -1), (1, 0, 1), (0, 1, -1), (1, 1, 1)])?;
    /// let circle = ChainComplex::new(vec![edges])?;
    /// let metric = MetricComplex::new(&circle);
    /// let space = HodgeSpace::new(&metric, 1)?;
    /// let harmonic = &space.harmonic_basis()[0];
    /// assert!(circle.is_closed(harmonic.class())?);
    /// # Ok(()) }
    /// ```
    pub fn class(&self) -> &Cochain<Integer> {
        &self.class
    }

    /// The norm of the coboundary, zero but for rounding.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::{HodgeSpace, MetricComplex};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A circle of two edges from vertex 0 to vertex 1.
    /// let edges = SparseMatrix::from_entries(2, 2, [(0, 0, -1), (1, 0, 1), (0, 1, -1), (1, 1, 1)])?;
    /// let circle = ChainComplex::new(vec![edges])?;
    /// let metric = MetricComplex::new(&circle);
    /// let space = HodgeSpace::new(&metric, 1)?;
    /// let harmonic = &space.harmonic_basis()[0];
    /// assert!(harmonic.closed_residual() < 1e-12);
    /// # Ok(()) }
    /// ```
    pub fn closed_residual(&self) -> f64 {
        self.closed_residual
    }

    /// The norm of the codifferential, zero but for rounding.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::{HodgeSpace, MetricComplex};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A circle of two edges from vertex 0 to vertex 1.
    /// let edges = SparseMatrix::from_entries(2, 2, [(0, 0, -1), (1, 0, 1), (0, 1, -1), (1, 1, 1)])?;
    /// let circle = ChainComplex::new(vec![edges])?;
    /// let metric = MetricComplex::new(&circle);
    /// let space = HodgeSpace::new(&metric, 1)?;
    /// let harmonic = &space.harmonic_basis()[0];
    /// assert!(harmonic.coclosed_residual() < 1e-12);
    /// # Ok(()) }
    /// ```
    pub fn coclosed_residual(&self) -> f64 {
        self.coclosed_residual
    }
}

/// A cochain as the sum of three parts that are orthogonal to each other.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct HodgeDecomposition {
    exact: Cochain<f64>,
    coexact: Cochain<f64>,
    harmonic: Cochain<f64>,
    potential: Option<Cochain<f64>>,
    closed_residual: f64,
    coclosed_residual: f64,
}

impl HodgeDecomposition {
    /// The exact part: a coboundary.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, SparseMatrix};
    /// use coface_algebra::chains::{ChainComplex, Cochain};
    /// use coface_topology::{HodgeSpace, MetricComplex};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A circle of two edges from vertex 0 to vertex 1.
    /// let edges = SparseMatrix::from_entries(2, 2, [(0, 0, -1), (1, 0, 1), (0, 1, -1), (1, 1, 1)])?;
    /// let circle = ChainComplex::new(vec![edges])?;
    /// let metric = MetricComplex::new(&circle);
    /// let space = HodgeSpace::new(&metric, 1)?;
    /// let first = Cochain::new(&circle, 1, [(CellId::new(0), 1.0)])?;
    /// let parts = space.decomposition(&first)?;
    /// let value = |cochain: &Cochain<f64>, edge| cochain.coefficient(CellId::new(edge)).copied().unwrap_or(0.0);
    /// assert!([0, 1].iter().all(|&edge| (value(parts.exact(), edge) - 0.5).abs() < 1e-12));
    /// # Ok(()) }
    /// ```
    pub fn exact(&self) -> &Cochain<f64> {
        &self.exact
    }

    /// The coexact part: a codifferential.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, SparseMatrix};
    /// use coface_algebra::chains::{ChainComplex, Cochain};
    /// use coface_topology::{HodgeSpace, MetricComplex};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A circle of two edges from vertex 0 to vertex 1.
    /// let edges = SparseMatrix::from_entries(2, 2, [(0, 0, -1), (1, 0, 1), (0, 1, -1), (1, 1, 1)])?;
    /// let circle = ChainComplex::new(vec![edges])?;
    /// let metric = MetricComplex::new(&circle);
    /// let space = HodgeSpace::new(&metric, 1)?;
    /// let first = Cochain::new(&circle, 1, [(CellId::new(0), 1.0)])?;
    /// let parts = space.decomposition(&first)?;
    /// // There are no faces.
    /// assert!(metric.norm(parts.coexact())? < 1e-12);
    /// # Ok(()) }
    /// ```
    pub fn coexact(&self) -> &Cochain<f64> {
        &self.coexact
    }

    /// The harmonic part: closed and coclosed.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, SparseMatrix};
    /// use coface_algebra::chains::{ChainComplex, Cochain};
    /// use coface_topology::{HodgeSpace, MetricComplex};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A circle of two edges from vertex 0 to vertex 1.
    /// let edges = SparseMatrix::from_entries(2, 2, [(0, 0, -1), (1, 0, 1), (0, 1, -1), (1, 1, 1)])?;
    /// let circle = ChainComplex::new(vec![edges])?;
    /// let metric = MetricComplex::new(&circle);
    /// let space = HodgeSpace::new(&metric, 1)?;
    /// let first = Cochain::new(&circle, 1, [(CellId::new(0), 1.0)])?;
    /// let parts = space.decomposition(&first)?;
    /// let value = |cochain: &Cochain<f64>, edge| cochain.coefficient(CellId::new(edge)).copied().unwrap_or(0.0);
    /// assert!((value(parts.harmonic(), 0) - 0.5).abs() < 1e-12);
    /// assert!((value(parts.harmonic(), 1) + 0.5).abs() < 1e-12);
    /// # Ok(()) }
    /// ```
    pub fn harmonic(&self) -> &Cochain<f64> {
        &self.harmonic
    }

    /// A cochain one degree below whose coboundary is the exact part; `None` in degree 0, where nothing is exact.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, SparseMatrix};
    /// use coface_algebra::chains::{ChainComplex, Cochain};
    /// use coface_topology::{HodgeSpace, MetricComplex};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A circle of two edges from vertex 0 to vertex 1.
    /// let edges = SparseMatrix::from_entries(2, 2, [(0, 0, -1), (1, 0, 1), (0, 1, -1), (1, 1, 1)])?;
    /// let circle = ChainComplex::new(vec![edges])?;
    /// let metric = MetricComplex::new(&circle);
    /// let space = HodgeSpace::new(&metric, 1)?;
    /// let first = Cochain::new(&circle, 1, [(CellId::new(0), 1.0)])?;
    /// let parts = space.decomposition(&first)?;
    /// let value = |cochain: &Cochain<f64>, edge| cochain.coefficient(CellId::new(edge)).copied().unwrap_or(0.0);
    /// let potential = parts.potential().expect("the degree is 1");
    /// assert!((value(potential, 1) - value(potential, 0) - 0.5).abs() < 1e-12);
    /// # Ok(()) }
    /// ```
    pub fn potential(&self) -> Option<&Cochain<f64>> {
        self.potential.as_ref()
    }

    /// The norm of the coboundary of the exact and harmonic parts together, zero but for rounding.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, SparseMatrix};
    /// use coface_algebra::chains::{ChainComplex, Cochain};
    /// use coface_topology::{HodgeSpace, MetricComplex};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A circle of two edges from vertex 0 to vertex 1.
    /// let edges = SparseMatrix::from_entries(2, 2, [(0, 0, -1), (1, 0, 1), (0, 1, -1), (1, 1, 1)])?;
    /// let circle = ChainComplex::new(vec![edges])?;
    /// let metric = MetricComplex::new(&circle);
    /// let space = HodgeSpace::new(&metric, 1)?;
    /// let first = Cochain::new(&circle, 1, [(CellId::new(0), 1.0)])?;
    /// let parts = space.decomposition(&first)?;
    /// assert!(parts.closed_residual() < 1e-12);
    /// # Ok(()) }
    /// ```
    pub fn closed_residual(&self) -> f64 {
        self.closed_residual
    }

    /// The norm of the codifferential of the coexact and harmonic parts together, zero but for rounding.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, SparseMatrix};
    /// use coface_algebra::chains::{ChainComplex, Cochain};
    /// use coface_topology::{HodgeSpace, MetricComplex};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A circle of two edges from vertex 0 to vertex 1.
    /// let edges = SparseMatrix::from_entries(2, 2, [(0, 0, -1), (1, 0, 1), (0, 1, -1), (1, 1, 1)])?;
    /// let circle = ChainComplex::new(vec![edges])?;
    /// let metric = MetricComplex::new(&circle);
    /// let space = HodgeSpace::new(&metric, 1)?;
    /// let first = Cochain::new(&circle, 1, [(CellId::new(0), 1.0)])?;
    /// let parts = space.decomposition(&first)?;
    /// assert!(parts.coclosed_residual() < 1e-12);
    /// # Ok(()) }
    /// ```
    pub fn coclosed_residual(&self) -> f64 {
        self.coclosed_residual
    }
}

/// The cochains of one degree, ready to be decomposed: harmonic cochains are found, and the matrix of the least squares
/// problem is factorized.
///
/// # Examples
/// The rim of a triangle, with edges 01, 12 and 02. A flow of 3 along the first edge alone is one of 1 around, and a
/// coboundary of heights.
/// ```
/// use coface_algebra::CellId;
/// use coface_algebra::SparseMatrix;
/// use coface_algebra::chains::{ChainComplex, Cochain};
/// use coface_topology::{HodgeSpace, MetricComplex};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let rim =
///     SparseMatrix::from_entries(3, 3, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1), (0, 2, -1), (2, 2, 1)])?;
/// let circle = ChainComplex::new(vec![rim])?;
/// let metric = MetricComplex::new(&circle);
/// let space = HodgeSpace::new(&metric, 1)?;
/// let parts = space.decomposition(&Cochain::new(&circle, 1, [(CellId::new(0), 3.0)])?)?;
/// let near = |cochain: &Cochain<f64>, values: [f64; 3]| {
///     (0..3).all(|e| (cochain.coefficient(CellId::new(e)).copied().unwrap_or(0.0) - values[e]).abs() < 1e-12)
/// };
/// assert!(near(parts.harmonic(), [1.0, 1.0, -1.0]));
/// assert!(near(parts.exact(), [2.0, -1.0, 1.0]));
/// assert!(near(parts.coexact(), [0.0, 0.0, 0.0]));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct HodgeSpace<'a> {
    metric: &'a MetricComplex<'a>,
    degree: usize,
    exact: Option<ExactProjection>,
    basis: Vec<HarmonicCochain>,
    /// An orthonormal basis of the harmonic cochains, by their values.
    orthonormal: Vec<Vec<f64>>,
}

impl<'a> HodgeSpace<'a> {
    /// Finds the harmonic cochains of this degree, for the classes of [`HomologyBasis::unshortened`].
    ///
    /// # Errors
    /// Those of [`Self::with_basis`].
    ///
    /// # Complexity
    /// That of the basis and of [`Self::with_basis`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::{HodgeSpace, MetricComplex};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A circle of two edges from vertex 0 to vertex 1.
    /// let edges = SparseMatrix::from_entries(2, 2, [(0, 0, -1), (1, 0, 1), (0, 1, -1), (1, 1, 1)])?;
    /// let circle = ChainComplex::new(vec![edges])?;
    /// let metric = MetricComplex::new(&circle);
    /// let space = HodgeSpace::new(&metric, 1)?;
    /// assert_eq!(space.harmonic_basis().len(), 1);
    /// # Ok(()) }
    /// ```
    pub fn new(metric: &'a MetricComplex<'a>, degree: usize) -> Result<Self, Error> {
        Self::with_basis(metric, degree, &HomologyBasis::unshortened(metric.complex()))
    }

    /// Finds the harmonic cochains of this degree, one for each free cocycle of a basis of the same complex: the
    /// cocycle less its exact part. Harmonic cochain i has the value 1 on the free generator i of the basis and 0 on
    /// all others.
    ///
    /// Which coboundaries are independent and how many classes there are is decided by integers. Floating point solves
    /// one least squares problem for each class, all with one sparse Cholesky factor.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::TooLarge`] if the normal equations cannot be held or factorized;
    /// [`coface_algebra::ErrorKind::NotInComplex`] if the basis is of a larger complex.
    ///
    /// # Complexity
    /// That of the matching and of the factor: on surfaces near-linear in practice, on volumes the fill of a
    /// three-dimensional grid.
    ///
    /// # References
    /// B. Eckmann, *Harmonische Funktionen und Randwertaufgaben in einem Komplex* (1944); L.-H. Lim, *Hodge
    /// Laplacians on graphs* (2020).
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::known_spaces::circle;
    /// use coface_topology::{HodgeSpace, HomologyBasis, MetricComplex};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let circle = circle(5)?.chain_complex()?;
    /// let basis = HomologyBasis::new(&circle);
    /// let metric = MetricComplex::new(&circle);
    /// let space = HodgeSpace::with_basis(&metric, 1, &basis)?;
    /// // Over the five edges of the generator the five fifths of the harmonic cochain add up to 1.
    /// let around = basis.generators(1)[0].chain().terms().iter();
    /// let harmonic = space.harmonic_basis()[0].cochain();
    /// let sum: f64 = around.map(|(edge, x)| x.to_f64() * harmonic.coefficient(*edge).unwrap_or(&0.0)).sum();
    /// assert!((sum - 1.0).abs() < 1e-12);
    /// # Ok(()) }
    /// ```
    pub fn with_basis(
        metric: &'a MetricComplex<'a>,
        degree: usize,
        basis: &HomologyBasis<'_>,
    ) -> Result<Self, Error> {
        let complex = metric.complex();
        let exact = match degree {
            0 => None,
            _ => {
                let morse = MorseComplex::new(complex);
                Some(ExactProjection::new(metric, degree, image_basis(&morse, degree))?)
            }
        };
        let mut space = Self { metric, degree, exact, basis: Vec::new(), orthonormal: Vec::new() };
        let steps = stage("solving for harmonic cochains", basis.cocycles(degree).len());
        for cocycle in basis.cocycles(degree).iter().filter(|cocycle| cocycle.order().is_none()) {
            steps.advance(1);
            space.add_class(cocycle.cochain())?;
        }
        Ok(space)
    }

    fn add_class(&mut self, class: &Cochain<Integer>) -> Result<(), Error> {
        let (metric, degree) = (self.metric, self.degree);
        let real = class.terms().iter().map(|(cell, value)| (*cell, value.to_f64()));
        let mut values = metric.dense(&Cochain::new(metric.complex(), degree, real)?)?;
        let exact = self.exact_part(&values)?.0;
        values.iter_mut().zip(exact).for_each(|(x, y)| *x -= y);
        let (closed_residual, coclosed_residual) = self.residuals(&values, &values);
        self.basis.push(HarmonicCochain {
            cochain: metric.cochain(degree, &values)?,
            class: class.clone(),
            closed_residual,
            coclosed_residual,
        });
        // Gram and Schmidt, twice for accuracy.
        for _ in 0..2 {
            let harmonic = self.harmonic_part(&values);
            values.iter_mut().zip(harmonic).for_each(|(x, y)| *x -= y);
        }
        let length = metric.length(degree, &values);
        values.iter_mut().for_each(|x| *x /= length);
        self.orthonormal.push(values);
        Ok(())
    }

    /// The degree of the cochains.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::{HodgeSpace, MetricComplex};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A circle of two edges from vertex 0 to vertex 1.
    /// let edges = SparseMatrix::from_entries(2, 2, [(0, 0, -1), (1, 0, 1), (0, 1, -1), (1, 1, 1)])?;
    /// let circle = ChainComplex::new(vec![edges])?;
    /// let metric = MetricComplex::new(&circle);
    /// let space = HodgeSpace::new(&metric, 1)?;
    /// assert_eq!(space.degree(), 1);
    /// # Ok(()) }
    /// ```
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// The harmonic cochains of a basis of the integral classes modulo torsion: as many as the Betti number.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::{HodgeSpace, MetricComplex};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A circle of two edges from vertex 0 to vertex 1.
    /// let edges = SparseMatrix::from_entries(2, 2, [(0, 0, -1), (1, 0, 1), (0, 1, -1), (1, 1, 1)])?;
    /// let circle = ChainComplex::new(vec![edges])?;
    /// let metric = MetricComplex::new(&circle);
    /// let space = HodgeSpace::new(&metric, 1)?;
    /// assert_eq!(space.harmonic_basis().len(), 1);
    /// # Ok(()) }
    /// ```
    pub fn harmonic_basis(&self) -> &[HarmonicCochain] {
        &self.basis
    }

    /// The parts of a cochain.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::Shape`] for a cochain of another degree,
    /// [`coface_algebra::ErrorKind::NotInComplex`] for a cell that is not here.
    ///
    /// # Complexity
    /// A few solutions with the factor, and two products for each harmonic cochain.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, SparseMatrix};
    /// use coface_algebra::chains::{ChainComplex, Cochain};
    /// use coface_topology::{HodgeSpace, MetricComplex};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A circle of two edges from vertex 0 to vertex 1.
    /// let edges = SparseMatrix::from_entries(2, 2, [(0, 0, -1), (1, 0, 1), (0, 1, -1), (1, 1, 1)])?;
    /// let circle = ChainComplex::new(vec![edges])?;
    /// let metric = MetricComplex::new(&circle);
    /// let space = HodgeSpace::new(&metric, 1)?;
    /// let first = Cochain::new(&circle, 1, [(CellId::new(0), 1.0)])?;
    /// let parts = space.decomposition(&first)?;
    /// // The harmonic part is half of the flow around.
    /// let size = metric.norm(parts.harmonic())?;
    /// assert!((size * size - 0.5).abs() < 1e-12);
    /// # Ok(()) }
    /// ```
    pub fn decomposition(&self, cochain: &Cochain<f64>) -> Result<HodgeDecomposition, Error> {
        let (metric, degree) = (self.metric, self.degree);
        if cochain.degree() != degree {
            return Err(Error::new(
                coface_algebra::ErrorKind::Shape,
                format!("a cochain of degree {} among those of degree {degree}", cochain.degree()),
            ));
        }
        let values = metric.dense(cochain)?;
        let (exact, potential) = self.exact_part(&values)?;
        let rest: Vec<f64> = values.iter().zip(&exact).map(|(x, y)| x - y).collect();
        let harmonic = self.harmonic_part(&rest);
        let coexact: Vec<f64> = rest.iter().zip(&harmonic).map(|(x, y)| x - y).collect();
        let closed: Vec<f64> = exact.iter().zip(&harmonic).map(|(x, y)| x + y).collect();
        let (closed_residual, coclosed_residual) = self.residuals(&closed, &rest);
        Ok(HodgeDecomposition {
            exact: metric.cochain(degree, &exact)?,
            coexact: metric.cochain(degree, &coexact)?,
            harmonic: metric.cochain(degree, &harmonic)?,
            potential: degree.checked_sub(1).map(|below| metric.cochain(below, &potential)).transpose()?,
            closed_residual,
            coclosed_residual,
        })
    }

    /// The exact part of a cochain and a potential of it.
    fn exact_part(&self, values: &[f64]) -> Result<(Vec<f64>, Vec<f64>), Error> {
        match &self.exact {
            Some(exact) => exact.project(self.metric, values),
            None => Ok((vec![0.0; values.len()], Vec::new())),
        }
    }

    fn harmonic_part(&self, values: &[f64]) -> Vec<f64> {
        let mut sum = vec![0.0; values.len()];
        for harmonic in &self.orthonormal {
            let factor = self.metric.dot(self.degree, harmonic, values);
            sum.iter_mut().zip(harmonic).for_each(|(x, y)| *x += factor * y);
        }
        sum
    }

    /// The norms of the coboundary of one cochain and of the codifferential of another.
    fn residuals(&self, closed: &[f64], coclosed: &[f64]) -> (f64, f64) {
        let above = self.degree + 1;
        let up = self.metric.length(above, &self.metric.up(self.degree, closed));
        let down = match self.degree.checked_sub(1) {
            Some(below) => self.metric.length(below, &self.metric.down(self.degree, coclosed)),
            None => 0.0,
        };
        (up, down)
    }
}

impl MetricComplex<'_> {
    /// The harmonic cochains of one degree, one for each free cocycle of a basis of the same complex; see
    /// [`HodgeSpace::with_basis`]. Where there is none, no least squares problem is set up.
    ///
    /// # Errors
    /// Those of [`HodgeSpace::with_basis`].
    ///
    /// # Examples
    /// A disk has a constant harmonic function and no other harmonic cochain.
    /// ```
    /// use coface_complexes::known_spaces::simplex;
    /// use coface_topology::{HomologyBasis, MetricComplex};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let disk = simplex(2)?.chain_complex()?;
    /// let (basis, metric) = (HomologyBasis::new(&disk), MetricComplex::new(&disk));
    /// let counts = (0..3).map(|degree| Ok(metric.harmonic_cochains(degree, &basis)?.len()));
    /// assert_eq!(counts.collect::<Result<Vec<_>, coface_algebra::Error>>()?, [1, 0, 0]);
    /// # Ok(()) }
    /// ```
    pub fn harmonic_cochains(
        &self,
        degree: usize,
        basis: &HomologyBasis<'_>,
    ) -> Result<Vec<HarmonicCochain>, Error> {
        // Free cocycles are as many as free generators.
        if basis.generators(degree).iter().all(|generator| generator.order().is_some()) {
            return Ok(Vec::new());
        }
        Ok(HodgeSpace::with_basis(self, degree, basis)?.basis)
    }
}

/// The harmonic cochains of a basis of integral cohomology modulo torsion, in this degree and with all weights 1; as
/// many as the Betti number. For weights, for the duals of given generators, and to decompose cochains, see
/// [`HodgeSpace`].
///
/// # Errors
/// Those of [`HodgeSpace::new`].
///
/// # Complexity
/// That of [`HodgeSpace::new`].
///
/// # Examples
/// Around the rim of a triangle the harmonic cochain of a generator is 1/3 or -1/3 on each edge.
/// ```
/// use coface_algebra::SparseMatrix;
/// use coface_algebra::chains::ChainComplex;
/// use coface_topology::harmonic_basis;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let rim =
///     SparseMatrix::from_entries(3, 3, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1), (0, 2, -1), (2, 2, 1)])?;
/// let basis = harmonic_basis(&ChainComplex::new(vec![rim])?, 1)?;
/// assert_eq!(basis.len(), 1);
/// assert!(basis[0].cochain().terms().iter().all(|(_, value)| (value.abs() - 1.0 / 3.0).abs() < 1e-12));
/// # Ok(()) }
/// ```
pub fn harmonic_basis(complex: &ChainComplex, degree: usize) -> Result<Vec<HarmonicCochain>, Error> {
    MetricComplex::new(complex).harmonic_cochains(degree, &HomologyBasis::unshortened(complex))
}
