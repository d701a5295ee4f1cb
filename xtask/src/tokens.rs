//! Rust code as words and signs.

/// Words, `::` and single signs of Rust code, without comments and without what stands in quotes.
pub(crate) fn tokens(text: &str) -> Vec<String> {
    let code: Vec<char> = text.chars().collect();
    let at = |i: usize| code.get(i).copied().unwrap_or('\0');
    let (mut tokens, mut i) = (Vec::new(), 0);
    while i < code.len() {
        match code[i] {
            '/' if at(i + 1) == '/' => i = (i..code.len()).find(|&j| code[j] == '\n').unwrap_or(code.len()),
            '/' if at(i + 1) == '*' => {
                let mut depth = 0;
                while i < code.len() {
                    match (at(i), at(i + 1)) {
                        ('/', '*') => (depth, i) = (depth + 1, i + 2),
                        ('*', '/') => (depth, i) = (depth - 1, i + 2),
                        _ => i += 1,
                    }
                    if depth == 0 {
                        break;
                    }
                }
            }
            'r' | 'b' if raw_string_hashes(&code[i..]).is_some() => {
                let hashes = raw_string_hashes(&code[i..]).unwrap_or(0);
                i = (i..code.len()).find(|&j| code[j] == '"').map_or(code.len(), |j| j + 1);
                while i < code.len() && !(code[i] == '"' && (1..=hashes).all(|k| at(i + k) == '#')) {
                    i += 1;
                }
                i += 1 + hashes;
            }
            '"' => {
                i += 1;
                while i < code.len() && code[i] != '"' {
                    i += if code[i] == '\\' { 2 } else { 1 };
                }
                i += 1;
            }
            // A character in quotes; a lifetime has no closing quote.
            '\'' if at(i + 1) == '\\' => {
                i = (i + 3..code.len()).find(|&j| code[j] == '\'').map_or(code.len(), |j| j + 1);
            }
            '\'' if at(i + 2) == '\'' => i += 3,
            ':' if at(i + 1) == ':' => {
                tokens.push("::".to_owned());
                i += 2;
            }
            c if c.is_alphanumeric() || c == '_' => {
                let end = (i..code.len())
                    .find(|&j| !(code[j].is_alphanumeric() || code[j] == '_'))
                    .unwrap_or(code.len());
                tokens.push(code[i..end].iter().collect());
                i = end;
            }
            c => {
                if !c.is_whitespace() {
                    tokens.push(c.to_string());
                }
                i += 1;
            }
        }
    }
    tokens
}

/// The number of hashes if a raw string starts here.
fn raw_string_hashes(code: &[char]) -> Option<usize> {
    let start = if code.starts_with(&['b', 'r']) {
        2
    } else if code.first() == Some(&'r') {
        1
    } else {
        return None;
    };
    let hashes = code[start..].iter().take_while(|c| **c == '#').count();
    (code.get(start + hashes) == Some(&'"')).then_some(hashes)
}

#[cfg(test)]
mod tests {
    use super::tokens;

    #[test]
    fn words_are_read_from_code_not_from_comments() {
        let text = r##"
            //! [`crate::io::Model`]
            /* use crate::io::Model; /* nested */ use crate::yin::Knot; */
            fn f(s: &'a str) { g("crate::io::x", r#"a "quoted" b"#, "x", '"', '\'', 'c'); }
        "##;
        assert_eq!(tokens(text).concat(), "fnf(s:&'astr){g(,,,,,);}");
        assert_eq!(tokens("a::b: c"), ["a", "::", "b", ":", "c"]);
    }
}
