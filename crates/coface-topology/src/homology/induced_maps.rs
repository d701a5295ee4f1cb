//! Homomorphisms between homology groups, as matrices on generators.

use crate::homology::abelian_group::AbelianGroup;
use crate::homology::basis::HomologyBasis;
use coface_algebra::Error;
use coface_algebra::chains::{Chain, ChainMap};
use coface_algebra::{Integer, SparseVector, WideMatrix, invariant_factors, smith_form_with_transforms};

/// A homomorphism between two finitely generated abelian groups, each with generators of known orders.
///
/// # Examples
/// ```
/// use coface_algebra::Integer;
/// use coface_topology::HomologyMap;
/// // Z to Z/4, the generator going to twice the generator: kernel 2 Z, cokernel Z/2.
/// let map = HomologyMap::new(vec![None], vec![Some(4.into())], vec![vec![2.into()]]);
/// assert_eq!(map.kernel().to_string(), "Z");
/// assert_eq!(map.cokernel().to_string(), "Z/2");
/// assert_eq!(map.image(&[3.into()]), [Integer::from(2)]);
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct HomologyMap {
    source_orders: Vec<Option<Integer>>,
    target_orders: Vec<Option<Integer>>,
    /// The image of each generator of the source, coefficients on the generators of the target.
    columns: Vec<Vec<Integer>>,
}

impl HomologyMap {
    /// The homomorphism that takes generator j of the source to the combination `columns[j]` of those of the target.
    /// An order `None` is infinite. Coefficients are reduced modulo the orders of the target.
    ///
    /// # Panics
    /// Unless there is a column for each generator of the source, with an entry for each of the target.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::{Coefficients, HomologyMap};
    /// // Coefficients are reduced: 6 is 2 modulo 4.
    /// let map = HomologyMap::new(vec![None], vec![Some(4.into())], vec![vec![6.into()]]);
    /// assert_eq!(map.columns(), [[2.into()]]);
    /// ```
    pub fn new(
        source_orders: Vec<Option<Integer>>,
        target_orders: Vec<Option<Integer>>,
        mut columns: Vec<Vec<Integer>>,
    ) -> Self {
        assert_eq!(columns.len(), source_orders.len(), "each generator of the source has an image");
        for column in &mut columns {
            assert_eq!(column.len(), target_orders.len(), "an image has a coefficient on each generator");
            reduce(column, &target_orders);
        }
        Self { source_orders, target_orders, columns }
    }

    /// The orders of the generators of the source; `None` is infinite.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::HomologyMap;
    /// // From Z to Z/4: the generator goes to twice the generator.
    /// let map = HomologyMap::new(vec![None], vec![Some(4.into())], vec![vec![2.into()]]);
    /// assert_eq!(map.source_orders(), [None]);
    /// ```
    pub fn source_orders(&self) -> &[Option<Integer>] {
        &self.source_orders
    }

    /// The orders of the generators of the target.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::HomologyMap;
    /// // From Z to Z/4: the generator goes to twice the generator.
    /// let map = HomologyMap::new(vec![None], vec![Some(4.into())], vec![vec![2.into()]]);
    /// assert_eq!(map.target_orders(), [Some(4.into())]);
    /// ```
    pub fn target_orders(&self) -> &[Option<Integer>] {
        &self.target_orders
    }

    /// The images of the generators of the source: one column each, coefficients on the generators of the target, from
    /// 0 to m - 1 for one of order m.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::HomologyMap;
    /// // From Z to Z/4: the generator goes to twice the generator.
    /// let map = HomologyMap::new(vec![None], vec![Some(4.into())], vec![vec![2.into()]]);
    /// assert_eq!(map.columns(), [[2.into()]]);
    /// ```
    pub fn columns(&self) -> &[Vec<Integer>] {
        &self.columns
    }

