//! The table of products of cohomology classes.

use super::{CochainAlgebra, Cocycle, Coefficients, Generator, HomologyBasis};
use crate::Error;
use crate::algebra::Integer;
use crate::chains::Cochain;

/// All products of a class of a basis of cohomology in one degree with one in another, by their values on cycles of the
/// degree of the product.
///
/// # Examples
/// See [`cup_product_table`].
#[derive(Clone, Debug, PartialEq)]
pub struct CupProductTable {
    coefficients: Coefficients,
    first: Vec<Cocycle>,
    second: Vec<Cocycle>,
    cycles: Vec<Generator>,
    values: Vec<Vec<Vec<Integer>>>,
}

impl CupProductTable {
    /// The ring.
    pub fn coefficients(&self) -> Coefficients {
        self.coefficients
    }

    /// The first factors: a basis of cohomology in their degree, modulo torsion over the integers.
    pub fn first(&self) -> &[Cocycle] {
        &self.first
    }

    /// The second factors.
    pub fn second(&self) -> &[Cocycle] {
        &self.second
    }

    /// The cycles that the products are evaluated on: a basis of homology in the degree of the products, modulo torsion over
    /// the integers.
    pub fn cycles(&self) -> &[Generator] {
        &self.cycles
    }

    /// The value of the product of factors i and j on cycle k is at `[i][j][k]`; over Z/n from 0 to n - 1.
    pub fn values(&self) -> &[Vec<Vec<Integer>>] {
        &self.values
    }

    /// Whether all products are zero on all cycles.
    pub fn is_zero(&self) -> bool {
        self.values.iter().flatten().flatten().all(Integer::is_zero)
    }
}

/// The products of a basis of cohomology in degree `p` with a basis in degree `q`, as values on a basis of homology in degree
/// p + q.
///
/// Over a field the values determine the products. Over Z and Z/n the bases are those of the free summands, whose values on
/// each other do not depend on the choice of cocycles; a product of finite order has the value zero on all of them and is
/// seen over a prime field that divides its order.
///
/// # Errors
/// None beyond a broken invariant: the bases belong to the complex.
///
/// # Complexity
/// That of a [`HomologyBasis`], and for each cycle the simplices on it with the cocycles that do not vanish on their faces.
///
/// # References
/// A. Hatcher, *Algebraic topology* (2002), section 3.2.
///
/// # Examples
/// On the projective plane the class of degree 1 over F_2 has a square that is not zero.
/// ```
/// use coface::simplicial::known_spaces::projective_plane;
/// use coface::topology::{CochainAlgebra, Coefficients, cup_product_table};
/// # fn main() -> Result<(), coface::Error> {
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
    let free = |degree| -> Vec<Cocycle> {
        let cocycles = basis.cocycles_with(degree, coefficients).into_iter();
        cocycles.filter(|cocycle| cocycle.order().is_none()).collect()
    };
    let (first, second) = (free(p), free(q));
    let cycles: Vec<Generator> = basis
        .generators_with(p + q, coefficients)
        .into_iter()
        .filter(|generator| generator.order().is_none())
        .collect();
    let of = |cocycles: &[Cocycle]| -> Vec<Cochain<Integer>> {
        cocycles.iter().map(|cocycle| cocycle.cochain().clone()).collect()
    };
    let (left, right) = (of(&first), of(&second));
    let modulus = match coefficients {
        Coefficients::Modulo(n) => Some(n.to_string().parse::<Integer>()?),
        Coefficients::Integers | Coefficients::Rationals => None,
    };
    let mut values = vec![vec![Vec::with_capacity(cycles.len()); second.len()]; first.len()];
    for cycle in &cycles {
        let on_cycle = cochains.products_on(&left, &right, cycle.chain())?;
        for (list, value) in values.iter_mut().flatten().zip(on_cycle.into_iter().flatten()) {
            let value = value.unwrap_or_default();
            list.push(modulus.as_ref().map_or(value.clone(), |n| value.div_rem_floor(n).1));
        }
    }
    Ok(CupProductTable { coefficients, first, second, cycles, values })
}
