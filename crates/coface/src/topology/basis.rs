//! Bases of homology and cohomology: generators, dual cocycles, classes of cycles, certificates.

use super::adapted_basis::{AdaptedBasis, adapted_bases};
use super::shortening;
use super::{AbelianGroup, Coefficients, Homology};
use crate::algebra::{Integer, SparseVector, WideMatrix, combination, inner_product, linear_combination};
use crate::chains::{Chain, ChainComplex, Cochain, Reduction};
use crate::{CellId, Error, ErrorKind};
use rayon::prelude::*;

/// A cycle whose class generates a cyclic summand of homology.
///
/// # Examples
/// See [`generators`](super::generators).
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Generator {
    order: Option<Integer>,
    chain: Chain<Integer>,
}

impl Generator {
    /// The order of its class: `None` when no multiple bounds. Over a field or Z/n, `None` when the summand is the whole
    /// ring.
    pub fn order(&self) -> Option<&Integer> {
        self.order.as_ref()
    }

    /// The cycle, on the cells of the complex. Over Z/n its coefficients are read modulo n.
    pub fn chain(&self) -> &Chain<Integer> {
        &self.chain
    }

    /// The sum of the absolute values of the coefficients: the number of cells, counted as often as the cycle runs
    /// through them.
    pub fn length(&self) -> Integer {
        let mut length = Integer::ZERO;
        for (_, coefficient) in self.chain.terms() {
            length += &coefficient.abs();
        }
        length
    }
}

/// A closed cochain whose class generates a cyclic summand of cohomology.
///
/// # Examples
/// See [`HomologyBasis::cocycles`].
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Cocycle {
    order: Option<Integer>,
    cochain: Cochain<Integer>,
}

impl Cocycle {
    /// The order of its class: `None` when no multiple is a coboundary. Over a field or Z/n, `None` when the summand is
    /// the whole ring.
    pub fn order(&self) -> Option<&Integer> {
        self.order.as_ref()
    }

    /// The cochain, on the cells of the complex. Over Z/n its values are read modulo n.
    pub fn cochain(&self) -> &Cochain<Integer> {
        &self.cochain
    }
}

/// The class of a cycle: its coefficients on the generators of its degree.
///
/// # Examples
/// See [`HomologyBasis::class_of`].
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct HomologyClass {
    coefficients: Vec<Integer>,
    orders: Vec<Option<Integer>>,
}

impl HomologyClass {
    /// The coefficient of each generator, in their order: from 0 to m - 1 for a generator of finite order m, any
    /// integer for a free one.
    pub fn coefficients(&self) -> &[Integer] {
        &self.coefficients
    }

    /// Whether the class is zero: whether the cycle bounds.
    pub fn is_zero(&self) -> bool {
        self.coefficients.iter().all(Integer::is_zero)
    }

    /// The least positive number whose product with the class is zero; `None` if there is none.
    pub fn order(&self) -> Option<Integer> {
        let mut multiple = Integer::ONE;
        for (coefficient, order) in self.coefficients.iter().zip(&self.orders) {
            match order {
                _ if coefficient.is_zero() => {}
                None => return None,
                Some(order) => {
                    let own = order.exact_quotient(&order.gcd(coefficient)).expect("a gcd divides");
                    let gcd = multiple.gcd(&own);
                    multiple *= &own.exact_quotient(&gcd).expect("a gcd divides");
                }
            }
        }
        Some(multiple)
    }
}

/// Whether a cycle bounds, with the proof.
///
/// # Examples
/// See [`HomologyBasis::bounding`].
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Bounding {
    /// It does: it is the boundary of this chain.
    Bounds(Chain<Integer>),
    /// It does not, but a multiple does.
    MultipleBounds {
        /// The least positive multiple that bounds, at least 2.
        multiple: Integer,
        /// The chain whose boundary is that multiple.
        chain: Chain<Integer>,
    },
    /// No multiple bounds.
    Never {
        /// A closed cochain, which vanishes on all boundaries.
        cocycle: Cochain<Integer>,
        /// Its value on the cycle, not zero.
        value: Integer,
    },
}

