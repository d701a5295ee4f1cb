//! Numbers and texts in SVG.

use std::fmt::Write;

/// Two numbers with at most one decimal.
pub(super) fn push_point(text: &mut String, [x, y]: [f64; 2]) {
    push_short(text, x);
    text.push(' ');
    push_short(text, y);
}

/// A number with one decimal, or none where that is 0.
pub(super) fn push_short(text: &mut String, number: f64) {
    let tenths = (10.0 * number).round();
    let _ = if tenths % 10.0 == 0.0 {
        write!(text, "{:.0}", tenths / 10.0 + 0.0)
    } else {
        write!(text, "{:.1}", tenths / 10.0)
    };
}

/// Text that can stand in XML: what it may not hold is left out.
pub(super) fn escaped(text: &str) -> String {
    let allowed: String = text.chars().filter(|&c| c >= ' ' || matches!(c, '\t' | '\n')).collect();
    allowed.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        let mut text = String::new();
        [3.0, 2.96, 2.94, -0.01, -1.25, 1e6].into_iter().for_each(|number| {
            push_short(&mut text, number);
            text.push(' ');
        });
        assert_eq!(text, "3 3 2.9 0 -1.3 1000000 ");
    }

    #[test]
    fn no_text_breaks_the_file() {
        assert_eq!(escaped("a<b> & \"c\"\u{1}"), "a&lt;b&gt; &amp; &quot;c&quot;");
    }
}
