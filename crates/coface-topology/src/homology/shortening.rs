//! Shorter cycles in the place of the generators of homology.

use crate::homology::basis::{HomologyBasis, length, to_vector};
use crate::homology::short_loops::exchange_loops;
use coface_algebra::chains::ChainComplex;
use coface_algebra::progress::{stage, stage_of_many};
use coface_algebra::{Integer, SparseMatrix, SparseVector, combination, linear_combination};

impl<'a> HomologyBasis<'a> {
    /// Finds the basis.
    ///
    /// Generators are made short: loops are exchanged against shorter ones of breadth-first trees while they stay a
    /// basis, cycles of any degree lose cells by adding boundaries and each other. The search is bounded by steps, and
    /// the result need not be shortest.
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
    /// assert_eq!(HomologyBasis::new(&plane).generators(1).len(), 1);
    /// # Ok(()) }
    /// ```
    pub fn new(complex: &'a ChainComplex) -> Self {
        let mut basis = Self::unshortened(complex);
        for degree in 0..complex.degree_count() {
            shorten(&mut basis, degree);
        }
        basis
    }
}

/// Makes the generators of one degree shorter, in the number of cells with multiplicity, and keeps them a basis.
///
/// Four means: cycles with large coefficients are brought near zero by a rounded least squares solution; loops of
/// breadth-first trees take the place of longer ones (degree 1); the boundary of a cell is added where that makes a
/// cycle shorter; a generator is added to or subtracted from another one.
fn shorten(basis: &mut HomologyBasis<'_>, degree: usize) {
    if degree == 0 || basis.generators(degree).is_empty() {
        return;
    }
    let steps = stage("shortening generators", 4);
    relax(basis, degree);
    steps.advance(1);
    if degree == 1 {
        exchange_loops(basis);
    }
    steps.advance(1);
    descend(basis, degree);
    steps.advance(1);
    combine(basis, degree);
}

/// Makes cycles with large coefficients small: subtracts the boundary that is nearest among real chains, rounded.
///
/// The least squares problem is solved by conjugate gradients in floating point, for the cycle divided by a power of
/// two; what is subtracted is an integral boundary, so only the size of the result depends on rounding.
fn relax(basis: &mut HomologyBasis<'_>, degree: usize) {
    /// Coefficients up to here are left to single steps.
    const SMALL: i64 = 4;
    const MOST_ROUNDS: usize = 64;
    let Some(boundaries) =
        basis.complex().boundary_matrix(degree + 1).filter(|matrix| matrix.entry_count() > 0)
    else {
        return;
    };
    for generator in 0..basis.generators(degree).len() {
        let mut cycle = to_vector(basis.generators(degree)[generator].chain());
        let mut size = largest(&cycle);
        let is_large = size > Integer::from(SMALL);
        for _ in 0..MOST_ROUNDS {
            if size <= Integer::from(SMALL) {
                break;
            }
            let nearer =
                combination(&Integer::ONE, &cycle, &Integer::from(-1), &nearest_boundary(boundaries, &cycle));
            let new_size = largest(&nearer);
            if new_size >= size {
                break;
            }
            (cycle, size) = (nearer, new_size);
        }
        if is_large {
            basis.replace_chain(degree, generator, cycle);
        }
    }
}

/// The largest absolute value of a coefficient.
fn largest(chain: &[(u32, Integer)]) -> Integer {
    chain.iter().map(|(_, x)| x.abs()).max().unwrap_or(Integer::ZERO)
}

