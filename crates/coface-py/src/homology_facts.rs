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
pub(crate) struct ChainFacts {
    pub(crate) cell_count: usize,
    pub(crate) cells: Vec<usize>,
    pub(crate) chain: Vec<ChainTerm>,
    pub(crate) cochain: bool,
    pub(crate) degree: usize,
}

/// A generator in the words of the program, with the numbers of its cells.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct GeneratorFacts {
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub(crate) bounding: Option<Vec<ChainTerm>>,
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub(crate) bounding_cell_count: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub(crate) bounding_cells: Option<Vec<usize>>,
    pub(crate) cell_count: usize,
    pub(crate) cells: Vec<usize>,
    pub(crate) chain: Vec<ChainTerm>,
    pub(crate) cochain: bool,
    pub(crate) degree: usize,
    pub(crate) length: WholeNumber,
    /// 0 where it is infinite.
    pub(crate) order: WholeNumber,
}

/// A group in the words of the program, with what those leave out: the ring if it is not Z, and generators.
#[derive(Debug, Serialize, Deserialize)]
pub(crate) struct GroupFacts {
    pub(crate) betti: usize,
    #[serde(skip_serializing_if = "Option::is_none", default)]
    coefficients: Option<String>,
    #[serde(skip_serializing_if = "is_false", default)]
    pub(crate) cohomology: bool,
    pub(crate) degree: usize,
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub(crate) generators: Option<Vec<GeneratorFacts>>,
    torsion: Vec<WholeNumber>,
}

fn is_false(is: &bool) -> bool {
    !is
}

impl GroupFacts {
    pub(crate) fn of(
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

    pub(crate) fn group(&self) -> Result<AbelianGroup, Error> {
        let orders = self.torsion.iter().map(number).collect::<Result<Vec<_>, _>>()?;
        if let Some(order) = orders.iter().find(|order| order.signum() <= 0) {
            return Err(Error::invalid(format!("a cyclic part has the order {order}"))
                .with_cure("give orders from 2"));
        }
        Ok(AbelianGroup::new(self.betti, orders))
    }

    pub(crate) fn ring(&self) -> Result<Coefficients, Error> {
        self.coefficients.as_deref().map_or(Ok(Coefficients::Integers), str::parse)
    }
}

fn number(whole: &WholeNumber) -> Result<Integer, Error> {
    match whole {
        WholeNumber::Number(number) => Ok(Integer::from(*number)),
        WholeNumber::Digits(digits) => digits.parse(),
    }
}

pub(crate) fn integer_of(py: Python<'_>, whole: &WholeNumber) -> PyResult<Integer> {
    use crate::errors::OrRaise;
    number(whole).or_raise(py)
}

/// What a dictionary says.
pub(crate) fn read<T: DeserializeOwned>(py: Python<'_>, value: Value, what: &str) -> PyResult<T> {
    serde_json::from_value(value)
        .map_err(|fault| invalid(py, format!("this is not {what}: {fault}"), "give what to_dict() gave"))
}
