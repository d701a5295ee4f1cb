//! Extended persistence of a function on a complex.

use super::{Filtration, persistence};
use crate::homology::Coefficients;
use coface_algebra::chains::ChainComplex;
use coface_algebra::progress::stage;
use coface_algebra::{CellId, Error, SparseMatrix};

/// How a class of extended persistence is born and dies.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum ExtendedKind {
    /// Born and dead as sublevel sets grow.
    Ordinary,
    /// A class of the whole complex: born in a sublevel set, and dead relative to a superlevel set of no lower value.
    ExtendedPlus,
    /// A class of the whole complex that dies relative to a superlevel set of a lower value than the one at which it is born.
    ExtendedMinus,
    /// A class relative to superlevel sets: born and dead as they grow, from high values to low ones.
    Relative,
}

/// A class of extended persistence, with the cells by which it is born and dies.
///
/// # Examples
/// See [`extended_persistence`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct ExtendedPair {
    kind: ExtendedKind,
    degree: usize,
    birth: f64,
    death: f64,
    birth_cell: (usize, CellId),
    death_cell: (usize, CellId),
}

impl ExtendedPair {
    /// How the class is born and dies.
    ///
    /// # Examples
    /// See [`extended_persistence`].
    pub fn kind(&self) -> ExtendedKind {
        self.kind
    }

    /// The degree of the class; of a relative one that of relative homology.
    ///
    /// # Examples
    /// See [`extended_persistence`].
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// The value at which the class is born.
    ///
    /// # Examples
    /// See [`extended_persistence`].
    pub fn birth(&self) -> f64 {
        self.birth
    }

    /// The value at which the class dies.
    ///
    /// # Examples
    /// See [`extended_persistence`].
    pub fn death(&self) -> f64 {
        self.death
    }

    /// The cell by which the class is born, with its degree: that of the class, or of a relative class one less.
    ///
    /// # Examples
    /// See [`extended_persistence`].
    pub fn birth_cell(&self) -> (usize, CellId) {
        self.birth_cell
    }

    /// The cell by which the class dies, with its degree: one more than that of the class if it is ordinary, and else the same.
    ///
    /// # Examples
    /// See [`extended_persistence`].
    pub fn death_cell(&self) -> (usize, CellId) {
        self.death_cell
    }
}

