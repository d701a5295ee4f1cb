//! Guide 11: Laplacians, harmonic cochains, and the three parts of a cochain.
//!
//! Run with `cargo run -p coface --example 11_hodge`.

use coface::algebra::chains::Cochain;
use coface::complexes::known_spaces::{circle, torus_grid};
use coface::topology::{HodgeSpace, MetricComplex, laplacian_matrix};
use coface::{CellId, SimplicialComplex};

fn is_near(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-9
}

fn main() -> Result<(), coface::Error> {
    // The Laplacian of degree 0 is that of the graph: the degree of each vertex on the diagonal, minus one for each neighbor.
    let hexagon = circle(6)?.chain_complex()?;
    let matrix = laplacian_matrix(&hexagon, 0)?;
    assert_eq!((matrix.entry(0, 0), matrix.entry(0, 1), matrix.entry(0, 2)), (2, -1, 0));

    // On a cycle of n vertices its eigenvalues are 2 - 2 cos(2 pi k / n). For six: 0, 1, 1, 3, 3, 4.
    let spectrum = MetricComplex::new(&hexagon).laplacian_spectrum(0)?;
    assert!(spectrum.iter().zip([0.0, 1.0, 1.0, 3.0, 3.0, 4.0]).all(|(&found, known)| is_near(found, known)));

    // In every degree the eigenvalue 0 occurs as often as the Betti number says: 1, 2 and 1 times on a torus.
    let torus = torus_grid(&[3, 3])?.chain_complex()?;
    let metric = MetricComplex::new(&torus);
    for (degree, betti) in [1, 2, 1].into_iter().enumerate() {
        let zeros = metric.laplacian_spectrum(degree)?.into_iter().filter(|&value| is_near(value, 0.0));
        assert_eq!(zeros.count(), betti);
    }

    // The rim of a triangle with the edges {0, 1}, {0, 2}, {1, 2}. A flow of 3 along the first edge has circulation 3; its harmonic part spreads that
    // evenly, 1 along each edge on the way around (so -1 along {0, 2}), and the rest is a gradient.
    let rim = SimplicialComplex::from_facets([[0, 1], [1, 2], [0, 2]])?.chain_complex()?;
    let flow = Cochain::new(&rim, 1, [(CellId::new(0), 3.0)])?;
    let metric = MetricComplex::new(&rim);
    let parts = HodgeSpace::new(&metric, 1)?.decomposition(&flow)?;
    let values = |cochain: &Cochain<f64>| -> Vec<f64> {
        (0..3)
            .map(|edge| cochain.terms().iter().find(|(c, _)| c.index() == edge).map_or(0.0, |(_, x)| *x))
            .collect()
    };
    let are_near = |found: Vec<f64>, known: [f64; 3]| found.iter().zip(known).all(|(&a, b)| is_near(a, b));
    assert!(are_near(values(parts.harmonic()), [1.0, -1.0, 1.0]));
    assert!(are_near(values(parts.exact()), [2.0, 1.0, -1.0]));
    // The gradient is that of a potential: its differences along the edges.
    let potential = parts.potential().expect("degree 1 has one");
    assert!(are_near(values(&rim.coboundary(potential)?), [2.0, 1.0, -1.0]));

    // With the triangle filled nothing is harmonic any more: the same part is now the codifferential of a cochain on the face.
    let disk = SimplicialComplex::from_facets([[0, 1, 2]])?.chain_complex()?;
    let flow = Cochain::new(&disk, 1, [(CellId::new(0), 3.0)])?;
    let metric = MetricComplex::new(&disk);
    let space = HodgeSpace::new(&metric, 1)?;
    assert!(space.harmonic_basis().is_empty());
    let parts = space.decomposition(&flow)?;
    assert!(are_near(values(parts.coexact()), [1.0, -1.0, 1.0]));

    // Weights make it geometry: a long edge conducts less. With weights 1/2, 1 and 1 of the edges the current of the rim is still the same along
    // all edges of the circle, and values are current over weight: 2 along the first edge, 1 along the others, of a circulation of 4.
    let weighted = MetricComplex::with_weights(&rim, vec![vec![1.0; 3], vec![0.5, 1.0, 1.0]])?;
    let flow = Cochain::new(&rim, 1, [(CellId::new(0), 4.0)])?;
    let parts = HodgeSpace::new(&weighted, 1)?.decomposition(&flow)?;
    assert!(are_near(values(parts.harmonic()), [2.0, -1.0, 1.0]));
    assert!(parts.closed_residual() < 1e-9 && parts.coclosed_residual() < 1e-9);
    Ok(())
}
