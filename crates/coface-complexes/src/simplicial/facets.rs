//! The facets of a list of simplices, each once, and the signed boundary matrix.

use super::SignedSimplices;
use coface_algebra::{Error, ErrorKind};
use coface_algebra::{RaggedArray, Sign, SparseMatrix};
use rayon::prelude::*;

/// The facets of simplices of one dimension, each once; [`facets`] makes it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FacetTable {
    facets: RaggedArray,
    boundary: SparseMatrix,
}

/// The facets of d-simplices given as lists of vertices whose order is their orientation: the table of all facets as
/// rising lists in lexicographic order, and the boundary matrix.
///
/// $\partial [v_0, \dots, v_d] = \sum_i (-1)^i \, [v_0, \dots, \hat{v_i}, \dots, v_d]$: leave out each vertex in turn. The
/// entry of a facet is $(-1)^i$ times the sign of the permutation that sorts what is left. Simplices may repeat, and any
/// number of them may share a facet; simplices of dimension 0 have no facets.
///
/// # Errors
/// [`ErrorKind::InvalidInput`] naming the first list without a vertex or with a repeated one; [`ErrorKind::Shape`] naming the
/// first one of another dimension than list 0; [`ErrorKind::TooLarge`] for more than $2^{32} - 1$ vertices in all facets.
///
/// # Complexity
/// One pass to cut facets into buckets by their least vertices, and a sort within each bucket, in parallel.
///
/// # Examples
/// Two triangles with a common edge:
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_complexes::simplicial::facets;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let table = facets(&RaggedArray::from_lists([[0, 1, 2], [1, 2, 3]]))?;
/// assert!(table.facets().iter().eq([[0, 1], [0, 2], [1, 2], [1, 3], [2, 3]]));
/// assert_eq!(table.boundary_matrix().column(0).iter().collect::<Vec<_>>(), [(0, 1), (1, -1), (2, 1)]);
/// assert_eq!(table.boundary_matrix().column(1).iter().collect::<Vec<_>>(), [(2, 1), (3, -1), (4, 1)]);
/// # Ok(()) }
/// ```
pub fn facets(simplices: &RaggedArray) -> Result<FacetTable, Error> {
    let signed = SignedSimplices::new(simplices)?;
    let width = signed.lists().iter().next().map_or(0, <[u32]>::len);
    if let Some((i, list)) = signed.lists().iter().enumerate().find(|(_, list)| list.len() != width) {
        return Err(Error::new(
            ErrorKind::Shape,
            format!("list {i} has {} vertices, list 0 has {width}", list.len()),
        )
        .with_cure("give simplices of one dimension"));
    }
    let count = signed.len();
    if width < 2 {
        return Ok(FacetTable { facets: RaggedArray::new(), boundary: SparseMatrix::zero(0, count)? });
    }
    if (count as u64 * width as u64).checked_mul(width as u64 - 1).is_none_or(|n| u32::try_from(n).is_err()) {
        return Err(Error::new(
            ErrorKind::TooLarge,
            format!("the facets of {count} simplices of {width} vertices each have more than 2^32 - 1 vertices in all"),
        )
        .with_cure("take the facets of fewer simplices at a time"));
    }
    let faces = Faces { items: signed.lists().items(), width };
    let sorted = faces.sorted(count);
    // The facets in order, and the number of that of each face.
    let mut items: Vec<u32> = Vec::new();
    let mut numbers = vec![0u32; sorted.len()];
    let mut last: Option<u32> = None;
    for &(_, face) in &sorted {
        if last.is_none_or(|last| !faces.vertices(last).eq(faces.vertices(face))) {
            items.extend(faces.vertices(face));
            last = Some(face);
        }
        // Without a later vertex the list is less, so a column rises from its last face to its first.
        let (simplex, left_out) = (face as usize / width, face as usize % width);
        numbers[simplex * width + width - 1 - left_out] = (items.len() / (width - 1)) as u32 - 1;
    }
    let entries = signed.signs().iter().flat_map(|&sign| {
        (0..width).rev().map(move |left_out| Sign::power_of_minus_one(left_out).times(sign).to_i32())
    });
    let starts = (0..=numbers.len() as u32).step_by(width).collect();
    let facets = RaggedArray::uniform(width - 1, items)?;
    let boundary = SparseMatrix::from_parts(facets.len(), starts, numbers, entries.collect())?;
    Ok(FacetTable { facets, boundary })
}

