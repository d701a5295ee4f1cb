//! Chain complexes of models and their pairs, and models in a line.

use super::source_of;
use crate::chain_complex::ChainComplex;
use crate::errors::invalid;
use crate::source::{Names, Naming, Source};
use crate::work::run;
use coface::answers::Pair;
use coface::io::{Model, Structure};
use pyo3::prelude::*;
use pyo3::types::PyString;
use std::sync::Arc;

/// The chain complex of a model, or of the pair that it is with a part.
pub(super) fn chain_complex(
    py: Python<'_>,
    source: &Arc<Source>,
    relative: Option<&Bound<'_, PyAny>>,
    reduced: bool,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<ChainComplex> {
    enum Part {
        Nothing,
        Boundary,
        Model(Arc<Source>),
    }
    let part = match relative {
        None => Part::Nothing,
        Some(part) => match part.cast::<PyString>() {
            Ok(word) if word.to_str()? == "boundary" => Part::Boundary,
            Ok(word) => {
                return Err(invalid(py, format!("relative is {word}"), "give \"boundary\" or a Model"));
            }
            Err(_) => Part::Model(source_of(part)?),
        },
    };
    if reduced && relative.is_some() {
        return Err(invalid(py, "a pair is not reduced", "leave reduced out"));
    }
    let source = Arc::clone(source);
    run(py, progress, || {
        let (producer, whole) = (source.producer()?, source.chains()?);
        let names = Names::Source(Arc::clone(&source));
        let pair = match &part {
            Part::Nothing => None,
            Part::Boundary => Some(Pair::with_boundary(producer, whole)?),
            Part::Model(part) => Some(Pair::with_model(producer, whole, &part.model)?),
        };
        let (complex, shift) = match &pair {
            Some(pair) => (Arc::new(pair.chains().clone()), 0),
            None if reduced => (Arc::new(whole.augmented()?), 1),
            None => (Arc::clone(whole), 0),
        };
        Ok(ChainComplex::new(complex, Naming { names, pair: pair.map(Arc::new), shift }))
    })
}

/// What a model has, in numbers.
pub(super) fn described(model: &Model) -> String {
    let counted = |count: usize, one: &str, many: &str| {
        (count > 0).then(|| format!("{count} {}", if count == 1 { one } else { many }))
    };
    let mut parts: Vec<String> = match model.structure() {
        Some(Structure::Facets(facets)) => vec![format!("{} facets", facets.len())],
        Some(Structure::Halfedges { next, .. }) => vec![format!("{} halfedges", next.len())],
        Some(Structure::Chains(complex)) => vec![format!("cells {:?}", complex.f_vector())],
        Some(Structure::Gluings(table)) => {
            vec![format!("{} simplices of dimension {} glued", table.simplex_count(), table.dimension())]
        }
        Some(Structure::Volume(volume)) => vec![format!("voxels {:?}", volume.shape())],
        _ => vec![format!(
            "{} {}",
            model.vertex_count(),
            if model.vertex_count() == 1 { "vertex" } else { "vertices" }
        )],
    };
    parts.extend(counted(model.lines().len(), "line", "lines"));
    parts.extend(counted(model.polygons().len(), "face", "faces"));
    parts.extend(counted(model.cells().len(), "cell", "cells"));
    format!("Model({})", parts.join(", "))
}
