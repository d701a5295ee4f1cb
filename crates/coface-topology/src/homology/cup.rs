//! Products of cochains, and of cochains with chains.

use coface_algebra::chains::{Chain, ChainComplex, Cochain, Coefficient};
use coface_algebra::{CellId, Error, ErrorKind};
use coface_complexes::simplicial::DeltaComplex;

/// A delta complex with its chain complex: what products of cochains are made on.
///
/// The product is that of Alexander and Whitney. On a simplex s of degree p + q,
/// $(f \smile g)(s) = f(\text{front p-face of } s) \cdot g(\text{back q-face of } s)$: f on the first p + 1 vertices
/// times g on the last q + 1, in the order of the simplex. It is associative, with the constant 1 as unit, and
/// $\delta(f \smile g) = \delta f \smile g + (-1)^p f \smile \delta g$. So products of cocycles are cocycles, and on
/// cohomology $g \smile f = (-1)^{pq} f \smile g$, though not on cochains.
///
/// # References
/// A. Hatcher, *Algebraic topology* (2002), sections 3.2 and 3.3.
///
/// # Examples
/// The torus of two triangles: 0 and 1 are the sides of a square, 2 is its diagonal. The cochains that count the
/// steps along each side have a product of 1 on one triangle and 0 on the other.
/// ```
/// use coface_algebra::CellId;
/// use coface_algebra::Integer;
/// use coface_algebra::chains::Cochain;
/// use coface_complexes::simplicial::DeltaComplex;
/// use coface_topology::CochainAlgebra;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let torus = CochainAlgebra::new(DeltaComplex::new(1, vec![vec![0; 6], vec![1, 2, 0, 0, 2, 1]])?)?;
/// let along = |edges: [usize; 2]| {
///     Cochain::new(torus.chains(), 1, edges.map(|edge| (CellId::new(edge), Integer::ONE)))
/// };
/// let product = torus.cup(&along([0, 2])?, &along([1, 2])?)?;
/// assert_eq!(product.to_string(), "c0");
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct CochainAlgebra {
    complex: DeltaComplex,
    chains: ChainComplex,
}

impl CochainAlgebra {
    /// The cochains of this complex.
    ///
    /// # Errors
    /// As [`DeltaComplex::chain_complex`].
    ///
    /// # Complexity
    /// Linear in the number of faces.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::DeltaComplex;
    /// use coface_topology::CochainAlgebra;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The circle of one edge, with both ends at the one vertex.
    /// let circle = CochainAlgebra::new(DeltaComplex::new(1, vec![vec![0, 0]])?)?;
    /// assert_eq!(circle.chains().f_vector(), [1, 1]);
    /// # Ok(()) }
    /// ```
    pub fn new(complex: DeltaComplex) -> Result<Self, Error> {
        let chains = complex.chain_complex()?;
        Ok(Self { complex, chains })
    }

    /// The complex.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::DeltaComplex;
    /// use coface_topology::CochainAlgebra;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The circle of one edge, with both ends at the one vertex.
    /// let circle = CochainAlgebra::new(DeltaComplex::new(1, vec![vec![0, 0]])?)?;
    /// assert_eq!(circle.complex().simplex_count(1), 1);
    /// # Ok(()) }
    /// ```
    pub fn complex(&self) -> &DeltaComplex {
        &self.complex
    }

    /// Its chain complex; cells have the same numbers.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::DeltaComplex;
    /// use coface_topology::CochainAlgebra;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The circle of one edge, with both ends at the one vertex.
    /// let circle = CochainAlgebra::new(DeltaComplex::new(1, vec![vec![0, 0]])?)?;
    /// assert_eq!(circle.chains().cell_count(0), 1);
    /// # Ok(()) }
    /// ```
    pub fn chains(&self) -> &ChainComplex {
        &self.chains
    }

    /// The constant cochain of degree 0 with this value on every vertex. With the value 1 it is the unit of the
    /// product.
    ///
    /// # Errors
    /// [`ErrorKind::Coefficient`] for a floating-point value that is no number.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Integer;
    /// use coface_complexes::simplicial::DeltaComplex;
    /// use coface_topology::CochainAlgebra;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The circle of one edge, with both ends at the one vertex.
    /// let circle = CochainAlgebra::new(DeltaComplex::new(1, vec![vec![0, 0]])?)?;
    /// assert_eq!(circle.constant(&Integer::from(3))?.to_string(), "3 c0");
    /// # Ok(()) }
    /// ```
    pub fn constant<C: Coefficient>(&self, value: &C) -> Result<Cochain<C>, Error> {
        let vertices = 0..self.complex.simplex_count(0);
        Cochain::new(&self.chains, 0, vertices.map(|vertex| (CellId::new(vertex), value.clone())))
    }

