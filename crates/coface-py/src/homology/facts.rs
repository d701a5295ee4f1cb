//! Groups, chains and generators as they are written to dictionaries and read back.

use crate::errors::invalid;
use coface::Error;
use coface::algebra::Integer;
use coface::answers::answer::{ChainTerm, WholeNumber};
use coface::topology::{AbelianGroup, Coefficients};
use pyo3::prelude::*;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use serde_json::Value;

/// A chain or cochain: its cells by number, and its terms by vertices.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct ChainFacts {
    pub(super) cell_count: usize,
    pub(super) cells: Vec<usize>,
    pub(super) chain: Vec<ChainTerm>,
    pub(super) cochain: bool,
    pub(super) degree: usize,
}

/// A generator in the words of the program, with the numbers of its cells.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct GeneratorFacts {
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub(super) bounding: Option<Vec<ChainTerm>>,
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub(super) bounding_cell_count: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub(super) bounding_cells: Option<Vec<usize>>,
    pub(super) cell_count: usize,
    pub(super) cells: Vec<usize>,
    pub(super) chain: Vec<ChainTerm>,
    pub(super) cochain: bool,
    pub(super) degree: usize,
    pub(super) length: WholeNumber,
    /// 0 where it is infinite.
    pub(super) order: WholeNumber,
}

/// A group in the words of the program, with what those leave out: the ring if it is not Z, and generators.
#[derive(Debug, Serialize, Deserialize)]
pub(super) struct GroupFacts {
    pub(super) betti: usize,
    #[serde(skip_serializing_if = "Option::is_none", default)]
    coefficients: Option<String>,
    #[serde(skip_serializing_if = "is_false", default)]
    pub(super) cohomology: bool,
    pub(super) degree: usize,
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub(super) generators: Option<Vec<GeneratorFacts>>,
    torsion: Vec<WholeNumber>,
}

fn is_false(is: &bool) -> bool {
    !is
}

impl GroupFacts {
    pub(super) fn of(
        degree: usize,
        group: &AbelianGroup,
        ring: Coefficients,
        cohomology: bool,
        generators: Vec<GeneratorFacts>,
    ) -> Self {
        Self {
            betti: group.betti(),
            coefficients: (ring != Coefficients::Integers).then(|| ring.to_string()),
            cohomology,
            degree,
            generators: (!generators.is_empty()).then_some(generators),
            torsion: group.torsion().iter().map(WholeNumber::from).collect(),
        }
    }

    pub(super) fn group(&self) -> Result<AbelianGroup, Error> {
        let orders = self.torsion.iter().map(number).collect::<Result<Vec<_>, _>>()?;
        if let Some(order) = orders.iter().find(|order| order.signum() <= 0) {
            return Err(Error::invalid(format!("a cyclic part has the order {order}"))
                .with_cure("give orders from 2"));
        }
        Ok(AbelianGroup::new(self.betti, orders))
    }

    pub(super) fn ring(&self) -> Result<Coefficients, Error> {
        self.coefficients.as_deref().map_or(Ok(Coefficients::Integers), str::parse)
    }
}

fn number(whole: &WholeNumber) -> Result<Integer, Error> {
    match whole {
        WholeNumber::Number(number) => Ok(Integer::from(*number)),
        WholeNumber::Digits(digits) => digits.parse(),
    }
}

pub(super) fn integer_of(py: Python<'_>, whole: &WholeNumber) -> PyResult<Integer> {
    use crate::errors::OrRaise;
    number(whole).or_raise(py)
}

/// What a dictionary says.
pub(super) fn read<T: DeserializeOwned>(py: Python<'_>, value: Value, what: &str) -> PyResult<T> {
    serde_json::from_value(value)
        .map_err(|fault| invalid(py, format!("this is not {what}: {fault}"), "give what to_dict() gave"))
}
