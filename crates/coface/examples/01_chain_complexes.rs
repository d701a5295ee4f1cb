//! Guide 1: everything is a chain complex.
//!
//! Cells in each degree and a sparse integer matrix from each degree to the one below: column j is the boundary of
//! cell j. Run with `cargo run -p coface --example 01_chain_complexes`.

use coface::algebra::SparseMatrix;
use coface::algebra::chains::ChainComplex;
use coface::topology::{Coefficients, cohomology, generators, homology, homology_with};

fn main() -> Result<(), coface::Error> {
    // A Klein bottle from a square: one vertex, two loops a and b, one disk with the rim a b a b^-1, so 2a.
    let klein_bottle =
        ChainComplex::new(vec![SparseMatrix::zero(1, 2)?, SparseMatrix::from_entries(2, 1, [(0, 0, 2)])?])?;
    assert_eq!(klein_bottle.euler_characteristic(), 0);

    // Integral homology sees that 2a bounds and a does not; a field sees less.
    let names = |groups: &[coface::topology::AbelianGroup]| -> Vec<String> {
        groups.iter().map(ToString::to_string).collect()
    };
    assert_eq!(names(homology(&klein_bottle).groups()), ["Z", "Z + Z/2", "0"]);
    assert_eq!(homology_with(&klein_bottle, Coefficients::Modulo(2)).betti_numbers(), [1, 2, 1]);
    assert_eq!(homology_with(&klein_bottle, Coefficients::Rationals).betti_numbers(), [1, 1, 0]);
    assert_eq!(names(cohomology(&klein_bottle, Coefficients::Integers).groups()), ["Z", "Z", "Z/2"]);

    // Generators come on the original cells: a has order 2, b has none.
    let loops = &generators(&klein_bottle)[1];
    assert_eq!(loops[0].order().map(ToString::to_string).as_deref(), Some("2"));
    assert_eq!(loops[1].order(), None);

    // What is no complex is refused, and the cell is named: an edge from v0 to v1 bounds no disk alone.
    let edge = SparseMatrix::from_entries(2, 1, [(0, 0, -1), (1, 0, 1)])?;
    let disk = SparseMatrix::from_entries(1, 1, [(0, 0, 1)])?;
    let error = ChainComplex::new(vec![edge, disk]).expect_err("the rim of a disk is closed");
    assert!(error.to_string().starts_with("the boundary of the boundary of cell 0 of degree 2 is not zero"));
    Ok(())
}