    /// The product of two cochains; its degree is the sum of theirs. Above the dimension it is zero.
    ///
    /// # Errors
    /// [`ErrorKind::NotInComplex`] if a cochain has a cell that is not here, [`ErrorKind::Coefficient`] if the rings
    /// differ.
    ///
    /// # Complexity
    /// $O(n (p + q))$ for n simplices of degree p + q.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, Integer};
    /// use coface_algebra::chains::Cochain;
    /// use coface_complexes::simplicial::DeltaComplex;
    /// use coface_topology::CochainAlgebra;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The circle of one edge, with both ends at the one vertex.
    /// let circle = CochainAlgebra::new(DeltaComplex::new(1, vec![vec![0, 0]])?)?;
    /// let unit = circle.constant(&Integer::ONE)?;
    /// let loops = Cochain::new(circle.chains(), 1, [(CellId::new(0), Integer::from(2))])?;
    /// assert_eq!(circle.cup(&unit, &loops)?, loops);
    /// # Ok(()) }
    /// ```
    pub fn cup<C: Coefficient>(&self, first: &Cochain<C>, second: &Cochain<C>) -> Result<Cochain<C>, Error> {
        let (p, q) = (first.degree(), second.degree());
        let (front, back) = (self.values(first)?, self.values(second)?);
        let mut terms = Vec::new();
        for simplex in (0..self.complex.simplex_count(p + q)).map(CellId::new) {
            let Some(value) = front[self.complex.front_face(p + q, simplex, p).index()] else { continue };
            let Some(other) = back[self.complex.back_face(p + q, simplex, q).index()] else { continue };
            terms.push((simplex, value.times(other)?));
        }
        Cochain::new(&self.chains, p + q, terms)
    }

