//! All places where a complex is no manifold, as far as counting and gluing show them.

use super::FrozenComplex;
use super::manifold::{Cells, LinkFault, split_cells, subsets};
use coface_algebra::UnionFind;
use coface_algebra::chains::ChainComplex;

/// More pairs of a facet and a face of it than a union-find holds are not told apart.
const MOST_CORNERS: usize = 1 << 31;

/// The cells of one dimension that have one fault, in increasing order.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FaultyCells {
    fault: LinkFault,
    dimension: usize,
    cells: Vec<u32>,
}

impl FaultyCells {
    /// What is wrong with each of them.
    pub fn fault(&self) -> LinkFault {
        self.fault
    }

    /// The dimension of the cells.
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// Their numbers among the simplices of that dimension.
    pub fn cells(&self) -> &[u32] {
        &self.cells
    }
}

impl FrozenComplex {
    /// Every simplex at which the complex is seen to be no manifold, where [`Self::manifold_verdict`] names the first one: facets below the
    /// top dimension ([`LinkFault::NotPure`]), ridges in three facets or more ([`LinkFault::BranchingRidge`]), simplices around which
    /// facets form several fans ([`LinkFault::LinkNotConnected`]), and, if there are none of these, those whose link is a surface other
    /// than the sphere and the disk ([`LinkFault::LinkNotASphere`]). By fault, then by dimension from the highest down.
    ///
    /// # Panics
    /// If `chains` has other numbers of cells than this complex.
    ///
    /// # Complexity
    /// $O(2^n f \alpha(f))$ for f facets of dimension n.
    ///
    /// # Examples
    /// Two triangles that touch in a vertex, and a loose edge.
    /// ```
    /// use coface_complexes::simplicial::{LinkFault, SimplicialComplex};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let complex = SimplicialComplex::from_facets(vec![vec![0, 1, 2], vec![2, 3, 4], vec![4, 5]])?.freeze();
    /// let faults = complex.manifold_faults(&complex.chain_complex()?);
    /// assert_eq!(faults[0].fault(), LinkFault::NotPure);
    /// assert_eq!(complex.numbers(1, faults[0].cells()[0] as usize), [4, 5]);
    /// assert_eq!((faults[1].fault(), faults[1].cells()), (LinkFault::LinkNotConnected, &[2][..]));
    /// # Ok(()) }
    /// ```
    pub fn manifold_faults(&self, chains: &ChainComplex) -> Vec<FaultyCells> {
        assert_eq!(chains.f_vector(), self.f_vector(), "the chain complex is that of this complex");
        let Some(dimension) = self.dimension().filter(|&dimension| dimension > 0) else { return Vec::new() };
        let cells = Cells { complex: self, chains, dimension };
        let mut faults = Vec::new();
        let mut add = |fault, dimension, cells: Vec<u32>| {
            if !cells.is_empty() {
                faults.push(FaultyCells { fault, dimension, cells });
            }
        };
        for degree in (0..dimension).rev() {
            let is_maximal = coface_counts(chains, degree).into_iter().map(|count| count == 0);
            add(LinkFault::NotPure, degree, numbers_of(is_maximal));
        }
        let is_branching = coface_counts(chains, dimension - 1).into_iter().map(|count| count > 2);
        add(LinkFault::BranchingRidge, dimension - 1, numbers_of(is_branching));
        for codimension in 2..=dimension {
            add(LinkFault::LinkNotConnected, dimension - codimension, split_stars(&cells, codimension));
        }
        if faults.is_empty() && dimension >= 3 {
            let cells = super::manifold::bad_surface_links(&cells);
            if !cells.is_empty() {
                faults.push(FaultyCells {
                    fault: LinkFault::LinkNotASphere,
                    dimension: dimension - 3,
                    cells,
                });
            }
        }
        faults
    }
}

fn numbers_of(found: impl Iterator<Item = bool>) -> Vec<u32> {
    (0u32..).zip(found).filter(|&(_, is_found)| is_found).map(|(cell, _)| cell).collect()
}

