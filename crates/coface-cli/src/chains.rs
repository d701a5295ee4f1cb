//! Chains and cochains on the command line, as text and from files.

use crate::failure::Failure;
use coface::Error;
use coface::algebra::Integer;
use coface::answers::group_chain;
use coface::io::Model;
use serde_json::Value;
use std::path::Path;

/// A chain from a file in JSON, or from text such as `"0 1; 1 2; -1*0 2"`.
pub(crate) fn read_chain(argument: &str) -> Result<Terms<Integer>, Failure> {
    let is_file = Path::new(argument).extension().is_some_and(|extension| extension == "json");
    if !is_file {
        return chain_of_text(argument);
    }
    read_terms(Path::new(argument), |coefficient| match coefficient {
        Value::String(digits) => digits.parse().ok(),
        number => number.to_string().parse().ok(),
    })
}

/// The chain that a group of a mesh is, if there is one of this name.
pub(crate) fn chain_of_group(model: &Model, name: &str) -> Option<Terms<Integer>> {
    group_chain(model, name).map(|(degree, terms)| (Some(degree), terms))
}

fn chain_of_text(text: &str) -> Result<Terms<Integer>, Failure> {
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
    Ok((None, terms))
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
    let text =
        std::fs::read_to_string(path).map_err(|error| Error::from(error).in_file(place.to_string()))?;
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