/// A basis of the integral homology of a complex in all degrees, with what it takes to tell the class of any cycle.
///
/// Generators are cycles on the original cells, torsion first (orders dividing along), then free ones; they are
/// [shortened](HomologyBasis::new). The cocycles of [`Self::cocycles`] are the dual basis of cohomology: free cocycle i
/// has the value 1 on free generator i and 0 on all others.
///
/// # Complexity
/// That of [`Reduction`] and of Smith transforms of what it leaves; each generator costs the cells that it reaches.
///
/// # References
/// R. Forman, *Morse theory for cell complexes* (1998), section 8; J. R. Munkres, *Elements of Algebraic Topology*
/// (1984), sections 11 and 53.
///
/// # Examples
/// The projective plane as one vertex, one loop and one disk that runs twice along it: the loop does not bound, but
/// twice the loop does.
/// ```
/// use coface::CellId;
/// use coface::algebra::{Integer, SparseMatrix};
/// use coface::chains::{Chain, ChainComplex};
/// use coface::topology::{Bounding, HomologyBasis};
/// # fn main() -> Result<(), coface::Error> {
/// let plane = ChainComplex::new(vec![
///     SparseMatrix::zero(1, 1)?,
///     SparseMatrix::from_entries(1, 1, [(0, 0, 2)])?,
/// ])?;
/// let basis = HomologyBasis::new(&plane);
/// assert_eq!(basis.generators(1)[0].order(), Some(&2.into()));
/// let three = Chain::new(&plane, 1, [(CellId::new(0), Integer::from(3))])?;
/// assert_eq!(basis.class_of(&three)?.coefficients(), [1.into()]);
/// let Bounding::MultipleBounds { multiple, chain } = basis.bounding(&three)? else { panic!() };
/// assert_eq!((multiple, chain.to_string()), (2.into(), "3 c0".to_owned()));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct HomologyBasis<'a> {
    complex: &'a ChainComplex,
    reduction: Reduction<'a>,
    degrees: Vec<AdaptedBasis>,
    generators: Vec<Vec<Generator>>,
}

impl<'a> HomologyBasis<'a> {
    /// Finds the basis.
    ///
    /// Generators are made short: loops are exchanged against shorter ones of breadth-first trees while they stay a
    /// basis, cycles of any degree lose cells by adding boundaries and each other. They need not be shortest; none can
    /// be made shorter by adding the boundary of one cell or one other generator.
    pub fn new(complex: &'a ChainComplex) -> Self {
        let mut basis = Self::unshortened(complex);
        for degree in 0..complex.degree_count() {
            shortening::shorten(&mut basis, degree);
        }
        basis
    }

    /// The basis as the reduction finds it: quicker, with generators that may be long.
    pub fn unshortened(complex: &'a ChainComplex) -> Self {
        let reduction = Reduction::new(complex);
        let degrees = adapted_bases(&reduction);
        let generators = degrees.par_iter().enumerate().map(|(degree, basis)| {
            let positions = basis.generators();
            let reduced = basis.elements[positions.clone()].to_vec();
            let images = reduction.inclusions(degree, reduced);
            let generator = |(position, image): (usize, SparseVector)| Generator {
                order: basis.order(position).cloned(),
                chain: to_chain(complex, degree, image),
            };
            positions.zip(images).map(generator).collect()
        });
        let generators = generators.collect();
        Self { complex, reduction, degrees, generators }
    }

