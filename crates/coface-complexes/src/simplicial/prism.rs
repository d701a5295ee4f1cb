//! Prisms: the product of a simplex, a chain or a complex with an interval, cut into simplices.

use super::{FrozenComplex, SignedSimplices};
use coface_algebra::chains::{Chain, ChainComplex, ChainMap, Coefficient};
use coface_algebra::{CellId, Error, ErrorKind};
use coface_algebra::{RaggedArray, Sign, SparseMatrix};

/// The prism over a simplex $v_0, \dots, v_d$: the product with an interval, cut into d + 1 simplices. The copy at the
/// upper end of vertex v is `v + shift`.
///
/// The simplices are the windows of d + 2 vertices on the sequence $v_0, \dots, v_d, v_0', \dots, v_d'$, and
/// $P = \sum_i (-1)^{id} \, [v_i, \dots, v_d, v_0', \dots, v_i']$. This is the product orientation, with
/// $\partial P(c) = P(\partial c) + (-1)^d (c' - c)$: the prism over the boundary, and the upper end minus the lower end
/// with the sign of the dimension d of c.
///
/// # Errors
/// [`ErrorKind::InvalidInput`] for no vertex, a repeated one, or one that is not below `shift`; [`ErrorKind::TooLarge`] if
/// the copies have no 32-bit numbers.
///
/// # Complexity
/// $O(d^2)$, the size of the result.
///
/// # References
/// A. Paoluzzi, *Computational topology*, lecture 4 (2019); as homotopy: A. Hatcher, *Algebraic Topology* (2002), section 2.1.
///
/// # Examples
/// ```
/// use coface_algebra::Sign;
/// use coface_complexes::simplicial::prism;
/// let over_edge = prism(&[0, 1], 2)?;
/// assert_eq!(over_edge, [(Sign::Plus, vec![0, 1, 2]), (Sign::Minus, vec![1, 2, 3])]);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn prism(simplex: &[u32], shift: u32) -> Result<Vec<(Sign, Vec<u32>)>, Error> {
    SignedSimplices::new(&RaggedArray::from_lists([simplex]))?;
    check_shift(simplex, shift)?;
    let width = simplex.len() + 1;
    let mut items = vec![0; simplex.len() * width];
    fill_windows(simplex, 0, shift, &mut items);
    let windows = items.chunks_exact(width).enumerate();
    Ok(windows.map(|(i, window)| (window_sign(i, simplex.len() - 1), window.to_vec())).collect())
}

fn check_shift(vertices: &[u32], shift: u32) -> Result<(), Error> {
    let Some(&last) = vertices.iter().max() else { return Ok(()) };
    if last >= shift {
        return Err(Error::invalid(format!("vertex {last} is not below the shift {shift}"))
            .with_cure("shift by the number of vertices"));
    }
    if last.checked_add(shift).is_none() {
        return Err(no_copy(last));
    }
    Ok(())
}

fn no_copy(vertex: u32) -> Error {
    Error::new(ErrorKind::TooLarge, format!("the copy of vertex {vertex} has no 32-bit number"))
        .with_cure("renumber the vertices from 0")
}

/// The sign $(-1)^{id}$ of window i of the prism over a d-simplex.
pub(super) fn window_sign(window: usize, dimension: usize) -> Sign {
    Sign::power_of_minus_one(window * dimension)
}

/// Writes the windows of the prism over a simplex between two copies of its vertices, one after the other.
pub(super) fn fill_windows(simplex: &[u32], lower: u32, upper: u32, items: &mut [u32]) {
    for (i, window) in items.chunks_exact_mut(simplex.len() + 1).enumerate() {
        let (below, above) = window.split_at_mut(simplex.len() - i);
        below.iter_mut().zip(&simplex[i..]).for_each(|(to, v)| *to = v + lower);
        above.iter_mut().zip(simplex).for_each(|(to, v)| *to = v + upper);
    }
}

