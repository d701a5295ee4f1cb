//! Properties of features: the text of a JSON object.

use crate::drawing::Drawing;
use crate::json_text::compact;
use coface_algebra::Error;
use serde::de::{Deserialize, DeserializeSeed, Deserializer, IgnoredAny, MapAccess, Visitor};
use serde_json::value::RawValue;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

/// Values are compared part by part so deep, and as text below.
const DEEPEST: usize = 64;

/// The name that a value is: a text or a number.
fn name_of(value: &serde_json::Value) -> Option<String> {
    match value {
        serde_json::Value::String(name) => Some(name.clone()),
        serde_json::Value::Number(number) => Some(number.to_string()),
        _ => None,
    }
}

/// What a file says of a feature beside its geometry.
#[derive(Debug, Default)]
pub(super) struct Description {
    /// The properties, as [`compact`] writes them; empty if there are none.
    properties: String,
    /// The id as JSON; empty if there is none.
    id: String,
    /// The property `name`.
    name: Option<String>,
    id_name: Option<String>,
}

impl Description {
    /// Takes in what stands under `"properties"`.
    ///
    /// # Errors
    /// What is wrong if that is neither an object nor null, or if its name is nested too deep.
    pub(super) fn set_properties(&mut self, value: &RawValue) -> Result<(), String> {
        self.name = name_in(value.get())?;
        self.properties = compact(value.get());
        if matches!(&self.properties[..], "{}" | "null") {
            self.properties.clear();
        }
        Ok(())
    }

    /// Takes in what stands under `"id"`: it is one if it is a text or a number.
    pub(super) fn set_id(&mut self, value: &RawValue) {
        self.id_name = serde_json::from_str(value.get()).ok().as_ref().and_then(name_of);
        self.id = self.id_name.as_ref().map_or(String::new(), |_| compact(value.get()));
    }

    /// What the feature is called: by its properties, or else by its id.
    pub(super) fn name(&self) -> Option<&str> {
        self.name.as_ref().or(self.id_name.as_ref()).map(String::as_str)
    }

    /// What is drawn next is of this feature.
    pub(super) fn begin(&self, drawing: &mut Drawing) {
        drawing.begin_described(self.name(), &self.properties, &self.id);
    }
}

/// The property `name`, in any case, of properties that may be null.
///
/// # Errors
/// What is wrong if they are neither an object nor null, or if the name is nested too deep.
pub(super) fn name_in(properties: &str) -> Result<Option<String>, String> {
    NameIn.deserialize(&mut serde_json::Deserializer::from_str(properties)).map_err(|error| {
        let place = format!(" at line {} column {}", error.line(), error.column());
        let text = error.to_string();
        text.strip_suffix(&place).unwrap_or(&text).to_owned()
    })
}

struct NameIn;

impl<'de> DeserializeSeed<'de> for NameIn {
    type Value = Option<String>;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Self::Value, D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for NameIn {
    type Value = Option<String>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("properties, an object or null")
    }

    fn visit_unit<E: serde::de::Error>(self) -> Result<Self::Value, E> {
        Ok(None)
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
        let mut name = None;
        while let Some(key) = map.next_key::<String>()? {
            if name.is_none() && key.eq_ignore_ascii_case("name") {
                name = name_of(&map.next_value()?);
            } else {
                map.next_value::<IgnoredAny>()?;
            }
        }
        Ok(name)
    }
}

/// The keys of an object with the texts of their values, in the order of the object.
pub(super) struct Pairs<'a>(pub(super) Vec<(String, &'a RawValue)>);

impl<'de: 'a, 'a> Deserialize<'de> for Pairs<'a> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct OfObject;
        impl<'de> Visitor<'de> for OfObject {
            type Value = Vec<(String, &'de RawValue)>;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("an object")
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
                let mut pairs = Vec::new();
                while let Some(pair) = map.next_entry()? {
                    pairs.push(pair);
                }
                Ok(pairs)
            }
        }
        deserializer.deserialize_map(OfObject).map(Self)
    }
}