/// The faces that are left when from each of some rising lists each vertex is left out: number `i * width + j` is list i
/// without its vertex j.
struct Faces<'a> {
    items: &'a [u32],
    width: usize,
}

impl Faces<'_> {
    /// The vertices of a face.
    fn vertices(&self, face: u32) -> impl Iterator<Item = u32> + '_ {
        let (list, left_out) = self.parts(face);
        list[..left_out].iter().chain(&list[left_out + 1..]).copied()
    }

    /// Vertex `at` of a face; 0 beyond its last one.
    fn vertex(&self, face: u32, at: usize) -> u32 {
        let (list, left_out) = self.parts(face);
        list.get(at + usize::from(at >= left_out)).copied().unwrap_or(0)
    }

    fn parts(&self, face: u32) -> (&[u32], usize) {
        let (simplex, left_out) = (face as usize / self.width, face as usize % self.width);
        (&self.items[simplex * self.width..(simplex + 1) * self.width], left_out)
    }

    /// All faces of so many lists in the order of their vertices, equal ones in the order of their numbers; each with two
    /// vertices as a key.
    fn sorted(&self, count: usize) -> Vec<(u64, u32)> {
        let total = (count * self.width) as u32;
        let bound = self.items.iter().max().map_or(0, |&last| last as usize + 1);
        // Buckets by least vertex, unless most vertex numbers are not in use.
        let buckets = if bound <= 4 * self.items.len() + 1024 {
            RaggedArray::grouped(bound, (0..total).map(|face| self.vertex(face, 0)))
        } else {
            RaggedArray::grouped(1, (0..total).map(|_| 0))
        };
        let known = usize::from(buckets.len() > 1);
        let key =
            |face: u32| u64::from(self.vertex(face, known)) << 32 | u64::from(self.vertex(face, known + 1));
        let mut sorted: Vec<(u64, u32)> = buckets.items().par_iter().map(|&face| (key(face), face)).collect();
        let mut pieces = Vec::new();
        let mut rest = sorted.as_mut_slice();
        for bucket in buckets.iter().filter(|bucket| !bucket.is_empty()) {
            let (own, after) = std::mem::take(&mut rest).split_at_mut(bucket.len());
            pieces.push(own);
            rest = after;
        }
        pieces.into_par_iter().with_min_len(64).for_each(|piece| {
            piece.sort_unstable_by(|a, b| {
                a.0.cmp(&b.0)
                    .then_with(|| {
                        // The two keys hold the first vertices.
                        let after = known + 2;
                        self.vertices(a.1).skip(after).cmp(self.vertices(b.1).skip(after))
                    })
                    .then(a.1.cmp(&b.1))
            });
        });
        sorted
    }
}

impl FacetTable {
    /// The facets as rising lists in lexicographic order.
    pub fn facets(&self) -> &RaggedArray {
        &self.facets
    }

    /// The boundary matrix: a column for each simplex, a row for each facet in its rising order.
    pub fn boundary_matrix(&self) -> &SparseMatrix {
        &self.boundary
    }