    /// The image of a combination of generators of the source.
    ///
    /// # Panics
    /// Unless there is a coefficient for each of them.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::HomologyMap;
    /// // From Z to Z/4: the generator goes to twice the generator.
    /// let map = HomologyMap::new(vec![None], vec![Some(4.into())], vec![vec![2.into()]]);
    /// assert_eq!(map.image(&[3.into()]), [2.into()]);
    /// ```
    pub fn image(&self, coefficients: &[Integer]) -> Vec<Integer> {
        assert_eq!(coefficients.len(), self.columns.len(), "a coefficient for each generator of the source");
        let mut image = vec![Integer::ZERO; self.target_orders.len()];
        for (x, column) in coefficients.iter().zip(&self.columns) {
            for (sum, y) in image.iter_mut().zip(column) {
                *sum += &(x * y);
            }
        }
        reduce(&mut image, &self.target_orders);
        image
    }

    /// This map, then another one.
    ///
    /// # Panics
    /// Unless the source of the other has as many generators as the target of this.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::HomologyMap;
    /// let double = HomologyMap::new(vec![None], vec![None], vec![vec![2.into()]]);
    /// assert_eq!(double.then(&double).columns(), [[4.into()]]);
    /// ```
    #[must_use]
    pub fn then(&self, next: &Self) -> Self {
        let columns = self.columns.iter().map(|column| next.image(column)).collect();
        Self::new(self.source_orders.clone(), next.target_orders.clone(), columns)
    }

    /// Whether every element goes to zero.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::HomologyMap;
    /// let zero = HomologyMap::new(vec![None], vec![Some(2.into())], vec![vec![4.into()]]);
    /// assert!(zero.is_zero());
    /// ```
    pub fn is_zero(&self) -> bool {
        self.columns.iter().flatten().all(Integer::is_zero)
    }

    /// The kernel, up to isomorphism.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::HomologyMap;
    /// let modulo_2 = HomologyMap::new(vec![Some(4.into())], vec![Some(2.into())], vec![vec![1.into()]]);
    /// assert_eq!(modulo_2.kernel().to_string(), "Z/2");
    /// ```
    pub fn kernel(&self) -> AbelianGroup {
        // Elements of the kernel generate it; their relations are what makes a combination a relation of the source.
        let kernel = self.kernel_elements();
        let relations = relations(&self.source_orders);
        let count = kernel.len();
        let syzygies: Vec<SparseVector> =
            kernel_of(self.source_orders.len(), &[&kernel[..], &relations].concat())
                .into_iter()
                .map(|vector| vector.into_iter().filter(|&(i, _)| (i as usize) < count).collect())
                .collect();
        group(count, &syzygies)
    }

    /// The target modulo the image, up to isomorphism.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::HomologyMap;
    /// // From Z to Z/4: the generator goes to twice the generator.
    /// let map = HomologyMap::new(vec![None], vec![Some(4.into())], vec![vec![2.into()]]);
    /// assert_eq!(map.cokernel().to_string(), "Z/2");
    /// ```
    pub fn cokernel(&self) -> AbelianGroup {
        group(self.target_orders.len(), &self.image_and_relations())
    }

    /// Whether only zero goes to zero.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::HomologyMap;
    /// let double = HomologyMap::new(vec![None], vec![None], vec![vec![2.into()]]);
    /// assert!(double.is_injective());
    /// ```
    pub fn is_injective(&self) -> bool {
        self.kernel().is_trivial()
    }

    /// Whether every element of the target is an image.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::HomologyMap;
    /// let double = HomologyMap::new(vec![None], vec![None], vec![vec![2.into()]]);
    /// assert!(!double.is_surjective());
    /// ```
    pub fn is_surjective(&self) -> bool {
        self.cokernel().is_trivial()
    }

    /// The image as a group of its own: the source modulo the kernel.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::HomologyMap;
    /// // Z to Z/4, the generator going to twice the generator.
    /// let map = HomologyMap::new(vec![None], vec![Some(4.into())], vec![vec![2.into()]]);
    /// assert_eq!(map.image_group().to_string(), "Z/2");
    /// ```
    pub fn image_group(&self) -> AbelianGroup {
        let vanishing = [relations(&self.source_orders), self.kernel_elements()].concat();
        group(self.source_orders.len(), &vanishing)
    }

