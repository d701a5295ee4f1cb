//! What questions are put to: a model with its cells identified, made once.

use coface::Error;
use coface::algebra::chains::ChainComplex;
use coface::answers::{Pair, Producer};
use coface::complexes::simplicial::FrozenComplex;
use coface::io::Model;
use std::collections::BTreeMap;
use std::sync::{Arc, OnceLock};

/// A model, and what is made of it when somebody asks.
#[derive(Debug)]
pub(crate) struct Source {
    pub(crate) model: Model,
    producer: OnceLock<Producer>,
    chains: OnceLock<Arc<ChainComplex>>,
}

/// What was made before, or what is made now.
fn once<T>(place: &OnceLock<T>, make: impl FnOnce() -> Result<T, Error>) -> Result<&T, Error> {
    if let Some(made) = place.get() {
        return Ok(made);
    }
    let made = make()?;
    Ok(place.get_or_init(|| made))
}

impl Source {
    pub(crate) fn new(model: Model) -> Arc<Self> {
        Arc::new(Self { model, producer: OnceLock::new(), chains: OnceLock::new() })
    }

    /// The cells of the model, with their names.
    pub(crate) fn producer(&self) -> Result<&Producer, Error> {
        once(&self.producer, || Producer::of(self.model.clone()))
    }

    pub(crate) fn chains(&self) -> Result<&Arc<ChainComplex>, Error> {
        once(&self.chains, || Ok(Arc::new(self.producer()?.chain_complex()?)))
    }
}

/// What the cells of a chain complex are called.
#[derive(Clone, Debug)]
pub(crate) enum Names {
    /// By their own numbers.
    Own,
    /// By the vertices that the model says.
    Source(Arc<Source>),
    /// By the vertices of the simplices.
    Simplices(Arc<FrozenComplex>),
    /// By what was written of the cells of each degree.
    Given(Arc<BTreeMap<(usize, usize), Vec<u32>>>),
}

/// Names the cells of a chain complex: those that a pair keeps, if there is one, shifted by one degree if the complex is augmented.
#[derive(Clone, Debug)]
pub(crate) struct Naming {
    pub(crate) names: Names,
    pub(crate) pair: Option<Arc<Pair>>,
    /// How many degrees the complex stands above the model: 1 for an augmented one.
    pub(crate) shift: usize,
}

impl Naming {
    pub(crate) fn of(names: Names) -> Self {
        Self { names, pair: None, shift: 0 }
    }

    /// The model whose vertices name the cells, if there is one.
    pub(crate) fn model(&self) -> Option<crate::model::Model> {
        match &self.names {
            Names::Source(source) => Some(crate::model::Model { source: Arc::clone(source) }),
            Names::Simplices(complex) => {
                Some(crate::model::Model::of(crate::complex::Complex::of(complex.thaw()).to_model()))
            }
            Names::Own | Names::Given(_) => None,
        }
    }

    /// The number in the model of a cell of the complex.
    pub(crate) fn cell(&self, degree: usize, cell: usize) -> usize {
        match degree.checked_sub(self.shift) {
            Some(degree) => {
                self.pair.as_ref().map_or(cell, |pair| pair.cell(degree, coface::CellId::new(cell)).index())
            }
            None => cell,
        }
    }

    /// The vertices of a cell of the complex; its own number where cells have no vertices.
    pub(crate) fn vertices(&self, degree: usize, cell: usize) -> Vec<u32> {
        let number = self.cell(degree, cell);
        let Some(degree) = degree.checked_sub(self.shift) else { return Vec::new() };
        match &self.names {
            Names::Own => vec![number as u32],
            // A complex with names was made by the producer.
            Names::Source(source) => source.producer().map_or_else(
                |_| vec![number as u32],
                |made| made.cell_vertices(degree, coface::CellId::new(number)),
            ),
            Names::Simplices(complex) => complex.numbers(degree, number).to_vec(),
            Names::Given(names) => names.get(&(degree, number)).cloned().unwrap_or(vec![number as u32]),
        }
    }
}