/// An integral boundary near a cycle: the coefficients of the nearest real one, rounded.
fn nearest_boundary(boundaries: &SparseMatrix, cycle: &[(u32, Integer)]) -> SparseVector {
    /// Bits of the cycle that floating point is given.
    const BITS: usize = 40;
    const MOST_STEPS: usize = 1000;
    let shift = largest(cycle).bit_length().saturating_sub(BITS);
    let mut unit = Integer::ONE;
    for _ in 0..shift {
        unit += &unit.clone();
    }
    let mut target = vec![0.0; boundaries.row_count()];
    for (cell, x) in cycle {
        target[*cell as usize] = x.div_rem_nearest(&unit).0.to_f64();
    }
    let apply = |y: &[f64]| -> Vec<f64> {
        let mut image = vec![0.0; boundaries.row_count()];
        for (column, y) in boundaries.columns().zip(y).filter(|(_, y)| **y != 0.0) {
            column.iter().for_each(|(row, x)| image[row] += f64::from(x) * y);
        }
        image
    };
    let apply_transposed = |z: &[f64]| -> Vec<f64> {
        boundaries.columns().map(|column| column.iter().map(|(row, x)| f64::from(x) * z[row]).sum()).collect()
    };
    // Conjugate gradients on the normal equations, with the residual of the least squares problem carried along.
    let mut solution = vec![0.0; boundaries.column_count()];
    let mut residual = target;
    let mut gradient = apply_transposed(&residual);
    let mut direction = gradient.clone();
    let square = |v: &[f64]| v.iter().map(|x| x * x).sum::<f64>();
    let mut size = square(&gradient);
    let first = size;
    let steps = stage("finding the nearest boundary", MOST_STEPS);
    for _ in 0..MOST_STEPS {
        if size <= first * 1e-24 || size == 0.0 {
            break;
        }
        steps.advance(1);
        let image = apply(&direction);
        let step = size / square(&image);
        solution.iter_mut().zip(&direction).for_each(|(x, d)| *x += step * d);
        residual.iter_mut().zip(&image).for_each(|(r, q)| *r -= step * q);
        gradient = apply_transposed(&residual);
        let next = square(&gradient);
        direction.iter_mut().zip(&gradient).for_each(|(d, g)| *d = g + next / size * *d);
        size = next;
    }
    let mut terms: Vec<(Integer, SparseVector)> = Vec::new();
    for (j, y) in solution.iter().enumerate() {
        let rounded = y.round();
        // Beyond 2^62 the solution is no longer one; such a step is left out.
        if rounded != 0.0 && rounded.abs() < 4e18 {
            let column = boundaries.column(j).iter().map(|(row, x)| (row as u32, x.into())).collect();
            terms.push((&Integer::from(rounded as i64) * &unit, column));
        }
    }
    linear_combination(terms.iter().map(|(x, column)| (x, &column[..])))
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
        let steps = stage_of_many("shortening a generator", self.boundaries.column_count());
        while let Some(&cell) = queue.get(at) {
            at += 1;
            if at < self.boundaries.column_count() {
                steps.pass(at);
            } else {
                steps.advance(0);
            }
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

/// Adds generators to free ones as long as that makes one shorter. The number of passes is bounded, and so is the
/// number of generators that are compared with each other.
fn combine(basis: &mut HomologyBasis<'_>, degree: usize) {
    const MOST_GENERATORS: usize = 256;
    const MOST_PASSES: usize = 16;
    let count = basis.generators(degree).len();
    if count > MOST_GENERATORS {
        return;
    }
    let generators = basis.generators(degree).iter();
    let mut chains: Vec<SparseVector> = generators.map(|generator| to_vector(generator.chain())).collect();
    let first_free = basis.generators(degree).iter().filter(|generator| generator.order().is_some()).count();
    for _ in 0..MOST_PASSES {
        let mut is_shorter = false;
        for i in first_free..count {
            for j in (0..count).filter(|&j| j != i) {
                let Some(present) = length(&chains[i]) else { continue };
                let better = [1, -1].into_iter().find(|&sign| {
                    length_of_sum(&chains[i], sign, &chains[j]).is_some_and(|length| length < present)
                });
                let Some(sign) = better.map(Integer::from) else { continue };
                let sum = combination(&Integer::ONE, &chains[i], &sign, &chains[j]);
                let mut coefficients = vec![Integer::ZERO; count];
                (coefficients[i], coefficients[j]) = (Integer::ONE, sign);
                basis.exchange(degree, i, &coefficients, sum.clone());
                chains[i] = sum;
                is_shorter = true;
            }
        }
        if !is_shorter {
            break;
        }
    }
}

/// The length of the first chain plus `sign` times the second; `None` beyond 64 bits.
fn length_of_sum(first: &[(u32, Integer)], sign: i64, second: &[(u32, Integer)]) -> Option<u64> {
    let (mut sum, mut others) = (length(second)?, second.iter().peekable());
    for (cell, x) in first {
        while others.next_if(|(other, _)| other < cell).is_some() {}
        let x = x.to_i64()?;
        let y = match others.next_if(|(other, _)| other == cell) {
            Some((_, y)) => y.to_i64()?,
            None => 0,
        };
        let together = x.checked_add(sign.checked_mul(y)?)?;
        sum = sum.checked_add(together.unsigned_abs())?.checked_sub(y.unsigned_abs())?;
    }
    Some(sum)
}

#[cfg(test)]
mod tests {
    use crate::homology::basis::HomologyBasis;
    use coface_algebra::chains::ChainComplex;
    use coface_algebra::{Integer, SparseMatrix};
    use coface_complexes::known_spaces::torus_grid;

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