    /// Whether the kernel of the next map is the image of this one.
    ///
    /// # Panics
    /// Unless the source of the next map has as many generators as the target of this.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::HomologyMap;
    /// // 0 to Z to Z to Z/2 is exact in the middle: even numbers are zero modulo 2.
    /// let double = HomologyMap::new(vec![None], vec![None], vec![vec![2.into()]]);
    /// let modulo_2 = HomologyMap::new(vec![None], vec![Some(2.into())], vec![vec![1.into()]]);
    /// assert!(double.is_exact_before(&modulo_2));
    /// ```
    pub fn is_exact_before(&self, next: &Self) -> bool {
        // The image lies in the kernel; they agree when the kernel adds nothing to the lattice of the image.
        let image = self.image_and_relations();
        let both = [&image[..], &next.kernel_elements()].concat();
        self.then(next).is_zero()
            && group(self.target_orders.len(), &image) == group(self.target_orders.len(), &both)
    }

    /// Elements of the source that generate, with its relations, the kernel.
    fn kernel_elements(&self) -> Vec<SparseVector> {
        let count = self.source_orders.len();
        kernel_of(self.target_orders.len(), &self.image_and_relations())
            .into_iter()
            .map(|vector| vector.into_iter().filter(|&(i, _)| (i as usize) < count).collect())
            .collect()
    }

    /// The images of the generators, then the relations of the target.
    fn image_and_relations(&self) -> Vec<SparseVector> {
        let images = self.columns.iter().map(|column| {
            let terms = column.iter().enumerate().filter(|(_, x)| !x.is_zero());
            terms.map(|(i, x)| (i as u32, x.clone())).collect()
        });
        images.chain(relations(&self.target_orders)).collect()
    }
}

/// The coefficients of generators of finite order, from 0 on.
fn reduce(coefficients: &mut [Integer], orders: &[Option<Integer>]) {
    for (x, order) in coefficients.iter_mut().zip(orders) {
        if let Some(order) = order {
            *x = x.div_rem_floor(order).1;
        }
    }
}

fn relations(orders: &[Option<Integer>]) -> Vec<SparseVector> {
    let finite = orders.iter().enumerate().filter_map(|(i, order)| Some((i as u32, order.clone()?)));
    finite.map(|relation| vec![relation]).collect()
}

fn matrix(row_count: usize, columns: &[SparseVector]) -> WideMatrix {
    WideMatrix::from_integer_columns(row_count, columns.to_vec())
        .expect("groups have fewer than 2^32 generators")
}

/// A basis of the integer relations between vectors.
fn kernel_of(row_count: usize, columns: &[SparseVector]) -> Vec<SparseVector> {
    let smith = smith_form_with_transforms(&matrix(row_count, columns));
    let vector = |j| smith.right().column(j).terms().map(|(i, x)| (i as u32, x.clone())).collect();
    (smith.form().rank()..columns.len()).map(vector).collect()
}

/// The group with so many generators and these relations.
fn group(generator_count: usize, relations: &[SparseVector]) -> AbelianGroup {
    let factors = invariant_factors(&matrix(generator_count, relations));
    AbelianGroup::new(generator_count - factors.len(), factors)
}

/// The homomorphisms that a chain map induces on integral homology, for each degree of the source: column j is the
/// class of the image of generator j.
///
/// # Errors
/// [`ErrorKind::NotInComplex`](coface_algebra::ErrorKind::NotInComplex) or
/// [`ErrorKind::NotACycle`](coface_algebra::ErrorKind::NotACycle) if the map is not one between the complexes of the
/// two bases.
///
/// # Complexity
/// For each generator of the source its image and the pairs that it reaches in the target.
///
/// # Examples
/// ```
/// use coface_algebra::{CellId, SparseMatrix};
/// use coface_algebra::chains::{ChainComplex, ChainMap};
/// use coface_topology::{HomologyBasis, induced_maps};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// // The inclusion of a vertex into a segment with two ends.
/// let segment = ChainComplex::new(vec![SparseMatrix::from_entries(2, 1, [(0, 0, -1), (1, 0, 1)])?])?;
/// let first = vec![vec![CellId::new(0)]];
/// let point = segment.subcomplex(&first)?;
/// let inclusion = ChainMap::inclusion(&segment, &first)?;
/// let maps = induced_maps(&inclusion, &HomologyBasis::new(&point), &HomologyBasis::new(&segment))?;
/// assert!(maps[0].is_injective() && maps[0].is_surjective());
/// # Ok(()) }
/// ```
pub fn induced_maps(
    map: &ChainMap,
    source: &HomologyBasis<'_>,
    target: &HomologyBasis<'_>,
) -> Result<Vec<HomologyMap>, Error> {
    (0..source.complex().degree_count())
        .map(|degree| map_of_generators(source, degree, target, degree, |chain| map.image(chain)))
        .collect()
}

