//! Harmonic cochains against dense eigenvectors, exact homology, and what the theory promises.

use super::*;
use crate::homology::{Coefficients, HomologyBasis, generators, homology, homology_with};
use coface_algebra::SparseMatrix;
use coface_algebra::chains::{ChainComplex, Cochain};
use coface_algebra::samples::random_complexes;
use coface_algebra::{CellId, ErrorKind};
use coface_complexes::known_spaces;
use coface_complexes::simplicial::SimplicialComplex;
use proptest::prelude::*;

/// What rounding may leave, relative to numbers of size 1.
const TOLERANCE: f64 = 1e-9;

/// Weights between 1/2 and 2 from a source of numbers.
fn weights(complex: &ChainComplex, source: &[f64]) -> Vec<Vec<f64>> {
    let mut source = source.iter().cycle();
    let mut level = |&count: &usize| (0..count).map(|_| 2f64.powf(*source.next().unwrap())).collect();
    complex.f_vector().iter().map(&mut level).collect()
}

fn cochain(complex: &ChainComplex, degree: usize, source: &[f64]) -> Cochain<f64> {
    let values = (0..complex.cell_count(degree)).map(|cell| (CellId::new(cell), source[cell % source.len()]));
    Cochain::new(complex, degree, values).unwrap()
}

fn value(cochain: &Cochain<f64>, cell: usize) -> f64 {
    cochain.coefficient(CellId::new(cell)).copied().unwrap_or(0.0)
}

fn distance(metric: &MetricComplex<'_>, a: &Cochain<f64>, b: &Cochain<f64>) -> f64 {
    metric.norm(&a.minus(b).unwrap()).unwrap()
}

/// Eigenvalues with orthonormal eigenvectors, by plane rotations (Jacobi): a second method beside the tridiagonal one.
fn eigenvectors(mut matrix: Vec<Vec<f64>>) -> Vec<(f64, Vec<f64>)> {
    let count = matrix.len();
    // Row i of `vectors` is rotated as row i of the matrix is.
    let mut vectors: Vec<Vec<f64>> =
        (0..count).map(|i| (0..count).map(|j| f64::from(u8::from(i == j))).collect()).collect();
    for _ in 0..50 {
        for p in 0..count {
            for q in p + 1..count {
                if matrix[p][q] == 0.0 {
                    continue;
                }
                let (sine, cosine) =
                    (0.5 * (2.0 * matrix[p][q]).atan2(matrix[q][q] - matrix[p][p])).sin_cos();
                for row in &mut matrix {
                    (row[p], row[q]) = (cosine * row[p] - sine * row[q], sine * row[p] + cosine * row[q]);
                }
                for list in [&mut matrix, &mut vectors] {
                    let (upper, lower) = list.split_at_mut(q);
                    for (x, y) in upper[p].iter_mut().zip(&mut lower[0]) {
                        (*x, *y) = (cosine * *x - sine * *y, sine * *x + cosine * *y);
                    }
                }
            }
        }
        let off = |i: usize| matrix[i].iter().enumerate().filter(move |&(j, _)| j != i).map(|(_, x)| x * x);
        if (0..count).flat_map(off).sum::<f64>() < 1e-26 {
            break;
        }
    }
    vectors.into_iter().enumerate().map(|(i, vector)| (matrix[i][i], vector)).collect()
}

#[test]
fn spectra_are_those_of_rotations() {
    for (name, space) in known() {
        let complex = space.chain_complex().unwrap();
        let metric = MetricComplex::new(&complex);
        for degree in (0..complex.degree_count()).filter(|&degree| complex.cell_count(degree) < 60) {
            let spectrum = metric.laplacian_spectrum(degree).unwrap();
            let mut expected: Vec<f64> =
                eigenvectors(metric.symmetric_laplacian(degree)).into_iter().map(|(x, _)| x).collect();
            expected.sort_by(f64::total_cmp);
            let largest = expected.last().copied().unwrap_or(0.0);
            for (x, y) in spectrum.iter().zip(&expected) {
                assert!((x - y).abs() <= 1e-12 * (1.0 + largest), "{name}: {spectrum:?} {expected:?}");
            }
        }
    }
}

