//! Names that strangers chose, in text for people.

use std::borrow::Cow;
use std::fmt::Write;

/// The text in one line that cannot change what stands around it: control characters and the marks that turn the
/// direction of text are written as `\n`, `\t`, `\r` and `\u{1b}`.
///
/// Names of files and of their objects may have any character. Everything that prints such a name for people prints
/// it by this function; JSON has escapes of its own.
///
/// # Complexity
/// Linear; text without such characters is not copied.
///
/// # Examples
/// ```
/// use coface_algebra::escaped;
/// assert_eq!(escaped("a\nb\u{1b}[31m\u{202e}.off"), "a\\nb\\u{1b}[31m\\u{202e}.off");
/// assert_eq!(escaped("größe 1.off"), "größe 1.off");
/// ```
pub fn escaped(text: &str) -> Cow<'_, str> {
    if !text.contains(is_escaped) {
        return Cow::Borrowed(text);
    }
    let mut whole = String::with_capacity(text.len() + 16);
    for character in text.chars() {
        match character {
            '\n' => whole.push_str("\\n"),
            '\r' => whole.push_str("\\r"),
            '\t' => whole.push_str("\\t"),
            _ if is_escaped(character) => {
                // Writing to a string does not fail.
                let _ = write!(whole, "\\u{{{:x}}}", u32::from(character));
            }
            _ => whole.push(character),
        }
    }
    Cow::Owned(whole)
}

/// C0, DEL and C1, the ends of lines and paragraphs, and the marks, embeddings, overrides and isolates of the
/// bidirectional algorithm.
fn is_escaped(character: char) -> bool {
    character.is_control()
        || matches!(character, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

#[cfg(test)]
mod tests {
    use super::escaped;
    use std::borrow::Cow;

    #[test]
    fn every_control_character_is_escaped_and_nothing_else() {
        let controls = (0..0x20)
            .chain(0x7f..0xa0)
            .chain([0x61c, 0x200e, 0x200f])
            .chain(0x2028..0x202f)
            .chain(0x2066..0x206a);
        for code in controls {
            let character = char::from_u32(code).unwrap();
            let text = escaped(&format!("a{character}b")).into_owned();
            assert!(text.starts_with("a\\") && text.ends_with('b'), "{code:x}: {text:?}");
            assert!(text.chars().all(|c| (' '..='~').contains(&c)), "{code:x}: {text:?}");
        }
        for plain in ["", "a b", "\\n", "\u{a0}", "é", "ab\u{301}", "日本", "עברית", "🙂", "C:\\new"]
        {
            assert!(matches!(escaped(plain), Cow::Borrowed(same) if same == plain), "{plain:?}");
        }
    }
}
