//! Chains and cochains on the command line: as JSON, from files, as pictures.

use crate::failure::Failure;
use coface::algebra::Integer;
use coface::algebra::chains::{Chain, ChainComplex};
use coface::answers::answer::{ChainTerm, WholeNumber};
use coface::answers::{Pair, Producer, Term};
use coface::{CellId, Error};
use serde_json::Value;
use std::path::Path;

/// Names the cells of a chain complex made from a model: those that a pair keeps, if there is one, shifted by one
/// degree if the complex is augmented.
pub(crate) struct Naming<'a> {
    pub(crate) producer: &'a Producer,
    /// If the complex is one relative to a subcomplex.
    pub(crate) pair: Option<&'a Pair>,
    /// How many degrees the complex stands above the model: 1 for an augmented one.
    pub(crate) shift: usize,
}

impl Naming<'_> {
    /// A chain or cochain as `[[coefficient,[vertices..]],..]`.
    pub(crate) fn terms(&self, degree: usize, terms: &[(CellId, Integer)]) -> Vec<ChainTerm> {
        let term = |(cell, coefficient): &(CellId, Integer)| {
            let vertices = self.vertices(degree, cell.index()).into_iter().map(u64::from).collect();
            (WholeNumber::from(coefficient), vertices)
        };
        terms.iter().map(term).collect()
    }

    /// The number in the model of a cell of the complex.
    fn cell(&self, degree: usize, cell: usize) -> usize {
        self.pair.map_or(cell, |pair| pair.cell(degree, cell))
    }

    /// The name of a cell of the complex.
    pub(crate) fn vertices(&self, degree: usize, cell: usize) -> Vec<u32> {
        match degree.checked_sub(self.shift) {
            Some(degree) => self.producer.cell_vertices(degree, self.cell(degree, cell)),
            // The empty simplex, below all vertices.
            None => Vec::new(),
        }
    }

    /// The name of a cell of the complex, as people read it.
    pub(crate) fn word(&self, degree: usize, cell: usize) -> String {
        let vertices = self.vertices(degree, cell);
        if self.producer.names_cells_by_vertices() || degree < self.shift {
            let vertices: Vec<String> = vertices.iter().map(|vertex| format!("v{vertex}")).collect();
            return format!("{{{}}}", vertices.join(" "));
        }
        format!("{{cell {}}}", vertices[0])
    }

    /// A chain of the complex as one of the model.
    pub(crate) fn to_model(
        &self,
        whole: &ChainComplex,
        degree: usize,
        terms: &[(CellId, Integer)],
    ) -> Result<Chain<Integer>, Error> {
        let degree = degree - self.shift;
        let in_model =
            |(cell, x): &(CellId, Integer)| (CellId::new(self.cell(degree, cell.index())), x.clone());
        Chain::new(whole, degree, terms.iter().map(in_model))
    }

    /// A chain of the model as one of the complex; cells that the pair leaves out vanish.
    pub(crate) fn of_model(
        &self,
        complex: &ChainComplex,
        chain: &Chain<Integer>,
    ) -> Result<Chain<Integer>, Error> {
        let kept = |(cell, x): &(CellId, Integer)| {
            let position = match self.pair {
                Some(pair) => pair.position(chain.degree(), cell.index())?,
                None => cell.index(),
            };
            Some((CellId::new(position), x.clone()))
        };
        Chain::new(complex, chain.degree() + self.shift, chain.terms().iter().filter_map(kept))
    }
}

/// A chain as the user gives it.
pub(crate) struct GivenChain {
    pub(crate) degree: Option<usize>,
    pub(crate) terms: Vec<Term>,
}

impl GivenChain {
    /// From a file in JSON, or from text such as `"0 1; 1 2; -1*0 2"`.
    pub(crate) fn read(argument: &str) -> Result<Self, Failure> {
        let is_file = Path::new(argument).extension().is_some_and(|extension| extension == "json");
        if !is_file {
            return Self::from_text(argument);
        }
        let (degree, terms) = read_terms(Path::new(argument), |coefficient| match coefficient {
            Value::String(digits) => digits.parse().ok(),
            number => number.to_string().parse().ok(),
        })?;
        Ok(Self { degree, terms })
    }

    fn from_text(text: &str) -> Result<Self, Failure> {
        let fault = |word: &str| {
            Failure::new(format!(
                "{word:?} is no part of a chain; write cells by their vertices, as in \"0 1; 1 2; -1*0 2\", or name a .json file"
            ))
        };
        let mut terms = Vec::new();
        for part in text.split(';').map(str::trim).filter(|part| !part.is_empty()) {
            let (coefficient, cell) = part.split_once('*').unwrap_or(("1", part));
            let coefficient: Integer = coefficient.trim().parse().map_err(|_| fault(part))?;
            let words = cell.split([' ', ',', '\t']).filter(|word| !word.is_empty());
            let vertices: Vec<u32> = words
                .map(|word| word.strip_prefix('v').unwrap_or(word).parse().map_err(|_| fault(part)))
                .collect::<Result<_, _>>()?;
            if vertices.is_empty() {
                return Err(fault(part));
            }
            terms.push((coefficient, vertices));
        }
        Ok(Self { degree: None, terms })
    }
}

/// A degree, if it is given, and terms: a coefficient and the vertices of a cell.
pub(crate) type Terms<T> = (Option<usize>, Vec<(T, Vec<u32>)>);

/// Reads a chain or cochain from a file in JSON, `[[coefficient,[vertices..]],..]` or such a list under the key "chain"
/// beside a "degree".
pub(crate) fn read_terms<T>(
    path: &Path,
    coefficient: impl Fn(&Value) -> Option<T>,
) -> Result<Terms<T>, Failure> {
    let place = path.display();
    let how = "write a chain as [[coefficient,[vertices..]],..] or {\"degree\":1,\"chain\":[..]}";
    let fault = |what: String| Failure::new(format!("{place}: {what}; {how}"));
    let text = std::fs::read_to_string(path)
        .map_err(|error| Failure::new(format!("{place}: cannot be read: {error}")))?;
    let value: Value = serde_json::from_str(&text)
        .map_err(|error| Failure::new(format!("{place}:{}: {error}; {how}", error.line())))?;
    let list = value.get("chain").unwrap_or(&value);
    let list = list.as_array().ok_or_else(|| fault("there is no chain here".to_owned()))?;
    let degree = match value.get("degree") {
        None | Some(Value::Null) => None,
        Some(degree) => {
            Some(degree.as_u64().ok_or_else(|| fault(format!("{degree} is no degree")))? as usize)
        }
    };
    let term = |value: &Value| {
        let [first, vertices] = value.as_array()?.as_slice() else { return None };
        let vertices: Option<Vec<u32>> =
            vertices.as_array()?.iter().map(|vertex| u32::try_from(vertex.as_u64()?).ok()).collect();
        Some((coefficient(first)?, vertices?))
    };
    let mut terms = Vec::with_capacity(list.len());
    for (i, value) in list.iter().enumerate() {
        terms.push(term(value).ok_or_else(|| fault(format!("term {i} of the chain is {value}")))?);
    }
    Ok((degree, terms))
}