/// The harmonic part by the second method: the eigenvectors of the dense Laplacian whose eigenvalue is zero.
fn harmonic_part_by_eigenvectors(metric: &MetricComplex<'_>, cochain: &Cochain<f64>) -> Cochain<f64> {
    let degree = cochain.degree();
    let roots: Vec<f64> = metric.weights(degree).iter().map(|weight| weight.sqrt()).collect();
    let values: Vec<f64> =
        metric.dense(cochain).unwrap().iter().zip(&roots).map(|(x, root)| x * root).collect();
    if values.is_empty() {
        return Cochain::zero(degree);
    }
    let mut sum = vec![0.0; values.len()];
    for (_, vector) in eigenvectors(metric.symmetric_laplacian(degree)).iter().filter(|(x, _)| *x < 1e-8) {
        let factor: f64 = vector.iter().zip(&values).map(|(u, x)| u * x).sum();
        sum.iter_mut().zip(vector).for_each(|(x, u)| *x += factor * u);
    }
    sum.iter_mut().zip(&roots).for_each(|(x, root)| *x /= root);
    metric.cochain(degree, &sum).unwrap()
}

fn numbers() -> impl Strategy<Value = Vec<f64>> {
    prop::collection::vec(-1.0f64..1.0, 40)
}

/// Cochains and weights that fit no pattern of a complex.
fn some_numbers() -> Vec<f64> {
    (0..101u64).map(|i| ((i * i * 7919 + 31 * i) % 1009) as f64 / 504.5 - 1.0).collect()
}

proptest! {
    #[test]
    fn as_many_harmonic_cochains_as_the_betti_number(complex in random_complexes(), numbers in numbers()) {
        let betti = homology_with(&complex, Coefficients::Rationals).betti_numbers();
        let metric = MetricComplex::with_weights(&complex, weights(&complex, &numbers)).unwrap();
        for (degree, &betti) in betti.iter().enumerate() {
            let space = HodgeSpace::new(&metric, degree).unwrap();
            prop_assert_eq!(space.harmonic_basis().len(), betti);
            let spectrum = metric.laplacian_spectrum(degree).unwrap();
            prop_assert_eq!(spectrum.iter().filter(|&&x| x.abs() < 1e-8).count(), betti, "{:?}", spectrum);
            for harmonic in space.harmonic_basis() {
                prop_assert!(harmonic.closed_residual() < TOLERANCE && harmonic.coclosed_residual() < TOLERANCE);
                prop_assert!(metric.norm(&metric.laplacian(harmonic.cochain()).unwrap()).unwrap() < TOLERANCE);
                prop_assert!(metric.norm(harmonic.cochain()).unwrap() > 1e-3, "a class that is not zero");
                prop_assert!(complex.is_closed(harmonic.class()).unwrap());
            }
        }
    }

    /// On cycles the harmonic cochain has the values of the integral one.
    #[test]
    fn harmonic_cochains_pair_as_their_classes(complex in random_complexes(), numbers in numbers()) {
        let metric = MetricComplex::with_weights(&complex, weights(&complex, &numbers)).unwrap();
        for (degree, cycles) in generators(&complex).iter().enumerate() {
            for harmonic in HodgeSpace::new(&metric, degree).unwrap().harmonic_basis() {
                for cycle in cycles {
                    let terms = cycle.chain().terms().iter();
                    let real: f64 = terms.map(|(cell, x)| x.to_f64() * value(harmonic.cochain(), cell.index())).sum();
                    let exact = harmonic.class().pairing(cycle.chain()).unwrap().unwrap_or_default();
                    prop_assert!((real - exact.to_f64()).abs() < TOLERANCE * 10.0, "{} {}", real, exact);
                }
            }
        }
    }

    #[test]
    fn the_parts_are_orthogonal_and_add_up(complex in random_complexes(), numbers in numbers(), at in 0usize..4) {
        let metric = MetricComplex::with_weights(&complex, weights(&complex, &numbers)).unwrap();
        let degree = at.min(complex.degree_count() - 1);
        let space = HodgeSpace::new(&metric, degree).unwrap();
        let whole = cochain(&complex, degree, &numbers[3..]);
        let parts = space.decomposition(&whole).unwrap();
        let sum = parts.exact().plus(parts.coexact()).unwrap().plus(parts.harmonic()).unwrap();
        prop_assert!(distance(&metric, &sum, &whole) < TOLERANCE);
        for (a, b) in [(parts.exact(), parts.coexact()), (parts.exact(), parts.harmonic()), (parts.coexact(), parts.harmonic())] {
            prop_assert!(metric.inner_product(a, b).unwrap().abs() < TOLERANCE);
        }
        prop_assert!(parts.closed_residual() < TOLERANCE && parts.coclosed_residual() < TOLERANCE);
        if let Some(potential) = parts.potential() {
            prop_assert!(distance(&metric, &complex.coboundary(potential).unwrap(), parts.exact()) < TOLERANCE);
        }
        // Each part has no parts but itself.
        for (i, part) in [parts.exact(), parts.coexact(), parts.harmonic()].into_iter().enumerate() {
            let again = space.decomposition(part).unwrap();
            for (j, other) in [again.exact(), again.coexact(), again.harmonic()].into_iter().enumerate() {
                let expected = if i == j { part.clone() } else { Cochain::zero(degree) };
                prop_assert!(distance(&metric, other, &expected) < TOLERANCE);
            }
        }
        // The second method.
        prop_assert!(distance(&metric, parts.harmonic(), &harmonic_part_by_eigenvectors(&metric, &whole)) < TOLERANCE);
    }

    /// Turning cells around turns the parts around.
    #[test]
    fn orientations_do_not_matter(complex in random_complexes(), numbers in numbers(), flips in any::<u64>(), at in 0usize..4) {
        let sign = |k: usize, cell: usize| if flips.rotate_left((13 * k + cell) as u32) & 1 == 1 { -1 } else { 1 };
        let matrices = complex.boundary_matrices().iter().enumerate().map(|(k, matrix)| {
            let entries = matrix.columns().enumerate().flat_map(|(j, column)| {
                column.iter().map(move |(i, x)| (i, j, i64::from(x) * sign(k + 1, j) * sign(k, i))).collect::<Vec<_>>()
            });
            SparseMatrix::from_entries(matrix.row_count(), matrix.column_count(), entries).unwrap()
        });
        let turned = ChainComplex::new(matrices.collect()).unwrap();
        let degree = at.min(complex.degree_count() - 1);
        let turn = |cochain: &Cochain<f64>| {
            let terms = cochain.terms().iter().map(|&(cell, x)| (cell, x * sign(degree, cell.index()) as f64));
            Cochain::new(&turned, degree, terms.collect::<Vec<_>>()).unwrap()
        };
        let (here, there) = (MetricComplex::new(&complex), MetricComplex::new(&turned));
        let whole = cochain(&complex, degree, &numbers);
        let a = HodgeSpace::new(&here, degree).unwrap().decomposition(&whole).unwrap();
        let b = HodgeSpace::new(&there, degree).unwrap().decomposition(&turn(&whole)).unwrap();
        for (x, y) in [(a.exact(), b.exact()), (a.coexact(), b.coexact()), (a.harmonic(), b.harmonic())] {
            prop_assert!(distance(&there, &turn(x), y) < TOLERANCE);
        }
    }

    #[test]
    fn the_codifferential_is_adjoint_to_the_coboundary(complex in random_complexes(), numbers in numbers(), at in 0usize..3) {
        let metric = MetricComplex::with_weights(&complex, weights(&complex, &numbers)).unwrap();
        let (below, above) = (cochain(&complex, at, &numbers[5..]), cochain(&complex, at + 1, &numbers[2..]));
        let first = metric.inner_product(&complex.coboundary(&below).unwrap(), &above).unwrap();
        let second = metric.inner_product(&below, &metric.codifferential(&above).unwrap()).unwrap();
        prop_assert!((first - second).abs() < TOLERANCE);
        // The exact matrix is the operator for weights 1.
        let metric = MetricComplex::new(&complex);
        let matrix = laplacian_matrix(&complex, at).unwrap();
        let applied = metric.laplacian(&below).unwrap();
        for row in 0..matrix.row_count() {
            let sum: f64 = (0..matrix.column_count()).map(|j| f64::from(matrix.entry(row, j)) * value(&below, j)).sum();
            prop_assert!((sum - value(&applied, row)).abs() < TOLERANCE);
        }
        prop_assert_eq!(&matrix, &matrix.transpose());
    }
}

