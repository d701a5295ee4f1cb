//! Properties by their keys.

use super::properties::{Pairs, canonical};
use coface_algebra::Error;

/// The keys of properties with the texts of their values, in their order.
///
/// # Errors
/// [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) if the text is no JSON object.
pub fn property_pairs(properties: &str) -> Result<Vec<(String, &str)>, Error> {
    let pairs: Pairs<'_> = serde_json::from_str(properties).map_err(|error| {
        Error::parse(format!("properties are no JSON object: {error}"))
            .with_cure("give the text of an object, such as {\"height\": 7}")
    })?;
    Ok(pairs.0.into_iter().map(|(key, value)| (key, value.get())).collect())
}

/// A text that is the same for equal values: numbers by value, objects whatever the order of their keys is.
pub fn equal_text(value: &str) -> String {
    canonical(value, 0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pairs_keep_their_order_and_texts() {
        let pairs = property_pairs(r#"{"b":1.50,"a":[1, 2],"b":null}"#).unwrap();
        assert_eq!(pairs, [("b".to_owned(), "1.50"), ("a".to_owned(), "[1, 2]"), ("b".to_owned(), "null")]);
        assert!(property_pairs("[1]").is_err());
        assert_eq!(equal_text("2"), equal_text("2.0"));
        assert_ne!(equal_text("2"), equal_text("\"2\""));
    }
}
