//! Collapses: taking a complex down through free faces, as a certificate that it is a ball or a sphere.

use coface_algebra::SparseMatrix;
use coface_algebra::chains::ChainComplex;
use std::collections::VecDeque;

/// Which free face goes first.
#[derive(Clone, Copy, Debug)]
enum Order {
    /// The one that has been free longest: breadth first.
    Oldest,
    /// The one that became free last: depth first.
    Newest,
}

/// A complex of simplices on its way down.
struct Collapse<'a> {
    complex: &'a ChainComplex,
    coboundaries: &'a [SparseMatrix],
    alive: Vec<Vec<bool>>,
    /// How many cells one degree above still have this cell as a face.
    coface_counts: Vec<Vec<u32>>,
}

impl<'a> Collapse<'a> {
    fn new(complex: &'a ChainComplex, coboundaries: &'a [SparseMatrix]) -> Self {
        let count = |degree: usize| complex.cell_count(degree);
        let coface_counts = (0..complex.degree_count())
            .map(|degree| match coboundaries.get(degree) {
                Some(matrix) => matrix.columns().map(|column| column.rows().len() as u32).collect(),
                None => vec![0; count(degree)],
            })
            .collect();
        let alive = (0..complex.degree_count()).map(|degree| vec![true; count(degree)]).collect();
        Self { complex, coboundaries, alive, coface_counts }
    }

    fn remove(&mut self, degree: usize, cell: usize, freed: &mut VecDeque<u32>) {
        self.alive[degree][cell] = false;
        let Some(matrix) = self.complex.boundary_matrix(degree) else { return };
        for &face in matrix.column(cell).rows() {
            let count = &mut self.coface_counts[degree - 1][face as usize];
            *count -= 1;
            if *count == 1 && self.alive[degree - 1][face as usize] {
                freed.push_back(face);
            }
        }
    }

    /// Removes cells of this degree through free faces until none is left; false if some are stuck.
    fn descend(&mut self, degree: usize, order: Order) -> bool {
        let mut free: VecDeque<u32> = (0..self.complex.cell_count(degree - 1) as u32)
            .filter(|&face| {
                self.alive[degree - 1][face as usize] && self.coface_counts[degree - 1][face as usize] == 1
            })
            .collect();
        let mut left = self.alive[degree].iter().filter(|&&alive| alive).count();
        let next = |free: &mut VecDeque<u32>| match order {
            Order::Oldest => free.pop_front(),
            Order::Newest => free.pop_back(),
        };
        while let Some(face) = next(&mut free) {
            if !self.alive[degree - 1][face as usize] || self.coface_counts[degree - 1][face as usize] != 1 {
                continue;
            }
            let cofaces = self.coboundaries[degree - 1].column(face as usize);
            let cell = *cofaces
                .rows()
                .iter()
                .find(|&&cell| self.alive[degree][cell as usize])
                .expect("a free face has one coface");
            self.remove(degree, cell as usize, &mut free);
            // The face goes with the cell; its own faces lose a coface.
            let mut freed_below = VecDeque::new();
            self.remove(degree - 1, face as usize, &mut freed_below);
            left -= 1;
        }
        left == 0
    }
}

/// Whether a complex is seen to collapse to one vertex, after the open cell `removed` of the top degree has been taken
/// out if one is named. A few orders of collapse are tried; false says nothing.
fn collapses(
    complex: &ChainComplex,
    coboundaries: &[SparseMatrix],
    removed: Option<usize>,
    order: Order,
) -> bool {
    let Some(dimension) = complex.dimension() else { return false };
    let mut collapse = Collapse::new(complex, coboundaries);
    if let Some(cell) = removed {
        collapse.remove(dimension, cell, &mut VecDeque::new());
    }
    (1..=dimension).rev().all(|degree| collapse.descend(degree, order))
        && collapse.alive[0].iter().filter(|&&alive| alive).count() == 1
}

/// The most cells of the top degree that are tried as the one to take out of a sphere.
const STARTS: usize = 24;

/// Whether a closed combinatorial manifold is seen to be a sphere: without one open facet it collapses to a point.
///
/// A combinatorial manifold that collapses is a ball (J. H. C. Whitehead, *Simplicial spaces, nuclei and m-groups*, 1939);
/// so yes is a proof, and no says nothing.
pub(crate) fn is_seen_as_sphere(complex: &ChainComplex) -> bool {
    let coboundaries: Vec<SparseMatrix> =
        complex.boundary_matrices().iter().map(SparseMatrix::transpose).collect();
    let count = complex.f_vector().last().copied().unwrap_or(0);
    starts(count).any(|cell| {
        [Order::Oldest, Order::Newest]
            .into_iter()
            .any(|order| collapses(complex, &coboundaries, Some(cell), order))
    })
}

/// Whether a combinatorial manifold with boundary is seen to be a ball: it collapses to a point. Yes is a proof, and no
/// says nothing.
pub(crate) fn is_seen_as_ball(complex: &ChainComplex) -> bool {
    let coboundaries: Vec<SparseMatrix> =
        complex.boundary_matrices().iter().map(SparseMatrix::transpose).collect();
    [Order::Oldest, Order::Newest].into_iter().any(|order| collapses(complex, &coboundaries, None, order))
}

/// Up to [`STARTS`] numbers spread over `0..count`.
fn starts(count: usize) -> impl Iterator<Item = usize> {
    let tried = count.min(STARTS);
    (0..tried).map(move |i| i * count / tried)
}

#[cfg(test)]
mod tests {
    use super::super::SimplicialComplex;
    use super::*;
    use crate::known_spaces;

    fn chains(complex: Result<SimplicialComplex, coface_algebra::Error>) -> ChainComplex {
        complex.unwrap().chain_complex().unwrap()
    }

    #[test]
    fn balls_collapse_and_spheres_do_without_a_facet() {
        for n in 1..6 {
            assert!(is_seen_as_ball(&chains(known_spaces::simplex(n))));
            let sphere = chains(known_spaces::cross_polytope_boundary(n));
            assert!(is_seen_as_sphere(&sphere));
            // A closed manifold has no free face.
            assert!(!is_seen_as_ball(&sphere));
        }
    }

    /// The dunce hat is contractible, but has no free edge; the others are no spheres.
    #[test]
    fn what_does_not_collapse() {
        assert!(!is_seen_as_ball(&chains(known_spaces::dunce_hat())));
        assert!(!is_seen_as_ball(&chains(known_spaces::triangle_strip(6))));
        assert!(!is_seen_as_sphere(&chains(known_spaces::cyclic_torus(3))));
        assert!(!is_seen_as_sphere(&chains(known_spaces::lens_space(3, 1))));
        assert!(!is_seen_as_ball(&ChainComplex::of_points(2)));
        assert!(!is_seen_as_ball(&ChainComplex::of_points(0)));
    }
}