    /// The product of a cochain of degree p with a chain of degree n: each simplex of the chain becomes its back face
    /// of degree n - p times the value of the cochain on its front face. So $(f \smile g)(c) = g(f \frown c)$, and
    /// $\partial(f \frown c) = (-1)^p (f \frown \partial c - \delta f \frown c)$.
    ///
    /// With the fundamental cycle of a closed oriented manifold it takes cocycles to the cycles that are Poincare dual.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] if p is greater than n; [`ErrorKind::NotInComplex`] if the cochain or the chain has a
    /// cell that is not here; [`ErrorKind::Coefficient`] if the rings differ.
    ///
    /// # Complexity
    /// $O(m n)$ for m simplices in the chain.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::CellId;
    /// use coface_algebra::Integer;
    /// use coface_algebra::chains::{Chain, Cochain};
    /// use coface_complexes::known_spaces::simplex;
    /// use coface_topology::CochainAlgebra;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The triangle 012 with the edges 01, 02, 12; the cochain is 5 on its front edge 01.
    /// let triangle = CochainAlgebra::new(simplex(2)?.freeze().to_delta()?)?;
    /// let five = Cochain::new(triangle.chains(), 1, [(CellId::new(0), Integer::from(5))])?;
    /// let whole = Chain::new(triangle.chains(), 2, [(CellId::new(0), Integer::ONE)])?;
    /// assert_eq!(triangle.cap(&five, &whole)?.to_string(), "5 c2");
    /// # Ok(()) }
    /// ```
    pub fn cap<C: Coefficient>(&self, cochain: &Cochain<C>, chain: &Chain<C>) -> Result<Chain<C>, Error> {
        let (p, n) = (cochain.degree(), chain.degree());
        let Some(q) = n.checked_sub(p) else {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("a cochain of degree {p} has no product with a chain of degree {n}"),
            )
            .with_cure("take a cochain of at most the degree of the chain"));
        };
        self.check_support(n, chain.support().last())?;
        let front = self.values(cochain)?;
        let mut terms = Vec::new();
        for (simplex, coefficient) in chain.terms() {
            if let Some(value) = front[self.complex.front_face(n, *simplex, p).index()] {
                let face = self.complex.back_face(n, *simplex, q);
                terms.push((face, value.times(coefficient)?));
            }
        }
        Chain::new(&self.chains, q, terms)
    }

    /// The values of all products of a cochain of one list with one of the other on a chain: entry (i, j) is
    /// $(f_i \smile g_j)(c)$; `None` stands for zero. The chain is walked once.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] if cochains of a list differ in degree or the degrees do not add up to that of the chain;
    /// [`ErrorKind::NotInComplex`] and [`ErrorKind::Coefficient`] as for [`Self::cup`].
    ///
    /// # Complexity
    /// $O(m (p + q))$ for m simplices in the chain, and the products that are not zero.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, Integer};
    /// use coface_algebra::chains::{Chain, Cochain};
    /// use coface_complexes::simplicial::DeltaComplex;
    /// use coface_topology::CochainAlgebra;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The circle of one edge, with both ends at the one vertex.
    /// let circle = CochainAlgebra::new(DeltaComplex::new(1, vec![vec![0, 0]])?)?;
    /// let unit = circle.constant(&Integer::ONE)?;
    /// let along = Cochain::new(circle.chains(), 1, [(CellId::new(0), Integer::ONE)])?;
    /// let twice = Chain::new(circle.chains(), 1, [(CellId::new(0), Integer::from(2))])?;
    /// assert_eq!(circle.products_on(&[unit], &[along], &twice)?, [[Some(2.into())]]);
    /// # Ok(()) }
    /// ```
    pub fn products_on<C: Coefficient>(
        &self,
        first: &[Cochain<C>],
        second: &[Cochain<C>],
        chain: &Chain<C>,
    ) -> Result<Vec<Vec<Option<C>>>, Error> {
        let mut table: Vec<Vec<Option<C>>> = vec![vec![None; second.len()]; first.len()];
        let (Some(p), Some(q)) = (self.common_degree(first)?, self.common_degree(second)?) else {
            return Ok(table);
        };
        let n = chain.degree();
        if p + q != n {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("products of degrees {p} and {q} have no value on a chain of degree {n}"),
            ));
        }
        self.check_support(n, chain.support().last())?;
        let (front, back) = (self.by_cell(p, first), self.by_cell(q, second));
        for (simplex, coefficient) in chain.terms() {
            let here = front.at(self.complex.front_face(n, *simplex, p).index());
            if here.is_empty() {
                continue;
            }
            let there = back.at(self.complex.back_face(n, *simplex, q).index());
            for (i, value) in here {
                let value = value.times(coefficient)?;
                for (j, other) in there {
                    let product = value.times(other)?;
                    let entry = &mut table[*i as usize][*j as usize];
                    *entry = Some(match entry.take() {
                        Some(sum) => sum.plus(&product)?,
                        None => product,
                    });
                }
            }
        }
        for entry in table.iter_mut().flatten() {
            entry.take_if(|sum| sum.is_zero());
        }
        Ok(table)
    }

    /// The values of a cochain by cell.
    fn values<'a, C: Coefficient>(&self, cochain: &'a Cochain<C>) -> Result<Vec<Option<&'a C>>, Error> {
        self.check_support(cochain.degree(), cochain.support().last())?;
        let mut values = vec![None; self.complex.simplex_count(cochain.degree())];
        for (cell, value) in cochain.terms() {
            values[cell.index()] = Some(value);
        }
        Ok(values)
    }

    /// That the last cell of a chain or cochain is there.
    fn check_support(&self, degree: usize, last: Option<CellId>) -> Result<(), Error> {
        let count = self.complex.simplex_count(degree);
        match last {
            Some(cell) if cell.index() >= count => Err(Error::new(
                ErrorKind::NotInComplex,
                format!("there is no cell {cell} of degree {degree}: there are {count} such cells"),
            )),
            _ => Ok(()),
        }
    }

    /// The degree of all of these cochains, which have to be of this complex; `None` for an empty list.
    fn common_degree<C: Coefficient>(&self, cochains: &[Cochain<C>]) -> Result<Option<usize>, Error> {
        let Some(first) = cochains.first() else { return Ok(None) };
        for cochain in cochains {
            if cochain.degree() != first.degree() {
                return Err(Error::new(
                    ErrorKind::Shape,
                    format!(
                        "cochains of the degrees {} and {} are in one list",
                        first.degree(),
                        cochain.degree()
                    ),
                ));
            }
            self.check_support(cochain.degree(), cochain.support().last())?;
        }
        Ok(Some(first.degree()))
    }

    /// The cochains of a list by the cells on which they do not vanish.
    fn by_cell<'a, C: Coefficient>(&self, degree: usize, cochains: &'a [Cochain<C>]) -> ByCell<'a, C> {
        let with_cells = (0..).zip(cochains).flat_map(|(i, cochain)| {
            cochain.terms().iter().map(move |(cell, value)| (cell.index(), (i, value)))
        });
        let mut members: Vec<(usize, (u32, &C))> = with_cells.collect();
        members.sort_by_key(|&(cell, (i, _))| (cell, i));
        let mut starts = vec![0; self.complex.simplex_count(degree) + 1];
        members.iter().for_each(|&(cell, _)| starts[cell + 1] += 1);
        for cell in 1..starts.len() {
            starts[cell] += starts[cell - 1];
        }
        ByCell { starts, members: members.into_iter().map(|(_, member)| member).collect() }
    }
}