/// The properties of something that several features contain.
///
/// A key that one feature has keeps its value, and so does a key of which all values are equal. A key with different
/// values has the list of them, each once, in the order in which the features were added; a value that is a list
/// counts as one value. Keys stand in the order in which they came. Numbers are equal by value, objects whatever the
/// order of their keys is.
///
/// # Examples
/// ```
/// use coface_io::geojson::MergedProperties;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let mut merged = MergedProperties::default();
/// merged.add(r#"{"zone":"A","year":2020,"owner":null}"#)?;
/// merged.add(r#"{"zone":"B","year":2020.0}"#)?;
/// assert_eq!(merged.to_string(), r#"{"zone":["A","B"],"year":2020,"owner":null}"#);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, Default)]
pub struct MergedProperties<'a> {
    keys: Vec<Key<'a>>,
    /// The place of each key in the list.
    places: BTreeMap<String, usize>,
}

#[derive(Clone, Debug)]
struct Key<'a> {
    name: String,
    values: Vec<&'a str>,
    /// What equal values have in common, once there are several.
    known: BTreeSet<String>,
}

impl<'a> MergedProperties<'a> {
    /// Adds the properties of one more feature, the text of a JSON object.
    ///
    /// # Errors
    /// [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) if the text is no JSON object.
    ///
    /// # Examples
    /// ```
    /// use coface_io::geojson::MergedProperties;
    /// let mut merged = MergedProperties::default();
    /// assert!(merged.add("{}").is_ok() && merged.add("[1]").is_err());
    /// assert_eq!(merged.to_string(), "{}");
    /// ```
    pub fn add(&mut self, properties: &'a str) -> Result<(), Error> {
        let pairs: Pairs<'a> = serde_json::from_str(properties).map_err(|error| {
            Error::parse(format!("properties are no JSON object: {error}"))
                .with_cure("give the text of an object, such as {\"height\": 7}")
        })?;
        for (name, value) in pairs.0 {
            match self.places.get(&name) {
                Some(&place) => self.keys[place].add(value.get()),
                None => {
                    self.places.insert(name.clone(), self.keys.len());
                    self.keys.push(Key { name, values: vec![value.get()], known: BTreeSet::new() });
                }
            }
        }
        Ok(())
    }

    /// Leaves a key out, if it is there.
    ///
    /// # Examples
    /// ```
    /// use coface_io::geojson::MergedProperties;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mut merged = MergedProperties::default();
    /// merged.add(r#"{"area":3,"use":"wood"}"#)?;
    /// merged.remove("area");
    /// assert_eq!(merged.to_string(), r#"{"use":"wood"}"#);
    /// # Ok(()) }
    /// ```
    pub fn remove(&mut self, key: &str) {
        if let Some(place) = self.places.remove(key) {
            self.keys.remove(place);
            self.places.values_mut().filter(|other| **other > place).for_each(|other| *other -= 1);
        }
    }
}

impl fmt::Display for MergedProperties<'_> {
    /// The text of a JSON object.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("{")?;
        for (i, key) in self.keys.iter().enumerate() {
            let comma = if i > 0 { "," } else { "" };
            write!(f, "{comma}{}:", serde_json::Value::from(&key.name[..]))?;
            match key.values[..] {
                [value] => f.write_str(value)?,
                _ => write!(f, "[{}]", key.values.join(","))?,
            }
        }
        f.write_str("}")
    }
}

impl<'a> Key<'a> {
    fn add(&mut self, value: &'a str) {
        if self.values[..] == [value] {
            return;
        }
        if self.known.is_empty() {
            self.known.insert(canonical(self.values[0], 0));
        }
        if self.known.insert(canonical(value, 0)) {
            self.values.push(value);
        }
    }
}

