//! Bases of cohomology, dual to those of homology.

use crate::homology::basis::HomologyBasis;
use crate::homology::class::{Cocycle, HomologyClass};
use crate::homology::coefficients::Coefficients;
use crate::homology::summands::Summands;
use coface_algebra::chains::Cochain;
use coface_algebra::{CellId, Error, ErrorKind};
use coface_algebra::{Integer, SparseVector, WideMatrix, inner_product};

impl HomologyBasis<'_> {
    /// Cocycles whose classes are a basis of integral cohomology in one degree: those of finite order first, then free
    /// ones. Free cocycle i has the value 1 on the free generator i of homology and 0 on all other generators; one of
    /// finite order m is, up to coboundaries, 1/m of the coboundary of the dual of a torsion generator one degree
    /// below.
    ///
    /// # Complexity
    /// One pass through the pairs of the matching and the values that are not zero.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::known_spaces::circle;
    /// use coface_topology::HomologyBasis;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let circle = circle(5)?.chain_complex()?;
    /// let basis = HomologyBasis::new(&circle);
    /// let (cocycle, around) = (&basis.cocycles(1)[0], &basis.generators(1)[0]);
    /// assert_eq!(cocycle.cochain().pairing(around.chain())?, Some(1.into()));
    /// # Ok(()) }
    /// ```
    pub fn cocycles(&self, degree: usize) -> Vec<Cocycle> {
        self.cocycles_with(degree, Coefficients::Integers)
    }

    /// The class of a closed cochain in the basis of [`Self::cocycles`]: coefficients from 0 to m - 1 on cocycles of
    /// finite order m, then those on free cocycles.
    ///
    /// # Errors
    /// [`ErrorKind::NotInComplex`] if the cochain has a cell that is not here, [`ErrorKind::NotACycle`] naming a cell
    /// in its coboundary.
    ///
    /// # Complexity
    /// One pass through the pairs of the matching and the values that are not zero.
    ///
    /// # Examples
    /// Two edges make a circle, each from an end to the other: the cochain that is 1 on both has the value 2 around it.
    /// ```
    /// use coface_algebra::CellId;
    /// use coface_algebra::{Integer, SparseMatrix};
    /// use coface_algebra::chains::{ChainComplex, Cochain};
    /// use coface_topology::HomologyBasis;
    /// # fn main() -> Result<(), coface_algebra::Error> {
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
        let restricted = self.restricted(cocycle);
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

    /// Cocycles whose classes are a basis of cohomology with coefficients in one degree; over a field they are dual to
    /// [`Self::generators_with`]: the matrix of values is the identity.
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
    /// // Over F_2 there is a class in each degree.
    /// let counts = [0, 1, 2].map(|degree| basis.cocycles_with(degree, Coefficients::Modulo(2)).len());
    /// assert_eq!(counts, [1, 1, 1]);
    /// # Ok(()) }
    /// ```
    pub fn cocycles_with(&self, degree: usize, coefficients: Coefficients) -> Vec<Cocycle> {
        let Some(basis) = self.degrees.get(degree) else { return Vec::new() };
        if let Coefficients::Modulo(n) = coefficients {
            let (summands, cochains) = self.cyclic_cocycles(degree, &n.into());
            let cochains = summands.generators(cochains).into_iter();
            let cochains = cochains.map(|terms| self.cochain(degree, terms));
            return cochains
                .zip(summands.orders())
                .map(|(cochain, order)| Cocycle { order, cochain })
                .collect();
        }
        let below = degree.checked_sub(1).map_or(&[][..], |below| &self.degrees[below].orders);
        // Over Z the torsion of cohomology comes from one degree below.
        let torsion = below.iter().zip(&basis.duals).filter(|(order, _)| !order.is_unit());
        let torsion = torsion.filter(|_| coefficients == Coefficients::Integers);
        let torsion = torsion.map(|(order, dual)| (Some(order.clone()), dual.clone()));
        let free = basis.duals[basis.rank + basis.orders.len()..].iter().map(|dual| (None, dual.clone()));
        let (orders, duals): (Vec<Option<Integer>>, Vec<SparseVector>) = torsion.chain(free).unzip();
        let cochains = self.pulled_back(degree, &duals).into_iter();
        orders.into_iter().zip(cochains).map(|(order, cochain)| Cocycle { order, cochain }).collect()
    }

    /// Cocycles modulo n of cyclic summands, in the order of [`Self::cyclic_generators`], and how they become summands whose orders divide each other.
    pub(super) fn cyclic_cocycles(&self, degree: usize, modulus: &Integer) -> (Summands, Vec<SparseVector>) {
        let list = self.cyclic_summands(degree, modulus);
        let duals: Vec<SparseVector> =
            list.iter().map(|one| self.degrees[degree].duals[one.position].clone()).collect();
        let reduced = |(one, cochain): (&CyclicSummand, Cochain<Integer>)| -> SparseVector {
            let terms = cochain.terms().iter();
            let terms = terms.map(|(cell, x)| (cell.to_u32(), (x * &one.factor).div_rem_nearest(modulus).1));
            terms.filter(|(_, x)| !x.is_zero()).collect()
        };
        let cochains = list.iter().zip(self.pulled_back(degree, &duals)).map(reduced).collect();
        (Summands::new(modulus, list.into_iter().map(|one| one.order).collect()), cochains)
    }

    /// The summands of cohomology over Z/n that positions of the basis make: those of this degree, then those from one below, by rising orders.
    fn cyclic_summands(&self, degree: usize, modulus: &Integer) -> Vec<CyclicSummand> {
        let Some(basis) = self.degrees.get(degree) else { return Vec::new() };
        let below = degree.checked_sub(1).map_or(&[][..], |below| &self.degrees[below].orders);
        let mut list = Vec::new();
        for position in (basis.rank..basis.duals.len()).chain(0..basis.rank) {
            let order = match position.checked_sub(basis.rank) {
                None => below[position].gcd(modulus),
                Some(cycle) => basis.orders.get(cycle).map_or(modulus.clone(), |order| order.gcd(modulus)),
            };
            if !order.is_unit() {
                let factor = match position < basis.rank {
                    true => Integer::ONE,
                    false => modulus.exact_quotient(&order).expect("a gcd divides"),
                };
                list.push(CyclicSummand { position, factor, order });
            }
        }
        list.sort_by(|a, b| a.order.cmp(&b.order));
        list
    }

    /// The class of a cochain that is closed modulo n in the basis of [`Self::cocycles_with`] over Z/n: coefficients from 0 to m - 1 on cocycles of order m, up to
    /// n - 1 on those of whole summands.
    ///
    /// # Errors
    /// As of [`Self::class_of_cocycle`], where the coboundary is not zero modulo n.
    ///
    /// # Complexity
    /// As of [`Self::class_of_cocycle`].
    ///
    /// # Examples
    /// A loop with a disk that runs twice along it: 3 on the loop is closed modulo 6, and a class of order 2.
    /// ```
    /// use coface_algebra::CellId;
    /// use coface_algebra::{Integer, SparseMatrix};
    /// use coface_algebra::chains::{ChainComplex, Cochain};
    /// use coface_topology::HomologyBasis;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let plane = ChainComplex::new(vec![
    ///     SparseMatrix::zero(1, 1)?,
    ///     SparseMatrix::from_entries(1, 1, [(0, 0, 2)])?,
    /// ])?;
    /// let three = Cochain::new(&plane, 1, [(CellId::new(0), Integer::from(3))])?;
    /// let class = HomologyBasis::new(&plane).class_of_cocycle_modulo(&three, 6)?;
    /// assert_eq!((class.coefficients(), class.order()), (&[1.into()][..], Some(2.into())));
    /// # Ok(()) }
    /// ```
    pub fn class_of_cocycle_modulo(
        &self,
        cocycle: &Cochain<Integer>,
        n: u64,
    ) -> Result<HomologyClass, Error> {
        let (degree, modulus) = (cocycle.degree(), Integer::from(n));
        let coboundary = self.complex.coboundary(cocycle)?;
        if let Some((cell, value)) = coboundary.terms().iter().find(|(_, value)| !modulus.divides(value)) {
            return Err(Error::new(
                ErrorKind::NotACycle,
                format!(
                    "the cochain of degree {degree} is not closed modulo {n}: its coboundary has the value {value} on cell {cell} of degree {}",
                    degree + 1
                ),
            )
            .with_cure("give a cochain whose coboundary is zero modulo n"));
        }
        let list = self.cyclic_summands(degree, &modulus);
        if list.is_empty() {
            return Ok(HomologyClass { coefficients: Vec::new(), orders: Vec::new() });
        }
        let restricted = self.restricted(cocycle);
        let given = list.iter().map(|one| {
            let value = inner_product(&restricted, &self.degrees[degree].elements[one.position]);
            let value = value.div_rem_floor(&modulus).1.exact_quotient(&one.factor);
            value.expect("values of what is closed are multiples of the factor").div_rem_floor(&one.order).1
        });
        let given = given.collect();
        let summands = Summands::new(&modulus, list.into_iter().map(|one| one.order).collect());
        // n times a class is zero, also in a whole summand.
        let orders = summands.orders().into_iter().map(|order| order.or(Some(modulus.clone()))).collect();
        Ok(HomologyClass { coefficients: summands.coefficients(given), orders })
    }

    /// The values of a cochain on the cells of the reduced complex.
    fn restricted(&self, cochain: &Cochain<Integer>) -> SparseVector {
        let degree = cochain.degree();
        let mut columns = vec![SparseVector::new(); self.complex.cell_count(degree)];
        for (cell, value) in cochain.terms() {
            columns[cell.index()].push((0, value.clone()));
        }
        let values = WideMatrix::from_integer_columns(1, columns).expect("cells have 32-bit numbers");
        let (restricted, _) = self.reduction.restriction_and_cohomotopy(degree, &values);
        let restricted = restricted.transpose();
        restricted.column(0).terms().map(|(cell, x)| (cell as u32, x.clone())).collect()
    }

    /// Cochains of the reduced complex as cochains of the original one.
    pub(super) fn pulled_back(&self, degree: usize, duals: &[SparseVector]) -> Vec<Cochain<Integer>> {
        if duals.is_empty() {
            return Vec::new();
        }
        let pulled = self.values_on_cells(degree, duals).transpose();
        let cochain = |i: usize| {
            let terms = pulled.column(i).terms().map(|(cell, x)| (CellId::new(cell), x.clone()));
            Cochain::new(self.complex, degree, terms).expect("a pullback has the cells of the complex")
        };
        (0..duals.len()).map(cochain).collect()
    }

    /// The values of the dual basis on all cells of a degree: column c holds (number of the generator, value) of cell
    /// c. For generators of finite order the values are meant modulo that order.
    pub(super) fn annotations(&self, degree: usize) -> WideMatrix {
        let basis = &self.degrees[degree];
        self.values_on_cells(degree, &basis.duals[basis.generators()])
    }

    /// The values of cochains of the reduced complex on the original cells: a row for each cochain, a column for each
    /// cell.
    fn values_on_cells(&self, degree: usize, duals: &[SparseVector]) -> WideMatrix {
        let columns = duals.iter().map(Vec::as_slice);
        let values = WideMatrix::from_sorted_columns(self.reduction.cell_count(degree), columns)
            .expect("cells have 32-bit numbers");
        self.reduction.pullback(degree, &values.transpose())
    }
}

/// A cyclic summand of cohomology over Z/n: the dual basis at a position, times a factor.
struct CyclicSummand {
    position: usize,
    factor: Integer,
    order: Integer,
}
