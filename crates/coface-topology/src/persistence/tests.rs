//! Persistence against a second method, and what its theory promises.

use super::*;
use crate::homology::{Coefficients, homology_with};
use coface_algebra::ErrorKind;
use coface_algebra::SparseMatrix;
use coface_algebra::chains::ChainComplex;
use coface_algebra::samples::random_complexes;
use proptest::prelude::*;

/// Values made monotone: each cell has the largest of its own number and those of its faces.
fn filtration(complex: &ChainComplex, numbers: &[f64]) -> Filtration {
    let mut source = numbers.iter().cycle();
    let mut values: Vec<Vec<f64>> = Vec::new();
    for degree in 0..complex.degree_count() {
        let level = (0..complex.cell_count(degree)).map(|cell| {
            let own = *source.next().unwrap();
            let faces = complex.boundary_matrix(degree).map_or(&[][..], |matrix| matrix.column(cell).rows());
            faces.iter().map(|&face| values[degree - 1][face as usize]).fold(own, f64::max)
        });
        values.push(level.collect());
    }
    Filtration::new(complex, values).unwrap()
}

/// The second method: the textbook's reduction of one dense matrix, columns from left to right, on all cells in the
/// order (value, degree, id). Gives (degree, cell of birth, cell of death).
fn by_dense_columns(
    complex: &ChainComplex,
    filtration: &Filtration,
    p: i64,
) -> Vec<(usize, usize, Option<usize>)> {
    let mut order: Vec<(usize, usize)> =
        (0..complex.degree_count()).flat_map(|k| (0..complex.cell_count(k)).map(move |c| (k, c))).collect();
    let value = |(degree, cell): (usize, usize)| filtration.values(degree)[cell];
    order.sort_by(|&a, &b| value(a).total_cmp(&value(b)).then(a.cmp(&b)));
    let at = |degree, cell| order.iter().position(|&other| other == (degree, cell)).unwrap();
    let mut columns: Vec<Vec<i64>> = Vec::new();
    let mut pairs = Vec::new();
    let mut killed = vec![false; order.len()];
    for &(degree, cell) in &order {
        let mut column = vec![0; order.len()];
        if let Some(matrix) = complex.boundary_matrix(degree) {
            for (face, entry) in matrix.column(cell).iter() {
                column[at(degree - 1, face)] = i64::from(entry).rem_euclid(p);
            }
        }
        let low = |column: &[i64]| column.iter().rposition(|&x| x != 0);
        while let Some(pivot) = low(&column)
            && let Some(other) = columns.iter().find(|other| low(other) == Some(pivot))
        {
            let inverse = (1..p).find(|x| x * other[pivot] % p == 1).unwrap();
            let factor = column[pivot] * inverse % p;
            column.iter_mut().zip(other).for_each(|(x, y)| *x = (*x - factor * y).rem_euclid(p));
        }
        if let Some(pivot) = low(&column) {
            killed[pivot] = true;
            killed[columns.len()] = true;
            pairs.push((order[pivot].0, order[pivot].1, Some(cell)));
        }
        columns.push(column);
    }
    let essential = order.iter().zip(&killed).filter(|&(_, &killed)| !killed);
    pairs.extend(essential.map(|(&(degree, cell), _)| (degree, cell, None)));
    pairs.sort_unstable();
    pairs
}

/// The points off the diagonal, as numbers that can be sorted.
fn points(diagram: &PersistenceDiagram) -> Vec<(usize, String)> {
    let mut points: Vec<_> = diagram
        .longer_than(0.0)
        .pairs()
        .iter()
        .map(|pair| (pair.degree(), format!("{:?} {:?}", pair.birth(), pair.death())))
        .collect();
    points.sort();
    points
}

fn modulo(p: i64) -> Coefficients {
    Coefficients::Modulo(p as u64)
}

fn numbers() -> impl Strategy<Value = Vec<f64>> {
    prop::collection::vec((-4i8..5).prop_map(f64::from), 1..60)
}

fn primes() -> impl Strategy<Value = i64> {
    prop::sample::select(vec![2, 3, 5, 31])
}

