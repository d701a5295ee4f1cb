//! Parts of answers that were written as JSON.

use super::Layer;
use serde_json::Value;

/// The vertices of a cell, which have been [checked](super::answers::check) to be numbers.
pub(super) fn vertices(cell: &Value) -> Vec<u32> {
    cell.as_array()
        .into_iter()
        .flatten()
        .filter_map(|vertex| vertex.as_u64().and_then(|vertex| u32::try_from(vertex).ok()))
        .collect()
}

/// The list at a key, empty where there is none.
pub(super) fn array<'a>(value: &'a Value, key: &str) -> &'a [Value] {
    value[key].as_array().map_or(&[], Vec::as_slice)
}

/// The cells of a chain `[[coefficient, cell], ..]`; edges run backwards where the coefficient is negative.
pub(super) fn push_chain(layer: &mut Layer, chain: &Value) -> usize {
    let terms = chain.as_array().map_or(&[][..], Vec::as_slice);
    for term in terms {
        let is_negative = match &term[0] {
            Value::String(digits) => digits.starts_with('-'),
            number => number.as_f64().is_some_and(|number| number < 0.0),
        };
        layer.push_term(&vertices(&term[1]), is_negative);
    }
    terms.len()
}
