//! The intersection form of a closed oriented manifold of even dimension.

use crate::homology::basis::HomologyBasis;
use crate::homology::cup::CochainAlgebra;
use coface_algebra::Error;
use coface_algebra::chains::{Chain, ChainComplex, Cochain};
use coface_algebra::{Integer, SkewForm, SymmetricForm};

/// The intersection form of a closed oriented manifold of dimension 2k: what products of classes of degree k, modulo
/// torsion, are on the fundamental cycle.
///
/// Entry (i, j) is $(a_i \smile a_j)(\[M\])$ for the cocycles $a_i$ of [`Self::basis`] and the cycle of
/// [`Self::fundamental_cycle`], with the product of [`CochainAlgebra`]. The opposite orientation changes all signs.
/// Of a manifold the form is unimodular, by Poincare duality; of other pseudomanifolds it need not be.
#[derive(Clone, Debug)]
pub struct IntersectionForm {
    pairing: MiddlePairing,
    basis: Vec<Cochain<Integer>>,
    fundamental_cycle: Chain<Integer>,
}

/// The form itself: symmetric in dimensions 0, 4, 8, ..., skew in dimensions 2, 6, 10, ...
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum MiddlePairing {
    /// Products commute: the middle degree is even.
    Symmetric(SymmetricForm),
    /// Products change their sign when exchanged: the middle degree is odd.
    Skew(SkewForm),
}

impl IntersectionForm {
    /// The form.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::DeltaComplex;
    /// use coface_topology::{CochainAlgebra, intersection_form};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus of two triangles: the product of its two loops counts their one crossing.
    /// let torus = CochainAlgebra::new(DeltaComplex::new(1, vec![vec![0; 6], vec![1, 2, 0, 0, 2, 1]])?)?;
    /// let form = intersection_form(&torus)?;
    /// assert!(matches!(form.pairing(), coface_topology::MiddlePairing::Skew(_)));
    /// # Ok(()) }
    /// ```
    pub fn pairing(&self) -> &MiddlePairing {
        &self.pairing
    }

    /// The form if it is symmetric.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::DeltaComplex;
    /// use coface_topology::{CochainAlgebra, intersection_form};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus of two triangles: the product of its two loops counts their one crossing.
    /// let torus = CochainAlgebra::new(DeltaComplex::new(1, vec![vec![0; 6], vec![1, 2, 0, 0, 2, 1]])?)?;
    /// let form = intersection_form(&torus)?;
    /// assert!(form.as_symmetric().is_none());
    /// # Ok(()) }
    /// ```
    pub fn as_symmetric(&self) -> Option<&SymmetricForm> {
        match &self.pairing {
            MiddlePairing::Symmetric(form) => Some(form),
            MiddlePairing::Skew(_) => None,
        }
    }

    /// The form if it is skew.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::DeltaComplex;
    /// use coface_topology::{CochainAlgebra, intersection_form};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus of two triangles: the product of its two loops counts their one crossing.
    /// let torus = CochainAlgebra::new(DeltaComplex::new(1, vec![vec![0; 6], vec![1, 2, 0, 0, 2, 1]])?)?;
    /// let form = intersection_form(&torus)?;
    /// assert_eq!(form.as_skew().expect("the middle degree is 1").rank(), 2);
    /// # Ok(()) }
    /// ```
    pub fn as_skew(&self) -> Option<&SkewForm> {
        match &self.pairing {
            MiddlePairing::Symmetric(_) => None,
            MiddlePairing::Skew(form) => Some(form),
        }
    }

    /// The rows of its matrix.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::DeltaComplex;
    /// use coface_topology::{CochainAlgebra, intersection_form};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus of two triangles: the product of its two loops counts their one crossing.
    /// let torus = CochainAlgebra::new(DeltaComplex::new(1, vec![vec![0; 6], vec![1, 2, 0, 0, 2, 1]])?)?;
    /// let form = intersection_form(&torus)?;
    /// let rows = form.rows();
    /// assert_eq!((rows[0][0].clone(), rows[0][1].abs()), (0.into(), 1.into()));
    /// # Ok(()) }
    /// ```
    pub fn rows(&self) -> &[Vec<Integer>] {
        match &self.pairing {
            MiddlePairing::Symmetric(form) => form.rows(),
            MiddlePairing::Skew(form) => form.rows(),
        }
    }

    /// The rank.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::DeltaComplex;
    /// use coface_topology::{CochainAlgebra, intersection_form};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus of two triangles: the product of its two loops counts their one crossing.
    /// let torus = CochainAlgebra::new(DeltaComplex::new(1, vec![vec![0; 6], vec![1, 2, 0, 0, 2, 1]])?)?;
    /// let form = intersection_form(&torus)?;
    /// assert_eq!(form.rank(), 2);
    /// # Ok(()) }
    /// ```
    pub fn rank(&self) -> usize {
        match &self.pairing {
            MiddlePairing::Symmetric(form) => form.rank(),
            MiddlePairing::Skew(form) => form.rank(),
        }
    }