/// The harmonic cochains of a basis are dual to its free generators, and vanish on torsion.
#[test]
fn harmonic_cochains_are_dual_to_the_generators() {
    for (name, space) in known() {
        let complex = space.chain_complex().unwrap();
        let (basis, metric) = (HomologyBasis::new(&complex), MetricComplex::new(&complex));
        for degree in 0..complex.degree_count() {
            let space = HodgeSpace::with_basis(&metric, degree, &basis).unwrap();
            let free =
                basis.generators(degree).iter().filter(|generator| generator.order().is_none()).count();
            let torsion = basis.generators(degree).len() - free;
            for (i, harmonic) in space.harmonic_basis().iter().enumerate() {
                for (j, generator) in basis.generators(degree).iter().enumerate() {
                    let terms = generator.chain().terms().iter();
                    let sum: f64 =
                        terms.map(|(cell, x)| x.to_f64() * value(harmonic.cochain(), cell.index())).sum();
                    let expected = f64::from(u8::from(i + torsion == j));
                    assert!(
                        (sum - expected).abs() < TOLERANCE,
                        "{name}, degree {degree}: {i} on {j} is {sum}"
                    );
                }
            }
        }
    }
}

/// A circle of edges with weights: as currents through resistors in a row, the values are inverse to the weights.
#[test]
fn around_a_circle_values_are_inverse_to_weights() {
    let entries = (0..4).flat_map(|edge| [(edge, edge, -1), ((edge + 1) % 4, edge, 1)]);
    let circle = ChainComplex::new(vec![SparseMatrix::from_entries(4, 4, entries).unwrap()]).unwrap();
    let metric =
        MetricComplex::with_weights(&circle, vec![vec![1.0, 5.0, 2.0, 0.25], vec![1.0, 0.5, 4.0, 0.25]])
            .unwrap();
    let space = HodgeSpace::new(&metric, 1).unwrap();
    let harmonic = space.harmonic_basis()[0].cochain();
    let total: f64 = (0..4).map(|edge| value(harmonic, edge)).sum();
    assert!((total.abs() - 1.0).abs() < 1e-12, "a generator is 1 around");
    // 1/w = 1, 2, 1/4, 4 of 29/4.
    for (edge, part) in [4.0, 8.0, 1.0, 16.0].into_iter().enumerate() {
        assert!((value(harmonic, edge) * total - part / 29.0).abs() < 1e-12);
    }
}