    /// The complex that this is a basis of.
    pub fn complex(&self) -> &'a ChainComplex {
        self.complex
    }

    /// The reduction that was used.
    pub fn reduction(&self) -> &Reduction<'a> {
        &self.reduction
    }

    /// The integral homology groups.
    pub fn homology(&self) -> Homology {
        let group = |list: &Vec<Generator>| {
            let orders: Vec<Integer> = list.iter().filter_map(|generator| generator.order.clone()).collect();
            AbelianGroup::new(list.len() - orders.len(), orders)
        };
        Homology::from_groups(self.generators.iter().map(group).collect())
    }

    /// The generators of one degree: those of finite order, orders dividing along, then those of infinite order.
    pub fn generators(&self, degree: usize) -> &[Generator] {
        self.generators.get(degree).map_or(&[], Vec::as_slice)
    }

    /// The generators of all degrees, without the rest.
    pub fn into_generators(self) -> Vec<Vec<Generator>> {
        self.generators
    }

    /// The orders of the generators of one degree; `None` is infinite.
    pub fn orders(&self, degree: usize) -> Vec<Option<Integer>> {
        self.generators(degree).iter().map(|generator| generator.order.clone()).collect()
    }

    /// The class of a cycle in the basis of its degree.
    ///
    /// # Errors
    /// [`ErrorKind::NotInComplex`] if the chain has a cell that is not here, [`ErrorKind::NotACycle`] naming a cell in
    /// its boundary.
    ///
    /// # Examples
    /// See [`HomologyBasis`].
    pub fn class_of(&self, cycle: &Chain<Integer>) -> Result<HomologyClass, Error> {
        self.check_cycle(cycle)?;
        let Some(basis) = self.degrees.get(cycle.degree()) else {
            return Ok(HomologyClass { coefficients: Vec::new(), orders: Vec::new() });
        };
        let (projection, _) = self.reduction.projection_and_homotopy(cycle.degree(), &to_vector(cycle));
        Ok(class(basis, &basis.coordinates(&projection)))
    }

    /// Whether a cycle bounds: the chain that it bounds, or the least multiple that bounds and its chain, or a cocycle
    /// that shows that no multiple does.
    ///
    /// # Errors
    /// As [`Self::class_of`].
    ///
    /// # Examples
    /// See [`HomologyBasis`].
    pub fn bounding(&self, cycle: &Chain<Integer>) -> Result<Bounding, Error> {
        self.check_cycle(cycle)?;
        let degree = cycle.degree();
        let Some(basis) = self.degrees.get(degree) else {
            return Ok(Bounding::Bounds(Chain::zero(degree + 1)));
        };
        let (projection, homotopy) = self.reduction.projection_and_homotopy(degree, &to_vector(cycle));
        let coordinates = basis.coordinates(&projection);
        let Some(multiple) = class(basis, &coordinates).order() else {
            let (free, value) = coordinates
                .iter()
                .enumerate()
                .skip(basis.orders.len())
                .find(|(_, x)| !x.is_zero())
                .expect("a class of infinite order has a free coefficient");
            let cocycle = self.pulled_back(degree, &[basis.duals[basis.rank + free].clone()]).remove(0);
            return Ok(Bounding::Never { cocycle, value: value.clone() });
        };
        // The cycle is the boundary of its homotopy plus the inclusion of its projection, and the multiple of the
        // projection is a combination of boundaries of basis elements one degree above.
        let mut chain = vec![(multiple.clone(), homotopy)];
        if let Some(above) = self.degrees.get(degree + 1) {
            let quotients: Vec<Integer> = coordinates
                .iter()
                .zip(&basis.orders)
                .map(|(x, order)| (x * &multiple).exact_quotient(order).expect("the multiple bounds"))
                .collect();
            let reduced = linear_combination(quotients.iter().zip(&above.elements).map(|(x, q)| (x, &q[..])));
            chain.extend(
                self.reduction.inclusions(degree + 1, vec![reduced]).into_iter().map(|x| (Integer::ONE, x)),
            );
        }
        let terms = linear_combination(chain.iter().map(|(x, list)| (x, &list[..])));
        let chain = to_chain(self.complex, degree + 1, terms);
        Ok(match multiple == Integer::ONE {
            true => Bounding::Bounds(chain),
            false => Bounding::MultipleBounds { multiple, chain },
        })
    }

    /// For a generator of finite order m the chain whose boundary is m times the generator; `None` for a free one.
    ///
    /// # Panics
    /// If there is no such generator.
    pub fn certificate(&self, degree: usize, generator: usize) -> Option<Chain<Integer>> {
        let generator = &self.generators[degree][generator];
        generator.order.as_ref()?;
        match self.bounding(&generator.chain).expect("a generator is a cycle of the complex") {
            Bounding::MultipleBounds { chain, .. } => Some(chain),
            _ => None,
        }
    }

    /// Cocycles whose classes are a basis of integral cohomology in one degree: those of finite order first, then free
    /// ones. Free cocycle i has the value 1 on the free generator i of homology and 0 on all other generators; one of
    /// finite order m is, up to coboundaries, 1/m of the coboundary of the dual of a torsion generator one degree below.
    ///
    /// # Complexity
    /// One pass through the pairs of the matching and the values that are not zero.
    ///
    /// # Examples
    /// ```
    /// use coface::simplicial::known_spaces::circle;
    /// use coface::topology::HomologyBasis;
    /// # fn main() -> Result<(), coface::Error> {
    /// let circle = circle(5)?.chain_complex()?;
    /// let basis = HomologyBasis::new(&circle);
    /// let (cocycle, around) = (&basis.cocycles(1)[0], &basis.generators(1)[0]);
    /// assert_eq!(cocycle.cochain().pairing(around.chain())?, Some(1.into()));
    /// # Ok(()) }
    /// ```
    pub fn cocycles(&self, degree: usize) -> Vec<Cocycle> {
        self.cocycles_with(degree, Coefficients::Integers)
    }

    /// The class of a closed cochain in the basis of [`Self::cocycles`]: coefficients from 0 to m - 1 on cocycles of finite
    /// order m, then those on free cocycles.
    ///
    /// # Errors
    /// [`ErrorKind::NotInComplex`] if the cochain has a cell that is not here, [`ErrorKind::NotACycle`] naming a cell in
    /// its coboundary.
    ///
    /// # Complexity
    /// One pass through the pairs of the matching and the values that are not zero.
    ///
    /// # Examples
    /// The coboundary of one end of an edge takes the value 1 on the other, closed, edge of a circle of two edges too:
    /// ```
    /// use coface::CellId;
    /// use coface::algebra::{Integer, SparseMatrix};
    /// use coface::chains::{ChainComplex, Cochain};
    /// use coface::topology::HomologyBasis;
    /// # fn main() -> Result<(), coface::Error> {
    /// let ends = SparseMatrix::from_entries(2, 2, [(0, 0, -1), (1, 0, 1), (0, 1, 1), (1, 1, -1)])?;
    /// let circle = ChainComplex::new(vec![ends])?;
    /// let basis = HomologyBasis::new(&circle);
    /// let both = Cochain::new(&circle, 1, [0, 1].map(|e| (CellId::new(e), Integer::ONE)))?;
    /// assert_eq!(basis.class_of_cocycle(&both)?.coefficients()[0].abs(), 2.into());
    /// # Ok(()) }
    /// ```
    pub fn class_of_cocycle(&self, cocycle: &Cochain<Integer>) -> Result<HomologyClass, Error> {
        let degree = cocycle.degree();
        let coboundary = self.complex.coboundary(cocycle)?;
        if let Some((cell, value)) = coboundary.terms().first() {
            return Err(Error::new(
                ErrorKind::NotACycle,
                format!(
                    "the cochain of degree {degree} is not closed: its coboundary has the value {value} on cell {cell} of degree {}",
                    degree + 1
                ),
            )
            .with_cure("give a cochain whose coboundary is zero"));
        }
        let Some(basis) = self.degrees.get(degree) else {
            return Ok(HomologyClass { coefficients: Vec::new(), orders: Vec::new() });
        };
        let mut columns = vec![SparseVector::new(); self.complex.cell_count(degree)];
        for (cell, value) in cocycle.terms() {
            columns[cell.index()].push((0, value.clone()));
        }
        let values = WideMatrix::from_integer_columns(1, columns).expect("cells have 32-bit numbers");
        let (restricted, _) = self.reduction.restriction_and_cohomotopy(degree, &values);
        let restricted = restricted.transpose();
        let restricted: SparseVector =
            restricted.column(0).terms().map(|(cell, x)| (cell as u32, x.clone())).collect();
        let below = degree.checked_sub(1).map_or(&[][..], |below| &self.degrees[below].orders);
        let torsion = below.iter().enumerate().filter(|(_, order)| !order.is_unit());
        let torsion = torsion.map(|(position, order)| (position, Some(order.clone())));
        let free = (basis.rank + basis.orders.len()..basis.elements.len()).map(|position| (position, None));
        let (positions, orders): (Vec<usize>, Vec<Option<Integer>>) = torsion.chain(free).unzip();
        let value = |(&position, order): (&usize, &Option<Integer>)| {
            let x = inner_product(&restricted, &basis.elements[position]);
            order.as_ref().map_or(x.clone(), |order| x.div_rem_floor(order).1)
        };
        let coefficients = positions.iter().zip(&orders).map(value).collect();
        Ok(HomologyClass { coefficients, orders })
    }

    /// Cycles whose classes are a basis of homology with coefficients in one degree.
    ///
    /// Over Q they are the free generators, over Z the generators. Over Z/n a generator of order m adds a summand of
    /// order gcd(m, n) twice: itself, and n / gcd(m, n) times the chain that m times it bounds, one degree above.
    pub fn generators_with(&self, degree: usize, coefficients: Coefficients) -> Vec<Generator> {
        let own = self.generators(degree).iter();
        let modulus = match coefficients {
            Coefficients::Integers => return own.cloned().collect(),
            Coefficients::Rationals => {
                return own.filter(|generator| generator.order.is_none()).cloned().collect();
            }
            Coefficients::Modulo(n) => modulus(n),
        };
        let reduce = |chain: &Chain<Integer>, factor: &Integer| {
            let terms =
                chain.terms().iter().map(|(cell, x)| (*cell, (x * factor).div_rem_nearest(&modulus).1));
            Chain::new(self.complex, degree, terms).expect("the cells are those of a chain of the complex")
        };
        let below = degree.checked_sub(1).map_or(&[][..], |below| self.generators(below));
        let from_below = below.iter().enumerate().filter_map(|(i, generator)| {
            let common = generator.order.as_ref()?.gcd(&modulus);
            let chain = (!common.is_unit()).then(|| self.certificate(degree - 1, i))??;
            Some((common, chain))
        });
        let summands = own
            .map(|generator| match &generator.order {
                None => (modulus.clone(), generator.chain.clone(), Integer::ONE),
                Some(order) => (order.gcd(&modulus), generator.chain.clone(), Integer::ONE),
            })
            .chain(from_below.map(|(common, chain)| {
                let factor = modulus.exact_quotient(&common).expect("a gcd divides");
                (common, chain, factor)
            }));
        let mut list: Vec<Generator> = summands
            .filter(|(order, ..)| !order.is_unit())
            .map(|(order, chain, factor)| Generator {
                chain: reduce(&chain, &factor),
                order: (order != modulus).then_some(order),
            })
            .collect();
        // Smaller orders first, whole summands last, as over the integers.
        list.sort_by_key(|generator| (generator.order.is_none(), generator.order.clone()));
        list
    }

    /// Cocycles whose classes are a basis of cohomology with coefficients in one degree; over a field they are dual to
    /// [`Self::generators_with`]: the matrix of values is the identity.
    pub fn cocycles_with(&self, degree: usize, coefficients: Coefficients) -> Vec<Cocycle> {
        let Some(basis) = self.degrees.get(degree) else { return Vec::new() };
        let modulus = match coefficients {
            Coefficients::Modulo(n) => Some(modulus(n)),
            _ => None,
        };
        // (dual, factor, order of the summand)
        let mut summands: Vec<(&SparseVector, Integer, Option<Integer>)> = Vec::new();
        let below = degree.checked_sub(1).map_or(&[][..], |below| &self.degrees[below].orders);
        // In the order of generators_with: those of this degree, then those from one below.
        for position in (basis.rank..basis.duals.len()).chain(0..basis.rank) {
            let dual = &basis.duals[position];
            let order = match position.checked_sub(basis.rank) {
                None => &below[position],
                Some(cycle) if cycle < basis.orders.len() => &basis.orders[cycle],
                Some(_) => {
                    summands.push((dual, Integer::ONE, None));
                    continue;
                }
            };
            match &modulus {
                // Over Z the torsion of cohomology comes from one degree below.
                None => {
                    if position < basis.rank && !order.is_unit() && coefficients == Coefficients::Integers {
                        summands.push((dual, Integer::ONE, Some(order.clone())));
                    }
                }
                Some(n) => {
                    let common = order.gcd(n);
                    if !common.is_unit() {
                        let factor = match position < basis.rank {
                            true => Integer::ONE,
                            false => n.exact_quotient(&common).expect("a gcd divides"),
                        };
                        summands.push((dual, factor, (common != *n).then_some(common)));
                    }
                }
            }
        }
        summands.sort_by_key(|(_, _, order)| (order.is_none(), order.clone()));
        let duals: Vec<SparseVector> = summands.iter().map(|(dual, ..)| (*dual).clone()).collect();
        let cochains = self.pulled_back(degree, &duals);
        let cocycle =
            |((_, factor, order), cochain): ((&SparseVector, Integer, Option<Integer>), Cochain<Integer>)| {
                let cochain = match &modulus {
                    None => cochain,
                    Some(n) => {
                        let terms = cochain.terms().iter();
                        let terms = terms.map(|(cell, x)| (*cell, (x * &factor).div_rem_nearest(n).1));
                        Cochain::new(self.complex, degree, terms).expect("the cells are those of a cochain")
                    }
                };
                Cocycle { order, cochain }
            };
        summands.into_iter().zip(cochains).map(cocycle).collect()
    }

    /// Cochains of the reduced complex as cochains of the original one.
    fn pulled_back(&self, degree: usize, duals: &[SparseVector]) -> Vec<Cochain<Integer>> {
        if duals.is_empty() {
            return Vec::new();
        }
        let values = WideMatrix::from_integer_columns(self.reduction.cell_count(degree), duals.to_vec())
            .expect("cells have 32-bit numbers")
            .transpose();
        let pulled = self.reduction.pullback(degree, &values).transpose();
        let cochain = |i: usize| {
            let terms = pulled.column(i).terms().map(|(cell, x)| (CellId::new(cell), x.clone()));
            Cochain::new(self.complex, degree, terms).expect("a pullback has the cells of the complex")
        };
        (0..duals.len()).map(cochain).collect()
    }

    /// The values of the dual basis on all cells of a degree: column c holds (number of the generator, value) of cell c.
    /// For generators of finite order the values are meant modulo that order.
    pub(super) fn annotations(&self, degree: usize) -> WideMatrix {
        let basis = &self.degrees[degree];
        let duals = basis.duals[basis.generators()].to_vec();
        let values = WideMatrix::from_integer_columns(self.reduction.cell_count(degree), duals)
            .expect("cells have 32-bit numbers")
            .transpose();
        self.reduction.pullback(degree, &values)
    }

    /// Replaces a generator by another cycle of the same class.
    pub(super) fn replace_chain(&mut self, degree: usize, generator: usize, chain: SparseVector) {
        self.generators[degree][generator].chain = to_chain(self.complex, degree, chain);
    }

    /// Replaces generator `at` by a cycle with these coefficients in the basis, that of `at` being 1 or -1. A generator
    /// of finite order is replaced within its own cyclic summand only.
    pub(super) fn exchange(
        &mut self,
        degree: usize,
        at: usize,
        coefficients: &[Integer],
        chain: SparseVector,
    ) {
        let basis = &mut self.degrees[degree];
        let first = basis.generators().start;
        let sign = coefficients[at].clone();
        assert!(sign.is_unit(), "an exchange keeps a basis");
        let positions = first..first + coefficients.len();
        let terms = coefficients.iter().zip(&basis.elements[positions]).filter(|(x, _)| !x.is_zero());
        let element = linear_combination(terms.map(|(x, element)| (x, &element[..])));
        basis.elements[first + at] = element;
        let new_dual = linear_combination([(&sign, &basis.duals[first + at][..])]);
        for (i, coefficient) in coefficients.iter().enumerate().filter(|&(i, x)| i != at && !x.is_zero()) {
            let dual = &mut basis.duals[first + i];
            *dual = combination(&Integer::ONE, dual, &-coefficient, &new_dual);
        }
        basis.duals[first + at] = new_dual;
        if basis.order(first + at).is_some() && sign.signum() < 0 {
            // m times the new cycle is the boundary of the opposite chain.
            let cycle = first + at - basis.rank;
            let above = &mut self.degrees[degree + 1];
            for vector in [&mut above.elements[cycle], &mut above.duals[cycle]] {
                vector.iter_mut().for_each(|(_, x)| *x = -&*x);
            }
        }
        self.replace_chain(degree, at, chain);
    }

    fn check_cycle(&self, chain: &Chain<Integer>) -> Result<(), Error> {
        let boundary = self.complex.boundary(chain)?;
        let Some((face, coefficient)) = boundary.terms().first() else { return Ok(()) };
        Err(Error::new(
            ErrorKind::NotACycle,
            format!(
                "the chain of degree {} is no cycle: its boundary has the coefficient {coefficient} on cell {face} of degree {}",
                chain.degree(),
                chain.degree().saturating_sub(1),
            ),
        )
        .with_cure("give a chain whose boundary is zero"))
    }
}