/// For each cell the positions of cochains in their list, with their values on the cell.
struct ByCell<'a, C> {
    starts: Vec<usize>,
    members: Vec<(u32, &'a C)>,
}

impl<'a, C> ByCell<'a, C> {
    fn at(&self, cell: usize) -> &[(u32, &'a C)] {
        &self.members[self.starts[cell]..self.starts[cell + 1]]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_algebra::{Integer, RaggedArray, Residue};
    use coface_complexes::simplicial::FrozenComplex;
    use proptest::prelude::*;

    fn algebra(complex: &FrozenComplex) -> CochainAlgebra {
        CochainAlgebra::new(complex.to_delta().unwrap()).unwrap()
    }

    /// Up to eight simplices on seven vertices.
    fn complexes() -> impl Strategy<Value = FrozenComplex> {
        let facet = prop::sample::subsequence((0u32..7).collect::<Vec<_>>(), 1..=5);
        prop::collection::vec(facet, 1..8)
            .prop_map(|facets| FrozenComplex::from_facets(&RaggedArray::from_lists(facets)).unwrap())
    }

    type Values = Vec<i64>;

    fn values() -> impl Strategy<Value = Values> {
        prop::collection::vec(-3i64..=3, 40)
    }

    /// A cochain whose values run through the list.
    fn cochain(of: &CochainAlgebra, degree: usize, values: &Values) -> Cochain<Integer> {
        let cells = 0..of.complex().simplex_count(degree);
        let value = |cell| (CellId::new(cell), Integer::from(values[(cell * 7 + degree) % values.len()]));
        Cochain::new(of.chains(), degree, cells.map(value)).unwrap()
    }

    fn chain(of: &CochainAlgebra, degree: usize, values: &Values) -> Chain<Integer> {
        let terms = cochain(of, degree, values).terms().to_vec();
        Chain::new(of.chains(), degree, terms).unwrap()
    }

    fn signed<C: Coefficient>(exponent: usize, cochain: &Cochain<C>) -> Cochain<C> {
        if exponent.is_multiple_of(2) { cochain.clone() } else { cochain.negated() }
    }

    proptest! {
        #[test]
        fn the_coboundary_of_a_product_follows_the_rule_of_leibniz(
            complex in complexes(), a in values(), b in values(), p in 0usize..3, q in 0usize..3,
        ) {
            let x = algebra(&complex);
            let (f, g) = (cochain(&x, p, &a), cochain(&x, q, &b));
            let whole = x.chains().coboundary(&x.cup(&f, &g).unwrap()).unwrap();
            let left = x.cup(&x.chains().coboundary(&f).unwrap(), &g).unwrap();
            let right = x.cup(&f, &x.chains().coboundary(&g).unwrap()).unwrap();
            prop_assert_eq!(whole, left.plus(&signed(p, &right)).unwrap());
        }

        #[test]
        fn products_are_associative_with_a_unit(
            complex in complexes(), a in values(), b in values(), c in values(), p in 0usize..3, q in 0usize..3, r in 0usize..2,
        ) {
            let x = algebra(&complex);
            let (f, g, h) = (cochain(&x, p, &a), cochain(&x, q, &b), cochain(&x, r, &c));
            prop_assert_eq!(
                x.cup(&x.cup(&f, &g).unwrap(), &h).unwrap(),
                x.cup(&f, &x.cup(&g, &h).unwrap()).unwrap()
            );
            let one = x.constant(&Integer::ONE).unwrap();
            prop_assert_eq!(&x.cup(&one, &f).unwrap(), &f);
            prop_assert_eq!(&x.cup(&f, &one).unwrap(), &f);
        }

        /// Modulo n it is the product of the residues.
        #[test]
        fn residues_commute_with_products(complex in complexes(), a in values(), b in values(), n in 1u32..7) {
            let x = algebra(&complex);
            let modulo = |f: &Cochain<Integer>| {
                let terms = f.terms().iter().map(|(cell, v)| (*cell, Residue::from_integer(v, n).unwrap()));
                Cochain::new(x.chains(), f.degree(), terms).unwrap()
            };
            let (f, g) = (cochain(&x, 1, &a), cochain(&x, 1, &b));
            let product = x.cup(&modulo(&f), &modulo(&g)).unwrap();
            prop_assert_eq!(product, modulo(&x.cup(&f, &g).unwrap()));
        }

        /// A vertex map that keeps the order pulls products back to products.
        #[test]
        fn products_are_natural(
            complex in complexes(), steps in prop::collection::vec(0u32..=1, 7), a in values(), b in values(),
            p in 0usize..3, q in 0usize..3,
        ) {
            let image: Vec<u32> = (0..7).map(|v| steps[..v as usize].iter().sum()).collect();
            let map = |simplex: &[u32]| -> Vec<u32> { simplex.iter().map(|&v| image[v as usize]).collect() };
            let mut facets = RaggedArray::new();
            for k in 0..complex.f_vector().len() {
                for i in 0..complex.simplex_count(k) {
                    let mut moved = map(complex.numbers(k, i));
                    moved.dedup();
                    facets.push(&moved);
                }
            }
            let target = FrozenComplex::from_facets(&facets).unwrap();
            let (x, y) = (algebra(&complex), algebra(&target));
            let pull_back = |f: &Cochain<Integer>| {
                let k = f.degree();
                let terms = (0..complex.simplex_count(k)).filter_map(|i| {
                    // A simplex that is flattened has the value 0.
                    let cell = target.index_of(&map(complex.numbers(k, i)))?;
                    Some((CellId::new(i), f.coefficient(CellId::new(cell))?.clone()))
                });
                Cochain::new(x.chains(), k, terms).unwrap()
            };
            let (f, g) = (cochain(&y, p, &a), cochain(&y, q, &b));
            let product = x.cup(&pull_back(&f), &pull_back(&g)).unwrap();
            prop_assert_eq!(product, pull_back(&y.cup(&f, &g).unwrap()));
        }

        #[test]
        fn caps_are_dual_to_cups(
            complex in complexes(), a in values(), b in values(), c in values(), p in 0usize..3, q in 0usize..3,
        ) {
            let x = algebra(&complex);
            let (f, g, z) = (cochain(&x, p, &a), cochain(&x, q, &b), chain(&x, p + q, &c));
            let cap = x.cap(&f, &z).unwrap();
            prop_assert_eq!(g.pairing(&cap).unwrap(), x.cup(&f, &g).unwrap().pairing(&z).unwrap());
            let table = x.products_on(std::slice::from_ref(&f), &[g.clone(), g.negated()], &z).unwrap();
            prop_assert_eq!(&table[0][0], &g.pairing(&cap).unwrap());
            prop_assert_eq!(&table[0][1], &g.negated().pairing(&cap).unwrap());
            if q > 0 {
                let boundary = x.chains().boundary(&cap).unwrap();
                let first = x.cap(&f, &x.chains().boundary(&z).unwrap()).unwrap();
                let second = x.cap(&x.chains().coboundary(&f).unwrap(), &z).unwrap();
                let difference = first.minus(&second).unwrap();
                prop_assert_eq!(boundary, if p.is_multiple_of(2) { difference } else { difference.negated() });
            }
        }
    }

    #[test]
    fn what_does_not_fit_is_refused() {
        let simplex = FrozenComplex::from_facets(&RaggedArray::from_lists([[0, 1, 2]])).unwrap();
        let (x, big) = (
            algebra(&simplex),
            algebra(&FrozenComplex::from_facets(&RaggedArray::from_lists([[0, 1, 2, 3]])).unwrap()),
        );
        let of = |x: &CochainAlgebra, degree, cell| {
            Cochain::new(x.chains(), degree, [(CellId::new(cell), Integer::ONE)]).unwrap()
        };
        assert_eq!(x.cup(&of(&big, 1, 5), &of(&x, 1, 0)).unwrap_err().kind(), ErrorKind::NotInComplex);
        let edge = Chain::new(x.chains(), 1, [(CellId::new(0), Integer::ONE)]).unwrap();
        assert_eq!(x.cap(&of(&x, 2, 0), &edge).unwrap_err().kind(), ErrorKind::Shape);
        let mixed = [of(&x, 0, 0), of(&x, 1, 0)];
        assert_eq!(x.products_on(&mixed, &mixed, &edge).unwrap_err().kind(), ErrorKind::Shape);
        assert_eq!(x.products_on(&mixed[..1], &mixed[..1], &edge).unwrap_err().kind(), ErrorKind::Shape);
        let residue =
            |n| Cochain::new(x.chains(), 0, [(CellId::new(0), Residue::new(1, n).unwrap())]).unwrap();
        assert_eq!(x.cup(&residue(2), &residue(3)).unwrap_err().kind(), ErrorKind::Coefficient);
        // Above the dimension everything is zero.
        assert!(x.cup(&of(&x, 2, 0), &of(&x, 1, 0)).unwrap().is_zero());
    }
}
