//! Persistence of a pair: relative to a subcomplex, and of the image of its homology.

use super::reduction::{Level, NONE, prime};
use super::{Filtration, PersistenceDiagram, PersistencePair, persistence};
use crate::homology::Coefficients;
use coface_algebra::chains::ChainComplex;
use coface_algebra::{Binary, CellId, Error, Field, Odd};

/// The persistent homology of a filtered complex relative to a part of it: that of the chains of the cells that have entered, modulo those of the part.
///
/// `part` lists for each degree the cells of the part, with all their faces. Cells of pairs have their numbers in the whole complex.
///
/// # Errors
/// Those of [`persistence`], and of [`ChainComplex::subcomplex`] if the cells are no subcomplex.
///
/// # Complexity
/// That of [`persistence`] of the cells outside of the part.
///
/// # Examples
/// A path of heights 0, 2, 1 relative to its first vertex: the component of that vertex is none, and the other one dies at the top.
/// ```
/// use coface_algebra::{CellId, SparseMatrix};
/// use coface_algebra::chains::ChainComplex;
/// use coface_topology::{Coefficients, Filtration, relative_persistence};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let edges = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1)])?;
/// let path = ChainComplex::new(vec![edges])?;
/// let filtration = Filtration::lower_star(&path, &[0.0, 2.0, 1.0])?;
/// let first = [vec![CellId::new(0)]];
/// let diagram = relative_persistence(&path, &filtration, &first, Coefficients::Modulo(2))?.longer_than(0.0);
/// let found: Vec<_> = diagram.pairs().iter().map(|pair| (pair.degree(), pair.birth(), pair.death())).collect();
/// assert_eq!(found, [(0, 1.0, Some(2.0))]);
/// assert_eq!(diagram.pairs()[0].birth_cell(), CellId::new(2));
/// # Ok(()) }
/// ```
pub fn relative_persistence(
    complex: &ChainComplex,
    filtration: &Filtration,
    part: &[Vec<CellId>],
    coefficients: Coefficients,
) -> Result<PersistenceDiagram, Error> {
    filtration.check(complex)?;
    let kept = complex.complement(part)?;
    let chains = complex.relative(part)?;
    Ok(persistence(&chains, &filtration.restricted(&kept), coefficients)?.with_cells(&kept))
}

/// The persistent homology of a part of a filtered complex as it is seen in the whole: of the images of the homology of what has entered of the part, in the
/// homology of all that has entered.
///
/// A class is born by a cell of the part, and dies when it bounds in the whole, by a cell of the part or not. `part` is as for [`relative_persistence`]. The
/// number of essential classes of a degree is the rank of the map from the homology of the part to that of the whole.
///
/// Coboundaries of the whole are reduced, those of cells outside of the part first: they are what relative persistence needs. Cells of the part that kill a
/// class of the part, and cells outside that kill a relative one, bring none.
///
/// # Errors
/// As [`relative_persistence`].
///
/// # Complexity
/// That of [`persistence`] of the whole and of the part.
///
/// # References
/// D. Cohen-Steiner, H. Edelsbrunner, J. Harer, D. Morozov, *Persistent homology for kernels, images, and cokernels* (2009); U. Bauer, M. Schmahl,
/// *Efficient computation of image persistence* (2022).
///
/// # Examples
/// The rim of a triangle is a loop from 1 on by itself; in the triangle, which enters at 5, it bounds.
/// ```
/// use coface_algebra::{CellId, SparseMatrix};
/// use coface_algebra::chains::ChainComplex;
/// use coface_topology::{Coefficients, Filtration, image_persistence};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let edges = [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1), (0, 2, -1), (2, 2, 1)];
/// let triangle = ChainComplex::new(vec![
///     SparseMatrix::from_entries(3, 3, edges)?,
///     SparseMatrix::from_entries(3, 1, [(0, 0, 1), (1, 0, 1), (2, 0, -1)])?,
/// ])?;
/// let filtration = Filtration::new(&triangle, vec![vec![0.0; 3], vec![1.0; 3], vec![5.0]])?;
/// let rim = vec![(0..3).map(CellId::new).collect(); 2];
/// let diagram = image_persistence(&triangle, &filtration, &rim, Coefficients::Modulo(3))?;
/// let loops = diagram.pairs_of_degree(1);
/// assert_eq!((loops.len(), loops[0].birth(), loops[0].death()), (1, 1.0, Some(5.0)));
/// assert_eq!(diagram.betti_numbers(), [1, 0, 0]);
/// # Ok(()) }
/// ```
pub fn image_persistence(
    complex: &ChainComplex,
    filtration: &Filtration,
    part: &[Vec<CellId>],
    coefficients: Coefficients,
) -> Result<PersistenceDiagram, Error> {
    let prime = prime(coefficients)?;
    filtration.check(complex)?;
    // By rising numbers, a list for each degree.
    let inside = complex.complement(&complex.complement(part)?)?;
    let chains = complex.subcomplex(&inside)?;
    let own = persistence(&chains, &filtration.restricted(&inside), coefficients)?.with_cells(&inside);
    let degrees = match prime {
        2 => image(&Binary, complex, filtration, &inside, &own),
        _ => image(&Odd::new(prime), complex, filtration, &inside, &own),
    };
    Ok(PersistenceDiagram::new(prime, filtration.is_falling(), degrees))
}

