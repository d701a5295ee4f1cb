//! Models from the library, and what users give as models.

use crate::chain_complex::ChainComplex;
use crate::complex::Complex;
use crate::errors::invalid;
use crate::model::Model;
use crate::source::Source;
use coface::io::{self, Structure};
use pyo3::prelude::*;
use std::sync::Arc;

impl Model {
    pub(crate) fn of(model: io::Model) -> Self {
        Self { source: Source::new(model) }
    }

    pub(crate) fn model(&self) -> &io::Model {
        &self.source.model
    }
}

/// The model behind what users give as one: a model, a simplicial complex or a chain complex.
pub(crate) fn source_of(value: &Bound<'_, PyAny>) -> PyResult<Arc<Source>> {
    let py = value.py();
    if let Ok(model) = value.cast::<Model>() {
        return Ok(Arc::clone(&model.get().source));
    }
    if let Ok(complex) = value.cast::<Complex>() {
        return Ok(Source::new(complex.get().to_model()));
    }
    if let Ok(complex) = value.cast::<ChainComplex>() {
        let complex = complex.get().complex.as_ref().clone();
        return Ok(Source::new(io::Model::from_structure(Structure::Chains(complex))));
    }
    let name = value.get_type().name()?;
    Err(invalid(py, format!("a {name} is no model"), "give a Model, a Complex or a ChainComplex"))
}