/// Whether two finite diagrams can be matched, points with points or with the diagonal, so that nothing moves farther
/// than `distance`: Kuhn's algorithm on the points of both sides and their places on the diagonal.
fn are_within(a: &[(f64, f64)], b: &[(f64, f64)], distance: f64) -> bool {
    let near = |i: usize, j: usize| match (a.get(i), b.get(j)) {
        (Some(x), Some(y)) => (x.0 - y.0).abs().max((x.1 - y.1).abs()) <= distance,
        (Some(x), None) | (None, Some(x)) => x.1 - x.0 <= 2.0 * distance,
        (None, None) => true,
    };
    let total = a.len() + b.len();
    let mut partner: Vec<Option<usize>> = vec![None; total];
    fn augment(
        i: usize,
        near: &dyn Fn(usize, usize) -> bool,
        partner: &mut [Option<usize>],
        seen: &mut [bool],
    ) -> bool {
        (0..partner.len()).any(|j| {
            if seen[j] || !near(i, j) {
                return false;
            }
            seen[j] = true;
            let is_free = partner[j].is_none_or(|other| augment(other, near, partner, seen));
            if is_free {
                partner[j] = Some(i);
            }
            is_free
        })
    }
    (0..total).all(|i| augment(i, &near, &mut partner, &mut vec![false; total]))
}

proptest! {
    #[test]
    fn reduction_agrees_with_dense_columns(complex in random_complexes(), numbers in numbers(), p in primes()) {
        let filtration = filtration(&complex, &numbers);
        let diagram = persistence(&complex, &filtration, modulo(p)).unwrap();
        let mut pairs: Vec<_> = diagram
            .pairs()
            .iter()
            .map(|pair| (pair.degree(), pair.birth_cell().index(), pair.death_cell().map(|cell| cell.index())))
            .collect();
        pairs.sort_unstable();
        prop_assert_eq!(pairs, by_dense_columns(&complex, &filtration, p));
        for pair in diagram.pairs() {
            prop_assert_eq!(pair.birth(), filtration.values(pair.degree())[pair.birth_cell().index()]);
            prop_assert!(pair.death().is_none_or(|death| death >= pair.birth()));
        }
    }

    #[test]
    fn essential_classes_are_homology(complex in random_complexes(), numbers in numbers(), p in primes()) {
        let diagram = persistence(&complex, &filtration(&complex, &numbers), modulo(p)).unwrap();
        prop_assert_eq!(diagram.betti_numbers(), homology_with(&complex, modulo(p)).betti_numbers());
        // Every cell is in one pair, a pair of two cells or an essential class.
        let essential: usize = diagram.betti_numbers().iter().sum();
        prop_assert_eq!(2 * diagram.pairs().len() - essential, complex.f_vector().iter().sum::<usize>());
    }

    /// Cells in reverse order, and each with the other orientation at random: the same points off the diagonal.
    #[test]
    fn the_diagram_does_not_see_numbers_and_orientations(
        complex in random_complexes(), numbers in numbers(), p in primes(), flips in any::<u64>(),
    ) {
        let values = filtration(&complex, &numbers);
        let count = |k: usize| complex.cell_count(k);
        let sign = |k: usize, cell: usize| if flips.rotate_left((11 * k + cell) as u32) & 1 == 1 { -1 } else { 1 };
        let matrices = (1..complex.degree_count()).map(|k| {
            let entries = complex.boundary_matrix(k).unwrap().columns().enumerate().flat_map(|(j, column)| {
                column.iter().map(move |(i, x)| (i, j, i64::from(x))).collect::<Vec<_>>()
            });
            let entries = entries.map(|(i, j, x)| (count(k - 1) - 1 - i, count(k) - 1 - j, x * sign(k, j) * sign(k - 1, i)));
            SparseMatrix::from_entries(count(k - 1), count(k), entries).unwrap()
        });
        let other = ChainComplex::new(matrices.collect()).unwrap();
        let reversed = (0..complex.degree_count()).map(|k| values.values(k).iter().rev().copied().collect());
        let reversed = Filtration::new(&other, reversed.collect()).unwrap();
        prop_assert_eq!(
            points(&persistence(&complex, &values, modulo(p)).unwrap()),
            points(&persistence(&other, &reversed, modulo(p)).unwrap())
        );
    }

    /// D. Cohen-Steiner, H. Edelsbrunner, J. Harer, *Stability of persistence diagrams* (2007): the bottleneck distance
    /// is at most the largest change of a value.
    #[test]
    fn diagrams_are_stable(
        complex in random_complexes(), numbers in numbers(), shifts in prop::collection::vec(-1.0f64..1.0, 60),
    ) {
        let moved: Vec<f64> = numbers.iter().zip(&shifts).map(|(x, shift)| x + shift).collect();
        let of_degree = |numbers: &[f64], degree: usize| -> Vec<(f64, f64)> {
            let diagram = persistence(&complex, &filtration(&complex, numbers), modulo(2)).unwrap();
            // Essential classes die far beyond everything, in both diagrams at one value.
            let pairs = diagram.longer_than(0.0);
            pairs.pairs_of_degree(degree).iter().map(|pair| (pair.birth(), pair.death().unwrap_or(1000.0))).collect()
        };
        let change = numbers.iter().zip(&moved).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
        for degree in 0..complex.degree_count() {
            let (a, b) = (of_degree(&numbers, degree), of_degree(&moved, degree));
            prop_assert!(are_within(&a, &b, change + 1e-12), "{a:?} {b:?} {change}");
        }
    }

    #[test]
    fn an_upper_star_is_the_lower_star_of_the_opposite(complex in random_complexes(), numbers in numbers(), p in primes()) {
        let values: Vec<f64> = (0..complex.cell_count(0)).map(|v| numbers[v % numbers.len()]).collect();
        let opposite: Vec<f64> = values.iter().map(|value| -value).collect();
        let falling = persistence(&complex, &Filtration::upper_star(&complex, &values).unwrap(), modulo(p)).unwrap();
        let rising = persistence(&complex, &Filtration::lower_star(&complex, &opposite).unwrap(), modulo(p)).unwrap();
        prop_assert_eq!(falling.pairs().len(), rising.pairs().len());
        for (a, b) in falling.pairs().iter().zip(rising.pairs()) {
            prop_assert_eq!((a.birth_cell(), a.death_cell()), (b.birth_cell(), b.death_cell()));
            prop_assert_eq!((-a.birth(), a.death().map(|x| -x)), (b.birth(), b.death()));
            prop_assert_eq!(a.persistence(), b.persistence());
        }
        prop_assert!(falling.is_falling() && !rising.is_falling());
    }
}

