//! Shorter cycles in the place of the generators of homology.

use super::HomologyBasis;
use super::basis::to_vector;
use super::short_loops::exchange_loops;
use crate::algebra::{Integer, SparseMatrix, SparseVector, combination};

/// Makes the generators of one degree shorter, in the number of cells with multiplicity, and keeps them a basis.
///
/// Three means: loops of breadth-first trees take the place of longer ones (degree 1); the boundary of a cell is added
/// where that makes a cycle shorter; a generator is added to or subtracted from another one. Cycles whose coefficients
/// do not fit in 64 bits stay as they are.
pub(super) fn shorten(basis: &mut HomologyBasis<'_>, degree: usize) {
    if degree == 0 || basis.generators(degree).is_empty() {
        return;
    }
    if degree == 1 {
        exchange_loops(basis);
    }
    descend(basis, degree);
    combine(basis, degree);
}

/// The sum of the absolute values; `None` beyond 64 bits.
pub(super) fn length(chain: &[(u32, Integer)]) -> Option<u64> {
    chain.iter().try_fold(0u64, |sum, (_, x)| sum.checked_add(x.to_i64()?.unsigned_abs()))
}

/// Adds boundaries of single cells as long as that makes cycles shorter.
fn descend(basis: &mut HomologyBasis<'_>, degree: usize) {
    let Some(boundaries) =
        basis.complex().boundary_matrix(degree + 1).filter(|matrix| matrix.entry_count() > 0)
    else {
        return;
    };
    let cofaces = boundaries.transpose();
    let mut descent = Descent {
        boundaries,
        cofaces: &cofaces,
        values: vec![0; boundaries.row_count()],
        is_waiting: vec![false; boundaries.column_count()],
    };
    let shorter: Vec<Option<SparseVector>> =
        basis.generators(degree).iter().map(|generator| descent.run(&to_vector(generator.chain()))).collect();
    for (generator, chain) in shorter.into_iter().enumerate() {
        if let Some(chain) = chain {
            basis.replace_chain(degree, generator, chain);
        }
    }
}

struct Descent<'m> {
    boundaries: &'m SparseMatrix,
    cofaces: &'m SparseMatrix,
    /// The coefficients of the cycle at hand; zero between runs.
    values: Vec<i64>,
    is_waiting: Vec<bool>,
}

impl Descent<'_> {
    /// A shorter homologous cycle, if one is found.
    fn run(&mut self, cycle: &[(u32, Integer)]) -> Option<SparseVector> {
        length(cycle)?;
        let mut queue = Vec::new();
        let mut touched: Vec<u32> = cycle.iter().map(|&(cell, _)| cell).collect();
        for (cell, x) in cycle {
            self.values[*cell as usize] = x.to_i64().unwrap_or_default();
            self.offer_cofaces(*cell as usize, &mut queue);
        }
        let (mut at, mut is_shorter) = (0, false);
        while let Some(&cell) = queue.get(at) {
            at += 1;
            self.is_waiting[cell as usize] = false;
            let Some(factor) = self.best_factor(cell) else { continue };
            is_shorter = true;
            for (face, incidence) in self.boundaries.column(cell as usize).iter() {
                self.values[face] += factor * i64::from(incidence);
                touched.push(face as u32);
                self.offer_cofaces(face, &mut queue);
            }
        }
        touched.sort_unstable();
        touched.dedup();
        let mut shorter = SparseVector::new();
        for cell in touched {
            let value = std::mem::take(&mut self.values[cell as usize]);
            if value != 0 {
                shorter.push((cell, value.into()));
            }
        }
        is_shorter.then_some(shorter)
    }

    fn offer_cofaces(&mut self, cell: usize, queue: &mut Vec<u32>) {
        for &coface in self.cofaces.column(cell).rows() {
            if !std::mem::replace(&mut self.is_waiting[coface as usize], true) {
                queue.push(coface);
            }
        }
    }

    /// 1 or -1, if adding that multiple of the boundary of the cell makes the cycle shorter.
    fn best_factor(&self, cell: u32) -> Option<i64> {
        let change = |factor: i64| {
            self.boundaries.column(cell as usize).iter().try_fold(0i64, |sum, (face, incidence)| {
                let value = self.values[face];
                let new = value.checked_add(factor * i64::from(incidence))?;
                sum.checked_add(new.checked_abs()?)?.checked_sub(value.checked_abs()?)
            })
        };
        [1, -1].into_iter().find(|&factor| change(factor).is_some_and(|change| change < 0))
    }
}

