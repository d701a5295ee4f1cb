//! The table of products of cohomology classes.

use crate::homology::basis::HomologyBasis;
use crate::homology::class::Cocycle;
use crate::homology::coefficients::Coefficients;
use crate::homology::cup::CochainAlgebra;
use coface_algebra::Error;
use coface_algebra::Integer;
use coface_algebra::chains::Cochain;

/// All products of a class of a basis of cohomology in one degree with one in another, in a basis of the degree of the
/// product.
///
/// # Examples
/// See [`cup_product_table`].
#[derive(Clone, Debug, PartialEq)]
pub struct CupProductTable {
    coefficients: Coefficients,
    first: Vec<Cocycle>,
    second: Vec<Cocycle>,
    target: Vec<Cocycle>,
    values: Vec<Vec<Vec<Integer>>>,
}

impl CupProductTable {
    /// The ring.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::known_spaces;
    /// use coface_topology::{CochainAlgebra, Coefficients, cup_product_table};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let plane = CochainAlgebra::new(known_spaces::projective_plane()?.freeze().to_delta()?)?;
    /// let table = cup_product_table(&plane, 1, 1, Coefficients::Modulo(2))?;
    /// assert_eq!(table.coefficients(), Coefficients::Modulo(2));
    /// # Ok(()) }
    /// ```
    pub fn coefficients(&self) -> Coefficients {
        self.coefficients
    }

    /// The first factors: a basis of cohomology in their degree.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::known_spaces;
    /// use coface_topology::{CochainAlgebra, Coefficients, cup_product_table};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let plane = CochainAlgebra::new(known_spaces::projective_plane()?.freeze().to_delta()?)?;
    /// let table = cup_product_table(&plane, 1, 1, Coefficients::Modulo(2))?;
    /// assert_eq!(table.first().len(), 1);
    /// # Ok(()) }
    /// ```
    pub fn first(&self) -> &[Cocycle] {
        &self.first
    }

    /// The second factors.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::known_spaces;
    /// use coface_topology::{CochainAlgebra, Coefficients, cup_product_table};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let plane = CochainAlgebra::new(known_spaces::projective_plane()?.freeze().to_delta()?)?;
    /// let table = cup_product_table(&plane, 1, 1, Coefficients::Modulo(2))?;
    /// assert_eq!(table.second()[0].cochain().degree(), 1);
    /// # Ok(()) }
    /// ```
    pub fn second(&self) -> &[Cocycle] {
        &self.second
    }

    /// The basis that products are expressed in.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::known_spaces;
    /// use coface_topology::{CochainAlgebra, Coefficients, cup_product_table};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let plane = CochainAlgebra::new(known_spaces::projective_plane()?.freeze().to_delta()?)?;
    /// let table = cup_product_table(&plane, 1, 1, Coefficients::Modulo(2))?;
    /// assert_eq!(table.target()[0].cochain().degree(), 2);
    /// # Ok(()) }
    /// ```
    pub fn target(&self) -> &[Cocycle] {
        &self.target
    }

    /// The coefficient of the product of factors i and j on cocycle k of the target is at `[i][j][k]`: from 0 to m -
    /// 1 for one of finite order m, and over Z/n from 0 to n - 1.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::known_spaces;
    /// use coface_topology::{CochainAlgebra, Coefficients, cup_product_table};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let plane = CochainAlgebra::new(known_spaces::projective_plane()?.freeze().to_delta()?)?;
    /// let table = cup_product_table(&plane, 1, 1, Coefficients::Modulo(2))?;
    /// // The square of the class of degree 1 is the class of degree 2.
    /// assert_eq!(table.values()[0][0], [1.into()]);
    /// # Ok(()) }
    /// ```
    pub fn values(&self) -> &[Vec<Vec<Integer>>] {
        &self.values
    }