/// In how many cells one dimension above each cell lies.
fn coface_counts(chains: &ChainComplex, degree: usize) -> Vec<u32> {
    let mut counts = vec![0u32; chains.cell_count(degree)];
    if let Some(matrix) = chains.boundary_matrix(degree + 1) {
        matrix.rows().iter().for_each(|&row| counts[row as usize] = counts[row as usize].saturating_add(1));
    }
    counts
}

/// The simplices of a codimension around which the facets, neighbors where they share a ridge that contains the simplex, form several
/// parts.
fn split_stars(cells: &Cells<'_>, codimension: usize) -> Vec<u32> {
    let n = cells.dimension;
    let corners = subsets(n + 1, codimension);
    let width = corners.len();
    if cells.facet_count().saturating_mul(width) >= MOST_CORNERS {
        return Vec::new();
    }
    let corner = |facet: usize, left_out: &[usize]| {
        let place = corners.binary_search_by(|choice| choice.as_slice().cmp(left_out));
        (facet * width + place.expect("all choices of positions are listed")) as u32
    };
    // The first facet at each ridge, with the position that is left out: later ones are united with it.
    let mut first_at = vec![None; cells.chains.cell_count(n - 1)];
    let mut parts = UnionFind::new(cells.facet_count() * width);
    let of_ridge = subsets(n, codimension - 1);
    let with = |choice: &[usize], position: usize| {
        let shifted = choice.iter().map(|&i| if i < position { i } else { i + 1 });
        let mut left_out: Vec<usize> = shifted.chain([position]).collect();
        left_out.sort_unstable();
        left_out
    };
    for facet in 0..cells.facet_count() {
        for position in 0..=n {
            let ridge = cells.face(n, facet, position);
            match first_at[ridge] {
                None => first_at[ridge] = Some((facet, position)),
                Some((first, at)) => {
                    for choice in &of_ridge {
                        parts.unite(corner(facet, &with(choice, position)), corner(first, &with(choice, at)));
                    }
                }
            }
        }
    }
    numbers_of(split_cells(cells, &corners, n - codimension, &mut parts).into_iter())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::known_spaces;
    use crate::simplicial::SimplicialComplex;

    fn faults(complex: &SimplicialComplex) -> Vec<(LinkFault, usize, usize)> {
        let frozen = complex.freeze();
        let found = frozen.manifold_faults(&frozen.chain_complex().unwrap());
        found.iter().map(|group| (group.fault(), group.dimension(), group.cells().len())).collect()
    }

    #[test]
    fn manifolds_have_none() {
        for complex in [
            known_spaces::cyclic_torus(3).unwrap(),
            known_spaces::simplex(4).unwrap(),
            known_spaces::complex_projective_plane().unwrap(),
            known_spaces::circle(5).unwrap(),
        ] {
            assert_eq!(faults(&complex), []);
        }
    }

    /// In a 3-dimensional complex: a loose edge, a loose point, a triangle in three tetrahedra, two tetrahedra that share an edge
    /// only, and two that share a vertex only.
    #[test]
    fn every_fault_is_named() {
        let complex = SimplicialComplex::from_facets(vec![
            vec![0, 1, 2, 3],
            vec![0, 1, 2, 4],
            vec![0, 1, 2, 5],
            vec![3, 10, 11, 12],
            vec![10, 11, 13, 14],
            vec![20, 21],
            vec![30],
        ])
        .unwrap();
        assert_eq!(
            faults(&complex),
            [
                (LinkFault::NotPure, 1, 1),
                (LinkFault::NotPure, 0, 1),
                (LinkFault::BranchingRidge, 2, 1),
                (LinkFault::LinkNotConnected, 1, 1),
                (LinkFault::LinkNotConnected, 0, 3),
            ]
        );
        let torus = known_spaces::cyclic_torus(2).unwrap();
        assert_eq!(faults(&torus.suspension().unwrap().0), [(LinkFault::LinkNotASphere, 0, 2)]);
    }
}
