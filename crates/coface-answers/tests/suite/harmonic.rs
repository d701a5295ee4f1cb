//! Harmonic cochains of real surfaces: as many as homology says, closed, coclosed and dual to the generators.
//!
//! The folder named by the environment variable `COFACE_DATA` holds the surfaces; without it the shipped models are
//! looked at.

use coface_algebra::CellId;
use coface_algebra::chains::{ChainComplex, Cochain};
use coface_answers::Producer;
use coface_complexes::known_spaces;
use coface_io as io;
use coface_topology::{HodgeSpace, HomologyBasis, MetricComplex, homology};
use std::path::{Path, PathBuf};

/// Norms of what should vanish, for harmonic cochains that are 1 on a generator.
const TOLERANCE: f64 = 1e-8;

/// The surfaces of the data folder that can be read, or the shipped ones.
fn surfaces() -> Vec<PathBuf> {
    let shipped = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data");
    let folder = match std::env::var_os("COFACE_DATA") {
        Some(data) => PathBuf::from(data).join("surfaces"),
        None => shipped,
    };
    let files = std::fs::read_dir(folder).expect("the folder of surfaces is there");
    let mut paths: Vec<PathBuf> = files.map(|file| file.expect("files are listed").path()).collect();
    paths.retain(|path| {
        let known = ["obj", "off", "ply", "stl", "STL", "vtk"];
        path.extension().is_some_and(|extension| known.iter().any(|known| extension == *known))
    });
    paths.sort();
    paths
}

/// Checks degree 0 and 1 of a complex; gives the first Betti number.
fn check(name: &str, complex: &ChainComplex) -> usize {
    let betti = homology(complex).betti_numbers();
    let (basis, metric) = (HomologyBasis::unshortened(complex), MetricComplex::new(complex));
    for (degree, &betti) in betti.iter().enumerate().take(2) {
        let found = metric.harmonic_cochains(degree, &basis).expect("a surface fits in memory");
        assert_eq!(found.len(), betti, "{name}, degree {degree}");
        let free = basis.generators(degree).iter().filter(|generator| generator.order().is_none());
        let free: Vec<_> = free.map(|generator| generator.chain()).collect();
        for (i, harmonic) in found.iter().enumerate() {
            let residual = harmonic.closed_residual().max(harmonic.coclosed_residual());
            assert!(residual < TOLERANCE, "{name}, degree {degree}: {residual}");
            for (j, cycle) in free.iter().enumerate() {
                let terms = cycle.terms().iter();
                let sum: f64 = terms
                    .map(|(cell, x)| x.to_f64() * harmonic.cochain().coefficient(*cell).unwrap_or(&0.0))
                    .sum();
                let expected = f64::from(u8::from(i == j));
                assert!((sum - expected).abs() < TOLERANCE, "{name}, degree {degree}: {i} on {j} is {sum}");
            }
        }
    }
    betti.get(1).copied().unwrap_or(0)
}

#[test]
fn real_surfaces_have_their_harmonic_cochains() {
    let mut loops = 0;
    for path in surfaces() {
        let name = path.display().to_string();
        let Ok(model) = io::read_path(&path, None) else { continue };
        let complex =
            Producer::of(model).and_then(Producer::into_chain_complex).expect("surfaces have a complex");
        if complex.cell_count(1) < 200_000 {
            loops += check(&name, &complex);
        }
    }
    assert!(loops > 0, "a surface with a loop is among them");
}

/// On a flat torus of squares cut in two the harmonic cochains are constant on the edges of each direction.
#[test]
fn on_a_flat_torus_harmonic_cochains_are_constant() {
    let torus = known_spaces::torus_grid(&[12, 9]).expect("a grid of this size is built");
    let complex = torus.chain_complex().expect("a small complex");
    let basis = HomologyBasis::new(&complex);
    let found = MetricComplex::new(&complex).harmonic_cochains(1, &basis).expect("a small problem");
    assert_eq!(found.len(), 2);
    for harmonic in &found {
        let mut sizes: Vec<f64> = (0..complex.cell_count(1))
            .map(|edge| harmonic.cochain().coefficient(CellId::new(edge)).copied().unwrap_or(0.0).abs())
            .collect();
        sizes.sort_by(f64::total_cmp);
        // 108 edges of each of the three directions.
        for direction in sizes.chunks(108) {
            assert!(direction[107] - direction[0] < 1e-10, "{direction:?}");
        }
    }
}

/// The gradient of a function and a harmonic flow on a torus are told apart.
#[test]
fn a_flow_is_split_into_its_parts() {
    let torus = known_spaces::torus_grid(&[8, 8]).expect("a grid of this size is built");
    let complex = torus.chain_complex().expect("a small complex");
    let metric = MetricComplex::new(&complex);
    let space = HodgeSpace::new(&metric, 1).expect("a small problem");
    let heights = (0..64).map(|vertex| (CellId::new(vertex), ((vertex * vertex * 37) % 101) as f64));
    let heights = Cochain::new(&complex, 0, heights).expect("values of vertices");
    let gradient = complex.coboundary(&heights).expect("a cochain of the complex");
    let harmonic = space.harmonic_basis()[0].cochain();
    let parts =
        space.decomposition(&gradient.plus(harmonic).expect("the same degree")).expect("of this degree");
    for (part, expected) in [(parts.exact(), &gradient), (parts.harmonic(), harmonic)] {
        let rest = part.minus(expected).expect("the same degree");
        assert!(metric.norm(&rest).expect("a cochain of the complex") < 1e-9);
    }
    assert!(metric.norm(parts.coexact()).expect("a cochain of the complex") < 1e-9);
}
