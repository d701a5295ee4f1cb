//! Bases of homology and cohomology: generators, dual cocycles, classes of cycles, certificates.

use crate::homology::abelian_group::AbelianGroup;
use crate::homology::adapted_basis::{AdaptedBasis, adapted_bases};
use crate::homology::class::{Bounding, Generator, HomologyClass};
use crate::homology::coefficients::Coefficients;
use crate::homology::computation::Homology;
use crate::homology::summands::Summands;
use coface_algebra::chains::{Chain, ChainComplex, Reduction};
use coface_algebra::progress::stage;
use coface_algebra::{CellId, Error, ErrorKind};
use coface_algebra::{Integer, SparseVector, combination, linear_combination};
use rayon::prelude::*;

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
/// use coface_algebra::CellId;
/// use coface_algebra::{Integer, SparseMatrix};
/// use coface_algebra::chains::{Chain, ChainComplex};
/// use coface_topology::{Bounding, HomologyBasis};
/// # fn main() -> Result<(), coface_algebra::Error> {
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
    pub(super) complex: &'a ChainComplex,
    pub(super) reduction: Reduction<'a>,
    pub(super) degrees: Vec<AdaptedBasis>,
    generators: Vec<Vec<Generator>>,
}

impl<'a> HomologyBasis<'a> {
    /// The basis as the reduction finds it: quicker, with generators that may be long.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::{HomologyBasis, homology};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The projective plane: one vertex, one loop, and a disk that runs twice along it.
    /// let plane = ChainComplex::new(vec![
    ///     SparseMatrix::zero(1, 1)?,
    ///     SparseMatrix::from_entries(1, 1, [(0, 0, 2)])?,
    /// ])?;
    /// assert_eq!(HomologyBasis::unshortened(&plane).homology(), homology(&plane));
    /// # Ok(()) }
    /// ```
    pub fn unshortened(complex: &'a ChainComplex) -> Self {
        let reduction = Reduction::new(complex);
        let matrix = |degree| reduction.boundary_matrix(degree);
        let degrees = adapted_bases(reduction.cell_count(0), complex.degree_count(), matrix);
        let total: usize = degrees.iter().map(|basis| basis.generators().len()).sum();
        let steps = stage("growing generators", total * reduction.level_count());
        let generators = degrees.par_iter().enumerate().map(|(degree, basis)| {
            let positions = basis.generators();
            let reduced = basis.elements[positions.clone()].to_vec();
            let images = reduction.inclusions_with_steps(degree, reduced, &steps);
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
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::HomologyBasis;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The projective plane: one vertex, one loop, and a disk that runs twice along it.
    /// let plane = ChainComplex::new(vec![
    ///     SparseMatrix::zero(1, 1)?,
    ///     SparseMatrix::from_entries(1, 1, [(0, 0, 2)])?,
    /// ])?;
    /// let basis = HomologyBasis::new(&plane);
    /// assert_eq!(basis.complex().f_vector(), [1, 1, 1]);
    /// # Ok(()) }
    /// ```
    pub fn complex(&self) -> &'a ChainComplex {
        self.complex
    }

    /// The reduction that was used.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::HomologyBasis;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The projective plane: one vertex, one loop, and a disk that runs twice along it.
    /// let plane = ChainComplex::new(vec![
    ///     SparseMatrix::zero(1, 1)?,
    ///     SparseMatrix::from_entries(1, 1, [(0, 0, 2)])?,
    /// ])?;
    /// let basis = HomologyBasis::new(&plane);
    /// // Nothing can be reduced: the entry 2 is no unit.
    /// assert_eq!(basis.reduction().cell_count(1), 1);
    /// # Ok(()) }
    /// ```
    pub fn reduction(&self) -> &Reduction<'a> {
        &self.reduction
    }

    /// The integral homology groups.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::HomologyBasis;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The projective plane: one vertex, one loop, and a disk that runs twice along it.
    /// let plane = ChainComplex::new(vec![
    ///     SparseMatrix::zero(1, 1)?,
    ///     SparseMatrix::from_entries(1, 1, [(0, 0, 2)])?,
    /// ])?;
    /// let basis = HomologyBasis::new(&plane);
    /// let groups: Vec<String> = basis.homology().groups().iter().map(ToString::to_string).collect();
    /// assert_eq!(groups, ["Z", "Z/2", "0"]);
    /// # Ok(()) }
    /// ```
    pub fn homology(&self) -> Homology {
        let group = |list: &Vec<Generator>| {
            let orders: Vec<Integer> = list.iter().filter_map(|generator| generator.order.clone()).collect();
            AbelianGroup::new(list.len() - orders.len(), orders)
        };
        Homology::from_groups(self.generators.iter().map(group).collect())
    }

    /// The generators of one degree: those of finite order, orders dividing along, then those of infinite order.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::HomologyBasis;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The projective plane: one vertex, one loop, and a disk that runs twice along it.
    /// let plane = ChainComplex::new(vec![
    ///     SparseMatrix::zero(1, 1)?,
    ///     SparseMatrix::from_entries(1, 1, [(0, 0, 2)])?,
    /// ])?;
    /// let basis = HomologyBasis::new(&plane);
    /// assert_eq!(basis.generators(1).len(), 1);
    /// assert!(basis.generators(2).is_empty());
    /// # Ok(()) }
    /// ```
    pub fn generators(&self, degree: usize) -> &[Generator] {
        self.generators.get(degree).map_or(&[], Vec::as_slice)
    }

    /// The generators of all degrees, without the rest.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::HomologyBasis;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The projective plane: one vertex, one loop, and a disk that runs twice along it.
    /// let plane = ChainComplex::new(vec![
    ///     SparseMatrix::zero(1, 1)?,
    ///     SparseMatrix::from_entries(1, 1, [(0, 0, 2)])?,
    /// ])?;
    /// let basis = HomologyBasis::new(&plane);
    /// let counts: Vec<usize> = basis.into_generators().iter().map(Vec::len).collect();
    /// assert_eq!(counts, [1, 1, 0]);
    /// # Ok(()) }
    /// ```
    pub fn into_generators(self) -> Vec<Vec<Generator>> {
        self.generators
    }

    /// The orders of the generators of one degree; `None` is infinite.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::HomologyBasis;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The projective plane: one vertex, one loop, and a disk that runs twice along it.
    /// let plane = ChainComplex::new(vec![
    ///     SparseMatrix::zero(1, 1)?,
    ///     SparseMatrix::from_entries(1, 1, [(0, 0, 2)])?,
    /// ])?;
    /// let basis = HomologyBasis::new(&plane);
    /// assert_eq!(basis.orders(0), [None]);
    /// assert_eq!(basis.orders(1), [Some(2.into())]);
    /// # Ok(()) }
    /// ```
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
    /// ```
    /// use coface_algebra::{CellId, Integer, SparseMatrix};
    /// use coface_algebra::chains::{Chain, ChainComplex};
    /// use coface_topology::HomologyBasis;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The projective plane: one vertex, one loop, and a disk that runs twice along it.
    /// let plane = ChainComplex::new(vec![
    ///     SparseMatrix::zero(1, 1)?,
    ///     SparseMatrix::from_entries(1, 1, [(0, 0, 2)])?,
    /// ])?;
    /// let basis = HomologyBasis::new(&plane);
    /// let five = Chain::new(&plane, 1, [(CellId::new(0), Integer::from(5))])?;
    /// assert_eq!(basis.class_of(&five)?.coefficients(), [1.into()]);
    /// # Ok(()) }
    /// ```
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
    /// ```
    /// use coface_algebra::{CellId, Integer, SparseMatrix};
    /// use coface_algebra::chains::{Chain, ChainComplex};
    /// use coface_topology::{Bounding, HomologyBasis};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The projective plane: one vertex, one loop, and a disk that runs twice along it.
    /// let plane = ChainComplex::new(vec![
    ///     SparseMatrix::zero(1, 1)?,
    ///     SparseMatrix::from_entries(1, 1, [(0, 0, 2)])?,
    /// ])?;
    /// let basis = HomologyBasis::new(&plane);
    /// let twice = Chain::new(&plane, 1, [(CellId::new(0), Integer::from(2))])?;
    /// let Bounding::Bounds(disk) = basis.bounding(&twice)? else { panic!("twice the loop bounds the disk") };
    /// assert_eq!(disk.to_string(), "c0");
    /// # Ok(()) }
    /// ```
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
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::HomologyBasis;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The projective plane: one vertex, one loop, and a disk that runs twice along it.
    /// let plane = ChainComplex::new(vec![
    ///     SparseMatrix::zero(1, 1)?,
    ///     SparseMatrix::from_entries(1, 1, [(0, 0, 2)])?,
    /// ])?;
    /// let basis = HomologyBasis::new(&plane);
    /// // The disk bounds twice the loop.
    /// assert_eq!(basis.certificate(1, 0).expect("torsion").to_string(), "c0");
    /// assert_eq!(basis.certificate(0, 0), None);
    /// # Ok(()) }
    /// ```
    pub fn certificate(&self, degree: usize, generator: usize) -> Option<Chain<Integer>> {
        let generator = &self.generators[degree][generator];
        generator.order.as_ref()?;
        match self.bounding(&generator.chain).expect("a generator is a cycle of the complex") {
            Bounding::MultipleBounds { chain, .. } => Some(chain),
            _ => None,
        }
    }

    /// Cycles whose classes are a basis of homology with coefficients in one degree.
    ///
    /// Over Q they are the free generators, over Z the generators. Over Z/n a generator of order m adds a summand of
    /// order gcd(m, n) twice: itself, and n / gcd(m, n) times the chain that m times it bounds, one degree above.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::{Coefficients, HomologyBasis};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The projective plane: one vertex, one loop, and a disk that runs twice along it.
    /// let plane = ChainComplex::new(vec![
    ///     SparseMatrix::zero(1, 1)?,
    ///     SparseMatrix::from_entries(1, 1, [(0, 0, 2)])?,
    /// ])?;
    /// let basis = HomologyBasis::new(&plane);
    /// let counts = |coefficients| [0, 1, 2].map(|degree| basis.generators_with(degree, coefficients).len());
    /// assert_eq!(counts(Coefficients::Rationals), [1, 0, 0]);
    /// assert_eq!(counts(Coefficients::Modulo(2)), [1, 1, 1]);
    /// # Ok(()) }
    /// ```
    pub fn generators_with(&self, degree: usize, coefficients: Coefficients) -> Vec<Generator> {
        let own = self.generators(degree).iter();
        match coefficients {
            Coefficients::Integers => own.cloned().collect(),
            Coefficients::Rationals => own.filter(|generator| generator.order.is_none()).cloned().collect(),
            Coefficients::Modulo(n) => {
                let (summands, chains) = self.cyclic_generators(degree, &n.into());
                let chains = summands.generators(chains).into_iter();
                let chains = chains.map(|terms| to_chain(self.complex, degree, terms));
                chains.zip(summands.orders()).map(|(chain, order)| Generator { chain, order }).collect()
            }
        }
    }

    /// Cycles modulo n of cyclic summands, and how they become summands whose orders divide each other. Smaller orders are first, whole summands last, as
    /// over the integers.
    pub(super) fn cyclic_generators(
        &self,
        degree: usize,
        modulus: &Integer,
    ) -> (Summands, Vec<SparseVector>) {
        let own = self.generators(degree).iter();
        let reduced = |chain: &Chain<Integer>, factor: &Integer| -> SparseVector {
            let terms = chain.terms().iter();
            let terms = terms.map(|(cell, x)| (cell.to_u32(), (x * factor).div_rem_nearest(modulus).1));
            terms.filter(|(_, x)| !x.is_zero()).collect()
        };
        let below = degree.checked_sub(1).map_or(&[][..], |below| self.generators(below));
        let from_below = below.iter().enumerate().filter_map(|(i, generator)| {
            let common = generator.order.as_ref()?.gcd(modulus);
            let chain = (!common.is_unit()).then(|| self.certificate(degree - 1, i))??;
            let factor = modulus.exact_quotient(&common).expect("a gcd divides");
            Some((common, reduced(&chain, &factor)))
        });
        let own = own.map(|generator| match &generator.order {
            None => (modulus.clone(), &generator.chain),
            Some(order) => (order.gcd(modulus), &generator.chain),
        });
        let own = own.filter(|(order, _)| !order.is_unit());
        let mut list: Vec<(Integer, SparseVector)> =
            own.map(|(order, chain)| (order, reduced(chain, &Integer::ONE))).chain(from_below).collect();
        list.sort_by(|a, b| a.0.cmp(&b.0));
        let (orders, chains) = list.into_iter().unzip();
        (Summands::new(modulus, orders), chains)
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

/// The sum of the absolute values; `None` beyond 64 bits.
pub(super) fn length(chain: &[(u32, Integer)]) -> Option<u64> {
    chain.iter().try_fold(0u64, |sum, (_, x)| sum.checked_add(x.to_i64()?.unsigned_abs()))
}

pub(super) fn to_vector(chain: &Chain<Integer>) -> SparseVector {
    chain.terms().iter().map(|(cell, x)| (cell.to_u32(), x.clone())).collect()
}

pub(super) fn to_chain(complex: &ChainComplex, degree: usize, terms: SparseVector) -> Chain<Integer> {
    let terms = terms.into_iter().map(|(cell, x)| (CellId::new(cell as usize), x));
    Chain::new(complex, degree, terms).expect("the cells are those of the complex")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::homology::class::Cocycle;
    use crate::homology::computation::{cohomology, homology_with};
    use crate::homology::homology;
    use coface_algebra::chains::Cochain;
    use coface_algebra::samples::random_complexes;
    use proptest::prelude::*;

    /// Integers for one test, over and over.
    fn cycled(numbers: &[i64]) -> impl FnMut() -> Integer + '_ {
        let mut numbers = numbers.iter().cycle();
        move || Integer::from(*numbers.next().unwrap())
    }

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
                let mut next = cycled(&numbers);
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

        /// Invariant 18 over fields and Z/n: closed modulo n, cycles modulo n, as many as the group has summands, and
        /// over a prime field the matrix of values is the identity.
        #[test]
        fn bases_with_coefficients_are_dual(complex in random_complexes(), n in 2u64..13) {
            let basis = HomologyBasis::new(&complex);
            let coefficients = Coefficients::Modulo(n);
            let is_zero = |x: &Integer| Integer::from(n).divides(x);
            let groups = homology_with(&complex, coefficients);
            let is_prime = (2..n).all(|d| n % d != 0);
            for degree in 0..complex.degree_count() {
                let generators = basis.generators_with(degree, coefficients);
                let cocycles = basis.cocycles_with(degree, coefficients);
                let whole = |order: Option<&Integer>| Some(order.cloned().unwrap_or_else(|| Integer::from(n)));
                let group = &groups.groups()[degree];
                let expected = AbelianGroup::new(
                    0,
                    group.torsion().iter().cloned().chain((0..group.betti()).map(|_| Integer::from(n))).collect(),
                );
                let list: Vec<_> = generators.iter().map(|g| whole(g.order())).collect();
                // The summands are those that are listed, and so are those of the cocycles.
                prop_assert_eq!(list.iter().flatten().cloned().collect::<Vec<_>>(), expected.torsion());
                prop_assert_eq!(&orders(list.iter().map(Option::as_ref)), &expected);
                let list: Vec<_> = cocycles.iter().map(|c| whole(c.order())).collect();
                prop_assert_eq!(list.iter().flatten().cloned().collect::<Vec<_>>(), expected.torsion());
                prop_assert_eq!(&orders(list.iter().map(Option::as_ref)), &expected);
                for (i, cocycle) in cocycles.iter().enumerate() {
                    let coboundary = complex.coboundary(cocycle.cochain()).unwrap();
                    prop_assert!(coboundary.terms().iter().all(|(_, x)| is_zero(x)));
                    let class = basis.class_of_cocycle_modulo(cocycle.cochain(), n).unwrap();
                    let unit = (0..cocycles.len()).map(|j| Integer::from(i64::from(i == j)));
                    prop_assert_eq!(class.coefficients(), unit.collect::<Vec<_>>());
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

        /// Invariant 19: a random cycle is a combination of generators plus a boundary, and what `bounding` says of
        /// it is proved by what it gives.
        #[test]
        fn classes_are_additive_and_verdicts_carry_proofs(
            complex in random_complexes(),
            numbers in prop::collection::vec(-4i64..5, 40),
        ) {
            let basis = HomologyBasis::new(&complex);
            for degree in 0..complex.degree_count() {
                let mut next = cycled(&numbers);
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
        let edge = coface_complexes::known_spaces::simplex(1).unwrap().chain_complex().unwrap();
        let chain = Chain::new(&edge, 1, [(CellId::new(0), Integer::ONE)]).unwrap();
        let basis = HomologyBasis::new(&edge);
        assert_eq!(basis.class_of(&chain).unwrap_err().kind(), ErrorKind::NotACycle);
        assert_eq!(basis.bounding(&chain).unwrap_err().kind(), ErrorKind::NotACycle);
        let beyond = Chain::zero(7);
        assert!(basis.class_of(&beyond).unwrap().is_zero());
        assert_eq!(basis.bounding(&beyond).unwrap(), Bounding::Bounds(Chain::zero(8)));
    }
}