    /// Whether all products are zero.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::known_spaces;
    /// use coface_topology::{CochainAlgebra, Coefficients, cup_product_table};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let plane = CochainAlgebra::new(known_spaces::projective_plane()?.freeze().to_delta()?)?;
    /// let table = cup_product_table(&plane, 1, 1, Coefficients::Modulo(2))?;
    /// assert!(!table.is_zero());
    /// # Ok(()) }
    /// ```
    pub fn is_zero(&self) -> bool {
        self.values.iter().flatten().flatten().all(Integer::is_zero)
    }
}

/// The products of a basis of cohomology in degree `p` with a basis in degree `q`, in the basis of degree p + q that
/// [`HomologyBasis::cocycles_with`] gives.
///
/// Over Z torsion takes part, as factor and as product. Over Z/n for n that is no prime the bases are those of the
/// summands Z/n.
///
/// # Errors
/// None beyond a broken invariant: the bases belong to the complex.
///
/// # Complexity
/// That of a [`HomologyBasis`], and for each cycle of the degree of the product the simplices on it with the cocycles
/// that do not vanish on their faces; if there is torsion, one pass through the matching for each product.
///
/// # References
/// A. Hatcher, *Algebraic topology* (2002), section 3.2.
///
/// # Examples
/// On the projective plane the class of degree 1 over F_2 has a square that is not zero.
/// ```
/// use coface_complexes::known_spaces::projective_plane;
/// use coface_topology::{CochainAlgebra, Coefficients, cup_product_table};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let plane = CochainAlgebra::new(projective_plane()?.freeze().to_delta()?)?;
/// let table = cup_product_table(&plane, 1, 1, Coefficients::Modulo(2))?;
/// assert_eq!(table.values(), [vec![vec![1.into()]]]);
/// assert!(cup_product_table(&plane, 1, 1, Coefficients::Integers)?.values().is_empty());
/// # Ok(()) }
/// ```
pub fn cup_product_table(
    cochains: &CochainAlgebra,
    p: usize,
    q: usize,
    coefficients: Coefficients,
) -> Result<CupProductTable, Error> {
    let basis = HomologyBasis::unshortened(cochains.chains());
    let cocycles = |degree| -> Vec<Cocycle> {
        let cocycles = basis.cocycles_with(degree, coefficients).into_iter();
        cocycles
            .filter(|cocycle| cocycle.order().is_none() || coefficients == Coefficients::Integers)
            .collect()
    };
    let (first, second, target) = (cocycles(p), cocycles(q), cocycles(p + q));
    let of = |cocycles: &[Cocycle]| -> Vec<Cochain<Integer>> {
        cocycles.iter().map(|cocycle| cocycle.cochain().clone()).collect()
    };
    let (left, right) = (of(&first), of(&second));
    let mut values = vec![vec![Vec::with_capacity(target.len()); second.len()]; first.len()];
    if target.iter().any(|cocycle| cocycle.order().is_some()) {
        for (row, a) in values.iter_mut().zip(&left) {
            for (entry, b) in row.iter_mut().zip(&right) {
                *entry = basis.class_of_cocycle(&cochains.cup(a, b)?)?.coefficients().to_vec();
            }
        }
        return Ok(CupProductTable { coefficients, first, second, target, values });
    }
    // Without torsion the cocycles are dual to cycles, and the values on these are the coefficients.
    let modulus = match coefficients {
        Coefficients::Modulo(n) => Some(Integer::from(n)),
        Coefficients::Integers | Coefficients::Rationals => None,
    };
    let generators = basis.generators_with(p + q, coefficients);
    for cycle in generators.iter().filter(|generator| generator.order().is_none()) {
        let on_cycle = cochains.products_on(&left, &right, cycle.chain())?;
        for (list, value) in values.iter_mut().flatten().zip(on_cycle.into_iter().flatten()) {
            let value = value.unwrap_or_default();
            list.push(modulus.as_ref().map_or(value.clone(), |n| value.div_rem_floor(n).1));
        }
    }
    Ok(CupProductTable { coefficients, first, second, target, values })
}