/// The prism over a complex: its product with an interval as a simplicial complex, the inclusions of its two ends, and the
/// operator that takes a chain to the prism over it.
///
/// # Examples
/// A circle times an interval is an annulus; its two ends differ by the boundary of the prism over it.
/// ```
/// use coface_algebra::CellId;
/// use coface_algebra::Integer;
/// use coface_algebra::chains::Chain;
/// use coface_complexes::known_spaces;
/// use coface_complexes::simplicial::Prism;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let circle = known_spaces::circle(3)?.freeze();
/// let annulus = Prism::new(&circle)?;
/// assert_eq!(annulus.complex().f_vector(), [6, 12, 6]);
/// // The edges are 01, 02, 12, so the cycle runs along the first, the third and against the second.
/// let terms = [(0, 1), (1, -1), (2, 1)].map(|(edge, x)| (CellId::new(edge), Integer::from(x)));
/// let cycle = Chain::new(&circle.chain_complex()?, 1, terms)?;
/// let ends = annulus.bottom().image(&cycle)?.minus(&annulus.top().image(&cycle)?)?;
/// assert_eq!(annulus.chain_complex()?.boundary(&annulus.over(&cycle)?)?, ends);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct Prism {
    complex: FrozenComplex,
    chain_complex: ChainComplex,
    shift: u32,
    bottom: ChainMap,
    top: ChainMap,
    /// From the k-chains of the base to the (k+1)-chains of the prism, at position k.
    matrices: Vec<SparseMatrix>,
}

impl Prism {
    /// The prism over a complex.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] if the copies of the vertices have no 32-bit numbers or there are more than 2^28
    /// simplices.
    ///
    /// # Complexity
    /// $O(n \log n)$ for n simplices of the prism.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::known_spaces::simplex_boundary;
    /// use coface_complexes::simplicial::Prism;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let prism = Prism::new(&simplex_boundary(1)?.freeze())?;
    /// assert_eq!(prism.complex().f_vector(), [6, 12, 6]);
    /// # Ok(()) }
    /// ```
    pub fn new(base: &FrozenComplex) -> Result<Self, Error> {
        let shift = match base.dimension().and_then(|_| base.flat(0).last()) {
            Some(&last) => last
                .checked_add(1)
                .filter(|shift| shift.checked_add(last).is_some())
                .ok_or_else(|| no_copy(last))?,
            None => 0,
        };
        let degree_count = base.dimension().map_or(0, |dimension| dimension + 1);
        let mut facets = RaggedArray::new();
        let mut items = Vec::new();
        for k in (0..degree_count).rev() {
            let mut is_face = vec![false; base.simplex_count(k)];
            for i in 0..base.simplex_count(k + 1) {
                base.facets(k + 1, i).for_each(|(_, facet)| is_face[facet] = true);
            }
            for i in (0..base.simplex_count(k)).filter(|&i| !is_face[i]) {
                items.resize((k + 1) * (k + 2), 0);
                fill_windows(base.numbers(k, i), 0, shift, &mut items);
                items.chunks_exact(k + 2).for_each(|window| facets.push(window));
            }
        }
        let complex = FrozenComplex::from_facets(&facets)?;
        let chain_complex = complex.chain_complex()?;
        let source = base.chain_complex()?;
        let inclusion = |shift: u32| {
            let matrices = (0..degree_count).map(|k| {
                let mut rows = Vec::with_capacity(base.simplex_count(k));
                let mut copy = vec![0; k + 1];
                for i in 0..base.simplex_count(k) {
                    copy.iter_mut().zip(base.numbers(k, i)).for_each(|(to, v)| *to = v + shift);
                    rows.push(index_in(&complex, &copy));
                }
                let starts = (0..=rows.len() as u32).collect();
                let entries = vec![1; rows.len()];
                SparseMatrix::from_parts(complex.simplex_count(k), starts, rows, entries)
            });
            ChainMap::new(&source, &chain_complex, matrices.collect::<Result<_, _>>()?)
        };
        let (bottom, top) = (inclusion(0)?, inclusion(shift)?);
        let matrices = (0..degree_count).map(|k| {
            let mut entries = Vec::with_capacity(base.simplex_count(k) * (k + 1));
            items.resize((k + 1) * (k + 2), 0);
            for i in 0..base.simplex_count(k) {
                fill_windows(base.numbers(k, i), 0, shift, &mut items);
                let windows = items.chunks_exact(k + 2).enumerate();
                entries.extend(windows.map(|(window, simplex)| {
                    (index_in(&complex, simplex) as usize, i, i64::from(window_sign(window, k).to_i32()))
                }));
            }
            SparseMatrix::from_entries(complex.simplex_count(k + 1), base.simplex_count(k), entries)
        });
        let matrices = matrices.collect::<Result<_, _>>()?;
        Ok(Self { complex, chain_complex, shift, bottom, top, matrices })
    }

