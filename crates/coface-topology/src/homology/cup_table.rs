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
/// Over Z torsion takes part, as factor and as product, and over Z/n the summands of smaller order do.
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
/// // Over Z/6 both have order 2.
/// let table = cup_product_table(&plane, 1, 1, Coefficients::Modulo(6))?;
/// assert_eq!((table.first()[0].order(), table.target()[0].order()), (Some(&2.into()), Some(&2.into())));
/// assert_eq!(table.values(), [vec![vec![1.into()]]]);
/// # Ok(()) }
/// ```
pub fn cup_product_table(
    cochains: &CochainAlgebra,
    p: usize,
    q: usize,
    coefficients: Coefficients,
) -> Result<CupProductTable, Error> {
    let basis = HomologyBasis::unshortened(cochains.chains());
    let cocycles = |degree| basis.cocycles_with(degree, coefficients);
    let (first, second, target) = (cocycles(p), cocycles(q), cocycles(p + q));
    let of = |cocycles: &[Cocycle]| -> Vec<Cochain<Integer>> {
        cocycles.iter().map(|cocycle| cocycle.cochain().clone()).collect()
    };
    let (left, right) = (of(&first), of(&second));
    let mut values = vec![vec![Vec::with_capacity(target.len()); second.len()]; first.len()];
    if target.iter().any(|cocycle| cocycle.order().is_some()) {
        for (row, a) in values.iter_mut().zip(&left) {
            for (entry, b) in row.iter_mut().zip(&right) {
                let product = cochains.cup(a, b)?;
                let class = match coefficients {
                    Coefficients::Modulo(n) => basis.class_of_cocycle_modulo(&product, n)?,
                    _ => basis.class_of_cocycle(&product)?,
                };
                *entry = class.coefficients().to_vec();
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

#[cfg(test)]
mod tests {
    use super::*;
    use coface_complexes::known_spaces::{
        klein_grid, lens_space, moore_space, projective_plane, real_projective_space, small_klein_bottle,
    };
    use coface_complexes::simplicial::SimplicialComplex;

    fn algebra(complex: Result<SimplicialComplex, Error>) -> CochainAlgebra {
        CochainAlgebra::new(complex.unwrap().freeze().to_delta().unwrap()).unwrap()
    }

    fn orders(cocycles: &[Cocycle]) -> Vec<i64> {
        cocycles.iter().map(|one| one.order().map_or(0, |order| order.to_i64().unwrap())).collect()
    }

    #[test]
    fn classes_of_smaller_order_take_part() {
        let plane = algebra(projective_plane());
        // The class is 3x with x of order 2 over Z, and its square 9 x^2.
        let table = cup_product_table(&plane, 1, 1, Coefficients::Modulo(6)).unwrap();
        assert_eq!((orders(&table.first), orders(&table.target)), (vec![2], vec![2]));
        assert_eq!(table.values(), [vec![vec![1.into()]]]);
        // 2x, and 4 x^2 is zero.
        let table = cup_product_table(&plane, 1, 1, Coefficients::Modulo(4)).unwrap();
        assert_eq!((orders(&table.first), table.is_zero()), (vec![2], true));
        assert!(cup_product_table(&plane, 1, 1, Coefficients::Modulo(9)).unwrap().first().is_empty());
        let bottle =
            cup_product_table(&algebra(small_klein_bottle()), 1, 1, Coefficients::Modulo(4)).unwrap();
        assert_eq!((orders(&bottle.first), orders(&bottle.target)), (vec![2, 0], vec![2]));
        // Z/2 + Z/3 of two degrees is one summand.
        let lens = cup_product_table(&algebra(lens_space(6, 1)), 1, 1, Coefficients::Modulo(12)).unwrap();
        assert_eq!((orders(&lens.first), orders(&lens.target)), (vec![6], vec![6]));
    }

    /// Modulo each prime p of n, the sum that the table gives has the values of the product on all cycles modulo p.
    #[test]
    fn products_are_the_sums_of_the_table() {
        let spaces = [
            projective_plane(),
            small_klein_bottle(),
            klein_grid(4, 3),
            lens_space(4, 1),
            lens_space(6, 1),
            moore_space(12),
            real_projective_space(3),
        ];
        for (place, space) in spaces.into_iter().enumerate() {
            let algebra = algebra(space);
            let basis = HomologyBasis::new(algebra.chains());
            for n in [4u64, 6, 8, 9, 12, 30] {
                for (p, q) in [(0, 1), (0, 2), (1, 1), (1, 2)] {
                    let table = cup_product_table(&algebra, p, q, Coefficients::Modulo(n)).unwrap();
                    for (a, row) in table.first.iter().zip(&table.values) {
                        for (b, sum) in table.second.iter().zip(row) {
                            assert_eq!(sum.len(), table.target.len());
                            let mut rest = algebra.cup(a.cochain(), b.cochain()).unwrap();
                            for (x, class) in sum.iter().zip(&table.target) {
                                rest = rest.plus(&class.cochain().scaled(&-x).unwrap()).unwrap();
                            }
                            for prime in [2u64, 3, 5].into_iter().filter(|prime| n % prime == 0) {
                                for cycle in basis.generators_with(p + q, Coefficients::Modulo(prime)) {
                                    let value = rest.pairing(cycle.chain()).unwrap().unwrap_or_default();
                                    assert!(Integer::from(prime).divides(&value), "{place} {n} {p} {q}");
                                }
                            }
                        }
                    }
                }
            }
        }
    }
}
