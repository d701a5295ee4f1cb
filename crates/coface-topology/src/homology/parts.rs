//! Homology and its generators from a complex in parts.

use crate::homology::abelian_group::AbelianGroup;
use crate::homology::adapted_basis::{AdaptedBasis, adapted_bases};
use crate::homology::basis::to_chain;
use crate::homology::class::Generator;
use crate::homology::computation::{Homology, homology};
use coface_algebra::Error;
use coface_algebra::chains::{
    ChainById, ChainComplex, PartTree, Partition, Parts, SettledParts, WideComplex,
};
use coface_algebra::{Integer, SparseVector, WideMatrix};

/// The integral homology of a complex in parts, where no cycles are asked for: classes are counted as soon as they are found, and forgotten.
///
/// # Errors
/// What [`SettledParts::new`] says.
///
/// # Complexity
/// As of [`SettledParts::new`], and the Smith normal forms of what is left at the root.
///
/// # Examples
/// ```
/// use coface_algebra::chains::Partition;
/// use coface_complexes::known_spaces::klein_grid;
/// use coface_topology::homology_of_parts;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let bottle = klein_grid(6, 6)?.chain_complex()?;
/// let found = homology_of_parts(&Partition::by_walk(&bottle, 5)?, 2)?;
/// assert_eq!(found.groups()[1].to_string(), "Z + Z/2");
/// # Ok(()) }
/// ```
pub fn homology_of_parts<P: Parts>(parts: &P, fan_in: u32) -> Result<Homology, Error> {
    let found = SettledParts::new(parts, fan_in)?;
    let left = homology(found.root());
    let groups = found.settled().iter().enumerate().map(|(degree, settled)| {
        let group = left.groups().get(degree);
        let torsion = group.map_or(Vec::new(), |group| group.torsion().to_vec());
        AbelianGroup::new(group.map_or(0, AbelianGroup::betti) + settled, torsion)
    });
    Ok(Homology::from_groups(groups.collect()))
}

/// Cycles on the cells of a complex whose classes generate its integral homology, found at the root of its tree of
/// parts and taken down to the cells. Orders and counts are those of [`generators`](crate::homology::generators); the
/// cycles are not made short.
///
/// # Errors
/// What [`PartTree::inclusions`] says.
///
/// # Complexity
/// Smith transforms of what is left at the root, and one matching of each part on the way of a cycle.
///
/// # Examples
/// ```
/// use coface_algebra::chains::{PartTree, Partition};
/// use coface_complexes::known_spaces::klein_grid;
/// use coface_topology::generators_of_parts;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let bottle = klein_grid(6, 6)?.chain_complex()?;
/// let partition = Partition::by_walk(&bottle, 5)?;
/// let loops = &generators_of_parts(&PartTree::new(&partition, 2)?)?[1];
/// assert_eq!(loops.iter().map(|generator| generator.order().cloned()).collect::<Vec<_>>(), [Some(2.into()), None]);
/// assert!(bottle.is_cycle(loops[0].chain())?);
/// # Ok(()) }
/// ```
pub fn generators_of_parts(tree: &PartTree<'_, Partition<'_>>) -> Result<Vec<Vec<Generator>>, Error> {
    let complex: &ChainComplex = tree.parts().complex();
    let generators =
        reduced_generators(tree.root().complex()).into_iter().enumerate().map(|(degree, found)| {
            let (orders, chains): (Vec<_>, Vec<_>) = found.into_iter().unzip();
            let images = tree.inclusions(degree, &chains)?;
            let generator = |(order, image): (Option<Integer>, ChainById)| {
                // The ids of a partition are the numbers of cells.
                let image: SparseVector = image.into_iter().map(|(id, x)| (id as u32, x)).collect();
                Generator { order, chain: to_chain(complex, degree, image) }
            };
            Ok(orders.into_iter().zip(images).map(generator).collect())
        });
    generators.collect()
}