/// All of the table of known spaces, in each degree and with weights.
#[test]
fn known_spaces_have_their_harmonic_cochains() {
    let numbers = some_numbers();
    for (name, space) in known() {
        let complex = space.chain_complex().unwrap();
        let metric = MetricComplex::with_weights(&complex, weights(&complex, &numbers)).unwrap();
        for (degree, group) in homology(&complex).groups().iter().enumerate() {
            let space = HodgeSpace::new(&metric, degree).unwrap();
            assert_eq!(space.harmonic_basis().len(), group.betti(), "{name}, degree {degree}");
            let whole = cochain(&complex, degree, &numbers);
            let parts = space.decomposition(&whole).unwrap();
            assert!(parts.closed_residual() < TOLERANCE && parts.coclosed_residual() < TOLERANCE, "{name}");
            let second = harmonic_part_by_eigenvectors(&metric, &whole);
            assert!(distance(&metric, parts.harmonic(), &second) < TOLERANCE, "{name}, degree {degree}");
        }
    }
}

fn known() -> Vec<(&'static str, SimplicialComplex)> {
    let named = [
        ("torus", known_spaces::torus_grid(&[4, 3])),
        ("3-torus", known_spaces::cyclic_torus(3)),
        ("Klein bottle", known_spaces::klein_grid(4, 3)),
        ("projective plane", known_spaces::projective_plane()),
        ("3-sphere", known_spaces::simplex_boundary(4)),
        ("lens space", known_spaces::lens_space(3, 1)),
        ("dunce hat", known_spaces::dunce_hat()),
        ("Moore space", known_spaces::moore_space(3)),
        ("sphere bundle", known_spaces::sphere_bundle_over_circle(3, 9)),
        ("book", known_spaces::book(3)),
        ("chessboard", known_spaces::chessboard(3, 4)),
    ];
    named.map(|(name, space)| (name, space.unwrap())).into()
}

#[test]
fn faults_are_named() {
    let points = ChainComplex::of_points(2);
    let fault = |weights| MetricComplex::with_weights(&points, weights).unwrap_err();
    assert_eq!(fault(vec![vec![1.0]]).kind(), ErrorKind::Shape);
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let error = fault(vec![vec![1.0, bad]]);
        assert!(
            error.kind() == ErrorKind::InvalidInput && error.message().contains("c1 of degree 0"),
            "{error}"
        );
    }
    let metric = MetricComplex::new(&points);
    let space = HodgeSpace::new(&metric, 0).unwrap();
    assert_eq!(space.decomposition(&Cochain::zero(1)).unwrap_err().kind(), ErrorKind::Shape);
    let more = ChainComplex::of_points(3);
    let foreign = cochain(&more, 0, &[1.0]);
    assert_eq!(space.decomposition(&foreign).unwrap_err().kind(), ErrorKind::NotInComplex);
    assert_eq!(metric.laplacian(&foreign).unwrap_err().kind(), ErrorKind::NotInComplex);
    let many = ChainComplex::of_points(5001);
    assert_eq!(MetricComplex::new(&many).laplacian_spectrum(0).unwrap_err().kind(), ErrorKind::TooLarge);
}

#[test]
fn degrees_beyond_the_dimension_have_nothing() {
    let points = ChainComplex::of_points(2);
    assert_eq!(harmonic_basis(&points, 0).unwrap().len(), 2);
    assert!(harmonic_basis(&points, 1).unwrap().is_empty());
    assert!(harmonic_basis(&ChainComplex::of_points(0), 0).unwrap().is_empty());
    assert!(MetricComplex::new(&points).laplacian_spectrum(5).unwrap().is_empty());
}
