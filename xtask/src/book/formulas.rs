//! Formulas as text that can be read without KaTeX: letters of the field, indices and exponents.

/// Commands of TeX that stand for one sign.
const SIGNS: &[(&str, &str)] = &[
    ("partial", "∂"),
    ("pi", "π"),
    ("chi", "χ"),
    ("sigma", "σ"),
    ("tau", "τ"),
    ("gamma", "γ"),
    ("Gamma", "Γ"),
    ("omega", "ω"),
    ("delta", "δ"),
    ("Delta", "Δ"),
    ("Sigma", "Σ"),
    ("rho", "ρ"),
    ("eta", "η"),
    ("mu", "μ"),
    ("lambda", "λ"),
    ("phi", "φ"),
    ("alpha", "α"),
    ("beta", "β"),
    ("varepsilon", "ε"),
    ("infty", "∞"),
    ("in", "∈"),
    ("notin", "∉"),
    ("subset", "⊂"),
    ("subseteq", "⊆"),
    ("supset", "⊃"),
    ("setminus", "∖"),
    ("cup", "∪"),
    ("cap", "∩"),
    ("times", "×"),
    ("cdot", "·"),
    ("circ", "∘"),
    ("to", "→"),
    ("mapsto", "↦"),
    ("leq", "≤"),
    ("le", "≤"),
    ("geq", "≥"),
    ("ge", "≥"),
    ("neq", "≠"),
    ("ne", "≠"),
    ("oplus", "⊕"),
    ("otimes", "⊗"),
    ("langle", "⟨"),
    ("rangle", "⟩"),
    ("mid", "|"),
    ("sum", "∑"),
    ("prod", "∏"),
    ("int", "∫"),
    ("cong", "≅"),
    ("simeq", "≃"),
    ("sim", "∼"),
    ("dots", "…"),
    ("ldots", "…"),
    ("cdots", "⋯"),
    ("emptyset", "∅"),
    ("top", "⊤"),
    ("perp", "⊥"),
    ("quad", " "),
    ("ker", "ker "),
    ("dim", "dim "),
    ("det", "det "),
    ("pm", "±"),
    ("lbrace", "{"),
    ("rbrace", "}"),
    ("ell", "ℓ"),
    ("star", "⋆"),
    ("wedge", "∧"),
    ("vee", "∨"),
    ("approx", "≈"),
    ("equiv", "≡"),
    ("sqrt", "√"),
];

/// The formula as HTML without KaTeX.
pub(super) fn readable(tex: &str) -> String {
    let letters: Vec<char> = tex.chars().collect();
    let mut at = 0;
    group(&letters, &mut at, false)
}

/// Reads until the end, or until the brace that closes the group.
fn group(letters: &[char], at: &mut usize, is_inner: bool) -> String {
    let mut text = String::new();
    while let Some(&c) = letters.get(*at) {
        *at += 1;
        match c {
            '}' if is_inner => break,
            '{' => text.push_str(&group(letters, at, true)),
            '_' | '^' => {
                let tag = if c == '_' { "sub" } else { "sup" };
                let inner = argument(letters, at);
                text.push_str(&format!("<{tag}>{inner}</{tag}>"));
            }
            '\\' => text.push_str(&command(letters, at)),
            '<' => text.push_str("&lt;"),
            '>' => text.push_str("&gt;"),
            '&' => text.push(' '),
            '~' => text.push(' '),
            c => text.push(c),
        }
    }
    text
}

/// One letter, one command or one group.
fn argument(letters: &[char], at: &mut usize) -> String {
    let Some(&c) = letters.get(*at) else { return String::new() };
    *at += 1;
    match c {
        '{' => group(letters, at, true),
        '\\' => command(letters, at),
        c => c.to_string(),
    }
}

fn command(letters: &[char], at: &mut usize) -> String {
    let begin = *at;
    while letters.get(*at).is_some_and(char::is_ascii_alphabetic) {
        *at += 1;
    }
    let name: String = letters[begin..*at].iter().collect();
    if name.is_empty() {
        let sign = letters.get(*at).copied().unwrap_or(' ');
        *at += 1;
        return if matches!(sign, ',' | ';' | '!' | '\\') { " ".to_owned() } else { sign.to_string() };
    }
    match name.as_str() {
        "mathbb" => match argument(letters, at).as_str() {
            "Z" => "ℤ".to_owned(),
            "Q" => "ℚ".to_owned(),
            "R" => "ℝ".to_owned(),
            "C" => "ℂ".to_owned(),
            "F" => "𝔽".to_owned(),
            other => other.to_owned(),
        },
        "operatorname" | "mathrm" | "text" | "mathcal" | "mathbf" => argument(letters, at),
        "bar" | "tilde" | "hat" => {
            let mark = if name == "bar" {
                '\u{304}'
            } else if name == "hat" {
                '\u{302}'
            } else {
                '\u{303}'
            };
            argument(letters, at) + &mark.to_string()
        }
        "frac" => {
            let above = argument(letters, at);
            format!("{above}/{}", argument(letters, at))
        }
        _ => SIGNS.iter().find(|(word, _)| *word == name).map_or(name, |(_, sign)| (*sign).to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::readable;

    #[test]
    fn formulas_are_read_without_katex() {
        assert_eq!(
            readable(r"H_1(\Sigma, \mathbb{Z}) = \mathbb{Z}^{2g}"),
            "H<sub>1</sub>(Σ, ℤ) = ℤ<sup>2g</sup>"
        );
        assert_eq!(readable(r"\operatorname{Lk}(s)"), "Lk(s)");
        assert_eq!(readable(r"\tilde{\Sigma}"), "Σ\u{303}");
    }
}