/// A circle with heights 0, 3, 1, 2 around: the valley at 1 dies at the lower pass, 2; the loop closes at 3.
#[test]
fn a_circle_has_a_valley_and_a_loop() {
    let ends = [(0, 1), (1, 2), (2, 3), (3, 0)];
    let entries = ends.iter().enumerate().flat_map(|(edge, &(a, b))| [(a, edge, -1), (b, edge, 1)]);
    let circle = ChainComplex::new(vec![SparseMatrix::from_entries(4, 4, entries).unwrap()]).unwrap();
    let filtration = Filtration::lower_star(&circle, &[0.0, 3.0, 1.0, 2.0]).unwrap();
    let diagram = persistence(&circle, &filtration, modulo(2)).unwrap().longer_than(0.0);
    let found: Vec<_> =
        diagram.pairs().iter().map(|pair| (pair.degree(), pair.birth(), pair.death())).collect();
    assert_eq!(found, [(0, 0.0, None), (0, 1.0, Some(2.0)), (1, 3.0, None)]);
    assert_eq!(diagram.longer_than(1.0).pairs().len(), 2, "the pair of persistence 1 goes");
    assert_eq!(diagram.pairs_of_degree(1)[0].birth_cell().index(), 1);
    assert!(diagram.pairs_of_degree(7).is_empty());
}

/// One vertex, one loop, one disk that runs twice along it: over two elements three essential classes, over others the
/// disk kills the loop.
#[test]
fn a_disk_that_runs_twice_along_its_rim() {
    let plane = ChainComplex::new(vec![
        SparseMatrix::zero(1, 1).unwrap(),
        SparseMatrix::from_entries(1, 1, [(0, 0, 2)]).unwrap(),
    ])
    .unwrap();
    let filtration = Filtration::new(&plane, vec![vec![0.0], vec![1.0], vec![4.0]]).unwrap();
    assert_eq!(persistence(&plane, &filtration, modulo(2)).unwrap().betti_numbers(), [1, 1, 1]);
    for p in [3, 2_147_483_647] {
        let diagram = persistence(&plane, &filtration, modulo(p)).unwrap();
        assert_eq!(diagram.betti_numbers(), [1, 0, 0]);
        assert_eq!(diagram.pairs()[1].persistence(), 3.0);
        assert_eq!(diagram.prime(), p as u32);
    }
}

#[test]
fn fields_and_complexes_that_do_not_fit_are_refused() {
    let points = ChainComplex::of_points(2);
    let filtration = Filtration::lower_star(&points, &[0.0, 1.0]).unwrap();
    for ring in
        [Coefficients::Integers, Coefficients::Rationals, modulo(4), modulo(1 << 31), modulo(4_294_967_311)]
    {
        assert_eq!(persistence(&points, &filtration, ring).unwrap_err().kind(), ErrorKind::Coefficient);
    }
    let other = ChainComplex::of_points(3);
    assert_eq!(persistence(&other, &filtration, modulo(2)).unwrap_err().kind(), ErrorKind::Shape);
    let empty = ChainComplex::of_points(0);
    let nothing = Filtration::lower_star(&empty, &[]).unwrap();
    assert!(persistence(&empty, &nothing, modulo(2)).unwrap().pairs().is_empty());
}