/// A text that is the same for equal values.
pub(super) fn canonical(value: &str, depth: usize) -> String {
    let of_parts = |value: &str| -> Option<String> {
        match value.as_bytes().first()? {
            b'{' if depth < DEEPEST => {
                let pairs: Pairs<'_> = serde_json::from_str(value).ok()?;
                // Of keys that stand there twice the last counts.
                let pairs: BTreeMap<_, _> = pairs.0.into_iter().collect();
                let pair = |(key, value): (&String, &&RawValue)| {
                    format!("{}:{}", serde_json::Value::from(&key[..]), canonical(value.get(), depth + 1))
                };
                Some(format!("{{{}}}", pairs.iter().map(pair).collect::<Vec<_>>().join(",")))
            }
            b'[' if depth < DEEPEST => {
                let parts: Vec<&RawValue> = serde_json::from_str(value).ok()?;
                let parts: Vec<String> = parts.iter().map(|part| canonical(part.get(), depth + 1)).collect();
                Some(format!("[{}]", parts.join(",")))
            }
            b'"' => Some(serde_json::from_str::<serde_json::Value>(value).ok()?.to_string()),
            b'-' | b'0'..=b'9' => {
                let number: f64 = value.parse().ok()?;
                let is_short = number.abs() < 2f64.powi(53);
                match number.fract() == 0.0 {
                    true if is_short => Some((number as i64).to_string()),
                    // Whole numbers with more digits than a floating-point number holds.
                    true if value.bytes().all(|c| c == b'-' || c.is_ascii_digit()) => None,
                    _ => Some(number.to_string()),
                }
            }
            _ => None,
        }
    };
    of_parts(value).unwrap_or_else(|| value.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::Value;

    fn merged(list: &[&str]) -> String {
        let mut merged = MergedProperties::default();
        list.iter().for_each(|properties| merged.add(properties).unwrap());
        let text = merged.to_string();
        assert!(serde_json::from_str::<Value>(&text).is_ok(), "{text}");
        text
    }

    #[test]
    fn equal_values_stay_and_different_ones_are_a_list() {
        assert_eq!(merged(&[]), "{}");
        assert_eq!(merged(&[r#"{"b":1,"a":2}"#]), r#"{"b":1,"a":2}"#);
        assert_eq!(merged(&[r#"{"a":1}"#, r#"{"b":2}"#, r#"{"a":1}"#]), r#"{"a":1,"b":2}"#);
        assert_eq!(merged(&[r#"{"a":"x"}"#, r#"{"a":"y"}"#, r#"{"a":"x"}"#]), r#"{"a":["x","y"]}"#);
        assert_eq!(merged(&[r#"{"a":null}"#, r#"{"a":0}"#, r#"{}"#]), r#"{"a":[null,0]}"#);
        // A list is one value.
        assert_eq!(merged(&[r#"{"c":[255,0]}"#, r#"{"c":[0,255]}"#]), r#"{"c":[[255,0],[0,255]]}"#);
        assert_eq!(merged(&[r#"{"c":[1,2]}"#, r#"{"c":[1,2]}"#]), r#"{"c":[1,2]}"#);
        // Quotation marks in keys.
        assert_eq!(merged(&[r#"{"a\"":1}"#, r#"{"a\u0022":2}"#]), r#"{"a\"":[1,2]}"#);
    }

    #[test]
    fn values_are_equal_whatever_they_are_written_like() {
        for equal in [
            ["1", "1.0"],
            ["100", "1e2"],
            ["0.1", "1E-1"],
            ["0", "-0"],
            [r#""ü""#, r#""\u00fc""#],
            [r#"{"a":1,"b":[2,{}]}"#, r#"{"b":[2.0,{}],"a":1}"#],
        ] {
            let texts = equal.map(|value| format!("{{\"k\":{value}}}"));
            assert_eq!(merged(&[&texts[0], &texts[1]]), texts[0], "{equal:?}");
        }
        for different in [
            ["1", "\"1\""],
            ["null", "false"],
            // One floating-point number is nearest to both.
            ["36893488147419103232", "36893488147419103233"],
            ["[36893488147419103232]", "[36893488147419103233]"],
            ["9007199254740992", "9007199254740993"],
            ["[1,2]", "[2,1]"],
            ["{}", "[]"],
            // Half of a pair of surrogates is no text.
            [r#""\ud800""#, r#""\ud801""#],
        ] {
            let texts = different.map(|value| format!("{{\"k\":{value}}}"));
            assert_eq!(merged_text(&texts), format!("{{\"k\":[{},{}]}}", different[0], different[1]));
        }
        let deep = |value: &str| format!("{{\"k\":{}{value}{}}}", "[".repeat(10_000), "]".repeat(10_000));
        assert!(merged_text(&[deep("1"), deep("2")]).starts_with("{\"k\":[[["));
        assert_eq!(merged_text(&[deep("1"), deep("1")]), deep("1"));
    }

    fn merged_text(texts: &[String; 2]) -> String {
        let mut merged = MergedProperties::default();
        texts.iter().for_each(|properties| merged.add(properties).unwrap());
        merged.to_string()
    }

    #[test]
    fn keys_are_removed_and_others_stay() {
        let mut merged = MergedProperties::default();
        merged.add(r#"{"a":1,"b":2,"c":3}"#).unwrap();
        merged.remove("a");
        merged.remove("z");
        merged.add(r#"{"c":4,"a":5}"#).unwrap();
        assert_eq!(merged.to_string(), r#"{"b":2,"c":[3,4],"a":5}"#);
    }
}
