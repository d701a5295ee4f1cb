//! Chain complexes of models and their pairs, and models in a line.

use crate::chain_complex::ChainComplex;
use crate::errors::invalid;
use crate::given::source_of;
use crate::homology::{Chain, Generator};
use crate::source::{Names, Naming, Source};
use crate::work::run;
use coface::algebra::chains;
use coface::answers::{Domain, RelativeTo, named_groups};
use coface::io::{Model, Structure};
use pyo3::prelude::*;
use pyo3::types::{PyList, PyString};
use std::sync::Arc;

/// The chain complex of a model or of groups of it, or of the pair that it is with a part.
pub(super) fn chain_complex(
    py: Python<'_>,
    source: &Arc<Source>,
    relative: Option<&Bound<'_, PyAny>>,
    domain: Option<&Bound<'_, PyAny>>,
    reduced: bool,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<ChainComplex> {
    let relative = relative.map(|part| relative_to(part, &source.model)).transpose()?;
    let domain = Domain { groups: domain.map_or(Ok(Vec::new()), words)?, relative };
    if reduced && !domain.is_whole() {
        return Err(invalid(py, "a pair or a domain is not reduced", "leave reduced out"));
    }
    let source = Arc::clone(source);
    run(py, progress, || {
        let (producer, whole) = (source.producer()?, source.chains()?);
        let names = Names::Source(Arc::clone(&source));
        let pair = domain.pair(producer, whole, Some(&source.model))?;
        let (complex, shift) = match &pair {
            Some(pair) => (Arc::new(pair.chains().clone()), 0),
            None if reduced => (Arc::new(whole.augmented()?), 1),
            None => (Arc::clone(whole), 0),
        };
        Ok(ChainComplex::new(complex, Naming { names, pair: pair.map(Arc::new), shift }))
    })
}

/// What a chain complex is taken relative to.
fn relative_to(part: &Bound<'_, PyAny>, model: &Model) -> PyResult<RelativeTo> {
    if part.cast::<PyString>().is_err() && part.cast::<PyList>().is_err() && part.extract::<i32>().is_err() {
        let part = source_of(part)?;
        return Ok(RelativeTo::Part { name: "relative".to_owned(), model: Box::new(part.model.clone()) });
    }
    let words = words(part)?;
    Ok(match &words[..] {
        [word] if word == "boundary" && named_groups(model, &words).is_err() => RelativeTo::Boundary,
        _ => RelativeTo::Groups(words),
    })
}

/// Names or numbers of groups: one, or a list.
fn words(value: &Bound<'_, PyAny>) -> PyResult<Vec<String>> {
    let word = |value: &Bound<'_, PyAny>| match value.cast::<PyString>() {
        Ok(word) => Ok(word.to_str()?.to_owned()),
        Err(_) => value.extract::<i32>().map(|number| number.to_string()).map_err(|_| {
            invalid(value.py(), format!("{value} names no group"), "give names or numbers of groups")
        }),
    };
    match value.cast::<PyList>() {
        Ok(list) => list.iter().map(|value| word(&value)).collect(),
        Err(_) => Ok(vec![word(value)?]),
    }
}

/// A mesh with one more group for a chain of it.
pub(super) fn with_chain(
    py: Python<'_>,
    source: &Arc<Source>,
    name: String,
    chain: &Bound<'_, PyAny>,
) -> PyResult<Model> {
    let generator = chain.cast::<Generator>().map(|generator| generator.get().chain.clone_ref(py));
    let chain = generator.or_else(|_| chain.cast::<Chain>().map(|chain| chain.clone().unbind()));
    let chain = chain.map_err(|_| invalid(py, "this is no chain", "give a Chain or a Generator"))?;
    let chain = chain.get();
    let is_own = matches!(&chain.naming.names, Names::Source(own) if Arc::ptr_eq(own, source));
    let Some(degree) = chain.degree.checked_sub(chain.naming.shift).filter(|_| is_own) else {
        return Err(invalid(
            py,
            "the chain is not one of this model",
            "take chains of model.chain_complex(..)",
        ));
    };
    run(py, None, || {
        let terms = chain
            .terms
            .iter()
            .map(|(cell, x)| (coface::CellId::new(chain.naming.cell(chain.degree, cell.index())), x.clone()));
        let on_model = chains::Chain::new(source.chains()?, degree, terms)?;
        source.producer()?.mesh_with_chains(source.model.clone(), &[(name, on_model)], chain.is_cochain)
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
