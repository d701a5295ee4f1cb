//! Values of JSON as the checker wants them.

use crate::Fault;
use dashu_int::IBig;
use serde_json::Value;

/// The value under a key.
pub(crate) fn field<'a>(value: &'a Value, key: &str, step: &str) -> Result<&'a Value, Fault> {
    value.get(key).ok_or_else(|| Fault::new(step, format!("the key {key:?} is missing")))
}

/// The value under a key, unless it is null or not there.
pub(crate) fn optional<'a>(value: &'a Value, key: &str) -> Option<&'a Value> {
    value.get(key).filter(|value| !value.is_null())
}

pub(crate) fn text<'a>(value: &'a Value, what: &str, step: &str) -> Result<&'a str, Fault> {
    value.as_str().ok_or_else(|| Fault::new(step, format!("{what} is {}, not text", short(value))))
}

pub(crate) fn truth(value: &Value, what: &str, step: &str) -> Result<bool, Fault> {
    value.as_bool().ok_or_else(|| Fault::new(step, format!("{what} is {}, not true or false", short(value))))
}

pub(crate) fn list<'a>(value: &'a Value, what: &str, step: &str) -> Result<&'a [Value], Fault> {
    value
        .as_array()
        .map(Vec::as_slice)
        .ok_or_else(|| Fault::new(step, format!("{what} is {}, not a list", short(value))))
}

/// A number of a cell, a vertex or a row.
pub(crate) fn index(value: &Value, what: &str, step: &str) -> Result<u32, Fault> {
    let number = value.as_u64().and_then(|number| u32::try_from(number).ok());
    number.ok_or_else(|| Fault::new(step, format!("{what} is {}, not a number from 0", short(value))))
}

/// An integer: a number of 64 bits, or the decimal digits of a larger one.
pub(crate) fn integer(value: &Value, what: &str, step: &str) -> Result<IBig, Fault> {
    let digits = |text: &str| {
        let plain = text.strip_prefix('-').unwrap_or(text);
        let is_number = !plain.is_empty() && plain.bytes().all(|byte| byte.is_ascii_digit());
        is_number.then(|| text.parse::<IBig>().ok()).flatten()
    };
    let found = match value {
        Value::Number(number) => number.as_i64().map(IBig::from),
        Value::String(text) => digits(text),
        _ => None,
    };
    found.ok_or_else(|| Fault::new(step, format!("{what} is {}, not an integer", short(value))))
}

/// A value for a message, of a length that fits there.
fn short(value: &Value) -> String {
    let whole = match value {
        Value::Array(items) => return format!("a list of {} values", items.len()),
        Value::Object(_) => return "an object".to_owned(),
        other => other.to_string(),
    };
    match whole.char_indices().nth(40) {
        Some((end, _)) => format!("{}..", &whole[..end]),
        None => whole,
    }
}