/// The pairs of the image by degree; `own` is the diagram of the part.
fn image<F: Field>(
    field: &F,
    complex: &ChainComplex,
    filtration: &Filtration,
    inside: &[Vec<CellId>],
    own: &PersistenceDiagram,
) -> Vec<Vec<PersistencePair>> {
    let mut degrees = Vec::with_capacity(complex.degree_count());
    // Whether a cell outside of the part kills a relative class of the degree below.
    let mut is_relative_death = vec![false; complex.f_vector().first().copied().unwrap_or(0)];
    for (degree, part) in inside.iter().enumerate() {
        let entrance = filtration.entrance(degree);
        let mut is_inside = vec![false; entrance.len()];
        part.iter().for_each(|cell| is_inside[cell.index()] = true);
        // The cells of the part, then the others, each in the order of entrance.
        let there = entrance.iter().copied().filter(|&cell| is_inside[cell as usize]);
        let faces: Vec<u32> =
            there.chain(entrance.iter().copied().filter(|&cell| !is_inside[cell as usize])).collect();
        let mut brings_none = vec![false; entrance.len()];
        for cell in part {
            brings_none[cell.index()] = true;
        }
        let births = if degree < own.degree_count() { own.pairs_of_degree(degree) } else { &[] };
        for pair in births {
            brings_none[pair.birth_cell().index()] = false;
        }
        let is_zero: Vec<bool> = faces
            .iter()
            .map(|&cell| brings_none[cell as usize] || is_relative_death[cell as usize])
            .collect();
        let cells = filtration.entrance(degree + 1);
        let partner = match complex.boundary_matrix(degree + 1) {
            None => Vec::new(),
            Some(matrix) => {
                let level = Level { field, matrix, cells, faces: &faces };
                let merged = if degree == 0 { level.merge(|_, _| ()) } else { None };
                merged
                    .unwrap_or_else(|| level.reduce(&is_zero, |_| true).expect("units of a field are leads"))
            }
        };
        let mut killer = vec![NONE; part.len()];
        is_relative_death = vec![false; cells.len()];
        for (&cell, &face) in cells.iter().zip(&partner).filter(|&(_, &face)| face != NONE) {
            match killer.get_mut(face as usize) {
                Some(killer) => *killer = cell,
                None => is_relative_death[cell as usize] = true,
            }
        }
        let pair = |(place, killer): (usize, u32)| {
            let death = (killer != NONE).then_some(killer);
            PersistencePair::new(filtration, degree, faces[place], death)
        };
        degrees
            .push(killer.into_iter().enumerate().filter(|&(place, _)| !is_zero[place]).map(pair).collect());
    }
    degrees
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_algebra::RaggedArray;
    use coface_complexes::simplicial::FrozenComplex;
    use proptest::prelude::*;

    /// The rank of dense columns over the field of p elements.
    fn rank(mut columns: Vec<Vec<i64>>, p: i64) -> usize {
        let mut rank = 0;
        let height = columns.first().map_or(0, Vec::len);
        for row in 0..height {
            let Some(pivot) = (rank..columns.len()).find(|&column| columns[column][row] != 0) else {
                continue;
            };
            columns.swap(rank, pivot);
            let pivot = columns[rank].clone();
            let inverse = (1..p).find(|x| (x * pivot[row]).rem_euclid(p) == 1).unwrap();
            for column in columns.iter_mut().skip(rank + 1).filter(|column| column[row] != 0) {
                let factor = column[row] * inverse;
                column.iter_mut().zip(&pivot).for_each(|(a, &b)| *a = (*a - factor * b).rem_euclid(p));
            }
            rank += 1;
        }
        rank
    }

    /// The boundaries of some cells of a degree, with the faces that are asked for alone.
    fn boundaries(
        complex: &ChainComplex,
        degree: usize,
        p: i64,
        cell: impl Fn(usize) -> bool,
        face: impl Fn(usize) -> bool,
    ) -> Vec<Vec<i64>> {
        let Some(matrix) = complex.boundary_matrix(degree) else { return Vec::new() };
        let dense = |number: usize| {
            let mut column = vec![0; matrix.row_count()];
            for (row, entry) in matrix.column(number).iter().filter(|&(row, _)| face(row)) {
                column[row] = i64::from(entry).rem_euclid(p);
            }
            column
        };
        (0..matrix.column_count()).filter(|&number| cell(number)).map(dense).collect()
    }

    /// The second method: the rank of the map from the homology of some cells to that of more, both modulo what `is_seen` leaves out: cycles of the first, less
    /// the boundaries of the second that lie in the first.
    fn map_rank(
        complex: &ChainComplex,
        (degree, p): (usize, i64),
        first: impl Fn(usize, usize) -> bool,
        second: impl Fn(usize, usize) -> bool,
        is_seen: impl Fn(usize, usize) -> bool,
    ) -> usize {
        let count = (0..complex.cell_count(degree)).filter(|&cell| first(degree, cell)).count();
        let of_first = boundaries(
            complex,
            degree,
            p,
            |cell| first(degree, cell),
            |face| is_seen(degree.wrapping_sub(1), face),
        );
        let above = |is_face: &dyn Fn(usize) -> bool| {
            rank(boundaries(complex, degree + 1, p, |cell| second(degree + 1, cell), is_face), p)
        };
        let all = above(&|face| is_seen(degree, face));
        let outside = above(&|face| is_seen(degree, face) && !first(degree, face));
        count - rank(of_first, p) - (all - outside)
    }

    /// A complex, values that rise by steps on cofaces, and a part.
    fn case(
        facets: &[Vec<u32>],
        steps: &[u8],
        chosen: &[bool],
    ) -> (ChainComplex, Vec<Vec<f64>>, Vec<Vec<CellId>>) {
        let complex =
            FrozenComplex::from_facets(&RaggedArray::from_lists(facets)).unwrap().chain_complex().unwrap();
        let mut step = steps.iter().cycle();
        let mut values: Vec<Vec<f64>> = Vec::new();
        let mut is_chosen = chosen.iter().cycle();
        let mut members: Vec<Vec<bool>> = complex
            .f_vector()
            .iter()
            .map(|&count| (0..count).map(|_| *is_chosen.next().unwrap()).collect())
            .collect();
        for degree in 0..complex.degree_count() {
            let value = |cell: usize| {
                let faces =
                    complex.boundary_matrix(degree).map_or(&[][..], |matrix| matrix.column(cell).rows());
                let least = faces.iter().map(|&face| values[degree - 1][face as usize]).fold(0.0, f64::max);
                least + f64::from(*step.next().unwrap())
            };
            let level = (0..complex.cell_count(degree)).map(value).collect();
            values.push(level);
        }
        for degree in (1..complex.degree_count()).rev() {
            let matrix = complex.boundary_matrix(degree).unwrap();
            for cell in (0..members[degree].len()).filter(|&cell| members[degree][cell]).collect::<Vec<_>>() {
                matrix.column(cell).rows().iter().for_each(|&face| members[degree - 1][face as usize] = true);
            }
        }
        let listed = |level: &Vec<bool>| (0..level.len()).filter(|&i| level[i]).map(CellId::new).collect();
        (complex, values, members.iter().map(listed).collect())
    }

    /// How many classes of a degree are born by one value and still live at another.
    fn alive(diagram: &PersistenceDiagram, degree: usize, from: f64, to: f64) -> usize {
        let is_alive =
            |pair: &&PersistencePair| pair.birth() <= from && pair.death().is_none_or(|death| death > to);
        // What is left of points without any of them has no degrees.
        if degree < diagram.degree_count() {
            diagram.pairs_of_degree(degree).iter().filter(is_alive).count()
        } else {
            0
        }
    }

    proptest! {
        #[test]
        fn ranks_of_maps_of_pairs_are_counts_of_classes(
            facets in prop::collection::vec(prop::collection::btree_set(0u32..6, 1..5), 1..8),
            steps in prop::collection::vec(0u8..3, 1..40),
            chosen in prop::collection::vec(prop::bool::weighted(0.35), 1..40),
            p in prop::sample::select(vec![2_i64, 3, 5]),
        ) {
            let facets: Vec<Vec<u32>> = facets.into_iter().map(|facet| facet.into_iter().collect()).collect();
            let (complex, values, part) = case(&facets, &steps, &chosen);
            let filtration = Filtration::new(&complex, values.clone()).unwrap();
            let field = Coefficients::Modulo(p as u64);
            let relative = relative_persistence(&complex, &filtration, &part, field).unwrap();
            let image = image_persistence(&complex, &filtration, &part, field).unwrap();
            let mut all: Vec<f64> = values.concat();
            all.sort_by(f64::total_cmp);
            all.dedup();
            let is_part = |degree: usize, cell: usize| part.get(degree).is_some_and(|level| level.contains(&CellId::new(cell)));
            for degree in 0..complex.degree_count() {
                for (place, &from) in all.iter().enumerate() {
                    for &to in &all[place..] {
                        let by = |value: f64| { let values = &values; move |degree: usize, cell: usize| values[degree][cell] <= value };
                        let (by_from, by_to) = (by(from), by(to));
                        let outside = |k: usize, cell: usize| !is_part(k, cell);
                        let expected = map_rank(
                            &complex, (degree, p),
                            |k, cell| by_from(k, cell) && outside(k, cell), |k, cell| by_to(k, cell) && outside(k, cell), outside,
                        );
                        prop_assert_eq!(alive(&relative, degree, from, to), expected, "relative, degree {} from {} to {}", degree, from, to);
                        let expected = map_rank(
                            &complex, (degree, p), |k, cell| by_from(k, cell) && is_part(k, cell), by_to, |_, _| true,
                        );
                        prop_assert_eq!(alive(&image, degree, from, to), expected, "image, degree {} from {} to {}", degree, from, to);
                    }
                }
            }
            for pair in image.pairs() {
                prop_assert!(is_part(pair.degree(), pair.birth_cell().index()));
            }
        }
    }

    #[test]
    fn nothing_and_everything() {
        let facets = vec![vec![0, 1, 2], vec![2, 3]];
        let (complex, values, _) = case(&facets, &[1, 0, 2], &[false]);
        let filtration = Filtration::new(&complex, values).unwrap();
        let field = Coefficients::Modulo(2);
        let whole = persistence(&complex, &filtration, field).unwrap();
        let every: Vec<Vec<CellId>> =
            complex.f_vector().iter().map(|&count| (0..count).map(CellId::new).collect()).collect();
        assert_eq!(relative_persistence(&complex, &filtration, &[], field).unwrap(), whole);
        assert_eq!(image_persistence(&complex, &filtration, &every, field).unwrap(), whole);
        assert!(relative_persistence(&complex, &filtration, &every, field).unwrap().pairs().is_empty());
        assert!(image_persistence(&complex, &filtration, &[], field).unwrap().pairs().is_empty());
        let empty = ChainComplex::of_points(0);
        let none = Filtration::lower_star(&empty, &[]).unwrap();
        assert!(image_persistence(&empty, &none, &[], field).unwrap().pairs().is_empty());
        // An edge without its ends is no part.
        let edge = [vec![], vec![CellId::new(0)]];
        assert!(image_persistence(&complex, &filtration, &edge, field).is_err());
        assert!(relative_persistence(&complex, &filtration, &edge, field).is_err());
    }

    #[test]
    fn values_that_fall() {
        // A path of three vertices, and its ends: they are joined when the middle enters.
        let (path, _, _) = case(&[vec![0, 1], vec![1, 2]], &[0], &[false]);
        let filtration = Filtration::upper_star(&path, &[3.0, 1.0, 2.0]).unwrap();
        let ends = [vec![CellId::new(0), CellId::new(2)]];
        let diagram = image_persistence(&path, &filtration, &ends, Coefficients::Modulo(2)).unwrap();
        let found: Vec<_> = diagram.pairs().iter().map(|pair| (pair.birth(), pair.death())).collect();
        assert_eq!(found, [(3.0, None), (2.0, Some(1.0))]);
        let diagram = relative_persistence(&path, &filtration, &ends, Coefficients::Modulo(2)).unwrap();
        let found: Vec<_> = diagram
            .longer_than(0.0)
            .pairs()
            .iter()
            .map(|pair| (pair.degree(), pair.birth(), pair.death()))
            .collect();
        assert_eq!(found, [(1, 1.0, None)]);
    }
}