    /// The product with the interval.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::known_spaces::simplex_boundary;
    /// use coface_complexes::simplicial::Prism;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let prism = Prism::new(&simplex_boundary(1)?.freeze())?;
    /// assert_eq!(prism.complex().f_vector(), [6, 12, 6]);
    /// # Ok(()) }
    /// ```
    pub fn complex(&self) -> &FrozenComplex {
        &self.complex
    }

    /// The chain complex of the product.
    ///
    /// # Errors
    /// None: it is copied.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::known_spaces::simplex_boundary;
    /// use coface_complexes::simplicial::Prism;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let prism = Prism::new(&simplex_boundary(1)?.freeze())?;
    /// assert_eq!(prism.chain_complex()?.euler_characteristic(), 0);
    /// # Ok(()) }
    /// ```
    pub fn chain_complex(&self) -> Result<ChainComplex, Error> {
        Ok(self.chain_complex.clone())
    }

    /// What is added to the number of a vertex for its copy at the upper end: one more than the greatest number.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::known_spaces::simplex_boundary;
    /// use coface_complexes::simplicial::Prism;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let prism = Prism::new(&simplex_boundary(1)?.freeze())?;
    /// assert_eq!(prism.shift(), 3);
    /// # Ok(()) }
    /// ```
    pub fn shift(&self) -> u32 {
        self.shift
    }

    /// The inclusion of the base at the lower end.
    pub fn bottom(&self) -> &ChainMap {
        &self.bottom
    }

    /// The inclusion of the base at the upper end.
    pub fn top(&self) -> &ChainMap {
        &self.top
    }

    /// The operator as a matrix P from the k-chains of the base to the (k+1)-chains of the product; `None` beyond the
    /// dimension of the base.
    ///
    /// $\partial P - P \partial = (-1)^k (\text{top} - \text{bottom})$, so that $(-1)^k P$ is a chain homotopy from bottom
    /// to top.
    pub fn matrix(&self, degree: usize) -> Option<&SparseMatrix> {
        self.matrices.get(degree)
    }

    /// The prism over a chain of the base.
    ///
    /// # Errors
    /// [`ErrorKind::NotInComplex`] if the chain has a simplex that the base has not.
    pub fn over<C: Coefficient>(&self, chain: &Chain<C>) -> Result<Chain<C>, Error> {
        let degree = chain.degree();
        let Some(matrix) = self.matrix(degree).filter(|_| !chain.is_zero()) else {
            return Ok(Chain::zero(degree + 1));
        };
        let mut terms = Vec::new();
        for (cell, coefficient) in chain.terms() {
            if cell.index() >= matrix.column_count() {
                let message = format!("there is no simplex {cell} of dimension {degree} under the prism");
                return Err(Error::new(ErrorKind::NotInComplex, message));
            }
            let column = matrix.column(cell.index());
            terms.extend(column.iter().map(|(row, x)| (CellId::new(row), coefficient.times_integer(x))));
        }
        Chain::new(&self.chain_complex, degree + 1, terms)
    }
}

