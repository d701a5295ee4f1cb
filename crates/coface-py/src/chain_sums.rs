//! Sums and multiples of chains, and the values of cochains on chains.

use crate::chain::{Chain, Generator};
use crate::errors::{invalid, wrong_type};
use crate::source::{Names, Naming};
use coface::CellId;
use coface::algebra::Integer;
use pyo3::prelude::*;
use std::collections::BTreeMap;
use std::sync::Arc;

/// The chain that this is, or that a generator has.
pub(crate) fn chain_of<'a>(value: &'a Bound<'_, PyAny>) -> Option<&'a Chain> {
    match value.cast::<Chain>() {
        Ok(chain) => Some(chain.get()),
        Err(_) => value.cast::<Generator>().ok().map(|generator| generator.get().chain.get()),
    }
}

/// Whether this is the number 0, which is the zero of all chains.
pub(crate) fn is_zero(value: &Bound<'_, PyAny>) -> bool {
    value.hasattr("__index__").unwrap_or(false) && value.extract::<i64>().is_ok_and(|number| number == 0)
}

/// Whether two chains are known to be of different models.
fn are_apart(one: &Naming, other: &Naming) -> bool {
    let is_other_part = one.shift != other.shift || one.pair.is_some() != other.pair.is_some();
    is_other_part
        || match (&one.names, &other.names) {
            (Names::Source(a), Names::Source(b)) => !Arc::ptr_eq(a, b) && a.model != b.model,
            (Names::Simplices(a), Names::Simplices(b)) => !Arc::ptr_eq(a, b) && a.thaw() != b.thaw(),
            _ => false,
        }
}

/// The names of the cells of two chains.
fn joined(one: &Arc<Naming>, other: &Naming) -> Arc<Naming> {
    match (&one.names, &other.names) {
        (Names::Given(a), Names::Given(b)) => {
            let mut names = a.as_ref().clone();
            names.extend(b.iter().map(|(cell, list)| (*cell, list.clone())));
            Arc::new(Naming { names: Names::Given(Arc::new(names)), ..one.as_ref().clone() })
        }
        _ => Arc::clone(one),
    }
}

impl Chain {
    /// This chain plus a multiple of another one of the same complex.
    pub(crate) fn plus(&self, py: Python<'_>, other: &Self, factor: &Integer) -> PyResult<Self> {
        if self.is_cochain != other.is_cochain {
            let cure = "add chains to chains and cochains to cochains; cochain @ chain is the value";
            return Err(wrong_type(py, "a chain and a cochain have no sum", cure));
        }
        self.refuse_other(py, other, "have no sum")?;
        let mut sum: BTreeMap<CellId, Integer> = self.terms.iter().cloned().collect();
        for (cell, coefficient) in &other.terms {
            *sum.entry(*cell).or_insert(Integer::ZERO) += &(coefficient * factor);
        }
        let terms = sum.into_iter().filter(|(_, coefficient)| !coefficient.is_zero()).collect();
        let naming = joined(&self.naming, &other.naming);
        Ok(Self { terms, naming, ..self.like() })
    }

    /// A multiple of the chain.
    pub(crate) fn times(&self, factor: &Integer) -> Self {
        let terms = match factor.is_zero() {
            true => Vec::new(),
            false => self.terms.iter().map(|(cell, coefficient)| (*cell, coefficient * factor)).collect(),
        };
        Self { terms, ..self.like() }
    }

    /// The value of a cochain on a chain of the same degree and complex.
    pub(crate) fn on(&self, py: Python<'_>, chain: &Self) -> PyResult<Integer> {
        if !self.is_cochain || chain.is_cochain {
            let what =
                if self.is_cochain { "a cochain has no value on a cochain" } else { "a chain has no values" };
            return Err(wrong_type(py, what, "ask a cochain for its value on a chain: cochain.value(chain)"));
        }
        self.refuse_other(py, chain, "do not pair")?;
        let of: BTreeMap<CellId, &Integer> = self.terms.iter().map(|(cell, x)| (*cell, x)).collect();
        let mut value = Integer::ZERO;
        for (cell, coefficient) in &chain.terms {
            if let Some(&x) = of.get(cell) {
                value += &(x * coefficient);
            }
        }
        Ok(value)
    }

    fn refuse_other(&self, py: Python<'_>, other: &Self, fault: &str) -> PyResult<()> {
        if self.degree != other.degree {
            let message = format!("chains of degrees {} and {} {fault}", self.degree, other.degree);
            return Err(invalid(py, message, "give chains of one degree"));
        }
        if self.cell_count != other.cell_count || are_apart(&self.naming, &other.naming) {
            return Err(invalid(
                py,
                format!("chains of two complexes {fault}"),
                "give chains of one complex",
            ));
        }
        Ok(())
    }

    /// The same without terms.
    fn like(&self) -> Self {
        Self {
            degree: self.degree,
            terms: Vec::new(),
            cell_count: self.cell_count,
            naming: Arc::clone(&self.naming),
            is_cochain: self.is_cochain,
        }
    }
}