    /// The determinant: 1 or -1 for manifolds.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::DeltaComplex;
    /// use coface_topology::{CochainAlgebra, intersection_form};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus of two triangles: the product of its two loops counts their one crossing.
    /// let torus = CochainAlgebra::new(DeltaComplex::new(1, vec![vec![0; 6], vec![1, 2, 0, 0, 2, 1]])?)?;
    /// let form = intersection_form(&torus)?;
    /// assert_eq!(form.determinant(), 1.into());
    /// # Ok(()) }
    /// ```
    pub fn determinant(&self) -> Integer {
        match &self.pairing {
            MiddlePairing::Symmetric(form) => form.determinant(),
            MiddlePairing::Skew(form) => form.determinant(),
        }
    }

    /// Cocycles whose classes are a basis of cohomology in the middle degree modulo torsion.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::DeltaComplex;
    /// use coface_topology::{CochainAlgebra, intersection_form};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus of two triangles: the product of its two loops counts their one crossing.
    /// let torus = CochainAlgebra::new(DeltaComplex::new(1, vec![vec![0; 6], vec![1, 2, 0, 0, 2, 1]])?)?;
    /// let form = intersection_form(&torus)?;
    /// assert_eq!(form.basis().len(), 2);
    /// # Ok(()) }
    /// ```
    pub fn basis(&self) -> &[Cochain<Integer>] {
        &self.basis
    }

    /// The cycle that all products are evaluated on.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::DeltaComplex;
    /// use coface_topology::{CochainAlgebra, intersection_form};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The torus of two triangles: the product of its two loops counts their one crossing.
    /// let torus = CochainAlgebra::new(DeltaComplex::new(1, vec![vec![0; 6], vec![1, 2, 0, 0, 2, 1]])?)?;
    /// let form = intersection_form(&torus)?;
    /// assert_eq!(form.fundamental_cycle().support().count(), 2);
    /// # Ok(()) }
    /// ```
    pub fn fundamental_cycle(&self) -> &Chain<Integer> {
        &self.fundamental_cycle
    }
}

/// The intersection form of a closed oriented manifold of even dimension, triangulated as a delta complex or a
/// simplicial complex ([`to_delta`](coface_complexes::simplicial::FrozenComplex::to_delta)). It is oriented by
/// [`CochainAlgebra::fundamental_cycle`]: the lowest facet of each component is positive.
///
/// # Errors
/// [`InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for odd dimensions; those of
/// [`CochainAlgebra::fundamental_cycle`], which name what is wrong with complexes that are no closed orientable
/// pseudomanifold.
///
/// # Complexity
/// That of cohomology, and for each facet the products of cocycles that do not vanish on its middle faces.
///
/// # References
/// J. Milnor, D. Husemoller, *Symmetric bilinear forms* (1973), chapter V; A. Hatcher, *Algebraic topology* (2002),
/// section 3.3.
///
/// # Examples
/// The complex projective plane: a generator of $H^2$ has a square that generates $H^4$.
/// ```
/// use coface_complexes::known_spaces;
/// use coface_topology::{CochainAlgebra, intersection_form};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let plane = known_spaces::complex_projective_plane()?.freeze().to_delta()?;
/// let form = intersection_form(&CochainAlgebra::new(plane)?)?;
/// let form = form.as_symmetric().expect("the dimension is 4");
/// assert_eq!((form.rank(), form.signature().abs()), (1, 1));
/// # Ok(()) }
/// ```
pub fn intersection_form(cochains: &CochainAlgebra) -> Result<IntersectionForm, Error> {
    let dimension = cochains.complex().dimension().unwrap_or(0);
    if dimension % 2 == 1 {
        return Err(Error::invalid(format!("a complex of dimension {dimension} has no middle degree"))
            .with_cure("take a closed manifold of even dimension"));
    }
    let fundamental_cycle = cochains.fundamental_cycle()?;
    let basis = free_cocycles(cochains.chains(), dimension / 2);
    let values = cochains.products_on(&basis, &basis, &fundamental_cycle)?;
    let rows =
        values.into_iter().map(|row| row.into_iter().map(Option::unwrap_or_default).collect()).collect();
    let pairing = if (dimension / 2).is_multiple_of(2) {
        MiddlePairing::Symmetric(SymmetricForm::new(rows)?)
    } else {
        MiddlePairing::Skew(SkewForm::new(rows)?)
    };
    Ok(IntersectionForm { pairing, basis, fundamental_cycle })
}

/// Cocycles whose classes are a basis of cohomology modulo torsion.
fn free_cocycles(chains: &ChainComplex, degree: usize) -> Vec<Cochain<Integer>> {
    let cocycles = HomologyBasis::unshortened(chains).cocycles(degree);
    let free = cocycles.iter().filter(|cocycle| cocycle.order().is_none());
    free.map(|cocycle| cocycle.cochain().clone()).collect()
}