fn index_in(complex: &FrozenComplex, simplex: &[u32]) -> u32 {
    complex.index_of(simplex).expect("the prism has all faces of its windows") as u32
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_algebra::Integer;
    use proptest::prelude::*;
    use std::collections::BTreeMap;

    /// A formal sum of simplices by their rising vertices.
    type Sum = BTreeMap<Vec<u32>, i64>;

    fn add(sum: &mut Sum, mut simplex: Vec<u32>, coefficient: i64) {
        let sign = super::super::signed_simplices::sort_with_sign(&mut simplex);
        let own = sum.entry(simplex.clone()).or_default();
        *own += coefficient * i64::from(sign.to_i32());
        if *own == 0 {
            sum.remove(&simplex);
        }
    }

    fn boundary(of: &Sum) -> Sum {
        let mut sum = Sum::new();
        for (simplex, coefficient) in of {
            for i in 0..simplex.len() {
                let mut facet = simplex.clone();
                facet.remove(i);
                if !facet.is_empty() {
                    add(&mut sum, facet, if i % 2 == 0 { *coefficient } else { -coefficient });
                }
            }
        }
        sum
    }

    fn over(of: &Sum, shift: u32) -> Sum {
        let mut sum = Sum::new();
        for (simplex, coefficient) in of {
            for (sign, window) in prism(simplex, shift).unwrap() {
                add(&mut sum, window, coefficient * i64::from(sign.to_i32()));
            }
        }
        sum
    }

    fn minus(a: &Sum, b: &Sum) -> Sum {
        let mut sum = a.clone();
        b.iter().for_each(|(simplex, coefficient)| add(&mut sum, simplex.clone(), -coefficient));
        sum
    }

    fn moved(of: &Sum, shift: u32) -> Sum {
        of.iter().map(|(simplex, &x)| (simplex.iter().map(|v| v + shift).collect(), x)).collect()
    }

    fn check(chain: &Sum, dimension: usize, shift: u32) {
        let sides = minus(&boundary(&over(chain, shift)), &over(&boundary(chain), shift));
        let ends = minus(&moved(chain, shift), chain);
        let expected = if dimension.is_multiple_of(2) { ends } else { minus(&Sum::new(), &ends) };
        assert_eq!(sides, expected);
    }

    #[test]
    fn the_boundary_of_a_prism_is_its_sides_and_ends() {
        for d in 0..7u32 {
            check(&Sum::from([((0..=d).collect(), 1)]), d as usize, d + 1);
        }
    }

    fn random_chains() -> impl Strategy<Value = (usize, Sum)> {
        (0usize..5).prop_flat_map(|d| {
            let simplex = prop::collection::btree_set(0u32..12, d + 1);
            let terms = prop::collection::btree_map(simplex, -3i64..4, 0..10);
            terms.prop_map(move |terms| {
                let chain = terms.into_iter().filter(|&(_, x)| x != 0);
                (d, chain.map(|(simplex, x)| (simplex.into_iter().collect(), x)).collect())
            })
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        #[test]
        fn prisms_over_chains_are_products((dimension, chain) in random_chains(), more in 0u32..9) {
            check(&chain, dimension, 12 + more);
        }

        #[test]
        fn the_prism_is_a_chain_homotopy(lists in prop::collection::vec(prop::collection::btree_set(0u32..9, 1..5), 0..8)) {
            let lists: Vec<Vec<u32>> = lists.into_iter().map(|list| list.into_iter().collect()).collect();
            let base = FrozenComplex::from_facets(&RaggedArray::from_lists(lists)).unwrap();
            let own = base.chain_complex().unwrap();
            let prism = Prism::new(&base).unwrap();
            prism.complex().check().unwrap();
            prop_assert_eq!(prism.chain_complex().unwrap().euler_characteristic(), own.euler_characteristic());
            for degree in 0..own.degree_count() {
                for cell in (0..own.cell_count(degree)).map(CellId::new) {
                    let chain = Chain::new(&own, degree, [(cell, Integer::ONE)]).unwrap();
                    let around = prism.chain_complex().unwrap().boundary(&prism.over(&chain).unwrap()).unwrap();
                    let mut ends = prism.top().image(&chain).unwrap().minus(&prism.bottom().image(&chain).unwrap()).unwrap();
                    if degree % 2 == 1 {
                        ends = ends.negated();
                    }
                    let sides = if degree == 0 { Chain::zero(0) } else { prism.over(&own.boundary(&chain).unwrap()).unwrap() };
                    prop_assert_eq!(around, sides.plus(&ends).unwrap());
                }
            }
        }
    }

    #[test]
    fn copies_need_numbers_of_their_own() {
        assert_eq!(prism(&[0, 5], 5).unwrap_err().kind(), ErrorKind::InvalidInput);
        assert_eq!(prism(&[0, 1 << 31], (1 << 31) + 1).unwrap_err().kind(), ErrorKind::TooLarge);
        assert_eq!(prism(&[], 1).unwrap_err().kind(), ErrorKind::InvalidInput);
        assert_eq!(prism(&[3], 4).unwrap(), [(Sign::Plus, vec![3, 7])]);
        let far = FrozenComplex::from_facets(&RaggedArray::from_lists([[0, u32::MAX]])).unwrap();
        assert_eq!(Prism::new(&far).unwrap_err().kind(), ErrorKind::TooLarge);
        let none = Prism::new(&FrozenComplex::default()).unwrap();
        assert!(none.complex().is_empty() && none.matrix(0).is_none());
    }
}