/// The extended persistence of a function on the vertices of a complex: first the homology of growing sublevel sets, then that of the complex relative to growing
/// superlevel sets, in which every class dies. By rising degree, then by kind, birth and death.
///
/// Ordinary and relative classes of persistence 0 are left out. Extended classes are all there: there are as many as the Betti numbers say. Classes are found
/// as ordinary ones of the cone over the complex: the cone over a cell enters when the superlevel sets reach its lowest vertex.
///
/// # Errors
/// Those of [`Filtration::lower_star`] and [`persistence`]; [`ErrorKind::NotAComplex`](coface_algebra::ErrorKind::NotAComplex) where the coefficients of
/// the boundary of an edge do not add up to 0, since there is no cone over such a complex.
///
/// # Complexity
/// That of [`persistence`] of twice as many cells.
///
/// # References
/// D. Cohen-Steiner, H. Edelsbrunner, J. Harer, *Extending persistence using Poincaré and Lefschetz duality* (2009).
///
/// # Examples
/// A circle of four vertices at the heights 0, 2, 1, 3: a component from 0 to 3, a loop that is born at 3 and dies at 0, one valley and one hill.
/// ```
/// use coface_algebra::SparseMatrix;
/// use coface_algebra::chains::ChainComplex;
/// use coface_topology::{Coefficients, ExtendedKind, extended_persistence};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let ends = [(0, 1), (1, 2), (2, 3), (3, 0)];
/// let entries = ends.iter().enumerate().flat_map(|(edge, &(from, to))| [(from, edge, -1), (to, edge, 1)]);
/// let circle = ChainComplex::new(vec![SparseMatrix::from_entries(4, 4, entries)?])?;
/// let pairs = extended_persistence(&circle, &[0.0, 2.0, 1.0, 3.0], Coefficients::Modulo(2))?;
/// let found: Vec<_> = pairs.iter().map(|pair| (pair.kind(), pair.degree(), pair.birth(), pair.death())).collect();
/// assert_eq!(found, [
///     (ExtendedKind::Ordinary, 0, 1.0, 2.0),
///     (ExtendedKind::ExtendedPlus, 0, 0.0, 3.0),
///     (ExtendedKind::ExtendedMinus, 1, 3.0, 0.0),
///     (ExtendedKind::Relative, 1, 2.0, 1.0),
/// ]);
/// // The valley at vertex 2 ends with an edge at vertex 1.
/// assert_eq!((pairs[0].birth_cell().1.index(), pairs[0].death_cell().0), (2, 1));
/// # Ok(()) }
/// ```
pub fn extended_persistence(
    complex: &ChainComplex,
    vertex_values: &[f64],
    coefficients: Coefficients,
) -> Result<Vec<ExtendedPair>, Error> {
    let lower = Filtration::lower_star(complex, vertex_values)?;
    let upper = Filtration::upper_star(complex, vertex_values)?;
    let counts = complex.f_vector();
    if counts.iter().all(|&count| count == 0) {
        return Ok(Vec::new());
    }
    let (cone, filtration) = extended_filtration(complex, vertex_values)?;
    let whole = persistence(&cone, &filtration, coefficients)?;
    let place = |degree: usize, cell: CellId| -> (bool, usize, CellId) {
        let own = counts.get(degree).copied().unwrap_or(0);
        match cell.index().checked_sub(own) {
            Some(over) => (true, degree.saturating_sub(1), CellId::new(over)),
            None => (false, degree, cell),
        }
    };
    let value = |(is_over, degree, cell): (bool, usize, CellId)| {
        let values = if is_over { upper.values(degree) } else { lower.values(degree) };
        values[cell.index()]
    };
    let mut pairs = Vec::new();
    for pair in whole.pairs() {
        // The apex is the one class that stays.
        let Some(death_cell) = pair.death_cell() else { continue };
        let born = place(pair.degree(), pair.birth_cell());
        let dead = place(pair.degree() + 1, death_cell);
        let (birth, death) = (value(born), value(dead));
        let kind = match (born.0, dead.0) {
            (false, false) => ExtendedKind::Ordinary,
            (true, _) => ExtendedKind::Relative,
            _ if birth <= death => ExtendedKind::ExtendedPlus,
            _ => ExtendedKind::ExtendedMinus,
        };
        let is_short = birth == death;
        if is_short && matches!(kind, ExtendedKind::Ordinary | ExtendedKind::Relative) {
            continue;
        }
        let (birth_cell, death_cell) = ((born.1, born.2), (dead.1, dead.2));
        pairs.push(ExtendedPair { kind, degree: pair.degree(), birth, death, birth_cell, death_cell });
    }
    pairs.sort_by(|a, b| {
        let by_kind = (a.degree, a.kind).cmp(&(b.degree, b.kind));
        by_kind.then(a.birth.total_cmp(&b.birth)).then(a.death.total_cmp(&b.death))
    });
    Ok(pairs)
}

/// The cone over a complex, with the filtration whose persistence is the [extended persistence](extended_persistence) of a function on the vertices: in each
/// degree the cells of the complex, then the cones over those of the degree below; in degree 0 the apex behind the vertices. Values are steps: ranks of values
/// while sublevel sets grow, and steps that come later while superlevel sets grow. The apex comes first.
///
/// # Errors
/// Those of [`extended_persistence`].
///
/// # Complexity
/// That of sorting the values; linear in the entries of the boundary matrices.
///
/// # Examples
/// ```
/// use coface_algebra::chains::ChainComplex;
/// use coface_topology::extended_filtration;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let (cone, filtration) = extended_filtration(&ChainComplex::of_points(2), &[5.0, 7.0])?;
/// assert_eq!(cone.f_vector(), [3, 2]);
/// assert_eq!((filtration.values(0), filtration.values(1)), (&[0.0, 1.0, -1.0][..], &[4.0, 3.0][..]));
/// # Ok(()) }
/// ```
pub fn extended_filtration(
    complex: &ChainComplex,
    vertex_values: &[f64],
) -> Result<(ChainComplex, Filtration), Error> {
    let lower = Filtration::lower_star(complex, vertex_values)?;
    let upper = Filtration::upper_star(complex, vertex_values)?;
    let counts = complex.f_vector();
    let steps = stage("making the cone", 0);
    let mut values: Vec<f64> = lower.values(0).to_vec();
    values.sort_by(f64::total_cmp);
    values.dedup();
    let cone = cone(complex)?;
    let rank = |value: f64| values.partition_point(|&other| other < value) as f64;
    let last = values.len() as f64;
    let ranks = (0..cone.degree_count()).map(|degree| {
        let own: &[f64] = if degree < counts.len() { lower.values(degree) } else { &[] };
        let over: Vec<f64> = match degree.checked_sub(1) {
            Some(below) => upper.values(below).iter().map(|&value| 2.0 * last - rank(value)).collect(),
            // The apex is there from the beginning.
            None => vec![-1.0],
        };
        own.iter().map(|&value| rank(value)).chain(over).collect()
    });
    let filtration = Filtration::new(&cone, ranks.collect())?;
    drop(steps);
    Ok((cone, filtration))
}