/// Cycles of a small complex whose classes generate its homology in each degree, with their orders; those of finite
/// order first.
pub fn reduced_generators(complex: &WideComplex) -> Vec<Vec<(Option<Integer>, SparseVector)>> {
    let matrix = |degree: usize| match complex.boundary_matrix(degree) {
        Some(matrix) => matrix.clone(),
        None => WideMatrix::from_integer_columns(complex.cell_count(degree - 1), [])
            .expect("an empty matrix fits"),
    };
    let bases = adapted_bases(complex.cell_count(0), complex.degree_count(), matrix);
    let of_basis = |basis: &AdaptedBasis| {
        let positions = basis.generators();
        positions.map(|position| (basis.order(position).cloned(), basis.elements[position].clone())).collect()
    };
    bases.iter().map(of_basis).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::homology::basis::HomologyBasis;
    use coface_algebra::samples::random_complexes;
    use coface_complexes::known_spaces as spaces;
    use proptest::prelude::*;

    /// Checks everything that must hold of a complex in parts.
    fn check(complex: &ChainComplex, partition: &Partition<'_>, fan_in: u32) {
        let tree = PartTree::new(partition, fan_in).unwrap();
        assert_eq!(homology(tree.root().complex()), homology(complex));
        assert_eq!(homology_of_parts(partition, fan_in).unwrap(), homology(complex));
        // Each cell is own to one part, and pairs cancel in neighboring degrees.
        let own = (0..partition.part_count()).map(|number| partition.part(number).unwrap().own_counts());
        let mut total = vec![0; complex.degree_count()];
        own.for_each(|counts| counts.iter().enumerate().for_each(|(degree, count)| total[degree] += count));
        assert_eq!(total, complex.f_vector());
        for counts in tree.critical_counts() {
            let signed =
                counts.iter().enumerate().map(|(k, &n)| if k % 2 == 0 { n as i64 } else { -(n as i64) });
            assert_eq!(signed.sum::<i64>(), complex.euler_characteristic());
        }
        // Generators are cycles of the orders that there must be, and a basis: no combination that should not bound
        // does.
        let basis = HomologyBasis::unshortened(complex);
        for (degree, generators) in generators_of_parts(&tree).unwrap().iter().enumerate() {
            let orders: Vec<Option<Integer>> = generators.iter().map(|g| g.order().cloned()).collect();
            assert_eq!(orders, basis.orders(degree));
            let rows: Vec<Vec<Integer>> = generators
                .iter()
                .map(|generator| basis.class_of(generator.chain()).unwrap().coefficients().to_vec())
                .collect();
            let free: Vec<usize> = (0..orders.len()).filter(|&i| orders[i].is_none()).collect();
            let minor: Vec<Vec<Integer>> =
                free.iter().map(|&i| free.iter().map(|&j| rows[i][j].clone()).collect()).collect();
            let columns = minor.iter().map(|row| (0..).zip(row.iter().cloned()).collect());
            let factors = coface_algebra::invariant_factors(
                &WideMatrix::from_integer_columns(free.len(), columns).unwrap(),
            );
            assert_eq!(factors, vec![Integer::ONE; free.len()], "the free parts are a basis");
        }
    }

    proptest! {
        #[test]
        fn parts_have_the_homology_of_the_whole(
            complex in random_complexes(),
            owners in prop::collection::vec(0u32..5, 40),
            fan_in in 2u32..4,
        ) {
            let owner = |degree: usize, cell: u32| owners[(degree * 17 + cell as usize) % owners.len()];
            check(&complex, &Partition::new(&complex, 5, owner).unwrap(), fan_in);
            for part_count in [1, 3] {
                check(&complex, &Partition::by_walk(&complex, part_count).unwrap(), fan_in);
            }
        }
    }

    /// Spaces with torsion in 1, 2, 7, 64 parts, with random owners, and with one maximal cell in each part.
    #[test]
    fn torsion_comes_through() {
        let spaces = [
            spaces::klein_grid(7, 6),
            spaces::projective_plane(),
            spaces::real_projective_space(3),
            spaces::lens_space(5, 2),
            spaces::moore_space(6),
            spaces::torus_grid(&[4, 4, 4]),
        ];
        for space in spaces {
            let complex = space.unwrap().chain_complex().unwrap();
            for part_count in [1, 2, 7, 64] {
                check(&complex, &Partition::by_walk(&complex, part_count).unwrap(), 2);
                let owner = |_: usize, cell: u32| (cell.wrapping_mul(2_654_435_761) >> 7) % part_count;
                check(&complex, &Partition::new(&complex, part_count, owner).unwrap(), 8);
            }
            let count = complex.cell_count(complex.degree_count() - 1) as u32;
            check(&complex, &Partition::new(&complex, count, |_, cell| cell).unwrap(), 4);
        }
    }

    #[test]
    fn complexes_without_cells_have_parts() {
        check(&ChainComplex::of_points(0), &Partition::by_walk(&ChainComplex::of_points(0), 3).unwrap(), 2);
        check(&ChainComplex::of_points(5), &Partition::by_walk(&ChainComplex::of_points(5), 3).unwrap(), 2);
    }

    /// Incidences beyond 64 bits at the merge: the disks of each part double coefficients many times.
    #[test]
    fn wide_incidences_go_through_merges() {
        let steps = 130;
        let entries = (0..steps).flat_map(|i| [(i, i, 1), (i + 1, i, -2)]).chain([(0, steps, 1)]);
        let complex = ChainComplex::new(vec![
            coface_algebra::SparseMatrix::zero(1, steps + 1).unwrap(),
            coface_algebra::SparseMatrix::from_entries(steps + 1, steps + 1, entries).unwrap(),
        ])
        .unwrap();
        let partition = Partition::new(&complex, 2, |_, cell| u32::from(cell >= 66)).unwrap();
        check(&complex, &partition, 2);
    }
}