/// The class with these coordinates on all cycles of a basis.
fn class(basis: &AdaptedBasis, coordinates: &[Integer]) -> HomologyClass {
    let positions = basis.generators();
    let orders: Vec<Option<Integer>> =
        positions.clone().map(|position| basis.order(position).cloned()).collect();
    let reduced = positions.zip(&orders).map(|(position, order)| {
        let x = &coordinates[position - basis.rank];
        order.as_ref().map_or_else(|| x.clone(), |order| x.div_rem_floor(order).1)
    });
    HomologyClass { coefficients: reduced.collect(), orders }
}

fn modulus(n: u64) -> Integer {
    n.to_string().parse().expect("digits are an integer")
}

pub(super) fn to_vector(chain: &Chain<Integer>) -> SparseVector {
    chain.terms().iter().map(|(cell, x)| (cell.to_u32(), x.clone())).collect()
}

fn to_chain(complex: &ChainComplex, degree: usize, terms: SparseVector) -> Chain<Integer> {
    let terms = terms.into_iter().map(|(cell, x)| (CellId::new(cell as usize), x));
    Chain::new(complex, degree, terms).expect("the cells are those of the complex")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chains::random_complexes;
    use crate::topology::{cohomology, homology, homology_with};
    use proptest::prelude::*;

    fn value(cochain: &Cochain<Integer>, chain: &Chain<Integer>) -> Integer {
        cochain.pairing(chain).unwrap().unwrap_or(Integer::ZERO)
    }

    fn orders<'g>(list: impl Iterator<Item = Option<&'g Integer>>) -> AbelianGroup {
        AbelianGroup::new(0, list.map(|order| order.cloned().unwrap_or(Integer::ZERO)).collect())
    }

    proptest! {
        /// Invariant 17: the basis has the groups of homology and cohomology, generators are independent classes of
        /// their orders, and m times one of order m bounds its certificate.
        #[test]
        fn generators_have_unit_classes_and_certificates(complex in random_complexes()) {
            let basis = HomologyBasis::new(&complex);
            prop_assert_eq!(&basis.homology(), &homology(&complex));
            for degree in 0..complex.degree_count() {
                let generators = basis.generators(degree);
                for (i, generator) in generators.iter().enumerate() {
                    prop_assert!(complex.is_cycle(generator.chain()).unwrap());
                    let class = basis.class_of(generator.chain()).unwrap();
                    for (j, x) in class.coefficients().iter().enumerate() {
                        prop_assert_eq!(x, &Integer::from(i64::from(i == j)));
                    }
                    prop_assert_eq!(class.order(), generator.order().cloned());
                    if let Some(order) = generator.order() {
                        let chain = basis.certificate(degree, i).unwrap();
                        prop_assert_eq!(complex.boundary(&chain).unwrap(), generator.chain().scaled(order).unwrap());
                    }
                }
            }
        }

        /// Invariant 18: cocycles are closed; their orders are the cohomology group; free ones pair with the free
        /// generators to the identity; m times one of order m is a coboundary (its values are divisible combinations).
        #[test]
        fn cocycles_are_dual(complex in random_complexes()) {
            let basis = HomologyBasis::new(&complex);
            let groups = cohomology(&complex, Coefficients::Integers);
            for degree in 0..complex.degree_count() {
                let cocycles = basis.cocycles(degree);
                prop_assert_eq!(&orders(cocycles.iter().map(Cocycle::order)), &groups.groups()[degree]);
                let free: Vec<&Generator> = basis.generators(degree).iter().filter(|g| g.order().is_none()).collect();
                let free_cocycles: Vec<&Cocycle> = cocycles.iter().filter(|c| c.order().is_none()).collect();
                for cocycle in &cocycles {
                    prop_assert!(complex.is_closed(cocycle.cochain()).unwrap());
                }
                for (i, cocycle) in free_cocycles.iter().enumerate() {
                    for (j, generator) in free.iter().enumerate() {
                        prop_assert_eq!(value(cocycle.cochain(), generator.chain()), Integer::from(i64::from(i == j)));
                    }
                    for torsion in basis.generators(degree).iter().filter(|g| g.order().is_some()) {
                        prop_assert!(value(cocycle.cochain(), torsion.chain()).is_zero());
                    }
                }
            }
        }

        /// Classes of cocycles: the basis has unit classes, and coboundaries add nothing.
        #[test]
        fn classes_of_cocycles_are_their_coefficients(
            complex in random_complexes(),
            numbers in prop::collection::vec(-4i64..5, 40),
        ) {
            let basis = HomologyBasis::new(&complex);
            for degree in 0..complex.degree_count() {
                let mut numbers = numbers.iter().cycle();
                let mut next = || Integer::from(*numbers.next().unwrap());
                let (mut sum, mut expected) = (Cochain::zero(degree), Vec::new());
                for cocycle in basis.cocycles(degree) {
                    let x = next();
                    sum = sum.plus(&cocycle.cochain().scaled(&x).unwrap()).unwrap();
                    expected.push(cocycle.order().map_or(x.clone(), |order| x.div_rem_floor(order).1));
                }
                if degree > 0 {
                    let cells = (0..complex.cell_count(degree - 1)).map(|c| (CellId::new(c), next()));
                    let below = Cochain::new(&complex, degree - 1, cells).unwrap();
                    sum = sum.plus(&complex.coboundary(&below).unwrap()).unwrap();
                }
                let class = basis.class_of_cocycle(&sum).unwrap();
                prop_assert_eq!(class.coefficients(), &expected);
            }
        }

        /// Invariant 18 over fields and Z/n: closed modulo n, cycles modulo n, as many as the group has summands, and over
        /// a prime field the matrix of values is the identity.
        #[test]
        fn bases_with_coefficients_are_dual(complex in random_complexes(), n in 2u64..13) {
            let basis = HomologyBasis::new(&complex);
            let coefficients = Coefficients::Modulo(n);
            let is_zero = |x: &Integer| modulus(n).divides(x);
            let groups = homology_with(&complex, coefficients);
            let is_prime = (2..n).all(|d| n % d != 0);
            for degree in 0..complex.degree_count() {
                let generators = basis.generators_with(degree, coefficients);
                let cocycles = basis.cocycles_with(degree, coefficients);
                let whole = |order: Option<&Integer>| Some(order.cloned().unwrap_or_else(|| modulus(n)));
                let group = &groups.groups()[degree];
                let expected = AbelianGroup::new(
                    0,
                    group.torsion().iter().cloned().chain((0..group.betti()).map(|_| modulus(n))).collect(),
                );
                let list: Vec<_> = generators.iter().map(|g| whole(g.order())).collect();
                prop_assert_eq!(&orders(list.iter().map(Option::as_ref)), &expected);
                let list: Vec<_> = cocycles.iter().map(|c| whole(c.order())).collect();
                prop_assert_eq!(&orders(list.iter().map(Option::as_ref)), &expected);
                for (i, cocycle) in cocycles.iter().enumerate() {
                    let coboundary = complex.coboundary(cocycle.cochain()).unwrap();
                    prop_assert!(coboundary.terms().iter().all(|(_, x)| is_zero(x)));
                    for (j, generator) in generators.iter().enumerate() {
                        let boundary = complex.boundary(generator.chain()).unwrap();
                        prop_assert!(boundary.terms().iter().all(|(_, x)| is_zero(x)));
                        if is_prime {
                            let x = value(cocycle.cochain(), generator.chain());
                            prop_assert!(is_zero(&(&x - &Integer::from(i64::from(i == j)))), "{i} {j} {x}");
                        }
                    }
                }
            }
        }

        /// Invariant 19: a random cycle is a combination of generators plus a boundary, and what `bounding` says of it is
        /// proved by what it gives.
        #[test]
        fn classes_are_additive_and_verdicts_carry_proofs(
            complex in random_complexes(),
            numbers in prop::collection::vec(-4i64..5, 40),
        ) {
            let basis = HomologyBasis::new(&complex);
            for degree in 0..complex.degree_count() {
                let mut numbers = numbers.iter().cycle();
                let mut next = || Integer::from(*numbers.next().unwrap());
                let mut expected = Vec::new();
                let mut cycle = Chain::zero(degree);
                for generator in basis.generators(degree) {
                    let x = next();
                    cycle = cycle.plus(&generator.chain().scaled(&x).unwrap()).unwrap();
                    expected.push(generator.order().map_or(x.clone(), |order| x.div_rem_floor(order).1));
                }
                let cells = (0..complex.cell_count(degree + 1)).map(|c| (CellId::new(c), next()));
                let above = Chain::new(&complex, degree + 1, cells).unwrap();
                if !above.is_zero() {
                    cycle = cycle.plus(&complex.boundary(&above).unwrap()).unwrap();
                }
                let class = basis.class_of(&cycle).unwrap();
                prop_assert_eq!(class.coefficients(), &expected);
                match basis.bounding(&cycle).unwrap() {
                    Bounding::Bounds(chain) => {
                        prop_assert!(class.is_zero());
                        if !chain.is_zero() || !cycle.is_zero() {
                            prop_assert_eq!(complex.boundary(&chain).unwrap(), cycle);
                        }
                    }
                    Bounding::MultipleBounds { multiple, chain } => {
                        prop_assert_eq!(class.order(), Some(multiple.clone()));
                        prop_assert!(multiple > Integer::ONE);
                        prop_assert_eq!(complex.boundary(&chain).unwrap(), cycle.scaled(&multiple).unwrap());
                    }
                    Bounding::Never { cocycle, value: found } => {
                        prop_assert_eq!(class.order(), None);
                        prop_assert!(complex.is_closed(&cocycle).unwrap());
                        prop_assert!(!found.is_zero());
                        prop_assert_eq!(value(&cocycle, &cycle), found);
                    }
                }
            }
        }
    }

    #[test]
    fn what_is_no_cycle_is_refused() {
        let edge = crate::simplicial::known_spaces::simplex(1).unwrap().chain_complex().unwrap();
        let chain = Chain::new(&edge, 1, [(CellId::new(0), Integer::ONE)]).unwrap();
        let basis = HomologyBasis::new(&edge);
        assert_eq!(basis.class_of(&chain).unwrap_err().kind(), ErrorKind::NotACycle);
        assert_eq!(basis.bounding(&chain).unwrap_err().kind(), ErrorKind::NotACycle);
        let beyond = Chain::zero(7);
        assert!(basis.class_of(&beyond).unwrap().is_zero());
        assert_eq!(basis.bounding(&beyond).unwrap(), Bounding::Bounds(Chain::zero(8)));
    }
}