/// The cone over a complex: in each degree its cells, then the cones over those of the degree below; in degree 0 the apex behind the vertices.
pub(super) fn cone(complex: &ChainComplex) -> Result<ChainComplex, Error> {
    let count = |degree: usize| if degree < complex.degree_count() { complex.cell_count(degree) } else { 0 };
    let matrix = |degree: usize| -> Result<SparseMatrix, Error> {
        let (own, below) = (count(degree), count(degree - 1));
        let over_below = degree.checked_sub(2).map_or(1, count);
        let mut entries: Vec<(usize, usize, i64)> = Vec::new();
        if let Some(matrix) = complex.boundary_matrix(degree) {
            for (column, cell) in matrix.columns().enumerate() {
                entries.extend(cell.iter().map(|(row, coefficient)| (row, column, i64::from(coefficient))));
            }
        }
        for cell in 0..below {
            entries.push((cell, own + cell, 1));
            if degree == 1 {
                entries.push((below, own + cell, -1));
            } else if let Some(matrix) = complex.boundary_matrix(degree - 1) {
                let faces = matrix.column(cell);
                entries.extend(
                    faces.iter().map(|(row, coefficient)| (below + row, own + cell, -i64::from(coefficient))),
                );
            }
        }
        SparseMatrix::from_entries(below + over_below, own + below, entries)
    };
    ChainComplex::new((1..=complex.degree_count()).map(matrix).collect::<Result<_, Error>>()?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_algebra::chains::ChainComplex;
    use coface_algebra::{RaggedArray, SparseMatrix};
    use coface_complexes::simplicial::FrozenComplex;
    use proptest::prelude::*;

    /// The rank over two elements.
    fn rank(mut columns: Vec<Vec<bool>>) -> usize {
        let mut rank = 0;
        let height = columns.first().map_or(0, Vec::len);
        for row in 0..height {
            let Some(pivot) = (rank..columns.len()).find(|&column| columns[column][row]) else { continue };
            columns.swap(rank, pivot);
            let pivot = columns[rank].clone();
            for column in columns.iter_mut().skip(rank + 1).filter(|column| column[row]) {
                column.iter_mut().zip(&pivot).for_each(|(a, &b)| *a ^= b);
            }
            rank += 1;
        }
        rank
    }

    /// The second method: the rank of the map from the homology of a part of the cone to that of a larger part, by ranks of boundaries alone:
    /// dim Z(part) - dim (Z(part) with B(whole)). Parts are cells with their order.
    fn persistent_rank(
        boundary: &[Vec<Vec<usize>>],
        order: &[Vec<usize>],
        degree: usize,
        from: usize,
        to: usize,
    ) -> usize {
        let there = |k: usize, bound: usize| -> Vec<usize> {
            order
                .get(k)
                .map_or(Vec::new(), |cells| (0..cells.len()).filter(|&cell| cells[cell] <= bound).collect())
        };
        let dense = |k: usize, cells: &[usize]| -> Vec<Vec<bool>> {
            let height = if k == 0 { 0 } else { order[k - 1].len() };
            let column = |&cell: &usize| {
                let mut column = vec![false; height];
                if k > 0 {
                    boundary[k - 1][cell].iter().for_each(|&face| column[face] ^= true);
                }
                column
            };
            cells.iter().map(column).collect()
        };
        let part = there(degree, from);
        let cycles = part.len() - rank(dense(degree, &part));
        // Boundaries of the larger part that lie in the smaller one: those of all, less what they are outside of it.
        let above = there(degree + 1, to);
        let boundaries = if above.is_empty() { Vec::new() } else { dense(degree + 1, &above) };
        let all = rank(boundaries.clone());
        let outside: Vec<Vec<bool>> = boundaries
            .iter()
            .map(|column| (0..column.len()).map(|face| column[face] && order[degree][face] > from).collect())
            .collect();
        cycles - (all - rank(outside))
    }

    proptest! {
        #[test]
        fn ranks_of_the_cone_are_counts_of_pairs(
            facets in prop::collection::vec(prop::collection::btree_set(0u32..5, 1..4), 1..7),
            heights in prop::collection::vec(0u8..4, 5),
        ) {
            let lists: Vec<Vec<u32>> = facets.into_iter().map(|facet| facet.into_iter().collect()).collect();
            let frozen = FrozenComplex::from_facets(&RaggedArray::from_lists(&lists)).unwrap();
            let complex = frozen.chain_complex().unwrap();
            let height = |vertex: u32| f64::from(heights[vertex as usize]);
            let values: Vec<f64> = frozen.flat(0).iter().map(|&vertex| height(vertex)).collect();
            let pairs = extended_persistence(&complex, &values, Coefficients::Modulo(2)).unwrap();
            // All simplices and their cones by hand; the step of a simplex is its height, that of a cone 7 less its lowest height, and the apex comes first.
            let dimension = frozen.dimension().unwrap();
            let tuples = |k: usize| -> Vec<&[u32]> { frozen.flat(k).chunks(k + 1).collect() };
            let mut order: Vec<Vec<usize>> = vec![Vec::new(); dimension + 2];
            let mut boundary: Vec<Vec<Vec<usize>>> = vec![Vec::new(); dimension + 1];
            for k in 0..=dimension + 1 {
                let own = if k <= dimension { tuples(k) } else { Vec::new() };
                let faces = |tuple: &[u32]| -> Vec<usize> {
                    let face = |left: usize| {
                        let mut face = tuple.to_vec();
                        face.remove(left);
                        frozen.index_of(&face).unwrap()
                    };
                    (0..tuple.len()).filter(|_| tuple.len() > 1).map(face).collect()
                };
                for tuple in &own {
                    order[k].push(tuple.iter().map(|&v| heights[v as usize] as usize).max().unwrap());
                    if k > 0 {
                        boundary[k - 1].push(faces(tuple));
                    }
                }
                if k == 0 {
                    order[0].push(0);
                    continue;
                }
                let below = tuples(k - 1);
                for (cell, tuple) in below.iter().enumerate() {
                    order[k].push(7 - tuple.iter().map(|&v| heights[v as usize] as usize).min().unwrap());
                    let over = if k == 1 { vec![below.len()] } else { faces(tuple).into_iter().map(|face| below.len() + face).collect() };
                    boundary[k - 1].push([vec![cell], over].concat());
                }
            }
            let step = |kind: ExtendedKind, value: f64, is_birth: bool| -> usize {
                let over = match kind {
                    ExtendedKind::Ordinary => false,
                    ExtendedKind::Relative => true,
                    _ => !is_birth,
                };
                if over { 7 - value as usize } else { value as usize }
            };
            for degree in 0..=dimension + 1 {
                for from in 0..8 {
                    for to in from..8 {
                        let alive = pairs.iter().filter(|pair| {
                            pair.degree() == degree
                                && step(pair.kind(), pair.birth(), true) <= from
                                && step(pair.kind(), pair.death(), false) > to
                        });
                        let apex = usize::from(degree == 0);
                        let expected = persistent_rank(&boundary, &order, degree, from, to);
                        prop_assert_eq!(alive.count() + apex, expected, "degree {} from {} to {}: {:?}", degree, from, to, &pairs);
                    }
                }
            }
            // As many extended classes as the Betti numbers say.
            let betti = crate::homology::homology(&complex);
            let extended = pairs.iter().filter(|pair| matches!(pair.kind(), ExtendedKind::ExtendedPlus | ExtendedKind::ExtendedMinus));
            let torsion_free = betti.betti_numbers().iter().sum::<usize>();
            prop_assert!(extended.count() >= torsion_free);
        }
    }

    #[test]
    fn nothing_and_one_point() {
        let nothing = ChainComplex::of_points(0);
        assert!(extended_persistence(&nothing, &[], Coefficients::Modulo(2)).unwrap().is_empty());
        let point =
            extended_persistence(&ChainComplex::of_points(1), &[5.0], Coefficients::Modulo(3)).unwrap();
        assert_eq!(
            (point.len(), point[0].kind(), point[0].birth(), point[0].death()),
            (1, ExtendedKind::ExtendedPlus, 5.0, 5.0)
        );
        let wrong = ChainComplex::new(vec![SparseMatrix::from_entries(1, 1, [(0, 0, 2)]).unwrap()]).unwrap();
        assert!(extended_persistence(&wrong, &[1.0], Coefficients::Modulo(2)).is_err());
    }
}
