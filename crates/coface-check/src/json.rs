//! Values of JSON as the checkers want them.

use crate::Fault;
use dashu_int::IBig;
use serde_json::Value;

/// The value under a key.
///
/// # Errors
/// A [`Fault`] of this step if the key is missing.
///
/// # Examples
/// ```
/// use coface_check::json::{field, index, list};
/// # fn main() -> Result<(), coface_check::Fault> {
/// let value = serde_json::json!({"cells": [3, 3]});
/// let cells = list(field(&value, "cells", "proof")?, "\"cells\"", "proof")?;
/// assert_eq!(index(&cells[0], "a number of cells", "proof")?, 3);
/// assert!(field(&value, "pairs", "proof").is_err());
/// # Ok(()) }
/// ```
pub fn field<'a>(value: &'a Value, key: &str, step: &str) -> Result<&'a Value, Fault> {
    value.get(key).ok_or_else(|| Fault::new(step, format!("the key {key:?} is missing")))
}

/// The value under a key, unless it is null or not there.
///
/// # Examples
/// ```
/// assert!(coface_check::json::optional(&serde_json::json!({"rule": null}), "rule").is_none());
/// ```
pub fn optional<'a>(value: &'a Value, key: &str) -> Option<&'a Value> {
    value.get(key).filter(|value| !value.is_null())
}

/// Text.
///
/// # Errors
/// A [`Fault`] of this step that names what the value should be.
///
/// # Examples
/// See [`field`].
pub fn text<'a>(value: &'a Value, what: &str, step: &str) -> Result<&'a str, Fault> {
    value.as_str().ok_or_else(|| Fault::new(step, format!("{what} is {}, not text", short(value))))
}

/// True or false.
///
/// # Errors
/// A [`Fault`] of this step that names what the value should be.
///
/// # Examples
/// See [`field`].
pub fn truth(value: &Value, what: &str, step: &str) -> Result<bool, Fault> {
    value.as_bool().ok_or_else(|| Fault::new(step, format!("{what} is {}, not true or false", short(value))))
}

/// A list.
///
/// # Errors
/// A [`Fault`] of this step that names what the value should be.
///
/// # Examples
/// See [`field`].
pub fn list<'a>(value: &'a Value, what: &str, step: &str) -> Result<&'a [Value], Fault> {
    value
        .as_array()
        .map(Vec::as_slice)
        .ok_or_else(|| Fault::new(step, format!("{what} is {}, not a list", short(value))))
}

/// A number of a cell, a vertex or a row.
///
/// # Errors
/// A [`Fault`] of this step that names what the value should be.
///
/// # Examples
/// See [`field`].
pub fn index(value: &Value, what: &str, step: &str) -> Result<u32, Fault> {
    let number = value.as_u64().and_then(|number| u32::try_from(number).ok());
    number.ok_or_else(|| Fault::new(step, format!("{what} is {}, not a number from 0", short(value))))
}

/// An integer: a number of 64 bits, or the decimal digits of a larger one.
///
/// # Errors
/// A [`Fault`] of this step that names what the value should be.
///
/// # Examples
/// See [`field`].
pub fn integer(value: &Value, what: &str, step: &str) -> Result<IBig, Fault> {
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
