//! What questions are put to: a model with its cells identified, made once.

use coface::algebra::Integer;
use coface::algebra::chains::ChainComplex;
use coface::answers::{Pair, Producer};
use coface::complexes::simplicial::FrozenComplex;
use coface::io::{Model, Structure};
use coface::{CellId, Error};
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

    /// The ends of an edge of a chain complex with positions, the one that it starts from first; nothing for other cells, and other models.
    fn edge_ends(&self, degree: usize, edge: usize) -> Option<Vec<u32>> {
        if degree != 1 || !self.has_named_edges() {
            return None;
        }
        let boundary = self.chains().ok()?.boundary_matrix(1)?;
        let mut ends: Vec<(i32, u32)> =
            boundary.column(edge).iter().map(|(row, sign)| (sign, row as u32)).collect();
        ends.sort_unstable();
        match ends[..] {
            [(-1, start), (1, end)] => Some(vec![start, end]),
            _ => None,
        }
    }

    /// Whether edges of its chain complex are named by their ends, though the model lists no cells by vertices.
    pub(crate) fn has_named_edges(&self) -> bool {
        matches!(self.model.structure(), Some(Structure::Chains(_))) && !self.model.positions().is_empty()
    }

    /// The edges between these vertices, with their signs; nothing where one is none, or two are.
    pub(crate) fn edges_between(&self, named: &[(Integer, Vec<u32>)]) -> Option<Vec<(CellId, Integer)>> {
        let count = self.chains().ok()?.cell_count(1);
        let ends: Vec<_> = (0..count).map(|edge| self.edge_ends(1, edge)).collect();
        let mut of: BTreeMap<[u32; 2], Option<usize>> = BTreeMap::new();
        for (edge, ends) in ends.iter().enumerate() {
            if let Some([start, end]) = ends.as_deref() {
                let pair = [*start.min(end), *start.max(end)];
                of.entry(pair).and_modify(|known| *known = None).or_insert(Some(edge));
            }
        }
        let term = |(coefficient, vertices): &(Integer, Vec<u32>)| {
            let &[start, end] = &vertices[..] else { return None };
            let edge = (*of.get(&[start.min(end), start.max(end)])?)?;
            let is_along = ends[edge].as_deref() == Some(&[start, end]);
            Some((CellId::new(edge), if is_along { coefficient.clone() } else { -coefficient }))
        };
        named.iter().map(term).collect()
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
            Names::Source(source) => source.edge_ends(degree, number).unwrap_or_else(|| {
                source.producer().map_or_else(
                    |_| vec![number as u32],
                    |made| made.cell_vertices(degree, coface::CellId::new(number)),
                )
            }),
            Names::Simplices(complex) => complex.numbers(degree, number).to_vec(),
            Names::Given(names) => names.get(&(degree, number)).cloned().unwrap_or(vec![number as u32]),
        }
    }
}
