//! Harmonic forms.

use coface::Error;
use coface::algebra::Integer;
use coface::algebra::chains::Cochain;
use coface::complexes::surface::GeneralizedMap;
use coface::topology::{HarmonicForm, cotangent_weights, harmonic_forms};

/// Harmonic forms, with the weights that they are for.
pub(super) fn forms(
    map: &GeneralizedMap,
    cocycles: &[Cochain<Integer>],
    lengths: Option<&[f64]>,
    weights: &str,
) -> Result<(&'static str, Vec<HarmonicForm>), Error> {
    let uniform = || vec![1.0; map.skeleton().edge_count()];
    if weights == "uniform" || cocycles.is_empty() {
        return Ok(("uniform", harmonic_forms(map, cocycles, &uniform())?));
    }
    let found = match lengths {
        None => Err(Error::invalid("the model has no positions, so angles have no cotangents")
            .with_cure("take weights=\"uniform\"")),
        Some(lengths) => {
            cotangent_weights(map, lengths).and_then(|weights| harmonic_forms(map, cocycles, &weights))
        }
    };
    match found {
        Ok(forms) => Ok(("cotangent", forms)),
        Err(error) if weights != "auto" => Err(error),
        Err(_) => Ok(("uniform", harmonic_forms(map, cocycles, &uniform())?)),
    }
}