/// The homomorphism that takes the class of each generator to the class of its image.
pub(super) fn map_of_generators(
    source: &HomologyBasis<'_>,
    degree: usize,
    target: &HomologyBasis<'_>,
    target_degree: usize,
    image: impl Fn(&Chain<Integer>) -> Result<Chain<Integer>, Error>,
) -> Result<HomologyMap, Error> {
    let columns = source.generators(degree).iter().map(|generator| {
        let class = target.class_of(&image(generator.chain())?)?;
        Ok(class.coefficients().to_vec())
    });
    let columns = columns.collect::<Result<_, Error>>()?;
    Ok(HomologyMap::new(source.orders(degree), target.orders(target_degree), columns))
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_algebra::samples::random_complexes;
    use proptest::prelude::*;

    fn order(n: i64) -> Option<Integer> {
        (n > 0).then(|| n.into())
    }

    /// All elements of a finite group, as coefficients.
    fn elements(orders: &[i64]) -> Vec<Vec<i64>> {
        orders.iter().fold(vec![Vec::new()], |list, &n| {
            list.iter().flat_map(|head| (0..n).map(move |x| [&head[..], &[x]].concat())).collect()
        })
    }

    fn finite_order(group: &AbelianGroup) -> Integer {
        assert_eq!(group.betti(), 0);
        group.torsion().iter().fold(Integer::ONE, |product, order| &product * order)
    }

    proptest! {
        /// Kernels and cokernels of maps of finite groups have the orders that counting gives.
        #[test]
        fn kernels_and_cokernels_are_counted(
            source in prop::collection::vec(1i64..7, 1..4),
            target in prop::collection::vec(1i64..7, 1..4),
            numbers in prop::collection::vec(0i64..60, 9),
        ) {
            // A generator of order m may go where m kills: to multiples of n / gcd(m, n).
            let columns: Vec<Vec<i64>> = source.iter().enumerate().map(|(j, &m)| {
                target.iter().enumerate().map(|(i, &n)| {
                    let gcd = Integer::from(m).gcd(&Integer::from(n)).to_i64().unwrap();
                    numbers[3 * j + i] * (n / gcd) % n
                }).collect()
            }).collect();
            let map = HomologyMap::new(
                source.iter().map(|&n| order(n)).collect(),
                target.iter().map(|&n| order(n)).collect(),
                columns.iter().map(|column| column.iter().map(|&x| x.into()).collect()).collect(),
            );
            let image = |element: &Vec<i64>| -> Vec<i64> {
                let all: Vec<Integer> = element.iter().map(|&x| x.into()).collect();
                map.image(&all).iter().map(|x| x.to_i64().unwrap()).collect()
            };
            let all = elements(&source);
            let kernel_size = all.iter().filter(|element| image(element).iter().all(|&x| x == 0)).count();
            let image_size = all.len() / kernel_size;
            prop_assert_eq!(finite_order(&map.kernel()), Integer::from(kernel_size as i64));
            let target_size: i64 = target.iter().product();
            prop_assert_eq!(finite_order(&map.cokernel()), Integer::from(target_size / image_size as i64));
            prop_assert_eq!(map.is_injective(), kernel_size == 1);
        }

        /// The identity induces the identity, and maps compose.
        #[test]
        fn induced_maps_are_functorial(complex in random_complexes()) {
            let basis = HomologyBasis::new(&complex);
            let identity = ChainMap::identity(&complex).unwrap();
            for (degree, map) in induced_maps(&identity, &basis, &basis).unwrap().iter().enumerate() {
                for (j, column) in map.columns().iter().enumerate() {
                    for (i, x) in column.iter().enumerate() {
                        prop_assert_eq!(x, &Integer::from(i64::from(i == j)));
                    }
                }
                prop_assert!(map.is_injective() && map.is_surjective());
                prop_assert_eq!(&map.then(map), map);
                prop_assert_eq!(map.columns().len(), basis.generators(degree).len());
            }
        }
    }
}