/// Adds generators to each other as long as that makes one shorter. The number of passes is bounded, and so is the number
/// of generators that are compared with each other.
fn combine(basis: &mut HomologyBasis<'_>, degree: usize) {
    const MOST_GENERATORS: usize = 256;
    const MOST_PASSES: usize = 16;
    let count = basis.generators(degree).len();
    if count > MOST_GENERATORS {
        return;
    }
    let is_free = |basis: &HomologyBasis<'_>, i: usize| basis.generators(degree)[i].order().is_none();
    let mut chains: Vec<SparseVector> =
        basis.generators(degree).iter().map(|generator| to_vector(generator.chain())).collect();
    for _ in 0..MOST_PASSES {
        let mut is_shorter = false;
        for i in (0..count).filter(|&i| is_free(basis, i)).collect::<Vec<_>>() {
            for j in (0..count).filter(|&j| j != i) {
                let Some(present) = length(&chains[i]) else { continue };
                for sign in [1, -1].map(Integer::from) {
                    let sum = combination(&Integer::ONE, &chains[i], &sign, &chains[j]);
                    if length(&sum).is_some_and(|length| length < present) {
                        let mut coefficients = vec![Integer::ZERO; count];
                        coefficients[i] = Integer::ONE;
                        coefficients[j] = sign;
                        basis.exchange(degree, i, &coefficients, sum.clone());
                        chains[i] = sum;
                        is_shorter = true;
                        break;
                    }
                }
            }
        }
        if !is_shorter {
            break;
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::algebra::{Integer, SparseMatrix};
    use crate::chains::ChainComplex;
    use crate::simplicial::known_spaces::torus_grid;
    use crate::topology::HomologyBasis;

    /// The loops of a torus of 6 by 9 squares cut by diagonals go around in 6 and 9 steps, or 9 along diagonals.
    #[test]
    fn loops_of_a_torus_are_as_short_as_they_can_be() {
        let torus = torus_grid(&[6, 9]).unwrap().chain_complex().unwrap();
        let basis = HomologyBasis::new(&torus);
        let mut lengths: Vec<i64> =
            basis.generators(1).iter().map(|g| g.length().to_i64().unwrap()).collect();
        lengths.sort_unstable();
        assert_eq!(lengths, [6, 9]);
        let longer = HomologyBasis::unshortened(&torus);
        assert_eq!(longer.homology(), basis.homology());
    }

    /// The 2-dimensional classes of a 3-torus are tori: 3 x 4 squares and so on, two triangles each.
    #[test]
    fn surfaces_in_a_three_torus_are_flattened() {
        let torus = torus_grid(&[3, 4, 5]).unwrap().chain_complex().unwrap();
        let basis = HomologyBasis::new(&torus);
        let mut areas: Vec<i64> = basis.generators(2).iter().map(|g| g.length().to_i64().unwrap()).collect();
        areas.sort_unstable();
        assert!(areas.iter().zip([24, 30, 40]).all(|(&area, least)| area >= least), "{areas:?}");
        assert!(areas.iter().sum::<i64>() <= 2 * (24 + 30 + 40), "{areas:?}");
    }

    /// A shorter multiple of a torsion class must not take its place: the generator stays one.
    #[test]
    fn torsion_generators_stay_generators() {
        // One vertex, one loop a of order 5 with a disk along 5a.
        let complex = ChainComplex::new(vec![
            SparseMatrix::zero(1, 2).unwrap(),
            SparseMatrix::from_entries(2, 2, [(0, 0, 5), (0, 1, 2), (1, 1, -1)]).unwrap(),
        ])
        .unwrap();
        let basis = HomologyBasis::new(&complex);
        let generator = &basis.generators(1)[0];
        assert_eq!((generator.order(), generator.length()), (Some(&Integer::from(5)), Integer::ONE));
    }
}