    /// The facets of exactly one simplex, in rising order, with their signs in its boundary.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{RaggedArray, Sign};
    /// use coface_complexes::simplicial::facets;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let path = facets(&RaggedArray::from_lists([[0, 1], [1, 2]]))?;
    /// let ends = path.boundary_facets();
    /// assert!(ends.lists().iter().eq([[0], [2]]));
    /// assert_eq!(ends.signs(), [Sign::Minus, Sign::Plus]);
    /// # Ok(()) }
    /// ```
    pub fn boundary_facets(&self) -> SignedSimplices {
        let mut uses = vec![0u8; self.facets.len()];
        let mut sign = vec![Sign::Plus; self.facets.len()];
        for column in self.boundary.columns() {
            for (row, entry) in column.iter() {
                uses[row] = uses[row].saturating_add(1);
                sign[row] = if entry > 0 { Sign::Plus } else { Sign::Minus };
            }
        }
        let once = (0..uses.len()).filter(|&facet| uses[facet] == 1);
        let (mut lists, mut signs) = (RaggedArray::new(), Vec::new());
        for facet in once {
            lists.push(self.facets.list(facet));
            signs.push(sign[facet]);
        }
        SignedSimplices::from_trusted(lists, signs)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simplicial::{FrozenComplex, SimplicialGrid};
    use proptest::prelude::*;
    use std::collections::BTreeMap;

    type Entries = Vec<(usize, usize, i64)>;

    /// The same by the definition, with maps.
    fn by_maps(simplices: &[Vec<u32>]) -> (Vec<Vec<u32>>, Entries) {
        let mut table: BTreeMap<Vec<u32>, Vec<(usize, i64)>> = BTreeMap::new();
        for (column, simplex) in simplices.iter().enumerate().filter(|(_, simplex)| simplex.len() > 1) {
            for i in 0..simplex.len() {
                let mut facet = simplex.clone();
                facet.remove(i);
                let inversions = (0..facet.len()).flat_map(|b| (0..b).map(move |a| (a, b)));
                let parity = i + inversions.filter(|&(a, b)| facet[a] > facet[b]).count();
                facet.sort_unstable();
                table.entry(facet).or_default().push((column, if parity % 2 == 0 { 1 } else { -1 }));
            }
        }
        let entries =
            table.values().enumerate().flat_map(|(row, own)| own.iter().map(move |&(j, x)| (row, j, x)));
        (table.keys().cloned().collect(), entries.collect())
    }

    fn lists() -> impl Strategy<Value = Vec<Vec<u32>>> {
        let pool = prop_oneof![
            Just((0..9).collect::<Vec<u32>>()),
            Just((0..9).map(|i| u32::MAX - 1000 * i).collect::<Vec<u32>>()),
        ];
        (pool, 1usize..8).prop_flat_map(|(pool, n)| {
            prop::collection::vec(prop::sample::subsequence(pool, n).prop_shuffle(), 0..12)
        })
    }

    proptest! {
        #[test]
        fn facets_follow_the_definition(lists in lists()) {
            let table = facets(&RaggedArray::from_lists(&lists)).unwrap();
            let (expected, entries) = by_maps(&lists);
            prop_assert!(table.facets().iter().eq(expected.iter()));
            let matrix = SparseMatrix::from_entries(expected.len(), lists.len(), entries.clone()).unwrap();
            prop_assert_eq!(table.boundary_matrix(), &matrix);
            let alone = table.boundary_facets();
            let uses = |row: usize| entries.iter().filter(|entry| entry.0 == row).count();
            let once: Vec<&Vec<u32>> = (0..expected.len()).filter(|&row| uses(row) == 1).map(|row| &expected[row]).collect();
            prop_assert!(alone.lists().iter().eq(once));
            // Boundary of boundary is zero.
            if lists.first().is_some_and(|list| list.len() > 2) {
                let below = facets(table.facets()).unwrap();
                prop_assert_eq!(below.boundary_matrix().first_nonzero_product_column(&matrix).unwrap(), None);
            }
        }

        #[test]
        fn rising_lists_are_those_of_the_frozen_complex(lists in prop::collection::btree_set(prop::collection::btree_set(0u32..20, 4), 1..40)) {
            let lists = RaggedArray::from_lists(lists.iter().map(|list| list.iter().copied().collect::<Vec<_>>()));
            let complex = FrozenComplex::from_facets(&lists).unwrap();
            let table = facets(&lists).unwrap();
            prop_assert_eq!(table.facets().items(), complex.flat(2));
            let chains = complex.chain_complex().unwrap();
            prop_assert_eq!(chains.boundary_matrix(3), Some(table.boundary_matrix()));
        }

        #[test]
        fn the_boundary_of_a_grid_is_known(shape in prop::collection::vec(1u32..4, 1..5)) {
            let grid = SimplicialGrid::new(&shape).unwrap();
            let signed = |simplices: &SignedSimplices| {
                let pairs = simplices.lists().iter().map(<[u32]>::to_vec).zip(simplices.signs().to_vec());
                pairs.collect::<BTreeMap<_, _>>()
            };
            let found = grid.boundary_facets().unwrap();
            let expected = facets(&grid.simplices().unwrap().to_oriented()).unwrap().boundary_facets();
            prop_assert_eq!(signed(&found), signed(&expected));
            prop_assert_eq!(found.len(), expected.len());
        }
    }

    #[test]
    fn lists_of_two_dimensions_are_refused() {
        let error = facets(&RaggedArray::from_lists(vec![vec![0, 1], vec![0, 1, 2]])).unwrap_err();
        assert_eq!(error.kind(), ErrorKind::Shape);
        assert!(error.message().contains("list 1"));
        let points = facets(&RaggedArray::from_lists([[3], [4]])).unwrap();
        assert_eq!((points.facets().len(), points.boundary_matrix().column_count()), (0, 2));
        assert!(facets(&RaggedArray::new()).unwrap().facets().is_empty());
    }
}
