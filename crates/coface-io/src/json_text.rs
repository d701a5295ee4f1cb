//! The text of JSON, as it is kept.

/// A text of JSON without the white space between its parts.
pub(crate) fn compact(text: &str) -> String {
    let (mut kept, mut is_in_text, mut is_escaped) = (String::with_capacity(text.len()), false, false);
    kept.extend(text.chars().filter(|&c| {
        let is_kept = is_in_text || !matches!(c, ' ' | '\t' | '\n' | '\r');
        if c == '"' && !is_escaped {
            is_in_text = !is_in_text;
        }
        is_escaped = is_in_text && c == '\\' && !is_escaped;
        is_kept
    }));
    kept
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::{Value, json};

    #[test]
    fn white_space_goes_and_texts_stay() {
        let text = "{ \"a b\" : \"x \\\" y\\\\\" ,\n\t\"c\": [ 1.10 , -0.0 ],\r\n \"d\\\\\" : { } }";
        assert_eq!(compact(text), r#"{"a b":"x \" y\\","c":[1.10,-0.0],"d\\":{}}"#);
        let values =
            [compact(text), text.to_owned()].map(|text| serde_json::from_str::<Value>(&text).unwrap());
        assert_eq!(values[0], values[1]);
        assert_eq!(values[0]["a b"], json!("x \" y\\"));
    }
}
