//! Harmonic cochains and Hodge decompositions.

use crate::chains::read_terms;
use crate::failure::Failure;
use coface::CellId;
use coface::algebra::Sign;
use coface::algebra::chains::{ChainComplex, Cochain};
use coface::answers::CellNames;
use coface::answers::answer::{HarmonicCochain, HodgeNorms, HodgeParts, RealTerm};
use coface::topology::{HodgeSpace, HomologyBasis, MetricComplex};
use serde_json::Value;
use std::path::Path;

/// Harmonic cochains of all degrees, and a page that says how good they are.
pub(super) fn cochains(
    basis: &HomologyBasis<'_>,
    naming: &CellNames<'_>,
) -> Result<(Vec<Vec<HarmonicCochain>>, String), Failure> {
    let metric = MetricComplex::new(basis.complex());
    let mut degrees = Vec::new();
    let mut page = "  harmonic cochains, dual to the free generators\n".to_owned();
    for degree in 0..basis.complex().degree_count() {
        let mut list = Vec::new();
        for (i, harmonic) in metric.harmonic_cochains(degree, basis)?.iter().enumerate() {
            let norm = metric.norm(harmonic.cochain())?;
            list.push(HarmonicCochain {
                chain: terms(harmonic.cochain(), naming),
                norm,
                closed_residual: harmonic.closed_residual(),
                coclosed_residual: harmonic.coclosed_residual(),
            });
            page += &format!(
                "    cochain {i} of degree {degree}: norm {norm:.6}, residuals {:.1e} closed, {:.1e} coclosed\n",
                harmonic.closed_residual(),
                harmonic.coclosed_residual()
            );
        }
        degrees.push(list);
    }
    Ok((degrees, page))
}

/// The three parts of a cochain from a file.
pub(super) fn decomposition(
    complex: &ChainComplex,
    naming: &CellNames<'_>,
    file: &Path,
) -> Result<(HodgeParts, String), Failure> {
    let (degree, values) = read_terms(file, Value::as_f64)?;
    let in_file = |error: coface::Error| error.in_file(file.display().to_string());
    let lists = values.iter().map(|(_, vertices)| &vertices[..]);
    let (degree, cells) = naming.producer().oriented_cells(complex, lists, degree).map_err(in_file)?;
    let signed = cells.into_iter().zip(&values).map(|((cell, sign), (value, _))| match sign {
        Sign::Plus => (cell, *value),
        Sign::Minus => (cell, -value),
    });
    let cochain = Cochain::new(complex, degree, signed).map_err(in_file)?;
    let metric = MetricComplex::new(complex);
    let parts = HodgeSpace::new(&metric, degree)?.decomposition(&cochain)?;
    let norms = [&cochain, parts.exact(), parts.coexact(), parts.harmonic()].map(|part| metric.norm(part));
    let [whole, exact, coexact, harmonic] = norms;
    let (whole, exact, coexact, harmonic) = (whole?, exact?, coexact?, harmonic?);
    let object = HodgeParts {
        degree,
        exact: terms(parts.exact(), naming),
        coexact: terms(parts.coexact(), naming),
        harmonic: terms(parts.harmonic(), naming),
        norms: HodgeNorms { cochain: whole, exact, coexact, harmonic },
    };
    let page = format!(
        "  Hodge decomposition of {}, of degree {degree} and norm {whole:.6}\n    \
         exact part: norm {exact:.6}\n    coexact part: norm {coexact:.6}\n    harmonic part: norm {harmonic:.6}\n",
        file.display()
    );
    Ok((object, page))
}

fn terms(cochain: &Cochain<f64>, naming: &CellNames<'_>) -> Vec<RealTerm> {
    let term = |&(cell, value): &(CellId, f64)| (value, naming.vertices(cochain.degree(), cell));
    cochain.terms().iter().map(term).collect()
}
