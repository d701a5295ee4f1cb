//! Values separated by commas.

use super::Cell;
use coface_algebra::escaped;

/// A text as a field of a table of comma-separated values: in quotes where it must be, with an apostrophe before what a spreadsheet would take
/// for a formula, control characters escaped.
///
/// # Examples
/// ```
/// use coface_scale::csv_field;
/// assert_eq!(["a b", "a,b", "=1+1"].map(csv_field), ["a b", "\"a,b\"", "'=1+1"]);
/// ```
pub fn csv_field(text: &str) -> String {
    field(&text.into())
}

/// A value as a field: empty for null, in one line, in quotes where it must be. What a spreadsheet would take for a
/// formula has an apostrophe before it, which says that it is text.
pub(super) fn field(value: &Cell) -> String {
    let text = match value {
        Cell::Nothing => return String::new(),
        Cell::Text(text) => {
            let text = escaped(text);
            if is_formula(&text) { format!("'{text}") } else { text.into_owned() }
        }
        number => serde_json::to_string(number).expect("numbers are JSON"),
    };
    if text.contains([',', '"', '\n', '\r']) || text.is_empty() || text.trim() != text {
        return format!("\"{}\"", text.replace('"', "\"\""));
    }
    text
}

/// Whether a spreadsheet may take a text for a formula: one that begins as a formula does and is no number.
fn is_formula(text: &str) -> bool {
    let is_number = || {
        text.bytes().all(|byte| byte.is_ascii_digit() || b"+-.eE".contains(&byte))
            && text.parse::<f64>().is_ok()
    };
    text.starts_with(['=', '+', '-', '@', '\t', '\r']) && !is_number()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fields_are_quoted_where_they_must_be() {
        let text = |text: &str| Cell::from(text);
        let fields =
            [Cell::Nothing, true.into(), 0.1.into(), text("a b"), text("a,\"b\""), text("\n"), text("")];
        let expected = ["", "true", "0.1", "a b", "\"a,\"\"b\"\"\"", "\\n", "\"\""];
        assert_eq!(fields.map(|value| field(&value)), expected);
    }

    #[test]
    fn formulas_are_text_and_numbers_are_numbers() {
        for text in ["=1+1", "+cmd|' /C calc'!A0", "-2+3", "@SUM(A1)", "-", "+1-1", "-inf", "-1e5 "] {
            let cell = field(&text.into());
            assert!(cell.trim_start_matches('"').starts_with(&format!("'{}", &text[..1])), "{text}: {cell}");
        }
        assert_eq!([field(&"\t=1".into()), field(&"\r\n=1".into())], ["\\t=1", "\\r\\n=1"]);
        assert_eq!(field(&"=a,b".into()), "\"'=a,b\"");
        for text in ["-1.5", "+2", "-1e-5", "a=b", "1-1", "."] {
            assert_eq!(field(&text.into()), text);
        }
        assert_eq!([field(&(-1.5).into()), field(&Cell::Whole(-3))], ["-1.5", "-3"]);
    }
}
