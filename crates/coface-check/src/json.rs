//! Values of JSON as the checkers want them.

use crate::Fault;
use dashu_int::IBig;
use serde::de::{Deserialize, Deserializer, Error, MapAccess, SeqAccess, Visitor};
use serde_json::{Map, Number, Value};
use std::fmt;

/// The value that a text is. An object that has a key twice is none: a reader may take the one, and a checker the other.
///
/// # Errors
/// A [`Fault`] of this step that names the line.
///
/// # Examples
/// ```
/// use coface_check::json::parsed;
/// assert_eq!(parsed(br#"{"a": [1, {"b": 2}]}"#, "input").expect("JSON")["a"][1]["b"], 2);
/// let fault = parsed(br#"{"a": 1, "a": 2}"#, "input").expect_err("which one?");
/// assert!(fault.to_string().contains("the key \"a\" stands twice"));
/// ```
pub fn parsed(text: &[u8], step: &str) -> Result<Value, Fault> {
    serde_json::from_slice(text)
        .map(|Single(value)| value)
        .map_err(|error| Fault::new(step, format!("this is not one value of JSON: {error}")))
}

/// A value in which no object has a key twice.
struct Single(Value);

impl<'de> Deserialize<'de> for Single {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(OfSingle).map(Self)
    }
}

struct OfSingle;

impl<'de> Visitor<'de> for OfSingle {
    type Value = Value;

    fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str("a value of JSON")
    }

    fn visit_unit<E>(self) -> Result<Value, E> {
        Ok(Value::Null)
    }

    fn visit_bool<E>(self, truth: bool) -> Result<Value, E> {
        Ok(truth.into())
    }

    fn visit_i64<E>(self, number: i64) -> Result<Value, E> {
        Ok(number.into())
    }

    fn visit_u64<E>(self, number: u64) -> Result<Value, E> {
        Ok(number.into())
    }

    fn visit_f64<E: Error>(self, number: f64) -> Result<Value, E> {
        Number::from_f64(number).map(Value::Number).ok_or_else(|| E::custom("a number is not finite"))
    }

    fn visit_str<E>(self, text: &str) -> Result<Value, E> {
        Ok(text.into())
    }

    fn visit_string<E>(self, text: String) -> Result<Value, E> {
        Ok(text.into())
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut access: A) -> Result<Value, A::Error> {
        let mut items = Vec::new();
        while let Some(Single(item)) = access.next_element()? {
            items.push(item);
        }
        Ok(items.into())
    }

    fn visit_map<A: MapAccess<'de>>(self, mut access: A) -> Result<Value, A::Error> {
        let mut items = Map::new();
        while let Some((key, Single(item))) = access.next_entry::<String, _>()? {
            if items.contains_key(&key) {
                return Err(A::Error::custom(format!("the key {key:?} stands twice")));
            }
            items.insert(key, item);
        }
        Ok(items.into())
    }
}

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
