//! Harmonic cochains and Hodge decompositions.

use super::GivenRealCochain;
use crate::CellNames;
use crate::answer::{HarmonicCochain, HodgeNorms, HodgeParts};
use coface_algebra::chains::{ChainComplex, Cochain};
use coface_algebra::{Error, Sign};
use coface_topology::{HodgeSpace, HomologyBasis, MetricComplex};

/// Harmonic cochains of all degrees.
pub(super) fn cochains(
    basis: &HomologyBasis<'_>,
    naming: &CellNames<'_>,
) -> Result<Vec<Vec<HarmonicCochain>>, Error> {
    let metric = MetricComplex::new(basis.complex());
    let mut degrees = Vec::new();
    for degree in 0..basis.complex().degree_count() {
        let mut list = Vec::new();
        for harmonic in &metric.harmonic_cochains(degree, basis)? {
            let norm = metric.norm(harmonic.cochain())?;
            list.push(HarmonicCochain {
                chain: naming.real_terms(harmonic.cochain()),
                norm,
                closed_residual: harmonic.closed_residual(),
                coclosed_residual: harmonic.coclosed_residual(),
            });
        }
        degrees.push(list);
    }
    Ok(degrees)
}

/// The three parts of a cochain from a file.
pub(super) fn decomposition(
    complex: &ChainComplex,
    naming: &CellNames<'_>,
    given: &GivenRealCochain,
) -> Result<HodgeParts, Error> {
    let values = &given.terms;
    let in_file = |error: Error| error.in_file(&given.place);
    let lists = values.iter().map(|(_, vertices)| &vertices[..]);
    let (degree, cells) = naming.producer().oriented_cells(complex, lists, given.degree).map_err(in_file)?;
    let signed = cells.into_iter().zip(values).map(|((cell, sign), (value, _))| match sign {
        Sign::Plus => (cell, *value),
        Sign::Minus => (cell, -value),
    });
    let cochain = Cochain::new(complex, degree, signed).map_err(in_file)?;
    let metric = MetricComplex::new(complex);
    let parts = HodgeSpace::new(&metric, degree)?.decomposition(&cochain)?;
    let norms = [&cochain, parts.exact(), parts.coexact(), parts.harmonic()].map(|part| metric.norm(part));
    let [whole, exact, coexact, harmonic] = norms;
    let (whole, exact, coexact, harmonic) = (whole?, exact?, coexact?, harmonic?);
    Ok(HodgeParts {
        degree,
        exact: naming.real_terms(parts.exact()),
        coexact: naming.real_terms(parts.coexact()),
        harmonic: naming.real_terms(parts.harmonic()),
        norms: HodgeNorms { cochain: whole, exact, coexact, harmonic },
    })
}
